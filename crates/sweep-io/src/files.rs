//! Tables as files: read a batch at a time, answers written as parts and joined.

use arrow_array::{
    ArrayRef, BooleanArray, Float64Array, Int64Array, RecordBatch, StringArray, UInt32Array, UInt64Array,
    new_null_array,
};
use arrow_cast::display::{ArrayFormatter, FormatOptions};
use arrow_schema::{DataType, Field, Schema, SchemaRef, TimeUnit};
use flate2::write::GzEncoder;
use parquet::arrow::ArrowWriter;
use parquet::basic::Compression;
use parquet::file::properties::WriterProperties;
use project::TabularFault;
use quantities::Language;
use quantities::unit::{MICROSECOND, MILLISECOND, SECOND};
use questions::sweep::csv::{self, Broken, Columns, Lines};
use recording::{
    Bytes, Commas, Content, FILE_BYTES_MAX, Fault, Limit, Memory, Ranges, Sniffed, Table, TableColumn, TableValues,
    ValueKind,
};
use std::borrow::Cow;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;
use words::table_text;

/// Format of a table of answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Text, a line for each row.
    Csv(Decimal),
    /// Text, packed with gzip.
    PackedCsv(Decimal),
    /// Columns in pages.
    Parquet,
}

/// Decimal sign of a text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Decimal {
    /// Point; commas between the cells.
    #[default]
    Point,
    /// Comma; semicolons between the cells, as in the German notation of spreadsheets.
    Comma,
}

impl Decimal {
    /// Returns the sign between the cells.
    const fn separator(self) -> char {
        match self {
            Self::Point => ',',
            Self::Comma => ';',
        }
    }
}

impl Format {
    /// Returns the format of the extension of a file name.
    #[must_use]
    pub fn of(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_string_lossy().to_ascii_lowercase();
        match name.rsplit_once('.')?.1 {
            "csv" => Some(Self::Csv(Decimal::Point)),
            "gz" if name.ends_with(".csv.gz") => Some(Self::PackedCsv(Decimal::Point)),
            "parquet" => Some(Self::Parquet),
            _ => None,
        }
    }

    /// Returns the format with decimal commas; `None` if it is no text.
    #[must_use]
    pub const fn with_decimal_commas(self) -> Option<Self> {
        match self {
            Self::Csv(_) => Some(Self::Csv(Decimal::Comma)),
            Self::PackedCsv(_) => Some(Self::PackedCsv(Decimal::Comma)),
            Self::Parquet => None,
        }
    }
}

/// A table that is read a batch at a time.
pub struct Batches {
    schema: SchemaRef,
    from: From,
}

enum From {
    /// Text, and the number of rows of a batch.
    Csv(Box<Lines<Sniffed>>, usize),
    /// Pages, and the number of rows of a batch.
    Parquet(Box<Table>, usize),
}

/// First bytes of a Parquet file.
const PARQUET: &[u8] = b"PAR1";

/// A file that is read at the positions of the pages.
struct Pages {
    file: File,
    size: u64,
}

impl Ranges for Pages {
    fn size(&self) -> u64 {
        self.size
    }

    fn bytes(&mut self, range: Range<u64>) -> std::io::Result<Bytes> {
        let length = range.end.saturating_sub(range.start);
        let _ = self.file.seek(SeekFrom::Start(range.start))?;
        let mut bytes = Vec::new();
        if (&self.file).take(length).read_to_end(&mut bytes)? as u64 == length {
            Ok(bytes.into())
        } else {
            Err(std::io::ErrorKind::UnexpectedEof.into())
        }
    }
}

/// Reason why there is no batch.
#[derive(Debug)]
pub enum NoBatch {
    /// The line of a row is faulty; the next batch follows it.
    Line(TabularFault),
    /// The rest of the table cannot be read; the reason in a sentence.
    Table(String),
}

impl NoBatch {
    fn of(broken: Broken, language: Language) -> Self {
        match broken {
            Broken::Line(fault) => Self::Line(fault),
            unread @ Broken::Unread(_) => Self::Table(unread.text(language)),
        }
    }

