//! The state machine: every transition of the profile.

use super::{Axis, CODE, enabled, read, until, usual, write};
use drive::{Command, Drive, State, Trouble, transition};

/// Masks and values of the statusword by state, as the profile prints them: another place than the bits of the code.
const PRINTED: [(State, i64, i64); 8] = [
    (State::NotReadyToSwitchOn, 0b100_1111, 0b000_0000),
    (State::SwitchOnDisabled, 0b100_1111, 0b100_0000),
    (State::ReadyToSwitchOn, 0b110_1111, 0b010_0001),
    (State::SwitchedOn, 0b110_1111, 0b010_0011),
    (State::OperationEnabled, 0b110_1111, 0b010_0111),
    (State::QuickStopActive, 0b110_1111, 0b000_0111),
    (State::FaultReactionActive, 0b100_1111, 0b000_1111),
    (State::Fault, 0b100_1111, 0b000_1000),
];

fn shown(drive: &Drive<'_>) -> State {
    let word = read(drive, 0x6041);
    let found: Vec<State> =
        PRINTED.iter().filter(|(_, mask, value)| word & mask == *value).map(|(state, ..)| *state).collect();
    assert_eq!(found.len(), 1, "{word:04X}");
    found[0]
}

#[test]
fn every_transition_of_a_command_is_that_of_the_profile() {
    use Command as C;
    use State as S;
    let expected = [
        (2, S::SwitchOnDisabled, C::Shutdown, S::ReadyToSwitchOn),
        (3, S::ReadyToSwitchOn, C::SwitchOn, S::SwitchedOn),
        (3, S::ReadyToSwitchOn, C::EnableOperation, S::SwitchedOn),
        (4, S::SwitchedOn, C::EnableOperation, S::OperationEnabled),
        (5, S::OperationEnabled, C::SwitchOn, S::SwitchedOn),
        (6, S::SwitchedOn, C::Shutdown, S::ReadyToSwitchOn),
        (7, S::ReadyToSwitchOn, C::DisableVoltage, S::SwitchOnDisabled),
        (7, S::ReadyToSwitchOn, C::QuickStop, S::SwitchOnDisabled),
        (8, S::OperationEnabled, C::Shutdown, S::ReadyToSwitchOn),
        (9, S::OperationEnabled, C::DisableVoltage, S::SwitchOnDisabled),
        (10, S::SwitchedOn, C::DisableVoltage, S::SwitchOnDisabled),
        (10, S::SwitchedOn, C::QuickStop, S::SwitchOnDisabled),
        (11, S::OperationEnabled, C::QuickStop, S::QuickStopActive),
        (12, S::QuickStopActive, C::DisableVoltage, S::SwitchOnDisabled),
        (16, S::QuickStopActive, C::EnableOperation, S::OperationEnabled),
    ];
    for state in State::ALL {
        for command in Command::ALL {
            let found = transition(*state, command).map(|found| (found.number, *state, command, found.to));
            let wanted = expected.iter().find(|(_, from, by, _)| (from, by) == (state, &command)).copied();
            assert_eq!(found, wanted, "{state:?} {command:?}");
        }
    }
}

/// Commands by their bits, those that do not matter set both ways.
#[test]
fn the_controlword_is_read_by_its_masks() {
    for control in 0..=u16::MAX {
        let expected = match control & 0x0F {
            0b0110 | 0b1110 => Command::Shutdown,
            0b0111 => Command::SwitchOn,
            0b1111 => Command::EnableOperation,
            0b0010 | 0b0011 | 0b1010 | 0b1011 => Command::QuickStop,
            _ => Command::DisableVoltage,
        };
        assert_eq!(Command::of(control), expected, "{control:04X}");
    }
}

/// The way of references.md: 0x250, 0x231, 0x233, 0x237.
#[test]
fn the_start_is_the_one_of_the_profile() {
    let axis = usual();
    let setup = twin::Setup::of(&axis.parameters, &axis.mechanism, &axis.motion, &axis.extras);
    let mut drive = Drive::new(&setup, &axis.given).unwrap();
    assert_eq!(shown(&drive), State::NotReadyToSwitchOn);
    drive.advance(1);
    assert_eq!(read(&drive, 0x6041), 0x250);
    for (control, word) in [(0x06, 0x231), (0x07, 0x233), (0x0F, 0x237)] {
        write(&mut drive, 0x6040, control);
        assert_eq!(read(&drive, 0x6041), word);
    }
}

