//! Least squares with correlated residuals, noisy regressors and known linear relations.

use numeric::Symmetric;

/// An equation: regressors, value, its stroke, and its place in a cycle that repeats.
#[derive(Clone, Debug)]
pub(super) struct Row {
    pub(super) regressors: Vec<f64>,
    pub(super) value: f64,
    pub(super) stroke: usize,
    /// Place within the repeated part of the run ([`Window::phase`](super::windows::Window::phase)).
    pub(super) phase: [usize; 2],
}

/// A linear relation of the coefficients known with a standard deviation: Σ factor · coefficient = 0 ± spread.
#[derive(Clone, Debug)]
pub(super) struct Prior {
    pub(super) factors: Vec<f64>,
    pub(super) spread: f64,
}

/// Solution of equations with the variances of the noise of their columns and known relations.
pub(super) type Solve = fn(&[Row], &[f64], &[Prior]) -> Option<Fit>;

/// Coefficients with their covariances.
#[derive(Clone, Debug)]
pub(super) struct Fit {
    pub(super) values: Vec<f64>,
    /// Covariances of the coefficients.
    covariance: Vec<Vec<f64>>,
    /// (XᵀX − n Σ_u + Σ w pᵀp)⁻¹.
    inverse: Vec<Vec<f64>>,
    /// Changes of the coefficients without a part of the equations, their products summed over the parts, and their covariances
    /// by `covariance`; empty if the parts have not been compared.
    parts: [Vec<Vec<f64>>; 2],
    /// Variance inflation factor of each coefficient caused by the other columns; 1 for an independent column.
    inflation: Vec<f64>,
    /// Variance of the residuals with their correlation.
    variance: f64,
    /// Norm of an error of the equations that is no noise, in the unit of the values.
    error: f64,
    /// Quantile of Student's distribution for 95 %.
    pub(super) quantile: f64,
    /// Sum of the squares of the residuals.
    pub(super) square: f64,
    /// Number of equations that count as independent.
    pub(super) independent: f64,
    /// The noise of the regressors exceeds what distinguishes them and remains in the coefficients.
    pub(super) is_attenuated: bool,
}

/// Largest variance inflation factor of a coefficient; beyond it the run does not separate it from others.
///
/// 10⁴ is a condition number of 100 of the columns scaled to length one. A choice.
const INFLATION_MOST: f64 = 1e4;

/// Share added to the diagonal, which keeps equations with dependent columns solvable; their inflation factor reveals
/// them.
const RIDGE: f64 = 1e-11;

/// Smallest standard deviation of the equations relative to the rms of their values: the error of the trapezoidal rule over the
/// shortest window.
const EXACT: f64 = 1e-4;

/// Correlation of white noise in adjacent windows: ∫ sin⁴ cos⁴/∫ sin⁸ over half a period = 3/35.
const OVERLAP: f64 = 3.0 / 35.0;

impl Fit {
    /// Returns the fit as one whose regressors keep their noise.
    pub(super) fn attenuated(self) -> Self {
        Self { is_attenuated: true, ..self }
    }

    /// Returns the standard deviation of a combination of coefficients, raised where parts of the run contradict each other.
    pub(super) fn deviation(&self, factors: &[f64]) -> f64 {
        let [changes, expected] = self.parts.each_ref().map(|matrix| quadratic(matrix, factors));
        let variance = quadratic(&self.covariance, factors);
        // What a prior knows does not change, and a part that alone knows a coefficient changes it at random.
        let apart = (changes - expected).min(variance * (changes / expected - 1.0));
        (variance + if expected > 0.0 { apart.max(0.0) } else { 0.0 }).max(0.0).sqrt()
    }

    /// Returns a coefficient with half its 95 % interval.
    pub(super) fn estimate(&self, place: usize) -> Option<(f64, f64)> {
        let value = *self.values.get(place)?;
        let mut factors = vec![0.0; self.values.len()];
        *factors.get_mut(place)? = 1.0;
        let error = self.error * self.inverse.get(place)?.get(place)?.max(0.0).sqrt();
        Some((value, (self.quantile * self.deviation(&factors)).hypot(error)))
    }

