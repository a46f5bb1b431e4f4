//! Motion of an axis at the output, and the loads of its segments.

use crate::along::turned;
use crate::assumption::{Assumption, unstated};
use crate::cam::through_points;
use crate::choices;
use crate::driven::Driven;
use crate::fault::{AxisFault, AxisReport, CycleFault};
use crate::mechanism::{BuiltLoad, driven};
use crate::recorded::{RecordedMotions, motion as recorded_motion, states_its_motion};
use crate::side;
use crate::source::{AxisSource, SegmentSource};
use crate::web;
use mechanism::{Extra, Mechanism, MechanismKind, ScissorLift};
use motion::{Closing, Given, ManualMove, Motion, MotionFault, MoveFault, SegmentSpec, Unread};
use project::choices::{Law, Spline};
use project::sections::{Fields, Segment, Stated, StatedField};
use project::{Fault, Hint, SegmentLaw};
use quantities::{Angle, Dimension, Length, Measure, Time, Unit};
use sizing::Axis;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::ops::Range as Span;

impl SegmentSource<'_> {
    /// Returns `true` if it is a trapezoid that two quantities determine.
    fn has_thirds(&self) -> bool {
        let stated: [&dyn StatedField; 4] = [&self.distance, &self.time, &self.speed, &self.acceleration];
        let is_trapezoid = self.law.value() == Some(SegmentLaw::Law(Law::Trapezoid));
        is_trapezoid && stated.iter().filter(|field| field.is_given()).count() == 2
    }

    /// Returns `true` if its torque is recorded.
    fn has_torque(&self) -> bool {
        self.recording.is_some_and(|read| read.recording.torque.is_some())
    }

    /// Returns the columns of its recording that are not used and may hold a torque by their unit; without one all that are
    /// not used.
    fn torque_columns(&self) -> Vec<String> {
        let Some(read) = self.recording else { return Vec::new() };
        let unused = &read.recording.unused;
        let is_torque = |heading: &&String| {
            recording::name_and_unit(heading)
                .1
                .is_some_and(|unit| Unit::of_dimension(Dimension::Torque, &unit).is_some())
        };
        let of_unit: Vec<String> = unused.iter().filter(is_torque).cloned().collect();
        if of_unit.is_empty() { unused.clone() } else { of_unit }
    }

    /// Returns `true` if it states its motion along the line of the mechanism.
    fn is_along_a_line(&self) -> bool {
        self.fields().iter().any(|field| field.is_of_a_line())
    }

    /// Returns the place of the value that a fault is about.
    fn place(&self, fault: &MoveFault) -> Span<usize> {
        match fault {
            MoveFault::NoTimeToChangeSpeed { braking: true } => self.brake.span(),
            MoveFault::NoTimeToChangeSpeed { braking: false } => self.accelerate.span(),
            MoveFault::SpeedTooLow { .. } | MoveFault::SpeedTooHigh { .. } | MoveFault::EndSpeedAboveLimit => {
                self.speed.span()
            }
            MoveFault::AccelerationTooLow { .. } => self.acceleration.span(),
            MoveFault::PointsSpeedJumps { .. } => self.points.span(),
            MoveFault::OutOfRange => self.zero().unwrap_or_else(|| self.law.span()),
            MoveFault::NoSegment
            | MoveFault::NoDuration
            | MoveFault::NotDetermined { .. }
            | MoveFault::RestToRestOnly
            | MoveFault::StillMoving { .. }
            | MoveFault::RecordingSpeedJumps { .. }
            | MoveFault::RecordingPositionJumps { .. }
            | MoveFault::SpeedNotClosed { .. }
            | MoveFault::PositionNotClosed { .. } => self.law.span(),
        }
    }

    /// Returns the place of the first quantity that is stated as zero.
    fn zero(&self) -> Option<Span<usize>> {
        let is_zero = |si: Option<f64>| si == Some(0.0);
        let all = [
            (is_zero(self.distance.value().map(|value| value.si)), self.distance.span()),
            (is_zero(self.time.value().map(|value| value.si())), self.time.span()),
            (is_zero(self.speed.value().map(|value| value.si)), self.speed.span()),
            (is_zero(self.acceleration.value().map(|value| value.si)), self.acceleration.span()),
        ];
        all.into_iter().find(|(is_zero, _)| *is_zero).map(|(_, span)| span)
    }

    fn extra(&self, load: &BuiltLoad) -> Extra {
        Extra {
            mass: self.payload.or_zero(),
            inertia: self.payload_inertia.or_zero(),
            force: load.force + self.process_force.or_zero(),
            torque: self.process_torque.or_zero(),
        }
    }

    /// Returns true if the segment ends at rest, whatever its quantities are.
    fn ends_at_rest(&self) -> bool {
        match self.law.value() {
            Some(SegmentLaw::Manual | SegmentLaw::Dwell | SegmentLaw::Web) => true,
            Some(SegmentLaw::Law(law)) => law != Law::Constant && !self.end_speed.is_written(),
            Some(SegmentLaw::Open) => !self.end_speed.is_written(),
            Some(SegmentLaw::Recorded | SegmentLaw::Points) | None => false,
        }
    }

    /// Returns the segment at the output; `travel`: linear travel per angle \[m/rad\] of a linear mechanism, `kind`: its
    /// equations, unless the load is faulty.
    fn spec(
        &self,
        (travel, kind, is_winder): (Option<f64>, Option<&MechanismKind>, bool),
        (known, lift): (&mut RecordedMotions, &mut LiftPosition<'_>),
        report: &mut AxisReport<'_>,
    ) -> Option<SegmentSpec> {
        if self.law.value() == Some(SegmentLaw::Web) {
            let run = web::run(self, (kind, is_winder), report)?;
            return states_its_motion(self).then_some(SegmentSpec::Points(run));
        }
        let before = report.fault_count();
        let given = Given {
            distance: lift.turned(self, travel, report),
            time: self.time.value(),
            speed: turned(&self.speed, travel, report),
            acceleration: turned(&self.acceleration, travel, report),
            jerk: turned(&self.jerk, travel, report),
            end_speed: turned(&self.end_speed, travel, report),
        };
        let is_readable = report.fault_count() == before;
        let law = self.law.value()?;
        // Their own faults do not depend on the keys of a law.
        let read = match law {
            SegmentLaw::Points => through_points(self, given.end_speed, travel, report).map(SegmentSpec::Points),
            SegmentLaw::Recorded => recorded_motion(*self, travel, known, report).map(SegmentSpec::Recorded),
            SegmentLaw::Manual | SegmentLaw::Dwell | SegmentLaw::Law(_) | SegmentLaw::Open | SegmentLaw::Web => None,
        };
        if !is_readable {
            return None;
        }
        match law {
            SegmentLaw::Manual => Some(SegmentSpec::Manual(ManualMove {
                speed: given.speed?,
                accelerate: self.accelerate.value()?,
                run: self.run.value()?,
                brake: self.brake.value()?,
                pause: self.pause.value()?,
            })),
            SegmentLaw::Points | SegmentLaw::Recorded => read,
            // A dwell that fills the cycle gets its duration when those of the others are known.
            SegmentLaw::Dwell if self.cycle.is_written() && !self.time.is_written() => {
                self.cycle.value().map(|_| SegmentSpec::Dwell(Time::from_si(0.0), choices::hold(self.hold())))
            }
            SegmentLaw::Dwell => Some(SegmentSpec::Dwell(given.time?, choices::hold(self.hold()))),
            // A refused value has been reported; without it the move would only appear undetermined.
            SegmentLaw::Law(_) | SegmentLaw::Open => {
                let law = choices::law(law.of_a_move()?);
                let turn =
                    given.speed.filter(|_| turns_once(self)).map(|speed| Angle::from_si(TAU.copysign(speed.si())));
                let given = Given { distance: given.distance.or(turn), ..given };
                states_its_motion(self).then_some(SegmentSpec::Move(law, given))
            }
            SegmentLaw::Web => None,
        }
    }
}

