//! Changes with which an actuator fits where none does: another gearing of the load, a counterweight, several actuators.

use crate::progress::Progress;
use crate::sizing_use::{Candidate, Refusal, Rejected, size_watched};
use axis::{AxisProject, Gearing};
use configurator::ProductId;
use quantities::Unit;
use quantities::unit::ONE;
use sizing::{Check, CheckId, Fit, Proviso, Verdict};
use std::collections::BTreeMap;

/// A value of the gearing, or of a counterweight, with which an actuator fits, judged as displayed.
#[derive(Clone, Debug, PartialEq)]
pub struct GearingProposal {
    /// Key of the value: `mechanism.screw.lead`, `stage.ratio`, `mechanism.hoist.counterweight`.
    pub path: String,
    /// `true` if the project states the value; a missing stage or counterweight would be added.
    pub is_stated: bool,
    /// The value in SI, with three digits in its unit; with the neighbouring value closer to the stated one no actuator
    /// fits. Of a counterweight a value inside the range in which one fits, with a reserve on both sides.
    pub si: f64,
    /// Unit of the displayed value.
    pub unit: &'static Unit,
    /// Best actuator with this value.
    pub code: String,
    /// Verdict on the actuator.
    pub fit: Fit,
    /// Conditions of this verdict.
    pub proviso: Proviso,
    /// `true` if the loads on the flange must be stated anew: those behind an added stage are others.
    pub changes_flange_loads: bool,
}

impl GearingProposal {
    /// Returns `true` if the proposal is an added stage.
    #[must_use]
    pub fn adds_stage(&self) -> bool {
        !self.is_stated && self.path == STAGE
    }
}

/// Key of the ratio of a stage.
const STAGE: &str = "stage.ratio";

/// Number of digits of a value.
const DIGITS: i32 = 3;

/// Factor up to which values are searched in both directions.
const FARTHEST: f64 = 16.0;

/// Returns an upper bound of the power of the gearing with which the excess of a failing check falls.
///
/// Torque, current and speed are proportional to the gearing itself, heat to its square, a life to the cube of the
/// torque times the speed; twice these powers and more leave room for mechanisms whose ratio depends on the position.
const fn power(check: CheckId) -> f64 {
    match check {
        CheckId::GearLife | CheckId::BearingLife | CheckId::BearingStatic => 7.0,
        CheckId::Thermal | CheckId::OverloadI2t | CheckId::Regeneration => 4.0,
        _ => 3.0,
    }
}

/// Factor of the smallest step, which finds a window of one per cent.
const STEP_LEAST: f64 = 1.01;

/// Factor of a step after the effort is spent.
const STEP_COARSE: f64 = 1.189_207_115_002_721;

/// Approximate number of instants and samples evaluated by the fine steps of one search: some tens of milliseconds for
/// a short cycle, a second for the longest.
const EFFORT: usize = 400_000;

/// Smallest and largest number of fine steps of a search.
const STEPS: [usize; 2] = [40, 400];

/// Cost of an instant of the loads on the flange, relative to that of an instant of the cycle.
const FLANGE_SHARE: f64 = 0.05;

/// Longest cycle in instants: some hundred rankings of a longer one would take more than a second.
pub const GEARING_INSTANTS_MOST: usize = 10_000;

/// Number of equal actuators among which the load is divided.
const ACTUATORS: [u32; 5] = [2, 3, 4, 6, 8];

/// Number of masses of a counterweight that are tried, up to the balance and half as much again.
const COUNTERWEIGHTS: usize = 24;

/// Number of halvings with which the ends of a narrow range of masses are found.
const HALVINGS: u32 = 8;

/// Several equal actuators that move the load together.
#[derive(Clone, Debug, PartialEq)]
pub struct SharedLoad {
    /// Number of actuators, the smallest one that fits.
    pub actuators: u32,
    /// Quantities of the load and of the segments with the share of one actuator.
    pub shares: Vec<Gearing>,
    /// Best actuator.
    pub code: String,
    /// Conditions of the verdict.
    pub proviso: Proviso,
}

