//! Every rejection rests on the manual, on documents of the maker of the actuators, on standards and models, and on what the project
//! states: never on a page of another maker.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use crate::catalogue_actuators;
use provenance::Source;
use quantities::Language;
use questions::{Check, Reason, Verdict, explain, read};
use std::collections::{BTreeMap, BTreeSet};

/// Axes that overload every size somewhere, with limits that few actuators keep.
fn projects() -> Vec<String> {
    let requirements = "[requirements]\nbrake = true\nsupply = \"560 V\"\nambient = \"60 degC\"\nlever_arm = \"900 mm\"\n\
         deviation_max = \"0.01 mm\"\nabsolute = true\nresolution_max = \"0.1 arcsec\"\noperation_per_day = \"24 h\"\n\
         battery_life_min = \"40 a\"\ncollision_torque = \"9000 N m\"\ncollision_time = \"0.1 s\"\ncollisions = 9000\n\
         gear_life_min = \"900000 h\"\nbearing_life_min = \"900000 h\"\ntorsion_max = \"0.01 arcmin\"\n\
         natural_frequency_min = \"300 Hz\"\ntilt_angle_max = \"0.001 arcmin\"\nstop_angle_max = \"0.1 deg\"\n\
         emergency_stops = 9000\nholding_safety = 9\nregeneration_power_max = \"0.1 W\"\ndc_link_rise = \"1 V\"\n\
         altitude = \"3000 m\"\naltitude_derating = 0.5\nprotection = \"IP68\"\nhumidity_max = 0.99\nvibration = \"50 g\"\n\
         shock = \"900 g\"\nservice_life = \"90000 h\"\n";
    let arm = |mass: &str, time: &str| {
        format!(
            "format = 1\n[mechanism.arm]\ninertia = \"0.2 kg m^2\"\nmass = \"{mass}\"\ncentre_distance = \"300 mm\"\n\
             axis_tilt = \"90 deg\"\nstart_angle = \"-90 deg\"\n[bearing]\noverhang = \"400 mm\"\nflange_share = 1\n\
             load_factor = 3\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"180 deg\"\ntime = \"{time}\"\n\
             [[motion]]\nlaw = \"dwell\"\ntime = \"0.5 s\"\nhold = \"brake\"\n\
             [[motion]]\nlaw = \"trapezoid\"\ndistance = \"-180 deg\"\ntime = \"{time}\"\n{requirements}"
        )
    };
    let turntable = format!(
        "format = 1\n[load]\ninertia = \"1.3 kg m^2\"\nfriction_torque = \"5 N m\"\n[[motion]]\nlaw = \"constant\"\n\
         speed = \"150 1/min\"\ntime = \"60 s\"\n{requirements}"
    );
    vec![arm("2 kg", "2 s"), arm("15 kg", "0.6 s"), arm("150 kg", "1 s"), arm("900 kg", "0.3 s"), turntable]
}

/// A limit of zero is no figure that a load exceeds: the reason says what the actuator lacks.
#[test]
fn a_limit_of_zero_is_stated_as_what_is_lacking() {
    let mut lacking = BTreeSet::new();
    for (time, required) in [("2 s", "absolute = true"), ("0.05 s", "supply = \"325 V\"")] {
        let text = format!(
            "format = 1\n[load]\ninertia = \"0.1 kg m^2\"\nfriction_torque = \"1 N m\"\n[[motion]]\nlaw = \"trapezoid\"\n\
             distance = \"180 deg\"\ntime = \"{time}\"\n[requirements]\n{required}\n"
        );
        let project = read(&text).unwrap();
        for (code, _) in catalogue_actuators().step_by(3) {
            let Ok(candidate) = explain(&project, code) else { continue };
            let Some(Reason::Check(check)) = candidate.reason() else { continue };
            if check.limit.is_some_and(|limit| limit.si == 0.0) {
                lacking.insert(check.id.id());
                for language in [Language::En, Language::De] {
                    let reason = questions::texts::reason(&candidate, language);
                    assert!(!reason.contains(['>', '≤', '≥']), "{code}: {reason}");
                }
            }
        }
    }
    assert!(lacking.contains("feedback_range"), "{lacking:?}");
}

/// The documents behind value and limit of a check and every step of its derivation.
fn documents(check: &Check) -> BTreeSet<&'static str> {
    let steps = check.workings.iter().map(|step| &step.source);
    let ends = [&check.value_source, &check.limit_source].into_iter().flatten();
    let cited = steps.chain(ends).filter_map(|source| match source {
        Source::Cell(place) | Source::Published(place) => Some(place.document),
        _ => None,
    });
    cited.collect()
}

#[test]
fn every_rejection_rests_on_the_maker_and_the_project() {
    let is_permitted = |id: &str| {
        let document = catalogue::documents().iter().find(|document| document.id == id).unwrap();
        document.publisher.starts_with("Harmonic Drive")
            || document.publisher == "antrieb"
            || document.kind == "standard"
    };
    let mut strange: BTreeMap<(&str, &str), String> = BTreeMap::new();
    let (mut failed, mut read_of) = (BTreeSet::new(), BTreeSet::new());
    for text in projects() {
        let project = read(&text).unwrap();
        for (code, _) in catalogue_actuators().step_by(5) {
            let Ok(candidate) = explain(&project, code) else { continue };
            for check in candidate.judgement.checks.iter().filter(|check| check.verdict == Verdict::Fail) {
                failed.insert(check.id.id());
                for document in documents(check) {
                    read_of.insert(document);
                    if !is_permitted(document) {
                        strange.entry((check.id.id(), document)).or_insert_with(|| code.to_string());
                    }
                }
            }
        }
    }
    assert!(strange.is_empty(), "{strange:#?}");
    for id in ["gear_life", "bearing_life", "torque_speed_trace", "brake_holding", "torsion", "natural_frequency"] {
        assert!(failed.contains(id), "{id} never fails: {failed:?}");
    }
    assert!(failed.len() >= 24, "{failed:?}");
    assert!(read_of.len() >= 3, "{read_of:?}");
}
