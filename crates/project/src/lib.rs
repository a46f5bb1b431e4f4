//! The project file as typed data: read against one description, every fault with its place.
//!
//! It states what the user wrote and speaks no language: a [`Fault`] is an identifier with its arguments, and so is a
//! [`Hint`]. Files that a project refers to are handed in ([`Files`]), and so is the choice among several ratios of a stage
//! ([`Choose`]), since it takes a judgement of the catalogue.

mod about;
mod bodies;
mod curves;
mod diagnostic;
mod edit;
mod fault;
mod flange;
mod ids;
mod inputs;
mod label;
mod load;
mod measured;
mod numbers;
mod read;
mod recorded;
mod schema;
mod section;
mod segment;
mod spec;
mod stage;
mod stated;
mod tolerance;

pub use about::{About, MeasuredKey};
pub use bodies::{BODY_SHAPES, BodyAnswer, BodyKind, BodyShape, InertiaAnswer, inertia};
pub use curves::OwnCatalogue;
pub use diagnostic::{Diagnostic, place};
pub use edit::{Edit, EditFault, Written, edit, edit_measured, key_at, measured_key_at, stretch, written};
pub use fault::{Expected, Fault, FileTrouble, Hint, NoRegularFile, Range};
pub use inputs::{Input, InputChange, input_changes, inputs};
pub use label::input_label;
pub use measured::{MEASURED_FORMAT, MEASURED_KEYS, MeasuredLine, measured, measured_lines};
pub use read::example;
pub use recorded::{Files, Grant, NoFiles, Reach, RecordingRead};
pub use schema::{SchemaText, schema};
pub use segment::SegmentLaw;
pub use spec::{Key, Kind, ROOT as KEYS, Variants};
pub use stage::RatioAnswer;
pub use stated::Within;
pub use tolerance::{ALL_CORNERS_MOST, Tolerance, Variant, Varied, sign};

use actuator::{BatteryFault, Parameters};
use configurator::Requirements;
use mechanism::{Extra, Mechanism};
use motion::Motion;
use order_code::{Feedback, Option1, Option2};
use provenance::{Datum, Grade, Source, Sourced};
use quantities::{Measure, Time};
use read::{Reader, joined};
use recorded::Recordings;
use section::Section;
use sizing::{Asked, Axis, BearingDuty, BrakeTimes, SpecialApplication};
use std::sync::Arc;

/// Largest project file that is read, in bytes.
pub const PROJECT_MAX_BYTES: usize = 1 << 20;

/// Share of U_DC/√2 that a drive can use unless the user says otherwise: room for dead times and current control.
const MODULATION_RESERVE: f64 = 0.9;

/// A default that the user did not confirm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Assumption {
    /// No friction torque is given: zero is assumed.
    NoFriction,
    /// No ambient temperature is given: the printed figures hold up to 40 °C.
    AmbientWithinRange,
    /// The plate of table 13.3 cools the actuator.
    CoolingPlate,
    /// A DC link voltage is given without a modulation reserve.
    ModulationReserve,
    /// No DC link voltage is given: the terminal voltage is not checked.
    NoSupply,
    /// I_0 of the user's actuator is taken to include the no-load starting current.
    OwnStallCurrentIncludesFriction,
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
    /// No share is given: the flange bears the loads of the mechanism alone.
    FlangeBearsAll,
    /// What turns on the flange has no products of inertia.
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
    /// Of several ratios the best was chosen.
    StageRatioChosen,
    /// No efficiency of the mechanism is given: one is assumed.
    NoLosses,
    /// No efficiency for driving backwards is given: the losses do not help to brake.
    LossesDoNotHelp,
    /// A trapezoid given by two quantities accelerates, runs and brakes for a third of the time each.
    TrapezoidThirds,
    /// A single move is judged as if it were repeated without a pause.
    SingleMoveRepeats,
    /// No special field of application is stated.
    OrdinaryApplication,
    /// A quantity with a tolerance is uniform within its band and independent of the others.
    UniformTolerances,
    /// In a dwell without `hold` the motor carries the load.
    MotorHolds,
    /// The recorded torque is a process torque, added to what the mechanism asks for.
    RecordedTorqueAdds,
    /// Speed and acceleration are differences of a recorded position, not smoothed.
    RecordedPositionDifferentiated,
}

