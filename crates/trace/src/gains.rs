//! Contribution of a stretch of the cycle to the lag of each product of two signals, computed once per time constant
//! for all candidates.

use super::rule::{self, lagged, rule, short};
use super::{Form, Node, Panel};
use std::sync::{Arc, Mutex, OnceLock};

/// One value for each product x_i x_j, i ≤ j.
pub(super) type Products = [f64; 10];

/// Returns the products of the signals at a node.
pub(super) fn products(node: &Node) -> Products {
    let [a, t, s, w] = node.signals();
    [a * a, a * t, a * s, a * w, t * t, t * s, t * w, s * s, s * w, w * w]
}

impl Form {
    /// Returns the coefficients q_m of the products: u = Σ q_m p_m.
    pub(super) const fn factors(&self) -> Products {
        let [[aa, at, as_, aw], [_, tt, ts, tw], [_, _, ss, sw], [_, _, _, ww]] = self.0;
        [aa, 2.0 * at, 2.0 * as_, 2.0 * aw, tt, 2.0 * ts, 2.0 * tw, ss, 2.0 * sw, ww]
    }
}

/// Returns the element-wise maximum.
pub(super) fn largest<'a>(swings: impl Iterator<Item = &'a Products>) -> Products {
    swings.fold([0.0; 10], |mut most, swing| {
        most.iter_mut().zip(swing).for_each(|(most, swing)| *most = most.max(*swing));
        most
    })
}

/// Σ a_m b_m
pub(super) fn sum(a: &Products, b: &Products) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Σ |a_m| b_m
pub(super) fn sum_of_magnitudes(a: &Products, b: &Products) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.abs() * b).sum()
}

/// Effect of a stretch of the cycle on a lag: y becomes y e^(−λ) + Σ q_m g_m.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gain {
    /// e^(−λ)
    pub(super) decay: f64,
    /// g_m
    pub(super) gain: Products,
}

impl Gain {
    /// The identity: a stretch of zero duration.
    pub(super) const NONE: Self = Self { decay: 1.0, gain: [0.0; 10] };

    /// Appends a panel to the stretch.
    pub(super) fn pass(&mut self, panel: &Panel<'_>, tau_s: f64) {
        let lambda = panel.duration_s / tau_s;
        let mut add = |decay: f64, weights: &[f64]| {
            self.decay *= decay;
            self.gain.iter_mut().for_each(|g| *g *= decay);
            for (node, weight) in panel.nodes.iter().zip(weights) {
                for (g, p) in self.gain.iter_mut().zip(products(node)) {
                    *g += weight * p;
                }
            }
        };
        if panel.nodes.len() == 3 && lambda <= rule::SHORT {
            let (decay, weights) = short(lambda);
            add(decay, &weights);
        } else {
            add((-lambda).exp(), &rule(panel.nodes.len()).weights(lambda));
        }
    }

    /// Appends another stretch.
    pub(super) fn then(&mut self, next: &Self) {
        self.decay *= next.decay;
        self.gain.iter_mut().zip(next.gain).for_each(|(g, further)| *g = *g * next.decay + further);
    }
}

/// Bounds |∫(p − p̄) dt| within a panel: a quarter of the duration times the range of p. A parabola exceeds the range
/// of its three nodes by at most an eighth of it.
pub(super) fn swing(panel: &Panel<'_>) -> Products {
    let (mut low, mut high) = ([f64::INFINITY; 10], [f64::NEG_INFINITY; 10]);
    for node in panel.nodes {
        for ((low, high), p) in low.iter_mut().zip(&mut high).zip(products(node)) {
            *low = low.min(p);
            *high = high.max(p);
        }
    }
    let mut swing = [0.0; 10];
    for ((swing, low), high) in swing.iter_mut().zip(low).zip(high) {
        *swing = 0.25 * panel.duration_s * 1.25 * (high - low);
    }
    swing
}

/// Bounds |∫(p_m − p̄_m) dt| along a course: the sum up to the end of each part plus the swing within the part.
fn most_away<'a>(
    course: impl Iterator<Item = (f64, &'a Products, &'a Products)>,
    whole: &Products,
    duration: f64,
) -> Products {
    let (mut most, mut before) = ([0.0_f64; 10], [0.0_f64; 10]);
    for (until, sums, swings) in course {
        for ((((most, before), whole), sum), swing) in most.iter_mut().zip(&mut before).zip(whole).zip(sums).zip(swings)
        {
            let away = (sum - whole * until / duration).abs();
            *most = most.max(away.max(*before) + swing);
            *before = away;
        }
    }
    most
}

