//! Texts for readers without the project file: a signed report, a distributed workbook.

use crate::keys::about_text;
use crate::pick;
use crate::project_file::short_label;
use crate::schema::schema_text;
use project::{KEYS, Key, input_label, key_at};
use quantities::Language;
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::LazyLock;

/// Returns the text with each key of the project file replaced by its purpose; a key in parentheses after its words is
/// left out, and so is an option of the command line in parentheses: `(--storage)`.
///
/// `no limit stated: requirements.torsion_max` becomes `no limit stated: maximum torsion …`. A word that is no key
/// stays unchanged.
#[must_use]
pub fn without_keys(text: &str, language: Language) -> Cow<'_, str> {
    match without_options(text) {
        Cow::Borrowed(text) => without_names(text, language),
        Cow::Owned(text) => Cow::Owned(without_names(&text, language).into_owned()),
    }
}

/// Returns the purpose of a key of the project file in a few words; the key itself if there is none.
#[must_use]
pub fn purpose_of(key: &str, language: Language) -> String {
    let of_a_table = || key_at(key).map(|key| short_label(about_text(key.about, language)));
    label(key, language).or_else(of_a_table).unwrap_or_else(|| key.to_owned())
}

/// Returns the text without the options of the command line that fill a parenthesis.
fn without_options(text: &str) -> Cow<'_, str> {
    let mut text = Cow::Borrowed(text);
    let mut from = 0;
    while let Some(start) = text.get(from..).and_then(|rest| rest.find(" (--")).map(|at| from + at) {
        let option = text.get(start + " (--".len()..).unwrap_or_default();
        let length = option.find(|sign: char| !(sign.is_ascii_lowercase() || sign == '-')).unwrap_or(option.len());
        from = start + " (--".len() + length;
        if length > 0 && text.get(from..).is_some_and(|rest| rest.starts_with(')')) {
            text.to_mut().replace_range(start..=from, "");
            from = start;
        }
    }
    text
}

/// Returns the text without names of keys.
fn without_names(text: &str, language: Language) -> Cow<'_, str> {
    if let Some(aside) = aside(text) {
        let (before, behind) = (text.get(..aside.start).unwrap_or_default(), text.get(aside.end..).unwrap_or_default());
        return Cow::Owned(without_names(&format!("{before}{behind}"), language).into_owned());
    }
    if !text.contains(['.', '_']) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    let mut changed = false;
    while let Some(found) = next_key(rest, language) {
        let (before, behind) = (rest.get(..found.from).unwrap_or_default(), rest.get(found.to..).unwrap_or_default());
        match (before.strip_suffix(" ("), end_of_aside(behind)) {
            (Some(before), Some(behind)) => {
                out.push_str(before);
                rest = behind;
            }
            // A key without its table may be an ordinary word.
            _ => {
                out.push_str(before);
                let key = rest.get(found.from..found.to).unwrap_or_default();
                out.push_str(if key.contains('.') { &found.label } else { key });
                rest = behind;
            }
        }
        changed = true;
    }
    if !changed {
        return Cow::Borrowed(text);
    }
    out.push_str(rest);
    Cow::Owned(out)
}

/// A key in a text.
struct Found {
    from: usize,
    to: usize,
    label: String,
}

fn next_key(text: &str, language: Language) -> Option<Found> {
    let is_part =
        |sign: char| sign.is_ascii_lowercase() || sign.is_ascii_digit() || matches!(sign, '_' | '.' | '[' | ']');
    let mut from = 0;
    while let Some(start) = text.get(from..)?.find(|sign: char| sign.is_ascii_lowercase()).map(|at| from + at) {
        let length = text.get(start..)?.find(|sign| !is_part(sign)).unwrap_or(text.len() - start);
        let word = text.get(start..start + length)?.trim_end_matches('.');
        let is_within = text
            .get(..start)?
            .ends_with(|sign: char| sign.is_alphanumeric() || matches!(sign, '_' | '-' | '/' | '.' | '"'));
        if !is_within
            && word.contains(['.', '_'])
            && let Some(label) = label(word, language)
        {
            return Some(Found { from: start, to: start + word.len(), label });
        }
        // The rest of a word is no separate word.
        from = start + length.max(1);
        from += text.get(from..)?.find(|sign: char| !sign.is_alphanumeric()).unwrap_or(0);
    }
    None
}

/// Returns the rest after the parenthesis that a key fills, alone or with its value: `)`, ` = "ignore")`.
fn end_of_aside(behind: &str) -> Option<&str> {
    let behind = match behind.strip_prefix(" = \"") {
        Some(value) => value.split_once('"')?.1,
        None => behind,
    };
    behind.strip_prefix(')')
}

/// Returns the place of the first parenthesis that holds names of keys alone, with the blank before it: ` (winding)`,
/// ` (time, distance)`. Elsewhere such a word may be an ordinary one.
fn aside(text: &str) -> Option<Range<usize>> {
    static NAMES: LazyLock<BTreeSet<&'static str>> = LazyLock::new(|| {
        fn walk(keys: &'static [Key], names: &mut BTreeSet<&'static str>) {
            for key in keys {
                names.insert(key.name);
                walk(key.kind.keys(true), names);
            }
        }
        let mut names = BTreeSet::new();
        walk(KEYS, &mut names);
        names
    });
    let mut from = 0;
    while let Some(start) = text.get(from..)?.find(" (").map(|at| from + at) {
        let inside = start + " (".len();
        let length = text.get(inside..)?.find(')')?;
        if text.get(inside..inside + length)?.split(", ").all(|word| NAMES.contains(word)) {
            return Some(start..inside + length + 1);
        }
        from = inside;
    }
    None
}

