//! Identification of load and motor parameters from a recorded run.
//!
//! [`identify`] integrates the equations of motion over short windows (`windows`), so that position, motor speed,
//! torque and current are used as measured, and none is differentiated. `load` and `motor` form linear equations of the
//! windows, `regression` solves them with confidence intervals, `moves` finds the segment of each window, `delay`
//! finds signals that lag the position, `doubts` signals with another convention.

mod columns;
mod delay;
mod doubts;
mod load;
mod losses;
mod motor;
mod moves;
mod regression;
mod scale;
mod sizes;
mod timing;
mod weight;
mod windows;

use crate::Parameters;
use delay::Lag;
use doubts::Signals;
use mechanism::{Extra, Mechanism};
use motion::Motion;
use moves::Followed;
use quantities::identified;
use timing::Examined;
use windows::{NoWindows, Strokes, Windows};

pub(crate) use losses::Losses;

pub use doubts::{Column, Doubt, Misread};

/// A recorded run, sample by sample, in SI at the output; currents i_q, peak of a phase.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Observed {
    /// Instants \[s\].
    pub time_s: Vec<f64>,
    /// Positions q \[rad\].
    pub position_rad: Vec<f64>,
    /// Speeds ω [rad/s], if recorded; compared with the position but not used for estimates.
    pub speed_rad_s: Option<Vec<f64>>,
    /// Motor speeds over i [rad/s].
    pub motor_rad_s: Vec<f64>,
    /// Torques through the gear \[Nm\].
    pub torque_nm: Vec<f64>,
    /// Currents i_q \[A\].
    pub current_q_a: Vec<f64>,
}

/// The axis as stated by project and tables.
#[derive(Clone, Copy, Debug)]
pub struct Stated<'a> {
    /// Parameters of actuator and model.
    pub parameters: &'a Parameters,
    /// Mechanism of the load.
    pub mechanism: &'a Mechanism,
    /// Motion of the cycle.
    pub motion: &'a Motion,
    /// Payload and process of each segment of the motion; those of the first segment are included in the estimates.
    pub extras: &'a [Extra],
}

identified! {
    /// An identified parameter.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Identified {
        /// J_L: inertia of the load \[kgm²\].
        LoadInertia = "load_inertia",
        /// T_c: Coulomb friction of the load \[Nm\].
        Coulomb = "coulomb",
        /// b: viscous friction of the load [Nm s/rad].
        Viscous = "viscous",
        /// W: weight of the load at its largest lever \[Nm\].
        Gravity = "gravity",
        /// q_0: angle of the centre of mass above the horizontal at q = 0 \[rad\].
        GravityAngle = "gravity_angle",
        /// T_e: torque independent of speed and position \[Nm\].
        External = "external",
        /// k_Tout: torque at the output per ampere rms while driving [Nm/A].
        TorqueConstant = "torque_constant_out",
        /// I_NLS: friction of motor and gear as a current, rms \[A\].
        StartingCurrent = "no_load_starting_current",
        /// K_INL: growth of this current with the output speed [A s/rad].
        CurrentConstant = "no_load_current_constant",
    }
}

/// An estimate with its confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Parameter.
    pub of: Identified,
    /// Value in SI.
    pub value: f64,
    /// Half width of the 95 % confidence interval, in SI.
    pub half_width: f64,
}

/// Largest half interval of an inertia or a torque constant that counts as known, relative to its value \[1\]. A
/// choice.
const SHARE_MOST: f64 = 0.2;

/// Largest half interval of the external torque that counts as known, relative to its value \[1\]. A choice: the interval
/// contains a zero of the torque.
const EXTERNAL_MOST: f64 = 0.1;

/// Largest half interval of an angle that counts as known \[rad\].
const ANGLE_MOST: f64 = 0.5;

impl Estimate {
    /// Returns `true` if the run determines the value: its interval excludes zero, and its sign is possible.
    #[must_use]
    pub fn is_known(&self) -> bool {
        let Self { of, value, half_width } = *self;
        match of {
            Identified::LoadInertia | Identified::TorqueConstant => half_width < SHARE_MOST * value,
            Identified::GravityAngle => half_width < ANGLE_MOST,
            Identified::External => half_width < EXTERNAL_MOST * value.abs(),
            Identified::Coulomb
            | Identified::Viscous
            | Identified::Gravity
            | Identified::StartingCurrent
            | Identified::CurrentConstant => half_width < value,
        }
    }
}

