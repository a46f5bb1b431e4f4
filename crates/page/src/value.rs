//! Field of a quantity: a number in the language of the page, with the choice of its unit.
//!
//! The project file keeps the entry as written: a number without a unit takes the selected unit; a number with a unit
//! is kept unchanged; the choice of another unit converts the value to that unit.

use crate::arithmetic::computed;
use crate::markup::{tolerance_of, vals};
use maud::{Markup, html};
use project::{KEYS, Key, Kind, example};
use quantities::{Dimension, Language, Unit, parse};
use words::page;

/// A quantity as the field shows it.
struct Shown {
    /// The number, or the whole text if it is not one number with one unit.
    number: String,
    unit: &'static Unit,
}

/// Returns the dimensions that a key may have; empty if it is no quantity.
pub(crate) fn dimensions(key: &Key) -> Vec<Dimension> {
    match key.kind {
        Kind::Quantity(dimension, _) => vec![dimension],
        Kind::Along(turning, line, _) => vec![line, turning],
        Kind::Number(..)
        | Kind::Numbers(..)
        | Kind::Integer(..)
        | Kind::Bool
        | Kind::Text
        | Kind::Texts
        | Kind::OneOf(_)
        | Kind::ListOf(_)
        | Kind::Rows(_)
        | Kind::Table(_)
        | Kind::OneOrMany(..)
        | Kind::Bodies
        | Kind::Variants(_) => Vec::new(),
    }
}

/// Returns the selectable units; empty for a ratio.
fn units(dimensions: &[Dimension]) -> Vec<&'static Unit> {
    dimensions.iter().flat_map(|dimension| dimension.units()).collect()
}

/// Returns the name of the list of units of these dimensions.
fn list_id(dimensions: &[Dimension]) -> String {
    let names: Vec<String> = dimensions.iter().map(|dimension| format!("{dimension:?}")).collect();
    format!("units-{}", names.join("-"))
}

/// Returns the lists of units, once for all fields of the page.
pub(crate) fn lists() -> Markup {
    let mut all: Vec<Vec<Dimension>> = Vec::new();
    crate::find::walk(KEYS, "", &mut |_, key| {
        let dimensions = dimensions(key);
        if units(&dimensions).len() > 1 && !all.contains(&dimensions) {
            all.push(dimensions);
        }
    });
    html! { @for dimensions in &all {
        datalist id=(list_id(dimensions)) { @for unit in units(dimensions) { option value=(unit.ascii) { (unit.symbol) } } }
    } }
}

/// Splits a text into number and unit, if it consists of these.
fn taken_apart(text: &str, dimensions: &[Dimension]) -> Option<(String, &'static Unit)> {
    let reading = dimensions.iter().find_map(|dimension| parse(*dimension, text).ok())?;
    let number: String = text.trim().chars().take_while(|sign| is_of_number(*sign)).collect();
    // A letter of a unit may look like an exponent: the longest beginning that is a number is the number.
    let number =
        (1..=number.len()).rev().filter_map(|end| number.get(..end)).find(|part| part.trim().parse::<f64>().is_ok())?;
    Some((number.trim().to_owned(), reading.unit))
}

fn is_of_number(sign: char) -> bool {
    sign.is_ascii_digit() || matches!(sign, '+' | '-' | '.' | 'e' | 'E')
}

/// Returns the value in the example of a key.
pub(crate) fn sample(key: &Key) -> Option<String> {
    Some(example(key)?.split_once("= ")?.1.trim_matches('"').to_owned())
}

/// Writes a number in a language.
fn written(number: &str, language: Language) -> String {
    number.replace('.', &language.decimal_mark().to_string())
}

/// Returns the value of a key as its field shows it: a plain number with the decimal mark of the language.
pub(crate) fn number(key: &Key, value: &str, language: Language) -> String {
    let is_number = matches!(key.kind, Kind::Number(..)) && value.parse::<f64>().is_ok();
    if is_number { written(value, language) } else { value.to_owned() }
}

/// Returns an entry of a number as the project file keeps it: arithmetic computed, the decimal mark of the language as a
/// point, a tolerance kept. Faulty arithmetic is kept as typed, so that its field reports it.
pub(crate) fn taken(typed: &str, language: Language) -> String {
    let (nominal, band) = tolerance_of(typed);
    match computed(nominal, language) {
        Ok(Some(value)) if band.is_empty() => value,
        Ok(Some(value)) => format!("{value} ± {band}"),
        // `1.000` is a thousand where the comma is the decimal mark, and one elsewhere: it is refused as `1 000`.
        Ok(None) | Err(_) if is_of_thousands(nominal, language) => {
            nominal.replacen('.', " ", nominal.matches('.').count())
        }
        Ok(None) | Err(_) => with_point(typed, language),
    }
}

