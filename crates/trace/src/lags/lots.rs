//! Kept panels in lots, each of which a lag passes at one step.

use crate::gains::{Gain, LagBlock, Lagging, Products, largest, most_on_the_way};
use crate::{Panel, Run, Trace};
use std::ops::Range;

/// So many panels make a lot, where there are more than a few.
const LOT: usize = 16;

/// Of so few panels of a run each is a lot: to look at all costs less than to look at one lot in two ways.
const FEW: usize = 32;

/// Neighbouring panels of one run.
#[derive(Debug)]
pub(super) struct Lot {
    pub(super) panels: Range<usize>,
    /// Of all of them once \[s\].
    pub(super) duration: f64,
    /// Largest |∫(p_m − p̄_m) dt| on the way.
    pub(super) swing: Products,
}

/// All panels of a trace, and the lots that they make.
#[derive(Debug)]
pub(super) struct Lots {
    /// None where the trace is changed: it is asked for the lags of one actuator, and what its panels are passed by costs less
    /// than to keep this.
    panels: Vec<LagBlock>,
    lots: Vec<Lot>,
    /// The lots of each run, and the largest of their swings; none of a recording.
    of_run: Vec<(Range<usize>, Products)>,
}

impl Lots {
    pub(super) fn of(trace: &Trace) -> Self {
        let is_kept = !trace.is_changed;
        let mut panels = Vec::with_capacity(if is_kept { trace.panels.len() } else { 0 });
        let mut blocks = Vec::with_capacity(LOT);
        let mut lots = Vec::with_capacity(trace.panels.len().min(FEW) + trace.panels.len() / LOT);
        let mut of_run = Vec::with_capacity(trace.runs.len());
        for run in &trace.runs {
            let from = lots.len();
            let (range, at_once) = match run {
                Run::Kept(range) => (range.clone(), if range.len() <= FEW { 1 } else { LOT }),
                // What repeats is passed period by period.
                Run::Repeated(range, _) => (range.clone(), range.len().max(1)),
                Run::Recorded(_) => (0..0, 1),
            };
            for first in range.clone().step_by(at_once) {
                let within = first..(first + at_once).min(range.end);
                let kept = trace.panels.get(within.clone()).unwrap_or_default();
                blocks.extend(kept.iter().map(|kept| LagBlock::of_panel(&trace.panel(kept), is_kept)));
                let duration = kept.iter().map(|kept| kept.duration).sum();
                lots.push(Lot { panels: within, duration, swing: most_on_the_way(&blocks, duration) });
                if is_kept {
                    panels.append(&mut blocks);
                }
                blocks.clear();
            }
            let own = lots.get(from..).unwrap_or_default();
            of_run.push((from..lots.len(), largest(own.iter().map(|lot| &lot.swing))));
        }
        Self { panels, lots, of_run }
    }

    /// The lots of a run: which they are, and what they are.
    pub(super) fn of_run(&self, run: usize) -> (Range<usize>, &[Lot]) {
        let range = self.of_run.get(run).map_or(0..0, |(range, _)| range.clone());
        (range.clone(), self.lots.get(range).unwrap_or_default())
    }

    /// The largest swings of the lots of a run.
    pub(super) fn largest_swings(&self, run: usize) -> Products {
        self.of_run.get(run).map_or([0.0; 10], |(_, swings)| *swings)
    }

    /// What each panel of a lot does to a lag.
    fn gains_within<'a>(&'a self, trace: &'a Trace, lot: &Lot, tau_s: f64) -> impl Iterator<Item = Gain> + 'a {
        let mut lagging = Lagging::of(tau_s);
        lot.panels.clone().map(move |index| {
            let panel = |look: &mut dyn FnMut(Panel<'_>)| {
                trace.panels.get(index).into_iter().for_each(|kept| look(trace.panel(kept)));
            };
            if let Some(block) = self.panels.get(index) {
                return block.gain(&mut lagging, panel);
            }
            let mut gain = Gain::NONE;
            panel(&mut |panel| gain.pass(&panel, tau_s));
            gain
        })
    }

    /// What each panel of a lot does to a lag.
    pub(super) fn part_gains(&self, trace: &Trace, lot: usize, tau_s: f64) -> Vec<Gain> {
        self.lots.get(lot).map(|lot| self.gains_within(trace, lot, tau_s).collect()).unwrap_or_default()
    }

    /// What each lot does to a lag, of one that repeats once.
    pub(super) fn gains(&self, trace: &Trace, tau_s: f64) -> Vec<Gain> {
        let through = |lot: &Lot| {
            let mut whole = Gain::NONE;
            self.gains_within(trace, lot, tau_s).for_each(|gain| whole.then(&gain));
            whole
        };
        self.lots.iter().map(through).collect()
    }
}
