//! Project files: whatever the text, a project or faults that have their place and their words.

use crate::draft;
use crate::text::{any_edits, mutate, rest, tells};
use arbitrary::{Result, Unstructured};
use workbench::text::told;
use workbench::{Language, Project, answer, inputs, place, project_fingerprint};

/// A project that is mostly valid, with edits in a share of the cases; or any text.
pub fn run(data: &[u8]) {
    hold(&shown(data));
}

/// The text that a case is.
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

/// Holds the faults of a text to their promises in both languages, and gives the projects if there are none.
pub fn hold(text: &str) -> Option<Vec<Project>> {
    read(text, || workbench::read_all(text, &workbench::NoFiles))
}

/// The same with another way to read it.
pub fn read(
    text: &str,
    with: impl FnOnce() -> std::result::Result<Vec<Project>, Vec<workbench::Diagnostic>>,
) -> Option<Vec<Project>> {
    let faults = match with() {
        Ok(projects) => {
            assert!(!projects.is_empty());
            for input in inputs(text) {
                assert!(text.get(input.span.clone()).is_some(), "{text:?}: {input:?}");
            }
            for project in &projects {
                let _ = project_fingerprint(text, &project.recordings);
            }
            return Some(projects);
        }
        Err(faults) => faults,
    };
    let [english, german] = [Language::En, Language::De].map(|language| told(&faults, language));
    assert!(!english.is_empty());
    assert!(english.is_sorted_by_key(|fault| fault.span.start), "{text:?}");
    for faults in [&english, &german] {
        for fault in faults {
            assert!(text.get(fault.span.clone()).is_some(), "{text:?}: {fault:?}");
            assert_eq!((fault.line, fault.column), place(text, fault.span.start), "{fault:?}");
            tells(&fault.message);
            fault.hint.iter().for_each(|hint| tells(hint));
        }
        let _ = answer::faults("project.toml", faults);
    }
    let places = |faults: &[workbench::text::Told]| {
        faults.iter().map(|fault| (fault.id, fault.span.clone())).collect::<Vec<_>>()
    };
    assert_eq!(places(&english), places(&german), "{text:?}: the languages disagree about the faults");
    None
}
