//! Fingerprints of the origin of a result: the project with its recordings, and the catalogue.

use crate::export::{EXPORT_COLUMNS, export_rows};
use axis::{Catalogue, RecordingRead};
use std::fmt::Write as _;

/// Digits of a fingerprint: the first sixteen of BLAKE3, 64 bits.
const DIGITS: usize = 16;

fn shown(hasher: &blake3::Hasher) -> String {
    hasher.finalize().to_hex().chars().take(DIGITS).collect()
}

/// Returns the fingerprint of a project: its text, and the samples of its recordings.
#[must_use]
pub fn project_fingerprint(text: &str, recordings: &[RecordingRead]) -> String {
    let mut hasher = blake3::Hasher::new();
    hasher.update(text.as_bytes());
    for read in recordings {
        let recording = &read.recording;
        let course = [&recording.course.position, &recording.course.speed].into_iter().flatten();
        let columns = course.map(|series| &series.values).chain(recording.torque.as_ref().map(|effort| &effort.values));
        for column in columns.chain([&recording.time_s]) {
            for value in column.iter() {
                hasher.update(&value.to_le_bytes());
            }
        }
    }
    shown(&hasher)
}

/// Returns the fingerprint of a catalogue: every cell of the series in the program as exported, errata included, and every
/// product of catalogue files with all its data.
#[must_use]
pub fn catalogue_fingerprint(catalogue: &dyn Catalogue) -> String {
    let mut hasher = blake3::Hasher::new();
    hasher.update(EXPORT_COLUMNS.join("\t").as_bytes());
    for row in export_rows() {
        hasher.update(format!("{row:?}\n").as_bytes());
    }
    hasher.update(file_products(catalogue).as_bytes());
    shown(&hasher)
}

/// Writes the products of catalogue files that a catalogue offers, one per line with all their data; empty without such files.
#[must_use]
pub fn file_products(catalogue: &dyn Catalogue) -> String {
    let mut text = String::new();
    if catalogue.has_files() {
        for product in catalogue.products(false).iter().filter(|product| product.id.order_code().is_none()) {
            let _ = writeln!(text, "{product:?}");
        }
    }
    text
}
