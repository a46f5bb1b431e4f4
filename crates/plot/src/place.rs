//! Placement of text: drawn items are marked on a grid, and a text is put at the free place nearest to its point.

use std::collections::BTreeMap;

use crate::geometry::{Point, Rect};

/// Side of a cell of the grid \[px\].
const CELL: f64 = 3.0;
/// Largest number of cells along a side, so that a large picture has coarser cells.
const CELLS_MAX: f64 = 600.0;

/// A plane with the occupied areas in it.
pub(crate) struct OccupiedPlane {
    area: Rect,
    cell: f64,
    columns: usize,
    rows: usize,
    taken: Vec<bool>,
    texts: Vec<Rect>,
    /// Centres of markers by squares of [`SQUARE`].
    markers: BTreeMap<(usize, usize), Vec<Point>>,
}

/// A place found for a text.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TextPlace {
    pub(crate) area: Rect,
    /// End of the leader at the text; `None` if the text is close to its point.
    pub(crate) leader: Option<Point>,
}

/// Placement of a text relative to its point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Near {
    /// Smallest distance between point and text.
    pub(crate) gap: f64,
    /// Largest distance between point and text.
    pub(crate) reach: f64,
    /// Largest cost of a place: covered items, distance, crossings of its leader.
    pub(crate) worst: f64,
}

impl OccupiedPlane {
    pub(crate) fn new(area: Rect) -> Self {
        let cell = CELL.max(area.width().max(area.height()) / CELLS_MAX);
        let (columns, rows) = (whole(area.width() / cell) + 1, whole(area.height() / cell) + 1);
        Self {
            area,
            cell,
            columns,
            rows,
            taken: vec![false; columns * rows],
            texts: Vec::new(),
            markers: BTreeMap::new(),
        }
    }

    pub(crate) fn line(&mut self, points: &[Point]) {
        for (&a, &b) in points.iter().zip(points.iter().skip(1)) {
            let Some((from, to)) = self.area.cut(a, b) else { continue };
            let steps = whole((to.0 - from.0).abs().max((to.1 - from.1).abs()) / (self.cell * 0.5)) + 1;
            for step in 0..=steps {
                let t = real(step) / real(steps);
                self.point(((to.0 - from.0).mul_add(t, from.0), (to.1 - from.1).mul_add(t, from.1)));
            }
        }
    }

    pub(crate) fn marker(&mut self, at: Point, radius: f64) {
        self.markers.entry(square(at)).or_default().push(at);
        let box_ = Rect { left: at.0, right: at.0, top: at.1, bottom: at.1 }.grown(radius);
        for index in self.cells(&box_) {
            if let Some(cell) = self.taken.get_mut(index) {
                *cell = true;
            }
        }
    }

    /// Keeps all other text out of a box.
    pub(crate) fn text(&mut self, area: Rect) {
        self.texts.push(area);
    }

    fn point(&mut self, at: Point) {
        let (column, row) = (whole((at.0 - self.area.left) / self.cell), whole((at.1 - self.area.top) / self.cell));
        if column < self.columns
            && let Some(cell) = self.taken.get_mut(row * self.columns + column)
        {
            *cell = true;
        }
    }

    fn cells(&self, area: &Rect) -> impl Iterator<Item = usize> + use<> {
        let clamp = |value: f64, most: usize| whole(value / self.cell).min(most.saturating_sub(1));
        let (left, right) =
            (clamp(area.left - self.area.left, self.columns), clamp(area.right - self.area.left, self.columns));
        let (top, bottom) = (clamp(area.top - self.area.top, self.rows), clamp(area.bottom - self.area.top, self.rows));
        let columns = self.columns;
        (top..=bottom).flat_map(move |row| (left..=right).map(move |column| row * columns + column))
    }

    /// Returns the number of occupied cells below a box; `None` if the box leaves the plane or overlaps a text.
    pub(crate) fn cost(&self, area: &Rect) -> Option<f64> {
        let free = self.area.holds(area) && !self.texts.iter().any(|text| text.overlaps(area));
        free.then(|| real(self.cells(area).filter(|index| self.taken.get(*index) == Some(&true)).count()))
    }

    /// Returns the box that covers least; of equal ones the first.
    pub(crate) fn best(&self, boxes: impl IntoIterator<Item = Rect>) -> Option<(Rect, f64)> {
        let mut best: Option<(Rect, f64)> = None;
        for area in boxes {
            if let Some(cost) = self.cost(&area.grown(1.5)).or_else(|| self.cost(&area))
                && best.is_none_or(|(_, least)| cost < least)
            {
                best = Some((area, cost));
            }
        }
        best
    }

