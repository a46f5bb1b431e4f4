//! Faults of the input, and hints: identifiers with their arguments, independent of language.

use crate::{ColumnDimensions, TabularFault, ids};
use order_code::CodeError;
use quantities::{Dimension, QuantityError, Unit};

/// One fault of a project file, of a file that it refers to, or of bodies written as text.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// The file exceeds the size limit.
    FileTooLarge {
        /// Size of the file.
        bytes: usize,
        /// Largest size that is read.
        most: usize,
    },
    /// The file is no UTF-8.
    NotUtf8 {
        /// First faulty byte; `None` for a file in UTF-16.
        byte: Option<u8>,
    },
    /// The text is no TOML.
    Syntax {
        /// Message of the parser, in English.
        message: String,
        /// Parts of the file are not read because of it, so that it may hide other faults.
        hides: bool,
    },
    /// A required key is missing.
    MissingKey {
        /// Path of the key.
        path: String,
        /// The key is an array of tables.
        list: bool,
    },
    /// A key that the description of the file does not have.
    UnknownKey {
        /// Path of the key, shortened.
        path: String,
    },
    /// A key that does not belong to the kind of its table.
    KeyOfAnotherKind {
        /// Path of the key.
        path: String,
        /// Key that names the kind.
        by: &'static str,
        /// Kind.
        kind: String,
    },
    /// A key next to several axes instead of in one of them.
    OutsideTheAxes {
        /// Key.
        key: &'static str,
    },
    /// An axis with the name of another one.
    AxisNamedTwice {
        /// Name.
        name: String,
        /// Path of the name of the first axis: `axis[1].name`.
        first: String,
        /// Line of the name of the first axis.
        line: usize,
        /// Both are written alike; otherwise they differ in case or spaces.
        is_alike: bool,
    },
    /// One axis is required, the file has several.
    OneAxisOnly,
    /// Further faults that are counted only.
    More {
        /// Number of further faults.
        count: usize,
    },
    /// Reading stopped because of too many faults of the syntax.
    ReadingStopped {
        /// First line that is not read.
        line: usize,
    },
    /// A character outside of texts, or in a key, that is not seen or only looks like a space.
    InvisibleCharacter {
        /// Character.
        sign: char,
    },
    /// A number without a unit where a quantity belongs.
    BareNumber {
        /// Path of the key.
        path: String,
        /// Dimension of the key.
        dimension: Dimension,
    },
    /// A text that is no quantity of the required dimension.
    Quantity {
        /// Path of the key.
        path: String,
        /// Reason.
        error: QuantityError,
        /// Other permissible dimensions.
        also: Vec<Dimension>,
    },
    /// A plain number outside its bounds.
    NumberOutOfRange {
        /// Path of the key.
        path: String,
        /// Lower bound.
        low: f64,
        /// Upper bound.
        high: f64,
    },
    /// A quantity that must be positive, or not negative.
    QuantityOutOfRange {
        /// Path of the key.
        path: String,
        /// Value as written.
        written: String,
        /// Zero is excluded.
        positive: bool,
    },
    /// A temperature below absolute zero.
    BelowAbsoluteZero {
        /// Path of the key.
        path: String,
        /// Value as written.
        written: String,
    },
    /// A magnitude that no machine has.
    Implausible {
        /// Path of the key.
        path: String,
        /// Value as written.
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
        /// Largest number of characters.
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
        /// Permissible values.
        expected: Expected,
        /// Name of the TOML type found.
        found: &'static str,
    },
    /// A word that is not among those to choose from.
    NotAChoice {
        /// Path of the key.
        path: String,
        /// Word as written, shortened.
        written: String,
    },
    /// More entries than the limit.
    TooManyEntries {
        /// Path of the key.
        path: String,
        /// Largest number of entries.
        most: usize,
    },
    /// A row that is not one quantity for each column.
    NotARow {
        /// Path of the key.
        path: String,
        /// Dimensions of the columns.
        columns: &'static [ColumnDimensions],
    },
    /// A ratio of either sign that is zero or nearly so.
    RatioTooSmall {
        /// Path of the ratio.
        path: String,
        /// Smallest and largest magnitude.
        magnitude: (f64, f64),
    },
    /// A list of words without an entry.
    EmptyList {
        /// Path of the list.
        path: String,
    },
    /// A list of ratios that is empty or too long.
    RatioCount {
        /// Largest number of ratios.
        most: usize,
    },
    /// Both one ratio and a choice of several.
    RatioAndRatios,
    /// A coupling with a ratio or a wheel.
    NoRatioInACoupling {
        /// Key.
        key: &'static str,
    },
    /// A tolerance with an invalid value at one end.
    ToleranceEnd {
        /// Path of the key.
        path: String,
        /// Value at that end, in SI.
        end: f64,
        /// Unit as written.
        unit: &'static Unit,
        /// Permissible range of the value.
        range: Range,
    },
    /// More quantities with a tolerance than the limit.
    TooManyTolerances {
        /// Largest number of quantities.
        most: usize,
    },
    /// A tolerance of a value that is used only while reading.
    NoTolerance,
    /// A pattern of codes that cannot be read.
    Code(CodeError),
    /// A pattern of codes that no actuator of the catalogue has.
    NoSuchCode {
        /// Pattern.
        written: String,
    },
    /// A key without effect on this load.
    WithoutEffect {
        /// Key.
        key: &'static str,
    },
    /// A key that has an effect only beside another one, which is missing.
    OnlyBeside {
        /// Key.
        key: &'static str,
        /// Missing key.
        needs: &'static str,
    },
    /// No load.
    NoMechanism,
    /// More than one load.
    TooManyMechanisms,
    /// Fault of a table whose columns are keys.
    Tabular(TabularFault),
    /// A linear value for a load without a fixed travel per revolution.
    NoLine {
        /// Path of the linear value: a key or a file.
        path: String,
    },
    /// A stroke of a scissor lift that its platform cannot make.
    StrokeBeyond {
        /// Largest strokes down and up from the position at which the segment begins \[m\].
        possible_m: [f64; 2],
    },
    /// A stroke of a scissor lift from a position that is not known.
    StrokeFromUnknown,
    /// A run of the web for a load that is no winder.
    NoWeb,
    /// A run of the web beside another move: the roll it begins with is not known.
    WebNotAlone,
    /// A line speed of the web that is none, or not greater than zero.
    WebSpeed,
    /// A web that ends before its ramps do.
    WebTooShort {
        /// Length of the web \[m\].
        length_m: f64,
        /// Length that passes during the ramps \[m\].
        ramps_m: f64,
    },
    /// A rod that is not longer than the crank.
    RodTooShort,
    /// A motion beyond the range of the mechanism.
    BeyondRange {
        /// Outermost position of the motion \[rad\].
        position_rad: f64,
        /// Lowest and highest possible position \[rad\].
        range_rad: (f64, f64),
    },
    /// No loads on the flange follow from this load.
    NoFlangeLoads,
    /// Loads on the flange are stated, and the mechanism has its own, without a statement of which apply.
    FlangeLoadsUndecided {
        /// Key of the first stated load.
        key: &'static str,
        /// Path of the section for that statement.
        section: String,
    },
    /// A load that would replace those of the mechanism in every segment.
    ReplacesEverything {
        /// Key.
        key: &'static str,
    },
    /// A belt and teeth on one wheel.
    BeltOrTeeth,
    /// A tooth angle out of range.
    ToothAngle {
        /// Key.
        key: &'static str,
        /// Largest angle \[deg\].
        most_deg: f64,
    },
    /// A joint with a segment that is not recorded with its torque.
    JointWithoutTorque {
        /// Columns of the recording that may hold it, as a project names them.
        columns: Vec<String>,
    },
    /// A point of a cam table in other quantities than the first one.
    UnlikeFirstPoint,
    /// Both the DC link and the mains are stated.
    SupplyAndMains,
    /// A value is above another one that it cannot exceed.
    WrongOrder {
        /// Key of the lower value.
        lower: &'static str,
        /// Key of the upper value.
        upper: &'static str,
    },
    /// The speed of a master with points over time.
    MasterOfTimes,
    /// An unknown unit.
    UnknownUnit {
        /// Unit as written, shortened.
        written: String,
    },
    /// A file that cannot be opened or read.
    File {
        /// Name of the file.
        name: String,
        /// Error of the system.
        trouble: FileTrouble,
    },
    /// A file outside of the folders that the project may read.
    FileOutOfReach {
        /// Name of the file.
        name: String,
    },
    /// Columns recorded at the motor, without the ratio to the output.
    MotorSide {
        /// Name of the file.
        name: String,
        /// Headings, shortened.
        headings: Vec<String>,
        /// Keys of `recorded_ratio` with the stated ratios; `None` for a column at the motor without one.
        ratios: Vec<(&'static str, Option<f64>)>,
    },
    /// A ratio for a role that no rotary column has.
    NoColumnWithRatio {
        /// Path of the ratio.
        path: String,
    },
    /// A fault within one of several bodies that are written as texts.
    InBody {
        /// Path of the bodies.
        path: String,
        /// Fault of the body.
        fault: Box<Fault>,
    },
    /// A line without a body.
    BodyMissing,
    /// A body without a shape.
    ShapeMissing,
    /// A word that is not a shape.
    NoShape {
        /// Word as written, shortened.
        written: String,
    },
    /// A word of a body that does not belong to a key.
    NoKey {
        /// Word as written, shortened.
        written: String,
    },
    /// A key that the shape of a body does not have.
    KeyOfAnotherShape {
        /// Key as written, shortened.
        key: String,
        /// Shape.
        shape: &'static str,
    },
    /// A key of a body that is stated twice.
    Twice {
        /// Key.
        key: String,
    },
    /// A number of pieces that is no whole number.
    Count {
        /// Value as written, shortened.
        written: String,
    },
    /// A word that is not an orientation of a body.
    BodyAxis {
        /// Word as written, shortened.
        written: String,
    },
    /// Bodies as texts and as tables.
    BodiesTwice,
}

