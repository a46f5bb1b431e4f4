//! Identity of a run: a hash of each input that the output depends on. A call continues a run with the same hashes.

use super::table::Table;
use axis::{AxisProject, Catalogue, Files};
use quantities::Language;
use questions::list::Unanswered;
use questions::list::catalogue::export_csv;
use questions::{FILE_BYTES_MAX, file_products};
use std::collections::BTreeSet;
use std::io::Read;
use words::{Word, file_trouble, sweeps};

/// Inputs of a run.
pub(super) struct SweepRun<'r> {
    /// Table.
    pub(super) table: &'r Table<'r>,
    /// Text of the project.
    pub(super) project: &'r str,
    /// Products of catalogue files, as [`products`] writes them.
    pub(super) products: String,
    /// Recordings that project and table name.
    pub(super) recordings: &'r BTreeSet<String>,
    /// Access to the recordings.
    pub(super) files: &'r dyn Files,
    /// Options, each with its value.
    pub(super) options: Vec<(&'static str, String)>,
}

/// Words for the inputs that are no options.
const INPUTS: [(&str, Word); 5] = [
    ("program", sweeps::of_program),
    ("catalogue", sweeps::of_catalogue),
    ("project", sweeps::of_project),
    ("table", sweeps::of_table),
    ("recordings", sweeps::of_recordings),
];

/// Digits of a hash: the first of BLAKE3, 96 bits.
const DIGITS: usize = 24;

/// Hash of each input of a run, by its name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct RunMark(Vec<(&'static str, String)>);

impl SweepRun<'_> {
    /// Computes the hashes of program, catalogue, project, options, and the bytes of the table and of every recording.
    pub(super) fn mark(&self) -> Result<RunMark, Unanswered> {
        let of_text = |texts: &[&str]| {
            let mut hasher = blake3::Hasher::new();
            for text in texts {
                hasher.update(&(text.len() as u64).to_le_bytes()).update(text.as_bytes());
            }
            digits(&hasher)
        };
        let mut table = blake3::Hasher::new();
        hash(&mut table, self.table.source()?)
            .map_err(|error| self.table.refused(&file_trouble(&error, self.table.language)))?;
        let mut recordings = blake3::Hasher::new();
        for name in self.recordings {
            recordings.update(&(name.len() as u64).to_le_bytes()).update(name.as_bytes());
            // A row with a missing recording has that fault as its answer.
            // A larger one is none.
            match self.files.open(name).and_then(|file| hash(&mut recordings, file.take(FILE_BYTES_MAX + 1))) {
                Ok(()) => {}
                Err(error) => drop(recordings.update(format!("{:?}", error.kind()).as_bytes())),
            }
        }
        let mut found = vec![
            ("program", of_text(&[env!("CARGO_PKG_VERSION"), &program()])),
            ("catalogue", of_text(&[&export_csv(), &self.products])),
            ("project", of_text(&[self.project])),
            ("table", digits(&table)),
            ("recordings", digits(&recordings)),
        ];
        found.extend(self.options.iter().map(|(name, value)| (*name, of_text(&[value]))));
        Ok(RunMark(found))
    }
}

impl RunMark {
    /// Returns the mark in one line.
    pub(super) fn written(&self) -> String {
        self.0.iter().map(|(name, hash)| format!("{name}={hash}")).collect::<Vec<_>>().join(" ")
    }

    /// Returns the inputs in which a run with a written mark differs.
    pub(super) fn differences(&self, other: &str, language: Language) -> String {
        let has = |name: &str, hash: &str| {
            other.split(' ').filter_map(|part| part.split_once('=')).any(|found| found == (name, hash))
        };
        let differing = self.0.iter().filter(|(name, hash)| !has(name, hash)).map(|(name, _)| {
            let word = INPUTS.iter().find(|(input, _)| input == name);
            word.map_or_else(|| (*name).to_owned(), |(_, word)| word(language).to_owned())
        });
        differing.collect::<Vec<_>>().join(", ")
    }
}

/// Writes the products of catalogue files that the axes of a project, or the call, offer; empty without such files.
pub(super) fn products(catalogue: &dyn Catalogue, projects: &[AxisProject]) -> String {
    let own = projects.iter().map(|project| &**project.catalogue());
    std::iter::once(catalogue).chain(own).map(file_products).collect()
}

/// Returns the identity of the running build: two of one version may differ.
fn program() -> String {
    let about = std::env::current_exe().and_then(std::fs::metadata);
    about.map_or_else(|_| String::new(), |about| format!("{} {:?}", about.len(), about.modified().ok()))
}

/// Returns the first digits of a hash.
fn digits(hasher: &blake3::Hasher) -> String {
    hasher.finalize().to_hex().chars().take(DIGITS).collect()
}

/// Adds the bytes of a file and their number.
fn hash(hasher: &mut blake3::Hasher, mut file: impl Read) -> std::io::Result<()> {
    let mut buffer = vec![0; 1 << 18];
    let mut length = 0_u64;
    loop {
        let read = match file.read(&mut buffer) {
            Err(error) if error.kind() == std::io::ErrorKind::Interrupted => continue,
            read => read?,
        };
        if read == 0 {
            hasher.update(&length.to_le_bytes());
            return Ok(());
        }
        hasher.update(buffer.get(..read).unwrap_or_default());
        length += read as u64;
    }
}
