//! An encoder with its tracks and its interface.

use crate::endat::{self, ErrorBits, Frame, Mode, Timing};
use crate::square::{HIGH, Window, phase};
use crate::ssi::{self, Format, Position, monoflop};
use crate::trace::{Clocked, EDGES_MOST, Edge, Line, TooManyEdges, Trace};
use crate::{CommutationPhases, Deviation, Resolver, Shaft, SinePair, SquareTracks, Word};
use quantities::{Angle, ElectricPotential, Measure, Time, identified};
use std::f64::consts::{SQRT_2, TAU};

/// Time for which a trace shows the lines before the first edge of the clock \[ns\]; at its end the position is latched.
const REST_NS: u64 = 1000;

/// The longest trace \[s\]: its nanoseconds are exact.
const SECONDS_MOST: f64 = 1e6;

/// An encoder.
#[derive(Clone, Debug, PartialEq)]
pub struct Encoder {
    /// What it sends.
    pub interface: Interface,
    /// How it deviates from the angle; `None`: not at all.
    pub deviation: Option<Deviation>,
}

/// What an encoder sends.
#[derive(Clone, Debug, PartialEq)]
pub enum Interface {
    /// Sine tracks.
    Sine {
        /// The incremental tracks.
        pair: SinePair,
        /// The commutation tracks.
        commutation: Option<SinePair>,
        /// Whether a reference mark is led out.
        has_reference: bool,
        /// The absolute position.
        absolute: Option<Absolute>,
    },
    /// Square tracks with a zero pulse.
    Square {
        /// The incremental tracks.
        tracks: SquareTracks,
        /// The commutation signals.
        commutation: CommutationPhases,
    },
    /// Windings of a resolver.
    Resolver(Resolver),
}

/// An absolute position that is sent as a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Absolute {
    /// How.
    pub protocol: Protocol,
    /// Its bits.
    pub format: Format,
}

identified! {
    /// The protocol of a word.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Protocol {
        /// `EnDat` 2.2.
        EnDat = "endat",
        /// SSI.
        Ssi = "ssi",
    }
}

identified! {
    /// A signal of an encoder; of those led out as a pair, the difference. Its identifier is the name printed on the pins
    /// without its polarity.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Signal {
        /// First incremental track.
        A = "A",
        /// Second incremental track.
        B = "B",
        /// First commutation track.
        C = "C",
        /// Second commutation track.
        D = "D",
        /// Reference mark.
        R = "R",
        /// Zero pulse.
        Z = "Z",
        /// Commutation signal of phase U.
        U = "U",
        /// Commutation signal of phase V.
        V = "V",
        /// Commutation signal of phase W.
        W = "W",
        /// Sine winding.
        Sine = "SIN",
        /// Cosine winding.
        Cosine = "COS",
        /// Excitation.
        Excitation = "Vss",
        /// Clock of the serial interface.
        Clock = "CLOCK",
        /// Data of the serial interface.
        Data = "DATA",
    }
}

/// What a signal shows at an angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A voltage between its two pins; of a resolver at the peak of the excitation.
    Voltage(ElectricPotential),
    /// High or low.
    Level(bool),
    /// A part of its amplitude, which is not printed.
    Share(f64),
}

impl Encoder {
    /// The shaft as the encoder sees it.
    #[must_use]
    pub fn seen(&self, shaft: Shaft) -> Shaft {
        let deviation = self.deviation.as_ref().map_or(0.0, |deviation| deviation.at(shaft.angle()).si());
        Shaft::new(shaft.turns(), Angle::from_si(shaft.angle().si() + deviation), shaft.speed())
    }

    /// Its signals.
    #[must_use]
    pub fn signals(&self) -> Vec<Signal> {
        Signal::ALL.into_iter().filter(|signal| self.has(*signal)).collect()
    }

