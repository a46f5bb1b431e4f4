//! The checks of the gear.

use crate::axis::Axis;
use crate::check::{Check, CheckId, Note, Verdict};
use crate::checks::{Comparison, at_least, not_checked, shown_or_at_most};
use actuator::Parameters;
use provenance::{Grade, Missing, Source};
use quantities::unit::{ARCMINUTE, HERTZ, HOUR, NEWTON_METRE};
use quantities::{AngularVelocity, Measure};

/// Every check of the gear. It carries the torque of the load only: the rotor's inertia is on its other side.
pub(crate) fn judge(axis: &Axis, actuator: &Parameters) -> Vec<Check> {
    vec![mean_torque(axis, actuator), life(axis, actuator), torsion(axis, actuator), natural_frequency(axis, actuator)]
}

/// T_av ≤ T_A; only where a rating of the gear is published.
fn mean_torque(axis: &Axis, actuator: &Parameters) -> Check {
    let id = CheckId::GearMeanTorque;
    match actuator.gear.average_torque_max.require("T_A") {
        Ok(limit) => Comparison {
            notes: vec![Note::RatingOfInterchangeableGear],
            ..Comparison::with(
                id,
                &NEWTON_METRE,
                axis.moments().load_cubic_mean.si(),
                Source::Model { name: "gear" },
                limit,
            )
        }
        .answer(Verdict::Fail),
        Err(missing) => not_checked(id, missing),
    }
}

/// L_10 of the wave-generator bearing against the life required.
fn life(axis: &Axis, actuator: &Parameters) -> Check {
    let id = CheckId::GearLife;
    let found = (|| {
        let rated = actuator.gear.rated_torque.require("T_N")?;
        let ratio = actuator.ratio.require("i")?;
        let mean = axis.moments().load_cubic_mean;
        let speed = AngularVelocity::from_si(axis.moments().speed_mean().si() * ratio.value);
        if speed.si() <= 0.0 || mean.si() <= 0.0 {
            return Err(Missing { symbol: "n_av" });
        }
        Ok((actuator::wave_generator_life(rated.value, mean, speed), rated.grade))
    })();
    match found {
        Ok((life, grade)) => {
            let asked = axis.gear_life_min.map(Measure::si);
            let source = Source::Model { name: "gear" };
            let mut check = at_least(id, &HOUR, life.si(), asked, "requirements.gear_life_min", source);
            check.grade = Some(grade.worst(Grade::Computed));
            check.notes.push(Note::RatingOfInterchangeableGear);
            check
        }
        Err(missing) => not_checked(id, missing),
    }
}

/// Torsion of the gear under the largest torque of the load.
fn torsion(axis: &Axis, actuator: &Parameters) -> Check {
    let id = CheckId::Torsion;
    let Some(curve) = actuator.gear.torsion() else { return not_checked(id, Missing { symbol: "K_1" }) };
    let worst = axis.moments().load_peak;
    let source = Source::Equation { document: "cha-manual", number: "73.1" };
    let limit = axis.torsion_max.map(Measure::si);
    let mut check =
        shown_or_at_most(id, &ARCMINUTE, curve.angle(worst).si(), limit, "requirements.torsion_max", source);
    check.at = Some(axis.moments().load_peak_at);
    check
}

/// First natural frequency of the load on the softest region of the gear, against the least that is asked.
fn natural_frequency(axis: &Axis, actuator: &Parameters) -> Check {
    let id = CheckId::NaturalFrequency;
    let [softest, _, _] = &actuator.gear.stiffness;
    let found = softest
        .require("K_1")
        .and_then(|k| if axis.moments().inertia_max.si() > 0.0 { Ok(k) } else { Err(Missing { symbol: "J_L" }) });
    match found {
        Ok(k) => {
            let frequency = actuator::natural_frequency(k.value, axis.moments().inertia_max);
            let asked = axis.natural_frequency_min.map(Measure::si);
            let source = Source::Model { name: "gear" };
            at_least(id, &HERTZ, frequency.si(), asked, "requirements.natural_frequency_min", source)
        }
        Err(missing) => not_checked(id, missing),
    }
}
