//! Combination of ordering code and catalogue: the parameters of an actuator, or the rules that the code breaks.
//!
//! The rules are read from tables 11.2, 11.3 and 12.1 of the manual at first use; none is repeated in code.

mod actuators;
mod cells;
mod codes;
mod family;
mod matrix;
mod nearest;
mod parameters;
mod parts;
mod requirements;
mod rules;

pub use actuators::{actuator, actuators, catalogue_actuators};
pub use codes::{Choice, all, broken_by_all, choices, complete, tokens_of_size};
pub use family::{battery, brake_times, own_actuator, ptc_cell};
pub use nearest::{nearest, nearest_to};
pub use parameters::{parameters, published_curve_points};
pub use requirements::{Requirements, Unmet};
pub use rules::{Availability, BrokenRule, Rule, Uncovered, availability, uncovered};
