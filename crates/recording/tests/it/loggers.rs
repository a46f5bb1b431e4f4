//! Files of loggers, controllers and spreadsheets: read correctly, or refused with the true reason.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use quantities::Measure;
use quantities::unit::{DEGREE, DEGREE_PER_SECOND, RADIAN, RADIAN_PER_SECOND, SECOND};
use recording::{
    ColumnSpec, Fault, FileRow, KnownBy, Layout, Memory, Recording, Role, preview_csv, read_csv, read_csv_within,
};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

fn read(text: &str) -> Recording {
    read_csv(text.as_bytes(), &Layout::default()).unwrap_or_else(|faults| panic!("{text}: {faults:?}"))
}

fn faults(text: &str) -> Vec<Fault> {
    read_csv(text.as_bytes(), &Layout::default()).unwrap_err()
}

fn named(name: &str) -> ColumnSpec {
    ColumnSpec { name: Some(name.to_owned()), ..ColumnSpec::default() }
}

fn near(found: &[f64], expected: &[f64]) -> bool {
    found.len() == expected.len() && found.iter().zip(expected).all(|(one, other)| (one - other).abs() < 1e-9)
}

fn degrees(recording: &Recording) -> Vec<f64> {
    recording.course.position.as_ref().unwrap().values.iter().map(|q| q.to_degrees()).collect()
}

