//! Parts of derivations that several checks share.

use crate::axis::Axis;
use crate::comparison::{Asking, equation, project};
use crate::demand::{Demand, ManualDemand};
use crate::flange::output;
use actuator::Parameters;
use derivation::{Finding, Workings};
use mechanism::{At, Extremes, MechanismKind, Output};
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

/// One of the extremes of the inertia of the load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Extreme {
    Least,
    Largest,
}

impl Extreme {
    /// Returns value \[kgm²\] and position \[rad\] of the extreme.
    fn of(self, found: &Extremes) -> (f64, f64) {
        let [least_at, largest_at] = found.inertia_at_rad;
        match self {
            Self::Least => (found.inertia_least.si(), least_at),
            Self::Largest => (found.inertia_largest.si(), largest_at),
        }
    }

    const fn position(self) -> Finding {
        match self {
            Self::Least => Finding::PositionOfLeastInertia,
            Self::Largest => Finding::PositionOfLargestInertia,
        }
    }

    /// Records the inertia of the load under a symbol, between two positions in a segment.
    pub(crate) fn explain(
        self,
        axis: &Axis,
        symbol: &'static str,
        (segment, (low, high)): (usize, (f64, f64)),
        work: &mut Workings,
    ) {
        let extra = axis.extras.get(segment).copied().unwrap_or_default();
        let (_, at) = self.of(&axis.mechanism.extremes(low, high, &extra));
        axis.mechanism.explain_inertia(symbol, (at, self.position()), (segment, &extra), work);
    }
}

/// Returns the segment of the path, with its lowest and highest position, in which a value is largest.
fn segment_of(axis: &Axis, value: impl Fn(&Extremes) -> f64) -> Option<(usize, (f64, f64))> {
    let each = axis.trace.spans().map(|(segment, (low, high))| {
        let extra = axis.extras.get(segment).copied().unwrap_or_default();
        (value(&axis.mechanism.extremes(low, high, &extra)), (segment, (low, high)))
    });
    let first = |best: Option<(f64, _)>, each: (f64, _)| best.filter(|best| best.0 >= each.0).or(Some(each));
    each.fold(None, first).map(|(_, segment)| segment)
}

/// Records an extreme inertia of the load along the path under a symbol.
pub(crate) fn load_inertia(axis: &Axis, (symbol, which): (&'static str, Extreme), value: f64, work: &mut Workings) {
    if !work.is_on() {
        return;
    }
    if which == Extreme::Least && matches!(axis.mechanism.kind, MechanismKind::Joint(_)) {
        let source = inertia_source(axis);
        work.found(symbol, &KILOGRAM_SQUARE_METRE, value, Finding::NotKnown, &source, Grade::Computed);
        return;
    }
    let sign = if which == Extreme::Least { -1.0 } else { 1.0 };
    if let Some(segment) = segment_of(axis, |found| sign * which.of(found).0) {
        which.explain(axis, symbol, segment, work);
    }
}

/// Records the largest torque that holds the load at rest, `T_hold`.
pub(crate) fn holding_torque(axis: &Axis, work: &mut Workings) {
    if !work.is_on() {
        return;
    }
    if let Some((segment, (low, high))) = segment_of(axis, |found| found.holding.si()) {
        let extra = axis.extras.get(segment).copied().unwrap_or_default();
        let at = axis.mechanism.extremes(low, high, &extra).holding_at_rad;
        axis.mechanism.explain_holding(at, (segment, &extra), work);
    }
}

/// Records an instant: J_out, α and T_L there.
pub(crate) fn instant(axis: &Axis, node: &Node, actuator: &Parameters, work: &mut Workings) {
    own_inertia(actuator, work);
    work.figure("t", &SECOND, node.time_s, &DEMAND, Grade::Computed);
    acceleration(node, work);
    load_torque(axis, node, moving_at(axis, node).as_ref(), work);
}

fn acceleration(node: &Node, work: &mut Workings) {
    let (unit, alpha) = (&RADIAN_PER_SECOND_SQUARED, node.acceleration_rad_s2);
    work.found("alpha", unit, alpha, Finding::AccelerationAt, &DEMAND, Grade::Computed);
}

/// Records T_L at the instant `t` with the acceleration `alpha`: by the law of the mechanism, where the motion reaches the
/// instant with this torque.
fn load_torque(axis: &Axis, node: &Node, moving: Option<&Moving>, work: &mut Workings) {
    match moving {
        Some(moving) => axis.mechanism.explain_torque(&moving.at(axis), node.load_nm, work),
        None => work.found("T_L", &NEWTON_METRE, node.load_nm, Finding::TorqueOfLoadAt, &DEMAND, Grade::Computed),
    }
}

/// Records the largest load torque of the cycle under a symbol.
pub(crate) fn peak_load(axis: &Axis, symbol: &'static str, work: &mut Workings) {
    if !work.is_on() {
        return;
    }
    let (_, node) = axis.trace.largest(&TorqueWith { inertia_kgm2: 0.0 });
    let moving = moving_at(axis, &node);
    work.figure("t", &SECOND, node.time_s, &DEMAND, Grade::Computed);
    if moving.is_some() && axis.mechanism.explains_by_acceleration() {
        acceleration(&node, work);
    }
    load_torque(axis, &node, moving.as_ref(), work);
    work.formula(symbol, &NEWTON_METRE, axis.moments().load_peak.si(), "abs(T_L)", &DEMAND);
}

/// State of the output at an instant of the motion.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moving {
    time_s: f64,
    output: Output,
    pub(crate) segment: usize,
    recorded_nm: f64,
}

