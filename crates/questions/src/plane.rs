//! Limits of the torque-speed plane, for pictures.

use crate::sizing_use::Candidate;
use actuator::{CurveKind, CurvePoint, Parameters, PerformanceCurve};
use axis::AxisProject;
use configurator::Product;
use provenance::Missing;
use quantities::{AngularVelocity, ElectricPotential, Measure, Torque};

/// Shares of the terminal voltage at which the short-time limit is also shown, for a sagging DC link.
const SAGGED: [f64; 2] = [0.8, 0.6];

/// Limits of an actuator in the torque-speed plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    /// Continuous duty, S3, short-time duty at the terminal voltage, in this order; unknown curves are left out.
    pub curves: Vec<PerformanceCurve>,
    /// Short-time limits at lower terminal voltages, if they differ, the highest first; empty without a voltage.
    pub sagged: Vec<PerformanceCurve>,
    /// Limit while braking: its largest speed and T_max, which the voltage does not lower.
    pub braking: Option<(AngularVelocity, Torque)>,
}

impl Plane {
    fn of(actuator: &Parameters, terminal: Option<ElectricPotential>) -> Result<Self, Missing> {
        let curves = actuator::performance_curves(actuator, terminal)?;
        let short_time =
            |curves: &[PerformanceCurve]| curves.iter().find(|curve| curve.kind == CurveKind::ShortTime).cloned();
        let full = short_time(&curves);
        let mut sagged: Vec<PerformanceCurve> = Vec::new();
        for voltage in terminal.into_iter().flat_map(|full| SAGGED.map(|share| full.si() * share)) {
            let lower = actuator::performance_curves(actuator, Some(ElectricPotential::from_si(voltage)));
            let Some(curve) = lower.ok().as_deref().and_then(short_time) else { continue };
            let above = sagged.last().or(full.as_ref());
            if above.is_some_and(|above| above.points != curve.points) {
                sagged.push(curve);
            }
        }
        let braking = full.and_then(|curve| Some((curve.points.last()?.speed, actuator.torque_max.known()?.value)));
        Ok(Self { curves, sagged, braking })
    }
}

/// Returns the limits of a candidate at the terminal voltage of the project's supply.
///
/// # Errors
/// The first missing datum if no curve can be drawn.
pub fn plane(project: &AxisProject, candidate: &Candidate<'_>) -> Result<Plane, Missing> {
    Plane::of(candidate.parameters, project.axis.terminal_voltage())
}

/// Returns the limits of a code at a terminal voltage; `None` if the manual states no data.
///
/// # Errors
/// The first missing datum if no curve can be drawn.
pub fn plane_of(product: &Product, terminal: Option<ElectricPotential>) -> Result<Plane, Missing> {
    Plane::of(&product.parameters, terminal)
}

/// Returns both edges of a curve at every speed of either, interpolated linearly between their points, which may have
/// different speeds.
#[must_use]
pub fn curve_rows(curve: &PerformanceCurve) -> Vec<(AngularVelocity, Option<Torque>, Option<Torque>)> {
    rows(&curve.points, curve.upper.as_deref().unwrap_or_default())
}

fn rows(lower: &[CurvePoint], upper: &[CurvePoint]) -> Vec<(AngularVelocity, Option<Torque>, Option<Torque>)> {
    let mut speeds: Vec<AngularVelocity> = lower.iter().map(|point| point.speed).collect();
    let has = |speeds: &[AngularVelocity], speed: AngularVelocity| {
        speeds.iter().any(|known| (known.si() - speed.si()).abs() <= 1e-9 * speed.si().abs())
    };
    for point in upper {
        if !has(&speeds, point.speed) {
            speeds.push(point.speed);
        }
    }
    speeds.sort_by(|a, b| a.si().total_cmp(&b.si()));
    let mut rows = Vec::with_capacity(speeds.len());
    let mut last: Option<AngularVelocity> = None;
    for speed in speeds {
        // At a drop of a curve two of its points have the same speed: both are returned.
        let again = last.is_some_and(|last| last.si() == speed.si());
        rows.push((speed, at_speed(lower, speed, again), at_speed(upper, speed, again)));
        last = Some(speed);
    }
    rows
}

/// Returns the torque at a speed; of two points at the same speed the first, or the last if `again` is set. `None`
/// beyond the last point.
fn at_speed(points: &[CurvePoint], speed: AngularVelocity, again: bool) -> Option<Torque> {
    let near = |point: &&CurvePoint| (point.speed.si() - speed.si()).abs() <= 1e-9 * speed.si().abs();
    let found = if again { points.iter().rfind(near) } else { points.iter().find(near) };
    let between = || {
        let (low, high) = points
            .iter()
            .zip(points.iter().skip(1))
            .find(|(a, b)| a.speed.si() < speed.si() && speed.si() < b.speed.si())?;
        let share = (speed.si() - low.speed.si()) / (high.speed.si() - low.speed.si());
        Some(low.torque + (high.torque - low.torque) * share)
    };
    found.map(|point| point.torque).or_else(between)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_edges_of_a_band_are_reported_at_the_same_speed() {
        let point = |(speed, torque): &(f64, f64)| CurvePoint {
            speed: AngularVelocity::from_si(*speed),
            torque: Torque::from_si(*torque),
        };
        let lower: Vec<CurvePoint> = [(0.0, 80.0), (10.0, 70.0), (10.0, 0.0)].iter().map(point).collect();
        let upper: Vec<CurvePoint> = [(0.0, 90.0), (4.0, 88.0), (8.0, 84.0), (10.0, 80.0)].iter().map(point).collect();
        let edges: Vec<(f64, Option<f64>, Option<f64>)> = rows(&lower, &upper)
            .into_iter()
            .map(|(speed, a, b)| (speed.si(), a.map(Measure::si), b.map(Measure::si)))
            .collect();
        let expected = [
            (0.0, Some(80.0), Some(90.0)),
            (4.0, Some(76.0), Some(88.0)),
            (8.0, Some(72.0), Some(84.0)),
            (10.0, Some(70.0), Some(80.0)),
            (10.0, Some(0.0), Some(80.0)),
        ];
        assert_eq!(edges, expected);
    }
}
