//! A check whose limit the project does not state lacks no datum, whatever is known of the actuator.
#![allow(clippy::unwrap_used, reason = "a test fails loudly")]

use questions::CheckId;
use questions::texts::by_importance;
use sizing::Verdict;

/// Data of the actuator, one more in each case: the first names it only.
const DATA: [&str; 6] = [
    "name = \"own\"\n",
    "ratio = 50\ninertia_out = \"1 kg m^2\"\n",
    "torque_max = \"90 N m\"\nspeed_max = \"60 1/min\"\n",
    "current_max = \"9 A\"\ntorque_constant_out = \"16.5 N m/A\"\n",
    "gear_torque_rated = \"40 N m\"\ngear_speed_max = \"6500 1/min\"\n",
    "gear_speed_mean_max = \"3500 1/min\"\n",
];

fn project(actuator: &str, requirements: &str) -> String {
    format!(
        "format = 1\n[load]\ninertia = \"1.3 kg m^2\"\nfriction_torque = \"5 N m\"\n[[motion]]\nlaw = \"manual\"\n\
         speed = \"40 1/min\"\naccelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\npause = \"1 s\"\n\
         [bearing]\nradial_force = \"90 N\"\nradial_distance = \"60 mm\"\n[requirements]\n{requirements}[actuator]\n{actuator}"
    )
}

#[test]
fn a_check_without_a_limit_is_not_open() {
    let mut seen = 0;
    for known in 1..=DATA.len() {
        let text = project(&DATA[..known].concat(), "");
        let found = questions::check_own(&questions::read(&text).unwrap()).map(|found| found.judgement.checks).unwrap();
        for check in by_importance(&found).into_iter().filter(|check| check.verdict == Verdict::NotChecked) {
            let lacks_limit = check.missing.is_some_and(CheckId::is_limit);
            assert_eq!(check.is_without_limit(), lacks_limit, "{known} {:?} {:?}", check.id, check.missing);
            assert_ne!(check.is_open(), lacks_limit, "{known} {:?}", check.id);
            seen += usize::from(lacks_limit && check.value.is_none());
        }
        for id in [CheckId::Torsion, CheckId::NaturalFrequency, CheckId::ErrorBudget, CheckId::FeedbackResolution] {
            let check = found.iter().find(|check| check.id == id).unwrap();
            assert!(check.is_without_limit(), "{known} {id:?} {:?}", check.missing);
        }
    }
    assert!(seen > 20, "{seen}");
}

/// With a limit, the datum is what is missing.
#[test]
fn a_check_with_a_limit_lacks_its_datum() {
    let text = project(DATA[0], "torsion_max = \"3 arcmin\"\n");
    let found = questions::check_own(&questions::read(&text).unwrap()).map(|found| found.judgement.checks).unwrap();
    let check = found.iter().find(|check| check.id == CheckId::Torsion).unwrap();
    assert!(check.is_open() && check.missing.is_some_and(|missing| !CheckId::is_limit(missing)), "{:?}", check.missing);
}
