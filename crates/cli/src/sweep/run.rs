//! Identity of a run: one hash of everything that the output depends on. A call continues a run with the same hash.

use super::table::Table;
use axis::Files;
use questions::list::Unanswered;
use questions::list::catalogue::export_csv;
use std::collections::BTreeSet;
use std::io::Read;
use words::file_trouble;

/// Largest number of hashed recordings: a table that names more begins anew each time.
const RECORDINGS_MOST: usize = 1 << 16;

/// Inputs of a run.
pub(super) struct SweepRun<'r> {
    /// Table.
    pub(super) table: &'r Table<'r>,
    /// Text of the project.
    pub(super) project: &'r str,
    /// Recordings that project and table name.
    pub(super) recordings: &'r BTreeSet<String>,
    /// Access to the recordings.
    pub(super) files: &'r dyn Files,
    /// Options, language and format of the output.
    pub(super) request: String,
}

impl SweepRun<'_> {
    /// Computes the hash of program, catalogue, project, request, and the bytes of the table and of every recording.
    pub(super) fn mark(&self) -> Result<String, Unanswered> {
        let mut hasher = blake3::Hasher::new();
        for text in [env!("CARGO_PKG_VERSION"), &program(), &export_csv(), self.project, &self.request] {
            hasher.update(&(text.len() as u64).to_le_bytes()).update(text.as_bytes());
        }
        hash(&mut hasher, self.table.file()?)
            .map_err(|error| self.table.refused(&file_trouble(&error, self.table.language)))?;
        for name in self.recordings.iter().take(RECORDINGS_MOST) {
            hasher.update(&(name.len() as u64).to_le_bytes()).update(name.as_bytes());
            // A row with a missing recording has that fault as its answer.
            match self.files.open(name).and_then(|file| hash(&mut hasher, file)) {
                Ok(()) => {}
                Err(error) => drop(hasher.update(format!("{:?}", error.kind()).as_bytes())),
            }
        }
        if self.recordings.len() > RECORDINGS_MOST {
            let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).unwrap_or_default();
            hasher.update(format!("{} {now:?}", std::process::id()).as_bytes());
        }
        Ok(hasher.finalize().to_hex().to_string())
    }
}

/// Returns the identity of the running build: two of one version may differ.
fn program() -> String {
    let about = std::env::current_exe().and_then(std::fs::metadata);
    about.map_or_else(|_| String::new(), |about| format!("{} {:?}", about.len(), about.modified().ok()))
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
