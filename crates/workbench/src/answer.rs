//! What the use cases found, as the records of `answers`, with their texts in the language asked for.

mod beside;
mod chapters;
mod check;
mod dossier;
mod fault;
mod judged;
mod motion;

pub use beside::{comparison, difference};
pub use chapters::{battery, bearings, curves, inertia, torsion};
pub use check::{check, explained, explanations};
pub use dossier::dossier;
pub use fault::faults;
pub use judged::{candidate, fit, judgement, objections, reserve, sizing, tolerance};
pub use motion::motion;
