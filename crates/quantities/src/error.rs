//! Why a text is no quantity.

use crate::Language;
use crate::dimension::Dimension;
use crate::units::Unit;
use std::ops::Range;
use thiserror::Error;

/// Why a text is no quantity, and where in it.
///
/// `Display` is the English message; [`message`](Self::message) and [`hint`](Self::hint) speak both languages.
/// The texts in `found` are shortened to 40 characters.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum QuantityError {
    /// The text is empty or blank.
    #[error("empty, expected {} such as \"{}\"", en(*expected), expected.example())]
    Empty {
        /// Place in the text, in bytes: all of it.
        span: Range<usize>,
        /// Expected quantity.
        expected: Dimension,
    },
    /// There is a unit without a number.
    #[error("the number is missing before \"{found}\", expected {} such as \"{}\"", en(*expected), expected.example())]
    NumberMissing {
        /// Place of the unit in the text, in bytes.
        span: Range<usize>,
        /// The unit as written.
        found: String,
        /// Expected quantity.
        expected: Dimension,
    },
    /// What stands in place of the number is none, or is grouped with spaces or dots.
    #[error("\"{found}\" is not a number")]
    NumberUnreadable {
        /// Place in the text, in bytes.
        span: Range<usize>,
        /// What stands there.
        found: String,
        /// Expected quantity.
        expected: Dimension,
    },
    /// The number has a decimal comma.
    #[error("decimal comma in \"{found}\"")]
    DecimalComma {
        /// Place of the number in the text, in bytes.
        span: Range<usize>,
        /// The number as written.
        found: String,
    },
    /// The number is infinite, no number, or too large to be held.
    #[error("\"{found}\" is not a finite number")]
    NotFinite {
        /// Place of the number in the text, in bytes.
        span: Range<usize>,
        /// The number as written.
        found: String,
    },
    /// There is a number without a unit.
    #[error("the unit is missing, expected {} such as \"{}\"", en(*expected), expected.example())]
    UnitMissing {
        /// Place of the number in the text, in bytes.
        span: Range<usize>,
        /// Expected quantity.
        expected: Dimension,
    },
    /// Nobody knows the unit.
    #[error("unknown unit \"{found}\"")]
    UnitUnknown {
        /// Place of the unit in the text, in bytes.
        span: Range<usize>,
        /// The unit as written.
        found: String,
        /// Expected quantity.
        expected: Dimension,
        /// The unit of the expected quantity that is spelled most alike, if one is near.
        nearest: Option<&'static Unit>,
    },
    /// The unit measures something else.
    #[error(
        "\"{found}\" is a unit of {}, expected a unit of {}",
        measures.name(Language::En),
        expected.name(Language::En)
    )]
    WrongQuantity {
        /// Place of the unit in the text, in bytes.
        span: Range<usize>,
        /// The unit as written.
        found: String,
        /// What the unit measures.
        measures: Dimension,
        /// Expected quantity.
        expected: Dimension,
    },
    /// After the sign of a tolerance nothing stands.
    #[error("the half-width of the tolerance is missing")]
    ToleranceMissing {
        /// Place of the sign in the text, in bytes.
        span: Range<usize>,
    },
    /// The half-width of a tolerance is negative.
    #[error("the half-width of a tolerance must not be negative")]
    ToleranceNegative {
        /// Place of the half-width in the text, in bytes.
        span: Range<usize>,
    },
    /// A percent of a temperature in °C.
    #[error("a percent of a temperature in °C has no meaning: its zero is arbitrary")]
    ToleranceOfOffsetScale {
        /// Place of the half-width in the text, in bytes.
        span: Range<usize>,
    },
}

fn en(dimension: Dimension) -> &'static str {
    dimension.name_with_article(Language::En)
}

impl QuantityError {
    /// The offending part of the text, in bytes; always at character boundaries.
    #[must_use]
    pub fn span(&self) -> Range<usize> {
        match self {
            Self::Empty { span, .. }
            | Self::NumberMissing { span, .. }
            | Self::NumberUnreadable { span, .. }
            | Self::DecimalComma { span, .. }
            | Self::NotFinite { span, .. }
            | Self::UnitMissing { span, .. }
            | Self::UnitUnknown { span, .. }
            | Self::WrongQuantity { span, .. }
            | Self::ToleranceMissing { span }
            | Self::ToleranceNegative { span }
            | Self::ToleranceOfOffsetScale { span } => span.clone(),
        }
    }

    /// The same fault of a text that begins so many bytes further on.
    pub(crate) fn moved(mut self, bytes: usize) -> Self {
        match &mut self {
            Self::Empty { span, .. }
            | Self::NumberMissing { span, .. }
            | Self::NumberUnreadable { span, .. }
            | Self::DecimalComma { span, .. }
            | Self::NotFinite { span, .. }
            | Self::UnitMissing { span, .. }
            | Self::UnitUnknown { span, .. }
            | Self::WrongQuantity { span, .. }
            | Self::ToleranceMissing { span }
            | Self::ToleranceNegative { span }
            | Self::ToleranceOfOffsetScale { span } => *span = span.start + bytes..span.end + bytes,
        }
        self
    }

    /// What is wrong, in one sentence.
    #[must_use]
    pub fn message(&self, language: Language) -> String {
        match language {
            Language::En => self.to_string(),
            Language::De => self.message_de(),
        }
    }

