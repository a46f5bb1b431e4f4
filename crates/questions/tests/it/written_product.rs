//! A product of the catalogue as the user would write it from its data sheet.
#![allow(clippy::unwrap_used, reason = "a test fails loudly")]

use actuator::{BearingType, Gear, Parameters};
use provenance::Datum;
use quantities::Measure;
use quantities::unit::DEGREE_CELSIUS;

/// A key with its value as written and its unit; no value if the product has none, no unit if the key has none.
pub(crate) type Stated = (&'static str, Option<String>, &'static str);

/// Returns the data of gear, bearing, brake and encoder of a product.
pub(crate) fn written(parameters: &Parameters) -> Vec<Stated> {
    fn quantity<T: Measure + Copy>(key: &'static str, datum: &Datum<T>, unit: &'static str) -> Stated {
        (key, datum.known().map(|known| format!("{:?}", known.value.si())), unit)
    }
    let Gear { torque_1, torque_2, stiffness: [k1, k2, k3], .. } = &parameters.gear;
    let Gear { rated_torque, average_torque_max, collision_torque_max, life_reference_speed, .. } = &parameters.gear;
    let bearing = &parameters.output_bearing;
    let life = parameters.gear.nominal_life.known().zip(parameters.gear.life_ratio.known());
    let (low, high) = parameters.ambient_range.known().unwrap().value;
    let [low, high] = [low, high].map(|temperature| temperature.in_unit(&DEGREE_CELSIUS).to_string());
    let design = match bearing.kind.known().unwrap().value {
        BearingType::CrossedRoller => "crossed_roller",
        BearingType::FourPoint => "four_point",
    };
    let ratio = &parameters.ratio;
    vec![
        ("ratio", Some(ratio.known().unwrap().value.to_string()), ""),
        ("ambient_min", Some(low), "degC"),
        ("ambient_max", Some(high), "degC"),
        ("bearing_type", Some(design.to_owned()), ""),
        ("gear_life_rated", life.map(|(life, ratio)| format!("{:?}", life.value.si() / ratio.value)), "s"),
        quantity("inertia_out", &parameters.inertia_out, "kg m^2"),
        quantity("torque_max", &parameters.torque_max, "N m"),
        quantity("gear_torque_rated", rated_torque, "N m"),
        quantity("gear_torque_mean_max", average_torque_max, "N m"),
        quantity("gear_torque_momentary_max", collision_torque_max, "N m"),
        quantity("gear_speed_max", &parameters.gear.input_speed_max, "rad/s"),
        quantity("gear_speed_mean_max", &parameters.gear.input_speed_mean_max, "rad/s"),
        quantity("gear_life_speed", life_reference_speed, "rad/s"),
        quantity("stiffness_1", k1, "N m/rad"),
        quantity("stiffness_2", k2, "N m/rad"),
        quantity("stiffness_3", k3, "N m/rad"),
        quantity("torque_1", torque_1, "N m"),
        quantity("torque_2", torque_2, "N m"),
        quantity("transmission_accuracy", &parameters.accuracy.transmission_accuracy, "rad"),
        quantity("repeatability", &parameters.accuracy.repeatability, "rad"),
        quantity("hysteresis_loss", &parameters.accuracy.hysteresis_loss, "rad"),
        quantity("lost_motion", &parameters.accuracy.lost_motion, "rad"),
        quantity("feedback_resolution", &parameters.feedback.resolution_out(ratio), "rad"),
        quantity("feedback_accuracy", &parameters.feedback.accuracy_out(ratio), "rad"),
        quantity("bearing_pitch_diameter", &bearing.pitch_diameter, "m"),
        quantity("bearing_offset", &bearing.offset, "m"),
        quantity("bearing_dynamic", &bearing.dynamic_rating, "N"),
        quantity("bearing_static", &bearing.static_rating, "N"),
        quantity("tilting_moment_max", &bearing.tilting_moment_max, "N m"),
        quantity("static_moment_max", &bearing.static_moment_max, "N m"),
        quantity("axial_force_max", &bearing.axial_max, "N"),
        quantity("radial_force_max", &bearing.radial_max, "N"),
        quantity("tilting_stiffness", &bearing.tilting_stiffness, "N m/rad"),
        quantity("brake_torque", &parameters.brake.holding_torque, "N m"),
        quantity("brake_closing_time", &parameters.brake.closing_time, "s"),
        quantity("brake_opening_time", &parameters.brake.opening_time, "s"),
    ]
}

/// Returns the lines of a table in TOML.
pub(crate) fn toml(stated: &[Stated]) -> String {
    let line = |(key, value, unit): &Stated| match (value, *unit) {
        (None, _) => String::new(),
        (Some(value), "") if value.parse::<f64>().is_ok() => format!("{key} = {value}\n"),
        (Some(value), "") => format!("{key} = \"{value}\"\n"),
        (Some(value), unit) => format!("{key} = \"{value} {unit}\"\n"),
    };
    stated.iter().map(line).collect()
}
