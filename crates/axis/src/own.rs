//! An actuator that is not in the catalogue.

use crate::choices;
use crate::curves::curve;
use crate::fault::AxisReport;
use crate::order::is_above;
use crate::sourced::Origin;
use actuator::{Accuracy, Brake, Feedback, FeedbackSide, Gear, OutputBearing, Parameters};
use configurator::Product;
use project::Fault;
use project::sections::{ActuatorSection, ActuatorValues, StatedField};
use provenance::Datum;
use quantities::{Measure, ThermodynamicTemperature};

/// Temperatures in the names of the keys `no_load_current_constant_30` and `no_load_current_constant_80`.
const NAMED_CELSIUS: [f64; 2] = [30.0, 80.0];

fn celsius(temperature: f64) -> ThermodynamicTemperature {
    ThermodynamicTemperature::new_in(temperature, &quantities::unit::DEGREE_CELSIUS)
}

/// Returns the actuator; `parameters` are those of one whose file states no value.
pub(crate) fn build(section: &ActuatorSection, parameters: Parameters, report: &mut AxisReport<'_>) -> Option<Product> {
    let parameters = stated(&section.values, parameters, &Origin::Project, report);
    Some(Product::of_project(section.name.get()?, parameters))
}

/// Returns the parameters with the stated values; `parameters` are those of an actuator whose file states no value.
pub(crate) fn stated(
    values: &ActuatorValues,
    mut parameters: Parameters,
    origin: &Origin<'_>,
    report: &mut AxisReport<'_>,
) -> Parameters {
    if let Datum::Known(limit) = origin.datum(&values.winding_temperature_max) {
        parameters.heat.winding_shutdown = Datum::Known(limit);
    }
    parameters.torque_max = origin.datum(&values.torque_max);
    parameters.speed_max = origin.datum(&values.speed_max);
    parameters.speed_motor_max = origin.datum(&values.speed_motor_max);
    parameters.speed_motor_rated = origin.datum(&values.speed_motor_rated);
    parameters.inertia_out = origin.datum(&values.inertia_out);
    parameters.stall_torque = origin.datum(&values.stall_torque);
    parameters.stall_current = origin.datum(&values.stall_current);
    parameters.current_max = origin.datum(&values.current_max);
    parameters.current_demagnetisation = origin.datum(&values.current_demagnetisation);
    parameters.no_load_starting_current = origin.datum(&values.no_load_starting_current);
    parameters.no_load_current_constant_cold = origin.datum(&values.no_load_current_constant_30);
    parameters.no_load_current_constant_warm = origin.datum(&values.no_load_current_constant_80);
    parameters.no_load_temperatures = origin.known(&values.no_load_current_constant_30, NAMED_CELSIUS.map(celsius));
    parameters.torque_constant_out = origin.datum(&values.torque_constant_out);
    parameters.torque_constant_motor = origin.datum(&values.torque_constant_motor);
    parameters.voltage_constant_motor = origin.datum(&values.voltage_constant_motor);
    parameters.resistance_ll = origin.datum(&values.resistance_ll);
    parameters.inductance_ll = origin.datum(&values.inductance_ll);
    parameters.mass = origin.datum(&values.mass);
    parameters.length = origin.datum(&values.length);
    parameters.hollow_shaft = origin.datum(&values.hollow_shaft);
    parameters.dc_link_max = origin.datum(&values.dc_link_max);
    parameters.terminal_voltage_min = origin.datum(&values.terminal_voltage_min);
    parameters.ratio = origin.datum(&values.ratio);
    parameters.pole_pairs =
        values.pole_pairs.value().map_or(Datum::NotPrinted, |pairs| origin.known(&values.pole_pairs, f64::from(pairs)));
    let [continuous, short_time] =
        [&values.continuous_curve, &values.short_time_curve].map(|points| curve(points, report));
    if let (Some(continuous), Some(short_time)) = (&continuous, &short_time)
        && is_above(continuous, short_time)
    {
        let [lower, upper] = [values.continuous_curve.name(), values.short_time_curve.name()];
        report.fault(values.continuous_curve.span(), Fault::WrongOrder { lower, upper }, None);
    }
    if let Some(curve) = continuous {
        parameters.continuous_curve = origin.known(&values.continuous_curve, curve);
    }
    if let Some(curve) = short_time {
        parameters.short_time_curve = origin.known(&values.short_time_curve, curve);
    }
    parameters.gear = gear(values, origin);
    parameters.accuracy = Accuracy {
        transmission_accuracy: origin.datum(&values.transmission_accuracy),
        repeatability: origin.datum(&values.repeatability),
        hysteresis_loss: origin.datum(&values.hysteresis_loss),
        lost_motion: origin.datum(&values.lost_motion),
    };
    parameters.output_bearing = OutputBearing {
        kind: values
            .bearing_type
            .value()
            .map_or(Datum::NotPrinted, |design| origin.known(&values.bearing_type, choices::bearing_type(design))),
        pitch_diameter: origin.datum(&values.bearing_pitch_diameter),
        offset: origin.datum(&values.bearing_offset),
        dynamic_rating: origin.datum(&values.bearing_dynamic),
        static_rating: origin.datum(&values.bearing_static),
        tilting_moment_max: origin.datum(&values.tilting_moment_max),
        static_moment_max: origin.datum(&values.static_moment_max),
        axial_max: origin.datum(&values.axial_force_max),
        radial_max: origin.datum(&values.radial_force_max),
        tilting_stiffness: origin.datum(&values.tilting_stiffness),
        ..parameters.output_bearing.clone()
    };
    parameters.brake = Brake {
        holding_torque: origin.datum(&values.brake_torque),
        closing_time: origin.datum(&values.brake_closing_time),
        opening_time: origin.datum(&values.brake_opening_time),
        ..Brake::default()
    };
    // Data sheets of actuators state the errors of the encoder at the output.
    parameters.feedback = Feedback {
        side: FeedbackSide::Output,
        resolution: origin.datum(&values.feedback_resolution),
        accuracy: origin.datum(&values.feedback_accuracy),
        ..Feedback::default()
    };
    parameters.heat.winding_time_constant = origin.datum(&values.winding_time_constant);
    parameters.ambient_range = ambient_range(values, origin);
    parameters
}

/// Returns the data of the gear.
fn gear(values: &ActuatorValues, origin: &Origin<'_>) -> Gear {
    Gear {
        torque_1: origin.datum(&values.torque_1),
        torque_2: origin.datum(&values.torque_2),
        stiffness: [
            origin.datum(&values.stiffness_1),
            origin.datum(&values.stiffness_2),
            origin.datum(&values.stiffness_3),
        ],
        rated_torque: origin.datum(&values.gear_torque_rated),
        average_torque_max: origin.datum(&values.gear_torque_mean_max),
        collision_torque_max: origin.datum(&values.gear_torque_momentary_max),
        rated_life: origin.datum(&values.gear_life_rated),
        life_reference_speed: origin.datum(&values.gear_life_speed),
        input_speed_max: origin.datum(&values.gear_speed_max),
        input_speed_mean_max: origin.datum(&values.gear_speed_mean_max),
        ..Gear::default()
    }
}

/// Returns the permitted ambient temperatures if both are stated.
fn ambient_range(
    values: &ActuatorValues,
    origin: &Origin<'_>,
) -> Datum<(ThermodynamicTemperature, ThermodynamicTemperature)> {
    match (values.ambient_min.value(), values.ambient_max.value()) {
        (Some(low), Some(high)) => origin.known(&values.ambient_max, (low, high)),
        _ => Datum::NotPrinted,
    }
}
