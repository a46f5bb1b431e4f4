//! Numerical methods: comparison with a limit, zeros of a function, borders of a region, largest values of a curve,
//! selection in order, quadrature, linear equations, pseudorandom numbers.
//!
//! One function per task: [`at_most`] and [`at_least`] compare with a limit, [`root`] finds a zero, [`root_by_slope`]
//! uses the slope, [`roots`] finds the zeros in a span, [`border`] the edge of a region whose function is expensive or
//! jumps, [`highest`] the largest value of a smooth curve, [`First`] the first of equally high places; [`nth_smallest`]
//! selects from a sequence; [`lobatto`] integrates, [`Symmetric`] solves linear
//! equations, [`Random`] generates pseudorandom numbers. The crate knows no quantity and no unit.

mod border;
mod first;
mod highest;
mod limit;
mod lobatto;
mod ordered;
mod random;
mod root;
mod symmetric;

pub use border::border;
pub use first::{EQUAL, First};
pub use highest::{highest, vertex};
pub use limit::{AT_THE_LIMIT, at_least, at_most};
pub use lobatto::{legendre, lobatto};
pub use ordered::{nth_smallest, quantile, upper_median};
pub use random::Random;
pub use root::{root, root_by_slope, root_steps, roots, roots_between};
pub use symmetric::Symmetric;
