//! Construction of a trace in one pass over the motion.

use super::kinks::{kink_passes, passes, recorded_passes};
use super::recording::{Strip, Surveys};
use super::repeats;
use super::rule::rule;
use super::short::Straight;
use super::{BLOCK, Block, BlockPanels, Carried, Extent, GROUP, Gram, Group, Kept, Node, Run, Share, Trace};
use mechanism::{Endless, Extra, LoadTorque, Loading, Mechanism, Output};
use motion::{Motion, Piece, Placed, Runs, State};
use numeric::{lobatto, root_steps, roots_between};
use quantities::{Angle, Measure};
use std::f64::consts::TAU;
use std::sync::{Arc, OnceLock};

pub(super) struct Builder<'a> {
    mechanism: &'a Mechanism,
    motion: &'a Motion,
    extras: &'a [Extra],
    carried: &'a [Carried],
    /// Strips of an existing trace of the same recordings.
    known: &'a [Strip],
    /// Strips of a trace of an earlier motion; used where the survey of this motion would be the same.
    recalled: &'a [Strip],
    nodes: Vec<Node>,
    panels: Vec<Kept>,
    strips: Vec<Strip>,
    blocks: Vec<Block>,
    /// Numbers of nodes and panels that already belong to a block.
    blocked: (usize, usize),
    /// Number of repetitions of the part being added.
    times: f64,
    shares: Vec<Share>,
    /// Lowest and highest position of each segment \[rad\].
    spans: Vec<Option<(f64, f64)>>,
    /// The load has kinks over the position.
    kinked: bool,
    /// Repeated panels are searched for.
    seeks_alike: bool,
    /// The nodes of recordings are stored.
    keeps_recordings: bool,
}

/// Number of panels of a position-dependent load covered by one root search with 64 steps: more than ten steps per half
/// turn.
const PANELS_PER_SEARCH: f64 = 12.0;

/// Largest phase of the law's harmonic covered by one panel \[rad\].
const PANEL_PHASE: f64 = std::f64::consts::FRAC_PI_4;

/// Maximum number of instants of one cycle, not counting recordings; a larger cycle is refused.
pub const INSTANTS_MOST: f64 = 130_000.0;

/// Panels between neighbouring kinks need fewer nodes: if a panel is shorter than this share of a regular one and the
/// load turns by less than [`SHORT_TURN`] \[rad\], nine nodes integrate to 10⁻¹².
const SHORT: f64 = 0.25;
const SHORT_TURN: f64 = 0.1;
const NODES_BETWEEN_KINKS: usize = 9;

/// Maximum number of nodes of a panel whose signals are straight over time.
const STRAIGHT: usize = 4;

/// Maximum number of intervals of all recordings together whose nodes are stored. They are read many times for every
/// candidate and fit into a few megabytes; for longer recordings storing and loading would cost more than computing the
/// nodes again.
const KEPT: usize = 1 << 13;

impl Trace {
    /// Evaluates a motion under its load as [`Self::of`] does, to the last bit; a recording whose survey is among the given
    /// ones is not evaluated again.
    #[must_use]
    pub fn surveyed(
        mechanism: &Mechanism,
        motion: &Motion,
        extras: &[Extra],
        carried: &[Carried],
        surveys: &Surveys,
    ) -> Self {
        Builder::new(mechanism, motion, extras, carried).recalling(&surveys.0).trace()
    }

    /// Returns the surveys of its recordings.
    #[must_use]
    pub fn surveys(&self) -> Surveys {
        Surveys(self.strips.clone())
    }
}

impl<'a> Builder<'a> {
    pub(super) fn new(
        mechanism: &'a Mechanism,
        motion: &'a Motion,
        extras: &'a [Extra],
        carried: &'a [Carried],
    ) -> Self {
        Self {
            mechanism,
            motion,
            extras,
            carried,
            known: &[],
            recalled: &[],
            nodes: Vec::with_capacity(4 * motion.pieces().len()),
            panels: Vec::with_capacity(motion.pieces().len()),
            strips: Vec::new(),
            blocks: Vec::new(),
            blocked: (0, 0),
            times: 1.0,
            shares: vec![Share::default(); motion.stretches().len()],
            spans: vec![None; motion.stretches().len()],
            kinked: !mechanism.kinks().is_empty(),
            seeks_alike: true,
            keeps_recordings: motion.recordings().iter().map(Placed::intervals).sum::<usize>() <= KEPT,
        }
    }

