//! Budget of all angular errors at the output.

use crate::output_bearing::tilt_angle;
use crate::parameters::{Drivetrain, Parameters};
use provenance::{Datum, Grade, Source, Sourced};
use quantities::{Angle, Length, Measure, Torque};

/// A contribution to the angular error at the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ErrorKind {
    /// Transmission accuracy of the gear.
    TransmissionAccuracy,
    /// Repeatability of the gear.
    Repeatability,
    /// Hysteresis of the gear.
    Hysteresis,
    /// Lost motion of the gear.
    LostMotion,
    /// Accuracy of the feedback.
    FeedbackAccuracy,
    /// Resolution of the feedback.
    FeedbackResolution,
    /// Torsion of the gear under torque.
    Torsion,
    /// Tilt of the flange under a moment.
    Tilt,
    /// Backlash of a stage after the actuator.
    StageBacklash,
    /// Torsion of a stage after the actuator.
    StageTorsion,
}

/// Feedback that closes the position loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PositionLoop {
    /// Motor feedback, which does not measure the errors of the gear.
    Motor,
    /// Feedback at the output, which measures the errors of the gear, so that the loop removes them.
    Output,
}

/// Conditions of an error budget.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BudgetCase {
    /// Torque at the output that causes the torsion.
    pub torque: Torque,
    /// Tilting moment at the flange; `None` if the loads on the flange are unknown.
    pub tilting_moment: Option<Torque>,
    /// Feedback that closes the position loop.
    pub position_loop: PositionLoop,
}

/// An entry of the budget.
#[derive(Clone, Debug, PartialEq)]
pub struct Contribution {
    /// Kind of the error.
    pub kind: ErrorKind,
    /// Magnitude of the error at the output.
    pub angle: Sourced<Angle>,
}

/// Error budget with known and unknown contributions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ErrorBudget {
    /// Contributions with known values.
    pub contributions: Vec<Contribution>,
    /// Contributions with unknown values, which make the sums lower bounds.
    pub missing: Vec<ErrorKind>,
}

impl ErrorBudget {
    /// Returns the sum of all contributions: every error at its limit and in the same direction.
    ///
    /// Σ φ_k
    #[must_use]
    pub fn worst_case(&self) -> Angle {
        Angle::from_si(self.contributions.iter().map(|entry| entry.angle.value.si()).sum())
    }

    /// Returns the root of the sum of squares: independent, random errors.
    ///
    /// √(Σ φ_k²)
    #[must_use]
    pub fn root_sum_square(&self) -> Angle {
        let squares: f64 = self.contributions.iter().map(|entry| entry.angle.value.si().powi(2)).sum();
        Angle::from_si(squares.sqrt())
    }

    /// Returns the worst grade of the contributions.
    #[must_use]
    pub fn grade(&self) -> Grade {
        self.contributions.iter().map(|entry| entry.angle.grade).fold(Grade::Computed, Grade::worst)
    }
}

/// Returns the displacement at the end of a lever caused by a small angle.
///
/// s = φ r
///
/// # Symbols
/// φ angle \[rad\], r lever arm \[m\]
/// # Source
/// definition of the radian
/// # Valid
/// small angles
#[must_use]
pub fn deviation_at(angle: Angle, lever_arm: Length) -> Length {
    Length::from_si(angle.si() * lever_arm.si())
}

/// Returns the angular errors at the output of an actuator.
///
/// Gear errors count in full as stated in the tables; the errors of the motor feedback are divided by i; torsion and
/// tilt are those of the given torque and moment. A loop closed at the output leaves only feedback and tilt.
///
/// # Source
/// docs/theory/error-budget.md; eqs. 73.1 to 73.3 for the torsion, eq. 76.4 for the tilt
/// # Valid
/// static; without thermal expansion and without errors of the load, of the mounting and of the controller
#[must_use]
pub fn error_budget(actuator: &Parameters, case: &BudgetCase) -> ErrorBudget {
    let gear = &actuator.accuracy;
    let feedback = match case.position_loop {
        PositionLoop::Motor => &actuator.feedback,
        PositionLoop::Output => &actuator.feedback_out,
    };
    let (torsion, tilt) = (torsion(actuator, case.torque), tilt(actuator, case.tilting_moment));
    let (accuracy, resolution) = (feedback.accuracy_out(&actuator.ratio), feedback.resolution_out(&actuator.ratio));
    let of_the_gear = [
        (ErrorKind::TransmissionAccuracy, &gear.transmission_accuracy),
        (ErrorKind::Repeatability, &gear.repeatability),
        (ErrorKind::Hysteresis, &gear.hysteresis_loss),
        (ErrorKind::LostMotion, &gear.lost_motion),
        (ErrorKind::Torsion, &torsion),
    ];
    let of_the_rest = [
        (ErrorKind::FeedbackAccuracy, &accuracy),
        (ErrorKind::FeedbackResolution, &resolution),
        (ErrorKind::Tilt, &tilt),
    ];
    let mut budget =
        ErrorBudget { contributions: Vec::with_capacity(of_the_gear.len() + of_the_rest.len()), missing: Vec::new() };
    let seen = of_the_gear.into_iter().filter(|_| case.position_loop == PositionLoop::Motor);
    for (kind, datum) in seen.chain(of_the_rest) {
        match datum.known() {
            Some(angle) => budget.contributions.push(Contribution { kind, angle: angle.clone() }),
            None => budget.missing.push(kind),
        }
    }
    budget
}