    /// Returns the reason in one sentence.
    #[must_use]
    pub fn text(self, language: Language) -> String {
        match self {
            Self::Line(fault) => Broken::Line(fault).text(language),
            Self::Table(why) => why,
        }
    }
}

/// Converts an error message of a library.
fn trouble(error: impl std::fmt::Display) -> NoBatch {
    NoBatch::Table(error.to_string())
}

impl Batches {
    /// Opens a table at a row, `rows` at a time. Its content shows whether it is a text, which may be packed, or Parquet.
    ///
    /// # Errors
    /// The reason why it cannot be read.
    pub fn open(mut file: File, skipped: u64, rows: usize, language: Language) -> Result<Self, NoBatch> {
        let refused = |fault: Fault| NoBatch::Table(table_text(&fault, language));
        let mut mark = Vec::new();
        let _ = (&file).take(PARQUET.len() as u64).read_to_end(&mut mark).map_err(trouble)?;
        file.rewind().map_err(trouble)?;
        let size = file.metadata().map_err(trouble)?.len();
        if mark == PARQUET {
            return Self::of_pages(Box::new(Pages { file, size }), skipped, rows).map_err(refused);
        }
        let (content, source) = recording::opened(Box::new(file)).map_err(trouble)?;
        match content {
            Content::Foreign(format) => return Err(refused(Fault::Foreign { format })),
            // The pages of a packed file are unpacked as a whole.
            Content::Parquet => {
                let mut bytes = Vec::new();
                let _ = source.take(FILE_BYTES_MAX + 1).read_to_end(&mut bytes).map_err(trouble)?;
                let found = bytes.len() as u64;
                if found > FILE_BYTES_MAX {
                    return Err(refused(Fault::Beyond { limit: Limit::FileBytes, found, most: FILE_BYTES_MAX }));
                }
                return Self::of_pages(Box::new(Bytes::from(bytes)), skipped, rows).map_err(refused);
            }
            Content::Text | Content::Packed(_) => {}
        }
        Self::of_lines(source, skipped, rows, language)
    }

    /// Opens a table in CSV at a row, `rows` at a time.
    ///
    /// # Errors
    /// The reason why it cannot be read.
    pub fn of_text(text: String, skipped: u64, rows: usize, language: Language) -> Result<Self, NoBatch> {
        let (_, source) = recording::opened(Box::new(std::io::Cursor::new(text))).map_err(trouble)?;
        Self::of_lines(source, skipped, rows, language)
    }

    fn of_lines(source: Sniffed, skipped: u64, rows: usize, language: Language) -> Result<Self, NoBatch> {
        let broken = |broken| NoBatch::of(broken, language);
        let mut lines = Lines::open(source).map_err(broken)?;
        lines.skip(skipped).map_err(broken)?;
        let field = |name: &String| Field::new(name, DataType::Utf8, true);
        let schema = Arc::new(Schema::new(lines.headings().iter().map(field).collect::<Vec<_>>()));
        Ok(Self { schema, from: From::Csv(Box::new(lines), rows) })
    }

    fn of_pages(pages: Box<dyn Ranges>, skipped: u64, rows: usize) -> Result<Self, Fault> {
        let mut table = Table::open(pages, Memory::default())?;
        table.skip(skipped)?;
        let schema = Arc::new(Schema::new(table.columns().iter().map(field).collect::<Vec<_>>()));
        Ok(Self { schema, from: From::Parquet(Box::new(table), rows) })
    }

    /// Returns the headings with the types of their cells.
    #[must_use]
    pub fn schema(&self) -> SchemaRef {
        Arc::clone(&self.schema)
    }

    /// Returns the number of comments below the headings so far.
    #[must_use]
    pub const fn comments(&self) -> u64 {
        match &self.from {
            From::Csv(lines, _) => lines.comments(),
            From::Parquet(..) => 0,
        }
    }

