//! Batches of stored panels, which a lag passes in one step each.

use crate::gains::{Gain, LagBlock, Lagging, Products, largest, most_on_the_way};
use crate::{Panel, Run, Trace};
use std::ops::Range;

/// Number of panels in a batch of a long run.
const BATCH: usize = 16;

/// Number of panels up to which each panel of a run is a batch of its own: evaluating all of them is cheaper than a
/// bound per batch first.
const FEW: usize = 32;

/// A batch of neighbouring panels of one run.
#[derive(Debug)]
pub(super) struct Batch {
    pub(super) panels: Range<usize>,
    /// Duration of the panels of one repetition \[s\].
    pub(super) duration: f64,
    /// Largest |∫(p_m − p̄_m) dt| within the batch.
    pub(super) swing: Products,
}

/// Panels of a trace and the batches they form.
#[derive(Debug)]
pub(super) struct Batches {
    /// Lag data of the panels; empty for a changed trace, for which only the lags of one actuator are requested and
    /// integrating the panels again costs less than storing this data.
    panels: Vec<LagBlock>,
    batches: Vec<Batch>,
    /// Batches of each run, and the largest of their swings; empty for a recording.
    of_run: Vec<(Range<usize>, Products)>,
}

impl Batches {
    pub(super) fn of(trace: &Trace) -> Self {
        let is_kept = !trace.is_changed;
        let mut panels = Vec::with_capacity(if is_kept { trace.panels.len() } else { 0 });
        let mut blocks = Vec::with_capacity(BATCH);
        let mut batches = Vec::with_capacity(trace.panels.len().min(FEW) + trace.panels.len() / BATCH);
        let mut of_run = Vec::with_capacity(trace.runs.len());
        for run in &trace.runs {
            let from = batches.len();
            let (range, at_once) = match run {
                Run::Kept(range) => (range.clone(), if range.len() <= FEW { 1 } else { BATCH }),
                // A repeated part is passed period by period.
                Run::Repeated(range, _) => (range.clone(), range.len().max(1)),
                Run::Recorded(_) => (0..0, 1),
            };
            for first in range.clone().step_by(at_once) {
                let within = first..(first + at_once).min(range.end);
                let kept = trace.panels.get(within.clone()).unwrap_or_default();
                blocks.extend(kept.iter().map(|kept| LagBlock::of_panel(&trace.panel(kept), is_kept)));
                let duration = kept.iter().map(|kept| kept.duration).sum();
                batches.push(Batch { panels: within, duration, swing: most_on_the_way(&blocks, duration) });
                if is_kept {
                    panels.append(&mut blocks);
                }
                blocks.clear();
            }
            let own = batches.get(from..).unwrap_or_default();
            of_run.push((from..batches.len(), largest(own.iter().map(|batch| &batch.swing))));
        }
        Self { panels, batches, of_run }
    }

    /// Returns the indices of the batches of a run and the batches.
    pub(super) fn of_run(&self, run: usize) -> (Range<usize>, &[Batch]) {
        let range = self.of_run.get(run).map_or(0..0, |(range, _)| range.clone());
        (range.clone(), self.batches.get(range).unwrap_or_default())
    }

    /// Returns the largest swings of the batches of a run.
    pub(super) fn largest_swings(&self, run: usize) -> Products {
        self.of_run.get(run).map_or([0.0; 10], |(_, swings)| *swings)
    }

