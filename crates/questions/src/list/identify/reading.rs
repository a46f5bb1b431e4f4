//! Columns of a recorded run, read and checked row by row.

use super::super::{Inquiry, Unanswered};
use super::headings;
use crate::Refusal;
use crate::progress::Stopped;
use quantities::{Language, format_significant, seen};
use recording::{Bytes, Content, Fault, Memory, Records, RowKind};
use std::io::Read;
use twin::{IdentifyFault, Observed};
use words::{Word, file_trouble, identification, recording_text, simulation};

/// Largest size of the file of a run.
const TRACE_MOST: u64 = 256 << 20;

/// Largest number of rows without a time limit: some ten seconds on one core, with the search for delays.
const ROWS_MOST: usize = 1 << 21;

/// Approximate time that this number takes \[s\].
const SECONDS: usize = 10;

/// Largest number of faults that are reported.
const FAULTS_MOST: usize = 20;

/// A column with its heading, as written by `simulate --out`, and the largest value that a machine can show, in its
/// unit.
struct Column {
    heading: &'static str,
    signal: Word,
    most: f64,
    required: bool,
}

/// Columns of a run. There is no column of the acceleration, which follows from the position.
///
/// The bounds are a choice: a million revolutions, a motor of 10⁶ 1/min not divided by i, times since 1970.
const COLUMNS: [Column; 6] = [
    Column { heading: "time_s", signal: identification::signal_time, most: 1e10, required: true },
    Column { heading: "position_rad", signal: identification::signal_position, most: 1e7, required: true },
    Column { heading: "speed_rad_s", signal: identification::signal_speed, most: 1e6, required: false },
    Column { heading: "motor_speed_rad_s", signal: identification::signal_motor_speed, most: 1e6, required: true },
    Column { heading: "torque_nm", signal: identification::signal_torque, most: 1e6, required: true },
    Column { heading: "current_q_a", signal: identification::signal_current, most: 1e5, required: true },
];

/// Place of the column of time.
const TIME: usize = 0;

/// A run with the lines of its rows.
pub(super) struct RecordedRun {
    pub(super) observed: Observed,
    /// Line of each row, from 1; empty where rows are numbered.
    pub(super) lines: Vec<usize>,
    /// Headings in words that were taken for columns, as text.
    pub(super) taken: Vec<String>,
}

/// Columns of a file, and their faults.
#[derive(Default)]
struct Columns {
    values: [Option<Vec<f64>>; COLUMNS.len()],
    lines: Vec<usize>,
    faults: Vec<String>,
    /// Headings of the file.
    headings: Vec<String>,
    /// Headings in words that were taken for columns, as text.
    taken: Vec<String>,
    /// Line with headings of a run below those read.
    headings_below: Option<u64>,
    /// Number of rows, if they are more than permitted; their values are not kept.
    too_many: Option<u64>,
}

/// Reads the run of a file, in the packings and dialects of recordings, within the memory of the project. The rows are counted
/// first; more than [`ROWS_MOST`] are refused unless the call states a time limit.
///
/// # Errors
/// Every fault, each with its line and column.
pub(super) fn run(inquiry: &Inquiry<'_>, name: &str) -> Result<RecordedRun, Unanswered> {
    let language = inquiry.language;
    let unread = |error: std::io::Error| {
        Unanswered::message(simulation::trace_unread(&seen(name), &file_trouble(&error, language), language))
    };
    let source = inquiry.source()?;
    let mut memory = Memory::new(source.files.grant().memory).until(Some(inquiry.progress.flag()));
    let (content, file) = source.files.open(name).and_then(recording::opened).map_err(unread)?;
    let most = if inquiry.refuses_long { ROWS_MOST as u64 } else { u64::MAX };
    // One byte above the limit shows that the file is larger.
    let mut file = file.take(TRACE_MOST + 1);
    let columns = match content {
        Content::Parquet => {
            let mut bytes = Vec::new();
            let _ = file.read_to_end(&mut bytes).map_err(unread)?;
            if file.limit() > 0 { of_parquet(bytes, &mut memory, most, language) } else { Columns::default() }
        }
        Content::Foreign(format) => Columns::unread(&[Fault::Foreign { format }], language),
        Content::Text | Content::Packed(_) => of_csv(&mut file, &mut memory, most, language),
    };
    if file.limit() == 0 {
        return Err(Unanswered::message(simulation::trace_too_large(&seen(name), &(TRACE_MOST >> 20), language)));
    }
    if inquiry.progress.is_over() {
        return Err(Unanswered::Refused(Refusal::from(Stopped), None));
    }
    if let Some(rows) = columns.too_many {
        return Err(Unanswered::message(identification::too_many_rows(&rows, &ROWS_MOST, &SECONDS, language)));
    }
    let run = columns.run(language);
    let run = run.map_err(|faults| Unanswered::combined(faults.into_iter().map(Unanswered::message).collect()))?;
    let needed = WORK_BYTES * run.observed.time_s.len() as u64;
    memory.take(needed).map_err(|fault| Unanswered::message(recording_text(&fault, language)))?;
    Ok(run)
}

