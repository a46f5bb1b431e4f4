//! Changes of a project text that keep its comments.

use project::{Edit, EditFault, edit};

/// Change of a text at a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextChange<'t> {
    /// A value as typed into a field.
    Value(&'t str),
    /// An empty table, or an empty entry of a list.
    Table,
    /// Absence of what was under this path.
    Gone,
}

/// Returns the text with changes in their order.
///
/// # Errors
/// [`EditFault`] of the first change that cannot be made.
pub fn edited<'t>(
    text: &str,
    changes: impl IntoIterator<Item = (&'t str, TextChange<'t>)>,
) -> Result<String, EditFault> {
    // An edit writes plain ends of lines.
    let has_carriage_returns = text.contains("\r\n");
    let edited = changes.into_iter().try_fold(text.to_owned(), |text, (path, change)| {
        let change = match change {
            TextChange::Value(typed) => Edit::Value(typed),
            TextChange::Table => Edit::Table,
            TextChange::Gone => Edit::Gone,
        };
        edit(&text, path, change)
    })?;
    Ok(if has_carriage_returns { edited.replace("\r\n", "\n").replace('\n', "\r\n") } else { edited })
}
