//! Initial conditions of a run, and the instant of its event.

use crate::scenario::ScenarioId;
use crate::setpoint::Course;
use crate::setup::{Fault, Setup};
use quantities::{ElectricPotential, Measure};

/// Returns the ambient temperature of a scenario \[K\].
pub(super) fn ambient(setup: &Setup<'_>) -> f64 {
    let range = setup.parameters.actuator.ambient_range.known().map(|known| known.value);
    match (setup.scenario.id, range) {
        (ScenarioId::HotAmbient, Some((_, warmest))) => warmest.si().max(setup.ambient_k),
        (ScenarioId::ColdGrease, Some((coldest, _))) => coldest.si().min(setup.ambient_k),
        _ => setup.ambient_k,
    }
}

/// Returns the DC link voltage at which the drive switches off \[V\]: U_DCmax if a braking resistor can keep the link
/// below it.
///
/// Otherwise U_DCmax is exceeded while braking, which the manual permits for a short time (glossary), and the drive
/// protects only itself: at a quarter above its supply, chosen by antrieb.
pub(super) fn link_most(setup: &Setup<'_>) -> f64 {
    let most = ElectricPotential::from_si(setup.supply.most_v);
    let limit = setup.parameters.actuator.dc_link_max.known().map(|known| known.value);
    match (limit, actuator::chopper_thresholds(most, limit)) {
        (Some(limit), Some(_)) => limit.si(),
        _ => 1.25 * setup.supply.most_v,
    }
}

/// Returns the instant of the scenario's event \[s\].
pub(super) fn happens(setup: &Setup<'_>, course: &Course<'_>) -> Result<Option<f64>, Fault> {
    let usual = match setup.scenario.id {
        ScenarioId::Cycle
        | ScenarioId::BrakeStuck
        | ScenarioId::BatteryLoss
        | ScenarioId::HotAmbient
        | ScenarioId::ColdGrease => return Ok(None),
        ScenarioId::HangingLoad => 0.0,
        ScenarioId::EmergencyStop
        | ScenarioId::PowerFailure
        | ScenarioId::BlockedLoad
        | ScenarioId::EncoderFailure
        | ScenarioId::LinkSag
        | ScenarioId::Collision => course.fastest_s(),
    };
    let at = setup.scenario.at_s.unwrap_or(usual);
    if !at.is_finite() || at < 0.0 {
        return Err(Fault::OutOfRange("at"));
    }
    let end_s = course.duration_s();
    if at >= end_s {
        return Err(Fault::AfterTheEnd { end_s });
    }
    let speed = course.at(at).state[1].abs();
    match setup.scenario.id {
        ScenarioId::HangingLoad if speed > 1e-9 => Err(Fault::NotAtRest),
        ScenarioId::Collision if speed < 1e-9 => Err(Fault::AtRest),
        _ => Ok(Some(at)),
    }
}
