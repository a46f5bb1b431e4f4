//! Records of `commission`.

use crate::{Fact, Fit, Id, Number, TableCell};
use catalogue::{Signal, Step};
use provenance::Grade;
use schemars::JsonSchema;
use serde::Serialize;
use sizing::Verdict;

/// `commission`: with `--for cia402` the list of objects, else the whole sheet.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum CommissionAnswer {
    /// The objects of CiA 402.
    Objects(Vec<DriveObject>),
    /// All that is known.
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
    /// The value to write.
    pub value: u32,
    /// Unit of the value.
    pub unit: &'static str,
    /// Name of the object in the profile.
    pub name: &'static str,
    /// The value before it was rounded.
    pub exact: Number,
    /// How it was rounded: `nearest` or `down`.
    pub rounding: &'static str,
    /// How far it can be trusted.
    pub grade: Id<Grade>,
    /// Where the figures stand, then the document that names the object.
    pub source: String,
}

/// All that is known for the commissioning of a code.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Commissioning {
    /// The code.
    pub code: String,
    /// Format of the values for the drive: `sinamics`, `plain`.
    #[serde(rename = "for")]
    pub form: &'static str,
    /// Hazards and conditions, gravest first.
    pub hazards: Vec<Fact>,
    /// Every value that is known.
    pub parameters: Vec<CommissionParameter>,
    /// Values that a drive requires and no source states, with advice.
    pub gaps: Vec<CommissionGap>,
    /// The parameters of a SINAMICS drive; empty for another form.
    pub sinamics: Vec<DriveParameter>,
    /// What is printed about the encoders.
    pub encoder: Vec<EncoderValue>,
    /// How the angle between encoder and rotor is found, step by step.
    pub commutation: Vec<String>,
    /// Thresholds of the temperature sensors in degrees and ohms.
    pub thresholds: Vec<SensorThreshold>,
    /// What the supervision of overload is set to.
    pub overload: OverloadSupervision,
    /// The check-lists: before power, first motion, after a day.
    pub lists: Vec<CommissionList>,
}

/// A value to enter in a drive.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CommissionParameter {
    /// Identifier.
    pub id: &'static str,
    /// Symbol in ASCII.
    pub symbol: &'static str,
    /// What it is.
    pub name: String,
    /// Its value, not rounded.
    pub value: Number,
    /// Its unit.
    pub unit: &'static str,
    /// How it follows from what is printed.
    pub conversion: &'static str,
    /// The same in words.
    pub conversion_text: String,
    /// How far it can be trusted.
    pub grade: Id<Grade>,
    /// Where it stands.
    pub source: String,
    /// Ids of the errata that touch it.
    pub errata: Vec<&'static str>,
}

/// A value that a drive requires and no source states.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct CommissionGap {
    /// Identifier.
    pub id: &'static str,
    /// What is missing, and what to do.
    pub text: String,
}

/// A parameter of a SINAMICS drive.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DriveParameter {
    /// Number with the index of the motor data set: `p350[0]`.
    pub number: String,
    /// Its value.
    pub value: Number,
    /// Its unit; `1` for a pure number.
    pub unit: &'static str,
    /// What it is.
    pub name: String,
    /// How it follows from what is printed.
    pub conversion_text: String,
    /// How far it can be trusted.
    pub grade: Id<Grade>,
    /// Where the figure stands, then the document that names the parameter.
    pub source: String,
}

/// A printed value of an encoder.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderValue {
    /// `motor` or `output`.
    pub side: &'static str,
    /// Symbol in ASCII.
    pub symbol: &'static str,
    /// What it is.
    pub name: String,
    /// Further distinction of the row.
    pub condition: String,
    /// The value after errata: a number or a text.
    pub value: TableCell,
    /// The same as it is shown.
    pub text: String,
    /// Its unit; empty for pure numbers and texts.
    pub unit: &'static str,
    /// Number of the table.
    pub table: &'static str,
    /// Notes on it.
    pub notes: Vec<String>,
}

