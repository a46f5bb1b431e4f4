//! Checks of the holding brake.

use crate::axis::Axis;
use crate::brake_times::brakings;
use crate::check::{Amount, Check, CheckId, Verdict};
use crate::comparison::{Asking, Comparison, against_asked, not_checked, project, unjudged};
use crate::list::{Case, Outcome};
use crate::notes::{BrakeStop, Note, Notes};
use crate::workings::{self, Extreme};
use actuator::{Brake, Parameters, StopOutcome};
use derivation::{Finding, Workings};
use motion::Hold;
use provenance::{Datum, Grade, Missing, Source};
use quantities::unit::{
    DEGREE, KILOGRAM_SQUARE_METRE, NEWTON_METRE, ONE, RADIAN_PER_SECOND, REVOLUTION_PER_MINUTE, SECOND,
};
use quantities::{Measure, MomentOfInertia, Time};

/// Share of the weight below which the load counts as balanced: the rounding of an angle.
const HANGING: f64 = 1e-9;

/// Relation of axis and actuator to a brake.
enum Held {
    /// The load is under gravity or tension and not held in a dwell.
    Free,
    /// The actuator has no brake, and the motion requires one.
    Absent,
    /// The actuator has no brake, and the load is under gravity or tension.
    Unheld,
    /// No brake is involved, or it is unknown whether the actuator has one.
    Unconcerned,
    /// The load is under gravity or tension, and it is unknown whether the actuator has a brake.
    NotPrinted,
    /// The actuator has a brake, and the torque that holds the load is unknown.
    LoadNotKnown,
    /// The actuator has a brake.
    Braked,
}

impl Held {
    fn of(axis: &Axis, actuator: &Parameters) -> Self {
        let holds = |hold| axis.motion.stretches().iter().any(|stretch| stretch.hold == hold);
        let (hangs, required) = (hangs(axis), holds(Hold::Brake));
        if hangs && holds(Hold::Free) {
            return Self::Free;
        }
        match actuator.brake.holding_torque {
            Datum::NotApplicable if required => Self::Absent,
            Datum::NotApplicable if hangs => Self::Unheld,
            Datum::NotPrinted if hangs && !required => Self::NotPrinted,
            Datum::NotApplicable => Self::Unconcerned,
            Datum::NotPrinted if !required => Self::Unconcerned,
            Datum::NotPrinted | Datum::Known(_) if !axis.mechanism.knows_holding_torque() => Self::LoadNotKnown,
            Datum::NotPrinted | Datum::Known(_) => Self::Braked,
        }
    }
}

/// Missing datum if the torque that holds the load is unknown.
const HOLDING_TORQUE: Missing = Missing { symbol: "mechanism.joint.holding_torque" };

/// Checks the torque that holds the load; `None` if the actuator has no brake and none is required.
pub(crate) fn holding(case: &Case<'_>, work: &mut Workings) -> Option<Outcome> {
    let Case { axis, actuator, .. } = *case;
    Some(match Held::of(axis, actuator) {
        Held::Free => Ok(free(axis, work)),
        Held::Absent => Ok(absent(axis, work)),
        Held::Unheld => Ok(unheld(axis, work)),
        Held::Unconcerned => return None,
        Held::NotPrinted => {
            let mut check = not_checked(CheckId::BrakeHolding, Missing { symbol: "T_Br" });
            check.notes.push(Note::HangingLoad);
            Ok(check)
        }
        Held::LoadNotKnown => Err(HOLDING_TORQUE),
        Held::Braked => held(axis, actuator, &actuator.brake, work),
    })
}

/// Checks the stop by the brake alone; `None` if the actuator has no brake or it is unknown.
pub(crate) fn emergency(case: &Case<'_>, work: &mut Workings) -> Option<Outcome> {
    let Case { axis, actuator, .. } = *case;
    match Held::of(axis, actuator) {
        Held::Free | Held::Absent | Held::Unheld | Held::Unconcerned | Held::NotPrinted => None,
        Held::LoadNotKnown => Some(Err(HOLDING_TORQUE)),
        Held::Braked => Some(stop(axis, actuator, &actuator.brake, work)),
    }
}

