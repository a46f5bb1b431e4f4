//! Catalogue files in CSV: a product for each row, a key for each column, its unit in the heading.
//!
//! A table becomes the text of a catalogue file in TOML, which is read like any other; the places of its faults are those
//! of the table.

use crate::fault::{AxisDiagnostic, AxisFault};
use project::sections::{ActuatorEntry, Section};
use project::{Diagnostic, Fault, Hint, Key, Kind, TabularFault, nearest_name, shortened};
use quantities::Dimension;
use recording::{Records, RowKind};
use std::fmt::Write;

/// Heading of a column that names the kind of the product.
const KIND: &str = "kind";

/// Kind of the products of a table without such a column.
const ACTUATOR: &str = "actuator";

/// Signs that stand for a value that is not stated.
const NOT_STATED: [&str; 4] = ["", "-", "–", "—"];

/// Largest number of characters of a cell or a heading that a fault repeats.
const SHOWN_MOST: usize = 60;

/// A table as the text of a catalogue file.
pub(crate) struct CsvText {
    /// Text in TOML.
    pub(crate) toml: String,
    /// Places of the cells.
    pub(crate) places: Places,
    /// Headings of keys with units.
    pub(crate) headings: Vec<UnitHeading>,
    /// Faults of headings and lines.
    pub(crate) faults: Vec<AxisDiagnostic>,
}

/// Heading of a key with its unit.
pub(crate) struct UnitHeading {
    /// Name of the key.
    pub(crate) key: &'static str,
    /// Heading as written.
    pub(crate) text: String,
    /// Unit as written.
    pub(crate) unit: String,
    /// Line, from one.
    pub(crate) line: usize,
    /// Column in characters, from one.
    pub(crate) column: usize,
}

/// Places of the cells of a table, by the beginning of their lines in the text.
#[derive(Default)]
pub(crate) struct Places(Vec<(usize, usize, usize)>);

impl Places {
    /// Returns line and column of the table for a place in the text.
    pub(crate) fn at(&self, place: usize) -> (usize, usize) {
        let next = self.0.partition_point(|(start, ..)| *start <= place);
        let found = next.checked_sub(1).and_then(|index| self.0.get(index));
        found.map_or((1, 1), |(_, line, column)| (*line, *column))
    }

    /// Returns the line of the table for a place in the text.
    pub(crate) fn line_of(&self, place: usize) -> usize {
        self.at(place).0
    }

    /// Returns a fault of the text at its place in the table.
    pub(crate) fn moved(&self, fault: AxisDiagnostic) -> AxisDiagnostic {
        let (line, column) = self.at(fault.span.start);
        Diagnostic { span: 0..0, line, column, ..fault }
    }
}

/// A column that is read.
enum Column {
    /// Values of a key, and the unit of its numbers as written.
    Of(&'static Key, Option<String>),
    /// Kind of the product.
    Kind,
    /// A column with a fault, which is reported already.
    Refused,
}

fn name_of(heading: &str) -> (String, Option<String>) {
    let (name, unit) = recording::name_and_unit(heading);
    (name.trim().to_lowercase().replace([' ', '-'], "_"), unit)
}

fn key_of(name: &str) -> Option<&'static Key> {
    ActuatorEntry::KEYS.iter().find(|key| key.name == name)
}

const fn dimension_of(key: &Key) -> Option<Dimension> {
    match key.kind {
        Kind::Quantity(dimension, _) => Some(dimension),
        _ => None,
    }
}

