//! The screw joints of load and housing: what they take of torque, tilting moment and force.

use crate::fit::Side;
use actuator::{JointLoad, LoadedJoint, Parameters, ScrewJoint, clamp_force, joint_utilisation, loaded_joint};
use order_code::OrderCode;
use provenance::{Datum, Grade, Source, Sourced};
use quantities::{Force, Length, Measure, Ratio, Torque, identified};

identified! {
    /// What loads a joint.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum LoadCase {
        /// Acceleration and braking.
        Peak = "peak",
        /// A collision of the load.
        Collision = "collision",
        /// The brake stops or holds the load.
        Brake = "brake",
        /// A moment on the axis at rest, without torque.
        StaticMoment = "static_moment",
    }
}

/// Loads of a project, in place of the limits of the actuator. What is absent stays the limit.
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

/// What a project puts on the output flange, each at its largest.
#[derive(Clone, Debug, PartialEq)]
pub struct FlangeLoads {
    /// Tilting moment about the centre of the output bearing.
    pub tilting_moment: Sourced<Torque>,
    /// Axial force.
    pub axial: Sourced<Force>,
    /// Radial force.
    pub radial: Sourced<Force>,
}

/// A joint under one load.
#[derive(Clone, Debug, PartialEq)]
pub struct CaseAnswer {
    /// Which load.
    pub case: LoadCase,
    /// The torque; not applicable to a case without.
    pub torque: Datum<Torque>,
    /// Share of the transmissible torque, torque alone.
    pub alone: Datum<Ratio>,
    /// The tilting moment that acts with it.
    pub moment: Datum<Torque>,
    /// The joint under torque, moment and forces at once, by the model.
    pub together: Datum<LoadedJoint>,
}

/// One of the two joints.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// Which.
    pub side: Side,
    /// Screws, circle and torques, as printed.
    pub screws: ScrewJoint,
    /// Coefficient of friction that the printed torque holds for.
    pub friction: Datum<Ratio>,
    /// Clamp force of a screw that the printed torque implies.
    pub clamp_force: Datum<Force>,
    /// What it takes.
    pub cases: Vec<CaseAnswer>,
}

const MODEL: Source = Source::Model { name: "screw-joint" };

/// A joint and what it takes under every load.
#[must_use]
pub fn joint(code: &OrderCode, side: Side, actuator: &Parameters, axis: &AxisLoads) -> Joint {
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
            let together = together(screws, &friction, &clamp, &torque, (&moment, axial, radial));
            CaseAnswer { case, torque, alone, moment, together }
        })
        .collect();
    Joint { side, screws: screws.clone(), friction, clamp_force: clamp, cases }
}

/// Moment and forces that act with a torque: those of the project, else the moment that the output bearing permits, alone.
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

/// The coefficient of friction that the manual states below table 79.1, for the torque printed there.
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

/// Transmissible torque, friction, number of screws and bolt circle, if all are known.
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

fn together(
    screws: &ScrewJoint,
    friction: &Datum<Ratio>,
    clamp: &Datum<Force>,
    torque: &Datum<Torque>,
    (moment, axial, radial): (&Datum<Torque>, Force, Force),
) -> Datum<LoadedJoint> {
    let torque = match torque {
        Datum::Known(torque) => torque.value,
        // A case without torque is one of the moment alone.
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
