//! What holds for the whole family: calibrations of the models, thresholds of the supervision, the battery of an encoder.

use crate::parts;
use actuator::Battery;
use catalogue::{Cell, Table};
use provenance::{CellRef, Datum, Grade, Source, Sourced};
use quantities::{Measure, Ratio, ThermodynamicTemperature, Time};

/// Where the thresholds of the winding temperature stand.
const THRESHOLDS: CellRef = CellRef::of_the_manual("62.3", "T_KTY", "");

/// A calibration headed by a drive, by its size without the feedback, or once for all.
fn cell(drive: &str, symbol: &str) -> Option<&'static Cell> {
    let cells = catalogue::table("family").map(Table::cells).unwrap_or_default();
    let of = |drive: &str| cells.iter().find(|cell| cell.place.symbol == symbol && cell.place.drive == drive);
    let size = drive.rsplit_once('-').map_or(drive, |(size, _)| size);
    of(drive).or_else(|| of(size)).or_else(|| of(""))
}

/// A calibration is ours: an estimate, cited by its cell.
fn estimated<T>(datum: Datum<T>) -> Datum<T> {
    match datum {
        Datum::Known(known) => {
            let source = match known.source {
                Source::Cell(cell) => Source::Published(cell),
                other => other,
            };
            Datum::Known(Sourced { source, grade: Grade::Estimated, ..known })
        }
        unknown => unknown,
    }
}

/// A pure number of a drive.
pub(crate) fn number(drive: &str, symbol: &str) -> Datum<f64> {
    estimated(parts::number_of(cell(drive, symbol)))
}

/// A quantity of a drive.
pub(crate) fn quantity<Q: Measure>(drive: &str, symbol: &str) -> Datum<Q> {
    estimated(cell(drive, symbol).map_or(Datum::NotPrinted, catalogue::datum_of))
}

/// A band of a drive by its two edges.
pub(crate) fn band(drive: &str, low: &str, high: &str) -> Datum<(f64, f64)> {
    match (number(drive, low), number(drive, high)) {
        (Datum::Known(low), Datum::Known(high)) => {
            let high = high.value;
            Datum::Known(low.map(|low| (low, high)))
        }
        _ => Datum::NotPrinted,
    }
}

/// Growth of friction below +20 °C per kelvin, least and largest.
pub(crate) fn cold_growth() -> Datum<(f64, f64)> {
    band("", "cold_growth_low", "cold_growth_high")
}

/// A threshold of the winding temperature: `warning` or `shutdown`.
pub(crate) fn winding_threshold(which: &str) -> Datum<ThermodynamicTemperature> {
    let cells = catalogue::table("62.3").map(Table::cells).unwrap_or_default();
    match cells.iter().find(|cell| cell.place.condition == which).map(catalogue::datum_of) {
        Some(Datum::Known(known)) => Datum::Known(Sourced { source: Source::Cell(&THRESHOLDS), ..known }),
        _ => Datum::NotPrinted,
    }
}

/// What another maker's actuator is taken to have where its owner does not say: each an assumption.
#[derive(Clone, Debug, PartialEq)]
pub struct Assumed {
    /// Growth of friction in the cold, a property of the grease of such gears.
    pub friction_cold_growth: Datum<(f64, f64)>,
    /// Winding temperature at which the voltage is checked.
    pub winding_shutdown: Datum<ThermodynamicTemperature>,
}

/// What of the family holds for any strain wave actuator, with no more trust than an assumption deserves.
#[must_use]
pub fn assumed() -> Assumed {
    fn assume<T>(datum: Datum<T>) -> Datum<T> {
        match datum {
            Datum::Known(known) => Datum::Known(Sourced { grade: Grade::Assumed, ..known }),
            unknown => unknown,
        }
    }
    Assumed { friction_cold_growth: assume(cold_growth()), winding_shutdown: assume(winding_threshold("shutdown")) }
}

