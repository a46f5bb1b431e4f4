//! Body of a request, read within limits of size and time, and within the memory for all bodies.

use crate::limits::RequestLimits;
use bytes::Bytes;
use http_body_util::BodyExt;
use hyper::body::{Body, Incoming};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Bytes of all bodies that are held at present.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bodies(Arc<AtomicUsize>);

/// A body, counted until it is dropped.
#[derive(Debug)]
pub(crate) struct CountedBody {
    bytes: Vec<u8>,
    all: Bodies,
}

impl CountedBody {
    pub(crate) fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Adds a piece and returns `true` if all bodies stay within `most` bytes.
    fn take(&mut self, piece: &Bytes, most: usize) -> bool {
        let before = self.all.0.fetch_add(piece.len(), Ordering::Relaxed);
        self.bytes.extend_from_slice(piece);
        before + piece.len() <= most
    }
}

impl Drop for CountedBody {
    fn drop(&mut self) {
        self.all.0.fetch_sub(self.bytes.len(), Ordering::Relaxed);
    }
}

/// Reason why a body was not read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NoBody {
    /// The body exceeds its size limit.
    TooLarge,
    /// The body exceeds its time limit.
    TooSlow,
    /// The memory for all bodies is used up.
    NoRoom,
    /// The sender disconnected, or sent no valid body.
    Broken,
}

/// Reads a body of at most `most` bytes to its end; with 0 bytes none is awaited.
pub(crate) async fn read(
    body: Incoming,
    most: usize,
    all: &Bodies,
    limits: &RequestLimits,
) -> Result<CountedBody, NoBody> {
    if body.size_hint().lower() > most as u64 || (most == 0 && !body.is_end_stream()) {
        return Err(NoBody::TooLarge);
    }
    let whole = pieces(body, all, most, limits.bodies_bytes);
    tokio::time::timeout(limits.body_time, whole).await.unwrap_or(Err(NoBody::TooSlow))
}

async fn pieces(mut body: Incoming, all: &Bodies, most: usize, most_of_all: usize) -> Result<CountedBody, NoBody> {
    let mut held = CountedBody { bytes: Vec::new(), all: all.clone() };
    while let Some(frame) = body.frame().await {
        // Frames without data are trailers, which are ignored.
        let Ok(piece) = frame.map_err(|_| NoBody::Broken)?.into_data() else { continue };
        if held.bytes.len() + piece.len() > most {
            return Err(NoBody::TooLarge);
        }
        if !held.take(&piece, most_of_all) {
            return Err(NoBody::NoRoom);
        }
    }
    Ok(held)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_are_counted_as_long_as_they_live() {
        let all = Bodies::default();
        let held = |bytes: usize| {
            let mut held = CountedBody { bytes: Vec::new(), all: all.clone() };
            let took = held.take(&Bytes::from(vec![0; bytes]), 100);
            (held, took)
        };
        let (first, took) = held(60);
        assert!(took && first.bytes().len() == 60);
        assert!(!held(60).1, "more than there is room for");
        drop(first);
        assert!(held(60).1);
        assert_eq!(all.0.load(Ordering::Relaxed), 0);
    }
}
