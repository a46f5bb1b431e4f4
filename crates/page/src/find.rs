//! The palette: search for keys of the project file, checks, ordering codes and terms of the glossary; and the keyboard
//! shortcuts.

use crate::call::Call;
use crate::markup::id;
use maud::{Markup, html};
use project::{KEYS, Key, Kind, key_at};
use quantities::Language;
use questions::CheckId;
use questions::list::code_list::list_codes;
use questions::list::glossary::glossary;
use words::{
    about_text, capitalised, check_title, own_and_foreign, page, part_title, row_sign, short_label, table_of_project,
    terms,
};

/// Largest number of hits of one kind.
const SHOWN: usize = 8;

/// A hit.
struct Found {
    kind: &'static str,
    value: String,
    title: String,
    about: String,
}

/// Returns the hits for the typed words.
pub(crate) fn found(call: &Call<'_>) -> Markup {
    let l = call.language();
    let typed = call.field("q").unwrap_or_default().trim().to_lowercase();
    if typed.is_empty() {
        return html! {};
    }
    let all = [keys(&typed, l), checks(&typed, l), codes(&typed, l), glossary_terms(&typed, l)];
    html! {
        @if all.iter().all(Vec::is_empty) { p { (page::nothing_found(l)) } }
        ul { @for one in all.iter().flatten() {
            li { button type="button" data-found=(one.kind) value=(one.value) { span { (one.title) } span.kind { (one.about) } } }
        } }
    }
}

/// Returns `true` if every typed word occurs in one of the texts.
fn holds(typed: &str, texts: &[&str]) -> bool {
    let texts: Vec<String> = texts.iter().map(|text| text.to_lowercase()).collect();
    typed.split_whitespace().all(|word| texts.iter().any(|text| text.contains(word)))
}

/// Returns the keys of the project file whose path or name contains the words.
fn keys(typed: &str, language: Language) -> Vec<Found> {
    let mut found = Vec::new();
    walk(KEYS, "", &mut |path, key| {
        let about = about_text(key.about, language);
        if found.len() < SHOWN && holds(typed, &[path, about]) {
            let title = capitalised(&short_label(about));
            found.push(Found { kind: "key", value: id(path), title, about: table_of(path, language) });
        }
    });
    found
}

/// Returns the title of the table that a key stands in, as the left pane shows it.
fn table_of(path: &str, language: Language) -> String {
    let mut above = path;
    while let Some((table, _)) = above.rsplit_once('.') {
        let name = table.rsplit('.').next().unwrap_or(table).trim_end_matches("[1]");
        if let Some(title) = table_of_project(name, language) {
            return title.to_owned();
        }
        if let Some(key) = key_at(table) {
            return capitalised(&short_label(about_text(key.about, language)));
        }
        above = table;
    }
    table_of_project("", language).unwrap_or_default().to_owned()
}

/// Visits every value below these keys with its path; the first entry of a list stands for all of its entries.
pub(crate) fn walk(keys: &'static [Key], above: &str, each: &mut impl FnMut(&str, &'static Key)) {
    for key in keys {
        let path = if above.is_empty() { key.name.to_owned() } else { format!("{above}.{}", key.name) };
        // The form of a single axis: with several axes the tables of the root stand in each of them.
        match (key.kind.keys(false), key.kind) {
            ([], _) => each(&path, key),
            (inside, Kind::Variants(_)) => walk(inside, &format!("{path}[1]"), each),
            (inside, _) => walk(inside, &path, each),
        }
    }
}

fn checks(typed: &str, language: Language) -> Vec<Found> {
    let of = |id: &CheckId| {
        let title = capitalised(&check_title(*id, language));
        let part = part_title(id.part(), language);
        let about = format!("{}, {part}", capitalised(terms::check(language)));
        holds(typed, &[&title, id.id(), part]).then(|| Found { kind: "check", value: id.id().to_owned(), title, about })
    };
    CheckId::ALL.iter().filter_map(of).take(SHOWN).collect()
}

