//! First-order lags of quadratic forms over a cycle in the steady periodic state.

mod batches;
mod course;
mod lag;

use super::gains::{Gain, GainTables, Gains, Products, rounded, sum, sum_of_magnitudes, swing};
use super::recording::Strip;
use super::rule::{SHORT, short};
use super::{Node, Panel, Run, Trace};
use batches::{Batch, Batches};
use course::{Bounds, Course, may_turn, turn};
pub use lag::Lag;
use numeric::{EQUAL, First};
use smallvec::SmallVec;
use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};

/// Largest value of a signal and the instant in the cycle at which it is reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// Largest value, in the unit of the form.
    pub value: f64,
    /// Instant from the start of the cycle \[s\].
    pub at_s: f64,
}

/// Cached data of the stored panels for lags.
#[derive(Debug, Default)]
pub(super) struct LagCache {
    batches: OnceLock<Batches>,
    gains: GainTables,
}

/// Relative tolerance of the search for the peak: a value must exceed the best one by more than this share. Far below
/// any displayed digit, above rounding.
const NEGLIGIBLE: f64 = 1e-10;

/// Effect of one period of a repeated stretch on a lag.
struct Period {
    /// Duration over τ.
    lambda: f64,
    gain: f64,
}

impl Period {
    fn of(once: &Gain, factors: &Products, tau_s: f64, duration: f64) -> Self {
        Self { lambda: duration / tau_s, gain: sum(factors, &once.gain) }
    }

    /// Returns the state at which a period ends in the value at which it began.
    fn steady(&self) -> f64 {
        self.gain / -(-self.lambda).exp_m1()
    }

    /// Returns the share of the initial state that remains after a number of periods.
    fn decay(&self, times: f64) -> f64 {
        (-times * self.lambda).exp()
    }

    /// Returns the contribution of a number of periods: the geometric sum of their gains.
    fn added(&self, times: f64) -> f64 {
        self.steady() * -(-times * self.lambda).exp_m1()
    }
}

/// Values of the lags of one sum, a few as a rule: a thermal network has two time constants.
type Lags<T> = SmallVec<[T; LAGS]>;

/// One lag along the stretches of the cycle. A cycle without recordings and repetitions is one run of few stretches, which
/// needs no allocation: the peak is searched for every actuator.
struct Flow {
    tau_s: f64,
    /// Decay e^(−λ) and added value of each stretch.
    stretches: SmallVec<[(f64, f64); 8]>,
    /// Coefficients of the products in the signals of each run, and the gains of each run.
    factors: SmallVec<[Products; 1]>,
    gains: SmallVec<[Arc<Gains>; 1]>,
    /// y at the start of the cycle.
    start: f64,
}

impl Flow {
    /// Returns decay e^(−λ) and added value of one stretch.
    fn stretch(&self, index: usize) -> (f64, f64) {
        self.stretches.get(index).copied().unwrap_or((1.0, 0.0))
    }
}

impl Trace {
    /// Returns the mean of a form over the cycle.
    #[cfg(test)]
    pub fn mean(&self, form: &super::Form) -> f64 {
        let sum = self.gram.0.iter().flatten().zip(form.0.iter().flatten()).map(|(g, q)| g * q).sum::<f64>();
        sum / self.duration
    }

    /// Returns the largest value over the cycle of the sum of several lags, in the steady periodic state, with the
    /// first instant at which it is reached.
    ///
    /// y_k(0) = (∫_0^T e^(−(T−t)/τ_k) u_k(t)/τ_k dt)/(1 − e^(−T/τ_k)); within a panel u is the polynomial through its nodes,
    /// which has a lag in closed form
    ///
    /// # Source
    /// docs/theory/moments.md
    pub fn peak_of_lags(&self, lags: &[Lag]) -> Peak {
        self.highest_of_lags(lags, f64::NEG_INFINITY)
    }

    /// Returns the same as [`Self::peak_of_lags`] if the peak exceeds a value; otherwise `None`, at less cost.
    pub fn peak_of_lags_above(&self, lags: &[Lag], least: f64) -> Option<Peak> {
        Some(self.highest_of_lags(lags, least)).filter(|peak| peak.value > least || least == f64::NEG_INFINITY)
    }

