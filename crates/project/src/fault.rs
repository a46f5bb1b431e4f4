//! What can be wrong with what the user wrote, and what would help: identifiers with their arguments, in no language.

use crate::{Column, TabularFault, ids};
use actuator::{BatteryFault, CurveFault};
use mechanism::{BodyError, Geometry, TableFault};
use motion::{MoveFault, PointsFault, RecordedFault};
use order_code::CodeError;
use quantities::{Dimension, QuantityError, Unit};
use sizing::TooManyInstants;

/// One fault of a project file, of a file that it refers to, or of bodies written as text.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// The file is larger than is read.
    FileTooLarge {
        /// Its size.
        bytes: usize,
        /// The largest size that is read.
        most: usize,
    },
    /// The text is no TOML.
    Syntax {
        /// What the parser says, in English.
        message: String,
    },
    /// A key that must be there is not.
    MissingKey {
        /// Its path.
        path: String,
        /// Whether it is an array of tables.
        list: bool,
    },
    /// A key that the description of the file does not have.
    UnknownKey {
        /// Its path, shortened.
        path: String,
    },
    /// A key that has no meaning for the kind of its table.
    KeyOfAnotherKind {
        /// Its path.
        path: String,
        /// The key that names the kind.
        by: &'static str,
        /// The kind.
        kind: String,
    },
    /// A key that stands beside several axes instead of in one.
    OutsideTheAxes {
        /// The key.
        key: &'static str,
    },
    /// One axis is required, the file has several.
    OneAxisOnly,
    /// Further faults that are counted only.
    More {
        /// How many.
        count: usize,
    },
    /// A number without a unit where a quantity belongs.
    BareNumber {
        /// Path of the key.
        path: String,
        /// What it measures.
        dimension: Dimension,
    },
    /// A text that is no quantity of the required dimension.
    Quantity {
        /// Path of the key.
        path: String,
        /// Why.
        error: QuantityError,
        /// Further dimensions that may stand there.
        also: Vec<Dimension>,
    },
    /// A plain number outside its bounds.
    NumberOutOfRange {
        /// Path of the key.
        path: String,
        /// The least.
        low: f64,
        /// The most.
        high: f64,
    },
    /// A quantity that must be positive, or not negative.
    QuantityOutOfRange {
        /// Path of the key.
        path: String,
        /// As written.
        written: String,
        /// Whether zero is excluded too.
        positive: bool,
    },
    /// A temperature below absolute zero.
    BelowAbsoluteZero {
        /// Path of the key.
        path: String,
        /// As written.
        written: String,
    },
    /// A magnitude that no machine has.
    Implausible {
        /// Path of the key.
        path: String,
        /// As written.
        written: String,
        /// Least magnitude that is read, in SI.
        low: f64,
        /// Largest magnitude that is read, in SI.
        high: f64,
    },
    /// A text longer than is read.
    TextTooLong {
        /// Path of the key.
        path: String,
        /// Most characters.
        most: usize,
    },
    /// A text with a control character.
    ControlCharacter {
        /// Path of the key.
        path: String,
    },
    /// A value of another type than the key has.
    WrongType {
        /// Path of the key.
        path: String,
        /// What may stand there.
        expected: Expected,
        /// What stands there: the name of TOML's type.
        found: &'static str,
    },
    /// A word that is not among those to choose from.
    NotAChoice {
        /// Path of the key.
        path: String,
        /// As written, shortened.
        written: String,
    },
    /// More entries than are read.
    TooManyEntries {
        /// Path of the key.
        path: String,
        /// How many are read.
        most: usize,
    },
    /// A row that is not one quantity for each column.
    NotARow {
        /// Path of the key.
        path: String,
        /// What the columns measure.
        columns: &'static [Column],
    },
    /// A list of ratios that is empty or too long.
    RatioCount {
        /// How many are read.
        most: usize,
    },
    /// One ratio and several to choose from.
    RatioAndRatios,
    /// A coupling with a ratio or a wheel.
    NoRatioInACoupling {
        /// The key.
        key: &'static str,
    },
    /// A tolerance at whose end no valid value stands.
    ToleranceEnd {
        /// Path of the key.
        path: String,
        /// The value at that end, in SI.
        end: f64,
        /// Its unit as written.
        unit: &'static Unit,
        /// What is demanded of the value.
        range: Range,
    },
    /// More quantities with a tolerance than are read.
    TooManyTolerances {
        /// How many are read.
        most: usize,
    },
    /// A tolerance where the value is used only while reading.
    NoTolerance,
    /// Values within the tolerances at which there is no such axis.
    ImpossibleWithin {
        /// Path, value in SI and unit of each quantity.
        values: Vec<(String, f64, &'static Unit)>,
        /// What is wrong there, where that is known.
        why: Option<Box<Fault>>,
    },
    /// A pattern of codes that cannot be read.
    Code(CodeError),
    /// A pattern of codes that no actuator of the catalogue has.
    NoSuchCode {
        /// The pattern.
        written: String,
    },
    /// Corner points that make no limit curve.
    Curve(CurveFault),
    /// Points that make no table over the position.
    Table(TableFault),
    /// Hours a day, or years of storage, that the battery model does not cover.
    Battery(BatteryFault),
    /// A key without effect on this load.
    WithoutEffect {
        /// The key.
        key: &'static str,
    },
    /// No load.
    NoMechanism,
    /// More than one load.
    TooManyMechanisms,
    /// Of a table whose columns are keys.
    Tabular(TabularFault),
    /// A value along a line where the load has no fixed travel per revolution.
    NoLine {
        /// What is along a line: a key or a file.
        path: String,
    },
    /// A rod that is not longer than the crank.
    RodTooShort,
    /// Lengths and angles that make no mechanism.
    Geometry(Geometry),
    /// A motion that goes farther than the geometry of the mechanism.
    BeyondRange {
        /// The farthest position that it reaches \[rad\].
        position_rad: f64,
        /// Lowest and highest that there are \[rad\].
        range_rad: (f64, f64),
    },
    /// No loads on the flange follow from this load.
    NoFlangeLoads,
    /// Loads on the flange are stated, and the mechanism has its own: which of them count is not said.
    FlangeLoadsUndecided {
        /// Key of the first stated load.
        key: &'static str,
        /// Path of the section in which it is to be said.
        section: String,
    },
    /// A load that would take the place of those of the mechanism in every segment.
    ReplacesEverything {
        /// The key.
        key: &'static str,
    },
    /// A belt and teeth on one wheel.
    BeltOrTeeth,
    /// An angle of teeth that no teeth have.
    ToothAngle {
        /// The key.
        key: &'static str,
        /// The most, in degrees.
        most_deg: f64,
    },
    /// A joint with a segment that is not recorded with its torque.
    JointWithoutTorque,
    /// A motion that cannot be.
    Move {
        /// Why.
        fault: MoveFault,
        /// Travel per angle [m/rad] where the segment is stated along a line.
        travel_m_per_rad: Option<f64>,
    },
    /// Points of a cam table that make no motion.
    Points(PointsFault),
    /// A point of a cam table in other quantities than the first one.
    UnlikeFirstPoint,
    /// Both the DC link and the mains are stated.
    SupplyAndMains,
    /// The lowest humidity is above the highest.
    HumidityOrder,
    /// The speed of a master beside points over the time.
    MasterOfTimes,
    /// A motion over too many revolutions under a load that depends on the position.
    Instants(TooManyInstants),
    /// A unit that is not known.
    UnknownUnit {
        /// As written, shortened.
        written: String,
    },
    /// A file that cannot be opened or read.
    File {
        /// Its name.
        name: String,
        /// What stands in the way.
        trouble: FileTrouble,
    },
    /// A file that lies outside of what the project may read.
    FileOutOfReach {
        /// Its name.
        name: String,
    },
    /// A file that is no recording.
    Recording {
        /// Its name.
        name: String,
        /// Why.
        fault: recording::Fault,
    },
    /// A recording that is no motion.
    Recorded {
        /// Name of its file.
        name: String,
        /// Why.
        fault: RecordedFault,
    },
    /// A fault within one of several bodies that are written as texts.
    InBody {
        /// Path of the bodies.
        path: String,
        /// What is wrong there.
        fault: Box<Fault>,
    },
    /// A line without a body.
    BodyMissing,
    /// A body without a shape.
    ShapeMissing,
    /// A word that is no shape.
    NoShape {
        /// As written, shortened.
        written: String,
    },
    /// A word of a body that belongs to no key.
    NoKey {
        /// As written, shortened.
        written: String,
    },
    /// A key that the shape of a body does not have.
    KeyOfAnotherShape {
        /// As written, shortened.
        key: String,
        /// The shape.
        shape: &'static str,
    },
    /// A key of a body that stands there twice.
    Twice {
        /// The key.
        key: String,
    },
    /// A number of pieces that is no whole number.
    Count {
        /// As written, shortened.
        written: String,
    },
    /// A word that says nothing about how a body lies.
    BodyAxis {
        /// As written, shortened.
        written: String,
    },
    /// A body that cannot be.
    Body(BodyError),
    /// Bodies as texts and as tables.
    BodiesTwice,
}

