//! Panels of an interval whose load depends on the position or has losses: split where the losses change sides and at
//! the kinks of the load, with a number of nodes that grows with the angle turned.

use super::super::kinks::passed;
use super::{NODES, Node, Panel, Strip, parts};
use mechanism::{Extra, Output};
use motion::Interval;
use numeric::{lobatto, root};
use quantities::{Measure, Torque};

/// Largest angle turned in an interval for 3, 5 and 9 nodes \[rad\]; beyond, 16 are used. From the error of the rule
/// for cos³.
const TURNED: [(f64, usize); 3] = [(0.01, 3), (0.1, 5), (0.5, 9)];

/// Tolerance for the place of a cut, as a share of the interval searched.
const CLOSE: f64 = 1e-14;

/// Distance of a node from a kink of the load, as a share of the panel; the node lies on its own side.
const BESIDE: f64 = 1e-9;

impl Strip {
    /// Visits the panels of an interval with a curved load.
    pub(super) fn bent_interval(&self, interval: &Interval, look: &mut impl FnMut(Panel<'_>)) {
        let lossy = self.mechanism.has_losses();
        let plain = self.plain.is_some() || !lossy && self.mechanism.stage.is_none() && self.kinks.is_empty();
        for (from, to, direction) in parts(interval) {
            if plain {
                self.bent_panel(interval, (from, to, direction), look);
                continue;
            }
            let mut cuts = vec![from];
            if direction != 0.0 {
                self.switches(interval, (from, to, direction), lossy, &mut cuts);
            }
            self.corners(interval, (from, to), &mut cuts);
            cuts.push(to);
            cuts.sort_by(f64::total_cmp);
            for (from, to) in cuts.iter().zip(cuts.iter().skip(1)).filter(|(from, to)| to > from) {
                self.bent_panel(interval, (*from, *to, direction), look);
            }
        }
    }

    fn output(interval: &Interval, u: f64, direction: f64) -> (Output, f64) {
        let (position_rad, speed_rad_s, torque) = interval.at(u);
        (Output { position_rad, speed_rad_s, acceleration_rad_s2: interval.acceleration_rad_s2(), direction }, torque)
    }

    fn with_recorded(&self, torque: f64) -> Extra {
        Extra { torque: self.extra.torque + Torque::from_si(torque), ..self.extra }
    }

    /// Adds the places at which the power before the losses changes its sign.
    fn switches(&self, interval: &Interval, (from, to, direction): (f64, f64, f64), lossy: bool, cuts: &mut Vec<f64>) {
        let useful = |u: f64| {
            let (output, torque) = Self::output(interval, u, direction);
            self.mechanism.useful_torque(&output, &self.with_recorded(torque))
        };
        if lossy {
            crossings(&useful, from, to, cuts);
        }
        if self.mechanism.has_lossy_sheaves() {
            let ropes = |u: f64| {
                let (output, torque) = Self::output(interval, u, direction);
                self.mechanism.loading(&self.with_recorded(torque)).at(&output).ropes_nm
            };
            crossings(&ropes, from, to, cuts);
        }
        if self.mechanism.stage.is_some() {
            let handed_on = |u: f64| {
                let (output, torque) = Self::output(interval, u, direction);
                self.mechanism.stage_torque(&output, &self.with_recorded(torque))
            };
            crossings(&handed_on, from, to, cuts);
        }
    }

    /// Adds the places at which the position passes a kink of the load.
    fn corners(&self, interval: &Interval, (from, to): (f64, f64), cuts: &mut Vec<f64>) {
        if self.kinks.is_empty() {
            return;
        }
        let ratio = self.mechanism.stage_ratio();
        let at = |u: f64| interval.at(u).0 / ratio;
        // Within an interval the speed is straight, so the position is monotone between the parts of an interval, which
        // end where the speed changes its sign. The ends and the middle are sampled.
        let middle = 0.5 * (from + to);
        for (low, high) in [(from, middle), (middle, to)] {
            passed(&self.kinks, self.mechanism.endless(), at(low), at(high), &mut |kink| {
                let beyond = |u: f64| at(u) - kink;
                cuts.push(root(beyond, (low, beyond(low)), (high, beyond(high)), CLOSE * (high - low)));
            });
        }
    }

    fn bent_panel(
        &self,
        interval: &Interval,
        (from, to, direction): (f64, f64, f64),
        look: &mut impl FnMut(Panel<'_>),
    ) {
        let turned = (interval.at(to).0 - interval.at(from).0).abs() / self.mechanism.stage_ratio();
        let count = TURNED.iter().find(|(most, _)| turned <= *most).map_or(NODES, |(_, count)| *count);
        let duration = (to - from) * interval.duration_s;
        let mut nodes = [Node::default(); NODES];
        for (node, (share, weight)) in nodes.iter_mut().zip(lobatto(count)) {
            let u = if *share == 1.0 { to } else { from + share * (to - from) };
            let beside = if self.kinks.is_empty() { u } else { from + share.clamp(BESIDE, 1.0 - BESIDE) * (to - from) };
            let (output, torque) = Self::output(interval, u, direction);
            let output = Output { position_rad: interval.at(beside).0, ..output };
            *node = Node {
                time_s: interval.start_s + u * interval.duration_s,
                weight_s: weight * duration,
                acceleration_rad_s2: output.acceleration_rad_s2,
                speed_rad_s: output.speed_rad_s,
                direction,
                load_nm: match &self.plain {
                    // The view adds the remaining parts.
                    Some(plain) => {
                        let lever = (output.position_rad + plain.angle_rad).cos();
                        torque + plain.constant_nm + self.surveyed_weight_nm * lever
                    }
                    None => self.mechanism.torque(&output, &self.with_recorded(torque)),
                },
            };
        }
        let nodes = nodes.get(..count).unwrap_or_default();
        look(Panel::passing(nodes, duration, [0.0, curvature(nodes), 0.0, 0.0]));
    }
}

/// Computes a bound on the rise of a smooth load above the straight line between two neighbouring nodes from its
/// largest second difference: a parabola rises above its chord by an eighth of the second derivative times the square
/// of the chord's duration.
fn curvature(nodes: &[Node]) -> f64 {
    let triples = nodes.iter().zip(nodes.iter().skip(1)).zip(nodes.iter().skip(2));
    let most = triples.fold(0.0_f64, |most, ((a, b), c)| {
        let (left, right) = (b.time_s - a.time_s, c.time_s - b.time_s);
        let bend = 2.0 * ((c.load_nm - b.load_nm) / right - (b.load_nm - a.load_nm) / left) / (left + right);
        most.max(bend.abs() * left.max(right) * left.max(right) / 8.0)
    });
    // Three nodes define the parabola; with more, the curvature between two of them may exceed that at either.
    if nodes.len() > 3 { 2.0 * most } else { most }
}

/// Adds the zeros with a change of sign between two shares, one at most in each half.
fn crossings(value: &impl Fn(f64) -> f64, from: f64, to: f64, cuts: &mut Vec<f64>) {
    let middle = 0.5 * (from + to);
    let at = [from, middle, to].map(value);
    let halves = [(from, middle), (middle, to)].into_iter().zip(at.iter().zip(at.iter().skip(1)));
    for ((low, high), (first, second)) in halves {
        if first * second < 0.0 {
            cuts.push(root(value, (low, *first), (high, *second), CLOSE * (high - low)));
        }
    }
}
