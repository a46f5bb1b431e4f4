//! `commission`: what a drive is told about the motor of a code, check-lists, and the judgement of what was measured.

mod recorded;

use crate::answer::{Answer, written};
use crate::code::{parse_for_use, read_argument};
use crate::data::decimal;
use crate::facts::facts_text;
use crate::fault::{path_text, quantity, simple};
use crate::report::checklist;
use crate::save::{Unwritten, save};
use crate::subject::refuse;
use crate::table::{Align, Table, paragraph};
use clap::ArgMatches;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use workbench::answers::{
    CommissionAnswer, CommissionEntry, CommissionParameter, CommissionWritten, Commissioning, DriveObject,
    DriveParameter, EncoderValue, OverloadSupervision, SensorThreshold,
};
use workbench::quantities::{ThermodynamicTemperature, Unit, format_significant};
use workbench::text::{SaveTrouble, capitalised, commission, describe_uncovered, grade_word, signal_word, terms};
use workbench::{DriveForm, Language, Refusal, answer, uncovered, usual_ambient};

/// `antrieb commission CODE`
pub(crate) fn commission(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    answered(matches, as_json, language).unwrap_or_else(|answer| answer)
}

fn answered(matches: &ArgMatches, as_json: bool, language: Language) -> Result<Answer, Answer> {
    let (reading, talk) = parse_for_use(&read_argument(matches), as_json, language)?;
    let about =
        workbench::commission(&reading.parsed.code).ok_or_else(|| refuse(&Refusal::NoData, as_json, language))?;
    let path = |name: &str| matches.get_one::<PathBuf>(name);
    if let Some(record) = path("record") {
        if ["for", "out", "checklist", "blank"].iter().any(|name| matches.contains_id(name)) {
            return Err(simple(commission::record_alone(language), as_json, language));
        }
        let answer = recorded::record(&about, record, matches, as_json, language)?;
        return Ok(Answer { talk: format!("{talk}{}", answer.talk), ..answer });
    }
    let ambient: Option<ThermodynamicTemperature> = quantity(matches, "ambient", as_json, language)?;
    let ambient = ambient.unwrap_or_else(usual_ambient);
    let form = matches.get_one::<String>("for").and_then(|form| DriveForm::of_id(form));
    let sheet = |form| answer::commissioning(&about, form, ambient, language);
    let mut files: Vec<(PathBuf, Vec<u8>)> = Vec::new();
    if let Some(blank) = path("blank") {
        let name = blank.file_name().map_or_else(String::new, |name| path_text(Path::new(name)));
        files.push((blank.clone(), workbench::blank_record(&about, &name, language).into_bytes()));
    }
    if let Some(file) = path("checklist") {
        files.push((file.clone(), lists_as_pdf(file, &sheet(DriveForm::Plain), as_json, language)?));
    }
    if let (Some(out), Some(form)) = (path("out"), form) {
        let text = match form {
            DriveForm::Sinamics => workbench::sinamics_script(&about, language),
            DriveForm::Cia402 => workbench::eds(&about, language),
            DriveForm::Plain => written(&sheet(form)),
        };
        files.push((out.clone(), text.into_bytes()));
    }
    if !files.is_empty() {
        return write(&files, &about.code.to_string(), matches, as_json, language)
            .map(|answer| Answer { talk, ..answer });
    }
    let form = form.unwrap_or(DriveForm::Plain);
    let answer = match (as_json, form) {
        (true, DriveForm::Cia402) => {
            Answer::record(&CommissionAnswer::Objects(answer::drive_objects(&about, language)))
        }
        (true, _) => Answer::record(&CommissionAnswer::Sheet(Box::new(sheet(form)))),
        (false, _) => {
            let mut text = format!("{}\n", capitalised(&commission::title(&about.code, language)));
            for what in uncovered(&about.code) {
                text.push_str(&paragraph("", describe_uncovered(what, language)));
            }
            let objects = answer::drive_objects(&about, language);
            text.push_str(&sheet_text(&sheet(form), form, &objects, language));
            Answer::data(text)
        }
    };
    Ok(Answer { talk, ..answer })
}

