//! Scenarios, balance, determinism, bounds.

use super::{NOTHING, encoder, load, one_move, parameters, replaced};
use feedback::{Failure, Finding};
use mechanism::{Friction, Mechanism};
use motion::{Closing, Given, Law, Motion, SegmentSpec};
use quantities::{Measure, Time, Torque};
use twin::{EventKind, Fault, LoopResponse, Part, Reaction, Scenario, ScenarioId, Setup, Switches, Twin, settled};

const CODE: &str = "CHA-17A-80-H-M128S-B";

/// Every scenario to its end; of each the events.
#[test]
fn every_scenario_ends_and_its_balance_closes() {
    let (parameters, encoder) = (parameters(CODE), encoder(CODE));
    let (hanging, motion, extras) = (
        Mechanism { friction: Friction { external: Torque::from_si(3.0), ..Friction::none() }, ..load(0.3, 1.0) },
        one_move(30.0, 0.1, 0.3, 0.2),
        NOTHING(),
    );
    for id in ScenarioId::ALL {
        for reaction in Reaction::ALL {
            let scenario = Scenario { id, reaction, ..Scenario::default() };
            let encoder = Some(&encoder);
            let setup = Setup { scenario, encoder, ..Setup::of(&parameters, &hanging, &motion, &extras) };
            let mut twin = Twin::new(&setup).unwrap();
            twin.advance(u64::MAX);
            let summary = twin.summary();
            let through =
                summary.throughput_j.max(summary.energies.brake_j).max(summary.energies.flange_j.abs()).max(1e-3);
            assert!(
                summary.unaccounted_j.abs() < 1e-9 * through,
                "{}: {:e} of {through}",
                id.id(),
                summary.unaccounted_j
            );
            assert!(!twin.events().iter().any(|event| event.kind == EventKind::Diverged), "{}", id.id());
            let has = |kind| twin.events().iter().any(|event| event.kind == kind);
            match id {
                ScenarioId::PowerFailure => assert!(has(EventKind::BrakeClosedMoving) && summary.stop_s.is_some()),
                ScenarioId::HangingLoad => {
                    let at_rest = twin.events().iter().find(|event| event.kind == EventKind::AtRest).unwrap();
                    assert!(summary.stop_rad.unwrap() > 0.0 && has(EventKind::BrakeCloses));
                    assert!((at_rest.time_s - summary.stop_s.unwrap()).abs() < 1e-3, "{at_rest:?}");
                }
                ScenarioId::EncoderFailure => assert!(has(EventKind::NoPosition) && has(EventKind::PulsesOff)),
                ScenarioId::BatteryLoss => {
                    assert!(has(EventKind::TurnsLost) && !has(EventKind::NoPosition) && !has(EventKind::PulsesOff));
                }
                ScenarioId::BrakeStuck => assert!(has(EventKind::Limited) && has(EventKind::BrakeSlips)),
                ScenarioId::Collision | ScenarioId::BlockedLoad => assert!(has(EventKind::Limited)),
                ScenarioId::LinkSag => assert!(has(EventKind::Scenario) && summary.link_v[0] < 550.0, "{summary:?}"),
                ScenarioId::EmergencyStop => assert_eq!(has(EventKind::Ramp), reaction == Reaction::Ramp),
                ScenarioId::Cycle | ScenarioId::HotAmbient | ScenarioId::ColdGrease => {}
            }
        }
    }
}