/// One motion in many notations.
#[test]
fn every_way_of_writing_gives_the_same_samples() {
    let times = [0.0, 0.005, 0.01, 0.015];
    let positions = [0.0, 0.25, 1.5, 2.0];
    for text in [
        // Clock times with and without a date, also with the date in a column of its own, and past midnight.
        "timestamp,q [deg]\n2025-04-17T17:00:08.000,0\n2025-04-17T17:00:08.005,0.25\n2025-04-17T17:00:08.010,1.5\n2025-04-17T17:00:08.015,2\n",
        "timestamp [s],q [deg]\n2025-04-17T17:00:08.000Z,0\n2025-04-17T17:00:08.005Z,0.25\n2025-04-17T17:00:08.010Z,1.5\n2025-04-17T17:00:08.015Z,2\n",
        "Date,Time,q [deg]\n2026-01-01,10:30:20.000,0\n2026-01-01,10:30:20.005,0.25\n2026-01-01,10:30:20.010,1.5\n2026-01-01,10:30:20.015,2\n",
        "Zeit;Lage [Grad]\n17.04.2025 23:59:59,990;0,0\n17.04.2025 23:59:59,995;0,25\n18.04.2025 00:00:00,000;1,5\n18.04.2025 00:00:00,005;2,0\n",
        "time;q [deg]\n23:59:59.990;0\n23:59:59.995;0.25\n00:00:00.000;1.5\n00:00:00.005;2\n",
        // Times since 1970, in seconds and nanoseconds, in one column and in two.
        "t [s],q [deg]\n1700000000.600,0\n1700000000.605,0.25\n1700000000.610,1.5\n1700000000.615,2\n",
        "t [ns],q [deg]\n1700000000600000000,0\n1700000000605000000,0.25\n1700000000610000000,1.5\n1700000000615000000,2\n",
        "/js/stamp/sec,/js/stamp/nanosec,/js/position [deg]\n1700000000,990000000,0\n1700000000,995000000,0.25\n1700000001,0,1.5\n1700000001,5000000,2\n",
        "secs,nsecs,q [deg]\n5,990000000,0\n5,995000000,0.25\n6,0,1.5\n6,5000000,2\n",
        // Lines about the file before the heading, with and without as many cells as the table, and a row of units.
        "Recorder;bench\nSamples;4\n\nTime [s];Position [deg]\n0,000;0\n0,005;0,25\n0,010;1,5\n0,015;2\n",
        "Recorder;bench 4.2\nAxis;Rotary 1\nStart;12.03.2025 08:15:02\n\nTime [s];Position [deg];Status\n0.000;0;ok\n0.005;0.25;ok\n0.010;1.5;ok\n0.015;2;ok\n",
        "Recorder;workbench 4.2\nAxis;Rotary 1\nStart;12.03.2025 08:15:02\nSamples;4\n\nTime [s];Position [deg];Velocity [deg/s]\n0.000;0;0\n0.005;0.25;1\n0.010;1.5;1\n0.015;2;0\n",
        "t [s];a;b;q [deg]\n0,000;x;y;0\n0,005;x;y;0,25\n0,010;x;y;1,5\n0,015;x;y;2\n",
        "t [s];a;b;c;q [deg]\n0,000;x;y;z;0\n0,005;x;y;z;0,25\n0,010;x;y;z;1,5\n0,015;x;y;z;2\n",
        "Name,TwinCAT Scope\nFile,run.svdx\nStart,132\n\nTime,Axis1.ActPos,Axis1.Status,State\nms,°,,\n0,0,1,2\n5,0.25,1,2\n10,1.5,1,2\n15,2,1,2\n",
        "sep=;\nt [s];q [deg]\n0,000;0\n0,005;0,25\n0,010;1,5\n0,015;2\n",
        "\"sep=,\"\nt [s],q [deg]\n0.000,0\n0.005,0.25\n0.010,1.5\n0.015,2\n",
        "SEP=\t\nt [s]\tq [deg]\n0.000\t0\n0.005\t0.25\n0.010\t1.5\n0.015\t2\n",
        // Quoted decimal commas in a comma-separated file.
        "t [s],q [deg]\n\"0,000\",\"0,0\"\n\"0,005\",\"0,25\"\n\"0,010\",\"1,5\"\n\"0,015\",\"2,0\"\n",
        // An index in brackets, the unit in others.
        "Time [ms];Axis[1].ActPos [deg];Axis[1].State\n0;0;1\n5;0.25;1\n10;1.5;1\n15;2;1\n",
        "t [ms];q[2] [deg]\n0;0\n5;0.25\n10;1.5\n15;2\n",
        "Time [ms];r0482[0]: Position [deg]\n0;0\n5;0.25\n10;1.5\n15;2\n",
        "t (s) [actual],q (measured) {deg}\n0,0\n0.005,0.25\n0.010,1.5\n0.015,2\n",
        // One column of time next to each channel.
        "t [s],q [deg],t [s],M [Nm]\n0,0,0,1\n0.005,0.25,0.005,1\n0.010,1.5,0.010,1\n0.015,2,0.015,1\n",
        "t [msec],q [Deg]\n0,0\n5,0.25\n10,1.5\n15,2\n",
        // German compounds, with the mark before or behind the quantity, and Greek letters.
        "\u{feff}Zeitstempel [s];Istposition [°]\r\n0,000;0\r\n0,005;0,25\r\n0,010;1,5\r\n0,015;2\r\n",
        "Uhrzeit;Istlage [Grad];Sollposition [Grad]\n10:30:20,000;0;0\n10:30:20,005;0,25;0\n10:30:20,010;1,5;0\n10:30:20,015;2;0\n",
        "Zeit [ms];Lageistwert [°]\n0;0\n5;0,25\n10;1,5\n15;2\n",
        "Zeit [ms];Positionsistwert [°];Positionssollwert [°]\n0;0;1\n5;0,25;1\n10;1,5;1\n15;2;1\n",
        "Zeit in s;Drehwinkel in Grad\n0,000;0\n0,005;0,25\n0,010;1,5\n0,015;2\n",
        "t/s;φ/°\n0,000;0\n0,005;0,25\n0,010;1,5\n0,015;2\n",
        // Bars between the cells, aligned or not.
        "t [s]|q [deg]\n0.000|0\n0.005|0.25\n0.010|1.5\n0.015|2\n",
        "  t [ms] | q [deg] \n       0 |       0 \n       5 |    0,25 \n      10 |     1,5 \n      15 |       2 \n",
        // Every cell in quotes, with a row of units; an index column; a delimiter at the end of each line; exponents.
        "\"Zeit\";\"Winkel\"\n\"ms\";\"Grad\"\n\"0\";\"0,0\"\n\"5\";\"0,25\"\n\"10\";\"1,5\"\n\"15\";\"2\"\n",
        ",t [s],q [deg]\n0,0.000,0\n1,0.005,0.25\n2,0.010,1.5\n3,0.015,2\n",
        "t [s],q [deg],\n0.000,0,\n0.005,0.25,\n0.010,1.5,\n0.015,2,\n",
        "time [us],pos [deg]\n0.0e+00,0.0E0\n5.0e+03,2.5E-1\n1.0e+04,1.5E0\n1.5e+04,2.0E0\n",
        "Time,Position\n(ms),(deg)\n0,0\n5,0.25\n10,1.5\n15,2\n",
        "t [s],q [deg]\r0.000,0\r0.005,0.25\r0.010,1.5\r0.015,2\r",
        "MAIN.fbAxis[3].NcToPlc.ActPos [°];Time [ms]\n0;0\n0.25;5\n1.5;10\n2;15\n",
        "t [ms],q [deg]\n0,0\n5,0.25\n10,1.5\n15,2\n# end of recording\n",
    ] {
        let recording = read(text);
        assert!(near(&recording.time_s, &times), "{text}: {:?}", recording.time_s);
        assert!(near(&degrees(&recording), &positions), "{text}: {:?}", degrees(&recording));
    }
}

