//! `[twin]` of a generated project: scenario, switches, gains and measured values.

use super::page::{ANGLE, CURRENT, INERTIA, Page, TIME, TORQUE, UnitSpellings};
use arbitrary::Result;

const SCENARIOS: [&str; 12] = [
    "cycle",
    "emergency_stop",
    "power_failure",
    "brake_stuck",
    "hanging_load",
    "blocked_load",
    "encoder_failure",
    "battery_loss",
    "link_sag",
    "hot_ambient",
    "cold_grease",
    "collision",
];

const SWITCHES: [&str; 7] = ["cold", "friction", "hysteresis", "kinematic_error", "delay", "limits", "noise"];

/// Gains, with their ranges.
const GAINS: [(&str, f64, f64, UnitSpellings); 3] = [
    ("position_gain", 0.1, 1e4, &[("1/s", 1.0)]),
    ("speed_gain", 0.1, 1e6, &[("N m s/rad", 1.0)]),
    ("current_gain", 0.1, 1e4, &[("V/A", 1.0)]),
];

const TIMES: [(&str, f64, f64); 3] =
    [("speed_time", 1e-5, 1.0), ("speed_filter", 1e-6, 0.1), ("current_time", 1e-5, 1.0)];

const STIFFNESS: UnitSpellings = &[("N m/rad", 1.0)];
const OHM: UnitSpellings = &[("ohm", 1.0)];

/// Measured values, with ranges from far below to far above the usual.
const MEASURED: [(&str, f64, f64, UnitSpellings); 22] = [
    ("resistance_ll", 0.01, 100.0, OHM),
    ("inductance_ll", 0.01, 100.0, &[("mH", 1.0)]),
    ("torque_constant_out", 0.1, 1e3, &[("N m/A", 1.0)]),
    ("torque_constant_motor", 1e-3, 10.0, &[("N m/A", 1.0)]),
    ("inertia_out", 1e-4, 100.0, INERTIA),
    ("no_load_starting_current", 0.0, 10.0, CURRENT),
    ("gear_torque_1", 0.1, 50.0, TORQUE),
    ("gear_torque_2", 50.0, 500.0, TORQUE),
    ("gear_stiffness_1", 1.0, 1e7, STIFFNESS),
    ("gear_stiffness_2", 1.0, 1e7, STIFFNESS),
    ("gear_stiffness_3", 1.0, 1e7, STIFFNESS),
    ("transmission_accuracy", 0.0, 1.0, ANGLE),
    ("hysteresis_loss", 0.0, 1.0, ANGLE),
    ("lost_motion", 1e-4, 1.0, ANGLE),
    ("brake_torque", 0.0, 500.0, TORQUE),
    ("winding_time_constant", 1e-3, 1e5, TIME),
    ("supply_resistance", 0.0, 1e4, OHM),
    ("brake_resistor", 1e-3, 1e4, OHM),
    ("stop_stiffness", 1.0, 1e9, STIFFNESS),
    ("load_inertia", 1e-4, 100.0, INERTIA),
    ("load_coulomb", 0.0, 100.0, TORQUE),
    ("load_external", -100.0, 100.0, TORQUE),
];

const SHARES: [(&str, f64, f64); 6] = [
    ("flange_inertia_share", 0.0, 0.9),
    ("gear_damping_ratio", 0.0, 1.0),
    ("breakaway_ratio", 1.0, 10.0),
    ("kinematic_share_2", 0.0, 1.0),
    ("chopper_on", 1.5, 2.0),
    ("chopper_off", 1.0, 1.5),
];

pub(super) fn twin(page: &mut Page<'_, '_>) -> Result<()> {
    page.table("twin");
    if page.often()? {
        let scenario = *page.u.choose(&SCENARIOS)?;
        page.word("scenario", scenario);
    }
    page.may("at", 0.0, 5.0, TIME)?;
    if page.u.ratio(1, 3)? {
        let reaction = *page.u.choose(&["ramp", "brake", "coast"])?;
        page.word("reaction", reaction);
    }
    if page.u.ratio(1, 3)? {
        let failure = *page.u.choose(&["track", "amplitude", "cable", "check", "error_bit", "data_line"])?;
        page.word("failure", failure);
    }
    for switch in SWITCHES {
        if page.seldom()? {
            let on: bool = page.u.arbitrary()?;
            page.plain(switch, on);
        }
    }
    for (key, low, high, units) in GAINS {
        if page.seldom()? {
            page.key(key, low, high, units)?;
        }
    }
    for (key, low, high) in TIMES {
        if page.seldom()? {
            page.key(key, low, high, TIME)?;
        }
    }
    if page.u.ratio(1, 2)? {
        page.table("twin.measured");
        for (key, low, high, units) in MEASURED {
            if page.seldom()? {
                page.key(key, low, high, units)?;
            }
        }
        for (key, low, high) in SHARES {
            if page.seldom()? {
                page.may_number(key, low, high)?;
            }
        }
    }
    Ok(())
}