/// Tables whose keys appear in texts without their table.
const BARE: [&str; 9] = [
    "motion",
    "bearing",
    "requirements",
    "mechanism.arm",
    "mechanism.screw",
    "mechanism.hoist",
    "mechanism.scissor_lift",
    "mechanism.four_bar",
    "stage",
];

fn label(key: &str, language: Language) -> Option<String> {
    let known = input_label(key).or_else(|| {
        let bare = (!key.contains('.')).then_some(BARE)?;
        bare.iter().find_map(|table| input_label(&format!("{table}.{key}")))
    })?;
    let label = short_label(&schema_text(known, language));
    let mut parts = label.split(", ").flat_map(|part| part.split(": "));
    let head = parts.next().unwrap_or(&label);
    // A symbol at the head goes behind its term: `T_L, friction torque`.
    let is_symbol = !head.contains(' ') && (head.contains('_') || head.chars().count() == 1);
    let label = match parts.next() {
        Some(term) if is_symbol => format!("{term} {head}"),
        _ => head.to_owned(),
    };
    let number = key.strip_prefix("motion[").and_then(|rest| rest.split_once(']')).map(|(number, _)| number);
    Some(match number {
        Some(number) => format!("{label} ({} {number})", pick(language, "segment", "Abschnitt")),
        None => label,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_gives_way_to_its_words_and_an_aside_goes() {
        let de = |text| without_keys(text, Language::De).into_owned();
        assert_eq!(
            de("keine Grenze angegeben: requirements.mass_max"),
            "keine Grenze angegeben: maximale Masse des Antriebs"
        );
        assert_eq!(de("90 % von U_DC/√2 (requirements.modulation_reserve)"), "90 % von U_DC/√2");
        assert_eq!(de("wie angegeben (bearing.mechanism = \"ignore\"), ja"), "wie angegeben, ja");
        assert_eq!(de("Neigung (axis_tilt): oben"), "Neigung: oben");
        assert_eq!(de("ein Jahr (--inspect), zwei (--hours-per-day) oder mehr"), "ein Jahr, zwei oder mehr");
        assert_eq!(de("Neigung (inclination): waagerecht (arm_mass)"), "Neigung: waagerecht");
        assert_eq!(de("Wickelrichtung (winding), Durchmesser (start_diameter)"), "Wickelrichtung, Durchmesser");
        assert_eq!(de("weder Dauer noch Weg (time, distance)"), "weder Dauer noch Weg");
        assert_eq!(de("nicht angegeben: bearing.belt_tension"), "nicht angegeben: statische Trumkraft des Riemens F_v");
        assert_eq!(de("nicht angegeben: bearing.wheel_mass"), "nicht angegeben: Masse des Rads am Flansch");
        let assumed = crate::terminal::best_of_the_ranking(&"CODE", Language::De);
        assert_eq!(de(&assumed), "kein Antrieb angegeben: der beste der Rangfolge, CODE");
        assert_eq!(purpose_of("stage.ratio", Language::De), de("stage.ratio"));
        assert!(!purpose_of("mechanism.hoist.counterweight", Language::En).contains('.'));
        let time = de("Projekt motion[3].time");
        assert!(time.ends_with("(Abschnitt 3)") && !time.contains("motion"), "{time}");
    }

    /// A sentence names a key by its label: two keys of a table with one label would be one thing for the reader.
    #[test]
    fn keys_of_a_table_have_different_labels() {
        fn walk(path: &str, keys: &[project::Key], language: Language, found: &mut Vec<String>) {
            let path_of = |key: &project::Key| {
                if path.is_empty() { key.name.to_owned() } else { format!("{path}.{}", key.name) }
            };
            let labels: Vec<(String, String)> =
                keys.iter().filter_map(|key| Some((path_of(key), label(&path_of(key), language)?))).collect();
            for (place, (one, text)) in labels.iter().enumerate() {
                let twin = labels.iter().skip(place + 1).find(|(_, other)| other == text);
                found.extend(twin.map(|(other, _)| format!("{one}, {other}: {text}")));
            }
            for key in keys {
                let mut inside = |keys: &[project::Key]| walk(&path_of(key), keys, language, found);
                match key.kind {
                    project::Kind::Table(inner) => inside(inner),
                    project::Kind::OneOrMany(one, several) => [one, several].into_iter().for_each(inside),
                    project::Kind::Variants(of) => inside(of.keys),
                    _ => {}
                }
            }
        }
        for language in [Language::En, Language::De] {
            let mut found = Vec::new();
            walk("", project::KEYS, language, &mut found);
            assert!(found.is_empty(), "{language:?}: {found:#?}");
        }
    }

    #[test]
    fn what_is_no_key_stays() {
        for text in [
            "T_rms 4.2 Nm",
            "robot-joint.csv",
            "z. B. n_mot_max",
            "a.b.c",
            "Load of load.weight_of_the_moon",
            "\"load.inertia\"",
            "xload.inertia",
            "with --today DATE (--today DATE), (--)",
        ] {
            assert_eq!(without_keys(text, Language::En), text);
        }
    }
}
