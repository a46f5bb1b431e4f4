//! Parquet files written by other tools; `data/make.py` created them.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use quantities::unit::{DEGREE, MICROSECOND, NEWTON_METRE};
use quantities::{Measure, Time};
use recording::{
    Bytes, ColumnSpec, Fault, FileRow, KnownBy, Layout, Memory, Recording, Remedy, Role, SAMPLES_MAX, read_columns,
    read_parquet,
};

const PANDAS: &[u8] = include_bytes!("../data/pandas_snappy.parquet");
const POLARS: &[u8] = include_bytes!("../data/polars_zstd.parquet");
const PYARROW: &[u8] = include_bytes!("../data/pyarrow_gzip.parquet");
const LZ4: &[u8] = include_bytes!("../data/pyarrow_lz4_v2.parquet");
const TOO_MANY: &[u8] = include_bytes!("../data/pyarrow_too_many.parquet");
const NULL: &[u8] = include_bytes!("../data/pyarrow_null.parquet");
const NULLS: &[u8] = include_bytes!("../data/polars_nulls.parquet");
const INT128: &[u8] = include_bytes!("../data/polars_int128.parquet");
const FLOAT16: &[u8] = include_bytes!("../data/pyarrow_float16.parquet");
const BROTLI: &[u8] = include_bytes!("../data/pyarrow_brotli.parquet");

fn read(bytes: &'static [u8], layout: &Layout) -> Result<Recording, Vec<Fault>> {
    read_parquet(Bytes::from_static(bytes), layout)
}

fn units() -> Layout {
    Layout {
        position: ColumnSpec { unit: Some(&DEGREE), ..ColumnSpec::default() },
        torque: ColumnSpec { unit: Some(&NEWTON_METRE), ..ColumnSpec::default() },
        ..Layout::default()
    }
}

fn assert_motion(recording: &Recording, tolerance: f64) {
    assert_eq!(recording.time_s.len(), 200);
    assert_eq!(recording.first_time.si(), 5.0);
    let position = &recording.course.position.as_ref().unwrap().values;
    let torque = &recording.torque.as_ref().unwrap().values;
    for (k, time) in recording.time_s.iter().enumerate() {
        let phase = std::f64::consts::TAU * 5.0 * k as f64 / 1000.0;
        assert!((time - k as f64 / 1000.0).abs() < 1e-12);
        assert!((position[k] - (90.0 * (1.0 - phase.cos())).to_radians()).abs() < 1e-12);
        assert!((torque[k] - (3.0 + 2.0 * phase.sin())).abs() < tolerance);
    }
}

#[test]
fn pandas_with_snappy_is_read() {
    let recording = read(PANDAS, &Layout::default()).unwrap();
    assert_motion(&recording, 1e-12);
    assert!(recording.columns.iter().all(|column| column.known_by == KnownBy::Header));
}

#[test]
fn polars_with_zstd_is_read() {
    let recording = read(POLARS, &units()).unwrap();
    assert_motion(&recording, 1e-6);
    let time = &recording.columns[0];
    assert_eq!((time.unit, time.known_by), (&MICROSECOND, KnownBy::Metadata));
    let found = read(POLARS, &Layout::default()).unwrap_err();
    assert!(matches!(
        found.as_slice(),
        [Fault::UnitMissing { role: Role::Position, .. }, Fault::UnitMissing { role: Role::Torque, .. }]
    ));
}

#[test]
fn pages_of_the_second_version_with_lz4_are_read() {
    assert_motion(&read(LZ4, &Layout::default()).unwrap(), 1e-6);
}

#[test]
fn units_are_read_from_the_metadata_of_the_file() {
    let recording = read(PYARROW, &units()).unwrap();
    assert_motion(&recording, 1e-12);
    assert!(recording.columns.iter().all(|column| column.known_by == KnownBy::Metadata));
    let layout =
        Layout { position: ColumnSpec { unit: Some(&quantities::unit::RADIAN), ..ColumnSpec::default() }, ..units() };
    assert!(matches!(read(PYARROW, &layout).unwrap_err().as_slice(), [Fault::UnitContradiction { .. }]));
}

#[test]
fn a_window_spans_row_groups() {
    let (from, to) = (Some(Time::from_si(5.060)), Some(Time::from_si(5.130)));
    let recording = read(PYARROW, &Layout { from, to, ..Layout::default() }).unwrap();
    assert_eq!(recording.time_s.len(), 71);
    assert_eq!((recording.left_out_before, recording.left_out_after), (60, 69));
}

