//! Lines to write for a recording some of whose rows are incomplete or in the wrong order.

use super::{fault, place, role_key, stamp};
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
    // A counter of time that overflows begins anew too.
    let is_known = own.is_some()
        && matches!(remedy, Remedy::KeepOne { .. } | Remedy::Sort | Remedy::SetBack { .. } | Remedy::Exchange { .. });
    let advice = (!is_known).then(|| advice(remedy, language));
    let hints: Vec<String> = own.into_iter().chain(advice).collect();
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
        Remedy::Reverse => said!(language =>
            "time runs backwards throughout the file: export it again in the order of time, or reverse the rows"
            | "die Zeit läuft in der ganzen Datei rückwärts: in zeitlicher Reihenfolge neu exportieren oder die Zeilen umkehren"
        ),
        Remedy::KeepOne { at } => {
            let at = place(at, language);
            said!(language =>
                "{at} begins anew at the first time: the file contains several recordings one after another, or one of them twice; keep one, and name each in a segment of its own if all are needed"
                | "{at} beginnt wieder mit der ersten Zeit: die Datei enthält mehrere Aufzeichnungen nacheinander oder eine doppelt; eine davon behalten, bei mehreren jede als eigene Datei in einem eigenen Abschnitt angeben"
            )
        }
        Remedy::SetBack { at, by } => {
            let (at, by) = (place(at, language), stamp(by, language));
            said!(language =>
                "{at} jumps back in time, and the rows go on from there: if the clock was set back (end of summer time, synchronisation), add {by} to the times from this row on, or log in UTC; if two recordings overlap, keep one"
                | "{at} springt in der Zeit zurück, von dort laufen die Zeilen weiter: wurde die Uhr zurückgestellt (Ende der Sommerzeit, Synchronisierung), zu den Zeiten ab dieser Zeile {by} addieren oder in UTC aufzeichnen; überschneiden sich zwei Aufzeichnungen, eine davon behalten"
            )
        }
        Remedy::Exchange { rows: [first, second] } => {
            let (first, second) = (place(first, language), place(second, language));
            said!(language =>
                "the two rows are exchanged: put {second} in front of {first}"
                | "die beiden sind vertauscht: {second} muss vor {first} stehen"
            )
        }
        Remedy::Sort => said!(language =>
            "the rows are not in the order of time: sort the file by the column of time"
            | "die Zeilen stehen nicht in zeitlicher Reihenfolge: die Datei nach der Zeitspalte sortieren"
        ),
        Remedy::EvenStamps => said!(language =>
            "the time stamps are rounded more coarsely than the rows follow one another; if the rows are evenly spaced, time_stamps = \"even\" reads them"
            | "die Zeitstempel sind gröber gerundet als der Abstand der Zeilen; haben die Zeilen gleiche Abstände, liest time_stamps = \"even\" sie ein"
        ),
        Remedy::DeleteRepeated => said!(language =>
            "a row occurs twice, or two recordings overlap: delete one of the two rows"
            | "eine Zeile steht doppelt, oder zwei Aufzeichnungen überschneiden sich: eine der beiden Zeilen löschen"
        ),
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

    /// Most of a file is no footer: no advice cuts it off.
    #[test]
    fn a_footer_is_short() {
        for (rows, below) in [(1, 9), (20, 20), (101, 80), (101, 180), (300, 101)] {
            let of = |range: std::ops::Range<u32>, cell: &str| -> String {
                range.map(|k| format!("{};{cell}\n", k * 2)).collect()
            };
            let text = format!("t [ms];q [deg]\n{}{}", of(0..rows, "1"), of(rows..rows + below, "1;2"));
            for (message, hint) in found(&text, Language::En) {
                let all = format!("{message} {hint:?}");
                assert!(!all.contains("footer") && !all.contains("to = "), "{rows} {below}: {all}");
            }
        }
        let text = format!("t [ms];q [deg]\n{}Max;2;3\n", (0..300).map(|k| format!("{k};1\n")).collect::<String>());
        assert!(found(&text, Language::En)[0].0.ends_with("(a footer, or a row cut off)"));
    }

    #[test]
    fn a_wrong_order_has_its_reason_and_the_line_to_write() {
        let table =
            |times: &[u32]| times.iter().fold(String::from("t [ms],q [deg]\n"), |all, t| format!("{all}{t},1\n"));
        for (times, message, advice) in [
            (&[4, 3, 2, 1][..], "line 3: time runs backwards, 3 ms follows 4 ms", "time runs backwards throughout"),
            (
                &[1, 2, 3, 1, 2, 3],
                "line 5: time runs backwards, 1 ms follows 3 ms",
                "line 5 begins anew at the first time",
            ),
            (&[1, 3, 2, 4], "line 4: time runs backwards, 2 ms follows 3 ms", "put line 4 in front of line 3"),
            (&[1, 2, 2, 3], "line 4: the same time as line 3, 2 ms", "delete one of the two rows"),
            (&[0, 0, 1, 1, 1, 2, 2], "line 3: the same time as line 2, 0 ms", "time_stamps = \"even\" reads them"),
        ] {
            let all = found(&table(times), Language::En);
            let (first, hint) = &all[0];
            assert!(first.starts_with(message), "{times:?}: {first}");
            assert!(hint.as_ref().is_some_and(|hint| hint.contains(advice)), "{times:?}: {hint:?}");
            let german = found(&table(times), Language::De);
            assert!(german.iter().zip(&all).all(|(de, en)| de != en && de.1.is_some()), "{german:?}");
        }
    }
}