/// Returns the reason why nothing is estimated.
pub(super) fn refused(lines: &[usize], why: &IdentifyFault, language: Language) -> Unanswered {
    let degrees = |angle: f64| format_significant(angle.to_degrees(), 2, language);
    let line = |row: usize| lines.get(row).copied().unwrap_or(row + 1);
    let text = match why {
        IdentifyFault::Uneven | IdentifyFault::TooFew => simulation::trace_too_short(language).to_owned(),
        IdentifyFault::NotExcited => simulation::trace_not_excited(language).to_owned(),
        IdentifyFault::TimeNotRising(row) => identification::time_not_rising(&line(*row), language),
        IdentifyFault::TooCoarse { step_rad, most_rad } => {
            identification::too_coarse(&degrees(*step_rad), &degrees(*most_rad), language)
        }
        IdentifyFault::OtherMotion => identification::other_motion(language).to_owned(),
        IdentifyFault::AmbiguousMotion => identification::ambiguous_motion(language).to_owned(),
        IdentifyFault::Stopped => return Unanswered::Refused(Refusal::from(Stopped), None),
    };
    Unanswered::message(text)
}

impl Columns {
    /// Returns the faults of a file that cannot be read; further faults are unknown.
    fn unread(why: &[Fault], language: Language) -> Self {
        let mut found = Self { values: COLUMNS.map(|_| Some(Vec::new())), ..Self::default() };
        found.add(why, language);
        found
    }

    fn add(&mut self, why: &[Fault], language: Language) {
        self.faults.extend(why.iter().map(|fault| recording_text(fault, language)));
    }

    fn run(mut self, language: Language) -> Result<RecordedRun, Vec<String>> {
        let there = COLUMNS.iter().zip(&self.values);
        let lacking: Vec<&str> = there
            .filter(|(column, values)| column.required && values.is_none())
            .map(|(column, _)| column.heading)
            .collect();
        if !lacking.is_empty() {
            let mut text = simulation::trace_lacks(&lacking.join(", "), language);
            if let Some(line) = self.headings_below {
                text.push_str(&identification::headings_below(&line, &(line - 1), language));
            } else if !self.headings.is_empty() {
                text.push_str(&headings::proposed(&lacking, &self.headings, language));
            }
            self.faults.insert(0, text);
        }
        if !self.faults.is_empty() {
            return Err(self.faults);
        }
        let [time_s, position_rad, speed_rad_s, motor_rad_s, torque_nm, current_q_a] = self.values;
        let [time_s, position_rad, motor_rad_s, torque_nm, current_q_a] =
            [time_s, position_rad, motor_rad_s, torque_nm, current_q_a].map(Option::unwrap_or_default);
        let observed = Observed { time_s, position_rad, speed_rad_s, motor_rad_s, torque_nm, current_q_a };
        Ok(RecordedRun { observed, lines: self.lines, taken: self.taken })
    }
}

/// Returns the fault of a value that no machine shows.
fn out_of_range(line: usize, column: &Column, value: f64, language: Language) -> String {
    let number = |value: f64| format_significant(value, 4, language);
    identification::out_of_range(&line, &column.heading, &number(value), &number(column.most), language)
}

/// Place of a column of the file among [`COLUMNS`], and the factor of its values.
type Place = (usize, f64);

/// Returns the place of each column of a file: by its heading as `simulate --out` writes it, the first where it is repeated;
/// else by words and a unit that only one heading has.
fn places(headings: &[String]) -> Vec<Option<Place>> {
    let mut places: Vec<Option<Place>> = vec![None; headings.len()];
    for (place, column) in COLUMNS.iter().enumerate() {
        let exact = headings.iter().position(|heading| heading == column.heading).map(|at| (at, 1.0));
        let Some((at, factor)) = exact.or_else(|| headings::meant(column.heading, headings)) else { continue };
        if let Some(free) = places.get_mut(at).filter(|free| free.is_none()) {
            *free = Some((place, factor));
        }
    }
    places
}

/// Returns which headings in words are taken for which columns, as text.
fn taken(headings: &[String], places: &[Option<Place>], language: Language) -> Vec<String> {
    let pairs = headings.iter().zip(places).filter_map(|(heading, place)| Some((heading, COLUMNS.get((*place)?.0)?)));
    let in_words = pairs.filter(|(heading, column)| heading.as_str() != column.heading);
    let text = |(heading, column): (&String, &Column)| {
        let signal = (column.signal)(language);
        identification::taken_as(&seen(heading), &column.heading, &signal, language)
    };
    in_words.map(text).collect()
}