#[test]
fn a_null_is_reported_with_its_row() {
    let found = read(
        NULL,
        &Layout { position: ColumnSpec { name: Some("q".into()), ..ColumnSpec::default() }, ..Layout::default() },
    );
    let fault = Fault::ValueMissing { at: FileRow::Row(3), column: String::from("q [deg]") };
    assert_eq!(found.unwrap_err(), [Fault::Advised { fault: Box::new(fault), remedy: Remedy::Delete }]);
}

#[test]
fn a_list_is_no_column_of_numbers() {
    let position = ColumnSpec { name: Some("x.list.element".into()), ..ColumnSpec::default() };
    let found = read(NULL, &Layout { position, ..Layout::default() }).unwrap_err();
    assert!(matches!(found.as_slice(), [Fault::ColumnType { .. }]), "{found:?}");
}

/// Floats of two bytes are numbers.
#[test]
fn half_floats_are_read() {
    let recording = read(FLOAT16, &Layout::default()).unwrap();
    assert_eq!(*recording.torque.unwrap().values, [1.0, 2.0, 3.0, 4.0]);
}

/// A column that cannot be read is named with its type, and the recording is read without it.
#[test]
fn a_column_without_numbers_is_named_by_its_type() {
    for (file, expected) in [(NULLS, "NULL"), (INT128, "FIXED_LEN_BYTE_ARRAY (16)")] {
        let faults = read(file, &Layout::default()).unwrap_err();
        let [Fault::Advised { fault, remedy: Remedy::Without(Role::Torque) }] = faults.as_slice() else {
            panic!("{expected}: {faults:?}")
        };
        assert!(matches!(fault.as_ref(), Fault::ColumnType { found, .. } if found == expected), "{fault:?}");
        let torque = ColumnSpec { unused: true, ..ColumnSpec::default() };
        let recording = read(file, &Layout { torque, ..Layout::default() }).unwrap();
        assert_eq!(recording.time_s.len(), 4);
        // A position alone cannot be left out.
        let (position, torque) = (ColumnSpec::default(), ColumnSpec { unused: true, ..ColumnSpec::default() });
        let position = ColumnSpec { name: Some(String::from("torque [Nm]")), unit: Some(&DEGREE), ..position };
        let faults = read(file, &Layout { position, torque, ..Layout::default() }).unwrap_err();
        assert!(faults.iter().any(|fault| matches!(fault, Fault::ColumnType { .. })), "{faults:?}");
    }
}

/// Numbers as written, of any type and in any row groups; a missing column is `None`.
#[test]
fn columns_are_read_by_their_names() {
    let columns =
        |bytes: &'static [u8], names: &[&str]| read_columns(&Bytes::from_static(bytes), names, &mut Memory::default());
    let angle = |k: usize| 90.0 * (1.0 - (std::f64::consts::TAU * 5.0 * k as f64 / 1000.0).cos());
    let read = columns(PANDAS, &["q [deg]", "nothing", "time [ms]"]).unwrap();
    let [Some(q), None, Some(time)] = read.as_slice() else { panic!("{read:?}") };
    assert_eq!((q.len(), time.len(), time[0], time[199]), (200, 200, 5000.0, 5199.0));
    assert!(q.iter().enumerate().all(|(k, value)| (value - angle(k)).abs() < 1e-12));
    let read = columns(PYARROW, &["q"]).unwrap();
    assert!(read[0].as_ref().unwrap().iter().enumerate().all(|(k, value)| (value - angle(k)).abs() < 1e-12));
    assert_eq!(read[0].as_ref().unwrap().len(), 200);
    let found = columns(NULL, &["q [deg]", "t [s]"]).unwrap_err();
    assert_eq!(found, [Fault::ValueMissing { at: FileRow::Row(3), column: String::from("q [deg]") }]);
    assert!(matches!(columns(PANDAS, &["note"]).unwrap_err().as_slice(), [Fault::ColumnType { .. }]));
    let small = read_columns(&Bytes::from_static(PANDAS), &["q [deg]"], &mut Memory::new(1599)).unwrap_err();
    assert!(matches!(small.as_slice(), [Fault::Beyond { found: 1600, .. }]), "{small:?}");
    assert!(columns(&PANDAS[..PANDAS.len() / 2], &["q [deg]"]).is_err());
}

