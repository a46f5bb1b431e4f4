//! Side of the gear at which a recording was taken.

use crate::assumption::{Assumption, WindowEnd};
use crate::fault::AxisReport;
use crate::source::SegmentSource;
use project::sections::{Ratios, Segment, Stated, StatedField};
use project::{Fault, shortened};
use quantities::Measure;
use recording::{Along, Recording, Role, Series};

/// Longest heading in a fault, in characters.
const HEADING_SHOWN: usize = 60;

/// Ratios of the recorded shaft to the output, 1 where none is stated.
pub(crate) struct Side {
    position: f64,
    speed: f64,
    torque: f64,
}

impl Side {
    /// Returns the factor from the recorded quantity to that at the output.
    ///
    /// q = q_rec/i, ω = ω_rec/i, T = i T_rec
    ///
    /// # Symbols
    /// i ratio of the gear at which was recorded \[1\], negative if its input turns against the output
    /// # Valid
    /// for rotary quantities; the ratio belongs to the recorded machine, independent of the gears of the candidates
    pub(crate) fn factor(&self, role: Role) -> f64 {
        match role {
            Role::Time => 1.0,
            Role::Position => 1.0 / self.position,
            Role::Speed => 1.0 / self.speed,
            Role::Torque => self.torque,
        }
    }
}

/// Returns the stated ratio of a role.
fn stated(ratios: Option<&Ratios>, role: Role) -> Option<&Stated<f64>> {
    let ratios = ratios?;
    match role {
        Role::Time => None,
        Role::Position => Some(&ratios.position),
        Role::Speed => Some(&ratios.speed),
        Role::Torque => Some(&ratios.torque),
    }
}

/// Smallest and largest ratio without its sign.
const RATIO_BOUNDS: (f64, f64) = (1e-4, 1e4);

/// Largest ratio of a position or a speed: counts of an encoder for each revolution of the output.
const COUNTS_MOST: f64 = 1e10;

/// Roles with a side, and their keys.
const SIDED: [(Role, &str); 3] = [(Role::Position, "position"), (Role::Speed, "speed"), (Role::Torque, "torque")];

/// Returns `true` if a role has a rotary column.
fn turns(recording: &Recording, role: Role) -> bool {
    let series = match role {
        Role::Time => &None,
        Role::Position => &recording.course.position,
        Role::Speed => &recording.course.speed,
        Role::Torque => &recording.torque,
    };
    matches!(series, Some(Series { along: Along::Turning, .. }))
}

/// Returns the ratios of a recording; reports columns of the motor without one, and ratios without a column.
pub(crate) fn ratios(segment: SegmentSource<'_>, report: &mut AxisReport<'_>) -> Side {
    let stated = |role: Role| stated(segment.recorded_ratio.get(), role);
    let ratio = |role: Role| stated(role).and_then(Stated::value);
    for (role, _) in SIDED {
        let magnitude = (RATIO_BOUNDS.0, if role == Role::Torque { RATIO_BOUNDS.1 } else { COUNTS_MOST });
        if let Some(field) = stated(role).filter(|field| field.value().is_some_and(|ratio| ratio.abs() < magnitude.0)) {
            report.fault(field.span(), Fault::RatioTooSmall { path: field.path(), magnitude }, None);
        }
    }
    if let Some(read) = segment.recording {
        for (role, _) in SIDED {
            if let Some(field) = stated(role).filter(|field| field.is_given() && !turns(&read.recording, role)) {
                report.fault(field.span(), Fault::NoColumnWithRatio { path: field.path() }, None);
            }
        }
        let column = |role: Role| read.recording.columns.iter().find(|column| column.role == role);
        let unstated = |role: Role| {
            let heading = &column(role).filter(|_| turns(&read.recording, role))?.name;
            let is_stated = stated(role).is_some_and(StatedField::is_given);
            (!is_stated && recording::is_of_motor(heading)).then(|| shortened(heading, HEADING_SHOWN))
        };
        let headings: Vec<String> = SIDED.into_iter().filter_map(|(role, _)| unstated(role)).collect();
        if !headings.is_empty() {
            let line = SIDED.into_iter().filter(|(role, _)| ratio(*role).is_some() || unstated(*role).is_some());
            let ratios = line.map(|(role, key)| (key, ratio(role))).collect();
            let fault = Fault::MotorSide { name: read.file.clone(), headings, ratios };
            report.fault(segment.file.span(), fault, None);
        }
    }
    let ratio = |role: Role| ratio(role).unwrap_or(1.0);
    Side { position: ratio(Role::Position), speed: ratio(Role::Speed), torque: ratio(Role::Torque) }
}

/// Adds what the recordings of an axis leave open: the side of the gear, the origin of their speed, turns.
pub(crate) fn assumptions(segments: &[SegmentSource<'_>], found: &mut Vec<Assumption>) {
    let recordings = || segments.iter().filter_map(|segment| Some((segment.stated, &*segment.recording?.recording)));
    let stated = |segment: &Segment, role: Role| stated(segment.recorded_ratio.get(), role).and_then(Stated::value);
    let is_open = |(segment, recording): (&Segment, &Recording)| {
        SIDED.into_iter().any(|(role, _)| turns(recording, role) && stated(segment, role).is_none())
    };
    let of_motor = |(segment, _): (&Segment, &Recording)| {
        stated(segment, Role::Torque).is_some_and(|ratio| (ratio.abs() - 1.0).abs() > f64::EPSILON)
    };
    let is_alike = |(segment, _): (&Segment, &Recording)| {
        SIDED
            .into_iter()
            .filter_map(|(role, _)| stated(segment, role))
            .any(|ratio| ratio > 0.0 && (ratio - 1.0).abs() > f64::EPSILON)
    };
    let differences = |(segment, recording): (&Segment, &Recording)| {
        recording.course.speed.is_none() && !segment.smoothing.is_given()
    };
    found.extend(recordings().any(is_open).then_some(Assumption::RecordedAtOutput));
    found.extend(recordings().any(is_alike).then_some(Assumption::RecordedTurnsAlike));
    found.extend(recordings().any(of_motor).then_some(Assumption::RecordedTorqueOfMotor));
    found.extend(recordings().any(differences).then_some(Assumption::RecordedPositionDifferentiated));
    let is_modulo = |(_, recording): (&Segment, &Recording)| recording.revolutions_removed > 0;
    found.extend(recordings().any(is_modulo).then_some(Assumption::RecordedModulo));
    for end in recordings().flat_map(|(segment, recording)| window_ends(segment, recording)) {
        if !found.contains(&Assumption::RecordedWindow(end)) {
            found.push(Assumption::RecordedWindow(end));
        }
    }
}

/// Returns the ends of a window that lie beside the samples, which begin and end it.
fn window_ends(segment: &Segment, recording: &Recording) -> impl Iterator<Item = WindowEnd> + use<> {
    /// Largest distance of an end from a sample relative to the mean interval; a time is written with limited digits.
    const NEAR: f64 = 0.01;
    let duration_s = recording.time_s.last().copied().unwrap_or_default();
    #[allow(clippy::cast_precision_loss, reason = "counts of samples")]
    let interval_s = duration_s / (recording.time_s.len() as f64 - 1.0).max(1.0);
    let first_s = recording.first_time.si();
    let ends = [(true, segment.from.value(), first_s), (false, segment.to.value(), first_s + duration_s)];
    ends.into_iter().filter_map(move |(is_start, stated, used_s)| {
        let end = WindowEnd { is_start, stated_s: stated?.si(), used_s };
        ((end.stated_s - used_s).abs() > NEAR * interval_s).then_some(end)
    })
}
