//! Parameters of the load: linear equations of the windows, without the additions of the segments.

use super::losses::{self, Losses, Part};
use super::regression::{Fit, Row, compared, fit};
use super::weight::Turned;
use super::windows::{Window, Windows};
use super::{Estimate, Identification, Identified, IdentifyFault, Observed, Open};
use mechanism::{Extra, Loading, Mechanism, Output, Plain};

/// Smallest range of the position over which gravity is estimated although the project states none \[rad\].
const SWING: f64 = 0.2;

/// Radius of the circle that contains 95 % of a normal distribution in two dimensions, over the 95 % quantile in one.
const CIRCLE: f64 = 2.448 / 1.960;

/// Relative error of an estimate caused by the trapezoidal rule where a torque jumps between two samples.
const QUADRATURE: f64 = 1e-3;

/// A part of the torque relative to the stated one, with half its 95 % interval \[1\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Share {
    pub(super) value: f64,
    pub(super) half_width: f64,
}

impl Share {
    fn of(fit: &Fit, place: usize, stated: f64) -> Option<Self> {
        let (value, half_width) = fit.estimate(place).filter(|_| fit.separates(place) && stated != 0.0)?;
        Some(Self { value: value / stated, half_width: (half_width / stated).abs() })
    }
}

/// Parts of the torque relative to what the project states.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Shares {
    /// Differences of payloads and process torques from move to move.
    pub(super) payload: Option<Share>,
    /// Inertia of the load.
    pub(super) inertia: Option<Share>,
    /// Friction and external torque of the load, as far as stated.
    pub(super) others: Vec<Share>,
    /// Parts of the weight.
    pub(super) weights: Vec<Share>,
    /// Constant torque: weight of a linear drive, external torque.
    pub(super) constant: Option<Share>,
    /// The mechanism has losses by the direction of power.
    pub(super) has_losses: bool,
    /// Lag of the torque that may be left \[s\].
    pub(super) torque_error_s: f64,
    /// Largest rms deviation of a stroke from a load that carries what the project states \[Nm\], if payloads of its own explain it.
    pub(super) unstated_nm: Option<f64>,
}

/// Load of a run as the project states it.
#[derive(Clone, Copy)]
pub(super) struct Load<'a, 'e> {
    pub(super) mechanism: &'a Mechanism,
    /// Losses of the mechanism, if it has any.
    pub(super) losses: Option<&'a Losses>,
    /// J of the flange, in front of the losses \[kgm²\].
    pub(super) flange_kgm2: f64,
    /// Standard deviation of the noise of the torque \[Nm\].
    pub(super) noise_nm: f64,
    /// Additions of a segment, by the sample of a run.
    pub(super) extra: &'a dyn Fn(usize) -> Option<&'e Extra>,
    /// Additions of all segments.
    pub(super) extras: &'e [Extra],
    /// The run moves in both directions.
    pub(super) both_ways: bool,
    /// A delay of the torque has been removed; what is left of it is a column.
    pub(super) is_delayed: bool,
}

/// Estimates the parameters of the load, including the payload of the first segment.
///
/// # Valid
/// all parameters of a load with constant coefficients; for other loads the deviation from the stated one: friction,
/// and for a linear drive the inertia too
pub(super) fn estimate(
    run: &Observed,
    windows: &Windows,
    load: &Load<'_, '_>,
    found: &mut Identification,
) -> Result<Shares, IdentifyFault> {
    let none = Extra::none();
    match load.mechanism.plain(load.extras.first().unwrap_or(&none)) {
        Some(plain) => plainly(windows, load, &plain, found),
        None => relative_to_stated(run, windows, load, found),
    }
}

