//! Axes of a recording: positions of modulo axes, columns of several axes, scales.

use super::{place, quoted, stamp};
use crate::texts::said;
use quantities::unit::{DEGREE, MILLIMETRE};
use quantities::{Angle, Language, Measure, format_significant, with_symbol};
use recording::{Along, Fault, FileRow, Role, Stamp};

pub(super) fn turn_begun(at: FileRow, jump: Angle, has_speed: bool, language: Language) -> (String, Option<String>) {
    let jump = format!("{}°", format_significant(jump.in_unit(&DEGREE), 4, language));
    (
        said!(language =>
            "{}: the position begins anew after a full turn, with a jump of {jump}"
            | "{}: die Position beginnt nach einer vollen Umdrehung von vorn, mit einem Sprung von {jump}", place(at, language)
        ),
        Some(match has_speed {
            true => said!(language =>
                "export the position beyond full turns (no modulo), or use the speed alone: columns = {{ position = \"none\" }}"
                | "die Position über volle Umdrehungen hinweg ausgeben (ohne Modulo) oder nur die Drehzahl verwenden: columns = {{ position = \"none\" }}"
            ),
            false => said!(language =>
                "export the position beyond full turns (no modulo), or record the speed"
                | "die Position über volle Umdrehungen hinweg ausgeben (ohne Modulo) oder die Drehzahl aufzeichnen"
            ),
        }),
    )
}

pub(super) fn step_undecided(
    at: FileRow,
    time: Stamp,
    step: Angle,
    count: usize,
    language: Language,
) -> (String, Option<String>) {
    let step = format!("{}°", format_significant(step.in_unit(&DEGREE), 4, language));
    let time = stamp(time, language);
    let more = match count {
        1 => String::new(),
        count => said!(language => " ({count} such steps)" | " (insgesamt {count} solche Schritte)"),
    };
    (
        said!(language =>
            "{}, {time}: the position moves by {step} between two samples{more}; all positions lie within one turn, and about half a turn of a modulo axis may be either direction"
            | "{}, {time}: die Position ändert sich zwischen zwei Abtastwerten um {step}{more}; alle Positionen liegen in einer Umdrehung, und etwa eine halbe Umdrehung einer Moduloachse kann jede der beiden Richtungen sein", place(at, language)
        ),
        Some(said!(language =>
            "record with a shorter interval, without modulo, or with the speed; read away from this point with from and to"
            | "mit kürzerem Abstand, ohne Modulo oder mit der Drehzahl aufzeichnen; abseits dieser Stelle mit from und to lesen"
        )),
    )
}

pub(super) fn position_jumps(fault: &Fault, language: Language) -> (String, Option<String>) {
    let Fault::PositionJumps { at, column, size, along, has_speed, count } = fault else {
        return (String::new(), None);
    };
    let unit = match along {
        Along::Turning => &DEGREE,
        Along::Line => &MILLIMETRE,
    };
    let size = with_symbol(&format_significant(unit.from_si(*size), 4, language), unit.symbol_in(language));
    let more = match count {
        1 => String::new(),
        count => said!(language => " ({count} such jumps)" | " (insgesamt {count} solche Sprünge)"),
    };
    (
        said!(language =>
            "{}: {} jumps by {size} from one end of its range to the other, against the motion{more}: a modulo axis"
            | "{}: {} springt um {size} von einem Ende des Bereichs zum anderen, entgegen der Bewegung{more}: eine Moduloachse", place(*at, language), quoted(column, language)
        ),
        Some(if *has_speed {
            said!(language =>
                "use the recorded speed alone: columns = {{ position = \"none\" }}"
                | "nur die aufgezeichnete Drehzahl verwenden: columns = {{ position = \"none\" }}"
            )
        } else {
            said!(language =>
                "record the position without modulo, or the speed"
                | "Position ohne Modulo aufzeichnen oder die Geschwindigkeit"
            )
        }),
    )
}

pub(super) fn several_axes(columns: &[(Role, String)], language: Language) -> (String, Option<String>) {
    let names: Vec<String> = columns.iter().map(|(_, name)| quoted(name, language)).collect();
    let names = names.join(", ");
    let key = |role: Role| match role {
        Role::Time => "time",
        Role::Position => "position",
        Role::Speed => "speed",
        Role::Torque => "torque",
    };
    let line = |(place, (role, name)): (usize, &(Role, String))| match place {
        0 => format!("{} = \"{name}\"", key(*role)),
        _ => format!("{} = \"none\"", key(*role)),
    };
    let line = columns.iter().enumerate().map(line).collect::<Vec<_>>().join(", ");
    (
        said!(language =>
            "the columns {names} are the only ones for their quantities, but belong to different axes"
            | "die Spalten {names} sind die einzigen ihrer Größen, gehören aber zu verschiedenen Achsen"
        ),
        Some(said!(language =>
            "name the columns of one axis, with \"none\" for what it lacks: columns = {{ {line} }}"
            | "die Spalten einer Achse nennen, mit \"none\" für fehlende: columns = {{ {line} }}"
        )),
    )
}

pub(super) fn scale_unknown(
    column: &str,
    [scale, offset]: &[String; 2],
    language: Language,
) -> (String, Option<String>) {
    let [scale, offset] = [scale, offset].map(|written| quoted(written, language));
    (
        said!(language =>
            "{} has the scale factor {scale} and the offset {offset} in the list of properties, which does not state if the values contain them"
            | "{} hat in der Liste der Eigenschaften den Skalierungsfaktor {scale} und den Versatz {offset}; ob die Werte sie enthalten, steht dort nicht", quoted(column, language)
        ),
        Some(said!(language =>
            "export with \"Scale values before export\" and delete the lines ScaleFactor and Offset"
            | "mit „Scale values before export“ exportieren und die Zeilen ScaleFactor und Offset löschen"
        )),
    )
}
