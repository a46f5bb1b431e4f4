//! The project file as typed data: read against one description, every fault with its place.
//!
//! It holds the statements of the user, independent of language: a [`Fault`] is an identifier with its arguments, and
//! so is a [`Hint`]. [`read`] returns them as sections of keys; `axis` makes an axis of a section.

mod about;
mod axis_names;
mod bodies;
mod cam;
mod catalogue_file;
/// Choices of the file, each with its word.
pub mod choices;
mod column_words;
mod curves;
mod cycle;
mod diagnostic;
mod edit;
mod encoding;
mod fault;
mod flange;
mod free_text;
mod heading;
mod hint;
mod ids;
mod inputs;
mod key;
mod key_default;
mod label;
mod load;
mod measured;
mod mechanism;
mod merged;
mod motion;
mod nearest;
mod numbers;
mod own;
mod read;
mod recorded;
mod recovery;
mod report;
mod requirements;
mod root;
mod scaled;
mod schema;
mod section;
mod several;
mod stage;
mod stated;
mod tabular;
mod tolerance;
mod twin;
mod value;

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
    pub use crate::own::{
        ActuatorEntryName, ActuatorName, ActuatorValueName, CatalogueFileName, CatalogueHeadName, CatalogueName,
    };
    pub use crate::recorded::{ColumnsName, RatiosName, UnitsName};
    pub use crate::requirements::{DriveName, RequirementsName};
    pub use crate::root::{AxisName, OneOfSeveralName, PartsName, RootName};
    pub use crate::stage::StageName;
    pub use crate::twin::{ReplacedName, TwinName};
}

/// Sections of the file with their fields, and the values that a field can have.
pub mod sections {
    pub use crate::bodies::BodySection;
    pub use crate::cam::{CamEnds, CamPoint};
    pub use crate::curves::{CurveLimit, CurveSection};
    pub use crate::flange::{Bearing, Derived, FlangeLoads};
    pub use crate::measured::{Brake, Direction, Emf, MeasuredRoot, NoLoadPoint, Sensor, Speed, Winding};
    pub use crate::mechanism::sections::*;
    pub use crate::motion::Segment;
    pub use crate::own::{
        ActuatorEntry, ActuatorSection, ActuatorValues, CatalogueFile, CatalogueHead, CatalogueSection,
    };
    pub use crate::recorded::{Columns, Gaps, HeldValues, Ratios, TimeStamps, Units};
    pub use crate::requirements::{DriveSection, PositionLoop, RequirementsSection};
    pub use crate::root::{AxisSection, Parts};
    pub use crate::section::{Fields, OfKinds, Section, group};
    pub use crate::stage::StageSection;
    pub use crate::stated::{SectionHead, Stated, StatedField};
    pub use crate::twin::{MeasuredSection, TwinSection};
    pub use crate::value::{
        Along, BodyLines, Choices, CurveRow, KeyValue, Numbers, OneOrMany, Rows, TableRow, Tables, Texts, Turning,
        Written,
    };
}

pub use about::About;
pub use bodies::{BODY_SHAPES, BodyKind, BodyShape, BodyText, read_bodies};
pub use catalogue_file::{CATALOGUE_KEYS, CATALOGUE_MAX_BYTES, ReadCatalogue, read_catalogue};
pub use column_words::{HeadingMeant, headings_meant, nearest_entry, readings_of_angle, without_cycle};
pub use cycle::{FilledCycle, Unfilled, cycle_filled};
pub use diagnostic::{Diagnostic, offset, place};
pub use edit::{
    Edit, EditFault, Written, edit, edit_measured, edit_values, files_named, key_at, measured_key_at, written,
};
pub use encoding::decoded;
pub use fault::{Expected, Fault, FileTrouble, Range, Unopened};
pub use heading::{Counted, Heading, Objection, is_label, nearest_heading, truth, with_brackets};
pub use hint::Hint;
pub use inputs::{Input, InputChange, input_changes, inputs};
pub use key::{ColumnDimensions, Key, Kind, Variants, example};
pub use key_default::KeyDefault;
pub use label::input_label;
pub use load::{LOADS, Load, loads, takes_payload};
pub use measured::{MEASURED_FORMAT, MEASURED_KEYS, MeasuredKey, MeasuredLine, measured_lines, read_measured};
pub use merged::{Clash, Prefer, Unmerged, merged};
pub use motion::SegmentLaw;
pub use nearest::{distance_of_stations, nearest as nearest_name, other_names};
pub use read::shortened;
pub use recovery::with_newlines;
pub use report::FaultReport;
pub use root::{KEYS, Project, ReadProject, Shared, read};
pub use scaled::{increased, load_scaled, multiplied, paced, stretch};
pub use schema::{SchemaText, schema};
pub use several::with_axis;
pub use tabular::TabularFault;
pub use tolerance::Tolerance;

/// Largest project file that is read, in bytes.
pub const PROJECT_MAX_BYTES: usize = 1 << 20;
