//! Check, twin and commissioning judge the same axis by the same figures: DC link and I_0.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic, reason = "a test may fail")]

use crate::simulated;

use quantities::{Language, Measure};
use questions::{Verdict, check};
use simulated::simulated;

/// A move to and fro that gives energy back, on some supply.
fn axis(inertia: f64, speed: f64, supply: &str) -> String {
    format!(
        "format = 1\n[load]\ninertia = \"{inertia} kg m^2\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"40 deg\"\n\
         speed = \"{speed} 1/min\"\nacceleration = \"40 rad/s^2\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"-40 deg\"\n\
         speed = \"{speed} 1/min\"\nacceleration = \"40 rad/s^2\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"0.3 s\"\n\
         [requirements]\nambient = \"25 degC\"\n{supply}\n"
    )
}

/// Over windings and supplies: a supply above U_DCmax fails in both, one that leaves a resistor no threshold is advice in both, any other
/// passes in both and trips nothing; mains are judged at their largest voltage.
#[test]
fn dc_link_and_twin_agree_over_windings_and_supplies() {
    for (code, inertia, speed, supplies) in [
        (
            "CHA-20A-50-H-C1024",
            0.4,
            50.0,
            [
                ("supply = \"320 V\"", Verdict::Pass, 320.0),
                ("supply = \"591 V\"", Verdict::Pass, 591.0),
                ("supply = \"659 V\"", Verdict::Pass, 659.0),
                ("supply = \"661 V\"", Verdict::Advice, 661.0),
                ("supply = \"680 V\"", Verdict::Advice, 680.0),
                ("supply = \"681 V\"", Verdict::Fail, 681.0),
                ("mains = \"400 V\"", Verdict::Pass, 622.25),
                ("mains = \"400 V\"\nmains_deviation = 0.18", Verdict::Advice, 667.51),
                ("mains = \"480 V\"\nmains_deviation = 0.05", Verdict::Fail, 712.76),
            ],
        ),
        (
            "CHA-14A-50-E-RES",
            0.05,
            20.0,
            [
                ("supply = \"24 V\"", Verdict::Pass, 24.0),
                ("supply = \"36 V\"", Verdict::Pass, 36.0),
                ("supply = \"46 V\"", Verdict::Pass, 46.0),
                ("supply = \"46.6 V\"", Verdict::Advice, 46.6),
                ("supply = \"47 V\"", Verdict::Advice, 47.0),
                ("supply = \"48 V\"", Verdict::Advice, 48.0),
                ("supply = \"48.1 V\"", Verdict::Fail, 48.1),
                ("mains = \"28 V\"", Verdict::Pass, 43.56),
                ("mains = \"32 V\"", Verdict::Fail, 49.78),
            ],
        ),
    ] {
        for (supply, expected, most) in supplies {
            let text = axis(inertia, speed, supply);
            let project = questions::read(&text).unwrap();
            let judged = check(&project, &order_code::parse(code).unwrap().code).unwrap();
            let found = judged.judgement.checks.iter().find(|check| check.id.id() == "dc_link").unwrap();
            assert_eq!(found.verdict, expected, "{code} {supply}");
            assert!((found.value.unwrap().value() - most).abs() < 0.01, "{code} {supply}: {:?}", found.value);
            let (record, _) = simulated(&text, &[("code", code), ("cold", "true")]).unwrap();
            let verdicts = record["verdicts"].as_array().unwrap();
            let of = |id: &str| verdicts.iter().find(|row| row["id"] == id).unwrap();
            let link = of("link_high");
            let (verdict, value) = (link["verdict"].as_str().unwrap(), link["value"].as_f64().unwrap());
            // What is advice for any cycle is advice for this one where its link passes U_DCmax.
            let limit = link["limit"].as_f64().unwrap();
            let here = if expected == Verdict::Advice && value <= limit { Verdict::Pass } else { expected };
            assert_eq!(verdict, here.id(), "{code} {supply}: {link}");
            assert!(value > most && record["summary"]["energy_regenerated"]["value"].as_f64().unwrap() > 0.0, "{link}");
            assert_eq!(of("drive_faults")["value"], 0.0, "{code} {supply}: {:?}", record["events"]);
            let notes = record["notes"].to_string();
            assert_eq!(
                notes.contains("threshold of a braking resistor"),
                expected == Verdict::Advice,
                "{code} {supply}: {notes}"
            );
        }
    }
}

