//! CSV that is read, and CSV that is refused, with the words of the fault.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use quantities::unit::{DEGREE, NEWTON_METRE, RADIAN, REVOLUTION_PER_MINUTE, SECOND};
use quantities::{Dimension, Measure, Time};
use recording::{
    Along, ColumnSpec, FAULTS_MAX, Fault, FileRow, KnownBy, LINE_BYTES_MAX, Layout, Recording, Role, read_csv,
};
use std::io::{Error, ErrorKind, Read};

fn read(text: &str) -> Recording {
    read_csv(text.as_bytes(), &Layout::default()).unwrap()
}

fn faults(text: &str) -> Vec<Fault> {
    faults_with(text, &Layout::default())
}

fn faults_with(text: &str, layout: &Layout) -> Vec<Fault> {
    read_csv(text.as_bytes(), layout).unwrap_err().iter().map(Fault::bare).cloned().collect()
}

fn named(name: &str) -> ColumnSpec {
    ColumnSpec { name: Some(name.to_owned()), ..ColumnSpec::default() }
}

fn unused() -> ColumnSpec {
    ColumnSpec { unused: true, ..ColumnSpec::default() }
}

fn position(recording: &Recording) -> &[f64] {
    &recording.course.position.as_ref().unwrap().values
}

#[test]
fn commas_semicolons_and_tabs_separate() {
    for text in [
        "t [s],q [rad]\n0,1.5\n0.5,2\n1,3\n",
        "t [s];q [rad]\n0;1.5\n0.5;2\n1;3\n",
        "t [s];q [rad]\n0;1,5\n0,5;2\n1;3\n",
        "t [s]\tq [rad]\n0\t1,5\n0,5\t2\n1\t3",
        "\u{feff}t [s];q [rad]\r\n0;1.5\r\n0.5;2\r\n1;3\r\n",
        "# logger 7\n\nt [s],\"q [rad]\"\n# begin\n0,\"1.5\"\n\n0.5, 2 \n1,3\n\n# end",
        "t;q\ns;rad\n0;1,5\n5e-1;+2\n1;3",
        "t,q\n[s],(rad)\n0,1.5\n0.5,2\n1,3",
    ] {
        let recording = read(text);
        assert_eq!(*recording.time_s, [0.0, 0.5, 1.0], "{text}");
        assert_eq!(position(&recording), [1.5, 2.0, 3.0], "{text}");
        assert_eq!(recording.course.speed, None);
        assert_eq!(recording.torque, None);
    }
}

#[test]
fn every_usual_name_is_recognised_in_any_case() {
    for role in Role::ALL {
        for name in role.names() {
            for name in [(*name).to_owned(), name.to_uppercase()] {
                let unit = role.dimensions()[0].units()[0].ascii;
                let others = match role {
                    Role::Time => "position [rad],zz",
                    _ => "time [s],position [rad]",
                };
                let text = if role == Role::Position {
                    format!("time [s],zz,{name} [{unit}]\n0,0,0\n1,1,1\n2,2,2\n")
                } else {
                    format!("{others},{name} [{unit}]\n0,0,0\n1,1,1\n2,2,2\n")
                };
                let recording = read(&text);
                let column = recording.columns.iter().find(|column| column.role == role).unwrap();
                assert_eq!(column.name, format!("{name} [{unit}]"));
            }
        }
    }
}

#[test]
fn a_unit_is_known_from_header_row_or_layout() {
    let layout =
        Layout { torque: ColumnSpec { unit: Some(&NEWTON_METRE), ..ColumnSpec::default() }, ..Layout::default() };
    let text = "t [ms],n,M\n,1/min,\n0,60,1\n1,60,2\n2,60,3\n";
    let recording = read_csv(text.as_bytes(), &layout).unwrap();
    let known: Vec<KnownBy> = recording.columns.iter().map(|column| column.known_by).collect();
    assert_eq!(known, [KnownBy::Header, KnownBy::UnitRow, KnownBy::Layout]);
    assert_eq!(*recording.time_s, [0.0, 1e-3, 2e-3]);
    let speed = recording.course.speed.unwrap();
    assert!((speed.values[0] - std::f64::consts::TAU).abs() < 1e-12);
    assert_eq!((speed.along, recording.torque.unwrap().along), (Along::Turning, Along::Turning));
}

