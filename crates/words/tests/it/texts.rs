//! Texts by name: whole, in both languages, with the same put in, in the words of the glossary and the signs of the language.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use crate::marks::has_foreign_quotes;
use quantities::Language;
use words::{MODULES, Text};

fn texts() -> impl Iterator<Item = (String, &'static Text)> {
    MODULES.iter().flat_map(|(module, texts)| texts.iter().map(move |text| (format!("{module}::{}", text.name), text)))
}

/// Forms of a text with their languages; one form is that of both.
fn forms(text: &'static Text) -> Vec<(Language, &'static str)> {
    match text.forms {
        [same] => Language::ALL.map(|language| (language, *same)).to_vec(),
        forms => {
            forms.iter().zip(Language::ALL.into_iter().cycle()).map(|(form, language)| (language, *form)).collect()
        }
    }
}

/// Names of the inserted values, without repetitions.
fn put_in(form: &str) -> Vec<&str> {
    let mut names: Vec<&str> = form.split('{').skip(1).filter_map(|rest| rest.split('}').next()).collect();
    names.sort_unstable();
    names.dedup();
    names
}

#[test]
fn every_module_of_texts_is_looked_at() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/src");
    let mut found = 0;
    for place in [folder.to_owned(), format!("{folder}/help")] {
        for entry in std::fs::read_dir(place).unwrap() {
            let path = entry.unwrap().path();
            let source = if path.is_file() { std::fs::read_to_string(&path).unwrap() } else { String::new() };
            if !source.contains("\ntexts! {\n") {
                continue;
            }
            let name = path.file_stem().unwrap().to_string_lossy().into_owned();
            let known = MODULES.iter().any(|(module, _)| module.rsplit("::").next() == Some(name.as_str()));
            assert!(known, "{name} is not in MODULES");
            found += 1;
        }
    }
    assert_eq!(found, MODULES.len());
}

#[test]
fn a_text_is_whole_and_says_something_in_each_language() {
    let mut count = 0;
    for (name, text) in texts() {
        count += 1;
        for (_, form) in forms(text) {
            assert!(!form.is_empty() && form.trim() == form, "{name}: {form:?}");
        }
        match text.forms {
            [_] => {}
            [en, de] => assert_ne!(en, de, "{name}: what is the same in both languages is written once"),
            [one_en, one_de, en, de] => {
                assert!(one_en != one_de && en != de && one_en != en && one_de != de, "{name}");
            }
            other => panic!("{name}: {} forms", other.len()),
        }
    }
    assert!(count > 500, "{count}");
}

#[test]
fn both_languages_tell_the_same_figures() {
    for (name, text) in texts() {
        match text.forms {
            [en, de] => assert_eq!(put_in(en), put_in(de), "{name}"),
            [one_en, one_de, en, de] => {
                assert_eq!((put_in(one_en), put_in(en)), (put_in(one_de), put_in(de)), "{name}");
            }
            _ => {}
        }
    }
}

#[test]
fn one_word_for_one_thing() {
    for (name, text) in texts() {
        for (language, form) in forms(text) {
            let small = form.to_lowercase();
            for word in catalogue::words() {
                let twins = if language == Language::De { word.not_de } else { word.not_en };
                for twin in twins {
                    let begins = |(at, _): (usize, &str)| {
                        let before = small.get(..at).unwrap_or_default();
                        !before.ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == '-')
                    };
                    let found = small.match_indices(&twin.to_lowercase()).any(begins);
                    assert!(!found, "{name}: {twin}: {form}");
                }
            }
        }
    }
}

/// A word of the glossary that stands by name is the one of the glossary.
#[test]
fn terms_are_those_of_the_glossary() {
    let mut count = 0;
    for word in catalogue::words() {
        for text in words::terms::TEXTS.iter().filter(|text| text.name == word.id) {
            assert_eq!(text.forms, [word.en, word.de], "{}", word.id);
            count += 1;
        }
    }
    assert!(count > 10, "{count}");
}

#[test]
fn every_language_has_its_own_signs() {
    for (name, text) in texts() {
        for (language, form) in forms(text) {
            // A file called `-` is standard input or output.
            let dash = if name.starts_with("help::") { " -- " } else { " - " };
            for wrong in ["...", dash, "m^2", "1/min", "deg ", "+-", "\u{2014}"] {
                assert!(!form.contains(wrong), "{name}: {wrong:?}: {form}");
            }
            if language == Language::En {
                assert!(!form.contains(['„', 'ä', 'ö', 'ü', 'ß']), "{name}: {form}");
                assert_eq!(form.matches('“').count(), form.matches('”').count(), "{name}: {form}");
                continue;
            }
            // What is typed as it stands has the quotation marks of the program that reads it.
            let marks = form.matches('"').count();
            assert!(marks == 0 || name.starts_with("help::"), "{name}: {form}");
            assert_eq!(form.matches('„').count(), form.matches('“').count(), "{name}: {form}");
            assert!(!form.contains('’') && !form.contains("„ "), "{name}: {form}");
        }
    }
}

/// A number in German has a comma; a point stands in the number of an equation, a table or a version alone.
#[test]
fn a_german_number_has_a_comma() {
    for (name, text) in texts() {
        for (_, form) in forms(text).into_iter().filter(|(language, _)| *language == Language::De) {
            let signs: Vec<char> = form.chars().collect();
            for (at, window) in signs.windows(3).enumerate() {
                if let [left, '.', right] = window
                    && left.is_ascii_digit()
                    && right.is_ascii_digit()
                {
                    let before: String = signs.iter().take(at).collect();
                    let numbered =
                        ["Gl. ", "Gleichungen ", " bis ", " und ", "Tabelle ", "EnDat-", "EnDat ", "Befehlssatz "];
                    let number = before.trim_end_matches(|c: char| c.is_ascii_digit());
                    assert!(numbered.iter().any(|head| number.ends_with(head)), "{name}: {form}");
                }
            }
        }
    }
}

/// Texts in German have German quotation marks, except around values of a file and of a call.
#[test]
fn german_texts_have_german_quotation_marks() {
    // The help states values as they are typed.
    let texts = texts().filter(|(name, _)| !name.starts_with("help::"));
    let german = texts.flat_map(|(name, text)| forms(text).into_iter().map(move |form| (name.clone(), form)));
    let wrong: Vec<(String, &str)> = german
        .filter(|(_, (language, form))| *language == Language::De && has_foreign_quotes(form))
        .map(|(name, (_, form))| (name, form))
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
    for (text, is_wrong) in [("\"{name}\" ist", true), ("speed = \"1 m/s\" oder \"2\"", false), ("etwa \"3 s\"", false)]
    {
        assert_eq!(has_foreign_quotes(text), is_wrong, "{text}");
    }
}

/// A datum of the place of installation lacks a statement about the actuator: the project has stated its own value.
#[test]
fn a_missing_range_of_the_place_is_one_of_the_actuator() {
    for symbol in
        ["ambient_temperature_operation", "altitude", "mounting_position", "protection_class", "relative_humidity"]
    {
        for (language, of_actuator) in [(Language::En, "for the actuator"), (Language::De, "für den Antrieb")] {
            let text = words::check_missing(symbol, language);
            assert!(text.contains(of_actuator) && !(symbol.contains('_') && text.contains(symbol)), "{text}");
        }
    }
    // The keys by which the range is stated.
    assert!(words::check_missing("ambient_temperature_operation", Language::En).contains("ambient_min, ambient_max"));
}