/// Position of a scissor lift from segment to segment: the turns of the screw for a stroke of the platform depend on it.
struct LiftPosition<'l> {
    lift: Option<&'l ScissorLift>,
    /// Position of the screw \[rad\]; `None` behind a segment whose distance follows from other quantities.
    position_rad: Option<f64>,
}

impl LiftPosition<'_> {
    /// Converts the distance of a segment to the output, and follows it.
    fn turned(
        &mut self,
        segment: &SegmentSource<'_>,
        travel: Option<f64>,
        report: &mut AxisReport<'_>,
    ) -> Option<Angle> {
        let Some(lift) = self.lift else { return turned(&segment.distance, travel, report) };
        let place = segment.distance.span();
        let angle = match segment.distance.value() {
            Some(stated) if stated.is_of_a_line => match self.position_rad {
                Some(position) => match lift.turned(position, Length::from_si(stated.si)) {
                    Ok(angle) => Some(Angle::from_si(angle)),
                    Err(possible_m) => {
                        report.fault(place, Fault::StrokeBeyond { possible_m }, None);
                        None
                    }
                },
                None => {
                    let whole = lift.stroke().si();
                    let is_possible = stated.si.abs() <= whole;
                    let beyond = Fault::StrokeBeyond { possible_m: [-whole, whole] };
                    report.fault(place, if is_possible { Fault::StrokeFromUnknown } else { beyond }, None);
                    None
                }
            },
            Some(stated) => Some(Angle::from_si(stated.si)),
            None => None,
        };
        let is_still = segment.law.value() == Some(SegmentLaw::Dwell);
        self.position_rad = match angle {
            Some(angle) => self.position_rad.map(|position| position + angle.si()),
            None => self.position_rad.filter(|_| is_still),
        };
        angle
    }
}

