//! Temporary files that are removed when a signal ends the program.
//!
//! Interrupt, terminate and hang-up end the program after removing unfinished files, with the status that a shell
//! assigns: 128 plus the number of the signal. A kill cannot be handled: the hidden file that it leaves is removed by a
//! save in the same folder after a minute.

#[cfg(unix)]
use std::io::IsTerminal as _;
use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::NamedTempFile;

/// Temporary files of this process that are not renamed yet.
static FILES: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Message that a signal prints before it ends the program.
static LAST_WORDS: Mutex<Option<Box<dyn Fn() -> String + Send>>> = Mutex::new(None);

/// Guard of a message that a signal prints before it ends the program.
pub struct LastWords;

impl LastWords {
    /// Sets the message, such as the way to continue interrupted work.
    #[must_use]
    pub fn set(message: impl Fn() -> String + Send + 'static) -> Self {
        *LAST_WORDS.lock().unwrap_or_else(PoisonError::into_inner) = Some(Box::new(message));
        Self
    }
}

impl Drop for LastWords {
    fn drop(&mut self) {
        *LAST_WORDS.lock().unwrap_or_else(PoisonError::into_inner) = None;
    }
}

/// Prints the message of [`LastWords`], if there is one, below a line that shows the progress.
#[cfg(unix)]
#[allow(clippy::print_stderr, reason = "the program ends with it")]
fn print_last_words() {
    if let Some(message) = &*LAST_WORDS.lock().unwrap_or_else(PoisonError::into_inner) {
        let clear = if std::io::stderr().is_terminal() { "\r\u{1b}[K" } else { "" };
        eprintln!("{clear}{}", message());
    }
}

/// A save in progress.
pub(crate) struct Unfinished;

impl Unfinished {
    /// Creates a temporary file and records it, without a signal in between.
    pub(crate) fn made(&self, make: impl FnOnce() -> std::io::Result<NamedTempFile>) -> std::io::Result<NamedTempFile> {
        let mut files = self.hold();
        let file = make()?;
        files.push(file.path().to_owned());
        Ok(file)
    }

    /// Delays the handling of signals.
    pub(crate) fn hold(&self) -> MutexGuard<'static, Vec<PathBuf>> {
        FILES.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        self.hold().clear();
    }
}

/// Ends the program with a status and removes unfinished files. A rename in progress is completed first.
pub fn end(status: i32) -> ! {
    let files = FILES.lock().unwrap_or_else(PoisonError::into_inner);
    files.iter().for_each(|path| drop(std::fs::remove_file(path)));
    std::process::exit(status);
}

/// Installs handlers by which interrupt, terminate and hang-up end the program and remove unfinished files. Effective
/// once per process; callers with handlers of their own must not use this function.
#[cfg(unix)]
pub fn end_on_signals() {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    use std::sync::Once;

    static WATCHED: Once = Once::new();
    WATCHED.call_once(|| {
        // Without a handler a signal ends the program as before.
        let Ok(mut signals) = Signals::new([SIGHUP, SIGINT, SIGTERM]) else { return };
        drop(std::thread::spawn(move || {
            if let Some(signal) = signals.forever().next() {
                print_last_words();
                end(128 + signal);
            }
        }));
    });
}

/// Installs a handler by which a file that exceeds the limit of the process (`ulimit -f`) is refused as a write error.
/// Without it, the signal ends the program and unfinished files stay.
#[cfg(unix)]
pub fn refuse_large_files() {
    use std::sync::atomic::AtomicBool;
    use std::sync::{Arc, Once};

    static REFUSED: Once = Once::new();
    // If no handler can be installed the signal ends the program as before.
    REFUSED.call_once(|| {
        drop(signal_hook::flag::register(signal_hook::consts::SIGXFSZ, Arc::new(AtomicBool::new(false))))
    });
}
