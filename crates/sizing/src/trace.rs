//! The motion under its load as weighted instants, once per axis; every candidate is judged on it.

use mechanism::{Extra, Mechanism, Output};
use motion::{Hold, Motion, Piece, lobatto};

/// One instant with its share of the cycle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Node {
    /// Instant from the start of the cycle \[s\].
    pub(crate) time: f64,
    /// Weight of the quadrature \[s\]; the weights sum to the duration.
    pub(crate) weight: f64,
    /// α [rad/s²]
    pub(crate) acceleration: f64,
    /// ω [rad/s]
    pub(crate) speed: f64,
    /// σ: +1, −1, 0 at rest.
    pub(crate) direction: f64,
    /// Torque that the load asks of the actuator, without the actuator's own inertia \[Nm\]; zero where the brake holds.
    pub(crate) load: f64,
}

impl Node {
    /// The instant at a share of the way to the next one, everything taken as straight in between.
    pub(crate) fn towards(&self, next: &Self, share: f64) -> Self {
        let between = |a: f64, b: f64| a + share * (b - a);
        Self {
            time: between(self.time, next.time),
            weight: 0.0,
            acceleration: between(self.acceleration, next.acceleration),
            speed: between(self.speed, next.speed),
            direction: self.direction,
            load: between(self.load, next.load),
        }
    }
}

/// Bounds of a block of nodes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    pub(crate) acceleration: (f64, f64),
    pub(crate) load: (f64, f64),
    /// Largest |ω|.
    pub(crate) speed: f64,
}

impl Extent {
    fn of(nodes: &[Node]) -> Self {
        let mut extent = Self {
            acceleration: (f64::INFINITY, f64::NEG_INFINITY),
            load: (f64::INFINITY, f64::NEG_INFINITY),
            speed: 0.0,
        };
        for node in nodes {
            extent.acceleration =
                (extent.acceleration.0.min(node.acceleration), extent.acceleration.1.max(node.acceleration));
            extent.load = (extent.load.0.min(node.load), extent.load.1.max(node.load));
            extent.speed = extent.speed.max(node.speed.abs());
        }
        extent
    }

    /// No |J α + T_L| of the block is above this.
    pub(crate) fn torque(&self, inertia: f64) -> f64 {
        let high = inertia * self.acceleration.1 + self.load.1;
        let low = inertia * self.acceleration.0 + self.load.0;
        high.max(-low)
    }
}

/// So many nodes share one extent.
const BLOCK: usize = 128;

/// The load in the direction of the motion: sums of products of (α, T_L, σ, ω) over the cycle.
///
/// G_ij = ∫ x_i x_j dt with x = (α, T_L, σ, ω). Any signal that is a weighted sum s = Σ c_i x_i, such as torque and
/// current, has ∫s² dt = cᵀ G c: one pass over the motion, then ten products per candidate.
///
/// # Source   own derivation, docs/theory/moments.md
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Gram([[f64; 4]; 4]);

impl Gram {
    fn of(nodes: &[Node]) -> Self {
        let mut sums = [[0.0; 4]; 4];
        for node in nodes {
            let x = [node.acceleration, node.load, node.direction, node.speed];
            for (row, a) in sums.iter_mut().zip(x) {
                let scaled = a * node.weight;
                for (sum, b) in row.iter_mut().zip(x) {
                    *sum += scaled * b;
                }
            }
        }
        Self(sums)
    }

    /// cᵀ G c
    pub(crate) fn square(&self, c: [f64; 4]) -> f64 {
        let sum: f64 =
            self.0.iter().zip(c).map(|(row, a)| a * row.iter().zip(c).map(|(g, b)| g * b).sum::<f64>()).sum();
        // Rounding may leave a tiny negative sum where the signal vanishes.
        sum.max(0.0)
    }

    /// ∫σ² dt: time in motion.
    pub(crate) const fn moving(&self) -> f64 {
        self.0[2][2]
    }

    /// ∫σ ω dt = ∫|ω| dt: angle travelled.
    pub(crate) const fn travelled(&self) -> f64 {
        self.0[2][3]
    }
}

