//! Connections without a running request.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};
use tokio::sync::Notify;

/// Connections without a running request: idle ones, and those with an incomplete request. When every place is taken, a
/// new connection replaces the one that has waited longest, so that half-sent requests do not exclude others.
/// Connections that never sent the token are replaced first.
#[derive(Debug, Default)]
pub(crate) struct Idle(Mutex<Waiting>);

/// Idle connections by [`IdleKey`]: at most one entry for each connection.
#[derive(Debug, Default)]
struct Waiting {
    last: u64,
    all: BTreeMap<IdleKey, Arc<Notify>>,
}

/// `true` if the connection has sent the token, and its number in the order of becoming idle.
type IdleKey = (bool, u64);

impl Idle {
    /// Closes the connection that has waited longest.
    pub(crate) fn closes_longest(&self) {
        let idle = &mut *self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, close)) = idle.all.pop_first() {
            close.notify_one();
        }
    }
}

/// A connection in the list of idle ones.
#[derive(Debug)]
pub(crate) struct IdleSlot {
    all: Arc<Idle>,
    close: Arc<Notify>,
    /// Key while it is idle, and `true` if it has sent the token.
    state: Mutex<(Option<IdleKey>, bool)>,
}

impl IdleSlot {
    pub(crate) fn new(all: &Arc<Idle>) -> Self {
        let place = Self { all: Arc::clone(all), close: Arc::default(), state: Mutex::default() };
        place.idle();
        place
    }

    /// Marks the connection as idle. A rejected request never was busy: the connection keeps its place among the
    /// waiting ones, so that a client with rejected requests is not treated as younger than a silent one.
    pub(crate) fn idle(&self) {
        let (place, is_known) = &mut *self.state.lock().unwrap_or_else(PoisonError::into_inner);
        if place.is_some() {
            return;
        }
        let idle = &mut *self.all.0.lock().unwrap_or_else(PoisonError::into_inner);
        idle.last += 1;
        let key = (*is_known, idle.last);
        let _ = idle.all.insert(key, Arc::clone(&self.close));
        *place = Some(key);
    }

    /// Marks the connection as busy: a request is complete, and its answer is not interrupted. It belongs to the user if the request
    /// `has_token`; a stranger who reads a file that is open to all remains one.
    pub(crate) fn busy(&self, has_token: bool) {
        let (place, is_known) = &mut *self.state.lock().unwrap_or_else(PoisonError::into_inner);
        *is_known |= has_token;
        if let Some(key) = place.take() {
            let _ = self.all.0.lock().unwrap_or_else(PoisonError::into_inner).all.remove(&key);
        }
    }

    /// Completes when a new connection replaces this one.
    pub(crate) async fn closed(&self) {
        loop {
            self.close.notified().await;
            // A request may have become complete meanwhile.
            if self.state.lock().unwrap_or_else(PoisonError::into_inner).0.is_some() {
                return;
            }
        }
    }
}

impl Drop for IdleSlot {
    fn drop(&mut self) {
        self.busy(false);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An answer that never was busy leaves nothing behind.
    #[test]
    fn a_connection_has_one_place_among_the_idle_ones() {
        let all = Arc::<Idle>::default();
        let length = || all.0.lock().unwrap().all.len();
        let (stranger, user) = (IdleSlot::new(&all), IdleSlot::new(&all));
        for _ in 0..1000 {
            stranger.busy(false);
            stranger.idle();
            user.busy(true);
            user.idle();
        }
        assert_eq!(length(), 2);
        user.busy(true);
        assert_eq!(length(), 1);
        user.idle();
        // The stranger goes first, however long the user is idle.
        let third = IdleSlot::new(&all);
        all.closes_longest();
        all.closes_longest();
        let left: Vec<bool> = all.0.lock().unwrap().all.keys().map(|(is_known, _)| *is_known).collect();
        assert_eq!(left, [true]);
        drop((stranger, user, third));
        assert_eq!(length(), 0);
    }
}