/// The drive detects a word with a wrong checksum after its arrival, while the tracks still show the angle, and a lost
/// track within a turn of the motor, when the angle read is already wrong.
#[test]
fn a_failed_encoder_is_noticed_by_what_it_sends() {
    let (mechanism, motion, extras) = (load(0.3, 1.0), one_move(20.0, 0.1, 0.3, 0.2), NOTHING());
    let run = |code: &str, failure: Failure, at_s: Option<f64>| {
        let (parameters, encoder) = (parameters(code), encoder(code));
        let scenario = Scenario { id: ScenarioId::EncoderFailure, failure: Some(failure), at_s, ..Scenario::default() };
        let setup = Setup { scenario, encoder: Some(&encoder), ..Setup::of(&parameters, &mechanism, &motion, &extras) };
        let mut twin = Twin::new(&setup).unwrap();
        twin.advance(u64::MAX);
        let failed = twin.failed().unwrap();
        let has = twin.events().iter().any(|event| event.kind == EventKind::NoPosition);
        assert_eq!(failed.noticed.is_some(), has, "{code} {failure:?}");
        assert!(!twin.events().iter().any(|event| event.kind == EventKind::Diverged), "{code} {failure:?}");
        (failed, twin.summary())
    };
    let period = 1.0 / twin::CURRENT_RATE_HZ;
    let (failed, _) = run("CHA-25A-50-H-M512P", Failure::Check, None);
    let (finding, after) = failed.noticed.unwrap();
    assert_eq!(finding, Finding::Check);
    assert!(after > 53e-6 && after < 0.5e-3 + 3.0 * period && failed.error_rad.abs() < 1e-4, "{failed:?}");
    for code in ["CHA-20A-50-H-C1024", "CHA-14A-50-N-RES", "CHA-14A-50-N-D2048", CODE] {
        for failure in [Failure::Track, Failure::Cable] {
            let (failed, summary) = run(code, failure, None);
            let (_, after) = failed.noticed.unwrap_or_else(|| panic!("{code} {failure:?}"));
            assert!(after <= 60.0 / (20.0 * 50.0) && summary.stop_s.is_some(), "{code} {failure:?} {after}");
            if failure == Failure::Cable {
                assert!(after < 1.5 * period, "{code} {after}");
            }
        }
    }
    // Before the motion the axis stands: a square track that is lost shows nothing, and the axis follows its own wrong angle.
    let (failed, _) = run("CHA-14A-50-N-D2048", Failure::Track, Some(0.0));
    assert!(failed.noticed.is_some_and(|(finding, _)| finding == Finding::Commutation), "{failed:?}");
    let parameters = parameters(CODE);
    let refused = |failure, encoder| {
        let scenario = Scenario { id: ScenarioId::EncoderFailure, failure, ..Scenario::default() };
        Twin::new(&Setup { scenario, encoder, ..Setup::of(&parameters, &mechanism, &motion, &extras) }).err()
    };
    assert_eq!(refused(None, None), Some(Fault::NoEncoder));
    let ssi = encoder(CODE);
    let why = refused(Some(Failure::Check), Some(&ssi));
    let Some(Fault::NotOfThisEncoder { failure: Failure::Check, possible }) = why else { panic!("{why:?}") };
    let possible: Vec<Failure> = possible.into_iter().flatten().collect();
    assert_eq!(possible, [Failure::Track, Failure::Amplitude, Failure::Cable, Failure::DataLine]);
}

/// 2048 turns are lost at i = 80: 25.6 turns of the output, which the position loop then travels, as far as the run lasts.
#[test]
fn a_lost_battery_sends_the_axis_off() {
    let (parameters, encoder) = (parameters(CODE), encoder(CODE));
    let (mechanism, motion, extras) = (load(0.3, 1.0), one_move(20.0, 0.1, 0.3, 0.2), NOTHING());
    let scenario = Scenario { id: ScenarioId::BatteryLoss, ..Scenario::default() };
    let setup = Setup { scenario, encoder: Some(&encoder), ..Setup::of(&parameters, &mechanism, &motion, &extras) };
    let mut twin = Twin::new(&setup).unwrap();
    twin.advance(u64::MAX);
    let failed = twin.failed().unwrap();
    assert_eq!((failed.failure, failed.noticed), (None, None));
    let turn = std::f64::consts::TAU;
    assert!((failed.error_rad / turn + 25.6).abs() < 1.0 / 80.0 + 1e-9, "{failed:?}");
    let way = twin.sample().position_rad;
    assert!(way > 0.5 * turn && way < 25.6 * turn, "{way}");
}

/// Same setup, same bits, in steps of any size; another seed, another run.
#[test]
fn the_same_setup_gives_the_same_bits() {
    let mut parameters = parameters(CODE);
    parameters.model.current_noise.value = 0.02;
    let (mechanism, motion, extras) = (load(0.3, 1.0), one_move(30.0, 0.1, 0.1, 0.1), NOTHING());
    let run = |seed: u64, chunk: u64| {
        let mut twin = Twin::new(&Setup { seed, ..Setup::of(&parameters, &mechanism, &motion, &extras) }).unwrap();
        while !twin.is_over() {
            twin.advance(chunk);
        }
        twin.summary()
    };
    let one = run(7, 1);
    assert_eq!(one, run(7, 1000));
    assert_ne!(one, run(8, 1));
}

