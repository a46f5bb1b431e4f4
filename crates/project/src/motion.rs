//! Segments of the motion: their keys, the laws with their keys, and the motion at the output.

use crate::about::About;
use crate::cam::{CamEnds, CamPoint};
use crate::flange::{FlangeLoads, needs};
use crate::key::Variants;
use crate::mechanism::{Driven, Load};
use crate::read::Reader;
use crate::recorded::{Columns, File, Gaps, HeldValues, Ratios, RecordedMotions, TimeStamps, Units};
use crate::root::AxisSection;
use crate::section::{Fields, OfKinds, Section, names, section};
use crate::stated::{Stated, StatedField};
use crate::value::{Along, Rows, Turning, WordChoice, choice, choices, choices_by_id};
use crate::{Assumption, Fault, Hint, Project};
use ::motion::{
    Closing, EndState, Ends, Given, Hold, Law, ManualMove, Motion, MotionFault, MoveFault, Points, PointsFault,
    SegmentSpec, Spline, Unread,
};
use mechanism::{Extra, Mechanism};
use quantities::{
    Angle, AngularAcceleration, AngularJerk, AngularVelocity, Dimension, Force, Mass, Measure, MomentOfInertia, Time,
    Torque,
};
use sizing::Axis;
use std::ops::Range as Span;
use std::sync::Arc;

section! {
    /// A segment of the motion.
    Segment, SegmentName of About::Segment {
        law: SegmentLaw => needed;
        speed: Along<AngularVelocity> => stretches(-1, 1);
        accelerate: Time => not_negative, stretches(1, 0);
        run: Time => not_negative, stretches(1, 0);
        brake: Time => not_negative, stretches(1, 0);
        pause: Time => not_negative, stretches(1, 0);
        distance: Along<Angle> => stretches(0, 1);
        time: Time => not_negative, stretches(1, 0);
        acceleration: Along<AngularAcceleration> => positive, stretches(-2, 1);
        jerk: Along<AngularJerk> => positive, stretches(-3, 1);
        end_speed: Along<AngularVelocity> => stretches(-1, 1);
        hold: Hold = Hold::Motor => noted(Assumption::MotorHolds);
        file: File => example("lift.csv");
        columns: Columns;
        units: Units;
        recorded_ratio: Ratios;
        from: Time;
        to: Time;
        smoothing: Time => positive, example("20 ms");
        standstill: Along<AngularVelocity> => positive, example("0.1 1/min");
        gaps: Gaps;
        held_values: HeldValues;
        time_stamps: TimeStamps;
        payload: Mass => not_negative;
        payload_inertia: MomentOfInertia => not_negative;
        process_force: Force;
        process_torque: Torque;
        bearing: FlangeLoads;
        points: Rows<CamPoint> => example("[[\"0 s\", \"0 deg\"], [\"0.2 s\", \"30 deg\"], [\"0.5 s\", \"90 deg\"]]");
        master_speed: AngularVelocity => positive;
        spline: Spline;
        ends: CamEnds;
        start_speed: Along<AngularVelocity>;
        start_acceleration: Along<AngularAcceleration>;
        end_acceleration: Along<AngularAcceleration>;
    }
}

