//! Project files to start from, commented in either language.

use axis::TemplateFigure;
use mechanism::MechanismId;
use project::{Kind, Written, key_at, written};
use quantities::Language;
use std::sync::LazyLock;

/// A kind of project file.
#[derive(Clone, Copy)]
struct ProjectKind {
    name: &'static str,
    /// The data that define the machine, and a plain motion.
    plain: &'static str,
    /// A machine with all that it may have.
    example: &'static str,
    /// Recording that the project names.
    recording: Option<(&'static str, &'static str)>,
}

/// Recording of the example of a joint.
const ROBOT_JOINT: (&str, &str) = ("robot-joint.csv", include_str!("../../../examples/robot-joint.csv"));

/// Lists the kinds: name, plain file, mechanism of the example.
macro_rules! kinds {
    ($($name:literal $plain:literal $mechanism:ident;)*) => {
        [$(ProjectKind {
            name: $name,
            plain: include_str!(concat!("../templates/", $plain, ".toml")),
            example: MechanismId::$mechanism.example(),
            recording: if matches!(MechanismId::$mechanism, MechanismId::Joint) { Some(ROBOT_JOINT) } else { None },
        }),*]
    };
}

static KINDS: [ProjectKind; 16] = kinds! {
    "manual" "manual" Load;
    "table" "turntable" Turntable;
    "arm" "arm" Arm;
    "screw" "screw" Screw;
    "belt" "belt" Belt;
    "recording" "joint" Joint;
    "load" "load" Load;
    "turntable" "turntable" Turntable;
    "conveyor" "conveyor" Conveyor;
    "slider_crank" "slider_crank" SliderCrank;
    "joint" "joint" Joint;
    "hoist" "hoist" Hoist;
    "winder" "winder" Winder;
    "unwinder" "unwinder" Winder;
    "scissor_lift" "scissor_lift" ScissorLift;
    "four_bar" "four_bar" FourBar;
};

/// Iterates over the kinds of project files to start from.
pub fn template_kinds() -> impl Iterator<Item = &'static str> {
    KINDS.iter().map(|kind| kind.name)
}

/// Returns the plain project file of a mechanism in English, without the recording that it may name; `None` for a table
/// of a cam, which has no plain one.
#[must_use]
pub fn plain_text(id: MechanismId) -> Option<&'static str> {
    KINDS.iter().find(|kind| kind.name == id.key() && id != MechanismId::Table).map(|kind| kind.plain)
}

/// A project file to start from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Template {
    /// The project file.
    pub text: String,
    /// Recording that the project names: file name and content.
    pub recording: Option<(String, String)>,
}

/// Returns the plain project file of a kind, with comments in a language, for a file name: what defines the machine, and
/// a plain motion, special things as comments to switch on; `None` if the kind does not exist.
#[must_use]
pub fn template(kind: &str, file: &str, language: Language) -> Option<Template> {
    let kind = KINDS.iter().find(|known| known.name == kind)?;
    Some(commented(kind, kind.plain, file, language))
}

/// Returns the example of a kind, with comments in a language, for a file name: a machine with all that it may have;
/// `None` if the kind does not exist.
#[must_use]
pub fn example(kind: &str, file: &str, language: Language) -> Option<Template> {
    let kind = KINDS.iter().find(|known| known.name == kind)?;
    // The example of the mechanism winds up.
    let text = if kind.name == "unwinder" { kind.plain } else { kind.example };
    Some(commented(kind, text, file, language))
}

