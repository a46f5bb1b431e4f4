//! Power over straight intervals of a recording, four at a time: the result of [`CyclePower::gap`] for each, without
//! branches.

use super::{Bank, CyclePower};
use trace::Ramps;
use wide::f64x4;

/// Returns a value in all lanes.
const fn all(value: f64) -> f64x4 {
    f64x4::new([value; 4])
}

/// A signal that is linear over an interval: its values at the beginning and at the end.
type Line = [f64x4; 2];

/// A part of an interval, between two shares of it; an empty one ends at its beginning, or before.
type Part = [f64x4; 2];

/// Returns a f + b g.
#[inline]
fn sum((a, [f0, f1]): (f64x4, Line), (b, [g0, g1]): (f64x4, Line)) -> Line {
    [a * f0 + b * g0, a * f1 + b * g1]
}

/// Returns the part in which a line lies below zero: its length is the share of |f_0| + |f_1| that is below.
#[inline]
fn below([f0, f1]: Line) -> Part {
    let under = f0.fast_min(f64x4::ZERO) + f1.fast_min(f64x4::ZERO);
    let length = -under / (f0.abs() + f1.abs()).fast_max(all(f64::MIN_POSITIVE));
    let from = f0.simd_lt(f64x4::ZERO).select(f64x4::ZERO, f64x4::ONE - length);
    [from, from + length]
}

/// Returns the intersection of two parts.
#[inline]
fn common([a, b]: Part, [c, d]: Part) -> Part {
    [a.fast_max(c), b.fast_min(d)]
}

#[inline]
fn at([f0, f1]: Line, share: f64x4) -> f64x4 {
    f0 + (f1 - f0) * share
}

/// Returns ∫f g over a part of the interval, whose duration is one: the value at its middle plus the curvature of the
/// product.
#[inline]
fn product(f: Line, g: Line, [from, to]: Part) -> f64x4 {
    let (length, middle) = ((to - from).fast_max(f64x4::ZERO), (from + to) * all(0.5));
    let bend = (f[1] - f[0]) * (g[1] - g[0]);
    length * (at(f, middle) * at(g, middle) + bend * length * length * all(1.0 / 12.0))
}

/// Power summed over straight intervals.
///
/// P = I V with V = 1.5 R I + k_TM i ω: a product of two lines, so the parts of one sign end at their zeros. In the
/// direction of the motion, power is regenerated if the load drives, I is below zero and V above.
pub(super) struct Sweep {
    inertia: f64x4,
    /// Factor of the torque in the current while the load does not drive, and while it does [A/Nm].
    per_torque: [f64; 2],
    /// Factors of σ \[A\] and ω [As/rad] in the current.
    starting: f64,
    per_speed: f64,
    /// 1.5 R \[Ω\]
    copper: f64,
    /// k_TM i [Vs/rad]
    constant: f64,
}

/// Contribution of some intervals to a balance.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Added {
    /// ∫(P − P_0) dt with P_0 the power without a driving load \[J\].
    pub(super) beside: f64,
    /// −∫P dt where P < 0 \[J\]
    pub(super) back: f64,
    /// Largest −P, if requested \[W\].
    pub(super) peak: f64,
}

impl Sweep {
    pub(super) fn of(power: &CyclePower<'_>) -> Self {
        let [[_, driving, starting, per_speed], [_, driven, ..]] = [false, true].map(|driven| power.weights(driven));
        let (copper, constant) = power.constants();
        let inertia = all(power.currents.inertia);
        Self { inertia, per_torque: [driving, driven], starting, per_speed, copper, constant }
    }

    /// Evaluates some intervals. The largest regenerated power is computed on request; a bank receives the parts of
    /// each interval in their order.
    pub(super) fn pass(&self, ramps: &[Ramps], with_peak: bool, bank: Option<&mut Bank>) -> Added {
        match (bank, with_peak) {
            (None, false) => self.each::<false>(ramps, None),
            (bank, _) => self.each::<true>(ramps, bank),
        }
    }

