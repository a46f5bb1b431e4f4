//! Look-up of words and symbols of the field and of the product.

use answers::{Glossary, GlossaryCheck, GlossarySymbol, GlossaryTerm, GlossaryWord};
use quantities::Language;
use sizing::CheckId;
use words::{check_meaning, check_titles, glossary_symbols, symbol_shown, term_remark, word_meaning};

/// Returns the glossary, or its entries for a symbol, an identifier or a word.
///
/// The first of these comparisons with a result decides: the exact name, the name without regard to capitals, without
/// regard to the spelling of a symbol (`tau_e`, `τ_e`, `τe`), a whole word of a name, several words of one name, a part of a
/// text. A word without a term of its own comes with the terms of the tables whose names contain it; the title of a check
/// also names that check.
///
/// # Errors
/// The nearest names if nothing is found.
pub fn glossary(wanted: Option<&str>, language: Language) -> Result<Glossary, Vec<String>> {
    let all = whole(language);
    let Some(wanted) = wanted.map(str::trim).filter(|wanted| !wanted.is_empty()) else { return Ok(all) };
    let small = wanted.to_lowercase();
    // "CE" is a word of "CE marking", and a part of many others.
    let is_word =
        |name: &str| name.to_lowercase().split(|sign: char| !sign.is_alphanumeric()).any(|word| word == small);
    let by_word = || chosen(&all, &|names, _| names.iter().any(|name| is_word(name)));
    let with_terms = |found: Glossary| {
        if found.words.is_empty() || !found.terms.is_empty() {
            return found;
        }
        Glossary { terms: by_word().terms, ..found }
    };
    let spelled = folded(wanted);
    // A title that is also the name of a symbol or of a word comes with it.
    let with_checks = |found: Glossary| Glossary { checks: checks_titled(&spelled), ..found };
    let exact = chosen(&all, &|names, _| names.contains(&wanted));
    if !exact.is_empty() {
        return Ok(with_checks(with_terms(exact)));
    }
    let by_name = chosen(&all, &|names, _| names.iter().any(|name| name.to_lowercase() == small));
    if !by_name.is_empty() {
        return Ok(with_checks(with_terms(by_name)));
    }
    let by_spelling = chosen(&all, &|names, _| names.iter().any(|name| folded(name) == spelled));
    if !by_spelling.is_empty() {
        return Ok(with_checks(by_spelling));
    }
    let by_word = by_word();
    if !by_word.is_empty() {
        return Ok(with_checks(by_word));
    }
    let by_words = with_checks(chosen(&all, &|names, _| names.iter().any(|name| has_words(name, &small))));
    if !by_words.is_empty() {
        return Ok(by_words);
    }
    let found = chosen(&all, &|_, texts| texts.iter().any(|text| text.to_lowercase().contains(&small)));
    if found.is_empty() { Err(nearest(&all, wanted)) } else { Ok(found) }
}

/// Returns `true` if every one of several words is a word of a name.
fn has_words(name: &str, wanted: &str) -> bool {
    let words = |text: &str| -> Vec<String> {
        text.to_lowercase().split(|sign: char| !sign.is_alphanumeric()).map(str::to_owned).collect()
    };
    let of_name = words(name);
    words(wanted).iter().all(|word| of_name.contains(word))
}

/// Returns the checks whose identifier, or title in one of the languages, has a spelling.
fn checks_titled(spelled: &str) -> Vec<GlossaryCheck> {
    let check = |id: &CheckId| {
        let [en, de] = check_titles(*id);
        let [meaning_en, meaning_de] = Language::ALL.map(|language| check_meaning(*id, language));
        GlossaryCheck { id: id.id().to_owned(), en, de, meaning_en, meaning_de }
    };
    let is_named = |check: &GlossaryCheck| [&check.id, &check.en, &check.de].iter().any(|name| folded(name) == spelled);
    CheckId::ALL.iter().map(check).filter(is_named).collect()
}

/// Returns the meaning of a symbol, with its unit and remark; `None` for a symbol outside the glossary.
#[must_use]
pub fn meaning_of_symbol(symbol: &str, language: Language) -> Option<String> {
    if let Some(term) = catalogue::term(symbol) {
        let name = words::symbol_term(symbol, language);
        let unit = if term.unit.is_empty() { String::new() } else { format!(" [{}]", shown_unit(term.unit)) };
        let remark = term_remark(term, language);
        return Some(if remark.is_empty() { format!("{name}{unit}") } else { format!("{name}{unit}: {remark}") });
    }
    words::glossary_symbol(symbol, language).map(str::to_owned)
}

