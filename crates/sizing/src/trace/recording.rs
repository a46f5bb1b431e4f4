//! A recording under its load: bounds and sums of its blocks in one pass; the nodes of a long one are made when they are
//! looked at.

mod bent;
mod cells;

pub(crate) use cells::{Cell, Inside};

use super::cubes::Moments;
use super::gains::{Gain, GainTables, LagBlock, Lagging, Products, largest};
use super::{Block, Extent, Form, Gram, Kept, Node, Panel, Place};
use cells::Cells;
use mechanism::{Extra, Mechanism, Plain};
use motion::{Interval, Placed};
use quantities::Measure;
use std::ops::Range;
use std::sync::{Arc, OnceLock};
use wide::f64x4;

/// From so many intervals two threads share the pass; the sums are those of one thread to the last bit.
const SHARED_FROM: usize = 1 << 16;

/// A block holds at most so many intervals of a recording.
pub(super) const INTERVALS: usize = 256;

/// And lasts about so long at most \[s\], unless that were less than [`INTERVALS_LEAST`]: short enough that the models of
/// heat may take it as a whole.
const BLOCK_S: f64 = 0.5;

/// So many intervals a block holds at least.
const INTERVALS_LEAST: usize = 16;

/// A recording with what it moves.
#[derive(Clone, Debug)]
pub(crate) struct Strip {
    placed: Placed,
    /// What the survey looks at: of a plain mechanism the recording by itself.
    surveyed: Placed,
    mechanism: Mechanism,
    extra: Extra,
    plain: Option<Plain>,
    /// Positions at which the load has a corner.
    kinks: Vec<f64>,
    view: View,
    survey: Arc<Survey>,
}

/// How the signals of a strip follow from those that its survey holds.
///
/// α = α_0/f², ω = ω_0/f, T_L = R + J α + T_c σ + b ω, t = t_0 + f t'
///
/// # Symbols  f stretch of the time; R recorded torque and what does not change over the motion \[Nm\]
/// # Source   docs/theory/moments.md
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct View {
    inertia: f64,
    coulomb: f64,
    viscous: f64,
    stretch: f64,
    start: f64,
}

impl View {
    fn node(&self, raw: &Node) -> Node {
        let (acceleration, speed) = (raw.acceleration / (self.stretch * self.stretch), raw.speed / self.stretch);
        Node {
            time: self.start + self.stretch * raw.time,
            weight: self.stretch * raw.weight,
            acceleration,
            speed,
            direction: raw.direction,
            load: raw.load + self.inertia * acceleration + self.coulomb * raw.direction + self.viscous * speed,
        }
    }

