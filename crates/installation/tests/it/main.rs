//! Tests of the crate from outside, in one program: each file is linked once for all.

mod commission;
mod facts;
mod reference_iso286;
mod whole_code_space;
