//! Bolted joints of load and housing: utilisation by torque, tilting moment and force.

use crate::fit::Side;
use actuator::{JointLoad, LoadedJoint, Parameters, ScrewJoint, clamp_force, joint_utilisation, loaded_joint};
use order_code::OrderCode;
use provenance::{Datum, Grade, Source, Sourced};
use quantities::{Force, Length, Measure, Ratio, Torque, identified};

identified! {
    /// Load case of a joint.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum LoadCase {
        /// Acceleration and braking.
        Peak = "peak",
        /// A collision of the load.
        Collision = "collision",
        /// The brake stops or holds the load.
        Brake = "brake",
        /// A tilting moment at rest, without torque.
        StaticMoment = "static_moment",
    }
}

/// Loads of a project, which replace the limits of the actuator. The limit applies to absent ones.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AxisLoads {
    /// Largest torque through the joint of the load.
    pub torque_load: Option<Sourced<Torque>>,
    /// Largest torque through the joint of the housing.
    pub torque_housing: Option<Sourced<Torque>>,
    /// Torque of a collision.
    pub collision: Option<Sourced<Torque>>,
    /// Loads on the flange.
    pub flange: Option<FlangeLoads>,
}

/// Largest loads of a project on the output flange.
#[derive(Clone, Debug, PartialEq)]
pub struct FlangeLoads {
    /// Tilting moment about the centre of the output bearing.
    pub tilting_moment: Sourced<Torque>,
    /// Axial force.
    pub axial: Sourced<Force>,
    /// Radial force.
    pub radial: Sourced<Force>,
}

/// Result of a joint in one load case.
#[derive(Clone, Debug, PartialEq)]
pub struct CaseAnswer {
    /// Load case of the result.
    pub case: LoadCase,
    /// Torque of the case; not applicable without one.
    pub torque: Datum<Torque>,
    /// Utilisation by torque alone: share of the transmissible torque \[1\].
    pub alone: Datum<Ratio>,
    /// Tilting moment that acts simultaneously.
    pub moment: Datum<Torque>,
    /// Joint under simultaneous torque, moment and forces, from the model.
    pub together: Datum<LoadedJoint>,
}

/// A bolted joint with its results.
#[derive(Clone, Debug, PartialEq)]
pub struct BoltedJoint {
    /// Side of the joint.
    pub side: Side,
    /// Screws, bolt circle and torques from the manual.
    pub screws: ScrewJoint,
    /// Coefficient of friction to which the stated torque applies.
    pub friction: Datum<Ratio>,
    /// Clamp force of a screw implied by the stated torque.
    pub clamp_force: Datum<Force>,
    /// Results by load case.
    pub cases: Vec<CaseAnswer>,
}

const MODEL: Source = Source::Model { name: "screw-joint" };

/// Computes a joint in all load cases.
#[must_use]
pub fn joint(code: &OrderCode, side: Side, actuator: &Parameters, axis: &AxisLoads) -> BoltedJoint {
    let screws = match side {
        Side::Load => &actuator.screw_joint_load,
        Side::Housing => &actuator.screw_joint_housing,
    };
    let friction = friction(screws);
    let clamp = clamp(screws, &friction);
    let own = match side {
        Side::Load => &axis.torque_load,
        Side::Housing => &axis.torque_housing,
    };
    let stated = |stated: &Option<Sourced<Torque>>, limit: &Datum<Torque>| {
        stated.as_ref().map_or_else(|| limit.clone(), |torque| Datum::Known(torque.clone()))
    };
    let torques = [
        (LoadCase::Peak, stated(own, &actuator.torque_max)),
        (LoadCase::Collision, stated(&axis.collision, &actuator.gear.collision_torque_max)),
        (LoadCase::Brake, actuator.brake.holding_torque.clone()),
        (LoadCase::StaticMoment, Datum::NotApplicable),
    ];
    let cases = torques
        .into_iter()
        .filter(|(case, torque)| *case != LoadCase::Brake || *torque != Datum::NotApplicable)
        .map(|(case, torque)| {
            let (moment, axial, radial) = flange_loads(code, case, actuator, axis);
            let alone = match (&torque, &screws.transmissible_torque) {
                (Datum::Known(torque), Datum::Known(limit)) => Datum::Known(Sourced {
                    value: joint_utilisation(torque.value, limit.value),
                    source: limit.source.clone(),
                    grade: torque.grade.worst(limit.grade).worst(Grade::Computed),
                    errata: limit.errata,
                }),
                (Datum::NotApplicable, _) => Datum::NotApplicable,
                _ => Datum::NotPrinted,
            };
            let together = combined(screws, &friction, &clamp, &torque, (&moment, axial, radial));
            CaseAnswer { case, torque, alone, moment, together }
        })
        .collect();
    BoltedJoint { side, screws: screws.clone(), friction, clamp_force: clamp, cases }
}

