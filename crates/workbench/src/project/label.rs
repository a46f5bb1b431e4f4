//! The keys of a project file in words.

use super::spec::{Key, Kind, ROOT};
use quantities::Language;

/// What a key says, in words: `load.inertia`, `motion[2].speed`, `mechanism.table.bodies[1]`; `None` where the project file
/// has no such key.
#[must_use]
pub fn input_label(path: &str, language: Language) -> Option<&'static str> {
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
    found.map(|key| match language {
        Language::En => key.en,
        Language::De => key.de,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_of_the_examples_has_words() {
        assert!(input_label("load.inertia", Language::De).is_some());
        assert!(input_label("motion[2].speed", Language::En).is_some());
        assert!(input_label("mechanism.screw.lead", Language::De).is_some());
        assert_eq!(input_label("load.weight_of_the_moon", Language::En), None);
    }
}
