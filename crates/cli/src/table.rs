//! Tables for people: aligned columns, units in the head, at most 100 columns wide.

/// Widest line.
pub(crate) const WIDTH: usize = 100;

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

    pub(crate) fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The table as text. A last column on the left is wrapped so that no line is wider than [`WIDTH`].
    pub(crate) fn render(&self) -> String {
        let width = |index: usize| {
            let head = self.columns.get(index).map_or(0, |(head, _)| head.chars().count());
            let cells = self.rows.iter().filter_map(|row| row.get(index)).map(|cell| cell.chars().count());
            cells.max().unwrap_or(0).max(head)
        };
        let mut widths: Vec<usize> = (0..self.columns.len()).map(width).collect();
        let gaps = 2 * widths.len().saturating_sub(1);
        if let Some((last, others)) = widths.split_last_mut() {
            let room = WIDTH.saturating_sub(others.iter().sum::<usize>() + gaps);
            *last = (*last).min(room.max(20));
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
        let last = cells.len().saturating_sub(1);
        let wrapped = wrap(cells.last().map_or("", String::as_str), widths.last().copied().unwrap_or(WIDTH));
        for (index, part) in wrapped.iter().enumerate() {
            let mut line = String::new();
            for (column, cell) in cells.iter().enumerate() {
                let text = match (column == last, index) {
                    (true, _) => part.as_str(),
                    (false, 0) => cell.as_str(),
                    (false, _) => "",
                };
                let width = widths.get(column).copied().unwrap_or(0);
                let pad = " ".repeat(width.saturating_sub(text.chars().count()));
                let left = self.columns.get(column).is_none_or(|(_, align)| *align == Align::Left);
                if column > 0 {
                    line.push_str("  ");
                }
                if left {
                    line.push_str(text);
                    line.push_str(&pad);
                } else {
                    line.push_str(&pad);
                    line.push_str(text);
                }
            }
            out.push_str(line.trim_end());
            out.push('\n');
        }
    }
}

/// Breaks a text at spaces so that no line is wider than `width`; a longer word keeps its line.
pub(crate) fn wrap(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let Some(line) = lines.last_mut() else { continue };
        let used = line.chars().count();
        if used == 0 {
            line.push_str(word);
        } else if used + 1 + word.chars().count() <= width {
            line.push(' ');
            line.push_str(word);
        } else {
            lines.push(word.to_owned());
        }
    }
    lines
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
    fn numbers_stand_under_each_other() {
        let mut table = Table::new([("n", Align::Right), ("x", Align::Left)]);
        table.row(["9".into(), "a".into()]);
        table.row(["120".into(), "b".into()]);
        assert_eq!(table.render(), "  n  x\n───  ─\n  9  a\n120  b\n");
    }
}