/// Returns `true` if a segment has a constant speed without duration and distance: it is one revolution.
pub(crate) fn turns_once(segment: &Segment) -> bool {
    let is_constant = segment.law.value() == Some(SegmentLaw::Law(Law::Constant));
    is_constant && !segment.time.is_written() && !segment.distance.is_written()
}

/// Builds the motion, and the loads that each segment adds.
pub(crate) fn motion(axis: &AxisSource, load: &BuiltLoad, report: &mut AxisReport<'_>) -> Option<(Motion, Vec<Extra>)> {
    // A missing motion has been reported.
    let _ = axis.parts.motion.get()?;
    let segments = axis.sources();
    let travel = load.mechanism.travel_m_per_rad();
    if web::is_along_a_web(axis.segments(), &load.mechanism.kind, report) {
        report_all(axis, Some(1.0), report);
        return None;
    }
    let specs = specs(axis, (travel, Some(&load.mechanism.kind)), report);
    let Some(mut whole) = specs.iter().cloned().collect::<Option<Vec<SegmentSpec>>>() else {
        report_readable(axis, specs, travel, report);
        return None;
    };
    let closing = if axis.single_move { Closing::SingleMove } else { Axis::closing(&load.mechanism) };
    let chained = |whole: &[SegmentSpec], report: &mut AxisReport<'_>| {
        Motion::new(whole, load.start, closing).map_err(|faults| report_chain(axis, faults, travel, report)).ok()
    };
    let mut motion = chained(&whole, report)?;
    if let Some((place, rest)) = rest_of_cycle(&segments, motion.duration(), report)? {
        if let Some(SegmentSpec::Dwell(time, _)) = whole.get_mut(place) {
            *time = rest;
        }
        motion = chained(&whole, report)?;
    }
    let place_of_all = || axis.parts.motion.span();
    let place = |index: usize| segments.get(index).map_or_else(place_of_all, |segment| segment.law.span());
    if let Some(found) = Axis::too_many_instants(&load.mechanism, &motion) {
        report.fault(place(found.segment), AxisFault::Instants(found), None);
        return None;
    }
    let beyond = beyond_range(&load.mechanism, &motion);
    for (segment, fault) in &beyond {
        report.fault(place(*segment), fault.clone(), None);
    }
    beyond.is_empty().then(|| (motion, segments.iter().map(|segment| segment.extra(load)).collect()))
}

