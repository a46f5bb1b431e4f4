//! The DC link behind a rectifier of one phase and of three.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use quantities::Language;
use questions::{Verdict, check};

const AXIS: &str = "format = 1\n[load]\ninertia = \"0.4 kg m^2\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"90 deg\"\n\
    time = \"1 s\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"-90 deg\"\ntime = \"1 s\"\n[requirements]\n";

/// The terminal voltage that is left \[V\], and the largest U_DC \[V\], of a code at these mains.
fn edges(mains: &str) -> (f64, f64) {
    let project = questions::read(&format!("{AXIS}{mains}\n")).unwrap();
    let judged = check(&project, &order_code::parse("CHA-20A-100-H-C1024").unwrap().code).unwrap();
    let of = |id: &str| judged.judgement.checks.iter().find(|check| check.id.id() == id).unwrap().clone();
    let (voltage, link) = (of("voltage"), of("dc_link"));
    assert_ne!(link.verdict, Verdict::NotChecked, "{mains}");
    (voltage.limit.unwrap().value(), link.value.unwrap().value())
}

#[test]
fn one_phase_gives_less_under_load_and_as_much_without() {
    let (low, high) = edges("mains = \"230 V\"\nmains_phases = \"single\"");
    assert!((low - 186.37 / 2.0_f64.sqrt() * 0.9).abs() < 0.01 && (high - 357.80).abs() < 0.01, "{low} {high}");
    let three = edges("mains = \"230 V\"\nmains_phases = \"three\"");
    assert_eq!(three, edges("mains = \"230 V\""));
    assert!((three.0 / low - 1.5).abs() < 1e-12 && (three.1 - high).abs() < 1e-12);
    let steady = edges("mains = \"230 V\"\nmains_phases = \"single\"\nmains_deviation = 0.0");
    assert!((steady.1 - 325.27).abs() < 0.01, "{steady:?}");
}

#[test]
fn what_is_assumed_of_the_rectifier_is_listed_in_both_languages() {
    let project = questions::read(&format!("{AXIS}mains = \"230 V\"\nmains_phases = \"single\"\n")).unwrap();
    for (language, words) in
        [(Language::En, ["single-phase", "0.90"]), (Language::De, ["Einphasengleichrichter", "0,90"])]
    {
        let texts: Vec<String> =
            project.assumptions.iter().map(|assumption| words::assumption_text(*assumption, language)).collect();
        assert!(texts.iter().any(|text| words.iter().all(|word| text.contains(word))), "{texts:?}");
    }
}

#[test]
fn another_number_of_phases_is_refused_with_the_choices() {
    let faults = questions::read(&format!("{AXIS}mains = \"230 V\"\nmains_phases = \"two\"\n")).unwrap_err();
    for language in Language::ALL {
        let worded = words::worded(&faults, language);
        let [fault] = worded.as_slice() else { panic!("{worded:?}") };
        let all = format!("{} {}", fault.message, fault.hint.clone().unwrap_or_default());
        assert!(all.contains("single") && all.contains("three"), "{all}");
    }
}
