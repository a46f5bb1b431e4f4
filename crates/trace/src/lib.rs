//! A cycle as weighted instants: a motion under its load in blocks with sums of products and bounds.
//!
//! [`Trace::of`] evaluates a motion once. Any form of the four signals (α, T_L, σ, ω), such as torque, current, loss or
//! voltage, can then be integrated, searched for its largest value or passed through a first-order lag without
//! evaluating the motion again. The actuator is unknown here, except for the part of each rest during which it carries
//! the load ([`Carried`]).

mod bisection;
mod build;
mod carried;
mod cubes;
mod form;
mod gains;
mod kinks;
mod lags;
mod neighbours;
mod panel;
mod recording;
mod repeats;
mod rule;
mod search;
mod short;
mod smooth;

pub use build::{INSTANTS_MOST, instants};
pub use carried::Carried;
pub use form::Form;
pub use kinks::kink_passes;
pub use lags::{Lag, Peak};
pub use panel::{Like, Panel};
pub use recording::{Cell, Inside, Ramps, Strip, Surveys, Swept};
pub use search::{Any, Convex, Sought, TorqueWith};
pub use smooth::Smooth;

use lags::LagCache;
use mechanism::{Extra, Mechanism};
use motion::Motion;
use neighbours::NeighbourTree;
use panel::Kept;
use quantities::{Angle, Measure, MomentOfInertia, Torque};
use short::Straight;
use std::ops::Range;
use std::sync::{Arc, OnceLock};

/// One instant of the cycle with its quadrature weight.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Node {
    /// Instant from the start of the cycle \[s\].
    pub time_s: f64,
    /// Weight of the quadrature \[s\]; the weights sum to the duration.
    pub weight_s: f64,
    /// α [rad/s²]
    pub acceleration_rad_s2: f64,
    /// ω [rad/s]
    pub speed_rad_s: f64,
    /// σ: +1, −1, 0 at rest.
    pub direction: f64,
    /// Torque at the actuator required by the load, without the actuator's own inertia \[Nm\]; zero while the brake
    /// holds.
    pub load_nm: f64,
}

impl Node {
    /// Returns the signals x = (α, T_L, σ, ω).
    #[inline]
    pub const fn signals(&self) -> [f64; 4] {
        [self.acceleration_rad_s2, self.load_nm, self.direction, self.speed_rad_s]
    }

    /// Returns the instant at a share of the way to the next one, by linear interpolation.
    #[inline]
    pub fn towards(&self, next: &Self, share: f64) -> Self {
        let between = |a: f64, b: f64| a + share * (b - a);
        Self {
            time_s: between(self.time_s, next.time_s),
            weight_s: 0.0,
            acceleration_rad_s2: between(self.acceleration_rad_s2, next.acceleration_rad_s2),
            speed_rad_s: between(self.speed_rad_s, next.speed_rad_s),
            direction: self.direction,
            load_nm: between(self.load_nm, next.load_nm),
        }
    }
}

/// Bounds of the signals of some nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// α [rad/s²]
    pub acceleration_rad_s2: (f64, f64),
    /// T_L \[Nm\]
    pub load_nm: (f64, f64),
    /// σ
    pub direction: (f64, f64),
    /// ω [rad/s]
    pub speeds_rad_s: (f64, f64),
    /// Largest |ω| [rad/s].
    pub speed_rad_s: f64,
}

impl Extent {
    const NONE: Self = Self {
        acceleration_rad_s2: (f64::INFINITY, f64::NEG_INFINITY),
        load_nm: (f64::INFINITY, f64::NEG_INFINITY),
        direction: (f64::INFINITY, f64::NEG_INFINITY),
        speeds_rad_s: (f64::INFINITY, f64::NEG_INFINITY),
        speed_rad_s: 0.0,
    };

    #[inline]
    fn widen(&mut self, node: &Node) {
        let wider = |(low, high): (f64, f64), value: f64| (low.min(value), high.max(value));
        self.acceleration_rad_s2 = wider(self.acceleration_rad_s2, node.acceleration_rad_s2);
        self.load_nm = wider(self.load_nm, node.load_nm);
        self.direction = wider(self.direction, node.direction);
        self.speeds_rad_s = wider(self.speeds_rad_s, node.speed_rad_s);
        self.speed_rad_s = self.speed_rad_s.max(node.speed_rad_s.abs());
    }

