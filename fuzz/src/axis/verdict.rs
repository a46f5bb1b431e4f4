//! Conditions that every verdict must satisfy.

use super::Case;
use project::inputs;
use quantities::Measure;
use questions::{Candidate, CheckId, ProductId, Verdict, check, reserve_of};
use sizing::Note;

/// Checks that compared values are finite, and that the candidate fits if and only if no check and no requirement
/// objects.
pub(crate) fn candidate(candidate: &Candidate<'_>) {
    for check in &candidate.judgement.checks {
        let judged = check.verdict != Verdict::NotChecked;
        // Advice may follow from a cause other than a limit, such as swings too small for the bearing.
        let decided = matches!(check.verdict, Verdict::Pass | Verdict::Fail);
        // Where no speed is held, no distance to a resonance exists; a remark says so.
        let no_speed_held = check.id == CheckId::ResonanceSpeed && !check.notes.is_empty();
        // A bearing without load has neither a safety nor a life that ends; a remark says so.
        let unloaded = check.verdict == Verdict::Pass && check.notes.contains(&Note::NoBearingLoad);
        assert!(check.value.is_some() || !judged || no_speed_held || unloaded, "{check:?}");
        assert!(check.limit.is_some() || !decided || unloaded, "{check:?}");
        for figure in [check.value, check.limit] {
            assert!(figure.is_none_or(|figure| figure.si.is_finite() && figure.value().is_finite()), "{check:?}");
        }
        assert!(check.utilisation.is_none_or(|share| share.is_finite() && share >= 0.0), "{check:?}");
        assert!(check.at.is_none_or(|at| at.si().is_finite()), "{check:?}");
        assert!(judged || check.missing.is_some(), "{check:?}");
        if let (Verdict::Pass, Some(share)) = (check.verdict, check.utilisation) {
            assert!(share <= 1.0 + 1e-9, "passes beyond its limit: {check:?}");
        }
    }
    // Infinite if a limit of zero is exceeded: that candidate cannot fit.
    let share = candidate.standing.utilisation;
    assert!(share.is_finite() || (share == f64::INFINITY && !candidate.fits()), "{:?}", candidate.standing);
    let failing = candidate.judgement.checks.iter().any(|check| check.verdict == Verdict::Fail);
    assert_eq!(candidate.judgement_fits(), !failing, "{:?}", candidate.id);
    assert!(!(candidate.fits() && failing), "{:?}", candidate.id);
    // A requirement may stay open for a user's own actuator without being violated.
    let of_the_catalogue = !candidate.product.is_of_project();
    assert!(candidate.fits() || failing || !candidate.objections.is_empty(), "{:?}", candidate.id);
    assert!(!of_the_catalogue || !candidate.fits() || candidate.objections.is_empty(), "{:?}", candidate.id);
}

/// Checks that the actuator fits at the reserve and no longer beyond it, on the project with that value written into
/// it.
pub(super) fn reserve(case: &Case<'_>, code: &ProductId, judged: &Candidate<'_>) {
    let reserve = reserve_of(case.project, judged);
    let factors = [reserve.load_factor, reserve.payload_factor].map(|factor| factor.map(|reach| reach.value));
    assert!(factors.iter().flatten().all(|factor| factor.is_finite() && *factor > 0.0), "{reserve:?}");
    assert!(reserve.cycle_time.is_none_or(|time| time.value.si().is_finite() && time.value.si() > 0.0), "{reserve:?}");
    // One axis without a choice of ratios: a change of the load does not change the judged project.
    if case.text.contains("[[axis]]") || case.text.contains("ratios") {
        return;
    }
    if let Some(ambient) = reserve.ambient {
        let degrees = ambient.value.si() - 273.15;
        let at = |degrees: f64| fits_with(case, code, "ambient", &format!("{degrees} degC"));
        if let Some(below) = at(degrees - 1e-6) {
            assert!(below, "{code} does not fit at its highest ambient temperature of {degrees} °C");
        }
        // The search ends at 80 °C; the reserve is rounded down to four digits.
        if degrees < 79.9
            && let Some(above) = at(degrees + 0.02)
        {
            assert!(!above, "{code} fits above its highest ambient temperature of {degrees} °C");
        }
    }
    if ["payload", "[stage]"].iter().any(|other| case.text.contains(other)) {
        return;
    }
    let inertia = inputs(case.text).into_iter().find(|input| input.path == "load.inertia");
    if let (Some(factor), Some((inertia, unit))) =
        (reserve.load_factor.map(|reach| reach.value), inertia.and_then(|input| input.amount))
    {
        let at = |factor: f64| fits_with(case, code, "inertia", &format!("{} {}", inertia * factor, unit.ascii));
        assert!(at(factor * (1.0 - 1e-6)) != Some(false), "{code} does not fit at {factor} times its load");
        assert!(at(factor * 1.01) != Some(true), "{code} fits beyond {factor} times its load");
    }
}

/// Returns `true` if no check fails with another value of the first key with this name; `None` if the project cannot be
/// read.
fn fits_with(case: &Case<'_>, code: &ProductId, key: &str, value: &str) -> Option<bool> {
    let begin = format!("{key} = \"");
    let line = case.text.lines().find(|line| line.starts_with(&begin))?;
    let text = case.text.replacen(line, &format!("{begin}{value}\""), 1);
    let project = questions::read(&text).ok()?;
    Some(check(&project, code).ok()?.judgement_fits())
}
