//! Origin and reliability of a number.
//!
//! Every figure that antrieb shows carries a [`Source`] and a [`Grade`]; a figure that does not exist is
//! [`Datum::NotPrinted`] or [`Datum::NotApplicable`], never a NaN or a silent default.

use std::fmt;
use std::ops::Deref;
use std::sync::Arc;

/// Reliability of a number, best first.
///
/// A result has the worst grade among its inputs (see [`Grade::worst`]).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Grade {
    /// A value stated in the manufacturer's manual.
    Printed,
    /// Computed from values of the manual with an equation of the manual.
    Computed,
    /// A value of another document: a named public one, or the user's own data sheet.
    Published,
    /// A result of a named model of this project with a stated error band.
    Estimated,
    /// A default not confirmed by the user.
    Assumed,
}

impl Grade {
    /// Returns the identifier used in data exchange.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Printed => "printed",
            Self::Computed => "computed",
            Self::Published => "published",
            Self::Estimated => "estimated",
            Self::Assumed => "assumed",
        }
    }

    /// Returns the worse of two grades: a result is no better than its weakest input.
    #[must_use]
    pub fn worst(self, other: Self) -> Self {
        self.max(other)
    }
}

impl fmt::Display for Grade {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id())
    }
}

/// Identifier of the manual in `data/sources.toml`.
pub const MANUAL: &str = "cha-manual";

/// Place of one cell: document, table, row (symbol and condition) and column (ratio, drive, feedback).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CellRef {
    /// Identifier of the document in `data/sources.toml`.
    pub document: &'static str,
    /// Number of the table after errata, e.g. `26.1`.
    pub table: &'static str,
    /// Symbol of the row, e.g. `T_max`.
    pub symbol: &'static str,
    /// Condition of the row, e.g. `30 degC`; empty if there is none.
    pub condition: &'static str,
    /// Drive that the cell belongs to; empty if the table holds for all drives.
    pub drive: &'static str,
    /// Ratio of the column; empty if the value is stated once for all ratios.
    pub ratio: &'static str,
}

impl CellRef {
    /// Creates the place of a cell of the manual that holds for every drive and ratio.
    #[must_use]
    pub const fn of_the_manual(table: &'static str, symbol: &'static str, condition: &'static str) -> Self {
        Self { document: MANUAL, table, symbol, condition, drive: "", ratio: "" }
    }
}

impl fmt::Display for CellRef {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "table {}, {}", self.table, self.symbol)?;
        if !self.condition.is_empty() {
            write!(f, " ({})", self.condition)?;
        }
        if !self.ratio.is_empty() {
            write!(f, ", i = {}", self.ratio)?;
        }
        Ok(())
    }
}

/// Meaning of a cell's text after errata, in the unit of the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A dash: the manual has a place for the value but states none.
    NotPrinted,
    /// A single number.
    Number(f64),
    /// `a ... b`
    Range {
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
    },
    /// `< a`, `≤ a`, `< ±a`
    UpperBound(f64),
    /// `> a`, `≥ a`
    LowerBound(f64),
    /// `±a`
    PlusMinus(f64),
    /// `a ±b %`
    Tolerance {
        /// Nominal value.
        nominal: f64,
        /// Tolerance in per cent of the nominal value.
        plus_minus_percent: f64,
    },
    /// Text that is not a number: a type, a connector, a colour.
    Text,
}

impl Value {
    /// Returns the number to compute with: the number itself, the bound, the nominal value; `None` for a range or text.
    #[must_use]
    pub const fn number(self) -> Option<f64> {
        match self {
            Self::Number(value)
            | Self::UpperBound(value)
            | Self::LowerBound(value)
            | Self::PlusMinus(value)
            | Self::Tolerance { nominal: value, .. } => Some(value),
            Self::NotPrinted | Self::Range { .. } | Self::Text => None,
        }
    }
}

/// Dotted path of a key, shared by all sources that refer to it.
#[derive(Clone, Debug)]
pub enum Key {
    /// A path defined in the program.
    Fixed(&'static str),
    /// A path taken from a file.
    Stated(Arc<str>),
}

impl Deref for Key {
    type Target = str;

