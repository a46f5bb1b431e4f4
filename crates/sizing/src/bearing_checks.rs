//! The checks of the output bearing.

use crate::axis::{Axis, BearingDuty};
use crate::check::{Check, CheckId, Note, Verdict};
use crate::comparison::{Comparison, at_least, equation, not_checked, shown_or_at_most};
use actuator::{FlangeLoad, OutputBearing};
use provenance::{Missing, Source, Sourced};
use quantities::unit::{ARCMINUTE, DEGREE, HOUR, NEWTON, NEWTON_METRE, ONE};
use quantities::{Angle, Force, Length, Measure, Torque};

/// Below this swing the manual warns of fretting (section 7.3.2).
const SWING_MIN_DEG: f64 = 5.0;

/// Every check of the output bearing; none where the user gave no loads.
pub(crate) fn judge(axis: &Axis, bearing: &OutputBearing) -> Vec<Check> {
    let Some(duty) = &axis.bearing else { return Vec::new() };
    vec![
        force(
            CheckId::BearingAxial,
            largest(duty, |load| load.axial_force.si()),
            "bearing.axial_force",
            bearing.axial_max.require("F_A_dyn_max"),
        ),
        force(
            CheckId::BearingRadial,
            largest(duty, |load| load.radial_force.si()),
            "bearing.radial_force",
            bearing.radial_max.require("F_R_dyn_max"),
        ),
        tilting_moment(duty, bearing),
        life(axis, duty, bearing),
        static_safety(duty, bearing),
        tilt_angle(duty, bearing),
    ]
}

/// F_a ≤ F_A,dyn(max) and F_r ≤ F_R,dyn(max), each alone (table 55.1, footnote 4).
fn force<Q: Measure>(id: CheckId, value: f64, key: &'static str, limit: Result<&Sourced<Q>, Missing>) -> Check {
    match limit {
        Ok(limit) => Comparison {
            notes: vec![Note::LoadsOneAtATime],
            ..Comparison::with(id, &NEWTON, value, Source::Project { key: key.into() }, limit)
        }
        .answer(Verdict::Fail),
        Err(missing) => not_checked(id, missing),
    }
}

/// The largest value over the segments, at rest as well as in motion.
fn largest(duty: &BearingDuty, value: impl Fn(&FlangeLoad) -> f64) -> f64 {
    duty.loads.iter().map(value).fold(0.0, f64::max)
}

/// The largest tilting moment of the cycle.
fn moment_of(duty: &BearingDuty, bearing: &OutputBearing) -> Result<Torque, Missing> {
    let offset = bearing.offset.require("R")?;
    Ok(Torque::from_si(largest(duty, |load| actuator::tilting_moment(load, offset.value).si())))
}

/// The averages of eq. 75.2 and 75.3 over the segments, and the tilting moment of the averages.
///
/// F_r (L_r + R) and F_a L_a are averaged like the forces, so that with distances that do not change the moment is
/// F_rav (L_r + R) + F_aav L_a.
fn mean_load(axis: &Axis, duty: &BearingDuty, offset: Length, exponent: f64) -> (FlangeLoad, Torque) {
    // Segments one after the other often carry the same.
    let mut parts: Vec<(&FlangeLoad, f64)> = Vec::new();
    for (load, share) in duty.loads.iter().zip(&axis.trace.shares) {
        match parts.last_mut().filter(|(last, _)| *last == load) {
            Some((_, travelled)) => *travelled += share.travelled,
            None => parts.push((load, share.travelled)),
        }
    }
    let mean = |value: &dyn Fn(&FlangeLoad) -> f64| {
        let parts = parts.iter().map(|(load, travelled)| (value(load), Angle::from_si(*travelled)));
        actuator::mean_load(parts, exponent)
    };
    let none = Length::from_si(0.0);
    let load = FlangeLoad {
        radial_force: Force::from_si(mean(&|load| load.radial_force.si())),
        radial_distance: none,
        axial_force: Force::from_si(mean(&|load| load.axial_force.si())),
        axial_distance: none,
    };
    let moment = mean(&|load| load.radial_force.si() * (load.radial_distance.si() + offset.si()))
        + mean(&|load| load.axial_force.si() * load.axial_distance.si());
    (load, Torque::from_si(moment))
}

