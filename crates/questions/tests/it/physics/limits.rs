//! Equal to a limit: no verdict hangs on rounding, in the check, in the sweep over the catalogue and under tolerances.

use crate::physics::{of, read};
use questions::{CheckId, Verdict, check, size};

const CODE: &str = "CHA-25A-50-H-C1024";

/// Keys that state a limit, with the unit in SI.
const LIMITS: [(CheckId, &str, &str); 9] = [
    (CheckId::Torsion, "torsion_max", "rad"),
    (CheckId::NaturalFrequency, "natural_frequency_min", "Hz"),
    (CheckId::BearingLife, "bearing_life_min", "s"),
    (CheckId::GearLife, "gear_life_min", "s"),
    (CheckId::TiltAngle, "tilt_angle_max", "rad"),
    (CheckId::ErrorBudget, "angle_error_max", "rad"),
    (CheckId::Regeneration, "regeneration_power_max", "W"),
    (CheckId::FeedbackResolution, "resolution_max", "rad"),
    (CheckId::BrakeEmergency, "stop_angle_max", "rad"),
];

fn project(requirements: &str) -> String {
    format!(
        "format = 1\n[load]\ninertia = \"0.9 kg m^2\"\nfriction_torque = \"4 N m\"\n\
         [[motion]]\nlaw = \"trapezoid\"\ndistance = \"77 deg\"\ntime = \"0.7 s\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"0.5 s\"\n\
         [[motion]]\nlaw = \"polynomial_5\"\ndistance = \"-77 deg\"\ntime = \"0.9 s\"\n\
         [bearing]\nradial_force = \"333 N\"\nradial_distance = \"57 mm\"\naxial_force = \"71 N\"\naxial_distance = \"13 mm\"\n\
         load_factor = 1.3\noperating_condition = \"normal\"\n[requirements]\nsupply = \"560 V\"\n{requirements}"
    )
}

/// A stated value passes at the limit and a billionth of rounding beside it, and fails a millionth beyond.
#[test]
fn a_stated_limit_is_kept_up_to_rounding() {
    for (id, key, unit) in LIMITS {
        let code = if id == CheckId::BrakeEmergency { "CHA-25A-50-H-C1024-B" } else { CODE };
        let value = of(&read(&project("")), code, id).value.unwrap_or_else(|| panic!("{id:?}")).si;
        let verdict = |share: f64| {
            let text = project(&format!("{key} = \"{} {unit}\"\n", value * share));
            let found = of(&read(&text), code, id);
            assert_eq!(found.verdict == Verdict::Pass, found.utilisation.unwrap() <= 1.0, "{id:?}");
            (found.verdict, found.relation().unwrap())
        };
        let at_least = key.ends_with("_min");
        for share in [1.0, 1.0 + 1e-12, 1.0 - 1e-12] {
            let sign = if at_least { "≥" } else { "≤" };
            assert_eq!(verdict(share), (Verdict::Pass, sign), "{key} {share}");
        }
        let (inside, beyond) = if at_least { (1.0 - 1e-6, 1.0 + 1e-6) } else { (1.0 + 1e-6, 1.0 - 1e-6) };
        assert_eq!(verdict(inside).0, Verdict::Pass, "{key}");
        assert_eq!(verdict(beyond), (Verdict::Fail, if at_least { "<" } else { ">" }), "{key}");
    }
}

/// Data of an actuator against the demand: the same, in each check that compares with one of them.
#[test]
fn a_datum_is_kept_up_to_rounding() {
    const OWN: &str = "[actuator]\nname = \"own\"\nratio = 50\ninertia_out = \"1.063 kg m^2\"\ntorque_constant_out = \"22 N m/A\"\n\
        torque_constant_motor = \"0.45 N m/A\"\nno_load_starting_current = \"0.4 A\"\nno_load_current_constant_30 = \"4e-3 A/min^-1\"\n\
        no_load_current_constant_80 = \"2e-3 A/min^-1\"\nresistance_ll = \"1.2 ohm\"\nvoltage_constant_motor = \"48 V/1000 1/min\"\n\
        inductance_ll = \"3 mH\"\npole_pairs = 5\nstall_torque = \"5 N m\"\nstall_current = \"0.3 A\"\n";
    let own = |more: &str| {
        let found = questions::read(&format!("{}{OWN}{more}", project("")));
        let project = found.unwrap_or_else(|faults| panic!("{faults:?}"));
        let own = questions::check_own(&project).unwrap();
        own.judgement.checks
    };
    for (id, key, unit) in [
        (CheckId::PeakTorque, "torque_max", "N m"),
        (CheckId::PeakSpeed, "speed_max", "rad/s"),
        (CheckId::PeakCurrent, "current_max", "A"),
        (CheckId::Demagnetisation, "current_demagnetisation", "A"),
        (CheckId::DcLink, "dc_link_max", "V"),
    ] {
        let of = |limit: f64| {
            let checks = own(&format!("{key} = \"{limit} {unit}\"\n"));
            checks.iter().find(|check| check.id == id).cloned().unwrap_or_else(|| panic!("{id:?}"))
        };
        let value = of(1e4).value.unwrap_or_else(|| panic!("{id:?}")).si;
        for share in [1.0, 1.0 + 1e-12, 1.0 - 1e-12, 1.0 + 1e-6] {
            // A remark may make advice of it.
            let check = of(value * share);
            assert!(check.verdict != Verdict::Fail && check.utilisation.unwrap() <= 1.0, "{id:?} {share}: {check:?}");
        }
        let check = of(value * (1.0 - 1e-6));
        assert!(check.verdict == Verdict::Fail && check.relation() == Some(">"), "{id:?}: {check:?}");
    }
}