/// Returns a project file with comments in a language, for a file name.
fn commented(kind: &ProjectKind, project: &str, file: &str, language: Language) -> Template {
    let stem = file.strip_suffix(".toml").unwrap_or(file);
    let beside = format!("{stem}.csv");
    let recording = kind.recording.map(|(_, text)| (beside.clone(), recording_in(text, language)));
    let mut text = String::with_capacity(project.len());
    for line in project.lines() {
        if line.starts_with("# Run: antrieb") {
            continue;
        }
        if line == "format = 1" {
            text.push_str(&format!("# {}\n", words::how_to_run(file, language)));
            if project == kind.plain {
                text.push_str(&format!("# {}\n", words::figures_of_a_template(language)));
            }
        }
        let line = match kind.recording {
            Some((name, _)) => line.replace(name, &beside),
            None => line.to_owned(),
        };
        text.push_str(&worded(&line, language));
        text.push('\n');
    }
    Template { text, recording }
}

/// Figures of a kind of project: paths with their values.
type Figures = Vec<(String, String)>;

/// First lines of the plain files, in every language, with the figures of the file.
static FIGURES: LazyLock<Vec<(String, Figures)>> = LazyLock::new(|| {
    let of = |kind: &ProjectKind| {
        let is_figure = |each: &Written| {
            let kind = key_at(&each.path).map(|key| key.kind);
            matches!(kind, Some(Kind::Quantity(..) | Kind::Along(..) | Kind::Number(..) | Kind::Integer(..)))
                && each.path.contains('.')
        };
        let all = written(kind.plain).unwrap_or_default().into_iter().filter(is_figure);
        let figures: Figures = all.filter_map(|each| Some((each.path, each.value?))).collect();
        let head = |language| worded(kind.plain.lines().next().unwrap_or_default(), language);
        Language::ALL.map(|language| (head(language), figures.clone()))
    };
    KINDS.iter().flat_map(of).collect()
});

/// Returns the figures of a template that a project begun with it still has: no one has stated them. A project without the head
/// line of its template has none.
pub(crate) fn unstated_figures(text: &str) -> Vec<TemplateFigure> {
    // Further lines may have been added above it.
    let mut heads = text.lines().map(str::trim_end).take_while(|line| line.is_empty() || line.starts_with('#'));
    let of_head = |head| FIGURES.iter().find(|(known, _)| known == head);
    let Some((_, figures)) = heads.find_map(of_head) else { return Vec::new() };
    let all = written(text).unwrap_or_default();
    let stated = stated(text);
    let is_kept = |(path, value): &&(String, String)| {
        all.iter().any(|each| each.path == *path && each.value.as_ref() == Some(value)) && !stated.contains(&&**path)
    };
    figures.iter().filter(is_kept).map(|(path, value)| TemplateFigure { path, value }).collect()
}

/// Returns the paths that a project lists as stated though their values are those of its template.
#[must_use]
pub fn stated(text: &str) -> Vec<&str> {
    text.lines().filter_map(words::paths_stated_of_template).flatten().collect()
}

/// Returns a project that lists figures of its template as stated. The list stands behind everything else, so that no line moves; a
/// text that is begun with no template stays as it is.
#[must_use]
pub fn stating(text: &str, paths: &[&str], language: Language) -> String {
    let figures = unstated_figures(text);
    let new: Vec<&str> =
        paths.iter().copied().filter(|path| figures.iter().any(|figure| figure.path == *path)).collect();
    if new.is_empty() {
        return text.to_owned();
    }
    let rest = text.lines().filter(|line| words::paths_stated_of_template(line).is_none());
    let listed = stated(text).into_iter().chain(new).collect::<Vec<&str>>();
    let line = words::stated_of_template(&listed, language);
    rest.chain([&*line]).map(|line| format!("{line}\n")).collect()
}

fn recording_in(text: &str, language: Language) -> String {
    let (head, rest) = text.split_once('\n').unwrap_or((text, ""));
    format!("{}\n{rest}", worded(head, language))
}

/// Returns a line that is switched off, without its mark: a key or the head of a table behind `# `.
fn switched_off(line: &str) -> Option<&str> {
    let line = line.strip_prefix("# ")?;
    let is_key = line.split_once(" = ").is_some_and(|(key, _)| !key.is_empty() && !key.contains(' '));
    (is_key || line.starts_with('[')).then_some(line)
}