/// Returns the magnitude of the torsion under a torque.
fn torsion(actuator: &Drivetrain, torque: Torque) -> Datum<Angle> {
    let [k1, k2, k3] = &actuator.gear.stiffness;
    let grades = [k1, k2, k3].map(|stiffness| stiffness.known().map(|known| known.grade));
    Datum::of(actuator.gear.torsion().map(|curve| Sourced {
        value: Angle::from_si(curve.angle(torque).si().abs()),
        source: Source::Equation { number: "73.1" },
        grade: grades.into_iter().flatten().fold(Grade::Computed, Grade::worst),
        errata: &[],
    }))
}

/// Returns the magnitude of the tilt under a moment.
fn tilt(actuator: &Drivetrain, moment: Option<Torque>) -> Datum<Angle> {
    let stiffness = actuator.output_bearing.tilting_stiffness.known();
    Datum::of(moment.zip(stiffness).map(|(moment, stiffness)| Sourced {
        value: Angle::from_si(tilt_angle(moment, stiffness.value).si().abs()),
        source: Source::Equation { number: "76.4" },
        grade: stiffness.grade.worst(Grade::Computed),
        errata: stiffness.errata,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::Accuracy;
    use crate::feedback::{Feedback, FeedbackSide};
    use crate::gear::Gear;
    use crate::output_bearing::OutputBearing;
    use provenance::CellRef;
    use quantities::unit::{ARCMINUTE, ARCSECOND};
    use quantities::{TiltingStiffness, TorsionalStiffness};

    fn known<T>(value: T) -> Datum<T> {
        const CELL: CellRef = CellRef::of_the_manual("54.1", "x", "");
        Datum::Known(Sourced { value, source: Source::Cell(&CELL), grade: Grade::Printed, errata: &[] })
    }

    fn minutes(value: f64) -> Datum<Angle> {
        known(Angle::new_in(value, &ARCMINUTE))
    }

    fn actuator() -> Parameters {
        Parameters {
            feedback: Feedback {
                accuracy: known(Angle::new_in(60.0, &ARCSECOND)),
                resolution: known(Angle::new_in(10.0, &ARCSECOND)),
                ..Feedback::default()
            },
            feedback_out: Feedback {
                side: FeedbackSide::Output,
                accuracy: known(Angle::new_in(20.0, &ARCSECOND)),
                ..Feedback::absent(FeedbackSide::Output)
            },
            ..Drivetrain {
                ratio: known(100.0),
                accuracy: Accuracy {
                    transmission_accuracy: minutes(0.8),
                    repeatability: minutes(0.1),
                    hysteresis_loss: minutes(1.0),
                    lost_motion: minutes(1.0),
                },
                gear: Gear {
                    torque_1: known(Torque::from_si(29.0)),
                    torque_2: known(Torque::from_si(108.0)),
                    stiffness: [6.7e4, 1.1e5, 1.2e5].map(|k| known(TorsionalStiffness::from_si(k))),
                    ..Gear::default()
                },
                output_bearing: OutputBearing {
                    tilting_stiffness: known(TiltingStiffness::from_si(4e5)),
                    ..OutputBearing::default()
                },
                ..Drivetrain::unknown()
            }
            .into()
        }
    }

    fn case(torque: f64, moment: f64, position_loop: PositionLoop) -> BudgetCase {
        let tilting_moment = Some(Torque::from_si(moment));
        BudgetCase { torque: Torque::from_si(torque), tilting_moment, position_loop }
    }

    /// Without load: 0.8 + 0.1 + 1 + 1 + 0.01 + 1/600 arcmin.
    #[test]
    fn the_sum_by_hand() {
        let budget = error_budget(&actuator(), &case(0.0, 0.0, PositionLoop::Motor));
        assert_eq!(budget.contributions.len(), 8);
        assert!(budget.missing.is_empty());
        assert!((budget.worst_case().in_unit(&ARCMINUTE) - (2.91 + 1.0 / 600.0)).abs() < 1e-9);
        let squares: f64 = 0.64 + 0.01 + 1.0 + 1.0 + 1e-4 + 1.0 / 360_000.0;
        assert!((budget.root_sum_square().in_unit(&ARCMINUTE) - squares.sqrt()).abs() < 1e-9);
    }

    /// −29 Nm on 6.7e4 Nm/rad twist by 4.328e-4 rad; 40 Nm on 4e5 Nm/rad tilt by 1e-4 rad; both count as magnitudes.
    #[test]
    fn torsion_and_tilt_come_with_the_load() {
        let idle = error_budget(&actuator(), &case(0.0, 0.0, PositionLoop::Motor)).worst_case().si();
        let loaded = error_budget(&actuator(), &case(-29.0, -40.0, PositionLoop::Motor)).worst_case().si();
        assert!((loaded - idle - 29.0 / 6.7e4 - 1e-4).abs() < 1e-12);
    }

    #[test]
    fn a_loop_at_the_output_sees_the_gear() {
        let budget = error_budget(&actuator(), &case(29.0, 40.0, PositionLoop::Output));
        assert!((budget.worst_case().si() - Angle::new_in(20.0, &ARCSECOND).si() - 1e-4).abs() < 1e-12);
        assert_eq!(budget.missing, [ErrorKind::FeedbackResolution]);
    }

    #[test]
    fn what_is_not_known_is_said() {
        let budget = error_budget(&Parameters::unknown(), &case(1.0, 1.0, PositionLoop::Motor));
        assert_eq!(budget.missing.len(), 8);
        assert!(budget.worst_case().si().abs() < 1e-300);
        let unloaded = BudgetCase { tilting_moment: None, ..case(1.0, 1.0, PositionLoop::Motor) };
        assert_eq!(error_budget(&actuator(), &unloaded).missing, [ErrorKind::Tilt]);
    }

    #[test]
    fn half_a_metre_makes_a_length_of_an_angle() {
        assert!((deviation_at(Angle::from_si(1e-3), Length::from_si(0.5)).si() - 5e-4).abs() < 1e-18);
    }
}
