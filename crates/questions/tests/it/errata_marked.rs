//! A value that is not the printed one carries its erratum, wherever a comparison or a mounting shows it; an erratum that is shown
//! concerns the code.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may fail")]

use answers::{Mount, MountValue, TableCell};
use order_code::OrderCode;
use quantities::{Language, Unit, parse_german};
use questions::answer;
use questions::list::compare::compare;
use questions::list::mount::{MountInputs, mount};
use questions::{Progress, read};

const AXIS: &str = "format = 1\n[load]\ninertia = \"0.05 kg m^2\"\n[[motion]]\nlaw = \"manual\"\nspeed = \"20 1/min\"\n\
    accelerate = \"0.2 s\"\nrun = \"0.5 s\"\nbrake = \"0.2 s\"\npause = \"0.5 s\"\n";

fn codes() -> Vec<OrderCode> {
    crate::catalogue_actuators().map(|(code, _)| *code).collect()
}

/// The numbers that the tables print for a symbol of a code, without errata, in a unit.
fn printed(code: &OrderCode, symbol: &str, unit: &str) -> Vec<f64> {
    let braked = format!("{symbol}_brake");
    let is_braked = code.brake != order_code::Brake::Without;
    let cells = catalogue::cells_about(code.size, code.winding, code.feedback, code.ratio);
    let has_braked = cells.iter().any(|cell| cell.place.symbol == braked);
    let wanted = if is_braked && has_braked { braked.as_str() } else { symbol };
    let of = |cell: &&&catalogue::Cell| cell.place.symbol == wanted;
    let in_unit = |cell: &&catalogue::Cell| {
        let text = cell.printed.trim_start_matches(['<', '≤', '≥', '>', '±', ' ']);
        let number = parse_german(text)?;
        let dimension = Unit::of(unit)?.dimension;
        Some(Unit::of(unit)?.from_si(Unit::of_dimension(dimension, cell.unit)?.to_si(number)))
    };
    cells.iter().filter(of).filter_map(in_unit).collect()
}

/// Returns `true` if a value is none of the printed ones.
fn differs(value: f64, printed: &[f64]) -> bool {
    !printed.is_empty() && printed.iter().all(|each| (value - each).abs() > 1e-9 * each.abs())
}

#[test]
fn a_comparison_marks_what_is_not_printed() {
    let project = read(AXIS).unwrap();
    let mut marked = 0;
    for pair in codes().chunks(2).filter(|pair| pair.len() == 2) {
        let ids = [(&pair[0]).into(), (&pair[1]).into()];
        let found = compare(&project, &ids, &Progress::endless()).unwrap();
        let record = answer::comparison(&found, &project, Language::En);
        for row in &record.data {
            for (place, value) in row.values.iter().enumerate() {
                let Some(value) = value else { continue };
                let errata = &row.errata[place];
                if differs(value.0, &printed(&pair[place], row.symbol, row.unit)) {
                    assert!(!errata.is_empty(), "{} of {}: {}", row.symbol, pair[place], value.0);
                    marked += 1;
                }
                for id in errata {
                    assert!(catalogue::erratum(id).unwrap().concerns(&pair[place]), "{id} of {}", pair[place]);
                    assert!(record.errata.iter().any(|each| each.id == *id));
                }
            }
        }
    }
    assert!(marked > 20, "{marked}");
}

fn number(value: &MountValue) -> Option<f64> {
    match value.value {
        TableCell::Number(number) => Some(number.0),
        _ => None,
    }
}

