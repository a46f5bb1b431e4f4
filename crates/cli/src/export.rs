//! `export`: the results of one or several axes as a workbook, or one table in a file.

use crate::answer::{CommandAnswer, written};
use crate::call::Call;
use crate::fault::path_text;
use crate::judge::file_name;
use crate::waiting::progress;
use answers::{AxisExported, ExportWritten, Fit, TableWritten};
use quantities::Language;
use questions::list::{Inquiry, Unanswered, export};
use questions::texts::standing_text;
use questions::{Candidate, Rejected, answer};
use std::borrow::Cow;
use std::fmt::Write as _;
use std::path::Path;
use tables::{AxisSheets, Format, Front, NAMES, SHEET_ROWS_MOST, Subject, Table};
use words::terminal;

/// `antrieb export PROJECT… (--out FILE | --table NAME)`
pub(crate) fn export(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let args = export::Args::read(&inquiry.given)?;
    let file = call.file("out");
    let format = format(call, file)?;
    // With a name one table, else the whole workbook.
    let table = args.table.as_deref();
    if table.is_none() && format != Format::Workbook {
        return Err(Unanswered::message(terminal::name_one_table(&NAMES.join(", "), language)));
    }
    let saver = call.saver();
    if let Some(file) = file {
        saver.ready(&[file])?;
    }
    let axes = args.axes(inquiry)?;
    for (_, (_, project)) in &axes {
        format.within(project, table, call.memory())?;
    }
    let top = args.top;
    let mut sizings = Vec::new();
    for (_, (_, project)) in &axes {
        sizings.push(questions::list::size::sized(project, top, Rejected::All, progress())?);
    }
    let mut all_chosen = Vec::new();
    for ((_, (_, project)), sizing) in axes.iter().zip(&sizings) {
        all_chosen.push(questions::candidate_for(project, args.code.as_ref(), || Ok(Cow::Borrowed(sizing)))?);
    }
    let name = call.path("project").and_then(Path::file_name).map(|name| path_text(Path::new(name)));
    let names: Vec<String> = match &inquiry.sources[..] {
        [one] => vec![name.unwrap_or_else(|| one.name.clone())],
        several => several.iter().map(|source| file_name(&source.name).to_owned()).collect(),
    };
    let mut sheets: Vec<AxisSheets<'_>> = Vec::new();
    for (((place, (axis, project)), sizing), chosen) in axes.iter().zip(&sizings).zip(&all_chosen) {
        let Some((source, file)) = inquiry.sources.get(*place).zip(names.get(*place)) else { continue };
        let text = source.text(language)?;
        let subject = Subject { text, axis: *axis, project, sizing, chosen, top, language };
        let tables: Vec<Table> = match table {
            Some(name) => subject.table(name, format).into_iter().collect(),
            None => subject.tables(),
        };
        let revision = args.revision.as_deref();
        sheets.push(AxisSheets { tables, front: Front { file, revision, date: args.date, project, chosen, language } });
    }
    let written: Vec<ExportedAxis<'_>> =
        sheets.iter().map(|axis| ExportedAxis::of(axis.front, &axis.tables, format)).collect();
    let bytes = bytes(format, sheets, language).map_err(|error| Unanswered::message(error.message(language)))?;
    let fits = all_chosen.iter().all(Candidate::fits);
    let Some(file) = file else {
        return Ok(CommandAnswer::data(String::from_utf8_lossy(&bytes).into_owned()).fits(fits));
    };
    saver.save(&[(file, &bytes)])?;
    let data = if call.as_json { sentence_json(file, &written) } else { sentence(file, &written, language) };
    Ok(CommandAnswer::data(data).fits(fits))
}

/// Returns the format of a file; that of standard output without a file.
fn format(call: &Call<'_>, file: Option<&Path>) -> Result<Format, Unanswered> {
    match file {
        None if call.as_json => Ok(Format::Json),
        None => Ok(Format::Csv),
        Some(file) => {
            Format::of(file).ok_or_else(|| Unanswered::message(terminal::ending_says_the_format(call.language)))
        }
    }
}

