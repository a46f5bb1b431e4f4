//! Current, voltage, heat and energy.

use super::{INTEGRAL, MIRRORED, OTHER_UNITS, PEAK, REPEATED, ROTATED, hold, hold_unchanged, of_the_drive};

#[test]
fn current_and_voltage_agree() {
    hold(&["peak_current", "demagnetisation", "voltage"].map(|key| (key, PEAK)), |_| true);
}

#[test]
fn temperature_and_overload_agree() {
    hold(&[("thermal", PEAK), ("overload_i2t", PEAK), ("housing", INTEGRAL)], |_| true);
}

#[test]
fn energy_at_the_terminals_agrees() {
    hold(&[("motoring", INTEGRAL), ("regenerated", INTEGRAL), ("regeneration", INTEGRAL)], |_| true);
    hold(&[("regenerated_peak", PEAK)], |_| true);
}

#[test]
fn other_units_change_nothing_in_the_drive() {
    hold_unchanged(&OTHER_UNITS, |_| 1.0, |_, key| of_the_drive(key));
}

#[test]
fn where_the_cycle_begins_changes_nothing_in_the_drive() {
    hold_unchanged(&ROTATED, |_| 1.0, |_, key| of_the_drive(key));
}

#[test]
fn the_motion_twice_changes_nothing_in_the_drive() {
    // The cycle is twice as long.
    let factor = |key: &str| if ["motoring", "regenerated"].contains(&key) { 2.0 } else { 1.0 };
    hold_unchanged(&REPEATED, factor, |_, key| of_the_drive(key));
}

#[test]
fn the_mirrored_axis_asks_the_same_of_the_drive() {
    hold_unchanged(&MIRRORED, |_| 1.0, |_, key| of_the_drive(key));
}