    /// Returns the fit with an error of the equations that is no noise, as the square root of the sum of its squares.
    ///
    /// |Δc| ≤ |e| √((XᵀX)⁻¹): the error may have the course of a column
    pub(super) fn with_error(self, error: f64) -> Self {
        Self { error, ..self }
    }

    /// Returns `true` if the run separates a coefficient from the others.
    pub(super) fn separates(&self, place: usize) -> bool {
        self.is_inflated_within(place, INFLATION_MOST)
    }

    /// Returns `true` if the other columns raise the variance of a coefficient less than a number of times.
    pub(super) fn is_inflated_within(&self, place: usize, most: f64) -> bool {
        self.inflation.get(place).is_some_and(|inflation| *inflation < most)
    }
}

/// Returns fᵀ M f.
fn quadratic(matrix: &[Vec<f64>], factors: &[f64]) -> f64 {
    let terms = matrix.iter().zip(factors);
    terms.map(|(line, a)| a * line.iter().zip(factors).map(|(value, b)| value * b).sum::<f64>()).sum()
}

/// Number of parts of a run that are compared. A choice.
const PARTS: usize = 10;

/// Fits as [`fit`] does, and compares the parts of the run: the variances grow by as much as the coefficients change more without
/// a part than their covariances permit.
///
/// V + min(D − E, V (D/E − 1)), D = Σ (c_p − c)², E = Σ (V_p − V), p = 1…10
///
/// # Symbols
/// c_p and V_p coefficient and variance without the p-th part of the equations, in the order of time
/// # Source
/// D: jackknife, Tukey, Bias and confidence in not-quite large samples, Ann. Math. Statist. 29 (1958); E, variance of the difference
/// of nested estimates: Hausman, Specification tests in econometrics, Econometrica 46 (1978); D/E: Birge, The calculation of errors
/// by the method of least squares, Physical Review 40 (1932)
/// # Valid
/// what the model lacks differs from part to part
pub(super) fn compared(rows: &[Row], noise: &[f64], priors: &[Prior]) -> Option<Fit> {
    let whole = fit(rows, noise, priors)?;
    let width = whole.values.len();
    let all = Sums::of(rows, width);
    let mut parts = [vec![vec![0.0; width]; width], vec![vec![0.0; width]; width]];
    for part in rows.chunks(rows.len().div_ceil(PARTS)) {
        let rest = all.without(&Sums::of(part, width));
        let Some((normal, right)) = rest.less(noise) else { continue };
        let Some((values, inverse, _)) = solved(&normal, &right, priors, whole.variance) else { continue };
        let changes: Vec<f64> = values.iter().zip(&whole.values).map(|(other, own)| other - own).collect();
        let [products, expected] = &mut parts;
        for (place, (products, expected)) in products.iter_mut().zip(expected).enumerate() {
            for (column, (product, expected)) in products.iter_mut().zip(expected).enumerate() {
                let at = |matrix: &[Vec<f64>]| matrix.get(place).and_then(|line| line.get(column)).copied();
                *product += changes.get(place)? * changes.get(column)?;
                *expected += at(&inverse)? * whole.variance - at(&whole.covariance)?;
            }
        }
    }
    Some(Fit { parts, ..whole })
}

/// Largest share of noise in the part of a column that the other columns do not explain, with which the noise is taken out of the sums
/// of squares. A choice: the error of that noise is then a hundredth of what distinguishes the column.
const NOISE_MOST: f64 = 0.1;

/// Returns `true` if noise is a considerable part of what distinguishes a column from the others.
pub(super) fn is_hidden(rows: &[Row], variance: f64, place: usize) -> bool {
    let hidden = || {
        let Sums { count, normal, right } = Sums::of(rows, rows.first()?.regressors.len());
        let (_, inverse, _) = solved(&normal, &right, &[], 0.0)?;
        Some(count * variance * inverse.get(place)?.get(place)? > NOISE_MOST)
    };
    hidden().unwrap_or(false)
}

