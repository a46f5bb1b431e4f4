//! Segments of the motion that a run follows, because payload and process torque belong to a segment.

use super::Observed;
use crate::setpoint::Course;
use motion::Motion;
use quantities::Measure;
use std::ops::Range;

/// A motion aligned with a run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Followed<'a> {
    course: Course<'a>,
    /// Time of the cycle at the instant 0 of the run \[s\], negative if the cycle begins later.
    pub(super) shift_s: f64,
    /// Slope of the position of the run over that of the motion \[1\].
    pub(super) slope: f64,
    /// Position of the run where that of the motion is zero \[rad\].
    offset_rad: f64,
    /// Correlation coefficient r of both.
    correlation: f64,
    /// Spread of the position over that of the speed of the run \[s\].
    pace_s: f64,
    /// Another shift fits equally well and yields other segments.
    pub(super) ambiguous: bool,
    /// Correlation coefficients of the run and of the mirrored run, each at its best shift.
    both: [f64; 2],
    /// Correlation coefficient at the clock of the run, if it starts within the first cycle.
    own: Option<f64>,
}

/// Smallest correlation coefficient of a run that follows a motion. A choice: it admits following errors of a tenth of
/// the range.
const FOLLOWS: f64 = 0.99;

/// Smallest correlation coefficient at the clock of the run with which this may be that of the motion. A choice: a run at half the
/// speed of a move back and forth has 0.9.
const LAGS: f64 = 0.9;

/// Number of samples compared and of shifts tried, if segments differ and if only the position matters.
const FINE: (usize, u32) = (600, 500);
const ROUGH: (usize, u32) = (200, 100);

impl<'a> Followed<'a> {
    /// Aligns a motion with a run: at the clock of the run if it fits, else at the shift with the largest correlation.
    ///
    /// Only the samples of `moving` are compared: how long the axis rests before and behind is no part of the motion.
    /// `same` returns `true` for two segments with equal additions to the load; `None` if all segments are equal.
    pub(super) fn of(
        motion: &'a Motion,
        run: &Observed,
        moving: Range<usize>,
        same: Option<&impl Fn(usize, usize) -> bool>,
    ) -> Option<Self> {
        let (times, positions) = (run.time_s.get(moving.clone())?, run.position_rad.get(moving)?);
        let (samples, shifts) = if same.is_some() { FINE } else { ROUGH };
        let stride = (times.len() / samples).max(1);
        let picked: Vec<(f64, f64)> = times.iter().copied().zip(positions.iter().copied()).step_by(stride).collect();
        let (first, last) = (*times.first()?, *times.last()?);
        let period = motion.duration().si();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bounded")]
        let cycles = ((last - first) / period).clamp(0.0, 1e6).ceil() as u32 + 2;
        let course = Course::of(motion, cycles, None);
        let pace_s = pace_s(&picked);
        let at = |shift_s: f64| {
            let (slope, offset_rad, correlation) = compared(&picked, &course, shift_s);
            let both = [correlation, -correlation];
            Self { course, shift_s, slope, offset_rad, correlation, pace_s, ambiguous: false, both, own: None }
        };
        // A run written by the twin has the clock of the motion.
        let own = at(0.0);
        let is_within = run.time_s.first().is_some_and(|begin| (0.0..period).contains(begin));
        if is_within && own.correlation > FOLLOWS {
            return Some(own);
        }
        let step = period / f64::from(shifts);
        let tried: Vec<Self> = (0..shifts).map(|k| at(f64::from(k) * step - first)).collect();
        let mut best = *tried.iter().max_by(|a, b| a.correlation.total_cmp(&b.correlation))?;
        for k in -20..=20 {
            let near = at((best.shift_s + f64::from(k) / 20.0 * step).max(-first));
            if near.correlation > best.correlation {
                best = near;
            }
        }
        let least = tried.iter().map(|other| other.correlation).fold(own.correlation, f64::min);
        best.both = [best.correlation, -least];
        best.own = is_within.then_some(own.correlation);
        let Some(same) = same else { return Some(best) };
        let differs = |other: &Self| {
            let pairs = picked.iter().filter(|(time, _)| !same(best.segment(*time), other.segment(*time)));
            pairs.count() * 50 > picked.len()
        };
        let rival = 1.0 - 4.0 * (1.0 - best.correlation).max(5e-4);
        // Shifts close to the best one fit nearly as well; another maximum is a different alignment.
        best.ambiguous = tried.iter().enumerate().any(|(place, other)| {
            let [before, after] = [place + tried.len() - 1, place + 1].map(|near| tried.get(near % tried.len()));
            let is_highest = [before, after].iter().flatten().all(|near| near.correlation <= other.correlation);
            let apart = (other.shift_s - best.shift_s).abs() > 2.0 * step;
            is_highest && apart && other.correlation > rival && differs(other)
        });
        Some(best)
    }

