//! Exports of tools that differ from a plain table: trends, lines of notes, headings in comments, empty cells at the end.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use quantities::unit;
use recording::{ColumnSpec, Fault, FileRow, Layout, Recording, Role, read_csv};
use std::time::Instant;

/// Number of samples, 2 ms apart.
const COUNT: u64 = 2_000;

fn read(text: &str, layout: &Layout) -> Result<Recording, Vec<Fault>> {
    read_csv(text.as_bytes(), layout)
}

fn position(k: u64) -> f64 {
    90.0 * (1.0 - (k as f64 * 2e-3).cos())
}

/// Checks times and positions against those of the samples.
fn check(recording: &Recording, what: &str) {
    assert_eq!(recording.time_s.len() as u64, COUNT, "{what}");
    let positions = &recording.course.position.as_ref().unwrap().values;
    for (k, (time, found)) in (0..).zip(recording.time_s.iter().zip(positions.iter())) {
        assert!((time - 2e-3 * k as f64).abs() < 1e-9, "{what}: {time} s in row {k}");
        assert!((found - position(k).to_radians()).abs() < 1e-6, "{what}: {found} rad in row {k}");
    }
}

/// Every form of a clock, over midnight: the samples begin 2 s before it.
#[test]
fn clocks_of_every_form_count_the_same_times() {
    let part = |k: u64| (k * 2) % 1000;
    let time = |k: u64, between: char| match k {
        0..1000 => format!("23:59:{}{between}{:03}", 58 + k / 500, part(k)),
        _ => format!("00:00:{:02}{between}{:03}", k / 500 - 2, part(k)),
    };
    let day = |k: u64, first: u64| first + k / 1000;
    let forms: [(&str, &dyn Fn(u64) -> String); 13] = [
        ("ISO", &|k| format!("2025-03-{} {}", day(k, 14), time(k, '.'))),
        ("UTC", &|k| format!("2025-03-{} {} UTC", day(k, 14), time(k, '.'))),
        ("two digits of the year", &|k| format!("{}.03.25 {}", day(k, 14), time(k, ','))),
        ("day and month", &|k| format!("{}/03/2025 {}", day(k, 14), time(k, '.'))),
        ("day and month over the end of a month", &|k| {
            format!("{}/2025 {}", if k < 1000 { "31/03" } else { "01/04" }, time(k, '.'))
        }),
        ("month and day over the end of a month", &|k| {
            format!("{}/2025 {}", if k < 1000 { "03/31" } else { "04/01" }, time(k, '.'))
        }),
        ("the order shows late", &|k| format!("{}/04/2025 {}", day(k, 12), time(k, '.'))),
        ("name of the month", &|k| format!("{}-Mar-2025 {}", day(k, 14), time(k, '.'))),
        ("colon before the milliseconds", &|k| time(k, ':')),
        ("duration of pandas", &|k| format!("{} days {}", day(k, 0), time(k, '.'))),
        ("duration of Python", &|k| format!("{} day, {}", day(k, 0), time(k, '.'))),
        ("minutes and seconds", &|k| format!("{:02}:{:02},{:03}", 59 - 59, k / 500, part(k))),
        ("time of day", &|k| time(k, '.')),
    ];
    for (what, form) in forms {
        let rows: String = (0..COUNT).map(|k| format!("{}\t{:.9}\n", form(k), position(k))).collect();
        let text =
            format!("Time\tq [deg]\n{}", if what.starts_with("minutes") { rows.replace('.', ",") } else { rows });
        match read(&text, &Layout::default()) {
            Ok(recording) => check(&recording, what),
            Err(faults) => panic!("{what}: {faults:?}"),
        }
    }
}