fn shown_unit(unit: &'static str) -> &'static str {
    quantities::Unit::of(unit).map_or(unit, |unit| unit.symbol)
}

/// Returns the meaning of a word in either language; `None` for a word outside the glossary.
#[must_use]
pub fn meaning_of_word(word: &str, language: Language) -> Option<&'static str> {
    let small = word.to_lowercase();
    let found =
        catalogue::words().iter().find(|known| [known.en, known.de].iter().any(|each| each.to_lowercase() == small));
    found.map(|found| word_meaning(found, language))
}

fn whole(language: Language) -> Glossary {
    Glossary {
        words: catalogue::words()
            .iter()
            .map(|word| GlossaryWord {
                id: word.id.to_owned(),
                en: word.en.to_owned(),
                de: word.de.to_owned(),
                meaning: word_meaning(word, language).to_owned(),
            })
            .collect(),
        terms: catalogue::glossary()
            .iter()
            .map(|term| GlossaryTerm {
                symbol: term.symbol.to_owned(),
                identifier: term.identifier.to_owned(),
                unit: term.unit.to_owned(),
                en: term.en.to_owned(),
                de: term.de.to_owned(),
                remark: term_remark(term, language).to_owned(),
            })
            .collect(),
        symbols: glossary_symbols()
            .map(|(symbol, en, de)| GlossarySymbol {
                symbol: symbol.to_owned(),
                shown: symbol_shown(symbol),
                en: en.to_owned(),
                de: de.to_owned(),
            })
            .collect(),
        checks: Vec::new(),
    }
}

/// Returns the entries selected by names (symbol, identifier, word) and by texts.
fn chosen(all: &Glossary, keeps: &dyn Fn(&[&str], &[&str]) -> bool) -> Glossary {
    let mut found = all.clone();
    found.words.retain(|word| keeps(&[&word.id, &word.en, &word.de], &[&word.en, &word.de]));
    found.terms.retain(|term| {
        keeps(&[&term.symbol, &term.identifier, &term.en, &term.de], &[&term.en, &term.de, &term.remark])
    });
    found
        .symbols
        .retain(|symbol| keeps(&[&symbol.symbol, &symbol.shown, &symbol.en, &symbol.de], &[&symbol.en, &symbol.de]));
    found
}

/// Greek letters of symbols, with their names in ASCII symbols.
const GREEK: [(char, &str); 18] = [
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('Δ', "d"),
    ('δ', "delta"),
    ('η', "eta"),
    ('θ', "theta"),
    ('ϑ', "theta"),
    ('κ', "kappa"),
    ('µ', "mu"),
    ('μ', "mu"),
    ('ρ', "rho"),
    ('σ', "sigma"),
    ('τ', "tau"),
    ('φ', "phi"),
    ('ψ', "psi"),
    ('ω', "omega"),
    ('Ω', "omega"),
];

/// Returns a name without regard to capitals, `_`, `-`, points and spaces, and with Greek letters by name.
fn folded(name: &str) -> String {
    let mut folded = String::with_capacity(name.len());
    for sign in name.chars() {
        match GREEK.iter().find(|(letter, _)| *letter == sign) {
            Some((_, name)) => folded.push_str(name),
            None if sign.is_alphanumeric() => folded.extend(sign.to_lowercase()),
            None => {}
        }
    }
    folded
}

/// Number of nearest names proposed.
const NEAREST: usize = 3;