fn of_parquet(bytes: Vec<u8>, memory: &mut Memory, most: u64, language: Language) -> Columns {
    let held = bytes.len() as u64;
    let file = Bytes::from(bytes);
    match recording::row_count(&file) {
        Ok(rows) if rows > most => return Columns { too_many: Some(rows), ..Columns::default() },
        Ok(_) => {}
        Err(fault) => return Columns::unread(&[fault], language),
    }
    let read = memory.take(held).map_err(|fault| vec![fault]).and_then(|()| {
        let names = recording::column_names(&file).map_err(|fault| vec![fault])?;
        let places = places(&names);
        let named = |place: usize| {
            let at = places.iter().position(|found| found.is_some_and(|(of, _)| of == place))?;
            Some((names.get(at)?.as_str(), places.get(at).copied()??.1))
        };
        let wanted: [(&str, f64); COLUMNS.len()] = std::array::from_fn(|place| {
            named(place).unwrap_or((COLUMNS.get(place).map_or("", |column| column.heading), 1.0))
        });
        let values = recording::read_columns(&file, &wanted.map(|(name, _)| name), memory)?;
        let taken = taken(&names, &places, language);
        Ok((values, wanted.map(|(_, factor)| factor), taken, names))
    });
    let (values, factors, taken, names) = match read {
        Ok(read) => read,
        Err(faults) => return Columns::unread(&faults, language),
    };
    let mut found = Columns { headings: names, taken, ..Columns::default() };
    for (((place, values), column), factor) in found.values.iter_mut().zip(values).zip(&COLUMNS).zip(factors) {
        *place = values;
        place.iter_mut().flatten().for_each(|value| *value *= factor);
        let cells = place.iter().flatten().zip(1_usize..).filter(|(value, _)| value.abs() > column.most);
        let left = FAULTS_MOST.saturating_sub(found.faults.len());
        found.faults.extend(cells.take(left).map(|(value, row)| out_of_range(row, column, *value, language)));
    }
    found
}

/// Counts the remaining rows of a run with too many.
fn counted(records: &mut Records<impl Read>, read: u64, memory: &Memory, language: Language) -> Columns {
    let mut rows = read;
    loop {
        let advanced = if rows.is_multiple_of(ROWS_COUNTED as u64) { memory.go_on() } else { Ok(()) };
        match advanced.and_then(|()| records.advance()) {
            Ok(true) | Err(Fault::LineTooLong { .. }) => rows += 1,
            Ok(false) => return Columns { too_many: Some(rows), ..Columns::default() },
            Err(fault) => return Columns::unread(&[fault], language),
        }
    }
}

/// Bytes of a row during the work: its speed, and its numbers again with shifted signals.
const WORK_BYTES: u64 = 8 * (2 * COLUMNS.len() as u64 + 2);

/// Bytes of a row: its numbers and its line.
const ROW_BYTES: u64 = 8 * (COLUMNS.len() as u64 + 1);

/// Number of rows that are counted together.
const ROWS_COUNTED: usize = 4096;

