//! `wiring`: connectors, pins and cables, and a list of pins compared with them.

use crate::answer::Answer;
use crate::code::{parse_for_use, read_argument};
use crate::fault::{option_fault, path_text, read_bytes_within, report, simple, unreadable};
use crate::laid_out::shown;
use crate::plot;
use crate::subject::refuse;
use crate::table::{Align, Table};
use clap::ArgMatches;
use std::fmt::Write as _;
use std::path::PathBuf;
use workbench::answers::WiringCheck;
use workbench::quantities::{Area, Length};
use workbench::text::{file_trouble, wiring};
use workbench::{LISTED_BYTES_MAX, Language, Role, answer, chapter};

/// `antrieb wiring CODE`
pub(crate) fn wiring(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let (reading, talk) = match parse_for_use(&read_argument(matches), as_json, language) {
        Ok(found) => found,
        Err(answer) => return answer,
    };
    let Some(found) = workbench::wiring(&reading.parsed.code) else {
        return refuse(&workbench::Refusal::NoData, as_json, language);
    };
    let cable = match cable(matches, as_json, language) {
        Ok(cable) => cable,
        Err(answer) => return answer,
    };
    let answer = match matches.get_one::<PathBuf>("check") {
        Some(_) if plot::is_asked(matches) => return simple(wiring::check_or_draw(language), as_json, language),
        Some(path) => check(&found, path, as_json, language),
        None if plot::is_asked(matches) => draw(&found, matches, as_json, language),
        None => {
            let record = answer::wiring(&found, cable, language);
            if as_json {
                Answer::record(&record)
            } else {
                Answer::data(shown(&chapter::wiring(&record, Vec::new(), language), language))
            }
        }
    };
    Answer { talk: talk + &answer.talk, ..answer }
}

/// Length and cross-section of a cable, where they are given.
fn cable(matches: &ArgMatches, as_json: bool, language: Language) -> Result<Option<(Length, Option<Area>)>, Answer> {
    let text = |option: &str| matches.get_one::<String>(option).map(String::as_str);
    let fault = |option: &'static str| move |fault| option_fault(option, fault, as_json, language);
    let Some(length) = text("length") else { return Ok(None) };
    let length = workbench::cable_length(length, language).map_err(fault("length"))?;
    let section = text("cross-section").map(|text| workbench::cross_section(text, language)).transpose();
    Ok(Some((length, section.map_err(fault("cross-section"))?)))
}

fn draw(wiring: &workbench::Wiring, matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let wanted = matches.get_one::<String>("connector").map_or(Role::Feedback.id(), String::as_str);
    let Some(connector) = wiring.connectors.iter().find(|connector| connector.role.id() == wanted) else {
        let roles: Vec<&str> = wiring.connectors.iter().map(|connector| connector.role.id()).collect();
        let what = wiring::no_such_connector(&wiring.code, &roles.join(", "), language);
        return option_fault("connector", (what, None), as_json, language);
    };
    if connector.pins.is_empty() {
        return simple(wiring::no_pins_to_draw(language), as_json, language);
    }
    if let Err(answer) = plot::destination(matches, &[], as_json, language) {
        return answer;
    }
    plot::put(&figures::mating_face(&wiring.code, connector, language), matches, &[], as_json, language)
}

fn check(wiring: &workbench::Wiring, path: &std::path::Path, as_json: bool, language: Language) -> Answer {
    let name = if path.as_os_str() == "-" { "stdin".to_owned() } else { path_text(path) };
    let bytes = match read_bytes_within(path, LISTED_BYTES_MAX) {
        Ok(bytes) if bytes.len() > LISTED_BYTES_MAX => {
            let what = wiring::pin_list_too_large(&LISTED_BYTES_MAX, language);
            return unreadable(&name, &what, as_json, language);
        }
        Ok(bytes) => bytes,
        Err(error) => return unreadable(&name, &file_trouble(&error, language), as_json, language),
    };
    let read = match workbench::read_list(wiring, &bytes) {
        Ok(read) => read,
        Err(error) => return unreadable(&name, &file_trouble(&error, language), as_json, language),
    };
    let Ok(comparison) = &read.outcome else {
        return report(&name, &read.text, &read.told(language), as_json, language);
    };
    let record = answer::wiring_check(wiring, comparison, language);
    let agrees = record.agrees;
    let answer = if as_json { Answer::record(&record) } else { Answer::data(check_text(&record, &name, language)) };
    answer.fits(agrees)
}

fn check_text(record: &WiringCheck, name: &str, language: Language) -> String {
    let mut out = format!("{}, {name}\n", record.code);
    let counted = if record.agreeing == record.rows {
        wiring::agrees(&record.rows, language)
    } else {
        wiring::differs(&record.agreeing, &record.rows, language)
    };
    let _ = writeln!(out, "{counted}");
    if record.findings.is_empty() {
        return out;
    }
    out.push('\n');
    let mut table = Table::new([
        (wiring::line(language), Align::Right),
        (wiring::severity(language), Align::Left),
        (wiring::connector(language), Align::Left),
        (wiring::pin(language), Align::Left),
        (wiring::finding(language), Align::Left),
    ]);
    for finding in &record.findings {
        table.row([
            finding.line.map_or_else(|| "–".into(), |line| line.to_string()),
            wiring::severity_word(*finding.severity, language).to_owned(),
            finding.connector.id().to_owned(),
            finding.pin.clone().unwrap_or_else(|| "–".into()),
            format!("{}; {}", finding.message, finding.action),
        ]);
    }
    out.push_str(&table.render());
    out
}
