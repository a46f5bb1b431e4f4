//! `errata`: what is wrong or in doubt in the print, and what is used.

use crate::answer::Answer;
use crate::code::refused;
use crate::fault::simple;
use crate::subject::refuse;
use crate::table::paragraph;
use clap::ArgMatches;
use std::fmt::Write as _;
use workbench::answers::{Erratum, ErratumStatus};
use workbench::quantities::Unit;
use workbench::text::{decimal, erratum_kind, erratum_status, terminal};
use workbench::{ErrataRefusal, Language, errata_about};

/// `antrieb errata [CODE | TABLE | ID]`
pub(crate) fn errata(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let words: Vec<&str> = matches.get_many::<String>("about").into_iter().flatten().map(String::as_str).collect();
    let text = words.join(" ");
    let found = match errata_about(Some(&text), language) {
        Ok(found) => found,
        Err(ErrataRefusal::Code(refusal)) => return refused(&text, &refusal, as_json, language),
        Err(ErrataRefusal::NoData) => return refuse(&workbench::Refusal::NoData, as_json, language),
        Err(ErrataRefusal::Unknown { message, hint }) => {
            let message = hint.map_or(message.clone(), |hint| format!("{message}; {hint}"));
            return simple(&message, as_json, language);
        }
    };
    let record = workbench::answer::errata(&found, language);
    if as_json {
        return Answer::record(&record);
    }
    let mut data = String::new();
    for (erratum, of) in record.errata.iter().zip(&found.errata) {
        if !data.is_empty() {
            data.push('\n');
        }
        let status = erratum_status(of.corrected_here, language);
        let _ = writeln!(data, "{}: {status}, {}", erratum.id, erratum_kind(of.kind, language));
        describe(&mut data, erratum, language);
    }
    let corrected = found.errata.iter().filter(|erratum| erratum.corrected_here).count();
    let (count, flagged) = (found.errata.len(), found.errata.len() - corrected);
    let talk = match count {
        0 => terminal::no_erratum(language).to_owned(),
        count => terminal::errata_counted(count, &corrected, &flagged, language),
    };
    let talk = talk
        + "
";
    Answer { talk, ..Answer::data(data) }
}

/// Where it stands, what is printed, what is used, and why.
fn describe(out: &mut String, erratum: &Erratum, language: Language) {
    let unit = Unit::of(erratum.unit).map_or(erratum.unit, |unit| unit.symbol);
    let shown = |text: &str| {
        let text = if text.is_empty() || text == "-" { "–".to_owned() } else { decimal(text, language) };
        if unit.is_empty() || text == "–" { text } else { format!("{text} {unit}") }
    };
    let mut line = |head: &str, text: &str| {
        out.push_str(&paragraph(&format!("  {head:<10} "), text));
    };
    line(terminal::where_it_stands(language), &erratum.place);
    if let Some(recovered) = erratum.recovered {
        line(terminal::recovered(language), &shown(recovered));
    }
    line(terminal::as_in_print(language), &shown(erratum.printed));
    let used = match (erratum.checks_use, erratum.status) {
        (Some(used), _) => terminal::used_by_checks(&shown(used), &shown(erratum.corrected), language),
        (None, ErratumStatus::Corrected) => shown(erratum.corrected),
        (None, ErratumStatus::Flagged) => {
            format!("{}, {}", shown(erratum.corrected), terminal::as_printed(language))
        }
    };
    line(terminal::used(language), &used);
    line(terminal::evidence(language), erratum.evidence);
}
