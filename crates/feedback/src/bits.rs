//! Words of bits in the order of transmission.

use std::fmt;
use std::str::FromStr;

/// A word of up to 64 bits; the first bit transmitted is the most significant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Word {
    bits: u64,
    len: u32,
}

impl Word {
    /// Maximum number of bits of a word.
    pub const MOST: u32 = 64;

    /// Creates a word from the lower `len` bits of `bits`; the first bit transmitted is the most significant.
    #[must_use]
    pub const fn new(bits: u64, len: u32) -> Self {
        let len = if len > Self::MOST { Self::MOST } else { len };
        Self { bits: bits & mask(len), len }
    }

    /// Creates a word without bits.
    #[must_use]
    pub const fn empty() -> Self {
        Self::new(0, 0)
    }

    /// Appends the lower `len` bits of a value, most significant bit first; bits beyond [`Word::MOST`] are dropped.
    #[must_use]
    pub const fn high_first(self, value: u64, len: u32) -> Self {
        let room = Self::MOST - self.len;
        let len = if len > room { room } else { len };
        let shifted = if len == Self::MOST { 0 } else { self.bits << len };
        Self { bits: shifted | (value & mask(len)), len: self.len + len }
    }

    /// Appends the lower `len` bits of a value, least significant bit first.
    #[must_use]
    pub const fn low_first(self, value: u64, len: u32) -> Self {
        self.high_first(reversed(value, len), len)
    }

    /// Appends one bit.
    #[must_use]
    pub const fn bit(self, bit: bool) -> Self {
        self.high_first(bit as u64, 1)
    }

    /// Returns the number of bits.
    #[must_use]
    pub const fn len(self) -> u32 {
        self.len
    }

    /// Returns `true` if the word has no bits.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.len == 0
    }

    /// Returns the word as a number whose most significant bit was transmitted first.
    #[must_use]
    pub const fn number(self) -> u64 {
        self.bits
    }

    /// Returns `len` bits from bit `from` on; fewer at the end of the word.
    #[must_use]
    pub const fn part(self, from: u32, len: u32) -> Self {
        let from = if from > self.len { self.len } else { from };
        let len = if len > self.len - from { self.len - from } else { len };
        let behind = self.len - from - len;
        let bits = if behind >= Self::MOST { 0 } else { self.bits >> behind };
        Self::new(bits, len)
    }

    /// Returns the word as a number whose least significant bit was transmitted first.
    #[must_use]
    pub const fn number_low_first(self) -> u64 {
        reversed(self.bits, self.len)
    }

    /// Iterates over the bits in the order of transmission.
    pub fn iter(self) -> impl DoubleEndedIterator<Item = bool> + ExactSizeIterator {
        let len = self.len as usize;
        (0..len).map(move |at| self.bits >> (len - 1 - at) & 1 == 1)
    }

    /// Returns the word with one bit inverted.
    #[must_use]
    pub const fn flipped(self, at: u32) -> Self {
        if at >= self.len { self } else { Self::new(self.bits ^ (1 << (self.len - 1 - at)), self.len) }
    }
}

const fn mask(len: u32) -> u64 {
    if len == 0 { 0 } else { u64::MAX >> (Word::MOST - len) }
}

const fn reversed(value: u64, len: u32) -> u64 {
    if len == 0 { 0 } else { value.reverse_bits() >> (Word::MOST - if len > Word::MOST { Word::MOST } else { len }) }
}

impl fmt::Display for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.iter().try_for_each(|bit| f.write_str(if bit { "1" } else { "0" }))
    }
}

/// Reason for which a text is no word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BitsFault {
    /// The text has no bits.
    Empty,
    /// A character other than 0, 1, white space and `_`, with its position counted from one.
    Sign(char, usize),
    /// More bits than a word can have.
    TooLong,
}

impl FromStr for Word {
    type Err = BitsFault;

    fn from_str(text: &str) -> Result<Self, BitsFault> {
        let mut word = Self::default();
        for (at, sign) in text.chars().enumerate() {
            let bit = match sign {
                '0' => false,
                '1' => true,
                ' ' | '_' => continue,
                _ => return Err(BitsFault::Sign(sign, at + 1)),
            };
            if word.len == Self::MOST {
                return Err(BitsFault::TooLong);
            }
            word = word.bit(bit);
        }
        if word.is_empty() { Err(BitsFault::Empty) } else { Ok(word) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_is_written_in_the_order_sent() {
        let word = Word::default().bit(true).low_first(0b001, 3).high_first(0b001, 3);
        assert_eq!(word.to_string(), "1100001");
        assert_eq!("1 100_001".parse(), Ok(word));
        assert_eq!(word.part(1, 3).number_low_first(), 1);
        assert_eq!(word.part(4, 9), Word::new(1, 3));
        assert_eq!(word.flipped(6).number(), word.number() - 1);
        assert_eq!(word.flipped(7), word);
    }

    #[test]
    fn what_is_no_word_is_refused() {
        assert_eq!("".parse::<Word>(), Err(BitsFault::Empty));
        assert_eq!("10x".parse::<Word>(), Err(BitsFault::Sign('x', 3)));
        assert_eq!("1".repeat(65).parse::<Word>(), Err(BitsFault::TooLong));
        let full: Word = "1".repeat(64).parse().unwrap();
        assert_eq!((full.number(), full.part(0, 64), full.bit(false)), (u64::MAX, full, full));
        assert_eq!((full.number_low_first(), Word::new(5, 0).number()), (u64::MAX, 0));
    }
}
