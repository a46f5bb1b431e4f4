//! An actuator that is not in the catalogue.

use crate::about::About;
use crate::curves::CURVE;
use crate::section::section;
use crate::value::{CurveRow, Rows};
use quantities::{
    AngularVelocity, ElectricCurrent, ElectricPotential, ElectricalResistance, Inductance, Length, Mass,
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
        short_time_curve: Rows<CurveRow> => example(CURVE);
        continuous_curve: Rows<CurveRow> => example(CURVE);
    }
}
