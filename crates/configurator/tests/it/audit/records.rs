//! Sources, terms and errata: nothing without use, nothing that points nowhere.

use super::tally::Tally;
use super::view::CellView;
use std::collections::BTreeSet;

/// Sources that no table names, each with the reason for keeping it. A source that comes into use leaves this list.
const SOURCES_WITHOUT_TABLE: [(&str, &str); 35] = [
    ("cha-manual-en-v03", "evidence of errata"),
    ("cha-manual-en-v01", "evidence of errata"),
    ("cha-page-57", "evidence of errata of table 57.1"),
    ("cha-page-59", "evidence of errata of table 59.1"),
    ("lynxdrive-manual", "a KTY table with an error, for comparison"),
    ("shg-series-manual", "evidence of erratum text-7.3.1-n_av"),
    ("fha-c-catalogue", "curves of a sister series, for comparison"),
    ("sha-cg-manual", "definition of the duty ranges"),
    ("bha-assembly-instructions", "8-pin motor connector with PTC; shielding"),
    ("hfus-2sh-manual", "running without a heat sink"),
    ("hma-manual", "40 K as the guide of the permissible rise, see the heat model"),
    ("kty-c-lib", "typical values of the sensor, the same as the data sheet's"),
    ("din-44081", "standard behind ptc-din44081"),
    ("din-44082", "standard behind ptc-din44081"),
    ("yaskawa-e-iii", "overload charts, for comparison"),
    ("fagor-fxm", "measuring current and polarity of the KTY"),
    ("sinamics-s150", "motor data list of a controller"),
    ("somanet-node", "phase values are half of line-to-line"),
    ("beckhoff-el72x1", "factor between peak and rms current"),
    ("beckhoff-ax8xxx", "motor data list of a controller"),
    ("br-mappmotion", "neutral field list of a synchronous motor"),
    ("sinamics-s120-functions", "parameter p0600 of `antrieb commission`"),
    ("sinamics-s120-list", "parameters p0300 and p0317 to p0319 of `antrieb commission`"),
    ("sinamics-s200", "parameters p0400 to p0423 of `antrieb commission`"),
    ("sinamics-g220", "parameter p0601 of `antrieb commission`"),
    ("sinamics-g120xa", "parameters p0604, p0605 and p0640 of `antrieb commission`"),
    ("sinamics-g115d", "ohms at which a drive takes a KTY for open or short-circuited"),
    ("sinamics-s-list", "procedure of the commutation offset in `antrieb commission`"),
    (
        "simodrive-611a",
        "tolerances of a servo motor's resistance and voltage constant, for `antrieb commission --record`",
    ),
    ("elmo-dsp402", "objects of `antrieb commission --for cia402`"),
    ("festo-cmmp", "objects of `antrieb commission --for cia402`"),
    ("infranor-xtrapuls", "objects of `antrieb commission --for cia402`"),
    ("synapticon-circulo", "object 0x607E of `antrieb commission --for cia402`"),
    ("novanta-emcl", "object 0x6075, for comparison"),
    ("cia-306", "layout of the EDS file of `antrieb commission --for cia402`"),
];

/// Terms that no table uses, each with its use.
const TERMS_WITHOUT_TABLE: [(&str, &str); 16] = [
    ("mounting_position", "datum that the check of the mounting position lacks"),
    ("i", "the ratio in formulas; tables have it as their column head"),
    ("T_rms", "result of the sizing, chapter 7.3"),
    ("n_av", "result of the sizing, chapter 7.3"),
    ("ED", "result of the sizing, chapter 7.3"),
    ("T_rated", GLOSSARY),
    ("n_rated", GLOSSARY),
    ("P_N", GLOSSARY),
    ("U_N", GLOSSARY),
    ("I_N", GLOSSARY),
    ("L_d", GLOSSARY),
    ("J_in", GLOSSARY),
    ("d_H_max", GLOSSARY),
    ("P_max", GLOSSARY),
    ("backlash", GLOSSARY),
    ("size", GLOSSARY),
];

