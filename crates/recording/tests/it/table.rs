//! Tables with any columns: values read, and limits that no file can exceed.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use parquet::basic::{Compression, ZstdLevel};
use parquet::data_type::{
    BoolType, ByteArrayType, DoubleType, FixedLenByteArrayType, Int32Type, Int64Type, Int96, Int96Type,
};
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;
use recording::{Bytes, Fault, Layout, Limit, Memory, TABLE_COLUMNS_MAX, Table, TableValues, ValueKind, read_parquet};
use std::sync::Arc;
use std::time::{Duration, Instant};
use testkit::parquet::{Structure, ended, nested_groups};

fn open(bytes: Vec<u8>) -> Result<Table, Fault> {
    Table::open(Box::new(Bytes::from(bytes)), Memory::default())
}

/// Three groups of four rows with every kind of column.
fn made(compression: Compression) -> Vec<u8> {
    let schema = "message s {
        required int96 stamp; required int64 price (DECIMAL(18, 3)); required fixed_len_byte_array(5) small (DECIMAL(10, 2));
        required double x; optional int32 count (UINT_32); optional boolean flag; optional binary name (UTF8); required int64 at (TIME_MICROS);
    }";
    let schema = Arc::new(parse_message_type(schema).unwrap());
    let properties = WriterProperties::builder().set_compression(compression).build();
    let mut writer = SerializedFileWriter::new(Vec::new(), schema, Arc::new(properties)).unwrap();
    for group in 0..3_i64 {
        let mut rows = writer.next_row_group().unwrap();
        macro_rules! column {
            ($of:ty, $values:expr, $levels:expr) => {{
                let mut column = rows.next_column().unwrap().unwrap();
                let levels: Option<&[i16]> = $levels;
                let _ = column.typed::<$of>().write_batch(&$values, levels, None).unwrap();
                column.close().unwrap();
            }};
        }
        let each = |of: fn(i64) -> i64| (0..4).map(move |k| of(4 * group + k)).collect::<Vec<_>>();
        let stamp = |k: i64| {
            let mut value = Int96::new();
            value.set_data(u32::try_from(k * 5_000_000).unwrap(), 0, 2_440_588);
            value
        };
        column!(Int96Type, each(|k| k).into_iter().map(stamp).collect::<Vec<_>>(), None);
        column!(Int64Type, each(|k| 1500 * k - 2000), None);
        let small = |k: i64| (k - 2).to_be_bytes()[3..].to_vec().into();
        column!(FixedLenByteArrayType, each(|k| k).into_iter().map(small).collect::<Vec<_>>(), None);
        column!(DoubleType, each(|k| k).into_iter().map(|k| k as f64 / 8.0).collect::<Vec<_>>(), None);
        column!(Int32Type, [-1, 7], Some(&[1, 0, 0, 1]));
        column!(BoolType, [true, false, true], Some(&[1, 1, 0, 1]));
        column!(ByteArrayType, ["a".into(), "größer".into()], Some(&[0, 1, 1, 0]));
        column!(Int64Type, each(|k| k * 5000), None);
        let _ = rows.close().unwrap();
    }
    writer.into_inner().unwrap()
}

