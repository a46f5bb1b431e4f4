//! `export`: the results as a workbook, or one table in a file.

use crate::answer::{CommandAnswer, written};
use crate::call::Call;
use crate::fault::path_text;
use crate::waiting::progress;
use answers::{ExportWritten, TableWritten};
use quantities::Language;
use questions::list::{Inquiry, Unanswered, export};
use questions::texts::standing_text;
use questions::{Candidate, Rejected, answer};
use std::borrow::Cow;
use std::fmt::Write as _;
use std::path::Path;
use tables::{Format, Front, NAMES, SHEET_ROWS_MOST, Subject, Table};
use words::terminal;

/// `antrieb export PROJECT (--out FILE | --table NAME)`
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
    let source = inquiry.source()?;
    let saver = call.saver();
    if let Some(file) = file {
        saver.ready(&[file])?;
    }
    let (axis, project) = args.axis(inquiry)?;
    format.within(&project, table, call.memory())?;
    let top = args.top;
    let sizing = questions::list::size::sized(&project, top, Rejected::All, progress())?;
    let chosen = questions::candidate_for(&project, args.code.as_ref(), || Ok(Cow::Borrowed(&sizing)))?;
    let text = source.text(language)?;
    let subject = Subject { text, axis, project: &project, sizing: &sizing, chosen: &chosen, top, language };
    let tables: Vec<Table> = match table {
        Some(name) => subject.table(name, format).into_iter().collect(),
        None => subject.tables(),
    };
    let name = call.path("project").and_then(Path::file_name);
    let name = name.map_or_else(|| source.name.clone(), |name| path_text(Path::new(name)));
    let front = Front {
        file: &name,
        revision: args.revision.as_deref(),
        date: args.date,
        project: &project,
        chosen: &chosen,
        language,
    };
    let bytes = bytes(format, &tables, &front).map_err(|error| Unanswered::message(error.message(language)))?;
    let Some(file) = file else {
        return Ok(CommandAnswer::data(String::from_utf8_lossy(&bytes).into_owned()).fits(chosen.fits()));
    };
    saver.save(&[(file, &bytes)])?;
    let (there, left_out): (Vec<&Table>, Vec<&Table>) = tables.iter().partition(|table| format.holds(table));
    let data = if call.as_json {
        sentence_json(file, (&there, &left_out), &chosen)
    } else {
        sentence(file, (&there, &left_out), &chosen, language)
    };
    Ok(CommandAnswer::data(data).fits(chosen.fits()))
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

fn bytes(format: Format, tables: &[Table], front: &Front<'_>) -> Result<Vec<u8>, tables::WriteError> {
    Ok(match (format, tables.first()) {
        (Format::Workbook, _) => tables::xlsx(tables, front)?,
        (Format::Csv, Some(table)) => tables::csv(table).into_bytes(),
        (Format::Json, Some(table)) => written(&tables::record(table)).into_bytes(),
        (Format::Parquet, Some(table)) => tables::parquet(table)?,
        (_, None) => Vec::new(),
    })
}

/// Tables in a file, and those that are too long for it.
type InFile<'t> = (&'t [&'t Table], &'t [&'t Table]);

fn sentence(file: &Path, (there, left_out): InFile<'_>, chosen: &Candidate<'_>, language: Language) -> String {
    let verdict = standing_text(chosen, language);
    let listed = |tables: &[&Table]| {
        let each = tables.iter().map(|table| format!("{} {}", table.name, table.rows.len()));
        each.collect::<Vec<_>>().join(", ")
    };
    let rows = terminal::rows(language);
    let mut sentence = format!("{}: {}: {verdict}; {rows}: {}", path_text(file), chosen.id, listed(there));
    if !left_out.is_empty() {
        let _ = write!(sentence, "; {}: {}", terminal::on_no_sheet(&SHEET_ROWS_MOST, language), listed(left_out));
    }
    sentence.push('\n');
    sentence
}

fn sentence_json(file: &Path, (there, left_out): InFile<'_>, chosen: &Candidate<'_>) -> String {
    let listed = |tables: &[&Table]| {
        let each = tables.iter().map(|table| TableWritten { name: table.name.to_owned(), rows: table.rows.len() });
        each.collect()
    };
    written(&ExportWritten {
        file: path_text(file),
        code: chosen.id.to_string(),
        verdict: answer::fit(chosen),
        tables: listed(there),
        left_out: listed(left_out),
    })
}