impl Fault {
    /// Its identifier in data exchange; it stays what it is when the words change.
    #[must_use]
    pub fn id(&self) -> &'static str {
        match self {
            Self::FileTooLarge { .. } => "file_too_large",
            Self::Syntax { .. } => "syntax",
            Self::MissingKey { .. } => "missing_key",
            Self::UnknownKey { .. } => "unknown_key",
            Self::KeyOfAnotherKind { .. } => "key_of_another_kind",
            Self::OutsideTheAxes { .. } => "outside_the_axes",
            Self::OneAxisOnly => "one_axis_only",
            Self::More { .. } => "more_faults",
            Self::BareNumber { .. } => "bare_number",
            Self::Quantity { error, .. } => ids::quantity(error),
            Self::NumberOutOfRange { .. } => "number_out_of_range",
            Self::QuantityOutOfRange { .. } => "quantity_out_of_range",
            Self::BelowAbsoluteZero { .. } => "below_absolute_zero",
            Self::Implausible { .. } => "implausible",
            Self::TextTooLong { .. } => "text_too_long",
            Self::ControlCharacter { .. } => "control_character",
            Self::WrongType { .. } => "wrong_type",
            Self::NotAChoice { .. } => "not_a_choice",
            Self::TooManyEntries { .. } => "too_many_entries",
            Self::NotARow { .. } => "not_a_row",
            Self::RatioCount { .. } => "ratio_count",
            Self::RatioAndRatios => "ratio_and_ratios",
            Self::NoRatioInACoupling { .. } => "no_ratio_in_a_coupling",
            Self::ToleranceEnd { .. } => "tolerance_end",
            Self::TooManyTolerances { .. } => "too_many_tolerances",
            Self::NoTolerance => "no_tolerance",
            Self::ImpossibleWithin { .. } => "impossible_within_tolerance",
            Self::Code(error) => ids::code(error),
            Self::NoSuchCode { .. } => "no_such_code",
            Self::Curve(fault) => match fault {
                CurveFault::TooFewPoints => "curve_too_few_points",
                CurveFault::DoesNotStartAtZero => "curve_not_from_standstill",
                CurveFault::SpeedsNotAscending => "curve_speeds_not_ascending",
                CurveFault::TorqueOutOfRange => "curve_torque_out_of_range",
            },
            Self::Table(fault) => match fault {
                TableFault::TooFewPoints => "table_too_few_points",
                TableFault::PositionsNotAscending => "table_positions_not_ascending",
                TableFault::NegativeInertia => "table_negative_inertia",
            },
            Self::Battery(fault) => match fault {
                BatteryFault::OperationOutOfRange { .. } => "battery_operation_out_of_range",
                BatteryFault::StorageOutOfRange { .. } => "battery_storage_out_of_range",
            },
            Self::WithoutEffect { .. } => "without_effect",
            Self::NoMechanism => "no_mechanism",
            Self::TooManyMechanisms => "too_many_mechanisms",
            Self::NoLine { .. } => "no_line",
            Self::Tabular(fault) => fault.id(),
            Self::RodTooShort => "rod_too_short",
            Self::Geometry(fault) => fault.id(),
            Self::BeyondRange { .. } => "beyond_range",
            Self::NoFlangeLoads => "no_flange_loads",
            Self::FlangeLoadsUndecided { .. } => "flange_loads_undecided",
            Self::ReplacesEverything { .. } => "replaces_everything",
            Self::BeltOrTeeth => "belt_or_teeth",
            Self::ToothAngle { .. } => "tooth_angle",
            Self::JointWithoutTorque => "joint_without_torque",
            Self::Move { fault, .. } => ids::motion(fault),
            Self::Points(fault) => match fault {
                PointsFault::TooFew { .. } => "points_too_few",
                PointsFault::NotFinite { .. } => "points_not_finite",
                PointsFault::NotIncreasing { .. } => "points_not_increasing",
                PointsFault::Uneven => "points_uneven",
            },
            Self::UnlikeFirstPoint => "unlike_first_point",
            Self::SupplyAndMains => "supply_and_mains",
            Self::HumidityOrder => "humidity_order",
            Self::MasterOfTimes => "master_of_times",
            Self::Instants(_) => "too_many_instants",
            Self::UnknownUnit { .. } => "unknown_unit",
            Self::File { .. } => "file_unreadable",
            Self::FileOutOfReach { .. } => "file_out_of_reach",
            Self::Recording { fault, .. } => ids::recording(fault),
            Self::Recorded { fault, .. } => ids::recorded(fault),
            Self::InBody { fault, .. } => fault.id(),
            Self::BodyMissing => "body_missing",
            Self::ShapeMissing => "shape_missing",
            Self::NoShape { .. } => "no_shape",
            Self::NoKey { .. } => "no_key",
            Self::KeyOfAnotherShape { .. } => "key_of_another_shape",
            Self::Twice { .. } => "given_twice",
            Self::Count { .. } => "count",
            Self::BodyAxis { .. } => "body_axis",
            Self::Body(error) => ids::body(error),
            Self::BodiesTwice => "bodies_twice",
        }
    }
}

