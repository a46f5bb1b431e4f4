//! Failures of an encoder: signals of the failed encoder, the position that a drive reads from it, and detection by the
//! drive.

use crate::encoder::{Absolute, Encoder, Interface, Protocol};
use crate::endat::{self, ErrorBits, Timing};
use crate::ssi::{self, Position, monoflop};
use crate::{CommutationPhases, Quadrature, Shaft, SquareTracks, TrackingLoop, Word, commutation_sector};
use quantities::{Angle, AngularVelocity, Measure, identified};
use std::f64::consts::{PI, TAU};

identified! {
    /// Failure of an encoder.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Failure {
        /// The second track, or the sine winding of a resolver, has no signal; a square track keeps its level.
        Track = "track",
        /// Both tracks or windings have a quarter of their level.
        Amplitude = "amplitude",
        /// No signal arrives.
        Cable = "cable",
        /// One bit of each word is inverted.
        Check = "check",
        /// The encoder reports an error in its word.
        ErrorBit = "error_bit",
        /// The data line of the word remains low.
        DataLine = "data_line",
    }
}

identified! {
    /// Check by which a drive detects a failure.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Finding {
        /// √(A² + B²) is out of bounds.
        Amplitude = "amplitude",
        /// The counted angle differs from that of the commutation signals.
        Commutation = "commutation",
        /// The commutation signals all have the same level.
        Sector = "sector",
        /// A word lacks its start bit.
        Start = "start",
        /// A word has a wrong checksum.
        Check = "check",
        /// The error bits of a word are set.
        ErrorBit = "error_bit",
        /// The absolute position differs from the counted one.
        Difference = "difference",
    }
}

/// Remaining level of weak signals \[1\]. A guess.
const WEAK: f64 = 0.25;

/// Bounds of √(A² + B²) relative to the nominal amplitude: for sine tracks 170 and 750 of 500 mV, for a resolver 1070
/// and 3582 of 2900 mV.
///
/// # Source
/// Siemens, SINAMICS G130/G150 list manual (LH2), 07/2016, A5E03263479A, fault F31115
const SINE_BOUNDS: [f64; 2] = [170.0 / 500.0, 750.0 / 500.0];
const RESOLVER_BOUNDS: [f64; 2] = [1070.0 / 2900.0, 3582.0 / 2900.0];

/// Largest difference between the counted angle and that of tracks C and D \[rad of the shaft\] or of U, V, W \[rad
/// electrical\]: 15° and 60°.
///
/// # Source
/// Siemens, SINAMICS DCM list manual (LH8), 02/2015, 6RX1800-0ED76, fault F31129
const TRACK_DIFFERENCE_RAD: f64 = PI / 12.0;
const SECTOR_DIFFERENCE_RAD: f64 = PI / 3.0;

/// Time between two words \[s\]: one period of the position loop. Assumed.
const WORD_EVERY_S: f64 = 0.5e-3;

/// Limit of the samples of square edges per call; beyond it the shaft is faster than any encoder permits.
const LOOKS_MOST: f64 = 1e5;

/// Error bits of the words read, here of command set 2.2.
const ERRORS: ErrorBits = ErrorBits::Both;

impl Encoder {
    /// Iterates over the failures that the encoder can have.
    pub fn failures(&self) -> impl Iterator<Item = Failure> {
        Failure::ALL.into_iter().filter(|failure| self.can_fail(*failure))
    }

    fn can_fail(&self, failure: Failure) -> bool {
        let protocol = self.absolute().map(|absolute| absolute.protocol);
        match failure {
            Failure::Track | Failure::Cable => true,
            Failure::Amplitude => !matches!(self.interface, Interface::Square { .. }),
            Failure::Check | Failure::ErrorBit => protocol == Some(Protocol::EnDat),
            Failure::DataLine => protocol.is_some(),
        }
    }
}

/// A drive reading a failed encoder until it detects the failure.
///
/// Tracks: every edge is counted, and the arctangent of both tracks refines the count; a resolver is followed by the
/// tracking loop; a word is requested once per period of the position loop and evaluated after its arrival.
///
/// # Source
/// docs/theory/feedback.md
/// # Valid
/// The drive reacts to the first wrong sample and the first wrong word; manufacturers may wait for more
#[derive(Clone, Debug)]
pub struct Reader {
    encoder: Encoder,
    failure: Failure,
    /// Last angle measured by the encoder over any number of turns \[rad\], followed by its time \[s\].
    seen_rad: f64,
    time_s: f64,
    counter: Quadrature,
    /// Quarter of a period at the start of the count \[periods\].
    first: f64,
    tracking: TrackingLoop,
    read_rad: f64,
    /// Time of the next request for a word \[s\].
    next_s: f64,
    /// Arrival time of the requested word \[s\], and the fault that it will show.
    arriving: Option<(f64, Option<Finding>)>,
}

