//! Recordings that a project file refers to: located, read and converted to motion at the output.

use crate::Fault;
use crate::about::About;
use crate::key::Kind;
use crate::layout::{depends_on_layout, has_layout, layout};
use crate::motion::{Segment, SegmentLaw};
use crate::read::{FoundValue, Reader};
use crate::section::section;
use crate::stated::StatedField;
use crate::value::{KeyValue, choices};
use ::motion::{Recorded, RecordedFault, Samples, Treatment};
use quantities::{AngularVelocity, Unit};
use recording::{Along, Bytes, Content, FILE_BYTES_MAX, Layout, Limit, MEMORY_USUAL, Memory, Recording, Role, Series};
use std::io::Read;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Bytes of a sample of a segment in addition to those of its recording: time, position, speed and torque at the
/// output.
const SEGMENT_BYTES: u64 = 4 * 8;

/// Permission of gaps between the samples of a recording.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Gaps {
    Allow,
}

/// Use of recorded values that are held over several rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum HeldValues {
    Interpolate,
}

/// Use of the time stamps of a recording.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TimeStamps {
    Even,
}

choices! {
    Gaps { Allow = "allow" }
    HeldValues { Interpolate = "interpolate" }
    TimeStamps { Even = "even" }
}

section! {
    /// Names of the columns of a recording; `none` where a name must not be taken for a role.
    Columns, ColumnsName of About::Columns {
        time: String;
        position: String;
        speed: String;
        torque: String;
    }
}

section! {
    /// Units of the columns of a recording.
    Units, UnitsName of About::Units {
        time: String => example("ms");
        position: String => example("deg");
        speed: String => example("1/min");
        torque: String => example("N m");
    }
}

section! {
    /// Ratios between the shaft at which a quantity is recorded and the output: 1 at the output, negative where it turns
    /// the other way.
    Ratios, RatiosName of About::Ratios {
        position: f64 => within(-1e4, 1e4), example("80");
        speed: f64 => within(-1e4, 1e4), example("80");
        torque: f64 => within(-1e4, 1e4), example("80");
    }
}

/// File of a recording, and the recording.
#[derive(Clone, Debug)]
pub(crate) struct File {
    name: String,
    read: Option<RecordingRead>,
}

impl KeyValue for File {
    const KIND: Kind = Kind::Text;

    fn read(found: &FoundValue<'_, '_>, reader: &mut Reader<'_>) -> Option<Self> {
        reader.free_text(found).map(|name| Self { name, read: None })
    }

    fn noted(&self) -> Option<Option<(f64, &'static Unit)>> {
        Some(None)
    }
}

impl Segment {
    /// Returns the recording that was read.
    pub(crate) fn recording(&self) -> Option<&RecordingRead> {
        self.file.get()?.read.as_ref()
    }
}

/// Access to the files that a project refers to, provided by the caller.
pub trait Files {
    /// Opens a file by the name that the project gives it. A file that is not a regular one is refused, never waited
    /// for.
    ///
    /// # Errors
    /// The error of the system, or [`Unopened`](crate::Unopened).
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>>;

    /// Returns its size in bytes, if that is known without reading it; a file that is too large is then not read at
    /// all.
    fn size(&self, _name: &str) -> Option<u64> {
        None
    }

    /// Returns a flag that the caller sets to cancel the reading.
    fn cancelled(&self) -> Option<Arc<AtomicBool>> {
        None
    }

    /// Returns the permissions of a project.
    fn grant(&self) -> Grant {
        Grant::default()
    }
}

/// Permissions of a project for files that it refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grant {
    /// Bytes of memory for all recordings of the project.
    pub memory: u64,
    /// Permissible folders.
    pub reach: Reach,
}

impl Default for Grant {
    /// Returns the default memory, and access to files next to the project only: a caller that serves another user
    /// decides on more.
    fn default() -> Self {
        Self { memory: MEMORY_USUAL, reach: Reach::Folder }
    }
}

/// Permissible folders of the files of a project. The name alone decides; links are resolved when the file is opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// The folder of the project and those below it.
    Folder,
    /// Any folder.
    Anywhere,
}

