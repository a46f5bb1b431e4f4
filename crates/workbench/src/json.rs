//! The results as JSON values, with the names that scripts rely on.

mod build;
mod chapters;
mod compare;
mod explain;
mod inertia;
mod moves;
mod tolerance;

pub use build::{bill_of_material, screws};
pub use chapters::{battery, curves, reserve};
pub use compare::{compare, difference, input_changes, verdict};
pub use explain::explain;
pub use inertia::inertia;
pub use moves::moves;
pub use tolerance::tolerance;

use crate::codes::{CodeFault, CodeReading, explain_code};
use crate::export::{EXPORT_COLUMNS, export_rows};
use crate::sheet::Sheet;
use crate::sizing_use::{Candidate, CandidateId, Objection, Sizing};
use crate::tolerance::Assessment;
use catalogue::Value as CellValue;
use configurator::{Availability, Choice};
use order_code::{Field, OrderCode};
use project::Project;
use quantities::unit::{KILOGRAM, NEWTON_METRE, REVOLUTION_PER_MINUTE, SECOND};
use quantities::{Language, Measure, Unit};
use serde_json::{Map, Value, json};
use sizing::{Check, Demand, ManualDemand, Note};
use words::{Told, assumption_text, check_title, describe_field, describe_rule, note_text, source_text, unmet_text};

/// A number without the last digits that only a change of unit has made: twelve significant digits.
fn number(value: f64) -> Value {
    if value == 0.0 || !value.is_finite() {
        return if value == 0.0 { json!(0.0) } else { Value::Null };
    }
    let rounded: f64 = format!("{value:.11e}").parse().unwrap_or(value);
    json!(rounded)
}

fn in_unit(si: f64, unit: &Unit) -> Value {
    number(unit.from_si(si))
}

/// One check, with the fields of the contract.
#[must_use]
pub fn check(check: &Check, language: Language) -> Value {
    let figure = |figure: Option<sizing::Figure>| figure.map_or(Value::Null, |figure| number(figure.value()));
    let unit = check.value.or(check.limit).map(|figure| figure.unit.json);
    let sources: Vec<String> = [&check.limit_source, &check.value_source]
        .into_iter()
        .flatten()
        .map(|source| source_text(source, language))
        .collect();
    let errata = check.notes.iter().filter_map(|note| if let Note::Erratum(id) = note { Some(*id) } else { None });
    let errata: Vec<&str> = errata.collect();
    let mut fields = json!({
        "id": check.id.id(),
        "title": check_title(check.id, language),
        "verdict": check.verdict.id(),
        "value": figure(check.value),
        "limit": figure(check.limit),
        "unit": unit,
        "direction": check.direction().id(),
        "part": check.id.part().id(),
        "utilisation": check.utilisation.map(number),
        "margin": check.id.has_margin(),
        "at": check.at.map(|at| in_unit(at.si(), &SECOND)),
        "grade": check.grade.map(provenance::Grade::id),
        "source": if sources.is_empty() { Value::Null } else { json!(sources.join("; ")) },
        "missing": check.missing,
        "notes": check.notes.iter().map(|note| note_text(note, language)).filter(|note| !note.is_empty()).collect::<Vec<_>>(),
    });
    if let Value::Object(map) = &mut fields
        && !errata.is_empty()
    {
        map.insert("errata".into(), json!(errata));
    }
    fields
}

fn demand_fields(demand: &Demand) -> Map<String, Value> {
    let mut map = Map::new();
    map.insert("T_rms".into(), in_unit(demand.torque_rms.si(), &NEWTON_METRE));
    map.insert("T_peak".into(), in_unit(demand.torque_peak.si(), &NEWTON_METRE));
    map.insert("n_av".into(), in_unit(demand.speed_mean.si(), &REVOLUTION_PER_MINUTE));
    map.insert("n_peak".into(), in_unit(demand.speed_peak.si(), &REVOLUTION_PER_MINUTE));
    map.insert("ED".into(), number(demand.duty_factor * 100.0));
    map
}

fn demand_units() -> Value {
    json!({ "T": "Nm", "n": "1/min", "ED": "%" })
}