/// Returns the equations of the load with the rate of the torque as their last column, without a scale of the torque, the
/// variances of the noise of the columns, and the norm of the error of the equations that is no noise.
pub(super) fn rows_of_delay(run: &Observed, windows: &Windows, load: &Load<'_, '_>) -> (Vec<Row>, Vec<f64>, f64) {
    let none = Extra::none();
    let first = load.extras.first().unwrap_or(&none);
    let differs = load.extras.iter().any(|each| each != first);
    if let Some(plain) = load.mechanism.plain(first) {
        let columns = Columns { rate: true, ..Columns::of(windows, load, &plain) };
        let has_weights = differs && adds_weight(load, &plain);
        let rows = windows.all.iter().map(|window| {
            let mut row = columns.row(window, load, &plain, differs);
            if has_weights {
                // The delay is sought without the offset: weights of payloads at any angle are free.
                let own = (load.extra)(window.samples.start).and_then(|extra| load.mechanism.plain(extra));
                let added = own.map_or(0.0, |own| own.weight_nm - plain.weight_nm);
                let rate = row.regressors.pop();
                row.regressors.extend([added * window.cosine, added * window.sine].into_iter().chain(rate));
            }
            row
        });
        return (rows.collect(), vec![windows.noise[0], 0.0, windows.noise[1]], 0.0);
    }
    let row = |window: &Window| {
        let Part { own, factor } =
            (load.extra)(window.samples.start).map_or(Some(Part::NONE), |extra| part(run, window, load, extra))?;
        let regressors = vec![own, window.sign, window.speed, factor, factor * window.acceleration, window.torque_rate];
        Some(Row { regressors, value: window.torque, stroke: window.stroke, phase: window.phase })
    };
    let rows: Vec<Row> = windows.all.iter().filter_map(row).collect();
    let error = error_share(&rows, 3) * norm(rows.iter().map(|row| row.value));
    (rows, Vec::new(), error)
}

/// Returns the square root of the sum of the squares.
fn norm(values: impl Iterator<Item = f64>) -> f64 {
    values.map(|value| value * value).sum::<f64>().sqrt()
}

/// Returns the error of the stated load in a window relative to the torque, from the column of the factors of the losses.
fn error_share(rows: &[Row], factor: usize) -> f64 {
    let factors = rows.iter().filter_map(|row| row.regressors.get(factor));
    let farthest = factors.map(|factor| (factor - 1.0).abs()).fold(0.0, f64::max);
    QUADRATURE + losses::OTHER_SIDE * farthest
}

/// Columns of the equations of a load with constant coefficients, besides those of acceleration, direction and speed.
#[derive(Clone, Copy)]
struct Columns {
    /// Cosine and sine of the position.
    hangs: bool,
    /// One.
    constant: bool,
    /// Rate of the torque.
    rate: bool,
    /// Weight and offset, about which both columns of the weight are those of their changes.
    turned: Option<Turned>,
}

impl Columns {
    fn of(windows: &Windows, load: &Load<'_, '_>, first: &Plain) -> Self {
        let (low, high) = windows.all.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), window| {
            (low.min(window.position), high.max(window.position))
        });
        let hangs = high - low > SWING || first.weight_nm != 0.0;
        Self { hangs, constant: load.both_ways, rate: load.is_delayed, turned: None }
    }

    /// Returns the place of the constant, if there is one.
    const fn constant(self) -> usize {
        if self.hangs { 5 } else { 3 }
    }

    /// Returns the place behind the constant.
    fn last(self) -> usize {
        self.constant() + usize::from(self.constant)
    }

    /// Returns the equation of a window; the additions of the segments are a column, behind the constant, if they are free.
    fn row(self, window: &Window, load: &Load<'_, '_>, first: &Plain, is_free: bool) -> Row {
        let mut regressors = vec![window.acceleration, window.sign, window.speed];
        let own = (load.extra)(window.samples.start).and_then(|extra| load.mechanism.plain(extra));
        if self.hangs {
            let of_turned = |turned: Turned| turned.columns(window, first, own.as_ref());
            regressors.extend(self.turned.map_or([window.cosine, window.sine], of_turned));
        }
        regressors.extend(self.constant.then_some(1.0));
        let offset_rad = self.turned.map_or(0.0, |turned| turned.offset_rad);
        let added = own.map_or(0.0, |own| difference(&own, first, window, offset_rad));
        regressors.extend(is_free.then_some(added));
        regressors.extend(self.rate.then_some(window.torque_rate));
        Row {
            regressors,
            value: if is_free { window.torque } else { window.torque - added },
            stroke: window.stroke,
            phase: window.phase,
        }
    }
}

