//! The project file as typed data: read against one description, every fault with its place.
//!
//! It holds the statements of the user, independent of language: a [`Fault`] is an identifier with its arguments, and
//! so is a [`Hint`]. The caller provides the files that a project refers to ([`Files`]), and the choice among several
//! ratios of a stage ([`Choose`]), since that needs a judgement of the catalogue.

mod about;
mod axis_names;
mod bodies;
mod cam;
mod catalogue;
mod computed;
mod curves;
mod diagnostic;
mod drawn;
mod edit;
mod fault;
mod flange;
mod gearing;
mod heading;
mod hint;
mod ids;
mod inputs;
mod key;
mod label;
mod layout;
mod measured;
mod mechanism;
mod motion;
mod nearest;
mod numbers;
mod order;
mod own;
mod read;
mod recorded;
mod recording_name;
mod recovery;
mod requirements;
mod roles;
mod root;
mod schema;
mod section;
mod segment_load;
mod side;
mod stage;
mod stated;
mod tabular;
mod tolerance;
mod twin;
mod value;
mod web;

/// Names of the keys of each section, by which their texts are found.
pub mod names {
    pub use crate::bodies::BodyName;
    pub use crate::curves::CurveName;
    pub use crate::flange::{BearingName, FlangeLoadsName};
    pub use crate::measured::{
        BrakeName, DirectionName, EmfName, MeasuredRootName, NoLoadName, SensorName, SpeedName, WindingName,
    };
    pub use crate::mechanism::names::*;
    pub use crate::motion::SegmentName;
    pub use crate::own::ActuatorName;
    pub use crate::recorded::{ColumnsName, RatiosName, UnitsName};
    pub use crate::requirements::{DriveName, RequirementsName};
    pub use crate::root::{AxisName, OneOfSeveralName, PartsName, RootName};
    pub use crate::stage::StageName;
    pub use crate::twin::{ReplacedName, TwinName};
}

pub use about::About;
pub use bodies::{BODY_SHAPES, BodyAnswer, BodyKind, BodyShape, InertiaAnswer, inertia};
pub use catalogue::{Catalogue, NoCatalogue};
pub use computed::Overrun;
pub use diagnostic::{Diagnostic, place};
pub use drawn::drawn_figures;
pub use edit::{Edit, EditFault, Written, edit, edit_measured, key_at, measured_key_at, stretch, written};
pub use fault::{Expected, Fault, FileTrouble, Range, Unopened};
pub use gearing::Gearing;
pub use heading::{Counted, Heading, Objection, nearest_heading};
pub use hint::Hint;
pub use inputs::{Input, InputChange, input_changes, inputs};
pub use key::{ColumnDimensions, Key, Kind, Variants, example};
pub use label::input_label;
pub use measured::{MEASURED_FORMAT, MEASURED_KEYS, MeasuredKey, MeasuredLine, measured, measured_lines};
pub use motion::SegmentLaw;
pub use recorded::{Files, Grant, NoFiles, Reach, RecordingRead};
pub use recording_name::{RECORDINGS, is_recording_name};
pub use roles::Within;
pub use root::KEYS;
pub use schema::{SchemaText, schema};
pub use segment_load::SegmentLoadKey;
pub use stage::RatioAnswer;
pub use tabular::TabularFault;
pub use tolerance::{ALL_CORNERS_MOST, Tolerance, Variant, Varied, sign};
pub use twin::TwinInput;

use ::mechanism::{Extra, Mechanism};
use ::motion::{Alternating, MadeUp, Motion, Remark, RestNoise, Spline, Spurious, SteppedColumn};
use bodies::summed;
use configurator::{Product, Requirements};
use order_code::{Option1, Option2};
use read::Reader;
use recorded::Recordings;
use requirements::RequirementsSection;
use root::{AxisSection, Root};
use section::{Fields, Section};
use sizing::{Axis, BearingDuty, BrakeTimes};
use stated::StatedField;
use std::sync::Arc;
use value::OneOrMany;

/// Largest project file that is read, in bytes.
pub const PROJECT_MAX_BYTES: usize = 1 << 20;

