//! Checks of the output bearing.

use crate::axis::{Axis, BearingDuty};
use crate::bearing_workings::{
    explain_largest_moment, explain_peaks, explain_stated_moment, is_constant, largest_force, load_moment, of_mechanism,
};
use crate::check::{Amount, Check, CheckId, Verdict};
use crate::comparison::{Asking, Comparison, against_asked, equation, not_checked, project, unjudged};
use crate::flange::{CycleLoads, Geometry, Peak, Peaks, with_equivalent};
use crate::list::Outcome;
use crate::notes::{Note, Notes};
use crate::swings::SmallSwings;
use crate::workings;
use actuator::{BearingType, FlangeLoad, OutputBearing};
use derivation::{Finding, Workings};
use mechanism::FlangeLoadKind;
use provenance::{CellRef, Datum, Grade, Missing, Source, Sourced};
use quantities::unit::{ARCMINUTE, HOUR, METRE, NEWTON, NEWTON_METRE, NEWTON_METRE_PER_ARCMINUTE, ONE};
use quantities::{Angle, Force, Length, Measure, Time, Torque};
use std::cell::OnceCell;

/// Model of tilting moment, life, safety and tilt.
pub(crate) const MODEL: Source = Source::Model { name: "output-bearing" };

/// Model of the loads that follow from the mechanism.
pub(crate) const DERIVED: Source = Source::Model { name: "flange-loads" };

/// Checks F_a ≤ F_A,dyn(max) alone, while the gear turns (table 55.1, footnote 4).
pub(crate) fn axial(borne: &Borne<'_>, work: &mut Workings) -> Outcome {
    let limit = borne.bearing.axial_max.require("F_A_dyn_max")?;
    let names = ("F_a", Finding::AxialForceMax, "bearing.axial_force");
    force(CheckId::BearingAxial, borne, (names, |loads| loads.turning.axial), ("F_A_dyn_max", limit), work)
}

/// Checks F_r ≤ F_R,dyn(max) alone, while the gear turns (table 55.1, footnote 4).
pub(crate) fn radial(borne: &Borne<'_>, work: &mut Workings) -> Outcome {
    let limit = borne.bearing.radial_max.require("F_R_dyn_max")?;
    let names = ("F_r", Finding::RadialForceMax, "bearing.radial_force");
    force(CheckId::BearingRadial, borne, (names, |loads| loads.turning.radial), ("F_R_dyn_max", limit), work)
}

/// A bearing with its loads, shared by four checks.
pub(crate) struct Borne<'a> {
    pub(crate) axis: &'a Axis,
    pub(crate) duty: &'a BearingDuty,
    pub(crate) bearing: &'a OutputBearing,
    loads: OnceCell<CycleLoads>,
}

impl<'a> Borne<'a> {
    pub(crate) const fn of(axis: &'a Axis, duty: &'a BearingDuty, bearing: &'a OutputBearing) -> Self {
        Self { axis, duty, bearing, loads: OnceCell::new() }
    }

    /// Returns the loads over the cycle, computed on first use.
    pub(crate) fn loads(&self) -> &CycleLoads {
        self.loads.get_or_init(|| cycle_loads(self.axis, self.duty, self.bearing))
    }

    /// Returns the largest tilting moment of the cycle, including rest.
    pub(crate) fn largest_moment(&self) -> Result<Peak, Missing> {
        Ok(self.known_moments()?.whole().moment)
    }

    /// Returns the loads if the tilting moment is known.
    fn known_moments(&self) -> Result<&CycleLoads, Missing> {
        self.bearing.offset.require("R")?;
        self.duty.moment_known(self.axis)?;
        Ok(self.loads())
    }
}

/// Returns F_r, F_a and M: the largest loads on the flange over the whole cycle, including rest; `None` if they are
/// unknown.
#[must_use]
pub fn largest_loads(axis: &Axis, bearing: &OutputBearing) -> Option<(Force, Force, Torque)> {
    let borne = Borne::of(axis, axis.bearing.as_ref()?, bearing);
    let Peaks { radial, axial, moment, .. } = borne.known_moments().ok()?.whole();
    Some((Force::from_si(radial.value()), Force::from_si(axial.value()), Torque::from_si(moment.value())))
}