/// Returns the smallest number of equal actuators that move the load together, each with its share; `None` if an actuator
/// fits alone, if the load cannot be divided, or if eight do not suffice.
///
/// Each actuator carries the same share of masses, forces and payloads. An uneven division, as by tolerances of two belts,
/// must be allowed for in the load.
///
/// [`Refusal::Stopped`] if the search was cancelled.
pub fn shared_load(project: &AxisProject, progress: &Progress) -> Result<Option<SharedLoad>, Refusal> {
    if is_long(project) || RankedAxis::of(project, progress)?.best.is_some() {
        return Ok(None);
    }
    for actuators in ACTUATORS {
        let Some((shares, each)) = project.shared_by(actuators) else { return Ok(None) };
        if let Some((code, _, proviso)) = RankedAxis::of(&each, progress)?.best {
            return Ok(Some(SharedLoad { actuators, shares, code, proviso }));
        }
    }
    Ok(None)
}

/// Returns `true` if the cycle is too long for some hundred rankings.
pub(crate) fn is_long(project: &AxisProject) -> bool {
    let instants = project.axis.instants();
    let [on_flange, recorded] = project.axis.flange_instants();
    #[allow(clippy::cast_precision_loss, reason = "a count far below 2^52")]
    let weighted = instants as f64 + FLANGE_SHARE * (on_flange + recorded);
    weighted > GEARING_INSTANTS_MOST as f64
}

/// Returns the nearest values of each key of the gearing, and of a counterweight, with which an actuator of the catalogue
/// fits, one change at a time. Empty if an actuator fits already, or if the cycle has more than [`GEARING_INSTANTS_MOST`] instants and
/// samples.
///
/// [`Refusal::Stopped`] if the search was cancelled.
pub fn gearing_proposals(project: &AxisProject, progress: &Progress) -> Result<Vec<GearingProposal>, Refusal> {
    if is_long(project) {
        return Ok(Vec::new());
    }
    let here = RankedAxis::of(project, progress)?;
    if here.best.is_some() {
        return Ok(Vec::new());
    }
    let adds_stage = project.axis.mechanism.stage.is_none();
    let excluded = if adds_stage { excluded_by_a_check(project, progress)? } else { Failing::new() };
    let none = Failing::new();
    let [least, most] = STEPS;
    let fine = (EFFORT / project.axis.instants().max(1)).clamp(least, most);
    let mut found = Vec::new();
    let mut seek = |path: &str, is_stated: bool, stated, unit, with: &dyn Fn(f64) -> Option<AxisProject>| {
        let failing = if is_stated { &none } else { &excluded };
        let ranked = |si: f64| {
            with(si).map_or_else(
                || Ok(RankedAxis::default()),
                |project| RankedAxis::unless_unchecked(&project, failing, progress),
            )
        };
        if let Some((si, (code, fit, proviso))) = nearest(&ranked, stated, &here, unit, fine)? {
            let changes_flange_loads = !is_stated && project.axis.bearing.is_some();
            found.push(GearingProposal {
                path: path.to_owned(),
                is_stated,
                si,
                unit,
                code,
                fit,
                proviso,
                changes_flange_loads,
            });
        }
        Ok::<_, Refusal>(())
    };
    for Gearing { path, si, unit } in project.gearings() {
        seek(&path, true, si, unit, &|value| project.with_value(&path, value))?;
    }
    if adds_stage {
        seek(STAGE, false, 1.0, &ONE, &|ratio| project.with_stage(ratio))?;
    }
    if let Some((Gearing { path, si, unit }, balanced)) = project.counterweight() {
        let ranked = |mass: f64| {
            project
                .with_value(&path, mass)
                .map_or_else(|| Ok(RankedAxis::default()), |other| RankedAxis::of(&other, progress))
        };
        if let Some((mass, (code, fit, proviso))) = nearest_mass(&ranked, si, 1.5 * balanced, unit)? {
            let is_stated = si > 0.0;
            found.push(GearingProposal {
                path,
                is_stated,
                si: mass,
                unit,
                code,
                fit,
                proviso,
                changes_flange_loads: false,
            });
        }
    }
    Ok(found)
}

