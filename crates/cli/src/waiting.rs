//! Time limit of an answer, and progress on the terminal when it takes longer than a second.

use indicatif::{ProgressBar, ProgressStyle};
use quantities::{Language, Measure as _, Time, format_number};
use questions::Progress;
use questions::list::Unanswered;
use std::io::{IsTerminal, Write as _};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};
use words::{sweeps, terminal};

/// Time after which the progress is shown.
const QUIET: Duration = Duration::from_secs(1);

/// Time after the deadline at which work that does not poll is ended from outside: a library that reads, or a pass over
/// a long recording.
const GRACE: Duration = Duration::from_millis(500);

/// Refresh interval of the progress.
const TICK: Duration = Duration::from_millis(100);

static PATIENCE: OnceLock<(Progress, Option<Duration>)> = OnceLock::new();

/// Parses a time limit such as `10 s`.
///
/// # Errors
/// A text that is no time.
pub fn deadline_of(text: &str, language: Language) -> Result<Duration, Unanswered> {
    let time = questions::read_quantity::<Time>(text, language);
    let time = time.map_err(|fault| Unanswered::option("deadline", fault))?;
    if time.si().is_nan() || time.si() < 0.0 {
        let why = terminal::deadline_not_negative(&text, language);
        return Err(Unanswered::option("deadline", (why, None)));
    }
    // A day stands for all longer limits.
    Ok(Duration::from_secs_f64(time.si().clamp(0.0, 86_400.0)))
}

fn caller() -> &'static (Progress, Option<Duration>) {
    PATIENCE.get_or_init(|| (Progress::endless(), None))
}

/// Returns progress and cancellation of the caller of this process.
pub(crate) fn progress() -> &'static Progress {
    &caller().0
}

/// Returns the deadline of the caller \[s\].
pub(crate) fn waited_s() -> Option<f64> {
    caller().1.map(|most| most.as_secs_f64())
}

/// Guard of a running work; while it lives, a terminal shows the progress after a second.
pub(crate) struct Waiting {
    done: Vec<(Sender<()>, JoinHandle<()>)>,
}

impl Waiting {
    /// Starts the clock with a time limit of `most`; `None` for no limit. Work that does not end by itself is ended by
    /// `late`.
    pub(crate) fn begin(language: Language, most: Option<Duration>, late: impl FnOnce() + Send + 'static) -> Self {
        let (progress, most) = PATIENCE.get_or_init(|| {
            let progress = if most.is_some() { Progress::limited() } else { Progress::endless() };
            (progress, most)
        });
        let mut waiting = Self { done: Vec::new() };
        if let Some(most) = *most {
            waiting.spawn(move |is_done| {
                if is_done.recv_timeout(most) == Err(RecvTimeoutError::Timeout) {
                    progress.cancel();
                    if is_done.recv_timeout(GRACE) == Err(RecvTimeoutError::Timeout) {
                        late();
                    }
                }
            });
        }
        if std::io::stderr().is_terminal() {
            waiting.spawn(move |is_done| show(&is_done, progress, language));
        } else {
            waiting.spawn(move |is_done| report(&is_done, progress, language));
        }
        waiting
    }

    fn spawn(&mut self, work: impl FnOnce(Receiver<()>) + Send + 'static) {
        let (done, is_done) = channel::<()>();
        self.done.push((done, std::thread::spawn(move || work(is_done))));
    }
}

/// Time after which the rows of a sweep are reported where there is no terminal, and the interval of further reports.
const FIRST_REPORT: Duration = Duration::from_secs(10);
const REPORTS: Duration = Duration::from_secs(60);

/// Writes the rows of a sweep as lines, for a log.
fn report(is_done: &Receiver<()>, progress: &Progress, language: Language) {
    let begun = Instant::now();
    let mut interval = FIRST_REPORT;
    while is_done.recv_timeout(interval) == Err(RecvTimeoutError::Timeout) {
        interval = REPORTS;
        if let Some(text) = rows_text(progress, begun, language) {
            let _ = writeln!(std::io::stderr(), "antrieb: {text}");
        }
    }
}

/// Returns the rows of a sweep that are read or judged; `None` for other work.
fn rows_text(progress: &Progress, begun: Instant, language: Language) -> Option<String> {
    let judged = ROWS.get().and_then(|kept| Some((kept, progress.progress().0 as u64, progress.progress().1? as u64)));
    if let Some((kept, done, all)) = judged {
        let rate = per_second(done, begun.elapsed().as_secs_f64());
        return Some(rows_at(kept + done, kept + all, rate, language));
    }
    let read = ROWS_READ.load(Ordering::Relaxed);
    (read > 0).then(|| sweeps::rows_read(&read, language))
}

