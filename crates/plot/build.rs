//! Extracts the widths of characters from the fonts, so that layout alone needs no outlines.
#![allow(clippy::print_stdout, reason = "cargo listens")]
#![allow(clippy::disallowed_methods, reason = "a build script runs before the program and has the disk from cargo")]

use std::path::PathBuf;
use std::{env, fs, io};

/// Font tables with the widths of characters.
const TABLES: [&[u8; 4]; 5] = [b"cmap", b"head", b"hhea", b"hmtx", b"maxp"];

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed=fonts");
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default());
    for name in ["Inter-Regular.ttf", "Inter-Italic.ttf", "Inter-SemiBold.ttf"] {
        let whole = fs::read(PathBuf::from("fonts").join(name))?;
        let widths = widths(&whole).ok_or_else(|| io::Error::other(format!("{name} is no TrueType file")))?;
        fs::write(out.join(name), widths)?;
    }
    Ok(())
}

/// Returns the font file with these tables alone: its header, an entry of 16 bytes for each table, the tables.
fn widths(whole: &[u8]) -> Option<Vec<u8>> {
    let number = |at: usize| Some(u32::from_be_bytes(whole.get(at..at + 4)?.try_into().ok()?) as usize);
    let count = usize::from(u16::from_be_bytes(whole.get(4..6)?.try_into().ok()?));
    let magic = whole.get(..4)?;
    let mut entries = Vec::new();
    let mut body = Vec::new();
    let first = 12 + 16 * TABLES.len();
    for entry in (0..count).map(|index| 12 + 16 * index) {
        let name = whole.get(entry..entry + 4)?;
        if !TABLES.iter().any(|table| *table == name) {
            continue;
        }
        let (from, length) = (number(entry + 8)?, number(entry + 12)?);
        entries.extend_from_slice(whole.get(entry..entry + 8)?);
        entries.extend_from_slice(&u32::try_from(first + body.len()).ok()?.to_be_bytes());
        entries.extend_from_slice(&u32::try_from(length).ok()?.to_be_bytes());
        body.extend_from_slice(whole.get(from..from + length)?);
        body.resize(body.len().next_multiple_of(4), 0);
    }
    let tables = u16::try_from(TABLES.len()).ok()?.to_be_bytes();
    (entries.len() == first - 12).then(|| [magic, &tables, &[0; 6], &entries, &body].concat())
}