/// Returns `true` if a number has points between groups of three digits, in a language with a decimal comma.
fn is_of_thousands(typed: &str, language: Language) -> bool {
    let number = typed.trim().trim_start_matches(['+', '-', '−']);
    let end = number.find(|sign: char| !sign.is_ascii_digit() && sign != '.').unwrap_or(number.len());
    let mut groups = number.get(..end).unwrap_or_default().split('.');
    let first = groups.next().is_some_and(|first| (1..=3).contains(&first.len()) && !first.starts_with('0'));
    let rest: Vec<&str> = groups.collect();
    let is_whole = !number.get(end..).is_some_and(|rest| rest.starts_with(','));
    language.decimal_mark() == ',' && is_whole && first && !rest.is_empty() && rest.iter().all(|group| group.len() == 3)
}

/// Returns the fault of the arithmetic in the value of a number; `None` if there is none.
pub(crate) fn arithmetic_fault(key: &Key, value: &str, language: Language) -> Option<String> {
    let is_number = matches!(key.kind, Kind::Quantity(..) | Kind::Along(..) | Kind::Number(..) | Kind::Integer(..));
    let (nominal, _) = tolerance_of(value);
    let fault = computed(nominal, language).err().filter(|_| is_number)?;
    // In the unit that the field has as an example.
    let dimensions = dimensions(key);
    let usual = sample(key).and_then(|sample| Some(taken_apart(&sample, &dimensions)?.1));
    let unit = usual.or_else(|| units(&dimensions).first().copied()).map_or("", |unit| unit.symbol_in(language));
    Some(fault.text(unit, language))
}

/// Returns an entry with the decimal point of the project file, if the language has a comma and the number contains
/// one.
fn with_point(typed: &str, language: Language) -> String {
    let head: String = typed.trim_start().chars().take_while(|sign| is_of_number(*sign) || *sign == ',').collect();
    let is_number =
        head.matches(',').count() == 1 && !head.contains('.') && head.chars().any(|sign| sign.is_ascii_digit());
    if language.decimal_mark() == ',' && is_number { typed.replacen(',', ".", 1) } else { typed.to_owned() }
}

/// Returns a value of a project file with the decimal mark of a language, for a field that takes number and unit
/// together.
pub(crate) fn with_mark(value: &str, language: Language) -> String {
    let end = value.trim().chars().take_while(|sign| is_of_number(*sign)).count();
    let is_number = end > 0 && value.matches('.').count() == 1 && value.find('.').is_some_and(|place| place < end);
    if is_number { written(value, language) } else { value.to_owned() }
}

/// Returns a value of a project file for a sentence: decimal mark and sign of the unit as its readers write them.
pub(crate) fn said(value: &str, language: Language) -> String {
    let marked = with_mark(value, language);
    let parts = marked.split_once(' ').and_then(|(number, unit)| Some((number, Unit::of(unit)?)));
    parts.map_or_else(|| marked.clone(), |(number, unit)| format!("{number} {}", unit.symbol_in(language)))
}

/// Returns the value of an entry with a selected unit: unchanged if it has its own unit, else with the selected one.
pub(crate) fn stated(typed: &str, unit: &str, language: Language) -> String {
    let typed = taken(typed, language);
    if typed.trim().parse::<f64>().is_ok() && !unit.is_empty() { format!("{} {unit}", typed.trim()) } else { typed }
}

/// Converts a value with its tolerance to another unit; returns it unchanged if that is impossible.
pub(crate) fn in_unit(text: &str, unit: &str) -> String {
    let (nominal, band) = tolerance_of(text);
    let Some(unit) = Unit::of(unit) else { return text.to_owned() };
    let other = |text: &str, is_difference: bool| {
        let reading = parse(unit.dimension, text).ok()?;
        let zero = if is_difference { [reading.unit.to_si(0.0), unit.to_si(0.0)] } else { [0.0; 2] };
        let value = unit.from_si(reading.si - zero[0] + zero[1]);
        // Rounding of the conversion adds no digits.
        let short = format!("{value:.12e}").parse::<f64>().unwrap_or(value);
        Some(format!("{short} {}", unit.ascii))
    };
    let Some(nominal) = other(nominal, false) else { return text.to_owned() };
    if band.is_empty() {
        return nominal;
    }
    let band = if band.ends_with('%') { Some(band.to_owned()) } else { other(band, true) };
    band.map_or_else(|| text.to_owned(), |band| format!("{nominal} ± {band}"))
}

/// Returns the unit that a text of a key states, as a project file has it; empty without one.
pub(crate) fn unit_of(key: &Key, text: &str) -> &'static str {
    taken_apart(text, &dimensions(key)).map_or("", |(_, unit)| unit.ascii)
}

/// Returns the content of a field, or of its placeholder.
fn shown(text: &str, dimensions: &[Dimension], language: Language) -> Option<Shown> {
    let (nominal, _) = tolerance_of(text);
    let (number, unit) = taken_apart(nominal, dimensions)?;
    Some(Shown { number: written(&number, language), unit })
}

