//! Types of time in Parquet, written by another implementation than the reader: every unit, in every place where a
//! column of numbers enters.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use arrow_array::{
    ArrayRef, DurationMicrosecondArray, DurationMillisecondArray, DurationNanosecondArray, DurationSecondArray,
    Float64Array, Int64Array, RecordBatch, StructArray, TimestampSecondArray,
};
use arrow_schema::{DataType, Field, Schema};
use parquet::arrow::ArrowWriter;
use quantities::Unit;
use quantities::unit::{DEGREE, MICROSECOND, MILLISECOND, MINUTE, NANOSECOND, SECOND};
use recording::{
    Bytes, Fault, KnownBy, Layout, Memory, Recording, Table, TableValues, ValueKind, read_columns, read_parquet,
};
use std::sync::Arc;

/// Number of samples, at an interval of 2 s in every unit, so that seconds state it too.
const SAMPLES: i64 = 40;

fn file(columns: Vec<(Field, ArrayRef)>) -> Bytes {
    let (fields, arrays): (Vec<Field>, Vec<ArrayRef>) = columns.into_iter().unzip();
    let batch = RecordBatch::try_new(Arc::new(Schema::new(fields)), arrays).unwrap();
    let mut bytes = Vec::new();
    let mut writer = ArrowWriter::try_new(&mut bytes, batch.schema(), None).unwrap();
    writer.write(&batch).unwrap();
    let _ = writer.close().unwrap();
    bytes.into()
}

fn column(name: &str, array: ArrayRef) -> (Field, ArrayRef) {
    (Field::new(name, array.data_type().clone(), false), array)
}

fn durations() -> [(&'static Unit, i64, ArrayRef); 4] {
    let of = |factor: i64| (0..SAMPLES).map(move |k| 2 * k * factor);
    [
        (&SECOND, 1, Arc::new(DurationSecondArray::from_iter_values(of(1)))),
        (&MILLISECOND, 1_000, Arc::new(DurationMillisecondArray::from_iter_values(of(1_000)))),
        (&MICROSECOND, 1_000_000, Arc::new(DurationMicrosecondArray::from_iter_values(of(1_000_000)))),
        (&NANOSECOND, 1_000_000_000, Arc::new(DurationNanosecondArray::from_iter_values(of(1_000_000_000)))),
    ]
}

fn positions() -> (Field, ArrayRef) {
    column("q [deg]", Arc::new(Float64Array::from_iter_values((0..SAMPLES).map(|k| k as f64))))
}

fn assert_times(recording: &Recording, unit: &'static Unit) {
    assert!(recording.time_s.iter().zip(0..).all(|(time, k)| (time - 2.0 * f64::from(k)).abs() < 1e-9));
    let time = &recording.columns[0];
    assert_eq!((time.unit, time.known_by), (unit, KnownBy::Metadata));
}

#[test]
fn a_duration_has_the_unit_of_its_type() {
    for (unit, _, array) in durations() {
        let recording = read_parquet(file(vec![column("t", array.clone()), positions()]), &Layout::default()).unwrap();
        assert_times(&recording, unit);
        // The type says what the numbers are, whatever unit a heading has.
        for named in ["t [s]", "t_ms", "time (ns)"] {
            assert_times(
                &read_parquet(file(vec![column(named, array.clone()), positions()]), &Layout::default()).unwrap(),
                unit,
            );
        }
        let mut layout = Layout::default();
        layout.time.unit = Some(&MINUTE);
        let faults = read_parquet(file(vec![column("t", array), positions()]), &layout).unwrap_err();
        assert!(matches!(faults.as_slice(), [Fault::UnitContradiction { .. }]), "{faults:?}");
    }
}

/// Instants of which Parquet does not state the unit.
#[test]
fn seconds_since_1970_are_instants() {
    let array: ArrayRef = Arc::new(TimestampSecondArray::from_iter_values((0..SAMPLES).map(|k| 1_700_000_000 + 2 * k)));
    let recording = read_parquet(file(vec![column("t", array), positions()]), &Layout::default()).unwrap();
    assert_times(&recording, &SECOND);
}

/// A column within a group, next to one of the same name.
#[test]
fn a_duration_within_a_group_is_read() {
    let (_, _, array) = &durations()[1];
    let whole: ArrayRef = Arc::new(Int64Array::from_iter_values(0..SAMPLES));
    let group = |array: &ArrayRef| {
        let field = Arc::new(Field::new("t", array.data_type().clone(), false));
        Arc::new(StructArray::from(vec![(field, Arc::clone(array))])) as ArrayRef
    };
    let bytes = file(vec![column("index", group(&whole)), column("log", group(array)), positions()]);
    let mut layout = Layout::default();
    layout.time.name = Some("log.t".to_owned());
    assert_times(&read_parquet(bytes, &layout).unwrap(), &MILLISECOND);
}

/// A column read by name has the unit of its name.
#[test]
fn a_duration_read_by_name_is_converted() {
    for (_, _, array) in durations() {
        let bytes = file(vec![column("time_s", array.clone()), column("position_rad", array)]);
        let found = read_columns(&bytes, &["time_s"], &mut Memory::default()).unwrap();
        assert!((found[0].as_ref().unwrap()[3] - 6.0).abs() < 1e-12);
        let faults = read_columns(&bytes, &["position_rad"], &mut Memory::default()).unwrap_err();
        assert!(matches!(faults.as_slice(), [Fault::ColumnType { found, .. }] if found.starts_with("DURATION")));
    }
}

#[test]
fn a_table_does_not_read_durations_as_numbers() {
    for (unit, _, array) in durations() {
        let bytes = file(vec![column("motion[1].pause [s]", array)]);
        let mut table = Table::open(Box::new(bytes), Memory::default()).unwrap();
        assert_eq!(table.columns()[0].kind, ValueKind::Duration(unit));
        assert_eq!(table.next(7).unwrap().unwrap(), [TableValues::Other(7)]);
    }
}

#[test]
fn a_unit_in_the_metadata_of_a_field_counts() {
    let of = |unit: &str| {
        let (field, array) = column("q", Arc::new(Float64Array::from_iter_values((0..SAMPLES).map(|k| k as f64))));
        let field = field.with_metadata([("unit".to_owned(), unit.to_owned())].into_iter().collect());
        let (_, _, time) = &durations()[1];
        read_parquet(file(vec![column("t", Arc::clone(time)), (field, array)]), &Layout::default())
    };
    let recording = of("deg").unwrap();
    assert_eq!((recording.columns[1].unit, recording.columns[1].known_by), (&DEGREE, KnownBy::Metadata));
    assert!(matches!(of("bananas").unwrap_err().as_slice(), [Fault::UnitUnknown { .. }]));
    // Types are named as Arrow names them.
    let (_, _, array) = &durations()[0];
    assert_eq!(array.data_type(), &DataType::Duration(arrow_schema::TimeUnit::Second));
}