    fn message_de(&self) -> String {
        let wanted = |expected: &Dimension| {
            let name = expected.name_with_article(Language::De);
            format!("erwartet wird {name}, zum Beispiel „{}“", expected.example())
        };
        match self {
            Self::Empty { expected, .. } => format!("leer: {}", wanted(expected)),
            Self::NumberMissing { found, expected, .. } => format!("Zahl fehlt vor „{found}“: {}", wanted(expected)),
            Self::NumberUnreadable { found, .. } => format!("„{found}“ ist keine Zahl"),
            Self::DecimalComma { found, .. } => format!("Dezimalkomma in „{found}“"),
            Self::NotFinite { found, .. } => format!("„{found}“ ist keine endliche Zahl"),
            Self::UnitMissing { expected, .. } => format!("Einheit fehlt: {}", wanted(expected)),
            Self::UnitUnknown { found, .. } => format!("unbekannte Einheit „{found}“"),
            Self::WrongQuantity { found, measures, expected, .. } => {
                let (measures, expected) = (measures.name(Language::De), expected.name_with_article(Language::De));
                format!("„{found}“ ist eine Einheit der Größe {measures}, erwartet wird {expected}")
            }
            Self::ToleranceMissing { .. } => "die halbe Breite der Toleranz fehlt".to_owned(),
            Self::ToleranceNegative { .. } => "die halbe Breite einer Toleranz darf nicht negativ sein".to_owned(),
            Self::ToleranceOfOffsetScale { .. } => {
                "ein Prozentsatz einer Temperatur in °C hat keine Bedeutung: ihr Nullpunkt ist willkürlich".to_owned()
            }
        }
    }

    /// What would be right, if more can be said than the message says.
    #[must_use]
    pub fn hint(&self, language: Language) -> Option<String> {
        match self {
            Self::Empty { expected, .. }
            | Self::NumberMissing { expected, .. }
            | Self::UnitMissing { expected, .. } => Some(units(*expected, language)),
            Self::NumberUnreadable { expected, .. } => Some(match language {
                Language::En => {
                    format!(
                        "write digits without separators, with a decimal point, for example \"{}\"",
                        expected.example()
                    )
                }
                Language::De => {
                    format!(
                        "Ziffern ohne Trennzeichen schreiben, mit Dezimalpunkt, zum Beispiel „{}“",
                        expected.example()
                    )
                }
            }),
            Self::DecimalComma { found, .. } => Some(point_hint(found, language)),
            Self::NotFinite { .. } => None,
            Self::UnitUnknown { expected, nearest, .. } => {
                let units = units(*expected, language);
                Some(match (nearest, language) {
                    (None, _) => units,
                    (Some(unit), Language::En) => format!("did you mean \"{}\"? {units}", unit.ascii),
                    (Some(unit), Language::De) => format!("gemeint ist vielleicht „{}“; {units}", unit.ascii),
                })
            }
            Self::WrongQuantity { expected, .. } => Some(units(*expected, language)),
            Self::ToleranceNegative { .. } => None,
            Self::ToleranceMissing { .. } => Some(match language {
                Language::En => "for example \"± 10 %\", or a quantity of the same kind".to_owned(),
                Language::De => "zum Beispiel „± 10 %“, oder eine Größe derselben Art".to_owned(),
            }),
            Self::ToleranceOfOffsetScale { .. } => Some(match language {
                Language::En => "write the half-width in kelvin, for example \"40 degC ± 5 K\"".to_owned(),
                Language::De => "die halbe Breite in Kelvin schreiben, zum Beispiel „40 degC ± 5 K“".to_owned(),
            }),
        }
    }
}

/// The valid units of a quantity.
fn units(dimension: Dimension, language: Language) -> String {
    let names: Vec<&str> = dimension.units().iter().map(|unit| unit.ascii).collect();
    let (name, names) = (dimension.name(language), names.join(", "));
    match language {
        Language::En => format!("units of {name}: {names}"),
        Language::De => format!("Einheiten für {name}: {names}"),
    }
}

/// The number with a decimal point; where the comma may have grouped thousands, also without it.
fn point_hint(found: &str, language: Language) -> String {
    let (whole, fraction) = found.split_once(',').unwrap_or((found, ""));
    let zero = if whole.ends_with(|c: char| c.is_ascii_digit()) { "" } else { "0" };
    let point = format!("{whole}{zero}.{fraction}");
    let grouped = Some((whole, fraction)).filter(|_| zero.is_empty() && fraction.len() == 3);
    match (language, grouped) {
        _ if found.ends_with('…') => match language {
            Language::En => "write a decimal point".to_owned(),
            Language::De => "mit Dezimalpunkt schreiben".to_owned(),
        },
        (Language::En, None) => format!("write a decimal point: {point}"),
        (Language::De, None) => format!("mit Dezimalpunkt schreiben: {point}"),
        (Language::En, Some((whole, fraction))) => {
            format!("write a decimal point: {point}; or no separator for thousands: {whole}{fraction}")
        }
        (Language::De, Some((whole, fraction))) => {
            format!("mit Dezimalpunkt schreiben: {point}; Tausender ohne Trennzeichen: {whole}{fraction}")
        }
    }
}
