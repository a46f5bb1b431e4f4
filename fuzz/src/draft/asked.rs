//! Requirements of a generated project, and its own actuator and curves.

use super::page::{
    ANGLE, CURRENT, INERTIA, LENGTH, LIFE, MASS, Page, SPEED, TEMPERATURE, TIME, TORQUE, UnitSpellings, VOLTAGE,
};
use arbitrary::Result;

/// Keys with a quantity: name, lower and upper end of the usual range, units.
const LIMITS: [(&str, f64, f64, UnitSpellings); 18] = [
    ("hollow_shaft_min", 5.0, 60.0, LENGTH),
    ("length_max", 80.0, 400.0, LENGTH),
    ("mass_max", 2.0, 60.0, MASS),
    ("bearing_life_min", 1e3, 1e5, LIFE),
    ("gear_life_min", 1e3, 1e5, LIFE),
    ("torsion_max", 0.005, 0.5, ANGLE),
    ("natural_frequency_min", 1.0, 80.0, &[("Hz", 1.0)]),
    ("tilt_angle_max", 0.001, 0.1, ANGLE),
    ("angle_error_max", 0.005, 0.5, ANGLE),
    ("lever_arm", 20.0, 1500.0, LENGTH),
    ("resolution_max", 1e-4, 0.1, ANGLE),
    ("stop_angle_max", 1.0, 360.0, ANGLE),
    ("service_life", 100.0, 1e5, LIFE),
    ("regeneration_power_max", 0.1, 500.0, &[("W", 1.0)]),
    ("operation_per_day", 0.0, 24.0, LIFE),
    ("storage", 0.0, 5e4, LIFE),
    ("battery_life_min", 1e3, 1e5, LIFE),
    ("dc_link_rise", 5.0, 200.0, VOLTAGE),
];

pub(super) fn requirements(page: &mut Page<'_, '_>) -> Result<()> {
    page.table("requirements");
    if page.often()? {
        let supply = *page.u.choose(&[560.0, 680.0, 325.0, 48.0])?;
        page.exactly("supply", supply, VOLTAGE)?;
        page.may_number("modulation_reserve", 0.5, 1.0)?;
    }
    if page.often()? {
        let ambient = page.between(0.0, 45.0)?;
        let ambient = page.literal(ambient, TEMPERATURE)?;
        page.word("ambient", &ambient);
    }
    // Along a line there is no lever arm.
    let mechanism = page.text.rsplit_once("mechanism.").map_or("", |(_, mechanism)| mechanism);
    let turns = mechanism.is_empty() || ["arm]", "turntable]"].iter().any(|kind| mechanism.starts_with(kind));
    for (key, low, high, units) in LIMITS {
        if page.u.ratio(1, 8)? && (turns || key != "lever_arm") {
            page.key(key, low, high, units)?;
            // Keys that have an effect only beside this one.
            if key == "lever_arm" && page.often()? {
                page.key("deviation_max", 0.01, 5.0, LENGTH)?;
            }
        }
    }
    if page.u.ratio(1, 8)? {
        page.key("collision_torque", 5.0, 900.0, TORQUE)?;
        if page.often()? {
            page.key("collision_time", 0.001, 0.5, TIME)?;
        }
        if page.often()? {
            let count = page.u.int_in_range(0..=500)?;
            page.plain("collisions", count);
        }
    }
    for key in ["brake", "absolute"] {
        if page.seldom()? {
            let value: bool = page.u.arbitrary()?;
            page.plain(key, value);
        }
    }
    if page.seldom()? {
        let count = page.u.int_in_range(0..=2000)?;
        page.plain("emergency_stops", count);
    }
    if page.seldom()? {
        let some = *page.u.choose(&["[\"M512P\"]", "[\"RES\", \"C1024\"]", "[\"M128S\"]", "[\"D2048\"]"])?;
        page.plain("feedback", some);
    }
    page.may_number("holding_safety", 1.0, 3.0)?;
    if page.seldom()? {
        page.word("option_1", "EC");
        page.may_word("position_loop", &["motor", "output"])?;
    }
    if page.seldom()? {
        page.may_word("option_2", &["K", "R", "S"])?;
        page.may_word("special_application", &["medical", "vacuum", "aerospace", "lifting_of_persons"])?;
    }
    Ok(())
}

