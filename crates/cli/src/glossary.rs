//! `glossary`: words and symbols with their meaning.

use crate::answer::Answer;
use crate::fault::error_word;
use crate::table::{Align, Table, paragraph};
use clap::ArgMatches;
use workbench::Language;
use workbench::answers::{Fault, Faults};
use workbench::text::symbol_shown;

/// `antrieb glossary [TERM]`
pub(crate) fn glossary(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let wanted = matches.get_one::<String>("term").map(String::as_str);
    let found = match workbench::glossary(wanted, language) {
        Ok(found) => found,
        Err(nearest) => return not_found(wanted.unwrap_or_default(), &nearest, as_json, language),
    };
    if as_json {
        return Answer::record(&found);
    }
    let chosen = |en: &str, de: &str| if language == Language::De { de.to_owned() } else { en.to_owned() };
    let other = |en: &str, de: &str| if language == Language::De { en.to_owned() } else { de.to_owned() };
    let heads: [&str; 4] = match language {
        Language::En => ["word", "German", "meaning", "symbol"],
        Language::De => ["Wort", "englisch", "Bedeutung", "Zeichen"],
    };
    let [word, foreign, meaning, symbol] = heads;
    let mut parts = Vec::new();
    if !found.words.is_empty() {
        let mut table = Table::new([(word, Align::Left), (foreign, Align::Left), (meaning, Align::Left)]);
        for each in &found.words {
            table.row([chosen(&each.en, &each.de), other(&each.en, &each.de), each.meaning.clone()]);
        }
        parts.push(table.render());
    }
    if !found.terms.is_empty() {
        let (name, unit) = match language {
            Language::En => ("name", "unit"),
            Language::De => ("Name", "Einheit"),
        };
        let mut table = Table::new([
            (symbol, Align::Left),
            (name, Align::Left),
            (unit, Align::Left),
            (meaning, Align::Left),
            (foreign, Align::Left),
        ]);
        for each in &found.terms {
            table.row([
                each.symbol.clone(),
                each.identifier.clone(),
                each.unit.clone(),
                chosen(&each.en, &each.de),
                other(&each.en, &each.de),
            ]);
        }
        let remarks = found.terms.iter().filter(|each| !each.remark.is_empty());
        let remarks: String = remarks.map(|each| paragraph(&format!("{}: ", each.symbol), &each.remark)).collect();
        parts.push(table.render() + &remarks);
    }
    if !found.symbols.is_empty() {
        let head = match language {
            Language::En => "in derivations",
            Language::De => "in Herleitungen",
        };
        let mut table = Table::new([(head, Align::Left), (meaning, Align::Left), (foreign, Align::Left)]);
        for each in &found.symbols {
            let shown = symbol_shown(&each.symbol);
            let name = if shown == each.symbol { shown } else { format!("{shown} ({})", each.symbol) };
            table.row([name, chosen(&each.en, &each.de), other(&each.en, &each.de)]);
        }
        parts.push(table.render());
    }
    Answer::data(parts.join("\n"))
}

fn not_found(wanted: &str, nearest: &[String], as_json: bool, language: Language) -> Answer {
    let wanted: String = wanted.chars().filter(|c| !c.is_control()).take(60).collect();
    let what = match language {
        Language::En => format!("the glossary has nothing about `{wanted}`"),
        Language::De => format!("das Glossar enthält nichts zu „{wanted}“"),
    };
    let hint = match (nearest, language) {
        ([], _) => None,
        (nearest, Language::En) => Some(format!("near: {}", nearest.join(", "))),
        (nearest, Language::De) => Some(format!("ähnlich: {}", nearest.join(", "))),
    };
    let shown = hint.as_ref().map_or_else(String::new, |hint| format!("  {hint}\n"));
    let talk = format!("{}: {what}\n{shown}", error_word(language));
    Answer::refused(talk, Faults { errors: vec![Fault { message: what, hint, ..Fault::default() }] }, as_json)
}
