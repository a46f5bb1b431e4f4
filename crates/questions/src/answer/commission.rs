//! The commissioning of a code as records.

use super::errata::cited_once;
use super::facts::facts;
use super::sheet::cell_value;
use crate::commission::DriveForm;
use answers::{
    CommissionEntry, CommissionGap, CommissionList, CommissionParameter, DriveObject, DriveParameter, EncoderValue, Id,
    Number, OverloadSupervision, OverloadTrip, SensorThreshold,
};
use catalogue::{Cell, Topic};
use installation::commission::checklist::{self, CheckList, ChecklistItem, Condition};
use installation::commission::cia402::{self, Object};
use installation::commission::encoder::{EncoderRow, EncoderSide};
use installation::commission::expected::ExpectedValue;
use installation::commission::sinamics::{self, Setting};
use installation::commission::{Commissioning, Conversion, ParameterId, ParameterToSet, clean, sensors};
use installation::facts::{Order, facts_about};
use order_code::FeedbackKind;
use provenance::{Grade, Source};
use quantities::unit::{DEGREE_CELSIUS, MINUTE, REVOLUTION_PER_MINUTE, SECOND};
use quantities::{Language, Measure, ThermodynamicTemperature, Unit, format_significant, with_symbol};
use words::{
    cell_text, choice_text, commission, condition_text, conversion_text, document_short, fact_source, fact_text,
    gap_text, marked, measurand_name, object_name, parameter_name, source_text, symbol_term, table_note, unpadded,
};

/// Returns the commissioning sheet of a code.
#[must_use]
pub fn commissioning(
    about: &Commissioning,
    form: DriveForm,
    ambient: ThermodynamicTemperature,
    language: Language,
) -> answers::Commissioning {
    let listed = |fact: &&'static catalogue::Fact| fact.step.is_none_or(|step| !checklist::STEPS.contains(&step));
    let hazards: Vec<_> =
        facts_about(Topic::Commission, &about.code, Order::Gravest).into_iter().filter(listed).collect();
    let mut sheet = answers::Commissioning {
        code: about.code.to_string(),
        form: form.id(),
        hazards: facts(&hazards, language),
        parameters: about.parameters.iter().map(|each| parameter(each, language)).collect(),
        gaps: about.gaps.iter().map(|gap| CommissionGap { id: gap.id(), text: gap_text(*gap, language) }).collect(),
        sinamics: if form == DriveForm::Sinamics { drive_parameters(about, language) } else { Vec::new() },
        encoder: about.encoder.iter().map(|row| encoder(row, language)).collect(),
        commutation: commutation(about, form, language),
        thresholds: thresholds(about, language),
        overload: overload(about, language),
        lists: checklist::lists(about, ambient).iter().map(|each| list(each, language)).collect(),
        errata: Vec::new(),
    };
    sheet.errata = cited_once(shown_errata(&sheet), language);
    sheet
}

/// Returns the errata of all values of a sheet.
fn shown_errata(sheet: &answers::Commissioning) -> Vec<&'static str> {
    let values = sheet.parameters.iter().flat_map(|each| &each.errata);
    let encoder = sheet.encoder.iter().flat_map(|each| &each.errata);
    let thresholds = sheet.thresholds.iter().flat_map(|each| &each.errata);
    let lists = sheet.lists.iter().flat_map(|list| &list.entries).flat_map(|entry| &entry.errata);
    values.chain(encoder).chain(thresholds).chain(&sheet.overload.errata).chain(lists).copied().collect()
}

fn joined(sources: &[Source], document: Option<&str>, language: Language) -> String {
    let mut sentences: Vec<String> = Vec::new();
    let texts = sources.iter().map(|source| source_text(source, language)).chain(document.map(str::to_owned));
    for text in texts {
        if !sentences.contains(&text) {
            sentences.push(text);
        }
    }
    sentences.join("; ")
}

fn parameter(parameter: &ParameterToSet, language: Language) -> CommissionParameter {
    let conversion = parameter.id.conversion();
    CommissionParameter {
        id: parameter.id.id(),
        symbol: parameter.id.symbol(),
        name: parameter_name(parameter.id, language).to_owned(),
        value: Number(parameter.value()),
        unit: parameter.id.unit().json,
        conversion: conversion.id(),
        conversion_text: conversion_of(parameter, language),
        grade: Id(parameter.grade),
        source: joined(&parameter.sources, None, language),
        errata: parameter.errata.clone(),
    }
}

