//! Data sheet of one ordering code: every value of the manual for it, with its table and the notes on both.

use catalogue::{Cell, Footnote, Value};
use configurator::{Uncovered, sheet_cells, uncovered};
use order_code::{Field, OrderCode};
use quantities::Language;
use words::{cell_text, decimal, terminal, typeset, unpadded};

/// A remark on a value or a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SheetNote {
    /// A note on the table.
    Table(&'static Footnote),
    /// Property of the code that the table does not cover.
    Uncovered(Uncovered),
}

impl SheetNote {
    /// Returns `true` if the remark is a conclusion of antrieb, not of the manual.
    #[must_use]
    pub const fn is_ours(&self) -> bool {
        match self {
            Self::Table(note) => note.ours,
            Self::Uncovered(_) => true,
        }
    }

    /// Returns the mark of the manual; empty if there is none.
    #[must_use]
    pub const fn mark(&self) -> &'static str {
        match self {
            Self::Table(note) => note.mark,
            Self::Uncovered(_) => "",
        }
    }
}

/// One value of the manual.
#[derive(Clone, Debug)]
pub struct SheetRow {
    /// The cell.
    pub cell: &'static Cell,
    /// `true` if the value is valid for the standard actuator only, so that the manual states none for this code.
    pub of_standard_only: bool,
    /// Remarks on the value.
    pub notes: Vec<SheetNote>,
}

/// Values of one table of the manual.
#[derive(Clone, Debug)]
pub struct SheetSection {
    /// The table.
    pub table: &'static catalogue::ManualTable,
    /// Values for this code.
    pub rows: Vec<SheetRow>,
    /// Remarks on the table as a whole.
    pub notices: Vec<SheetNote>,
    /// Errata of the table that name no single cell; slips of the recovered text are left out.
    pub errata: Vec<&'static str>,
}

/// The data sheet of one ordering code.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// The code.
    pub code: OrderCode,
    /// Properties of the code that the tables do not cover.
    pub uncovered: Vec<Uncovered>,
    /// Values by table, in the order of the manual.
    pub sections: Vec<SheetSection>,
}

/// Returns the data sheet of a code; `None` if the manual states no data for it.
///
/// Values for the other brake variant are left out, and so are the sections of other feedback systems.
#[must_use]
pub fn sheet(code: &OrderCode) -> Option<Sheet> {
    let cells = sheet_cells(code)?;
    let uncovered = uncovered(code);
    let mut sections: Vec<SheetSection> = Vec::new();
    for cell in cells {
        let Some(table) = catalogue::table(cell.place.table) else { continue };
        let row = row(table, cell, &uncovered);
        match sections.last_mut().filter(|section| section.table.id == table.id) {
            Some(section) => section.rows.push(row),
            None => sections.push(SheetSection {
                table,
                rows: vec![row],
                notices: table.notices().map(SheetNote::Table).collect(),
                errata: errata_of_table(table.id),
            }),
        }
    }
    Some(Sheet { code: *code, uncovered, sections })
}

fn row(table: &'static catalogue::ManualTable, cell: &'static Cell, uncovered: &[Uncovered]) -> SheetRow {
    let symbol = cell.place.symbol;
    let printed = table.notes_on(cell).map(SheetNote::Table);
    let open = uncovered.iter().filter(|each| each.concerns().contains(&symbol)).copied().map(SheetNote::Uncovered);
    SheetRow {
        cell,
        of_standard_only: uncovered.iter().any(|each| each.not_printed().contains(&symbol)),
        notes: printed.chain(open).collect(),
    }
}

/// Returns the errata of a table that name no cell and are more than a slip of the recovered text.
fn errata_of_table(table: &str) -> Vec<&'static str> {
    catalogue::errata()
        .iter()
        .filter(|erratum| erratum.table == table && erratum.kind != catalogue::ErratumKind::Recovery)
        .filter(|erratum| erratum.cell().is_none())
        .map(|erratum| erratum.id)
        .collect()
}

/// Marks of the notes in a table: those of the manual, else the next small letter. A property that the tables do not
/// cover has the token of the code that causes it.
#[derive(Clone, Debug, Default)]
pub struct SheetMarks(Vec<(String, SheetNote)>);

impl SheetMarks {
    /// Returns the mark of a note, equal for equal notes.
    pub fn of(&mut self, note: SheetNote) -> String {
        if let SheetNote::Uncovered(what) = note {
            return uncovered_mark(what).to_owned();
        }
        if let Some((mark, _)) = self.0.iter().find(|(_, known)| *known == note) {
            return mark.clone();
        }
        let letters = self.0.iter().filter(|(_, known)| known.mark().is_empty()).count();
        let mark = match note.mark() {
            "" => ('a'..='z').nth(letters).unwrap_or('z').to_string(),
            mark => mark.to_owned(),
        };
        self.0.push((mark.clone(), note));
        mark
    }

