//! Records of the embedded data.

use order_code::OrderCode;
use provenance::{CellRef, Grade, Source, Sourced, Value};
use quantities::identified;

/// One cell of a table of the manual.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Place: table, drive, ratio, symbol, condition. The drive is the heading in 6.2-6.17, or the size for a table
    /// headed by size only.
    pub place: CellRef,
    /// Row of the table file, from zero.
    pub row: u16,
    /// First column of the cell, from zero.
    pub column: u16,
    /// Motor feedback; empty: holds for every feedback of the drive.
    pub feedback: &'static str,
    /// Unit as the manual states it, in ASCII; empty for pure numbers and texts.
    pub unit: &'static str,
    /// Text of the cell in the manual.
    pub printed: &'static str,
    /// Text of the cell after errata; equal to `printed` without a correction.
    pub corrected: &'static str,
    /// Meaning of `corrected`.
    pub value: Value,
    /// Value that checks must use for an open contradiction, on the safe side.
    pub checks_use: Option<Value>,
    /// Identifiers of the errata that concern this cell.
    pub errata: &'static [&'static str],
}

impl Cell {
    /// Returns the value that checks use: the safe one of a contradiction, otherwise the value after errata.
    #[must_use]
    pub fn limit(&self) -> Value {
        self.checks_use.unwrap_or(self.value)
    }

    /// Returns a value with the source of this cell; its grade is computed if checks use another value than the stated
    /// one.
    pub const fn sourced<T>(&'static self, value: T) -> Sourced<T> {
        let grade = if self.checks_use.is_some() { Grade::Computed } else { Grade::Printed };
        Sourced { value, source: Source::Cell(&self.place), grade, errata: self.errata }
    }

    /// Returns the text of the cell in English; the German text is that of the manual.
    #[must_use]
    pub fn corrected_en(&self) -> &'static str {
        crate::embedded::TEXTS
            .iter()
            .find(|(printed, _)| *printed == self.corrected)
            .map_or(self.corrected, |(_, en)| en)
    }

    /// Returns the value in machine form, in the stated unit: `1.12`, `220...430`, a text; empty if not stated.
    #[must_use]
    pub fn value_text(&self) -> String {
        match self.value {
            Value::NotPrinted => String::new(),
            Value::Range { low, high } => format!("{low}...{high}"),
            Value::Text => self.corrected.to_owned(),
            Value::Number(value)
            | Value::UpperBound(value)
            | Value::LowerBound(value)
            | Value::PlusMinus(value)
            | Value::Tolerance { nominal: value, .. } => format!("{value}"),
        }
    }
}

/// A cell as it is embedded, with the numbers of its texts. The linker places the addresses of texts in pages that each
/// start of the program has to relocate; packed cells contain none.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Packed {
    pub(crate) document: u16,
    pub(crate) table: u16,
    pub(crate) symbol: u16,
    pub(crate) condition: u16,
    pub(crate) drive: u16,
    pub(crate) ratio: u16,
    pub(crate) row: u16,
    pub(crate) column: u16,
    pub(crate) feedback: u16,
    pub(crate) unit: u16,
    pub(crate) printed: u16,
    pub(crate) corrected: u16,
    pub(crate) value: Value,
    pub(crate) checks_use: Option<Value>,
    pub(crate) errata: u16,
}

impl Packed {
    pub(crate) fn unpacked(&self, texts: &[&'static str], errata: &[&'static [&'static str]]) -> Cell {
        let text = |number: u16| texts.get(usize::from(number)).copied().unwrap_or_default();
        Cell {
            place: CellRef {
                document: text(self.document),
                table: text(self.table),
                symbol: text(self.symbol),
                condition: text(self.condition),
                drive: text(self.drive),
                ratio: text(self.ratio),
            },
            row: self.row,
            column: self.column,
            feedback: text(self.feedback),
            unit: text(self.unit),
            printed: text(self.printed),
            corrected: text(self.corrected),
            value: self.value,
            checks_use: self.checks_use,
            errata: errata.get(usize::from(self.errata)).copied().unwrap_or_default(),
        }
    }
}

/// A note on a table, in our own words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Footnote {
    /// Mark in the manual, without the parenthesis; empty: a notice without a mark.
    pub mark: &'static str,
    /// Symbol whose rows a notice without a mark is about; empty: the whole table.
    pub symbol: &'static str,
    /// `true` for our own conclusion from the manual; `false` for a statement of the source.
    pub ours: bool,
    /// English text.
    pub en: &'static str,
    /// German text.
    pub de: &'static str,
}

/// One table of the manual.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ManualTable {
    /// Number after errata, or the file's name for tables of other sources.
    pub id: &'static str,
    /// Section of the manual; empty for other sources.
    pub section: &'static str,
    /// Page of the manual; zero if unknown.
    pub page: u16,
    /// English title.
    pub title_en: &'static str,
    /// German title.
    pub title_de: &'static str,
    /// Identifier of the document that contains it.
    pub source: &'static str,
    /// Footnotes and notices.
    pub footnotes: &'static [Footnote],
    /// Rows that carry footnote marks, several joined by `, `.
    pub row_notes: &'static [(u16, &'static str)],
    /// Position among the tables, from zero.
    pub number: usize,
    /// Index of its first cell among those that are embedded together, or that are added together.
    pub first: usize,
    /// Index behind its last cell.
    pub end: usize,
}