    /// Returns the bounds of a panel: its nodes and the curve between them.
    fn of(nodes: &[Node], bow: &[f64; 4]) -> Self {
        let mut extent = Self::NONE;
        nodes.iter().for_each(|node| extent.widen(node));
        extent.bend(bow);
        extent
    }

    /// Returns the bounds of the curve between two neighbouring nodes of a panel.
    #[inline]
    fn between(a: &Node, b: &Node, bow: &[f64; 4]) -> Self {
        let mut extent = Self::NONE;
        extent.widen(a);
        extent.widen(b);
        extent.bend(bow);
        extent
    }

    /// Widens the bounds by the largest deviation of each signal from the straight lines between the nodes.
    #[inline]
    fn bend(&mut self, [acceleration, load, _, speed]: &[f64; 4]) {
        for ((low, high), bow) in
            [(&mut self.acceleration_rad_s2, acceleration), (&mut self.load_nm, load), (&mut self.speeds_rad_s, speed)]
                .map(|((low, high), bow)| ((low, high), bow))
        {
            *low -= bow;
            *high += bow;
        }
        self.speed_rad_s += speed;
    }

    #[inline]
    fn join(&mut self, other: &Self) {
        let both = |a: (f64, f64), b: (f64, f64)| (a.0.min(b.0), a.1.max(b.1));
        self.acceleration_rad_s2 = both(self.acceleration_rad_s2, other.acceleration_rad_s2);
        self.load_nm = both(self.load_nm, other.load_nm);
        self.direction = both(self.direction, other.direction);
        self.speeds_rad_s = both(self.speeds_rad_s, other.speeds_rad_s);
        self.speed_rad_s = self.speed_rad_s.max(other.speed_rad_s);
    }

    /// Returns the range of c·x within the bounds.
    #[inline]
    pub fn range(&self, c: [f64; 4]) -> (f64, f64) {
        let ranges = [self.acceleration_rad_s2, self.load_nm, self.direction, self.speeds_rad_s];
        c.into_iter().zip(ranges).fold((0.0, 0.0), |(low, high), (c, (from, to))| {
            (low + (c * from).min(c * to), high + (c * from).max(c * to))
        })
    }

    /// Returns an upper bound of |J α + T_L| at the nodes \[Nm\].
    #[inline]
    pub fn torque(&self, inertia: f64) -> f64 {
        let (low, high) = self.torques(inertia);
        high.max(-low)
    }

    /// Returns the range of J α + T_L within the bounds \[Nm\].
    #[inline]
    pub fn torques(&self, inertia: f64) -> (f64, f64) {
        // A joint with T_L − J α passes a negative inertia.
        let (a, b) = (inertia * self.acceleration_rad_s2.0, inertia * self.acceleration_rad_s2.1);
        (a.min(b) + self.load_nm.0, a.max(b) + self.load_nm.1)
    }

    /// Returns the sign of (J α + T_L) σ if it is the same at all nodes: +1 if nowhere negative, −1 if nowhere
    /// positive, else `None`.
    #[inline]
    pub fn power_sign(&self, inertia: f64) -> Option<f64> {
        let ((low, high), (back, forth)) = (self.torques(inertia), self.direction);
        if (low >= 0.0 && back >= 0.0) || (high <= 0.0 && forth <= 0.0) {
            Some(1.0)
        } else if (low >= 0.0 && forth <= 0.0) || (high <= 0.0 && back >= 0.0) {
            Some(-1.0)
        } else {
            None
        }
    }
}

/// Sums of products of the signals (α, T_L, σ, ω) over a time.
///
/// G_ij = ∫ x_i x_j dt with x = (α, T_L, σ, ω). Any signal that is a weighted sum s = Σ c_i x_i, such as torque and
/// current, has ∫s² dt = cᵀ G c: one pass over the motion, then ten products per candidate.
///
/// # Source
/// own derivation, docs/theory/moments.md
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gram([[f64; 4]; 4]);

impl Gram {
    fn add(&mut self, node: &Node) {
        let x = node.signals();
        for (row, a) in self.0.iter_mut().zip(x) {
            let scaled = a * node.weight_s;
            for (sum, b) in row.iter_mut().zip(x) {
                *sum += scaled * b;
            }
        }
    }

    #[inline]
    fn join(&mut self, other: &Self) {
        for (row, others) in self.0.iter_mut().zip(&other.0) {
            for (sum, other) in row.iter_mut().zip(others) {
                *sum += other;
            }
        }
    }

