//! Reasons of the operating system for which a file cannot be read or written.

use crate::pick;
use crate::texts::said;
use project::{FileTrouble, Unopened};
use quantities::Language;

/// Returns the message of the system about an unreadable file.
#[must_use]
pub fn file_trouble(error: &std::io::Error, language: Language) -> String {
    trouble_text(&error.into(), language)
}

pub(crate) fn trouble_text(trouble: &FileTrouble, language: Language) -> String {
    use std::io::ErrorKind;
    let system = &trouble.system;
    let (en, de) = match (trouble.unopened, trouble.kind, trouble.code) {
        (Some(Unopened::NoRegularFile), ..) => (
            "this is a pipe, a device or a socket, not a regular file",
            "das ist eine Pipe, ein Gerät oder ein Socket, keine gewöhnliche Datei",
        ),
        (Some(Unopened::NoRecordingName), ..) => (
            "only recordings are opened here: file names ending in .csv, .txt or .parquet (or .csv.gz, .txt.zst) without a path component that begins with a dot",
            "hier werden nur Aufzeichnungen geöffnet: Namen, die auf .csv, .txt oder .parquet (oder .csv.gz, .txt.zst) enden und von denen kein Teil mit einem Punkt beginnt",
        ),
        (_, ErrorKind::NotFound, _) => ("there is no such file", "diese Datei existiert nicht"),
        (_, ErrorKind::PermissionDenied, _) => ("permission denied", "kein Zugriff"),
        (_, ErrorKind::IsADirectory, _) => ("this is a folder, not a file", "das ist ein Ordner, keine Datei"),
        (_, ErrorKind::NotADirectory, _) => {
            ("a part of the path is a file, not a folder", "ein Teil des Pfads ist eine Datei, kein Ordner")
        }
        (_, ErrorKind::FileTooLarge, _) => ("the file is too large", "die Datei ist zu groß"),
        (_, ErrorKind::Unsupported, _) => {
            ("files cannot be read from here", "von hier aus können keine Dateien gelesen werden")
        }
        (_, ErrorKind::StorageFull, _) => ("no space is left on the device", "auf dem Datenträger ist kein Platz mehr"),
        (_, ErrorKind::QuotaExceeded, _) => {
            ("the quota of the disk is used up", "das Kontingent des Datenträgers ist erschöpft")
        }
        (_, ErrorKind::ReadOnlyFilesystem, _) => {
            ("the file system is read-only", "das Dateisystem ist schreibgeschützt")
        }
        (_, ErrorKind::InvalidFilename, _) => ("the file name is not valid", "der Dateiname ist ungültig"),
        (_, ErrorKind::AlreadyExists, _) => ("the file already exists", "die Datei existiert bereits"),
        (_, ErrorKind::BrokenPipe, _) => {
            ("the reader has closed the output", "die Ausgabe wurde vom Empfänger geschlossen")
        }
        (_, ErrorKind::TimedOut, _) => ("the time limit was exceeded", "die Zeit ist abgelaufen"),
        (_, ErrorKind::Interrupted, _) => ("the operation was interrupted", "der Vorgang wurde unterbrochen"),
        (_, ErrorKind::UnexpectedEof, _) => ("the file ends too early", "die Datei endet zu früh"),
        (_, ErrorKind::InvalidData, _) => ("the data are damaged", "die Daten sind beschädigt"),
        (_, ErrorKind::InvalidInput, _) => {
            ("the operating system rejects this input", "das Betriebssystem weist diese Eingabe zurück")
        }
        (_, ErrorKind::WouldBlock, _) => ("the source has no data at present", "die Quelle hat zurzeit keine Daten"),
        (_, ErrorKind::OutOfMemory, _) => ("not enough memory", "der Arbeitsspeicher reicht nicht aus"),
        (_, ErrorKind::ResourceBusy | ErrorKind::ExecutableFileBusy, _) => {
            ("the file is in use by another program", "die Datei wird von einem anderen Programm benutzt")
        }
        (_, ErrorKind::AddrInUse, _) => ("the address is in use", "die Adresse ist belegt"),
        (_, ErrorKind::AddrNotAvailable, _) => {
            ("this computer does not have the address", "dieser Rechner hat die Adresse nicht")
        }
        // Numbers of POSIX systems, for which the library has no kind.
        (_, _, Some(5)) if cfg!(unix) => ("the device reports an error", "das Gerät meldet einen Fehler"),
        (_, _, Some(9)) if cfg!(unix) => ("the file is closed", "die Datei ist geschlossen"),
        (_, _, Some(23 | 24)) if cfg!(unix) => ("too many files are open", "zu viele Dateien sind offen"),
        (_, _, Some(40 | 62)) if cfg!(unix) => ("the links form a loop", "die Verknüpfungen bilden eine Schleife"),
        (_, _, Some(code)) => {
            return said!(language => "{system}" | "Fehler {code} des Betriebssystems („{system}“)");
        }
        (_, _, None) => return said!(language => "{system}" | "„{system}“"),
    };
    pick(language, en, de).to_owned()
}
