//! An encoder with its tracks and its interface.

use crate::endat::{self, ErrorBits, Frame, Mode, Timing};
use crate::square::{HIGH, Window, phase};
use crate::ssi::{self, Position, SsiFormat, monoflop};
use crate::trace::{Clocked, EDGES_MOST, Edge, Line, TooManyEdges, Trace};
use crate::{CommutationPhases, Deviation, Resolver, Shaft, SinePair, SquareTracks, Word};
use quantities::{Angle, ElectricPotential, Measure, Time, identified};
use std::f64::consts::{SQRT_2, TAU};

/// Time before the first clock edge that a trace shows \[ns\]; the position is latched at its end.
const REST_NS: u64 = 1000;

/// Upper limit of the duration of a trace \[s\], so that its nanoseconds are exact.
const SECONDS_MOST: f64 = 1e6;

/// An encoder with its interface and its deviation.
#[derive(Clone, Debug, PartialEq)]
pub struct Encoder {
    /// Signals and telegrams of the encoder.
    pub interface: Interface,
    /// Deviation of the measured from the true angle; `None` for an ideal encoder.
    pub deviation: Option<Deviation>,
}

/// Signals and telegrams of an encoder.
#[derive(Clone, Debug, PartialEq)]
pub enum Interface {
    /// Sine tracks.
    Sine {
        /// Incremental tracks.
        pair: SinePair,
        /// Commutation tracks.
        commutation: Option<SinePair>,
        /// A reference mark is available at the connector.
        has_reference: bool,
        /// Absolute position.
        absolute: Option<Absolute>,
    },
    /// Square-wave tracks with a zero pulse.
    Square {
        /// Incremental tracks.
        tracks: SquareTracks,
        /// Commutation signals.
        commutation: CommutationPhases,
    },
    /// Resolver windings.
    Resolver(Resolver),
}

/// An absolute position transmitted as a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Absolute {
    /// Protocol of transmission.
    pub protocol: Protocol,
    /// Number of bits of turns and angle.
    pub format: SsiFormat,
}

identified! {
    /// Protocol of a position word.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Protocol {
        /// `EnDat` 2.2.
        EnDat = "endat",
        /// SSI.
        Ssi = "ssi",
    }
}

identified! {
    /// A signal of an encoder; the difference voltage if it has a pair of pins. The identifier is the name of the pins
    /// in the manual without polarity.
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

/// Value of a signal at an angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// Voltage between the two pins; for a resolver, at the peak of the excitation.
    Voltage(ElectricPotential),
    /// High (`true`) or low.
    Level(bool),
    /// Value relative to an amplitude that the manual does not state.
    Share(f64),
}

impl Encoder {
    /// Returns the shaft as measured by the encoder, including the deviation.
    #[must_use]
    pub fn seen(&self, shaft: Shaft) -> Shaft {
        let deviation = self.deviation.as_ref().map_or(0.0, |deviation| deviation.at(shaft.angle()).si());
        Shaft::new(shaft.turns(), Angle::from_si(shaft.angle().si() + deviation), shaft.speed())
    }

    /// Returns the signals of the encoder.
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

    /// Returns the periods of a signal per turn; `None` if it has none.
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

    /// Returns the value of a signal at an angle measured by the encoder; `None` for signals independent of the angle.
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

    /// Returns the periods per turn of a digital signal and the part of a period in which it is high; sine tracks pass
    /// a comparator at zero.
    fn window(&self, signal: Signal) -> Option<(u32, Window)> {
        let periods = self.periods(signal)?;
        let [u, v, w] = CommutationPhases::HIGH;
        // A mark is centred between the peaks of both tracks, where both are high: at 45° of the first period.
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

    /// Returns the absolute position that the encoder transmits.
    #[must_use]
    pub const fn absolute(&self) -> Option<Absolute> {
        match &self.interface {
            Interface::Sine { absolute, .. } => *absolute,
            Interface::Square { .. } | Interface::Resolver(_) => None,
        }
    }

    /// Returns the digital signals while the shaft turns at its speed, and a word whose position is latched where the
    /// shaft stands; for `EnDat`, in answer to the command with these error bits. Sine tracks pass a comparator at
    /// zero; a resolver has no digital signal.
    ///
    /// # Errors
    /// A trace with more edges than [`EDGES_MOST`].
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

    /// Returns the edges of a signal during a rotation from an angle: the share of the rotation at each edge, and the
    /// level after it.
    #[allow(clippy::cast_possible_truncation, reason = "the number of edges was counted")]
    fn edges(&self, from_rad: f64, turned: f64, periods: u32, window: Window) -> Vec<(f64, bool)> {
        let periods = f64::from(periods);
        let (low, high) = (from_rad.min(from_rad + turned), from_rad.max(from_rad + turned));
        // A deviation shifts an edge by less than a thousandth of a turn and, for the finest tracks, by less than a
        // period.
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
    /// Returns the position as one number, turns above the steps of the turn.
    #[must_use]
    pub const fn number(self, position: Position) -> u64 {
        position.turns << self.format.steps | position.step
    }

    /// Splits a number into turns and step.
    #[must_use]
    pub const fn position(self, number: u64) -> Position {
        Position {
            turns: number >> self.format.steps & ((1 << self.format.turns) - 1),
            step: number & ((1 << self.format.steps) - 1),
        }
    }

    /// Returns the number of bits of the word.
    #[must_use]
    pub const fn bits(self, errors: ErrorBits) -> u32 {
        match self.protocol {
            Protocol::EnDat => Frame::bits(self.format.bits(), errors),
            Protocol::Ssi => self.format.bits(),
        }
    }

    /// Returns the word of a position; for `EnDat`, with these error bits, set if `is_error`.
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

    /// Returns the clock periods of a transmission before the first bit of its word.
    ///
    /// SSI: one, which latches the position. `EnDat`: two, six for the command, two in which the line changes
    /// direction, and those until the position is computed
    #[must_use]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a handful")]
    pub fn periods_before(self, errors: ErrorBits) -> u32 {
        let timing = Timing::published(errors);
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
                let timing = Timing::published(errors);
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

    /// Reads a position word; the flag is `true` if the encoder reports an error.
    ///
    /// # Errors
    /// The faults of the word.
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