    /// Subtracts the contribution of a panel.
    pub fn take(&mut self, panel: &Panel<'_>) {
        panel.nodes.iter().for_each(|node| self.add(&Node { weight_s: -node.weight_s, ..*node }));
    }

    /// Returns cᵀ G c, the integral of (c·x)².
    #[inline]
    pub fn square(&self, c: [f64; 4]) -> f64 {
        // Rounding may leave a tiny negative sum where the signal vanishes.
        self.product(c, c).max(0.0)
    }

    /// Returns aᵀ G b, the integral of (a·x)(b·x).
    #[inline]
    pub fn product(&self, a: [f64; 4], b: [f64; 4]) -> f64 {
        self.0.iter().zip(a).map(|(row, a)| a * row.iter().zip(b).map(|(g, b)| g * b).sum::<f64>()).sum()
    }

    /// Returns the matrix G_ij = ∫ x_i x_j dt with x = (α, T_L, σ, ω).
    #[must_use]
    #[inline]
    pub const fn sums(&self) -> &[[f64; 4]; 4] {
        &self.0
    }

    /// Returns ∫σ² dt, the time in motion \[s\].
    #[inline]
    pub const fn moving(&self) -> f64 {
        self.0[2][2]
    }

    /// Returns ∫σ ω dt = ∫|ω| dt, the angle travelled \[rad\].
    #[inline]
    pub const fn travelled(&self) -> f64 {
        self.0[2][3]
    }
}

/// Contribution of one segment to the cycle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Share {
    /// Angle travelled, ∫|ω| dt.
    pub travelled: Angle,
}

/// Location of the panels of a block.
#[derive(Clone, Debug, PartialEq)]
enum BlockPanels {
    /// Stored panels, as a range of indices.
    Kept(Range<usize>),
    /// Intervals of a recording, whose panels are computed each time they are read.
    Recorded { strip: usize, intervals: Range<usize> },
}

/// A sequence of panels or blocks in chronological order.
#[derive(Clone, Debug, PartialEq)]
enum Run {
    /// Stored panels, as a range of indices.
    Kept(Range<usize>),
    /// Stored panels that are repeated several times: the revolutions at constant speed.
    Repeated(Range<usize>, f64),
    /// Blocks of one strip, by its index.
    Recorded(usize),
}

/// Neighbouring nodes with their bounds and sums.
#[derive(Clone, Debug)]
pub struct Block {
    place: BlockPanels,
    /// Instant at which it begins \[s\].
    pub from_s: f64,
    /// Duration including repetitions \[s\].
    pub duration_s: f64,
    /// Number of repetitions of its panels; the weights of their nodes include them.
    pub times: f64,
    /// Bounds of the nodes and of the curve between them.
    pub extent: Extent,
    /// Sums of the products of the signals.
    pub gram: Gram,
}

impl Block {
    const fn empty(place: BlockPanels) -> Self {
        Self { place, from_s: 0.0, duration_s: 0.0, times: 1.0, extent: Extent::NONE, gram: Gram([[0.0; 4]; 4]) }
    }

    /// Returns `true` if the nodes are computed from a recording each time they are read.
    #[inline]
    pub const fn is_recorded(&self) -> bool {
        matches!(self.place, BlockPanels::Recorded { .. })
    }

    /// Returns the index of the recording among the strips, if the block belongs to one.
    #[inline]
    #[must_use]
    pub const fn recording_index(&self) -> Option<usize> {
        match &self.place {
            BlockPanels::Recorded { strip, .. } => Some(*strip),
            BlockPanels::Kept(_) => None,
        }
    }

    #[inline]
    fn join(&mut self, other: &Self) {
        self.duration_s += other.duration_s;
        self.extent.join(&other.extent);
        self.gram.join(&other.gram);
    }

    fn add(&mut self, panel: &Panel<'_>) {
        self.duration_s += self.times * panel.duration_s;
        panel.nodes.iter().for_each(|node| self.gram.add(node));
        self.extent.join(&panel.extent().copied().unwrap_or_else(|| Extent::of(panel.nodes, &panel.bow)));
    }
}

/// A short cycle reduced to a few bounds of its signals and some instants.
#[derive(Clone, Debug, Default)]
pub struct Outline {
    /// Bounds of the signals, which together enclose the whole cycle.
    pub extents: Vec<Extent>,
    /// The signals at some instants.
    pub nodes: Vec<[f64; 4]>,
    /// Every signal is straight between the nodes.
    pub is_straight: bool,
}

/// Number of intervals between neighbouring nodes in one stretch of a panel.
const STRETCH: usize = 4;