    /// Adds the strips of a trace of the same motion and that trace's result on repeated panels, neither of which
    /// depends on load or pace.
    pub(super) fn knowing(self, known: &'a [Strip], has_copies: bool) -> Self {
        Self { known, seeks_alike: has_copies, ..self }
    }

    /// Adds the strips of an earlier trace whose surveys are used where they equal those of this one.
    pub(super) fn recalling(self, recalled: &'a [Strip]) -> Self {
        Self { recalled, ..self }
    }

    pub(super) fn trace(mut self) -> Trace {
        let none = Extra::none();
        let mut recordings = self.motion.recordings().iter().peekable();
        for piece in self.motion.pieces() {
            while let Some(placed) = recordings.next_if(|placed| placed.start_s < piece.start_s) {
                self.recording(placed);
            }
            let extra = self.extras.get(piece.segment).unwrap_or(&none);
            self.piece(piece, extra);
        }
        for placed in recordings {
            self.recording(placed);
        }
        self.close_block();
        if self.seeks_alike {
            repeats::find(&self.nodes, &mut self.panels);
        }
        let (inertia, holding) = self.extremes();
        let both = |a: (f64, f64), b: (f64, f64)| (a.0.min(b.0), a.1.max(b.1));
        let span = self.spans.iter().flatten().copied().fold((f64::INFINITY, f64::NEG_INFINITY), both);
        let mut gram = Gram::default();
        self.blocks.iter().for_each(|block| gram.join(&block.gram));
        let mut trace = Trace {
            groups: groups(&self.blocks),
            near: OnceLock::new(),
            straight: None,
            is_changed: false,
            lags: Arc::default(),
            runs: runs(&self.blocks),
            duration: self.blocks.iter().map(|block| block.duration_s).sum(),
            nodes: self.nodes,
            panels: self.panels,
            strips: self.strips,
            blocks: self.blocks,
            gram,
            cubes: OnceLock::new(),
            shares: self.shares,
            inertia,
            span,
            spans: self.spans,
            holding,
        };
        trace.straight = Straight::of(&trace);
        trace
    }

    /// Closes the current block: groups all nodes added since the last one.
    fn close_block(&mut self) {
        let (nodes, panels) = self.blocked;
        if panels == self.panels.len() {
            return;
        }
        self.blocked = (self.nodes.len(), self.panels.len());
        let mut block = Block::empty(BlockPanels::Kept(panels..self.panels.len()));
        block.times = self.times;
        block.from_s = self.nodes.get(nodes).map_or(0.0, |node| node.time_s);
        for kept in self.panels.get(panels..).unwrap_or_default() {
            block.add(&kept.panel(&self.nodes));
        }
        self.blocks.push(block);
    }

    fn recording(&mut self, placed: &Placed) {
        self.close_block();
        let none = Extra::none();
        let extra = self.extras.get(placed.segment).unwrap_or(&none);
        let others = self.known.iter().chain(&self.strips);
        let mut strip = Strip::new(placed.clone(), self.mechanism.clone(), *extra, others, self.recalled);
        strip.first = self.strips.iter().position(|other| other.is_like(&strip)).unwrap_or(self.strips.len());
        let mut survey = strip.found(self.strips.len());
        if let Some(share) = self.shares.get_mut(placed.segment) {
            let travelled = survey.blocks.iter().map(|block| block.gram.travelled()).sum::<f64>();
            share.travelled += Angle::from_si(travelled);
        }
        let (lowest, highest) = survey.span;
        [lowest, highest].into_iter().for_each(|position| self.see(position, placed.segment));
        if self.keeps_recordings {
            let (nodes, panels) = (&mut self.nodes, &mut self.panels);
            survey.blocks.iter_mut().for_each(|block| strip.keep(block, nodes, panels));
            self.blocked = (self.nodes.len(), self.panels.len());
        } else {
            self.strips.push(strip);
        }
        self.blocks.extend(survey.blocks);
    }

