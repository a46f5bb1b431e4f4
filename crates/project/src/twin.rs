//! `[twin]`: settings of the simulation of an axis, and measured values that replace those of the model.

use crate::about::About;
use crate::choices::{Failure, Reaction, ScenarioId};
use crate::section::section;
use quantities::{
    Angle, CurrentGain, ElectricCurrent, ElectricalResistance, Energy, Inductance, MomentOfInertia,
    NoLoadCurrentConstant, PositionGain, SpeedGain, ThermodynamicTemperature, Time, Torque, TorqueConstant,
    TorsionalStiffness, ViscousFriction, VoltageConstant,
};

section! {
    /// The simulation.
    TwinSection, TwinName of About::Twin {
        scenario: ScenarioId;
        at: Time => not_negative, example("0.3 s");
        reaction: Reaction;
        failure: Failure;
        cycles: u32 => whole(1, 100_000), example("10");
        cold: bool;
        friction: bool;
        hysteresis: bool;
        kinematic_error: bool;
        delay: bool;
        limits: bool;
        noise: bool;
        position_gain: PositionGain => positive;
        speed_gain: SpeedGain => positive;
        speed_time: Time => positive, example("5 ms");
        speed_filter: Time => not_negative, example("0.2 ms");
        current_gain: CurrentGain => positive;
        current_time: Time => positive, example("1.4 ms");
        following_error_max: Angle => positive, example("1 deg");
        measured: MeasuredSection;
    }
}

section! {
    /// Measured values.
    MeasuredSection, ReplacedName of About::Replaced {
        resistance_ll: ElectricalResistance => positive;
        inductance_ll: Inductance => positive;
        torque_constant_motor: TorqueConstant => positive;
        torque_constant_out: TorqueConstant => positive;
        voltage_constant_motor: VoltageConstant => positive;
        inertia_out: MomentOfInertia => positive;
        no_load_starting_current: ElectricCurrent => not_negative;
        no_load_current_constant_cold: NoLoadCurrentConstant => not_negative;
        no_load_current_constant_warm: NoLoadCurrentConstant => not_negative;
        gear_torque_1: Torque => positive;
        gear_torque_2: Torque => positive;
        gear_stiffness_1: TorsionalStiffness => positive;
        gear_stiffness_2: TorsionalStiffness => positive;
        gear_stiffness_3: TorsionalStiffness => positive;
        transmission_accuracy: Angle => not_negative;
        hysteresis_loss: Angle => not_negative;
        lost_motion: Angle => positive;
        brake_torque: Torque => not_negative;
        brake_opening_time: Time => not_negative;
        brake_closing_time: Time => not_negative;
        feedback_accuracy: Angle => not_negative;
        winding_time_constant: Time => positive;
        housing_time_constant: Time => positive;
        flange_inertia_share: f64 => within(0.0, 0.9), example("0.02");
        gear_damping_ratio: f64 => within(0.0, 1.0), example("0.03");
        breakaway_ratio: f64 => within(1.0, 10.0), example("1.2");
        kinematic_share_1: f64 => within(0.0, 1.0), example("0.15");
        kinematic_share_2: f64 => within(0.0, 1.0), example("0.5");
        kinematic_share_4: f64 => within(0.0, 1.0), example("0.1");
        kinematic_share_out: f64 => within(0.0, 1.0), example("0.25");
        sensor_lag: Time => not_negative;
        ptc_lag: Time => not_negative;
        ptc_response_temperature: ThermodynamicTemperature => positive;
        link_energy: Energy => positive;
        supply_resistance: ElectricalResistance => not_negative;
        brake_resistor: ElectricalResistance => positive;
        chopper_on: f64 => within(1.0, 2.0), example("1.15");
        chopper_off: f64 => within(1.0, 2.0), example("1.12");
        stop_stiffness: TorsionalStiffness => positive;
        current_noise: ElectricCurrent => not_negative;
        load_inertia: MomentOfInertia => positive;
        load_coulomb: Torque => not_negative;
        load_viscous: ViscousFriction => not_negative;
        load_gravity: Torque => not_negative;
        load_gravity_angle: Angle;
        load_external: Torque;
    }
}