fn bytes(format: Format, axes: Vec<AxisSheets<'_>>, language: Language) -> Result<Vec<u8>, tables::WriteError> {
    let table = axes.first().and_then(|axis| axis.tables.first());
    Ok(match (format, table) {
        (Format::Workbook, _) => tables::xlsx_of_axes(axes, language)?,
        (Format::Csv, Some(table)) => tables::csv(table).into_bytes(),
        (Format::Json, Some(table)) => written(&tables::record(table)).into_bytes(),
        (Format::Parquet, Some(table)) => tables::parquet(table)?,
        (_, None) => Vec::new(),
    })
}

/// An axis in a file: tables with their numbers of rows, and those that are too long for it.
struct ExportedAxis<'a> {
    front: Front<'a>,
    there: Vec<TableWritten>,
    left_out: Vec<TableWritten>,
}

impl<'a> ExportedAxis<'a> {
    fn of(front: Front<'a>, tables: &[Table], format: Format) -> Self {
        let (there, left_out): (Vec<&Table>, Vec<&Table>) = tables.iter().partition(|table| format.holds(table));
        let listed = |tables: Vec<&Table>| {
            let each = tables.into_iter();
            each.map(|table| TableWritten { name: table.name.to_owned(), rows: table.rows.len() }).collect()
        };
        Self { front, there: listed(there), left_out: listed(left_out) }
    }

    /// Returns code, verdict and the rows of the tables.
    fn sentence(&self, language: Language) -> String {
        let verdict = standing_text(self.front.chosen, language);
        let listed = |tables: &[TableWritten]| {
            let each = tables.iter().map(|table| format!("{} {}", table.name, table.rows));
            each.collect::<Vec<_>>().join(", ")
        };
        let rows = terminal::rows(language);
        let mut sentence = format!("{}: {verdict}; {rows}: {}", self.front.chosen.id, listed(&self.there));
        if !self.left_out.is_empty() {
            let left_out = listed(&self.left_out);
            let _ = write!(sentence, "; {}: {left_out}", terminal::on_no_sheet(&SHEET_ROWS_MOST, language));
        }
        sentence
    }

    /// Returns the name of the axis, of one without a name that of its file.
    fn name(&self) -> &str {
        if self.front.project.name.is_empty() { self.front.file } else { &self.front.project.name }
    }
}

fn sentence(file: &Path, axes: &[ExportedAxis<'_>], language: Language) -> String {
    let file = path_text(file);
    match axes {
        [one] => format!("{file}: {}\n", one.sentence(language)),
        several => {
            let line = |axis: &ExportedAxis<'_>| format!("  {}: {}\n", axis.name(), axis.sentence(language));
            format!("{file}\n{}", several.iter().map(line).collect::<String>())
        }
    }
}

fn sentence_json(file: &Path, axes: &[ExportedAxis<'_>]) -> String {
    let file = path_text(file);
    let verdict = Fit::of_all(axes.iter().map(|axis| answer::fit(axis.front.chosen)));
    let of = |axis: &ExportedAxis<'_>| AxisExported {
        axis: axis.name().to_owned(),
        code: axis.front.chosen.id.to_string(),
        verdict: answer::fit(axis.front.chosen),
        tables: axis.there.clone(),
        left_out: axis.left_out.clone(),
    };
    let mut all: Vec<AxisExported> = axes.iter().map(of).collect();
    let one = if all.len() == 1 { all.pop() } else { None };
    let (code, tables, left_out) = match one {
        Some(AxisExported { code, tables, left_out, .. }) => (Some(code), tables, left_out),
        None => (None, Vec::new(), Vec::new()),
    };
    written(&ExportWritten { file, code, verdict, tables, left_out, axes: all })
}
