//! Temporary files that a signal takes with it.
//!
//! Interrupt, terminate and hang-up end the program with what is unfinished removed and the status that a shell gives
//! them: 128 and the number of the signal. Nothing can be done about a kill: the hidden file that it
//! leaves goes with a save in the same folder after a minute.

use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::NamedTempFile;

/// The temporary files of this process that are not renamed yet.
static FILES: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// A save that may be interrupted.
pub(crate) struct Unfinished;

impl Unfinished {
    /// Makes a temporary file and notes it, without a signal between.
    pub(crate) fn made(&self, make: impl FnOnce() -> std::io::Result<NamedTempFile>) -> std::io::Result<NamedTempFile> {
        let mut files = self.hold();
        let file = make()?;
        files.push(file.path().to_owned());
        Ok(file)
    }

    /// Keeps signals waiting.
    pub(crate) fn hold(&self) -> MutexGuard<'static, Vec<PathBuf>> {
        FILES.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        self.hold().clear();
    }
}

/// Ends the program with a status, and removes what is unfinished. A save that is being renamed is completed first.
pub fn end(status: i32) -> ! {
    let files = FILES.lock().unwrap_or_else(PoisonError::into_inner);
    files.iter().for_each(|path| drop(std::fs::remove_file(path)));
    std::process::exit(status);
}

/// From now on interrupt, terminate and hang-up end the program, and what is unfinished goes with it; once in its life. Who has
/// a better end of his own for them does without.
#[cfg(unix)]
pub fn end_on_signals() {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    use std::sync::Once;

    static WATCHED: Once = Once::new();
    WATCHED.call_once(|| {
        // Without a watch a signal ends the program as ever.
        let Ok(mut signals) = Signals::new([SIGHUP, SIGINT, SIGTERM]) else { return };
        drop(std::thread::spawn(move || {
            if let Some(signal) = signals.forever().next() {
                end(128 + signal);
            }
        }));
    });
}

/// From now on a file that grows beyond the limit of the process (`ulimit -f`) is refused as an error of the write. Without this
/// the signal for it ends the program, and what is unfinished stays.
#[cfg(unix)]
pub fn refuse_large_files() {
    use std::sync::atomic::AtomicBool;
    use std::sync::{Arc, Once};

    static REFUSED: Once = Once::new();
    // Where no handler can be set the signal ends the program as before.
    REFUSED.call_once(|| {
        drop(signal_hook::flag::register(signal_hook::consts::SIGXFSZ, Arc::new(AtomicBool::new(false))))
    });
}
