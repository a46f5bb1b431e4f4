//! Direction, relation, utilisation and verdict of every check say the same, for every example on every actuator.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may fail")]

use axis::Files;
use questions::{Check, CheckId, Direction, Verdict, size};

struct Examples;

impl Files for Examples {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/");
        Ok(Box::new(std::fs::File::open(format!("{folder}{name}"))?))
    }
}

fn agrees(check: &Check, what: &str) {
    let (Some(value), Some(limit)) = (check.value, check.limit) else {
        assert_eq!(check.relation(), None, "{what}");
        return;
    };
    let relation = check.relation().unwrap();
    match check.verdict {
        Verdict::Pass => assert!(["≤", "≥"].contains(&relation), "{what} passes"),
        Verdict::Fail => assert!([">", "<"].contains(&relation), "{what} fails"),
        Verdict::Advice | Verdict::NotChecked => {}
    }
    let expected = match check.direction() {
        Direction::AtMost => (value.si / limit.si).abs(),
        Direction::AtLeast => (limit.si / value.si).abs(),
    };
    // A temperature has no share of a limit; its rise above the air has. Above the end of the short-time curve the limit
    // is zero, and the utilisation that of the speed.
    let is_of_another_quantity =
        check.id == CheckId::Thermal || (check.id == CheckId::TorqueSpeedTrace && limit.si == 0.0);
    if let Some(utilisation) = check.utilisation.filter(|_| !is_of_another_quantity) {
        assert!(
            utilisation == expected || (utilisation / expected - 1.0).abs() < 1e-12,
            "{what}: {utilisation} {expected}"
        );
    }
}

#[test]
fn direction_relation_utilisation_and_verdict_agree() {
    let folder = std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples"));
    let mut seen = std::collections::BTreeSet::new();
    let mut files: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    for file in files.iter().filter(|file| file.extension().is_some_and(|ending| ending == "toml")) {
        let text = std::fs::read_to_string(file).unwrap();
        // A second time with more asked than anything gives.
        let harder = text.replace(
            "[requirements]",
            "[requirements]\ngear_life_min = \"1e7 h\"\nnatural_frequency_min = \"1e5 Hz\"\n",
        );
        for (text, as_it_is) in [(text, true), (harder, false)] {
            let read = questions::read_all(&text, &Examples);
            // What is asked twice is refused; every example by itself is valid.
            assert!(read.is_ok() || !as_it_is, "{}", file.display());
            let Ok(projects) = read else { continue };
            for project in &projects {
                for candidate in size(project).candidates {
                    for check in &candidate.judgement.checks {
                        agrees(check, &format!("{} {} {}", file.display(), candidate.id, check.id.id()));
                        seen.insert((check.id, check.verdict == Verdict::Fail));
                    }
                }
            }
        }
    }
    // A life and a frequency that fail were among them.
    for id in [CheckId::GearLife, CheckId::NaturalFrequency] {
        assert!(seen.contains(&(id, true)), "{}", id.id());
    }
}

#[test]
fn every_check_has_an_identifier_of_its_own() {
    let ids: std::collections::BTreeSet<&str> = CheckId::ALL.iter().map(|check| check.id()).collect();
    assert_eq!(ids.len(), CheckId::ALL.len());
}
