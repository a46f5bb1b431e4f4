//! Styles of a workbook, distinct without colour too.

use rust_xlsxwriter::{Color, Format, FormatAlign, FormatBorder};

/// Utilisation from which a value is near its limit.
pub(super) const NEAR: f64 = 0.8;

/// Shares: `●` marks a value near its limit, `▲` one above it.
pub(super) const SHARE: &str = "[>1]\"▲ \"0.0%;[>0.8]\"● \"0.0%;0.0%";
/// Ratios that are no margin.
pub(super) const RATIO: &str = "0.0%";
/// Margins: `▲` marks a negative one.
pub(super) const MARGIN: &str = "0.0%;\"▲ \"-0.0%";

const INK: u32 = 0x1F_2A_36;
const RULE: u32 = 0xB8_C2_CC;
const HEAD: u32 = 0xE4_E9_EE;

pub(super) struct Styles {
    pub(super) title: Format,
    pub(super) plain: Format,
    pub(super) label: Format,
    pub(super) strong: Format,
    pub(super) head: Format,
    pub(super) unit: Format,
    pub(super) text: Format,
    pub(super) link: Format,
    pub(super) fine: Format,
    pub(super) near: Format,
    pub(super) over: Format,
    pub(super) open: Format,
    pub(super) date: Format,
}

impl Styles {
    pub(super) fn new() -> Self {
        let base = || Format::new().set_font_color(Color::RGB(INK)).set_align(FormatAlign::Top);
        let filled = |colour: u32| Format::new().set_background_color(Color::RGB(colour));
        Self {
            title: base().set_bold().set_font_size(18),
            plain: base().set_text_wrap(),
            label: base().set_font_color(Color::RGB(0x5A_66_72)),
            strong: base().set_bold(),
            head: base()
                .set_bold()
                .set_text_wrap()
                .set_align(FormatAlign::Bottom)
                .set_background_color(Color::RGB(HEAD)),
            unit: base()
                .set_font_color(Color::RGB(0x5A_66_72))
                .set_background_color(Color::RGB(HEAD))
                .set_border_bottom(FormatBorder::Thin)
                .set_border_bottom_color(Color::RGB(RULE)),
            text: base().set_text_wrap(),
            link: base().set_font_color(Color::RGB(0x00_5A_9C)).set_underline(rust_xlsxwriter::FormatUnderline::Single),
            fine: filled(0xCD_EB_E1),
            near: filled(0xFA_E3_B8),
            over: filled(0xF6_CD_B4).set_bold(),
            open: filled(0xE6_E6_E6).set_italic(),
            date: base().set_align(FormatAlign::Left),
        }
    }

    /// Returns the style of a number in a format.
    pub(super) fn number(&self, format: &str) -> Format {
        self.text.clone().set_num_format(format)
    }
}

/// Returns the format of a single number: unchanged if it is short, else with `digits` digits.
pub(super) fn single(number: f64, digits: i32) -> String {
    const SHORT: usize = 8;
    if number.to_string().len() <= SHORT { "General".to_owned() } else { decimals(number, digits) }
}

/// Returns a format with the decimals that a magnitude needs for `digits` digits.
pub(super) fn decimals(magnitude: f64, digits: i32) -> String {
    let magnitude = magnitude.abs();
    if magnitude == 0.0 {
        return "0".to_owned();
    }
    if !(1e-4..1e7).contains(&magnitude) {
        return format!("0.{}E+00", "0".repeat(usize::try_from(digits - 1).unwrap_or(0)));
    }
    #[allow(clippy::cast_possible_truncation, reason = "between minus four and seven")]
    let exponent = magnitude.log10().floor() as i32;
    match usize::try_from(digits - 1 - exponent).unwrap_or(0) {
        0 => "0".to_owned(),
        count => format!("0.{}", "0".repeat(count)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_format_shows_the_digits_asked_for() {
        for (magnitude, expected) in
            [(0.0, "0"), (110.6, "0.0"), (9.5, "0.000"), (12345.0, "0"), (0.012, "0.00000"), (2e9, "0.000E+00")]
        {
            assert_eq!(decimals(magnitude, 4), expected, "{magnitude}");
        }
    }
}
