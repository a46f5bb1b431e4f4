//! What may be combined: ordering code × catalogue → actuator, or the rules broken.
//!
//! The rules are read from the manual's tables 11.2, 11.3 and 12.1 at first use; none is written a second time in code.

mod codes;
mod family;
mod matrix;
mod parameters;
mod parts;
mod requirements;
mod rules;

pub use codes::{Choice, all, choices, complete, nearest};
pub use family::{Assumed, assumed, battery, brake_times};
pub use parameters::{parameters, published_curve_points};
pub use requirements::{Requirements, Unmet};
pub use rules::{Availability, BrokenRule, Rule, availability};
