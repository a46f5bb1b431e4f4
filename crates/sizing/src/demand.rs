//! Demand of an axis on an actuator: the manual's procedure and the exact integrals.

use crate::axis::Axis;
use motion::ManualMove;
use numeric::First;
use quantities::{AngularVelocity, Measure, MomentOfInertia, Time, Torque};
use std::ops::Deref;
use trace::TorqueWith;

/// Demand of an axis on one actuator, whose own inertia is part of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Demand {
    /// T_rms: effective torque over the cycle.
    pub torque_rms: Torque,
    /// T_peak: largest magnitude of the torque.
    pub torque_peak: Torque,
    /// Instant at which the peak is first reached.
    pub torque_peak_at: Time,
    /// n_av: mean of |n| over the cycle.
    pub speed_mean: AngularVelocity,
    /// n_peak: largest |n|.
    pub speed_peak: AngularVelocity,
    /// Instant at which the peak is first reached.
    pub speed_peak_at: Time,
    /// ED: share of the cycle in motion, 0 to 1.
    pub duty_factor: f64,
}

/// Torques of one move by the manual's equations, in the direction of the move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MoveTorques {
    /// T_1: torque while accelerating.
    pub accelerate: Torque,
    /// T_2: torque while running.
    pub run: Torque,
    /// T_3: torque while braking.
    pub brake: Torque,
}

/// Torques of the moves of a cycle; stored inline for a single move, the most common case.
#[derive(Clone, Debug, PartialEq)]
pub struct Moves(Listed);

#[derive(Clone, Debug, PartialEq)]
enum Listed {
    One([MoveTorques; 1]),
    Several(Box<[MoveTorques]>),
}

impl Moves {
    fn of(cycle: &[ManualMove], torques: impl Fn(&ManualMove) -> MoveTorques) -> Self {
        Self(match cycle {
            [only] => Listed::One([torques(only)]),
            several => Listed::Several(several.iter().map(torques).collect()),
        })
    }
}

impl Deref for Moves {
    type Target = [MoveTorques];

    fn deref(&self) -> &[MoveTorques] {
        match &self.0 {
            Listed::One(one) => one,
            Listed::Several(several) => several,
        }
    }
}

/// Demand by the manual's equations 69.1 to 69.4.
#[derive(Clone, Debug, PartialEq)]
pub struct ManualDemand {
    /// Characteristic values of the cycle.
    pub demand: Demand,
    /// Torques of each move.
    pub moves: Moves,
    /// Index of the move with the largest torque.
    pub governing: usize,
    /// Eq. 69.2 uses an accelerating time that differs from the braking time. Then T_3, and with it T_rms, differ from
    /// the exact integral.
    pub braking_assumed: bool,
}

impl Axis {
    /// Computes the demand by exact integrals of the motion.
    ///
    /// T_rms² = (J² G_αα + 2 J G_αT + G_TT) / t_0 with J = J_out
    ///
    /// # Symbols
    /// G_xy = ∫ x y dt over the cycle, T torque of the load without J_out
    /// # Source
    /// docs/theory/moments.md; the torque at every instant is J_out α + T
    #[must_use]
    pub fn demand(&self, inertia_out: MomentOfInertia) -> Demand {
        let moments = &self.moments;
        let inertia = inertia_out.si();
        let square = self.trace.gram().square([inertia, 1.0, 0.0, 0.0]) / moments.duration.si();
        let (peak, at) = self.trace.largest(&TorqueWith { inertia_kgm2: inertia });
        Demand {
            torque_rms: Torque::from_si(square.sqrt()),
            torque_peak: Torque::from_si(peak),
            torque_peak_at: Time::from_si(at.time_s),
            speed_mean: moments.speed_mean(),
            speed_peak: moments.speed_peak,
            speed_peak_at: moments.speed_peak_at,
            duty_factor: moments.duty_factor(),
        }
    }

