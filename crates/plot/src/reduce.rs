//! Long series made short without losing a peak.

use crate::geometry::{Point, Rect};

/// Width of a column in px: half a pixel of a plain screen.
const COLUMN: f64 = 0.5;

/// Of each run of points within one column the first, the lowest, the highest and the last, in their order.
///
/// The drawn line covers the same rows of every column as the full one does, so no extreme is lost.
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

/// The path of a line, cut to an area; the pen lifts where it leaves.
pub(crate) fn line_path(points: &[Point], area: &Rect) -> String {
    use crate::canvas::number;
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

/// The path of a closed outline, cut to an area.
pub(crate) fn outline_path(points: &[Point], area: &Rect) -> String {
    use crate::canvas::number;
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
    fn a_million_points_become_a_few_thousand() {
        let points: Vec<Point> =
            (0..1_000_000_u32).map(|i| (f64::from(i) * 5e-4, (f64::from(i) * 0.37).sin() * 100.0)).collect();
        let kept = reduced(&points);
        assert!(kept.len() <= 4 * 1001, "{}", kept.len());
    }
}
