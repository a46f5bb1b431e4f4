//! Motion given by samples instead of a law.

use crate::examination::Stamps;
use crate::faults::RecordedFault;
use crate::held::{Interpolated, Updated, held, interpolated, interpolated_position};
use crate::joint::joint;
use crate::outliers::{OutlyingColumn, OutlyingValues};
use crate::remarks::{Remark, of_stamps, of_standstill};
use crate::resolution::{
    MadeUp, NOTABLE, Spurious, SteppedColumn, made_up, made_up_by_noise, made_up_by_updates, mean_interval,
    median_interval, noise_beside,
};
use crate::samples::{HeldValues, Samples, TimeStamps, Treatment};
use crate::settled::{SlowMotion, slow_motion, stop_at_rests};
use crate::smoothing::{end_error, slope_error, slope_error_at_end, smooth_by};
use crate::sparse::{SparseSamples, sparse};
use crate::standstill::{Alternating, RestNoise, alternating, rests, still};
use crate::threshold::set_to_rest;
use crate::timing::{SpeedOverTime, evenly_spaced, with_time};
use quantities::Measure;
use std::sync::Arc;

/// Largest permitted difference of recorded and integrated position, relative to the travel; beyond it one of them must
/// be wrong.
const CONTRADICTION: f64 = 0.05;

/// Largest permitted difference, relative to the travel, where recorded and integrated position differ by a factor alone.
const CONTRADICTION_BY_FACTOR: f64 = 0.02;

/// Difference that a factor leaves, relative to that without it.
const LEFT: f64 = 0.25;

/// A recorded motion: speed and torque are linear between two samples, so that the acceleration is constant there.
///
/// α = (ω_(k+1) − ω_k)/(t_(k+1) − t_k)
///
/// # Source
/// docs/theory/recorded-motion.md
/// # Valid
/// the position is the recorded one at the samples; without a recorded speed it is differentiated, without a recorded
/// position the speed is integrated
#[derive(Clone, Debug, PartialEq)]
pub struct Recorded {
    time_s: Arc<Vec<f64>>,
    position_rad: Arc<Vec<f64>>,
    speed_rad_s: Arc<Vec<f64>>,
    torque_nm: Option<Arc<Vec<f64>>>,
    is_placed: bool,
    end_errors_rad_s: (f64, f64),
    rest_noise: Option<RestNoise>,
    alternating: Option<Alternating>,
    slow_motion: Option<SlowMotion>,
    made_up: Option<MadeUp>,
    sparse: Option<SparseSamples>,
    outliers: Vec<OutlyingValues>,
    torque_noise_nm: f64,
    remarks: Vec<Remark>,
    rests: bool,
    turns: bool,
    hidden_rad_s: f64,
}

