//! List of checks of a simulated run: the figures of the run against the limits of the actuator.

use crate::check::Verdict;
use crate::comparison::project;
use actuator::{Parameters, speed_max};
use provenance::{Datum, Grade, Source, Sourced};
use quantities::unit::{AMPERE, DEGREE, DEGREE_CELSIUS, NEWTON_METRE, ONE, REVOLUTION_PER_MINUTE, VOLT};
use quantities::{Angle, Measure, Unit, identified};

/// Share by which a figure of a run may exceed its limit: a control reaches a limit and settles around it.
pub const RUN_TOLERANCE: f64 = 1e-3;

identified! {
    /// Identifier of a check of a simulated run, part of the contract with scripts.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum RunCheckId {
        /// Largest motor current against I_max; beyond the demagnetisation limit against that.
        CurrentPeak = "current_peak",
        /// Largest output torque against T_max; after a collision or a stop against T_M if it is known.
        TorquePeak = "torque_peak",
        /// Largest output speed against n_mot,max/i.
        SpeedPeak = "speed_peak",
        /// Largest temperature of the winding against its shutdown threshold.
        WindingPeak = "winding_peak",
        /// Largest I²t integral against one, the response of the drive.
        Overload = "overload",
        /// Highest voltage of the DC link against U_DCmax.
        LinkHigh = "link_high",
        /// Angle of an emergency stop against `requirements.stop_angle_max`.
        StopAngle = "stop_angle",
        /// Number of faults of the drive against none.
        DriveFaults = "drive_faults",
    }
}

/// Conditions on which the limits of a run depend, besides its figures.
#[derive(Clone, Copy, Debug)]
pub struct RunCase<'a> {
    /// Data of the actuator that was simulated.
    pub actuator: &'a Parameters,
    /// `true` if the scenario is a cycle that must be completed, without collision or stop.
    pub is_cycle: bool,
    /// `true` if the drive limits its setpoints.
    pub is_limited: bool,
    /// `true` if a braking resistor can keep the DC link between the supply and U_DCmax; `None` if the supply is above
    /// U_DCmax or U_DCmax is not known.
    pub has_chopper_room: Option<bool>,
    /// Largest permitted angle of a stop.
    pub stop_angle_max: Option<Angle>,
}

/// Result of a check of a run.
#[derive(Clone, Debug)]
pub struct RunCheck {
    /// Identifier of the check.
    pub id: RunCheckId,
    /// Figure of the run in SI.
    pub value: f64,
    /// Limit in SI, with grade and source.
    pub limit: Option<Sourced<f64>>,
    /// Symbol of the limit where several are possible; empty elsewhere.
    pub limit_symbol: &'static str,
    /// Verdict.
    pub verdict: Verdict,
}