#[test]
fn lengths_and_forces_are_along_a_line() {
    let recording = read("t [us],weg [mm],v [mm/s],F [N]\n0,1,2,3\n1,1,2,3\n2,1,2,3\n");
    assert_eq!(recording.course.position.unwrap().along, Along::Line);
    assert_eq!(*recording.course.speed.unwrap().values, [0.002; 3]);
    assert_eq!(recording.torque.unwrap().along, Along::Line);
    assert!((recording.time_s[2] - 2e-6).abs() < 1e-20);
}

#[test]
fn times_in_any_unit_are_relative_to_the_first() {
    let recording =
        read("timestamp [ns],q [deg]\n1699999999123456789,0\n1699999999124456789,1\n1699999999125456790,2\n");
    assert!((recording.time_s[1] - 1e-3).abs() < 1e-18);
    assert!((recording.time_s[2] - 2.000_001e-3).abs() < 1e-18);
    assert!((recording.first_time.si() - 1_699_999_999.123_456_7).abs() < 1e-6);
}

#[test]
fn the_layout_names_columns_and_leaves_roles_out() {
    let text = "stamp,q,q_soll [deg],m\n0,a,1,auto\n1,b,2,auto\n2,c,3,hand\n";
    let layout = Layout {
        time: ColumnSpec { name: Some(String::from("stamp")), unit: Some(&SECOND), unused: false },
        position: named("Q_SOLL"),
        torque: unused(),
        ..Layout::default()
    };
    let recording = read_csv(text.as_bytes(), &layout).unwrap();
    assert!((position(&recording)[2] - 3f64.to_radians()).abs() < 1e-15);
    assert_eq!(recording.columns[1].name, "q_soll [deg]");
}

#[test]
fn a_column_that_does_not_exist_is_reported_with_the_nearest() {
    let layout = Layout { position: named("angel"), ..Layout::default() };
    let found = faults_with("t [s],angle_out [deg],Angle [deg]\n0,1,1\n", &layout);
    let [Fault::ColumnUnknown { role: Role::Position, name, nearest, headers }] = found.as_slice() else {
        panic!("{found:?}")
    };
    assert_eq!((name.as_str(), nearest.as_deref(), headers.len()), ("angel", Some("Angle [deg]"), 3));
}

#[test]
fn a_column_has_one_role() {
    let layout = Layout { time: named("t"), position: named("t"), ..Layout::default() };
    let found = faults_with("t [s],q [deg]\n0,1\n", &layout);
    assert!(matches!(found.as_slice(), [Fault::ColumnTwice { .. }]), "{found:?}");
}

#[test]
fn missing_roles_are_reported_with_the_headers() {
    let found = faults("a,b\n1,2\n");
    let [Fault::TimeMissing { headers, .. }, Fault::CourseMissing { .. }] = found.as_slice() else {
        panic!("{found:?}")
    };
    assert_eq!(headers, &["a", "b"]);
    assert_eq!(faults(""), [Fault::NoHeader]);
    assert_eq!(faults("# nothing\n\n"), [Fault::NoHeader]);
}

#[test]
fn two_columns_for_one_role_are_ambiguous() {
    let found = faults("t [s],q [deg],pos [deg]\n0,1,1\n");
    let columns = vec![String::from("q [deg]"), String::from("pos [deg]")];
    assert_eq!(found, [Fault::Ambiguous { role: Role::Position, columns, numbers: vec![2, 3] }]);
}

#[test]
fn every_fault_of_a_unit_is_reported_at_once() {
    let layout = Layout { speed: ColumnSpec { unit: Some(&RADIAN), ..ColumnSpec::default() }, ..Layout::default() };
    let found = faults_with("t,q [grad],n,M [deg]\n0,1,2,3\n", &layout);
    let [
        Fault::UnitMissing { role: Role::Time, .. },
        Fault::UnitUnknown { role: Role::Position, text, by: KnownBy::Header, nearest, .. },
        Fault::UnitWrong { role: Role::Speed, by: KnownBy::Layout, .. },
        Fault::UnitWrong { role: Role::Torque, unit, .. },
    ] = found.as_slice()
    else {
        panic!("{found:?}")
    };
    assert_eq!((text.as_str(), *unit), ("grad", &DEGREE));
    // A gon is no radian: no unit that would change the value is proposed.
    assert_eq!(*nearest, None);
}

