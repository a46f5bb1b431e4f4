//! Cells of a table, and their faults.
#![allow(clippy::result_large_err, reason = "a fault is found once for a table, not for each of its rows")]

use super::{Column, Holds, Options, Value};
use crate::codes::{CodeRefusal, read_product};
use configurator::ProductId;
use project::{Fault, Heading, Hint, Kind, TabularFault, nearest_name};
use quantities::{Language, Unit, seen};
use recording::{Commas, RowKind, Thousands, may_be_grouped};
use std::borrow::Cow;
use words::{fault_text, hint_text, sweeps};

/// Cells of a column.
#[derive(Clone, Debug)]
pub enum Cells<'c> {
    /// Numbers; `None` for an empty cell.
    Numbers(Vec<Option<f64>>),
    /// Texts; `None` for an empty cell.
    Texts(Vec<Option<Cow<'c, str>>>),
    /// Another type, with its name and the number of cells.
    Other(String, usize),
}

/// A fault of a table at a column, and at a row if it is a fault of a cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CellFault {
    /// Original heading.
    pub heading: String,
    /// The row, counted from zero.
    pub row: Option<u64>,
    /// Stable identifier of the kind of fault.
    pub id: &'static str,
    /// The fault in one sentence.
    pub message: String,
    /// Expected content, or the nearest valid choice.
    pub hint: Option<String>,
}

/// Faults of a table: the first ones, and the number of further ones.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TableFaults {
    /// Faults in the order of detection.
    pub listed: Vec<CellFault>,
    /// Number of further faults.
    pub more: usize,
    /// `true` if the rest of the table was not read, because its headings are rejected.
    pub is_unread: bool,
}

/// Largest number of faults listed individually.
const LISTED_MOST: usize = 50;

/// Number of further faults after which the rest of a table is not checked, because it gives no new information: as in a recording.
const COUNTED_MOST: usize = 10_000;

impl TableFaults {
    /// Adds a fault.
    pub fn add(&mut self, fault: CellFault) {
        if self.listed.len() < LISTED_MOST {
            self.listed.push(fault);
        } else {
            self.more += 1;
        }
    }

    /// Returns `true` if checking the rest of the table is pointless.
    #[must_use]
    pub const fn is_enough(&self) -> bool {
        self.more >= COUNTED_MOST
    }

    /// Returns `true` if there is none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.listed.is_empty()
    }
}

impl CellFault {
    /// Creates a fault with its texts.
    #[must_use]
    pub fn of(heading: &str, row: Option<u64>, (fault, hint): &(Fault, Option<Hint>), language: Language) -> Self {
        let own = || words::own_hint(fault, language);
        let hint = hint.as_ref().map(|hint| hint_text(hint, language)).or_else(own);
        // A heading that may be a key or a label has a name under which it is a label.
        let label = label_of(heading);
        let label = label.map(|label| sweeps::as_a_label(&seen(&label), language));
        Self {
            heading: seen(heading).into_owned(),
            row,
            id: fault.id(),
            message: fault_text(fault, language),
            hint: match (hint, label) {
                (Some(hint), Some(label)) => Some(format!("{hint}; {label}")),
                (hint, label) => hint.or(label),
            },
        }
    }
}

/// Returns the name under which a column is carried instead of read as a key; `None` for a heading that is a path.
fn label_of(heading: &str) -> Option<String> {
    if heading.trim() == super::CODE || Heading::is_one(heading) {
        return None;
    }
    let name = heading.split('[').next().unwrap_or_default().trim();
    let label = format!("label_{}", name.replace(' ', "_"));
    (!name.is_empty() && !name.contains('.') && project::is_label(&label)).then_some(label)
}