/// What one segment contributes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Share {
    /// ∫|ω| dt \[rad\]
    pub(crate) travelled: f64,
}

/// The motion under its load.
#[derive(Clone, Debug)]
pub(crate) struct Trace {
    nodes: Vec<Node>,
    extents: Vec<Extent>,
    pub(crate) gram: Gram,
    pub(crate) shares: Vec<Share>,
    /// ∫|T_L|³ |ω| dt
    pub(crate) cubes: f64,
    /// Largest and smallest J_L on the way \[kgm²\].
    pub(crate) inertia: (f64, f64),
    /// Lowest and highest position \[rad\].
    pub(crate) span: (f64, f64),
    /// End minus start \[rad\].
    pub(crate) net: f64,
    /// Largest magnitude of the torque that holds the load without friction at any instant \[Nm\], whoever holds it.
    pub(crate) holding: f64,
}

impl Trace {
    pub(crate) fn of(mechanism: &Mechanism, motion: &Motion, extras: &[Extra]) -> Self {
        let mut builder = Builder {
            mechanism,
            nodes: Vec::with_capacity(4 * motion.pieces().len()),
            shares: vec![Share::default(); motion.stretches().len()],
            inertia: (0.0, f64::INFINITY),
            span: (f64::INFINITY, f64::NEG_INFINITY),
            holding: 0.0,
            kinked: !mechanism.kinks().is_empty(),
        };
        let none = Extra::none();
        for piece in motion.pieces() {
            let extra = extras.get(piece.segment).unwrap_or(&none);
            let hold = motion.stretches().get(piece.segment).map_or(Hold::Motor, |stretch| stretch.hold);
            builder.piece(piece, extra, hold);
        }
        let net = match (motion.pieces().first(), motion.pieces().last()) {
            (Some(first), Some(last)) => last.end().position_rad - first.position_rad,
            _ => 0.0,
        };
        let Builder { nodes, shares, inertia, span, holding, .. } = builder;
        Self {
            gram: Gram::of(&nodes),
            extents: if nodes.len() > BLOCK { nodes.chunks(BLOCK).map(Extent::of).collect() } else { Vec::new() },
            cubes: nodes.iter().map(|node| node.weight * node.load.abs().powi(3) * node.speed.abs()).sum(),
            nodes,
            shares,
            inertia,
            span,
            net,
            holding,
        }
    }

    pub(crate) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The largest value over the nodes and the first node that has it. `bound` is above every value of its block, so
    /// that a block whose bound is below what is found already is left out: exact, and near O(blocks).
    pub(crate) fn largest(&self, bound: impl Fn(&Extent) -> f64, value: impl Fn(&Node) -> f64) -> (f64, Node) {
        let mut best = (f64::NEG_INFINITY, Node::default());
        let scan = |nodes: &[Node], best: &mut (f64, Node)| {
            for node in nodes {
                let here = value(node);
                if here > best.0 || (here == best.0 && node.time < best.1.time) {
                    *best = (here, *node);
                }
            }
        };
        if self.extents.is_empty() {
            scan(&self.nodes, &mut best);
            return best;
        }
        let bounds: Vec<f64> = self.extents.iter().map(bound).collect();
        let block = |index: usize| self.nodes.chunks(BLOCK).nth(index).unwrap_or_default();
        let most = bounds.iter().enumerate().max_by(|(_, a), (_, b)| a.total_cmp(b));
        let first = most.map_or(0, |(index, _)| index);
        scan(block(first), &mut best);
        for (index, bound) in bounds.iter().enumerate() {
            if *bound >= best.0 && index != first {
                scan(block(index), &mut best);
            }
        }
        best
    }
}

struct Builder<'a> {
    mechanism: &'a Mechanism,
    nodes: Vec<Node>,
    shares: Vec<Share>,
    inertia: (f64, f64),
    span: (f64, f64),
    holding: f64,
    /// Whether the load has kinks over the position.
    kinked: bool,
}