/// A 48 V winding at its printed supply, which check and twin both accept with their advice.
#[test]
fn a_winding_of_48_volt_runs_at_its_printed_supply() {
    let text = "format = 1\n[axis]\nname = \"x\"\n[load]\ninertia = \"0.3 kg m^2\"\nfriction_torque = \"0.5 N m\"\n\
        [[motion]]\nlaw = \"trapezoid\"\ndistance = \"90 deg\"\nspeed = \"20 1/min\"\nacceleration = \"10 rad/s^2\"\n\
        [[motion]]\nlaw = \"dwell\"\ntime = \"0.5 s\"\n[requirements]\nsupply = \"48 V\"\nambient = \"25 degC\"\n";
    let project = questions::read(text).unwrap();
    let code = "CHA-17A-50-E-RES";
    let judged = check(&project, &order_code::parse(code).unwrap().code).unwrap();
    assert!(judged.fits(), "{:?}", judged.judgement.worst_failure().map(|check| check.id));
    let (record, fits) = simulated(text, &[("code", code), ("cold", "true")]).unwrap();
    assert!(fits, "{} {}", record["verdicts"], record["events"]);
}

/// Held at rest, y = (I/I_0)² with I = T/k_Tout: the same I_0 in the check, in the twin's parameters, in p0318, 6075h and the plain list
/// of the commissioning, for every size, winding and ratio.
#[test]
fn one_stall_current_for_check_twin_and_commissioning() {
    use installation::commission::{ParameterId, cia402, commission, sinamics};
    let mut seen = std::collections::BTreeSet::new();
    for (code, _) in configurator::all() {
        let (Some(actuator), Some(about)) = (configurator::parameters(code), commission(code)) else { continue };
        if !seen.insert((code.size.to_string(), code.winding.to_string(), code.ratio.value())) {
            continue;
        }
        let stall = actuator.stall_current.known().unwrap().value.si();
        assert_eq!(about.get(ParameterId::StallCurrent).unwrap().si, stall, "{code}");
        let set = sinamics::lines(&about).into_iter().find(|line| line.entry.number == 318).unwrap().value;
        assert!((set / stall - 1.0).abs() < 1e-12, "{code}");
        let object = cia402::objects(&about).into_iter().find(|object| object.index == 0x6075).unwrap();
        assert!((f64::from(object.value) / 1000.0 / stall - 1.0).abs() < 1e-3, "{code}");
        let listed = twin::Parameters::of(&actuator).list();
        let of_the_twin = listed.iter().find(|each| each.key == "stall_current").unwrap().value.clone().unwrap();
        assert_eq!(of_the_twin.value, stall, "{code}");
        let torque = 0.5 * actuator.stall_torque.known().unwrap().value.si();
        let text = format!(
            "format = 1\n[load]\ninertia = \"0.3 kg m^2\"\nexternal_torque = \"{torque} N m\"\n\
             [[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\nhold = \"motor\"\n"
        );
        let project = questions::read(&text).unwrap_or_else(|faults| panic!("{faults:?}"));
        let judged = check(&project, code).unwrap();
        let found = judged.judgement.checks.iter().find(|check| check.id.id() == "overload_i2t").unwrap();
        let constant = actuator.torque_constant_out.known().unwrap().value.si();
        let wanted = (torque / constant / stall).powi(2);
        let value = found.value.unwrap().si;
        assert!((value / wanted - 1.0).abs() < 1e-6, "{code}: {value} {wanted}");
    }
    assert!(seen.len() >= 60, "{}", seen.len());
}

