//! Resistance of a copper winding.

use quantities::{ElectricalResistance, Measure, ThermodynamicTemperature};

/// Temperature coefficient of copper at 20 °C \[1/K\]: handbook value 3.93e-3; IEC 60034-1 uses 1/(235+20) = 3.92e-3.
const COPPER_TEMPERATURE_COEFFICIENT: f64 = 3.93e-3;

/// Returns the resistance of a copper winding at a temperature.
///
/// R = R_20 (1 + 3.93e-3 (ϑ − 20 °C))
///
/// # Valid
/// −40 °C to 200 °C, linear law of copper
#[must_use]
pub fn copper_resistance(
    resistance_20: ElectricalResistance,
    temperature: ThermodynamicTemperature,
) -> ElectricalResistance {
    let rise = temperature.si() - 293.15;
    ElectricalResistance::from_si(resistance_20.si() * (1.0 + COPPER_TEMPERATURE_COEFFICIENT * rise))
}
