//! Signals and words of encoders as a record.

use super::facts::facts;
use crate::list::encoder::Args;
use answers::{
    DecodedWord, EncoderAssumption, EncoderCarrier, EncoderCurve, EncoderPin, EncoderShaft, EncoderSignal,
    EncoderState, EncoderWord, Id, Number, SignalForm, WordFault, WordField,
};
use catalogue::{Cell, Topic};
use feedback::endat::{CRC_BITS, ErrorBits, Fault, Mode, Opening, Parameter, Timing};
use feedback::ssi::Position;
use feedback::{Absolute, Interface, Protocol, Shaft, Signal, SinePair, Value, Windings, Word};
use installation::encoder::{Fitted, STEPS_OF_A_PERIOD};
use installation::facts::{Order, facts_about};
use installation::wiring::{CodeWiring, Role, wiring};
use provenance::Source;
use quantities::unit::{ARCSECOND, DEGREE, KILOHERTZ, MICROSECOND, REVOLUTION_PER_MINUTE, VOLT};
use quantities::{Angle, Language, Measure, Time};
use std::f64::consts::TAU;
use words::encoder;

/// Number of points of a curve.
const POINTS: u32 = 129;

/// Largest number of periods in a curve: with fewer points per period the curve would show another signal.
const PERIODS_MOST: f64 = 16.0;

/// Position words of `EnDat`, in the order of the answer.
const ENDAT: [(&str, ErrorBits, Mode); 2] = [
    ("endat_2_2_position", ErrorBits::Both, Mode::PositionInfo),
    ("endat_2_1_position", ErrorBits::One, Mode::Position),
];

/// Returns the signals of the encoders of a code; `None` if the manual states no wiring.
#[must_use]
pub fn encoder(args: &Args, fitted: &[Fitted], motor: Shaft, language: Language) -> Option<answers::Encoder> {
    let wiring = wiring(&args.code)?;
    let of = |each: &Fitted| {
        let shaft = each.shaft(motor, &args.code);
        // The revolution counter of a buffered encoder is lost with battery and supply.
        let is_lost = args.battery_lost && each.feedback.buffered_by_battery;
        let counted = if is_lost { Shaft::new(0, shaft.angle(), shaft.speed()) } else { shaft };
        state(each, shaft, counted, args, &wiring, language)
    };
    let (first, second) = (fitted.first()?, fitted.get(1));
    let mut assumed: Vec<_> = fitted.iter().flat_map(|each| each.assumed(args.battery_lost)).collect();
    assumed.sort_unstable();
    assumed.dedup();
    let mut errata: Vec<&'static str> =
        fitted.iter().flat_map(|each| &each.cells).flat_map(|cell| cell.errata).copied().collect();
    errata.sort_unstable();
    errata.dedup();
    // Among the facts on one subject, those on commissioning are worded for the programmer of a controller.
    let mut rules = facts_about(Topic::Commission, &args.code, Order::Data);
    rules.retain(|fact| ["6.22", "6.25"].iter().any(|section| fact.section.starts_with(section)));
    Some(answers::Encoder {
        code: args.code.to_string(),
        feedback: args.code.feedback.as_str(),
        seed: args.seed,
        motor: of(first),
        output_encoder: second.map(of),
        decoded: args.decode.map(|word| decoded(word, fitted, language)),
        assumptions: assumed
            .into_iter()
            .map(|what| EncoderAssumption {
                id: Id(what),
                text: encoder::assumed(what, language).to_owned(),
                grade: Id(encoder::assumed_grade(what)),
            })
            .collect(),
        notes: notes(args, fitted, motor, language),
        rules: facts(&rules, language),
        errata,
        trace: None,
    })
}

fn notes(args: &Args, fitted: &[Fitted], motor: Shaft, language: Language) -> Vec<String> {
    let mut notes = Vec::new();
    for each in fitted {
        let turns = each.shaft(motor, &args.code).turns();
        let is_ssi = each.encoder.absolute().is_some_and(|absolute| absolute.protocol == Protocol::Ssi);
        if is_ssi && args.decode.is_some() {
            notes.push(encoder::ssi_has_no_check(language).to_owned());
        }
        match each.turns() {
            Some(count) if args.battery_lost && each.feedback.buffered_by_battery && count > 1 => {
                notes.push(encoder::battery_lost(language).to_owned());
            }
            Some(count) if count > 1 && u64::try_from(turns).map_or(true, |turns| turns >= count) => {
                notes.push(encoder::overflow(&turns, &(count - 1), language));
            }
            Some(_) => {}
            None if !each.feedback.single_turn_absolute => notes.push(encoder::incremental_only(language).to_owned()),
            None => {}
        }
    }
    notes
}

