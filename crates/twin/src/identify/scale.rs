//! Scale of torque and current: balance of the motor, payloads and project under each known convention.

use super::doubts::{Column, Doubt, Misread, SCATTER};
use super::load::{Share, Shares};
use super::motor::{Equations, Scale, Tabulated, Tie};
use super::regression::fit;
use super::windows::Windows;
use std::f64::consts::SQRT_2;

/// One lbf ft in Nm.
const FOOT_POUND: f64 = 1.355_817_948_331_400_4;

/// One kgf in N.
const KILOGRAM_FORCE: f64 = 9.806_65;

/// Returns the known conventions of torque and current, with the factor of the signal.
fn conventions(ratio: f64) -> [(Column, Misread, f64); 13] {
    use Column::{Current, Torque};
    [
        (Torque, Misread::MotorShaft, 1.0 / ratio),
        (Torque, Misread::NewtonMillimetres, 1e3),
        (Torque, Misread::NewtonCentimetres, 1e2),
        (Torque, Misread::KilonewtonMetres, 1e-3),
        (Torque, Misread::PoundForceFeet, 1.0 / FOOT_POUND),
        (Torque, Misread::PoundForceInches, 12.0 / FOOT_POUND),
        (Torque, Misread::OunceForceInches, 192.0 / FOOT_POUND),
        (Torque, Misread::KilogramForceMetres, 1.0 / KILOGRAM_FORCE),
        (Torque, Misread::KilogramForceCentimetres, 100.0 / KILOGRAM_FORCE),
        (Current, Misread::Rms, 1.0 / SQRT_2),
        (Current, Misread::PeakTwice, SQRT_2),
        (Current, Misread::PowerInvariant, 1.224_744_871_391_589),
        (Current, Misread::Milliamperes, 1e3),
    ]
}

/// Largest deviation of the slope of current over torque from the tables that is no doubt, beyond its interval. A choice.
const SLOPE: f64 = 0.2;

/// Half intervals by which a slope must lie beside a scale that it excludes. A choice: three standard deviations, since every run is
/// tried.
const BEYOND: f64 = 1.5;

/// Deviation of a torque constant beyond the usual scatter with which a convention is still named. A choice.
const FURTHER: f64 = 0.03;

/// Largest relative half interval of a slope that confirms a scale. A choice.
const CONFIRMED: f64 = 0.3;

/// Largest half interval of that slope relative to its value with which it excludes a scale. A choice.
const VAGUE: f64 = 1.0;

/// Largest difference of two shares that one scale explains. A choice.
const ALIKE: f64 = 0.03;

/// Smallest deviation of a scale from one that causes a doubt without the balance of the motor. A choice.
const SCALED: f64 = 0.15;

/// Smallest factor between run and project that counts as an unknown scale while the motor contradicts neither. A choice: what a
/// project states may be off by 40 %, all of it alike, which is a factor of 1.67.
const UNKNOWN: f64 = 1.75;

/// Standard deviations of what a project states, relative to the value: payloads, inertia, the rest. A choice.
const STATED: [f64; 3] = [0.05, 0.15, 0.3];

/// Largest contribution of one share, so that a single wrong entry of the project does not decide.
const COST_MOST: f64 = 9.0;

/// Smallest difference of the sums of squares with which a convention is named that the motor does not require: the load is off by
/// its factor, and the motor does not decide. A choice: likelihoods of 1 to 55.
const LIKELIER: f64 = 8.0;

/// Smallest difference of the squared deviations of a torque constant from that of a convention and from the tables with which the
/// convention is excluded. A choice: likelihoods of 1 to 2.7.
const EXCLUDED: f64 = 2.0;

/// Returns `true` if a torque constant relative to the tables, with half its interval, excludes currents √2 times too small or too
/// large.
pub(super) fn excludes_root_two(Share { value, half_width }: Share) -> bool {
    let squared = |factor: f64| {
        let own = 0.5 * half_width / value;
        ((value / factor).ln()).powi(2) / own.mul_add(own, SCATTER * SCATTER)
    };
    value > 0.0 && [SQRT_2, SQRT_2.recip()].iter().all(|factor| squared(*factor) - squared(1.0) > EXCLUDED)
}

/// Slope of current over torque relative to the tables under a scale, for both references of the rotor.
struct Slopes {
    all: [Option<Share>; 2],
}

