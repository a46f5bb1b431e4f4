//! The actuators of the catalogue that can be had, with their parameters.

use crate::{all, parameters};
use actuator::Parameters;
use order_code::{Option1, OrderCode};
use std::sync::LazyLock;

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

/// Each code is the bare one, its parameters those with the option.
fn actuators_with(option_1: Option<Option1>) -> Vec<(OrderCode, Parameters)> {
    all()
        .iter()
        .filter(|(code, found)| code.option_1.is_none() && code.option_2.is_none() && found.is_available())
        .filter_map(|(code, _)| Some((*code, parameters(&OrderCode { option_1, ..*code })?)))
        .collect()
}