/// Approximate number of nodes in a block.
const BLOCK: usize = 128;

/// Number of blocks that share one extent.
const GROUP: usize = 64;

/// Neighbouring blocks of recordings with common bounds.
#[derive(Clone, Debug)]
struct Group {
    blocks: Range<usize>,
    extent: Extent,
    /// Instant at which it begins \[s\].
    from: f64,
}

/// The motion under its load.
#[derive(Clone, Debug)]
pub struct Trace {
    nodes: Vec<Node>,
    panels: Vec<Kept>,
    strips: Vec<Strip>,
    blocks: Vec<Block>,
    groups: Vec<Group>,
    /// Search tree over the stored panels, built on first use.
    near: OnceLock<NeighbourTree>,
    /// The trace was derived from another one of the same recordings and uses its cells.
    is_changed: bool,
    runs: Vec<Run>,
    lags: Arc<LagCache>,
    /// Ends and lines of the panels of a short cycle with straight panels only.
    straight: Option<Straight>,
    /// Sum of the weights \[s\].
    duration: f64,
    gram: Gram,
    cubes: OnceLock<f64>,
    shares: Vec<Share>,
    /// Largest and smallest J_L in the cycle \[kgm²\].
    inertia: (f64, f64),
    /// Lowest and highest position \[rad\].
    span: (f64, f64),
    /// Lowest and highest position of each segment \[rad\].
    spans: Vec<Option<(f64, f64)>>,
    holding: f64,
}

impl Trace {
    /// Evaluates a motion under its load. `extras` holds the load added in each segment, `carried` the part of each
    /// rest during which the load is carried; a segment without an entry has no added load and is carried throughout.
    #[must_use]
    pub fn of(mechanism: &Mechanism, motion: &Motion, extras: &[Extra], carried: &[Carried]) -> Self {
        build::Builder::new(mechanism, motion, extras, carried).trace()
    }

    /// Evaluates another load or another pace of the same recordings. A recording is not evaluated again if the load is
    /// a sum of four parts with constant factors.
    #[must_use]
    pub fn changed(&self, mechanism: &Mechanism, motion: &Motion, extras: &[Extra], carried: &[Carried]) -> Self {
        let builder = build::Builder::new(mechanism, motion, extras, carried);
        Self { is_changed: true, ..builder.knowing(&self.strips, self.has_copies()).trace() }
    }

    /// Returns the number of samples of long recordings whose load must be computed again for another load, and for
    /// another pace: with losses, a stage, a position-dependent inertia, or a weight together with a constant torque.
    #[must_use]
    pub fn found_anew(&self) -> [usize; 2] {
        self.strips.iter().map(Strip::found_anew).fold([0; 2], |[load, pace], [a, b]| [load + a, pace + b])
    }

    /// Returns the number of samples of the long recordings and their cost; samples under a load that depends on the
    /// position or has losses count twice.
    #[must_use]
    pub fn samples(&self) -> [usize; 2] {
        let each = |strip: &Strip| [strip.intervals() + 1, strip.cost()];
        self.strips.iter().map(each).fold([0; 2], |[samples, cost], [a, b]| [samples + a, cost + b])
    }

    /// Writes the bounds and instants of a short cycle into `outline`; returns `false` if the cycle is not short.
    #[must_use]
    pub fn outline(&self, outline: &mut Outline) -> bool {
        outline.extents.clear();
        outline.nodes.clear();
        outline.is_straight = true;
        if !self.is_short() {
            return false;
        }
        for kept in self.panels.iter().filter(|kept| !kept.like.is_copy) {
            let panel = self.panel(kept);
            outline.is_straight &= panel.is_straight();
            let stretches = panel.stretches(STRETCH);
            let extents = if stretches.is_empty() { std::slice::from_ref(&kept.extent) } else { stretches };
            outline.extents.extend_from_slice(extents);
            outline.nodes.extend(panel.nodes.iter().step_by(STRETCH).chain(panel.nodes.last()).map(Node::signals));
        }
        true
    }

    /// Returns the sums of the products of the signals over the whole cycle.
    #[must_use]
    #[inline]
    pub const fn gram(&self) -> &Gram {
        &self.gram
    }

    /// Returns the contribution of each segment.
    #[must_use]
    pub fn shares(&self) -> &[Share] {
        &self.shares
    }

