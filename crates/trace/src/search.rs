//! Search for the largest value of a signal over the cycle: bounds of panels with close signals first, then nodes, then
//! the curve between them.

use super::neighbours::{Branch, NeighbourTree};
use super::recording::{Cell, Inside, Strip};
use super::{Block, Extent, Group, Kept, Node, Panel, STRETCH, Trace};
use numeric::First;

/// Relative excess over the highest value that is ignored, since rounding causes as much.
const ROUNDING: f64 = 1e-12;

/// Relative excess up to which a higher value between two nodes is ignored. Of values that differ by less the first counts,
/// see [`First`].
const NEGLIGIBLE: f64 = numeric::EQUAL;

/// Maximum number of halvings around a maximum between two nodes, leaving 10⁻¹² of the smooth curvature.
const HALVINGS: u32 = 20;

/// Relative tolerance between the value at a vertex and its parabola.
const AGREEMENT: f64 = 1e-13;

/// Number of places between two nodes to which a vertex is rounded, the resolution of its value.
const PLACES: f64 = (1 << 24) as f64;

/// Number of corners above which the bound of the whole stretch is tested before the curve between the corners.
const FEW: usize = 4;

/// Largest error of a parabola at its vertex, as a share of its bend, at which the parabola is used.
const GOOD: f64 = 0.05;

/// A signal whose largest value over the cycle is sought.
pub trait Sought {
    /// `true` if no value on a straight line exceeds both of its ends, as for the magnitude of a weighted sum.
    const CONVEX: bool = false;

    /// Returns an upper bound of the values of instants within some bounds.
    fn bound(&self, extent: &Extent) -> f64;

    /// Returns the value at an instant.
    fn value(&self, node: &Node) -> f64;

    /// Returns an upper bound of the values on the straight line between two instants with no corner in between.
    fn on_line(&self, a: &Node, b: &Node) -> f64 {
        self.bound(&Extent::between(a, b, &[0.0; 4]))
    }

    /// Returns the values of |ω| at which the value may have an upward corner, in rising order. Values at a few
    /// instants determine the curve only between corners.
    fn corners(&self) -> &[f64] {
        &[]
    }
}

/// A signal that is convex over (α, T_L, σ, ω), such as the magnitude of a weighted sum: its bound and its value.
pub struct Convex<B, V>(pub B, pub V);

impl<B: Fn(&Extent) -> f64, V: Fn(&Node) -> f64> Sought for Convex<B, V> {
    const CONVEX: bool = true;

    fn bound(&self, extent: &Extent) -> f64 {
        self.0(extent)
    }

    fn value(&self, node: &Node) -> f64 {
        self.1(node)
    }
}

/// A signal of any shape: values between two instants are bounded like values within their bounds.
pub struct Any<B, V>(pub B, pub V);

impl<B: Fn(&Extent) -> f64, V: Fn(&Node) -> f64> Sought for Any<B, V> {
    fn bound(&self, extent: &Extent) -> f64 {
        self.0(extent)
    }

    fn value(&self, node: &Node) -> f64 {
        self.1(node)
    }
}

/// |J α + T_L|
pub struct TorqueWith {
    /// J \[kgm²\]
    pub inertia_kgm2: f64,
}

impl Sought for TorqueWith {
    const CONVEX: bool = true;

    fn bound(&self, extent: &Extent) -> f64 {
        extent.torque(self.inertia_kgm2)
    }

    fn value(&self, node: &Node) -> f64 {
        (self.inertia_kgm2 * node.acceleration_rad_s2 + node.load_nm).abs()
    }
}

impl Trace {
    /// Returns the largest value over the cycle and the first instant with it, see [`First`]. Parts with a bound not above
    /// the best value are skipped.
    pub fn largest(&self, sought: &impl Sought) -> (f64, Node) {
        self.search(sought, false, f64::NEG_INFINITY)
    }

    /// Returns the same as [`Self::largest`] if the largest value exceeds another one; otherwise `None`, at less cost.
    pub fn largest_above(&self, sought: &impl Sought, least: f64) -> Option<(f64, Node)> {
        Some(self.search(sought, false, least)).filter(|(found, _)| *found > least || least == f64::NEG_INFINITY)
    }

