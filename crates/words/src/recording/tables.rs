//! Words for files that were given as a table of axes.

use super::foreign::foreign;
use super::recording_text;
use crate::texts::said;
use quantities::Language;
use recording::{Fault, Foreign, Limit};

/// Returns the fault of a file read as a table of axes, in one sentence.
#[must_use]
pub fn table_text(found: &Fault, language: Language) -> String {
    match found {
        Fault::ReadFailed { kind, .. } => {
            let why = crate::file_trouble(&(*kind).into(), language);
            said!(language => "the table cannot be read: {why}" | "die Tabelle ist nicht lesbar: {why}")
        }
        Fault::Beyond { limit: Limit::Memory, found, most } => {
            let (found, most) = (found.div_ceil(1 << 20), most.div_ceil(1 << 20));
            said!(language =>
                "a part of the table needs {found} MiB of memory, at most {most} MiB are taken; smaller row groups or fewer columns help"
                | "ein Teil der Tabelle erfordert {found} MiB Speicher, verwendet werden höchstens {most} MiB; kleinere Zeilengruppen oder weniger Spalten helfen"
            )
        }
        Fault::Foreign { format } => {
            let (what, remedy) = match format {
                // The remedies of these name the columns of a recording.
                Foreign::Mat | Foreign::Npy => (foreign(*format, language).0, foreign(Foreign::Json, language).1),
                format => foreign(*format, language),
            };
            said!(language =>
                "this is {what}, not a CSV or Parquet; {remedy}" | "das ist {what}, kein CSV oder Parquet; {remedy}"
            )
        }
        found => recording_text(found, language),
    }
}
