//! Panels of a cycle that are like one another: a move that is made again and again need be looked into once.

use super::{Block, Kept, Like, Node, Place};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// In fewer panels nothing is sought: looking into all of them costs less.
const WORTH_IT: usize = 32;

/// Two signals that differ by less than this share of the largest one of their kind are the same: what adds up along the
/// cycle rounds no worse, and a peak is found no more closely.
const SAME: f64 = 1e-12;

/// Marks each panel that is like an earlier one, and each block that holds nothing else.
///
/// Signals are compared as whole numbers of [`SAME`]; of two that are equal but for rounding some fall to either side of a
/// step, and their panels are then taken for different ones, which costs time only.
///
/// Cost: O(n log n) over the nodes.
pub(super) fn find(nodes: &[Node], panels: &mut [Kept], blocks: &mut [Block]) {
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
    for block in blocks {
        if let Place::Kept(range) = &block.place {
            block.is_copy = panels.get(range.clone()).is_some_and(|panels| panels.iter().all(|kept| kept.like.is_copy));
        }
    }
}

/// How many steps each signal has to one of its unit.
fn steps(nodes: &[Node]) -> [f64; 4] {
    let largest = nodes.iter().fold([0.0_f64; 4], |mut most, node| {
        most.iter_mut().zip(node.signals()).for_each(|(most, x)| *most = most.max(x.abs()));
        most
    });
    largest.map(|largest| if largest > 0.0 { 1.0 / (SAME * largest) } else { 0.0 })
}

/// The signals of a panel's nodes as whole numbers of steps, and how long it lasts.
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
