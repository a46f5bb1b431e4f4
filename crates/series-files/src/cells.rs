//! Conversion of table files to flat cells, with errata applied and every rule of `data/README.md` checked.

use crate::code::Code;
use crate::read::{Data, ErratumEntry, TableFile, TableRow};
use provenance::Value;
use std::collections::{BTreeMap, BTreeSet};

/// Keys of a cell, in the order of [`PlacedCell::keys`].
pub const KEYS: [&str; 5] = ["drive", "feedback", "ratio", "symbol", "condition"];
const MERGED: &str = "<<";

/// One cell with everything that distinguishes it from the others.
pub struct PlacedCell<'a> {
    /// Index of its table.
    pub table: usize,
    /// Row of the table, counted from zero.
    pub row: usize,
    /// First column covered by the cell, counted from zero.
    pub column: usize,
    /// Drive, feedback, ratio, symbol and condition.
    pub keys: [String; 5],
    /// Unit as stated in the source.
    pub unit: &'a str,
    /// Text as stated in the source.
    pub printed: &'a str,
    /// Text after errata.
    pub corrected: &'a str,
    /// Text to be used by checks instead, if the erratum states one.
    pub checks_use: Option<&'a str>,
    /// Indices of the errata about the cell.
    pub errata: Vec<usize>,
}

/// Parses the text of a cell.
#[must_use]
pub fn value_of(text: &str) -> Value {
    let number = |text: &str| quantities::parse_german(text.trim());
    let text = text.trim();
    if text.is_empty() || text == "-" {
        return Value::NotPrinted;
    }
    if let Some(value) = number(text) {
        return Value::Number(value);
    }
    if let Some((low, high)) = text.split_once("...")
        && let (Some(low), Some(high)) = (number(low), number(high))
    {
        return Value::Range { low, high };
    }
    if let Some(bound) = text.strip_prefix('<').or_else(|| text.strip_prefix('≤')) {
        let bound = bound.trim_start();
        if let Some(value) = number(bound.strip_prefix('±').unwrap_or(bound)) {
            return Value::UpperBound(value);
        }
    }
    if let Some(value) = text.strip_prefix('≥').or_else(|| text.strip_prefix('>')).and_then(number) {
        return Value::LowerBound(value);
    }
    if let Some(value) = text.strip_prefix('±').and_then(number) {
        return Value::PlusMinus(value);
    }
    if let Some((nominal, percent)) = text.split_once('±')
        && let (Some(nominal), Some(percent)) = (number(nominal), percent.trim().strip_suffix('%').and_then(number))
    {
        return Value::Tolerance { nominal, plus_minus_percent: percent };
    }
    Value::Text
}

/// Splits a column heading into its keys: `CHA-14A | 30` with the keys drive and ratio.
fn column_keys<'a>(table: &'a TableFile, column: &'a str) -> Vec<(&'a str, &'a str)> {
    table.keys.iter().map(String::as_str).zip(column.split(" | ").map(str::trim)).collect()
}

/// Returns the entry for one key in a column heading.
fn head_of(table: &TableFile, column: &str, key: &str) -> String {
    column_keys(table, column).into_iter().filter(|(k, _)| *k == key).map(|(_, v)| v).collect::<Vec<_>>().join(", ")
}

/// Returns the keys of a cell that covers the columns `from..to`: those of the table, overridden by the row, and by the
/// column headings if they agree.
fn cell_keys(table: &TableFile, row: &TableRow, columns: &[String]) -> [String; 5] {
    let defaults = |key: &str| match key {
        "drive" => row.drive.as_deref().or(table.drive.as_deref()),
        "feedback" => row.feedback.as_deref().or(table.feedback.as_deref()),
        "ratio" => row.ratio.as_deref(),
        "symbol" => row.symbol.as_deref(),
        _ => row.condition.as_deref(),
    };
    KEYS.map(|key| {
        let heads: Vec<String> = columns.iter().map(|column| head_of(table, column, key)).collect();
        let mut distinct = heads.clone();
        distinct.dedup();
        let common = match distinct.as_slice() {
            [only] => only.clone(),
            // Stated once for some of the drives: it holds for each of them. For all: it holds without restriction.
            some if key == "drive" && columns.len() < table.columns.len() => some.join(" / "),
            _ => String::new(),
        };
        match (defaults(key), common.is_empty()) {
            (None, _) => common,
            (Some(own), true) => own.to_owned(),
            (Some(own), false) if key == "condition" => format!("{own}, {common}"),
            (Some(_), false) => common,
        }
    })
}

