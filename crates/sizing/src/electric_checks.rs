//! Checks of the DC link, and of every instant of the cycle against the torque-speed plane.

use crate::axis::Axis;
use crate::check::{Check, CheckId, Verdict};
use crate::comparison::{Asking, Comparison, Edges, project};
use crate::list::{Case, Outcome};
use crate::notes::Note;
use crate::supply::Edge;
use crate::workings;
use actuator::{ContinuousLimit, Drivetrain, ShortTime, chopper_thresholds};
use derivation::{Finding, Workings};
use numeric::{First, at_most};
use provenance::{Grade, Missing, Source};
use quantities::unit::{NEWTON_METRE, REVOLUTION_PER_MINUTE, VOLT};
use quantities::{AngularVelocity, ElectricPotential, Measure, Time, Torque};
use trace::{Extent, Node, Sought, Trace};

/// Checks U_DC ≤ U_DCmax, the largest *stationary* voltage. Regenerated energy may raise the voltage above it for a
/// short time while braking (glossary of the manual), and no source states by how much and how long: if the rise that
/// the project permits exceeds U_DCmax the result is advice; also if no braking resistor can be switched between supply
/// and U_DCmax and the project states no rise, because any regenerated energy then exceeds U_DCmax.
pub(crate) fn dc_link(axis: &Axis, actuator: &Drivetrain, work: &mut Workings) -> Outcome {
    let (id, rise) = (CheckId::DcLink, axis.asked.dc_link_rise);
    let link = axis.supply.ok_or(Missing { symbol: "requirements.supply" })?;
    let limit = actuator.dc_link_max.require("U_DCmax")?;
    let (source, supply) = (link.source(), link.at(Edge::High));
    link.explain(Edge::High, work);
    let is_within = |voltage: ElectricPotential| at_most(voltage.si(), limit.value.si());
    // A supply voltage that is too high is the fault, independent of the rise.
    let top = rise.map(|rise| supply + rise).filter(|top| is_within(supply) && !is_within(*top));
    let check = match (top, rise) {
        (Some(top), Some(rise)) => {
            let key = "requirements.dc_link_rise";
            let asked = project(key);
            work.stated("dU", &VOLT, rise.si(), key);
            work.formula("U_top", &VOLT, top.si(), "U_DC + dU", &asked);
            work.value("U_top");
            let free = limit.value - supply;
            let notes = Note::DcLinkRises { to: top, free }.into();
            Comparison { notes, ..Comparison::with(id, &VOLT, top.si(), asked, limit) }.answer(Verdict::Advice)
        }
        _ => {
            work.value("U_DC");
            let comparison = Comparison::with(id, &VOLT, supply.si(), source, limit);
            let mut check =
                Comparison { grade: comparison.grade.worst(link.grade()), ..comparison }.answer(Verdict::Fail);
            let has_room = chopper_thresholds(supply, Some(limit.value)).is_some() || rise.is_some();
            if check.verdict == Verdict::Pass && !has_room {
                check.verdict = Verdict::Advice;
                check.notes.push(Note::NoChopperThreshold { supply, limit: limit.value });
            }
            check
        }
    };
    work.given("U_DCmax", &VOLT, limit);
    work.limit("U_DCmax");
    Ok(check)
}

/// Required share of the short-time torque at the speed of an instant; while braking, of T_max.
struct Share<'a> {
    inertia: f64,
    /// T_max \[Nm\]
    most: f64,
    short_time: &'a ShortTime<'a>,
    /// Selected edge of its band.
    edge: fn([Torque; 2]) -> Torque,
    corners: Vec<f64>,
}

impl<'a> Share<'a> {
    fn of(inertia: f64, most: f64, short_time: &'a ShortTime<'a>) -> Self {
        let edge = |[lower, _]: [Torque; 2]| lower;
        Self { inertia, most, short_time, edge, corners: short_time.corners() }
    }

    /// Selects the upper edge of the band.
    fn of_the_upper_edge(self) -> Self {
        Self { edge: |[_, upper]| upper, ..self }
    }

    /// Returns T \[Nm\].
    fn torque(&self, node: &Node) -> f64 {
        self.inertia * node.acceleration_rad_s2 + node.load_nm
    }

    fn is_braking(&self, node: &Node) -> bool {
        self.torque(node) * node.direction < 0.0
    }

    /// Returns the fastest instant, given one that is as fast up to the tolerance of the search; of several that are equally
    /// fast up to [`numeric::EQUAL`] the one with the largest torque, and the first of these.
    fn fastest(&self, trace: &Trace, near: Node) -> Node {
        let mut fastest = near.speed_rad_s.abs();
        let each = |least: f64, look: &mut dyn FnMut(&Node)| {
            trace.as_fast_as(least, &mut |node| {
                if !self.is_braking(node) {
                    look(node);
                }
            });
        };
        each(near.speed_rad_s, &mut |node| fastest = fastest.max(node.speed_rad_s.abs()));
        let mut largest = First::above(f64::NEG_INFINITY, near);
        each(fastest, &mut |node| largest.see(self.torque(node).abs(), node.time_s, *node));
        largest.place()
    }