#[test]
fn every_kind_of_column_is_read_in_parts() {
    for compression in
        [Compression::UNCOMPRESSED, Compression::SNAPPY, Compression::ZSTD(ZstdLevel::try_new(3).unwrap())]
    {
        let mut table = open(made(compression)).unwrap();
        let kinds: Vec<ValueKind> = table.columns().iter().map(|column| column.kind.clone()).collect();
        assert!(
            matches!(
                &kinds[..],
                [
                    ValueKind::Other(_),
                    ValueKind::Float,
                    ValueKind::Float,
                    ValueKind::Float,
                    ValueKind::Unsigned { is_long: false },
                    ValueKind::Truth,
                    ValueKind::Text,
                    ValueKind::Other(_),
                ]
            ),
            "{kinds:?}"
        );
        table.skip(1).unwrap();
        let first = table.next(2).unwrap().unwrap();
        assert_eq!(first[0], TableValues::Other(2));
        assert_eq!(first[1], TableValues::Floats(vec![Some(-0.5), Some(1.0)]));
        assert_eq!(first[2], TableValues::Floats(vec![Some(-0.01), Some(0.0)]));
        assert_eq!(first[3], TableValues::Floats(vec![Some(0.125), Some(0.25)]));
        assert_eq!(first[4], TableValues::Unsigned(vec![None, None]));
        assert_eq!(first[5], TableValues::Truths(vec![Some(false), None]));
        assert_eq!(first[6], TableValues::Texts(vec![Some("a".to_owned()), Some("größer".to_owned())]));
        let rest = table.next(1).unwrap().unwrap();
        assert_eq!(rest[4], TableValues::Unsigned(vec![Some(7)]));
        table.skip(5).unwrap();
        assert_eq!(
            table.next(100).unwrap().unwrap()[3],
            TableValues::Floats(vec![Some(1.125), Some(1.25), Some(1.375)])
        );
        assert_eq!(table.next(100).unwrap(), None);
        table.skip(1000).unwrap();
    }
}

/// Half floats are numbers in a table as they are in a recording; no cell of a type that is read is lost.
#[test]
fn half_floats_are_numbers_in_a_table() {
    let schema = "message s { optional fixed_len_byte_array(2) h (FLOAT16); required double x; }";
    let schema = Arc::new(parse_message_type(schema).unwrap());
    let mut writer = SerializedFileWriter::new(Vec::new(), schema, Arc::default()).unwrap();
    let mut rows = writer.next_row_group().unwrap();
    let mut column = rows.next_column().unwrap().unwrap();
    // 0.5, 5, −2 with an empty cell.
    let halves = [0x3800_u16, 0x4500, 0xc000].map(|bits| bits.to_le_bytes().to_vec().into());
    let _ = column.typed::<FixedLenByteArrayType>().write_batch(&halves, Some(&[1, 1, 0, 1]), None).unwrap();
    column.close().unwrap();
    let mut column = rows.next_column().unwrap().unwrap();
    let _ = column.typed::<DoubleType>().write_batch(&[1.0, 2.0, 3.0, 4.0], None, None).unwrap();
    column.close().unwrap();
    let _ = rows.close().unwrap();
    let mut table = open(writer.into_inner().unwrap()).unwrap();
    assert_eq!(table.columns()[0].kind, ValueKind::Float);
    let found = table.next(10).unwrap().unwrap();
    assert_eq!(found[0], TableValues::Floats(vec![Some(0.5), Some(5.0), None, Some(-2.0)]));
}

/// The parts of a table are those of its rows, whatever the groups of the file: all are full but the last, and together they are
/// the whole.
#[test]
fn a_part_goes_on_across_the_groups_of_the_file() {
    let whole = open(made(Compression::SNAPPY)).unwrap().next(1000).unwrap().unwrap();
    let TableValues::Floats(all) = &whole[3] else { panic!("{whole:?}") };
    for rows in 1..=all.len() + 1 {
        for skipped in 0..all.len() {
            let mut table = open(made(Compression::SNAPPY)).unwrap();
            table.skip(skipped as u64).unwrap();
            let mut found = Vec::new();
            while let Some(part) = table.next(rows).unwrap() {
                let TableValues::Floats(values) = &part[3] else { panic!("{part:?}") };
                assert_eq!(values.len(), rows.min(all.len() - skipped - found.len()), "{rows} rows from {skipped}");
                assert_eq!(part[0], TableValues::Other(values.len()));
                found.extend(values.clone());
            }
            assert_eq!(found, all[skipped..], "{rows} rows from {skipped}");
        }
    }
}

