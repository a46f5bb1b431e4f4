//! `simulate`: the digital twin of an axis.

use crate::answer::{CommandAnswer, written};
use crate::call::Call;
use crate::fault::path_text;
use crate::laid_out::shown;
use crate::plot;
use crate::reserve::assumptions_about;
use answers::{Answered, Fit};
use questions::list::{Inquiry, Unanswered, identify, simulate};
use questions::{answer, chapter};
use std::io::{BufWriter, Write};
use tables::Format;
use words::{file_trouble, simulation, terminal};

/// `antrieb simulate PROJECT --code CODE --scenario NAME --out FILE`
pub(crate) fn simulate(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let args = simulate::Args::read(&inquiry.given)?;
    let file = call.path("out");
    let ending = || Unanswered::option("out", (simulation::ending_of_a_trace(language).to_owned(), None));
    let is_trace = |format: &Format| matches!(format, Format::Csv | Format::Parquet);
    let format = file.map(|file| Format::of(file).filter(is_trace).ok_or_else(ending)).transpose()?;
    let axes = args.axes(inquiry)?;
    let saver = call.saver();
    // As with `plot`: without a file the picture goes to standard output.
    let draws = plot::is_asked(call) || args.figure.is_some();
    if draws {
        plot::destination(call, file)?;
    } else if let Some(file) = file {
        saver.ready(&[file])?;
    }
    if (file.is_some() || draws) && axes.len() > 1 {
        let names = axes.iter().map(|(_, project)| project.name.clone()).collect();
        return Err(Unanswered::which_axis(names, |names| terminal::several_axes(&names, language)));
    }
    let runs = inquiry.each(&axes, |project| args.simulated(project, inquiry, file.is_some() || draws))?;
    let fits = runs.iter().all(questions::Simulated::fits);
    let mut records: Vec<answers::Simulation> = runs.iter().map(|run| answer::simulation(run, language)).collect();
    if let (Some(file), Some(format), Some(run), Some(record)) = (file, format, runs.first(), records.first_mut()) {
        match (format, args.days_of(run, language)?) {
            (format, Some(days)) => {
                let table = tables::days(days, language);
                let bytes = if format == Format::Parquet {
                    tables::parquet(&table)
                } else {
                    Ok(tables::csv(&table).into_bytes())
                };
                saver.save(&[(file, &bytes.map_err(|error| Unanswered::message(error.message(language)))?)])?;
            }
            (Format::Parquet, None) => {
                let table = tables::trace(&run.course, &args.signals, language);
                let bytes = tables::parquet(&table);
                saver.save(&[(file, &bytes.map_err(|error| Unanswered::message(error.message(language)))?)])?;
            }
            (Format::Csv | Format::Json | Format::Workbook, None) => saver.save_by(file, |to| {
                let mut to = BufWriter::new(to);
                let refused = |error: &std::io::Error| Unanswered::message(file_trouble(error, language));
                let rows = |rows: &str| to.write_all(rows.as_bytes());
                tables::trace_csv(&run.course, &args.signals, language, rows).map_err(|error| refused(&error))?;
                to.flush().map_err(|error| refused(&error))
            })?,
        }
        record.trace = Some(path_text(file));
    }
    if let Some(run) = runs.first().filter(|_| draws) {
        let drawing = figures::of_a_run(args.figure.as_deref(), run, language);
        return Ok(plot::draw(&drawing, call)?.fits(fits));
    }
    let data = if call.as_json {
        written(&Answered::of(records, Fit::of(fits)))
    } else {
        let text = |(record, run): (&answers::Simulation, &questions::Simulated<'_>)| {
            let assumed = assumptions_about(run.project, &run.candidate, language);
            let text = shown(&chapter::simulation(record, language), language) + "\n" + &assumed;
            match &record.trace {
                Some(file) if args.days_of(run, language).is_ok_and(|days| days.is_some()) => {
                    let rows: usize = run.days().unwrap_or_default().iter().map(|day| day.points.len()).sum();
                    format!("{text}\n{}\n", simulation::days_written(file, &rows, language))
                }
                Some(file) => {
                    let every = quantities::format_significant(run.every_s() * 1e3, 4, language);
                    format!("{text}\n{}\n", simulation::trace_written(file, &run.course.len(), &every, language))
                }
                None => text,
            }
        };
        records.iter().zip(&runs).map(text).collect::<Vec<_>>().join("\n")
    };
    Ok(CommandAnswer::data(data).fits(fits))
}

/// `antrieb identify TRACE PROJECT`
pub(crate) fn identify(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let found = identify::found(inquiry)?;
    let text = || shown(&chapter::identification(&found, call.language), call.language);
    let fits = found.doubts.is_empty();
    Ok(CommandAnswer::data(if call.as_json { written(&found) } else { text() }).fits(fits))
}
