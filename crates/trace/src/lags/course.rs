//! Search for the maximum of a sum of lags within a panel.

use super::lag::Lag;
use crate::Panel;
use crate::rule::{MOST, PARTS, Values, dot, lagged, parts, rule};
use numeric::root;

/// A lag over one panel.
pub(super) struct Course {
    tau_s: f64,
    /// Duration of the panel over τ.
    lambda: f64,
    /// e^(−λ)
    decay: f64,
    /// Nodes of the panel.
    count: usize,
    /// u at the nodes.
    input: Values,
    /// Added value at the end of the panel.
    gain: f64,
}

impl Course {
    pub(super) fn of(lag: &Lag, panel: &Panel<'_>) -> Self {
        let lambda = panel.duration_s / lag.tau_s;
        let course = Self::with(lag, panel, ((-lambda).exp(), 0.0));
        Self { gain: dot(&rule(course.count).weights(lambda), &course.input), ..course }
    }

    /// Returns the course over a panel with known decay and added value.
    pub(super) fn with(lag: &Lag, panel: &Panel<'_>, (decay, gain): (f64, f64)) -> Self {
        let mut input = [0.0; MOST];
        input.iter_mut().zip(panel.nodes).for_each(|(u, node)| *u = lag.form.at(node));
        Self { tau_s: lag.tau_s, lambda: panel.duration_s / lag.tau_s, decay, count: panel.nodes.len(), input, gain }
    }

    /// Returns y at the end of the panel.
    pub(super) fn end(&self, start: f64) -> f64 {
        start * self.decay + self.gain
    }

    /// Returns y at a share of the panel.
    fn at(&self, start: f64, s: f64) -> f64 {
        self.behind(start, s, &rule(self.count).first_part(&self.input, s))
    }

    /// Returns y at a share of the panel, from the coefficients of the input up to it.
    fn behind(&self, start: f64, s: f64, first_part: &Values) -> f64 {
        let lambda = s * self.lambda;
        start * (-lambda).exp() + lambda * dot(&lagged(lambda, self.count), first_part)
    }

    /// Returns y' at a share of the panel.
    fn slope(&self, start: f64, s: f64) -> f64 {
        (dot(&rule(self.count).shares(s), &self.input) - self.at(start, s)) / self.tau_s
    }

    /// Adds y' at the equal parts of the panel.
    fn add_slopes(&self, start: f64, sums: &mut [f64; PARTS as usize + 1]) {
        let rule = rule(self.count);
        let behind = parts().skip(1).zip(rule.first_parts(&self.input)).map(|(s, part)| self.behind(start, s, &part));
        let values = std::iter::once(start).chain(behind);
        for ((sum, u), y) in sums.iter_mut().zip(rule.at_parts(&self.input)).zip(values) {
            *sum += (u - y) / self.tau_s;
        }
    }

    /// Returns the bounds within the panel.
    pub(super) fn bounds(&self, start: f64) -> Bounds {
        let inputs = self.input.iter().take(self.count).copied();
        Bounds::of(inputs, (start, self.end(start)), self.lambda, self.tau_s)
    }
}

/// Bounds of a lag within a panel.
pub(super) struct Bounds {
    /// Values at both ends.
    ends: (f64, f64),
    /// Lower and upper bound of y'.
    slopes: (f64, f64),
}

impl Bounds {
    /// Returns the bounds from the inputs at the nodes and the values at both ends.
    pub(super) fn of(inputs: impl Iterator<Item = f64>, (start, end): (f64, f64), lambda: f64, tau_s: f64) -> Self {
        let (low, high) = inputs.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), u| (a.min(u), b.max(u)));
        let room = 0.125 * (high - low);
        let (low, high) = (low - room, high + room);
        // y deviates from the straight line by less than λ/4 of the range of its input.
        let stray = 0.25 * lambda * (high - low + (end - start).abs());
        let slopes = ((low - start.max(end) - stray) / tau_s, (high - start.min(end) + stray) / tau_s);
        Self { ends: (start, end), slopes }
    }
}

