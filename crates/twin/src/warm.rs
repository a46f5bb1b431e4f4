//! The settled temperatures of a cycle that repeats for ever, by the mean of its losses.

use crate::setup::{Fault, Setup};
use crate::twin::Twin;
use crate::{Scenario, ScenarioId};
use quantities::{Measure, ThermodynamicTemperature};

/// Temperatures of winding and housing \[K\] to which a cycle settles that repeats for ever: one cycle is run, its mean losses
/// give the steady temperatures, until they change by less than a tenth of a kelvin; `goes_on` is polled before each cycle.
///
/// # Source
/// docs/theory/twin.md; the network of docs/theory/thermal.md
/// # Valid
/// cycles short against τ_w: the temperature of the winding swings within a longer one
/// # Errors
/// [`Fault`] as of [`Twin::new`]; `Ok(None)` where the caller ends it or the actuator has no heat model
pub fn settled(setup: &Setup<'_>, mut goes_on: impl FnMut() -> bool) -> Result<Option<[f64; 2]>, Fault> {
    let Ok(heat) = actuator::HeatModel::of(&setup.parameters.actuator) else { return Ok(None) };
    let mut start_k = setup.start_k.unwrap_or([setup.ambient_k; 2]);
    let scenario = Scenario { id: ScenarioId::Cycle, cycles: 1, ..setup.scenario };
    for _ in 0..ROUNDS {
        let mut twin = Twin::new(&Setup { start_k: Some(start_k), scenario, ..*setup })?;
        while !twin.is_over() {
            if !goes_on() {
                return Ok(None);
            }
            twin.advance(AT_ONCE);
        }
        let ambient = ThermodynamicTemperature::from_si(setup.ambient_k);
        let steady = heat.network().steady(twin.losses(), ambient);
        // Not hotter than what destroys it: a cycle that is too much is shown as such by the run itself.
        let next = [steady.winding.si(), steady.housing.si()].map(|kelvin| kelvin.min(HOTTEST_K));
        let change = next.iter().zip(&start_k).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        start_k = next;
        if change < 0.1 {
            break;
        }
    }
    Ok(Some(start_k))
}

/// Friction falls with the temperature, copper loss rises: the rounds contract by at least one half each.
const ROUNDS: usize = 8;

/// Periods between two polls: 64 ms of the run.
pub(crate) const AT_ONCE: u64 = 1024;

/// 200 °C.
const HOTTEST_K: f64 = 473.15;
