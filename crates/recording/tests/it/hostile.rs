//! Files that claim more than they contain: each is refused immediately because of its claim.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use recording::{
    Bytes, DELTA_BLOCK_MAX, Damage, Fault, FileRow, Layout, Limit, Memory, NESTING_MAX, Recording, read_csv,
    read_csv_within, read_parquet, read_parquet_within,
};
use std::time::{Duration, Instant};
use testkit::parquet::{FileColumn, Structure, claimed_children, ended, file, nested_groups, page, ramp_of_deltas};

const INT64: i64 = 2;
const DOUBLE: i64 = 5;
const PLAIN: i64 = 0;
const DELTAS: i64 = 5;
const ZSTD: i64 = 6;

/// Time limit: far longer than a refusal takes without optimisation on a busy machine, far shorter than the claimed
/// work.
const AT_ONCE: Duration = Duration::from_millis(600);

fn read(bytes: Vec<u8>) -> Result<Recording, Vec<Fault>> {
    let begin = Instant::now();
    let read = read_parquet(Bytes::from(bytes), &Layout::default());
    assert!(begin.elapsed() < AT_ONCE, "{:?}: {read:?}", begin.elapsed());
    read
}

fn only(read: Result<Recording, Vec<Fault>>) -> Fault {
    let mut faults = read.unwrap_err();
    assert_eq!(faults.len(), 1, "{faults:?}");
    faults.remove(0)
}

fn plain(name: &'static str, values: impl Iterator<Item = f64>) -> FileColumn {
    let bytes: Vec<u8> = values.flat_map(f64::to_le_bytes).collect();
    let count = (bytes.len() / 8) as i64;
    FileColumn {
        name,
        physical: DOUBLE,
        codec: 0,
        values: count,
        pages: page(PLAIN, count, &bytes, bytes.len() as i64),
    }
}

fn times(count: i32) -> FileColumn {
    plain("t [s]", (0..count).map(f64::from))
}

#[test]
fn a_file_made_by_hand_is_read() {
    let bytes = file(4, &[times(4), plain("q [rad]", [0.0, 0.5, 0.25, 0.0].into_iter())]);
    let recording = read(bytes).unwrap();
    assert_eq!(*recording.time_s, [0.0, 1.0, 2.0, 3.0]);
    assert_eq!(*recording.course.position.unwrap().values, [0.0, 0.5, 0.25, 0.0]);
}

#[test]
fn groups_within_groups_are_refused_beyond_their_limit() {
    for depth in [NESTING_MAX + 2, 5_000, 10_000, 1_000_000] {
        let fault = only(read(nested_groups(depth)));
        let (limit, most) = (Limit::Nesting, NESTING_MAX as u64);
        assert_eq!(fault, Fault::Beyond { limit, found: most + 1, most }, "{depth}");
    }
    // At the limit the missing column is reported.
    let found = read(nested_groups(NESTING_MAX + 1)).unwrap_err();
    assert!(matches!(found[0], Fault::TimeMissing { .. }), "{found:?}");
}

#[test]
fn children_and_elements_that_are_not_there_are_refused() {
    let bytes = claimed_children();
    assert!(bytes.len() <= 31, "{}", bytes.len());
    assert_eq!(only(read(bytes)), Fault::ParquetUnreadable { reason: Damage::Footer });
    let root = || Structure::default().text(4, "s").integer(5, 0);
    let groups = Structure::default().list(2, 1, [root()]).integer(3, 0).list(4, u64::from(u32::MAX), []);
    assert_eq!(only(read(ended(b"PAR1".to_vec(), groups.end()))), Fault::ParquetUnreadable { reason: Damage::Footer });
    // A negative number of children, and a group with more children than follow.
    for children in [-1, 2] {
        let root = Structure::default().text(4, "s").integer(5, children);
        let column = Structure::default().integer(1, DOUBLE).text(4, "t");
        let footer = Structure::default().list(2, 2, [root, column]).integer(3, 0).end();
        assert_eq!(
            only(read(ended(b"PAR1".to_vec(), footer))),
            Fault::ParquetUnreadable { reason: Damage::Footer },
            "{children}"
        );
    }
}

#[test]
fn many_columns_and_long_paths_are_refused() {
    let name = "n".repeat(700);
    let schema = |count: usize, name: &str| {
        let root = Structure::default().text(4, "s").integer(5, count as i64);
        let columns = (0..count).map(|_| Structure::default().integer(1, DOUBLE).text(4, name));
        let footer = Structure::default().list(2, count as u64 + 1, [root].into_iter().chain(columns)).integer(3, 0);
        ended(b"PAR1".to_vec(), footer.end())
    };
    assert!(matches!(only(read(schema(10_001, "c"))), Fault::Beyond { limit: Limit::Columns, found: 10_001, .. }));
    assert!(matches!(only(read(schema(2, &name.repeat(2)))), Fault::Beyond { limit: Limit::PathBytes, .. }));
    // Ten thousand columns that could all be the position: the fault fits on a screen.
    let found = read(schema(9_000, "q [deg]")).unwrap_err();
    assert!(matches!(&found[0], Fault::Ambiguous { columns, .. } if columns.len() < 30), "{}", found.len());
}

