//! What would let an actuator fit where none does: another gearing of the load.

use crate::patience::Patience;
use crate::sizing_use::{Candidate, CandidateId, Refusal, size_watched};
use project::{Gearing, Project};
use quantities::Unit;
use quantities::unit::ONE;
use sizing::{CheckId, Verdict};

/// A value with which an actuator would fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Mend {
    /// The key: `mechanism.screw.lead`, `stage.ratio`.
    pub path: String,
    /// Whether the project states it; a stage that it does not have would be added.
    pub is_stated: bool,
    /// The value in SI, rounded towards what fits.
    pub si: f64,
    /// The unit in which it is shown.
    pub unit: &'static Unit,
    /// The best actuator with it.
    pub code: String,
}

/// Values are sought in steps of this factor, up to so many of them in both directions: a factor of sixteen.
const STEP: f64 = 1.189_207_115_002_721;
const STEPS: i32 = 16;

/// Halvings of the step at whose end an actuator fits.
const HALVINGS: u32 = 5;

/// Halvings of a step between whose ends one may fit: a window of 1 % is found. A narrower one leaves no reserve.
const SPLITS: u32 = 4;

/// Within a step no utilisation falls by more than this factor: it follows a power of the gearing up to the fourth.
const FALL: f64 = 2.0;

/// The longest cycle: some hundred rankings of a longer one would keep the user waiting for more than a second.
pub const GEARING_INSTANTS_MOST: usize = 10_000;

/// The nearest values of each key of the gearing with which an actuator of the catalogue fits, one change at a time. Nothing
/// where one fits already, or where the cycle has more than [`GEARING_INSTANTS_MOST`] instants and samples.
///
/// # Errors
/// [`Refusal::Stopped`] where it was cancelled.
pub fn mends(project: &Project, patience: &Patience) -> Result<Vec<Mend>, Refusal> {
    if project.axis.instants() > GEARING_INSTANTS_MOST {
        return Ok(Vec::new());
    }
    let here = Ranked::of(project, patience)?;
    if here.best.is_some() {
        return Ok(Vec::new());
    }
    let mut found = Vec::new();
    let mut seek = |path: &str, is_stated, stated, unit, with: &dyn Fn(f64) -> Option<Project>| {
        let ranked = |si: f64| with(si).map_or_else(|| Ok(Ranked::default()), |project| Ranked::of(&project, patience));
        if let Some((si, code)) = nearest(&ranked, stated, &here, unit)? {
            found.push(Mend { path: path.to_owned(), is_stated, si, unit, code });
        }
        Ok::<_, Refusal>(())
    };
    for Gearing { path, si, unit } in project.gearings() {
        seek(&path, true, si, unit, &|value| project.with_value(&path, value))?;
    }
    if project.axis.mechanism.stage.is_none() {
        seek("stage.ratio", false, 1.0, &ONE, &|ratio| project.with_stage(ratio))?;
    }
    Ok(found)
}

/// The catalogue with one value of the gearing.
#[derive(Clone, Debug, Default)]
struct Ranked {
    /// The best actuator, if one fits.
    best: Option<String>,
    /// The others that miss by less than [`FALL`], with the checks that fail.
    near: Vec<(CandidateId, Vec<CheckId>)>,
}

impl Ranked {
    fn of(project: &Project, patience: &Patience) -> Result<Self, Refusal> {
        let sizing = size_watched(project, 0, patience)?;
        let is_near = |candidate: &&Candidate<'_>| {
            candidate.objections.is_empty() && !candidate.fits() && candidate.judgement.utilisation() < FALL
        };
        let failing = |candidate: &Candidate<'_>| {
            let checks = candidate.judgement.checks.iter();
            checks.filter(|check| check.verdict == Verdict::Fail).map(|check| check.id).collect()
        };
        Ok(Self {
            best: sizing.answer().map(|best| best.id.to_string()),
            near: sizing.candidates.iter().filter(is_near).map(|near| (near.id.clone(), failing(near))).collect(),
        })
    }

    /// Whether an actuator may fit between two values: a longer way of the load with a turn takes more torque and less speed,
    /// so a check that fails at both fails between them too.
    fn may_fit_before(&self, other: &Self) -> bool {
        self.near.iter().any(|(id, here)| {
            let there = other.near.iter().find(|(other, _)| other == id);
            there.is_some_and(|(_, there)| !here.iter().any(|check| there.contains(check)))
        })
    }
}