/// Friction holds an unbalanced load without a drift of a single bit, and the closed brake too.
#[test]
fn what_sticks_does_not_creep() {
    let parameters = parameters(CODE);
    let mechanism =
        Mechanism { friction: Friction { external: Torque::from_si(3.0), ..Friction::none() }, ..load(0.3, 0.0) };
    let dwell = motion::SegmentSpec::Dwell(quantities::Time::from_si(3.0), motion::Hold::Brake);
    let motion = motion::Motion::new(&[dwell], None, motion::Closing::SingleMove).unwrap();
    let extras = NOTHING();
    let mut twin = Twin::new(&Setup::of(&parameters, &mechanism, &motion, &extras)).unwrap();
    twin.advance(16_000);
    let before = twin.sample().motor_rad;
    twin.advance(16_000);
    assert_eq!(twin.sample().motor_rad.to_bits(), before.to_bits());
    assert!(twin.sample().braked && twin.sample().current_q_a == 0.0);
}

/// The default gains hold every loop of every size with and without a load.
#[test]
fn the_gains_of_the_rule_are_stable() {
    let (motion, extras) = (one_move(10.0, 0.1, 0.1, 0.1), NOTHING());
    for code in
        ["CHA-14A-50-H-RES", "CHA-17A-80-H-RES", "CHA-20A-100-H-C1024", "CHA-32A-100-H-C1024", "CHA-50A-100-H-C1024"]
    {
        let parameters = parameters(code);
        let own = parameters.actuator.inertia_out.known().unwrap().value.si();
        for factor in [0.1, 1.0, 3.0, 10.0] {
            let mechanism = load(factor * own, 0.0);
            let setup = Setup::of(&parameters, &mechanism, &motion, &extras);
            for each in LoopResponse::of(&setup).unwrap() {
                let margins = each.margins;
                assert!(margins.stable, "{code} {factor} {:?} {margins:?}", each.of);
                assert!(
                    margins.phase_rad.is_none_or(|phase| phase.to_degrees() > 25.0),
                    "{code} {factor} {:?} {margins:?}",
                    each.of
                );
            }
        }
    }
}

/// A simulation that is impossible is rejected with its reason.
#[test]
fn what_cannot_be_simulated_is_refused() {
    let with_brake = parameters(CODE);
    let without = parameters("CHA-20A-100-H-C1024");
    let (mechanism, motion, extras) = (load(0.3, 1.0), one_move(30.0, 0.1, 0.1, 0.1), NOTHING());
    let of = |parameters, mechanism, scenario| {
        Twin::new(&Setup { scenario, ..Setup::of(parameters, mechanism, &motion, &extras) }).err()
    };
    let scenario = |id, at_s| Scenario { id, at_s, ..Scenario::default() };
    assert_eq!(of(&without, &mechanism, scenario(ScenarioId::BrakeStuck, None)), Some(Fault::NoBrake));
    assert_eq!(of(&without, &mechanism, scenario(ScenarioId::BatteryLoss, None)), Some(Fault::NoBattery));
    assert_eq!(
        of(&with_brake, &mechanism, scenario(ScenarioId::EmergencyStop, Some(9.0))),
        Some(Fault::AfterTheEnd { end_s: 0.4 })
    );
    assert_eq!(of(&with_brake, &mechanism, scenario(ScenarioId::HangingLoad, Some(0.15))), Some(Fault::NotAtRest));
    assert_eq!(of(&with_brake, &mechanism, scenario(ScenarioId::Collision, Some(0.35))), Some(Fault::AtRest));
    let setup = Setup {
        substeps: 1,
        scenario: scenario(ScenarioId::BlockedLoad, None),
        ..Setup::of(&with_brake, &mechanism, &motion, &extras)
    };
    let light = load(1e-5, 0.0);
    let mut rigid = with_brake.clone();
    rigid.model.flange_inertia_share.value = 1e-6;
    let setup = Setup { mechanism: &light, parameters: &rigid, ..setup };
    let Some(Fault::StepTooLong { substeps }) = Twin::new(&setup).err() else { panic!("runs") };
    assert!(Twin::new(&Setup { substeps, ..setup }).is_ok());
    let mut bad = with_brake.clone();
    replaced(&mut bad.actuator.resistance_ll, f64::NAN);
    assert_eq!(of(&bad, &mechanism, Scenario::default()), Some(Fault::OutOfRange("resistance_ll")));
}

