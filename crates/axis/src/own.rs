//! An actuator that is not in the catalogue.

use crate::choices;
use crate::curves::curve;
use crate::fault::AxisReport;
use crate::order::is_above;
use crate::sourced::sourced;
use actuator::{Accuracy, Brake, Feedback, FeedbackSide, Gear, OutputBearing, Parameters};
use configurator::Product;
use project::Fault;
use project::sections::{ActuatorSection, KeyValue, Stated, StatedField};
use provenance::Datum;
use quantities::{Measure, ThermodynamicTemperature};

/// Temperatures in the names of the keys `no_load_current_constant_30` and `no_load_current_constant_80`.
const NAMED_CELSIUS: [f64; 2] = [30.0, 80.0];

fn celsius(temperature: f64) -> ThermodynamicTemperature {
    ThermodynamicTemperature::new_in(temperature, &quantities::unit::DEGREE_CELSIUS)
}

/// Returns the actuator; `parameters` are those of one whose file states no value.
pub(crate) fn build(
    section: &ActuatorSection,
    mut parameters: Parameters,
    report: &mut AxisReport<'_>,
) -> Option<Product> {
    if let Datum::Known(stated) = own(&section.winding_temperature_max) {
        parameters.heat.winding_shutdown = Datum::Known(stated);
    }
    parameters.torque_max = own(&section.torque_max);
    parameters.speed_max = own(&section.speed_max);
    parameters.speed_motor_max = own(&section.speed_motor_max);
    parameters.speed_motor_rated = own(&section.speed_motor_rated);
    parameters.inertia_out = own(&section.inertia_out);
    parameters.stall_torque = own(&section.stall_torque);
    parameters.stall_current = own(&section.stall_current);
    parameters.current_max = own(&section.current_max);
    parameters.current_demagnetisation = own(&section.current_demagnetisation);
    parameters.no_load_starting_current = own(&section.no_load_starting_current);
    parameters.no_load_current_constant_cold = own(&section.no_load_current_constant_30);
    parameters.no_load_current_constant_warm = own(&section.no_load_current_constant_80);
    parameters.no_load_temperatures = known(&section.no_load_current_constant_30, NAMED_CELSIUS.map(celsius));
    parameters.torque_constant_out = own(&section.torque_constant_out);
    parameters.torque_constant_motor = own(&section.torque_constant_motor);
    parameters.voltage_constant_motor = own(&section.voltage_constant_motor);
    parameters.resistance_ll = own(&section.resistance_ll);
    parameters.inductance_ll = own(&section.inductance_ll);
    parameters.mass = own(&section.mass);
    parameters.length = own(&section.length);
    parameters.hollow_shaft = own(&section.hollow_shaft);
    parameters.dc_link_max = own(&section.dc_link_max);
    parameters.terminal_voltage_min = own(&section.terminal_voltage_min);
    parameters.ratio = own(&section.ratio);
    parameters.pole_pairs =
        section.pole_pairs.value().map_or(Datum::NotPrinted, |pairs| known(&section.pole_pairs, f64::from(pairs)));
    let [continuous, short_time] =
        [&section.continuous_curve, &section.short_time_curve].map(|points| curve(points, report));
    if let (Some(continuous), Some(short_time)) = (&continuous, &short_time)
        && is_above(continuous, short_time)
    {
        let [lower, upper] = [section.continuous_curve.name(), section.short_time_curve.name()];
        report.fault(section.continuous_curve.span(), Fault::WrongOrder { lower, upper }, None);
    }
    if let Some(curve) = continuous {
        parameters.continuous_curve = known(&section.continuous_curve, curve);
    }
    if let Some(curve) = short_time {
        parameters.short_time_curve = known(&section.short_time_curve, curve);
    }
    parameters.gear = gear(section);
    parameters.accuracy = Accuracy {
        transmission_accuracy: own(&section.transmission_accuracy),
        repeatability: own(&section.repeatability),
        hysteresis_loss: own(&section.hysteresis_loss),
        lost_motion: own(&section.lost_motion),
    };
    parameters.output_bearing = OutputBearing {
        kind: section
            .bearing_type
            .value()
            .map_or(Datum::NotPrinted, |design| known(&section.bearing_type, choices::bearing_type(design))),
        pitch_diameter: own(&section.bearing_pitch_diameter),
        offset: own(&section.bearing_offset),
        dynamic_rating: own(&section.bearing_dynamic),
        static_rating: own(&section.bearing_static),
        tilting_moment_max: own(&section.tilting_moment_max),
        static_moment_max: own(&section.static_moment_max),
        axial_max: own(&section.axial_force_max),
        radial_max: own(&section.radial_force_max),
        tilting_stiffness: own(&section.tilting_stiffness),
        ..parameters.output_bearing.clone()
    };
    parameters.brake = Brake {
        holding_torque: own(&section.brake_torque),
        closing_time: own(&section.brake_closing_time),
        opening_time: own(&section.brake_opening_time),
        ..Brake::default()
    };
    // Data sheets of actuators state the errors of the encoder at the output.
    parameters.feedback = Feedback {
        side: FeedbackSide::Output,
        resolution: own(&section.feedback_resolution),
        accuracy: own(&section.feedback_accuracy),
        ..Feedback::default()
    };
    parameters.heat.winding_time_constant = own(&section.winding_time_constant);
    parameters.ambient_range = ambient_range(section);
    Some(Product::of_project(section.name.get()?, parameters))
}

/// Returns the data of the gear.
fn gear(section: &ActuatorSection) -> Gear {
    Gear {
        torque_1: own(&section.torque_1),
        torque_2: own(&section.torque_2),
        stiffness: [own(&section.stiffness_1), own(&section.stiffness_2), own(&section.stiffness_3)],
        rated_torque: own(&section.gear_torque_rated),
        average_torque_max: own(&section.gear_torque_mean_max),
        collision_torque_max: own(&section.gear_torque_momentary_max),
        rated_life: own(&section.gear_life_rated),
        life_reference_speed: own(&section.gear_life_speed),
        input_speed_max: own(&section.gear_speed_max),
        input_speed_mean_max: own(&section.gear_speed_mean_max),
        ..Gear::default()
    }
}

/// Returns the permitted ambient temperatures if both are stated.
fn ambient_range(section: &ActuatorSection) -> Datum<(ThermodynamicTemperature, ThermodynamicTemperature)> {
    match (section.ambient_min.value(), section.ambient_max.value()) {
        (Some(low), Some(high)) => known(&section.ambient_max, (low, high)),
        _ => Datum::NotPrinted,
    }
}

fn known<T>(field: &dyn StatedField, value: T) -> Datum<T> {
    Datum::Known(sourced(field, value))
}

fn own<T: KeyValue + Copy>(field: &Stated<T>) -> Datum<T> {
    field.value().map_or(Datum::NotPrinted, |value| known(field, value))
}
