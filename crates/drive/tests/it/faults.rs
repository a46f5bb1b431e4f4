//! Faults of the axis: the drive's answer and its reset.

use super::{Axis, CODE, at, enabled, read, until, usual, write};
use drive::{Abort, State};
use feedback::Failure;

/// A clamped load: the following error trips after its time, the axis is braked, the brake closes; reset needs the cause gone.
#[test]
fn a_blocked_load_trips_the_following_error() {
    let axis = usual();
    let mut drive = axis.drive();
    enabled(&mut drive, 1);
    write(&mut drive, 0x6065, 20_000);
    write(&mut drive, 0x607A, 3_000_000);
    write(&mut drive, 0x2010, 1);
    write(&mut drive, 0x6040, 0x1F);
    let steps = until(&mut drive, 4000, |drive| read(drive, 0x6041) & 0x2000 != 0);
    assert!(steps > 10);
    let wait = until(&mut drive, 100, |drive| drive.state() != State::OperationEnabled);
    assert!((20..=22).contains(&wait), "10 ms of 6066h: {wait}");
    assert_eq!((read(&drive, 0x603F), read(&drive, 0x1001)), (0x8611, 0b10_0001));
    assert_eq!(drive.take_emergencies(), [(0x8611, 0b10_0001)]);
    until(&mut drive, 4000, |drive| drive.state() == State::Fault);
    assert_eq!((read(&drive, 0x2003), read(&drive, 0x1003)), (1, 1));
    write(&mut drive, 0x2010, 0);
    write(&mut drive, 0x6040, 0x80);
    assert_eq!((drive.state(), drive.take_emergencies()), (State::SwitchOnDisabled, vec![(0, 0)]));
    // The list keeps what happened until a zero is written.
    assert_eq!(drive.read(drive::Address::new(0x1003, 1)).unwrap(), drive::Value::Number(0x8611));
    write(&mut drive, 0x1003, 0);
    assert_eq!(read(&drive, 0x1003), 0);
    enabled(&mut drive, 1);
}

/// A frozen angle is noticed within some milliseconds; while it lasts no reset helps.
#[test]
fn an_encoder_without_signal_is_a_fault_until_it_is_gone() {
    let axis = usual();
    let mut drive = axis.drive();
    enabled(&mut drive, 3);
    write(&mut drive, 0x60FF, 2_000_000);
    drive.advance(1000);
    write(&mut drive, 0x2010, 3);
    let steps = until(&mut drive, 40, |drive| drive.state() == State::Fault);
    assert!(steps <= 3 && !drive.reading().pulses, "{steps}");
    assert_eq!(read(&drive, 0x603F), 0x7305);
    write(&mut drive, 0x6040, 0x80);
    assert_eq!(drive.state(), State::Fault);
    write(&mut drive, 0x2010, 0);
    write(&mut drive, 0x6040, 0x00);
    drive.advance(10);
    write(&mut drive, 0x6040, 0x80);
    assert_eq!(drive.state(), State::SwitchOnDisabled);
}

/// The detecting check determines the code: resolver 7303h, tracks 7305h, words 7320h. At rest a lost track may remain
/// undetected.
#[test]
fn the_code_of_a_failed_encoder_follows_what_is_noticed() {
    for (code, failure, expected) in [
        ("CHA-14A-100-N-RES", Failure::Track, 0x7303),
        ("CHA-20A-100-H-C1024", Failure::Amplitude, 0x7305),
        ("CHA-20A-100-H-C1024", Failure::Track, 0x7305),
        (CODE, Failure::Check, 0x7320),
        (CODE, Failure::ErrorBit, 0x7320),
        ("CHA-17A-80-H-M128S-B", Failure::DataLine, 0x7320),
        ("CHA-14A-100-N-D2048", Failure::Track, 0x7305),
    ] {
        let axis = Axis { failure: Some(failure), ..Axis::of(code, 0.1, 0.0) };
        let mut drive = axis.drive();
        enabled(&mut drive, 3);
        write(&mut drive, 0x60FF, 2_000_000);
        drive.advance(1000);
        write(&mut drive, 0x2010, 3);
        until(&mut drive, 200, |drive| drive.state() == State::Fault);
        assert_eq!(read(&drive, 0x603F), expected, "{code} {failure:?}");
    }
    let axis = Axis { failure: Some(Failure::Track), ..Axis::of("CHA-14A-100-N-D2048", 0.1, 0.0) };
    let mut drive = axis.drive();
    write(&mut drive, 0x2010, 3);
    drive.advance(1000);
    assert_eq!(read(&drive, 0x603F), 0);
}

