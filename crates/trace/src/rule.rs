//! Interpolation within a panel: the polynomial through its nodes, and its first-order lag.

use super::Node;
use numeric::lobatto;
use std::sync::{LazyLock, OnceLock};
use wide::f64x4;

/// Maximum number of nodes of a panel.
pub(super) const MOST: usize = 16;

/// One value per node of a panel; zero beyond its nodes.
pub(super) type Values = [f64; MOST];

/// Gauss-Lobatto rule on 0…1 with the polynomial through its nodes.
#[derive(Debug)]
pub(super) struct Rule {
    nodes: Vec<f64>,
    barycentric: Vec<f64>,
    /// Row j gives the factor of the shifted Legendre polynomial P̃_j from the values at the nodes.
    legendre: Vec<Values>,
    /// Row j gives the factor of the Chebyshev polynomial T_j from the values at the nodes.
    chebyshev: Vec<Values>,
    /// Row k gives the factor of s^k from the values at the nodes.
    powers: Vec<Values>,
    /// Row k gives the integral from the beginning of the panel to its node k from the values at the nodes.
    integrals: Vec<Values>,
    /// Row m gives the value at the share m/[`PARTS`] from those at the nodes.
    parts: Vec<Values>,
    /// Element m gives the factors of the shifted Legendre polynomials on 0…(m + 1)/[`PARTS`] from the values at the nodes.
    first_parts: OnceLock<Vec<Vec<Values>>>,
    /// Row m gives the value half-way between the nodes m and m + 1 from those at the nodes.
    middles: Vec<Values>,
}

/// Number of equal parts of a panel in the search for a change of sign.
pub(super) const PARTS: u32 = 16;

/// Iterates over the borders of the equal parts of a panel, as shares of it.
pub(super) fn parts() -> impl Iterator<Item = f64> {
    (0..=PARTS).map(|part| f64::from(part) / f64::from(PARTS))
}

/// Returns the rule of n nodes.
#[inline]
pub(super) fn rule(n: usize) -> &'static Rule {
    static RULES: LazyLock<Vec<Rule>> = LazyLock::new(|| (0..=MOST).map(Rule::new).collect());
    static NONE: Rule = Rule {
        nodes: Vec::new(),
        barycentric: Vec::new(),
        legendre: Vec::new(),
        chebyshev: Vec::new(),
        powers: Vec::new(),
        integrals: Vec::new(),
        parts: Vec::new(),
        first_parts: OnceLock::new(),
        middles: Vec::new(),
    };
    RULES.get(n).unwrap_or(&NONE)
}

impl Rule {
    /// Computes the coefficients a_j = (2j + 1) Σ w_k P_j(x_k) u_k; that of the highest degree is (n − 1) Σ w_k
    /// P_j(x_k) u_k, because Lobatto's rule gives 1/(n − 1) for the square of that polynomial.
    ///
    /// The barycentric weights of the nodes are (−1)^k √w_k.
    ///
    /// # Source
    /// docs/theory/moments.md; Wang, Huybrechs and Vandewalle, Explicit barycentric weights for polynomial
    /// interpolation in the roots or extrema of classical orthogonal polynomials, Math. Comp. 83 (2014)
    fn new(n: usize) -> Self {
        let rule = if n < 2 { &[] } else { lobatto(n) };
        let signs = [1.0, -1.0].into_iter().cycle();
        let row = |(j, norm): (usize, f64)| {
            let mut row = [0.0; MOST];
            row.iter_mut().zip(rule).for_each(|(factor, (s, w))| *factor = norm * w * legendre(j, *s));
            row
        };
        let mut made = Self {
            nodes: rule.iter().map(|(s, _)| *s).collect(),
            barycentric: rule.iter().zip(signs).map(|((_, w), sign)| sign * w.sqrt()).collect(),
            legendre: (0..rule.len())
                .map(|j| (j, if j + 1 == n { real(n - 1) } else { real(2 * j + 1) }))
                .map(row)
                .collect(),
            chebyshev: Vec::new(),
            powers: powers(rule),
            integrals: Vec::new(),
            parts: Vec::new(),
            first_parts: OnceLock::new(),
            middles: Vec::new(),
        };
        made.chebyshev = (0..rule.len()).map(|j| made.chebyshev_factor(j)).collect();
        made.integrals = made.nodes.iter().map(|s| made.integral_until(*s)).collect();
        made.parts = parts().map(|s| made.shares(s)).collect();
        made.middles =
            made.nodes.iter().zip(made.nodes.iter().skip(1)).map(|(a, b)| made.shares(0.5 * (a + b))).collect();
        made
    }