/// What would have been right, where that can be said beyond the fault itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Hint {
    /// A line that would be valid.
    Example(String),
    /// The name that was probably meant.
    DidYouMean(String),
    /// Every name that is valid.
    ValidAre(Vec<String>),
    /// A bare number with a unit behind it.
    WithUnit {
        /// The number as written.
        written: String,
        /// What it measures.
        dimension: Dimension,
    },
    /// The mechanisms from which loads on the flange follow.
    MechanismsWithLoads,
    /// How a recorded cycle is made to close.
    CloseTheRecording,
}

impl Hint {
    /// Every name that is valid.
    pub(crate) fn valid(names: &[&str]) -> Self {
        Self::ValidAre(names.iter().map(|name| (*name).to_owned()).collect())
    }
}

/// Which numbers a quantity may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Range {
    /// Any finite number.
    Any,
    /// Zero or more.
    NotNegative,
    /// More than zero.
    Positive,
}

impl Range {
    /// Whether a value may stand there; a temperature is bounded below by absolute zero too.
    pub(crate) fn holds(self, dimension: Dimension, si: f64) -> bool {
        match self {
            Self::Any => dimension != Dimension::Temperature || si >= 0.0,
            Self::NotNegative => si >= 0.0,
            Self::Positive => si > 0.0,
        }
    }
}

