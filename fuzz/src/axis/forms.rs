//! Tables, pictures and the content of a report.

use super::Case;
use crate::text::tells;
use figures::{By, Figure, Style, draw};
use parquet::file::reader::{FileReader, SerializedFileReader};
use questions::{Candidate, Progress, Sampling, Sizing, answer, assess, reserve_of};
use report::{AxisContent, Content, Settings};
use serde_json::Value;
use tables::{Front, NAMES, Subject, Table};

/// Checks that every table is complete and has the same number of rows in every format.
pub(super) fn tables(case: &Case<'_>, sizing: &Sizing<'_>, best: &Candidate<'_>) {
    let subject = Subject {
        text: case.text,
        axis: case.place,
        project: case.project,
        sizing,
        chosen: best,
        top: 3,
        language: case.language,
    };
    let tables = subject.tables();
    assert_eq!(tables.len(), NAMES.len());
    for table in &tables {
        assert!(table.rows.iter().all(|row| row.len() == table.columns.len()), "{}", table.name);
        table.columns.iter().for_each(|column| tells(&column.title));
        let names: Vec<&String> = table.columns.iter().map(|column| &column.name).collect();
        assert!(names.iter().enumerate().all(|(at, name)| !names.iter().skip(at + 1).any(|other| other == name)));
        super::keeps_to_schema("export --table", &tables::record(table));
        let made = table.rows.iter().len();
        assert!(made == table.rows.len() || table.rows.len() > 2 * tables::SHEET_ROWS_MOST, "{}", table.name);
        assert_eq!(lines(&tables::csv(table)), made + 1, "{} as CSV", table.name);
        assert_eq!(parquet_rows(table), Some(made), "{} as Parquet", table.name);
    }
    let front = Front {
        file: "project.toml",
        revision: None,
        date: None,
        project: case.project,
        chosen: best,
        language: case.language,
    };
    // A workbook takes as long as everything else together.
    if case.text.len().is_multiple_of(8) {
        assert!(tables::xlsx(&tables, &front).is_ok_and(|bytes| bytes.starts_with(b"PK")));
    }
}

/// Counts the lines of CSV; a line break within quotes is none.
fn lines(text: &str) -> usize {
    let mut quoted = false;
    let breaks = |c: &char| {
        quoted ^= *c == '"';
        *c == '\n' && !quoted
    };
    text.chars().filter(breaks).count()
}

fn parquet_rows(table: &Table) -> Option<usize> {
    let bytes = tables::parquet(table).ok()?;
    let reader = SerializedFileReader::new(bytes::Bytes::from(bytes)).ok()?;
    usize::try_from(reader.metadata().file_metadata().num_rows()).ok()
}

/// Checks that every picture is well-formed and has its texts.
pub(super) fn figures(case: &Case<'_>, best: &Candidate<'_>) {
    for figure in Figure::ALL {
        let Ok(drawing) = draw(figure, case.project, best, By::Mass, &Progress::endless(), case.language) else {
            continue;
        };
        [&drawing.title, &drawing.caption, &drawing.description].into_iter().for_each(|text| tells(text));
        let picture = drawing.render(&Style::new(drawing.size()));
        let parsed = roxmltree::Document::parse(picture.svg());
        assert!(parsed.is_ok_and(|parsed| parsed.root_element().has_tag_name("svg")), "{}", figure.id());
        assert!(!tells_no_number(picture.svg()), "{}", figure.id());
    }
}

/// Checks the content of a report, and the input of its template.
pub(super) fn dossier(case: &Case<'_>, sizing: &Sizing<'_>, best: &Candidate<'_>) {
    let reserve = reserve_of(case.project, best);
    let assessment = assess(case.project, &[best], Sampling { samples: 5, seed: 1 }).pop();
    let about = (case.text, case.place, "antrieb");
    let found = answer::dossier(
        case.project,
        sizing,
        best,
        (&reserve, assessment.as_ref(), &questions::Proposals::default()),
        about,
        case.language,
    );
    assert_eq!(found.sizing.judged, sizing.candidates.len());
    assert!(!found.explained.is_empty());
    assert_eq!(found.bill_of_material.is_empty(), !best.fits(), "parts are listed of an actuator that fits");
    let rejected: usize = found.rejections.iter().map(|group| group.codes.len()).sum();
    assert_eq!(rejected, sizing.candidates.iter().filter(|each| !each.fits()).count());
    super::texts(&serde_json::to_value(&found).unwrap_or_default());
    let figure = report::Diagram {
        place: report::DiagramPlace::Motion,
        svgs: vec![String::new()],
        caption: String::from("caption"),
        alternative_text: String::from("description"),
    };
    let actuator_kind = answer::actuator_kind(best, case.language).to_owned();
    let axis = AxisContent { dossier: found, actuator_kind, figures: vec![figure], chapters: Vec::new() };
    let content = Content { language: case.language, axes: vec![axis.clone(), axis] };
    let date = chrono::NaiveDate::from_ymd_opt(2026, 11, 22);
    for full in [false, true] {
        let settings = Settings { date, full, ..Settings::default() };
        let document = report::document(&content, &settings);
        assert!(document.is_ok(), "{:?}", document.err());
        let document = document.unwrap_or_default();
        let axes = document.get("axes").and_then(Value::as_array).map(Vec::len);
        assert_eq!(axes, Some(2), "an axis is not named");
        numbers(&document);
    }
}

/// Checks that no infinite or undefined number enters a document, as a number or as text.
fn numbers(value: &Value) {
    match value {
        Value::String(text) => assert!(!tells_no_number(text), "{text:?}"),
        Value::Array(all) => all.iter().for_each(numbers),
        Value::Object(all) => all.values().for_each(numbers),
        _ => {}
    }
}

/// Returns `true` if a text contains a printed float that is no number: alone or after the letter of a path (`MNaN`),
/// but not within a word (`einfach`).
fn tells_no_number(text: &str) -> bool {
    let printed = |sign: &str| {
        text.match_indices(sign).any(|(at, _)| {
            let (before, behind) = (text[..at].chars().next_back(), text[at + sign.len()..].chars().next());
            !before.is_some_and(char::is_lowercase) && !behind.is_some_and(char::is_alphabetic)
        })
    };
    printed("NaN") || printed("inf")
}

#[cfg(test)]
mod tests {
    use super::tells_no_number;

    #[test]
    fn a_float_that_is_none_is_seen_and_a_word_is_not() {
        for text in ["NaN", "-inf", "MNaN 3", "L4,inf", "x=\"inf\"", "10 inf Nm"] {
            assert!(tells_no_number(text), "{text}");
        }
        for text in ["einfache Sinuslinie", "information", "3 reinf", "Nanometer", ""] {
            assert!(!tells_no_number(text), "{text}");
        }
    }
}
