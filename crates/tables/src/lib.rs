//! A result as tables, and how they are written.
//!
//! A [`Table`] is plain data: columns with a name, a unit and a meaning, and rows of cells. Every table is defined
//! once ([`Subject::table`]), and four writers take it from there: [`xlsx`] a whole workbook, [`csv`], [`record`] and
//! [`parquet`] one table each. They give bytes; nothing here touches a file or the clock, and the same tables give
//! the same bytes.
//!
//! [`calendar`] writes the dates of a plan of upkeep for a calendar program.
//!
//! Names of tables and columns and their units are the contract with scripts and are the same in both languages;
//! titles, remarks and sources are words.

mod csv;
mod define;
mod error;
mod format;
mod ical;
mod json;
mod parquet;
mod results;
mod rows;
mod table;
mod trace;
mod xlsx;

pub use crate::csv::csv;
pub use crate::json::record;
pub use crate::parquet::parquet;
pub use define::{NAMES, Subject};
pub use error::WriteError;
pub use format::Format;
pub use ical::calendar;
pub use rows::Rows;
pub use table::{Cell, Column, ColumnContent, Derived, Table};
pub use trace::{trace, trace_csv};
pub use xlsx::{Front, SHEET_ROWS_MOST, xlsx};
