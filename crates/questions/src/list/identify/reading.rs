//! The columns of a recorded run, read and checked row by row.

use super::super::{Asked, Unanswered};
use quantities::{Language, format_significant, seen};
use recording::{Bytes, Memory};
use std::io::Read as _;
use twin::{IdentifyFault, Observed};
use words::{identification, recording_text, simulation};

/// Largest size of the file of a run.
const TRACE_MOST: u64 = 256 << 20;

/// Largest number of faults that are reported.
const FAULTS_MOST: usize = 20;

/// A column with its heading, as `simulate --out` writes it, and the largest value that a machine can show, in its unit.
struct Column {
    heading: &'static str,
    most: f64,
    required: bool,
}

/// The columns that are read. An acceleration is not: it follows from the position.
///
/// The bounds are a choice: a million revolutions, a motor of 10⁶ 1/min not divided by i, times since 1970.
const COLUMNS: [Column; 6] = [
    Column { heading: "time_s", most: 1e10, required: true },
    Column { heading: "position_rad", most: 1e7, required: true },
    Column { heading: "speed_rad_s", most: 1e6, required: false },
    Column { heading: "motor_speed_rad_s", most: 1e6, required: true },
    Column { heading: "torque_nm", most: 1e6, required: true },
    Column { heading: "current_q_a", most: 1e5, required: true },
];

/// A run with the lines of its rows.
pub(super) struct Run {
    pub(super) observed: Observed,
    /// Line of each row, from 1; empty where rows are numbered.
    lines: Vec<usize>,
}

/// The columns of a file and what is wrong in them.
#[derive(Default)]
struct Columns {
    values: [Option<Vec<f64>>; COLUMNS.len()],
    lines: Vec<usize>,
    faults: Vec<String>,
}

/// Reads the run of a file.
///
/// # Errors
/// Every fault, each with its line and column.
pub(super) fn run(asked: &Asked<'_>, name: &str) -> Result<Run, Unanswered> {
    let language = asked.language;
    let mut bytes = Vec::new();
    let source = asked.source()?;
    let read = source.files.open(name).and_then(|file| file.take(TRACE_MOST + 1).read_to_end(&mut bytes));
    read.map_err(|_| Unanswered::message(simulation::no_such_trace(&seen(name), language)))?;
    if bytes.len() as u64 > TRACE_MOST {
        return Err(Unanswered::message(simulation::trace_too_large(&seen(name), &(TRACE_MOST >> 20), language)));
    }
    let memory = source.files.grant().memory;
    let columns =
        if bytes.starts_with(b"PAR1") { of_parquet(bytes, memory, language) } else { of_csv(&bytes, language) };
    columns.run(language).map_err(|faults| Unanswered::together(faults.into_iter().map(Unanswered::message).collect()))
}

impl Run {
    fn line(&self, row: usize) -> usize {
        self.lines.get(row).copied().unwrap_or(row + 1)
    }

    /// Returns why nothing is estimated.
    pub(super) fn refused(&self, why: &IdentifyFault, language: Language) -> String {
        let degrees = |angle: f64| format_significant(angle.to_degrees(), 2, language);
        match why {
            IdentifyFault::Uneven | IdentifyFault::TooFew => simulation::trace_too_short(language).to_owned(),
            IdentifyFault::NotExcited => simulation::trace_not_excited(language).to_owned(),
            IdentifyFault::TimeNotRising(row) => identification::time_not_rising(&self.line(*row), language),
            IdentifyFault::TooCoarse { step_rad, most_rad } => {
                identification::too_coarse(&degrees(*step_rad), &degrees(*most_rad), language)
            }
            IdentifyFault::OtherMotion => identification::other_motion(language).to_owned(),
            IdentifyFault::AmbiguousMotion => identification::ambiguous_motion(language).to_owned(),
        }
    }
}

impl Columns {
    fn fault(&mut self, fault: impl FnOnce() -> String) {
        if self.faults.len() < FAULTS_MOST {
            self.faults.push(fault());
        }
    }

    fn run(mut self, language: Language) -> Result<Run, Vec<String>> {
        let there = COLUMNS.iter().zip(&self.values);
        let lacking: Vec<&str> = there
            .filter(|(column, values)| column.required && values.is_none())
            .map(|(column, _)| column.heading)
            .collect();
        if !lacking.is_empty() {
            self.faults.insert(0, simulation::trace_lacks(&lacking.join(", "), language));
        }
        if !self.faults.is_empty() {
            return Err(self.faults);
        }
        let [time_s, position_rad, speed_rad_s, motor_rad_s, torque_nm, current_q_a] = self.values;
        let [time_s, position_rad, motor_rad_s, torque_nm, current_q_a] =
            [time_s, position_rad, motor_rad_s, torque_nm, current_q_a].map(Option::unwrap_or_default);
        let observed = Observed { time_s, position_rad, speed_rad_s, motor_rad_s, torque_nm, current_q_a };
        Ok(Run { observed, lines: self.lines })
    }
}

/// Why a value is refused that no machine shows.
fn out_of_range(line: usize, column: &Column, value: f64, language: Language) -> String {
    let number = |value: f64| format_significant(value, 4, language);
    identification::out_of_range(&line, &column.heading, &number(value), &number(column.most), language)
}

fn of_parquet(bytes: Vec<u8>, memory: u64, language: Language) -> Columns {
    let mut found = Columns::default();
    let headings = COLUMNS.map(|column| column.heading);
    match recording::read_columns(&Bytes::from(bytes), &headings, &mut Memory::new(memory)) {
        Ok(values) => {
            for ((place, values), column) in found.values.iter_mut().zip(values).zip(&COLUMNS) {
                *place = values;
                let cells = place.iter().flatten().zip(1_usize..).filter(|(value, _)| value.abs() > column.most);
                let left = FAULTS_MOST.saturating_sub(found.faults.len());
                found.faults.extend(cells.take(left).map(|(value, row)| out_of_range(row, column, *value, language)));
            }
        }
        // What is missing besides is not known of a file that cannot be read.
        Err(faults) => {
            found.faults = faults.iter().map(|fault| recording_text(fault, language)).collect();
            found.values = COLUMNS.map(|_| Some(Vec::new()));
        }
    }
    found
}

fn of_csv(bytes: &[u8], language: Language) -> Columns {
    let text = String::from_utf8_lossy(bytes);
    let mut lines = (1_usize..).zip(text.lines()).filter(|(_, line)| !line.starts_with('#'));
    let heads: Vec<&str> =
        lines.next().map_or("", |(_, line)| line).trim_start_matches('\u{feff}').split(',').collect();
    let places = COLUMNS.map(|column| heads.iter().position(|head| head.trim() == column.heading));
    let mut found = Columns { values: places.map(|place| place.map(|_| Vec::new())), ..Columns::default() };
    for (line, text) in lines.filter(|(_, text)| !text.trim().is_empty()) {
        let cells: Vec<&str> = text.split(',').collect();
        found.lines.push(line);
        for ((index, place), column) in places.iter().enumerate().zip(&COLUMNS) {
            let Some(place) = place else { continue };
            let value = cells.get(*place).and_then(|cell| cell.trim().parse::<f64>().ok());
            match value.filter(|value| value.is_finite()) {
                Some(value) if value.abs() > column.most => {
                    found.fault(|| out_of_range(line, column, value, language));
                }
                Some(value) => {
                    if let Some(Some(values)) = found.values.get_mut(index) {
                        values.push(value);
                    }
                }
                None => found.fault(|| simulation::trace_not_a_number(&line, &column.heading, language)),
            }
        }
    }
    found
}