    /// Finds a place for a box of a size near a point and occupies it.
    pub(crate) fn place_near(&mut self, at: Point, (width, height): (f64, f64), near: Near) -> Option<TextPlace> {
        let Near { gap, reach, worst } = near;
        let mut best: Option<(TextPlace, f64)> = None;
        for (ring, distance) in [0.0, 7.0, 15.0, 25.0, 38.0, 54.0, 74.0, 98.0].into_iter().enumerate() {
            let distance = distance + gap;
            if distance > reach.max(gap) {
                break;
            }
            for (order, (x, y)) in DIRECTIONS.into_iter().enumerate() {
                let middle = ((width / 2.0 + distance).mul_add(x, at.0), (height / 2.0 + distance).mul_add(y, at.1));
                let area = Rect {
                    left: middle.0 - width / 2.0,
                    right: middle.0 + width / 2.0,
                    top: middle.1 - height / 2.0,
                    bottom: middle.1 + height / 2.0,
                };
                let Some(covered) = self.cost(&area) else { continue };
                let leader = (ring > 0).then(|| area.nearest(at));
                let crossing = leader.map_or(0.0, |end| self.crossing(at, end))
                    + if self.covers_marker(&area) { 300.0 } else { 0.0 };
                // A text at a distance should not be next to another point, whose name it would appear to be.
                let beside = if ring > 0 { self.cost(&area.grown(4.0)).unwrap_or(0.0) - covered } else { 0.0 };
                let score = covered.mul_add(8.0, distance * 0.5) + 2.0 * beside + real(order) * 0.15 + crossing;
                if best.as_ref().is_none_or(|(_, least)| score < *least) {
                    best = Some((TextPlace { area, leader }, score));
                }
            }
        }
        let (place, _) = best.filter(|(_, score)| *score <= worst)?;
        // Adjacent texts need a blank between them.
        self.texts.push(place.area.grown(1.8));
        if let Some(end) = place.leader {
            self.line(&[at, end]);
        }
        Some(place)
    }

    /// Returns `true` if a box covers a marker.
    fn covers_marker(&self, area: &Rect) -> bool {
        let around = area.grown(SOLID);
        let (from, to) = (square((around.left, around.top)), square((around.right, around.bottom)));
        (from.0..=to.0).any(|column| {
            let squares = self.markers.range((column, from.1)..=(column, to.1));
            squares.flat_map(|(_, middles)| middles).any(|middle| around.cut(*middle, *middle).is_some())
        })
    }

    /// Returns the cost of a leader that crosses texts and drawn items away from its own point.
    fn crossing(&self, from: Point, to: Point) -> f64 {
        if self.texts.iter().any(|text| text.cut(from, to).is_some()) {
            return 400.0;
        }
        let length = (to.0 - from.0).hypot(to.1 - from.1);
        let steps = whole(length / self.cell);
        let crossed = (0..=steps).map(|step| real(step) * self.cell).filter(|along| *along > OWN).filter(|along| {
            let t = along / length;
            let at = ((to.0 - from.0).mul_add(t, from.0), (to.1 - from.1).mul_add(t, from.1));
            self.is_taken(at)
        });
        25.0 * real(crossed.count())
    }

    fn is_taken(&self, at: Point) -> bool {
        let (column, row) = (whole((at.0 - self.area.left) / self.cell), whole((at.1 - self.area.top) / self.cell));
        column < self.columns && self.taken.get(row * self.columns + column) == Some(&true)
    }
}

/// Side of a square of markers \[px\].
const SQUARE: f64 = 16.0;
/// Half side of the area around the centre of a marker that no text may cover \[px\].
const SOLID: f64 = 3.0;

fn square(at: Point) -> (usize, usize) {
    (whole(at.0 / SQUARE), whole(at.1 / SQUARE))
}

/// Distance from its point within which a leader may cross items \[px\].
const OWN: f64 = 7.0;

/// Directions from a point in the order of preference: upper right first.
const DIRECTIONS: [Point; 16] = [
    (1.0, -0.75),
    (-1.0, -0.75),
    (1.0, 0.75),
    (-1.0, 0.75),
    (1.0, 0.0),
    (-1.0, 0.0),
    (0.0, -1.0),
    (0.0, 1.0),
    (0.5, -1.0),
    (-0.5, -1.0),
    (0.5, 1.0),
    (-0.5, 1.0),
    (1.0, -0.4),
    (-1.0, -0.4),
    (1.0, 0.4),
    (-1.0, 0.4),
];

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates, which is what is meant")]
const fn whole(value: f64) -> usize {
    value as usize
}

#[expect(clippy::cast_precision_loss, reason = "a count of cells is small")]
const fn real(value: usize) -> f64 {
    value as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    const AREA: Rect = Rect { left: 0.0, right: 300.0, top: 0.0, bottom: 200.0 };
    const NEAR: Near = Near { gap: 4.0, reach: 120.0, worst: 1e3 };

    #[test]
    fn texts_near_one_point_do_not_overlap() {
        let mut field = OccupiedPlane::new(AREA);
        let places: Vec<Rect> = (0..12)
            .filter_map(|_| field.place_near((150.0, 100.0), (40.0, 12.0), NEAR))
            .map(|place| place.area)
            .collect();
        assert!(places.len() >= 8, "{}", places.len());
        for (i, a) in places.iter().enumerate() {
            assert!(AREA.holds(a));
            assert!(places.iter().skip(i + 1).all(|b| !a.overlaps(b)));
        }
    }

    #[test]
    fn a_text_avoids_a_line() {
        let mut field = OccupiedPlane::new(AREA);
        field.line(&[(0.0, 200.0), (300.0, 0.0)]);
        let place = field.place_near((150.0, 100.0), (50.0, 12.0), NEAR).unwrap();
        assert!(field.taken.iter().filter(|taken| **taken).count() > 60);
        assert!(place.area.right < 150.0 || place.area.top > 100.0 || place.area.left > 150.0);
        assert_eq!(field.cells(&place.area).filter(|index| field.taken[*index]).count(), 0);
    }
}