/// A datum that is not known is named; a run whose gains swing up without limits ends with a mark, and nothing hides it.
#[test]
fn what_is_missing_is_named_and_what_swings_up_is_marked() {
    let (mechanism, motion, extras) = (load(0.3, 1.0), one_move(30.0, 0.1, 0.3, 0.1), NOTHING());
    let mut without = parameters(CODE);
    without.actuator.inductance_ll = provenance::Datum::NotPrinted;
    let found = Twin::new(&Setup::of(&without, &mechanism, &motion, &extras)).err();
    assert!(matches!(found, Some(Fault::Missing(missing)) if missing.symbol == "L_LL"), "{found:?}");
    let parameters = parameters(CODE);
    let setup = Setup {
        switches: Switches { limits: false, ..Switches::default() },
        ..Setup::of(&parameters, &mechanism, &motion, &extras)
    };
    let usual = *Twin::new(&setup).unwrap().gains();
    for factor in [4.0, 1e3, 1e9] {
        let gains = Some(twin::Gains { current_p: factor * usual.current_p, ..usual });
        let mut twin = Twin::new(&Setup { gains, ..setup }).unwrap();
        let end = twin.periods();
        twin.advance(u64::MAX);
        assert!(twin.events().iter().any(|event| event.kind == EventKind::Diverged), "{factor}");
        assert!(twin.periods() < end, "{factor}");
    }
}

/// The settled temperatures are those at which one more cycle changes nothing.
#[test]
fn a_settled_cycle_stays_where_it_is() {
    let parameters = parameters("CHA-20A-100-H-C1024");
    let (mechanism, motion, extras) = (load(1.3, 5.0), one_move(30.0, 0.1, 0.3, 0.5), NOTHING());
    let setup = Setup { ambient_k: 303.15, ..Setup::of(&parameters, &mechanism, &motion, &extras) };
    let warm = settled(&setup, || true).unwrap().unwrap();
    assert!(warm[0] > warm[1] && warm[1] > 305.0, "{warm:?}");
    let mut twin =
        Twin::new(&Setup { start_k: Some(warm), scenario: Scenario { cycles: 20, ..Scenario::default() }, ..setup })
            .unwrap();
    twin.advance(u64::MAX);
    let summary = twin.summary();
    assert!((summary.housing_end_k - warm[1]).abs() < 0.1, "{summary:?} {warm:?}");
    assert!((summary.winding_end_k - warm[0]).abs() < 0.5, "{summary:?} {warm:?}");
    assert_eq!(settled(&setup, || false), Ok(None));
}

/// With every law of the model and all its kinks: half the step leaves a sixth of the balance open, or less.
#[test]
fn the_balance_closes_with_the_order_of_the_method() {
    let parameters = parameters("CHA-20A-100-H-C1024");
    let (mechanism, motion, extras) = (load(1.3, 5.0), one_move(30.0, 0.1, 0.3, 0.5), NOTHING());
    let switches = Switches { noise: false, ..Switches::default() };
    let open = |substeps: u32| {
        let setup = Setup { substeps, switches, ..Setup::of(&parameters, &mechanism, &motion, &extras) };
        let mut twin = Twin::new(&setup).unwrap();
        twin.advance(u64::MAX);
        (twin.summary().unaccounted_j / twin.summary().throughput_j).abs()
    };
    let open = [1, 2, 4, 8].map(open);
    for pair in open.windows(2) {
        assert!(pair[1] < pair[0] / 6.0, "{open:?}");
    }
    assert!(open[0] < 1e-8, "{open:?}");
}

/// Resident memory of the process in kB, where the system says it.
fn memory_kb() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find(|line| line.starts_with("VmRSS:"))?;
    line.split_whitespace().nth(1)?.parse().ok()
}

