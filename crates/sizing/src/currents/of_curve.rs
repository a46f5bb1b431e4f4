//! Current that the manufacturer's short-time curve permits.

use super::Currents;
use crate::check::{Amount, Check, CheckId, Verdict};
use crate::comparison::Comparison;
use crate::list::Case;
use crate::notes::Note;
use actuator::{CurvePoint, FrictionAt, MotorCurrent};
use derivation::Workings;
use numeric::at_most;
use provenance::{Source, Sourced};
use quantities::unit::AMPERE;
use quantities::{ElectricCurrent, Measure, Time};

/// Limit of the manufacturer's short-time curve, which may permit more than the stated I_max.
#[derive(Clone, Copy)]
pub(super) struct OfCurve<'a> {
    pub(super) curve: &'a actuator::Curve,
    /// T_max \[Nm\], which caps the curve; infinite if unknown.
    pub(super) torque_max: f64,
    /// I_E \[A\], which caps the current; infinite if unknown.
    pub(super) current_most: f64,
}

impl OfCurve<'_> {
    /// Returns the current of a torque of the curve with that of the friction \[A\].
    pub(super) fn current(&self, motor: &MotorCurrent, torque: f64, friction: f64) -> f64 {
        (motor.of_torque(torque.min(self.torque_max)) + friction).min(self.current_most)
    }

    /// Returns the speeds at which the permissible current has a corner, in ascending order: those of the curve, those at which
    /// it crosses T_max, and those at which its current, of its torque or of T_max, crosses the limit of the manual or I_E.
    pub(super) fn corners(&self, motor: &MotorCurrent, printed: f64, states: &[&FrictionAt]) -> Vec<f64> {
        let mut corners = Vec::new();
        let points = self.curve.points();
        for (a, b) in points.iter().zip(points.iter().skip(1)) {
            corners.extend([a.speed.si(), b.speed.si()]);
            let mut cross = |[from, to]: [f64; 2]| {
                if from * to < 0.0 {
                    corners.push(a.speed.si() + from / (from - to) * (b.speed.si() - a.speed.si()));
                }
            };
            cross([a, b].map(|point| point.torque.si() - self.torque_max));
            for friction in states {
                for most in [f64::INFINITY, self.torque_max] {
                    let at = |point: &CurvePoint, limit: f64| {
                        let torque = point.torque.si().min(most);
                        motor.of_torque(torque) + friction.current(point.speed).si() - limit
                    };
                    for limit in [printed, self.current_most] {
                        cross([a, b].map(|point| at(point, limit)));
                    }
                }
            }
        }
        // Beyond its end the curve permits no current.
        corners.extend(points.last().map(|end| end.speed.si().next_up()));
        corners.sort_by(f64::total_cmp);
        corners.dedup();
        corners
    }
}

/// Checks I_peak ≤ I_max where no instant exceeds the current of the published short-time curve, `share` of which is used at
/// most: above I_max the curve permits the torque, but a drive that is set to I_max does not deliver it.
pub(super) fn within_the_curve(
    case: &Case<'_>,
    currents: &Currents<'_>,
    (limit, share): (&Sourced<ElectricCurrent>, f64),
    work: &mut Workings,
) -> Check {
    let peak = currents.peak(case.axis);
    let current = currents.extreme(&peak).abs();
    currents.explain_peak(&peak, None, (case.axis, case.actuator), work);
    work.value("I_peak");
    work.given("I_max", &AMPERE, limit);
    work.limit("I_max");
    let mut notes = currents.notes.clone();
    if !at_most(current, limit.value.si()) {
        notes.push(Note::PermittedByCurve(Amount { si: current / share, unit: &AMPERE }));
    }
    Comparison {
        at: Some(Time::from_si(peak.time_s)),
        grade: currents.grade.worst(limit.grade),
        notes,
        ..Comparison::with(CheckId::PeakCurrent, &AMPERE, current, Source::Model { name: "current" }, limit)
    }
    .answer(Verdict::Advice)
}
