//! A series that is not embedded: read from its folder and added to the program of a test.

use catalogue::{DriveHead, Further, Mark, MarkEntry, SeriesData, WindingData, WiringTables};
use order_code::{Feedback, FeedbackKind, Field, FieldWords, Grammar, Meaning, Series, Size, Winding};
use provenance::CellRef;
use series_files::{Code, Data};
use std::path::Path;

/// Returns the folder of the fictitious series `INV`.
#[must_use]
pub fn invented() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("series/inv")
}

/// Adds the series of a folder to this program, before any code or table is read.
///
/// # Panics
/// If the folder breaks a rule of `data/README.md`, has errata or facts, which only the build embeds, or if a series was
/// added before.
pub fn add(folder: &Path) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    let mut faults = Vec::new();
    // The added data live as long as the program, like the embedded data.
    let data: &'static Data = Box::leak(Box::new(series_files::read_one(&root, folder, &mut faults)));
    let cells = series_files::cells(data, &mut faults);
    assert!(faults.is_empty(), "{}: {faults:#?}", folder.display());
    assert!(
        data.errata.is_empty() && !series_files::facts(data, &mut faults).contains("Fact {"),
        "no errata, no facts"
    );
    let place = u8::try_from(Series::all().count()).unwrap_or(u8::MAX);
    let added = order_code::extend(data.codes.iter().map(grammar).collect());
    assert!(added.is_ok(), "a series was added before");
    let document = |source: &'static series_files::SourceDocument| catalogue::SourceDocument {
        id: &source.id,
        short: &source.short,
        short_de: &source.short_de,
        title: &source.title,
        title_de: &source.title_de,
        edition: &source.edition,
        language: &source.language,
        publisher: &source.publisher,
        kind: &source.kind,
        place: &source.place,
        note: &source.note,
    };
    let new = data.sources.iter().filter(|source| catalogue::document(&source.id).is_none());
    let further = Further {
        documents: new.map(document).collect(),
        series: data.codes.iter().map(|code| Reader { series: Series::at(place), code }.data()).collect(),
        tables: data.tables.iter().zip(cells.ranges.iter().copied()).enumerate().map(table).collect(),
        cells: cells.cells.iter().map(|cell| self::cell(data, cell)).collect(),
    };
    assert!(catalogue::extend(further).is_ok(), "a series was added before");
}

fn leaked<T>(all: impl IntoIterator<Item = T>) -> &'static [T] {
    Vec::leak(all.into_iter().collect())
}

fn words(words: &'static [String]) -> &'static [&'static str] {
    leaked(words.iter().map(String::as_str))
}

fn grammar(code: &'static Code) -> Grammar {
    Grammar { series: &code.series, fields: leaked(code.fields.iter().map(|field| field_words(code, field))) }
}

fn field_of(id: &str) -> Field {
    Field::ALL.iter().copied().find(|field| field.id() == id).unwrap_or(Field::Series)
}

fn field_words(code: &'static Code, field: &'static series_files::CodeField) -> FieldWords {
    let of = |word: &String| code.feedbacks.iter().find(|feedback| feedback.word == *word);
    let kind = |feedback: &series_files::Feedback| match feedback.kind.as_str() {
        "sine_incremental" => FeedbackKind::SineIncremental,
        "endat_multiturn" => FeedbackKind::EndatMultiturn,
        "resolver" => FeedbackKind::Resolver,
        "square_incremental" => FeedbackKind::SquareIncremental,
        _ => FeedbackKind::SsiMultiturn,
    };
    let meaning = |meaning: &'static series_files::WordMeaning| Meaning {
        word: meaning.word.as_deref(),
        when: leaked(meaning.when.iter().map(|(of, all)| (field_of(of), words(all)))),
        en: &meaning.en,
        de: &meaning.de,
    };
    FieldWords {
        field: field_of(&field.id),
        is_optional: field.optional,
        words: words(&field.words),
        kinds: leaked(field.words.iter().filter_map(of).map(kind)),
        meanings: leaked(field.meanings.iter().map(meaning)),
    }
}

