//! Signals and words of the encoders of a code.

use crate::{Fact, Grade, Id, Number};
use feedback::Protocol;
use installation::encoder::Assumed;
use installation::wiring::Role;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// `encoder`: output of the encoders of a code at an angle.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Encoder {
    /// Ordering code.
    pub code: String,
    /// Motor encoder.
    pub feedback: &'static str,
    /// Seed of the deviation; `null` if encoders measure the true angle.
    pub seed: Option<u64>,
    /// Output of the motor encoder.
    #[serde(flatten)]
    pub motor: EncoderState,
    /// Output of the output encoder, option EC; `null` without it.
    pub output_encoder: Option<EncoderState>,
    /// Result of `decode`; `null` if no word was given.
    pub decoded: Option<DecodedWord>,
    /// Assumptions of the simulation on points that the manual leaves open.
    pub assumptions: Vec<EncoderAssumption>,
    /// Remarks on the position.
    pub notes: Vec<String>,
    /// Rules of the manual on direction and battery.
    pub rules: Vec<Fact>,
    /// Errata that concern the data.
    pub errata: Vec<&'static str>,
    /// File of the trace; `null` if none was written.
    pub trace: Option<String>,
}

/// Output of one encoder.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderState {
    /// Connector of the encoder.
    pub connector: Id<Role>,
    /// Manufacturer's name of the encoder, as in the manual.
    pub type_printed: Option<&'static str>,
    /// Shaft of the encoder.
    pub shaft: EncoderShaft,
    /// Words sent; empty without a serial interface.
    pub words: Vec<EncoderWord>,
    /// Signals by name.
    pub signals: BTreeMap<&'static str, EncoderSignal>,
    /// Two periods of the excitation with the windings, while the shaft turns at its speed; `null` unless it is a
    /// resolver.
    pub carrier: Option<EncoderCarrier>,
    /// Table of the pins.
    pub table_of_pins: Option<&'static str>,
}

/// Voltages of a resolver over time.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderCarrier {
    /// Frequency of the excitation \[kHz\].
    pub frequency_khz: Number,
    /// Time \[us\].
    pub time_us: Vec<Number>,
    /// Excitation \[V\].
    pub excitation_v: Vec<Number>,
    /// Sine winding \[V\].
    pub sine_v: Vec<Number>,
    /// Cosine winding \[V\].
    pub cosine_v: Vec<Number>,
}

/// The shaft of an encoder.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderShaft {
    /// Whole turns.
    pub turns: i64,
    /// Angle within the turn \[deg\].
    pub angle_deg: Number,
    /// Speed \[1/min\].
    pub speed_per_min: Number,
    /// Angle measured by the encoder \[deg\].
    pub seen_deg: Number,
    /// Largest deviation to either side \[arcsec\]; `null` if the manual states none.
    pub accuracy_arcsec: Option<Number>,
    /// Number of turns after which the absolute position repeats; `null` without one.
    pub absolute_turns: Option<u64>,
    /// `true` if the count of turns is reliable; `null` if none is sent.
    pub turns_valid: Option<bool>,
    /// Whole steps since zero: interpolated to 8 bit, or every edge; `null` for a resolver.
    pub increments: Option<i64>,
}

/// A word of a serial interface.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderWord {
    /// Kind of word: `endat_2_2_position`, `endat_2_1_position`, `ssi_position`.
    pub name: &'static str,
    /// Kind of word as text.
    pub title: String,
    /// Protocol of the word.
    pub protocol: Id<Protocol>,
    /// Bits in the order sent.
    pub bits: String,
    /// Checksum; `null` if it has none.
    pub crc: Option<String>,
    /// Mode command in the order sent; `null` if none is sent.
    pub command: Option<String>,
    /// Fields in the order sent.
    pub fields: Vec<WordField>,
    /// Number of clock periods of a transmission before its first bit, in a trace.
    pub clocks_before: u32,
    /// Clock frequency of a trace \[kHz\].
    pub clock_khz: Number,
    /// Shortest and longest time until the data line is at rest again after the word \[us\].
    pub recovery_us: [Number; 2],
    /// Longest time until the position is ready \[us\]; `null` if unknown.
    pub calculation_us: Option<Number>,
}

