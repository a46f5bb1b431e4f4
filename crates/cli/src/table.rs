//! Tables and paragraphs for readers: aligned columns, units in the heading, no line wider than the terminal.

use quantities::Unit;
use std::io::IsTerminal;
use std::sync::OnceLock;
use words::{is_vowel, stands_before_a_number};

/// Width without a terminal.
const USUAL: usize = 100;

/// Permissible widths of a terminal.
const NARROWEST_TERMINAL: usize = 60;
const WIDEST_TERMINAL: usize = 200;

/// Smallest width to which a column is wrapped.
const NARROWEST: usize = 14;

/// Smallest width of the last of several columns if it is text; a narrower one is placed below its row.
const NARROWEST_WORDS: usize = 30;

/// A blank at which a line is not broken; printed as a blank.
const NO_BREAK: char = '\u{a0}';

/// Returns the largest line width: the variable `COLUMNS`, else the terminal, within limits; 100 without a terminal.
pub(crate) fn width() -> usize {
    static WIDTH: OnceLock<usize> = OnceLock::new();
    *WIDTH.get_or_init(|| {
        let stated = std::env::var("COLUMNS").ok().and_then(|columns| columns.trim().parse::<usize>().ok());
        let terminal = || {
            let asked = std::io::stdout().is_terminal().then(terminal_size::terminal_size).flatten();
            asked.map(|(columns, _)| usize::from(columns.0))
        };
        let found = stated.filter(|columns| *columns > 0).or_else(terminal);
        found.map_or(USUAL, |columns| columns.clamp(NARROWEST_TERMINAL, WIDEST_TERMINAL))
    })
}

/// Alignment of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Align {
    Left,
    Right,
}

/// A table of texts.
#[derive(Debug)]
pub(crate) struct TextTable {
    columns: Vec<(String, Align)>,
    rows: Vec<Vec<String>>,
}

impl TextTable {
    pub(crate) fn new<H: Into<String>>(columns: impl IntoIterator<Item = (H, Align)>) -> Self {
        Self { columns: columns.into_iter().map(|(head, align)| (head.into(), align)).collect(), rows: Vec::new() }
    }

    pub(crate) fn row(&mut self, cells: impl Into<Vec<String>>) {
        self.rows.push(cells.into());
    }

    /// Returns the table as text, no line wider than the terminal.
    pub(crate) fn render(&self) -> String {
        self.render_to(width())
    }

    /// Returns the table in a width. Columns on the left are wrapped, the widest first; if that is not enough, the last
    /// columns are placed below their row, each with its heading.
    fn render_to(&self, most: usize) -> String {
        let widest = |index: usize| {
            let head = self.columns.get(index).map_or(0, |(head, _)| head.chars().count());
            let cells = self.rows.iter().filter_map(|row| row.get(index)).map(|cell| cell.chars().count());
            cells.max().unwrap_or(0).max(head)
        };
        let mut widths: Vec<usize> = (0..self.columns.len()).map(widest).collect();
        loop {
            let room = most.saturating_sub(2 * widths.len().saturating_sub(1));
            let floors: Vec<usize> = (0..widths.len()).map(|index| self.floor(index)).collect();
            let least: usize = widths.iter().zip(&floors).map(|(width, floor)| *width.min(floor)).sum();
            if least <= room || widths.len() <= 1 {
                shrink(&mut widths, &floors, room);
                break;
            }
            widths.pop();
        }
        let heads: Vec<String> = self.columns.iter().take(widths.len()).map(|(head, _)| head.clone()).collect();
        let mut out = String::new();
        self.line(&mut out, &heads, &widths);
        // A single column below its rows has its heading below theirs; of several, each has its own.
        let single = self.columns.len() == widths.len() + 1;
        if let Some((head, _)) = self.columns.last().filter(|_| single) {
            out.push_str(&paragraph_to("    ", head, most));
        }
        let rule: Vec<String> = widths.iter().map(|width| "─".repeat(*width)).collect();
        self.line(&mut out, &rule, &widths);
        for row in &self.rows {
            self.line(&mut out, row, &widths);
            let below = self.columns.iter().zip(row).skip(widths.len());
            let below = below.filter(|(_, cell)| !cell.is_empty() && *cell != "–");
            let cell_text = |head: &str, cell: &str| if single { cell.to_owned() } else { format!("{head}: {cell}") };
            let below: Vec<String> = below.map(|((head, _), cell)| cell_text(head, cell)).collect();
            if !below.is_empty() {
                out.push_str(&paragraph_to("    ", &below.join(" · "), most));
            }
        }
        out
    }