fn codes(typed: &str, language: Language) -> Vec<Found> {
    // Nearly every word with a letter occurs in a code.
    if typed.len() < 3 || !typed.contains(|sign: char| sign.is_ascii_digit()) {
        return Vec::new();
    }
    let found = list_codes(None).into_iter().map(|(code, _)| code.to_string()).filter(|code| holds(typed, &[code]));
    let about = capitalised(terms::ordering_code(language));
    found
        .take(SHOWN)
        .map(|code| Found { kind: "code", value: code.clone(), title: code, about: about.clone() })
        .collect()
}

fn glossary_terms(typed: &str, language: Language) -> Vec<Found> {
    let Ok(found) = glossary(Some(typed), language) else { return Vec::new() };
    let words =
        found.words.into_iter().map(|word| (own_and_foreign(&word.en, &word.de, language)[0].to_owned(), word.meaning));
    // A row that the tables name in words has no symbol.
    let terms = found.terms.into_iter().map(|term| {
        let (name, table) =
            (words::symbol_term(&term.symbol, language), capitalised(words::terminal::symbol(language)));
        row_sign(&term.symbol).map_or_else(|| (name.clone(), table), |sign| (sign, name.clone()))
    });
    let of = |(title, about): (String, String)| Found {
        kind: "term",
        value: title.clone(),
        title: capitalised(&title),
        about,
    };
    words.chain(terms).take(SHOWN).map(of).collect()
}

/// Returns the keyboard shortcuts of the page.
pub(crate) fn keyboard(call: &Call<'_>) -> Markup {
    let l = call.language();
    let rows = [
        ("1 2 3", page::key_panes(l)),
        ("/", page::find(l)),
        ("?", page::keyboard(l)),
        ("Ctrl+S", page::save(l)),
        ("Ctrl+P", page::print(l)),
        ("Ctrl+Z", page::undo(l)),
        ("Ctrl+Y", page::redo(l)),
        ("Esc", page::key_escape(l)),
        ("+ − 0", page::key_zoom(l)),
        ("← →", page::key_arrows(l)),
    ];
    html! {
        h2 { (page::keyboard(l)) }
        table { tbody { @for (key, about) in rows { tr { th scope="row" { kbd { (key) } } td { (about) } } } } }
        form method="dialog" { button type="submit" { (page::close(l)) } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sketch::symbol_of;

    /// Requires that a label and a title begin with a symbol as the manual writes it.
    #[test]
    fn symbols_keep_their_letter_in_labels_and_titles() {
        let mut seen = 0;
        for l in Language::ALL {
            walk(KEYS, "", &mut |path, key| {
                let about = about_text(key.about, l);
                let (head, label) = (about.split(", ").next().unwrap_or_default(), capitalised(&short_label(about)));
                let is_symbol = head.contains('_') || head.chars().count() == 1 || head.chars().any(char::is_numeric);
                if is_symbol && !head.contains(' ') && head.len() < about.len() {
                    assert!(label.starts_with(head), "{path}: {label}");
                    seen += 1;
                }
                if let Some(symbol) = symbol_of(path).filter(|_| is_symbol) {
                    assert!(!head.eq_ignore_ascii_case(symbol) || head == symbol, "{path}: {head} and {symbol}");
                }
            });
            for symbol in glossary(None, l).map_or_else(|_| Vec::new(), |found| found.terms) {
                let Some(sign) = row_sign(&symbol.symbol) else { continue };
                let is_word = sign.chars().all(char::is_alphabetic) && sign.chars().count() > 1;
                if !is_word {
                    assert_eq!(capitalised(&sign), sign);
                    assert!(capitalised(&format!("{sign}, x")).starts_with(&sign), "{sign}");
                    seen += 1;
                }
            }
        }
        assert!(seen > 100, "{seen}");
        assert_eq!(["t₁, time", "m", "T₁", "time"].map(capitalised), ["t₁, time", "m", "T₁", "Time"]);
    }
}
