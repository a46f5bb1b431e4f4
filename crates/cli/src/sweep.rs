//! `sweep`: a table of axes, judged part by part. Finished parts are kept beside the answers until these are whole, so that an
//! interrupted call continues.

use crate::answer::{Answer, written};
use crate::call::Call;
use crate::fault::path_text;
use quantities::{Language, format_number};
use questions::list::{Asked, Unanswered, sweep};
use questions::sweep::{SweepSummary, Tally};
use std::fmt::Write as _;
use std::fs::File;
use std::io::{BufWriter, Read as _, Write as _};
use std::path::{Path, PathBuf};
use sweep_io::{Answers, Batches, Format, Head, Sweep, Unread};
use words::{file_trouble, sweeps};

/// Rows of a part.
const PART: usize = 1 << 14;

/// The file that says to what the parts belong.
const MARK: &str = "sweep";

/// A table in a file.
struct Table<'c> {
    path: &'c Path,
    format: Format,
    language: Language,
}

/// `antrieb sweep PROJECT --table FILE --out FILE`
pub(crate) fn sweep(call: &Call<'_>, asked: &Asked<'_>) -> Result<Answer, Unanswered> {
    let language = call.language;
    let args = sweep::Args::read(&asked.given)?;
    let path = PathBuf::from(args.table.clone().unwrap_or_default());
    let (Some(out), Some(beside)) = (call.path("out"), call.beside()) else { return Ok(Answer::none()) };
    let source = asked.source()?;
    let text = source.text(language)?;
    let projects = source.projects(asked.patience, language);
    let mut inputs = call.inputs(projects.as_deref().unwrap_or_default());
    inputs.push(path.clone());
    let desk = call.desk(&inputs);
    let ending = |option| Unanswered::option(option, (sweeps::ending_of_a_table(language).to_owned(), None));
    let place = Format::of(out).ok_or_else(|| ending("out"));
    let place = place.and_then(|answers| desk.ready(&[out]).map(|()| answers));
    let opened = Format::of(&path).ok_or_else(|| ending("table")).and_then(|format| {
        let table = Table { path: &path, format, language };
        table.open(0).map(|batches| (table, batches))
    });
    let ready = match opened {
        Ok((table, batches)) => {
            let head = Head::read(text, projects, &batches.schema(), args.options(language));
            table.checked(batches, head, beside).map(|(sweep, rows)| (table, sweep, rows))
        }
        Err(unread) => Err(Unanswered::together(projects.err().into_iter().chain([unread]).collect())),
    };
    let (table, sweep, rows, answers) = match (ready, place) {
        (Ok((table, sweep, rows)), Ok(answers)) => (table, sweep, rows, answers),
        (ready, place) => return Err(Unanswered::together(ready.err().into_iter().chain(place.err()).collect())),
    };
    let parts = Parts::of(&table, out, text, &format!("{args:?} {}", language.id()))?;
    let mut talk = format!("{}\n", sweeps::keys(&sweep.keys().collect::<Vec<_>>().join(", "), language));
    talk += &parts.remark(rows);
    parts.judged(&table, &sweep, rows, asked)?;
    let mut tally = Tally::default();
    desk.save_by(out, |file| parts.together(answers, &sweep, rows, file, &mut tally))?;
    parts.remove();
    let summary = tally.summary(Some(path_text(out)), language);
    let data = if call.as_json { written(&summary) } else { shown(&summary, language) };
    Ok(Answer { talk, ..Answer::data(data) }.fits(summary.fitting > 0))
}

impl Table<'_> {
    /// A sentence about the table.
    fn refused(&self, why: &str) -> Unanswered {
        Unanswered::message(sweeps::unreadable(&path_text(self.path), &why, self.language))
    }

    fn file(&self) -> Result<File, Unanswered> {
        File::open(self.path).map_err(|error| self.refused(&file_trouble(&error, self.language)))
    }

    /// The table from a row on.
    fn open(&self, skipped: u64) -> Result<Batches, Unanswered> {
        let opened = Batches::open(self.file()?, self.format, skipped, PART, self.language);
        opened.map_err(|why| self.refused(&why.text(self.language)))
    }

    /// The sweep over the table and its rows, all of whose cells can be read.
    fn checked(&self, mut batches: Batches, mut head: Head, beside: disk::Beside) -> Result<(Sweep, u64), Unanswered> {
        let mut rows = 0;
        let unread = loop {
            match batches.next(self.language) {
                Ok(Some(batch)) => {
                    head.check(&batch, rows);
                    rows += batch.num_rows() as u64;
                }
                Ok(None) => {
                    head.refuse_empty(rows);
                    break None;
                }
                Err(Unread::Line(fault)) => {
                    head.refuse_line(fault, rows);
                    rows += 1;
                }
                Err(Unread::Table(why)) => break Some(self.refused(&why)),
            }
        };
        match (head.ready(&path_text(self.path), Box::new(beside)), unread) {
            (Ok(sweep), None) => Ok((sweep, rows)),
            (ready, unread) => Err(Unanswered::together(ready.err().into_iter().chain(unread).collect())),
        }
    }
}

/// The parts of the answers: a folder beside them.
struct Parts {
    folder: PathBuf,
    /// How many were there, and whether others had to go.
    kept: usize,
    begun_anew: bool,
    language: Language,
}