    /// Returns the width below which a column is not wrapped; numbers are not wrapped, only their headings, nor are
    /// ordering codes, whose first part alone would read as another code.
    fn floor(&self, index: usize) -> usize {
        let words = index > 3 && index + 1 == self.columns.len();
        let cells = self.rows.iter().filter_map(|row| row.get(index));
        let narrowest = match self.columns.get(index) {
            Some((_, Align::Left)) if words => NARROWEST_WORDS,
            Some((_, Align::Left)) => NARROWEST,
            Some((head, Align::Right)) => {
                return head
                    .split(' ')
                    .chain(cells.map(String::as_str))
                    .map(|text| text.chars().count())
                    .max()
                    .unwrap_or(0);
            }
            None => return usize::MAX,
        };
        let codes = cells.flat_map(|cell| cell.split([' ', ','])).filter(|word| is_code(word));
        codes.map(|code| code.chars().count()).fold(narrowest, usize::max)
    }

    fn line(&self, out: &mut String, cells: &[String], widths: &[usize]) {
        let wrapped: Vec<Vec<String>> = cells.iter().zip(widths).map(|(cell, width)| wrap(cell, *width)).collect();
        let height = wrapped.iter().map(Vec::len).max().unwrap_or(0);
        for index in 0..height {
            let mut line = String::new();
            for (column, ((_, align), (parts, width))) in
                self.columns.iter().zip(wrapped.iter().zip(widths)).enumerate()
            {
                let text = parts.get(index).map_or("", String::as_str);
                let pad = " ".repeat(width.saturating_sub(text.chars().count()));
                if column > 0 {
                    line.push_str("  ");
                }
                match align {
                    Align::Left => {
                        line.push_str(text);
                        line.push_str(&pad);
                    }
                    Align::Right => {
                        line.push_str(&pad);
                        line.push_str(text);
                    }
                }
            }
            out.push_str(line.trim_end());
            out.push('\n');
        }
    }
}

/// Returns `true` for a word in the form of an ordering code: three or more hyphens between capitals and digits.
fn is_code(word: &str) -> bool {
    let is_sign = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '-';
    word.matches('-').count() > 2 && word.chars().all(is_sign)
}

/// Narrows columns, the widest first and none below its minimum, until all of them fit.
fn shrink(widths: &mut [usize], floors: &[usize], room: usize) {
    while widths.iter().sum::<usize>() > room {
        let wide = widths.iter_mut().zip(floors).filter(|(width, floor)| **width > **floor);
        match wide.max_by_key(|(width, _)| **width) {
            Some((width, _)) => *width -= 1,
            None => break,
        }
    }
}

/// Breaks a text at blanks so that no line is wider than `width`. A number and its unit stay together; a word longer
/// than a line is broken at a joint, else with a hyphen.
pub(crate) fn wrap(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    let text = kept_together(text);
    for word in text.split(' ').flat_map(|word| pieces(word, width)) {
        let (piece, glued) = word;
        let Some(line) = lines.last_mut() else { continue };
        let used = line.chars().count();
        let gap = usize::from(used > 0 && !glued);
        if used + gap + piece.chars().count() <= width || used == 0 {
            if gap > 0 {
                line.push(' ');
            }
            line.push_str(&piece);
        } else {
            lines.push(piece);
        }
    }
    lines.iter().map(|line| line.trim_end().replace(NO_BREAK, " ")).collect()
}

