//! `EnDat` 2.2: mode commands, position words, parameters, additional information, and their check.

mod device;

pub use device::{Device, MANUFACTURER, Refused, Reply, Request, STATUS_ERROR};

use crate::Word;
use quantities::{Frequency, Measure, Time};

/// Bits of the check behind every word.
pub const CRC_BITS: u32 = 5;

/// The check of bits in the order sent.
///
/// x⁵ + x³ + x + 1, register preset to ones, result inverted
///
/// # Source
/// TI `endat_drv.c`, Esteves `endat_crc.c`; vectors in docs/theory/feedback.md
#[must_use]
#[allow(clippy::cast_possible_truncation, reason = "five bits are kept")]
pub fn crc(word: Word) -> u8 {
    // The bits that fill no group of five one by one, then five at a time.
    let single = word.len() % CRC_BITS;
    let begun = word.part(0, single).iter().fold(PRESET, shifted);
    let groups = (0..word.len() / CRC_BITS).rev();
    let register = groups.fold(begun, |register, group| {
        let bits = (word.number() >> (group * CRC_BITS)) as u8 & PRESET;
        FIVE.get(usize::from(register ^ bits)).copied().unwrap_or_default()
    });
    !register & PRESET
}

/// The register before the first bit: ones.
const PRESET: u8 = 0b11111;

/// x⁵ + x³ + x + 1 without its highest power.
const POLYNOMIAL: u8 = 0b01011;

/// The register behind one bit.
const fn shifted(register: u8, bit: bool) -> u8 {
    let carries = (register >> 4 & 1 == 1) != bit;
    let moved = register << 1 & PRESET;
    if carries { moved ^ POLYNOMIAL } else { moved }
}

/// The register behind five bits, by its difference to them before.
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
        /// A mode command: what the electronics request.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Mode {
            $($(#[$about])* $name,)*
        }

        impl Mode {
            /// Every command.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];

            /// Its six bits in the order sent.
            #[must_use]
            pub const fn word(self) -> Word {
                match self {
                    $(Self::$name => Word::new($bits, 6),)*
                }
            }

            /// The identifier used in data exchange.
            #[must_use]
            pub const fn id(self) -> &'static str {
                match self {
                    $(Self::$name => $id,)*
                }
            }

            /// The error bits in its position word; `None` where it is answered without a position.
            #[must_use]
            pub const fn errors(self) -> Option<ErrorBits> {
                match self {
                    $(Self::$name => $errors,)*
                }
            }

            /// Whether it belongs to command set 2.2 alone.
            #[must_use]
            pub const fn is_of_2_2(self) -> bool {
                match self {
                    $(Self::$name => $infos,)*
                }
            }
        }
    };
}

/// The error bits of a position word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorBits {
    /// F1, as in command set 2.1.
    One,
    /// F1 and F2, as in command set 2.2.
    Both,
}

impl ErrorBits {
    /// How many.
    #[must_use]
    pub const fn count(self) -> u32 {
        match self {
            Self::One => 1,
            Self::Both => 2,
        }
    }
}

modes! {
    /// The position.
    Position = 0b000_111 "position", Some(ErrorBits::One), false;
    /// Selects a memory area.
    SelectMemory = 0b001_110 "select_memory", None, false;
    /// The encoder takes a parameter.
    ReceiveParameter = 0b011_100 "receive_parameter", None, false;
    /// The encoder sends a parameter.
    SendParameter = 0b100_011 "send_parameter", None, false;
    /// Reset.
    Reset = 0b101_010 "reset", None, false;
    /// The encoder sends test values.
    SendTest = 0b010_101 "send_test", None, false;
    /// The encoder takes a test command.
    ReceiveTest = 0b110_001 "receive_test", None, false;
    /// The position with additional information.
    PositionInfo = 0b111_000 "position_info", Some(ErrorBits::Both), true;
    /// The same, then a memory area is selected.
    PositionSelectMemory = 0b001_001 "position_select_memory", Some(ErrorBits::Both), true;
    /// The same, then the encoder takes a parameter.
    PositionReceiveParameter = 0b011_011 "position_receive_parameter", Some(ErrorBits::Both), true;
    /// The same, then the encoder prepares a parameter.
    PositionSendParameter = 0b100_100 "position_send_parameter", Some(ErrorBits::Both), true;
    /// The same, then the encoder takes a test command.
    PositionReceiveTest = 0b110_110 "position_receive_test", Some(ErrorBits::Both), true;
    /// The same, then errors are cleared.
    PositionErrorReset = 0b101_101 "position_error_reset", Some(ErrorBits::Both), true;
    /// Communication commands of 2.2.
    Communication = 0b010_010 "communication", None, true;
}