    /// Returns the commas that its numbers may have.
    #[must_use]
    pub const fn commas(&self) -> Commas {
        match &self.from {
            From::Csv(lines, _) => lines.commas(),
            From::Parquet(..) => Commas::None,
        }
    }

    /// Returns the next rows; `None` behind the last.
    ///
    /// # Errors
    /// The reason why they cannot be read.
    pub fn next(&mut self, language: Language) -> Result<Option<RecordBatch>, NoBatch> {
        match &mut self.from {
            From::Parquet(table, rows) => {
                let columns = table.next(*rows).map_err(|fault| NoBatch::Table(table_text(&fault, language)))?;
                let batch = |columns: Vec<TableValues>| {
                    let arrays = self.schema.fields().iter().zip(columns).map(|(field, values)| array(field, values));
                    RecordBatch::try_new(Arc::clone(&self.schema), arrays.collect())
                };
                columns.map(batch).transpose().map_err(trouble)
            }
            From::Csv(lines, rows) => {
                let columns = lines.rows(*rows).map_err(|broken| NoBatch::of(broken, language))?;
                let array = |cells: Vec<Option<String>>| Arc::new(StringArray::from(cells)) as ArrayRef;
                let batch =
                    |columns: Columns| RecordBatch::try_new(self.schema(), columns.into_iter().map(array).collect());
                columns.map(batch).transpose().map_err(trouble)
            }
        }
    }
}

/// Returns the heading of a column, with the type of its cells.
fn field(column: &TableColumn) -> Field {
    let of = match &column.kind {
        ValueKind::Float => DataType::Float64,
        ValueKind::Integer => DataType::Int64,
        ValueKind::Unsigned { is_long: false } => DataType::UInt32,
        ValueKind::Unsigned { is_long: true } => DataType::UInt64,
        ValueKind::Text => DataType::Utf8,
        ValueKind::Truth => DataType::Boolean,
        // No key accepts these; the type is reported where they are used.
        ValueKind::Other(name) if name.contains("TIME") || name.contains("INT96") => {
            DataType::Timestamp(TimeUnit::Nanosecond, None)
        }
        ValueKind::Duration(unit) => DataType::Duration(match unit {
            unit if **unit == SECOND => TimeUnit::Second,
            unit if **unit == MILLISECOND => TimeUnit::Millisecond,
            unit if **unit == MICROSECOND => TimeUnit::Microsecond,
            _ => TimeUnit::Nanosecond,
        }),
        ValueKind::Other(name) if name.contains("DATE") => DataType::Date32,
        ValueKind::Other(_) => DataType::Binary,
    };
    Field::new(&column.name, of, column.nullable || matches!(column.kind, ValueKind::Duration(_) | ValueKind::Other(_)))
}

/// Returns the cells of a column.
fn array(field: &Field, values: TableValues) -> ArrayRef {
    match values {
        TableValues::Floats(values) => Arc::new(Float64Array::from(values)),
        TableValues::Integers(values) => Arc::new(Int64Array::from(values)),
        TableValues::Unsigned(values) if *field.data_type() == DataType::UInt32 => {
            let short = |value: Option<u64>| value.and_then(|value| u32::try_from(value).ok());
            Arc::new(values.into_iter().map(short).collect::<UInt32Array>())
        }
        TableValues::Unsigned(values) => Arc::new(UInt64Array::from(values)),
        TableValues::Texts(values) => Arc::new(StringArray::from(values)),
        TableValues::Truths(values) => Arc::new(BooleanArray::from(values)),
        TableValues::Other(count) => new_null_array(field.data_type(), count),
    }
}

/// Answers written batch by batch.
pub enum Answers<W: Write + Send> {
    /// CSV writer.
    Csv(W, Decimal),
    /// Writer of packed CSV.
    PackedCsv(Box<GzEncoder<W>>, Decimal),
    /// Parquet writer.
    Parquet(Box<ArrowWriter<W>>),
}

/// Largest number of rows in one row group of a file, and of values: a writer holds a row group in memory.
const GROUP: usize = 1 << 20;
const GROUP_VALUES: usize = 1 << 23;

