//! Motor, gear and load: constants and state of their equations of motion, and the energy balance.

use crate::gear::{Anchor, ELEMENTS, Hysteresis, KinematicError, Spring};
use crate::load::Local;

/// Constants of the equations; temperature-dependent ones are updated every millisecond.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plant {
    /// R of a phase at the temperature of the winding \[Ω\].
    pub(crate) resistance_ohm: f64,
    /// L of a phase \[H\].
    pub(crate) inductance_h: f64,
    /// ψ: flux linkage, peak of a phase \[Vs\].
    pub(crate) flux_vs: f64,
    /// p i: electrical angle per angle of the output \[1\].
    pub(crate) electrical: f64,
    /// k_TM i/√2: torque at the output per i_q [Nm/A].
    pub(crate) torque_constant: f64,
    /// J_M: inertia of the parts turning with the wave generator, at the output \[kgm²\].
    pub(crate) inertia_kgm2: f64,
    /// Speed-independent friction of motor and gear \[Nm\], its breakaway value as a multiple \[1\], and the viscous
    /// part [Nm s/rad].
    pub(crate) friction_nm: f64,
    pub(crate) breakaway: f64,
    pub(crate) viscous_nms: f64,
    /// Friction of the teeth per torque, 1/η − 1 \[1\].
    pub(crate) mesh: f64,
    /// Torque of the closed brake \[Nm\]; zero when open.
    pub(crate) brake_nm: f64,
    pub(crate) spring: Spring,
    pub(crate) hysteresis: Hysteresis,
    /// D: damping of the twist [Nm s/rad].
    pub(crate) damping_nms: f64,
    pub(crate) kinematic: Option<KinematicError>,
}

/// Energy balance since the start of the run \[J\], by sink.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energies {
    /// Energy from the inverter to the motor.
    pub terminal_j: f64,
    /// Heat in the winding.
    pub copper_j: f64,
    /// No-load friction of motor and gear.
    pub friction_j: f64,
    /// Friction of the teeth under torque.
    pub mesh_j: f64,
    /// Heat in the brake.
    pub brake_j: f64,
    /// Damping of the gear.
    pub damping_j: f64,
    /// Hysteresis of the gear.
    pub hysteresis_j: f64,
    /// Energy transferred to the load at the flange.
    pub flange_j: f64,
    /// Difference between k_TM and k_EM of the tables: work that appears in the voltage but not in the torque.
    pub constants_j: f64,
    /// Regenerated part of the terminal energy, as a positive number.
    pub regenerated_j: f64,
}

/// A quantity for each variable of the equations of motion: the value of the state, or the terms of its series.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Variables<T = f64> {
    /// i_d \[A\].
    pub(crate) current_d: T,
    /// i_q \[A\].
    pub(crate) current_q: T,
    /// θ: angle of the motor over i \[rad\].
    pub(crate) motor_rad: T,
    /// Ω: speed of the motor over i [rad/s].
    pub(crate) motor_rad_s: T,
    /// q: angle of the load \[rad\].
    pub(crate) load_rad: T,
    /// ω: speed of the load [rad/s].
    pub(crate) load_rad_s: T,
}

impl Variables {
    /// Returns the values increased by an amount computed from the terms of each variable.
    #[inline(always)]
    pub(crate) fn increased<T>(&self, terms: &Variables<T>, amount: impl Fn(&T) -> f64) -> Self {
        Self {
            current_d: self.current_d + amount(&terms.current_d),
            current_q: self.current_q + amount(&terms.current_q),
            motor_rad: self.motor_rad + amount(&terms.motor_rad),
            motor_rad_s: self.motor_rad_s + amount(&terms.motor_rad_s),
            load_rad: self.load_rad + amount(&terms.load_rad),
            load_rad_s: self.load_rad_s + amount(&terms.load_rad_s),
        }
    }

    /// Returns `true` if every value is finite.
    pub(crate) fn are_finite(&self) -> bool {
        let Self { current_d, current_q, motor_rad, motor_rad_s, load_rad, load_rad_s } = self;
        [current_d, current_q, motor_rad, motor_rad_s, load_rad, load_rad_s].into_iter().all(|value| value.is_finite())
    }
}

/// Directions in which the dry contacts slide; 0 while sticking.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sliding {
    /// Bearings, seals and brake of the motor.
    pub(crate) motor: f64,
    /// Guides of the load.
    pub(crate) load: f64,
}

