//! Rectangles, and clipping of lines to them.

/// A rectangle in px, y downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// Left edge.
    pub left: f64,
    /// Right edge.
    pub right: f64,
    /// Upper edge, the smaller y.
    pub top: f64,
    /// Lower edge.
    pub bottom: f64,
}

pub(crate) type Point = (f64, f64);

impl Rect {
    /// Returns the width.
    #[must_use]
    pub const fn width(&self) -> f64 {
        self.right - self.left
    }

    /// Returns the height.
    #[must_use]
    pub const fn height(&self) -> f64 {
        self.bottom - self.top
    }

    /// Returns `true` if two rectangles share more than an edge.
    #[must_use]
    pub const fn overlaps(&self, other: &Self) -> bool {
        self.left < other.right && other.left < self.right && self.top < other.bottom && other.top < self.bottom
    }

    /// Returns `true` if another rectangle lies within this one.
    #[must_use]
    pub const fn holds(&self, other: &Self) -> bool {
        self.left <= other.left && other.right <= self.right && self.top <= other.top && other.bottom <= self.bottom
    }

    pub(crate) fn grown(&self, by: f64) -> Self {
        Self { left: self.left - by, right: self.right + by, top: self.top - by, bottom: self.bottom + by }
    }

    pub(crate) fn middle(&self) -> Point {
        (f64::midpoint(self.left, self.right), f64::midpoint(self.top, self.bottom))
    }

    /// Returns the point of the rectangle nearest to another point.
    pub(crate) fn nearest(&self, to: Point) -> Point {
        (to.0.clamp(self.left, self.right.max(self.left)), to.1.clamp(self.top, self.bottom.max(self.top)))
    }

    /// Clips a line from `a` to `b` to the rectangle (Liang and Barsky).
    pub(crate) fn cut(&self, a: Point, b: Point) -> Option<(Point, Point)> {
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for (p, q) in [(-dx, a.0 - self.left), (dx, self.right - a.0), (-dy, a.1 - self.top), (dy, self.bottom - a.1)] {
            if p == 0.0 {
                if q < 0.0 {
                    return None;
                }
            } else if p < 0.0 {
                from = from.max(q / p);
            } else {
                to = to.min(q / p);
            }
        }
        let at = |t: f64| (dx.mul_add(t, a.0), dy.mul_add(t, a.1));
        (from <= to).then(|| (if from > 0.0 { at(from) } else { a }, if to < 1.0 { at(to) } else { b }))
    }

    /// Clips a closed outline to the rectangle (Sutherland and Hodgman).
    pub(crate) fn cut_outline(&self, outline: &[Point]) -> Vec<Point> {
        let cross_x = |a: Point, b: Point, x: f64| (x, (b.1 - a.1).mul_add((x - a.0) / (b.0 - a.0), a.1));
        let cross_y = |a: Point, b: Point, y: f64| ((b.0 - a.0).mul_add((y - a.1) / (b.1 - a.1), a.0), y);
        let left = half(outline, |p| p.0 >= self.left, |a, b| cross_x(a, b, self.left));
        let right = half(&left, |p| p.0 <= self.right, |a, b| cross_x(a, b, self.right));
        let top = half(&right, |p| p.1 >= self.top, |a, b| cross_y(a, b, self.top));
        half(&top, |p| p.1 <= self.bottom, |a, b| cross_y(a, b, self.bottom))
    }
}

fn half(outline: &[Point], inside: impl Fn(Point) -> bool, cross: impl Fn(Point, Point) -> Point) -> Vec<Point> {
    let mut kept = Vec::with_capacity(outline.len() + 4);
    let Some(last) = outline.last() else { return kept };
    let mut from = *last;
    for &to in outline {
        if inside(from) != inside(to) {
            kept.push(cross(from, to));
        }
        if inside(to) {
            kept.push(to);
        }
        from = to;
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Rect = Rect { left: 0.0, right: 1.0, top: 0.0, bottom: 1.0 };

    #[test]
    fn a_line_is_cut_where_it_leaves() {
        assert_eq!(UNIT.cut((-1.0, 0.5), (3.0, 0.5)), Some(((0.0, 0.5), (1.0, 0.5))));
        assert_eq!(UNIT.cut((-1.0, 2.0), (2.0, 2.0)), None);
        assert_eq!(UNIT.cut((0.2, 0.2), (0.2, 0.2)), Some(((0.2, 0.2), (0.2, 0.2))));
        assert_eq!(UNIT.cut((2.0, 0.0), (3.0, 1.0)), None);
    }

    #[test]
    fn an_outline_around_becomes_the_rectangle() {
        let around = [(-5.0, -5.0), (5.0, -5.0), (5.0, 5.0), (-5.0, 5.0)];
        let cut = UNIT.cut_outline(&around);
        assert_eq!(cut.len(), 4);
        assert!(cut.iter().all(|p| [0.0, 1.0].contains(&p.0) && [0.0, 1.0].contains(&p.1)));
        assert!(UNIT.cut_outline(&[(2.0, 2.0), (3.0, 2.0), (3.0, 3.0)]).is_empty());
    }
}