/// Returns moment and forces that act with a torque: those of the project, else only the moment permitted by the output
/// bearing.
fn flange_loads(
    code: &OrderCode,
    case: LoadCase,
    actuator: &Parameters,
    axis: &AxisLoads,
) -> (Datum<Torque>, Force, Force) {
    let none = Force::from_si(0.0);
    match (&axis.flange, case) {
        (Some(flange), LoadCase::Peak | LoadCase::Collision | LoadCase::Brake) => {
            (Datum::Known(flange.tilting_moment.clone()), flange.axial.value, flange.radial.value)
        }
        (None, LoadCase::Peak | LoadCase::Collision | LoadCase::Brake) => {
            (actuator.output_bearing.tilting_moment_max.clone(), none, none)
        }
        (_, LoadCase::StaticMoment) => {
            let cell = catalogue::size_cell(code.size, code.ratio, "M_0_max");
            (cell.map_or(Datum::NotPrinted, catalogue::datum_of), none, none)
        }
    }
}

/// Returns the coefficient of friction stated below table 79.1, for the torque stated there.
fn friction(screws: &ScrewJoint) -> Datum<Ratio> {
    let fact = catalogue::fact("degrease_joint_faces");
    match (fact.and_then(|fact| fact.values.first()), screws.transmissible_torque.known()) {
        (Some(value), Some(torque)) => Datum::Known(Sourced {
            value: Ratio::from_si(value.number),
            source: torque.source.clone(),
            grade: Grade::Printed,
            errata: &[],
        }),
        _ => Datum::NotPrinted,
    }
}

/// Returns transmissible torque, friction, number of screws and bolt circle, if all are known.
fn known(screws: &ScrewJoint, friction: &Datum<Ratio>) -> Option<(Torque, Ratio, f64, Length)> {
    Some((
        screws.transmissible_torque.known()?.value,
        friction.known()?.value,
        screws.count.known()?.value,
        screws.bolt_circle.known()?.value,
    ))
}

fn clamp(screws: &ScrewJoint, friction: &Datum<Ratio>) -> Datum<Force> {
    Datum::of(known(screws, friction).map(|(torque, friction, count, circle)| Sourced {
        value: clamp_force(torque, friction, count, circle),
        source: MODEL,
        grade: Grade::Estimated,
        errata: &[],
    }))
}

fn combined(
    screws: &ScrewJoint,
    friction: &Datum<Ratio>,
    clamp: &Datum<Force>,
    torque: &Datum<Torque>,
    (moment, axial, radial): (&Datum<Torque>, Force, Force),
) -> Datum<LoadedJoint> {
    let torque = match torque {
        Datum::Known(torque) => torque.value,
        // A case without torque has only the moment.
        Datum::NotApplicable => Torque::from_si(0.0),
        Datum::NotPrinted => return Datum::NotPrinted,
    };
    match (known(screws, friction), clamp.known(), moment.known()) {
        (Some((_, friction, count, circle)), Some(clamp), Some(moment)) => {
            let load = JointLoad { torque, tilting_moment: moment.value, axial, radial };
            Datum::Known(Sourced {
                value: loaded_joint(&load, clamp.value, friction, count, circle),
                source: MODEL,
                grade: Grade::Estimated,
                errata: moment.errata,
            })
        }
        _ => Datum::NotPrinted,
    }
}
