//! Recordings that a project file refers to: found, read and turned into motion at the output.

use crate::read::{Reader, shortened};
use crate::section::{Entry, Section};
use crate::{Fault, Hint};
use motion::{Recorded, RecordedFault, Samples, Treatment};
use quantities::{Dimension, Measure, Time, Unit};
use recording::{Along, Bytes, ColumnSpec, Layout, Recording};
use std::io::Read;
use std::sync::Arc;

/// Largest Parquet file that is read, in bytes; of a CSV only a bounded part is held at any time.
const PARQUET_BYTES_MAX: u64 = 1 << 30;

/// Longest excerpt of a unit in a fault, in characters.
const UNIT_SHOWN: usize = 40;

/// The word in `columns` for a role that no column has.
const NO_COLUMN: &str = "none";

/// The files that a project refers to, handed in by the face.
pub trait Files {
    /// Opens a file by the name that the project gives it.
    ///
    /// # Errors
    /// What stands in the way.
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>>;
}

/// No files at all: a project that refers to one is refused.
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
    /// The name that the project gives.
    pub file: String,
    /// What was read.
    pub recording: Arc<Recording>,
}

/// Reads every recording of the motion; what is read stands in the place of the name.
pub(crate) fn resolve(root: &mut Section, files: &dyn Files, reader: &mut Reader<'_>) {
    for section in root.tables_mut("motion") {
        if section.text("law") != Some("recorded") || !section.is_whole() {
            continue;
        }
        let Some(name) = section.text("file").map(str::to_owned) else { continue };
        let span = section.span_of("file");
        let before = reader.fault_count();
        let layout = layout(section, reader);
        if reader.fault_count() > before {
            section.refuse("file");
            continue;
        }
        match read(&name, &layout, files) {
            Ok(recording) => {
                let read = RecordingRead { file: name, recording: Arc::new(recording) };
                section.replace("file", Entry::Recording(read));
            }
            Err(Trouble::File(error)) => {
                let trouble = (&error).into();
                reader.fault(span, Fault::File { name, trouble }, None);
                section.refuse("file");
            }
            Err(Trouble::Content(faults)) => {
                for fault in faults {
                    reader.fault(span.clone(), Fault::Recording { name: name.clone(), fault }, None);
                }
                section.refuse("file");
            }
        }
    }
}

enum Trouble {
    File(std::io::Error),
    Content(Vec<recording::Fault>),
}

fn read(name: &str, layout: &Layout, files: &dyn Files) -> Result<Recording, Trouble> {
    let mut source = files.open(name).map_err(Trouble::File)?;
    if name.to_ascii_lowercase().ends_with(".parquet") {
        let mut bytes = Vec::new();
        source.take(PARQUET_BYTES_MAX + 1).read_to_end(&mut bytes).map_err(Trouble::File)?;
        if bytes.len() as u64 > PARQUET_BYTES_MAX {
            return Err(Trouble::File(std::io::ErrorKind::FileTooLarge.into()));
        }
        return recording::read_parquet(Bytes::from(bytes), layout).map_err(Trouble::Content);
    }
    recording::read_csv(&mut source, layout).map_err(Trouble::Content)
}

fn layout(section: &Section, reader: &mut Reader<'_>) -> Layout {
    let mut column = |role: &str, dimensions: &[Dimension]| {
        let name = section.table("columns").and_then(|columns| columns.text(role));
        let unit = section.table("units").and_then(|units| {
            let written = units.text(role)?;
            let found = dimensions.iter().find_map(|dimension| Unit::of_dimension(*dimension, written));
            if found.is_none() {
                let known: Vec<&str> =
                    dimensions.iter().flat_map(|dimension| dimension.units().iter().map(|unit| unit.ascii)).collect();
                let fault = Fault::UnknownUnit { written: shortened(written, UNIT_SHOWN) };
                reader.fault(units.span_of(role), fault, Some(Hint::valid(&known)));
            }
            found
        });
        ColumnSpec {
            name: name.filter(|name| *name != NO_COLUMN).map(str::to_owned),
            unit,
            unused: name == Some(NO_COLUMN),
        }
    };
    Layout {
        time: column("time", &[Dimension::Time]),
        position: column("position", &[Dimension::Angle, Dimension::Length]),
        speed: column("speed", &[Dimension::AngularVelocity, Dimension::Velocity]),
        torque: column("torque", &[Dimension::Torque, Dimension::Force]),
        from: section.quantity("from"),
        to: section.quantity("to"),
        allow_gaps: section.text("gaps") == Some("allow"),
    }
}

/// The recorded motion of a segment at the output; `None` where a fault stands in the way.
///
/// `travel`: way along the line per angle [m/rad], where the mechanism has one.
pub(crate) fn motion(section: &Section, travel: Option<f64>, reader: &mut Reader<'_>) -> Option<Arc<Recorded>> {
    let Some(Entry::Recording(RecordingRead { file, recording })) = section.get("file") else { return None };
    let mut turned = |along: Along, values: &[f64], per_metre: bool| -> Option<Vec<f64>> {
        let factor = match (along, travel) {
            (Along::Turning, _) => return Some(values.to_vec()),
            (Along::Line, Some(travel)) if per_metre => 1.0 / travel,
            (Along::Line, Some(travel)) => travel,
            (Along::Line, None) => {
                reader.fault(section.span_of("file"), Fault::NoLine { path: file.clone() }, None);
                return None;
            }
        };
        Some(values.iter().map(|value| value * factor).collect())
    };
    let position = recording.course.position.as_ref().map(|series| turned(series.along, &series.values, true));
    let speed = recording.course.speed.as_ref().map(|series| turned(series.along, &series.values, true));
    let torque = recording.torque.as_ref().map(|effort| turned(effort.along, &effort.values, false));
    if [&position, &speed, &torque].into_iter().any(|column| matches!(column, Some(None))) {
        return None;
    }
    let samples = Samples {
        time_s: recording.time_s.clone(),
        position_rad: position.flatten(),
        speed_rad_s: speed.flatten(),
        torque_nm: torque.flatten(),
    };
    let standstill = match (section.along("standstill"), travel) {
        (Some((Dimension::Velocity, si)), Some(travel)) => Some(si / travel),
        (Some((Dimension::Velocity, _)), None) => {
            reader.fault(section.span_of("standstill"), Fault::NoLine { path: "standstill".to_owned() }, None);
            return None;
        }
        (found, _) => found.map(|(_, si)| si),
    };
    let treatment =
        Treatment { smoothing: section.quantity::<Time>("smoothing"), standstill: standstill.map(Measure::from_si) };
    match Recorded::new(samples, treatment) {
        Ok(recorded) => Some(Arc::new(recorded)),
        Err(fault) => {
            let key = match fault {
                RecordedFault::WindowTooShort { .. } | RecordedFault::WindowTooLong { .. } => "smoothing",
                _ => "file",
            };
            reader.fault(section.span_of(key), Fault::Recorded { name: file.clone(), fault }, None);
            None
        }
    }
}

/// The recordings of the motion, in order.
pub(crate) fn all(root: &Section) -> Vec<RecordingRead> {
    root.tables("motion")
        .iter()
        .filter_map(|section| match section.get("file") {
            Some(Entry::Recording(read)) => Some(read.clone()),
            _ => None,
        })
        .collect()
}