fn cells_of<'a>(index: usize, table: &'a TableFile, faults: &mut Vec<String>) -> Vec<PlacedCell<'a>> {
    let mut cells = Vec::new();
    let at = |row: usize| format!("table {}, row {}", table.table, row + 1);
    for key in &table.keys {
        if !KEYS.contains(&key.as_str()) {
            faults.push(format!("table {}: unknown key `{key}`", table.table));
        }
    }
    for column in &table.columns {
        if column.split(" | ").count() != table.keys.len() {
            faults.push(format!("table {}: column `{column}` does not have {} keys", table.table, table.keys.len()));
        }
    }
    for (row_index, row) in table.rows.iter().enumerate() {
        let width = table.columns.len().max(1);
        let single = row.cells.len() == 1;
        if !single && row.cells.len() != width {
            faults.push(format!("{}: {} cells on {width} columns", at(row_index), row.cells.len()));
            continue;
        }
        if let Some(unit) = row.unit.as_deref()
            && quantities::Unit::of(unit).is_none()
        {
            faults.push(format!("{}: unknown unit `{unit}`", at(row_index)));
        }
        for (column, text) in row.cells.iter().enumerate() {
            if text == MERGED {
                if column == 0 {
                    faults.push(format!("{}: nothing to merge with on the left", at(row_index)));
                }
                continue;
            }
            if text.is_empty() {
                continue;
            }
            let merged = row.cells.iter().skip(column + 1).take_while(|next| *next == MERGED).count();
            let span = if single { table.columns.len() } else { merged + 1 };
            let columns = table.columns.get(column..(column + span).min(table.columns.len())).unwrap_or_default();
            let keys = cell_keys(table, row, columns);
            if keys.get(3).is_none_or(String::is_empty) {
                faults.push(format!("{}: a row needs a symbol", at(row_index)));
            }
            cells.push(PlacedCell {
                table: index,
                row: row_index,
                column,
                keys,
                unit: row.unit.as_deref().unwrap_or(""),
                printed: text,
                corrected: text,
                checks_use: None,
                errata: Vec::new(),
            });
        }
    }
    cells
}

/// Fields of a code by which an erratum of a table can state the codes it concerns.
const CONCERNED: [&str; 3] = ["feedback", "winding", "size"];

/// Reports words under `concerns` that occur in no code of the data.
fn known_words(erratum: &ErratumEntry, codes: &[Code], faults: &mut Vec<String>) {
    let id = &erratum.id;
    for (field, words) in &erratum.concerns {
        if !CONCERNED.contains(&field.as_str()) {
            faults.push(format!("erratum {id}: `concerns` has the key `{field}`, known are {}", CONCERNED.join(", ")));
        }
        for word in words.iter().filter(|word| !codes.iter().any(|code| code.place(field, word).is_some())) {
            faults.push(format!("erratum {id}: unknown {field} `{word}`"));
        }
    }
}

