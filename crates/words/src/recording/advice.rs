//! Lines to write for a recording some of whose rows are incomplete.

use super::{fault, role_key, stamp};
use crate::texts::said;
use quantities::Language;
use recording::{Fault, Remedy, Stamp};

/// A time as the project file states it.
fn line(key: &str, time: Stamp) -> String {
    format!("{key} = \"{time}\"")
}

/// Returns a fault with the way to read the recording nevertheless, behind its own remedy.
pub(super) fn advised(found: &Fault, remedy: Remedy, language: Language) -> (String, Option<String>) {
    let (message, own) = fault(found, language);
    let hints: Vec<String> = own.into_iter().chain([advice(remedy, language)]).collect();
    (message, Some(hints.join("; ")))
}

/// Returns the way to read a recording without the missing values.
fn advice(remedy: Remedy, language: Language) -> String {
    match remedy {
        Remedy::Without(role) => {
            let line = format!("columns = {{ {} = \"none\" }}", role_key(role));
            said!(language =>
                "the recording can be read without this column: {line}"
                | "ohne diese Spalte ist die Aufzeichnung lesbar: {line}"
            )
        }
        Remedy::Within { from, to } => {
            let lines = from.map(|from| line("from", from)).into_iter().chain(to.map(|to| line("to", to)));
            let lines = lines.collect::<Vec<_>>().join(", ");
            said!(language =>
                "all values are present in a part of the recording: {lines}"
                | "vollständig sind die Werte in einem Abschnitt: {lines}"
            )
        }
        Remedy::Delete => said!(language =>
            "export the value in every row, or delete the rows without it; gaps = \"allow\" permits the gaps that this leaves"
            | "den Wert in jeder Zeile ausgeben oder die Zeilen ohne ihn löschen; die Lücken, die dabei entstehen, lässt gaps = \"allow\" zu"
        ),
    }
}

/// Returns the fault of lines below the last row, and the line to write.
pub(super) fn below_rows(first: &Fault, count: u64, last: Stamp, language: Language) -> (String, Option<String>) {
    let message = fault(first, language).0;
    let (end, shown) = (line("to", last), stamp(last, language));
    let message = match count {
        1 => said!(language =>
            "{message}; the last row is that of {shown}, and one line follows that is no row (a footer, or a row cut off)"
            | "{message}; der letzte Abtastwert ist der bei {shown}, danach steht eine Zeile, die keiner ist (eine Fußzeile oder eine abgeschnittene Zeile)"
        ),
        _ => said!(language =>
            "{message}; the last row is that of {shown}, and {count} lines follow that are no rows (a footer)"
            | "{message}; der letzte Abtastwert ist der bei {shown}, danach stehen {count} Zeilen, die keine sind (eine Fußzeile)"
        ),
    };
    let hint = said!(language =>
        "delete what follows the last row, or state the end: {end}"
        | "alles hinter dem letzten Abtastwert löschen oder das Ende angeben: {end}"
    );
    (message, Some(hint))
}

#[cfg(test)]
mod tests {
    use super::*;
    use recording::{Layout, read_csv};

    /// Faults of a text with their remedies.
    fn found(text: &str, language: Language) -> Vec<(String, Option<String>)> {
        let faults = read_csv(text.as_bytes(), &Layout::default()).unwrap_err();
        faults.iter().map(|found| fault(found, language)).collect()
    }

    #[test]
    fn a_footer_is_named_with_the_line_that_reads_the_recording() {
        let rows = "t [ms];q [deg];n [deg/s]\n0;0;0\n2;1;0\n4;2;0\n";
        let footer = format!("{rows}[Statistics]\nNmbOfSamples 3\nMax;2\n");
        let all = found(&footer, Language::En);
        let (first, hint) = &all[0];
        assert_eq!(all.len(), 3);
        assert_eq!(
            first,
            "line 5: 1 cell, the header has 3; the last row is that of 4 ms, and 3 lines follow that are no rows (a footer)"
        );
        assert_eq!(hint.as_deref(), Some("delete what follows the last row, or state the end: to = \"4 ms\""));
    }
}
