//! Power over a panel in which the signals are no straight lines: cut where the torque or the power turns its sign.

use super::{CyclePower, Returned};
use motion::lobatto;
use trace::{Node, Panel, Sought, crossing};

/// Nodes of the rule for a part of a panel: exact for the power of signals of the sixth degree, and of those of the second.
const NODES: [usize; 2] = [8, 4];

/// Most nodes of a rule.
const MOST: usize = 16;

/// A share of a panel up to which the place of a cut is sought: energy beside it is of second order in what is left.
const CLOSE: f64 = 1e-8;

/// A way through one panel.
pub(super) struct Walk<'a, 'p> {
    panel: &'a Panel<'p>,
    power: &'a CyclePower<'a>,
    /// Energy of each part in which the power has one sign, in order \[J\].
    parts: &'a mut Vec<f64>,
    /// The largest power given back so far \[W\].
    peak: f64,
    /// Where the part with one sign of torque and power began.
    from: f64,
    /// Whether the load drives in it.
    driven: bool,
}

impl<'a, 'p> Walk<'a, 'p> {
    /// Adds the energies of the parts to those that are there; the larger of `peak` and the largest power given back.
    pub(super) fn through(panel: &'a Panel<'p>, power: &'a CyclePower<'a>, peak: f64, parts: &'a mut Vec<f64>) -> f64 {
        let driven = |node: &Node| power.torque(node) * node.direction < 0.0;
        let rule = lobatto(panel.nodes.len());
        let mut walk = Walk { panel, power, parts, peak, from: 0.0, driven: panel.nodes.first().is_some_and(driven) };
        // Where nothing turns its sign the nodes of the panel themselves make its energy.
        let plain = panel.nodes.iter().all(|node| !driven(node))
            || panel.nodes.iter().all(|node| driven(node) && power.with(node, true) < 0.0);
        if plain {
            let driven = walk.driven;
            walk.part((0.0, 1.0), rule, panel.nodes.iter().map(|node| power.with(node, driven)));
        } else {
            let gaps = panel.nodes.iter().zip(panel.nodes.iter().skip(1)).zip(rule.iter().zip(rule.iter().skip(1)));
            for (((a, b), ((from, _), (to, _))), middle) in gaps.zip(panel.middles()) {
                walk.gap((*from, a), (*to, b), &middle);
            }
            walk.close(1.0);
        }
        walk.peak
    }

    fn duration(&self) -> f64 {
        match self.panel.nodes {
            [first, .., last] => last.time_s - first.time_s,
            _ => 0.0,
        }
    }

    /// From one node to the next, with the instant half-way.
    fn gap(&mut self, (from, first): (f64, &Node), (to, last): (f64, &Node), middle: &Node) {
        let (power, panel) = (self.power, self.panel);
        let along = |node: &Node| power.torque(node) * node.direction;
        let (a, b) = (along(first), along(last));
        if a * b < 0.0 {
            let zero = crossing(|s| along(&panel.at(s)), (from, a), (to, b), CLOSE * (to - from));
            let at = panel.at(zero);
            self.stretch((from, first), (zero, &at), None, a < 0.0);
            self.stretch((zero, &at), (to, last), None, b < 0.0);
        } else {
            self.stretch((from, first), (to, last), Some(middle), a + b < 0.0);
        }
    }

    /// From one instant to another with one sign of the torque; the instant half-way if it is known.
    fn stretch(
        &mut self,
        (from, first): (f64, &Node),
        (to, last): (f64, &Node),
        half_way: Option<&Node>,
        driven: bool,
    ) {
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
        let ((a, b), middle) = ((power.with(first, true), power.with(last, true)), 0.5 * (from + to));
        let close = CLOSE * (to - from);
        if a * b < 0.0 {
            self.close(crossing(at, (from, a), (to, b), close));
        } else {
            // Between two ends of one sign the power may have the other one: looked for half-way, else at the vertex of the
            // parabola through the three.
            let low = half_way.map_or_else(|| at(middle), |node| power.with(node, true));
            let towards = |s: f64, value: f64| (s, -a.signum() * value);
            let turned = Some((middle, low)).filter(|(_, value)| a * value < 0.0).or_else(|| {
                let (s, _) = vertex(towards(from, a), towards(middle, low), towards(to, b))?;
                Some((s, at(s))).filter(|(_, value)| a * value < 0.0)
            });
            if let Some(turned) = turned {
                self.close(crossing(at, (from, a), turned, close));
                self.close(crossing(at, turned, (to, b), close));
            }
        }
    }

    /// The part up to an instant.
    fn close(&mut self, to: f64) {
        let (from, length) = (self.from, to - self.from);
        if length > 0.0 {
            let (panel, power, driven) = (self.panel, self.power, self.driven);
            let [many, few] = NODES;
            let rule = lobatto(if panel.nodes.len() <= 3 { few } else { many });
            self.part((from, length), rule, rule.iter().map(|(s, _)| power.with(&panel.at(from + s * length), driven)));
        }
        self.from = to;
    }

    /// A part of some length by the power at the nodes of a rule.
    fn part(&mut self, (from, length): (f64, f64), rule: &[(f64, f64)], powers: impl Iterator<Item = f64>) {
        let mut back = [(0.0, 0.0); MOST];
        let mut taken = 0.0;
        for ((point, (s, w)), power) in back.iter_mut().zip(rule).zip(powers) {
            *point = (from + s * length, -power);
            taken += w * power;
        }
        self.parts.push(taken * length * self.duration());
        if taken < 0.0 {
            self.look(back.get(..rule.len()).unwrap_or_default());
        }
    }

    /// The largest power given back in a part: at one of the instants that are known, or where a parabola through it and its
    /// neighbours is highest, found anew from the instants that are there.
    fn look(&mut self, points: &[(f64, f64)]) {
        if self.panel.extent().is_some_and(|extent| Returned(self.power).bound(extent) <= self.peak) {
            return;
        }
        let back = |s: f64| -self.power.with(&self.panel.at(s), self.driven);
        let mut peak = points.iter().fold(self.peak, |peak, (_, value)| peak.max(*value));
        for three in points.windows(3) {
            let [mut a, mut b, mut c] = *three else { continue };
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
        self.peak = peak;
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
