//! Parameters of the model: those of the actuator, and those that the manufacturer's tables lack, each with grade and
//! source.

use crate::setup::{SUPPLY_USUAL_V, Supply};
use actuator::Parameters as Actuator;
use provenance::{Datum, Grade, Missing, Source, Sourced};
use quantities::{
    Angle, Dimension, ElectricCurrent, ElectricPotential, ElectricalResistance, Inductance, Measure, MomentOfInertia,
    NoLoadCurrentConstant, ThermodynamicTemperature, Time, Torque, TorqueConstant, TorsionalStiffness, VoltageConstant,
};

/// A parameter of the exported file.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Key of the parameter.
    pub key: &'static str,
    /// Dimension of the value.
    pub dimension: Dimension,
    /// Value in SI with grade and source; `None` if unknown.
    pub value: Option<Sourced<f64>>,
}

impl Parameter {
    /// Returns `true` if the value may be negative.
    pub(crate) fn has_a_sign(&self) -> bool {
        matches!(self.key, "load_external" | "load_gravity_angle")
    }
}

/// Parameters of the simulation of an actuator.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters {
    /// Data of the actuator, some of them replaced.
    pub actuator: Actuator,
    /// Parameters beyond the tables.
    pub model: Model,
    /// Measured values of the load, which replace those of the mechanism.
    pub load: MeasuredLoad,
}

/// A key of the actuator's data with its read access.
struct Of {
    key: &'static str,
    dimension: Dimension,
    get: fn(&Actuator) -> Option<Sourced<f64>>,
}

/// Defines the data of the actuator, one per line: key, field and quantity.
macro_rules! data {
    ($($key:literal $($place:ident).+ : $quantity:ty;)*) => {
        const DATA: &[Of] = &[$(Of {
            key: $key,
            dimension: <$quantity as Scalar>::DIMENSION,
            get: |actuator| Some(actuator.$($place).+.known()?.clone().map(<$quantity as Scalar>::value)),
        }),*];
    };
}

/// A quantity or a pure number.
trait Scalar {
    const DIMENSION: Dimension;
    fn value(self) -> f64;
}

macro_rules! scalars {
    ($($quantity:ty),*) => {$(
        impl Scalar for $quantity {
            const DIMENSION: Dimension = <$quantity as Measure>::DIMENSION;
            fn value(self) -> f64 {
                self.si()
            }
        }
    )*};
}

scalars!(
    Angle,
    ElectricCurrent,
    ElectricPotential,
    ElectricalResistance,
    Inductance,
    MomentOfInertia,
    NoLoadCurrentConstant,
    ThermodynamicTemperature,
    Time,
    Torque,
    TorqueConstant,
    TorsionalStiffness,
    VoltageConstant
);

impl Scalar for f64 {
    const DIMENSION: Dimension = Dimension::Ratio;
    fn value(self) -> f64 {
        self
    }
}

data! {
    "ratio" ratio: f64;
    "pole_pairs" pole_pairs: f64;
    "resistance_ll" resistance_ll: ElectricalResistance;
    "inductance_ll" inductance_ll: Inductance;
    "torque_constant_motor" torque_constant_motor: TorqueConstant;
    "torque_constant_out" torque_constant_out: TorqueConstant;
    "voltage_constant_motor" voltage_constant_motor: VoltageConstant;
    "inertia_out" inertia_out: MomentOfInertia;
    "no_load_starting_current" no_load_starting_current: ElectricCurrent;
    "no_load_current_constant_cold" no_load_current_constant_cold: NoLoadCurrentConstant;
    "no_load_current_constant_warm" no_load_current_constant_warm: NoLoadCurrentConstant;
    "torque_max" torque_max: Torque;
    "current_max" current_max: ElectricCurrent;
    "current_demagnetisation" current_demagnetisation: ElectricCurrent;
    "stall_torque" stall_torque: Torque;
    "stall_current" stall_current: ElectricCurrent;
    "dc_link_max" dc_link_max: ElectricPotential;
    "gear_torque_1" gear.torque_1: Torque;
    "gear_torque_2" gear.torque_2: Torque;
    "collision_torque_max" gear.collision_torque_max: Torque;
    "transmission_accuracy" accuracy.transmission_accuracy: Angle;
    "hysteresis_loss" accuracy.hysteresis_loss: Angle;
    "lost_motion" accuracy.lost_motion: Angle;
    "brake_torque" brake.holding_torque: Torque;
    "brake_opening_time" brake.opening_time: Time;
    "brake_closing_time" brake.closing_time: Time;
    "feedback_accuracy" feedback.accuracy: Angle;
    "feedback_resolution" feedback.resolution: Angle;
    "winding_time_constant" heat.winding_time_constant: Time;
    "housing_time_constant" heat.housing_time_constant: Time;
    "housing_share" heat.housing_share: f64;
    "winding_warning" heat.winding_warning: ThermodynamicTemperature;
    "winding_shutdown" heat.winding_shutdown: ThermodynamicTemperature;
    "ptc_response_temperature" ptc_response: ThermodynamicTemperature;
}

