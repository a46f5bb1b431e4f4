//! The motion under its load as weighted instants, once per axis; every candidate is judged on it.

pub(crate) mod build;
mod cubes;
mod form;
mod gains;
mod lags;
mod recording;
mod rule;
mod search;

pub(crate) use form::Form;
pub(crate) use lags::Lag;
pub(crate) use recording::{Cell, Inside, Strip};
pub(crate) use search::{Any, Convex, Sought, TorqueWith};

use lags::LagCache;
use mechanism::{Extra, Mechanism};
use motion::Motion;
use std::ops::Range;
use std::sync::{Arc, OnceLock};

/// One instant with its share of the cycle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Node {
    /// Instant from the start of the cycle \[s\].
    pub(crate) time: f64,
    /// Weight of the quadrature \[s\]; the weights sum to the duration.
    pub(crate) weight: f64,
    /// α [rad/s²]
    pub(crate) acceleration: f64,
    /// ω [rad/s]
    pub(crate) speed: f64,
    /// σ: +1, −1, 0 at rest.
    pub(crate) direction: f64,
    /// Torque that the load asks of the actuator, without the actuator's own inertia \[Nm\]; zero where the brake holds.
    pub(crate) load: f64,
}

impl Node {
    /// x = (α, T_L, σ, ω)
    pub(crate) const fn signals(&self) -> [f64; 4] {
        [self.acceleration, self.load, self.direction, self.speed]
    }

    /// The instant at a share of the way to the next one, everything taken as straight in between.
    pub(crate) fn towards(&self, next: &Self, share: f64) -> Self {
        let between = |a: f64, b: f64| a + share * (b - a);
        Self {
            time: between(self.time, next.time),
            weight: 0.0,
            acceleration: between(self.acceleration, next.acceleration),
            speed: between(self.speed, next.speed),
            direction: self.direction,
            load: between(self.load, next.load),
        }
    }
}

/// Bounds of some nodes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    pub(crate) acceleration: (f64, f64),
    pub(crate) load: (f64, f64),
    pub(crate) direction: (f64, f64),
    /// ω
    pub(crate) speeds: (f64, f64),
    /// Largest |ω|.
    pub(crate) speed: f64,
}

impl Extent {
    const NONE: Self = Self {
        acceleration: (f64::INFINITY, f64::NEG_INFINITY),
        load: (f64::INFINITY, f64::NEG_INFINITY),
        direction: (f64::INFINITY, f64::NEG_INFINITY),
        speeds: (f64::INFINITY, f64::NEG_INFINITY),
        speed: 0.0,
    };

    fn widen(&mut self, node: &Node) {
        let wider = |(low, high): (f64, f64), value: f64| (low.min(value), high.max(value));
        self.acceleration = wider(self.acceleration, node.acceleration);
        self.load = wider(self.load, node.load);
        self.direction = wider(self.direction, node.direction);
        self.speeds = wider(self.speeds, node.speed);
        self.speed = self.speed.max(node.speed.abs());
    }

    /// Of what lies between two neighbouring nodes of a panel.
    fn between(a: &Node, b: &Node, bow: &[f64; 4]) -> Self {
        let mut extent = Self::NONE;
        extent.widen(a);
        extent.widen(b);
        extent.bend(bow);
        extent
    }

    /// Wider by how far the signals bend beyond their nodes.
    fn bend(&mut self, [acceleration, load, _, speed]: &[f64; 4]) {
        for ((low, high), bow) in
            [(&mut self.acceleration, acceleration), (&mut self.load, load), (&mut self.speeds, speed)]
                .map(|((low, high), bow)| ((low, high), bow))
        {
            *low -= bow;
            *high += bow;
        }
        self.speed += speed;
    }

    fn join(&mut self, other: &Self) {
        let both = |a: (f64, f64), b: (f64, f64)| (a.0.min(b.0), a.1.max(b.1));
        self.acceleration = both(self.acceleration, other.acceleration);
        self.load = both(self.load, other.load);
        self.direction = both(self.direction, other.direction);
        self.speeds = both(self.speeds, other.speeds);
        self.speed = self.speed.max(other.speed);
    }

    /// All c·x lie between these.
    pub(crate) fn range(&self, c: [f64; 4]) -> (f64, f64) {
        let ranges = [self.acceleration, self.load, self.direction, self.speeds];
        c.into_iter().zip(ranges).fold((0.0, 0.0), |(low, high), (c, (from, to))| {
            (low + (c * from).min(c * to), high + (c * from).max(c * to))
        })
    }

    /// No |J α + T_L| of the nodes is above this.
    pub(crate) fn torque(&self, inertia: f64) -> f64 {
        let (low, high) = self.torques(inertia);
        high.max(-low)
    }

