//! Record batches in, record batches out.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, missing_docs, reason = "a test fails loudly")]

use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, Int64Type, UInt32Type, UInt64Type};
use arrow_array::{Array, ArrayRef, Float32Array, Float64Array, Int64Array, RecordBatch, StringArray};
use axis::NoFiles;
use quantities::Language;
use questions::Progress;
use std::io::Write as _;
use std::sync::Arc;
use sweep_io::{Answers, BatchHead, BatchSweep, Batches, Decimal, Format, Options, Repeats, TableFaults, Wanted};

const MOVE: &str = "format = 1\n[load]\ninertia = \"1 kg m^2\"\nfriction_torque = \"5 N m\"\n[[motion]]\n\
    law = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"0.5 s\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n";

fn batch(columns: Vec<(&str, ArrayRef)>) -> RecordBatch {
    RecordBatch::try_from_iter_with_nullable(columns.into_iter().map(|(name, cells)| (name, cells, true))).unwrap()
}

fn sweep(batch: &RecordBatch, wanted: Wanted) -> BatchSweep {
    let options = Options { wanted, ..Options::default() };
    BatchHead::of(("axis.toml", MOVE), &NoFiles, &batch.schema(), Repeats::default(), options)
        .ready("tasks", Box::new(NoFiles))
        .unwrap()
}

#[test]
fn a_table_is_answered_row_by_row() {
    let table = batch(vec![
        ("load.inertia [kg m^2]", Arc::new(Float64Array::from(vec![1.0, -1.0, 900.0])) as ArrayRef),
        ("motion[1].time [ms]", Arc::new(Int64Array::from(vec![500, 500, 1000]))),
        ("motion[1].law", Arc::new(StringArray::from(vec!["trapezoid", "polynomial_5", "trapezoid"]))),
    ]);
    let sweep = sweep(&table, Wanted::Best);
    let mut faults = TableFaults::default();
    sweep.check(&table, 0, &mut faults);
    assert!(faults.is_empty(), "{faults:?}");
    let answer = sweep.batch(&table, 1000, &Progress::endless()).unwrap();
    assert_eq!(answer.schema(), sweep.schema());
    let names: Vec<_> = answer.schema().fields().iter().map(|field| field.name().clone()).collect();
    assert_eq!(names, ["row", "fit", "code", "utilisation", "tightest", "error", "fit_if_estimate"]);
    assert_eq!(answer.column(0).as_primitive::<UInt64Type>().values(), &[1000, 1001, 1002]);
    let fit = answer.column(1).as_primitive::<UInt32Type>();
    assert!(fit.value(0) > 50 && fit.is_null(1) && fit.value(2) == 0);
    let code = answer.column(2).as_string::<i32>();
    assert!(code.value(0).starts_with("CHA-") && code.is_null(1) && code.is_null(2));
    let utilisation = answer.column(3).as_primitive::<Float64Type>();
    assert!(utilisation.value(0) < 1.0 && utilisation.is_null(1) && utilisation.value(2) > 1.0);
    let error = answer.column(5).as_string::<i32>();
    assert!(error.is_null(0) && error.value(1).contains("load.inertia") && error.is_null(2));
}

#[test]
fn every_code_and_the_front_stand_in_lines_of_their_own() {
    let table = batch(vec![("load.inertia [kg m^2]", Arc::new(Float32Array::from(vec![1.0, 2.0])) as ArrayRef)]);
    let every = sweep(&table, Wanted::Every(vec![questions::CheckId::PeakTorque]));
    let answer = every.batch(&table, 0, &Progress::endless()).unwrap();
    assert!(answer.num_rows() > 500 && answer.num_rows().is_multiple_of(2));
    assert_eq!(answer.schema().field(5).name(), "peak_torque.verdict");
    assert!(["pass", "fail"].contains(&answer.column(5).as_string::<i32>().value(0)));
    let front = sweep(&table, Wanted::Front);
    let answer = front.batch(&table, 0, &Progress::endless()).unwrap();
    assert!((2..200).contains(&answer.num_rows()), "{}", answer.num_rows());
    assert!(answer.column(2).as_primitive::<Float64Type>().iter().all(|mass| mass.is_some_and(|mass| mass > 0.5)));
    // The errata of the mass stand beside it, and those of no other figure.
    let (codes, errata) = (answer.column(1).as_string::<i32>(), answer.column(8).as_string::<i32>());
    assert_eq!(answer.schema().field(8).name(), "errata");
    let mut marked = 0;
    for (code, errata) in codes.iter().zip(errata) {
        let code = code.unwrap();
        let catalogue = questions::embedded_catalogue();
        let data = &catalogue.products(false).iter().find(|known| known.id.to_string() == code).unwrap().parameters;
        let ids =
            [data.mass.known().unwrap().errata, data.length.known().map_or(&[][..], |length| length.errata)].concat();
        assert_eq!(errata.unwrap_or_default(), ids.join(";"), "{code}");
        marked += ids.len();
    }
    assert!(marked > 0, "no erratum on the front");
}

