//! Kinks of a load over the position: instants at which a motion passes them, and their number.

use mechanism::{Endless, Mechanism};
use motion::{Piece, Placed};
use numeric::root;
use std::f64::consts::TAU;

/// Visits the kinks strictly between two positions in the order in which they are passed. `kinks` is in rising order;
/// for a load with the period of one revolution they recur at every revolution.
pub(crate) fn passed(kinks: &[f64], endless: Endless, from: f64, to: f64, look: &mut dyn FnMut(f64)) {
    let (low, high) = (from.min(to), from.max(to));
    let turns =
        |end: f64, kink: f64| if endless == Endless::EachRevolution { ((end - kink) / TAU).floor() } else { 0.0 };
    let (Some(first), Some(last)) = (kinks.first(), kinks.last()) else { return };
    let (begin, end) = (turns(low, *last), turns(high, *first));
    let count = (end - begin).max(0.0) as usize;
    let mut turn = |n: usize| {
        let offset = TAU * (begin + n as f64);
        let first = kinks.partition_point(|kink| kink + offset <= low);
        let inside = kinks.get(first..).unwrap_or_default();
        let inside = inside.get(..inside.partition_point(|kink| kink + offset < high)).unwrap_or_default();
        if to >= from {
            inside.iter().for_each(|kink| look(kink + offset));
        } else {
            inside.iter().rev().for_each(|kink| look(kink + offset));
        }
    };
    if to >= from { (0..=count).for_each(&mut turn) } else { (0..=count).rev().for_each(&mut turn) }
}

/// Returns the instants within a piece at which the position passes a kink of the load \[s\]. Between two reversals the
/// position is monotone, so each kink in between is passed once: the work grows with the passes, not with the number of
/// kinks.
#[must_use]
pub fn kink_passes(mechanism: &Mechanism, piece: &Piece) -> Vec<f64> {
    let (kinks, mut found) = (mechanism.kinks(), Vec::new());
    if kinks.is_empty() {
        return found;
    }
    let (state, ratio) = (piece.states(), mechanism.stage_ratio());
    let at = |t: f64| state(t).position_rad / ratio;
    let mut ends = piece.reversals();
    ends.push(piece.duration_s);
    let mut from = 0.0;
    for to in ends {
        let (a, b) = (at(from), at(to));
        // Each root bounds the next one: the position is monotone.
        let mut low = (from, a);
        passed(&kinks, mechanism.endless(), a, b, &mut |kink| {
            let beyond = |t: f64| at(t) - kink;
            let instant = root(beyond, (low.0, low.1 - kink), (to, b - kink), 0.0);
            found.push(instant);
            low = (instant, kink);
        });
        from = to;
    }
    found
}

/// Returns the approximate number of kink passes of a recording.
pub(crate) fn recorded_passes(mechanism: &Mechanism, kinks: &[f64], placed: &Placed) -> f64 {
    if kinks.is_empty() {
        return 0.0;
    }
    let (positions, ratio) = (placed.recorded.position_rad(), mechanism.stage_ratio());
    let pairs = positions.iter().zip(positions.iter().skip(1));
    pairs.map(|(a, b)| passes(mechanism, kinks, a / ratio, b / ratio)).sum()
}

/// Returns the approximate number of kinks between two positions.
pub(crate) fn passes(mechanism: &Mechanism, kinks: &[f64], from: f64, to: f64) -> f64 {
    if mechanism.endless() == Endless::EachRevolution {
        return (to - from).abs() / TAU * kinks.len() as f64;
    }
    let (low, high) = (from.min(to), from.max(to));
    let below = |end: f64| kinks.partition_point(|kink| *kink < end);
    below(high).saturating_sub(below(low)) as f64
}
