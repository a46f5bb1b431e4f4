//! Words of EnDat against published vectors, and against every wrong bit.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use feedback::Word;
use feedback::endat::{ErrorBits, Fault, Frame, Mode, Opening, Parameter, crc};

/// Check of a position with F1 = 0, F1 = 1 and F1 F2 = 01: bit-serial form, TI `endat_drv.c` and Esteves `endat_crc.c` agree.
const POSITIONS: [(u32, u64, [u64; 3]); 6] = [
    (13, 0, [0b00101, 0b01101, 0b01000]),
    (13, 8191, [0b00100, 0b01100, 0b01001]),
    (25, 0, [0b00011, 0b00010, 0b01101]),
    (25, 1, [0b10110, 0b10111, 0b11000]),
    (25, 0x1AB_CDEF, [0b10100, 0b10101, 0b11010]),
    (25, 0x1FF_FFFF, [0b11100, 0b11101, 0b10010]),
];

#[test]
fn positions_have_the_published_check() {
    for (width, position, checks) in POSITIONS {
        let words = [(false, ErrorBits::One), (true, ErrorBits::One), (false, ErrorBits::Both)];
        for ((is_error, errors), check) in words.into_iter().zip(checks) {
            let frame = Frame { position, is_error };
            let word = frame.word(width, errors);
            assert_eq!(word.part(word.len() - 5, 5).number(), check, "{width} bits, {position:#x}");
            assert_eq!(Frame::read(word, width, errors), Ok(frame));
        }
    }
}

#[test]
fn parameters_have_the_published_check() {
    for (head, value, check) in [(0x0d_u64, 0x0019, 0b00101), (0xa1, 0x0000, 0b11100), (0xb9, 0xffff, 0b00001)] {
        let data = Word::new(head << 16 | value, 24);
        assert_eq!(crc(data), check);
    }
    let word = Parameter { head: 0x0d, value: 0x0019 }.word(Opening::Parameter);
    assert_eq!(word.to_string(), "100001101000000000001100100101");
}

/// The six bits of every command, as sent.
#[test]
fn commands_have_the_published_bits() {
    let published = [
        ("000111", Mode::Position),
        ("001110", Mode::SelectMemory),
        ("011100", Mode::ReceiveParameter),
        ("100011", Mode::SendParameter),
        ("101010", Mode::Reset),
        ("010101", Mode::SendTest),
        ("110001", Mode::ReceiveTest),
        ("111000", Mode::PositionInfo),
        ("001001", Mode::PositionSelectMemory),
        ("011011", Mode::PositionReceiveParameter),
        ("100100", Mode::PositionSendParameter),
        ("110110", Mode::PositionReceiveTest),
        ("101101", Mode::PositionErrorReset),
        ("010010", Mode::Communication),
    ];
    assert_eq!(published.len(), Mode::ALL.len());
    for (bits, mode) in published {
        assert_eq!(mode.word().to_string(), bits);
        assert_eq!(Mode::of(mode.word()), Some(mode));
    }
    assert_eq!(Mode::of(Word::new(0, 6)), None);
}

#[test]
fn every_single_wrong_bit_is_found() {
    for errors in [ErrorBits::One, ErrorBits::Both] {
        for width in [13, 25] {
            for position in [0, 1, 0xabc, (1 << width) - 1, 0x155_5555 & ((1 << width) - 1)] {
                for is_error in [false, true] {
                    let word = Frame { position, is_error }.word(width, errors);
                    for bit in 0..word.len() {
                        assert!(Frame::read(word.flipped(bit), width, errors).is_err(), "{word} bit {bit}");
                    }
                }
            }
        }
    }
    for opening in [Opening::Parameter, Opening::Information] {
        let word = Parameter { head: 0xa5, value: 0x1234 }.word(opening);
        assert!((0..word.len()).all(|bit| Parameter::read(word.flipped(bit), opening).is_err()));
    }
}

#[test]
fn all_that_is_wrong_is_named_at_once() {
    let good = Frame { position: 5, is_error: false }.word(25, ErrorBits::Both);
    let wrong = good.flipped(0).flipped(1);
    let faults = Frame::read(wrong, 25, ErrorBits::Both).unwrap_err();
    assert!(matches!(faults[..], [Fault::Start, Fault::Crc { .. }, Fault::ErrorBitsAlike]), "{faults:?}");
    let short = good.part(0, 32);
    assert_eq!(Frame::read(short, 25, ErrorBits::Both), Err(vec![Fault::Length { found: 32, expected: 33 }]));
}