impl Assumption {
    /// Every one, in their order.
    pub const ALL: [Self; 33] = [
        Self::NoFriction,
        Self::AmbientWithinRange,
        Self::CoolingPlate,
        Self::ModulationReserve,
        Self::NoSupply,
        Self::OwnStallCurrentIncludesFriction,
        Self::NoFlangeLoads,
        Self::FlangeLoadsConstant,
        Self::FlangeMomentsAligned,
        Self::FlangeLoadsOfMechanism,
        Self::FlangeLoadsAddUp,
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
        Self::TrapezoidThirds,
        Self::SingleMoveRepeats,
        Self::OrdinaryApplication,
        Self::UniformTolerances,
        Self::MotorHolds,
        Self::RecordedTorqueAdds,
        Self::RecordedPositionDifferentiated,
    ];
}

/// An actuator that the user describes.
#[derive(Clone, Debug)]
pub struct OwnActuator {
    /// Its name.
    pub name: String,
    /// What is known of it.
    pub parameters: Parameters,
}

/// A project: one axis with its requirements.
#[derive(Clone, Debug)]
pub struct Project {
    /// Name of the axis; empty if none is given.
    pub name: String,
    /// Load and motion.
    pub axis: Axis,
    /// What the actuator must have.
    pub requirements: Requirements,
    /// Sensor option asked for.
    pub option_1: Option<Option1>,
    /// Cable and connector option asked for.
    pub option_2: Option<Option2>,
    /// The user's own actuator, if there is one.
    pub actuator: Option<OwnActuator>,
    /// The catalogue with the user's curves, where there are any.
    pub own_catalogue: Option<Arc<OwnCatalogue>>,
    /// What each of several ratios of the stage gives; empty for one ratio or no stage.
    pub ratios: Vec<RatioAnswer>,
    /// Recordings that the motion consists of.
    pub recordings: Vec<RecordingRead>,
    /// Defaults that were taken.
    pub assumptions: Vec<Assumption>,
    /// The quantities that carry a tolerance, in the order of the reader.
    pub tolerances: Vec<Tolerance>,
    /// The axis as it was read: it says where a value is stated, and with tolerances it is built anew at other values.
    root: Section,
    /// Whether a segment has loads on the flange of its own.
    segment_bearings: bool,
}

/// Chooses among the ratios that a stage may have, in the order of the file: gives the project with the one to go on with.
/// The second argument makes the project with a ratio.
pub type Choose<'c> = &'c dyn Fn(&[f64], &dyn Fn(f64) -> Option<Project>) -> Option<Project>;

impl Project {
    /// The solid bodies that the axis turns, with their inertia; `None` where it turns something else.
    #[must_use]
    pub fn bodies(&self) -> Option<InertiaAnswer> {
        bodies::of_axis(&self.root)
    }

    /// Reads a project file with one axis that refers to no other file.
    ///
    /// # Errors
    /// Every fault of the file, each with its place, in the order of the file.
    pub fn read(text: &str, choose: Choose<'_>) -> Result<Self, Vec<Diagnostic>> {
        let mut axes = Self::read_all(text, &NoFiles, choose)?;
        match (axes.pop(), axes.is_empty()) {
            (Some(only), true) => Ok(only),
            _ => Err(vec![Diagnostic::at(text, 0..0, Fault::OneAxisOnly, None)]),
        }
    }

