//! Gauss-Lobatto quadrature: nodes at both ends of a span and inside.

use std::sync::LazyLock;

/// Largest number of nodes.
const NODES_MOST: usize = 16;

/// Returns nodes and weights of the Gauss-Lobatto rule on 0…1; the weights sum to one.
///
/// Exact for polynomials of degree 2n − 3. The inner nodes are the roots of P'_(n−1), the weights 1/(n(n−1) P_(n−1)²).
///
/// # Source
/// Abramowitz & Stegun 25.4.32
/// # Valid
/// 2 ≤ n ≤ 16; other n are replaced by the nearest
#[must_use]
pub fn lobatto(n: usize) -> &'static [(f64, f64)] {
    static RULES: LazyLock<Vec<Vec<(f64, f64)>>> = LazyLock::new(|| (0..=NODES_MOST).map(rule).collect());
    RULES.get(n.clamp(2, NODES_MOST)).map_or(&[], Vec::as_slice)
}

/// Returns P_(m−1) and P_m of Legendre at x, by the three-term recurrence; P_(−1) = 0.
///
/// # Source
/// Abramowitz & Stegun 22.7.10
#[must_use]
pub fn legendre(m: usize, x: f64) -> (f64, f64) {
    let (mut below, mut here, mut degree) = (0.0, 1.0, 0.0);
    for _ in 0..m {
        degree += 1.0;
        (below, here) = (here, ((2.0 * degree - 1.0) * x * here - (degree - 1.0) * below) / degree);
    }
    (below, here)
}

/// Returns P'_m and P''_m from the differential equation (1 − x²) P'' − 2x P' + m(m+1) P = 0.
fn slope_and_curvature(m: usize, x: f64) -> (f64, f64) {
    let (below, here) = legendre(m, x);
    #[allow(clippy::cast_precision_loss, reason = "at most sixteen")]
    let degree = m as f64;
    let slope = degree * (below - x * here) / (1.0 - x * x);
    (slope, (2.0 * x * slope - degree * (degree + 1.0) * here) / (1.0 - x * x))
}

fn rule(n: usize) -> Vec<(f64, f64)> {
    if n < 2 {
        return Vec::new();
    }
    #[allow(clippy::cast_precision_loss, reason = "at most sixteen")]
    let count = n as f64;
    let end = 1.0 / (count * (count - 1.0));
    let mut nodes = vec![(0.0, end)];
    for k in 1..n - 1 {
        #[allow(clippy::cast_precision_loss, reason = "at most sixteen")]
        let mut x = -(std::f64::consts::PI * k as f64 / (count - 1.0)).cos();
        for _ in 0..60 {
            let (slope, curvature) = slope_and_curvature(n - 1, x);
            let step = slope / curvature;
            x -= step;
            if step.abs() < 1e-16 {
                break;
            }
        }
        let (_, value) = legendre(n - 1, x);
        nodes.push((0.5 * (1.0 + x), end / (value * value)));
    }
    nodes.push((1.0, end));
    nodes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_rule_is_exact_up_to_its_degree_and_no_further() {
        for n in 2..=NODES_MOST {
            let integral = |degree: i32| lobatto(n).iter().map(|(x, w)| w * x.powi(degree)).sum::<f64>();
            let degree = i32::try_from(2 * n - 3).unwrap();
            for d in 0..=degree {
                assert!((integral(d) - 1.0 / f64::from(d + 1)).abs() < 1e-14, "n = {n}, degree {d}");
            }
            if n < 8 {
                assert!((integral(degree + 1) - 1.0 / f64::from(degree + 2)).abs() > 1e-9, "n = {n}");
            }
        }
    }

    #[test]
    fn three_nodes_are_simpson() {
        let expected = [(0.0, 1.0 / 6.0), (0.5, 2.0 / 3.0), (1.0, 1.0 / 6.0)];
        for ((x, w), (x0, w0)) in lobatto(3).iter().zip(expected) {
            assert!((x - x0).abs() < 1e-15 && (w - w0).abs() < 1e-15);
        }
    }
}
