//! Widths of text, from the advances of the font that the charts name.

use std::sync::OnceLock;

use ttf_parser::Face;

/// Font family of every chart; [`font_files`] are its faces.
pub const FONT_FAMILY: &str = "Inter";

const REGULAR: &[u8] = include_bytes!("../fonts/Inter-Regular.ttf");
const ITALIC: &[u8] = include_bytes!("../fonts/Inter-Italic.ttf");
const SEMIBOLD: &[u8] = include_bytes!("../fonts/Inter-SemiBold.ttf");

/// Returns the faces of [`FONT_FAMILY`] as TrueType files: regular, italic, semi-bold.
///
/// A renderer (PDF, web page) must use these fonts, so that text has the width of the layout.
#[must_use]
pub const fn font_files() -> [&'static [u8]; 3] {
    [REGULAR, ITALIC, SEMIBOLD]
}

/// A face of the family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Cut {
    Regular,
    Italic,
    SemiBold,
}

/// Ascent of a line of text above its base line, as a share of the font size.
pub(crate) const ASCENT: f64 = 0.76;
/// Descent of a line of text below its base line, as a share of the font size.
pub(crate) const DESCENT: f64 = 0.22;
/// Height of a capital letter or digit as a share of the font size.
pub(crate) const CAP_HEIGHT: f64 = 0.727;

/// Advance of a character outside the font, as a share of the font size: another font draws it, probably a wider one.
const FOREIGN_ADVANCE: f64 = 1.0;

/// Returns the width of a text at a font size, without kerning.
pub(crate) fn width(text: &str, cut: Cut, size: f64) -> f64 {
    size * text.chars().map(|c| advance(c, cut)).sum::<f64>()
}

fn advance(c: char, cut: Cut) -> f64 {
    let Some(face) = face(cut) else { return FOREIGN_ADVANCE };
    let advance = face.glyph_index(c).and_then(|glyph| face.glyph_hor_advance(glyph));
    advance.map_or(FOREIGN_ADVANCE, |units| f64::from(units) / f64::from(face.units_per_em()))
}

/// Widths of the regular face, extracted by the build script.
const WIDTHS_REGULAR: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/Inter-Regular.ttf"));
const WIDTHS_ITALIC: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/Inter-Italic.ttf"));
const WIDTHS_SEMIBOLD: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/Inter-SemiBold.ttf"));

fn face(cut: Cut) -> Option<&'static Face<'static>> {
    static FACES: [OnceLock<Option<Face<'static>>>; 3] = [OnceLock::new(), OnceLock::new(), OnceLock::new()];
    let [regular, italic, semibold] = &FACES;
    let (cell, bytes) = match cut {
        Cut::Regular => (regular, WIDTHS_REGULAR),
        Cut::Italic => (italic, WIDTHS_ITALIC),
        Cut::SemiBold => (semibold, WIDTHS_SEMIBOLD),
    };
    cell.get_or_init(|| Face::parse(bytes, 0).ok()).as_ref()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Characters in the units, symbols and labels of the field.
    const NEEDED: &str = "⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹₀₁₂₃₄₅₆₇₈₉·−±×÷≤≥≈≠√∞∑∂∆∫…–—„“”‚‘’′″→←↑↓⇒‰%€§°ÄÖÜäöüßØµΩ\u{a0}\u{2009}\u{202f}\
        ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789()[]{}<>/|+-*=.,;:!?'\"#&@_~^\
        αβγδεζηθικλμνξοπρστυφχψωϑϕΓΔΘΛΞΠΣΦΨ✓▲■●◆□○◇△";

    #[test]
    fn every_character_of_the_field_is_in_every_face() {
        for cut in [Cut::Regular, Cut::Italic, Cut::SemiBold] {
            let face = face(cut).unwrap();
            for c in NEEDED.chars() {
                assert!(
                    face.glyph_index(c).is_some_and(|glyph| glyph.0 != 0),
                    "{cut:?} has no {c:?} U+{:04X}",
                    c as u32
                );
            }
        }
    }

    #[test]
    fn widths_are_those_of_the_whole_faces() {
        for (cut, file) in [Cut::Regular, Cut::Italic, Cut::SemiBold].into_iter().zip(font_files()) {
            let whole = Face::parse(file, 0).unwrap();
            assert!(face(cut).unwrap().raw_face().data.len() * 10 < file.len());
            for c in NEEDED.chars() {
                let units = whole.glyph_index(c).and_then(|glyph| whole.glyph_hor_advance(glyph)).unwrap();
                let share = f64::from(units) / f64::from(whole.units_per_em());
                assert!((advance(c, cut) - share).abs() < 1e-15, "{cut:?} {c:?}");
            }
        }
    }

    #[test]
    fn digits_and_minus_are_equally_wide() {
        for cut in [Cut::Regular, Cut::Italic, Cut::SemiBold] {
            let one = width("1", cut, 10.0);
            assert!("0123456789−".chars().all(|c| (width(&c.to_string(), cut, 10.0) - one).abs() < 1e-12));
            assert!(one > 5.0 && one < 8.0);
        }
    }

    #[test]
    fn widths_add_up_and_scale() {
        let (half, whole) = (width("Nm", Cut::Regular, 6.0), width("Nm", Cut::Regular, 12.0));
        assert!((whole - 2.0 * half).abs() < 1e-12);
        assert!((whole - width("N", Cut::Regular, 12.0) - width("m", Cut::Regular, 12.0)).abs() < 1e-12);
    }
}