impl Reach {
    /// Returns `true` if a name stays within. A root, a drive or a parent folder of any system is refused on all of
    /// them.
    #[must_use]
    pub fn admits(self, name: &str) -> bool {
        let is_plain = |part: &str| part != ".." && !part.contains([':', '\0']);
        self == Self::Anywhere || !name.starts_with(['/', '\\']) && name.split(['/', '\\']).all(is_plain)
    }
}

/// No access to files: a project that refers to one is refused.
#[derive(Clone, Copy, Debug)]
pub struct NoFiles;

impl Files for NoFiles {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn Read>> {
        Err(std::io::ErrorKind::Unsupported.into())
    }
}

/// A recording with the name of its file.
#[derive(Clone, Debug)]
pub struct RecordingRead {
    /// Name in the project.
    pub file: String,
    /// Recording.
    pub recording: Arc<Recording>,
}

/// Recordings of a project: each is read once, independent of the number of segments and axes that name it.
pub(crate) struct Recordings<'f> {
    files: &'f dyn Files,
    reach: Reach,
    memory: Memory,
    /// Recordings by file and layout; `None` for a refused one.
    read: Vec<(String, Layout, Option<Arc<Recording>>)>,
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
            read: Vec::new(),
            examined: Vec::new(),
        }
    }

    /// Reads every recording of the motion.
    pub(crate) fn resolve(&mut self, segments: &mut [Segment], reader: &mut Reader<'_>) {
        for segment in segments {
            if segment.law.value() != Some(SegmentLaw::Recorded) {
                continue;
            }
            let Some(name) = segment.file.get().map(|file| file.name.clone()) else { continue };
            let span = segment.file.span();
            let before = reader.fault_count();
            let layout = layout(segment, reader);
            // Of a layout with a refused value only the faults of the file count that do not depend on the layout.
            if reader.fault_count() > before || !has_layout(segment) {
                for fault in self.faults_of_file(&name, &layout) {
                    reader.fault(span.clone(), fault, None);
                }
                segment.file.refuse();
                continue;
            }
            let report = |faults: Vec<Fault>, reader: &mut Reader<'_>| {
                for fault in faults {
                    reader.fault(span.clone(), fault, None);
                }
            };
            let known = self.read.iter().find(|(file, by, _)| *file == name && *by == layout);
            let found = match known {
                // A rejected file is reported at its first use.
                Some((.., found)) => found.clone(),
                None => {
                    let found =
                        self.read_file(&name, &layout).map_err(|faults| report(faults, reader)).ok().map(Arc::new);
                    self.read.push((name.clone(), layout, found.clone()));
                    found
                }
            };
            let found = found.filter(|recording| {
                let bytes = SEGMENT_BYTES * recording.time_s.len() as u64;
                self.memory.take(bytes).map_err(|fault| report(unreadable(&name, vec![fault]), reader)).is_ok()
            });
            match found {
                Some(recording) => {
                    let read = Some(RecordingRead { file: name.clone(), recording });
                    segment.file.give(File { name, read }, span);
                }
                None => segment.file.refuse(),
            }
        }
    }

    /// Returns the faults of a file that no layout can mend, once for each file.
    fn faults_of_file(&mut self, name: &str, layout: &Layout) -> Vec<Fault> {
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

    fn read_file(&mut self, name: &str, layout: &Layout) -> Result<Recording, Vec<Fault>> {
        if !self.reach.admits(name) {
            return Err(vec![Fault::FileOutOfReach { name: name.to_owned() }]);
        }
        let unopened = |error: std::io::Error| vec![Fault::File { name: name.to_owned(), trouble: (&error).into() }];
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
        let (content, source) = self.files.open(name).and_then(recording::opened).map_err(unopened)?;
        match content {
            Content::Parquet => {}
            Content::Foreign(format) => return Err(refused(recording::Fault::Foreign { format })),
            Content::Text | Content::Packed(_) => {
                use recording::{
                    Damage, Fault::LineTooLong, Fault::NoHeader, Fault::NoTable, Fault::ParquetUnreadable,
                };
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

/// Returns the faults of a file that is no recording.
fn unreadable(name: &str, faults: Vec<recording::Fault>) -> Vec<Fault> {
    faults.into_iter().map(|fault| Fault::Recording { name: name.to_owned(), fault }).collect()
}

/// Returns the number of samples of the recording of a segment.
pub(crate) fn samples(segment: &Segment) -> usize {
    segment.recording().map_or(0, |read| read.recording.time_s.len())
}

/// Recorded motions of the segments of an axis: segments that use one recording alike share its motion.
#[derive(Default)]
pub(crate) struct RecordedMotions(Vec<RecordedUse>);

/// A recording with the use that a segment makes of it, and the motion that results.
struct RecordedUse {
    recording: Arc<Recording>,
    /// Factors of position, speed and torque.
    factors: [f64; 3],
    treatment: Treatment,
    motion: Arc<Recorded>,
}

impl RecordedMotions {
    /// Returns the motion of another segment with the same recording, ratios of its columns, and treatment.
    fn find(&self, of: &Arc<Recording>, factors: [f64; 3], by: &Treatment) -> Option<Arc<Recorded>> {
        let mut known = self.0.iter();
        let is_same = |known: &&RecordedUse| {
            Arc::ptr_eq(&known.recording, of) && known.factors == factors && known.treatment == *by
        };
        known.find(is_same).map(|same| Arc::clone(&same.motion))
    }
}

/// Returns the recorded motion of a segment at the output; `None` after a fault.
///
/// `travel`: linear travel per angle \[m/rad\] of a linear mechanism.
pub(crate) fn motion(
    segment: &Segment,
    travel: Option<f64>,
    known: &mut RecordedMotions,
    reader: &mut Reader<'_>,
) -> Option<Arc<Recorded>> {
    let before = reader.fault_count();
    // Known without the recording.
    let standstill = crate::motion::turned(&segment.standstill, travel, reader);
    let ratios = crate::side::ratios(segment, reader);
    let RecordingRead { file, recording } = segment.recording()?;
    let treatment = treatment(segment, standstill);
    let factors = [Role::Position, Role::Speed, Role::Torque].map(|role| ratios.factor(role));
    if let Some(same) = known.find(recording, factors, &treatment).filter(|_| segment.states_its_motion()) {
        return Some(same);
    }
    let mut turned = |series: &Option<Series>, role: Role| -> Option<Arc<Vec<f64>>> {
        let Series { along, values } = series.as_ref()?;
        let factor = match (along, travel) {
            (Along::Turning, _) => match ratios.factor(role) {
                1.0 => return Some(Arc::clone(values)),
                factor => factor,
            },
            (Along::Line, Some(travel)) if role != Role::Torque => 1.0 / travel,
            (Along::Line, Some(travel)) => travel,
            (Along::Line, None) => {
                reader.fault(segment.file.span(), Fault::NoLine { path: file.clone() }, None);
                return None;
            }
        };
        Some(Arc::new(values.iter().map(|value| value * factor).collect()))
    };
    let samples = Samples {
        time_s: Arc::clone(&recording.time_s),
        position_rad: turned(&recording.course.position, Role::Position),
        speed_rad_s: turned(&recording.course.speed, Role::Speed),
        torque_nm: turned(&recording.torque, Role::Torque),
    };
    if reader.fault_count() > before {
        return None;
    }
    match Recorded::new(samples, treatment) {
        // A refused value has been reported; without it the motion is another one.
        Ok(_) | Err(RecordedFault::Contradiction { .. }) if !segment.states_its_motion() => None,
        Ok(recorded) => {
            let motion = Arc::new(recorded);
            let recording = Arc::clone(recording);
            known.0.push(RecordedUse { recording, factors, treatment, motion: Arc::clone(&motion) });
            Some(motion)
        }
        Err(fault) => {
            let span = match fault {
                RecordedFault::WindowTooShort { .. }
                | RecordedFault::WindowTooLong { .. }
                | RecordedFault::WindowOverMotion { .. } => segment.smoothing.span(),
                RecordedFault::StampsUneven { .. } => segment.time_stamps.span(),
                RecordedFault::TooFew { .. }
                | RecordedFault::NoCourse
                | RecordedFault::Uneven
                | RecordedFault::NotFinite { .. }
                | RecordedFault::NotIncreasing { .. }
                | RecordedFault::Contradiction { .. } => segment.file.span(),
            };
            reader.fault(span, Fault::Recorded { name: file.clone(), fault }, None);
            None
        }
    }
}

/// Returns the stated treatment of a recording; `standstill` is the limit of the speed at the output.
fn treatment(segment: &Segment, standstill: Option<AngularVelocity>) -> Treatment {
    Treatment {
        smoothing: segment.smoothing.value(),
        standstill,
        held_values: match segment.held_values.value() {
            Some(HeldValues::Interpolate) => ::motion::HeldValues::Interpolated,
            None => ::motion::HeldValues::Kept,
        },
        time_stamps: match segment.time_stamps.value() {
            Some(TimeStamps::Even) => ::motion::TimeStamps::Even,
            None => ::motion::TimeStamps::Kept,
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{NoCatalogue, Project};
    use std::cell::RefCell;

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

    fn faults(files: &[&str], shelf: &Shelf) -> Vec<Fault> {
        let segments = files.iter().map(|file| format!("[[motion]]\nlaw = \"recorded\"\nfile = '{file}'\n"));
        let text = format!(
            "format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"1 kg m^2\"\n{}",
            segments.collect::<String>()
        );
        let read = Project::read_all(&text, shelf, &NoCatalogue::shared(), &|_, _| None);
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
                Project::read_all(&text, &shelf, &NoCatalogue::shared(), &|_, _| None).err().unwrap_or_default();
            let hints: Vec<bool> = found.iter().map(|each| each.hint == Some(crate::Hint::TimeOfClock)).collect();
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
                [Fault::Recording { fault: recording::Fault::Beyond { limit: Limit::Memory, .. }, .. }]
            ),
            "{found:?}"
        );
    }

    #[test]
    fn the_content_decides_whatever_the_name() {
        assert_eq!(faults(&["a.parquet"], &Shelf::of(TEXT, Grant::default())), []);
        for text in ["", "PAR\u{1}\u{2}", "no table\nat all\n"] {
            let found = faults(&["a.parquet"], &Shelf::of(text, Grant::default()));
            assert!(
                matches!(
                    found.as_slice(),
                    [Fault::Recording { fault: recording::Fault::ParquetUnreadable { .. }, .. }]
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
                    [Fault::Recording { fault: recording::Fault::Beyond { limit: Limit::FileBytes, .. }, .. }]
                ),
                "{found:?}"
            );
            assert_eq!(*shelf.opened.borrow(), [""; 0]);
        }
        // A Parquet file is held in memory as a whole: one beyond the limit is not read.
        let grant = Grant { memory: 100, ..Grant::default() };
        let shelf = Shelf { size: Some(1000), ..Shelf::of(TEXT, grant) };
        let found = faults(&["a.parquet"], &shelf);
        assert!(matches!(found.as_slice(), [Fault::Recording { .. }]), "{found:?}");
        assert_eq!(*shelf.opened.borrow(), [""; 0]);
        let unsized_ = Shelf::of(&format!("PAR1{}", "x".repeat(1000)), grant);
        assert!(matches!(
            faults(&["a.parquet"], &unsized_).as_slice(),
            [Fault::Recording { fault: recording::Fault::Beyond { .. }, .. }]
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
            assert_eq!(faults(&[name], &shelf), [Fault::FileOutOfReach { name: name.to_owned() }]);
            assert_eq!(*shelf.opened.borrow(), [""; 0]);
            let anywhere = Shelf::of(TEXT, Grant { reach: Reach::Anywhere, ..Grant::default() });
            assert_eq!(faults(&[name], &anywhere), []);
        }
        for name in ["a.csv", "runs/a.csv", "./a..b.csv", "..a/b.csv"] {
            assert_eq!(faults(&[name], &Shelf::of(TEXT, Grant::default())), []);
        }
    }
}
