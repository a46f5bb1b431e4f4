//! The motion under its load as weighted instants, once per axis; every candidate is judged on it.

mod build;
mod form;
mod lags;
mod recording;
mod rule;

pub(crate) use form::Form;
pub(crate) use lags::{Lag, Peak};

use mechanism::{Extra, Mechanism};
use motion::Motion;
use recording::Strip;
use std::ops::Range;
use std::sync::OnceLock;

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
    /// Largest |ω|.
    pub(crate) speed: f64,
}

impl Extent {
    const NONE: Self = Self {
        acceleration: (f64::INFINITY, f64::NEG_INFINITY),
        load: (f64::INFINITY, f64::NEG_INFINITY),
        direction: (f64::INFINITY, f64::NEG_INFINITY),
        speed: 0.0,
    };

    fn widen(&mut self, node: &Node) {
        let wider = |(low, high): (f64, f64), value: f64| (low.min(value), high.max(value));
        self.acceleration = wider(self.acceleration, node.acceleration);
        self.load = wider(self.load, node.load);
        self.direction = wider(self.direction, node.direction);
        self.speed = self.speed.max(node.speed.abs());
    }

    fn join(&mut self, other: &Self) {
        let both = |a: (f64, f64), b: (f64, f64)| (a.0.min(b.0), a.1.max(b.1));
        self.acceleration = both(self.acceleration, other.acceleration);
        self.load = both(self.load, other.load);
        self.direction = both(self.direction, other.direction);
        self.speed = self.speed.max(other.speed);
    }

    /// No |J α + T_L| of the nodes is above this.
    pub(crate) fn torque(&self, inertia: f64) -> f64 {
        let (low, high) = self.torques(inertia);
        high.max(-low)
    }

    /// All J α + T_L of the nodes lie between these.
    fn torques(&self, inertia: f64) -> (f64, f64) {
        (inertia * self.acceleration.0 + self.load.0, inertia * self.acceleration.1 + self.load.1)
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
}

/// A panel whose nodes are kept.
#[derive(Clone, Debug, PartialEq)]
struct Kept {
    nodes: Range<usize>,
    duration: f64,
}

/// Where the panels of a block are.
#[derive(Clone, Debug, PartialEq)]
enum Place {
    /// Kept, between two indices.
    Kept(Range<usize>),
    /// Made from the intervals of a recording whenever they are looked at.
    Recorded { strip: usize, intervals: Range<usize> },
}

/// Neighbouring nodes with their bounds and sums.
#[derive(Clone, Debug)]
pub(crate) struct Block {
    place: Place,
    pub(crate) duration: f64,
    pub(crate) extent: Extent,
    pub(crate) gram: Gram,
}

impl Block {
    const fn empty(place: Place) -> Self {
        Self { place, duration: 0.0, extent: Extent::NONE, gram: Gram([[0.0; 4]; 4]) }
    }

    fn join(&mut self, other: &Self) {
        self.duration += other.duration;
        self.extent.join(&other.extent);
        self.gram.join(&other.gram);
    }

    fn add(&mut self, node: &Node) {
        self.duration += node.weight;
        self.extent.widen(node);
        self.gram.add(node);
    }
}

/// A block holds about so many nodes.
const BLOCK: usize = 128;

/// So many blocks share one extent.
const GROUP: usize = 64;

/// A signal over the cycle as steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Step {
    pub(crate) duration: f64,
    pub(crate) value: f64,
}

