//! Values of a motor for the drive, and checks of the first run.

use super::parts::{grid, hazard, hazards, marked_errata, unit_shown};
use answers::{
    Chapter, Column, CommissionEntry, CommissionParameter, Commissioning, DriveObject, DriveParameter, EncoderValue,
    OverloadSupervision, SensorThreshold, Task,
};
use quantities::{Language, format_significant};
use words::{capitalised, commission, decimal, grade_word, marked, report, row_sign, terms};

/// Returns the commissioning of a code; with the objects of CiA 402 if requested.
#[must_use]
pub fn commission(record: &Commissioning, objects: &[DriveObject], language: Language) -> Chapter {
    let mut chapter = Chapter::new(capitalised(&commission::title(&record.code, language)));
    chapter.section(capitalised(commission::hazards(language)));
    chapter.hazards(hazards(&record.hazards, language));
    if !objects.is_empty() {
        chapter.section(capitalised(commission::objects(language)));
        drive_objects(&mut chapter, objects, language);
    }
    chapter.section(capitalised(commission::parameters(language)));
    if record.sinamics.is_empty() {
        parameters(&mut chapter, &record.parameters, language);
    } else {
        sinamics(&mut chapter, &record.sinamics, language);
    }
    if !record.errata.is_empty() {
        chapter.section(report::c_errata(language));
        chapter.points(marked_errata(&record.errata, language));
    }
    chapter.section(capitalised(commission::gaps(language)));
    chapter.points(record.gaps.iter().map(|gap| gap.text.clone()).collect());
    chapter.section(capitalised(commission::encoder(language)));
    encoder(&mut chapter, &record.encoder, language);
    chapter.section(capitalised(commission::commutation(language)));
    chapter.steps(record.commutation.clone());
    chapter.section(capitalised(commission::thresholds(language)));
    thresholds(&mut chapter, &record.thresholds, language);
    for (sensor, absent) in [("kty", commission::no_kty(language)), ("ptc", commission::no_ptc(language))] {
        if !record.thresholds.iter().any(|threshold| threshold.sensor == sensor) {
            chapter.text(absent);
        }
    }
    chapter.section(capitalised(commission::overload(language)));
    overload(&mut chapter, &record.overload, language);
    for list in &record.lists {
        chapter.section(capitalised(&list.title));
        chapter.tasks(list.entries.iter().map(|entry| task(entry, language)).collect());
    }
    chapter
}

/// Formats a value with its own digits; from five digits on with five significant ones.
pub(super) fn shown(value: f64, language: Language) -> String {
    let plain = value.to_string();
    let digits = plain.trim_start_matches(['0', '.', '-']).chars().filter(char::is_ascii_digit).count();
    if digits <= 4 {
        plain.replace('.', &language.decimal_mark().to_string())
    } else {
        format_significant(value, 5, language)
    }
}

fn parameters(chapter: &mut Chapter, parameters: &[CommissionParameter], language: Language) {
    grid(
        chapter,
        parameters,
        &[
            (Column::wide(commission::parameter(language)), &|each| {
                row_sign(each.symbol).map_or_else(|| each.name.clone(), |sign| format!("{sign} {}", each.name))
            }),
            (Column::numbers(terms::value(language)), &|each| marked(shown(each.value.0, language), &each.errata)),
            (Column::text(terms::unit(language)), &|each| unit_shown(each.unit, language)),
            (Column::wide(commission::conversion(language)), &|each| each.conversion_text.clone()),
            (Column::text(terms::grade(language)), &|each| grade_word(*each.grade, language).to_owned()),
            (Column::wide(terms::source(language)), &|each| each.source.clone()),
        ],
    );
}

fn sinamics(chapter: &mut Chapter, parameters: &[DriveParameter], language: Language) {
    grid(
        chapter,
        parameters,
        &[
            (Column::text(terms::number(language)), &|each| each.number.clone()),
            (Column::numbers(terms::value(language)), &|each| marked(shown(each.value.0, language), &each.errata)),
            (Column::text(terms::unit(language)), &|each| unit_shown(each.unit, language)),
            (Column::wide(commission::parameter(language)), &|each| each.name.clone()),
            (Column::wide(commission::conversion(language)), &|each| each.conversion_text.clone()),
            (Column::wide(terms::source(language)), &|each| {
                format!("{} ({})", each.source, grade_word(*each.grade, language))
            }),
        ],
    );
}