    /// Returns the weights of the values at the nodes in the integral of their polynomial from the start to a share.
    ///
    /// ∫_0^s P̃_j ds = (P̃_(j+1) − P̃_(j−1))/(2(2j + 1)), P̃_(−1) = −1
    fn integral_until(&self, s: f64) -> Values {
        let mut weights = [0.0; MOST];
        for (j, row) in self.legendre.iter().enumerate() {
            let before = if j == 0 { -1.0 } else { legendre(j - 1, s) };
            let integral = 0.5 * (legendre(j + 1, s) - before) / real(2 * j + 1);
            weights.iter_mut().zip(row).for_each(|(weight, l)| *weight += integral * l);
        }
        weights
    }

    /// Returns the weights of the values at the nodes in the coefficient of T_j.
    ///
    /// c_j = (2 − δ_j0)/n Σ_m u(cos θ_m) cos(j θ_m), θ_m = π (m + ½)/n, m = 0…n−1
    fn chebyshev_factor(&self, j: usize) -> Values {
        let n = self.nodes.len();
        let mut weights = [0.0; MOST];
        for m in 0..n {
            let angle = std::f64::consts::PI * (real(m) + 0.5) / real(n);
            let share = (if j == 0 { 1.0 } else { 2.0 }) / real(n) * (real(j) * angle).cos();
            let shares = self.shares(0.5 * (1.0 + angle.cos()));
            weights.iter_mut().zip(shares).for_each(|(weight, u)| *weight += share * u);
        }
        weights
    }

    /// Returns the values at the nodes of the lag y' = λ (u − y), y(0) = start, for a small λ.
    ///
    /// y = start + λ ∫(u − y) ds at every node, solved by fixed-point iteration: iteration k reduces the error by the
    /// factor λ/k.
    ///
    /// # Valid
    /// λ ≤ 0.5; y is then the polynomial through its nodes as closely as u is
    pub(super) fn lag_at_nodes(&self, start: f64, input: &Values, lambda: f64) -> Values {
        let scale = input.iter().fold(start.abs(), |most, u| most.max(u.abs()));
        let mut lag = [start; MOST];
        for _ in 0..MOST {
            let mut driven = [0.0; MOST];
            driven.iter_mut().zip(input).zip(&lag).for_each(|((d, u), y)| *d = u - y);
            let mut moved = 0.0_f64;
            for (y, row) in lag.iter_mut().zip(&self.integrals) {
                let next = start + lambda * dot(row, &driven);
                moved = moved.max((next - *y).abs());
                *y = next;
            }
            if moved <= 1e-13 * scale {
                break;
            }
        }
        lag
    }

    /// Iterates over the values at equal parts of the panel, from its start to its end.
    pub(super) fn at_parts<'a>(&'a self, values: &'a Values) -> impl Iterator<Item = f64> + 'a {
        self.parts.iter().map(move |row| dot(row, values))
    }

