//! Checks of oscillation: first natural frequency of the load on the gear, and the speeds that excite it.

use crate::axis::Axis;
use crate::check::{Amount, Check, CheckId, Verdict};
use crate::comparison::{Asking, against_asked, unjudged};
use crate::list::{Case, Outcome};
use crate::notes::{Note, Notes, ResonanceSpeeds};
use crate::stage;
use crate::workings::{self, Extreme};
use actuator::Parameters;
use derivation::{Finding, Workings};
use mechanism::Extra;
use numeric::{First, at_least};
use provenance::{Grade, Missing, Source, Sourced};
use quantities::unit::{HERTZ, PERCENT, REVOLUTION_PER_MINUTE, SECOND};
use quantities::{AngularVelocity, Frequency, Measure, MomentOfInertia, Time, TorsionalStiffness};

const MODEL: Source = Source::Model { name: "gear" };

/// A speed that the cycle holds, with the inertia of the load at that time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Held {
    /// Instant from which it is held \[s\].
    start: f64,
    /// |ω| [rad/s]
    speed: f64,
    /// Least and largest J_L \[kgm²\].
    inertia: (f64, f64),
    /// Index of the segment, with the positions at its ends \[rad\].
    place: (usize, (f64, f64)),
}

/// Returns the speeds that the cycle holds, each with the inertia of its own payload and positions; a speed held
/// several times is listed once, at its first instant.
pub(crate) fn held_speeds(axis: &Axis) -> Vec<Held> {
    let mut held = each_held_speed(axis);
    let key = |held: &Held| [held.speed, held.inertia.0, held.inertia.1].map(f64::to_bits);
    let mut seen = std::collections::BTreeSet::new();
    held.retain(|held| seen.insert(key(held)));
    held
}

fn each_held_speed(axis: &Axis) -> Vec<Held> {
    let none = Extra::none();
    let held = axis.motion.pieces().iter().filter(|piece| piece.speed_degree() == Some(0) && !piece.is_rest());
    held.map(|piece| {
        let extra = axis.extras.get(piece.segment).unwrap_or(&none);
        let (from, to) = (piece.position_rad, piece.end().position_rad);
        let found = axis.mechanism.extremes(from, to, extra);
        let range = (found.inertia_least.si(), found.inertia_largest.si());
        Held {
            start: piece.start_s,
            speed: piece.speed_rad_s.abs(),
            inertia: range,
            place: (piece.segment, (from, to)),
        }
    })
    .collect()
}

/// Behaviour of the rotor while the load swings.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Rotor {
    /// Held by a stiff position loop: the load swings alone.
    Blocked,
    /// Swings against the load, with this inertia \[kgm²\].
    Free(f64),
}

fn frequency(stiffness: TorsionalStiffness, load: f64, rotor: Rotor) -> Frequency {
    let load = MomentOfInertia::from_si(load);
    match rotor {
        Rotor::Blocked => actuator::natural_frequency(stiffness, load),
        Rotor::Free(own) => actuator::natural_frequency_free(stiffness, load, MomentOfInertia::from_si(own)),
    }
}

/// Compares the first natural frequency of the load on the softest region of the gear with the required minimum.
pub(crate) fn natural_frequency(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let Case { axis, actuator, .. } = *case;
    let id = CheckId::NaturalFrequency;
    let [softest, _, _] = &actuator.gear.stiffness;
    let gear = softest.require("K_1")?;
    let load = axis.moments().inertia_max.si();
    if load <= 0.0 {
        return Err(Missing { symbol: "J_L" });
    }
    let k = stage::in_series(&axis.mechanism, gear);
    let blocked = frequency(k.value, load, Rotor::Blocked);
    let asked = axis.asked.natural_frequency_min.map(Measure::si);
    stage::explain_series(&axis.mechanism, "K_1", gear, work);
    workings::load_inertia(axis, ("J_L", Extreme::Largest), load, work);
    work.formula("f", &HERTZ, blocked.si(), "sqrt(K_1/J_L)/(2*pi)", &MODEL);
    work.value("f");
    work.asked("f_min", &HERTZ, asked, id);
    let mut check = against_asked(id, &HERTZ, blocked.si(), asked, MODEL);
    if let Some(own) = own_inertia(actuator) {
        check.notes.push(Note::FreeRotor(frequency(k.value, load, Rotor::Free(own))));
    }
    Ok(check)
}

/// Returns J_out if it is known and not zero.
fn own_inertia(actuator: &Parameters) -> Option<f64> {
    actuator.inertia_out.known().map(|own| own.value.si()).filter(|own| *own > 0.0)
}

/// Half width of the band around a resonance speed in which no speed should be held, as a share of that speed. Assumed;
/// the model has no damping and no amplitudes.
const RESONANCE_BAND: f64 = 0.1;