/// A default that the user did not confirm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Assumption {
    /// No friction torque is given: zero is assumed.
    NoFriction,
    /// No ambient temperature is given: the values of the manual hold up to 40 °C.
    AmbientWithinRange,
    /// Not all conditions of use are stated: those that are missing are within the manufacturer's.
    ConditionsWithinRange,
    /// The plate of table 13.3 cools the actuator.
    CoolingPlate,
    /// A DC link voltage is given without a modulation reserve.
    ModulationReserve,
    /// No DC link voltage is given: the terminal voltage is not checked.
    NoSupply,
    /// The DC link is that of a three-phase rectifier without control.
    Rectifier,
    /// The DC link is that of an uncontrolled three-phase rectifier, and the mains voltage varies by 10 %.
    RectifierAndDeviation,
    /// The DC link is that of a single-phase rectifier without control.
    SinglePhaseRectifier,
    /// The DC link is that of an uncontrolled single-phase rectifier, and the mains voltage varies by 10 %.
    SinglePhaseRectifierAndDeviation,
    /// I_0 of the user's actuator is taken to include the no-load starting current.
    OwnStallCurrentIncludesFriction,
    /// T_0 of the user's actuator is above its T_max: a limit of the motor alone.
    OwnStallTorqueAboveLargest,
    /// I_0 of the user's actuator is above its I_max: a limit of the motor alone.
    OwnStallCurrentAboveLargest,
    /// n_N of the user's actuator is above its n_mot,max: a limit of the motor alone.
    OwnRatedSpeedAboveLargest,
    /// No loads on the flange are given: the output bearing is not judged.
    NoFlangeLoads,
    /// The loads on the flange are constant over the cycle.
    FlangeLoadsConstant,
    /// The moments of radial and axial force point in the same direction.
    FlangeMomentsAligned,
    /// The loads on the flange follow from the mechanism.
    FlangeLoadsOfMechanism,
    /// Stated loads add to them at their worst.
    FlangeLoadsAddUp,
    /// The loads of the mechanism on the flange are ignored, as stated in the file.
    FlangeLoadsIgnored,
    /// Loads on the flange of a segment replace those of the mechanism there, as stated in the file.
    FlangeLoadsReplaced,
    /// No share is given: the flange bears the loads of the mechanism alone.
    FlangeBearsAll,
    /// The bodies on the flange have no products of inertia.
    FlangeBodiesFlat,
    /// No tilt of the axis is given: the flange looks upwards.
    FlangeUpwards,
    /// A payload given by its inertia loads the flange with no weight.
    PayloadInertiaWeightless,
    /// No mass of pulley, pinion or crank is given.
    WheelWeightless,
    /// No helix angle is given: spur teeth.
    SpurTeeth,
    /// With a stage the mechanism does not load the flange.
    MechanismOnOwnBearings,
    /// No efficiency of the stage is given.
    StageNoLosses,
    /// No efficiency of the stage for driving backwards is given.
    StageLossesDoNotHelp,
    /// No inertia of the stage is given.
    StageWithoutInertia,
    /// No stiffness of the stage is given.
    StageRigid,
    /// No backlash of the stage is given.
    StageNoBacklash,
    /// The best of several ratios was chosen.
    StageRatioChosen,
    /// No efficiency of the mechanism is given: one is assumed.
    NoLosses,
    /// No efficiency for driving backwards is given: the losses do not help to brake.
    LossesDoNotHelp,
    /// No inclination of a linear travel is given: horizontal.
    TravelHorizontal,
    /// No inclination of the ground link of a four-bar linkage is given: horizontal.
    GroundHorizontal,
    /// No tilt of the axis of rotation is given: vertical.
    AxisVertical,
    /// No inertia of the rotating parts of a mechanism is given: zero.
    PartsWithoutInertia,
    /// No mass of the rope is given: zero.
    RopeWeightless,
    /// No efficiency of the rope sheaves is given: one.
    SheavesNoLosses,
    /// No mass of the arms of a scissor lift is given: zero.
    ArmsWeightless,
    /// No mass of the coupler of a four-bar linkage is given: zero.
    CouplerWeightless,
    /// No mass of the rocker of a four-bar linkage is given: zero.
    RockerWeightless,
    /// A trapezoid given by two quantities accelerates, runs and brakes for a third of the time each.
    TrapezoidThirds,
    /// A single move is judged as if it were repeated without a pause.
    SingleMoveRepeats,
    /// No special field of application is stated.
    OrdinaryApplication,
    /// A quantity with a tolerance is uniform within its band and independent of the others.
    UniformTolerances,
    /// The motor carries the load in a dwell without `hold`.
    MotorHolds,
    /// A dwell behind a move with a payload states none: nothing is carried in it.
    NoPayloadInDwell,
    /// The payload of a turntable lies in the direction of the common centre of mass of the bodies.
    PayloadTowardsCentre,
    /// The recorded torque is a process torque, added to the torque of the mechanism.
    RecordedTorqueAdds,
    /// The recorded rotary quantities are those at the output.
    RecordedAtOutput,
    /// The recorded shaft turns in the direction of the output.
    RecordedTurnsAlike,
    /// Inertia and friction of the recorded motor and gear are not removed from a torque recorded at the motor.
    RecordedTorqueOfMotor,
    /// Speed and acceleration are differences of a recorded position, not smoothed.
    RecordedPositionDifferentiated,
    /// The recorded position is that of a modulo axis; its jumps of one revolution are removed.
    RecordedModulo,
    /// Noise of a recorded speed at rest is treated as zero.
    RecordedRest(RestNoise),
    /// A recorded speed changes its sign from sample to sample and counts as motion.
    RecordedAlternating(Alternating),
    /// A key of a recording does not do what it is stated for.
    RecordedKey(Remark),
    /// A recording or a cam table, by its segment from 1, does not move; the largest speed [rad/s] that `standstill` hides.
    Motionless(usize, f64),
    /// The distance of a move is shorter than its change of speed takes: the axis comes back.
    Overruns(Overrun),
    /// The resolution of a recording in value or time causes an apparent acceleration, with the torque that the load would
    /// need for it \[Nm\].
    RecordedSteps(MadeUp, f64),
    /// The motion between the points of a cam table is a spline with continuous derivatives.
    SplineThroughPoints(Spline),
}

