//! The cells of a table, and what is wrong with them.
#![allow(clippy::result_large_err, reason = "a fault is found once for a table, not for each of its rows")]

use super::{Column, Holds, Value};
use crate::codes::read_code;
use project::{CellKind, Fault, Hint, TabularFault};
use quantities::{Language, seen};
use std::borrow::Cow;
use words::{fault_text, hint_text};

/// The cells of a column.
#[derive(Clone, Debug)]
pub enum Cells<'c> {
    /// Numbers; `None` where a cell is empty.
    Numbers(Vec<Option<f64>>),
    /// Texts; `None` where a cell is empty.
    Texts(Vec<Option<Cow<'c, str>>>),
    /// Something else: its type, and how many cells.
    Other(String, usize),
}

/// A fault of a table at a column, and at a row where it is one of a cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CellFault {
    /// The heading as it is written.
    pub heading: String,
    /// The row, counted from zero.
    pub row: Option<u64>,
    /// Stable id of its kind.
    pub id: &'static str,
    /// What is wrong, one sentence.
    pub message: String,
    /// What was expected, or the nearest valid choice.
    pub hint: Option<String>,
}

/// Faults of a table: the first of them, and how many more.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TableFaults {
    /// In the order in which they were found.
    pub listed: Vec<CellFault>,
    /// How many more there are.
    pub more: usize,
}

/// So many faults are listed one by one.
const LISTED_MOST: usize = 50;

impl TableFaults {
    /// Adds one.
    pub fn add(&mut self, fault: CellFault) {
        if self.listed.len() < LISTED_MOST {
            self.listed.push(fault);
        } else {
            self.more += 1;
        }
    }

    /// Whether there is none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.listed.is_empty()
    }
}

impl CellFault {
    /// A fault in words.
    #[must_use]
    pub fn of(heading: &str, row: Option<u64>, (fault, hint): &(Fault, Option<Hint>), language: Language) -> Self {
        let own = || words::own_hint(fault, language);
        Self {
            heading: seen(heading).into_owned(),
            row,
            id: fault.id(),
            message: fault_text(fault, language),
            hint: hint.as_ref().map(|hint| hint_text(hint, language)).or_else(own),
        }
    }
}

impl Cells<'_> {
    /// How many they are.
    #[must_use]
    pub const fn len(&self) -> usize {
        match self {
            Self::Numbers(cells) => cells.len(),
            Self::Texts(cells) => cells.len(),
            Self::Other(_, count) => *count,
        }
    }

    /// Whether there is none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Adds what is wrong with them under a heading.
    pub(super) fn check(&self, column: &Column, first_row: u64, language: Language, faults: &mut TableFaults) {
        if let Self::Other(found, _) = self {
            let fault = Fault::Tabular(TabularFault::CellType { path: column.key().to_owned(), found: found.clone() });
            return faults.add(CellFault::of(&column.written, None, &(fault, None), language));
        }
        for row in 0..self.len() {
            let found = column.cell(self, row).err().or_else(|| column.wrong_word(self, row, language));
            if let Some(found) = found {
                let at = first_row + row as u64;
                faults.add(match found {
                    Wrong::Key(fault, hint) => CellFault::of(&column.written, Some(at), &(fault, hint), language),
                    Wrong::Code { id, message, hint } => {
                        let heading = seen(&column.written).into_owned();
                        CellFault { heading, row: Some(at), id, message, hint }
                    }
                });
            }
        }
    }
}

/// What is wrong with a cell.
pub(super) enum Wrong {
    Key(Fault, Option<Hint>),
    Code { id: &'static str, message: String, hint: Option<String> },
}

impl Column {
    pub(super) fn key(&self) -> &str {
        match &self.holds {
            Holds::Code => super::CODE,
            Holds::Key(heading) => &heading.path,
        }
    }

    fn is_number(&self) -> bool {
        match &self.holds {
            Holds::Code => false,
            Holds::Key(heading) => heading.is_number() || matches!(heading.cells, CellKind::Whole(..)),
        }
    }

    /// What stands in a cell.
    fn cell<'c>(&self, cells: &'c Cells<'_>, row: usize) -> Result<Value<'c>, Wrong> {
        let path = || self.key().to_owned();
        let empty = || Wrong::Key(Fault::Tabular(TabularFault::NoValue { path: path() }), None);
        match cells {
            Cells::Numbers(numbers) => {
                let number = numbers.get(row).copied().flatten().ok_or_else(empty)?;
                if self.is_number() {
                    return Ok(Value::Number(number));
                }
                Err(Wrong::Key(
                    Fault::Tabular(TabularFault::NoText { path: path(), written: number.to_string() }),
                    None,
                ))
            }
            Cells::Texts(texts) => {
                let text = texts.get(row).and_then(Option::as_ref).ok_or_else(empty)?.trim();
                if text.is_empty() {
                    return Err(empty());
                }
                if !self.is_number() {
                    return Ok(Value::Text(text));
                }
                let number = text.parse().map(Value::Number);
                number.map_err(|_| {
                    let written: String = text.chars().take(60).collect();
                    Wrong::Key(Fault::Tabular(TabularFault::NotANumber { path: path(), written }), None)
                })
            }
            Cells::Other(found, _) => {
                Err(Wrong::Key(Fault::Tabular(TabularFault::CellType { path: path(), found: found.clone() }), None))
            }
        }
    }

    /// A word or a code that there is not.
    fn wrong_word(&self, cells: &Cells<'_>, row: usize, language: Language) -> Option<Wrong> {
        let Ok(Value::Text(text)) = self.cell(cells, row) else { return None };
        match &self.holds {
            Holds::Key(heading) => heading.objection(text).map(|(fault, hint)| Wrong::Key(fault, hint)),
            Holds::Code => {
                let refusal = read_code(text, language).err()?;
                let near = refusal.nearest.first().map(|(code, _)| words::terminal::near(code, language));
                let fault = refusal.faults.into_iter().next()?;
                let shown: String = text.chars().take(60).collect();
                let message = format!("{shown}: {}", fault.message);
                Some(Wrong::Code { id: fault.id(), hint: near.or_else(|| fault.hint.clone()), message })
            }
        }
    }

    /// The value of a cell.
    ///
    /// # Errors
    /// Why a project file would be refused with it.
    pub(super) fn value<'c>(&self, cells: &'c Cells<'_>, row: usize) -> Result<Value<'c>, Fault> {
        let value = match self.cell(cells, row) {
            Ok(value) => value,
            Err(Wrong::Key(fault, _)) => return Err(fault),
            Err(Wrong::Code { .. }) => {
                return Err(Fault::Tabular(TabularFault::NoValue { path: self.key().to_owned() }));
            }
        };
        if let (Holds::Key(heading), Value::Number(number)) = (&self.holds, &value)
            && heading.is_number()
            && let Some(fault) = heading.refusal(*number)
        {
            return Err(fault);
        }
        Ok(value)
    }
}
