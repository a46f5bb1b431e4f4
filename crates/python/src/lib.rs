//! antrieb for Python: the questions of the list as functions, sweeps over Arrow tables, and the command line in one wheel.
//!
//! [`QuestionCall`] is a call without any Python in it; the module that Python loads is behind the feature `extension`, which
//! `cargo xtask ci python` and `maturin` set. The functions, their types and their documentation in `python/antrieb`
//! are generated from the list and from the schema of the answers by `tests/generated.rs`.

mod ask;
mod edited;
mod held;
mod labels;
#[cfg(feature = "extension")]
mod module;
mod pool;
mod sweep;
mod values;

pub use ask::{CallOutcome, CallSource, QuestionCall, SourceText};
pub use edited::{TextChange, edited};
pub use held::{HeldFiles, Recordings};
pub use labels::labels;
pub use pool::{ForkedAtWork, forked, leave, settle, within};
pub use sweep::{SweepCall, checked};
pub use values::{ValueFault, value_faults};
