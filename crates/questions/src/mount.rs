//! Mounting of an actuator: notation of its bores, and the loads of a project.

use crate::sizing_use::{Refusal, check};
use axis::AxisProject;
use installation::fit::{Bore, read_bore as read};
use installation::joint::{AxisLoads, FlangeLoads};
use order_code::OrderCode;
use provenance::{Grade, Source, Sourced};
use quantities::{Language, Measure, Torque};
use sizing::{Check, CheckId, Scope};
use words::mounting::bore_fault;

/// Reads the bore over a pilot from the command line.
///
/// # Errors
/// The fault of the text, and a hint.
pub(crate) fn read_bore(text: &str, language: Language) -> Result<Bore, (String, Option<String>)> {
    read(text).map_err(|fault| bore_fault(&fault, language))
}

/// Returns the loads of a project on the joints of an actuator, as used by its checks.
///
/// # Errors
/// The reason why the actuator cannot be judged.
pub fn joint_loads(project: &AxisProject, code: &OrderCode) -> Result<AxisLoads, Refusal> {
    let candidate = check(project, code)?;
    let collision = project.axis.asked.collision_torque;
    // The collision is a row of its own: the loads of the cycle are judged without it.
    let without = collision.map(|_| {
        let mut axis = project.axis.clone();
        axis.asked.collision_torque = None;
        sizing::judge(&axis, candidate.parameters, Scope::All)
    });
    let cycle = without.as_ref().unwrap_or(&candidate.judgement);
    let found = |id: CheckId| candidate.judgement.checks.iter().find(|check| check.id == id);
    let flange = || {
        // The checks consider the turning gear; a joint bears the loads at rest too.
        let (radial, axial, moment) = sizing::largest_loads(&project.axis, &candidate.parameters.output_bearing)?;
        Some(FlangeLoads {
            tilting_moment: Sourced { value: moment, ..asked(found(CheckId::BearingTiltingMoment)?)? },
            axial: Sourced { value: axial, ..asked(found(CheckId::BearingAxial)?)? },
            radial: Sourced { value: radial, ..asked(found(CheckId::BearingRadial)?)? },
        })
    };
    let torque = |id: CheckId| cycle.checks.iter().find(|check| check.id == id).and_then(asked);
    Ok(AxisLoads {
        torque_load: torque(CheckId::ScrewJointLoad),
        torque_housing: torque(CheckId::ScrewJointHousing),
        collision: collision.map(|torque: Torque| Sourced {
            value: torque,
            source: Source::Project { key: "requirements.collision_torque".into() },
            grade: Grade::Printed,
            errata: &[],
        }),
        flange: flange(),
    })
}

/// Returns the value that a check compares with its limit, with its source.
fn asked<Q: Measure>(check: &Check) -> Option<Sourced<Q>> {
    let value = check.value.filter(|figure| figure.unit.dimension == Q::DIMENSION)?;
    Some(Sourced { value: Q::from_si(value.si), source: check.value_source.clone()?, grade: check.grade?, errata: &[] })
}
