//! Power over straight intervals of a recording, several side by side: what [`CyclePower::gap`] finds of one, without a
//! branch.

use super::{Bank, CyclePower};
use trace::Ramps;
use wide::f64x4;

/// The same in all lanes.
const fn all(value: f64) -> f64x4 {
    f64x4::new([value; 4])
}

/// A power that is summed up over straight intervals.
pub(super) struct Sweep {
    inertia: f64x4,
    /// Factor of the torque in the current while the load drives, and while it is driven [A/Nm].
    per_torque: [f64x4; 2],
    /// Factors of σ \[A\] and ω [As/rad] in the current.
    starting: f64,
    per_speed: f64x4,
    /// 1.5 R \[Ω\]
    copper: f64x4,
    /// k_TM i [Vs/rad]
    constant: f64x4,
    /// ∫P dt and −∫P dt where P < 0 \[J\]
    whole: f64x4,
    back: f64x4,
    /// Largest −P \[W\]
    peak: f64x4,
}

/// A straight interval of the output: torque with that of the own inertia, and speed, at its beginning and their increase.
#[derive(Clone, Copy)]
struct Line {
    duration: f64x4,
    torque: [f64x4; 2],
    speed: [f64x4; 2],
    /// σ I_s \[A\]
    starting: f64x4,
}

/// The parabola of the power over a part of it: P(u) = p_0 + p_1 u + p_2 u², u from 0 to 1.
struct Arcs {
    duration: f64x4,
    power: [f64x4; 3],
}

impl Arcs {
    /// ∫P dt from the beginning to u \[J\]
    fn energy(&self, u: f64x4) -> f64x4 {
        let [p0, p1, p2] = self.power;
        self.duration * u * (p0 + u * (p1 * all(0.5) + u * p2 * all(1.0 / 3.0)))
    }

    /// Where P passes zero within, in order; an end of the part where it does not.
    fn zeros(&self) -> [f64x4; 2] {
        let [p0, p1, p2] = self.power;
        let root = p1 * p1 - all(4.0) * p2 * p0;
        // Without cancellation: one root from the sum, the other from the product. Of a parabola without one, or of a power
        // that is zero all through, no part is cut off.
        let (none, sum) = (root.simd_lt(f64x4::ZERO), root.fast_max(f64x4::ZERO).sqrt());
        let q = all(-0.5) * (p1 + p1.simd_lt(f64x4::ZERO).select(-sum, sum));
        let within = |u: f64x4| {
            let inside = u.simd_gt(f64x4::ZERO) & u.simd_lt(f64x4::ONE);
            none.select(f64x4::ZERO, inside.select(u, f64x4::ZERO))
        };
        let (a, b) = (within(q / p2), within(p0 / q));
        [a.fast_min(b), a.fast_max(b)]
    }

    /// The least power at an end or between \[W\].
    fn least(&self) -> f64x4 {
        let [p0, p1, p2] = self.power;
        let ends = p0.fast_min(p0 + p1 + p2);
        let vertex = all(-0.5) * p1 / p2;
        let between = vertex.simd_gt(f64x4::ZERO) & vertex.simd_lt(f64x4::ONE);
        between.select(ends.fast_min(p0 + vertex * (p1 + vertex * p2)), ends)
    }
}

impl Sweep {
    pub(super) fn of(power: &CyclePower<'_>) -> Self {
        let [[_, driving, starting, per_speed], [_, driven, ..]] = [false, true].map(|driven| power.weights(driven));
        let (copper, constant) = power.constants();
        Self {
            inertia: all(power.currents.inertia),
            per_torque: [all(driving), all(driven)],
            starting,
            per_speed: all(per_speed),
            copper: all(copper),
            constant: all(constant),
            whole: f64x4::ZERO,
            back: f64x4::ZERO,
            peak: f64x4::ZERO,
        }
    }

    /// What was taken \[J\], what came back \[J\] and the largest power that did \[W\].
    pub(super) fn found(&self) -> [f64; 3] {
        let peak = self.peak.to_array().into_iter().fold(0.0, f64::max);
        [self.whole.reduce_add(), self.back.reduce_add(), peak]
    }

    /// The power of a part from one share of it to another, with the factor of the torque in the current.
    fn arcs(&self, line: &Line, from: f64x4, to: f64x4, per_torque: f64x4) -> Arcs {
        let ([t, dt], [w, dw], share) = (line.torque, line.speed, to - from);
        let (w0, dw0) = (w + dw * from, dw * share);
        let i0 = per_torque * (t + dt * from) + line.starting + self.per_speed * w0;
        let di = per_torque * dt * share + self.per_speed * dw0;
        let (r, k) = (self.copper, self.constant);
        Arcs {
            duration: line.duration * share,
            power: [(r * i0 + k * w0) * i0, all(2.0) * r * i0 * di + k * (i0 * dw0 + w0 * di), (r * di + k * dw0) * di],
        }
    }