/// Speeds and torques, in the units of inch-pound and technical papers, and with the minus sign of print.
#[test]
fn every_way_of_writing_gives_the_same_torques() {
    for (heading, values) in [
        ("M [Nm]", ["-1,5", "0", "3"]),
        ("M [N·m]", ["−1,5", "0", "3"]),
        ("Lastmoment [Nm]", ["−1,5E0", "0", "3,0E+0"]),
        ("Drehmomentistwert [mNm]", ["-1500", "0", "3000"]),
        ("Momentenistwert [Ncm]", ["-150", "0", "300"]),
        // 1 lbf in = 0.112984829 N m, 1 ozf in a sixteenth of it, 1 kgf m = 9.80665 N m.
        ("torque [lb·in]", ["-13,27611868699", "0", "26,55223737398"]),
        ("torque [oz-in]", ["-212,41789899185", "0", "424,83579798370"]),
        ("torque [ft-lb]", ["-1,10634322392", "0", "2,21268644783"]),
        ("tau [kgf·m]", ["-0,15295743195", "0", "0,30591486389"]),
        ("Moment [kp cm]", ["-15,295743194668", "0", "30,591486389337"]),
    ] {
        let rows: Vec<String> = values.iter().enumerate().map(|(at, value)| format!("{at};{at};{value}\n")).collect();
        let text = format!("t [s];q [deg];{heading}\n{}", rows.concat());
        let torque = read(&text).torque.unwrap();
        assert!(near(&torque.values, &[-1.5, 0.0, 3.0]), "{text}: {:?}", torque.values);
    }
    for heading in ["Istdrehzahl [°/s]", "Drehzahlistwert [Grad/s]", "Winkelgeschwindigkeit [deg/s]", "ω/(°/s)"] {
        let speed = read(&format!("t [s];{heading}\n0;0\n1;180\n2;−90\n")).course.speed.unwrap();
        let turn = std::f64::consts::PI;
        assert!(near(&speed.values, &[0.0, turn, -turn / 2.0]), "{heading}: {:?}", speed.values);
    }
}

/// A table that is none by its delimiter is refused with that reason.
#[test]
fn a_delimiter_that_cannot_be_one_is_named() {
    for text in ["t[s]   q[deg]\n0.000  0.0\n0.005  0.25\n", "0.000 0.0\n0.005 0.25\n0.010 1.5\n"] {
        assert_eq!(faults(text), [Fault::SpacesOnly], "{text}");
    }
    let text = "t [s],q [deg],n [deg/s]\n0,000,0,000000,0,000000\n0,005,0,25,-1,0\n0,010,1,5,-2,0\n";
    let twice = |line| Fault::CommasTwice { line, found: 6, expected: 3 };
    assert_eq!(faults(text)[..3], [twice(2), twice(3), twice(4)]);
    // Cells too many without that reason.
    let text = "t [s],q [deg]\n0,0,a\n1,1\n2,2\n3,3\n";
    assert_eq!(faults(text), [Fault::Ragged { line: 2, found: 3, expected: 2 }]);
    let text = "t [s],q [deg]\n0.0,0.5,1.5\n1,1\n2,2\n3,3\n";
    assert_eq!(faults(text), [Fault::Ragged { line: 2, found: 3, expected: 2 }]);
}

