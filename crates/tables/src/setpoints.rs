//! Setpoints of a motion as a table.

use crate::rows::Rows;
use crate::subject::titled;
use crate::table::{Column, ColumnContent, Table};
use quantities::Language;
use questions::Setpoints;
use words::{Word, capitalised, tables, terms};

/// Returns the setpoints of a motion: time, position, speed and acceleration in the units of the axis.
#[must_use]
pub fn setpoints(setpoints: &Setpoints, language: Language) -> Table {
    let speed: Word = if setpoints.turns { terms::rotary_speed } else { terms::linear_speed };
    let heads: [(&str, Word); 4] =
        [("time", terms::time), ("position", terms::position), ("speed", speed), ("acceleration", terms::acceleration)];
    let column = |((name, title), unit): ((&str, Word), _)| -> Column {
        let about = tables::setpoints_about;
        titled(name, title(language).to_owned(), ColumnContent::Number, Some(unit), about, language)
    };
    let values =
        setpoints.rows.iter().flat_map(|row| row.iter().zip(setpoints.units).map(|(si, unit)| unit.from_si(*si)));
    Table {
        name: "setpoints",
        title: capitalised(tables::setpoints(language)),
        about: tables::setpoints_about(language).to_owned(),
        columns: heads.into_iter().zip(setpoints.units).map(column).collect(),
        rows: Rows::numbered(heads.len(), values),
        derived: Vec::new(),
    }
}