/// Fits the coefficients of linear equations by least squares.
///
/// c = (XᵀX − n Σ_u + Σ w pᵀp)⁻¹ Xᵀy, cov c = s² g (XᵀX − n Σ_u + Σ w pᵀp)⁻¹, g = D (1 + ρ)/(1 − ρ), w = s² g/σ_p²,
/// D = max(1, Σ_c (Σ_{k∈c} r_k)²/Σ r²)
///
/// # Symbols
/// X regressors, y values, n number of equations, Σ_u variances of the noise of the regressors, s² variance of the
/// residuals r, ρ their correlation from equation to equation within a stroke (at least that of windows that overlap by
/// half), c the equations at one place of a cycle that repeats: an error that repeats with it, as the steps of a coarse position do, is
/// no noise that more cycles average out; p and σ_p prior relations with their standard deviations
/// # Source
/// Fuller, Measurement Error Models (1987), eq. 2.2.11 for Σ_u; Theil and Goldberger, On pure and mixed statistical estimation in
/// economics, International Economic Review 2 (1961), for the prior; Moulton, Random group effects and the precision of regression
/// estimates, Journal of Econometrics 32 (1986), for D; n/g equations count as independent
/// # Valid
/// noise of the regressors small compared with the regressors
pub(super) fn fit(rows: &[Row], noise: &[f64], priors: &[Prior]) -> Option<Fit> {
    let width = rows.first()?.regressors.len();
    if rows.len() <= width + 2 {
        return None;
    }
    let (normal, right) = Sums::of(rows, width).less(noise)?;
    #[allow(clippy::cast_precision_loss, reason = "counts of windows")]
    let count = rows.len() as f64;
    // Without noise a prior would weigh nothing, and dependent columns be solved by rounding: windows are exact to a share.
    let square = || rows.iter().map(|row| row.value * row.value).sum::<f64>();
    let least = if priors.is_empty() { 0.0 } else { EXACT.powi(2) * square() / count };
    let mut variance = 0.0;
    let mut found = None;
    // The weight of a prior depends on the variance of the residuals and vice versa.
    for _ in 0..if priors.is_empty() { 1 } else { 5 } {
        let (values, inverse, inflation) = solved(&normal, &right, priors, variance)?;
        let residues: Vec<(usize, f64)> = rows
            .iter()
            .map(|row| (row.stroke, row.value - row.regressors.iter().zip(&values).map(|(a, b)| a * b).sum::<f64>()))
            .collect();
        let square: f64 = residues.iter().map(|(_, residue)| residue * residue).sum();
        let pairs = residues.windows(2).filter_map(|pair| match pair {
            [(a, x), (b, y)] if a == b => Some(x * y),
            _ => None,
        });
        let rho = if square > 0.0 { (pairs.sum::<f64>() / square).clamp(OVERLAP, 0.95) } else { 0.0 };
        let grown = (1.0 + rho) / (1.0 - rho) * repeated(rows, &residues);
        #[allow(clippy::cast_precision_loss, reason = "a handful")]
        let width = width as f64;
        variance = (square / (count - width) * grown).max(least);
        let covariance = inverse.iter().map(|line| line.iter().map(|value| value * variance).collect()).collect();
        let error = 0.0;
        let quantile = student((count / grown - width).max(4.0));
        let independent = count / grown;
        let (parts, is_attenuated) = ([Vec::new(), Vec::new()], false);
        found = Some(Fit {
            values,
            covariance,
            inverse,
            parts,
            variance,
            error,
            inflation,
            quantile,
            square,
            independent,
            is_attenuated,
        });
    }
    found
}

