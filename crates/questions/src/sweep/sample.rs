//! Tables of rows for a sweep: grids and seeded samples of stated keys and ranges.

use super::csv;
pub use super::stepped::SAMPLES_MOST;
use super::stepped::{Unstepped, stepped};
use crate::list::Unanswered;
use project::{Counted, Heading};
use quantities::{Language, identified};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::Rng;
use words::{fault_text, hint_text, own_hint, sweeps};

identified! {
    /// Method of covering ranges.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub enum Method {
        /// Sobol sequence, shifted by the seed; zero leaves it unshifted.
        #[default]
        Sobol = "sobol",
        /// One value in each of N equal parts of a range for N rows, in seeded order.
        LatinHypercube = "lhs",
        /// Equal steps of each range, in every combination.
        Grid = "grid",
    }
}

/// Values of the cells of a column.
#[derive(Clone, Debug, PartialEq)]
enum Values {
    /// Lower and upper end; `true` for equal ratios instead of equal differences.
    Range(f64, f64, bool),
    /// Listed values.
    Listed(Vec<String>),
}

struct Column {
    heading: String,
    values: Values,
}

/// Returns a table in CSV: `keys` are headings, each with its range or its values.
///
/// # Errors
/// Every invalid key; more rows than permitted.
pub fn table<'k>(
    keys: impl Iterator<Item = &'k str>,
    method: Method,
    samples: usize,
    seed: u64,
    language: Language,
) -> Result<String, Unanswered> {
    let keys: Vec<&str> = keys.filter(|key| !key.trim().is_empty()).collect();
    let counted = Counted::of(keys.iter().filter_map(|key| Some(key.rsplit_once('=')?.0)));
    let read = keys.iter().map(|key| column(key, counted, language));
    let (mut columns, mut faults) = (Vec::new(), Vec::new());
    for found in read {
        match found {
            Ok(column) => columns.push(column),
            Err(fault) => faults.push(Unanswered::option("key", fault)),
        }
    }
    let ranges = columns.iter().filter(|column| matches!(column.values, Values::Range(..))).count();
    if keys.is_empty() {
        let hint = Some(sweeps::sample_key_hint(language).to_owned());
        faults.push(Unanswered::option("key", (sweeps::no_sample_keys(language).to_owned(), hint)));
    }
    if method == Method::Sobol && ranges > SOBOL.len() {
        let message = sweeps::too_many_dimensions(&ranges, &SOBOL.len(), language);
        faults.push(Unanswered::option("by", (message, None)));
    }
    if !faults.is_empty() {
        return Err(Unanswered::combined(faults));
    }
    let combinations = |column: &Column| match (&column.values, method) {
        (Values::Range(..), Method::Grid) => samples as u64,
        (Values::Range(..), Method::LatinHypercube | Method::Sobol) => 1,
        (Values::Listed(listed), _) => listed.len() as u64,
    };
    let drawn = if method == Method::Grid || ranges == 0 { 1 } else { samples as u64 };
    let rows = columns.iter().map(combinations).fold(drawn, u64::saturating_mul);
    if rows > SAMPLES_MOST {
        let message = sweeps::too_many_samples(&rows, &SAMPLES_MOST, language);
        return Err(Unanswered::option("samples", (message, None)));
    }
    let shares = shares(method, ranges, samples, seed);
    let headings: Vec<_> = columns.iter().map(|column| csv::written(&column.heading)).collect();
    let mut text = headings.join(",");
    text.push('\n');
    for row in 0..rows {
        // The first column changes least often; all samples follow within each combination of listed values.
        let mut rest = row / drawn;
        let mut cells: Vec<String> = vec![String::new(); columns.len()];
        let mut range = ranges;
        for (column, cell) in columns.iter().zip(&mut cells).rev() {
            let count = combinations(column);
            #[allow(clippy::cast_possible_truncation, reason = "below the rows of the table")]
            let place = (rest % count) as usize;
            rest /= count;
            *cell = match &column.values {
                Values::Listed(listed) => listed.get(place).cloned().unwrap_or_default(),
                Values::Range(low, high, is_log) => {
                    range -= 1;
                    #[allow(
                        clippy::cast_precision_loss,
                        clippy::cast_possible_truncation,
                        reason = "at most a million"
                    )]
                    let share = match method {
                        Method::Grid => place as f64 / (count.max(2) - 1) as f64,
                        Method::LatinHypercube | Method::Sobol => {
                            let of_row = shares.get((row % drawn) as usize);
                            of_row.and_then(|shares| shares.get(range)).copied().unwrap_or(0.0)
                        }
                    };
                    at(*low, *high, *is_log, share).to_string()
                }
            };
        }
        let cells: Vec<_> = cells.iter().map(|cell| csv::written(cell)).collect();
        text.push_str(&cells.join(","));
        text.push('\n');
    }
    Ok(text)
}

