//! The limits of the torque-speed plane, for pictures.

use crate::project::Project;
use crate::sizing_use::Candidate;
use actuator::{CurveKind, Parameters, PerformanceCurve};
use order_code::OrderCode;
use provenance::Missing;
use quantities::{AngularVelocity, ElectricPotential, Measure, Torque};

/// Shares of the terminal voltage at which the short-time limit is shown besides, as the DC link sags.
const SAGGED: [f64; 2] = [0.8, 0.6];

/// The limits of an actuator in the torque-speed plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    /// Continuous duty, S3, short time at the terminal voltage, in this order; what is not known is left out.
    pub curves: Vec<PerformanceCurve>,
    /// Short-time limits at lower terminal voltages that differ, the highest first; none where no voltage is given.
    pub sagged: Vec<PerformanceCurve>,
    /// The limit while braking: its largest speed and T_max, which the voltage does not lower.
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

/// The limits of a candidate at the terminal voltage of the project's supply.
///
/// # Errors
/// The first datum that is missing if no curve can be drawn.
pub fn plane(project: &Project, candidate: &Candidate<'_>) -> Result<Plane, Missing> {
    Plane::of(candidate.parameters, project.axis.terminal_voltage())
}

/// The limits of a code at a terminal voltage; `None` where the manual prints no data.
///
/// # Errors
/// The first datum that is missing if no curve can be drawn.
pub fn plane_of(code: &OrderCode, terminal: Option<ElectricPotential>) -> Option<Result<Plane, Missing>> {
    Some(Plane::of(&configurator::parameters(code)?, terminal))
}
