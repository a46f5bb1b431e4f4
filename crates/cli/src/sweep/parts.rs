//! Finished parts of the output, kept next to it until it is complete, so that an interrupted call continues.

use super::run::{RunMark, SweepRun};
use super::table::Table;
use crate::fault::path_text;
use disk::PartsTrouble;
use quantities::Language;
use questions::list::{Inquiry, Unanswered};
use questions::sweep::Tally;
use std::ffi::OsString;
use std::fs::File;
use std::io::{BufWriter, Write as _};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use sweep_io::{Answers, BatchSweep, Batches, Constants, Format, NoBatch};
use words::{SaveTrouble, file_trouble, save_trouble, sweeps};

/// Largest number of rows of a part.
pub(super) const PART: usize = 1 << 14;

/// Values of finished parts that are read at a time, over all columns.
const VALUES_READ: usize = 1 << 18;

/// Parts of the output of one run.
pub(super) struct SweepParts {
    folder: PathBuf,
    parts: disk::Parts,
    /// Number of parts of an earlier call.
    kept: u64,
    /// Remark on the parts of another run that are discarded.
    discarded: Option<String>,
    /// Mark of this run.
    mark: RunMark,
    /// Number of rows of a part; its answers are held in memory.
    rows: usize,
    language: Language,
}

/// Returns the message about an error of the folder.
fn refused(folder: &Path, trouble: PartsTrouble, language: Language) -> Unanswered {
    let shown = path_text(folder);
    Unanswered::message(match trouble {
        PartsTrouble::Foreign => sweeps::parts_foreign(&shown, language),
        PartsTrouble::ForeignFile(name) => sweeps::parts_foreign_file(&path_text(&folder.join(name)), language),
        PartsTrouble::Busy => sweeps::parts_busy(&shown, language),
        PartsTrouble::System(error) => {
            format!("{shown}: {}", save_trouble(&SaveTrouble::System((&error).into()), language))
        }
    })
}

impl SweepParts {
    /// Opens the parts next to the output. Those of the same run are kept; those of another run are removed only on request.
    ///
    /// # Errors
    /// Errors of the folder; parts of another run without the request to discard them.
    pub(super) fn of(
        run: &SweepRun<'_>,
        out: &Path,
        mark: RunMark,
        rows: usize,
        discards: bool,
    ) -> Result<Self, Unanswered> {
        let mut name = out.file_name().map(OsString::from).unwrap_or_default();
        name.push(".parts");
        let folder = out.with_file_name(name);
        let language = run.table.language;
        let parts = disk::Parts::open(&folder).map_err(|trouble| refused(&folder, trouble, language))?;
        let written = mark.written();
        let is_same = parts.mark() == written;
        let mut found = Self { folder, parts, kept: 0, discarded: None, mark, rows, language };
        if !is_same {
            let others = found.count()?;
            let inputs = found.mark.differences(found.parts.mark(), language);
            if others > 0 && !discards {
                let message = sweeps::other_run(others, &path_text(&found.folder), &inputs, language);
                return Err(Unanswered::option("out", (message, Some(sweeps::other_run_hint(language).to_owned()))));
            }
            found.discarded = (others > 0).then(|| sweeps::begun_anew(others, &inputs, language));
            if let Err(trouble) = found.parts.begin(&written) {
                let why = found.failed(trouble);
                return Err(found.ended(why));
            }
        }
        while found.parts.holds(found.kept).map_err(|trouble| found.failed(trouble))? {
            found.kept += 1;
        }
        Ok(found)
    }

    /// Returns the number of finished parts, of whatever run.
    fn count(&self) -> Result<usize, Unanswered> {
        let mut count = 0;
        while self.parts.has(count).map_err(|trouble| self.failed(trouble))? {
            count += 1;
        }
        Ok(usize::try_from(count).unwrap_or(usize::MAX))
    }

    /// Returns a remark on the use of earlier parts; `rows` is the number of rows of the table.
    pub(super) fn remark(&self, rows: u64) -> String {
        if let Some(discarded) = &self.discarded {
            return format!("{discarded}\n");
        }
        let kept = rows.min(self.kept * self.rows as u64);
        let parts = usize::try_from(self.kept).unwrap_or(usize::MAX);
        if parts == 0 { String::new() } else { format!("{}\n", sweeps::resumed(parts, &kept, self.language)) }
    }

    fn failed(&self, trouble: PartsTrouble) -> Unanswered {
        refused(&self.folder, trouble, self.language)
    }

