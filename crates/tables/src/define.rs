//! Definitions of the tables: content and origin of each.

use crate::cell::Cell;
use crate::format::Format;
use crate::results;
use crate::rows::Rows;
use crate::subject::{Subject, column};
use crate::table::{ColumnContent, Table};
use project::inputs;
use quantities::unit::{
    AMPERE, DEGREE, DEGREE_CELSIUS, NEWTON_METRE, ONE, RADIAN_PER_SECOND_SQUARED, REVOLUTION_PER_MINUTE, SECOND, WATT,
};
use quantities::{Measure, Unit};
use questions::answer::input_words;
use questions::{Sample, course, moves};
use words::{Word, assumption_text, law_text, tables, terms, without_keys};

/// Names of the tables, in the order of a workbook.
pub const NAMES: [&str; 7] = questions::list::export::TABLES;

impl Subject<'_> {
    /// Returns a table by its name, for a format; `None` for a name that is not in [`NAMES`]. The rows of a course that
    /// exceeds the sheet of a workbook are only counted.
    #[must_use]
    pub fn table(&self, name: &str, format: Format) -> Option<Table> {
        Some(match name {
            "inputs" => self.inputs(format),
            "assumptions" => self.assumptions(),
            "demand" => results::demand(self),
            "motion" => self.motion(),
            "candidates" => results::candidates(self),
            "checks" => results::checks(self, format),
            "course" => self.course(format),
            _ => return None,
        })
    }

    /// Returns every table of a workbook, in the order of [`NAMES`].
    #[must_use]
    pub fn tables(&self) -> Vec<Table> {
        NAMES.iter().filter_map(|name| self.table(name, Format::Workbook)).collect()
    }

    fn inputs(&self, format: Format) -> Table {
        let l = self.language;
        // Readers of a workbook do not have the project file; programs read its keys.
        let is_read = format == Format::Workbook;
        let (key, key_about): (Word, Word) =
            if is_read { (tables::input, tables::input_about) } else { (tables::key, tables::key_about) };
        let columns = vec![
            column("path", key, ColumnContent::Text, None, key_about, l),
            column("written", tables::written, ColumnContent::Text, None, tables::written_about, l),
            column("value", terms::value, ColumnContent::Number, None, tables::value_of_input_about, l),
            column("tolerance", tables::tolerance, ColumnContent::Number, None, tables::tolerance_about, l),
            column("unit", terms::unit, ColumnContent::Text, None, tables::unit_of_input_about, l),
        ];
        let own = format!("axis[{}].", self.axis + 1);
        let rows = inputs(self.text)
            .into_iter()
            .filter(|input| !input.path.starts_with("axis[") || input.path.starts_with(&own))
            .map(|input| {
                let (value, unit) = input
                    .amount
                    .map_or((Cell::Empty, Cell::Empty), |(value, unit)| (Cell::number(value), Cell::unit(unit, l)));
                let [path, written] =
                    if is_read { input_words(&input, l) } else { [input.path.clone(), input.written.clone()] };
                vec![
                    Cell::text(path),
                    Cell::text(written),
                    value,
                    input.half_width.map_or(Cell::Empty, Cell::number),
                    unit,
                ]
            });
        self.made("inputs", terms::inputs, tables::inputs_about, columns, rows.collect())
    }

    fn assumptions(&self) -> Table {
        let l = self.language;
        let columns = vec![
            column("number", terms::number, ColumnContent::Count, None, tables::number_about, l),
            column("assumption", tables::assumption, ColumnContent::Text, None, tables::assumption_about, l),
        ];
        let concerning = self.project.assumptions.iter().filter(|each| self.chosen.is_concerned_by(**each));
        let stated = concerning.map(|each| without_keys(&assumption_text(*each, l), l).into_owned());
        let rows = (1_u16..)
            .zip(self.chosen.how_named(l).into_iter().chain(stated))
            .map(|(number, text)| vec![Cell::number(f64::from(number)), Cell::text(text)]);
        self.made("assumptions", terms::assumptions, tables::assumptions_about, columns, rows.collect())
    }

    fn motion(&self) -> Table {
        let l = self.language;
        let moves = moves(self.project);
        let [distance, speed, acceleration] = moves.units;
        let speed_title = if moves.turns { terms::rotary_speed } else { terms::linear_speed };
        let where_at = if moves.turns { tables::at_the_output } else { tables::along_the_line };
        let number = |name: &str, title: Word, unit: &'static Unit| {
            column(name, title, ColumnContent::Number, Some(unit), where_at, l)
        };
        let columns = vec![
            column("segment", terms::segment, ColumnContent::Count, None, tables::segment_about, l),
            column("law", terms::law, ColumnContent::Text, None, tables::law_about, l),
            column("start", tables::from, ColumnContent::Number, Some(&SECOND), tables::from_about, l),
            column("duration", terms::duration, ColumnContent::Number, Some(&SECOND), terms::duration, l),
            number("distance", terms::distance, distance),
            number("speed", speed_title, speed),
            number("acceleration", terms::acceleration, acceleration),
            column("recording", terms::recording, ColumnContent::Text, None, tables::recording_about, l),
        ];
        let rows = (1_u32..).zip(&moves.moves).map(|(number, each)| {
            let [s, v, a] = each.course.map_or([None; 3], |course| course.map(Some));
            vec![
                Cell::number(f64::from(number)),
                Cell::text(law_text(each.law, l)),
                Cell::in_unit(Some(each.start.si()), &SECOND),
                Cell::in_unit(Some(each.duration.si()), &SECOND),
                Cell::in_unit(s, distance),
                Cell::in_unit(v, speed),
                Cell::in_unit(a, acceleration),
                each.recording.map_or(Cell::Empty, |read| Cell::text(read.file.as_str())),
            ]
        });
        self.made("motion", terms::motion, tables::motion_about, columns, rows.collect())
    }

    fn course(&self, format: Format) -> Table {
        let l = self.language;
        type Of = fn(&Sample) -> Option<f64>;
        let has_inertia = self.chosen.parameters.inertia_out.known().is_some();
        let of_torque = if has_inertia { tables::torque_of_course_about } else { tables::torque_of_the_load_about };
        let series: [(&str, Word, &'static Unit, Word, Of); 10] = [
            ("time", terms::time, &SECOND, tables::time_of_course_about, |s| Some(s.time_s)),
            ("position", tables::angle, &DEGREE, tables::of_the_output, |s| Some(s.position_rad)),
            ("speed", terms::rotary_speed, &REVOLUTION_PER_MINUTE, tables::of_the_output, |s| Some(s.speed_rad_s)),
            ("acceleration", terms::acceleration, &RADIAN_PER_SECOND_SQUARED, tables::of_the_output, |s| {
                Some(s.acceleration_rad_s2)
            }),
            ("torque", tables::torque, &NEWTON_METRE, of_torque, |s| Some(s.torque_nm)),
            ("current", tables::motor_current, &AMPERE, tables::motor_current_about, |s| s.current_a),
            ("power", tables::power, &WATT, tables::power_about, |s| s.power_w),
            ("winding", terms::winding, &DEGREE_CELSIUS, tables::temperature_about, |s| s.winding_k),
            ("housing", terms::housing, &DEGREE_CELSIUS, tables::temperature_about, |s| s.housing_k),
            ("overload", tables::overload, &ONE, tables::overload_about, |s| s.overload),
        ];
        let columns = series
            .iter()
            .map(|(name, title, unit, about, _)| column(name, *title, ColumnContent::Number, Some(unit), *about, l))
            .collect();
        let row = |sample: &Sample| series.map(|(.., unit, _, of)| of(sample).map(|si| unit.from_si(si)));
        let rows = match format.course_left_out(self.project) {
            Some(rows) => Rows::left_out(rows),
            None => Rows::series(course(self.project, self.chosen).samples.iter().map(row)),
        };
        self.made("course", tables::course, tables::course_about, columns, rows)
    }
}
