//! List of checks: properties that are equal for every result of a check stand in its entry only.

use crate::axis::Axis;
use crate::bearing_checks::{self, Borne};
use crate::brake_checks;
use crate::check::{Check, Direction, Margin, Part, Verdict};
use crate::checks;
use crate::comparison::not_checked;
use crate::currents::{self, Currents};
use crate::demand::{Demand, ManualDemand};
use crate::drive_checks;
use crate::electric_checks;
use crate::electrics::Electrics;
use crate::energy;
use crate::environment_checks as environment;
use crate::feedback_checks;
use crate::gear_checks;
use crate::heat_checks;
use crate::joint_checks;
use crate::resonance;
use crate::rope_checks;
use actuator::{Drivetrain, Parameters};
use derivation::Workings;
use provenance::Missing;

/// One actuator on one axis, with the data that several checks use.
pub(crate) struct Case<'c> {
    pub(crate) axis: &'c Axis,
    pub(crate) actuator: &'c Parameters,
    /// Demand by exact integrals, if the own inertia is known.
    pub(crate) demand: Option<&'c Demand>,
    /// Demand by the manual's equations, if they describe the axis.
    pub(crate) manual: Option<&'c ManualDemand>,
    pub(crate) electrics: &'c Electrics,
    pub(crate) currents: Result<&'c Currents<'c>, &'c Missing>,
    /// Output bearing with its loads, if any are known.
    pub(crate) bearing: Option<&'c Borne<'c>>,
    /// A check that passes is not required: see [`Depth::Failing`](crate::Depth::Failing).
    pub(crate) only_failing: bool,
}

impl Case<'_> {
    /// Returns the value that the largest one of the cycle must exceed for its check to be required.
    pub(crate) const fn least(&self, limit: f64) -> f64 {
        if self.only_failing { limit } else { f64::NEG_INFINITY }
    }
}