/// Returns `true` if a word begins with a unit, before parentheses, marks or a further operation.
fn begins_with_unit(word: &str) -> bool {
    let head = word.trim_start_matches('(').split(['(', ')', '[', ']', '|', ',', ';', ':', '·']).next();
    let head = head.unwrap_or_default().trim_end_matches(['/', '.']);
    let is_number = head.starts_with(|c: char| c.is_ascii_digit()) && !head.contains('/');
    !is_number && (matches!(head, "%" | "Umdr" | "U/s" | "U/s²") || Unit::of(head).is_some())
}

/// Returns `true` if a word ends with a number, such as `3,5`, `(−2·10³` or `cos(0,5`.
fn ends_with_number(word: &str) -> bool {
    let tail = word.rsplit(['(', '[', '|', '√', '−', '-', '±', '≥', '≤', '~', '–']).next().unwrap_or_default();
    tail.starts_with(|c: char| c.is_ascii_digit())
        && tail.chars().all(|c| c.is_ascii_digit() || "⁰¹²³⁴⁵⁶⁷⁸⁹⁻·,./".contains(c))
        && !tail.ends_with([',', '.', '/'])
}

/// Returns `true` if a word is the next group of three digits of a number in groups, such as `10 000`.
fn is_group(before: &str, word: &str) -> bool {
    let digits = |text: &str| text.chars().take_while(char::is_ascii_digit).count();
    let head = before.trim_start_matches(['(', '−']);
    let rest = word.trim_start_matches(|c: char| c.is_ascii_digit());
    (1..=3).contains(&digits(head))
        && digits(head) == head.len()
        && digits(word) == 3
        && !rest.starts_with(|c: char| c.is_alphanumeric() || c == '-' || c == '.')
}

/// Returns the text with no-break blanks between a number and its unit, within a number in groups of three digits, and between
/// "table" and its number.
fn kept_together(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut before = "";
    for (index, word) in text.split(' ').enumerate() {
        if index > 0 {
            let unit = ends_with_number(before) && begins_with_unit(word);
            let sign = matches!(before, "≥" | "≤" | "×" | "i" | "=");
            let number = word.starts_with(|c: char| c.is_ascii_digit() || c == '−');
            let numbered = number && (sign || stands_before_a_number(before.trim_start_matches('(')));
            let is_ratio = before == "i" && word == "=";
            let held = unit || numbered || is_ratio || is_group(before, word);
            out.push(if held { NO_BREAK } else { ' ' });
        }
        out.push_str(word);
        before = word;
    }
    out
}

/// Splits a word into pieces of at most `width` characters; each with `true` if it is joined to the piece before it.
fn pieces(word: &str, width: usize) -> Vec<(String, bool)> {
    let mut found: Vec<(String, bool)> = Vec::new();
    let mut rest = word;
    while rest.chars().count() > width.max(2) {
        let end = |count: usize| rest.char_indices().nth(count).map_or(rest.len(), |(at, _)| at);
        let head = rest.get(..end(width.max(2))).unwrap_or(rest);
        // A number is separated from its unit before it is split.
        let joint = head.rfind(NO_BREAK).map(|at| (at, at + NO_BREAK.len_utf8(), false));
        let joint = joint.or_else(|| head.rfind(['.', '/', '_', '-']).map(|at| (at + 1, at + 1, true)));
        if let Some((cut, next, glued_on)) = joint.filter(|(cut, ..)| *cut > 0) {
            let glued = !found.is_empty();
            found.push((rest.get(..cut).unwrap_or_default().to_owned(), glued));
            rest = rest.get(next..).unwrap_or_default();
            if !glued_on {
                found.extend(pieces(rest, width));
                return found;
            }
            continue;
        }
        let cut = end(syllable(rest, width.max(2)));
        let (piece, tail) = rest.split_at(cut);
        found.push((format!("{piece}-"), !found.is_empty()));
        rest = tail;
    }
    found.push((rest.to_owned(), !found.is_empty()));
    found
}

