//! The kept panels as a k-d tree over their bounds: neighbours in the signals, whenever they were. What lies together has
//! close bounds however many different moves follow upon each other, and a search need look into few of them.

use crate::halves::{Point, halve, scale};
use crate::{Extent, Kept, Node};

/// A branch of at most so many panels is not split.
const LEAF: usize = 2;

/// Panels with close bounds.
#[derive(Clone, Debug)]
pub(super) struct Branch {
    /// What bounds them all.
    pub(super) extent: Extent,
    /// Instant at which the first of them begins \[s\].
    pub(super) from: f64,
    inside: Inside,
}

#[derive(Clone, Debug)]
enum Inside {
    /// Panels, between two places of the order.
    Panels(usize, usize),
    /// Two branches.
    Halves([usize; 2]),
}

/// The tree, its root last.
#[derive(Clone, Debug)]
pub(super) struct Near {
    branches: Vec<Branch>,
    order: Vec<usize>,
}

impl Near {
    /// Of the panels that are no copies of others.
    ///
    /// Cost: O(n log n)
    pub(super) fn of(panels: &[Kept], nodes: &[Node]) -> Self {
        let mut points: Vec<Point<6>> = panels
            .iter()
            .enumerate()
            .filter(|(_, kept)| !kept.like.is_copy)
            .filter_map(|(index, kept)| Some(Point { signals: signals(&kept.extent), index: index.try_into().ok()? }))
            .collect();
        let room = 2 * points.len().div_ceil(LEAF).next_power_of_two();
        let mut all = Self { branches: Vec::with_capacity(room), order: Vec::with_capacity(points.len()) };
        if !points.is_empty() {
            let scale = scale(&points);
            all.split((panels, nodes), &mut points, &scale);
        }
        all
    }

    /// Adds the branches of some points; which is the one of all of them.
    fn split(&mut self, of: (&[Kept], &[Node]), points: &mut [Point<6>], scale: &[f32; 6]) -> usize {
        let mut branch = Branch { extent: Extent::NONE, from: f64::INFINITY, inside: Inside::Panels(0, 0) };
        if points.len() <= LEAF {
            let first = self.order.len();
            points.sort_unstable_by_key(|point| point.index);
            for index in points.iter().map(|point| point.index as usize) {
                if let Some(kept) = of.0.get(index) {
                    branch.extent.join(&kept.extent);
                    branch.from = branch.from.min(of.1.get(kept.nodes.start).map_or(0.0, |node| node.time_s));
                    self.order.push(index);
                }
            }
            branch.inside = Inside::Panels(first, self.order.len());
        } else {
            let middle = halve(points, scale);
            let (low, high) = points.split_at_mut(middle);
            let halves = [self.split(of, low, scale), self.split(of, high, scale)];
            for half in halves.iter().filter_map(|half| self.branches.get(*half)) {
                branch.extent.join(&half.extent);
                branch.from = branch.from.min(half.from);
            }
            branch.inside = Inside::Halves(halves);
        }
        self.branches.push(branch);
        self.branches.len() - 1
    }

    pub(super) fn root(&self) -> Option<&Branch> {
        self.branches.last()
    }

    /// The halves of a branch, or the panels of one that is not split.
    #[inline]
    pub(super) fn inside(&self, branch: &Branch) -> Result<[Option<&Branch>; 2], &[usize]> {
        match branch.inside {
            Inside::Halves(halves) => Ok(halves.map(|half| self.branches.get(half))),
            Inside::Panels(from, to) => Err(self.order.get(from..to).unwrap_or_default()),
        }
    }
}

/// The bounds of acceleration, torque and speed.
#[allow(clippy::cast_possible_truncation, reason = "only neighbourhood counts")]
const fn signals(extent: &Extent) -> [f32; 6] {
    let (a, t, w) = (extent.acceleration_rad_s2, extent.load_nm, extent.speeds_rad_s);
    [a.0 as f32, a.1 as f32, t.0 as f32, t.1 as f32, w.0 as f32, w.1 as f32]
}
