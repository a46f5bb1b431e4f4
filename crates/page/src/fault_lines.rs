//! Faults of a project as lines that lead to where they can be mended.

use crate::markup::{id, vals};
use crate::sentences::{hint, quoted, worded};
use crate::state::{PageState, ReadProject};
use maud::{Markup, html};
use quantities::Language;
use words::{Worded, page};

/// Places that a fault can lead to: the fields of the shown axis, the other axes, the lines of the text.
pub(crate) struct FaultLines<'a> {
    state: &'a PageState,
    held: &'a ReadProject,
    /// The form of the shown axis.
    fields: &'a str,
}

impl<'a> FaultLines<'a> {
    pub(crate) const fn new(state: &'a PageState, held: &'a ReadProject, fields: &'a str) -> Self {
        Self { state, held, fields }
    }

    pub(crate) const fn language(&self) -> Language {
        self.state.language
    }

    /// Returns the fault as a link to its field, to its axis, or to its line in the text.
    pub(crate) fn line(&self, (path, fault): &(Option<String>, Worded)) -> Markup {
        let l = self.state.language;
        let at = page::at_line(&fault.line, &fault.column, l);
        let (all, alone) = (worded(&fault.message, fault.hint.as_deref(), l), quoted(&fault.message, l));
        html! {
            @match (path.as_deref().and_then(|path| self.field(path)), path.as_deref().and_then(|path| self.axis(path))) {
                // The fault itself leads to its field.
                (Some(id), _) => { a href={ "#" (id) } title=(at) { (alone) } (hint(fault.hint.as_deref(), l)) },
                (None, Some(axis)) => { button.plain type="button" hx-post="/work" hx-vals=(vals(&[("axis", &axis.to_string()), ("code", "")])) { (at) } ": " (all) },
                (None, None) => { a href="#text" data-line=(fault.line) { (at) } ": " (all) },
            }
        }
    }

    /// Returns the identifier of the field of a path; for a value without a field, of the enclosing table.
    fn field(&self, path: &str) -> Option<String> {
        let prefix = self.state.prefix.as_str();
        // A value outside the shown axis has no field.
        let inside = path.strip_prefix(prefix)?;
        let is_load = |path: &str| matches!(path.strip_prefix(prefix), Some("load" | "mechanism"));
        let of = |path: &str| {
            let id = if is_load(path) { String::from("mechanism") } else { id(path) };
            [id.clone(), format!("{id}-t"), format!("{id}-e")]
                .into_iter()
                .find(|id| self.fields.contains(&format!("id=\"{id}\"")))
        };
        let other = inside.starts_with("mechanism.").then(|| format!("{prefix}mechanism"));
        of(path).or_else(|| of(&other?))
    }

    /// Returns the position of the axis of a path unless it is the shown one.
    fn axis(&self, path: &str) -> Option<usize> {
        let place: usize = path.strip_prefix("axis[")?.split(']').next()?.parse().ok()?;
        place.checked_sub(1).filter(|place| *place != self.state.axis && *place < self.held.projects.len())
    }
}
