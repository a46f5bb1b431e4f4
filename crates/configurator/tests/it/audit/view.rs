//! Cells of the manual as the checks read them: text in one of three readings, and intervals of rounding.

#![allow(clippy::unwrap_used, reason = "a test that cannot panic cannot fail")]

use catalogue::{Cell, Erratum, ErratumKind};
use std::ops::{Add, Div, Mul, Sub};

/// Version of the cell texts used in a run of the checks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TextVersion {
    /// Text of the manual: every deviation needs an erratum.
    Printed,
    /// Text after errata: a corrected value must fit its neighbours, only a flagged one may still deviate.
    Corrected,
    /// Values used by the checks of an actuator: a value set to the safe side must fit too.
    Limits,
}

impl TextVersion {
    pub(super) const ALL: [Self; 3] = [Self::Printed, Self::Corrected, Self::Limits];

    /// Returns the name used in reports.
    #[must_use]
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Printed => "printed",
            Self::Corrected => "corrected",
            Self::Limits => "as checks use it",
        }
    }

    /// Returns `true` if an erratum may explain a deviation in this reading. A recovery of the text is no error of the
    /// manual, and another edition proves nothing about this one; a replaced value must fit itself.
    pub(super) fn explains(self, erratum: &Erratum) -> bool {
        let of_the_print =
            matches!(erratum.kind, ErratumKind::PrintError | ErratumKind::Contradiction | ErratumKind::Rounding);
        let replaced = match self {
            Self::Printed => false,
            Self::Corrected => erratum.corrected_here,
            Self::Limits => erratum.corrected_here || erratum.checks_use.is_some(),
        };
        of_the_print && !replaced
    }

    fn text(self, cell: &Cell) -> String {
        let safe = cell.errata.iter().filter_map(|id| catalogue::erratum(id)?.checks_use).next();
        match self {
            Self::Printed => cell.printed,
            Self::Corrected => cell.corrected,
            Self::Limits => safe.unwrap_or(cell.corrected),
        }
        .to_owned()
    }
}

/// One cell with its text in this reading.
#[derive(Clone, Debug)]
pub(super) struct AuditedCell {
    /// The cell.
    pub(crate) cell: &'static Cell,
    /// Text in this reading.
    pub(crate) text: String,
}

impl AuditedCell {
    /// Returns the value with half its last stated digit to both sides; `None` for dashes, ranges and texts.
    pub(super) fn span(&self) -> Option<Span> {
        Span::of(&self.text)
    }

    /// Returns the value without its interval.
    pub(super) fn number(&self) -> Option<f64> {
        self.span().map(|span| span.mid)
    }

    /// Returns the place of the cell for messages.
    pub(super) fn place(&self) -> String {
        let mut place = format!("table {}, {}", self.cell.place.table, self.cell.place.symbol);
        for part in [self.cell.place.condition, self.cell.place.drive, self.cell.feedback] {
            if !part.is_empty() {
                place.push_str(&format!(", {part}"));
            }
        }
        if !self.cell.place.ratio.is_empty() {
            place.push_str(&format!(", i = {}", self.cell.place.ratio));
        }
        place
    }
}

/// The cells in one reading.
pub(super) struct CellView {
    /// The reading.
    pub(crate) reading: TextVersion,
    entries: Vec<AuditedCell>,
}

impl CellView {
    /// Reads the embedded tables.
    pub(super) fn of(reading: TextVersion) -> Self {
        let entries = catalogue::cells().map(|cell| AuditedCell { cell, text: reading.text(cell) }).collect();
        Self { reading, entries }
    }

    /// Iterates over the cells of a table.
    pub(super) fn table<'a, 'b>(&'a self, id: &'b str) -> impl Iterator<Item = &'a AuditedCell> + use<'a, 'b> {
        self.entries.iter().filter(move |entry| entry.cell.place.table == id)
    }

    /// Iterates over the cells of a symbol in a table, in the order of its columns.
    pub(super) fn row<'a, 'b>(
        &'a self,
        table: &'b str,
        symbol: &'b str,
    ) -> impl Iterator<Item = &'a AuditedCell> + use<'a, 'b> {
        self.table(table).filter(move |entry| entry.cell.place.symbol == symbol)
    }

    /// Returns the cell of a symbol in a table with one column per size.
    pub(super) fn of_size(&self, table: &str, symbol: &str, size: &str) -> Option<&AuditedCell> {
        self.row(table, symbol).find(|entry| entry.cell.place.drive == size)
    }

    /// Returns the first cell that satisfies a predicate.
    pub(super) fn find(&self, accept: impl Fn(&Cell) -> bool) -> Option<&AuditedCell> {
        self.entries.iter().find(|entry| accept(entry.cell))
    }

    /// Returns the cells of one drive: technical data, inertias, brake and lengths.
    pub(super) fn drive(&self, name: &'static str) -> DriveView<'_> {
        DriveView { name, entries: self.entries.iter().filter(|entry| entry.cell.place.drive == name).collect() }
    }

    /// Returns the sixteen drives.
    pub(super) fn drives(&self) -> Vec<DriveView<'_>> {
        catalogue::drives().iter().map(|drive| self.drive(drive.name)).collect()
    }
}

