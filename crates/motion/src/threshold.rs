//! Standstill below a stated speed: rests become zero, the ends of the moves stay.

use crate::stretch::runs;

/// Smallest number of samples of a rest between two moves.
const REST_LEAST: usize = 8;

/// Largest speed at which the end of a move may give way to an offset, relative to the quiet speed of the run.
const ABOVE_QUIET: f64 = 1.5;

/// Largest speed of a block of samples of a move that is still falling, relative to that of the block before.
const FALLING: f64 = 0.9;

/// Sets the speeds of an axis at rest, all of them below `least`, to zero.
///
/// The end of a move belongs to the move: it lasts to the first sample at zero or with another sign. Where the speeds
/// fall to an offset instead, it lasts to the slowest sample of the first `block` that is quiet and no longer falls, and
/// is stretched to end at zero there. A reversal or a dip without rest stays as it is. At both ends of a recording the
/// axis is at rest below the bound.
pub(crate) fn set_to_rest(speed: &mut [f64], least: f64, block: usize) {
    let block = block.max(REST_LEAST);
    for run in runs(speed, 0..speed.len(), least.next_down()) {
        let (from, to) = (run.start, run.end);
        let outside = |index: Option<usize>| index.and_then(|index| speed.get(index)).copied();
        let (before, behind) = (outside(from.checked_sub(1)), outside(Some(to)));
        let inside = speed.get(run.clone()).unwrap_or_default();
        let quiet = quiet(inside, block);
        let first = before.map(|moving| end_of_move(moving, inside.iter().copied(), quiet, block));
        let last = behind.map(|moving| end_of_move(moving, inside.iter().rev().copied(), quiet, block));
        let kept = |end: &Option<End>| end.as_ref().map_or(0, |end| end.samples);
        let rest = from + kept(&first)..to.saturating_sub(kept(&last));
        let is_between = before.is_some() && behind.is_some();
        if rest.is_empty() || is_between && rest.len() < REST_LEAST {
            continue;
        }
        let stretched = |end: &Option<End>, moving: Option<f64>| {
            end.as_ref().zip(moving).map(|(end, moving)| (end.offset, moving / (moving - end.offset)))
        };
        let (of_first, of_last) = (stretched(&first, before), stretched(&last, behind));
        for (range, stretch) in [(from..rest.start, of_first), (rest.end..to, of_last)] {
            let Some((offset, factor)) = stretch.filter(|(offset, _)| *offset != 0.0) else { continue };
            let ends = speed.get_mut(range).into_iter().flatten();
            ends.for_each(|speed| *speed = (*speed - offset) * factor);
        }
        speed.get_mut(rest).into_iter().flatten().for_each(|speed| *speed = 0.0);
    }
}

/// End of a move among speeds below a bound.
struct End {
    /// Number of samples.
    samples: usize,
    /// Speed at the first sample behind it if it does not reach zero [rad/s].
    offset: f64,
}

/// Returns the largest speed of the quiet samples of a run: the lower quartile of the largest speeds of its blocks.
fn quiet(speeds: &[f64], block: usize) -> f64 {
    let largest = |part: &[f64]| part.iter().fold(0.0_f64, |most, speed| most.max(speed.abs()));
    let mut all: Vec<f64> = speeds.chunks_exact(block.clamp(1, speeds.len().max(1))).map(largest).collect();
    let quarter = all.len() / 4;
    if quarter >= all.len() {
        return 0.0;
    }
    *all.select_nth_unstable_by(quarter, f64::total_cmp).1
}

/// Returns the end of a move with the speed `moving` among the speeds that follow it; `quiet` is the [`quiet`] speed of
/// the run.
fn end_of_move(moving: f64, speeds: impl Iterator<Item = f64>, quiet: f64, block: usize) -> End {
    let (mut slow, mut most, mut most_before) = (0, 0.0_f64, f64::INFINITY);
    let mut slowest = End { samples: 0, offset: f64::INFINITY };
    for (samples, speed) in speeds.enumerate() {
        if speed * moving <= 0.0 {
            return End { samples, offset: 0.0 };
        }
        let size = speed.abs();
        if size < slowest.offset.abs() {
            slowest = End { samples, offset: speed };
        }
        if size > ABOVE_QUIET * quiet {
            (slow, most, most_before) = (0, 0.0, f64::INFINITY);
            continue;
        }
        (slow, most) = (slow + 1, most.max(size));
        if slow == block {
            if most > FALLING * most_before {
                break;
            }
            (slow, most, most_before) = (0, 0.0, most);
        }
    }
    if slowest.offset.is_finite() { slowest } else { End { samples: 0, offset: 0.0 } }
}

#[cfg(test)]
#[path = "threshold_tests.rs"]
mod tests;
