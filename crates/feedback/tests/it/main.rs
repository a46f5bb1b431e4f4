//! Tests of the crate from outside, in one program: each file is linked once for all.

mod endat_vectors;
mod other_hands;
mod traces;
