//! What a stretch of the cycle adds to the lag of each product of two signals, once per time constant for all candidates.

use super::rule::{self, lagged, rule, short};
use super::{Form, Node, Panel};
use std::sync::{Arc, Mutex, OnceLock};

/// One number for each product x_i x_j, i ≤ j.
pub(super) type Products = [f64; 10];

/// The products of the signals at an instant.
pub(super) fn products(node: &Node) -> Products {
    let [a, t, s, w] = node.signals();
    [a * a, a * t, a * s, a * w, t * t, t * s, t * w, s * s, s * w, w * w]
}

impl Form {
    /// The factors of the products: u = Σ q_m p_m.
    pub(super) const fn factors(&self) -> Products {
        let [[aa, at, as_, aw], [_, tt, ts, tw], [_, _, ss, sw], [_, _, _, ww]] = self.0;
        [aa, 2.0 * at, 2.0 * as_, 2.0 * aw, tt, 2.0 * ts, 2.0 * tw, ss, 2.0 * sw, ww]
    }
}

/// The largest of each.
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

/// Over a stretch of the cycle y becomes y e^(−λ) + Σ q_m g_m.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gain {
    /// e^(−λ)
    pub(super) decay: f64,
    /// g_m
    pub(super) gain: Products,
}

impl Gain {
    /// Nothing yet.
    pub(super) const NONE: Self = Self { decay: 1.0, gain: [0.0; 10] };

    /// A panel later.
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

    /// Another stretch later.
    pub(super) fn then(&mut self, next: &Self) {
        self.decay *= next.decay;
        self.gain.iter_mut().zip(next.gain).for_each(|(g, further)| *g = *g * next.decay + further);
    }
}

/// How far ∫(p − p̄) dt may lie from zero on the way through a panel, between its ends: a quarter of the duration times
/// the range. A parabola leaves the range of its three nodes by an eighth of it.
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

/// The largest |∫(p_m − p̄_m) dt| on a way: what is gathered until the end of each part of it, and how far that swings
/// within the part.
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

/// The same through neighbouring blocks.
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

/// Legendre moments kept of each block.
const MOMENTS: usize = 4;

/// Up to this λ the moments of a block serve: what the next one would add is (λ/2)⁴/105 of a gain, 10⁻¹⁰.
const SHORT: f64 = 0.02;

/// What any lag needs of a block of a recording.
#[derive(Clone, Debug, Default)]
pub(super) struct LagBlock {
    pub(super) duration: f64,
    /// ∫ P̃_k(s) p_m dt, s the share of the block.
    moments: [Products; MOMENTS],
    /// Largest |∫(p_m − p̄_m) dt| on the way.
    pub(super) swing: Products,
}

impl LagBlock {
    pub(super) fn of(duration: f64, panels: impl Fn(&mut dyn FnMut(Panel<'_>))) -> Self {
        let mut moments = [[0.0; 10]; MOMENTS];
        // What is gathered until the end of each panel, and how far it may swing within.
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

    /// Of a kept panel, once: by the polynomials through the products at its nodes, whose factors are (2k + 1)/h times the
    /// moments. With all of them, or with the first alone where no gains are made of it.
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

    /// The same of straight intervals under a constant torque and in one direction: of the ten products five change, and
    /// within an interval only α ω, ω and ω² do. Of these the moment about its middle is counted with the slope of the
    /// Legendre polynomials; what they bend by over an interval is (h/H)² of a moment that itself is 10⁻⁵ of a gain.
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

    /// Whether its moments serve a lag.
    pub(super) fn is_short(&self, tau_s: f64) -> bool {
        self.duration <= SHORT * tau_s
    }

    /// What the block does to a lag, from its moments or, where it is not short, from its panels.
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

/// A lag through blocks most of which last equally long: up to the rounding of the instants of a recording.
pub(super) struct Lagging {
    tau_s: f64,
    duration: f64,
    decay: f64,
    /// (2k + 1) c_k(λ)/τ
    weights: [f64; MOMENTS],
}

/// Durations that differ by no more than this share are those of the same number of samples.
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

/// The gains of consecutive stretches for a time constant.
#[derive(Debug, Default)]
pub(super) struct Gains {
    known: OnceLock<Known>,
}

/// Of each stretch, and of its parts if requested.
#[derive(Debug)]
struct Known {
    stretches: Vec<Gain>,
    parts: Vec<OnceLock<Vec<Gain>>>,
}

impl Gains {
    /// Of each stretch.
    pub(super) fn stretches(&self) -> &[Gain] {
        self.known.get().map_or(&[], |known| &known.stretches)
    }

    /// Of the parts of one stretch, made if it is the first time.
    pub(super) fn parts(&self, stretch: usize, make: impl FnOnce() -> Vec<Gain>) -> &[Gain] {
        let parts = self.known.get().and_then(|known| known.parts.get(stretch));
        parts.map_or(&[], |parts| parts.get_or_init(make))
    }
}

/// Those for a time constant, by its bits.
type Cached = (u64, Arc<Gains>);

/// Number of cached time constants. Judging one actuator after the other needs those of a size or two at a time; a
/// catalogue has more of them, and each costs memory in proportion to the recording.
const TABLES: usize = 8;

/// A time constant without its last twelve bits, 10⁻¹²: equal ones of different actuators are rounded differently.
pub(super) fn rounded(tau_s: f64) -> f64 {
    f64::from_bits((tau_s.to_bits() + (1 << 11)) & !((1 << 12) - 1))
}

/// Gains for the requested time constants.
#[derive(Debug, Default)]
pub(super) struct GainTables(Mutex<Vec<Cached>>);

impl GainTables {
    /// The gains for a time constant, made if it is the first time.
    pub(super) fn of(&self, tau_s: f64, make: impl FnOnce(f64) -> Vec<Gain>) -> Arc<Gains> {
        let entry = {
            // What another thread left behind when it failed is whole: entries are added, moved or taken out.
            let mut tables = self.0.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            let key = rounded(tau_s).to_bits();
            match tables.iter().position(|(known, _)| *known == key) {
                Some(place) => {
                    // The last one requested goes last.
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