    /// Reads a project file with one axis or several, in their order, and the files that it refers to.
    ///
    /// # Errors
    /// Every fault of the file, each with its place, in the order of the file.
    pub fn read_all(text: &str, files: &dyn Files, choose: Choose<'_>) -> Result<Vec<Self>, Vec<Diagnostic>> {
        if text.len() > PROJECT_MAX_BYTES {
            let fault = Fault::FileTooLarge { bytes: text.len(), most: PROJECT_MAX_BYTES };
            return Err(vec![Diagnostic::at(text, 0..0, fault, None)]);
        }
        let mut reader = Reader::new(text);
        let root = reader.read();
        let own = curves::read(&root, &mut reader);
        let mut recordings = Recordings::new(files);
        let several = root.tables("axis");
        let axes: Vec<Option<Self>> = if several.is_empty() {
            vec![Self::build(root, None, (&mut recordings, own.as_ref(), choose), &mut reader)]
        } else {
            for key in ["load", "mechanism", "stage", "motion", "bearing", "requirements", "actuator"] {
                if root.has(key) {
                    reader.fault(root.span_of(key), Fault::OutsideTheAxes { key }, None);
                }
            }
            let build = |(index, section): (usize, &Section)| {
                Self::build(section.as_root(), Some(index), (&mut recordings, own.as_ref(), choose), &mut reader)
            };
            several.iter().enumerate().map(build).collect()
        };
        let faults = reader.into_faults();
        match axes.into_iter().collect::<Option<Vec<Self>>>() {
            Some(axes) if faults.is_empty() => Ok(axes),
            _ => Err(faults),
        }
    }

    /// One axis from its section, `index` among several; `None` where a fault stands in the way.
    fn build(
        mut root: Section,
        index: Option<usize>,
        (recordings, own_catalogue, choose): (&mut Recordings<'_>, Option<&Arc<OwnCatalogue>>, Choose<'_>),
        reader: &mut Reader<'_>,
    ) -> Option<Self> {
        recordings.resolve(&mut root, reader);
        let root = &root;
        let axis = prepare(root, reader).map(|draft| finish(root, draft));
        let actuator = build_actuator(root, reader);
        let tolerances = tolerance::of_axis(&reader.tolerances, index);
        for window in tolerances.iter().filter(|each| each.path.ends_with("].from") || each.path.ends_with("].to")) {
            reader.fault(window.span.clone(), Fault::NoTolerance, None);
        }
        if reader.fault_count() == 0 && axis.is_some() {
            tolerance::hold(root, &tolerances, reader);
        }
        let project = Self {
            ratios: Vec::new(),
            name: root.table("axis").and_then(|axis| axis.text("name")).unwrap_or_default().to_owned(),
            own_catalogue: own_catalogue.cloned(),
            recordings: recorded::all(root),
            assumptions: assumptions(root, !tolerances.is_empty()),
            requirements: requirements(root),
            option_1: option(root, "option_1").and_then(|word| (word == "EC").then_some(Option1::EC)),
            option_2: option(root, "option_2").and_then(|word| match word {
                "K" => Some(Option2::K),
                "R" => Some(Option2::R),
                "S" => Some(Option2::S),
                _ => None,
            }),
            axis: axis?,
            actuator,
            segment_bearings: root.tables("motion").iter().any(|section| section.table("bearing").is_some()),
            root: root.clone(),
            tolerances,
        };
        let ratios = root.table("stage").map(|section| section.numbers("ratios")).unwrap_or_default();
        if ratios.is_empty() || reader.fault_count() > 0 {
            return Some(project);
        }
        let with_ratio = |ratio: f64| project.with_ratio(root, ratio);
        Some(choose(ratios, &with_ratio).unwrap_or_else(|| project.clone()))
    }

    /// The project with one ratio in the place of several; `None` where there is no such axis.
    fn with_ratio(&self, root: &Section, ratio: f64) -> Option<Self> {
        let mut root = root.clone();
        root.set_ratio(ratio);
        let draft = prepare(&root, &mut Reader::new(""))?;
        Some(Self { axis: finish(&root, draft), root, ..self.clone() })
    }
}

fn option<'s>(root: &'s Section, name: &str) -> Option<&'s str> {
    root.table("requirements").and_then(|section| section.text(name))
}

fn assumptions(root: &Section, toleranced: bool) -> Vec<Assumption> {
    let mut found = Vec::new();
    load::assumptions(root, &mut found);
    if root.table("requirements").is_none_or(|section| section.get("ambient").is_none()) {
        found.push(Assumption::AmbientWithinRange);
    }
    found.push(Assumption::CoolingPlate);
    if root.table("actuator").is_some_and(|own| own.get("stall_current").is_some()) {
        found.push(Assumption::OwnStallCurrentIncludesFriction);
    }
    let asks = |key: &str| root.table("requirements").is_some_and(|section| section.get(key).is_some());
    if !asks("supply") {
        found.push(Assumption::NoSupply);
    } else if !asks("modulation_reserve") {
        found.push(Assumption::ModulationReserve);
    }
    stage::assumptions(root, &mut found);
    flange::assumptions(root, &mut found);
    if !asks("special_application") {
        found.push(Assumption::OrdinaryApplication);
    }
    found.extend(toleranced.then_some(Assumption::UniformTolerances));
    found
}