/// A part of an answer with every check of every code takes a quarter of the memory, estimated from its values; an answer of few
/// values has the rows of the caller.
#[test]
fn the_rows_of_a_part_are_those_of_the_memory() {
    let table = batch(vec![("load.inertia [kg m^2]", Arc::new(Float64Array::from(vec![1.0; 8])) as ArrayRef)]);
    let best = sweep(&table, Wanted::Best);
    assert_eq!(best.rows_within(512 << 20, 1 << 14), 1 << 14);
    let every = sweep(&table, Wanted::Every(questions::CheckId::ALL.to_vec()));
    let [small, large] = [64_u64 << 20, 512 << 20].map(|memory| every.rows_within(memory, 1 << 14));
    assert!(small >= 1 && large >= 8 * small && large < 200, "{small} {large}");
    assert_eq!(every.rows_within(0, 1 << 14), 1);
    // The estimate holds the arrays of the answer and its judgement: 24 bytes a check.
    let answer = every.batch(&table, 0, &Progress::endless()).unwrap();
    let judged = answer.num_rows() * questions::CheckId::ALL.len() * 24;
    let held = (answer.get_array_memory_size() + judged) as u64;
    let counted = (512_u64 << 20) / 4 / large as u64 * 8;
    assert!(held <= counted, "{held} bytes, {counted} counted");
    // Rows with a code have one line.
    let codes = batch(vec![
        ("load.inertia [kg m^2]", Arc::new(Float64Array::from(vec![1.0])) as ArrayRef),
        ("code", Arc::new(StringArray::from(vec!["CHA-25A-100-H-M512P-B"]))),
    ]);
    let of_code = sweep(&codes, Wanted::Every(questions::CheckId::ALL.to_vec()));
    assert!(of_code.rows_within(512 << 20, 1 << 14) == 1 << 14);
}

/// A table is answered as a whole if the memory holds its answers; one row more is refused before a row is judged, with the number that
/// it holds.
#[test]
fn a_table_whose_answers_exceed_the_memory_is_refused_before_work() {
    const MEMORY: u64 = 4 << 20;
    let rows = |count: usize| {
        batch(vec![("load.inertia [kg m^2]", Arc::new(Float64Array::from(vec![1.0; count])) as ArrayRef)])
    };
    let checks = questions::CheckId::ALL.to_vec();
    let every = sweep(&rows(1), Wanted::Every(checks.clone()));
    let most = usize::try_from(every.rows_held(MEMORY)).unwrap();
    assert!((2..20).contains(&most), "{most}");
    let table = [rows(1), rows(most - 1)];
    let answers = every.whole(&table, 7, MEMORY, &Progress::endless()).unwrap();
    // Few rows at a time, in the order of the table and with the cells of one batch.
    assert!(
        answers.len() > 2 && answers.len() >= most.div_ceil(every.rows_within(MEMORY, usize::MAX)),
        "{}",
        answers.len()
    );
    let one = every.batch(&rows(most), 7, &Progress::endless()).unwrap();
    let mut line = 0;
    for answer in &answers {
        assert_eq!(*answer, one.slice(line, answer.num_rows()));
        line += answer.num_rows();
    }
    assert_eq!(line, one.num_rows());
    // A cancelled call would end at its first row: what is refused was refused before.
    let cancelled = Progress::limited();
    cancelled.cancel();
    let why = every.whole(&[rows(most + 1)], 0, MEMORY, &cancelled).err().unwrap();
    let message = why.faults(None, quantities::Language::En).errors[0].message.clone();
    assert!(message.contains(&format!("the table has {} rows", most + 1)), "{message}");
    assert!(message.contains("4 MiB") && message.contains(&format!("at most {most} rows")), "{message}");
    let why = every.whole(&table, 0, MEMORY, &cancelled).err().unwrap();
    assert!(!why.faults(None, quantities::Language::En).errors[0].message.contains("rows"), "a smaller table begins");
    // The count holds the arrays of every kind of answer.
    for wanted in
        [Wanted::Best, Wanted::Every(checks), Wanted::Every(vec![questions::CheckId::PeakTorque]), Wanted::Front]
    {
        let table = rows(64);
        let sweep = sweep(&table, wanted.clone());
        let answer = sweep.batch(&table, 0, &Progress::endless()).unwrap();
        let counted = MEMORY as f64 * 64.0 / sweep.rows_held(MEMORY * 1024) as f64 * 1024.0;
        let held = answer.get_array_memory_size() as f64;
        assert!(held <= counted, "{wanted:?}: {held} bytes, {counted} counted");
    }
    // No memory is so small that a row is refused.
    assert_eq!(every.rows_held(0), 1);
}

