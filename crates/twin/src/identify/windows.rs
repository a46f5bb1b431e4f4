//! Equations of motion over short windows, so that no measured signal is differentiated.

use super::Observed;
use std::f64::consts::{PI, SQRT_2};
use std::ops::Range;

/// Means over one window, weighted by a smooth function that is zero at both ends.
#[derive(Clone, Debug)]
pub(super) struct Window {
    /// Samples of the window.
    pub(super) samples: Range<usize>,
    /// Stroke of the window: a stretch of motion in one direction.
    pub(super) stroke: usize,
    /// Number of its stroke within the part of the run that repeats, and its own number within the stroke.
    pub(super) phase: [usize; 2],
    /// Direction of motion, +1 or −1.
    pub(super) sign: f64,
    /// q \[rad\], ω [rad/s], α [rad/s²] of the load, from the position only.
    pub(super) position: f64,
    pub(super) speed: f64,
    pub(super) acceleration: f64,
    /// Means of cos q and sin q.
    pub(super) cosine: f64,
    pub(super) sine: f64,
    /// Torque through the gear \[Nm\], and its part that drives the load.
    pub(super) torque: f64,
    pub(super) driving: f64,
    /// Rate of the torque through the gear \[Nm/s\].
    pub(super) torque_rate: f64,
    /// i_q/√2 \[A\].
    pub(super) current: f64,
    /// Rate of i_q/√2 \[A/s\].
    pub(super) current_rate: f64,
    /// Motor speed over i [rad/s] and its derivatives [rad/s²], [rad/s³].
    pub(super) motor_speed: f64,
    pub(super) motor_acceleration: f64,
    pub(super) motor_jerk: f64,
    /// A current of the window is at its limit.
    pub(super) limited: bool,
    /// A current of the window is far beyond its limit, which none of a drive is.
    pub(super) exceeds: bool,
}

/// Windows of a run with their common properties.
#[derive(Clone, Debug)]
pub(super) struct Windows {
    pub(super) all: Vec<Window>,
    /// Length of a window \[s\].
    pub(super) length_s: f64,
    /// Median sampling interval \[s\].
    pub(super) step_s: f64,
    /// Interval at which the current is sampled \[s\].
    pub(super) current_s: f64,
    /// Variances of the noise of α and ω of a window caused by the noise of the position.
    pub(super) noise: [f64; 2],
    /// Variance of the noise of the torque of a window \[N²m²\].
    pub(super) torque_noise: f64,
    /// Variances of the noise of Ω' and Ω of a window caused by the noise of the motor speed.
    pub(super) motor_noise: [f64; 2],
}

/// Reason for which a run has no windows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum NoWindows {
    /// Too few samples in motion.
    TooFew,
    /// Step of the position that hides the acceleration \[rad\], and the largest that would be acceptable \[rad\].
    TooCoarse { step_rad: f64, most_rad: f64 },
    /// The caller ended the work.
    Stopped,
}

/// Smallest number of samples of a window, with which the trapezoidal rule over the weight function is accurate to
/// 10⁻⁴.
const SAMPLES_LEAST: usize = 24;

/// Smallest number of windows.
const WINDOWS_LEAST: usize = 16;

/// Windows per stroke without overlap.
const PER_STROKE: f64 = 5.0;

/// Smallest speed in motion relative to the largest speed; below it friction may be that of rest.
const MOVING: f64 = 0.05;

/// Smallest current relative to its limit that counts as limited.
const LIMITED: f64 = 0.97;

/// Smallest current relative to its limit that is another unit. A choice: a limited current overshoots by less.
const EXCEEDED: f64 = 1.2;

/// Largest noise in the acceleration of a window relative to its rms value.
const NOISE_MOST: f64 = 0.3;

/// Noise relative to the rms acceleration up to which windows are not lengthened.
const NOISE_WANTED: f64 = 0.03;

/// Smallest gap relative to the median sampling interval: two missing rows are bridged. A choice.
const GAP: f64 = 3.5;

