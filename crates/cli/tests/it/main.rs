//! Tests of the crate from outside, in one program: each file is linked once for all.

mod answers;
mod api;
mod behaviour;
mod commission;
mod doors;
mod drive;
mod ends;
mod export;
mod files;
mod german_figures;
mod hostile;
mod inputs;
mod meanings;
mod readers;
mod refusals;
mod run;
mod saving;
mod serve;
mod sigrok;
mod spoken;
mod sweep;
mod sweep_parts;
mod vary;
mod vocabulary;
mod words;