/// A refused heading decides: the rest of the table is not read, and no row of one without any key.
#[test]
fn a_table_with_a_refused_heading_is_not_read_to_its_end() {
    let cells = || Arc::new(Float64Array::from(vec![1.0; 1000])) as ArrayRef;
    for columns in [vec![("nonsense", cells())], vec![("load.nonsense", cells()), ("load.inertia [kg m^2]", cells())]] {
        let is_one_a_key = columns.len() > 1;
        let table = batch(columns);
        let mut head =
            BatchHead::of(("axis.toml", MOVE), &NoFiles, &table.schema(), Repeats::default(), Options::default());
        assert_eq!(head.is_enough(), !is_one_a_key);
        head.check(&table, 0);
        assert!(head.is_enough());
        let Err(why) = head.ready("tasks", Box::new(NoFiles)) else { panic!("the heading is refused") };
        let texts: Vec<String> =
            why.faults(None, quantities::Language::En).errors.into_iter().map(|fault| fault.message).collect();
        assert!(texts.len() == 2 && texts[1].contains("not checked to its end"), "{texts:?}");
    }
}

#[test]
fn every_fault_of_headings_and_cells_is_reported_at_once() {
    let table = batch(vec![
        ("load.inerta [kg m^2]", Arc::new(Float64Array::from(vec![1.0])) as ArrayRef),
        ("load.friction_torque", Arc::new(Float64Array::from(vec![1.0]))),
        ("motion[1].time [kg]", Arc::new(Float64Array::from(vec![1.0]))),
    ]);
    let head = BatchHead::of(("axis.toml", MOVE), &NoFiles, &table.schema(), Repeats::default(), Options::default());
    let faults = head.ready("tasks", Box::new(NoFiles)).err().unwrap().faults(None, Options::default().language).errors;
    let ids: Vec<_> = faults.iter().filter_map(|fault| Some((fault.id?, fault.heading.clone()?))).collect();
    assert_eq!(
        ids,
        [
            ("unknown_key", "load.inerta [kg m^2]".to_owned()),
            ("unit_missing", "load.friction_torque".to_owned()),
            ("unit_of_another_quantity", "motion[1].time [kg]".to_owned())
        ]
    );
    assert!(faults[0].hint.as_ref().unwrap().contains("load.inertia"));
    // Below headings that are read the cells are looked at beside the wrong ones.
    let table = batch(vec![
        ("load.inerta [kg m^2]", Arc::new(Float64Array::from(vec![None, Some(1.0)])) as ArrayRef),
        ("motion[1].time [s]", Arc::new(StringArray::from(vec![Some("0.5"), None]))),
        ("motion[1].law", Arc::new(StringArray::from(vec!["trapezoid", "trapezoyd"]))),
    ]);
    let mut head =
        BatchHead::of(("axis.toml", MOVE), &NoFiles, &table.schema(), Repeats::default(), Options::default());
    head.check(&table, 7);
    let faults = head.ready("tasks", Box::new(NoFiles)).err().unwrap().faults(None, Options::default().language).errors;
    let found: Vec<_> = faults.iter().map(|fault| (fault.id.unwrap(), fault.row)).collect();
    assert_eq!(found, [("unknown_key", None), ("no_value", Some(8)), ("not_a_choice", Some(8))]);
    let table = batch(vec![
        ("load.inertia [kg m^2]", Arc::new(StringArray::from(vec!["1.5", "heavy"])) as ArrayRef),
        ("motion[1].time [s]", Arc::new(Float64Array::from(vec![None, Some(1.0)]))),
        ("code", Arc::new(StringArray::from(vec!["CHA-25A-50-H-C1024", "CHA-25A-55-H-C1024"]))),
    ]);
    let mut faults = TableFaults::default();
    sweep(&table, Wanted::Best).check(&table, 70, &mut faults);
    let found: Vec<_> = faults.listed.iter().map(|fault| (fault.id, fault.row)).collect();
    assert_eq!(found, [("not_a_number", Some(71)), ("no_value", Some(70)), ("code_spelling", Some(71))]);
}

