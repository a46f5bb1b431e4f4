//! Threads of a process in which Python runs, and which may be the child of a fork.
//!
//! A fork copies the calling thread only: the threads of a pool do not exist in the child, and work given to them would
//! wait forever. So each process creates its own pool. A lock that another thread of the parent holds at the moment of
//! a fork stays locked in the child; calls are then refused at once.

use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Pool of this process.
static POOL: Mutex<Option<Arc<ThreadPool>>> = Mutex::new(None);

/// Number of running calls.
static AT_WORK: AtomicUsize = AtomicUsize::new(0);

/// Set if this process was forked while a call was running.
static IS_BROKEN: AtomicBool = AtomicBool::new(false);

/// Threads of interrupted calls, which end at their next step.
static LEFT: Mutex<Vec<JoinHandle<()>>> = Mutex::new(Vec::new());

/// Longest time that a fork waits for interrupted calls.
const SETTLING: Duration = Duration::from_secs(10);

/// Error of a process that was forked while another thread was running a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ForkedAtWork;

/// Leaves a cancelled call to its thread.
pub fn leave(worker: JoinHandle<()>) {
    let mut left = LEFT.lock().unwrap_or_else(PoisonError::into_inner);
    left.retain(|thread| !thread.is_finished());
    left.push(worker);
}

/// Waits before a fork until interrupted calls have ended: no caller knows of them, and a child could not work beside them.
pub fn settle() {
    let begin = Instant::now();
    let is_over = || {
        let left = LEFT.lock().unwrap_or_else(PoisonError::into_inner);
        left.iter().all(JoinHandle::is_finished)
    };
    while !is_over() && begin.elapsed() < SETTLING {
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Records that this process is the child of a fork, before anything else runs in it.
pub fn forked() {
    if let Ok(mut left) = LEFT.try_lock() {
        // Those threads do not exist here.
        left.drain(..).for_each(std::mem::forget);
    }
    if AT_WORK.swap(0, Ordering::SeqCst) > 0 {
        IS_BROKEN.store(true, Ordering::SeqCst);
    } else if let Some(pool) = lock().take() {
        // Its threads do not exist here; waiting for their end would never return.
        std::mem::forget(pool);
    }
}

/// Runs work in the pool of this process and returns its result.
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
    // Without a pool of its own the work runs in that of rayon.
    Ok(match pool {
        Some(pool) => pool.install(work),
        None => work(),
    })
}

fn lock() -> std::sync::MutexGuard<'static, Option<Arc<ThreadPool>>> {
    POOL.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Guard of a running call.
struct AtWork;

impl AtWork {
    fn begin() -> Self {
        AT_WORK.fetch_add(1, Ordering::SeqCst);
        Self
    }
}

impl Drop for AtWork {
    fn drop(&mut self) {
        // A child counts from zero.
        let less = |count: usize| Some(count.saturating_sub(1));
        let _ = AT_WORK.fetch_update(Ordering::SeqCst, Ordering::SeqCst, less);
    }
}
