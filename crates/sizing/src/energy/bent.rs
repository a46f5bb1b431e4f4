//! Power over a panel in which the signals are no straight lines: cut where the torque or the power turns its sign.

use super::{Balance, CyclePower};
use motion::lobatto;
use trace::{Node, Panel};

/// Nodes of the rule for a part of a panel: exact for the power of signals of the sixth degree.
const NODES: usize = 8;

/// A share of a panel up to which the place of a cut is sought: energy beside it is of second order in what is left.
const CLOSE: f64 = 1e-8;

/// A way through one panel.
pub(super) struct Walk<'a, 'p> {
    panel: &'a Panel<'p>,
    power: &'a CyclePower<'a>,
    balance: &'a mut Balance,
    /// Where the part with one sign of torque and power began.
    from: f64,
    /// Whether the load drives in it.
    driven: bool,
}

impl<'a, 'p> Walk<'a, 'p> {
    pub(super) fn through(panel: &'a Panel<'p>, power: &'a CyclePower<'a>, balance: &'a mut Balance) {
        let driven = |node: &Node| power.torque(node) * node.direction < 0.0;
        let rule = lobatto(panel.nodes.len());
        let mut walk = Walk { panel, power, balance, from: 0.0, driven: panel.nodes.first().is_some_and(driven) };
        // Where nothing turns its sign the nodes of the panel themselves make its energy.
        let plain = panel.nodes.iter().all(|node| !driven(node))
            || panel.nodes.iter().all(|node| driven(node) && power.with(node, true) < 0.0);
        if plain {
            let taken: f64 = rule.iter().zip(panel.nodes).map(|((_, w), node)| w * power.with(node, walk.driven)).sum();
            walk.balance.part(taken * walk.duration());
            if walk.driven {
                walk.peak(|| rule.iter().map(|(s, _)| *s));
            }
        } else {
            let gaps = panel.nodes.iter().zip(panel.nodes.iter().skip(1)).zip(rule.iter().zip(rule.iter().skip(1)));
            for ((a, b), ((from, _), (to, _))) in gaps {
                walk.gap((*from, power.torque(a) * a.direction), (*to, power.torque(b) * b.direction));
            }
            walk.close(1.0);
        }
    }

    fn duration(&self) -> f64 {
        match self.panel.nodes {
            [first, .., last] => last.time_s - first.time_s,
            _ => 0.0,
        }
    }

    /// From one node to the next, with T σ at both.
    fn gap(&mut self, (from, a): (f64, f64), (to, b): (f64, f64)) {
        let (power, panel) = (self.power, self.panel);
        if a * b < 0.0 {
            let torque = |s: f64| {
                let node = panel.at(s);
                power.torque(&node) * node.direction
            };
            let zero = crossing(torque, (from, a), (to, b));
            self.stretch((from, zero), a < 0.0);
            self.stretch((zero, to), b < 0.0);
        } else {
            self.stretch((from, to), a + b < 0.0);
        }
    }

    /// From one instant to another with one sign of the torque.
    fn stretch(&mut self, (from, to): (f64, f64), driven: bool) {
        if driven != self.driven {
            self.close(from);
            self.driven = driven;
        }
        // Where the load does not drive current and speed have one direction, and nothing comes back.
        if !driven {
            return;
        }
        let (power, panel) = (self.power, self.panel);
        let at = |s: f64| power.with(&panel.at(s), true);
        let ((a, b), middle) = ((at(from), at(to)), 0.5 * (from + to));
        if a * b < 0.0 {
            self.close(crossing(at, (from, a), (to, b)));
        } else if a > 0.0 {
            let low = at(middle);
            if low < 0.0 {
                self.close(crossing(at, (from, a), (middle, low)));
                self.close(crossing(at, (middle, low), (to, b)));
            }
        }
    }

    /// The part up to an instant.
    fn close(&mut self, to: f64) {
        let length = to - self.from;
        if length > 0.0 {
            let at = |s: f64| self.power.with(&self.panel.at(self.from + s * length), self.driven);
            let taken: f64 = lobatto(NODES).iter().map(|(s, w)| w * at(*s)).sum();
            self.balance.part(taken * length * self.duration());
            if taken < 0.0 {
                let from = self.from;
                self.peak(|| lobatto(NODES).iter().map(move |(s, _)| from + s * length));
            }
        }
        self.from = to;
    }

    /// The largest power given back in a part: at one of the instants named, or where a parabola through it and its
    /// neighbours is highest, found anew from the instants that are there.
    fn peak<I: Iterator<Item = f64>>(&mut self, shares: impl Fn() -> I) {
        let back = |s: f64| -self.power.with(&self.panel.at(s), self.driven);
        let points = || shares().map(|s| (s, back(s)));
        let mut peak = points().fold(self.balance.peak, |peak, (_, value)| peak.max(value));
        for ((mut a, mut b), mut c) in points().zip(points().skip(1)).zip(points().skip(2)) {
            for _ in 0..4 {
                let Some((s, height)) = vertex(a, b, c).filter(|(_, height)| *height > peak) else { break };
                let found = (s, back(s));
                peak = peak.max(found.1);
                (a, b, c) = match (found.1 > b.1, s > b.0) {
                    (true, true) => (b, found, c),
                    (true, false) => (a, found, b),
                    (false, true) => (a, b, found),
                    (false, false) => (found, b, c),
                };
                if (height - found.1).abs() <= CLOSE * peak {
                    break;
                }
            }
        }
        self.balance.peak = peak;
    }
}

/// The vertex of the parabola through three points, strictly between the outer two.
fn vertex(a: (f64, f64), b: (f64, f64), c: (f64, f64)) -> Option<(f64, f64)> {
    let (left, right) = ((b.1 - a.1) / (b.0 - a.0), (c.1 - b.1) / (c.0 - b.0));
    let bend = (right - left) / (c.0 - a.0);
    let s = 0.5 * (a.0 + b.0 - left / bend);
    let height = a.1 + left * (s - a.0) + bend * (s - a.0) * (s - b.0);
    (bend < 0.0 && s > a.0 && s < c.0 && s != b.0).then_some((s, height))
}

/// Where a function passes zero between two instants with values of opposite sign: regula falsi, the end that stays
/// behind counted half (Illinois).
fn crossing(value: impl Fn(f64) -> f64, (mut a, mut at_a): (f64, f64), (mut b, mut at_b): (f64, f64)) -> f64 {
    let close = CLOSE * (b - a);
    let mut s = a;
    let mut kept = None;
    for _ in 0..60 {
        let before = s;
        s = b - at_b * (b - a) / (at_b - at_a);
        let here = value(s);
        if here == 0.0 || (s - before).abs() <= close {
            break;
        }
        let keeps_a = (here < 0.0) == (at_b < 0.0);
        let behind = if kept == Some(keeps_a) { 0.5 } else { 1.0 };
        if keeps_a {
            (b, at_b, at_a) = (s, here, behind * at_a);
        } else {
            (a, at_a, at_b) = (s, here, behind * at_b);
        }
        kept = Some(keeps_a);
    }
    s
}
