//! A recording under its load: bounds and sums of its blocks in one pass, its nodes made when they are looked at.

use super::{BLOCK, Block, Node, Place};
use mechanism::{Extra, Mechanism, Output, Plain};
use motion::{Interval, Placed};
use quantities::{Measure, Torque};
use std::ops::Range;

/// From so many intervals two threads share the pass; the sums are those of one thread to the last bit.
const SHARED_FROM: usize = 1 << 16;

/// A recording with what it moves.
#[derive(Clone, Debug)]
pub(super) struct Strip {
    placed: Placed,
    mechanism: Mechanism,
    extra: Extra,
    plain: Option<Plain>,
}

/// What one pass over a recording finds.
pub(super) struct Survey {
    pub(super) blocks: Vec<Block>,
    /// Smallest and largest J_L \[kgm²\].
    pub(super) inertia: (f64, f64),
    /// Lowest and highest position \[rad\].
    pub(super) span: (f64, f64),
    /// Largest magnitude of the holding torque \[Nm\].
    pub(super) holding: f64,
}

/// A part of an interval in which the direction does not change, from one share of it to another.
type Part = (f64, f64, f64);

impl Strip {
    pub(super) fn new(placed: Placed, mechanism: Mechanism, extra: Extra) -> Self {
        let plain = mechanism.plain(&extra);
        Self { placed, mechanism, extra, plain }
    }

    /// The nodes of an interval: both ends and the middle with the weights of Simpson's rule, once for each direction.
    pub(super) fn interval(&self, index: usize, look: &mut impl FnMut(&Node)) {
        let Some(interval) = self.placed.interval(index) else { return };
        let acceleration = interval.acceleration_rad_s2();
        for (from, to, direction) in parts(&interval) {
            for (share, weight) in [(0.0, 1.0 / 6.0), (0.5, 4.0 / 6.0), (1.0, 1.0 / 6.0)] {
                let u = if share == 1.0 { to } else { from + share * (to - from) };
                let (position, speed, torque) = interval.at(u);
                let output =
                    Output { position_rad: position, speed_rad_s: speed, acceleration_rad_s2: acceleration, direction };
                look(&Node {
                    time: interval.start_s + u * interval.duration_s,
                    weight: weight * (to - from) * interval.duration_s,
                    acceleration,
                    speed,
                    direction,
                    load: self.load(&output, torque),
                });
            }
        }
    }

    /// Torque of the mechanism and the recorded one.
    fn load(&self, output: &Output, recorded: f64) -> f64 {
        match &self.plain {
            Some(plain) => {
                plain.inertia_kgm2 * output.acceleration_rad_s2
                    + plain.constant_nm
                    + recorded
                    + plain.coulomb_nm * output.direction
                    + plain.viscous_nms * output.speed_rad_s
            }
            None => {
                let extra = Extra { torque: self.extra.torque + Torque::from_si(recorded), ..self.extra };
                self.mechanism.torque(output, &extra)
            }
        }
    }

    /// One pass over all samples.
    pub(super) fn survey(&self, own: usize) -> Survey {
        let intervals = self.placed.intervals();
        let ranges: Vec<Range<usize>> =
            (0..intervals).step_by(BLOCK).map(|from| from..(from + BLOCK).min(intervals)).collect();
        let work = |ranges: &[Range<usize>]| -> Vec<Block> {
            ranges.iter().map(|range| self.block(own, range.clone())).collect()
        };
        let blocks = if intervals >= SHARED_FROM {
            let (first, second) = ranges.split_at(ranges.len() / 2);
            std::thread::scope(|scope| {
                let other = scope.spawn(|| work(second));
                let mut blocks = work(first);
                // A thread that could not finish leaves its part to this one.
                blocks.extend(other.join().unwrap_or_else(|_| work(second)));
                blocks
            })
        } else {
            work(&ranges)
        };
        let wider = |(low, high): (f64, f64), value: f64| (low.min(value), high.max(value));
        let none = (f64::INFINITY, f64::NEG_INFINITY);
        let positions = self.placed.recorded.position_rad();
        let span = positions.iter().fold(none, |span, q| wider(span, q + self.placed.offset_rad));
        let at = |q: f64| {
            let inertia = self.mechanism.inertia(q, &self.extra).si();
            (inertia, self.mechanism.holding_torque(q, &self.extra).si())
        };
        let (mut inertia, mut holding) = (none, 0.0_f64);
        let mut see = |q: f64| {
            let (here, held) = at(q);
            inertia = wider(inertia, here);
            holding = holding.max(held.abs());
        };
        if self.mechanism.depends_on_position() {
            positions.iter().for_each(|q| see(q + self.placed.offset_rad));
        } else {
            see(0.0);
        }
        Survey { blocks, inertia, span, holding }
    }

    pub(super) fn block(&self, strip: usize, intervals: Range<usize>) -> Block {
        let mut block = Block::empty(Place::Recorded { strip, intervals: intervals.clone() });
        intervals.for_each(|index| self.interval(index, &mut |node| block.add(node)));
        block
    }
}

/// The parts of an interval in each of which the speed keeps its sign; the zero of a straight speed between them.
fn parts(interval: &Interval) -> impl Iterator<Item = Part> {
    let [first, last] = interval.speed_rad_s;
    let zero = if first * last < 0.0 { first / (first - last) } else { 1.0 };
    let sign = |speed: f64| if speed == 0.0 { 0.0 } else { speed.signum() };
    let before = (0.0, zero, sign(if first == 0.0 { last } else { first }));
    let after = (zero < 1.0).then_some((zero, 1.0, sign(last)));
    [Some(before), after].into_iter().flatten()
}
