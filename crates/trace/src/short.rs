//! A short cycle of straight panels, which every search evaluates as a whole.

use super::{Kept, Node, Trace};

/// The ends of the panels and the lines between them.
#[derive(Clone, Debug, Default)]
pub(super) struct Straight {
    /// End nodes of the panels; of neighbouring ones with the same signals the first.
    pub(super) ends: Vec<Node>,
    /// Both ends of each panel along which a signal changes.
    pub(super) lines: Vec<[Node; 2]>,
}

/// Number of preceding ends with which an end is compared: those of a move and its pause.
const NEIGHBOURS: usize = 8;

impl Straight {
    /// Collects ends and lines of a short cycle; `None` if the cycle is long or has a curved panel.
    pub(super) fn of(trace: &Trace) -> Option<Self> {
        if !trace.is_short() {
            return None;
        }
        let mut found = Self::default();
        for kept in &trace.panels {
            let [from, to] = trace.straight(kept)?;
            if kept.like.is_copy {
                continue;
            }
            for end in [from, to] {
                if found.ends.iter().rev().take(NEIGHBOURS).all(|known| known.signals() != end.signals()) {
                    found.ends.push(end);
                }
            }
            if from.signals() != to.signals() {
                found.lines.push([from, to]);
            }
        }
        Some(found)
    }
}

impl Trace {
    /// Returns both ends of a panel if it is straight.
    fn straight(&self, kept: &Kept) -> Option<[Node; 2]> {
        let panel = self.panel(kept);
        match panel.nodes {
            [from, .., to] if panel.is_straight() => Some([*from, *to]),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::lag_tests::under;
    use crate::tests::{direct, law, manual, motion};
    use crate::{Any, Convex, Extent, Node, TorqueWith, Trace};
    use motion::Law;

    /// Returns a copy of the trace that is searched like a long one.
    fn long(trace: &Trace) -> Trace {
        Trace { straight: None, ..trace.clone() }
    }

    #[test]
    fn a_short_cycle_of_straight_panels_has_the_peaks_of_its_blocks() {
        let moves = [manual(4.0, [0.1, 0.3, 0.25, 0.5]), manual(-2.5, [0.4, 0.0, 0.2, 0.05])];
        for count in [1, 2] {
            let trace = under(&direct(), &motion(moves.get(..count).unwrap_or_default()));
            assert!(trace.straight.is_some());
            let blocks = long(&trace);
            for inertia_kgm2 in [0.0, 0.4, 30.0, -2.0] {
                let sought = TorqueWith { inertia_kgm2 };
                assert_eq!(trace.largest(&sought), blocks.largest(&sought));
            }
            let current = |node: &Node| {
                let [a, t, s, w] = node.signals();
                (0.7 * a + t + 3.0 * s + 0.9 * w).abs()
            };
            let bound = |extent: &Extent| {
                let (low, high) = extent.range([0.7, 1.0, 3.0, 0.9]);
                high.max(-low)
            };
            let sought = Convex(bound, current);
            assert_eq!(trace.largest(&sought), blocks.largest(&sought));
            // The maximum lies between two ends: power that falls again while the speed still rises.
            let bent = |speed: f64, torque: f64| speed * (60.0 - 9.0 * speed) + 0.01 * torque;
            let sought = Any(
                |extent: &Extent| 100.0 + 0.01 * extent.torque(1.0),
                |node: &Node| bent(node.speed_rad_s.abs(), node.load_nm),
            );
            let ((found, at), (expected, place)) = (trace.largest(&sought), blocks.largest(&sought));
            assert!((found - expected).abs() <= 1e-9 * expected, "{found} {expected}");
            assert!((at.time_s - place.time_s).abs() < 1e-4, "{} {}", at.time_s, place.time_s);
            assert!(found > 99.9, "60·ω − 9·ω² has 100 at ω = 10/3: {found}");
        }
    }

    #[test]
    fn what_bends_or_is_long_is_searched_by_its_blocks() {
        let bent = motion(&[law(Law::ModifiedSine, 1.4, 0.6), law(Law::ModifiedSine, -1.4, 0.6)]);
        assert!(under(&direct(), &bent).straight.is_none());
        let many: Vec<_> = (1..200).map(|k| manual(4.0 + 0.01 * f64::from(k), [0.1, 0.3, 0.25, 0.5])).collect();
        assert!(under(&direct(), &motion(&many)).straight.is_none());
    }
}