fn plainly(
    windows: &Windows,
    load: &Load<'_, '_>,
    first: &Plain,
    found: &mut Identification,
) -> Result<Shares, IdentifyFault> {
    let both_ways = load.both_ways;
    let plain = Columns::of(windows, load, first);
    let turned = (plain.hangs && first.weight_nm != 0.0 && adds_weight(load, first))
        .then(|| {
            let rows = |turned| {
                let columns = Columns { turned: Some(turned), ..plain };
                windows.all.iter().map(|window| columns.row(window, load, first, false)).collect()
            };
            Turned::find(first.weight_nm, 3, &rows)
        })
        .flatten();
    let columns = Columns { turned, ..plain };
    let rows_of = |is_free: bool| -> Vec<Row> {
        windows.all.iter().map(|window| columns.row(window, load, first, is_free)).collect()
    };
    let fitted = |is_free: bool| {
        let rows = rows_of(is_free);
        let [of_acceleration, of_speed] = windows.noise;
        compared(&rows, &[of_acceleration, 0.0, of_speed], &[])
    };
    let fit = fitted(false).ok_or(IdentifyFault::NotExcited)?;
    let (hangs, constant, last) = (columns.hangs, columns.constant(), columns.last());
    let free = fitted(true).filter(|free| free.separates(last));
    let of = free.as_ref().unwrap_or(&fit);
    let weight = |row: &Row| {
        let part = |place: usize| Some(of.values.get(place)? * row.regressors.get(place)?);
        part(3).zip(part(4)).filter(|_| hangs).map(|(cosine, sine)| cosine + sine)
    };
    let per_stroke = |row: &Row| row.regressors.iter().take(1).copied().chain([1.0]).chain(weight(row)).collect();
    let unstated_nm = unstated(&rows_of(free.is_some()), of, &per_stroke);
    let (sine, cosine) = first.angle_rad.sin_cos();
    let weights = match turned {
        Some(_) => [(3, first.weight_nm), (4, 0.0)],
        None => [(3, cosine), (4, -sine)].map(|(place, part)| (place, first.weight_nm * part)),
    };
    let others = [(1, first.coulomb_nm), (2, first.viscous_nms), (constant, first.constant_nm)];
    let others = others.into_iter().filter(|(place, _)| both_ways || *place == 2);
    let weights = weights.into_iter().filter(|(_, stated)| hangs && stated.abs() > 0.3 * first.weight_nm.abs());
    let shares = Shares {
        payload: free.as_ref().and_then(|free| Share::of(free, last, 1.0)),
        inertia: Share::of(of, 0, first.inertia_kgm2),
        others: others.filter_map(|(place, stated)| Share::of(of, place, stated)).collect(),
        weights: weights.filter_map(|(place, stated)| Share::of(of, place, stated)).collect(),
        constant: Share::of(of, constant, first.constant_nm).filter(|_| both_ways),
        has_losses: false,
        torque_error_s: 0.0,
        unstated_nm,
    };
    let mut taken = |of, place: Option<usize>| take(&fit, of, place, both_ways, found);
    taken(Identified::LoadInertia, Some(0));
    taken(Identified::Coulomb, both_ways.then_some(1));
    taken(Identified::Viscous, Some(2));
    taken(Identified::External, both_ways.then_some(constant));
    match turned {
        Some(turned) => turned_gravity(&fit, first, turned, found),
        None => gravity(&fit, hangs, found),
    }
    if found.estimates.is_empty() { Err(IdentifyFault::NotExcited) } else { Ok(shares) }
}

/// Returns `true` if a segment adds another weight than the first.
fn adds_weight(load: &Load<'_, '_>, first: &Plain) -> bool {
    let own = |extra: &Extra| load.mechanism.plain(extra).map(|own| own.weight_nm);
    load.extras.iter().filter_map(own).any(|weight_nm| weight_nm != first.weight_nm)
}