    fn each<const PEAK: bool>(&self, ramps: &[Ramps], mut bank: Option<&mut Bank>) -> Added {
        let [mut beside, mut back, mut peak] = [f64x4::ZERO; 3];
        for four in ramps {
            let found = self.four::<PEAK>(four, bank.as_deref_mut());
            beside += found[0];
            back += found[1];
            peak = peak.fast_max(found[2]);
        }
        let peak = peak.to_array().into_iter().fold(0.0, f64::max);
        Added { beside: beside.reduce_add(), back: back.reduce_add(), peak }
    }

    /// Returns the contribution of four intervals.
    #[inline]
    fn four<const PEAK: bool>(&self, ramps: &Ramps, bank: Option<&mut Bank>) -> [f64x4; 3] {
        let duration = f64x4::new(ramps.duration_s);
        let own = self.inertia * f64x4::new(ramps.acceleration_rad_s2);
        // Torque, speed and current are taken in the direction of the motion; the power of two of them is the same.
        let sign = all(if ramps.direction < 0.0 { -1.0 } else { 1.0 });
        let torque = ramps.load_nm.map(|load| sign * (own + f64x4::new(load)));
        let speed = ramps.speed_rad_s.map(|speed| sign * f64x4::new(speed));
        let starting = self.starting * ramps.direction.abs();
        let friction = speed.map(|speed| all(self.per_speed) * speed + all(starting));
        let [driving, driven] = self.per_torque;
        let (r, k) = (self.copper, self.constant);
        let power = |factor: f64| {
            let current = sum((all(factor), torque), (f64x4::ONE, friction));
            (current, sum((all(r), current), (all(k), speed)))
        };
        // The load drives before the zero of the torque, behind it, in the whole interval or not at all; at rest it
        // does not.
        let braking = if ramps.direction == 0.0 { [f64x4::ONE; 2] } else { below(torque) };
        // With the factors a where it does and b elsewhere P − P_0 = (a − b) T (1.5 R ((a + b) T + 2 I_f) + k_TM i ω).
        let per_speed = all((driven - driving) * (2.0 * r * self.per_speed + k));
        let unchanging = all((driven - driving) * 2.0 * r * starting);
        let per_torque = all((driven - driving) * r * (driven + driving));
        let change = sum((per_torque, torque), (per_speed, speed)).map(|change| change + unchanging);
        let beside = duration * product(torque, change, braking);
        let (current, voltage) = power(driven);
        let returning = common(below(current), below(voltage.map(|voltage| -voltage)));
        let returning = common(returning, braking);
        let back = -duration * product(current, voltage, returning);
        let [from, to] = returning;
        let comes = to.simd_gt(from);
        let mut peak = f64x4::ZERO;
        if PEAK {
            // The vertex of P lies half-way between the zeros; a line has none, and its largest value is at an end.
            let root = |[f0, f1]: Line| f0 / (f0 - f1);
            let bends = ((current[1] - current[0]) * (voltage[1] - voltage[0])).simd_ne(f64x4::ZERO);
            let vertex = bends.select(all(0.5) * (root(current) + root(voltage)), from).fast_max(from).fast_min(to);
            let returned = |share: f64x4| -at(current, share) * at(voltage, share);
            let most = returned(from).fast_max(returned(to)).fast_max(returned(vertex));
            peak = comes.select(most, f64x4::ZERO);
        }
        if let Some(bank) = bank {
            let (current, voltage) = power(driving);
            let until = comes.select(from, f64x4::ONE);
            let begin = [f64x4::ZERO, until];
            let taken = |part: Part| product(current, voltage, part) + product(torque, change, common(part, braking));
            let parts = [taken(begin), taken([f64x4::ZERO, f64x4::ONE])].map(|taken| (duration * taken).to_array());
            let [before, whole] = parts;
            for ((before, whole), back) in before.into_iter().zip(whole).zip(back.to_array()) {
                bank.pass(before);
                bank.pass(-back);
                bank.pass(whole + back - before);
            }
        }
        [beside, back, peak]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const COPPER: f64 = 0.9;
    const CONSTANT: f64 = 14.0;
    const STARTING: f64 = 0.21;
    const PER_SPEED: f64 = 0.05;
    /// A driving load passes less torque on.
    const PER_TORQUE: [f64; 2] = [0.08, 0.05];
    const INERTIA: f64 = 0.3;

    fn sweep() -> Sweep {
        let [driving, driven] = PER_TORQUE;
        Sweep {
            inertia: all(INERTIA),
            per_torque: [driving, driven],
            starting: STARTING,
            per_speed: PER_SPEED,
            copper: COPPER,
            constant: CONSTANT,
        }
    }

    /// Evaluates the instants of an interval with the required resolution: ∫(P − P_0) dt, −∫P dt where P < 0, the
    /// largest −P.
    fn brute(ramps: &Ramps, lane: usize, steps: u32, bank: &mut Bank) -> [f64; 3] {
        let (sigma, h) = (ramps.direction, ramps.duration_s[lane]);
        let step = h / f64::from(steps);
        let mut found = [0.0; 3];
        for k in 0..steps {
            let u = (f64::from(k) + 0.5) / f64::from(steps);
            let along = |ends: [[f64; 4]; 2]| ends[0][lane] + u * (ends[1][lane] - ends[0][lane]);
            let (speed, load) = (along(ramps.speed_rad_s), along(ramps.load_nm));
            let torque = INERTIA * ramps.acceleration_rad_s2[lane] + load;
            let power = |per_torque: f64| {
                let current = per_torque * torque + STARTING * sigma + PER_SPEED * speed;
                (COPPER * current + CONSTANT * speed) * current
            };
            let [driving, driven] = PER_TORQUE.map(power);
            let power = if torque * sigma < 0.0 { driven } else { driving };
            found[0] += (power - driving) * step;
            found[1] -= power.min(0.0) * step;
            found[2] = f64::max(found[2], -power);
            bank.pass(power * step);
        }
        found
    }

    /// Compares every order of sign changes of torque and power within an interval, forwards, backwards and at rest.
    #[test]
    fn intervals_side_by_side_are_those_taken_apart() {
        let torques: [f64; 9] = [-60.0, -12.0, -3.0, -0.4, 0.0, 0.4, 3.0, 12.0, 60.0];
        let speeds: [[f64; 2]; 6] = [[0.0, 0.0], [0.0, 1.5], [1.2, 1.3], [4.0, 0.1], [-2.0, -0.5], [-0.3, -0.3]];
        let mut seen_back = 0;
        for ([w0, w1], a) in speeds.into_iter().flat_map(|speeds| torques.map(|a| (speeds, a))) {
            let sigma = if w0 + w1 == 0.0 { 0.0 } else { (w0 + w1).signum() };
            for four in torques.windows(4) {
                let acceleration = (w1 - w0) / 0.02;
                let ramps = Ramps {
                    duration_s: [0.02; 4],
                    acceleration_rad_s2: [acceleration; 4],
                    speed_rad_s: [[w0; 4], [w1; 4]],
                    load_nm: [[a; 4], four.try_into().unwrap()]
                        .map(|load| load.map(|load| load - INERTIA * acceleration)),
                    direction: sigma,
                };
                let (mut bank, mut expected_bank) = (Bank::default(), Bank::default());
                let added = sweep().pass(&[ramps], true, Some(&mut bank));
                assert_eq!(added, sweep().pass(&[ramps], true, None), "the bank changes nothing");
                let without = sweep().pass(&[ramps], false, None);
                assert_eq!(Added { peak: 0.0, ..added }, without, "nor does the largest power");
                let found = [added.beside, added.back, added.peak];
                let each = [0, 1, 2, 3].map(|lane| brute(&ramps, lane, 20_000, &mut expected_bank));
                let expected = each.into_iter().reduce(|[a, b, c], [d, e, f]| [a + d, b + e, c.max(f)]).unwrap();
                let what = format!("{a} to {four:?} Nm, {w0} to {w1} rad/s: {found:?} against {expected:?}");
                let scale = 1.0 + expected[0].abs() + expected[1] + expected_bank.most;
                assert!((found[0] - expected[0]).abs() < 1e-6 * scale, "{what}");
                assert!((found[1] - expected[1]).abs() < 1e-6 * scale, "{what}");
                assert!((found[2] - expected[2]).abs() < 1e-3 * (1.0 + expected[2]), "{what}");
                let (most, expected_most) = (bank.most, expected_bank.most);
                assert!((most - expected_most).abs() < 1e-5 * scale, "{what}: {most} J against {expected_most} J");
                seen_back += u32::from(expected[1] > 0.0);
            }
        }
        assert!(seen_back > 50, "{seen_back}: energy comes back in many of them");
    }
}
