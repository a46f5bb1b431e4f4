//! Lag data of a recording: gains of its blocks and of their parts.

use super::{SHARED_FROM, Strip, in_two};
use crate::gains::{Gain, LagBlock, Lagging, Products, largest};
use crate::{Block, BlockPanels};
use std::ops::Range;

/// Number of intervals in a part of a block.
const PART: usize = 32;

/// Data of a part of a block from which the gain for any time constant follows.
#[derive(Debug)]
pub(crate) struct LagPart {
    pub(crate) intervals: Range<usize>,
    pub(crate) lag: LagBlock,
}

impl Strip {
    /// Data of each block for lags, computed on first use.
    pub(crate) fn lag_blocks(&self) -> &[LagBlock] {
        self.survey.lags.get_or_init(|| {
            in_two(&self.survey.blocks, self.placed.intervals() >= SHARED_FROM, &|block| {
                let BlockPanels::Recorded { intervals, .. } = &block.place else { return LagBlock::default() };
                self.lag_block(block.duration_s, block.extent.direction, intervals)
            })
        })
    }

    /// Computes the lag data of some intervals.
    fn lag_block(&self, duration: f64, (back, forth): (f64, f64), intervals: &Range<usize>) -> LagBlock {
        if let (Some(plain), None, true) = (self.straight(), self.surveyed.recorded.torque_nm(), back == forth) {
            let intervals = intervals.clone().filter_map(|index| self.surveyed.interval(index));
            return LagBlock::straight(duration, [plain.constant_nm, back], intervals);
        }
        LagBlock::of(duration, |look| {
            intervals.clone().for_each(|index| self.raw_interval(index, &mut |panel| look(panel)));
        })
    }

    /// Returns the parts of a block with their lag data, computed on first use.
    pub(crate) fn lag_parts(&self, block: usize) -> &[LagPart] {
        let (Some(parts), Some(whole)) = (self.survey.lag_parts.get(block), self.survey.blocks.get(block)) else {
            return &[];
        };
        parts.get_or_init(|| {
            let BlockPanels::Recorded { intervals, .. } = &whole.place else { return Vec::new() };
            let part = |from: usize| {
                let intervals = from..(from + PART).min(intervals.end);
                let each = || intervals.clone().filter_map(|index| self.surveyed.interval(index));
                let duration = each().map(|interval| interval.duration_s).sum();
                LagPart { lag: self.lag_block(duration, whole.extent.direction, &intervals), intervals }
            };
            intervals.clone().step_by(PART).map(part).collect()
        })
    }

    /// Returns the instant at which a part ends \[s\].
    pub(crate) fn end_of(&self, part: &LagPart) -> f64 {
        let time = self.placed.recorded.time_s().get(part.intervals.end).copied().unwrap_or(0.0);
        self.placed.start_s + time * self.placed.stretch
    }

    /// Returns the gains of the blocks for a lag of the signals of the survey.
    pub(crate) fn gains(&self, tau_s: f64) -> Vec<Gain> {
        let mut lagging = Lagging::of(tau_s);
        let gain = |(number, (block, lag)): (usize, (&Block, &LagBlock))| {
            // The parts are not computed if they cannot be short enough.
            let parts = self.block_intervals().div_ceil(PART) as f64;
            if lag.is_short(tau_s) || !lag.is_short(parts * tau_s) || !self.has_short_parts(number, tau_s) {
                return lag.gain(&mut lagging, |look| self.raw_panels(block, look));
            }
            // The moments of the parts may suffice even if those of the block do not.
            let mut gain = Gain::NONE;
            self.part_gains(number, tau_s).iter().for_each(|part| gain.then(part));
            gain
        };
        self.survey.blocks.iter().zip(self.lag_blocks()).enumerate().map(gain).collect()
    }

    fn has_short_parts(&self, block: usize, tau_s: f64) -> bool {
        self.lag_parts(block).iter().all(|part| part.lag.is_short(tau_s))
    }

    /// Returns the gains of the parts of a block for a lag of the signals of the survey.
    pub(crate) fn part_gains(&self, block: usize, tau_s: f64) -> Vec<Gain> {
        let mut lagging = Lagging::of(tau_s);
        let gain = |part: &LagPart| {
            part.lag.gain(&mut lagging, |look| {
                part.intervals.clone().for_each(|index| self.raw_interval(index, &mut |panel| look(panel)));
            })
        };
        self.lag_parts(block).iter().map(gain).collect()
    }

    /// Returns the largest swings of all blocks.
    pub(crate) fn largest_swings(&self) -> &Products {
        self.survey.largest_swings.get_or_init(|| largest(self.lag_blocks().iter().map(|block| &block.swing)))
    }
}
