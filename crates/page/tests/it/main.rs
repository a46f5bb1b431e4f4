//! Tests of the crate from outside, in one program: each file is linked once for all.

mod axes;
mod begin;
mod cards;
mod cost;
mod faults;
mod folder;
mod incoming;
mod kept;
mod moving;
mod page;
mod parts;
mod readers;
mod run_part;
mod shell;
mod tools;
mod visible;
