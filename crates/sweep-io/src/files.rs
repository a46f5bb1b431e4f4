//! Tables as files: read a batch at a time, answers written as parts and put together.

use arrow_array::{ArrayRef, RecordBatch, StringArray};
use arrow_cast::display::{ArrayFormatter, FormatOptions};
use arrow_schema::{DataType, Field, Schema, SchemaRef};
use parquet::arrow::ArrowWriter;
use parquet::arrow::arrow_reader::{ParquetRecordBatchReader, ParquetRecordBatchReaderBuilder};
use parquet::basic::Compression;
use parquet::file::properties::WriterProperties;
use quantities::Language;
use questions::sweep::csv;
use std::fs::File;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::sync::Arc;
use words::sweeps;

/// The format of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Text, a line for each row.
    Csv,
    /// Columns in pages.
    Parquet,
}

impl Format {
    /// By the ending of a name.
    #[must_use]
    pub fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_string_lossy().to_ascii_lowercase();
        match ending.as_str() {
            "csv" => Some(Self::Csv),
            "parquet" => Some(Self::Parquet),
            _ => None,
        }
    }
}

/// Longest line of a table in CSV.
const LINE_MOST: usize = 1 << 20;

/// A table that is read a batch at a time.
pub enum Batches {
    /// From text.
    Csv(Box<Lines>),
    /// From pages.
    Parquet(SchemaRef, Box<ParquetRecordBatchReader>),
}

/// The lines of a table.
pub struct Lines {
    source: BufReader<File>,
    schema: SchemaRef,
    rows: usize,
    line: u64,
    language: Language,
}

impl Batches {
    /// A table from a row on, so many rows at a time.
    ///
    /// # Errors
    /// Why it cannot be read, in a sentence.
    pub fn open(file: File, format: Format, skipped: u64, rows: usize, language: Language) -> Result<Self, String> {
        match format {
            Format::Parquet => {
                let builder = ParquetRecordBatchReaderBuilder::try_new(file).map_err(|error| error.to_string())?;
                let schema = Arc::clone(builder.schema());
                let skipped = usize::try_from(skipped).unwrap_or(usize::MAX);
                let reader = builder.with_batch_size(rows).with_offset(skipped).build();
                Ok(Self::Parquet(schema, Box::new(reader.map_err(|error| error.to_string())?)))
            }
            Format::Csv => Lines::open(file, skipped, rows, language).map(|lines| Self::Csv(Box::new(lines))),
        }
    }

    /// Its headings with the types of their cells.
    #[must_use]
    pub fn schema(&self) -> SchemaRef {
        match self {
            Self::Csv(lines) => Arc::clone(&lines.schema),
            Self::Parquet(schema, _) => Arc::clone(schema),
        }
    }
}

impl Iterator for Batches {
    type Item = Result<RecordBatch, String>;

    fn next(&mut self) -> Option<Self::Item> {
        match self {
            Self::Csv(lines) => lines.batch().transpose(),
            Self::Parquet(_, reader) => reader.next().map(|batch| batch.map_err(|error| error.to_string())),
        }
    }
}

impl Lines {
    fn open(file: File, skipped: u64, rows: usize, language: Language) -> Result<Self, String> {
        let empty = Arc::new(Schema::empty());
        let mut lines =
            Self { source: BufReader::with_capacity(1 << 18, file), schema: empty, rows, line: 0, language };
        let head = lines.next()?.unwrap_or_default();
        let heads = csv::cells(head.trim_start_matches('\u{feff}'));
        let heads = heads.ok_or_else(|| sweeps::open_quote(&lines.line, language))?;
        let fields: Vec<Field> = heads.iter().map(|name| Field::new(name.trim(), DataType::Utf8, true)).collect();
        lines.schema = Arc::new(Schema::new(fields));
        for _ in 0..skipped {
            if lines.next()?.is_none() {
                break;
            }
        }
        Ok(lines)
    }

    /// The next line that is not empty.
    fn next(&mut self) -> Result<Option<String>, String> {
        loop {
            let mut bytes = Vec::new();
            self.line += 1;
            let most = LINE_MOST as u64 + 1;
            let read =
                self.source.by_ref().take(most).read_until(b'\n', &mut bytes).map_err(|error| error.to_string())?;
            if read == 0 {
                return Ok(None);
            }
            if bytes.len() > LINE_MOST {
                return Err(sweeps::long_line(&self.line, &LINE_MOST, self.language));
            }
            while bytes.last().is_some_and(|byte| matches!(byte, b'\n' | b'\r')) {
                bytes.pop();
            }
            let text = String::from_utf8(bytes).map_err(|_| sweeps::not_utf_8(&self.line, self.language))?;
            if !text.trim().is_empty() {
                return Ok(Some(text));
            }
        }
    }