/// A trend of Rockwell: lines about the file, the date in a column of its own, milliseconds behind a semicolon.
#[test]
fn a_trend_of_rockwell_is_read() {
    let rows: String = (0..COUNT)
        .map(|k| format!("Data: ,3/14/2025,10:11:{};{},{:.9}\n", 12 + k / 500, (k * 2) % 1000, position(k)))
        .collect();
    let text = format!(
        "Controller Name: ,PLC1\nTrend Tags: ,2\nSample Period: ,2 ms\nStart Time: ,\"Friday, March 14, 2025 10:11:12 AM\"\n\
         Header: ,Date,Time,Axis1.ActualPosition\n{rows}"
    );
    let unit = quantities::Unit::of("deg");
    let layout = Layout { position: ColumnSpec { unit, ..ColumnSpec::default() }, ..Layout::default() };
    check(&read(&text, &layout).unwrap(), "Rockwell");
}

/// catman: names, units and a line of notes above the rows.
#[test]
fn a_line_of_notes_below_the_units_is_passed_over() {
    let rows: String = (0..COUNT).map(|k| format!("{:.3}\t{:.9}\t0\n", 2e-3 * k as f64, position(k))).collect();
    let text =
        format!("File\t\nCreated\t14.03.2025\n\nZeit\tWinkel\tTemperatur\ns\tdeg\t°C\nkein Startoffset\t\t\n{rows}");
    check(&read(&text, &Layout::default()).unwrap(), "catman");
}

/// The heading in a comment, as NumPy writes it.
#[test]
fn a_comment_above_numbers_is_their_heading() {
    let rows: String = (0..COUNT).map(|k| format!("{:e},{:e}\n", 2e-3 * k as f64, position(k))).collect();
    for before in ["", "# run 7\n", "# a, b, c\n"] {
        check(&read(&format!("{before}# t [s],q [deg]\n{rows}"), &Layout::default()).unwrap(), before);
    }
    // A comment that is no heading leaves the file without one.
    for other in ["# run 7", "# a,b", "# t [s],q [deg],n [1/min]", "# t [s],q [deg]\n# run 7"] {
        let faults = read(&format!("{other}\n{rows}"), &Layout::default()).unwrap_err();
        assert!(matches!(faults.as_slice(), [Fault::HeadingMissing { .. }]), "{other}: {faults:?}");
    }
}

/// Empty cells at the end of the rows or of the heading only.
#[test]
fn empty_cells_at_the_end_count_for_nothing() {
    for delimiter in [";", "\t", ","] {
        for (heading, row) in [("", delimiter), (delimiter, ""), ("", ";;;"), (";;", ""), (delimiter, delimiter)] {
            let (heading, row) = (heading.replace(';', delimiter), row.replace(';', delimiter));
            let line = |k: u64| format!("{:.3}{delimiter}{:.9}{row}\n", 2e-3 * k as f64, position(k));
            let rows: String = (0..COUNT).map(line).collect();
            let text = format!("t [s]{delimiter}q [deg]{heading}\n{rows}");
            match read(&text, &Layout::default()) {
                Ok(recording) => check(&recording, &format!("{heading:?} {row:?}")),
                Err(faults) => panic!("{heading:?} {row:?}: {faults:?}"),
            }
            // A cell with content is one too many, unless a nameless column holds it.
            if !heading.is_empty() {
                continue;
            }
            let text =
                text.replacen(&line(7), &format!("{}x\n", line(7).trim_end_matches('\n').to_owned() + delimiter), 1);
            let faults = read(&text, &Layout::default()).unwrap_err();
            assert!(faults.iter().any(|fault| matches!(fault, Fault::Ragged { line: 9, .. })), "{faults:?}");
        }
    }
}