/// Reason why a parameter has no estimate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Open {
    /// The run moves in one direction, so that Coulomb friction and constant torques cannot be distinguished.
    OneDirection,
    /// The run varies the parameter's share of the torque only together with others.
    NotSeparated,
    /// The half interval is at least a fifth of the value.
    Wide,
    /// The load of this mechanism has no such constant.
    NotConstant,
    /// Too few samples with a current below its limit.
    AtLimit,
    /// The run does not exclude another scale of the current.
    Scale,
    /// A zero of the torque would be part of the value, and the run does not bound it.
    Zero,
}

/// Lag of a signal behind the position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Delay {
    /// Lag \[s\]; negative if the signal leads.
    pub s: f64,
    /// Half width of its 95 % confidence interval \[s\].
    pub half_width_s: f64,
}

/// Scatter of time stamps about evenly spaced instants.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scatter {
    /// Standard deviation of the stamps \[s\].
    pub scatter_s: f64,
    /// Interval of the instants \[s\].
    pub interval_s: f64,
}

/// A column whose values are held over several rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeldColumn {
    /// Column.
    pub column: Column,
    /// Period at which the values are updated \[s\].
    pub period_s: f64,
}

/// Constant of the motor's equation: the zero of the current against that of the torque.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Zero {
    /// Value of i_q without a current, if the torque has none \[A\].
    pub current_q_a: f64,
    /// Half width of its 95 % confidence interval \[A\].
    pub half_width_a: f64,
    /// Torque recorded without a torque, if the current has no zero \[Nm\].
    pub torque_nm: f64,
    /// Half width of its 95 % confidence interval \[Nm\].
    pub half_width_nm: f64,
    /// The external torque deviates from the stated one by the same amount, so that the torque has the zero.
    pub is_of_torque: bool,
}

/// Smallest zero relative to half its 95 % interval that counts. A choice: three standard deviations.
const ZERO: f64 = 1.5;

impl Zero {
    /// Returns `true` if the run shows a zero.
    #[must_use]
    pub fn is_significant(&self) -> bool {
        self.current_q_a.abs() > ZERO * self.half_width_a
    }

    /// Returns the largest torque recorded without a torque that the run admits, if the current has no zero \[Nm\].
    #[must_use]
    pub fn most_nm(&self) -> f64 {
        self.torque_nm.abs() + self.half_width_nm
    }
}

/// Result of an identification.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Identification {
    /// Estimates that the run separates from each other.
    pub estimates: Vec<Estimate>,
    /// Parameters without an estimate, with the reason.
    pub open: Vec<(Identified, Open)>,
    /// Signs that a signal has another unit, sign or side, so that the estimates are not those of the axis.
    pub doubts: Vec<Doubt>,
    /// Number of windows with limited current, which provide no information on the motor.
    pub at_limit: usize,
    /// The run moves in both directions.
    pub both_ways: bool,
    /// Length of the windows \[s\].
    pub window_s: f64,
    /// Number of windows.
    pub windows: usize,
    /// Step of a position with few digits \[rad\].
    pub position_step_rad: Option<f64>,
    /// Inertia of rotor and wave generator at the output that the motor's equation takes from the tables \[kgm²\], and
    /// its assumed relative standard deviation.
    pub rotor: Option<[f64; 2]>,
    /// Lag of the motor speed behind the position, which the estimates take into account \[s\]; zero if it is a small
    /// part of the sampling interval.
    pub motor_lag_s: f64,
    /// Lag of the torque behind the position, removed before the estimates; `None` if the run shows none.
    pub torque_delay: Option<Delay>,
    /// Lag of the current behind position and torque, removed before the estimates; `None` if the run shows none.
    pub current_delay: Option<Delay>,
    /// Time constant of a filter of the torque, which the estimates have on the other signals; `None` if the run does not
    /// distinguish one from a delay.
    pub torque_filter: Option<Delay>,
    /// Time constant of a filter of the current.
    pub current_filter: Option<Delay>,
    /// Zero of the current against that of the torque; `None` if the run does not separate it.
    pub zero: Option<Zero>,
    /// The lags of torque and current are coefficients of the equations, so that the intervals contain their uncertainty: they
    /// have been removed, may be too small to count, or values are held, whose instants are known within their period only.
    pub are_lags_estimated: [bool; 2],
    /// Median interval of the rows \[s\].
    pub row_s: f64,
    /// Scatter of the time stamps about the even instants that the estimates use; `None` if they use the stamps.
    pub scatter: Option<Scatter>,
    /// Columns whose values are held over rows; the estimates use one value for each update.
    pub held: Vec<HeldColumn>,
    /// k_Tout of the tables without the no-load friction [Nm/A].
    pub tabulated_nm_a: Option<f64>,
    /// Payloads and process torques that segments add to the first, relative to the stated ones, and half the 95 % interval;
    /// `None` if none differ or the run does not separate them. The estimates take the stated ones.
    pub payload: Option<[f64; 2]>,
    /// Correlation coefficient of the positions of run and cycle at the best shift in time, if the run does not follow the cycle.
    pub other_motion: Option<f64>,
    /// Angle of the mechanism at position 0 of the run beyond the stated one, and half its 95 % interval \[rad\]; `None` if the
    /// segments add no different weights to a load under gravity. The estimates take all weights at it.
    pub offset_rad: Option<[f64; 2]>,
    /// Time of the cycle at the instant 0 of the run \[s\], if segments add different payloads or process torques.
    pub shift_s: Option<f64>,
}