#[test]
fn a_page_is_not_unpacked_to_what_it_claims() {
    let two_gib = i64::from(i32::MAX);
    let claim = |values: i64, unpacked: i64, packed: &[u8]| {
        let time = FileColumn {
            name: "t [s]",
            physical: DOUBLE,
            codec: ZSTD,
            values,
            pages: page(PLAIN, values, packed, unpacked),
        };
        let position = FileColumn { name: "q [deg]", ..time.clone() };
        only(read(file(values, &[time, position])))
    };
    let packed = vec![0x28; 3_000];
    // Values that cannot need as many bytes, and enough values to need them.
    assert_eq!(claim(1_000, two_gib, &packed), Fault::ParquetUnreadable { reason: Damage::Page });
    assert!(matches!(claim(1 << 24, 1 << 28, &packed), Fault::Beyond { limit: Limit::PageRatio, found: 89_478, .. }));
    assert!(matches!(
        claim(1 << 26, two_gib, &packed),
        Fault::Beyond { limit: Limit::PageRatio, .. } | Fault::TooManySamples { .. }
    ));
    assert!(matches!(claim(1 << 30, two_gib, &packed), Fault::Beyond { limit: Limit::Rows, .. }));
    // Beyond the given memory, at any ratio.
    let packed = vec![0x28; 100_000];
    assert!(matches!(claim(1 << 23, 90 << 20, &packed), Fault::ParquetUnreadable { reason: Damage::Packed }));
    let column = |name| FileColumn {
        name,
        physical: DOUBLE,
        codec: ZSTD,
        values: 1 << 23,
        pages: page(PLAIN, 1 << 23, &packed, 90 << 20),
    };
    let bytes = file(1 << 23, &[column("t [s]"), column("q [deg]")]);
    let mut memory = Memory::new(80 << 20);
    let fault = only(read_parquet_within(Bytes::from(bytes), &Layout::default(), &mut memory));
    assert!(matches!(fault, Fault::Beyond { limit: Limit::Memory, most, .. } if most == 80 << 20), "{fault:?}");
}

#[test]
fn zeros_that_are_packed_tightly_are_not_unpacked() {
    // 24 MiB of real data, in a few kilobytes.
    let zeros = vec![0; 24 << 20];
    let packed = zstd::bulk::compress(&zeros, 1).unwrap();
    assert!(packed.len() < 20_000);
    let values = (zeros.len() / 8) as i64;
    let pages = page(PLAIN, values, &packed, zeros.len() as i64);
    let time = FileColumn { name: "t [s]", physical: DOUBLE, codec: ZSTD, values, pages };
    let fault = only(read(file(values, &[time.clone(), FileColumn { name: "q [deg]", ..time }])));
    assert!(matches!(fault, Fault::Beyond { limit: Limit::PageRatio, .. }), "{fault:?}");
}

#[test]
fn samples_that_take_no_bytes_are_refused() {
    let deltas = |count: u64, block: u64| {
        let bytes = ramp_of_deltas(count, block);
        let pages = page(DELTAS, count as i64, &bytes, bytes.len() as i64);
        let time = FileColumn { name: "t [ms]", physical: INT64, codec: 0, values: count as i64, pages };
        file(count as i64, &[time.clone(), FileColumn { name: "q [deg]", ..time }])
    };
    let bytes = deltas(1 << 20, 1 << 20);
    assert!(bytes.len() < 228, "{}", bytes.len());
    let (limit, most) = (Limit::DeltaBlock, DELTA_BLOCK_MAX);
    assert_eq!(only(read(bytes)), Fault::Beyond { limit, found: 1 << 20, most });
    let recording = read(deltas(5_000, DELTA_BLOCK_MAX)).unwrap();
    assert_eq!((recording.time_s.len(), recording.time_s[4_999]), (5_000, 4.999));
}