/// Word, law, required keys, optional keys in addition to those of every segment.
type LawLine = (&'static str, SegmentLaw, &'static [&'static str], &'static [&'static str]);

/// Keys of which any two determine a move from rest to rest.
const MOVE: &[&str] = names!(Segment: distance time speed acceleration);
const MOVE_ON: &[&str] = names!(Segment: distance time speed acceleration end_speed);

/// The laws of motion.
#[rustfmt::skip] // one line per law
const LAWS: [LawLine; 14] = [
    ("manual", SegmentLaw::Manual, names!(Segment: speed accelerate run brake pause), &[]),
    ("trapezoid", SegmentLaw::Law(Law::Trapezoid), &[], MOVE_ON),
    ("triangle", SegmentLaw::Law(Law::Triangle), &[], MOVE),
    ("jerk", SegmentLaw::Law(Law::Jerk), names!(Segment: distance speed acceleration jerk), names!(Segment: end_speed)),
    ("polynomial_5", SegmentLaw::Law(Law::Polynomial5), &[], MOVE_ON),
    ("modified_sine", SegmentLaw::Law(Law::ModifiedSine), &[], MOVE),
    ("modified_trapezoid", SegmentLaw::Law(Law::ModifiedTrapezoid), &[], MOVE),
    ("simple_sine", SegmentLaw::Law(Law::SimpleSine), &[], MOVE),
    ("inclined_sine", SegmentLaw::Law(Law::InclinedSine), &[], MOVE),
    // VDI 2143 uses this name for the triangle.
    ("parabola", SegmentLaw::Law(Law::Triangle), &[], MOVE),
    ("constant", SegmentLaw::Law(Law::Constant), names!(Segment: speed), names!(Segment: time distance)),
    ("dwell", SegmentLaw::Dwell, names!(Segment: time), names!(Segment: hold)),
    ("recorded", SegmentLaw::Recorded, names!(Segment: file), names!(Segment: columns units recorded_ratio from to smoothing standstill gaps held_values time_stamps)),
    ("points", SegmentLaw::Points, names!(Segment: points spline ends), names!(Segment: master_speed start_speed end_speed start_acceleration end_acceleration)),
];

impl OfKinds for Segment {
    #[allow(clippy::indexing_slicing, reason = "read while compiling: an index out of bounds does not compile")]
    const VARIANTS: &'static Variants = &Variants {
        keys: Self::KEYS,
        by: "law",
        kinds: &{
            let mut kinds: [(&str, &[&str], &[&str]); LAWS.len()] = [("", &[], &[]); LAWS.len()];
            let mut index = 0;
            while index < LAWS.len() {
                kinds[index] = (LAWS[index].0, LAWS[index].2, LAWS[index].3);
                index += 1;
            }
            kinds
        },
        shared: names!(Segment: payload payload_inertia process_force process_torque bearing),
    };
}

/// Law of a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SegmentLaw {
    /// A law of motion.
    Law(Law),
    /// The manual's move: a trapezoid with a pause.
    Manual,
    /// Rest.
    Dwell,
    /// A recording.
    Recorded,
    /// A spline through the points of a cam table.
    Points,
}

impl SegmentLaw {
    /// Returns the identifier used in project files and data exchange.
    #[must_use]
    pub fn id(self) -> &'static str {
        LAWS.iter().find(|(_, law, ..)| *law == self).map_or("", |(word, ..)| word)
    }

    /// Iterates over every law, in the order of the project file.
    pub fn all() -> impl Iterator<Item = Self> {
        LAWS.iter().filter(|(word, law, ..)| law.id() == *word).map(|(_, law, ..)| *law)
    }

    /// Returns `true` if a move by this law can be stretched in time and distance by its keys.
    #[must_use]
    pub fn stretches(self) -> bool {
        let needed = LAWS.iter().find(|(_, law, ..)| *law == self).map_or(&[][..], |(_, _, needed, _)| needed);
        let grows = |name: &&str| Segment::KEYS.iter().any(|key| key.name == *name && key.stretches.is_some());
        needed.iter().all(grows)
    }

    /// Returns a move of one radian in one second, from rest to rest if the law allows it, for its picture; `None` for
    /// a recording. Limited jerk is shown in thirds, the manual's move with a pause of the length of its run and ramps.
    #[must_use]
    pub fn sample(self) -> Option<SegmentSpec> {
        let second = Time::from_si;
        let far = Given { distance: Some(Angle::from_si(1.0)), ..Given::default() };
        let long = Given { time: Some(second(1.0)), ..Given::default() };
        match self {
            Self::Law(Law::Jerk) => Some(SegmentSpec::Move(
                Law::Jerk,
                Given {
                    speed: Some(AngularVelocity::from_si(1.5)),
                    acceleration: Some(AngularAcceleration::from_si(6.0)),
                    jerk: Some(AngularJerk::from_si(54.0)),
                    ..far
                },
            )),
            Self::Law(Law::Constant) => {
                Some(SegmentSpec::Move(Law::Constant, Given { speed: Some(AngularVelocity::from_si(1.0)), ..long }))
            }
            Self::Law(law) => Some(SegmentSpec::Move(law, Given { distance: far.distance, ..long })),
            Self::Manual => Some(SegmentSpec::Manual(ManualMove {
                speed: AngularVelocity::from_si(1.0),
                accelerate: second(0.2),
                run: second(0.2),
                brake: second(0.2),
                pause: second(0.4),
            })),
            Self::Dwell => Some(SegmentSpec::Dwell(second(1.0), Hold::Motor)),
            Self::Recorded => None,
            Self::Points => {
                let points = [(0.0, 0.0), (1.0 / 3.0, 0.4), (2.0 / 3.0, 0.6), (1.0, 1.0)];
                let points = points.map(|(time, position)| (second(time), Angle::from_si(position)));
                Some(SegmentSpec::Points(Points::new(&points, Spline::Cubic, Ends::Rest).ok()?.into()))
            }
        }
    }

    /// Returns the law of a word of the project file; the quadratic parabola of VDI 2143 is the triangle.
    #[must_use]
    pub fn of_id(id: &str) -> Option<Self> {
        LAWS.iter().find(|(word, ..)| *word == id).map(|(_, law, ..)| *law)
    }
}

