//! Words about tolerances.

use super::either;
use crate::project::{Range, Tolerance};
use quantities::{Dimension, Language, Unit, format_significant};

/// More quantities than this are not named in a message.
const NAMED_MOST: usize = 4;

fn shown(si: f64, unit: &Unit, language: Language) -> String {
    format!("{} {}", format_significant(unit.from_si(si), 5, language), unit.symbol)
}

/// An end of a band at which the key has no valid value.
pub(crate) fn end_out_of_range(path: &str, end: f64, unit: &Unit, range: Range, language: Language) -> String {
    let end = shown(end, unit, language);
    let (en, de) = match range {
        Range::Positive => ("it must be greater than zero", "muss größer als null sein"),
        Range::NotNegative => ("it must not be negative", "darf nicht negativ sein"),
        Range::Any => ("that is below absolute zero", "liegt unter dem absoluten Nullpunkt"),
    };
    either(
        language,
        format!("`{path}`: with this tolerance the value reaches {end}; {en}"),
        format!("`{path}`: mit dieser Toleranz erreicht der Wert {end}; er {de}"),
    )
}

/// How a quantity is written, for an editor.
pub(crate) fn quantity(dimension: Dimension, language: Language) -> String {
    let (name, example) = (dimension.name(language), dimension.example());
    let half = if dimension == Dimension::Temperature { "5 K" } else { "10 %" };
    either(
        language,
        format!("{name} with its unit, perhaps with a tolerance: \"{example}\", \"{example} ± {half}\""),
        format!("{name} mit Einheit, vielleicht mit Toleranz: \"{example}\", \"{example} ± {half}\""),
    )
}

/// More tolerances than are read.
pub(crate) fn too_many(most: usize, language: Language) -> String {
    either(
        language,
        format!("more than {most} quantities with a tolerance"),
        format!("mehr als {most} Größen mit einer Toleranz"),
    )
}

/// Values within the tolerances at which there is no such axis, and why.
pub(crate) fn impossible(values: &[(&Tolerance, f64)], why: &str, language: Language) -> String {
    let mut named: Vec<String> = values
        .iter()
        .take(NAMED_MOST)
        .map(|(tolerance, end)| format!("{} = {}", tolerance.path, shown(tolerance.at(*end), tolerance.unit, language)))
        .collect();
    if values.len() > NAMED_MOST {
        named.push("…".to_owned());
    }
    let named = named.join(", ");
    if values.len() == 1 {
        return either(
            language,
            format!("with this tolerance the axis is not possible, at {named}: {why}"),
            format!("mit dieser Toleranz ist die Achse nicht möglich, bei {named}: {why}"),
        );
    }
    either(
        language,
        format!("with these tolerances together the axis is not possible, at {named}: {why}"),
        format!("mit diesen Toleranzen zusammen ist die Achse nicht möglich, bei {named}: {why}"),
    )
}
