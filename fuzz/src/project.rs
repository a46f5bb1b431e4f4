//! Project files: any text gives a project, or faults with their place and text.

use crate::draft;
use crate::text::{any_edits, mutate, one_in, rest, tells};
use arbitrary::{Result, Unstructured};
use axis::AxisDiagnostic;
use axis::AxisProject;
use project::{inputs, place};
use quantities::{Language, is_unseen, seen};
use questions::{answer, project_fingerprint};
use std::ops::Range;
use words::{Worded, worded};

/// Tests a mostly valid project, in some cases with edits, or any text.
pub fn run(data: &[u8]) {
    hold(&shown(data));
}

/// Returns the text of a case.
pub fn shown(data: &[u8]) -> String {
    text(&mut Unstructured::new(data)).unwrap_or_default()
}

fn text(u: &mut Unstructured<'_>) -> Result<String> {
    match u.int_in_range(0..=9)? {
        0 => Ok(rest(u)),
        1..=4 => {
            let edits = any_edits(u, 5)?;
            let text = draft::project(u, false)?;
            Ok(mutate(&text, &edits))
        }
        _ => draft::project(u, false),
    }
}

/// Tests the faults of a text in both languages, and returns the projects if there are none.
pub fn hold(text: &str) -> Option<Vec<AxisProject>> {
    read(text, || questions::read_all(text, &axis::NoFiles))
}

/// Tests the faults of a text that is read by another function, and returns the projects if there are none.
pub fn read(
    text: &str,
    with: impl FnOnce() -> std::result::Result<Vec<AxisProject>, Vec<axis::AxisDiagnostic>>,
) -> Option<Vec<AxisProject>> {
    let faults = match with() {
        Ok(projects) => {
            assert!(!projects.is_empty());
            // Inputs and fingerprint are tested in a share of the cases only.
            if one_in(4, text) {
                for input in inputs(text) {
                    assert!(text.get(input.span.clone()).is_some(), "{text:?}: {input:?}");
                }
                for project in &projects {
                    let _ = project_fingerprint(text, &project.recordings);
                }
            }
            return Some(projects);
        }
        Err(faults) => faults,
    };
    assert!(!faults.is_empty());
    assert!(faults.is_sorted_by_key(|fault| fault.span.start), "{text:?}");
    for fault in &faults {
        assert!(text.get(fault.span.clone()).is_some(), "{text:?}: {fault:?}");
        assert_eq!((fault.line, fault.column), place(text, fault.span.start), "{fault:?}");
    }
    let first = if one_in(2, text) { Language::En } else { Language::De };
    wording(text, &faults, first);
    if one_in(5, text) {
        let [english, german] = [Language::En, Language::De].map(|language| wording(text, &faults, language));
        assert_eq!(english, german, "{text:?}: the languages disagree about the faults");
    }
    None
}

/// Tests the texts of faults, also as shown within the project text, and returns their ids and places.
fn wording(text: &str, faults: &[AxisDiagnostic], language: Language) -> Vec<(&'static str, Range<usize>)> {
    let worded = worded(faults, language);
    for fault in &worded {
        tells(&fault.message);
        fault.hint.iter().for_each(|hint| tells(hint));
    }
    let _ = answer::faults("project.toml", &worded);
    excerpts(text, &worded);
    worded.into_iter().map(|fault| (fault.id, fault.span)).collect()
}

/// Checks that a fault shown within its text contains no terminal control except colours.
fn excerpts(text: &str, faults: &[Worded]) {
    // Testing all would cost as much as the rest of the case; first and last represent them.
    let ends = faults.iter().take(1).chain(faults.last());
    for fault in ends {
        let (message, hint) = (seen(&fault.message), fault.hint.as_deref().map(seen));
        let of_text = excerpt::Fault {
            span: fault.span.clone(),
            line: fault.line,
            column: fault.column,
            message: &message,
            hint: hint.as_deref(),
        };
        let style = excerpt::Style { file: "project.toml", error: "error", help: "help", width: 60 + text.len() % 60 };
        let shown = excerpt::show(text, &of_text, &style);
        let place = format!("project.toml:{}:", fault.line);
        assert!(shown.contains(&place), "{text:?}: {shown:?} does not name {place}");
        let acts = |part: &str| part.chars().any(|sign| is_unseen(sign) && !matches!(sign, '\n' | '\r' | '\t'));
        assert!(!plain(&shown).any(acts), "{text:?}: {shown:?}");
    }
}

/// Iterates over the parts of a shown text between the colours.
fn plain(shown: &str) -> impl Iterator<Item = &str> {
    let is_colour = |code: &str| code.chars().all(|sign| sign.is_ascii_digit() || sign == ';');
    shown.split("\u{1b}[").enumerate().map(move |(index, part)| match part.split_once('m') {
        Some((code, rest)) if index > 0 && is_colour(code) => rest,
        _ => part,
    })
}