impl Identification {
    /// Widens the intervals by what the estimates of another run differ that explains the signals as well.
    fn widen(&mut self, other: &Self) {
        for estimate in &mut self.estimates {
            let Some(other) = other.estimates.iter().find(|other| other.of == estimate.of) else { continue };
            let apart = other.value - estimate.value;
            let turn = std::f64::consts::TAU;
            let apart =
                if estimate.of == Identified::GravityAngle { apart - turn * (apart / turn).round() } else { apart };
            estimate.half_width += apart.abs();
        }
        if let (Some(zero), Some(other)) = (&mut self.zero, &other.zero) {
            zero.half_width_a += (other.current_q_a - zero.current_q_a).abs();
            zero.half_width_nm += (other.torque_nm - zero.torque_nm).abs();
        }
    }
}

/// Reason for which an identification is impossible.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum IdentifyFault {
    /// The columns differ in length.
    Uneven,
    /// A time is not later than that of the previous row; index of the row from 0.
    TimeNotRising(usize),
    /// Too few samples in motion.
    TooFew,
    /// The motion of the run does not determine the values.
    NotExcited,
    /// The steps of the position hide the acceleration.
    TooCoarse {
        /// Step of the position, or standard deviation of its noise \[rad\].
        step_rad: f64,
        /// Largest step with which the run could be evaluated \[rad\].
        most_rad: f64,
    },
    /// Segments add different payloads, and the run does not follow the motion.
    OtherMotion,
    /// Segments add different payloads, and the run follows the motion at several shifts in time.
    AmbiguousMotion,
    /// The caller ended the work.
    Stopped,
}

impl From<NoWindows> for IdentifyFault {
    fn from(why: NoWindows) -> Self {
        match why {
            NoWindows::TooFew => Self::TooFew,
            NoWindows::TooCoarse { step_rad, most_rad } => Self::TooCoarse { step_rad, most_rad },
            NoWindows::Stopped => Self::Stopped,
        }
    }
}

/// Estimates parameters of load and motor from a recorded run.
///
/// load: T = J_L α + T_c σ + b ω + W_c cos q + W_s sin q + T_e; motor: I = T/k_Tout + I_NLS σ + K Ω + (J_M/k) Ω' + I_0, where T drives
///
/// # Symbols
/// T torque through the gear, I = i_q/√2, q and ω of the load, Ω of the motor over i, σ direction, I_0 zero of the current
/// # Source
/// docs/theory/twin.md, *Identification*
/// # Valid
/// samples in motion; torque through the gear measured or simulated; constant parameters over the run. Additions of
/// motion segments are taken as stated, and J_M from the tables within a stated tolerance.
/// # Errors
/// [`IdentifyFault`]
pub fn identify(run: &Observed, stated: &Stated<'_>) -> Result<Identification, IdentifyFault> {
    identify_while(run.clone(), stated, &|| true)
}