/// A state behind another by a controlword, in the drive itself.
#[test]
fn the_drive_passes_from_state_to_state() {
    let axis = usual();
    // Shutdown and disable operation at once, a quick stop that holds.
    let at_once = [(0x605B, 0), (0x605C, 0), (0x605A, 6)];
    let cases: [(&[i64], State); 14] = [
        (&[0x06], State::ReadyToSwitchOn),
        (&[0x07], State::SwitchOnDisabled),
        (&[0x0F], State::SwitchOnDisabled),
        (&[0x06, 0x07], State::SwitchedOn),
        (&[0x06, 0x0F], State::OperationEnabled),
        (&[0x06, 0x07, 0x0F, 0x07], State::SwitchedOn),
        (&[0x06, 0x07, 0x06], State::ReadyToSwitchOn),
        (&[0x06, 0x02], State::SwitchOnDisabled),
        (&[0x06, 0x0F, 0x06], State::ReadyToSwitchOn),
        (&[0x06, 0x0F, 0x00], State::SwitchOnDisabled),
        (&[0x06, 0x07, 0x02], State::SwitchOnDisabled),
        (&[0x06, 0x0F, 0x02], State::QuickStopActive),
        (&[0x06, 0x0F, 0x02, 0x00], State::SwitchOnDisabled),
        (&[0x06, 0x0F, 0x02, 0x0F], State::OperationEnabled),
    ];
    for (controls, expected) in cases {
        let mut drive = axis.drive();
        for (index, value) in at_once {
            write(&mut drive, index, value);
        }
        for control in controls {
            write(&mut drive, 0x6040, *control);
        }
        assert_eq!((drive.state(), shown(&drive)), (expected, expected), "{controls:02X?}");
    }
}

/// 12 by itself: a quick stop from full speed ends in switch on disabled, slower with the slower ramp.
#[test]
fn a_quick_stop_brakes_and_ends_by_its_option() {
    let axis = usual();
    let mut times = Vec::new();
    for option in [0, 1, 2, 5, 6] {
        let mut drive = axis.drive();
        write(&mut drive, 0x605A, option);
        enabled(&mut drive, 3);
        let speed = read(&drive, 0x607F) / 2;
        write(&mut drive, 0x60FF, speed);
        until(&mut drive, 4000, |drive| (read(drive, 0x606C) - speed).abs() < speed / 100);
        write(&mut drive, 0x6040, 0x02);
        if option == 0 {
            assert_eq!(drive.state(), State::SwitchOnDisabled);
            continue;
        }
        assert_eq!(drive.state(), State::QuickStopActive);
        times.push(until(&mut drive, 4000, |drive| read(drive, 0x606C).abs() < speed / 200));
        let end = if option < 5 { State::SwitchOnDisabled } else { State::QuickStopActive };
        drive.advance(1000);
        assert_eq!((drive.state(), read(&drive, 0x2003)), (end, i64::from(option < 5)), "{option}");
    }
    let [slow, quick, slow_held, quick_held] = times[..] else { panic!("{times:?}") };
    assert!(slow == slow_held && quick == quick_held && quick * 3 < slow * 2, "{times:?}");
}

/// 5 with its option: the axis is braked, the brake closes, then the state changes.
#[test]
fn disable_operation_brakes_first() {
    let axis = usual();
    let mut drive = axis.drive();
    enabled(&mut drive, 3);
    let speed = read(&drive, 0x607F) / 4;
    write(&mut drive, 0x60FF, speed);
    drive.advance(2000);
    write(&mut drive, 0x6040, 0x07);
    assert_eq!(drive.state(), State::OperationEnabled);
    until(&mut drive, 4000, |drive| drive.state() == State::SwitchedOn);
    assert_eq!((read(&drive, 0x2003), read(&drive, 0x606C)), (1, 0));
    assert!(!drive.reading().pulses);
    // The command of before counts no more: back again by enable operation.
    write(&mut drive, 0x6040, 0x0F);
    assert_eq!(drive.state(), State::OperationEnabled);
}

/// 13 from every state, 14 by itself, 15 by a rising edge alone.
#[test]
fn a_fault_comes_from_every_state_and_is_reset_by_an_edge() {
    let axis = usual();
    for controls in [&[][..], &[0x06], &[0x06, 0x07], &[0x06, 0x0F], &[0x06, 0x0F, 0x02]] {
        let mut drive = axis.drive();
        for control in controls {
            write(&mut drive, 0x6040, *control);
        }
        let had_torque = drive.state().has_torque();
        drive.raise(Trouble::Guarding);
        let begun = if had_torque { State::FaultReactionActive } else { State::Fault };
        assert_eq!((drive.state(), shown(&drive)), (begun, begun), "{controls:02X?}");
        until(&mut drive, 4000, |drive| drive.state() == State::Fault);
        assert_eq!((read(&drive, 0x603F), read(&drive, 0x1001)), (0x8130, 0b1_0001));
        // No command leaves a fault.
        for control in [0x00, 0x06, 0x0F, 0x02] {
            write(&mut drive, 0x6040, control);
            assert_eq!(drive.state(), State::Fault);
        }
        write(&mut drive, 0x6040, 0x80);
        assert_eq!((drive.state(), read(&drive, 0x603F), read(&drive, 0x1001)), (State::SwitchOnDisabled, 0, 0));
        // The level that stays resets nothing.
        drive.raise(Trouble::Guarding);
        write(&mut drive, 0x6040, 0x80);
        assert_eq!(drive.state(), State::Fault);
    }
}