/// Searches the mass nearest to a stated one, up to a largest one, with which an actuator fits also if it is a step lighter
/// or heavier: a mass at the end of the range would no longer fit as built. If the range has no such mass, its middle is
/// returned. A mass with which an actuator fits is preferred to one with which it fits only if an estimate holds.
fn nearest_mass(
    ranked: &dyn Fn(f64) -> Result<RankedAxis, Refusal>,
    stated: f64,
    most: f64,
    unit: &Unit,
) -> Result<Option<(f64, Best)>, Refusal> {
    #[allow(clippy::cast_precision_loss, reason = "at most some dozen")]
    let mass = |place: usize| most / COUNTERWEIGHTS as f64 * place as f64;
    let all: Vec<Option<Best>> =
        (0..=COUNTERWEIGHTS).map(|place| Ok(ranked(mass(place))?.best)).collect::<Result<_, Refusal>>()?;
    let is = |place: usize, fit: Fit| all.get(place).and_then(Option::as_ref).is_some_and(|best| best.1 <= fit);
    let mut nearest: Vec<usize> = (0..=COUNTERWEIGHTS).collect();
    nearest.sort_by(|a, b| (mass(*a) - stated).abs().total_cmp(&(mass(*b) - stated).abs()));
    for fit in [Fit::Fits, Fit::FitsIfEstimate] {
        let is_inside = |place: &usize| {
            let lighter = place.checked_sub(1).is_none_or(|lighter| is(lighter, fit));
            is(*place, fit) && lighter && is(place + 1, fit)
        };
        let inside = nearest.iter().copied().find(is_inside).map(mass);
        let narrow = || -> Result<Option<f64>, Refusal> {
            let Some(place) = nearest.iter().copied().find(|place| is(*place, fit)) else { return Ok(None) };
            // The run of fitting masses; it has at most two of them.
            let first = (0..=place).rev().take_while(|place| is(*place, fit)).last().unwrap_or(place);
            let last = (place..=COUNTERWEIGHTS).take_while(|place| is(*place, fit)).last().unwrap_or(place);
            let end = |fits: usize, misses: f64| {
                let (mut good, mut bad) = (mass(fits), misses);
                for _ in 0..HALVINGS {
                    let middle = f64::midpoint(good, bad);
                    if ranked(middle)?.best.is_some_and(|best| best.1 <= fit) { good = middle } else { bad = middle }
                }
                Ok::<_, Refusal>(good)
            };
            let lower = if first > 0 { end(first, mass(first - 1))? } else { 0.0 };
            Ok(Some(f64::midpoint(lower, end(last, mass(last + 1))?)))
        };
        let is_inside = inside.is_some();
        let Some(found) = inside.map_or_else(narrow, |mass| Ok(Some(mass)))? else { continue };
        if found == 0.0 {
            return Ok(all.into_iter().next().flatten().map(|best| (found, best)));
        }
        // In a narrow range three digits may lead to its end.
        for digits in DIGITS + i32::from(!is_inside)..=DIGITS + 2 {
            let scale = 10_f64.powf(f64::from(digits - 1) - unit.from_si(found).log10().floor());
            let rounded = unit.to_si((unit.from_si(found) * scale).round() / scale);
            // Judged as it is displayed.
            if let Some(best) = ranked(rounded)?.best.filter(|best| best.1 <= fit) {
                return Ok(Some((rounded, best)));
            }
        }
    }
    Ok(None)
}

/// The best actuator with its verdict.
pub(crate) type Best = (String, Fit, Proviso);

/// Result of ranking the catalogue with one value of the gearing.
pub(crate) struct RankedAxis {
    /// Best actuator, if one fits.
    pub(crate) best: Option<Best>,
    /// Smallest factor by which the gearing must change before an actuator may fit.
    farther: f64,
}

impl Default for RankedAxis {
    /// Returns the result for an impossible axis: a possible one may be adjacent.
    fn default() -> Self {
        Self { best: None, farther: 1.0 }
    }
}

/// The failing checks of each rejected actuator.
type Failing = BTreeMap<ProductId, Vec<CheckId>>;

