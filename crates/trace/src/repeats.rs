//! Detection of repeated panels: a move that recurs in the cycle is evaluated once.

use super::{Kept, Like, Node};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// Minimum number of panels for the search for repetitions; below it, evaluating every panel is cheaper.
const WORTH_IT: usize = 32;

/// Relative tolerance for equal signals, as a share of the largest magnitude of each signal. Sums over the cycle round
/// no better, and peaks are located no more precisely.
const SAME: f64 = 1e-12;

/// Marks each panel that repeats an earlier one.
///
/// Signals are compared as integer multiples of [`SAME`]. Rounding can put equal signals on either side of a step; such
/// panels count as different, which costs time but changes no result.
///
/// Cost: O(n log n) over the nodes.
pub(super) fn find(nodes: &[Node], panels: &mut [Kept]) {
    let worth_it = panels.len() >= WORTH_IT;
    let steps = if worth_it { steps(nodes) } else { [0.0; 4] };
    let mut known: BTreeMap<Vec<i64>, usize> = BTreeMap::new();
    let mut repeated = vec![false; if worth_it { panels.len() } else { 0 }];
    for (index, kept) in panels.iter_mut().enumerate() {
        kept.like = Like { first: index, is_copy: false, has_others: false };
        if !worth_it {
            continue;
        }
        let within = nodes.get(kept.nodes.clone()).unwrap_or_default();
        match known.entry(signature(within, kept.duration, &steps)) {
            Entry::Occupied(first) => {
                kept.like = Like { first: *first.get(), is_copy: true, has_others: true };
                repeated.iter_mut().skip(*first.get()).take(1).for_each(|repeated| *repeated = true);
            }
            Entry::Vacant(free) => {
                free.insert(index);
            }
        }
    }
    for (kept, repeated) in panels.iter_mut().zip(repeated) {
        kept.like.has_others |= repeated;
    }
}

/// Returns the number of comparison steps per unit of each signal.
fn steps(nodes: &[Node]) -> [f64; 4] {
    let largest = nodes.iter().fold([0.0_f64; 4], |mut most, node| {
        most.iter_mut().zip(node.signals()).for_each(|(most, x)| *most = most.max(x.abs()));
        most
    });
    largest.map(|largest| if largest > 0.0 { 1.0 / (SAME * largest) } else { 0.0 })
}

/// Returns the duration of a panel and the signals at its nodes as whole numbers of comparison steps.
fn signature(nodes: &[Node], duration: f64, steps: &[f64; 4]) -> Vec<i64> {
    #[allow(clippy::cast_possible_truncation, reason = "at most 10¹² steps")]
    let whole = |x: f64| x.round() as i64;
    // A duration is a difference of instants, which round by 10⁻¹⁶ of the cycle.
    let lasts = f64::from_bits((duration.to_bits() + (1 << 19)) & !((1 << 20) - 1));
    let signals = nodes.iter().flat_map(|node| {
        let [a, t, s, w] = node.signals();
        let [steps_a, steps_t, steps_s, steps_w] = steps;
        [whole(a * steps_a), whole(t * steps_t), whole(s * steps_s), whole(w * steps_w)]
    });
    [lasts.to_bits().cast_signed()].into_iter().chain(signals).collect()
}

#[cfg(test)]
mod tests {
    use crate::lag_tests::under;
    use crate::tests::{arm, law, motion};
    use crate::{Any, Form, Lag, Like, TorqueWith, Trace};
    use motion::{Law, SegmentSpec};

    /// Returns back-and-forth swings of an arm in groups of different angles.
    fn swings(angles: &[f64], rounds: usize) -> Vec<SegmentSpec> {
        let there_and_back = |angle: &f64| [*angle, -*angle].map(|angle| law(Law::ModifiedSine, angle, 0.6));
        (0..rounds).flat_map(|_| angles.iter().flat_map(there_and_back)).collect()
    }