/// Estimates parameters as [`identify`] does, as long as `goes_on`, which is called for each window, returns `true`.
///
/// Cost: O(n) for n rows, each in two windows; the search for delays and filters repeats the windows up to 17 times for each of torque
/// and current
///
/// # Errors
/// As [`identify`], and [`IdentifyFault::Stopped`].
pub fn identify_while(
    run: Observed,
    stated: &Stated<'_>,
    goes_on: &dyn Fn() -> bool,
) -> Result<Identification, IdentifyFault> {
    let run = prepared(run)?;
    let of_columns = columns::doubts(&run);
    if !of_columns.is_empty() {
        return Ok(Identification { doubts: of_columns, ..Identification::default() });
    }
    let Examined { run, grain, scatter, undecided, held } = timing::examined(run);
    let strokes = Strokes::of(&run, grain)?;
    let first = Extra::none();
    let extras = if stated.extras.is_empty() { std::slice::from_ref(&first) } else { stated.extras };
    let extra = |segment: usize| extras.get(segment).or(extras.last());
    let same = |a: usize, b: usize| extra(a) == extra(b);
    let differs = extras.iter().any(|each| extras.first() != Some(each));
    let followed = Followed::of(stated.motion, &run, strokes.moving(), differs.then_some(&same));
    let limit = stated.parameters.actuator.current_max.known().map(|known| {
        let rms: quantities::ElectricCurrent = known.value;
        std::f64::consts::SQRT_2 * quantities::Measure::si(rms)
    });
    let accelerating = || load::accelerating(&Windows::of(&run, &strokes, limit, |_, _| true, goes_on).ok()?);
    let signals = Signals::of(&run, &strokes, followed.as_ref(), stated, accelerating);
    if !goes_on() {
        return Err(IdentifyFault::Stopped);
    }
    let of_stamps = undecided.map(|scatter| Doubt::new(Column::Time, Misread::TimeStamps, scatter.scatter_s));
    if !signals.doubts.is_empty() {
        // Signals with another unit do not satisfy an equation of motion.
        return Ok(Identification {
            doubts: signals.doubts.into_iter().chain(of_stamps).collect(),
            both_ways: strokes.both_ways(),
            row_s: strokes.step_s,
            scatter,
            held,
            ..Identification::default()
        });
    }
    if differs {
        match followed {
            Some(followed) if !followed.follows() => return Err(IdentifyFault::OtherMotion),
            Some(followed) if followed.ambiguous => return Err(IdentifyFault::AmbiguousMotion),
            Some(_) => {}
            None => return Err(IdentifyFault::OtherMotion),
        }
    }
    let segment = |sample: usize| {
        let time = run.time_s.get(sample).copied().unwrap_or(0.0);
        followed.filter(|_| differs).map_or(0, |followed| followed.segment(time))
    };
    let is_sure = |sample: usize| {
        let about = followed.filter(|_| differs).and_then(|followed| {
            let (time, position) = (run.time_s.get(sample)?, run.position_rad.get(sample)?);
            Some(followed.about(*time, *position, *strokes.speed.get(sample)?))
        });
        about.is_none_or(|about| about.into_iter().all(|other| same(other, segment(sample))))
    };
    let is_even = |a, b| !differs || (same(segment(a), segment(b)) && is_sure(a) && is_sure(b));
    let windows = Windows::of(&run, &strokes, limit, is_even, goes_on)?;
    let of_sample = |sample: usize| extra(segment(sample));
    let both_ways = strokes.both_ways();
    let losses = Losses::of(stated.mechanism);
    let load = load::Load {
        mechanism: stated.mechanism,
        losses: losses.as_ref(),
        flange_kgm2: stated.parameters.flange_kgm2(),
        noise_nm: strokes.grain.noise_nm,
        extra: &of_sample,
        extras,
        both_ways,
        is_delayed: false,
    };
    let made = |run: &Observed, settle_s: f64| {
        let settled = (settle_s > 0.0).then(|| strokes.settled(&run.time_s, settle_s));
        Windows::of(run, settled.as_ref().unwrap_or(&strokes), limit, is_even, goes_on).ok()
    };
    let (run, windows, shifted_s) = delay::aligned(run.clone(), windows, &made);
    let (run, windows, delays) =
        delay::removed(run, windows, &made, &|run, windows| load::rows_of_delay(run, windows, &load));
    if !goes_on() {
        return Err(IdentifyFault::Stopped);
    }
    let mut found = Identification {
        both_ways,
        window_s: windows.length_s,
        windows: windows.all.len(),
        at_limit: windows.all.iter().filter(|window| window.limited).count(),
        position_step_rad: strokes.grain.quantum_rad,
        other_motion: followed.and_then(|followed| followed.deviation()),
        shift_s: followed.filter(|_| differs).map(|followed| followed.shift_s),
        are_lags_estimated: [delays.torque, delays.current].map(|lag| lag.is_some() || !held.is_empty()),
        torque_delay: delays.torque.and_then(Lag::delay),
        current_delay: delays.current.and_then(Lag::delay),
        torque_filter: delays.torque.and_then(Lag::filter),
        current_filter: delays.current.and_then(Lag::filter),
        row_s: strokes.step_s,
        scatter,
        held,
        ..Identification::default()
    };
    let load = load::Load { is_delayed: found.are_lags_estimated[0], ..load };
    let shares = load::estimate(&run, &windows, &load, &mut found)?;
    let shares = load::Shares { torque_error_s: delays.torque_error_s, ..shares };
    found.payload = shares.payload.map(|share| [share.value, share.half_width]);
    motor::estimate(&windows, &shares, stated.parameters, found.are_lags_estimated[1], &mut found);
    found.motor_lag_s += shifted_s;
    if let Some((run, windows)) = &delays.torque_or {
        let mut other = Identification::default();
        if load::estimate(run, windows, &load, &mut other).is_ok() {
            found.widen(&other);
        }
    }
    if let Some((_, windows)) = &delays.current_or {
        let mut other = Identification::default();
        motor::estimate(windows, &shares, stated.parameters, true, &mut other);
        found.widen(&other);
    }
    external(stated.mechanism.plain(extras.first().unwrap_or(&first)).map(|plain| plain.constant_nm), &mut found);
    let direction = followed.as_ref().and_then(Followed::direction);
    doubts::of_estimates(stated, extras, &windows, &shares, direction, &mut found);
    found.doubts.extend(of_stamps);
    Ok(found)
}