    /// Row i gives signal i from those of the survey.
    fn rows(&self) -> [[f64; 4]; 4] {
        let slow = 1.0 / self.stretch;
        let slower = slow * slow;
        [
            [slower, 0.0, 0.0, 0.0],
            [self.inertia * slower, 1.0, self.coulomb, self.viscous * slow],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, slow],
        ]
    }

    /// A G Aᵀ with the rows above, over a time that is longer by the stretch.
    fn gram(&self, raw: &Gram) -> Gram {
        let slow = 1.0 / self.stretch;
        let (a, j, c, b) = (slow * slow, self.inertia * slow * slow, self.coulomb, self.viscous * slow);
        let [ga, gt, gs, gw] = raw.0;
        let torque = |[ga, gt, gs, gw]: [f64; 4]| j * ga + gt + c * gs + b * gw;
        let (ta, tt, ts, tw) = (torque(ga), torque(gt), torque(gs), torque(gw));
        let f = self.stretch;
        let [aa, at, as_, aw] = [f * a * a * ga[0], f * a * ta, f * a * ga[2], f * a * slow * ga[3]];
        let [ttt, tts, ttw] = [f * (j * ta + tt + c * ts + b * tw), f * ts, f * slow * tw];
        let [ss, sw, ww] = [f * gs[2], f * slow * gs[3], f * slow * slow * gw[3]];
        Gram([[aa, at, as_, aw], [at, ttt, tts, ttw], [as_, tts, ss, sw], [aw, ttw, sw, ww]])
    }

    /// The weights of the signals of the survey that make the same sum as others of those under the load: Aᵀ c.
    fn weights(&self, c: [f64; 4]) -> [f64; 4] {
        let mut raw = [0.0; 4];
        for (row, c) in self.rows().iter().zip(c) {
            raw.iter_mut().zip(row).for_each(|(raw, a)| *raw += c * a);
        }
        raw
    }

    fn extent(&self, raw: &Extent) -> Extent {
        let times = |(low, high): (f64, f64), factor: f64| (low * factor, high * factor);
        let slow = 1.0 / self.stretch;
        let (acceleration, speeds) = (times(raw.acceleration, slow * slow), times(raw.speeds, slow));
        let parts = [
            raw.load,
            times(acceleration, self.inertia),
            times(raw.direction, self.coulomb),
            times(speeds, self.viscous),
        ];
        let load = parts.iter().fold((0.0, 0.0), |(low, high), part| (low + part.0, high + part.1));
        // The nodes are rounded otherwise than the sums here; the bounds must hold for them too.
        let room = 8.0 * f64::EPSILON * parts.iter().map(|part| part.0.abs().max(part.1.abs())).sum::<f64>();
        let load = (load.0 - room, load.1 + room);
        Extent { acceleration, load, speeds, speed: raw.speed * slow, direction: raw.direction }
    }

    /// Qʹ = Aᵀ Q A: the same form of the signals of the survey.
    pub(super) fn form(&self, form: &Form) -> Form {
        let rows = self.rows();
        let mut raw = Form::default();
        for (q, a) in form.0.iter().zip(&rows) {
            for (q, b) in q.iter().zip(&rows) {
                raw = raw.add(&Form::product(*a, *b).scale(*q));
            }
        }
        raw
    }

    pub(super) const fn stretch(&self) -> f64 {
        self.stretch
    }
}

/// What one pass over a recording finds, in the signals before the view.
#[derive(Debug)]
pub(super) struct Survey {
    blocks: Vec<Block>,
    /// Smallest and largest J_L \[kgm²\] and holding torque \[Nm\] over the positions; of a plain mechanism not needed.
    by_position: Option<((f64, f64), f64)>,
    /// Lowest and highest recorded position \[rad\].
    span: (f64, f64),
    lags: OnceLock<Vec<LagBlock>>,
    largest_swings: OnceLock<Products>,
    lag_parts: Vec<OnceLock<Vec<LagPart>>>,
    cubes: OnceLock<Vec<Moments>>,
    cells: OnceLock<Cells>,
    pub(super) gains: GainTables,
}

/// What a recording contributes to a trace.
pub(super) struct Found {
    pub(super) blocks: Vec<Block>,
    /// Smallest and largest J_L \[kgm²\].
    pub(super) inertia: (f64, f64),
    /// Lowest and highest position \[rad\].
    pub(super) span: (f64, f64),
    /// Largest magnitude of the holding torque \[Nm\].
    pub(super) holding: f64,
}

/// A part of an interval in which the direction does not change, from one share of it to another.
type Part = (f64, f64, f64);

impl Strip {
    /// A recording under a load; the survey of one of the known strips serves if only the view differs.
    pub(super) fn new(placed: Placed, mechanism: Mechanism, extra: Extra, known: &[Self]) -> Self {
        let plain = mechanism.plain(&extra);
        let view = match &plain {
            Some(plain) => View {
                inertia: plain.inertia_kgm2,
                coulomb: plain.coulomb_nm,
                viscous: plain.viscous_nms,
                stretch: placed.stretch,
                start: placed.start_s,
            },
            None => View { inertia: 0.0, coulomb: 0.0, viscous: 0.0, stretch: 1.0, start: 0.0 },
        };
        let same = |other: &&Self| {
            let constant = |plain: &Option<Plain>| plain.map(|plain| plain.constant_nm);
            plain.is_some()
                && constant(&other.plain) == constant(&plain)
                && Arc::ptr_eq(&other.placed.recorded, &placed.recorded)
        };
        let known = known.iter().find(same).map(|other| Arc::clone(&other.survey));
        let surveyed = match &plain {
            Some(_) => Placed { start_s: 0.0, offset_rad: 0.0, stretch: 1.0, ..placed.clone() },
            None => placed.clone(),
        };
        let kinks = mechanism.kinks();
        let mut strip =
            Self { placed, surveyed, mechanism, extra, plain, kinks, view, survey: Arc::new(Survey::empty()) };
        strip.survey = known.unwrap_or_else(|| Arc::new(strip.look()));
        strip
    }

