//! The modes of operation against the twin's own values.

use super::{Axis, CODE, at, enabled, read, until, usual, write};
use drive::Abort;
use std::f64::consts::TAU;

/// Increments of a turn of the output: 131 072 of the encoder (table 58.1), 100 turns.
const TURN: f64 = 13_107_200.0;

/// 10° of the output: the demand, the measured position and the load of the twin agree.
#[test]
fn a_move_of_profile_position_ends_where_the_twin_is() {
    let axis = usual();
    let mut drive = axis.drive();
    enabled(&mut drive, 1);
    let (target, speed, rate) = (364_089, 3_000_000, 30_000_000);
    for (index, value) in [(0x607A, target), (0x6081, speed), (0x6083, rate), (0x6084, rate)] {
        write(&mut drive, index, value);
    }
    write(&mut drive, 0x6040, 0x1F);
    assert_eq!(read(&drive, 0x6041) & 0x1000, 0x1000, "acknowledged");
    write(&mut drive, 0x6040, 0x0F);
    assert_eq!(read(&drive, 0x6041) & 0x1400, 0, "ready for the next, not reached");
    // s/v + v/a: 0.1214 + 0.1 s.
    let steps = until(&mut drive, 2000, |drive| read(drive, 0x6062) == target);
    assert!((steps as f64 * 0.5e-3 - 0.221_363).abs() < 1e-3, "{steps}");
    until(&mut drive, 400, |drive| read(drive, 0x6041) & 0x400 != 0);
    drive.advance(1000);
    let sample = drive.twin().sample();
    let wanted = target as f64 / TURN * TAU;
    // The load is beside the motor by hysteresis and kinematic error, and the encoder by its accuracy: 1' together.
    assert!((sample.position_rad - wanted).abs() < 3e-4, "{} {wanted}", sample.position_rad);
    assert!((sample.wanted_rad - wanted).abs() < 1e-9);
    let error = (read(&drive, 0x6064) - target).abs();
    assert!(error <= 300 && (read(&drive, 0x60F4)).abs() <= 300, "{error}");
}

/// Fast moves: set-points wait for the move to end or replace it; relative ones count from the last.
#[test]
fn set_points_wait_or_replace() {
    let axis = usual();
    let mut drive = axis.drive();
    enabled(&mut drive, 1);
    let start = |drive: &mut drive::Drive<'_>, target: i64, bits: i64| {
        write(drive, 0x607A, target);
        write(drive, 0x6040, 0x1F | bits);
        let acknowledged = read(drive, 0x6041) & 0x1000 != 0;
        write(drive, 0x6040, 0x0F);
        acknowledged
    };
    assert!(start(&mut drive, 400_000, 0));
    drive.advance(50);
    assert!(start(&mut drive, 100_000, 0), "one waits");
    assert_eq!(read(&drive, 0x6041) & 0x1000, 0x1000, "no room for another");
    write(&mut drive, 0x607A, 999_999);
    write(&mut drive, 0x6040, 0x1F);
    write(&mut drive, 0x6040, 0x0F);
    let highest = (0..4000).map(|_| (drive.advance(1), read(&drive, 0x6062)).1).max().unwrap();
    assert_eq!((highest, read(&drive, 0x6062)), (400_000, 100_000));
    assert!(start(&mut drive, 50_000, 0x40));
    until(&mut drive, 4000, |drive| read(drive, 0x6062) == 150_000);
    assert!(start(&mut drive, 900_000, 0));
    drive.advance(60);
    assert!(start(&mut drive, 0, 0x20), "at once");
    let highest = (0..6000).map(|_| (drive.advance(1), read(&drive, 0x6062)).1).max().unwrap();
    assert!(highest < 900_000 && read(&drive, 0x6062) == 0, "{highest}");
}

/// A halt stops the move, its end goes on with it; another disturbs nothing.
#[test]
fn a_halt_stops_and_its_end_goes_on() {
    let axis = usual();
    let mut drive = axis.drive();
    enabled(&mut drive, 1);
    write(&mut drive, 0x607A, 2_000_000);
    write(&mut drive, 0x6040, 0x1F);
    drive.advance(300);
    write(&mut drive, 0x6040, 0x11F);
    until(&mut drive, 2000, |drive| read(drive, 0x6041) & 0x400 != 0);
    let halted = read(&drive, 0x6062);
    assert!(halted > 0 && halted < 2_000_000);
    drive.advance(100);
    assert_eq!(read(&drive, 0x6062), halted);
    write(&mut drive, 0x6040, 0x1F);
    until(&mut drive, 8000, |drive| read(drive, 0x6062) == 2_000_000);
}