#[test]
fn labels_and_inputs_are_repeated_beside_every_line_of_a_row() {
    let table = batch(vec![
        ("id", Arc::new(StringArray::from(vec![Some("a"), None, Some("c")])) as ArrayRef),
        ("load.inertia [kg m^2]", Arc::new(Float64Array::from(vec![1.0, -1.0, 2.0]))),
        ("station", Arc::new(Int64Array::from(vec![7, 8, 9]))),
    ]);
    for wanted in [Wanted::Best, Wanted::Front, Wanted::Every(vec![])] {
        let options = Options { wanted, ..Options::default() };
        for (repeats, names) in
            [(Repeats::Labels, &["id", "station"][..]), (Repeats::Inputs, &["id", "load.inertia [kg m^2]", "station"])]
        {
            let head = BatchHead::of(("axis.toml", MOVE), &NoFiles, &table.schema(), repeats, options.clone());
            let sweep = head.ready("tasks", Box::new(NoFiles)).unwrap();
            assert_eq!(sweep.carried().collect::<Vec<_>>(), names);
            // The second and third row, whose numbers do not begin at zero.
            let answer = sweep.batch(&table.slice(1, 2), 41, &Progress::endless()).unwrap();
            let rows = answer.column(0).as_primitive::<UInt64Type>();
            let (ids, stations) = (answer.column_by_name("id").unwrap(), answer.column_by_name("station").unwrap());
            for line in 0..answer.num_rows() {
                assert_eq!(
                    stations.as_primitive::<Int64Type>().value(line),
                    i64::try_from(rows.value(line)).unwrap() - 33
                );
                assert_eq!(ids.is_null(line), rows.value(line) == 41);
            }
            assert!(answer.num_rows() >= 2);
        }
    }
}

#[test]
fn a_label_with_a_name_of_the_answer_is_refused() {
    let table = batch(vec![
        ("load.inertia [kg m^2]", Arc::new(Float64Array::from(vec![1.0])) as ArrayRef),
        ("row", Arc::new(Int64Array::from(vec![7]))),
    ]);
    let head = BatchHead::of(("axis.toml", MOVE), &NoFiles, &table.schema(), Repeats::Labels, Options::default());
    assert!(head.ready("tasks", Box::new(NoFiles)).is_err());
}

/// Answers with decimal commas are read as a table with the same numbers and texts.
#[test]
fn a_file_with_decimal_commas_is_read_as_it_was_written() {
    let batch = batch(vec![
        ("load.inertia [kg m^2]", Arc::new(Float64Array::from(vec![Some(0.5), Some(-1250.25), None])) as ArrayRef),
        ("count", Arc::new(Int64Array::from(vec![1, 20_000, 3]))),
        ("id", Arc::new(StringArray::from(vec!["a;b", "c,d \"e\"", "f.g"]))),
    ]);
    for decimal in [Decimal::Point, Decimal::Comma] {
        let mut file = tempfile::tempfile().unwrap();
        let mut answers = Answers::begin(Vec::new(), Format::Csv(decimal), batch.schema()).unwrap();
        answers.add(&batch).unwrap();
        let bytes = answers.end().unwrap();
        let text = String::from_utf8(bytes.clone()).unwrap();
        assert_eq!(text.contains("-1250,25;20000;"), decimal == Decimal::Comma, "{text}");
        file.write_all(&bytes).unwrap();
        let mut read = Batches::open(file, 0, 9, Language::En).unwrap();
        assert_eq!(read.commas().may_be_decimal(), decimal == Decimal::Comma, "{text}");
        let found = read.next(Language::En).unwrap().unwrap();
        assert_eq!(found.schema().field(0).name(), "load.inertia [kg m^2]");
        let cells = |column: usize| -> Vec<Option<String>> {
            let texts = found.column(column).as_string::<i32>();
            texts
                .iter()
                .map(|text| text.map(|text| if column < 2 { text.replace(',', ".") } else { text.to_owned() }))
                .collect()
        };
        let some = |texts: [&str; 3]| texts.map(|text| (!text.is_empty()).then(|| text.to_owned()));
        assert_eq!(cells(0), some(["0.5", "-1250.25", ""]));
        assert_eq!(cells(1), some(["1", "20000", "3"]));
        assert_eq!(cells(2), some(["a;b", "c,d \"e\"", "f.g"]));
    }
}
