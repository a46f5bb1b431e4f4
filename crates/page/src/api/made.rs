//! Answers that are drawn, typeset or written as tables.

use crate::{Reply, ReportAsked, Shell};
use figures::{By, Drawing, Figure, NoFigure, Size, Theme};
use quantities::{Language, Length};
use questions::answer::written;
use questions::list::{
    Asked, Cost, Unanswered, commission_checklist, export, media, plot, report, simulate, upkeep_calendar,
};
use questions::{Refusal, Rejected};
use std::borrow::Cow;
use std::convert::Infallible;
use tables::{Format, Front, Subject};
use words::{requests, simulation, terminal};

/// Makes an answer.
type Makes = fn(&Asked<'_>, &dyn Shell) -> Result<Reply, Unanswered>;

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
pub(super) fn reply(command: &str, asked: &Asked<'_>, shell: &dyn Shell) -> Result<Reply, Unanswered> {
    let made = MADE.iter().find(|(made, _)| *made == command);
    made.map_or(Err(Refusal::NoData.into()), |(_, make)| make(asked, shell))
}

/// Returns `true` if the answer to a question is made here.
#[cfg(test)]
pub(super) fn is_made(command: &str) -> bool {
    MADE.iter().any(|(made, _)| *made == command)
}

fn openapi(asked: &Asked<'_>, _: &dyn Shell) -> Result<Reply, Unanswered> {
    Ok(Reply::of(200, media::JSON, written(&super::openapi::document(asked.language))))
}

fn drawn(asked: &Asked<'_>, _: &dyn Shell) -> Result<Reply, Unanswered> {
    let args = plot::Args::read(&asked.given)?;
    let project = args.drawn(asked)?;
    let candidate = args.candidate(&project, asked)?;
    let figure = args.figure.as_deref().and_then(Figure::of_id).ok_or(Refusal::NoData)?;
    let by = if args.by == Some(true) { By::Length } else { By::Mass };
    let drawing = figures::draw(figure, &project, &candidate, by, asked.patience, asked.language);
    let drawing = drawing.map_err(|fault| match fault {
        NoFigure::Refused(refusal) => refusal.into(),
        other => Unanswered::message(other.message(None, asked.language)),
    })?;
    picture(&drawing, args.theme, [args.width, args.height], asked.language)
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

fn typeset(asked: &Asked<'_>, shell: &dyn Shell) -> Result<Reply, Unanswered> {
    let language = asked.language;
    let write = shell.report().ok_or_else(|| Unanswered::message(terminal::built_without_report(language)))?;
    let args = report::Args::read(&asked.given)?;
    let axes = args.axes(asked)?;
    let bytes = write(&ReportAsked {
        text: asked.source()?.text(language)?,
        axes: &axes,
        args: &args,
        language,
        patience: asked.patience,
    });
    Ok(Reply::of(200, media::PDF, bytes.map_err(Unanswered::message)?).saved_as("antrieb.pdf"))
}

fn checklist(asked: &Asked<'_>, shell: &dyn Shell) -> Result<Reply, Unanswered> {
    let language = asked.language;
    let write = shell.checklist().ok_or_else(|| Unanswered::message(terminal::built_without_report(language)))?;
    let sheet = commission_checklist::found(asked)?;
    let bytes = write(&sheet, language).map_err(Unanswered::message)?;
    Ok(Reply::of(200, media::PDF, bytes).saved_as(&format!("{}.pdf", sheet.code)))
}

fn calendar(asked: &Asked<'_>, _: &dyn Shell) -> Result<Reply, Unanswered> {
    let (plan, found, name) = upkeep_calendar::found(asked)?;
    let text = tables::calendar(&plan, &found, name.as_deref(), asked.language);
    Ok(Reply::of(200, media::CALENDAR, text).saved_as(&format!("{}.ics", found.code)))
}

/// Returns the record of a run, its course as a table, or a picture of it.
fn simulated(asked: &Asked<'_>, _: &dyn Shell) -> Result<Reply, Unanswered> {
    let language = asked.language;
    let args = simulate::Args::read(&asked.given)?;
    let stated = |name: &'static str, why: &str| Unanswered::option(name, (why.to_owned(), None));
    if args.format.as_deref() == Some(simulate::PICTURE_FORMAT) {
        if !args.signals.is_empty() {
            return Err(stated("signals", simulation::signals_need_a_format(language)));
        }
        let (_, project) = asked.axis(args.axis.as_deref(), Cost::Other)?;
        let run = args.simulated(&project, asked, true)?;
        let drawing = figures::of_a_run(args.figure.as_deref(), &run, language);
        return picture(&drawing, args.theme, [args.width, args.height], language);
    }
    if args.figure.is_some() {
        return Err(stated("figure", simulation::figure_needs_a_format(language)));
    }
    let format = args.format.as_deref().and_then(Format::of_ending).filter(|format| *format != Format::Json);
    let Some(format) = format else {
        if args.signals.is_empty() {
            let answer = simulate::record(&args, asked)?;
            return Ok(Reply::of(200, answer.media, answer.text));
        }
        return Err(stated("signals", simulation::signals_need_a_format(language)));
    };
    let (_, project) = asked.axis(args.axis.as_deref(), Cost::Other)?;
    let run = args.simulated(&project, asked, true)?;
    let (media, bytes) = match format {
        Format::Parquet => {
            let bytes = tables::parquet(&tables::trace(&run.course, &args.signals, language));
            (media::PARQUET, bytes.map_err(|error| Unanswered::message(error.message(language)))?)
        }
        Format::Csv | Format::Json | Format::Workbook => {
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

fn tabled(asked: &Asked<'_>, shell: &dyn Shell) -> Result<Reply, Unanswered> {
    let language = asked.language;
    let args = export::Args::read(&asked.given)?;
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
    let (axis, project) = args.axis(asked)?;
    format.within(&project, table, shell.files().grant().memory)?;
    let sizing = questions::list::size::sized(&project, args.top, Rejected::All, asked.patience)?;
    let chosen = questions::candidate_for(&project, args.code.as_ref(), || Ok(Cow::Borrowed(&sizing)))?;
    let source = asked.source()?;
    let (text, top) = (source.text(language)?, args.top);
    let subject = Subject { text, axis, project: &project, sizing: &sizing, chosen: &chosen, top, language };
    let not_written = |error: tables::WriteError| Unanswered::message(error.message(language));
    let Some(name) = table else {
        let front = Front {
            file: &source.name,
            revision: args.revision.as_deref(),
            date: args.date.as_deref(),
            project: &project,
            chosen: &chosen,
            language,
        };
        let bytes = tables::xlsx(&subject.tables(), &front).map_err(not_written)?;
        return Ok(Reply::of(200, media::XLSX, bytes).saved_as("antrieb.xlsx"));
    };
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