/// The value nearest to a stated one with which an actuator fits, and that actuator: at the steps, then between them.
fn nearest(
    ranked: &dyn Fn(f64) -> Result<Ranked, Refusal>,
    stated: f64,
    here: &Ranked,
    unit: &Unit,
) -> Result<Option<(f64, String)>, Refusal> {
    let mut open: Vec<[(f64, Ranked); 2]> = Vec::new();
    let mut last = [here.clone(), here.clone()];
    for step in 1..=STEPS {
        for (last, sense) in last.iter_mut().zip([1, -1]) {
            let [before, value] = [step - 1, step].map(|step| stated * STEP.powi(sense * step));
            let next = ranked(value)?;
            if let Some(code) = next.best {
                return edge(ranked, before, (value, code), unit).map(Some);
            }
            let last = std::mem::replace(last, next.clone());
            if last.may_fit_before(&next) {
                open.push([(before, last), (value, next)]);
            }
        }
    }
    for _ in 0..SPLITS {
        let mut halves = Vec::new();
        for [near, far] in open {
            let value = (near.0 * far.0).sqrt();
            let middle = ranked(value)?;
            if let Some(code) = middle.best {
                return edge(ranked, near.0, (value, code), unit).map(Some);
            }
            let middle = (value, middle);
            for half in [[near, middle.clone()], [middle, far]] {
                if half[0].1.may_fit_before(&half[1].1) {
                    halves.push(half);
                }
            }
        }
        open = halves;
    }
    Ok(None)
}

/// Where an actuator begins to fit, between a value with which none does and one with which one does; rounded towards the
/// latter.
fn edge(
    ranked: &dyn Fn(f64) -> Result<Ranked, Refusal>,
    mut misses: f64,
    (mut fits, mut found): (f64, String),
    unit: &Unit,
) -> Result<(f64, String), Refusal> {
    for _ in 0..HALVINGS {
        let middle = (fits * misses).sqrt();
        match ranked(middle)?.best {
            Some(better) => (fits, found) = (middle, better),
            None => misses = middle,
        }
    }
    let rounded = rounded(fits, fits > misses, unit);
    Ok(match ranked(rounded)?.best {
        Some(code) => (rounded, code),
        None => (fits, found),
    })
}

