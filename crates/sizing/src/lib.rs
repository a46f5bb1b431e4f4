//! Demand of an axis, its comparison with an actuator, and the ranking of many actuators.
//!
//! [`Axis`] holds the load and the cycle with all that does not depend on the actuator, so that judging one more
//! candidate costs a few arithmetic operations per ramp. [`judge`] answers every check for one set of parameters;
//! [`Judge`] judges many and computes answers shared by adjacent ones once; [`rank`] orders the judgements.

mod axis;
mod bearing_checks;
mod bearing_workings;
mod brake_checks;
mod brake_times;
mod check;
mod checks;
mod comparison;
mod course;
mod currents;
mod demand;
mod drive_checks;
mod electric_checks;
mod electrics;
mod energy;
mod environment_checks;
mod feedback_checks;
mod flange;
mod gear_checks;
mod heat_checks;
mod joint_checks;
mod judge;
mod list;
mod notes;
mod observer;
mod operation;
mod rank;
mod requirements;
mod reserve;
mod resonance;
#[cfg(test)]
mod reversal_tests;
mod rope_checks;
mod run_checks;
mod screen;
mod stage;
mod supply;
mod swings;
mod workings;

pub use axis::{Axis, BearingDuty, Moments, OperatingCondition, TooManyInstants};
pub use bearing_checks::largest_loads;
pub use brake_times::BrakeTimes;
pub use check::{Amount, Check, CheckId, Checks, Direction, Fit, InOrder, Margin, Part, Verdict};
pub use course::{Course, Sample};
pub use demand::{Demand, ManualDemand, MoveTorques, Moves};
pub use derivation;
pub use flange::{DerivedLoads, FlangeSample};
pub use judge::{Depth, Judge, Judgement, Naming, Proviso, Scope, governing, judge};
pub use list::Shaft;
pub use notes::{BrakeStop, Budget, Note, Notes, ResonanceSpeeds, RopeSlack};
pub use observer::{StepObserver, Unobserved, finished};
pub use operation::{DutyType, MotorSide, Operation, SegmentLoad};
pub use rank::{RankKey, Standing, rank};
pub use requirements::{AxisRequirements, MountingPosition, SpecialApplication};
pub use reserve::{AxisChange, Reach, Reserve, SAMPLES_ANEW, Unsought, nearest_change, reserve, reserve_watched};
pub use run_checks::{RUN_TOLERANCE, RunCase, RunCheck, RunCheckId};
pub use screen::{Entrant, Found, Ranked, Screen, Screening};
pub use supply::{MainsPhases, Supply, SupplyFrom};
pub use trace::{INSTANTS_MOST, Surveys};
