//! `[twin]`: settings of the simulation of an axis, and measured values that replace those of the model.

use crate::about::About;
use crate::own::sourced;
use crate::section::{Fields, section};
use crate::stated::StatedField;
use crate::value::choices_by_id;
use ::feedback::Failure;
use ::twin::{Gains, Limits, Reaction, Scenario, ScenarioId, Switches};
use provenance::Sourced;
use quantities::{
    Angle, ElectricCurrent, ElectricalResistance, Energy, Inductance, Measure, MomentOfInertia, NoLoadCurrentConstant,
    ThermodynamicTemperature, Time, Torque, TorqueConstant, TorsionalStiffness, ViscousFriction, VoltageConstant,
};

/// Simulation as the project states it.
#[derive(Clone, Debug, Default)]
pub struct TwinInput {
    /// The project has the section.
    pub stated: bool,
    /// Scenario.
    pub scenario: Scenario,
    /// Active parts of the model.
    pub switches: Switches,
    /// Replaced parameters, by key.
    pub replaced: Vec<(&'static str, Sourced<f64>)>,
    /// Stated gains: position, speed with time and filter, current with time.
    gains: [Option<f64>; 6],
    following_rad: Option<f64>,
}

impl TwinInput {
    /// Returns the gains with the stated ones in place of `usual`.
    #[must_use]
    pub fn gains(&self, usual: Gains) -> Gains {
        let [position, speed, speed_time, filter, current, current_time] = self.gains;
        Gains {
            position_p: position.unwrap_or(usual.position_p),
            speed_p: speed.unwrap_or(usual.speed_p),
            speed_time_s: speed_time.unwrap_or(usual.speed_time_s),
            speed_filter_s: filter.unwrap_or(usual.speed_filter_s),
            current_p: current.unwrap_or(usual.current_p),
            current_time_s: current_time.unwrap_or(usual.current_time_s),
            ..usual
        }
    }

    /// Returns the supervision limits with the stated ones in place of `usual`.
    #[must_use]
    pub fn limits(&self, usual: Limits) -> Limits {
        Limits { following_rad: self.following_rad.or(usual.following_rad), ..usual }
    }
}

choices_by_id! { Reaction, Failure, ScenarioId }

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
        position_gain: f64 => within(1e-3, 1e5), example("25");
        speed_gain: f64 => within(1e-6, 1e9), example("900");
        speed_time: Time => positive, example("5 ms");
        speed_filter: Time => not_negative, example("0.2 ms");
        current_gain: f64 => within(1e-6, 1e6), example("20");
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

impl MeasuredSection {
    /// Returns the stated values in SI, by key.
    fn stated(&self) -> Vec<(&'static str, Sourced<f64>)> {
        let value = |field: &dyn StatedField| Some((field.name(), sourced(field, field.si()?)));
        self.fields().into_iter().filter_map(value).collect()
    }
}

impl TwinSection {
    /// Returns the settings of the section.
    pub(crate) fn input(&self) -> TwinInput {
        let usual = Switches::default();
        let time = |stated: Option<Time>| stated.map(Measure::si);
        TwinInput {
            stated: true,
            scenario: Scenario {
                id: self.scenario.value().unwrap_or_default(),
                at_s: time(self.at.value()),
                reaction: self.reaction.value().unwrap_or_default(),
                failure: self.failure.value(),
                cycles: self.cycles.value().unwrap_or(1),
                cold: self.cold.value().unwrap_or(false),
            },
            switches: Switches {
                friction: self.friction.value().unwrap_or(usual.friction),
                hysteresis: self.hysteresis.value().unwrap_or(usual.hysteresis),
                kinematic_error: self.kinematic_error.value().unwrap_or(usual.kinematic_error),
                delay: self.delay.value().unwrap_or(usual.delay),
                limits: self.limits.value().unwrap_or(usual.limits),
                noise: self.noise.value().unwrap_or(usual.noise),
            },
            replaced: self.measured.get().map(MeasuredSection::stated).unwrap_or_default(),
            gains: [
                self.position_gain.value(),
                self.speed_gain.value(),
                time(self.speed_time.value()),
                time(self.speed_filter.value()),
                self.current_gain.value(),
                time(self.current_time.value()),
            ],
            following_rad: self.following_error_max.value().map(Measure::si),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::section::Section;

    /// Requires that every value of the section is a parameter of the model.
    #[test]
    fn every_measured_value_is_a_parameter_of_the_twin() {
        let keys = ::twin::Parameters::keys();
        for key in MeasuredSection::KEYS {
            assert!(keys.iter().any(|(known, _)| *known == key.name), "{}", key.name);
        }
    }
}
