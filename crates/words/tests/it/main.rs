//! Tests of the crate from outside, in one program: each file is linked once for all.

mod axes_of_recordings;
mod catalogue_files;
mod commissioned;
mod complete;
mod glossary_page;
mod marks;
mod project_page;
mod quantities;
mod texts;
