//! Faults of an axis: those of its file, and those of what is built from it.

use crate::ids;
use actuator::{BatteryFault, CurveFault};
use mechanism::{BodyError, Geometry, TableFault};
use motion::{MoveFault, PointsFault, RecordedFault};
use project::{Diagnostic, Fault, FaultReport};
use quantities::{Time, Unit};
use sizing::TooManyInstants;

/// Reason why a dwell cannot fill the cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CycleFault {
    /// The other segments take longer than the cycle.
    TooShort {
        /// Duration of the other segments.
        others: Time,
        /// Stated cycle.
        cycle: Time,
    },
    /// The dwell states its own duration too.
    WithTime,
    /// Another dwell fills the cycle already.
    Twice,
}

/// A fault of an axis, with its place and a hint.
pub type AxisDiagnostic = Diagnostic<AxisFault>;

/// Faults of a file, and of the axes that are built from it.
pub(crate) type AxisReport<'t> = FaultReport<'t, AxisFault>;

/// One fault of an axis.
#[derive(Clone, Debug, PartialEq)]
pub enum AxisFault {
    /// A fault of the file.
    Stated(Fault),
    /// Values within the tolerances for which the axis is impossible.
    ImpossibleWithin {
        /// Path, value in SI and unit of each quantity.
        values: Vec<(String, f64, &'static Unit)>,
        /// Fault for these values, if it is known.
        why: Option<Box<Self>>,
    },
    /// Corner points that do not form a limit curve.
    Curve(CurveFault),
    /// Points that do not form a table over the position.
    Table(TableFault),
    /// Hours a day, or years of storage, that the battery model does not cover.
    Battery(BatteryFault),
    /// Lengths and angles that do not form a mechanism.
    Geometry(Geometry),
    /// An impossible motion.
    Move {
        /// Reason.
        fault: MoveFault,
        /// Travel per angle \[m/rad\] for a segment stated along a line.
        travel_m_per_rad: Option<f64>,
    },
    /// A dwell that cannot fill the cycle.
    Cycle(CycleFault),
    /// Points of a cam table that do not form a motion.
    Points(PointsFault),
    /// A motion over too many revolutions under a load that depends on the position.
    Instants(TooManyInstants),
    /// A file that is no recording.
    Recording {
        /// Name of the file.
        name: String,
        /// Fault of the file.
        fault: recording::Fault,
    },
    /// A recording that does not form a motion.
    Recorded {
        /// Name of its file.
        name: String,
        /// Reason.
        fault: RecordedFault,
    },
    /// An impossible body.
    Body(BodyError),
    /// An impossible body of several that are written as texts.
    BodyOfText {
        /// Path of the bodies.
        path: String,
        /// Fault of the body.
        error: BodyError,
    },
    /// A fault of a catalogue file that the project names.
    InCatalogue {
        /// Name of the file.
        name: String,
        /// Fault with its place in the file.
        found: Box<AxisDiagnostic>,
    },
    /// A price without an amount or without a currency.
    NoPrice,
    /// A manufacturer of whom the catalogue has no product.
    UnknownMaker {
        /// Name as written.
        name: String,
        /// Manufacturers of the catalogue.
        makers: Vec<String>,
    },
    /// A catalogue file without products.
    NoProducts,
    /// A product with the name of another one of the file.
    ProductNamedTwice {
        /// Name.
        id: String,
        /// Line of the first product with the name.
        line: usize,
    },
    /// A product with the name of one of another catalogue file.
    ProductOfTwoFiles {
        /// Name.
        id: String,
    },
    /// A product whose name is an ordering code of the series in the program.
    ProductNamedAsCode {
        /// Name.
        id: String,
    },
    /// Neither the series in the program nor a catalogue file is offered.
    NothingOffered,
}

impl From<Fault> for AxisFault {
    fn from(fault: Fault) -> Self {
        Self::Stated(fault)
    }
}

impl AxisFault {
    /// Returns the identifier in data exchange, independent of the words.
    #[must_use]
    pub fn id(&self) -> &'static str {
        match self {
            Self::Stated(fault) => fault.id(),
            Self::ImpossibleWithin { .. } => "impossible_within_tolerance",
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
            Self::Geometry(fault) => fault.id(),
            Self::Move { fault, .. } => ids::motion(fault),
            Self::Cycle(fault) => match fault {
                CycleFault::TooShort { .. } => "cycle_too_short",
                CycleFault::WithTime => "cycle_and_time",
                CycleFault::Twice => "cycle_filled_twice",
            },
            Self::Points(fault) => match fault {
                PointsFault::TooFew { .. } => "points_too_few",
                PointsFault::NotFinite { .. } => "points_not_finite",
                PointsFault::NotIncreasing { .. } => "points_not_increasing",
                PointsFault::Uneven => "points_uneven",
            },
            Self::Instants(_) => "too_many_instants",
            Self::Recording { fault, .. } => ids::recording(fault),
            Self::Recorded { fault, .. } => ids::recorded(fault),
            Self::Body(error) => ids::body(error),
            Self::BodyOfText { error, .. } => ids::body(error),
            Self::InCatalogue { found, .. } => found.fault.id(),
            Self::NoPrice => "no_price",
            Self::UnknownMaker { .. } => "unknown_maker",
            Self::NoProducts => "catalogue_without_products",
            Self::ProductNamedTwice { .. } => "product_named_twice",
            Self::ProductOfTwoFiles { .. } => "product_of_two_files",
            Self::ProductNamedAsCode { .. } => "product_named_as_code",
            Self::NothingOffered => "nothing_offered",
        }
    }
}