/// Where the load depends on the position a panel covers at most this angle, so that sixteen nodes leave an error near
/// the last bit: 30° is a twelfth of the period of what gravity and a crank make (docs/theory/moments.md gives the error).
const PANEL_ANGLE: f64 = std::f64::consts::FRAC_PI_6;

/// Over so many panels of [`PANEL_ANGLE`] one search for roots runs, with 64 steps: more than ten to a half turn.
const PANELS_PER_SEARCH: f64 = 12.0;

/// A panel covers at most this phase of the harmonic of its law.
const PANEL_PHASE: f64 = std::f64::consts::FRAC_PI_4;

/// Most panels of one piece; a piece that turns through more than eighty revolutions under a changing load is sampled
/// more coarsely than [`PANEL_ANGLE`].
const PANELS_MOST: f64 = 1_000.0;

impl Builder<'_> {
    fn piece(&mut self, piece: &Piece, extra: &Extra, hold: Hold) {
        if piece.is_rest() {
            self.rest(piece, extra, hold);
            return;
        }
        let cuts = self.cuts(piece, extra);
        let nodes = self.nodes_per_panel(piece);
        for pair in cuts.windows(2) {
            if let [from, to] = pair {
                self.panel(piece, extra, (*from, *to), nodes);
            }
        }
    }

    fn rest(&mut self, piece: &Piece, extra: &Extra, hold: Hold) {
        let output = self.output(piece, 0.0, 0.0);
        let holding = self.mechanism.torque(&output, extra);
        let load = if hold == Hold::Motor { holding } else { 0.0 };
        for share in [0.0, 1.0] {
            self.nodes.push(Node {
                time: piece.start_s + share * piece.duration_s,
                weight: 0.5 * piece.duration_s,
                acceleration: 0.0,
                speed: 0.0,
                direction: 0.0,
                load,
            });
        }
        self.see(&output, extra);
    }

    fn output(&self, piece: &Piece, t: f64, direction: f64) -> Output {
        let state = piece.at(t);
        Output {
            position_rad: state.position_rad,
            speed_rad_s: state.speed_rad_s,
            acceleration_rad_s2: state.acceleration_rad_s2,
            direction,
        }
    }

    /// Notes extremes at an instant.
    fn see(&mut self, output: &Output, extra: &Extra) {
        let inertia = quantities::Measure::si(self.mechanism.inertia(output.position_rad, extra));
        self.inertia = (self.inertia.0.max(inertia), self.inertia.1.min(inertia));
        self.span = (self.span.0.min(output.position_rad), self.span.1.max(output.position_rad));
        let holding = quantities::Measure::si(self.mechanism.holding_torque(output.position_rad, extra));
        self.holding = self.holding.max(holding.abs());
    }

    /// Panel borders: reversals, changes of sign of the torque and kinks of the load, and then as many equal parts as a
    /// smooth integrand needs.
    fn cuts(&self, piece: &Piece, extra: &Extra) -> Vec<f64> {
        let mut cuts = vec![0.0];
        cuts.extend(piece.reversals());
        let ramp = piece.speed_degree().is_some_and(|degree| degree <= 1);
        if !ramp {
            // The extremes of speed and acceleration become nodes.
            cuts.extend(motion::roots(|t| piece.at(t).acceleration_rad_s2, piece.duration_s));
            cuts.extend(motion::roots(|t| piece.jerk(t), piece.duration_s));
        }
        if !(ramp && self.mechanism.is_constant_over_ramps()) {
            let sign = |t: f64| piece.at(t).speed_rad_s.signum();
            // So many spans that no two roots fall into one step of the search.
            let spans = (self.parts(piece) / PANELS_PER_SEARCH).ceil().max(1.0);
            let span = piece.duration_s / spans;
            let search = |f: &dyn Fn(f64) -> f64, cuts: &mut Vec<f64>| {
                let mut k = 0.0;
                while k < spans {
                    cuts.extend(motion::roots(|t| f(k * span + t), span).into_iter().map(|t| k * span + t));
                    k += 1.0;
                }
            };
            search(&|t| self.mechanism.useful_torque(&self.output(piece, t, sign(t)), extra), &mut cuts);
            search(&|t| self.mechanism.torque(&self.output(piece, t, sign(t)), extra), &mut cuts);
            for kink in self.mechanism.kinks() {
                search(&|t| wrapped(piece.at(t).position_rad - kink), &mut cuts);
            }
        }
        cuts.push(piece.duration_s);
        cuts.sort_by(f64::total_cmp);
        cuts.dedup_by(|a, b| (*a - *b).abs() <= 1e-12 * piece.duration_s);
        let parts = self.parts(piece);
        if parts <= 1.0 {
            return cuts;
        }
        let longest = piece.duration_s / parts;
        let mut fine = vec![0.0];
        for pair in cuts.windows(2) {
            if let [from, to] = pair {
                let count = ((to - from) / longest).ceil().max(1.0);
                let mut k = 1.0;
                while k < count {
                    fine.push(from + (to - from) * k / count);
                    k += 1.0;
                }
                fine.push(*to);
            }
        }
        fine
    }

    fn parts(&self, piece: &Piece) -> f64 {
        let [amplitude, frequency, _] = piece.harmonic;
        let phase = if amplitude == 0.0 { 0.0 } else { frequency * piece.duration_s / PANEL_PHASE };
        let angle = if self.mechanism.depends_on_position() {
            // The travel is at most the largest speed times the duration; the ends and the middle bound it closely.
            let speed = [0.0, 0.25, 0.5, 0.75, 1.0].map(|u| piece.at(u * piece.duration_s).speed_rad_s.abs());
            speed.into_iter().fold(0.0, f64::max) * piece.duration_s / PANEL_ANGLE
        } else {
            0.0
        };
        phase.max(angle).min(PANELS_MOST).ceil()
    }

    /// So many nodes that T², I² and T³ω are integrated exactly where they are polynomials of time.
    fn nodes_per_panel(&self, piece: &Piece) -> usize {
        if self.mechanism.depends_on_position() {
            return 16;
        }
        let viscous = !self.mechanism.is_constant_over_ramps();
        match piece.speed_degree() {
            // Constant speed: everything is constant.
            Some(0) => 2,
            // T constant: T³ω and I² up to degree 2; with viscous friction T³ω has degree 4.
            Some(1) => {
                if viscous {
                    4
                } else {
                    3
                }
            }
            // ω² and T³ω: degree 5 without viscous friction, 8 with it.
            Some(2) => 6,
            Some(3) => 8,
            Some(_) => 11,
            None => 16,
        }
    }

    fn panel(&mut self, piece: &Piece, extra: &Extra, (from, to): (f64, f64), nodes: usize) {
        let direction = piece.at(0.5 * (from + to)).speed_rad_s.signum();
        let mut travelled = 0.0;
        let (kinked, beside) = (self.kinked, 1e-9 * (to - from));
        for (u, weight) in lobatto(nodes) {
            // The end is met to the last bit, so that time never runs back into the next panel.
            let t = if *u == 1.0 { to } else { from + u * (to - from) };
            // At a kink of the load each panel takes the slope of its own side.
            let beside = if kinked { (t.max(from + beside)).min(to - beside) } else { t };
            let output = self.output(piece, beside, direction);
            self.nodes.push(Node {
                time: piece.start_s + t,
                weight: weight * (to - from),
                acceleration: output.acceleration_rad_s2,
                speed: output.speed_rad_s,
                direction,
                load: self.mechanism.torque(&output, extra),
            });
            travelled += weight * (to - from) * output.speed_rad_s * direction;
            self.see(&output, extra);
        }
        if let Some(share) = self.shares.get_mut(piece.segment) {
            share.travelled += travelled;
        }
    }
}

/// An angle brought to ±180°, for kinks that repeat with each revolution; its own jump is no kink.
fn wrapped(angle: f64) -> f64 {
    // The sine has the same roots at whole revolutions, and those at half ones cut a panel where nothing happens.
    (0.5 * angle).sin() * (0.5 * angle).cos()
}

#[cfg(test)]
#[path = "trace_tests.rs"]
mod tests;
