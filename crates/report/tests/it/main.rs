//! Tests of the crate from outside, in one program: each file is linked once for all.

mod another_series;
mod checklist;
mod laden;
mod named;
mod pages;
mod products;
mod readers;
mod report;
mod samples;