fn drive_objects(chapter: &mut Chapter, objects: &[DriveObject], language: Language) {
    grid(
        chapter,
        objects,
        &[
            (Column::wide(commission::object(language)), &|each| format!("{}:{} {}", each.index, each.sub, each.name)),
            (Column::text(commission::type_of_data(language)), &|each| each.data_type.to_owned()),
            (Column::numbers(terms::value(language)), &|each| marked(each.value.to_string(), &each.errata)),
            (Column::text(terms::unit(language)), &|each| unit_shown(each.unit, language)),
            (Column::numbers(commission::rounding(language)), &|each| shown(each.exact.0, language)),
            (Column::wide(terms::source(language)), &|each| each.source.clone()),
        ],
    );
}

fn encoder(chapter: &mut Chapter, values: &[EncoderValue], language: Language) {
    let name = |each: &EncoderValue| {
        let side =
            if each.side == "output" { commission::side_output(language) } else { commission::side_motor(language) };
        let condition = if each.condition.is_empty() { String::new() } else { format!(" ({})", each.condition) };
        format!("{side}: {}{condition}", each.name)
    };
    grid(
        chapter,
        values,
        &[
            (Column::wide(commission::parameter(language)), &name),
            (Column::text(terms::value(language)), &|each| marked(decimal(&each.text, language), &each.errata)),
            (Column::text(terms::unit(language)), &|each| unit_shown(each.unit, language)),
            (Column::wide(terms::remark(language)), &|each| each.notes.join("; ")),
        ],
    );
}

fn thresholds(chapter: &mut Chapter, thresholds: &[SensorThreshold], language: Language) {
    let resistance = |each: &SensorThreshold| {
        let sign = match each.bound {
            "at_most" => "≤ ",
            "at_least" => "≥ ",
            _ => "",
        };
        format!("{sign}{} Ω", format_significant(each.resistance.0, 4, language))
    };
    grid(
        chapter,
        thresholds,
        &[
            (Column::text(commission::threshold(language)), &|each| {
                format!("{} {}", each.sensor.to_uppercase(), each.name)
            }),
            (Column::numbers(commission::temperature(language)), &|each| {
                marked(format!("{} °C", shown(each.temperature.0, language)), &each.errata)
            }),
            (Column::numbers(commission::resistance(language)), &resistance),
            (Column::wide(terms::source(language)), &|each| {
                format!("{} ({})", each.source, grade_word(*each.grade, language))
            }),
        ],
    );
}

fn overload(chapter: &mut Chapter, overload: &OverloadSupervision, language: Language) {
    let number = |value: f64| shown(format!("{value:.2e}").parse().unwrap_or(value), language);
    if let (Some(current), Some(constant)) = (overload.stall_current, overload.time_constant) {
        let current = marked(number(current.0), &overload.errata);
        let line = commission::overload_line(&current, &number(constant.0), language);
        chapter.text(format!("{line} ({})", grade_word(*overload.grade, language)));
    }
    let trip = |trip: &answers::OverloadTrip| {
        commission::overload_trip(&number(trip.factor.0), &number(trip.time.0), language)
    };
    chapter.points(overload.trips.iter().map(trip).collect());
    chapter.text(overload.text.clone());
}

fn task(entry: &CommissionEntry, language: Language) -> Task {
    let unit = entry.unit.map(|unit| unit_shown(unit, language)).unwrap_or_default();
    let grade = grade_word(*entry.grade, language);
    Task {
        what: hazard(entry.signal, &entry.text, format!("{grade}; {}", entry.source), language),
        expected: format!("{} {unit}", entry.shown).trim().to_owned(),
        unit: entry.field.then_some(unit),
    }
}