/// Returns the value at a share of a range, rounded to nine digits for legibility.
fn at(low: f64, high: f64, is_log: bool, share: f64) -> f64 {
    let value = if is_log { low * (high / low).powf(share) } else { low + share * (high - low) };
    format!("{value:.8e}").parse().unwrap_or(value)
}

/// Parses one key with its range or values: `load.inertia [kg m^2] = 0.1..10 log`.
fn column(written: &str, counted: Counted, language: Language) -> Result<Column, (String, Option<String>)> {
    let shown: String = written.chars().take(80).collect();
    let wrong = || (sweeps::sample_key(&shown, language), Some(sweeps::sample_key_hint(language).to_owned()));
    let (heading, values) = written.rsplit_once('=').ok_or_else(wrong)?;
    let heading = heading.trim();
    let read = if heading == super::CODE { None } else { Some(Heading::read(heading, counted, None)) };
    let read = read.transpose().map_err(|(fault, hint)| {
        let hint = hint.map(|hint| hint_text(&hint, language)).or_else(|| own_hint(&fault, language));
        (fault_text(&fault, language), hint)
    })?;
    let values = values.trim();
    let is_number = read.as_ref().is_some_and(Heading::is_number);
    if let Some((low, high)) = values.split_once("..") {
        if let Some((high, step)) = high.split_once(':').filter(|_| is_number) {
            let listed = stepped(low, high, step).map_err(|why| match why {
                Unstepped::NoNumber => wrong(),
                why => unstepped((values, step.trim()), &why, language),
            })?;
            return Ok(Column { heading: heading.to_owned(), values: Values::Listed(listed) });
        }
        let (high, is_log) = high.trim().strip_suffix("log").map_or((high, false), |high| (high, true));
        let number = |text: &str| text.trim().parse::<f64>().ok().filter(|number| number.is_finite());
        let (low, high) = number(low).zip(number(high)).filter(|_| is_number).ok_or_else(wrong)?;
        if is_log && low.min(high) <= 0.0 {
            return Err((sweeps::log_needs_positive(&heading, language), None));
        }
        return Ok(Column { heading: heading.to_owned(), values: Values::Range(low, high, is_log) });
    }
    let listed: Vec<String> = values.split(';').map(|value| value.trim().to_owned()).collect();
    if listed.iter().any(|value| value.is_empty() || (is_number && value.parse::<f64>().is_err())) {
        return Err(wrong());
    }
    Ok(Column { heading: heading.to_owned(), values: Values::Listed(listed) })
}

/// Returns the refusal of a step that does not divide a range, with the nearest steps that do.
fn unstepped((values, step): (&str, &str), why: &Unstepped, language: Language) -> (String, Option<String>) {
    match why {
        Unstepped::Missed(nearest) => {
            let hint = (!nearest.is_empty()).then(|| sweeps::steps_that_meet(&nearest.join(", "), language));
            (sweeps::step_misses(&values, &step, language), hint)
        }
        Unstepped::NoNumber | Unstepped::TooMany => {
            (sweeps::step_too_small(&values, &step, &SAMPLES_MOST, language), None)
        }
    }
}

/// Returns the shares of the ranges for each row.
fn shares(method: Method, ranges: usize, samples: usize, seed: u64) -> Vec<Vec<f64>> {
    match method {
        Method::Grid => Vec::new(),
        Method::LatinHypercube => latin_hypercube(ranges, samples, seed),
        Method::Sobol => sobol(ranges, samples, seed),
    }
}

fn generator(seed: u64, dimension: usize) -> Pcg64Mcg {
    Pcg64Mcg::new(u128::from(seed) << 64 | (dimension as u128 + 1) << 1 | 1)
}