/// Cycles for hours: no drift, no NaN, no growing memory. The axis goes on in one direction, so that its angle grows too. A night
/// runs 24 hours (`ANTRIEB_TWIN_HOURS`), a push a minute.
#[test]
fn hours_of_cycles_do_not_drift() {
    let hours: f64 = std::env::var("ANTRIEB_TWIN_HOURS").map_or(1.0 / 60.0, |hours| hours.parse().unwrap());
    let parameters = parameters("CHA-20A-100-H-C1024");
    let (mechanism, motion, extras) = (load(1.3, 2.0), one_move(20.0, 0.1, 0.05, 0.1), NOTHING());
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count")]
    let cycles = (hours * 3600.0 / motion.duration().si()).round() as u32;
    let scenario = Scenario { cycles, ..Scenario::default() };
    let setup = Setup { ambient_k: 303.15, ..Setup::of(&parameters, &mechanism, &motion, &extras) };
    let start_k = settled(&setup, || true).unwrap();
    let mut twin = Twin::new(&Setup { scenario, start_k, ..setup }).unwrap();
    let quarter = twin.periods() / 4;
    twin.advance(quarter);
    let (early, memory) = (twin.summary(), memory_kb());
    twin.advance(u64::MAX);
    let (summary, now) = (twin.summary(), twin.sample());
    println!(
        "{:.2} h, {cycles} cycles, {:.1e} steps: {:e} of the throughput unaccounted, standing {:e} rad, following {:e} rad, memory {:?} to {:?} kB",
        twin.time_s() / 3600.0,
        twin.steps() as f64,
        summary.unaccounted_j / summary.throughput_j,
        now.following_rad,
        summary.following_rms_rad,
        memory,
        memory_kb()
    );
    assert!(
        summary.unaccounted_j.abs() < 1e-9 * summary.throughput_j,
        "{:e} {:e}",
        summary.unaccounted_j,
        summary.throughput_j
    );
    assert!(now.following_rad.abs() < 2e-3, "{now:?}");
    // The mean square of the following error and the mean current are those of the first quarter.
    for (whole, first) in
        [(summary.following_rms_rad, early.following_rms_rad), (summary.current_rms_a, early.current_rms_a)]
    {
        assert!((whole / first - 1.0).abs() < 5e-3, "{whole} {first}");
    }
    assert!((summary.housing_end_k - early.housing_end_k).abs() < 0.2, "{summary:?} {early:?}");
    assert!(twin.events().len() < 10, "{:?}", twin.events());
    if let Some((before, after)) = memory.zip(memory_kb()) {
        assert!(after < before + 2048.0, "{before} kB, {after} kB");
    }
}

/// A load with dry friction stands beside its set-point by the twist of the gear where the motor is controlled, and within the step
/// of the encoder (158″, table 68.1) where the output is; without such an encoder there is no run.
#[test]
fn a_loop_over_the_output_takes_the_twist_out() {
    let parameters = parameters("CHA-25A-100-H-C1024-EC");
    let (rubbing, motion, extras) = (load(1.0, 70.0), one_move(5.0, 0.2, 0.3, 3.0), NOTHING());
    let off = |loop_at_output: bool| {
        let switches = Switches { kinematic_error: false, ..Switches::default() };
        let setup = Setup { loop_at_output, switches, ..Setup::of(&parameters, &rubbing, &motion, &extras) };
        for each in LoopResponse::of(&setup).unwrap() {
            assert!(each.margins.stable, "{loop_at_output} {:?} {:?}", each.of, each.margins);
        }
        let mut twin = Twin::new(&setup).unwrap();
        twin.advance(u64::MAX);
        assert!(!twin.events().iter().any(|event| event.kind == EventKind::Diverged));
        twin.sample().following_rad.abs()
    };
    let (motor, output) = (off(false), off(true));
    let step = std::f64::consts::TAU / 8192.0;
    assert!(output < 0.75 * step && motor > 1.5 * step, "{motor} {output}");
    let bare = super::parameters(CODE);
    let setup = Setup { loop_at_output: true, ..Setup::of(&bare, &rubbing, &motion, &extras) };
    assert_eq!(Twin::new(&setup).unwrap_err(), Fault::NoOutputEncoder);
}