/// Returns `true` if the slope of a sum of lags may change from positive to negative within a panel, at a value above
/// `least`.
pub(super) fn may_turn(lags: impl Iterator<Item = Bounds>, duration: f64, least: f64) -> bool {
    let (mut lowest, mut highest, mut start, mut end) = (0.0, 0.0, 0.0, 0.0);
    for Bounds { ends, slopes } in lags {
        lowest += slopes.0;
        highest += slopes.1;
        start += ends.0;
        end += ends.1;
    }
    // The sum exceeds its ends by at most this much with slopes within these bounds.
    lowest < 0.0 && highest > 0.0 && f64::max(start, end) + 0.25 * duration * (highest - lowest) > least
}

/// Tolerance for the instant of a maximum, as a share of the panel.
const CLOSE: f64 = 1e-12;

/// Largest λ for which a lag is smooth enough for a polynomial, and largest number of nodes for which this is one in powers
/// of the share; with more nodes it is that through its values at the nodes.
const SMOOTH: (f64, usize) = (0.5, 7);

/// Returns the share of the panel at which the sum of lags has its highest maximum, and that value, if it exceeds
/// `least`.
pub(super) fn turn(courses: &[Course], states: &[f64], least: f64) -> Option<(f64, f64)> {
    let (slow, few) = SMOOTH;
    if courses.iter().all(|course| course.lambda <= slow) {
        let by_powers = courses.iter().all(|course| course.count <= few);
        return if by_powers { turn_by_powers(courses, states, least) } else { turn_by_nodes(courses, states, least) };
    }
    turn_in_closed_form(courses, states, least)
}

/// Finds the maximum like [`turn`] on any panel.
fn turn_in_closed_form(courses: &[Course], states: &[f64], least: f64) -> Option<(f64, f64)> {
    let sum = |of: &dyn Fn(&Course, f64) -> f64| courses.iter().zip(states).map(|(c, y)| of(c, *y)).sum::<f64>();
    let mut at_parts = [0.0; PARTS as usize + 1];
    courses.iter().zip(states).for_each(|(course, start)| course.add_slopes(*start, &mut at_parts));
    let slope = |s: f64| sum(&|course, start| course.slope(start, s));
    highest(at_parts.into_iter(), slope, least, |s, _| sum(&|course, start| course.at(start, s)))
}

/// Returns the highest value above `least` at a root where the slope changes from positive to negative, and its share of
/// the panel, from the slopes at equal parts; `value` returns the value at a root, given the highest one so far.
fn highest(
    at_parts: impl Iterator<Item = f64>,
    slope: impl Fn(f64) -> f64,
    least: f64,
    value: impl Fn(f64, f64) -> f64,
) -> Option<(f64, f64)> {
    let (mut best, mut most) = (None, least);
    let mut last = (0.0, 0.0);
    for here in parts().zip(at_parts) {
        if last.1 > 0.0 && here.1 < 0.0 {
            let at = root(&slope, last, here, CLOSE);
            let value = value(at, most);
            if value > most {
                most = value;
                best = Some((at, value));
            }
        }
        last = here;
    }
    best
}

/// Number of powers of the share that are evaluated. From the n-th on each coefficient is λ/(k + 1) of the one before,
/// so for λ = 0.5 and seven nodes the first neglected one is 0.5¹¹ · 7!/18! of the seventh, 4 · 10⁻¹⁶.
const POWERS: usize = 18;

impl Course {
    /// Adds the coefficients of the lag as powers of the share, and returns the number of powers that matter.
    ///
    /// y_(k+1) = λ (u_k − y_k)/(k + 1), y_0 the lag at the beginning
    ///
    /// # Source
    /// docs/theory/moments.md
    /// # Valid
    /// λ ≤ 0.5, n ≤ 7
    fn add_powers(&self, start: f64, sums: &mut [f64; POWERS]) -> usize {
        let scale = self.input.iter().fold(start.abs(), |most, u| most.max(u.abs()));
        let inputs = rule(self.count).powers(&self.input).chain(std::iter::repeat(0.0));
        let (mut power, mut order, mut count) = (start, 1.0, 0);
        for (sum, u) in sums.iter_mut().zip(inputs) {
            *sum += power;
            count += 1;
            if count > self.count && power.abs() <= 1e-18 * scale {
                break;
            }
            power = self.lambda * (u - power) / order;
            order += 1.0;
        }
        count
    }
}

