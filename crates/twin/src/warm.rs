//! Settled temperatures of a repeated cycle, from its mean losses.

use crate::setup::{Fault, Setup};
use crate::twin::Twin;
use crate::{Scenario, ScenarioId};
use quantities::{Measure, ThermodynamicTemperature};

/// Computes the temperatures of winding and housing \[K\] at which a repeated cycle settles: one cycle is run and its
/// mean losses give the steady temperatures, until they change by less than a tenth of a kelvin; heat trips nothing
/// meanwhile, and `goes_on` is polled before each cycle.
///
/// # Source
/// docs/theory/twin.md; the network of docs/theory/thermal.md
/// # Valid
/// cycles short compared with τ_w: within a longer one the winding temperature varies
/// # Errors
/// [`Fault`] of [`Twin::new`]; `Ok(None)` if cancelled by the caller or if the actuator has no heat model
pub fn settled(setup: &Setup<'_>, mut goes_on: impl FnMut() -> bool) -> Result<Option<[f64; 2]>, Fault> {
    let Ok(heat) = actuator::HeatModel::of(&setup.parameters.actuator) else { return Ok(None) };
    let mut start_k = setup.start_k.unwrap_or([setup.ambient_k; 2]);
    let scenario = Scenario { id: ScenarioId::Cycle, cycles: 1, ..setup.scenario };
    for _ in 0..ROUNDS {
        let mut twin = Twin::untripped(&Setup { start_k: Some(start_k), scenario, ..*setup })?;
        while !twin.is_over() {
            if !goes_on() {
                return Ok(None);
            }
            twin.advance(AT_ONCE);
        }
        let ambient = ThermodynamicTemperature::from_si(setup.ambient_k);
        let steady = heat.network().steady(twin.losses(), ambient);
        // Limited to a destructive temperature: the run itself shows an excessive cycle.
        let next = [steady.winding.si(), steady.housing.si()].map(|kelvin| kelvin.min(HOTTEST_K));
        let change = next.iter().zip(&start_k).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        start_k = next;
        if change < 0.1 {
            break;
        }
    }
    Ok(Some(start_k))
}

/// Number of iterations: friction decreases with the temperature and copper loss increases, so that each at least
/// halves the error.
const ROUNDS: usize = 8;

/// Periods between two polls: 64 ms of simulated time.
const AT_ONCE: u64 = 1024;

/// Upper limit of the settled temperatures, 200 °C \[K\].
const HOTTEST_K: f64 = 473.15;