/// Noise of the signals of a run, from one value for each update.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grain {
    /// Standard deviation of the noise of the position \[rad\].
    noise_rad: f64,
    /// Step of a position with few digits \[rad\].
    pub(super) quantum_rad: Option<f64>,
    /// Standard deviation of the noise of the torque \[Nm\].
    pub(super) noise_nm: f64,
    /// Standard deviation of the noise of the motor speed over i [rad/s].
    noise_rad_s: f64,
    /// Periods at which position, torque, current and motor speed are updated, if they are slower than the rows \[s\].
    updates_s: [f64; 4],
}

impl Grain {
    /// Returns the noise of positions, torques and motor speeds, and the periods of their updates.
    pub(super) fn of(position: &[f64], torque: &[f64], motor: &[f64], updates_s: [f64; 4]) -> Self {
        let (noise_rad, quantum_rad) = (noise_of(position), quantum_of(position));
        Self { noise_rad, quantum_rad, noise_nm: noise_of(torque), noise_rad_s: noise_of(motor), updates_s }
    }

    /// Returns the numbers of rows for which position, torque, current and motor speed have one independent value.
    fn rows(&self, step_s: f64) -> [f64; 4] {
        self.updates_s.map(|period| (period / step_s).max(1.0))
    }
}

/// Stretches of motion in one direction without a gap, and the noise of the signals.
#[derive(Clone, Debug)]
pub(super) struct Strokes {
    pub(super) ranges: Vec<(Range<usize>, f64)>,
    /// Median sampling interval \[s\].
    pub(super) step_s: f64,
    /// Noise of the signals.
    pub(super) grain: Grain,
    /// Mean speed about each sample [rad/s].
    pub(super) speed: Vec<f64>,
}

impl Strokes {
    /// Returns the strokes of a run.
    ///
    /// Speeds are differences over a distance of samples at which the noise of the position is small.
    pub(super) fn of(run: &Observed, grain: Grain) -> Result<Self, NoWindows> {
        let (time, position) = (&run.time_s, &run.position_rad);
        let mut steps: Vec<f64> = differences(time).collect();
        let middle = steps.len() / 2;
        let step_s = *steps.select_nth_unstable_by(middle, f64::total_cmp).1;
        let broken = |k: usize| {
            let after = |column: &[f64]| column.get(k..k + 2).and_then(|pair| differences(pair).next());
            after(time).is_none_or(|step| step > GAP * step_s) || after(position).is_none_or(|way| way.abs() > PI)
        };
        let Grain { noise_rad, quantum_rad, .. } = grain;
        let apart = 4.0 * noise_rad + quantum_rad.unwrap_or(0.0);
        let mut half = 2_usize;
        let mut speed = Vec::new();
        // The largest speed and the distance of samples needed for it depend on each other.
        for _ in 0..3 {
            speed = block_speeds(time, position, half);
            let largest = largest(&speed);
            if largest == 0.0 {
                return Err(NoWindows::TooFew);
            }
            let needed = apart / (MOVING * largest * step_s);
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bounded")]
            let next = needed.ceil().clamp(2.0, 1e6) as usize;
            if next <= half {
                break;
            }
            half = next;
        }
        if 8 * half > time.len() {
            // The noise of the position hides the speed everywhere.
            let step_rad = quantum_rad.unwrap_or(noise_rad);
            #[allow(clippy::cast_precision_loss, reason = "counts of samples")]
            let share = time.len() as f64 / (8 * half) as f64;
            return Err(NoWindows::TooCoarse { step_rad, most_rad: step_rad * share });
        }
        let least = MOVING * largest(&speed);
        let mut ranges: Vec<(Range<usize>, f64)> = Vec::new();
        let mut from = None;
        for k in 0..=speed.len() {
            let now = speed.get(k).filter(|speed| speed.abs() > least).map(|speed| speed.signum());
            let goes_on = from.is_some_and(|(_, sign)| now == Some(sign)) && k > 0 && !broken(k - 1);
            if goes_on {
                continue;
            }
            if let Some((first, sign)) = from {
                // Neighbours must move too: near a reversal friction may be that of rest.
                let (first, end): (usize, usize) = (first + half, k.saturating_sub(half));
                if end > first {
                    ranges.push((first..end, sign));
                }
            }
            from = now.map(|sign| (k, sign));
        }
        Ok(Self { ranges, step_s, grain, speed })
    }

