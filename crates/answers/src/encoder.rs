//! Signals and words of the encoders of a code.

use crate::{Fact, Grade, Id, Number};
use feedback::Protocol;
use installation::encoder::Assumed;
use installation::wiring::Role;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// `encoder`: what the encoders of a code send at an angle.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Encoder {
    /// The code.
    pub code: String,
    /// The motor feedback.
    pub feedback: &'static str,
    /// Seed of the deviation; `null` where encoders see the true angle.
    pub seed: Option<u64>,
    /// What the motor feedback sends.
    #[serde(flatten)]
    pub motor: EncoderState,
    /// What the encoder at the output sends, option EC; `null` without it.
    pub output_encoder: Option<EncoderState>,
    /// What `decode` reads; `null` where no word was given.
    pub decoded: Option<DecodedWord>,
    /// What the manual leaves open and the simulation takes.
    pub assumptions: Vec<EncoderAssumption>,
    /// What is to be known about the position.
    pub notes: Vec<String>,
    /// Rules of the manual on its direction and its battery.
    pub rules: Vec<Fact>,
    /// Errata that concern the data.
    pub errata: Vec<&'static str>,
    /// The file of the trace, where one was written.
    pub trace: Option<String>,
}

/// What one encoder sends.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderState {
    /// Its connector.
    pub connector: Id<Role>,
    /// Its maker's name for it, as printed.
    pub type_printed: Option<&'static str>,
    /// Its shaft.
    pub shaft: EncoderShaft,
    /// The words that it sends; none where it has no serial interface.
    pub words: Vec<EncoderWord>,
    /// Its signals by name.
    pub signals: BTreeMap<&'static str, EncoderSignal>,
    /// Two periods of the excitation with the windings, while the shaft turns at its speed; `null` unless it is a resolver.
    pub carrier: Option<EncoderCarrier>,
    /// The table of its pins.
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
    /// Angle that the encoder sees \[deg\].
    pub seen_deg: Number,
    /// Largest deviation to either side \[arcsec\]; `null` where none is printed.
    pub accuracy_arcsec: Option<Number>,
    /// Turns after which the absolute position begins again; `null` without one.
    pub absolute_turns: Option<u64>,
    /// Whether the count of turns can be trusted; `null` where none is sent.
    pub turns_valid: Option<bool>,
    /// Whole steps since the zero: interpolated to 8 bit, or every edge; `null` for a resolver.
    pub increments: Option<i64>,
}

/// A word.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderWord {
    /// What it is: `endat_2_2_position`, `endat_2_1_position`, `ssi_position`.
    pub name: &'static str,
    /// The same in words.
    pub title: String,
    /// Its protocol.
    pub protocol: Id<Protocol>,
    /// Its bits in the order sent.
    pub bits: String,
    /// Its check; `null` where it has none.
    pub crc: Option<String>,
    /// Its mode command in the order sent; `null` where none is sent.
    pub command: Option<String>,
    /// Its fields in the order sent.
    pub fields: Vec<WordField>,
    /// Clock periods of a transmission before its first bit, in a trace.
    pub clocks_before: u32,
    /// Clock frequency of a trace \[kHz\].
    pub clock_khz: Number,
    /// Time until data is at rest again behind the word, shortest and longest \[us\].
    pub recovery_us: [Number; 2],
    /// Longest time until the position is ready \[us\]; `null` where none is known.
    pub calculation_us: Option<Number>,
}

/// A field of a word.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WordField {
    /// What it is: `start`, `error_1`, `error_2`, `position`, `turns`, `step`, `head`, `value`, `crc`, or a mode command.
    pub name: &'static str,
    /// The same in words.
    pub title: &'static str,
    /// Place of its first bit, from zero.
    pub first: u32,
    /// Its bits in the order sent.
    pub bits: String,
    /// Its value.
    pub value: u64,
}

/// A signal.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderSignal {
    /// What it is.
    pub meaning: String,
    /// Its pins, plus end first.
    pub pins: Vec<EncoderPin>,
    /// How its value is meant.
    pub form: SignalForm,
    /// Its value; `null` where it does not follow the angle.
    pub value: Option<Number>,
    /// Unit of the value: `V`, or `1` for a level and a part of an amplitude.
    pub unit: &'static str,
    /// Nominal level peak to peak \[V\]; `null` where none is printed.
    pub level_v: Option<Number>,
    /// Lowest and highest level peak to peak \[V\]; `null` where no tolerance is printed.
    pub level_bounds_v: Option<[Number; 2]>,
    /// Periods in a turn; `null` where it does not follow the angle.
    pub periods_per_turn: Option<u32>,
    /// Where it stands: the table of its level or its lines.
    pub source: String,
    /// Its course over the angle; `null` where it does not follow the angle.
    pub curve: Option<EncoderCurve>,
}

/// How the value of a signal is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SignalForm {
    /// A voltage between its pins.
    Voltage,
    /// A voltage at the peak of the excitation.
    PeakVoltage,
    /// One is high, zero low.
    Level,
    /// A part of the amplitude, which is not printed.
    Share,
    /// Clocked or alternating: it does not follow the angle.
    Other,
}

/// A pin.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderPin {
    /// Its number.
    pub pin: String,
    /// The signal as printed.
    pub signal: &'static str,
}

/// A signal over the angle of its shaft.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderCurve {
    /// Angles from where the shaft stands \[deg\].
    pub offset_deg: Vec<Number>,
    /// The values there.
    pub value: Vec<Number>,
}

/// What is taken where the manual says nothing.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderAssumption {
    /// What.
    pub id: Id<Assumed>,
    /// The same in words, with what it rests on.
    pub text: String,
    /// How far it can be trusted.
    pub grade: Id<Grade>,
}

/// A word that was read.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DecodedWord {
    /// What it is by its length; `null` where no word of the encoder has it.
    pub name: Option<&'static str>,
    /// The same in words.
    pub title: Option<String>,
    /// The connector of the encoder that sends such words.
    pub connector: Option<Id<Role>>,
    /// Its bits.
    pub bits: String,
    /// Whether nothing is wrong with it.
    pub valid: bool,
    /// Its fields; none where its length is wrong.
    pub fields: Vec<WordField>,
    /// Turns; `null` where the word is wrong or no position.
    pub turns: Option<u64>,
    /// Angle within the turn \[deg\]; `null` likewise.
    pub angle_deg: Option<Number>,
    /// Whether the encoder reports an error; `null` where the word is wrong or has no error bit.
    pub encoder_error: Option<bool>,
    /// What is wrong with it.
    pub faults: Vec<WordFault>,
}

/// What is wrong with a word.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WordFault {
    /// What: `length`, `start`, `error_bits_alike`, `crc`, `command`, `encoder_error`.
    pub id: &'static str,
    /// The same in words.
    pub message: String,
    /// What to look at.
    pub hint: Option<String>,
}
