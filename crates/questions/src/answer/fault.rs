//! Faults of an input as records.

use crate::codes::CodeRefusal;
use crate::sizing_use::Refusal;
use crate::sweep::{CellFault, TableFaults};
use answers::{Fault, Faults, Place};
use quantities::{Language, format_significant, seen};
use words::{Worded, check_missing, check_title, terminal};

/// Returns the faults of an input file.
#[must_use]
pub fn faults(file: &str, faults: &[Worded]) -> Faults {
    let fault = |fault: &Worded| Fault {
        id: Some(fault.id),
        file: Some(seen(file).into_owned()),
        place: Some(Place { line: fault.line, column: fault.column, span: [fault.span.start, fault.span.end] }),
        message: seen(&fault.message).into_owned(),
        hint: fault.hint.as_deref().map(|hint| seen(hint).into_owned()),
        ..Fault::default()
    };
    Faults::from(faults.iter().map(fault).collect::<Vec<_>>())
}

/// Returns the faults of a table; the last entry counts those not listed.
#[must_use]
pub fn table_faults(table: &str, found: &TableFaults, language: Language) -> Faults {
    let file = || Some(seen(table).into_owned()).filter(|name| !name.is_empty());
    let fault = |fault: &CellFault| Fault {
        id: Some(fault.id),
        file: file(),
        heading: Some(fault.heading.clone()).filter(|heading| !heading.is_empty()),
        row: fault.row,
        message: seen(&fault.message).into_owned(),
        hint: fault.hint.as_deref().map(|hint| seen(hint).into_owned()),
        ..Fault::default()
    };
    let mut errors: Vec<Fault> = found.listed.iter().map(fault).collect();
    if found.more > 0 {
        let more = project::Fault::More { count: found.more };
        let mut message = words::fault_text(&more, language);
        if found.is_enough() {
            message = words::sweeps::rest_unchecked(&message, language);
        }
        errors.push(Fault { id: Some(more.id()), file: file(), message, ..Fault::default() });
    }
    if found.is_unread {
        let message = words::sweeps::headings_refused(language).to_owned();
        errors.push(Fault { file: file(), message, ..Fault::default() });
    }
    Faults::from(errors)
}

/// Returns the fault of a file that cannot be read or written.
#[must_use]
pub fn file_fault(file: &str, what: &str) -> Faults {
    let fault = Fault { file: Some(seen(file).into_owned()), message: seen(what).into_owned(), ..Fault::default() };
    Faults::from(vec![fault])
}

/// Returns the fault of an option, with the remedy.
#[must_use]
pub fn option_fault(option: &str, (message, hint): (String, Option<String>)) -> Faults {
    let fault = Fault {
        option: Some(option.to_owned()),
        message: seen(&message).into_owned(),
        hint: hint.map(|hint| seen(&hint).into_owned()),
        ..Fault::default()
    };
    Faults::from(vec![fault])
}

/// Returns a fault in one sentence.
#[must_use]
pub fn fault(what: &str) -> Faults {
    Faults::of(seen(what))
}

/// Returns the reasons why a text is no code, each with its place.
#[must_use]
pub fn code_worded(text: &str, refusal: &CodeRefusal) -> Vec<Worded> {
    let worded = |fault: &crate::codes::CodeFault| {
        Worded::at(text, fault.span.clone(), fault.id(), fault.message.clone(), fault.hint.clone())
    };
    refusal.faults.iter().map(worded).collect()
}

/// Returns the reason why an actuator cannot be judged, in one sentence; `waited_s` is the time limit of the caller.
#[must_use]
pub fn refusal_text(refusal: &Refusal, waited_s: Option<f64>, language: Language) -> String {
    match refusal {
        Refusal::NotAsked(id) => terminal::check_not_asked(&check_title(*id, language), language),
        Refusal::NoActuator => terminal::no_own_actuator(language).to_owned(),
        Refusal::TooManySamples { asked, most } => terminal::too_many_samples(asked, most, language),
        Refusal::TooLong { samples, most, seconds } => terminal::too_long(samples, most, seconds, language),
        Refusal::TooManyAxes { axes, seconds } => terminal::too_many_axes(axes, seconds, language),
        Refusal::TooManyRatios { ratios, seconds } => terminal::too_many_ratios(ratios, seconds, language),
        Refusal::TooManyRows { rows, needed, most } => {
            let whole = |bytes: u64| bytes.div_ceil(1 << 20);
            terminal::too_many_rows(rows, &whole(*needed), &(most >> 20), language)
        }
        Refusal::Stopped => terminal::not_in_time(&format_significant(waited_s.unwrap_or(0.0), 3, language), language),
        Refusal::NoProduct { name, near } => {
            let near = near.as_ref().map_or_else(String::new, |near| format!("; {}", terminal::near(near, language)));
            format!("{}{near}", terminal::no_product(&seen(name), language))
        }
        Refusal::NotStated { name, symbol } => format!("{}: {}", seen(name), check_missing(symbol, language)),
        Refusal::NoData | Refusal::Broken(_) => terminal::no_data(language).to_owned(),
    }
}

/// Returns the fault of an unknown term: the requested term and similar ones.
#[must_use]
pub fn not_in_glossary(wanted: &str, nearest: &[String], language: Language) -> (String, Option<String>) {
    // A term has one or two words; a longer text is not repeated.
    let wanted: String = wanted.chars().filter(|sign| !sign.is_control()).take(60).collect();
    let hint = (!nearest.is_empty()).then(|| terminal::near(&nearest.join(", "), language));
    (terminal::nothing_in_the_glossary(&wanted, language), hint)
}
