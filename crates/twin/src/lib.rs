//! Digital twin: an actuator with its drive and its load, simulated over time.
//!
//! [`Setup`] describes the simulation, [`Twin`] is the run; plant (motor, gear, load), control, drive with its
//! supervision, and a solver of fixed step are separate. The formulas of an instant are those of `actuator`, the load
//! is the mechanism of the project, the setpoints are its motion. All quantities refer to the output unless a name
//! includes `motor`. Equal setups yield equal bits.

mod averaged;
mod bode;
mod control;
mod control_loop;
mod drive;
mod gear;
mod identify;
mod link;
mod load;
mod machine;
mod parameters;
mod plant;
mod scenario;
mod setpoint;
mod setup;
mod step;
mod summary;
mod twin;
mod warm;

pub use averaged::{Averaged, Operation, POINTS_OF_A_PERIOD, PeriodCourse, PeriodPoint, averaged};
pub use bode::{LoopResponse, Margins, Response};
pub use control::{CURRENT_RATE_HZ, Demand, Gains, POSITION_EVERY};
pub use control_loop::Loop;
pub use drive::Limits;
pub use identify::{
    Column, Delay, Doubt, Estimate, HeldColumn, Identification, Identified, IdentifyFault, Misread, Observed, Open,
    Scatter, Stated, Zero, identify, identify_while,
};
pub use parameters::{MeasuredLoad, Model, Parameter, Parameters};
pub use plant::Energies;
pub use scenario::{Event, EventKind, Failed, Part, Reaction, Scenario, ScenarioId};
pub use setup::{Fault, SUBSTEPS_USUAL, Setup, Supply, Switches};
pub use summary::Summary;
pub use twin::{
    EndOverrun, EventEffect, INSTANTS_MOST, MotionDirection, Reading, Sample, Twin, WorstInstant, WorstOf,
    search_periods, worst_instant,
};
pub use warm::settled;
