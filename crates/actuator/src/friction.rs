//! No-load friction of motor and gear as a current, and how it changes with the temperature of the grease.

use crate::parameters::Drivetrain;
use provenance::Missing;
use quantities::unit::DEGREE_CELSIUS;
use quantities::{ElectricCurrent, Measure, NoLoadCurrentConstant, ThermodynamicTemperature};

/// The law of the no-load friction of one actuator.
///
/// I_f = I_NLS + K(ϑ) |n|, K(ϑ) = K_c (K_w/K_c)^((ϑ − ϑ_c)/(ϑ_w − ϑ_c))
///
/// The viscosity of grease falls exponentially with the temperature over such a span, so the printed pair is joined by an
/// exponential, not by a straight line. Above ϑ_w K stays K_w. Below ϑ_p the same factor holds for I_NLS too: the
/// extrapolation *cold friction*, with the band of [`NoLoadFriction::cold_band`].
///
/// # Symbols
/// I_NLS no-load starting current \[A\], K no-load current constant [A/(1/min)] per output speed, K_c and K_w that at the
/// temperatures ϑ_c and ϑ_w of the print, ϑ_p the temperature from which friction is printed, n output speed [1/min],
/// ϑ temperature of the gear, taken as that of the housing
/// # Source
/// rows I_NLS and K_INL of the maker's tables; docs/theory/current.md
/// # Valid
/// from ϑ_p to ϑ_w within the print, below by extrapolation
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoLoadFriction {
    /// I_NLS \[A\]
    starting_a: f64,
    /// The part of it that adds to the current of a torque: all of it, or none in the 48 V windings, whose k_Tout is
    /// T_0/I_0 and so holds it already.
    counted: f64,
    /// K_c [A/(rad/s)]
    constant_cold: f64,
    /// ln(K_c/K_w)/(ϑ_w − ϑ_c) [1/K]
    decay_per_k: f64,
    /// ϑ_c and ϑ_w \[K\]
    printed_k: [f64; 2],
    /// ϑ_p \[K\]
    printed_from_k: f64,
    /// Between these growths per kelvin friction may lie where it is extrapolated into the cold.
    cold_growth_per_k: Option<(f64, f64)>,
}

/// Friction at one temperature, as currents.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionAt {
    /// Temperature of the gear.
    pub temperature: ThermodynamicTemperature,
    /// I_NLS at it.
    pub starting: ElectricCurrent,
    /// I_s: the part of it that adds to the current of a torque; zero for the 48 V windings, whose I_0 = T_0/k_Tout.
    pub counted: ElectricCurrent,
    /// K_INL at it.
    pub constant: NoLoadCurrentConstant,
}

impl NoLoadFriction {
    /// The law of an actuator; if K_INL is known at the colder temperature only, it does not change with the temperature.
    ///
    /// # Errors
    /// [`Missing`] with the first datum that is not known.
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

    /// ϑ_c: temperature of a cold gear, the colder one of those for which friction is printed. It holds where no ambient
    /// temperature is stated or a higher one; in colder air the gear is as cold as the air.
    #[must_use]
    pub fn cold_start(&self) -> ThermodynamicTemperature {
        ThermodynamicTemperature::from_si(self.printed_k[0])
    }

    /// ϑ_w: the warmest temperature for which friction is printed.
    #[must_use]
    pub fn warmest(&self) -> ThermodynamicTemperature {
        ThermodynamicTemperature::from_si(self.printed_k[1])
    }

    /// The friction at a temperature of the gear.
    #[must_use]
    pub fn at(&self, temperature: ThermodynamicTemperature) -> FrictionAt {
        let (starting, constant, _) = self.state(temperature.si());
        self.with(temperature, starting, constant)
    }

    /// The friction of an I_NLS \[A\] and a K [A/(rad/s)] that were found for a temperature.
    pub(crate) fn with(&self, temperature: ThermodynamicTemperature, starting: f64, constant: f64) -> FrictionAt {
        FrictionAt {
            temperature,
            starting: ElectricCurrent::from_si(starting),
            counted: ElectricCurrent::from_si(self.counted(starting)),
            constant: NoLoadCurrentConstant::from_si(constant),
        }
    }

    /// δ: decay of K per kelvin \[1/K\], between ϑ_p and ϑ_w.
    #[must_use]
    pub const fn decay_per_k(&self) -> f64 {
        self.decay_per_k
    }

    /// I_s of an I_NLS \[A\].
    pub(crate) fn counted(&self, starting: f64) -> f64 {
        starting * self.counted
    }

    /// I_NLS \[A\], K [A/(rad/s)] and −dK/dϑ at a temperature \[K\].
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

    /// By which factors friction may lie beside the extrapolation below ϑ_p; `None` from there on.
    ///
    /// Towards the cold starting currents grow between two rates per kelvin, see [`crate::Drivetrain::friction_cold_growth`], the
    /// extrapolation by ln(K_c/K_w)/(ϑ_w − ϑ_c): the quotient over the span below ϑ_p.
    ///
    /// # Errors
    /// [`Missing`] where the law is extrapolated and its band is not known.
    pub fn cold_band(&self, temperature: ThermodynamicTemperature) -> Result<Option<(f64, f64)>, Missing> {
        let cold = self.printed_from_k - temperature.si();
        // A difference of a nanokelvin is the rounding of a unit.
        if cold <= 1e-9 {
            return Ok(None);
        }
        let (low, high) = self.cold_growth_per_k.ok_or(Missing { symbol: "cold_growth_low" })?;
        let beside = |growth: f64| ((growth - self.decay_per_k) * cold).exp();
        Ok(Some((beside(low).min(1.0), beside(high).max(1.0))))
    }
}

impl FrictionAt {
    /// I_f = I_s + K |n|: what friction adds to the current of a torque while turning, by magnitude.
    #[must_use]
    pub fn current(&self, speed: quantities::AngularVelocity) -> ElectricCurrent {
        ElectricCurrent::from_si(self.counted.si() + self.constant.si() * speed.si().abs())
    }

    /// The temperature in degrees Celsius, for people.
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

    /// K_30/K_80 = e^(0.0207944·50) = 2.828: at the middle, 55 °C, the geometric mean.
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