impl Project {
    /// Returns the law of a segment, counted from zero.
    #[must_use]
    pub fn law(&self, segment: usize) -> Option<SegmentLaw> {
        self.root.segments().get(segment)?.law.value()
    }
}

impl WordChoice for SegmentLaw {
    #[allow(clippy::indexing_slicing, reason = "read while compiling: an index out of bounds does not compile")]
    const WORDS: &'static [&'static str] = &{
        let mut words = [""; LAWS.len()];
        let mut index = 0;
        while index < LAWS.len() {
            words[index] = LAWS[index].0;
            index += 1;
        }
        words
    };

    fn of_word(word: &str) -> Option<Self> {
        Self::of_id(word)
    }
}

choice! { SegmentLaw }

choices_by_id! { Spline }

choices! {
    Hold { Motor = "motor", Brake = "brake", Free = "free" }
}

impl Segment {
    /// Returns `true` if it is a trapezoid that two quantities determine.
    fn has_thirds(&self) -> bool {
        let stated: [&dyn StatedField; 4] = [&self.distance, &self.time, &self.speed, &self.acceleration];
        let is_trapezoid = self.law.value() == Some(SegmentLaw::Law(Law::Trapezoid));
        is_trapezoid && stated.iter().filter(|field| field.is_given()).count() == 2
    }

    /// Returns `true` if no value of its motion was refused; its loads do not count.
    pub(crate) fn states_its_motion(&self) -> bool {
        let is_of_motion = |field: &&dyn StatedField| !Self::VARIANTS.shared.contains(&field.name());
        self.fields().into_iter().filter(is_of_motion).all(|field| field.is_given() || !field.is_written())
    }

    /// Returns `true` if its torque is recorded.
    fn has_torque(&self) -> bool {
        self.recording().is_some_and(|read| read.recording.torque.is_some())
    }

    /// Returns `true` if it states its motion along the line of the mechanism.
    fn is_along_a_line(&self) -> bool {
        self.fields().iter().any(|field| field.is_of_a_line())
    }

