//! Names of files that are recordings.

/// Extensions of recordings; those of compressed ones follow them.
pub const RECORDINGS: [&str; 5] = ["csv", "txt", "tsv", "parquet", "pq"];
const PACKED: [&str; 5] = ["gz", "gzip", "zst", "zstd", "snappy"];

/// Returns `true` if a path is that of a recording: with one of the extensions, `run.csv`, `run.csv.gz`, and no hidden
/// part.
#[must_use]
pub fn is_recording_name(name: &str) -> bool {
    let lower = name.to_ascii_lowercase();
    let packed = |ending: &str| lower.strip_suffix(ending)?.strip_suffix('.');
    let plain = PACKED.iter().find_map(|ending| packed(ending)).unwrap_or(&lower);
    let ending = plain.rsplit_once('.').map(|(_, ending)| ending);
    ending.is_some_and(|ending| RECORDINGS.contains(&ending)) && !has_hidden_part(name)
}

/// Returns `true` if a path is that of a file to which a project may refer: a recording, or a catalogue file.
#[must_use]
pub fn is_referable_name(name: &str) -> bool {
    is_recording_name(name) || name.to_ascii_lowercase().ends_with(".toml") && !has_hidden_part(name)
}

fn has_hidden_part(name: &str) -> bool {
    name.split(['/', '\\']).any(|part| part.starts_with('.'))
}
