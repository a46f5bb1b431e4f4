//! Test support: tolerances for printed values, generated projects and files, invalid files, checks of HTML pages, of costs, and of words that
//! no reader should meet.

pub mod cost;
pub mod generated;
pub mod html;
pub mod parquet;
pub mod projects;
pub mod readers;
pub mod series;
pub mod visible;

/// Returns `true` if a computed value agrees with a printed one within half of the last printed digit.
///
/// # Panics
/// If `printed` is no number: a test with a broken reference must fail.
#[must_use]
#[allow(clippy::expect_used, reason = "a broken reference value must fail the test that uses it")]
pub fn agrees(value: f64, printed: &str) -> bool {
    let reference: f64 = printed.parse().expect("a reference value is a number");
    (value - reference).abs() <= half_last_digit(printed) * (1.0 + 1e-12)
}

/// Returns half of the last printed digit: 0.005 for `103.98`, 0.5 for `23`.
#[must_use]
pub fn half_last_digit(printed: &str) -> f64 {
    let decimals = printed.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    0.5 * 10f64.powi(-i32::try_from(decimals).unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_of_the_last_digit_is_the_tolerance() {
        assert!(agrees(103.984, "103.98"));
        assert!(!agrees(103.986, "103.98"));
        assert!(agrees(23.4, "23"));
        assert!(!agrees(22.4, "23"));
    }
}
