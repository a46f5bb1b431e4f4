//! The motion as it came out, as text.

use crate::table::{Align, Table, paragraph};
use workbench::quantities::unit::SECOND;
use workbench::quantities::{Measure, format_significant};
use workbench::text::{encoding_guess, law_text};
use workbench::{Language, Moves};

/// So many segments are shown; --json has them all.
const SEGMENTS_MOST: usize = 12;

/// Every segment with what was given and what followed from it.
pub(crate) fn text(moves: &Moves<'_>, language: Language) -> String {
    let [distance, speed, acceleration] = moves.units.map(|unit| unit.symbol);
    let heads = match language {
        Language::En => [
            "move".to_owned(),
            "law".into(),
            "from s".into(),
            "time s".into(),
            format!("distance {distance}"),
            format!("speed {speed}"),
            format!("acceleration {acceleration}"),
        ],
        Language::De => [
            "Abschnitt".to_owned(),
            "Gesetz".into(),
            "ab s".into(),
            "Zeit s".into(),
            format!("Weg {distance}"),
            format!("{} {speed}", if moves.turns { "Drehzahl" } else { "Geschwindigkeit" }),
            format!("Beschleunigung {acceleration}"),
        ],
    };
    let number = |value: f64| format_significant(value, 4, language);
    let mut table = Table::new([
        (heads[0].as_str(), Align::Right),
        (heads[1].as_str(), Align::Left),
        (heads[2].as_str(), Align::Right),
        (heads[3].as_str(), Align::Right),
        (heads[4].as_str(), Align::Right),
        (heads[5].as_str(), Align::Right),
        (heads[6].as_str(), Align::Right),
    ]);
    for (index, each) in moves.moves.iter().enumerate().take(SEGMENTS_MOST) {
        let cells = match each.course {
            Some([s, v, a]) => {
                let [distance, speed, acceleration] = moves.units;
                [number(distance.from_si(s)), number(speed.from_si(v)), number(acceleration.from_si(a))]
            }
            None => ["–", "–", "–"].map(str::to_owned),
        };
        let [distance, speed, acceleration] = cells;
        let time = |si: f64| number(SECOND.from_si(si));
        let (start, duration) = (time(each.start.si()), time(each.duration.si()));
        let law = law_text(each.law, language).to_owned();
        table.row([(index + 1).to_string(), law, start, duration, distance, speed, acceleration]);
    }
    let mut out = table.render();
    let more = moves.moves.len().saturating_sub(SEGMENTS_MOST);
    if more > 0 {
        out.push_str(&match language {
            Language::En => format!("{more} more; --json has them all\n"),
            Language::De => format!("{more} weitere; --json hat alle\n"),
        });
    }
    for read in moves.moves.iter().filter_map(|each| each.recording) {
        let columns: Vec<String> =
            read.recording.columns.iter().map(|column| column_text(&column.name, column.unit.symbol)).collect();
        let (count, columns) = (read.recording.time_s.len(), columns.join(", "));
        let left = read.recording.left_out_before + read.recording.left_out_after;
        let (head, mut what) = match language {
            Language::En => ("recording: ", format!("{}, {count} samples, {columns}", read.file)),
            Language::De => ("Aufzeichnung: ", format!("{}, {count} Abtastwerte, {columns}", read.file)),
        };
        if left > 0 {
            what.push_str(&match language {
                Language::En => format!("; {left} outside the window"),
                Language::De => format!("; {left} außerhalb des Fensters"),
            });
        }
        if let Some(guess) = encoding_guess(read.recording.encoding, language) {
            what.push_str("; ");
            what.push_str(&guess);
        }
        out.push_str(&paragraph(head, &what));
    }
    out
}

/// A column with its unit, which its name may carry already.
fn column_text(name: &str, unit: &str) -> String {
    if name.contains(['[', '(', '/']) { name.to_owned() } else { format!("{name} [{unit}]") }
}
