//! Counters of time that start again.

use super::stamp;
use crate::texts::said;
use quantities::Language;
use recording::Stamp;

/// Distance from the ends of the range of a counter within which it starts again, relative to the range.
const NEAR: f64 = 0.02;

/// Returns the remedy for a time that jumps from the upper end of the range of a counter to the lower end, with or without sign.
pub(super) fn counter(before: Stamp, time: Stamp, language: Language) -> Option<String> {
    if before.value.fract() != 0.0 || time.value.fract() != 0.0 {
        return None;
    }
    let starts_again = |bits: i32| {
        let range = 2.0_f64.powi(bits);
        [0.0, -0.5 * range].into_iter().any(|low| {
            let is_above = (0.0..=NEAR * range).contains(&(low + range - 1.0 - before.value));
            is_above && (0.0..=NEAR * range).contains(&(time.value - low))
        })
    };
    let bits = [8, 16, 32].into_iter().find(|bits| starts_again(*bits))?;
    let range = stamp(Stamp { value: 2.0_f64.powi(bits), unit: before.unit }, language);
    Some(said!(language =>
        "apparently a counter of {bits} bits that restarts: add {range} to the times from there on, again at each further restart, or export continuous times"
        | "offenbar ein Zähler mit {bits} Bit, der neu beginnt: ab hier {range} zu den Zeiten addieren, bei jedem weiteren Neubeginn wieder, oder fortlaufende Zeiten exportieren"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::unit::MILLISECOND;

    fn bits(before: f64, time: f64) -> Option<String> {
        let of = |value: f64| Stamp { value, unit: &MILLISECOND };
        counter(of(before), of(time), Language::En)
    }

    /// Counters of 8, 16 and 32 bits with and without sign are named with their range, for steps of up to 1/50 of it.
    #[test]
    fn a_counter_that_starts_again_is_named() {
        for (wide, range) in [(8, 256.0), (16, 65_536.0), (32, 4_294_967_296.0)] {
            for low in [0.0, -0.5 * range] {
                for step in [1.0, 2.0, range / 64.0] {
                    for phase in [0.0, 1.0] {
                        let before = low + range - 1.0 - phase;
                        let text = bits(before, before + step - range).filter(|_| before + step >= low + range);
                        assert!(
                            step <= phase
                                || text.is_some_and(|text| {
                                    text.starts_with(&format!("apparently a counter of {wide} bits"))
                                        && text.contains(&format!("{range} ms"))
                                }),
                            "{wide} {low} {step} {phase}"
                        );
                    }
                }
            }
        }
        for (before, time) in [
            (0.02, 0.01),
            (1000.0, 0.0),
            (65_534.0, 40_000.0),
            (40_000.0, 0.0),
            (65_600.0, 10.0),
            (12.0, -3.0),
            (254.5, 0.5),
        ] {
            assert_eq!(bits(before, time), None, "{before} {time}");
        }
    }
}
