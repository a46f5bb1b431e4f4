//! What would let an actuator fit where none does: another gearing of the load.

use crate::patience::Patience;
use crate::sizing_use::{Refusal, size_watched};
use project::{Gearing, Project};
use quantities::Unit;
use quantities::unit::ONE;

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

/// The nearest values of each key of the gearing with which an actuator of the catalogue fits, one change at a time. Nothing
/// where one fits already, or where the cycle is so long that some hundred rankings would keep the user waiting.
///
/// # Errors
/// [`Refusal::Stopped`] where it was cancelled.
pub fn mends(project: &Project, patience: &Patience) -> Result<Vec<Mend>, Refusal> {
    if !project.axis.is_short() || best(project, patience)?.is_some() {
        return Ok(Vec::new());
    }
    let mut found = Vec::new();
    for Gearing { path, si, unit } in project.gearings() {
        let with = |value: f64| project.with_value(&path, value);
        if let Some((si, code)) = nearest(&with, si, unit, patience)? {
            found.push(Mend { path: path.clone(), is_stated: true, si, unit, code });
        }
    }
    if project.axis.mechanism.stage.is_none() {
        let with = |ratio: f64| project.with_stage(ratio);
        if let Some((si, code)) = nearest(&with, 1.0, &ONE, patience)? {
            found.push(Mend { path: "stage.ratio".to_owned(), is_stated: false, si, unit: &ONE, code });
        }
    }
    Ok(found)
}

/// The best actuator of the catalogue, if one fits.
fn best(project: &Project, patience: &Patience) -> Result<Option<String>, Refusal> {
    Ok(size_watched(project, 0, patience)?.answer().map(|best| best.id.to_string()))
}

/// The value nearest to a stated one with which an actuator fits, and that actuator.
fn nearest(
    with: &dyn Fn(f64) -> Option<Project>,
    stated: f64,
    unit: &Unit,
    patience: &Patience,
) -> Result<Option<(f64, String)>, Refusal> {
    let code = |value: f64| with(value).map_or(Ok(None), |project| best(&project, patience));
    for step in 1..=STEPS {
        for sense in [1, -1] {
            let factor = |step: i32| STEP.powi(sense * step);
            let Some(mut found) = code(stated * factor(step))? else { continue };
            let (mut fits, mut misses) = (stated * factor(step), stated * factor(step - 1));
            for _ in 0..HALVINGS {
                let middle = (fits * misses).sqrt();
                match code(middle)? {
                    Some(better) => (fits, found) = (middle, better),
                    None => misses = middle,
                }
            }
            let rounded = rounded(fits, fits > misses, unit);
            return Ok(Some(match code(rounded)? {
                Some(code) => (rounded, code),
                None => (fits, found),
            }));
        }
    }
    Ok(None)
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
            assert_eq!(best(&with.unwrap(), &Patience::endless()).unwrap().as_ref(), Some(&mend.code));
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

    #[test]
    fn a_value_is_rounded_to_where_it_fits() {
        assert!((rounded(0.061_3, true, &MILLIMETRE) - 0.062).abs() < 1e-12);
        assert!((rounded(0.061_3, false, &MILLIMETRE) - 0.061).abs() < 1e-12);
        assert!((rounded(0.333, false, &ONE) - 0.33).abs() < 1e-12);
    }
}
