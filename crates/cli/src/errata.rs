//! `errata`: errors and doubts in the manual, and the values that are used.

use crate::answer::CommandAnswer;
use crate::call::Call;
use crate::table::paragraph;
use answers::{Erratum, ErratumStatus};
use quantities::{Language, Unit, with_symbol};
use questions::list::{Inquiry, Unanswered, errata};
use std::fmt::Write as _;
use words::{decimal, erratum_kind, erratum_status, terminal};

/// `antrieb errata [CODE | TABLE | ID]`
pub(crate) fn errata(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let found = errata::found(inquiry)?;
    let record = questions::answer::errata(&found, language);
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
    } + "\n";
    Ok(CommandAnswer { talk, ..CommandAnswer::data(data) })
}

/// Appends place, stated value, used value and evidence of an erratum.
fn describe(out: &mut String, erratum: &Erratum, language: Language) {
    let unit = Unit::of(erratum.unit).map_or(erratum.unit, |unit| unit.symbol_in(language));
    let shown = |text: &str| {
        let text = if text.is_empty() || text == "-" { "–".to_owned() } else { decimal(text, language) };
        if text == "–" { text } else { with_symbol(&text, unit) }
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