    /// Returns the values of the basis polynomials at a share of the panel; the interpolated value is the sum of each
    /// times the value at its node.
    pub(super) fn shares(&self, s: f64) -> Values {
        let mut shares = [0.0; MOST];
        if let Some(at) = self.nodes.iter().position(|node| *node == s) {
            shares.iter_mut().skip(at).take(1).for_each(|share| *share = 1.0);
            return shares;
        }
        let mut sum = 0.0;
        for ((share, node), weight) in shares.iter_mut().zip(&self.nodes).zip(&self.barycentric) {
            *share = weight / (s - node);
            sum += *share;
        }
        let whole = 1.0 / sum;
        shares.iter_mut().for_each(|share| *share *= whole);
        shares
    }

    /// Returns the coefficients of the shifted Legendre polynomials.
    pub(super) fn coefficients(&self, values: &Values) -> Values {
        let mut coefficients = [0.0; MOST];
        for (coefficient, row) in coefficients.iter_mut().zip(&self.legendre) {
            *coefficient = dot(row, values);
        }
        coefficients
    }

    /// Iterates over the factors of the powers of the share, by rising degree.
    ///
    /// # Valid
    /// Few nodes: the factors grow with the degree and cancel each other, at seven nodes by three digits.
    pub(super) fn powers<'a>(&'a self, values: &'a Values) -> impl Iterator<Item = f64> + 'a {
        self.powers.iter().map(move |row| dot(row, values))
    }

    /// Iterates over the coefficients of the shifted Legendre polynomials for several values per node, by rising
    /// degree.
    pub(super) fn coefficients_of<const N: usize>(
        &self,
        values: impl Iterator<Item = [f64; N]> + Clone,
    ) -> impl Iterator<Item = [f64; N]> {
        self.legendre.iter().map(move |row| {
            let mut sums = [0.0; N];
            for (l, values) in row.iter().zip(values.clone()) {
                sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += l * value);
            }
            sums
        })
    }

    /// Returns the weights of the values at the nodes in the lag at the end of the panel; λ is duration over time
    /// constant.
    pub(super) fn weights(&self, lambda: f64) -> Values {
        let mut weights = [0.0; MOST];
        for (row, c) in self.legendre.iter().zip(lagged(lambda, self.nodes.len())) {
            for (weight, l) in weights.iter_mut().zip(row) {
                *weight += lambda * c * l;
            }
        }
        weights
    }

    /// Returns the coefficients of the shifted Legendre polynomials on 0…s.
    pub(super) fn first_part(&self, values: &Values, s: f64) -> Values {
        let mut part = [0.0; MOST];
        for (value, node) in part.iter_mut().zip(&self.nodes) {
            *value = dot(&self.shares(s * node), values);
        }
        self.coefficients(&part)
    }

    /// Iterates over the coefficients of the shifted Legendre polynomials on the first of the equal parts, the first two,
    /// and so on.
    pub(super) fn first_parts<'a>(&'a self, values: &'a Values) -> impl Iterator<Item = Values> + 'a {
        let of = |s: f64| {
            let shares: Vec<Values> = self.nodes.iter().map(|node| self.shares(s * node)).collect();
            self.legendre.iter().map(|row| combined(row, &shares)).collect()
        };
        let matrices = self.first_parts.get_or_init(|| parts().skip(1).map(of).collect());
        matrices.iter().map(|matrix| {
            let mut coefficients = [0.0; MOST];
            coefficients.iter_mut().zip(matrix).for_each(|(coefficient, row)| *coefficient = dot(row, values));
            coefficients
        })
    }

    #[inline]
    pub(super) fn nodes(&self) -> &[f64] {
        &self.nodes
    }

    /// Returns the weights of the values at the nodes in those half-way between neighbouring nodes.
    #[inline]
    pub(super) fn middles(&self) -> &[Values] {
        &self.middles
    }
}

