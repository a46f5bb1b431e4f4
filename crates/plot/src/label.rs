//! Text with symbols: runs of plain, italic and subscript characters, measured, shortened and broken into lines.

use crate::font::{self, Cut};

/// Smallest font size in px: 7 pt.
pub(crate) const SIZE_MIN: f64 = 7.0 * 96.0 / 72.0;
const SUBSCRIPT_SCALE: f64 = 0.78;

/// A text of a chart: plain words and symbols of quantities.
///
/// A symbol is set in italics, its index as an upright subscript.
///
/// ```
/// use plot::Label;
/// let label = Label::symbol("T_rms").text(" at 325 V");
/// assert_eq!(label.plain(), "T_rms at 325 V");
/// assert_eq!(Label::from("Reach").plain(), "Reach");
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Label {
    pub(crate) runs: Vec<TextRun>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct TextRun {
    pub(crate) text: String,
    pub(crate) kind: RunKind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RunKind {
    Plain,
    Symbol,
    Index,
}

impl Label {
    /// Creates the symbol of a quantity, its index after an underscore: `"T_max"`.
    #[must_use]
    pub fn symbol(symbol: &str) -> Self {
        Self::default().and_symbol(symbol)
    }

    /// Appends plain text.
    #[must_use]
    pub fn text(self, text: &str) -> Self {
        self.with(text, RunKind::Plain)
    }

    /// Appends the symbol of a quantity.
    #[must_use]
    pub fn and_symbol(self, symbol: &str) -> Self {
        match symbol.split_once('_') {
            Some((base, index)) => self.with(base, RunKind::Symbol).with(index, RunKind::Index),
            None => self.with(symbol, RunKind::Symbol),
        }
    }

    /// Returns the text without formatting, an index after an underscore.
    #[must_use]
    pub fn plain(&self) -> String {
        let mut plain = String::new();
        for run in &self.runs {
            if run.kind == RunKind::Index {
                plain.push('_');
            }
            plain.push_str(&run.text);
        }
        plain
    }

    /// Returns `true` if the text contains blanks only.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.runs.iter().all(|run| run.text.trim().is_empty())
    }

    fn with(mut self, text: &str, kind: RunKind) -> Self {
        // A line of text cannot contain line breaks or control characters; XML does not allow the latter.
        let text: String = text.chars().map(|c| if is_drawable(c) { c } else { ' ' }).collect();
        if !text.is_empty() {
            self.runs.push(TextRun { text, kind });
        }
        self
    }

    pub(crate) fn width(&self, size: f64, bold: bool) -> f64 {
        self.runs.iter().map(|run| run.width(size, bold)).sum()
    }

    /// Returns the text up to its first blank.
    pub(crate) fn first_word(&self) -> Self {
        let mut word = Self::default();
        for run in &self.runs {
            let (text, rest) = run.text.split_once(' ').map_or((run.text.as_str(), None), |(a, b)| (a, Some(b)));
            word = word.with(text, run.kind);
            if rest.is_some() {
                break;
            }
        }
        word
    }

    /// Shortens the text to a width, with an ellipsis; empty if not even that fits.
    pub(crate) fn elided(&self, limit: f64, size: f64, bold: bool) -> Self {
        if self.width(size, bold) <= limit {
            return self.clone();
        }
        let mut room = limit - font::width("…", cut(RunKind::Plain, bold), size);
        if room < 0.0 {
            return Self::default();
        }
        let mut kept = Self::default();
        for run in &self.runs {
            let (size, cut) = (run.size(size), cut(run.kind, bold));
            let mut text = String::new();
            let mut full = false;
            for c in run.text.chars() {
                let mut buffer = [0; 4];
                room -= font::width(c.encode_utf8(&mut buffer), cut, size);
                if room < 0.0 {
                    full = true;
                    break;
                }
                text.push(c);
            }
            kept = kept.with(&text, run.kind);
            if full {
                break;
            }
        }
        while kept.runs.last_mut().is_some_and(|run| {
            run.text.truncate(run.text.trim_end().len());
            run.text.is_empty()
        }) {
            kept.runs.pop();
        }
        kept.with("…", RunKind::Plain)
    }

    /// Breaks the text into lines of at most `limit`, at blanks, and within a word that is longer than a line. The
    /// whole text is kept.
    pub(crate) fn wrapped(&self, limit: f64, size: f64, bold: bool) -> Vec<Self> {
        let mut done: Vec<Self> = Vec::new();
        let mut line = Self::default();
        for word in self.words() {
            let longer = line.clone().joined(&word);
            if longer.width(size, bold) <= limit {
                line = longer;
                continue;
            }
            if !line.is_empty() {
                done.push(line);
            }
            line = Self::default();
            for piece in word.without_leading_blank().pieces(limit, size, bold) {
                if !line.is_empty() {
                    done.push(line);
                }
                line = piece;
            }
        }
        if !line.is_empty() {
            done.push(line);
        }
        done
    }

    /// Splits the label into parts of at most `limit`, after a hyphen, comma or slash if there is one, else anywhere.
    fn pieces(self, limit: f64, size: f64, bold: bool) -> Vec<Self> {
        if self.width(size, bold) <= limit {
            return vec![self];
        }
        let atoms: Vec<Self> = self
            .runs
            .iter()
            .flat_map(|run| run.text.split_inclusive(['-', ',', '/', '\u{ad}']).map(|part| (part, run.kind)))
            .map(|(part, kind)| Self::default().with(part, kind))
            .flat_map(|part| if part.width(size, bold) <= limit { vec![part] } else { part.letters() })
            .collect();
        let mut parts: Vec<Self> = Vec::new();
        for atom in atoms {
            match parts.last_mut() {
                Some(last) if last.clone().joined(&atom).width(size, bold) <= limit => {
                    *last = std::mem::take(last).joined(&atom);
                }
                _ => parts.push(atom),
            }
        }
        parts.into_iter().map(Self::merged).collect()
    }

    fn letters(&self) -> Vec<Self> {
        let letters = self.runs.iter().flat_map(|run| run.text.chars().map(|c| (c, run.kind)));
        letters.map(|(c, kind)| Self::default().with(c.encode_utf8(&mut [0; 4]), kind)).collect()
    }

    /// Merges adjacent runs of one kind.
    pub(crate) fn merged(self) -> Self {
        let mut merged = Self::default();
        for run in self.runs {
            match merged.runs.last_mut() {
                Some(last) if last.kind == run.kind => last.text.push_str(&run.text),
                _ => merged.runs.push(run),
            }
        }
        merged
    }

    /// Splits the text into unbreakable pieces; each but the first begins with its blank.
    fn words(&self) -> Vec<Self> {
        let mut words = vec![Self::default()];
        for run in &self.runs {
            for (number, piece) in run.text.split(' ').enumerate() {
                if number > 0 {
                    words.push(Self::default().with(" ", run.kind));
                }
                if let Some(word) = words.last_mut() {
                    *word = std::mem::take(word).with(piece, run.kind);
                }
            }
        }
        words
    }

    fn joined(mut self, other: &Self) -> Self {
        self.runs.extend(other.runs.iter().cloned());
        self.merged()
    }

    fn without_leading_blank(mut self) -> Self {
        if self.runs.first().is_some_and(|run| run.text == " ") {
            self.runs.remove(0);
        }
        self
    }
}

impl From<&str> for Label {
    fn from(text: &str) -> Self {
        Self::default().text(text)
    }
}

impl From<String> for Label {
    fn from(text: String) -> Self {
        Self::default().text(&text)
    }
}

impl TextRun {
    pub(crate) fn size(&self, size: f64) -> f64 {
        if self.kind == RunKind::Index { (size * SUBSCRIPT_SCALE).max(SIZE_MIN) } else { size }
    }

    pub(crate) fn width(&self, size: f64, bold: bool) -> f64 {
        font::width(&self.text, cut(self.kind, bold), self.size(size))
    }
}

const fn cut(kind: RunKind, bold: bool) -> Cut {
    match (kind, bold) {
        (RunKind::Symbol, _) => Cut::Italic,
        (_, true) => Cut::SemiBold,
        (_, false) => Cut::Regular,
    }
}

/// Returns `true` for a character that XML and a single line can contain.
pub(crate) fn is_drawable(c: char) -> bool {
    !quantities::is_unseen(c)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_symbol_has_an_index() {
        let label = Label::symbol("T_max");
        assert_eq!(label.runs.iter().map(|run| run.kind).collect::<Vec<_>>(), [RunKind::Symbol, RunKind::Index]);
        assert_eq!(label.plain(), "T_max");
    }

    #[test]
    fn a_long_text_is_cut_to_its_room() {
        let label = Label::from("A very long label of a check").and_symbol("T_continuous");
        for limit in [0.0, 3.0, 20.0, 60.0, 150.0, 1e4] {
            let cut = label.elided(limit, 12.0, true);
            assert!(cut.width(12.0, true) <= limit, "{limit}");
            assert!(cut.is_empty() || cut == label || cut.plain().ends_with('…'));
        }
        assert!(label.elided(3.0, 12.0, false).is_empty());
    }

    #[test]
    fn lines_are_broken_at_blanks_and_lose_nothing() {
        let label = Label::from("mean input speed of the gear ").and_symbol("n_in");
        let lines = label.wrapped(90.0, 12.0, false);
        assert!(lines.len() > 1);
        let plain: Vec<String> = lines.iter().map(Label::plain).collect();
        assert_eq!(plain.join(" "), "mean input speed of the gear n_in");
        for limit in [12.0, 25.0, 40.0, 70.0] {
            let lines = label.wrapped(limit, 12.0, false);
            assert!(lines.iter().all(|line| line.width(12.0, false) <= limit), "{limit}: {lines:?}");
            let letters = |text: &str| text.replace([' ', '_'], "");
            let found: String = lines.iter().map(|line| letters(&line.plain())).collect();
            assert_eq!(found, letters(&label.plain()));
        }
        let code: Vec<String> =
            Label::from("CHA-25A-100-H-C1024-B").wrapped(70.0, 12.0, true).iter().map(Label::plain).collect();
        assert!(code.len() > 1 && code.iter().rev().skip(1).all(|line| line.ends_with('-')), "{code:?}");
    }

    #[test]
    fn control_characters_become_blanks() {
        assert_eq!(Label::from("a\nb\u{0}c").plain(), "a b c");
    }
}
