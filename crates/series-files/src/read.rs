//! File formats of `data/`: one struct per format.
#![allow(missing_docs, reason = "data/README.md describes every key")]

use crate::code::Code;
use crate::fact_file::{FactEntry, FactsFile};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A text in both languages.
#[derive(Deserialize, Default, Clone)]
#[serde(deny_unknown_fields)]
pub struct Bilingual {
    pub en: String,
    pub de: String,
}

/// A note on a table in the project's own words.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Footnote {
    pub mark: Option<String>,
    pub symbol: Option<String>,
    pub by: Option<String>,
    pub en: String,
    pub de: String,
}

/// One row of a table file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TableRow {
    pub symbol: Option<String>,
    pub condition: Option<String>,
    pub drive: Option<String>,
    pub feedback: Option<String>,
    pub ratio: Option<String>,
    pub unit: Option<String>,
    pub note: Option<String>,
    pub cells: Vec<String>,
}

/// One table file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TableFile {
    pub table: String,
    pub section: Option<String>,
    pub page: Option<u16>,
    pub title: Bilingual,
    pub source: String,
    pub drive: Option<String>,
    pub feedback: Option<String>,
    #[serde(default)]
    pub keys: Vec<String>,
    #[serde(default)]
    pub columns: Vec<String>,
    #[serde(default, rename = "footnote")]
    pub footnotes: Vec<Footnote>,
    #[serde(rename = "row")]
    pub rows: Vec<TableRow>,
}

/// One entry of `errata.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ErratumEntry {
    pub id: String,
    pub table: Option<String>,
    #[serde(default)]
    pub cell: BTreeMap<String, String>,
    /// Words of the fields `feedback`, `winding` and `size` in the codes that an erratum of a table concerns.
    #[serde(default)]
    pub concerns: BTreeMap<String, Vec<String>>,
    #[serde(rename = "where")]
    pub place: Option<String>,
    #[serde(rename = "where_de")]
    pub place_de: Option<String>,
    pub recovered: Option<String>,
    pub recovered_de: Option<String>,
    pub printed: String,
    pub printed_de: Option<String>,
    pub corrected: String,
    pub corrected_de: Option<String>,
    pub checks_use: Option<String>,
    pub kind: String,
    pub status: String,
    pub evidence: String,
    pub evidence_de: String,
}

/// One entry of `sources.toml`; names and fields are those of the type in `catalogue`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SourceDocument {
    pub id: String,
    pub short: String,
    #[serde(default)]
    pub short_de: String,
    pub title: String,
    #[serde(default)]
    pub title_de: String,
    #[serde(default)]
    pub edition: String,
    #[serde(default)]
    pub language: String,
    #[serde(default)]
    pub publisher: String,
    #[serde(default)]
    pub kind: String,
    #[serde(default, rename = "where")]
    pub place: String,
    #[serde(default)]
    pub note: String,
}

/// One entry of `glossary.toml`; names and fields are those of the type in `catalogue`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Term {
    pub symbol: String,
    pub identifier: String,
    #[serde(default)]
    pub unit: String,
    pub en: String,
    pub de: String,
    #[serde(default)]
    pub note_en: String,
    #[serde(default)]
    pub note_de: String,
}

/// One entry of `cha/texts.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Text {
    pub printed: String,
    pub en: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TextsFile {
    text: Vec<Text>,
}

