//! The engine against dense sampling written apart from it (validation/differential), and against itself where a change
//! of the project must change nothing.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a test may fail")]

mod cases;
mod drive;
mod invariance;

use cases::{CASES, Case, Figures};
use std::sync::LazyLock;

/// Allowed relative deviation of what is integrated over the cycle.
const INTEGRAL: f64 = 1e-6;
/// Allowed relative deviation of what is searched: the samples of the reference miss a peak by less.
const PEAK: f64 = 1e-4;
/// Allowed relative deviation between two spellings of one project.
const UNCHANGED: f64 = 1e-9;

/// Compares the named values with the reference, in every case that has them; reports all deviations.
fn hold(keys: &[(&str, f64)], chosen: impl Fn(&Case) -> bool) {
    let mut compared = vec![0; keys.len()];
    let mut faults = Vec::new();
    for case in CASES.iter().filter(|case| chosen(case)) {
        let found = case.found();
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
    let keys = [
        "bearing_axial",
        "bearing_radial",
        "bearing_tilting_moment",
        "bearing_static_moment",
        "bearing_life",
        "bearing_static",
        "tilt_angle",
    ];
    // The life is the power 10/3 of the mean load, and deviates by as much more.
    let allowed = |key| if key == "bearing_life" { 10.0 / 3.0 * INTEGRAL } else { INTEGRAL };
    hold(&keys.map(|key| (key, allowed(key))), |_| true);
}

/// Figures of the drive: their invariance is held in `drive`.
const OF_THE_DRIVE: [&str; 10] = [
    "peak_current",
    "demagnetisation",
    "voltage",
    "thermal",
    "housing",
    "overload_i2t",
    "motoring",
    "regenerated",
    "regeneration",
    "regenerated_peak",
];

/// Returns `true` if a figure is one of the drive.
fn of_the_drive(key: &str) -> bool {
    OF_THE_DRIVE.contains(&key)
}

/// Returns `true` if a figure is one of the load.
fn of_the_load(key: &str) -> bool {
    !of_the_drive(key)
}

/// A change of the cases that changes none of their results, with the results after it: several variants of each case.
struct Change(LazyLock<Vec<Vec<Figures>>>);

impl Change {
    const fn new(results: fn() -> Vec<Vec<Figures>>) -> Self {
        Self(LazyLock::new(results))
    }
}

/// The results of each case after a change.
fn after(change: impl Fn(&Case) -> Vec<Case>) -> Vec<Vec<Figures>> {
    CASES.iter().map(|case| change(case).iter().map(Case::figures).collect()).collect()
}

/// Every quantity in another unit.
static OTHER_UNITS: Change =
    Change::new(|| after(|case| vec![case.with(invariance::other_units(&case.project), &case.files)]));

/// The cycle begun elsewhere.
static ROTATED: Change = Change::new(|| {
    let begun = |case: &Case, first: usize| case.with(invariance::rotated(case, first), &case.files);
    after(|case| case.rotations.iter().map(|first| begun(case, *first)).collect())
});

/// The motion twice in one cycle.
static REPEATED: Change =
    Change::new(|| after(|case| vec![case.with(invariance::repeated(&case.project), &case.files)]));

/// Every direction turned round.
static MIRRORED: Change = Change::new(|| {
    let turned = |case: &Case| {
        let (project, files) = invariance::mirrored(case);
        case.with(project, &files)
    };
    after(|case| case.mirror.then(|| turned(case)).into_iter().collect())
});

/// Holds the figures chosen of all cases against those after a change, but for the factors that they take.
fn hold_unchanged(change: &Change, factor: impl Fn(&str) -> f64, chosen: impl Fn(&Case, &str) -> bool) {
    let mut faults = Vec::new();
    let mut compared = 0;
    for (case, variants) in CASES.iter().zip(change.0.iter()) {
        for other in variants {
            compared += 1;
            faults.extend(moved(case, other, &factor, |key| chosen(case, key)));
        }
    }
    assert!(faults.is_empty(), "{} deviate:\n{}", faults.len(), faults.join("\n"));
    assert!(compared > 40, "{compared} compared");
}

/// Figures that a change which changes nothing moves by more than rounding.
fn moved(case: &Case, after: &Figures, factor: impl Fn(&str) -> f64, chosen: impl Fn(&str) -> bool) -> Vec<String> {
    let before = case.found();
    let mut faults = Vec::new();
    if !before.keys().eq(after.keys()) {
        faults.push(format!("{}: other checks", case.name));
    }
    for (key, value) in before.iter().filter(|(key, _)| chosen(key)) {
        let (value, Some(other)) = (value * factor(key), after.get(key)) else { continue };
        let deviation = relative(value, *other);
        // The torque where its share of a limit is largest: the share is flat there, the torque is not, so the instant,
        // and with it the torque, is known to the root of what the share is.
        // The torque that holds is looked at at the nodes only.
        let allowed = match key.as_str() {
            "torque_speed_trace" => UNCHANGED.sqrt(),
            "brake_holding" => 1e-8,
            _ => UNCHANGED,
        };
        if deviation.is_nan() || deviation > allowed {
            faults.push(format!("{}: {key} {value:.12} becomes {other:.12}, {deviation:.1e}", case.name));
        }
    }
    faults
}

/// An axis that goes on and on swings farther when the cycle is run through twice, or begun elsewhere.
fn travels_on(case: &Case, key: &str) -> bool {
    key == "feedback_range" && case.travels_on()
}

#[test]
fn other_units_change_nothing() {
    hold_unchanged(&OTHER_UNITS, |_| 1.0, |_, key| of_the_load(key));
}

#[test]
fn where_the_cycle_begins_changes_nothing() {
    hold_unchanged(&ROTATED, |_| 1.0, |case, key| of_the_load(key) && !travels_on(case, key));
}

#[test]
fn the_motion_twice_changes_nothing() {
    hold_unchanged(&REPEATED, |_| 1.0, |case, key| of_the_load(key) && !travels_on(case, key));
}

#[test]
fn the_mirrored_axis_asks_the_same() {
    hold_unchanged(&MIRRORED, |_| 1.0, |_, key| of_the_load(key));
}
