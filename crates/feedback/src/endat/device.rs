//! Simulation of an `EnDat` encoder that answers mode commands.

use super::{Frame, Mode, Opening, Parameter};
use crate::Word;
use std::collections::BTreeMap;

/// Memory areas of the manufacturer by their selection codes; they are read-only.
pub const MANUFACTURER: [u8; 3] = [0xa1, 0xa3, 0xa5];

/// Memory area of the operating status, and the address of the errors in it.
pub const STATUS_ERROR: (u8, u8) = (0xb9, 0x00);

/// Address of the number of clock pulses of a position word, in the first memory area of the manufacturer.
const CLOCK_PULSES: (u8, u8) = (0xa1, 0x0d);

/// A mode command with the data that follow it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Request {
    /// Mode command.
    pub mode: Mode,
    /// Code of a memory area, or an address; zero if the command has neither.
    pub head: u8,
    /// Value to write; zero if the command has none.
    pub value: u16,
}

/// Answer of an encoder.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Reply {
    /// Position word.
    pub position: Option<Word>,
    /// Words after or instead of the position: a parameter, additional information.
    pub further: Vec<Word>,
}

/// Reason for which a command is not answered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refused {
    /// A write to the memory of the manufacturer.
    ReadOnly,
    /// Test values and communication commands depend on manufacturer and type and are not published.
    NotPublished,
}

/// An encoder with an `EnDat` interface.
///
/// # Source
/// Commands and words: docs/theory/feedback.md
/// # Valid
/// Only the number of clock pulses is known of the manufacturer's memory (word 13 of area A1); other words read as zero
#[derive(Clone, Debug)]
pub struct Device {
    width: u32,
    area: u8,
    memory: BTreeMap<(u8, u8), u16>,
    is_error: bool,
    /// Additional information that follows each position of command set 2.2, once selected.
    information: Option<Parameter>,
}

impl Device {
    /// Creates an encoder whose position has `width` bits.
    #[must_use]
    pub fn new(width: u32) -> Self {
        let pulses = u16::try_from(width).unwrap_or(u16::MAX);
        Self {
            width,
            area: MANUFACTURER[0],
            memory: BTreeMap::from([(CLOCK_PULSES, pulses)]),
            is_error: false,
            information: None,
        }
    }

    /// Sets an error, which the encoder reports until it is reset.
    pub fn fail(&mut self) {
        self.is_error = true;
        self.memory.insert(STATUS_ERROR, 1);
    }

    fn clear(&mut self) {
        self.is_error = false;
        self.memory.remove(&STATUS_ERROR);
    }

    /// Answers a command at a position.
    ///
    /// # Errors
    /// The command has no answer; the encoder remains unchanged.
    pub fn answer(&mut self, request: Request, position: u64) -> Result<Reply, Refused> {
        let Request { mode, head, value } = request;
        let frame = Frame { position, is_error: self.is_error };
        let position = mode.errors().map(|errors| frame.word(self.width, errors));
        let mut further = Vec::new();
        if mode.is_of_2_2() {
            further.extend(self.information.map(|information| information.word(Opening::Information)));
        }
        let parameter = |head, value| Parameter { head, value }.word(Opening::Parameter);
        match mode {
            Mode::Position | Mode::PositionInfo => {}
            Mode::SelectMemory => {
                self.area = head;
                further.push(parameter(head, value));
            }
            Mode::ReceiveParameter => {
                self.write(head, value)?;
                further.push(parameter(head, value));
            }
            Mode::SendParameter => further.push(parameter(head, self.read(head))),
            Mode::Reset => {
                self.clear();
                further.push(parameter(head, value));
            }
            Mode::PositionSelectMemory => {
                self.area = head;
                self.information = Some(Parameter { head: 0, value: u16::from(head) << 8 });
            }
            Mode::PositionReceiveParameter => {
                self.write(head, value)?;
                self.information = Some(Parameter { head: 0, value });
            }
            Mode::PositionSendParameter => self.information = Some(Parameter { head: 0, value: self.read(head) }),
            Mode::PositionErrorReset => self.clear(),
            Mode::SendTest | Mode::ReceiveTest | Mode::PositionReceiveTest | Mode::Communication => {
                return Err(Refused::NotPublished);
            }
        }
        Ok(Reply { position, further })
    }

    fn read(&self, address: u8) -> u16 {
        self.memory.get(&(self.area, address)).copied().unwrap_or_default()
    }

    fn write(&mut self, address: u8, value: u16) -> Result<(), Refused> {
        if MANUFACTURER.contains(&self.area) {
            return Err(Refused::ReadOnly);
        }
        if (self.area, address) == STATUS_ERROR && value == 0 {
            self.is_error = false;
        }
        self.memory.insert((self.area, address), value);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::endat::ErrorBits;

    const fn request(mode: Mode, head: u8, value: u16) -> Request {
        Request { mode, head, value }
    }

    /// Word 13 of area A1 contains the number of clock pulses, 25 = 0x0019, with the checksum of
    /// docs/theory/feedback.md.
    #[test]
    fn the_clock_pulses_are_read_as_a_drive_does_at_start_up() {
        let mut device = Device::new(25);
        device.answer(request(Mode::SelectMemory, 0xa1, 0), 0).unwrap();
        let reply = device.answer(request(Mode::SendParameter, 0x0d, 0), 0).unwrap();
        assert_eq!(reply.position, None);
        assert_eq!(reply.further[0].to_string(), "1 00001101 0000000000011001 00101".replace(' ', ""));
    }

    #[test]
    fn an_error_stays_until_it_is_reset() {
        let mut device = Device::new(25);
        device.fail();
        let read = |device: &mut Device, mode| {
            let word = device.answer(request(mode, 0, 0), 77).unwrap().position.unwrap();
            Frame::read(word, 25, mode.errors().unwrap()).unwrap()
        };
        assert_eq!(read(&mut device, Mode::Position), Frame { position: 77, is_error: true });
        assert!(read(&mut device, Mode::PositionErrorReset).is_error);
        assert!(!read(&mut device, Mode::PositionInfo).is_error);
        device.fail();
        device.answer(request(Mode::Reset, 0, 0), 0).unwrap();
        assert!(!read(&mut device, Mode::Position).is_error);
    }

    /// Information selected by a command of set 2.2 follows the next position.
    #[test]
    fn additional_information_follows_the_next_position() {
        let mut device = Device::new(25);
        let first = device.answer(request(Mode::PositionSendParameter, 0x0d, 0), 5).unwrap();
        assert!(first.position.is_some() && first.further.is_empty());
        let next = device.answer(request(Mode::PositionInfo, 0, 0), 6).unwrap();
        assert_eq!(Frame::read(next.position.unwrap(), 25, ErrorBits::Both).unwrap().position, 6);
        assert_eq!(Parameter::read(next.further[0], Opening::Information).unwrap().value, 25);
    }

    #[test]
    fn the_memory_of_the_maker_is_read_only_and_the_other_keeps_what_is_written() {
        let mut device = Device::new(13);
        let write = request(Mode::ReceiveParameter, 0x01, 0xbeef);
        assert_eq!(device.answer(write, 0), Err(Refused::ReadOnly));
        device.answer(request(Mode::SelectMemory, 0xa9, 0), 0).unwrap();
        device.answer(write, 0).unwrap();
        let read = device.answer(request(Mode::SendParameter, 0x01, 0), 0).unwrap();
        assert_eq!(Parameter::read(read.further[0], Opening::Parameter).unwrap().value, 0xbeef);
        assert_eq!(device.answer(request(Mode::SendTest, 0, 0), 0), Err(Refused::NotPublished));
    }
}