    /// Returns the same as [`Self::largest`] for a single search of a new trace, which does not pay for building the
    /// tree of stored panels or the cells of a recording; cells of the trace it was changed from are used.
    pub fn largest_once(&self, sought: &impl Sought) -> (f64, Node) {
        self.search(sought, true, f64::NEG_INFINITY)
    }

    fn search<S: Sought>(&self, sought: &S, is_once: bool, least: f64) -> (f64, Node) {
        let mut best = Best(First::above(least, Node::default()));
        if let Some(straight) = &self.straight {
            for node in &straight.ends {
                best.see(node, sought.value(node));
            }
            if !S::CONVEX {
                straight.lines.iter().for_each(|[a, b]| best.along(a, b, sought));
            }
            return best.found();
        }
        // A copy has the values of the first panel of its kind. A changed trace is searched only a few times.
        if is_once || self.is_changed {
            let from = |kept: &Kept| self.nodes.get(kept.nodes.start).map_or(0.0, |node| node.time_s);
            let bound = |kept: &Kept| {
                let above = if kept.like.is_copy { f64::NEG_INFINITY } else { sought.bound(&kept.extent) };
                (above, from(kept))
            };
            in_order(&self.panels, bound, &mut best, |kept, best| best.evaluate(&self.panel(kept), sought));
        } else {
            let near = self.near.get_or_init(|| NeighbourTree::of(&self.panels, &self.nodes));
            best.descend(&(self, near), near.root(), sought);
        }
        if is_once && !self.is_changed {
            let group_bound = |group: &Group| (sought.bound(&group.extent), group.from);
            in_order(&self.groups, group_bound, &mut best, |group, best| {
                let blocks = self.blocks.get(group.blocks.clone()).unwrap_or_default();
                let bound = |block: &Block| (sought.bound(&block.extent), block.from_s);
                in_order(blocks, bound, best, |block, best| {
                    self.panels(block, &mut |panel| best.evaluate(&panel, sought));
                });
            });
        } else {
            // A recording that recurs has its values at the first time.
            let anew = self.strips.iter().enumerate().filter(|(index, strip)| strip.first == *index);
            anew.for_each(|(_, strip)| best.descend(strip, strip.root(), sought));
        }
        best.found()
    }
}

/// A tree of panels with close bounds; each part has two halves or is undivided.
trait Parted {
    type Part;

    /// Returns an upper bound of the values within a part, and the start of its first panel \[s\].
    fn bound(&self, part: &Self::Part, sought: &impl Sought) -> (f64, f64);

    /// Returns the halves of a part; visits the panels of an undivided one and returns `None`.
    fn open<'a>(
        &'a self,
        part: &'a Self::Part,
        look: &mut impl FnMut(Panel<'_>),
    ) -> Option<[Option<&'a Self::Part>; 2]>;
}

impl Parted for Strip {
    type Part = Cell;

    #[inline]
    fn bound(&self, cell: &Cell, sought: &impl Sought) -> (f64, f64) {
        let (extent, from) = self.seen(cell);
        (sought.bound(&extent), from)
    }

    #[inline]
    fn open<'a>(&'a self, cell: &'a Cell, look: &mut impl FnMut(Panel<'_>)) -> Option<[Option<&'a Cell>; 2]> {
        match cell.inside {
            Inside::Halves(halves) => Some(self.children(halves)),
            Inside::Intervals(from, to) => {
                self.panels_within((from, to), look);
                None
            }
        }
    }
}

impl Parted for (&Trace, &NeighbourTree) {
    type Part = Branch;

    #[inline]
    fn bound(&self, branch: &Branch, sought: &impl Sought) -> (f64, f64) {
        (sought.bound(&branch.extent), branch.from)
    }

    #[inline]
    fn open<'a>(&'a self, branch: &'a Branch, look: &mut impl FnMut(Panel<'_>)) -> Option<[Option<&'a Branch>; 2]> {
        let (trace, near) = self;
        match near.inside(branch) {
            Ok(halves) => Some(halves),
            Err(panels) => {
                let kept = panels.iter().filter_map(|panel| trace.panels.get(*panel));
                kept.for_each(|kept| look(trace.panel(kept)));
                None
            }
        }
    }
}