    /// Returns the limit at a speed.
    fn limit(&self, speed_rad_s: f64) -> Torque {
        (self.edge)(self.short_time.at(AngularVelocity::from_si(speed_rad_s)))
    }
}

/// Share from which nothing is permitted at the speed.
const NOTHING_PERMITTED: f64 = 1e100;

/// |T| over a limit at a speed. Where nothing is permitted, above every finite share and growing with the speed, so that
/// the fastest instant is the worst.
fn share(torque: f64, limit: f64, speed_rad_s: f64) -> f64 {
    let torque = torque.abs();
    if torque == 0.0 {
        0.0
    } else if limit > 0.0 {
        torque / limit
    } else {
        NOTHING_PERMITTED * (1.0 + speed_rad_s.abs())
    }
}

impl Sought for Share<'_> {
    fn bound(&self, extent: &Extent) -> f64 {
        let (back, forth) = extent.speeds_rad_s;
        let [slower, faster] = [back.max(-forth).max(0.0), extent.speed_rad_s].map(AngularVelocity::from_si);
        let limit = (self.edge)(self.short_time.least_between(slower, faster)).si();
        share(extent.torque(self.inertia), limit, extent.speed_rad_s)
    }

    fn value(&self, node: &Node) -> f64 {
        let limit = if self.is_braking(node) { self.most } else { self.limit(node.speed_rad_s).si() };
        share(self.torque(node), limit, node.speed_rad_s)
    }

    fn corners(&self) -> &[f64] {
        &self.corners
    }
}

/// |T| ≤ short-time torque at the speed of every instant; while braking the voltage helps, and T_max is the limit.
///
/// Checks every instant against the short-time torque. Without a published short-time curve, a torque between that with
/// a cold gear within I_max and the upper edge is advice; the upper edge leaves I_max to its own check.
pub(crate) fn torque_speed_trace(case: &Case<'_>, work: &mut Workings) -> Option<Outcome> {
    worst_instant(case, work).transpose()
}

fn worst_instant(case: &Case<'_>, work: &mut Workings) -> Result<Option<Check>, Missing> {
    let Case { axis, actuator, currents, .. } = *case;
    let id = CheckId::TorqueSpeedTrace;
    let terminal = axis.terminal_voltage();
    let currents = currents.map_err(|missing| *missing)?;
    let highest = actuator.torque_max.require("T_max")?;
    let short_time = ShortTime::of(actuator, terminal, currents.cold())?;
    let lower = Share::of(currents.inertia, highest.value.si(), &short_time);
    let Some((found, mut worst)) = axis.trace.largest_above(&lower, case.least(1.0)) else { return Ok(None) };
    if found >= NOTHING_PERMITTED {
        worst = lower.fastest(&axis.trace, worst);
    }
    let (torque, is_braking) = (lower.torque(&worst).abs(), lower.is_braking(&worst));
    if work.is_on() {
        workings::torque_at(axis, &worst, actuator, work);
        work.formula("T_at", &NEWTON_METRE, torque, "abs(T)", &workings::DEMAND);
        work.value("T_at");
    }
    let speed = AngularVelocity::from_si(worst.speed_rad_s);
    let curve = if is_braking {
        work.given("T_max", &NEWTON_METRE, highest);
        ContinuousLimit { limit: highest.clone(), upper: highest.value }
    } else {
        let source = &workings::DEMAND;
        work.found("n", &REVOLUTION_PER_MINUTE, worst.speed_rad_s, Finding::SpeedAt, source, Grade::Computed);
        short_time.explain(speed, work);
        short_time.limit(speed)
    };
    work.limit(if is_braking { "T_max" } else { "T_short" });
    // Beyond the lower edge, another instant may be decisive for the upper edge.
    let beyond = !at_most(found, 1.0) && {
        let upper = lower.of_the_upper_edge();
        !at_most(upper.value(&worst), 1.0) || !at_most(axis.trace.largest(&upper).0, 1.0)
    };
    let limit = curve.limit.value.si();
    let upper = if beyond { limit } else { curve.upper.si().max(torque) };
    let edges = Edges { limit, upper, unit: &NEWTON_METRE };
    let mut check = Comparison {
        at: Some(Time::from_si(worst.time_s)),
        ..Comparison::with(id, &NEWTON_METRE, torque, Source::Model { name: "demand" }, &curve.limit)
    }
    .between(edges);
    // Above its end the curve permits nothing: the excess is that of the speed.
    let end = short_time.end();
    if limit == 0.0 && check.verdict == Verdict::Fail && !at_most(speed.si().abs(), end.si()) {
        check.utilisation = Some(speed.si().abs() / end.si());
        check.notes.push(Note::AboveEndOfCurve { speed: AngularVelocity::from_si(speed.si().abs()), end });
    }
    Ok(Some(check))
}