/// Returns the torque that a segment adds to that of the first in a window \[Nm\]; `offset_rad`: angle of the mechanism at q = 0
/// beyond the stated one.
fn difference(own: &Plain, first: &Plain, window: &Window, offset_rad: f64) -> f64 {
    let weight = |plain: &Plain| {
        let (sine, cosine) = (plain.angle_rad + offset_rad).sin_cos();
        plain.weight_nm * (cosine * window.cosine - sine * window.sine)
    };
    (own.inertia_kgm2 - first.inertia_kgm2) * window.acceleration
        + (own.constant_nm - first.constant_nm)
        + (weight(own) - weight(first))
        + (own.coulomb_nm - first.coulomb_nm) * window.sign
        + (own.viscous_nms - first.viscous_nms) * window.speed
}

/// Largest variance beside loads of the strokes' own relative to that beside one load, with which the strokes have loads of their
/// own. A choice: losses that grow with the torque leave 0.3 with a flywheel.
const STROKES_OWN: f64 = 0.1;

/// Smallest rms value of what the strokes' own loads explain relative to that of the torque. A choice: losses that grow with the
/// torque explain up to 0.032.
const UNSTATED: f64 = 0.04;

/// Returns the largest rms torque of a stroke beside the common load, if a load of its own in each stroke explains the residuals.
///
/// # Symbols
/// The regressors of `own` are those of a load that a stroke carries: acceleration, constant torque, weight
/// # Valid
/// strokes with at least three equations more than `own` has regressors; residuals that depend on the position alike in all
/// strokes remain
fn unstated(rows: &[Row], fit_of_all: &Fit, own: &dyn Fn(&Row) -> Vec<f64>) -> Option<f64> {
    let residue = |row: &Row| {
        let value: f64 = row.regressors.iter().zip(&fit_of_all.values).map(|(a, b)| a * b).sum();
        Row { regressors: own(row), value: row.value - value, stroke: row.stroke, phase: row.phase }
    };
    let square = |rows: &[Row]| rows.iter().map(|row| row.value * row.value).sum::<f64>();
    let (mut count, mut free) = (0.0, 0.0);
    let [mut all, mut left, mut torque, mut most] = [0.0_f64; 4];
    for stroke in rows.chunk_by(|a, b| a.stroke == b.stroke) {
        let residues: Vec<Row> = stroke.iter().map(residue).collect();
        let Some(of_stroke) = fit(&residues, &[], &[]) else { continue };
        #[allow(clippy::cast_precision_loss, reason = "counts of windows")]
        let (rows, width) = (residues.len() as f64, of_stroke.values.len() as f64);
        let whole = square(&residues);
        (count, free) = (count + rows, free + rows - width);
        (all, left, torque) = (all + whole, left + of_stroke.square, torque + square(stroke));
        most = most.max((whole / rows).sqrt());
    }
    let is_own = left / free < STROKES_OWN * all / count;
    (is_own && all - left > UNSTATED * UNSTATED * torque).then_some(most)
}

fn take(fit: &Fit, of: Identified, place: Option<usize>, both_ways: bool, found: &mut Identification) {
    let Some(place) = place else {
        found.open.push((of, Open::OneDirection));
        return;
    };
    let Some((value, half_width)) = fit.estimate(place) else { return };
    let estimate = Estimate { of, value, half_width: half_width.max(QUADRATURE * value.abs()) };
    // In one direction friction and constant torque cannot be distinguished.
    if !fit.separates(place) {
        found.open.push((of, if both_ways { Open::NotSeparated } else { Open::OneDirection }));
    } else if of == Identified::LoadInertia && half_width >= super::SHARE_MOST * value.abs() {
        found.open.push((of, Open::Wide));
    } else {
        found.estimates.push(estimate);
    }
}

