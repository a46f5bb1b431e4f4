//! Results as tables, and their file formats.
//!
//! A [`Table`] is plain data: columns with a name, a unit and a meaning, and rows of cells. Every table is defined once
//! ([`Subject::table`]) and has four writers: [`xlsx`] writes a whole workbook, [`csv`], [`record`] and [`parquet`] one
//! table each. They return bytes; this crate uses neither files nor the clock, and equal tables give equal bytes.
//!
//! [`calendar`] writes the dates of a maintenance plan for a calendar program.
//!
//! Names of tables and columns and their units are the contract with scripts and are equal in both languages; titles,
//! remarks and sources are translated.

mod cell;
mod csv;
mod define;
mod error;
mod format;
mod ical;
mod json;
mod parquet;
mod results;
mod rows;
mod setpoints;
mod subject;
mod table;
mod trace;
mod xlsx;

pub use crate::csv::csv;
pub use crate::json::record;
pub use crate::parquet::parquet;
pub use cell::Cell;
pub use define::NAMES;
pub use error::WriteError;
pub use format::{Format, SHEET_ROWS_MOST};
pub use ical::calendar;
pub use rows::Rows;
pub use setpoints::setpoints;
pub use subject::Subject;
pub use table::{Column, ColumnContent, Derived, Table};
pub use trace::{days, trace, trace_csv};
pub use xlsx::cover::Front;
pub use xlsx::{AxisSheets, xlsx, xlsx_of_axes};