fn nearest(all: &Glossary, wanted: &str) -> Vec<String> {
    let names = all.words.iter().flat_map(|word| [&word.en, &word.de]);
    let names = names.chain(all.terms.iter().flat_map(|term| [&term.symbol, &term.identifier, &term.en, &term.de]));
    let titles: Vec<String> = CheckId::ALL.iter().flat_map(|id| check_titles(*id)).collect();
    let mut rated: Vec<(f64, &String)> = names
        .chain(&titles)
        .chain(all.symbols.iter().map(|symbol| &symbol.symbol))
        .map(|name| (strsim::jaro_winkler(&name.to_lowercase(), &wanted.to_lowercase()), name))
        .filter(|(likeness, _)| *likeness > 0.75)
        .collect();
    rated.sort_by(|a, b| b.0.total_cmp(&a.0).then_with(|| a.1.cmp(b.1)));
    rated.dedup_by(|a, b| a.1 == b.1);
    rated.into_iter().take(NEAREST).map(|(_, name)| name.clone()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_symbol_an_identifier_and_a_word_are_found() {
        let found = glossary(Some("T_max"), Language::De).unwrap();
        assert_eq!(found.terms.len(), 1);
        assert_eq!(found.terms[0].de, "maximales Drehmoment");
        assert_eq!(glossary(Some("torque_max"), Language::De).unwrap().terms, found.terms);
        assert_eq!(glossary(Some("nachweis"), Language::En).unwrap().words[0].en, "check");
        let losses = glossary(Some("P_0"), Language::En).unwrap();
        assert_eq!(losses.symbols.len(), 2, "{losses:?}");
        assert!(glossary(Some("demagnetisation"), Language::En).unwrap().terms.len() == 1);
    }

    /// The title of every check, in every language, leads to that check, and to no symbol that only mentions it.
    #[test]
    fn every_check_is_found_by_its_title() {
        for id in CheckId::ALL {
            for name in check_titles(*id).into_iter().chain([id.id().to_owned()]) {
                let found = glossary(Some(&name), Language::En).unwrap();
                assert!(found.checks.iter().any(|check| check.id == id.id()), "{name}: {found:?}");
            }
        }
        let symbols = |found: Glossary| found.terms.into_iter().map(|term| term.symbol).collect::<Vec<_>>();
        assert_eq!(symbols(glossary(Some("mean speed"), Language::En).unwrap()), ["n_av"]);
        assert!(glossary(Some("peak speed"), Language::En).unwrap().symbols.iter().any(|each| each.symbol == "n_peak"));
    }

    #[test]
    fn a_symbol_and_a_word_tell_what_they_mean() {
        let torque = meaning_of_symbol("T_max", Language::De).unwrap();
        assert!(torque.starts_with("maximales Drehmoment [Nm]"), "{torque}");
        assert!(meaning_of_symbol("T_rms", Language::En).is_some() && meaning_of_symbol("x_y", Language::En).is_none());
        assert_eq!(meaning_of_word("Nachweis", Language::En), meaning_of_word("check", Language::En));
        assert!(meaning_of_word("check", Language::En).is_some());
    }

    #[test]
    fn every_usual_spelling_is_found() {
        for (spellings, symbol) in [
            (["tau_e", "τ_e", "τe", "TAU_E", "taue"], "tau_e"),
            (["k_Tout", "kTout", "k_tout", "k-Tout", "K_TOUT"], "k_Tout"),
            (["F_R_dyn_max", "FRdynmax", "F_R dyn max", "f_r_dyn_max", "F_R dyn (max)"], "F_R_dyn_max"),
        ] {
            for spelling in spellings {
                let found = glossary(Some(spelling), Language::De).unwrap();
                assert!(found.terms.iter().any(|term| term.symbol == symbol), "{spelling}: {found:?}");
                assert!(found.terms.len() <= 2, "{spelling}: {found:?}");
            }
        }
        for (spellings, id) in [
            (["CE", "ce", "CE-Kennzeichnung"], "ce_marking"),
            (["REACH", "reach", "REACH-Verordnung"], "reach"),
            (["RoHS", "rohs", "ROHS"], "rohs"),
        ] {
            for spelling in spellings {
                let found = glossary(Some(spelling), Language::En).unwrap();
                let ids: Vec<&str> = found.words.iter().map(|word| word.id.as_str()).collect();
                assert_eq!((ids, found.terms.len()), (vec![id], 0), "{spelling}");
            }
        }
        // Every symbol is found in the spelling that is shown.
        for symbol in glossary(None, Language::En).unwrap().symbols {
            let found = glossary(Some(&symbol.shown), Language::En).unwrap();
            assert!(found.symbols.iter().any(|each| each.symbol == symbol.symbol), "{}", symbol.shown);
        }
    }

    #[test]
    fn what_is_not_there_has_its_nearest() {
        let nearest = glossary(Some("torque_maxx"), Language::En).unwrap_err();
        assert!(nearest.contains(&"torque_max".to_owned()), "{nearest:?}");
        assert!(glossary(Some("vvyvvyvv"), Language::En).unwrap_err().is_empty());
    }

    #[test]
    fn the_whole_glossary_has_every_word_once() {
        let all = glossary(None, Language::De).unwrap();
        assert!(all.words.len() > 20 && all.terms.len() > 150 && all.symbols.len() > 150);
        let mut words: Vec<&String> = all.words.iter().map(|word| &word.de).collect();
        words.sort();
        let count = words.len();
        words.dedup();
        assert_eq!(words.len(), count);
    }
}
