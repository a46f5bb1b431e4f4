//! Power over a panel with curved signals: cut where the torque or the power changes its sign.

use super::{CyclePower, Returned};
use numeric::{highest, lobatto, root, vertex};
use std::cell::OnceCell;
use trace::{Node, Panel, Smooth, Sought};

/// Numbers of nodes of the rule for a part of a panel: exact for the power of signals of the sixth degree, and of those
/// of the second.
const NODES: [usize; 2] = [8, 4];

/// Largest number of nodes of a rule.
const MOST: usize = 16;

/// Tolerance of the position of a cut as a share of a panel: the error of the energy is of second order in it.
const CLOSE: f64 = 1e-8;

/// One walk through a panel.
pub(super) struct Walk<'a, 'p> {
    course: Course<'a, 'p>,
    /// Energy of each part in which the power has one sign, in order \[J\].
    parts: &'a mut Vec<f64>,
    /// Largest regenerated power so far \[W\].
    peak: f64,
    /// Start of the part with one sign of torque and power.
    from: f64,
    /// The load drives in that part.
    driven: bool,
}

/// Torque and power at any position of a panel: with enough nodes as polynomials through their values.
struct Course<'a, 'p> {
    panel: &'a Panel<'p>,
    power: &'a CyclePower<'a>,
    torque: OnceCell<Option<Smooth>>,
    /// Power if the load does not drive, and if it does.
    powers: [OnceCell<Option<Smooth>>; 2],
}

impl Course<'_, '_> {
    /// Returns the torque in the direction of the motion \[Nm\].
    fn along(&self, node: &Node) -> f64 {
        self.power.torque(node) * node.direction
    }

    fn along_at(&self, share: f64) -> f64 {
        let smooth = self.torque.get_or_init(|| self.panel.smooth(|node| self.along(node)));
        smooth.as_ref().map_or_else(|| self.along(&self.panel.at(share)), |smooth| smooth.at(share))
    }

    fn smooth(&self, driven: bool) -> Option<&Smooth> {
        let [no, yes] = &self.powers;
        let cell = if driven { yes } else { no };
        cell.get_or_init(|| self.panel.smooth(|node| self.power.with(node, driven))).as_ref()
    }

    fn at(&self, share: f64, driven: bool) -> f64 {
        let node = || self.power.with(&self.panel.at(share), driven);
        self.smooth(driven).map_or_else(node, |smooth| smooth.at(share))
    }

    /// Returns the power half-way between a node and the next.
    fn middle(&self, place: usize, driven: bool) -> f64 {
        let node = || self.power.with(&self.panel.middle(place), driven);
        self.smooth(driven).map_or_else(node, |smooth| smooth.middle(place))
    }
}

impl<'a, 'p> Walk<'a, 'p> {
    /// Appends the energies of the parts; returns the larger of `peak` and the largest regenerated power.
    pub(super) fn through(panel: &'a Panel<'p>, power: &'a CyclePower<'a>, peak: f64, parts: &'a mut Vec<f64>) -> f64 {
        let course = Course { panel, power, torque: OnceCell::new(), powers: [OnceCell::new(), OnceCell::new()] };
        let rule = lobatto(panel.nodes.len());
        let mut along = [0.0; MOST];
        along.iter_mut().zip(panel.nodes).for_each(|(along, node)| *along = course.along(node));
        let along = along.get(..panel.nodes.len()).unwrap_or_default();
        let driven = along.first().is_some_and(|along| *along < 0.0);
        // Without a change of sign the nodes of the panel give its energy directly.
        let plain = along.iter().all(|along| *along >= 0.0)
            || (along.iter().all(|along| *along < 0.0) && panel.nodes.iter().all(|node| power.with(node, true) < 0.0));
        let mut walk = Walk { course, parts, peak, from: 0.0, driven };
        if plain {
            walk.part((0.0, 1.0), rule, panel.nodes.iter().map(|node| power.with(node, driven)));
        } else {
            let gaps = panel.nodes.windows(2).zip(along.windows(2)).zip(rule.windows(2)).enumerate();
            for (place, ((nodes, along), rule)) in gaps {
                if let ([first, last], [a, b], [(from, _), (to, _)]) = (nodes, along, rule) {
                    walk.gap(place, (*from, first, *a), (*to, last, *b));
                }
            }
            walk.close(1.0);
        }
        walk.peak
    }

    fn duration(&self) -> f64 {
        match self.course.panel.nodes {
            [first, .., last] => last.time_s - first.time_s,
            _ => 0.0,
        }
    }

