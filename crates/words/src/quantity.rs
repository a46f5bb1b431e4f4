//! Words for texts that are no quantities, and plain numbers.

use crate::texts::said;
use quantities::{Dimension, Language, QuantityError, format_number, format_significant};

/// Returns the fault of a text that should be a quantity, in one sentence.
#[must_use]
pub fn quantity_fault(error: &QuantityError, language: Language) -> String {
    let wanted = |expected: Dimension| {
        let (name, example) = (expected.name_with_article(language), expected.example());
        said!(language => "expected {name} such as \"{example}\"" | "erwartet wird {name}, zum Beispiel „{example}“")
    };
    match error {
        QuantityError::Empty { expected, .. } => {
            let wanted = wanted(*expected);
            said!(language => "empty, {wanted}" | "leer: {wanted}")
        }
        QuantityError::NumberMissing { found, expected, .. } => {
            let wanted = wanted(*expected);
            said!(language =>
                "the number is missing before \"{found}\", {wanted}"
                | "vor „{found}“ fehlt die Zahl: {wanted}"
            )
        }
        QuantityError::NumberUnreadable { found, .. } => {
            said!(language => "\"{found}\" is not a number" | "„{found}“ ist keine Zahl")
        }
        QuantityError::DecimalComma { found, .. } => {
            said!(language => "decimal comma in \"{found}\"" | "Dezimalkomma in „{found}“")
        }
        QuantityError::NotFinite { found, .. } if is_too_small(found) => {
            said!(language => "\"{found}\" is too small for a number" | "„{found}“ ist für eine Zahl zu klein")
        }
        QuantityError::NotFinite { found, .. } => {
            said!(language => "\"{found}\" is not a finite number" | "„{found}“ ist keine endliche Zahl")
        }
        QuantityError::UnitMissing { expected, .. } => {
            let wanted = wanted(*expected);
            said!(language => "the unit is missing, {wanted}" | "die Einheit fehlt: {wanted}")
        }
        QuantityError::UnitUnknown { found, .. } => {
            said!(language => "unknown unit \"{found}\"" | "unbekannte Einheit „{found}“")
        }
        QuantityError::WrongQuantity { found, measures, expected, .. } => {
            let name = measures.name(language);
            match language {
                Language::En => {
                    format!("\"{found}\" is a unit of {name}, expected a unit of {}", expected.name(language))
                }
                Language::De => format!(
                    "„{found}“ ist eine Einheit der Größe {name}, erwartet wird {}",
                    expected.name_with_article(language)
                ),
            }
        }
        QuantityError::FlywheelEffect { found, .. } => said!(language =>
            "\"{found}\" is a unit of the flywheel effect GD², expected a moment of inertia, J = GD²/4"
            | "„{found}“ ist eine Einheit des Schwungmoments GD², erwartet wird ein Massenträgheitsmoment, J = GD²/4"
        ),
        QuantityError::ToleranceMissing { .. } => {
            said!(language => "the half-width of the tolerance is missing" | "die halbe Breite der Toleranz fehlt")
        }
        QuantityError::ToleranceNegative { .. } => said!(language =>
            "the half-width of a tolerance must not be negative"
            | "die halbe Breite einer Toleranz darf nicht negativ sein"
        ),
        QuantityError::ToleranceOfOffsetScale { .. } => said!(language =>
            "a percentage of a temperature in °C or °F has no meaning: its zero is arbitrary"
            | "eine Prozentangabe zu einer Temperatur in °C oder °F ist nicht sinnvoll: der Nullpunkt ist willkürlich"
        ),
    }
}

/// Returns the remedy; `None` if the fault already implies it.
#[must_use]
pub fn quantity_hint(error: &QuantityError, language: Language) -> Option<String> {
    match error {
        QuantityError::Empty { expected, .. }
        | QuantityError::NumberMissing { expected, .. }
        | QuantityError::UnitMissing { expected, .. } => Some(units(*expected, language)),
        QuantityError::NumberUnreadable { expected, .. } => Some(match language {
            Language::En => {
                format!("write digits without separators of thousands, for example \"{}\"", expected.example())
            }
            Language::De => {
                format!("Ziffern ohne Tausendertrennzeichen schreiben, zum Beispiel „{}“", expected.example())
            }
        }),
        QuantityError::DecimalComma { found, .. } => Some(point_hint(found, language)),
        QuantityError::NotFinite { .. } => None,
        QuantityError::UnitUnknown { expected, nearest, .. } => {
            let units = units(*expected, language);
            Some(match (nearest, language) {
                (None, _) => units,
                (Some(unit), Language::En) => format!("did you mean \"{}\"? {units}", unit.ascii),
                (Some(unit), Language::De) => format!("gemeint ist vielleicht „{}“; {units}", unit.ascii),
            })
        }
        QuantityError::WrongQuantity {
            measures: Dimension::EffectiveVoltage, expected: Dimension::Voltage, ..
        } => Some(said!(language =>
            "this key takes a DC voltage, \"560 V\"; for the mains voltage of a rectifier use [requirements] mains = \"400 V\""
            | "hier ist eine Gleichspannung anzugeben, „560 V“; für die Netzspannung eines Gleichrichters [requirements] mains = \"400 V\" verwenden"
        )),
        QuantityError::WrongQuantity { expected, .. } => Some(units(*expected, language)),
        QuantityError::FlywheelEffect { found, .. } => Some(said!(language =>
            "write \"GD^2 {found}\" after the number if it is GD²: then it is divided by 4"
            | "„GD^2 {found}“ hinter die Zahl schreiben, wenn sie GD² angibt: dann wird sie durch 4 geteilt"
        )),
        QuantityError::ToleranceNegative { .. } => None,
        QuantityError::ToleranceMissing { .. } => Some(said!(language =>
            "for example \"± 10 %\", or a quantity of the same kind"
            | "zum Beispiel „± 10 %“, oder eine Größe derselben Art"
        )),
        QuantityError::ToleranceOfOffsetScale { .. } => Some(said!(language =>
            "state the half-width in kelvin, for example \"40 °C ± 5 K\""
            | "die halbe Breite in Kelvin angeben, zum Beispiel „40 °C ± 5 K“"
        )),
    }
}

