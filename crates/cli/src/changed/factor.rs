//! Factors that a call states as numbers, percentages or with a sign of multiplication.

use std::ops::RangeInclusive;

/// Percentages without a sign that state a share of the stated value: a smaller one may also be meant as an increase.
const SHARES: RangeInclusive<f64> = 50.0..=200.0;

/// Returns the factor that a percentage states: `+15%` is 1.15, `-20%` is 0.8, `80%` is 0.8; `None` for a share that may be meant
/// as an increase.
pub(crate) fn share(text: &str) -> Option<f64> {
    let number = text.strip_suffix('%')?.trim();
    let percent: f64 = number.replace(',', ".").parse().ok()?;
    match number.starts_with(['+', '-']) {
        true => Some((100.0 + percent) / 100.0),
        false => SHARES.contains(&percent).then_some(percent / 100.0),
    }
}

/// Returns the change that a factor makes, as a percentage with a sign: 1.15 is `+15%`.
pub(super) fn percentage(factor: f64) -> String {
    let text = format!("{:+.6}", 100.0 * (factor - 1.0));
    format!("{}%", text.trim_end_matches('0').trim_end_matches('.'))
}

/// Returns the factors that a statement may mean and that none of its forms decides: `15%`, `+0.15`.
pub(super) fn undecided_factors(text: &str) -> Vec<String> {
    let number = text.strip_suffix('%').map(str::trim);
    let (plain, is_percent) = (number.unwrap_or(text), number.is_some());
    let Ok(value) = plain.replace(',', ".").parse::<f64>() else { return Vec::new() };
    let trimmed = |number: f64| {
        let text = format!("{number:.6}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    };
    let is_signed = plain.starts_with(['+', '-']);
    match (is_percent, is_signed) {
        (true, false) => vec![format!("+{}%", trimmed(value)), trimmed(value / 100.0)],
        // Of one the sign adds a share, of many a percentage.
        (false, true) if value.abs() < 1.0 => vec![format!("{:+}%", 100.0 * value), trimmed(value.abs())],
        (false, true) => vec![format!("{value:+}%"), trimmed(value.abs())],
        _ => Vec::new(),
    }
}

/// Returns the factor that a word states as a percentage or with a sign of multiplication.
pub(crate) fn factor(word: &str) -> Option<f64> {
    if let Some(factor) = share(word) {
        return Some(factor);
    }
    let number = word.strip_prefix(['x', '×', '*']).or_else(|| word.strip_suffix(['x', '×']))?;
    number.replace(',', ".").parse().ok()
}

/// Returns the factor that a statement is, with a sign as a percentage only.
pub(super) fn any_factor(text: &str) -> Option<f64> {
    let plain = || text.replace(',', ".").parse().ok().filter(|_| !text.starts_with(['+', '-']));
    share(text).or_else(|| factor(text)).or_else(plain)
}