impl RunCheckId {
    /// Returns the display unit of value and limit.
    #[must_use]
    pub const fn unit(self) -> &'static Unit {
        match self {
            Self::CurrentPeak => &AMPERE,
            Self::TorquePeak => &NEWTON_METRE,
            Self::SpeedPeak => &REVOLUTION_PER_MINUTE,
            Self::WindingPeak => &DEGREE_CELSIUS,
            Self::Overload | Self::DriveFaults => &ONE,
            Self::LinkHigh => &VOLT,
            Self::StopAngle => &DEGREE,
        }
    }

    /// Returns the limit in SI of a value.
    fn limit(self, value: f64, case: &RunCase<'_>) -> Option<Sourced<f64>> {
        let actuator = case.actuator;
        match self {
            Self::CurrentPeak if is_demagnetised(value, actuator) => known(&actuator.current_demagnetisation),
            Self::CurrentPeak => known(&actuator.current_max),
            Self::TorquePeak if case.is_cycle => known(&actuator.torque_max),
            Self::TorquePeak => known(&actuator.gear.collision_torque_max).or_else(|| known(&actuator.torque_max)),
            Self::SpeedPeak => speed_max(actuator).ok().map(|limit| limit.map(Measure::si)),
            Self::WindingPeak => known(&actuator.heat.winding_shutdown),
            Self::Overload => Some(of_the_twin(1.0)),
            Self::DriveFaults => Some(of_the_twin(0.0)),
            Self::LinkHigh => known(&actuator.dc_link_max),
            Self::StopAngle => case.stop_angle_max.map(|limit| Sourced {
                value: limit.si(),
                grade: Grade::Computed,
                source: project("requirements.stop_angle_max"),
                errata: &[],
            }),
        }
    }

    /// Returns `true` if a value beyond the limit is advice and no failure.
    fn is_advice(self, value: f64, limit: &Sourced<f64>, case: &RunCase<'_>) -> bool {
        match self {
            // A rating of another gear is no reason for rejection.
            _ if matches!(limit.source, Source::Published(_)) => true,
            // The drive keeps its setpoint within I_max and the current itself oscillates around it; the manual states no
            // limit for a short overshoot but the demagnetisation limit.
            Self::CurrentPeak => {
                let has_magnets = case.actuator.current_demagnetisation.known().is_some();
                !is_demagnetised(value, case.actuator) && (case.is_limited || has_magnets)
            }
            // U_DCmax is the largest stationary voltage; it may be exceeded briefly while braking (glossary of the
            // manual).
            Self::LinkHigh => case.has_chopper_room == Some(false),
            _ => false,
        }
    }

    /// Compares a figure of a run with its limit, within [`RUN_TOLERANCE`].
    #[must_use]
    pub fn compare(self, value: f64, case: &RunCase<'_>) -> RunCheck {
        let limit = self.limit(value, case);
        let verdict = match &limit {
            None => Verdict::NotChecked,
            Some(limit) if value <= limit.value * (1.0 + RUN_TOLERANCE) => Verdict::Pass,
            Some(limit) if self.is_advice(value, limit, case) => Verdict::Advice,
            Some(_) => Verdict::Fail,
        };
        let limit_symbol = if limit.is_some() { self.limit_symbol(value, case) } else { "" };
        RunCheck { id: self, value, limit, limit_symbol, verdict }
    }

    /// Returns the symbol of the limit in use, where several are possible.
    fn limit_symbol(self, value: f64, case: &RunCase<'_>) -> &'static str {
        let actuator = case.actuator;
        match self {
            Self::CurrentPeak if is_demagnetised(value, actuator) => "I_E",
            Self::CurrentPeak => "I_max",
            Self::TorquePeak if !case.is_cycle && actuator.gear.collision_torque_max.known().is_some() => "T_M",
            Self::TorquePeak => "T_max",
            Self::WindingPeak => "T_KTY_shutdown",
            Self::SpeedPeak | Self::Overload | Self::LinkHigh | Self::StopAngle | Self::DriveFaults => "",
        }
    }
}

/// Returns `true` if a current is beyond the demagnetisation limit, or if this is the only known one.
fn is_demagnetised(value: f64, actuator: &Parameters) -> bool {
    let magnets = known(&actuator.current_demagnetisation);
    magnets.is_some_and(|limit| value > limit.value * (1.0 + RUN_TOLERANCE)) || actuator.current_max.known().is_none()
}

fn known<Q: Measure>(datum: &Datum<Q>) -> Option<Sourced<f64>> {
    datum.known().map(|known| known.clone().map(Measure::si))
}

fn of_the_twin(value: f64) -> Sourced<f64> {
    Sourced { value, grade: Grade::Computed, source: Source::Model { name: "twin" }, errata: &[] }
}

#[cfg(test)]
mod tests {
    use super::{RUN_TOLERANCE, RunCase, RunCheckId};
    use crate::check::Verdict;
    use actuator::Parameters;
    use provenance::{Datum, Grade, Source, Sourced};
    use quantities::unit::{AMPERE, DEGREE, DEGREE_CELSIUS, NEWTON_METRE, REVOLUTION_PER_MINUTE, VOLT};
    use quantities::{Measure, Unit};
    use std::sync::Arc;

    fn printed<T>(value: T) -> Datum<T> {
        Datum::Known(Sourced { value, source: Source::Equation { number: "1" }, grade: Grade::Printed, errata: &[] })
    }