/// Writes the files that were asked for, all or none.
fn write(
    files: &[(PathBuf, Vec<u8>)],
    code: &str,
    matches: &ArgMatches,
    as_json: bool,
    language: Language,
) -> Result<Answer, Answer> {
    let to_write: Vec<(&Path, &[u8])> = files.iter().map(|(path, bytes)| (path.as_path(), bytes.as_slice())).collect();
    save(&to_write, &[], matches.get_flag("force")).map_err(|fault| fault.answer(as_json, language))?;
    let told: Vec<CommissionWritten> = files
        .iter()
        .map(|(path, bytes)| CommissionWritten { file: path_text(path), code: code.to_owned(), bytes: bytes.len() })
        .collect();
    if as_json {
        return Ok(Answer::record(&told));
    }
    Ok(Answer::data(told.iter().map(|each| format!("{}: {}\n", each.file, each.code)).collect()))
}

fn lists_as_pdf(file: &Path, sheet: &Commissioning, as_json: bool, language: Language) -> Result<Vec<u8>, Answer> {
    if file.as_os_str() == "-" {
        let fault = Unwritten { path: file.to_owned(), trouble: SaveTrouble::NotToStdout };
        return Err(fault.answer(as_json, language));
    }
    if !file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("pdf")) {
        return Err(simple(&commission::checklist_is_a_pdf(&path_text(file), language), as_json, language));
    }
    checklist(sheet, as_json, language)
}

fn heading(out: &mut String, title: &str) {
    let _ = writeln!(out, "\n{}", capitalised(title));
}

fn sheet_text(sheet: &Commissioning, form: DriveForm, objects: &[DriveObject], language: Language) -> String {
    let mut out = String::new();
    heading(&mut out, commission::hazards(language));
    out.push_str(&facts_text(&sheet.hazards, language));
    match form {
        DriveForm::Sinamics => {
            heading(&mut out, commission::parameters(language));
            out.push_str(&sinamics_table(&sheet.sinamics, language));
        }
        DriveForm::Cia402 => {
            heading(&mut out, commission::objects(language));
            out.push_str(&object_table(objects, language));
        }
        DriveForm::Plain => {}
    }
    if form != DriveForm::Sinamics {
        heading(&mut out, commission::parameters(language));
        out.push_str(&parameter_table(&sheet.parameters, language));
    }
    heading(&mut out, commission::gaps(language));
    for gap in &sheet.gaps {
        out.push_str(&paragraph("- ", &gap.text));
    }
    heading(&mut out, commission::encoder(language));
    out.push_str(&encoder_table(&sheet.encoder, language));
    heading(&mut out, commission::commutation(language));
    for (number, step) in (1..).zip(&sheet.commutation) {
        out.push_str(&paragraph(&format!("{number}. "), step));
    }
    heading(&mut out, commission::thresholds(language));
    out.push_str(&threshold_table(&sheet.thresholds, language));
    if !sheet.thresholds.iter().any(|threshold| threshold.sensor == "ptc") {
        out.push_str(&paragraph("", commission::no_ptc(language)));
    }
    heading(&mut out, commission::overload(language));
    out.push_str(&overload_text(&sheet.overload, language));
    for list in &sheet.lists {
        heading(&mut out, &list.title);
        for entry in &list.entries {
            out.push_str(&entry_text(entry, language));
        }
    }
    out
}

/// As many digits as the value has, four at the least.
fn shown(value: f64, language: Language) -> String {
    let plain = value.to_string();
    let digits = plain.trim_start_matches(['0', '.', '-']).chars().filter(char::is_ascii_digit).count();
    if digits <= 4 { decimal(&plain.replace('.', ","), language) } else { format_significant(value, 5, language) }
}

fn unit_shown(unit: &str) -> String {
    if unit == "1" { String::new() } else { Unit::of(unit).map_or(unit, |unit| unit.symbol).to_owned() }
}

fn parameter_table(parameters: &[CommissionParameter], language: Language) -> String {
    let heads = [
        (commission::parameter(language), Align::Left),
        (terms::value(language), Align::Right),
        (terms::unit(language), Align::Left),
        (commission::conversion(language), Align::Left),
        (terms::grade(language), Align::Left),
        (terms::source(language), Align::Left),
    ];
    let mut table = Table::new(heads);
    for each in parameters {
        table.row([
            format!("{} {}", each.symbol, each.name),
            shown(each.value.0, language),
            unit_shown(each.unit),
            each.conversion_text.clone(),
            grade_word(*each.grade, language).to_owned(),
            each.source.clone(),
        ]);
    }
    table.render()
}