/// A region of stiffness with the rotor blocked or free, and its resonance speeds for one range of J_L.
#[derive(Clone, Copy)]
struct Line {
    region: usize,
    rotor: Rotor,
    /// Lowest speed, of the largest J_L, and highest, of the least [rad/s].
    speeds: (f64, f64),
}

impl Line {
    /// Returns the distance of a speed from the range, relative to its nearer end.
    fn distance(&self, speed: f64) -> f64 {
        (1.0 - speed / self.speeds.0).max(speed / self.speeds.1 - 1.0).max(0.0)
    }
}

/// Returns the resonances of a range of J_L in the three regions.
fn lines(
    stiffness: &[&Sourced<TorsionalStiffness>; 3],
    ratio: f64,
    rotor: Rotor,
    (least, largest): (f64, f64),
) -> [Line; 3] {
    let [k1, k2, k3] = stiffness;
    [(0, k1), (1, k2), (2, k3)].map(|(region, k)| {
        let speed = |load| actuator::resonance_speed(frequency(k.value, load, rotor), ratio).si();
        Line { region, rotor, speeds: (speed(largest), speed(least)) }
    })
}

/// Checks the distance of the held speeds from those at which the wave generator excites the load (2 i n/60 = f on each
/// region of stiffness, with blocked and with free rotor), relative to the latter, each with the inertia of the load at
/// that time. Holding such a speed is against advice; passing it is not.
pub(crate) fn resonance(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let Case { axis, actuator, .. } = *case;
    let id = CheckId::ResonanceSpeed;
    let ratio = actuator.ratio.require("i")?;
    let [k1, k2, k3] = &actuator.gear.stiffness;
    let stiffness = [k1.require("K_1")?, k2.require("K_2")?, k3.require("K_3")?];
    if axis.moments().inertia_max.si() <= 0.0 {
        return Err(Missing { symbol: "J_L" });
    }
    let stiffness = stiffness.map(|k| stage::in_series(&axis.mechanism, k));
    let stiffness = stiffness.each_ref().map(|k| &**k);
    let own = own_inertia(actuator);
    let of = |held: &Held| {
        let rotors = [Some(Rotor::Blocked), own.map(Rotor::Free)].into_iter().flatten();
        let each = rotors.flat_map(|rotor| lines(&stiffness, ratio.value, rotor, held.inertia));
        each.map(|line| (line.distance(held.speed), line)).min_by(|a, b| a.0.total_cmp(&b.0))
    };
    let held = axis.held_speeds().iter().filter(|held| held.inertia.1 > 0.0);
    let mut nearest = First::above(f64::NEG_INFINITY, None);
    for (found, held) in held.filter_map(|held| Some((of(held)?, held))) {
        nearest.see(-found.0, held.start, Some((found, held)));
    }
    let nearest = nearest.place();
    let value = nearest.as_ref().map_or(f64::INFINITY, |((distance, _), _)| *distance);
    // Without a held speed there is no distance to state.
    let is_held = nearest.is_some();
    if work.is_on() {
        explain_resonance((axis, actuator), ratio, nearest.map(|((_, line), held)| (line, held)), value, work);
    }
    // The constant speeds of a recording are unknown.
    let is_apart = at_least(value, RESONANCE_BAND);
    let open = is_apart && !axis.motion.recordings().is_empty();
    let verdict = match is_apart {
        _ if open => Verdict::NotChecked,
        true => Verdict::Pass,
        false => Verdict::Advice,
    };
    let speeds = speeds_note(axis, &stiffness, ratio.value, own);
    let notes: Notes = if is_held || open { speeds.into() } else { [Note::NoSpeedHeld, speeds].into() };
    Ok(Check {
        verdict,
        // What lies apart of the speeds that are known says nothing about those of a recording.
        value: (is_held && !open).then_some(Amount { si: value, unit: &PERCENT }),
        limit: (!open).then_some(Amount { si: RESONANCE_BAND, unit: &PERCENT }),
        utilisation: (is_held && value > 0.0 && !open).then(|| RESONANCE_BAND / value),
        at: nearest.filter(|_| !open).map(|(_, held)| Time::from_si(held.start)),
        grade: Some(Grade::Assumed),
        value_source: is_held.then_some(MODEL),
        limit_source: Some(MODEL),
        missing: open.then_some("recorded_speed"),
        notes,
        ..unjudged(id)
    })
}