impl Recorded {
    /// Creates a motion from samples.
    ///
    /// In this order: the time stamps become even, if stated; held values are interpolated, if stated; rest is sought; the
    /// window smooths; noise at rest becomes zero. A spurious acceleration is sought in the course that results, without
    /// those causes that a key has taken out: held values first, then scattered stamps, then steps; the first found is the
    /// one reported.
    ///
    /// # Errors
    /// Returns the first [`RecordedFault`].
    pub fn new(samples: Samples, treatment: Treatment) -> Result<Self, RecordedFault> {
        let columns = [&samples.position_rad, &samples.speed_rad_s, &samples.torque_nm];
        check(&samples.time_s, columns.map(Option::as_ref), treatment.time_stamps)?;
        let mut samples = samples;
        let start = samples.time_s.first().copied().unwrap_or(0.0);
        if start != 0.0 {
            samples.time_s = Arc::new(samples.time_s.iter().map(|t| t - start).collect());
        }
        let outliers = outliers(&samples);
        let mut remarks = Vec::new();
        let stamps = (treatment.time_stamps == TimeStamps::Even).then(|| Arc::clone(&samples.time_s));
        if stamps.is_some() {
            samples.time_s = evenly_spaced(&samples.time_s)?;
        }
        let window = treatment.smoothing.map(Measure::si);
        let is_placed = samples.position_rad.is_some();
        if let (Some(position), Some(speed)) = (&samples.position_rad, &samples.speed_rad_s) {
            agree(&samples.time_s, position, speed)?;
        }
        let held_are_interpolated = treatment.held_values == HeldValues::Interpolated;
        let open = Course::of(&samples, window, held_are_interpolated, None)?;
        let gap = window.filter(|_| treatment.repeats).and_then(|window| open.gap(&samples, window));
        let derived = match gap {
            Some(gap) => Course::of(&samples, window, held_are_interpolated, Some(gap))?,
            None => open,
        };
        let made_up = derived.spurious(&samples, window, treatment);
        remarks.extend((held_are_interpolated && !derived.is_held(&samples)).then_some(Remark::NotHeld));
        if let Some(stamps) = stamps {
            let signal = samples.position_rad.as_ref().or(samples.speed_rad_s.as_ref());
            remarks.extend(of_stamps(&stamps, &samples.time_s, signal.map(|signal| signal.as_slice())));
        }
        let differentiated = samples.speed_rad_s.is_none();
        // No window and no interpolation changes where the axis is at rest: both make noise resemble a slow motion.
        let before = match (window, treatment.standstill) {
            (None, None) => derived.updated.as_ref().map(|updated| updated.rests(&samples.time_s)),
            (Some(_), None) => {
                let plain = Course::of(&samples, None, held_are_interpolated, None)?;
                let position = plain.position.as_deref().map(Vec::as_slice);
                let mut found = rests(&samples.time_s, &plain.speed, position, differentiated).unwrap_or_default();
                found.extend(plain.updated.into_iter().flat_map(|updated| updated.rests(&samples.time_s)));
                Some(found)
            }
            (_, Some(_)) => None,
        };
        let Samples { time_s, torque_nm, .. } = samples;
        let Course { position, mut speed, mut end_errors, closed, .. } = derived;
        let largest = |speed: &[f64]| speed.iter().fold(0.0_f64, |most, speed| most.max(speed.abs()));
        let before_standstill = treatment.standstill.map_or(0.0, |_| largest(&speed));
        let mut rest_noise = None;
        if let Some(least) = treatment.standstill {
            let without = SpeedOverTime { time: &time_s, speed: &speed }.largest_acceleration();
            let block = window.map_or(0.0, |window| window / median_interval(&time_s)).ceil() as usize;
            set_to_rest(Arc::make_mut(&mut speed).as_mut_slice(), least.si(), block);
            remarks.extend(of_standstill(least.si(), SpeedOverTime { time: &time_s, speed: &speed }, without));
        } else if let Some((rests, noise)) = still(
            &time_s,
            &speed,
            position.as_deref().map(Vec::as_slice),
            differentiated,
            before.as_deref().map(|before| (window.unwrap_or(0.0), before)),
        ) {
            let speed = Arc::make_mut(&mut speed);
            for rest in rests {
                speed.get_mut(rest).into_iter().flatten().for_each(|speed| *speed = 0.0);
            }
            // A sample before the first rest or behind the last may be noise of it.
            end_errors = (end_errors.0 + noise.speed_rad_s, end_errors.1 + noise.speed_rad_s);
            rest_noise = Some(noise);
        }
        let alternating = treatment.standstill.is_none().then(|| alternating(&speed)).flatten();
        // Alternating speeds are reported as such.
        let slow_motion = (treatment.standstill.is_none() && alternating.is_none())
            .then(|| slow_motion(&time_s, &speed, position.as_deref().map(Vec::as_slice)))
            .flatten();
        let position = position.unwrap_or_else(|| Arc::new(integral(&time_s, &speed)));
        let between = |torque: &Arc<Vec<f64>>| held_are_interpolated.then(|| interpolated(&time_s, torque)).flatten();
        let torque_nm = torque_nm.map(|torque| between(&torque).map_or(torque, Arc::new));
        let torque_nm = match (torque_nm, window) {
            (Some(torque), Some(window)) => Some(Arc::new(smooth_by(&time_s, &torque, window, closed.map(|_| 0.0))?.0)),
            (torque, _) => torque,
        };
        let made_up = made_up.map(|made_up| made_up.while_moving(&speed));
        // Noise makes the differences larger, and a window leaves out what it is stated for.
        let is_plain = made_up.is_none() && window.is_none() && !held_are_interpolated;
        let sparse = is_plain.then(|| match is_placed && differentiated {
            true => sparse(&time_s, &position, SteppedColumn::Position),
            false => sparse(&time_s, &speed, SteppedColumn::Speed),
        });
        let torque_noise_nm = torque_nm.as_ref().map_or(0.0, |torque| noise_beside(&time_s, torque));
        let rests = speed.windows(2).any(|ends| ends == [0.0; 2]);
        let turns = speed.iter().any(|speed| *speed != 0.0);
        Ok(Self {
            time_s,
            position_rad: position,
            speed_rad_s: speed,
            torque_nm,
            is_placed,
            end_errors_rad_s: end_errors,
            rest_noise,
            alternating,
            slow_motion,
            made_up,
            sparse: sparse.flatten(),
            outliers,
            torque_noise_nm,
            remarks,
            rests,
            turns,
            hidden_rad_s: if turns { 0.0 } else { before_standstill },
        })
    }

