//! Constants of the equations, derived from the parameters.

use crate::gear::{Hysteresis, KinematicError, Spring};
use crate::parameters::{Parameters, si};
use crate::plant::Plant;
use crate::{Fault, Switches};
use actuator::{HeatModel, NoLoadFriction, coil_power, copper_resistance, speed_max};
use numeric::Random;
use provenance::{Datum, Missing};
use quantities::{ElectricalResistance, Measure, Ratio, ThermodynamicTemperature, Time};
use std::f64::consts::{SQRT_2, TAU};

/// An actuator as constants.
#[derive(Clone, Debug)]
pub(crate) struct Machine {
    /// Constants at 20 °C; temperature-dependent ones are set by [`Machine::warm`].
    pub(crate) plant: Plant,
    pub(crate) ratio: f64,
    resistance_ll_20: f64,
    friction: Option<NoLoadFriction>,
    /// Torque at the output per ampere rms of a friction current.
    friction_nm_a: f64,
    pub(crate) heat: Option<HeatModel>,
    /// I_max, I_0, I_E, rms \[A\].
    pub(crate) current_max_a: f64,
    pub(crate) stall_current_a: Option<f64>,
    pub(crate) demagnetisation_a: Option<f64>,
    /// Largest speed of the output [rad/s].
    pub(crate) speed_max: f64,
    pub(crate) brake: Option<BrakeData>,
    /// J of the flange \[kgm²\].
    pub(crate) flange_kgm2: f64,
    /// Largest deviation and step of the motor feedback, referred to the output \[rad\].
    pub(crate) feedback_rad: [f64; 2],
    /// Largest deviation and step of the encoder at the output \[rad\]; `None` without one.
    pub(crate) feedback_out_rad: Option<[f64; 2]>,
    /// Symbols of unknown data, whose part of the model is omitted.
    pub(crate) left_out: Vec<&'static str>,
}

/// Data of the holding brake.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BrakeData {
    pub(crate) torque_nm: f64,
    pub(crate) opening_s: f64,
    pub(crate) closing_s: f64,
    /// Heat of the coil while the brake is open \[W\].
    pub(crate) coil_w: f64,
}

