//! Project files to start from, commented in either language.

use mechanism::MechanismId;
use quantities::Language;

/// A kind of project file and its example.
#[derive(Clone, Copy)]
struct TemplateKind {
    name: &'static str,
    text: &'static str,
    /// Recording that the project names.
    recording: Option<(&'static str, &'static str)>,
}

/// Recording of the example of a joint.
const ROBOT_JOINT: (&str, &str) = ("robot-joint.csv", include_str!("../../../examples/robot-joint.csv"));

static TEMPLATES: [TemplateKind; 6] = [
    TemplateKind { name: "manual", text: include_str!("../../../examples/indexing-table.toml"), recording: None },
    TemplateKind { name: "table", text: include_str!("../../../examples/turntable.toml"), recording: None },
    TemplateKind { name: "arm", text: include_str!("../../../examples/tilting-arm.toml"), recording: None },
    TemplateKind { name: "screw", text: include_str!("../../../examples/screw-axis.toml"), recording: None },
    TemplateKind { name: "belt", text: include_str!("../../../examples/belt-axis.toml"), recording: None },
    TemplateKind {
        name: "recording",
        text: include_str!("../../../examples/robot-joint.toml"),
        recording: Some(ROBOT_JOINT),
    },
];

/// Iterates over the kinds of project files to start from: those of the list, and every other mechanism under its own
/// name.
pub fn template_kinds() -> impl Iterator<Item = &'static str> {
    let named = |name: &str| TEMPLATES.iter().any(|kind| kind.name == name);
    // A load stated by its inertia alone is that of the manual's example.
    let mechanisms = MechanismId::ALL.iter().filter(|id| **id != MechanismId::Load).map(|id| id.key());
    TEMPLATES.iter().map(|kind| kind.name).chain(mechanisms.filter(move |name| !named(name)))
}

/// Returns the example of a kind.
fn kind_of(name: &str) -> Option<TemplateKind> {
    let listed = TEMPLATES.iter().find(|kind| kind.name == name).copied();
    listed.or_else(|| {
        let id = MechanismId::of(name).filter(|id| *id != MechanismId::Load)?;
        Some(TemplateKind {
            name: id.key(),
            text: id.example(),
            recording: (id == MechanismId::Joint).then_some(ROBOT_JOINT),
        })
    })
}

/// A project file to start from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Template {
    /// The project file.
    pub text: String,
    /// Recording that the project names: file name and content.
    pub recording: Option<(String, String)>,
}

/// Returns a project file of a kind, with comments in a language, for a file name; `None` if the kind does not exist.
#[must_use]
pub fn template(kind: &str, file: &str, language: Language) -> Option<Template> {
    let kind = kind_of(kind)?;
    let stem = file.strip_suffix(".toml").unwrap_or(file);
    let beside = format!("{stem}.csv");
    let recording = kind.recording.map(|(_, text)| (beside.clone(), recording_in(text, language)));
    let mut text = String::with_capacity(kind.text.len());
    for line in kind.text.lines() {
        if line.starts_with("# Run: antrieb") {
            continue;
        }
        if line == "format = 1" {
            text.push_str(&format!("# {}\n", words::how_to_run(file, language)));
        }
        let line = match kind.recording {
            Some((name, _)) => line.replace(name, &beside),
            None => line.to_owned(),
        };
        text.push_str(&worded(&line, language));
        text.push('\n');
    }
    Some(Template { text, recording })
}

fn recording_in(text: &str, language: Language) -> String {
    let (head, rest) = text.split_once('\n').unwrap_or((text, ""));
    format!("{}\n{rest}", worded(head, language))
}

/// Returns a line with its comment, or its name, in a language.
fn worded(line: &str, language: Language) -> String {
    let head = ["# ", "name = "].into_iter().find_map(|mark| line.find(mark).map(|at| at + mark.len()));
    let Some((before, text)) = head.and_then(|head| line.split_at_checked(head)) else { return line.to_owned() };
    format!("{before}{}", words::example_text(text, language).unwrap_or(text))
}

#[cfg(test)]
mod tests {
    use super::*;
    use axis::NoFiles;

    #[test]
    fn every_template_is_commented_in_german_too() {
        for kind in template_kinds() {
            let (en, de) = (
                template(kind, "axis.toml", Language::En).unwrap(),
                template(kind, "axis.toml", Language::De).unwrap(),
            );
            assert_eq!(en.text.lines().count(), de.text.lines().count());
            for (english, german) in en.text.lines().zip(de.text.lines()) {
                let worded = |line: &str| line.split_once("# ").map(|(_, comment)| comment.to_owned());
                let (a, b) = (worded(english), worded(german));
                assert_eq!(a.is_some(), b.is_some(), "{english}");
                let symbols = a.as_deref().is_none_or(|comment| comment.len() < 4);
                assert!(symbols || a != b, "{kind}: still English: {english}");
                assert!(!english.starts_with("name = ") || english != german, "{kind}: still English: {english}");
            }
        }
    }

    #[test]
    fn a_template_names_its_own_file_and_is_a_project() {
        for kind in template_kinds() {
            for language in [Language::En, Language::De] {
                let found = template(kind, "my axis.toml", language).unwrap();
                assert!(
                    found.text.contains("antrieb size my axis.toml") && !found.text.contains("examples/"),
                    "{kind}"
                );
                assert_eq!(found.recording.is_some(), matches!(kind, "recording" | "joint"));
                match &found.recording {
                    None => assert!(crate::read_all(&found.text, &NoFiles).is_ok(), "{kind}"),
                    Some((name, text)) => {
                        assert!(found.text.contains("file = \"my axis.csv\"") && name == "my axis.csv");
                        assert!(text.lines().count() > 100);
                    }
                }
            }
        }
    }
}
