//! `sweep`: a table of axes, judged part by part. Finished parts are kept next to the output until that is complete, so
//! that an interrupted call continues.

mod parts;
mod run;

use crate::answer::{CommandAnswer, written};
use crate::call::Call;
use crate::fault::path_text;
use parts::{PART, SweepParts};
use quantities::{Language, format_number};
use questions::list::{Inquiry, Unanswered, sweep};
use questions::sweep::{SweepSummary, Tally};
use run::SweepRun;
use std::fmt::Write as _;
use std::fs::File;
use std::path::{Path, PathBuf};
use sweep_io::{BatchHead, BatchSweep, Batches, Format, NoBatch};
use words::{file_trouble, sweeps};

/// A table in a file.
struct Table<'c> {
    path: &'c Path,
    language: Language,
}

/// `antrieb sweep PROJECT --table FILE --out FILE`
pub(crate) fn sweep(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let args = sweep::Args::read(&inquiry.given)?;
    let path = PathBuf::from(args.table.clone().unwrap_or_default());
    let (Some(out), Some(beside)) = (call.path("out"), call.beside()) else { return Ok(CommandAnswer::none()) };
    let source = inquiry.source()?;
    let text = source.text(language)?;
    let projects = source.projects(inquiry.progress, language);
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
            let options = args.options(batches.has_decimal_commas(), language)?;
            let head = BatchHead::read(text, projects, &batches.schema(), options);
            table.checked(batches, head, beside.clone()).map(|(sweep, rows)| (table, sweep, rows))
        }
        Err(unread) => Err(Unanswered::together(projects.err().into_iter().chain([unread]).collect())),
    };
    let (table, sweep, rows, answers) = match (ready, place) {
        (Ok((table, sweep, rows)), Ok(answers)) => (table, sweep, rows, answers),
        (ready, place) => return Err(Unanswered::together(ready.err().into_iter().chain(place.err()).collect())),
    };
    let request = format!("{args:?} {} {answers:?} {}", language.id(), call.memory());
    let run = SweepRun { table: &table, project: text, recordings: sweep.recordings(), files: &beside, request };
    // Files that the table names are protected too.
    let inputs: Vec<PathBuf> =
        inputs.into_iter().chain(run.recordings.iter().map(|name| beside.folder.join(name))).collect();
    let saver = call.saver(&inputs);
    saver.ready(&[out])?;
    let parts = SweepParts::of(&run, out, &run.mark()?, sweep.rows_within(call.memory(), PART))?;
    let mut talk = format!("{}\n", sweeps::keys(&sweep.keys().collect::<Vec<_>>().join(", "), language));
    talk += &parts.remark(rows);
    if let Err(why) = parts.judged(&table, &sweep, rows, inquiry) {
        return Err(parts.ended(why));
    }
    let parts = parts.verified(&run)?;
    let mut tally = Tally::default();
    if let Err(why) = saver.save_by(out, |file| parts.together(answers, &sweep, rows, file, &mut tally)) {
        return Err(parts.ended(why));
    }
    parts.remove();
    let summary = tally.summary(Some(path_text(out)), language);
    let data = if call.as_json { written(&summary) } else { shown(&summary, language) };
    Ok(CommandAnswer { talk, ..CommandAnswer::data(data) }.fits(summary.fitting > 0))
}

impl Table<'_> {
    /// Returns a message about the table.
    fn refused(&self, why: &str) -> Unanswered {
        Unanswered::message(sweeps::unreadable(&path_text(self.path), &why, self.language))
    }

    fn file(&self) -> Result<File, Unanswered> {
        File::open(self.path).map_err(|error| self.refused(&file_trouble(&error, self.language)))
    }

    /// Opens the table at a row, so many at a time.
    fn open(&self, skipped: u64, rows: usize) -> Result<Batches, Unanswered> {
        let opened = Batches::open(self.file()?, skipped, rows, self.language);
        opened.map_err(|why| self.refused(&why.text(self.language)))
    }

    /// Returns the sweep over the table and the number of its rows, after all cells have been read without faults.
    fn checked(
        &self,
        mut batches: Batches,
        mut head: BatchHead,
        beside: disk::Beside,
    ) -> Result<(BatchSweep, u64), Unanswered> {
        let mut rows = 0;
        let unread = loop {
            if head.is_enough() {
                break None;
            }
            match batches.next(self.language) {
                Ok(Some(batch)) => {
                    head.check(&batch, rows);
                    rows += batch.num_rows() as u64;
                }
                Ok(None) => {
                    head.refuse_empty(rows);
                    break None;
                }
                Err(NoBatch::Line(fault)) => {
                    head.refuse_line(fault, rows);
                    rows += 1;
                }
                Err(NoBatch::Table(why)) => break Some(self.refused(&why)),
            }
        };
        match (head.ready(&path_text(self.path), Box::new(beside)), unread) {
            (Ok(sweep), None) => Ok((sweep, rows)),
            (ready, unread) => Err(Unanswered::together(ready.err().into_iter().chain(unread).collect())),
        }
    }
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
