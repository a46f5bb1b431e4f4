//! `[twin]`: settings of the simulation of an axis, and measured values that replace those of the model.

use crate::choices;
use crate::sourced::sourced;
use project::sections::{KeyValue, MeasuredSection, Stated, StatedField, TwinSection};
use provenance::{Datum, Sourced};
use quantities::{Angle, CurrentGain, Measure, PositionGain, SpeedGain, Time};
use twin::{Gains, Limits, Parameters, Scenario, Switches};

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
            replace(measured, parameters);
        }
    }
}

fn replace(measured: &MeasuredSection, parameters: &mut Parameters) {
    let actuator = &mut parameters.actuator;
    datum(&measured.resistance_ll, &mut actuator.resistance_ll);
    datum(&measured.inductance_ll, &mut actuator.inductance_ll);
    datum(&measured.torque_constant_motor, &mut actuator.torque_constant_motor);
    datum(&measured.torque_constant_out, &mut actuator.torque_constant_out);
    // A measured constant is the slope of the torque, without the no-load current.
    actuator.stall_current_includes_friction |= measured.torque_constant_out.is_given();
    datum(&measured.voltage_constant_motor, &mut actuator.voltage_constant_motor);
    datum(&measured.inertia_out, &mut actuator.inertia_out);
    datum(&measured.no_load_starting_current, &mut actuator.no_load_starting_current);
    datum(&measured.no_load_current_constant_cold, &mut actuator.no_load_current_constant_cold);
    datum(&measured.no_load_current_constant_warm, &mut actuator.no_load_current_constant_warm);
    datum(&measured.gear_torque_1, &mut actuator.gear.torque_1);
    datum(&measured.gear_torque_2, &mut actuator.gear.torque_2);
    let [first, second, third] = &mut actuator.gear.stiffness;
    datum(&measured.gear_stiffness_1, first);
    datum(&measured.gear_stiffness_2, second);
    datum(&measured.gear_stiffness_3, third);
    datum(&measured.transmission_accuracy, &mut actuator.accuracy.transmission_accuracy);
    datum(&measured.hysteresis_loss, &mut actuator.accuracy.hysteresis_loss);
    datum(&measured.lost_motion, &mut actuator.accuracy.lost_motion);
    datum(&measured.brake_torque, &mut actuator.brake.holding_torque);
    datum(&measured.brake_opening_time, &mut actuator.brake.opening_time);
    datum(&measured.brake_closing_time, &mut actuator.brake.closing_time);
    datum(&measured.feedback_accuracy, &mut actuator.feedback.accuracy);
    datum(&measured.winding_time_constant, &mut actuator.heat.winding_time_constant);
    datum(&measured.housing_time_constant, &mut actuator.heat.housing_time_constant);
    datum(&measured.ptc_response_temperature, &mut actuator.ptc_response);
    let model = &mut parameters.model;
    numbers([
        (&measured.flange_inertia_share as &dyn StatedField, &mut model.flange_inertia_share),
        (&measured.gear_damping_ratio, &mut model.gear_damping_ratio),
        (&measured.breakaway_ratio, &mut model.breakaway_ratio),
        (&measured.kinematic_share_1, &mut model.kinematic_share_1),
        (&measured.kinematic_share_2, &mut model.kinematic_share_2),
        (&measured.kinematic_share_4, &mut model.kinematic_share_4),
        (&measured.kinematic_share_out, &mut model.kinematic_share_out),
        (&measured.sensor_lag, &mut model.sensor_lag),
        (&measured.ptc_lag, &mut model.ptc_lag),
        (&measured.link_energy, &mut model.link_energy),
        (&measured.supply_resistance, &mut model.supply_resistance),
        (&measured.brake_resistor, &mut model.brake_resistor),
        (&measured.chopper_on, &mut model.chopper_on),
        (&measured.chopper_off, &mut model.chopper_off),
        (&measured.stop_stiffness, &mut model.stop_stiffness),
        (&measured.current_noise, &mut model.current_noise),
    ]);
    let load = &mut parameters.load;
    numbers([
        (&measured.load_inertia as &dyn StatedField, &mut load.inertia),
        (&measured.load_coulomb, &mut load.coulomb),
        (&measured.load_viscous, &mut load.viscous),
        (&measured.load_gravity, &mut load.gravity),
        (&measured.load_gravity_angle, &mut load.gravity_angle),
        (&measured.load_external, &mut load.external),
    ]);
}

/// Replaces each number by the stated value, if there is one.
fn numbers<P: From<Sourced<f64>>, const N: usize>(pairs: [(&dyn StatedField, &mut P); N]) {
    for (stated, place) in pairs {
        if let Some(value) = stated.si() {
            *place = sourced(stated, value).into();
        }
    }
}

/// Replaces a datum by the stated value, if there is one.
fn datum<Q: KeyValue + Copy>(stated: &Stated<Q>, place: &mut Datum<Q>) {
    if let Some(value) = stated.value() {
        *place = Datum::Known(sourced(stated, value));
    }
}

/// Returns the settings of the section.
pub(crate) fn input(section: &TwinSection) -> TwinInput {
    let usual = Switches::default();
    let time = |stated: Option<Time>| stated.map(Measure::si);
    TwinInput {
        stated: true,
        scenario: Scenario {
            id: section.scenario.value().map(choices::scenario).unwrap_or_default(),
            at_s: time(section.at.value()),
            reaction: section.reaction.value().map(choices::reaction).unwrap_or_default(),
            failure: section.failure.value().map(choices::failure),
            cycles: section.cycles.value().unwrap_or(1),
            cold: section.cold.value().unwrap_or(false),
        },
        switches: Switches {
            friction: section.friction.value().unwrap_or(usual.friction),
            hysteresis: section.hysteresis.value().unwrap_or(usual.hysteresis),
            kinematic_error: section.kinematic_error.value().unwrap_or(usual.kinematic_error),
            delay: section.delay.value().unwrap_or(usual.delay),
            limits: section.limits.value().unwrap_or(usual.limits),
            noise: section.noise.value().unwrap_or(usual.noise),
        },
        gains: StatedGains {
            position: section.position_gain.value(),
            speed: section.speed_gain.value(),
            speed_time: section.speed_time.value(),
            speed_filter: section.speed_filter.value(),
            current: section.current_gain.value(),
            current_time: section.current_time.value(),
        },
        following_error_max: section.following_error_max.value(),
        measured: section.measured.get().cloned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{AxisProject, NoCatalogue};
    use project::sections::Section;
    use project::{Fault, Hint};
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
            let project = AxisProject::read(&text, &NoCatalogue::shared(), &|_, _| None);
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
                AxisProject::read(&text, &NoCatalogue::shared(), &|_, _| None)
            };
            let faults = read(number).unwrap_err();
            let [fault] = faults.as_slice() else { panic!("{faults:?}") };
            assert_eq!(fault.fault, Fault::BareNumber { path: format!("twin.{key}"), dimension }.into());
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
