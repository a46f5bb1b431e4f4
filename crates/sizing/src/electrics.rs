//! Laws of current, voltage and heat of a drivetrain, for every feedback and brake.

use crate::axis::Axis;
use crate::comparison::Edges;
use crate::notes::Notes;
use actuator::{ContinuousLimit, Drivetrain, FrictionAt, HeatModel, MotorCurrent, MotorVoltage, NoLoadFriction};
use derivation::Workings;
use provenance::{Grade, Missing};
use quantities::Measure;
use quantities::unit::NEWTON_METRE;

/// Laws of a drivetrain for one axis, each with its missing datum otherwise.
pub(crate) struct Electrics {
    pub(crate) current: Result<CurrentLaw, Missing>,
    pub(crate) heat: Result<HeatModel, Missing>,
    pub(crate) voltage: Result<MotorVoltage, Missing>,
    /// Continuous torque at the mean speed of the cycle.
    pub(crate) continuous: Result<ContinuousLimit, Missing>,
    /// Remark on its band, if it has one.
    pub(crate) estimated: Notes,
}

/// Returns the edges of a continuous torque.
pub(crate) fn edges(limit: &ContinuousLimit) -> Edges {
    Edges { limit: limit.limit.value.si(), upper: limit.upper.si(), unit: &NEWTON_METRE }
}

/// Motor current of a torque, with the friction of a gear at the ambient temperature.
#[derive(Clone)]
pub(crate) struct CurrentLaw {
    pub(crate) motor: MotorCurrent,
    /// k_Tout \[Nm/A\]
    pub(crate) torque_constant: f64,
    /// Friction at the ambient temperature.
    pub(crate) cold: FrictionAt,
    /// Friction of the warmest gear.
    pub(crate) warmest: FrictionAt,
    /// Factors between which friction may differ from `cold` if that is extrapolated.
    pub(crate) cold_band: Option<(f64, f64)>,
    pub(crate) grade: Grade,
    pub(crate) errata: &'static [&'static str],
}

impl Electrics {
    pub(crate) fn of(axis: &Axis, drivetrain: &Drivetrain) -> Self {
        let laws = (CurrentLaw::of(axis, drivetrain), HeatModel::of(drivetrain), MotorVoltage::of(drivetrain));
        Self::with(axis, drivetrain, laws)
    }

    /// Creates the electrics with the known laws of the drivetrain.
    pub(crate) fn with(
        axis: &Axis,
        drivetrain: &Drivetrain,
        (current, heat, voltage): (
            Result<CurrentLaw, Missing>,
            Result<HeatModel, Missing>,
            Result<MotorVoltage, Missing>,
        ),
    ) -> Self {
        let (model, mut off) = (heat.as_ref().ok(), Workings::off());
        let speed = axis.moments.speed_mean();
        let continuous = actuator::continuous_torque_with(drivetrain, model, speed, &mut off);
        let remark = continuous.as_ref().ok().and_then(|limit| edges(limit).remark());
        Self { current, voltage, estimated: remark.map_or(Notes::NONE, |remark| remark.into()), continuous, heat }
    }
}

impl Electrics {
    /// Electrics without laws, for checks that use none of them.
    pub(crate) const UNKNOWN: Self = Self {
        current: Err(UNKNOWN),
        heat: Err(UNKNOWN),
        voltage: Err(UNKNOWN),
        continuous: Err(UNKNOWN),
        estimated: Notes::NONE,
    };
}

const UNKNOWN: Missing = Missing { symbol: "" };

impl CurrentLaw {
    pub(crate) fn of(axis: &Axis, drivetrain: &Drivetrain) -> Result<Self, Missing> {
        let torque_constant = drivetrain.torque_constant_out.require("k_Tout")?;
        let motor = MotorCurrent::of(drivetrain)?;
        let law = NoLoadFriction::of(drivetrain)?;
        // The stated temperature is that of the hottest day; a gear does not start warmer than the cold start of the
        // manual.
        let start = law.cold_start();
        let cold = axis.ambient.filter(|air| air.si() < start.si()).unwrap_or(start);
        let cold_band = law.cold_band(cold)?;
        // The grade shows a growth that is taken from another manufacturer's actuators.
        let growth = drivetrain.friction_cold_growth.known().filter(|growth| growth.grade == Grade::Assumed);
        let grade_of_the_cold = growth.filter(|_| cold_band.is_some()).map_or(Grade::Computed, |growth| growth.grade);
        Ok(Self {
            motor,
            torque_constant: torque_constant.value.si(),
            cold: law.at(cold),
            warmest: law.at(law.warmest()),
            cold_band,
            grade: grade_of_the_cold.worst(torque_constant.grade),
            errata: torque_constant.errata,
        })
    }
}
