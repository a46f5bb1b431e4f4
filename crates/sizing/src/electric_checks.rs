//! The DC link, and every instant of the cycle against the torque-speed plane.

use crate::axis::Axis;
use crate::check::{Check, CheckId, Verdict};
use crate::comparison::{Comparison, Edges, not_checked};
use crate::currents::Currents;
use crate::trace::Node;
use crate::workings;
use actuator::Parameters;
use derivation::Workings;
use provenance::{Grade, Missing, Source};
use quantities::unit::{NEWTON_METRE, REVOLUTION_PER_MINUTE, VOLT};
use quantities::{AngularVelocity, ElectricPotential, Measure, Time};

/// U_DC ≤ U_DCmax.
pub(crate) fn dc_link(supply: ElectricPotential, actuator: &Parameters, work: &mut Workings) -> Check {
    let id = CheckId::DcLink;
    match actuator.dc_link_max.require("U_DCmax") {
        Ok(limit) => {
            let source = Source::Project { key: "requirements.supply".into() };
            work.figure("U_DC", &VOLT, supply.si(), &source, Grade::Printed);
            work.value("U_DC");
            work.given("U_DCmax", &VOLT, limit);
            work.limit("U_DCmax");
            Comparison::with(id, &VOLT, supply.si(), source, limit).answer(Verdict::Fail)
        }
        Err(missing) => not_checked(id, missing),
    }
}

/// |T| ≤ short-time torque at the speed of every instant; while braking the voltage helps, and T_max is the limit.
///
/// Where no short-time curve is published, what lies between the torque with a cold gear within I_max and the upper edge,
/// which leaves I_max to its own check, is advice.
pub(crate) fn torque_speed_trace(
    axis: &Axis,
    actuator: &Parameters,
    currents: Result<&Currents, &Missing>,
    work: &mut Workings,
) -> Check {
    let id = CheckId::TorqueSpeedTrace;
    let terminal = axis.terminal_voltage();
    let found = (|| {
        let currents = currents.map_err(|missing| *missing)?;
        let highest = actuator.torque_max.require("T_max")?;
        let standstill = AngularVelocity::from_si(0.0);
        let first = actuator::short_time_torque(actuator, standstill, terminal, currents.cold())?;
        Ok((currents, highest, first))
    })();
    let (currents, highest, first) = match found {
        Ok(found) => found,
        Err(missing) => return not_checked(id, missing),
    };
    let (inertia, most) = (currents.inertia, highest.value.si());
    let limits = |speed: f64| {
        let speed = AngularVelocity::from_si(speed);
        actuator::short_time_torque(actuator, speed, terminal, currents.cold())
            .map_or((0.0, 0.0), |limit| (limit.limit.value.si(), limit.upper.si()))
    };
    let torque = |node: &Node| inertia * node.acceleration + node.load;
    // Neighbouring instants often share their speed.
    let last = std::cell::Cell::new((0.0, (first.limit.value.si(), first.upper.si())));
    let at_speed = |speed: f64| {
        let (known, limits_there) = last.get();
        if known == speed.abs() {
            return limits_there;
        }
        let found = limits(speed);
        last.set((speed.abs(), found));
        found
    };
    let share = |torque: f64, limit: f64| {
        if torque == 0.0 {
            0.0
        } else if limit > 0.0 {
            torque.abs() / limit
        } else {
            f64::MAX
        }
    };
    let braking = |node: &Node| torque(node) * node.direction < 0.0;
    let (found, worst) = axis.trace.largest(
        |extent| share(extent.torque(inertia), at_speed(extent.speed).0),
        |node| share(torque(node), if braking(node) { most } else { at_speed(node.speed).0 }),
    );
    let by_upper = || {
        axis.trace.largest(
            |extent| share(extent.torque(inertia), at_speed(extent.speed).1),
            |node| share(torque(node), if braking(node) { most } else { at_speed(node.speed).1 }),
        )
    };
    if work.is_on() {
        workings::torque_at(&worst, actuator, work);
        work.formula("T_at", &NEWTON_METRE, torque(&worst).abs(), "abs(T)", &workings::DEMAND);
        work.value("T_at");
    }
    let speed = AngularVelocity::from_si(worst.speed);
    let curve = if braking(&worst) {
        work.given("T_max", &NEWTON_METRE, highest);
        Ok(actuator::ContinuousLimit { limit: highest.clone(), upper: highest.value })
    } else {
        let source = &workings::DEMAND;
        work.found("n", &REVOLUTION_PER_MINUTE, worst.speed, "speed at t", source, Grade::Computed);
        actuator::short_time_torque_with(actuator, speed, terminal, currents.cold(), work)
    };
    let curve = match curve {
        Ok(curve) => curve,
        Err(missing) => return not_checked(id, missing),
    };
    work.limit(if braking(&worst) { "T_max" } else { "T_short" });
    // Where the lower edge is exceeded the instant that counts may be another one for the upper edge.
    let beyond = found > 1.0 && by_upper().0 > 1.0;
    let (value, limit) = (torque(&worst).abs(), curve.limit.value.si());
    let upper = if beyond { limit } else { curve.upper.si().max(value) };
    let edges = Edges { limit, upper, unit: &NEWTON_METRE };
    Comparison {
        at: Some(Time::from_si(worst.time)),
        ..Comparison::with(id, &NEWTON_METRE, value, Source::Model { name: "demand" }, &curve.limit)
    }
    .between(edges)
}