#[test]
fn a_misspelt_unit_has_a_neighbour_in_either_kind() {
    for (header, near) in [("n [1/mim]", "1/min"), ("v [mm/mim]", "mm/min"), ("n [rac/s]", "rad/s")] {
        let found = faults(&format!("t [s],{header}\n0,1\n"));
        let [Fault::UnitUnknown { nearest, .. }] = found.as_slice() else { panic!("{found:?}") };
        assert_eq!(nearest.map(|unit| unit.ascii), Some(near));
    }
    let found = faults("t,q\nsecx,Gdr\n0,1\n");
    assert!(matches!(found.as_slice(), [Fault::UnitUnknown { by: KnownBy::UnitRow, .. }, Fault::UnitUnknown { .. }]));
}

#[test]
fn two_statements_of_a_unit_must_agree() {
    assert_eq!(read("t [s],n [rpm]\ns,1/min\n0,1\n1,2\n2,3\n").columns[1].unit, &REVOLUTION_PER_MINUTE);
    let found = faults("t [s],q [rad]\ns,deg\n0,1\n");
    let column = String::from("q [rad]");
    let (units, by) = ([&RADIAN, &DEGREE], [KnownBy::Header, KnownBy::UnitRow]);
    assert_eq!(found, [Fault::UnitContradiction { column, units, by }]);
}

#[test]
fn position_and_speed_belong_together() {
    let text = "t [s],x [mm],n [1/min]\n0,1,2\n1,1,2\n2,1,2\n";
    let mixed = Fault::CourseMixed { position: Dimension::Length, speed: Dimension::AngularVelocity };
    assert_eq!(faults(text), [mixed]);
    let layout = Layout { speed: unused(), ..Layout::default() };
    assert_eq!(read_csv(text.as_bytes(), &layout).unwrap().columns.len(), 2);
}

#[test]
fn every_bad_cell_is_reported_with_its_line() {
    let text = "t [s],q [deg]\n0,1\n# note\n1,\n2,x1\n3,nan\n4,1e999\n5,1,2\n6\n,7\n8,\"9\n";
    let (column, at) = (|| String::from("q [deg]"), FileRow::Line);
    assert_eq!(
        faults(text),
        [
            Fault::ValueMissing { at: at(4), column: column() },
            Fault::ValueUnreadable { at: at(5), column: column(), text: None },
            Fault::ValueNotFinite { at: at(6), column: column(), text: String::from("nan") },
            Fault::ValueNotFinite { at: at(7), column: column(), text: String::from("1e999") },
            Fault::Ragged { line: 8, found: 3, expected: 2 },
            Fault::Ragged { line: 9, found: 1, expected: 2 },
            Fault::ValueMissing { at: at(10), column: String::from("t [s]") },
            Fault::QuoteOpen { line: 11 },
        ]
    );
    let long = faults(&format!("t [s],q [deg]\n0,{}\n", "1x".repeat(250).replace('x', "-")));
    let [Fault::ValueUnreadable { text: Some(text), .. }] = long.as_slice() else { panic!("{long:?}") };
    assert_eq!(text.chars().count(), 41);
}

#[test]
fn a_value_too_large_for_si_is_refused() {
    let found = faults("t [s],n [rev/s]\n0,1\n1,2\n2,1e308\n");
    assert!(matches!(found.as_slice(), [Fault::ValueImplausible { at: FileRow::Line(4), .. }]), "{found:?}");
    let found = faults("t [d],q [deg]\n0,1\n1e306,2\n2e306,3\n");
    assert!(matches!(found.as_slice(), [Fault::ValueImplausible { at: FileRow::Line(3), .. }, _]), "{found:?}");
    let found = faults("t [s],q [deg]\n-1e308,1\n0,2\n1e308,3\n");
    let [Fault::ValueImplausible { at, .. }, Fault::ValueImplausible { .. }] = found.as_slice() else {
        panic!("{found:?}")
    };
    assert_eq!(*at, FileRow::Line(2));
}

