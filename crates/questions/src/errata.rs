//! Errata by subject: an actuator, a table, or their identifier.

use crate::codes::CodeRefusal;
use crate::codes::read_code;
use crate::sheet::sheet;
use catalogue::Erratum;
use order_code::Series;
use project::Hint;
use quantities::Language;

/// Subject of a request, and its errata.
#[derive(Clone, Debug)]
pub struct ErrataFound {
    /// The code in canonical spelling, the table, the id; `None`: all.
    pub about: Option<String>,
    /// The errata, in the order of the data.
    pub errata: Vec<&'static Erratum>,
}

/// Reasons why errata cannot be looked up.
#[derive(Clone, Debug)]
pub enum ErrataRefusal {
    /// The text is a code that does not exist.
    Code(CodeRefusal),
    /// The manual prints no data for the code.
    NoData,
    /// The text is unknown: the fault, and the nearest name.
    Unknown {
        /// The fault in one sentence.
        message: String,
        /// The nearest id or table.
        hint: Option<String>,
    },
}

/// Returns the errata of a code, of a table or with an identifier; all errata without a text.
///
/// The errata of a code are those of the cells of its data sheet and of its tables.
///
/// # Errors
/// If the text is no code with data, no table and no identifier.
pub fn errata_about(text: Option<&str>, language: Language) -> Result<ErrataFound, ErrataRefusal> {
    let all = catalogue::errata();
    let Some(text) = text.map(str::trim).filter(|text| !text.is_empty()) else {
        return Ok(ErrataFound { about: None, errata: all.iter().collect() });
    };
    if let Some(erratum) = all.iter().find(|erratum| erratum.id.eq_ignore_ascii_case(text)) {
        return Ok(ErrataFound { about: Some(erratum.id.to_owned()), errata: vec![erratum] });
    }
    if let Some(table) = catalogue::tables().iter().find(|table| table.id.eq_ignore_ascii_case(text)) {
        let errata = all.iter().filter(|erratum| erratum.table == table.id).collect();
        return Ok(ErrataFound { about: Some(table.id.to_owned()), errata });
    }
    match read_code(text, language) {
        Ok(reading) => {
            let code = reading.parsed.code;
            let sheet = sheet(&code).ok_or(ErrataRefusal::NoData)?;
            let rows = || sheet.sections.iter().flat_map(|section| &section.rows);
            let concerns = |erratum: &&Erratum| match erratum.cell() {
                Some(_) => rows().any(|row| row.cell.errata.contains(&erratum.id)),
                None => {
                    erratum.concerns(&code) && sheet.sections.iter().any(|section| section.table.id == erratum.table)
                }
            };
            Ok(ErrataFound { about: Some(code.to_string()), errata: all.iter().filter(concerns).collect() })
        }
        Err(refusal) if Series::beginning(text).is_some() => Err(ErrataRefusal::Code(refusal)),
        Err(_) => Err(unknown(text, language)),
    }
}

fn unknown(text: &str, language: Language) -> ErrataRefusal {
    let lower = text.to_lowercase();
    let names = catalogue::errata().iter().map(|erratum| erratum.id);
    let names = names.chain(catalogue::tables().iter().map(|table| table.id));
    // Among equally near names, the one with the longest common beginning is taken.
    let alike = |name: &str| lower.bytes().zip(name.to_lowercase().bytes()).take_while(|(a, b)| a == b).count();
    let distance = |name: &str| strsim::damerau_levenshtein(&lower, &name.to_lowercase());
    let scored = names.map(|name| (distance(name), std::cmp::Reverse(alike(name)), name));
    let near = scored.min().filter(|(distance, ..)| *distance * 2 <= text.chars().count()).map(|(_, _, name)| name);
    ErrataRefusal::Unknown {
        message: words::records::no_such_erratum(&text, language),
        hint: near.map(|near| words::hint_text(&Hint::DidYouMean(near.to_owned()), language)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ids(text: &str) -> Vec<&'static str> {
        errata_about(Some(text), Language::En).unwrap().errata.iter().map(|erratum| erratum.id).collect()
    }

    #[test]
    fn every_erratum_is_found_by_its_id_and_its_table() {
        assert_eq!(errata_about(None, Language::En).unwrap().errata.len(), catalogue::errata().len());
        for erratum in catalogue::errata() {
            assert_eq!(ids(erratum.id), [erratum.id]);
            assert!(erratum.table.is_empty() || ids(erratum.table).contains(&erratum.id), "{}", erratum.id);
        }
    }

    #[test]
    fn the_errata_of_a_code_are_those_of_its_sheet() {
        let found = ids("CHA-25A-50-H-M512P");
        assert!(found.contains(&"25A-M512P-J_out-50") && found.contains(&"T77.1-fit-name"), "{found:?}");
        assert!(!found.contains(&"25A-M512P-m_brake"), "of the other brake variant: {found:?}");
    }

    #[test]
    fn what_is_not_known_has_a_hint() {
        let Err(ErrataRefusal::Unknown { hint, .. }) = errata_about(Some("77.2"), Language::En) else {
            panic!("77.2 is no table");
        };
        assert_eq!(hint.unwrap(), "did you mean `77.1`?");
        assert!(matches!(errata_about(Some("CHA-40A-30-H-C1024"), Language::De), Err(ErrataRefusal::Code(_))));
        assert!(matches!(errata_about(Some("CHA-40A-50-H-RES"), Language::De), Err(ErrataRefusal::NoData)));
    }
}