    /// Returns `true` if the run follows the motion, in any unit.
    pub(super) fn follows(&self) -> bool {
        self.correlation > FOLLOWS
    }

    /// Returns the correlation coefficient of a run that does not follow the motion, mirrored or not.
    pub(super) fn deviation(&self) -> Option<f64> {
        let most = self.both.into_iter().fold(self.correlation, f64::max);
        (most <= FOLLOWS).then_some(most)
    }

    /// Returns the sign of the position relative to the motion: +1, −1 if only the mirrored run follows it.
    pub(super) fn direction(&self) -> Option<f64> {
        if self.own.is_some_and(|own| own < -FOLLOWS) {
            return Some(-1.0);
        }
        match self.both.map(|correlation| correlation > FOLLOWS) {
            [true, false] => Some(1.0),
            [false, true] => Some(-1.0),
            _ => None,
        }
    }

    /// Returns the segment of the motion at an instant of the run.
    pub(super) fn segment(&self, time_s: f64) -> usize {
        self.course.at((time_s + self.shift_s).max(0.0)).segment
    }

    /// Returns the segments before and behind an instant by the time that the run at a speed is off the motion, and that of the
    /// clock of the run.
    ///
    /// τ = |q − q_motion|/|ω| + √(1 − r²) s_q/s_ω: what the run is off here, and what the shift in time may be off
    ///
    /// # Valid
    /// A run at a limit of speed or current lags: the instant of a payload is that of the motion or that of the place.
    pub(super) fn about(&self, time_s: f64, position_rad: f64, speed_rad_s: f64) -> [usize; 3] {
        let wanted = self.course.at((time_s + self.shift_s).max(0.0)).state[0];
        let off_rad = position_rad - self.offset_rad - self.slope * wanted;
        let spread = (1.0 - self.correlation * self.correlation).max(0.0).sqrt();
        let lag_s = (off_rad / speed_rad_s).abs() + spread * self.pace_s;
        let shift_s = if self.own.is_some_and(|own| own > LAGS) { 0.0 } else { self.shift_s };
        let of_clock = self.course.at((time_s + shift_s).max(0.0)).segment;
        [self.segment(time_s - lag_s), self.segment(time_s + lag_s), of_clock]
    }
}

/// Returns the standard deviation of positions over the rms speed between them \[s\].
fn pace_s(picked: &[(f64, f64)]) -> f64 {
    #[allow(clippy::cast_precision_loss, reason = "counts of samples")]
    let count = picked.len() as f64;
    let mean = picked.iter().map(|(_, q)| q / count).sum::<f64>();
    let square = picked.iter().map(|(_, q)| (q - mean).powi(2)).sum::<f64>() / count;
    let [mut ways, mut times] = [0.0; 2];
    for pair in picked.windows(2) {
        if let [(ta, qa), (tb, qb)] = pair {
            ways += (qb - qa).powi(2) / (tb - ta);
            times += tb - ta;
        }
    }
    if ways > 0.0 { (square * times / ways).sqrt() } else { 0.0 }
}

/// Returns slope, intercept and correlation coefficient of a run over a motion.
fn compared(picked: &[(f64, f64)], course: &Course<'_>, shift_s: f64) -> (f64, f64, f64) {
    #[allow(clippy::cast_precision_loss, reason = "counts of samples")]
    let count = picked.len() as f64;
    let pairs: Vec<[f64; 2]> =
        picked.iter().map(|(time, q)| [course.at((time + shift_s).max(0.0)).state[0], *q]).collect();
    let mean = pairs.iter().fold([0.0; 2], |[a, b], [x, y]| [a + x / count, b + y / count]);
    let [mut xx, mut xy, mut yy] = [0.0; 3];
    for [x, y] in pairs {
        let [x, y] = [x - mean[0], y - mean[1]];
        (xx, xy, yy) = (xx + x * x, xy + x * y, yy + y * y);
    }
    let [x, y] = mean;
    if xx > 0.0 && yy > 0.0 { (xy / xx, y - xy / xx * x, xy / (xx * yy).sqrt()) } else { (0.0, y, 0.0) }
}
