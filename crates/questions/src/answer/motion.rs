//! The motion as a record.

use super::check::assumption;
use crate::moves::{Move, Moves};
use crate::setpoints::Setpoints;
use answers::{ColumnRole, Number, RecordedColumn, Recording, Segment, TextEncoding, UnitBy, Units};
use axis::{AxisProject, RecordingRead, SegmentLoadKey};
use quantities::unit::SECOND;
use quantities::{Language, Measure, Unit};
use recording::{Encoding, KnownBy, Role};
use words::law_text;

/// Returns every segment with stated and derived values.
#[must_use]
pub fn motion(moves: &Moves<'_>, setpoints: Option<answers::Setpoints>, language: Language) -> answers::Motion {
    let [distance, speed, acceleration] = moves.units;
    let mut units = vec![("time", &SECOND), ("distance", distance), ("speed", speed), ("acceleration", acceleration)];
    units.extend(moves.loads.iter().map(|load| (load.id(), load.unit())));
    answers::Motion {
        units: Units::of(&units),
        segments: moves.moves.iter().map(|each| segment(each, moves, language)).collect(),
        setpoints,
        assumptions: Vec::new(),
    }
}

/// Returns the motion of a project with the assumptions that concern it.
#[must_use]
pub fn motion_of(project: &AxisProject, setpoints: Option<answers::Setpoints>, language: Language) -> answers::Motion {
    let concerning = project.assumed().into_iter().filter(|each| each.assumption.concerns_motion());
    let assumptions = concerning.map(|each| assumption(each, language)).collect();
    answers::Motion { assumptions, ..motion(&crate::moves(project), setpoints, language) }
}

/// Returns the record of setpoints, of those in a file without their rows.
#[must_use]
pub fn setpoints(found: &Setpoints, file: Option<String>) -> answers::Setpoints {
    let [time, position, speed, acceleration] = found.units;
    let column = |place: usize, unit: &'static Unit| -> Vec<Number> {
        let rows = found.rows.iter().filter(|_| file.is_none());
        rows.filter_map(|row| Some(Number::in_unit(*row.get(place)?, unit))).collect()
    };
    answers::Setpoints {
        units: Units::of(&[("time", time), ("position", position), ("speed", speed), ("acceleration", acceleration)]),
        every: Number::in_unit(found.every.si(), time),
        rows: found.rows.len(),
        time: column(0, time),
        position: column(1, position),
        speed: column(2, speed),
        acceleration: column(3, acceleration),
        file,
    }
}

fn segment(each: &Move<'_>, moves: &Moves<'_>, language: Language) -> Segment {
    let [distance_unit, speed_unit, acceleration_unit] = moves.units;
    let course = each.course.map(|[distance, speed, acceleration]| {
        [(distance, distance_unit), (speed, speed_unit), (acceleration, acceleration_unit)]
            .map(|(si, unit)| Number::in_unit(si, unit))
    });
    let load = |load: SegmentLoadKey| {
        let (_, si) = moves.loads.iter().zip(&each.loads).find(|(known, _)| **known == load)?;
        Some(Number::in_unit(*si, load.unit()))
    };
    Segment {
        law: each.law.id(),
        name: law_text(each.law, language),
        start: Number::in_unit(each.start.si(), &SECOND),
        duration: Number::in_unit(each.duration.si(), &SECOND),
        distance: course.map(|[distance, ..]| distance),
        speed: course.map(|[_, speed, _]| speed),
        acceleration: course.map(|[.., acceleration]| acceleration),
        payload: load(SegmentLoadKey::Payload),
        payload_inertia: load(SegmentLoadKey::PayloadInertia),
        process_force: load(SegmentLoadKey::ProcessForce),
        external_torque: load(SegmentLoadKey::ExternalTorque),
        recording: each.recording.map(recording),
    }
}

fn recording(read: &RecordingRead) -> Recording {
    let recording = &read.recording;
    let columns = recording.columns.iter().map(|column| RecordedColumn {
        role: match column.role {
            Role::Time => ColumnRole::Time,
            Role::Position => ColumnRole::Position,
            Role::Speed => ColumnRole::Speed,
            Role::Torque => ColumnRole::Torque,
        },
        name: column.name.clone(),
        unit: column.unit.json,
        unit_by: match column.known_by {
            KnownBy::Header => UnitBy::Header,
            KnownBy::UnitRow => UnitBy::UnitRow,
            KnownBy::Metadata => UnitBy::Metadata,
            KnownBy::Values => UnitBy::Values,
            KnownBy::Layout => UnitBy::Project,
        },
    });
    Recording {
        file: read.file.clone(),
        encoding: recording.encoding.map(|encoding| match encoding {
            Encoding::Utf8 => TextEncoding::Utf8,
            Encoding::Utf16 => TextEncoding::Utf16,
            Encoding::Utf16Guessed => TextEncoding::Utf16Guessed,
            Encoding::Windows1252Guessed => TextEncoding::Windows1252Guessed,
        }),
        samples: recording.time_s.len(),
        first_time: Number::in_unit(recording.first_time.si(), &SECOND),
        left_out_before: recording.left_out_before,
        left_out_after: recording.left_out_after,
        comments: recording.comments,
        columns: columns.collect(),
        unused: recording.unused.clone(),
    }
}
