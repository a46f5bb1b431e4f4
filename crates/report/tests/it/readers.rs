//! A report with all appendices and chapters as those read it who never see the project file, in both languages.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test that cannot panic cannot fail")]

use crate::samples;

use answers::Picture;
use figures::{PinTexts, Style, Theme};
use quantities::Language;
use questions::list::commission::{DriveForm, usual_ambient};
use questions::list::mount::MountInputs;
use questions::list::upkeep::{UpkeepInputs, read_date};
use questions::{answer, chapter};
use report::Content;
use samples::read::is_readable;
use samples::{full, made};

/// Wiring, mounting and commissioning as they follow a report, with their pictures.
fn with_chapters(content: &mut Content) {
    let language = content.language;
    for axis in &mut content.axes {
        let code = axis.dossier.judgement.candidate.code.clone().unwrap();
        let read = questions::read_code(&code, language).unwrap();
        let code = read.parsed.code;
        if let Some(found) = questions::list::wiring::wiring(&code) {
            let faces = found.connectors.iter().filter(|connector| !connector.pins.is_empty()).map(|connector| {
                let drawing = figures::mating_face(&code, connector, PinTexts::Signals, language);
                let style = Style::new(drawing.size()).theme(Theme::Light).language(language).id(connector.role.id());
                Picture {
                    svg: drawing.render(&style).into_svg(),
                    caption: drawing.title.clone(),
                    alternative_text: drawing.description.clone(),
                }
            });
            axis.chapters.push(chapter::wiring(&answer::wiring(&found, None, language), faces.collect(), language));
        }
        let asked = MountInputs::default();
        if let Some(found) = questions::list::mount::mount(&code, &asked) {
            axis.chapters.push(chapter::mount(&answer::mount(&found, &asked, None, language), language));
        }
        if let Some(about) = questions::list::commission::commission(&code) {
            let sheet = answer::commissioning(&about, DriveForm::Plain, usual_ambient(), language);
            axis.chapters.push(chapter::commission(&sheet, &[], language));
        }
        let delivered = read_date("2026-03-01", language).unwrap();
        let asked = UpkeepInputs { delivered, storage: None, hours_per_day: None, inspect: None, today: None };
        let plan = questions::list::upkeep::upkeep(&code, &asked, language).unwrap();
        axis.chapters.push(chapter::upkeep(&answer::upkeep(&plan, language), language));
        axis.dossier.documents.extend(chapter::documents(&axis.chapters, language));
    }
}

fn in_language(language: Language) {
    let text = include_str!("../../../../examples/tilting-arm.toml");
    let mut content = made(text, None, language, true);
    with_chapters(&mut content);
    is_readable("tilting arm", &content, &full());
}

#[test]
fn an_english_report_has_letters_to_read_and_no_identifier() {
    in_language(Language::En);
}

#[test]
fn a_german_report_has_letters_to_read_no_identifier_and_no_english() {
    in_language(Language::De);
}