fn requirements(root: &Section) -> Requirements {
    let Some(section) = root.table("requirements") else { return Requirements::default() };
    Requirements {
        feedback: section
            .list("feedback")
            .iter()
            .filter_map(|word| Feedback::ALL.iter().copied().find(|feedback| feedback.as_str() == word))
            .collect(),
        brake: section.bool("brake"),
        hollow_shaft_min: section.quantity("hollow_shaft_min"),
        length_max: section.quantity("length_max"),
        mass_max: section.quantity("mass_max"),
        supply: section.quantity("supply"),
    }
}

/// What an axis is made of, checked and not yet laid over each other.
struct Draft {
    mechanism: Mechanism,
    motion: Motion,
    extras: Vec<Extra>,
    bearing: Option<BearingDuty>,
}

/// Everything that may be wrong with an axis is told here; [`finish`] only computes.
fn prepare(root: &Section, reader: &mut Reader<'_>) -> Option<Draft> {
    if !root.has("motion") && !reader.is_damaged() {
        let start = root.span.start;
        let hint = Hint::Example("[[motion]]".to_owned());
        let span = start..start + usize::from(!root.span.is_empty());
        reader.fault(span, Fault::MissingKey { path: "motion".to_owned(), list: true }, Some(hint));
    }
    flange::stated(root, reader);
    let stage = stage::read(root, reader);
    let load = load::load(root, reader)?;
    // The file states the motion of the mechanism; from here on everything is that of the actuator's output.
    let mechanism = Mechanism { stage, ..load.mechanism.clone() };
    let bearing = flange::duty(root, &mechanism, reader);
    let (motion, extras) = load::motion(root, &load, reader)?;
    let motion = motion.geared(mechanism.stage_ratio());
    if let Some(asked) = root.table("requirements") {
        let storage = asked.quantity("storage").unwrap_or_else(|| Time::from_si(0.0));
        let operation = asked.quantity("operation_per_day");
        let battery = configurator::battery();
        if let Some(Err(fault)) = operation.zip(battery.known()).map(|(time, model)| model.value.life(time, storage)) {
            let key =
                if matches!(fault, BatteryFault::OperationOutOfRange { .. }) { "operation_per_day" } else { "storage" };
            reader.fault(asked.span_of(key), Fault::Battery(fault), None);
        }
    }
    Some(Draft { mechanism, motion, extras, bearing })
}

/// Load and motion laid over each other, with what is asked.
fn finish(root: &Section, draft: Draft) -> Axis {
    let mut axis = match configurator::brake_times() {
        Some((closing, opening)) => {
            Axis::braked(draft.mechanism, draft.motion, draft.extras, BrakeTimes { closing, opening })
        }
        None => Axis::new(draft.mechanism, draft.motion, draft.extras),
    };
    if let Some(asked) = root.table("requirements") {
        axis.ambient = asked.quantity("ambient");
        axis.supply = asked
            .quantity("supply")
            .map(|supply| (supply, asked.number("modulation_reserve").unwrap_or(MODULATION_RESERVE)));
        axis.asked = asked_of(asked);
    }
    axis.bearing = draft.bearing;
    axis
}

