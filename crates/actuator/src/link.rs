//! DC link: switching thresholds of a braking resistor within the largest voltage of the actuator.

use quantities::{ElectricPotential, Measure};

/// Largest switch-on voltage of a braking resistor relative to U_DCmax \[1\]. Chosen by antrieb: margin for tolerance
/// and overshoot of the threshold.
const BELOW_THE_LARGEST: f64 = 0.97;

/// Usual switch-on voltage relative to the largest of the supply \[1\]. Chosen by antrieb.
const ABOVE_THE_SUPPLY: f64 = 1.15;

/// Hysteresis relative to the distance of the threshold from the supply \[1\]: 1.12 to 1.15 of the supply. Chosen by
/// antrieb.
const HYSTERESIS: f64 = 0.2;

/// Returns the switch-off and switch-on voltage of a braking resistor; `None` if no threshold lies between supply and
/// actuator.
///
/// U_on = min(1.15 U_s, 0.97 U_DCmax), U_off = U_on − 0.2 (U_on − U_s)
///
/// # Symbols
/// U_s largest voltage of the DC link by the supply alone \[V\], U_DCmax largest stationary voltage of the actuator \[V\]
/// # Source
/// docs/theory/twin.md; factors chosen by antrieb
/// # Valid
/// U_s < 0.97 U_DCmax. Above that, a threshold that respects U_DCmax would be below the supply, which would then feed
/// the resistor.
#[must_use]
pub fn chopper_thresholds(
    supply: ElectricPotential,
    limit: Option<ElectricPotential>,
) -> Option<[ElectricPotential; 2]> {
    let usual = ABOVE_THE_SUPPLY * supply.si();
    let on = limit.map_or(usual, |limit| usual.min(BELOW_THE_LARGEST * limit.si()));
    let off = on - HYSTERESIS * (on - supply.si());
    (on > supply.si()).then(|| [off, on].map(ElectricPotential::from_si))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn thresholds(supply: f64, limit: Option<f64>) -> Option<[f64; 2]> {
        let found = chopper_thresholds(ElectricPotential::from_si(supply), limit.map(ElectricPotential::from_si));
        found.map(|both| both.map(Measure::si))
    }

    fn is(found: Option<[f64; 2]>, wanted: [f64; 2]) -> bool {
        found.is_some_and(|found| found.iter().zip(wanted).all(|(one, other)| (one - other).abs() < 1e-9))
    }

    /// Thresholds by hand: 560 V, 400 V mains + 10 % (622.25 V), 48 V at 680, 680 and 48 V.
    #[test]
    fn the_resistor_is_switched_between_supply_and_actuator() {
        assert!(is(thresholds(560.0, Some(680.0)), [627.2, 644.0]));
        assert!(is(thresholds(622.25, Some(680.0)), [659.6 - 0.2 * 37.35, 659.6]));
        assert!(is(thresholds(560.0, None), [627.2, 644.0]));
        assert_eq!(thresholds(48.0, Some(48.0)), None);
        assert_eq!(thresholds(659.6, Some(680.0)), None);
        assert_eq!(thresholds(700.0, Some(680.0)), None);
    }
}
