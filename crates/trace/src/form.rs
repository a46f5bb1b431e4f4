//! Quadratic forms of the four signals of a cycle.

use super::Node;

/// u(t) = Σ_ij Q_ij x_i x_j with x = (α, T_L, σ, ω), Q symmetric.
///
/// Copper loss is the square of a weighted sum, friction loss a product of two.
///
/// # Source
/// docs/theory/moments.md
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Form(pub(crate) [[f64; 4]; 4]);

impl Form {
    /// (c·x)²
    #[inline]
    pub fn square(c: [f64; 4]) -> Self {
        Self::product(c, c)
    }

    /// (a·x)(b·x)
    #[inline]
    pub fn product(a: [f64; 4], b: [f64; 4]) -> Self {
        let mut form = Self::default();
        for ((row, a_i), b_i) in form.0.iter_mut().zip(a).zip(b) {
            for ((q, a_j), b_j) in row.iter_mut().zip(a).zip(b) {
                *q = 0.5 * (a_i * b_j + a_j * b_i);
            }
        }
        form
    }

    /// Returns the sum of two forms.
    #[inline]
    pub fn plus(mut self, other: &Self) -> Self {
        for (row, others) in self.0.iter_mut().zip(&other.0) {
            for (q, other) in row.iter_mut().zip(others) {
                *q += other;
            }
        }
        self
    }

    /// Returns the form multiplied by a factor.
    #[inline]
    pub fn scale(mut self, factor: f64) -> Self {
        self.0.iter_mut().flatten().for_each(|q| *q *= factor);
        self
    }

    /// Evaluates u at a node.
    #[inline]
    pub fn at(&self, node: &Node) -> f64 {
        let x = node.signals();
        self.0.iter().zip(x).map(|(row, a)| a * row.iter().zip(x).map(|(q, b)| q * b).sum::<f64>()).sum()
    }
}