/// Returns the conversion from the value of the manual: for a corrected value also what the manual states, and for the
/// smaller of two values the one that is not known.
fn conversion_of(parameter: &ParameterToSet, language: Language) -> String {
    let conversion = parameter.id.conversion();
    let is_source = |cell: &&'static Cell| parameter.sources.contains(&Source::Cell(&cell.place));
    let mut cells =
        parameter.errata.iter().filter_map(|id| catalogue::erratum(id)?.cell()).filter(|cell| is_source(cell));
    match conversion {
        Conversion::AsPrinted => match cells.find(|cell| cell.checks_use.is_some() || cell.printed != cell.corrected) {
            Some(cell) => commission::corrected_from(&printed_text(cell, language), language),
            None => conversion_text(conversion, language).to_owned(),
        },
        Conversion::Smaller if parameter.sources.len() == 1 => {
            commission::limit_without_demagnetisation(language).to_owned()
        }
        _ => conversion_text(conversion, language).to_owned(),
    }
}

/// Returns the text of the manual in a cell, a number in the notation of the language with its unit.
fn printed_text(cell: &Cell, language: Language) -> String {
    let Ok(number) = cell.printed.replace(',', ".").parse::<f64>() else { return cell.printed.to_owned() };
    with_symbol(&unpadded(number, 6, language), cell.unit)
}

fn drive_parameters(about: &Commissioning, language: Language) -> Vec<DriveParameter> {
    let record = |line: &sinamics::ParameterLine| {
        let number = line.entry.name();
        let document = Some(document_short(line.entry.document, language));
        match line.entry.setting {
            Setting::Choice(choice) => DriveParameter {
                number,
                value: Number(line.value),
                unit: "1",
                name: choice_text(choice, language).to_owned(),
                conversion_text: String::new(),
                grade: Id(Grade::Published),
                source: joined(&[], document, language),
                errata: Vec::new(),
            },
            Setting::Value(id, unit) => {
                let known = about.get(id);
                DriveParameter {
                    number,
                    value: Number(line.value),
                    unit: unit.json,
                    name: parameter_name(id, language).to_owned(),
                    conversion_text: known.map_or_else(String::new, |known| conversion_of(known, language)),
                    grade: Id(known.map_or(Grade::Assumed, |known| known.grade)),
                    source: joined(known.map_or(&[], |known| known.sources.as_slice()), document, language),
                    errata: known.map_or_else(Vec::new, |known| known.errata.clone()),
                }
            }
        }
    };
    sinamics::lines(about).iter().map(record).collect()
}

/// Returns the sources of an object: those of its figures, then the facts, then the document that names the object.
fn object_source(sources: &[Source], object: &Object, language: Language) -> String {
    let prose = object.facts.iter().map(|fact| fact_source(fact, language));
    let mut sentences = prose.collect::<Vec<_>>();
    sentences.dedup();
    let document = sentences
        .into_iter()
        .chain([document_short(object.document, language).to_owned()])
        .collect::<Vec<_>>()
        .join("; ");
    joined(sources, Some(&document), language)
}

/// Returns the objects of CiA 402.
#[must_use]
pub fn drive_objects(about: &Commissioning, language: Language) -> Vec<DriveObject> {
    let record = |object: &Object| {
        let sources: Vec<Source> = object.from.iter().flat_map(|each| each.sources.clone()).collect();
        let grade = object.from.iter().fold(Grade::Computed, |grade, each| grade.worst(each.grade));
        DriveObject {
            index: format!("0x{:04X}", object.index),
            sub: object.sub,
            data_type: object.data_type.id(),
            value: object.value,
            unit: object.unit,
            name: object_name(object.id, language),
            exact: Number(object.exact),
            rounding: object.rounding.id(),
            grade: Id(grade),
            source: object_source(&sources, object, language),
            errata: object.errata(),
        }
    };
    cia402::objects(about).iter().map(record).collect()
}

fn encoder(row: &EncoderRow, language: Language) -> EncoderValue {
    let cell = row.cell;
    EncoderValue {
        side: match row.side {
            EncoderSide::Motor => "motor",
            EncoderSide::Output => "output",
        },
        symbol: cell.place.symbol,
        name: symbol_term(cell.place.symbol, language),
        condition: condition_text(cell.place.condition, language),
        value: cell_value(cell),
        text: cell_text(cell, language).to_owned(),
        unit: cell.unit,
        table: cell.place.table,
        notes: row.notes.iter().map(|note| table_note(note, language).to_owned()).collect(),
        errata: cell.errata.to_vec(),
    }
}

