//! Quantities: whatever the text, no panic, a finite value or a fault inside the text.

use fuzz::{any_edits, any_text, explore, mutate};
use quantities::{Dimension, Language, parse, unit};

fn hold(text: &str) {
    for unit in unit::ALL {
        match parse(unit.dimension, text) {
            Ok(reading) => assert!(reading.si.is_finite(), "{text:?} as {:?}", unit.dimension),
            Err(error) => {
                assert!(text.get(error.span()).is_some(), "{text:?}: {error:?}");
                for language in [Language::En, Language::De] {
                    assert!(!workbench::text::quantity_fault(&error, language).is_empty());
                    let _ = workbench::text::quantity_hint(&error, language);
                }
            }
        }
    }
}

#[test]
fn quantities_from_any_text() {
    explore(2, |u| {
        hold(&any_text(u, 60)?);
        Ok(())
    });
}

#[test]
fn quantities_with_a_few_edits() {
    let examples: Vec<&str> = unit::ALL.iter().map(|unit| unit.dimension.example()).collect();
    explore(2, |u| {
        let example = u.choose(&examples)?;
        hold(&mutate(example, &any_edits(u, 4)?));
        Ok(())
    });
}

#[test]
fn inputs_that_once_were_hard() {
    for text in include_str!("../corpus/quantities.txt").lines() {
        hold(text);
    }
    assert!(parse(Dimension::Torque, "5 N m").is_ok());
}
