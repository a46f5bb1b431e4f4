//! Number of the rows of a text before it is read.

use crate::faults::Fault;
use crate::layout::Layout;
use crate::limits::{Limit, ROWS_MAX, SAMPLES_MAX};
use crate::memory::Memory;
use memchr::memchr_iter;
use std::io::Read;

/// Number of bytes of the shortest row, `0,0` with its end.
const ROW_BYTES_LEAST: u64 = 4;

/// Number of lines that may be none of a row without a comment sign: lines about the file, headings, units.
const OTHER_LINES_MOST: u64 = 1000;

/// Number of bytes read at a time.
const PIECE: usize = 1 << 18;

/// Returns an error if a text of `size` bytes has more rows than are read or kept, at `sample_bytes` bytes of memory each.
///
/// Lines are counted without being read, and only of a text that is long enough. Of a window an unknown share is kept, so that only
/// the number of rows counts.
///
/// # Errors
/// [`Fault::TooManySamples`]; [`Fault::Beyond`] the rows of a file or the memory.
pub fn refuse_long(
    source: impl Read,
    size: u64,
    layout: &Layout,
    (memory, sample_bytes): (&Memory, u64),
) -> Result<(), Fault> {
    let has_window = layout.from.is_some() || layout.to.is_some();
    let most = if has_window { ROWS_MAX } else { SAMPLES_MAX as u64 };
    let kept = if has_window { most } else { most.min(memory.left() / sample_bytes.max(1)) };
    if size / ROW_BYTES_LEAST <= kept {
        return Ok(());
    }
    let rows = rows_up_to(source, most + OTHER_LINES_MOST + 1).saturating_sub(OTHER_LINES_MOST);
    match has_window {
        true => Limit::Rows.hold(rows, most),
        false if rows > most => Err(Fault::too_many_samples()),
        false => memory.clone().take(rows.saturating_mul(sample_bytes)),
    }
}

/// Returns the number of lines that are neither empty nor comments, at most `most`; those of a source that ends with an error as far
/// as it is read.
fn rows_up_to(mut source: impl Read, most: u64) -> u64 {
    let mut piece = vec![0; PIECE];
    let (mut rows, mut is_start) = (0, true);
    while rows < most {
        let Ok(count @ 1..) = source.read(&mut piece) else { break };
        let read = piece.get(..count).unwrap_or_default();
        let is_row = |first: Option<&u8>| first.is_some_and(|first| !matches!(first, b'\n' | b'\r' | b'#'));
        rows += u64::from(is_start && is_row(read.first()));
        rows += memchr_iter(b'\n', read).filter(|end| is_row(read.get(end + 1))).count() as u64;
        is_start = read.last() == Some(&b'\n');
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::{Measure, Time};

    fn refused(rows: u64, memory: u64, layout: &Layout) -> Option<Fault> {
        let text = "# about\n\nt [s],q [deg]\n".to_owned() + &"0,0\n".repeat(usize::try_from(rows).unwrap());
        let memory = Memory::new(memory);
        refuse_long(text.as_bytes(), text.len() as u64, layout, (&memory, 48)).err()
    }

    #[test]
    fn lines_are_counted_at_any_border_of_a_piece() {
        for (text, rows) in [("", 0), ("a", 1), ("a\n", 1), ("a\nb", 2), ("#a\n\n\r\nb\r\nc\n", 2)] {
            assert_eq!(rows_up_to(text.as_bytes(), 100), rows, "{text:?}");
        }
        let text = "1,2\n#\n".repeat(PIECE);
        assert_eq!(rows_up_to(text.as_bytes(), u64::MAX), PIECE as u64);
        assert!(rows_up_to(std::io::repeat(b'\n'), 0) == 0);
    }

    #[test]
    fn more_rows_than_are_kept_are_refused_by_their_number() {
        let (plain, window) = (Layout::default(), Layout { from: Some(Time::from_si(1.0)), ..Layout::default() });
        assert_eq!(refused(10_000, 48 * 10_000, &plain), None);
        assert!(matches!(refused(12_000, 48 * 10_000, &plain), Some(Fault::Beyond { limit: Limit::Memory, .. })));
        assert_eq!(refused(12_000, 48 * 10_000, &window), None, "an unknown share of a window is kept");
        let all = SAMPLES_MAX as u64;
        for memory in [48 * 10_000, u64::MAX] {
            assert_eq!(refused(all + 2000, memory, &plain), Some(Fault::too_many_samples()));
        }
        assert_eq!(refused(all, u64::MAX, &plain), None);
    }
}