    /// Returns a copy of the trace in which no panel is marked as repeated.
    fn unmarked(trace: &Trace) -> Trace {
        let mut plain = trace.clone();
        for (index, kept) in plain.panels.iter_mut().enumerate() {
            kept.like = Like { first: index, is_copy: false, has_others: false };
        }
        plain
    }

    fn same(a: f64, b: f64, what: &str) {
        assert!((a - b).abs() <= 2e-10 * b.abs(), "{what}: {a} {b}");
    }

    #[test]
    fn moves_that_repeat_are_known_and_change_no_answer() {
        for (angles, rounds) in [(&[1.2][..], 40), (&[0.7, 1.9, 0.3], 15), (&[1.0, 1.01], 30)] {
            let trace = under(&arm(), &motion(&swings(angles, rounds)));
            let copies = trace.panels.iter().filter(|kept| kept.like.is_copy).count();
            // The first round is original; rounding puts some panels of later rounds on the other side of a comparison
            // step.
            let most = trace.panels.len() * (rounds - 1) / rounds;
            assert!(copies <= most && copies as f64 > 0.9 * most as f64, "{copies} of {}", trace.panels.len());
            let plain = unmarked(&trace);
            for inertia_kgm2 in [0.0, 0.4, 3.0] {
                let sought = TorqueWith { inertia_kgm2 };
                let ((a, at), (b, of)) = (trace.largest(&sought), plain.largest(&sought));
                same(a, b, "torque");
                assert!((at.time_s - of.time_s).abs() < 1e-9, "the first instant: {} {}", at.time_s, of.time_s);
                let power = Any(
                    |extent: &crate::Extent| extent.torque(inertia_kgm2) * extent.speed_rad_s,
                    |node: &crate::Node| (inertia_kgm2 * node.acceleration_rad_s2 + node.load_nm) * node.speed_rad_s,
                );
                same(trace.largest(&power).0, plain.largest(&power).0, "power");
            }
            for taus in [[8.0, 0.6], [60.0, 2400.0], [0.05, 3.0]] {
                let form = Form::square([0.3, 0.9, 1.1, 0.4]);
                let lags = taus.map(|tau_s| Lag { tau_s, form });
                same(trace.peak_of_lags(&lags).value, plain.peak_of_lags(&lags).value, "lags");
            }
        }
    }

    /// A trace changed to another load equals a trace built from scratch, with and without repeated panels.
    #[test]
    fn a_changed_trace_is_that_made_anew() {
        for (angles, rounds) in [(&[0.7, 1.9, 0.3][..], 15), (&[0.5, 0.9, 1.4, 1.7, 0.2, 1.1, 0.8, 1.6], 1)] {
            let motion = motion(&swings(angles, rounds));
            let first = under(&arm(), &motion);
            let heavier = arm().with_masses(1.7);
            let changed = first.changed(&heavier, &motion, &[], &[]);
            let anew = Trace::of(&heavier, &motion, &[], &[]);
            let form = Form::square([0.3, 0.9, 1.1, 0.4]);
            for taus in [[8.0, 0.6], [60.0, 2400.0], [0.05, 3.0]] {
                let lags = taus.map(|tau_s| Lag { tau_s, form });
                same(changed.peak_of_lags(&lags).value, anew.peak_of_lags(&lags).value, "lags");
            }
            let sought = TorqueWith { inertia_kgm2: 0.4 };
            same(changed.largest(&sought).0, anew.largest(&sought).0, "torque");
        }
    }

    /// Moves that differ by a millionth count as different.
    #[test]
    fn what_nearly_repeats_does_not() {
        let segments: Vec<SegmentSpec> = (0..40).flat_map(|k| swings(&[1.2 + 1e-6 * f64::from(k)], 1)).collect();
        let trace = under(&arm(), &motion(&segments));
        assert!(trace.panels.len() >= super::WORTH_IT);
        let moving = trace.panels.iter().filter(|kept| kept.like.is_copy).count();
        assert_eq!(moving, 0);
    }
}