impl Moving {
    pub(crate) fn at(&self, axis: &Axis) -> At {
        let extra = axis.extras.get(self.segment).copied().unwrap_or_default();
        At { time_s: self.time_s, output: self.output, extra, recorded_nm: self.recorded_nm, segment: self.segment }
    }
}

/// Returns the state of the motion at a node; `None` if no part of the motion has its torque there, as while the brake holds.
fn moving_at(axis: &Axis, node: &Node) -> Option<Moving> {
    let gram = axis.trace.gram();
    let effective = (gram.square([1.0, 0.0, 0.0, 0.0]) / axis.moments().duration.si()).max(0.0).sqrt();
    let fits = |moving: &Moving| {
        let torque = axis.mechanism.torque_at(&moving.at(axis));
        let accelerated = moving.output.acceleration_rad_s2 - node.acceleration_rad_s2;
        (torque - node.load_nm).abs() <= 1e-9 * axis.moments().load_peak.si() && accelerated.abs() <= 1e-6 * effective
    };
    let mut found = states_at(axis, node.time_s, &[node.direction]).find(fits)?;
    found.output.acceleration_rad_s2 = node.acceleration_rad_s2;
    Some(found)
}

/// Shares of the cycle by which a state beside an instant is evaluated: at a corner of the load each part of the motion has
/// the torque of its own side.
const BESIDE: [f64; 5] = [0.0, 1e-12, -1e-12, 1e-9, -1e-9];

/// Returns the states of the motion at an instant and beside it, in some directions.
pub(crate) fn states_at<'a>(axis: &'a Axis, time_s: f64, directions: &'a [f64]) -> impl Iterator<Item = Moving> + 'a {
    let beside = BESIDE.map(|share| time_s + share * axis.moments().duration.si());
    beside.into_iter().flat_map(move |at_s| {
        let of = move |direction: &f64| states_exactly_at(axis, at_s, *direction);
        directions.iter().flat_map(of).map(move |moving| Moving { time_s, ..moving })
    })
}

/// Returns the states of the parts of the motion at an instant: of several, where one part ends and another begins.
fn states_exactly_at(axis: &Axis, time_s: f64, direction: f64) -> impl Iterator<Item = Moving> + '_ {
    let near = 1e-9 * axis.moments().duration.si();
    let within = move |start: f64, duration: f64| time_s >= start - near && time_s <= start + duration + near;
    let pieces = axis.motion.pieces().iter().filter(move |piece| within(piece.start_s, piece.duration_s));
    let of_pieces = pieces.map(move |piece| {
        let t = (time_s - piece.start_s).clamp(0.0, piece.duration_s);
        Moving { time_s, output: output(piece, t, direction), segment: piece.segment, recorded_nm: 0.0 }
    });
    let recorded = axis.motion.recordings().iter().flat_map(move |placed| {
        let own = (time_s - placed.start_s) / placed.stretch;
        let next = placed.recorded.time_s().partition_point(|t| *t < own);
        (next.saturating_sub(2)..next + 1).filter_map(|index| placed.interval(index)).map(move |interval| {
            let share = ((time_s - interval.start_s) / interval.duration_s).clamp(0.0, 1.0);
            let (position_rad, speed_rad_s, recorded_nm) = interval.at(share);
            let acceleration_rad_s2 = interval.acceleration_rad_s2();
            let output = Output { position_rad, speed_rad_s, acceleration_rad_s2, direction };
            Moving { time_s, output, segment: placed.segment, recorded_nm }
        })
    });
    of_pieces.chain(recorded)
}

/// Records the torque at an instant: α and T_L there, and `T` = J_out α + T_L.
pub(crate) fn torque_at(axis: &Axis, node: &Node, actuator: &Parameters, work: &mut Workings) {
    if !work.is_on() {
        return;
    }
    let inertia = actuator.inertia_out.known().map_or(0.0, |inertia| inertia.value.si());
    instant(axis, node, actuator, work);
    work.formula("T", &NEWTON_METRE, inertia * node.acceleration_rad_s2 + node.load_nm, "J_out*alpha + T_L", &DEMAND);
}

/// Records the largest torque, `T_peak`.
pub(crate) fn peak_torque(axis: &Axis, actuator: &Parameters, demand: &Demand, work: &mut Workings) {
    if !work.is_on() {
        return;
    }
    let inertia = actuator.inertia_out.known().map_or(0.0, |inertia| inertia.value.si());
    let (_, node) = axis.trace.largest(&TorqueWith { inertia_kgm2: inertia });
    torque_at(axis, &node, actuator, work);
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