/// Decides from the stated external torque which signal has a zero, and widens the interval of the external torque by the
/// zero that the torque may have; where the run does not bound that zero, the external torque is open.
///
/// # Valid
/// one of torque and current has a zero: zeros of both that cancel each other do not show
fn external(stated_nm: Option<f64>, found: &mut Identification) {
    let Some(place) = found.estimates.iter().position(|each| each.of == Identified::External) else { return };
    let Some(zero) = found.zero.as_mut() else {
        found.estimates.remove(place);
        found.open.push((Identified::External, Open::Zero));
        return;
    };
    let Some(estimate) = found.estimates.get_mut(place) else { return };
    zero.is_of_torque = zero.is_significant()
        && stated_nm.is_some_and(|stated| {
            let deviation = estimate.value - stated;
            let within = (estimate.half_width + zero.half_width_nm).min(0.5 * zero.torque_nm.abs());
            deviation.abs() > estimate.half_width && (deviation - zero.torque_nm).abs() < within
        });
    estimate.half_width += zero.most_nm();
}

/// Checks the columns; a position counted within one revolution is unwrapped.
fn prepared(mut run: Observed) -> Result<Observed, IdentifyFault> {
    let count = run.time_s.len();
    let columns = [&run.position_rad, &run.motor_rad_s, &run.torque_nm, &run.current_q_a];
    let speeds = run.speed_rad_s.as_ref().is_some_and(|speeds| speeds.len() != count);
    if speeds || columns.iter().any(|column| column.len() != count) {
        return Err(IdentifyFault::Uneven);
    }
    if count < 2 {
        return Err(IdentifyFault::TooFew);
    }
    let falls = run.time_s.windows(2).position(|pair| matches!(pair, [a, b] if b <= a));
    if let Some(before) = falls {
        return Err(IdentifyFault::TimeNotRising(before + 1));
    }
    let turn = std::f64::consts::TAU;
    let (mut added, mut last) = (0.0, run.position_rad.first().copied().unwrap_or(0.0));
    for position in &mut run.position_rad {
        let jump = *position - last;
        last = *position;
        if (jump.abs() - turn).abs() < 0.1 * turn {
            added -= turn * jump.signum();
        }
        *position += added;
    }
    Ok(run)
}
