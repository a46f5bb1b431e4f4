//! Comparison of the products of a series: values of the same motor, and power laws in size.

use super::finding::{ComparedFigure, PlausibilityFinding};
use super::rows::Row;
use super::rules::{PlausibilityRuleId, SERIES_KEYS, SIZE_KEYS, SeriesKey};
use std::collections::BTreeMap;

/// Smallest number of products with a value: one that deviates and four that agree.
pub(super) const PRODUCTS_LEAST: usize = 5;

/// Smallest factor from the power law that is a finding. The built-in series stays within 3.5.
pub(super) const FACTOR_LEAST: f64 = 5.0;

/// Widest plausible ratio of J_out/i² among products with the same motor, brake and encoder included. The built-in series
/// stays within 2.
pub(super) const SAME_MOTOR_FACTOR: f64 = 3.0;

/// Smallest number of products with the same motor of which a deviating one is found.
const SAME_MOTOR_LEAST: usize = 3;

/// Compared ratio of products with the same motor.
const SAME_MOTOR_FORMULA: &str = "J_out / (J · i²)";

/// Largest number of products from which a law is fitted, evenly spread over the series: bounds the time.
const FITTED_MOST: usize = 120;

/// Smallest difference of sizes, in decades, between two products that decide a slope.
const SIZE_STEP: f64 = 0.1;

/// Median of absolute deviations of a normal distribution, in standard deviations.
const MAD_OF_SIGMA: f64 = 0.6745;

/// Standard deviations beyond which a value is no scatter.
const SIGMAS: f64 = 5.0;

/// Products of a file, compared with each other.
pub(super) struct Peers<'r> {
    pub(super) rows: &'r [Row],
    pub(super) series: SeriesFits,
    pub(super) motors: SameMotors,
}

/// J_out/i² of products with the same motor, relative to their median: of those with equal k_TM and R_LL within one series.
///
/// J_out = J·i² for the inertia J of the motor, on which the gear, the encoder and the brake have a small part.
pub(super) struct SameMotors(BTreeMap<usize, MotorInertia>);

/// Manufacturer, series, and the bits of torque constant and resistance, by which a motor is recognised.
type SameMotorKey<'r> = (&'r str, &'r str, u64, u64);

struct MotorInertia {
    /// Ratio to the median.
    ratio: f64,
    /// Product with the median.
    nearest: usize,
}

impl SameMotors {
    /// Compares the products of a file; at least three are needed to find the wrong one.
    pub(super) fn of(rows: &[Row]) -> Self {
        let mut motors: BTreeMap<SameMotorKey<'_>, Vec<(usize, f64)>> = BTreeMap::new();
        for (index, row) in rows.iter().enumerate() {
            let value = |key: &str| row.si(key).filter(|value| *value > 0.0);
            let of_motor = value("torque_constant_motor").zip(value("resistance_ll"));
            if let Some(((constant, resistance), (inertia, ratio))) =
                of_motor.zip(value("inertia_out").zip(value("ratio")))
            {
                let motor = (row.maker.as_str(), row.series.as_str(), constant.to_bits(), resistance.to_bits());
                motors.entry(motor).or_default().push((index, inertia / ratio.powi(2)));
            }
        }
        let mut found = BTreeMap::new();
        for mut products in motors.into_values().filter(|products| products.len() >= SAME_MOTOR_LEAST) {
            // The median is that of a product, so that the ratio can be found by its figures; of two, the smaller.
            products.sort_by(|a, b| a.1.total_cmp(&b.1));
            let Some(&(nearest, middle)) = products.get((products.len() - 1) / 2) else { continue };
            found.extend(
                products.into_iter().map(|(index, inertia)| (index, MotorInertia { ratio: inertia / middle, nearest })),
            );
        }
        Self(found)
    }

    /// Returns the ratio of a product.
    pub(super) fn ratio(&self, index: usize) -> Option<f64> {
        self.0.get(&index).map(|found| found.ratio)
    }