/// The demand: the manual's figures with T_1, T_2, T_3 of the governing move, the exact integrals beside them.
#[must_use]
pub fn demand(manual: Option<&ManualDemand>, integral: Option<&Demand>) -> Value {
    let Some(manual) = manual else {
        let Some(integral) = integral else { return Value::Null };
        let mut map = Map::new();
        map.insert("mode".into(), json!("integral"));
        map.append(&mut demand_fields(integral));
        map.insert("units".into(), demand_units());
        return Value::Object(map);
    };
    let mut map = Map::new();
    map.insert("mode".into(), json!("manual"));
    map.append(&mut demand_fields(&manual.demand));
    let torques = |torques: &sizing::MoveTorques| {
        [("T_1", torques.accelerate), ("T_2", torques.run), ("T_3", torques.brake)]
            .map(|(name, torque)| (name.to_owned(), in_unit(torque.si(), &NEWTON_METRE)))
    };
    if let Some(governing) = manual.moves.get(manual.governing) {
        map.extend(torques(governing));
    }
    map.insert("units".into(), demand_units());
    if manual.moves.len() > 1 {
        let moves: Vec<Value> =
            manual.moves.iter().map(|each| Value::Object(torques(each).into_iter().collect())).collect();
        map.insert("moves".into(), Value::Array(moves));
        map.insert("governing_move".into(), json!(manual.governing + 1));
    }
    if let Some(integral) = integral {
        let mut exact = demand_fields(integral);
        exact.insert("mode".into(), json!("integral"));
        map.insert("integral".into(), Value::Object(exact));
    }
    Value::Object(map)
}

fn objection(candidate: &Candidate<'_>, objection: &Objection, language: Language) -> String {
    match (objection, &candidate.id) {
        (Objection::Unmet(unmet), _) => unmet_text(unmet, language),
        (Objection::Rule(rule), CandidateId::Code(code)) => describe_rule(code, rule, language),
        (Objection::Rule(rule), CandidateId::Own(_)) => rule.table.to_owned(),
    }
}

/// What speaks against a candidate besides a failing check, in words.
#[must_use]
pub fn objections(candidate: &Candidate<'_>, language: Language) -> Vec<String> {
    candidate.objections.iter().map(|each| objection(candidate, each, language)).collect()
}

fn names(fields: &[Field], language: Language) -> Vec<&'static str> {
    fields.iter().map(|field| describe_field(*field, language)).collect()
}

/// One judged actuator.
#[must_use]
pub fn candidate(candidate: &Candidate<'_>, language: Language) -> Value {
    let mut map = Map::new();
    match &candidate.id {
        CandidateId::Code(code) => map.insert("code".into(), json!(code.to_string())),
        CandidateId::Own(name) => map.insert("name".into(), json!(name)),
    };
    map.insert("verdict".into(), json!(verdict(candidate)));
    map.insert("utilisation".into(), number(candidate.standing.utilisation));
    map.insert("tightest".into(), json!(candidate.judgement.tightest().map(|check| check.id.id())));
    let mass = candidate.parameters.mass.known().map(|mass| in_unit(mass.value.si(), &KILOGRAM));
    map.insert("mass_kg".into(), mass.unwrap_or(Value::Null));
    map.insert("on_request".into(), json!(names(&candidate.on_request, language)));
    map.insert("demand".into(), demand(candidate.judgement.manual.as_ref(), candidate.judgement.demand.as_ref()));
    map.insert("checks".into(), candidate.judgement.checks.iter().map(|each| check(each, language)).collect());
    map.insert("objections".into(), json!(objections(candidate, language)));
    map.insert("open_questions".into(), json!(candidate.open_questions()));
    Value::Object(map)
}

/// Why a candidate is rejected, in short.
fn rejection(candidate: &Candidate<'_>, language: Language) -> Value {
    let worst = candidate.worst_failure();
    let failing: Vec<&str> = candidate
        .judgement
        .checks
        .iter()
        .filter(|check| check.verdict == sizing::Verdict::Fail)
        .map(|check| check.id.id())
        .collect();
    json!({
        "code": candidate.id.to_string(),
        "check": worst.map(|check| check.id.id()),
        "value": worst.and_then(|check| check.value).map(|figure| number(figure.value())),
        "limit": worst.and_then(|check| check.limit).map(|figure| number(figure.value())),
        "unit": worst.and_then(|check| check.value).map(|figure| figure.unit.json),
        "utilisation": worst.and_then(|check| check.utilisation).map(number),
        "failing": failing,
        "objections": objections(candidate, language),
    })
}

