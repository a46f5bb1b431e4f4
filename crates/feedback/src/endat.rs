//! `EnDat` 2.2: mode commands, position words, parameters, additional information and their checksum.

mod device;

pub use device::{Device, MANUFACTURER, Refused, Reply, Request, STATUS_ERROR};

use crate::Word;
use quantities::{Frequency, Measure, Time};

/// Bits of the checksum after each word.
pub const CRC_BITS: u32 = 5;

/// Returns the checksum of bits in the order of transmission.
///
/// x⁵ + x³ + x + 1, register preset to ones, result inverted
///
/// # Source
/// TI `endat_drv.c`, Esteves `endat_crc.c`; vectors in docs/theory/feedback.md
#[must_use]
#[allow(clippy::cast_possible_truncation, reason = "five bits are kept")]
pub fn crc(word: Word) -> u8 {
    // Bits in excess of a multiple of five are processed singly, the others five at a time.
    let single = word.len() % CRC_BITS;
    let begun = word.part(0, single).iter().fold(PRESET, shifted);
    let groups = (0..word.len() / CRC_BITS).rev();
    let register = groups.fold(begun, |register, group| {
        let bits = (word.number() >> (group * CRC_BITS)) as u8 & PRESET;
        FIVE.get(usize::from(register ^ bits)).copied().unwrap_or_default()
    });
    !register & PRESET
}

/// Register before the first bit: all ones.
const PRESET: u8 = 0b11111;

/// x⁵ + x³ + x + 1 without its highest power.
const POLYNOMIAL: u8 = 0b01011;

/// Returns the register after one bit.
const fn shifted(register: u8, bit: bool) -> u8 {
    let carries = (register >> 4 & 1 == 1) != bit;
    let moved = register << 1 & PRESET;
    if carries { moved ^ POLYNOMIAL } else { moved }
}

/// Register after five bits, indexed by the exclusive or of the register and the bits.
#[allow(clippy::indexing_slicing, reason = "evaluated by the compiler, which reports it")]
const FIVE: [u8; 32] = {
    let mut table = [0; 32];
    let mut at: u8 = 0;
    while at < 32 {
        let mut register = at;
        let mut bit = 0;
        while bit < CRC_BITS {
            register = shifted(register, false);
            bit += 1;
        }
        table[at as usize] = register;
        at += 1;
    }
    table
};

macro_rules! modes {
    ($($(#[$about:meta])* $name:ident = $bits:literal $id:literal, $errors:expr, $infos:literal;)*) => {
        /// A mode command of the subsequent electronics.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Mode {
            $($(#[$about])* $name,)*
        }

        impl Mode {
            /// The mode commands of both command sets.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];

            /// Returns the six bits of the command in the order of transmission.
            #[must_use]
            pub const fn word(self) -> Word {
                match self {
                    $(Self::$name => Word::new($bits, 6),)*
                }
            }

            /// Returns the identifier used in data exchange.
            #[must_use]
            pub const fn id(self) -> &'static str {
                match self {
                    $(Self::$name => $id,)*
                }
            }

            /// Returns the error bits of the position word that answers the command; `None` if the answer has no
            /// position.
            #[must_use]
            pub const fn errors(self) -> Option<ErrorBits> {
                match self {
                    $(Self::$name => $errors,)*
                }
            }

            /// Returns `true` if the command belongs to command set 2.2 only.
            #[must_use]
            pub const fn is_of_2_2(self) -> bool {
                match self {
                    $(Self::$name => $infos,)*
                }
            }
        }
    };
}

/// Error bits of a position word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorBits {
    /// F1, as in command set 2.1.
    One,
    /// F1 and F2, as in command set 2.2.
    Both,
}

impl ErrorBits {
    /// Returns the number of error bits.
    #[must_use]
    pub const fn count(self) -> u32 {
        match self {
            Self::One => 1,
            Self::Both => 2,
        }
    }
}

modes! {
    /// Position value.
    Position = 0b000_111 "position", Some(ErrorBits::One), false;
    /// Selects a memory area.
    SelectMemory = 0b001_110 "select_memory", None, false;
    /// Writes a parameter to the encoder.
    ReceiveParameter = 0b011_100 "receive_parameter", None, false;
    /// Reads a parameter from the encoder.
    SendParameter = 0b100_011 "send_parameter", None, false;
    /// Resets the encoder.
    Reset = 0b101_010 "reset", None, false;
    /// Reads test values.
    SendTest = 0b010_101 "send_test", None, false;
    /// Sends a test command.
    ReceiveTest = 0b110_001 "receive_test", None, false;
    /// Position with additional information.
    PositionInfo = 0b111_000 "position_info", Some(ErrorBits::Both), true;
    /// Position with additional information, then selects a memory area.
    PositionSelectMemory = 0b001_001 "position_select_memory", Some(ErrorBits::Both), true;
    /// Position with additional information, then writes a parameter.
    PositionReceiveParameter = 0b011_011 "position_receive_parameter", Some(ErrorBits::Both), true;
    /// Position with additional information, then requests a parameter.
    PositionSendParameter = 0b100_100 "position_send_parameter", Some(ErrorBits::Both), true;
    /// Position with additional information, then sends a test command.
    PositionReceiveTest = 0b110_110 "position_receive_test", Some(ErrorBits::Both), true;
    /// Position with additional information, then clears errors.
    PositionErrorReset = 0b101_101 "position_error_reset", Some(ErrorBits::Both), true;
    /// Communication commands of command set 2.2.
    Communication = 0b010_010 "communication", None, true;
}

impl Mode {
    /// Returns the command with these six bits.
    #[must_use]
    pub fn of(word: Word) -> Option<Self> {
        Self::ALL.iter().copied().find(|mode| mode.word() == word)
    }
}

/// Content of a position word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Position, turns above the steps of the turn.
    pub position: u64,
    /// The encoder reports an error.
    pub is_error: bool,
}

