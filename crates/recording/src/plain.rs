//! Bulk reader for rows of plain numbers, the most frequent kind of row.

use crate::layout::Role;
use crate::limits::LINE_BYTES_MAX;
use crate::number::plain;
use memchr::{memchr, memchr3_iter, memrchr};

/// Minimum number of bytes from which a second thread saves time.
const SHARED_FROM: usize = 1 << 17;

/// Number of characters of a time up to which it is read as a float: from eight digits on, a tick stores its whole part
/// separately.
const TIME_QUICK: usize = 8;

/// Notation of the rows of a file.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Written<'a> {
    pub(crate) delimiter: u8,
    /// Decimal sign.
    pub(crate) sign: u8,
    /// Line ending.
    pub(crate) end: u8,
    /// Number of cells in each line.
    pub(crate) fields: usize,
    /// Indices of the cells in use, time first.
    pub(crate) wanted: &'a [usize],
}

/// Rows that were read, one number for each cell in use.
#[derive(Debug, Default)]
pub(crate) struct PlainRows {
    pub(crate) numbers: Vec<f64>,
    /// Number of bytes of the rows.
    pub(crate) bytes: usize,
}

/// Parses a cell of time if it is a plain number that an f64 represents without loss. The last digits matter in a time
/// with many digits before the decimal sign.
#[inline]
pub(crate) fn plain_time(cell: &[u8], sign: u8) -> Option<f64> {
    let is_short = cell.len() < TIME_QUICK || cell.get(..TIME_QUICK).is_some_and(|head| head.contains(&sign));
    is_short.then(|| plain(cell, sign)).flatten()
}

impl Written<'_> {
    /// Returns the first of complete lines: as many as `most` bytes hold, at least one.
    pub(crate) fn first<'t>(&self, lines: &'t [u8], most: usize) -> &'t [u8] {
        let Some((head, rest)) = lines.split_at_checked(most) else { return lines };
        let length = memrchr(self.end, head).or_else(|| memchr(self.end, rest).map(|at| head.len() + at));
        length.and_then(|at| lines.get(..=at)).unwrap_or(lines)
    }

    /// Reads complete lines up to the first one that is no row of plain numbers, in two threads; replaces the previous
    /// content of `rows`.
    pub(crate) fn read(&self, lines: &[u8], rows: &mut [PlainRows; 2]) {
        let [first, second] = rows;
        let middle = memrchr(self.end, lines.get(..lines.len() / 2).unwrap_or_default()).map_or(0, |at| at + 1);
        if lines.len() < SHARED_FROM || middle == 0 {
            self.read_one(lines, first);
            return second.clear();
        }
        let (low, high) = lines.split_at(middle);
        let is_done = std::thread::scope(|scope| {
            let other = std::thread::Builder::new().spawn_scoped(scope, || self.read_one(high, second)).ok();
            self.read_one(low, first);
            other.is_some_and(|other| other.join().is_ok())
        });
        if first.bytes < middle {
            second.clear();
        } else if !is_done {
            // The second part is read here if the thread could not be started, as in a browser.
            self.read_one(high, second);
        }
    }

    fn read_one(&self, lines: &[u8], rows: &mut PlainRows) {
        rows.clear();
        let mut row = [0.0; Role::ALL.len()];
        let (mut line, mut cell, mut count, mut found) = (0, 0, 0, 0);
        for at in memchr3_iter(self.delimiter, self.end, b'"', lines) {
            let byte = lines.get(at).copied().unwrap_or(b'"');
            if byte == b'"' {
                return;
            }
            let text = lines.get(cell..at).unwrap_or_default();
            let text = if byte == self.end { text.strip_suffix(b"\r").unwrap_or(text) } else { text };
            for (place, (wanted, number)) in self.wanted.iter().zip(&mut row).enumerate() {
                if *wanted == count {
                    let read = if place == 0 { plain_time(text, self.sign) } else { plain(text, self.sign) };
                    let Some(read) = read else { return };
                    (*number, found) = (read, found + 1);
                }
            }
            (cell, count) = (at + 1, count + 1);
            if byte == self.end {
                let is_row = count == self.fields && found == self.wanted.len();
                if !is_row || at - line > LINE_BYTES_MAX || lines.get(line) == Some(&b'#') {
                    return;
                }
                rows.numbers.extend(row.iter().take(found));
                rows.bytes = at + 1;
                (line, count, found) = (at + 1, 0, 0);
            }
        }
    }
}

impl PlainRows {
    fn clear(&mut self) {
        self.numbers.clear();
        self.bytes = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str, wanted: &[usize]) -> (Vec<f64>, usize) {
        let written = Written { delimiter: b';', sign: b',', end: b'\n', fields: 3, wanted };
        let mut rows = [PlainRows::default(), PlainRows::default()];
        written.read(text.as_bytes(), &mut rows);
        let [first, second] = rows;
        ([first.numbers, second.numbers].concat(), first.bytes + second.bytes)
    }

    #[test]
    fn rows_are_read_up_to_the_first_that_is_not_plain() {
        let good = "0,1;a;-2,5\r\n0,2;;3\n";
        assert_eq!(read(good, &[0, 2]), (vec![0.1, -2.5, 0.2, 3.0], good.len()));
        assert_eq!(read(good, &[2, 0]).0, [-2.5, 0.1, 3.0, 0.2]);
        for stop in [
            "0,3;b\n",
            "0,3;b;1;2\n",
            "#0,3;b;1\n",
            "\n",
            " 0,3;b;1\n",
            "0,3;\"b\";1\n",
            "0.3;b;1\n",
            "0,3;b;1e3\n",
            "12345678;b;1\n",
            "0,3;b;1",
        ] {
            assert_eq!(read(&format!("{good}{stop}"), &[0, 2]).1, good.len(), "{stop}");
        }
        let long = format!("0,3;{};1\n", "b".repeat(LINE_BYTES_MAX));
        assert_eq!(read(&format!("{good}{long}"), &[0, 2]).1, good.len());
    }

    #[test]
    fn two_threads_read_what_one_reads() {
        let row = |k: usize| format!("{k},5;x;{}\n", 3 * k);
        let text: String = (0..40_000).map(row).collect();
        assert!(text.len() > SHARED_FROM);
        let (numbers, bytes) = read(&text, &[0, 2]);
        assert_eq!(bytes, text.len());
        assert!(numbers.chunks(2).enumerate().all(|(k, row)| row == [k as f64 + 0.5, 3.0 * k as f64]));
        // Rows after one that is not plain do not count, in either half.
        for bad in [10, 15_000, 30_000] {
            let text: String = (0..40_000).map(|k| if k == bad { "x;x;x\n".to_owned() } else { row(k) }).collect();
            assert_eq!(read(&text, &[0, 2]).0.len(), 2 * bad);
        }
    }
}