/// Returns the failing checks of every actuator that the catalogue offers for an axis.
fn excluded_by_a_check(project: &AxisProject, progress: &Progress) -> Result<Failing, Refusal> {
    let sizing = size_watched(project, 0, Rejected::Reasons, progress)?;
    let failing = |candidate: &Candidate<'_>| {
        let checks = candidate.judgement.checks.iter().filter(|check| check.verdict == Verdict::Fail);
        (candidate.id.clone(), checks.map(|check| check.id).collect())
    };
    Ok(sizing.rejected().iter().map(failing).collect())
}

impl RankedAxis {
    pub(crate) fn of(project: &AxisProject, progress: &Progress) -> Result<Self, Refusal> {
        Self::unless_unchecked(project, &Failing::new(), progress)
    }

    /// Ranks the catalogue; an actuator does not fit where a check that fails without the change cannot be made with it: the
    /// loads on the flange behind an additional stage are not known.
    fn unless_unchecked(project: &AxisProject, failing: &Failing, progress: &Progress) -> Result<Self, Refusal> {
        let sizing = size_watched(project, 0, Rejected::None, progress)?;
        let is_met = |candidate: &&Candidate<'_>| candidate.objections.is_empty();
        let farther = sizing.candidates.iter().filter(is_met).filter_map(farther).reduce(f64::min);
        let is_checked = |candidate: &&Candidate<'_>| {
            let is_made = |id: &CheckId| {
                candidate.judgement.checks.of(*id).is_none_or(|check| check.verdict != Verdict::NotChecked)
            };
            failing.get(&candidate.id).is_none_or(|failing| failing.iter().all(is_made))
        };
        let best = sizing.fitting().iter().find(is_checked);
        Ok(Self {
            best: best.map(|best| (best.id.to_string(), best.fit(), best.judgement.proviso())),
            farther: farther.unwrap_or(f64::INFINITY),
        })
    }
}

/// Returns the smallest factor by which the gearing must change before an actuator may fit, by its failing checks;
/// `None` if a failing check is independent of the gearing. A limit of zero gives no distance: the speed that leads to
/// it has a check of its own. The worst instant of the torque-speed trace by the lower edge is not the one at which the
/// check fails, so its share is not used either.
fn farther(candidate: &Candidate<'_>) -> Option<f64> {
    let failing = || candidate.judgement.checks.iter().filter(|check| check.verdict == Verdict::Fail);
    if failing().any(|check| check.id.is_of_the_place()) {
        return None;
    }
    let says_how_far = |check: &&Check| check.id != CheckId::TorqueSpeedTrace;
    let factor = |check: &Check| Some(check.share_of_failure()?.powf(1.0 / power(check.id)));
    Some(failing().filter(says_how_far).filter_map(factor).fold(1.0, f64::max))
}

/// Searches the value nearest to a stated one with which an actuator fits, and that actuator.
///
/// The search proceeds from the stated value in both directions, the nearer end first. An actuator that exceeds a limit
/// by a factor x does not fit before the gearing has changed by x^(1/p), see [`power`]; this is the step, at least
/// [`STEP_LEAST`], after `fine` steps at least [`STEP_COARSE`], and a window narrower than that may be missed.
fn nearest(
    ranked: &dyn Fn(f64) -> Result<RankedAxis, Refusal>,
    stated: f64,
    here: &RankedAxis,
    unit: &Unit,
    fine: usize,
) -> Result<Option<(f64, Best)>, Refusal> {
    // Factors reached upwards and downwards, and the next steps.
    let mut ends = [1.0, -1.0].map(|sense| (sense, 1.0, step(here.farther, 0, fine)));
    for count in 1.. {
        let next = ends.iter_mut().min_by(|a, b| a.2.total_cmp(&b.2));
        let Some((sense, reached, factor)) = next.filter(|(_, _, factor)| *factor <= FARTHEST) else { break };
        let value = |factor: f64| stated * factor.powf(*sense);
        let found = ranked(value(*factor))?;
        if let Some(best) = found.best {
            return edge(ranked, value(*reached), (value(*factor), best), unit).map(Some);
        }
        *reached = *factor;
        *factor *= step(found.farther, count, fine);
    }
    Ok(None)
}