impl CellView {
    /// Returns the printed reading with the text of one cell changed; the cell must exist once and have no erratum.
    pub(super) fn with(table: &str, text: &str, accept: impl Fn(&Cell) -> bool) -> Self {
        let mut view = Self::of(TextVersion::Printed);
        let mut hits = view.entries.iter_mut().filter(|entry| entry.cell.place.table == table && accept(entry.cell));
        let entry = hits.next().unwrap();
        assert!(entry.cell.errata.is_empty(), "{} has an erratum already", entry.place());
        assert!(hits.next().is_none(), "more than one cell to change");
        text.clone_into(&mut entry.text);
        view
    }
}

/// The cells of one drive.
pub(super) struct DriveView<'a> {
    /// Heading of the drive's section.
    pub(crate) name: &'static str,
    /// Cells of the drive.
    pub(crate) entries: Vec<&'a AuditedCell>,
}

impl<'a> DriveView<'a> {
    /// Returns the ratios in ascending order, as in the column headings.
    pub(super) fn ratios(&self) -> Vec<&'static str> {
        self.entries
            .iter()
            .filter(|entry| entry.cell.place.symbol == "T_max")
            .map(|entry| entry.cell.place.ratio)
            .collect()
    }

    /// Returns the cell of a symbol at a ratio; a value stated once holds for every ratio. Of values for several
    /// temperatures the one at 20 °C is returned.
    pub(super) fn at(&self, symbol: &str, ratio: &str) -> Option<&'a AuditedCell> {
        self.every(symbol, ratio).find(|entry| ["", "20 degC"].contains(&entry.cell.place.condition))
    }

    /// Iterates over the cells of a symbol at a ratio, under any condition and with any encoder.
    pub(super) fn every(&self, symbol: &str, ratio: &str) -> impl Iterator<Item = &'a AuditedCell> {
        self.entries.iter().copied().filter(move |entry| {
            entry.cell.place.symbol == symbol && (entry.cell.place.ratio.is_empty() || entry.cell.place.ratio == ratio)
        })
    }

    /// Returns the cell of a symbol stated once for all ratios.
    pub(super) fn once(&self, symbol: &str) -> Option<&'a AuditedCell> {
        self.at(symbol, "")
    }

    /// Returns the cell of another symbol with the encoder, condition and ratio of `other`.
    pub(super) fn beside(&self, symbol: &str, other: &AuditedCell) -> Option<&'a AuditedCell> {
        self.entries.iter().copied().find(|entry| {
            entry.cell.place.symbol == symbol
                && entry.cell.feedback == other.cell.feedback
                && entry.cell.place.condition == other.cell.place.condition
                && (entry.cell.place.ratio.is_empty() || entry.cell.place.ratio == other.cell.place.ratio)
        })
    }

    /// Returns the size as headed in other tables: `CHA-20A`.
    pub(super) fn size(&self) -> &'static str {
        self.name.get(..7).unwrap_or(self.name)
    }

    /// Returns `true` for a drive with the 48 V winding E.
    pub(super) fn is_48_v(&self) -> bool {
        self.name.ends_with("-E")
    }

    /// Returns `true` for the sizes 14A and 17A.
    pub(super) fn is_small(&self) -> bool {
        ["CHA-14A", "CHA-17A"].contains(&self.size())
    }
}

/// A positive value with the interval that its rounding allows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Span {
    /// Lower end.
    pub(crate) low: f64,
    /// Value as stated, or computed from stated values.
    pub(crate) mid: f64,
    /// Upper end.
    pub(crate) high: f64,
}

impl Span {
    /// Returns the interval of a stated text: half the last digit to both sides. Signs of bounds are ignored.
    pub(super) fn of(text: &str) -> Option<Self> {
        let text = text.trim_start_matches(['<', '>', '≤', '≥', '±', ' ']);
        let digits = text.split_once(',').map_or(0, |(_, behind)| behind.len());
        Some(Self::around(text.replace(',', ".").parse().ok()?, digits))
    }