/// Computes weight and angle from the coefficients of cos q and sin q.
fn gravity(fit: &Fit, hangs: bool, found: &mut Identification) {
    if !hangs || !fit.separates(3) || !fit.separates(4) {
        found.open.extend([(Identified::Gravity, Open::NotSeparated), (Identified::GravityAngle, Open::NotSeparated)]);
        return;
    }
    let (Some(c), Some(s)) = (fit.values.get(3), fit.values.get(4)) else { return };
    let weight = c.hypot(*s);
    let factors = |of_c: f64, of_s: f64| fit.quantile * fit.deviation(&[0.0, 0.0, 0.0, of_c, of_s]);
    let size = weight.max(f64::MIN_POSITIVE);
    // Along the gradient of the hypotenuse and perpendicular to it; near zero the interval is the circle about both.
    let [along, across] = [factors(c / size, s / size), factors(-s / size, c / size)];
    let is_there = weight > 2.0 * along.max(across);
    let half = if is_there { along } else { CIRCLE * factors(1.0, 0.0).max(factors(0.0, 1.0)) };
    let mut push = |of, value: f64, half: f64| {
        found.estimates.push(Estimate { of, value, half_width: half });
    };
    push(Identified::Gravity, weight, half.max(QUADRATURE * weight));
    if is_there {
        push(Identified::GravityAngle, (-s).atan2(*c), (across / size).max(QUADRATURE));
    } else {
        found.open.push((Identified::GravityAngle, Open::NotSeparated));
    }
}

/// Returns weight and angle of a load whose payloads act at the same offset, with the offset.
fn turned_gravity(fit: &Fit, first: &Plain, turned: Turned, found: &mut Identification) {
    let (Some((weight, half)), Some((_, half_rad))) = (fit.estimate(3), fit.estimate(4)) else { return };
    if !fit.separates(3) || !fit.separates(4) {
        found.open.extend([(Identified::Gravity, Open::NotSeparated), (Identified::GravityAngle, Open::NotSeparated)]);
        return;
    }
    let half_rad = half_rad.max(QUADRATURE);
    // A negative weight is a positive one on the opposite side.
    let opposite = if weight < 0.0 { std::f64::consts::PI } else { 0.0 };
    let angle = first.angle_rad + turned.offset_rad + opposite;
    let turn = std::f64::consts::TAU;
    let mut push = |of, value: f64, half_width: f64| found.estimates.push(Estimate { of, value, half_width });
    push(Identified::Gravity, weight.abs(), half.max(QUADRATURE * weight.abs()));
    push(Identified::GravityAngle, angle - turn * (angle / turn).round(), half_rad);
    found.offset_rad = Some([turned.offset_rad, half_rad]);
}

/// Instants of a window at which the stated load is evaluated.
const WITHIN: u32 = 8;