impl Strip {
    /// Returns the largest value over a recording whose nodes are not stored, or `least` if no value exceeds it.
    pub fn largest(&self, sought: &impl Sought, least: f64) -> f64 {
        let mut best = Best(First::above(least, Node::default()));
        best.descend(self, self.root(), sought);
        best.0.value()
    }
}

/// Largest value found so far and the first instant with it.
struct Best(First<Node>);

impl Best {
    #[inline]
    fn see(&mut self, node: &Node, value: f64) {
        self.0.see(value, node.time_s, *node);
    }

    fn found(&self) -> (f64, Node) {
        (self.0.value(), self.0.place())
    }

    /// Returns `true` if the bound of a part that begins at an instant permits a better value, or an equal one earlier.
    #[inline]
    fn may_be_within(&self, bound: f64, from: f64) -> bool {
        self.0.permits(bound, from, ROUNDING)
    }

    /// Searches a part if it may contain a better value.
    fn descend<T: Parted>(&mut self, tree: &T, part: Option<&T::Part>, sought: &impl Sought) {
        if let Some(part) = part {
            let (bound, from) = tree.bound(part, sought);
            if self.may_be_within(bound, from) {
                self.within(tree, part, sought);
            }
        }
    }

    /// Searches a part, beginning with the half with the higher bound.
    fn within<T: Parted>(&mut self, tree: &T, part: &T::Part, sought: &impl Sought) {
        let Some(halves) = tree.open(part, &mut |panel| self.evaluate(&panel, sought)) else { return };
        let mut halves = halves.map(|half| {
            let half = half?;
            let (bound, from) = tree.bound(half, sought);
            Some((half, bound, from))
        });
        if let [Some((_, low, first)), Some((_, high, second))] = &halves
            && (high > low || (high == low && second < first))
        {
            halves.swap(0, 1);
        }
        for (half, bound, from) in halves.into_iter().flatten() {
            if self.may_be_within(bound, from) {
                self.within(tree, half, sought);
            }
        }
    }

    fn evaluate<S: Sought>(&mut self, panel: &Panel<'_>, sought: &S) {
        if panel.is_straight() {
            if let [a, .., b] = panel.nodes {
                self.line(a, b, sought);
            }
            return;
        }
        // Bounds of a stored panel are known, and most panels of a block lie below the best value.
        let from = panel.nodes.first().map_or(0.0, |node| node.time_s);
        if panel.extent().is_some_and(|extent| !self.may_be_within(sought.bound(extent), from)) {
            return;
        }
        // The bounds of a stretch are closer than those of the panel, and cost less than its values.
        let mut bounds = panel.stretches(STRETCH).iter();
        let shares = super::rule::rule(panel.nodes.len()).nodes();
        let mut first = 0;
        while first + 1 < panel.nodes.len() {
            let (nodes, shares) = (panel.nodes.get(first..), shares.get(first..));
            let (nodes, shares) = (nodes.unwrap_or_default(), shares.unwrap_or_default());
            let nodes = nodes.get(..=STRETCH).unwrap_or(nodes);
            first += STRETCH;
            let from = nodes.first().map_or(0.0, |node| node.time_s);
            if bounds.next().is_some_and(|extent| !self.may_be_within(sought.bound(extent), from)) {
                continue;
            }
            for node in nodes {
                self.see(node, sought.value(node));
            }
            let pairs = nodes.iter().zip(nodes.iter().skip(1)).zip(shares.iter().zip(shares.iter().skip(1)));
            for ((a, b), (from, to)) in pairs {
                self.cut([(*from, a), (*to, b)], sought, &panel.bow, &|s| panel.at(s));
            }
        }
    }

    /// Searches the straight line between two instants: its ends, then the values between them.
    fn line<S: Sought>(&mut self, a: &Node, b: &Node, sought: &S) {
        self.see(a, sought.value(a));
        self.see(b, sought.value(b));
        if !S::CONVEX && a.signals() != b.signals() {
            self.along(a, b, sought);
        }
    }

