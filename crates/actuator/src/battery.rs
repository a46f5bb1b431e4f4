//! Battery that buffers the turns of an encoder.

use provenance::{Grade, Source, Sourced};
use quantities::unit::{HOUR, YEAR};
use quantities::{Measure, Ratio, Time};

/// Battery of an encoder: model of its load, and the replacement rules of the manufacturer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Battery {
    /// C: life under permanent load without storage.
    pub capacity: Time,
    /// Load during storage relative to that in a machine that is always off \[1\].
    pub storage_load: Ratio,
    /// Self-discharge relative to the load in a machine that is always off \[1\].
    pub self_discharge: Ratio,
    /// Longest storage covered by the model.
    pub storage_max: Time,
    /// Recommended replacement interval of the encoder.
    pub exchange_recommended: Time,
    /// Latest replacement of the encoder after delivery.
    pub exchange_latest: Time,
}

/// Battery life, and the two replacement rules, which apply in addition to the model.
#[derive(Clone, Debug, PartialEq)]
pub struct BatteryLife {
    /// h: operation per day.
    pub per_day: Time,
    /// s: storage before use.
    pub storage: Time,
    /// L: life in use after storage, limited by the remainder of the ten years.
    pub life: Sourced<Time>,
    /// Recommended replacement interval of the encoder.
    pub exchange_recommended: Time,
    /// Latest replacement of the encoder after delivery.
    pub exchange_latest: Time,
    /// The ten years end before the life of the battery.
    pub capped: bool,
}

/// Input outside the range of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BatteryFault {
    /// The operation per day is not between 0 h and 24 h.
    OperationOutOfRange {
        /// Operation per day.
        per_day: Time,
    },
    /// The storage is outside the range of the model, 0 a to 3 a.
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

impl Battery {
    /// Returns the life of the buffer battery in use.
    ///
    /// L = (C − c s)/((24 − h)/24 + d), s + L ≤ L_max
    ///
    /// # Symbols
    /// L life \[a\], h operation per day \[h\], s storage before use \[a\], C capacity \[a\], c load of storage,
    /// d self-discharge, L_max latest replacement \[a\]
    /// # Source
    /// docs/theory/battery.md; calibrated to the 10 a at 10 h/d of the manual
    /// # Valid
    /// 0 ≤ h ≤ 24, s up to the longest storage covered, battery at 25 °C, self-discharge 1 % per year
    /// # Errors
    /// [`BatteryFault`] outside these ranges.
    pub fn life(&self, operation_per_day: Time, storage: Time) -> Result<BatteryLife, BatteryFault> {
        let (hours, stored) = (operation_per_day.in_unit(&HOUR), storage.in_unit(&YEAR));
        // Tolerance for the rounding of a conversion: a billionth of the range.
        if !(-24e-9..=24.0 + 24e-9).contains(&hours) {
            return Err(BatteryFault::OperationOutOfRange { per_day: operation_per_day });
        }
        if !(-3e-9..=self.storage_max.in_unit(&YEAR) + 3e-9).contains(&stored) {
            return Err(BatteryFault::StorageOutOfRange { storage });
        }
        let left_of_it = self.capacity.in_unit(&YEAR) - self.storage_load.si() * stored;
        let years = left_of_it / ((24.0 - hours) / 24.0 + self.self_discharge.si());
        let left = self.exchange_latest.in_unit(&YEAR) - stored;
        Ok(BatteryLife {
            per_day: operation_per_day,
            storage,
            life: Sourced {
                value: Time::new_in(years.min(left), &YEAR),
                source: Source::Model { name: "battery" },
                grade: Grade::Estimated,
                errata: &[],
            },
            exchange_recommended: self.exchange_recommended,
            exchange_latest: self.exchange_latest,
            capped: years > left,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn battery() -> Battery {
        Battery {
            capacity: Time::new_in(6.481, &YEAR),
            storage_load: Ratio::from_si(1.065),
            self_discharge: Ratio::from_si(0.065),
            storage_max: Time::new_in(3.0, &YEAR),
            exchange_recommended: Time::new_in(6.0, &YEAR),
            exchange_latest: Time::new_in(10.0, &YEAR),
        }
    }

    fn years(hours: f64, stored: f64) -> f64 {
        let life = battery().life(Time::new_in(hours, &HOUR), Time::new_in(stored, &YEAR)).unwrap();
        life.life.value.in_unit(&YEAR)
    }

    /// Always off: the recommended six years; 10 h per day: the ten years of the manual; then years of storage.
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
        let life = battery().life(Time::new_in(24.0, &HOUR), Time::new_in(0.0, &YEAR)).unwrap();
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
        let ask = |h, s| battery().life(Time::new_in(h, &HOUR), Time::new_in(s, &YEAR)).unwrap_err();
        assert_eq!(ask(25.0, 0.0).to_string(), "25 h of operation per day, possible are 0 h to 24 h");
        assert!(ask(8.0, 4.0).to_string().ends_with("the battery model covers 0 a to 3 a"));
        assert!(matches!(ask(f64::NAN, 0.0), BatteryFault::OperationOutOfRange { .. }));
        assert!(matches!(ask(-1.0, 0.0), BatteryFault::OperationOutOfRange { .. }));
    }
}
