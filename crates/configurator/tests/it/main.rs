//! Tests of the crate from outside, in one program: each file is linked once for all.

mod audit;
mod reference_continuous_curve;
mod reference_sister_series;
mod reference_voltage;
mod whole_code_space;