    /// Returns the fields that decide the largest speed of a move by a law, depending on whether it reaches its stated
    /// speed.
    pub(crate) fn speed_follows_from(&self, reaches_its_speed: bool) -> Vec<&dyn StatedField> {
        let all: Vec<&dyn StatedField> = match self.law.value() {
            Some(SegmentLaw::Recorded) => vec![&self.file],
            Some(SegmentLaw::Points) => vec![&self.points, &self.master_speed],
            Some(SegmentLaw::Manual) => vec![&self.speed],
            Some(SegmentLaw::Law(_) | SegmentLaw::Dwell) | None if reaches_its_speed => vec![&self.speed],
            Some(SegmentLaw::Law(_) | SegmentLaw::Dwell) | None => {
                vec![&self.distance, &self.time, &self.speed, &self.acceleration, &self.jerk, &self.end_speed]
            }
        };
        all.into_iter().filter(|field| field.is_given()).collect()
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
            MoveFault::NoSegment
            | MoveFault::NoDuration
            | MoveFault::NotDetermined { .. }
            | MoveFault::OutOfRange
            | MoveFault::RestToRestOnly
            | MoveFault::StillMoving { .. }
            | MoveFault::RecordingSpeedJumps { .. }
            | MoveFault::RecordingPositionJumps { .. }
            | MoveFault::SpeedNotClosed { .. }
            | MoveFault::PositionNotClosed { .. } => self.law.span(),
        }
    }

    fn extra(&self, load: &Load) -> Extra {
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
            Some(SegmentLaw::Manual | SegmentLaw::Dwell) => true,
            Some(SegmentLaw::Law(law)) => law != Law::Constant && !self.end_speed.is_written(),
            Some(SegmentLaw::Recorded | SegmentLaw::Points) | None => false,
        }
    }

    /// Returns the segment at the output; `travel`: linear travel per angle \[m/rad\] of a linear mechanism.
    fn spec(&self, travel: Option<f64>, known: &mut RecordedMotions, reader: &mut Reader<'_>) -> Option<SegmentSpec> {
        let before = reader.fault_count();
        let given = Given {
            distance: turned(&self.distance, travel, reader),
            time: self.time.value(),
            speed: turned(&self.speed, travel, reader),
            acceleration: turned(&self.acceleration, travel, reader),
            jerk: turned(&self.jerk, travel, reader),
            end_speed: turned(&self.end_speed, travel, reader),
        };
        let is_readable = reader.fault_count() == before;
        let law = self.law.value()?;
        // Their own faults do not depend on the keys of a law.
        let read = match law {
            SegmentLaw::Points => self.through_points(given.end_speed, travel, reader).map(SegmentSpec::Points),
            SegmentLaw::Recorded => crate::recorded::motion(self, travel, known, reader).map(SegmentSpec::Recorded),
            SegmentLaw::Manual | SegmentLaw::Dwell | SegmentLaw::Law(_) => None,
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
            SegmentLaw::Dwell => Some(SegmentSpec::Dwell(given.time?, self.hold())),
            // A refused value has been reported; without it the move would only appear undetermined.
            SegmentLaw::Law(law) => self.states_its_motion().then_some(SegmentSpec::Move(law, given)),
        }
    }

    /// Builds the spline through its points; reports all of their faults, with the end conditions that the spline
    /// needs.
    fn through_points(
        &self,
        end_speed: Option<AngularVelocity>,
        travel: Option<f64>,
        reader: &mut Reader<'_>,
    ) -> Option<Arc<Points>> {
        let before = reader.fault_count();
        let (spline, ends) = (self.spline.value(), self.ends.value());
        self.end_keys(spline, ends, reader);
        let mut acceleration = |stated| turned(stated, travel, reader).unwrap_or_else(|| Measure::from_si(0.0));
        let [first, last] = [&self.start_acceleration, &self.end_acceleration].map(&mut acceleration);
        let first_speed = turned(&self.start_speed, travel, reader);
        let ends = ends.map(|ends| match ends {
            CamEnds::Rest => Ends::Rest,
            CamEnds::Natural => Ends::Natural,
            CamEnds::Periodic => Ends::Periodic,
            CamEnds::Stated => {
                let speed = |speed: Option<AngularVelocity>| speed.unwrap_or_else(|| Measure::from_si(0.0));
                let [first_speed, end_speed] = [first_speed, end_speed].map(speed);
                Ends::Stated(
                    EndState { speed: first_speed, acceleration: first },
                    EndState { speed: end_speed, acceleration: last },
                )
            }
        });
        let rows = self.points.get()?.0.as_slice();
        let measures = rows.first().map(|(point, _)| point.measures());
        for (_, span) in rows.iter().filter(|(point, _)| Some(point.measures()) != measures) {
            reader.fault(span.clone(), Fault::UnlikeFirstPoint, None);
        }
        let over_master = measures.is_some_and(|[over, _]| over == Dimension::Angle);
        if over_master {
            needs(&self.points, &self.master_speed, reader);
        } else if self.master_speed.is_given() {
            reader.fault(self.master_speed.span(), Fault::MasterOfTimes, None);
        }
        let along_a_line = measures.is_some_and(|[_, position]| position == Dimension::Length);
        if along_a_line && travel.is_none() {
            reader.fault(self.points.span(), Fault::NoLine { path: self.points.path() }, None);
        }
        if rows.iter().any(|(point, _)| Some(point.measures()) != measures) {
            return None;
        }
        // Without them the points are checked in their own units.
        let per_second = self.master_speed.value().filter(|_| over_master).map_or(1.0, Measure::si);
        let per_turn = travel.filter(|_| along_a_line).unwrap_or(1.0);
        let points: Vec<(Time, Angle)> = rows
            .iter()
            .map(|(point, _)| {
                let [over, position] = point.values();
                (Time::from_si(over / per_second), Angle::from_si(position / per_turn))
            })
            .collect();
        // Requirements of the spline on the points are reported without its keys too.
        match Points::new(&points, spline.unwrap_or(Spline::Cubic), ends.unwrap_or(Ends::Rest)) {
            Ok(found) if spline.is_some() && ends.is_some() && reader.fault_count() == before => Some(found.into()),
            Ok(_) => None,
            Err(faults) => {
                for fault in faults {
                    let row = match fault {
                        PointsFault::NotFinite { index } | PointsFault::NotIncreasing { index } => rows.get(index),
                        PointsFault::TooFew { .. } | PointsFault::Uneven => None,
                    };
                    let span = row.map_or_else(|| self.points.span(), |(_, span)| span.clone());
                    reader.fault(span, Fault::Points(fault), None);
                }
                None
            }
        }
    }
}