#[test]
fn pages_of_brotli_are_those_of_another_compression() {
    let [brotli, gzip] = [BROTLI, PYARROW].map(|file| read(file, &Layout::default()).unwrap());
    assert_eq!((brotli.time_s.len(), brotli.course), (200, gzip.course));
}

#[test]
fn too_many_rows_are_reported_before_they_are_read() {
    let found = read(TOO_MANY, &Layout::default()).unwrap_err();
    assert_eq!(found, [Fault::TooManySamples { most: SAMPLES_MAX }]);
    let windowed = read(TOO_MANY, &Layout { from: Some(Time::from_si(1.0)), ..Layout::default() }).unwrap_err();
    let [Fault::Repeated { first, .. }, ..] = windowed.as_slice() else { panic!("{windowed:?}") };
    assert!(matches!(first.as_ref(), Fault::SameTime { at: FileRow::Row(2), .. }), "with a window they are");
}

#[test]
fn what_is_no_parquet_is_refused() {
    for bytes in
        [b"".as_slice(), b"PAR1", b"t,q\n0,1\n", b"PAR1\0\0\0\0PAR1", b"PAR1\xff\xff\xff\x7fPAR1", b"PARE\0\0\0\0PARE"]
    {
        let found = read_parquet(Bytes::from_static(bytes), &Layout::default()).unwrap_err();
        assert!(matches!(found.as_slice(), [Fault::ParquetUnreadable { .. }]), "{found:?}");
    }
}

#[test]
fn a_truncated_file_is_refused() {
    for bytes in [PANDAS, POLARS, PYARROW, LZ4] {
        for length in (0..bytes.len()).step_by(7) {
            let found = read(&bytes[..length], &units()).unwrap_err();
            assert!(matches!(found.as_slice(), [Fault::ParquetUnreadable { .. }]), "{found:?}");
        }
    }
}

/// Parquet stores the durations of Arrow as plain integers; the schema of Arrow beside it says what they are.
#[test]
fn durations_state_their_unit() {
    let files: [(&[u8], [f64; 4]); 6] = [
        (include_bytes!("../data/pyarrow_duration_s.parquet"), [0.0, 1.0, 2.0, 3.0]),
        (include_bytes!("../data/pyarrow_duration_ms.parquet"), [0.0, 0.005, 0.01, 0.015]),
        (include_bytes!("../data/pyarrow_duration_us.parquet"), [0.0, 0.005, 0.01, 0.015]),
        (include_bytes!("../data/pyarrow_duration_ns.parquet"), [0.0, 0.005, 0.01, 0.015]),
        (include_bytes!("../data/polars_duration.parquet"), [0.0, 0.005, 0.01, 0.015]),
        (include_bytes!("../data/pandas_timedelta.parquet"), [0.0, 0.005, 0.01, 0.015]),
    ];
    for (bytes, times) in files {
        let recording = read(bytes, &Layout::default()).unwrap();
        assert!(recording.time_s.iter().zip(times).all(|(found, time)| (found - time).abs() < 1e-12));
        let time = recording.columns.iter().find(|column| column.role == Role::Time).unwrap();
        assert_ne!(time.known_by, KnownBy::Layout);
        // The unit that someone states must be that of the file.
        let wrong = Layout {
            time: ColumnSpec { unit: Some(&quantities::unit::MINUTE), ..ColumnSpec::default() },
            ..Layout::default()
        };
        let found = read(bytes, &wrong).unwrap_err();
        assert!(matches!(found.as_slice(), [Fault::UnitContradiction { .. }]), "{found:?}");
        // In a table they are no bare integers.
        let table = recording::Table::open(Box::new(Bytes::from_static(bytes)), Memory::default()).unwrap();
        let time = table.columns().iter().find(|column| column.name == "time").unwrap();
        assert!(matches!(time.kind, recording::ValueKind::Duration(_)), "{:?}", time.kind);
        // Every byte of the footer changed: another answer, or a fault, but an end.
        for at in bytes.len().saturating_sub(700)..bytes.len() {
            let mut changed = bytes.to_vec();
            changed[at] ^= 0x55;
            let _ = recording::read_parquet(Bytes::from(changed), &Layout::default());
        }
    }
}
