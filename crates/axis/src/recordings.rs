//! Recordings that a project file refers to: located and read, each once.

use crate::fault::{AxisFault, AxisReport};
use crate::files::{Files, Grant, Reach};
use crate::kept::{FILE_MOST, RecordingUses};
use crate::layout::{depends_on_layout, has_layout, layout};
use project::sections::{Segment, StatedField};
use project::{Fault, SegmentLaw};
use recording::{Bytes, Content, FILE_BYTES_MAX, Layout, Limit, Memory, Recording};
use std::io::{Cursor, Read};
use std::sync::Arc;

/// Bytes of a sample of a segment in addition to those of its recording: time, position, speed and torque at the
/// output.
const SEGMENT_BYTES: u64 = 4 * 8;

/// Least bytes of a sample of a recording: its time and one quantity.
const SAMPLE_BYTES: u64 = 2 * 8;

/// A recording with the name of its file.
#[derive(Clone, Debug)]
pub struct RecordingRead {
    /// Name in the project.
    pub file: String,
    /// Recording.
    pub recording: Arc<Recording>,
    /// Results of earlier projects with the recording, if it is kept.
    pub(crate) uses: Option<Arc<RecordingUses>>,
}

/// A recording with the results of earlier projects, if it is kept.
type Found = (Arc<Recording>, Option<Arc<RecordingUses>>);

/// Recordings of a project: each is read once, independent of the number of segments and axes that name it.
pub(crate) struct Recordings<'f> {
    files: &'f dyn Files,
    reach: Reach,
    memory: Memory,
    /// Bytes of a sample of a file, with those of the segment that names it.
    sample_bytes: u64,
    /// Recordings by file and layout; `None` for a refused one.
    read: Vec<(String, Layout, Option<Found>)>,
    /// Files examined without a valid layout.
    examined: Vec<String>,
}

impl<'f> Recordings<'f> {
    pub(crate) fn new(files: &'f dyn Files) -> Self {
        let Grant { memory, reach } = files.grant();
        Self {
            files,
            reach,
            memory: Memory::new(memory).until(files.cancelled()),
            sample_bytes: SAMPLE_BYTES + SEGMENT_BYTES,
            read: Vec::new(),
            examined: Vec::new(),
        }
    }

    /// Reads the recordings of a motion, in the order of its segments; the file of one that cannot be read is refused.
    pub(crate) fn resolve(
        &mut self,
        segments: &mut [Segment],
        report: &mut AxisReport<'_>,
    ) -> Vec<Option<RecordingRead>> {
        segments.iter_mut().map(|segment| self.of_segment(segment, report)).collect()
    }

