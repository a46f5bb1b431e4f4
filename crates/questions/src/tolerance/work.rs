//! What judging tolerances costs, known before it begins.

use super::{Draw, SAMPLES_MOST, SAMPLES_USUAL};
use project::{ALL_CORNERS_MOST, Project};

/// The unit is the work of one instant of a cycle under a load that depends on the position, about a microsecond on a slow
/// core. The default limit: some seconds.
const USUAL: f64 = 3e6;

/// So much is done where no time is named, however few samples that is: ten seconds of a long recording, less of others.
const MOST: f64 = 1e7;

/// So much a search for the worst corner may take.
pub(super) const FOR_CORNERS: f64 = 1e6;

/// An instant of a cycle whose load does not depend on the position is made this much faster.
const PLAIN: f64 = 0.2;

/// Work of an instant at which the loads on the flange are found for one bearing.
const ON_THE_FLANGE: f64 = 0.15;

/// Bearings of the actuators that are judged for a variant: neighbours in a ranking share theirs.
const BEARINGS: usize = 4;

/// Work to make one variant of the axis and to judge some actuators for it: each looks at all blocks of the cycle and into
/// some of them.
#[allow(clippy::cast_precision_loss, reason = "counts far below 2^52")]
pub(super) fn cost_of_a_variant(project: &Project, actuators: usize) -> f64 {
    let instants = project.axis.instants() as f64;
    let made = if project.axis.mechanism.depends_on_position() { instants } else { PLAIN * instants };
    let flange: f64 = project.axis.flange_instants().iter().sum();
    1.5 * made + actuators as f64 * (10.0 + 0.125 * instants) + ON_THE_FLANGE * flange * actuators.min(BEARINGS) as f64
}

/// Limit of the work while the user types: up to a second.
const QUICK: f64 = 1e6;

/// Whether so many samples are judged quickly.
pub(super) fn is_quick(project: &Project, actuators: usize, samples: usize) -> bool {
    work(project, actuators, samples) <= QUICK
}

/// So much is done in five seconds: of a long recording a variant is slower, since all of its samples pass once more.
const FIVE_SECONDS: [f64; 2] = [1.4e7, 5e6];

/// The share of five seconds that judging the tolerances of a project takes; none of what is refused by itself.
pub(crate) fn share(project: &Project, actuators: usize, draw: Draw) -> f64 {
    let Ok(sampling) = draw.sampling(project, actuators, false) else { return 0.0 };
    let [recorded, _] = project.axis.samples();
    let [short, long] = FIVE_SECONDS;
    let most = if recorded == 0 { short } else { long };
    if project.tolerances.is_empty() { 0.0 } else { work(project, actuators, sampling.samples) / most }
}

/// Work to judge so many samples and the corners.
fn work(project: &Project, actuators: usize, samples: usize) -> f64 {
    #[allow(clippy::cast_precision_loss, reason = "at most a million")]
    let points = (samples + corners(project)) as f64;
    points * cost_of_a_variant(project, actuators)
}

/// How many corners are looked at, at most.
fn corners(project: &Project) -> usize {
    1_usize << project.tolerances.len().min(ALL_CORNERS_MOST)
}

/// The numbers of samples that are taken unless the user says otherwise, the largest first.
const STEPS: [usize; 7] = [SAMPLES_USUAL, 5_000, 2_000, 1_000, 500, 200, 100];

/// How many samples of a project are judged for some actuators unless the user says otherwise: ten thousand, or fewer where
/// that would take longer than some seconds.
pub(super) fn samples_usual(project: &Project, actuators: usize) -> usize {
    let fits = |samples: &&usize| work(project, actuators, **samples) <= USUAL;
    STEPS.iter().find(fits).copied().unwrap_or(100)
}

/// The most samples of a project that are judged for some actuators, beside the corners, without a word about the time they
/// may take.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to a million")]
pub(super) fn samples_most(project: &Project, actuators: usize) -> usize {
    let points = (MOST / cost_of_a_variant(project, actuators)) as usize;
    points.saturating_sub(corners(project)).min(SAMPLES_MOST)
}