    /// Returns the samples from the first motion to the last, without the rest before and behind.
    pub(super) fn moving(&self) -> Range<usize> {
        let first = self.ranges.iter().map(|(range, _)| range.start).min().unwrap_or(0);
        first..self.ranges.iter().map(|(range, _)| range.end).max().unwrap_or(self.speed.len())
    }

    /// Returns the strokes without a time at the begin of each, in which filters settle after the reversal of friction.
    pub(super) fn settled(&self, time_s: &[f64], settle_s: f64) -> Self {
        let later = |range: &Range<usize>| {
            let first = time_s.get(range.start).copied().unwrap_or(f64::INFINITY);
            let own = time_s.get(range.clone()).unwrap_or_default();
            range.start + own.partition_point(|time| *time < first + settle_s)..range.end
        };
        let ranges = self.ranges.iter().map(|(range, sign)| (later(range), *sign));
        Self { ranges: ranges.filter(|(range, _)| !range.is_empty()).collect(), ..self.clone() }
    }

    /// Returns `true` if the run moves in both directions.
    pub(super) fn both_ways(&self) -> bool {
        [1.0, -1.0].iter().all(|sign| self.ranges.iter().any(|(_, own)| own == sign))
    }
}

/// Iterates over the differences of adjacent values.
fn differences(column: &[f64]) -> impl Iterator<Item = f64> {
    column.windows(2).filter_map(|pair| if let [a, b] = pair { Some(b - a) } else { None })
}

/// Returns (q_{k+h} − q_{k−h})/(t_{k+h} − t_{k−h}) for each sample.
fn block_speeds(time: &[f64], position: &[f64], half: usize) -> Vec<f64> {
    let last = time.len().saturating_sub(1);
    let speed = |k: usize| {
        let (a, b) = (k.saturating_sub(half), (k + half).min(last));
        let way = position.get(b)? - position.get(a)?;
        let span = time.get(b)? - time.get(a)?;
        Some(way / span)
    };
    (0..time.len()).map(|k| speed(k).filter(|speed| speed.is_finite()).unwrap_or(0.0)).collect()
}

fn largest(speeds: &[f64]) -> f64 {
    speeds.iter().fold(0.0, |most, speed| most.max(speed.abs()))
}

/// Returns the standard deviation of the noise of a signal.
///
/// σ² = mean (Δ⁴q)²/70
///
/// # Valid
/// the fourth differences of the signal without noise are small compared with the noise; the median of their magnitudes
/// excludes single impacts
pub(super) fn noise_of(signal: &[f64]) -> f64 {
    let mut sizes: Vec<f64> = signal
        .windows(5)
        .filter_map(|w| if let [a, b, c, d, e] = w { Some((a - 4.0 * b + 6.0 * c - 4.0 * d + e).abs()) } else { None })
        .filter(|size| *size > 0.0)
        .collect();
    if sizes.is_empty() {
        return 0.0;
    }
    let middle = sizes.len() / 2;
    // The median of |x| of a normal x is 0.6745 σ.
    *sizes.select_nth_unstable_by(middle, f64::total_cmp).1 / 0.6745 / 70.0_f64.sqrt()
}

/// Returns the step of a position with few digits \[rad\], of which every difference is a multiple.
fn quantum_of(position: &[f64]) -> Option<f64> {
    let sizes = || differences(position).map(f64::abs).filter(|size| *size > 1e-13);
    let least = sizes().fold(f64::INFINITY, f64::min);
    let (mut count, mut most) = (0_usize, 0.0_f64);
    for difference in sizes() {
        let steps = difference / least;
        most = most.max(steps);
        // Beyond some thousand steps rounding hides the step.
        if steps > 5e3 || (steps - steps.round()).abs() > 0.1 {
            return None;
        }
        count += 1;
    }
    (count > 20).then_some(least).filter(|_| most >= 1.0)
}