impl Geometry {
    /// Returns the geometry of a bearing; a datum that is not stated enters no check.
    fn of(bearing: &OutputBearing) -> Self {
        let known = |length: &Datum<Length>| length.known().map_or_else(|| Length::from_si(0.0), |length| length.value);
        let exponent = bearing.kind.known().map_or(3.0, |kind| kind.value.life_exponent());
        Self { offset: known(&bearing.offset), pitch: known(&bearing.pitch_diameter), exponent }
    }
}

/// Computes the loads over the cycle; averages only if loads follow from the mechanism.
fn cycle_loads(axis: &Axis, duty: &BearingDuty, bearing: &OutputBearing) -> CycleLoads {
    let geometry = Geometry::of(bearing);
    let stated = || {
        let mut found = CycleLoads::default();
        for ((load, stretch), states) in duty.loads.iter().zip(axis.motion.stretches()).zip(axis.gear_states()) {
            let moment = actuator::tilting_moment(load, geometry.offset).si();
            let forces = [load.radial_force.si(), load.axial_force.si(), moment];
            let values = with_equivalent(forces, geometry.pitch);
            if states.turns {
                found.turning.see(values, stretch.start.si());
            }
            if states.rests {
                found.resting.see(values, stretch.start.si());
            }
        }
        found
    };
    axis.derived_loads(&geometry).unwrap_or_else(|| axis.stated_loads(&geometry, stated))
}

/// Returns the instant of a peak if loads change within a segment.
fn instant(duty: &BearingDuty, peak: Peak) -> Option<Time> {
    duty.derived.as_ref().map(|_| Time::from_si(peak.at()))
}

/// Symbol, largest over the segments, and key of a force that the user states.
pub(crate) type Names = (&'static str, Finding, &'static str);

/// Compares a force on the flange with the permissible one.
fn force<Q: Measure>(
    id: CheckId,
    borne: &Borne<'_>,
    (names, of): (Names, fn(&CycleLoads) -> Peak),
    (symbol, limit): (&'static str, &Sourced<Q>),
    work: &mut Workings,
) -> Outcome {
    let (axis, duty) = (borne.axis, borne.duty);
    if !duty.has_loads {
        return Err(Missing { symbol: names.2 });
    }
    duty.forces_known(axis)?;
    let peak = of(borne.loads());
    let source = if duty.derived.is_some() { DERIVED } else { project(names.2) };
    largest_force(borne, names, peak, work);
    work.given(symbol, &NEWTON, limit);
    work.limit(symbol);
    Ok(Comparison {
        at: instant(duty, peak),
        notes: Notes::fixed(&[Note::LoadsOneAtATime]),
        ..Comparison::with(id, &NEWTON, peak.value(), source, limit)
    }
    .answer(Verdict::Fail))
}

/// Averages of eq. 75.2 and 75.3 over the cycle.
struct MeanLoad {
    /// F_rav and F_aav; without distances.
    load: FlangeLoad,
    /// M_av: average of the tilting moment.
    moment: Torque,
}

impl MeanLoad {
    /// Averages F_r, F_a and M, each as eq. 75.2 averages F_r.
    ///
    /// M_av = (Σ |n_k| t_k M_k^B / Σ |n_k| t_k)^(1/B), M_k = F_rk (L_rk + R) + F_ak L_ak
    ///
    /// # Symbols
    /// n_k speed [1/min], t_k duration \[s\], M_k tilting moment of a segment about the bearing's centre \[Nm\], B life
    /// exponent \[1\]
    /// # Source
    /// cha-manual eq. 75.2, applied to M: the manual averages forces only (docs/theory/output-bearing.md)
    /// # Valid
    /// loads of the mechanism: the integral over the instants instead of the sum over the segments
    fn of(axis: &Axis, duty: &BearingDuty, bearing: &Geometry) -> Self {
        let Geometry { offset, exponent, .. } = *bearing;
        let without_distances = |radial: f64, axial: f64| FlangeLoad {
            radial_force: Force::from_si(radial),
            radial_distance: Length::from_si(0.0),
            axial_force: Force::from_si(axial),
            axial_distance: Length::from_si(0.0),
        };
        if let Some(found) = axis.derived_loads(bearing) {
            let [radial, axial] = found.means;
            return Self { load: without_distances(radial, axial), moment: Torque::from_si(found.mean_moment) };
        }
        // Consecutive segments often have the same loads.
        let mut parts: Vec<(&FlangeLoad, f64)> = Vec::new();
        for (load, share) in duty.loads.iter().zip(axis.trace.shares()) {
            match parts.last_mut().filter(|(last, _)| *last == load) {
                Some((_, travelled)) => *travelled += share.travelled.si(),
                None => parts.push((load, share.travelled.si())),
            }
        }
        let (radial, axial) = (|load: &FlangeLoad| load.radial_force.si(), |load: &FlangeLoad| load.axial_force.si());
        let moment = |load: &FlangeLoad| actuator::tilting_moment(load, offset).si();
        if let [(load, travelled)] = parts.as_slice()
            && *travelled != 0.0
        {
            // The mean of one load is that load.
            let load: &FlangeLoad = load;
            return Self { load: without_distances(radial(load), axial(load)), moment: Torque::from_si(moment(load)) };
        }
        let mean = |value: &dyn Fn(&FlangeLoad) -> f64| {
            let parts = parts.iter().map(|(load, travelled)| (value(load), Angle::from_si(*travelled)));
            actuator::mean_load(parts, exponent)
        };
        Self { load: without_distances(mean(&radial), mean(&axial)), moment: Torque::from_si(mean(&moment)) }
    }
}

/// Returns the load of all segments in motion, if it is the same.
fn only_load<'a>(axis: &Axis, duty: &'a BearingDuty) -> Option<&'a FlangeLoad> {
    if duty.derived.is_some() {
        return None;
    }
    let shares = duty.loads.iter().zip(axis.trace.shares());
    let mut moving = shares.filter(|(_, share)| share.travelled.si() != 0.0).map(|(load, _)| load);
    moving.next().filter(|first| moving.all(|load| load == *first))
}