    /// Searches the values between two instants on a straight line.
    fn along<S: Sought>(&mut self, a: &Node, b: &Node, sought: &S) {
        self.cut([(0.0, a), (1.0, b)], sought, &[0.0; 4], &|s| a.towards(b, s));
    }

    /// Searches the values between two shares of a panel, where no signal deviates from the straight line by more than
    /// `bow`: split at the corners of the value that it passes.
    fn cut<S: Sought>(
        &mut self,
        [(from, a), (to, b)]: [(f64, &Node); 2],
        sought: &S,
        bow: &[f64; 4],
        place: &impl Fn(f64) -> Node,
    ) {
        let (first, last) = (a.speed_rad_s.abs(), b.speed_rad_s.abs());
        let corners = within(sought.corners(), first.min(last), first.max(last));
        let Some(corner) = corners.get(corners.len() / 2) else {
            let above = if *bow == [0.0; 4] { sought.on_line(a, b) } else { sought.bound(&Extent::between(a, b, bow)) };
            if self.may_be_exceeded(above, a.time_s) {
                self.narrow([(from, sought.value(a)), (to, sought.value(b))], sought, place);
            }
            return;
        };
        if corners.len() > FEW && !self.may_be_exceeded(sought.bound(&Extent::between(a, b, bow)), a.time_s) {
            return;
        }
        let ahead = |s: f64| place(s).speed_rad_s.abs() - corner;
        let s = numeric::root(ahead, (from, first - corner), (to, last - corner), AGREEMENT * (to - from));
        let at = place(s);
        let node = Node { speed_rad_s: corner.copysign(at.speed_rad_s), ..at };
        self.see(&node, sought.value(&node));
        self.cut([(from, a), (s, &node)], sought, bow, place);
        self.cut([(s, &node), (to, b)], sought, bow, place);
    }

    /// Returns `true` if the bound of values between two nodes that begin at an instant permits a higher value, or an
    /// equal one earlier.
    #[inline]
    fn may_be_exceeded(&self, bound: f64, from: f64) -> bool {
        self.0.permits(bound, from, NEGLIGIBLE)
    }

    /// Finds the largest value between two shares of a panel: the best of three instants at ever smaller distance,
    /// reduced to a half each time, or to a quarter if the parabola through them predicts the value at its vertex. Ends
    /// when two successive vertices agree with their parabolas. A stretch is skipped if it bends by less between the
    /// three than the best of them and both ends lie below the highest value.
    fn narrow(&mut self, ends: [(f64, f64); 2], sought: &impl Sought, place: impl Fn(f64) -> Node) {
        let mut own = Vertex { value: f64::NEG_INFINITY, node: Node::default() };
        self.narrow_alone(&mut own, ends, sought, place);
        // A vertex no higher than an end is that end, which was evaluated before; its place differs by the rounding of the
        // machine, and so would the signals there.
        let [(_, first), (_, last)] = ends;
        let highest_end = first.max(last);
        if own.value > highest_end + NEGLIGIBLE * highest_end.abs() {
            self.see(&own.node, own.value);
        }
    }