/// Returns the number of letters of a word too long for its line that stay before a hyphen: up to the joint of a
/// compound, else up to a consonant followed by a vowel.
fn syllable(word: &str, width: usize) -> usize {
    let letters: Vec<char> = word.chars().take(width + 1).collect();
    let most = width.saturating_sub(1).max(1);
    if let Some(joint) = last_joint(word, most) {
        return joint;
    }
    let vowel = |at: usize| letters.get(at).copied().is_some_and(is_vowel);
    let pair = |at: usize| {
        let two: String = letters.iter().skip(at.saturating_sub(1)).take(2).collect();
        matches!(two.as_str(), "ch" | "ck" | "sh" | "sp" | "st" | "th" | "ph" | "qu")
    };
    let fits = |at: &usize| !vowel(*at) && vowel(*at + 1) && !pair(*at);
    (3..=most).rev().find(fits).unwrap_or(most)
}

/// Returns the number of letters before the last joint of a compound, at least three and at most `most`.
fn last_joint(word: &str, most: usize) -> Option<usize> {
    let (mut letters, mut found) = (0, None);
    for sign in words::hyphenated(word).chars() {
        match sign {
            '\u{ad}' if (3..=most).contains(&letters) => found = Some(letters),
            '\u{ad}' => {}
            _ => letters += 1,
        }
    }
    found
}

/// Returns a paragraph behind a label.
pub(crate) fn labelled(label: &str, text: &str) -> String {
    paragraph(&format!("{label}: "), text)
}

/// Returns a paragraph with a hanging indent, no line wider than the terminal.
pub(crate) fn paragraph(head: &str, text: &str) -> String {
    paragraph_to(head, text, width())
}

/// Returns an indented paragraph whose further lines are indented more.
pub(crate) fn hanging(indent: &str, text: &str) -> String {
    hung(indent, &format!("{indent}    "), text, width())
}

/// Returns a paragraph with one prefix for its first line and another for the further ones.
fn hung(first: &str, further: &str, text: &str, most: usize) -> String {
    let mut out = String::new();
    for (index, line) in wrap(text, most.saturating_sub(further.chars().count())).iter().enumerate() {
        out.push_str(if index == 0 { first } else { further });
        out.push_str(line);
        out.push('\n');
    }
    out
}

/// Largest length of a heading that sets the indent of its text.
const INDENT_MOST: usize = 30;