    fn quantity<Q: Measure>(value: f64, unit: &Unit) -> Datum<Q> {
        printed(Q::from_si(unit.to_si(value)))
    }

    fn actuator() -> Parameters {
        let mut all = Parameters::unknown();
        let drivetrain = Arc::make_mut(&mut all.drivetrain);
        drivetrain.ratio = printed(100.0);
        drivetrain.torque_max = quantity(80.0, &NEWTON_METRE);
        drivetrain.gear.collision_torque_max = quantity(160.0, &NEWTON_METRE);
        drivetrain.current_max = quantity(10.0, &AMPERE);
        drivetrain.speed_motor_max = quantity(4000.0, &REVOLUTION_PER_MINUTE);
        drivetrain.heat.winding_shutdown = quantity(120.0, &DEGREE_CELSIUS);
        drivetrain.dc_link_max = quantity(680.0, &VOLT);
        all
    }

    /// A figure passes up to the tolerance above its limit; beyond, the two that may be exceeded briefly are advice.
    #[test]
    fn a_figure_beyond_its_limit_fails_unless_it_may_be_exceeded_briefly() {
        let actuator = actuator();
        let case = |is_cycle, is_limited, has_chopper_room| RunCase {
            actuator: &actuator,
            is_cycle,
            is_limited,
            has_chopper_room,
            stop_angle_max: Some(quantities::Angle::from_si(DEGREE.to_si(5.0))),
        };
        let limits = [
            (RunCheckId::CurrentPeak, AMPERE.to_si(10.0)),
            (RunCheckId::TorquePeak, NEWTON_METRE.to_si(80.0)),
            (RunCheckId::SpeedPeak, REVOLUTION_PER_MINUTE.to_si(40.0)),
            (RunCheckId::WindingPeak, DEGREE_CELSIUS.to_si(120.0)),
            (RunCheckId::Overload, 1.0),
            (RunCheckId::LinkHigh, VOLT.to_si(680.0)),
            (RunCheckId::StopAngle, DEGREE.to_si(5.0)),
            (RunCheckId::DriveFaults, 0.0),
        ];
        assert_eq!(limits.map(|(id, _)| id), RunCheckId::ALL);
        for (id, limit) in limits {
            let judged = |value: f64, case: &RunCase<'_>| id.compare(value, case).verdict;
            let above = limit * (1.0 + 2.0 * RUN_TOLERANCE) + f64::from(u8::from(limit == 0.0));
            let strict = case(true, false, Some(true));
            assert_eq!(judged(limit * (1.0 + 0.5 * RUN_TOLERANCE), &strict), Verdict::Pass, "{id:?}");
            assert_eq!(judged(above, &strict), Verdict::Fail, "{id:?}");
            let may_be_exceeded = matches!(id, RunCheckId::CurrentPeak | RunCheckId::LinkHigh);
            let expected = if may_be_exceeded { Verdict::Advice } else { Verdict::Fail };
            assert_eq!(judged(above, &case(true, true, Some(false))), expected, "{id:?}");
        }
        // After a collision the gear may carry its momentary peak torque.
        assert_eq!(RunCheckId::TorquePeak.compare(120.0, &case(false, true, None)).verdict, Verdict::Pass);
        assert_eq!(RunCheckId::TorquePeak.compare(120.0, &case(true, true, None)).verdict, Verdict::Fail);
    }

    #[test]
    fn a_figure_without_a_limit_is_not_checked() {
        let unknown = Parameters::unknown();
        let case = RunCase {
            actuator: &unknown,
            is_cycle: true,
            is_limited: true,
            has_chopper_room: None,
            stop_angle_max: None,
        };
        let of_the_drive = [RunCheckId::Overload, RunCheckId::DriveFaults];
        for id in RunCheckId::ALL.into_iter().filter(|id| !of_the_drive.contains(id)) {
            assert_eq!(id.compare(f64::MAX, &case).verdict, Verdict::NotChecked, "{id:?}");
        }
    }
}
