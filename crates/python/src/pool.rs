//! The threads of a process in which Python runs, which may be the child of a fork.
//!
//! A fork takes the calling thread along and no other one: a pool of threads made before it has none in the child, and work given to
//! it waits for ever. So each process makes a pool of its own. What another thread of the parent held at the moment of a fork stays
//! held in the child; there a call is refused at once.

use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

/// The pool of this process.
static POOL: Mutex<Option<Arc<ThreadPool>>> = Mutex::new(None);

/// Calls that are at work.
static AT_WORK: AtomicUsize = AtomicUsize::new(0);

/// Whether this process was forked while a call was at work.
static IS_BROKEN: AtomicBool = AtomicBool::new(false);

/// This process was forked while a call was at work in another thread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ForkedAtWork;

/// Notes that this process is the child of a fork, before anything else runs in it.
pub fn forked() {
    if AT_WORK.swap(0, Ordering::SeqCst) > 0 {
        IS_BROKEN.store(true, Ordering::SeqCst);
    } else if let Some(pool) = lock().take() {
        // Its threads do not exist here; to wait for their end would be for ever.
        std::mem::forget(pool);
    }
}

/// Returns the result of a piece of work in the pool of this process.
///
/// # Errors
/// [`ForkedAtWork`].
pub fn within<T: Send>(work: impl FnOnce() -> T + Send) -> Result<T, ForkedAtWork> {
    if IS_BROKEN.load(Ordering::SeqCst) {
        return Err(ForkedAtWork);
    }
    let _at_work = AtWork::begin();
    let pool = {
        let mut pool = lock();
        match &*pool {
            Some(pool) => Some(Arc::clone(pool)),
            None => {
                *pool = ThreadPoolBuilder::new().build().ok().map(Arc::new);
                pool.clone()
            }
        }
    };
    // Without threads of its own the work is done in those that rayon has.
    Ok(match pool {
        Some(pool) => pool.install(work),
        None => work(),
    })
}

fn lock() -> std::sync::MutexGuard<'static, Option<Arc<ThreadPool>>> {
    POOL.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A call as long as it is at work.
struct AtWork;

impl AtWork {
    fn begin() -> Self {
        AT_WORK.fetch_add(1, Ordering::SeqCst);
        Self
    }
}

impl Drop for AtWork {
    fn drop(&mut self) {
        // A child counts anew.
        let less = |count: usize| Some(count.saturating_sub(1));
        let _ = AT_WORK.fetch_update(Ordering::SeqCst, Ordering::SeqCst, less);
    }
}