    fn deref(&self) -> &str {
        match self {
            Self::Fixed(key) => key,
            Self::Stated(key) => key,
        }
    }
}

impl From<&'static str> for Key {
    fn from(key: &'static str) -> Self {
        Self::Fixed(key)
    }
}

impl From<String> for Key {
    fn from(key: String) -> Self {
        Self::Stated(key.into())
    }
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        self[..] == other[..]
    }
}

impl Eq for Key {}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self)
    }
}

/// Origin of a number. Kept small: every check of every candidate contains two.
#[derive(Clone, Debug, Eq)]
pub enum Source {
    /// A cell of the manual.
    Cell(&'static CellRef),
    /// An equation of the manual.
    Equation {
        /// Number of the equation, as in the manual: `69.1`.
        number: &'static str,
    },
    /// A cell of a published document other than the manual, by its table and row in the data of this project.
    Published(&'static CellRef),
    /// A model of this project, documented under `docs/theory`.
    Model {
        /// Name of the model's page.
        name: &'static str,
    },
    /// A value that the user wrote in the project file.
    Project {
        /// Dotted path of the key, e.g. `actuator.torque_max`.
        key: Key,
    },
    /// A value of a catalogue file of the user.
    CatalogueFile {
        /// File, line of the product, key, and the document that the file names: `stock.toml:12: torque_max (data sheet B)`.
        place: Arc<str>,
    },
    /// A value that the project file leaves open: the default of a key.
    NotStated {
        /// Dotted path of the key, e.g. `mechanism.belt.inclination`.
        key: Arc<str>,
    },
}

impl Source {
    /// Returns the page of the manual: tables and equations are numbered by their pages.
    #[must_use]
    pub fn page(&self) -> Option<u16> {
        let number = match self {
            Self::Cell(cell) if cell.document == MANUAL => cell.table,
            Self::Equation { number } => number,
            Self::Cell(_)
            | Self::Published(_)
            | Self::Model { .. }
            | Self::Project { .. }
            | Self::CatalogueFile { .. }
            | Self::NotStated { .. } => return None,
        };
        number.split_once('.')?.0.parse().ok()
    }

    /// Returns `true` if a file of the user states the value: the project, or a catalogue file.
    #[must_use]
    pub const fn is_of_the_user(&self) -> bool {
        matches!(self, Self::Project { .. } | Self::CatalogueFile { .. })
    }

    /// Returns the page of `docs/theory` that explains the source.
    #[must_use]
    pub const fn model(&self) -> Option<&'static str> {
        match self {
            Self::Model { name } => Some(name),
            Self::Cell(_)
            | Self::Published(_)
            | Self::Equation { .. }
            | Self::Project { .. }
            | Self::CatalogueFile { .. }
            | Self::NotStated { .. } => None,
        }
    }
}

impl PartialEq for Source {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            // Most equal cells are identical.
            (Self::Cell(a), Self::Cell(b)) | (Self::Published(a), Self::Published(b)) => std::ptr::eq(*a, *b) || a == b,
            (Self::Equation { number: a }, Self::Equation { number: b })
            | (Self::Model { name: a }, Self::Model { name: b }) => a == b,
            (Self::Project { key: a }, Self::Project { key: b }) => a == b,
            (Self::CatalogueFile { place: a }, Self::CatalogueFile { place: b }) => a == b,
            (Self::NotStated { key: a }, Self::NotStated { key: b }) => a == b,
            _ => false,
        }
    }
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cell(cell) => write!(f, "{cell}"),
            Self::Equation { number } => write!(f, "{MANUAL} eq. {number}"),
            Self::Published(cell) => write!(f, "{} ({cell})", cell.document),
            Self::Model { name } => write!(f, "model {name}"),
            Self::Project { key } => write!(f, "project {key}"),
            Self::CatalogueFile { place } => f.write_str(place),
            Self::NotStated { key } => write!(f, "{key} not stated"),
        }
    }
}

/// A value with its source, its grade and the errata that concern it.
#[derive(Clone, Debug, PartialEq)]
pub struct Sourced<T> {
    /// Value, in SI if it is a quantity.
    pub value: T,
    /// Source of the value.
    pub source: Source,
    /// Reliability of the value.
    pub grade: Grade,
    /// Identifiers of the errata that concern this value.
    pub errata: &'static [&'static str],
}