fn paragraph_to(head: &str, text: &str, most: usize) -> String {
    let long = head.chars().count() > INDENT_MOST;
    let blank = head.chars().take_while(|c| *c == ' ').count();
    // A longer heading begins the text; further lines are indented by two blanks.
    if long {
        let text = format!("{}{text}", head.trim_start_matches(' '));
        return hung(&" ".repeat(blank), &" ".repeat(blank + 2), &text, most);
    }
    hung(head, &" ".repeat(head.chars().count()), text, most)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_line_is_wider_than_the_terminal_whatever_its_width() {
        let mut table = TextTable::new([
            ("check", Align::Left),
            ("verdict", Align::Left),
            ("value", Align::Right),
            ("limit", Align::Right),
            ("unit", Align::Left),
            ("util. %", Align::Right),
            ("at s", Align::Right),
            ("grade, source of the limit", Align::Left),
        ]);
        let source = "estimated, model thermal and a very long word Zwischenkreisspannungsüberwachungsfunktion";
        let row = ["winding temperature", "not checked", "1234.5", "2345.6", "min⁻¹", "104.5", "0.123", source];
        table.row(row.map(str::to_owned));
        for width in 60..=200 {
            let text = table.render_to(width);
            assert!(text.lines().all(|line| line.chars().count() <= width), "{width}:\n{text}");
            let letters = |text: &str| text.replace([' ', '\n', '-'], "");
            assert!(letters(&text).contains("winding"), "{text}");
        }
        assert!(table.render_to(60).contains("grade, source of the limit: "));
        assert!(!table.render_to(200).contains("limit: "));
    }

    #[test]
    fn a_number_keeps_its_unit_and_a_table_its_number() {
        // A table and its number have thirteen letters here.
        for width in 13..60 {
            for line in
                wrap("the winding reaches 80.5 °C after 12 min (table 12.1), with 3 Nm at i = 100; so it is", width)
            {
                let end = line.split(' ').next_back().unwrap_or_default();
                assert!(!["80.5", "12", "(table", "3", "="].contains(&end), "{width}: {line}");
            }
        }
    }

    /// The units of formulas with values, which begin and end at parentheses, bars and strokes.
    #[test]
    fn a_number_in_a_formula_keeps_its_unit() {
        let text = "cos(3,6356 rad − (−3,78846 rad))/(0,35 m · |24,97 min⁻¹|) + 10 000 Umdr. · 1,08·10⁻⁵ kgm²/(0,12 m)";
        let tied =
            ["3,6356 rad", "(−3,78846 rad))/(0,35 m", "|24,97 min⁻¹|)", "10 000 Umdr.", "1,08·10⁻⁵ kgm²/(0,12 m)"];
        for width in 30..120 {
            let lines = wrap(text, width);
            for tied in tied {
                assert!(lines.iter().any(|line| line.contains(tied)), "{width}: {tied} in {lines:?}");
            }
        }
        // No unit of the number before it.
        for text in ["size 14 and 17", "K_1 m", "T_1 Nm", "3, m", "table 12 2345"] {
            assert!(
                !kept_together(text).contains(&format!("{NO_BREAK}{}", text.rsplit(' ').next().unwrap())),
                "{text}"
            );
        }
    }

    /// The first part of an ordering code would read as another code.
    #[test]
    fn ordering_codes_are_never_broken() {
        let heads = ["#", "code", "util. %", "governing check", "T_rms Nm", "remark"].map(str::to_owned);
        let columns = heads
            .into_iter()
            .enumerate()
            .map(|(place, head)| (head, if [0, 2, 4].contains(&place) { Align::Right } else { Align::Left }));
        let mut table = TextTable::new(columns.collect::<Vec<_>>());
        for code in ["CHA-17A-120-H-RES-B", "CHA-20A-100-H-C1024-B-EC-K"] {
            table.row(["1", code, "72.2", "torque-speed trace", "18.16", "advice: inertia ratio"].map(str::to_owned));
        }
        for most in 30..140 {
            let text = table.render_to(most);
            assert!(text.contains("CHA-17A-120-H-RES-B") && text.contains("CHA-20A-100-H-C1024-B-EC-K"), "{text}");
        }
    }

    #[test]
    fn long_words_are_broken_at_joints_or_with_a_hyphen() {
        assert_eq!(wrap("project requirements.bearing_life_min", 16), ["project", "requirements.", "bearing_life_min"]);
        assert_eq!(wrap("CHA-25A-100-H-C1024-B", 12), ["CHA-25A-100-", "H-C1024-B"]);
        assert_eq!(wrap("Zwischenkreisspannung", 18), ["Zwischenkreis-", "spannung"]);
        assert_eq!(wrap("Stillstandsstrom, effektiv", 16), ["Stillstands-", "strom, effektiv"]);
        assert_eq!(wrap("aaaaaaaaaa", 4), ["aaa-", "aaa-", "aaaa"]);
        assert_eq!(wrap("", 4), [""]);
    }

    #[test]
    fn a_long_head_begins_its_paragraph() {
        let text = paragraph_to("a head that is so long that nothing could hang from it: ", "and a text behind it", 60);
        assert_eq!(text, "a head that is so long that nothing could hang from it:\n  and a text behind it\n");
        assert_eq!(paragraph_to("note: ", "one two", 9), "note: one\n      two\n");
    }

    #[test]
    fn numbers_stand_under_each_other() {
        let mut table = TextTable::new([("n", Align::Right), ("x", Align::Left)]);
        table.row(["9".into(), "a".into()]);
        table.row(["120".into(), "b".into()]);
        assert_eq!(table.render(), "  n  x\n───  ─\n  9  a\n120  b\n");
    }
}