/// Reason for terms that no table states.
const GLOSSARY: &str = "explained in chapter 11.1 of the manual, which every reader may look up";

/// Every source is named by a table or kept for a stated reason; every table names a source that exists
///
/// Source: the rules of `data/README.md`.
/// Tolerance: none.
pub(super) fn sources(_: &CellView, tally: &mut Tally) {
    let used: BTreeSet<&str> = catalogue::tables().iter().map(|table| table.source).collect();
    let kept: BTreeSet<&str> = SOURCES_WITHOUT_TABLE.iter().map(|(id, _)| *id).collect();
    each_once(tally, "source", catalogue::documents().iter().map(|document| document.id), &used, &kept);
}

/// Every term is used by a table or kept for a stated reason; every symbol of a table is a term
///
/// Source: the rules of `data/README.md`.
/// Tolerance: none.
pub(super) fn terms(_: &CellView, tally: &mut Tally) {
    let used: BTreeSet<&str> = catalogue::cells().map(|cell| cell.place.symbol).collect();
    let kept: BTreeSet<&str> = TERMS_WITHOUT_TABLE.iter().map(|(symbol, _)| *symbol).collect();
    each_once(tally, "term", catalogue::glossary().iter().map(|term| term.symbol), &used, &kept);
}

/// Compares a list of entries with those in use and those kept: each entry must be in exactly one of the two sets.
fn each_once(
    tally: &mut Tally,
    kind: &str,
    written: impl Iterator<Item = &'static str>,
    used: &BTreeSet<&str>,
    kept: &BTreeSet<&str>,
) {
    let written: BTreeSet<&str> = written.collect();
    for id in &written {
        let (is_used, is_kept) = (used.contains(id), kept.contains(id));
        tally.compare(is_used || is_kept, &[], || format!("no table uses {kind} `{id}` and no reason keeps it"));
        tally.compare(!(is_used && is_kept), &[], || format!("{kind} `{id}` is in use and needs no reason any more"));
    }
    for id in used.union(kept) {
        tally.compare(written.contains(id), &[], || format!("there is no {kind} `{id}`"));
    }
}

/// Every erratum stands in a table that exists, or is about the text; its identifier is its own
///
/// Source: the rules of `data/README.md`.
/// Tolerance: none.
pub(super) fn errata(_: &CellView, tally: &mut Tally) {
    let mut seen = BTreeSet::new();
    for erratum in catalogue::errata() {
        let table = erratum.table;
        tally.compare(table.is_empty() || catalogue::table(table).is_some(), &[], || {
            format!("erratum {} is about table {table}, which does not exist", erratum.id)
        });
        tally.compare(seen.insert(erratum.id), &[], || format!("erratum {} stands twice", erratum.id));
    }
    for cell in catalogue::cells() {
        for id in cell.errata {
            let belongs = catalogue::erratum(id).is_some_and(|erratum| erratum.table == cell.place.table);
            tally.compare(belongs, &[], || format!("erratum {id} at a cell of table {}", cell.place.table));
        }
    }
}

mod tests {
    use super::super::view::TextVersion;
    use super::*;

    fn findings(used: &[&str], kept: &[&str]) -> Vec<String> {
        let mut tally = Tally::new("records", TextVersion::Printed);
        each_once(
            &mut tally,
            "term",
            ["a", "b"].into_iter(),
            &used.iter().copied().collect(),
            &kept.iter().copied().collect(),
        );
        tally.findings()
    }

    #[test]
    fn an_unused_an_unknown_and_a_needlessly_kept_entry_are_found() {
        assert!(findings(&["a"], &["b"]).is_empty());
        assert_eq!(findings(&["a"], &[]).len(), 1);
        assert_eq!(findings(&["a", "b", "c"], &[]).len(), 1);
        assert_eq!(findings(&["a", "b"], &["b"]).len(), 1);
    }
}
