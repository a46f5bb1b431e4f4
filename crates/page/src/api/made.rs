//! Answers that are drawn, typeset or written as tables.

use crate::{Reply, ReportInputs, Shell};
use figures::{By, Drawing, Figure, NoFigure, Size, Theme};
use quantities::{Language, Length};
use questions::answer::written;
use questions::list::{
    Cost, Inquiry, Unanswered, commission_checklist, export, media, plot, report, simulate, upkeep_calendar,
};
use questions::{Refusal, Rejected};
use std::borrow::Cow;
use std::convert::Infallible;
use tables::{AxisSheets, Format, Front, Subject};
use words::{requests, simulation, terminal};

/// Makes an answer.
type Makes = fn(&Inquiry<'_>, &dyn Shell) -> Result<Reply, Unanswered>;

/// The questions answered here, by command.
const MADE: [(&str, Makes); 7] = [
    (super::OPENAPI.command, openapi),
    (plot::ENTRY.command, drawn),
    (report::ENTRY.command, typeset),
    (commission_checklist::ENTRY.command, checklist),
    (export::ENTRY.command, tabled),
    (simulate::ENTRY.command, simulated),
    (upkeep_calendar::ENTRY.command, calendar),
];

/// Returns the reply to a question answered here.
pub(super) fn reply(command: &str, inquiry: &Inquiry<'_>, shell: &dyn Shell) -> Result<Reply, Unanswered> {
    let made = MADE.iter().find(|(made, _)| *made == command);
    made.map_or(Err(Refusal::NoData.into()), |(_, make)| make(inquiry, shell))
}

/// Returns `true` if the answer to a question is made here.
#[cfg(test)]
pub(super) fn is_made(command: &str) -> bool {
    MADE.iter().any(|(made, _)| *made == command)
}

fn openapi(inquiry: &Inquiry<'_>, _: &dyn Shell) -> Result<Reply, Unanswered> {
    Ok(Reply::of(200, media::JSON, written(&super::openapi::document(inquiry.language))))
}

fn drawn(inquiry: &Inquiry<'_>, _: &dyn Shell) -> Result<Reply, Unanswered> {
    let args = plot::Args::read(&inquiry.given)?;
    let project = args.drawn(inquiry)?;
    let candidate = args.candidate(&project, inquiry)?;
    let figure = args.figure.as_deref().and_then(Figure::of_id).ok_or(Refusal::NoData)?;
    let by = if args.by == Some(true) { By::Length } else { By::Mass };
    let drawing = figures::draw(figure, &project, &candidate, by, inquiry.progress, inquiry.language);
    let drawing = drawing.map_err(|fault| match fault {
        NoFigure::Refused(refusal) => refusal.into(),
        other => Unanswered::message(other.message(None, inquiry.language)),
    })?;
    picture(&drawing, args.theme, [args.width, args.height], inquiry.language)
}

/// Returns a picture with the stated colours, width and height.
fn picture(
    drawing: &Drawing,
    is_dark: Option<bool>,
    [width, height]: [Option<Length>; 2],
    language: Language,
) -> Result<Reply, Unanswered> {
    let side = |name, length: Option<_>, usual| {
        let side = length.map_or(Ok(usual), |length| figures::side_mm(length, language));
        side.map_err(|what| Unanswered::option(name, (what, None)))
    };
    let usual = drawing.size_mm;
    let size = Size::millimetres(side("width", width, usual.0)?, side("height", height, usual.1)?);
    let theme = if is_dark == Some(true) { Theme::Dark } else { Theme::Light };
    let svg = drawing.render(&drawing.style(size, theme, language)).into_svg();
    Ok(Reply::of(200, media::SVG, svg))
}

fn typeset(inquiry: &Inquiry<'_>, shell: &dyn Shell) -> Result<Reply, Unanswered> {
    let language = inquiry.language;
    let write = shell.report().ok_or_else(|| Unanswered::message(terminal::built_without_report(language)))?;
    let args = report::Args::read(&inquiry.given)?;
    let axes = args.axes(inquiry)?;
    let bytes = write(&ReportInputs {
        text: inquiry.source()?.text(language)?,
        axes: &axes,
        args: &args,
        language,
        progress: inquiry.progress,
    });
    Ok(Reply::of(200, media::PDF, bytes.map_err(Unanswered::message)?).saved_as("antrieb.pdf"))
}

fn checklist(inquiry: &Inquiry<'_>, shell: &dyn Shell) -> Result<Reply, Unanswered> {
    let language = inquiry.language;
    let write = shell.checklist().ok_or_else(|| Unanswered::message(terminal::built_without_report(language)))?;
    let sheet = commission_checklist::found(inquiry)?;
    let bytes = write(&sheet, language).map_err(Unanswered::message)?;
    Ok(Reply::of(200, media::PDF, bytes).saved_as(&format!("{}.pdf", sheet.code)))
}

fn calendar(inquiry: &Inquiry<'_>, _: &dyn Shell) -> Result<Reply, Unanswered> {
    let (plan, found, name) = upkeep_calendar::found(inquiry)?;
    let text = tables::calendar(&plan, &found, name.as_deref(), inquiry.language);
    Ok(Reply::of(200, media::CALENDAR, text).saved_as(&format!("{}.ics", found.code)))
}

/// Returns the record of a run, its course as a table, or a picture of it.
fn simulated(inquiry: &Inquiry<'_>, _: &dyn Shell) -> Result<Reply, Unanswered> {
    let language = inquiry.language;
    let args = simulate::Args::read(&inquiry.given)?;
    let stated = |name: &'static str, why: &str| Unanswered::option(name, (why.to_owned(), None));
    if args.format.as_deref() == Some(simulate::PICTURE_FORMAT) {
        if !args.signals.is_empty() {
            return Err(stated("signals", simulation::signals_need_a_format(language)));
        }
        let (_, project) = inquiry.axis(args.axis.as_deref(), Cost::Other)?;
        let run = args.simulated(&project, inquiry, true)?;
        let drawing = figures::of_a_run(args.figure.as_deref(), &run, language);
        return picture(&drawing, args.theme, [args.width, args.height], language);
    }
    if args.figure.is_some() {
        return Err(stated("figure", simulation::figure_needs_a_format(language)));
    }
    let format = args.format.as_deref().and_then(Format::of_ending).filter(|format| *format != Format::Json);
    let Some(format) = format else {
        if args.signals.is_empty() {
            let answer = simulate::record(&args, inquiry)?;
            return Ok(Reply::of(200, answer.media, answer.text));
        }
        return Err(stated("signals", simulation::signals_need_a_format(language)));
    };
    let (_, project) = inquiry.axis(args.axis.as_deref(), Cost::Other)?;
    let run = args.simulated(&project, inquiry, true)?;
    let (media, bytes) = match (format, args.days_of(&run, language)?) {
        (format, Some(days)) => {
            let table = tables::days(days, language);
            match format {
                Format::Parquet => {
                    let bytes = tables::parquet(&table);
                    (media::PARQUET, bytes.map_err(|error| Unanswered::message(error.message(language)))?)
                }
                Format::Csv | Format::Json | Format::Workbook => (media::CSV, tables::csv(&table).into_bytes()),
            }
        }
        (Format::Parquet, None) => {
            let bytes = tables::parquet(&tables::trace(&run.course, &args.signals, language));
            (media::PARQUET, bytes.map_err(|error| Unanswered::message(error.message(language)))?)
        }
        (Format::Csv | Format::Json | Format::Workbook, None) => {
            let mut bytes = Vec::new();
            let rows = |rows: &str| {
                bytes.extend_from_slice(rows.as_bytes());
                Ok::<_, Infallible>(())
            };
            let Ok(()) = tables::trace_csv(&run.course, &args.signals, language, rows);
            (media::CSV, bytes)
        }
    };
    Ok(Reply::of(200, media, bytes).saved_as(&format!("trace.{}", format.ending())))
}

fn tabled(inquiry: &Inquiry<'_>, shell: &dyn Shell) -> Result<Reply, Unanswered> {
    let language = inquiry.language;
    let args = export::Args::read(&inquiry.given)?;
    let table = args.table.as_deref();
    let usual = if table.is_some() { Format::Json } else { Format::Workbook };
    let format = args.format.as_deref().and_then(Format::of_ending).unwrap_or(usual);
    match (format, table) {
        (Format::Workbook, Some(_)) => return Err(Unanswered::message(requests::workbook_has_all_tables(language))),
        (Format::Json | Format::Csv | Format::Parquet, None) => {
            return Err(Unanswered::message(requests::format_needs_a_table(&format.ending(), language)));
        }
        (Format::Workbook, None) | (Format::Json | Format::Csv | Format::Parquet, Some(_)) => {}
    }
    let axes = args.axes(inquiry)?;
    for (_, (_, project)) in &axes {
        format.within(project, table, shell.files().grant().memory)?;
    }
    let mut sizings = Vec::new();
    for (_, (_, project)) in &axes {
        sizings.push(questions::list::size::sized(project, args.top, Rejected::All, inquiry.progress)?);
    }
    let mut all_chosen = Vec::new();
    for ((_, (_, project)), sizing) in axes.iter().zip(&sizings) {
        all_chosen.push(questions::candidate_for(project, args.code.as_ref(), || Ok(Cow::Borrowed(sizing)))?);
    }
    let mut subjects = Vec::new();
    for (((place, (axis, project)), sizing), chosen) in axes.iter().zip(&sizings).zip(&all_chosen) {
        let Some(source) = inquiry.sources.get(*place) else { continue };
        let (text, top) = (source.text(language)?, args.top);
        let subject = Subject { text, axis: *axis, project, sizing, chosen, top, language };
        let (revision, date) = (args.revision.as_deref(), args.date);
        subjects.push((subject, Front { file: &source.name, revision, date, project, chosen, language }));
    }
    let not_written = |error: tables::WriteError| Unanswered::message(error.message(language));
    let Some(name) = table else {
        let sheets = subjects.iter().map(|(subject, front)| AxisSheets { tables: subject.tables(), front: *front });
        let bytes = tables::xlsx_of_axes(sheets.collect(), language).map_err(not_written)?;
        return Ok(Reply::of(200, media::XLSX, bytes).saved_as("antrieb.xlsx"));
    };
    let (subject, _) = subjects.first().ok_or(Refusal::NoData)?;
    let table = subject.table(name, format).ok_or(Refusal::NoData)?;
    Ok(match format {
        Format::Csv => Reply::of(200, media::CSV, tables::csv(&table)).saved_as(&format!("{name}.csv")),
        Format::Parquet => {
            let bytes = tables::parquet(&table).map_err(not_written)?;
            Reply::of(200, media::PARQUET, bytes).saved_as(&format!("{name}.parquet"))
        }
        Format::Json | Format::Workbook => super::record(200, &tables::record(&table)),
    })
}
