//! Assumed data of an own actuator show in the grade, and stated data take precedence.
#![allow(clippy::unwrap_used, reason = "a test fails loudly")]

use axis::AxisProject;
use provenance::Grade;
use questions::check_own;
use sizing::{Check, CheckId};
use std::sync::Arc;

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

fn check(project: &AxisProject, id: CheckId) -> Arc<Check> {
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