impl Reader {
    /// Creates a drive that has read the encoder correctly until now, when it fails.
    ///
    /// `seen` is the angle measured by the encoder over any number of turns. Returns `None` if the encoder cannot have
    /// this failure.
    #[must_use]
    pub fn new(encoder: &Encoder, failure: Failure, seen: Angle, speed: AngularVelocity, time_s: f64) -> Option<Self> {
        if !encoder.can_fail(failure) {
            return None;
        }
        let pairs = match &encoder.interface {
            Interface::Resolver(resolver) => f64::from(resolver.pole_pairs),
            Interface::Sine { .. } | Interface::Square { .. } => 1.0,
        };
        let tracking =
            TrackingLoop::turning(Angle::from_si(pairs * seen.si()), AngularVelocity::from_si(pairs * speed.si()));
        let mut reader = Self {
            encoder: encoder.clone(),
            failure,
            seen_rad: seen.si(),
            time_s,
            counter: Quadrature::default(),
            first: 0.0,
            tracking,
            read_rad: seen.si(),
            next_s: time_s,
            arriving: None,
        };
        if let Some(tracks) = reader.tracks() {
            reader.first = (4.0 * seen.si() / TAU * f64::from(tracks.periods)).floor();
            // Levels before the failure: a level changed by the failure itself counts as an edge.
            let _ = reader.counter.take(tracks.at(seen));
        }
        Some(reader)
    }

    /// Returns the counted tracks, after their comparators.
    fn tracks(&self) -> Option<SquareTracks> {
        match &self.encoder.interface {
            Interface::Sine { pair, .. } => Some(SquareTracks::from(*pair)),
            Interface::Square { tracks, .. } => Some(*tracks),
            Interface::Resolver(_) => None,
        }
    }

    /// Returns the last angle read by the drive \[rad\], over any number of turns.
    #[must_use]
    pub const fn read_rad(&self) -> f64 {
        self.read_rad
    }

