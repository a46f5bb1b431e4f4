//! Purposes of the keys of the project file; `words` has the texts.

use crate::bodies::BodyName;
use crate::curves::CurveName;
use crate::flange::{BearingName, FlangeLoadsName};
use crate::measured::MeasuredKey;
use crate::mechanism::names::{
    CounterweightName, FrictionName, GuideName, LoadName, LossesName, MechanismName, MechanismsName, ProcessForceName,
    SlideName, StartAngleName,
};
use crate::motion::SegmentName;
use crate::own::{
    ActuatorEntryName, ActuatorName, ActuatorValueName, CatalogueFileName, CatalogueHeadName, CatalogueName,
};
use crate::recorded::{ColumnsName, RatiosName, UnitsName};
use crate::requirements::{DriveName, RequirementsName};
use crate::root::{AxisName, OneOfSeveralName, PartsName, RootName};
use crate::stage::StageName;
use crate::twin::{ReplacedName, TwinName};

/// A key by its section, as the identifier of its explanation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// Key at the root.
    Root(RootName),
    /// Key of `[axis]`.
    Axis(AxisName),
    /// Key of one of several `[[axis]]`.
    OneOfSeveral(OneOfSeveralName),
    /// A table of an axis.
    Parts(PartsName),
    /// Key of `[load]`.
    Load(LoadName),
    /// A table of `[mechanism]`.
    Mechanisms(MechanismsName),
    /// Key of one mechanism.
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
    /// Position at which the motion begins.
    StartAngle(StartAngleName),
    /// Key of a solid body.
    Body(BodyName),
    /// Key of `[stage]`.
    Stage(StageName),
    /// Key of a segment of `[[motion]]`.
    Segment(SegmentName),
    /// Key of the columns of a recording.
    Columns(ColumnsName),
    /// Key of the units of a recording.
    Units(UnitsName),
    /// Key of the ratios of a recording.
    Ratios(RatiosName),
    /// A load on the flange.
    FlangeLoads(FlangeLoadsName),
    /// Key of `[bearing]`.
    Bearing(BearingName),
    /// Key of `[requirements]`.
    Requirements(RequirementsName),
    /// Key of `[drive]`.
    Drive(DriveName),
    /// Key of `[actuator]`.
    Actuator(ActuatorName),
    /// Datum of an actuator.
    ActuatorValue(ActuatorValueName),
    /// Key of `[catalogue]` of a project.
    Catalogue(CatalogueName),
    /// A table of a catalogue file.
    CatalogueFile(CatalogueFileName),
    /// Key of `[catalogue]` of a catalogue file.
    CatalogueHead(CatalogueHeadName),
    /// Key of `[[actuator]]` of a catalogue file.
    ActuatorEntry(ActuatorEntryName),
    /// Key of `[twin]`.
    Twin(TwinName),
    /// Key of `[twin.measured]`.
    Replaced(ReplacedName),
    /// Key of `[[curve]]`.
    Curve(CurveName),
    /// Key of a record of measured values.
    Measured(MeasuredKey),
}