/// Number of rows of the table of a sweep that are read.
static ROWS_READ: AtomicU64 = AtomicU64::new(0);

/// Shows the number of rows read so far.
pub(crate) fn count_read(rows: u64) {
    ROWS_READ.store(rows, Ordering::Relaxed);
}

/// Shows the progress until the work is done.
fn show(is_done: &Receiver<()>, progress: &Progress, language: Language) {
    if is_done.recv_timeout(QUIET) != Err(RecvTimeoutError::Timeout) {
        return;
    }
    let bar = ProgressBar::new_spinner();
    if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} {elapsed}") {
        bar.set_style(style);
    }
    let mut begun: Option<(Instant, usize)> = None;
    while is_done.recv_timeout(TICK) == Err(RecvTimeoutError::Timeout) {
        let text = match (ROWS.get(), progress.progress()) {
            (Some(kept), (done, Some(all))) => {
                let (begin, first) = *begun.get_or_insert_with(|| (Instant::now(), done));
                let seconds = begin.elapsed().as_secs_f64();
                let rate = per_second(done.saturating_sub(first) as u64, seconds);
                rows_at(kept + done as u64, kept + all as u64, rate, language)
            }
            _ => match ROWS_READ.load(Ordering::Relaxed) {
                0 => message(progress, language),
                read => sweeps::rows_read(&read, language),
            },
        };
        bar.set_message(text);
        bar.tick();
    }
    bar.finish_and_clear();
}

/// Number of rows that a sweep keeps of an earlier call; set if the steps of the work are rows.
static ROWS: OnceLock<u64> = OnceLock::new();

/// Shows the progress as rows from now on; `kept` is the number of rows of an earlier call.
pub(crate) fn count_rows(kept: u64) {
    let _ = ROWS.set(kept);
}

/// Returns the progress of a sweep in one line: completed rows, rows per second and the time left.
#[must_use]
pub fn rows_line(done: u64, all: u64, seconds: f64, language: Language) -> String {
    rows_at(done, all, per_second(done, seconds), language)
}

#[allow(clippy::cast_precision_loss, reason = "counts of rows")]
fn per_second(done: u64, seconds: f64) -> f64 {
    if seconds > 0.0 { done as f64 / seconds } else { 0.0 }
}

fn rows_at(done: u64, all: u64, rate: f64, language: Language) -> String {
    if rate <= 0.0 || !rate.is_finite() {
        return sweeps::rows_begun(&done, &all, language);
    }
    #[allow(clippy::cast_precision_loss, reason = "counts of rows")]
    let left = (all.saturating_sub(done) as f64 / rate).ceil();
    let left = match left {
        left if left < 100.0 => format!("{left:.0} s"),
        left if left < 6000.0 => format!("{:.0} min", (left / 60.0).ceil()),
        left => format!("{} h", format_number(left / 3600.0, 1, language)),
    };
    let rate = format_number(rate, if rate < 10.0 { 1 } else { 0 }, language);
    sweeps::rows_done(&done, &all, &rate, &left, language)
}

/// Returns the text of the progress, with the completed share if it is known.
fn message(progress: &Progress, language: Language) -> String {
    match progress.progress() {
        (done, Some(all)) if done <= all => {
            #[allow(clippy::cast_precision_loss, reason = "at most some millions")]
            let share = format_number(100.0 * done as f64 / all as f64, 0, language);
            terminal::calculating_share(&share, language)
        }
        _ => terminal::calculating(language).to_owned(),
    }
}

impl Drop for Waiting {
    fn drop(&mut self) {
        for (done, thread) in self.done.drain(..) {
            drop(done);
            // The progress line is removed before the answer is written.
            let _ = thread.join();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_states_rows_rate_and_time_left() {
        let line = |done, all, seconds| rows_line(done, all, seconds, Language::En);
        assert_eq!(line(0, 5000, 0.0), "0 of 5000 rows");
        assert_eq!(line(1000, 5000, 2.0), "1000 of 5000 rows · 500 rows/s · 8 s left");
        assert_eq!(line(10, 5000, 4.0), "10 of 5000 rows · 2.5 rows/s · 34 min left");
        assert_eq!(line(1, 50000, 1.0), "1 of 50000 rows · 1.0 rows/s · 13.9 h left");
        assert_eq!(rows_line(1, 50_000, 1.0, Language::De), "1 von 50000 Zeilen · 1,0 Zeilen/s · noch 13,9 h");
    }
}
