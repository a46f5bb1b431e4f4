//! An actuator that is not in the catalogue.

use crate::Fault;
use crate::about::About;
use crate::curves::{CURVE, curve};
use crate::order::is_above;
use crate::read::Reader;
use crate::section::section;
use crate::stated::{Stated, StatedField};
use crate::value::Rows;
use actuator::{CurvePoint, Parameters};
use configurator::Product;
use provenance::{Datum, Grade, Source, Sourced};
use quantities::{
    AngularVelocity, ElectricCurrent, ElectricPotential, ElectricalResistance, Inductance, Length, Mass, Measure,
    MomentOfInertia, NoLoadCurrentConstant, ThermodynamicTemperature, Torque, TorqueConstant, VoltageConstant,
};

section! {
    /// An actuator that is not in the catalogue.
    ActuatorSection, ActuatorName of About::Actuator {
        name: String => needed;
        ratio: f64 => within(1.0, 10_000.0), example("50");
        torque_max: Torque => positive;
        speed_max: AngularVelocity => positive;
        speed_motor_max: AngularVelocity => positive, example("6000 1/min");
        speed_motor_rated: AngularVelocity => positive, example("3500 1/min");
        inertia_out: MomentOfInertia => not_negative;
        stall_torque: Torque => positive;
        stall_current: ElectricCurrent => positive;
        current_max: ElectricCurrent => positive;
        current_demagnetisation: ElectricCurrent => positive;
        no_load_starting_current: ElectricCurrent => not_negative;
        no_load_current_constant_30: NoLoadCurrentConstant => not_negative;
        no_load_current_constant_80: NoLoadCurrentConstant => not_negative;
        torque_constant_out: TorqueConstant => positive;
        torque_constant_motor: TorqueConstant => positive;
        voltage_constant_motor: VoltageConstant => positive;
        resistance_ll: ElectricalResistance => positive;
        winding_temperature_max: ThermodynamicTemperature;
        inductance_ll: Inductance => positive;
        pole_pairs: u32 => whole(1, 100), example("5");
        mass: Mass => positive;
        length: Length => positive, example("120 mm");
        hollow_shaft: Length => not_negative, example("18 mm");
        dc_link_max: ElectricPotential => positive;
        terminal_voltage_min: ElectricPotential => positive;
        short_time_curve: Rows<CurvePoint> => example(CURVE);
        continuous_curve: Rows<CurvePoint> => example(CURVE);
    }
}

/// Temperatures in the names of the keys `no_load_current_constant_30` and `no_load_current_constant_80`.
const NAMED_CELSIUS: [f64; 2] = [30.0, 80.0];

fn celsius(temperature: f64) -> ThermodynamicTemperature {
    ThermodynamicTemperature::new_in(temperature, &quantities::unit::DEGREE_CELSIUS)
}

impl ActuatorSection {
    /// Returns the actuator; `parameters` are those of one whose file states no value.
    pub(crate) fn build(&self, mut parameters: Parameters, reader: &mut Reader<'_>) -> Option<Product> {
        if let Datum::Known(stated) = own(&self.winding_temperature_max) {
            parameters.heat.winding_shutdown = Datum::Known(stated);
        }
        parameters.torque_max = own(&self.torque_max);
        parameters.speed_max = own(&self.speed_max);
        parameters.speed_motor_max = own(&self.speed_motor_max);
        parameters.speed_motor_rated = own(&self.speed_motor_rated);
        parameters.inertia_out = own(&self.inertia_out);
        parameters.stall_torque = own(&self.stall_torque);
        parameters.stall_current = own(&self.stall_current);
        parameters.current_max = own(&self.current_max);
        parameters.current_demagnetisation = own(&self.current_demagnetisation);
        parameters.no_load_starting_current = own(&self.no_load_starting_current);
        parameters.no_load_current_constant_cold = own(&self.no_load_current_constant_30);
        parameters.no_load_current_constant_warm = own(&self.no_load_current_constant_80);
        parameters.no_load_temperatures = known(&self.no_load_current_constant_30, NAMED_CELSIUS.map(celsius));
        parameters.torque_constant_out = own(&self.torque_constant_out);
        parameters.torque_constant_motor = own(&self.torque_constant_motor);
        parameters.voltage_constant_motor = own(&self.voltage_constant_motor);
        parameters.resistance_ll = own(&self.resistance_ll);
        parameters.inductance_ll = own(&self.inductance_ll);
        parameters.mass = own(&self.mass);
        parameters.length = own(&self.length);
        parameters.hollow_shaft = own(&self.hollow_shaft);
        parameters.dc_link_max = own(&self.dc_link_max);
        parameters.terminal_voltage_min = own(&self.terminal_voltage_min);
        parameters.ratio = own(&self.ratio);
        parameters.pole_pairs =
            self.pole_pairs.value().map_or(Datum::NotPrinted, |pairs| known(&self.pole_pairs, f64::from(pairs)));
        let [continuous, short_time] =
            [&self.continuous_curve, &self.short_time_curve].map(|points| curve(points, reader));
        if let (Some(continuous), Some(short_time)) = (&continuous, &short_time)
            && is_above(continuous, short_time)
        {
            let [lower, upper] = [self.continuous_curve.name(), self.short_time_curve.name()];
            reader.fault(self.continuous_curve.span(), Fault::WrongOrder { lower, upper }, None);
        }
        if let Some(curve) = continuous {
            parameters.continuous_curve = known(&self.continuous_curve, curve);
        }
        if let Some(curve) = short_time {
            parameters.short_time_curve = known(&self.short_time_curve, curve);
        }
        Some(Product::of_project(self.name.get()?, parameters))
    }
}

/// Returns a value of the user with its source: graded as published, since it is taken from a document of the user.
pub(crate) fn sourced<T>(field: &dyn StatedField, value: T) -> Sourced<T> {
    Sourced { value, source: Source::Project { key: field.path().into() }, grade: Grade::Published, errata: &[] }
}

fn known<T>(field: &dyn StatedField, value: T) -> Datum<T> {
    Datum::Known(sourced(field, value))
}

fn own<T: crate::value::KeyValue + Copy>(field: &Stated<T>) -> Datum<T> {
    field.value().map_or(Datum::NotPrinted, |value| known(field, value))
}