    /// The panels of an interval, one for each direction: both ends and the middle with the weights of Simpson's rule. Where
    /// the load depends on the position or has losses there are more, see [`Self::bent_interval`].
    pub(super) fn interval(&self, index: usize, look: &mut impl FnMut(Panel<'_>)) {
        if self.plain.is_none() {
            self.raw_interval(index, look);
            return;
        }
        self.raw_interval(index, &mut |panel| {
            if let [a, b, c] = panel.nodes {
                let nodes = [a, b, c].map(|node| self.view.node(node));
                look(Panel { nodes: &nodes, duration: panel.duration * self.view.stretch, bow: panel.bow });
            }
        });
    }

    /// The same in the signals of the survey: of a plain mechanism those of the recording by itself.
    fn raw_interval(&self, index: usize, look: &mut impl FnMut(Panel<'_>)) {
        let Some(interval) = self.surveyed.interval(index) else { return };
        let Some(plain) = &self.plain else {
            self.bent_interval(&interval, look);
            return;
        };
        let acceleration = interval.acceleration_rad_s2();
        for (from, to, direction) in parts(&interval) {
            let duration = (to - from) * interval.duration_s;
            let nodes = [(0.0, 1.0 / 6.0), (0.5, 4.0 / 6.0), (1.0, 1.0 / 6.0)].map(|(share, weight)| {
                let u = if share == 1.0 { to } else { from + share * (to - from) };
                let (_, speed, torque) = interval.at(u);
                Node {
                    time: interval.start_s + u * interval.duration_s,
                    weight: weight * duration,
                    acceleration,
                    speed,
                    direction,
                    load: torque + plain.constant_nm,
                }
            });
            look(Panel { nodes: &nodes, duration, bow: [0.0; 4] });
        }
    }

    pub(super) fn intervals(&self) -> usize {
        self.placed.intervals()
    }

    /// Makes the panels of a block once and for all.
    pub(super) fn keep(&self, block: &mut Block, nodes: &mut Vec<Node>, panels: &mut Vec<Kept>) {
        if let Place::Recorded { intervals, .. } = &block.place {
            let from = panels.len();
            for index in intervals.clone() {
                self.interval(index, &mut |panel| {
                    let first = nodes.len();
                    nodes.extend_from_slice(panel.nodes);
                    panels.push(Kept { nodes: first..nodes.len(), duration: panel.duration, bow: panel.bow });
                });
            }
            block.place = Place::Kept(from..panels.len());
        }
    }

    /// So many intervals make a block.
    pub(super) fn block_intervals(&self) -> usize {
        let time = self.placed.recorded.time_s();
        let whole = time.last().zip(time.first()).map_or(0.0, |(last, first)| last - first);
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            clippy::cast_precision_loss,
            reason = "a count; what is out of range is clamped"
        )]
        let fitting = (BLOCK_S / whole * self.placed.intervals() as f64) as usize;
        fitting.clamp(INTERVALS_LEAST, INTERVALS) / LANES * LANES
    }