fn cell(data: &'static Data, cell: &series_files::PlacedCell<'static>) -> catalogue::Cell {
    let [drive, feedback, ratio, symbol, condition] = cell.keys.clone().map(|key| &*key.leak());
    let (document, table) = data.tables.get(cell.table).map_or(("", ""), |table| (&*table.source, &*table.table));
    catalogue::Cell {
        place: CellRef { document, table, symbol, condition, drive, ratio },
        row: u16::try_from(cell.row).unwrap_or(u16::MAX),
        column: u16::try_from(cell.column).unwrap_or(u16::MAX),
        feedback,
        unit: cell.unit,
        printed: cell.printed,
        corrected: cell.corrected,
        value: series_files::value_of(cell.corrected),
        checks_use: None,
        errata: &[],
    }
}

fn table(
    (number, (table, (first, end))): (usize, (&'static series_files::TableFile, (usize, usize))),
) -> catalogue::ManualTable {
    catalogue::ManualTable {
        id: &table.table,
        section: table.section.as_deref().unwrap_or(""),
        page: table.page.unwrap_or(0),
        title_en: &table.title.en,
        title_de: &table.title.de,
        source: &table.source,
        footnotes: &[],
        row_notes: &[],
        number,
        first,
        end,
    }
}

/// Converter from the table references of a series to catalogue types.
struct Reader {
    series: Series,
    code: &'static Code,
}

impl Reader {
    fn windings(&self, words: &[String]) -> &'static [Winding] {
        leaked(words.iter().filter_map(|word| Winding::of(self.series, word)))
    }

    fn feedbacks(&self, words: &[String]) -> &'static [Feedback] {
        leaked(words.iter().filter_map(|word| Feedback::of(self.series, word)))
    }

    fn data(&self) -> SeriesData {
        let (code, tables) = (self.code, &self.code.tables);
        let winding = |word: &String| code.windings.iter().find(|each| each.words.contains(word));
        let feedback = |word: &String| code.feedbacks.iter().find(|each| each.word == *word);
        let head = |drive: &'static series_files::HeadingDrives, name: &'static String| {
            let size = Size::of(self.series, code.size_of(name)?)?;
            let (windings, feedbacks) = (self.windings(&drive.windings), self.feedbacks(&drive.feedbacks));
            Some(DriveHead { name, size, windings, feedbacks })
        };
        SeriesData {
            manual: &code.manual,
            family: &tables.family,
            matrix: &tables.matrix,
            pairs: &tables.pairs,
            thresholds: &tables.thresholds,
            preselection: &tables.preselection,
            output_encoder: &tables.output_encoder,
            output_wiring: words(&tables.output_wiring),
            cables: words(&tables.cables),
            by_size: words(&tables.by_size),
            feedback: words(&tables.feedback),
            ordering: words(&tables.ordering),
            of_all: words(&tables.of_all),
            curves: words(&tables.curves),
            gear_life: &tables.gear_life,
            gear_series: &tables.gear_series,
            marks: leaked(code.marks.iter().map(|mark| Mark {
                begins: &mark.begins,
                entry: match mark.entry.as_str() {
                    "available" => MarkEntry::Available,
                    "on_request" => MarkEntry::OnRequest,
                    _ => MarkEntry::NotAvailable,
                },
                feedback: mark.feedback.as_ref().and_then(|word| Feedback::of(self.series, word)),
                longer: &mark.longer,
            })),
            windings: leaked(code.words("winding").iter().filter_map(winding).map(|each| WindingData {
                general: &each.general,
                general_head: &each.general_head,
                starting_current: &each.starting_current,
                stall_current_includes_friction: each.stall_current_includes_friction,
                ptc: each.ptc,
                without_kty: leaked(each.without_kty.iter().map(String::as_str)),
            })),
            feedback_tables: leaked(code.words("feedback").iter().filter_map(feedback).map(|each| &*each.table)),
            drives: leaked(
                code.drives.iter().flat_map(|drive| drive.heads.iter().filter_map(move |name| head(drive, name))),
            ),
            wirings: leaked(code.wirings.iter().map(|each| WiringTables {
                windings: self.windings(&each.windings),
                feedbacks: self.feedbacks(&each.feedbacks),
                tables: each.tables.each_ref().map(String::as_str),
            })),
        }
    }
}