impl Machine {
    /// Creates the constants of an actuator, with parts of the model switched off.
    pub(crate) fn of(parameters: &Parameters, switches: Switches, seed: u64) -> Result<Self, Fault> {
        let actuator = &parameters.actuator;
        let model = &parameters.model;
        let ratio = actuator.ratio.require("i")?.value;
        let pole_pairs = actuator.pole_pairs.require("p")?.value;
        let resistance_ll_20 = si(&actuator.resistance_ll, "R_LL")?;
        let constant_motor = si(&actuator.torque_constant_motor, "k_TM")?;
        let inertia_out = si(&actuator.inertia_out, "J_out")?;
        let torsion = actuator.gear.torsion().ok_or(Missing { symbol: "K_1" })?;
        let spring = Spring::of(&torsion);
        let mut left_out = Vec::new();
        let friction = if switches.friction { Some(NoLoadFriction::of(actuator)?) } else { None };
        let out_nm_a = loaded(parameters)?;
        // A k_TM rounded down would yield an efficiency above one: the motor then provides the torque of the output.
        let constant_motor = constant_motor.max(out_nm_a / ratio);
        let mesh = if switches.friction && out_nm_a > 0.0 { ratio * constant_motor / out_nm_a - 1.0 } else { 0.0 };
        let accuracy = &actuator.accuracy;
        let hysteresis = match (accuracy.hysteresis_loss.known(), accuracy.lost_motion.known()) {
            (Some(loss), Some(motion)) if switches.hysteresis && motion.value.si() > 0.0 => {
                Hysteresis::of(&spring, loss.value.si(), motion.value.si())
            }
            (Some(_), Some(_)) => Hysteresis::none(),
            _ => {
                left_out.push("hysteresis_loss");
                Hysteresis::none()
            }
        };
        let mut random = Random::new(seed);
        let phases = [(); 4].map(|()| TAU * random.uniform());
        let shares = [
            model.kinematic_share_1.value,
            model.kinematic_share_2.value,
            model.kinematic_share_4.value,
            model.kinematic_share_out.value,
        ];
        let kinematic = match accuracy.transmission_accuracy.known() {
            Some(known) if switches.kinematic_error => {
                KinematicError::spanning(known.value.si(), ratio, shares, phases)
            }
            Some(_) => None,
            None => {
                left_out.push("transmission_accuracy");
                None
            }
        };
        let flange_kgm2 = model.flange_inertia_share.value * inertia_out;
        let damping = 2.0 * model.gear_damping_ratio.value * (torsion.stiffness[1].si() * inertia_out).sqrt();
        let heat = HeatModel::of(actuator).ok();
        if heat.is_none() {
            left_out.push("housing_share");
        }
        let brake = &actuator.brake;
        let brake = brake.holding_torque.known().map(|torque| {
            let mut time = |datum: &Datum<Time>, symbol, standard: f64| match datum.known() {
                Some(known) => known.value.si(),
                None => {
                    left_out.push(symbol);
                    standard
                }
            };
            let coil = brake.voltage.known().zip(brake.holding_current.known());
            let open = Ratio::from_si(1.0);
            BrakeData {
                coil_w: coil.map_or(0.0, |(voltage, current)| coil_power(voltage.value, current.value, open).si()),
                torque_nm: torque.value.si(),
                opening_s: time(&brake.opening_time, "t_o", model.brake_opening_usual.value),
                closing_s: time(&brake.closing_time, "t_c", model.brake_closing_usual.value),
            }
        });
        let feedback = &actuator.feedback;
        let of_feedback = |angle: quantities::Angle| angle.si() / ratio;
        Ok(Self {
            plant: Plant {
                resistance_ohm: 0.5 * resistance_ll_20,
                inductance_h: 0.5 * si(&actuator.inductance_ll, "L_LL")?,
                flux_vs: si(&actuator.voltage_constant_motor, "k_EM")? * (2.0_f64 / 3.0).sqrt() / pole_pairs,
                electrical: pole_pairs * ratio,
                torque_constant: ratio * constant_motor / SQRT_2,
                inertia_kgm2: inertia_out - flange_kgm2,
                friction_nm: 0.0,
                breakaway: model.breakaway_ratio.value.max(1.0),
                viscous_nms: 0.0,
                mesh,
                brake_nm: 0.0,
                spring,
                hysteresis,
                damping_nms: damping,
                kinematic,
            },
            ratio,
            resistance_ll_20,
            friction,
            friction_nm_a: ratio * constant_motor,
            heat,
            current_max_a: si(&actuator.current_max, "I_max")?,
            stall_current_a: si(&actuator.stall_current, "I_0").ok(),
            demagnetisation_a: si(&actuator.current_demagnetisation, "I_E").ok(),
            speed_max: speed_max(actuator)?.value.si(),
            brake,
            flange_kgm2,
            feedback_rad: [
                feedback.accuracy.known().map_or(0.0, |known| of_feedback(known.value)),
                feedback.resolution.known().map_or(0.0, |known| of_feedback(known.value)),
            ],
            feedback_out_rad: actuator.feedback_out.resolution.known().map(|resolution| {
                let accuracy = actuator.feedback_out.accuracy.known().map_or(0.0, |known| known.value.si());
                [accuracy, resolution.value.si()]
            }),
            left_out,
        })
    }

    /// Returns R of a phase at a temperature of the winding \[Ω\].
    pub(crate) fn resistance_ohm(&self, winding_k: f64) -> f64 {
        let cold = ElectricalResistance::from_si(self.resistance_ll_20);
        0.5 * copper_resistance(cold, ThermodynamicTemperature::from_si(winding_k)).si()
    }

    /// Sets the constants that depend on the temperatures of winding and housing \[K\].
    pub(crate) fn warm(&self, plant: &mut Plant, winding_k: f64, housing_k: f64) {
        plant.resistance_ohm = self.resistance_ohm(winding_k);
        if let Some(friction) = &self.friction {
            let at = friction.at(ThermodynamicTemperature::from_si(housing_k));
            plant.friction_nm = self.friction_nm_a * at.starting.si();
            plant.viscous_nms = self.friction_nm_a * at.constant.si();
        }
    }
}

/// Returns η i k_TM, the torque at the output per ampere beyond the no-load friction \[Nm/A\].
///
/// k_Tout; for the 48 V windings, whose k_Tout is T_0/I_0 and includes that friction, T_0/(I_0 − I_NLS)
fn loaded(parameters: &Parameters) -> Result<f64, Missing> {
    let actuator = &parameters.actuator;
    if actuator.stall_current_includes_friction {
        return si(&actuator.torque_constant_out, "k_Tout");
    }
    let starting = si(&actuator.no_load_starting_current, "I_NLS")?;
    Ok(si(&actuator.stall_torque, "T_0")? / (si(&actuator.stall_current, "I_0")? - starting))
}
