//! `[twin]`: settings of the simulation of an axis, and measured values that replace those of the model.

use crate::about::About;
use crate::own::sourced;
use crate::section::section;
use crate::stated::{Stated, StatedField};
use crate::value::{KeyValue, choices_by_id};
use ::feedback::Failure;
use ::twin::{Gains, Limits, Parameters, Reaction, Scenario, ScenarioId, Switches};
use provenance::Datum;
use quantities::{
    Angle, CurrentGain, ElectricCurrent, ElectricalResistance, Energy, Inductance, Measure, MomentOfInertia,
    NoLoadCurrentConstant, PositionGain, SpeedGain, ThermodynamicTemperature, Time, Torque, TorqueConstant,
    TorsionalStiffness, ViscousFriction, VoltageConstant,
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
    gains: StatedGains,
    following_error_max: Option<Angle>,
    measured: Option<MeasuredSection>,
}

/// Gains that a project states.
#[derive(Clone, Copy, Debug, Default)]
struct StatedGains {
    position: Option<PositionGain>,
    speed: Option<SpeedGain>,
    speed_time: Option<Time>,
    speed_filter: Option<Time>,
    current: Option<CurrentGain>,
    current_time: Option<Time>,
}

impl TwinInput {
    /// Returns the gains with the stated ones in place of `usual`.
    #[must_use]
    pub fn gains(&self, usual: Gains) -> Gains {
        let stated = &self.gains;
        Gains {
            position_p: stated.position.map_or(usual.position_p, Measure::si),
            speed_p: stated.speed.map_or(usual.speed_p, Measure::si),
            speed_time_s: stated.speed_time.map_or(usual.speed_time_s, Measure::si),
            speed_filter_s: stated.speed_filter.map_or(usual.speed_filter_s, Measure::si),
            current_p: stated.current.map_or(usual.current_p, Measure::si),
            current_time_s: stated.current_time.map_or(usual.current_time_s, Measure::si),
            ..usual
        }
    }

    /// Returns the supervision limits with the stated ones in place of `usual`.
    #[must_use]
    pub fn limits(&self, usual: Limits) -> Limits {
        Limits { following_rad: self.following_error_max.map(Measure::si).or(usual.following_rad), ..usual }
    }