/// The motion under its load.
#[derive(Clone, Debug)]
pub(crate) struct Trace {
    nodes: Vec<Node>,
    panels: Vec<Kept>,
    strips: Vec<Strip>,
    blocks: Vec<Block>,
    groups: Vec<Extent>,
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
        build::Builder::new(mechanism, motion, extras).trace()
    }

    /// The panels of a block in the order of time.
    pub(crate) fn panels(&self, block: &Block, look: &mut impl FnMut(Panel<'_>)) {
        match &block.place {
            Place::Kept(range) => {
                for kept in self.panels.get(range.clone()).unwrap_or_default() {
                    let nodes = self.nodes.get(kept.nodes.clone()).unwrap_or_default();
                    look(Panel { nodes, duration: kept.duration });
                }
            }
            Place::Recorded { strip, intervals } => {
                if let Some(strip) = self.strips.get(*strip) {
                    intervals.clone().for_each(|index| strip.interval(index, look));
                }
            }
        }
    }

    /// The nodes of a block in the order of time.
    pub(crate) fn within(&self, block: &Block, look: &mut impl FnMut(&Node)) {
        self.panels(block, &mut |panel| panel.nodes.iter().for_each(&mut *look));
    }

    /// ∫|T_L|³ |ω| dt; only gears with a rating ask for it.
    pub(crate) fn cubes(&self) -> f64 {
        *self.cubes.get_or_init(|| {
            let mut sum = 0.0;
            let mut look = |node: &Node| sum += node.weight * (node.load * node.load * node.load * node.speed).abs();
            self.blocks.iter().for_each(|block| self.within(block, &mut look));
            sum
        })
    }

    pub(crate) fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// Whether so few nodes make the cycle that each may be looked at for every candidate.
    pub(crate) fn is_short(&self) -> bool {
        self.strips.is_empty() && self.nodes.len() <= 2 * BLOCK
    }

    /// The largest value over the nodes and the first node that has it. `bound` is above every value of its block, so
    /// that a block whose bound is below what is found already is left out: exact, and near O(√blocks).
    pub(crate) fn largest(&self, bound: impl Fn(&Extent) -> f64, value: impl Fn(&Node) -> f64) -> (f64, Node) {
        let mut best = (f64::NEG_INFINITY, Node::default());
        self.search(bound, &mut best, |block, best| {
            self.within(block, &mut |node| {
                let here = value(node);
                if here > best.0 || (here == best.0 && node.time < best.1.time) {
                    *best = (here, *node);
                }
            });
        });
        best
    }

    /// The largest value between neighbouring nodes of different instants, `least` if none is above it; bounds as in
    /// [`Self::largest`]. `value` is told what is found so far and need not be exact below it.
    pub(crate) fn largest_between(
        &self,
        least: f64,
        bound: impl Fn(&Extent) -> f64,
        value: impl Fn(&Node, &Node, f64) -> f64,
    ) -> f64 {
        let mut best = (least, Node::default());
        self.search(bound, &mut best, |block, best| {
            let mut last: Option<Node> = None;
            self.within(block, &mut |node| {
                if let Some(last) = last.as_ref().filter(|last| node.time > last.time && last.direction != 0.0) {
                    best.0 = best.0.max(value(last, node, best.0));
                }
                last = Some(*node);
            });
        });
        best.0
    }

    /// Looks into the blocks whose bound is not below what is found so far, the most promising first.
    fn search(
        &self,
        bound: impl Fn(&Extent) -> f64,
        best: &mut (f64, Node),
        mut look: impl FnMut(&Block, &mut (f64, Node)),
    ) {
        let mut group = |index: usize, best: &mut (f64, Node)| {
            let blocks = self.blocks.chunks(GROUP).nth(index).unwrap_or_default();
            in_order(blocks, |block| bound(&block.extent), best, |block, _, best| look(block, best));
        };
        in_order(&self.groups, &bound, best, |_, index, best| group(index, best));
    }

    /// A signal over the cycle as steps: the mean over each block that is not longer than `longest`, of the others each
    /// node by itself. `whole` gives the integral over a block at once, where it can.
    pub(crate) fn steps(
        &self,
        longest: f64,
        whole: impl Fn(&Block) -> Option<f64>,
        value: impl Fn(&Node) -> f64,
    ) -> Vec<Step> {
        let mut steps = Vec::with_capacity(self.blocks.len());
        for block in &self.blocks {
            if block.duration > longest || self.is_short() {
                self.within(block, &mut |node| steps.push(Step { duration: node.weight, value: value(node) }));
                continue;
            }
            let integral = whole(block).unwrap_or_else(|| {
                let mut sum = 0.0;
                self.within(block, &mut |node| sum += node.weight * value(node));
                sum
            });
            if block.duration > 0.0 {
                steps.push(Step { duration: block.duration, value: integral / block.duration });
            }
        }
        steps
    }

    #[cfg(test)]
    pub(crate) fn nodes(&self) -> Vec<Node> {
        let mut nodes = Vec::new();
        self.blocks.iter().for_each(|block| self.within(block, &mut |node| nodes.push(*node)));
        nodes
    }
}

/// Visits what may hold something better than the best: the one with the largest bound, then the others in their order.
fn in_order<T>(
    items: &[T],
    bound: impl Fn(&T) -> f64,
    best: &mut (f64, Node),
    mut visit: impl FnMut(&T, usize, &mut (f64, Node)),
) {
    if let [only] = items {
        visit(only, 0, best);
        return;
    }
    let first = items.iter().enumerate().map(|(index, item)| (index, bound(item))).max_by(|a, b| a.1.total_cmp(&b.1));
    let Some((first, _)) = first else { return };
    if let Some(item) = items.get(first) {
        visit(item, first, best);
    }
    for (index, item) in items.iter().enumerate() {
        if index != first && bound(item) >= best.0 {
            visit(item, index, best);
        }
    }
}

#[cfg(test)]
#[path = "trace_tests.rs"]
mod tests;

#[cfg(test)]
#[path = "lag_tests.rs"]
mod lag_tests;