/// Returns the dwell that fills the cycle with its duration, if there is one; `others`: duration of all other segments.
/// `None` after a fault.
fn rest_of_cycle(
    segments: &[SegmentSource<'_>],
    others: Time,
    report: &mut AxisReport<'_>,
) -> Option<Option<(usize, Time)>> {
    let mut filling = segments.iter().enumerate().filter(|(_, segment)| segment.cycle.is_given());
    let Some((place, segment)) = filling.next() else { return Some(None) };
    let cycle = segment.cycle.value()?;
    if others.si() > cycle.si() {
        report.fault(segment.cycle.span(), AxisFault::Cycle(CycleFault::TooShort { others, cycle }), None);
        return None;
    }
    Some(Some((place, cycle - others)))
}

/// Reports the dwells that state neither a duration nor the cycle, or both, or fill the cycle a second time.
fn report_dwells(segments: &[SegmentSource<'_>], report: &mut AxisReport<'_>) {
    let mut is_filled = false;
    for segment in segments.iter().filter(|segment| segment.law.value() == Some(SegmentLaw::Dwell)) {
        match (segment.time.is_written(), segment.cycle.is_written()) {
            (false, false) => {
                report.fault(segment.law.span(), Fault::MissingKey { path: segment.time.path(), list: false }, None);
            }
            (true, true) => report.fault(segment.cycle.span(), AxisFault::Cycle(CycleFault::WithTime), None),
            (false, true) if is_filled => report.fault(segment.cycle.span(), AxisFault::Cycle(CycleFault::Twice), None),
            (false, true) => is_filled = true,
            (true, false) => {}
        }
    }
}

/// Reports the faults of a motion whose load is faulty: those that depend on the kind of the load alone, neither on its
/// values nor on the end of the cycle.
pub(crate) fn without_load(axis: &AxisSource, report: &mut AxisReport<'_>) {
    // A length counts as an angle, and is converted back where a fault shows it.
    let is_lift = |driven: &dyn Driven| driven.head().path.ends_with("mechanism.scissor_lift");
    let travel = driven(&axis.parts).is_none_or(|driven| driven.travel().is_some() || is_lift(driven)).then_some(1.0);
    report_all(axis, travel, report);
}

/// Reports the faults of all segments, apart from those of their end.
fn report_all(axis: &AxisSource, travel: Option<f64>, report: &mut AxisReport<'_>) {
    let specs = specs(axis, (travel, None), report);
    report_readable(axis, specs, travel, report);
}

/// Reports the faults of segments some of which are faulty (`None`), apart from those of their end.
fn report_readable(
    axis: &AxisSource,
    specs: Vec<Option<SegmentSpec>>,
    travel: Option<f64>,
    report: &mut AxisReport<'_>,
) {
    // A file whose text cannot be read may have its motion behind the fault.
    if specs.is_empty() {
        return;
    }
    let unread =
        |segment: &SegmentSource<'_>| if segment.ends_at_rest() { Unread::EndsAtRest } else { Unread::EndsMoving };
    let segments = axis.sources().into_iter().zip(specs).map(|(segment, spec)| spec.ok_or_else(|| unread(&segment)));
    let start = driven(&axis.parts).and_then(Driven::start_angle);
    let mut faults = Motion::faults(&segments.collect::<Vec<_>>(), start.and_then(Stated::value));
    // A recording is placed by the refused angle.
    if start.is_some_and(|start| start.is_written() && !start.is_given()) {
        faults.retain(|each| !matches!(each.fault, MoveFault::RecordingPositionJumps { .. }));
    }
    report_chain(axis, faults, travel, report);
}

/// Builds the segments, `None` for a faulty one, and reports those of their keys that have no effect on the load.
fn specs(
    axis: &AxisSource,
    of: (Option<f64>, Option<&MechanismKind>),
    report: &mut AxisReport<'_>,
) -> Vec<Option<SegmentSpec>> {
    let segments = axis.sources();
    web::alone(axis.segments(), report);
    let is_winder = driven(&axis.parts).is_none_or(|driven| driven.head().path.ends_with("mechanism.winder"));
    let of = (of.0, of.1, is_winder);
    let mut recorded = RecordedMotions::of(!axis.single_move && segments.len() == 1);
    let lift = match of.1 {
        Some(MechanismKind::ScissorLift(lift)) => Some(lift),
        _ => None,
    };
    let mut lift = LiftPosition { lift, position_rad: Some(0.0) };
    report_dwells(&segments, report);
    let specs: Vec<Option<SegmentSpec>> =
        segments.iter().map(|segment| segment.spec(of, (&mut recorded, &mut lift), report)).collect();
    if let Some(driven) = driven(&axis.parts) {
        for segment in &segments {
            without_effect(segment, driven, report);
            if driven.torque_is_recorded() && !segment.has_torque() && states_its_motion(segment) {
                let fault = Fault::JointWithoutTorque { columns: segment.torque_columns() };
                report.fault(segment.law.span(), fault, None);
            }
        }
    }
    specs
}

/// Reports the faults of a chain of segments.
fn report_chain(axis: &AxisSource, faults: Vec<MotionFault>, travel: Option<f64>, report: &mut AxisReport<'_>) {
    let segments = axis.sources();
    let recorded = segments.iter().any(|segment| segment.law.value() == Some(SegmentLaw::Recorded));
    for MotionFault { segment, fault } in faults {
        let unclosed = recorded && matches!(fault, MoveFault::SpeedNotClosed { .. });
        let hint = unclosed.then_some(Hint::CloseTheRecording);
        let segment = segment.and_then(|index| segments.get(index));
        let span = segment.map_or_else(|| axis.parts.motion.span(), |segment| segment.place(&fault));
        let along =
            segment.map_or_else(|| segments.iter().any(SegmentSource::is_along_a_line), SegmentSource::is_along_a_line);
        let travel_m_per_rad = travel.filter(|_| along);
        report.fault(span, AxisFault::Move { fault, travel_m_per_rad }, hint);
    }
}

/// Returns the segments in which the motion leaves the range of the mechanism.
fn beyond_range(mechanism: &Mechanism, motion: &Motion) -> Vec<(usize, Fault)> {
    let Some((low, high)) = mechanism.range_rad() else { return Vec::new() };
    let ratio = mechanism.stage_ratio();
    // A segment begins at the end of the one before it.
    let first = motion.pieces().first().map(|piece| (piece.segment, piece.at(0.0).position_rad));
    let of_pieces = motion.pieces().iter().filter(|piece| !piece.is_rest()).flat_map(|piece| {
        let turns = piece.reversals().into_iter().chain([piece.duration_s]);
        turns.map(|t| (piece.segment, piece.at(t).position_rad)).collect::<Vec<_>>()
    });
    let of_recordings = motion
        .recordings()
        .iter()
        .flat_map(|placed| placed.recorded.position_rad().iter().map(|q| (placed.segment, q + placed.offset_rad)));
    let mut found: BTreeMap<usize, f64> = BTreeMap::new();
    // The last turn may end at the end of the range, up to rounding.
    let slack = 1e-9 * (1.0 + low.abs().min(high.abs()));
    for (segment, q) in first.into_iter().chain(of_pieces).chain(of_recordings) {
        let excess = |q: f64| (low - q).max(q - high);
        if excess(q) <= slack {
            continue;
        }
        let worst = found.entry(segment).or_insert(q);
        if excess(q) > excess(*worst) {
            *worst = q;
        }
    }
    let of_mechanism = |q: f64| q / ratio;
    let (from, to) = (of_mechanism(low), of_mechanism(high));
    let range_rad = (from.min(to), from.max(to));
    let fault = |(segment, q)| (segment, Fault::BeyondRange { position_rad: of_mechanism(q), range_rad });
    found.into_iter().map(fault).collect()
}

/// Reports a payload that no part carries and a force without a line, which would otherwise be ignored silently.
fn without_effect(segment: &SegmentSource<'_>, driven: &dyn Driven, report: &mut AxisReport<'_>) {
    let (carries, turns, has_line) = (driven.carries(), !driven.torque_is_recorded(), driven.process_force().is_some());
    let of_payload: &[&str] = if turns { &["payload_inertia", "payload_distance"] } else { &["process_torque"] };
    let fields: [(&dyn StatedField, bool, &[&str]); 3] = [
        (&segment.payload, carries, of_payload),
        (&segment.payload_inertia, turns, &["process_torque"]),
        (&segment.process_force, has_line, &["process_torque"]),
    ];
    for (field, _, instead) in fields.into_iter().filter(|(field, effect, _)| field.is_given() && !effect) {
        report.fault(field.span(), Fault::WithoutEffect { key: field.name() }, Some(Hint::instead(instead)));
    }
}

/// Adds the defaults about the motion that the file leaves open.
pub(crate) fn assumptions(axis: &AxisSource, driven: Option<&dyn Driven>, found: &mut Vec<Assumption>) {
    let segments = axis.sources();
    if segments.iter().any(SegmentSource::has_thirds) {
        found.push(Assumption::TrapezoidThirds);
    }
    if segments.iter().any(|segment| segment.law.value() == Some(SegmentLaw::Open)) {
        found.push(Assumption::LawOpen);
    }
    if axis.segments().iter().any(turns_once) {
        found.push(Assumption::OneRevolution);
    }
    if axis.segments().iter().any(web::has_assumed_ramps) {
        found.push(Assumption::WebRamps);
    }
    if axis.single_move {
        found.push(Assumption::SingleMoveRepeats);
    }
    if !driven.is_some_and(Driven::torque_is_recorded) && segments.iter().any(SegmentSource::has_torque) {
        found.push(Assumption::RecordedTorqueAdds);
    }
    let splines = Spline::ALL.into_iter().filter(|each| segments.iter().any(|one| one.spline.value() == Some(*each)));
    found.extend(splines.map(|each| Assumption::SplineThroughPoints(choices::spline(each))));
    side::assumptions(&segments, found);
    let rests = |segment: &&SegmentSource<'_>| segment.law.value() == Some(SegmentLaw::Dwell);
    found.extend(segments.iter().filter(rests).find_map(|segment| unstated(&segment.hold)));
    let carries =
        |one: &SegmentSource<'_>| one.payload.or_zero().si() > 0.0 || one.payload_inertia.or_zero().si() > 0.0;
    let is_silent = |one: &SegmentSource<'_>| !one.payload.is_given() && !one.payload_inertia.is_given();
    // A cycle repeats: its first segment follows the last.
    let next = segments.iter().skip(1).chain(segments.first().filter(|_| !axis.single_move));
    if segments.iter().zip(next).any(|(before, dwell)| rests(&dwell) && carries(before) && is_silent(dwell)) {
        found.push(Assumption::NoPayloadInDwell);
    }
    let has_bodies = driven.is_some_and(|driven| driven.bodies().is_some());
    let has_payload = segments.iter().any(|segment| segment.payload.or_zero().si() > 0.0);
    if has_bodies && has_payload {
        found.push(Assumption::PayloadTowardsCentre);
    }
    found.extend(driven.map(|driven| driven.assumptions(has_payload)).unwrap_or_default());
}