impl Slopes {
    fn of(equations: &Equations<'_>, tabulated: &Tabulated, scale: Scale) -> Self {
        let lag = equations.lag_s(scale);
        let slope = |tie| {
            let fit = equations.fit(fit, scale, lag, tie).filter(|fit| !fit.is_attenuated)?;
            let (value, half_width) = fit.estimate(0)?;
            let constant = tabulated.relative(Share { value: value.recip(), half_width: half_width / (value * value) });
            let value_relative = constant.value.recip();
            Some(Share { value: value_relative, half_width: constant.half_width * value_relative * value_relative })
        };
        Self { all: [slope(Tie::ToTorque), slope(Tie::ToTable)] }
    }

    /// Returns `true` if no slope excludes that the scale is right within a tolerance, beyond a number of half intervals.
    fn admits(&self, within: f64, beyond: f64) -> bool {
        let excludes = |slope: &Share| {
            let vague = slope.half_width > VAGUE * slope.value.abs();
            let low = slope.value - beyond * slope.half_width > 1.0 + within;
            let high = slope.value + beyond * slope.half_width < 1.0 / (1.0 + within);
            !vague && (low || high)
        };
        !self.all.iter().flatten().any(excludes)
    }

    /// Returns the measured factor of a torque, or the measured torque constant over that of the tables.
    fn measured(&self, column: Column) -> Option<f64> {
        // The tie to the table leaves the scale of the torque open, that to the torque the scale of the current.
        let [tied, loose] = self.all;
        let slope = if column == Column::Torque { loose } else { tied };
        slope.filter(|slope| slope.half_width < CONFIRMED * slope.value).map(|slope| slope.value.recip())
    }

    /// Returns `true` if a slope lies near one, so that the scale is also confirmed.
    fn confirms(&self) -> bool {
        self.admits(SCATTER + FURTHER, 1.0)
            && self.all.iter().flatten().any(|slope| slope.half_width < CONFIRMED * slope.value.abs())
    }

    /// Returns the squared deviation from one over its variance.
    fn cost(&self) -> f64 {
        let [tied, _] = self.all;
        tied.map_or(COST_MOST, |slope| off(slope, 1.0, SCATTER))
    }
}

/// Returns the squared logarithm of a share over a scale, relative to its variance.
fn off(share: Share, scale: f64, spread: f64) -> f64 {
    let ratio = share.value / scale;
    if ratio <= 0.0 {
        return COST_MOST;
    }
    let own = 0.5 * share.half_width / share.value;
    (ratio.ln().powi(2) / own.mul_add(own, spread * spread)).min(COST_MOST)
}

/// Returns how far payloads and project contradict a scale of the torque.
fn contradiction(shares: &Shares, torque: f64) -> f64 {
    let [payload, inertia, rest] = STATED;
    let of = |share: Option<Share>, spread| share.map_or(0.0, |share| off(share, torque, spread));
    let others = shares.others.iter().chain(&shares.weights).map(|share| off(*share, torque, rest));
    of(shares.payload, payload) + of(shares.inertia, inertia) + others.sum::<f64>()
}

/// Returns the scale of the torque that the payloads, or the project's inertia and friction, show alike.
fn of_load(shares: &Shares) -> Option<f64> {
    let is_off = |share: &Share| {
        share.value > 0.0
            && (share.value.ln().abs() - share.half_width / share.value) > SCALED.ln_1p()
            && share.half_width < 0.1 * share.value
    };
    let alike = |a: &Share, b: &Share| {
        let within = (a.half_width / a.value).hypot(b.half_width / b.value);
        (a.value / b.value - 1.0).abs() < ALIKE + within
    };
    let known: Vec<&Share> = shares.payload.iter().chain(&shares.inertia).chain(&shares.others).collect();
    let first = shares.payload.as_ref().or(shares.inertia.as_ref()).filter(|share| is_off(share))?;
    let witnesses = known.into_iter().filter(|share| !std::ptr::eq(*share, first));
    let mut all = witnesses.filter(|share| is_off(share) && alike(first, share));
    all.next().map(|_| first.value)
}