    fn narrow_alone(
        &self,
        own: &mut Vertex,
        [(from, mut low_end), (to, mut high_end)]: [(f64, f64); 2],
        sought: &impl Sought,
        place: impl Fn(f64) -> Node,
    ) {
        let mut at = |s: f64| {
            let node = place(s);
            let found = sought.value(&node);
            if found > own.value {
                *own = Vertex { value: found, node };
            }
            ((s, found), self.0.value().max(own.value))
        };
        let highest_end = low_end.max(high_end);
        let mut quarter = 0.25 * (to - from);
        let (mut middle, _) = at(from + 2.0 * quarter);
        let mut agreed = f64::NAN;
        for _ in 0..HALVINGS {
            let [(before, _), (after, highest)] = [middle.0 - quarter, middle.0 + quarter].map(&mut at);
            let bend = before.1 - 2.0 * middle.1 + after.1;
            let rise = 0.5 * (after.1 - before.1);
            let is_between = before.1 <= middle.1 && after.1 <= middle.1 && bend < 0.0;
            let best = [before, after].into_iter().fold(middle, |best, side| if side.1 > best.1 { side } else { best });
            if best.1.max(highest_end) + bend.abs() < highest {
                return;
            }
            if !is_between {
                let five = [low_end, before.1, middle.1, after.1, high_end];
                if is_highest_at_an_end(five, highest) {
                    // That end was evaluated before; its instant counts among values that differ by rounding only.
                    own.value = f64::NEG_INFINITY;
                    return;
                }
                // The next interval is bounded by the neighbours of the best of the five instants.
                (low_end, high_end) = if best.0 < middle.0 {
                    (low_end, middle.1)
                } else if best.0 > middle.0 {
                    (middle.1, high_end)
                } else {
                    (before.1, after.1)
                };
                (middle, quarter, agreed) = (best, 0.5 * quarter, f64::NAN);
                continue;
            }
            let height = middle.1 - 0.5 * rise * rise / bend;
            let (vertex, _) = at(middle.0 - rise / bend * quarter);
            let (off, close) = ((vertex.1 - height).abs(), AGREEMENT * height.abs());
            if off <= close && (vertex.1 - agreed).abs() <= close {
                // A value higher in the last digits only is so by chance and lies elsewhere on another machine; the
                // same holds for the last digits of the place.
                if own.value <= vertex.1 + close {
                    let node = place(from + (to - from) / PLACES * ((vertex.0 - from) / (to - from) * PLACES).round());
                    *own = Vertex { value: sought.value(&node), node };
                }
                return;
            }
            agreed = if off <= close { vertex.1 } else { f64::NAN };
            quarter *= if off <= -GOOD * bend { 0.25 } else { 0.5 };
            (low_end, high_end) = (f64::NAN, f64::NAN);
            if vertex.1 > middle.1 {
                middle = vertex;
            }
        }
    }
}

/// Highest of the values between two nodes.
struct Vertex {
    value: f64,
    node: Node,
}

/// Returns `true` if an end is the largest of five values at equal steps and nothing before it exceeds the highest
/// known value by more than rounding: the values rise towards that end, or fall by so little that the vertex of the
/// parabola with their curvature is no higher.
///
/// Slope and bend per step are those of the polynomial through all five; the slope is reduced by the contribution of
/// the fifth.
fn is_highest_at_an_end(five: [f64; 5], highest: f64) -> bool {
    let [first, .., last] = five;
    let [a, b, c, d, e] = if first > last { [five[4], five[3], five[2], five[1], five[0]] } else { five };
    if !(a <= e && b <= e && c <= e && d <= e) {
        return false;
    }
    let changed = 0.25 * (a - 4.0 * b + 6.0 * c - 4.0 * d + e).abs();
    let slope = (3.0 * a - 16.0 * b + 36.0 * c - 48.0 * d + 25.0 * e) / 12.0 - changed;
    let bend = ((11.0 * a - 56.0 * b + 114.0 * c - 104.0 * d + 35.0 * e) / 12.0).abs();
    let counts = ROUNDING * highest.abs();
    slope >= -counts || slope * slope <= 2.0 * bend * counts
}

/// Returns the corners between two speeds.
#[inline]
fn within(corners: &[f64], low: f64, high: f64) -> &[f64] {
    let from = corners.partition_point(|corner| *corner <= low);
    let to = corners.partition_point(|corner| *corner < high);
    corners.get(from..to).unwrap_or_default()
}

/// Visits items that may contain a value better than the best: the one with the largest bound first, then the others in
/// order.
fn in_order<T>(items: &[T], bound: impl Fn(&T) -> (f64, f64), best: &mut Best, mut visit: impl FnMut(&T, &mut Best)) {
    if let [only] = items {
        visit(only, best);
        return;
    }
    let bounds: Vec<(f64, f64)> = items.iter().map(bound).collect();
    let mut first: Option<(usize, f64)> = None;
    for (index, (above, _)) in bounds.iter().enumerate() {
        if first.is_none_or(|(_, largest)| *above > largest) {
            first = Some((index, *above));
        }
    }
    let Some((first, _)) = first else { return };
    if let Some(item) = items.get(first) {
        visit(item, best);
    }
    for (index, (item, (above, from))) in items.iter().zip(bounds).enumerate() {
        if index != first && best.may_be_within(above, from) {
            visit(item, best);
        }
    }
}