#[test]
fn the_source_of_a_unit_is_named() {
    let recording = read("time,q [deg]\n10:00:00,0\n10:00:01,1\n10:00:02,2\n");
    assert_eq!((recording.columns[0].unit, recording.columns[0].known_by), (&SECOND, KnownBy::Values));
    let recording = read("a/sec,a/nanosec,q [deg]\n1,0,0\n1,5,1\n1,10,2\n");
    assert_eq!((recording.columns[0].unit, recording.columns[0].name.as_str()), (&SECOND, "a/sec + a/nanosec"));
}

/// Motion files of IDTA 02021, rotary and linear: unused columns are named.
#[test]
fn what_is_not_used_is_named() {
    let rotative = "Time [s];AngularPosition [rad];AngularVelocity [rad/s];AngularAcceleration [rad/s²];AngularJerk [rad/s³];FrictionTorque [Nm];LoadTorque [Nm]\n0;0;0;0;0;2;1\n1;1;1;0;0;2;1\n2;2;1;0;0;2;1\n";
    let recording = read(rotative);
    let units: Vec<_> = recording.columns.iter().map(|column| (column.role, column.unit.ascii)).collect();
    assert_eq!(units, [(Role::Time, "s"), (Role::Position, "rad"), (Role::Speed, "rad/s"), (Role::Torque, "N m")]);
    assert_eq!(recording.unused, ["AngularAcceleration [rad/s²]", "AngularJerk [rad/s³]", "FrictionTorque [Nm]"]);
    let linear = "Time [s];Position [m];LinearVelocity [m/s];LinearAcceleration [m/s²];FrictionForce [N];Force [N]\n0;0;0;0;20;100\n1;1;1;0;20;100\n2;2;1;0;20;100\n";
    let recording = read(linear);
    assert_eq!(recording.columns.len(), 4);
    assert_eq!(recording.unused, ["LinearAcceleration [m/s²]", "FrictionForce [N]"]);
    // TwinCAT's speed is recognised; a setpoint next to the measured position and a column with its unit in the row of
    // units are unused.
    let text = "Time;ActPos;SetPos;ActVelo;Temp;Counter\nms;°;°;°/s;°C;\n0;0;0;0;20;1\n1;1;1;1;20;2\n2;2;2;1;20;3\n";
    let recording = read(text);
    assert!(recording.course.speed.is_some());
    assert_eq!(recording.unused, ["SetPos", "Temp", "Counter"]);
    let none = Layout { speed: ColumnSpec { unused: true, ..ColumnSpec::default() }, ..Layout::default() };
    let recording = read_csv(text.as_bytes(), &none).unwrap();
    assert_eq!(recording.unused, ["SetPos", "Temp", "Counter"], "what the layout leaves out is no surprise");
}

#[test]
fn columns_are_named_by_their_numbers() {
    let text = "t [s],q [deg],q [deg]\n0,0,5\n1,1,6\n2,2,7\n";
    let found = faults(text);
    assert!(
        matches!(&found[0], Fault::Ambiguous { role: Role::Position, numbers, .. } if *numbers == [2, 3]),
        "{found:?}"
    );
    let layout = Layout { position: named("#3"), ..Layout::default() };
    assert!(near(&degrees(&read_csv(text.as_bytes(), &layout).unwrap()), &[5.0, 6.0, 7.0]));
    let beyond = Layout { position: named("#4"), ..Layout::default() };
    assert!(matches!(read_csv(text.as_bytes(), &beyond).unwrap_err()[0], Fault::ColumnUnknown { .. }));
    // A column with exactly this name is used.
    let odd = Layout { position: named("#1"), ..Layout::default() };
    assert!(near(&degrees(&read_csv(&b"t [s],#1 [deg]\n0,0\n1,1\n2,2\n"[..], &odd).unwrap()), &[0.0, 1.0, 2.0]));
}