/// Finds the maximum like [`turn`], over a short panel of few nodes, from powers of the share.
fn turn_by_powers(courses: &[Course], states: &[f64], least: f64) -> Option<(f64, f64)> {
    let (mut sums, mut slopes) = ([0.0; POWERS], [0.0; POWERS]);
    let count = courses.iter().zip(states).map(|(course, state)| course.add_powers(*state, &mut sums)).max()?;
    let mut order = 1.0;
    for (slope, sum) in slopes.iter_mut().zip(sums.iter().skip(1)) {
        *slope = order * sum;
        order += 1.0;
    }
    let (sums, slopes) = (sums.get(..count)?, slopes.get(..count.saturating_sub(1))?);
    let at = |factors: &[f64], s: f64| factors.iter().rev().fold(0.0, |value, factor| value * s + factor);
    let slope = |s: f64| at(slopes, s);
    highest(parts().map(slope), slope, least, |s, _| at(sums, s))
}

/// Finds the maximum like [`turn`], from the values at the nodes, where each lag is the polynomial through them.
fn turn_by_nodes(courses: &[Course], states: &[f64], least: f64) -> Option<(f64, f64)> {
    let rule = rule(courses.first()?.count);
    let (mut slopes, mut sums) = ([0.0; MOST], [0.0; MOST]);
    for (course, state) in courses.iter().zip(states) {
        let lag = rule.lag_at_nodes(*state, &course.input, course.lambda);
        for (((slope, sum), u), y) in slopes.iter_mut().zip(&mut sums).zip(&course.input).zip(lag).take(course.count) {
            *slope += (u - y) / course.tau_s;
            *sum += y;
        }
    }
    highest(
        rule.at_parts(&slopes),
        |s| dot(&rule.shares(s), &slopes),
        least,
        |s, most| {
            let near = dot(&rule.shares(s), &sums);
            // The closed form is evaluated only for values that are not clearly lower.
            if near > most - 1e-6 * most.abs() {
                courses.iter().zip(states).map(|(course, state)| course.at(*state, s)).sum()
            } else {
                near
            }
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns a random course over a panel with that many nodes, and a state close to its inputs.
    fn drawn(chance: &mut impl FnMut() -> f64, count: usize, lambda: f64) -> (Course, f64) {
        let mut input = [0.0; MOST];
        let (mean, swing) = (chance(), chance());
        input.iter_mut().take(count).for_each(|u| *u = mean + swing * chance());
        let gain = dot(&rule(count).weights(lambda), &input);
        let state = mean + 0.2 * swing * chance();
        (Course { tau_s: 0.3 / lambda, lambda, decay: (-lambda).exp(), count, input, gain }, state)
    }

    /// The maximum of a short panel of few nodes is that of the closed form.
    #[test]
    fn powers_of_the_share_have_the_maximum_of_the_closed_form() {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        let mut chance = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as f64 / f64::from(u32::MAX >> 1) * 2.0 - 1.0
        };
        let mut found = 0;
        for case in 0..3_000_u32 {
            let count = 2 + (case % 6) as usize;
            let lambdas = [0, 1].map(|_| 0.5 * 10_f64.powf(-2.0 * (chance() + 1.0)));
            let [(a, start_a), (b, start_b)] = lambdas.map(|lambda| drawn(&mut chance, count, lambda));
            let (courses, states) = ([a, b], [start_a, start_b]);
            let [powers, closed] =
                [turn_by_powers, turn_in_closed_form].map(|turn| turn(&courses, &states, f64::NEG_INFINITY));
            let (Some((_, powers)), Some((_, closed))) = (powers, closed) else {
                assert_eq!(powers, closed, "{case}");
                continue;
            };
            assert!((powers - closed).abs() < 1e-13, "{case}: {powers} {closed}");
            found += 1;
        }
        assert!(found > 500, "{found} maxima");
    }
}
