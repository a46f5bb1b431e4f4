//! Blocks of straight intervals: sums and bounds without nodes.

use super::{LANES, Strip, range};
use crate::{Block, BlockPanels, Extent, Gram, Panel};
use mechanism::Plain;
use motion::Interval;
use std::ops::Range;
use wide::f64x4;

impl Strip {
    pub(crate) fn block(&self, intervals: Range<usize>) -> Block {
        let place = BlockPanels::Recorded { strip: 0, intervals: intervals.clone() };
        let mut block = Block::empty(place.clone());
        block.from_s = self.surveyed.interval(intervals.start).map_or(0.0, |interval| interval.start_s);
        let mut from = intervals.start;
        while from < intervals.end {
            // Up to the first reversal, start or stop; at least one interval.
            let to = self.one_way(from, intervals.end).max(from + 1);
            let many = from + (to - from) / LANES * LANES;
            let sums = self.straight().filter(|_| many > from);
            if let Some(part) = sums.and_then(|plain| self.quick(plain, &place, from..many)) {
                block.join(&part);
                from = many;
            }
            let mut add = |panel: Panel<'_>| block.add(&panel);
            (from..to).for_each(|index| self.raw_interval(index, &mut add));
            from = to;
        }
        block
    }

    /// Returns the first interval from `from` on that is not passed in the direction of the interval `from`.
    pub(super) fn one_way(&self, from: usize, end: usize) -> usize {
        let speeds = self.placed.recorded.speed_rad_s().get(from..=end).unwrap_or_default();
        let Some(first) = speeds.first() else { return end };
        let other = if *first > 0.0 {
            speeds.iter().position(|speed| *speed <= 0.0)
        } else if *first < 0.0 {
            speeds.iter().position(|speed| *speed >= 0.0)
        } else {
            speeds.iter().position(|speed| *speed != 0.0)
        };
        // The interval before that sample ends in it.
        other.map_or(end, |sample| from + sample.saturating_sub(1))
    }

    /// Computes the block of a plain mechanism that has one direction or rests throughout, several intervals at a time.
    ///
    /// With α constant, ω and τ straight over an interval of length h the products of the four signals integrate to
    /// ∫α² = α Δω, ∫ω² = h (s² − ω_0 ω_1)/3, ∫ω = h s/2 with s = ω_0 + ω_1, and alike for τ; those of α with ω and with a
    /// constant add up to what lies between the ends of the block. R = τ + T_h mixes them.
    fn quick(&self, plain: &Plain, place: &BlockPanels, intervals: Range<usize>) -> Option<Block> {
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
        let [mut aa, mut ww, mut w, mut tt, mut ta, mut tw, mut t] = [f64x4::ZERO; 7];
        let [mut a_low, mut l_low] = [all(f64::INFINITY); 2];
        let [mut a_high, mut l_high] = [all(f64::NEG_INFINITY); 2];
        let mut from = 0;
        while from < intervals.len() {
            // LANES samples from one on, and the following ones.
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
            let h = next - at;
            let (dw, s, p) = (w1 - w0, w0 + w1, t0 + t1);
            let a = dw / h;
            aa += a * dw;
            ww += h * (s * s - w0 * w1);
            w += h * s;
            tt += h * (p * p - t0 * t1);
            ta += dw * p;
            tw += h * (s * p + t0 * w0 + t1 * w1);
            t += h * p;
            (a_low, a_high) = (a_low.fast_min(a), a_high.fast_max(a));
            (l_low, l_high) = (l_low.fast_min(t0).fast_min(t1), l_high.fast_max(t0).fast_max(t1));
            from += LANES;
        }
        let (a_low, a_high) = (range(a_low.as_array()).0, range(a_high.as_array()).1);
        let (l_low, l_high) = (range(l_low.as_array()).0, range(l_high.as_array()).1);
        let sum = |lanes: f64x4| lanes.as_array().iter().sum::<f64>();
        let duration = time.last()? - time.first()?;
        let (first, last) = (speed.first()?, speed.last()?);
        let sums = Sums {
            aa: sum(aa),
            ww: sum(ww) / 3.0,
            w: sum(w) / 2.0,
            tt: sum(tt) / 3.0,
            ta: sum(ta) / 2.0,
            tw: sum(tw) / 6.0,
            t: sum(t) / 2.0,
            a: last - first,
            aw: 0.5 * (last * last - first * first),
            duration,
        };
        Some(Block {
            place: place.clone(),
            times: 1.0,
            from_s: *time.first()?,
            duration_s: duration,
            extent: bounds(plain, direction, (a_low, a_high), (l_low, l_high), (slowest, fastest)),
            gram: sums.gram(plain, direction),
        })
    }
}

/// Integrals over straight intervals of one direction: products of α, ω and the recorded torque τ.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums {
    aa: f64,
    ww: f64,
    w: f64,
    tt: f64,
    ta: f64,
    tw: f64,
    t: f64,
    a: f64,
    aw: f64,
    duration: f64,
}

impl Sums {
    /// Adds an interval: ∫α² = α Δω, ∫ω² = h (s² − ω_0 ω_1)/3, ∫ω = h s/2 with s = ω_0 + ω_1, and likewise for τ.
    pub(super) fn add(&mut self, interval: &Interval) {
        let (h, [w0, w1], [t0, t1]) = (interval.duration_s, interval.speed_rad_s, interval.torque_nm);
        let (dw, s, p) = (w1 - w0, w0 + w1, t0 + t1);
        self.aa += dw / h * dw;
        self.ww += h * (s * s - w0 * w1) / 3.0;
        self.w += 0.5 * h * s;
        self.tt += h * (p * p - t0 * t1) / 3.0;
        self.ta += 0.5 * dw * p;
        self.tw += h * (s * p + t0 * w0 + t1 * w1) / 6.0;
        self.t += 0.5 * h * p;
        self.a += dw;
        self.aw += 0.5 * dw * s;
        self.duration += h;
    }

    /// Converts the products of the basis (α, τ, 1, ω) to those of (α, R, σ, ω), R = τ + T_h.
    pub(super) fn gram(&self, plain: &Plain, direction: f64) -> Gram {
        let Self { aa, ww, w, tt, ta, tw, t, a, aw, duration } = *self;
        let basis = Gram([[aa, ta, a, aw], [ta, tt, t, tw], [a, t, duration, w], [aw, tw, w, ww]]);
        let constant = plain.constant_nm;
        let rows = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, constant, 0.0], [0.0, 0.0, direction, 0.0], [0.0, 0.0, 0.0, 1.0]];
        Gram(rows.map(|a| rows.map(|b| basis.product(a, b))))
    }
}

/// Computes the bounds of straight intervals of one direction from those of α, τ and ω, widened because the nodes are
/// rounded differently from these bounds.
pub(super) fn bounds(
    plain: &Plain,
    direction: f64,
    acceleration: (f64, f64),
    torque: (f64, f64),
    speeds: (f64, f64),
) -> Extent {
    let wider = |(low, high): (f64, f64)| {
        let room = 8.0 * f64::EPSILON * f64::max(-low, high).abs();
        (low - room, high + room)
    };
    let load = (torque.0 + plain.constant_nm, torque.1 + plain.constant_nm);
    Extent {
        acceleration_rad_s2: wider(acceleration),
        load_nm: wider(load),
        direction: (direction, direction),
        speeds_rad_s: speeds,
        speed_rad_s: f64::max(speeds.1, -speeds.0),
    }
}