    fn highest_of_lags(&self, lags: &[Lag], least: f64) -> Peak {
        let flows: SmallVec<[Flow; 2]> = lags.iter().map(|lag| self.flow(lag)).collect();
        let count = flows.first().map_or(0, |flow| flow.stretches.len());
        let mut states: Lags<f64> = flows.iter().map(|flow| flow.start).collect();
        let mut ends = First::above(f64::NEG_INFINITY, None);
        let mut order = 0.0;
        ends.see(states.iter().sum(), order, None);
        for index in 0..count {
            for (state, flow) in states.iter_mut().zip(&flows) {
                if let Some((decay, gain)) = flow.stretches.get(index) {
                    *state = *state * decay + gain;
                }
            }
            order += 1.0;
            ends.see(states.iter().sum(), order, Some(index));
        }
        let mut best = First::above(least, ());
        best.see(ends.value(), ends.place().map_or(0.0, |index| self.end_of_stretch(index)), ());
        let starts = flows.iter().map(|flow| flow.start).collect();
        Search {
            trace: self,
            lags,
            flows: &flows,
            states: starts,
            now_s: 0.0,
            best,
            seen: BTreeMap::new(),
            seen_blocks: BTreeMap::new(),
        }
        .search()
    }

    /// Computes a lag along all stretches: batches of stored panels and blocks of recordings.
    fn flow(&self, lag: &Lag) -> Flow {
        let mut stretches = SmallVec::new();
        let (mut factors, mut gains) = (SmallVec::new(), SmallVec::new());
        for (number, run) in self.runs.iter().enumerate() {
            let (q, found) = match run {
                Run::Recorded(strip) => {
                    let Some(strip) = self.strips.get(*strip) else { continue };
                    let (q, tau_s) = (strip.view().form(&lag.form).factors(), lag.tau_s / strip.view().stretch());
                    (q, strip.survey().gains.of(tau_s, |tau_s| strip.gains(tau_s)))
                }
                Run::Kept(_) | Run::Repeated(..) => {
                    (lag.form.factors(), self.lags.gains.of(lag.tau_s, |tau_s| self.batches().gains(self, tau_s)))
                }
            };
            let through = |gain: &Gain| (gain.decay, sum(&q, &gain.gain));
            let (places, batches) = self.batches().of_run(number);
            let within = found.stretches().get(places).unwrap_or_default();
            match run {
                Run::Kept(_) => stretches.extend(within.iter().map(through)),
                Run::Repeated(_, times) => stretches.extend(within.iter().zip(batches).map(|(once, batch)| {
                    let period = Period::of(once, &q, lag.tau_s, batch.duration);
                    (period.decay(*times), period.added(*times))
                })),
                Run::Recorded(_) => stretches.extend(found.stretches().iter().map(through)),
            }
            factors.push(q);
            gains.push(found);
        }
        let gathered = stretches.iter().fold(0.0, |state, (decay, gain)| state * decay + gain);
        Flow { tau_s: lag.tau_s, stretches, factors, gains, start: gathered / -(-self.duration / lag.tau_s).exp_m1() }
    }

    fn batches(&self) -> &Batches {
        self.lags.batches.get_or_init(|| Batches::of(self))
    }

    /// Returns the instant at which a stored panel ends \[s\].
    fn end_of_panel(&self, panel: usize) -> f64 {
        let nodes = self.panels.get(panel).and_then(|kept| self.nodes.get(kept.nodes.clone()));
        nodes.and_then(<[Node]>::last).map_or(0.0, |node| node.time_s)
    }

    /// Returns the instant at which a stretch ends \[s\].
    fn end_of_stretch(&self, index: usize) -> f64 {
        let mut before = 0;
        for (number, run) in self.runs.iter().enumerate() {
            let within = index - before;
            let (_, batches) = self.batches().of_run(number);
            match run {
                Run::Kept(_) => {
                    if let Some(batch) = batches.get(within) {
                        return self.end_of_panel(batch.panels.end - 1);
                    }
                    before += batches.len();
                }
                Run::Repeated(range, times) => {
                    if let Some(batch) = batches.get(within) {
                        let first = self.panels.get(range.start).and_then(|kept| self.nodes.get(kept.nodes.start));
                        return first.map_or(0.0, |node| node.time_s) + times * batch.duration;
                    }
                    before += batches.len();
                }
                Run::Recorded(strip) => {
                    let blocks = self.strips.get(*strip).map_or(&[][..], |strip| strip.raw_blocks());
                    if within < blocks.len() {
                        let mut last = 0.0;
                        if let (Some(block), Some(strip)) = (blocks.get(within), self.strips.get(*strip)) {
                            strip
                                .panels(block, &mut |panel| last = panel.nodes.last().map_or(last, |node| node.time_s));
                        }
                        return last;
                    }
                    before += blocks.len();
                }
            }
        }
        self.duration
    }
}