/// Steps of a position, as an example.
const STEPS: MadeUp = MadeUp {
    column: SteppedColumn::Position,
    cause: Spurious::Steps { step: 1.7e-8, smoothing_s: Some(3.3e-3) },
    interval_s: 60e-6,
    acceleration_rad_s2: 4.8,
    motion_rad_s2: 0.31,
};

impl Assumption {
    /// Assumptions in their order, with example arguments.
    pub const ALL: [Self; 78] = [
        Self::NoFriction,
        Self::AmbientWithinRange,
        Self::ConditionsWithinRange,
        Self::CoolingPlate,
        Self::ModulationReserve,
        Self::NoSupply,
        Self::Rectifier,
        Self::RectifierAndDeviation,
        Self::SinglePhaseRectifier,
        Self::SinglePhaseRectifierAndDeviation,
        Self::OwnStallCurrentIncludesFriction,
        Self::OwnStallTorqueAboveLargest,
        Self::OwnStallCurrentAboveLargest,
        Self::OwnRatedSpeedAboveLargest,
        Self::NoFlangeLoads,
        Self::FlangeLoadsConstant,
        Self::FlangeMomentsAligned,
        Self::FlangeLoadsOfMechanism,
        Self::FlangeLoadsAddUp,
        Self::FlangeLoadsIgnored,
        Self::FlangeLoadsReplaced,
        Self::FlangeBearsAll,
        Self::FlangeBodiesFlat,
        Self::FlangeUpwards,
        Self::PayloadInertiaWeightless,
        Self::WheelWeightless,
        Self::SpurTeeth,
        Self::MechanismOnOwnBearings,
        Self::StageNoLosses,
        Self::StageLossesDoNotHelp,
        Self::StageWithoutInertia,
        Self::StageRigid,
        Self::StageNoBacklash,
        Self::StageRatioChosen,
        Self::NoLosses,
        Self::LossesDoNotHelp,
        Self::TravelHorizontal,
        Self::GroundHorizontal,
        Self::AxisVertical,
        Self::PartsWithoutInertia,
        Self::RopeWeightless,
        Self::SheavesNoLosses,
        Self::ArmsWeightless,
        Self::CouplerWeightless,
        Self::RockerWeightless,
        Self::TrapezoidThirds,
        Self::SingleMoveRepeats,
        Self::OrdinaryApplication,
        Self::UniformTolerances,
        Self::MotorHolds,
        Self::NoPayloadInDwell,
        Self::PayloadTowardsCentre,
        Self::RecordedTorqueAdds,
        Self::RecordedAtOutput,
        Self::RecordedTurnsAlike,
        Self::RecordedTorqueOfMotor,
        Self::RecordedPositionDifferentiated,
        Self::RecordedModulo,
        Self::RecordedRest(RestNoise { speed_rad_s: 1e-3, duration_s: 9.0 }),
        Self::RecordedAlternating(Alternating { share: 0.15, speed_rad_s: 0.02 }),
        Self::RecordedKey(Remark::NotHeld),
        Self::RecordedKey(Remark::EvenAlready),
        Self::RecordedKey(Remark::FollowsStamps),
        Self::RecordedKey(Remark::StandstillSteps {
            speed_rad_s: 0.1,
            acceleration_rad_s2: 180.0,
            without_rad_s2: 19.0,
        }),
        Self::Motionless(2, 0.0),
        Self::Motionless(2, 0.1),
        Self::Overruns(Overrun { segment: 3, stated_rad: 0.0884, plain_rad: 0.0885, travel_m_per_rad: None }),
        Self::Overruns(Overrun { segment: 3, stated_rad: 0.0884, plain_rad: 0.0885, travel_m_per_rad: Some(0.01) }),
        Self::RecordedSteps(STEPS, 0.5),
        Self::RecordedSteps(MadeUp { cause: Spurious::Steps { step: 1.7e-8, smoothing_s: None }, ..STEPS }, 0.5),
        Self::RecordedSteps(MadeUp { column: SteppedColumn::Speed, ..STEPS }, 0.5),
        Self::RecordedSteps(MadeUp { cause: Spurious::Held { period_s: 8e-3 }, ..STEPS }, 0.5),
        Self::RecordedSteps(
            MadeUp { cause: Spurious::Held { period_s: 8e-3 }, column: SteppedColumn::Speed, ..STEPS },
            0.5,
        ),
        Self::RecordedSteps(MadeUp { cause: Spurious::Updates { smoothing_s: Some(0.05) }, ..STEPS }, 0.5),
        Self::RecordedSteps(MadeUp { cause: Spurious::Updates { smoothing_s: None }, ..STEPS }, 0.5),
        Self::RecordedSteps(MadeUp { cause: Spurious::Stamps { scatter_s: 3e-4 }, ..STEPS }, 0.5),
        Self::SplineThroughPoints(Spline::Cubic),
        Self::SplineThroughPoints(Spline::Quintic),
    ];
}