#[test]
fn one_decimal_sign_holds_for_a_file() {
    let mixed = |line, text: &str, decided| {
        let column = String::from("q [deg]");
        Fault::DecimalMixed { line, column, text: text.to_owned(), decided }
    };
    assert_eq!(faults("t [s];q [deg]\n0;1,5\n1;1.500\n2;3\n"), [mixed(3, "1.500", 2)]);
    assert_eq!(faults("t [s];q [deg]\n0.5;1\n1;1,5\n2;3\n"), [mixed(3, "1,5", 2)]);
    let found = faults("t [s];q [deg]\n0;1.000,5\n1;1,5\n2;3\n");
    assert!(matches!(found.as_slice(), [Fault::ThousandsGrouped { at: FileRow::Line(2), .. }]));
}

#[test]
fn time_rises() {
    let found = faults("t [ms],q [deg]\n0,1\n2,1\n1,1\n3,1\n3,1\n4,1\n");
    let [
        Fault::Backwards { at: FileRow::Line(4), time, before },
        Fault::SameTime { at: FileRow::Line(6), first: FileRow::Line(5), time: same },
    ] = found.as_slice()
    else {
        panic!("{found:?}")
    };
    assert_eq!((time.to_string(), before.to_string(), same.to_string()), ("1 ms".into(), "2 ms".into(), "3 ms".into()));
}

/// Ten intervals are no gap in any unit, from any start; eleven are one.
#[test]
fn a_gap_of_exactly_ten_intervals_is_none() {
    for (unit, decimals) in [("s", 6), ("ms", 3), ("s", 4), ("min", 6)] {
        for start in [0.0, 0.1, 12.3, 4567.8, 1_700_000_000.0] {
            for interval in [0.001_f64, 0.002, 0.003, 0.007] {
                for (factor, is_gap) in [(10.0, false), (11.0, true)] {
                    let (mut time, mut text) = (start, format!("t [{unit}],q [deg]\n"));
                    for row in 0..60 {
                        text += &format!("{time:.decimals$},1\n");
                        time += interval * if row % 3 == 2 { factor } else { 1.0 };
                    }
                    let layout = Layout::default();
                    let found = read_csv(text.as_bytes(), &layout).err();
                    let is_a_gap = |fault: &Fault| match fault {
                        Fault::Repeated { first, .. } => matches!(**first, Fault::Gap { .. }),
                        fault => matches!(fault, Fault::Gap { .. }),
                    };
                    let has_gap = found.iter().flat_map(|found| found.iter().map(Fault::bare)).any(is_a_gap);
                    assert_eq!(has_gap, is_gap, "{unit} from {start}, {interval}: {found:?}");
                }
            }
        }
    }
}

#[test]
fn a_gap_is_reported_and_can_be_allowed() {
    let text = "t [ms],q [deg]\n0,1\n1,1\n# pause\n2,1\n13,1\n23,1\n24,1\n25,1\n";
    let found = faults(text);
    let [Fault::Gap { at: FileRow::Line(6), length, median }] = found.as_slice() else { panic!("{found:?}") };
    assert!((length.si() - 11e-3).abs() < 1e-15 && (median.si() - 1e-3).abs() < 1e-15, "ten times is none yet");
    let layout = Layout { allow_gaps: true, ..Layout::default() };
    assert_eq!(read_csv(text.as_bytes(), &layout).unwrap().time_s.len(), 7);
}

#[test]
fn a_window_keeps_what_lies_in_it() {
    let text = "t [ms],q [deg]\n1098,0\n1099,bad\n1100,1\n1101,2\n1102,3\n1103,4\n1900,\n";
    let seconds = |value| Some(Time::from_si(value));
    let layout = Layout { from: seconds(1.1), to: seconds(1.103), ..Layout::default() };
    let recording = read_csv(text.as_bytes(), &layout).unwrap();
    assert_eq!(recording.time_s.len(), 4);
    assert_eq!((recording.left_out_before, recording.left_out_after), (2, 1));
    assert!((recording.first_time.si() - 1.1).abs() < 1e-15);

    let late = Layout { from: seconds(5.0), ..Layout::default() };
    let found = faults_with(text, &late);
    let [Fault::TooFewSamples { found: 0, outside: 7, span: Some([first, last]), .. }] = found.as_slice() else {
        panic!("{found:?}")
    };
    assert_eq!((first.value, last.value), (1098.0, 1900.0));

    let reversed = Layout { from: seconds(2.0), to: seconds(1.0), ..Layout::default() };
    assert!(matches!(faults_with(text, &reversed).as_slice(), [Fault::WindowReversed { .. }]));

    let order = Layout { to: seconds(1.0), ..Layout::default() };
    assert!(matches!(faults_with("t [s],q [deg]\n5,1\n4,1\n", &order).as_slice(), [Fault::Backwards { .. }]));
}

