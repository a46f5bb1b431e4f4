//! Errata as records.

use crate::errata::ErrataFound;
use answers::{CitedErratum, Errata, ErratumCell, ErratumKind, ErratumStatus};
use catalogue::Erratum;
use quantities::Language;
use words::evidence_text;

/// Returns the requested errata.
#[must_use]
pub fn errata(found: &ErrataFound, language: Language) -> Errata {
    Errata { about: found.about.clone(), errata: found.errata.iter().map(|each| erratum(each, language)).collect() }
}

/// Returns an erratum as cited by figures.
pub(crate) fn cited_erratum(id: &str, language: Language) -> CitedErratum {
    CitedErratum { id: id.to_owned(), evidence: evidence_text(id, language).to_owned() }
}

/// Returns the errata with these identifiers, each once, in the order of their first mention.
pub(crate) fn cited_once(ids: impl IntoIterator<Item = &'static str>, language: Language) -> Vec<CitedErratum> {
    let mut found: Vec<CitedErratum> = Vec::new();
    for id in ids {
        if found.iter().all(|known| known.id != id) {
            found.push(cited_erratum(id, language));
        }
    }
    found
}

/// Returns one erratum.
#[must_use]
pub fn erratum(erratum: &'static Erratum, language: Language) -> answers::Erratum {
    let cell = erratum.cell();
    let (recovered, [printed, corrected]) = words::erratum_readings(erratum, language);
    answers::Erratum {
        id: erratum.id,
        table: Some(erratum.table).filter(|table| !table.is_empty()),
        cell: cell.map(|cell| ErratumCell {
            symbol: cell.place.symbol,
            drive: cell.place.drive,
            feedback: cell.feedback,
            ratio: cell.place.ratio,
            condition: cell.place.condition,
        }),
        place: words::erratum_place(erratum, language),
        kind: match erratum.kind {
            catalogue::ErratumKind::Recovery => ErratumKind::Recovery,
            catalogue::ErratumKind::PrintError => ErratumKind::PrintError,
            catalogue::ErratumKind::Contradiction => ErratumKind::Contradiction,
            catalogue::ErratumKind::Rounding => ErratumKind::Rounding,
            catalogue::ErratumKind::Edition => ErratumKind::Edition,
        },
        status: if erratum.corrected_here { ErratumStatus::Corrected } else { ErratumStatus::Flagged },
        recovered,
        printed,
        corrected,
        checks_use: erratum.checks_use,
        unit: cell.map_or("", |cell| cell.unit),
        evidence: evidence_text(erratum.id, language),
    }
}