fn commutation(about: &Commissioning, form: DriveForm, language: Language) -> Vec<String> {
    let Some(kind) = about.feedback_kind() else { return Vec::new() };
    let own = match kind {
        FeedbackKind::SineIncremental => commission::commute_c1024(language),
        FeedbackKind::EndatMultiturn | FeedbackKind::SsiMultiturn => commission::commute_absolute(language),
        FeedbackKind::Resolver => commission::commute_resolver(language),
        FeedbackKind::SquareIncremental => commission::commute_d2048(language),
    };
    let brake = about.has_brake().then(|| commission::commute_brake(language));
    let drive = (form == DriveForm::Sinamics).then(|| commission::commute_sinamics(language));
    let steps = [
        Some(commission::commute_uncoupled(language)),
        Some(commission::commute_limits(language)),
        brake,
        Some(own),
        drive,
        Some(commission::commute_confirm(language)),
        Some(commission::commute_value(language)),
    ];
    steps.into_iter().flatten().map(str::to_owned).collect()
}

/// Returns the thresholds of the temperature sensors: both of the KTY, and the corners of the standard for the PTC.
fn thresholds(about: &Commissioning, language: Language) -> Vec<SensorThreshold> {
    let mut found = Vec::new();
    let named = [
        (ParameterId::WindingWarning, commission::warning_threshold(language)),
        (ParameterId::WindingShutdown, commission::shutdown_threshold(language)),
    ];
    for (id, name) in named {
        let Some(known) = about.get(id) else { continue };
        let expected = about.expected_kty(ThermodynamicTemperature::from_si(known.si));
        let Some(expected) = expected else { continue };
        let sources = [known.sources.clone(), expected.sources.clone()].concat();
        found.push(SensorThreshold {
            sensor: "kty",
            name: name.to_owned(),
            temperature: Number(known.value()),
            resistance: Number(clean(expected.nominal.unwrap_or(expected.high))),
            bound: "typical",
            grade: Id(expected.grade),
            source: joined(&sources, None, language),
            errata: [known.errata.clone(), expected.errata].concat(),
        });
    }
    let Some(response) = about.ptc_response() else { return found };
    let Some(celsius) = response.limit().number() else { return found };
    let corners = [
        (-20.0, commission::ptc_cold(language)),
        (-5.0, commission::ptc_below(language)),
        (5.0, commission::ptc_above(language)),
        (15.0, commission::ptc_far_above(language)),
    ];
    for ((offset, name), cell) in corners.into_iter().zip(sensors::ptc_bounds()) {
        let Some(ohm) = cell.limit().number() else { continue };
        let sources = [Source::Cell(&response.place), Source::Published(&cell.place)];
        found.push(SensorThreshold {
            sensor: "ptc",
            name: name.to_owned(),
            temperature: Number(celsius + offset),
            resistance: Number(ohm),
            bound: if offset < 0.0 { "at_most" } else { "at_least" },
            grade: Id(Grade::Published),
            source: joined(&sources, None, language),
            errata: [response.errata, cell.errata].concat(),
        });
    }
    found
}

/// Overload factors for which the time is listed.
const FACTORS: [f64; 3] = [1.5, 2.0, 3.0];

/// Computes t = τ ln(k²/(k² − 1)): first-order monitoring from the cold state; docs/theory/overload.md.
fn overload(about: &Commissioning, language: Language) -> OverloadSupervision {
    let constant = about.actuator.heat.winding_time_constant.known();
    let trip = |factor: f64| {
        let square = factor * factor;
        constant.map(|known| OverloadTrip {
            factor: Number(factor),
            time: Number(known.value.in_unit(&SECOND) * (square / (square - 1.0)).ln()),
        })
    };
    OverloadSupervision {
        stall_current: about.get(ParameterId::StallCurrent).map(|known| Number(known.value())),
        time_constant: constant.map(|known| Number(known.value.in_unit(&SECOND))),
        grade: Id(constant.map_or(Grade::Assumed, |known| known.grade)),
        errata: about.get(ParameterId::StallCurrent).map_or_else(Vec::new, |known| known.errata.clone()),
        trips: FACTORS.into_iter().filter_map(trip).collect(),
        text: match constant {
            Some(_) => commission::overload_text(language).to_owned(),
            None => commission::overload_not_known(language).to_owned(),
        },
    }
}

fn list(list: &CheckList, language: Language) -> CommissionList {
    CommissionList {
        step: Id(list.step),
        title: words::step_title(list.step, language).to_owned(),
        entries: list.items.iter().map(|item| entry(list.step, item, language)).collect(),
    }
}

fn tick(id: &'static str, text: String, grade: Grade, source: String) -> CommissionEntry {
    CommissionEntry {
        id,
        signal: None,
        text,
        expected: None,
        low: None,
        high: None,
        shown: String::new(),
        unit: None,
        field: false,
        grade: Id(grade),
        source,
        errata: Vec::new(),
    }
}