/// A threshold of a temperature sensor.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SensorThreshold {
    /// `kty` or `ptc`.
    pub sensor: &'static str,
    /// What it is.
    pub name: String,
    /// Temperature in degC, of the PTC that of the corner.
    pub temperature: Number,
    /// Resistance in ohm.
    pub resistance: Number,
    /// `typical`, `at_most` or `at_least`.
    pub bound: &'static str,
    /// How far it can be trusted: that of the resistance.
    pub grade: Id<Grade>,
    /// Where both stand.
    pub source: String,
}

/// What the supervision of overload is set to.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OverloadSupervision {
    /// Stall current in A rms, to which the overload factor refers.
    pub stall_current: Option<Number>,
    /// Time constant of the winding in s, by the model of the house; the manual states none.
    pub time_constant: Option<Number>,
    /// How far the time constant can be trusted.
    pub grade: Id<Grade>,
    /// When a first-order supervision responds, from the cold.
    pub trips: Vec<OverloadTrip>,
    /// What this rests on, in words.
    pub text: String,
}

/// When the supervision of overload responds.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OverloadTrip {
    /// Overload factor I/I_0.
    pub factor: Number,
    /// Time in s.
    pub time: Number,
}

/// A check-list.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CommissionList {
    /// `before_power`, `first_motion` or `after_a_day`.
    pub step: Id<Step>,
    /// Its title.
    pub title: String,
    /// Its lines.
    pub entries: Vec<CommissionEntry>,
}

/// A line of a check-list.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CommissionEntry {
    /// Identifier: of a fact, a value or a measurand.
    pub id: &'static str,
    /// Signal word; `null` where there is none.
    pub signal: Option<Id<Signal>>,
    /// What is to be done, set or measured.
    pub text: String,
    /// What should come out; `null` for a line to tick.
    pub expected: Option<Number>,
    /// Lower edge of the band.
    pub low: Option<Number>,
    /// Upper edge of the band.
    pub high: Option<Number>,
    /// The same as it is shown; empty for a line to tick.
    pub shown: String,
    /// Unit of the figures; `null` for a line to tick.
    pub unit: Option<&'static str>,
    /// Whether a measured value is to be written down.
    pub field: bool,
    /// How far it can be trusted.
    pub grade: Id<Grade>,
    /// Where it stands.
    pub source: String,
}

/// `commission --record`: what was measured, judged.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Recorded {
    /// The code.
    pub code: String,
    /// Whether nothing is off; what was not measured does not count as passed.
    pub verdict: Fit,
    /// How many measurements are off.
    pub off: usize,
    /// How many are not judged.
    pub not_checked: usize,
    /// Each measurement.
    pub measurements: Vec<RecordedValue>,
}

/// One measurement with its verdict.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RecordedValue {
    /// What was measured.
    pub id: &'static str,
    /// The same in words.
    pub name: String,
    /// Which of several, from 1.
    pub number: Option<usize>,
    /// What comes out; `advice` is outside an estimated band.
    pub verdict: Id<Verdict>,
    /// The measured value.
    pub value: Option<Number>,
    /// What it should be.
    pub expected: Option<Number>,
    /// Lower edge of the band.
    pub low: Option<Number>,
    /// Upper edge of the band.
    pub high: Option<Number>,
    /// Unit of the figures.
    pub unit: &'static str,
    /// What the band rests on: `printed`, `servo_motors`, `kty_data_sheet`, `din_44081`, `friction`, `ours`, `exact`.
    pub band: Option<&'static str>,
    /// The same in words, or why it is not judged.
    pub remark: String,
    /// Identifier of the likely cause of what is off.
    pub cause: Option<&'static str>,
    /// The likely cause in words.
    pub cause_text: Option<String>,
    /// How far the judgement can be trusted.
    pub grade: Option<Id<Grade>>,
    /// Where what it is compared with stands.
    pub source: String,
}

/// `commission --out`, `--checklist` or `--blank`: a file that was written.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct CommissionWritten {
    /// Its path.
    pub file: String,
    /// The code.
    pub code: String,
    /// How many bytes it has.
    pub bytes: usize,
}