    /// Returns the samples at the input of a stage that turns `ratio` times as far; the torque remains that of the
    /// mechanism.
    pub(crate) fn geared(&self, ratio: f64) -> Self {
        let times = |values: &[f64]| Arc::new(values.iter().map(|value| value * ratio).collect());
        Self { position_rad: times(&self.position_rad), speed_rad_s: times(&self.speed_rad_s), ..self.clone() }
    }

    /// Returns `true` if the axis rests between two neighbouring samples, at any pace.
    #[must_use]
    pub const fn rests(&self) -> bool {
        self.rests
    }

    /// Returns `true` if the axis turns between two neighbouring samples, at any pace.
    #[must_use]
    pub const fn turns(&self) -> bool {
        self.turns
    }

    /// Returns the largest speed \[rad/s\] of a recording that does not turn because of the stated standstill; zero for
    /// all others.
    #[must_use]
    pub const fn hidden_rad_s(&self) -> f64 {
        self.hidden_rad_s
    }

    /// Returns the instants from the first sample \[s\].
    #[must_use]
    pub fn time_s(&self) -> &[f64] {
        &self.time_s
    }

    /// Returns the positions \[rad\].
    #[must_use]
    pub fn position_rad(&self) -> &[f64] {
        &self.position_rad
    }

    /// Returns the speeds [rad/s].
    #[must_use]
    pub fn speed_rad_s(&self) -> &[f64] {
        &self.speed_rad_s
    }

    /// Returns the standard deviation of the white noise of the recorded torques \[Nm\], if its largest values are notable beside
    /// the largest torque; else zero.
    #[must_use]
    pub const fn torque_noise_nm(&self) -> f64 {
        self.torque_noise_nm
    }

    /// Returns the torques \[Nm\], if they are recorded.
    #[must_use]
    pub fn torque_nm(&self) -> Option<&[f64]> {
        self.torque_nm.as_ref().map(|torque| torque.as_slice())
    }

    /// Returns `true` if positions are recorded and thus determine the position of the axis; speeds alone determine
    /// only the travel.
    #[must_use]
    pub const fn is_placed(&self) -> bool {
        self.is_placed
    }

    /// Returns the duration \[s\].
    #[must_use]
    pub fn duration_s(&self) -> f64 {
        self.time_s.last().copied().unwrap_or(0.0)
    }

    /// Returns the positions at the first and the last sample \[rad\].
    #[must_use]
    pub fn ends_rad(&self) -> (f64, f64) {
        ends(&self.position_rad)
    }

    /// Returns the speeds at the first and the last sample [rad/s].
    #[must_use]
    pub fn end_speeds_rad_s(&self) -> (f64, f64) {
        ends(&self.speed_rad_s)
    }

    /// Returns the errors of the speeds at the first and the last sample [rad/s]: that of the slope of positions, zero
    /// if the speed is recorded, and the noise found at rest.
    ///
    /// h_0 (h_0 + h_1) |q'''|/3, for equal steps 2/3 h² |q'''|: twice the error of a cubic; q''' from the third
    /// difference of the four samples at the end
    #[must_use]
    pub const fn end_errors_rad_s(&self) -> (f64, f64) {
        self.end_errors_rad_s
    }

    /// Returns the noise at rest that was set to zero, if there is any.
    #[must_use]
    pub const fn rest_noise(&self) -> Option<RestNoise> {
        self.rest_noise
    }

    /// Returns the speeds that alternate in sign and count as motion, if they are frequent and no `standstill` is stated.
    #[must_use]
    pub const fn alternating(&self) -> Option<Alternating> {
        self.alternating
    }

    /// Returns the slow motion that counts as motion and may be meant as rest, if there is any and no `standstill` is stated.
    #[must_use]
    pub const fn slow_motion(&self) -> Option<SlowMotion> {
        self.slow_motion
    }

    /// Returns the spurious acceleration caused by the resolution of the samples, if it is significant.
    #[must_use]
    pub const fn made_up(&self) -> Option<MadeUp> {
        self.made_up
    }