/// One word of the product in `glossary.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WordEntry {
    pub id: String,
    pub en: String,
    pub de: String,
    pub about_en: String,
    pub about_de: String,
    pub not_en: Vec<String>,
    pub not_de: Vec<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ErrataFile {
    erratum: Vec<ErratumEntry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SourcesFile {
    source: Vec<SourceDocument>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct GlossaryFile {
    term: Vec<Term>,
    word: Vec<WordEntry>,
}

/// Content of the files of `data/`.
#[derive(Default)]
pub struct Data {
    pub tables: Vec<TableFile>,
    pub errata: Vec<ErratumEntry>,
    pub sources: Vec<SourceDocument>,
    pub glossary: Vec<Term>,
    pub texts: Vec<Text>,
    pub words: Vec<WordEntry>,
    pub facts: Vec<FactEntry>,
    pub codes: Vec<Code>,
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

/// Returns the entries of a folder.
fn entries(folder: &Path, faults: &mut Vec<String>) -> Vec<PathBuf> {
    match std::fs::read_dir(folder) {
        Ok(entries) => entries.flatten().map(|entry| entry.path()).collect(),
        Err(fault) => {
            faults.push(format!("{}: {fault}", folder.display()));
            Vec::new()
        }
    }
}

/// Returns the TOML files in `folder`, sorted by their names read as numbers.
fn table_paths(folder: &Path, faults: &mut Vec<String>) -> Vec<PathBuf> {
    let mut paths = entries(folder, faults);
    paths.retain(|path| path.extension().is_some_and(|e| e == "toml"));
    paths.sort_by_key(|path| {
        let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
        let numbers: Option<Vec<u32>> = stem.split('.').map(|part| part.parse().ok()).collect();
        (numbers.is_none(), numbers.unwrap_or_default(), stem)
    });
    paths
}

/// Returns the folders of series in `data/`, sorted by name: those with a `code.toml`.
pub fn series_folders(root: &Path, faults: &mut Vec<String>) -> Vec<PathBuf> {
    let mut folders = entries(root, faults);
    folders.retain(|path| path.join("code.toml").is_file());
    folders.sort();
    folders
}

/// Returns the ordering codes of the series in `data/`.
pub fn codes(root: &Path, faults: &mut Vec<String>) -> Vec<Code> {
    series_folders(root, faults).iter().filter_map(|folder| code(folder, faults)).collect()
}

fn code(folder: &Path, faults: &mut Vec<String>) -> Option<Code> {
    let code = read_file::<Code>(&folder.join("code.toml"), faults)?;
    code.check(faults);
    Some(code)
}

/// Reads every file of `data/`; a file that cannot be read is reported, and reading continues.
pub fn read_all(root: &Path, faults: &mut Vec<String>) -> Data {
    let folders = series_folders(root, faults);
    let mut data = Data::default();
    for folder in &folders {
        read_tables(&folder.join("tables"), &mut data, faults);
    }
    for folder in &folders {
        read_series(folder, &mut data, faults);
    }
    read_tables(&root.join("published"), &mut data, faults);
    read_shared(root, &mut data, faults);
    data
}

/// Reads one series from another folder, with the sources and the glossary of `data/`.
pub fn read_one(root: &Path, folder: &Path, faults: &mut Vec<String>) -> Data {
    let mut data = Data::default();
    read_tables(&folder.join("tables"), &mut data, faults);
    read_series(folder, &mut data, faults);
    read_shared(root, &mut data, faults);
    if let Some(file) = optional::<SourcesFile>(&folder.join("sources.toml"), faults) {
        data.sources.extend(file.source);
    }
    data
}

fn read_tables(folder: &Path, data: &mut Data, faults: &mut Vec<String>) {
    for path in table_paths(folder, faults) {
        let Some(table) = read_file::<TableFile>(&path, faults) else { continue };
        if path.file_stem().is_none_or(|stem| stem.to_string_lossy() != table.table) {
            faults.push(format!("{}: the file must be named after its table {}", path.display(), table.table));
        }
        data.tables.push(table);
    }
}

/// Reads the files of a series except its tables.
fn read_series(folder: &Path, data: &mut Data, faults: &mut Vec<String>) {
    data.codes.extend(code(folder, faults));
    data.tables.extend(read_file::<TableFile>(&folder.join("family.toml"), faults));
    if let Some(file) = optional::<ErrataFile>(&folder.join("errata.toml"), faults) {
        data.errata.extend(file.erratum);
    }
    if let Some(file) = optional::<TextsFile>(&folder.join("texts.toml"), faults) {
        data.texts.extend(file.text);
    }
    if !folder.join("facts").is_dir() {
        return;
    }
    for path in table_paths(&folder.join("facts"), faults) {
        let Some(file) = read_file::<FactsFile>(&path, faults) else { continue };
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        for mut fact in file.fact {
            fact.file.clone_from(&name);
            fact.series = data.codes.len().saturating_sub(1);
            data.facts.push(fact);
        }
    }
}

fn read_shared(root: &Path, data: &mut Data, faults: &mut Vec<String>) {
    if let Some(file) = read_file::<SourcesFile>(&root.join("sources.toml"), faults) {
        data.sources = file.source;
    }
    if let Some(file) = read_file::<GlossaryFile>(&root.join("glossary.toml"), faults) {
        data.glossary = file.term;
        data.words = file.word;
    }
}

/// Reads a file that a series may omit.
fn optional<T: for<'de> Deserialize<'de>>(path: &Path, faults: &mut Vec<String>) -> Option<T> {
    if path.is_file() { read_file(path, faults) } else { None }
}