/// A project: one axis with its requirements.
#[derive(Clone, Debug)]
pub struct Project {
    /// Name of the axis; empty if none is given.
    pub name: String,
    /// Load and motion.
    pub axis: Axis,
    /// Requirements on the actuator.
    pub requirements: Requirements,
    /// Required sensor option.
    pub option_1: Option<Option1>,
    /// Required cable and connector option.
    pub option_2: Option<Option2>,
    /// The user's own actuator, if there is one.
    pub actuator: Option<Product>,
    /// Result of each of several ratios of the stage; empty for one ratio or no stage.
    pub ratios: Vec<RatioAnswer>,
    /// Settings of the simulation.
    pub twin: TwinInput,
    /// Recordings that the motion consists of.
    pub recordings: Vec<RecordingRead>,
    /// Defaults that were used.
    pub assumptions: Vec<Assumption>,
    /// Quantities with a tolerance, in the order of the reader.
    pub tolerances: Vec<Tolerance>,
    catalogue: Arc<dyn Catalogue>,
    /// The axis as read: it contains the places of the values, and with tolerances it is built again with other values.
    root: AxisSection,
}

/// Chooses among the possible ratios of a stage, in the order of the file; returns the project with the chosen one. The
/// second argument builds the project with a ratio.
pub type Choose<'c> = &'c dyn Fn(&[f64], &dyn Fn(f64) -> Option<Project>) -> Option<Project>;

impl Project {
    /// Returns `true` if it is one of several axes of its file.
    #[must_use]
    pub fn is_of_several(&self) -> bool {
        !self.root.head().path.is_empty()
    }

    /// Returns the catalogue with which the axis was read, with the user's curves.
    #[must_use]
    pub fn catalogue(&self) -> &Arc<dyn Catalogue> {
        &self.catalogue
    }

    /// Returns the solid bodies that the axis turns, with their inertia; `None` for other loads.
    #[must_use]
    pub fn bodies(&self) -> Option<InertiaAnswer> {
        summed(self.root.driven()?.bodies()?)
    }

