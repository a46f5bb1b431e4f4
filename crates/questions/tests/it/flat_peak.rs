//! A flat peak at a stored instant is reported at that instant, not at a neighbouring one with the same value except for
//! rounding: which of those is found depends on the last digits of a machine.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use quantities::Measure;
use sizing::CheckId;

/// α of a modified sine is largest an eighth of the time after the start, n half-way: 0.05625 s and 0.225 s of 0.45 s.
#[test]
fn the_peaks_of_a_modified_sine_are_reported_at_its_own_instants() {
    let text = questions::list::new::example("table", "axis.toml", quantities::Language::En).unwrap().text;
    let project = questions::read(&text).unwrap();
    for candidate in &questions::size(&project).candidates {
        let at = |id: CheckId| {
            let check = candidate.judgement.checks.iter().find(|check| check.id == id);
            check.and_then(|check| check.at).map(Measure::si)
        };
        for (id, instant) in [(CheckId::PeakTorque, 0.05625), (CheckId::PeakSpeed, 0.225), (CheckId::Torsion, 0.05625)]
        {
            assert_eq!(at(id), Some(instant), "{}, {}", candidate.id, id.id());
        }
    }
}
