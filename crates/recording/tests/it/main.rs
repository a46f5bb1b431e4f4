//! Tests of the crate from outside, in one program: each file is linked once for all.

mod blank;
mod csv;
mod dialects;
mod durations;
mod hostile;
mod incomplete;
mod loggers;
mod marked;
mod notations;
mod order;
mod parquet;
mod properties;
mod table;
