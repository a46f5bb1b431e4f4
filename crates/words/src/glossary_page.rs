//! The reference page of the glossary, in Markdown: words and symbols in both languages, from the data of the glossary.

use crate::{pages, parameter_name, step_terms, symbol_shown, term_remark, word_meaning};
use installation::commission::ParameterId;
use quantities::Language;

/// Returns the page in a language; terms are listed in both.
#[must_use]
pub fn glossary_page(language: Language) -> String {
    let mut page = format!("# {}\n\n{}\n", pages::glossary_title(language), pages::glossary_about(language));
    page.push_str(&format!("\n## {}\n\n", pages::glossary_words(language)));
    page.push_str(&format!("{}\n|---|---|---|\n", pages::columns_of_words(language)));
    for word in catalogue::words() {
        row(&mut page, &[word.en, word.de, word_meaning(word, language)]);
    }
    page.push_str(&format!(
        "\n## {}\n\n{}\n\n",
        pages::glossary_terms(language),
        pages::glossary_terms_about(language)
    ));
    page.push_str(&format!("{}\n|---|---|---|---|---|---|\n", pages::columns_of_terms(language)));
    for term in catalogue::glossary() {
        let (symbol, name) = (format!("`{}`", term.symbol), format!("`{}`", term.identifier));
        row(&mut page, &[&symbol, &name, term.unit, term.en, term.de, term_remark(term, language)]);
    }
    page.push_str(&format!(
        "\n## {}\n\n{}\n\n",
        pages::glossary_steps(language),
        pages::glossary_steps_about(language)
    ));
    page.push_str(&format!("{}\n|---|---|---|\n", pages::columns_of_steps(language)));
    for (symbol, en, de) in glossary_symbols() {
        row(&mut page, &[&symbol_shown(symbol), en, de]);
    }
    page
}

/// Iterates over the symbols besides those of the tables with their meaning, English and German: those of the
/// derivations, then those of the values for a drive.
pub fn glossary_symbols() -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    let of_tables = |symbol: &str| catalogue::glossary().iter().any(|term| term.symbol == symbol);
    let listed = ParameterId::ALL.iter().filter(move |id| !of_tables(id.symbol()));
    let listed = listed.map(|id| (id.symbol(), parameter_name(*id, Language::En), parameter_name(*id, Language::De)));
    step_terms().chain(listed)
}

/// Returns the meaning of one of these symbols in a language.
#[must_use]
pub fn glossary_symbol(symbol: &str, language: Language) -> Option<&'static str> {
    let (_, en, de) = glossary_symbols().find(|(known, ..)| *known == symbol)?;
    Some(if language == Language::De { de } else { en })
}

fn row(page: &mut String, cells: &[&str]) {
    for cell in cells {
        page.push_str("| ");
        page.push_str(&cell.replace('|', "\\|"));
        page.push(' ');
    }
    page.push_str("|\n");
}