impl<T> Sourced<T> {
    /// Converts the value and keeps the provenance, for conversions that add no information.
    pub fn map<U>(self, convert: impl FnOnce(T) -> U) -> Sourced<U> {
        Sourced { value: convert(self.value), source: self.source, grade: self.grade, errata: self.errata }
    }
}

/// A value that may not exist; the variant states the reason.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Datum<T> {
    /// The value is known.
    Known(Sourced<T>),
    /// The source has a place for it, but states a dash, or has no such row.
    #[default]
    NotPrinted,
    /// The value has no meaning for this product (a brake datum without a brake).
    NotApplicable,
}

impl<T> Datum<T> {
    /// Creates a datum from an optional value; `None` becomes [`Datum::NotPrinted`].
    pub fn of(found: Option<Sourced<T>>) -> Self {
        found.map_or(Self::NotPrinted, Self::Known)
    }

    /// Converts a known value together with its provenance; an unknown value stays unknown.
    pub fn map<U>(self, convert: impl FnOnce(Sourced<T>) -> Sourced<U>) -> Datum<U> {
        match self {
            Self::Known(known) => Datum::Known(convert(known)),
            Self::NotPrinted => Datum::NotPrinted,
            Self::NotApplicable => Datum::NotApplicable,
        }
    }

    /// Returns the known value, if there is one.
    pub const fn known(&self) -> Option<&Sourced<T>> {
        match self {
            Self::Known(sourced) => Some(sourced),
            Self::NotPrinted | Self::NotApplicable => None,
        }
    }

    /// Returns the known value, or the symbol of the missing one, for checks with the result `not checked`.
    ///
    /// # Errors
    /// [`Missing`] with the given symbol if the value is not known.
    pub const fn require(&self, symbol: &'static str) -> Result<&Sourced<T>, Missing> {
        match self {
            Self::Known(sourced) => Ok(sourced),
            Self::NotPrinted | Self::NotApplicable => Err(Missing { symbol }),
        }
    }
}

/// A missing datum required by a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Missing {
    /// Symbol of the datum, as in the glossary.
    pub symbol: &'static str,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_result_is_as_good_as_its_worst_input() {
        assert_eq!(Grade::Printed.worst(Grade::Estimated), Grade::Estimated);
        assert_eq!(Grade::Assumed.worst(Grade::Published), Grade::Assumed);
    }

    #[test]
    fn a_source_reads_like_a_citation() {
        const CELL: CellRef = CellRef { ratio: "50", ..CellRef::of_the_manual("26.1", "K_INL", "30 degC") };
        assert_eq!(Source::Cell(&CELL).to_string(), "table 26.1, K_INL (30 degC), i = 50");
        assert_eq!(Source::Equation { number: "69.1" }.to_string(), "cha-manual eq. 69.1");
    }

    /// The number of a table begins with the page stated in its file.
    #[test]
    fn a_table_stands_on_the_page_of_its_number() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/cha/tables");
        let mut count = 0;
        for entry in std::fs::read_dir(folder).unwrap() {
            let text = std::fs::read_to_string(entry.unwrap().path()).unwrap();
            let of = |key: &str| {
                let line = text.lines().find(|line| line.split('=').next().is_some_and(|name| name.trim() == key));
                line.and_then(|line| line.split_once('=')).map(|(_, value)| value.trim().trim_matches('"').to_owned())
            };
            let (Some(table), Some(page)) = (of("table"), of("page")) else { panic!("{text}") };
            let table: &'static str = table.leak();
            let cell: &'static CellRef = Box::leak(Box::new(CellRef::of_the_manual(table, "x", "")));
            if let Some(found) = Source::Cell(cell).page() {
                assert_eq!(found.to_string(), page, "{table}");
                count += 1;
            }
        }
        assert!(count > 40, "{count}");
        assert_eq!(Source::Equation { number: "69.1" }.page(), Some(69));
        assert_eq!(Source::Model { name: "gear" }.page(), None);
    }

    /// Every check contains two sources, and there are thousands of checks.
    #[test]
    fn a_source_is_small() {
        assert_eq!(size_of::<Option<Source>>(), 24);
    }

    #[test]
    fn absence_names_what_is_missing() {
        let datum: Datum<f64> = Datum::NotPrinted;
        assert_eq!(datum.require("I_E").unwrap_err().symbol, "I_E");
    }
}