    /// Replaces parameters by the measured values that the project states.
    pub fn replace(&self, parameters: &mut Parameters) {
        if let Some(measured) = &self.measured {
            measured.replace(parameters);
        }
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

impl MeasuredSection {
    fn replace(&self, parameters: &mut Parameters) {
        let actuator = &mut parameters.actuator;
        datum(&self.resistance_ll, &mut actuator.resistance_ll);
        datum(&self.inductance_ll, &mut actuator.inductance_ll);
        datum(&self.torque_constant_motor, &mut actuator.torque_constant_motor);
        datum(&self.torque_constant_out, &mut actuator.torque_constant_out);
        // A measured constant is the slope of the torque, without the no-load current.
        actuator.stall_current_includes_friction |= self.torque_constant_out.is_given();
        datum(&self.voltage_constant_motor, &mut actuator.voltage_constant_motor);
        datum(&self.inertia_out, &mut actuator.inertia_out);
        datum(&self.no_load_starting_current, &mut actuator.no_load_starting_current);
        datum(&self.no_load_current_constant_cold, &mut actuator.no_load_current_constant_cold);
        datum(&self.no_load_current_constant_warm, &mut actuator.no_load_current_constant_warm);
        datum(&self.gear_torque_1, &mut actuator.gear.torque_1);
        datum(&self.gear_torque_2, &mut actuator.gear.torque_2);
        let [first, second, third] = &mut actuator.gear.stiffness;
        datum(&self.gear_stiffness_1, first);
        datum(&self.gear_stiffness_2, second);
        datum(&self.gear_stiffness_3, third);
        datum(&self.transmission_accuracy, &mut actuator.accuracy.transmission_accuracy);
        datum(&self.hysteresis_loss, &mut actuator.accuracy.hysteresis_loss);
        datum(&self.lost_motion, &mut actuator.accuracy.lost_motion);
        datum(&self.brake_torque, &mut actuator.brake.holding_torque);
        datum(&self.brake_opening_time, &mut actuator.brake.opening_time);
        datum(&self.brake_closing_time, &mut actuator.brake.closing_time);
        datum(&self.feedback_accuracy, &mut actuator.feedback.accuracy);
        datum(&self.winding_time_constant, &mut actuator.heat.winding_time_constant);
        datum(&self.housing_time_constant, &mut actuator.heat.housing_time_constant);
        datum(&self.ptc_response_temperature, &mut actuator.ptc_response);
        let model = &mut parameters.model;
        for (stated, place) in [
            (&self.flange_inertia_share as &dyn StatedField, &mut model.flange_inertia_share),
            (&self.gear_damping_ratio, &mut model.gear_damping_ratio),
            (&self.breakaway_ratio, &mut model.breakaway_ratio),
            (&self.kinematic_share_1, &mut model.kinematic_share_1),
            (&self.kinematic_share_2, &mut model.kinematic_share_2),
            (&self.kinematic_share_4, &mut model.kinematic_share_4),
            (&self.kinematic_share_out, &mut model.kinematic_share_out),
            (&self.sensor_lag, &mut model.sensor_lag),
            (&self.ptc_lag, &mut model.ptc_lag),
            (&self.link_energy, &mut model.link_energy),
            (&self.supply_resistance, &mut model.supply_resistance),
            (&self.brake_resistor, &mut model.brake_resistor),
            (&self.chopper_on, &mut model.chopper_on),
            (&self.chopper_off, &mut model.chopper_off),
            (&self.stop_stiffness, &mut model.stop_stiffness),
            (&self.current_noise, &mut model.current_noise),
        ] {
            if let Some(value) = stated.si() {
                *place = sourced(stated, value);
            }
        }
        let load = &mut parameters.load;
        for (stated, place) in [
            (&self.load_inertia as &dyn StatedField, &mut load.inertia),
            (&self.load_coulomb, &mut load.coulomb),
            (&self.load_viscous, &mut load.viscous),
            (&self.load_gravity, &mut load.gravity),
            (&self.load_gravity_angle, &mut load.gravity_angle),
            (&self.load_external, &mut load.external),
        ] {
            if let Some(value) = stated.si() {
                *place = Some(sourced(stated, value));
            }
        }
    }
}

/// Replaces a datum by the stated value, if there is one.
fn datum<Q: KeyValue + Copy>(stated: &Stated<Q>, place: &mut Datum<Q>) {
    if let Some(value) = stated.value() {
        *place = Datum::Known(sourced(stated, value));
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
            gains: StatedGains {
                position: self.position_gain.value(),
                speed: self.speed_gain.value(),
                speed_time: self.speed_time.value(),
                speed_filter: self.speed_filter.value(),
                current: self.current_gain.value(),
                current_time: self.current_time.value(),
            },
            following_error_max: self.following_error_max.value(),
            measured: self.measured.get().cloned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::section::Section;
    use crate::{Fault, Hint, NoCatalogue, Project};
    use quantities::{Dimension, unit};

    /// Every value of the section, stated alone, is the value of the parameter with its name, and of no other.
    #[test]
    fn every_measured_value_replaces_its_parameter_alone() {
        let usual = Parameters::of(&actuator::Parameters::unknown());
        for (key, dimension) in Parameters::keys() {
            if MeasuredSection::KEYS.iter().all(|known| known.name != key) {
                continue;
            }
            // Within the bounds of all ratios, and a value that no parameter has.
            let number = if key == "breakaway_ratio" || key.starts_with("chopper") { 1.2345 } else { 0.12345 };
            let written = match dimension {
                Dimension::Ratio => number.to_string(),
                Dimension::Temperature => format!("\"{} K\"", 273.15 + number),
                _ => format!("\"{number} {}\"", si_unit(dimension)),
            };
            let text = format!(
                "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n\
                 [twin.measured]\n{key} = {written}\n"
            );
            let project = Project::read(&text, &NoCatalogue::shared(), &|_, _| None);
            let project = project.unwrap_or_else(|faults| panic!("{key}: {faults:?}"));
            let mut found = usual.clone();
            project.twin.replace(&mut found);
            let changed: Vec<_> = found.list().into_iter().filter(|each| !usual.list().contains(each)).collect();
            assert_eq!(changed.len(), 1, "{key}: {changed:?}");
            let expected = if dimension == Dimension::Temperature { 273.15 + number } else { number };
            let value = changed[0].value.as_ref().unwrap();
            assert_eq!((changed[0].key, changed[0].dimension), (key, dimension));
            assert!((value.value - expected).abs() < 1e-9, "{key}: {}", value.value);
        }
        for key in MeasuredSection::KEYS {
            assert!(Parameters::keys().iter().any(|(known, _)| *known == key.name), "{}", key.name);
        }
    }

    #[test]
    fn a_gain_has_its_unit() {
        for (key, number, dimension, unit) in [
            ("position_gain", "25", Dimension::PositionGain, "1/s"),
            ("speed_gain", "900", Dimension::SpeedGain, "N m s/rad"),
            ("current_gain", "20.5", Dimension::CurrentGain, "V/A"),
        ] {
            let read = |value: &str| {
                let text = format!(
                    "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n\
                     [twin]\n{key} = {value}\n"
                );
                Project::read(&text, &NoCatalogue::shared(), &|_, _| None)
            };
            let faults = read(number).unwrap_err();
            let [fault] = faults.as_slice() else { panic!("{faults:?}") };
            assert_eq!(fault.fault, Fault::BareNumber { path: format!("twin.{key}"), dimension });
            assert_eq!(fault.hint, Some(Hint::WithUnit { written: number.to_owned(), dimension }));
            let usual = Gains {
                current_p: 1.0,
                current_time_s: 1.0,
                speed_p: 1.0,
                speed_time_s: 1.0,
                speed_filter_s: 1.0,
                position_p: 1.0,
                feed_speed: 1.0,
                feed_inertia: 1.0,
            };
            let found = read(&format!("\"{number} {unit}\"")).unwrap().twin.gains(usual);
            let number: f64 = number.parse().unwrap();
            let expected = match dimension {
                Dimension::PositionGain => Gains { position_p: number, ..usual },
                Dimension::SpeedGain => Gains { speed_p: number, ..usual },
                _ => Gains { current_p: number, ..usual },
            };
            assert_eq!(found, expected, "{key}");
        }
    }

    fn si_unit(dimension: Dimension) -> &'static str {
        let is_si = |unit: &&quantities::Unit| (unit.to_si(1.0) - 1.0).abs() < 1e-12 && **unit != unit::ONE;
        dimension.units().iter().find(is_si).unwrap().json
    }
}
