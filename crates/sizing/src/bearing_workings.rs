//! Derivations of the loads on the flange, stated and of the mechanism.

use crate::axis::BearingDuty;
use crate::bearing_checks::{Borne, DERIVED, MODEL, Names};
use crate::comparison::{Asking, project};
use crate::flange::{Peak, Peaks, States};
use crate::workings;
use actuator::FlangeLoad;
use derivation::{Finding, Workings};
use mechanism::{At, FlangeLoadKind};
use provenance::{Grade, Sourced};
use quantities::unit::{METRE, NEWTON, NEWTON_METRE};
use quantities::{Length, Measure, Unit};

/// Returns `true` if every segment has the same loads.
pub(crate) fn is_constant(duty: &BearingDuty) -> bool {
    duty.loads.windows(2).all(|pair| matches!(pair, [a, b] if a == b))
}

/// Records the derivation of the largest force.
pub(crate) fn largest_force(borne: &Borne<'_>, (symbol, what, key): Names, peak: Peak, work: &mut Workings) {
    if !work.is_on() {
        return;
    }
    if borne.duty.derived.is_some() {
        let kind = if symbol == "F_a" { FlangeLoadKind::Axial } else { FlangeLoadKind::Radial };
        of_mechanism(borne, kind, peak, Finding::LargestInMotion, work);
    } else {
        stated(is_constant(borne.duty), (symbol, &NEWTON, peak.value(), key), what, work);
    }
    work.value(symbol);
}

/// Records the derivation of a largest load of the mechanism, `F_r`, `F_a` or `M`, at its instant; `what` where the motion
/// does not reach it by its states there.
pub(crate) fn of_mechanism(borne: &Borne<'_>, kind: FlangeLoadKind, peak: Peak, what: Finding, work: &mut Workings) {
    let (symbol, unit) = match kind {
        FlangeLoadKind::Radial => ("F_r", &NEWTON),
        FlangeLoadKind::Axial => ("F_a", &NEWTON),
        FlangeLoadKind::Moment => ("M", &NEWTON_METRE),
    };
    if !work.is_on() {
        return;
    }
    let Some((at, derived)) = state_of_peak(borne, kind, peak).zip(borne.duty.derived.as_ref()) else {
        work.found(symbol, unit, peak.value(), what, &DERIVED, Grade::Computed);
        return;
    };
    let offset = borne.bearing.offset.known();
    let acts = derived.acts.get(at.segment).copied().unwrap_or(false);
    let [radial, axial, moment] =
        stated_in(borne.duty, at.segment, offset.map_or_else(|| Length::from_si(0.0), |offset| offset.value));
    let own = acts.then(|| borne.axis.mechanism.explain_flange(kind, &at, (&derived.mounting, offset), work));
    let load = borne.duty.loads.get(at.segment);
    let part = match kind {
        FlangeLoadKind::Radial => radial,
        FlangeLoadKind::Axial => axial,
        FlangeLoadKind::Moment => moment,
    };
    let Some(load) = load.filter(|_| part != 0.0) else {
        // Without a load of the segment nothing acts on the flange.
        work.formula(symbol, unit, peak.value(), own.unwrap_or_else(|| "0".to_owned()), &DERIVED);
        return;
    };
    let of_mechanism = if kind == FlangeLoadKind::Moment { "M_m" } else { "F_m" };
    let is_sum = own.is_some();
    if let Some(text) = own {
        work.formula(of_mechanism, unit, peak.value() - part, text, &DERIVED);
    }
    let text = match (kind, is_sum) {
        (FlangeLoadKind::Radial, true) => "F_m + F_rs",
        (FlangeLoadKind::Radial, false) => "F_rs",
        (FlangeLoadKind::Axial, true) => "F_m + F_as",
        (FlangeLoadKind::Axial, false) => "F_as",
        (FlangeLoadKind::Moment, true) => "M_m + M_s",
        (FlangeLoadKind::Moment, false) => "M_s",
    };
    if kind != FlangeLoadKind::Axial {
        work.stated("F_rs", &NEWTON, load.radial_force.si(), "bearing.radial_force");
    }
    if kind != FlangeLoadKind::Radial {
        work.stated("F_as", &NEWTON, load.axial_force.si(), "bearing.axial_force");
    }
    if kind == FlangeLoadKind::Moment {
        if let Some(offset) = offset {
            work.given("R", &METRE, offset);
        }
        work.stated("L_r", &METRE, load.radial_distance.si(), "bearing.radial_distance");
        work.stated("L_a", &METRE, load.axial_distance.si(), "bearing.axial_distance");
        work.formula("M_s", &NEWTON_METRE, moment, "F_rs*(L_r + R) + F_as*L_a", &MODEL);
    }
    work.formula(symbol, unit, peak.value(), text, &DERIVED);
}

/// Returns F_r, F_a and M that the project states for a segment.
fn stated_in(duty: &BearingDuty, segment: usize, offset: Length) -> [f64; 3] {
    duty.loads.get(segment).map_or([0.0; 3], |load| {
        [load.radial_force.si(), load.axial_force.si(), actuator::tilting_moment(load, offset).si()]
    })
}

