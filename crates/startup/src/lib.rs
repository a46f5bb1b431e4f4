//! State of the process that is observable only before the Rust runtime starts.
//!
//! The runtime opens `/dev/null` for reading and writing in place of a standard stream closed by the caller. Callers
//! that discard the output open it in the same way (`subprocess.DEVNULL` of Python), so the two cases cannot be
//! distinguished afterwards.

#[cfg(unix)]
mod unix {
    use std::sync::atomic::{AtomicBool, Ordering};

    static IS_CLOSED: AtomicBool = AtomicBool::new(false);

    ctor::declarative::ctor! {
        // Sound before `main`: one system call and one store, no memory is requested and nothing of the runtime is used.
        #[ctor(unsafe)]
        fn look() {
            IS_CLOSED.store(rustix::io::fcntl_getfd(rustix::stdio::stdout()).is_err(), Ordering::Relaxed);
        }
    }

    pub(super) fn is_closed() -> bool {
        IS_CLOSED.load(Ordering::Relaxed)
    }
}

/// Checks that the program was started with an open standard output.
///
/// # Errors
/// `EBADF` if the caller closed it. On systems other than Unix the standard library reports this when it writes.
pub fn stdout_is_open() -> std::io::Result<()> {
    #[cfg(unix)]
    if unix::is_closed() {
        return Err(rustix::io::Errno::BADF.into());
    }
    Ok(())
}
