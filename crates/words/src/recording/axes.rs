//! Columns of several axes.

use super::quoted;
use crate::texts::said;
use quantities::Language;
use recording::Role;

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