impl ManualTable {
    /// Returns the cells of this table.
    #[must_use]
    pub fn cells(&self) -> &'static [Cell] {
        crate::cells_of(self)
    }

    /// Returns the notes on one of its rows, in the order of the table's notes.
    pub fn notes_on<'a>(&'a self, cell: &'a Cell) -> impl Iterator<Item = &'static Footnote> + 'a {
        let marks = self.row_notes.iter().find(|(row, _)| *row == cell.row).map_or("", |(_, marks)| *marks);
        self.footnotes.iter().filter(move |note| {
            (!note.symbol.is_empty() && note.symbol == cell.place.symbol)
                || (!note.mark.is_empty() && marks.split(", ").any(|mark| mark == note.mark))
        })
    }

    /// Returns the notices on the table as a whole.
    pub fn notices(&self) -> impl Iterator<Item = &'static Footnote> {
        self.footnotes.iter().filter(|note| note.mark.is_empty() && note.symbol.is_empty())
    }

    /// Returns `true` if the manual of a series contains this table.
    #[must_use]
    pub fn is_of_the_manual(&self) -> bool {
        crate::series().iter().any(|series| series.manual == self.source)
    }
}

identified! {
    /// Kind of an erratum.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum ErratumKind {
        /// The recovered text differs from the manual.
        Recovery = "recovery",
        /// The manual is wrong, as its neighbouring values prove.
        PrintError = "print_error",
        /// Two statements of the manual exclude each other and nothing decides.
        Contradiction = "contradiction",
        /// A value is rounded to the unsafe side or has unfounded digits.
        Rounding = "rounding",
        /// Another edition states another value.
        Edition = "edition",
    }
}

/// One entry of `errata.toml`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Erratum {
    /// Identifier.
    pub id: &'static str,
    /// Table concerned; empty for an erratum of the text.
    pub table: &'static str,
    /// Feedback systems that an erratum of a table concerns; empty if all.
    pub feedbacks: &'static [&'static str],
    /// Windings that an erratum of a table concerns; empty if all.
    pub windings: &'static [&'static str],
    /// Sizes that an erratum of a table concerns; empty if all.
    pub sizes: &'static [&'static str],
    /// Place in words.
    pub place: &'static str,
    /// Place in words, in German.
    pub place_de: &'static str,
    /// Recovered text, for kind recovery.
    pub recovered: Option<&'static str>,
    /// Recovered text in German.
    pub recovered_de: Option<&'static str>,
    /// Text of the manual.
    pub printed: &'static str,
    /// Text of the manual in German.
    pub printed_de: &'static str,
    /// Correct text; equal to `printed` if the matter is open.
    pub corrected: &'static str,
    /// Correct text in German.
    pub corrected_de: &'static str,
    /// Value used by checks if it is safer than the corrected one.
    pub checks_use: Option<&'static str>,
    /// Kind.
    pub kind: ErratumKind,
    /// `true` if the value is corrected here; otherwise it stays as stated and is flagged.
    pub corrected_here: bool,
    /// Evidence with its figures, in English.
    pub evidence: &'static str,
    /// Evidence in German.
    pub evidence_de: &'static str,
}

impl Erratum {
    /// Returns `true` if an erratum of a table concerns a code.
    ///
    /// An erratum of a cell concerns the codes for which the cell holds; the caller knows these.
    #[must_use]
    pub fn concerns(&self, code: &OrderCode) -> bool {
        let open_or_has = |words: &[&str], word: &str| words.is_empty() || words.contains(&word);
        open_or_has(self.feedbacks, code.feedback.as_str())
            && open_or_has(self.windings, code.winding.as_str())
            && open_or_has(self.sizes, code.size.as_str())
    }

    /// Returns the one cell that it names; `None` for an erratum of a table or a text.
    #[must_use]
    pub fn cell(&self) -> Option<&'static Cell> {
        crate::cells().find(|cell| cell.errata.contains(&self.id))
    }
}

/// A document that a number comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SourceDocument {
    /// Identifier.
    pub id: &'static str,
    /// Short name under which texts cite it, in English; unique, and never part of another one.
    pub short: &'static str,
    /// Text in German; empty if it equals the English one.
    pub short_de: &'static str,
    /// Title.
    pub title: &'static str,
    /// Title in German of a document that has one in both languages; else empty.
    pub title_de: &'static str,
    /// Edition; empty if unknown.
    pub edition: &'static str,
    /// Language; empty if unknown.
    pub language: &'static str,
    /// Publisher; empty if unknown.
    pub publisher: &'static str,
    /// Kind: manual, catalogue, data sheet, standard, library.
    pub kind: &'static str,
    /// Public address; empty if there is none.
    pub place: &'static str,
    /// Remark.
    pub note: &'static str,
}

/// A term of the field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Term {
    /// Symbol in ASCII, as in the tables: `T_max`.
    pub symbol: &'static str,
    /// Long name in code and project files: `torque_max`.
    pub identifier: &'static str,
    /// Unit in ASCII; empty for pure numbers.
    pub unit: &'static str,
    /// English term.
    pub en: &'static str,
    /// German term.
    pub de: &'static str,
    /// English remark; may be empty.
    pub note_en: &'static str,
    /// German remark; may be empty.
    pub note_de: &'static str,
}

/// A word of the product.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProductWord {
    /// Identifier.
    pub id: &'static str,
    /// English word.
    pub en: &'static str,
    /// German word.
    pub de: &'static str,
    /// Meaning in English.
    pub about_en: &'static str,
    /// Meaning in German.
    pub about_de: &'static str,
    /// English words that are not used for it.
    pub not_en: &'static [&'static str],
    /// German words that are not used for it.
    pub not_de: &'static [&'static str],
}
