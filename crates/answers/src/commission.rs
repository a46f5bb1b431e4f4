//! Records of `commission`.

use crate::{CitedErratum, Fact, Fit, Id, Number, TableCell};
use catalogue::{LifeStep, SignalWord};
use provenance::Grade;
use schemars::JsonSchema;
use serde::Serialize;
use sizing::Verdict;

/// `commission`: the list of objects with `--for cia402`, else the whole sheet.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum CommissionAnswer {
    /// Objects of CiA 402.
    Objects(Vec<DriveObject>),
    /// The whole sheet.
    Sheet(Box<Commissioning>),
}

/// An object of CiA 402 with its value.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DriveObject {
    /// Index: `0x6075`.
    pub index: String,
    /// Sub-index.
    pub sub: u8,
    /// Type of CiA 301: `UNSIGNED8`, `UNSIGNED16` or `UNSIGNED32`.
    #[serde(rename = "type")]
    pub data_type: &'static str,
    /// Value to write.
    pub value: u32,
    /// Unit of the value.
    pub unit: &'static str,
    /// Name of the object in the profile.
    pub name: &'static str,
    /// Value before rounding.
    pub exact: Number,
    /// Direction of rounding: `nearest` or `down`.
    pub rounding: &'static str,
    /// Grade of the value.
    pub grade: Id<Grade>,
    /// Source of the figures, then the document that defines the object.
    pub source: String,
    /// Ids of the errata that concern the value.
    pub errata: Vec<&'static str>,
}

/// Known values for the commissioning of a code.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Commissioning {
    /// Ordering code.
    pub code: String,
    /// Format of the values for the servo drive: `sinamics`, `plain`.
    #[serde(rename = "for")]
    pub form: &'static str,
    /// Hazards and conditions, the gravest first.
    pub hazards: Vec<Fact>,
    /// Known values.
    pub parameters: Vec<CommissionParameter>,
    /// Values that a servo drive requires and no source states, with advice.
    pub gaps: Vec<CommissionGap>,
    /// Parameters of a SINAMICS drive; empty for another format.
    pub sinamics: Vec<DriveParameter>,
    /// Values stated for the encoders.
    pub encoder: Vec<EncoderValue>,
    /// Determination of the angle between encoder and rotor, step by step.
    pub commutation: Vec<String>,
    /// Thresholds of the temperature sensors in degrees and ohms.
    pub thresholds: Vec<SensorThreshold>,
    /// Settings of the overload supervision.
    pub overload: OverloadSupervision,
    /// Checklists: before power, first motion, after a day.
    pub lists: Vec<CommissionList>,
    /// Errata of the values shown, with their evidence.
    pub errata: Vec<CitedErratum>,
}

/// A value to enter in a servo drive.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CommissionParameter {
    /// Identifier.
    pub id: &'static str,
    /// Symbol in ASCII.
    pub symbol: &'static str,
    /// Name of the value.
    pub name: String,
    /// Value without rounding.
    pub value: Number,
    /// Unit of the value.
    pub unit: &'static str,
    /// Id of the conversion from the manual's value.
    pub conversion: &'static str,
    /// Conversion as text.
    pub conversion_text: String,
    /// Grade of the value.
    pub grade: Id<Grade>,
    /// Source of the value.
    pub source: String,
    /// Ids of the errata that concern the value.
    pub errata: Vec<&'static str>,
}

/// A value that a servo drive requires and no source states.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct CommissionGap {
    /// Identifier.
    pub id: &'static str,
    /// Missing value, and advice.
    pub text: String,
}

/// A parameter of a SINAMICS drive.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DriveParameter {
    /// Number with the index of the motor data set: `p350[0]`.
    pub number: String,
    /// Value of the parameter.
    pub value: Number,
    /// Unit of the value; `1` for a pure number.
    pub unit: &'static str,
    /// Name of the parameter.
    pub name: String,
    /// Conversion from the manual's value, as text.
    pub conversion_text: String,
    /// Grade of the value.
    pub grade: Id<Grade>,
    /// Source of the figure, then the document that defines the parameter.
    pub source: String,
    /// Ids of the errata that concern the value.
    pub errata: Vec<&'static str>,
}

/// A value stated for an encoder.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderValue {
    /// `motor` or `output`.
    pub side: &'static str,
    /// Symbol in ASCII.
    pub symbol: &'static str,
    /// Name of the value.
    pub name: String,
    /// Further distinction of the row.
    pub condition: String,
    /// The value after errata: a number or a text.
    pub value: TableCell,
    /// Value as displayed.
    pub text: String,
    /// Unit of the value; empty for pure numbers and texts.
    pub unit: &'static str,
    /// Number of the table.
    pub table: &'static str,
    /// Notes on the value.
    pub notes: Vec<String>,
    /// Ids of the errata that concern the value.
    pub errata: Vec<&'static str>,
}

