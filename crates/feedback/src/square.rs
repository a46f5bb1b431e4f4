//! Square-wave tracks, zero pulse and commutation signals.

use crate::sine::SinePair;
use quantities::{Angle, Measure};
use std::f64::consts::TAU;

/// Part of a period in which a signal is high \[periods\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Phase of the middle \[periods\].
    pub middle: f64,
    /// Width of the part \[periods\].
    pub width: f64,
}

impl Window {
    /// Returns `true` if a phase lies within the window.
    #[must_use]
    pub fn holds(self, phase: f64) -> bool {
        // The beginning belongs to the window, the end does not.
        (phase - self.middle + self.width / 2.0).rem_euclid(1.0) < self.width
    }

    /// Returns the phases at which the window begins and ends.
    #[must_use]
    pub fn ends(self) -> [f64; 2] {
        [self.middle - self.width / 2.0, self.middle + self.width / 2.0].map(|end| end.rem_euclid(1.0))
    }
}

/// Windows in which two tracks are high after a comparator at zero: a cosine from −90° to 90°, a sine from 0° to 180°.
pub(crate) const HIGH: [Window; 2] = [Window { middle: 0.0, width: 0.5 }, Window { middle: 0.25, width: 0.5 }];

/// Two square-wave tracks; the first leads by a quarter period while the angle increases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SquareTracks {
    /// Periods per turn.
    pub periods: u32,
}

impl SquareTracks {
    /// Returns the levels of both tracks at an angle.
    #[must_use]
    pub fn at(self, seen: Angle) -> [bool; 2] {
        let phase = phase(seen, self.periods);
        HIGH.map(|window| window.holds(phase))
    }
}

impl From<SinePair> for SquareTracks {
    fn from(pair: SinePair) -> Self {
        Self { periods: pair.periods }
    }
}

/// Returns the phase within the period of a track \[periods\].
pub(crate) fn phase(seen: Angle, periods: u32) -> f64 {
    (seen.si() / TAU * f64::from(periods)).rem_euclid(1.0)
}

/// Three commutation signals, each high for half a period, a third of a period apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CommutationPhases {
    /// Periods per turn: the pole pairs of the motor.
    pub periods: u32,
}

impl CommutationPhases {
    /// Windows in which U, V and W are high.
    pub const HIGH: [Window; 3] = [
        Window { middle: 0.25, width: 0.5 },
        Window { middle: 0.25 + 1.0 / 3.0, width: 0.5 },
        Window { middle: 0.25 + 2.0 / 3.0, width: 0.5 },
    ];

    /// Returns the levels of U, V and W at an angle.
    #[must_use]
    pub fn at(self, seen: Angle) -> [bool; 3] {
        let phase = phase(seen, self.periods);
        Self::HIGH.map(|window| window.holds(phase))
    }
}

/// Error: U, V and W are all high or all low, which a working encoder never shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoSector;

/// Returns the sixth of the period that three commutation signals indicate, counted from zero.
///
/// # Errors
/// The three signals have the same level.
pub const fn commutation_sector([u, v, w]: [bool; 3]) -> Result<u8, NoSector> {
    match (u, v, w) {
        (true, false, true) => Ok(0),
        (true, false, false) => Ok(1),
        (true, true, false) => Ok(2),
        (false, true, false) => Ok(3),
        (false, true, true) => Ok(4),
        (false, false, true) => Ok(5),
        (true, true, true) | (false, false, false) => Err(NoSector),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Five periods per turn: thirty sectors of 12°; one signal changes at a time.
    #[test]
    fn commutation_steps_every_twelve_degrees() {
        let tracks = CommutationPhases { periods: 5 };
        for sector in 0..30_u8 {
            let angle = Angle::from_si((f64::from(sector) * 12.0 + 6.0).to_radians());
            assert_eq!(commutation_sector(tracks.at(angle)), Ok(sector % 6));
        }
        assert_eq!(commutation_sector([true; 3]), Err(NoSector));
        assert_eq!(commutation_sector([false; 3]), Err(NoSector));
    }

    #[test]
    fn squares_are_the_signs_of_the_sines() {
        let pair = SinePair { periods: 7, level: None };
        for at in 0..1000 {
            let angle = Angle::from_si(f64::from(at) * 0.0123 + 0.001);
            assert_eq!(SquareTracks::from(pair).at(angle), pair.unit(angle).map(|value| value >= 0.0));
        }
    }
}
