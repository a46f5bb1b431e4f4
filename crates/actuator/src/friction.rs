//! No-load friction of motor and gear as a current, and its dependence on the temperature of the grease.

use crate::parameters::Drivetrain;
use provenance::Missing;
use quantities::unit::DEGREE_CELSIUS;
use quantities::{ElectricCurrent, Measure, NoLoadCurrentConstant, ThermodynamicTemperature};

/// Law of the no-load friction of an actuator.
///
/// I_f = I_NLS + K(ϑ) |n|, K(ϑ) = K_c (K_w/K_c)^((ϑ − ϑ_c)/(ϑ_w − ϑ_c))
///
/// The viscosity of grease decreases exponentially with the temperature over such a range, therefore the two table
/// values are joined by an exponential instead of a straight line. Above ϑ_w K stays at K_w. Below ϑ_p the same factor
/// applies to I_NLS too: the extrapolation *cold friction*, with the band of [`NoLoadFriction::cold_band`].
///
/// # Symbols
/// I_NLS no-load starting current \[A\], K no-load current constant [A/(1/min)] per output speed, K_c and K_w its
/// values at the temperatures ϑ_c and ϑ_w of the tables, ϑ_p lowest temperature for which friction is stated, n output
/// speed [1/min], ϑ temperature of the gear, assumed equal to that of the housing
/// # Source
/// rows I_NLS and K_INL of the manufacturer's tables; docs/theory/current.md
/// # Valid
/// from ϑ_p to ϑ_w within the tables, below by extrapolation
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoLoadFriction {
    /// I_NLS \[A\]
    starting_a: f64,
    /// Share of I_NLS that adds to the current of a torque \[1\]: 1, or 0 for the 48 V windings, whose k_Tout is
    /// T_0/I_0 and therefore includes it.
    counted: f64,
    /// K_c [A/(rad/s)]
    constant_cold: f64,
    /// ln(K_c/K_w)/(ϑ_w − ϑ_c) [1/K]
    decay_per_k: f64,
    /// ϑ_c and ϑ_w \[K\]
    printed_k: [f64; 2],
    /// ϑ_p \[K\]
    printed_from_k: f64,
    /// Lower and upper growth of friction per kelvin where it is extrapolated to low temperatures \[1/K\].
    cold_growth_per_k: Option<(f64, f64)>,
}

/// Friction at one temperature, expressed as currents.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionAt {
    /// Temperature of the gear.
    pub temperature: ThermodynamicTemperature,
    /// I_NLS at this temperature.
    pub starting: ElectricCurrent,
    /// I_s: share of I_NLS that adds to the current of a torque; zero for the 48 V windings, whose I_0 = T_0/k_Tout.
    pub counted: ElectricCurrent,
    /// K_INL at this temperature.
    pub constant: NoLoadCurrentConstant,
}

impl NoLoadFriction {
    /// Creates the law of an actuator; if K_INL is known at the lower temperature only, it is constant.
    ///
    /// # Errors
    /// [`Missing`] with the first unknown datum.
    pub fn of(actuator: &Drivetrain) -> Result<Self, Missing> {
        let starting = actuator.no_load_starting_current.require("I_NLS")?.value.si();
        let cold = actuator.no_load_current_constant_cold.require("K_INL")?.value.si();
        let warm = actuator.no_load_current_constant_warm.known().map_or(cold, |warm| warm.value.si());
        let printed_k = actuator.no_load_temperatures.require("K_INL")?.value.map(Measure::si);
        let printed_from_k = actuator.friction_printed_from.require("friction_printed_from")?.value.si();
        let both = cold > 0.0 && warm > 0.0;
        let decay_per_k = if both { (cold / warm).ln() / (printed_k[1] - printed_k[0]) } else { 0.0 };
        let counted = if actuator.stall_current_includes_friction { 1.0 } else { 0.0 };
        let cold_growth_per_k = actuator.friction_cold_growth.known().map(|growth| growth.value);
        let constant_cold = cold;
        Ok(Self {
            starting_a: starting,
            counted,
            constant_cold,
            decay_per_k,
            printed_k,
            printed_from_k,
            cold_growth_per_k,
        })
    }

    /// Returns ϑ_c, the temperature of a cold gear: the lower temperature for which friction is stated. It applies if
    /// no ambient temperature, or a higher one, is stated; in colder air the gear has the temperature of the air.
    #[must_use]
    pub fn cold_start(&self) -> ThermodynamicTemperature {
        ThermodynamicTemperature::from_si(self.printed_k[0])
    }

    /// Returns ϑ_w, the highest temperature for which friction is stated.
    #[must_use]
    pub fn warmest(&self) -> ThermodynamicTemperature {
        ThermodynamicTemperature::from_si(self.printed_k[1])
    }

    /// Returns the friction at a temperature of the gear.
    #[must_use]
    pub fn at(&self, temperature: ThermodynamicTemperature) -> FrictionAt {
        let (starting, constant, _) = self.state(temperature.si());
        self.with(temperature, starting, constant)
    }

    /// Returns the friction for an I_NLS \[A\] and a K [A/(rad/s)] already determined for a temperature.
    pub(crate) fn with(&self, temperature: ThermodynamicTemperature, starting: f64, constant: f64) -> FrictionAt {
        FrictionAt {
            temperature,
            starting: ElectricCurrent::from_si(starting),
            counted: ElectricCurrent::from_si(self.counted(starting)),
            constant: NoLoadCurrentConstant::from_si(constant),
        }
    }

