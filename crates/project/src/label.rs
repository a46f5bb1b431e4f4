//! Texts for the keys of a project file.

use crate::edit::key_along;
use crate::root::KEYS;
use crate::schema::SchemaText;

/// Returns the identifier of the text about a key of the project file: `load.inertia`, `motion[2].speed`,
/// `mechanism.turntable.bodies[1].mass`; `None` if the project file has no such key.
#[must_use]
pub fn input_label(path: &str) -> Option<SchemaText> {
    let names = path.split('.').map(|part| (part.split('[').next().unwrap_or(part), true));
    key_along(KEYS, names).copied().map(SchemaText::Key)
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
