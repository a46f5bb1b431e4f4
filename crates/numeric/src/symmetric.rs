//! Systems of linear equations with a sparse symmetric positive definite matrix.

/// A symmetric matrix stored by its rows up to the diagonal, each from its first non-zero entry.
#[derive(Clone, Debug)]
pub struct Symmetric(Vec<Row>);

#[derive(Clone, Debug)]
struct Row {
    /// Column of the first value.
    first: usize,
    /// Values up to the diagonal.
    values: Vec<f64>,
}

impl Row {
    fn from(&self, column: usize) -> &[f64] {
        self.values.get(column.saturating_sub(self.first)..).unwrap_or_default()
    }

    fn diagonal(&self) -> f64 {
        self.values.last().copied().unwrap_or(f64::NAN)
    }
}

impl Symmetric {
    /// Creates a matrix of zeros; `first` returns the column in which each row begins, limited to the diagonal.
    #[must_use]
    pub fn zero(first: impl Iterator<Item = usize>) -> Self {
        let row = |(row, first): (usize, usize)| {
            let first = first.min(row);
            Row { first, values: vec![0.0; row - first + 1] }
        };
        Self(first.enumerate().map(row).collect())
    }

    /// Adds to the entry in a row and a column, and thus to its mirror image; entries outside the envelope are ignored.
    pub fn add(&mut self, row: usize, column: usize, value: f64) {
        let (low, high) = (row.min(column), row.max(column));
        let Some(row) = self.0.get_mut(high) else { return };
        if let Some(entry) = low.checked_sub(row.first).and_then(|place| row.values.get_mut(place)) {
            *entry += value;
        }
    }

    /// Returns the solution for a right-hand side, by Cholesky decomposition within the envelope; `None` if the matrix
    /// is not positive definite.
    ///
    /// # Source
    /// George and Liu, Computer Solution of Large Sparse Positive Definite Systems (1981), ch. 4
    /// # Valid
    /// The solution is the exact one of a matrix that differs by about w ε of its own entries, w the longest row (Higham,
    /// Accuracy and Stability of Numerical Algorithms, th. 10.4), for any scaling of the rows.
    #[must_use]
    pub fn solve(mut self, mut right: Vec<f64>) -> Option<Vec<f64>> {
        let rows = &mut self.0;
        for index in 0..rows.len() {
            let (done, open) = rows.split_at_mut(index);
            let row = open.first_mut()?;
            for (above, column) in done.get(row.first..)?.iter().zip(0..) {
                let from = row.first.max(above.first);
                let before = row.values.get(from - row.first..column)?;
                let sum = dot(before, above.from(from));
                *row.values.get_mut(column)? = (row.values.get(column)? - sum) / above.diagonal();
            }
            let (diagonal, before) = row.values.split_last_mut()?;
            *diagonal = (*diagonal - dot(before, before)).sqrt();
            // NaN is not positive either.
            if diagonal.is_nan() || *diagonal <= 0.0 {
                return None;
            }
            let solved = right.get(row.first..index)?;
            let sum = dot(before, solved);
            let value = right.get_mut(index)?;
            *value = (*value - sum) / *diagonal;
        }
        for (index, row) in rows.iter().enumerate().rev() {
            let value = right.get_mut(index)?;
            *value /= row.diagonal();
            let value = *value;
            for (before, factor) in right.get_mut(row.first..index)?.iter_mut().zip(&row.values) {
                *before -= factor * value;
            }
        }
        Some(right)
    }
}

/// Returns the scalar product over the length of the shorter slice.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_system_by_hand_and_one_that_is_none() {
        let entries = [(0, 0, 4.0), (1, 0, 2.0), (1, 1, 5.0), (2, 1, 2.0), (2, 2, 5.0), (3, 0, 1.0), (3, 3, 6.0)];
        let made = |least: f64| {
            let mut matrix = Symmetric::zero([0, 0, 1, 0].into_iter());
            entries.iter().for_each(|(row, column, value)| matrix.add(*column, *row, *value));
            matrix.add(2, 2, least);
            matrix
        };
        let x = [1.0, -2.0, 3.0, 0.5];
        let right = vec![4.0 - 4.0 + 0.5, 2.0 - 10.0 + 6.0, -4.0 + 15.0, 1.0 + 3.0];
        let found = made(0.0).solve(right.clone()).unwrap();
        assert!(found.iter().zip(x).all(|(a, b)| (a - b).abs() < 1e-15), "{found:?}");
        assert!(made(-5.0).solve(right).is_none());
    }
}