#[test]
fn times_beside_each_channel_must_agree() {
    let text = "t [s],q [deg],t [s],n [deg/s]\n0,0,0,1\n1,1,1,1\n2,2,2.5,1\n3,3,3,1\n";
    let [Fault::TimesDiffer { at: FileRow::Line(4), numbers: [1, 3], .. }] = faults(text).as_slice() else {
        panic!("{:?}", faults(text))
    };
    let layout = Layout { time: named("#1"), ..Layout::default() };
    assert_eq!(*read_csv(text.as_bytes(), &layout).unwrap().time_s, [0.0, 1.0, 2.0, 3.0]);
    for name in ["t", "t [s]"] {
        let layout = Layout { time: named(name), ..Layout::default() };
        assert!(matches!(read_csv(text.as_bytes(), &layout).unwrap_err()[0], Fault::TimesDiffer { .. }), "{name}");
    }
}

#[test]
fn without_a_heading_numbers_and_units_are_needed() {
    let text = "0,0,0\n0.1,1,2\n0.2,2,3\n0.3,3,4\n";
    assert_eq!(faults(text), [Fault::HeadingMissing { columns: 3 }]);
    let of = |name: &str, unit| ColumnSpec { name: Some(name.to_owned()), unit: Some(unit), unused: false };
    let layout = Layout { time: of("#1", &SECOND), position: of("#3", &DEGREE), ..Layout::default() };
    let recording = read_csv(text.as_bytes(), &layout).unwrap();
    assert_eq!(*recording.time_s, [0.0, 0.1, 0.2, 0.3].map(|t: f64| t));
    assert!(near(&degrees(&recording), &[0.0, 2.0, 3.0, 4.0]));
}

#[test]
fn what_is_wrong_in_such_files_has_its_line() {
    let clock = "time,q [deg]\n10:00:00,0\n10:00:01,1\n10:00:61,2\nx,3\n10:00:04,4\n";
    let found = faults(clock);
    assert!(
        matches!(
            &found[..],
            [
                Fault::ValueUnreadable { at: FileRow::Line(4), .. },
                Fault::ValueUnreadable { at: FileRow::Line(5), text: None, .. }
            ]
        ),
        "{found:?}"
    );
    let nano = "sec,nanosec,q [deg]\n1,0,0\n1,1000000000,1\n2,-5,2\n3,0,2\n";
    assert_eq!(faults(nano).len(), 2, "{:?}", faults(nano));
    let backwards = "time,q [deg]\n2025-01-01 10:00:00,0\n2025-01-01 09:00:00,1\n2025-01-01 11:00:00,2\n";
    assert!(matches!(faults(backwards)[0].bare(), Fault::Backwards { at: FileRow::Line(3), .. }));
    // Columns without units say which are missing.
    let ros = "h/stamp/sec,h/stamp/nanosec,j3/position,j3/velocity\n1,0,0,0\n1,5,1,1\n1,9,2,1\n";
    let found = faults(ros);
    assert!(
        matches!(
            &found[..],
            [Fault::UnitMissing { role: Role::Position, .. }, Fault::UnitMissing { role: Role::Speed, .. }]
        ),
        "{found:?}"
    );
    let of = |unit| ColumnSpec { unit: Some(unit), ..ColumnSpec::default() };
    let layout = Layout { position: of(&RADIAN), speed: of(&RADIAN_PER_SECOND), ..Layout::default() };
    assert!(read_csv(ros.as_bytes(), &layout).is_ok());
    let other = Layout {
        position: of(&DEGREE),
        speed: of(&DEGREE_PER_SECOND),
        time: named("h/stamp/sec"),
        ..Layout::default()
    };
    assert_eq!(read_csv(ros.as_bytes(), &other).unwrap().time_s.len(), 3, "the nanoseconds belong to it");
}

