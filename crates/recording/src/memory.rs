//! Memory of the recordings of a project, and how a limit is held.

use crate::faults::Fault;
use crate::limits::{Limit, MEMORY_USUAL};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Memory budget of recordings, and the part in use.
#[derive(Clone, Debug)]
pub struct Memory {
    most: u64,
    taken: u64,
    /// Flag by which the caller cancels reading.
    cancelled: Option<Arc<AtomicBool>>,
}

impl Default for Memory {
    fn default() -> Self {
        Self::new(MEMORY_USUAL)
    }
}

impl Memory {
    /// Creates a budget of `most` bytes, none of them in use.
    #[must_use]
    pub const fn new(most: u64) -> Self {
        Self { most, taken: 0, cancelled: None }
    }

    /// Adds a flag by which the caller cancels reading.
    #[must_use]
    pub fn until(self, cancelled: Option<Arc<AtomicBool>>) -> Self {
        Self { cancelled, ..self }
    }

    /// Returns an error if the caller cancelled.
    ///
    /// # Errors
    /// [`Fault::Stopped`].
    pub fn go_on(&self) -> Result<(), Fault> {
        let is_over = self.cancelled.as_ref().is_some_and(|flag| flag.load(Ordering::Relaxed));
        if is_over { Err(Fault::Stopped) } else { Ok(()) }
    }

    /// Returns the number of bytes left.
    #[must_use]
    pub const fn left(&self) -> u64 {
        self.most.saturating_sub(self.taken)
    }

    /// Reserves a number of bytes.
    ///
    /// # Errors
    /// [`Fault::Beyond`] if fewer bytes are left; nothing is reserved then.
    pub fn take(&mut self, bytes: u64) -> Result<(), Fault> {
        let taken = self.taken.saturating_add(bytes);
        Limit::Memory.hold(taken, self.most)?;
        self.taken = taken;
        Ok(())
    }

    /// Returns a number of reserved bytes.
    pub const fn give_back(&mut self, bytes: u64) {
        self.taken = self.taken.saturating_sub(bytes);
    }
}

impl Limit {
    /// Returns an error if `found` exceeds the limit `most`.
    pub(crate) fn hold(self, found: u64, most: u64) -> Result<(), Fault> {
        if found <= most { Ok(()) } else { Err(Fault::Beyond { limit: self, found, most }) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_taken_up_to_its_bound_and_given_back() {
        let mut memory = Memory::new(100);
        assert_eq!(memory.take(60), Ok(()));
        assert_eq!(memory.take(41), Err(Fault::Beyond { limit: Limit::Memory, found: 101, most: 100 }));
        assert_eq!(memory.take(u64::MAX), Err(Fault::Beyond { limit: Limit::Memory, found: u64::MAX, most: 100 }));
        assert_eq!((memory.take(40), memory.left()), (Ok(()), 0));
        memory.give_back(30);
        assert_eq!(memory.left(), 30);
    }
}
