//! Selection from a sequence in bounded memory.

/// Number of bits of a digit: its counts fit into the first-level cache.
const DIGIT: u32 = 11;

/// Returns the value at an index of the sequence in ascending order (`f64::total_cmp`); `None` at or beyond its end.
///
/// The values are read several times instead of being stored: once for their range, then once for each eleven bits in
/// which smallest and largest differ, six times at most.
#[must_use]
pub fn nth_smallest(values: impl Iterator<Item = f64> + Clone, index: usize) -> Option<f64> {
    let keys = values.map(key);
    let (count, least, most) = keys
        .clone()
        .fold((0, u64::MAX, 0), |(count, least, most), key| (count + 1_usize, least.min(key), most.max(key)));
    if index >= count {
        return None;
    }
    // Bits above `open` are those of every value that is still in question.
    let mut open = u64::BITS - (least ^ most).leading_zeros();
    let (mut found, mut before) = (least, index);
    while open > 0 {
        let shift = open.saturating_sub(DIGIT);
        let above = |key: u64| key.checked_shr(open).unwrap_or(0);
        let digit = |key: u64| (key >> shift) as usize & ((1 << (open - shift)) - 1);
        let mut counts = [0_usize; 1 << DIGIT];
        for key in keys.clone().filter(|key| above(*key) == above(found)) {
            if let Some(count) = counts.get_mut(digit(key)) {
                *count += 1;
            }
        }
        let reached = counts.iter().position(|count| {
            let is_within = before < *count;
            before -= if is_within { 0 } else { *count };
            is_within
        })?;
        found = (found & !(((1 << (open - shift)) - 1) << shift)) | (reached as u64) << shift;
        open = shift;
    }
    Some(value(found))
}

/// Returns the median of a sequence, of an even number of values the upper one; `None` if there are none.
#[must_use]
pub fn upper_median(values: impl Iterator<Item = f64> + Clone) -> Option<f64> {
    let count = values.clone().count();
    nth_smallest(values, count / 2)
}

const SIGN: u64 = 1 << 63;

/// Returns a whole number in the order of `f64::total_cmp`.
const fn key(value: f64) -> u64 {
    let bits = value.to_bits();
    if bits & SIGN == 0 { bits | SIGN } else { !bits }
}

const fn value(key: u64) -> f64 {
    f64::from_bits(if key & SIGN == 0 { !key } else { key & !SIGN })
}

/// Returns the value that a part of the values does not exceed; 0 without a value.
#[must_use]
pub fn quantile(values: &mut [f64], part: f64) -> f64 {
    #[allow(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a place among the values"
    )]
    let place = ((values.len() as f64 * part) as usize).min(values.len().saturating_sub(1));
    if values.is_empty() { 0.0 } else { *values.select_nth_unstable_by(place, f64::total_cmp).1 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_value_is_that_of_the_sorted_sequence() {
        arbtest::arbtest(|u| {
            let count = u.int_in_range(0..=60_usize)?;
            let is_close = u.arbitrary::<bool>()?;
            let mut values: Vec<f64> = Vec::new();
            for _ in 0..count {
                let any: f64 = u.arbitrary()?;
                // Steps of an even recording differ in the last bits only.
                values.push(if is_close { f64::from_bits(1e-3_f64.to_bits() + any.to_bits() % 9) } else { any });
            }
            let mut sorted = values.clone();
            sorted.sort_by(f64::total_cmp);
            for index in 0..=count {
                let found = nth_smallest(values.iter().copied(), index).map(f64::to_bits);
                assert_eq!(found, sorted.get(index).map(|value| value.to_bits()), "{index} of {sorted:?}");
            }
            assert_eq!(
                upper_median(values.iter().copied()).map(f64::to_bits),
                sorted.get(count / 2).map(|v| v.to_bits())
            );
            Ok(())
        });
    }
}