#[test]
fn two_samples_are_no_recording() {
    let found = faults("t [s],q [deg]\n0,1\n1,2\n");
    assert!(matches!(found.as_slice(), [Fault::TooFewSamples { found: 2, least: 3, outside: 0, .. }]));
    assert!(matches!(faults("t [s],q [deg]\n").as_slice(), [Fault::TooFewSamples { found: 0, span: None, .. }]));
}

#[test]
fn equal_faults_are_reported_once_with_their_number() {
    let rows = |count: usize| (0..count).map(|line| format!("{line};1.234,5;x\n")).collect::<String>();
    let head = "t [s];q [deg];M [Nm]\n";
    assert_eq!(faults(&format!("{head}{}", rows(3))).len(), 6, "three of each are given one by one");
    let found = faults(&format!("{head}{}", rows(80)));
    let [Fault::Repeated { first, more: 79 }, Fault::Repeated { first: second, more: 79 }] = found.as_slice() else {
        panic!("{found:?}")
    };
    assert!(matches!(first.as_ref(), Fault::ThousandsGrouped { at: FileRow::Line(2), column, text }
        if column == "q [deg]" && text == "1.234,5"));
    assert!(matches!(second.as_ref(), Fault::ValueUnreadable { at: FileRow::Line(2), .. }));
    // Reading stops after ten thousand faults.
    let found = faults(&format!("{head}{}", rows(20_000)));
    assert_eq!(found.last(), Some(&Fault::More { count: 0, stopped: true }));
    assert_eq!(found.len(), 3);
}

#[test]
fn many_different_faults_are_capped() {
    let columns = 2 * FAULTS_MAX;
    let head: String = (0..columns).map(|column| format!(",c{column}")).collect();
    let found = read_csv(format!("t [s],q [deg]{head}\n0\n").as_bytes(), &Layout::default()).unwrap_err();
    assert!(matches!(found.as_slice(), [Fault::Ragged { .. }]), "{found:?}");
    // Times that run backwards are one kind of fault for any column.
    let text: String = (0..100).map(|line| format!("{},1\n", 100 - line)).collect();
    let found = faults(&format!("t [s],q [deg]\n{text}"));
    assert!(matches!(found.as_slice(), [Fault::Repeated { more: 98, .. }]), "{found:?}");
}

#[test]
fn latin_1_and_utf_16_are_read() {
    let text = "Zeit [s];Straße;ψ;Winkel [°]\n0;ä;0;1,5\n1;ö;0;2,5\n2;ü;0;3,5\n";
    let expected = read_csv(text.as_bytes(), &Layout::default()).unwrap().course.position.unwrap();
    let latin: Vec<u8> = text.replace('ψ', "k").chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect();
    assert!(std::str::from_utf8(&latin).is_err());
    let units: Vec<u16> = [0xfeff].into_iter().chain(text.encode_utf16()).collect();
    let little: Vec<u8> = units.iter().flat_map(|unit| unit.to_le_bytes()).collect();
    let big: Vec<u8> = units.iter().flat_map(|unit| unit.to_be_bytes()).collect();
    for bytes in [latin, little, big] {
        let found = read_csv(bytes.as_slice(), &Layout::default()).unwrap();
        assert_eq!(found.course.position.unwrap(), expected);
    }
    // A row of units in Latin-1.
    let units = b"t;q\ns;\xb0\n0;1\n1;2\n2;3\n".as_slice();
    assert!(read_csv(units, &Layout::default()).is_ok());
    let text = b"t [s],where,q [deg]\n0,Stra\xdfe,2\n1,,3\n2,,4\n".as_slice();
    assert!(read_csv(text, &Layout::default()).is_ok(), "a column that is not in use holds what it likes");
    let cell = read_csv(b"t [s],q [deg]\n0,\xb5\n".as_slice(), &Layout::default()).unwrap_err();
    assert!(matches!(cell.as_slice(), [Fault::ValueUnreadable { .. }]));
}