    /// Returns the peak torque that is reached with every moment of inertia of an actuator, and its instant: a lower bound where
    /// J_out is unknown.
    ///
    /// min over J ≥ 0 of max |J α + T_L|, which is convex in J
    pub(crate) fn least_peak(&self) -> (Torque, Time) {
        /// Doublings of the upper end, from a millionth of the inertia of the load on.
        const DOUBLINGS: u32 = 60;
        /// Steps of the search, each of which shortens the interval to 0.62 of it.
        const STEPS: u32 = 60;
        /// Share by which the least value found may lie above the true one.
        const SURE: f64 = 1e-6;
        let of = |inertia: f64| {
            let (peak, at) = self.trace.largest(&TorqueWith { inertia_kgm2: inertia });
            (peak, at.time_s)
        };
        *self.least_peak.get_or_init(|| {
            let without = of(0.0);
            let mut high = 1e-6;
            let mut doublings = 0;
            while of(high).0 <= without.0 && doublings < DOUBLINGS {
                high *= 2.0;
                doublings += 1;
            }
            let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
            let (mut low, mut best) = (0.0, without);
            let inner = |low: f64, high: f64| [high - golden * (high - low), low + golden * (high - low)];
            for _ in 0..STEPS {
                let [one, other] = inner(low, high);
                let [at_one, at_other] = [of(one), of(other)];
                for found in [at_one, at_other] {
                    if found.0 < best.0 {
                        best = found;
                    }
                }
                if at_one.0 <= at_other.0 { high = other } else { low = one }
            }
            (Torque::from_si(best.0 * (1.0 - SURE)), Time::from_si(best.1))
        })
    }

    /// Computes the demand by the manual's procedure; `None` if its equations do not describe the axis.
    ///
    /// T_1 = T_L + (2π/60) (J_out + J_L) n_2 / t_1, T_2 = T_L, T_3 = T_L − (T_1 − T_L),
    /// T_rms = √((T_1² t_1 + T_2² t_2 + T_3² t_3) / (t_1 + t_2 + t_3 + t_p)),
    /// n_av = (|n_2|/2 t_1 + |n_2| t_2 + |n_2|/2 t_3) / (t_1 + t_2 + t_3 + t_p),
    /// ED = (t_1 + t_2 + t_3) / (t_1 + t_2 + t_3 + t_p)
    ///
    /// Several moves: the sums of numerators and denominators. T_L opposes each move, so that the three torques of a
    /// move are those of the same move in the positive direction.
    ///
    /// # Symbols
    /// n_2 [1/min], t \[s\], T \[Nm\], J \[kgm²\]
    /// # Source
    /// cha-manual eq. 69.1, 69.2, 69.3, 69.4
    /// # Valid
    /// exact for t_3 = t_1; with another braking time eq. 69.2 keeps the torque of the acceleration,
    /// see [`ManualDemand::braking_assumed`]
    #[must_use]
    pub fn manual_demand(&self, inertia_out: MomentOfInertia) -> Option<ManualDemand> {
        let (load_inertia, load_friction, cycle) = self.by_the_manual()?;
        let inertia = (load_inertia + inertia_out).si();
        let mut square_time = 0.0;
        let mut speed_time = 0.0;
        let mut moving = 0.0;
        let mut peak = First::above(f64::NEG_INFINITY, 0);
        let mut start = 0.0;
        let mut braking_assumed = false;
        let torques = |each: &ManualMove| {
            let speed = each.speed.si().abs();
            let friction = if speed > 0.0 { load_friction.si() } else { 0.0 };
            let first = if speed > 0.0 { friction + inertia * speed / each.accelerate.si() } else { 0.0 };
            let third = friction - (first - friction);
            [first, friction, third]
        };
        for (index, each) in cycle.iter().enumerate() {
            let [t1, t2, t3, tp] = [each.accelerate, each.run, each.brake, each.pause].map(Measure::si);
            let speed = each.speed.si().abs();
            let [first, friction, third] = torques(each);
            square_time += first * first * t1 + friction * friction * t2 + third * third * t3;
            speed_time += speed / 2.0 * t1 + speed * t2 + speed / 2.0 * t3;
            moving += t1 + t2 + t3;
            // Equal inputs are compared here, not equal results.
            braking_assumed |= speed > 0.0 && t1 != t3;
            for (torque, at) in [(first, start), (friction, start + t1), (third, start + t1 + t2)] {
                peak.see(torque.abs(), at, index);
            }
            start += t1 + t2 + t3 + tp;
        }
        Some(ManualDemand {
            demand: Demand {
                torque_rms: Torque::from_si((square_time / start).sqrt()),
                torque_peak: Torque::from_si(peak.value().max(0.0)),
                torque_peak_at: Time::from_si(peak.at().max(0.0)),
                speed_mean: AngularVelocity::from_si(speed_time / start),
                speed_peak: self.moments.speed_peak,
                speed_peak_at: self.moments.speed_peak_at,
                duty_factor: moving / start,
            },
            moves: Moves::of(cycle, |each| {
                let [accelerate, run, brake] = torques(each).map(Torque::from_si);
                MoveTorques { accelerate, run, brake }
            }),
            governing: peak.place(),
            braking_assumed,
        })
    }
}

#[cfg(test)]
#[path = "demand_tests.rs"]
mod tests;
