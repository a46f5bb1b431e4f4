//! Mechanism of a recording along a line: its travel per turn relates positions and forces to the output.

use crate::call::Call;
use crate::start::{BEGINS, Begin};
use maud::{Markup, html};
use project::{Written, written};
use quantities::Language;
use std::sync::LazyLock;
use words::{incoming, page};

/// Name of the field with the chosen mechanism.
const FIELD: &str = "mechanism";

/// Mass of a mechanism whose recorded force is the whole load.
pub(super) const NO_MASS: &str = "0 kg";

/// Ways to begin whose mechanism has a constant travel per turn.
static LINEAR: LazyLock<Vec<&'static Begin>> =
    LazyLock::new(|| BEGINS.iter().filter(|begin| begin.has_travel()).collect());

/// Mechanism stated together with a recording.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct LineMechanism {
    /// Key of the mechanism; `None` if none is chosen.
    pub(super) name: Option<&'static str>,
    /// Paths of the keys that define it, with their values; empty where none is typed.
    pub(super) values: Vec<(&'static str, String)>,
}

/// Returns the chosen way to begin.
fn begin_of(name: &str) -> Option<&'static Begin> {
    LINEAR.iter().copied().find(|begin| begin.mechanism == Some(name))
}

/// Iterates over the rows of a way to begin that define its mechanism. Of the whole load they define its travel only.
fn rows(begin: &'static Begin, is_whole: bool) -> impl Iterator<Item = &'static [&'static str]> {
    let is_asked = move |path: &&str| {
        path.starts_with("mechanism.") && !(is_whole && (path.ends_with(".mass") || path.ends_with(".inclination")))
    };
    begin.asked.iter().copied().filter(move |row| row.first().is_some_and(&is_asked))
}

impl LineMechanism {
    /// Returns the statements of a call about a recording along a line; `None` if the axis whose keys have a prefix in the
    /// text has a mechanism with a constant travel per turn that stays. `is_whole`: the recorded force is the whole load.
    pub(super) fn of(call: &Call<'_>, (text, prefix): (&str, &str), is_whole: bool) -> Option<Self> {
        let keys = written(text).unwrap_or_default();
        let is_stated = |name: &&str| {
            let table = format!("{prefix}mechanism.{name}");
            keys.iter()
                .any(|key| key.path.strip_prefix(&table).is_some_and(|rest| rest.is_empty() || rest.starts_with('.')))
        };
        let present = LINEAR.iter().filter_map(|begin| begin.mechanism).find(is_stated);
        if present.is_some() && !is_whole {
            return None;
        }
        let chosen = call.field(FIELD);
        let name = match &chosen {
            Some(word) => begin_of(word).and_then(|begin| begin.mechanism),
            None => present,
        };
        let value = |begin: &Begin, path: &'static str| {
            let of_project = |key: &Written| (key.path == format!("{prefix}{path}")).then(|| key.value.clone());
            let typed = crate::start::typed_value(begin, path, call);
            typed.or_else(|| keys.iter().find_map(of_project).flatten()).unwrap_or_default().trim().to_owned()
        };
        let begin = name.and_then(begin_of);
        let paths = begin.into_iter().flat_map(|begin| rows(begin, is_whole).flatten().map(move |path| (begin, *path)));
        Some(Self { name, values: paths.map(|(begin, path)| (path, value(begin, path))).collect() })
    }

    /// Returns `true` if a mechanism is chosen and each of its values is stated.
    pub(super) fn is_stated(&self) -> bool {
        self.name.is_some() && self.values.iter().all(|(_, value)| !value.is_empty())
    }

    /// Returns the choice of the mechanism with the values that define it.
    pub(super) fn fields(&self, is_whole: bool, language: Language) -> Markup {
        let l = language;
        let value = |path: &str| {
            self.values.iter().find(|(of, _)| *of == path).map(|(_, value)| value.clone()).unwrap_or_default()
        };
        html! {
            fieldset id="incoming-mechanism" {
                legend { (page::mechanism(l)) }
                p.small { (incoming::mechanism_about(l)) }
                select id="incoming-mechanism-kind" name=(FIELD) aria-label=(page::mechanism(l)) data-chosen=(self.name.unwrap_or_default()) {
                    option value="" { (page::choose(l)) }
                    @for name in LINEAR.iter().filter_map(|begin| begin.mechanism) {
                        option value=(name) selected[self.name == Some(name)] { (crate::start::title(Some(name), l)) }
                    }
                }
                @if let Some(begin) = self.name.and_then(begin_of) {
                    @for row in rows(begin, is_whole) { (crate::start::value_row(begin, row, &value, l)) }
                }
            }
        }
    }
}
