//! First-order lags of quadratic forms over a cycle that repeats for ever.

use super::rule::{MOST, Values, dot, lagged, rule};
use super::{Form, Node, Trace};

/// One first-order lag y' = (u − y)/τ of a form, in the steady periodic state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lag {
    /// τ \[s\], greater than zero.
    pub(crate) tau_s: f64,
    /// u
    pub(crate) form: Form,
}

/// A largest value and when in the cycle it is reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Peak {
    /// The value.
    pub(crate) value: f64,
    /// Instant from the start of the cycle \[s\].
    pub(crate) at_s: f64,
}

/// A lag over one panel.
struct Course {
    tau_s: f64,
    /// Duration of the panel over τ.
    lambda: f64,
    /// e^(−λ)
    decay: f64,
    /// Nodes of the panel.
    count: usize,
    /// u at the nodes.
    input: Values,
    /// What the panel adds until its end.
    gain: f64,
}

impl Course {
    fn of(lag: &Lag, nodes: &[Node], duration: f64) -> Self {
        let mut input = [0.0; MOST];
        input.iter_mut().zip(nodes).for_each(|(u, node)| *u = lag.form.at(node));
        let (lambda, count) = (duration / lag.tau_s, nodes.len());
        let gain = lambda * dot(&lagged(lambda, count), &rule(count).coefficients(&input));
        Self { tau_s: lag.tau_s, lambda, decay: (-lambda).exp(), count, input, gain }
    }

    /// y at the end.
    fn end(&self, start: f64) -> f64 {
        start * self.decay + self.gain
    }

    /// y at a share of the panel.
    fn at(&self, start: f64, s: f64) -> f64 {
        let (rule, lambda) = (rule(self.count), s * self.lambda);
        let part = rule.coefficients(&rule.first_part(&self.input, s));
        start * (-lambda).exp() + lambda * dot(&lagged(lambda, self.count), &part)
    }

    /// y' at a share of the panel.
    fn slope(&self, start: f64, s: f64) -> f64 {
        (dot(&rule(self.count).shares(s), &self.input) - self.at(start, s)) / self.tau_s
    }
}

/// Into so many parts a panel is cut to see whether the sum of the lags turns within it.
const PARTS: u32 = 16;

impl Trace {
    /// Mean of a form over the cycle.
    pub(crate) fn mean(&self, form: &Form) -> f64 {
        let sum = self.gram.0.iter().flatten().zip(form.0.iter().flatten()).map(|(g, q)| g * q).sum::<f64>();
        sum / self.duration
    }

    /// The largest value over the cycle of the sum of some lags, in the steady periodic state, and its first instant.
    ///
    /// y_k(0) = (∫_0^T e^(−(T−t)/τ_k) u_k(t)/τ_k dt)/(1 − e^(−T/τ_k)); within a panel u is the polynomial through its nodes,
    /// which has a lag in closed form
    ///
    /// # Source   docs/theory/moments.md
    pub(crate) fn peak_of_lags(&self, lags: &[Lag]) -> Peak {
        let mut states: Vec<f64> = lags.iter().map(|lag| self.start_of_lag(lag)).collect();
        let mut best = Peak { value: states.iter().sum(), at_s: 0.0 };
        for block in &self.blocks {
            self.panels(block, &mut |panel| {
                let courses: Vec<Course> =
                    lags.iter().map(|lag| Course::of(lag, panel.nodes, panel.duration)).collect();
                let start = panel.nodes.first().map_or(0.0, |node| node.time);
                within(&courses, &states, &mut |s, value| {
                    if value > best.value {
                        best = Peak { value, at_s: start + s * panel.duration };
                    }
                });
                for (state, course) in states.iter_mut().zip(&courses) {
                    *state = course.end(*state);
                }
            });
        }
        best
    }

    fn start_of_lag(&self, lag: &Lag) -> f64 {
        let mut state = 0.0;
        for block in &self.blocks {
            self.panels(block, &mut |panel| state = Course::of(lag, panel.nodes, panel.duration).end(state));
        }
        state / -(-self.duration / lag.tau_s).exp_m1()
    }
}

/// The end of a panel, and where within it the sum of lags turns from rising to falling.
fn within(courses: &[Course], states: &[f64], see: &mut impl FnMut(f64, f64)) {
    let sum = |of: &dyn Fn(&Course, f64) -> f64| courses.iter().zip(states).map(|(c, y)| of(c, *y)).sum::<f64>();
    let slope = |s: f64| sum(&|course, start| course.slope(start, s));
    let mut last = (0.0, slope(0.0));
    for part in 1..=PARTS {
        let s = f64::from(part) / f64::from(PARTS);
        let here = (s, slope(s));
        if last.1 > 0.0 && here.1 < 0.0 {
            let (mut low, mut high) = (last.0, s);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if slope(middle) > 0.0 { low = middle } else { high = middle }
            }
            see(low, sum(&|course, start| course.at(start, low)));
        }
        last = here;
    }
    see(1.0, sum(&|course, start| course.end(start)));
}
