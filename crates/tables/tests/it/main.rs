//! Tests of the crate from outside, in one program: each file is linked once for all.

mod calendar;
mod readers;
mod tables;