    /// Returns the products that deviate from the others with the same motor.
    pub(super) fn findings(&self, rows: &[Row]) -> Vec<PlausibilityFinding> {
        let far = self.0.iter().filter(|(_, found)| !is_same_motor(found.ratio));
        let finding = |(index, found): (&usize, &MotorInertia)| {
            let row = rows.get(*index)?;
            let terms = [("J_out", "inertia_out"), ("i", "ratio")];
            let figures = terms.into_iter().filter_map(|(symbol, key)| row.figure(symbol, key)).collect();
            Some(PlausibilityFinding {
                formula: SAME_MOTOR_FORMULA,
                ratio: Some(found.ratio),
                window: Some((1.0 / SAME_MOTOR_FACTOR, SAME_MOTOR_FACTOR)),
                other: rows.get(found.nearest).map(|other| (other.id.clone(), other.line)),
                ..row.finding(PlausibilityRuleId::SameMotor, figures)
            })
        };
        far.filter_map(finding).collect()
    }
}

/// Returns `true` if J_out/i² is that of the same motor.
pub(super) fn is_same_motor(ratio: f64) -> bool {
    (1.0 / SAME_MOTOR_FACTOR..=SAME_MOTOR_FACTOR).contains(&ratio)
}

/// Power law of a key within a series.
struct Law {
    of: SeriesKey,
    slope: f64,
    /// Logarithm at the median size.
    middle: f64,
    /// Largest deviation that is no finding, as logarithm.
    most: f64,
}

/// Products that are compared with each other.
struct Group {
    /// Indices of the products, each with its size: the logarithm of a mass relative to the median of the series.
    sizes: BTreeMap<usize, f64>,
    laws: Vec<Law>,
}

/// Power laws of all series of a file.
pub(super) struct SeriesFits(Vec<Group>);

impl SeriesFits {
    /// Fits the laws: products of one manufacturer, series and voltage of the winding.
    pub(super) fn of(rows: &[Row]) -> Self {
        let mut groups: BTreeMap<(&str, &str, Option<u64>), Vec<usize>> = BTreeMap::new();
        for (index, row) in rows.iter().enumerate() {
            let voltage = row.si("dc_link_max").map(f64::to_bits);
            groups.entry((&row.maker, &row.series, voltage)).or_default().push(index);
        }
        let enough = groups.into_iter().filter(|(_, members)| members.len() >= PRODUCTS_LEAST);
        Self(enough.map(|((.., voltage), members)| Group::of(rows, &members, voltage.is_some())).collect())
    }

    /// Returns the values that deviate from the law of their series.
    pub(super) fn findings(&self, rows: &[Row]) -> Vec<PlausibilityFinding> {
        let of_group = |group: &Group| {
            let mut found = Vec::new();
            for (index, size) in &group.sizes {
                let Some(row) = rows.get(*index) else { continue };
                for law in &group.laws {
                    let Some(deviation) = law.deviation(row, *size).filter(|deviation| deviation.abs() > law.most)
                    else {
                        continue;
                    };
                    let figures: Vec<ComparedFigure> = row.figure("", law.of.key).into_iter().collect();
                    found.push(PlausibilityFinding {
                        formula: law.of.key,
                        ratio: Some(10.0_f64.powf(deviation)),
                        window: Some((10.0_f64.powf(-law.most), 10.0_f64.powf(law.most))),
                        ..row.finding(PlausibilityRuleId::Neighbours, figures)
                    });
                }
            }
            found
        };
        self.0.iter().flat_map(of_group).collect()
    }

    /// Returns the deviation of a value, in decades, from the law of the series, and the largest one without a finding.
    pub(super) fn deviation(&self, index: usize, row: &Row, key: &str) -> Option<(f64, f64)> {
        let group = self.0.iter().find(|group| group.sizes.contains_key(&index))?;
        let law = group.laws.iter().find(|law| law.of.key == key)?;
        Some((law.deviation(row, *group.sizes.get(&index)?)?, law.most))
    }
}