    /// Advances to the angle measured by the encoder at a time, not before the last one.
    ///
    /// # Errors
    /// The check that detects the failure.
    pub fn take(&mut self, seen: Angle, time_s: f64) -> Result<(), Finding> {
        let (from, passed_s) = (self.seen_rad, time_s - self.time_s);
        (self.seen_rad, self.time_s) = (seen.si(), time_s);
        match self.encoder.interface.clone() {
            Interface::Sine { pair, commutation, absolute, .. } => {
                let sample = self.damaged(pair.unit(seen));
                self.count(from, pair.periods, |reader, at| {
                    reader.damaged(pair.unit(Angle::from_si(at))).map(|track| track >= 0.0)
                });
                let coarse = self.coarse();
                let [x, y] = sample;
                let within = y.atan2(x) / TAU;
                self.read_rad = ((coarse - within).round() + within) / f64::from(pair.periods) * TAU;
                bounded(sample, SINE_BOUNDS)?;
                if let Some(pair) = commutation {
                    let [cosine, sine] = pair.unit(seen);
                    let periods = f64::from(pair.periods);
                    if apart(periods * self.read_rad, sine.atan2(cosine)) > periods * TRACK_DIFFERENCE_RAD {
                        return Err(Finding::Commutation);
                    }
                }
                absolute.map_or(Ok(()), |absolute| self.word(absolute, pair.periods))
            }
            Interface::Square { tracks, commutation } => {
                self.count(from, tracks.periods, |reader, at| match reader.failure {
                    Failure::Cable => [true; 2],
                    _ => [tracks.at(Angle::from_si(at))[0], true],
                });
                self.read_rad = self.coarse() / f64::from(tracks.periods) * TAU;
                self.commutated(commutation, seen)
            }
            Interface::Resolver(resolver) => {
                let pairs = f64::from(resolver.pole_pairs);
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "of a period of the drive")]
                let steps = (passed_s * TrackingLoop::RATE_HZ).round().clamp(0.0, LOOKS_MOST) as u32;
                for step in 1..=steps {
                    let at = from + (seen.si() - from) * f64::from(step) / f64::from(steps);
                    let windings =
                        self.damaged(resolver.envelope(Angle::from_si(at)).map(|share| share / resolver.ratio));
                    self.read_rad = self.tracking.step(windings).angle.si() / pairs;
                }
                bounded(self.damaged(resolver.envelope(seen).map(|share| share / resolver.ratio)), RESOLVER_BOUNDS)
            }
        }
    }

    /// Returns both tracks, or sine and cosine winding, as they arrive at the drive.
    fn damaged(&self, [first, second]: [f64; 2]) -> [f64; 2] {
        let is_resolver = matches!(self.encoder.interface, Interface::Resolver(_));
        match self.failure {
            Failure::Track if is_resolver => [0.0, second],
            Failure::Track => [first, 0.0],
            Failure::Amplitude => [WEAK * first, WEAK * second],
            Failure::Cable => [0.0; 2],
            Failure::Check | Failure::ErrorBit | Failure::DataLine => [first, second],
        }
    }

    /// Counts the edges between an angle and the present one.
    fn count(&mut self, from: f64, periods: u32, levels: impl Fn(&Self, f64) -> [bool; 2]) {
        let way = self.seen_rad - from;
        let looks = (8.0 * way.abs() / TAU * f64::from(periods)).ceil().clamp(1.0, LOOKS_MOST);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bounded")]
        for look in 1..=looks as u32 {
            let found = levels(self, from + way * f64::from(look) / looks);
            // A missed edge leaves the count unchanged; another check detects the failure.
            let _ = self.counter.take(found);
        }
    }

    /// Returns the middle of the counted quarter \[periods\].
    #[allow(clippy::cast_precision_loss, reason = "edges of a shaft are far below 2^52")]
    fn coarse(&self) -> f64 {
        (self.first + self.counter.count() as f64 + 0.5) / 4.0
    }

    /// Compares the counted angle with the commutation signals.
    fn commutated(&self, commutation: CommutationPhases, seen: Angle) -> Result<(), Finding> {
        let phases = if self.failure == Failure::Cable { [true; 3] } else { commutation.at(seen) };
        let sector = commutation_sector(phases).map_err(|_| Finding::Sector)?;
        let middle = (f64::from(sector) + 0.5) * PI / 3.0;
        let counted = self.read_rad * f64::from(commutation.periods);
        if apart(counted, middle) > SECTOR_DIFFERENCE_RAD { Err(Finding::Commutation) } else { Ok(()) }
    }

    /// Requests words and evaluates each after its arrival.
    fn word(&mut self, absolute: Absolute, periods: u32) -> Result<(), Finding> {
        if let Some((arrives_s, wrong)) = self.arriving
            && self.time_s >= arrives_s
        {
            self.arriving = None;
            if let Some(finding) = wrong {
                return Err(finding);
            }
        }
        if self.arriving.is_none() && self.time_s >= self.next_s {
            self.next_s = self.time_s + WORD_EVERY_S;
            self.arriving = Some((self.time_s + absolute.lasts_s(ERRORS), self.judged(absolute, periods)));
        }
        Ok(())
    }

    /// Returns the fault of a word latched now.
    fn judged(&self, absolute: Absolute, periods: u32) -> Option<Finding> {
        let at = |rad: f64| absolute.format.position(Shaft::new(0, Angle::from_si(rad), AngularVelocity::from_si(0.0)));
        let sent = absolute.word(at(self.seen_rad), ERRORS, self.failure == Failure::ErrorBit);
        let arrived = match self.failure {
            // The inverted bit follows start bit and error bits.
            Failure::Check => sent.flipped(1 + ERRORS.count()),
            Failure::DataLine | Failure::Cable => Word::new(0, sent.len()),
            Failure::Track | Failure::Amplitude | Failure::ErrorBit => sent,
        };
        match absolute.read(arrived, ERRORS) {
            Err(faults) if faults.contains(&endat::Fault::Start) => Some(Finding::Start),
            Err(_) => Some(Finding::Check),
            Ok((_, true)) => Some(Finding::ErrorBit),
            Ok((position, false)) => {
                let counted = at(self.read_rad);
                let range = 1_u64 << absolute.format.bits();
                let difference = absolute.number(position).abs_diff(absolute.number(counted));
                // One period of the tracks: at a larger difference the count has lost an edge, or the word is wrong.
                let most = (1_u64 << absolute.format.steps) / u64::from(periods.max(1));
                (difference.min(range - difference) > most).then_some(Finding::Difference)
            }
        }
    }
}