/// Returns D: the factor by which errors that repeat with the cycle raise the variances.
fn repeated(rows: &[Row], residues: &[(usize, f64)]) -> f64 {
    let mut placed: Vec<([usize; 2], f64)> =
        rows.iter().zip(residues).map(|(row, (_, residue))| (row.phase, *residue)).collect();
    placed.sort_by_key(|(phase, _)| *phase);
    let of_place = |place: &[([usize; 2], f64)]| place.iter().map(|(_, residue)| residue).sum::<f64>().powi(2);
    let together: f64 = placed.chunk_by(|(one, _), (other, _)| one == other).map(of_place).sum();
    let square: f64 = residues.iter().map(|(_, residue)| residue * residue).sum();
    if square > 0.0 { (together / square).max(1.0) } else { 1.0 }
}

/// Sums of products of the equations.
struct Sums {
    count: f64,
    normal: Vec<Vec<f64>>,
    right: Vec<f64>,
}

impl Sums {
    fn of(rows: &[Row], width: usize) -> Self {
        let mut normal = vec![vec![0.0; width]; width];
        let mut right = vec![0.0; width];
        for row in rows {
            for ((line, right), a) in normal.iter_mut().zip(&mut right).zip(&row.regressors) {
                *right += a * row.value;
                for (cell, b) in line.iter_mut().zip(&row.regressors) {
                    *cell += a * b;
                }
            }
        }
        #[allow(clippy::cast_precision_loss, reason = "counts of windows")]
        let count = rows.len() as f64;
        Self { count, normal, right }
    }

    /// Returns the sums without those of a part.
    fn without(&self, part: &Self) -> Self {
        let less = |all: &[f64], part: &[f64]| all.iter().zip(part).map(|(a, b)| a - b).collect::<Vec<f64>>();
        let normal = self.normal.iter().zip(&part.normal).map(|(all, part)| less(all, part)).collect();
        Self { count: self.count - part.count, normal, right: less(&self.right, &part.right) }
    }

    /// Returns normal matrix and right side without the noise of the regressors; `None` if the noise exceeds the signal.
    fn less(self, noise: &[f64]) -> Option<(Vec<Vec<f64>>, Vec<f64>)> {
        let Self { count, mut normal, right } = self;
        for (place, variance) in noise.iter().enumerate() {
            let cell = normal.get_mut(place)?.get_mut(place)?;
            let own = *cell - count * variance;
            // More noise than signal: the column carries no information.
            if *variance > 0.0 && own < 0.5 * *cell {
                return None;
            }
            *cell = own;
        }
        Some((normal, right))
    }
}

/// Coefficients, inverse of the normal matrix, variance inflation factors.
type Solved = (Vec<f64>, Vec<Vec<f64>>, Vec<f64>);

fn solved(normal: &[Vec<f64>], right: &[f64], priors: &[Prior], variance: f64) -> Option<Solved> {
    let width = right.len();
    let mut normal = normal.to_vec();
    for prior in priors {
        let weight = variance / (prior.spread * prior.spread);
        for (line, a) in normal.iter_mut().zip(&prior.factors) {
            line.iter_mut().zip(&prior.factors).for_each(|(cell, b)| *cell += weight * a * b);
        }
    }
    // Columns are scaled to equal size to preserve small ones.
    let scale: Vec<f64> = (0..width)
        .map(|place| Some(normal.get(place)?.get(place)?.sqrt().max(f64::MIN_POSITIVE)))
        .collect::<Option<_>>()?;
    let column = |right: Vec<f64>| {
        let mut matrix = Symmetric::zero(std::iter::repeat_n(0, width));
        for ((place, line), a) in normal.iter().enumerate().zip(&scale) {
            for ((column, value), b) in line.iter().enumerate().zip(&scale).take(place + 1) {
                matrix.add(place, column, value / (a * b));
            }
            matrix.add(place, place, RIDGE);
        }
        matrix.solve(right)
    };
    let scaled = column(right.iter().zip(&scale).map(|(value, scale)| value / scale).collect())?;
    let values = scaled.iter().zip(&scale).map(|(value, scale)| value / scale).collect();
    let mut inverse = Vec::with_capacity(width);
    let mut inflation = Vec::with_capacity(width);
    for (place, own) in scale.iter().enumerate() {
        let mut unit = vec![0.0; width];
        *unit.get_mut(place)? = 1.0;
        let line = column(unit)?;
        inflation.push(*line.get(place)?);
        inverse.push(line.iter().zip(&scale).map(|(value, scale)| value / (scale * own)).collect());
    }
    Some((values, inverse, inflation))
}