    /// Reads a project file with one axis that refers to no other file.
    ///
    /// # Errors
    /// Every fault of the file, each with its place, in the order of the file.
    pub fn read(text: &str, catalogue: &Arc<dyn Catalogue>, choose: Choose<'_>) -> Result<Self, Vec<Diagnostic>> {
        let mut axes = Self::read_all(text, &NoFiles, catalogue, choose)?;
        match (axes.pop(), axes.is_empty()) {
            (Some(only), true) => Ok(only),
            _ => Err(vec![Diagnostic::at(text, 0..0, Fault::OneAxisOnly, None)]),
        }
    }

    /// Reads a project file with one axis or several, in their order, and the files that it refers to.
    ///
    /// # Errors
    /// Every fault of the file, each with its place, in the order of the file.
    pub fn read_all(
        text: &str,
        files: &dyn Files,
        catalogue: &Arc<dyn Catalogue>,
        choose: Choose<'_>,
    ) -> Result<Vec<Self>, Vec<Diagnostic>> {
        let mut reader = Reader::of_file(text)?;
        let mut root: Root = reader.read();
        let own = curves::read(root.curve.get().map_or(&[], |all| all.0.as_slice()), catalogue, &mut reader);
        let catalogue = own.as_ref().unwrap_or(catalogue);
        let mut recordings = Recordings::new(files);
        let several = match root.axis.get_mut() {
            Some(OneOrMany::Many(several)) => std::mem::take(several),
            Some(OneOrMany::One(_)) | None => Vec::new(),
        };
        let axes: Vec<Option<Self>> = if several.is_empty() {
            let axis = AxisSection::single(root);
            vec![Self::build(axis, None, (&mut recordings, catalogue, choose), &mut reader)]
        } else {
            for field in root.parts.fields().into_iter().filter(|field| field.is_written()) {
                reader.fault(field.span(), Fault::OutsideTheAxes { key: field.name() }, None);
            }
            axis_names::named_apart(&several, &mut reader);
            let build = |(index, axis)| {
                let axis = AxisSection::of_several(axis);
                Self::build(axis, Some(index), (&mut recordings, catalogue, choose), &mut reader)
            };
            several.into_iter().enumerate().map(build).collect()
        };
        let faults = reader.into_faults();
        match axes.into_iter().collect::<Option<Vec<Self>>>() {
            Some(axes) if faults.is_empty() => Ok(axes),
            _ => Err(faults),
        }
    }

    /// Builds one axis from its section, `index` among several; `None` after a fault.
    fn build(
        mut root: AxisSection,
        index: Option<usize>,
        (recordings, catalogue, choose): (&mut Recordings<'_>, &Arc<dyn Catalogue>, Choose<'_>),
        reader: &mut Reader<'_>,
    ) -> Option<Self> {
        if let Some(segments) = root.parts.motion.get_mut() {
            recordings.resolve(&mut segments.0, reader);
        }
        let root = &root;
        let axis = prepare(root, &**catalogue, reader).map(|draft| finish(root, draft));
        let actuator = build_actuator(root, &**catalogue, reader);
        let tolerances = tolerance::of_axis(&reader.tolerances, index);
        for window in tolerances.iter().filter(|each| each.path.ends_with("].from") || each.path.ends_with("].to")) {
            reader.fault(window.span.clone(), Fault::NoTolerance, None);
        }
        if reader.fault_count() == 0 && axis.is_some() {
            tolerance::hold(root, &**catalogue, &tolerances, reader);
        }
        let required = root.parts.requirements.get();
        let axis = axis?;
        let project = Self {
            ratios: Vec::new(),
            name: root.name.clone().unwrap_or_default(),
            catalogue: Arc::clone(catalogue),
            twin: root.parts.twin.get().map(|twin| twin.input()).unwrap_or_default(),
            recordings: root.segments().iter().filter_map(|segment| segment.recording().cloned()).collect(),
            assumptions: assumptions(root, &axis, !tolerances.is_empty()),
            requirements: requirements(root),
            option_1: required.and_then(|required| required.option_1.value()),
            option_2: required.and_then(|required| required.option_2.value()),
            axis,
            actuator,
            root: root.clone(),
            tolerances,
        };
        let ratios = root.parts.stage.get().map_or(&[][..], |stage| stage.ratios());
        if ratios.is_empty() || reader.fault_count() > 0 {
            return Some(project);
        }
        let with_ratio = |ratio: f64| project.with_ratio(root, ratio);
        Some(choose(ratios, &with_ratio).unwrap_or_else(|| project.clone()))
    }