/// Returns the factor of the next step.
fn step(farther: f64, count: usize, fine: usize) -> f64 {
    farther.max(if count < fine { STEP_LEAST } else { STEP_COARSE })
}

/// Returns the first value with few digits at which an actuator fits, between a value at which none fits and one at
/// which one fits.
fn edge(
    ranked: &dyn Fn(f64) -> Result<RankedAxis, Refusal>,
    misses: f64,
    (fits, best): (f64, Best),
    unit: &Unit,
) -> Result<(f64, Best), Refusal> {
    let upwards = fits > misses;
    // A narrow window may contain no value with the default number of digits.
    for digits in [DIGITS, DIGITS + 1, DIGITS + 2] {
        let scale = 10_f64.powf(f64::from(digits - 1) - unit.from_si(fits).abs().log10().floor());
        let value = |place: f64| unit.to_si(place / scale);
        let inwards = |si: f64| {
            let place = unit.from_si(si) * scale;
            if upwards { place.floor() } else { place.ceil() }
        };
        let sense = if upwards { 1.0 } else { -1.0 };
        let mut low = inwards(misses);
        let Some((mut high, mut found)) = [inwards(fits), inwards(fits) + sense]
            .into_iter()
            .filter(|place| (place - low) * sense > 0.0)
            .find_map(|place| match ranked(value(place)) {
                Ok(there) => there.best.map(|best| Ok((place, best))),
                Err(refusal) => Some(Err(refusal)),
            })
            .transpose()?
        else {
            continue;
        };
        while (high - low).abs() > 1.5 {
            let middle = (0.5 * (low + high)).round();
            match ranked(value(middle))?.best {
                Some(better) => (high, found) = (middle, better),
                None => low = middle,
            }
        }
        return Ok((value(high), found));
    }
    Ok((fits, best))
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIFT: &str = "format = 1\n[mechanism.screw]\nlead = \"20 mm\"\nmass = \"60 kg\"\ninclination = \"90 deg\"\n\
        [[motion]]\nlaw = \"polynomial_5\"\ndistance = \"300 mm\"\ntime = \"2 s\"\n[[motion]]\nlaw = \"polynomial_5\"\n\
        distance = \"-300 mm\"\ntime = \"2 s\"\n";

    /// The lift of the review: a longer lead or a stage that gears up would make an actuator fit.
    #[test]
    fn a_lead_or_a_stage_is_proposed_where_nothing_fits() {
        let project = crate::read(LIFT).unwrap();
        let found = gearing_proposals(&project, &Progress::endless()).unwrap();
        let paths: Vec<&str> = found.iter().map(|mend| mend.path.as_str()).collect();
        assert_eq!(paths, ["mechanism.screw.lead", "stage.ratio"]);
        assert!(found[0].si > 0.020 && found[1].si < 1.0, "{found:?}");
        for mend in &found {
            let with = match mend.is_stated {
                true => project.with_value(&mend.path, mend.si),
                false => project.with_stage(mend.si),
            };
            let best = RankedAxis::of(&with.unwrap(), &Progress::endless()).unwrap().best;
            assert_eq!(best, Some((mend.code.clone(), mend.fit, mend.proviso)));
        }
        // A stage of ratio r turns the screw like a lead longer by 1/r.
        assert!((found[0].si / 0.020 * found[1].si - 1.0).abs() < 0.15, "{found:?}");
        // A stated stage is varied in the same way.
        let staged = crate::read(&format!("{LIFT}[stage]\nkind = \"gear\"\nratio = 1\n")).unwrap();
        let varied = gearing_proposals(&staged, &Progress::endless()).unwrap();
        assert_eq!(varied.iter().map(|mend| mend.is_stated).collect::<Vec<_>>(), [true, true], "{varied:?}");
        assert_eq!((varied[1].path.as_str(), varied[1].si), ("stage.ratio", found[1].si));
        assert_eq!(varied[1].code, found[1].code);
        let fitting = LIFT.replace("20 mm", "100 mm");
        assert!(gearing_proposals(&crate::read(&fitting).unwrap(), &Progress::endless()).unwrap().is_empty());
    }

    /// A lift that no actuator moves: half of its load, or a counterweight, lets one fit; the answer with the proposed
    /// values, read anew from a file, is the proposed one.
    #[test]
    fn several_actuators_and_a_counterweight_are_proposed_as_they_would_be_judged() {
        let hoist = |mass: &str, more: &str| {
            format!(
                "format = 1\n[mechanism.hoist]\ndrum_diameter = \"200 mm\"\nmass = \"{mass}\"\n{more}[[motion]]\n\
                law = \"polynomial_5\"\ndistance = \"1 m\"\ntime = \"6 s\"\n[[motion]]\nlaw = \"polynomial_5\"\n\
                distance = \"-1 m\"\ntime = \"6 s\"\n"
            )
        };
        let project = crate::read(&hoist("900 kg", "")).unwrap();
        let progress = Progress::endless();
        let shared = shared_load(&project, &progress).unwrap().unwrap();
        let fits = |text: &str| RankedAxis::of(&crate::read(text).unwrap(), &progress).unwrap().best;
        for (count, is_enough) in [(shared.actuators, true), (shared.actuators - 1, false)] {
            let text = hoist(&format!("{} kg", 900.0 / f64::from(count)), "");
            assert_eq!(fits(&text).map(|(code, ..)| code == shared.code), is_enough.then_some(true), "{shared:?}");
        }
        let paths: Vec<&str> = shared.shares.iter().map(|share| share.path.as_str()).collect();
        assert_eq!(paths, ["mechanism.hoist.mass"]);
        let found = gearing_proposals(&project, &progress).unwrap();
        let balance = found.iter().find(|mend| mend.path.ends_with("counterweight")).unwrap();
        assert!(!balance.is_stated && balance.si > 100.0 && balance.si < 900.0, "{balance:?}");
        let with = |mass: f64| fits(&hoist("900 kg", &format!("counterweight = \"{mass} kg\"\n")));
        assert_eq!(with(balance.si).map(|(code, ..)| code), Some(balance.code.clone()));
        // A mass that differs by some per cent is enough too, with the same verdict or a better one.
        for factor in [0.95, 1.05] {
            let built = with((balance.si * factor).round());
            assert!(built.is_some_and(|(_, fit, _)| fit <= balance.fit), "{factor}");
        }
        // An actuator of a file with several axes gets the same proposals.
        let of_two = hoist("900 kg", "").replace("[mechanism", "[axis.mechanism").replace("[[motion", "[[axis.motion");
        let of_two = of_two.replace("format = 1\n", "format = 1\n[[axis]]\nname = \"z\"\n");
        let axes = format!(
            "{of_two}[[axis]]\nname = \"b\"\n[axis.load]\ninertia = \"1 kg m^2\"\n[[axis.motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n"
        );
        let axes = crate::read_all(&axes, &axis::NoFiles).unwrap();
        assert_eq!(gearing_proposals(&axes[0], &progress).unwrap(), found);
        assert_eq!(shared_load(&axes[0], &progress).unwrap(), Some(shared));
        // A recorded or an endless load is not divided.
        assert_eq!(crate::read(LIFT).unwrap().shared_by(2).map(|(shares, _)| shares.len()), Some(1));
    }

    /// Two moves of 160 instants each, and a stated stage: a longer lead or a stage that gears up would make an
    /// actuator fit.
    #[test]
    fn a_cycle_of_some_hundred_instants_is_mended_too() {
        let tilter = "format = 1\n[mechanism.screw]\nlead = \"10 mm\"\nmass = \"120 kg\"\ninclination = \"90 deg\"\n\
            [stage]\nkind = \"belt\"\nratio = 2\n[[motion]]\nlaw = \"modified_sine\"\ndistance = \"200 mm\"\n\
            time = \"1.5 s\"\n[[motion]]\nlaw = \"modified_sine\"\ndistance = \"-200 mm\"\ntime = \"2 s\"\n";
        let found = gearing_proposals(&crate::read(tilter).unwrap(), &Progress::endless()).unwrap();
        let paths: Vec<&str> = found.iter().map(|mend| mend.path.as_str()).collect();
        assert_eq!(paths, ["mechanism.screw.lead", "stage.ratio"], "{found:?}");
        assert!((found[0].si / 0.010 * found[1].si / 2.0 - 1.0).abs() < 0.15, "{found:?}");
    }

    /// Ranges of masses in which an actuator fits, or fits if an estimate holds: the proposed mass is inside with reserve.
    #[test]
    fn a_counterweight_is_not_at_the_end_of_its_range() {
        let most = 1500.0;
        let step = most / 24.0;
        for place in 0..200 {
            let (low, width) = (f64::from(place) * 6.0, f64::from(place % 7 + 1) * 40.0);
            for certain in [0.0, 0.3] {
                // The middle part of the range without the condition of an estimate.
                let firm = (low + (0.5 - certain) * width)..=(low + (0.5 + certain) * width);
                let ranked = |mass: f64| {
                    let fit = if certain > 0.0 && firm.contains(&mass) { Fit::Fits } else { Fit::FitsIfEstimate };
                    let best = (low..=low + width).contains(&mass).then(|| ("one".to_owned(), fit, Proviso::default()));
                    Ok(RankedAxis { best, farther: 1.0 })
                };
                let found = nearest_mass(&ranked, 0.0, most, &quantities::unit::KILOGRAM).unwrap();
                let (mass, best) = match found {
                    Some(found) => found,
                    None => {
                        assert!(width < step, "nothing in {low} to {}", low + width);
                        continue;
                    }
                };
                assert_eq!(ranked(mass).unwrap().best, Some(best.clone()), "judged as displayed");
                let range = if best.1 == Fit::Fits { firm.clone() } else { low..=low + width };
                let reserve = (mass - range.start()).min(range.end() - mass);
                let wanted = (0.9 * step).min(0.45 * (range.end().min(most) - range.start()));
                assert!(
                    mass == 0.0 || reserve >= wanted - 1.0 || *range.end() > most,
                    "{mass} in {range:?}, {reserve}"
                );
            }
        }
    }

    /// A catalogue with one actuator that is too slow below a value and too weak above another; the excess follows
    /// powers of the value.
    fn window(low: f64, high: f64, value: f64) -> RankedAxis {
        let (speed, heat) = (low / value, (value / high).powi(2));
        let farther = speed.powf(1.0 / power(CheckId::PeakSpeed)).max(heat.powf(1.0 / power(CheckId::Thermal)));
        RankedAxis {
            best: (farther <= 1.0).then(|| ("the only one".to_owned(), Fit::Fits, Proviso::default())),
            farther,
        }
    }

    #[test]
    fn every_window_of_a_little_more_than_one_percent_is_found() {
        for place in 0..400 {
            // From a sixteenth to sixteen times the value, without the value itself.
            let low = 15.5_f64.powf(f64::from(place) / 200.0 - 1.0);
            let high = low * 1.011;
            if (low..=high).contains(&1.0) {
                continue;
            }
            let count = std::cell::Cell::new(0);
            let ranked = |value: f64| {
                count.set(count.get() + 1);
                Ok(window(low, high, value))
            };
            let found = nearest(&ranked, 1.0, &window(low, high, 1.0), &ONE, 400).unwrap();
            let (value, _) = found.unwrap_or_else(|| panic!("nothing in {low} to {high}"));
            assert!((low..=high).contains(&value), "{value} in {low} to {high}");
            // The displayed value fits, and its neighbour closer to one does not.
            let scale = 10_f64.powf(2.0 - value.log10().floor());
            let place = value * scale;
            assert!((place - place.round()).abs() < 1e-6, "{value} has more than three digits");
            let nearer = (place.round() + if value > 1.0 { -1.0 } else { 1.0 }) / scale;
            assert!(!(low..=high).contains(&nearer), "{nearer} is nearer than {value} in {low} to {high}");
            assert!(count.get() < 120, "{} rankings", count.get());
        }
        let none = |value: f64| Ok(window(2.0, 1.9, value));
        assert_eq!(nearest(&none, 1.0, &window(2.0, 1.9, 1.0), &ONE, 400).unwrap(), None);
    }
}
