//! `glossary` and `units`: terms and symbols with their meaning, units with their spellings.

use crate::answer::CommandAnswer;
use crate::call::Call;
use crate::command::checks::what_a_check_is;
use crate::table::{Align, TextTable, paragraph};
use answers::Number;
use questions::list::{Inquiry, Unanswered, glossary, units};
use words::{own_and_foreign, symbol_shown, terminal, terms, unpadded};

/// `antrieb glossary [TERM]`
pub(crate) fn glossary(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let found = glossary::found(inquiry)?;
    let both = |en: &str, de: &str| own_and_foreign(en, de, language).map(str::to_owned);
    let (word, foreign) = (terminal::word(language), terminal::other_language(language));
    let (meaning, symbol) = (terminal::meaning(language), terminal::sign(language));
    let mut parts = Vec::new();
    if !found.words.is_empty() {
        let mut table = TextTable::new([(word, Align::Left), (foreign, Align::Left), (meaning, Align::Left)]);
        for each in &found.words {
            let [own, foreign] = both(&each.en, &each.de);
            table.row([own, foreign, each.meaning.clone()]);
        }
        parts.push(table.render());
    }
    if !found.terms.is_empty() {
        let (name, unit) = (terminal::identifier(language), terms::unit(language));
        let mut table = TextTable::new([
            (symbol, Align::Left),
            (name, Align::Left),
            (unit, Align::Left),
            (meaning, Align::Left),
            (foreign, Align::Left),
        ]);
        for each in &found.terms {
            let [own, foreign] = both(&each.en, &each.de);
            table.row([each.symbol.clone(), each.identifier.clone(), each.unit.clone(), own, foreign]);
        }
        let remarks = found.terms.iter().filter(|each| !each.remark.is_empty());
        let remarks: String = remarks.map(|each| paragraph(&format!("{}: ", each.symbol), &each.remark)).collect();
        parts.push(table.render() + &remarks);
    }
    if !found.symbols.is_empty() {
        let head = terminal::in_derivations(language);
        let mut table = TextTable::new([(head, Align::Left), (meaning, Align::Left), (foreign, Align::Left)]);
        for each in &found.symbols {
            let shown = symbol_shown(&each.symbol);
            let name = if shown == each.symbol { shown } else { format!("{shown} ({})", each.symbol) };
            let [own, foreign] = both(&each.en, &each.de);
            table.row([name, own, foreign]);
        }
        parts.push(table.render());
    }
    for check in &found.checks {
        let [own, _] = own_and_foreign(&check.en, &check.de, language);
        let [meaning, _] = own_and_foreign(check.meaning_en, check.meaning_de, language);
        parts.push(what_a_check_is((own, &check.id, meaning), language));
    }
    Ok(CommandAnswer::data(parts.join("\n")))
}

/// `antrieb units [QUANTITY]`
pub(crate) fn units(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    // A conversion factor is exact: as many digits as its definition needs.
    let shown = |number: Number| unpadded(number.written().unwrap_or_default(), 12, language);
    let mut parts = Vec::new();
    for measured in units::found(inquiry)?.quantities {
        let heads = [measured.quantity.as_str(), terminal::also_written(language), terminal::in_si(language)];
        let mut table = TextTable::new(heads.map(|head| (head, Align::Left)));
        for unit in &measured.units {
            let spellings = [&unit.symbol, &unit.json].into_iter().chain(&unit.also).map(String::as_str);
            let mut also: Vec<&str> = spellings.filter(|spelling| *spelling != unit.unit).collect();
            also.dedup();
            let mut si = format!("{} {}", shown(unit.si), measured.si_unit);
            if unit.zero.written() != Some(0.0) {
                si.push_str(&format!(" + {} {}", shown(unit.zero), measured.si_unit));
            }
            table.row([unit.unit.clone(), also.join(", "), si]);
        }
        parts.push(table.render());
    }
    Ok(CommandAnswer::data(parts.join("\n")))
}
