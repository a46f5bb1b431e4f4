//! Temperature sensors: resistance of the KTY as a function of temperature, and corner points of the PTC.

use catalogue::Cell;
use quantities::unit::DEGREE_CELSIUS;
use quantities::{ElectricalResistance, Measure, ThermodynamicTemperature};

/// Range of the closed form \[°C\]; widened by a nanokelvin for unit conversions.
const RANGE_CELSIUS: std::ops::RangeInclusive<f64> = -40.000_000_001..=250.000_000_001;

/// Returns the resistance of a KTY 84-130.
///
/// R = 1000 (1 + 6.12e-3 (ϑ − 100) + 1.1e-5 (ϑ − 100)²)
///
/// # Symbols
/// ϑ temperature \[°C\], R \[Ω\]
/// # Source
/// nxp-kty84: 1000 Ω at 100 °C; the constants agree with the table kty84-130 within 0.7 Ω
/// # Valid
/// −40 °C to 250 °C, `None` outside
#[must_use]
pub fn kty_resistance(temperature: ThermodynamicTemperature) -> Option<ElectricalResistance> {
    let celsius = temperature.in_unit(&DEGREE_CELSIUS);
    let from_100 = celsius - 100.0;
    let ohm = 1000.0 * (1.0 + 6.12e-3 * from_100 + 1.1e-5 * from_100 * from_100);
    RANGE_CELSIUS.contains(&celsius).then(|| ElectricalResistance::from_si(ohm))
}

/// Returns the temperature of a KTY 84-130 with a resistance: the inverse of [`kty_resistance`].
///
/// # Valid
/// −40 °C to 250 °C, `None` outside
#[must_use]
pub fn kty_temperature(resistance: ElectricalResistance) -> Option<ThermodynamicTemperature> {
    let (linear, square) = (6.12e-3, 1.1e-5);
    let root = linear * linear - 4.0 * square * (1.0 - resistance.si() / 1000.0);
    let celsius = 100.0 + (root.max(0.0).sqrt() - linear) / (2.0 * square);
    (root >= 0.0 && RANGE_CELSIUS.contains(&celsius))
        .then(|| ThermodynamicTemperature::new_in(celsius, &DEGREE_CELSIUS))
}

/// Returns the smallest and the largest resistance of a KTY 84-130 in its data sheet.
///
/// R(ϑ) + d(ϑ), d by linear interpolation between two temperatures of the data sheet
///
/// # Symbols
/// R see [`kty_resistance`], d distance of the bound of the data sheet from it \[Ω\]
/// # Source
/// nxp-kty84, table kty84-130: 340 to 379 Ω at −40 °C, 577 to 629 Ω at 25 °C, 970 to 1030 Ω at 100 °C, 2046 to 2286 Ω at 250 °C
/// # Valid
/// −40 °C to 250 °C, `None` outside
#[must_use]
pub fn kty_band(temperature: ThermodynamicTemperature) -> Option<[ElectricalResistance; 2]> {
    let middle = kty_resistance(temperature)?.si();
    let celsius = temperature.in_unit(&DEGREE_CELSIUS);
    let bound = |which: &str| {
        let distance = |cell: &Cell| {
            let at = cell_celsius(cell)?;
            let there = kty_resistance(ThermodynamicTemperature::new_in(at, &DEGREE_CELSIUS))?.si();
            Some((at, cell.limit().number()? - there))
        };
        let mut points = kty_cells(which).filter_map(distance).peekable();
        let mut before = *points.peek()?;
        let after = points.find(|point| {
            let is_after = point.0 >= celsius;
            before = if is_after { before } else { *point };
            is_after
        });
        let (from, to) = (before, after.unwrap_or(before));
        let share = if to.0 > from.0 { (celsius - from.0) / (to.0 - from.0) } else { 0.0 };
        Some(ElectricalResistance::from_si(middle + from.1 + share * (to.1 - from.1)))
    };
    Some([bound("least")?, bound("largest")?])
}

/// Iterates over the cells of a row of the table kty84-130 in the order of their temperatures.
fn kty_cells(which: &str) -> impl Iterator<Item = &'static Cell> {
    catalogue::table_cells("kty84-130").iter().filter(move |cell| cell.place.condition.starts_with(which))
}

/// Returns the cell of the table kty84-130 nearest to a temperature.
#[must_use]
pub fn kty_cell(temperature: ThermodynamicTemperature) -> Option<&'static Cell> {
    let celsius = temperature.in_unit(&DEGREE_CELSIUS);
    let away = |cell: &&Cell| cell_celsius(cell).map_or(f64::INFINITY, |at| (at - celsius).abs());
    kty_cells("typical").min_by(|one, other| away(one).total_cmp(&away(other)))
}

/// Returns the temperature of a cell of the table \[°C\]: `typical, 80 degC`.
fn cell_celsius(cell: &Cell) -> Option<f64> {
    cell.place.condition.split([' ', ',']).find_map(|part| part.parse().ok())
}

/// Returns the bounds of a single PTC (DIN 44081) from the table: up to T_NAT − 20 K, at −5 K, +5 K, +15 K.
#[must_use]
pub fn ptc_bounds() -> Vec<&'static Cell> {
    let cells = catalogue::table_cells("ptc-din44081").iter();
    cells.filter(|cell| cell.place.symbol == "R_PTC" && cell.place.condition.starts_with("single")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(celsius: f64) -> ThermodynamicTemperature {
        ThermodynamicTemperature::new_in(celsius, &DEGREE_CELSIUS)
    }

    /// nxp-kty84 as listed in kty-c-lib: the two thresholds of the manual, and the corners.
    #[test]
    fn the_closed_form_meets_the_data_sheet() {
        let printed = [
            (-40.0, 359.0),
            (0.0, 498.0),
            (20.0, 581.0),
            (25.0, 603.0),
            (80.0, 882.0),
            (90.0, 940.0),
            (100.0, 1000.0),
            (160.0, 1407.0),
            (250.0, 2166.0),
        ];
        for (celsius, ohm) in printed {
            let found = kty_resistance(at(celsius)).unwrap().si();
            assert!((found - ohm).abs() < 0.75, "{celsius} degC: {found}");
            let back = kty_temperature(ElectricalResistance::from_si(found)).unwrap();
            assert!((back.in_unit(&DEGREE_CELSIUS) - celsius).abs() < 1e-9);
        }
        assert!(kty_resistance(at(251.0)).is_none() && kty_temperature(ElectricalResistance::from_si(10.0)).is_none());
    }

    #[test]
    fn the_closed_form_lies_within_one_ohm_of_every_cell_of_the_table() {
        let mut count = 0;
        for cell in kty_cells("typical") {
            let celsius = cell_celsius(cell).unwrap_or(f64::NAN);
            assert_eq!(kty_cell(at(celsius)), Some(cell));
            if celsius <= 250.0 {
                let found = kty_resistance(at(celsius)).unwrap().si();
                assert!((found - cell.value.number().unwrap()).abs() <= 1.0, "{celsius}: {found}");
                count += 1;
            }
        }
        assert_eq!(count, 31);
    }

    #[test]
    fn the_ptc_responds_at_120_or_145_degrees() {
        let of = |code: &str| {
            let code = order_code::parse(code).unwrap().code;
            configurator::ptc_cell(&code).and_then(|cell| cell.value.number())
        };
        assert_eq!(of("CHA-17A-50-E-RES"), Some(120.0));
        assert_eq!(of("CHA-20A-50-H-C1024"), Some(145.0));
        assert_eq!(ptc_bounds().len(), 4);
    }
}