/// A value with two digits in its unit, away from what does not fit.
fn rounded(si: f64, upwards: bool, unit: &Unit) -> f64 {
    let value = unit.from_si(si);
    let scale = 10_f64.powf(1.0 - value.abs().log10().floor());
    let digits = if upwards { (value * scale).ceil() } else { (value * scale).floor() };
    unit.to_si(digits / scale)
}

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::unit::MILLIMETRE;

    const LIFT: &str = "format = 1\n[mechanism.screw]\nlead = \"20 mm\"\nmass = \"60 kg\"\ninclination = \"90 deg\"\n\
        [[motion]]\nlaw = \"polynomial_5\"\ndistance = \"300 mm\"\ntime = \"2 s\"\n[[motion]]\nlaw = \"polynomial_5\"\n\
        distance = \"-300 mm\"\ntime = \"2 s\"\n";

    /// The lift of the review: a longer lead or a stage that gears up would do.
    #[test]
    fn a_lead_or_a_stage_is_proposed_where_nothing_fits() {
        let project = crate::read(LIFT).unwrap();
        let found = mends(&project, &Patience::endless()).unwrap();
        let paths: Vec<&str> = found.iter().map(|mend| mend.path.as_str()).collect();
        assert_eq!(paths, ["mechanism.screw.lead", "stage.ratio"]);
        assert!(found[0].si > 0.020 && found[1].si < 1.0, "{found:?}");
        for mend in &found {
            let with = match mend.is_stated {
                true => project.with_value(&mend.path, mend.si),
                false => project.with_stage(mend.si),
            };
            assert_eq!(Ranked::of(&with.unwrap(), &Patience::endless()).unwrap().best.as_ref(), Some(&mend.code));
        }
        // A stage of ratio r turns the screw as a lead longer by 1/r does.
        assert!((found[0].si / 0.020 * found[1].si - 1.0).abs() < 0.15, "{found:?}");
        // A stage that is stated is varied, and counts as much.
        let staged = crate::read(&format!("{LIFT}[stage]\nkind = \"gear\"\nratio = 1\n")).unwrap();
        let varied = mends(&staged, &Patience::endless()).unwrap();
        assert_eq!(varied.iter().map(|mend| mend.is_stated).collect::<Vec<_>>(), [true, true], "{varied:?}");
        assert_eq!((varied[1].path.as_str(), varied[1].si), ("stage.ratio", found[1].si));
        assert_eq!(varied[1].code, found[1].code);
        let fitting = LIFT.replace("20 mm", "100 mm");
        assert!(mends(&crate::read(&fitting).unwrap(), &Patience::endless()).unwrap().is_empty());
    }

    /// Two moves of 160 instants each, and a stated stage: a longer lead or a stage that gears up would do.
    #[test]
    fn a_cycle_of_some_hundred_instants_is_mended_too() {
        let tilter = "format = 1\n[mechanism.screw]\nlead = \"10 mm\"\nmass = \"120 kg\"\ninclination = \"90 deg\"\n\
            [stage]\nkind = \"belt\"\nratio = 2\n[[motion]]\nlaw = \"modified_sine\"\ndistance = \"200 mm\"\n\
            time = \"1.5 s\"\n[[motion]]\nlaw = \"modified_sine\"\ndistance = \"-200 mm\"\ntime = \"2 s\"\n";
        let found = mends(&crate::read(tilter).unwrap(), &Patience::endless()).unwrap();
        let paths: Vec<&str> = found.iter().map(|mend| mend.path.as_str()).collect();
        assert_eq!(paths, ["mechanism.screw.lead", "stage.ratio"], "{found:?}");
        assert!((found[0].si / 0.010 * found[1].si / 2.0 - 1.0).abs() < 0.15, "{found:?}");
    }

    /// A catalogue of one actuator that is too slow below a value and too weak above another; both are exceeded by powers.
    fn window(low: f64, high: f64, value: f64) -> Ranked {
        let excess = [(CheckId::PeakSpeed, low / value), (CheckId::PeakTorque, (value / high).powi(2))];
        let failing: Vec<_> = excess.iter().filter(|(_, excess)| *excess > 1.0).map(|(check, _)| *check).collect();
        let is_near = excess.iter().all(|(_, excess)| *excess < FALL);
        Ranked {
            best: failing.is_empty().then(|| "the only one".to_owned()),
            near: is_near.then(|| (CandidateId::Own("the only one".to_owned()), failing)).into_iter().collect(),
        }
    }

    #[test]
    fn every_window_of_one_percent_is_found() {
        for place in 0..400 {
            // From a sixteenth to the sixteenfold, but for the value itself.
            let low = 15.5_f64.powf(f64::from(place) / 200.0 - 1.0);
            let high = low * 1.011;
            if (low..=high).contains(&1.0) {
                continue;
            }
            let ranked = |value: f64| Ok(window(low, high, value));
            let found = nearest(&ranked, 1.0, &window(low, high, 1.0), &ONE).unwrap();
            assert!(
                found.as_ref().is_some_and(|(value, _)| (low..=high).contains(value)),
                "{found:?} in {low} to {high}"
            );
        }
        let none = |value: f64| Ok(window(2.0, 1.9, value));
        assert_eq!(nearest(&none, 1.0, &window(2.0, 1.9, 1.0), &ONE).unwrap(), None);
    }

    #[test]
    fn a_value_is_rounded_to_where_it_fits() {
        assert!((rounded(0.061_3, true, &MILLIMETRE) - 0.062).abs() < 1e-12);
        assert!((rounded(0.061_3, false, &MILLIMETRE) - 0.061).abs() < 1e-12);
        assert!((rounded(0.333, false, &ONE) - 0.33).abs() < 1e-12);
    }
}
