//! A recording under its load: bounds and sums of its blocks from one pass. The nodes of a long recording are computed
//! each time they are read.

mod bent;
mod cells;
mod lagging;
mod loads;
mod straight;
mod sweep;
mod view;

use view::View;

pub use cells::{Cell, Inside};
pub use sweep::{Ramps, Swept};

use super::cubes::Moments;
use super::gains::{GainTables, LagBlock, Products};
use super::kinks::recorded_passes;
use super::{Block, BlockPanels, Extent, Kept, Node, Panel};
use cells::Cells;
use lagging::LagPart;
use loads::Known;
use mechanism::{Extra, Mechanism, Plain};
use motion::{Interval, Placed};
use std::ops::Range;
use std::sync::{Arc, OnceLock};

/// Number of intervals from which two threads share the pass; the sums equal those of one thread to the last bit.
const SHARED_FROM: usize = 1 << 16;

/// Maximum number of intervals of a recording in a block.
pub(super) const INTERVALS: usize = 256;

/// Approximate maximum duration of a block \[s\], unless it held fewer than [`INTERVALS_LEAST`] intervals: short enough
/// for the thermal models to take it as a whole.
const BLOCK_S: f64 = 0.5;

/// Minimum number of intervals in a block.
const INTERVALS_LEAST: usize = 16;

/// A recording with the mechanism that it moves.
#[derive(Clone, Debug)]
pub struct Strip {
    placed: Placed,
    /// Recording as the survey evaluates it: unscaled for a plain mechanism, else as placed.
    surveyed: Placed,
    mechanism: Mechanism,
    extra: Extra,
    /// Parts of the load if it is a sum with constant factors; the survey is then seen through the view.
    plain: Option<Plain>,
    /// Weight with which the survey was made \[Nm\].
    surveyed_weight_nm: f64,
    /// Positions at which the load has a kink \[rad\].
    kinks: Vec<f64>,
    view: View,
    /// Loads of intervals that are not straight: for a load that is a sum the part independent of pace, else the whole
    /// load.
    loads: Arc<Known>,
    survey: Arc<Survey>,
    /// Index of the first strip of the trace with the same signals at its own instants: its own index unless the
    /// recording recurs.
    pub(super) first: usize,
}

/// Surveys of long recordings, for other traces of the same recordings.
#[derive(Clone, Debug, Default)]
pub struct Surveys(pub(super) Vec<Strip>);

/// Result of one pass over a recording, in the signals before the view.
#[derive(Debug)]
pub(super) struct Survey {
    blocks: Vec<Block>,
    /// Lowest and highest recorded position \[rad\].
    span: (f64, f64),
    lags: OnceLock<Vec<LagBlock>>,
    largest_swings: OnceLock<Products>,
    lag_parts: Vec<OnceLock<Vec<LagPart>>>,
    cubes: OnceLock<Vec<Moments>>,
    cells: OnceLock<Cells>,
    pub(super) gains: GainTables,
}

/// Contribution of a recording to a trace.
pub(super) struct Found {
    pub(super) blocks: Vec<Block>,
    /// Lowest and highest position \[rad\].
    pub(super) span: (f64, f64),
}

/// Maximum number of nodes in a panel of an interval.
const NODES: usize = 16;

/// A part of an interval with one direction: start and end as shares of the interval, and the direction.
type Part = (f64, f64, f64);

