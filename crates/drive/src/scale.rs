//! Conversion between user units and angles of the output.

use crate::given::Given;
use std::f64::consts::TAU;

/// Encoder increments per motor turn where no table states them. Assumed.
pub(crate) const INCREMENTS_USUAL: i64 = 65_536;

/// Conversion of output angles into increments.
///
/// x = ± q i r/(2π) · (feed/turns) / (increments/turns · gear)
///
/// # Symbols
/// q angle of the output \[rad\], i ratio, r increments of the encoder in a turn of the motor; the objects 6092h, 608Fh, 6091h
/// # Source
/// cia-402 factor group
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Scale {
    /// Encoder increments per rad at the output, as stated in the tables.
    encoder: f64,
    ratio: f64,
    increments: f64,
    /// The encoder counts down while the output turns in the positive direction.
    is_reversed: bool,
    /// User units of position per rad, with sign.
    per_rad: f64,
    /// Sign of speeds relative to that of positions.
    speed_sign: f64,
    /// Angle that counts as zero \[rad\].
    zero_rad: f64,
}

impl Scale {
    pub(crate) fn new(given: &Given) -> Self {
        let known = |index: u16| given.objects.iter().find(|object| (object.index, object.sub) == (index, 1));
        #[allow(clippy::cast_precision_loss, reason = "65536")]
        let increments = known(0x608F).map_or(INCREMENTS_USUAL as f64, |object| f64::from(object.value));
        let ratio = known(0x6091).map_or(1.0, |object| f64::from(object.value));
        let encoder = increments * ratio / TAU;
        // If the manual states the direction of increasing position, the gear reverses it (cha-manual section 11.1).
        let is_reversed = given.objects.iter().any(|object| object.index == 0x607E);
        Self { encoder, ratio, increments, is_reversed, per_rad: encoder, speed_sign: 1.0, zero_rad: 0.0 }
    }

    /// Adopts the present values of the factor group; `number` returns the value of an object by index and sub-index.
    pub(crate) fn follow(&mut self, number: impl Fn(u16, u8) -> i64) {
        #[allow(clippy::cast_precision_loss, reason = "at most 32 bit")]
        let get = |index: u16, sub: u8| number(index, sub) as f64;
        let feed = get(0x6092, 1) / get(0x6092, 2);
        let of_a_turn = get(0x608F, 1) / get(0x608F, 2) * get(0x6091, 1) / get(0x6091, 2);
        let polarity = number(0x607E, 0);
        let sign = |bit: u8| if (polarity >> bit & 1 == 1) == self.is_reversed { 1.0 } else { -1.0 };
        self.per_rad = sign(7) * self.encoder * feed / of_a_turn;
        self.speed_sign = sign(6) * sign(7);
    }

    /// Returns the position of an angle \[rad\] in user units.
    pub(crate) fn position(&self, rad: f64) -> i64 {
        self.difference(rad - self.zero_rad)
    }

    /// Returns the angle of a position \[rad\].
    pub(crate) fn angle(&self, position: i64) -> f64 {
        self.way(position) + self.zero_rad
    }

    /// Returns a difference of angles \[rad\] as a difference of positions.
    pub(crate) fn difference(&self, rad: f64) -> i64 {
        wrapped(rad * self.per_rad)
    }

    /// Returns a difference of positions as a difference of angles \[rad\].
    #[allow(clippy::cast_precision_loss, reason = "32 bit")]
    pub(crate) fn way(&self, position: i64) -> f64 {
        position as f64 / self.per_rad
    }

    /// Resets the turns counted by the encoder to zero at an angle \[rad\]; the angle within the turn remains.
    pub(crate) fn lose_turns(&mut self, rad: f64) {
        let turn = TAU / self.ratio;
        let seen = if self.is_reversed { self.zero_rad - rad } else { rad - self.zero_rad };
        let lost = turn * (seen / turn).floor();
        self.zero_rad += if self.is_reversed { -lost } else { lost };
    }

    /// Returns a speed of the output [rad/s] in user units.
    pub(crate) fn speed(&self, rad_s: f64) -> i64 {
        bounded(rad_s * self.per_rad * self.speed_sign, i64::from(i32::MIN), i64::from(i32::MAX))
    }

    /// Returns a speed in user units as a speed of the output [rad/s].
    #[allow(clippy::cast_precision_loss, reason = "32 bit")]
    pub(crate) fn speed_rad(&self, speed: i64) -> f64 {
        speed as f64 / self.per_rad * self.speed_sign
    }

    /// Returns a magnitude in user units.
    pub(crate) fn plain(&self, rad: f64) -> i64 {
        bounded((rad * self.per_rad).abs(), 0, i64::from(u32::MAX))
    }

    /// Returns a magnitude in user units as an angle, a speed or an acceleration at the output.
    #[allow(clippy::cast_precision_loss, reason = "32 bit")]
    pub(crate) fn plain_rad(&self, value: i64) -> f64 {
        (value as f64 / self.per_rad).abs()
    }

    /// Returns the motor speed of an output speed in whole 1/min, rounded down because it is a limit.
    pub(crate) fn motor_rpm(&self, rad_s: f64) -> i64 {
        bounded((rad_s * self.ratio * 60.0 / TAU + 1e-6).floor(), 0, i64::from(u32::MAX))
    }

    /// Returns the output speed [rad/s] of a motor speed in 1/min.
    #[allow(clippy::cast_precision_loss, reason = "32 bit")]
    pub(crate) fn motor_rad(&self, rpm: i64) -> f64 {
        rpm as f64 * TAU / 60.0 / self.ratio
    }

    pub(crate) fn ratio(&self) -> i64 {
        bounded(self.ratio, 1, i64::from(u32::MAX))
    }

    pub(crate) fn increments_of_a_turn(&self) -> i64 {
        bounded(self.increments * self.ratio, 1, i64::from(u32::MAX))
    }
}

/// Rounds a number and limits it to a range; NaN becomes the value nearest to zero in the range.
pub(crate) fn bounded(value: f64, least: i64, most: i64) -> i64 {
    #[allow(clippy::cast_possible_truncation, reason = "the cast keeps within its bounds")]
    let whole = value.round() as i64;
    whole.clamp(least, most)
}

/// Rounds a number to 32 bit; values out of range wrap around, as the counter of a drive does.
fn wrapped(value: f64) -> i64 {
    #[allow(clippy::cast_possible_truncation, reason = "the cast keeps within its bounds")]
    let whole = value.round() as i64;
    let span = 1_i64 << 32;
    let least = i64::from(i32::MIN);
    whole.wrapping_sub(least).rem_euclid(span) + least
}
