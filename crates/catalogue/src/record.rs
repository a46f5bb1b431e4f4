//! The records of the embedded data.

use order_code::OrderCode;
use provenance::{CellRef, Grade, Source, Sourced, Value};
use quantities::identified;

/// One printed cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Where it stands: table, drive, ratio, symbol, condition. The drive is as headed in 6.2-6.17, or the size where a
    /// table heads only that.
    pub place: CellRef,
    /// Row of the table file, from zero.
    pub row: u16,
    /// First column on which the cell stands, from zero.
    pub column: u16,
    /// Motor feedback; empty: holds for every feedback of the drive.
    pub feedback: &'static str,
    /// Unit as printed, in ASCII; empty for pure numbers and texts.
    pub unit: &'static str,
    /// Text of the cell as the manual prints it.
    pub printed: &'static str,
    /// The same after errata; equal to `printed` where nothing is corrected.
    pub corrected: &'static str,
    /// Meaning of `corrected`.
    pub value: Value,
    /// The value that checks must use for an open contradiction, on the safe side.
    pub checks_use: Option<Value>,
    /// Identifiers of the errata that concern this cell.
    pub errata: &'static [&'static str],
}

impl Cell {
    /// The value that checks use: the safe one of a contradiction, otherwise the value after errata.
    #[must_use]
    pub fn limit(&self) -> Value {
        self.checks_use.unwrap_or(self.value)
    }

    /// A value as this cell has it; computed where checks use another one than the printed.
    pub const fn sourced<T>(&'static self, value: T) -> Sourced<T> {
        let grade = if self.checks_use.is_some() { Grade::Computed } else { Grade::Printed };
        Sourced { value, source: Source::Cell(&self.place), grade, errata: self.errata }
    }

    /// The text of the cell in English; German is what stands printed.
    #[must_use]
    pub fn corrected_en(&self) -> &'static str {
        crate::embedded::TEXTS
            .iter()
            .find(|(printed, _)| *printed == self.corrected)
            .map_or(self.corrected, |(_, en)| en)
    }

    /// The value in machine form, in the printed unit: `1.12`, `220...430`, a text; empty where not printed.
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

/// A cell as it is embedded, with the numbers of its texts. The linker lays the addresses of texts into pages that each start of
/// the program has to write; these hold none.
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
    /// The mark as printed, without the parenthesis; empty: a notice without a mark.
    pub mark: &'static str,
    /// The symbol whose rows a notice without a mark is about; empty: the whole table.
    pub symbol: &'static str,
    /// Whether it is our own conclusion from what is printed; otherwise the source says so.
    pub ours: bool,
    /// English text.
    pub en: &'static str,
    /// German text.
    pub de: &'static str,
}

/// One printed table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Table {
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
    /// Identifier of the document that prints it.
    pub source: &'static str,
    /// Footnotes and notices.
    pub footnotes: &'static [Footnote],
    /// Rows that carry footnote marks, several joined by `, `.
    pub row_notes: &'static [(u16, &'static str)],
    /// Its place among the tables, from zero.
    pub number: usize,
    /// First of its cells among those that are embedded together, or that are added together.
    pub first: usize,
    /// The cell behind its last.
    pub end: usize,
}

impl Table {
    /// The cells of this table.
    #[must_use]
    pub fn cells(&self) -> &'static [Cell] {
        crate::cells_of(self)
    }

    /// The notes on one of its rows, in the order of the table's notes.
    pub fn notes_on<'a>(&'a self, cell: &'a Cell) -> impl Iterator<Item = &'static Footnote> + 'a {
        let marks = self.row_notes.iter().find(|(row, _)| *row == cell.row).map_or("", |(_, marks)| *marks);
        self.footnotes.iter().filter(move |note| {
            (!note.symbol.is_empty() && note.symbol == cell.place.symbol)
                || (!note.mark.is_empty() && marks.split(", ").any(|mark| mark == note.mark))
        })
    }

    /// The notices on the table as a whole.
    pub fn notices(&self) -> impl Iterator<Item = &'static Footnote> {
        self.footnotes.iter().filter(|note| note.mark.is_empty() && note.symbol.is_empty())
    }

    /// Whether the manual of a series prints this table.
    #[must_use]
    pub fn is_of_the_manual(&self) -> bool {
        crate::series().iter().any(|series| series.manual == self.source)
    }
}

identified! {
    /// What is wrong, and with what.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum ErratumKind {
        /// The recovered text differs from the print.
        Recovery = "recovery",
        /// The print itself is wrong and its neighbours prove it.
        PrintError = "print_error",
        /// Two printed facts exclude each other and nothing decides.
        Contradiction = "contradiction",
        /// Rounded to the unsafe side or with false digits.
        Rounding = "rounding",
        /// Another edition prints otherwise.
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
    /// The place in words.
    pub place: &'static str,
    /// The same in German.
    pub place_de: &'static str,
    /// What the recovered text has, for kind recovery.
    pub recovered: Option<&'static str>,
    /// The same in German.
    pub recovered_de: Option<&'static str>,
    /// What is printed.
    pub printed: &'static str,
    /// The same in German.
    pub printed_de: &'static str,
    /// What is right; equal to `printed` where the matter is open.
    pub corrected: &'static str,
    /// The same in German.
    pub corrected_de: &'static str,
    /// The value used by checks if the other one is safer.
    pub checks_use: Option<&'static str>,
    /// Kind.
    pub kind: ErratumKind,
    /// Whether the value is corrected (otherwise it stays as printed and is flagged).
    pub corrected_here: bool,
    /// Why, with the figures, in English.
    pub evidence: &'static str,
    /// The same in German.
    pub evidence_de: &'static str,
}

impl Erratum {
    /// Returns true if an erratum of a table concerns a code.
    ///
    /// An erratum of a cell concerns the codes that the cell holds for; the caller knows these.
    #[must_use]
    pub fn concerns(&self, code: &OrderCode) -> bool {
        let open_or_has = |words: &[&str], word: &str| words.is_empty() || words.contains(&word);
        open_or_has(self.feedbacks, code.feedback.as_str())
            && open_or_has(self.windings, code.winding.as_str())
            && open_or_has(self.sizes, code.size.as_str())
    }

    /// The one cell that it names; `None` for an erratum of a table or a text.
    #[must_use]
    pub fn cell(&self) -> Option<&'static Cell> {
        crate::cells().find(|cell| cell.errata.contains(&self.id))
    }
}

/// A document that a number comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Document {
    /// Identifier.
    pub id: &'static str,
    /// Title.
    pub title: &'static str,
    /// Edition; empty if unknown.
    pub edition: &'static str,
    /// Language; empty if unknown.
    pub language: &'static str,
    /// Publisher; empty if unknown.
    pub publisher: &'static str,
    /// Kind: manual, catalogue, data sheet, standard, library.
    pub kind: &'static str,
    /// Where it can be read; empty if nowhere public.
    pub place: &'static str,
    /// Remark.
    pub note: &'static str,
}

/// A term of the field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Term {
    /// Symbol in ASCII, as in the tables: `T_max`.
    pub symbol: &'static str,
    /// Long name as used in code and project files: `torque_max`.
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

/// A word of the product: one for one thing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    /// Identifier.
    pub id: &'static str,
    /// English word.
    pub en: &'static str,
    /// German word.
    pub de: &'static str,
    /// What it means, in English.
    pub about_en: &'static str,
    /// What it means, in German.
    pub about_de: &'static str,
    /// English words that are not used for it.
    pub not_en: &'static [&'static str],
    /// German words that are not used for it.
    pub not_de: &'static [&'static str],
}