/// Search for the peak within the stretches whose upper bound exceeds the best value found.
struct Search<'a> {
    trace: &'a Trace,
    lags: &'a [Lag],
    flows: &'a [Flow],
    states: Lags<f64>,
    /// Instant of these states \[s\].
    now_s: f64,
    best: First<()>,
    /// States at the start of the first evaluated panel of each kind, by index of the kind.
    seen: BTreeMap<usize, Lags<f64>>,
    /// States at the start of the first evaluated block of a recording that recurs, by index of the strip and place.
    seen_blocks: BTreeMap<(usize, usize), Lags<f64>>,
}

/// Returns `true` if a part of this kind was searched before and no lag starts higher now: the initial state only adds to
/// the result, so no lag can get higher within the part either. Otherwise remembers the states.
fn was_searched<K: Ord>(seen: &mut BTreeMap<K, Lags<f64>>, kind: K, states: &[f64]) -> bool {
    let is_no_higher =
        |seen: &Lags<f64>| states.iter().zip(seen).all(|(now, then)| now - then <= NEGLIGIBLE * then.abs());
    if seen.get(&kind).is_some_and(is_no_higher) {
        return true;
    }
    seen.insert(kind, states.into());
    false
}

impl Search<'_> {
    fn search(mut self) -> Peak {
        let mut index = 0;
        for (number, run) in self.trace.runs.iter().enumerate() {
            match run {
                Run::Kept(_) => {
                    let (places, batches) = self.trace.batches().of_run(number);
                    let most = self.rise(number, &self.trace.batches().largest_swings(number), 1.0);
                    for (place, batch) in places.zip(batches) {
                        let (through, own) =
                            (|flow: &Flow| flow.stretch(index), || self.rise(number, &batch.swing, 1.0));
                        if self.may_rise((&self.states, self.now_s), through, batch.duration, most, own) {
                            if batch.panels.len() == 1 {
                                let steps: Lags<(f64, f64)> = self.flows.iter().map(through).collect();
                                self.inside_kept(batch.panels.start, &self.states.clone(), &steps);
                            } else {
                                self.inside_lot((number, place), batch);
                            }
                        }
                        self.step(index, batch.duration);
                        index += 1;
                    }
                }
                Run::Repeated(range, times) => {
                    let (places, batches) = self.trace.batches().of_run(number);
                    for (place, batch) in places.zip(batches) {
                        self.inside_repeated((number, place), range, (*times, batch.duration));
                        self.step(index, times * batch.duration);
                        index += 1;
                    }
                }
                Run::Recorded(strip) => {
                    let Some(strip) = self.trace.strips.get(*strip) else { continue };
                    let stretch = strip.view().stretch();
                    let most = self.rise(number, strip.largest_swings(), stretch);
                    for (place, lags) in strip.lag_blocks().iter().enumerate() {
                        let own = || self.rise(number, &lags.swing, stretch);
                        let through = |flow: &Flow| flow.stretch(index);
                        let duration = lags.duration * stretch;
                        if self.may_rise((&self.states, self.now_s), through, duration, most, own)
                            && !was_searched(&mut self.seen_blocks, (strip.first, place), &self.states)
                        {
                            self.inside_block(number, strip, place);
                        }
                        self.step(index, duration);
                        index += 1;
                    }
                }
            }
        }
        Peak { value: self.best.value(), at_s: self.best.at() }
    }

    /// Searches the panels of a batch: first their ends, then the values between them.
    fn inside_lot(&mut self, (run, place): (usize, usize), batch: &Batch) {
        let (trace, flows) = (self.trace, self.flows);
        let count = flows.len();
        let mut steps = vec![(1.0, 0.0); batch.panels.len() * count];
        for (number, flow) in flows.iter().enumerate() {
            let (Some(q), Some(gains)) = (flow.factors.get(run), flow.gains.get(run)) else { return };
            let parts = gains.parts(place, || trace.batches().part_gains(trace, place, rounded(flow.tau_s)));
            for (step, gain) in steps.iter_mut().skip(number).step_by(count).zip(parts) {
                *step = (gain.decay, sum(q, &gain.gain));
            }
        }
        let mut states = self.states.clone();
        for (panel, steps) in batch.panels.clone().zip(steps.chunks(count)) {
            pass(&mut states, steps);
            let value = states.iter().sum();
            if value > self.enough(self.now_s) {
                self.best.see(value, trace.end_of_panel(panel), ());
            }
        }
        states.clone_from(&self.states);
        for (panel, steps) in batch.panels.clone().zip(steps.chunks(count)) {
            let Some(kept) = trace.panels.get(panel) else { return };
            let rise = self.rise(run, &swing(&trace.panel(kept)), 1.0);
            let mut through = steps.iter();
            if self.may_rise(
                (&states, self.now_s),
                |_| through.next().copied().unwrap_or((1.0, 0.0)),
                kept.duration,
                rise,
                || rise,
            ) {
                self.inside_kept(panel, &states, steps);
            }
            pass(&mut states, steps);
        }
    }

    /// Searches a stored panel, given the states at its start and its effect on each lag. Its ends are already known.
    fn inside_kept(&mut self, panel: usize, states: &[f64], steps: &[(f64, f64)]) {
        let trace = self.trace;
        let Some(panel) = trace.panels.get(panel).map(|kept| trace.panel(kept)) else { return };
        if self.was_seen(&panel, states) {
            return;
        }
        let bounds = self.lags.iter().zip(states).zip(steps).map(|((lag, start), (decay, gain))| {
            let inputs = panel.nodes.iter().map(|node| lag.form.at(node));
            Bounds::of(inputs, (*start, start * decay + gain), panel.duration_s / lag.tau_s, lag.tau_s)
        });
        if may_turn(bounds, panel.duration_s, self.enough(panel.start_s())) {
            let lags = self.lags.iter().zip(steps);
            let courses: SmallVec<[Course; 2]> = lags.map(|(lag, step)| Course::with(lag, &panel, *step)).collect();
            self.turn(&courses, states, (panel.start_s(), panel.duration_s));
        }
    }

    /// Returns `true` if a panel with the same signals was searched before, see [`was_searched`].
    fn was_seen(&mut self, panel: &Panel<'_>, states: &[f64]) -> bool {
        let Some(like) = panel.like().filter(|like| like.has_others) else { return false };
        was_searched(&mut self.seen, like.first, states)
    }

    fn step(&mut self, index: usize, duration: f64) {
        self.now_s += duration;
        for (state, flow) in self.states.iter_mut().zip(self.flows) {
            let (decay, gain) = flow.stretch(index);
            *state = *state * decay + gain;
        }
    }

    /// Searches the parts of a block of a recording.
    fn inside_block(&mut self, run: usize, strip: &Strip, block: usize) {
        let stretch = strip.view().stretch();
        let mut states = self.states.clone();
        for (place, part) in strip.lag_parts(block).iter().enumerate() {
            let through = |flow: &Flow| {
                let make = || strip.part_gains(block, rounded(flow.tau_s / stretch));
                let (q, gains) = (flow.factors.get(run)?, flow.gains.get(run)?);
                let gain = gains.parts(block, make).get(place)?;
                Some((gain.decay, sum(q, &gain.gain)))
            };
            let through = |flow: &Flow| through(flow).unwrap_or((1.0, 0.0));
            let rise = self.rise(run, &part.lag.swing, stretch);
            if self.may_rise((&states, self.now_s), through, part.lag.duration * stretch, rise, || rise) {
                let mut look = |panel: Panel<'_>| self.inside_interval(&panel, &mut states);
                part.intervals.clone().for_each(|index| strip.interval(index, &mut look));
            } else {
                for (state, flow) in states.iter_mut().zip(self.flows) {
                    let (decay, gain) = through(flow);
                    *state = *state * decay + gain;
                }
                let end = states.iter().sum();
                if end > self.enough(self.now_s) {
                    self.best.see(end, strip.end_of(part), ());
                }
            }
        }
    }

    /// Returns `true` if the sum of the lags may exceed the best value within a stretch, bounded by its higher end plus
    /// the swings of inputs and lags in between. The states are those at the start of the stretch, the instant is not
    /// after it.
    fn may_rise(
        &self,
        (states, from_s): (&[f64], f64),
        mut through: impl FnMut(&Flow) -> (f64, f64),
        duration: f64,
        most: f64,
        own: impl FnOnce() -> f64,
    ) -> bool {
        let (mut start, mut end, mut moved, mut ends, mut quickest) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for (state, flow) in states.iter().zip(self.flows) {
            let (decay, gain) = through(flow);
            let (next, lambda) = (state * decay + gain, duration / flow.tau_s);
            start += state;
            end += next;
            // Largest deviation of a lag of the mean input from the straight line between its ends; it never leaves
            // their range.
            moved += 0.25 * lambda * (next - state).abs();
            ends += next.max(*state);
            quickest = f64::max(quickest, lambda);
        }
        let left = self.enough(from_s) - f64::min(f64::max(start, end) + moved, ends);
        let swung = |rise: f64| rise * (1.0 + 2.0 * quickest) > left;
        // The largest swings of the whole run are already known and tested first.
        swung(most) && swung(own())
    }

    /// Returns the bound on the rise of the sum of the lags due to the swings of their inputs.
    fn rise(&self, run: usize, swings: &Products, stretch: f64) -> f64 {
        let of = |flow: &Flow| {
            flow.factors.get(run).map_or(f64::INFINITY, |q| sum_of_magnitudes(q, swings) * stretch / flow.tau_s)
        };
        self.flows.iter().map(of).sum()
    }

    /// Searches an interval of a recording. An interval is short against every time constant, so it is evaluated like a
    /// regular panel only if the sum of the lags has a maximum within it that may exceed the best value.
    fn inside_interval(&mut self, panel: &Panel<'_>, states: &mut [f64]) {
        let ([a, b, c], false) = (panel.nodes, self.is_long(panel)) else {
            self.inside(panel, states, 0.0);
            return;
        };
        let (mut before, mut after, mut slopes) = (0.0, 0.0, [0.0; 3]);
        let mut ends = [0.0; LAGS];
        for ((state, lag), end) in states.iter().zip(self.lags).zip(&mut ends) {
            let u = [a, b, c].map(|node| lag.form.at(node));
            let (decay, weights) = short(panel.duration_s / lag.tau_s);
            *end = state * decay + weights.iter().zip(u).map(|(w, u)| w * u).sum::<f64>();
            before += state;
            after += *end;
            let y = [*state, 0.5 * (state + *end), *end];
            for (slope, (u, y)) in slopes.iter_mut().zip(u.into_iter().zip(y)) {
                *slope += (u - y) / lag.tau_s;
            }
        }
        let [first, middle, last] = slopes;
        let turns = (first > 0.0 && middle.min(last) < 0.0) || (middle > 0.0 && last < 0.0);
        let steep = slopes.iter().fold(0.0_f64, |most, slope| most.max(slope.abs()));
        if turns && before.max(after) + 0.75 * panel.duration_s * steep > self.enough(a.time_s) {
            self.inside(panel, states, 0.0);
            return;
        }
        states.iter_mut().zip(ends).for_each(|(state, end)| *state = end);
        if after > self.enough(a.time_s) {
            self.best.see(after, c.time_s, ());
        }
    }

    fn is_long(&self, panel: &Panel<'_>) -> bool {
        self.lags.len() > LAGS || self.lags.iter().any(|lag| panel.duration_s > SHORT * lag.tau_s)
    }

    /// Searches the periods in which the sum of the lags may be largest. From one period to the next each lag
    /// approaches its steady state, y = y_∞ + (y_0 − y_∞) e^(−jT/τ): the sum of two lags is largest in the first or the
    /// last period or near the one where its derivative with respect to j is zero.
    fn inside_repeated(
        &mut self,
        (run, place): (usize, usize),
        range: &std::ops::Range<usize>,
        (times, once): (f64, f64),
    ) {
        let trace = self.trace;
        let mut periods = Vec::with_capacity(self.lags.len());
        for (flow, lag) in self.flows.iter().zip(self.lags) {
            let (Some(factors), Some(gains)) = (flow.factors.get(run), flow.gains.get(run)) else { return };
            let Some(gain) = gains.stretches().get(place) else { return };
            periods.push(Period::of(gain, factors, lag.tau_s, once));
        }
        let last = times - 1.0;
        let mut looked = vec![0.0, 1.0, last];
        let away: Vec<(f64, f64)> =
            periods.iter().zip(&self.states).map(|(period, state)| (state - period.steady(), period.lambda)).collect();
        if let [(a, quick), (b, slow)] = away.as_slice() {
            let turn = (-(a * quick) / (b * slow)).ln() / (quick - slow);
            if turn.is_finite() {
                looked.extend([-1.0, 0.0, 1.0].map(|beside| turn.floor() + beside));
            }
        }
        looked.retain(|j| (0.0..=last).contains(j));
        looked.sort_by(f64::total_cmp);
        looked.dedup();
        for j in looked {
            let states = periods.iter().zip(&self.states);
            let mut states: Vec<f64> =
                states.map(|(period, state)| state * period.decay(j) + period.added(j)).collect();
            for kept in trace.panels.get(range.clone()).unwrap_or_default() {
                self.inside(&trace.panel(kept), &mut states, j * once);
            }
        }
    }

    /// Returns the value that a candidate after an instant must exceed: before the first highest one an equal value counts
    /// too.
    fn enough(&self, from_s: f64) -> f64 {
        let share = if from_s < self.best.at() { -EQUAL } else { NEGLIGIBLE };
        self.best.value() + share * self.best.value().abs()
    }

    /// Searches the values between the ends of a panel, given its start and duration \[s\].
    fn turn(&mut self, courses: &[Course], states: &[f64], (start_s, duration_s): (f64, f64)) {
        if let Some((s, value)) = turn(courses, states, self.enough(start_s)) {
            self.best.see(value, start_s + s * duration_s, ());
        }
    }

    /// Searches a panel, which recurs after a time, and advances the states to its end.
    fn inside(&mut self, panel: &Panel<'_>, states: &mut [f64], later_s: f64) {
        let courses: SmallVec<[Course; 2]> = self.lags.iter().map(|lag| Course::of(lag, panel)).collect();
        let start = panel.start_s() + later_s;
        let bounds = courses.iter().zip(&*states).map(|(course, state)| course.bounds(*state));
        if may_turn(bounds, panel.duration_s, self.enough(start)) {
            self.turn(&courses, states, (start, panel.duration_s));
        }
        for (state, course) in states.iter_mut().zip(&courses) {
            *state = course.end(*state);
        }
        let value = states.iter().sum();
        if value > self.enough(start) {
            self.best.see(value, start + panel.duration_s, ());
        }
    }
}

