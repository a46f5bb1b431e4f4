//! Integrals of a cycle from which the demand of every candidate follows without looking at the cycle again.

use crate::cycle::{Cycle, Phase};
use quantities::{Angle, AngularVelocity, Measure, Time};

/// Exact integrals over one cycle of linear speed ramps.
///
/// With a load that answers T = J α + T_c σ (σ = direction of motion, 0 at rest), the mean square of the torque is
/// ∫T² dt / t_0 = (J² ∫α² dt + 2 J T_c ∫α σ dt + T_c² ∫σ² dt) / t_0,
/// a polynomial in J and T_c with the coefficients kept here: one pass over the motion, then O(1) per actuator.
///
/// # Symbols  α angular acceleration [rad/s²], σ direction, t_0 cycle time \[s\]
/// # Source   own derivation, docs/theory/demand.md
/// # Valid    any sequence of linear speed ramps; each ramp keeps its direction of motion
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments {
    /// t_0: duration of the cycle.
    pub duration: Time,
    /// ∫σ² dt: time in motion.
    pub moving: Time,
    /// ∫α² dt [rad²/s³]
    pub alpha_squared_rad2_s3: f64,
    /// ∫α σ dt [rad/s]
    pub alpha_direction_rad_s: f64,
    /// ∫|ω| dt: angle travelled, counted positive in both directions.
    pub angle_travelled: Angle,
    /// ∫ω dt: angle between the end and the start of the cycle.
    pub angle_net: Angle,
    /// Largest minus smallest position within one cycle.
    pub angle_swing: Angle,
    /// max |ω|
    pub speed_peak: AngularVelocity,
    /// Instant at which the peak speed is first reached.
    pub speed_peak_at: Time,
}

impl Moments {
    /// The moments of a cycle, in one pass.
    #[must_use]
    pub fn of(cycle: &Cycle) -> Self {
        let mut sum = Self {
            duration: cycle.duration(),
            moving: Time::from_si(0.0),
            alpha_squared_rad2_s3: 0.0,
            alpha_direction_rad_s: 0.0,
            angle_travelled: Angle::from_si(0.0),
            angle_net: Angle::from_si(0.0),
            angle_swing: Angle::from_si(0.0),
            speed_peak: AngularVelocity::from_si(0.0),
            speed_peak_at: Time::from_si(0.0),
        };
        // The direction never changes within a ramp, so the extremes of the position lie at its ends.
        let (mut lowest, mut highest) = (0.0_f64, 0.0_f64);
        for segment in cycle.segments() {
            let duration = segment.duration.si();
            let alpha = segment.acceleration().si();
            let angle = 0.5 * (segment.speed_start.si() + segment.speed_end.si()) * duration;
            sum.alpha_squared_rad2_s3 += alpha * alpha * duration;
            sum.alpha_direction_rad_s += alpha * segment.direction * duration;
            sum.angle_net += Angle::from_si(angle);
            sum.angle_travelled += Angle::from_si(angle.abs());
            lowest = lowest.min(sum.angle_net.si());
            highest = highest.max(sum.angle_net.si());
            if segment.phase != Phase::Pause {
                sum.moving += segment.duration;
            }
            for (speed, at) in
                [(segment.speed_start, segment.start), (segment.speed_end, segment.start + segment.duration)]
            {
                if speed.si().abs() > sum.speed_peak.si() {
                    sum.speed_peak = AngularVelocity::from_si(speed.si().abs());
                    sum.speed_peak_at = at;
                }
            }
        }
        sum.angle_swing = Angle::from_si(highest - lowest);
        sum
    }

    /// Whether the cycle ends where it began, up to a millionth of what it travels: a swing, not a rotation.
    #[must_use]
    pub fn is_swing(&self) -> bool {
        self.angle_net.si().abs() <= 1e-6 * self.angle_travelled.si()
    }

    /// n_av: mean of |n| over the cycle, pause included.
    #[must_use]
    pub fn speed_mean(&self) -> AngularVelocity {
        AngularVelocity::from_si(self.angle_travelled.si() / self.duration.si())
    }

    /// ED: share of the cycle in motion.
    #[must_use]
    pub fn duty_factor(&self) -> f64 {
        self.moving.si() / self.duration.si()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ManualMove;

    fn cycle() -> Cycle {
        let s = Time::from_si;
        let one = |speed, t1, t2, t3, tp| ManualMove {
            speed: AngularVelocity::from_si(speed),
            accelerate: s(t1),
            run: s(t2),
            brake: s(t3),
            pause: s(tp),
        };
        Cycle::new(vec![one(4.0, 0.1, 0.3, 0.25, 0.5), one(-2.5, 0.4, 0.0, 0.2, 0.05)]).unwrap()
    }

    /// Midpoint sampling of the same integrals; exact for constants and linear functions up to the ramp borders.
    #[test]
    fn the_moments_agree_with_brute_force_sampling() {
        let cycle = cycle();
        let moments = Moments::of(&cycle);
        let (mut alpha2, mut alpha_sigma, mut travelled, mut net) = (0.0, 0.0, 0.0, 0.0);
        for segment in cycle.segments() {
            let n = 1000;
            let dt = segment.duration.si() / f64::from(n);
            for k in 0..n {
                let u = (f64::from(k) + 0.5) / f64::from(n);
                let w = segment.speed_start.si() + u * (segment.speed_end.si() - segment.speed_start.si());
                let a = (segment.speed_end.si() - segment.speed_start.si()) / segment.duration.si();
                alpha2 += a * a * dt;
                alpha_sigma += a * segment.direction * dt;
                travelled += w.abs() * dt;
                net += w * dt;
            }
        }
        assert!((alpha2 - moments.alpha_squared_rad2_s3).abs() < 1e-9);
        assert!((alpha_sigma - moments.alpha_direction_rad_s).abs() < 1e-9);
        assert!((travelled - moments.angle_travelled.si()).abs() < 1e-9);
        assert!((net - moments.angle_net.si()).abs() < 1e-9);
    }

    #[test]
    fn from_rest_to_rest_the_acceleration_along_the_motion_cancels() {
        assert!(Moments::of(&cycle()).alpha_direction_rad_s.abs() < 1e-12);
    }

    #[test]
    fn the_swing_is_the_span_of_the_positions() {
        let moments = Moments::of(&cycle());
        // Forth: 4·(0.05 + 0.3 + 0.125) = 1.9 rad; back: 2.5·(0.2 + 0.1) = 0.75 rad.
        assert!((moments.angle_swing.si() - 1.9).abs() < 1e-12);
        assert!((moments.angle_net.si() - 1.15).abs() < 1e-12);
        assert!(!moments.is_swing());
    }

    #[test]
    fn the_peak_speed_is_found_with_its_instant() {
        let moments = Moments::of(&cycle());
        assert!((moments.speed_peak.si() - 4.0).abs() < 1e-15);
        assert!((moments.speed_peak_at.si() - 0.1).abs() < 1e-15);
    }
}