impl Absolute {
    /// Returns the time from the first clock edge until the word has arrived and the next may be requested \[s\].
    fn lasts_s(self, errors: ErrorBits) -> f64 {
        let clocks = f64::from(self.periods_before(errors) + self.bits(errors));
        match self.protocol {
            Protocol::EnDat => {
                let timing = Timing::published(errors);
                clocks / timing.clock.si() + timing.recovery[1].si()
            }
            Protocol::Ssi => clocks / ssi::clock().si() + monoflop().si(),
        }
    }

    /// Returns the number of turns missing from the reading after battery and supply have failed together: the encoder
    /// counts from zero again, and the word itself is valid. The zero of the machine is in the middle of the range,
    /// with most turns to both sides.
    ///
    /// # Source
    /// cha-manual section 6.22: the reported position is wrong after switching on; the initial count and the position
    /// of the zero are assumed
    #[must_use]
    pub fn turns_lost(self, seen: Angle) -> Option<u64> {
        let middle = 1_i64 << (self.format.turns.checked_sub(1)?);
        let shaft = Shaft::new(middle, seen, AngularVelocity::from_si(0.0));
        let before = self.format.position(shaft);
        let after = Position { turns: 0, ..before };
        let read = |position| Some(self.read(self.word(position, ERRORS, false), ERRORS).ok()?.0.turns);
        Some(read(before)? - read(after)?)
    }
}

/// Compares √(x² + y²) with its bounds.
fn bounded([x, y]: [f64; 2], [low, high]: [f64; 2]) -> Result<(), Finding> {
    if (low..=high).contains(&x.hypot(y)) { Ok(()) } else { Err(Finding::Amplitude) }
}