/// Numbers with their units, as timetables of MATLAB and panels of Grafana write them: in all columns or in one, with either
/// decimal sign, a unit behind a space or not.
#[test]
fn a_unit_may_stand_in_every_cell() {
    let rows =
        |row: &dyn Fn(f64, f64) -> String| (0..COUNT).map(|k| row(2e-3 * k as f64, position(k))).collect::<String>();
    let comma = |value: f64| format!("{value:.9}").replace('.', ",");
    type Row<'r> = &'r dyn Fn(f64, f64) -> String;
    let cases: [(&str, &str, Row<'_>); 6] = [
        ("all", "t;q", &|t, q| format!("{t:.3} s;{q:.9} deg\n")),
        ("time only", "Time,q_deg", &|t, q| format!("{t:.3} sec,{q:.9}\n")),
        ("no space", "t\tq", &|t, q| format!("{:.1}ms\t{q:.9}°\n", 1e3 * t)),
        ("decimal commas", "t;q", &|t, q| format!("{} s;{} deg\n", comma(t), comma(q))),
        ("also in the heading", "t [s];q [deg]", &|t, q| format!("{t:.3} s;{q:.9} deg\n")),
        ("quoted", "\"t\",\"q\"", &|t, q| format!("\"{} s\",\"{} deg\"\n", comma(t), comma(q))),
    ];
    for (name, heading, row) in cases {
        match read(&format!("{heading}\n{}", rows(row)), &Layout::default()) {
            Ok(recording) => check(&recording, name),
            Err(faults) => panic!("{name}: {faults:?}"),
        }
    }
    // A cell in another unit, or in none, is refused at its line; a unit that contradicts the heading, for the column.
    let text = format!("t;q\n{}", rows(&|t, q| format!("{t:.3} s;{q:.9} deg\n")));
    let third = "0.002 s;";
    for wrong in ["0.002 min;", "0.002;", "2 ms;"] {
        let faults = read(&text.replacen(third, wrong, 1), &Layout::default()).unwrap_err();
        assert!(matches!(faults.as_slice(), [Fault::UnitOfCell { at: FileRow::Line(3), .. }]), "{wrong}: {faults:?}");
    }
    let faults = read(&text.replacen("t;q", "t [ms];q", 1), &Layout::default()).unwrap_err();
    assert!(matches!(faults.as_slice(), [Fault::UnitContradiction { .. }]), "{faults:?}");
    let faults = read(&text.replace(" deg", " kg"), &Layout::default()).unwrap_err();
    assert!(matches!(faults.as_slice(), [Fault::UnitWrong { .. }]), "{faults:?}");
    // A row of values that holds a unit proposes no column: one signal a row, as a controller lists them.
    let listed = "VarName;Timestamp;Value;Unit\nfActPos;0;0,5;deg\nfActPos;2;0,7;deg\n";
    let faults = read(listed, &Layout::default()).unwrap_err();
    let is_proposed = |fault: &Fault| matches!(fault, Fault::CourseMissing { near, .. } if !near.is_empty());
    assert!(!faults.iter().any(is_proposed), "{faults:?}");
}

/// Without a heading, columns named by their numbers are read from the first row, whatever the other cells hold.
#[test]
fn a_first_row_with_numbers_in_the_numbered_columns_is_a_row() {
    for sign in [';', ',', '\t'] {
        for before in ["", "RUN|", "a b|c|d|"] {
            for behind in ["", "|RUN", "|ok|x|y"] {
                for clock in [false, true] {
                    let time = |k: u32| if clock { format!("10:00:0{k}") } else { format!("0.{k}") };
                    let rows: Vec<String> = (0..5).map(|k| format!("{before}{}|{k}{behind}", time(k))).collect();
                    let text = rows.join("\n").replace('|', &sign.to_string());
                    let first = before.matches('|').count() + 1;
                    let named =
                        |number: usize, unit| ColumnSpec { name: Some(format!("#{number}")), unit, unused: false };
                    let layout = Layout {
                        time: named(first, (!clock).then_some(&unit::SECOND)),
                        position: named(first + 1, Some(&unit::DEGREE)),
                        ..Layout::default()
                    };
                    let found = read_csv(text.as_bytes(), &layout);
                    let samples = found.as_ref().map(|recording| recording.time_s.len());
                    assert_eq!(samples.ok(), Some(5), "{text}: {found:?}");
                }
            }
        }
    }
}

/// A bracket, or a row below the heading, that holds no unit does not count where the layout states the unit; a unit
/// there does.
#[test]
fn a_stated_unit_replaces_what_is_no_unit() {
    let layout = |speed| Layout {
        time: ColumnSpec { unit: Some(&unit::SECOND), ..ColumnSpec::default() },
        speed: ColumnSpec { unit: speed, ..ColumnSpec::default() },
        ..Layout::default()
    };
    let stated = || layout(Some(&unit::REVOLUTION_PER_MINUTE));
    for word in ["tours", "pos", "ø", "counts", "Units/s", "OFF", "FLT", "---"] {
        let heading = format!("time;speed ({word})\n0;1\n1;2\n2;3\n");
        let row = format!("time;speed\ns;{word}\n0;1\n1;2\n2;3\n");
        for text in [heading, row] {
            let found = read_csv(text.as_bytes(), &stated()).unwrap();
            assert_eq!(found.time_s.len(), 3, "{text}");
            let faults = read_csv(text.as_bytes(), &layout(None)).unwrap_err();
            assert!(
                matches!(faults.as_slice(), [Fault::UnitUnknown { .. } | Fault::UnitMissing { .. }]),
                "{text}: {faults:?}"
            );
        }
    }
    for word in ["rad/s", "mm/s", "deg", "Nm"] {
        let text = format!("time;speed ({word})\n0;1\n1;2\n2;3\n");
        let faults = read_csv(text.as_bytes(), &stated()).unwrap_err();
        let is_refused = |fault: &Fault| matches!(fault, Fault::UnitContradiction { .. } | Fault::UnitWrong { .. });
        assert!(faults.iter().all(is_refused), "{text}: {faults:?}");
    }
    // A dash in a row of units leaves the others.
    let text = "time;speed\ns;-\n0;1\n1;2\n2;3\n";
    let only_speed = Layout { time: ColumnSpec::default(), ..stated() };
    for layout in [stated(), only_speed] {
        assert_eq!(read_csv(text.as_bytes(), &layout).unwrap().time_s.len(), 3);
    }
    assert!(matches!(
        read_csv(text.as_bytes(), &Layout::default()).unwrap_err().as_slice(),
        [Fault::UnitMissing { .. }]
    ));
}

/// Every proposed column is read as proposed.
#[test]
fn proposals_name_columns_that_can_be_read() {
    for (text, expected) in [
        ("FLT,FLT,FLT\ns,deg,1/min\n0,0,0\n1,1,1\n2,2,2\n", 3),
        ("stamp,FLT,FLT\ns,deg,1/min\n0,0,0\n1,1,1\n2,2,2\n", 3),
        (
            ",q [deg]\n2025-03-14 10:00:00.000+01:00,0\n2025-03-14 10:00:00.002+01:00,1\n2025-03-14 10:00:00.004+01:00,2\n",
            3,
        ),
        ("when,q [deg]\n10:00:00.000,0\n10:00:00.002,1\n10:00:00.004,2\n", 3),
    ] {
        let mut layout = Layout::default();
        let mut found = read_csv(text.as_bytes(), &layout);
        assert!(found.is_err(), "{text}");
        for fault in found.unwrap_err() {
            let (Fault::TimeMissing { near, .. } | Fault::CourseMissing { near, .. }) = fault else {
                panic!("{text}: {fault:?}")
            };
            assert!(!near.is_empty(), "{text}");
            for near in near {
                let spec = ColumnSpec { name: Some(near.column), ..ColumnSpec::default() };
                match near.role {
                    Role::Time => layout.time = spec,
                    Role::Position => layout.position = spec,
                    Role::Speed => layout.speed = spec,
                    Role::Torque => layout.torque = spec,
                }
            }
        }
        found = read_csv(text.as_bytes(), &layout);
        assert_eq!(found.as_ref().map(|recording| recording.time_s.len()).ok(), Some(expected), "{text}: {found:?}");
    }
}

/// A clock time in a form that is not known is quoted as such, with a unit stated or not.
#[test]
fn a_clock_time_of_unknown_form_is_quoted() {
    for written in ["T#0ms", "2025-10-26_02-59-58", "20251026 025958", "2025-10-26 02:59:58 CET", "02:59"] {
        let text = format!("Time;q [deg]\n{written};0\n{written};1\n{written};2\n");
        for unit in [None, Some(&unit::SECOND)] {
            let time = ColumnSpec { unit, ..ColumnSpec::default() };
            let faults = read_csv(text.as_bytes(), &Layout { time, ..Layout::default() }).unwrap_err();
            assert!(matches!(faults.as_slice(), [Fault::ClockUnknown { text, .. }] if text == written), "{faults:?}");
        }
    }
}

/// `Time_ms` of WinCC beside `TimeString` counts millionths of a day.
#[test]
fn the_time_of_wincc_is_in_millionths_of_a_day() {
    let rows: String = (0..20_u32)
        .map(|k| {
            let days = 45_730_416_666.666_67 + f64::from(k) * 0.01 / 0.0864;
            format!("\"Pos\";\"14.03.2025 10:00:00\";{k};1;{}\n", format!("{days:.6}").replace('.', ","))
        })
        .collect();
    let text = format!("\"VarName\";\"TimeString\";\"Position [deg]\";\"Validity\";\"Time_ms\"\n{rows}");
    let found = read_csv(text.as_bytes(), &Layout::default()).unwrap();
    assert!((found.time_s[19] - 0.19).abs() < 2e-5, "{:?}", found.time_s);
    let alone = text.replace("TimeString", "Text");
    let found = read_csv(alone.as_bytes(), &Layout::default()).unwrap();
    assert!((found.time_s[19] - 19e-3 * 0.01 / 0.0864).abs() < 1e-6, "{:?}", found.time_s);
}

/// Every way of writing numbers takes a small multiple of the time of plain ones.
#[test]
fn no_dialect_takes_much_longer_than_plain_numbers() {
    const ROWS: u64 = 12_000;
    let time = |k: u64| 2e-3 * k as f64;
    let text = |heading: &str, row: &dyn Fn(u64) -> String| -> String {
        std::iter::once(heading.to_owned()).chain((0..ROWS).map(row)).collect::<Vec<_>>().join("\n")
    };
    let seconds_of = |text: &str, what: &str| {
        let once = || {
            let start = Instant::now();
            let recording = read(text, &Layout::default()).unwrap_or_else(|faults| panic!("{what}: {faults:?}"));
            assert_eq!(recording.time_s.len() as u64, ROWS, "{what}");
            start.elapsed().as_secs_f64()
        };
        (0..3).map(|_| once()).fold(f64::INFINITY, f64::min)
    };
    let plain = seconds_of(&text("t [s];q [deg]", &|k| format!("{:.3};{:.9}", time(k), position(k))), "plain");
    let nanoseconds = |k: u64| 1_700_000_000_000_000_000 + 2_000_000 * k;
    type Row<'r> = &'r dyn Fn(u64) -> String;
    let dialects: [(&str, &str, Row<'_>); 11] = [
        ("exponents", "t [s];q [deg]", &|k| format!("{:e};{:e}", time(k), position(k))),
        ("exponents in every second row", "t [s];q [deg]", &|k| match k % 2 {
            0 => format!("{:e};{:e}", time(k), position(k)),
            _ => format!("{:.3};{:.9}", time(k), position(k)),
        }),
        ("exponents in every hundredth row", "t [s];q [deg]", &|k| match k % 100 {
            0 => format!("{:e};{:e}", time(k), position(k)),
            _ => format!("{:.3};{:.9}", time(k), position(k)),
        }),
        ("nanoseconds", "t [ns];q [deg]", &|k| format!("{};{:.9}", nanoseconds(k), position(k))),
        ("spaces", "t [s]; q [deg]", &|k| format!("{:.3}; {:.9}", time(k), position(k))),
        ("signs", "t [s];q [deg]", &|k| format!("{:+.3};{:+.9}", time(k), position(k))),
        ("quotes", "t [s],q [deg]", &|k| format!("\"{:.3}\",\"{:.9}\"", time(k), position(k))),
        ("units", "t;q", &|k| format!("{:.3} s;{:.9} deg", time(k), position(k))),
        ("clock", "t;q [deg]", &|k| format!("10:00:{:02}.{:03};{:.9}", k / 500, (2 * k) % 1000, position(k))),
        ("more headings than cells", "t [s];q [deg];;", &|k| format!("{:.3};{:.9}", time(k), position(k))),
        ("the same in quotes", "\"t [s]\";\"q [deg]\";;", &|k| format!("\"{:.3}\";\"{:.9}\"", time(k), position(k))),
    ];
    for (what, heading, row) in dialects {
        let seconds = seconds_of(&text(heading, row), what);
        assert!(seconds < 15.0 * plain + 0.05, "{what}: {seconds:.3} s, plain numbers {plain:.3} s");
    }
}

/// A first line of units alone is refused with the columns by number, and read with them.
#[test]
fn a_heading_of_units_is_named() {
    for (heading, roles) in [
        ("s;deg;Nm", &[Role::Time, Role::Position, Role::Torque][..]),
        ("ms;rad", &[Role::Time, Role::Position]),
        ("[s];[1/min]", &[Role::Time, Role::Speed]),
        ("(s);(mm);(mm/s);(N)", &[Role::Time, Role::Position, Role::Speed, Role::Torque]),
    ] {
        let cells = heading.split(';').count() - 1;
        let rows: String = (0..5).map(|k| format!("{k}{}\n", format!(";{k}").repeat(cells))).collect();
        let text = format!("{heading}\n{rows}");
        let faults = read_csv(text.as_bytes(), &Layout::default()).unwrap_err();
        let [Fault::HeadingOfUnits { columns }] = faults.as_slice() else { panic!("{heading}: {faults:?}") };
        assert_eq!(columns.iter().map(|(role, ..)| *role).collect::<Vec<_>>(), roles, "{heading}");
        let spec = |role: Role| {
            let found = columns.iter().find(|(of, ..)| *of == role);
            let name = found.map(|(_, number, _)| format!("#{number}"));
            ColumnSpec { name, unit: found.map(|(.., unit)| *unit), ..ColumnSpec::default() }
        };
        let layout = Layout {
            time: spec(Role::Time),
            position: spec(Role::Position),
            speed: spec(Role::Speed),
            torque: spec(Role::Torque),
            ..Layout::default()
        };
        let recording = read_csv(text.as_bytes(), &layout).unwrap();
        assert_eq!((recording.time_s.len(), recording.columns.len()), (5, roles.len()), "{heading}");
    }
}

/// A unit that the project states does not say the factor of a heading, so that it would be dropped: the column is refused. A number
/// that is an index is none.
#[test]
fn a_stated_unit_drops_no_factor_of_a_heading() {
    let read = |heading: &str, unit| {
        let position = ColumnSpec { unit: Some(unit), ..ColumnSpec::default() };
        read(&format!("t [s],\"{heading}\"\n0,1\n1,2\n2,1\n"), &Layout { position, ..Layout::default() })
    };
    for text in ["0.001 deg", "1e-3 deg", "deg*10", "1/100 deg", "100 deg", "0,1 rad", "deg/10", "% rated", "1000mm"] {
        let found = read(&format!("q [{text}]"), &unit::DEGREE).unwrap_err();
        let is_it = |fault: &&Fault| matches!(fault.bare(), Fault::UnitScaled { .. });
        assert!(found.iter().any(|fault| is_it(&fault)), "{text}: {found:?}");
    }
    for text in ["inc", "pos", "axis 1", "LU", "1/x", "deg"] {
        assert!(read(&format!("q [{text}]"), &unit::DEGREE).is_ok(), "{text}");
    }
}