    /// Returns δ, the decay of K per kelvin between ϑ_p and ϑ_w \[1/K\].
    #[must_use]
    pub const fn decay_per_k(&self) -> f64 {
        self.decay_per_k
    }

    /// Returns I_s for an I_NLS \[A\].
    pub(crate) fn counted(&self, starting: f64) -> f64 {
        starting * self.counted
    }

    /// Returns I_NLS \[A\], K [A/(rad/s)] and −dK/dϑ at a temperature \[K\].
    pub(crate) fn state(&self, temperature_k: f64) -> (f64, f64, f64) {
        let [cold_k, warm_k] = self.printed_k;
        if temperature_k >= warm_k {
            let warm = self.constant_cold * (-self.decay_per_k * (warm_k - cold_k)).exp();
            return (self.starting_a, warm, 0.0);
        }
        let constant = self.constant_cold * (-self.decay_per_k * (temperature_k - cold_k)).exp();
        let cold = (self.printed_from_k - temperature_k).max(0.0);
        let starting = if cold > 0.0 { self.starting_a * (self.decay_per_k * cold).exp() } else { self.starting_a };
        (starting, constant, self.decay_per_k * constant)
    }

    /// Returns the lower and upper factor on friction in the extrapolation below ϑ_p; `None` from ϑ_p on.
    ///
    /// Towards low temperatures, starting currents grow at a rate between two limits per kelvin, see
    /// [`crate::Drivetrain::friction_cold_growth`], the extrapolation at ln(K_c/K_w)/(ϑ_w − ϑ_c): the factor is their
    /// quotient over the range below ϑ_p.
    ///
    /// # Errors
    /// [`Missing`] if the law is extrapolated and its band is unknown.
    pub fn cold_band(&self, temperature: ThermodynamicTemperature) -> Result<Option<(f64, f64)>, Missing> {
        let cold = self.printed_from_k - temperature.si();
        // A difference of a nanokelvin is a rounding error of a unit.
        if cold <= 1e-9 {
            return Ok(None);
        }
        let (low, high) = self.cold_growth_per_k.ok_or(Missing { symbol: "cold_growth_low" })?;
        let beside = |growth: f64| ((growth - self.decay_per_k) * cold).exp();
        Ok(Some((beside(low).min(1.0), beside(high).max(1.0))))
    }
}

impl FrictionAt {
    /// Returns I_f = I_s + K |n|, the magnitude that friction adds to the current of a torque in motion.
    #[must_use]
    pub fn current(&self, speed: quantities::AngularVelocity) -> ElectricCurrent {
        ElectricCurrent::from_si(self.counted.si() + self.constant.si() * speed.si().abs())
    }

    /// Returns the temperature in degrees Celsius, for display.
    #[must_use]
    pub fn celsius(&self) -> f64 {
        self.temperature.in_unit(&DEGREE_CELSIUS)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAW: NoLoadFriction = NoLoadFriction {
        starting_a: 0.2,
        counted: 1.0,
        constant_cold: 0.04,
        decay_per_k: 0.020_794_415_416_798_36,
        printed_k: [303.15, 353.15],
        printed_from_k: 293.15,
        cold_growth_per_k: Some((0.019, 0.052)),
    };

    fn at(celsius: f64) -> FrictionAt {
        LAW.at(ThermodynamicTemperature::new_in(celsius, &DEGREE_CELSIUS))
    }

    /// K_30/K_80 = e^(0.0207944·50) = 2.828; at 55 °C, in the middle, the geometric mean.
    #[test]
    fn the_printed_pair_is_met_and_joined_by_an_exponential() {
        assert!((at(30.0).constant.si() - 0.04).abs() < 1e-15);
        assert!((at(80.0).constant.si() - 0.04 / 8.0_f64.sqrt()).abs() < 1e-12);
        assert!((at(55.0).constant.si().powi(2) - at(30.0).constant.si() * at(80.0).constant.si()).abs() < 1e-15);
        assert_eq!(at(95.0).constant, at(80.0).constant, "beyond the print it stays");
        assert_eq!(at(20.0).starting.si(), 0.2);
    }

    #[test]
    fn in_the_cold_both_grow_and_the_band_is_reported() {
        assert!((at(0.0).starting.si() / 0.2 - (0.020_794_4_f64 * 20.0).exp()).abs() < 1e-4);
        let band = |celsius: f64| LAW.cold_band(ThermodynamicTemperature::new_in(celsius, &DEGREE_CELSIUS));
        assert_eq!(band(20.0), Ok(None));
        let (low, high) = band(0.0).unwrap().unwrap();
        assert!((low - ((0.019_f64 - 0.020_794_4) * 20.0).exp()).abs() < 1e-4);
        assert!((high - ((0.052_f64 - 0.020_794_4) * 20.0).exp()).abs() < 1e-4);
        let unknown = NoLoadFriction { cold_growth_per_k: None, ..LAW };
        assert_eq!(unknown.cold_band(ThermodynamicTemperature::new_in(30.0, &DEGREE_CELSIUS)), Ok(None));
        assert!(unknown.cold_band(ThermodynamicTemperature::new_in(0.0, &DEGREE_CELSIUS)).is_err());
    }
}