impl Windows {
    /// Returns the windows of the strokes of a run.
    ///
    /// ∫ w α dt = ∫ w″ q dt, ∫ w ω dt = −∫ w′ q dt, w = sin⁴(π x), x = 0…1 over a window
    ///
    /// # Source
    /// Shinbrot, On the analysis of linear and nonlinear dynamical systems, Trans. ASME 79 (1957): modulating functions
    /// # Valid
    /// windows overlap by half; the weights of adjacent windows then have a correlation of 0.086 and their sum is
    /// nearly constant. A straight line through the ends is first subtracted from q, which changes no integral and
    /// keeps large angles exact. The windows are the shortest, up to a fifth of a stroke, in which the noise of the
    /// position is small.
    pub(super) fn of(
        run: &Observed,
        strokes: &Strokes,
        current_limit_a: Option<f64>,
        is_even: impl Fn(usize, usize) -> bool,
        goes_on: &dyn Fn() -> bool,
    ) -> Result<Self, NoWindows> {
        let mut lengths: Vec<usize> = strokes.ranges.iter().map(|(range, _)| range.len()).collect();
        if lengths.is_empty() {
            return Err(NoWindows::TooFew);
        }
        lengths.sort_unstable();
        #[allow(
            clippy::cast_precision_loss,
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "counts of samples"
        )]
        let fifth = (lengths.get(lengths.len() / 2).copied().unwrap_or(0) as f64 / PER_STROKE) as usize;
        let longest = fifth.max(SAMPLES_LEAST);
        // In long strokes of slow motion a fifth may hide the ramps.
        let largest = largest(&strokes.speed);
        let ramps = largest / strokes.ramp(run);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bounded")]
        let short = (ramps / strokes.step_s).clamp(1.0, 1e7) as usize;
        let mut length = longest.min(short).max(SAMPLES_LEAST);
        let made = |length: usize| {
            let is_even = |first: usize, last: usize| {
                if goes_on() { Ok(is_even(first, last)) } else { Err(NoWindows::Stopped) }
            };
            Self::of_length(run, strokes, current_limit_a, length, &is_even)
        };
        let mut found = made(length)?;
        // The noise decreases with the length to the power of 2.5, while the acceleration hardly changes.
        let grown = (found.noise_share() / NOISE_WANTED).powf(0.4);
        if grown > 1.0 && length < longest && found.all.len() >= WINDOWS_LEAST {
            #[allow(
                clippy::cast_precision_loss,
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "counts of samples"
            )]
            let wanted = (length as f64 * grown).ceil().min(longest as f64) as usize;
            length = wanted.max(length);
            found = made(length)?;
        }
        while found.all.len() < WINDOWS_LEAST && length > SAMPLES_LEAST {
            length = (length * 3 / 4).max(SAMPLES_LEAST);
            found = made(length)?;
        }
        // ∫ w² dt = 35 L/128, as many samples as the length.
        let [_, rows, _, of_motor] = strokes.grain.rows(found.step_s);
        let independent = found.length_s / found.step_s / rows * (9.0 / 64.0) / (35.0 / 128.0);
        found.torque_noise = strokes.grain.noise_nm.powi(2) / independent;
        // ∫ w′² dt = 5 π²/(8 L), as for the speed of a position.
        let of_speed = strokes.grain.noise_rad_s.powi(2) * of_motor / rows / independent;
        let rate = 5.0 * PI.powi(2) / 8.0 / found.length_s.powi(2) * (128.0 / 35.0);
        found.motor_noise = [of_speed * rate, of_speed];
        found.judged(strokes)
    }

    /// Returns the windows that begin a time behind the first of their stroke.
    pub(super) fn behind(&self, time_s: &[f64], settle_s: f64) -> Self {
        let begin = |window: &Window| time_s.get(window.samples.start).copied().unwrap_or(f64::INFINITY);
        let mut all = Vec::with_capacity(self.all.len());
        for stroke in self.all.chunk_by(|one, other| one.stroke == other.stroke) {
            let first = stroke.iter().map(begin).fold(f64::INFINITY, f64::min);
            all.extend(stroke.iter().filter(|window| begin(window) >= first + settle_s).cloned());
        }
        Self { all, ..self.clone() }
    }

    fn judged(self, strokes: &Strokes) -> Result<Self, NoWindows> {
        if self.all.len() < WINDOWS_LEAST {
            return Err(NoWindows::TooFew);
        }
        let share = self.noise_share();
        if share > NOISE_MOST {
            let step_rad = strokes.grain.quantum_rad.unwrap_or(strokes.grain.noise_rad);
            return Err(NoWindows::TooCoarse { step_rad, most_rad: step_rad * NOISE_MOST / share });
        }
        Ok(self)
    }

    /// Returns the standard deviation of the noise of α over the rms value of α.
    fn noise_share(&self) -> f64 {
        let square: f64 = self.all.iter().map(|window| window.acceleration * window.acceleration).sum();
        #[allow(clippy::cast_precision_loss, reason = "counts of windows")]
        let mean = square / (self.all.len() as f64).max(1.0);
        let noise = self.noise[0];
        if noise > 0.0 { (noise / (mean - noise).max(f64::MIN_POSITIVE)).sqrt() } else { 0.0 }
    }

    fn of_length(
        run: &Observed,
        strokes: &Strokes,
        current_limit_a: Option<f64>,
        length: usize,
        is_even: &impl Fn(usize, usize) -> Result<bool, NoWindows>,
    ) -> Result<Self, NoWindows> {
        let mut all = Vec::new();
        let period = strokes.period(run);
        for (stroke, (range, sign)) in strokes.ranges.iter().enumerate() {
            let count = range.len().saturating_sub(1);
            if count < length {
                continue;
            }
            // Windows are evenly spaced in the stroke, at most half a length apart.
            let gaps = (2 * (count - length)).div_ceil(length);
            for place in 0..=gaps {
                let first = range.start + (count - length) * place / gaps.max(1);
                if is_even(first, first + length)? {
                    let of_stroke = OfStroke { stroke, sign: *sign, phase: [stroke % period, place] };
                    all.extend(window(run, first..first + length + 1, of_stroke, current_limit_a));
                }
            }
        }
        #[allow(clippy::cast_precision_loss, reason = "counts of samples")]
        let (count, length_s) = (length as f64, length as f64 * strokes.step_s);
        // ∫ w″² dt = 4 π⁴/L³, ∫ w′² dt = 5 π²/(8 L), ∫ w dt = 3 L/8, one sample per L/n.
        let quantised = strokes.grain.quantum_rad.map_or(0.0, |step| step / 12.0_f64.sqrt());
        let [rows, _, of_current, _] = strokes.grain.rows(strokes.step_s);
        let current_s = of_current * strokes.step_s;
        let variance = strokes.grain.noise_rad.max(quantised).powi(2) * rows;
        let noise = [4.0 * PI.powi(4) / length_s.powi(4), 5.0 * PI.powi(2) / 8.0 / length_s.powi(2)]
            .map(|square| variance * square / count * 64.0 / 9.0);
        Ok(Self { all, length_s, step_s: strokes.step_s, current_s, noise, torque_noise: 0.0, motor_noise: [0.0; 2] })
    }
}

