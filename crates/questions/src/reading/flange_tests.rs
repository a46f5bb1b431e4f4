//! Loads on the flange out of project files: what is read, what is refused, and what the checks say.

use crate::{CheckId, Verdict, check, size};
use axis::AxisProject;
use quantities::Language;
use sizing::{Check, Checks};

const ARM: &str = r#"format = 1
[mechanism.arm]
inertia = "0.42 kg m^2"
mass = "5 kg"
centre_distance = "180 mm"
payload_distance = "420 mm"
axis_tilt = "90 deg"
start_angle = "-60 deg"
[[motion]]
law = "modified_sine"
distance = "120 deg"
time = "0.9 s"
PAYLOAD
[[motion]]
law = "modified_sine"
distance = "-120 deg"
time = "0.9 s"
SEGMENT
[bearing]
load_factor = 1.2
operating_condition = "normal"
BEARING
[requirements]
bearing_life_min = "1000 h"
tilt_angle_max = "2 arcmin"
"#;

fn text(payload: &str, segment: &str, bearing: &str) -> String {
    ARM.replace("PAYLOAD", payload).replace("SEGMENT", segment).replace("BEARING", bearing)
}

fn read(text: &str) -> AxisProject {
    crate::read(text).unwrap_or_else(|faults| panic!("{faults:?}"))
}

fn messages(text: &str) -> Vec<String> {
    let faults = words::worded(&crate::read(text).map(|_| ()).unwrap_err(), Language::En);
    faults.into_iter().map(|fault| fault.message).collect()
}

fn checks(project: &AxisProject) -> Checks {
    let code = order_code::parse("CHA-25A-100-H-M512P").unwrap().code;
    check(project, &code).unwrap().judgement.checks
}

fn of(project: &AxisProject, id: CheckId) -> Check {
    checks(project).iter().find(|check| check.id == id).unwrap().clone()
}

fn value(project: &AxisProject, id: CheckId) -> f64 {
    of(project, id).value.unwrap().si
}

/// At the lower end of its swing the arm starts from rest; F_r is above its weight, 49.033 N, by what the motion adds, and M is
/// F_r (L + R) with R = 18 mm of 25A.
#[test]
fn an_arm_loads_its_flange() {
    let project = read(&text("", "", "mechanism = \"add\"\noverhang = \"45 mm\""));
    let radial = value(&project, CheckId::BearingRadial);
    assert!(radial > 49.033 && radial < 80.0, "{radial}");
    assert!((value(&project, CheckId::BearingTiltingMoment) - radial * 0.063).abs() < 1e-9);
    assert_eq!(value(&project, CheckId::BearingAxial), 0.0);
    assert!(of(&project, CheckId::BearingRadial).at.is_some());
    assert_eq!(of(&project, CheckId::BearingLife).verdict, Verdict::Pass);
    // Static safety by hand: C_0 = 45000 N, d_p = 88 mm.
    let expected = 45_000.0 / (radial + 2.0 * radial * 0.063 / 0.088);
    assert!((value(&project, CheckId::BearingStatic) - expected).abs() < 1e-9 * expected);
}

#[test]
fn what_is_not_stated_is_reported_and_not_guessed() {
    let missing = |text: &str, id| of(&read(text), id).missing;
    let open = text("", "", "mechanism = \"add\"");
    assert_eq!(missing(&open, CheckId::BearingTiltingMoment), Some("bearing.overhang"));
    assert_eq!(missing(&open, CheckId::BearingLife), Some("bearing.overhang"));
    assert_eq!(missing(&open, CheckId::BearingStatic), Some("bearing.overhang"));
    assert_eq!(missing(&open, CheckId::BearingRadial), None, "forces need no lever");
    let carried = text("payload = \"2 kg\"", "", "mechanism = \"add\"\noverhang = \"45 mm\"");
    assert_eq!(missing(&carried, CheckId::TiltAngle), Some("bearing.payload_overhang"));
    assert_eq!(words::check_missing("bearing.overhang", Language::En), "not stated: bearing.overhang");
}

#[test]
fn stated_loads_add_replace_or_stand_alone() {
    let own = "[motion.bearing]\nradial_force = \"500 N\"\nradial_distance = \"45 mm\"";
    let derived = value(&read(&text("", "", "mechanism = \"add\"\noverhang = \"45 mm\"")), CheckId::BearingRadial);
    let radial = |how: &str| value(&read(&text("", own, how)), CheckId::BearingRadial);
    let added = radial("mechanism = \"add\"\noverhang = \"45 mm\"");
    assert!((added - derived - 500.0).abs() < 1e-6, "{added} {derived}");
    assert!((radial("mechanism = \"replace\"\noverhang = \"45 mm\"") - 500.0).abs() < 1e-12);
    assert!((radial("mechanism = \"ignore\"") - 500.0).abs() < 1e-12);
    // Without a word the loads of the mechanism act; where it says that they do not count none are known.
    assert_eq!(value(&read(&text("", "", "overhang = \"45 mm\"")), CheckId::BearingRadial), derived);
    let alone = read(&text("", "", "mechanism = \"ignore\""));
    assert_eq!(of(&alone, CheckId::BearingRadial).missing, Some("bearing.radial_force"));
}