/// t_c and t_o, the same for every brake that they are printed for.
#[must_use]
pub fn brake_times() -> Option<(Time, Time)> {
    let printed = |symbol: &str| {
        let cells = catalogue::tables().iter().filter(|table| table.is_of_the_manual()).flat_map(Table::cells);
        let times = cells.filter(|cell| cell.place.symbol == symbol).map(catalogue::datum_of::<Time>);
        times.filter_map(|time| Some(time.known()?.value)).next()
    };
    Some((printed("t_c")?, printed("t_o")?))
}

/// The battery of the encoder M128S.
#[must_use]
pub fn battery() -> Datum<Battery> {
    let time = |symbol| quantity::<Time>("", symbol);
    let share = |symbol| number("", symbol);
    let recommended = parts::feedback_cell("M128S", "encoder_exchange_interval").map(catalogue::datum_of::<Time>);
    let found = (|| {
        let capacity = time("battery_capacity");
        let capacity = capacity.known()?;
        let value = Battery {
            capacity: capacity.value,
            storage_load: Ratio::from_si(share("battery_storage_load").known()?.value),
            self_discharge: Ratio::from_si(share("battery_self_discharge").known()?.value),
            storage_max: time("battery_storage_max").known()?.value,
            exchange_recommended: recommended.as_ref()?.known()?.value,
            exchange_latest: time("encoder_exchange_latest").known()?.value,
        };
        Some(capacity.clone().map(|_| value))
    })();
    found.map_or(Datum::NotPrinted, Datum::Known)
}

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::unit::{DEGREE_CELSIUS, YEAR};

    #[test]
    fn thresholds_times_and_battery_are_read() {
        let celsius = |which| winding_threshold(which).known().unwrap().value.in_unit(&DEGREE_CELSIUS);
        assert!((celsius("warning") - 80.0).abs() < 1e-9 && (celsius("shutdown") - 90.0).abs() < 1e-9);
        let (closing, opening) = brake_times().unwrap();
        assert!((closing.si() - 0.07).abs() < 1e-12 && (opening.si() - 0.11).abs() < 1e-12);
        let battery = battery();
        let battery = battery.known().unwrap();
        assert!((battery.value.exchange_recommended.in_unit(&YEAR) - 6.0).abs() < 1e-12);
        assert!((battery.value.exchange_latest.in_unit(&YEAR) - 10.0).abs() < 1e-12);
        assert_eq!(battery.grade, Grade::Estimated);
        let Source::Published(cell) = battery.source else { panic!("{:?}", battery.source) };
        assert_eq!((cell.document, cell.table), ("antrieb-models", "family"));
    }

    /// The growth is that of the printed starting currents of the 48 V windings: ln(I_cold/I_20)/ΔT over all ratios.
    #[test]
    fn the_growth_in_the_cold_is_that_of_the_print() {
        let growth = cold_growth().known().unwrap().value;
        let mut found = Vec::new();
        for table in ["14.1", "20.1"] {
            let cells = catalogue::table(table).unwrap().cells();
            let at = |condition: &str, ratio: &str| {
                let cell = cells.iter().find(|cell| {
                    cell.place.symbol == "I_NLS" && cell.place.condition == condition && cell.place.ratio == ratio
                });
                cell.and_then(|cell| cell.value.number())
            };
            for cell in cells.iter().filter(|cell| cell.place.symbol == "I_NLS") {
                let Some(celsius) = cell.place.condition.strip_suffix(" degC").and_then(|t| t.parse::<f64>().ok())
                else {
                    continue;
                };
                if let (Some(cold), Some(warm)) = (cell.value.number(), at("20 degC", cell.place.ratio))
                    && celsius < 20.0
                {
                    found.push((cold / warm).ln() / (20.0 - celsius));
                }
            }
        }
        let (low, high) = found.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), g| (a.min(*g), b.max(*g)));
        assert_eq!(found.len(), 9, "{found:?}");
        assert!((low - growth.0).abs() < 1e-3 && (high - growth.1).abs() < 1e-3, "{low} {high}");
    }
}