fn sinamics_table(parameters: &[DriveParameter], language: Language) -> String {
    let heads = [
        (terms::number(language), Align::Left),
        (terms::value(language), Align::Right),
        (terms::unit(language), Align::Left),
        (commission::parameter(language), Align::Left),
        (commission::conversion(language), Align::Left),
        (terms::source(language), Align::Left),
    ];
    let mut table = Table::new(heads);
    for each in parameters {
        table.row([
            each.number.clone(),
            shown(each.value.0, language),
            unit_shown(each.unit),
            each.name.clone(),
            each.conversion_text.clone(),
            format!("{} ({})", each.source, grade_word(*each.grade, language)),
        ]);
    }
    table.render()
}

fn object_table(objects: &[DriveObject], language: Language) -> String {
    let heads = [
        (commission::object(language), Align::Left),
        (commission::type_of_data(language), Align::Left),
        (terms::value(language), Align::Right),
        (terms::unit(language), Align::Left),
        (commission::rounding(language), Align::Right),
        (terms::source(language), Align::Left),
    ];
    let mut table = Table::new(heads);
    for each in objects {
        table.row([
            format!("{}:{} {}", each.index, each.sub, each.name),
            each.data_type.to_owned(),
            each.value.to_string(),
            each.unit.to_owned(),
            shown(each.exact.0, language),
            each.source.clone(),
        ]);
    }
    table.render()
}

fn encoder_table(values: &[EncoderValue], language: Language) -> String {
    let heads = [
        (commission::parameter(language), Align::Left),
        (terms::value(language), Align::Left),
        (terms::unit(language), Align::Left),
        (terms::remark(language), Align::Left),
    ];
    let mut table = Table::new(heads);
    for each in values {
        let side =
            if each.side == "output" { commission::side_output(language) } else { commission::side_motor(language) };
        let condition = if each.condition.is_empty() { String::new() } else { format!(" ({})", each.condition) };
        table.row([
            format!("{side}: {}{condition}", each.name),
            decimal(&each.text, language),
            unit_shown(each.unit),
            each.notes.join("; "),
        ]);
    }
    table.render()
}

fn threshold_table(thresholds: &[SensorThreshold], language: Language) -> String {
    let heads = [
        (commission::threshold(language), Align::Left),
        (commission::temperature(language), Align::Right),
        (commission::resistance(language), Align::Right),
        (terms::source(language), Align::Left),
    ];
    let mut table = Table::new(heads);
    for each in thresholds {
        let sign = match each.bound {
            "at_most" => "≤ ",
            "at_least" => "≥ ",
            _ => "",
        };
        table.row([
            format!("{} {}", each.sensor.to_uppercase(), each.name),
            format!("{} °C", shown(each.temperature.0, language)),
            format!("{sign}{} Ω", format_significant(each.resistance.0, 4, language)),
            format!("{} ({})", each.source, grade_word(*each.grade, language)),
        ]);
    }
    table.render()
}

fn overload_text(overload: &OverloadSupervision, language: Language) -> String {
    let mut out = String::new();
    let number = |value: f64| shown(format!("{value:.2e}").parse().unwrap_or(value), language);
    if let (Some(current), Some(constant)) = (overload.stall_current, overload.time_constant) {
        let line = commission::overload_line(&number(current.0), &number(constant.0), language);
        out.push_str(&paragraph("", &format!("{line} ({})", grade_word(*overload.grade, language))));
    }
    for trip in &overload.trips {
        out.push_str(&paragraph(
            "- ",
            &commission::overload_trip(&number(trip.factor.0), &number(trip.time.0), language),
        ));
    }
    out.push_str(&paragraph("", &overload.text));
    out
}

fn entry_text(entry: &CommissionEntry, language: Language) -> String {
    let signal = entry.signal.map_or_else(String::new, |signal| format!("{}: ", signal_word(*signal, language)));
    let unit = entry.unit.map_or_else(String::new, |unit| format!(" {}", unit_shown(unit)));
    let expected = match (entry.shown.is_empty(), entry.field) {
        (true, _) => String::new(),
        (false, true) => format!(": {} {}{}", commission::expected(language), entry.shown, unit.trim_end()),
        (false, false) => format!(": {}{}", entry.shown, unit.trim_end()),
    };
    let grade = grade_word(*entry.grade, language);
    let field = if entry.field { format!("  {} ________", commission::measured(language)) } else { String::new() };
    paragraph("[ ] ", &format!("{signal}{}{expected} ({grade}; {}){field}", entry.text, entry.source))
}