/// Compares the friction at the output with the torque that moves the load, which no brake holds.
fn free(axis: &Axis, work: &mut Workings) -> Check {
    let friction = provenance::Sourced {
        value: axis.mechanism.coulomb_torque(),
        source: project("friction_torque"),
        grade: Grade::Computed,
        errata: &[],
    };
    holding_torque(axis, work);
    work.given("T_c", &NEWTON_METRE, &friction);
    work.limit("T_c");
    Comparison {
        notes: Notes::fixed(&[Note::NothingHolds]),
        ..Comparison::with(
            CheckId::BrakeHolding,
            &NEWTON_METRE,
            axis.moments().holding_torque.si(),
            Source::Model { name: "brake" },
            &friction,
        )
    }
    .answer(Verdict::Fail)
}

/// Returns the failed check of a motion that requires a brake which the actuator lacks.
fn absent(axis: &Axis, work: &mut Workings) -> Check {
    Check { notes: Notes::fixed(&[Note::NoBrake]), ..without_brake(Verdict::Fail, project("motion.hold"), axis, work) }
}

/// Returns the check of a load under gravity or tension without a brake: in operation the motor holds it, without power
/// nothing does. The machine has to solve that, so the check is advice.
fn unheld(axis: &Axis, work: &mut Workings) -> Check {
    let notes = Notes::fixed(&[Note::NothingHoldsWithoutPower]);
    Check { notes, ..without_brake(Verdict::Advice, Source::Model { name: "brake" }, axis, work) }
}

/// Compares the torque that holds the load with a brake torque of zero.
fn without_brake(verdict: Verdict, none: Source, axis: &Axis, work: &mut Workings) -> Check {
    holding_torque(axis, work);
    work.figure("T_Br", &NEWTON_METRE, 0.0, &none, Grade::Printed);
    work.limit("T_Br");
    Check {
        verdict,
        value: Some(Amount { si: axis.moments().holding_torque.si(), unit: &NEWTON_METRE }),
        limit: Some(Amount { si: 0.0, unit: &NEWTON_METRE }),
        grade: Some(Grade::Printed),
        value_source: Some(Source::Model { name: "brake" }),
        limit_source: Some(none),
        ..unjudged(CheckId::BrakeHolding)
    }
}

/// Records the largest torque that holds the load, `T_hold`, as the requirement of the axis.
fn holding_torque(axis: &Axis, work: &mut Workings) {
    find_holding_torque(axis, work);
    work.value("T_hold");
}

fn find_holding_torque(axis: &Axis, work: &mut Workings) {
    workings::holding_torque(axis, work);
}

fn hangs(axis: &Axis) -> bool {
    axis.moments().holding_torque.si() > HANGING
}

/// Returns the smallest inertia of the load in the cycle; for a joint only the largest is stated, and zero holds.
fn least_load(axis: &Axis) -> MomentOfInertia {
    let joint = matches!(axis.mechanism.kind, mechanism::MechanismKind::Joint(_));
    if joint { MomentOfInertia::from_si(0.0) } else { axis.trace.inertia().1 }
}

/// Checks T_Br ≥ S times gravity, process and external torque at every instant, without the help of friction: the drive
/// may fail at any time.
fn held(axis: &Axis, actuator: &Parameters, brake: &Brake, work: &mut Workings) -> Outcome {
    let id = CheckId::BrakeHolding;
    let limit = brake.holding_torque.require("T_Br")?;
    let torque = axis.moments().holding_torque;
    let safety = axis.asked.holding_safety.unwrap_or(1.0);
    let model = Source::Model { name: "brake" };
    let mut check =
        Comparison::with(id, &NEWTON_METRE, torque.si() * safety, model.clone(), limit).answer(Verdict::Fail);
    find_holding_torque(axis, work);
    if axis.asked.holding_safety.is_some() {
        work.stated("S", &ONE, safety, "requirements.holding_safety");
        work.formula("T_need", &NEWTON_METRE, torque.si() * safety, "S*T_hold", &model);
        work.value("T_need");
    } else {
        work.value("T_hold");
    }
    work.given("T_Br", &NEWTON_METRE, limit);
    work.limit("T_Br");
    let brakings = brakings(axis);
    let notes = &mut check.notes;
    if hangs(axis) {
        notes.push(Note::HangingLoad);
        if let (Some(own), Some(closing)) = (actuator.inertia_out.known(), brake.closing_time.known()) {
            // The lightest load moves most while the brake closes.
            let inertia = own.value + least_load(axis);
            notes.push(Note::Sag(actuator::sag_angle(inertia, torque, closing.value)));
        }
    }
    if brakings.each_cycle > 0.0 {
        let cycle = axis.moments().duration;
        let lasts = brake.brakings_max.known().map(|most| Time::from_si(most.value / brakings.each_cycle * cycle.si()));
        notes.push(Note::BrakingsLast { each_cycle: brakings.each_cycle, lasts });
        let unknown = brake.closing_time.known().is_none() || brake.opening_time.known().is_none();
        notes.extend((unknown && hangs(axis)).then_some(Note::BrakeTimesAssumed));
    }
    let too_short = brakings.too_short.filter(|_| hangs(axis)).zip(axis.brake_times);
    notes.extend(
        too_short
            .map(|(shortest, times)| Note::DwellTooShortForBrake { shortest, needed: times.closing + times.opening }),
    );
    Ok(check)
}