#[test]
fn a_line_is_of_bounded_length() {
    let header = "t [s],q [deg],note\n";
    let row = |length: usize| format!("0,1,{}\n1,1,\n2,1,\n", "y".repeat(length));
    assert!(read_csv((header.to_owned() + &row(LINE_BYTES_MAX - 4)).as_bytes(), &Layout::default()).is_ok());
    for length in [LINE_BYTES_MAX - 3, 10 * LINE_BYTES_MAX] {
        let found = faults(&(header.to_owned() + &row(length)));
        assert_eq!(found, [Fault::LineTooLong { line: 2, most: LINE_BYTES_MAX }]);
    }
}

/// Source that delivers one byte at a time, is interrupted in between, and breaks off.
struct Broken<'a>(&'a [u8], bool);

impl Read for Broken<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        self.1 = !self.1;
        if self.1 {
            return Err(Error::from(ErrorKind::Interrupted));
        }
        let Some((first, rest)) = self.0.split_first() else { return Err(Error::from(ErrorKind::ConnectionReset)) };
        buffer[0] = *first;
        self.0 = rest;
        Ok(1)
    }
}

#[test]
fn a_source_that_breaks_off_is_reported() {
    let found = read_csv(Broken(b"t [s],q [deg]\n0,1\n1,", false), &Layout::default()).unwrap_err();
    assert_eq!(found, [Fault::ReadFailed { line: 3, kind: ErrorKind::ConnectionReset }]);
}

/// Source of endless samples at 1 kHz, generated while they are read.
struct Logger {
    sample: u64,
    samples: u64,
    line: Vec<u8>,
    given: usize,
}

impl Read for Logger {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        if self.given == self.line.len() {
            if self.sample == self.samples {
                return Ok(0);
            }
            self.line = format!("{},{},text\n", self.sample, self.sample % 7).into_bytes();
            self.sample += 1;
            self.given = 0;
        }
        let count = buffer.len().min(self.line.len() - self.given);
        buffer[..count].copy_from_slice(&self.line[self.given..self.given + count]);
        self.given += count;
        Ok(count)
    }
}

#[test]
fn a_small_window_in_a_long_file_keeps_little() {
    let logger = Logger { sample: 0, samples: 1_000_000, line: b"t [ms],q [deg],note\n".to_vec(), given: 0 };
    let (from, to) = (Some(Time::from_si(500.0)), Some(Time::from_si(500.099)));
    let recording = read_csv(logger, &Layout { from, to, ..Layout::default() }).unwrap();
    assert_eq!((recording.left_out_before, recording.left_out_after), (500_000, 499_900));
    assert_eq!(recording.time_s.len(), 100);
    assert!(recording.time_s.capacity() <= 256);
    assert!(recording.course.position.unwrap().values.capacity() <= 256);
}

#[test]
fn files_of_python_are_read() {
    for bytes in [include_bytes!("../data/python_excel.csv").as_slice(), include_bytes!("../data/pandas_german.csv")] {
        let recording = read_csv(bytes, &Layout::default()).unwrap();
        assert_eq!(recording.time_s.len(), 200);
        assert_eq!(recording.first_time.si(), 5.0);
        let torque = &recording.torque.as_ref().unwrap().values;
        for (k, time) in recording.time_s.iter().enumerate() {
            let phase = std::f64::consts::TAU * 5.0 * k as f64 / 1000.0;
            assert!((time - k as f64 / 1000.0).abs() < 1e-12);
            assert!((position(&recording)[k] - (90.0 * (1.0 - phase.cos())).to_radians()).abs() < 1e-9);
            assert!((torque[k] - (3.0 + 2.0 * phase.sin())).abs() < 1e-9);
        }
    }
}