#[test]
fn a_preview_begins_at_the_heading() {
    let found =
        preview_csv(&b"sep=;\nAxis;Rotary 1;;\nt;q [deg];mode;M\ns;;;Nm\n0,0;1,5;auto;2\n0,1;2;auto;3\n"[..], 2)
            .unwrap();
    let headings: Vec<&str> = found.columns.iter().map(|column| column.heading.as_str()).collect();
    assert_eq!(headings, ["t", "q [deg]", "mode", "M"]);
    assert_eq!(found.rows[1], ["0,0", "1,5", "auto", "2"]);
}

/// Faulty rows end the reading after some thousands, and cancellation ends it at once.
#[test]
fn reading_ends_where_nothing_new_is_to_be_found() {
    /// Source with a heading and endless equal rows; counts the bytes delivered.
    struct Endless<'c>(&'c std::cell::Cell<usize>);
    impl std::io::Read for Endless<'_> {
        fn read(&mut self, room: &mut [u8]) -> std::io::Result<usize> {
            let text = b"t [s],q [deg]\n".iter().chain(b"0.5,1.25\n".iter().cycle()).copied();
            let given = self.0.get();
            let (head, row) = (14, 9);
            let skipped = if given < head { given } else { head + (given - head) % row };
            room.iter_mut().zip(text.skip(skipped)).for_each(|(to, byte)| *to = byte);
            self.0.set(given + room.len());
            Ok(room.len())
        }
    }
    let given = std::cell::Cell::new(0);
    let found = read_csv(Endless(&given), &Layout::default()).unwrap_err();
    assert!(matches!(found[..], [Fault::Repeated { .. }, Fault::More { stopped: true, .. }]), "{found:?}");
    assert!(given.get() < 4 << 20, "{} bytes were read", given.get());

    let given = std::cell::Cell::new(0);
    let mut memory = Memory::default().until(Some(Arc::new(AtomicBool::new(true))));
    assert_eq!(read_csv_within(Endless(&given), &Layout::default(), &mut memory).unwrap_err(), [Fault::Stopped]);
}