fn entry(step: catalogue::LifeStep, item: &ChecklistItem, language: Language) -> CommissionEntry {
    match item {
        ChecklistItem::Fact(fact) => CommissionEntry {
            signal: fact.signal.map(Id),
            ..tick(fact.id, fact_text(fact, language).to_owned(), fact.grade, fact_source(fact, language))
        },
        ChecklistItem::Measure { expected, at } => to_measure(expected, *at, language),
        ChecklistItem::Value(parameter) => {
            let name = format!("{}, {}", parameter_name(parameter.id, language), parameter.id.symbol());
            let value = plain(parameter.value(), language);
            let (text, shown, field) = if step == catalogue::LifeStep::AfterADay {
                (commission::hottest(language).to_owned(), commission::at_most_value(&value, language), true)
            } else {
                (commission::set_value(&name, language), value, false)
            };
            CommissionEntry {
                expected: Some(Number(parameter.value())),
                shown: marked(shown, &parameter.errata),
                unit: Some(parameter.id.unit().json),
                field,
                errata: parameter.errata.clone(),
                ..tick(parameter.id.id(), text, parameter.grade, joined(&parameter.sources, None, language))
            }
        }
        ChecklistItem::Limit { speed_motor, speed_out, time } => {
            let number = |value: f64| plain(value, language);
            let text = commission::limit_run(
                &number(speed_motor.in_unit(&REVOLUTION_PER_MINUTE)),
                &number(speed_out.in_unit(&REVOLUTION_PER_MINUTE)),
                &number(time.in_unit(&MINUTE)),
                language,
            );
            let fact = catalogue::facts().iter().find(|fact| fact.id == "test_run_short");
            let (grade, source) =
                fact.map_or((Grade::Printed, String::new()), |fact| (fact.grade, fact_source(fact, language)));
            tick("test_run", text, grade, source)
        }
    }
}

fn to_measure(expected: &ExpectedValue, at: Condition, language: Language) -> CommissionEntry {
    let unit = expected.what.unit();
    let name = measurand_name(expected.what, language);
    let number = |value: f64| plain(value, language);
    let celsius = |temperature: ThermodynamicTemperature| number(temperature.in_unit(&DEGREE_CELSIUS));
    let text = match at {
        Condition::Any => name.to_owned(),
        Condition::Temperature(temperature) => commission::at_temperature(&name, &celsius(temperature), language),
        Condition::SpeedMotor(speed) => {
            commission::at_motor_speed(&name, &number(speed.in_unit(&REVOLUTION_PER_MINUTE)), language)
        }
        Condition::SpeedOut(speed, temperature) => {
            let speed = number(speed.in_unit(&REVOLUTION_PER_MINUTE));
            commission::at_output_speed(&name, &speed, &celsius(temperature), language)
        }
    };
    CommissionEntry {
        expected: expected.nominal.map(|nominal| in_unit(nominal, unit)),
        low: Some(in_unit(expected.low, unit)),
        high: Some(in_unit(expected.high, unit)),
        shown: marked(band_shown(expected, language), &expected.errata),
        errata: expected.errata.clone(),
        unit: Some(unit.json),
        field: true,
        ..tick(expected.what.id(), text, expected.grade, joined(&expected.sources, None, language))
    }
}

/// Formats a value to set or to run at, with three digits and without trailing zeros.
fn plain(value: f64, language: Language) -> String {
    let rounded = format!("{value:.2e}").parse::<f64>().unwrap_or(value);
    // A value of the list is shown unchanged.
    let value = if (rounded - value).abs() <= 1e-9 * value.abs() { rounded } else { clean(value) };
    let text = if value.to_string().len() > 6 { format_significant(value, 4, language) } else { value.to_string() };
    text.chars().map(|sign| if sign == '.' { language.decimal_mark() } else { sign }).collect()
}

pub(super) fn in_unit(si: f64, unit: &Unit) -> Number {
    Number(clean(unit.from_si(si)))
}

/// Formats an expected value as `5.9 (5.31 to 6.49)`, or the upper limit alone.
pub(super) fn band_shown(expected: &ExpectedValue, language: Language) -> String {
    let number = |si: f64| format_significant(expected.what.unit().from_si(si), 3, language);
    match expected.nominal {
        None => commission::at_most_value(&number(expected.high), language),
        Some(nominal) => {
            let band = commission::between(&number(expected.low), &number(expected.high), language);
            format!("{} ({band})", number(nominal))
        }
    }
}
