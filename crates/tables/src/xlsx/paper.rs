//! Paper and row heights of a sheet.

use rust_xlsxwriter::Worksheet;

/// Estimates the number of lines of a text in a column width, rather high than low: a surplus line is empty, a missing
/// one is cut off.
pub(super) fn lines(text: &str, characters: f64) -> u32 {
    let mut lines = 0;
    for paragraph in text.split('\n') {
        let (mut used, mut rows) = (0.0, 1);
        for word in paragraph.split(' ') {
            #[allow(clippy::cast_precision_loss, reason = "the length of a word")]
            let long = word.chars().count() as f64 * 1.08;
            let space = if used > 0.0 { 1.0 } else { 0.0 };
            if used + space + long <= characters {
                used += space + long;
            } else {
                rows += u32::from(used > 0.0);
                // A word longer than the column is broken.
                let mut rest = long;
                while rest > characters {
                    rest -= characters;
                    rows += 1;
                }
                used = rest;
            }
        }
        lines += rows;
    }
    lines
}

/// Returns the height of a row of `lines` lines in points; the limit of a sheet is 409.
pub(super) fn height(lines: u32) -> f64 {
    (f64::from(lines) * 15.0).min(409.0)
}

/// Paper of a printed sheet, landscape, with the heading on every page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Paper {
    /// Size of the paper.
    size: Size,
    /// Number of pages beside each other.
    pages: u16,
}

/// Size of a paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Size {
    A4,
    /// For sheets illegible on A4.
    A3,
}

/// Characters of all columns that A4 and A3 hold at a scale of sixty per cent, below which letters are hard to read.
const CHARACTERS: [f64; 2] = [240.0, 340.0];

impl Paper {
    /// One page of A4.
    pub(super) const A4: Self = Self { size: Size::A4, pages: 1 };

    /// Returns the smallest paper on which columns of this total width in characters stay legible, A3 on as many pages as
    /// that takes.
    pub(super) fn for_width(characters: f64) -> Self {
        let [a4, a3] = CHARACTERS;
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small positive number")]
        let pages = (characters / a3).ceil().clamp(1.0, 20.0) as u16;
        if characters <= a4 { Self::A4 } else { Self { size: Size::A3, pages } }
    }

    pub(super) fn set(self, sheet: &mut Worksheet) {
        let number = match self.size {
            Size::A4 => 9,
            Size::A3 => 8,
        };
        sheet.set_paper_size(number).set_landscape().set_print_fit_to_pages(self.pages, 0);
        sheet.set_margins(0.4, 0.4, 0.5, 0.5, 0.3, 0.3);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_takes_the_lines_that_its_words_need() {
        assert_eq!(lines("", 10.0), 1);
        assert_eq!(lines("one two", 10.0), 1);
        assert_eq!(lines("one two three four", 12.0), 2);
        assert_eq!(lines("a\nb", 10.0), 2);
        assert_eq!(lines(&"x".repeat(25), 10.0), 3);
    }
}