    /// Passes some intervals; a bank takes the parts of each in their order.
    pub(super) fn pass(&mut self, ramps: &Ramps, bank: Option<&mut Bank>) {
        let own = self.inertia * f64x4::new(ramps.acceleration_rad_s2);
        let [a, b] = ramps.load_nm.map(|load| own + f64x4::new(load));
        let [w0, w1] = ramps.speed_rad_s.map(f64x4::new);
        let direction = all(ramps.direction);
        let line = Line {
            duration: f64x4::new(ramps.duration_s),
            torque: [a, b - a],
            speed: [w0, w1 - w0],
            starting: all(self.starting * ramps.direction),
        };
        // The load drives in one part at most: before the zero of the torque, behind it, all through or nowhere.
        // At rest nothing does.
        let crosses = (a * b * direction * direction).simd_lt(f64x4::ZERO);
        let zero = crosses.select(a / (a - b), f64x4::ONE);
        let first = (a * direction).simd_lt(f64x4::ZERO);
        let some = ((a + b) * direction).simd_lt(f64x4::ZERO);
        let braking = crosses.select(first, some);
        // Up to there: the braking part comes first, or the driving one.
        let (before, after) = ([f64x4::ZERO, zero], [zero, f64x4::ONE]);
        let pick = |plain: [f64x4; 2], other: [f64x4; 2]| {
            let ([a, b], [c, d]) = (plain, other);
            [braking.select(a, c), braking.select(b, d)]
        };
        let ([from, to], [back_from, back_to]) = (pick(after, before), pick(before, after));
        let [driving, driven] = self.per_torque;
        let taken = self.arcs(&line, from, to, driving).energy(f64x4::ONE);
        let arcs = self.arcs(&line, back_from, back_to, driven);
        let [u, v] = arcs.zeros();
        let (at_u, at_v, at_end) = (arcs.energy(u), arcs.energy(v), arcs.energy(f64x4::ONE));
        let parts = [at_u, at_v - at_u, at_end - at_v];
        self.whole += taken + at_end;
        for part in parts {
            self.back -= part.fast_min(f64x4::ZERO);
        }
        self.peak = self.peak.fast_max((back_to - back_from).simd_gt(f64x4::ZERO).select(-arcs.least(), self.peak));
        if let Some(bank) = bank {
            let (taken, parts) = (taken.to_array(), parts.map(|part| part.to_array()));
            let first = braking.to_bitmask();
            for (lane, taken) in taken.into_iter().enumerate() {
                let of = |part: &[f64; 4]| part.get(lane).copied().unwrap_or(0.0);
                let [a, b, c] = parts.each_ref().map(of);
                let order = if first >> lane & 1 == 1 { [a, b, c, taken] } else { [taken, a, b, c] };
                order.into_iter().for_each(|taken| bank.pass(taken));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const COPPER: f64 = 0.9;
    const CONSTANT: f64 = 14.0;
    const STARTING: f64 = 0.21;
    const PER_SPEED: f64 = 0.05;
    /// Less is passed on while the load drives.
    const PER_TORQUE: [f64; 2] = [0.08, 0.05];
    const INERTIA: f64 = 0.3;

    fn sweep() -> Sweep {
        let [driving, driven] = PER_TORQUE;
        Sweep {
            inertia: all(INERTIA),
            per_torque: [all(driving), all(driven)],
            starting: STARTING,
            per_speed: all(PER_SPEED),
            copper: all(COPPER),
            constant: all(CONSTANT),
            whole: f64x4::ZERO,
            back: f64x4::ZERO,
            peak: f64x4::ZERO,
        }
    }

    /// The instants of an interval, taken apart as finely as is asked for: ∫P dt, −∫P dt where P < 0, the largest −P.
    fn brute(ramps: &Ramps, lane: usize, steps: u32, bank: &mut Bank) -> [f64; 3] {
        let (sigma, h) = (ramps.direction, ramps.duration_s[lane]);
        let step = h / f64::from(steps);
        let mut found = [0.0; 3];
        for k in 0..steps {
            let u = (f64::from(k) + 0.5) / f64::from(steps);
            let along = |ends: [[f64; 4]; 2]| ends[0][lane] + u * (ends[1][lane] - ends[0][lane]);
            let (speed, load) = (along(ramps.speed_rad_s), along(ramps.load_nm));
            let torque = INERTIA * ramps.acceleration_rad_s2[lane] + load;
            let per_torque = PER_TORQUE[usize::from(torque * sigma < 0.0)];
            let current = per_torque * torque + STARTING * sigma + PER_SPEED * speed;
            let power = (COPPER * current + CONSTANT * speed) * current;
            found[0] += power * step;
            found[1] -= power.min(0.0) * step;
            found[2] = f64::max(found[2], -power);
            bank.pass(power * step);
        }
        found
    }

    /// Every way in which torque and power may turn their sign within an interval, forwards, backwards and at rest.
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
                let (mut own, mut bank, mut expected_bank) = (sweep(), Bank::default(), Bank::default());
                own.pass(&ramps, Some(&mut bank));
                let mut without = sweep();
                without.pass(&ramps, None);
                assert_eq!(own.found(), without.found(), "the bank changes nothing");
                let each = [0, 1, 2, 3].map(|lane| brute(&ramps, lane, 20_000, &mut expected_bank));
                let expected = each.into_iter().reduce(|[a, b, c], [d, e, f]| [a + d, b + e, c.max(f)]).unwrap();
                let what = format!("{a} to {four:?} Nm, {w0} to {w1} rad/s: {:?} against {expected:?}", own.found());
                let scale = 1.0 + expected[0].abs() + expected[1];
                assert!((own.found()[0] - expected[0]).abs() < 1e-6 * scale, "{what}");
                assert!((own.found()[1] - expected[1]).abs() < 1e-6 * scale, "{what}");
                assert!((own.found()[2] - expected[2]).abs() < 1e-3 * (1.0 + expected[2]), "{what}");
                let (most, expected_most) = (bank.most, expected_bank.most);
                assert!((most - expected_most).abs() < 1e-5 * scale, "{what}: {most} J against {expected_most} J");
                seen_back += u32::from(expected[1] > 0.0);
            }
        }
        assert!(seen_back > 50, "{seen_back}: energy comes back in many of them");
    }
}
