//! Every cell of the workbook of every example as its readers see it: no internal identifier but names to type, no English in a
//! German workbook, and the errata of the data beside the figures that they touch.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a test fails loudly")]

use axis::Files;
use calamine::{Data, Reader as _, Xlsx};
use quantities::Language;
use questions::Candidate;
use std::io::{Cursor, Read};
use std::path::PathBuf;
use tables::{Front, Subject, xlsx};
use testkit::readers::{english, identifiers};
use words::{tables as table_words, terms};

struct Recordings(PathBuf);

impl Files for Recordings {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>> {
        Ok(Box::new(std::fs::File::open(self.0.join(name))?))
    }
}

/// Columns by heading whose cells a reader types elsewhere: keys, names in data exchange, files; ids are hidden.
fn is_typed(heading: &str, language: Language) -> bool {
    let typed = [
        table_words::written,
        table_words::key,
        table_words::name_in_csv_json_parquet,
        table_words::check_id,
        table_words::errata_of_data,
    ];
    typed
        .iter()
        .any(|word| word(language).eq_ignore_ascii_case(heading) || words::capitalised(word(language)) == heading)
}

fn faults(file: &str, bytes: &[u8], front: &Front<'_>) -> Vec<String> {
    let language = front.language;
    let mut book: Xlsx<_> = Xlsx::new(Cursor::new(bytes)).unwrap();
    let mut found = Vec::new();
    for name in book.sheet_names() {
        let range = book.worksheet_range(&name).unwrap();
        let heads: Vec<String> =
            range.rows().next().map(|row| row.iter().map(ToString::to_string).collect()).unwrap_or_default();
        for row in range.rows().skip(1) {
            for (column, cell) in row.iter().enumerate() {
                let Data::String(text) = cell else { continue };
                if heads.get(column).is_some_and(|head| is_typed(head, language)) || text == front.file {
                    continue;
                }
                let text = words::without_keys(text, language).into_owned();
                let errata = |each: &String| !catalogue::errata().iter().any(|known| known.id.contains(each.as_str()));
                found
                    .extend(identifiers(&text).into_iter().filter(errata).map(|each| format!("{file} {name}: {each}")));
                // What the user wrote stays as written.
                if language == Language::De
                    && heads.get(column).is_none_or(|head| head != table_words::written(language))
                {
                    let names = catalogue::documents().iter().flat_map(|each| [each.title, each.short]);
                    let own = names.fold(text, |text, name| text.replace(name, "")).replace(&front.project.name, "");
                    found.extend(english(&own).into_iter().map(|each| format!("{file} {name}: {each}")));
                }
            }
        }
    }
    found
}

/// The errata of the data of each row of candidates stand in the row; a candidate without any has none.
fn errata_are_marked(file: &str, bytes: &[u8], subject: &Subject<'_>) -> usize {
    let mut book: Xlsx<_> = Xlsx::new(Cursor::new(bytes)).unwrap();
    let sheet = words::capitalised(terms::candidates(subject.language));
    let range = book.worksheet_range(&sheet).unwrap();
    let heads: Vec<String> = range.rows().next().unwrap().iter().map(ToString::to_string).collect();
    let of =
        |word: words::Word| heads.iter().position(|head| head.eq_ignore_ascii_case(word(subject.language))).unwrap();
    let (code, errata) = (of(terms::ordering_code), of(table_words::errata_of_data));
    let mut marked = 0;
    for candidate in &subject.sizing.candidates {
        if candidate.product.is_of_project() {
            continue;
        }
        let name = candidate.id.to_string();
        let Some(row) = range.rows().find(|row| row[code].to_string() == name) else { continue };
        let data = candidate.parameters;
        let ids = [data.mass.known().map(|each| each.errata), data.length.known().map(|each| each.errata)];
        for id in ids.into_iter().flatten().flatten() {
            // By table and cell: the reader does not know the ids of the data.
            let shown = row[errata].to_string();
            assert!(!shown.is_empty() && !shown.contains(id), "{file} {name}: {id}");
            marked += 1;
        }
    }
    marked
}

fn in_language(language: Language) {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut files: Vec<PathBuf> = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    files.sort();
    let (mut found, mut marked) = (Vec::new(), 0);
    for path in files {
        let text = std::fs::read_to_string(&path).unwrap();
        let file = path.file_name().unwrap().to_string_lossy().into_owned();
        for (axis, project) in questions::read_all(&text, &Recordings(folder.clone())).unwrap().iter().enumerate() {
            let sizing = questions::size(project);
            let chosen: Candidate<'_> = sizing.own.as_ref().unwrap_or(&sizing.candidates[0]).clone();
            let top = 40;
            let subject = Subject { text: &text, axis, project, sizing: &sizing, chosen: &chosen, top, language };
            let front = Front { file: &file, revision: None, date: None, project, chosen: &chosen, language };
            let bytes = xlsx(&subject.tables(), &front).unwrap();
            found.extend(faults(&file, &bytes, &front));
            marked += errata_are_marked(&file, &bytes, &subject);
        }
    }
    found.sort();
    found.dedup();
    assert!(found.is_empty(), "{} faults\n{}", found.len(), found.join("\n"));
    assert!(marked > 0, "no erratum in any workbook");
}

#[test]
fn no_cell_of_an_english_workbook_shows_an_identifier() {
    in_language(Language::En);
}

#[test]
fn no_cell_of_a_german_workbook_shows_an_identifier_or_english() {
    in_language(Language::De);
}
