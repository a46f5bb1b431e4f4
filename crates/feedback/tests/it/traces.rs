//! Encoder signals read back from a trace as by a receiver: levels at edges, without knowledge of the angle.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use feedback::endat::{ErrorBits, Frame};
use feedback::ssi::SsiFormat;
use feedback::{
    Absolute, CommutationPhases, Deviation, Encoder, Interface, Protocol, Quadrature, Shaft, SinePair, SquareTracks,
    Trace, Word, commutation_sector,
};
use quantities::unit::{ARCSECOND, DEGREE, REVOLUTION_PER_MINUTE};
use quantities::{Angle, AngularVelocity, Measure, Time};

const fn sine(periods: u32, protocol: Option<Protocol>, turns: u32, steps: u32) -> Encoder {
    let absolute = match protocol {
        Some(protocol) => Some(Absolute { protocol, format: SsiFormat { turns, steps } }),
        None => None,
    };
    let commutation = match protocol {
        Some(_) => None,
        None => Some(SinePair { periods: 1, level: None }),
    };
    let pair = SinePair { periods, level: None };
    Encoder {
        interface: Interface::Sine { pair, commutation, has_reference: protocol.is_none(), absolute },
        deviation: None,
    }
}

const M512P: Encoder = sine(512, Some(Protocol::EnDat), 12, 13);
const M128S: Encoder = sine(128, Some(Protocol::Ssi), 12, 17);
const C1024: Encoder = sine(1024, None, 0, 0);
const D2048: Encoder = Encoder {
    interface: Interface::Square {
        tracks: SquareTracks { periods: 2048 },
        commutation: CommutationPhases { periods: 5 },
    },
    deviation: None,
};

fn shaft(turns: i64, degrees: f64, speed: f64) -> Shaft {
    let speed = AngularVelocity::new_in(speed, &REVOLUTION_PER_MINUTE);
    Shaft::new(turns, Angle::new_in(degrees, &DEGREE), speed)
}

fn line(trace: &Trace, name: &str) -> usize {
    trace.lines.iter().position(|line| line.name == name).unwrap()
}

/// Data at every falling edge of the clock.
fn clocked(trace: &Trace) -> Vec<bool> {
    let (clock, data) = (line(trace, "CLOCK"), line(trace, "DATA"));
    let falling = trace.edges.iter().filter(|edge| edge.line == clock && !edge.level);
    falling.map(|edge| trace.level(data, edge.time_ns - 1).unwrap()).collect()
}

fn word(bits: &[bool]) -> Word {
    bits.iter().fold(Word::empty(), |word, bit| word.bit(*bit))
}

fn count(trace: &Trace) -> i64 {
    let [a, b] = ["A", "B"].map(|name| line(trace, name));
    let mut levels = [a, b].map(|line| trace.lines[line].level);
    let mut counter = Quadrature::default();
    counter.take(levels).unwrap();
    for edge in &trace.edges {
        if let Some(which) = [a, b].iter().position(|line| *line == edge.line) {
            levels[which] = edge.level;
            counter.take(levels).unwrap();
        }
    }
    counter.count()
}

#[test]
fn a_clocked_word_is_the_position_at_its_first_falling_edge() {
    for (turns, degrees) in [(0, 0.0), (3, 12.5), (-1, 359.99), (4095, 180.0), (4096, 0.01), (123_456_789, 90.0)] {
        let at = shaft(turns, degrees, 3000.0);
        let trace = M128S.trace(at, Time::from_si(1e-4), ErrorBits::Both).unwrap();
        let bits = clocked(&trace);
        assert_eq!((bits.len(), bits[0]), (30, true));
        let absolute = M128S.absolute().unwrap();
        let (position, _) = absolute.read(word(&bits[1..]), ErrorBits::Both).unwrap();
        assert_eq!(position, absolute.format.position(at));
        assert_eq!(position.turns, turns.rem_euclid(4096).unsigned_abs());

        for errors in [ErrorBits::One, ErrorBits::Both] {
            let trace = M512P.trace(at, Time::from_si(1e-4), errors).unwrap();
            let bits = clocked(&trace);
            let absolute = M512P.absolute().unwrap();
            let before = absolute.periods_before(errors) as usize;
            assert_eq!(bits.len(), before + Frame::bits(25, errors) as usize);
            assert!(bits[8..before].iter().all(|bit| !bit), "low until the start bit");
            let (position, is_error) = absolute.read(word(&bits[before..]), errors).unwrap();
            assert_eq!((position, is_error), (absolute.format.position(at), false));
        }
    }
}

