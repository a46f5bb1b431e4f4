//! Every table of every example in every format.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a test fails loudly")]

use axis::Files;
use calamine::{Data, Reader as _, Xlsx};
use parquet::file::reader::{FileReader as _, SerializedFileReader};
use parquet::record::Field;
use quantities::Language;
use quantities::unit::{NEWTON_METRE, REVOLUTION_PER_MINUTE};
use questions::{Candidate, CheckId};
use recording::{Bytes, Layout};
use std::io::{Cursor, Read};
use std::path::PathBuf;
use tables::{
    AxisSheets, Cell, ColumnContent, Front, NAMES, Subject, Table, csv, parquet as to_parquet, record, xlsx,
    xlsx_of_axes,
};

struct RecordingFolder(PathBuf);

impl Files for RecordingFolder {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>> {
        Ok(Box::new(std::fs::File::open(self.0.join(name))?))
    }
}

/// Calls with the tables of each axis of each example.
fn each(language: Language, top: usize, look: &mut dyn FnMut(&str, &[Table], &Front<'_>)) {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut files: Vec<PathBuf> = std::fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
        .collect();
    files.sort();
    assert!(files.len() >= 10);
    for path in files {
        let text = std::fs::read_to_string(&path).unwrap();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let projects = questions::read_all(&text, &RecordingFolder(folder.clone())).unwrap();
        for (axis, project) in projects.iter().enumerate() {
            let sizing = questions::size(project);
            let chosen: Candidate<'_> = match &sizing.own {
                Some(own) => own.clone(),
                None => sizing.candidates[0].clone(),
            };
            let subject = Subject { text: &text, axis, project, sizing: &sizing, chosen: &chosen, top, language };
            let front = Front {
                file: &name,
                revision: Some("C"),
                date: chrono::NaiveDate::from_ymd_opt(2026, 3, 1),
                project,
                chosen: &chosen,
                language,
            };
            look(&name, &subject.tables(), &front);
        }
    }
}

fn table<'t>(tables: &'t [Table], name: &str) -> &'t Table {
    tables.iter().find(|table| table.name == name).unwrap()
}

#[test]
fn every_table_is_whole() {
    for language in [Language::En, Language::De] {
        each(language, 3, &mut |file, tables, front| {
            assert_eq!(tables.iter().map(|table| table.name).collect::<Vec<_>>(), NAMES);
            for table in tables {
                let mut names: Vec<&str> = table.columns.iter().map(|column| column.name.as_str()).collect();
                names.sort_unstable();
                names.dedup();
                assert_eq!(names.len(), table.columns.len(), "{file} {}", table.name);
                for column in &table.columns {
                    assert!(
                        column.name.is_ascii() && !column.title.is_empty() && !column.about.is_empty(),
                        "{column:?}"
                    );
                }
                for row in table.rows.iter() {
                    assert_eq!(row.len(), table.columns.len());
                    for (cell, column) in row.iter().zip(&table.columns) {
                        let fits = match cell {
                            Cell::Number(number) => number.is_finite() && column.is_numeric(),
                            Cell::Text(_) | Cell::Word(..) | Cell::Ids(..) => !column.is_numeric(),
                            Cell::Empty => true,
                        };
                        assert!(fits, "{file} {} {}: {cell:?}", table.name, column.name);
                    }
                }
            }
            let judged = table(tables, "candidates").rows.len();
            assert!((3..=4).contains(&judged), "{file}: {judged}");
            let checks = table(tables, "checks");
            let code = front.chosen.id.to_string();
            let own = checks.rows.iter().filter(|row| row[0].as_text() == Some(&code)).count();
            assert_eq!(own, front.chosen.judgement.checks.len().max(own), "{file}");
            assert_eq!(checks.rows.get(0).unwrap()[0].as_text(), Some(code.as_str()), "the chosen one stands first");
            let mut concerning = front.project.assumptions.clone();
            concerning.retain(|each| front.chosen.is_concerned_by(*each));
            let assumed = concerning.len() + usize::from(front.chosen.how_named(language).is_some());
            assert_eq!(table(tables, "assumptions").rows.len(), assumed);
            assert_eq!(table(tables, "motion").rows.len(), questions::moves(front.project).moves.len());
            assert!(table(tables, "inputs").rows.len() > 10 && table(tables, "course").rows.len() > 10);
            let demand = table(tables, "demand");
            let exact = front.chosen.judgement.demand.unwrap().torque_rms.value;
            let found = demand
                .rows
                .iter()
                .find(|row| row[0].as_text() == Some(&code) && row[1].as_text() == Some("integral"))
                .unwrap();
            assert!((found[2].as_number().unwrap() / exact - 1.0).abs() < 1e-11, "{file}");
        });
    }
}

