//! Reduction of long courses without loss of an extreme.

use questions::{Course, Sample};

/// Number of samples above which a course is reduced.
const SAMPLES_MAX: usize = 200_000;

/// Number of time columns of a reduced course; finer than the pixels of a picture.
const COLUMNS: f64 = 8000.0;

type Quantity = fn(&Sample) -> Option<f64>;

const QUANTITIES: [Quantity; 9] = [
    |sample| Some(sample.position_rad),
    |sample| Some(sample.speed_rad_s),
    |sample| Some(sample.acceleration_rad_s2),
    |sample| Some(sample.torque_nm),
    |sample| sample.current_a,
    |sample| sample.power_w,
    |sample| sample.winding_k,
    |sample| sample.housing_k,
    |sample| sample.overload,
];

/// Reduces each time column to the first and the last sample, and those with the least or largest value of a quantity.
pub(crate) fn thinned(course: Course) -> Course {
    if course.samples.len() <= SAMPLES_MAX || course.duration_s <= 0.0 {
        return course;
    }
    let column = |sample: &Sample| (sample.time_s / course.duration_s * COLUMNS).floor();
    let samples = course.samples.chunk_by(|a, b| column(a) == column(b)).flat_map(extremes).collect();
    Course { samples, ..course }
}

/// Returns the samples of a column that a picture needs, in their order.
fn extremes(samples: &[Sample]) -> Vec<Sample> {
    let of = |quantity: usize, row: usize| QUANTITIES.get(quantity)?(samples.get(row)?);
    let rows = outstanding(samples.len(), QUANTITIES.len(), of);
    rows.into_iter().filter_map(|row| samples.get(row).copied()).collect()
}

/// Returns the first and the last of several rows, and those with the least or the largest value of a quantity, in
/// order; `of`: value of a quantity in a row.
pub(crate) fn outstanding(rows: usize, quantities: usize, of: impl Fn(usize, usize) -> Option<f64>) -> Vec<usize> {
    let mut kept = vec![0, rows.saturating_sub(1)];
    for quantity in 0..quantities {
        let mut found: Option<((usize, f64), (usize, f64))> = None;
        for (row, value) in (0..rows).filter_map(|row| Some((row, of(quantity, row)?))) {
            let (low, high) = found.get_or_insert(((row, value), (row, value)));
            if value < low.1 {
                *low = (row, value);
            }
            if value > high.1 {
                *high = (row, value);
            }
        }
        kept.extend(found.map(|(low, high)| [low.0, high.0]).into_iter().flatten());
    }
    kept.sort_unstable();
    kept.dedup();
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_course_keeps_its_extremes_and_its_ends() {
        let sample = |index: u32| {
            let time_s = f64::from(index) * 1e-3;
            let peak = if index == 123_457 { 9.0 } else { 0.0 };
            Sample { time_s, position_rad: (time_s * 40.0).sin(), torque_nm: time_s + peak, ..Sample::default() }
        };
        let course = Course { samples: (0..=400_000).map(sample).collect(), duration_s: 400.0 };
        let short = thinned(course.clone());
        assert!(short.samples.len() < 100_000, "{}", short.samples.len());
        assert_eq!((short.samples.first(), short.samples.last()), (course.samples.first(), course.samples.last()));
        assert!(short.samples.windows(2).all(|pair| pair[0].time_s < pair[1].time_s));
        for of in QUANTITIES {
            let least = |course: &Course| course.samples.iter().filter_map(of).fold(f64::INFINITY, f64::min);
            let largest = |course: &Course| course.samples.iter().filter_map(of).fold(f64::NEG_INFINITY, f64::max);
            assert_eq!((least(&short), largest(&short)), (least(&course), largest(&course)));
        }
        assert!(short.samples.contains(&sample(123_457)));
    }
}