/// The hottest instant of the course has the temperature of the check on the winding, and its housing that of the note:
/// with and without a brake, whose coil heats the housing, in dwells held by motor or brake, for ratings with and
/// without published curves.
#[test]
fn the_course_is_as_hot_as_the_check() {
    let codes = [
        "CHA-14A-50-N-D2048",
        "CHA-17A-100-N-D2048",
        "CHA-20A-80-H-C1024",
        "CHA-20A-160-H-M512P",
        "CHA-32A-100-H-C1024",
    ];
    for code in codes {
        for (order, hold) in [("", ""), ("-B", ""), ("-B", "hold = \"brake\"\n")] {
            let text =
                axis(0.4, 20.0, "brake = true").replace("time = \"0.3 s\"\n", &format!("time = \"0.9 s\"\n{hold}"));
            let text = if order.is_empty() { text.replace("brake = true", "") } else { text };
            let project = questions::read(&text).unwrap();
            let code = questions::read_code(&format!("{code}{order}"), Language::En).unwrap().parsed.code;
            let candidate = check(&project, &code).unwrap();
            let judged =
                candidate.judgement.checks.iter().find(|check| check.id == questions::CheckId::Thermal).unwrap();
            let judged = judged.value.unwrap().si;
            let course = questions::course(&project, &candidate);
            let hottest = course.samples.iter().filter_map(|sample| sample.winding_k).fold(0.0, f64::max);
            let rise = judged - 298.15;
            assert!((hottest - judged).abs() < 2e-3 * rise, "{code:?} {order} {hold}: {hottest} of {judged}");
        }
    }
}

/// A brake that holds the dwell leaves the motor without current: S5; a motor that holds a weight is never without: S8.
#[test]
fn the_duty_type_knows_who_holds() {
    for (hold, expected) in
        [("", sizing::DutyType::HeldAtStandstill), ("hold = \"brake\"\n", sizing::DutyType::WithBraking)]
    {
        let text = format!(
            "format = 1\n[mechanism.arm]\ninertia = \"1 kg m^2\"\nmass = \"10 kg\"\ncentre_distance = \"0.1 m\"\naxis_tilt = \"90 deg\"\n\
             start_angle = \"0 deg\"\n[[motion]]\nlaw = \"modified_sine\"\ndistance = \"60 deg\"\ntime = \"0.5 s\"\n\
             [[motion]]\nlaw = \"dwell\"\ntime = \"0.9 s\"\n{hold}[[motion]]\nlaw = \"modified_sine\"\ndistance = \"-60 deg\"\n\
             time = \"0.5 s\"\n[requirements]\nbrake = true\n"
        );
        let project = questions::read(&text).unwrap();
        let code = questions::read_code("CHA-20A-100-H-C1024-B", Language::En).unwrap().parsed.code;
        let candidate = check(&project, &code).unwrap();
        let found = sizing::Operation::of(&project.axis, candidate.parameters).unwrap();
        assert_eq!(found.duty, expected, "{hold}");
    }
}

/// Slightly too fast, the excess is that of the speed: finite, the same wherever the cycle begins, and the nearest miss is
/// the actuator whose speed is exceeded least.
#[test]
fn above_the_end_of_the_curve_the_speed_governs() {
    let moves = [
        "[[motion]]\nlaw = \"trapezoid\"\ndistance = \"4 rev\"\nspeed = \"290 1/min\"\nacceleration = \"60 rad/s^2\"\n",
        "[[motion]]\nlaw = \"trapezoid\"\ndistance = \"-4 rev\"\nspeed = \"290 1/min\"\nacceleration = \"90 rad/s^2\"\n",
    ];
    let read = |order: [usize; 2]| {
        let text = format!("format = 1\n[load]\ninertia = \"0.02 kg m^2\"\n{}{}", moves[order[0]], moves[order[1]]);
        questions::read(&text).unwrap()
    };
    let code = questions::read_code("CHA-14A-30-N-D2048", Language::En).unwrap().parsed.code;
    let values = [[0, 1], [1, 0]].map(|order| {
        let project = read(order);
        let candidate = check(&project, &code).unwrap();
        let trace = candidate.judgement.checks.iter().find(|check| check.id == questions::CheckId::TorqueSpeedTrace);
        let trace = trace.unwrap();
        assert_eq!((trace.verdict, trace.limit.unwrap().si), (Verdict::Fail, 0.0));
        let speed = candidate.judgement.checks.iter().find(|check| check.id == questions::CheckId::PeakSpeed).unwrap();
        let (share, expected) = (trace.utilisation.unwrap(), speed.utilisation.unwrap());
        assert!((share - expected).abs() < 1e-9 && share > 1.0, "{share} {expected}");
        (trace.value.unwrap().si, candidate.standing.utilisation)
    });
    assert!((values[0].0 - values[1].0).abs() < 1e-9 && values[0].1.is_finite(), "{values:?}");
}
