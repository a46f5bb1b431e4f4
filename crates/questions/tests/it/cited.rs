//! A value cites the keys of the file in which it is stated, as they are written there.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may fail")]

use axis::AxisProject;
use provenance::Source;
use questions::{CheckId, check, explain, read, read_all};
use sizing::Checks;

const REST: &str = "brake = \"0.1 s\"\npause = \"1 s\"\n";

fn manual(speed: &str) -> String {
    format!("[[motion]]\nlaw = \"manual\"\nspeed = \"{speed}\"\naccelerate = \"0.1 s\"\nrun = \"0.1 s\"\n{REST}")
}

fn checks(project: &AxisProject) -> Checks {
    let code = order_code::parse("CHA-25A-100-H-C1024").unwrap().code;
    check(project, &code).unwrap().judgement.checks
}

fn value_key(checks: &Checks, id: CheckId) -> String {
    let check = checks.iter().find(|check| check.id == id).unwrap();
    match check.value_source.as_ref().unwrap() {
        Source::Project { key } => key.to_string(),
        other => other.to_string(),
    }
}

fn limit_key(checks: &Checks, id: CheckId) -> String {
    checks.iter().find(|check| check.id == id).unwrap().limit_source.as_ref().unwrap().to_string()
}

fn speed_key(text: &str) -> String {
    value_key(&checks(&read(text).unwrap()), CheckId::PeakSpeed)
}

#[test]
fn the_peak_speed_of_a_move_by_distance_and_time_cites_both() {
    let text = "format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"1 kg m^2\"\n\
                [[motion]]\nlaw = \"modified_sine\"\ndistance = \"20 deg\"\ntime = \"1 s\"\n\
                [[motion]]\nlaw = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n";
    assert_eq!(speed_key(text), "motion[2].distance, motion[2].time");
    assert_eq!(
        speed_key(&text.replace("90 deg\"\ntime = \"1 s\"", "90 deg\"\nspeed = \"20 1/min\"\ntime = \"1 s\"")),
        "motion[2].speed"
    );
}

#[test]
fn a_limit_of_the_speed_that_is_not_reached_is_not_cited_alone() {
    let jerk = |speed: &str| {
        format!(
            "format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"jerk\"\n\
             distance = \"10 deg\"\nspeed = \"{speed}\"\nacceleration = \"5 rad/s^2\"\njerk = \"50 rad/s^3\"\n"
        )
    };
    assert_eq!(speed_key(&jerk("2 1/min")), "motion[1].speed");
    let all = "motion[1].distance, motion[1].speed, motion[1].acceleration, motion[1].jerk";
    assert_eq!(speed_key(&jerk("40 1/min")), all);
}

#[test]
fn a_motion_along_a_line_behind_a_stage_cites_what_turns_it() {
    let text = "format = 1\n[axis]\nsingle_move = true\n[stage]\nkind = \"belt\"\nratio = 2\n\
                [mechanism.screw]\nlead = \"20 mm\"\nmass = \"10 kg\"\n\
                [[motion]]\nlaw = \"trapezoid\"\ndistance = \"100 mm\"\ntime = \"2 s\"\n";
    assert_eq!(speed_key(text), "motion[1].distance, motion[1].time, mechanism.screw.lead, stage.ratio");
}

#[test]
fn the_faster_of_the_manuals_moves_is_cited() {
    let text = format!("format = 1\n[load]\ninertia = \"1 kg m^2\"\n{}{}", manual("10 1/min"), manual("20 1/min"));
    let project = read(&text).unwrap();
    let found = checks(&project);
    assert_eq!(value_key(&found, CheckId::PeakSpeed), "motion[2].speed");
    assert_eq!(value_key(&found, CheckId::InertiaRatio), "load.inertia");
    // The workings of the effective torque name the move that governs.
    let code = order_code::parse("CHA-25A-100-H-C1024").unwrap().code;
    let explained = explain(&project, &code).unwrap().judgement.checks;
    let steps = explained.iter().flat_map(|check| &check.workings);
    let keys: Vec<String> = steps.map(|step| step.source.to_string()).collect();
    assert!(keys.iter().any(|key| key == "project motion[2].speed"), "{keys:?}");
    assert!(!keys.iter().any(|key| key.contains("motion.")), "{keys:?}");
}

#[test]
fn a_turntable_cites_its_bodies_and_not_a_load_that_is_not_there() {
    let text = |bodies: &str| format!("format = 1\n[mechanism.turntable]\n{bodies}\n{}", manual("10 1/min"));
    let bodies = text("bodies = [\"disc diameter=500mm length=20mm mass=12kg\"]");
    let found = checks(&read(&bodies).unwrap());
    assert_eq!(value_key(&found, CheckId::InertiaRatio), "mechanism.turntable.bodies");
    let table = text("[[mechanism.turntable.body]]\nshape = \"point\"\nmass = \"1 kg\"\ndistance = \"1 m\"");
    assert_eq!(value_key(&checks(&read(&table).unwrap()), CheckId::InertiaRatio), "mechanism.turntable.body");
    let payload = format!("{bodies}payload_inertia = \"0.5 kg m^2\"\n");
    // With a payload the largest inertia follows from both.
    let found = checks(&read(&payload).unwrap());
    assert_eq!(value_key(&found, CheckId::InertiaRatio), "model mechanisms");
}

#[test]
fn every_key_of_one_axis_of_several_begins_with_the_axis() {
    let axis = |name: &str, speed: &str| {
        format!(
            "[[axis]]\nname = \"{name}\"\n[axis.load]\ninertia = \"1 kg m^2\"\n{}[axis.requirements]\n\
             supply = \"560 V\"\nambient = \"30 degC\"\ntorsion_max = \"3 arcmin\"\n\
             [axis.bearing]\nradial_force = \"100 N\"\nradial_distance = \"50 mm\"\n",
            manual(speed).replace("[[motion]]", "[[axis.motion]]")
        )
    };
    let text = format!("format = 1\n{}{}", axis("a", "10 1/min"), axis("b", "20 1/min"));
    let projects = read_all(&text, &axis::NoFiles).unwrap();
    let found = checks(&projects[1]);
    assert_eq!(value_key(&found, CheckId::PeakSpeed), "axis[2].motion[1].speed");
    assert_eq!(value_key(&found, CheckId::InertiaRatio), "axis[2].load.inertia");
    assert_eq!(value_key(&found, CheckId::BearingRadial), "axis[2].bearing.radial_force");
    assert_eq!(limit_key(&found, CheckId::Torsion), "project axis[2].requirements.torsion_max");
    for check in &found {
        for source in [&check.value_source, &check.limit_source].into_iter().flatten() {
            if let Source::Project { key } = source {
                assert!(key.starts_with("axis[2]."), "{:?}: {key}", check.id);
            }
        }
    }
}

#[test]
fn a_load_of_the_flange_cites_the_segment_that_states_it() {
    let text = format!(
        "format = 1\n[load]\ninertia = \"1 kg m^2\"\n{}[motion.bearing]\nradial_force = \"900 N\"\n\
         radial_distance = \"50 mm\"\n{}[bearing]\nradial_force = \"100 N\"\nradial_distance = \"50 mm\"\n",
        manual("10 1/min"),
        manual("20 1/min")
    );
    assert_eq!(value_key(&checks(&read(&text).unwrap()), CheckId::BearingRadial), "motion[1].bearing.radial_force");
}