    fn has(&self, signal: Signal) -> bool {
        match &self.interface {
            Interface::Sine { commutation, has_reference, absolute, .. } => match signal {
                Signal::A | Signal::B => true,
                Signal::C | Signal::D => commutation.is_some(),
                Signal::R => *has_reference,
                Signal::Clock | Signal::Data => absolute.is_some(),
                Signal::Z | Signal::U | Signal::V | Signal::W => false,
                Signal::Sine | Signal::Cosine | Signal::Excitation => false,
            },
            Interface::Square { .. } => match signal {
                Signal::A | Signal::B | Signal::Z | Signal::U | Signal::V | Signal::W => true,
                Signal::C | Signal::D | Signal::R | Signal::Clock | Signal::Data => false,
                Signal::Sine | Signal::Cosine | Signal::Excitation => false,
            },
            Interface::Resolver(_) => matches!(signal, Signal::Sine | Signal::Cosine | Signal::Excitation),
        }
    }

    /// Periods per turn of a signal; `None` where it has none.
    #[must_use]
    pub fn periods(&self, signal: Signal) -> Option<u32> {
        match (&self.interface, signal) {
            (Interface::Sine { pair, .. }, Signal::A | Signal::B) => Some(pair.periods),
            (Interface::Sine { commutation, .. }, Signal::C | Signal::D) => commutation.map(|pair| pair.periods),
            (Interface::Sine { has_reference, .. }, Signal::R) => has_reference.then_some(1),
            (Interface::Square { tracks, .. }, Signal::A | Signal::B) => Some(tracks.periods),
            (Interface::Square { .. }, Signal::Z) => Some(1),
            (Interface::Square { commutation, .. }, Signal::U | Signal::V | Signal::W) => Some(commutation.periods),
            (Interface::Resolver(resolver), Signal::Sine | Signal::Cosine) => Some(resolver.pole_pairs),
            (Interface::Sine { .. } | Interface::Square { .. } | Interface::Resolver(_), _) => None,
        }
    }

    /// A signal at an angle that the encoder sees; `None` for those that do not follow the angle.
    #[must_use]
    pub fn at(&self, signal: Signal, seen: Angle) -> Option<Value> {
        let of_pair = |pair: &SinePair, which: usize| {
            let share = pair.unit(seen).get(which).copied()?;
            let voltage = |peak: ElectricPotential| Value::Voltage(ElectricPotential::from_si(share * peak.si()));
            Some(pair.amplitude().map_or(Value::Share(share), voltage))
        };
        match (&self.interface, signal) {
            (Interface::Sine { pair, .. }, Signal::A) => of_pair(pair, 0),
            (Interface::Sine { pair, .. }, Signal::B) => of_pair(pair, 1),
            (Interface::Sine { commutation, .. }, Signal::C) => of_pair(commutation.as_ref()?, 0),
            (Interface::Sine { commutation, .. }, Signal::D) => of_pair(commutation.as_ref()?, 1),
            (Interface::Resolver(resolver), Signal::Sine | Signal::Cosine) => {
                let [sine, cosine] = resolver.envelope(seen);
                let share = if signal == Signal::Sine { sine } else { cosine };
                Some(Value::Voltage(ElectricPotential::from_si(share * resolver.excitation.si() * SQRT_2)))
            }
            (Interface::Sine { .. } | Interface::Square { .. } | Interface::Resolver(_), _) => {
                let (periods, window) = self.window(signal)?;
                Some(Value::Level(window.holds(phase(seen, periods))))
            }
        }
    }

    /// Where a digital signal is high, and its periods per turn; of sine tracks behind a comparator at zero.
    fn window(&self, signal: Signal) -> Option<(u32, Window)> {
        let periods = self.periods(signal)?;
        let [u, v, w] = CommutationPhases::HIGH;
        // A mark lies where both tracks are high, in the middle between their peaks: 45° of the first period.
        let mark = |width: f64| {
            let tracks = f64::from(self.periods(Signal::A)?);
            Some(Window { middle: 0.125 / tracks, width: width / tracks })
        };
        let window = match signal {
            Signal::A | Signal::C => HIGH[0],
            Signal::B | Signal::D => HIGH[1],
            Signal::R => mark(0.5)?,
            Signal::Z => mark(0.25)?,
            Signal::U => u,
            Signal::V => v,
            Signal::W => w,
            Signal::Sine | Signal::Cosine | Signal::Excitation | Signal::Clock | Signal::Data => return None,
        };
        Some((periods, window))
    }

