//! Recordings of earlier projects, kept while a project is edited: with each key the load changes, the recording does not.

use motion::{Recorded, Treatment};
use recording::{Layout, Recording};
use sizing::Surveys;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Largest file that is kept \[bytes\]: a hundred thousand samples with some columns have a few megabytes.
pub(crate) const FILE_MOST: u64 = 32 << 20;

/// Largest number of kept recordings.
const RECORDINGS_MOST: usize = 2;

/// Largest number of kept uses of one recording.
const USES_MOST: usize = 4;

/// Recordings that were read for earlier projects, with the motions and the surveys made of them.
///
/// A recording is found by its content, compared byte by byte: a file that has changed is read again. What is kept equals
/// what is computed anew to the last bit.
#[derive(Debug, Default)]
pub struct KeptRecordings(Mutex<Vec<KeptRecording>>);

/// A recording with the bytes that it was read from.
#[derive(Clone, Debug)]
pub(crate) struct KeptRecording {
    content: Arc<[u8]>,
    layout: Layout,
    pub(crate) recording: Arc<Recording>,
    /// Memory that was available for it, and that it took \[bytes\].
    pub(crate) memory: (u64, u64),
    pub(crate) uses: Arc<RecordingUses>,
}

/// A recording with the use that a segment makes of it, and the motion that results.
#[derive(Clone, Debug)]
pub(crate) struct RecordedUse {
    pub(crate) recording: Arc<Recording>,
    /// Factors of position, speed and torque.
    pub(crate) factors: [f64; 3],
    /// Linear travel per angle of a recording along a line \[m/rad\].
    pub(crate) travel: Option<f64>,
    pub(crate) treatment: Treatment,
    pub(crate) motion: Arc<Recorded>,
}

/// Results computed from a recording for earlier projects.
#[derive(Debug, Default)]
pub(crate) struct RecordingUses {
    motions: Mutex<Vec<RecordedUse>>,
    surveys: Mutex<Surveys>,
}

/// Locks what one thread at a time changes; another one that failed left it whole.
fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl KeptRecordings {
    /// Returns the recording of a file with this content, read by the same layout.
    pub(crate) fn find(&self, content: &[u8], layout: &Layout) -> Option<KeptRecording> {
        let mut kept = locked(&self.0);
        let place = kept.iter().position(|each| each.layout == *layout && *each.content == *content)?;
        // The one that was used last stays the longest.
        let found = kept.remove(place);
        kept.push(found.clone());
        Some(found)
    }

    /// Keeps a recording; the one that was not used for the longest time is dropped for it.
    pub(crate) fn keep(
        &self,
        content: Arc<[u8]>,
        layout: &Layout,
        recording: &Arc<Recording>,
        memory: (u64, u64),
    ) -> Arc<RecordingUses> {
        let uses = Arc::<RecordingUses>::default();
        let mut kept = locked(&self.0);
        if kept.len() >= RECORDINGS_MOST {
            let _ = kept.remove(0);
        }
        kept.push(KeptRecording {
            content,
            layout: layout.clone(),
            recording: Arc::clone(recording),
            memory,
            uses: Arc::clone(&uses),
        });
        uses
    }
}

impl RecordingUses {
    /// Returns the motion of an equal use.
    pub(crate) fn motion(&self, is_equal: impl Fn(&RecordedUse) -> bool) -> Option<Arc<Recorded>> {
        locked(&self.motions).iter().find(|known| is_equal(known)).map(|known| Arc::clone(&known.motion))
    }

    /// Keeps the motion of a use.
    pub(crate) fn keep_motion(&self, made: RecordedUse) {
        let mut motions = locked(&self.motions);
        if motions.len() >= USES_MOST {
            let _ = motions.remove(0);
        }
        motions.push(made);
    }

    /// Returns the surveys of the last axis with the recording.
    pub(crate) fn surveys(&self) -> Surveys {
        locked(&self.surveys).clone()
    }

    /// Keeps the surveys of an axis in place of those before.
    pub(crate) fn keep_surveys(&self, surveys: Surveys) {
        *locked(&self.surveys) = surveys;
    }
}
