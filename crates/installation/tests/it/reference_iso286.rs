//! Limit deviations against published tables, typed by hand from them.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use installation::fit::{Side, bore_zones, deviations, fit};
use quantities::unit::{MICROMETRE, MILLIMETRE};
use quantities::{Length, Measure};

/// Upper and lower limit deviation in µm.
fn limits(zone: &str, size_mm: f64) -> (f64, f64) {
    let found = deviations(zone, Length::new_in(size_mm, &MILLIMETRE));
    let found = &found.known().unwrap_or_else(|| panic!("{zone} at {size_mm} mm")).value;
    (found.upper.in_unit(&MICROMETRE), found.lower.in_unit(&MICROMETRE))
}

#[track_caller]
fn agrees(zone: &str, size_mm: f64, upper: f64, lower: f64) {
    let (found_upper, found_lower) = limits(zone, size_mm);
    assert!(
        (found_upper - upper).abs() < 1e-6 && (found_lower - lower).abs() < 1e-6,
        "{zone} at {size_mm} mm: {found_upper}/{found_lower}, published {upper}/{lower}"
    );
}

/// A maker of mould parts, "Tables for Determining Metric Tolerances", tables for holes:
/// https://online.flippingbook.com/view/962121/282 (J6, J7, K6, K7, M6, M7, N7, JS6, JS7) and
/// https://online.flipbuilder.com/zmgi/xitc/files/basic-html/page280.html (G6, G7, H6, H7, H8 up to 80 mm).
#[test]
fn holes_are_those_of_a_mould_catalogue() {
    for (size, of_zones) in [
        (
            50.0,
            [("J7", 14.0, -11.0), ("K7", 7.0, -18.0), ("M7", 0.0, -25.0), ("N7", -8.0, -33.0), ("JS7", 12.5, -12.5)],
        ),
        (
            78.0,
            [("J7", 18.0, -12.0), ("K7", 9.0, -21.0), ("M7", 0.0, -30.0), ("N7", -9.0, -39.0), ("JS7", 15.0, -15.0)],
        ),
        (
            98.0,
            [("J7", 22.0, -13.0), ("K7", 10.0, -25.0), ("M7", 0.0, -35.0), ("N7", -10.0, -45.0), ("JS7", 17.5, -17.5)],
        ),
        (
            148.0,
            [("J7", 26.0, -14.0), ("K7", 12.0, -28.0), ("M7", 0.0, -40.0), ("N7", -12.0, -52.0), ("JS7", 20.0, -20.0)],
        ),
        (
            222.0,
            [("J7", 30.0, -16.0), ("K7", 13.0, -33.0), ("M7", 0.0, -46.0), ("N7", -14.0, -60.0), ("JS7", 23.0, -23.0)],
        ),
    ] {
        for (zone, upper, lower) in of_zones {
            agrees(zone, size, upper, lower);
        }
    }
    for (size, of_zones) in [
        (49.0, [("J6", 10.0, -6.0), ("K6", 3.0, -13.0), ("M6", -4.0, -20.0), ("JS6", 8.0, -8.0)]),
        (69.0, [("J6", 13.0, -6.0), ("K6", 4.0, -15.0), ("M6", -5.0, -24.0), ("JS6", 9.5, -9.5)]),
        (110.0, [("J6", 16.0, -6.0), ("K6", 4.0, -18.0), ("M6", -6.0, -28.0), ("JS6", 11.0, -11.0)]),
        (168.0, [("J6", 18.0, -7.0), ("K6", 4.0, -21.0), ("M6", -8.0, -33.0), ("JS6", 12.5, -12.5)]),
        (193.0, [("J6", 22.0, -7.0), ("K6", 5.0, -24.0), ("M6", -8.0, -37.0), ("JS6", 14.5, -14.5)]),
    ] {
        for (zone, upper, lower) in of_zones {
            agrees(zone, size, upper, lower);
        }
    }
    for (size, of_zones) in [
        (49.0, [("G6", 25.0, 9.0), ("G7", 34.0, 9.0), ("H6", 16.0, 0.0), ("H7", 25.0, 0.0), ("H8", 39.0, 0.0)]),
        (59.0, [("G6", 29.0, 10.0), ("G7", 40.0, 10.0), ("H6", 19.0, 0.0), ("H7", 30.0, 0.0), ("H8", 46.0, 0.0)]),
    ] {
        for (zone, upper, lower) in of_zones {
            agrees(zone, size, upper, lower);
        }
    }
}

