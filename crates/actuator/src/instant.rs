//! The physics of one instant: current, losses and power of the motor from the state of the output.
//!
//! Plain numbers in, plain numbers out, without memory: integration over a cycle and stepping through time use the
//! same functions. State that changes with time, temperatures and the state of the overload supervision, is in
//! [`Network`](crate::Network) and [`overload_slope`](crate::overload_slope); the voltage is [`MotorVoltage`](crate::MotorVoltage).

use crate::friction::FrictionAt;
use crate::motor::{copper_resistance, driven_share};
use crate::parameters::Drivetrain;
use crate::temperature::Losses;
use provenance::Missing;
use quantities::{ElectricalResistance, Measure, ThermodynamicTemperature};

/// The output of an actuator at one instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct OperatingPoint {
    /// T: torque of the actuator, its own inertia's included \[Nm\].
    pub torque_nm: f64,
    /// ω [rad/s]
    pub speed_rad_s: f64,
    /// σ: direction of the motion, +1 or −1; 0 at rest, where friction neither helps nor hinders.
    pub direction: f64,
}

impl OperatingPoint {
    /// Whether the load drives the actuator: torque against the direction of the motion.
    #[must_use]
    #[inline]
    pub fn is_driven(&self) -> bool {
        self.torque_nm * self.direction < 0.0
    }
}

/// The motor current of a torque.
///
/// I = T/k_Tout + σ (I_s + K |n|)
///
/// # Symbols
/// T torque at the output \[Nm\], σ direction, I_s and K friction at the temperature of the gear, n output speed
/// # Source
/// docs/theory/current.md
/// # Valid
/// magnets of rated temperature, i_d = 0; signed like the torque, rms
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorCurrent {
    /// k_Tout \[Nm/A\]
    torque_constant: f64,
}

impl MotorCurrent {
    /// The current of an actuator's motor.
    ///
    /// # Errors
    /// [`Missing`] if k_Tout is not known.
    pub fn of(actuator: &Drivetrain) -> Result<Self, Missing> {
        Ok(Self { torque_constant: actuator.torque_constant_out.require("k_Tout")?.value.si() })
    }

    /// T/k_Tout: the current of a torque without friction \[A\].
    #[must_use]
    #[inline]
    pub fn of_torque(&self, torque_nm: f64) -> f64 {
        torque_nm / self.torque_constant
    }

    /// The current at an instant \[A\].
    #[must_use]
    #[inline]
    pub fn at(&self, point: &OperatingPoint, friction: &FrictionAt) -> f64 {
        let running = friction.counted.si() + friction.constant.si() * point.speed_rad_s.abs();
        self.of_torque(point.torque_nm) + point.direction * running
    }

    /// The same as a weighted sum of α, the torque of the load, σ and ω, for an own inertia \[kgm²\].
    #[must_use]
    #[inline]
    pub fn weights(&self, inertia_kgm2: f64, friction: &FrictionAt) -> [f64; 4] {
        let per_torque = 1.0 / self.torque_constant;
        [inertia_kgm2 * per_torque, per_torque, friction.counted.si(), friction.constant.si()]
    }
}

/// Where the power of the motor becomes heat.
///
/// P_cu = 1.5 R I², P_f = (I_NLS + K |n|) k_TM ω_mot
///
/// # Symbols
/// R = R_LL at the temperature of the winding: 1.5 R_LL I² is the copper loss of a star winding; I rms
/// # Source
/// docs/theory/thermal.md
/// # Valid
/// losses of a slow motor: iron losses are part of the no-load current
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LossLaw {
    copper_ohm: f64,
    friction_vs: f64,
}

impl LossLaw {
    /// The losses of an actuator, its winding at a temperature.
    ///
    /// # Errors
    /// [`Missing`] with the first datum that is not known.
    pub fn of(actuator: &Drivetrain, winding: ThermodynamicTemperature) -> Result<Self, Missing> {
        let copper_ohm = copper_ohm(actuator.resistance_ll.require("R_LL")?.value, winding);
        let ratio = actuator.ratio.require("i")?.value;
        Ok(Self { copper_ohm, friction_vs: actuator.torque_constant_motor.require("k_TM")?.value.si() * ratio })
    }