/// Finds the one cell named in an erratum and applies the erratum.
fn apply<'a>(
    number: usize,
    erratum: &'a ErratumEntry,
    tables: &[TableFile],
    cells: &mut [PlacedCell<'a>],
    faults: &mut Vec<String>,
) {
    let id = &erratum.id;
    if !["recovery", "print_error", "contradiction", "rounding", "edition"].contains(&erratum.kind.as_str()) {
        faults.push(format!("erratum {id}: unknown kind `{}`", erratum.kind));
    }
    if !["corrected", "flagged"].contains(&erratum.status.as_str()) {
        faults.push(format!("erratum {id}: unknown status `{}`", erratum.status));
    }
    if erratum.status == "flagged" && erratum.corrected != erratum.printed {
        faults.push(format!("erratum {id}: flagged, so `corrected` must equal `printed`"));
    }
    if (erratum.kind == "recovery") != erratum.recovered.is_some() {
        faults.push(format!("erratum {id}: `recovered` belongs to kind recovery, and only there"));
    }
    if erratum.place.is_some() != erratum.place_de.is_some() {
        faults.push(format!("erratum {id}: `where` and `where_de` belong together"));
    }
    if !erratum.concerns.is_empty() && !erratum.cell.is_empty() {
        faults.push(format!("erratum {id}: `concerns` belongs to an erratum of a table, a cell has its own codes"));
    }
    let Some(table) = erratum.table.as_deref() else {
        if erratum.place.is_none() {
            faults.push(format!("erratum {id}: needs `table` or `where`"));
        }
        return;
    };
    if !tables.iter().any(|t| t.table == table) {
        faults.push(format!("erratum {id}: there is no table {table}"));
        return;
    }
    if erratum.cell.is_empty() {
        if erratum.place.is_none() {
            faults.push(format!("erratum {id}: needs `cell` or `where`"));
        }
        return;
    }
    for key in erratum.cell.keys() {
        if !KEYS.contains(&key.as_str()) {
            faults.push(format!("erratum {id}: unknown key `{key}`"));
        }
    }
    let mut found: Vec<&mut PlacedCell<'a>> = cells
        .iter_mut()
        .filter(|cell| tables.get(cell.table).is_some_and(|t| t.table == table))
        .filter(|cell| {
            KEYS.iter().zip(&cell.keys).all(|(key, value)| erratum.cell.get(*key).is_none_or(|want| want == value))
        })
        .collect();
    match found.as_mut_slice() {
        [cell] => {
            if cell.printed != erratum.printed {
                faults.push(format!(
                    "erratum {id}: says `{}` is printed, the table has `{}`",
                    erratum.printed, cell.printed
                ));
            }
            cell.errata.push(number);
            if erratum.status == "corrected" {
                cell.corrected = &erratum.corrected;
            }
            if let Some(limit) = &erratum.checks_use {
                cell.checks_use = Some(limit);
            }
        }
        none_or_many => faults.push(format!("erratum {id}: names {} cells, must name one", none_or_many.len())),
    }
}

/// Cells of all tables, with the range of each table.
pub struct AllCells<'a> {
    /// The cells, in the order of the tables, rows and columns.
    pub cells: Vec<PlacedCell<'a>>,
    /// Index of the first cell of each table, and one past its last.
    pub ranges: Vec<(usize, usize)>,
}

/// Returns the cells of the tables with their errata applied; reports every rule that the data violate.
pub fn cells<'a>(data: &'a Data, faults: &mut Vec<String>) -> AllCells<'a> {
    let mut cells: Vec<PlacedCell<'_>> = Vec::new();
    let mut ranges = Vec::new();
    for (index, table) in data.tables.iter().enumerate() {
        let first = cells.len();
        cells.extend(cells_of(index, table, faults));
        ranges.push((first, cells.len()));
        if !data.sources.iter().any(|source| source.id == table.source) {
            faults.push(format!("table {}: source `{}` is not in sources.toml", table.table, table.source));
        }
    }
    for erratum in &data.errata {
        known_words(erratum, &data.codes, faults);
    }
    for (number, erratum) in data.errata.iter().enumerate() {
        apply(number, erratum, &data.tables, &mut cells, faults);
    }
    unique(data, &cells, faults);
    notes(data, faults);
    texts(data, &cells, faults);
    roles(data, faults);
    AllCells { cells, ranges }
}