/// Checks the applications of the brake over the stated service life ≤ N_brakings; `None` if the actuator has no brake or no
/// dwell is held by it.
///
/// N_life = z t_life / t_0
///
/// # Symbols
/// z applications in one cycle, t_life service life \[s\], t_0 cycle time \[s\]
/// # Source
/// docs/theory/brake.md
pub(crate) fn applications(case: &Case<'_>, work: &mut Workings) -> Option<Outcome> {
    let Case { axis, actuator, .. } = *case;
    let life = axis.asked.service_life?;
    let each_cycle = brakings(axis).each_cycle;
    let is_applied = matches!(Held::of(axis, actuator), Held::Braked | Held::LoadNotKnown) && each_cycle > 0.0;
    is_applied.then(|| {
        let limit = actuator.brake.brakings_max.require("N_brakings")?;
        let count = each_cycle * life.si() / axis.moments().duration.si();
        let most = limit.clone().map(quantities::Ratio::from_si);
        explain_applications(axis, (each_cycle, count), work);
        work.given_number("N_brakings", limit);
        work.limit("N_brakings");
        let model = Source::Model { name: "brake" };
        Ok(Comparison::with(CheckId::BrakeApplications, &ONE, count, model, &most).answer(Verdict::Fail))
    })
}

/// Records the derivation of the number of applications over the service life, `N_life`.
fn explain_applications(axis: &Axis, (each_cycle, count): (f64, f64), work: &mut Workings) {
    let Some(life) = axis.asked.service_life else { return };
    let (model, cycle) = (Source::Model { name: "brake" }, axis.moments().duration.si());
    work.found("z", &ONE, each_cycle, Finding::Brakings, &model, Grade::Computed);
    work.stated("t_life", &SECOND, life.si(), "requirements.service_life");
    work.figure("t_0", &SECOND, cycle, &workings::DEMAND, Grade::Computed);
    work.formula("N_life", &ONE, count, "z*t_life/t_0", &model);
    work.value("N_life");
}

/// Checks the stated number of stops by the brake alone ≤ N_emergency; `None` if the actuator has no brake.
pub(crate) fn stops(case: &Case<'_>, work: &mut Workings) -> Option<Outcome> {
    let Case { axis, actuator, .. } = *case;
    let count = axis.asked.emergency_stops?;
    matches!(Held::of(axis, actuator), Held::Braked | Held::LoadNotKnown).then(|| {
        let limit = actuator.brake.emergency_max.require("N_emergency")?;
        let key = "requirements.emergency_stops";
        let most = limit.clone().map(quantities::Ratio::from_si);
        work.stated("N_stops", &ONE, count, key);
        work.value("N_stops");
        work.given_number("N_emergency", limit);
        work.limit("N_emergency");
        Ok(Comparison::with(CheckId::BrakeStops, &ONE, count, project(key), &most).answer(Verdict::Fail))
    })
}

