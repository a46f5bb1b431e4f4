//! The actuators of the catalogue available without request, with their parameters.

use crate::codes::{is_plain, plain};
use crate::parameters::{parameters, parameters_beside};
use actuator::Parameters;
use order_code::{Option1, OrderCode};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// The actuators without and with the encoder at the output, created on first use.
static LISTS: [OnceLock<Vec<(OrderCode, Parameters)>>; 2] = [const { OnceLock::new() }; 2];

fn list(output_encoder: bool) -> &'static OnceLock<Vec<(OrderCode, Parameters)>> {
    let [without, with] = &LISTS;
    if output_encoder { with } else { without }
}

/// Returns the actuators without options, or those with the encoder at the output: the code without the option, the
/// parameters with it.
#[must_use]
pub fn actuators(output_encoder: bool) -> &'static [(OrderCode, Parameters)] {
    list(output_encoder).get_or_init(|| actuators_with(output_encoder))
}

/// Returns all actuators of the catalogue with data in the manual that are available without request, with their
/// parameters: each size, ratio, winding, feedback and brake, without options.
#[must_use]
pub fn catalogue_actuators() -> &'static [(OrderCode, Parameters)] {
    actuators(false)
}

/// Returns the parameters of one of [`actuators`] by its code without options. As long as the list is not used, only this
/// actuator is looked up: the list costs a hundred times as much.
#[must_use]
pub fn actuator(code: &OrderCode, output_encoder: bool) -> Option<&'static Parameters> {
    /// Actuators looked up alone, which stay for the whole run as the list does.
    static ALONE: Mutex<Vec<(OrderCode, bool, &'static Parameters)>> = Mutex::new(Vec::new());
    if let Some(all) = list(output_encoder).get() {
        return all.iter().find(|(known, _)| known == code).map(|(_, parameters)| parameters);
    }
    // Entries are only added, so the list is consistent even if another thread panicked.
    let mut alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let is_it = |(known, with, _): &&(OrderCode, bool, &'static Parameters)| (known, *with) == (code, output_encoder);
    if let Some((.., parameters)) = alone.iter().find(is_it) {
        return Some(parameters);
    }
    let found = parameters(&with_encoder(*code, output_encoder).filter(|_| is_plain(code))?)?;
    let found: &'static Parameters = Box::leak(Box::new(found));
    alone.push((*code, output_encoder, found));
    Some(found)
}

/// Returns a code with the encoder at the output or without; `None` if its series does not have it.
fn with_encoder(code: OrderCode, output_encoder: bool) -> Option<OrderCode> {
    let option_1 = Option1::all(code.series()).next().filter(|_| output_encoder);
    (option_1.is_some() == output_encoder).then_some(OrderCode { option_1, ..code })
}

/// Lists the actuators by their code without the option, with the parameters including it. Neighbours with equal
/// drivetrains share one.
fn actuators_with(output_encoder: bool) -> Vec<(OrderCode, Parameters)> {
    let mut actuators: Vec<(OrderCode, Parameters)> = Vec::new();
    for code in plain() {
        let Some(code_with) = with_encoder(code, output_encoder) else { continue };
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

    /// An actuator that is looked up alone is that of the list, and one that is not in the list is not found.
    #[test]
    fn an_actuator_alone_is_that_of_the_list() {
        for output_encoder in [false, true] {
            let codes: Vec<OrderCode> = crate::all().iter().map(|(code, _)| *code).step_by(7).chain(plain()).collect();
            let alone: Vec<_> = codes.iter().map(|code| actuator(code, output_encoder)).collect();
            for (code, alone) in codes.iter().zip(alone) {
                let listed = actuators(output_encoder).iter().find(|(known, _)| known == code);
                assert!(alone == listed.map(|(_, parameters)| parameters), "{code}");
                assert!(alone == actuator(code, output_encoder), "{code}");
            }
        }
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
