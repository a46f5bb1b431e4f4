//! A stage out of project files: its limits, what it changes, and the best of several ratios.

use crate::{CheckId, check, explain, size};
use axis::{AxisProject, RatioAnswer};
use quantities::unit::{ARCMINUTE, DEGREE};
use quantities::{Language, Measure};
use sizing::Checks;

const ARM: &str = r#"format = 1
[mechanism.arm]
inertia = "0.9 kg m^2"
mass = "6 kg"
centre_distance = "250 mm"
axis_tilt = "90 deg"
start_angle = "-40 deg"
friction_torque = "1 N m"
efficiency = 0.95
efficiency_back = 0.9
[[motion]]
law = "modified_sine"
distance = "100 deg"
time = "1 s"
[[motion]]
law = "jerk"
distance = "-100 deg"
speed = "30 1/min"
acceleration = "15 rad/s^2"
jerk = "300 rad/s^3"
[requirements]
lever_arm = "200 mm"
"#;

fn arm(stage: &str) -> AxisProject {
    let text = format!("{ARM}{stage}");
    crate::read(&text).unwrap_or_else(|faults| panic!("{faults:?}"))
}

fn messages(stage: &str) -> Vec<String> {
    let faults = words::worded(&crate::read(&format!("{ARM}{stage}")).map(|_| ()).unwrap_err(), Language::En);
    faults.into_iter().map(|fault| fault.message).collect()
}

fn checks(project: &AxisProject) -> Checks {
    let code = order_code::parse("CHA-25A-100-H-M512P").unwrap().code;
    check(project, &code).unwrap().judgement.checks
}

fn value(project: &AxisProject, id: CheckId) -> f64 {
    checks(project).into_iter().find(|check| check.id == id).and_then(|check| check.value).unwrap().si
}

/// Ratio 1 without losses and inertia is no stage: every check but those that look at tilt and angles of the stage.
#[test]
fn a_ratio_of_one_is_no_stage() {
    let plain = checks(&arm(""));
    for stage in ["[stage]\nkind = \"gear\"\nratio = 1.0\n", "[stage]\nkind = \"coupling\"\n"] {
        let through = checks(&arm(stage));
        assert_eq!(plain.len(), through.len());
        // Teeth push on the flange otherwise than the load itself.
        let at_flange = |id: CheckId| id.part() == sizing::Part::OutputBearing;
        for (a, b) in plain.iter().zip(&through).filter(|(a, _)| !at_flange(a.id)) {
            let same = |a: Option<sizing::Amount>, b: Option<sizing::Amount>| match (a, b) {
                (Some(a), Some(b)) => (a.si - b.si).abs() <= 1e-12 * a.si.abs(),
                (None, None) => true,
                _ => false,
            };
            assert!(
                a.id == b.id && same(a.value, b.value) && same(a.limit, b.limit),
                "{:?} {:?} {:?}",
                a.id,
                a.value,
                b.value
            );
            assert_eq!(a.verdict, b.verdict, "{:?}", a.id);
        }
    }
}

/// A stage of ratio n before a pure inertia is the inertia J/n² that turns n times as far.
#[test]
fn a_pure_inertia_behind_a_stage_is_a_smaller_one_that_turns_further() {
    let text = |inertia: f64, distance: f64, stage: &str| {
        let text = format!(
            "format = 1\n[load]\ninertia = \"{inertia} kg m^2\"\n[[motion]]\nlaw = \"modified_sine\"\ndistance = \"{distance} deg\"\n\
             time = \"0.8 s\"\n[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"-{distance} deg\"\ntime = \"1.1 s\"\n{stage}"
        );
        crate::read(&text).unwrap()
    };
    let staged = text(2.7, 40.0, "[stage]\nkind = \"belt\"\nratio = 3.0\n");
    let direct = text(2.7 / 9.0, 120.0, "");
    for id in [
        CheckId::PeakTorque,
        CheckId::PeakSpeed,
        CheckId::MeanSpeed,
        CheckId::ContinuousTorque,
        CheckId::InertiaRatio,
        CheckId::Regeneration,
        CheckId::NaturalFrequency,
        CheckId::FeedbackRange,
        CheckId::Thermal,
    ] {
        let (a, b) = (value(&staged, id), value(&direct, id));
        assert!((a - b).abs() <= 1e-12 * b.abs(), "{id:?}: {a} {b}");
    }
    // The segments are reported as in the file: at the mechanism.
    let worded = crate::moves(&staged).moves.first().unwrap().course.unwrap();
    assert!((DEGREE.from_si(worded[0]) - 40.0).abs() < 1e-9);
    // The gear's torsion is seen through the ratio.
    assert!((value(&staged, CheckId::Torsion) * 3.0 / value(&direct, CheckId::Torsion) - 1.0).abs() < 1e-12);
}

/// A slide behind a stage: the line is that of the file, the ratio is between.
#[test]
fn a_line_stays_a_line() {
    let text = "format = 1\n[mechanism.belt]\npulley_diameter = \"100 mm\"\nmass = \"10 kg\"\n[[motion]]\nlaw = \"trapezoid\"\n\
        distance = \"500 mm\"\ntime = \"1 s\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"-500 mm\"\ntime = \"1 s\"\n[stage]\n\
        kind = \"gear\"\nratio = 0.5\n";
    let project = crate::read(text).unwrap();
    let moves = crate::moves(&project);
    assert!(!moves.turns && (moves.moves.first().unwrap().course.unwrap()[0] - 0.5).abs() < 1e-12);
    // 500 mm over 50 mm are 10 rad at the pulley, 5 rad at the actuator.
    assert!((project.axis.moments().angle_swing.si() - 5.0).abs() < 1e-9);
}

