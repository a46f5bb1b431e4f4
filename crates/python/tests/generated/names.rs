//! Names of Python for those of the list and of the schema, and texts as its strings.

/// Reserved names of Python that occur.
const KEPT: [&str; 35] = [
    "False", "None", "True", "and", "as", "assert", "async", "await", "break", "class", "continue", "def", "del",
    "elif", "else", "except", "finally", "for", "from", "global", "if", "import", "in", "is", "lambda", "nonlocal",
    "not", "or", "pass", "raise", "return", "try", "while", "with", "yield",
];

/// Returns the Python name of a name of the list or of a field: `hours-per-day` is `hours_per_day`, `for` is `for_`.
pub(super) fn name(written: &str) -> String {
    let plain: String = written.chars().map(|sign| if sign.is_ascii_alphanumeric() { sign } else { '_' }).collect();
    if KEPT.contains(&plain.as_str()) { plain + "_" } else { plain }
}

/// Returns the function of a command: `wiring --check` is `wiring_check`.
pub(super) fn function(command: &str) -> String {
    name(&command.replace(" --", " "))
}

/// Returns the class of a record: `Axes_of_Sizing` is `AxesOfSizing`.
pub(super) fn class(definition: &str) -> String {
    let capital = |word: &str| {
        let mut signs = word.chars();
        signs.next().map_or_else(String::new, |first| first.to_uppercase().chain(signs).collect())
    };
    definition.split('_').map(capital).collect()
}

/// Escapes a text for a string of three quotes.
pub(super) fn doc(text: &str) -> String {
    text.replace('\\', "\\\\").replace("\"\"\"", "\\\"\\\"\\\"")
}

/// Returns a sentence with a capital and a full stop.
pub(super) fn sentence(text: &str) -> String {
    let text = text.trim();
    let mut signs = text.chars();
    let mut whole: String = signs.next().map_or_else(String::new, |first| first.to_uppercase().chain(signs).collect());
    if !whole.ends_with(['.', '?', '!']) {
        whole.push('.');
    }
    whole
}

/// Returns a Python string.
pub(super) fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

/// Returns the type of one of these strings.
pub(super) fn literal<'w>(words: impl IntoIterator<Item = &'w str>) -> String {
    let words: Vec<String> = words.into_iter().map(quoted).collect();
    format!("Literal[{}]", words.join(", "))
}
