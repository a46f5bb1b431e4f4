//! Axes built from the sections of a project file: load, motion, requirements, own actuator, and the defaults that the file
//! leaves open.
//!
//! `project` reads keys, units and places; this crate makes of an axis as stated what the engine takes. The caller provides
//! the files that a project refers to ([`Files`]), the catalogue ([`Catalogue`]), and the choice among several ratios of a
//! stage ([`Choose`]), since that needs a judgement of the catalogue.

mod along;
mod assumed;
mod assumption;
mod axis_project;
mod bodies;
mod cam;
mod catalogue;
mod catalogue_csv;
mod catalogue_files;
mod choices;
mod computed;
mod curves;
mod draft;
mod drawn;
mod driven;
mod fault;
mod files;
mod flange;
mod gearing;
mod ids;
mod kept;
mod law_sample;
mod layout;
mod measured;
mod mechanism;
mod motion;
mod needs;
#[cfg(test)]
mod one_fault_tests;
mod order;
mod own;
mod plausibility;
mod recorded;
mod recording_name;
mod recordings;
mod requirements;
mod roles;
mod segment_load;
mod side;
mod source;
mod sourced;
mod stage;
mod tolerance;
mod twin;
mod varied;
mod web;

pub use assumed::AssumedKeys;
pub use assumption::{Assumption, Overrun, TemplateFigure, WindowEnd};
pub use axis_project::{AxisProject, Choose};
pub use bodies::{BodyAnswer, InertiaAnswer, inertia};
pub use catalogue::{Catalogue, NoCatalogue};
pub use catalogue_files::{FileCatalogue, product_names, read_products};
pub use drawn::drawn_figures;
pub use fault::{AxisDiagnostic, AxisFault, CycleFault};
pub use files::{Files, Grant, NoFiles, Reach};
pub use gearing::Gearing;
pub use kept::KeptRecordings;
pub use law_sample::law_sample;
pub use measured::{measurand, measured};
pub use plausibility::{
    CatalogueCheck, ComparedFigure, PLAUSIBILITY_RULES, PlausibilityFinding, PlausibilityRule, PlausibilityRuleId,
    SERIES_KEYS, SIZE_KEYS, SeriesKey, UnitProposal, check_catalogue,
};
pub use recording_name::{RECORDINGS, is_recording_name, is_referable_name};
pub use recordings::{RecordingRead, is_parquet, read_recording};
pub use roles::Within;
pub use segment_load::SegmentLoadKey;
pub use stage::RatioAnswer;
pub use tolerance::{ALL_CORNERS_MOST, sign};
pub use twin::TwinInput;
pub use varied::{Variant, Varied};