    /// The absolute position that is sent.
    #[must_use]
    pub const fn absolute(&self) -> Option<Absolute> {
        match &self.interface {
            Interface::Sine { absolute, .. } => *absolute,
            Interface::Square { .. } | Interface::Resolver(_) => None,
        }
    }

    /// The digital signals while the shaft turns at its speed, and a word whose position is latched where the shaft stands; for
    /// `EnDat` in answer to this command. Sine tracks are shown behind a comparator at zero; a resolver has no digital signal.
    ///
    /// # Errors
    /// More edges than a trace may have.
    pub fn trace(&self, shaft: Shaft, time: Time, errors: ErrorBits) -> Result<Trace, TooManyEdges> {
        #[allow(clippy::cast_precision_loss, reason = "a microsecond")]
        let start = shaft.after(Time::from_si(-(REST_NS as f64) * 1e-9));
        let tracks = self.tracks(start, time)?;
        let Some(absolute) = self.absolute() else { return Ok(tracks) };
        let position = absolute.format.position(self.seen(shaft));
        Ok(tracks.with(absolute.transmission(position, errors)))
    }

    fn tracks(&self, start: Shaft, time: Time) -> Result<Trace, TooManyEdges> {
        let digital = self.signals().into_iter().filter_map(|signal| Some((signal, self.window(signal)?)));
        let digital: Vec<(Signal, (u32, Window))> = digital.collect();
        let (seconds, speed) = (time.si().max(0.0), start.speed().si());
        let turned = speed * seconds;
        let edges: f64 = digital.iter().map(|(_, (periods, _))| 2.0 * f64::from(*periods) * turned.abs() / TAU).sum();
        #[allow(clippy::cast_precision_loss, reason = "a million")]
        if !(edges <= EDGES_MOST as f64 && seconds <= SECONDS_MOST) {
            return Err(TooManyEdges { edges });
        }
        let seen = self.seen(start).angle();
        let mut trace = Trace { end_ns: nanoseconds(seconds), ..Trace::default() };
        for (line, (signal, (periods, window))) in digital.into_iter().enumerate() {
            let mut level = window.holds(phase(seen, periods));
            trace.lines.push(Line { name: signal.id(), level });
            if speed == 0.0 {
                continue;
            }
            let mut found = self.edges(start.angle().si(), turned, periods, window);
            found.sort_by(|a, b| a.0.total_cmp(&b.0));
            for (share, high) in found {
                if high != level {
                    level = high;
                    trace.edges.push(Edge { time_ns: nanoseconds(share * seconds), line, level });
                }
            }
        }
        trace.edges.sort_by_key(|edge| (edge.time_ns, edge.line));
        Ok(trace)
    }

    /// The edges of a signal on the way from an angle: the share of the way, and the level behind them.
    #[allow(clippy::cast_possible_truncation, reason = "the number of edges was counted")]
    fn edges(&self, from_rad: f64, turned: f64, periods: u32, window: Window) -> Vec<(f64, bool)> {
        let periods = f64::from(periods);
        let (low, high) = (from_rad.min(from_rad + turned), from_rad.max(from_rad + turned));
        // A deviation moves an edge by less than a thousandth of a turn and, of the finest tracks, by a period.
        let margin = if self.deviation.is_some() { 2.0 + periods / 500.0 } else { 2.0 };
        let first = (low / TAU * periods - margin).floor() as i64;
        let last = (high / TAU * periods + margin).ceil() as i64;
        let [begin, end] = window.ends();
        let mut found = Vec::new();
        for period in first..=last {
            for (at, is_begin) in [(begin, true), (end, false)] {
                #[allow(clippy::cast_precision_loss, reason = "the number of edges was counted")]
                let seen = (period as f64 + at) / periods * TAU;
                let angle = self.deviation.as_ref().map_or(seen, |d| d.true_angle(Angle::from_si(seen)).si());
                let share = (angle - from_rad) / turned;
                if (0.0..=1.0).contains(&share) {
                    found.push((share, is_begin == (turned > 0.0)));
                }
            }
        }
        found
    }
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "not negative and bounded")]
fn nanoseconds(seconds: f64) -> u64 {
    (seconds * 1e9).round() as u64
}