    /// Iterates over the gains of the panels of a batch.
    fn gains_within<'a>(&'a self, trace: &'a Trace, batch: &Batch, tau_s: f64) -> impl Iterator<Item = Gain> + 'a {
        let mut lagging = Lagging::of(tau_s);
        batch.panels.clone().map(move |index| {
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

    /// Returns the gains of the panels of a batch.
    pub(super) fn part_gains(&self, trace: &Trace, batch: usize, tau_s: f64) -> Vec<Gain> {
        self.batches.get(batch).map(|batch| self.gains_within(trace, batch, tau_s).collect()).unwrap_or_default()
    }

    /// Returns the gain of each batch; of a repeated one for a single period.
    pub(super) fn gains(&self, trace: &Trace, tau_s: f64) -> Vec<Gain> {
        let through = |batch: &Batch| {
            let mut whole = Gain::NONE;
            self.gains_within(trace, batch, tau_s).for_each(|gain| whole.then(&gain));
            whole
        };
        self.batches.iter().map(through).collect()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;
    use crate::gains::products;
    use crate::lag_tests::under;
    use crate::rule::rule;
    use crate::tests::{arm, law, motion};
    use crate::{Form, Lag};
    use motion::{Law, SegmentSpec};
    use std::sync::Arc;

    /// Returns the trace of back-and-forth swings of an arm, increasing in angle and duration, with two laws in turn.
    fn trace() -> Trace {
        let swings: Vec<SegmentSpec> = (0..40)
            .map(|k| {
                let angle = (0.6 + 0.02 * f64::from(k / 2)) * if k % 2 == 0 { 1.0 } else { -1.0 };
                law(if k % 3 == 0 { Law::ModifiedSine } else { Law::Trapezoid }, angle, 0.5 + 0.003 * f64::from(k / 2))
            })
            .collect();
        let trace = under(&arm(), &motion(&swings));
        assert!(trace.panels.len() > 4 * FEW, "{} panels", trace.panels.len());
        trace
    }

    /// Returns the trace marked as changed, whose panels are integrated from their nodes.
    fn changed(trace: &Trace) -> Trace {
        Trace { is_changed: true, lags: Arc::default(), ..trace.clone() }
    }

    #[test]
    fn a_lot_does_what_its_panels_do_one_after_the_other() {
        let trace = trace();
        for trace in [&trace, &changed(&trace)] {
            let batches = trace.batches();
            let (_, first) = batches.of_run(0);
            assert!(first.iter().any(|batch| batch.panels.len() == BATCH), "lots of several panels");
            for tau_s in [0.4, 30.0, 2400.0] {
                for (place, (batch, gain)) in batches.batches.iter().zip(batches.gains(trace, tau_s)).enumerate() {
                    let mut plain = Gain::NONE;
                    for kept in trace.panels.get(batch.panels.clone()).unwrap() {
                        plain.pass(&trace.panel(kept), tau_s);
                    }
                    let mut parts = Gain::NONE;
                    batches.part_gains(trace, place, tau_s).iter().for_each(|part| parts.then(part));
                    for found in [&gain, &parts] {
                        assert!((found.decay - plain.decay).abs() < 1e-13, "{tau_s}");
                        for (a, b) in found.gain.iter().zip(plain.gain) {
                            assert!((a - b).abs() <= 1e-10 * b.abs().max(1e-6), "{tau_s}: {a} {b}");
                        }
                    }
                }
            }
        }
    }

    /// No product deviates from its mean over the batch by more than the stated swing, between the nodes included.
    #[test]
    fn no_course_within_a_lot_swings_farther() {
        let trace = trace();
        for batch in &trace.batches().batches {
            let panels: Vec<Panel<'_>> =
                trace.panels.get(batch.panels.clone()).unwrap().iter().map(|kept| trace.panel(kept)).collect();
            let fine = 200;
            let mut course: Vec<(f64, Products)> = vec![(0.0, [0.0; 10])];
            for panel in &panels {
                let h = panel.duration_s / f64::from(fine);
                for k in 0..fine {
                    let middle = products(&panel.at((f64::from(k) + 0.5) / f64::from(fine)));
                    let (at, mut sums) = *course.last().unwrap();
                    sums.iter_mut().zip(middle).for_each(|(sum, p)| *sum += p * h);
                    course.push((at + h, sums));
                }
            }
            let whole = course.last().unwrap().1;
            for (at, sums) in &course {
                for ((sum, whole), swing) in sums.iter().zip(whole).zip(batch.swing) {
                    let away = (sum - whole * at / batch.duration).abs();
                    // Error of the midpoint sum.
                    assert!(away <= swing + 1e-4 * (whole.abs() + swing), "{away} {swing}");
                }
            }
        }
    }

    /// The peak agrees with an integration in small steps over two rounds of the cycle.
    #[test]
    fn peaks_are_those_of_a_plain_walk() {
        let trace = trace();
        let form = Form([[2.0, 0.1, 0.0, 0.3], [0.1, 0.5, 0.2, 0.0], [0.0, 0.2, 3.0, 0.1], [0.3, 0.0, 0.1, 0.4]]);
        for taus in [[0.4, 6.0], [30.0, 900.0]] {
            let lags = taus.map(|tau_s| Lag { tau_s, form });
            let mut states = [0.0; 2];
            let walk = |states: &mut [f64; 2]| {
                let mut best = f64::NEG_INFINITY;
                for kept in &trace.panels {
                    let panel = trace.panel(kept);
                    let (rule, steps) = (rule(panel.nodes.len()), 64);
                    let h = panel.duration_s / f64::from(steps);
                    for k in 0..steps {
                        let from = f64::from(k) / f64::from(steps);
                        for (state, lag) in states.iter_mut().zip(&lags) {
                            let inputs =
                                rule.nodes().iter().map(|s| lag.form.at(&panel.at(from + s / f64::from(steps))));
                            let gain: f64 = rule.weights(h / lag.tau_s).iter().zip(inputs).map(|(w, u)| w * u).sum();
                            *state = *state * (-h / lag.tau_s).exp() + gain;
                        }
                        best = best.max(states.iter().sum());
                    }
                }
                best
            };
            walk(&mut states);
            for (state, tau_s) in states.iter_mut().zip(taus) {
                *state /= -(-trace.duration / tau_s).exp_m1();
            }
            let expected = walk(&mut states);
            for trace in [&trace, &changed(&trace)] {
                let found = trace.peak_of_lags(&lags).value;
                let above = found / expected - 1.0;
                // The integration samples its steps only, so it may miss the peak slightly.
                assert!((-1e-10..1e-5).contains(&above), "{taus:?}: {found} {expected}");
            }
        }
    }
}
