//! A recording that no project names yet: its columns, its quality, and its effect on the axis that would use it.

use crate::progress::Progress;
use axis::{AxisFault, AxisProject, Files, Grant, read_recording};
use motion::{ColumnQuality, MadeUp, Outliers, Recorded, RecordedFault, Samples, SignalKind, Treatment, jumps};
use quantities::{Measure, MomentOfInertia, Time, Torque, parse_as};
use recording::{Along, Content, Layout, Preview, Recording, Role, Series};
use std::io::{Cursor, Read};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Number of rows of a preview.
const ROWS: usize = 4;

/// Number of samples above which only the stated and the proposed window of smoothing are tried.
const TRIED_WITHIN: usize = 200_000;

/// Windows that are tried, in samples.
const WINDOWS: [u32; 4] = [7, 15, 31, 63];

/// Largest share of the duration of a recording that a window which is tried may have.
const SHARE_MOST: f64 = 0.05;

/// A file that is to become part of a project.
#[derive(Clone, Debug)]
pub struct IncomingFile {
    name: String,
    bytes: Arc<[u8]>,
}

impl IncomingFile {
    /// Creates it from its name and its content.
    #[must_use]
    pub fn new(name: &str, bytes: &[u8]) -> Self {
        Self { name: name.to_owned(), bytes: bytes.into() }
    }

    /// Returns its name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns its content.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Returns its columns and, of a text, its first rows; `None` if it is no table.
    #[must_use]
    pub fn preview(&self) -> Option<Preview> {
        preview_of(self.source(), recording::MEMORY_USUAL)
    }

    /// Returns the files of a project with this one among them.
    #[must_use]
    pub const fn among<'f>(&'f self, others: &'f dyn Files, progress: &'f Progress) -> FilesWithIncoming<'f> {
        FilesWithIncoming { incoming: self, others, progress }
    }

    /// Reads the recording.
    ///
    /// # Errors
    /// Every fault of the file.
    pub fn read(&self, layout: &Layout, others: &dyn Files, progress: &Progress) -> Result<Recording, Vec<AxisFault>> {
        read_recording(&self.name, layout, &self.among(others, progress))
    }

    fn source(&self) -> Box<dyn Read> {
        Box::new(Cursor::new(Arc::clone(&self.bytes)))
    }
}

/// Returns the columns of a source and, of a text, its first rows; `None` if it is no table, or one in Parquet of more
/// than `most` bytes.
fn preview_of(source: Box<dyn Read>, most: u64) -> Option<Preview> {
    let (content, source) = recording::opened(source).ok()?;
    match content {
        Content::Foreign(_) => None,
        Content::Text | Content::Packed(_) => recording::preview_csv(source, ROWS),
        Content::Parquet => {
            let mut bytes = Vec::new();
            let _ = source.take(most.saturating_add(1)).read_to_end(&mut bytes).ok()?;
            let is_within = bytes.len() as u64 <= most;
            is_within.then(|| recording::preview_parquet(&recording::Bytes::from(bytes)).ok()).flatten()
        }
    }
}

/// Returns the columns of a file and, of a text, its first rows. No more of a text is read than that, and no file that
/// would be too large as a recording.
///
/// # Errors
/// Every reason why the file is no recording.
pub fn previewed(name: &str, files: &dyn Files) -> Result<Preview, Vec<AxisFault>> {
    let most = files.grant().memory;
    let is_small = files.size(name).is_none_or(|size| size <= recording::FILE_BYTES_MAX);
    let shown = if is_small { files.open(name).ok().and_then(|source| preview_of(source, most)) } else { None };
    shown.ok_or_else(|| {
        let faults = read_recording(name, &Layout::default(), files).err().unwrap_or_default();
        let none = || vec![AxisFault::Recording { name: name.to_owned(), fault: recording::Fault::NoTable }];
        if faults.is_empty() { none() } else { faults }
    })
}

/// Files of a project with one that is not among them yet.
pub struct FilesWithIncoming<'f> {
    incoming: &'f IncomingFile,
    others: &'f dyn Files,
    progress: &'f Progress,
}

impl Files for FilesWithIncoming<'_> {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>> {
        if name == self.incoming.name { Ok(self.incoming.source()) } else { self.others.open(name) }
    }

    fn size(&self, name: &str) -> Option<u64> {
        if name == self.incoming.name { Some(self.incoming.bytes.len() as u64) } else { self.others.size(name) }
    }

    fn cancelled(&self) -> Option<Arc<AtomicBool>> {
        Some(self.progress.flag())
    }

    fn grant(&self) -> Grant {
        self.others.grant()
    }
}

/// Single values of a recorded column far beside those around them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColumnOutliers {
    /// Role of the column.
    pub role: Role,
    /// Direction of its values.
    pub along: Along,
    /// Number of the values.
    pub count: usize,
    /// Instant of the one farthest from those around it \[s\].
    pub time_s: f64,
    /// Value there, in SI.
    pub value: f64,
}