/// What may stand behind a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Expected {
    /// A quantity with its unit.
    Quantity(Dimension),
    /// A quantity of the rotation or of the line.
    Along(Dimension, Dimension),
    /// A plain number.
    Number,
    /// A list of plain numbers.
    Numbers,
    /// A whole number.
    Integer,
    /// `true` or `false`.
    Bool,
    /// Text in quotes.
    Text,
    /// One of these words.
    OneOf(&'static [&'static str]),
    /// A list of these words.
    ListOf(&'static [&'static str]),
    /// A list of points.
    Rows,
    /// A table.
    Table,
    /// A list of bodies.
    Bodies,
    /// An array of tables.
    Tables,
}

/// Why a file is not opened though the system would: the inner error of what [`Files::open`](crate::Files::open) returns, since the
/// system has no kind for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unopened {
    /// It is no regular file: a pipe, a device, a socket.
    NoRegularFile,
    /// Its name is not that of a recording ([`is_recording_name`](crate::is_recording_name)).
    NoRecordingName,
}

impl std::fmt::Display for Unopened {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Self::NoRegularFile => "this is no regular file",
            Self::NoRecordingName => "this is no name of a recording",
        })
    }
}

impl std::error::Error for Unopened {}

/// Why a file cannot be opened or read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileTrouble {
    /// The kind of trouble.
    pub kind: std::io::ErrorKind,
    /// Why it is not opened though the system would.
    pub unopened: Option<Unopened>,
    /// The number of the system's error.
    pub code: Option<i32>,
    /// What the system says.
    pub system: String,
}

impl From<&std::io::Error> for FileTrouble {
    fn from(error: &std::io::Error) -> Self {
        let unopened = error.get_ref().and_then(|inner| inner.downcast_ref()).copied();
        Self { kind: error.kind(), unopened, code: error.raw_os_error(), system: error.to_string() }
    }
}
