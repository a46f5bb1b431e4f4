//! The course of a run: set-point and axis of one instant.

use super::{NOTHING, load, one_move, parameters, replaced};
use quantities::Measure;
use quantities::unit::REVOLUTION_PER_MINUTE;
use twin::{Gains, Setup, Supply, Switches, Twin};

/// q and ω of one move of the manual, by hand.
fn wanted(t: f64, speed: f64, ramp: f64, run: f64) -> (f64, f64) {
    let rate = speed / ramp;
    let (from_run, from_brake, from_rest) =
        (0.5 * speed * ramp, 0.5 * speed * ramp + speed * run, speed * (ramp + run));
    if t < ramp {
        (0.5 * rate * t * t, rate * t)
    } else if t < ramp + run {
        (from_run + speed * (t - ramp), speed)
    } else if t < 2.0 * ramp + run {
        let s = t - ramp - run;
        (from_brake + speed * s - 0.5 * rate * s * s, speed - rate * s)
    } else {
        (from_rest, 0.0)
    }
}

/// Whatever the time between two rows, between two periods of the position loop too: the set-point is that of the row.
#[test]
fn the_set_point_of_a_row_is_that_of_its_instant() {
    let (parameters, mechanism, extras) = (parameters("CHA-20A-100-H-C1024"), load(1.3, 2.0), NOTHING());
    let (ramp, run) = (0.1, 0.2);
    let motion = one_move(30.0, ramp, run, 0.1);
    let speed = REVOLUTION_PER_MINUTE.to_si(30.0);
    for every in [1, 3, 7, 16, 29] {
        let mut twin = Twin::new(&Setup::of(&parameters, &mechanism, &motion, &extras)).unwrap();
        while !twin.is_over() {
            twin.advance(every);
            let row = twin.sample();
            let (place, rate) = wanted(row.time_s, speed, ramp, run);
            assert!(
                (row.wanted_rad - place).abs() < 1e-12 && (row.wanted_rad_s - rate).abs() < 1e-9,
                "{every} {row:?}"
            );
            assert_eq!(row.following_rad, row.wanted_rad - row.position_rad);
        }
    }
}

/// Following error of every instant in the middle of a run at constant speed.
fn lags(feed_speed: f64, position_p: f64, rpm: f64) -> Vec<f64> {
    let (parameters, mechanism, extras) = (parameters("CHA-20A-100-H-C1024"), load(0.5, 0.0), NOTHING());
    let motion = one_move(rpm, 0.1, 3.0, 0.1);
    let setup = Setup { switches: Switches::none(), ..Setup::of(&parameters, &mechanism, &motion, &extras) };
    let usual: Gains = *Twin::new(&setup).unwrap().gains();
    let gains = Some(Gains { feed_speed, position_p, ..usual });
    let mut twin = Twin::new(&Setup { gains, ..setup }).unwrap();
    twin.advance(46_000);
    let mut found = Vec::new();
    while twin.time_s() < 3.0 {
        twin.advance(1);
        found.push(twin.sample().following_rad);
    }
    found
}

/// Without the speed fed forward the axis lags by v/K_v, with it by nothing, at every instant.
#[test]
fn the_lag_at_constant_speed_is_that_of_the_position_loop() {
    for (gain, rpm) in [(15.0, 20.0), (30.0, -10.0)] {
        let speed = REVOLUTION_PER_MINUTE.to_si(rpm);
        for lag in lags(0.0, gain, rpm) {
            assert!((lag / (speed / gain) - 1.0).abs() < 1e-5, "{gain} {rpm}: {lag}");
        }
        // Half a millisecond at this speed is a thousand times as much.
        for lag in lags(1.0, gain, rpm) {
            assert!(lag.abs() < 1e-3 * 0.5e-3 * speed.abs(), "{gain} {rpm}: {lag:e}");
        }
    }
}

/// I_0 of the I²t supervision is the printed one of the ratio, for every drivetrain: y = (I/I_0)² (1 − exp(−t/τ)).
#[test]
fn the_overload_is_related_to_the_stall_current_of_the_ratio() {
    use mechanism::{Friction, Mechanism};
    use motion::{Closing, Hold, Motion, SegmentSpec};
    use quantities::{Time, Torque};
    let motion =
        Motion::new(&[SegmentSpec::Dwell(Time::from_si(0.05), Hold::Motor)], None, Closing::SingleMove).unwrap();
    let switches =
        Switches { friction: false, hysteresis: false, kinematic_error: false, noise: false, ..Switches::default() };
    let (mut seen, extras) = (std::collections::BTreeSet::new(), NOTHING());
    for (code, _) in configurator::all() {
        let Some(actuator) = configurator::parameters(code) else { continue };
        if !seen.insert((code.size.to_string(), code.winding.to_string(), code.ratio.value())) {
            continue;
        }
        let mut parameters = twin::Parameters::of(&actuator);
        let tau = 0.5;
        replaced(&mut parameters.actuator.heat.winding_time_constant, tau);
        let torque = Torque::from_si(0.5 * actuator.stall_torque.known().unwrap().value.si());
        let friction = Friction { external: torque, ..Friction::none() };
        let mechanism = Mechanism { friction, ..load(0.5, 0.0) };
        let limit = actuator.dc_link_max.known().unwrap().value.si();
        let supply = Supply::of(limit.min(560.0));
        let mut twin =
            Twin::new(&Setup { switches, supply, ..Setup::of(&parameters, &mechanism, &motion, &extras) }).unwrap();
        let current = twin.sample().current_q_a / std::f64::consts::SQRT_2;
        twin.advance(u64::MAX);
        let printed = actuator.stall_current.known().unwrap().value.si();
        let wanted = (current / printed).powi(2) * -(-twin.time_s() / tau).exp_m1();
        let found = twin.summary().overload_peak;
        assert!((found / wanted - 1.0).abs() < 2e-3, "{code}: {found} {wanted}");
    }
    assert!(seen.len() >= 60, "{}", seen.len());
}