    /// Walks from one node to the next: position, instant and torque in the direction of the motion of both.
    fn gap(&mut self, place: usize, (from, first, a): (f64, &Node, f64), (to, last, b): (f64, &Node, f64)) {
        let power = |node: &Node| self.course.power.with(node, true);
        if a * b < 0.0 {
            let zero = root(|s| self.course.along_at(s), (from, a), (to, b), CLOSE * (to - from));
            let (first, at, last) = (power(first), self.course.at(zero, true), power(last));
            self.stretch((from, first), (zero, at), None, a < 0.0);
            self.stretch((zero, at), (to, last), None, b < 0.0);
        } else if a + b < 0.0 {
            let (first, last) = (power(first), power(last));
            self.stretch((from, first), (to, last), Some(place), true);
        } else {
            self.stretch((from, 0.0), (to, 0.0), None, false);
        }
    }

    /// Walks from one instant to another with one sign of the torque, with the power for a driving load; `gap` is the
    /// index of a complete gap.
    fn stretch(&mut self, (from, a): (f64, f64), (to, b): (f64, f64), gap: Option<usize>, driven: bool) {
        if driven != self.driven {
            self.close(from);
            self.driven = driven;
        }
        // If the load does not drive, current and speed have one direction, and no power is regenerated.
        if !driven {
            return;
        }
        let middle = 0.5 * (from + to);
        let close = CLOSE * (to - from);
        let at = |s: f64| self.course.at(s, true);
        if a * b < 0.0 {
            let zero = root(at, (from, a), (to, b), close);
            self.close(zero);
        } else {
            // Between two ends of one sign the power may have the other one: evaluated half-way, else at the vertex of
            // the parabola through the three.
            let low = gap.map_or_else(|| at(middle), |place| self.course.middle(place, true));
            let towards = |s: f64, value: f64| (s, -a.signum() * value);
            let turned = Some((middle, low)).filter(|(_, value)| a * value < 0.0).or_else(|| {
                let (s, _) = vertex(towards(from, a), towards(middle, low), towards(to, b))?;
                Some((s, at(s))).filter(|(_, value)| a * value < 0.0)
            });
            if let Some(turned) = turned {
                let zeros = [root(at, (from, a), turned, close), root(at, turned, (to, b), close)];
                zeros.into_iter().for_each(|zero| self.close(zero));
            }
        }
    }

    /// Closes the part at an instant.
    fn close(&mut self, to: f64) {
        let (from, length) = (self.from, to - self.from);
        self.from = to;
        if length <= 0.0 {
            return;
        }
        let (panel, power, driven) = (self.course.panel, self.course.power, self.driven);
        let [many, few] = NODES;
        let rule = lobatto(if panel.nodes.len() <= 3 { few } else { many });
        let powers = |s: &f64| power.with(&panel.at(from + s * length), driven);
        let Some(smooth) = self.course.smooth(driven) else {
            self.part((from, length), rule, rule.iter().map(|(s, _)| powers(s)));
            return;
        };
        let taken = (smooth.until(to) - smooth.until(from)) * self.duration();
        self.parts.push(taken);
        if taken < 0.0 && self.may_be_higher() {
            let mut points = [(0.0, 0.0); MOST];
            for (point, (s, _)) in points.iter_mut().zip(rule) {
                let share = from + s * length;
                *point = (share, -smooth.at(share));
            }
            self.update(points.get(..rule.len()).unwrap_or_default());
        }
    }

    /// Adds a part of some length by the power at the nodes of a rule.
    fn part(&mut self, (from, length): (f64, f64), rule: &[(f64, f64)], powers: impl Iterator<Item = f64>) {
        let mut back = [(0.0, 0.0); MOST];
        let mut taken = 0.0;
        for ((point, (s, w)), power) in back.iter_mut().zip(rule).zip(powers) {
            *point = (from + s * length, -power);
            taken += w * power;
        }
        self.parts.push(taken * length * self.duration());
        if taken < 0.0 && self.may_be_higher() {
            self.update(back.get(..rule.len()).unwrap_or_default());
        }
    }

    /// Returns `true` if the bounds of the panel allow more than the largest regenerated power so far.
    fn may_be_higher(&self) -> bool {
        let Course { panel, power, .. } = self.course;
        panel.extent().is_none_or(|extent| Returned(power).bound(extent) > self.peak)
    }

    /// Updates the largest regenerated power of a part: at one of the known instants, or at the vertex of a parabola
    /// through it and its neighbours, recomputed from the nodes.
    fn update(&mut self, points: &[(f64, f64)]) {
        let Course { panel, power, .. } = self.course;
        let back = |s: f64| -power.with(&panel.at(s), self.driven);
        let mut peak = points.iter().fold(self.peak, |peak, (_, value)| peak.max(*value));
        for three in points.windows(3) {
            let Ok(three) = <[_; 3]>::try_from(three) else { continue };
            peak = peak.max(highest(back, three, peak, CLOSE).1);
        }
        self.peak = peak;
    }
}
