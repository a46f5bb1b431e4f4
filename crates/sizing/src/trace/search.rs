//! The largest value of a signal over the cycle: bounds of blocks first, then nodes, then what lies between them.

use super::rule::between;
use super::{Block, Extent, GROUP, Node, Panel, Place, Trace};

/// What is not higher by more than this share of the highest is not looked for: rounding makes as much.
const ROUNDING: f64 = 1e-12;

/// What lies between two nodes is looked for where it may be higher by more than this share.
const NEGLIGIBLE: f64 = 1e-9;

/// So often the place of a largest value between two nodes is halved: what is left is 10⁻¹² of the smooth bend there.
const HALVINGS: u32 = 20;

/// Whether a value on the straight line between two instants may be above both its ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shape {
    /// Never, as of the magnitude of a weighted sum.
    Convex,
    /// It may.
    Any,
}

impl Trace {
    /// The largest value over the cycle and the first instant that has it. `bound` is above every value of its instants, so
    /// that a block whose bound is not above what is found already is left out.
    ///
    /// # Valid    values that are convex over (α, T_L, σ, ω), as the magnitude of a weighted sum is
    pub(crate) fn largest(&self, bound: impl Fn(&Extent) -> f64, value: impl Fn(&Node) -> f64) -> (f64, Node) {
        self.search(&bound, &value, Shape::Convex)
    }

    /// The same for any value: looked for between straight neighbours too.
    pub(crate) fn largest_of_any(&self, bound: impl Fn(&Extent) -> f64, value: impl Fn(&Node) -> f64) -> (f64, Node) {
        self.search(&bound, &value, Shape::Any)
    }

    fn search(&self, bound: &impl Fn(&Extent) -> f64, value: &impl Fn(&Node) -> f64, shape: Shape) -> (f64, Node) {
        let mut best = Best { value: f64::NEG_INFINITY, node: Node::default() };
        let group = |index: usize, best: &mut Best| {
            let blocks = self.blocks.chunks(GROUP).nth(index).unwrap_or_default();
            in_order(
                blocks,
                |block: &Block| (bound(&block.extent), block.from),
                best,
                |block, _, best| {
                    let Place::Recorded { strip, intervals } = &block.place else {
                        self.panels(block, &mut |panel| best.look(&panel, bound, value, shape));
                        return;
                    };
                    let Some(strip) = self.strips.get(*strip) else { return };
                    strip.parts(intervals, &mut |range, extent, from| {
                        if best.may_be_within(bound(extent), from) {
                            range.for_each(|index| {
                                strip.interval(index, &mut |panel| best.look(&panel, bound, value, shape))
                            });
                        }
                    });
                },
            );
        };
        in_order(&self.groups, |(extent, from)| (bound(extent), *from), &mut best, |_, index, best| group(index, best));
        (best.value, best.node)
    }
}

struct Best {
    value: f64,
    node: Node,
}

impl Best {
    fn see(&mut self, node: &Node, value: f64) {
        if value > self.value || (value == self.value && node.time < self.node.time) {
            *self = Self { value, node: *node };
        }
    }

    /// Whether a bound of what begins at an instant leaves room for something better, or for the same at an earlier instant.
    fn may_be_within(&self, bound: f64, from: f64) -> bool {
        if self.value == f64::NEG_INFINITY || from < self.node.time {
            bound >= self.value
        } else {
            bound > self.value + ROUNDING * self.value.abs()
        }
    }

    fn look(
        &mut self,
        panel: &Panel<'_>,
        bound: &impl Fn(&Extent) -> f64,
        value: &impl Fn(&Node) -> f64,
        shape: Shape,
    ) {
        for node in panel.nodes {
            self.see(node, value(node));
        }
        let bent = panel.bow != [0.0; 4];
        if !bent
            && (shape == Shape::Convex
                || panel.nodes.first().map(Node::signals) == panel.nodes.last().map(Node::signals))
        {
            return;
        }
        let shares = super::rule::rule(panel.nodes.len()).nodes();
        let pairs = panel.nodes.iter().zip(panel.nodes.iter().skip(1)).zip(shares.iter().zip(shares.iter().skip(1)));
        for ((a, b), (from, to)) in pairs {
            let extent = Extent::between(a, b, &panel.bow);
            if bound(&extent) > self.value + NEGLIGIBLE * self.value.abs() {
                let highest_end = value(a).max(value(b));
                if bent {
                    self.narrow((*from, *to), highest_end, value, |s| between(panel.nodes, s));
                } else {
                    self.narrow((0.0, 1.0), highest_end, value, |s| on_line(a, b, s));
                }
            }
        }
    }

    /// The largest value between two shares of a panel, by halving about the best of three instants. What bends by less
    /// between them than it and both ends lie below the highest is left alone.
    fn narrow(
        &mut self,
        (from, to): (f64, f64),
        highest_end: f64,
        value: &impl Fn(&Node) -> f64,
        place: impl Fn(f64) -> Node,
    ) {
        let mut at = |s: f64| {
            let node = place(s);
            let found = value(&node);
            self.see(&node, found);
            ((s, found), self.value)
        };
        let mut quarter = 0.25 * (to - from);
        let (mut middle, _) = at(from + 2.0 * quarter);
        for _ in 0..HALVINGS {
            let [(before, _), (after, highest)] = [middle.0 - quarter, middle.0 + quarter].map(&mut at);
            let bend = (before.1 - 2.0 * middle.1 + after.1).abs();
            for side in [before, after] {
                if side.1 > middle.1 {
                    middle = side;
                }
            }
            if middle.1.max(highest_end) + bend < highest {
                return;
            }
            quarter *= 0.5;
        }
    }
}

/// The instant at a share of the straight line between two.
fn on_line(a: &Node, b: &Node, s: f64) -> Node {
    let blend = |a: f64, b: f64| a + s * (b - a);
    Node {
        acceleration: blend(a.acceleration, b.acceleration),
        speed: blend(a.speed, b.speed),
        load: blend(a.load, b.load),
        time: blend(a.time, b.time),
        ..*a
    }
}

/// Visits what may hold something better than the best: the one with the largest bound, then the others in their order.
fn in_order<T>(
    items: &[T],
    bound: impl Fn(&T) -> (f64, f64),
    best: &mut Best,
    mut visit: impl FnMut(&T, usize, &mut Best),
) {
    if let [only] = items {
        visit(only, 0, best);
        return;
    }
    let mut first: Option<(usize, f64)> = None;
    for (index, item) in items.iter().enumerate() {
        let here = bound(item).0;
        if first.is_none_or(|(_, largest)| here > largest) {
            first = Some((index, here));
        }
    }
    let Some((first, _)) = first else { return };
    if let Some(item) = items.get(first) {
        visit(item, first, best);
    }
    for (index, item) in items.iter().enumerate() {
        let (above, from) = bound(item);
        if index != first && best.may_be_within(above, from) {
            visit(item, index, best);
        }
    }
}
