//! The results as JSON values, with the names that scripts rely on.

use crate::codes::{CodeFault, CodeReading, explain_code};
use crate::export::{EXPORT_COLUMNS, export_rows};
use crate::sheet::Sheet;
use crate::text::describe_field;
use catalogue::Value as CellValue;
use configurator::{Availability, Choice};
use order_code::{Field, OrderCode};
use quantities::Language;
use serde_json::{Map, Value, json};

fn names(fields: &[Field], language: Language) -> Vec<&'static str> {
    fields.iter().map(|field| describe_field(*field, language)).collect()
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
        "name": crate::text::symbol_term(cell.place.symbol, language),
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
