//! Encoder words: any text is read or refused, a word read equals the word sent, and a trace keeps its order.

use crate::text::{any_edits, mutate, rest};
use arbitrary::{Result, Unstructured};
use feedback::endat::{ErrorBits, Frame, Opening, Parameter};
use feedback::ssi::SsiFormat;
use feedback::{
    Absolute, CommutationPhases, Deviation, Encoder, Interface, Protocol, Shaft, SinePair, SquareTracks, Word,
};
use quantities::{Angle, AngularVelocity, Measure, Time};

/// Tests a word of an encoder with edits, or any text; then a turning shaft.
pub fn run(data: &[u8]) {
    let mut u = Unstructured::new(data);
    if let Ok(text) = text(&mut u)
        && let Ok(word) = text.parse::<Word>()
    {
        read(word);
    }
    let _ = turn(&mut u);
}

/// Returns the text of a case.
pub fn shown(data: &[u8]) -> String {
    text(&mut Unstructured::new(data)).unwrap_or_default()
}

const ABSOLUTE: [Absolute; 3] = [
    Absolute { protocol: Protocol::EnDat, format: SsiFormat { turns: 12, steps: 13 } },
    Absolute { protocol: Protocol::EnDat, format: SsiFormat { turns: 0, steps: 13 } },
    Absolute { protocol: Protocol::Ssi, format: SsiFormat { turns: 12, steps: 17 } },
];

const SETS: [ErrorBits; 2] = [ErrorBits::One, ErrorBits::Both];

fn text(u: &mut Unstructured<'_>) -> Result<String> {
    if u.ratio(1, 4)? {
        return Ok(rest(u));
    }
    let absolute = u.choose(&ABSOLUTE)?;
    let position = absolute.position(u.arbitrary()?);
    let word = absolute.word(position, *u.choose(&SETS)?, u.arbitrary()?).to_string();
    let edits = any_edits(u, 4)?;
    Ok(mutate(&word, &edits))
}

/// Checks that reading a word and sending the result gives the same word.
fn read(word: Word) {
    assert_eq!(word.to_string().parse(), Ok(word));
    for absolute in ABSOLUTE {
        for errors in SETS {
            match absolute.read(word, errors) {
                Ok((position, is_error)) => assert_eq!(absolute.word(position, errors, is_error), word),
                Err(faults) => assert!(!faults.is_empty()),
            }
        }
        let width = absolute.format.bits();
        if let Ok(frame) = Frame::read(word, width, ErrorBits::Both) {
            assert!((0..word.len()).all(|bit| Frame::read(word.flipped(bit), width, ErrorBits::Both).is_err()));
            assert_eq!(frame.word(width, ErrorBits::Both), word);
        }
    }
    for opening in [Opening::Parameter, Opening::Information] {
        if let Ok(parameter) = Parameter::read(word, opening) {
            assert_eq!(parameter.word(opening), word);
        }
    }
}

fn encoder(u: &mut Unstructured<'_>) -> Result<Encoder> {
    let periods = *u.choose(&[128, 512, 1024, 2048])?;
    let interface = if u.arbitrary()? {
        Interface::Square { tracks: SquareTracks { periods }, commutation: CommutationPhases { periods: 5 } }
    } else {
        let absolute = if u.arbitrary()? { Some(*u.choose(&ABSOLUTE)?) } else { None };
        let commutation = absolute.is_none().then_some(SinePair { periods: 1, level: None });
        Interface::Sine {
            pair: SinePair { periods, level: None },
            commutation,
            has_reference: absolute.is_none(),
            absolute,
        }
    };
    let of_sines = matches!(interface, Interface::Sine { .. }).then_some(periods);
    let deviation =
        if u.arbitrary()? { Some(Deviation::new(Angle::from_si(1e-4), of_sines, u.arbitrary()?)) } else { None };
    Ok(Encoder { interface, deviation })
}

/// Checks that the levels of a line alternate, edges are in order and within the trace, and the word in it is that of
/// the position.
fn turn(u: &mut Unstructured<'_>) -> Result<()> {
    let encoder = encoder(u)?;
    let turns: i64 = u.arbitrary()?;
    let any =
        |u: &mut Unstructured<'_>, size: f64| -> Result<f64> { Ok(f64::from(u.arbitrary::<i16>()?) / 32_768.0 * size) };
    let speed = if u.ratio(1, 8)? { u.arbitrary()? } else { any(u, 700.0)? };
    let angle = if u.ratio(1, 8)? { u.arbitrary()? } else { any(u, 10.0)? };
    let shaft = Shaft::new(turns, Angle::from_si(angle), AngularVelocity::from_si(speed));
    let time = Time::from_si(any(u, 1e-3)?.abs());
    let Ok(trace) = encoder.trace(shaft, time, ErrorBits::Both) else { return Ok(()) };
    let mut levels: Vec<bool> = trace.lines.iter().map(|line| line.level).collect();
    let mut now = 0;
    for edge in &trace.edges {
        assert!(edge.time_ns >= now && edge.time_ns <= trace.end_ns, "{edge:?}");
        now = edge.time_ns;
        if let Some(level) = levels.get_mut(edge.line) {
            assert_ne!(*level, edge.level, "{edge:?}");
            *level = edge.level;
        }
    }
    assert!(trace.vcd("x").ends_with('\n'));
    Ok(())
}
