//! A recording under its load: bounds and sums of its blocks in one pass; the nodes of a long one are made when they are
//! looked at.

use super::{Block, Extent, Gram, Kept, Node, Panel, Place};
use mechanism::{Extra, Mechanism, Output, Plain};
use motion::{Interval, Placed};
use quantities::{Measure, Torque};
use std::ops::Range;
use wide::f64x4;

/// From so many intervals two threads share the pass; the sums are those of one thread to the last bit.
const SHARED_FROM: usize = 1 << 16;

/// A block holds at most so many intervals of a recording.
pub(super) const INTERVALS: usize = 256;

/// And lasts about so long at most \[s\], unless that were less than [`INTERVALS_LEAST`]: short enough that the models of
/// heat may take it as a whole.
const BLOCK_S: f64 = 0.5;

/// So many intervals a block holds at least.
const INTERVALS_LEAST: usize = 16;

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

    /// The panels of an interval, one for each direction: both ends and the middle with the weights of Simpson's rule.
    pub(super) fn interval(&self, index: usize, look: &mut impl FnMut(Panel<'_>)) {
        let Some(interval) = self.placed.interval(index) else { return };
        let acceleration = interval.acceleration_rad_s2();
        for (from, to, direction) in parts(&interval) {
            let duration = (to - from) * interval.duration_s;
            let nodes = [(0.0, 1.0 / 6.0), (0.5, 4.0 / 6.0), (1.0, 1.0 / 6.0)].map(|(share, weight)| {
                let u = if share == 1.0 { to } else { from + share * (to - from) };
                let (position, speed, torque) = interval.at(u);
                let output =
                    Output { position_rad: position, speed_rad_s: speed, acceleration_rad_s2: acceleration, direction };
                Node {
                    time: interval.start_s + u * interval.duration_s,
                    weight: weight * duration,
                    acceleration,
                    speed,
                    direction,
                    load: self.load(&output, torque),
                }
            });
            look(Panel { nodes: &nodes, duration });
        }
    }

    pub(super) fn intervals(&self) -> usize {
        self.placed.intervals()
    }

    /// Makes the panels of a block once and for all.
    pub(super) fn keep(&self, block: &mut Block, nodes: &mut Vec<Node>, panels: &mut Vec<Kept>) {
        if let Place::Recorded { intervals, .. } = &block.place {
            let from = panels.len();
            for index in intervals.clone() {
                self.interval(index, &mut |panel| {
                    let first = nodes.len();
                    nodes.extend_from_slice(panel.nodes);
                    panels.push(Kept { nodes: first..nodes.len(), duration: panel.duration });
                });
            }
            block.place = Place::Kept(from..panels.len());
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

    /// So many intervals make a block.
    pub(super) fn block_intervals(&self) -> usize {
        let time = self.placed.recorded.time_s();
        let whole = time.last().zip(time.first()).map_or(0.0, |(last, first)| last - first) * self.placed.stretch;
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            clippy::cast_precision_loss,
            reason = "a count; what is out of range is clamped"
        )]
        let fitting = (BLOCK_S / whole * self.placed.intervals() as f64) as usize;
        fitting.clamp(INTERVALS_LEAST, INTERVALS) / LANES * LANES
    }

    /// One pass over all samples.
    pub(super) fn survey(&self, own: usize) -> Survey {
        let (intervals, most) = (self.placed.intervals(), self.block_intervals());
        let ranges: Vec<Range<usize>> =
            (0..intervals).step_by(most).map(|from| from..(from + most).min(intervals)).collect();
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
        let (low, high) = range(positions);
        let span = (low + self.placed.offset_rad, high + self.placed.offset_rad);
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
        let place = Place::Recorded { strip, intervals: intervals.clone() };
        let mut block = Block::empty(place.clone());
        let mut from = intervals.start;
        while from < intervals.end {
            // Up to where the axis turns round, starts or stops; one interval at least.
            let to = self.one_way(from, intervals.end).max(from + 1);
            let many = from + (to - from) / LANES * LANES;
            let sums = self.plain.as_ref().filter(|_| many > from);
            if let Some(part) = sums.and_then(|plain| self.quick(plain, &place, from..many)) {
                block.join(&part);
                from = many;
            }
            let mut add = |panel: Panel<'_>| panel.nodes.iter().for_each(|node| block.add(node));
            (from..to).for_each(|index| self.interval(index, &mut add));
            from = to;
        }
        block
    }

    /// The first interval from one on that is not run through in the direction in which that one begins.
    fn one_way(&self, from: usize, end: usize) -> usize {
        let speeds = self.placed.recorded.speed_rad_s().get(from..=end).unwrap_or_default();
        let Some(first) = speeds.first() else { return end };
        let other = if *first > 0.0 {
            speeds.iter().position(|speed| *speed <= 0.0)
        } else if *first < 0.0 {
            speeds.iter().position(|speed| *speed >= 0.0)
        } else {
            speeds.iter().position(|speed| *speed != 0.0)
        };
        // The interval before that sample has it as its end.
        other.map_or(end, |sample| from + sample.saturating_sub(1))
    }

    /// The block of a plain mechanism that turns one way all through it, or rests, several intervals at a time.
    ///
    /// With α constant, ω and τ straight over an interval of length h the products of the four signals integrate to
    /// ∫α² = α Δω, ∫ω² = h (s² − ω_0 ω_1)/3, ∫ω = h s/2 with s = ω_0 + ω_1, and alike for τ; those of α with ω and with a
    /// constant add up to what lies between the ends of the block. T_L = J α + c + τ + b ω mixes them.
    fn quick(&self, plain: &Plain, place: &Place, intervals: Range<usize>) -> Option<Block> {
        let recorded = &*self.placed.recorded;
        let samples = intervals.start..intervals.end + 1;
        let time = recorded.time_s().get(samples.clone())?;
        let speed = recorded.speed_rad_s().get(samples.clone())?;
        let torque = recorded.torque_nm().and_then(|torque| torque.get(samples));
        if !intervals.len().is_multiple_of(LANES) {
            return None;
        }
        let (slowest, fastest) = range(speed);
        let direction = if slowest > 0.0 {
            1.0
        } else if fastest < 0.0 {
            -1.0
        } else if slowest == 0.0 && fastest == 0.0 {
            0.0
        } else {
            return None;
        };
        let all = f64x4::splat;
        let (stretch, slow) = (all(self.placed.stretch), all(1.0 / self.placed.stretch));
        let (inertia, viscous) = (all(plain.inertia_kgm2), all(plain.viscous_nms));
        let [mut aa, mut ww, mut w, mut tt, mut ta, mut tw, mut t] = [f64x4::ZERO; 7];
        let [mut a_low, mut l_low] = [all(f64::INFINITY); 2];
        let [mut a_high, mut l_high] = [all(f64::NEG_INFINITY); 2];
        let mut from = 0;
        while from < intervals.len() {
            // LANES samples from one on, and the next ones.
            let ends = |values: &[f64]| -> Option<(f64x4, f64x4)> {
                let first: [f64; LANES] = values.get(from..from + LANES)?.try_into().ok()?;
                let next: [f64; LANES] = values.get(from + 1..=from + LANES)?.try_into().ok()?;
                Some((f64x4::new(first), f64x4::new(next)))
            };
            let ((at, next), (w0, w1)) = (ends(time)?, ends(speed)?);
            let (t0, t1) = match torque {
                Some(torque) => ends(torque)?,
                None => (f64x4::ZERO, f64x4::ZERO),
            };
            let (h, w0, w1) = ((next - at) * stretch, w0 * slow, w1 * slow);
            let (dw, s, p) = (w1 - w0, w0 + w1, t0 + t1);
            let a = dw / h;
            aa += a * dw;
            ww += h * (s * s - w0 * w1);
            w += h * s;
            tt += h * (p * p - t0 * t1);
            ta += dw * p;
            tw += h * (s * p + t0 * w0 + t1 * w1);
            t += h * p;
            let inert = inertia * a;
            let (l0, l1) = (inert + t0 + viscous * w0, inert + t1 + viscous * w1);
            (a_low, a_high) = (a_low.fast_min(a), a_high.fast_max(a));
            (l_low, l_high) = (l_low.fast_min(l0).fast_min(l1), l_high.fast_max(l0).fast_max(l1));
            from += LANES;
        }
        let (stretch, slow) = (self.placed.stretch, 1.0 / self.placed.stretch);
        let (a_low, a_high) = (range(a_low.as_array()).0, range(a_high.as_array()).1);
        let (l_low, l_high) = (range(l_low.as_array()).0, range(l_high.as_array()).1);
        let sum = |lanes: f64x4| lanes.as_array().iter().sum::<f64>();
        let duration = (time.last()? - time.first()?) * stretch;
        let (first, last) = (speed.first()? * slow, speed.last()? * slow);
        let constant = plain.constant_nm + plain.coulomb_nm * direction;
        // The basis (α, τ, 1, ω); σ is constant here.
        let (aa, ww, w) = (sum(aa), sum(ww) / 3.0, sum(w) / 2.0);
        let (tt, ta, tw, t) = (sum(tt) / 3.0, sum(ta) / 2.0, sum(tw) / 6.0, sum(t) / 2.0);
        let (a1, aw) = (last - first, 0.5 * (last * last - first * first));
        let basis = [[aa, ta, a1, aw], [ta, tt, t, tw], [a1, t, duration, w], [aw, tw, w, ww]];
        let rows = [
            [1.0, 0.0, 0.0, 0.0],
            [plain.inertia_kgm2, 1.0, constant, plain.viscous_nms],
            [0.0, 0.0, direction, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ];
        let basis = Gram(basis);
        // The nodes are rounded otherwise than the sums here; the bounds must hold for them too.
        let wider = |(low, high): (f64, f64)| {
            let room = 8.0 * f64::EPSILON * f64::max(-low, high).abs();
            (low - room, high + room)
        };
        let (l_low, l_high) = (l_low + constant, l_high + constant);
        Some(Block {
            place: place.clone(),
            duration,
            extent: Extent {
                acceleration: wider((a_low, a_high)),
                load: wider((l_low, l_high)),
                direction: (direction, direction),
                speed: fastest.max(-slowest) * slow,
            },
            gram: Gram(rows.map(|a| rows.map(|b| basis.product(a, b)))),
        })
    }
}

/// So many intervals run side by side.
const LANES: usize = 4;

/// Smallest and largest value.
fn range(values: &[f64]) -> (f64, f64) {
    let (mut low, mut high) = ([f64::INFINITY; LANES], [f64::NEG_INFINITY; LANES]);
    let (lanes, rest) = values.as_chunks::<LANES>();
    for lane in lanes {
        for ((low, high), value) in low.iter_mut().zip(&mut high).zip(lane) {
            *low = if *value < *low { *value } else { *low };
            *high = if *value > *high { *value } else { *high };
        }
    }
    let all = low.iter().chain(&high).chain(rest).copied().filter(|value| value.is_finite());
    all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
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