impl Fault {
    /// Returns `true` if the keys themselves contradict each other or the kind of the load, whatever their values.
    #[must_use]
    pub const fn is_of_keys(&self) -> bool {
        matches!(
            self,
            Self::UnknownKey { .. }
                | Self::MissingKey { .. }
                | Self::FlangeLoadsUndecided { .. }
                | Self::KeyOfAnotherKind { .. }
                | Self::OutsideTheAxes { .. }
                | Self::RatioAndRatios
                | Self::NoRatioInACoupling { .. }
                | Self::WithoutEffect { .. }
                | Self::OnlyBeside { .. }
                | Self::NoMechanism
                | Self::TooManyMechanisms
                | Self::NoLine { .. }
                | Self::NoWeb
                | Self::NoFlangeLoads
                | Self::SupplyAndMains
        )
    }

    /// Returns the identifier in data exchange, independent of the words.
    #[must_use]
    pub fn id(&self) -> &'static str {
        match self {
            Self::FileTooLarge { .. } => "file_too_large",
            Self::NotUtf8 { .. } => "not_utf_8",
            Self::Syntax { .. } => "syntax",
            Self::MissingKey { .. } => "missing_key",
            Self::UnknownKey { .. } => "unknown_key",
            Self::KeyOfAnotherKind { .. } => "key_of_another_kind",
            Self::OutsideTheAxes { .. } => "outside_the_axes",
            Self::AxisNamedTwice { .. } => "axis_named_twice",
            Self::OneAxisOnly => "one_axis_only",
            Self::More { .. } => "more_faults",
            Self::ReadingStopped { .. } => "reading_stopped",
            Self::InvisibleCharacter { .. } => "invisible_character",
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
            Self::RatioTooSmall { .. } => "ratio_too_small",
            Self::EmptyList { .. } => "empty_list",
            Self::RatioCount { .. } => "ratio_count",
            Self::RatioAndRatios => "ratio_and_ratios",
            Self::NoRatioInACoupling { .. } => "no_ratio_in_a_coupling",
            Self::ToleranceEnd { .. } => "tolerance_end",
            Self::TooManyTolerances { .. } => "too_many_tolerances",
            Self::NoTolerance => "no_tolerance",
            Self::Code(error) => ids::code(error),
            Self::NoSuchCode { .. } => "no_such_code",
            Self::MotorSide { .. } => "recorded_at_the_motor",
            Self::NoColumnWithRatio { .. } => "no_column_with_ratio",
            Self::WithoutEffect { .. } => "without_effect",
            Self::OnlyBeside { .. } => "only_beside",
            Self::NoMechanism => "no_mechanism",
            Self::TooManyMechanisms => "too_many_mechanisms",
            Self::NoLine { .. } => "no_line",
            Self::Tabular(fault) => fault.id(),
            Self::StrokeBeyond { .. } => "stroke_beyond",
            Self::StrokeFromUnknown => "stroke_from_unknown",
            Self::NoWeb => "no_web",
            Self::WebNotAlone => "web_not_alone",
            Self::WebSpeed => "web_speed",
            Self::WebTooShort { .. } => "web_too_short",
            Self::RodTooShort => "rod_too_short",
            Self::BeyondRange { .. } => "beyond_range",
            Self::NoFlangeLoads => "no_flange_loads",
            Self::FlangeLoadsUndecided { .. } => "flange_loads_undecided",
            Self::ReplacesEverything { .. } => "replaces_everything",
            Self::BeltOrTeeth => "belt_or_teeth",
            Self::ToothAngle { .. } => "tooth_angle",
            Self::JointWithoutTorque { .. } => "joint_without_torque",
            Self::UnlikeFirstPoint => "unlike_first_point",
            Self::SupplyAndMains => "supply_and_mains",
            Self::WrongOrder { .. } => "wrong_order",
            Self::MasterOfTimes => "master_of_times",
            Self::UnknownUnit { .. } => "unknown_unit",
            Self::File { .. } => "file_unreadable",
            Self::FileOutOfReach { .. } => "file_out_of_reach",
            Self::InBody { fault, .. } => fault.id(),
            Self::BodyMissing => "body_missing",
            Self::ShapeMissing => "shape_missing",
            Self::NoShape { .. } => "no_shape",
            Self::NoKey { .. } => "no_key",
            Self::KeyOfAnotherShape { .. } => "key_of_another_shape",
            Self::Twice { .. } => "given_twice",
            Self::Count { .. } => "count",
            Self::BodyAxis { .. } => "body_axis",
            Self::BodiesTwice => "bodies_twice",
        }
    }
}