#[test]
fn values_that_are_not_there_are_refused() {
    // The columns differ in length, a chunk has fewer values than stated, a page more.
    let cut = |values: i64| FileColumn { values, ..plain("q [deg]", (0..4).map(f64::from)) };
    for column in [cut(3), cut(5), FileColumn { values: 4, ..plain("q [deg]", (0..5).map(f64::from)) }] {
        assert_eq!(only(read(file(4, &[times(4), column]))), Fault::ParquetUnreadable { reason: Damage::Lengths });
    }
    // No delta where the levels state a value.
    let none = ramp_of_deltas(0, 128);
    let pages = page(DELTAS, 4, &none, none.len() as i64);
    let column = FileColumn { name: "q [deg]", physical: INT64, codec: 0, values: 4, pages };
    assert!(matches!(
        only(read(file(4, &[times(4), column]))),
        Fault::ParquetUnreadable { reason: Damage::Values { .. } }
    ));
    // Pages beyond the end of the file: the range referenced by the footer is cut out.
    let mut bytes = file(4, &[times(4), times(4)]);
    drop(bytes.drain(4..60));
    assert!(read(bytes).is_err());
}

#[test]
fn what_no_machine_does_is_no_recording() {
    let far = |text: &str, line| {
        let found = read_csv(text.as_bytes(), &Layout::default()).unwrap_err();
        assert!(
            matches!(found.as_slice(), [Fault::ValueImplausible { at, .. }, ..] if *at == FileRow::Line(line)),
            "{text}: {found:?}"
        );
    };
    far("t [s],q [deg],M [Nm]\n0,1,95\n1e307,2,95\n2e307,3,95\n", 3);
    far("t [s],q [deg]\n0,1\n1,1e308\n2,3\n", 3);
    far("t [s],q [deg],M [Nm]\n0,1,95\n1,2,-2e12\n2,3,95\n", 3);
    assert!(read_csv("t [s],q [rad]\n0,1e12\n1,-1e12\n2,6e-17\n".as_bytes(), &Layout::default()).is_ok());
    let close = read_csv("t [s],q [deg]\n0,1\n1e-300,2\n2e-300,3\n".as_bytes(), &Layout::default()).unwrap_err();
    assert!(matches!(close.as_slice(), [Fault::TooClose { at: FileRow::Line(3), .. }, ..]), "{close:?}");
    let parquet = only(read(file(3, &[times(3), plain("q [deg]", [0.0, 1e308, 0.0].into_iter())])));
    assert!(matches!(parquet, Fault::ValueImplausible { at: FileRow::Row(2), .. }), "{parquet:?}");
}

#[test]
fn memory_is_taken_for_what_is_kept_and_bounds_it() {
    let rows: String = (0..10_000).map(|row| format!("{row},0\n")).collect();
    let text = format!("t [s],q [deg]\n{rows}");
    let mut memory = Memory::new(1 << 20);
    let recording = read_csv_within(text.as_bytes(), &Layout::default(), &mut memory).unwrap();
    assert_eq!(memory.left(), (1 << 20) - 16 * recording.time_s.len() as u64);
    let mut little = Memory::new(100_000);
    let found = read_csv_within(text.as_bytes(), &Layout::default(), &mut little).unwrap_err();
    assert!(matches!(found.as_slice(), [Fault::Beyond { limit: Limit::Memory, most: 100_000, .. }]), "{found:?}");
    assert_eq!(little.left(), 100_000, "what was refused takes nothing");
}

#[test]
fn lines_may_end_with_a_carriage_return_alone() {
    let text = "# logger\rt [s];q [rad]\r0;1,5\r1;2\r\r2;3\r";
    for text in [text.to_owned(), text.trim_end().to_owned(), text.replace('\r', "\r\n")] {
        let recording = read_csv(text.as_bytes(), &Layout::default()).unwrap();
        assert_eq!(*recording.course.position.unwrap().values, [1.5, 2.0, 3.0], "{text:?}");
    }
    let found = read_csv("t [s];q [rad]\r0;x\r".as_bytes(), &Layout::default()).unwrap_err();
    assert!(matches!(found.as_slice(), [Fault::ValueUnreadable { at: FileRow::Line(2), .. }]), "{found:?}");
}

/// Every row has a value larger than any measurement, for example if a clock in nanoseconds is taken for the position.
#[test]
fn a_column_of_faults_is_read_in_the_time_of_one_of_numbers() {
    let row = |k: usize| format!("{},1{k:013}\n", k as f64 / 1000.0);
    let text = format!("t [s],q [rad]\n{}", (0..60_000).map(row).collect::<String>());
    let begin = Instant::now();
    let faults = read_csv(text.as_bytes(), &Layout::default()).unwrap_err();
    assert!(begin.elapsed() < 20 * AT_ONCE, "{:?}", begin.elapsed());
    let Fault::Repeated { first, .. } = &faults[0] else { panic!("{faults:?}") };
    let Fault::ValueImplausible { at, text, .. } = first.as_ref() else { panic!("{faults:?}") };
    assert_eq!((*at, text.as_str()), (FileRow::Line(2), "10000000000000"));
}
