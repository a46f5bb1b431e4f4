//! Reduction of long series without loss of a peak.

use std::collections::BTreeSet;

use crate::geometry::{Point, Rect};
use crate::number::number;

/// Width of a column \[px\]: half a pixel of a standard screen.
const COLUMN: f64 = 0.5;

/// Reduces each run of points within one column to the first, the lowest, the highest and the last, in their order.
///
/// The drawn line covers the same rows of every column as the full one, so that no extreme is lost.
pub(crate) fn reduced(points: &[Point]) -> Vec<Point> {
    let mut kept = Vec::new();
    let mut run: Option<Run> = None;
    for &point in points {
        let column = (point.0 / COLUMN).floor();
        match &mut run {
            Some(run) if run.column == column => run.add(point),
            _ => {
                if let Some(run) = run.take() {
                    run.write(&mut kept);
                }
                run = Some(Run::new(column, point));
            }
        }
    }
    if let Some(run) = run {
        run.write(&mut kept);
    }
    kept
}

struct Run {
    column: f64,
    count: usize,
    first: Point,
    low: (usize, Point),
    high: (usize, Point),
    last: Point,
}

impl Run {
    const fn new(column: f64, point: Point) -> Self {
        Self { column, count: 0, first: point, low: (0, point), high: (0, point), last: point }
    }

    fn add(&mut self, point: Point) {
        self.count += 1;
        if point.1 < self.low.1.1 {
            self.low = (self.count, point);
        }
        if point.1 > self.high.1.1 {
            self.high = (self.count, point);
        }
        self.last = point;
    }

    fn write(&self, kept: &mut Vec<Point>) {
        let (early, late) = if self.low.0 <= self.high.0 { (self.low, self.high) } else { (self.high, self.low) };
        kept.push(self.first);
        for (at, point) in [early, late] {
            if at != 0 && at != self.count && kept.last() != Some(&point) {
                kept.push(point);
            }
        }
        if self.count > 0 {
            kept.push(self.last);
        }
    }
}

/// Number of points above which repeated parts of a line are drawn once.
const REPEATS_MIN: usize = 20_000;

/// Returns the pieces of a line without those that lie, to half a pixel, on an earlier part of it.
///
/// A repeated cycle looks like a single one; a line of fewer points is left unchanged.
pub(crate) fn without_repeats(points: Vec<Point>) -> Vec<Vec<Point>> {
    if points.len() < REPEATS_MIN {
        return vec![points];
    }
    #[expect(clippy::cast_possible_truncation, reason = "a place near the picture; far away it saturates")]
    let snapped = |point: Point| ((point.0 / COLUMN).round() as i32, (point.1 / COLUMN).round() as i32);
    let mut seen = BTreeSet::new();
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    let mut down = false;
    for (&a, &b) in points.iter().zip(points.iter().skip(1)) {
        let (from, to) = (snapped(a), snapped(b));
        if seen.insert((from.min(to), from.max(to))) {
            match pieces.last_mut() {
                Some(piece) if down => piece.push(b),
                _ => pieces.push(vec![a, b]),
            }
            down = true;
        } else {
            down = false;
        }
    }
    pieces
}

/// Largest distance of the line from an omitted point, in px: coordinates are written in hundredths.
const BESIDE: f64 = 0.02;

/// Returns a line without the points on its straight parts, within [`BESIDE`].
///
/// A segment from a kept point continues while one direction passes all following points within the tolerance, and none
/// turns back.
fn straightened(points: &[Point]) -> Vec<Point> {
    let Some((&first, rest)) = points.split_first() else { return Vec::new() };
    let mut kept = vec![first];
    let mut sight = Sight::from(first);
    for &point in rest {
        if !sight.passes(point) {
            kept.push(sight.last);
            sight = Sight::from(sight.last);
            sight.passes(point);
        }
    }
    if rest.is_empty() {
        return kept;
    }
    kept.push(sight.last);
    kept
}

/// Directions from a point that pass all following points within [`BESIDE`].
struct Sight {
    from: Point,
    last: Point,
    far: f64,
    /// Right and left border; `None` until a point lies at a distance.
    borders: Option<[Point; 2]>,
}

impl Sight {
    const fn from(from: Point) -> Self {
        Self { from, last: from, far: 0.0, borders: None }
    }

    /// Returns `true` if a straight line to the next point passes all points before it; the point is then the last one.
    fn passes(&mut self, point: Point) -> bool {
        let cross = |a: Point, b: Point| a.0 * b.1 - a.1 * b.0;
        let (x, y) = (point.0 - self.from.0, point.1 - self.from.1);
        let far = x.hypot(y);
        if !far.is_finite() || far + BESIDE < self.far {
            return false;
        }
        if far > 2.0 * BESIDE {
            let (sin, cos) = (BESIDE / far, (1.0 - (BESIDE / far).powi(2)).sqrt());
            let mut borders = [(x * cos + y * sin, y * cos - x * sin), (x * cos - y * sin, y * cos + x * sin)];
            if let Some([right, left]) = self.borders {
                if cross(right, (x, y)) < 0.0 || cross((x, y), left) < 0.0 {
                    return false;
                }
                if cross(borders[0], right) > 0.0 {
                    borders[0] = right;
                }
                if cross(left, borders[1]) > 0.0 {
                    borders[1] = left;
                }
            }
            self.borders = Some(borders);
        } else if self.borders.is_some() {
            return false;
        }
        self.far = self.far.max(far);
        self.last = point;
        true
    }
}