/// Loads beside those of the mechanism: to add them and to leave the others out are both a guess, so the file says which. Where the
/// mechanism describes none, nothing is to be said.
#[test]
fn stated_loads_beside_those_of_the_mechanism_need_a_word() {
    let loads = "radial_force = \"10 N\"\nradial_distance = \"1 mm\"";
    let segment = format!("[motion.bearing]\n{loads}");
    for (segment, bearing, line) in [(segment.as_str(), "", 19), ("", loads, 22)] {
        let faults = crate::read(&text("", segment, bearing)).unwrap_err();
        let [fault] = words::worded(&faults, Language::En).try_into().unwrap_or_else(|all| panic!("{all:?}"));
        assert!(fault.message.starts_with("`radial_force` states a load on the flange"), "{fault:?}");
        assert!(fault.message.contains("`mechanism = \"add\"` in [bearing]"), "{fault:?}");
        assert_eq!(faults[0].line, line);
        for word in ["add", "ignore"] {
            let said = text("", segment, &format!("mechanism = \"{word}\"\n{bearing}"));
            let assumptions = read(&said).assumptions;
            let expected = match word {
                "add" => axis::Assumption::FlangeLoadsAddUp,
                _ => axis::Assumption::FlangeLoadsIgnored,
            };
            assert!(assumptions.contains(&expected), "{word}: {assumptions:?}");
        }
    }
    let replaced = read(&text("", &segment, "mechanism = \"replace\"\noverhang = \"45 mm\""));
    assert!(replaced.assumptions.contains(&axis::Assumption::FlangeLoadsReplaced));
    let load = format!(
        "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n[bearing]\n{loads}\n"
    );
    assert!(!read(&load).assumptions.contains(&axis::Assumption::FlangeLoadsIgnored));
}

#[test]
fn heavier_loads_bear_harder_in_the_reserve() {
    let project = read(
        &text("", "", "mechanism = \"add\"\noverhang = \"45 mm\"")
            .replace("bearing_life_min = \"1000 h\"", "tilt_angle_max = \"0.06 arcmin\"")
            .replace("tilt_angle_max = \"2 arcmin\"\n", ""),
    );
    let code = order_code::parse("CHA-25A-100-H-M512P").unwrap().code;
    let candidate = check(&project, &code).unwrap();
    assert!(candidate.fits(), "{:?}", candidate.governing());
    // The tilt is in proportion to the mass: M ≤ 114 Nm/′ · 0.06′.
    let moment = value(&project, CheckId::BearingTiltingMoment);
    let factor = crate::reserve_of(&project, &candidate).load_factor.unwrap().value;
    assert!(factor <= 114.0 * 0.06 / moment * (1.0 + 1e-9), "{factor}");
}

#[test]
fn faults_of_the_geometry_are_reported_at_once() {
    let found = messages(&text(
        "",
        "",
        "mechanism = \"add\"\nbelt_tension = \"100 N\"\nwheel_mass = \"1 kg\"\nflange_share = 2.0\nradial_force = \"5 N\"",
    ));
    assert_eq!(found.len(), 4, "{found:?}");
    assert!(found.iter().any(|message| message == "`belt_tension` has no effect on this load"), "{found:?}");
    assert!(found.iter().any(|message| message == "`bearing.flange_share` must be a number from 0 to 1"));
    let found = messages(&text(
        "",
        "",
        "mechanism = \"ignore\"\noverhang = \"45 mm\"\nradial_force = \"5 N\"\nradial_distance = \"1 mm\"",
    ));
    assert_eq!(found, ["`overhang` has no effect on this load"], "stated loads are all of them");
    let found = messages(&text("", "", "mechanism = \"replace\"\nradial_force = \"5 N\"\nradial_distance = \"1 mm\""));
    assert!(found[0].contains("would replace the loads"), "{found:?}");
    let belt = "format = 1\n[mechanism.belt]\npulley_diameter = \"120 mm\"\nmass = \"18 kg\"\n[[motion]]\nlaw = \"dwell\"\n\
        time = \"1 s\"\n[bearing]\nmechanism = \"add\"\nbelt_tension = \"90 N\"\npressure_angle = \"75 deg\"\naxis_tilt = \"0 deg\"\n";
    assert_eq!(messages(belt).len(), 3, "{:?}", messages(belt));
    let load = "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n[bearing]\n\
        mechanism = \"add\"\n";
    assert!(messages(load)[0].contains("not described"), "{:?}", messages(load));
}