/// Returns the doubt of the scale of torque or current.
///
/// # Symbols
/// The value of a doubt of the torque is its size relative to the expected one, of the current the torque constant relative to
/// the tables.
/// # Valid
/// one of both signals has another scale
pub(super) fn doubt(windows: &Windows, tabulated: &Tabulated, shares: &Shares, is_delayed: bool) -> Option<Doubt> {
    // A current at its limit follows no equation, if it is none of another unit.
    let is_limited = Equations::free(windows, false, None, false).is_none();
    if is_limited && !windows.all.iter().any(|window| window.exceeds) {
        return None;
    }
    let equations = Equations::of(windows, shares.has_losses, Some(*tabulated), is_delayed)
        .with_torque_error(shares.torque_error_s);
    let plain = Slopes::of(&equations, tabulated, Scale::NONE);
    let of_load = of_load(shares);
    let scaled = |column, factor| match column {
        Column::Torque => Scale { torque: factor, ..Scale::NONE },
        _ => Scale { current: factor, ..Scale::NONE },
    };
    // A load that is off too needs less of the motor.
    let is_wrong = !plain.admits(SLOPE, if of_load.is_some() { 1.0 } else { BEYOND });
    let [tied, loose] = plain.all;
    let ratio = |slope: Option<Share>| slope.filter(|slope| slope.value != 0.0).map(|slope| slope.value.recip());
    let measured = ratio(loose).filter(|measured| *measured > 0.0);
    let least = measured.map_or(f64::INFINITY, |measured| contradiction(shares, measured));
    // Two entries of a project that are off alike may be a coincidence: the motor must agree better, too.
    let is_better = |slopes: &Slopes| slopes.admits(SCATTER, 1.0) && slopes.cost() < plain.cost();
    let without = plain.cost() + contradiction(shares, 1.0);
    let named = conventions(tabulated.ratio)
        .into_iter()
        .filter_map(|(column, misread, factor)| {
            let torque = if column == Column::Torque { factor } else { 1.0 };
            // Without a contradiction of the motor only the load speaks, of the torque.
            let near = of_load.is_some_and(|scale| (scale / torque).ln().abs() < ALIKE);
            let slopes = Slopes::of(&equations, tabulated, scaled(column, factor));
            // The load may agree with the measured scale of the torque only.
            let fits = if is_wrong {
                slopes.confirms() && contradiction(shares, torque) < least + COST_MOST
            } else {
                let with = slopes.cost() + contradiction(shares, torque);
                let is_far = column == Column::Torque && factor.ln().abs() > UNKNOWN.ln();
                (near && is_better(&slopes)) || (is_far && slopes.admits(SCATTER, 1.0) && without - with > LIKELIER)
            };
            fits.then(|| (slopes.cost() + contradiction(shares, torque), column, misread, factor))
        })
        .min_by(|a, b| a.0.total_cmp(&b.0));
    if let Some((_, column, misread, factor)) = named {
        let by_convention = if column == Column::Torque { factor } else { 1.0 / factor };
        let of_motor = is_wrong.then(|| plain.measured(column)).flatten();
        let value = of_motor.or(of_load.filter(|_| column == Column::Torque)).unwrap_or(by_convention);
        return Some(Doubt { column, misread, value, by_convention: Some(by_convention) });
    }
    if !is_wrong {
        let is_scale = |factor: &f64| is_better(&Slopes::of(&equations, tabulated, scaled(Column::Torque, *factor)));
        let is_far = |factor: &f64| factor.ln().abs() > UNKNOWN.ln();
        let value = of_load.filter(|_| shares.payload.is_some()).filter(is_far).filter(is_scale)?;
        return Some(Doubt::new(Column::Torque, Misread::Other, value));
    }
    let (of_torque, of_current) = (ratio(loose).or(ratio(tied))?, ratio(tied).or(ratio(loose))?);
    let is_torque = of_torque > 0.0 && contradiction(shares, of_torque) < contradiction(shares, 1.0);
    let (column, value) = if is_torque { (Column::Torque, of_torque) } else { (Column::Current, of_current) };
    (value > 0.0).then_some(Doubt::new(column, Misread::Other, value))
}

/// Largest deviation of the payloads of a run from the stated ones, beyond its interval. A choice.
const LADEN: f64 = 0.15;

/// Returns the doubt of payloads that the run does not show.
pub(super) fn payload(shares: &Shares) -> Option<Doubt> {
    let Share { value, half_width } = shares.payload?;
    let is_off = (value - 1.0).abs() - half_width > LADEN;
    is_off.then_some(Doubt::new(Column::Torque, Misread::PayloadMissing, value))
}