    /// Returns the values far beside those before and behind, of each column that has some.
    #[must_use]
    pub fn outliers(&self) -> &[OutlyingValues] {
        &self.outliers
    }

    /// Returns the samples as sparse ones, if they are too far apart for the acceleration of their motion.
    #[must_use]
    pub const fn sparse(&self) -> Option<SparseSamples> {
        self.sparse
    }

    /// Returns the remarks on keys that do not do what they are stated for.
    #[must_use]
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// Returns the number of samples.
    #[must_use]
    pub fn len(&self) -> usize {
        self.time_s.len()
    }

    /// Returns `false`: a recording has at least three samples.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.time_s.is_empty()
    }
}

/// Returns the outliers of the columns as they were recorded.
fn outliers(samples: &Samples) -> Vec<OutlyingValues> {
    let Samples { time_s, position_rad, speed_rad_s, torque_nm } = samples;
    let columns = [
        (position_rad, OutlyingColumn::Position),
        (speed_rad_s, OutlyingColumn::Speed),
        (torque_nm, OutlyingColumn::Torque),
    ];
    let of = |(values, column): (&Option<Arc<Vec<f64>>>, _)| OutlyingValues::of(time_s, values.as_deref()?, column);
    columns.into_iter().filter_map(of).collect()
}

/// Position and speed at each sample, before rest is detected.
struct Course {
    /// Positions \[rad\], if they are recorded.
    position: Option<Arc<Vec<f64>>>,
    /// Speeds [rad/s].
    speed: Arc<Vec<f64>>,
    /// Errors of the speeds at both ends [rad/s].
    end_errors: (f64, f64),
    /// Updates of the speed, if held values are interpolated.
    updated: Option<Updated>,
    /// A held position was interpolated.
    has_held_position: bool,
    /// Difference of the last and the first position \[rad\], if the window went over the ends of a cycle.
    closed: Option<f64>,
}

impl Course {
    /// Returns position and speed of samples; `between` interpolates held values, `closed` is the gap of a closed cycle.
    fn of(samples: &Samples, window: Option<f64>, between: bool, closed: Option<f64>) -> Result<Self, RecordedFault> {
        let time: &[f64] = &samples.time_s;
        let mut updated = None;
        let speed =
            samples.speed_rad_s.clone().map(|speed| match between.then(|| Updated::new(time, &speed)).flatten() {
                Some((rows, updates)) => {
                    updated = Some(updates);
                    Arc::new(rows)
                }
                None => speed,
            });
        let held = samples.position_rad.as_ref().filter(|_| between);
        let held = held.and_then(|position| interpolated_position(time, position));
        let has_held_position = held.is_some();
        let mut end_errors = (0.0, 0.0);
        let (position, slope) = match held {
            Some(Interpolated { position, speed: slope, update_s, updated: at, is_irregular }) => {
                end_errors = (slope_error(&update_s, &at, 0.0), slope_error_at_end(&update_s, &at, 0.0));
                if speed.is_none() {
                    let speed = slopes(&update_s, &at);
                    updated = Some(Updated { time: update_s, speed, position: Some(at), is_irregular });
                }
                (Some(Arc::new(position)), Some(slope))
            }
            None => (samples.position_rad.clone(), None),
        };
        let (position, speed) = match (position, speed, window) {
            (None, None, _) => return Err(RecordedFault::NoCourse),
            (Some(position), None, None) => {
                let speed = slope.unwrap_or_else(|| {
                    end_errors = (slope_error(time, &position, 0.0), slope_error_at_end(time, &position, 0.0));
                    let mut speed = slopes(time, &position);
                    stop_at_rests(&mut speed, &position);
                    speed
                });
                (Some(position), Arc::new(speed))
            }
            (Some(position), None, Some(window)) => {
                let (position, speed) = smooth_by(time, &position, window, closed)?;
                let half = 0.5 * window;
                end_errors = (slope_error(time, &position, half), slope_error_at_end(time, &position, half));
                (Some(Arc::new(position)), Arc::new(speed))
            }
            (position, Some(speed), window) => {
                end_errors = (0.0, 0.0);
                let speed = window
                    .map(|window| smooth_by(time, &speed, window, closed.map(|_| 0.0)))
                    .transpose()?
                    .map_or(speed, |fitted| Arc::new(fitted.0));
                (position, speed)
            }
        };
        Ok(Self { position, speed, end_errors, updated, has_held_position, closed })
    }