/// A recording that could be read, with its quality.
#[derive(Clone, Debug)]
pub struct ExaminedRecording {
    /// Recording as read.
    pub recording: Arc<Recording>,
    /// Samples at the output.
    samples: Samples,
    /// Motion at the output: in rad, or in m along a line.
    pub recorded: Recorded,
    /// Smallest, median and largest interval between two samples \[s\].
    pub intervals_s: [f64; 3],
    /// Quality of each recorded column, in its SI unit.
    pub quality: Vec<(Role, Along, ColumnQuality)>,
    /// Single values of recorded columns far beside those around them.
    pub outliers: Vec<ColumnOutliers>,
    /// First jump of the position from one row to the next: direction, instant \[s\] and change in SI.
    pub jump: Option<(Along, f64, f64)>,
}

impl ExaminedRecording {
    /// Examines a recording. `ratios` divide position and speed and multiply the torque: the turns at the place of
    /// recording per turn of the output.
    ///
    /// # Errors
    /// Reason why the samples are no motion.
    pub fn of(recording: Arc<Recording>, ratios: [f64; 3]) -> Result<Self, RecordedFault> {
        let [position, speed, torque] = ratios;
        let at_output = |series: &Option<Series>, factor: f64| {
            let Series { along, values } = series.as_ref()?;
            let turned = *along == Along::Turning && factor != 1.0;
            Some(if turned {
                Arc::new(values.iter().map(|value| value * factor).collect())
            } else {
                Arc::clone(values)
            })
        };
        let samples = Samples {
            time_s: Arc::clone(&recording.time_s),
            position_rad: at_output(&recording.course.position, 1.0 / position),
            speed_rad_s: at_output(&recording.course.speed, 1.0 / speed),
            torque_nm: at_output(&recording.torque, torque),
        };
        let columns = [
            (Role::Position, &recording.course.position),
            (Role::Speed, &recording.course.speed),
            (Role::Torque, &recording.torque),
        ];
        let quality = columns.into_iter().filter_map(|(role, series)| {
            let Series { along, values } = series.as_ref()?;
            Some((role, *along, ColumnQuality::of(&recording.time_s, values)))
        });
        let quality = quality.collect();
        let outliers = columns.into_iter().filter_map(|(role, series)| {
            let Series { along, values } = series.as_ref()?;
            let kind = if role == Role::Torque { SignalKind::Force } else { SignalKind::Motion };
            let found = Outliers::of(values, kind)?;
            let (time_s, value) = (*recording.time_s.get(found.farthest)?, *values.get(found.farthest)?);
            Some(ColumnOutliers { role, along: *along, count: found.count, time_s, value })
        });
        let outliers: Vec<ColumnOutliers> = outliers.collect();
        let jump = recording.course.position.as_ref().and_then(|Series { along, values }| {
            let (row, change) = jumps(&recording.time_s, values).into_iter().next()?;
            // A single value jumps there and back.
            let is_outlier = outliers.iter().any(|found| found.role == Role::Position);
            Some((*along, *recording.time_s.get(row)?, change)).filter(|_| !is_outlier)
        });
        let intervals_s = intervals(&recording.time_s);
        let recorded = Recorded::new(samples.clone(), Treatment::default())?;
        Ok(Self { recording, samples, recorded, intervals_s, quality, outliers, jump })
    }

    /// Returns the largest acceleration with a window of smoothing [rad/s²], or [m/s²] along a line, of a single move or of a
    /// cycle, whose window goes over its seam as in an axis; `None` if the window is too narrow or too wide.
    fn acceleration_peak(&self, smoothing: Option<Time>, is_single: bool) -> Option<f64> {
        let treatment = Treatment { smoothing, repeats: !is_single, ..Treatment::default() };
        let smoothed = Recorded::new(self.samples.clone(), treatment).ok()?;
        let steps = smoothed.time_s().windows(2).zip(smoothed.speed_rad_s().windows(2));
        let acceleration = steps.filter_map(|(t, w)| Some((w.last()? - w.first()?) / (t.last()? - t.first()?)));
        Some(acceleration.fold(0.0, |most: f64, a| most.max(a.abs())))
    }

    /// Returns the recorded values of a column at the beginning and at the end, in SI, and their direction.
    #[must_use]
    pub fn ends(&self, role: Role) -> Option<(Along, [f64; 2])> {
        let series = match role {
            Role::Position => self.recording.course.position.as_ref(),
            Role::Speed => self.recording.course.speed.as_ref(),
            Role::Torque => self.recording.torque.as_ref(),
            Role::Time => None,
        }?;
        Some((series.along, [*series.values.first()?, *series.values.last()?]))
    }

