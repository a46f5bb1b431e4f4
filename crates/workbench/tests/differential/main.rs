//! The engine against dense sampling written apart from it (validation/differential), and against itself where a change
//! of the project must change nothing.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a test may fail")]

mod cases;
mod drive;
mod invariance;

use cases::{CASES, Case, Figures};

/// Allowed relative deviation of what is integrated over the cycle.
const INTEGRAL: f64 = 1e-6;
/// Allowed relative deviation of what is searched: the samples of the reference miss a peak by less.
const PEAK: f64 = 1e-4;
/// Allowed relative deviation between two spellings of one project.
const UNCHANGED: f64 = 1e-9;

/// Holds the figures named against the reference, in every case that has them; tells all that deviate.
fn hold(keys: &[(&str, f64)], chosen: impl Fn(&Case) -> bool) {
    let mut compared = vec![0; keys.len()];
    let mut faults = Vec::new();
    for case in CASES.iter().filter(|case| chosen(case)) {
        let found = case.figures();
        for ((key, allowed), count) in keys.iter().zip(&mut compared) {
            let (Some(expected), Some(value)) = (case.expected(key), found.get(*key)) else { continue };
            *count += 1;
            let deviation = relative(*value, expected);
            if deviation.is_nan() || deviation > *allowed {
                faults.push(format!("{}: {key} {value:.12} for {expected:.12}, {deviation:.1e}", case.name));
            }
        }
    }
    assert!(faults.is_empty(), "{} deviate:\n{}", faults.len(), faults.join("\n"));
    for ((key, _), count) in keys.iter().zip(compared) {
        assert!(count > 3, "{key} was compared {count} times only");
    }
}

/// |a − b| over the larger magnitude; zero where they are equal.
fn relative(a: f64, b: f64) -> f64 {
    if a == b { 0.0 } else { (a - b).abs() / a.abs().max(b.abs()) }
}

/// Every case of the reference is for an actuator whose numbers are still those of the catalogue.
#[test]
fn the_reference_took_the_numbers_of_the_catalogue() {
    let faults: Vec<String> = cases::actuators_that_differ();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn integrals_of_the_motion_and_the_torque_agree() {
    let keys = ["T_rms", "n_av", "ED", "gear_mean_torque"].map(|key| (key, INTEGRAL));
    hold(&keys, |case| case.files.is_empty());
}

#[test]
fn integrals_of_recordings_agree() {
    let keys = ["T_rms", "n_av", "ED", "gear_mean_torque"].map(|key| (key, INTEGRAL));
    hold(&keys, |case| !case.files.is_empty());
}

#[test]
fn peaks_of_the_motion_and_the_torque_agree() {
    hold(&["T_peak", "n_peak", "torsion"].map(|key| (key, PEAK)), |_| true);
}

#[test]
fn the_output_bearing_agrees() {
    let keys =
        ["bearing_axial", "bearing_radial", "bearing_tilting_moment", "bearing_life", "bearing_static", "tilt_angle"];
    hold(&keys.map(|key| (key, INTEGRAL)), |_| true);
}

/// Figures of the drive: their invariance is held in `drive`.
const OF_THE_DRIVE: [&str; 9] = [
    "peak_current",
    "voltage",
    "thermal",
    "housing",
    "overload_i2t",
    "motoring",
    "regenerated",
    "regeneration",
    "regenerated_peak",
];

/// Whether a figure is one of the drive.
fn of_the_drive(key: &str) -> bool {
    OF_THE_DRIVE.contains(&key)
}

/// Whether a figure is one of the load.
fn of_the_load(key: &str) -> bool {
    !of_the_drive(key)
}

/// A change of a case that changes nothing, with the factors that its figures take.
fn hold_unchanged(
    change: impl Fn(&Case) -> Vec<Case>,
    factor: impl Fn(&str) -> f64,
    chosen: impl Fn(&Case, &str) -> bool,
) {
    let mut faults = Vec::new();
    let mut compared = 0;
    for case in CASES.iter() {
        let before = case.figures();
        for other in change(case) {
            compared += 1;
            faults.extend(moved(case, &before, &other.figures(), &factor, |key| chosen(case, key)));
        }
    }
    assert!(faults.is_empty(), "{} deviate:\n{}", faults.len(), faults.join("\n"));
    assert!(compared > 40, "{compared} compared");
}

/// Figures that a change which changes nothing moves by more than rounding.
fn moved(
    case: &Case,
    before: &Figures,
    after: &Figures,
    factor: impl Fn(&str) -> f64,
    chosen: impl Fn(&str) -> bool,
) -> Vec<String> {
    let mut faults = Vec::new();
    if !before.keys().eq(after.keys()) {
        faults.push(format!("{}: other checks", case.name));
    }
    for (key, value) in before.iter().filter(|(key, _)| chosen(key)) {
        let (value, Some(other)) = (value * factor(key), after.get(key)) else { continue };
        let deviation = relative(value, *other);
        if deviation.is_nan() || deviation > UNCHANGED {
            faults.push(format!("{}: {key} {value:.12} becomes {other:.12}, {deviation:.1e}", case.name));
        }
    }
    faults
}

/// Every quantity in another unit.
fn other_units(case: &Case) -> Vec<Case> {
    vec![case.with(invariance::other_units(&case.project), &case.files)]
}

/// The cycle begun elsewhere.
fn rotated(case: &Case) -> Vec<Case> {
    case.rotations.iter().map(|first| case.with(invariance::rotated(case, *first), &case.files)).collect()
}

/// The motion twice in one cycle.
fn repeated(case: &Case) -> Vec<Case> {
    vec![case.with(invariance::repeated(&case.project), &case.files)]
}

/// Every direction turned round.
fn mirrored(case: &Case) -> Vec<Case> {
    let turned = || {
        let (project, files) = invariance::mirrored(case);
        case.with(project, &files)
    };
    case.mirror.then(turned).into_iter().collect()
}

/// An axis that goes on and on swings farther when the cycle is run through twice, or begun elsewhere.
fn travels_on(case: &Case, key: &str) -> bool {
    key == "feedback_range" && case.travels_on()
}

#[test]
fn other_units_change_nothing() {
    hold_unchanged(other_units, |_| 1.0, |_, key| of_the_load(key));
}

#[test]
fn where_the_cycle_begins_changes_nothing() {
    hold_unchanged(rotated, |_| 1.0, |case, key| of_the_load(key) && !travels_on(case, key));
}

#[test]
fn the_motion_twice_changes_nothing() {
    hold_unchanged(repeated, |_| 1.0, |case, key| of_the_load(key) && !travels_on(case, key));
}

#[test]
fn the_mirrored_axis_asks_the_same() {
    hold_unchanged(mirrored, |_| 1.0, |_, key| of_the_load(key));
}
