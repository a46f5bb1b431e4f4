//! Products of the ordering tables that are available without request, with their data.

use crate::codes::{is_plain, plain};
use crate::parameters::{parameters, parameters_beside};
use crate::product::Product;
use order_code::{Option1, OrderCode};
use std::sync::Arc;

/// Returns the product of a code without options, with the data of the code or of the one with the encoder at the
/// output; `None` if it is not among [`actuators`].
pub(crate) fn alone(code: &OrderCode, output_encoder: bool) -> Option<Product> {
    let with = with_encoder(*code, output_encoder).filter(|_| is_plain(code))?;
    Some(Product::of_code(*code, parameters(&with)?))
}

/// Returns a code with the encoder at the output or without; `None` if its series does not have it.
fn with_encoder(code: OrderCode, output_encoder: bool) -> Option<OrderCode> {
    let option_1 = Option1::all(code.series()).next().filter(|_| output_encoder);
    (option_1.is_some() == output_encoder).then_some(OrderCode { option_1, ..code })
}

/// Lists the products by their code without the option, with the data including it. Neighbours with equal drivetrains
/// share one.
pub(crate) fn actuators(output_encoder: bool) -> Vec<Product> {
    let mut actuators: Vec<Product> = Vec::new();
    for code in plain() {
        let Some(code_with) = with_encoder(code, output_encoder) else { continue };
        let other = actuators.last().and_then(|last| Some((last.id.order_code()?, &last.parameters)));
        let Some(mut parameters) = parameters_beside(&code_with, other) else { continue };
        if let Some((_, before)) = other
            && before.drivetrain == parameters.drivetrain
        {
            parameters.drivetrain = Arc::clone(&before.drivetrain);
        }
        actuators.push(Product::of_code(code, parameters));
    }
    actuators
}