/// Returns a table as the text of a catalogue file.
pub(crate) fn as_toml(name: &str, bytes: &[u8]) -> CsvText {
    let mut found =
        CsvText { toml: String::new(), places: Places::default(), headings: Vec::new(), faults: Vec::new() };
    let of_file = |fault| AxisFault::Recording { name: name.to_owned(), fault };
    let is_known = |cell: &str| matches!(name_of(cell).0, known if known == KIND || key_of(&known).is_some());
    let mut records = match Records::open_below(bytes, is_known) {
        Ok(records) => records,
        Err(fault) => {
            found.fault((1, 1), of_file(fault), None);
            return found;
        }
    };
    let headings = records.headings().to_vec();
    if headings.is_empty() {
        found.fault((1, 1), AxisFault::NoProducts, None);
        return found;
    }
    let heading_line = usize::try_from(records.line()).unwrap_or(usize::MAX);
    let starts = starts(&records.text(), &headings);
    let place = |index: usize| (heading_line, starts.get(index).copied().unwrap_or(1));
    let mut columns: Vec<Column> = Vec::with_capacity(headings.len());
    for (index, heading) in headings.iter().enumerate() {
        let (column, fault) = match column(heading, index, &headings) {
            Ok(column) => (column, None),
            Err(fault) => (Column::Refused, Some(fault)),
        };
        if let Column::Of(key, Some(unit)) = &column {
            let (line, column) = place(index);
            found.headings.push(UnitHeading { key: key.name, text: heading.clone(), unit: unit.clone(), line, column });
        }
        columns.push(column);
        if let Some(fault) = fault {
            let (fault, hint) = *fault;
            found.fault(place(index), fault, hint);
        }
    }
    loop {
        match records.advance() {
            Ok(true) => found.row(&mut records, &mut columns, &place, &of_file),
            Ok(false) => break,
            Err(fault) => {
                let line = usize::try_from(records.line()).unwrap_or(usize::MAX);
                let is_last = !matches!(fault, recording::Fault::LineTooLong { .. });
                found.fault((line, 1), of_file(fault), None);
                if is_last {
                    break;
                }
            }
        }
    }
    let is_number = |index: usize| matches!(columns.get(index), Some(Column::Of(key, _)) if is_number(key));
    if let Some(fault) = records.thousands(RowKind::Entries, is_number) {
        found.fault((heading_line, 1), of_file(fault), None);
    }
    found
}

/// Returns `true` if the cells of a key are numbers.
const fn is_number(key: &Key) -> bool {
    matches!(key.kind, Kind::Quantity(..) | Kind::Number(..) | Kind::Integer(..))
}

/// Reads a heading.
fn column(heading: &str, index: usize, all: &[String]) -> Result<Column, Box<(AxisFault, Option<Hint>)>> {
    let fault = |fault: Fault, hint| Err(Box::new((AxisFault::from(fault), hint)));
    if heading.is_empty() {
        return fault(Fault::Tabular(TabularFault::NoHeading { number: index + 1 }), None);
    }
    let (name, unit) = name_of(heading);
    let path = || shortened(heading, SHOWN_MOST);
    if all.iter().take(index).any(|other| name_of(other).0 == name) {
        return fault(Fault::Tabular(TabularFault::ColumnTwice { path: path() }), None);
    }
    if name == KIND {
        return Ok(Column::Kind);
    }
    let Some(key) = key_of(&name) else {
        let names: Vec<&str> = ActuatorEntry::KEYS.iter().map(|key| key.name).chain([KIND]).collect();
        return fault(Fault::UnknownKey { path: path() }, Some(nearest_name(&name, &names)));
    };
    if matches!(key.kind, Kind::Rows(_)) {
        return fault(Fault::Tabular(TabularFault::NoColumn { path: path() }), None);
    }
    let Some(unit) = unit else { return Ok(Column::Of(key, None)) };
    let Some(dimension) = dimension_of(key) else {
        let unit = shortened(&unit, SHOWN_MOST);
        return fault(Fault::Tabular(TabularFault::UnitOfNoQuantity { path: name, unit }), None);
    };
    match quantities::parse(dimension, &format!("1 {unit}")) {
        Ok(_) => Ok(Column::Of(key, Some(unit))),
        Err(error) => fault(Fault::Quantity { path: name, error, also: Vec::new() }, None),
    }
}

fn example(key: &Key, dimension: Dimension) -> String {
    format!("{} [{}]", key.name, dimension.units().first().map_or("", |unit| unit.ascii))
}

