//! Where and when a run begins.

use crate::scenario::ScenarioId;
use crate::setpoint::Course;
use crate::setup::{Fault, Setup};
use quantities::Measure;

/// The air of a scenario \[K\].
pub(super) fn ambient(setup: &Setup<'_>) -> f64 {
    let range = setup.parameters.actuator.ambient_range.known().map(|known| known.value);
    match (setup.scenario.id, range) {
        (ScenarioId::HotAmbient, Some((_, warmest))) => warmest.si().max(setup.ambient_k),
        (ScenarioId::ColdGrease, Some((coldest, _))) => coldest.si().min(setup.ambient_k),
        _ => setup.ambient_k,
    }
}

/// The largest voltage of the DC link: that of the actuator.
pub(super) fn link_most(setup: &Setup<'_>) -> f64 {
    let known = setup.parameters.actuator.dc_link_max.known().map(|known| known.value.si());
    known.unwrap_or(1.25 * setup.supply_v).max(1.05 * setup.supply_v)
}

/// When the scenario takes place.
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