/// Two-sided quantile of the normal distribution for 95 %.
const NORMAL: f64 = 1.959_964;

/// Returns the two-sided quantile of Student's distribution for 95 %.
///
/// t = z + (z³ + z)/(4ν) + (5z⁵ + 16z³ + 3z)/(96ν²)
///
/// # Source
/// Abramowitz and Stegun, eq. 26.7.5
/// # Valid
/// ν ≥ 4 within 2 %, ν ≥ 10 within 0.2 %; smaller degrees of freedom are raised to 4
fn student(free: f64) -> f64 {
    let z = NORMAL;
    let [z3, z5] = [z.powi(3), z.powi(5)];
    z + (z3 + z) / (4.0 * free) + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * free * free)
}

#[cfg(test)]
mod tests {
    use super::*;
    use numeric::Random;

    #[test]
    fn quantiles_of_student() {
        // Abramowitz and Stegun, table 26.10: ν, t, and the error of the expansion.
        for (free, printed, within) in
            [(4.0, 2.776, 0.05), (10.0, 2.228, 0.005), (30.0, 2.042, 0.001), (120.0, 1.980, 0.001)]
        {
            assert!((student(free) - printed).abs() < within, "{free}: {}", student(free));
        }
    }

    fn rows(random: &mut Random, noise: f64) -> Vec<Row> {
        (0..400)
            .map(|k| {
                let (a, b) = (random.normal(), random.normal());
                let seen = a + noise * random.normal();
                Row {
                    regressors: vec![seen, b],
                    value: 2.0 * a - 3.0 * b + 0.1 * random.normal(),
                    stroke: k / 10,
                    phase: [k, 0],
                }
            })
            .collect()
    }

    #[test]
    fn noise_of_a_regressor_is_taken_out() {
        let mut random = Random::new(1);
        let rows = rows(&mut random, 0.4);
        let plain = fit(&rows, &[0.0, 0.0], &[]).unwrap();
        assert!(plain.values[0] < 1.8, "{plain:?}");
        let corrected = fit(&rows, &[0.16, 0.0], &[]).unwrap();
        let (value, half) = corrected.estimate(0).unwrap();
        assert!((value - 2.0).abs() < half && half < 0.15, "{value} {half}");
        assert!(fit(&rows, &[2.0, 0.0], &[]).is_none());
    }

    #[test]
    fn columns_that_say_the_same_are_not_separated_and_a_prior_separates_them() {
        let mut random = Random::new(2);
        let mut rows = rows(&mut random, 0.0);
        rows.iter_mut().for_each(|row| row.regressors.push(0.5 * row.regressors[0]));
        let open = fit(&rows, &[0.0; 3], &[]).unwrap();
        assert!(!open.separates(0) && open.separates(1) && !open.separates(2));
        let prior = Prior { factors: vec![0.5, 0.0, -1.0], spread: 0.02 };
        let known = fit(&rows, &[0.0; 3], &[prior]).unwrap();
        let (value, half) = known.estimate(0).unwrap();
        // 2 = a + b/2, b = a/2: a = 1.6.
        assert!(known.separates(0) && (value - 1.6).abs() < half && half < 0.06, "{value} {half}");
    }