impl Parts {
    /// Those of the same project, table and request are kept, others removed.
    fn of(table: &Table<'_>, out: &Path, project: &str, request: &str) -> Result<Self, Unanswered> {
        let name = out.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let folder = out.with_file_name(format!("{name}.parts"));
        let language = table.language;
        let failed = |error: &std::io::Error| {
            Unanswered::message(format!("{}: {}", path_text(&folder), file_trouble(error, language)))
        };
        let mut hasher = blake3::Hasher::new();
        for text in [env!("CARGO_PKG_VERSION"), project, request, &name] {
            hasher.update(&(text.len() as u64).to_le_bytes()).update(text.as_bytes());
        }
        let mut file = table.file()?;
        let mut buffer = vec![0; 1 << 18];
        loop {
            let read = file.read(&mut buffer).map_err(|error| table.refused(&file_trouble(&error, language)))?;
            if read == 0 {
                break;
            }
            hasher.update(buffer.get(..read).unwrap_or_default());
        }
        let mark = format!("{}\n", hasher.finalize().to_hex());
        let path = folder.join(MARK);
        let known = std::fs::read_to_string(&path).ok();
        let is_same = known.as_deref() == Some(mark.as_str());
        let begun_anew = known.is_some() && !is_same;
        if !is_same {
            // Without its mark a folder of this name is not ours: only what we wrote is removed.
            if known.is_some() {
                std::fs::remove_dir_all(&folder).map_err(|error| failed(&error))?;
            }
            std::fs::create_dir_all(&folder).map_err(|error| failed(&error))?;
            put(&folder, MARK, mark.as_bytes()).map_err(|error| failed(&error))?;
        }
        let mut parts = Self { folder, kept: 0, begun_anew, language };
        parts.kept = (0..).take_while(|index| parts.path(*index).is_file()).count();
        Ok(parts)
    }

    fn path(&self, index: u64) -> PathBuf {
        self.folder.join(name(index))
    }

    /// What became of parts that were there; `rows` are those of the table.
    fn remark(&self, rows: u64) -> String {
        if self.begun_anew {
            return format!("{}\n", sweeps::begun_anew(self.language));
        }
        let kept = rows.min((self.kept * PART) as u64);
        if self.kept == 0 { String::new() } else { format!("{}\n", sweeps::resumed(self.kept, &kept, self.language)) }
    }

    fn failed(&self, why: &str) -> Unanswered {
        Unanswered::message(format!("{}: {why}", path_text(&self.folder)))
    }

    /// Judges what is not judged yet, a part at a time.
    fn judged(&self, table: &Table<'_>, sweep: &Sweep, rows: u64, asked: &Asked<'_>) -> Result<(), Unanswered> {
        let mut first = self.kept as u64 * PART as u64;
        if first >= rows {
            return Ok(());
        }
        asked.patience.expect_steps(usize::try_from(rows - first).unwrap_or(usize::MAX));
        let mut index = self.kept as u64;
        let mut batches = table.open(first)?;
        while first < rows {
            let batch = batches.next(self.language).map_err(|why| table.refused(&why.text(self.language)))?;
            let Some(batch) = batch else { break };
            let answers = sweep.batch(&batch, first, asked.patience).map_err(|why| self.kept_in(why))?;
            let bytes = sweep_io::part(&answers).map_err(|why| self.failed(&why))?;
            put(&self.folder, &name(index), &bytes)
                .map_err(|error| self.failed(&file_trouble(&error, self.language)))?;
            first += batch.num_rows() as u64;
            index += 1;
        }
        Ok(())
    }

    /// Why it ended, and that what is finished stays.
    fn kept_in(&self, why: Unanswered) -> Unanswered {
        let kept = Unanswered::message(sweeps::kept(&path_text(&self.folder), self.language));
        if why.is_stopped() { Unanswered::together(vec![why, kept]) } else { why }
    }

    /// All parts as one file, counted.
    fn together(
        &self,
        format: Format,
        sweep: &Sweep,
        rows: u64,
        file: &mut File,
        tally: &mut Tally,
    ) -> Result<(), Unanswered> {
        let failed = |why: String| self.failed(&why);
        let unread = |why: Unread| self.failed(&why.text(self.language));
        let mut answers =
            Answers::begin(BufWriter::with_capacity(1 << 18, file), format, sweep.schema()).map_err(failed)?;
        for index in 0..rows.div_ceil(PART as u64) {
            let part = File::open(self.path(index)).map_err(|error| failed(file_trouble(&error, self.language)))?;
            let mut batches = Batches::open(part, Format::Parquet, 0, PART, self.language).map_err(unread)?;
            while let Some(batch) = batches.next(self.language).map_err(unread)? {
                sweep_io::count(&batch, tally);
                answers.add(&batch).map_err(failed)?;
            }
        }
        let mut out = answers.end().map_err(failed)?;
        out.flush().map_err(|error| failed(file_trouble(&error, self.language)))
    }

    /// Once the answers are whole.
    fn remove(&self) {
        // What is left over is found by the next call.
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

fn name(index: u64) -> String {
    format!("part-{index:08}.parquet")
}

/// Writes a file of a folder of ours whole: under another name first.
fn put(folder: &Path, name: &str, bytes: &[u8]) -> std::io::Result<()> {
    let unfinished = folder.join(format!("{name}.unfinished"));
    let mut file = File::create(&unfinished)?;
    file.write_all(bytes)?;
    file.sync_data()?;
    std::fs::rename(unfinished, folder.join(name))
}

/// The summary on the terminal.
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