/// Estimates friction, and for a linear drive inertia, of a load without constant coefficients, relative to the stated
/// load without friction.
fn relative_to_stated(
    run: &Observed,
    windows: &Windows,
    load: &Load<'_, '_>,
    found: &mut Identification,
) -> Result<Shares, IdentifyFault> {
    let Load { mechanism, extra, both_ways, .. } = *load;
    let is_even = mechanism.travel_m_per_rad().is_some();
    let none = Extra::none();
    let first = load.extras.first().unwrap_or(&none);
    let rows: Vec<Row> = windows
        .all
        .iter()
        .filter_map(|window| {
            let Part { own, factor } =
                extra(window.samples.start).map_or(Some(Part::NONE), |extra| part(run, window, load, extra))?;
            // The flange turns with every load, so that the acceleration is a column in each case.
            let mut regressors = vec![window.sign, window.speed, factor, factor * window.acceleration];
            regressors.extend(load.is_delayed.then_some(window.torque_rate));
            let flange = if load.losses.is_some() { load.flange_kgm2 * window.acceleration } else { 0.0 };
            Some(Row { regressors, value: window.torque - own - flange, stroke: window.stroke, phase: window.phase })
        })
        .collect();
    let noise = [0.0, windows.noise[1], 0.0, windows.noise[0]];
    let torque = norm(windows.all.iter().map(|window| window.torque));
    let Some(fit) = compared(&rows, &noise, &[]).map(|fit| fit.with_error(error_share(&rows, 2) * torque)) else {
        if load.losses.is_none() {
            return Err(IdentifyFault::NotExcited);
        }
        // Too few windows in which the power flows in one direction.
        let all = [Identified::LoadInertia, Identified::Coulomb, Identified::Viscous];
        found.open.extend(all.map(|of| (of, Open::NotSeparated)));
        let others = [Identified::External, Identified::Gravity, Identified::GravityAngle];
        found.open.extend(others.map(|of| (of, Open::NotConstant)));
        return Ok(Shares::default());
    };
    let per_stroke = |row: &Row| row.regressors.iter().skip(2).take(2).copied().collect();
    let unstated_nm = if is_even { unstated(&rows, &fit, &per_stroke) } else { None };
    let stated_nm = load.losses.filter(|_| is_even && both_ways).map_or(0.0, |losses| losses.constant_nm(first));
    let constant = Share::of(&fit, 2, stated_nm).map(|deviation| Share { value: 1.0 + deviation.value, ..deviation });
    let has_losses = load.losses.is_some();
    let shares = Shares { unstated_nm, constant, has_losses, ..shares_beside(run, windows, load) };
    if is_even {
        let stated = mechanism.inertia(0.0, first);
        let of = Identified::LoadInertia;
        let stated = quantities::Measure::si(stated) + if load.losses.is_some() { load.flange_kgm2 } else { 0.0 };
        match fit.estimate(3) {
            Some((value, half)) if fit.separates(3) && half < super::SHARE_MOST * (stated + value).abs() => {
                let half_width = half.max(QUADRATURE * stated);
                found.estimates.push(Estimate { of, value: stated + value, half_width });
            }
            _ => found.open.push((of, Open::Wide)),
        }
    } else {
        found.open.push((Identified::LoadInertia, Open::NotConstant));
    }
    take(&fit, Identified::Coulomb, both_ways.then_some(0), both_ways, found);
    take(&fit, Identified::Viscous, Some(1), both_ways, found);
    if let Some(losses) = load.losses {
        // What deviates from the stated friction, and a part beside the stated load, may lie in front of the losses or behind.
        let stated = losses.friction(first);
        let behind: Vec<Row> = rows.iter().map(|row| behind(row, stated)).collect();
        let column = |row: &Row, place: usize| row.regressors.get(place).copied().unwrap_or(0.0);
        let farthest = rows.iter().map(|row| (column(row, 2) - 1.0).abs()).fold(0.0, f64::max);
        let constant = fit.values.get(2).map_or(0.0, |value| value.abs());
        let apart = |place: usize, stated: f64| {
            let other = super::regression::fit(&behind, &noise, &[])?.values.get(place)? + stated;
            Some((other - fit.values.get(place)?).abs())
        };
        let [coulomb, viscous] = stated;
        for each in &mut found.estimates {
            each.half_width += match each.of {
                Identified::Coulomb => farthest * constant + apart(0, coulomb).unwrap_or(f64::INFINITY),
                Identified::Viscous => apart(1, viscous).unwrap_or(f64::INFINITY),
                Identified::LoadInertia => apart(3, 0.0).unwrap_or(f64::INFINITY),
                _ => 0.0,
            };
        }
    }
    let is_wide =
        |each: &Estimate| each.of == Identified::LoadInertia && each.half_width >= super::SHARE_MOST * each.value.abs();
    if found.estimates.iter().any(is_wide) {
        found.estimates.retain(|each| !is_wide(each));
        found.open.push((Identified::LoadInertia, Open::Wide));
    }
    let others = [Identified::External, Identified::Gravity, Identified::GravityAngle];
    found.open.extend(others.map(|of| (of, Open::NotConstant)));
    Ok(shares)
}

/// Returns an equation whose friction lies behind the losses, relative to the stated T_c and b.
///
/// T − T₀ − T_c σ − b ω = φ (δT_c σ + δb ω + δT + δJ α)
fn behind(row: &Row, [coulomb, viscous]: [f64; 2]) -> Row {
    let mut other = row.clone();
    if let [sign, speed, factor, ..] = other.regressors.as_mut_slice() {
        other.value -= coulomb * *sign + viscous * *speed;
        (*sign, *speed) = (*factor * *sign, *factor * *speed);
    }
    other
}

