//! Tests of the crate from outside, in one program: each file is linked once for all.

mod faults;
mod prefixes;
mod proposals;
mod reference_factors;
mod reference_gnu_units;
mod spellings;