/// Bounds |∫(p_m − p̄_m) dt| along neighbouring blocks.
pub(super) fn most_on_the_way(blocks: &[LagBlock], duration: f64) -> Products {
    if let [one] = blocks {
        return one.swing;
    }
    let mut course = Vec::with_capacity(blocks.len());
    let (mut elapsed, mut gathered) = (0.0, [0.0; 10]);
    for block in blocks {
        let [whole, ..] = &block.moments;
        elapsed += block.duration;
        gathered.iter_mut().zip(whole).for_each(|(sum, further)| *sum += further);
        course.push((elapsed, gathered, &block.swing));
    }
    most_away(course.iter().map(|(until, sums, swing)| (*until, sums, *swing)), &gathered, duration)
}

/// Number of Legendre moments stored for each block.
const MOMENTS: usize = 4;

/// Largest λ for which the moments of a block suffice: the next one would contribute (λ/2)⁴/105 of a gain, 10⁻¹⁰.
const SHORT: f64 = 0.02;

/// Data of a block from which the gain for any time constant follows.
#[derive(Clone, Debug, Default)]
pub(super) struct LagBlock {
    pub(super) duration: f64,
    /// ∫ P̃_k(s) p_m dt, s the share of the block's duration.
    moments: [Products; MOMENTS],
    /// Largest |∫(p_m − p̄_m) dt| within the block.
    pub(super) swing: Products,
}