/// Returns the field of a quantity; `follows` is the value without an entry.
pub(crate) fn field(
    key: &Key,
    (id, path, label): (&str, &str, &str),
    value: &str,
    follows: Option<&str>,
    (wrong, described): (bool, &str),
    trigger: &str,
    language: Language,
) -> Markup {
    let l = language;
    let dimensions = dimensions(key);
    let units = units(&dimensions);
    let sample = sample(key).unwrap_or_default();
    let held = shown(value, &dimensions, l);
    let ghost = shown(follows.unwrap_or(&sample), &dimensions, l);
    let unit = held.as_ref().or(ghost.as_ref()).map_or("", |shown| shown.unit.ascii);
    let (nominal, _) = tolerance_of(value);
    let number = held.map_or_else(|| nominal.to_owned(), |shown| shown.number);
    // The value that follows from others; an empty field has no other number in it that could be taken for one.
    let placeholder =
        follows.map(|follows| format!("= {}", ghost.as_ref().map_or(follows, |shown| shown.number.as_str())));
    let title = follows.filter(|_| value.is_empty()).map(|follows| page::follows(&follows, l));
    let (_, band) = tolerance_of(value);
    html! {
        span.quantity {
            input id=(id) name="value" type="text" value=(number) placeholder=[placeholder] title=[title] autocomplete="off" spellcheck="false" inputmode="decimal"
                aria-invalid=[wrong.then_some("true")] aria-describedby=[wrong.then_some(described)]
                hx-post="/work" hx-trigger=(trigger) hx-vals=(vals(&[("path", path), ("unit", unit), ("kept", band)]));
            @if units.len() > 1 {
                // The other units stand once in the page.
                select id={ (id) "-u" } name="in_unit" data-chosen=(unit) data-units=(list_id(&dimensions)) aria-label=(page::unit_of(&label, l)) title=(page::unit_of(&label, l))
                    hx-post="/work" hx-trigger="change" hx-vals=(vals(&[("path", path), ("was", value)])) {
                    option value=(unit) selected { (Unit::of(unit).map_or(unit, |unit| unit.symbol)) }
                }
            } @else if let Some(only) = units.first() { span.unit { (only.symbol) } }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thousand_with_a_point_is_refused_where_the_comma_is_the_decimal_mark() {
        for (typed, kept) in [
            ("1.000", "1 000"),
            ("-12.500 kg", "-12 500 kg"),
            ("1.000.000", "1 000 000"),
            ("0.125", "0.125"),
            ("1.5", "1.5"),
            ("1.0000", "1.0000"),
        ] {
            assert_eq!(taken(typed, Language::De), kept, "{typed}");
            assert_eq!(taken(typed, Language::En), typed);
        }
        assert!(quantities::parse_as::<quantities::Mass>("1 000 kg").is_err());
    }

    #[test]
    fn a_number_takes_the_unit_beside_it() {
        assert_eq!(stated("60", "kg", Language::En), "60 kg");
        assert_eq!(stated("0,5", "kg", Language::De), "0.5 kg");
        assert_eq!(stated("0,5 t", "kg", Language::De), "0.5 t");
        assert_eq!(stated("1,300", "mm", Language::En), "1,300");
        assert_eq!(stated("", "mm", Language::En), "");
        assert_eq!(stated("60 lb", "kg", Language::En), "60 lb");
        assert_eq!(stated("1.000,5", "mm", Language::De), "1.000,5");
    }

    #[test]
    fn another_unit_states_the_same_value() {
        assert_eq!(in_unit("40 mm", "m"), "0.04 m");
        assert_eq!(in_unit("40 mm ± 5 %", "m"), "0.04 m ± 5 %");
        assert_eq!(in_unit("40 mm ± 2 mm", "m"), "0.04 m ± 0.002 m");
        assert_eq!(in_unit("1 in", "mm"), "25.4 mm");
        assert_eq!(in_unit("40 mm", "kg"), "40 mm");
        assert_eq!(in_unit("20 degC ± 5 K", "K"), "293.15 K ± 5 K");
        assert_eq!(in_unit("fast", "mm"), "fast");
    }

    #[test]
    fn a_value_reads_back_as_it_was() {
        for value in ["0.7 kg m^2", "90 deg", "disc diameter=0.5m length=20mm", "1.25"] {
            let shown = with_mark(value, Language::De);
            assert_eq!(with_point(&shown, Language::De), value, "{shown}");
        }
        assert_eq!(with_mark("0.7 kg m^2", Language::De), "0,7 kg m^2");
    }

    #[test]
    fn an_exponent_is_no_unit() {
        let length = [Dimension::Length];
        let found = taken_apart("1e-3 m", &length).map(|(number, unit)| (number, unit.ascii));
        assert_eq!(found, Some(("1e-3".to_owned(), "m")));
        assert!(taken_apart("3", &length).is_none());
    }
}