/// A maker of bearings, housing tolerances: https://it.scribd.com/document/460766340/Tolerances-and-resultant-fits-SKF-1-pdf.
#[test]
fn holes_are_those_of_a_bearing_catalogue() {
    for (size, h7, h8, (j6_upper, j6_lower)) in [
        (49.0, 25.0, 39.0, (10.0, -6.0)),
        (59.0, 30.0, 46.0, (13.0, -6.0)),
        (116.0, 35.0, 54.0, (16.0, -6.0)),
        (180.0, 40.0, 63.0, (18.0, -7.0)),
        (222.0, 46.0, 72.0, (22.0, -7.0)),
        (255.0, 52.0, 81.0, (25.0, -7.0)),
    ] {
        agrees("H7", size, h7, 0.0);
        agrees("H8", size, h8, 0.0);
        agrees("J6", size, j6_upper, j6_lower);
    }
}

/// A maker of tools, shaft tolerances: https://catalog.bigdaishowa.com/view/510119233/139, column h7 in mm.
#[test]
fn the_pilots_are_those_of_a_tool_catalogue() {
    for (size, lower) in [
        (49.0, -25.0),
        (59.0, -30.0),
        (84.0, -35.0),
        (132.0, -40.0),
        (180.0, -40.0),
        (193.0, -46.0),
        (222.0, -46.0),
        (255.0, -52.0),
    ] {
        agrees("h7", size, 0.0, lower);
    }
}

/// The rules of ISO 286-1: H and h begin at the nominal size, JS lies about it, and every zone is as wide as its grade.
#[test]
fn every_zone_is_as_wide_as_its_grade() {
    // Standard tolerances: https://berger-tools.co.uk/pdfs/flipping_book/Standard_Parts_Catalogue/2151.
    let grades = [
        ('6', [16.0, 19.0, 22.0, 25.0, 29.0, 32.0]),
        ('7', [25.0, 30.0, 35.0, 40.0, 46.0, 52.0]),
        ('8', [39.0, 46.0, 54.0, 63.0, 72.0, 81.0]),
    ];
    let zones = bore_zones();
    assert_eq!(zones.len(), 14, "{zones:?}");
    for zone in zones.into_iter().chain(["h7"]) {
        let (_, widths) = grades.iter().find(|(grade, _)| zone.ends_with(*grade)).unwrap();
        for (size, width) in [50.0, 80.0, 120.0, 180.0, 250.0, 315.0].into_iter().zip(widths) {
            let (upper, lower) = limits(zone, size);
            assert!((upper - lower - width).abs() < 1e-6, "{zone} at {size}: {upper}/{lower}");
            match zone.trim_end_matches(|sign: char| sign.is_ascii_digit()) {
                "H" => assert!(lower.abs() < 1e-9, "{zone}"),
                "h" => assert!(upper.abs() < 1e-9, "{zone}"),
                "JS" => assert!((upper + lower).abs() < 1e-9, "{zone}"),
                _ => {}
            }
        }
    }
}

#[test]
fn a_size_belongs_to_the_range_that_it_ends() {
    assert_eq!(limits("H7", 50.0), limits("H7", 49.0));
    assert!(limits("H7", 50.001).0 > limits("H7", 50.0).0);
    for outside in [30.0, 315.1] {
        assert!(deviations("H7", Length::new_in(outside, &MILLIMETRE)).known().is_none(), "{outside}");
    }
}

/// The erratum of table 77.1 names these two extremes.
#[test]
fn the_recommended_bore_gives_no_transition() {
    let clearance = |code: &str, side| {
        let fit = fit(&order_code::parse(code).unwrap().code, side, None).unwrap();
        (fit.clearance_min.in_unit(&MICROMETRE), fit.clearance_max.in_unit(&MICROMETRE), fit.kind.id())
    };
    let (min, max, kind) = clearance("CHA-14A-50-E-M128S", Side::Load);
    assert!(min.abs() < 1e-9 && (max - 50.0).abs() < 1e-6 && kind == "clearance");
    let (min, max, kind) = clearance("CHA-58A-50-H-C1024", Side::Housing);
    assert!(min.abs() < 1e-9 && (max - 104.0).abs() < 1e-6 && kind == "clearance");
}