    fn piece(&mut self, piece: &Piece, extra: &Extra) {
        if piece.is_rest() {
            self.rest(piece, extra);
            return;
        }
        if let Some(revolutions) = whole_revolutions(self.mechanism, piece) {
            self.revolutions(piece, extra, revolutions);
            return;
        }
        self.turning(piece, extra);
    }

    /// Adds whole revolutions at constant speed under a load with the period of one revolution: one revolution
    /// represents all, the remainder follows.
    fn revolutions(&mut self, piece: &Piece, extra: &Extra, times: f64) {
        self.close_block();
        // Angle of one revolution of the load, seen at the actuator: the stage in between multiplies it.
        let angle = TAU * self.mechanism.stage_ratio().abs();
        let period = angle / piece.speed_rad_s.abs();
        self.times = times;
        self.turning(&Piece { duration_s: period, ..*piece }, extra);
        self.close_block();
        self.times = 1.0;
        let left = piece.duration_s - times * period;
        if left > 1e-12 * piece.duration_s {
            let position_rad = piece.position_rad + times * angle * piece.speed_rad_s.signum();
            let start_s = piece.start_s + times * period;
            self.turning(&Piece { start_s, duration_s: left, position_rad, ..*piece }, extra);
        } else {
            self.see(piece.at(piece.duration_s).position_rad, piece.segment);
        }
    }

    fn turning(&mut self, piece: &Piece, extra: &Extra) {
        let (runs, loading) = (piece.runs(), self.mechanism.loading(extra));
        let cuts = self.cuts(piece, &loading, &runs);
        let nodes = nodes_per_panel(self.mechanism, piece);
        let short = SHORT * piece.duration_s / parts(self.mechanism, piece).max(1.0);
        let turned = |from: f64, to: f64| (piece.at(to).position_rad - piece.at(from).position_rad).abs();
        let near = SHORT_TURN * self.mechanism.stage_ratio().abs();
        for pair in cuts.windows(2) {
            if let [from, to] = pair {
                let between = self.kinked && to - from <= short && turned(*from, *to) <= near;
                let nodes = if between { NODES_BETWEEN_KINKS.min(nodes) } else { nodes };
                self.panel(piece, &loading, (*from, *to, runs.direction(0.5 * (from + to))), nodes);
                // A repeated part stays in one block.
                if self.times == 1.0 && self.nodes.len() - self.blocked.0 >= BLOCK {
                    self.close_block();
                }
            }
        }
    }

    fn rest(&mut self, piece: &Piece, extra: &Extra) {
        let output = output(&piece.at(0.0), 0.0);
        let holding = self.mechanism.loading(extra).at(&output).torque_nm;
        let carried = self.carried.get(piece.segment).copied().unwrap_or_default();
        let (until, again) = carried.ends(piece.duration_s);
        for (from, to, load) in [(0.0, until, holding), (until, again, 0.0), (again, piece.duration_s, holding)] {
            if to <= from {
                continue;
            }
            let first = self.nodes.len();
            for at in [from, to] {
                self.nodes.push(Node {
                    time_s: piece.start_s + at,
                    weight_s: 0.5 * (to - from),
                    acceleration_rad_s2: 0.0,
                    speed_rad_s: 0.0,
                    direction: 0.0,
                    load_nm: load,
                });
            }
            self.panels.push(Kept::of(&self.nodes, first, to - from, [0.0; 4]));
        }
        self.see(output.position_rad, piece.segment);
    }

    /// Updates the lowest and the highest position of a segment.
    fn see(&mut self, position_rad: f64, segment: usize) {
        if let Some(span) = self.spans.get_mut(segment) {
            let (low, high) = span.unwrap_or((position_rad, position_rad));
            *span = Some((low.min(position_rad), high.max(position_rad)));
        }
    }

