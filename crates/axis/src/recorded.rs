//! Recordings converted to motion at the output.

use crate::along::turned;
use crate::fault::{AxisFault, AxisReport};
use crate::kept::RecordedUse;
use crate::mechanism::OF_A_LINE;
use crate::recordings::RecordingRead;
use crate::side::ratios;
use crate::source::SegmentSource;
use motion::{Recorded, RecordedFault, Samples, Treatment};
use project::sections::{Fields, HeldValues, OfKinds, Segment, StatedField, TimeStamps};
use project::{Fault, Hint};
use quantities::AngularVelocity;
use recording::{Along, Recording, Role, Series};
use std::sync::Arc;

/// Recorded motions of the segments of an axis: segments that use one recording alike share its motion.
pub(crate) struct RecordedMotions {
    /// The only segment is one recording, of a cycle that repeats.
    repeats: bool,
    uses: Vec<RecordedUse>,
}

impl RecordedMotions {
    /// Creates it without a motion; `repeats`: the only segment is a recording of a cycle that repeats.
    pub(crate) const fn of(repeats: bool) -> Self {
        Self { repeats, uses: Vec::new() }
    }

    /// Returns the motion of another segment with the same recording, ratios of its columns, and treatment.
    fn find(&self, of: &Arc<Recording>, factors: [f64; 3], by: &Treatment) -> Option<Arc<Recorded>> {
        let mut known = self.uses.iter();
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
    segment: SegmentSource<'_>,
    travel: Option<f64>,
    known: &mut RecordedMotions,
    report: &mut AxisReport<'_>,
) -> Option<Arc<Recorded>> {
    let before = report.fault_count();
    // Known without the recording.
    let standstill = turned(&segment.standstill, travel, report);
    let ratios = ratios(segment, report);
    let RecordingRead { file, recording, uses } = segment.recording?;
    let treatment = Treatment { repeats: known.repeats, ..treatment(&segment, standstill) };
    let factors = [Role::Position, Role::Speed, Role::Torque].map(|role| ratios.factor(role));
    if let Some(same) = known.find(recording, factors, &treatment).filter(|_| states_its_motion(&segment)) {
        return Some(same);
    }
    let is_same =
        |known: &RecordedUse| known.factors == factors && known.treatment == treatment && known.travel == travel;
    let kept = uses.as_ref().filter(|_| states_its_motion(&segment)).and_then(|uses| uses.motion(is_same));
    if let Some(motion) = kept {
        let recording = Arc::clone(recording);
        known.uses.push(RecordedUse { recording, factors, travel, treatment, motion: Arc::clone(&motion) });
        return Some(motion);
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
                let hint = Hint::Example(OF_A_LINE.to_owned());
                report.fault(segment.file.span(), Fault::NoLine { path: file.clone() }, Some(hint));
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
    if report.fault_count() > before {
        return None;
    }
    match Recorded::new(samples, treatment) {
        // A refused value has been reported; without it the motion is another one.
        Ok(_) | Err(RecordedFault::Contradiction { .. }) if !states_its_motion(&segment) => None,
        Ok(recorded) => {
            let motion = Arc::new(recorded);
            let recording = Arc::clone(recording);
            let made = RecordedUse { recording, factors, travel, treatment, motion: Arc::clone(&motion) };
            if let Some(uses) = uses {
                uses.keep_motion(made.clone());
            }
            known.uses.push(made);
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
            report.fault(span, AxisFault::Recorded { name: file.clone(), fault }, None);
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
            Some(HeldValues::Interpolate) => motion::HeldValues::Interpolated,
            None => motion::HeldValues::Kept,
        },
        time_stamps: match segment.time_stamps.value() {
            Some(TimeStamps::Even) => motion::TimeStamps::Even,
            None => motion::TimeStamps::Kept,
        },
        repeats: false,
    }
}

/// Returns `true` if no value of the motion of a segment was refused; its loads do not count.
pub(crate) fn states_its_motion(segment: &Segment) -> bool {
    let is_of_motion = |field: &&dyn StatedField| !Segment::VARIANTS.shared.contains(&field.name());
    segment.fields().into_iter().filter(is_of_motion).all(|field| field.is_given() || !field.is_written())
}