/// Checks M ≤ M_dyn(max) while the gear turns (table 55.1, footnote 2): it follows from the permissible tilt of the
/// gear, so it holds even if the life would allow more.
pub(crate) fn tilting_moment(borne: &Borne<'_>, work: &mut Workings) -> Outcome {
    let id = CheckId::BearingTiltingMoment;
    let moment = borne.known_moments()?.turning.moment;
    let limit = borne.bearing.tilting_moment_max.require("M_dyn_max")?;
    if let Some(offset) = borne.bearing.offset.known().filter(|_| work.is_on()) {
        if borne.duty.derived.is_some() {
            of_mechanism(borne, FlangeLoadKind::Moment, moment, Finding::LargestInMotion, work);
        } else {
            explain_stated_moment(borne, offset, |states| states.turns, work);
        }
    }
    work.value("M");
    work.given("M_dyn_max", &NEWTON_METRE, limit);
    work.limit("M_dyn_max");
    let at = instant(borne.duty, moment);
    Ok(Comparison { at, ..Comparison::with(id, &NEWTON_METRE, moment.value(), MODEL, limit) }.answer(Verdict::Fail))
}

/// Checks M_eq ≤ M_0(max) while the gear rests (table 55.1, footnote 3): M_0(max) holds for a tilting moment alone, so
/// forces count as the moment with the equivalent load on the bearing (eq. 76.1, 76.2). Largest loads of different instants
/// are combined as in [`static_safety`].
pub(crate) fn static_moment(borne: &Borne<'_>, work: &mut Workings) -> Outcome {
    let id = CheckId::BearingStaticMoment;
    let loads = borne.known_moments()?;
    let pitch = borne.bearing.pitch_diameter.require("d_p")?;
    let limit = borne.bearing.static_moment_max.require("M_0_max")?;
    let Peaks { moment, .. } = loads.resting;
    let load = forces_alone(&loads.resting);
    let equivalent = actuator::static_equivalent_moment(&load, Torque::from_si(moment.value()), pitch.value).si();
    if work.is_on() {
        explain_peaks(borne, &loads.resting, (Finding::LargestAtRest, |states| states.rests), work);
        work.given("d_p", &METRE, pitch);
        work.formula("M_eq", &NEWTON_METRE, equivalent, "M + d_p/2*(F_r + 0.44*F_a)", &equation("76.1"));
        work.value("M_eq");
        work.given("M_0_max", &NEWTON_METRE, limit);
        work.limit("M_0_max");
    }
    let source = equation("76.1");
    let at = instant(borne.duty, moment);
    let comparison = Comparison { at, ..Comparison::with(id, &NEWTON_METRE, equivalent, source, limit) };
    let alone = Amount { si: loads.resting.equivalent.value(), unit: &NEWTON_METRE };
    Ok(at_one_instant(&loads.resting, alone, comparison.answer(Verdict::Fail)))
}

