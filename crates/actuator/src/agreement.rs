//! Agreement of the heat model with published curves: results of the model for a duty that the manufacturer or the user
//! permits.

use crate::curve::Curve;
use crate::heat_model::HeatModel;
use crate::parameters::Drivetrain;
use provenance::{Datum, Sourced};
use quantities::{AngularVelocity, Measure, Torque};

/// Result of the heat model for the published duty closest to a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PublishedDuty {
    /// Rise of the winding relative to the permitted one \[1\]: the divisor that makes the estimate agree.
    pub rise_share: f64,
    /// Largest filtered (I/I_0)² \[1\], which the overload supervision must permit.
    pub overload: f64,
}

impl PublishedDuty {
    /// Returns the factor that scales the modelled rise of the winding to the published curves.
    #[must_use]
    pub fn rise_scale(&self) -> f64 {
        1.0 / self.rise_share
    }
}

/// Returns the result of the heat model for the published curves at the duty factor and mean speed of a cycle; `None`
/// if none is published there.
///
/// The continuous curve is evaluated at the mean speed, the S3 curves at the speed in motion, with linear interpolation
/// over the duty factor in between. Where a curve stays at T_0, or is an S3 curve, the limit may be that of the gear
/// instead of the heat: there it can only relax the estimate.
///
/// # Symbols
/// duty factor ED, mean speed n_av over the whole cycle
/// # Source
/// docs/theory/thermal.md; curves of [`crate::Drivetrain`]
#[must_use]
pub fn published_duty(
    actuator: &Drivetrain,
    model: &HeatModel,
    duty: f64,
    speed_mean: AngularVelocity,
) -> Option<PublishedDuty> {
    let in_motion = AngularVelocity::from_si(if duty > 0.0 { speed_mean.si() / duty } else { 0.0 });
    let at = |curve: &Sourced<Curve>, factor: f64, speed: AngularVelocity, most: &Datum<Torque>| {
        let curve = &curve.value;
        let end = curve.points().last().map_or(0.0, |point| point.speed.si());
        let speed = AngularVelocity::from_si(speed.si().abs().min(end));
        let most = most.known().map_or(f64::INFINITY, |most| most.value.si());
        let torque = Torque::from_si(curve.at(speed).si().min(most));
        said(actuator, model, torque, speed, factor).map(|said| (said, torque.si() < most * (1.0 - 1e-9)))
    };
    let continuous = || {
        let (found, by_heat) = at(actuator.continuous_curve.known()?, 1.0, speed_mean, &actuator.stall_torque)?;
        let rise_share = if by_heat { found.rise_share } else { found.rise_share.max(1.0) };
        Some(PublishedDuty { rise_share, ..found })
    };
    let [half, quarter] = &actuator.s3_curves;
    let intermittent = |curve: &Datum<Curve>, factor: f64| {
        let (found, _) = at(curve.known()?, factor, in_motion, &actuator.torque_max)?;
        Some(PublishedDuty { rise_share: found.rise_share.max(1.0), ..found })
    };
    let between = |slow: PublishedDuty, quick: PublishedDuty, share: f64| PublishedDuty {
        rise_share: quick.rise_share + share * (slow.rise_share - quick.rise_share),
        overload: quick.overload + share * (slow.overload - quick.overload),
    };
    if duty >= 1.0 - 1e-9 {
        return continuous();
    }
    if duty > 0.5 {
        return match (continuous(), intermittent(half, 0.5)) {
            (Some(slow), Some(quick)) => Some(between(slow, quick, (duty - 0.5) / 0.5)),
            (slow, _) => slow,
        };
    }
    match (intermittent(half, 0.5), intermittent(quarter, 0.25)) {
        (Some(slow), Some(quick)) => Some(between(slow, quick, ((duty - 0.25) / 0.25).max(0.0))),
        (Some(slow), None) => Some(slow),
        (None, _) => continuous(),
    }
}

/// Returns the result of the model for a torque at a speed, applied for a share of the S3 cycle, with rest for the
/// remainder.
fn said(
    actuator: &Drivetrain,
    model: &HeatModel,
    torque: Torque,
    speed: AngularVelocity,
    duty: f64,
) -> Option<PublishedDuty> {
    let stall = actuator.stall_current.known()?.value.si();
    let cycle = actuator.heat.intermittent_cycle.known()?.value;
    let (rise_share, settled) = model.rise_share(torque, speed, duty, cycle);
    let current = model.current(torque, speed, &settled.friction).si() / stall;
    let tau = model.winding_time_constant().si();
    let filter = if duty < 1.0 { (-duty * cycle.si() / tau).exp_m1() / (-cycle.si() / tau).exp_m1() } else { 1.0 };
    Some(PublishedDuty { rise_share, overload: current * current * filter })
}
