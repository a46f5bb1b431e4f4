//! Whatever is written and sent: no panic, one of the eight states, numbers within their types.

use super::{read, usual};
use arbtest::arbitrary::{Result, Unstructured};
use drive::can::{CanNode, Frame};
use drive::line::{self, Time};
use drive::{Address, Drive, State, Value, socketcand};

const WORDS: [(State, i64, i64); 8] = [
    (State::NotReadyToSwitchOn, 0x4F, 0x00),
    (State::SwitchOnDisabled, 0x4F, 0x40),
    (State::ReadyToSwitchOn, 0x6F, 0x21),
    (State::SwitchedOn, 0x6F, 0x23),
    (State::OperationEnabled, 0x6F, 0x27),
    (State::QuickStopActive, 0x6F, 0x07),
    (State::FaultReactionActive, 0x4F, 0x0F),
    (State::Fault, 0x4F, 0x08),
];

fn holds(drive: &Drive<'_>) {
    let word = read(drive, 0x6041);
    let found: Vec<_> =
        WORDS.iter().filter(|(_, mask, value)| word & mask == *value).map(|(state, ..)| *state).collect();
    assert_eq!(found, [drive.state()], "{word:04X}");
    for entry in drive.entries() {
        if let Value::Number(number) = drive.read(entry.at).unwrap() {
            let [least, most] = entry.data_type.range();
            assert!((least..=most).contains(&number), "{:04X?} {number}", entry.at);
        }
    }
    assert!(drive.reading().position_rad.is_finite());
}

/// Returns a value that means something more often than chance would have it.
fn value(u: &mut Unstructured<'_>) -> Result<i64> {
    Ok(match u.int_in_range(0..=4)? {
        0 => i64::from(u.arbitrary::<u8>()?),
        1 => *u.choose(&[0x06, 0x07, 0x0F, 0x1F, 0x3F, 0x5F, 0x80, 0x10F, 0x02, 0x00])?,
        2 => i64::from(u.arbitrary::<i32>()?),
        3 => i64::from(u.arbitrary::<u32>()?),
        _ => u.arbitrary()?,
    })
}

#[test]
fn random_writes_leave_a_drive_in_one_of_its_states() {
    let axis = usual();
    let places: Vec<Address> = axis.drive().entries().map(|entry| entry.at).collect();
    let often = [0x6040, 0x6040, 0x6040, 0x6060, 0x607A, 0x60FF, 0x2010, 0x6081, 0x6083, 0x60C2, 0x605A];
    arbtest::arbtest(|u| {
        let mut drive = axis.drive();
        for _ in 0..u.int_in_range(1..=40)? {
            let place = match u.int_in_range(0..=3)? {
                0 => *u.choose(&places)?,
                1 => Address::new(u.arbitrary()?, u.arbitrary()?),
                _ => Address::new(*u.choose(&often)?, 0),
            };
            let before = drive.read(place);
            let value = value(u)?;
            if drive.write(place, value).is_err() && !drive.state().has_torque() {
                assert_eq!(drive.read(place), before, "what is refused changes nothing");
            }
            drive.advance(u.int_in_range(0..=60)?);
            holds(&drive);
        }
        Ok(())
    })
    .budget_ms(4000);
}

#[test]
fn random_frames_leave_a_node_whole() {
    let axis = usual();
    arbtest::arbtest(|u| {
        let mut node = CanNode::new(axis.drive(), 1, u.arbitrary()?);
        for _ in 0..u.int_in_range(1..=60)? {
            let id = match u.int_in_range(0..=5)? {
                0 => 0x000,
                1 => 0x080,
                2 => *u.choose(&[0x201, 0x301, 0x401, 0x501, 0x701])?,
                3 => u.arbitrary()?,
                _ => 0x601,
            };
            let mut data: [u8; 8] = u.arbitrary()?;
            if id == 0x601 && u.arbitrary()? {
                let index: u16 = *u.choose(&[0x6040, 0x6060, 0x1008, 0x1A00, 0x1800, 0x60C2, 0x607A])?;
                let [low, high] = index.to_le_bytes();
                (data[0], data[1], data[2]) = (*u.choose(&[0x40, 0x2B, 0x23, 0x2F, 0x60, 0x70, 0x80])?, low, high);
            }
            let length = u.int_in_range(0..=8)?;
            node.receive(&Frame::new(id, &data[..length]));
            node.advance(u.int_in_range(0..=20)?);
            assert!(node.take().iter().all(|frame| frame.data().len() <= 8 && frame.id() <= 0x7FF));
        }
        holds(node.drive());
        Ok(())
    })
    .budget_ms(3000);
}

#[test]
fn random_text_is_answered_or_refused() {
    let axis = usual();
    let mut drive = axis.drive();
    arbtest::arbtest(|u| {
        let words = [
            "read", "write", "step", "status", "time", "bye", "6040", "0x", "-1", "1e9", "NaN", "6091:1", ":",
            "\u{202e}",
        ];
        let line = if u.arbitrary()? {
            let count = u.int_in_range(0..=4)?;
            (0..count).map(|_| u.choose(&words).copied()).collect::<Result<Vec<_>>>()?.join(" ")
        } else {
            u.arbitrary::<String>()?
        };
        if let line::Answer::Line(answer) = line::answer(&mut drive, Time::Real, &line) {
            assert!(answer.is_ascii() && answer.len() < 400 && !answer.contains('\n'), "{answer}");
        }
        let bytes: Vec<u8> = u.arbitrary()?;
        if let Ok(Some((_, taken))) = socketcand::read(&bytes) {
            assert!(taken <= bytes.len());
        }
        Ok(())
    })
    .budget_ms(1500);
}