    fn of_segment(&mut self, segment: &mut Segment, report: &mut AxisReport<'_>) -> Option<RecordingRead> {
        if segment.law.value() != Some(SegmentLaw::Recorded) {
            return None;
        }
        let name = segment.file.get()?.clone();
        let span = segment.file.span();
        let before = report.fault_count();
        let layout = layout(segment, report);
        let listed = |faults: Vec<AxisFault>, report: &mut AxisReport<'_>| {
            for fault in faults {
                report.fault(span.clone(), fault, None);
            }
        };
        // Of a layout with a refused value only the faults of the file count that do not depend on the layout.
        if report.fault_count() > before || !has_layout(segment) {
            listed(self.faults_of_file(&name, &layout), report);
            segment.file.refuse();
            return None;
        }
        let known = self.read.iter().find(|(file, by, _)| *file == name && *by == layout);
        let found = match known {
            // A rejected file is reported at its first use.
            Some((.., found)) => found.clone(),
            None => {
                let found = self.read_or_kept(&name, &layout).map_err(|faults| listed(faults, report)).ok();
                self.read.push((name.clone(), layout, found.clone()));
                found
            }
        };
        let found = found.filter(|(recording, _)| {
            let bytes = SEGMENT_BYTES * recording.time_s.len() as u64;
            self.memory.take(bytes).map_err(|fault| listed(unreadable(&name, vec![fault]), report)).is_ok()
        });
        if found.is_none() {
            segment.file.refuse();
        }
        found.map(|(recording, uses)| RecordingRead { file: name, recording, uses })
    }

    /// Returns the recording of a file: the kept one if its content is the same, else read anew and kept.
    fn read_or_kept(&mut self, name: &str, layout: &Layout) -> Result<Found, Vec<AxisFault>> {
        let is_small = || self.files.size(name).is_some_and(|size| size <= FILE_MOST);
        let kept = self.files.kept().filter(|_| self.reach.admits(name) && is_small());
        let Some(kept) = kept else { return Ok((Arc::new(self.read_file(name, layout)?), None)) };
        let mut content = Vec::new();
        let opened = self.files.open(name).and_then(|file| file.take(FILE_MOST + 1).read_to_end(&mut content));
        if opened.is_err() || content.len() as u64 > FILE_MOST {
            return Ok((Arc::new(self.read_file(name, layout)?), None));
        }
        let left = self.memory.left();
        // With less memory than before it may be refused.
        if let Some(found) = kept.find(&content, layout).filter(|found| found.memory.0 <= left)
            && self.memory.take(found.memory.1).is_ok()
        {
            return Ok((found.recording, Some(found.uses)));
        }
        let content: Arc<[u8]> = content.into();
        let recording = Arc::new(self.read_opened(name, layout, &|| Ok(Box::new(Cursor::new(Arc::clone(&content)))))?);
        let taken = left.saturating_sub(self.memory.left());
        let uses = kept.keep(content, layout, &recording, (left, taken));
        Ok((recording, Some(uses)))
    }

    /// Returns the faults of a file that no layout can mend, once for each file.
    fn faults_of_file(&mut self, name: &str, layout: &Layout) -> Vec<AxisFault> {
        let is_known = self.read.iter().any(|(file, ..)| file == name) || self.examined.iter().any(|file| file == name);
        if is_known {
            return Vec::new();
        }
        self.examined.push(name.to_owned());
        let left = self.memory.left();
        let found = self.read_file(name, layout).err().unwrap_or_default();
        self.memory.give_back(left.saturating_sub(self.memory.left()));
        found.into_iter().filter(|fault| !depends_on_layout(fault)).collect()
    }

    fn read_file(&mut self, name: &str, layout: &Layout) -> Result<Recording, Vec<AxisFault>> {
        let files = self.files;
        self.read_opened(name, layout, &|| files.open(name))
    }

    /// Reads a recording from its opened file, after the checks that need none.
    fn read_opened(
        &mut self,
        name: &str,
        layout: &Layout,
        open: &dyn Fn() -> std::io::Result<Box<dyn Read>>,
    ) -> Result<Recording, Vec<AxisFault>> {
        if !self.reach.admits(name) {
            return Err(vec![Fault::FileOutOfReach { name: name.to_owned() }.into()]);
        }
        let unopened =
            |error: std::io::Error| vec![Fault::File { name: name.to_owned(), trouble: (&error).into() }.into()];
        let refused = |fault| unreadable(name, vec![fault]);
        let beyond = |found| recording::Fault::Beyond { limit: Limit::FileBytes, found, most: FILE_BYTES_MAX };
        let size = self.files.size(name);
        if let Some(size) = size.filter(|size| *size > FILE_BYTES_MAX) {
            return Err(refused(beyond(size)));
        }
        let is_parquet = [".parquet", ".pq"].iter().any(|ending| name.to_ascii_lowercase().ends_with(ending));
        if is_parquet {
            // A file that would need more memory than is available as a whole is not begun.
            let whole = size.unwrap_or(0);
            self.memory.take(whole).map_err(refused)?;
            self.memory.give_back(whole);
        }
        // The content decides the format, independent of the name: data frames are saved as `run.parquet.gzip`.
        let (content, source) = open().and_then(recording::opened).map_err(unopened)?;
        match content {
            Content::Parquet => {}
            Content::Foreign(format) => return Err(refused(recording::Fault::Foreign { format })),
            Content::Text | Content::Packed(_) => {
                use recording::{
                    Damage, Fault::LineTooLong, Fault::NoHeader, Fault::NoTable, Fault::ParquetUnreadable,
                };
                // A text that is too long is not begun; a packed one has no length before it is unpacked.
                if content == Content::Text
                    && let Some(size) = size
                {
                    let counted = open().map_err(unopened)?;
                    recording::refuse_long(counted, size, layout, (&self.memory, self.sample_bytes))
                        .map_err(refused)?;
                }
                let read = recording::read_csv_within(source, layout, &mut self.memory);
                return read.map_err(|faults| match faults.as_slice() {
                    // A damaged file is recognised by its name if it is no table of text either.
                    [NoTable | NoHeader | LineTooLong { .. }, ..] if is_parquet => {
                        refused(ParquetUnreadable { reason: Damage::NoParquet })
                    }
                    _ => unreadable(name, faults),
                });
            }
        }
        if !cfg!(feature = "parquet") {
            return Err(unopened(std::io::ErrorKind::Unsupported.into()));
        }
        // The bytes of the file are in memory while it is read, within the limit.
        let held = size.unwrap_or(0);
        self.memory.take(held).map_err(refused)?;
        let most = self.memory.left().saturating_add(held).min(FILE_BYTES_MAX);
        let mut bytes = Vec::new();
        let opened = source.take(most + 1).read_to_end(&mut bytes);
        self.memory.give_back(held);
        let _ = opened.map_err(unopened)?;
        let held = bytes.len() as u64;
        if held > FILE_BYTES_MAX {
            return Err(refused(beyond(held)));
        }
        self.memory.take(held).map_err(refused)?;
        let read = recording::read_parquet_within(Bytes::from(bytes), layout, &mut self.memory);
        self.memory.give_back(held);
        read.map_err(|faults| unreadable(name, faults))
    }
}