/// Returns for each power of the share its factors in the basis polynomials of the nodes, Π (s − s_m)/(s_k − s_m).
fn powers(rule: &[(f64, f64)]) -> Vec<Values> {
    let mut powers = vec![[0.0; MOST]; rule.len()];
    for (k, (own, _)) in rule.iter().enumerate() {
        let mut basis: Values = std::array::from_fn(|degree| if degree == 0 { 1.0 } else { 0.0 });
        for (other, _) in rule.iter().filter(|(other, _)| other != own) {
            let mut below = 0.0;
            for factor in &mut basis {
                let here = *factor;
                *factor = (below - other * here) / (own - other);
                below = here;
            }
        }
        for (row, factor) in powers.iter_mut().zip(basis) {
            row.iter_mut().skip(k).take(1).for_each(|to| *to = factor);
        }
    }
    powers
}

/// Returns the sum of some rows, each times its factor.
fn combined(factors: &Values, rows: &[Values]) -> Values {
    let mut sum = [0.0; MOST];
    for (factor, row) in factors.iter().zip(rows) {
        sum.iter_mut().zip(row).for_each(|(to, value)| *to += factor * value);
    }
    sum
}

/// Σ a_k b_k
#[inline]
pub(super) fn dot(a: &Values, b: &Values) -> f64 {
    let fours = |values: &Values| -> [f64x4; MOST / 4] {
        let [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = *values;
        [[a, b, c, d], [e, f, g, h], [i, j, k, l], [m, n, o, p]].map(f64x4::from)
    };
    let ([a, b, c, d], [e, f, g, h]) = (fours(a), fours(b));
    ((a * e + b * f) + (c * g + d * h)).reduce_add()
}

#[allow(clippy::cast_precision_loss, reason = "at most a few dozen")]
const fn real(n: usize) -> f64 {
    n as f64
}

/// P_j(2s − 1)
fn legendre(j: usize, s: f64) -> f64 {
    numeric::legendre(j, 2.0 * s - 1.0).1
}

/// Computes the response of a first-order lag to each shifted Legendre polynomial over a time: a lag that starts from
/// zero ends at λ Σ a_j c_j.
///
/// c_j = ∫_0^1 e^(−λ(1−s)) P̃_j(s) ds = e^(−λ/2) i_j(λ/2)
///
/// # Symbols
/// λ duration over time constant, i_j modified spherical Bessel function of the first kind
/// # Source
/// Abramowitz & Stegun 10.2.36, Gegenbauer's integral; docs/theory/moments.md
/// # Valid
/// λ ≥ 0, n ≤ 16
pub(super) fn lagged(lambda: f64, n: usize) -> Values {
    let x = 0.5 * lambda;
    let mut found = [0.0; MOST];
    let wanted = found.iter_mut().take(n);
    if x < 0.5 {
        // i_j = x^j/(2j+1)!! (1 + x²/2/(2j+3) (1 + x²/4/(2j+5) (1 + …)))
        let (decay, half_square) = ((-x).exp(), 0.5 * x * x);
        let mut leading = decay;
        for (j, c) in wanted.enumerate() {
            let odd = real(2 * j + 1);
            if j > 0 {
                leading *= x / odd;
            }
            let (mut term, mut sum, mut m) = (1.0, 1.0, 1.0);
            while term > 1e-18 {
                term *= half_square / (m * (odd + 2.0 * m));
                sum += term;
                m += 1.0;
            }
            *c = leading * sum;
        }
        return found;
    }
    let first = -(-lambda).exp_m1() / lambda;
    if x > 200.0 {
        // Upward recurrence; the error grows by e^(j²/x) only.
        let mut pair = (first, (0.5 * (1.0 + (-lambda).exp()) - first) / x);
        for (j, c) in wanted.enumerate() {
            *c = pair.0;
            pair = (pair.1, pair.0 - real(2 * j + 3) / x * pair.1);
        }
        return found;
    }
    // Downward recurrence from a negligible start value, then scaled.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most two hundred")]
    let from = n + 20 + (9.0 * x.sqrt()) as usize;
    let (mut above, mut here) = (0.0, 1e-300);
    for j in (0..from).rev() {
        (above, here) = (here, above + real(2 * j + 3) / x * here);
        if let Some(c) = found.get_mut(j).filter(|_| j < n) {
            *c = here;
        }
        if here > 1e250 {
            (above, here) = (above * 1e-250, here * 1e-250);
            found.iter_mut().for_each(|c| *c *= 1e-250);
        }
    }
    let scale = first / here;
    found.iter_mut().for_each(|c| *c *= scale);
    found
}

/// Largest λ for which the lag over an interval of a recording is evaluated with a few terms.
pub(super) const SHORT: f64 = 0.01;

/// Returns e^(−λ) and the weights of the values at both ends and the middle in the lag of a parabola.
///
/// # Valid
/// λ ≤ 0.01, to the last digits
pub(super) fn short(lambda: f64) -> (f64, [f64; 3]) {
    let x = 0.5 * lambda;
    let square = x * x;
    let decay = 1.0 - x * (1.0 - x / 2.0 * (1.0 - x / 3.0 * (1.0 - x / 4.0 * (1.0 - x / 5.0))));
    let even = lambda * decay * (1.0 + square / 6.0 * (1.0 + square / 20.0));
    let odd = lambda * decay * x / 3.0 * (1.0 + square / 10.0);
    let bend = lambda * decay * square / 15.0 * (1.0 + square / 14.0);
    // a_0 = (u_0 + 4 u_m + u_1)/6, a_1 = (u_1 − u_0)/2, a_2 = (u_0 − 2 u_m + u_1)/3
    (decay * decay, [even / 6.0 - odd / 2.0 + bend / 3.0, (even - bend) / 1.5, even / 6.0 + odd / 2.0 + bend / 3.0])
}

/// Returns the instant at a share of a panel, on the polynomial through its nodes.
#[inline]
pub(super) fn between(nodes: &[Node], s: f64) -> Node {
    if let [_, _, _] = nodes {
        // The parabola through both ends and the middle, as in most intervals of a recording.
        let ahead = 2.0 * s - 1.0;
        return weighted(nodes, &[ahead * (s - 1.0), 4.0 * s * (1.0 - s), ahead * s], s);
    }
    weighted(nodes, &rule(nodes.len()).shares(s), s)
}

/// Polynomials through the nodes of a panel as Chebyshev series, computed on first use; for many instants cheaper than
/// interpolation between the nodes.
#[derive(Clone, Debug, Default)]
pub(super) struct Series(OnceLock<Box<[f64x4]>>);

impl Series {
    /// Returns the same instant as [`between`], by Clenshaw's recurrence.
    #[inline]
    pub(super) fn at(&self, nodes: &[Node], s: f64) -> Node {
        let factors = self.0.get_or_init(|| {
            let signals = |node: &Node| f64x4::from([node.acceleration_rad_s2, node.load_nm, node.speed_rad_s, 0.0]);
            let sum = |row: &Values| row.iter().zip(nodes).map(|(c, node)| f64x4::splat(*c) * signals(node)).sum();
            rule(nodes.len()).chebyshev.iter().map(sum).collect()
        });
        let x = f64x4::splat(2.0 * s - 1.0);
        let (twice, mut above, mut here) = (x + x, f64x4::ZERO, f64x4::ZERO);
        let Some((first, further)) = factors.split_first() else { return Node::default() };
        for factor in further.iter().rev() {
            (above, here) = (here, twice * here + (*factor - above));
        }
        let [acceleration, load, speed, _] = (x * here + (*first - above)).to_array();
        Node { acceleration_rad_s2: acceleration, load_nm: load, speed_rad_s: speed, ..placed(nodes, s) }
    }
}

/// Returns the instant half-way between a node and the next.
pub(super) fn middle(nodes: &[Node], place: usize) -> Node {
    let rule = rule(nodes.len());
    let (Some(shares), Some([a, b])) = (rule.middles.get(place), rule.nodes.get(place..place + 2)) else {
        return Node::default();
    };
    weighted(nodes, shares, 0.5 * (a + b))
}

#[inline]
fn weighted(nodes: &[Node], shares: &[f64], s: f64) -> Node {
    let mut at = placed(nodes, s);
    for (node, share) in nodes.iter().zip(shares) {
        at.acceleration_rad_s2 += share * node.acceleration_rad_s2;
        at.speed_rad_s += share * node.speed_rad_s;
        at.load_nm += share * node.load_nm;
    }
    at
}

/// Returns the instant at a share of a panel with the direction of the panel; the other signals are zero.
#[inline]
fn placed(nodes: &[Node], s: f64) -> Node {
    let (Some(first), Some(last)) = (nodes.first(), nodes.last()) else { return Node::default() };
    let time_s = first.time_s + s * (last.time_s - first.time_s);
    Node { time_s, direction: first.direction, ..Node::default() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The closed form agrees with Simpson sums of the defining integral.
    #[test]
    fn the_lag_of_legendre_polynomials_is_their_integral() {
        for lambda in [0.0, 1e-9, 1e-3, 0.3, 0.99, 1.01, 7.0, 60.0, 399.0, 401.0, 5e3] {
            let found = lagged(lambda, MOST);
            let steps = 4_000 + (100.0 * lambda) as u32;
            for j in [0, 1, 2, 3, 7, 15] {
                let f = |s: f64| (-lambda * (1.0 - s)).exp() * legendre(j, s);
                let h = 1.0 / f64::from(steps);
                let sum: f64 = (0..steps)
                    .map(|k| f64::from(k) * h)
                    .map(|s| (f(s) + 4.0 * f(s + 0.5 * h) + f(s + h)) * h / 6.0)
                    .sum();
                assert!(
                    (found[j] - sum).abs() < 1e-10 * (found[0] + 1e-3),
                    "λ = {lambda}, j = {j}: {} {sum}",
                    found[j]
                );
            }
        }
    }

    #[test]
    fn the_polynomial_meets_every_polynomial_of_its_degree() {
        for n in 2..=MOST {
            let f = |s: f64| (0..n).map(|j| (1.0 + j as f64).sqrt() * (s - 0.3).powi(j as i32)).sum::<f64>();
            let rule = rule(n);
            let mut values = [0.0; MOST];
            values.iter_mut().zip(rule.nodes()).for_each(|(value, s)| *value = f(*s));
            let a = rule.coefficients(&values);
            let part = rule.first_part(&values, 0.6);
            for (part, s) in rule.first_parts(&values).zip(parts().skip(1)) {
                for (a, b) in part.iter().zip(rule.first_part(&values, s)) {
                    assert!((a - b).abs() < 1e-12, "{n} {s}: {a} {b}");
                }
            }
            for s in [0.0, 0.123, 0.5, 0.77, 1.0] {
                let series: f64 = (0..n).map(|j| a[j] * legendre(j, s)).sum();
                assert!((dot(&rule.shares(s), &values) - f(s)).abs() < 1e-12, "{n} {s}");
                assert!((series - f(s)).abs() < 1e-12, "{n} {s}: {series} {}", f(s));
                let power: f64 =
                    rule.powers(&values).collect::<Vec<f64>>().iter().rev().fold(0.0, |sum, c| sum * s + c);
                assert!((power - f(s)).abs() < 1e-15 * 8_f64.powi(n as i32), "{n} {s}: {power} {}", f(s));
            }
            for s in rule.nodes() {
                let series: f64 = (0..n).map(|j| part[j] * legendre(j, *s)).sum();
                assert!((series - f(0.6 * s)).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn the_weights_of_short_intervals_are_those_of_the_rule() {
        for lambda in [1e-9, 1e-5, 1e-3, SHORT] {
            let (decay, weights) = short(lambda);
            assert!((decay / (-lambda).exp() - 1.0).abs() < 1e-14);
            for (a, b) in weights.iter().zip(rule(3).weights(lambda)) {
                assert!((a / b - 1.0).abs() < 1e-12, "{lambda}: {a} {b}");
            }
        }
    }
}
