//! Where a number comes from and how far it can be trusted.
//!
//! Every figure that antrieb shows carries a [`Source`] and a [`Grade`]; a figure that does not exist is
//! [`Datum::NotPrinted`] or [`Datum::NotApplicable`], never a NaN or a quiet default.

use std::fmt;
use std::ops::Deref;
use std::sync::Arc;

/// How far a number can be trusted, best first.
///
/// The order is the order of trust: a result is graded by the worst grade among its inputs
/// (see [`Grade::worst`]).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Grade {
    /// A value that the maker's manual prints.
    Printed,
    /// Computed from printed values with an equation of the manual.
    Computed,
    /// A value of another document: a public one, which is named, or the user's own data sheet.
    Published,
    /// A model of ours, which is named and has a stated band.
    Estimated,
    /// A default that the user did not confirm.
    Assumed,
}

impl Grade {
    /// The identifier used in data exchange.
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

    /// The worse of two grades: a result is no better than its weakest input.
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

/// The manual's identifier in `data/sources.toml`.
pub const MANUAL: &str = "cha-manual";

/// The place of one printed cell: document, table, row (symbol and condition) and column (ratio, drive, feedback).
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
    /// Drive that the cell belongs to; empty if the table holds for all.
    pub drive: &'static str,
    /// Ratio of the column; empty if printed once for all ratios.
    pub ratio: &'static str,
}

impl CellRef {
    /// A cell of the manual that holds for every drive and ratio.
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

/// The meaning of a cell's text after errata, in the printed unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A dash: the manual has a place for the value but prints none.
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
    /// Anything that is not a number: a type, a connector, a colour.
    Text,
}

impl Value {
    /// The number to compute with: the number itself, the bound, the nominal value. A range has none.
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

/// The dotted path of a key, shared by all that cite it.
#[derive(Clone, Debug)]
pub enum Key {
    /// Known to the program.
    Fixed(&'static str),
    /// As a file has it.
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

/// Where a number comes from. Kept small: every check of every candidate carries two.
#[derive(Clone, Debug, Eq)]
pub enum Source {
    /// A printed cell of the manual.
    Cell(&'static CellRef),
    /// An equation of the manual.
    Equation {
        /// Its number as printed: `69.1`.
        number: &'static str,
    },
    /// A cell of a published document other than the manual; the place is that in our data: table and row.
    Published(&'static CellRef),
    /// A model of ours, documented under `docs/theory`.
    Model {
        /// Name of the model's page.
        name: &'static str,
    },
    /// A value that the user wrote in the project file.
    Project {
        /// Dotted path of the key, e.g. `actuator.torque_max`.
        key: Key,
    },
}

impl Source {
    /// The page of the manual that it stands on: its tables and equations are numbered by their pages.
    #[must_use]
    pub fn page(&self) -> Option<u16> {
        let number = match self {
            Self::Cell(cell) if cell.document == MANUAL => cell.table,
            Self::Equation { number } => number,
            Self::Cell(_) | Self::Published(_) | Self::Model { .. } | Self::Project { .. } => return None,
        };
        number.split_once('.')?.0.parse().ok()
    }

    /// The page of `docs/theory` that it is explained on.
    #[must_use]
    pub const fn model(&self) -> Option<&'static str> {
        match self {
            Self::Model { name } => Some(name),
            Self::Cell(_) | Self::Published(_) | Self::Equation { .. } | Self::Project { .. } => None,
        }
    }
}

impl PartialEq for Source {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            // Most cells that are equal are the same one.
            (Self::Cell(a), Self::Cell(b)) | (Self::Published(a), Self::Published(b)) => std::ptr::eq(*a, *b) || a == b,
            (Self::Equation { number: a }, Self::Equation { number: b })
            | (Self::Model { name: a }, Self::Model { name: b }) => a == b,
            (Self::Project { key: a }, Self::Project { key: b }) => a == b,
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
        }
    }
}

/// A value together with its source, grade and the errata that touch it.
#[derive(Clone, Debug, PartialEq)]
pub struct Sourced<T> {
    /// The value, in SI where it is a quantity.
    pub value: T,
    /// Where it comes from.
    pub source: Source,
    /// How far it can be trusted.
    pub grade: Grade,
    /// Identifiers of the errata that concern this value.
    pub errata: &'static [&'static str],
}

impl<T> Sourced<T> {
    /// The same provenance with another value, for conversions that add no information.
    pub fn map<U>(self, convert: impl FnOnce(T) -> U) -> Sourced<U> {
        Sourced { value: convert(self.value), source: self.source, grade: self.grade, errata: self.errata }
    }
}

/// A value that may not exist. Absence is a type of its own and says why.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Datum<T> {
    /// The value is known.
    Known(Sourced<T>),
    /// The source has a place for it, but prints a dash, or has no such row.
    #[default]
    NotPrinted,
    /// The question makes no sense for this product (a brake datum without a brake).
    NotApplicable,
}

impl<T> Datum<T> {
    /// What was found, or not printed.
    pub fn of(found: Option<Sourced<T>>) -> Self {
        found.map_or(Self::NotPrinted, Self::Known)
    }

    /// The known value converted together with its provenance; what is not known stays so.
    pub fn map<U>(self, convert: impl FnOnce(Sourced<T>) -> Sourced<U>) -> Datum<U> {
        match self {
            Self::Known(known) => Datum::Known(convert(known)),
            Self::NotPrinted => Datum::NotPrinted,
            Self::NotApplicable => Datum::NotApplicable,
        }
    }

    /// The known value, if there is one.
    pub const fn known(&self) -> Option<&Sourced<T>> {
        match self {
            Self::Known(sourced) => Some(sourced),
            Self::NotPrinted | Self::NotApplicable => None,
        }
    }

    /// The known value, or the name of what is missing, for checks that answer `not checked`.
    ///
    /// # Errors
    /// [`Missing`] with the given symbol when the value is not known.
    pub const fn require(&self, symbol: &'static str) -> Result<&Sourced<T>, Missing> {
        match self {
            Self::Known(sourced) => Ok(sourced),
            Self::NotPrinted | Self::NotApplicable => Err(Missing { symbol }),
        }
    }
}

/// A missing datum that a check needs.
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

    /// The number of a table begins with the page that its file names.
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

    /// It stands twice in every check, of which there are thousands.
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