    /// Returns the project with one ratio instead of several; `None` if that axis is impossible.
    fn with_ratio(&self, root: &AxisSection, ratio: f64) -> Option<Self> {
        let mut root = root.clone();
        root.set_ratio(ratio);
        let draft = prepare(&root, &*self.catalogue, &mut Reader::new(""))?;
        let axis = finish(&root, draft);
        let assumptions = assumptions(&root, &axis, !self.tolerances.is_empty());
        Some(Self { axis, root, assumptions, ..self.clone() })
    }
}

fn assumptions(root: &AxisSection, axis: &Axis, toleranced: bool) -> Vec<Assumption> {
    let mut found = Vec::new();
    let driven = root.driven();
    if let Some(driven) = driven {
        mechanism::assumptions(driven, &mut found);
    }
    motion::assumptions(root, driven, &mut found);
    computed::assumptions(axis, &mut found);
    let absent = RequirementsSection::absent(root.head());
    let required = root.parts.requirements.get().unwrap_or(&absent);
    found.extend(required.ambient.note());
    found.extend(required.conditions_note());
    found.push(Assumption::CoolingPlate);
    if root.parts.actuator.get().is_some_and(|own| own.stall_current.is_given()) {
        found.push(Assumption::OwnStallCurrentIncludesFriction);
    }
    found.extend(order::unusual(&root.parts));
    found.extend(required.link_notes());
    if let Some(stage) = root.parts.stage.get() {
        stage.assumptions(&mut found);
    }
    flange::assumptions(root, &mut found);
    found.extend(required.special_application.note());
    found.extend(toleranced.then_some(Assumption::UniformTolerances));
    found
}

fn requirements(root: &AxisSection) -> Requirements {
    root.parts.requirements.get().map_or_else(Requirements::default, |required| required.build())
}

/// Checked parts of an axis before they are combined.
struct Draft {
    mechanism: Mechanism,
    motion: Motion,
    extras: Vec<Extra>,
    bearing: BearingDuty,
    brake_times: Option<BrakeTimes>,
}

/// Prepares an axis and reports all of its faults; [`finish`] only computes.
fn prepare(root: &AxisSection, catalogue: &dyn Catalogue, reader: &mut Reader<'_>) -> Option<Draft> {
    if !root.parts.motion.is_written() && !reader.is_damaged() {
        let hint = Hint::Example("[[motion]]".to_owned());
        let fault = Fault::MissingKey { path: root.parts.motion.name().to_owned(), list: true };
        reader.fault(root.head().start(), fault, Some(hint));
    }
    flange::stated(root, reader);
    order::check(&root.parts, reader);
    if let Some(required) = root.parts.requirements.get() {
        required.battery(catalogue, reader);
        required.check(root.driven().is_none_or(|driven| driven.travel().is_some()), reader);
    }
    let stage = root.parts.stage.get().and_then(|stage| stage.build(reader));
    let Some(load) = mechanism::load(&root.parts, reader) else {
        motion::without_load(root, reader);
        return None;
    };
    // The file states the motion of the mechanism; the following values are those of the actuator's output.
    let mechanism = Mechanism { stage, ..load.mechanism.clone() };
    let bearing = flange::duty(root, &mechanism, reader);
    let (motion, extras) = motion::motion(root, &load, reader)?;
    let motion = motion.geared(mechanism.stage_ratio());
    Some(Draft { mechanism, motion, extras, bearing, brake_times: catalogue.brake_times() })
}

/// Combines load, motion and requirements.
fn finish(root: &AxisSection, draft: Draft) -> Axis {
    let mut axis = match draft.brake_times {
        Some(times) => Axis::braked(draft.mechanism, draft.motion, draft.extras, times),
        None => Axis::new(draft.mechanism, draft.motion, draft.extras),
    };
    if let Some(required) = root.parts.requirements.get() {
        required.apply(&mut axis);
    }
    if let Some(drive) = root.parts.drive.get() {
        drive.apply(&mut axis);
    }
    axis.bearing = Some(draft.bearing);
    axis
}

fn build_actuator(root: &AxisSection, catalogue: &dyn Catalogue, reader: &mut Reader<'_>) -> Option<Product> {
    root.parts.actuator.get()?.build(catalogue.own_actuator(), reader)
}