impl LagBlock {
    pub(super) fn of(duration: f64, panels: impl Fn(&mut dyn FnMut(Panel<'_>))) -> Self {
        let mut moments = [[0.0; 10]; MOMENTS];
        // Sum up to the end of each panel, and bound of the swing within it.
        let mut course: Vec<(f64, Products, Products)> = Vec::with_capacity(264);
        let mut elapsed = 0.0;
        let mut gathered = [0.0; 10];
        panels(&mut |panel| {
            for ((node, share), p) in
                panel.nodes.iter().zip(rule(panel.nodes.len()).nodes()).zip(panel.nodes.iter().map(products))
            {
                let x = 2.0 * (elapsed + share * panel.duration_s) / duration - 1.0;
                let square = x * x;
                let legendre = [1.0, x, 1.5 * square - 0.5, (2.5 * square - 1.5) * x];
                for (moment, legendre) in moments.iter_mut().zip(legendre) {
                    let weight = node.weight_s * legendre;
                    for (sum, p) in moment.iter_mut().zip(p) {
                        *sum += weight * p;
                    }
                }
            }
            elapsed += panel.duration_s;
            if let Some(whole) = moments.first() {
                gathered = *whole;
            }
            course.push((elapsed, gathered, swing(&panel)));
        });
        let course = course.iter().map(|(until, sums, swing)| (*until, sums, swing));
        let swing = most_away(course, &gathered, duration);
        Self { duration, moments, swing }
    }

    /// Computes the data of a stored panel from the polynomials through the products at its nodes, whose coefficients
    /// are (2k + 1)/h times the moments. Without `all` only the first moment is computed, for panels of which no gains
    /// are made.
    pub(super) fn of_panel(panel: &Panel<'_>, all: bool) -> Self {
        let (duration, mut moments) = (panel.duration_s, [[0.0; 10]; MOMENTS]);
        let mut found = [[0.0; 10]; rule::MOST];
        found.iter_mut().zip(panel.nodes).for_each(|(found, node)| *found = products(node));
        let values = found.into_iter().take(panel.nodes.len());
        let mut odd = 1.0;
        let factors = rule(panel.nodes.len()).coefficients_of(values);
        for (moment, factors) in moments.iter_mut().zip(factors).take(if all { MOMENTS } else { 1 }) {
            *moment = factors.map(|factor| factor * duration / odd);
            odd += 2.0;
        }
        Self { duration, moments, swing: swing(panel) }
    }

    /// Computes the data of straight intervals with constant torque and one direction. Five of the ten products vary,
    /// and within an interval only α ω, ω and ω² do. Their moment about the middle of the interval is taken with the
    /// slope of the Legendre polynomials; the neglected curvature over an interval is (h/H)² of a moment that is 10⁻⁵
    /// of a gain.
    pub(super) fn straight(
        duration: f64,
        [load, direction]: [f64; 2],
        intervals: impl Iterator<Item = motion::Interval> + Clone,
    ) -> Self {
        // α², α, α ω, ω, ω²
        let products = |interval: &motion::Interval| {
            let (h, [w0, w1]) = (interval.duration_s, interval.speed_rad_s);
            let (dw, s) = (w1 - w0, w0 + w1);
            [dw * dw / h, dw, 0.5 * dw * s, 0.5 * h * s, h * (s * s - w0 * w1) / 3.0]
        };
        let mut moments = [[0.0; 5]; MOMENTS];
        let mut elapsed = 0.0;
        for interval in intervals.clone() {
            let (h, [w0, w1]) = (interval.duration_s, interval.speed_rad_s);
            let (dw, s) = (w1 - w0, w0 + w1);
            // ∫(t − t_m) ω dt
            let bend = h * h * dw / 12.0;
            let beside = [0.0, 0.0, bend * dw / h, bend, bend * s];
            let x = 2.0 * (elapsed + 0.5 * h) / duration - 1.0;
            let legendre = [1.0, x, 1.5 * x * x - 0.5, (2.5 * x * x - 1.5) * x];
            let slope = [0.0, 1.0, 3.0 * x, 7.5 * x * x - 1.5].map(|slope| slope * 2.0 / duration);
            let whole = products(&interval);
            for ((moment, l), d) in moments.iter_mut().zip(legendre).zip(slope) {
                for ((sum, p), beside) in moment.iter_mut().zip(whole).zip(beside) {
                    *sum += l * p + d * beside;
                }
            }
            elapsed += h;
        }
        let [whole, ..] = moments;
        let mean = whole.map(|whole| whole / duration);
        let (mut gathered, mut most, mut before) = ([0.0; 5], [0.0_f64; 5], [0.0_f64; 5]);
        elapsed = 0.0;
        for interval in intervals {
            let (h, [w0, w1]) = (interval.duration_s, interval.speed_rad_s);
            elapsed += h;
            let dw = (w1 - w0).abs();
            let within = 0.3125 * h * dw;
            let inner = [0.0, 0.0, within * dw / h, within, within * (w0 + w1).abs()];
            for (((((sum, p), mean), most), before), inner) in
                gathered.iter_mut().zip(products(&interval)).zip(mean).zip(&mut most).zip(&mut before).zip(inner)
            {
                *sum += p;
                let away = (*sum - mean * elapsed).abs();
                *most = most.max(away.max(*before) + inner);
                *before = away;
            }
        }
        let all = |[aa, a, aw, w, ww]: [f64; 5], one: f64, [load, direction]: [f64; 2]| {
            [
                aa,
                load * a,
                direction * a,
                aw,
                load * load * one,
                load * direction * one,
                load * w,
                direction * direction * one,
                direction * w,
                ww,
            ]
        };
        let mut ones = [0.0; MOMENTS];
        if let Some(first) = ones.first_mut() {
            *first = elapsed;
        }
        let mut expanded = [[0.0; 10]; MOMENTS];
        for ((expanded, moment), one) in expanded.iter_mut().zip(moments).zip(ones) {
            *expanded = all(moment, one, [load, direction]);
        }
        Self { duration, moments: expanded, swing: all(most, 0.0, [load.abs(), direction.abs()]) }
    }

    /// Returns `true` if the moments suffice for a lag with this time constant.
    pub(super) fn is_short(&self, tau_s: f64) -> bool {
        self.duration <= SHORT * tau_s
    }

    /// Computes the gain of the block for a lag, from the moments or, if the block is too long, from its panels.
    ///
    /// g_m = (λ/h) Σ_k (2k + 1) c_k(λ) ∫ P̃_k p_m dt
    pub(super) fn gain(&self, lagging: &mut Lagging, panels: impl Fn(&mut dyn FnMut(Panel<'_>))) -> Gain {
        if !self.is_short(lagging.tau_s) {
            let mut gain = Gain::NONE;
            panels(&mut |panel| gain.pass(&panel, lagging.tau_s));
            return gain;
        }
        let (decay, weights) = lagging.through(self.duration);
        let mut gain = Gain { decay, gain: [0.0; 10] };
        for (moment, weight) in self.moments.iter().zip(weights) {
            for (g, m) in gain.gain.iter_mut().zip(moment) {
                *g += weight * m;
            }
        }
        gain
    }
}

/// Cache of decay and weights for consecutive blocks of equal duration, up to the rounding of a recording's instants.
pub(super) struct Lagging {
    tau_s: f64,
    duration: f64,
    decay: f64,
    /// (2k + 1) c_k(λ)/τ
    weights: [f64; MOMENTS],
}

/// Relative tolerance within which durations count as the same number of samples.
const ROUNDING: f64 = 1e-12;

impl Lagging {
    pub(super) const fn of(tau_s: f64) -> Self {
        Self { tau_s, duration: 0.0, decay: 1.0, weights: [0.0; MOMENTS] }
    }

    fn through(&mut self, duration: f64) -> (f64, [f64; MOMENTS]) {
        if (duration - self.duration).abs() > ROUNDING * duration {
            let lambda = duration / self.tau_s;
            let mut odd = 1.0;
            for (weight, c) in self.weights.iter_mut().zip(lagged(lambda, MOMENTS)) {
                *weight = odd * c / self.tau_s;
                odd += 2.0;
            }
            (self.duration, self.decay) = (duration, (-lambda).exp());
        }
        (self.decay, self.weights)
    }
}

/// Gains of consecutive stretches for one time constant.
#[derive(Debug, Default)]
pub(super) struct Gains {
    known: OnceLock<Known>,
}

/// Gains of each stretch, and of its parts once requested.
#[derive(Debug)]
struct Known {
    stretches: Vec<Gain>,
    parts: Vec<OnceLock<Vec<Gain>>>,
}

impl Gains {
    /// Returns the gain of each stretch.
    pub(super) fn stretches(&self) -> &[Gain] {
        self.known.get().map_or(&[], |known| &known.stretches)
    }

    /// Returns the gains of the parts of one stretch, computed on first use.
    pub(super) fn parts(&self, stretch: usize, make: impl FnOnce() -> Vec<Gain>) -> &[Gain] {
        let parts = self.known.get().and_then(|known| known.parts.get(stretch));
        parts.map_or(&[], |parts| parts.get_or_init(make))
    }
}

/// Gains with the bits of their time constant.
type Cached = (u64, Arc<Gains>);

/// Number of cached time constants. Judging actuators one after the other needs those of one or two sizes at a time; a
/// catalogue has more, and each costs memory in proportion to the recording.
const TABLES: usize = 8;

/// Rounds a time constant to a relative 10⁻¹² (the last twelve bits), so that equal ones of different actuators share
/// an entry.
pub(super) fn rounded(tau_s: f64) -> f64 {
    f64::from_bits((tau_s.to_bits() + (1 << 11)) & !((1 << 12) - 1))
}

/// Cache of gains by time constant.
#[derive(Debug, Default)]
pub(super) struct GainTables(Mutex<Vec<Cached>>);

impl GainTables {
    /// Returns the gains for a time constant, computed on first use.
    pub(super) fn of(&self, tau_s: f64, make: impl FnOnce(f64) -> Vec<Gain>) -> Arc<Gains> {
        let entry = {
            // Entries are only added, moved or removed, so the table is consistent even if another thread panicked.
            let mut tables = self.0.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            let key = rounded(tau_s).to_bits();
            match tables.iter().position(|(known, _)| *known == key) {
                Some(place) => {
                    // The most recently used entry moves to the end.
                    let (_, latest) = tables.split_at_mut(place);
                    latest.rotate_left(1);
                }
                None => {
                    if tables.len() == TABLES {
                        tables.remove(0);
                    }
                    tables.push((key, Arc::default()));
                }
            }
            tables.last().map(|(_, entry)| Arc::clone(entry)).unwrap_or_default()
        };
        entry.known.get_or_init(|| {
            let stretches = make(rounded(tau_s));
            let parts = stretches.iter().map(|_| OnceLock::new()).collect();
            Known { stretches, parts }
        });
        entry
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The least recently used entry is dropped.
    #[test]
    fn the_oldest_table_gives_way() {
        let tables = GainTables::default();
        let made = std::cell::Cell::new(0);
        let ask = |tau_s: f64| {
            tables.of(tau_s, |_| {
                made.set(made.get() + 1);
                vec![Gain::NONE]
            });
        };
        (0..TABLES).for_each(|k| ask(60.0 + k as f64));
        ask(60.0);
        ask(2400.0);
        assert_eq!(made.get(), TABLES + 1);
        ask(60.0);
        assert_eq!(made.get(), TABLES + 1, "asked for lately");
        ask(61.0);
        assert_eq!(made.get(), TABLES + 2, "the oldest");
    }
}
