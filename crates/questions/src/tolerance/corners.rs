//! The worst corner of the bands.

use super::{Judged, Point, PointKind, Worst};
use axis::{ALL_CORNERS_MOST, AxisProject, Varied, sign};
use sizing::StepObserver;

/// Largest number of passes of a search over all quantities; each pass but the last finds a worse corner.
const PASSES_MOST: usize = 20;

/// Returns the worst corner for each actuator.
pub(super) fn worst<W: StepObserver>(
    (project, varied): (&AxisProject, &Varied<'_>),
    judged: &[Judged<'_>],
    rising: &[Vec<f64>],
    watch: &W,
) -> Result<Vec<Worst>, W::Stop> {
    let mut varied = varied.clone();
    if project.tolerances.len() <= ALL_CORNERS_MOST {
        return of_all(project, &mut varied, judged, watch);
    }
    let cost = super::work::cost_of_a_variant(project, 1);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss, reason = "a count")]
    let looks = (super::work::FOR_CORNERS / (cost * judged.len() as f64)) as usize;
    judged
        .iter()
        .zip(rising)
        .map(|(judged, rising)| searched((project, &mut varied), judged, rising, (looks, watch)))
        .collect()
}

fn values(project: &AxisProject, sign: impl Fn(usize) -> f64) -> Vec<f64> {
    project.tolerances.iter().enumerate().map(|(index, each)| each.at(sign(index))).collect()
}

/// Returns the worst of all corners, each created once for all actuators; among equally bad ones the first.
fn of_all<W: StepObserver>(
    project: &AxisProject,
    varied: &mut Varied<'_>,
    judged: &[Judged<'_>],
    watch: &W,
) -> Result<Vec<Worst>, W::Stop> {
    let mut found: Vec<Option<(Point, usize)>> = vec![None; judged.len()];
    for corner in 0..1_usize << project.tolerances.len() {
        watch.step()?;
        let variant = varied.at(&values(project, |index| sign(corner, index))).ok();
        for (best, judged) in found.iter_mut().zip(judged) {
            let here = variant.as_ref().map_or(Point::IMPOSSIBLE, |variant| Point::of(judged, project, variant));
            if best.as_ref().is_none_or(|(point, _)| here.is_worse_than(point)) {
                *best = Some((here, corner));
            }
        }
    }
    let found = found
        .into_iter()
        .map(|best| {
            let (point, corner) = best.unwrap_or((Point::IMPOSSIBLE, 0));
            point.at(values(project, |index| sign(corner, index)), PointKind::Corner)
        })
        .collect();
    Ok(found)
}

/// Returns the worst corner found by changing one quantity at a time, from all quantities low, all high, and the corner
/// towards which the samples become worse.
///
/// `looks`: number of evaluations after which the search ends; the starts are always evaluated.
fn searched<W: StepObserver>(
    (project, varied): (&AxisProject, &mut Varied<'_>),
    judged: &Judged<'_>,
    rising: &[f64],
    (mut looks, watch): (usize, &W),
) -> Result<Worst, W::Stop> {
    let count = project.tolerances.len();
    let upwards: Vec<f64> = rising.iter().map(|rho| if *rho < 0.0 { -1.0 } else { 1.0 }).collect();
    let mut best: Option<(Point, Vec<f64>)> = None;
    for start in [vec![-1.0; count], vec![1.0; count], upwards] {
        let mut signs = start;
        let mut look = |signs: &[f64]| {
            watch.step()?;
            let at = values(project, |index| signs.get(index).copied().unwrap_or(1.0));
            Ok(Point::judged_at(varied, judged, &at))
        };
        let mut here = look(&signs)?;
        'search: for _ in 0..PASSES_MOST {
            let mut better = false;
            for index in 0..count {
                if looks == 0 {
                    break 'search;
                }
                looks -= 1;
                let mut flipped = signs.clone();
                if let Some(sign) = flipped.get_mut(index) {
                    *sign = -*sign;
                }
                let there = look(&flipped)?;
                if there.is_worse_than(&here) {
                    (here, signs, better) = (there, flipped, true);
                }
            }
            if !better {
                break;
            }
        }
        if best.as_ref().is_none_or(|(point, _)| here.is_worse_than(point)) {
            best = Some((here, signs));
        }
    }
    let (point, signs) = best.unwrap_or_else(|| (Point::IMPOSSIBLE, vec![1.0; count]));
    Ok(point.at(values(project, |index| signs.get(index).copied().unwrap_or(1.0)), PointKind::SearchedCorner))
}