/// Returns the state of the motion at a peak; `None` if no state at its instant has this load.
fn state_of_peak(borne: &Borne<'_>, kind: FlangeLoadKind, peak: Peak) -> Option<At> {
    let (axis, derived) = (borne.axis, borne.duty.derived.as_ref()?);
    let offset = borne.bearing.offset.known().map_or_else(|| Length::from_si(0.0), |offset| offset.value);
    let load = |at: &At| {
        let forces = if derived.acts.get(at.segment).copied().unwrap_or(false) {
            axis.mechanism.flange_forces(&at.output, &at.extra, at.recorded_nm, &derived.mounting)
        } else {
            mechanism::FlangeForces::default()
        };
        let [radial, axial, moment] = stated_in(borne.duty, at.segment, offset);
        match kind {
            FlangeLoadKind::Radial => forces.radial() + radial,
            FlangeLoadKind::Axial => forces.axial() + axial,
            FlangeLoadKind::Moment => forces.moment(offset) + moment,
        }
    };
    let mut found = workings::states_at(axis, peak.at(), &[1.0, -1.0, 0.0]).map(|moving| moving.at(axis));
    found.find(|at| (load(at) - peak.value()).abs() <= 1e-9 * peak.value().abs())
}

/// Records the value of the user, from the segment that `what` names if there are several.
fn stated(
    constant: bool,
    (symbol, unit, value, key): (&'static str, &'static Unit, f64, &'static str),
    what: Finding,
    work: &mut Workings,
) {
    if constant {
        work.stated(symbol, unit, value, key);
    } else {
        work.found(symbol, unit, value, what, &project(key), Grade::Printed);
    }
}

/// Records the derivation of the tilting moment under one load, `M`: the values of the user, from the segment that
/// `what` names if there are several.
pub(crate) fn load_moment(
    duty: &BearingDuty,
    load: &FlangeLoad,
    offset: &Sourced<Length>,
    what: Finding,
    work: &mut Workings,
) {
    let constant = is_constant(duty);
    for given in [
        ("F_r", &NEWTON, load.radial_force.si(), "bearing.radial_force"),
        ("L_r", &METRE, load.radial_distance.si(), "bearing.radial_distance"),
        ("F_a", &NEWTON, load.axial_force.si(), "bearing.axial_force"),
        ("L_a", &METRE, load.axial_distance.si(), "bearing.axial_distance"),
    ] {
        stated(constant, given, what, work);
    }
    work.given("R", &METRE, offset);
    let moment = actuator::tilting_moment(load, offset.value).si();
    work.formula("M", &NEWTON_METRE, moment, "F_r*(L_r + R) + F_a*L_a", &MODEL);
}

/// Records the derivation of the largest tilting moment, `M`.
pub(crate) fn explain_largest_moment(borne: &Borne<'_>, work: &mut Workings) {
    let (duty, bearing) = (borne.duty, borne.bearing);
    let Some(offset) = bearing.offset.known().filter(|_| work.is_on()) else { return };
    if duty.derived.is_some() {
        let moment = borne.loads().whole().moment;
        of_mechanism(borne, FlangeLoadKind::Moment, moment, Finding::LargestOfMechanism, work);
        return;
    }
    explain_stated_moment(borne, offset, |_| true, work);
}

/// Records the derivation of the largest tilting moment of stated loads over the segments in a state of the gear, `M`.
pub(crate) fn explain_stated_moment(
    borne: &Borne<'_>,
    offset: &Sourced<Length>,
    counts: fn(&States) -> bool,
    work: &mut Workings,
) {
    let duty = borne.duty;
    let moment = |load: &FlangeLoad| actuator::tilting_moment(load, offset.value).si();
    let loads = duty.loads.iter().zip(borne.axis.gear_states()).filter(|(_, states)| counts(states));
    let largest = loads.map(|(load, _)| load).max_by(|a, b| moment(a).total_cmp(&moment(b)));
    if let Some(load) = largest {
        load_moment(duty, load, offset, Finding::SegmentOfLargestMoment, work);
    }
}

/// Records the derivation of largest loads, each by itself: `F_r`, `F_a` and `M`; of stated loads those of the segments in a
/// state of the gear.
pub(crate) fn explain_peaks(
    borne: &Borne<'_>,
    largest: &Peaks,
    (what, counts): (Finding, fn(&States) -> bool),
    work: &mut Workings,
) {
    let (duty, bearing) = (borne.duty, borne.bearing);
    if duty.derived.is_some() {
        of_mechanism(borne, FlangeLoadKind::Radial, largest.radial, what, work);
        of_mechanism(borne, FlangeLoadKind::Axial, largest.axial, what, work);
        of_mechanism(borne, FlangeLoadKind::Moment, largest.moment, what, work);
        return;
    }
    if let Some(offset) = bearing.offset.known() {
        explain_stated_moment(borne, offset, counts, work);
    }
    let constant = is_constant(duty);
    for (symbol, peak, key) in
        [("F_r", largest.radial, "bearing.radial_force"), ("F_a", largest.axial, "bearing.axial_force")]
    {
        stated(constant, (symbol, &NEWTON, peak.value(), key), what, work);
    }
}