    /// One pass over all samples.
    fn look(&self) -> Survey {
        let (intervals, most) = (self.placed.intervals(), self.block_intervals());
        let ranges: Vec<Range<usize>> =
            (0..intervals).step_by(most).map(|from| from..(from + most).min(intervals)).collect();
        let blocks = in_two(&ranges, intervals >= SHARED_FROM, &|range| self.block(range.clone()));
        let positions = self.placed.recorded.position_rad();
        let span = range(positions);
        let by_position = self.mechanism.depends_on_position().then(|| {
            let (mut inertia, mut holding) = ((f64::INFINITY, f64::NEG_INFINITY), 0.0_f64);
            for q in positions {
                let q = q + self.placed.offset_rad;
                let here = self.mechanism.inertia(q, &self.extra).si();
                inertia = (inertia.0.min(here), inertia.1.max(here));
                holding = holding.max(self.mechanism.holding_torque(q, &self.extra).si().abs());
            }
            (inertia, holding)
        });
        Survey {
            cells: OnceLock::new(),
            lag_parts: blocks.iter().map(|_| OnceLock::new()).collect(),
            blocks,
            by_position,
            span,
            lags: OnceLock::new(),
            largest_swings: OnceLock::new(),
            cubes: OnceLock::new(),
            gains: GainTables::default(),
        }
    }

    /// What the survey says under this load, with the blocks of the strip of this number.
    pub(super) fn found(&self, own: usize) -> Found {
        let offset = self.placed.offset_rad;
        let block = |raw: &Block| {
            let place = match &raw.place {
                Place::Recorded { intervals, .. } => Place::Recorded { strip: own, intervals: intervals.clone() },
                kept @ Place::Kept(_) => kept.clone(),
            };
            if self.plain.is_none() {
                return Block { place, ..raw.clone() };
            }
            Block {
                place,
                times: 1.0,
                from: self.view.start + raw.from * self.view.stretch,
                duration: raw.duration * self.view.stretch,
                extent: self.view.extent(&raw.extent),
                gram: self.view.gram(&raw.gram),
            }
        };
        let (inertia, holding) = self.survey.by_position.unwrap_or_else(|| {
            let inertia = self.mechanism.inertia(0.0, &self.extra).si();
            ((inertia, inertia), self.mechanism.holding_torque(0.0, &self.extra).si().abs())
        });
        Found {
            blocks: self.survey.blocks.iter().map(block).collect(),
            inertia,
            span: (self.survey.span.0 + offset, self.survey.span.1 + offset),
            holding,
        }
    }

    pub(super) const fn view(&self) -> &View {
        &self.view
    }

    pub(super) fn survey(&self) -> &Survey {
        &self.survey
    }

    /// What lags need of each block, found when the first lag is asked for.
    pub(super) fn lag_blocks(&self) -> &[LagBlock] {
        self.survey.lags.get_or_init(|| {
            in_two(&self.survey.blocks, self.placed.intervals() >= SHARED_FROM, &|block| {
                let Place::Recorded { intervals, .. } = &block.place else { return LagBlock::default() };
                self.lag_block(block.duration, block.extent.direction, intervals)
            })
        })
    }

    /// What lags need of some intervals.
    fn lag_block(&self, duration: f64, (back, forth): (f64, f64), intervals: &Range<usize>) -> LagBlock {
        if let (Some(plain), None, true) = (&self.plain, self.surveyed.recorded.torque_nm(), back == forth) {
            let intervals = intervals.clone().filter_map(|index| self.surveyed.interval(index));
            return LagBlock::straight(duration, [plain.constant_nm, back], intervals);
        }
        LagBlock::of(duration, |look| {
            intervals.clone().for_each(|index| self.raw_interval(index, &mut |panel| look(panel)));
        })
    }

    /// What lags need of the parts of a block, found when it is first looked into.
    pub(super) fn lag_parts(&self, block: usize) -> &[LagPart] {
        let (Some(parts), Some(whole)) = (self.survey.lag_parts.get(block), self.survey.blocks.get(block)) else {
            return &[];
        };
        parts.get_or_init(|| {
            let Place::Recorded { intervals, .. } = &whole.place else { return Vec::new() };
            let part = |from: usize| {
                let intervals = from..(from + PART).min(intervals.end);
                let each = || intervals.clone().filter_map(|index| self.surveyed.interval(index));
                let duration = each().map(|interval| interval.duration_s).sum();
                LagPart { lag: self.lag_block(duration, whole.extent.direction, &intervals), intervals }
            };
            intervals.clone().step_by(PART).map(part).collect()
        })
    }