/// Keys of the three stiffnesses, which are an array and therefore not in `data!`.
const STIFFNESS: [&str; 3] = ["gear_stiffness_1", "gear_stiffness_2", "gear_stiffness_3"];

/// Defines the parameters of the model, one per line: name, quantity, default value and grade.
macro_rules! model {
    ($($(#[$about:meta])* $name:ident: $dimension:ident = $standard:expr, $grade:ident;)*) => {
        /// Parameters that the manufacturer's tables lack, in SI. A value without evidence is `assumed`.
        #[derive(Clone, Debug, PartialEq)]
        pub struct Model {
            $($(#[$about])* pub $name: Sourced<f64>,)*
        }

        impl Default for Model {
            fn default() -> Self {
                let standard = |value, grade| Sourced { value, source: Source::Model { name: "twin" }, grade, errata: &[] };
                Self { $($name: standard($standard, Grade::$grade),)* }
            }
        }

        impl Model {
            fn list(&self) -> Vec<Parameter> {
                vec![$(Parameter {
                    key: stringify!($name),
                    dimension: Dimension::$dimension,
                    value: Some(self.$name.clone()),
                }),*]
            }
        }
    };
}

model! {
    /// Share of J_out that turns with the output flange instead of the wave generator \[1\]. A guess.
    flange_inertia_share: Ratio = 0.02, Assumed;
    /// ζ: damping of the gear for J_out on K_2, D = 2 ζ √(K_2 J_out) \[1\]. A guess.
    gear_damping_ratio: Ratio = 0.03, Assumed;
    /// Breakaway torque over the running torque at zero speed \[1\]: I_NLS is defined as the current that starts the
    /// motor.
    breakaway_ratio: Ratio = 1.0, Assumed;
    /// Relative amplitude of the kinematic error with one period per turn of the wave generator; the four amplitudes are
    /// scaled together to the transmission accuracy. A guess.
    kinematic_share_1: Ratio = 0.15, Assumed;
    /// Relative amplitude with two periods per turn of the wave generator: the main line.
    kinematic_share_2: Ratio = 0.5, Assumed;
    /// Relative amplitude with four periods per turn of the wave generator. A guess.
    kinematic_share_4: Ratio = 0.1, Assumed;
    /// Relative amplitude with one period per turn of the output. A guess.
    kinematic_share_out: Ratio = 0.25, Assumed;
    /// Time constant of the KTY in the winding. A guess.
    sensor_lag: Time = 10.0, Assumed;
    /// Time constant of the PTC in the winding, a smaller bead. A guess.
    ptc_lag: Time = 5.0, Assumed;
    /// Energy of the DC link capacitor at the nominal voltage of the supply \[J\]: 470 µF at 560 V.
    link_energy: Energy = 73.7, Assumed;
    /// Resistance of the DC link supply including its cable, at 560 V \[Ω\].
    supply_resistance: Resistance = 1.0, Assumed;
    /// Braking resistor at 560 V \[Ω\].
    brake_resistor: Resistance = 82.0, Assumed;
    /// Switch-on voltage of the braking resistor relative to the highest of the supply \[1\].
    chopper_on: Ratio = 1.15, Assumed;
    /// Switch-off voltage of the braking resistor relative to the highest of the supply \[1\].
    chopper_off: Ratio = 1.12, Assumed;
    /// Stiffness of a stop hit by the load [Nm/rad]. A guess: that of a rigid machine frame.
    stop_stiffness: TorsionalStiffness = 2.0e5, Assumed;
    /// Opening time of a brake if the tables state none \[s\]: that of the larger sizes.
    brake_opening_usual: Time = 0.11, Assumed;
    /// Closing time of a brake if the tables state none \[s\]: that of the larger sizes.
    brake_closing_usual: Time = 0.07, Assumed;
    /// Noise of a measured phase current, rms \[A\].
    current_noise: Current = 0.0, Assumed;
}

/// Defines the measured values of the load, one per line: key, field and quantity.
macro_rules! load {
    ($($(#[$about:meta])* $key:literal $name:ident: $dimension:ident;)*) => {
        /// Measured values of the load at the output, in SI; values not measured are those of the mechanism.
        #[derive(Clone, Debug, Default, PartialEq)]
        pub struct MeasuredLoad {
            $($(#[$about])* pub $name: Option<Sourced<f64>>,)*
        }

        impl MeasuredLoad {
            const KEYS: &[(&str, Dimension)] = &[$(($key, Dimension::$dimension)),*];

            fn list(&self) -> Vec<Parameter> {
                let stated = [$(($key, Dimension::$dimension, &self.$name)),*];
                let stated = stated.into_iter().filter(|(.., value)| value.is_some());
                stated.map(|(key, dimension, value)| Parameter { key, dimension, value: value.clone() }).collect()
            }
        }
    };
}

load! {
    /// J_L: inertia including the flange.
    "load_inertia" inertia: MomentOfInertia;
    /// T_c: Coulomb friction.
    "load_coulomb" coulomb: Torque;
    /// b: viscous friction.
    "load_viscous" viscous: ViscousFriction;
    /// W: gravity torque at its largest lever.
    "load_gravity" gravity: Torque;
    /// q_0: angle of the centre of mass above the horizontal at q = 0.
    "load_gravity_angle" gravity_angle: Angle;
    /// T_e: torque independent of speed and position.
    "load_external" external: Torque;
}

impl Parameters {
    /// Returns J of the flange, which turns with the load \[kgm²\]; zero if the inertia of the actuator is not known.
    pub(crate) fn flange_kgm2(&self) -> f64 {
        self.actuator.inertia_out.known().map_or(0.0, |known| self.model.flange_inertia_share.value * known.value.si())
    }

    /// Creates the parameters of an actuator on a drive at 560 V.
    #[must_use]
    pub fn of(actuator: &Actuator) -> Self {
        Self::on_supply(actuator, &Supply::of(SUPPLY_USUAL_V))
    }

    /// Creates the parameters of an actuator on a drive with a supply.
    ///
    /// E = E_560 U/560 V (C = C_560 560 V/U), R = R_560 U/560 V: a drive of equal current at another voltage;
    /// thresholds of the braking resistor between the highest voltage of the supply and that of the actuator
    ///
    /// # Symbols
    /// U nominal voltage of the supply \[V\]; E_560, C_560, R_560 values at 560 V
    /// # Source
    /// docs/theory/twin.md; [`actuator::chopper_thresholds`]
    /// # Valid
    /// assumed: the drive is unknown
    #[must_use]
    pub fn on_supply(actuator: &Actuator, supply: &Supply) -> Self {
        let mut model = Model::default();
        let scale = supply.nominal_v / SUPPLY_USUAL_V;
        for value in [&mut model.link_energy, &mut model.supply_resistance, &mut model.brake_resistor] {
            value.value *= scale;
        }
        let most = ElectricPotential::from_si(supply.most_v);
        if let Some([off, on]) =
            actuator::chopper_thresholds(most, actuator.dc_link_max.known().map(|known| known.value))
        {
            (model.chopper_off.value, model.chopper_on.value) = (off.si() / supply.most_v, on.si() / supply.most_v);
        }
        Self { actuator: actuator.clone(), model, load: MeasuredLoad::default() }
    }

    /// Returns the keys of the first pair of which the lower value is above the upper one.
    pub(crate) fn reversed(&self) -> Option<(&'static str, &'static str)> {
        let Model { chopper_off, chopper_on, .. } = &self.model;
        let [first, second] = [&self.actuator.gear.torque_1, &self.actuator.gear.torque_2].map(|torque| torque.known());
        let pairs = [
            ("chopper_off", Some(chopper_off.value), "chopper_on", Some(chopper_on.value)),
            (
                "gear_torque_1",
                first.map(|known| known.value.si()),
                "gear_torque_2",
                second.map(|known| known.value.si()),
            ),
        ];
        pairs.into_iter().find_map(|(lower, low, upper, high)| (low? > high?).then_some((lower, upper)))
    }

    /// Returns all parameters in the fixed order of the exported file.
    #[must_use]
    pub fn list(&self) -> Vec<Parameter> {
        let of = |of: &Of| Parameter { key: of.key, dimension: of.dimension, value: (of.get)(&self.actuator) };
        let stiffness = STIFFNESS.iter().zip(&self.actuator.gear.stiffness).map(|(key, datum)| Parameter {
            key,
            dimension: Dimension::TorsionalStiffness,
            value: datum.known().map(|known| known.clone().map(Measure::si)),
        });
        DATA.iter().map(of).chain(stiffness).chain(self.model.list()).chain(self.load.list()).collect()
    }

    /// Returns all keys with their dimensions.
    #[must_use]
    pub fn keys() -> Vec<(&'static str, Dimension)> {
        let stiffness = STIFFNESS.iter().map(|key| (*key, Dimension::TorsionalStiffness));
        let model = Model::default().list().into_iter().map(|each| (each.key, each.dimension));
        let load = MeasuredLoad::KEYS.iter().copied();
        DATA.iter().map(|of| (of.key, of.dimension)).chain(stiffness).chain(model).chain(load).collect()
    }
}

/// Returns a datum in SI.
pub(crate) fn si<Q: Measure>(datum: &Datum<Q>, symbol: &'static str) -> Result<f64, Missing> {
    datum.require(symbol).map(|known| known.value.si())
}
