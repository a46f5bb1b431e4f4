//! Every constant that the physics holds in code stands in a table of the data, and is the same there.
#![allow(clippy::unwrap_used, reason = "a test fails loudly")]

use actuator::{BearingType, FlangeLoad, LifeLaw, Parameters};
use catalogue::Value;
use provenance::Datum;
use quantities::unit::{DEGREE_CELSIUS, HOUR};
use quantities::{AngularVelocity, Force, Length, Measure, ThermodynamicTemperature, Torque};
use sizing::OperatingCondition;

/// Constants of CHA-20A-50; what is looked at here is the same for every code.
fn parameters() -> Parameters {
    let code = order_code::parse("CHA-20A-50-H-M512P").unwrap().code;
    configurator::parameters(&code).unwrap()
}

/// The cell of a table with this symbol whose condition begins like this.
fn cell(table: &str, symbol: &str, condition: &str) -> &'static catalogue::Cell {
    let cells = catalogue::table(table).unwrap().cells();
    cells.iter().find(|cell| cell.place.symbol == symbol && cell.place.condition.contains(condition)).unwrap()
}

fn number(table: &str, symbol: &str, condition: &str) -> f64 {
    cell(table, symbol, condition).value.number().unwrap()
}

#[test]
fn life_exponents_of_table_74_5() {
    assert_eq!(cell("74.5", "B", "bearing_type=C").corrected, "10/3");
    assert!((BearingType::CrossedRoller.life_exponent() - 10.0 / 3.0).abs() < 1e-15);
    assert!((BearingType::FourPoint.life_exponent() - number("74.5", "B", "bearing_type=F")).abs() < 1e-15);
}

#[test]
fn load_factors_of_table_75_4() {
    let load = |radial: f64, axial: f64| {
        let load = FlangeLoad {
            radial_force: Force::from_si(radial),
            radial_distance: Length::from_si(0.0),
            axial_force: Force::from_si(axial),
            axial_distance: Length::from_si(0.0),
        };
        actuator::dynamic_equivalent_load(&load, Torque::from_si(0.0), Length::from_si(1.0)).si()
    };
    for (radial, axial, range) in [(1000.0, 1000.0, "≤ 1,5"), (100.0, 1000.0, "> 1,5")] {
        let expected = number("75.4", "x", range) * radial + number("75.4", "y", range) * axial;
        assert!((load(radial, axial) - expected).abs() < 1e-9, "{range}");
    }
}

#[test]
fn static_safeties_of_table_76_3() {
    for (condition, text) in [
        (OperatingCondition::Normal, "normal"),
        (OperatingCondition::Shock, "vibration or shock"),
        (OperatingCondition::HighAccuracy, "high transmission accuracy"),
    ] {
        assert!((condition.static_safety_min() - number("76.3", "f_s", text)).abs() < 1e-15);
    }
}

/// Table 70.1 recommends J_L ≤ 3 J_out; tables 13.1 and 13.2 print 0 … 40 °C; table 62.3 warns at 80 °C.
#[test]
fn recommendation_and_temperatures() {
    assert!(cell("70.1", "J_L", "limit").corrected.starts_with("≤ 3"));
    for table in ["13.1", "13.2"] {
        let value = cell(table, "ambient_temperature_operation", "").value;
        assert_eq!(value, Value::Range { low: 0.0, high: 40.0 });
    }
    let heat = parameters().heat.clone();
    let celsius = |datum: &Datum<ThermodynamicTemperature>| datum.known().unwrap().value.in_unit(&DEGREE_CELSIUS);
    for (found, condition) in [(&heat.winding_warning, "warning"), (&heat.winding_shutdown, "shutdown")] {
        let cells = catalogue::table("62.3").unwrap().cells();
        let printed = cells.iter().find(|cell| cell.place.condition == condition).unwrap();
        assert!((celsius(found) - printed.value.number().unwrap()).abs() < 1e-9, "{condition}");
    }
    assert!((celsius(&heat.ambient_reference) - 40.0).abs() < 1e-9);
}

/// L_10 at T_N and n_N is L_n / 5 of the table gear-life.
#[test]
fn constants_of_the_gear_life() {
    let speed = AngularVelocity::from_si(number("gear-life", "n_N_gear", "") * std::f64::consts::TAU / 60.0);
    let law = LifeLaw::of(&parameters().gear).unwrap();
    let life = law.l10(Torque::from_si(1.0), Torque::from_si(1.0), speed).in_unit(&HOUR);
    let expected = number("gear-life", "L_n", "CPU") / number("gear-life", "life_ratio_50_10", "");
    assert!((life - expected).abs() < 1e-6, "{life} {expected}");
}

/// Every brake whose times are printed closes in 70 ms and opens in 110 ms, and has its number of brakings.
#[test]
fn times_of_the_brake() {
    let mut printed = 0;
    let (closing, opening) = configurator::Catalogue::cha().brake_times().unwrap();
    assert!((closing.si() - 0.07).abs() < 1e-12 && (opening.si() - 0.11).abs() < 1e-12);
    for (symbol, expected) in [("t_c", closing.si()), ("t_o", opening.si())] {
        let tables = catalogue::tables().iter().flat_map(catalogue::ManualTable::cells);
        for cell in tables.filter(|cell| cell.place.symbol == symbol) {
            let Some(value) = cell.value.number() else { continue };
            assert!((value / 1000.0 - expected).abs() < 1e-12, "{:?}", cell.place);
            printed += 1;
        }
    }
    assert!(printed >= 22, "{printed}");
}

/// The static equivalent load is that of equation 76.1 with its two factors.
#[test]
fn load_factors_of_equation_76_1() {
    let (x_0, y_0) = (number("equation-76.1", "x_0", ""), number("equation-76.1", "y_0", ""));
    for (radial, axial, moment) in [(1000.0, 0.0, 0.0), (0.0, 1000.0, 0.0), (300.0, 700.0, 20.0)] {
        let load = FlangeLoad {
            radial_force: Force::from_si(radial),
            radial_distance: Length::from_si(0.0),
            axial_force: Force::from_si(axial),
            axial_distance: Length::from_si(0.0),
        };
        let (diameter, rating) = (Length::from_si(0.07), Force::from_si(31_000.0));
        let found = actuator::static_safety(rating, &load, Torque::from_si(moment), diameter);
        let expected = 31_000.0 / (x_0 * (radial + 2.0 * moment / 0.07) + y_0 * axial);
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    }
}