/// Stroke of a window, and its place there.
struct OfStroke {
    stroke: usize,
    sign: f64,
    phase: [usize; 2],
}

/// Deviation of the ends of a stroke, relative to its way, and of its duration, up to which another one repeats it. A choice.
const REPEATS: f64 = 0.02;

impl Strokes {
    /// Returns the smallest number of strokes after which the run repeats itself, up to the first and the last stroke, which may be
    /// cut; the number of all strokes if it does not.
    fn period(&self, run: &Observed) -> usize {
        let place = |index: usize| run.position_rad.get(index).copied().unwrap_or(f64::NAN);
        let ends = |range: &Range<usize>| [place(range.start), place(range.end.saturating_sub(1))];
        let repeats = |(one, sign): &(Range<usize>, f64), (other, of_other): &(Range<usize>, f64)| {
            let ([from, to], [other_from, other_to]) = (ends(one), ends(other));
            let way = REPEATS * (to - from).abs();
            #[allow(clippy::cast_precision_loss, reason = "counts of samples")]
            let longer = one.len().abs_diff(other.len()) as f64 <= REPEATS * one.len() as f64 + 2.0;
            sign == of_other && longer && (other_from - from).abs() <= way && (other_to - to).abs() <= way
        };
        let period = |strokes: &[(Range<usize>, f64)]| {
            let is_period = |period: &usize| {
                strokes.iter().zip(strokes.iter().skip(*period)).all(|(one, other)| repeats(one, other))
            };
            (1..strokes.len()).find(is_period)
        };
        let whole = self.ranges.get(1..self.ranges.len().saturating_sub(1)).unwrap_or_default();
        period(&self.ranges).or_else(|| period(whole)).unwrap_or(self.ranges.len()).max(1)
    }

