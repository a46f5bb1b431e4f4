//! The keys of a project file in words.

use crate::schema::SchemaText;
use crate::spec::{Key, Kind, ROOT};

/// What a key of the project file is for: `load.inertia`, `motion[2].speed`, `mechanism.turntable.bodies[1].mass`; `None`
/// where the project file has no such key.
#[must_use]
pub fn input_label(path: &str) -> Option<SchemaText> {
    let mut keys = ROOT;
    let mut found: Option<&'static Key> = None;
    for part in path.split('.') {
        let name = part.split('[').next().unwrap_or(part);
        let key = keys.iter().find(|key| key.name == name)?;
        keys = match key.kind {
            Kind::Table(keys) => keys,
            Kind::OneOrMany(_, keys) => keys,
            Kind::Variants(variants) => variants.keys,
            _ => &[],
        };
        found = Some(key);
    }
    found.map(|key| SchemaText::Key(key.about))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_that_can_be_written_has_words() {
        for path in ["load.inertia", "motion[2].speed", "mechanism.screw.lead", "axis[2].requirements.supply"] {
            assert!(input_label(path).is_some(), "{path}");
        }
        assert_eq!(input_label("load.weight_of_the_moon"), None);
    }
}
