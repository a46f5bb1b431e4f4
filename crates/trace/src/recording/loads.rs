//! Loads of a recording under a load that depends on the position or has losses, computed once: the sines of an arm and
//! the lever of a crank cost more than all later evaluations of an interval.

use super::{LANES, Node, Panel, SHARED_FROM, Strip, in_two, parts};
use motion::Interval;

/// T_L at the beginning, in the middle and at the end of a part of an interval \[Nm\].
type Loads = [f64; 3];

/// Number of intervals per work item.
const GO: usize = 1 << 10;

/// Loads of all intervals with one panel of three nodes, or with two such panels on either side of a cut.
#[derive(Debug, Default)]
pub(super) struct Known {
    /// Loads of an interval with one panel. An interval with a cut has NaN and the index of the cut, any other interval
    /// only NaN.
    whole: Vec<Loads>,
    cuts: Vec<Cut>,
}

/// An interval split in two.
#[derive(Clone, Copy, Debug)]
struct Cut {
    /// Place of the cut as a share of the interval.
    at: f64,
    loads: [Loads; 2],
}

/// A part of an interval, between two shares of it, with its loads.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) loads: Loads,
}

impl Known {
    fn push(&mut self, pieces: [Option<Piece>; 2]) {
        let nothing = [f64::NAN; 3];
        self.whole.push(match pieces {
            [Some(only), None] => only.loads,
            [Some(first), Some(second)] => {
                self.cuts.push(Cut { at: first.to, loads: [first.loads, second.loads] });
                // Some millions at most.
                #[allow(clippy::cast_precision_loss, reason = "see above")]
                let place = (self.cuts.len() - 1) as f64;
                [f64::NAN, place, f64::NAN]
            }
            _ => nothing,
        });
    }

    fn extend(&mut self, other: &Self) {
        #[allow(clippy::cast_precision_loss, reason = "some millions at most")]
        let before = self.cuts.len() as f64;
        self.whole.extend(other.whole.iter().map(|loads| match loads {
            [first, place, last] if first.is_nan() => [*first, place + before, *last],
            loads => *loads,
        }));
        self.cuts.extend_from_slice(&other.cuts);
    }

    /// Returns the loads of [`LANES`] neighbouring intervals if each has one panel.
    #[inline]
    pub(super) fn whole(&self, from: usize) -> Option<&[Loads; LANES]> {
        let loads: &[Loads; LANES] = self.whole.get(from..from + LANES)?.try_into().ok()?;
        loads.iter().all(|[first, ..]| !first.is_nan()).then_some(loads)
    }

    /// Returns the pieces of an interval in chronological order; none for an interval with other panels.
    #[inline]
    pub(super) fn pieces(&self, index: usize) -> [Option<Piece>; 2] {
        match self.whole.get(index) {
            Some(loads) if !loads[0].is_nan() => [Some(Piece { from: 0.0, to: 1.0, loads: *loads }), None],
            Some([_, place, _]) if place.is_finite() => {
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a place")]
                let Some(Cut { at, loads: [first, second] }) = self.cuts.get(*place as usize) else { return [None; 2] };
                [Some(Piece { from: 0.0, to: *at, loads: *first }), Some(Piece { from: *at, to: 1.0, loads: *second })]
            }
            _ => [None; 2],
        }
    }
}

impl Piece {
    /// Returns the height of the middle above the straight line between the ends \[Nm\].
    pub(super) fn bend(&self) -> f64 {
        let [first, middle, last] = self.loads;
        middle - 0.5 * (first + last)
    }