/// Files of tools with headers of their own: read with the units that they state, or refused for want of them.
#[test]
fn the_headers_of_tools_are_understood() {
    let scope = |units: &str| {
        format!(
            "Name\tYT Scope Project\nFile\tC:\\axis.csv\nStarttime of export\t132959733843760000\tMontag, 2. Mai 2022\t15:56:24.376\n\n\n\
             Name\tAxis 1.ActPos\tName\tAxis 1.ActVelo\nSymbolComment\t\tSymbolComment\t\nData-Type\tREAL64\tData-Type\tREAL64\n\
             SampleTime[ms]\t2\tSampleTime[ms]\t2\nVariableSize\t8\tVariableSize\t8\nSymbolName\tMAIN.a\tSymbolName\tMAIN.b\n{units}\n\
             Unit Offset\t0\tUnit Offset\t0\n\n0\t0,0\t0\t0,0\n5\t0,25\t5\t1,0\n10\t1,5\t10\t2,0\n15\t2,0\t15\t0,0\nEOF\n"
        )
    };
    let recording = read(&scope("Unit\t° (Angle)\tUnit\t°/s (Angular velocity)"));
    assert!(near(&recording.time_s, &[0.0, 0.005, 0.01, 0.015]), "{:?}", recording.time_s);
    assert!(near(&degrees(&recording), &[0.0, 0.25, 1.5, 2.0]));
    let names: Vec<&str> = recording.columns.iter().map(|column| column.name.as_str()).collect();
    assert_eq!(names, ["Time [ms]", "Axis 1.ActPos [°]", "Axis 1.ActVelo [°/s]"]);
    let found = faults(&scope("Unit\t(None)\tUnit\t(None)"));
    assert!(
        matches!(found.as_slice(), [Fault::UnitMissing { column, .. }, Fault::UnitMissing { .. }] if column == "Axis 1.ActPos"),
        "{found:?}"
    );
    // One column of time for all channels, or one for each; in milliseconds, or as Windows counts.
    let layouts = |row: &dyn Fn(&str, [&str; 2]) -> String, times: [&str; 4]| {
        let properties = [("Name", ["Axis 1.ActPos", "Axis 1.ActVelo"]), ("Data-Type", ["REAL64"; 2])];
        let more = [("SampleTime[ms]", ["5"; 2]), ("Unit", ["deg", "deg/s"])];
        let head: String = properties.iter().chain(&more).map(|(name, cells)| row(name, *cells)).collect();
        let cells = [["0,0", "0,0"], ["0,25", "1,0"], ["1,5", "2,0"], ["2,0", "0,0"]];
        let rows: String = times.iter().zip(cells).map(|(time, cells)| row(time, cells)).collect();
        format!(
            "Name\tYT Scope Project\nStarttime of export\t133863912000000000\tFreitag\t10:00:00.000\n\n{head}\n{rows}"
        )
    };
    let one = |first: &str, [a, b]: [&str; 2]| format!("{first}\t{a}\t{b}\n");
    let each = |first: &str, [a, b]: [&str; 2]| format!("{first}\t{a}\t{first}\t{b}\n");
    let windows = ["133863912000000000", "133863912000050000", "133863912000100000", "133863912000150000"];
    for times in [["0", "5", "10", "15"], windows] {
        for text in [layouts(&one, times), layouts(&each, times)] {
            let recording = read(&text);
            assert!(near(&recording.time_s, &[0.0, 0.005, 0.01, 0.015]), "{:?}\n{text}", recording.time_s);
            assert!(near(&degrees(&recording), &[0.0, 0.25, 1.5, 2.0]), "{text}");
            let speed = recording.course.speed.unwrap();
            assert!(near(&speed.values, &[0.0, 1.0, 2.0, 0.0].map(f64::to_radians)), "{text}");
        }
    }
    // Channels of two samplings have different times in a row.
    let mixed = layouts(&each, ["0", "5", "10", "15"]).replace("\t5\t1,0", "\t10\t1,0");
    assert!(matches!(faults(&mixed).as_slice(), [Fault::TimesDiffer { numbers: [1, 3], .. }]));
    let plain: String = windows.iter().zip(["0", "1", "3", "4"]).map(|(time, q)| format!("{time};{q}\n")).collect();
    let recording = read(&format!("t [FILETIME];q [deg]\n{plain}"));
    assert!(near(&recording.time_s, &[0.0, 0.005, 0.01, 0.015]));
    let labview = "LabVIEW Measurement\t\nWriter_Version\t2\nSeparator\tTab\nDecimal_Separator\t,\nX_Columns\tOne\n\
         ***End_of_Header***\t\n\t\nChannels\t1\t\t\nSamples\t4\t\t\nY_Unit_Label\tdeg\t\t\nX_Dimension\tTime\t\t\n\
         X0\t0,0E+0\t\t\nDelta_X\t0,005\t\t\n***End_of_Header***\t\t\t\nX_Value\tPosition\tComment\n\
         0,000000\t0,0\t\n0,005000\t0,25\t\n0,010000\t1,5\t\n0,015000\t2,0\t\n";
    let found = faults(labview);
    assert!(found.iter().all(|fault| matches!(fault, Fault::UnitMissing { .. })) && found.len() == 2, "{found:?}");
    let of = |unit| ColumnSpec { unit: Some(unit), ..ColumnSpec::default() };
    let layout = Layout { time: of(&SECOND), position: of(&DEGREE), ..Layout::default() };
    let recording = read_csv(labview.as_bytes(), &layout).unwrap();
    assert!(near(&recording.time_s, &[0.0, 0.005, 0.01, 0.015]) && near(&degrees(&recording), &[0.0, 0.25, 1.5, 2.0]));
}

