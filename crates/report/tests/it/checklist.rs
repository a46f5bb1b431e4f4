//! The check-lists as PDF: every line is there, in both languages, and the same call gives the same bytes.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test that cannot panic cannot fail")]

use answers::Commissioning;
use hayro_syntax::object::{Array, Dict, Rect};
use hayro_syntax::{Pdf, object};
use quantities::Language;
use questions::list::commission::{DriveForm, commission, usual_ambient};
use questions::{answer, read_code};
use std::collections::BTreeMap;

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

/// A field as a reader finds it.
#[derive(Debug, Default)]
struct Found {
    kind: String,
    tooltip: String,
    places: usize,
}

/// Text of a PDF: UTF-16 with its mark, else as it stands.
fn text(bytes: &[u8]) -> String {
    match bytes.strip_prefix(&[0xFE, 0xFF]) {
        Some(wide) => {
            let units: Vec<u16> = wide.chunks_exact(2).map(|pair| u16::from_be_bytes([pair[0], pair[1]])).collect();
            String::from_utf16(&units).unwrap()
        }
        None => String::from_utf8(bytes.to_vec()).unwrap(),
    }
}

/// The fields of a file by name, read as a reader does: catalogue, form, fields, then the annotations of the pages.
fn fields(file: Vec<u8>) -> BTreeMap<String, Found> {
    let pdf = Pdf::new(file).unwrap();
    let root: Dict<'_> = pdf.xref().get(pdf.xref().root_id()).unwrap();
    let form: Dict<'_> = root.get("AcroForm").unwrap();
    assert!(form.get::<Dict<'_>>("DR").unwrap().get::<Dict<'_>>("Font").unwrap().contains_key("Helv"));
    let string = |dict: &Dict<'_>, key: &str| text(dict.get::<object::String<'_>>(key).unwrap().as_bytes());
    let mut by_id = BTreeMap::new();
    let mut found = BTreeMap::new();
    for id in form.get::<Array<'_>>("Fields").unwrap().raw_iter() {
        let id = id.as_obj_ref().unwrap();
        let field: Dict<'_> = pdf.xref().get(id.into()).unwrap();
        let name = string(&field, "T");
        let kind = field.get::<object::Name<'_>>("FT").unwrap().as_str().to_owned();
        let kids = field.get::<Array<'_>>("Kids");
        let widgets = kids.map_or(vec![id], |kids| kids.raw_iter().map(|kid| kid.as_obj_ref().unwrap()).collect());
        by_id.extend(widgets.iter().map(|widget| (widget.obj_number, name.clone())));
        let field = Found { kind, tooltip: string(&field, "TU"), places: 0 };
        assert!(found.insert(name.clone(), field).is_none(), "{name} twice");
    }
    for page in pdf.pages().iter() {
        let Some(annotations) = page.raw().get::<Array<'_>>("Annots") else { continue };
        for id in annotations.raw_iter() {
            let id = id.as_obj_ref().unwrap();
            let widget: Dict<'_> = pdf.xref().get(id.into()).unwrap();
            assert_eq!(widget.get::<object::Name<'_>>("Subtype").unwrap().as_str(), "Widget", "a mark that was left");
            let place: Rect = widget.get("Rect").unwrap();
            assert!(place.width() > 8.0 && place.height() > 8.0, "{place:?}");
            found.get_mut(&by_id[&id.obj_number]).unwrap().places += 1;
        }
    }
    found
}

#[test]
fn every_line_has_its_tick_and_every_measured_value_its_field() {
    for language in Language::ALL {
        for code in ["CHA-25A-100-H-M512P-B", "CHA-14A-50-E-M128S"] {
            let sheet = sheet(code, language);
            let pages = report::checklist_texts(&sheet, language).unwrap().len();
            let mut found = fields(report::checklist_pdf(&sheet, language).unwrap());
            let serial = found.remove("serial_number").unwrap();
            assert_eq!((serial.kind.as_str(), serial.places), ("Tx", pages), "on every page, typed once");
            assert_eq!(found.remove("signature").unwrap().places, 1);
            for list in &sheet.lists {
                for (index, entry) in list.entries.iter().enumerate() {
                    let name = format!("{}-{}-{}", list.step.id(), index + 1, entry.id);
                    let mut field = |what: &str, kind: &str| {
                        let found = found.remove(&format!("{name}-{what}")).unwrap();
                        assert_eq!((found.kind.as_str(), found.places), (kind, 1), "{name}");
                        assert!(found.tooltip.ends_with(&entry.text), "{}", found.tooltip);
                    };
                    field("done", "Btn");
                    if entry.field {
                        field("measured", "Tx");
                    }
                }
            }
            assert!(found.is_empty(), "{found:?}");
        }
    }
}