/// Reads a recording that no project names yet, with the memory that a project may use.
///
/// # Errors
/// Every fault of the file.
pub fn read_recording(name: &str, layout: &Layout, files: &dyn Files) -> Result<Recording, Vec<AxisFault>> {
    let mut recordings = Recordings::new(files);
    recordings.sample_bytes = SAMPLE_BYTES;
    recordings.read_file(name, layout)
}

/// Returns true if a file is Parquet by its first bytes, packed or not.
#[must_use]
pub fn is_parquet(source: Box<dyn Read>) -> bool {
    recording::opened(source).is_ok_and(|(content, _)| content == Content::Parquet)
}

/// Returns the faults of a file that is no recording.
fn unreadable(name: &str, faults: Vec<recording::Fault>) -> Vec<AxisFault> {
    faults.into_iter().map(|fault| AxisFault::Recording { name: name.to_owned(), fault }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{AxisProject, NoCatalogue};
    use std::cell::{Cell, RefCell};

    const TEXT: &str = "t [s],q [deg],M [Nm]\n0,0,1\n1,0,1\n2,0,1\n";

    /// Files with equal content, counted as they are opened.
    struct Shelf {
        content: Vec<u8>,
        size: Option<u64>,
        grant: Grant,
        opened: RefCell<Vec<String>>,
    }

    impl Shelf {
        fn of(content: &str, grant: Grant) -> Self {
            Self { content: content.into(), size: None, grant, opened: RefCell::default() }
        }
    }

    impl Files for Shelf {
        fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>> {
            self.opened.borrow_mut().push(name.to_owned());
            Ok(Box::new(std::io::Cursor::new(self.content.clone())))
        }

        fn size(&self, _: &str) -> Option<u64> {
            self.size
        }

        fn grant(&self) -> Grant {
            self.grant
        }
    }

    fn faults(files: &[&str], shelf: &Shelf) -> Vec<AxisFault> {
        let segments = files.iter().map(|file| format!("[[motion]]\nlaw = \"recorded\"\nfile = '{file}'\n"));
        let text = format!(
            "format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"1 kg m^2\"\n{}",
            segments.collect::<String>()
        );
        let read = AxisProject::read_all(&text, shelf, &NoCatalogue::shared(), &|_, _| None);
        read.err().unwrap_or_default().into_iter().map(|diagnostic| diagnostic.fault).collect()
    }

    #[test]
    fn a_file_of_several_segments_is_read_once() {
        let shelf = Shelf::of(TEXT, Grant::default());
        assert_eq!(faults(&["a.csv", "b.csv", "a.csv", "a.csv"], &shelf), []);
        assert_eq!(*shelf.opened.borrow(), ["a.csv", "b.csv"]);
        let refused = Shelf::of("nothing", Grant::default());
        let found = faults(&["a.csv", "a.csv"], &refused);
        assert_eq!((found.len(), refused.opened.borrow().len()), (1, 1), "reported once: {found:?}");
    }

    #[test]
    fn a_clock_time_as_a_bound_has_its_remedy() {
        for bound in ["from = \"17:00:05.1\"", "to = \"2025-04-17T17:00:07\"", "from = \"5 x\""] {
            let text = format!(
                "format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"recorded\"\nfile = 'a.csv'\n{bound}\n"
            );
            let shelf = Shelf::of(TEXT, Grant::default());
            let found =
                AxisProject::read_all(&text, &shelf, &NoCatalogue::shared(), &|_, _| None).err().unwrap_or_default();
            let hints: Vec<bool> = found.iter().map(|each| each.hint == Some(project::Hint::TimeOfClock)).collect();
            assert_eq!(hints, [bound.contains(':')], "{bound}: {found:?}");
        }
    }

    #[test]
    fn every_segment_counts_against_the_memory_of_the_project() {
        let rows: String = (0..1000).map(|row| format!("{row},0\n")).collect();
        let text = format!("t [s],q [deg]\n{rows}");
        let with = |memory| Shelf::of(&text, Grant { memory, ..Grant::default() });
        // 16 bytes a sample for the recording, 32 for each segment; memory for 4096 samples is reserved at first.
        assert_eq!(faults(&["a.csv"; 2], &with(80_000)), []);
        let found = faults(&["a.csv"; 3], &with(80_000));
        assert!(
            matches!(
                found.as_slice(),
                [AxisFault::Recording { fault: recording::Fault::Beyond { limit: Limit::Memory, .. }, .. }]
            ),
            "{found:?}"
        );
    }

    /// A recording of 60 million rows, made while it is read.
    struct Long {
        block: Vec<u8>,
        opened: Cell<u64>,
    }

    struct Rows {
        block: Vec<u8>,
        at: usize,
        left: u64,
    }

    impl Read for Rows {
        fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
            let from = &self.block[self.at..];
            let count = from.len().min(into.len()).min(usize::try_from(self.left).unwrap());
            into[..count].copy_from_slice(&from[..count]);
            self.at = (self.at + count) % self.block.len();
            self.left -= count as u64;
            Ok(count)
        }
    }

    impl Files for Long {
        fn open(&self, _: &str) -> std::io::Result<Box<dyn Read>> {
            self.opened.set(self.opened.get() + 1);
            // Only the first opening is read as a recording, the second to count.
            let left = if self.opened.get() == 1 { 4096 } else { self.size("").unwrap() };
            Ok(Box::new(Rows { block: self.block.clone(), at: 0, left }))
        }

        fn size(&self, _: &str) -> Option<u64> {
            Some(60_000_000 * 10)
        }
    }

    fn read(lines: &str, content: &str) -> Result<Vec<AxisProject>, Vec<AxisFault>> {
        let text = format!(
            "format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"recorded\"\nfile = 'a.csv'\n{lines}"
        );
        let read =
            AxisProject::read_all(&text, &Shelf::of(content, Grant::default()), &NoCatalogue::shared(), &|_, _| None);
        read.map_err(|faults| faults.into_iter().map(|each| each.fault).collect())
    }

    /// A position in counts is an angle once the counts of a revolution are stated, by any number of them.
    #[test]
    fn counts_are_an_angle_with_their_number_in_a_revolution() {
        for counts in [4096.0, 131_072.0, 13_107_200.0, 1e9] {
            for heading in ["q [counts]", "Position [inc]", "Lage (Inkremente)"] {
                let row = |k: u32| {
                    format!("{},{}\n", f64::from(k) * 0.1, (0.5 * counts * f64::from(k * (20 - k)) / 100.0).round())
                };
                let content = format!("t [s],{heading}\n{}", (0..=20).map(row).collect::<String>());
                let refused = read("", &content).err().unwrap_or_default();
                assert!(
                    matches!(refused[..], [AxisFault::Recording { fault: recording::Fault::UnitUnknown { .. }, .. }]),
                    "{heading}: {refused:?}"
                );
                let lines = format!("units = {{ position = \"rev\" }}\nrecorded_ratio = {{ position = {counts} }}\n");
                let found = read(&lines, &content).unwrap_or_else(|why| panic!("{heading}: {why:?}"));
                let positions = found[0].axis.motion.recordings()[0].recorded.position_rad();
                let [low, high] = positions
                    .iter()
                    .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], q| [low.min(*q), high.max(*q)]);
                assert!((high - low - std::f64::consts::PI).abs() < 1e-2, "{counts}: {}", high - low);
            }
        }
    }

    /// An end of the part in use that is no instant of a sample is stated with the instant that is used.
    #[test]
    fn an_end_between_samples_is_stated() {
        let row = |k: u32| format!("{},{}\n", f64::from(k) * 0.1, k * (20 - k));
        let content = format!("t [s],q [deg]\n{}", (0..=20).map(row).collect::<String>());
        for (lines, ends) in [
            ("from = \"0.3 s\"\nto = \"1.5 s\"\n", vec![]),
            ("from = \"300 ms\"\nto = \"1.54 s\"\n", vec![(false, 1.54, 1.5)]),
            ("from = \"0.201 s\"\nto = \"1.599 s\"\n", vec![(true, 0.201, 0.3), (false, 1.599, 1.5)]),
            ("from = \"-1 s\"\n", vec![(true, -1.0, 0.0)]),
            ("", vec![]),
        ] {
            let found = read(lines, &content).unwrap();
            let of = |each: &crate::Assumption| match each {
                crate::Assumption::RecordedWindow(end) => Some(*end),
                _ => None,
            };
            let found: Vec<crate::WindowEnd> = found[0].assumptions.iter().filter_map(of).collect();
            assert_eq!(found.len(), ends.len(), "{lines}: {found:?}");
            for (end, (is_start, stated, used)) in found.iter().zip(ends) {
                assert_eq!((end.is_start, end.stated_s), (is_start, stated), "{lines}");
                assert!((end.used_s - used).abs() < 1e-9, "{lines}: {end:?}");
            }
        }
    }

    #[test]
    fn a_recording_of_too_many_rows_is_not_begun() {
        let files = Long { block: b"0.001,0.5\n".repeat(1 << 17), opened: Cell::default() };
        let found = read_recording("a.csv", &Layout::default(), &files).map(drop).unwrap_err();
        assert_eq!(
            found,
            [AxisFault::Recording {
                name: "a.csv".to_owned(),
                fault: recording::Fault::TooManySamples { most: recording::SAMPLES_MAX }
            }]
        );
        assert_eq!(files.opened.get(), 2);
    }

    #[test]
    fn the_content_decides_whatever_the_name() {
        assert_eq!(faults(&["a.parquet"], &Shelf::of(TEXT, Grant::default())), []);
        for text in ["", "PAR\u{1}\u{2}", "no table\nat all\n"] {
            let found = faults(&["a.parquet"], &Shelf::of(text, Grant::default()));
            assert!(
                matches!(
                    found.as_slice(),
                    [AxisFault::Recording { fault: recording::Fault::ParquetUnreadable { .. }, .. }]
                ),
                "{found:?}"
            );
        }
    }

    #[test]
    fn a_file_that_is_too_large_is_not_opened() {
        for name in ["a.csv", "a.parquet"] {
            let shelf = Shelf { size: Some(FILE_BYTES_MAX + 1), ..Shelf::of(TEXT, Grant::default()) };
            let found = faults(&[name], &shelf);
            assert!(
                matches!(
                    found.as_slice(),
                    [AxisFault::Recording { fault: recording::Fault::Beyond { limit: Limit::FileBytes, .. }, .. }]
                ),
                "{found:?}"
            );
            assert_eq!(*shelf.opened.borrow(), [""; 0]);
        }
        // A Parquet file is held in memory as a whole: one beyond the limit is not read.
        let grant = Grant { memory: 100, ..Grant::default() };
        let shelf = Shelf { size: Some(1000), ..Shelf::of(TEXT, grant) };
        let found = faults(&["a.parquet"], &shelf);
        assert!(matches!(found.as_slice(), [AxisFault::Recording { .. }]), "{found:?}");
        assert_eq!(*shelf.opened.borrow(), [""; 0]);
        let unsized_ = Shelf::of(&format!("PAR1{}", "x".repeat(1000)), grant);
        assert!(matches!(
            faults(&["a.parquet"], &unsized_).as_slice(),
            [AxisFault::Recording { fault: recording::Fault::Beyond { .. }, .. }]
        ));
    }

    #[test]
    fn the_strict_reach_keeps_to_the_folder_of_the_project() {
        let away = [
            "/etc/passwd",
            "../a.csv",
            "runs/../../a.csv",
            "C:\\a.csv",
            "\\\\host\\a.csv",
            "runs\\..\\..\\a.csv",
            "a.csv:hidden",
        ];
        for name in away {
            let shelf = Shelf::of(TEXT, Grant::default());
            assert_eq!(faults(&[name], &shelf), [Fault::FileOutOfReach { name: name.to_owned() }.into()]);
            assert_eq!(*shelf.opened.borrow(), [""; 0]);
            let anywhere = Shelf::of(TEXT, Grant { reach: Reach::Anywhere, ..Grant::default() });
            assert_eq!(faults(&[name], &anywhere), []);
        }
        for name in ["a.csv", "runs/a.csv", "./a..b.csv", "..a/b.csv"] {
            assert_eq!(faults(&[name], &Shelf::of(TEXT, Grant::default())), []);
        }
    }
}