/// Converts a quantity to the output.
pub(crate) fn turned<Q: Turning>(stated: &Stated<Along<Q>>, travel: Option<f64>, reader: &mut Reader<'_>) -> Option<Q> {
    let along = stated.value()?;
    match (along.is_of_a_line, travel) {
        (false, _) => Some(Q::from_si(along.si)),
        (true, Some(travel)) => Some(Q::from_si(along.si / travel)),
        (true, None) => {
            reader.fault(stated.span(), Fault::NoLine { path: stated.name().to_owned() }, None);
            None
        }
    }
}

/// Builds the motion, and the loads that each segment adds.
pub(crate) fn motion(axis: &AxisSection, load: &Load, reader: &mut Reader<'_>) -> Option<(Motion, Vec<Extra>)> {
    let segments = axis.parts.motion.get()?.0.as_slice();
    let travel = load.mechanism.travel_m_per_rad();
    if crate::web::is_along_a_web(segments, &load.mechanism.kind, reader) {
        report_all(axis, Some(1.0), reader);
        return None;
    }
    let specs = specs(axis, travel, reader);
    let Some(whole) = specs.iter().cloned().collect::<Option<Vec<SegmentSpec>>>() else {
        report_readable(axis, specs, travel, reader);
        return None;
    };
    let closing = if axis.single_move { Closing::SingleMove } else { Axis::closing(&load.mechanism) };
    let motion =
        Motion::new(&whole, load.start, closing).map_err(|faults| report(axis, faults, travel, reader)).ok()?;
    let place_of_all = || axis.parts.motion.span();
    let place = |index: usize| segments.get(index).map_or_else(place_of_all, |segment| segment.law.span());
    if let Some(found) = Axis::too_many_instants(&load.mechanism, &motion) {
        reader.fault(place(found.segment), Fault::Instants(found), None);
        return None;
    }
    let beyond = beyond_range(&load.mechanism, &motion);
    for (segment, fault) in &beyond {
        reader.fault(place(*segment), fault.clone(), None);
    }
    beyond.is_empty().then(|| (motion, segments.iter().map(|segment| segment.extra(load)).collect()))
}