    /// All J α + T_L of the nodes lie between these.
    fn torques(&self, inertia: f64) -> (f64, f64) {
        // A joint that takes T_L − J α asks with a negative inertia.
        let (a, b) = (inertia * self.acceleration.0, inertia * self.acceleration.1);
        (a.min(b) + self.load.0, a.max(b) + self.load.1)
    }

    /// Whether (J α + T_L) σ has one sign over all nodes: +1 if nowhere negative, −1 if nowhere positive.
    pub(crate) fn power_sign(&self, inertia: f64) -> Option<f64> {
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

/// The load in the direction of the motion: sums of products of (α, T_L, σ, ω) over a time.
///
/// G_ij = ∫ x_i x_j dt with x = (α, T_L, σ, ω). Any signal that is a weighted sum s = Σ c_i x_i, such as torque and
/// current, has ∫s² dt = cᵀ G c: one pass over the motion, then ten products per candidate.
///
/// # Source   own derivation, docs/theory/moments.md
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Gram([[f64; 4]; 4]);

impl Gram {
    fn add(&mut self, node: &Node) {
        let x = node.signals();
        for (row, a) in self.0.iter_mut().zip(x) {
            let scaled = a * node.weight;
            for (sum, b) in row.iter_mut().zip(x) {
                *sum += scaled * b;
            }
        }
    }

    fn join(&mut self, other: &Self) {
        for (row, others) in self.0.iter_mut().zip(&other.0) {
            for (sum, other) in row.iter_mut().zip(others) {
                *sum += other;
            }
        }
    }

    /// cᵀ G c
    pub(crate) fn square(&self, c: [f64; 4]) -> f64 {
        // Rounding may leave a tiny negative sum where the signal vanishes.
        self.product(c, c).max(0.0)
    }

    /// aᵀ G b
    pub(crate) fn product(&self, a: [f64; 4], b: [f64; 4]) -> f64 {
        self.0.iter().zip(a).map(|(row, a)| a * row.iter().zip(b).map(|(g, b)| g * b).sum::<f64>()).sum()
    }

    /// ∫σ² dt: time in motion.
    pub(crate) const fn moving(&self) -> f64 {
        self.0[2][2]
    }

    /// ∫σ ω dt = ∫|ω| dt: angle travelled.
    pub(crate) const fn travelled(&self) -> f64 {
        self.0[2][3]
    }
}

/// What one segment contributes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Share {
    /// ∫|ω| dt \[rad\]
    pub(crate) travelled: f64,
}

/// A smooth part of the cycle: between its nodes every signal is the polynomial through them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Panel<'a> {
    /// The nodes of a Gauss-Lobatto rule, two to sixteen.
    pub(crate) nodes: &'a [Node],
    /// Duration \[s\].
    pub(crate) duration: f64,
    /// Between two neighbouring nodes no signal leaves the straight line by more than this.
    pub(crate) bow: [f64; 4],
}

impl Panel<'_> {
    /// The instant at a share of the panel.
    pub(crate) fn at(&self, share: f64) -> Node {
        rule::between(self.nodes, share)
    }

    /// Whether every signal is straight.
    pub(crate) fn is_straight(&self) -> bool {
        self.bow == [0.0; 4]
    }
}

/// A panel whose nodes are kept.
#[derive(Clone, Debug, PartialEq)]
struct Kept {
    nodes: Range<usize>,
    duration: f64,
    bow: [f64; 4],
}

/// Where the panels of a block are.
#[derive(Clone, Debug, PartialEq)]
enum Place {
    /// Kept, between two indices.
    Kept(Range<usize>),
    /// Made from the intervals of a recording whenever they are looked at.
    Recorded { strip: usize, intervals: Range<usize> },
}

/// Panels or blocks in the order of time.
#[derive(Clone, Debug, PartialEq)]
enum Run {
    /// Kept panels between two indices.
    Kept(Range<usize>),
    /// Kept panels that follow upon each other several times: the revolutions at constant speed.
    Repeated(Range<usize>, f64),
    /// All blocks of a strip.
    Recorded(usize),
}

/// Neighbouring nodes with their bounds and sums.
#[derive(Clone, Debug)]
pub(crate) struct Block {
    place: Place,
    /// Instant at which it begins \[s\].
    pub(crate) from: f64,
    pub(crate) duration: f64,
    /// How often its panels follow upon each other; their nodes bear the weight of all.
    pub(crate) times: f64,
    pub(crate) extent: Extent,
    pub(crate) gram: Gram,
}

