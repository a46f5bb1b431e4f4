//! How much of everything one who asks may take.

use std::time::Duration;

/// The bounds that requests are held to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Connections at the same time; further ones wait until one ends.
    pub connections: usize,
    /// Bytes of the line and the headers of a request.
    pub head_bytes: usize,
    /// Number of headers.
    pub headers: usize,
    /// Time for the headers, and until the next request comes.
    pub head_time: Duration,
    /// Bytes of a body.
    pub body_bytes: usize,
    /// Bytes of a recording that is brought.
    pub recording_bytes: usize,
    /// Bytes of all bodies together that are read or answered.
    pub bodies_bytes: usize,
    /// Time for a body.
    pub body_time: Duration,
    /// Time for an answer, the wait for its turn included.
    pub answer_time: Duration,
    /// Short answers that are computed at the same time; beside them one fewer of the long ones, but at least one.
    pub computed: usize,
    /// A work that takes longer is a long one: it leaves its turn to the short ones.
    pub short_time: Duration,
    /// Questions that wait for their turn.
    pub waiting: usize,
    /// Time for what has begun, once the server is to end, and once more until cancelled works have ended.
    pub end_time: Duration,
}

/// Largest number of short answers and of long ones that are computed at the same time, independent of the number of cores: each may need
/// the memory that is allowed for recordings.
const COMPUTED_MOST: usize = 8;

impl Limits {
    /// Long answers that are computed at the same time.
    pub(crate) const fn long(&self) -> usize {
        if self.computed > 2 { self.computed - 1 } else { 1 }
    }
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            connections: 512,
            head_bytes: 32 << 10,
            headers: 64,
            head_time: Duration::from_secs(10),
            // Two project files as JSON, in which a line feed takes two bytes.
            body_bytes: 4 << 20,
            // A million samples of three quantities, as loggers write them.
            recording_bytes: 64 << 20,
            bodies_bytes: 128 << 20,
            body_time: Duration::from_secs(20),
            answer_time: Duration::from_secs(60),
            computed: std::thread::available_parallelism().map_or(1, usize::from).min(COMPUTED_MOST),
            short_time: Duration::from_secs(1),
            waiting: 256,
            end_time: Duration::from_millis(400),
        }
    }
}