    fn unread(&self, why: &str) -> Unanswered {
        Unanswered::message(format!("{}: {why}", path_text(&self.folder)))
    }

    /// Judges the missing rows, one part at a time.
    pub(super) fn judged(
        &self,
        table: &Table<'_>,
        sweep: &BatchSweep,
        rows: u64,
        inquiry: &Inquiry<'_>,
    ) -> Result<(), Unanswered> {
        let mut index = self.kept;
        let mut first = index * self.rows as u64;
        if first >= rows {
            return Ok(());
        }
        inquiry.progress.expect_steps(usize::try_from(rows - first).unwrap_or(usize::MAX));
        crate::waiting::count_rows(first);
        let kept = Arc::new(AtomicU64::new(first));
        let _words = disk::LastWords::set(self.last_words(rows, &kept));
        disk::end_on_signals();
        let mut batches = table.open(first, self.rows)?;
        while first < rows {
            let batch = batches.next(self.language).map_err(|why| table.refused(&why.text(self.language)))?;
            let Some(batch) = batch else { break };
            let answers = sweep.batch(&batch, first, inquiry.progress)?;
            let bytes = sweep_io::part(&answers).map_err(|why| self.unread(&why))?;
            self.parts.write(index, &bytes).map_err(|trouble| self.failed(trouble))?;
            first += batch.num_rows() as u64;
            kept.store(first, Ordering::Relaxed);
            index += 1;
        }
        Ok(())
    }

    /// Returns the message about the rows that an interrupted run keeps.
    fn last_words(&self, rows: u64, kept: &Arc<AtomicU64>) -> impl Fn() -> String + Send + 'static {
        let (kept, folder, part, language) = (Arc::clone(kept), path_text(&self.folder), self.rows, self.language);
        move || match kept.load(Ordering::Relaxed) {
            0 => sweeps::interrupted_early(&part, language),
            kept => sweeps::interrupted(&kept, &rows, &folder, language),
        }
    }

    /// Ends a run without an output: finished parts stay, and the reason names them; an empty folder is removed.
    pub(super) fn ended(self, why: Unanswered) -> Unanswered {
        if !self.parts.has(0).unwrap_or(true) {
            self.parts.remove();
            return why;
        }
        let kept = Unanswered::message(sweeps::kept(&path_text(&self.folder), self.language));
        Unanswered::combined(vec![why, kept])
    }

    /// Ends a run whose inputs changed while it ran: no part is kept.
    fn changed(self) -> Unanswered {
        let why = Unanswered::message(sweeps::parts_changed(self.language));
        self.parts.remove();
        why
    }

    /// Checks that the inputs are unchanged, and that the parts belong to this run.
    pub(super) fn verified(self, run: &SweepRun<'_>) -> Result<Self, Unanswered> {
        let verified = run.mark().and_then(|mark| {
            let is_marked = self.parts.is_marked().map_err(|trouble| self.failed(trouble))?;
            Ok(is_marked && mark == self.mark)
        });
        match verified {
            Ok(true) => Ok(self),
            Ok(false) => Err(self.changed()),
            Err(why) => Err(self.ended(why)),
        }
    }

    /// Joins all parts to one file and counts the answers.
    pub(super) fn join(
        &self,
        (format, constants): (Format, &Constants),
        sweep: &BatchSweep,
        rows: u64,
        file: &mut File,
        tally: &mut Tally,
    ) -> Result<(), Unanswered> {
        let failed = |why: String| self.unread(&why);
        let unread = |why: NoBatch| self.unread(&why.text(self.language));
        let schema = constants.schema(&sweep.schema());
        let lines = (VALUES_READ / schema.fields().len().max(1)).clamp(1, PART);
        let mut answers = Answers::begin(BufWriter::with_capacity(1 << 18, file), format, schema).map_err(failed)?;
        for index in 0..rows.div_ceil(self.rows as u64) {
            let part = self.parts.part(index).map_err(|trouble| self.failed(trouble))?;
            let mut batches = Batches::open(part, 0, lines, self.language).map_err(unread)?;
            while let Some(batch) = batches.next(self.language).map_err(unread)? {
                sweep_io::count(&batch, tally);
                answers.add(&constants.in_each_row(&batch).map_err(failed)?).map_err(failed)?;
            }
        }
        let mut out = answers.end().map_err(failed)?;
        out.flush().map_err(|error| failed(file_trouble(&error, self.language)))
    }

    /// Removes the parts when the output is complete; the next call finds any that could not be removed.
    pub(super) fn remove(self) {
        self.parts.remove();
    }
}
