//! Files that are packed as a whole, gzip or Zstandard: in members and frames, cut off, changed, packed twice, other archives.

use crate::recorded::{self, edit_bytes};
use crate::text::any_edits;
use crate::{run, table};
use arbitrary::{Result, Unstructured};
use std::io::Write as _;

/// First bytes of files that are no recording, and of packings that are not read.
const FOREIGN: [&[u8]; 8] = [
    b"PK\x03\x04",
    b"\x1f\x8b",
    b"\x28\xb5\x2f\xfd",
    b"\x89HDF\r\n\x1a\n",
    b"BZh9",
    b"\xfd7zXZ\0",
    b"PAR1",
    b"\x04\x22\x4d\x18",
];

/// Repeated bytes behind a file: small when packed, larger than the file when read.
const REPEATED_MOST: u32 = 1 << 22;

/// A recording, a run or a table in its packing: read or refused.
pub fn run(data: &[u8]) {
    let Ok(made) = made(&mut Unstructured::new(data)) else { return };
    match made.entry {
        Entry::Recording => recorded::hold_recording(&made.project, &made.bytes),
        Entry::Run => run::hold(&made.bytes),
        Entry::Table => table::hold(&made.bytes),
    }
}

/// The file and what reads it.
pub fn shown(data: &[u8]) -> String {
    made(&mut Unstructured::new(data))
        .map(|made| format!("{:?}\n{}---\n{}", made.entry, made.project, made.bytes.escape_ascii()))
        .unwrap_or_default()
}

/// Reader of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Entry {
    Recording,
    Run,
    Table,
}

struct Made {
    entry: Entry,
    project: String,
    bytes: Vec<u8>,
}

fn made(u: &mut Unstructured<'_>) -> Result<Made> {
    let entry = *u.choose(&[Entry::Recording, Entry::Recording, Entry::Run, Entry::Table])?;
    let name = *u.choose(&["run.csv", "run.csv.gz", "run.txt.zst", "run.parquet", "run.parquet.gzip"])?;
    let (project, mut plain) = match entry {
        Entry::Recording => recorded::made(u, name)?,
        Entry::Run => (String::new(), run::made(u)?),
        Entry::Table => (String::new(), table::made(u)?),
    };
    if u.ratio(1, 8)? {
        let (sign, count) = (*u.choose(b"\n0,\"#")?, u.int_in_range(0..=REPEATED_MOST)?);
        plain.extend(std::iter::repeat_n(sign, count as usize));
    }
    let mut bytes = parts(u, &plain)?;
    if u.ratio(1, 12)? {
        bytes = parts(u, &bytes)?;
    }
    if u.ratio(1, 3)? {
        bytes = edit_bytes(bytes, &any_edits(u, 6)?);
    }
    match u.int_in_range(0..=11)? {
        0 => bytes.truncate(u.int_in_range(0..=bytes.len())?),
        1 => bytes.extend_from_slice(u.bytes(u.len().min(32))?),
        2 => bytes.splice(0..0, u.choose(&FOREIGN)?.iter().copied()).for_each(drop),
        // The bytes are the file behind a mark that is read.
        3 => bytes = [*u.choose(&FOREIGN)?, u.bytes(u.len())?].concat(),
        _ => {}
    }
    Ok(Made { entry, project, bytes })
}

/// A file as some members or frames, one behind the other.
fn parts(u: &mut Unstructured<'_>, plain: &[u8]) -> Result<Vec<u8>> {
    let (is_gzip, count) = (u.ratio(1, 2)?, u.int_in_range(1..=3_usize)?);
    let mut bytes = Vec::new();
    for part in plain.chunks(plain.len().div_ceil(count).max(1)) {
        if is_gzip {
            let level = flate2::Compression::new(*u.choose(&[0, 1, 6])?);
            let mut packer = flate2::GzBuilder::new().filename(*u.choose(&["", "run.csv"])?).write(Vec::new(), level);
            let packed = packer.write_all(part).and_then(|()| packer.finish());
            bytes.extend(packed.unwrap_or_default());
        } else {
            if u.ratio(1, 4)? {
                // A frame to be passed over, that claims its length.
                let claimed = *u.choose(&[0_u32, 3, 3, u32::MAX])?;
                bytes.extend_from_slice(b"\x50\x2a\x4d\x18");
                bytes.extend(claimed.to_le_bytes());
                bytes.extend_from_slice(b"abc");
            }
            bytes.extend(zstd::bulk::compress(part, *u.choose(&[-1, 1, 3])?).unwrap_or_default());
        }
    }
    Ok(bytes)
}