    /// Returns the gap of the positions at the ends \[rad\] if the speeds there are equal up to tolerance and noise.
    fn gap(&self, samples: &Samples, window: f64) -> Option<f64> {
        let (start, end) = ends(&self.speed);
        let fastest = self.speed.iter().fold(0.0_f64, |most, speed| most.max(speed.abs()));
        let (first, last) = self.position.as_deref().map_or((0.0, 0.0), |position| ends(position));
        let half = 0.5 * window;
        let (raw, smoothed, factor) = match (&samples.speed_rad_s, &samples.position_rad, &self.position) {
            (Some(raw), ..) => (raw, &self.speed, 3.0),
            (None, Some(raw), Some(position)) => (raw, position, 192_f64.sqrt() / half),
            _ => return None,
        };
        let noise = factor * end_error(raw, smoothed, half / median_interval(&samples.time_s));
        let is_alike = (end - start).abs() <= joint(fastest, self.end_errors.0 + self.end_errors.1 + noise);
        is_alike.then_some(last - first)
    }

    /// Returns `true` if a column of the samples is held and interpolated.
    fn is_held(&self, samples: &Samples) -> bool {
        let is_held = |torque: &Arc<Vec<f64>>| held(&samples.time_s, torque).is_some();
        self.updated.is_some() || self.has_held_position || samples.torque_nm.as_ref().is_some_and(is_held)
    }

    /// Returns the spurious acceleration caused by held values, by scattered time stamps, or by steps of the column
    /// from which the acceleration follows, if it is significant.
    fn spurious(&self, samples: &Samples, window: Option<f64>, treatment: Treatment) -> Option<MadeUp> {
        let time: &[f64] = &samples.time_s;
        let (values, column) = match (&samples.position_rad, &samples.speed_rad_s) {
            (_, Some(speed)) => (speed, SteppedColumn::Speed),
            (Some(position), None) => (position, SteppedColumn::Position),
            (None, None) => return None,
        };
        let own = SpeedOverTime { time, speed: &self.speed };
        let between = treatment.held_values == HeldValues::Interpolated;
        let of = |cause: Spurious, interval_s: f64, without: SpeedOverTime<'_>| {
            let (motion, apart) = without.acceleration_and_difference(own);
            (apart > NOTABLE * motion).then_some(MadeUp {
                column,
                cause,
                interval_s,
                acceleration_rad_s2: apart,
                motion_rad_s2: motion,
            })
        };
        if !between && let Some(period_s) = held(time, values) {
            let without = Self::of(samples, window, true, self.closed).ok()?;
            let found =
                of(Spurious::Held { period_s }, mean_interval(time), SpeedOverTime { time, speed: &without.speed });
            if found.is_some() {
                return found;
            }
        }
        if treatment.time_stamps == TimeStamps::Kept
            && let Stamps::Scattered(even) = Stamps::of(time, &[values])
        {
            let even_samples = with_time(samples, even.time_s);
            let without = Self::of(&even_samples, window, between, self.closed).ok()?;
            let without = SpeedOverTime { time: &even_samples.time_s, speed: &without.speed };
            let found = of(Spurious::Stamps { scatter_s: even.scatter_s }, even.interval_s, without);
            if found.is_some() {
                return found;
            }
        }
        // Of interpolated values the steps lie between the updates.
        match &self.updated {
            Some(Updated { time: updates, speed, position, is_irregular }) => {
                let values = position.as_ref().unwrap_or(speed);
                let known = (median_interval(time), own.largest_acceleration());
                let by_updates = || made_up_by_updates((updates, values), column, window, known);
                made_up(updates, values, column, window).or_else(|| is_irregular.then(by_updates).flatten())
            }
            None => made_up(time, values, column, window).or_else(|| made_up_by_noise(time, values, column, window)),
        }
    }
}

fn ends(values: &[f64]) -> (f64, f64) {
    (values.first().copied().unwrap_or(0.0), values.last().copied().unwrap_or(0.0))
}

