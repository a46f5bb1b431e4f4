//! Motion required of the output shaft: motion laws, their pieces, and the chain of a cycle.
//!
//! All quantities refer to the output of the actuator. A [`Motion`] is a chain of [`Piece`]s whose acceleration is a
//! cubic polynomial of time plus one harmonic, so that position, speed and acceleration are closed forms at every
//! instant. A [`Recorded`] segment consists of samples instead.

mod chain;
mod examination;
mod faults;
#[cfg(test)]
mod generated;
mod grid;
mod held;
mod instant;
mod joint;
mod law;
mod outliers;
mod piece;
mod placed;
mod points;
mod quality;
mod recorded;
mod remarks;
mod resolution;
mod samples;
mod settled;
mod seven_phase;
mod smoothing;
mod solve;
mod sparse;
mod standstill;
mod stretch;
mod threshold;
mod timing;
mod web;
mod white;

pub use chain::{Closing, Hold, ManualMove, Motion, SegmentSpec, Stretch, Unread};
pub use examination::{EvenRows, HeldSignal, Stamps};
pub use faults::{MotionFault, MoveFault, Needed, RecordedFault};
pub use law::{Given, Law, Solved};
pub use outliers::{Outliers, OutlyingColumn, OutlyingValues, SignalKind, jumps};
pub use piece::{Piece, Runs, State};
pub use placed::{Interval, Placed};
pub use points::{EndState, Ends, Points, PointsFault, Spline};
pub use quality::ColumnQuality;
pub use recorded::Recorded;
pub use remarks::Remark;
pub use resolution::{MadeUp, Spurious, SteppedColumn};
pub use samples::{HeldValues, Samples, TimeStamps, Treatment};
pub use settled::SlowMotion;
pub use sparse::SparseSamples;
pub use standstill::{Alternating, RestNoise};
pub use web::{Web, WebFault};