    /// Returns the largest and the smallest J_L in the cycle.
    #[must_use]
    pub fn inertia(&self) -> (MomentOfInertia, MomentOfInertia) {
        (MomentOfInertia::from_si(self.inertia.0), MomentOfInertia::from_si(self.inertia.1))
    }

    /// Returns the lowest and the highest position.
    #[must_use]
    pub fn span(&self) -> (Angle, Angle) {
        (Angle::from_si(self.span.0), Angle::from_si(self.span.1))
    }

    /// Returns the lowest and the highest position of the segments \[rad\], each with its index.
    pub fn spans(&self) -> impl Iterator<Item = (usize, (f64, f64))> + '_ {
        self.spans.iter().enumerate().filter_map(|(segment, span)| Some((segment, (*span)?)))
    }

    /// Returns the largest magnitude of the torque that holds the load without friction, by motor or brake.
    #[must_use]
    pub fn holding(&self) -> Torque {
        Torque::from_si(self.holding)
    }

    /// Visits the panels of a block in chronological order.
    pub fn panels(&self, block: &Block, look: &mut impl FnMut(Panel<'_>)) {
        match &block.place {
            BlockPanels::Kept(range) => {
                self.panels.get(range.clone()).unwrap_or_default().iter().for_each(|kept| look(self.panel(kept)));
            }
            BlockPanels::Recorded { strip, intervals } => {
                if let Some(strip) = self.strips.get(*strip) {
                    intervals.clone().for_each(|index| strip.interval(index, look));
                }
            }
        }
    }

    /// Visits the evaluated instants at which the axis is as fast as `speed_rad_s`, up to the difference of equally high values
    /// ([`numeric::EQUAL`]), or faster.
    pub fn as_fast_as(&self, speed_rad_s: f64, look: &mut impl FnMut(&Node)) {
        let least = speed_rad_s.abs() * (1.0 - numeric::EQUAL);
        for block in self.blocks.iter().filter(|block| block.extent.speed_rad_s >= least) {
            self.panels(block, &mut |panel| {
                panel.nodes.iter().filter(|node| node.speed_rad_s.abs() >= least).for_each(&mut *look);
            });
        }
    }

    /// Visits the panels of a block in chronological order, several straight intervals of a recording at a time.
    pub fn sweep(&self, block: &Block, look: &mut impl FnMut(Swept<'_>)) {
        match &block.place {
            BlockPanels::Recorded { strip, .. } => {
                if let Some(strip) = self.strips.get(*strip) {
                    strip.sweep(block, look);
                }
            }
            BlockPanels::Kept(_) => self.panels(block, &mut |panel| look(Swept::Panel(panel))),
        }
    }

    #[inline]
    fn panel<'a>(&'a self, kept: &'a Kept) -> Panel<'a> {
        kept.panel(&self.nodes)
    }

    /// Visits the nodes of a block in chronological order.
    #[cfg(test)]
    fn within(&self, block: &Block, look: &mut impl FnMut(&Node)) {
        self.panels(block, &mut |panel| panel.nodes.iter().for_each(&mut *look));
    }

    /// Returns the blocks in chronological order.
    #[must_use]
    #[inline]
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// Returns the recordings whose nodes are not stored.
    #[inline]
    pub fn strips(&self) -> &[Strip] {
        &self.strips
    }

    /// Returns the number of instants in the cycle, including the samples of recordings: the cost of one evaluation.
    #[must_use]
    pub fn instants(&self) -> usize {
        self.nodes.len() + self.strips.iter().map(Strip::intervals).sum::<usize>()
    }

    fn has_copies(&self) -> bool {
        self.panels.iter().any(|kept| kept.like.is_copy)
    }

    /// Returns `true` if the cycle has so few nodes that each can be evaluated for every candidate.
    #[inline]
    pub fn is_short(&self) -> bool {
        self.strips.is_empty() && self.nodes.len() <= 2 * BLOCK
    }

    #[cfg(test)]
    fn nodes(&self) -> Vec<Node> {
        let mut nodes = Vec::new();
        self.blocks.iter().for_each(|block| self.within(block, &mut |node| nodes.push(*node)));
        nodes
    }
}

#[cfg(test)]
#[path = "trace_tests.rs"]
mod tests;

#[cfg(test)]
#[path = "search_tests.rs"]
mod search_tests;

#[cfg(test)]
#[path = "lag_tests.rs"]
mod lag_tests;

#[cfg(test)]
#[path = "cells_tests.rs"]
mod cells_tests;
#[cfg(test)]
#[path = "recurring_tests.rs"]
mod recurring_tests;