impl Cells<'_> {
    /// Returns the number of cells.
    #[must_use]
    pub const fn len(&self) -> usize {
        match self {
            Self::Numbers(cells) => cells.len(),
            Self::Texts(cells) => cells.len(),
            Self::Other(_, count) => *count,
        }
    }

    /// Returns the cell of a row alone.
    pub(super) fn of_row(&self, row: usize) -> Cells<'static> {
        match self {
            Self::Numbers(cells) => Cells::Numbers(vec![cells.get(row).copied().flatten()]),
            Self::Texts(cells) => Cells::Texts(vec![
                cells.get(row).and_then(|cell| cell.as_ref().map(|text| Cow::Owned(text.clone().into_owned()))),
            ]),
            Self::Other(found, _) => Cells::Other(found.clone(), 1),
        }
    }

    /// Returns `true` if there is no cell.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Adds the faults of the cells under a heading.
    pub(super) fn check(
        &self,
        (place, column): (usize, &Column),
        first_row: u64,
        language: Language,
        decimals: &mut Decimals,
        faults: &mut TableFaults,
    ) {
        if let Self::Other(found, _) = self {
            let fault = Fault::Tabular(TabularFault::CellType { path: column.key().to_owned(), found: found.clone() });
            return faults.add(CellFault::of(&column.written, None, &(fault, None), language));
        }
        for row in 0..self.len() {
            if faults.is_enough() {
                return;
            }
            let at = first_row + row as u64;
            let wrong = |fault| Some(CellFault::of(&column.written, Some(at), &(fault, None), language));
            let found = match column.cell(self, row, decimals.commas) {
                Err(fault) => wrong(fault),
                Ok(Value::Text(text)) => column.wrong_word(text, at, language),
                Ok(Value::Number(_)) => {
                    decimals.note(place, self, row, at);
                    decimals.mixed(column, self, row).and_then(wrong)
                }
            };
            found.into_iter().for_each(|fault| faults.add(fault));
        }
    }
}

/// The decimal sign of a table: the first number with either sign decides, because `1.234` beside `5,6` may be a thousand.
#[derive(Clone, Debug)]
pub(super) struct Decimals {
    commas: Commas,
    has_comma: Option<bool>,
    thousands: Thousands,
}

impl Decimals {
    pub(super) fn of(options: &Options) -> Self {
        Self { commas: options.commas, has_comma: None, thousands: Thousands::of(options.commas) }
    }

    /// Adds the faults of columns in which every sign may separate thousands.
    pub(super) fn check<'c>(
        &self,
        columns: impl Fn(usize) -> Option<&'c Column>,
        language: Language,
        faults: &mut TableFaults,
    ) {
        for found in self.thousands.possible(RowKind::Entries) {
            let Some(column) = columns(found.column) else { continue };
            let (path, written) = (column.key().to_owned(), found.text.clone());
            let fault = Fault::Tabular(TabularFault::ThousandsPossible { path, written });
            faults.add(CellFault::of(&column.written, Some(found.place), &(fault, None), language));
        }
    }

    /// Adds a number as evidence of the sign.
    fn note(&mut self, place: usize, cells: &Cells<'_>, row: usize, at: u64) {
        if let Cells::Texts(texts) = cells
            && self.commas.may_be_decimal()
            && let Some(Some(text)) = texts.get(row)
        {
            self.thousands.note(place, number_of(text), at);
        }
    }

    /// Returns the fault of a number with the other mark.
    fn mixed(&mut self, column: &Column, cells: &Cells<'_>, row: usize) -> Option<Fault> {
        let Cells::Texts(texts) = cells else { return None };
        let text = texts.get(row)?.as_deref().filter(|_| self.commas.may_be_decimal())?;
        let text = Some(number_of(text)).filter(|text| text.contains(['.', ',']))?;
        let has_comma = text.contains(',');
        let decided = *self.has_comma.get_or_insert(has_comma);
        (has_comma != decided).then(|| {
            let written = text.trim().chars().take(60).collect();
            Fault::Tabular(TabularFault::DecimalMixed { path: column.key().to_owned(), written, has_comma })
        })
    }
}

/// Returns the number of a cell without a unit behind it.
fn number_of(text: &str) -> &str {
    recording::with_unit(text).map_or(text, |(number, _)| number)
}

impl Column {
    /// Returns `true` if its heading is a word for the key.
    pub(super) fn is_by_word(&self) -> bool {
        matches!(&self.holds, Holds::Key(_)) && !Heading::is_one(&self.written)
    }

    pub(super) fn key(&self) -> &str {
        match &self.holds {
            Holds::Code(_) => super::CODE,
            Holds::Key(heading) => &heading.path,
        }
    }

    /// Returns `true` if the cells are names of recordings.
    pub(super) fn names_recordings(&self) -> bool {
        matches!(&self.holds, Holds::Key(heading) if heading.path.ends_with(".file"))
    }

    /// Returns `true` if the cells are numbers.
    pub(super) fn is_number(&self) -> bool {
        match &self.holds {
            Holds::Code(_) => false,
            Holds::Key(heading) => heading.is_number() || matches!(heading.key.kind, Kind::Integer(..)),
        }
    }

    /// Returns the content of a cell, with the sign of the key.
    fn cell<'c>(&self, cells: &'c Cells<'_>, row: usize, commas: Commas) -> Result<Value<'c>, Fault> {
        match self.read(cells, row, commas)? {
            Value::Number(number) if self.is_opposite => Ok(Value::Number(-number)),
            value => Ok(value),
        }
    }