/// Permissible range of a quantity.
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
    /// Returns `true` if a value is in the range; a temperature is bounded by absolute zero too.
    pub(crate) fn holds(self, dimension: Dimension, si: f64) -> bool {
        match self {
            Self::Any => dimension != Dimension::Temperature || si >= 0.0,
            Self::NotNegative => si >= 0.0,
            Self::Positive => si > 0.0,
        }
    }
}

/// Permissible values of a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Expected {
    /// A quantity with its unit.
    Quantity(Dimension),
    /// A rotational or a linear quantity.
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
    /// A list of texts.
    Texts,
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

/// Reason why a file is not opened although the system would open it: the inner error of
/// the access to the file, since the system has no kind for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unopened {
    /// It is not a regular file: a pipe, a device, a socket.
    NoRegularFile,
    /// The name is not that of a recording.
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

/// Reason why a file cannot be opened or read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileTrouble {
    /// Kind of the error.
    pub kind: std::io::ErrorKind,
    /// Reason why it is not opened although the system would open it.
    pub unopened: Option<Unopened>,
    /// Error number of the system.
    pub code: Option<i32>,
    /// Error message of the system.
    pub system: String,
}

impl From<&std::io::Error> for FileTrouble {
    fn from(error: &std::io::Error) -> Self {
        let unopened = error.get_ref().and_then(|inner| inner.downcast_ref()).copied();
        Self { kind: error.kind(), unopened, code: error.raw_os_error(), system: error.to_string() }
    }
}
