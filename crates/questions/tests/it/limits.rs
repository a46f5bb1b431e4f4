//! The limits that a candidate would need let it in, and nothing less does.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may fail")]

use axis::AxisProject;
use quantities::Language;
use questions::{check, limits_needed};

/// The indexing table with requirements of its own.
fn table(requirements: &str) -> AxisProject {
    let text = include_str!("../../../../examples/indexing-table.toml");
    let text = text.replace("bearing_life_min = \"30000 h\"\n", &format!("{requirements}\n"));
    questions::read(&text).unwrap()
}

fn code(text: &str) -> order_code::OrderCode {
    order_code::parse(text).unwrap().code
}

#[test]
fn limits_that_are_met_let_a_candidate_in() {
    let code = code("CHA-32A-50-H-C1024");
    let project = table("torsion_max = \"1 arcmin\"\nmass_max = \"4 kg\"\nnatural_frequency_min = \"200 Hz\"");
    let needed = limits_needed(&check(&project, &code).unwrap()).unwrap();
    let keys: Vec<&str> = needed.iter().map(|limit| limit.key.as_str()).collect();
    assert_eq!(keys, ["requirements.mass_max", "requirements.torsion_max", "requirements.natural_frequency_min"]);
    let with = |factor: f64| {
        let lines = needed.iter().map(|limit| {
            // A least frequency is met by less, a largest torsion by more.
            let easier = if limit.key.ends_with("_min") { 1.0 / factor } else { factor };
            let name = limit.key.strip_prefix("requirements.").unwrap();
            format!("{name} = \"{:.12} {}\"\n", limit.enough.value() * easier, limit.enough.unit.json)
        });
        check(&table(&lines.collect::<String>()), &code).unwrap().fits()
    };
    // Rounding to four digits leaves a thousandth at most.
    assert!(with(1.0) && !with(1.0 - 1.1e-3));
}

#[test]
fn where_more_than_a_limit_of_the_project_fails_none_is_named() {
    let fits = check(&table(""), &code("CHA-32A-50-H-C1024")).unwrap().fits();
    assert!(fits && limits_needed(&check(&table(""), &code("CHA-32A-50-H-C1024")).unwrap()).is_none());
    // Its peak torque is too small as well.
    let project = table("torsion_max = \"1 arcmin\"");
    assert!(limits_needed(&check(&project, &code("CHA-20A-50-H-C1024")).unwrap()).is_none());
    // A brake is no limit.
    let project = table("brake = true\nmass_max = \"4 kg\"");
    assert!(limits_needed(&check(&project, &code("CHA-32A-50-H-C1024")).unwrap()).is_none());
}

/// An arm that changes its speed over thousands of revolutions: refused in both languages with number and limit; at constant
/// speed it is calculated.
#[test]
fn too_long_a_cycle_is_refused() {
    let arm = |motion: &str| {
        format!(
            "format = 1\n[axis]\nname = \"arm\"\nsingle_move = true\n[mechanism.arm]\ninertia = \"1 kg m^2\"\nmass = \"5 kg\"\n\
             centre_distance = \"100 mm\"\naxis_tilt = \"90 deg\"\nstart_angle = \"0 deg\"\n[[motion]]\n{motion}\n"
        )
    };
    let slow = arm("law = \"trapezoid\"\ndistance = \"2000000 deg\"\ntime = \"20000 s\"");
    for (language, words) in
        [(Language::En, "the limit is 130000"), (Language::De, "gerechnet werden höchstens 130000")]
    {
        let faults = words::worded(&questions::read(&slow).unwrap_err(), language);
        assert!(faults.iter().any(|fault| fault.message.contains(words)), "{faults:?}");
    }
    assert!(questions::read(&arm("law = \"constant\"\nspeed = \"20 1/min\"\ntime = \"100000 s\"")).is_ok());
}
