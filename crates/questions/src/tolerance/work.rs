//! Cost of judging tolerances, known before the work begins.

use super::{Draw, SAMPLES_MOST, SAMPLES_USUAL};
use axis::{ALL_CORNERS_MOST, AxisProject};

/// Default limit of the work: some seconds. The unit is the work for one instant of a cycle under a load that depends
/// on the position, about a microsecond on a slow core.
const USUAL: f64 = 3e6;

/// Largest work without a time limit, independent of the number of samples: ten seconds for a long recording, less for
/// others.
const MOST: f64 = 1e7;

/// Largest work of a search for the worst corner.
pub(super) const FOR_CORNERS: f64 = 1e6;

/// Work of an instant whose load does not depend on the position.
const PLAIN: f64 = 0.4;

/// Work of an instant at which the loads on the flange are computed for one bearing.
const ON_THE_FLANGE: f64 = 0.45;

/// Work of an instant at which the tension of the ropes is computed.
const OF_ROPES: f64 = 0.25;

/// Work of an actuator besides that of its instants, and that of a piece of the motion.
const ACTUATOR: f64 = 10.0;
const PIECE: f64 = 1.0;

/// Number of bearings of the actuators judged for a variant: neighbours in a ranking share theirs.
const BEARINGS: usize = 4;

/// Returns the work for creating one variant of the axis and judging some actuators for it: each evaluates the bounds
/// of all blocks of the cycle and the content of some of them.
#[allow(clippy::cast_precision_loss, reason = "counts far below 2^52")]
pub(super) fn cost_of_a_variant(project: &AxisProject, actuators: usize) -> f64 {
    let instants = project.axis.instants() as f64;
    let made = if project.axis.mechanism.depends_on_position() { instants } else { PLAIN * instants };
    let flange: f64 = project.axis.flange_instants().iter().sum();
    let variant = PIECE * project.axis.motion.pieces().len() as f64 + OF_ROPES * project.axis.rope_instants();
    variant
        + 1.5 * made
        + actuators as f64 * (ACTUATOR + 0.125 * instants)
        + ON_THE_FLANGE * flange * actuators.min(BEARINGS) as f64
}

/// Limit of the work during typing: up to a second.
const QUICK: f64 = 1e6;

/// Returns `true` if this number of samples can be judged during typing.
pub(super) fn is_quick(project: &AxisProject, actuators: usize, samples: usize) -> bool {
    work(project, actuators, samples) <= QUICK
}

/// Work of five seconds, without and with a recording: with a long recording a variant is slower, since all of its
/// samples are processed again.
const FIVE_SECONDS: [f64; 2] = [1.4e7, 5e6];

/// Returns the share of five seconds that judging the tolerances of a project takes; zero for a sampling that is
/// refused.
pub(crate) fn share(project: &AxisProject, actuators: usize, draw: Draw) -> f64 {
    let Ok(sampling) = draw.sampling(project, actuators, false) else { return 0.0 };
    let [recorded, _] = project.axis.samples();
    let [short, long] = FIVE_SECONDS;
    let most = if recorded == 0 { short } else { long };
    if project.tolerances.is_empty() { 0.0 } else { work(project, actuators, sampling.samples) / most }
}

/// Returns the work for this number of samples and the corners.
fn work(project: &AxisProject, actuators: usize, samples: usize) -> f64 {
    #[allow(clippy::cast_precision_loss, reason = "at most a million")]
    let points = (samples + corners(project)) as f64;
    points * cost_of_a_variant(project, actuators)
}

/// Returns the largest number of corners that are evaluated.
fn corners(project: &AxisProject) -> usize {
    1_usize << project.tolerances.len().min(ALL_CORNERS_MOST)
}

/// Default numbers of samples, the largest first.
const STEPS: [usize; 7] = [SAMPLES_USUAL, 5_000, 2_000, 1_000, 500, 200, 100];

/// Returns the default number of samples of a project for some actuators: ten thousand, or fewer if these would exceed
/// some seconds.
pub(super) fn samples_usual(project: &AxisProject, actuators: usize) -> usize {
    let fits = |samples: &&usize| work(project, actuators, **samples) <= USUAL;
    STEPS.iter().find(fits).copied().unwrap_or(100)
}

/// Returns the largest number of samples of a project for some actuators, besides the corners, without a time limit.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to a million")]
pub(super) fn samples_most(project: &AxisProject, actuators: usize) -> usize {
    let points = (MOST / cost_of_a_variant(project, actuators)) as usize;
    points.saturating_sub(corners(project)).min(SAMPLES_MOST)
}
