//! Figures that several answers share.

use workbench::quantities::{Unit, format_number, format_significant};
use workbench::{Figure, Language};

/// A value in its unit, four digits.
pub(crate) fn shown(si: f64, unit: &Unit, language: Language) -> String {
    format_significant(unit.from_si(si), 4, language)
}

/// A figure in its unit, four digits, or a dash.
pub(crate) fn figure(figure: Option<Figure>, language: Language) -> String {
    figure.map_or_else(|| "–".into(), |figure| format_significant(figure.value(), 4, language))
}

/// A utilisation in percent, or a dash.
pub(crate) fn percent(utilisation: Option<f64>, language: Language) -> String {
    utilisation.map_or_else(|| "–".into(), |share| format_number(share * 100.0, 1, language))
}