/// Returns a uniform number in [0, 1).
#[allow(clippy::cast_precision_loss, reason = "53 bits")]
fn uniform(generator: &mut Pcg64Mcg) -> f64 {
    (generator.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

/// Computes a Latin hypercube: one value in each of N equal parts for each range.
///
/// # Source
/// McKay, Beckman, Conover: A comparison of three methods for selecting values of input variables, Technometrics 21
/// (1979) 239
#[allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "at most a million"
)]
fn latin_hypercube(ranges: usize, samples: usize, seed: u64) -> Vec<Vec<f64>> {
    let mut rows = vec![vec![0.0; ranges]; samples];
    for dimension in 0..ranges {
        let mut generator = generator(seed, dimension);
        let mut parts: Vec<usize> = (0..samples).collect();
        // Shuffle of Fisher and Yates.
        for last in (1..samples).rev() {
            let other = (uniform(&mut generator) * (last + 1) as f64) as usize;
            parts.swap(last, other.min(last));
        }
        for (row, part) in rows.iter_mut().zip(parts) {
            if let Some(cell) = row.get_mut(dimension) {
                *cell = (part as f64 + uniform(&mut generator)) / samples as f64;
            }
        }
    }
    rows
}

/// Degree, coefficients of the primitive polynomial without its ends, initial numbers of each dimension from the
/// second.
type Direction = (u32, u32, &'static [u32]);

/// # Source
/// S. Joe, F. Y. Kuo: Constructing Sobol sequences with better two-dimensional projections, SIAM J. Sci. Comput. 30
/// (2008) 2635; file new-joe-kuo-6.21201
const SOBOL: [Direction; 16] = [
    (0, 0, &[]),
    (1, 0, &[1]),
    (2, 1, &[1, 3]),
    (3, 1, &[1, 3, 1]),
    (3, 2, &[1, 1, 1]),
    (4, 1, &[1, 1, 3, 3]),
    (4, 4, &[1, 3, 5, 13]),
    (5, 2, &[1, 1, 5, 5, 17]),
    (5, 4, &[1, 1, 5, 5, 5]),
    (5, 7, &[1, 1, 7, 11, 19]),
    (5, 11, &[1, 1, 5, 1, 1]),
    (5, 13, &[1, 1, 1, 3, 11]),
    (5, 14, &[1, 3, 5, 5, 31]),
    (6, 1, &[1, 3, 3, 9, 7, 49]),
    (6, 13, &[1, 1, 1, 15, 21, 21]),
    (6, 16, &[1, 3, 1, 13, 27, 49]),
];

/// Number of bits of a number of the sequence.
const BITS: u32 = 32;

/// Computes the direction numbers of a dimension: v_k = m_k 2^(32−k).
///
/// m_k = 2 a_1 m_(k−1) ⊕ 4 a_2 m_(k−2) ⊕ … ⊕ 2^s m_(k−s) ⊕ m_(k−s)
///
/// # Symbols
/// s degree, a_j coefficients of the polynomial
/// # Source
/// P. Bratley, B. L. Fox: Algorithm 659, ACM Trans. Math. Softw. 14 (1988) 88
fn directions((degree, coefficients, initial): Direction) -> Vec<u32> {
    let mut numbers: Vec<u32> = Vec::with_capacity(BITS as usize);
    for place in 0..BITS {
        let number = match initial.get(place as usize) {
            _ if degree == 0 => 1,
            Some(number) => *number,
            None => {
                let before = |back: u32| numbers.get((place - back) as usize).copied().unwrap_or(0);
                let mut number = before(degree) ^ (before(degree) << degree);
                for back in 1..degree {
                    if coefficients >> (degree - 1 - back) & 1 == 1 {
                        number ^= before(back) << back;
                    }
                }
                number
            }
        };
        numbers.push(number);
    }
    numbers.iter().zip(0..).map(|(number, place): (&u32, u32)| number << (BITS - 1 - place)).collect()
}

/// Computes the Sobol sequence in the order of the Gray code, each dimension shifted by a seeded number (a digital
/// shift preserves its nets).
fn sobol(ranges: usize, samples: usize, seed: u64) -> Vec<Vec<f64>> {
    let directions: Vec<Vec<u32>> = SOBOL.iter().take(ranges).map(|direction| directions(*direction)).collect();
    let shift = |dimension| if seed == 0 { 0 } else { (generator(seed, dimension).next_u64() >> BITS) as u32 };
    let shifts: Vec<u32> = (0..ranges).map(shift).collect();
    let mut state = vec![0_u32; ranges];
    (0..samples)
        .map(|row| {
            if row > 0 {
                let place = row.trailing_zeros() as usize;
                for (number, of) in state.iter_mut().zip(&directions) {
                    *number ^= of.get(place).copied().unwrap_or(0);
                }
            }
            let share = |(number, shift): (&u32, &u32)| f64::from(number ^ shift) / 4_294_967_296.0;
            state.iter().zip(&shifts).map(share).collect()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Row 1000 of the sequence in sixteen dimensions, by scipy 1.17.1: `scipy.stats.qmc.Sobol(d=16,
    /// scramble=False).random(1024)[1000]`.
    #[test]
    fn the_sequence_is_that_of_another_tool() {
        let expected = [
            0.2197265625,
            0.0966796875,
            0.5185546875,
            0.6767578125,
            0.2802734375,
            0.9072265625,
            0.0458984375,
            0.8994140625,
            0.5009765625,
            0.0693359375,
            0.0849609375,
            0.2548828125,
            0.1611328125,
            0.3837890625,
            0.1435546875,
            0.3701171875,
        ];
        assert_eq!(sobol(16, 1001, 0)[1000], expected);
        assert_eq!(sobol(5, 5, 0)[4], [0.375, 0.375, 0.625, 0.875, 0.375]);
        assert!(sobol(3, 64, 5) != sobol(3, 64, 6) && sobol(3, 64, 5) == sobol(3, 64, 5));
    }

    #[test]
    fn a_latin_hypercube_has_one_value_in_each_part() {
        let rows = latin_hypercube(3, 50, 1);
        for dimension in 0..3 {
            let mut parts: Vec<usize> = rows.iter().map(|row| (row[dimension] * 50.0) as usize).collect();
            parts.sort_unstable();
            assert_eq!(parts, (0..50).collect::<Vec<_>>());
        }
    }

    #[test]
    fn a_grid_and_lists_are_every_combination() {
        let keys = ["load.inertia [kg m^2] = 0.1..10 log", "motion[1].law = trapezoid; polynomial_5"];
        let text = table(keys.into_iter(), Method::Grid, 3, 1, Language::En).unwrap();
        let expected = "load.inertia [kg m^2],motion[1].law\n0.1,trapezoid\n0.1,polynomial_5\n1,trapezoid\n1,polynomial_5\n\
            10,trapezoid\n10,polynomial_5\n";
        assert_eq!(text, expected);
        let stepped = "load.inertia [kg m^2] = 0.1..0.3:0.1";
        let text = table(std::iter::once(stepped), Method::Grid, 11, 1, Language::En).unwrap();
        assert_eq!(text, "load.inertia [kg m^2]\n0.1\n0.2\n0.3\n");
        let drawn = table(keys.into_iter(), Method::Sobol, 8, 1, Language::En).unwrap();
        assert_eq!(drawn.lines().count(), 17);
    }

    #[test]
    fn what_is_no_key_is_refused_with_what_is_near() {
        let wrong = ["load.inertia = 1..2", "load.inertai [kg m^2] = 1..2", "load.inertia [kg m^2] = a..b", "x"];
        let why = table(wrong.into_iter(), Method::Grid, 3, 1, Language::En).unwrap_err();
        assert_eq!(why.faults(None, Language::En).errors.len(), 4);
        for (wrong, named) in [("0..1:0.3", "0.25, 0.5"), ("0..1e9:1", ""), ("0..9:0", "")] {
            let why =
                table(std::iter::once(&*format!("load.inertia [kg m^2] = {wrong}")), Method::Grid, 3, 1, Language::En);
            let why = format!("{:?}", why.unwrap_err());
            assert!(why.contains(named), "{wrong}: {why}");
        }
        let many = ["load.inertia [kg m^2] = 1..2", "motion[1].time [s] = 1..2"];
        assert!(table(many.into_iter(), Method::Grid, 10_000, 1, Language::En).is_err());
    }
}
