//! Any bytes get an answer, and a written recording is read back.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use arbtest::arbtest;
use quantities::Measure;
use quantities::Time;
use quantities::unit::{DEGREE, MILLISECOND, NEWTON_METRE};
use recording::{Bytes, ColumnSpec, Fault, Layout, MAGNITUDE_MAX, read_csv, read_parquet};

fn layout(choice: u8) -> Layout {
    let unit = |unit| ColumnSpec { unit: Some(unit), ..ColumnSpec::default() };
    Layout {
        time: if choice & 1 == 0 { ColumnSpec::default() } else { unit(&MILLISECOND) },
        position: if choice & 2 == 0 { ColumnSpec::default() } else { unit(&DEGREE) },
        torque: if choice & 4 == 0 { ColumnSpec::default() } else { unit(&NEWTON_METRE) },
        from: (choice & 8 != 0).then(|| Time::from_si(0.5)),
        allow_gaps: choice & 16 != 0,
        ..Layout::default()
    }
}

fn is_sound(read: Result<recording::Recording, Vec<recording::Fault>>) {
    match read {
        Err(faults) => assert!(!faults.is_empty()),
        Ok(recording) => {
            assert!(recording.time_s.is_sorted_by(|a, b| a < b));
            assert_eq!(recording.time_s[0], 0.0);
            let course = recording.course;
            for values in [course.position, course.speed].into_iter().flatten().map(|series| series.values) {
                assert_eq!(values.len(), recording.time_s.len());
                assert!(values.iter().all(|value| value.is_finite()));
            }
        }
    }
}

#[test]
fn random_bytes_have_an_answer() {
    arbtest(|u| {
        let layout = layout(u.arbitrary()?);
        let bytes: Vec<u8> = u.arbitrary()?;
        is_sound(read_csv(bytes.as_slice(), &layout));
        is_sound(read_parquet(Bytes::from(bytes), &layout));
        Ok(())
    });
}

#[test]
fn random_cells_have_an_answer() {
    let cells = [
        "t",
        "q",
        "n",
        "M",
        "[s]",
        " [deg]",
        "s",
        "deg",
        ",",
        ";",
        "\t",
        "\n",
        "\r\n",
        "\"",
        "#",
        "0",
        "1",
        "2.5",
        "3,5",
        "-1",
        "1e9",
        "1e308",
        "nan",
        "123456789012",
        "\u{feff}",
        "/",
        " in ",
        "(",
        "]",
        "ä",
        "t [s];q [deg]\n",
        "0;1\n1;2\n2;3\n",
        "t [h],q [deg]\n",
        "-1e20,1\n1,2\n2,3\n",
    ];
    arbtest(|u| {
        let layout = layout(u.arbitrary()?);
        let mut text = String::new();
        for _ in 0..u.int_in_range(0..=60)? {
            text += *u.choose(&cells)?;
        }
        is_sound(read_csv(text.as_bytes(), &layout));
        Ok(())
    });
}

#[test]
fn a_series_is_read_as_it_was_written() {
    arbtest(|u| {
        let (delimiter, comma) = *u.choose(&[(',', false), (';', false), (';', true), ('\t', true)])?;
        let signs = |value: f64| if comma { value.to_string().replace('.', ",") } else { value.to_string() };
        let mut text = format!("t [s]{delimiter}x{delimiter}q [rad]{delimiter}tau [Nm]\n");
        let (mut time, mut written) = (f64::from(u.arbitrary::<i16>()?), Vec::new());
        for _ in 0..u.int_in_range(3..=40)? {
            time += f64::from(u.int_in_range::<u16>(1000..=9999)?) / 1000.0;
            let value = |u: &mut arbtest::arbitrary::Unstructured<'_>| -> arbtest::arbitrary::Result<f64> {
                let value: f64 = u.arbitrary()?;
                Ok(if value.abs() <= MAGNITUDE_MAX { value } else { 0.0 })
            };
            let row = [time, value(u)?, value(u)?];
            text += &format!("{}{delimiter}a{delimiter}{}{delimiter}{}\n", signs(row[0]), signs(row[1]), signs(row[2]));
            written.push(row);
        }
        let no_x =
            Layout { position: ColumnSpec { name: Some("q".into()), ..ColumnSpec::default() }, ..Layout::default() };
        let recording = match read_csv(text.as_bytes(), &no_x) {
            Ok(recording) => recording,
            // A step of about half a turn, which random positions may have, is refused.
            Err(faults) => {
                assert!(faults.iter().all(|fault| matches!(fault, Fault::StepUndecided { .. })), "{faults:?}");
                return Ok(());
            }
        };
        let jumps = recording.revolutions_removed;
        let (position, torque) = (recording.course.position.unwrap().values, recording.torque.unwrap().values);
        assert_eq!(recording.time_s.len(), written.len());
        for (k, row) in written.iter().enumerate() {
            assert_eq!(recording.time_s[k], row[0] - written[0][0]);
            assert_eq!(torque[k], row[2]);
            // Random positions may be those of a modulo axis, whose revolutions are counted.
            let turns = ((position[k] - row[1]) / std::f64::consts::TAU).round();
            assert!(turns == 0.0 || jumps > 0, "{turns} {jumps}");
            let expected = if turns == 0.0 { row[1] } else { row[1] + turns * std::f64::consts::TAU };
            assert!((position[k] - expected).abs() <= 1e-9 * turns.abs(), "{} {expected}", position[k]);
        }
        Ok(())
    });
}