/// The reproducer of the review: 90° and two hundred swings of 2° are reported, independent of the life by rolling.
#[test]
fn many_small_swings_are_reported() {
    let swing = |angle: f64| format!("[[motion]]\nlaw = \"triangle\"\ndistance = \"{angle} deg\"\ntime = \"0.5 s\"\n");
    let moves = |moves: &[f64]| moves.iter().map(|angle| swing(*angle)).collect::<String>();
    let mut many = vec![90.0];
    many.extend([-2.0, 2.0].repeat(200));
    many.push(-90.0);
    let project = |moves: String, asked: &str| {
        read(&format!(
            "format = 1\n[load]\ninertia = \"0.1 kg m^2\"\nfriction_torque = \"1 N m\"\n{moves}[bearing]\n\
             radial_force = \"100 N\"\nradial_distance = \"50 mm\"\nload_factor = 1.2\n[requirements]\n{asked}"
        ))
    };
    for asked in ["", "bearing_life_min = \"1000 h\"\n"] {
        let life = of(&project(moves(&many), asked), CheckId::BearingLife);
        assert_eq!(life.verdict, Verdict::Advice, "{asked}");
        let worded = words::note_text(life.notes.first().unwrap(), Language::En);
        assert!(
            worded.starts_with("200 swivel motions of up to 2.00° per cycle, 82 % of the total travel"),
            "{worded}"
        );
        let small = of(&project(moves(&[4.0, -4.0]), asked), CheckId::BearingLife);
        assert_eq!(small.verdict, Verdict::Advice, "below 5°");
        let large = of(&project(moves(&[40.0, -40.0]), asked), CheckId::BearingLife);
        assert!(large.notes.is_empty() && large.verdict != Verdict::Advice);
    }
}

/// The largest radial force and the largest moment of different segments count together.
#[test]
fn static_safety_takes_the_largest_loads_together() {
    let swing = |loads: &str| {
        format!("[[motion]]\nlaw = \"triangle\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n[motion.bearing]\n{loads}\n")
    };
    let text = format!(
        "format = 1\n[load]\ninertia = \"0.1 kg m^2\"\n{}{}[bearing]\noperating_condition = \"normal\"\n",
        swing("radial_force = \"4000 N\"\nradial_distance = \"0 mm\""),
        swing("axial_force = \"1000 N\"\naxial_distance = \"150 mm\"")
    );
    // d_p 88 mm, R 18 mm: M = max(4000·0.018, 150) = 150 Nm.
    let expected = 45_000.0 / (4_000.0 + 300.0 / 0.088 + 440.0);
    let found = of(&read(&text), CheckId::BearingStatic);
    assert!((found.value.unwrap().si - expected).abs() < 1e-9, "{:?}", found.value);
    assert!(size(&read(&text)).candidates.first().unwrap().id.order_code().is_some());
}

/// The life follows, also where force and moment act in different segments, from the mean of the moment that acts, not from the
/// means of its parts: eq. 74.1 to 75.3 by hand.
#[test]
fn the_life_follows_from_the_moment_that_acts() {
    let run = |speed: f64, loads: &str| {
        format!(
            "[[motion]]\nlaw = \"manual\"\nspeed = \"{speed} 1/min\"\naccelerate = \"0.2 s\"\nrun = \"2 s\"\nbrake = \"0.3 s\"\n\
             pause = \"0.7 s\"\n{loads}"
        )
    };
    let text = format!(
        "format = 1\n[load]\ninertia = \"0.5 kg m^2\"\n{}{}[bearing]\nload_factor = 1.5\nradial_force = \"800 N\"\n\
         radial_distance = \"50 mm\"\naxial_force = \"1500 N\"\naxial_distance = \"40 mm\"\n",
        run(20.0, ""),
        run(-30.0, "[motion.bearing]\nradial_force = \"3000 N\"\nradial_distance = \"30 mm\"\n")
    );
    let b = 10.0 / 3.0;
    // Each run travels its speed for 2.25 s of the 3.2 s of a segment.
    let mean = |one: f64, other: f64| ((2.0 * f64::powf(one, b) + 3.0 * f64::powf(other, b)) / 5.0).powf(1.0 / b);
    let (radial, axial) = (mean(800.0, 3000.0), mean(1500.0, 0.0));
    // 25A: R 18 mm, d_p 88 mm, C 30 kN; F_a stays below 1.5 (F_r + 2 M/d_p).
    let moment = mean(800.0 * 0.068 + 1500.0 * 0.04, 3000.0 * 0.048);
    let equivalent = radial + 2.0 * moment / 0.088 + 0.45 * axial;
    let speed = 25.0 * 2.25 / 3.2;
    let expected = 1e6 / (60.0 * speed) * (30_000.0 / (1.5 * equivalent)).powf(b);
    let found = of(&read(&text), CheckId::BearingLife).value.unwrap().si / 3600.0;
    assert!((found / expected - 1.0).abs() < 1e-9, "{found} h, {expected} h by hand");
}