    /// 1.5 R: copper loss per square of the current \[Ω\].
    #[must_use]
    #[inline]
    pub const fn copper_ohm(&self) -> f64 {
        self.copper_ohm
    }

    /// k_TM i: friction loss per friction current and output speed [V/(rad/s)].
    #[must_use]
    #[inline]
    pub const fn friction_v_s_per_rad(&self) -> f64 {
        self.friction_vs
    }

    /// Both losses at an instant with its current \[A\].
    #[must_use]
    #[inline]
    pub fn at(&self, point: &OperatingPoint, current_a: f64, friction: &FrictionAt) -> Losses {
        let speed = point.speed_rad_s.abs();
        let running = point.direction.abs() * friction.starting.si() + friction.constant.si() * speed;
        Losses { copper_w: self.copper_ohm * current_a * current_a, friction_w: self.friction_vs * running * speed }
    }
}

/// Electrical power at the terminals of the motor: what the drive gives to it, negative where it comes back.
///
/// P = 1.5 R I² + k_TM I ω_mot
///
/// Driven by the load the gear passes on 2 − 1/η of its torque, driving it takes 1/η: its loss is the same share of the
/// torque either way, η = k_Tout/(i k_TM), see [`driven_share`].
///
/// # Source
/// docs/theory/energy.md
/// # Valid
/// steady current, i_d = 0; what the inductance stores is not looked at
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TerminalPower {
    copper_ohm: f64,
    constant_vs: f64,
    driven: f64,
}

impl TerminalPower {
    /// The power of an actuator, its winding at a temperature.
    ///
    /// # Errors
    /// [`Missing`] with the first datum that is not known.
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

    /// 1.5 R \[Ω\].
    #[must_use]
    #[inline]
    pub const fn copper_ohm(&self) -> f64 {
        self.copper_ohm
    }

    /// k_TM i: induced voltage per output speed [V/(rad/s)].
    #[must_use]
    #[inline]
    pub const fn constant_v_s_per_rad(&self) -> f64 {
        self.constant_vs
    }

    /// Current per torque, over that while driving: one while the actuator drives, η (2 − 1/η) while the load does.
    #[must_use]
    #[inline]
    pub const fn passed(&self, driven: bool) -> f64 {
        if driven { self.driven } else { 1.0 }
    }

    /// At a speed with a current that has the gear's loss of its direction in it, see [`TerminalPower::current`] \[W\].
    #[must_use]
    #[inline]
    pub fn with(&self, current_a: f64, speed_rad_s: f64) -> f64 {
        (self.copper_ohm * current_a + self.constant_vs * speed_rad_s) * current_a
    }

    /// The current of an instant with the gear's loss of its direction \[A\].
    #[must_use]
    #[inline]
    pub fn current(&self, motor: &MotorCurrent, point: &OperatingPoint, friction: &FrictionAt) -> f64 {
        motor.at(&OperatingPoint { torque_nm: self.passed(point.is_driven()) * point.torque_nm, ..*point }, friction)
    }

    /// At an instant \[W\].
    #[must_use]
    #[inline]
    pub fn at(&self, motor: &MotorCurrent, point: &OperatingPoint, friction: &FrictionAt) -> f64 {
        self.with(self.current(motor, point, friction), point.speed_rad_s)
    }
}

/// 1.5 R_LL at a temperature of the winding: copper loss of a star winding per square of the current \[Ω\].
fn copper_ohm(resistance_20: ElectricalResistance, winding: ThermodynamicTemperature) -> f64 {
    1.5 * copper_resistance(resistance_20, winding).si()
}

#[cfg(test)]
#[path = "instant_tests.rs"]
mod tests;
