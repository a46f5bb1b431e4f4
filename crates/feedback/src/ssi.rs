//! SSI: the position as a plain binary word without checksum.

use crate::{Shaft, Word};
use quantities::{Frequency, Measure, Time};

/// Division of an SSI word into turns and angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SsiFormat {
    /// Bits of the turns, transmitted first.
    pub turns: u32,
    /// Bits of the angle.
    pub steps: u32,
}

/// Position in an SSI word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Position {
    /// Turns modulo the number of turns in the word.
    pub turns: u64,
    /// Step within the turn.
    pub step: u64,
}

/// Error: a word differs in length from that of the encoder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WrongLength {
    /// Bits found.
    pub found: u32,
    /// Bits expected.
    pub expected: u32,
}

impl SsiFormat {
    /// Returns the number of bits of a word.
    #[must_use]
    pub const fn bits(self) -> u32 {
        self.turns + self.steps
    }

    /// Returns the position of a shaft; turns beyond the last start again at zero.
    #[must_use]
    pub fn position(self, shaft: Shaft) -> Position {
        #[allow(clippy::cast_sign_loss, reason = "the remainder is not negative")]
        let turns = shaft.turns().rem_euclid(1 << self.turns) as u64;
        Position { turns, step: shaft.step(1 << self.steps) }
    }

    /// Returns the word of a position, most significant bit first.
    ///
    /// # Source
    /// cha-manual table 59.1: SSI binary, 29 bit, of which 17 for the angle and (erratum T59.1-turns-bits) 12 for the turns
    #[must_use]
    pub const fn word(self, position: Position) -> Word {
        Word::empty().high_first(position.turns, self.turns).high_first(position.step, self.steps)
    }

    /// Reads a position word.
    ///
    /// # Errors
    /// The word has another length. Nothing else can be detected: SSI has no checksum, so that a wrong bit remains
    /// unnoticed.
    pub const fn read(self, word: Word) -> Result<Position, WrongLength> {
        if word.len() != self.bits() {
            return Err(WrongLength { found: word.len(), expected: self.bits() });
        }
        Ok(Position { turns: word.part(0, self.turns).number(), step: word.part(self.turns, self.steps).number() })
    }
}

/// Returns the time for which data stays low after the last bit before the next word can be latched: 20 µs.
///
/// # Source
/// Assumed: SSI masters of other manufacturers wait 20 µs (PandA) to 25 µs (NI); the manual states no time
#[must_use]
pub fn monoflop() -> Time {
    Time::from_si(20e-6)
}

/// Returns the clock frequency of a trace: 500 kHz.
///
/// # Source
/// Assumed: within the limits of SSI for some tens of metres of cable; the manual states none
#[must_use]
pub fn clock() -> Frequency {
    Frequency::from_si(5e5)
}

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::{Angle, AngularVelocity};
    use std::f64::consts::TAU;

    const M128S: SsiFormat = SsiFormat { turns: 12, steps: 17 };

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

    /// Turn 1, step 1: the lowest bit of each part is set.
    #[test]
    fn the_turns_are_sent_first() {
        assert_eq!(M128S.word(Position { turns: 1, step: 1 }).to_string(), "00000000000100000000000000001");
    }
}