/// Adds the value by the worst single instant to a check of the largest loads combined, where they act at different
/// instants, and rejects nothing that this instant alone permits.
fn at_one_instant(peaks: &Peaks, alone: Amount, check: Check) -> Check {
    let Some(combined) = check.value.filter(|_| !peaks.is_of_one_instant()) else { return check };
    // Where the loads stay the same over a stretch, the first instants of equal values may differ.
    if (alone.si / combined.si - 1.0).abs() <= numeric::AT_THE_LIMIT {
        return check;
    }
    let permitted = check.limit.is_some_and(|limit| check.direction().keeps(alone.si, limit.si));
    let verdict = if check.verdict == Verdict::Fail && permitted { Verdict::Advice } else { check.verdict };
    let mut check = Check { verdict, ..check };
    check.notes.push(Note::AtOneInstant(alone));
    check
}

/// Returns the largest forces without distances; their moment is separate.
fn forces_alone(peaks: &Peaks) -> FlangeLoad {
    let none = Length::from_si(0.0);
    FlangeLoad {
        radial_force: Force::from_si(peaks.radial.value()),
        radial_distance: none,
        axial_force: Force::from_si(peaks.axial.value()),
        axial_distance: none,
    }
}

/// Checks L_10 ≥ the required life (eq. 74.1, 74.3).
pub(crate) fn life(borne: &Borne<'_>, work: &mut Workings) -> Outcome {
    let Borne { axis, duty, bearing, .. } = *borne;
    let id = CheckId::BearingLife;
    let found = (|| {
        let offset = bearing.offset.require("R")?;
        let pitch = bearing.pitch_diameter.require("d_p")?;
        let rating = bearing.dynamic_rating.require("C")?;
        let kind = bearing.kind.require("bearing_type")?;
        let load_factor = duty.load_factor.ok_or(Missing { symbol: "bearing.load_factor" })?;
        duty.moment_known(axis)?;
        let mean = MeanLoad::of(axis, duty, &Geometry::of(bearing));
        let equivalent = actuator::dynamic_equivalent_load(&mean.load, mean.moment, pitch.value);
        if equivalent.si() <= 0.0 {
            return Ok(None);
        }
        let speed = axis.moments().speed_mean();
        if speed.si() <= 0.0 {
            return Err(Missing { symbol: "n_av" });
        }
        let life = actuator::bearing_life(rating.value, equivalent, load_factor, kind.value.life_exponent(), speed);
        if work.is_on() {
            explain_exponent(kind, work);
            let only = only_load(axis, duty);
            match only {
                Some(load) => load_moment(duty, load, offset, Finding::EverySegmentInMotion, work),
                None => explain_mean_load(&mean, offset, duty.derived.is_some(), work),
            }
            explain_equivalent_load(&mean, only.is_some(), (pitch, equivalent), work);
            work.given("C", &NEWTON, rating);
            work.stated("f_w", &ONE, load_factor, "bearing.load_factor");
            workings::mean_speed(axis, work);
            // For a swing the manual writes the equation with its angle and the number per minute.
            let source = if axis.moments().is_swing() { MODEL } else { equation("74.1") };
            work.formula("L_10", &HOUR, life.si(), "10^6/(60*n_av)*(C/(f_w*P_c))^B", &source);
            work.value("L_10");
        }
        Ok(Some(life))
    })();
    let number = if axis.moments().is_swing() { "74.3" } else { "74.1" };
    let mut check = match found {
        Ok(None) => unloaded(id),
        Ok(Some(life)) => {
            let asked = duty.life_min.map(Measure::si);
            work.asked("L_10_min", &HOUR, asked, id);
            against_asked(id, &HOUR, life.si(), asked, equation(number))
        }
        Err(missing) => not_checked(id, missing),
    };
    fretting(axis, bearing, &mut check);
    Ok(check)
}