impl Law {
    fn deviation(&self, row: &Row, size: f64) -> Option<f64> {
        Some(logarithm(row, &self.of)? - self.middle - self.slope * size)
    }

    /// Fits a law: the median of the slopes between two products (Theil and Sen), and the median of what remains.
    ///
    /// # Source
    /// P. K. Sen, *Estimates of the regression coefficient based on Kendall's tau*, J. Am. Stat. Assoc. 63 (1968): up to 29 % of
    /// the values may be wrong.
    fn of(of: SeriesKey, points: &[(f64, f64)]) -> Option<Self> {
        let step = points.len().div_ceil(FITTED_MOST).max(1);
        let fitted: Vec<(f64, f64)> = points.iter().step_by(step).copied().collect();
        let pairs = fitted.iter().enumerate().flat_map(|(index, a)| fitted.iter().skip(index + 1).map(move |b| (a, b)));
        let slopes = pairs.filter(|(a, b)| (b.0 - a.0).abs() > SIZE_STEP).map(|(a, b)| (b.1 - a.1) / (b.0 - a.0));
        let slope = median(slopes.collect()).unwrap_or(0.0);
        let rest: Vec<f64> = fitted.iter().map(|(size, value)| value - slope * size).collect();
        let middle = median(rest.clone())?;
        let scatter = median(rest.into_iter().map(|value| (value - middle).abs()).collect())?;
        let most = FACTOR_LEAST.log10().max(SIGMAS * scatter / MAD_OF_SIGMA);
        Some(Self { of, slope, middle, most })
    }
}

impl Group {
    fn of(rows: &[Row], members: &[usize], has_voltage: bool) -> Self {
        let sizes = sizes(rows, members);
        let law = |of: &SeriesKey| {
            if of.winding && !has_voltage {
                return None;
            }
            let point = |(index, size): (&usize, &f64)| Some((*size, logarithm(rows.get(*index)?, of)?));
            let points: Vec<(f64, f64)> = sizes.iter().filter_map(point).collect();
            (points.len() >= PRODUCTS_LEAST).then(|| Law::of(*of, &points)).flatten()
        };
        let laws = SERIES_KEYS.iter().filter_map(law).collect();
        Self { sizes, laws }
    }
}

/// Returns the size of each product: the median over its size keys of their logarithms relative to the median of the series,
/// so that one wrong value of several does not shift it.
fn sizes(rows: &[Row], members: &[usize]) -> BTreeMap<usize, f64> {
    let mut found: BTreeMap<usize, Vec<f64>> = members.iter().map(|index| (*index, Vec::new())).collect();
    for (key, power) in SIZE_KEYS {
        let value = |index: &usize| Some((*index, rows.get(*index)?.si(key).filter(|value| *value > 0.0)?.log10()));
        let values: Vec<(usize, f64)> = members.iter().filter_map(value).collect();
        let Some(middle) = median(values.iter().map(|(_, value)| *value).collect()) else { continue };
        for (index, value) in values {
            if let Some(list) = found.get_mut(&index) {
                list.push(power * (value - middle));
            }
        }
    }
    found.into_iter().map(|(index, list)| (index, median(list).unwrap_or(0.0))).collect()
}

/// Returns the logarithm of a value without its dependence on the ratio.
fn logarithm(row: &Row, of: &SeriesKey) -> Option<f64> {
    let value = row.si(of.key).filter(|value| *value > 0.0)?.log10();
    if of.ratio == 0.0 {
        return Some(value);
    }
    Some(value - of.ratio * row.si("ratio").filter(|ratio| *ratio > 0.0)?.log10())
}

/// Returns the median; of an even number of values the mean of the middle two.
fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    let half = values.len() / 2;
    let upper = *values.get(half)?;
    if values.len() % 2 == 1 {
        return Some(upper);
    }
    Some(0.5 * (upper + values.get(half.checked_sub(1)?)?))
}