/// The catalogue judged for an axis: the best `top` in full, the rejected ones with their reason.
#[must_use]
pub fn sizing(
    sizing: &Sizing<'_>,
    project: &Project,
    assessed: &[(&Candidate<'_>, Assessment)],
    top: usize,
    language: Language,
) -> Value {
    let judged = |each: &Candidate<'_>| {
        let mut value = candidate(each, language);
        let found = assessed.iter().find(|(of, _)| of.id == each.id);
        if let (Value::Object(map), Some((_, found))) = (&mut value, found) {
            map.insert("tolerance".into(), tolerance(project, found));
        }
        value
    };
    let fitting = sizing.candidates.iter().filter(|candidate| candidate.fits()).count();
    let ranking: Vec<Value> = sizing
        .candidates
        .iter()
        .enumerate()
        .filter(|(_, each)| each.fits())
        .take(top)
        .map(|(index, each)| {
            let mut value = judged(each);
            if let Value::Object(map) = &mut value {
                map.insert("rank".into(), json!(index + 1));
            }
            value
        })
        .collect();
    let rejected: Vec<Value> =
        sizing.candidates.iter().filter(|each| !each.fits()).map(|each| rejection(each, language)).collect();
    let mut value = json!({
        "axis": sizing.name,
        "verdict": if sizing.fits() { "fits" } else { "does_not_fit" },
        "answer": sizing.answer().map(|answer| answer.id.to_string()),
        "judged": sizing.candidates.len(),
        "fitting": fitting,
        "rule": words::ranking_rule(language),
        "ranking": ranking,
        "rejected": rejected,
        "own": sizing.own.as_ref().map(judged),
        "assumptions": assumptions(sizing.assumptions, language),
    });
    if let (Value::Object(map), Some(stage)) = (&mut value, stage(project)) {
        map.insert("stage".into(), stage);
    }
    value
}

/// The ratio of the stage between actuator and mechanism, and what others of the project would give.
fn stage(project: &Project) -> Option<Value> {
    let stage = project.axis.mechanism.stage.as_ref()?;
    let ratios: Vec<Value> = project
        .ratios
        .iter()
        .map(|each| {
            json!({
                "ratio": number(each.ratio),
                "answer": each.answer,
                "utilisation": number(each.utilisation),
                "fitting": each.fitting,
            })
        })
        .collect();
    Some(json!({ "ratio": number(stage.ratio), "ratios": ratios }))
}

/// The assumptions in words.
#[must_use]
pub fn assumptions(assumptions: &[crate::Assumption], language: Language) -> Vec<String> {
    assumptions.iter().map(|assumption| assumption_text(*assumption, language)).collect()
}

/// A code with every field explained.
#[must_use]
pub fn code_reading(reading: &CodeReading, language: Language) -> Value {
    let fields: Vec<Value> = explain_code(&reading.parsed.code, language)
        .into_iter()
        .map(|(field, token, meaning)| {
            let span = reading
                .parsed
                .spans
                .iter()
                .find(|(spanned, _)| *spanned == field)
                .map(|(_, span)| [span.start, span.end]);
            json!({
                "field": field_id(field),
                "name": describe_field(field, language),
                "token": token,
                "meaning": meaning,
                "span": span,
            })
        })
        .collect();
    json!({
        "valid": true,
        "code": reading.parsed.code.to_string(),
        "canonical": reading.parsed.is_canonical(),
        "availability": availability_id(&reading.availability),
        "on_request": names(&reading.availability.on_request, language),
        "fields": fields,
    })
}

/// The faults of a code, with the nearest valid ones.
#[must_use]
pub fn code_faults(text: &str, faults: &[CodeFault], nearest: &[OrderCode]) -> Value {
    let faults: Vec<Value> = faults
        .iter()
        .map(|fault| {
            json!({
                "position": text.get(..fault.span.start).map_or(1, |before| before.chars().count() + 1),
                "span": [fault.span.start, fault.span.end],
                "text": text.get(fault.span.clone()),
                "message": fault.message,
                "hint": fault.hint,
                "table": fault.table,
            })
        })
        .collect();
    let nearest: Vec<String> = nearest.iter().map(ToString::to_string).collect();
    json!({ "valid": false, "text": text, "errors": faults, "nearest": nearest })
}

const fn availability_id(availability: &Availability) -> &'static str {
    if availability.on_request.is_empty() { "available" } else { "on_request" }
}

const fn field_id(field: Field) -> &'static str {
    match field {
        Field::Series => "series",
        Field::Size => "size",
        Field::Ratio => "ratio",
        Field::Winding => "winding",
        Field::Feedback => "feedback",
        Field::Brake => "brake",
        Field::Option1 => "option_1",
        Field::Option2 => "option_2",
        Field::Special => "special",
    }
}