/// Writes a user's own actuator, with all its data or a part of them; the ranges keep the order of rated and largest values.
pub(super) fn actuator(page: &mut Page<'_, '_>) -> Result<()> {
    let data: [(&str, f64, f64, UnitSpellings); 21] = [
        ("torque_max", 20.0, 900.0, TORQUE),
        ("speed_max", 20.0, 200.0, SPEED),
        ("speed_motor_max", 4000.0, 8500.0, SPEED),
        ("speed_motor_rated", 2000.0, 3500.0, SPEED),
        ("inertia_out", 0.05, 8.0, INERTIA),
        ("stall_torque", 2.0, 20.0, TORQUE),
        ("stall_current", 0.2, 1.0, CURRENT),
        ("current_max", 1.0, 40.0, CURRENT),
        ("current_demagnetisation", 40.0, 120.0, CURRENT),
        ("no_load_starting_current", 0.02, 0.8, CURRENT),
        ("no_load_current_constant_30", 1e-4, 0.05, &[("A/(1/min)", 1.0)]),
        ("no_load_current_constant_80", 1e-4, 0.05, &[("A/(1/min)", 1.0)]),
        ("torque_constant_out", 5.0, 120.0, &[("N m/A", 1.0)]),
        ("torque_constant_motor", 0.05, 1.5, &[("N m/A", 1.0)]),
        ("voltage_constant_motor", 5.0, 100.0, &[("V/1000 1/min", 1.0)]),
        ("resistance_ll", 0.1, 20.0, &[("ohm", 1.0)]),
        ("inductance_ll", 0.1, 40.0, &[("mH", 1.0)]),
        ("mass", 1.0, 60.0, MASS),
        ("length", 60.0, 400.0, LENGTH),
        ("hollow_shaft", 10.0, 60.0, LENGTH),
        ("dc_link_max", 48.0, 700.0, VOLTAGE),
    ];
    page.table("actuator");
    page.word("name", "own actuator");
    let all = page.u.ratio(1, 2)?;
    page.may_number("ratio", 30.0, 160.0)?;
    for (key, low, high, units) in data {
        if all || page.u.ratio(1, 2)? {
            page.key(key, low, high, units)?;
        }
    }
    if page.u.ratio(1, 3)? {
        let hottest = page.between(80.0, 140.0)?;
        let hottest = page.literal(hottest, TEMPERATURE)?;
        page.word("winding_temperature_max", &hottest);
    }
    if page.u.ratio(1, 2)? {
        let pairs = page.u.int_in_range(1..=12)?;
        page.plain("pole_pairs", pairs);
    }
    // Both have an order, which random corners do not keep.
    if page.u.ratio(1, 2)? {
        let key = *page.u.choose(&["continuous_curve", "short_time_curve"])?;
        let corners = corners(page)?;
        page.plain(key, corners);
    }
    Ok(())
}

/// Writes a user's own curve for actuators of the catalogue.
pub(super) fn curve(page: &mut Page<'_, '_>) -> Result<()> {
    page.row("curve");
    let kind = *page.u.choose(&["continuous", "s3_50", "s3_25", "short_time"])?;
    page.word("kind", kind);
    let code = *page.u.choose(&["CHA-25A-100-*", "CHA-*-50-H-*", "CHA-32A-50-H-C1024"])?;
    page.word("code", code);
    let corners = corners(page)?;
    page.plain("points", corners);
    page.word("source", "test bench");
    Ok(())
}

/// Returns corner points from standstill with falling torque.
fn corners(page: &mut Page<'_, '_>) -> Result<String> {
    let (mut speed, mut torque) = (0.0, page.between(20.0, 600.0)?);
    let mut rows = Vec::new();
    for _ in 0..page.u.int_in_range(2..=5)? {
        rows.push(format!("[\"{speed:.1} 1/min\", \"{torque:.2} N m\"]"));
        speed += page.between(5.0, 60.0)?;
        torque *= page.between(0.3, 1.0)?;
    }
    Ok(format!("[{}]", rows.join(", ")))
}