impl Block {
    const fn empty(place: Place) -> Self {
        Self { place, from: 0.0, duration: 0.0, times: 1.0, extent: Extent::NONE, gram: Gram([[0.0; 4]; 4]) }
    }

    /// Whether its nodes are made from a recording whenever they are looked at.
    pub(crate) const fn is_recorded(&self) -> bool {
        matches!(self.place, Place::Recorded { .. })
    }

    fn join(&mut self, other: &Self) {
        self.duration += other.duration;
        self.extent.join(&other.extent);
        self.gram.join(&other.gram);
    }

    fn add(&mut self, panel: &Panel<'_>) {
        self.duration += self.times * panel.duration;
        let mut extent = Extent::NONE;
        for node in panel.nodes {
            extent.widen(node);
            self.gram.add(node);
        }
        extent.bend(&panel.bow);
        self.extent.join(&extent);
    }
}

/// A block holds about so many nodes.
const BLOCK: usize = 128;

/// So many blocks share one extent.
const GROUP: usize = 64;

/// Neighbouring blocks with what bounds them all.
#[derive(Clone, Debug)]
struct Group {
    blocks: Range<usize>,
    extent: Extent,
    /// Instant at which it begins \[s\].
    from: f64,
    /// Whether its blocks are those of a recording.
    recorded: bool,
}

/// The motion under its load.
#[derive(Clone, Debug)]
pub(crate) struct Trace {
    nodes: Vec<Node>,
    panels: Vec<Kept>,
    strips: Vec<Strip>,
    blocks: Vec<Block>,
    groups: Vec<Group>,
    /// Whether it is made from another one of the same recordings, whose cells serve it.
    is_changed: bool,
    runs: Vec<Run>,
    lags: Arc<LagCache>,
    /// Sum of the weights \[s\].
    duration: f64,
    pub(crate) gram: Gram,
    cubes: OnceLock<f64>,
    pub(crate) shares: Vec<Share>,
    /// Largest and smallest J_L on the way \[kgm²\].
    pub(crate) inertia: (f64, f64),
    /// Lowest and highest position \[rad\].
    pub(crate) span: (f64, f64),
    /// Largest magnitude of the torque that holds the load without friction at any instant \[Nm\], whoever holds it.
    pub(crate) holding: f64,
}

impl Trace {
    pub(crate) fn of(mechanism: &Mechanism, motion: &Motion, extras: &[Extra]) -> Self {
        build::Builder::new(mechanism, motion, extras, &[]).trace()
    }

    /// The same for another load or another pace of the same recordings, which need not be passed again where the load
    /// is a sum of four parts with constant factors.
    pub(crate) fn changed(&self, mechanism: &Mechanism, motion: &Motion, extras: &[Extra]) -> Self {
        Self { is_changed: true, ..build::Builder::new(mechanism, motion, extras, &self.strips).trace() }
    }

    /// The panels of a block in the order of time.
    pub(crate) fn panels(&self, block: &Block, look: &mut impl FnMut(Panel<'_>)) {
        match &block.place {
            Place::Kept(range) => {
                self.panels.get(range.clone()).unwrap_or_default().iter().for_each(|kept| look(self.panel(kept)));
            }
            Place::Recorded { strip, intervals } => {
                if let Some(strip) = self.strips.get(*strip) {
                    intervals.clone().for_each(|index| strip.interval(index, look));
                }
            }
        }
    }

    fn panel(&self, kept: &Kept) -> Panel<'_> {
        let nodes = self.nodes.get(kept.nodes.clone()).unwrap_or_default();
        Panel { nodes, duration: kept.duration, bow: kept.bow }
    }

    /// The nodes of a block in the order of time.
    #[cfg(test)]
    pub(crate) fn within(&self, block: &Block, look: &mut impl FnMut(&Node)) {
        self.panels(block, &mut |panel| panel.nodes.iter().for_each(&mut *look));
    }

    pub(crate) fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// The recordings whose nodes are not kept.
    pub(crate) fn strips(&self) -> &[Strip] {
        &self.strips
    }

    /// Whether so few nodes make the cycle that each may be looked at for every candidate.
    pub(crate) fn is_short(&self) -> bool {
        self.strips.is_empty() && self.nodes.len() <= 2 * BLOCK
    }

    #[cfg(test)]
    pub(crate) fn nodes(&self) -> Vec<Node> {
        let mut nodes = Vec::new();
        self.blocks.iter().for_each(|block| self.within(block, &mut |node| nodes.push(*node)));
        nodes
    }
}

#[cfg(test)]
#[path = "trace_tests.rs"]
mod tests;

#[cfg(test)]
#[path = "lag_tests.rs"]
mod lag_tests;

#[cfg(test)]
#[path = "cells_tests.rs"]
mod cells_tests;
