//! Assumed data of an own actuator show in the grade, and stated data take precedence.
#![allow(clippy::unwrap_used, reason = "a test fails loudly")]

use crate::written_product::{toml, written};
use axis::AxisProject;
use provenance::Grade;
use questions::check_own;
use sizing::{Check, CheckId, Checks};

fn project(requirements: &str, actuator: &str) -> AxisProject {
    let text = format!(
        "format = 1\n[load]\ninertia = \"1.3 kg m^2\"\nfriction_torque = \"5 N m\"\n[[motion]]\nlaw = \"manual\"\n\
         speed = \"40 1/min\"\naccelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\npause = \"1 s\"\n\
         [requirements]\n{requirements}[actuator]\nname = \"own\"\nratio = 50\ninertia_out = \"1 kg m^2\"\n\
         current_max = \"9 A\"\ntorque_constant_out = \"16.5 N m/A\"\nvoltage_constant_motor = \"23 V/1000 1/min\"\n\
         resistance_ll = \"5.9 ohm\"\ninductance_ll = \"8 mH\"\npole_pairs = 5\nno_load_starting_current = \"0.17 A\"\n\
         no_load_current_constant_30 = \"4e-3 A/min^-1\"\nno_load_current_constant_80 = \"2e-3 A/min^-1\"\n{actuator}"
    );
    questions::read(&text).unwrap()
}

fn check(project: &AxisProject, id: CheckId) -> Check {
    let found = check_own(project).unwrap();
    found.judgement.checks.iter().find(|check| check.id == id).unwrap().clone()
}

#[test]
fn the_temperature_of_the_winding_is_assumed_until_it_is_stated() {
    let voltage = |actuator| check(&project("supply = \"560 V\"\n", actuator), CheckId::Voltage);
    let (assumed, stated) = (voltage(""), voltage("winding_temperature_max = \"90 degC\"\n"));
    assert_eq!((assumed.grade, stated.grade), (Some(Grade::Assumed), Some(Grade::Published)));
    assert_eq!(assumed.value, stated.value);
    let hotter = voltage("winding_temperature_max = \"130 degC\"\n");
    assert!(hotter.value.unwrap().si > stated.value.unwrap().si);
}

#[test]
fn friction_in_the_cold_is_assumed() {
    let current = |ambient: &str| check(&project(&format!("ambient = \"{ambient}\"\n"), ""), CheckId::PeakCurrent);
    assert_eq!(current("25 degC").grade, Some(Grade::Published));
    assert_eq!(current("0 degC").grade, Some(Grade::Assumed));
}

/// Checks of the gear, of the output bearing, of the encoder and of the place.
const OF_THE_DATA: [CheckId; 17] = [
    CheckId::BrakeHolding,
    CheckId::PeakTorque,
    CheckId::GearMeanTorque,
    CheckId::GearMeanInputSpeed,
    CheckId::GearLife,
    CheckId::CollisionTorque,
    CheckId::Torsion,
    CheckId::NaturalFrequency,
    CheckId::ErrorBudget,
    CheckId::FeedbackResolution,
    CheckId::BearingTiltingMoment,
    CheckId::BearingLife,
    CheckId::BearingStatic,
    CheckId::BearingAxial,
    CheckId::BearingRadial,
    CheckId::TiltAngle,
    CheckId::Ambient,
];

/// A check of an actuator that is written out answers as for the product of the catalogue: same value, limit,
/// utilisation and verdict.
#[test]
fn a_product_written_out_is_judged_as_in_the_catalogue() {
    let head = "format = 1\n[load]\ninertia = \"1.3 kg m^2\"\nfriction_torque = \"5 N m\"\nexternal_torque = \"3 N m\"\n\
                [[motion]]\nlaw = \"manual\"\nspeed = \"40 1/min\"\naccelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\npause = \"1 s\"\n\
                [bearing]\nradial_force = \"900 N\"\nradial_distance = \"80 mm\"\naxial_force = \"1.2 kN\"\n\
                axial_distance = \"30 mm\"\n[requirements]\nambient = \"30 degC\"\ncollision_torque = \"20 N m\"\n";
    let catalogue = questions::read(head).unwrap();
    let sizing = questions::size(&catalogue);
    let (mut compared, mut open) = (0, 0);
    for candidate in &sizing.candidates {
        let text = format!("{head}[actuator]\nname = \"written\"\n{}", toml(&written(&candidate.product.parameters)));
        let own =
            questions::read(&text).unwrap_or_else(|faults| panic!("{}: {faults:?}\n{text}", candidate.product.id));
        let own = check_own(&own).unwrap();
        for id in OF_THE_DATA {
            // An actuator whose file states no brake may have one.
            if id == CheckId::BrakeHolding && candidate.product.parameters.brake.holding_torque.known().is_none() {
                continue;
            }
            let of = |checks: &Checks| checks.iter().find(|check| check.id == id).cloned();
            let (there, here) = (of(&candidate.judgement.checks).unwrap(), of(&own.judgement.checks).unwrap());
            let numbers = |check: &Check| {
                [check.value.map(|amount| amount.si), check.limit.map(|amount| amount.si), check.utilisation]
            };
            for (there, here) in numbers(&there).into_iter().zip(numbers(&here)) {
                let is_equal = match (there, here) {
                    (Some(there), Some(here)) => (there - here).abs() <= 1e-12 * there.abs().max(1e-12),
                    (there, here) => there == here,
                };
                assert!(is_equal, "{} {id:?}: {there:?} and {here:?}\n{text}", candidate.product.id);
            }
            // A rating of another manufacturer's gear only advises; stated by the user it decides.
            if !there.is_of_another_gear() {
                assert_eq!(there.verdict, here.verdict, "{} {id:?}", candidate.product.id);
            }
            compared += 1;
            open += usize::from(there.is_open());
        }
    }
    assert!(compared >= 4000 && open * 6 < compared, "{compared}, of them open {open}");
}

#[test]
fn limits_in_the_wrong_order_are_refused() {
    let refused = |lines: &str| {
        let text = format!(
            "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"1 rad\"\n\
                            time = \"1 s\"\n[axis]\nsingle_move = true\n[actuator]\nname = \"own\"\n{lines}"
        );
        questions::read(&text).unwrap_err().len()
    };
    assert_eq!(refused("torque_1 = \"20 N m\"\ntorque_2 = \"10 N m\"\n"), 1);
    assert_eq!(refused("ambient_min = \"40 degC\"\nambient_max = \"0 degC\"\n"), 1);
    assert_eq!(refused("bearing_dynamic = \"-3 kN\"\nstiffness_1 = \"0 N m/rad\"\nbearing_type = \"ball\"\n"), 3);
}
