//! SSI: the position as a plain binary word without a check.

use crate::{Shaft, Word};
use quantities::{Frequency, Measure, Time};

/// How an SSI word is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Format {
    /// Bits of the turns, sent first.
    pub turns: u32,
    /// Bits of the angle.
    pub steps: u32,
}

/// The position in an SSI word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Position {
    /// Turns, counted modulo their number.
    pub turns: u64,
    /// Step of the turn.
    pub step: u64,
}

/// A word is not as long as the encoder sends it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WrongLength {
    /// Bits that it has.
    pub found: u32,
    /// Bits that it should have.
    pub expected: u32,
}

impl Format {
    /// Bits of a word.
    #[must_use]
    pub const fn bits(self) -> u32 {
        self.turns + self.steps
    }

    /// The position of a shaft; turns beyond the last begin again at zero.
    #[must_use]
    pub fn position(self, shaft: Shaft) -> Position {
        #[allow(clippy::cast_sign_loss, reason = "the remainder is not negative")]
        let turns = shaft.turns().rem_euclid(1 << self.turns) as u64;
        Position { turns, step: shaft.step(1 << self.steps) }
    }

    /// The word of a position, highest bit first.
    ///
    /// # Source
    /// cha-manual table 59.1: SSI binary, 29 bit, of which 17 for the angle and (erratum T59.1-turns-bits) 12 for the turns
    #[must_use]
    pub const fn word(self, position: Position) -> Word {
        Word::empty().high_first(position.turns, self.turns).high_first(position.step, self.steps)
    }

    /// Reads a word.
    ///
    /// # Errors
    /// Another length. Nothing else can be found out: SSI has no check, so every bit may be wrong unseen.
    pub const fn read(self, word: Word) -> Result<Position, WrongLength> {
        if word.len() != self.bits() {
            return Err(WrongLength { found: word.len(), expected: self.bits() });
        }
        Ok(Position { turns: word.part(0, self.turns).number(), step: word.part(self.turns, self.steps).number() })
    }
}

/// How long data stays low behind the last bit before the next word can be latched: 20 µs.
///
/// # Source
/// Assumed: SSI masters of other makers wait 20 µs (PandA) to 25 µs (NI); the manual prints no time
#[must_use]
pub fn monoflop() -> Time {
    Time::from_si(20e-6)
}

/// The clock of a trace: 500 kHz.
///
/// # Source
/// Assumed: within what SSI permits on some tens of metres of cable; the manual prints none
#[must_use]
pub fn clock() -> Frequency {
    Frequency::from_si(5e5)
}

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::{Angle, AngularVelocity};
    use std::f64::consts::TAU;

    const M128S: Format = Format { turns: 12, steps: 17 };

    fn shaft(turns: i64, share: f64) -> Shaft {
        Shaft::new(turns, Angle::from_si(TAU * share), AngularVelocity::from_si(0.0))
    }

    #[test]
    fn turns_and_angle_come_back_and_overflow() {
        for turns in [0, 1, 2047, 4095] {
            for step in (0..131_072_u32).step_by(997) {
                let at = shaft(turns, (f64::from(step) + 0.5) / 131_072.0);
                let word = M128S.word(M128S.position(at));
                assert_eq!(word.len(), 29);
                let read = M128S.read(word).unwrap();
                assert_eq!((read.turns, read.step), (turns.unsigned_abs(), u64::from(step)));
            }
        }
        assert_eq!(M128S.position(shaft(4096, 0.0)), M128S.position(shaft(0, 0.0)));
        assert_eq!(M128S.position(shaft(0, -0.000_001)), Position { turns: 4095, step: 131_071 });
    }

    #[test]
    fn another_length_is_refused() {
        assert_eq!(M128S.read(Word::new(0, 30)), Err(WrongLength { found: 30, expected: 29 }));
    }

    /// Turn 1, step 1: the lowest bits of both parts.
    #[test]
    fn the_turns_are_sent_first() {
        assert_eq!(M128S.word(Position { turns: 1, step: 1 }).to_string(), "00000000000100000000000000001");
    }
}
