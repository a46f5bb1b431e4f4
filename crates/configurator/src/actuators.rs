//! The actuators of the catalogue available without request, with their parameters.

use crate::codes::plain;
use crate::parameters::parameters_beside;
use actuator::Parameters;
use order_code::{Option1, OrderCode};
use std::sync::{Arc, LazyLock};

/// Returns the actuators without options, or those with the encoder at the output: the code without the option, the
/// parameters with it.
#[must_use]
pub fn actuators(output_encoder: bool) -> &'static [(OrderCode, Parameters)] {
    static WITH_OUTPUT_ENCODER: LazyLock<Vec<(OrderCode, Parameters)>> = LazyLock::new(|| actuators_with(true));
    if output_encoder { &WITH_OUTPUT_ENCODER } else { catalogue_actuators() }
}

/// Returns all actuators of the catalogue with data in the manual that are available without request, with their
/// parameters: each size, ratio, winding, feedback and brake, without options.
#[must_use]
pub fn catalogue_actuators() -> &'static [(OrderCode, Parameters)] {
    static ACTUATORS: LazyLock<Vec<(OrderCode, Parameters)>> = LazyLock::new(|| actuators_with(false));
    &ACTUATORS
}

/// Lists the actuators by their code without the option, with the parameters including it. Neighbours with equal
/// drivetrains share one.
fn actuators_with(output_encoder: bool) -> Vec<(OrderCode, Parameters)> {
    let mut actuators: Vec<(OrderCode, Parameters)> = Vec::new();
    for code in plain() {
        let option_1 = Option1::all(code.series()).next().filter(|_| output_encoder);
        if option_1.is_some() != output_encoder {
            continue;
        }
        let code_with = OrderCode { option_1, ..code };
        let Some(mut parameters) = parameters_beside(&code_with, actuators.last()) else { continue };
        if let Some((_, before)) = actuators.last()
            && before.drivetrain == parameters.drivetrain
        {
            parameters.drivetrain = Arc::clone(&before.drivetrain);
        }
        actuators.push((code, parameters));
    }
    actuators
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameters;

    /// The list has the parameters that [`parameters`] returns for each code. Actuators that share a drivetrain have
    /// the same size and ratio; one whose drivetrain differs in a single value, as it may with the feedback, has its
    /// own.
    #[test]
    fn neighbours_share_their_drivetrain_and_nothing_else() {
        let mut drivetrains = 0;
        let mut before: Option<&(OrderCode, Parameters)> = None;
        for here in catalogue_actuators() {
            let (code, own) = here;
            assert_eq!(parameters(code).as_ref(), Some(own), "{code}");
            let shares = before.is_some_and(|(_, other)| Arc::ptr_eq(&other.drivetrain, &own.drivetrain));
            let equal = before.is_some_and(|(_, other)| *other.drivetrain == *own.drivetrain);
            let of_one_gear = before.is_some_and(|(other, _)| (other.size, other.ratio) == (code.size, code.ratio));
            assert_eq!((shares, shares && of_one_gear), (equal, shares), "{code}");
            drivetrains += usize::from(!shares);
            before = Some(here);
        }
        assert_eq!(drivetrains, 84);
    }

    /// Changing one datum gives the actuator a drivetrain of its own.
    #[test]
    fn a_datum_that_is_written_changes_no_neighbour() {
        let mut pairs = catalogue_actuators().windows(2);
        let shared = pairs.find_map(|pair| match pair {
            [(_, a), (_, b)] if Arc::ptr_eq(&a.drivetrain, &b.drivetrain) => Some((a.clone(), b)),
            _ => None,
        });
        let (mut own, other) = shared.expect("neighbours that share");
        own.torque_max = provenance::Datum::NotPrinted;
        assert!(other.torque_max.known().is_some() && !Arc::ptr_eq(&own.drivetrain, &other.drivetrain));
    }
}