/// State of the plant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct State {
    pub(crate) x: Variables,
    /// Forces of the hysteresis elements \[Nm\].
    pub(crate) force: [f64; ELEMENTS],
    pub(crate) sliding: Sliding,
    pub(crate) energies: Energies,
    /// Angle by which the closed brake has slipped \[rad\].
    pub(crate) slipped_rad: f64,
    /// Last directions of the twist and of the torque through the gear.
    pub(crate) turning: f64,
    pub(crate) pull: f64,
    /// Torque through the gear \[Nm\], its twist \[rad\] and the acceleration of the load [rad/s²].
    pub(crate) gear_nm: f64,
    pub(crate) twist_rad: f64,
    pub(crate) acceleration_rad_s2: f64,
    /// The inverter is switching; without pulses no current flows.
    pub(crate) pulses: bool,
}

/// An elastic stop hit by the load.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stop {
    pub(crate) at_rad: f64,
    /// 0 for a clamp in both directions, +1 or −1 for a stop against motion in that direction only.
    pub(crate) side: f64,
    pub(crate) stiffness_nm: f64,
    pub(crate) damping_nms: f64,
}

impl Stop {
    /// Returns the torque on the stop in contact \[Nm\].
    #[inline]
    pub(crate) fn torque(&self, position: f64, speed: f64) -> f64 {
        self.stiffness_nm * (position - self.at_rad) + self.damping_nms * speed
    }

    /// Returns the contact torque \[Nm\]; negative without contact. A clamp in both directions always holds.
    pub(crate) fn pressed(&self, position: f64, speed: f64) -> f64 {
        if self.side == 0.0 {
            return f64::INFINITY;
        }
        (self.torque(position, speed) * self.side).min(self.stiffness_nm * (position - self.at_rad) * self.side)
    }
}

/// Constants within a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Given<'a> {
    /// u_d, u_q \[V\].
    pub(crate) voltage: [f64; 2],
    pub(crate) load: &'a Local,
    pub(crate) stop: Option<&'a Stop>,
    pub(crate) anchor: &'a Anchor,
}

impl Plant {
    /// Sets the twist of a state from its angles.
    pub(crate) fn place(&self, state: &mut State) {
        let error = self.kinematic.map_or(0.0, |error| error.at(state.x.motor_rad));
        state.twist_rad = state.x.motor_rad - state.x.load_rad - error;
    }

    /// Blocks the inverter: the energy of the windings returns through its diodes at once.
    pub(crate) fn block(&self, state: &mut State) {
        let stored = self.magnetic(state);
        state.energies.terminal_j -= stored;
        state.energies.regenerated_j += stored;
        state.x.current_d = 0.0;
        state.x.current_q = 0.0;
        state.pulses = false;
    }

    fn magnetic(&self, state: &State) -> f64 {
        let Variables { current_d, current_q, .. } = state.x;
        0.75 * self.inductance_h * (current_d * current_d + current_q * current_q)
    }

    /// Returns the energy stored in windings, rotor and gear \[J\].
    pub(crate) fn stored(&self, state: &State) -> f64 {
        let omega = state.x.motor_rad_s;
        self.magnetic(state)
            + 0.5 * self.inertia_kgm2 * omega * omega
            + self.spring.energy(state.twist_rad)
            + self.hysteresis.energy(&state.force)
    }

    /// Returns the largest product of a step and an eigenvalue of the equations, which must stay below about one.
    pub(crate) fn stiffness(&self, load_kgm2: f64, stop_nm: f64, speed_max: f64, h: f64) -> f64 {
        let spring = self.spring.stiffest() + self.hysteresis.stiffness.iter().sum::<f64>();
        let swing = (spring / self.inertia_kgm2 + (spring + stop_nm) / load_kgm2).sqrt();
        let electric = self.resistance_ohm / self.inductance_h;
        h * swing.max(electric).max(self.electrical * speed_max)
    }
}

impl Energies {
    /// Returns the error of the balance: terminal energy that is neither lost, nor transferred to the load, nor stored
    /// \[J\].
    pub(crate) fn unaccounted(&self, stored_j: f64) -> f64 {
        self.terminal_j
            - self.copper_j
            - self.friction_j
            - self.mesh_j
            - self.brake_j
            - self.damping_j
            - self.hysteresis_j
            - self.flange_j
            - self.constants_j
            - stored_j
    }

    /// Returns the energy through the motor, in both directions \[J\].
    pub(crate) fn throughput(&self) -> f64 {
        self.terminal_j + 2.0 * self.regenerated_j
    }

    /// Returns the heat in the housing, all losses except that of the copper \[J\].
    pub(crate) fn heat(&self) -> f64 {
        self.friction_j + self.mesh_j + self.brake_j + self.damping_j + self.hysteresis_j
    }
}