fn state(
    each: &Fitted,
    shaft: Shaft,
    counted: Shaft,
    args: &Args,
    wiring: &CodeWiring,
    language: Language,
) -> EncoderState {
    let seen = each.encoder.seen(counted);
    let words = each
        .encoder
        .absolute()
        .map_or_else(Vec::new, |absolute| words(absolute, absolute.format.position(seen), args.error, language));
    let signals = each
        .encoder
        .signals()
        .into_iter()
        .map(|signal| (signal.id(), self::signal(each, signal, shaft, args.window, wiring, language)));
    let has_turns = each.turns().is_some_and(|turns| turns > 1);
    EncoderState {
        connector: Id(each.role),
        type_printed: each.cell("manufacturer_type", "").map(|cell| cell.corrected),
        shaft: EncoderShaft {
            turns: shaft.turns(),
            angle_deg: Number::in_unit(shaft.angle().si(), &DEGREE),
            speed_per_min: Number::in_unit(shaft.speed().si(), &REVOLUTION_PER_MINUTE),
            seen_deg: Number::in_unit(seen.angle().si(), &DEGREE),
            accuracy_arcsec: each.accuracy().map(|accuracy| Number::in_unit(accuracy.si(), &ARCSECOND)),
            absolute_turns: each.turns(),
            turns_valid: has_turns.then_some(!(args.battery_lost && each.feedback.buffered_by_battery)),
            increments: increments(each, each.encoder.seen(shaft)),
        },
        words,
        signals: signals.collect(),
        carrier: carrier(each, shaft),
        table_of_pins: wiring.connector(each.role).map(|connector| connector.table.id),
    }
}

/// Returns two periods of the excitation.
fn carrier(each: &Fitted, shaft: Shaft) -> Option<EncoderCarrier> {
    let Interface::Resolver(resolver) = &each.encoder.interface else { return None };
    let times = (0..POINTS).map(|point| 2.0 / resolver.frequency.si() * f64::from(point) / f64::from(POINTS - 1));
    let at = |seconds: f64| {
        let time = Time::from_si(seconds);
        (time, resolver.at(each.encoder.seen(shaft.after(time)).angle(), time))
    };
    let found: Vec<_> = times.map(at).collect();
    let volts = |of: fn(&Windings) -> f64| found.iter().map(|(_, windings)| Number(of(windings))).collect();
    Some(EncoderCarrier {
        frequency_khz: Number::in_unit(resolver.frequency.si(), &KILOHERTZ),
        time_us: found.iter().map(|(time, _)| Number::in_unit(time.si(), &MICROSECOND)).collect(),
        excitation_v: volts(|windings| windings.excitation.si()),
        sine_v: volts(|windings| windings.sine.si()),
        cosine_v: volts(|windings| windings.cosine.si()),
    })
}

/// Returns the steps since zero.
fn increments(each: &Fitted, seen: Shaft) -> Option<i64> {
    let steps = match &each.encoder.interface {
        Interface::Sine { pair, .. } => u64::from(pair.periods) * u64::from(STEPS_OF_A_PERIOD),
        Interface::Square { tracks, .. } => u64::from(tracks.periods) * 4,
        Interface::Resolver(_) => return None,
    };
    let turns = i64::try_from(steps).ok()?.checked_mul(seen.turns())?;
    turns.checked_add_unsigned(seen.step(steps))
}

