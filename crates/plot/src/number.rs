//! Numbers of the SVG text.

/// Writes a coordinate with at most two decimals. Non-finite values are removed earlier; here they are written as
/// empty.
pub(crate) fn number(value: f64) -> String {
    if !value.is_finite() {
        return String::from("0");
    }
    let mut text = format!("{value:.2}");
    text.truncate(text.trim_end_matches('0').trim_end_matches('.').len());
    if text == "-0" { String::from("0") } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_are_short_and_never_minus_zero() {
        for (value, text) in [
            (1.0, "1"),
            (100.0, "100"),
            (0.5, "0.5"),
            (-0.004, "0"),
            (-0.006, "-0.01"),
            (12.345, "12.35"),
            (f64::NAN, "0"),
            (f64::INFINITY, "0"),
        ] {
            assert_eq!(number(value), text);
        }
    }
}
