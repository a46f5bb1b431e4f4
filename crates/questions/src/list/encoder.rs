//! `encoder CODE`: signals and words of the encoders at an angle, and decoding of a word.

use super::given::{Hinted, arguments, code, flag, number, one, some};
use super::{Answer, Argument, ArgumentKind, CODE, Entry, Gives, Inquiry, Reads, Record, Unanswered};
use crate::answer;
use crate::chapters::read_quantity;
use crate::sizing_use::Refusal;
use feedback::{BitsFault, Protocol, Shaft, Word};
use installation::encoder::{Fitted, encoders};
use order_code::OrderCode;
use quantities::unit::{DEGREE, REVOLUTION, REVOLUTION_PER_MINUTE};
use quantities::{Angle, AngularVelocity, Language, Measure, seen};
use words::help::values;
use words::{encoder, help};

/// Largest number of turns of a shaft.
const TURNS_MOST: i64 = 1_000_000_000_000;

/// Largest number of turns in an angle.
const ANGLE_MOST_TURNS: f64 = 1e6;

/// Largest speed of a motor \[1/min\].
const SPEED_MOST_PER_MIN: f64 = 1e6;

pub(super) const ANGLE: Argument =
    Argument::option("angle", values::angle, help::encoder_angle).signed().usually("0 deg");
pub(super) const TURN: Argument = Argument::option("turn", values::n, help::encoder_turn).signed().usually("0");
pub(super) const SPEED: Argument =
    Argument::option("speed", values::speed, help::encoder_speed).signed().usually("0 1/min");
pub(super) const SEED: Argument =
    Argument::option("seed", values::n, help::encoder_seed).of(ArgumentKind::Whole(0, u64::MAX));

arguments! {
    /// Arguments of `encoder`: actuator, motor shaft, and the output.
    pub struct Args {
        /// Ordering code of the actuator.
        code: OrderCode = CODE => code,
        /// Angle of the motor shaft.
        angle: Angle = ANGLE => one(read_angle),
        /// Whole turns of the motor shaft.
        turn: i64 = TURN => one(read_turn),
        /// Speed of the motor shaft.
        speed: AngularVelocity = SPEED => one(read_speed),
        /// Seed of the deviation.
        seed: Option<u64> = SEED => number,
        /// Angle over which signals are shown.
        window: Option<Angle> = Argument::option("window", values::angle, help::encoder_window) => some(read_window),
        /// Simultaneous failure of battery and supply.
        battery_lost: bool = Argument::flag("battery-lost", help::encoder_battery_lost) => flag,
        /// Error reported by the encoder.
        error: bool = Argument::flag("error", help::encoder_error) => flag,
        /// Word to decode.
        decode: Option<Word> = Argument::option("decode", values::bits, help::encoder_decode) => some(read_word),
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "encoder",
    path: "encoder",
    about: help::encoder,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Encoder>("encoder")),
    writes: &[],
    example: "CHA-25A-100-H-M512P --angle \"12.5 deg\" --turn 3",
    answer: Some(|inquiry| {
        let found = found(inquiry)?;
        let fits = is_right(&found);
        Ok(Answer::record(&found).fits(fits))
    }),
};

/// Returns `true` if the decoded word is valid, or none was given.
#[must_use]
pub fn is_right(found: &answers::Encoder) -> bool {
    found.decoded.as_ref().is_none_or(|decoded| decoded.valid)
}

/// Returns the signals and words of the encoders.
///
/// # Errors
/// Every fault of the arguments; a word, an error or a battery that the encoders do not have; no data in the manual.
pub fn found(inquiry: &Inquiry<'_>) -> Result<answers::Encoder, Unanswered> {
    let args = Args::read(&inquiry.given)?;
    let fitted = fitted(&args.code, args.seed)?;
    let language = inquiry.language;
    let absolute = || fitted.iter().filter_map(|each| each.encoder.absolute());
    let has_endat = absolute().any(|absolute| absolute.protocol == Protocol::EnDat);
    let is_buffered = fitted.iter().any(|each| each.feedback.buffered_by_battery);
    Unanswered::unless_right([
        ("decode", args.decode.is_some() && absolute().next().is_none(), encoder::no_word_to_decode(language)),
        ("error", args.error && !has_endat, encoder::no_error_to_report(language)),
        ("battery-lost", args.battery_lost && !is_buffered, encoder::no_battery_to_lose(language)),
    ])?;
    let motor = Shaft::new(args.turn, args.angle, args.speed);
    let refused = || Unanswered::from(Refusal::NoData);
    answer::encoder(&args, &fitted, motor, language).ok_or_else(refused)
}

/// Returns the encoders of a code, with the deviations of a seed if one is given.
///
/// # Errors
/// No data in the manual.
pub(super) fn fitted(code: &OrderCode, seed: Option<u64>) -> Result<Vec<Fitted>, Unanswered> {
    let fitted = encoders(code).ok_or(Refusal::NoData)?;
    Ok(match seed {
        Some(seed) => fitted.into_iter().map(|each| each.deviating(seed)).collect(),
        None => fitted,
    })
}

/// Parses the angle of the motor shaft.
pub(super) fn read_angle(text: &str, language: Language) -> Result<Angle, Hinted> {
    let angle: Angle = read_quantity(text, language)?;
    if angle.in_unit(&REVOLUTION).abs() <= ANGLE_MOST_TURNS {
        return Ok(angle);
    }
    Err((encoder::angle_is_bounded(&ANGLE_MOST_TURNS, language), None))
}

/// Parses the whole turns of the motor shaft.
pub(super) fn read_turn(text: &str, language: Language) -> Result<i64, Hinted> {
    let turn = text.trim().parse::<i64>().ok();
    let fault = || (encoder::turn_is_whole(&TURNS_MOST, language), None);
    turn.filter(|turn| (-TURNS_MOST..=TURNS_MOST).contains(turn)).ok_or_else(fault)
}

/// Parses the speed of the motor shaft.
pub(super) fn read_speed(text: &str, language: Language) -> Result<AngularVelocity, Hinted> {
    let speed: AngularVelocity = read_quantity(text, language)?;
    if speed.in_unit(&REVOLUTION_PER_MINUTE).abs() <= SPEED_MOST_PER_MIN {
        return Ok(speed);
    }
    Err((encoder::speed_is_bounded(&SPEED_MOST_PER_MIN, language), None))
}

fn read_window(text: &str, language: Language) -> Result<Angle, Hinted> {
    let window: Angle = read_quantity(text, language)?;
    let degrees = window.in_unit(&DEGREE);
    // A full turn in another unit may exceed the limit by rounding.
    if degrees > 0.0 && degrees <= 360.0 + 1e-9 {
        return Ok(window);
    }
    Err((encoder::window_is_bounded(language).to_owned(), None))
}

fn read_word(text: &str, language: Language) -> Result<Word, Hinted> {
    text.parse().map_err(|fault| {
        let fault = match fault {
            BitsFault::Empty => encoder::word_is_empty(language).to_owned(),
            BitsFault::Sign(sign, place) => {
                encoder::bits_are_0_and_1(&seen(sign.encode_utf8(&mut [0; 4])), &place, language)
            }
            BitsFault::TooLong => encoder::word_is_too_long(&Word::MOST, language),
        };
        (fault, None)
    })
}
