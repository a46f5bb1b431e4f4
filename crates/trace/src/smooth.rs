//! One value along a panel of many nodes, as the polynomial through its values at the nodes.

use crate::Panel;
use crate::rule::{MOST, Rule, Values, dot, rule};

/// j P̃_j = (2j − 1) x P̃_(j−1) − (j − 1) P̃_(j−2): the factors of x P̃_(j−1) and of P̃_(j−2) for j = 2…16.
const STEPS: [(f64, f64); MOST - 1] = {
    let mut steps = [(0.0, 0.0); MOST - 1];
    let (mut open, mut degree): (&mut [(f64, f64)], f64) = (&mut steps, 2.0);
    while let [first, further @ ..] = open {
        *first = ((2.0 * degree - 1.0) / degree, (degree - 1.0) / degree);
        degree += 1.0;
        open = further;
    }
    steps
};

/// The polynomial through the values of a quantity at the nodes of a panel.
///
/// Half of the sixteen nodes of a panel resolve the signals to the last digits, all of them resolve their products
/// (docs/theory/moments.md).
#[derive(Clone, Copy, Debug)]
pub struct Smooth {
    rule: &'static Rule,
    values: Values,
    /// Coefficients of the shifted Legendre polynomials.
    factors: Values,
}

impl Smooth {
    /// Returns the value at a share of the panel.
    #[inline]
    #[must_use]
    pub fn at(&self, share: f64) -> f64 {
        let x = 2.0 * share - 1.0;
        let [a0, a1, further @ ..] = &self.factors;
        let (mut before, mut here, mut sum) = (1.0, x, a0 + a1 * x);
        for (a, (up, down)) in further.iter().zip(STEPS) {
            (before, here) = (here, up * x * here - down * before);
            sum += a * here;
        }
        sum
    }

    /// Returns the integral from the start of the panel to a share, as a mean over the whole panel.
    ///
    /// ∫_0^s P̃_j ds = (P̃_(j+1) − P̃_(j−1))/(2(2j + 1)), P̃_(−1) = −1
    #[must_use]
    pub fn until(&self, share: f64) -> f64 {
        let [whole, ..] = self.factors;
        // Most parts have one end in common with the panel.
        if share <= 0.0 || share >= 1.0 {
            return if share <= 0.0 { 0.0 } else { whole };
        }
        let x = 2.0 * share - 1.0;
        let (mut before, mut here, mut odd, mut sum) = (-1.0, 1.0, 1.0, 0.0);
        let mut next = x;
        for (a, (up, down)) in self.factors.iter().zip(STEPS.iter().chain(&[LAST])) {
            sum += a * (next - before) / (2.0 * odd);
            odd += 2.0;
            (before, here, next) = (here, next, up * x * next - down * here);
        }
        sum
    }

    /// Returns the value half-way between a node and the next.
    #[inline]
    #[must_use]
    pub fn middle(&self, node: usize) -> f64 {
        self.rule.middles().get(node).map_or(0.0, |shares| dot(shares, &self.values))
    }
}

/// Placeholder for the step beyond the last polynomial, whose result is not used.
const LAST: (f64, f64) = (0.0, 0.0);

impl Panel<'_> {
    /// Returns the polynomial through values at the nodes; `None` for a panel with too few nodes to resolve a product
    /// of its signals.
    #[must_use]
    pub fn smooth(&self, value: impl FnMut(&crate::Node) -> f64) -> Option<Smooth> {
        if self.nodes.len() < MOST {
            return None;
        }
        let (rule, mut values) = (rule(MOST), [0.0; MOST]);
        values.iter_mut().zip(self.nodes.iter().map(value)).for_each(|(to, value)| *to = value);
        Some(Smooth { rule, values, factors: rule.coefficients(&values) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Node;

    #[test]
    fn it_is_the_polynomial_and_its_integral() {
        let power = |s: f64, n: i32| (s - 0.3).powi(n);
        let value = |s: f64| (0..16).map(|n| f64::from(n + 1).sqrt() * power(s, n)).sum::<f64>();
        let integral = |s: f64| {
            let one = |n: i32| f64::from(n + 1).sqrt() * (power(s, n + 1) - power(0.0, n + 1)) / f64::from(n + 1);
            (0..16).map(one).sum::<f64>()
        };
        let nodes: Vec<Node> =
            rule(MOST).nodes().iter().map(|s| Node { time_s: *s, load_nm: value(*s), ..Node::default() }).collect();
        let panel = Panel::passing(&nodes, 1.0, [1.0; 4]);
        let smooth = panel.smooth(|node| node.load_nm).unwrap();
        for s in [0.0, 0.01, 0.3, 0.5, 0.77, 1.0] {
            assert!((smooth.at(s) - value(s)).abs() < 1e-12, "{s}: {} {}", smooth.at(s), value(s));
            assert!((smooth.until(s) - integral(s)).abs() < 1e-13, "{s}: {} {}", smooth.until(s), integral(s));
        }
        for (k, pair) in nodes.windows(2).enumerate() {
            let expected = value(0.5 * (pair[0].time_s + pair[1].time_s));
            assert!((smooth.middle(k) - expected).abs() < 1e-12, "{k}");
        }
        let few = nodes.get(..3).unwrap();
        assert!(Panel::passing(few, 1.0, [1.0; 4]).smooth(|node| node.load_nm).is_none());
    }
}
