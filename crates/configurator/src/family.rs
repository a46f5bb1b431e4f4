//! Data common to a product family: calibrations of the models, thresholds of the supervision, the battery of an
//! encoder.

use crate::cells::{feedback_cell, number_of, quantity_of};
use actuator::{Battery, Parameters};
use catalogue::{Cell, ManualTable, SeriesData};
use order_code::{Feedback, FeedbackKind, OrderCode, Series};
use provenance::{CellRef, Datum, Grade, Source, Sourced};
use quantities::unit::DEGREE;
use quantities::{Angle, Measure, Ratio, ThermodynamicTemperature, Time};
use std::sync::LazyLock;

/// Location of the winding temperature thresholds of each series.
static THRESHOLDS: LazyLock<Vec<CellRef>> = LazyLock::new(|| places("T_KTY", |data| data.thresholds));

/// Returns the row of a table for each series, cited without its column.
pub(crate) fn places(symbol: &'static str, table: impl Fn(&SeriesData) -> &'static str) -> Vec<CellRef> {
    let place =
        |data: &SeriesData| CellRef { document: data.manual, ..CellRef::of_the_manual(table(data), symbol, "") };
    catalogue::series().iter().map(place).collect()
}

/// Returns the cell of a calibration: that of the drive, else that of its size without the feedback, else the one
/// common to all.
fn cell(series: Series, drive: &str, symbol: &str) -> Option<&'static Cell> {
    let cells = catalogue::table_cells(SeriesData::of(series).family);
    let of = |drive: &str| cells.iter().find(|cell| cell.place.symbol == symbol && cell.place.drive == drive);
    let size = drive.rsplit_once('-').map_or(drive, |(size, _)| size);
    of(drive).or_else(|| of(size)).or_else(|| of(""))
}

/// Cites a value from a table outside the manual by its cell: a published value, or a calibration by antrieb, which is
/// an estimate.
pub(crate) fn published_as<T>(grade: Grade, datum: Datum<T>) -> Datum<T> {
    datum.map(|known| {
        let source = match known.source {
            Source::Cell(cell) => Source::Published(cell),
            other => other,
        };
        Sourced { source, grade, ..known }
    })
}

/// Returns a pure number of a drive \[1\].
pub(crate) fn number(series: Series, drive: &str, symbol: &str) -> Datum<f64> {
    published_as(Grade::Estimated, number_of(cell(series, drive, symbol)))
}

/// Returns a quantity of a drive.
pub(crate) fn quantity<Q: Measure>(series: Series, drive: &str, symbol: &str) -> Datum<Q> {
    published_as(Grade::Estimated, quantity_of(cell(series, drive, symbol)))
}

/// Returns a band of a drive from its two edges.
pub(crate) fn band(series: Series, drive: &str, low: &str, high: &str) -> Datum<(f64, f64)> {
    match (number(series, drive, low), number(series, drive, high)) {
        (Datum::Known(low), Datum::Known(high)) => {
            let high = high.value;
            Datum::Known(low.map(|low| (low, high)))
        }
        _ => Datum::NotPrinted,
    }
}

/// Returns the growth of friction below +20 °C \[1/K\], lower and upper edge.
pub(crate) fn cold_growth(series: Series) -> Datum<(f64, f64)> {
    band(series, "", "cold_growth_low", "cold_growth_high")
}

/// Returns the largest J_L/J_out recommended for highly dynamic duty \[1\], from a cell such as `≤ 3J_out`.
pub(crate) fn inertia_ratio_recommended(series: Series) -> Datum<f64> {
    let cells = catalogue::table_cells(SeriesData::of(series).preselection);
    let factor = |cell: &'static Cell| {
        let (factor, _) = cell.corrected.strip_prefix('≤')?.split_once("J_out")?;
        Some(cell.sourced(quantities::parse_german(factor.trim())?))
    };
    Datum::of(cells.iter().filter(|cell| cell.place.symbol == "J_L").find_map(factor))
}

/// Returns the swing angle below which the output bearing may fret, from a fact of the series.
pub(crate) fn swing_min(series: Series) -> Datum<Angle> {
    let fact = catalogue::fact("fretting_below_5_deg").filter(|fact| fact.holds_for.series == series);
    Datum::of(fact.and_then(|fact| {
        let value = Angle::new_in(fact.values.first()?.number, &DEGREE);
        let source = Source::Model { name: "output-bearing" };
        Some(Sourced { value, source, grade: fact.grade, errata: &[] })
    }))
}

/// Returns f_s, the static safety on which the M_0(max) of a size is based (table 55.1, footnote 3), from a fact of the
/// series.
pub(crate) fn static_safety_min(code: &OrderCode) -> Datum<f64> {
    let fact = catalogue::fact("static_safety_of_the_table").filter(|fact| fact.holds_for.series == code.series());
    let class = if code.size.number() <= LAST_SMALL { "sizes_14_to_20" } else { "sizes_25_to_58" };
    let found = || {
        let value = fact?.values.iter().find(|value| value.id == class)?.number;
        let cell = catalogue::size_cell(code.size, code.ratio, "M_0_max")?;
        Some(Sourced { grade: fact?.grade, errata: &[], ..cell.sourced(value) })
    };
    Datum::of(found())
}