/// Advances the states over a stretch with the given decay and added value of each lag.
fn pass(states: &mut [f64], steps: &[(f64, f64)]) {
    states.iter_mut().zip(steps).for_each(|(state, (decay, gain))| *state = *state * decay + gain);
}

/// Maximum number of lags in one sum for the shortcut over short intervals; with more, intervals are evaluated like
/// regular panels.
const LAGS: usize = 4;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lag_tests::under;
    use crate::tests::{arm, law, motion};
    use crate::{Kept, Like};
    use motion::Law;

    /// Only a panel with repetitions is skipped when it recurs, and only if no lag starts higher.
    #[test]
    fn only_what_has_others_is_known_again() {
        let trace = under(&arm(), &motion(&[law(Law::ModifiedSine, 1.0, 0.6), law(Law::ModifiedSine, -1.0, 0.6)]));
        let kept = trace.panels.first().unwrap();
        let [alone, one_of_many] = [false, true]
            .map(|has_others| Kept { like: Like { first: 0, is_copy: false, has_others }, ..kept.clone() });
        let (alone, one_of_many) = (trace.panel(&alone), trace.panel(&one_of_many));
        let best = First::above(0.0, ());
        let (states, seen) = (SmallVec::from_slice(&[2.0, 3.0]), BTreeMap::new());
        let mut search = Search {
            trace: &trace,
            lags: &[],
            flows: &[],
            states,
            now_s: 0.0,
            best,
            seen,
            seen_blocks: BTreeMap::new(),
        };
        assert!(!search.was_seen(&alone, &[2.0, 3.0]) && !search.was_seen(&alone, &[2.0, 3.0]));
        assert!(!search.was_seen(&one_of_many, &[2.0, 3.0]) && search.was_seen(&one_of_many, &[2.0, 3.0]));
        assert!(search.was_seen(&one_of_many, &[1.0, 3.0]), "lower");
        assert!(!search.was_seen(&one_of_many, &[1.0, 3.1]), "higher");
    }
}