    /// Returns the largest and the smallest J_L \[kgm²\], and the largest holding torque \[Nm\]. They depend on the
    /// position alone, and a segment passes every position between its lowest and its highest one.
    fn extremes(&self) -> ((f64, f64), f64) {
        let none = Extra::none();
        let (mut inertia, mut holding) = ((0.0_f64, f64::INFINITY), 0.0_f64);
        for (segment, span) in self.spans.iter().enumerate() {
            let Some((low, high)) = *span else { continue };
            let found = self.mechanism.extremes(low, high, self.extras.get(segment).unwrap_or(&none));
            inertia = (inertia.0.max(found.inertia_largest.si()), inertia.1.min(found.inertia_least.si()));
            holding = holding.max(found.holding.si());
        }
        (inertia, holding)
    }

    /// Returns the panel borders \[s\]: reversals, sign changes of the torque, kinks of the load, and equal parts short
    /// enough for the quadrature of a smooth integrand.
    fn cuts(&self, piece: &Piece, loading: &Loading<'_>, runs: &Runs) -> Vec<f64> {
        let mut cuts = vec![0.0];
        cuts.extend(runs.reversals());
        let ramp = piece.speed_degree().is_some_and(|degree| degree <= 1);
        let parts = parts(self.mechanism, piece);
        if !ramp {
            // The extremes of speed and acceleration become nodes.
            cuts.extend(piece.acceleration_roots());
            cuts.extend(piece.jerk_roots());
        }
        if !(ramp && self.mechanism.is_constant_over_ramps()) {
            // Enough spans that no two roots fall into one step of the search.
            let spans = (parts / PANELS_PER_SEARCH).ceil().max(1.0);
            let span = piece.duration_s / spans;
            // A root on the border of two spans lies inside neither.
            let mut border = 1.0;
            while border < spans {
                cuts.push(border * span);
                border += 1.0;
            }
            let state = piece.states();
            let at = |t: f64| output(&state(t), runs.direction(t));
            let looked = |output: Output| (output, loading.at(&output));
            let (mut seen, mut values) = (Vec::new(), Vec::new());
            let mut k = 0.0;
            while k < spans {
                let from = k * span;
                // All functions share the same search instants.
                seen.clear();
                seen.extend(root_steps(span).map(|t| looked(at(from + t))));
                let mut search = |f: &dyn Fn(&(Output, LoadTorque)) -> f64| {
                    values.clear();
                    values.extend(seen.iter().map(f));
                    let found = roots_between(&values, |t| f(&looked(at(from + t))), span);
                    cuts.extend(found.into_iter().map(|t| from + t));
                };
                // Without friction and losses both torques are equal and pass zero together.
                if seen.iter().any(|(_, load)| load.useful_nm != load.torque_nm) {
                    search(&|(_, load)| load.useful_nm);
                }
                search(&|(_, load)| load.torque_nm);
                if self.mechanism.stage.is_some() {
                    search(&|(_, load)| load.stage_nm);
                }
                if self.mechanism.has_lossy_sheaves() {
                    search(&|(_, load)| load.ropes_nm);
                }
                k += 1.0;
            }
        }
        if self.kinked {
            cuts.extend(kink_passes(self.mechanism, piece));
        }
        cuts.push(piece.duration_s);
        cuts.sort_by(f64::total_cmp);
        cuts.dedup_by(|a, b| (*a - *b).abs() <= 1e-12 * piece.duration_s);
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

    fn panel(&mut self, piece: &Piece, loading: &Loading<'_>, (from, to, direction): (f64, f64, f64), nodes: usize) {
        let mut travelled = 0.0;
        let (kinked, beside, state) = (self.kinked, 1e-9 * (to - from), piece.states());
        let first = self.nodes.len();
        for (u, weight) in lobatto(nodes) {
            // The last node takes the exact end, so that time never runs back into the next panel.
            let t = if *u == 1.0 { to } else { from + u * (to - from) };
            // At a kink of the load each panel takes the slope of its own side.
            let beside = if kinked { (t.max(from + beside)).min(to - beside) } else { t };
            let output = output(&state(beside), direction);
            let load = loading.at(&output);
            self.nodes.push(Node {
                time_s: piece.start_s + t,
                weight_s: weight * (to - from) * self.times,
                acceleration_rad_s2: output.acceleration_rad_s2,
                speed_rad_s: output.speed_rad_s,
                direction,
                load_nm: load.torque_nm,
            });
            travelled += self.times * weight * (to - from) * output.speed_rad_s * direction;
            self.see(output.position_rad, piece.segment);
        }
        let bow = curvature(self.nodes.get(first..).unwrap_or_default());
        self.panels.push(Kept::of(&self.nodes, first, to - from, bow));
        if let Some(share) = self.shares.get_mut(piece.segment) {
            share.travelled += Angle::from_si(travelled);
        }
    }
}

/// Computes the bound on the deviation of each signal from the straight line between two neighbouring nodes of a panel.
///
/// g²/8 Σ |a_j| P_j''(1), P_j''(1) = (j − 1) j (j + 1) (j + 2)/8
///
/// # Symbols
/// g widest gap on −1…1, a_j factors of the Legendre polynomials P_j, whose second derivative is largest at 1
/// # Source
/// docs/theory/moments.md
/// # Valid
/// with up to four nodes the signals of a law are straight
fn curvature(nodes: &[Node]) -> [f64; 4] {
    let mut bow = [0.0; 4];
    if nodes.len() <= STRAIGHT {
        return bow;
    }
    let rule = rule(nodes.len());
    let shares = rule.nodes();
    let gap = shares.iter().zip(shares.iter().skip(1)).map(|(a, b)| 2.0 * (b - a)).fold(0.0, f64::max);
    let mut j = 0.0;
    for factors in rule.coefficients_of(nodes.iter().map(Node::signals)) {
        for (bow, a) in bow.iter_mut().zip(factors) {
            *bow += a.abs() * (j - 1.0) * j * (j + 1.0) * (j + 2.0) / 8.0;
        }
        j += 1.0;
    }
    bow.map(|bow| bow * (gap * gap / 8.0))
}

/// Returns the number of whole revolutions that a piece makes at constant speed under a load with the period of one
/// revolution; `None` below two.
fn whole_revolutions(mechanism: &Mechanism, piece: &Piece) -> Option<f64> {
    let repeats = mechanism.depends_on_position()
        && mechanism.endless() == Endless::EachRevolution
        && piece.speed_degree() == Some(0)
        && piece.speed_rad_s != 0.0;
    let times = (turned(mechanism, piece) * (1.0 + 1e-14)).floor();
    (repeats && times >= 2.0).then_some(times)
}

/// Returns the number of revolutions of the load in a piece, estimated as duration times the largest speed at the ends
/// and quarters of the piece.
fn turned(mechanism: &Mechanism, piece: &Piece) -> f64 {
    let state = piece.states();
    let speed = [0.0, 0.25, 0.5, 0.75, 1.0].map(|u| state(u * piece.duration_s).speed_rad_s.abs());
    speed.into_iter().fold(0.0, f64::max) * piece.duration_s / (TAU * mechanism.stage_ratio().abs())
}

/// Returns the lowest and the highest position of a piece \[rad\], sampled at its ends, quarters and reversals.
fn extremes(piece: &Piece) -> [f64; 2] {
    let state = piece.states();
    let at = [0.0, 0.25, 0.5, 0.75, 1.0].into_iter().map(|u| u * piece.duration_s).chain(piece.runs().reversals());
    at.map(|t| state(t).position_rad)
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], q| [low.min(q), high.max(q)])
}

