//! Text without rows: how far it is read.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use recording::{BLANK_BYTES_MAX, Fault, Layout, Limit, Records, read_csv};
use std::io::Read;

/// Text, then a pattern for 1 GiB, then text; counts the bytes read.
struct Bomb<'a> {
    parts: [&'a [u8]; 2],
    pattern: &'a [u8],
    left: u64,
    read: std::rc::Rc<std::cell::Cell<u64>>,
}

impl Read for Bomb<'_> {
    fn read(&mut self, room: &mut [u8]) -> std::io::Result<usize> {
        let [before, after] = &mut self.parts;
        let count = if !before.is_empty() {
            before.read(room)?
        } else if self.left > 0 {
            let count = room.len().min(usize::try_from(self.left).unwrap()) / self.pattern.len() * self.pattern.len();
            room[..count].chunks_mut(self.pattern.len()).for_each(|chunk| chunk.copy_from_slice(self.pattern));
            self.left -= count as u64;
            count
        } else {
            after.read(room)?
        };
        self.read.set(self.read.get() + count as u64);
        Ok(count)
    }
}

/// Empty lines, comments and one long line, as a packed file holds a gigabyte of them in a megabyte, are read up to their limit before the
/// heading, below it and between the rows, by every reader; a few megabytes do no harm.
#[test]
fn a_text_of_nothing_is_not_read_to_its_end() {
    const SMALL: u64 = BLANK_BYTES_MAX - 4096;
    let (head, rows) = ("t [s],q [deg]\n", "0,0\n1,1\n2,2\n");
    let places = [
        (String::new(), format!("{head}{rows}")),
        (head.to_owned(), rows.to_owned()),
        (format!("{head}{rows}"), "3,3\n".to_owned()),
    ];
    let patterns = ["\n\n\n\n\n\n\n\n", "\r\n  \r\n ", "#\n# 4567\n", "# no end", "        "];
    for (before, after) in &places {
        for pattern in patterns {
            for bytes in [SMALL, 1 << 30] {
                if bytes == SMALL && !pattern.contains('#') {
                    continue;
                }
                let read = std::rc::Rc::new(std::cell::Cell::new(0));
                let bomb = || {
                    read.set(0);
                    let parts = [before.as_bytes(), after.as_bytes()];
                    let left = bytes / pattern.len() as u64 * pattern.len() as u64;
                    Bomb { parts, pattern: pattern.as_bytes(), left, read: std::rc::Rc::clone(&read) }
                };
                let context = format!("{before:?} {pattern:?} {bytes}");
                let is_line = !pattern.contains('\n');
                let is_bomb = bytes > BLANK_BYTES_MAX;
                let most = BLANK_BYTES_MAX + (2 << 20);
                match read_csv(bomb(), &Layout::default()) {
                    Ok(recording) => assert!(!is_bomb && !is_line && recording.time_s.len() >= 3, "{context}"),
                    Err(faults) if is_line => {
                        assert!(matches!(faults.as_slice(), [Fault::LineTooLong { .. }, ..]), "{context}: {faults:?}");
                    }
                    Err(faults) => {
                        let beyond = |fault: &Fault| matches!(fault, Fault::Beyond { limit: Limit::BlankBytes, .. });
                        assert!(is_bomb && faults.iter().any(beyond), "{context}: {faults:?}");
                    }
                }
                assert!(read.get() < most, "{context}: {} bytes of a recording", read.get());
                if before.is_empty() {
                    let _ = recording::preview_csv(bomb(), 10);
                    assert!(read.get() < most, "{context}: {} bytes of a preview", read.get());
                }
                let last = Records::open(bomb()).and_then(|mut records| {
                    loop {
                        match records.advance() {
                            Ok(true) | Err(Fault::LineTooLong { .. }) => {}
                            Ok(false) => return Ok(()),
                            Err(fault) => return Err(fault),
                        }
                    }
                });
                assert!(read.get() < most, "{context}: {} bytes of a table", read.get());
                let is_refused =
                    matches!(last, Err(Fault::Beyond { limit: Limit::BlankBytes, .. } | Fault::LineTooLong { .. }));
                assert!(is_refused || !is_bomb, "{context}: {last:?}");
            }
        }
    }
}