/// 3000 1/min for 20 ms is a turn: every step of it is counted, forwards and backwards, straight and bent.
#[test]
fn a_turn_has_all_its_edges_both_ways() {
    for (encoder, steps) in [(M512P, 2048), (M128S, 512), (C1024, 4096), (D2048, 8192)] {
        for (speed, sign) in [(3000.0, 1), (-3000.0, -1)] {
            for seed in [None, Some(1), Some(2)] {
                let periods = match encoder.interface {
                    Interface::Sine { pair, .. } => Some(pair.periods),
                    Interface::Square { .. } | Interface::Resolver(_) => None,
                };
                let accuracy = Angle::new_in(if periods.is_some() { 60.0 } else { 600.0 }, &ARCSECOND);
                let deviation = seed.map(|seed| Deviation::new(accuracy, periods, seed));
                let encoder = Encoder { deviation, ..encoder.clone() };
                // A little off an edge: at one, both ends of the way would be on it.
                let trace = encoder.trace(shaft(0, 17.001, speed), Time::from_si(0.02), ErrorBits::Both).unwrap();
                let counted = count(&trace);
                assert!((counted - sign * steps).abs() <= i64::from(seed.is_some()), "{counted} of {steps}");
            }
        }
    }
}

#[test]
fn the_mark_comes_once_a_turn_while_both_tracks_are_high() {
    for (encoder, mark) in [(C1024, "R"), (D2048, "Z")] {
        for speed in [3000.0, -3000.0] {
            let trace = encoder.trace(shaft(0, 90.0, speed), Time::from_si(0.04), ErrorBits::Both).unwrap();
            let [mark, a, b] = [mark, "A", "B"].map(|name| line(&trace, name));
            let rises: Vec<u64> =
                trace.edges.iter().filter(|edge| edge.line == mark && edge.level).map(|edge| edge.time_ns).collect();
            let falls: Vec<u64> =
                trace.edges.iter().filter(|edge| edge.line == mark && !edge.level).map(|edge| edge.time_ns).collect();
            assert_eq!((rises.len(), falls.len()), (2, 2));
            let middle = u64::midpoint(rises[0], falls[0]);
            assert_eq!([a, b].map(|line| trace.level(line, middle)), [Some(true); 2]);
            // A turn takes 20 ms.
            assert!(rises[1].abs_diff(rises[0] + 20_000_000) <= 1);
        }
    }
}

#[test]
fn commutation_runs_through_its_sectors_in_order() {
    for (speed, step) in [(3000.0, 1), (-3000.0, 5)] {
        let trace = D2048.trace(shaft(0, 1.0, speed), Time::from_si(0.02), ErrorBits::Both).unwrap();
        let phases = ["U", "V", "W"].map(|name| line(&trace, name));
        let mut levels = phases.map(|line| trace.lines[line].level);
        let mut sector = commutation_sector(levels).unwrap();
        let mut changes = 0;
        for edge in &trace.edges {
            if let Some(which) = phases.iter().position(|line| *line == edge.line) {
                levels[which] = edge.level;
                let next = commutation_sector(levels).unwrap();
                assert_eq!(next, (sector + step) % 6);
                (sector, changes) = (next, changes + 1);
            }
        }
        assert_eq!(changes, 30);
    }
}

#[test]
fn a_standing_shaft_has_no_edges_and_an_endless_trace_is_refused() {
    let still = D2048.trace(shaft(0, 0.0, 0.0), Time::from_si(1.0), ErrorBits::Both).unwrap();
    assert!(still.edges.is_empty() && still.lines.len() == 6);
    let long = D2048.trace(shaft(0, 0.0, 6000.0), Time::from_si(60.0), ErrorBits::Both);
    assert!(long.unwrap_err().edges > 4e7);
    assert!(D2048.trace(shaft(0, 0.0, f64::NAN), Time::from_si(1.0), ErrorBits::Both).is_err());
}
