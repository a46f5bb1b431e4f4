//! Values of the curves of a figure, for reading at a cursor: those of the picture, independent of its size.

use crate::drawing::{Chart, Drawing};
use crate::thin::outstanding;
use plot::{Line, PlaneAxis};

/// Largest number of rows of curves with common places; more are reduced.
const ROWS_MOST: usize = 8000;

/// Number of places into which many rows are grouped; more than a picture has columns.
const GROUPS: f64 = 1500.0;

/// Symbol, unit and name of a curve.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CurveName {
    /// Symbol of the axis.
    pub symbol: String,
    /// Unit of the axis.
    pub unit: String,
    /// Label of the curve; empty if no other curve has its axis.
    pub label: String,
}

/// Curves that share their places.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveValues {
    /// Curves in the order in which the picture has them.
    pub names: Vec<CurveName>,
    /// Places on the horizontal axis.
    pub places: Vec<f64>,
    /// Values of each curve at these places.
    pub values: Vec<Vec<f64>>,
    /// `true` if only the first, the last and the extreme rows of each group are kept.
    pub is_reduced: bool,
}

/// A line with the axis of its values.
pub(crate) type CurveLine<'d> = (&'d PlaneAxis, &'d Line);

impl Drawing {
    /// Returns the curves of the figure in groups with the same places; curves without common places are groups of
    /// their own, and a long one among them has no values.
    #[must_use]
    pub fn values(&self) -> Vec<CurveValues> {
        let (_, blocks) = self.blocks();
        let several = |axis: &PlaneAxis| blocks.iter().flatten().filter(|(other, _)| *other == axis).count() > 1;
        blocks.iter().map(|block| values(block, several)).collect()
    }

    /// Returns symbol and unit of the horizontal axis; `None` without curves.
    #[must_use]
    pub fn place_name(&self) -> Option<CurveName> {
        let (symbol, unit) = self.blocks().0?.sign();
        Some(CurveName { symbol: symbol.to_owned(), unit: unit.to_owned(), label: String::new() })
    }

    /// Returns the horizontal axis, and the curves in groups with the same places.
    pub(crate) fn blocks(&self) -> (Option<&PlaneAxis>, Vec<Vec<CurveLine<'_>>>) {
        let (x, lines) = match &self.chart {
            Chart::Xy(chart) => chart.lines(),
            Chart::Stacked(chart) => chart.lines(),
            Chart::Bars(_) | Chart::Face(_) => return (None, Vec::new()),
        };
        let Some((_, first)) = lines.first() else { return (Some(x), Vec::new()) };
        let is_same = |one: &Line, other: &Line| {
            one.points().len() == other.points().len()
                && one.points().iter().zip(other.points()).all(|(one, other)| one.0.to_bits() == other.0.to_bits())
        };
        let shared = lines.iter().all(|(_, line)| is_same(line, first));
        (Some(x), if shared { vec![lines] } else { lines.into_iter().map(|line| vec![line]).collect() })
    }
}