    /// Visits the panel of a piece of an interval in which the axis does not reverse.
    #[inline]
    pub(super) fn panel(&self, interval: &Interval, direction: f64, look: &mut impl FnMut(Panel<'_>)) {
        let share = self.to - self.from;
        let duration = share * interval.duration_s;
        let acceleration = interval.acceleration_rad_s2();
        let [first, last] = interval.speed_rad_s;
        let rule = [(0.0, 1.0 / 6.0), (0.5, 4.0 / 6.0), (1.0, 1.0 / 6.0)];
        let mut nodes = [Node::default(); 3];
        for ((node, (s, weight)), load) in nodes.iter_mut().zip(rule).zip(self.loads) {
            let u = if s == 1.0 { self.to } else { self.from + s * share };
            *node = Node {
                time_s: interval.start_s + u * interval.duration_s,
                weight_s: weight * duration,
                acceleration_rad_s2: acceleration,
                speed_rad_s: first + u * (last - first),
                direction,
                load_nm: load,
            };
        }
        // A parabola rises above either half of its chord by a quarter of its bend.
        let bow = [0.0, 0.25 * self.bend().abs(), 0.0, 0.0];
        look(Panel::passing(&nodes, duration, bow));
    }
}

/// Returns the direction of an interval if it does not reverse.
#[inline]
pub(super) fn direction(interval: &Interval) -> Option<f64> {
    let mut parts = parts(interval);
    let (_, _, direction) = parts.next()?;
    parts.next().is_none().then_some(direction)
}

impl Strip {
    /// Computes the loads of all intervals.
    pub(super) fn find_loads(&self) -> Known {
        let count = self.placed.intervals();
        let goes: Vec<usize> = (0..count).step_by(GO).collect();
        let of = |from: &usize| {
            let mut known = Known::default();
            (*from..(from + GO).min(count)).for_each(|index| known.push(self.pieces_of(index)));
            known
        };
        let mut all = Known { whole: Vec::with_capacity(count), cuts: Vec::new() };
        in_two(&goes, count >= SHARED_FROM, &of).into_iter().for_each(|go| all.extend(&go));
        all.cuts.shrink_to_fit();
        all
    }

    /// Computes the pieces of an interval; none if it has panels with more nodes, more than two panels, or a reversal.
    fn pieces_of(&self, index: usize) -> [Option<Piece>; 2] {
        let none = [None; 2];
        let Some(interval) = self.surveyed.interval(index).filter(|interval| direction(interval).is_some()) else {
            return none;
        };
        let (mut pieces, mut count, mut until) = (none, 0, 0.0);
        self.bent_interval(&interval, &mut |panel| {
            let place = pieces.get_mut(count);
            count += if panel.nodes.len() == 3 { 1 } else { none.len() + 1 };
            if let ([a, b, c], Some(place)) = (panel.nodes, place) {
                let to = (c.time_s - interval.start_s) / interval.duration_s;
                *place = Some(Piece { from: until, to, loads: [a, b, c].map(|node| node.load_nm) });
                until = to;
            }
        });
        if count <= none.len() { pieces } else { none }
    }
}

#[cfg(test)]
mod tests {
    use crate::cells_tests::noisy;
    use crate::tests::{arm, lossless};
    use crate::{Node, Panel, Trace};

    /// Stored panels equal newly computed ones.
    #[test]
    fn known_panels_are_those_made_anew() {
        for (mechanism, is_cut) in [(lossless(), false), (arm(), true)] {
            let trace = Trace::of(&mechanism, &noisy(true), &[], &[]);
            let [strip] = trace.strips() else { panic!("not kept") };
            let (mut known, mut cut) = (0, 0);
            for index in 0..strip.intervals() {
                let mut bows = Vec::new();
                let mut all = |found: &mut Vec<Node>, panel: &Panel<'_>| {
                    found.extend_from_slice(panel.nodes);
                    bows.push(panel.bow[1]);
                };
                let (mut found, mut expected) = (Vec::new(), Vec::new());
                strip.raw_interval(index, &mut |panel| all(&mut found, &panel));
                strip.bent_interval(&strip.surveyed.interval(index).unwrap(), &mut |panel| all(&mut expected, &panel));
                assert_eq!(found.len(), expected.len());
                let (bows, expected_bows) = bows.split_at(bows.len() / 2);
                for (bow, expected) in bows.iter().zip(expected_bows) {
                    assert!((bow - expected).abs() <= 1e-11 * (1.0 + found[0].load_nm.abs()), "{bow} {expected}");
                }
                for (found, expected) in found.iter().zip(&expected) {
                    // A cut is located with the resolution of the time.
                    let [a, b] = [found, expected]
                        .map(|node| [node.time_s, node.speed_rad_s, node.load_nm, node.direction, node.weight_s]);
                    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-13 * (1.0 + b.abs())), "{a:?} {b:?}");
                }
                let pieces = strip.loads.pieces(index);
                known += usize::from(pieces[0].is_some());
                cut += usize::from(pieces[1].is_some());
            }
            assert!(known > 15_000 && known < strip.intervals(), "{known}");
            assert!(if is_cut { cut > 100 } else { cut == 0 }, "{cut}");
        }
    }
}