/// Speed of the twin at its set-point, ramped with the stated rate, both ways.
#[test]
fn profile_velocity_is_reached_along_its_ramp() {
    let axis = usual();
    let mut drive = axis.drive();
    enabled(&mut drive, 3);
    write(&mut drive, 0x6083, 10_000_000);
    write(&mut drive, 0x6084, 20_000_000);
    write(&mut drive, 0x60FF, 5_000_000);
    let steps = until(&mut drive, 4000, |drive| read(drive, 0x606B) == 5_000_000);
    assert!(steps.abs_diff(1000) <= 1, "{steps}");
    until(&mut drive, 400, |drive| read(drive, 0x6041) & 0x400 != 0);
    drive.advance(400);
    let speed = drive.twin().sample().motor_rad_s;
    assert!((speed / (5_000_000.0 / TURN * TAU) - 1.0).abs() < 2e-2, "{speed}");
    write(&mut drive, 0x60FF, -5_000_000);
    let steps = until(&mut drive, 4000, |drive| read(drive, 0x606B) == -5_000_000);
    assert!(steps.abs_diff(500 + 1000) <= 1, "{steps}");
    // What is too fast is bounded by 607Fh.
    write(&mut drive, 0x60FF, i64::from(i32::MAX));
    drive.advance(10_000);
    assert!((read(&drive, 0x606B) - read(&drive, 0x607F)).abs() <= 1);
}

/// Set-points each 2 ms along a sine: the axis follows them one period late.
#[test]
fn cyclic_positions_are_followed_a_period_late() {
    let axis = usual();
    let mut drive = axis.drive();
    drive.write(drive::Address::new(0x60C2, 1), 2).unwrap();
    enabled(&mut drive, 8);
    assert_eq!(read(&drive, 0x6041) & 0x1000, 0x1000);
    let point = |step: i32| (200_000.0 * (1.0 - (f64::from(step) * 2e-3 * TAU).cos())).round() as i64;
    let mut worst = 0;
    for step in 1..=500 {
        write(&mut drive, 0x607A, point(step));
        drive.advance(4);
        assert_eq!(read(&drive, 0x6062), point(step));
        worst = worst.max((read(&drive, 0x6064) - point(step)).abs());
    }
    // 3' of the output.
    assert!(worst < 2000, "{worst}");
    drive.advance(1000);
    assert_eq!((read(&drive, 0x6062), read(&drive, 0x6041) & 0x8), (point(500), 0));
    // Without new set-points it stands: the same one again moves nothing.
    write(&mut drive, 0x607A, point(500));
    drive.advance(10);
    assert_eq!(read(&drive, 0x6062), point(500));
}

/// Positive is the flange clockwise as the commissioning has it; without the bits of 607Eh it is the other way round.
#[test]
fn polarity_and_feed_scale_the_position() {
    let axis = usual();
    let mut drive = axis.drive();
    assert_eq!(read(&drive, 0x607E), 192);
    assert_eq!(drive.read(drive::Address::new(0x6092, 1)).unwrap(), drive::Value::Number(13_107_200));
    enabled(&mut drive, 1);
    write(&mut drive, 0x607A, 100_000);
    write(&mut drive, 0x6040, 0x1F);
    until(&mut drive, 4000, |drive| read(drive, 0x6041) & 0x400 != 0 && read(drive, 0x6062) == 100_000);
    assert!(drive.twin().sample().position_rad > 0.0);
    assert_eq!(drive.write(at(0x607E), 0), Err(Abort::State));
    write(&mut drive, 0x6040, 0x00);
    write(&mut drive, 0x607E, 0);
    let actual = read(&drive, 0x6064);
    assert!((actual + 100_000).abs() < 2000, "{actual}");
    // 360 000 to a turn: thousandths of a degree.
    drive.write(drive::Address::new(0x6092, 1), 360_000).unwrap();
    assert!((read(&drive, 0x6064) + 2747).abs() < 50);
}

/// A hanging load is held while the brake opens, and does not sag.
#[test]
fn a_load_does_not_sag_when_the_brake_opens() {
    let axis = Axis::of(CODE, 1.0, 20.0);
    let mut drive = axis.drive();
    let before = drive.twin().sample().position_rad;
    enabled(&mut drive, 1);
    drive.advance(1000);
    let after = drive.twin().sample().position_rad;
    assert!((after - before).abs() < 2e-4, "{before} {after}");
    assert!(read(&drive, 0x6077).abs() > 50, "{}", read(&drive, 0x6077));
}

/// 60F4h is demand less actual of one instant, at every instant and in every mode that follows a position; at constant speed it is the
/// error of the loop and not a period of it late.
#[test]
fn the_following_error_is_demand_less_actual() {
    let axis = usual();
    let mut drive = axis.drive();
    enabled(&mut drive, 1);
    let speed = read(&drive, 0x607F) / 2;
    write(&mut drive, 0x6081, speed);
    write(&mut drive, 0x607A, 4 * speed);
    write(&mut drive, 0x6040, 0x3F);
    let mut at_speed = Vec::new();
    for _ in 0..4000 {
        drive.advance(1);
        let error = read(&drive, 0x6062) - read(&drive, 0x6064);
        assert!((read(&drive, 0x60F4) - error).abs() <= 1, "{} {error}", read(&drive, 0x60F4));
        if (read(&drive, 0x606B) - speed).abs() < speed / 1000 {
            at_speed.push(error);
        }
    }
    let mean = at_speed.iter().sum::<i64>() as f64 / at_speed.len() as f64;
    // A period of the position loop at this speed.
    let period = speed as f64 * 0.5e-3;
    assert!(at_speed.len() > 1000 && mean.abs() < 0.1 * period, "{mean} {period}");
}
