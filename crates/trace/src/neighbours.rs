//! The stored panels as a k-d tree over their bounds, so that neighbours are close in the signals, not in time. Close
//! bounds are found for any number of different moves, and a search visits few branches.

use crate::bisection::{Point, halve, scale};
use crate::{Extent, Kept, Node};

/// Maximum number of panels in a branch that is not split.
const LEAF: usize = 2;

/// A group of panels with close bounds.
#[derive(Clone, Debug)]
pub(super) struct Branch {
    /// Common bounds of the panels.
    pub(super) extent: Extent,
    /// Instant at which the first of them begins \[s\].
    pub(super) from: f64,
    inside: Inside,
}

#[derive(Clone, Debug)]
enum Inside {
    /// Panels, as a range of places in the order.
    Panels(usize, usize),
    /// Two branches, by index.
    Halves([usize; 2]),
}

/// The tree, its root last.
#[derive(Clone, Debug)]
pub(super) struct NeighbourTree {
    branches: Vec<Branch>,
    order: Vec<usize>,
}

impl NeighbourTree {
    /// Builds the tree over the panels that are not copies of others.
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

    /// Adds the branches of some points and returns the index of the branch that contains all of them.
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

    /// Returns the two halves of a branch, or the indices of the panels of an undivided one.
    #[inline]
    pub(super) fn inside(&self, branch: &Branch) -> Result<[Option<&Branch>; 2], &[usize]> {
        match branch.inside {
            Inside::Halves(halves) => Ok(halves.map(|half| self.branches.get(half))),
            Inside::Panels(from, to) => Err(self.order.get(from..to).unwrap_or_default()),
        }
    }
}

/// Returns the bounds of acceleration, torque and speed in single precision.
#[allow(clippy::cast_possible_truncation, reason = "only neighbourhood counts")]
const fn signals(extent: &Extent) -> [f32; 6] {
    let (a, t, w) = (extent.acceleration_rad_s2, extent.load_nm, extent.speeds_rad_s);
    [a.0 as f32, a.1 as f32, t.0 as f32, t.1 as f32, w.0 as f32, w.1 as f32]
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;
    use crate::lag_tests::under;
    use crate::tests::{arm, law, motion};
    use crate::{Any, Sought, TorqueWith, Trace};
    use motion::{Law, SegmentSpec};

    fn swings() -> Trace {
        let swings: Vec<SegmentSpec> = (0..60)
            .map(|k| {
                let angle = (0.5 + 0.01 * f64::from(k / 2)) * if k % 2 == 0 { 1.0 } else { -1.0 };
                law(Law::ModifiedSine, angle, 0.5 + 0.002 * f64::from(k / 2 % 7))
            })
            .collect();
        under(&arm(), &motion(&swings))
    }

    #[test]
    fn every_panel_lies_in_one_leaf_and_within_the_bounds_of_all_above() {
        let trace = swings();
        let near = NeighbourTree::of(&trace.panels, &trace.nodes);
        let mut all: Vec<usize> = near.order.clone();
        all.sort_unstable();
        assert!(all.len() > 100 && all.iter().copied().eq(0..trace.panels.len()));
        let mut seen = 0;
        let mut open = vec![(near.root().unwrap(), vec![near.root().unwrap()])];
        while let Some((branch, above)) = open.pop() {
            match near.inside(branch) {
                Ok(halves) => {
                    for half in halves.into_iter().flatten() {
                        open.push((half, above.iter().copied().chain([half]).collect()));
                    }
                }
                Err(panels) => {
                    seen += panels.len();
                    assert!(!panels.is_empty() && panels.len() <= LEAF);
                    for kept in panels.iter().map(|panel| &trace.panels[*panel]) {
                        for branch in &above {
                            let mut both = branch.extent;
                            both.join(&kept.extent);
                            assert_eq!(both, branch.extent);
                            assert!(branch.from <= trace.nodes[kept.nodes.start].time_s);
                        }
                    }
                }
            }
        }
        assert_eq!(seen, trace.panels.len());
    }

    /// The search with the tree finds the same values as the search panel by panel.
    #[test]
    fn the_tree_finds_what_the_panels_show() {
        fn same(trace: &Trace, sought: &impl Sought) {
            let ((a, at), (b, of)) = (trace.largest(sought), trace.largest_once(sought));
            assert!((a - b).abs() <= 1e-12 * b.abs() && (at.time_s - of.time_s).abs() < 1e-6, "{a} {b}: {at:?} {of:?}");
        }
        let trace = swings();
        for inertia_kgm2 in [0.0, 0.3, 2.0] {
            same(&trace, &TorqueWith { inertia_kgm2 });
            let bound = |extent: &Extent| extent.torque(inertia_kgm2) * extent.speed_rad_s;
            let value =
                |node: &Node| (inertia_kgm2 * node.acceleration_rad_s2 + node.load_nm).abs() * node.speed_rad_s.abs();
            same(&trace, &Any(bound, value));
        }
    }
}
