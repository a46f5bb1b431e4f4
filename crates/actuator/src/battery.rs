//! The battery that buffers the turns of the encoder M128S.

use provenance::{Grade, Source, Sourced};
use quantities::unit::{HOUR, YEAR};
use quantities::{Measure, Time};

/// Years that the battery gives when it is always on load and was never stored, times the load of a day.
const CAPACITY_A: f64 = 6.481;

/// Years of that capacity that one year of storage takes.
const STORAGE_SHARE: f64 = 1.065;

/// Self-discharge in shares of the load of a day.
const SELF_DISCHARGE: f64 = 0.065;

/// Years after delivery at which the encoder is to be replaced at the latest (cha-manual table 59.1, remark).
const LATEST_A: f64 = 10.0;

/// Years after which its replacement is recommended (cha-manual table 59.1).
const RECOMMENDED_A: f64 = 6.0;

/// Longest storage of the published diagram in years.
const STORAGE_MAX_A: f64 = 3.0;

/// How long the battery lasts, and the two rules of replacement. Both rules hold beside the model.
#[derive(Clone, Debug, PartialEq)]
pub struct BatteryLife {
    /// L: life in use after the storage, never longer than what is left of the ten years.
    pub life: Sourced<Time>,
    /// Interval after which replacing the encoder is recommended.
    pub exchange_recommended: Time,
    /// Time after delivery at which the encoder must be replaced at the latest.
    pub exchange_latest: Time,
    /// Whether the ten years end before the battery does.
    pub capped: bool,
}

/// Why the model gives no answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BatteryFault {
    /// A day has 0 h to 24 h of operation.
    OperationOutOfRange {
        /// Operation on a day.
        per_day: Time,
    },
    /// The model covers 0 a to 3 a of storage.
    StorageOutOfRange {
        /// Storage before use.
        storage: Time,
    },
}

impl std::fmt::Display for BatteryFault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::OperationOutOfRange { per_day } => {
                write!(f, "{} h of operation per day, possible are 0 h to 24 h", per_day.in_unit(&HOUR))
            }
            Self::StorageOutOfRange { storage } => {
                write!(f, "{} a of storage, the battery model covers 0 a to 3 a", storage.in_unit(&YEAR))
            }
        }
    }
}

impl std::error::Error for BatteryFault {}

/// Life of the buffer battery in use.
///
/// L = (6.481 − 1.065 s) / ((24 − h)/24 + 0.065), s + L ≤ 10
///
/// # Symbols  L life \[a\], h operation per day \[h\], s storage before use \[a\]
/// # Source   docs/theory/battery.md; calibrated on the printed 10 a at 10 h/d
/// # Valid    0 ≤ h ≤ 24, 0 ≤ s ≤ 3, battery at 25 °C, self-discharge 1 % per year
/// # Errors
/// [`BatteryFault`] outside these ranges.
pub fn battery_life(operation_per_day: Time, storage: Time) -> Result<BatteryLife, BatteryFault> {
    let (hours, stored) = (operation_per_day.in_unit(&HOUR), storage.in_unit(&YEAR));
    // Room for the rounding of a conversion, a billionth of the range.
    if !(-24e-9..=24.0 + 24e-9).contains(&hours) {
        return Err(BatteryFault::OperationOutOfRange { per_day: operation_per_day });
    }
    if !(-3e-9..=STORAGE_MAX_A + 3e-9).contains(&stored) {
        return Err(BatteryFault::StorageOutOfRange { storage });
    }
    let years = (CAPACITY_A - STORAGE_SHARE * stored) / ((24.0 - hours) / 24.0 + SELF_DISCHARGE);
    let left = LATEST_A - stored;
    Ok(BatteryLife {
        life: Sourced {
            value: Time::new_in(years.min(left), &YEAR),
            source: Source::Model { name: "battery" },
            grade: Grade::Estimated,
            errata: &[],
        },
        exchange_recommended: Time::new_in(RECOMMENDED_A, &YEAR),
        exchange_latest: Time::new_in(LATEST_A, &YEAR),
        capped: years > left,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn years(hours: f64, stored: f64) -> f64 {
        let life = battery_life(Time::new_in(hours, &HOUR), Time::new_in(stored, &YEAR)).unwrap();
        life.life.value.in_unit(&YEAR)
    }

    /// Always switched off: the recommended six years; 10 h a day: the printed ten; then years of storage.
    #[test]
    fn the_points_of_the_calibration() {
        for (hours, stored, expected) in
            [(0.0, 0.0, 6.1), (10.0, 0.0, 10.0), (10.0, 1.0, 8.4), (10.0, 2.0, 6.7), (10.0, 3.0, 5.1)]
        {
            assert!((years(hours, stored) - expected).abs() < 0.05, "{hours} {stored}: {}", years(hours, stored));
        }
    }

    #[test]
    fn storage_and_use_end_after_ten_years() {
        for stored in [0.0, 0.5, 3.0] {
            assert!((years(24.0, stored) + stored - 10.0).abs() < 1e-9);
        }
        let life = battery_life(Time::new_in(24.0, &HOUR), Time::new_in(0.0, &YEAR)).unwrap();
        assert!(life.capped);
        assert!((life.exchange_recommended.in_unit(&YEAR) - 6.0).abs() < 1e-12);
        assert!((life.exchange_latest.in_unit(&YEAR) - 10.0).abs() < 1e-12);
    }

    #[test]
    fn life_grows_with_use_and_falls_with_storage() {
        for step in 0..24 {
            let hours = f64::from(step);
            assert!(years(hours + 1.0, 1.0) >= years(hours, 1.0));
            assert!(years(hours, 1.5) < years(hours, 1.0));
        }
    }

    #[test]
    fn outside_the_diagram_there_is_no_answer() {
        let ask = |h, s| battery_life(Time::new_in(h, &HOUR), Time::new_in(s, &YEAR)).unwrap_err();
        assert_eq!(ask(25.0, 0.0).to_string(), "25 h of operation per day, possible are 0 h to 24 h");
        assert!(ask(8.0, 4.0).to_string().ends_with("the battery model covers 0 a to 3 a"));
        assert!(matches!(ask(f64::NAN, 0.0), BatteryFault::OperationOutOfRange { .. }));
        assert!(matches!(ask(-1.0, 0.0), BatteryFault::OperationOutOfRange { .. }));
    }
}
