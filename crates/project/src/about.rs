//! What the keys of the project file are for; `words` has the texts.

use crate::bodies::BodyName;
use crate::curves::CurveName;
use crate::flange::{BearingName, FlangeLoadsName};
use crate::measured::MeasuredKey;
use crate::mechanism::names::{
    CounterweightName, FrictionName, GuideName, LoadName, LossesName, MechanismName, MechanismsName, ProcessForceName,
    SlideName, StartAngleName,
};
use crate::motion::SegmentName;
use crate::own::ActuatorName;
use crate::recorded::{ColumnsName, UnitsName};
use crate::requirements::{DriveName, RequirementsName};
use crate::root::{AxisName, OneOfSeveralName, PartsName, RootName};
use crate::stage::StageName;
use crate::twin::{ReplacedName, TwinName};

/// A key by its section, for what it is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// At the root.
    Root(RootName),
    /// Of `[axis]`.
    Axis(AxisName),
    /// Of one of several `[[axis]]`.
    OneOfSeveral(OneOfSeveralName),
    /// A table of an axis.
    Parts(PartsName),
    /// Of `[load]`.
    Load(LoadName),
    /// A table of `[mechanism]`.
    Mechanisms(MechanismsName),
    /// Of one mechanism.
    Mechanism(MechanismName),
    /// Friction at the output.
    Friction(FrictionName),
    /// Efficiencies.
    Losses(LossesName),
    /// A mass on a line.
    Slide(SlideName),
    /// A counterweight.
    Counterweight(CounterweightName),
    /// Friction along a line.
    Guide(GuideName),
    /// A force along a line.
    ProcessForce(ProcessForceName),
    /// Where the motion begins.
    StartAngle(StartAngleName),
    /// Of a solid body.
    Body(BodyName),
    /// Of `[stage]`.
    Stage(StageName),
    /// Of a segment of `[[motion]]`.
    Segment(SegmentName),
    /// Of the columns of a recording.
    Columns(ColumnsName),
    /// Of the units of a recording.
    Units(UnitsName),
    /// A load on the flange.
    FlangeLoads(FlangeLoadsName),
    /// Of `[bearing]`.
    Bearing(BearingName),
    /// Of `[requirements]`.
    Requirements(RequirementsName),
    /// Of `[drive]`.
    Drive(DriveName),
    /// Of `[actuator]`.
    Actuator(ActuatorName),
    /// Of `[twin]`.
    Twin(TwinName),
    /// Of `[twin.measured]`.
    Replaced(ReplacedName),
    /// Of `[[curve]]`.
    Curve(CurveName),
    /// Of a record of measured values.
    Measured(MeasuredKey),
}