impl Mode {
    /// The command of six bits.
    #[must_use]
    pub fn of(word: Word) -> Option<Self> {
        Self::ALL.iter().copied().find(|mode| mode.word() == word)
    }
}

/// A position word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame {
    /// The position, turns above the steps of the turn.
    pub position: u64,
    /// Whether the encoder reports an error.
    pub is_error: bool,
}

/// What is wrong with a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// Its length.
    Length {
        /// Bits that it has.
        found: u32,
        /// Bits that it should have.
        expected: u32,
    },
    /// The start bit has the wrong level.
    Start,
    /// F1 and F2 are alike.
    ErrorBitsAlike,
    /// The check differs.
    Crc {
        /// The check in the word.
        found: u8,
        /// That of its bits.
        expected: u8,
    },
}

impl Frame {
    /// Bits of a word with a position of so many bits, from the start bit to the check.
    #[must_use]
    pub const fn bits(width: u32, errors: ErrorBits) -> u32 {
        1 + errors.count() + width + CRC_BITS
    }

    /// The word, from the start bit to the check: start 1, F1, F2, position from its lowest bit, check without the start bit.
    ///
    /// # Source
    /// docs/theory/feedback.md; F1 is high and F2 low for an error
    #[must_use]
    pub fn word(self, width: u32, errors: ErrorBits) -> Word {
        let checked = match errors {
            ErrorBits::One => Word::empty().bit(self.is_error),
            ErrorBits::Both => Word::empty().bit(self.is_error).bit(!self.is_error),
        };
        started(true, checked.low_first(self.position, width))
    }

    /// Reads a word.
    ///
    /// # Errors
    /// Everything that is wrong with it.
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

/// A word of parameters or additional information: eight bits and sixteen, highest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// Address, memory area, or the status and acknowledgement of additional information.
    pub head: u8,
    /// Its value.
    pub value: u16,
}

/// What a word of parameters or additional information begins with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Opening {
    /// A parameter: high.
    Parameter,
    /// Additional information: low.
    Information,
}

impl Parameter {
    /// Bits of a word.
    pub const BITS: u32 = 1 + 24 + CRC_BITS;

    /// The word.
    #[must_use]
    pub fn word(self, opening: Opening) -> Word {
        let data = Word::empty().high_first(u64::from(self.head), 8).high_first(u64::from(self.value), 16);
        started(opening == Opening::Parameter, data)
    }

    /// Reads a word.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    #[allow(clippy::cast_possible_truncation, reason = "of eight and sixteen bits")]
    pub fn read(word: Word, opening: Opening) -> Result<Self, Vec<Fault>> {
        let data = body(word, opening == Opening::Parameter, 24)?;
        Ok(Self { head: data.part(0, 8).number() as u8, value: data.part(8, 16).number() as u16 })
    }
}

/// A start bit, the bits, and their check.
fn started(start: bool, data: Word) -> Word {
    Word::empty().bit(start).high_first(data.number(), data.len()).high_first(u64::from(crc(data)), CRC_BITS)
}

/// The bits between start bit and check.
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

/// How fast an encoder answers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timing {
    /// Clock without compensation of the delay on the cable.
    pub clock: Frequency,
    /// Longest time until the position is ready.
    pub calculation: Time,
    /// Time for which data stays high behind the last word, shortest and longest.
    pub recovery: [Time; 2],
}

impl Timing {
    /// Of command set 2.1 and of 2.2.
    ///
    /// # Source
    /// Position within 5 µs, recovery 10 to 30 µs (2.1) and 1.25 to 3.75 µs (2.2): published for the interface in general (Beckhoff
    /// EL5031-0011 documentation); 1 MHz assumed. Those of the encoder itself are not printed
    #[must_use]
    pub fn usual(errors: ErrorBits) -> Self {
        let recovery = match errors {
            ErrorBits::One => [10e-6, 30e-6],
            ErrorBits::Both => [1.25e-6, 3.75e-6],
        };
        Self { clock: Frequency::from_si(1e6), calculation: Time::from_si(5e-6), recovery: recovery.map(Time::from_si) }
    }
}