fn words(absolute: Absolute, position: Position, is_error: bool, language: Language) -> Vec<EncoderWord> {
    match absolute.protocol {
        Protocol::EnDat => ENDAT
            .iter()
            .map(|(name, errors, mode)| {
                let timing = Timing::published(*errors);
                let bits = absolute.word(position, *errors, is_error);
                EncoderWord {
                    name,
                    title: title(name, language).to_owned(),
                    protocol: Id(absolute.protocol),
                    bits: bits.to_string(),
                    crc: Some(bits.part(bits.len() - CRC_BITS, CRC_BITS).to_string()),
                    command: Some(mode.word().to_string()),
                    fields: position_fields(absolute, bits, *errors, language),
                    clocks_before: absolute.periods_before(*errors),
                    clock_khz: Number::in_unit(timing.clock.si(), &KILOHERTZ),
                    recovery_us: timing.recovery.map(|time| Number::in_unit(time.si(), &MICROSECOND)),
                    calculation_us: Some(Number::in_unit(timing.calculation.si(), &MICROSECOND)),
                }
            })
            .collect(),
        Protocol::Ssi => {
            let bits = absolute.word(position, ErrorBits::One, false);
            let monoflop = Number::in_unit(feedback::ssi::monoflop().si(), &MICROSECOND);
            vec![EncoderWord {
                name: SSI,
                title: title(SSI, language).to_owned(),
                protocol: Id(absolute.protocol),
                bits: bits.to_string(),
                crc: None,
                command: None,
                fields: position_fields(absolute, bits, ErrorBits::One, language),
                clocks_before: absolute.periods_before(ErrorBits::One),
                clock_khz: Number::in_unit(feedback::ssi::clock().si(), &KILOHERTZ),
                recovery_us: [monoflop; 2],
                calculation_us: None,
            }]
        }
    }
}

const SSI: &str = "ssi_position";
const PARAMETER: &str = "endat_parameter";
const INFORMATION: &str = "endat_additional_information";
const COMMAND: &str = "endat_mode_command";

fn title(name: &str, language: Language) -> &'static str {
    match name {
        SSI => encoder::ssi(language),
        PARAMETER => encoder::endat_parameter(language),
        INFORMATION => encoder::endat_information(language),
        COMMAND => encoder::endat_command(language),
        "endat_2_1_position" => encoder::endat_2_1(language),
        _ => encoder::endat_2_2(language),
    }
}

/// Splits a word into its fields.
fn fields(word: Word, parts: &[(&'static str, &'static str, u32, bool)]) -> Vec<WordField> {
    let mut first = 0;
    let part = |(name, title, len, is_low_first): &(&'static str, &'static str, u32, bool)| {
        let bits = word.part(first, *len);
        let value = if *is_low_first { bits.number_low_first() } else { bits.number() };
        let field = WordField { name, title, first, bits: bits.to_string(), value };
        first += len;
        field
    };
    parts.iter().map(part).collect()
}

fn position_fields(absolute: Absolute, word: Word, errors: ErrorBits, language: Language) -> Vec<WordField> {
    let format = absolute.format;
    match absolute.protocol {
        Protocol::EnDat => {
            let mut parts = vec![("start", encoder::field_start(language), 1, false)];
            parts.push(("error_1", encoder::field_error_1(language), 1, false));
            if errors == ErrorBits::Both {
                parts.push(("error_2", encoder::field_error_2(language), 1, false));
            }
            parts.push(("position", encoder::field_position(language), format.bits(), true));
            parts.push(("crc", encoder::field_crc(language), CRC_BITS, false));
            fields(word, &parts)
        }
        Protocol::Ssi => fields(
            word,
            &[
                ("turns", encoder::field_turns(language), format.turns, false),
                ("step", encoder::field_step(language), format.steps, false),
            ],
        ),
    }
}

fn signal(
    each: &Fitted,
    signal: Signal,
    shaft: Shaft,
    window: Option<Angle>,
    wiring: &CodeWiring,
    language: Language,
) -> EncoderSignal {
    let pins = each.pins(signal, wiring);
    let carried = pins.iter().find_map(|pin| pin.carries);
    let at = |angle: Angle| each.encoder.at(signal, each.encoder.seen(Shaft::new(0, angle, shaft.speed())).angle());
    let now = at(shaft.angle());
    let pair: Option<&SinePair> = match (&each.encoder.interface, signal) {
        (Interface::Sine { pair, .. }, Signal::A | Signal::B) => Some(pair),
        (Interface::Sine { commutation, .. }, Signal::C | Signal::D) => commutation.as_ref(),
        (Interface::Sine { .. } | Interface::Square { .. } | Interface::Resolver(_), _) => None,
    };
    let level = pair.and_then(|pair| pair.level);
    let periods = each.encoder.periods(signal);
    let cell = source(each, signal);
    EncoderSignal {
        meaning: carried.map_or_else(String::new, |carried| {
            let whole = installation::wiring::WiringSignal { polarity: None, ..carried };
            words::wiring::signal_meaning(whole, language)
        }),
        pins: pins.iter().map(|pin| EncoderPin { pin: pin.name.clone(), signal: pin.printed() }).collect(),
        form: form(signal, now),
        value: now.map(number),
        unit: match now {
            Some(Value::Voltage(_)) => VOLT.json,
            Some(Value::Level(_) | Value::Share(_)) => "1",
            None => "",
        },
        level_v: level.map(|level| Number(level.nominal.si())),
        level_bounds_v: level.and_then(|level| level.bounds).map(|bounds| bounds.map(|volts| Number(volts.si()))),
        periods_per_turn: periods,
        source: cell.map_or_else(String::new, |cell| words::source_text(&Source::Cell(&cell.place), language)),
        errata: cell.map_or_else(Vec::new, |cell| cell.errata.to_vec()),
        curve: shown_periods(each, signal).and_then(|periods| curve(shaft, periods, window, &at)),
    }
}