/// Calculated by hand: J_1 0.01, (0.9 + J_2 0.05)/16 at n = 4; the error at the lever arm: what the actuator errs, a quarter of it, and 3′ of
/// backlash; stiffness in series lowers the frequency.
#[test]
fn inertia_backlash_and_stiffness_count() {
    let stage = "[stage]\nkind = \"belt\"\nratio = 4\nefficiency = 0.97\ninertia_driving = \"0.01 kg m^2\"\n\
        inertia_driven = \"0.05 kg m^2\"\n";
    let staged = arm(stage);
    assert!((value(&staged, CheckId::InertiaRatio) - (0.95 / 16.0 + 0.01)).abs() < 1e-12);
    let loose = arm(&format!("{stage}backlash = \"3 arcmin\"\n"));
    let wider = value(&loose, CheckId::ErrorBudget) - value(&staged, CheckId::ErrorBudget);
    assert!((ARCMINUTE.from_si(wider) - 3.0).abs() < 1e-9);
    let springy = arm(&format!("{stage}stiffness = \"8000 N m/rad\"\n"));
    let ratio = value(&springy, CheckId::NaturalFrequency) / value(&staged, CheckId::NaturalFrequency);
    // K_1 = 37 kNm/rad is in series with 8000/16.
    assert!(ratio < 0.2, "{ratio}");
    let further = value(&springy, CheckId::Torsion) - value(&staged, CheckId::Torsion);
    let torque = springy.axis.moments().load_peak.si();
    assert!((further - 4.0 * torque / 8000.0).abs() < 1e-12);
    // Every step of the derivations of a stage is there.
    let code = order_code::parse("CHA-25A-100-H-M512P").unwrap().code;
    let explained = explain(&springy, &code).unwrap();
    let budget = explained.judgement.checks.iter().find(|check| check.id == CheckId::ErrorBudget).unwrap();
    assert!(budget.workings.iter().any(|step| step.symbol == "phi_out"));
}

#[test]
fn of_several_ratios_the_best_is_found() {
    let project = arm("[stage]\nkind = \"belt\"\nratios = [1, 2.5, 6, 40]\n");
    assert_eq!(project.ratios.len(), 4);
    let chosen: Vec<&RatioAnswer> = project.ratios.iter().filter(|answer| answer.chosen).collect();
    let [chosen] = chosen.as_slice() else { panic!("{:?}", project.ratios) };
    assert_eq!(project.axis.mechanism.stage_ratio(), chosen.ratio);
    assert_eq!(size(&project).answer().map(|answer| answer.id.to_string()), chosen.answer);
    // Each answer is that of the ratio alone, and none beats the chosen one by the rule.
    let best = size(&project).candidates.first().unwrap().standing;
    for answer in &project.ratios {
        let alone = arm(&format!("[stage]\nkind = \"belt\"\nratio = {}\n", answer.ratio));
        let sizing = size(&alone);
        assert_eq!(sizing.answer().map(|best| best.id.to_string()), answer.answer);
        assert!(sizing::rank(&best, &sizing.candidates.first().unwrap().standing).is_le());
    }
    assert!(project.ratios.last().unwrap().answer.is_none(), "forty times as fast is too fast");
    let text = words::ratios_text(&project.ratios, Language::En);
    assert!(text.contains("(chosen)") && text.contains("40.00: none fits, the nearest has 629.7 %"), "{text}");
}

#[test]
fn faults_of_the_stage_are_reported() {
    assert_eq!(messages("[stage]\nkind = \"belt\"\n"), ["`stage.ratio` is missing"]);
    assert_eq!(messages("[stage]\nkind = \"belt\"\nratio = 2\nratios = [1, 2]\n").len(), 1);
    assert_eq!(messages("[stage]\nkind = \"coupling\"\nratio = 2\n").len(), 1);
    assert_eq!(messages("[stage]\nkind = \"gear\"\nratios = []\n").len(), 1);
    assert_eq!(messages("[stage]\nkind = \"gear\"\nratios = [0, \"2\", 3]\n").len(), 2);
    assert_eq!(messages("[stage]\nratio = 2\n"), ["`stage.kind` is missing"]);
}

/// The load of a belt stage on the flange is its pull, not the weight behind it.
#[test]
fn the_flange_bears_the_stage() {
    let bearing = "[bearing]\nmechanism = \"add\"\nbelt_tension = \"200 N\"\noverhang = \"20 mm\"\nload_factor = 1.2\n";
    let stage = "[stage]\nkind = \"belt\"\nratio = 2\n";
    let open = arm(&format!("{stage}{bearing}"));
    let checks = checks(&open);
    let radial = checks.iter().find(|check| check.id == CheckId::BearingRadial).unwrap();
    assert_eq!(radial.missing, Some("stage.pitch_diameter"));
    let project = arm(&format!("{stage}pitch_diameter = \"80 mm\"\n{bearing}"));
    let pull = value(&project, CheckId::BearingRadial) - 400.0;
    // The belt hands on the torque of the load less what is not behind it: here all of it.
    assert!((pull * 0.04 - project.axis.moments().load_peak.si()).abs() < 1e-6, "{pull}");
}