    fn read<'c>(&self, cells: &'c Cells<'_>, row: usize, commas: Commas) -> Result<Value<'c>, Fault> {
        let path = || self.key().to_owned();
        let empty = || Fault::Tabular(TabularFault::NoValue { path: path() });
        match cells {
            Cells::Numbers(numbers) => {
                let number = numbers.get(row).copied().flatten().ok_or_else(empty)?;
                if self.is_number() {
                    return Ok(Value::Number(number));
                }
                Err(Fault::Tabular(TabularFault::NoText { path: path(), written: number.to_string() }))
            }
            Cells::Texts(texts) => {
                let text = texts.get(row).and_then(Option::as_ref).ok_or_else(empty)?.trim();
                if text.is_empty() {
                    return Err(empty());
                }
                match &self.holds {
                    Holds::Key(heading) if self.is_number() => Self::number(heading, text, commas),
                    Holds::Key(heading) => Ok(Value::Text(heading.word(text))),
                    Holds::Code(_) => Ok(Value::Text(text)),
                }
            }
            Cells::Other(found, _) => {
                Err(Fault::Tabular(TabularFault::CellType { path: path(), found: found.clone() }))
            }
        }
    }

    /// Returns the number of a cell, which may repeat the unit of its column.
    fn number<'c>(heading: &Heading, text: &str, commas: Commas) -> Result<Value<'c>, Fault> {
        let may_have_comma = commas.may_be_decimal();
        if let Some(number) = recording::number(text, may_have_comma) {
            return Ok(Value::Number(number));
        }
        let (path, written) = (heading.path.clone(), text.chars().take(60).collect());
        if !may_have_comma && text.contains(',') && may_be_grouped(number_of(text)) {
            return Err(Fault::Tabular(TabularFault::ThousandsPossible { path, written }));
        }
        let Some((unit, (number, other))) = heading.unit.zip(recording::with_unit(text)) else {
            return Err(Fault::Tabular(TabularFault::NotANumber { path, written }));
        };
        if Unit::of_dimension(unit.dimension, other) != Some(unit) {
            return Err(Fault::Tabular(TabularFault::UnitOfCell { path, written, unit }));
        }
        let number = recording::number(number, may_have_comma).map(Value::Number);
        number.ok_or(Fault::Tabular(TabularFault::NotANumber { path, written }))
    }

    /// Returns the product that a cell of the column of codes names.
    pub(super) fn product(&self, text: &str, language: Language) -> Result<ProductId, CodeRefusal> {
        let is_name = |name: &str| match &self.holds {
            Holds::Code(Some(names)) => names.iter().any(|each| each == name),
            // The names of a refused project with products of its own are not known.
            Holds::Code(None) => true,
            Holds::Key(_) => false,
        };
        read_product(text, is_name, language)
    }

    /// Returns the fault of an unknown word or code.
    fn wrong_word(&self, text: &str, row: u64, language: Language) -> Option<CellFault> {
        match &self.holds {
            Holds::Key(heading) => {
                let objection = heading.objection(text)?;
                Some(CellFault::of(&self.written, Some(row), &objection, language))
            }
            Holds::Code(names) => {
                let refusal = self.product(text, language).err()?;
                let near = refusal.nearest.first().map(|(code, _)| words::terminal::near(code, language));
                let fault = refusal.faults.into_iter().next()?;
                let shown: String = text.chars().take(60).collect();
                let names: Vec<&str> = names.iter().flatten().map(String::as_str).collect();
                if let Hint::DidYouMean(name) = nearest_name(text, &names) {
                    return Some(CellFault {
                        heading: seen(&self.written).into_owned(),
                        row: Some(row),
                        id: fault.id(),
                        message: words::terminal::no_product(&seen(&shown), language),
                        hint: Some(words::terminal::near(&name, language)),
                    });
                }
                Some(CellFault {
                    heading: seen(&self.written).into_owned(),
                    row: Some(row),
                    id: fault.id(),
                    message: format!("{shown}: {}", fault.message),
                    hint: near.or(fault.hint),
                })
            }
        }
    }

    /// Returns the value of a cell.
    ///
    /// # Errors
    /// The reason why a project file with this value would be refused.
    pub(super) fn value<'c>(&self, cells: &'c Cells<'_>, row: usize, commas: Commas) -> Result<Value<'c>, Fault> {
        let value = self.cell(cells, row, commas)?;
        if let (Holds::Key(heading), Value::Number(number)) = (&self.holds, &value)
            && heading.is_number()
            && let Some(fault) = heading.refusal(*number)
        {
            return Err(fault);
        }
        Ok(value)
    }
}