/// Returns the periods of a signal that its curve shows: for a mark, which is as short as a period of the tracks, those
/// of the tracks.
fn shown_periods(each: &Fitted, signal: Signal) -> Option<u32> {
    each.encoder.periods(if matches!(signal, Signal::R | Signal::Z) { Signal::A } else { signal })
}

const fn form(signal: Signal, now: Option<Value>) -> SignalForm {
    match (now, signal) {
        (Some(Value::Voltage(_)), Signal::Sine | Signal::Cosine) => SignalForm::PeakVoltage,
        (Some(Value::Voltage(_)), _) => SignalForm::Voltage,
        (Some(Value::Level(_)), _) => SignalForm::Level,
        (Some(Value::Share(_)), _) => SignalForm::Share,
        (None, _) => SignalForm::Other,
    }
}

fn number(value: Value) -> Number {
    Number(match value {
        Value::Voltage(volts) => volts.si(),
        Value::Level(is_high) => f64::from(u8::from(is_high)),
        Value::Share(share) => share,
    })
}

/// Returns the source cell of a signal.
fn source(each: &Fitted, signal: Signal) -> Option<&'static Cell> {
    match signal {
        Signal::A | Signal::B => each.cell("u_pp", "incremental").or_else(|| each.cell("n_1_lines", "")),
        Signal::C | Signal::D => each.cell("u_pp", "commutation"),
        Signal::U | Signal::V | Signal::W => each.cell("n_2_lines", ""),
        Signal::R | Signal::Z => each.cell("n_3_lines", ""),
        Signal::Sine | Signal::Cosine => each.cell("transformation_ratio", ""),
        Signal::Excitation => each.cell("U_b", ""),
        Signal::Clock | Signal::Data => each.cell("protocol", ""),
    }
}

/// Returns the course of a signal around the position of the shaft, which is in the middle.
fn curve(
    shaft: Shaft,
    periods: u32,
    window: Option<Angle>,
    at: &dyn Fn(Angle) -> Option<Value>,
) -> Option<EncoderCurve> {
    let of_two = (2.0 * TAU / f64::from(periods)).min(TAU);
    let window = window.map_or(of_two, |window| window.si().min(TAU));
    if window / TAU * f64::from(periods) > PERIODS_MOST + 1e-9 {
        return None;
    }
    let offsets = (0..POINTS).map(|point| window * (f64::from(point) / f64::from(POINTS - 1) - 0.5));
    let point = |offset: f64| {
        let value = at(Angle::from_si(shaft.angle().si() + offset))?;
        Some((Number::in_unit(offset, &DEGREE), number(value)))
    };
    let (offset_deg, value) = offsets.map(point).collect::<Option<Vec<_>>>()?.into_iter().unzip();
    Some(EncoderCurve { offset_deg, value })
}

/// Returns the content of a word of the kind that its length indicates.
fn decoded(word: Word, fitted: &[Fitted], language: Language) -> DecodedWord {
    let sending = fitted.iter().filter_map(|each| Some((each.role, each.encoder.absolute()?)));
    let sending: Vec<(Role, Absolute)> = sending.collect();
    for (role, absolute) in &sending {
        let kinds: &[(&str, ErrorBits)] = match absolute.protocol {
            Protocol::EnDat => &ENDAT.map(|(name, errors, _)| (name, errors)),
            Protocol::Ssi => &[(SSI, ErrorBits::One)],
        };
        for (name, errors) in kinds {
            if word.len() == absolute.bits(*errors) {
                return position(word, (name, *role), *absolute, *errors, language);
            }
        }
    }
    let endat = sending.iter().find(|(_, absolute)| absolute.protocol == Protocol::EnDat);
    match (endat, word.len()) {
        (Some((role, _)), Parameter::BITS) => parameter(word, *role, language),
        (Some((role, _)), 6) => command(word, *role, language),
        _ => {
            let expected = sending.first().map_or(0, |(_, absolute)| absolute.bits(ErrorBits::Both));
            let fault = Fault::Length { found: word.len(), expected };
            DecodedWord { faults: vec![word_fault(&fault, language)], ..unread(word) }
        }
    }
}