    /// Returns `true` if the recording is that of a motion along a line.
    #[must_use]
    pub fn is_along_a_line(&self) -> bool {
        let course = &self.recording.course;
        [&course.position, &course.speed].into_iter().flatten().any(|series| series.along == Along::Line)
    }

    /// Returns the spurious acceleration caused by the resolution of the samples, if it is significant.
    #[must_use]
    pub const fn made_up(&self) -> Option<MadeUp> {
        self.recorded.made_up()
    }
}

/// Returns the smallest, the median and the largest interval.
fn intervals(time_s: &[f64]) -> [f64; 3] {
    let mut all: Vec<f64> = time_s.windows(2).filter_map(|ends| Some(ends.last()? - ends.first()?)).collect();
    if all.is_empty() {
        return [0.0; 3];
    }
    let (least, most) = all.iter().fold((f64::INFINITY, 0.0_f64), |(least, most), h| (least.min(*h), most.max(*h)));
    let middle = all.len() / 2;
    let (_, median, _) = all.select_nth_unstable_by(middle, f64::total_cmp);
    [least, *median, most]
}

/// Effect of a window of smoothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SmoothingEffect {
    /// Width of the window; `None` without smoothing.
    pub window: Option<Time>,
    /// T_peak of the load, without the moment of inertia of the actuator; `None` if the axis is impossible with the window,
    /// e.g. because its cycle does not close.
    pub torque_peak: Option<Torque>,
    /// Largest acceleration of the recording by itself at the output [rad/s²], or [m/s²] along a line; `None` with a project, or
    /// if the window is too narrow or too wide.
    pub acceleration_peak: Option<f64>,
    /// The window reduces the spurious acceleration of steps to a twentieth of the motion's.
    pub is_proposed: bool,
}

/// Returns the width of a window of smoothing as a project states it: in milliseconds, with four digits.
#[must_use]
pub fn window_text(window: Time) -> String {
    let rounded = format!("{:.3e}", 1e3 * window.si()).parse::<f64>().unwrap_or_default();
    format!("{rounded} ms")
}

/// Returns the windows of smoothing worth a trial in ascending order: several numbers of samples, the one that steps
/// require, and the stated one; with `true` for the one that steps require. They have four digits in milliseconds.
fn windows(plain: &ExaminedRecording, stated: Option<Time>) -> Vec<(Time, bool)> {
    use motion::Spurious;
    let proposed = plain.made_up().and_then(|made_up| match made_up.cause {
        Spurious::Steps { smoothing_s, .. }
        | Spurious::Updates { smoothing_s }
        | Spurious::Noise { smoothing_s, .. } => smoothing_s,
        Spurious::Held { .. } | Spurious::Stamps { .. } => None,
    });
    let [_, interval, _] = plain.intervals_s;
    let is_short = |window: &f64| *window <= SHARE_MOST * plain.recorded.duration_s();
    let few = plain.recorded.len() <= TRIED_WITHIN;
    // Slightly more than an even multiple of the interval holds the same number of samples everywhere.
    let usual = WINDOWS.iter().filter(|_| few).map(|samples| (f64::from(*samples) - 0.5) * interval).filter(is_short);
    let short = |window_s: f64| parse_as::<Time>(&window_text(Time::from_si(window_s))).ok();
    let proposed = proposed.and_then(short);
    let mut found: Vec<Time> = usual.filter_map(short).chain(proposed).chain(stated).collect();
    found.sort_unstable_by(|one, other| one.si().total_cmp(&other.si()));
    found.dedup();
    found.into_iter().map(|window| (window, Some(window) == proposed)).collect()
}

/// Returns the effect of windows of smoothing on a recorded segment of a project, counted from zero: none, several numbers of samples,
/// the one that steps require, and the stated one. The torque follows if there is a project: the effect of a window depends
/// neither on the stated one nor, where the cycle does not close with it, on the closing.
#[must_use]
pub fn smoothing_effects(
    project: Option<(&AxisProject, usize)>,
    is_single: bool,
    plain: &ExaminedRecording,
    stated: Option<Time>,
    progress: &Progress,
) -> Vec<SmoothingEffect> {
    let tried = windows(plain, stated).into_iter().map(|(window, is_proposed)| (Some(window), is_proposed));
    let effect = |(window, is_proposed): (Option<Time>, bool)| {
        let smoothed = project.and_then(|(project, segment)| {
            let by = |is_single: bool| project.smoothed(segment, window, is_single);
            by(is_single).or_else(|| by(true))
        });
        let torque_peak = smoothed.map(|smoothed| smoothed.axis.demand(MomentOfInertia::from_si(0.0)).torque_peak);
        // Of a long recording it is found where there is no torque only.
        let acceleration_peak = if project.is_none() { plain.acceleration_peak(window, is_single) } else { None };
        SmoothingEffect { window, torque_peak, acceleration_peak, is_proposed }
    };
    std::iter::once((None, false)).chain(tried).take_while(|_| !progress.is_over()).map(effect).collect()
}
