//! Single chapters as separate answers: output bearing, battery.

use crate::progress::Progress;
use crate::sizing_use::{Candidate, Refusal, check_part};
use actuator::BatteryLife;
use configurator::catalogue_actuators;
use order_code::Size;
use project::Project;
use quantities::unit::HOUR;
use quantities::{Language, Measure, Time, parse_as};
use sizing::{Check, Part, StepObserver as _};
use std::sync::Arc;

/// Reads a quantity from the command line.
///
/// # Errors
/// The fault of the text, and a hint.
pub fn read_quantity<Q: Measure>(text: &str, language: Language) -> Result<Q, (String, Option<String>)> {
    parse_as(text).map_err(|error| (words::quantity_fault(&error, language), words::quantity_hint(&error, language)))
}

/// Reads hours per day; the unit may be omitted, since the name of the option states it.
///
/// # Errors
/// The fault of the text, and a hint.
pub(crate) fn read_hours(text: &str, language: Language) -> Result<Time, (String, Option<String>)> {
    match text.trim().parse::<f64>() {
        Ok(hours) => Ok(Time::new_in(hours, &HOUR)),
        Err(_) => read_quantity(text, language),
    }
}

/// Computes the life of the battery of a buffered encoder from the hours of operation per day and the storage before.
///
/// # Errors
/// The value that is out of range.
pub(crate) fn battery(operation_per_day: Time, storage: Time, language: Language) -> Result<BatteryLife, String> {
    let battery = configurator::battery();
    let model = battery.require("battery_capacity").map_err(|missing| missing.symbol.to_owned())?;
    model.value.life(operation_per_day, storage).map_err(|fault| words::battery_fault(&fault, language))
}

/// Iterates over the checks of the output bearing of one code.
pub fn bearing_checks<'c>(candidate: &'c Candidate<'_>) -> impl Iterator<Item = &'c Check> {
    candidate.judgement.checks.iter().map(Arc::as_ref).filter(|check| check.id.part() == Part::OutputBearing)
}

/// Judges one code of each size by the checks of its output bearing alone: all codes of a size have the same bearing.
///
/// # Errors
/// [`Refusal::Stopped`]
pub fn bearing_of_each_size<'p>(
    project: &'p Project,
    progress: &Progress,
) -> Result<Vec<(Size, Candidate<'p>)>, Refusal> {
    let mut found: Vec<(Size, Candidate<'_>)> = Vec::new();
    for (code, _) in catalogue_actuators() {
        if found.iter().all(|(size, _)| *size != code.size) {
            progress.step()?;
            if let Ok(candidate) = check_part(project, code, Part::OutputBearing) {
                found.push((code.size, candidate));
            }
        }
    }
    progress.step()?;
    Ok(found)
}
