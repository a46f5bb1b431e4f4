//! Tables for people: aligned columns, units in the head, at most 100 columns wide.

/// Widest line.
pub(crate) const WIDTH: usize = 100;

/// A column is not wrapped to less than this.
const NARROWEST: usize = 18;

/// How a column is aligned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Align {
    Left,
    Right,
}

/// A table of texts.
#[derive(Debug)]
pub(crate) struct Table {
    columns: Vec<(String, Align)>,
    rows: Vec<Vec<String>>,
}

impl Table {
    pub(crate) fn new<const N: usize>(columns: [(&str, Align); N]) -> Self {
        Self { columns: columns.iter().map(|(head, align)| ((*head).to_owned(), *align)).collect(), rows: Vec::new() }
    }

    pub(crate) fn row<const N: usize>(&mut self, cells: [String; N]) {
        self.rows.push(cells.into_iter().collect());
    }

    /// A table with columns that are counted when it is made.
    pub(crate) fn of(columns: Vec<(String, Align)>) -> Self {
        Self { columns, rows: Vec::new() }
    }

    pub(crate) fn push(&mut self, cells: Vec<String>) {
        self.rows.push(cells);
    }

    /// The table as text. Columns on the left are wrapped, the widest first, so that no line is wider than [`WIDTH`].
    pub(crate) fn render(&self) -> String {
        let width = |index: usize| {
            let head = self.columns.get(index).map_or(0, |(head, _)| head.chars().count());
            let cells = self.rows.iter().filter_map(|row| row.get(index)).map(|cell| cell.chars().count());
            cells.max().unwrap_or(0).max(head)
        };
        let mut widths: Vec<usize> = (0..self.columns.len()).map(width).collect();
        let room = WIDTH.saturating_sub(2 * widths.len().saturating_sub(1));
        while widths.iter().sum::<usize>() > room {
            let widest = widths
                .iter_mut()
                .zip(&self.columns)
                .filter(|(width, (_, align))| *align == Align::Left && **width > NARROWEST)
                .max_by_key(|(width, _)| **width);
            match widest {
                Some((width, _)) => *width -= 1,
                None => break,
            }
        }
        let heads: Vec<String> = self.columns.iter().map(|(head, _)| head.clone()).collect();
        let mut out = String::new();
        self.line(&mut out, &heads, &widths);
        let rule: Vec<String> = widths.iter().map(|width| "─".repeat(*width)).collect();
        self.line(&mut out, &rule, &widths);
        for row in &self.rows {
            self.line(&mut out, row, &widths);
        }
        out
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

/// Breaks a text at spaces, and longer words behind a point, a slash or an underscore, so that no line is wider than
/// `width`.
pub(crate) fn wrap(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
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
    lines
}

/// A word in pieces of at most `width` characters; each with whether it belongs to the piece before it.
fn pieces(word: &str, width: usize) -> Vec<(String, bool)> {
    let mut found: Vec<(String, bool)> = Vec::new();
    let mut rest = word;
    while rest.chars().count() > width.max(1) {
        let end = rest.char_indices().nth(width.max(1)).map_or(rest.len(), |(at, _)| at);
        let head = rest.get(..end).unwrap_or(rest);
        let cut = head.rfind(['.', '/', '_']).map_or(end, |at| at + 1);
        let (piece, tail) = rest.split_at(cut);
        found.push((piece.to_owned(), !found.is_empty()));
        rest = tail;
    }
    found.push((rest.to_owned(), !found.is_empty()));
    found
}

/// A paragraph with a hanging indent.
pub(crate) fn paragraph(head: &str, text: &str) -> String {
    let indent = head.chars().count();
    let lines = wrap(text, WIDTH.saturating_sub(indent));
    let mut out = String::new();
    for (index, line) in lines.iter().enumerate() {
        if index == 0 {
            out.push_str(head);
        } else {
            out.push_str(&" ".repeat(indent));
        }
        out.push_str(line);
        out.push('\n');
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_line_is_wider_than_the_width_and_the_last_column_wraps() {
        let mut table = Table::new([("code", Align::Left), ("%", Align::Right), ("reason", Align::Left)]);
        table.row(["CHA-14A-30-E-RES".into(), "120".into(), "word ".repeat(60).trim().into()]);
        let text = table.render();
        assert!(text.lines().all(|line| line.chars().count() <= WIDTH), "{text}");
        assert!(text.lines().count() > 4);
    }

    #[test]
    fn long_words_are_broken_where_they_have_joints() {
        assert_eq!(wrap("project requirements.bearing_life_min", 16), ["project", "requirements.", "bearing_life_min"]);
        assert_eq!(wrap("aaaaaaaaaa", 4), ["aaaa", "aaaa", "aa"]);
        assert_eq!(wrap("", 4), [""]);
    }

    #[test]
    fn numbers_stand_under_each_other() {
        let mut table = Table::new([("n", Align::Right), ("x", Align::Left)]);
        table.row(["9".into(), "a".into()]);
        table.row(["120".into(), "b".into()]);
        assert_eq!(table.render(), "  n  x\n───  ─\n  9  a\n120  b\n");
    }
}
