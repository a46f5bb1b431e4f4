//! Notations that could be read in two ways, and columns that are not used.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use recording::{Fault, Layout, Recording, Records, RowKind, read_csv};

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

/// A number as spreadsheets write it with a separator of thousands and decimals.
fn with_decimals(value: f64, places: usize, thousands: &str, decimal: &str) -> String {
    let text = format!("{value:.places$}");
    let (whole, part) = text.split_once('.').unwrap_or((&text, ""));
    let mut grouped = String::new();
    for (index, digit) in whole.chars().enumerate() {
        if index > 0 && (whole.len() - index).is_multiple_of(3) {
            grouped.push_str(thousands);
        }
        grouped.push(digit);
    }
    if places > 0 { format!("{grouped}{decimal}{part}") } else { grouped }
}

/// Times that have separators of thousands from some row to the end of the file are no footer: the only remedy is to export them
/// without, since an earlier end would drop a part of the motion.
#[test]
fn grouped_times_to_the_end_are_no_footer() {
    let text = |scale: f64, count: u32, places, (thousands, decimal): (&str, &str)| {
        let row = |k: u32| {
            let t = f64::from(k) * 5.0 * scale;
            let q = with_decimals(f64::from(k % 90), 2, "", decimal);
            format!("{};{q}\n", with_decimals(t, places, thousands, decimal))
        };
        format!("t [ms];q [deg]\n{}", (0..=count).map(row).collect::<String>())
    };
    let signs = [(".", ","), (",", "."), ("'", ","), ("’", "."), ("\u{a0}", ","), ("\u{202f}", ","), (" ", ",")];
    for signs in signs {
        for (scale, places) in [(1.0, 2), (1.0, 0), (1000.0, 0), (1000.0, 1)] {
            // As many rows with separators as a footer may have, fewer, and more.
            for count in [200, 201, 281, 2000] {
                let text = text(scale, count, places, signs);
                let faults = read(&text).unwrap_err();
                let is_right = |fault: &Fault| matches!(fault.bare(), Fault::ThousandsGrouped { column, .. } if column == "t [ms]");
                let first = |fault: &Fault| match fault {
                    Fault::Repeated { first, .. } => is_right(first),
                    fault => is_right(fault),
                };
                assert!(
                    !faults.is_empty() && faults.iter().all(first),
                    "{signs:?} {scale} {places} {count}: {faults:?}"
                );
            }
        }
    }
    // A value with separators beside a time without is no other matter.
    let faults = read("t [s];n [1/min]\n0;0,5\n1;999,5\n2;1.000,5\n3;1.001,5\n").unwrap_err();
    assert!(matches!(faults.as_slice(), [Fault::ThousandsGrouped { .. }, ..]), "{faults:?}");
}