/// Returns the sign of the torque that accelerates in the direction of the position; `None` if the run does not show it.
pub(super) fn accelerating(windows: &Windows) -> Option<f64> {
    let row = |window: &Window| {
        let regressors = vec![window.acceleration, window.sign, window.speed, window.cosine, window.sine, 1.0];
        Row { regressors, value: window.torque, stroke: window.stroke, phase: window.phase }
    };
    let rows: Vec<Row> = windows.all.iter().map(row).collect();
    let (value, half) = fit(&rows, &[], &[])?.estimate(0)?;
    (value.abs() > half).then(|| value.signum())
}

/// Returns the stated load of the first segment, and what the segments add to it, as shares of the torque.
fn shares_beside(run: &Observed, windows: &Windows, load: &Load<'_, '_>) -> Shares {
    let none = Extra::none();
    let first = load.extras.first().unwrap_or(&none);
    let differs = load.extras.iter().any(|each| each != first);
    let row = |window: &Window| {
        let Part { own, factor } = part(run, window, load, first)?;
        let mut regressors = vec![own, window.sign, window.speed, factor];
        if differs {
            let extra = (load.extra)(window.samples.start);
            let all = extra.and_then(|extra| part(run, window, load, extra)).map_or(own, |all| all.own);
            regressors.push(all - own);
        }
        regressors.extend(load.is_delayed.then_some(window.torque_rate));
        Some(Row { regressors, value: window.torque, stroke: window.stroke, phase: window.phase })
    };
    let rows: Vec<Row> = windows.all.iter().filter_map(row).collect();
    let error = error_share(&rows, 3) * norm(rows.iter().map(|row| row.value));
    compared(&rows, &[], &[]).map(|fit| fit.with_error(error)).map_or_else(Shares::default, |fit| Shares {
        payload: Share::of(&fit, 4, 1.0).filter(|_| differs),
        inertia: Share::of(&fit, 0, 1.0),
        ..Shares::default()
    })
}

/// Returns the stated load without friction in a window; `None` if the mechanism has losses whose direction changes in it.
fn part(run: &Observed, window: &Window, load: &Load<'_, '_>, extra: &Extra) -> Option<Part> {
    let none = Extra::none();
    let first = load.extras.first().unwrap_or(&none);
    match load.losses {
        Some(losses) => losses.part(run, window, [load.flange_kgm2, load.noise_nm], [extra, first]),
        None => {
            let (own, first) = (load.mechanism.loading(extra), load.mechanism.loading(first));
            let own = mean(run, window, &|output| own.at(&output).torque_nm - friction(&first, output));
            Some(Part { own, ..Part::NONE })
        }
    }
}

/// Returns the friction of a load without losses \[Nm\]: odd in the direction, while the torque of a varying inertia is even.
pub(super) fn friction(loading: &Loading<'_>, output: Output) -> f64 {
    let back = Output { speed_rad_s: -output.speed_rad_s, direction: -output.direction, ..output };
    0.5 * (loading.at(&output).torque_nm - loading.at(&back).torque_nm)
}

/// Returns the weighted mean of a quantity over a window; the direction of the states is that of the window.
pub(super) fn mean(run: &Observed, window: &Window, of: &dyn Fn(Output) -> f64) -> f64 {
    let length = window.samples.len() - 1;
    let [mut sum, mut all] = [0.0; 2];
    let at = |place: usize| Some((*run.time_s.get(place)?, *run.position_rad.get(place)?));
    let Some((begin, end)) = at(window.samples.start).zip(at(window.samples.start + length)) else { return 0.0 };
    let middle = 0.5 * (begin.0 + end.0);
    for k in 1..WITHIN {
        let x = f64::from(k) / f64::from(WITHIN);
        let weight = (std::f64::consts::PI * x).sin().powi(4);
        let Some((time, position_rad)) = at(window.samples.start + length * k as usize / WITHIN as usize) else {
            continue;
        };
        let speed_rad_s = window.speed + window.acceleration * (time - middle);
        let acceleration_rad_s2 = window.acceleration;
        sum += weight * of(Output { position_rad, speed_rad_s, acceleration_rad_s2, direction: window.sign });
        all += weight;
    }
    sum / all
}
