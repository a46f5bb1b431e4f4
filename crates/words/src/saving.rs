//! Words for files that cannot be written.

use crate::pick;
use crate::texts::said;
use project::FileTrouble;
use quantities::Language;

/// Reasons why a file is not written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SaveTrouble {
    /// The file exists, and replacing it was not requested.
    Exists,
    /// The file is write-protected.
    WriteProtected,
    /// The file exists and is a pipe, a device or a socket.
    NoRegularFile,
    /// The folder does not exist.
    NoFolder,
    /// The path is a link, through which no file is written.
    IsLink {
        /// Target of the link.
        target: String,
    },
    /// The file is the project file or one that the project reads.
    IsInput,
    /// Two files to be written have the same path.
    Twice,
    /// The format cannot be written to standard output.
    NotToStdout,
    /// Message of the system.
    System(FileTrouble),
}

/// Returns the reason why a file is not written, in one sentence.
#[must_use]
pub fn save_trouble(trouble: &SaveTrouble, language: Language) -> String {
    use std::io::ErrorKind;
    let (en, de) = match trouble {
        SaveTrouble::Exists => {
            ("the file already exists; --force replaces it", "die Datei existiert bereits; --force ersetzt sie")
        }
        SaveTrouble::WriteProtected => (
            "the file is write-protected and was not changed",
            "die Datei ist schreibgeschützt und wurde nicht geändert",
        ),
        SaveTrouble::NoRegularFile => (
            "this is a pipe, a device or a socket; only regular files are written",
            "das ist eine Pipe, ein Gerät oder ein Socket; geschrieben werden nur gewöhnliche Dateien",
        ),
        SaveTrouble::NoFolder => ("there is no such folder", "dieser Ordner existiert nicht"),
        SaveTrouble::IsLink { target } => {
            return said!(language =>
                "this is a link to {target}; files are not written through a link, specify its target directly"
                | "das ist eine Verknüpfung auf {target}; durch Verknüpfungen wird nicht geschrieben, das Ziel direkt angeben"
            );
        }
        SaveTrouble::IsInput => (
            "this call reads the file; specify another file for writing",
            "dieser Aufruf liest die Datei; zum Schreiben eine andere angeben",
        ),
        SaveTrouble::Twice => ("two output files are the same file", "zwei Ausgabedateien sind dieselbe Datei"),
        SaveTrouble::NotToStdout => (
            "this format cannot be written to standard output",
            "dieses Format kann nicht auf die Standardausgabe geschrieben werden",
        ),
        // Some systems report a full device as an exceeded file size.
        SaveTrouble::System(FileTrouble { kind: ErrorKind::FileTooLarge, .. }) => {
            ("not enough space for a file of this size", "nicht genügend Speicherplatz für eine Datei dieser Größe")
        }
        SaveTrouble::System(found) => return super::file_trouble::trouble_text(found, language),
    };
    pick(language, en, de).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_trouble_has_its_sentence_in_both_languages() {
        let system =
            |kind| SaveTrouble::System(FileTrouble { kind, unopened: None, code: None, system: "x".to_owned() });
        let all = [
            SaveTrouble::Exists,
            SaveTrouble::WriteProtected,
            SaveTrouble::NoRegularFile,
            SaveTrouble::NoFolder,
            SaveTrouble::IsLink { target: "/far".to_owned() },
            SaveTrouble::IsInput,
            SaveTrouble::Twice,
            SaveTrouble::NotToStdout,
            system(std::io::ErrorKind::FileTooLarge),
            system(std::io::ErrorKind::StorageFull),
        ];
        for trouble in all {
            let [en, de] = [Language::En, Language::De].map(|language| save_trouble(&trouble, language));
            assert!(en.len() > 10 && de.len() > 10 && en != de, "{trouble:?}");
        }
    }
}