/// A table is read with its numbers or refused in every dialect, as samples and as the rows of a spreadsheet: no combination of
/// delimiter, decimal sign, separator of thousands, quotes and a separator at the end of the heading gives other numbers.
#[test]
fn no_dialect_gives_other_numbers() {
    let (mut read_well, mut refused) = (0, 0);
    arbtest::arbtest(|u| {
        let delimiter = [';', ',', '\t', '|'][u.int_in_range(0..=3_usize)?];
        let decimal = [".", ","][u.int_in_range(0..=1_usize)?];
        let thousands = ["", "", ".", ",", "'", "\u{a0}"][u.int_in_range(0..=5_usize)?];
        if thousands == decimal {
            return Ok(());
        }
        let (quotes, is_open) = (u.int_in_range(0..=2_u8)?, u.ratio(1, 6)?);
        let places = [u.int_in_range(0..=4_usize)?, u.int_in_range(0..=4_usize)?];
        // A column in which every number is below 1000, above, or either.
        let (least, most) = [(0, 999), (1_000, 999_999), (0, 3_000)][u.int_in_range(0..=2_usize)?];
        let count = u.int_in_range(3..=30_u32)?;
        let mut values = Vec::new();
        for k in 0..count {
            let value = f64::from(u.int_in_range(least..=most)?) + f64::from(u.int_in_range(0..=999)?) / 1000.0;
            // The number that is written.
            let whole: f64 = format!("{value:.*}", places[1]).parse().unwrap();
            values.push([f64::from(k), whole]);
        }
        let mut has_open_comma = false;
        let mut cell = |value: f64, places: usize| {
            let text = with_decimals(value, places, thousands, decimal);
            let is_quoted = quotes == 2 || quotes == 1 && text.contains(delimiter);
            has_open_comma |= !is_quoted && text.contains(delimiter);
            if is_quoted { format!("\"{text}\"") } else { text }
        };
        let rows: String = values
            .iter()
            .map(|[t, n]| format!("{}{delimiter}{}\n", cell(*t, places[0]), cell(*n, places[1])))
            .collect();
        let end = if is_open { delimiter.to_string() } else { String::new() };
        let text = format!("t [s]{delimiter}n [1/min]{end}\n{rows}");
        let written: Vec<String> =
            values.iter().map(|[_, n]| with_decimals(*n, places[1], thousands, decimal)).collect();
        let is_grouped =
            |text: &String| text.len() < 8 && text.split_once(thousands).is_some_and(|(_, rest)| rest.len() == 3);
        // Where every number has three digits behind one sign, a comma of an unquoted number or a point counts as decimal.
        let is_undecided = !thousands.is_empty() && places == [0, 0] && written.iter().all(is_grouped);
        // Between commas a point is that of decimals.
        let is_point_between_commas =
            thousands == "." && delimiter == ',' && places == [0, 0] && written.iter().all(|text| text.len() < 8);
        let is_known_limit =
            is_undecided && thousands != "'" && thousands != "\u{a0}" && delimiter != ',' || is_point_between_commas;
        match read(&text) {
            Ok(found) => {
                let speeds = &found.course.speed.as_ref().unwrap().values;
                let is_same = speeds.len() == values.len()
                    && speeds
                        .iter()
                        .zip(&values)
                        .all(|(found, [_, n])| (found * 30.0 / std::f64::consts::PI - n).abs() < 1e-6);
                assert!(is_same || is_known_limit, "{text}");
                read_well += u32::from(is_same);
            }
            Err(faults) => {
                assert!(!faults.is_empty());
                refused += 1;
            }
        }
        let mut records = Records::open_below(text.as_bytes(), |cell| cell == "t [s]").unwrap();
        let (mut numbers, mut is_refused) = (Vec::new(), false);
        while records.advance().unwrap() {
            let row = records.numbers(|column, number, _| {
                is_refused |= number.is_none();
                if column == 1 {
                    numbers.push(number.unwrap_or_default());
                }
            });
            is_refused |= row.is_err();
        }
        is_refused |= records.thousands(RowKind::Entries, |_| true).is_some();
        let is_same = numbers.iter().zip(&values).all(|(found, [_, n])| (found - n).abs() < 1e-6);
        let is_limit_of_rows = is_known_limit && thousands == "," || is_point_between_commas;
        assert!(is_refused || is_same || is_limit_of_rows, "{text}");
        Ok(())
    })
    .budget_ms(2_000);
    assert!(read_well > 100 && refused > 100, "{read_well} {refused}");
}

/// Numbers that are quoted in a comma-separated table, each with a comma before three digits, may be thousands or decimals.
#[test]
fn quoted_commas_before_three_digits_are_ambiguous() {
    let text = |numbers: [&str; 3]| {
        let rows = numbers.iter().zip(0..).map(|(number, k)| format!("\"{k}\",\"{number}\"\n"));
        format!("t [s],n [1/min]\n{}", rows.collect::<String>())
    };
    let faults = read(&text(["1,000", "2,000", "3,000"])).unwrap_err();
    assert!(matches!(faults.as_slice(), [Fault::ThousandsPossible { line: 2, .. }]), "{faults:?}");
    assert!(read(&text(["1,000", "2,000", "3,5"])).is_ok());
    // A point beside them shows that they are thousands, as does a first row without quotes.
    for text in [text(["0.5", "2,000", "3,000"]), "t [s],n [1/min]\n0,998\n1,\"1,002\"\n2,\"1,003\"\n".to_owned()] {
        assert!(read(&text).is_err(), "{text}");
    }
}

/// A separator at the end of a comma-separated heading leaves room for the digits behind a decimal comma.
#[test]
fn a_separator_at_the_end_of_the_heading_swallows_no_decimals() {
    let faults = read("t [s],q [deg],\n0,1,5\n1,2,5\n2,3,5\n").unwrap_err();
    let is_twice = |fault: &Fault| matches!(fault.bare(), Fault::CommasTwice { found: 3, expected: 2, .. });
    assert!(faults.iter().all(is_twice) && faults.len() == 3, "{faults:?}");
    assert!(read("t [s];q [deg];\n0;1,5;\n1;2,5;\n2;3,5;\n").is_ok());
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
    let blank = read("t [s],q [deg],\n0,0,x\n1,1,y\n2,2,z\n").unwrap();
    assert_eq!(blank.unused, Vec::<String>::new());
    // Of several the order is that of the file.
    let many = read("t [s],b,q [deg],a,c\n0,x,0,y,z\n1,x,1,y,z\n2,x,2,y,z\n").unwrap();
    assert_eq!(many.unused, ["b", "a", "c"]);
}

/// Rows of delimiters end the export of a range of a spreadsheet; among other rows the values are missing.
#[test]
fn rows_of_delimiters_at_the_end_are_empty() {
    let rows = "t [s];q [deg];n [deg/s];;;\n0;0;0;;;\n1;1;2;;;\n2;4;2;;;\n";
    for more in [";;;;;\n", ";;;;;\n;;;;;\n", ";\n", &";;;;;\n".repeat(500), " ; ;;;;\n;;\n"] {
        let found = read(&format!("{rows}{more}")).unwrap_or_else(|faults| panic!("{more:?}: {faults:?}"));
        assert_eq!(*found.time_s, [0.0, 1.0, 2.0], "{more:?}");
    }
    for more in [";;;;;\n3;6;2;;;\n", ";;;;;\n;;;;;\n3;6;2;;;\n4;8;2;;;\n"] {
        let faults = read(&format!("{rows}{more}")).unwrap_err();
        assert!(matches!(faults.as_slice(), [Fault::ValueMissing { .. }]), "{more:?}: {faults:?}");
    }
}

