//! Limits of the resources that a client can use.

use std::time::Duration;

/// Limits of requests.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RequestLimits {
    /// Number of simultaneous connections; further ones wait until one ends.
    pub connections: usize,
    /// Bytes of the request line and the headers.
    pub head_bytes: usize,
    /// Number of headers.
    pub headers: usize,
    /// Time limit of the headers, and of the wait for the next request.
    pub head_time: Duration,
    /// Bytes of a body.
    pub body_bytes: usize,
    /// Bytes of a recording with the project that is to use it.
    pub recording_bytes: usize,
    /// Bytes of all bodies that are being read or answered.
    pub bodies_bytes: usize,
    /// Time limit of a body.
    pub body_time: Duration,
    /// Time limit of an answer, including the wait for its turn.
    pub answer_time: Duration,
    /// Number of short answers that are computed simultaneously; additionally one fewer of the long ones, but at least
    /// one.
    pub computed: usize,
    /// Duration above which a work is a long one and leaves its turn to the short ones.
    pub short_time: Duration,
    /// Number of questions that wait for their turn.
    pub waiting: usize,
    /// Time limit of running requests when the server is to end, and again until cancelled works have ended.
    pub end_time: Duration,
}

/// Largest number of short answers and of long ones that are computed simultaneously, independent of the number of
/// cores: each may need the memory that is allowed for recordings.
const COMPUTED_MOST: usize = 8;

impl RequestLimits {
    /// Returns the number of long answers that are computed simultaneously.
    pub(crate) const fn long(&self) -> usize {
        if self.computed > 2 { self.computed - 1 } else { 1 }
    }
}

impl Default for RequestLimits {
    fn default() -> Self {
        Self {
            connections: 512,
            head_bytes: 32 << 10,
            headers: 64,
            head_time: Duration::from_secs(10),
            // Two project files as JSON, in which a line feed takes two bytes.
            body_bytes: 4 << 20,
            // With the project, whose text stands before it.
            recording_bytes: page::RECORDING_BYTES_MAX + (4 << 20),
            bodies_bytes: 136 << 20,
            body_time: Duration::from_secs(20),
            answer_time: Duration::from_secs(60),
            computed: std::thread::available_parallelism().map_or(1, usize::from).min(COMPUTED_MOST),
            short_time: Duration::from_secs(1),
            waiting: 256,
            end_time: Duration::from_millis(400),
        }
    }
}