impl Strip {
    /// Creates the strip of a recording under a load; reuses the survey of one of the known strips if only the view
    /// differs, or of a recalled one if a survey made now would be the same.
    pub(super) fn new<'k>(
        placed: Placed,
        mechanism: Mechanism,
        extra: Extra,
        known: impl IntoIterator<Item = &'k Self>,
        recalled: &'k [Self],
    ) -> Self {
        let plain = mechanism.plain(&extra);
        let view = match &plain {
            Some(plain) => View {
                inertia: plain.inertia_kgm2,
                coulomb: plain.coulomb_nm,
                viscous: plain.viscous_nms,
                stretch: placed.stretch,
                start: placed.start_s,
                ..View::NONE
            },
            None => View::NONE,
        };
        let surveyed = match &plain {
            Some(_) => Placed { start_s: 0.0, stretch: 1.0, ..placed.clone() },
            None => placed.clone(),
        };
        let known = plain.and_then(|plain| {
            let is_same = |other: &&Self| other.shows(&plain, &placed) && other.surveyed_weight_nm == plain.weight_nm;
            known.into_iter().find(|other| other.shows(&plain, &placed)).or_else(|| recalled.iter().find(is_same))
        });
        let kinks = mechanism.kinks();
        let surveyed_weight_nm = plain.map_or(0.0, |plain| plain.weight_nm);
        let (loads, survey) = (Arc::default(), Arc::new(Survey::empty()));
        let mut strip = Self {
            placed,
            surveyed,
            mechanism,
            extra,
            plain,
            surveyed_weight_nm,
            kinks,
            view,
            loads,
            survey,
            first: 0,
        };
        if let Some(known) = known {
            (strip.loads, strip.survey) = (Arc::clone(&known.loads), Arc::clone(&known.survey));
            if known.surveyed_weight_nm != 0.0 {
                strip.view.weight = surveyed_weight_nm / known.surveyed_weight_nm;
            }
            strip.surveyed_weight_nm = known.surveyed_weight_nm;
            return strip;
        }
        if strip.straight().is_none() {
            strip.loads = Arc::new(strip.find_loads());
        }
        strip.survey = Arc::new(strip.evaluate());
        strip
    }

    /// Returns `true` if a view of this survey represents the recording under a load that is a sum of parts.
    fn shows(&self, plain: &Plain, placed: &Placed) -> bool {
        let Some(own) = &self.plain else { return false };
        if !Arc::ptr_eq(&self.placed.recorded, &placed.recorded) || own.constant_nm != plain.constant_nm {
            return false;
        }
        if self.surveyed_weight_nm == 0.0 || plain.weight_nm == 0.0 {
            return self.surveyed_weight_nm == plain.weight_nm;
        }
        (self.is_weight_alone() || self.surveyed_weight_nm == plain.weight_nm)
            && own.angle_rad == plain.angle_rad
            && self.placed.offset_rad == placed.offset_rad
    }

    /// Returns `true` if this strip and another one of the trace have the same signals, each at its own instants: the same
    /// recording at the same pace, with the same load, at the same positions unless the load is independent of them.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.placed.recorded, &other.placed.recorded)
            && self.placed.stretch == other.placed.stretch
            && self.extra == other.extra
            && (self.placed.offset_rad == other.placed.offset_rad || self.straight().is_some())
    }

    /// Returns `true` if the load before the view is a weight alone, so that another weight is a factor.
    fn is_weight_alone(&self) -> bool {
        self.placed.recorded.torque_nm().is_none() && self.plain.is_some_and(|plain| plain.constant_nm == 0.0)
    }

    /// Returns the number of samples whose load must be computed again for another load, and for another pace.
    pub(super) fn found_anew(&self) -> [usize; 2] {
        let samples = self.placed.recorded.len() + self.kinks_passed();
        match &self.plain {
            None => [samples; 2],
            Some(_) if self.straight().is_none() && !self.is_weight_alone() => [samples, 0],
            Some(_) => [0; 2],
        }
    }

    /// Returns the number of kinks passed; each divides an interval like a sample.
    fn kinks_passed(&self) -> usize {
        recorded_passes(&self.mechanism, &self.kinks, &self.placed) as usize
    }

    /// Returns the work of a pass, in samples under a load with straight intervals. Other loads take about twice as
    /// long, and longer if their equations do.
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "a count far below 2^52"
    )]
    pub(super) fn cost(&self) -> usize {
        let samples = self.placed.recorded.len() + self.kinks_passed();
        if self.straight().is_some() {
            samples
        } else {
            (2.0 * self.mechanism.evaluation_cost() * samples as f64) as usize
        }
    }

    /// Returns the load if it makes every interval straight.
    #[inline]
    fn straight(&self) -> Option<&Plain> {
        self.plain.as_ref().filter(|_| self.surveyed_weight_nm == 0.0)
    }

    /// Visits the panels of an interval, one for each direction: both ends and the middle with the weights of Simpson's
    /// rule. A load that depends on the position or has losses needs more panels, see [`Self::bent_interval`].
    pub(super) fn interval(&self, index: usize, look: &mut impl FnMut(Panel<'_>)) {
        if self.plain.is_none() {
            self.raw_interval(index, look);
            return;
        }
        self.raw_interval(index, &mut |panel| {
            let mut nodes = [Node::default(); NODES];
            nodes.iter_mut().zip(panel.nodes).for_each(|(node, raw)| *node = self.view.node(raw));
            let nodes = nodes.get(..panel.nodes.len()).unwrap_or_default();
            look(Panel::passing(nodes, panel.duration_s * self.view.stretch, self.view.curvature(panel.bow)));
        });
    }

    /// Visits the panels of an interval in the signals of the survey.
    fn raw_interval(&self, index: usize, look: &mut impl FnMut(Panel<'_>)) {
        let Some(interval) = self.surveyed.interval(index) else { return };
        let Some(plain) = self.straight() else {
            match (self.loads.pieces(index), loads::direction(&interval)) {
                (pieces @ [Some(_), _], Some(direction)) => {
                    pieces.iter().flatten().for_each(|piece| piece.panel(&interval, direction, look));
                }
                _ => self.bent_interval(&interval, look),
            }
            return;
        };
        let acceleration = interval.acceleration_rad_s2();
        for (from, to, direction) in parts(&interval) {
            let duration = (to - from) * interval.duration_s;
            let nodes = [(0.0, 1.0 / 6.0), (0.5, 4.0 / 6.0), (1.0, 1.0 / 6.0)].map(|(share, weight)| {
                let u = if share == 1.0 { to } else { from + share * (to - from) };
                let (_, speed, torque) = interval.at(u);
                Node {
                    time_s: interval.start_s + u * interval.duration_s,
                    weight_s: weight * duration,
                    acceleration_rad_s2: acceleration,
                    speed_rad_s: speed,
                    direction,
                    load_nm: torque + plain.constant_nm,
                }
            });
            look(Panel::passing(&nodes, duration, [0.0; 4]));
        }
    }

    /// Returns the number of intervals between samples.
    #[must_use]
    pub fn intervals(&self) -> usize {
        self.placed.intervals()
    }

    /// Computes the panels of a block and stores them.
    pub(super) fn keep(&self, block: &mut Block, nodes: &mut Vec<Node>, panels: &mut Vec<Kept>) {
        if let BlockPanels::Recorded { intervals, .. } = &block.place {
            let from = panels.len();
            for index in intervals.clone() {
                self.interval(index, &mut |panel| {
                    let first = nodes.len();
                    nodes.extend_from_slice(panel.nodes);
                    panels.push(Kept::of(nodes, first, panel.duration_s, panel.bow));
                });
            }
            block.place = BlockPanels::Kept(from..panels.len());
        }
    }

    /// Returns the number of intervals per block.
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

    /// Evaluates all samples in one pass.
    fn evaluate(&self) -> Survey {
        let (intervals, most) = (self.placed.intervals(), self.block_intervals());
        let ranges: Vec<Range<usize>> =
            (0..intervals).step_by(most).map(|from| from..(from + most).min(intervals)).collect();
        let blocks = in_two(&ranges, intervals >= SHARED_FROM, &|range| self.block(range.clone()));
        let span = range(self.placed.recorded.position_rad());
        Survey {
            cells: OnceLock::new(),
            lag_parts: blocks.iter().map(|_| OnceLock::new()).collect(),
            blocks,
            span,
            lags: OnceLock::new(),
            largest_swings: OnceLock::new(),
            cubes: OnceLock::new(),
            gains: GainTables::default(),
        }
    }

    /// Returns the result of the survey under this load; its blocks refer to the strip with the index `own`.
    pub(super) fn found(&self, own: usize) -> Found {
        let offset = self.placed.offset_rad;
        let block = |raw: &Block| {
            let place = match &raw.place {
                BlockPanels::Recorded { intervals, .. } => {
                    BlockPanels::Recorded { strip: own, intervals: intervals.clone() }
                }
                kept @ BlockPanels::Kept(_) => kept.clone(),
            };
            if self.plain.is_none() {
                return Block { place, ..raw.clone() };
            }
            Block {
                place,
                times: 1.0,
                from_s: self.view.start + raw.from_s * self.view.stretch,
                duration_s: raw.duration_s * self.view.stretch,
                extent: self.view.extent(&raw.extent),
                gram: self.view.gram(&raw.gram),
            }
        };
        Found {
            blocks: self.survey.blocks.iter().map(block).collect(),
            span: (self.survey.span.0 + offset, self.survey.span.1 + offset),
        }
    }

    #[inline]
    pub(super) const fn view(&self) -> &View {
        &self.view
    }

    /// Returns the address that identifies a survey.
    #[cfg(test)]
    pub(super) fn survey_address(&self) -> *const Survey {
        Arc::as_ptr(&self.survey)
    }

    pub(super) fn survey(&self) -> &Survey {
        &self.survey
    }

    /// Returns `true` if the cells have moments for the cube of a torque.
    pub(super) fn has_moments(&self) -> bool {
        self.straight().is_some()
    }

    /// Returns the moments of a cell for the cube of a torque; `None` unless the mechanism is plain and its intervals
    /// are straight.
    pub(super) fn cubic(&self, cell: &Cell) -> Option<&Moments> {
        self.straight()?;
        self.survey.cubes.get_or_init(|| self.cells().moments(self)).get(cell.number as usize)
    }

    /// Visits the panels of a block in the signals of the survey.
    pub(super) fn raw_panels(&self, block: &Block, look: &mut dyn FnMut(Panel<'_>)) {
        if let BlockPanels::Recorded { intervals, .. } = &block.place {
            intervals.clone().for_each(|index| self.raw_interval(index, &mut |panel| look(panel)));
        }
    }

    /// Returns the tree of the intervals, built on first use.
    #[inline]
    fn cells(&self) -> &Cells {
        self.survey.cells.get_or_init(|| Cells::of(self))
    }

    /// Returns the cell that contains all intervals.
    #[inline]
    pub fn root(&self) -> Option<&Cell> {
        self.cells().root()
    }

    /// Returns the two halves of a cell.
    #[inline]
    pub fn children(&self, halves: [u32; 2]) -> [Option<&Cell>; 2] {
        self.cells().children(halves)
    }

    /// Visits the panels of the intervals of a cell.
    pub fn panels_within(&self, (from, to): (u32, u32), look: &mut impl FnMut(Panel<'_>)) {
        self.cells().intervals(from, to).for_each(|index| self.interval(index, look));
    }

    /// Converts the weights of a sum of signals under the load to weights of the signals of the cells.
    #[inline]
    pub fn weights(&self, c: [f64; 4]) -> [f64; 4] {
        if self.plain.is_some() { self.view.weights(c) } else { c }
    }

    /// Returns the factor by which the time of the cells is stretched.
    #[inline]
    pub fn stretch(&self) -> f64 {
        if self.plain.is_some() { self.view.stretch } else { 1.0 }
    }

    /// Returns the bounds of a cell under the load, and the start of its first interval \[s\].
    #[inline]
    pub(super) fn seen(&self, cell: &Cell) -> (Extent, f64) {
        if self.plain.is_some() {
            (self.view.extent(&cell.extent), self.view.start + cell.from * self.view.stretch)
        } else {
            (cell.extent, cell.from)
        }
    }

    /// Visits the panels of a block under the load.
    pub fn panels(&self, block: &Block, look: &mut impl FnMut(Panel<'_>)) {
        if let BlockPanels::Recorded { intervals, .. } = &block.place {
            intervals.clone().for_each(|index| self.interval(index, look));
        }
    }

    /// Returns the blocks in the signals of the survey.
    pub(super) fn raw_blocks(&self) -> &[Block] {
        &self.survey.blocks
    }
}

impl Survey {
    fn empty() -> Self {
        Self {
            blocks: Vec::new(),
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

/// Applies `of` to all items in their order; computes the second half in another thread if `shared`.
fn in_two<I: Sync, O: Send>(items: &[I], shared: bool, of: &(impl Fn(&I) -> O + Sync)) -> Vec<O> {
    let work = |items: &[I]| -> Vec<O> { items.iter().map(of).collect() };
    if !shared {
        return work(items);
    }
    let (first, second) = items.split_at(items.len() / 2);
    std::thread::scope(|scope| {
        let other = std::thread::Builder::new().spawn_scoped(scope, || work(second)).ok();
        let mut all = Vec::with_capacity(items.len());
        all.extend(first.iter().map(of));
        // The second half is computed here if the thread could not be started, as in a browser, or did not finish.
        all.extend(other.and_then(|other| other.join().ok()).unwrap_or_else(|| work(second)));
        all
    })
}

/// Number of intervals processed in parallel lanes.
pub(super) const LANES: usize = 4;

/// Returns the smallest and the largest value.
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

/// Iterates over the parts of an interval in which the speed keeps its sign, split at the zero of the straight speed.
#[inline]
fn parts(interval: &Interval) -> impl Iterator<Item = Part> {
    let [first, last] = interval.speed_rad_s;
    let zero = if first * last < 0.0 { first / (first - last) } else { 1.0 };
    let sign = |speed: f64| if speed == 0.0 { 0.0 } else { speed.signum() };
    let before = (0.0, zero, sign(if first == 0.0 { last } else { first }));
    let after = (zero < 1.0).then_some((zero, 1.0, sign(last)));
    [Some(before), after].into_iter().flatten()
}
