//! An axis as stated, with the recordings that were read for it.

use crate::bodies::check_texts;
use crate::fault::AxisReport;
use crate::recordings::{RecordingRead, Recordings};
use project::sections::{AxisSection, Fields, Segment, StatedField};
use recording::{Along, Series};
use std::ops::{Deref, DerefMut};

/// An axis as the file states it, with the recordings that its segments name.
#[derive(Clone, Debug)]
pub(crate) struct AxisSource {
    section: AxisSection,
    /// Recordings in the order of the segments.
    recordings: Vec<Option<RecordingRead>>,
}

impl AxisSource {
    /// Reads the recordings of an axis, and refuses bodies that are impossible.
    pub(crate) fn read(mut section: AxisSection, recordings: &mut Recordings<'_>, report: &mut AxisReport<'_>) -> Self {
        check_texts(&mut section.parts, report);
        let found = match section.parts.motion.get_mut() {
            Some(segments) => recordings.resolve(&mut segments.0, report),
            None => Vec::new(),
        };
        Self { section, recordings: found }
    }

    /// Returns the segments with their recordings.
    pub(crate) fn sources(&self) -> Vec<SegmentSource<'_>> {
        let recordings = self.recordings.iter().map(Option::as_ref).chain(std::iter::repeat(None));
        let segments = self.section.segments().iter().zip(recordings);
        segments.map(|(stated, recording)| SegmentSource { stated, recording }).collect()
    }

    /// Returns `true` if a segment or a recording states a motion along a line.
    pub(crate) fn moves_along_a_line(&self) -> bool {
        let is_along = |series: &Option<Series>| series.as_ref().is_some_and(|series| series.along == Along::Line);
        let course = |read: &RecordingRead| {
            [&read.recording.course.position, &read.recording.course.speed].into_iter().any(is_along)
        };
        let stated = self.section.segments();
        stated.iter().any(|segment| segment.fields().into_iter().any(StatedField::is_of_a_line))
            || self.recordings().any(course)
    }

    /// Returns the recordings that were read, in the order of the segments.
    pub(crate) fn recordings(&self) -> impl Iterator<Item = &RecordingRead> {
        self.recordings.iter().flatten()
    }
}

impl Deref for AxisSource {
    type Target = AxisSection;

    fn deref(&self) -> &AxisSection {
        &self.section
    }
}

impl DerefMut for AxisSource {
    fn deref_mut(&mut self) -> &mut AxisSection {
        &mut self.section
    }
}

/// A segment as the file states it, with the recording that it names.
#[derive(Clone, Copy)]
pub(crate) struct SegmentSource<'a> {
    pub(crate) stated: &'a Segment,
    /// Recording that was read.
    pub(crate) recording: Option<&'a RecordingRead>,
}

impl Deref for SegmentSource<'_> {
    type Target = Segment;

    fn deref(&self) -> &Segment {
        self.stated
    }
}
