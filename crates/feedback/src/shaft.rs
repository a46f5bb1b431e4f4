//! Shaft of an encoder at an instant.

use quantities::{Angle, AngularVelocity, Measure, Time};
use std::f64::consts::TAU;

/// A shaft with whole turns, the angle within one turn, and its speed; positive in the direction of increasing position
/// values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shaft {
    turns: i64,
    angle_rad: f64,
    speed_rad_s: f64,
}

impl Shaft {
    /// Creates a shaft from whole turns and an angle, which may itself exceed a turn.
    #[must_use]
    #[allow(clippy::cast_possible_truncation, reason = "a float becomes the nearest whole number that there is")]
    pub fn new(turns: i64, angle: Angle, speed: AngularVelocity) -> Self {
        let angle = if angle.si().is_finite() { angle.si() } else { 0.0 };
        let whole = (angle / TAU).floor();
        let within = angle - whole * TAU;
        // The difference of two close numbers may round to the full turn.
        let (whole, within) = if within >= TAU { (whole + 1.0, 0.0) } else { (whole, within.max(0.0)) };
        Self { turns: turns.saturating_add(whole as i64), angle_rad: within, speed_rad_s: speed.si() }
    }

    /// Returns the whole turns.
    #[must_use]
    pub const fn turns(self) -> i64 {
        self.turns
    }

    /// Returns the angle within the turn, from zero up.
    #[must_use]
    pub fn angle(self) -> Angle {
        Angle::from_si(self.angle_rad)
    }

    /// Returns the speed.
    #[must_use]
    pub fn speed(self) -> AngularVelocity {
        AngularVelocity::from_si(self.speed_rad_s)
    }

    /// Returns the shaft after a time at constant speed.
    #[must_use]
    pub fn after(self, time: Time) -> Self {
        let angle = Angle::from_si(self.angle_rad + self.speed_rad_s * time.si());
        Self::new(self.turns, angle, self.speed())
    }

    /// Returns the output of a strain wave gear with a fixed circular spline: slower by the ratio, in the opposite
    /// direction.
    ///
    /// φ_out = −φ / i, each clockwise as seen from the front
    ///
    /// # Source
    /// cha-manual tables 58.1 and 68.1, footnotes on the direction: motor shaft clockwise, flange counter-clockwise
    #[must_use]
    pub fn behind_gear(self, ratio: u32) -> Self {
        let (ratio_turns, ratio_f) = (i64::from(ratio.max(1)), f64::from(ratio.max(1)));
        let rest = self.turns.rem_euclid(ratio_turns);
        #[allow(clippy::cast_precision_loss, reason = "below a ratio")]
        let angle = (rest as f64 * TAU + self.angle_rad) / ratio_f;
        let turns = self.turns.div_euclid(ratio_turns).checked_neg().unwrap_or(i64::MAX);
        Self::new(turns, Angle::from_si(-angle), AngularVelocity::from_si(-self.speed_rad_s / ratio_f))
    }

    /// Returns the step of the turn at which the shaft stands, of `steps` per turn.
    #[must_use]
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "steps of a turn are few, and the angle is not negative"
    )]
    pub fn step(self, steps: u64) -> u64 {
        // An angle stated in degrees may be a rounding error below the step that begins there.
        let step = (self.angle_rad / TAU * steps as f64 + 1e-9).floor() as u64;
        step.min(steps.saturating_sub(1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(turns: i64, turn: f64) -> Shaft {
        Shaft::new(turns, Angle::from_si(turn * TAU), AngularVelocity::from_si(3.0))
    }

    #[test]
    fn whole_turns_leave_the_angle() {
        let shaft = at(3, -1.25);
        assert_eq!((shaft.turns(), shaft.step(8)), (1, 6));
        assert_eq!(at(0, -1e-20).turns(), 0, "as near to zero as a float can say");
        let later = at(0, 0.0).after(Time::from_si(TAU / 3.0 * 2.6));
        assert_eq!((later.turns(), later.step(4)), (2, 2));
    }

    /// 100 turns of the motor are one turn of the output in the opposite direction; exact for any number of motor
    /// turns.
    #[test]
    fn the_output_turns_the_other_way() {
        let out = at(25, 0.0).behind_gear(100);
        assert_eq!((out.turns(), out.step(4)), (-1, 3));
        assert!((out.speed().si() + 0.03).abs() < 1e-15);
        let far = at(100 * 1_000_000_000_000 + 25, 0.0).behind_gear(100);
        assert_eq!((far.turns(), far.step(4)), (-1_000_000_000_001, 3));
    }
}
