//! Columns in a scale of the drive that wrote them: counts of an encoder, percent of a rated value.

use crate::texts::said;
use quantities::Language;
use recording::{Role, is_share};

/// Returns the word of the file for a role.
#[must_use]
pub const fn role_key(role: Role) -> &'static str {
    match role {
        Role::Time => "time",
        Role::Position => "position",
        Role::Speed => "speed",
        Role::Torque => "torque",
    }
}

/// Words for the counts of an encoder.
const COUNTS: [&str; 22] = [
    "count",
    "counts",
    "cnt",
    "cnts",
    "cts",
    "ct",
    "inc",
    "incr",
    "incs",
    "increment",
    "increments",
    "ink",
    "inkr",
    "inkremente",
    "impulse",
    "imp",
    "pulse",
    "pulses",
    "tick",
    "ticks",
    "lsb",
    "digits",
];

/// Returns the remedy for a column in a scale that only its drive knows; `None` for another unit.
pub(super) fn of_column(role: Role, unit: &str, language: Language) -> Option<String> {
    let written = unit.trim().to_lowercase();
    let (word, rest) = written.split_once('/').unwrap_or((&written, ""));
    let key = role_key(role);
    if COUNTS.contains(&word.trim()) && rest.is_empty() && role == Role::Position {
        return Some(said!(language =>
            "counts are no angle until it is known how many make up a revolution; with N of them for each revolution of the output (counts per revolution of the encoder times the ratio in front of it): units = {{ {key} = \"rev\" }} and recorded_ratio = {{ {key} = N }}"
            | "Inkremente sind erst dann ein Winkel, wenn bekannt ist, wie viele eine Umdrehung ergeben; bei N Inkrementen je Umdrehung des Abtriebs (Inkremente je Umdrehung des Gebers mal Übersetzung davor): units = {{ {key} = \"rev\" }} und recorded_ratio = {{ {key} = N }}"
        ));
    }
    if COUNTS.contains(&word.trim()) && role == Role::Speed && matches!(rest.trim(), "" | "s" | "sec" | "min") {
        let unit = if rest.trim() == "min" { "1/min" } else { "rev/s" };
        return Some(said!(language =>
            "counts are no angle until it is known how many make up a revolution; with N of them for each revolution of the output: units = {{ {key} = \"{unit}\" }} and recorded_ratio = {{ {key} = N }}"
            | "Inkremente sind erst dann ein Winkel, wenn bekannt ist, wie viele eine Umdrehung ergeben; bei N Inkrementen je Umdrehung des Abtriebs: units = {{ {key} = \"{unit}\" }} und recorded_ratio = {{ {key} = N }}"
        ));
    }
    if is_share(unit) && role == Role::Torque {
        return Some(said!(language =>
            "a share of the rated torque is no torque until that is known: multiply the column by the rated torque of the recorded drive (CiA 402: object 6076h) and write the unit into the heading, for example [N m]; a column without use: columns = {{ {key} = \"none\" }}"
            | "ein Anteil des Nenndrehmoments ist erst dann ein Moment, wenn dieses bekannt ist: die Spalte mit dem Nenndrehmoment des aufgezeichneten Antriebs multiplizieren (CiA 402: Objekt 6076h) und die Einheit in die Kopfzeile schreiben, zum Beispiel [N m]; ohne diese Spalte: columns = {{ {key} = \"none\" }}"
        ));
    }
    if is_share(unit) && role == Role::Speed {
        return Some(said!(language =>
            "a share of a reference speed is no speed until that is known: multiply the column by the reference speed of the recorded drive and write the unit into the heading, for example [1/min]"
            | "ein Anteil der Bezugsdrehzahl ist erst dann eine Drehzahl, wenn diese bekannt ist: die Spalte mit der Bezugsdrehzahl des aufgezeichneten Antriebs multiplizieren und die Einheit in die Kopfzeile schreiben, zum Beispiel [1/min]"
        ));
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A column of counts and one of a share have a remedy of their own in each spelling; real units have none.
    #[test]
    fn scales_of_a_drive_have_their_remedy() {
        for language in Language::ALL {
            for (role, unit, line) in [
                (Role::Position, "counts", Some("units = { position = \"rev\" }")),
                (Role::Position, "Inc", Some("recorded_ratio = { position = N }")),
                (Role::Position, "Inkremente", Some("recorded_ratio = { position = N }")),
                (Role::Speed, "counts/s", Some("units = { speed = \"rev/s\" }")),
                (Role::Speed, "inc/min", Some("units = { speed = \"1/min\" }")),
                (Role::Torque, "%", Some("6076h")),
                (Role::Torque, "% Mn", Some("6076h")),
                (Role::Torque, "0.1%", Some("6076h")),
                (Role::Torque, "pct", Some("6076h")),
                (Role::Torque, "Prozent", Some("6076h")),
                (Role::Speed, "percent", Some("[1/min]")),
                (Role::Speed, "%", Some("[1/min]")),
                (Role::Position, "in", None),
                (Role::Position, "mm", None),
                (Role::Time, "counts", None),
                (Role::Torque, "Nmm", None),
            ] {
                let found = of_column(role, unit, language);
                let is_right = match line {
                    Some(line) => found.as_ref().is_some_and(|found| found.contains(line)),
                    None => found.is_none(),
                };
                assert!(is_right, "{role:?} {unit}: {found:?}");
            }
        }
    }
}
