//! Tests of the crate from outside, in one program: each file is linked once for all.

mod codes;
mod faults;
mod whole_code_space;