/// A threshold of a temperature sensor.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SensorThreshold {
    /// `kty` or `ptc`.
    pub sensor: &'static str,
    /// Name of the threshold.
    pub name: String,
    /// Temperature in degC; for the PTC that of the corner point.
    pub temperature: Number,
    /// Resistance in ohm.
    pub resistance: Number,
    /// `typical`, `at_most` or `at_least`.
    pub bound: &'static str,
    /// Grade of the resistance.
    pub grade: Id<Grade>,
    /// Source of temperature and resistance.
    pub source: String,
    /// Ids of the errata that concern the value.
    pub errata: Vec<&'static str>,
}

/// Settings of the overload supervision.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OverloadSupervision {
    /// Stall current in A rms, to which the overload factor refers.
    pub stall_current: Option<Number>,
    /// Time constant of the winding in s, from the project's model; the manual states none.
    pub time_constant: Option<Number>,
    /// Grade of the time constant.
    pub grade: Id<Grade>,
    /// Response times of a first-order supervision from the cold state.
    pub trips: Vec<OverloadTrip>,
    /// Basis of the values, as text.
    pub text: String,
    /// Ids of the errata that concern the stall current.
    pub errata: Vec<&'static str>,
}

/// Response of the overload supervision.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OverloadTrip {
    /// Overload factor I/I_0.
    pub factor: Number,
    /// Response time in s.
    pub time: Number,
}

/// A checklist.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CommissionList {
    /// `before_power`, `first_motion` or `after_a_day`.
    pub step: Id<LifeStep>,
    /// Title of the checklist.
    pub title: String,
    /// Entries of the checklist.
    pub entries: Vec<CommissionEntry>,
}

/// An entry of a checklist.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CommissionEntry {
    /// Identifier: of a fact, a value or a measurand.
    pub id: &'static str,
    /// Signal word; `null` if there is none.
    pub signal: Option<Id<SignalWord>>,
    /// Action, setting or measurement.
    pub text: String,
    /// Expected value; `null` for an entry to tick.
    pub expected: Option<Number>,
    /// Lower edge of the band.
    pub low: Option<Number>,
    /// Upper edge of the band.
    pub high: Option<Number>,
    /// Expected value as displayed; empty for an entry to tick.
    pub shown: String,
    /// Unit of the figures; `null` for an entry to tick.
    pub unit: Option<&'static str>,
    /// `true` if a measured value is to be recorded.
    pub field: bool,
    /// Grade of the expected value.
    pub grade: Id<Grade>,
    /// Source of the entry.
    pub source: String,
    /// Ids of the errata that concern the value.
    pub errata: Vec<&'static str>,
}

/// `commission --record`: measured values with their verdicts.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Recorded {
    /// Ordering code.
    pub code: String,
    /// Verdict on all measurements; a value not measured does not count as passed.
    pub verdict: Fit,
    /// Number of measurements out of their band.
    pub off: usize,
    /// Number of measurements that are not judged.
    pub not_checked: usize,
    /// The measurements.
    pub measurements: Vec<RecordedValue>,
    /// Errata of the expected values, with their evidence.
    pub errata: Vec<CitedErratum>,
}

/// One measurement with its verdict.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RecordedValue {
    /// Id of the measurand.
    pub id: &'static str,
    /// Name of the measurand.
    pub name: String,
    /// Number of the measurement among several, from 1.
    pub number: Option<usize>,
    /// Verdict of the measurement; `advice` is outside an estimated band.
    pub verdict: Id<Verdict>,
    /// Measured value.
    pub value: Option<Number>,
    /// Expected value.
    pub expected: Option<Number>,
    /// Lower edge of the band.
    pub low: Option<Number>,
    /// Upper edge of the band.
    pub high: Option<Number>,
    /// Unit of the figures.
    pub unit: &'static str,
    /// Basis of the band: `printed`, `servo_motors`, `kty_data_sheet`, `din_44081`, `friction`, `ours`, `exact`.
    pub band: Option<&'static str>,
    /// Basis of the band as text, or the reason why it is not judged.
    pub remark: String,
    /// Identifier of the likely cause of the deviation.
    pub cause: Option<&'static str>,
    /// Likely cause as text.
    pub cause_text: Option<String>,
    /// Grade of the judgement.
    pub grade: Option<Id<Grade>>,
    /// Source of the expected value.
    pub source: String,
    /// Ids of the errata that concern the value.
    pub errata: Vec<&'static str>,
}

/// `commission --out`, `--checklist` or `--blank`: a file written.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct CommissionWritten {
    /// Path of the file.
    pub file: String,
    /// Ordering code.
    pub code: String,
    /// Size of the file in bytes.
    pub bytes: usize,
}
