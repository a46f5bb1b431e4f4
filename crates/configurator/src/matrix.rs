//! Ordering matrix of a series and its pairs of winding and feedback, read from the cells.

use catalogue::{Cell, Mark, MarkEntry, SeriesData, table_cells};
use order_code::{Feedback, Field, Series, Size, Winding};
use std::sync::LazyLock;

/// Fields with rows in the matrix, in the order of its entries.
const FIELDS: [Field; 6] =
    [Field::Ratio, Field::Winding, Field::Feedback, Field::Brake, Field::Option1, Field::Option2];

/// Entry of every combination that the matrix does not list.
const NOT_AVAILABLE: Mark = Mark { begins: "", entry: MarkEntry::NotAvailable, feedback: None, longer: "" };

/// Matrix and pairs of a series, indexed for fast look-up.
pub(crate) struct Matrix {
    /// Tables and marks of the series.
    pub(crate) data: &'static SeriesData,
    /// Entries by size, then by field of [`FIELDS`], then by word.
    entries: Vec<Mark>,
    /// Index of the first word of each field within the entries of a size.
    begins: [usize; FIELDS.len()],
    width: usize,
    pairs: Vec<(Winding, Feedback)>,
}

fn mark_of(cell: &Cell, data: &SeriesData) -> Option<Mark> {
    data.marks.iter().find(|mark| cell.corrected.starts_with(mark.begins)).copied()
}

static MATRICES: LazyLock<Vec<Matrix>> = LazyLock::new(|| Series::all().map(Matrix::of).collect());

/// Returns the matrix of a series.
pub(crate) fn matrix(series: Series) -> Option<&'static Matrix> {
    MATRICES.get(series.place())
}

impl Matrix {
    fn of(series: Series) -> Self {
        let data = SeriesData::of(series);
        let mut begins = [0; FIELDS.len()];
        let mut conditions: Vec<String> = Vec::new();
        for (begin, field) in begins.iter_mut().zip(FIELDS) {
            *begin = conditions.len();
            conditions.extend(series.words(field).iter().map(|word| format!("{}={word}", field.id())));
        }
        let mut entries = Vec::new();
        for size in Size::all(series) {
            let head = format!("{}-{size}", series.as_str());
            for condition in &conditions {
                // A cell merged over several sizes lists all of them.
                let covers = |cell: &&Cell| {
                    cell.place.condition == condition && cell.place.drive.split(" / ").any(|each| each == head)
                };
                let found = table_cells(data.matrix).iter().find(covers).and_then(|cell| mark_of(cell, data));
                entries.push(found.unwrap_or(NOT_AVAILABLE));
            }
        }
        let mut pairs = Vec::new();
        for winding in Winding::all(series) {
            let condition = format!("winding={winding}");
            for feedback in Feedback::all(series) {
                let named = |cell: &Cell| cell.place.condition == condition && cell.feedback == feedback.as_str();
                if table_cells(data.pairs).iter().any(named) {
                    pairs.push((winding, feedback));
                }
            }
        }
        Self { data, entries, begins, width: conditions.len(), pairs }
    }

    /// Returns the entry of the matrix for a word of a field at a size.
    pub(crate) fn entry(&self, size: Size, field: Field, word: usize) -> Mark {
        let begin = FIELDS.iter().zip(self.begins).find(|(known, _)| **known == field).map_or(self.width, |(_, b)| b);
        self.entries.get(size.place() * self.width + begin + word).copied().unwrap_or(NOT_AVAILABLE)
    }

    /// Returns `true` if the ordering tables list this pair of winding and feedback.
    pub(crate) fn pair(&self, winding: Winding, feedback: Feedback) -> bool {
        self.pairs.contains(&(winding, feedback))
    }

    /// Returns `true` if any pair of the ordering tables has this winding.
    pub(crate) fn ordered(&self, winding: Winding) -> bool {
        self.pairs.iter().any(|(known, _)| *known == winding)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_matrix_is_read_from_the_tables() {
        let series = Series::default();
        let m = matrix(series).unwrap();
        let entry = |size: &str, field: Field, word: &str| {
            let place = series.words(field).iter().position(|known| *known == word).unwrap();
            let mark = m.entry(Size::of(series, size).unwrap(), field, place);
            (mark.entry, mark.feedback.map(Feedback::as_str), mark.longer)
        };
        assert_eq!(entry("14A", Field::Ratio, "120"), (MarkEntry::NotAvailable, None, ""));
        assert_eq!(entry("17A", Field::Ratio, "120"), (MarkEntry::Available, None, ""));
        assert_eq!(entry("40A", Field::Ratio, "30"), (MarkEntry::NotAvailable, None, ""));
        assert_eq!(entry("32A", Field::Feedback, "RES"), (MarkEntry::OnRequest, None, ""));
        assert_eq!(entry("14A", Field::Option2, "K"), (MarkEntry::OnRequest, Some("RES"), "1"));
        assert_eq!(entry("14A", Field::Option2, "R"), (MarkEntry::NotAvailable, None, ""));
        assert_eq!(entry("58A", Field::Option2, "S"), (MarkEntry::Available, Some("M512P"), ""));
        assert_eq!(entry("20A", Field::Winding, "N"), (MarkEntry::NotAvailable, None, ""));
        assert_eq!(m.pairs.len(), 10, "table 11.3 has ten rows");
        assert!(!m.ordered(Winding::of(series, "L").unwrap()));
    }

    #[test]
    fn every_entry_of_the_matrix_is_understood() {
        let series = Series::default();
        let data = SeriesData::of(series);
        let conditions: Vec<String> = FIELDS
            .iter()
            .flat_map(|field| series.words(*field).iter().map(move |word| format!("{}={word}", field.id())))
            .collect();
        for cell in table_cells(data.matrix) {
            assert!(mark_of(cell, data).is_some(), "{cell:?}");
            assert!(conditions.iter().any(|known| known == cell.place.condition), "{cell:?}");
        }
        for (size, condition) in Size::all(series).flat_map(|size| conditions.iter().map(move |each| (size, each))) {
            let head = format!("CHA-{size}");
            let stands = |cell: &Cell| cell.place.condition == condition && cell.place.drive.contains(&head);
            assert!(table_cells(data.matrix).iter().any(stands), "{size} {condition}");
        }
    }
}