    /// Returns the notes that have a mark, sorted by mark.
    #[must_use]
    pub fn sorted(mut self) -> Vec<(String, SheetNote)> {
        self.0.sort_by(|(one, _), (other, _)| one.cmp(other));
        self.0
    }
}

/// Returns the token of the code that causes a property which the tables do not cover.
#[must_use]
pub fn uncovered_mark(what: Uncovered) -> &'static str {
    match what {
        Uncovered::LongerWith { option, .. } => option.as_str(),
        Uncovered::SpecialDesign(series) => series.words(Field::Special).first().copied().unwrap_or_default(),
        Uncovered::OutputEncoder(option) => option.as_str(),
    }
}

/// Returns the value after errata, with that of the manual if it differs, and the one that checks use if that is another; a
/// value of the standard actuator is marked as such.
#[must_use]
pub fn sheet_value_text(row: &SheetRow, language: Language) -> String {
    let cell = row.cell;
    let value = typeset(&decimal(cell_text(cell, language), language)).into_owned();
    if row.of_standard_only {
        return terminal::value_of_the_standard(&value, language);
    }
    let value = match cell.checks_use.and_then(Value::number) {
        Some(used) => terminal::value_and_used(&value, &unpadded(used, 6, language), language),
        None => value,
    };
    if cell.corrected == cell.printed {
        return value;
    }
    let printed = typeset(&decimal(cell.printed, language)).into_owned();
    terminal::value_and_print(&value, &printed, language)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Sheet {
        sheet(&order_code::parse(text).unwrap().code).unwrap()
    }

    fn rows<'s>(sheet: &'s Sheet, symbol: &str) -> Vec<&'s SheetRow> {
        sheet.sections.iter().flat_map(|section| &section.rows).filter(|row| row.cell.place.symbol == symbol).collect()
    }

    #[test]
    fn what_is_printed_once_for_all_sizes_is_on_every_sheet() {
        for (code, _) in configurator::all().iter().step_by(37) {
            let Some(sheet) = sheet(code) else { continue };
            for (symbol, count) in [("fit_inner_ring_zone", 1), ("fit_housing_zone", 1), ("T_KTY", 2)] {
                assert_eq!(rows(&sheet, symbol).len(), count, "{code} {symbol}");
            }
        }
    }

    #[test]
    fn every_note_of_the_tables_on_the_sheets_is_shown_somewhere() {
        let mut shown: Vec<SheetNote> = Vec::new();
        let mut tables: Vec<&catalogue::ManualTable> = Vec::new();
        let hundred = configurator::all().iter().filter(|(code, _)| code.ratio.value() == 100);
        for (code, _) in hundred {
            for section in sheet(code).iter().flat_map(|sheet| &sheet.sections) {
                let notes = section.rows.iter().flat_map(|row| &row.notes).chain(&section.notices);
                let new: Vec<SheetNote> = notes.filter(|note| !shown.contains(note)).copied().collect();
                shown.extend(new);
                if !tables.iter().any(|table| table.id == section.table.id) {
                    tables.push(section.table);
                }
            }
        }
        assert!(tables.len() > 70, "{}", tables.len());
        for table in tables {
            for note in table.footnotes {
                assert!(shown.contains(&SheetNote::Table(note)), "table {}: {}", table.id, note.en);
            }
        }
    }

    #[test]
    fn option_k_and_special_designs_have_no_printed_length() {
        let longer = of("CHA-14A-50-E-RES-K");
        assert!(rows(&longer, "L").iter().all(|row| row.of_standard_only && !row.notes.is_empty()));
        assert!(rows(&longer, "m").iter().all(|row| !row.of_standard_only));
        assert!(rows(&of("CHA-20A-50-H-C1024-K"), "L").iter().all(|row| !row.of_standard_only));
        let special = of("CHA-20A-50-H-C1024-SP");
        assert!(["L", "m"].iter().all(|symbol| rows(&special, symbol).iter().all(|row| row.of_standard_only)));
    }

    #[test]
    fn no_german_text_is_left_on_an_english_sheet() {
        let german = ["ä", "ö", "ü", "ß", "Rechteck", "binär", "batterie", "ca. ", "Geber", "Stecker"];
        let mut texts = 0;
        for code in ["CHA-20A-50-H-C1024-EC", "CHA-14A-50-E-M128S", "CHA-17A-80-N-D2048-B", "CHA-58A-50-H-M512P-EC-R"] {
            let sheet = of(code);
            for row in sheet.sections.iter().flat_map(|section| &section.rows) {
                let shown = row.cell.corrected_en();
                assert!(!german.iter().any(|word| shown.contains(word)), "{code}: {shown}");
                texts += usize::from(shown != row.cell.corrected);
            }
        }
        assert!(texts >= 8, "{texts}");
    }

    #[test]
    fn errata_of_a_whole_table_are_named() {
        let sheet = of("CHA-17A-50-H-RES");
        let named: Vec<&str> = sheet.sections.iter().flat_map(|section| &section.errata).copied().collect();
        assert_eq!(named, ["T50.6-length", "T77.1-fit-name", "T79.1-securing"]);
    }
}