/// Reports the faults of a motion whose load is faulty: those that depend on the kind of the load alone, neither on its
/// values nor on the end of the cycle.
pub(crate) fn without_load(axis: &AxisSection, reader: &mut Reader<'_>) {
    // A length counts as an angle, and is converted back where a fault shows it.
    let travel = axis.driven().is_none_or(|driven| driven.travel().is_some()).then_some(1.0);
    report_all(axis, travel, reader);
}

/// Reports the faults of all segments, apart from those of their end.
fn report_all(axis: &AxisSection, travel: Option<f64>, reader: &mut Reader<'_>) {
    let specs = specs(axis, travel, reader);
    report_readable(axis, specs, travel, reader);
}

/// Reports the faults of segments some of which are faulty (`None`), apart from those of their end.
fn report_readable(axis: &AxisSection, specs: Vec<Option<SegmentSpec>>, travel: Option<f64>, reader: &mut Reader<'_>) {
    // A file whose text cannot be read may have its motion behind the fault.
    if specs.is_empty() {
        return;
    }
    let unread = |segment: &Segment| if segment.ends_at_rest() { Unread::EndsAtRest } else { Unread::EndsMoving };
    let segments = axis.segments().iter().zip(specs).map(|(segment, spec)| spec.ok_or_else(|| unread(segment)));
    let start = axis.driven().and_then(Driven::start_angle);
    let mut faults = Motion::faults(&segments.collect::<Vec<_>>(), start.and_then(Stated::value));
    // A recording is placed by the refused angle.
    if start.is_some_and(|start| start.is_written() && !start.is_given()) {
        faults.retain(|each| !matches!(each.fault, MoveFault::RecordingPositionJumps { .. }));
    }
    report(axis, faults, travel, reader);
}

/// Builds the segments, `None` for a faulty one, and reports those of their keys that have no effect on the load.
fn specs(axis: &AxisSection, travel: Option<f64>, reader: &mut Reader<'_>) -> Vec<Option<SegmentSpec>> {
    let segments = axis.segments();
    let mut recorded = RecordedMotions::default();
    let specs: Vec<Option<SegmentSpec>> =
        segments.iter().map(|segment| segment.spec(travel, &mut recorded, reader)).collect();
    if let Some(driven) = axis.driven() {
        for segment in segments {
            without_effect(segment, driven, reader);
            if driven.torque_is_recorded() && !segment.has_torque() && segment.states_its_motion() {
                reader.fault(segment.law.span(), Fault::JointWithoutTorque, None);
            }
        }
    }
    specs
}