/// A fault of a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The word has the wrong length.
    Length {
        /// Bits found.
        found: u32,
        /// Bits expected.
        expected: u32,
    },
    /// The start bit has the wrong level.
    Start,
    /// F1 and F2 have the same level.
    ErrorBitsAlike,
    /// The checksum is wrong.
    Crc {
        /// Checksum in the word.
        found: u8,
        /// Checksum computed from the bits.
        expected: u8,
    },
}

impl Frame {
    /// Returns the number of bits of a word whose position has `width` bits, from start bit to checksum.
    #[must_use]
    pub const fn bits(width: u32, errors: ErrorBits) -> u32 {
        1 + errors.count() + width + CRC_BITS
    }

    /// Returns the word from start bit to checksum: start 1, F1, F2, position from its lowest bit, checksum without the
    /// start bit.
    ///
    /// # Source
    /// docs/theory/feedback.md; F1 is high and F2 low in case of an error
    #[must_use]
    pub fn word(self, width: u32, errors: ErrorBits) -> Word {
        let checked = match errors {
            ErrorBits::One => Word::empty().bit(self.is_error),
            ErrorBits::Both => Word::empty().bit(self.is_error).bit(!self.is_error),
        };
        started(true, checked.low_first(self.position, width))
    }

    /// Reads a position word.
    ///
    /// # Errors
    /// The faults of the word.
    pub fn read(word: Word, width: u32, errors: ErrorBits) -> Result<Self, Vec<Fault>> {
        let data = errors.count() + width;
        let body = body(word, true, data);
        let alike = errors == ErrorBits::Both && word.len() == Self::bits(width, errors) && {
            let bits = word.part(1, 2).number();
            bits == 0b00 || bits == 0b11
        };
        match (body, alike) {
            (Ok(body), false) => Ok(Self {
                is_error: body.part(0, 1).number() == 1,
                position: body.part(errors.count(), width).number_low_first(),
            }),
            (Ok(_), true) => Err(vec![Fault::ErrorBitsAlike]),
            (Err(mut faults), alike) => {
                faults.extend(alike.then_some(Fault::ErrorBitsAlike));
                Err(faults)
            }
        }
    }
}

/// Content of a word of parameters or additional information: eight and sixteen bits, most significant first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// Address, memory area, or status and acknowledgement of additional information.
    pub head: u8,
    /// Value of the parameter.
    pub value: u16,
}

/// Start bit of a word of parameters or additional information.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Opening {
    /// Parameter: start bit high.
    Parameter,
    /// Additional information: start bit low.
    Information,
}

impl Parameter {
    /// Bits of a word, from start bit to checksum.
    pub const BITS: u32 = 1 + 24 + CRC_BITS;

    /// Returns the word from start bit to checksum.
    #[must_use]
    pub fn word(self, opening: Opening) -> Word {
        let data = Word::empty().high_first(u64::from(self.head), 8).high_first(u64::from(self.value), 16);
        started(opening == Opening::Parameter, data)
    }

    /// Reads a word of parameters or additional information.
    ///
    /// # Errors
    /// The faults of the word.
    #[allow(clippy::cast_possible_truncation, reason = "of eight and sixteen bits")]
    pub fn read(word: Word, opening: Opening) -> Result<Self, Vec<Fault>> {
        let data = body(word, opening == Opening::Parameter, 24)?;
        Ok(Self { head: data.part(0, 8).number() as u8, value: data.part(8, 16).number() as u16 })
    }
}

/// Returns a word of start bit, data and checksum.
fn started(start: bool, data: Word) -> Word {
    Word::empty().bit(start).high_first(data.number(), data.len()).high_first(u64::from(crc(data)), CRC_BITS)
}

/// Returns the bits between start bit and checksum.
#[allow(clippy::cast_possible_truncation, reason = "five bits")]
fn body(word: Word, start: bool, data: u32) -> Result<Word, Vec<Fault>> {
    let expected = 1 + data + CRC_BITS;
    if word.len() != expected {
        return Err(vec![Fault::Length { found: word.len(), expected }]);
    }
    let mut faults = Vec::new();
    if (word.part(0, 1).number() == 1) != start {
        faults.push(Fault::Start);
    }
    let data = word.part(1, data);
    let (sent, computed) = (word.part(expected - CRC_BITS, CRC_BITS).number() as u8, crc(data));
    if sent != computed {
        faults.push(Fault::Crc { found: sent, expected: computed });
    }
    if faults.is_empty() { Ok(data) } else { Err(faults) }
}

/// Timing of the interface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timing {
    /// Clock frequency without compensation of the cable delay.
    pub clock: Frequency,
    /// Maximum calculation time until the position is ready.
    pub calculation: Time,
    /// Recovery time in which data stays high after the last word, minimum and maximum.
    pub recovery: [Time; 2],
}

impl Timing {
    /// Returns the timing of command set 2.1 ([`ErrorBits::One`]) or 2.2 ([`ErrorBits::Both`]).
    ///
    /// # Source
    /// Position within 5 µs, recovery 10 to 30 µs (2.1) and 1.25 to 3.75 µs (2.2): published for the interface in
    /// general (Beckhoff EL5031-0011 documentation); 1 MHz assumed. The manual states no values of the encoder itself
    #[must_use]
    pub fn published(errors: ErrorBits) -> Self {
        let recovery = match errors {
            ErrorBits::One => [10e-6, 30e-6],
            ErrorBits::Both => [1.25e-6, 3.75e-6],
        };
        Self { clock: Frequency::from_si(1e6), calculation: Time::from_si(5e-6), recovery: recovery.map(Time::from_si) }
    }
}
