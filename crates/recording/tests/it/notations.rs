//! Notations that could be read in two ways, and columns that are not used.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use recording::{Fault, Layout, Recording, read_csv};

fn read(text: &str) -> Result<Recording, Vec<Fault>> {
    read_csv(text.as_bytes(), &Layout::default())
}

/// A whole number as spreadsheets write it with a separator of thousands.
fn grouped(value: i64, sign: char) -> String {
    let (minus, size) = (if value < 0 { "-" } else { "" }, value.unsigned_abs());
    if size < 1000 { format!("{minus}{size}") } else { format!("{minus}{}{sign}{:03}", size / 1000, size % 1000) }
}

/// Speeds with separators of thousands are refused at the first of them, in any column and in the time, however long
/// the file is.
#[test]
fn whole_numbers_with_separators_of_thousands_are_refused() {
    for sign in ['.', ','] {
        for (delimiter, count) in [(';', 30), ('\t', 30), (';', 20_000)] {
            let peak = 3000.0;
            let speed = |k: i64| (peak * (std::f64::consts::PI * k as f64 / count as f64).sin()) as i64;
            let rows: String = (0..=count).map(|k| format!("{k}{delimiter}{}\n", grouped(speed(k), sign))).collect();
            let faults = read(&format!("t [s]{delimiter}n [1/min]\n{rows}")).unwrap_err();
            let line = 2 + (0..=count).find(|k| speed(*k) > 999).unwrap() as u64;
            assert!(
                matches!(faults.as_slice(), [Fault::ThousandsPossible { line: found, column, .. }]
                    if *found == line && column == "n [1/min]"),
                "{sign} {delimiter:?} {count}: {faults:?}"
            );
            // In the time, where the reading would run backwards.
            let rows: String = (0..=count).map(|k| format!("{}{delimiter}{k}\n", grouped(k + 990, sign))).collect();
            let faults = read(&format!("t [ms]{delimiter}n [1/min]\n{rows}")).unwrap_err();
            assert!(
                matches!(faults.as_slice(), [Fault::ThousandsPossible { line: 12, column, .. }] if column == "t [ms]"),
                "{sign} {delimiter:?} {count}: {faults:?}"
            );
        }
    }
}

/// Decimals are read in every notation that shows them.
#[test]
fn decimals_are_read_where_a_cell_shows_them() {
    for text in [
        "t [s];n [1/min]\n0;998\n0.5;1.002\n1;1.003\n",
        "t [s];n [1/min]\n0;998\n1;1,002\n2;1,0025\n",
        "t [s],n [1/min]\n0,998\n1,1.002\n2,1.003\n",
        "t [s];n [1/min]\n10.000;100.000\n11.000;101.000\n12.000;102.000\n",
        "t [s];n [1/min]\n1000;1\n1001;2\n1002;3\n",
    ] {
        assert!(read(text).is_ok(), "{text}: {:?}", read(text));
    }
}

/// The position of a modulo axis gives the motion of the axis, whatever its range of one revolution.
#[test]
fn modulo_positions_are_unwrapped() {
    for (unit, revolution) in [("deg", 360.0), ("rad", std::f64::consts::TAU), ("rev", 1.0)] {
        for start in [0.0, -0.5] {
            let at = |k: i32| 3.0 * (1.0 - (0.01 * f64::from(k)).cos()) - 0.2;
            let row = |k: i32| {
                let modulo = start + (at(k) - start).rem_euclid(1.0);
                format!("{k},{:.9}\n", modulo * revolution)
            };
            let rows: String = (0..629).map(row).collect();
            let recording = read(&format!("t [ms],q [{unit}]\n{rows}")).unwrap();
            assert!(recording.revolutions_removed >= 12, "{}", recording.revolutions_removed);
            let position = recording.course.position.unwrap();
            for (found, k) in position.values.iter().zip(0..) {
                let expected = std::f64::consts::TAU * (at(k) - at(0));
                assert!((found - position.values[0] - expected).abs() < 1e-6, "{unit} {k}");
            }
        }
    }
}

#[test]
fn positions_of_another_range_are_refused_with_the_way_out() {
    for (unit, speed) in [("deg", true), ("mm", false)] {
        let row = |k: i32| {
            let more = if speed { ",1" } else { "" };
            format!("{k},{}{more}\n", (5.0 * f64::from(k)) % 1000.0)
        };
        let rows: String = (0..500).map(row).collect();
        let faults = read(&format!("t [ms],q [{unit}]{}\n{rows}", if speed { ",n [1/min]" } else { "" })).unwrap_err();
        assert!(
            matches!(faults.as_slice(), [Fault::PositionJumps { has_speed, count: 2, .. }] if *has_speed == speed),
            "{faults:?}"
        );
    }
}

/// A column that states a quantity by name or unit is listed if it is not used.
#[test]
fn unused_headings_are_listed() {
    for name in [
        "velocity_cps",
        "speed_cps",
        "velocity_rads",
        "motor_speed_rpm",
        "rpm",
        "current_A",
        "Torque Reference [%]",
        "load [%]",
        "Motordrehzahl",
        "Motorstrom [A]",
        "temperature",
        "Axis1.FollowingError [deg]",
        "torque_set_pct",
        "SetAcc",
        "Foo",
        "mode",
        "comment",
        "index",
    ] {
        let recording = read(&format!("t [s],q [deg],{name}\n0,0,0\n1,1,0\n2,2,0\n")).unwrap();
        assert_eq!(recording.unused, [name]);
    }
    let blank = read("t [s],q [deg],\n0,0,0\n1,1,0\n2,2,0\n").unwrap();
    assert_eq!(blank.unused, Vec::<String>::new());
    // Of several the order is that of the file.
    let many = read("t [s],b,q [deg],a,c\n0,x,0,y,z\n1,x,1,y,z\n2,x,2,y,z\n").unwrap();
    assert_eq!(many.unused, ["b", "a", "c"]);
}
