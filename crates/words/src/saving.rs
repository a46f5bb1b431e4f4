//! Words about files that cannot be written.

use crate::pick;
use crate::texts::said;
use project::FileTrouble;
use quantities::Language;

/// Why a file is not written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SaveTrouble {
    /// It exists, and replacing it was not requested.
    Exists,
    /// It is write-protected.
    WriteProtected,
    /// It exists and is a pipe, a device or a socket.
    NoRegularFile,
    /// There is no such folder.
    NoFolder,
    /// A link leads out of the folder of the given name.
    LinkLeadsAway {
        /// Where it leads.
        target: String,
    },
    /// A link leads to nothing.
    LinkToNothing,
    /// It is the project file or one that the project reads.
    IsInput,
    /// Two files to be written are one.
    Twice,
    /// Its format does not go to standard output.
    NotToStdout,
    /// What the system says.
    System(FileTrouble),
}

/// Why a file is not written, in one sentence.
#[must_use]
pub fn save_trouble(trouble: &SaveTrouble, language: Language) -> String {
    use std::io::ErrorKind;
    let (en, de) = match trouble {
        SaveTrouble::Exists => ("the file exists; --force replaces it", "die Datei gibt es schon; --force ersetzt sie"),
        SaveTrouble::WriteProtected => {
            ("the file is write-protected and stays as it is", "die Datei ist schreibgeschützt und bleibt, wie sie ist")
        }
        SaveTrouble::NoRegularFile => (
            "this is a pipe, a device or a socket; only regular files are written",
            "das ist eine Pipe, ein Gerät oder ein Socket; geschrieben werden nur gewöhnliche Dateien",
        ),
        SaveTrouble::NoFolder => ("there is no such folder", "diesen Ordner gibt es nicht"),
        SaveTrouble::LinkLeadsAway { target } => {
            return said!(language =>
                "the link leads out of its folder, to {target}; name that file itself"
                | "die Verknüpfung führt aus ihrem Ordner hinaus, zu {target}; die Datei dort selbst nennen"
            );
        }
        SaveTrouble::LinkToNothing => ("the link leads to nothing", "die Verknüpfung führt ins Leere"),
        SaveTrouble::IsInput => (
            "the project is read from this file; name another one to write",
            "aus dieser Datei wird das Projekt gelesen; zum Schreiben eine andere nennen",
        ),
        SaveTrouble::Twice => {
            ("two files to be written are the same one", "zwei zu schreibende Dateien sind ein und dieselbe")
        }
        SaveTrouble::NotToStdout => {
            ("this format does not go to standard output", "dieses Format geht nicht auf die Standardausgabe")
        }
        // A limit of the size is how some systems tell that there is no room.
        SaveTrouble::System(FileTrouble { kind: ErrorKind::FileTooLarge, .. }) => {
            ("there is no room for a file of this size", "für eine Datei dieser Größe ist kein Platz")
        }
        SaveTrouble::System(found) => return super::faults::trouble_text(found, language),
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
            SaveTrouble::LinkLeadsAway { target: "/far".to_owned() },
            SaveTrouble::LinkToNothing,
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