/// Returns the distance of two angles on the circle \[rad\].
fn apart(one: f64, other: f64) -> f64 {
    let between = (one - other).rem_euclid(TAU);
    between.min(TAU - between)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ssi::SsiFormat;
    use crate::{Resolver, SinePair};
    use quantities::{EffectiveVoltage, Frequency};

    /// Period of a current loop at 16 kHz \[s\].
    const PERIOD_S: f64 = 62.5e-6;

    fn sine(absolute: Option<(Protocol, u32, u32)>, periods: u32) -> Encoder {
        let absolute =
            absolute.map(|(protocol, turns, steps)| Absolute { protocol, format: SsiFormat { turns, steps } });
        let commutation = absolute.is_none().then_some(SinePair { periods: 1, level: None });
        let pair = SinePair { periods, level: None };
        Encoder { interface: Interface::Sine { pair, commutation, has_reference: true, absolute }, deviation: None }
    }

    fn all() -> [Encoder; 5] {
        let square =
            Interface::Square { tracks: SquareTracks { periods: 2048 }, commutation: CommutationPhases { periods: 5 } };
        let resolver = Resolver {
            pole_pairs: 1,
            excitation: EffectiveVoltage::from_si(7.0),
            frequency: Frequency::from_si(5e3),
            ratio: 0.5,
        };
        [
            sine(None, 1024),
            sine(Some((Protocol::EnDat, 12, 13)), 512),
            sine(Some((Protocol::Ssi, 12, 17)), 128),
            Encoder { interface: square, deviation: None },
            Encoder { interface: Interface::Resolver(resolver), deviation: None },
        ]
    }

    /// Returns the check that detects the failure of an encoder on a turning shaft, and the time until then \[s\],
    /// within one second.
    fn noticed(encoder: &Encoder, failure: Failure, from: f64, speed: f64) -> (Option<(Finding, f64)>, f64) {
        let at = |time: f64| Angle::from_si(from + speed * time);
        let mut reader = Reader::new(encoder, failure, at(0.0), AngularVelocity::from_si(speed), 0.0).unwrap();
        for period in 1..=16_000 {
            let time = f64::from(period) * PERIOD_S;
            if let Err(finding) = reader.take(at(time), time) {
                return (Some((finding, time)), reader.read_rad() - at(time).si());
            }
        }
        (None, reader.read_rad() - at(1.0).si())
    }

    /// At 2000 1/min in both directions, each failure of each encoder is detected by the expected check within one
    /// turn.
    #[test]
    fn a_turning_shaft_shows_every_failure() {
        let speed = 2000.0 * TAU / 60.0;
        let mut seen = 0;
        for encoder in all() {
            for failure in encoder.failures() {
                for direction in [1.0, -1.0] {
                    let (found, _) = noticed(&encoder, failure, 0.3, direction * speed);
                    let (finding, after) = found.unwrap_or_else(|| panic!("{failure:?} of {encoder:?}"));
                    assert!(after <= TAU / speed, "{failure:?} {finding:?} {after}");
                    let is_square = matches!(encoder.interface, Interface::Square { .. });
                    let expected: &[Finding] = match failure {
                        Failure::Track if is_square => &[Finding::Commutation],
                        Failure::Cable if is_square => &[Finding::Sector],
                        Failure::Track => &[Finding::Amplitude, Finding::Difference, Finding::Commutation],
                        Failure::Amplitude | Failure::Cable => &[Finding::Amplitude],
                        Failure::Check => &[Finding::Check],
                        Failure::ErrorBit => &[Finding::ErrorBit],
                        Failure::DataLine => &[Finding::Start, Finding::Difference],
                    };
                    assert!(expected.contains(&finding), "{failure:?} {finding:?}");
                    seen += 1;
                }
            }
        }
        // A sine encoder has three failures, EnDat three more, SSI one more; square tracks have two, a resolver three.
        assert_eq!(seen, 2 * (3 + 6 + 4 + 2 + 3));
    }

    /// At rest a lost track is detected only where the other one is near zero, a lost square track never; a word is
    /// evaluated after its arrival, which for EnDat at 1 MHz takes 15 clocks, 33 bits and 3.75 µs, in the next period.
    #[test]
    fn at_rest_a_lost_track_may_stay_unseen() {
        let [sine, endat, ssi, square, resolver] = all();
        let near = |of: f64| of * TAU / 1024.0;
        assert_eq!(noticed(&sine, Failure::Track, near(0.05), 0.0).0, None);
        assert_eq!(noticed(&sine, Failure::Track, near(0.24), 0.0).0, Some((Finding::Amplitude, PERIOD_S)));
        assert_eq!(noticed(&square, Failure::Track, 0.3, 0.0).0, None);
        assert_eq!(noticed(&resolver, Failure::Track, 0.1, 0.0).0, None);
        let (found, error) = noticed(&endat, Failure::Check, 0.3, 0.0);
        let (finding, after) = found.unwrap();
        assert_eq!(finding, Finding::Check);
        assert!((after - 2.0 * PERIOD_S).abs() < 1e-12, "{after}");
        assert!(error.abs() < 1e-9, "the tracks show the angle: {error}");
        // A word of zeros is correct at zero, and SSI has no checksum.
        assert_eq!(noticed(&ssi, Failure::DataLine, 1e-6, 0.0).0, None);
        let (found, _) = noticed(&ssi, Failure::DataLine, 1.0, 0.0);
        assert_eq!(found.map(|(finding, _)| finding), Some(Finding::Difference));
    }

    /// After the loss of a track the count stays unchanged while the shaft turns on.
    #[test]
    fn the_angle_that_is_read_stands_still_without_a_track() {
        let square = &all()[3];
        let speed = 1000.0 * TAU / 60.0;
        let (found, error) = noticed(square, Failure::Track, 0.0, speed);
        let (_, after) = found.unwrap();
        assert!((error + speed * after).abs() < TAU / 2048.0, "{error}");
        // Between 30° and 90° of the 72° of one commutation period.
        let electrical = (5.0 * speed * after).to_degrees();
        assert!((30.0..=92.0).contains(&electrical), "{electrical}");
    }

    /// If the tracks have not failed, the drive reads the angle at any speed.
    #[test]
    fn what_has_not_failed_is_read_right() {
        let ssi = &all()[2];
        for speed in [0.0, 3.0, -300.0, 700.0] {
            let at = |time: f64| 5.0 * TAU + 0.3 + speed * time;
            let rate = AngularVelocity::from_si(speed);
            let mut reader = Reader::new(ssi, Failure::DataLine, Angle::from_si(at(0.0)), rate, 0.0).unwrap();
            for period in 1..=5 {
                let time = f64::from(period) * PERIOD_S / 5.0;
                assert_eq!(reader.take(Angle::from_si(at(time)), time), Ok(()));
                assert!((reader.read_rad() - at(time)).abs() < 1e-9, "{speed}");
            }
        }
    }

    /// 4096 turns with zero in their middle: 2048 are lost; an encoder without turns loses none.
    #[test]
    fn a_lost_battery_leaves_a_valid_word() {
        let of = |turns| Absolute { protocol: Protocol::Ssi, format: SsiFormat { turns, steps: 17 } };
        assert_eq!(of(12).turns_lost(Angle::from_si(0.1)), Some(2048));
        assert_eq!(of(12).turns_lost(Angle::from_si(-0.1)), Some(2047));
        assert_eq!(of(0).turns_lost(Angle::from_si(0.1)), None);
    }
}