/// Returns the remedy where a quantity of further dimensions is valid.
pub(crate) fn hint_of_several(error: &QuantityError, also: &[Dimension], language: Language) -> Option<String> {
    let hint = quantity_hint(error, language)?;
    let names_units = match error {
        QuantityError::Empty { .. }
        | QuantityError::NumberMissing { .. }
        | QuantityError::UnitMissing { .. }
        | QuantityError::UnitUnknown { .. }
        | QuantityError::WrongQuantity { .. } => true,
        QuantityError::NumberUnreadable { .. }
        | QuantityError::DecimalComma { .. }
        | QuantityError::NotFinite { .. }
        | QuantityError::FlywheelEffect { .. }
        | QuantityError::ToleranceMissing { .. }
        | QuantityError::ToleranceNegative { .. }
        | QuantityError::ToleranceOfOffsetScale { .. } => false,
    };
    let others = also.iter().filter(|_| names_units).map(|dimension| units(*dimension, language));
    Some(std::iter::once(hint).chain(others).collect::<Vec<_>>().join("; "))
}

/// Returns the valid units of a quantity.
fn units(dimension: Dimension, language: Language) -> String {
    let names: Vec<&str> = dimension.units().iter().map(|unit| unit.ascii).collect();
    let (name, names) = (dimension.name(language), names.join(", "));
    said!(language => "units of {name}: {names}" | "Einheiten für {name}: {names}")
}

/// Returns the number with a decimal point; if the comma may group thousands, also without it.
fn point_hint(found: &str, language: Language) -> String {
    let (whole, fraction) = found.split_once(',').unwrap_or((found, ""));
    let zero = if whole.ends_with(|c: char| c.is_ascii_digit()) { "" } else { "0" };
    let point = format!("{whole}{zero}.{fraction}");
    let grouped = Some((whole, fraction)).filter(|_| zero.is_empty() && fraction.len() == 3);
    match (language, grouped) {
        _ if found.ends_with('…') => said!(language => "write a decimal point" | "mit Dezimalpunkt schreiben"),
        (Language::En, None) => format!("write a decimal point: {point}"),
        (Language::De, None) => format!("mit Dezimalpunkt schreiben: {point}"),
        (Language::En, Some((whole, fraction))) => {
            format!("write a decimal point: {point}; or, without thousands separator: {whole}{fraction}")
        }
        (Language::De, Some((whole, fraction))) => {
            format!("mit Dezimalpunkt schreiben: {point}; oder ohne Tausendertrennzeichen: {whole}{fraction}")
        }
    }
}

/// Most decimals of a share in percent that tell it from 100 %.
const PERCENT_DECIMALS: usize = 4;

/// Smallest percentage without a decimal: no digit of it says more than its magnitude.
const PERCENT_LARGE: f64 = 1e6;

/// Returns a share in percent with one decimal, or with as many as tell it from 100 %, so that no excess stands beside
/// 100.0 %; from 10⁶ % on with four digits and a power of ten ([`format_significant`]).
#[must_use]
pub fn percent_text(share: f64, language: Language) -> String {
    let percent = share * 100.0;
    if percent.is_finite() && percent.abs() >= PERCENT_LARGE - 0.05 {
        return format_significant(percent, 4, language);
    }
    let text = |decimals: usize| format_number(share * 100.0, decimals, language);
    let is_hundred = |decimals: usize| text(decimals) == format_number(100.0, decimals, language);
    let decimals = (1..=PERCENT_DECIMALS).find(|decimals| !is_hundred(*decimals)).unwrap_or(1);
    text(decimals)
}

/// A number with at most so many digits that count, without zeros that only fill them up.
#[must_use]
pub fn unpadded(number: f64, digits: usize, language: Language) -> String {
    let text = format_significant(number, digits, language);
    let has_fraction = text.contains(['.', ',']) && !text.contains(['e', '·']);
    if has_fraction { text.trim_end_matches('0').trim_end_matches(['.', ',']).to_owned() } else { text }
}

/// Returns `true` if a number that is not finite is so by the negative power of ten behind it.
fn is_too_small(number: &str) -> bool {
    ["e-", "E-", "e−", "E−"].iter().any(|power| number.contains(power))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A percentage of any size has a handful of digits, from which its magnitude can be read.
    #[test]
    fn a_percentage_is_short() {
        for language in Language::ALL {
            for exponent in -12..300 {
                for mantissa in [1.0, 1.234_567, 9.999_999_9] {
                    let share = mantissa * 10_f64.powi(exponent);
                    let text = percent_text(share, language);
                    assert!(text.chars().count() <= 11, "{share}: {text}");
                }
            }
        }
        for (share, text) in [
            (0.728, "72,8"),
            (1.0004, "100,04"),
            (1234.5, "123450,0"),
            (9999.9999, "1000000"),
            (1.234e28, "1,234·10³⁰"),
            (f64::INFINITY, "∞"),
        ] {
            assert_eq!(percent_text(share, Language::De), text);
        }
    }
}
