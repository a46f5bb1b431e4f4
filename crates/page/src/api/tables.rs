//! The results as a workbook, or one table of them.

use super::asked::Asked;
use super::{Unanswered, list, record};
use crate::Reply;
use tables::{Format, Front, Subject};
use workbench::answer;
use workbench::text::{requests, terminal};

/// How many of the ranking the tables hold where nobody says.
const TOP_USUAL: usize = 20;

pub(super) fn export(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let language = asked.language;
    let table = asked.text("table");
    let usual = if table.is_some() { Format::Json } else { Format::Workbook };
    let format = asked.text("format").and_then(Format::of_ending).unwrap_or(usual);
    match (format, table) {
        (Format::Workbook, Some(_)) => return Err(answer::fault(requests::workbook_has_all_tables(language)).into()),
        (Format::Json | Format::Csv | Format::Parquet, None) => {
            return Err(answer::fault(&requests::format_needs_a_table(&format.ending(), language)).into());
        }
        _ => {}
    }
    let (revision, date, file) = (asked.label("revision")?, asked.label("date")?, asked.name()?);
    let (axis, project) = asked.axis_or(|names| terminal::export_is_of_one_axis(&names, language))?;
    let code = asked.code_if_any()?;
    let memory = asked.shell.files().grant().memory;
    format.within(&project, table, memory).map_err(|refusal| asked.refused(&refusal))?;
    let top = asked.whole("top").unwrap_or(TOP_USUAL);
    let sizing = workbench::sized(&project, top, asked.patience).map_err(|refusal| asked.refused(&refusal))?;
    let chosen =
        workbench::candidate_of_tables(&project, code.as_ref(), &sizing).map_err(|refusal| asked.refused(&refusal))?;
    let subject =
        Subject { text: asked.body()?, axis, project: &project, sizing: &sizing, chosen: &chosen, top, language };
    let not_written = |error: tables::WriteError| Unanswered::from(answer::fault(&error.message(language)));
    let Some(name) = table else {
        let front = Front {
            file: &file,
            revision: revision.as_deref(),
            date: date.as_deref(),
            project: &project,
            chosen: &chosen,
            language,
        };
        let bytes = tables::xlsx(&subject.tables(), &front).map_err(not_written)?;
        return Ok(Reply::of(200, list::XLSX, bytes).saved_as("antrieb.xlsx"));
    };
    let table = subject.table(name, format).ok_or_else(|| asked.refused(&workbench::Refusal::NoData))?;
    Ok(match format {
        Format::Csv => Reply::of(200, list::CSV, tables::csv(&table)).saved_as(&format!("{name}.csv")),
        Format::Parquet => {
            let bytes = tables::parquet(&table).map_err(not_written)?;
            Reply::of(200, list::PARQUET, bytes).saved_as(&format!("{name}.parquet"))
        }
        Format::Json | Format::Workbook => record(200, &tables::record(&table)),
    })
}