/// Checks the angle of a stop from the peak speed by the brake alone, under a driving load.
fn stop(axis: &Axis, actuator: &Parameters, brake: &Brake, work: &mut Workings) -> Outcome {
    let id = CheckId::BrakeEmergency;
    let holding = brake.holding_torque.require("T_Br")?;
    let torque = holding.value;
    let closing = brake.closing_time.require("t_c")?.value;
    let stated = !matches!(axis.mechanism.kind, mechanism::MechanismKind::Joint(_));
    if !stated && axis.moments().inertia_max.si() <= 0.0 {
        return Err(Missing { symbol: "J_L" });
    }
    let own = actuator.inertia_out.require("J_out")?.value;
    let source = Source::Model { name: "brake" };
    let driving = axis.moments().holding_torque;
    let permitted = brake.emergency_max.known();
    // The heaviest load has the most energy, the lightest gathers the most speed until the brake has closed: angle and
    // energy are convex in J, so that one of the two is the worst.
    let loads = [axis.moments().inertia_max, least_load(axis)];
    let [heaviest, lightest] =
        loads.map(|load| actuator::emergency_stop(own + load, axis.moments().speed_peak, torque, driving, closing));
    let (stop, load) = match (heaviest, lightest) {
        (StopOutcome::Stops(heaviest), StopOutcome::Stops(lightest)) => {
            let by_lightest = lightest.angle > heaviest.angle;
            let energy = if lightest.energy > heaviest.energy { lightest.energy } else { heaviest.energy };
            let time = if lightest.time > heaviest.time { lightest.time } else { heaviest.time };
            let angle = if by_lightest { lightest.angle } else { heaviest.angle };
            let load = if by_lightest { (loads[1], Extreme::Least) } else { (loads[0], Extreme::Largest) };
            (BrakeStop { angle, time, energy, permitted: permitted.map(|permitted| permitted.value) }, load)
        }
        (StopOutcome::DoesNotStop, _) | (_, StopOutcome::DoesNotStop) => {
            holding_torque(axis, work);
            work.given("T_Br", &NEWTON_METRE, holding);
            work.limit("T_Br");
            return Ok(Check {
                verdict: Verdict::Fail,
                value: Some(Amount { si: driving.si(), unit: &NEWTON_METRE }),
                limit: Some(Amount { si: torque.si(), unit: &NEWTON_METRE }),
                utilisation: Some(driving.si() / torque.si()),
                grade: Some(Grade::Computed),
                value_source: Some(source),
                limit_source: Some(holding.source.clone()),
                notes: Notes::fixed(&[Note::BrakeDoesNotStop]),
                ..unjudged(id)
            });
        }
    };
    let angle = axis.asked.stop_angle_max.map(Measure::si);
    let mut check = against_asked(id, &DEGREE, stop.angle.si(), angle, source);
    if work.is_on() {
        stop_angle(axis, (actuator, brake), load, stop.angle.si(), work);
        work.asked("phi_perm", &DEGREE, angle, id);
    }
    check.notes.push(Note::BrakeStop(Box::new(stop)));
    Ok(check)
}

/// Records the derivation of the angle of a stop by the brake alone, `phi_stop`, with the inertia of the load that is the worst.
fn stop_angle(
    axis: &Axis,
    (actuator, brake): (&Parameters, &Brake),
    (load, which): (MomentOfInertia, Extreme),
    angle: f64,
    work: &mut Workings,
) {
    let (Some(torque), Some(closing)) = (brake.holding_torque.known(), brake.closing_time.known()) else { return };
    let source = Source::Model { name: "brake" };
    let moments = axis.moments();
    workings::own_inertia(actuator, work);
    workings::load_inertia(axis, ("J_L", which), load.si(), work);
    let speed = moments.speed_peak.si();
    work.found("n_peak", &REVOLUTION_PER_MINUTE, speed, Finding::PeakSpeed, &source, Grade::Computed);
    workings::holding_torque(axis, work);
    work.formula("T_d", &NEWTON_METRE, moments.holding_torque.si(), "T_hold", &source);
    work.given("T_Br", &NEWTON_METRE, torque);
    work.given("t_c", &SECOND, closing);
    let own = actuator.inertia_out.known().map_or(0.0, |own| own.value.si());
    let inertia = own + load.si();
    work.formula("J", &KILOGRAM_SQUARE_METRE, inertia, "J_out + J_L", &source);
    let speed = moments.speed_peak.si() + moments.holding_torque.si() / inertia * closing.value.si();
    work.formula("omega_1", &RADIAN_PER_SECOND, speed, "n_peak*2*pi/60 + T_d/J*t_c", &source);
    let text = "180/pi*(n_peak*2*pi/60*t_c + T_d/(2*J)*t_c^2 + J*omega_1^2/(2*(T_Br - T_d)))";
    work.formula("phi_stop", &DEGREE, angle, text, &source);
    work.value("phi_stop");
}
