//! The check-lists as PDF: every line is there, in both languages, and the same call gives the same bytes.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot panic cannot fail")]

use answers::Commissioning;
use quantities::Language;
use workbench::{DriveForm, answer, commission, read_code, usual_ambient};

fn sheet(code: &str, language: Language) -> Commissioning {
    let Ok(reading) = read_code(code, language) else { panic!("{code}") };
    let about = commission(&reading.parsed.code).unwrap();
    answer::commissioning(&about, DriveForm::Plain, usual_ambient(), language)
}

/// Letters and digits only: line breaks are a matter of setting.
fn letters(text: &str) -> String {
    text.chars().filter(|sign| sign.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

#[test]
fn every_line_of_every_list_is_on_the_pages_in_both_languages() {
    for language in Language::ALL {
        for code in ["CHA-25A-100-H-M512P-B", "CHA-14A-50-E-M128S"] {
            let sheet = sheet(code, language);
            let pages = report::checklist_texts(&sheet, language).unwrap();
            assert!((2..=6).contains(&pages.len()), "{code}: {} pages", pages.len());
            let all = letters(&pages.concat());
            let mut lines = 0;
            for list in &sheet.lists {
                assert!(all.contains(&letters(&list.title)), "{}", list.title);
                for entry in &list.entries {
                    lines += 1;
                    assert!(all.contains(&letters(&entry.text)), "{code}: {}", entry.text);
                    assert!(all.contains(&letters(&entry.shown)), "{code}: {}", entry.shown);
                }
            }
            assert!(lines > 25, "{lines}");
            let signal = match language {
                Language::En => "DANGER",
                Language::De => "GEFAHR",
            };
            assert!(pages.concat().contains(signal));
        }
    }
}

#[test]
fn the_same_call_gives_the_same_bytes() {
    let sheet = sheet("CHA-25A-100-H-M512P-B", Language::En);
    let one = report::checklist_pdf(&sheet, Language::En).unwrap();
    assert!(one.starts_with(b"%PDF-") && one == report::checklist_pdf(&sheet, Language::En).unwrap());
}