/// The peak speed of a planner with sixteen digits, 18.75 1/min of CHA-58A-160, alone and among all.
#[test]
fn sixteen_digits_of_a_limit_fit() {
    let text = "format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"0.4 kg m^2\"\n[[motion]]\nlaw = \"trapezoid\"\n\
                distance = \"360 deg\"\nspeed = \"1.963495408493621 rad/s\"\nacceleration = \"10 rad/s^2\"\n";
    let project = read(text);
    let check = of(&project, "CHA-58A-160-H-C1024", CheckId::PeakSpeed);
    assert!(
        check.verdict == Verdict::Pass && check.relation() == Some("≤") && check.utilisation == Some(1.0),
        "{check:?}"
    );
    let speed = |each: &questions::Candidate<'_>| {
        each.judgement.checks.iter().find(|check| check.id == CheckId::PeakSpeed).cloned()
    };
    let at_it =
        |check: &sizing::Check| check.limit.is_some_and(|limit| (limit.si - 1.963_495_408_493_620_7).abs() < 1e-9);
    let all: Vec<_> = size(&project).candidates.iter().filter_map(speed).filter(at_it).collect();
    assert!(!all.is_empty() && all.iter().all(|check| check.verdict == Verdict::Pass), "{all:?}");
}

/// The mean speed exactly at n_N/i, 70 1/min of CHA-25A-50, and a slider-crank that goes round at it, for any time.
#[test]
fn the_rated_speed_is_no_more_than_the_rated_speed() {
    let crank =
        "[mechanism.slider_crank]\ncrank = \"20 mm\"\nrod = \"80 mm\"\nmass = \"0.5 kg\"\nstart_angle = \"0 deg\"\n";
    let load = "[load]\ninertia = \"0.1 kg m^2\"\n";
    for mechanism in [load, crank] {
        for time in ["2", "2.4", "3", "0.7", "11.3", "60"] {
            let text = format!(
                "format = 1\n[axis]\nsingle_move = true\n{mechanism}[[motion]]\nlaw = \"constant\"\nspeed = \"70 1/min\"\ntime = \"{time} s\"\n"
            );
            let check = of(&read(&text), CODE, CheckId::MeanSpeed);
            assert_eq!(check.verdict, Verdict::Pass, "{time}: {check:?}");
        }
    }
}

/// Requirements on length, mass and bore that are the actuator's own figures are met.
#[test]
fn an_own_figure_meets_the_requirement() {
    let plain = read(&project(""));
    let code = order_code::parse(CODE).unwrap().code;
    let candidate = check(&plain, &code).unwrap();
    let parameters = candidate.parameters;
    let of = |datum: Option<f64>| datum.unwrap();
    let length = of(parameters.length.known().map(|known| quantities::Measure::si(known.value)));
    let mass = of(parameters.mass.known().map(|known| quantities::Measure::si(known.value)));
    let bore = of(parameters.hollow_shaft.known().map(|known| quantities::Measure::si(known.value)));
    let unmet = |share: f64| {
        let text = project(&format!(
            "length_max = \"{} m\"\nmass_max = \"{} kg\"\nhollow_shaft_min = \"{} m\"\n",
            length * share,
            mass * share,
            bore / share
        ));
        check(&read(&text), &code).unwrap().objections.len()
    };
    for share in [1.0, 1.0 - 1e-12, 1.0 + 1e-12, 1.0 + 1e-6] {
        assert_eq!(unmet(share), 0, "{share}");
    }
    assert_eq!(unmet(1.0 - 1e-6), 3);
}
