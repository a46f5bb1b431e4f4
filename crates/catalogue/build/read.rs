//! The files of `data/` as they are written: one struct per file format.

use crate::facts::{Fact, FactsFile};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A text in both languages.
#[derive(Deserialize, Default, Clone)]
#[serde(deny_unknown_fields)]
pub(crate) struct Bilingual {
    pub(crate) en: String,
    pub(crate) de: String,
}

/// A note on a table, in our own words.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Footnote {
    pub(crate) mark: Option<String>,
    pub(crate) symbol: Option<String>,
    pub(crate) by: Option<String>,
    pub(crate) en: String,
    pub(crate) de: String,
}

/// One row of a table file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Row {
    pub(crate) symbol: Option<String>,
    pub(crate) condition: Option<String>,
    pub(crate) drive: Option<String>,
    pub(crate) feedback: Option<String>,
    pub(crate) ratio: Option<String>,
    pub(crate) unit: Option<String>,
    pub(crate) note: Option<String>,
    pub(crate) cells: Vec<String>,
}

/// One table file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Table {
    pub(crate) table: String,
    pub(crate) section: Option<String>,
    pub(crate) page: Option<u16>,
    pub(crate) title: Bilingual,
    pub(crate) source: String,
    pub(crate) drive: Option<String>,
    pub(crate) feedback: Option<String>,
    #[serde(default)]
    pub(crate) keys: Vec<String>,
    #[serde(default)]
    pub(crate) columns: Vec<String>,
    #[serde(default, rename = "footnote")]
    pub(crate) footnotes: Vec<Footnote>,
    #[serde(rename = "row")]
    pub(crate) rows: Vec<Row>,
}

/// One entry of `errata.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Erratum {
    pub(crate) id: String,
    pub(crate) table: Option<String>,
    #[serde(default)]
    pub(crate) cell: BTreeMap<String, String>,
    #[serde(rename = "where")]
    pub(crate) place: Option<String>,
    #[serde(rename = "where_de")]
    pub(crate) place_de: Option<String>,
    pub(crate) recovered: Option<String>,
    pub(crate) recovered_de: Option<String>,
    pub(crate) printed: String,
    pub(crate) printed_de: Option<String>,
    pub(crate) corrected: String,
    pub(crate) corrected_de: Option<String>,
    pub(crate) checks_use: Option<String>,
    pub(crate) kind: String,
    pub(crate) status: String,
    pub(crate) evidence: String,
    pub(crate) evidence_de: String,
}

/// One entry of `sources.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Source {
    pub(crate) id: String,
    pub(crate) title: String,
    pub(crate) edition: Option<String>,
    pub(crate) language: Option<String>,
    pub(crate) publisher: Option<String>,
    pub(crate) kind: Option<String>,
    #[serde(rename = "where")]
    pub(crate) place: Option<String>,
    pub(crate) note: Option<String>,
}

/// One entry of `glossary.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Term {
    pub(crate) symbol: String,
    pub(crate) identifier: String,
    pub(crate) unit: Option<String>,
    pub(crate) en: String,
    pub(crate) de: String,
    pub(crate) note_en: Option<String>,
    pub(crate) note_de: Option<String>,
}

/// One entry of `cha/texts.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Text {
    pub(crate) printed: String,
    pub(crate) en: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TextsFile {
    text: Vec<Text>,
}

/// One word of the product in `glossary.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Word {
    pub(crate) id: String,
    pub(crate) en: String,
    pub(crate) de: String,
    pub(crate) about_en: String,
    pub(crate) about_de: String,
    pub(crate) not_en: Vec<String>,
    pub(crate) not_de: Vec<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ErrataFile {
    erratum: Vec<Erratum>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SourcesFile {
    source: Vec<Source>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct GlossaryFile {
    term: Vec<Term>,
    word: Vec<Word>,
}

/// All files of `data/`.
#[derive(Default)]
pub(crate) struct Data {
    pub(crate) tables: Vec<Table>,
    pub(crate) errata: Vec<Erratum>,
    pub(crate) sources: Vec<Source>,
    pub(crate) glossary: Vec<Term>,
    pub(crate) texts: Vec<Text>,
    pub(crate) words: Vec<Word>,
    pub(crate) facts: Vec<Fact>,
}

fn read_file<T: for<'de> Deserialize<'de>>(path: &Path, faults: &mut Vec<String>) -> Option<T> {
    let text = match std::fs::read_to_string(path) {
        Ok(text) => text,
        Err(fault) => {
            faults.push(format!("{}: {fault}", path.display()));
            return None;
        }
    };
    match toml::from_str(&text) {
        Ok(value) => Some(value),
        Err(fault) => {
            let line = fault.span().map_or(0, |span| text.get(..span.start).unwrap_or("").lines().count());
            faults.push(format!("{}:{line}: {}", path.display(), fault.message()));
            None
        }
    }
}

/// The TOML files below `folder`, in the order of their names read as numbers.
fn table_paths(folder: &Path, faults: &mut Vec<String>) -> Vec<PathBuf> {
    let entries = match std::fs::read_dir(folder) {
        Ok(entries) => entries,
        Err(fault) => {
            faults.push(format!("{}: {fault}", folder.display()));
            return Vec::new();
        }
    };
    let mut paths: Vec<PathBuf> = entries
        .flatten()
        .map(|entry| entry.path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .collect();
    paths.sort_by_key(|path| {
        let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
        let numbers: Option<Vec<u32>> = stem.split('.').map(|part| part.parse().ok()).collect();
        (numbers.is_none(), numbers.unwrap_or_default(), stem)
    });
    paths
}

/// Reads every file of `data/`; what cannot be read is a fault, not an end.
pub(crate) fn read_all(root: &Path, faults: &mut Vec<String>) -> Data {
    let mut data = Data::default();
    for folder in ["cha/tables", "published"] {
        let mut paths = table_paths(&root.join(folder), faults);
        if folder == "published" {
            paths.insert(0, root.join("cha/family.toml"));
        }
        for path in paths {
            let Some(table) = read_file::<Table>(&path, faults) else { continue };
            if path.file_stem().is_none_or(|stem| stem.to_string_lossy() != table.table) {
                faults.push(format!("{}: the file must be named after its table {}", path.display(), table.table));
            }
            data.tables.push(table);
        }
    }
    if let Some(file) = read_file::<ErrataFile>(&root.join("cha/errata.toml"), faults) {
        data.errata = file.erratum;
    }
    if let Some(file) = read_file::<SourcesFile>(&root.join("sources.toml"), faults) {
        data.sources = file.source;
    }
    if let Some(file) = read_file::<GlossaryFile>(&root.join("glossary.toml"), faults) {
        data.glossary = file.term;
        data.words = file.word;
    }
    if let Some(file) = read_file::<TextsFile>(&root.join("cha/texts.toml"), faults) {
        data.texts = file.text;
    }
    for path in table_paths(&root.join("cha/facts"), faults) {
        let Some(file) = read_file::<FactsFile>(&path, faults) else { continue };
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        for mut fact in file.fact {
            fact.file.clone_from(&name);
            data.facts.push(fact);
        }
    }
    data
}