/// Returns a line with its comment, or its name, in a language.
fn worded(line: &str, language: Language) -> String {
    if let Some(inner) = switched_off(line) {
        return format!("# {}", worded(inner, language));
    }
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
            for of in [template, example] {
                let (en, de) =
                    (of(kind, "axis.toml", Language::En).unwrap(), of(kind, "axis.toml", Language::De).unwrap());
                assert_eq!(en.text.lines().count(), de.text.lines().count());
                for (english, german) in en.text.lines().zip(de.text.lines()) {
                    let worded = |line: &str| {
                        let line = switched_off(line).unwrap_or(line);
                        line.split_once("# ").map(|(_, comment)| comment.to_owned())
                    };
                    let (a, b) = (worded(english), worded(german));
                    assert_eq!(a.is_some(), b.is_some(), "{english}");
                    let symbols = a.as_deref().is_none_or(|comment| comment.len() < 4);
                    assert!(symbols || a != b, "{kind}: still English: {english}");
                    assert!(!english.starts_with("name = ") || english != german, "{kind}: still English: {english}");
                }
            }
        }
    }

    #[test]
    fn a_template_names_its_own_file_and_is_a_project() {
        for kind in template_kinds() {
            for language in [Language::En, Language::De] {
                for found in [template, example].map(|of| of(kind, "my axis.toml", language).unwrap()) {
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

    #[test]
    fn figures_of_a_template_are_assumptions_until_they_are_stated() {
        for language in Language::ALL {
            let text = template("hoist", "axis.toml", language).unwrap().text;
            let paths = |text: &str| -> Vec<&str> { unstated_figures(text).iter().map(|figure| figure.path).collect() };
            let all = paths(&text);
            for path in ["mechanism.hoist.drum_diameter", "mechanism.hoist.falls", "motion[1].time"] {
                assert!(all.contains(&path), "{path}: {all:?}");
            }
            let stated = text.replace("\"120 mm\"", "\"150 mm\"").replace("falls = 2 ", "falls = 4 ");
            assert_eq!(paths(&stated).len(), all.len() - 2);
            let project = &crate::read_all(&stated, &NoFiles).unwrap()[0];
            let assumed = project.assumed();
            let of_template = assumed.iter().filter(|each| matches!(each.assumption, axis::Assumption::OfTemplate(_)));
            assert_eq!(of_template.count(), all.len() - 2);
            let (_, rest) = text.split_once('\n').unwrap();
            assert!(paths(rest).is_empty());
            // The file says so itself, and lines above leave it a template.
            assert!(rest.contains(&words::figures_of_a_template(language)));
            assert_eq!(paths(&format!("# Order 4711\n\n{text}")).len(), all.len());
        }
    }

    /// Recording of a template, under any name.
    struct Beside(String);

    impl axis::Files for Beside {
        fn open(&self, _: &str) -> std::io::Result<Box<dyn std::io::Read>> {
            Ok(Box::new(std::io::Cursor::new(self.0.clone().into_bytes())))
        }
    }

    /// Every line that is switched off is one of the project: with all of them on, the file is read, and each key has an
    /// effect.
    #[test]
    fn what_is_switched_off_can_be_switched_on() {
        for kind in template_kinds() {
            let found = template(kind, "axis.toml", Language::En).unwrap();
            let files = Beside(found.recording.map(|(_, text)| text).unwrap_or_default());
            let on = |lines: &mut dyn Iterator<Item = &str>| {
                lines.map(|line| switched_off(line).unwrap_or(line)).collect::<Vec<_>>().join("\n")
            };
            let all = on(&mut found.text.lines());
            let read = crate::read_all(&all, &files);
            assert!(read.is_ok(), "{kind}: {read:?}\n{all}");
            assert!(all != found.text, "{kind}");
        }
    }
}