    /// The instant at which a part ends \[s\].
    pub(super) fn end_of(&self, part: &LagPart) -> f64 {
        let time = self.placed.recorded.time_s().get(part.intervals.end).copied().unwrap_or(0.0);
        self.placed.start_s + time * self.placed.stretch
    }

    /// The moments of a cell for the cube of a torque; of a plain mechanism only, whose intervals are straight.
    pub(super) fn cubic(&self, cell: &Cell) -> Option<&Moments> {
        self.plain.as_ref()?;
        self.survey.cubes.get_or_init(|| self.cells().moments(self)).get(cell.number as usize)
    }

    /// The panels of a block in the signals of the survey.
    pub(super) fn raw_panels(&self, block: &Block, look: &mut dyn FnMut(Panel<'_>)) {
        if let Place::Recorded { intervals, .. } = &block.place {
            intervals.clone().for_each(|index| self.raw_interval(index, &mut |panel| look(panel)));
        }
    }

    /// The intervals by their signals, found when they are first asked for.
    fn cells(&self) -> &Cells {
        self.survey.cells.get_or_init(|| Cells::of(self))
    }

    /// The cell of all intervals.
    pub(crate) fn root(&self) -> Option<&Cell> {
        self.cells().root()
    }

    /// The two cells within one.
    pub(crate) fn halves(&self, halves: [u32; 2]) -> [Option<&Cell>; 2] {
        self.cells().halves(halves)
    }

    /// The panels of the intervals of a cell.
    pub(crate) fn panels_within(&self, (from, to): (u32, u32), look: &mut impl FnMut(Panel<'_>)) {
        self.cells().intervals(from, to).for_each(|index| self.interval(index, look));
    }

    /// The weights of the signals of the cells that make the same sum as others of those under the load.
    pub(crate) fn weights(&self, c: [f64; 4]) -> [f64; 4] {
        if self.plain.is_some() { self.view.weights(c) } else { c }
    }

    /// By which factor the time of the cells is stretched.
    pub(crate) fn stretch(&self) -> f64 {
        if self.plain.is_some() { self.view.stretch } else { 1.0 }
    }

    /// Bounds of a cell under the load, and the instant at which the first of its intervals begins.
    pub(super) fn seen(&self, cell: &Cell) -> (Extent, f64) {
        if self.plain.is_some() {
            (self.view.extent(&cell.extent), self.view.start + cell.from * self.view.stretch)
        } else {
            (cell.extent, cell.from)
        }
    }

    /// The panels of a block under the load.
    pub(super) fn panels(&self, block: &Block, look: &mut impl FnMut(Panel<'_>)) {
        if let Place::Recorded { intervals, .. } = &block.place {
            intervals.clone().for_each(|index| self.interval(index, look));
        }
    }

    /// What the blocks do to a lag of the signals of the survey.
    pub(super) fn gains(&self, tau_s: f64) -> Vec<Gain> {
        let mut lagging = Lagging::of(tau_s);
        let gain = |(number, (block, lag)): (usize, (&Block, &LagBlock))| {
            // Not even asked for where they cannot be short enough.
            let parts = self.block_intervals().div_ceil(PART) as f64;
            if lag.is_short(tau_s) || !lag.is_short(parts * tau_s) || !self.has_short_parts(number, tau_s) {
                return lag.gain(&mut lagging, |look| self.raw_panels(block, look));
            }
            // Where the moments of a block do not serve, those of its parts may.
            let mut gain = Gain::NONE;
            self.part_gains(number, tau_s).iter().for_each(|part| gain.then(part));
            gain
        };
        self.survey.blocks.iter().zip(self.lag_blocks()).enumerate().map(gain).collect()
    }

    fn has_short_parts(&self, block: usize, tau_s: f64) -> bool {
        self.lag_parts(block).iter().all(|part| part.lag.is_short(tau_s))
    }

    /// What the parts of a block do to a lag of the signals of the survey.
    pub(super) fn part_gains(&self, block: usize, tau_s: f64) -> Vec<Gain> {
        let mut lagging = Lagging::of(tau_s);
        let gain = |part: &LagPart| {
            part.lag.gain(&mut lagging, |look| {
                part.intervals.clone().for_each(|index| self.raw_interval(index, &mut |panel| look(panel)));
            })
        };
        self.lag_parts(block).iter().map(gain).collect()
    }

    /// The largest swings of all blocks.
    pub(super) fn largest_swings(&self) -> &Products {
        self.survey.largest_swings.get_or_init(|| largest(self.lag_blocks().iter().map(|block| &block.swing)))
    }

    /// The blocks in the signals of the survey.
    pub(super) fn raw_blocks(&self) -> &[Block] {
        &self.survey.blocks
    }

    pub(super) fn block(&self, intervals: Range<usize>) -> Block {
        let place = Place::Recorded { strip: 0, intervals: intervals.clone() };
        let mut block = Block::empty(place.clone());
        block.from = self.surveyed.interval(intervals.start).map_or(0.0, |interval| interval.start_s);
        let mut from = intervals.start;
        while from < intervals.end {
            // Up to where the axis turns round, starts or stops; one interval at least.
            let to = self.one_way(from, intervals.end).max(from + 1);
            let many = from + (to - from) / LANES * LANES;
            let sums = self.plain.as_ref().filter(|_| many > from);
            if let Some(part) = sums.and_then(|plain| self.quick(plain, &place, from..many)) {
                block.join(&part);
                from = many;
            }
            let mut add = |panel: Panel<'_>| block.add(&panel);
            (from..to).for_each(|index| self.raw_interval(index, &mut add));
            from = to;
        }
        block
    }

    /// The first interval from one on that is not run through in the direction in which that one begins.
    fn one_way(&self, from: usize, end: usize) -> usize {
        let speeds = self.placed.recorded.speed_rad_s().get(from..=end).unwrap_or_default();
        let Some(first) = speeds.first() else { return end };
        let other = if *first > 0.0 {
            speeds.iter().position(|speed| *speed <= 0.0)
        } else if *first < 0.0 {
            speeds.iter().position(|speed| *speed >= 0.0)
        } else {
            speeds.iter().position(|speed| *speed != 0.0)
        };
        // The interval before that sample has it as its end.
        other.map_or(end, |sample| from + sample.saturating_sub(1))
    }

    /// The block of a plain mechanism that turns one way all through it, or rests, several intervals at a time.
    ///
    /// With α constant, ω and τ straight over an interval of length h the products of the four signals integrate to
    /// ∫α² = α Δω, ∫ω² = h (s² − ω_0 ω_1)/3, ∫ω = h s/2 with s = ω_0 + ω_1, and alike for τ; those of α with ω and with a
    /// constant add up to what lies between the ends of the block. R = τ + T_h mixes them.
    fn quick(&self, plain: &Plain, place: &Place, intervals: Range<usize>) -> Option<Block> {
        let recorded = &*self.placed.recorded;
        let samples = intervals.start..intervals.end + 1;
        let time = recorded.time_s().get(samples.clone())?;
        let speed = recorded.speed_rad_s().get(samples.clone())?;
        let torque = recorded.torque_nm().and_then(|torque| torque.get(samples));
        if !intervals.len().is_multiple_of(LANES) {
            return None;
        }
        let (slowest, fastest) = range(speed);
        let direction = if slowest > 0.0 {
            1.0
        } else if fastest < 0.0 {
            -1.0
        } else if slowest == 0.0 && fastest == 0.0 {
            0.0
        } else {
            return None;
        };
        let all = f64x4::splat;
        let [mut aa, mut ww, mut w, mut tt, mut ta, mut tw, mut t] = [f64x4::ZERO; 7];
        let [mut a_low, mut l_low] = [all(f64::INFINITY); 2];
        let [mut a_high, mut l_high] = [all(f64::NEG_INFINITY); 2];
        let mut from = 0;
        while from < intervals.len() {
            // LANES samples from one on, and the next ones.
            let ends = |values: &[f64]| -> Option<(f64x4, f64x4)> {
                let first: [f64; LANES] = values.get(from..from + LANES)?.try_into().ok()?;
                let next: [f64; LANES] = values.get(from + 1..=from + LANES)?.try_into().ok()?;
                Some((f64x4::new(first), f64x4::new(next)))
            };
            let ((at, next), (w0, w1)) = (ends(time)?, ends(speed)?);
            let (t0, t1) = match torque {
                Some(torque) => ends(torque)?,
                None => (f64x4::ZERO, f64x4::ZERO),
            };
            let h = next - at;
            let (dw, s, p) = (w1 - w0, w0 + w1, t0 + t1);
            let a = dw / h;
            aa += a * dw;
            ww += h * (s * s - w0 * w1);
            w += h * s;
            tt += h * (p * p - t0 * t1);
            ta += dw * p;
            tw += h * (s * p + t0 * w0 + t1 * w1);
            t += h * p;
            (a_low, a_high) = (a_low.fast_min(a), a_high.fast_max(a));
            (l_low, l_high) = (l_low.fast_min(t0).fast_min(t1), l_high.fast_max(t0).fast_max(t1));
            from += LANES;
        }
        let (a_low, a_high) = (range(a_low.as_array()).0, range(a_high.as_array()).1);
        let (l_low, l_high) = (range(l_low.as_array()).0, range(l_high.as_array()).1);
        let sum = |lanes: f64x4| lanes.as_array().iter().sum::<f64>();
        let duration = time.last()? - time.first()?;
        let (first, last) = (speed.first()?, speed.last()?);
        let sums = Sums {
            aa: sum(aa),
            ww: sum(ww) / 3.0,
            w: sum(w) / 2.0,
            tt: sum(tt) / 3.0,
            ta: sum(ta) / 2.0,
            tw: sum(tw) / 6.0,
            t: sum(t) / 2.0,
            a: last - first,
            aw: 0.5 * (last * last - first * first),
            duration,
        };
        Some(Block {
            place: place.clone(),
            times: 1.0,
            from: *time.first()?,
            duration,
            extent: bounds(plain, direction, (a_low, a_high), (l_low, l_high), (slowest, fastest)),
            gram: sums.gram(plain, direction),
        })
    }
}

/// Integrals over straight intervals of one direction: of the products of α, ω and the recorded torque τ.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    aa: f64,
    ww: f64,
    w: f64,
    tt: f64,
    ta: f64,
    tw: f64,
    t: f64,
    a: f64,
    aw: f64,
    duration: f64,
}

impl Sums {
    /// ∫α² = α Δω, ∫ω² = h (s² − ω_0 ω_1)/3, ∫ω = h s/2 with s = ω_0 + ω_1, and alike for τ.
    fn add(&mut self, interval: &Interval) {
        let (h, [w0, w1], [t0, t1]) = (interval.duration_s, interval.speed_rad_s, interval.torque_nm);
        let (dw, s, p) = (w1 - w0, w0 + w1, t0 + t1);
        self.aa += dw / h * dw;
        self.ww += h * (s * s - w0 * w1) / 3.0;
        self.w += 0.5 * h * s;
        self.tt += h * (p * p - t0 * t1) / 3.0;
        self.ta += 0.5 * dw * p;
        self.tw += h * (s * p + t0 * w0 + t1 * w1) / 6.0;
        self.t += 0.5 * h * p;
        self.a += dw;
        self.aw += 0.5 * dw * s;
        self.duration += h;
    }

    /// The products of (α, R, σ, ω) out of those of the basis (α, τ, 1, ω), R = τ + T_h.
    fn gram(&self, plain: &Plain, direction: f64) -> Gram {
        let Self { aa, ww, w, tt, ta, tw, t, a, aw, duration } = *self;
        let basis = Gram([[aa, ta, a, aw], [ta, tt, t, tw], [a, t, duration, w], [aw, tw, w, ww]]);
        let constant = plain.constant_nm;
        let rows = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, constant, 0.0], [0.0, 0.0, direction, 0.0], [0.0, 0.0, 0.0, 1.0]];
        Gram(rows.map(|a| rows.map(|b| basis.product(a, b))))
    }
}