/// A list of codes with their availability.
#[must_use]
pub fn codes(codes: &[&(OrderCode, Availability)], language: Language) -> Value {
    codes
        .iter()
        .map(|(code, found)| {
            json!({
                "code": code.to_string(),
                "availability": availability_id(found),
                "on_request": names(&found.on_request, language),
            })
        })
        .collect()
}

/// What may stand at each field of a partial code, and the codes it allows.
#[must_use]
pub fn completion(
    choices: &[(Field, &'static str, Vec<Choice>)],
    codes: &[&(OrderCode, Availability)],
    language: Language,
) -> Value {
    let fields: Vec<Value> = choices
        .iter()
        .map(|(field, name, choices)| {
            let choices: Vec<Value> = choices
                .iter()
                .map(|choice| {
                    json!({ "token": choice.token, "availability": if choice.available { "available" } else { "on_request" } })
                })
                .collect();
            json!({ "field": field_id(*field), "name": name, "choices": choices })
        })
        .collect();
    json!({ "fields": fields, "codes": self::codes(codes, language) })
}

/// A data sheet.
#[must_use]
pub fn sheet(sheet: &Sheet, language: Language) -> Value {
    let sections: Vec<Value> = sheet
        .sections
        .iter()
        .map(|section| {
            let rows: Vec<Value> = section.rows.iter().map(|row| cell(row.cell, language)).collect();
            let title = if language == Language::De { section.table.title_de } else { section.table.title_en };
            json!({ "table": section.table.id, "title": title, "values": rows })
        })
        .collect();
    json!({ "code": sheet.code.to_string(), "sections": sections })
}

/// The torsion of a gear under a torque.
#[must_use]
pub fn torsion(code: &OrderCode, answer: &crate::TorsionAnswer) -> Value {
    use quantities::unit::{ARCMINUTE, NEWTON_METRE_PER_RADIAN, RADIAN};
    json!({
        "code": code.to_string(),
        "torque": in_unit(answer.torque.si(), &NEWTON_METRE),
        "angle_rad": in_unit(answer.angle.si(), &RADIAN),
        "angle_arcmin": in_unit(answer.angle.si(), &ARCMINUTE),
        "region": answer.region,
        "T_1": in_unit(answer.curve.torque_1.si(), &NEWTON_METRE),
        "T_2": in_unit(answer.curve.torque_2.si(), &NEWTON_METRE),
        "K": answer.curve.stiffness.map(|k| in_unit(k.si(), &NEWTON_METRE_PER_RADIAN)),
        "units": { "T": "Nm", "K": "Nm/rad" },
        "source": "cha-manual eq. 73.1 to 73.4",
    })
}

fn cell_value(cell: &catalogue::Cell) -> Value {
    match cell.value {
        CellValue::NotPrinted => Value::Null,
        CellValue::Range { .. } | CellValue::Text => json!(cell.value_text()),
        _ => cell.value.number().map_or(Value::Null, |value| json!(value)),
    }
}

fn cell(cell: &catalogue::Cell, language: Language) -> Value {
    json!({
        "symbol": cell.place.symbol,
        "name": words::symbol_term(cell.place.symbol, language),
        "condition": cell.place.condition,
        "printed": cell.printed,
        "value": cell_value(cell),
        "unit": cell.unit,
        "table": cell.place.table,
        "grade": "printed",
        "errata": cell.errata,
        "checks_use": cell.checks_use.and_then(CellValue::number),
    })
}

/// The catalogue in long form.
#[must_use]
pub fn export() -> Value {
    export_rows()
        .map(|(cell, row)| {
            let mut map: Map<String, Value> =
                EXPORT_COLUMNS.iter().map(|name| (*name).to_owned()).zip(row.into_iter().map(Value::String)).collect();
            map.insert("value".into(), cell_value(cell));
            Value::Object(map)
        })
        .collect()
}

/// Faults of an input file.
#[must_use]
pub fn diagnostics(file: &str, faults: &[Told]) -> Value {
    let faults: Vec<Value> = faults
        .iter()
        .map(|fault| {
            json!({
                "file": file,
                "line": fault.line,
                "column": fault.column,
                "id": fault.id,
                "span": [fault.span.start, fault.span.end],
                "message": fault.message,
                "hint": fault.hint,
            })
        })
        .collect();
    json!({ "errors": faults })
}
