//! The DC link, and every instant of the cycle against the torque-speed plane.

use crate::axis::Axis;
use crate::check::{Check, CheckId, Verdict};
use crate::comparison::{Comparison, Edges, not_checked};
use crate::currents::Currents;
use crate::notes::Note;
use crate::workings;
use actuator::{Drivetrain, Parameters};
use derivation::Workings;
use provenance::{Grade, Missing, Source};
use quantities::unit::{NEWTON_METRE, REVOLUTION_PER_MINUTE, VOLT};
use quantities::{AngularVelocity, ElectricPotential, Measure, Time};
use trace::{Any, Extent, Node};

/// U_DC ≤ U_DCmax, the largest *stationary* voltage. What energy that comes back adds may pass it for a short time while
/// braking (glossary of the manual), nobody says how far and how long: with the rise that the project permits above
/// U_DCmax the answer is advice.
pub(crate) fn dc_link(
    supply: ElectricPotential,
    rise: Option<ElectricPotential>,
    actuator: &Drivetrain,
    work: &mut Workings,
) -> Check {
    let id = CheckId::DcLink;
    let limit = match actuator.dc_link_max.require("U_DCmax") {
        Ok(limit) => limit,
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

/// A function of the speed on so many equal steps, each found when it is asked for.
struct Steps {
    width: f64,
    known: [std::cell::Cell<Option<(f64, f64)>>; STEPS],
}

/// Speeds that differ by so little of the largest lie between two samples.
const CLOSE: f64 = 1e-4;

/// Steps between standstill and the largest speed.
const STEPS: usize = 64;

impl Steps {
    fn of(most: f64) -> Self {
        #[allow(clippy::cast_precision_loss, reason = "a small count")]
        let width = most / STEPS as f64;
        Self { width, known: [const { std::cell::Cell::new(None) }; STEPS] }
    }

    /// The values at the end of the step that holds a speed.
    fn at(&self, speed: f64, of: impl Fn(f64) -> (f64, f64)) -> (f64, f64) {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped by the count of steps")]
        let index = (speed / self.width) as usize;
        match self.known.get(index) {
            Some(known) => known.get().unwrap_or_else(|| {
                #[allow(clippy::cast_precision_loss, reason = "a small count")]
                let found = of((index + 1) as f64 * self.width);
                known.set(Some(found));
                found
            }),
            None => of(speed),
        }
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
    let torque = |node: &Node| inertia * node.acceleration_rad_s2 + node.load_nm;
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
    // The limits fall with the speed: those at the next higher of a few speeds are below them, and cost less.
    let steps = (!axis.trace.is_short()).then(|| Steps::of(axis.moments.speed_peak.si()));
    let below = |speed: f64| steps.as_ref().map_or_else(|| at_speed(speed), |steps| steps.at(speed, at_speed));
    let largest_share = |edge: fn((f64, f64)) -> f64| {
        let highest = std::cell::Cell::new(0.0_f64);
        let seen = |share: f64| {
            highest.set(highest.get().max(share));
            share
        };
        axis.trace.largest(&Any(
            |extent: &Extent| {
                // Between two instants the exact limit decides sooner.
                let (low, high) = extent.speeds_rad_s;
                let close = high - low <= CLOSE * axis.moments.speed_peak.si();
                let limits = if close { at_speed(extent.speed_rad_s) } else { below(extent.speed_rad_s) };
                share(extent.torque(inertia), edge(limits))
            },
            |node: &Node| {
                let torque = torque(node);
                if braking(node) {
                    return seen(share(torque, most));
                }
                let above = share(torque, edge(below(node.speed_rad_s.abs())));
                // What is not the largest even so need not be exact.
                if above < highest.get() { above } else { seen(share(torque, edge(at_speed(node.speed_rad_s)))) }
            },
        ))
    };
    let (found, worst) = largest_share(|(lower, _)| lower);
    let by_upper = || largest_share(|(_, upper)| upper);
    if work.is_on() {
        workings::torque_at(&worst, actuator, work);
        work.formula("T_at", &NEWTON_METRE, torque(&worst).abs(), "abs(T)", &workings::DEMAND);
        work.value("T_at");
    }
    let speed = AngularVelocity::from_si(worst.speed_rad_s);
    let curve = if braking(&worst) {
        work.given("T_max", &NEWTON_METRE, highest);
        Ok(actuator::ContinuousLimit { limit: highest.clone(), upper: highest.value })
    } else {
        let source = &workings::DEMAND;
        work.found("n", &REVOLUTION_PER_MINUTE, worst.speed_rad_s, "speed at t", source, Grade::Computed);
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
        at: Some(Time::from_si(worst.time_s)),
        ..Comparison::with(id, &NEWTON_METRE, value, Source::Model { name: "demand" }, &curve.limit)
    }
    .between(edges)
}
