//! `encoder CODE --vcd FILE`: the digital signals of an encoder over time; a face writes them.

use super::encoder::{ANGLE, SEED, SPEED, TURN, fitted, read_angle, read_speed, read_turn};
use super::given::{Hinted, arguments, by_id, code, number, one, word};
use super::{Answer, Argument, ArgumentKind, CODE, Entry, Gives, Inquiry, OutputFile, Reads, Unanswered, media};
use crate::chapters::read_quantity;
use feedback::endat::ErrorBits;
use feedback::{EDGES_MOST, Shaft, Trace};
use installation::wiring::Role;
use order_code::OrderCode;
use quantities::{Angle, AngularVelocity, Language, Measure, Time};
use words::help::values;
use words::{encoder, help, requests};

/// Largest length of a trace \[s\].
const TRACE_MOST_S: f64 = 3600.0;

/// Names of the command sets.
const SETS: [(&str, ErrorBits); 2] = [("2.2", ErrorBits::Both), ("2.1", ErrorBits::One)];

/// Encoders that can be traced.
const CONNECTORS: [Role; 2] = [Role::Feedback, Role::OutputEncoder];

arguments! {
    /// Arguments of `encoder --vcd`: actuator, motor shaft, length of the trace.
    pub struct Args {
        /// Ordering code of the actuator.
        code: OrderCode = CODE => code,
        /// Angle of the motor shaft at which the position is latched.
        angle: Angle = ANGLE => one(read_angle),
        /// Whole turns of the motor shaft at this instant.
        turn: i64 = TURN => one(read_turn),
        /// Speed of the motor shaft.
        speed: AngularVelocity = SPEED => one(read_speed),
        /// Seed of the deviation.
        seed: Option<u64> = SEED => number,
        /// Length of the trace.
        time: Time = Argument::option("time", values::time, help::encoder_time).usually("1 ms").with("vcd") => one(read_time),
        /// Command set of an `EnDat` word.
        endat: Option<ErrorBits> = Argument::option("endat", values::set, help::encoder_endat)
            .of(ArgumentKind::Word(|| SETS.map(|(name, _)| name).to_vec())).usually("2.2").with("vcd")
            => word(|text: &str| SETS.iter().find(|(name, _)| *name == text).map(|(_, errors)| *errors)),
        /// Encoder to trace.
        connector: Option<Role> = Argument::option("connector", values::connector, help::encoder_connector)
            .of(ArgumentKind::Word(|| CONNECTORS.map(Role::id).to_vec())).usually("feedback").with("vcd")
            => word(by_id(&CONNECTORS, Role::id)),
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "encoder --vcd",
    path: "encoder/trace",
    about: requests::encoder_trace,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Media(&[media::PLAIN]),
    writes: &[OutputFile::of("vcd", &[media::PLAIN], help::encoder_vcd)],
    example: "",
    answer: Some(|inquiry| {
        let (code, trace) = found(inquiry)?;
        Ok(Answer::text(media::PLAIN, trace.vcd(&code.to_string())).saved_as(format!("{code}.vcd")))
    }),
};

/// Computes the trace.
///
/// # Errors
/// Every fault of the arguments; an encoder that the code does not have, or without digital signals; too many edges.
pub fn found(inquiry: &Inquiry<'_>) -> Result<(OrderCode, Trace), Unanswered> {
    let Args { code, angle, turn, speed, seed, time, endat, connector } = Args::read(&inquiry.given)?;
    let language = inquiry.language;
    let role = connector.unwrap_or(Role::Feedback);
    let Some(each) = fitted(&code, seed)?.into_iter().find(|each| each.role == role) else {
        return Err(Unanswered::option("connector", (encoder::no_output_encoder(language).to_owned(), None)));
    };
    let shaft = each.shaft(Shaft::new(turn, angle, speed), &code);
    let trace = each.encoder.trace(shaft, time, endat.unwrap_or(ErrorBits::Both)).map_err(|many| {
        let edges = quantities::format_significant(many.edges, 2, language);
        let fault = encoder::too_many_edges(&edges, &EDGES_MOST, language);
        Unanswered::option("time", (fault, Some(encoder::too_many_edges_hint(language).to_owned())))
    })?;
    if trace.lines.is_empty() {
        return Err(Unanswered::option("vcd", (encoder::nothing_digital(language).to_owned(), None)));
    }
    Ok((code, trace))
}

fn read_time(text: &str, language: Language) -> Result<Time, Hinted> {
    let time: Time = read_quantity(text, language)?;
    if time.si() > 0.0 && time.si() <= TRACE_MOST_S {
        return Ok(time);
    }
    Err((encoder::time_is_bounded(&TRACE_MOST_S, language), None))
}