    /// Returns the interval with a trailing zero after the comma taken as padding: the value is known to one digit
    /// less.
    pub(super) fn padded(text: &str) -> Option<Self> {
        match text.strip_suffix('0') {
            Some(shorter) if text.contains(',') => Self::of(shorter.trim_end_matches(',')),
            _ => Self::of(text),
        }
    }

    fn around(mid: f64, digits: usize) -> Self {
        let half = 0.5 * 0.1_f64.powi(i32::try_from(digits).unwrap_or(0));
        Self { low: mid - half, mid, high: mid + half }
    }

    /// Returns a value without rounding.
    pub(super) const fn exact(value: f64) -> Self {
        Self { low: value, mid: value, high: value }
    }

    /// Returns `true` if the intervals share a value, within floating-point rounding.
    pub(super) fn meets(self, other: Self) -> bool {
        let noise = 1e-9 * self.mid.abs().max(other.mid.abs());
        self.low <= other.high + noise && other.low <= self.high + noise
    }
}

impl std::fmt::Display for Span {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} … {}", brief(self.low), brief(self.high))
    }
}

/// Formats a value with four significant digits.
pub(super) fn brief(value: f64) -> String {
    let whole = value.abs().max(1e-12).log10().floor();
    let digits = if whole >= 3.0 { 0 } else { 3_usize.saturating_add_signed(-(whole as isize)) };
    format!("{value:.digits$}")
}

/// Returns the median of values; the mean of the middle two if their number is even; zero if there are none.
pub(super) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let upper = values.get(values.len() / 2).copied().unwrap_or_default();
    let lower = values.get(values.len().saturating_sub(1) / 2).copied().unwrap_or_default();
    f64::midpoint(lower, upper)
}

impl Mul<f64> for Span {
    type Output = Self;
    fn mul(self, by: f64) -> Self {
        Self { low: self.low * by, mid: self.mid * by, high: self.high * by }
    }
}

impl Mul for Span {
    type Output = Self;
    fn mul(self, by: Self) -> Self {
        Self { low: self.low * by.low, mid: self.mid * by.mid, high: self.high * by.high }
    }
}

impl Div for Span {
    type Output = Self;
    fn div(self, by: Self) -> Self {
        Self { low: self.low / by.high, mid: self.mid / by.mid, high: self.high / by.low }
    }
}

impl Add for Span {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { low: self.low + other.low, mid: self.mid + other.mid, high: self.high + other.high }
    }
}

impl Sub for Span {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { low: self.low - other.high, mid: self.mid - other.mid, high: self.high - other.low }
    }
}

mod tests {
    use super::*;

    #[test]
    fn the_last_printed_digit_sets_the_span() {
        let span = Span::of("1,12").unwrap();
        assert!((span.low - 1.115).abs() < 1e-12 && (span.high - 1.125).abs() < 1e-12, "{span:?}");
        assert!((Span::of("< ±0,1").unwrap().high - 0.15).abs() < 1e-12);
        assert_eq!(Span::of("0 ... 40"), None);
        assert_eq!(Span::of("-"), None);
    }

    #[test]
    fn a_zero_behind_the_comma_may_be_padding() {
        assert_eq!(Span::padded("3,50"), Span::of("3,5"));
        assert_eq!(Span::padded("3,0"), Span::of("3"));
        assert_eq!(Span::padded("3,55"), Span::of("3,55"));
        assert_eq!(Span::padded("30"), Span::of("30"));
    }

    #[test]
    fn a_replaced_value_is_not_explained_by_its_erratum() {
        let corrected = catalogue::erratum("25A-M512P-J_out-50").unwrap();
        let safe = catalogue::erratum("25A-C1024-T_Br-30").unwrap();
        let edition = catalogue::erratum("50A-M512P-J_out_brake-50").unwrap();
        assert_eq!(TextVersion::ALL.map(|reading| reading.explains(corrected)), [true, false, false]);
        assert_eq!(TextVersion::ALL.map(|reading| reading.explains(safe)), [true, true, false]);
        assert_eq!(TextVersion::ALL.map(|reading| reading.explains(edition)), [false; 3]);
    }

    #[test]
    fn the_median_of_an_even_number_is_the_mean_of_the_middle_two() {
        assert!((median(vec![4.0, 1.0, 2.0, 3.0]) - 2.5).abs() < 1e-12);
        assert!((median(vec![3.0, 1.0, 2.0]) - 2.0).abs() < 1e-12);
    }
}