    fn batch(&mut self) -> Result<Option<RecordBatch>, String> {
        let count = self.schema.fields().len();
        let mut columns: Vec<Vec<Option<String>>> = vec![Vec::new(); count];
        for _ in 0..self.rows {
            let Some(line) = self.next()? else { break };
            let cells = csv::cells(&line).ok_or_else(|| sweeps::open_quote(&self.line, self.language))?;
            if cells.len() != count {
                return Err(sweeps::ragged(&self.line, &cells.len(), &count, self.language));
            }
            let cell = |cell: &str| Some(cell.to_owned()).filter(|cell| !cell.is_empty());
            columns.iter_mut().zip(&cells).for_each(|(column, text)| column.push(cell(text)));
        }
        if columns.first().is_none_or(Vec::is_empty) {
            return Ok(None);
        }
        let columns: Vec<ArrayRef> =
            columns.into_iter().map(|cells| Arc::new(StringArray::from(cells)) as ArrayRef).collect();
        RecordBatch::try_new(Arc::clone(&self.schema), columns).map(Some).map_err(|error| error.to_string())
    }
}

/// Answers written one batch after the other.
pub enum Answers<W: Write + Send> {
    /// As text.
    Csv(W),
    /// In pages.
    Parquet(Box<ArrowWriter<W>>),
}

/// Rows that one group of a file holds.
const GROUP: usize = 1 << 20;

impl<W: Write + Send> Answers<W> {
    /// A file of answers with these columns; the same answers give the same bytes.
    ///
    /// # Errors
    /// Why it cannot be written.
    pub fn begin(mut to: W, format: Format, schema: SchemaRef) -> Result<Self, String> {
        match format {
            Format::Parquet => {
                let properties = WriterProperties::builder()
                    .set_compression(Compression::SNAPPY)
                    .set_created_by("antrieb".to_owned())
                    .set_max_row_group_row_count(Some(GROUP))
                    .build();
                let writer = ArrowWriter::try_new(to, schema, Some(properties)).map_err(|error| error.to_string())?;
                Ok(Self::Parquet(Box::new(writer)))
            }
            Format::Csv => {
                let names: Vec<_> = schema.fields().iter().map(|field| csv::written(field.name())).collect();
                writeln!(to, "{}", names.join(",")).map_err(|error| error.to_string())?;
                Ok(Self::Csv(to))
            }
        }
    }

    /// Adds the answers of a batch.
    ///
    /// # Errors
    /// Why they cannot be written.
    pub fn add(&mut self, batch: &RecordBatch) -> Result<(), String> {
        match self {
            Self::Parquet(writer) => writer.write(batch).map_err(|error| error.to_string()),
            Self::Csv(to) => lines(to, batch),
        }
    }

    /// Ends the file.
    ///
    /// # Errors
    /// Why it cannot be written.
    pub fn end(self) -> Result<W, String> {
        match self {
            Self::Parquet(writer) => writer.into_inner().map_err(|error| error.to_string()),
            Self::Csv(mut to) => to.flush().map(|()| to).map_err(|error| error.to_string()),
        }
    }
}

fn lines(to: &mut impl Write, batch: &RecordBatch) -> Result<(), String> {
    let options = FormatOptions::default();
    let columns = batch.columns().iter().map(|column| ArrayFormatter::try_new(column.as_ref(), &options));
    let columns: Vec<ArrayFormatter<'_>> = columns.collect::<Result<_, _>>().map_err(|error| error.to_string())?;
    for row in 0..batch.num_rows() {
        let cells: Vec<String> = columns.iter().map(|column| column.value(row).to_string()).collect();
        let cells: Vec<_> = cells.iter().map(|cell| csv::written(cell)).collect();
        writeln!(to, "{}", cells.join(",")).map_err(|error| error.to_string())?;
    }
    Ok(())
}

/// The answers of one part as bytes.
///
/// # Errors
/// Why they cannot be written.
pub fn part(batch: &RecordBatch) -> Result<Vec<u8>, String> {
    let mut answers = Answers::begin(Vec::new(), Format::Parquet, batch.schema())?;
    answers.add(batch)?;
    answers.end()
}
