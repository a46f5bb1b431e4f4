//! What the page is about at an instant: a project's text, and what of it is looked at.
//!
//! A shell keeps none of it. Every request carries it, and every answer gives it back.

use crate::call::Call;
use figures::Theme;
use workbench::text::{Told, told};
use workbench::{
    Diagnostic, Edit, Files, Language, OrderCode, Patience, Project, Unread, Written, edit, read_all_watched,
    read_code, written,
};

/// The state as a request carries it, with what was changed by it.
pub(crate) struct State {
    /// The project's text.
    pub(crate) text: String,
    /// The last text without faults; empty before there was one.
    pub(crate) good: String,
    /// Which axis is shown, from zero.
    pub(crate) axis: usize,
    /// The actuator that is looked at; without one the best.
    pub(crate) code: Option<OrderCode>,
    /// The actuators marked to be compared.
    pub(crate) marked: Vec<OrderCode>,
    pub(crate) language: Language,
    pub(crate) theme: Theme,
    /// The project file in the folder.
    pub(crate) file: String,
    /// The version that was opened, and the name of its file.
    pub(crate) known: String,
    /// What the ranking is narrowed to.
    pub(crate) filter: Filter,
}

/// What the ranking is narrowed to; figures as they were typed.
#[derive(Default)]
pub(crate) struct Filter {
    pub(crate) size: String,
    pub(crate) feedback: String,
    pub(crate) brake: String,
    pub(crate) bore_mm: String,
    pub(crate) length_mm: String,
    pub(crate) mass_kg: String,
}

/// The project as it could be read.
pub(crate) struct Held {
    /// Its axes; those of the last good text where the text has faults.
    pub(crate) projects: Vec<Project>,
    /// Every fault of the text, with the path that it is shown at.
    pub(crate) faults: Vec<(Option<String>, Told)>,
    /// Whether the projects are those of an older text.
    pub(crate) is_old: bool,
    /// Every key of the text; of the last good one where it is no TOML.
    pub(crate) written: Vec<Written>,
    /// Whether the text is TOML, so that something in it has a place.
    pub(crate) has_places: bool,
}

impl State {
    /// The state that a request carries.
    pub(crate) fn of(call: &Call<'_>) -> Self {
        let field = |name: &str| call.field(name).map(std::borrow::Cow::into_owned).unwrap_or_default();
        let code = |text: &str| read_code(text, call.language()).ok().map(|reading| reading.parsed.code);
        let marked = call.fields().filter(|(key, _)| key == "mark");
        let mut state = Self {
            text: field("text").replace("\r\n", "\n"),
            good: field("good").replace("\r\n", "\n"),
            axis: field("axis").parse().unwrap_or(0),
            code: code(&field("code")),
            marked: marked.filter_map(|(_, text)| code(&text)).take(MARKED_MOST).collect(),
            language: call.language(),
            theme: if field("theme") == "dark" { Theme::Dark } else { Theme::Light },
            file: field("file"),
            known: field("known"),
            filter: Filter {
                size: field("f_size"),
                feedback: field("f_feedback"),
                brake: field("f_brake"),
                bore_mm: field("f_bore"),
                length_mm: field("f_length"),
                mass_kg: field("f_mass"),
            },
        };
        state.change(call);
        state
    }

    /// Carries out what the request changes, in its order; what has no place in the text changes nothing.
    fn change(&mut self, call: &Call<'_>) {
        let mut apply = |path: &str, change: Edit<'_>| {
            if let Ok(text) = edit(&self.text, path, change) {
                self.text = text;
            }
        };
        let asked: Vec<_> = call.fields().filter(|(key, _)| key == "do").map(|(_, value)| value).collect();
        for value in asked.iter().flat_map(|value| value.lines()) {
            let (what, path) = value.split_once(' ').unwrap_or((value, ""));
            match what {
                "table" => apply(path, Edit::Table),
                "gone" => apply(path, Edit::Gone),
                "instead" => apply(path, Edit::Instead),
                "down" => apply(path, Edit::Down),
                "value" => {
                    let (path, value) = path.split_once('=').unwrap_or((path, ""));
                    apply(path, Edit::Value(value));
                }
                _ => {}
            }
        }
        if let (Some(path), Some(value)) = (call.field("path"), call.field("value")) {
            apply(&path, Edit::Value(&value));
        }
    }

    /// Reads the project; what cannot be read leaves the last good one.
    pub(crate) fn hold(&mut self, files: &dyn Files, patience: &Patience) -> Held {
        let keys = written(&self.text);
        let has_places = keys.is_some();
        match read_all_watched(&self.text, files, patience) {
            Ok(projects) => {
                self.good.clone_from(&self.text);
                let written = keys.unwrap_or_default();
                Held { projects, faults: Vec::new(), is_old: false, written, has_places }
            }
            Err(unread) => {
                let found = match unread {
                    Unread::Faults(found) => found,
                    Unread::Stopped => Vec::new(),
                };
                let faults = placed(&found, keys.as_deref().unwrap_or_default(), self.language);
                let projects = read_all_watched(&self.good, files, patience).unwrap_or_default();
                let written = keys.or_else(|| written(&self.good)).unwrap_or_default();
                Held { projects, faults, is_old: true, written, has_places }
            }
        }
    }
}

/// The most actuators that stand side by side.
pub(crate) const MARKED_MOST: usize = 5;

/// Every fault with the path that it belongs to: the one that it names, else that of the smallest value around it.
fn placed(faults: &[Diagnostic], written: &[Written], language: Language) -> Vec<(Option<String>, Told)> {
    let path = |fault: &Diagnostic| -> Option<String> {
        if let workbench::Fault::MissingKey { path, .. } = &fault.fault {
            return Some(path.clone());
        }
        let around = |key: &&Written| {
            key.span.start < fault.span.end.max(fault.span.start + 1) && fault.span.start < key.span.end
        };
        written.iter().filter(around).min_by_key(|key| key.span.len()).map(|key| key.path.clone())
    };
    told(faults, language).into_iter().zip(faults).map(|(told, fault)| (path(fault), told)).collect()
}