/// A part of a cycle runs as the whole cycle does there, after a run-up along the motion; one outside of it is refused.
#[test]
fn a_part_runs_as_the_whole_does_there() {
    let parameters = parameters("CHA-20A-100-H-C1024");
    let (mechanism, motion, extras) = (load(1.3, 5.0), one_move(30.0, 0.3, 0.6, 0.5), NOTHING());
    let switches = Switches { noise: false, ..Switches::default() };
    let whole = Setup { switches, ..Setup::of(&parameters, &mechanism, &motion, &extras) };
    let row_after = |setup: &Setup<'_>, periods: u64| {
        let mut twin = Twin::new(setup).unwrap();
        twin.advance(periods);
        twin.sample()
    };
    for (from_s, after_s) in [(0.35, 0.1), (0.5, 0.4), (0.0, 0.5)] {
        let part = Some(Part { from_s, for_s: 0.6 });
        let periods = |seconds: f64| (seconds * twin::CURRENT_RATE_HZ).round() as u64;
        let (of_whole, of_part) =
            (row_after(&whole, periods(from_s + after_s)), row_after(&Setup { part, ..whole }, periods(after_s)));
        // The kinematic error at the beginning is part of the offset between motor and setpoint.
        assert!((of_whole.position_rad - of_part.position_rad).abs() < 1e-4, "{of_whole:?} {of_part:?}");
        assert!(
            (of_whole.torque_nm - of_part.torque_nm).abs() < 0.05 * of_whole.torque_nm.abs() + 0.2,
            "{of_whole:?} {of_part:?}"
        );
    }
    for (from_s, for_s) in [(-0.1, 0.2), (0.0, 99.0), (0.5, 0.0), (f64::NAN, 1.0), (99.0, 0.1)] {
        let part = Some(Part { from_s, for_s });
        assert_eq!(Twin::new(&Setup { part, ..whole }).err(), Some(Fault::OutOfRange("part")), "{from_s} {for_s}");
    }
}

/// The drive brakes with the largest acceleration of the motion, by whatever law, if the largest current permits it; the set-point of
/// the stop follows this ramp, and the stopping angle is the largest distance from the place of the event.
#[test]
fn a_stop_has_the_steepest_ramp_of_the_motion_and_its_angle_is_an_excursion() {
    let parameters = parameters("CHA-25A-50-H-C1024");
    let (mechanism, extras) = (load(0.3, 1.0), NOTHING());
    for law in Law::ALL.iter().copied().filter(|law| *law != Law::Constant) {
        for slow in [1.0, 3.0] {
            let of = |distance: f64, time: f64| {
                let distance = Some(quantities::Angle::from_si(distance));
                SegmentSpec::Move(law, Given { distance, time: Some(Time::from_si(time)), ..Given::default() })
            };
            let Ok(motion) = Motion::new(&[of(1.6, 0.8), of(-1.6, 0.8 * slow)], None, Closing::Position) else {
                continue;
            };
            let steepest = (0..40_000)
                .filter_map(|k| {
                    let time = f64::from(k) * 1e-4;
                    let piece = motion.pieces().iter().rev().find(|piece| piece.start_s <= time)?;
                    (time - piece.start_s < piece.duration_s)
                        .then(|| piece.at(time - piece.start_s).acceleration_rad_s2.abs())
                })
                .fold(0.0, f64::max);
            let scenario = Scenario { id: ScenarioId::EmergencyStop, at_s: Some(0.4), ..Scenario::default() };
            let setup = Setup { scenario, ..Setup::of(&parameters, &mechanism, &motion, &extras) };
            let mut twin = Twin::new(&setup).unwrap();
            let ramp = twin.limits().ramp_rad_s2;
            assert!((ramp / steepest - 1.0).abs() < 1e-3, "{law:?} {slow}: {ramp} for {steepest}");
            let (mut place, mut farthest, mut ramped) = (None, 0.0_f64, 0);
            while twin.summary().stop_s.is_none() && twin.sample().time_s < 3.0 {
                twin.advance(8);
                let sample = twin.sample();
                if twin.events().iter().any(|event| event.kind == EventKind::Ramp) {
                    let from = *place.get_or_insert(sample.position_rad);
                    farthest = farthest.max((sample.position_rad - from).abs());
                    ramped += u32::from(sample.wanted_rad_s.abs() > 1e-3);
                }
            }
            let summary = twin.summary();
            assert!(
                (summary.stop_rad.unwrap() - farthest).abs() < 2e-3,
                "{law:?}: {:?} for {farthest}",
                summary.stop_rad
            );
            assert!(ramped > 10, "{law:?}: the set-point of the stop has a speed");
        }
    }
}