/// M ≤ M_dyn(max): from the tilt that the gear allows, so it holds even where the life would allow more.
fn tilting_moment(duty: &BearingDuty, bearing: &OutputBearing) -> Check {
    let id = CheckId::BearingTiltingMoment;
    let found = moment_of(duty, bearing).and_then(|m| Ok((m, bearing.tilting_moment_max.require("M_dyn_max")?)));
    match found {
        Ok((moment, limit)) => {
            let source = Source::Model { name: "output-bearing" };
            Comparison::with(id, &NEWTON_METRE, moment.si(), source, limit).answer(Verdict::Fail)
        }
        Err(missing) => not_checked(id, missing),
    }
}

/// L_10 ≥ the life required (eq. 74.1, 74.3).
fn life(axis: &Axis, duty: &BearingDuty, bearing: &OutputBearing) -> Check {
    let id = CheckId::BearingLife;
    let found = (|| {
        let offset = bearing.offset.require("R")?;
        let pitch = bearing.pitch_diameter.require("d_p")?;
        let rating = bearing.dynamic_rating.require("C")?;
        let kind = bearing.kind.require("bearing_type")?;
        let load_factor = duty.load_factor.ok_or(Missing { symbol: "f_w" })?;
        let (load, moment) = mean_load(axis, duty, offset.value, kind.value.life_exponent());
        let equivalent = actuator::dynamic_equivalent_load(&load, moment, pitch.value);
        if equivalent.si() <= 0.0 {
            return Err(Missing { symbol: "F_r" });
        }
        let speed = axis.moments().speed_mean();
        if speed.si() <= 0.0 {
            return Err(Missing { symbol: "n_av" });
        }
        Ok(actuator::bearing_life(rating.value, equivalent, load_factor, kind.value.life_exponent(), speed))
    })();
    let life = match found {
        Ok(life) => life,
        Err(missing) => return not_checked(id, missing),
    };
    let number = if axis.moments().is_swing() { "74.3" } else { "74.1" };
    let asked = duty.life_min.map(Measure::si);
    let mut check = at_least(id, &HOUR, life.si(), asked, "requirements.bearing_life_min", equation(number));
    let swing = axis.moments().angle_swing;
    if axis.moments().is_swing() && swing.in_unit(&DEGREE) < SWING_MIN_DEG {
        check.notes.push(Note::SwingTooSmall { swing });
        if check.verdict == Verdict::Pass {
            check.verdict = Verdict::Advice;
        }
    }
    check
}

/// f_s = C_0/P_0 ≥ the least of the operating condition (eq. 76.1, table 76.3).
fn static_safety(duty: &BearingDuty, bearing: &OutputBearing) -> Check {
    let id = CheckId::BearingStatic;
    let found = (|| {
        let offset = bearing.offset.require("R")?;
        let pitch = bearing.pitch_diameter.require("d_p")?;
        let rating = bearing.static_rating.require("C_0")?;
        let safety = duty.loads.iter().map(|load| {
            let moment = actuator::tilting_moment(load, offset.value);
            actuator::static_safety(rating.value, load, moment, pitch.value)
        });
        let safety = safety.fold(f64::INFINITY, f64::min);
        if safety.is_finite() { Ok(safety) } else { Err(Missing { symbol: "F_r" }) }
    })();
    match found {
        Ok(safety) => {
            let asked = duty.operating_condition.map(crate::axis::OperatingCondition::static_safety_min);
            at_least(id, &ONE, safety, asked, "bearing.operating_condition", equation("76.1"))
        }
        Err(missing) => not_checked(id, missing),
    }
}

/// γ = M/K_B ≤ the tilt permitted (eq. 76.4).
fn tilt_angle(duty: &BearingDuty, bearing: &OutputBearing) -> Check {
    let id = CheckId::TiltAngle;
    let found = moment_of(duty, bearing).and_then(|m| Ok((m, bearing.tilting_stiffness.require("K_B")?)));
    let (moment, stiffness) = match found {
        Ok(found) => found,
        Err(missing) => return not_checked(id, missing),
    };
    let tilt = actuator::tilt_angle(moment, stiffness.value).si();
    let limit = duty.tilt_max.map(Measure::si);
    shown_or_at_most(id, &ARCMINUTE, tilt, limit, "requirements.tilt_angle_max", equation("76.4"))
}