/// Values of a mounting that the tables print: symbol, unit, value, errata.
fn shown(found: &Mount) -> Vec<(&'static str, &'static str, f64, &[&'static str])> {
    let values = found.tolerances.iter().chain(&found.dimensions);
    let mut all: Vec<_> =
        values.filter_map(|each| Some((each.symbol, each.unit, number(each)?, &each.errata[..]))).collect();
    for joint in &found.joints {
        let side = joint.side.id();
        let [tightening, transmissible] = match side {
            "load" => ["tightening_torque_load", "transmissible_torque_load"],
            _ => ["tightening_torque_housing", "transmissible_torque_housing"],
        };
        all.extend(joint.tightening_torque.map(|torque| (tightening, "Nm", torque.0, &joint.tightening_errata[..])));
        all.extend(
            joint.transmissible_torque.map(|torque| (transmissible, "Nm", torque.0, &joint.transmissible_errata[..])),
        );
        for case in &joint.cases {
            let symbol = match case.case.id() {
                "peak" => "T_max",
                "brake" => "T_Br",
                _ => continue,
            };
            all.extend(case.torque.map(|torque| (symbol, "Nm", torque.0, &case.torque_errata[..])));
            all.extend(case.moment.map(|moment| ("M_dyn_max", "Nm", moment.0, &case.moment_errata[..])));
        }
        let rests = joint.cases.iter().find(|case| case.case.id() == "static_moment");
        all.extend(rests.and_then(|case| Some(("M_0_max", "Nm", case.moment?.0, &case.moment_errata[..]))));
    }
    all
}

#[test]
fn a_mounting_marks_what_is_not_printed() {
    let (mut marked, mut seen) = (0, 0);
    for code in codes() {
        let asked = MountInputs::default();
        let found = answer::mount(&mount(&code, &asked).unwrap(), &asked, None, Language::En);
        for (symbol, unit, value, errata) in shown(&found) {
            let printed = printed(&code, symbol, unit);
            seen += usize::from(!printed.is_empty());
            if differs(value, &printed) {
                assert!(!errata.is_empty(), "{symbol} of {code}: {value} for {printed:?}");
                marked += 1;
            }
            for id in errata {
                assert!(found.errata.iter().any(|each| each.id == *id), "{id} of {code}");
            }
        }
    }
    assert!(marked > 20 && seen > 2000, "{marked} of {seen}");
}

/// The tightening torque of table 79.1 that is rounded by another table: printed 42,2, used 42.
#[test]
fn the_torque_of_m8_is_marked_in_the_text() {
    let code = order_code::parse("CHA-50A-80-H-C1024").unwrap().code;
    let asked = MountInputs::default();
    let found = answer::mount(&mount(&code, &asked).unwrap(), &asked, None, Language::De);
    let text = format!("{:?}", questions::chapter::mount(&found, Language::De));
    assert!(text.contains("42 †") && text.contains("† Tabelle 79.1, Anzugsdrehmoment"), "{text}");
}

/// Errata of a wiring concern the winding, the feedback and the size of its code.
#[test]
fn errata_of_a_wiring_concern_the_code() {
    let mut seen = 0;
    for code in codes() {
        let Some(found) = installation::wiring::wiring(&code) else { continue };
        let record = answer::wiring(&found, None, Language::En);
        for id in
            record.errata.iter().chain(record.connectors.iter().flat_map(|each| &each.pins).flat_map(|pin| &pin.errata))
        {
            let erratum = catalogue::erratum(id).unwrap();
            assert!(erratum.concerns(&code), "{id} of {code}");
            seen += 1;
        }
    }
    assert!(seen > 100, "{seen}");
}

/// Every erratum of a cell stands in the row of the cell of the exported catalogue.
#[test]
fn the_exported_catalogue_marks_its_cells() {
    let text = questions::list::catalogue::export_csv();
    let rows: Vec<Vec<&str>> = text.lines().skip(1).map(|line| line.split(',').collect()).collect();
    let mut marked = 0;
    for cell in catalogue::cells() {
        for id in cell.errata {
            let is_its = |row: &&Vec<&str>| row.contains(&cell.place.table) && row.contains(&cell.place.symbol);
            let found =
                rows.iter().filter(is_its).any(|row| row.iter().any(|field| field.split(';').any(|each| each == *id)));
            assert!(found, "{id} of {} {}", cell.place.table, cell.place.symbol);
            marked += 1;
        }
    }
    assert!(marked > 50, "{marked}");
}
