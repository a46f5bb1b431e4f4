//! The smallest changes of load and cycle time with which any actuator of the catalogue fits where none does.

use crate::gearing_proposals::{RankedAxis, is_long};
use crate::progress::Progress;
use crate::sizing_use::Refusal;
use axis::AxisProject;
use sizing::{AxisChange, Fit, Proviso, SAMPLES_ANEW, nearest_change};

/// A change of one quantity with which an actuator of the catalogue fits, judged as displayed.
#[derive(Clone, Debug, PartialEq)]
pub struct CatalogueReach {
    /// Changed quantity.
    pub change: AxisChange,
    /// Factor on the load or the payloads, or duration of the cycle \[s\].
    pub value: f64,
    /// Best actuator with this value.
    pub code: String,
    /// Verdict on the actuator.
    pub fit: Fit,
    /// Conditions of this verdict.
    pub proviso: Proviso,
}

/// Returns the shortest longer cycle, the largest payload and the largest load with which any actuator of the catalogue
/// fits, in this order; `None` if one fits already, or if the cycle is too long for some hundred rankings.
///
/// Cost: at most some forty rankings of the catalogue for each quantity, a few tenths of a second in total.
///
/// # Errors
/// [`Refusal::Stopped`] if the search was cancelled.
pub fn catalogue_reserve(project: &AxisProject, progress: &Progress) -> Result<Option<Vec<CatalogueReach>>, Refusal> {
    if is_long(project) || RankedAxis::of(project, progress)?.best.is_some() {
        return Ok(None);
    }
    let mut found = Vec::new();
    let mut changed = project.clone();
    for change in [AxisChange::CycleTime, AxisChange::Payload, AxisChange::Load] {
        let reach = nearest_change(&project.axis, change, SAMPLES_ANEW, |axis| {
            changed.axis = axis;
            RankedAxis::of(&changed, progress).map(|ranked| ranked.best)
        })?;
        if let Some((value, (code, fit, proviso))) = reach {
            found.push(CatalogueReach { change, value, code, fit, proviso });
        }
    }
    Ok(Some(found))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reserve_of;
    use crate::sizing_use::size;
    use quantities::Measure;

    /// Axes that no actuator moves, by the speed, the torque or the heat.
    fn projects() -> Vec<AxisProject> {
        let load = |inertia: &str, angle: &str, time: &str, payload: &str| {
            format!(
                "format = 1\n[load]\ninertia = \"{inertia}\"\n[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"{angle}\"\n\
                time = \"{time}\"\n{payload}[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"-{angle}\"\ntime = \"{time}\"\n\
                [[motion]]\nlaw = \"dwell\"\ntime = \"0.2 s\"\n"
            )
        };
        let payload = "payload_inertia = \"30 kg m^2\"\n";
        let lift = "format = 1\n[mechanism.screw]\nlead = \"20 mm\"\nmass = \"60 kg\"\ninclination = \"90 deg\"\n\
            [[motion]]\nlaw = \"modified_sine\"\ndistance = \"300 mm\"\ntime = \"2 s\"\n[[motion]]\nlaw = \"trapezoid\"\n\
            distance = \"-300 mm\"\ntime = \"3 s\"\n";
        [
            load("40 kg m^2", "90 deg", "0.4 s", ""),
            load("20 kg m^2", "60 deg", "0.35 s", payload),
            load("0.5 kg m^2", "270 deg", "0.3 s", ""),
            lift.to_owned(),
        ]
        .iter()
        .map(|text| crate::read(text).unwrap())
        .collect()
    }

    /// No candidate by itself fits with a smaller change; with the proposed one the named actuator is the best.
    #[test]
    fn no_actuator_of_the_catalogue_fits_with_a_smaller_change() {
        let progress = Progress::endless();
        let mut better = 0;
        for (index, project) in projects().iter().enumerate() {
            let found = catalogue_reserve(project, &progress).unwrap().unwrap();
            assert!(found.iter().any(|reach| reach.change == AxisChange::CycleTime), "{index}");
            let all = size(project);
            let nearest = all.named().unwrap();
            // The nearest, and some others spread over the catalogue, of each size.
            let drawn = all.candidates.iter().skip(index).step_by(29);
            for candidate in drawn.chain([nearest]).filter(|candidate| candidate.objections.is_empty()) {
                let own = reserve_of(project, candidate);
                let seconds = own.cycle_time.map(|reach| reach.value.si());
                let factors = [own.payload_factor, own.load_factor].map(|reach| reach.map(|reach| reach.value));
                for (change, value) in [
                    (AxisChange::CycleTime, seconds),
                    (AxisChange::Payload, factors[0]),
                    (AxisChange::Load, factors[1]),
                ] {
                    let Some(value) = value else { continue };
                    let reach = found.iter().find(|reach| reach.change == change);
                    let reach = reach.unwrap_or_else(|| panic!("{index}: {} has {change:?} {value}", candidate.id));
                    let excess =
                        if change == AxisChange::CycleTime { value / reach.value } else { reach.value / value };
                    // Both are rounded to four digits.
                    assert!(excess > 0.998, "{index}: {} with {value} before {reach:?}", candidate.id);
                    better += usize::from(excess > 1.01 && candidate.id == nearest.id);
                }
            }
        }
        assert!(better > 0, "the nearest actuator is not always the one with the smallest change");
    }

    #[test]
    fn nothing_is_proposed_where_an_actuator_fits() {
        let text = "format = 1\n[load]\ninertia = \"0.3 kg m^2\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n";
        assert_eq!(catalogue_reserve(&crate::read(text).unwrap(), &Progress::endless()), Ok(None));
        let progress = Progress::limited();
        progress.cancel();
        assert_eq!(catalogue_reserve(projects().first().unwrap(), &progress), Err(Refusal::Stopped));
    }
}
