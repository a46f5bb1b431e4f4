//! Parameters of the load and of the motor from a recorded run, by least squares.

use numeric::Symmetric;
use quantities::identified;

/// A recorded run, sample by sample, in SI at the output; currents i_q, peak of a phase.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Observed {
    /// q \[rad\]
    pub position_rad: Vec<f64>,
    /// ω [rad/s]
    pub speed_rad_s: Vec<f64>,
    /// α [rad/s²]
    pub acceleration_rad_s2: Vec<f64>,
    /// Speed of the motor over i [rad/s].
    pub motor_rad_s: Vec<f64>,
    /// Torque through the gear \[Nm\].
    pub torque_nm: Vec<f64>,
    /// i_q \[A\]
    pub current_q_a: Vec<f64>,
    /// Instants \[s\].
    pub time_s: Vec<f64>,
}

identified! {
    /// What is estimated.
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
        /// T_e: torque that neither speed nor position change \[Nm\].
        External = "external",
        /// k_Tout: torque at the output per ampere rms, driving [Nm/A].
        TorqueConstant = "torque_constant_out",
        /// I_NLS: friction of motor and gear as a current, rms \[A\].
        StartingCurrent = "no_load_starting_current",
        /// K_INL: its growth with the output speed [A s/rad].
        CurrentConstant = "no_load_current_constant",
    }
}

/// An estimate with its confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// What.
    pub of: Identified,
    /// Its value in SI.
    pub value: f64,
    /// Half the width of the interval that holds the true value in 95 of 100 runs, in SI.
    pub half_width: f64,
}

/// What a run says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Identification {
    /// The estimates.
    pub estimates: Vec<Estimate>,
    /// Samples in motion whose current is at its limit: they and their neighbours say nothing of the motor.
    pub at_limit: usize,
}

/// Why nothing is estimated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum IdentifyFault {
    /// Columns of different lengths.
    Uneven,
    /// Too few samples in motion.
    TooFew,
    /// The run moves in a way that leaves the values open: constant speed, or one direction only.
    NotExcited,
}

/// Below this share of the largest speed a sample says nothing of the friction of motion.
const MOVING: f64 = 0.05;

/// Above this share of its limit a current counts as limited.
const LIMITED: f64 = 0.97;

/// Fewer samples in motion are not looked at.
const LEAST: usize = 50;

/// The quantile of the normal distribution for 95 %.
const QUANTILE: f64 = 1.96;

/// Radius of the circle that holds 95 % of a normal distribution in two dimensions, in standard deviations.
const CIRCLE: f64 = 2.448;

/// Over a smaller swing of the position gravity and a constant torque are the same \[rad\].
const SWING: f64 = 0.2;