/// Reports the faults of a chain of segments.
fn report(axis: &AxisSection, faults: Vec<MotionFault>, travel: Option<f64>, reader: &mut Reader<'_>) {
    let segments = axis.segments();
    let recorded = segments.iter().any(|segment| segment.law.value() == Some(SegmentLaw::Recorded));
    for MotionFault { segment, fault } in faults {
        let unclosed = recorded && matches!(fault, MoveFault::SpeedNotClosed { .. });
        let hint = unclosed.then_some(Hint::CloseTheRecording);
        let segment = segment.and_then(|index| segments.get(index));
        let span = segment.map_or_else(|| axis.parts.motion.span(), |segment| segment.place(&fault));
        let along = segment.map_or_else(|| segments.iter().any(Segment::is_along_a_line), Segment::is_along_a_line);
        let travel_m_per_rad = travel.filter(|_| along);
        reader.fault(span, Fault::Move { fault, travel_m_per_rad }, hint);
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
    let mut found: Vec<(usize, f64)> = Vec::new();
    // The last turn may end at the end of the range, up to rounding.
    let slack = 1e-9 * (1.0 + low.abs().min(high.abs()));
    for (segment, q) in first.into_iter().chain(of_pieces).chain(of_recordings) {
        let excess = |q: f64| (low - q).max(q - high);
        if excess(q) <= slack {
            continue;
        }
        match found.iter_mut().find(|(known, _)| *known == segment) {
            Some((_, worst)) if excess(q) > excess(*worst) => *worst = q,
            Some(_) => {}
            None => found.push((segment, q)),
        }
    }
    let of_mechanism = |q: f64| q / ratio;
    let (from, to) = (of_mechanism(low), of_mechanism(high));
    let range_rad = (from.min(to), from.max(to));
    let fault = |(segment, q)| (segment, Fault::BeyondRange { position_rad: of_mechanism(q), range_rad });
    found.into_iter().map(fault).collect()
}

/// Reports a payload that no part carries and a force without a line, which would otherwise be ignored silently.
fn without_effect(segment: &Segment, driven: &dyn Driven, reader: &mut Reader<'_>) {
    let (carries, turns, has_line) = (driven.carries(), !driven.torque_is_recorded(), driven.process_force().is_some());
    let of_payload: &[&str] = if turns { &["payload_inertia", "payload_distance"] } else { &["process_torque"] };
    let fields: [(&dyn StatedField, bool, &[&str]); 3] = [
        (&segment.payload, carries, of_payload),
        (&segment.payload_inertia, turns, &["process_torque"]),
        (&segment.process_force, has_line, &["process_torque"]),
    ];
    for (field, _, instead) in fields.into_iter().filter(|(field, effect, _)| field.is_given() && !effect) {
        reader.fault(field.span(), Fault::WithoutEffect { key: field.name() }, Some(Hint::instead(instead)));
    }
}

/// Adds the defaults about the motion that the file leaves open.
pub(crate) fn assumptions(axis: &AxisSection, driven: Option<&dyn Driven>, found: &mut Vec<Assumption>) {
    let segments = axis.segments();
    if segments.iter().any(Segment::has_thirds) {
        found.push(Assumption::TrapezoidThirds);
    }
    if axis.single_move {
        found.push(Assumption::SingleMoveRepeats);
    }
    if !driven.is_some_and(Driven::torque_is_recorded) && segments.iter().any(Segment::has_torque) {
        found.push(Assumption::RecordedTorqueAdds);
    }
    let splines = Spline::ALL.into_iter().filter(|each| segments.iter().any(|one| one.spline.value() == Some(*each)));
    found.extend(splines.map(Assumption::SplineThroughPoints));
    crate::side::assumptions(segments, found);
    let rests = |segment: &&Segment| segment.law.value() == Some(SegmentLaw::Dwell);
    found.extend(segments.iter().filter(rests).find_map(|segment| segment.hold.note()));
    let carries = |one: &Segment| one.payload.or_zero().si() > 0.0 || one.payload_inertia.or_zero().si() > 0.0;
    let is_silent = |one: &Segment| !one.payload.is_given() && !one.payload_inertia.is_given();
    // A cycle repeats: its first segment follows the last.
    let next = segments.iter().skip(1).chain(segments.first().filter(|_| !axis.single_move));
    if segments.iter().zip(next).any(|(before, dwell)| rests(&dwell) && carries(before) && is_silent(dwell)) {
        found.push(Assumption::NoPayloadInDwell);
    }
    let has_bodies = driven.is_some_and(|driven| driven.bodies().is_some());
    if has_bodies && segments.iter().any(|segment| segment.payload.or_zero().si() > 0.0) {
        found.push(Assumption::PayloadTowardsCentre);
    }
}