    /// Returns the acceleration exceeded by a tenth of the samples in motion [rad/s²], from differences of the speed
    /// over a tenth of a stroke.
    fn ramp(&self, run: &Observed) -> f64 {
        let mut all = Vec::new();
        for (range, _) in &self.ranges {
            let half = (range.len() / 20).max(2);
            for k in range.clone().step_by(half) {
                let (a, b) = (k.saturating_sub(half).max(range.start), (k + half).min(range.end.saturating_sub(1)));
                if let (Some(va), Some(vb), Some(ta), Some(tb)) =
                    (self.speed.get(a), self.speed.get(b), run.time_s.get(a), run.time_s.get(b))
                    && tb > ta
                {
                    all.push(((vb - va) / (tb - ta)).abs());
                }
            }
        }
        if all.is_empty() {
            return f64::MIN_POSITIVE;
        }
        let place = all.len() * 9 / 10;
        all.select_nth_unstable_by(place, f64::total_cmp).1.max(f64::MIN_POSITIVE)
    }
}

fn window(
    run: &Observed,
    samples: Range<usize>,
    OfStroke { stroke, sign, phase }: OfStroke,
    current_limit_a: Option<f64>,
) -> Option<Window> {
    let time = run.time_s.get(samples.clone())?;
    let position = run.position_rad.get(samples.clone())?;
    let motor = run.motor_rad_s.get(samples.clone())?;
    let torque = run.torque_nm.get(samples.clone())?;
    let current = run.current_q_a.get(samples.clone())?;
    let (t0, t1) = (*time.first()?, *time.last()?);
    let (q0, q1) = (*position.first()?, *position.last()?);
    let length = t1 - t0;
    let slope = (q1 - q0) / length;
    #[allow(clippy::cast_precision_loss, reason = "counts of samples")]
    let motor_mean = motor.iter().sum::<f64>() / motor.len() as f64;
    let mut sums = [0.0_f64; 10];
    let [mut motor_acceleration, mut motor_jerk, mut torque_rate, mut current_rate] = [0.0; 4];
    for (k, t) in time.iter().enumerate() {
        let before = time.get(k.saturating_sub(1)).unwrap_or(t);
        let after = time.get(k + 1).unwrap_or(t);
        let step = 0.5 * (after - before);
        let x = (t - t0) / length;
        let (sine, cosine) = (PI * x).sin_cos();
        let [s2, c2] = [sine * sine, cosine * cosine];
        let weight = s2 * s2 * step;
        let first = 4.0 * s2 * sine * cosine * (PI / length) * step;
        let second = (12.0 * s2 * c2 - 4.0 * s2 * s2) * (PI / length).powi(2) * step;
        let q = *position.get(k)?;
        let bent = q - q0 - slope * (t - t0);
        let (sin_q, cos_q) = q.sin_cos();
        let drives = *torque.get(k)? * sign > 0.0;
        let (own, motor, current) = (*torque.get(k)?, *motor.get(k)?, current.get(k)? / SQRT_2);
        motor_acceleration -= first * (motor - motor_mean);
        motor_jerk += second * (motor - motor_mean);
        torque_rate -= first * own;
        current_rate -= first * current;
        let terms = [
            weight,
            weight * q,
            -first * bent,
            second * bent,
            weight * cos_q,
            weight * sin_q,
            weight * own,
            if drives { weight * own } else { 0.0 },
            weight * current,
            weight * motor,
        ];
        sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
    }
    let [all, q, bent, acceleration, cosine, sine, mean_torque, driving, mean_current, motor_speed] = sums;
    let beyond = |share: f64| current_limit_a.is_some_and(|limit| current.iter().any(|i| i.abs() > share * limit));
    let (limited, exceeds) = (beyond(LIMITED), beyond(EXCEEDED));
    Some(Window {
        samples,
        stroke,
        phase,
        sign,
        position: q / all,
        speed: slope + bent / all,
        acceleration: acceleration / all,
        cosine: cosine / all,
        sine: sine / all,
        torque: mean_torque / all,
        torque_rate: torque_rate / all,
        driving: driving / all,
        current: mean_current / all,
        current_rate: current_rate / all,
        motor_speed: motor_speed / all,
        motor_acceleration: motor_acceleration / all,
        motor_jerk: motor_jerk / all,
        limited,
        exceeds,
    })
}