/// 605Eh: with 0 the axis coasts at once into the fault.
#[test]
fn the_reaction_follows_its_option() {
    let axis = Axis::of(CODE, 1.0, 0.0);
    for (option, then) in [(0, State::Fault), (1, State::FaultReactionActive), (2, State::FaultReactionActive)] {
        let mut drive = axis.drive();
        write(&mut drive, 0x605E, option);
        enabled(&mut drive, 3);
        write(&mut drive, 0x60FF, 2_000_000);
        drive.advance(800);
        drive.raise(drive::Trouble::Guarding);
        assert_eq!(drive.state(), then, "{option}");
    }
}

/// A blocked axis under full current: I²t trips.
#[test]
fn overload_trips() {
    let axis = usual();
    let mut drive = axis.drive();
    enabled(&mut drive, 3);
    write(&mut drive, 0x2010, 1);
    write(&mut drive, 0x60FF, 2_000_000);
    until(&mut drive, 400_000, |drive| drive.state() == State::Fault);
    assert_eq!((read(&drive, 0x603F), read(&drive, 0x2002) >= 1000), (0x2350, true));
    // Still too warm: it stays.
    write(&mut drive, 0x6040, 0x80);
    assert_eq!(drive.state(), State::Fault);
}

/// The current stays within 6073h.
#[test]
fn the_current_is_limited() {
    let axis = usual();
    let mut drive = axis.drive();
    write(&mut drive, 0x6073, 500);
    enabled(&mut drive, 3);
    write(&mut drive, 0x2010, 1);
    write(&mut drive, 0x60FF, 2_000_000);
    drive.advance(2000);
    let current = read(&drive, 0x6078);
    assert!((490..=510).contains(&current) && read(&drive, 0x6041) & 0x800 != 0, "{current}");
}

/// Manual 6.22: battery and supply fail together, then the reported position is wrong, and nothing says so. The turns begin at zero;
/// the angle within the turn stays.
#[test]
fn a_lost_battery_makes_the_position_wrong_and_no_fault() {
    // 128 periods of 256 increments a turn of the motor (table 59.1).
    let with = Axis::of("CHA-17A-80-H-M128S-B", 0.1, 0.0);
    let mut drive = with.drive();
    enabled(&mut drive, 1);
    let turn = 32_768;
    for target in [2 * turn + 10_000, -3 * turn - 10_000] {
        write(&mut drive, 0x607A, target);
        write(&mut drive, 0x6040, 0x1F);
        write(&mut drive, 0x6040, 0x0F);
        until(&mut drive, 20_000, |drive| read(drive, 0x6041) & 0x400 != 0 && read(drive, 0x6062) == target);
        assert_eq!(drive.write(at(0x2010), 4), Err(Abort::State), "torque is on");
        write(&mut drive, 0x6040, 0x00);
        drive.advance(400);
        let before = read(&drive, 0x6064);
        write(&mut drive, 0x2010, 4);
        drive.advance(4);
        assert_eq!((drive.state(), read(&drive, 0x603F)), (State::SwitchOnDisabled, 0));
        let after = read(&drive, 0x6064);
        // The count of the encoder falls while the position rises: 0 to −1 turn. The step of the noise may change.
        assert!((-turn - 2..=2).contains(&after) && (before - after) % turn == 0, "{before} {after}");
        enabled(&mut drive, 1);
    }
    assert_eq!(usual().drive().write(at(0x2010), 4), Err(Abort::Value), "M512P counts without one");
}