/// Without voltage in the DC link the drive is not switched on, and bit 4 says so.
#[test]
fn it_is_not_switched_on_without_voltage() {
    let axis = Axis::of(CODE, 1.0, 0.0);
    let mut drive = axis.drive();
    write(&mut drive, 0x2010, 5);
    // A current discharges the capacitor: enable, then the supply is gone.
    enabled(&mut drive, 3);
    let fastest = read(&drive, 0x607F);
    write(&mut drive, 0x60FF, fastest);
    until(&mut drive, 20_000, |drive| drive.state() == State::Fault);
    assert_eq!(read(&drive, 0x603F), 0x3220);
    drive.advance(4);
    write(&mut drive, 0x6040, 0x80);
    write(&mut drive, 0x6040, 0x06);
    write(&mut drive, 0x6040, 0x07);
    assert_eq!((drive.state(), read(&drive, 0x6041) & 0x10), (State::ReadyToSwitchOn, 0));
    write(&mut drive, 0x2010, 0);
    drive.advance(400);
    assert_eq!(drive.state(), State::SwitchedOn);
}

/// Bit 10 at a quick stop that holds: 0 while the axis slows down, 1 once it has come to rest, whatever was reached before; one that
/// switches off behind it never sets it. By the profile: *if quick stop option code is 5, 6, 7 or 8, this bit must be set, after the
/// quick stop operation is finished and the drive is halted*.
#[test]
fn a_quick_stop_that_holds_reports_the_rest() {
    let axis = usual();
    for mode in [1, 3, 8] {
        for option in [1, 2, 5, 6] {
            let mut drive = axis.drive();
            write(&mut drive, 0x605A, option);
            enabled(&mut drive, mode);
            let speed = read(&drive, 0x607F) / 2;
            match mode {
                3 => write(&mut drive, 0x60FF, speed),
                1 => {
                    write(&mut drive, 0x607A, 20 * speed);
                    write(&mut drive, 0x6040, 0x3F);
                }
                _ => {}
            }
            for k in 0..1200 {
                if mode == 8 && k % 20 == 0 {
                    // A period of 10 ms each, faster from one to the next.
                    let target = read(&drive, 0x6062) + speed / 100 * k.min(800) / 800;
                    write(&mut drive, 0x607A, target);
                }
                drive.advance(1);
            }
            assert!(read(&drive, 0x606C) > speed / 4, "{mode} {option} {} {speed}", read(&drive, 0x606C));
            write(&mut drive, 0x6040, 0x02);
            assert_eq!((drive.state(), read(&drive, 0x6041) & 0x400), (State::QuickStopActive, 0), "{mode} {option}");
            let mut rest = None;
            for step in 0..6000 {
                drive.advance(1);
                let (word, velocity) = (read(&drive, 0x6041), read(&drive, 0x606C));
                let bit = word & 0x400 != 0;
                assert!(!bit || velocity.abs() <= read(&drive, 0x606F), "{mode} {option} {step}");
                if bit && rest.is_none() {
                    rest = Some(step);
                }
            }
            assert_eq!(rest.is_some(), option > 4, "{mode} {option}");
            let end = if option > 4 { State::QuickStopActive } else { State::SwitchOnDisabled };
            assert_eq!((drive.state(), read(&drive, 0x6041) & 0x400 != 0), (end, option > 4), "{mode} {option}");
        }
    }
}

/// Bits 10 to 13 speak of an enabled drive alone: what was reached, cut or acknowledged is no property of one that is off, has a fault
/// or begins anew.
#[test]
fn no_bit_of_a_mode_outlives_its_operation() {
    let axis = usual();
    for mode in [1, 3, 8] {
        for end in [0x00, 0x06, 0x07, -1] {
            let mut drive = axis.drive();
            for index in [0x605B, 0x605C, 0x605E] {
                write(&mut drive, index, 0);
            }
            drive.write(drive::Address::new(0x607D, 1), -10_000).unwrap();
            drive.write(drive::Address::new(0x607D, 2), 10_000).unwrap();
            enabled(&mut drive, mode);
            write(&mut drive, 0x607A, 50_000);
            write(&mut drive, 0x6040, 0x3F);
            drive.advance(4000);
            if end < 0 {
                drive.raise(Trouble::Guarding);
            } else {
                write(&mut drive, 0x6040, end);
            }
            assert_ne!(drive.state(), State::OperationEnabled);
            drive.advance(10);
            // Bit 12 of profile velocity is the standstill, which is measured in any state.
            let of_the_mode = if mode == 3 { 0x2C00 } else { 0x3C00 };
            assert_eq!(read(&drive, 0x6041) & of_the_mode, 0, "{mode} {end} {:04X}", read(&drive, 0x6041));
        }
    }
}

/// The target velocity beyond what is permitted is cut, and bit 11 says so.
#[test]
fn a_target_velocity_that_is_cut_sets_the_limit() {
    let axis = usual();
    let mut drive = axis.drive();
    enabled(&mut drive, 3);
    let most = read(&drive, 0x607F);
    for (target, expected) in [(most, 0), (most / 2, 0), (most + most / 10, 0x800), (-most - most / 10, 0x800), (0, 0)]
    {
        write(&mut drive, 0x60FF, target);
        drive.advance(4000);
        assert_eq!(read(&drive, 0x6041) & 0x800, expected, "{target} of {most}");
    }
}