/// Cost of an instant between kinks relative to a regular one: no root search is needed there.
const BETWEEN_KINKS: f64 = 0.25;

/// Number of kink passes within recordings that cost as much as one stored instant.
const RECORDED_PASSES: f64 = 8.0;

/// Estimates the number of instants at which each piece is evaluated, by segment: panels times nodes, one revolution
/// representing all at constant speed, plus the panels between kinks, including those passed by recordings. Cuts at
/// reversals are not counted.
pub fn instants(mechanism: &Mechanism, motion: &Motion) -> Vec<(usize, f64)> {
    let (kinks, ratio) = (mechanism.kinks(), mechanism.stage_ratio());
    let at_kinks = |piece: &Piece, share: f64| {
        if kinks.is_empty() {
            return 0.0;
        }
        let at = |t: f64| piece.at(t).position_rad / ratio;
        let mut ends = piece.reversals();
        ends.push(share * piece.duration_s);
        let (mut from, mut found) = (at(0.0), 0.0);
        for to in ends.into_iter().map(at) {
            found += passes(mechanism, &kinks, from, to);
            from = to;
        }
        found * NODES_BETWEEN_KINKS as f64 * BETWEEN_KINKS
    };
    let of_recording = |placed: &Placed| (placed.segment, recorded_passes(mechanism, &kinks, placed) / RECORDED_PASSES);
    let recorded = motion.recordings().iter().filter(|_| !kinks.is_empty()).map(of_recording);
    let of = |piece: &Piece| {
        if piece.is_rest() {
            return 2.0;
        }
        let nodes = nodes_per_panel(mechanism, piece) as f64;
        match whole_revolutions(mechanism, piece) {
            // The representative revolution and the remainder.
            Some(times) => {
                nodes * (2.0 * parts(mechanism, piece) / times).max(1.0) + at_kinks(piece, (2.0 / times).min(1.0))
            }
            None => nodes * parts(mechanism, piece).max(1.0) + at_kinks(piece, 1.0),
        }
    };
    motion.pieces().iter().map(|piece| (piece.segment, of(piece))).chain(recorded).collect()
}