/// Function that answers a check, with the actuators that share its answer.
#[derive(Clone, Copy)]
pub(crate) enum Answer {
    /// No part: a separate answer for each actuator.
    Actuator(fn(&Case<'_>, &mut Workings) -> Outcome),
    /// A separate answer for each actuator; `None` if the check does not apply to it, e.g. without a brake, or is not
    /// required.
    Concerned(fn(&Case<'_>, &mut Workings) -> Option<Outcome>),
    /// One answer for all actuators with the same drivetrain.
    Drivetrain(fn(&Axis, &Drivetrain, &mut Workings) -> Outcome),
    /// One answer for all actuators with the same output bearing; none if no loads are known.
    Bearing(fn(&Borne<'_>, &mut Workings) -> Outcome),
}

/// Part shared by the actuators with one answer of a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SharedBy {
    /// A separate answer for each actuator.
    Nothing,
    /// Drivetrain.
    Drivetrain,
    /// Output bearing.
    Bearing,
}

/// Result of a check, or the datum that it lacks.
pub(crate) type Outcome = Result<Check, Missing>;

/// Stage of a judgement. The list of checks is sorted by stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Stage {
    /// Checks that need no further evaluation of the cycle.
    First,
    /// Checks of the heat over the whole cycle.
    Heat,
    /// Checks of the energy over the whole cycle.
    Pass,
    /// Other checks.
    Further,
}

/// Change that can make a failed check pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mended {
    /// A smaller load or a slower motion.
    LoadOrPace,
    /// A slower motion only.
    Pace,
    /// Neither of them.
    Neither,
}

/// Role of the project in a check.
#[derive(Clone, Copy)]
enum Requirement {
    /// The check is always made and its limit belongs to the actuator.
    None,
    /// The check is made only of an axis to which it applies.
    Case(fn(&Axis) -> bool),
    /// The check is made only if the key is stated.
    Switch(&'static str, fn(&Axis) -> bool),
    /// The key states the limit; without it the value is shown.
    Limit(&'static str, fn(&Axis) -> bool),
}

/// Shaft to which an angle or a speed refers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shaft {
    /// Output of the actuator.
    Output,
    /// Shaft of the mechanism: behind a stage it turns 1/i_s times as far, else it is that of the output.
    Mechanism,
}

/// Properties of a check that are independent of its result.
#[derive(Clone, Copy)]
struct ListedCheck {
    id: &'static str,
    part: Part,
    stage: Stage,
    answer: Answer,
    direction: Direction,
    margin: Margin,
    mended: Mended,
    requirement: Requirement,
    shaft: Option<Shaft>,
    of_the_feedback: bool,
}

impl ListedCheck {
    /// Creates a check of a value at most its limit, with a margin, that a smaller load or a slower motion can make
    /// pass.
    const fn new(id: &'static str, part: Part, stage: Stage, answer: Answer) -> Self {
        Self {
            id,
            part,
            stage,
            answer,
            direction: Direction::AtMost,
            margin: Margin::Share,
            mended: Mended::LoadOrPace,
            requirement: Requirement::None,
            shaft: None,
            of_the_feedback: false,
        }
    }

    const fn at_least(self) -> Self {
        Self { direction: Direction::AtLeast, ..self }
    }

    const fn margin(self, margin: Margin) -> Self {
        Self { margin, ..self }
    }

    const fn mended_by(self, mended: Mended) -> Self {
        Self { mended, ..self }
    }

    const fn only_of(self, applies: fn(&Axis) -> bool) -> Self {
        Self { requirement: Requirement::Case(applies), ..self }
    }

    const fn only_with(self, key: &'static str, stated: fn(&Axis) -> bool) -> Self {
        Self { requirement: Requirement::Switch(key, stated), ..self }
    }

    /// `stated`: returns `true` if the project limits the check, by the key or another one.
    const fn limited_by(self, key: &'static str, stated: fn(&Axis) -> bool) -> Self {
        Self { requirement: Requirement::Limit(key, stated), ..self }
    }

    /// Marks a check of the feedback; other checks have equal answers for actuators that differ in it alone.
    const fn of_the_feedback(self) -> Self {
        Self { of_the_feedback: true, ..self }
    }

    /// Marks a check whose value and limit are an angle or a speed of the output shaft, to which a linear axis behind
    /// it is proportional.
    const fn of_the_output(self) -> Self {
        Self { shaft: Some(Shaft::Output), ..self }
    }

    /// Marks a check whose value and limit are an angle of the mechanism, behind a stage if there is one.
    const fn of_the_mechanism(self) -> Self {
        Self { shaft: Some(Shaft::Mechanism), ..self }
    }
}

macro_rules! checks {
    ($($(#[$about:meta])* $name:ident: $entry:expr;)*) => {
        /// Identifier of a check, part of the contract with scripts.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum CheckId {
            $($(#[$about])* $name,)*
        }

        impl CheckId {
            /// Checks in the order of the list, in which they are judged.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            const fn entry(self) -> &'static ListedCheck {
                match self {
                    $(Self::$name => const { &$entry },)*
                }
            }
        }
    };
}

use Answer::{Actuator, Bearing, Concerned, Drivetrain as OfDrivetrain};
use Part::{Brake, Drive, Energy, Environment, Feedback, Gear, OutputBearing, Screws, Thermal};
use Stage::{First, Further, Heat, Pass};

checks! {
    /// Peak torque against T_max.
    PeakTorque: ListedCheck::new("peak_torque", Drive, First, Actuator(checks::peak_torque));
    /// Peak speed against n_mot,max/i.
    PeakSpeed: ListedCheck::new("peak_speed", Drive, First, OfDrivetrain(checks::peak_speed))
        .mended_by(Mended::Pace).of_the_output();
    /// Mean speed against n_N/i.
    MeanSpeed: ListedCheck::new("mean_speed", Drive, First, OfDrivetrain(checks::mean_speed))
        .mended_by(Mended::Pace).of_the_output();
    /// Effective torque against the continuous torque at the mean speed.
    ContinuousTorque: ListedCheck::new("continuous_torque", Thermal, First, Actuator(heat_checks::continuous_torque));
    /// Peak motor current against I_max.
    PeakCurrent: ListedCheck::new("peak_current", Drive, First, Actuator(currents::peak_current));
    /// Peak motor current against I_E.
    Demagnetisation: ListedCheck::new("demagnetisation", Drive, First, Actuator(currents::demagnetisation));
    /// Terminal voltage of the motor against the voltage available from the DC link.
    Voltage: ListedCheck::new("voltage", Energy, First, Actuator(currents::voltage))
        .only_with("requirements.supply", |axis| axis.supply.is_some());
    /// Load inertia against three times the own inertia.
    InertiaRatio: ListedCheck::new("inertia_ratio", Drive, First, Actuator(checks::inertia_ratio))
        .margin(Margin::Recommendation);
    /// Force that the motion takes off the ropes that hold the load, against the weight on them: ropes cannot push.
    RopeTension: ListedCheck::new("rope_tension", Drive, First, OfDrivetrain(rope_checks::tension))
        .margin(Margin::Class).only_of(|axis| axis.mechanism.has_rope());
    /// Cubic mean torque against T_A.
    GearMeanTorque: ListedCheck::new("gear_mean_torque", Gear, First, OfDrivetrain(gear_checks::mean_torque));
    /// Life of the wave-generator bearing against the required life.
    GearLife: ListedCheck::new("gear_life", Gear, First, OfDrivetrain(gear_checks::life))
        .at_least().limited_by("requirements.gear_life_min", |axis| axis.asked.gear_life_min.is_some());
    /// Torsion of the gear under the largest torque against the permissible torsion.
    Torsion: ListedCheck::new("torsion", Gear, First, OfDrivetrain(gear_checks::torsion))
        .of_the_mechanism().limited_by("requirements.torsion_max", |axis| axis.asked.torsion_max.is_some());
    /// First natural frequency against the required minimum.
    NaturalFrequency: ListedCheck::new("natural_frequency", Gear, First, Actuator(resonance::natural_frequency))
        .at_least()
        .limited_by("requirements.natural_frequency_min", |axis| axis.asked.natural_frequency_min.is_some());
    /// Axial force on the flange against the permissible one.
    BearingAxial: ListedCheck::new("bearing_axial", OutputBearing, First, Bearing(bearing_checks::axial));
    /// Radial force on the flange against the permissible one.
    BearingRadial: ListedCheck::new("bearing_radial", OutputBearing, First, Bearing(bearing_checks::radial));
    /// Tilting moment against the permissible one.
    BearingTiltingMoment:
        ListedCheck::new("bearing_tilting_moment", OutputBearing, First, Bearing(bearing_checks::tilting_moment));
    /// Static load of the resting gear against the permissible static tilting moment.
    BearingStaticMoment:
        ListedCheck::new("bearing_static_moment", OutputBearing, First, Bearing(bearing_checks::static_moment))
        .only_of(Axis::gear_rests);
    /// Life of the output bearing against the required life.
    BearingLife: ListedCheck::new("bearing_life", OutputBearing, First, Bearing(bearing_checks::life))
        .at_least().limited_by("requirements.bearing_life_min", |axis| limits_bearing(axis, |duty| duty.life_min.is_some()));
    /// Static safety of the output bearing against that of the operating condition.
    BearingStatic: ListedCheck::new("bearing_static", OutputBearing, First, Bearing(bearing_checks::static_safety))
        .at_least()
        .limited_by("bearing.operating_condition", |axis| limits_bearing(axis, |duty| duty.operating_condition.is_some()));
    /// Tilt of the flange against the permissible tilt.
    TiltAngle: ListedCheck::new("tilt_angle", OutputBearing, First, Bearing(bearing_checks::tilt_angle))
        .limited_by("requirements.tilt_angle_max", |axis| limits_bearing(axis, |duty| duty.tilt_max.is_some()));
    /// Ambient temperature against the operating range.
    Ambient: ListedCheck::new("ambient", Thermal, First, OfDrivetrain(checks::ambient))
        .margin(Margin::Range).mended_by(Mended::Neither)
        .only_with("requirements.ambient", |axis| axis.ambient.is_some());
    /// Altitude of the place against that of the manual, or the effective torque against the derated continuous torque.
    Altitude: ListedCheck::new("altitude", Environment, First, Actuator(environment::altitude))
        .only_with("requirements.altitude", |axis| axis.asked.altitude.is_some());
    /// Required degree of protection against that of the manual.
    Protection: ListedCheck::new("protection", Environment, First, OfDrivetrain(environment::protection))
        .margin(Margin::Class).mended_by(Mended::Neither)
        .only_with("requirements.protection", |axis| axis.asked.protection.is_some());
    /// Highest relative humidity of the place against the permissible range.
    Humidity: ListedCheck::new("humidity", Environment, First, OfDrivetrain(environment::humidity))
        .margin(Margin::Range).mended_by(Mended::Neither)
        .only_with("requirements.humidity_max", |axis| axis.asked.humidity_max.is_some());
    /// Lowest relative humidity of the place against the permissible range.
    HumidityMin: ListedCheck::new("humidity_min", Environment, First, OfDrivetrain(environment::humidity_min))
        .at_least().margin(Margin::Range).mended_by(Mended::Neither)
        .only_with("requirements.humidity_min", |axis| axis.asked.humidity_min.is_some());
    /// Vibration at the place against the resistance of the actuator.
    Vibration: ListedCheck::new("vibration", Environment, First, OfDrivetrain(environment::vibration))
        .margin(Margin::Class).mended_by(Mended::Neither)
        .only_with("requirements.vibration", |axis| axis.asked.vibration.is_some());
    /// Shock at the place against the resistance of the actuator.
    Shock: ListedCheck::new("shock", Environment, First, OfDrivetrain(environment::shock))
        .margin(Margin::Class).mended_by(Mended::Neither)
        .only_with("requirements.shock", |axis| axis.asked.shock.is_some());
    /// Mounting position against the permissible ones.
    Mounting: ListedCheck::new("mounting", Environment, First, OfDrivetrain(environment::mounting))
        .margin(Margin::Class).mended_by(Mended::Neither)
        .only_with("requirements.mounting", |axis| axis.asked.mounting.is_some());
    /// DC link voltage against U_DCmax.
    DcLink: ListedCheck::new("dc_link", Energy, First, OfDrivetrain(electric_checks::dc_link))
        .margin(Margin::Class).mended_by(Mended::Neither)
        .only_with("requirements.supply", |axis| axis.supply.is_some());
    /// Effective motor current against the continuous current of the drive of the machine.
    DriveCurrent: ListedCheck::new("drive_current", Drive, Heat, Actuator(drive_checks::continuous))
        .only_with("drive.current_continuous", |axis| axis.asked.drive_current_continuous.is_some());
    /// Peak motor current against the peak current of the drive of the machine.
    DriveCurrentPeak: ListedCheck::new("drive_current_peak", Drive, Heat, Actuator(drive_checks::peak))
        .only_with("drive.current_peak", |axis| axis.asked.drive_current_peak.is_some());
    /// Longest time above the continuous current of the drive against the time of its peak current.
    DrivePeakTime: ListedCheck::new("drive_peak_time", Drive, Heat, Actuator(drive_checks::peak_time))
        .only_with("drive.peak_time", |axis| axis.asked.drive_peak_time.is_some());
    /// Every instant of the cycle against the short-time torque at its speed.
    TorqueSpeedTrace: ListedCheck::new("torque_speed_trace", Drive, Heat, Concerned(electric_checks::torque_speed_trace));
    /// Temperature of the winding in the steady cycle against its warning threshold.
    Thermal: ListedCheck::new("thermal", Part::Thermal, Heat, Concerned(heat_checks::thermal));
    /// Filtered square of the current against that of I_0.
    OverloadI2t: ListedCheck::new("overload_i2t", Part::Thermal, Heat, Concerned(heat_checks::overload));
    /// Mean regenerated power against the power that the supply or a resistor can take.
    Regeneration: ListedCheck::new("regeneration", Energy, Pass, Actuator(energy::regeneration))
        .limited_by("requirements.regeneration_power_max", |axis| axis.asked.regeneration_power_max.is_some());
    /// Mean input speed of the gear against its limit.
    GearMeanInputSpeed: ListedCheck::new("gear_mean_input_speed", Gear, Further, Actuator(gear_checks::mean_input_speed))
        .mended_by(Mended::Pace);
    /// Torque of a collision against T_M.
    CollisionTorque: ListedCheck::new("collision_torque", Gear, Further, Actuator(gear_checks::collision))
        .only_with("requirements.collision_torque", |axis| axis.asked.collision_torque.is_some());
    /// Number of collisions against that which the gear bears.
    CollisionNumber: ListedCheck::new("collision_number", Gear, Further, Actuator(gear_checks::collision_number))
        .mended_by(Mended::Pace)
        .only_with("requirements.collisions", |axis| axis.asked.collisions.is_some());
    /// Distance of the speeds held in the cycle from those at which the wave generator excites the load.
    ResonanceSpeed: ListedCheck::new("resonance_speed", Gear, Further, Actuator(resonance::resonance))
        .at_least().margin(Margin::Recommendation);
    /// Sum of all angular errors against the permissible one.
    ErrorBudget: ListedCheck::new("error_budget", Feedback, Further, Actuator(gear_checks::error_budget))
        .of_the_mechanism().of_the_feedback()
        .limited_by("requirements.angle_error_max", |axis| axis.asked.angle_error_max.is_some());
    /// Sum of all angular errors at the lever arm or along the line of the mechanism against the permissible deviation.
    Deviation: ListedCheck::new("deviation", Feedback, Further, Actuator(gear_checks::deviation))
        .of_the_feedback().only_with("requirements.deviation_max", |axis| axis.asked.deviation_max.is_some());
    /// Torque that holds the load against the holding torque of the brake.
    BrakeHolding: ListedCheck::new("brake_holding", Brake, Further, Concerned(brake_checks::holding));
    /// Applications of the brake at standstill over the service life against their permissible number.
    BrakeApplications: ListedCheck::new("brake_applications", Brake, Further, Concerned(brake_checks::applications))
        .only_with("requirements.service_life", |axis| axis.asked.service_life.is_some());
    /// Angle of a stop by the brake alone. A brake that does not stop the load fails without a limit.
    BrakeEmergency: ListedCheck::new("brake_emergency", Brake, Further, Concerned(brake_checks::emergency))
        .of_the_output().limited_by("requirements.stop_angle_max", |_| true);
    /// Number of stops by the brake alone against the permissible one.
    BrakeStops: ListedCheck::new("brake_stops", Brake, Further, Concerned(brake_checks::stops))
        .mended_by(Mended::Neither)
        .only_with("requirements.emergency_stops", |axis| axis.asked.emergency_stops.is_some());
    /// Travel against the absolute range of the feedback.
    FeedbackRange: ListedCheck::new("feedback_range", Feedback, Further, Concerned(feedback_checks::range))
        .of_the_output().of_the_feedback().limited_by("requirements.absolute", |axis| axis.asked.absolute == Some(true));
    /// Step of the position at the output against the largest permissible one.
    FeedbackResolution: ListedCheck::new("feedback_resolution", Feedback, Further, Actuator(feedback_checks::resolution))
        .mended_by(Mended::Neither).of_the_output().of_the_feedback()
        .limited_by("requirements.resolution_max", |axis| axis.asked.resolution_max.is_some());
    /// Life of the encoder's battery against the required life.
    Battery: ListedCheck::new("battery", Feedback, Further, Concerned(feedback_checks::battery))
        .at_least().mended_by(Mended::Neither).of_the_feedback()
        .limited_by("requirements.battery_life_min", |axis| axis.asked.battery_life_min.is_some());
    /// Peak torque against the torque that the screws of the load transmit.
    ScrewJointLoad: ListedCheck::new("screw_joint_load", Screws, Further, Actuator(joint_checks::load));
    /// Peak torque against the torque that the screws of the housing transmit.
    ScrewJointHousing: ListedCheck::new("screw_joint_housing", Screws, Further, Actuator(joint_checks::housing));
    /// Field of application against those that need approval.
    Application: ListedCheck::new("application", Drive, Further, Actuator(joint_checks::application))
        .only_with("requirements.special_application", |axis| axis.asked.special_application.is_some());
}

/// Returns `true` if the project states a limit of the output bearing.
fn limits_bearing(axis: &Axis, stated: fn(&crate::axis::BearingDuty) -> bool) -> bool {
    axis.bearing.as_ref().is_some_and(stated)
}

impl CheckId {
    /// Returns the identifier used in data exchange.
    #[must_use]
    pub const fn id(self) -> &'static str {
        self.entry().id
    }

    /// Returns the part of the actuator that the check is about.
    #[must_use]
    pub const fn part(self) -> Part {
        self.entry().part
    }

    /// Returns the required relation of its value to its limit; a range has two limits, see [`Check::direction`].
    #[must_use]
    pub const fn direction(self) -> Direction {
        self.entry().direction
    }

    /// Returns the meaning of its utilisation.
    #[must_use]
    pub const fn margin(self) -> Margin {
        self.entry().margin
    }

    /// Returns `true` if its utilisation is a margin used by the ranking.
    #[must_use]
    pub const fn has_margin(self) -> bool {
        match self.margin() {
            Margin::Share | Margin::Range => true,
            Margin::Recommendation | Margin::Class => false,
        }
    }

    /// Returns `true` if a face shows its utilisation beside a verdict: always as a margin; that of a recommendation or a
    /// class only as the reason of a failure or an advice, without the colours of a margin.
    #[must_use]
    pub const fn shows_utilisation(self, verdict: Verdict) -> bool {
        self.has_margin() || matches!(verdict, Verdict::Fail | Verdict::Advice)
    }

    /// Returns `true` if it can at most advise, because its limit is a recommendation.
    #[must_use]
    pub const fn is_recommendation(self) -> bool {
        matches!(self.margin(), Margin::Recommendation)
    }

    /// Returns `true` if a check with this verdict could have rejected the actuator: it was made, and is no recommendation.
    #[must_use]
    pub const fn can_reject(self, verdict: Verdict) -> bool {
        !matches!(verdict, Verdict::NotChecked) && !self.is_recommendation()
    }

    /// Returns the shaft to whose angle or speed value and limit refer, to which a linear axis behind it is
    /// proportional; `None` for other quantities.
    #[must_use]
    pub const fn shaft(self) -> Option<Shaft> {
        self.entry().shaft
    }

    /// Returns `true` if it is a check of the feedback.
    pub(crate) const fn is_of_the_feedback(self) -> bool {
        self.entry().of_the_feedback
    }

    /// Returns `true` if its answer depends neither on the load nor on the pace of the motion.
    #[must_use]
    pub const fn is_of_the_place(self) -> bool {
        matches!(self.entry().mended, Mended::Neither)
    }

    /// Returns `true` if its answer depends on the pace of the motion alone.
    pub(crate) const fn is_of_the_pace(self) -> bool {
        matches!(self.entry().mended, Mended::Pace)
    }

    pub(crate) const fn stage(self) -> Stage {
        self.entry().stage
    }

    pub(crate) const fn answer(self) -> Answer {
        self.entry().answer
    }

    pub(crate) const fn shared_by(self) -> SharedBy {
        match self.answer() {
            Answer::Actuator(_) | Answer::Concerned(_) => SharedBy::Nothing,
            Answer::Drivetrain(_) => SharedBy::Drivetrain,
            Answer::Bearing(_) => SharedBy::Bearing,
        }
    }

    /// Returns its result in a case: not checked if a datum is missing, `None` if it does not apply to the actuator. If
    /// the project states no limit, only the limit is missing, whatever data are known.
    pub(crate) fn of(self, case: &Case<'_>, work: &mut Workings) -> Option<Check> {
        let found = match self.answer() {
            Answer::Actuator(answer) => answer(case, work),
            Answer::Concerned(answer) => answer(case, work)?,
            Answer::Drivetrain(answer) => answer(case.axis, case.actuator, work),
            Answer::Bearing(answer) => answer(case.bearing?, work),
        };
        let mut check = found.unwrap_or_else(|missing| not_checked(self, missing));
        if check.is_open()
            && let Requirement::Limit(key, stated) = self.entry().requirement
            && !stated(case.axis)
        {
            check.missing = Some(key);
        }
        Some(check)
    }

    /// Returns the key of the project that states its limit; `None` for a limit of the actuator.
    #[must_use]
    pub(crate) const fn limit_key(self) -> Option<&'static str> {
        match self.entry().requirement {
            Requirement::None | Requirement::Case(_) | Requirement::Switch(..) => None,
            Requirement::Limit(key, _) => Some(key),
        }
    }

    /// Returns the key of the project that states its limit or enables it.
    pub(crate) const fn key(self) -> Option<&'static str> {
        match self.entry().requirement {
            Requirement::None | Requirement::Case(_) => None,
            Requirement::Switch(key, _) | Requirement::Limit(key, _) => Some(key),
        }
    }

    /// Returns `true` for a key of the project that states the limit of a check, not a datum that it needs.
    #[must_use]
    pub fn is_limit(key: &str) -> bool {
        Self::ALL.iter().any(|id| id.limit_key() == Some(key))
    }

    /// Returns `true` if the check is made for an axis.
    pub(crate) fn is_made(self, axis: &Axis) -> bool {
        match self.entry().requirement {
            Requirement::None | Requirement::Limit(..) => true,
            Requirement::Case(stated) | Requirement::Switch(_, stated) => stated(axis),
        }
    }

    /// Returns `true` if it can fail or has a margin: neither a recommendation nor a value without a limit of the
    /// project.
    pub(crate) fn can_fail(self, axis: &Axis) -> bool {
        match self.entry().requirement {
            Requirement::None | Requirement::Case(_) | Requirement::Switch(..) => !self.is_recommendation(),
            Requirement::Limit(_, stated) => stated(axis),
        }
    }
}
