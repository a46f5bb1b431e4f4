//! `sweep`: a table of axes, judged part by part. Finished parts are kept next to the output until that is complete, so
//! that an interrupted call continues.

mod parts;
mod run;
mod table;

use crate::answer::{CommandAnswer, written};
use crate::call::Call;
use crate::fault::path_text;
use parts::{PART, SweepParts};
use quantities::{Language, format_number};
use questions::list::{Inquiry, Unanswered, sweep};
use questions::sweep::{SweepSummary, Tally};
use run::SweepRun;
use std::fmt::Write as _;
use std::path::PathBuf;
use sweep_io::{BatchHead, Format};
use table::Table;
use words::sweeps;

/// `antrieb sweep PROJECT --table FILE --out FILE`
pub(crate) fn sweep(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let args = sweep::Args::read(&inquiry.given)?;
    let path = PathBuf::from(args.table.clone().unwrap_or_default());
    let (Some(out), Some(project_files)) = (call.path("out"), call.project_files()) else {
        return Ok(CommandAnswer::none());
    };
    let source = inquiry.source()?;
    let text = source.text(language)?;
    let projects = source.projects(inquiry.catalogue, inquiry.progress, language);
    let mut inputs = call.inputs(projects.as_deref().unwrap_or_default());
    inputs.push(path.clone());
    let saver = call.saver(&inputs);
    let ending = || Unanswered::option("out", (sweeps::ending_of_a_table(language).to_owned(), None));
    let place = Format::of(out).ok_or_else(ending);
    let place = place.and_then(|answers| saver.ready(&[out]).map(|()| answers));
    let table = Table { path: &path, language };
    let opened = table.open(0, PART).map(|batches| (table, batches));
    let ready = match opened {
        Ok((table, batches)) => {
            let options = args.options(inquiry.catalogue, batches.has_decimal_commas(), language)?;
            let mut head = BatchHead::read(text, projects, &batches.schema(), options);
            head.refuse_unwritable(&batches.schema(), language);
            table.checked(batches, head, project_files.clone()).map(|(sweep, rows)| (table, sweep, rows))
        }
        Err(unread) => Err(Unanswered::combined(projects.err().into_iter().chain([unread]).collect())),
    };
    let (table, sweep, rows, answers) = match (ready, place) {
        (Ok((table, sweep, rows)), Ok(answers)) => (table, sweep, rows, answers),
        (ready, place) => return Err(Unanswered::combined(ready.err().into_iter().chain(place.err()).collect())),
    };
    let request = format!("{args:?} {} {answers:?} {}", language.id(), call.memory());
    let run = SweepRun { table: &table, project: text, recordings: sweep.recordings(), files: &project_files, request };
    // Files that the table names are protected too.
    let inputs: Vec<PathBuf> =
        inputs.into_iter().chain(run.recordings.iter().map(|name| project_files.folder.join(name))).collect();
    let saver = call.saver(&inputs);
    saver.ready(&[out])?;
    let parts = SweepParts::of(&run, out, &run.mark()?, sweep.rows_within(call.memory(), PART))?;
    let mut talk = format!("{}\n", sweeps::keys(&sweep.keys().collect::<Vec<_>>().join(", "), language));
    let carried = sweep.carried().collect::<Vec<_>>().join(", ");
    if !carried.is_empty() {
        talk += &format!("{}\n", sweeps::carried(&carried, language));
    }
    talk += &parts.remark(rows);
    if let Err(why) = parts.judged(&table, &sweep, rows, inquiry) {
        return Err(parts.ended(why));
    }
    let parts = parts.verified(&run)?;
    let mut tally = Tally::default();
    if let Err(why) = saver.save_by(out, |file| parts.join(answers, &sweep, rows, file, &mut tally)) {
        return Err(parts.ended(why));
    }
    parts.remove();
    let summary = tally.summary(Some(path_text(out)), language);
    let data = if call.as_json { written(&summary) } else { shown(&summary, language) };
    Ok(CommandAnswer { talk, ..CommandAnswer::data(data) }.fits(summary.fitting > 0))
}

/// Returns the summary for the terminal.
fn shown(summary: &SweepSummary, language: Language) -> String {
    #[allow(clippy::cast_precision_loss, reason = "counts of rows")]
    let share = |rows: u64| format_number(100.0 * rows as f64 / summary.rows.max(1) as f64, 1, language);
    let counted = |rows: u64| usize::try_from(rows).unwrap_or(usize::MAX);
    let mut text = String::new();
    let _ = writeln!(
        text,
        "{}",
        sweeps::written(counted(summary.rows), &summary.file.clone().unwrap_or_default(), language)
    );
    let _ = writeln!(text, "{}", sweeps::fitting(counted(summary.fitting), &share(summary.fitting), language));
    if summary.fit_if_estimate > 0 {
        let rows = summary.fit_if_estimate;
        let _ = writeln!(text, "  {}", sweeps::fitting_if_estimate(&rows, &share(rows), language));
    }
    let missed: u64 = summary.none_fits.iter().map(|each| each.rows).sum();
    if missed > 0 {
        let _ = writeln!(
            text,
            "{}; {}:",
            sweeps::none_fits(counted(missed), &share(missed), language),
            sweeps::tightest(language)
        );
        for each in &summary.none_fits {
            let _ = writeln!(text, "  {:>10}  {}", each.rows, each.title);
        }
    }
    let refused: u64 = summary.not_judged.iter().map(|each| each.rows).sum::<u64>() + summary.further;
    if refused > 0 {
        let _ = writeln!(
            text,
            "{}; {}:",
            sweeps::not_judged(counted(refused), &share(refused), language),
            sweeps::reason(language)
        );
        for each in &summary.not_judged {
            let _ = writeln!(text, "  {:>10}  {}", each.rows, each.message);
        }
        if summary.further > 0 {
            let _ = writeln!(text, "  {:>10}  {}", summary.further, sweeps::further(language));
        }
    }
    text
}
