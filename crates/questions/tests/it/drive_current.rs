//! `[drive]` of a project file, from its text to the record of the check in both languages.
#![allow(clippy::unwrap_used, reason = "a test that cannot panic cannot fail")]

use quantities::Language;
use questions::answer;
use sizing::CheckId;

const CODE: &str = "CHA-25A-100-H-C1024-B";

/// A check of the example `winder.toml`, with other lines in `[drive]`.
fn record(drive: &str, id: CheckId, language: Language) -> Option<answers::Check> {
    let text = include_str!("../../../../examples/winder.toml");
    let (before, behind) = text.split_once("[drive]").unwrap();
    let (_, behind) = behind.split_once("\n\n").unwrap_or((behind, ""));
    let project = questions::read(&format!("{before}{drive}\n{behind}")).unwrap();
    let code = order_code::parse(CODE).unwrap().code;
    let candidate = questions::check(&project, &code).unwrap_or_else(|_| unreachable!());
    let record = answer::candidate(&candidate, language);
    record.checks.into_iter().find(|check| *check.id == id)
}

fn verdict(drive: &str, id: CheckId) -> sizing::Verdict {
    *record(drive, id, Language::En).unwrap().verdict
}

#[test]
fn a_drive_that_supplies_the_current_passes_and_a_small_one_fails() {
    let of = |continuous: &str, peak: &str| {
        format!("[drive]\ncurrent_continuous = \"{continuous}\"\ncurrent_peak = \"{peak}\"\n")
    };
    use sizing::Verdict::{Fail, Pass};
    let (continuous, peak, time) = (CheckId::DriveCurrent, CheckId::DriveCurrentPeak, CheckId::DrivePeakTime);
    assert_eq!(verdict(&of("5 A", "10 A"), continuous), Pass);
    assert_eq!(verdict(&of("5 A", "10 A"), peak), Pass);
    assert_eq!(verdict(&of("0.01 A", "10 A"), continuous), Fail);
    assert_eq!(verdict("[drive]\ncurrent_peak = \"0.01 A\"\n", peak), Fail);
    // Never above the continuous current: no time above it.
    assert_eq!(verdict(&format!("{}peak_time = \"1 ms\"\n", of("5 A", "10 A")), time), Pass);
    assert_eq!(verdict(&format!("{}peak_time = \"1 ms\"\n", of("0.5 A", "10 A")), time), Fail);
}

#[test]
fn the_limit_is_cited_by_its_key_and_titled_in_both_languages() {
    for (language, title) in [(Language::En, "drive, continuous current"), (Language::De, "Servoregler, Dauerstrom")] {
        let check = record("[drive]\ncurrent_continuous = \"5 A\"\n", CheckId::DriveCurrent, language).unwrap();
        assert_eq!((check.title.as_str(), check.unit), (title, Some("A")));
        assert!(check.limit.is_some_and(|limit| (limit.0 - 5.0).abs() < 1e-12));
        assert!(check.sources.iter().any(|source| source.contains("drive.current_continuous")), "{:?}", check.sources);
        assert_eq!(check.missing, None);
    }
}

/// Without `[drive]` it is not judged, and an actuator without a torque constant is not checked.
#[test]
fn without_data_it_is_not_checked() {
    assert!(record("", CheckId::DriveCurrent, Language::En).is_none());
    let text = "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n\
        [[motion]]\nlaw = \"polynomial_5\"\ndistance = \"-90 deg\"\ntime = \"1 s\"\n[drive]\ncurrent_peak = \"10 A\"\n\
        [actuator]\nname = \"own\"\nratio = 50\ninertia_out = \"1 kg m^2\"\n";
    let project = questions::read(text).unwrap();
    let candidate = questions::check_own(&project).unwrap();
    for language in Language::ALL {
        let record = answer::candidate(&candidate, language);
        let check = record.checks.into_iter().find(|check| *check.id == CheckId::DriveCurrentPeak).unwrap();
        assert_eq!((*check.verdict, check.missing.as_deref()), (sizing::Verdict::NotChecked, Some("k_Tout")));
    }
}
