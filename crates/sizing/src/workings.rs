//! Parts of derivations that several checks share.

use crate::axis::Axis;
use crate::comparison::{Asking, equation, project};
use crate::demand::{Demand, ManualDemand};
use actuator::Parameters;
use derivation::{Finding, Workings};
use provenance::{Grade, Source};
use quantities::Measure;
use quantities::unit::{
    KILOGRAM_SQUARE_METRE, NEWTON_METRE, ONE, RADIAN, RADIAN_PER_SECOND_SQUARED, REVOLUTION_PER_MINUTE, SECOND,
};
use trace::{Node, TorqueWith};

/// Model of the load and its motion.
pub(crate) const DEMAND: Source = Source::Model { name: "demand" };

/// Records J_out of the actuator.
pub(crate) fn own_inertia(actuator: &Parameters, work: &mut Workings) {
    work.known("J_out", &KILOGRAM_SQUARE_METRE, &actuator.inertia_out);
}

/// Returns the source of the inertia of the load.
pub(crate) fn inertia_source(axis: &Axis) -> Source {
    match axis.by_the_manual() {
        Some(_) => project("load.inertia"),
        None => Source::Model { name: "mechanisms" },
    }
}

/// Records an instant: J_out, α and T_L there.
pub(crate) fn instant(node: &Node, actuator: &Parameters, work: &mut Workings) {
    own_inertia(actuator, work);
    work.figure("t", &SECOND, node.time_s, &DEMAND, Grade::Computed);
    work.found(
        "alpha",
        &RADIAN_PER_SECOND_SQUARED,
        node.acceleration_rad_s2,
        Finding::AccelerationAt,
        &DEMAND,
        Grade::Computed,
    );
    work.found("T_L", &NEWTON_METRE, node.load_nm, Finding::TorqueOfLoadAt, &DEMAND, Grade::Computed);
}

/// Records the torque at an instant: α and T_L there, and `T` = J_out α + T_L.
pub(crate) fn torque_at(node: &Node, actuator: &Parameters, work: &mut Workings) {
    if !work.is_on() {
        return;
    }
    let inertia = actuator.inertia_out.known().map_or(0.0, |inertia| inertia.value.si());
    instant(node, actuator, work);
    work.formula("T", &NEWTON_METRE, inertia * node.acceleration_rad_s2 + node.load_nm, "J_out*alpha + T_L", &DEMAND);
}

/// Records the largest torque, `T_peak`.
pub(crate) fn peak_torque(axis: &Axis, actuator: &Parameters, demand: &Demand, work: &mut Workings) {
    if !work.is_on() {
        return;
    }
    let inertia = actuator.inertia_out.known().map_or(0.0, |inertia| inertia.value.si());
    let (_, node) = axis.trace.largest(&TorqueWith { inertia_kgm2: inertia });
    torque_at(&node, actuator, work);
    work.formula("T_peak", &NEWTON_METRE, demand.torque_peak.si(), "abs(T)", &DEMAND);
}

/// Records the three torques of the governing move by the manual's equations.
pub(crate) fn manual_torques(axis: &Axis, actuator: &Parameters, manual: &ManualDemand, work: &mut Workings) {
    let found = axis.by_the_manual().and_then(|(inertia, friction, moves)| {
        Some((inertia, friction, moves.get(manual.governing)?, manual.moves.get(manual.governing)?))
    });
    let Some((inertia, friction, each, torques)) = found.filter(|_| work.is_on()) else { return };
    work.stated("T_L", &NEWTON_METRE, friction.si(), "load.friction_torque");
    work.stated("J_L", &KILOGRAM_SQUARE_METRE, inertia.si(), "load.inertia");
    own_inertia(actuator, work);
    work.stated("n_2", &REVOLUTION_PER_MINUTE, each.speed.si(), "motion.speed");
    work.stated("t_1", &SECOND, each.accelerate.si(), "motion.accelerate");
    let text = "T_L + 2*pi/60*(J_out + J_L)*abs(n_2)/t_1";
    work.formula("T_1", &NEWTON_METRE, torques.accelerate.si(), text, &equation("69.1"));
    work.formula("T_2", &NEWTON_METRE, torques.run.si(), "T_L", &equation("69.2"));
    work.formula("T_3", &NEWTON_METRE, torques.brake.si(), "T_L - (T_1 - T_L)", &equation("69.2"));
}

/// Records the effective torque, `T_rms`: by the manual's equation for one move that it describes, else by the exact
/// integral.
pub(crate) fn effective_torque(
    axis: &Axis,
    actuator: &Parameters,
    demand: &Demand,
    manual: Option<&ManualDemand>,
    work: &mut Workings,
) {
    if !work.is_on() {
        return;
    }
    if let Some(manual) = manual.filter(|manual| manual.moves.len() == 1 && !manual.braking_assumed) {
        manual_torques(axis, actuator, manual, work);
        if let Some(each) = axis.by_the_manual().and_then(|(.., moves)| moves.first()) {
            for (symbol, time, name) in [
                ("t_2", each.run, "motion.run"),
                ("t_3", each.brake, "motion.brake"),
                ("t_p", each.pause, "motion.pause"),
            ] {
                work.stated(symbol, &SECOND, time.si(), name);
            }
        }
        let text = "sqrt((T_1^2*t_1 + T_2^2*t_2 + T_3^2*t_3)/(t_1 + t_2 + t_3 + t_p))";
        work.formula("T_rms", &NEWTON_METRE, demand.torque_rms.si(), text, &equation("69.2"));
        return;
    }
    let duration = axis.moments().duration.si();
    let gram = axis.trace.gram();
    let (acceleration, load) = ([1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]);
    let effective = |of| (gram.square(of) / duration).sqrt();
    let (alpha, torque) = (effective(acceleration), effective(load));
    let product = gram.product(acceleration, load) / duration;
    let correlation = if alpha * torque > 0.0 { product / (alpha * torque) } else { 0.0 };
    work.figure("t_0", &SECOND, duration, &DEMAND, Grade::Computed);
    let grade = Grade::Computed;
    let what = Finding::AccelerationRms;
    work.found("alpha_rms", &RADIAN_PER_SECOND_SQUARED, alpha, what, &DEMAND, grade);
    work.found("T_L_rms", &NEWTON_METRE, torque, Finding::LoadRms, &DEMAND, grade);
    let what = Finding::Correlation;
    work.found("rho", &ONE, correlation, what, &DEMAND, grade);
    own_inertia(actuator, work);
    let text = "sqrt(J_out^2*alpha_rms^2 + 2*J_out*rho*alpha_rms*T_L_rms + T_L_rms^2)";
    work.formula("T_rms", &NEWTON_METRE, demand.torque_rms.si(), text, &Source::Model { name: "moments" });
}

/// Records the mean speed, `n_av`.
pub(crate) fn mean_speed(axis: &Axis, work: &mut Workings) {
    if !work.is_on() {
        return;
    }
    let moments = axis.moments();
    work.figure("t_0", &SECOND, moments.duration.si(), &DEMAND, Grade::Computed);
    let what = Finding::AngleTravelled;
    work.found("phi", &RADIAN, moments.angle_travelled.si(), what, &DEMAND, Grade::Computed);
    work.formula("n_av", &REVOLUTION_PER_MINUTE, moments.speed_mean().si(), "phi/t_0*60/(2*pi)", &equation("69.3"));
}
