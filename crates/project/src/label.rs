//! The keys of a project file in words.

use crate::key::Key;
use crate::root::KEYS;
use crate::schema::SchemaText;

/// What a key of the project file is for: `load.inertia`, `motion[2].speed`, `mechanism.turntable.bodies[1].mass`; `None`
/// where the project file has no such key.
#[must_use]
pub fn input_label(path: &str) -> Option<SchemaText> {
    let mut keys = KEYS;
    let mut found: Option<&'static Key> = None;
    for part in path.split('.') {
        let name = part.split('[').next().unwrap_or(part);
        let key = keys.iter().find(|key| key.name == name)?;
        keys = key.kind.keys(true);
        found = Some(key);
    }
    found.copied().map(SchemaText::Key)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_that_can_be_written_has_words() {
        for path in ["load.inertia", "motion[2].speed", "mechanism.screw.lead", "axis[2].requirements.supply"] {
            assert!(input_label(path).is_some(), "{path}");
        }
        assert!(input_label("load.weight_of_the_moon").is_none());
    }
}