impl<W: Write + Send> Answers<W> {
    /// Begins a file of answers with these columns; equal answers give equal bytes.
    ///
    /// # Errors
    /// The reason why it cannot be written.
    pub fn begin(mut to: W, format: Format, schema: SchemaRef) -> Result<Self, String> {
        match format {
            Format::Parquet => {
                let rows = (GROUP_VALUES / schema.fields().len().max(1)).clamp(1, GROUP);
                let properties = WriterProperties::builder()
                    .set_compression(Compression::SNAPPY)
                    .set_created_by("antrieb".to_owned())
                    .set_max_row_group_row_count(Some(rows))
                    .build();
                let writer = ArrowWriter::try_new(to, schema, Some(properties)).map_err(|error| error.to_string())?;
                Ok(Self::Parquet(Box::new(writer)))
            }
            Format::Csv(decimal) => heading(&mut to, &schema, decimal).map(|()| Self::Csv(to, decimal)),
            Format::PackedCsv(decimal) => {
                let mut packed = GzEncoder::new(to, flate2::Compression::default());
                heading(&mut packed, &schema, decimal).map(|()| Self::PackedCsv(Box::new(packed), decimal))
            }
        }
    }

    /// Adds the answers of a batch.
    ///
    /// # Errors
    /// The reason why they cannot be written.
    pub fn add(&mut self, batch: &RecordBatch) -> Result<(), String> {
        match self {
            Self::Parquet(writer) => writer.write(batch).map_err(|error| error.to_string()),
            Self::Csv(to, decimal) => lines(to, batch, *decimal),
            Self::PackedCsv(to, decimal) => lines(to, batch, *decimal),
        }
    }

    /// Ends the file.
    ///
    /// # Errors
    /// The reason why it cannot be written.
    pub fn end(self) -> Result<W, String> {
        match self {
            Self::Parquet(writer) => writer.into_inner().map_err(|error| error.to_string()),
            Self::Csv(mut to, _) => to.flush().map(|()| to).map_err(|error| error.to_string()),
            Self::PackedCsv(to, _) => to.finish().map_err(|error| error.to_string()),
        }
    }
}

fn heading(to: &mut impl Write, schema: &Schema, decimal: Decimal) -> Result<(), String> {
    let names: Vec<_> =
        schema.fields().iter().map(|field| csv::written_between(field.name(), decimal.separator())).collect();
    line(to, &names, decimal)
}

fn line(to: &mut impl Write, cells: &[Cow<'_, str>], decimal: Decimal) -> Result<(), String> {
    writeln!(to, "{}", cells.join(decimal.separator().encode_utf8(&mut [0; 4]))).map_err(|error| error.to_string())
}

fn lines(to: &mut impl Write, batch: &RecordBatch, decimal: Decimal) -> Result<(), String> {
    let options = FormatOptions::default();
    let columns = batch.columns().iter().map(|column| {
        let has_decimals = decimal == Decimal::Comma && column.data_type().is_floating();
        ArrayFormatter::try_new(column.as_ref(), &options).map(|formatter| (formatter, has_decimals))
    });
    let columns: Vec<(ArrayFormatter<'_>, bool)> =
        columns.collect::<Result<_, _>>().map_err(|error| error.to_string())?;
    for row in 0..batch.num_rows() {
        let cell = |(column, has_decimals): &(ArrayFormatter<'_>, bool)| {
            let text = column.value(row).to_string();
            if *has_decimals { text.replace('.', ",") } else { text }
        };
        let cells: Vec<String> = columns.iter().map(cell).collect();
        let cells: Vec<_> = cells.iter().map(|cell| csv::written_between(cell, decimal.separator())).collect();
        line(to, &cells, decimal)?;
    }
    Ok(())
}

/// Writes the answers of one part as bytes.
///
/// # Errors
/// The reason why they cannot be written.
pub fn part(batch: &RecordBatch) -> Result<Vec<u8>, String> {
    let mut answers = Answers::begin(Vec::new(), Format::Parquet, batch.schema())?;
    answers.add(batch)?;
    answers.end()
}
