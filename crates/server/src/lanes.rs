//! Two lanes for answers, so that a long one does not keep short ones waiting.
//!
//! The duration of a work is unknown in advance, so every work begins as a short one. A work that has not ended after
//! [`RequestLimits::short_time`] is a long one: it leaves its turn to the next short one and continues in the second lane. If
//! that lane is full, the work is cancelled and begun again there when its turn has come, so that it never delays a
//! short one; its partial result is lost.

use crate::limits::RequestLimits;
use page::Reply;
use questions::Progress;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::{Arc, Mutex, PoisonError, Weak};
use std::time::Duration;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::task::JoinHandle;

/// A work that can be begun more than once.
type Work = dyn Fn(&Progress) -> Reply + Send + Sync;

/// The lanes.
pub(crate) struct Lanes {
    short: Arc<Semaphore>,
    long: Arc<Semaphore>,
    short_time: Duration,
    /// Thread pools of finished works, for reuse.
    pools: Arc<Mutex<Vec<ThreadPool>>>,
    /// Running works.
    under_way: Mutex<Vec<Weak<Progress>>>,
}

/// Turn of a work, held until the work ends, after a disconnection of its client too.
type Turn = Arc<Mutex<Option<OwnedSemaphorePermit>>>;

impl Lanes {
    pub(crate) fn new(limits: &RequestLimits) -> Self {
        Self {
            short: Arc::new(Semaphore::new(limits.computed.max(1))),
            long: Arc::new(Semaphore::new(limits.long())),
            short_time: limits.short_time,
            pools: Arc::default(),
            under_way: Mutex::default(),
        }
    }

    /// Returns the largest number of threads that run works.
    pub(crate) fn threads(limits: &RequestLimits) -> usize {
        limits.computed.max(1) + limits.long()
    }

    /// Returns the answer of a work after its turn has come, which `begins` reports; `None` if it failed.
    pub(crate) async fn computed(
        &self,
        work: Arc<Work>,
        progress: Arc<Progress>,
        begins: impl FnOnce(),
    ) -> Option<Reply> {
        let turn = Arc::clone(&self.short).acquire_owned().await.ok()?;
        begins();
        self.note(&progress);
        let (held, mut running) = self.begun(&work, &progress, turn);
        if let Ok(done) = tokio::time::timeout(self.short_time, &mut running).await {
            return done.ok();
        }
        if let Ok(turn) = Arc::clone(&self.long).try_acquire_owned() {
            // This frees the turn among the short ones.
            *held.lock().unwrap_or_else(PoisonError::into_inner) = Some(turn);
            return running.await.ok();
        }
        progress.displace();
        let done = running.await.ok();
        if !progress.resume() {
            return done;
        }
        // The turn among the short ones is freed before the work waits for another.
        drop(held);
        let turn = Arc::clone(&self.long).acquire_owned().await.ok()?;
        let (_held, running) = self.begun(&work, &progress, turn);
        running.await.ok()
    }

    /// Begins a work on its own thread, with a separate thread pool for its parts: in a shared pool, a long work would
    /// keep the parts of a short one waiting.
    fn begun(
        &self,
        work: &Arc<Work>,
        progress: &Arc<Progress>,
        turn: OwnedSemaphorePermit,
    ) -> (Turn, JoinHandle<Reply>) {
        let held: Turn = Arc::new(Mutex::new(Some(turn)));
        let (turn, work, progress, pools) =
            (Arc::clone(&held), Arc::clone(work), Arc::clone(progress), Arc::clone(&self.pools));
        let running = tokio::task::spawn_blocking(move || {
            let _turn = turn;
            let kept = pools.lock().unwrap_or_else(PoisonError::into_inner).pop();
            // Without a pool of its own it uses the global one.
            let Some(pool) = kept.or_else(|| ThreadPoolBuilder::new().build().ok()) else { return work(&progress) };
            let reply = pool.install(|| work(&progress));
            pools.lock().unwrap_or_else(PoisonError::into_inner).push(pool);
            reply
        });
        (held, running)
    }

    fn note(&self, progress: &Arc<Progress>) {
        let mut under_way = self.under_way.lock().unwrap_or_else(PoisonError::into_inner);
        under_way.retain(|work| work.strong_count() > 0);
        under_way.push(Arc::downgrade(progress));
    }

    /// Cancels every running work.
    pub(crate) fn cancel_all(&self) {
        let under_way = self.under_way.lock().unwrap_or_else(PoisonError::into_inner);
        under_way.iter().filter_map(Weak::upgrade).for_each(|progress| progress.cancel());
    }
}
