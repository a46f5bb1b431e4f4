//! Interface of a quantity type: its dimension and its value in SI.

use crate::dimension::Dimension;
use crate::units::Unit;
use std::marker::PhantomData;

/// A typed quantity. `uom` types and the newtypes of this crate implement it.
pub trait Measure: Copy {
    /// Kind of the quantity.
    const DIMENSION: Dimension;

    /// Creates the quantity from its value in SI.
    fn from_si(si: f64) -> Self;

    /// Returns the value in SI.
    fn si(self) -> f64;

    /// Creates the quantity from a value in a unit of the same dimension.
    #[must_use]
    fn new_in(value: f64, unit: &Unit) -> Self {
        debug_assert!(unit.dimension == Self::DIMENSION, "{} is no unit of {:?}", unit.ascii, Self::DIMENSION);
        Self::from_si(unit.to_si(value))
    }

    /// Returns the value in a unit of the same dimension.
    #[must_use]
    fn in_unit(self, unit: &Unit) -> f64 {
        debug_assert!(unit.dimension == Self::DIMENSION, "{} is no unit of {:?}", unit.ascii, Self::DIMENSION);
        unit.from_si(self.si())
    }
}

macro_rules! measures {
    ($($quantity:ident => $dimension:ident),* $(,)?) => {$(
        impl Measure for crate::$quantity {
            const DIMENSION: Dimension = Dimension::$dimension;

            fn from_si(si: f64) -> Self {
                Self { dimension: PhantomData, units: PhantomData, value: si }
            }

            fn si(self) -> f64 {
                self.value
            }
        }
    )*};
}

measures! {
    Acceleration => Acceleration,
    Angle => Angle,
    AngularAcceleration => AngularAcceleration,
    AngularJerk => AngularJerk,
    AngularVelocity => AngularVelocity,
    Area => Area,
    ElectricCurrent => Current,
    ElectricPotential => Voltage,
    ElectricalResistance => Resistance,
    ElectricalResistivity => Resistivity,
    Energy => Energy,
    Force => Force,
    Frequency => Frequency,
    Inductance => Inductance,
    Jerk => Jerk,
    Length => Length,
    Mass => Mass,
    MassDensity => MassDensity,
    MomentOfInertia => MomentOfInertia,
    Power => Power,
    Pressure => Pressure,
    Ratio => Ratio,
    TemperatureInterval => TemperatureInterval,
    ThermodynamicTemperature => Temperature,
    Time => Time,
    Torque => Torque,
    Velocity => Velocity,
}

/// Quantities that `uom` does not distinguish: torque constant and voltage constant have the same dimension.
macro_rules! newtypes {
    ($($(#[$doc:meta])* $name:ident),* $(,)?) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
        pub struct $name(f64);

        impl Measure for $name {
            const DIMENSION: Dimension = Dimension::$name;

            fn from_si(si: f64) -> Self {
                Self(si)
            }

            fn si(self) -> f64 {
                self.0
            }
        }
    )*};
}

newtypes! {
    /// Travel per revolution \[m\].
    Lead,
    /// Effective voltage between two lines \[V\].
    EffectiveVoltage,
    /// Torque per current \[Nm/A\].
    TorqueConstant,
    /// Voltage per angular velocity [V/(rad/s)].
    VoltageConstant,
    /// No-load current per output speed [A/(rad/s)].
    NoLoadCurrentConstant,
    /// Torque per angle of twist [Nm/rad].
    TorsionalStiffness,
    /// Moment per angle of tilt [Nm/rad].
    TiltingStiffness,
    /// Friction torque per angular velocity [Nm/(rad/s)].
    ViscousFriction,
    /// Speed per deviation of the position [1/s].
    PositionGain,
    /// Torque per deviation of the speed [Nm/(rad/s)].
    SpeedGain,
    /// Voltage per deviation of the current [V/A].
    CurrentGain,
}