impl Absolute {
    /// The position as one number, turns above the steps of the turn.
    #[must_use]
    pub const fn number(self, position: Position) -> u64 {
        position.turns << self.format.steps | position.step
    }

    /// The parts of a number.
    #[must_use]
    pub const fn position(self, number: u64) -> Position {
        Position {
            turns: number >> self.format.steps & ((1 << self.format.turns) - 1),
            step: number & ((1 << self.format.steps) - 1),
        }
    }

    /// Bits of its word.
    #[must_use]
    pub const fn bits(self, errors: ErrorBits) -> u32 {
        match self.protocol {
            Protocol::EnDat => Frame::bits(self.format.bits(), errors),
            Protocol::Ssi => self.format.bits(),
        }
    }

    /// The word of a position; for `EnDat` with these error bits, which report an error or none.
    #[must_use]
    pub fn word(self, position: Position, errors: ErrorBits, is_error: bool) -> Word {
        match self.protocol {
            Protocol::EnDat => {
                let frame = Frame { position: self.number(position), is_error };
                frame.word(self.format.bits(), errors)
            }
            Protocol::Ssi => self.format.word(position),
        }
    }

    /// Clock periods of a transmission before the first bit of its word.
    ///
    /// SSI: one that latches. `EnDat`: two, six of the command, two in which the line changes its direction, and those until the
    /// position is computed
    #[must_use]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a handful")]
    pub fn periods_before(self, errors: ErrorBits) -> u32 {
        let timing = Timing::usual(errors);
        match self.protocol {
            Protocol::EnDat => 10 + (timing.calculation.si() * timing.clock.si()).round() as u32,
            Protocol::Ssi => 1,
        }
    }

    fn transmission(self, position: Position, errors: ErrorBits) -> Trace {
        let word = self.word(position, errors, false);
        let before = self.periods_before(errors);
        match self.protocol {
            Protocol::Ssi => {
                let mut line = Clocked::at_rest(nanoseconds(0.5 / ssi::clock().si()), REST_NS, true);
                line.idle();
                word.iter().for_each(|bit| line.bit(bit));
                line.hold(false, nanoseconds(monoflop().si()));
                line.done(REST_NS, true)
            }
            Protocol::EnDat => {
                let timing = Timing::usual(errors);
                let mode = match errors {
                    ErrorBits::One => Mode::Position,
                    ErrorBits::Both => Mode::PositionInfo,
                };
                let mut line = Clocked::at_rest(nanoseconds(0.5 / timing.clock.si()), REST_NS, false);
                line.idle();
                line.idle();
                mode.word().iter().for_each(|bit| line.bit(bit));
                (8..before).for_each(|_| line.bit(false));
                word.iter().for_each(|bit| line.bit(bit));
                let [_, longest] = timing.recovery;
                line.hold(true, nanoseconds(longest.si()));
                line.done(REST_NS, false)
            }
        }
    }

    /// Reads a word of the position.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn read(self, word: Word, errors: ErrorBits) -> Result<(Position, bool), Vec<endat::Fault>> {
        match self.protocol {
            Protocol::EnDat => {
                let frame = Frame::read(word, self.format.bits(), errors)?;
                Ok((self.position(frame.position), frame.is_error))
            }
            Protocol::Ssi => {
                let read = self.format.read(word).map(|position| (position, false));
                read.map_err(|ssi::WrongLength { found, expected }| vec![endat::Fault::Length { found, expected }])
            }
        }
    }
}
