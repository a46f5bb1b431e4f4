//! Single chapters as separate answers: output bearing, battery.

use crate::progress::Progress;
use crate::sizing_use::{Candidate, Refusal, check_part};
use actuator::{Battery, BatteryFault, BatteryLife};
use axis::AxisProject;
use configurator::Product;
use provenance::Datum;
use quantities::unit::HOUR;
use quantities::{Language, Measure, Time, parse_as};
use sizing::{Check, Part, StepObserver as _};

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
/// The fault of the text, and a hint; more hours than a day has.
pub(crate) fn read_hours(text: &str, language: Language) -> Result<Time, (String, Option<String>)> {
    let per_day = match text.trim().parse::<f64>() {
        Ok(hours) => Time::new_in(hours, &HOUR),
        Err(_) => read_quantity(text, language)?,
    };
    if (0.0..=24.0).contains(&per_day.in_unit(&HOUR)) {
        return Ok(per_day);
    }
    Err((words::battery_fault(&BatteryFault::OperationOutOfRange { per_day }, language), None))
}

/// Computes the life of the battery of a buffered encoder from the hours of operation per day and the storage before.
///
/// # Errors
/// The value that is out of range.
pub(crate) fn battery(
    battery: &Datum<Battery>,
    operation_per_day: Time,
    storage: Time,
    language: Language,
) -> Result<BatteryLife, String> {
    let model = battery.require("battery_capacity").map_err(|missing| missing.symbol.to_owned())?;
    model.value.life(operation_per_day, storage).map_err(|fault| words::battery_fault(&fault, language))
}

/// Iterates over the checks of the output bearing of one code.
pub fn bearing_checks<'c>(candidate: &'c Candidate<'_>) -> impl Iterator<Item = &'c Check> {
    candidate.judgement.checks.iter().filter(|check| check.id.part() == Part::OutputBearing)
}

/// Judges the output bearing of each frame size for an axis, on the first product of the size: the bearing depends on the
/// size alone.
///
/// # Errors
/// [`Refusal::Stopped`].
pub fn bearing_of_each_size<'p>(project: &'p AxisProject, progress: &Progress) -> Result<Vec<Candidate<'p>>, Refusal> {
    let mut found: Vec<Candidate<'_>> = Vec::new();
    let kind = |product: &'p Product| (&product.series, &product.frame_size);
    for product in project.catalogue().products(false) {
        if product.frame_size.is_some() && found.iter().all(|known| kind(known.product) != kind(product)) {
            progress.step()?;
            found.extend(check_part(project, &product.id, Part::OutputBearing));
        }
    }
    progress.step()?;
    Ok(found)
}