/// A field of a word.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WordField {
    /// Kind of field: `start`, `error_1`, `error_2`, `position`, `turns`, `step`, `head`, `value`, `crc`, or a mode
    /// command.
    pub name: &'static str,
    /// Kind of field as text.
    pub title: &'static str,
    /// Index of the first bit, from zero.
    pub first: u32,
    /// Bits in the order sent.
    pub bits: String,
    /// Value of the field.
    pub value: u64,
}

/// A signal of an encoder.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderSignal {
    /// Meaning of the signal.
    pub meaning: String,
    /// Pins, plus end first.
    pub pins: Vec<EncoderPin>,
    /// Representation of the value.
    pub form: SignalForm,
    /// Value; `null` if it does not depend on the angle.
    pub value: Option<Number>,
    /// Unit of the value: `V`, or `1` for a level and a fraction of an amplitude.
    pub unit: &'static str,
    /// Nominal level peak to peak \[V\]; `null` if the manual states none.
    pub level_v: Option<Number>,
    /// Lowest and highest level peak to peak \[V\]; `null` if the manual states no tolerance.
    pub level_bounds_v: Option<[Number; 2]>,
    /// Periods per turn; `null` if it does not depend on the angle.
    pub periods_per_turn: Option<u32>,
    /// Source: the table of its level or its lines.
    pub source: String,
    /// Ids of the errata that concern the value.
    pub errata: Vec<&'static str>,
    /// Values over the angle; `null` if it does not depend on the angle.
    pub curve: Option<EncoderCurve>,
}

/// Representation of the value of a signal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SignalForm {
    /// A voltage between its pins.
    Voltage,
    /// A voltage at the peak of the excitation.
    PeakVoltage,
    /// Logic level: one is high, zero low.
    Level,
    /// Fraction of the amplitude, which the manual does not state.
    Share,
    /// Clocked or alternating signal, independent of the angle.
    Other,
}

/// A pin of a signal.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderPin {
    /// Number of the pin.
    pub pin: String,
    /// Signal as in the manual.
    pub signal: &'static str,
}

/// A signal over the angle of its shaft.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderCurve {
    /// Angles relative to the position of the shaft \[deg\].
    pub offset_deg: Vec<Number>,
    /// Values at these angles.
    pub value: Vec<Number>,
}

/// An assumption on a point that the manual leaves open.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderAssumption {
    /// Id of the assumption.
    pub id: Id<Assumed>,
    /// Assumption as text, with its basis.
    pub text: String,
    /// Grade of the assumption.
    pub grade: Id<Grade>,
}

/// A decoded word.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DecodedWord {
    /// Kind of word by its length; `null` if no word of the encoder has it.
    pub name: Option<&'static str>,
    /// Kind of word as text.
    pub title: Option<String>,
    /// Connector of the encoder that sends such words.
    pub connector: Option<Id<Role>>,
    /// Bits of the word.
    pub bits: String,
    /// `true` if the word has no fault.
    pub valid: bool,
    /// Fields; empty if the length is wrong.
    pub fields: Vec<WordField>,
    /// Turns; `null` if the word is wrong or no position.
    pub turns: Option<u64>,
    /// Angle within the turn \[deg\]; `null` if the word is wrong or no position.
    pub angle_deg: Option<Number>,
    /// `true` if the encoder reports an error; `null` if the word is wrong or has no error bit.
    pub encoder_error: Option<bool>,
    /// Faults of the word.
    pub faults: Vec<WordFault>,
}

/// A fault of a word.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WordFault {
    /// Kind of fault: `length`, `start`, `error_bits_alike`, `crc`, `command`, `encoder_error`.
    pub id: &'static str,
    /// Description of the fault.
    pub message: String,
    /// Point to check.
    pub hint: Option<String>,
}
