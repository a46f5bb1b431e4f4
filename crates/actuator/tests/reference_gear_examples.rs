//! Worked selection examples of gear makers: the cubic mean torque, the mean speed and the number of collisions.

use actuator::{collision_count_max, cubic_mean_torque};
use quantities::unit::REVOLUTION_PER_MINUTE;
use quantities::{Angle, AngularVelocity, Measure, Time, Torque};

/// Torque \[Nm\], speed [1/min], duration \[s\].
type Part = [f64; 3];

fn mean_torque(parts: &[Part]) -> f64 {
    let parts = parts.iter().map(|[torque, speed, time]| (Torque::from_si(*torque), Angle::from_si(speed * time)));
    cubic_mean_torque(parts).si()
}

fn mean_speed(parts: &[Part]) -> f64 {
    let sum = |of: fn(&Part) -> f64| parts.iter().map(of).sum::<f64>();
    sum(|[_, speed, time]| speed * time) / sum(|[_, _, time]| *time)
}

/// The selection example of the strain-wave gear catalogues: printed 319 Nm and 12 1/min, exactly 319.74 and 12.03.
#[test]
fn the_example_of_the_gear_catalogues() {
    let parts = [[400.0, 7.0, 0.3], [320.0, 14.0, 3.0], [200.0, 7.0, 0.4], [0.0, 0.0, 0.2]];
    assert!((mean_torque(&parts) - 319.74).abs() < 0.005, "{}", mean_torque(&parts));
    assert!((mean_speed(&parts) - 12.03).abs() < 0.005, "{}", mean_speed(&parts));
}

/// Honpine, "How to select a harmonic reduction gear": printed 89 Nm, exactly 89.4; 200 Nm for 0.15 s at 20 1/min with
/// i = 100 turn the wave generator five times, ten strains: 1000 collisions.
#[test]
fn the_example_of_honpine() {
    let parts = [[150.0, 10.0, 0.2], [82.0, 20.0, 3.0], [130.0, 10.0, 0.3], [0.0, 0.0, 0.2]];
    assert!((mean_torque(&parts) - 89.4).abs() < 0.05, "{}", mean_torque(&parts));
    let count =
        collision_count_max(1e4, AngularVelocity::new_in(20.0, &REVOLUTION_PER_MINUTE), 100.0, Time::from_si(0.15));
    assert!((count - 1000.0).abs() < 1e-9, "{count}");
}