#[test]
fn a_damaged_parquet_file_has_an_answer() {
    let files = [
        include_bytes!("../data/pandas_snappy.parquet").as_slice(),
        include_bytes!("../data/polars_zstd.parquet"),
        include_bytes!("../data/pyarrow_gzip.parquet"),
        include_bytes!("../data/pyarrow_null.parquet"),
        include_bytes!("../data/pyarrow_lz4_v2.parquet"),
    ];
    arbtest(|u| {
        let layout = layout(u.arbitrary()?);
        let mut bytes = u.choose(&files)?.to_vec();
        for _ in 0..u.int_in_range(1..=8)? {
            let at = u.choose_index(bytes.len())?;
            // Half of the changes affect the footer with its lengths and offsets.
            let at = if u.arbitrary()? { at } else { bytes.len() - 1 - at % 2000.min(bytes.len()) };
            bytes[at] = u.arbitrary()?;
        }
        is_sound(read_parquet(Bytes::from(bytes), &layout));
        Ok(())
    })
    .budget_ms(2_000);
}

/// A quoted cell without a role leaves a row to the reader of single rows: both readers find the same numbers and
/// faults.
#[test]
fn rows_read_many_at_a_time_are_those_read_one_by_one() {
    arbtest(|u| {
        let layout = layout(u.arbitrary::<u8>()? & 0b1_1000);
        let (delimiter, sign) = *u.choose(&[(',', '.'), (';', ','), ('\t', '.')])?;
        let end = *u.choose(&["\n", "\r\n", "\r"])?;
        let epoch = if u.ratio(1, 8)? { 1_700_000_000 } else { 0 };
        let mut lines = vec![["t [s]", "note", "q [rad]"].map(str::to_owned)];
        let rows = u.int_in_range(0..=60)?;
        // In some cases enough rows for two threads.
        let copies = if u.ratio(1, 16)? { 400 } else { 1 };
        for row in 0..rows * copies {
            let mut time = format!("{}{sign}{:02}", epoch + row / 100, row % 100);
            let mut place = format!("{}{sign}5", row % 7);
            if u.ratio(1, 40)? {
                let odd = ["", "y", "1e2", "9999999999999999999999", "1234567890123", " 1", "-3", "nan", "1.5", "1,5"];
                *(if u.arbitrary()? { &mut time } else { &mut place }) = (*u.choose(&odd)?).to_owned();
            }
            lines.push([time, "x".to_owned(), place]);
            if u.ratio(1, 60)? {
                lines.push(["# said".to_owned(), "x".to_owned(), String::new()]);
            }
        }
        let written = |note: &str| {
            let row = |line: &[String; 3]| line.join(&delimiter.to_string()).replace("x", note);
            lines.iter().map(row).collect::<Vec<_>>().join(end)
        };
        let [plain, quoted] = ["n", "\"n\""].map(|note| read_csv(written(note).as_bytes(), &layout));
        assert_eq!(plain, quoted);
        Ok(())
    });
}