fn check(time: &[f64], columns: [Option<&Arc<Vec<f64>>>; 3], stamps: TimeStamps) -> Result<(), RecordedFault> {
    if time.len() < 3 {
        return Err(RecordedFault::TooFew { samples: time.len() });
    }
    if columns.iter().flatten().any(|column| column.len() != time.len()) {
        return Err(RecordedFault::Uneven);
    }
    for column in columns.into_iter().flatten().map(|column| column.as_slice()).chain([time]) {
        if let Some(index) = column.iter().position(|value| !value.is_finite()) {
            return Err(RecordedFault::NotFinite { index });
        }
    }
    // Even instants replace equal stamps too.
    let is_late = |pair: &[f64]| match stamps {
        TimeStamps::Kept => pair.first() >= pair.last(),
        TimeStamps::Even => pair.first() > pair.last(),
    };
    match time.windows(2).position(is_late) {
        Some(before) => Err(RecordedFault::NotIncreasing { index: before + 1 }),
        None => Ok(()),
    }
}

/// Returns the slope of the parabola through each sample and its neighbours; at the ends that of the nearest parabola,
/// or zero if the two samples there are equal.
///
/// ẏ_k = (h_1 d_0 + h_0 d_1)/(h_0 + h_1), d slopes of the secants, h time steps; error h²/6 of the third derivative,
/// h²/3 at the ends.
pub(crate) fn slopes(time: &[f64], values: &[f64]) -> Vec<f64> {
    // Computed lazily: for a long recording they would need as much memory as two of its columns.
    let secants = || {
        let ends = time.iter().zip(values).zip(time.iter().zip(values).skip(1));
        ends.map(|((t0, y0), (t1, y1))| (t1 - t0, (y1 - y0) / (t1 - t0)))
    };
    let pairs = || secants().zip(secants().skip(1));
    let mut slopes = Vec::with_capacity(time.len());
    if let Some(((h0, d0), (h1, d1))) = pairs().next() {
        // A motion with equal first samples starts from rest, not backwards.
        slopes.push(if d0 == 0.0 { 0.0 } else { d0 + h0 * (d0 - d1) / (h0 + h1) });
    }
    slopes.extend(pairs().map(|((h0, d0), (h1, d1))| (h1 * d0 + h0 * d1) / (h0 + h1)));
    if let Some(((h0, d0), (h1, d1))) = pairs().next_back() {
        slopes.push(if d1 == 0.0 { 0.0 } else { d1 + h1 * (d1 - d0) / (h0 + h1) });
    }
    slopes
}

/// Returns the trapezoidal integral, which is exact for a speed linear between the samples.
fn integral(time: &[f64], speed: &[f64]) -> Vec<f64> {
    let mut position = 0.0;
    let mut positions = Vec::with_capacity(time.len());
    positions.push(position);
    for ((t0, w0), (t1, w1)) in time.iter().zip(speed).zip(time.iter().zip(speed).skip(1)) {
        position += 0.5 * (w0 + w1) * (t1 - t0);
        positions.push(position);
    }
    positions
}

/// Checks that recorded positions and speeds agree.
///
/// The speeds differ from those of the position by a factor alone if they leave a quarter of their difference when they
/// are divided by it, F = Σ s Δq/Σ Δq², s integrated and Δq recorded travel; such a factor is a wrong unit or ratio, and
/// a small one contradicts too.
fn agree(time: &[f64], position: &[f64], speed: &[f64]) -> Result<(), RecordedFault> {
    let travelled = integral(time, speed);
    let first = position.first().copied().unwrap_or(0.0);
    let (mut low, mut high, mut apart) = (f64::INFINITY, f64::NEG_INFINITY, 0.0_f64);
    let (mut product, mut square, mut moved) = (0.0, 0.0, 0.0_f64);
    for (recorded, integrated) in position.iter().zip(&travelled) {
        (low, high) = (low.min(*recorded), high.max(*recorded));
        let way = recorded - first;
        (apart, moved) = (apart.max((way - integrated).abs()), moved.max(integrated.abs()));
        (product, square) = (product + way * integrated, square + way * way);
    }
    let swing = (high - low).max(moved);
    if apart <= CONTRADICTION_BY_FACTOR * swing {
        return Ok(());
    }
    let factor = product / square;
    let left =
        position.iter().zip(&travelled).map(|(recorded, integrated)| (integrated / factor - recorded + first).abs());
    let is_factor = factor.is_finite() && factor != 0.0 && left.fold(0.0, f64::max) <= LEFT * apart;
    if is_factor || apart > CONTRADICTION * swing {
        return Err(RecordedFault::Contradiction { share: apart / swing, factor: is_factor.then_some(factor) });
    }
    Ok(())
}

#[cfg(test)]
#[path = "recorded_tests.rs"]
mod tests;
