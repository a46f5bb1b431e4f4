//! Physics of one instant: current, losses and power of the motor from the state of the output.
//!
//! Functions of plain numbers without memory: integration over a cycle and simulation over time use the same functions.
//! State that changes with time, the temperatures and the state of the overload supervision, is in
//! [`Network`](crate::Network) and [`overload_slope`](crate::overload_slope); the voltage is in
//! [`MotorVoltage`](crate::MotorVoltage).

use crate::copper::copper_resistance;
use crate::friction::FrictionAt;
use crate::gear::driven_share;
use crate::parameters::Drivetrain;
use crate::temperature::Losses;
use provenance::Missing;
use quantities::{ElectricalResistance, Measure, ThermodynamicTemperature};

/// State of the output of an actuator at one instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct OperatingPoint {
    /// T: torque of the actuator, including that of its own inertia \[Nm\].
    pub torque_nm: f64,
    /// ω: output speed [rad/s].
    pub speed_rad_s: f64,
    /// σ: direction of motion, +1 or −1; 0 at rest, where friction has no effect.
    pub direction: f64,
}

impl OperatingPoint {
    /// Returns `true` if the load drives the actuator: torque against the direction of motion.
    #[must_use]
    #[inline]
    pub fn is_driven(&self) -> bool {
        self.torque_nm * self.direction < 0.0
    }
}

/// Law of the motor current.
///
/// I = T/k_Tout + σ (I_s + K |n|)
///
/// # Symbols
/// T torque at the output \[Nm\], σ direction, I_s and K friction at the temperature of the gear, n output speed
/// # Source
/// docs/theory/current.md
/// # Valid
/// magnets at rated temperature, i_d = 0; rms with the sign of the torque
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorCurrent {
    /// k_Tout \[Nm/A\]
    torque_constant: f64,
}

impl MotorCurrent {
    /// Creates the law of an actuator's motor.
    ///
    /// # Errors
    /// [`Missing`] if k_Tout is unknown.
    pub fn of(actuator: &Drivetrain) -> Result<Self, Missing> {
        Ok(Self { torque_constant: actuator.torque_constant_out.require("k_Tout")?.value.si() })
    }

    /// Returns T/k_Tout, the current of a torque without friction \[A\].
    #[must_use]
    #[inline]
    pub fn of_torque(&self, torque_nm: f64) -> f64 {
        torque_nm / self.torque_constant
    }

    /// Returns the current at an instant \[A\].
    #[must_use]
    #[inline]
    pub fn at(&self, point: &OperatingPoint, friction: &FrictionAt) -> f64 {
        let running = friction.counted.si() + friction.constant.si() * point.speed_rad_s.abs();
        self.of_torque(point.torque_nm) + point.direction * running
    }

    /// Returns the weights with which α, the load torque, σ and ω add up to the current, for an own inertia \[kgm²\].
    #[must_use]
    #[inline]
    pub fn weights(&self, inertia_kgm2: f64, friction: &FrictionAt) -> [f64; 4] {
        let per_torque = 1.0 / self.torque_constant;
        [inertia_kgm2 * per_torque, per_torque, friction.counted.si(), friction.constant.si()]
    }
}

/// Law of the losses of motor and gear.
///
/// P_cu = 1.5 R I², P_f = (I_NLS + K |n|) k_TM ω_mot
///
/// # Symbols
/// R = R_LL at the temperature of the winding: 1.5 R_LL I² is the copper loss of a star winding; I rms
/// # Source
/// docs/theory/thermal.md
/// # Valid
/// losses of a slow motor: iron losses are included in the no-load current
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LossLaw {
    copper_ohm: f64,
    friction_vs: f64,
}

impl LossLaw {
    /// Creates the law of an actuator with its winding at a temperature.
    ///
    /// # Errors
    /// [`Missing`] with the first unknown datum.
    pub fn of(actuator: &Drivetrain, winding: ThermodynamicTemperature) -> Result<Self, Missing> {
        let copper_ohm = copper_ohm(actuator.resistance_ll.require("R_LL")?.value, winding);
        let ratio = actuator.ratio.require("i")?.value;
        Ok(Self { copper_ohm, friction_vs: actuator.torque_constant_motor.require("k_TM")?.value.si() * ratio })
    }