/// Lines of delimiters between names, units and rows state nothing.
#[test]
fn a_line_of_delimiters_above_the_rows_is_no_heading() {
    for text in [
        "Time,Position,Velocity\nseconds,degrees,RPM\n,,\n0.0,0.0,0.0\n0.5,1.0,2.0\n1.0,4.0,2.0\n",
        "Time,Position,Velocity\n,,\ns,deg,1/min\n0.0,0.0,0.0\n0.5,1.0,2.0\n1.0,4.0,2.0\n",
        "Time [s];Position [deg];Velocity [1/min]\n;;\n;;\n0,0;0,0;0,0\n0,5;1,0;2,0\n1,0;4,0;2,0\n",
    ] {
        let found = read(text).unwrap_or_else(|faults| panic!("{text}: {faults:?}"));
        assert_eq!((*found.time_s).as_ref(), [0.0, 0.5, 1.0], "{text}");
    }
}

/// Numbers separated by spaces are named as such below lines of text too.
#[test]
fn spaced_rows_below_lines_of_text_are_named() {
    let faults = read("Rig 7\nOperator: x\nt q n\n0.0 0.0 0.0\n0.1 0.2 0.3\n0.2 0.4 0.6\n").unwrap_err();
    assert_eq!(faults, [Fault::SpacesOnly]);
    let faults = read("Rig 7\nOperator: x\nno numbers here\nnor here\n").unwrap_err();
    assert_eq!(faults, [Fault::NoTable]);
}

/// The index of a data frame is proposed as the time if no other column is, and reported where it is not used.
#[test]
fn the_index_of_a_data_frame_is_proposed_and_reported() {
    let faults = read(",q [deg],n [deg/s]\n0.0,0,0\n0.5,1,2\n1.0,4,2\n").unwrap_err();
    let [Fault::TimeMissing { near, .. }] = faults.as_slice() else { panic!("{faults:?}") };
    assert_eq!((near[0].column.as_str(), near[0].has_unit), ("#1", false));
    let found = read(",t [s],q [deg],\n0,0.0,0,\n1,0.5,1,\n2,1.0,4,\n").unwrap();
    assert_eq!(found.unused, ["#1"], "cells without heading at the end hold nothing");
    let found = read(",t [s],q [deg]\n,0.0,0\n,0.5,1\n,1.0,4\n").unwrap();
    assert_eq!(found.unused, [""; 0], "nor does an empty column");
}

/// The number of a parameter is no part of the name.
#[test]
fn numbers_of_parameters_stand_before_names() {
    for (heading, is_known) in [
        ("r0063 Drehzahlistwert [1/min]", true),
        ("r0063[0] Drehzahlistwert [1/min]", true),
        ("S-0-0040 Istgeschwindigkeit [1/min]", true),
        ("r63 Drehzahlistwert [1/min]", false),
        ("r0063 [1/min]", false),
    ] {
        let found = read(&format!("Zeit [s];{heading}\n0;0\n1;1\n2;2\n"));
        assert_eq!(found.is_ok(), is_known, "{heading}: {found:?}");
    }
}

/// A unit that is stated for a column which is not found is reported: the motion would be that of another column.
#[test]
fn a_unit_without_its_column_is_reported() {
    use quantities::unit::{DEGREE, NEWTON_METRE};
    use recording::{ColumnSpec, Role};
    let text = "time [s],axis.s,omega [rad/s],load [N m]\n0,0,0,0\n1,1,2,1\n2,4,2,1\n";
    let of = |layout: &Layout| read_csv(text.as_bytes(), layout);
    let unit = |unit| ColumnSpec { unit: Some(unit), ..ColumnSpec::default() };
    assert!(of(&Layout::default()).is_ok());
    let layout = Layout { position: unit(&DEGREE), ..Layout::default() };
    let faults = of(&layout).unwrap_err();
    assert!(matches!(faults.as_slice(), [Fault::UnitWithoutColumn { role: Role::Position, .. }]), "{faults:?}");
    let layout = Layout { torque: unit(&NEWTON_METRE), ..Layout::default() };
    let faults = of(&layout).unwrap_err();
    let [Fault::UnitWithoutColumn { role: Role::Torque, near, .. }] = faults.as_slice() else { panic!("{faults:?}") };
    assert_eq!(near[0].column, "load [N m]");
    let left_out = ColumnSpec { unused: true, ..unit(&DEGREE) };
    assert!(of(&Layout { position: left_out, ..Layout::default() }).is_ok());
}