/// Read as a recording, 96-bit times, times of a day and decimals are numbers with their units.
#[test]
fn decimals_and_times_are_read_as_a_recording() {
    let bytes = Bytes::from(made(Compression::SNAPPY));
    let named = |name: &str, unit| recording::ColumnSpec { name: Some(name.to_owned()), unit, unused: false };
    for time in ["stamp", "at"] {
        let layout = Layout {
            time: named(time, None),
            position: named("price", Some(&quantities::unit::DEGREE)),
            torque: named("small", Some(&quantities::unit::NEWTON_METRE)),
            ..Layout::default()
        };
        let recording = read_parquet(bytes.clone(), &layout).unwrap();
        assert!(recording.time_s.iter().enumerate().all(|(k, t)| (t - 0.005 * k as f64).abs() < 1e-12), "{time}");
        let degrees: Vec<f64> = recording.course.position.unwrap().values.iter().map(|q| q.to_degrees()).collect();
        assert!(degrees.iter().enumerate().all(|(k, q)| (q - (1.5 * k as f64 - 2.0)).abs() < 1e-12));
        let torque = recording.torque.unwrap();
        assert!(torque.values.iter().enumerate().all(|(k, m)| (m - (k as f64 - 2.0) / 100.0).abs() < 1e-15));
    }
}

/// Files that claim more than they contain are refused immediately.
#[test]
fn no_claim_costs_more_than_its_bytes() {
    let begin = Instant::now();
    let footer = |schema: Vec<Structure>, claimed: u64, rows: i64| {
        ended(b"PAR1".to_vec(), Structure::default().list(2, claimed, schema).integer(3, rows).end())
    };
    let root = |children: i64| Structure::default().text(4, "s").integer(5, children);
    let column = || Structure::default().integer(1, 5).text(4, "c");
    assert!(open(b"PAR1".to_vec()).is_err());
    assert!(open(footer(vec![root(1)], u64::MAX / 4, 1)).is_err(), "a list longer than its bytes");
    for depth in [100, 20_000, 100_000] {
        assert!(matches!(open(nested_groups(depth)), Err(Fault::Beyond { limit: Limit::Nesting, .. })), "{depth}");
    }
    let wide = TABLE_COLUMNS_MAX as usize + 1;
    let columns: Vec<Structure> = std::iter::once(root(wide as i64)).chain((0..wide).map(|_| column())).collect();
    assert!(matches!(open(footer(columns, wide as u64 + 1, 0)), Err(Fault::Beyond { limit: Limit::Columns, .. })));
    for rows in [1 << 21, 1 << 40, i64::MAX] {
        let found = open(footer(vec![root(1), column()], 2, rows));
        assert!(matches!(found, Err(Fault::Beyond { limit: Limit::Rows, .. })), "{rows}");
    }
    // Every truncation and every changed byte of a valid file is read or refused.
    let sound = made(Compression::SNAPPY);
    for place in 0..sound.len() {
        let mut changed = sound.clone();
        changed[place] ^= 0x5a;
        for bytes in [changed, sound[..place].to_vec()] {
            let Ok(mut table) = open(bytes) else { continue };
            for _ in 0..20 {
                let Ok(Some(_)) = table.next(1000) else { break };
            }
        }
    }
    assert!(begin.elapsed() < Duration::from_secs(60), "{:?}", begin.elapsed());
}

/// A long dictionary text that occurs in every row is counted before it is copied.
#[test]
fn a_text_in_every_row_takes_no_more_than_is_given() {
    let schema = Arc::new(parse_message_type("message s { required binary n (UTF8); }").unwrap());
    let properties = WriterProperties::builder().set_dictionary_page_size_limit(64 << 20).build();
    let mut writer = SerializedFileWriter::new(Vec::new(), schema, Arc::new(properties)).unwrap();
    let mut rows = writer.next_row_group().unwrap();
    let mut column = rows.next_column().unwrap().unwrap();
    let text = "x".repeat(1 << 20);
    let texts = vec![text.as_str().into(); 200];
    let _ = column.typed::<ByteArrayType>().write_batch(&texts, None, None).unwrap();
    column.close().unwrap();
    let _ = rows.close().unwrap();
    let bytes = writer.into_inner().unwrap();
    assert!(bytes.len() < 4 << 20, "{} bytes", bytes.len());
    let found = open(bytes).and_then(|mut table| table.next(16_384));
    assert!(matches!(found, Err(Fault::Beyond { limit: Limit::Memory, .. })), "three copies of 200 MiB");
}