/// Returns the result of a check that divides by the load of the bearing where there is none: passed without a value, since any
/// limit is met.
fn unloaded(id: CheckId) -> Check {
    Check { verdict: Verdict::Pass, notes: Note::NoBearingLoad.into(), ..unjudged(id) }
}

/// Adds a remark on small swings, which may fret the bearing independent of its rolling life, and advice if the life
/// does not fail by itself.
fn fretting(axis: &Axis, bearing: &OutputBearing, check: &mut Check) {
    let Some(least) = bearing.swing_min.known().map(|least| least.value) else { return };
    let (moments, small) = (axis.moments(), SmallSwings::of(axis, least));
    if !small.are_reported() {
        return;
    }
    let swing = moments.angle_swing;
    check.notes.push(if moments.is_swing() && swing.si() < least.si() {
        Note::SwingTooSmall { swing, least }
    } else {
        Note::SmallSwings { count: small.count, largest: small.largest, share: small.share, least }
    });
    if check.value.is_some() && check.verdict != Verdict::Fail {
        check.verdict = Verdict::Advice;
        check.missing = None;
    }
}

/// Columns of table 74.5: exponent B of the life by the type of the bearing.
const EXPONENT: [CellRef; 2] =
    [CellRef::of_the_manual("74.5", "B", "bearing_type=C"), CellRef::of_the_manual("74.5", "B", "bearing_type=F")];

/// Rows of table 75.4: factors x and y for a mostly radial load, and otherwise.
const FACTORS: [[CellRef; 2]; 2] = {
    const RADIAL: &str = "F_aav/(F_rav + 2 M/d_p) ≤ 1,5";
    const AXIAL: &str = "F_aav/(F_rav + 2 M/d_p) > 1,5";
    [
        [CellRef::of_the_manual("75.4", "x", RADIAL), CellRef::of_the_manual("75.4", "y", RADIAL)],
        [CellRef::of_the_manual("75.4", "x", AXIAL), CellRef::of_the_manual("75.4", "y", AXIAL)],
    ]
};

/// Records B of the bearing's type.
fn explain_exponent(kind: &Sourced<BearingType>, work: &mut Workings) {
    let [crossed, four] = &EXPONENT;
    let column = match kind.value {
        BearingType::CrossedRoller => crossed,
        BearingType::FourPoint => four,
    };
    work.figure("B", &ONE, kind.value.life_exponent(), &Source::Cell(column), kind.grade);
}

/// Records the derivation of the averages, if the load changes: `F_rav`, `F_aav` and `M_av`.
fn explain_mean_load(mean: &MeanLoad, offset: &Sourced<Length>, derived: bool, work: &mut Workings) {
    let (by_radial, by_axial) = (equation("75.2"), equation("75.3"));
    let (of_radial, of_axial, of_moment) = if derived {
        (Finding::RadialMeanOverCycle, Finding::AxialMeanOverCycle, Finding::MomentMeanOverCycle)
    } else {
        (Finding::RadialMean, Finding::AxialMean, Finding::MomentMean)
    };
    work.found("F_rav", &NEWTON, mean.load.radial_force.si(), of_radial, &by_radial, Grade::Computed);
    work.found("F_aav", &NEWTON, mean.load.axial_force.si(), of_axial, &by_axial, Grade::Computed);
    if !derived {
        work.given("R", &METRE, offset);
    }
    work.found("M_av", &NEWTON_METRE, mean.moment.si(), of_moment, &MODEL, Grade::Computed);
}

/// Records the derivation of the dynamic equivalent load, `P_c`; `constant`: from the loads themselves, not from
/// averages.
fn explain_equivalent_load(
    mean: &MeanLoad,
    constant: bool,
    (pitch, equivalent): (&Sourced<Length>, Force),
    work: &mut Workings,
) {
    let (x, y, mostly_radial) = actuator::dynamic_load_factors(&mean.load, mean.moment, pitch.value);
    let [radial, axial] = &FACTORS;
    let [of_x, of_y] = if mostly_radial { radial } else { axial };
    work.given("d_p", &METRE, pitch);
    work.figure("x", &ONE, x, &Source::Cell(of_x), Grade::Printed);
    work.figure("y", &ONE, y, &Source::Cell(of_y), Grade::Printed);
    let text = if constant { "x*(F_r + 2*M/d_p) + y*F_a" } else { "x*(F_rav + 2*M_av/d_p) + y*F_aav" };
    work.formula("P_c", &NEWTON, equivalent.si(), text, &equation("75.1"));
}