fn values(block: &[CurveLine<'_>], several: impl Fn(&PlaneAxis) -> bool) -> CurveValues {
    let name = |(axis, line): &(&PlaneAxis, &Line)| {
        let (symbol, unit) = axis.sign();
        let label = if several(axis) { line.label_text() } else { String::new() };
        CurveName { symbol: symbol.to_owned(), unit: unit.to_owned(), label }
    };
    let names = block.iter().map(name).collect();
    let points: Vec<&[(f64, f64)]> = block.iter().map(|(_, line)| line.points()).collect();
    let first = points.first().copied().unwrap_or_default();
    let is_reduced = first.len() > ROWS_MOST;
    let rows: Vec<usize> = if is_reduced { reduced(&points) } else { (0..first.len()).collect() };
    let column = |points: &[(f64, f64)]| rows.iter().filter_map(|row| Some(points.get(*row)?.1)).collect();
    CurveValues {
        names,
        places: rows.iter().filter_map(|row| Some(first.get(*row)?.0)).collect(),
        values: points.iter().map(|points| column(points)).collect(),
        is_reduced,
    }
}

/// Returns the rows to keep of curves whose common places ascend; none if they do not.
fn reduced(points: &[&[(f64, f64)]]) -> Vec<usize> {
    let first = points.first().copied().unwrap_or_default();
    let (Some((from, _)), Some((until, _))) = (first.first(), first.last()) else { return Vec::new() };
    if until <= from || !first.is_sorted_by(|a, b| a.0 <= b.0) {
        return Vec::new();
    }
    let group = |(x, _): &(f64, f64)| ((x - from) / (until - from) * GROUPS).floor();
    let mut start = 0;
    let mut rows = Vec::new();
    for part in first.chunk_by(|a, b| group(a) == group(b)) {
        let of = |curve: usize, row: usize| Some(points.get(curve)?.get(start + row)?.1);
        rows.extend(outstanding(part.len(), points.len(), of).into_iter().map(|row| start + row));
        start += part.len();
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Figure;
    use plot::{Panel, StackedChart, XyChart};
    use quantities::Language;

    fn stacked(lines: Vec<Vec<(f64, f64)>>) -> Drawing {
        let chart = StackedChart::new(PlaneAxis::new("t", "s"));
        let panel = |line| Panel::new(PlaneAxis::new("T", "Nm")).with(Line::new(line));
        let chart = lines.into_iter().fold(chart, |chart, line| chart.panel(panel(line)));
        let texts = (String::new(), String::new());
        Drawing::new(Figure::Cycle, "", (100.0, 100.0), texts, Chart::Stacked(chart), Language::En)
    }

    #[test]
    fn a_short_figure_gives_every_value_and_both_sides_of_a_jump() {
        let found = stacked(vec![vec![(0.0, 1.0), (1.0, 2.0), (1.0, -3.0)], vec![(0.0, 4.0), (1.0, 5.0), (1.0, 6.0)]]);
        let found = found.values();
        assert_eq!(found.len(), 1);
        assert_eq!((found[0].places.as_slice(), found[0].is_reduced), ([0.0, 1.0, 1.0].as_slice(), false));
        assert_eq!(found[0].values, [[1.0, 2.0, -3.0], [4.0, 5.0, 6.0]]);
        assert_eq!((found[0].names[1].symbol.as_str(), found[0].names[1].unit.as_str()), ("T", "Nm"));
    }

    /// Compares every kept row with the samples, for several lengths up to 10⁶.
    #[test]
    fn a_long_figure_is_bounded_and_keeps_rows_as_they_are_with_their_extremes() {
        for count in [9_000_u32, 100_000, 1_000_000] {
            let time = |row: u32| f64::from(row) * 1e-3;
            let noise = |row: u32| f64::from(row.wrapping_mul(2_654_435_761) >> 16) / 65_536.0;
            let peak = |row: u32| if row == count / 3 + 7 { 9.0 } else { noise(row) };
            let drawing = stacked(vec![
                (0..count).map(|row| (time(row), peak(row))).collect(),
                (0..count).map(|row| (time(row), -noise(row + 1))).collect(),
            ]);
            let found = &drawing.values()[0];
            assert!(found.is_reduced && found.places.len() < 10_000, "{count}: {}", found.places.len());
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a row of the test")]
            for (row, place) in found.places.iter().enumerate() {
                let of = (place * 1e3).round() as u32;
                assert_eq!((found.values[0][row], found.values[1][row]), (peak(of), -noise(of + 1)));
            }
            assert!(found.values[0].contains(&9.0) && found.places.first() == Some(&0.0));
            assert_eq!(found.places.last(), Some(&time(count - 1)));
        }
    }

    #[test]
    fn curves_without_common_places_are_groups_of_their_own() {
        let round = (0..20_000_u32).map(|row| f64::from(row).sin_cos());
        let chart = XyChart::new(PlaneAxis::new("n", ""), PlaneAxis::new("T", "Nm"))
            .with(Line::new([(0.0, 3.0), (5.0, 3.0)]).label("limit"))
            .with(Line::new(round).label("cycle"));
        let texts = (String::new(), String::new());
        let found =
            Drawing::new(Figure::TorqueSpeed, "", (100.0, 80.0), texts, Chart::Xy(chart), Language::En).values();
        assert_eq!(found.len(), 2);
        assert_eq!((found[0].places.len(), found[1].places.len(), found[1].is_reduced), (2, 0, true));
        assert_eq!(found[0].names[0].label, "limit");
    }
}