fn asked_of(section: &Section) -> Asked {
    Asked {
        gear_life_min: section.quantity("gear_life_min"),
        torsion_max: section.quantity("torsion_max"),
        natural_frequency_min: section.quantity("natural_frequency_min"),
        angle_error_max: section.quantity("angle_error_max"),
        lever_arm: section.quantity("lever_arm"),
        deviation_max: section.quantity("deviation_max"),
        stop_angle_max: section.quantity("stop_angle_max"),
        emergency_stops: section.number("emergency_stops"),
        holding_safety: section.number("holding_safety"),
        service_life: section.quantity("service_life"),
        regeneration_power_max: section.quantity("regeneration_power_max"),
        absolute: section.bool("absolute"),
        resolution_max: section.quantity("resolution_max"),
        operation_per_day: section.quantity("operation_per_day"),
        storage: section.quantity("storage"),
        battery_life_min: section.quantity("battery_life_min"),
        collision_torque: section.quantity("collision_torque"),
        collision_time: section.quantity("collision_time"),
        collisions: section.number("collisions"),
        loop_at_output: section.text("position_loop") == Some("output"),
        dc_link_rise: section.quantity("dc_link_rise"),
        special_application: section.text("special_application").and_then(|word| match word {
            "aerospace" => Some(SpecialApplication::Aerospace),
            "explosive_atmosphere" => Some(SpecialApplication::ExplosiveAtmosphere),
            "nuclear" => Some(SpecialApplication::Nuclear),
            "vacuum" => Some(SpecialApplication::Vacuum),
            "household" => Some(SpecialApplication::Household),
            "medical" => Some(SpecialApplication::Medical),
            "human_contact" => Some(SpecialApplication::HumanContact),
            "lifting_of_persons" => Some(SpecialApplication::LiftingOfPersons),
            "amusement" => Some(SpecialApplication::Amusement),
            _ => None,
        }),
    }
}

fn build_actuator(root: &Section, reader: &mut Reader<'_>) -> Option<OwnActuator> {
    let section = root.table("actuator")?;
    let mut parameters = Parameters::unknown();
    let assumed = configurator::assumed();
    parameters.friction_cold_growth = assumed.friction_cold_growth;
    parameters.heat.winding_shutdown = match own(section, "winding_temperature_max") {
        Datum::Known(stated) => Datum::Known(stated),
        _ => assumed.winding_shutdown,
    };
    parameters.torque_max = own(section, "torque_max");
    parameters.speed_max = own(section, "speed_max");
    parameters.speed_motor_max = own(section, "speed_motor_max");
    parameters.speed_motor_rated = own(section, "speed_motor_rated");
    parameters.inertia_out = own(section, "inertia_out");
    parameters.stall_torque = own(section, "stall_torque");
    parameters.stall_current = own(section, "stall_current");
    parameters.current_max = own(section, "current_max");
    parameters.current_demagnetisation = own(section, "current_demagnetisation");
    parameters.no_load_starting_current = own(section, "no_load_starting_current");
    parameters.no_load_current_constant_30 = own(section, "no_load_current_constant_30");
    parameters.no_load_current_constant_80 = own(section, "no_load_current_constant_80");
    parameters.torque_constant_out = own(section, "torque_constant_out");
    parameters.torque_constant_motor = own(section, "torque_constant_motor");
    parameters.voltage_constant_motor = own(section, "voltage_constant_motor");
    parameters.resistance_ll = own(section, "resistance_ll");
    parameters.inductance_ll = own(section, "inductance_ll");
    parameters.mass = own(section, "mass");
    parameters.length = own(section, "length");
    parameters.hollow_shaft = own(section, "hollow_shaft");
    parameters.dc_link_max = own(section, "dc_link_max");
    parameters.terminal_voltage_min = own(section, "terminal_voltage_min");
    parameters.ratio = section.number("ratio").map_or(Datum::NotPrinted, |value| known(section, "ratio", value));
    parameters.pole_pairs =
        section.number("pole_pairs").map_or(Datum::NotPrinted, |value| known(section, "pole_pairs", value));
    if let Some(curve) = curves::curve(section, "continuous_curve", reader) {
        parameters.continuous_curve = known(section, "continuous_curve", curve);
    }
    if let Some(curve) = curves::curve(section, "short_time_curve", reader) {
        parameters.short_time_curve = known(section, "short_time_curve", curve);
    }
    Some(OwnActuator { name: section.text("name")?.to_owned(), parameters })
}

/// A value that the user wrote: graded as published, since it stands in some document of the user's.
fn known<T>(section: &Section, name: &str, value: T) -> Datum<T> {
    let source = Source::Project { key: joined(&section.path, name).into() };
    Datum::Known(Sourced { value, source, grade: Grade::Published, errata: &[] })
}

fn own<Q: Measure>(section: &Section, name: &str) -> Datum<Q> {
    section.quantity(name).map_or(Datum::NotPrinted, |value| known(section, name, value))
}