/// Checks f_s = C_0/P_0 ≥ the minimum of the operating condition (eq. 76.1, table 76.3), and of the size (table 55.1,
/// footnote 3), for the largest F_r, F_a and M of the cycle combined, as in the manufacturer's sister series
/// (docs/theory/output-bearing.md). If only their combination violates the minimum and no single instant does, it is
/// advice.
pub(crate) fn static_safety(borne: &Borne<'_>, work: &mut Workings) -> Outcome {
    let id = CheckId::BearingStatic;
    let (duty, bearing) = (borne.duty, borne.bearing);
    let offset = bearing.offset.require("R")?;
    let pitch = bearing.pitch_diameter.require("d_p")?;
    let rating = bearing.static_rating.require("C_0")?;
    duty.moment_known(borne.axis)?;
    let largest = &borne.loads().whole();
    let load = forces_alone(largest);
    let moment = Torque::from_si(largest.moment.value());
    let safety = actuator::static_safety(rating.value, &load, moment, pitch.value);
    if !safety.is_finite() {
        return Ok(unloaded(id));
    }
    if work.is_on() {
        match duty.loads.first().filter(|_| duty.derived.is_none() && is_constant(duty)) {
            Some(load) => load_moment(duty, load, offset, Finding::EverySegmentInMotion, work),
            None => {
                let is_derived = duty.derived.is_some();
                let what = if is_derived { Finding::LargestOfMechanism } else { Finding::LargestOverSegments };
                explain_peaks(borne, largest, (what, |_| true), work);
            }
        }
        work.given("d_p", &METRE, pitch);
        work.given("C_0", &NEWTON, rating);
        let equivalent = rating.value.si() / safety;
        if largest.is_of_one_instant() {
            work.formula("P_0", &NEWTON, equivalent, "F_r + 2*M/d_p + 0.44*F_a", &equation("76.1"));
        } else {
            work.found("P_0", &NEWTON, equivalent, Finding::LargestTogether, &equation("76.1"), Grade::Computed);
        }
        work.formula("f_s", &ONE, safety, "C_0/P_0", &equation("76.1"));
        work.value("f_s");
    }
    let asked = duty.operating_condition.map(crate::axis::OperatingCondition::static_safety_min);
    // The value of the table for the size is the minimum for any condition.
    let of_size = bearing.static_safety_min.known();
    let alone = 0.5 * rating.value.si() * pitch.value.si() / largest.equivalent.value();
    let check = match (asked, of_size.filter(|least| asked.is_some_and(|asked| least.value > asked))) {
        (Some(_), Some(least)) => {
            work.given_number("f_s_min", least);
            work.limit("f_s_min");
            let check = against_asked(id, &ONE, safety, Some(least.value), equation("76.1"));
            Check { limit_source: Some(least.source.clone()), ..check }
        }
        _ => {
            work.asked("f_s_min", &ONE, asked, id);
            against_asked(id, &ONE, safety, asked, equation("76.1"))
        }
    };
    Ok(at_one_instant(largest, Amount { si: alone, unit: &ONE }, check))
}

/// Checks γ = M/K_B ≤ the permissible tilt (eq. 76.4).
pub(crate) fn tilt_angle(borne: &Borne<'_>, work: &mut Workings) -> Outcome {
    let id = CheckId::TiltAngle;
    let moment = Torque::from_si(borne.largest_moment()?.value());
    let stiffness = borne.bearing.tilting_stiffness.require("K_B")?;
    let tilt = actuator::tilt_angle(moment, stiffness.value).si();
    explain_largest_moment(borne, work);
    work.given("K_B", &NEWTON_METRE_PER_ARCMINUTE, stiffness);
    work.formula("gamma", &ARCMINUTE, tilt, "M/K_B", &equation("76.4"));
    work.value("gamma");
    let limit = borne.duty.tilt_max.map(Measure::si);
    work.asked("gamma_max", &ARCMINUTE, limit, id);
    Ok(against_asked(id, &ARCMINUTE, tilt, limit, equation("76.4")))
}