/// Returns a record for a word of unknown content.
fn unread(word: Word) -> DecodedWord {
    DecodedWord {
        name: None,
        title: None,
        connector: None,
        bits: word.to_string(),
        valid: false,
        fields: Vec::new(),
        turns: None,
        angle_deg: None,
        encoder_error: None,
        faults: Vec::new(),
    }
}

fn named(word: Word, (name, role): (&'static str, Role), language: Language) -> DecodedWord {
    let title = Some(title(name, language).to_owned());
    DecodedWord { name: Some(name), title, connector: Some(Id(role)), ..unread(word) }
}

fn position(
    word: Word,
    name: (&'static str, Role),
    absolute: Absolute,
    errors: ErrorBits,
    language: Language,
) -> DecodedWord {
    let read = absolute.read(word, errors);
    let mut found =
        DecodedWord { fields: position_fields(absolute, word, errors, language), ..named(word, name, language) };
    match read {
        Ok((position, is_error)) => {
            #[allow(clippy::cast_precision_loss, reason = "a step of the turn")]
            let share = position.step as f64 / (1_u64 << absolute.format.steps) as f64;
            found.turns = (absolute.format.turns > 0).then_some(position.turns);
            found.angle_deg = Some(Number(share * 360.0));
            found.encoder_error = (absolute.protocol == Protocol::EnDat).then_some(is_error);
            if is_error {
                found.faults.push(WordFault {
                    id: "encoder_error",
                    message: encoder::fault_reported(language).to_owned(),
                    hint: Some(encoder::fault_reported_hint(language).to_owned()),
                });
            }
        }
        Err(faults) => found.faults = faults.iter().map(|fault| word_fault(fault, language)).collect(),
    }
    found.valid = found.faults.is_empty();
    found
}

fn parameter(word: Word, role: Role, language: Language) -> DecodedWord {
    let is_parameter = word.part(0, 1).number() == 1;
    let (name, opening) =
        if is_parameter { (PARAMETER, Opening::Parameter) } else { (INFORMATION, Opening::Information) };
    let faults = Parameter::read(word, opening).err().unwrap_or_default();
    let parts = [
        ("start", encoder::field_start(language), 1, false),
        ("head", encoder::field_head(language), 8, false),
        ("value", encoder::field_value(language), 16, false),
        ("crc", encoder::field_crc(language), CRC_BITS, false),
    ];
    DecodedWord {
        fields: fields(word, &parts),
        valid: faults.is_empty(),
        faults: faults.iter().map(|fault| word_fault(fault, language)).collect(),
        ..named(word, (name, role), language)
    }
}

fn command(word: Word, role: Role, language: Language) -> DecodedWord {
    let faults = match Mode::of(word) {
        Some(_) => Vec::new(),
        None => vec![WordFault { id: "command", message: encoder::fault_command(language).to_owned(), hint: None }],
    };
    DecodedWord {
        fields: fields(
            word,
            &[(Mode::of(word).map_or("command", Mode::id), encoder::field_command(language), 6, false)],
        ),
        valid: faults.is_empty(),
        faults,
        ..named(word, (COMMAND, role), language)
    }
}

fn word_fault(fault: &Fault, language: Language) -> WordFault {
    let (id, message, hint) = match fault {
        Fault::Length { found, expected } => ("length", encoder::fault_length(found, expected, language), None),
        Fault::Start => ("start", encoder::fault_start(language).to_owned(), Some(encoder::fault_start_hint(language))),
        Fault::ErrorBitsAlike => {
            ("error_bits_alike", encoder::fault_alike(language).to_owned(), Some(encoder::fault_alike_hint(language)))
        }
        Fault::Crc { found, expected } => {
            let bits = |crc: u8| format!("{crc:05b}");
            let message = encoder::fault_crc(&bits(*found), &bits(*expected), language);
            ("crc", message, Some(encoder::fault_crc_hint(language)))
        }
    };
    WordFault { id, message, hint: hint.map(str::to_owned) }
}