/// The bounds of straight intervals of one direction, by those of α, τ and ω. The nodes are rounded otherwise than what these
/// were found of; the bounds must hold for them too.
fn bounds(plain: &Plain, direction: f64, acceleration: (f64, f64), torque: (f64, f64), speeds: (f64, f64)) -> Extent {
    let wider = |(low, high): (f64, f64)| {
        let room = 8.0 * f64::EPSILON * f64::max(-low, high).abs();
        (low - room, high + room)
    };
    let load = (torque.0 + plain.constant_nm, torque.1 + plain.constant_nm);
    Extent {
        acceleration: wider(acceleration),
        load: wider(load),
        direction: (direction, direction),
        speeds,
        speed: f64::max(speeds.1, -speeds.0),
    }
}

impl Survey {
    fn empty() -> Self {
        Self {
            blocks: Vec::new(),
            by_position: None,
            span: (0.0, 0.0),
            lags: OnceLock::new(),
            largest_swings: OnceLock::new(),
            lag_parts: Vec::new(),
            cubes: OnceLock::new(),
            cells: OnceLock::new(),
            gains: GainTables::default(),
        }
    }
}

/// The answers for all items in their order, the second half by another thread where that is worth it.
fn in_two<I: Sync, O: Send>(items: &[I], shared: bool, of: &(impl Fn(&I) -> O + Sync)) -> Vec<O> {
    let work = |items: &[I]| -> Vec<O> { items.iter().map(of).collect() };
    if !shared {
        return work(items);
    }
    let (first, second) = items.split_at(items.len() / 2);
    std::thread::scope(|scope| {
        let other = scope.spawn(|| work(second));
        let mut all = work(first);
        // A thread that could not finish leaves its part to this one.
        all.extend(other.join().unwrap_or_else(|_| work(second)));
        all
    })
}