/// Returns the remark on the resonance speeds over every inertia of the cycle.
fn speeds_note(axis: &Axis, stiffness: &[&Sourced<TorsionalStiffness>; 3], ratio: f64, own: Option<f64>) -> Note {
    let (largest, least) = axis.trace.inertia();
    let (largest, least) = (largest.si(), least.si());
    // Without inertia there is no resonance; that of a joint is stated once for all positions.
    let least = if least.is_finite() && least > 0.0 { least.min(largest) } else { largest };
    let speeds = |rotor| {
        lines(stiffness, ratio, rotor, (least, largest))
            .map(|line| (AngularVelocity::from_si(line.speeds.0), AngularVelocity::from_si(line.speeds.1)))
    };
    let free = own.map(|own| speeds(Rotor::Free(own)));
    Note::ResonanceSpeeds(Box::new(ResonanceSpeeds { blocked: speeds(Rotor::Blocked), free }))
}

/// Records the derivation of the distance `d` from the resonance of a region that is nearest to a held speed.
fn explain_resonance(
    (axis, actuator): (&Axis, &Parameters),
    ratio: &Sourced<f64>,
    nearest: Option<(Line, &Held)>,
    value: f64,
    work: &mut Workings,
) {
    if let Some((line, held)) = nearest {
        let [first, second, third] = &FORMULAS;
        let formulas = [first, second, third].into_iter().nth(line.region).unwrap_or(third);
        let (k, [blocked, free], [blocked_least, free_least]) = *formulas;
        let (least, largest) = held.inertia;
        let demand = &workings::DEMAND;
        if let Some(gear) = actuator.gear.stiffness.get(line.region).and_then(|gear| gear.known()) {
            stage::explain_series(&axis.mechanism, k, gear, work);
        }
        work.given_number("i", ratio);
        let is_free = line.rotor != Rotor::Blocked;
        if is_free {
            workings::own_inertia(actuator, work);
        }
        let hertz = |speed: f64| speed * ratio.value / std::f64::consts::PI;
        work.figure("t", &SECOND, held.start, demand, Grade::Computed);
        Extreme::Largest.explain(axis, "J_L", held.place, work);
        let text = if is_free { free } else { blocked };
        work.formula("f", &HERTZ, hertz(line.speeds.0), text, &MODEL);
        work.formula("n_r", &REVOLUTION_PER_MINUTE, line.speeds.0, "60*f/(2*i)", &MODEL);
        let mut distance = "100*max(1 - n/n_r, 0)";
        if line.speeds.1.is_finite() && least != largest {
            Extreme::Least.explain(axis, "J_L_min", held.place, work);
            let text = if is_free { free_least } else { blocked_least };
            work.formula("f_high", &HERTZ, hertz(line.speeds.1), text, &MODEL);
            work.formula("n_r_high", &REVOLUTION_PER_MINUTE, line.speeds.1, "60*f_high/(2*i)", &MODEL);
            distance = "100*max(1 - n/n_r, n/n_r_high - 1, 0)";
        } else if line.speeds.1.is_finite() {
            distance = "100*abs(n/n_r - 1)";
        }
        let what = Finding::SpeedNearResonance;
        work.found("n", &REVOLUTION_PER_MINUTE, held.speed, what, demand, Grade::Computed);
        work.formula("d", &PERCENT, value, distance, &MODEL);
        work.value("d");
    }
    work.figure("d_min", &PERCENT, RESONANCE_BAND, &MODEL, Grade::Assumed);
    work.limit("d_min");
}

/// Symbol of a region, and the formulas of the frequency with blocked and free rotor, for the largest and for the least
/// J_L.
type Formulas = (&'static str, [&'static str; 2], [&'static str; 2]);

const FORMULAS: [Formulas; 3] = [
    (
        "K_1",
        ["sqrt(K_1/J_L)/(2*pi)", "sqrt(K_1*(J_L + J_out)/(J_L*J_out))/(2*pi)"],
        ["sqrt(K_1/J_L_min)/(2*pi)", "sqrt(K_1*(J_L_min + J_out)/(J_L_min*J_out))/(2*pi)"],
    ),
    (
        "K_2",
        ["sqrt(K_2/J_L)/(2*pi)", "sqrt(K_2*(J_L + J_out)/(J_L*J_out))/(2*pi)"],
        ["sqrt(K_2/J_L_min)/(2*pi)", "sqrt(K_2*(J_L_min + J_out)/(J_L_min*J_out))/(2*pi)"],
    ),
    (
        "K_3",
        ["sqrt(K_3/J_L)/(2*pi)", "sqrt(K_3*(J_L + J_out)/(J_L*J_out))/(2*pi)"],
        ["sqrt(K_3/J_L_min)/(2*pi)", "sqrt(K_3*(J_L_min + J_out)/(J_L_min*J_out))/(2*pi)"],
    ),
];

#[cfg(test)]
#[path = "resonance_tests.rs"]
mod tests;