/// Returns the number of equal parts into which a piece is cut for the quadrature of a smooth integrand.
fn parts(mechanism: &Mechanism, piece: &Piece) -> f64 {
    let [amplitude, frequency, _] = piece.harmonic;
    let phase = if amplitude == 0.0 { 0.0 } else { frequency * piece.duration_s / PANEL_PHASE };
    if !mechanism.depends_on_position() {
        return phase.ceil();
    }
    let [low, high] = extremes(piece);
    let angle = mechanism.smooth_over(low, high).map_or(0.0, |panel| turned(mechanism, piece) * TAU / panel);
    phase.max(angle).ceil()
}

/// Returns the number of nodes per panel that integrates T², I² and T³ω exactly where they are polynomials in time.
fn nodes_per_panel(mechanism: &Mechanism, piece: &Piece) -> usize {
    if mechanism.depends_on_position() {
        return 16;
    }
    let viscous = !mechanism.is_constant_over_ramps();
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

/// Merges the blocks into runs of stored panels and whole recordings.
fn runs(blocks: &[Block]) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for block in blocks {
        match (&block.place, runs.last_mut()) {
            (BlockPanels::Kept(range), _) if block.times > 1.0 => runs.push(Run::Repeated(range.clone(), block.times)),
            (BlockPanels::Kept(range), Some(Run::Kept(run))) => run.end = range.end,
            (BlockPanels::Kept(range), _) => runs.push(Run::Kept(range.clone())),
            (BlockPanels::Recorded { strip, .. }, Some(Run::Recorded(run))) if run == strip => {}
            (BlockPanels::Recorded { strip, .. }, _) => runs.push(Run::Recorded(*strip)),
        }
    }
    runs
}

/// Groups the blocks of recordings.
fn groups(blocks: &[Block]) -> Vec<Group> {
    let mut groups = Vec::new();
    let mut from = 0;
    for alike in blocks.chunk_by(|a, b| a.is_recorded() == b.is_recorded()) {
        if alike.first().is_some_and(Block::is_recorded) {
            for (part, first) in alike.chunks(GROUP).zip((from..).step_by(GROUP)) {
                let mut extent = Extent::NONE;
                part.iter().for_each(|block| extent.join(&block.extent));
                let start = part.first().map_or(0.0, |block| block.from_s);
                groups.push(Group { blocks: first..first + part.len(), extent, from: start });
            }
        }
        from += alike.len();
    }
    groups
}

/// Returns the motion of the output at an instant.
const fn output(state: &State, direction: f64) -> Output {
    Output {
        position_rad: state.position_rad,
        speed_rad_s: state.speed_rad_s,
        acceleration_rad_s2: state.acceleration_rad_s2,
        direction,
    }
}
