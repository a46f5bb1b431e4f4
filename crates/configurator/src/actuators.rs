//! The actuators of the catalogue that can be had, with their parameters.

use crate::{Availability, all, parameters};
use actuator::Parameters;
use order_code::{Option1, OrderCode};
use std::sync::{Arc, LazyLock};

/// The actuators without options, or with the encoder at the output: each under its bare code, its parameters those with
/// the option.
#[must_use]
pub fn actuators(option_1: Option<Option1>) -> &'static [(OrderCode, Parameters)] {
    if option_1.is_some() { actuators_with_output_encoder() } else { catalogue_actuators() }
}

/// Every actuator of the catalogue that has printed data and can be had without asking, with its parameters:
/// each size, ratio, winding, feedback and brake, without options.
#[must_use]
pub fn catalogue_actuators() -> &'static [(OrderCode, Parameters)] {
    static ACTUATORS: LazyLock<Vec<(OrderCode, Parameters)>> = LazyLock::new(|| actuators_with(None));
    &ACTUATORS
}

/// The same actuators with the encoder at the output.
fn actuators_with_output_encoder() -> &'static [(OrderCode, Parameters)] {
    static ACTUATORS: LazyLock<Vec<(OrderCode, Parameters)>> = LazyLock::new(|| actuators_with(Some(Option1::EC)));
    &ACTUATORS
}

/// Each code is the bare one, its parameters those with the option. Neighbours whose drivetrains are equal share one.
fn actuators_with(option_1: Option<Option1>) -> Vec<(OrderCode, Parameters)> {
    let available = |code: &OrderCode, found: &Availability| {
        code.option_1.is_none() && code.option_2.is_none() && found.is_available()
    };
    let mut actuators: Vec<(OrderCode, Parameters)> = Vec::new();
    for (code, _) in all().iter().filter(|(code, found)| available(code, found)) {
        let Some(mut parameters) = parameters(&OrderCode { option_1, ..*code }) else { continue };
        if let Some((_, before)) = actuators.last()
            && before.drivetrain == parameters.drivetrain
        {
            parameters.drivetrain = Arc::clone(&before.drivetrain);
        }
        actuators.push((*code, parameters));
    }
    actuators
}