/// Headings of loggers, oscilloscopes and spreadsheets.
#[test]
fn headings_are_recognised_as_they_come() {
    for (text, named) in [
        ("time_s,position_deg\n0,0\n1,90\n2,180\n", ["time_s", "position_deg"]),
        ("t[ms];Winkel (°)\n0;0\n1000;90\n2000;180\n", ["t[ms]", "Winkel (°)"]),
        ("Zeit (s)\tpos / °\n0\t0\n1\t90\n2\t180\n", ["Zeit (s)", "pos / °"]),
        ("Zeit;Ist-Winkel\n[ms];[deg]\n0;0,0\n1000;90,0\n2000;180,0\n", ["Zeit", "Ist-Winkel"]),
        (
            "MAIN.t_s,Axis1.SetPos [deg],Axis1.ActPos [deg]\n0,7,0\n1,7,90\n2,7,180\n",
            ["MAIN.t_s", "Axis1.ActPos [deg]"],
        ),
        ("t_s,joint_1/q_rev\n0,0\n1,0.25\n2,0.5\n", ["t_s", "joint_1/q_rev"]),
    ] {
        let recording = read(text);
        let names: Vec<&str> = recording.columns.iter().map(|column| column.name.as_str()).collect();
        assert_eq!(names, named, "{text}");
        assert_eq!(*recording.time_s, [0.0, 1.0, 2.0], "{text}");
        assert!((position(&recording)[1] - std::f64::consts::FRAC_PI_2).abs() < 1e-15, "{text}");
    }
    // Latin-1 and UTF-16, as spreadsheets write them.
    let german = "Zeit (s);Ist-Lage [°];Größe\n0;0;ä\n1;90;ö\n2;180;ü\n";
    let latin: Vec<u8> = german.chars().map(|sign| u8::try_from(u32::from(sign)).unwrap()).collect();
    let wide: Vec<u8> = german.encode_utf16().flat_map(u16::to_le_bytes).collect();
    for bytes in [latin, wide] {
        let recording = read_csv(bytes.as_slice(), &Layout::default()).unwrap();
        assert_eq!(recording.columns[1].name, "Ist-Lage [°]");
    }
}

/// Two joints: the intended one is not guessed.
#[test]
fn several_columns_of_one_sureness_are_ambiguous() {
    let found = faults("t [s],q1 [deg],q2 [deg]\n0,0,0\n1,1,1\n2,2,2\n");
    assert!(matches!(found.as_slice(), [Fault::Ambiguous { role: Role::Position, columns, .. }] if columns.len() == 2));
    let layout = Layout { position: named("q2"), ..Layout::default() };
    let recording = read_csv(&b"t [s],q1 [deg],q2_deg\n0,0,0\n1,1,2\n2,2,4\n"[..], &layout).unwrap();
    assert!((position(&recording)[2] - 4f64.to_radians()).abs() < 1e-15);
}

#[test]
fn a_near_miss_is_proposed() {
    let found = faults("Zeitpunkt,angel,M [Nm]\n0,0,1\n1,1,1\n2,2,1\n");
    let [Fault::TimeMissing { near: time, .. }, Fault::CourseMissing { near: course, .. }] = found.as_slice() else {
        panic!("{found:?}")
    };
    assert!(time.len() == 1 && time[0].column == "Zeitpunkt" && !time[0].has_unit, "{time:?}");
    assert!(course[0].column == "angel" && course[0].role == Role::Position, "{course:?}");
    let found = faults("Zeitpunkt;Weg\nms;mm\n0;0\n1;1\n2;2\n");
    let [Fault::TimeMissing { near, .. }] = found.as_slice() else { panic!("{found:?}") };
    assert!(near[0].has_unit, "the row of units states it");
    let found = faults("Channel 1 [ms],Channel 2 [deg]\n0,0\n1,1\n2,2\n");
    let [Fault::TimeMissing { near: time, .. }, Fault::CourseMissing { near: course, .. }] = found.as_slice() else {
        panic!("{found:?}")
    };
    assert!(time[0].column == "Channel 1 [ms]" && time[0].has_unit && course[0].has_unit, "{found:?}");
}

/// Text of a file that is no table of numbers may be a note or a key and is not quoted.
#[test]
fn the_content_of_what_is_no_table_is_not_repeated() {
    for text in [
        "hunter2\n",
        "hunter2",
        "user;secret\nme;hunter2\nyou;hunter2\n",
        "a secret, long\nand hunter2, longer\nline\n",
    ] {
        assert_eq!(faults(text), [Fault::NoTable], "{text}");
        assert_eq!(recording::preview_csv(text.as_bytes(), 3), None, "{text}");
    }
    let found = faults("t [s],q [deg]\n0,hunter2\n1,2\n2,3\n");
    assert!(!format!("{found:?}").contains("hunter2"), "{found:?}");
}