/// Returns the columns in characters, from one, at which cells begin in a line.
fn starts(line: &str, cells: &[String]) -> Vec<usize> {
    let mut from = 0;
    let mut found = Vec::with_capacity(cells.len());
    let (mut counted, mut characters) = (0, 0);
    for cell in cells {
        let at = line.get(from..).and_then(|rest| rest.find(cell.trim())).map_or(from, |at| from + at);
        characters += line.get(counted..at).unwrap_or_default().chars().count();
        counted = at;
        found.push(characters + 1);
        from = (at + cell.trim().len()).min(line.len());
        // The delimiter behind the cell belongs to it, so that an empty cell begins behind it.
        from += line.get(from..).and_then(|rest| rest.chars().next()).map_or(0, char::len_utf8);
    }
    found
}

impl CsvText {
    fn fault(&mut self, (line, column): (usize, usize), fault: AxisFault, hint: Option<Hint>) {
        self.faults.push(Diagnostic { span: 0..0, line, column, fault, hint });
    }

    /// Adds the product of a row.
    fn row<R: std::io::Read>(
        &mut self,
        records: &mut Records<R>,
        columns: &mut [Column],
        heading: &dyn Fn(usize) -> (usize, usize),
        of_file: &dyn Fn(recording::Fault) -> AxisFault,
    ) {
        let line = usize::try_from(records.line()).unwrap_or(usize::MAX);
        let text = records.text();
        let mut cells: Vec<(String, Option<f64>)> = Vec::with_capacity(columns.len());
        if let Err(fault) = records.numbers(|_, number, cell| cells.push((cell.trim().to_owned(), number))) {
            return self.fault((line, 1), of_file(fault), None);
        }
        if cells.iter().all(|(cell, _)| NOT_STATED.contains(&cell.as_str())) {
            return;
        }
        let texts: Vec<String> = cells.iter().map(|(cell, _)| cell.clone()).collect();
        let starts = starts(&text, &texts);
        self.places.0.push((self.toml.len(), line, 1));
        self.toml.push_str("[[actuator]]\n");
        for (index, (cell, number)) in cells.iter().enumerate() {
            let place = (line, starts.get(index).copied().unwrap_or(1));
            let Some(column) = columns.get_mut(index) else { continue };
            if NOT_STATED.contains(&cell.as_str()) {
                continue;
            }
            match column {
                Column::Refused => {}
                Column::Kind if cell.eq_ignore_ascii_case(ACTUATOR) => {}
                Column::Kind => {
                    let fault = Fault::NotAChoice { path: KIND.to_owned(), written: shortened(cell, SHOWN_MOST) };
                    self.fault(place, fault.into(), Some(Hint::valid(&[ACTUATOR])));
                }
                Column::Of(key, unit) => {
                    if let (Some(dimension), None, Some(_)) = (dimension_of(key), unit.as_ref(), number) {
                        let hint = Hint::DidYouMean(example(key, dimension));
                        let fault = Fault::BareNumber { path: key.name.to_owned(), dimension };
                        self.fault(heading(index), fault.into(), Some(hint));
                        *column = Column::Refused;
                        continue;
                    }
                    self.places.0.push((self.toml.len(), line, place.1));
                    let value = value(key, unit.as_deref(), cell, *number);
                    // Writing to a text does not fail.
                    let _ = writeln!(self.toml, "{} = {value}", key.name);
                }
            }
        }
    }
}

/// Returns a cell as the value of its key.
fn value(key: &Key, unit: Option<&str>, cell: &str, number: Option<f64>) -> String {
    match (key.kind, unit, number) {
        (Kind::Quantity(..), Some(unit), Some(number)) => quoted(&format!("{number} {unit}")),
        (Kind::Number(..) | Kind::Integer(..), _, Some(number)) => number.to_string(),
        (Kind::Bool, ..) if ["true", "false"].contains(&cell.to_lowercase().as_str()) => cell.to_lowercase(),
        _ => quoted(cell),
    }
}

/// Returns a text as a string of TOML.
fn quoted(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    for sign in text.chars() {
        match sign {
            '"' | '\\' => out.extend(['\\', sign]),
            control if control.is_control() => {
                // Writing to a text does not fail.
                let _ = write!(out, "\\u{:04X}", u32::from(control));
            }
            other => out.push(other),
        }
    }
    out.push('"');
    out
}