/// Estimates from a recorded run.
///
/// load: T = J_L α + T_c σ + b ω + W_c cos q + W_s sin q + T_e; motor: I = T/k_Tout + I_NLS σ + K ω + (J_M/k) α_M, where T drives
///
/// # Source
/// least squares; the variance of the residue counts the correlation of neighbouring residues, n (1 − ρ)/(1 + ρ) samples
/// # Valid
/// samples in motion; torque through the gear measured or simulated; constant parameters over the run
/// # Errors
/// [`IdentifyFault`]
pub fn identify(run: &Observed, current_limit_a: Option<f64>) -> Result<Identification, IdentifyFault> {
    let count = run.time_s.len();
    let columns = [
        &run.position_rad,
        &run.speed_rad_s,
        &run.acceleration_rad_s2,
        &run.motor_rad_s,
        &run.torque_nm,
        &run.current_q_a,
    ];
    if columns.iter().any(|column| column.len() != count) {
        return Err(IdentifyFault::Uneven);
    }
    let largest = run.speed_rad_s.iter().fold(0.0_f64, |most, speed| most.max(speed.abs()));
    let at = |column: &[f64], place: usize| column.get(place).copied().unwrap_or(0.0);
    // Neighbours must move too: about a reversal friction is not that of motion.
    let moves = |place: usize| {
        let sign = at(&run.speed_rad_s, place).signum();
        let near = place.saturating_sub(2)..=(place + 2).min(count.saturating_sub(1));
        near.into_iter().all(|k| {
            let (load, motor) = (at(&run.speed_rad_s, k), at(&run.motor_rad_s, k));
            load * sign > MOVING * largest && motor * sign > MOVING * largest
        })
    };
    let moving: Vec<usize> = (0..count).filter(|place| moves(*place)).collect();
    if moving.len() < LEAST {
        return Err(IdentifyFault::TooFew);
    }
    let (low, high) = moving.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| {
        let q = at(&run.position_rad, *place);
        (low.min(q), high.max(q))
    });
    // In one direction a constant torque and Coulomb friction are the same, and gravity hardly another.
    let both_ways = [1.0, -1.0].iter().all(|sign| moving.iter().any(|place| at(&run.speed_rad_s, *place) * sign > 0.0));
    let swings = both_ways && high - low > SWING;
    let load: Vec<(Vec<f64>, f64)> = moving
        .iter()
        .map(|place| {
            let (q, speed) = (at(&run.position_rad, *place), at(&run.speed_rad_s, *place));
            let mut row = vec![at(&run.acceleration_rad_s2, *place), speed.signum(), speed];
            if both_ways {
                row.push(1.0);
            }
            if swings {
                row.extend([q.cos(), q.sin()]);
            }
            (row, at(&run.torque_nm, *place))
        })
        .collect();
    let fit = least_squares(&load).ok_or(IdentifyFault::NotExcited)?;
    // The torque of the fit has no noise: that of a measured one would make the torque constant too small.
    let fitted: Vec<f64> =
        load.iter().map(|(row, _)| row.iter().zip(&fit).map(|(value, (factor, _))| value * factor).sum()).collect();
    let mut found = Vec::new();
    let mut push = |fit: &[(f64, f64)], place: usize, of| {
        if let Some((value, half_width)) = fit.get(place).copied() {
            found.push(Estimate { of, value, half_width });
        }
    };
    push(&fit, 0, Identified::LoadInertia);
    push(&fit, 1, Identified::Coulomb);
    push(&fit, 2, Identified::Viscous);
    if both_ways {
        push(&fit, 3, Identified::External);
    }
    if let (Some((c, dc)), Some((s, ds))) = (fit.get(4), fit.get(5)) {
        let weight = c.hypot(*s);
        // Along the gradient of the hypotenuse and across it; near zero the interval is the circle about both.
        let [along, across] =
            [(c * dc).hypot(s * ds), (s * dc).hypot(c * ds)].map(|half| half / weight.max(f64::MIN_POSITIVE));
        let is_there = weight > 2.0 * along.max(across);
        let half = if is_there { along } else { dc.max(*ds) * CIRCLE / QUANTILE };
        push(&[(weight, half)], 0, Identified::Gravity);
        if is_there {
            push(&[((-s).atan2(*c), across / weight)], 0, Identified::GravityAngle);
        }
    }
    // Where the torque drives the gear loses one way: k_Tout as the tables have it.
    let limited =
        |place: usize| current_limit_a.is_some_and(|limit| at(&run.current_q_a, place).abs() > LIMITED * limit);
    let limited: Vec<bool> = (0..count).map(limited).collect();
    let at_limit = moving.iter().filter(|place| limited.get(**place) == Some(&true)).count();
    // The block in which the current comes to its limit or leaves it is not that of a control that follows.
    let free = |place: usize| {
        let near = limited.get(place.saturating_sub(TOGETHER)..(place + TOGETHER).min(count)).unwrap_or_default();
        !near.contains(&true)
    };
    let free: Vec<(usize, f64)> =
        moving.iter().copied().zip(fitted.iter().copied()).filter(|(place, _)| free(*place)).collect();
    let drives = |place: usize, torque: f64| torque * at(&run.speed_rad_s, place) > 0.0;
    let is_driven = free.iter().any(|(place, torque)| !drives(*place, *torque));
    let motor: Vec<(usize, Vec<f64>, f64)> = free
        .iter()
        .map(|(place, torque)| {
            let (before, after) = (place.saturating_sub(1), place + 1);
            let step = at(&run.time_s, after) - at(&run.time_s, before);
            let gained = (at(&run.motor_rad_s, after) - at(&run.motor_rad_s, before)) / step;
            let speed = at(&run.motor_rad_s, *place);
            let current = at(&run.current_q_a, *place) / std::f64::consts::SQRT_2;
            let mut row = vec![0.0, speed.signum(), speed, gained];
            if is_driven {
                row.push(0.0);
            }
            let column = if drives(*place, *torque) { 0 } else { 4 };
            if let Some(cell) = row.get_mut(column) {
                *cell = *torque;
            }
            (*place, row, current)
        })
        .collect();
    let motor = averaged(&motor);
    if motor.len() >= LEAST / 4
        && let Some(fit) = least_squares(&motor)
    {
        if let Some((slope, half)) = fit.first().copied().filter(|(slope, _)| *slope > 0.0) {
            push(&[(1.0 / slope, half / (slope * slope))], 0, Identified::TorqueConstant);
        }
        push(&fit, 1, Identified::StartingCurrent);
        push(&fit, 2, Identified::CurrentConstant);
    }
    Ok(Identification { estimates: found, at_limit })
}