/// A position that begins anew after a turn and does not stay within one is no motion of a turn within one interval.
#[test]
fn a_position_that_begins_anew_after_a_turn_is_named() {
    for speeds in [false, true] {
        for step in [-3.1, 2.0, 20.0] {
            let head = if speeds { "t [ms],q [deg],n [deg/s]\n" } else { "t [ms],q [deg]\n" };
            let rows: String = (0..400)
                .map(|k| {
                    let turn = if k < 150 { 0.0 } else { 360.0_f64.copysign(step) };
                    let speed = if speeds { format!(",{}", step * 500.0) } else { String::new() };
                    format!("{},{:.5}{speed}\n", 2 * k, f64::from(k) * step - turn)
                })
                .collect();
            let found = faults(&(head.to_owned() + &rows));
            let [Fault::TurnBegun { has_speed, jump, .. }] = found.as_slice() else { panic!("{found:?}") };
            assert_eq!(*has_speed, speeds);
            assert!((jump.in_unit(&DEGREE).abs() - 360.0).abs() <= step.abs() + 1e-3, "{jump:?}");
        }
    }
    // Whole turns from sample to sample, or a turn that takes some samples, are motions.
    for text in [
        "t [s],q [deg]\n0,0\n1,360\n2,720\n3,1080\n4,1440\n".to_owned(),
        "t [s],q [deg]\n0,0\n1,10\n2,130\n3,250\n4,360\n5,361\n".to_owned(),
    ] {
        assert!(read_csv(text.as_bytes(), &Layout::default()).is_ok(), "{text}");
    }
}

/// The line that a message proposes can be written as it stands, however long a name is.
#[test]
fn a_column_with_a_long_name_is_proposed_by_its_number() {
    let text =
        format!("t [s],{} [deg]\n0,0\n1,1\n2,2\n", "Antriebsachse_1.technologischer Wert nach dem Filter".repeat(2));
    let found = faults(&text);
    let [Fault::CourseMissing { near, .. }] = found.as_slice() else { panic!("{found:?}") };
    assert_eq!(near[0].column, "#2");
    let layout = Layout { position: named(&near[0].column), ..Layout::default() };
    assert!(read_csv(text.as_bytes(), &layout).is_ok());
    // Of a name that is almost one of the file, and of several that could be meant.
    let long = "Antriebsachse_1.r61[0]: Drehzahlistwert des Umrichters";
    let text = format!("t [s],{long} [1/min]\n0,0\n1,1\n2,2\n");
    let layout = Layout { speed: named(&long.replace("Umrichters", "Umrichter")), ..Layout::default() };
    let found = read_csv(text.as_bytes(), &layout).unwrap_err();
    assert!(
        matches!(found.as_slice(), [Fault::ColumnUnknown { nearest: Some(nearest), .. }] if nearest == "#2"),
        "{found:?}"
    );
    let text = "t [s],Antriebsachse_1_des_ersten_Gelenks/Position [deg],Antriebsachse_2_des_ersten_Gelenks/Position [deg]\n0,0,0\n1,1,1\n2,2,2\n";
    let found = faults(text);
    assert!(matches!(found.as_slice(), [Fault::Ambiguous { columns, .. }] if columns == &["#2", "#3"]), "{found:?}");
}

/// Time and torque differ in case only; their units tell them apart, in the name or in a row below.
#[test]
fn names_that_differ_in_case_only_are_told_apart_by_their_units() {
    for text in [
        "t / s;phi / °;T / Nm\n0;0;1\n0,1;2;1\n0,2;4;1\n",
        "t;phi;T\ns;°;Nm\n0;0;1\n0,1;2;1\n0,2;4;1\n",
        "T / Nm;phi / °;t / s\n1;0;0\n1;2;0,1\n1;4;0,2\n",
    ] {
        let read = recording::read_csv(text.as_bytes(), &recording::Layout::default()).unwrap();
        assert_eq!(*read.time_s, [0.0, 0.1, 0.2], "{text}");
        assert_eq!(*read.torque.unwrap().values, [1.0; 3], "{text}");
    }
}