/// Returns the path of a line, clipped to an area, with gaps outside of it.
pub(crate) fn line_path(points: &[Point], area: &Rect) -> String {
    let points = straightened(points);
    let mut d = String::new();
    let mut pen: Option<Point> = None;
    for (&a, &b) in points.iter().zip(points.iter().skip(1)) {
        let Some((from, to)) = area.cut(a, b) else { continue };
        if pen != Some(from) {
            d.push_str(&format!("M{} {}", number(from.0), number(from.1)));
        }
        d.push_str(&format!("L{} {}", number(to.0), number(to.1)));
        pen = Some(to);
    }
    d
}

/// Returns the path of a closed outline, clipped to an area.
pub(crate) fn outline_path(points: &[Point], area: &Rect) -> String {
    let mut d = String::new();
    for (index, point) in area.cut_outline(points).iter().enumerate() {
        d.push_str(&format!("{}{} {}", if index == 0 { 'M' } else { 'L' }, number(point.0), number(point.1)));
    }
    if !d.is_empty() {
        d.push('Z');
    }
    d
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the distance of a point from a line segment.
    fn distance((x, y): Point, (a, b): (Point, Point)) -> f64 {
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let square = dx * dx + dy * dy;
        let along = if square > 0.0 { (((x - a.0) * dx + (y - a.1) * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
        (x - a.0 - along * dx).hypot(y - a.1 - along * dy)
    }

    #[test]
    fn a_straightened_line_passes_every_point() {
        let wave: Vec<Point> = (0..2000).map(|k| f64::from(k) * 0.3).map(|x| (x, 40.0 * (x / 25.0).sin())).collect();
        let steps =
            vec![(0.0, 0.0), (5.0, 0.0), (5.0, 8.0), (5.0, 3.0), (9.0, 3.0), (2.0, 3.0), (2.0, 3.0), (2.01, 3.0)];
        let level: Vec<Point> = (0..500).map(|k| (f64::from(k), 7.0)).collect();
        for (line, most) in [(&wave, 400), (&steps, steps.len()), (&level, 2)] {
            let short = straightened(line);
            assert!(short.len() <= most, "{} points", short.len());
            assert_eq!((short.first(), short.last()), (line.first(), line.last()));
            for point in line {
                let near =
                    short.windows(2).map(|pair| distance(*point, (pair[0], pair[1]))).fold(f64::INFINITY, f64::min);
                assert!(near <= 2.0 * BESIDE, "{point:?} lies {near} beside");
            }
        }
        assert_eq!(straightened(&[]), []);
        assert_eq!(straightened(&[(1.0, 2.0)]), [(1.0, 2.0)]);
    }

    #[test]
    fn few_points_stay_as_they_are() {
        let points = [(0.0, 1.0), (1.0, 5.0), (2.0, 3.0), (1.0, 2.0)];
        assert_eq!(reduced(&points), points);
        assert_eq!(reduced(&[]), []);
        assert_eq!(reduced(&[(3.0, 4.0)]), [(3.0, 4.0)]);
    }

    #[test]
    fn every_column_keeps_its_ends_and_extremes() {
        arbtest::arbtest(|u| {
            let count = u.int_in_range(0..=400)?;
            let mut points = Vec::new();
            let mut x = 0.0;
            for _ in 0..count {
                x += f64::from(u.int_in_range(0_u8..=20)?) * 0.01;
                points.push((x, f64::from(u.arbitrary::<i16>()?)));
            }
            let kept = reduced(&points);
            let column = |p: &Point| (p.0 / COLUMN).floor();
            for point in &points {
                let all: Vec<f64> = points.iter().filter(|p| column(p) == column(point)).map(|p| p.1).collect();
                let some: Vec<f64> = kept.iter().filter(|p| column(p) == column(point)).map(|p| p.1).collect();
                assert!(some.len() <= 4);
                let ends = |ys: &[f64]| {
                    let fold = |f: fn(f64, f64) -> f64| ys.iter().copied().reduce(f).unwrap();
                    (ys[0], fold(f64::min), fold(f64::max), ys[ys.len() - 1])
                };
                assert_eq!(ends(&all), ends(&some));
            }
            Ok(())
        });
    }

    #[test]
    fn a_cycle_run_through_often_is_drawn_once() {
        let turn = |i: u32| f64::from(i % 500) / 500.0 * std::f64::consts::TAU;
        let points: Vec<Point> = (0..100_000).map(|i| (100.0 * turn(i).cos(), 100.0 * turn(i).sin())).collect();
        let pieces = without_repeats(points.clone());
        assert!(pieces.concat().len() <= 502, "{}", pieces.concat().len());
        for point in points.iter().take(500) {
            assert!(pieces.concat().iter().any(|kept| (kept.0 - point.0).hypot(kept.1 - point.1) < 0.5));
        }
        assert_eq!(without_repeats(points[..1500].to_vec()), [&points[..1500]]);
    }

    #[test]
    fn level_and_upright_stretches_are_written_by_their_ends() {
        let points = [(0.0, 1.0), (1.0, 1.0), (2.0, 1.001), (3.0, 1.0), (3.0, 2.0), (3.0, 5.0), (3.0, 4.0), (4.0, 3.0)];
        let kept = [(0.0, 1.0), (3.0, 1.0), (3.0, 5.0), (3.0, 4.0), (4.0, 3.0)];
        assert_eq!(straightened(&points), kept);
    }

    #[test]
    fn a_million_points_become_a_few_thousand() {
        let points: Vec<Point> =
            (0..1_000_000_u32).map(|i| (f64::from(i) * 5e-4, (f64::from(i) * 0.37).sin() * 100.0)).collect();
        let kept = reduced(&points);
        assert!(kept.len() <= 4 * 1001, "{}", kept.len());
    }
}