/// Largest size of the first class of f_s.
const LAST_SMALL: u16 = 20;

/// Returns a threshold of the winding temperature: `warning` or `shutdown`.
pub(crate) fn winding_threshold(series: Series, which: &str) -> Datum<ThermodynamicTemperature> {
    let cells = catalogue::table_cells(SeriesData::of(series).thresholds);
    let found = cells.iter().find(|cell| cell.place.condition == which).map(catalogue::datum_of);
    match (found, THRESHOLDS.get(series.place())) {
        (Some(Datum::Known(known)), Some(place)) => Datum::Known(Sourced { source: Source::Cell(place), ..known }),
        _ => Datum::NotPrinted,
    }
}

/// Returns T_NAT, the response temperature of the winding PTC, by size.
///
/// `NotApplicable` if the motor connector has no contacts for the PTC.
pub(crate) fn ptc_response(code: &OrderCode) -> Datum<ThermodynamicTemperature> {
    match ptc_cell(code) {
        _ if !catalogue::winding_data(code.winding).is_some_and(|data| data.ptc) => Datum::NotApplicable,
        Some(cell) => catalogue::datum_of(cell),
        None => Datum::NotPrinted,
    }
}

/// Returns the cell of the response temperature T_NAT of the PTC of a size.
#[must_use]
pub fn ptc_cell(code: &OrderCode) -> Option<&'static Cell> {
    // Cached: called for every actuator at program start.
    static CELLS: LazyLock<Vec<&'static Cell>> =
        LazyLock::new(|| catalogue::cells().filter(|cell| cell.place.symbol == "T_NAT").collect());
    let head = format!("{}-{}", code.series().as_str(), code.size);
    CELLS.iter().copied().find(|cell| cell.place.drive.split(" / ").any(|drive| drive == head))
}

/// Returns the parameters of another manufacturer's actuator whose file states no value: the data of the family that
/// apply to any strain wave actuator, graded as assumptions.
pub(crate) fn own_actuator() -> Parameters {
    fn assume<T>(datum: Datum<T>) -> Datum<T> {
        datum.map(|known| Sourced { grade: Grade::Assumed, ..known })
    }
    let series = Series::default();
    let mut parameters = Parameters::unknown();
    // The growth of friction at low temperature is a property of the grease of strain wave gears.
    parameters.friction_cold_growth = assume(cold_growth(series));
    parameters.friction_printed_from = assume(quantity(series, "", "friction_printed_from"));
    parameters.inertia_ratio_recommended = assume(inertia_ratio_recommended(series));
    parameters.heat.winding_shutdown = assume(winding_threshold(series, "shutdown"));
    parameters.output_bearing.swing_min = assume(swing_min(series));
    parameters
}

/// Returns t_c and t_o, the longest closing and opening times of all brakes in the manual.
pub(crate) fn brake_times() -> Option<(Time, Time)> {
    let printed = |symbol: &str| {
        let cells = catalogue::tables().iter().filter(|table| table.is_of_the_manual()).flat_map(ManualTable::cells);
        let times = cells.filter(|cell| cell.place.symbol == symbol).map(catalogue::datum_of::<Time>);
        times.filter_map(|time| Some(time.known()?.value)).max_by(|a, b| a.si().total_cmp(&b.si()))
    };
    Some((printed("t_c")?, printed("t_o")?))
}

/// Returns the battery of the first encoder with a battery in the default series.
#[must_use]
pub fn battery() -> Datum<Battery> {
    let buffered = Feedback::all(Series::default()).find(|each| each.kind() == Some(FeedbackKind::SsiMultiturn));
    buffered.map_or(Datum::NotPrinted, battery_of)
}

/// Returns the battery of an encoder.
pub(crate) fn battery_of(feedback: Feedback) -> Datum<Battery> {
    let series = feedback.series();
    let time = |symbol| quantity::<Time>(series, "", symbol);
    let share = |symbol| number(series, "", symbol);
    let recommended =
        feedback_cell(series, feedback.as_str(), "encoder_exchange_interval").map(catalogue::datum_of::<Time>);
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
    Datum::of(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::unit::{DEGREE_CELSIUS, YEAR};

    #[test]
    fn thresholds_times_and_battery_are_read() {
        let celsius =
            |which| winding_threshold(Series::default(), which).known().unwrap().value.in_unit(&DEGREE_CELSIUS);
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

    /// The growth follows from the no-load starting currents of the 48 V windings in the manual: ln(I_cold/I_20)/ΔT
    /// over all ratios.
    #[test]
    fn the_growth_in_the_cold_is_that_of_the_print() {
        let growth = cold_growth(Series::default()).known().unwrap().value;
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