/// So many neighbouring rows are one: a mean of both sides of an equation is an equation, and the ripple of the control is gone.
const TOGETHER: usize = 32;

/// Means of neighbouring rows.
fn averaged(rows: &[(usize, Vec<f64>, f64)]) -> Vec<(Vec<f64>, f64)> {
    let runs = rows.chunk_by(|(a, ..), (b, ..)| *b == a + 1);
    let blocks = runs.flat_map(|run| run.chunks_exact(TOGETHER));
    blocks
        .map(|block| {
            #[allow(clippy::cast_precision_loss, reason = "eight")]
            let share = 1.0 / TOGETHER as f64;
            let width = block.first().map_or(0, |(_, row, _)| row.len());
            let column = |place: usize| block.iter().filter_map(|(_, row, _)| row.get(place)).sum::<f64>() * share;
            ((0..width).map(column).collect(), block.iter().map(|(.., value)| value).sum::<f64>() * share)
        })
        .collect()
}

/// Coefficients with half their intervals; `None` where the columns leave them open.
fn least_squares(rows: &[(Vec<f64>, f64)]) -> Option<Vec<(f64, f64)>> {
    let width = rows.first()?.0.len();
    // Columns of like size, so that what is small is not lost.
    let scale: Vec<f64> = (0..width)
        .map(|column| {
            let square: f64 = rows.iter().filter_map(|(row, _)| row.get(column)).map(|value| value * value).sum();
            square.sqrt().max(f64::MIN_POSITIVE)
        })
        .collect();
    let scaled = |row: &[f64]| -> Vec<f64> { row.iter().zip(&scale).map(|(value, scale)| value / scale).collect() };
    let mut normal = vec![vec![0.0; width]; width];
    let mut right = vec![0.0; width];
    for (row, value) in rows {
        let row = scaled(row);
        for ((line, right), a) in normal.iter_mut().zip(&mut right).zip(&row) {
            *right += a * value;
            for (cell, b) in line.iter_mut().zip(&row) {
                *cell += a * b;
            }
        }
    }
    let solve = |right: Vec<f64>| {
        let mut matrix = Symmetric::zero(std::iter::repeat_n(0, width));
        for (place, line) in normal.iter().enumerate() {
            for (column, value) in line.iter().enumerate().take(place + 1) {
                matrix.add(place, column, *value);
            }
        }
        matrix.solve(right)
    };
    let coefficients = solve(right)?;
    let residues: Vec<f64> = rows
        .iter()
        .map(|(row, value)| value - scaled(row).iter().zip(&coefficients).map(|(a, b)| a * b).sum::<f64>())
        .collect();
    let square: f64 = residues.iter().map(|residue| residue * residue).sum();
    let together: f64 = residues.windows(2).map(|pair| pair.iter().product::<f64>()).sum();
    let correlation = if square > 0.0 { (together / square).clamp(0.0, 0.999) } else { 0.0 };
    #[allow(clippy::cast_precision_loss, reason = "counts of samples")]
    let free = (rows.len() - width) as f64 * (1.0 - correlation) / (1.0 + correlation);
    #[allow(clippy::cast_precision_loss, reason = "counts of samples")]
    let variance = square / (rows.len() - width) as f64 * (rows.len() as f64 / free.max(1.0));
    (0..width)
        .map(|place| {
            let mut unit = vec![0.0; width];
            *unit.get_mut(place)? = 1.0;
            let spread = solve(unit)?.get(place).copied()?;
            // Columns that say the same leave a spread beyond all bounds.
            if !(spread.is_finite() && spread > 0.0 && spread < 1e12) {
                return None;
            }
            let scale = scale.get(place)?;
            Some((coefficients.get(place)? / scale, QUANTILE * (variance * spread).sqrt() / scale))
        })
        .collect()
}