#[test]
fn names_and_units_are_the_same_in_both_languages() {
    let mut heads: Vec<Vec<String>> = Vec::new();
    for language in [Language::En, Language::De] {
        let mut of = Vec::new();
        each(language, 2, &mut |_, tables, _| {
            of.extend(tables.iter().flat_map(|table| table.columns.iter().map(tables::Column::header)));
        });
        heads.push(of);
    }
    assert_eq!(heads[0], heads[1]);
}

/// Reads the records of a CSV with an independent reader.
fn records(text: &str) -> Vec<Vec<String>> {
    let mut reader = csv_core::ReaderBuilder::new().build();
    let (mut input, mut out, mut ends) = (text.as_bytes(), vec![0; text.len() + 8], vec![0; 256]);
    let mut found = Vec::new();
    loop {
        let (result, read, written, ended) = reader.read_record(input, &mut out, &mut ends);
        input = &input[read..];
        match result {
            csv_core::ReadRecordResult::Record => {
                let (mut from, mut record) = (0, Vec::new());
                for end in &ends[..ended] {
                    record.push(String::from_utf8(out[from..*end].to_vec()).unwrap());
                    from = *end;
                }
                assert_eq!(from, written);
                found.push(record);
            }
            csv_core::ReadRecordResult::End => return found,
            csv_core::ReadRecordResult::InputEmpty => {}
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn csv_comes_back_as_it_was() {
    each(Language::De, 3, &mut |file, tables, _| {
        for table in tables {
            let text = csv(table);
            assert!(!text.replace("\r\n", "").contains('\r'));
            let records = records(&text);
            let heads: Vec<String> = table.columns.iter().map(tables::Column::header).collect();
            assert_eq!(records[0], heads);
            assert_eq!(records.len(), table.rows.len() + 1, "{file} {}", table.name);
            for (record, row) in records[1..].iter().zip(table.rows.iter()) {
                for (field, cell) in record.iter().zip(row.iter()) {
                    match cell {
                        Cell::Number(number) => assert_eq!(field.parse::<f64>().unwrap(), *number),
                        other => {
                            // An apostrophe marks text.
                            let text = other.as_text().unwrap_or("");
                            let plain = field.strip_prefix('\'').filter(|rest| rest.starts_with(['=', '+', '-', '@']));
                            assert_eq!(plain.unwrap_or(field), text);
                        }
                    }
                }
            }
        }
    });
}

#[test]
fn json_holds_the_columns_and_a_record_for_each_row() {
    each(Language::En, 3, &mut |_, tables, _| {
        for table in tables {
            let value: serde_json::Value = serde_json::to_value(record(table)).unwrap();
            assert_eq!(value["table"], table.name);
            assert_eq!(value["columns"].as_array().unwrap().len(), table.columns.len());
            let rows = value["rows"].as_array().unwrap();
            assert_eq!(rows.len(), table.rows.len());
            for (record, row) in rows.iter().zip(table.rows.iter()) {
                for (column, cell) in table.columns.iter().zip(row.iter()) {
                    let found = &record[&column.name];
                    match cell {
                        Cell::Number(number) => assert_eq!(found.as_f64(), Some(*number)),
                        other => assert_eq!(found.as_str(), other.as_text()),
                    }
                }
            }
        }
    });
}

#[test]
fn parquet_comes_back_as_it_was() {
    each(Language::De, 3, &mut |file, tables, _| {
        for table in tables {
            let bytes = to_parquet(table).unwrap();
            let reader = SerializedFileReader::new(Bytes::from(bytes)).unwrap();
            let pairs = reader.metadata().file_metadata().key_value_metadata().unwrap();
            for column in table.columns.iter().filter(|column| column.unit.is_some()) {
                let key = format!("{}.unit", column.name);
                let unit = pairs.iter().find(|pair| pair.key == key).unwrap().value.as_deref();
                assert_eq!(unit, column.unit.map(|unit| unit.json));
            }
            let mut count = 0;
            for (record, row) in reader.get_row_iter(None).unwrap().zip(table.rows.iter()) {
                for ((_, field), cell) in record.unwrap().get_column_iter().zip(row.iter()) {
                    match (field, cell) {
                        (Field::Double(found), Cell::Number(number)) => assert_eq!(found, number),
                        (Field::Str(found), cell) => assert_eq!(Some(found.as_str()), cell.as_text()),
                        (Field::Null, Cell::Empty) => {}
                        other => panic!("{file} {}: {other:?}", table.name),
                    }
                }
                count += 1;
            }
            assert_eq!(count, table.rows.len());
        }
    });
}

/// Returns the course with unique instants, which a recording requires.
fn rising(course: &Table) -> Table {
    let mut rows: Vec<Vec<Cell>> = Vec::new();
    for row in course.rows.iter() {
        if rows.last().is_none_or(|last| last[0].as_number() < row[0].as_number()) {
            rows.push(row.into_owned());
        }
    }
    Table { rows: rows.into_iter().collect(), ..course.clone() }
}

#[test]
fn the_course_can_be_read_as_a_recording_with_its_units() {
    each(Language::En, 1, &mut |file, tables, _| {
        let course = rising(table(tables, "course"));
        let by_parquet = recording::read_parquet(Bytes::from(to_parquet(&course).unwrap()), &Layout::default());
        let by_csv = recording::read_csv(csv(&course).as_bytes(), &Layout { allow_gaps: true, ..Layout::default() });
        let read = match by_parquet {
            Ok(read) => read,
            // A long rest between short ramps is a gap to a recording.
            Err(_) => recording::read_parquet(
                Bytes::from(to_parquet(&course).unwrap()),
                &Layout { allow_gaps: true, ..Layout::default() },
            )
            .unwrap_or_else(|faults| panic!("{file}: {faults:?}")),
        };
        assert_eq!(read.time_s.len(), course.rows.len());
        let column = |name: &str| course.numbers(course.column(name).unwrap()).map(Option::unwrap).collect::<Vec<_>>();
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * a.abs().max(1.0);
        let speeds = &read.course.speed.as_ref().unwrap().values;
        for (si, speed) in speeds.iter().zip(column("speed")) {
            assert!(near(REVOLUTION_PER_MINUTE.from_si(*si), speed));
        }
        for (si, torque) in read.torque.as_ref().unwrap().values.iter().zip(column("torque")) {
            assert!(near(NEWTON_METRE.from_si(*si), torque));
        }
        let again = by_csv.unwrap_or_else(|faults| panic!("{file}: {faults:?}"));
        assert_eq!((again.time_s, again.torque), (read.time_s, read.torque), "both formats say the same");
    });
}

#[test]
fn a_workbook_opens_with_every_row_and_live_formulas() {
    for language in [Language::En, Language::De] {
        each(language, 3, &mut |file, tables, front| {
            let bytes = xlsx(tables, front).unwrap();
            let mut book: Xlsx<_> = Xlsx::new(Cursor::new(bytes)).unwrap();
            let sheets = book.sheet_names();
            assert_eq!(sheets.len(), tables.len() + 3, "{file}: {sheets:?}");
            for table in tables {
                let range = book.worksheet_range(&table.title).unwrap();
                let formulas = book.worksheet_formula(&table.title).unwrap();
                let (mut shares, mut live) = (0, 0);
                for (row, cells) in (2_u32..).zip(table.rows.iter()) {
                    for (at, (cell, column)) in (0_u32..).zip(cells.iter().zip(&table.columns)) {
                        let found = range.get_value((row, at));
                        match (cell, found) {
                            (Cell::Number(number), Some(Data::Float(found))) => assert_eq!(number, found),
                            (Cell::Number(number), Some(Data::Int(found))) => assert_eq!(*number, *found as f64),
                            (
                                Cell::Text(text) | Cell::Word(_, text) | Cell::Ids(_, text),
                                Some(Data::String(found)),
                            ) => {
                                assert_eq!(text, found);
                            }
                            (Cell::Empty, None | Some(Data::Empty)) => {}
                            (Cell::Word(_, text), None | Some(Data::Empty)) if text.is_empty() => {}
                            other => panic!("{file} {} {row} {at}: {other:?}", table.name),
                        }
                        if table.name == "checks" && column.kind == ColumnContent::Share && cell.as_number().is_some() {
                            shares += 1;
                            live += usize::from(formulas.get_value((row, at)).is_some_and(|text| !text.is_empty()));
                        }
                    }
                }
                assert!(live * 10 >= shares * 9, "{file} {}: {live} of {shares}", table.name);
                assert!(table.name != "checks" || live > 0);
            }
            // The effective torque once more: the formula's value stands beside the exact one.
            let cover = book.worksheet_range(&sheets[0]).unwrap();
            let of = |label: &str| {
                let row = cover.rows().find(|row| row[0] == Data::String(label.to_owned())).unwrap();
                match row[1] {
                    Data::Float(number) => number,
                    ref other => panic!("{other:?}"),
                }
            };
            let (course, exact) = match language {
                Language::En => (of("T_rms from the time series"), of("T_rms exact")),
                Language::De => (of("T_rms aus dem Verlauf"), of("T_rms exakt")),
            };
            // The formula is the trapezoidal rule over the rows: within 2 ‰, and 5 ‰ where a crank bends the torque between them.
            let bound = if ["four-bar.toml", "slider-crank.toml"].contains(&file) { 5e-3 } else { 2e-3 };
            assert!((course / exact - 1.0).abs() < bound, "{file}: {course} {exact}");
        });
    }
}

/// Sheets of several axes, also of one name, have permitted names of their own, and formulas refer to sheets of the same axis.
#[test]
fn a_workbook_of_several_axes_keeps_their_sheets_apart() {
    for language in [Language::En, Language::De] {
        each(language, 2, &mut |file, tables, front| {
            let axes: Vec<AxisSheets<'_>> =
                (0..3).map(|_| AxisSheets { tables: tables.to_vec(), front: *front }).collect();
            let bytes = xlsx_of_axes(axes.clone(), language).unwrap();
            assert!(bytes == xlsx_of_axes(axes, language).unwrap(), "{file}");
            let mut book: Xlsx<_> = Xlsx::new(Cursor::new(bytes)).unwrap();
            let sheets = book.sheet_names();
            assert_eq!(sheets.len(), 3 * (tables.len() + 2) + 2, "{file}: {sheets:?}");
            let mut distinct: Vec<String> = sheets.iter().map(|name| name.to_lowercase()).collect();
            distinct.sort_unstable();
            distinct.dedup();
            assert_eq!(distinct.len(), sheets.len(), "{sheets:?}");
            for name in &sheets {
                assert!(
                    name.chars().count() <= 31 && !name.contains(['[', ']', ':', '*', '?', '/', '\\', '\'']),
                    "{name}"
                );
            }
            let mut referred = 0;
            for of_axis in sheets[1..sheets.len() - 1].chunks(tables.len() + 2) {
                for name in of_axis {
                    let formulas = book.worksheet_formula(name).unwrap();
                    for (_, _, formula) in formulas.used_cells() {
                        for other in formula.split('\'').skip(1).step_by(2) {
                            assert!(of_axis.iter().any(|own| own == other), "{file} {name}: {formula}");
                            referred += 1;
                        }
                    }
                }
            }
            assert!(referred >= 3 || !sheets.iter().any(|name| name.contains("Time series")), "{file}");
            let first = book.worksheet_range(&sheets[0]).unwrap();
            let code = Data::String(front.chosen.id.to_string());
            assert_eq!(first.rows().filter(|row| row.contains(&code)).count(), 3, "{file}");
            let one = xlsx_of_axes(vec![AxisSheets { tables: tables.to_vec(), front: *front }], language).unwrap();
            assert!(one == xlsx(tables, front).unwrap(), "{file}: one axis is the workbook of one");
        });
    }
}

/// One word for one thing in the workbook too: the glossary names the words that are not used.
#[test]
fn a_german_workbook_has_no_second_word_for_a_thing() {
    let twins: Vec<String> =
        catalogue::words().iter().flat_map(|word| word.not_de).map(|twin| twin.to_lowercase()).collect();
    let mut cells = 0;
    each(Language::De, 2, &mut |name, tables, front| {
        let mut book: Xlsx<_> = Xlsx::new(Cursor::new(xlsx(tables, front).unwrap())).unwrap();
        for sheet in book.sheet_names() {
            let texts = book.worksheet_range(&sheet).unwrap();
            assert!(!twins.contains(&sheet.to_lowercase()), "{sheet}");
            let strings = texts.used_cells().filter_map(|(_, _, cell)| match cell {
                Data::String(text) => Some(text.to_lowercase()),
                _ => None,
            });
            for text in strings {
                cells += 1;
                let found = twins.iter().find(|twin| {
                    text.match_indices(twin.as_str())
                        .any(|(at, _)| !text[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == '-'))
                });
                assert!(found.is_none(), "{name}, {sheet}: {found:?} in {text}");
            }
        }
    });
    assert!(cells > 500, "{cells}");
}

#[test]
fn the_same_tables_give_the_same_bytes() {
    each(Language::De, 3, &mut |file, tables, front| {
        assert!(xlsx(tables, front).unwrap() == xlsx(tables, front).unwrap(), "{file}");
        for table in tables {
            assert!(to_parquet(table).unwrap() == to_parquet(table).unwrap(), "{file} {}", table.name);
        }
    });
}

#[test]
fn a_long_course_is_left_to_the_other_formats() {
    each(Language::En, 1, &mut |file, tables, front| {
        if file != "indexing-table.toml" {
            return;
        }
        let mut tables = tables.to_vec();
        let course = tables.iter_mut().find(|table| table.name == "course").unwrap();
        let row = course.rows.get(0).unwrap().into_owned();
        course.rows = std::iter::repeat_n(row, tables::SHEET_ROWS_MOST + 1).collect();
        let mut book: Xlsx<_> = Xlsx::new(Cursor::new(xlsx(&tables, front).unwrap())).unwrap();
        assert!(!book.sheet_names().contains(&"Time series".to_owned()));
        let cover = book.worksheet_range("Overview").unwrap();
        let shown = cover.rows().find(|row| row[0] == Data::String("Time series".to_owned())).unwrap();
        assert!(shown[1].to_string().contains("--table course"), "{shown:?}");
    });
}

/// The choice of the report, the page and the terminal: a recommendation and a class show a utilisation only as the reason
/// of a verdict, and never a margin.
#[test]
fn a_recommendation_or_a_class_that_is_met_has_no_utilisation_in_a_table() {
    let (mut met, mut shown, mut columns) = (0, 0, 0);
    each(Language::En, 3, &mut |name, tables, _| {
        let checks = table(tables, "checks");
        let of = |column: &str| checks.column(column).unwrap();
        for row in checks.rows.iter() {
            // A workbook has no identifiers; a check with several titles is that of its usual one.
            let title = row[of("title")].as_text().unwrap();
            let Some(id) = CheckId::ALL.iter().find(|id| words::check_title(**id, Language::En) == title) else {
                continue;
            };
            let verdict = row[of("verdict")].as_text().unwrap();
            let [utilisation, margin] = ["utilisation", "margin"].map(|column| row[of(column)].as_number());
            if id.has_margin() {
                assert_eq!(utilisation.is_some(), margin.is_some(), "{name} {id:?}");
            } else if verdict == "pass" {
                assert_eq!((utilisation, margin), (None, None), "{name} {id:?}");
                met += 1;
            } else {
                assert!(verdict == "fail" || margin.is_none(), "{name} {id:?}");
                shown += usize::from(utilisation.is_some());
            }
        }
        for column in &table(tables, "candidates").columns {
            let Some(id) = CheckId::ALL.iter().find(|known| known.id() == column.name) else { continue };
            let expected = if id.has_margin() { ColumnContent::Share } else { ColumnContent::Ratio };
            assert_eq!(column.kind, expected, "{name} {id:?}");
            columns += 1;
        }
    });
    assert!(met > 40 && shown > 5 && columns > 300, "{met} {shown} {columns}");
}