fn of_csv(file: impl Read, memory: &mut Memory, most: u64, language: Language) -> Columns {
    let mut records = match Records::open(file) {
        Ok(records) => records,
        Err(fault) => return Columns::unread(&[fault], language),
    };
    let places = places(records.headings());
    let mut found = Columns { taken: taken(records.headings(), &places, language), ..Columns::default() };
    for (place, _) in places.iter().flatten() {
        if let Some(values) = found.values.get_mut(*place) {
            *values = Some(Vec::new());
        }
    }
    found.headings = records.headings().to_vec();
    // Where no column is known there is nothing to read below.
    let is_of_run = places.iter().any(Option::is_some);
    if !is_of_run {
        found.headings_below =
            headings::below(&mut records, |cell| COLUMNS.iter().any(|column| column.heading == cell));
    }
    // A date in the column of time is one fault for all rows.
    let mut has_clock = false;
    let mut is_first_row = true;
    while is_of_run && found.faults.len() < FAULTS_MOST {
        if found.lines.len().is_multiple_of(ROWS_COUNTED) {
            let granted = memory.go_on().and_then(|()| memory.take(ROW_BYTES * ROWS_COUNTED as u64));
            if let Err(fault) = granted {
                return Columns::unread(&[fault], language);
            }
        }
        match records.advance() {
            Ok(true) => {}
            Ok(false) => break,
            // The next line follows it.
            Err(fault @ Fault::LineTooLong { .. }) => {
                found.add(&[fault], language);
                continue;
            }
            Err(fault) => return Columns::unread(&[fault], language),
        }
        let line = usize::try_from(records.line()).unwrap_or(usize::MAX);
        if std::mem::take(&mut is_first_row) {
            let heading_of = |index: usize| Some(COLUMNS.get(places.get(index).copied()??.0)?.heading);
            if let Some(others) = headings::of_units(&mut records, heading_of, language) {
                if !others.is_empty() {
                    found.faults.push(identification::unit_row(&line, &others.join(", "), language));
                }
                continue;
            }
        }
        if found.lines.len() as u64 == most {
            return counted(&mut records, most + 1, memory, language);
        }
        found.lines.push(line);
        let Columns { values, faults, .. } = &mut found;
        let row = records.numbers(|index, number, cell| {
            let Some((place, factor)) = places.get(index).copied().flatten() else { return };
            let number = number.map(|number| number * factor);
            let (Some(column), Some(Some(values))) = (COLUMNS.get(place), values.get_mut(place)) else { return };
            // A fault keeps its place, so that rows and numbers stay aligned.
            values.push(number.unwrap_or_default());
            let fault = match number {
                Some(value) if value.abs() > column.most => out_of_range(line, column, value, language),
                Some(_) => return,
                None if place == TIME && headings::is_clock(cell) => {
                    if std::mem::replace(&mut has_clock, true) {
                        return;
                    }
                    identification::time_of_day(&line, &seen(cell), language)
                }
                None => simulation::trace_not_a_number(&line, &column.heading, language),
            };
            if faults.len() < FAULTS_MOST {
                faults.push(fault);
            }
        });
        if let Err(fault) = row {
            found.add(&[fault], language);
        }
    }
    // Numbers that may be a thousand times larger make every other fault of a cell doubtful.
    if let Some(fault) = records.thousands(RowKind::Samples, |index| places.get(index).copied().flatten().is_some()) {
        found.faults.clear();
        found.add(&[fault], language);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Headings in words with a unit give the values of the columns, in every order, language and unit; what is not clear stays
    /// unread: two headings of one signal, a heading without a unit, the unit of another quantity, a motor's signal for that of the load.
    #[test]
    fn headings_in_words_are_taken_for_columns_with_their_factors() {
        let factors = |headings: &[&str]| {
            let headings: Vec<String> = headings.iter().map(|heading| (*heading).to_owned()).collect();
            let places = places(&headings);
            places.iter().map(|place| place.map(|(at, factor)| (COLUMNS[at].heading, factor))).collect::<Vec<_>>()
        };
        let (time, degree, rpm) = (Some(("time_s", 1e-3)), std::f64::consts::PI / 180.0, std::f64::consts::PI / 30.0);
        for headings in [
            ["Zeit [ms]", "Lage [°]", "Motordrehzahl [1/min]", "Drehmoment [mNm]", "Iq [A]", "Temperatur [°C]"],
            ["time (ms)", "actual position (deg)", "motor speed (rpm)", "torque (mN m)", "current (A)", "note"],
        ] {
            let found = factors(&headings);
            let near = |at: usize, column: &str, factor: f64| {
                let (name, of) = found[at].unwrap_or_else(|| panic!("{headings:?}: {at}"));
                assert!(name == column && (of / factor - 1.0).abs() < 1e-12, "{name} {of}");
            };
            assert_eq!((found[0], found[5]), (time, None));
            near(1, "position_rad", degree);
            near(2, "motor_speed_rad_s", rpm);
            near(3, "torque_nm", 1e-3);
            near(4, "current_q_a", 1.0);
        }
        for unclear in [
            &["Zeit", "pos"][..],
            &["Lage 1 [°]", "Lage 2 [°]"],
            &["position [V]", "torque [A]"],
            &["Motorlage [°]", "Motorstrom [Nm]"],
        ] {
            assert!(factors(unclear).iter().all(Option::is_none), "{unclear:?}");
        }
        // The own name of a column is the first choice.
        assert_eq!(factors(&["Zeit [ms]", "time_s", "time_s"]), [None, Some(("time_s", 1.0)), None]);
    }

    /// The rows of a text are counted up to its end, the values of too many are not kept.
    #[test]
    fn rows_of_a_text_are_counted() {
        let text =
            format!("time_s,position_rad,motor_speed_rad_s,torque_nm,current_q_a\n{}", "0,0,0,0,0\n".repeat(9000));
        let read = |most| of_csv(text.as_bytes(), &mut Memory::default(), most, Language::En);
        assert_eq!((read(9000).too_many, read(9000).lines.len()), (None, 9000));
        for most in [0, 1, 4095, 4096, 8999] {
            let columns = read(most);
            assert_eq!((columns.too_many, columns.lines.len(), columns.faults), (Some(9000), 0, Vec::new()), "{most}");
        }
    }
}