/// A part of a block has so many intervals.
const PART: usize = 16;

/// What any lag needs of a part of a block.
#[derive(Debug)]
pub(super) struct LagPart {
    pub(super) intervals: Range<usize>,
    pub(super) lag: LagBlock,
}

/// So many intervals run side by side.
const LANES: usize = 4;

/// Smallest and largest value.
fn range(values: &[f64]) -> (f64, f64) {
    let (mut low, mut high) = ([f64::INFINITY; LANES], [f64::NEG_INFINITY; LANES]);
    let (lanes, rest) = values.as_chunks::<LANES>();
    for lane in lanes {
        for ((low, high), value) in low.iter_mut().zip(&mut high).zip(lane) {
            *low = if *value < *low { *value } else { *low };
            *high = if *value > *high { *value } else { *high };
        }
    }
    let all = low.iter().chain(&high).chain(rest).copied().filter(|value| value.is_finite());
    all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

/// The parts of an interval in each of which the speed keeps its sign; the zero of a straight speed between them.
fn parts(interval: &Interval) -> impl Iterator<Item = Part> {
    let [first, last] = interval.speed_rad_s;
    let zero = if first * last < 0.0 { first / (first - last) } else { 1.0 };
    let sign = |speed: f64| if speed == 0.0 { 0.0 } else { speed.signum() };
    let before = (0.0, zero, sign(if first == 0.0 { last } else { first }));
    let after = (zero < 1.0).then_some((zero, 1.0, sign(last)));
    [Some(before), after].into_iter().flatten()
}
