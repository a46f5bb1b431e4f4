//! What a program can know about itself only before the runtime of Rust starts.
//!
//! The runtime opens `/dev/null` in place of a standard stream that the caller closed, for reading and writing. Callers that throw
//! an answer away open it in the same way (`subprocess.DEVNULL` of Python), so afterwards the two look alike.

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

/// Whether the program was started with a standard output that takes what is written to it.
///
/// # Errors
/// `EBADF` where the caller closed it. On other systems than Unix the standard library reports it by itself when it writes.
pub fn stdout_is_open() -> std::io::Result<()> {
    #[cfg(unix)]
    if unix::is_closed() {
        return Err(rustix::io::Errno::BADF.into());
    }
    Ok(())
}