    /// Returns 1.5 R, the copper loss per square of the current \[Ω\].
    #[must_use]
    #[inline]
    pub const fn copper_ohm(&self) -> f64 {
        self.copper_ohm
    }

    /// Returns k_TM i, the friction loss per friction current and output speed [V/(rad/s)].
    #[must_use]
    #[inline]
    pub const fn friction_v_s_per_rad(&self) -> f64 {
        self.friction_vs
    }

    /// Returns both losses at an instant with its current \[A\].
    #[must_use]
    #[inline]
    pub fn at(&self, point: &OperatingPoint, current_a: f64, friction: &FrictionAt) -> Losses {
        let speed = point.speed_rad_s.abs();
        let running = point.direction.abs() * friction.starting.si() + friction.constant.si() * speed;
        Losses { copper_w: self.copper_ohm * current_a * current_a, friction_w: self.friction_vs * running * speed }
    }
}

/// Law of the electrical power at the motor terminals, positive from the drive, negative when regenerating.
///
/// P = 1.5 R I² + k_TM I ω_mot
///
/// Driven by the load, the gear transmits 2 − 1/η of its torque; driving, it needs 1/η: its loss is the same share of
/// the torque in both directions, η = k_Tout/(i k_TM), see [`driven_share`].
///
/// # Source
/// docs/theory/energy.md
/// # Valid
/// steady current, i_d = 0; without the energy stored in the inductance
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TerminalPower {
    copper_ohm: f64,
    constant_vs: f64,
    driven: f64,
}

impl TerminalPower {
    /// Creates the law of an actuator with its winding at a temperature.
    ///
    /// # Errors
    /// [`Missing`] with the first unknown datum.
    pub fn of(actuator: &Drivetrain, winding: ThermodynamicTemperature) -> Result<Self, Missing> {
        let resistance = actuator.resistance_ll.require("R_LL")?;
        let constant = actuator.torque_constant_motor.require("k_TM")?;
        let ratio = actuator.ratio.require("i")?;
        let out = actuator.torque_constant_out.require("k_Tout")?;
        Ok(Self {
            copper_ohm: copper_ohm(resistance.value, winding),
            constant_vs: constant.value.si() * ratio.value,
            driven: driven_share(out.value, constant.value, ratio.value),
        })
    }

    /// Returns 1.5 R \[Ω\].
    #[must_use]
    #[inline]
    pub const fn copper_ohm(&self) -> f64 {
        self.copper_ohm
    }

    /// Returns k_TM i, the induced voltage per output speed [V/(rad/s)].
    #[must_use]
    #[inline]
    pub const fn constant_v_s_per_rad(&self) -> f64 {
        self.constant_vs
    }

    /// Returns the current per torque relative to that while driving \[1\]: one while the actuator drives, η (2 − 1/η)
    /// while the load does.
    #[must_use]
    #[inline]
    pub const fn passed(&self, driven: bool) -> f64 {
        if driven { self.driven } else { 1.0 }
    }

    /// Returns the power at a speed with a current that includes the gear loss of its direction, see
    /// [`TerminalPower::current`] \[W\].
    #[must_use]
    #[inline]
    pub fn with(&self, current_a: f64, speed_rad_s: f64) -> f64 {
        (self.copper_ohm * current_a + self.constant_vs * speed_rad_s) * current_a
    }

    /// Returns the current of an instant including the gear loss of its direction \[A\].
    #[must_use]
    #[inline]
    pub fn current(&self, motor: &MotorCurrent, point: &OperatingPoint, friction: &FrictionAt) -> f64 {
        motor.at(&OperatingPoint { torque_nm: self.passed(point.is_driven()) * point.torque_nm, ..*point }, friction)
    }

    /// Returns the power at an instant \[W\].
    #[must_use]
    #[inline]
    pub fn at(&self, motor: &MotorCurrent, point: &OperatingPoint, friction: &FrictionAt) -> f64 {
        self.with(self.current(motor, point, friction), point.speed_rad_s)
    }
}

/// Returns 1.5 R_LL at a winding temperature, the copper loss of a star winding per square of the current \[Ω\].
fn copper_ohm(resistance_20: ElectricalResistance, winding: ThermodynamicTemperature) -> f64 {
    1.5 * copper_resistance(resistance_20, winding).si()
}

#[cfg(test)]
#[path = "instant_tests.rs"]
mod tests;