/// Checks that every table named in a code exists.
fn roles(data: &Data, faults: &mut Vec<String>) {
    for code in &data.codes {
        let tables = &code.tables;
        let single = [
            &tables.family,
            &tables.matrix,
            &tables.pairs,
            &tables.thresholds,
            &tables.preselection,
            &tables.output_encoder,
        ];
        let named = single
            .into_iter()
            .chain(&tables.output_wiring)
            .chain(&tables.cables)
            .chain(&tables.curves)
            .chain([&tables.gear_life])
            .chain(code.windings.iter().map(|winding| &winding.general))
            .chain(code.feedbacks.iter().map(|feedback| &feedback.table))
            .chain(code.wirings.iter().flat_map(|wiring| &wiring.tables));
        for table in named.filter(|named| !named.is_empty() && !data.tables.iter().any(|each| each.table == **named)) {
            faults.push(format!("code.toml of {}: there is no table {table}", code.series));
        }
    }
}

fn unique(data: &Data, cells: &[PlacedCell<'_>], faults: &mut Vec<String>) {
    let errata = data.errata.iter().map(|erratum| ("erratum", &erratum.id));
    let tables = data.tables.iter().map(|table| ("table", &table.table));
    let terms = data.glossary.iter().map(|term| ("glossary:", &term.symbol));
    let words = data.words.iter().map(|word| ("glossary: the word", &word.id));
    let mut seen = BTreeSet::new();
    for (what, name) in errata.chain(tables).chain(terms).chain(words) {
        if !seen.insert((what, name)) {
            faults.push(format!("{what} {name} stands twice"));
        }
    }
    let name_of = |cell: &PlacedCell<'_>| data.tables.get(cell.table).map_or("", |table| table.table.as_str());
    let mut keys: BTreeMap<(usize, &[String; 5]), usize> = BTreeMap::new();
    for cell in cells {
        if let Some(row) = keys.insert((cell.table, &cell.keys), cell.row) {
            faults.push(format!(
                "table {}: rows {} and {} name the same cell {:?}",
                name_of(cell),
                row + 1,
                cell.row + 1,
                cell.keys
            ));
        }
        let symbol = &cell.keys[3];
        if !symbol.is_empty() && !data.glossary.iter().any(|term| &term.symbol == symbol) {
            faults.push(format!("table {}: symbol `{symbol}` is not in glossary.toml", name_of(cell)));
        }
    }
}

/// Checks that every mark and symbol that binds a note to its rows exists.
fn notes(data: &Data, faults: &mut Vec<String>) {
    for table in &data.tables {
        let name = &table.table;
        for note in &table.footnotes {
            if note.by.as_deref().is_some_and(|by| by != "antrieb") {
                faults.push(format!("table {name}: a note is by the source, or `by = \"antrieb\"`"));
            }
            let symbol = note.symbol.as_deref();
            if symbol.is_some_and(|symbol| !table.rows.iter().any(|row| row.symbol.as_deref() == Some(symbol))) {
                faults.push(format!("table {name}: a note names `{}`, which no row has", symbol.unwrap_or_default()));
            }
            if note.mark.is_some() && symbol.is_some() {
                faults.push(format!("table {name}: a note has a mark or a symbol, not both"));
            }
        }
        for (index, row) in table.rows.iter().enumerate() {
            for mark in row.note.iter().flat_map(|marks| marks.split(", ")) {
                if !table.footnotes.iter().any(|note| note.mark.as_deref() == Some(mark)) {
                    faults.push(format!("table {name}, row {}: there is no note `{mark}`", index + 1));
                }
            }
        }
    }
}

/// Checks that every translated text occurs in a cell.
fn texts(data: &Data, cells: &[PlacedCell<'_>], faults: &mut Vec<String>) {
    for text in &data.texts {
        if !cells.iter().any(|cell| cell.corrected == text.printed) {
            faults.push(format!("texts.toml: `{}` stands in no cell", text.printed));
        }
    }
}