    /// Equal parts leave the interval as it is, and it holds the coefficient; a coefficient that changes within the run widens it.
    #[test]
    fn parts_that_contradict_each_other_widen_the_interval() {
        let mut random = Random::new(3);
        let [mut inside, mut wider] = [0.0; 2];
        for _ in 0..200 {
            let rows = rows(&mut random, 0.0);
            let [plain, compared] = [fit, compared].map(|solve| solve(&rows, &[], &[]).unwrap().estimate(0).unwrap());
            assert_eq!(plain.0, compared.0);
            wider += compared.1 / plain.1 / 200.0;
            inside += f64::from(u8::from((compared.0 - 2.0).abs() < compared.1)) / 200.0;
        }
        assert!(inside > 0.92 && (1.0..1.2).contains(&wider), "{inside} {wider}");
        let mut rows = rows(&mut random, 0.0);
        rows.iter_mut().take(130).for_each(|row| row.value += 0.2 * row.regressors[0]);
        let [plain, half] = [fit, compared].map(|solve| solve(&rows, &[], &[]).unwrap().estimate(0).unwrap().1);
        assert!(half > 3.0 * plain, "{half} {plain}");
    }

    /// An error that repeats with each of ten cycles is as large as in one of them, and the interval holds the coefficient; noise that
    /// does not repeat leaves it as it is.
    #[test]
    fn an_error_that_repeats_is_not_averaged_out() {
        let mut random = Random::new(7);
        let [mut inside, mut wider, mut inside_if_one] = [0.0; 3];
        for _ in 0..200 {
            let cycle = rows(&mut random, 0.0).into_iter().take(80);
            let cycle: Vec<Row> = cycle.enumerate().map(|(k, row)| Row { phase: [0, k], ..row }).collect();
            let run: Vec<Row> = std::iter::repeat_n(cycle, 10).flatten().collect();
            let (value, half) = fit(&run, &[], &[]).unwrap().estimate(0).unwrap();
            inside += f64::from(u8::from((value - 2.0).abs() < half)) / 200.0;
            let apart: Vec<Row> = run.iter().enumerate().map(|(k, row)| Row { phase: [k, 0], ..row.clone() }).collect();
            let (value, half) = fit(&apart, &[], &[]).unwrap().estimate(0).unwrap();
            inside_if_one += f64::from(u8::from((value - 2.0).abs() < half)) / 200.0;
            let noisy: Vec<Row> =
                run.iter().map(|row| Row { value: row.value + 3.0 * random.normal(), ..row.clone() }).collect();
            let apart: Vec<Row> =
                noisy.iter().enumerate().map(|(k, row)| Row { phase: [k, 0], ..row.clone() }).collect();
            let [placed, free] = [noisy, apart].map(|rows| fit(&rows, &[], &[]).unwrap().estimate(0).unwrap().1);
            wider += placed / free / 200.0;
        }
        assert!(inside > 0.9 && inside_if_one < 0.6 && (1.0..1.1).contains(&wider), "{inside} {inside_if_one} {wider}");
    }

    /// An error that is no noise moves a coefficient at most by the interval that it makes.
    #[test]
    fn an_error_of_the_equations_is_in_the_interval() {
        let mut random = Random::new(4);
        for course in 0..20 {
            let mut rows = rows(&mut random, 0.0);
            rows.iter_mut().for_each(|row| row.value = 2.0 * row.regressors[0] - 3.0 * row.regressors[1]);
            let of = |row: &Row, k: usize| match course % 4 {
                0 => row.regressors[0],
                1 => row.regressors[0] - row.regressors[1],
                2 => f64::from(u8::from(k > 200)),
                _ => 1.0,
            };
            let errors: Vec<f64> = rows.iter().enumerate().map(|(k, row)| 0.3 * of(row, k)).collect();
            rows.iter_mut().zip(&errors).for_each(|(row, error)| row.value += error);
            let norm = errors.iter().map(|error| error * error).sum::<f64>().sqrt();
            let found = fit(&rows, &[], &[]).unwrap();
            let (value, half) = found.with_error(norm).estimate(0).unwrap();
            assert!((value - 2.0).abs() <= half, "{course}: {value} {half}");
        }
    }
}
