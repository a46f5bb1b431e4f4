//! Values within tolerances, for all of which an axis must be possible.

use crate::catalogue::Catalogue;
use crate::draft::{build_actuator, prepare};
use crate::fault::{AxisDiagnostic, AxisFault, AxisReport};
use crate::source::AxisSource;
use project::{Hint, Tolerance};

/// Largest number of toleranced quantities for which every corner of their bands is checked: 2¹⁰ of them.
pub const ALL_CORNERS_MOST: usize = 10;

/// Returns the sign of a quantity at a corner: bit k of the corner is set if quantity k is at its upper end.
#[must_use]
pub const fn sign(corner: usize, quantity: usize) -> f64 {
    if corner >> quantity & 1 == 1 { 1.0 } else { -1.0 }
}

/// Reports the first tolerance within which the project cannot be built: each quantity at its ends with the others
/// nominal, and then, where these are possible, the corners.
pub(crate) fn hold(
    root: &AxisSource,
    catalogue: &dyn Catalogue,
    tolerances: &[Tolerance],
    report: &mut AxisReport<'_>,
) {
    let recorded: usize = root.recordings().map(|read| read.recording.time_s.len()).sum();
    let mut root = root.clone();
    let mut fails = |values: &[(&Tolerance, f64)], report: &AxisReport<'_>| {
        for (tolerance, share) in values {
            let _ = root.set(&tolerance.path, tolerance.at(*share));
        }
        let mut trial = AxisReport::new(report.text());
        let own = values.iter().any(|(tolerance, _)| tolerance.path.starts_with("actuator."));
        let built = prepare(&root, catalogue, &mut trial).is_some();
        if own {
            build_actuator(&root, catalogue, &mut trial);
        }
        for (tolerance, _) in values {
            let _ = root.set(&tolerance.path, tolerance.nominal);
        }
        let fault = trial.into_faults().into_iter().next();
        if built && fault.is_none() { None } else { Some(fault) }
    };
    let mut sound = true;
    for tolerance in tolerances {
        let found = [-1.0, 1.0].iter().find_map(|end| Some((*end, fails(&[(tolerance, *end)], report)?)));
        if let Some((end, fault)) = found {
            sound = false;
            let (fault, hint) = impossible(&[(tolerance, end)], fault);
            report.fault(tolerance.span.clone(), fault, hint);
        }
    }
    if !sound || tolerances.len() < 2 {
        return;
    }
    let all = tolerances.len() <= ALL_CORNERS_MOST && recorded << tolerances.len() <= SAMPLES_BUILT_MOST;
    // Of very many corners only the two with all quantities low or high.
    let corners = if all { 0..1 << tolerances.len() } else { 0..2 };
    for corner in corners {
        let end = |index: usize| if all { sign(corner, index) } else { sign(corner, 0) };
        let values: Vec<(&Tolerance, f64)> =
            tolerances.iter().enumerate().map(|(index, each)| (each, end(index))).collect();
        if let Some(fault) = fails(&values, report) {
            let (fault, hint) = impossible(&values, fault);
            let place = tolerances.first().map(|first| first.span.clone()).unwrap_or_default();
            report.fault(place, fault, hint);
            return;
        }
    }
}

/// Largest number of samples of recordings for the motions of the corners: about a third of a second.
const SAMPLES_BUILT_MOST: usize = 1 << 26;

/// Returns the fault of values within the tolerances for which the axis is impossible.
fn impossible(values: &[(&Tolerance, f64)], found: Option<AxisDiagnostic>) -> (AxisFault, Option<Hint>) {
    let (why, hint) = found.map_or((None, None), |found| (Some(Box::new(found.fault)), found.hint));
    let named = |(tolerance, end): &(&Tolerance, f64)| (tolerance.path.clone(), tolerance.at(*end), tolerance.unit);
    (AxisFault::ImpossibleWithin { values: values.iter().map(named).collect(), why }, hint)
}
