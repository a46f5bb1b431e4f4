//! Numerical methods: comparison with a limit, zeros of a function, borders of a region, largest values of a curve, quadrature, linear equations,
//! numbers that look random.
//!
//! One function for one question: [`at_most`] and [`at_least`] whether a limit is kept, [`root`] where a function passes zero, [`root_by_slope`] if its slope is known,
//! [`roots`] for all of them in a span, [`border`] for the edge of a region whose function is expensive or jumps,
//! [`highest`] for the largest value of a smooth curve, [`lobatto`] for integrals, [`Symmetric`] for linear equations, [`Random`] for numbers
//! that look random. The crate knows no quantity and no unit.

mod border;
mod highest;
mod limit;
mod lobatto;
mod random;
mod root;
mod symmetric;

pub use border::border;
pub use highest::{highest, vertex};
pub use limit::{AT_THE_LIMIT, at_least, at_most};
pub use lobatto::{legendre, lobatto};
pub use random::Random;
pub use root::{root, root_by_slope, root_steps, roots, roots_between};
pub use symmetric::Symmetric;