/// The tilt of the axis turns the weight of a roll without a wheel too; an axis without a stated tilt is horizontal, and
/// that is listed.
#[test]
fn the_roll_of_a_winder_needs_no_wheel_for_its_tilt() {
    let text = |bearing: &str| {
        format!(
            "format = 1\n[axis]\nsingle_move = true\n[mechanism.winder]\ntension = \"50 N\"\nwidth = \"400 mm\"\n\
             thickness = \"0.5 mm\"\ndensity = \"900 kg/m^3\"\ncore_diameter = \"90 mm\"\nfull_diameter = \"600 mm\"\n\
             [[motion]]\nlaw = \"web\"\nspeed = \"30 m/min\"\n[bearing]\noverhang = \"200 mm\"\n{bearing}"
        )
    };
    let weight = 900.0 * 0.4 * std::f64::consts::PI * (0.3_f64.powi(2) - 0.045_f64.powi(2)) * 9.806_65;
    let assumed = axis::Assumption::Default(project::KeyDefault::AxisLevel);
    for (bearing, radial, axial) in [
        ("", 50.0 + weight, 0.0),
        ("axis_tilt = \"0 deg\"\n", 50.0, weight),
        ("axis_tilt = \"90 deg\"\n", 50.0 + weight, 0.0),
    ] {
        let project = read(&text(bearing));
        let found = [CheckId::BearingRadial, CheckId::BearingAxial].map(|id| value(&project, id));
        // The web is as long as whole turns of the roll allow.
        assert!((found[0] - radial).abs() < 0.01 * weight, "{bearing}: {found:?} {radial}");
        assert!((found[1] - axial).abs() < 0.01 * weight, "{bearing}: {found:?} {axial}");
        assert_eq!(project.assumptions.contains(&assumed), bearing.is_empty(), "{bearing}");
    }
}

/// The output bearing is never left out: each of its checks is made or names the key that is missing.
#[test]
fn every_load_has_its_five_bearing_checks() {
    let five = [
        CheckId::BearingAxial,
        CheckId::BearingRadial,
        CheckId::BearingTiltingMoment,
        CheckId::BearingLife,
        CheckId::BearingStatic,
    ];
    let motion = "[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n[[motion]]\nlaw = \"polynomial_5\"\n\
        distance = \"-90 deg\"\ntime = \"1 s\"\n";
    for (load, known) in [
        ("[load]\ninertia = \"1 kg m^2\"\n", [false, false]),
        (
            "[mechanism.arm]\ninertia = \"1 kg m^2\"\nmass = \"9 kg\"\ncentre_distance = \"200 mm\"\naxis_tilt = \"90 deg\"\nstart_angle = \"0 deg\"\n",
            [true, true],
        ),
        ("[mechanism.turntable]\nbodies = [\"disc mass=9kg diameter=300mm length=20mm\"]\n", [true, true]),
        ("[mechanism.belt]\npulley_diameter = \"80 mm\"\nmass = \"9 kg\"\n", [false, false]),
        ("[mechanism.screw]\nlead = \"10 mm\"\nmass = \"9 kg\"\n", [false, false]),
        (
            "[mechanism.slider_crank]\ncrank = \"60 mm\"\nrod = \"240 mm\"\nmass = \"9 kg\"\nstart_angle = \"10 deg\"\n",
            [true, true],
        ),
    ] {
        let project = read(&format!("format = 1\n{load}{motion}"));
        let found = checks(&project);
        for id in five {
            let check = found.iter().find(|check| check.id == id).unwrap_or_else(|| panic!("{load}: no {id:?}"));
            assert_eq!(check.value.is_none(), check.missing.is_some(), "{load} {id:?}");
            let place = usize::from(id != CheckId::BearingAxial);
            if matches!(id, CheckId::BearingAxial | CheckId::BearingRadial) {
                assert_eq!(check.value.is_some(), known[place], "{load} {id:?} {:?}", check.missing);
            }
        }
    }
}
