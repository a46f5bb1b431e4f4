//! The DC link, the drive, and every instant of the cycle against the torque-speed plane.

use crate::axis::Axis;
use crate::check::{Check, CheckId, Verdict};
use crate::comparison::{Asking, Comparison, Edges, not_checked};
use crate::currents::Currents;
use crate::list::Case;
use crate::notes::Note;
use crate::workings;
use actuator::{ContinuousLimit, Drivetrain, ShortTime};
use derivation::{Finding, Workings};
use provenance::{Grade, Missing, Source};
use quantities::unit::{AMPERE, NEWTON_METRE, REVOLUTION_PER_MINUTE, SECOND, VOLT};
use quantities::{AngularVelocity, Measure, Time, Torque, Unit};
use trace::{Extent, Node, Panel, Sought};

/// U_DC ≤ U_DCmax, the largest *stationary* voltage. What energy that comes back adds may pass it for a short time while
/// braking (glossary of the manual), no source says how far and how long: with the rise that the project permits above
/// U_DCmax the answer is advice.
pub(crate) fn dc_link(axis: &Axis, actuator: &Drivetrain, work: &mut Workings) -> Check {
    let (id, rise) = (CheckId::DcLink, axis.asked.dc_link_rise);
    let supply = axis.supply.ok_or(Missing { symbol: "requirements.supply" });
    let (supply, limit) = match supply.and_then(|(supply, _)| Ok((supply, actuator.dc_link_max.require("U_DCmax")?))) {
        Ok(found) => found,
        Err(missing) => return not_checked(id, missing),
    };
    let source = Source::Project { key: "requirements.supply".into() };
    work.figure("U_DC", &VOLT, supply.si(), &source, Grade::Printed);
    // A supply that is too high is the fault, whatever comes on top of it.
    let top =
        rise.map(|rise| supply + rise).filter(|top| supply.si() <= limit.value.si() && top.si() > limit.value.si());
    let check = match (top, rise) {
        (Some(top), Some(rise)) => {
            let asked = Source::Project { key: "requirements.dc_link_rise".into() };
            work.figure("dU", &VOLT, rise.si(), &asked, Grade::Printed);
            work.formula("U_top", &VOLT, top.si(), "U_DC + dU", &asked);
            work.value("U_top");
            let free = limit.value - supply;
            let notes = Note::DcLinkRises { to: top, free }.into();
            Comparison { notes, ..Comparison::with(id, &VOLT, top.si(), asked, limit) }.answer(Verdict::Advice)
        }
        _ => {
            work.value("U_DC");
            Comparison::with(id, &VOLT, supply.si(), source, limit).answer(Verdict::Fail)
        }
    };
    work.given("U_DCmax", &VOLT, limit);
    work.limit("U_DCmax");
    check
}

/// The share of the short-time torque at its speed needed at an instant; while braking, that of T_max.
struct Share<'a> {
    inertia: f64,
    /// T_max \[Nm\]
    most: f64,
    short_time: &'a ShortTime<'a>,
    /// Which edge of its band.
    edge: fn([Torque; 2]) -> Torque,
    corners: Vec<f64>,
}

impl<'a> Share<'a> {
    fn of(inertia: f64, most: f64, short_time: &'a ShortTime<'a>) -> Self {
        let edge = |[lower, _]: [Torque; 2]| lower;
        Self { inertia, most, short_time, edge, corners: short_time.corners() }
    }

    /// The same of the upper edge.
    fn of_the_upper_edge(self) -> Self {
        Self { edge: |[_, upper]| upper, ..self }
    }

    /// T \[Nm\]
    fn torque(&self, node: &Node) -> f64 {
        self.inertia * node.acceleration_rad_s2 + node.load_nm
    }

    fn is_braking(&self, node: &Node) -> bool {
        self.torque(node) * node.direction < 0.0
    }

    /// The limit at a speed.
    fn limit(&self, speed_rad_s: f64) -> Torque {
        (self.edge)(self.short_time.at(AngularVelocity::from_si(speed_rad_s)))
    }
}

/// |T| over a limit.
fn share(torque: f64, limit: f64) -> f64 {
    if torque == 0.0 {
        0.0
    } else if limit > 0.0 {
        torque.abs() / limit
    } else {
        f64::MAX
    }
}

impl Sought for Share<'_> {
    fn bound(&self, extent: &Extent) -> f64 {
        let (back, forth) = extent.speeds_rad_s;
        let [slower, faster] = [back.max(-forth).max(0.0), extent.speed_rad_s].map(AngularVelocity::from_si);
        share(extent.torque(self.inertia), (self.edge)(self.short_time.least_between(slower, faster)).si())
    }

    fn value(&self, node: &Node) -> f64 {
        let limit = if self.is_braking(node) { self.most } else { self.limit(node.speed_rad_s).si() };
        share(self.torque(node), limit)
    }

    fn corners(&self) -> &[f64] {
        &self.corners
    }
}

/// |T| ≤ short-time torque at the speed of every instant; while braking the voltage helps, and T_max is the limit.
///
/// Where no short-time curve is published, what lies between the torque with a cold gear within I_max and the upper edge,
/// which leaves I_max to its own check, is advice.
pub(crate) fn torque_speed_trace(case: &Case<'_>, work: &mut Workings) -> Check {
    let Case { axis, actuator, currents, .. } = *case;
    let id = CheckId::TorqueSpeedTrace;
    let terminal = axis.terminal_voltage();
    let found = (|| {
        let currents = currents.map_err(|missing| *missing)?;
        let highest = actuator.torque_max.require("T_max")?;
        let short_time = ShortTime::of(actuator, terminal, currents.cold())?;
        Ok((currents, highest, short_time))
    })();
    let (currents, highest, short_time) = match found {
        Ok(found) => found,
        Err(missing) => return not_checked(id, missing),
    };
    let lower = Share::of(currents.inertia, highest.value.si(), &short_time);
    let (found, worst) = axis.trace.largest(&lower);
    let (torque, is_braking) = (lower.torque(&worst).abs(), lower.is_braking(&worst));
    if work.is_on() {
        workings::torque_at(&worst, actuator, work);
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
    // Where the lower edge is exceeded the instant that counts may be another one for the upper edge.
    let beyond = found > 1.0 && axis.trace.largest(&lower.of_the_upper_edge()).0 > 1.0;
    let limit = curve.limit.value.si();
    let upper = if beyond { limit } else { curve.upper.si().max(torque) };
    let edges = Edges { limit, upper, unit: &NEWTON_METRE };
    Comparison {
        at: Some(Time::from_si(worst.time_s)),
        ..Comparison::with(id, &NEWTON_METRE, torque, Source::Model { name: "demand" }, &curve.limit)
    }
    .between(edges)
}
