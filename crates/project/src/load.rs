//! From the sections of a project file to mechanism and motion.

use crate::read::{Reader, joined};
use crate::section::{Entry, Section};
use crate::{Assumption, Fault, Hint};
use mechanism::{
    Body, BodyError, Extra, Friction, Joint, Kind, Linear, LinearKind, Mechanism, Rotor, SliderCrank, Table, TablePoint,
};
use motion::{Closing, Given, Hold, Law, ManualMove, Motion, MotionFault, MoveFault, SegmentSpec};
use quantities::{Angle, Dimension, Force, Length, Mass, Measure, MomentOfInertia, Torque, ViscousFriction};
use sizing::Axis;

/// What is moved, and where it stands when the motion begins.
pub(crate) struct Load {
    pub(crate) mechanism: Mechanism,
    start: Option<Angle>,
    /// Process force that acts in every segment.
    force: Force,
}

/// The one load of the axis: `[load]` or one table of `[mechanism]`.
pub(crate) fn load(root: &Section, reader: &mut Reader<'_>) -> Option<Load> {
    let given: Vec<(&str, &Section)> = root
        .table("load")
        .map(|section| ("load", section))
        .into_iter()
        .chain(root.table("mechanism").into_iter().flat_map(Section::subtables))
        .collect();
    match given.as_slice() {
        [(name, section)] => build(name, section, reader),
        [] => {
            // A load that is there but faulty has been told already, and one that could not be read may be there.
            let there = root.has("load") || root.table("mechanism").is_some_and(|section| !section.is_whole());
            if !there && !reader.is_damaged() {
                let hint = Hint::Example("[load] inertia = \"1.3 kg m^2\"".to_owned());
                reader.fault(root.span_of("mechanism"), Fault::NoMechanism, Some(hint));
            }
            None
        }
        [_, (_, second), ..] => {
            reader.fault(second.span.clone(), Fault::TooManyMechanisms, None);
            None
        }
    }
}

fn zero<Q: Measure>() -> Q {
    Q::from_si(0.0)
}

fn build(name: &str, section: &Section, reader: &mut Reader<'_>) -> Option<Load> {
    let start: Option<Angle> = section.quantity("start_angle");
    let turning: MomentOfInertia = section.quantity("inertia").unwrap_or_else(zero);
    let inclination: Angle = section.quantity("inclination").unwrap_or_else(zero);
    let linear = |kind, travel_m_per_rad| {
        Some(Kind::Linear(Linear {
            kind,
            travel_m_per_rad,
            inertia: turning,
            mass: section.quantity("mass")?,
            counterweight: section.quantity("counterweight").unwrap_or_else(zero),
            inclination,
            friction_force: section.quantity("friction_force").unwrap_or_else(zero),
            friction_coefficient: section.number("friction_coefficient").unwrap_or(0.0),
        }))
    };
    let kind = match name {
        "joint" => Kind::Joint(Joint { inertia: turning, holding_torque: section.quantity("holding_torque") }),
        "load" => Kind::Rotor(Rotor::balanced(section.quantity("inertia")?)),
        "turntable" => {
            let (bodies, tables) = bodies(section, reader)?;
            let bodies = match mechanism::inertia(&bodies) {
                Ok(total) => total,
                Err(errors) => {
                    for each in errors {
                        let span = match tables.get(each.body) {
                            Some(table) => place_in(table, &each.error),
                            // The bodies as written are sound; with other values within their tolerance they need not be.
                            None => section.span_of("bodies"),
                        };
                        reader.fault(span, Fault::Body(each.error), None);
                    }
                    return None;
                }
            };
            Kind::Rotor(Rotor {
                inertia: bodies.inertia,
                mass: bodies.mass,
                radius: bodies.centre_radius,
                payload_radius: section.quantity("payload_distance").unwrap_or_else(zero),
                angle: bodies.centre_angle,
                tilt: section.quantity("axis_tilt").unwrap_or_else(zero),
            })
        }
        "arm" => Kind::Rotor(Rotor {
            inertia: section.quantity("inertia")?,
            mass: section.quantity("mass")?,
            radius: section.quantity("centre_distance")?,
            payload_radius: section.quantity("payload_distance").unwrap_or_else(zero),
            angle: zero(),
            tilt: section.quantity("axis_tilt")?,
        }),
        "screw" => linear(LinearKind::Screw, section.quantity::<Length>("lead")?.si() / std::f64::consts::TAU)?,
        "belt" => linear(LinearKind::Belt, section.quantity::<Length>("pulley_diameter")?.si() / 2.0)?,
        "conveyor" => linear(LinearKind::Conveyor, section.quantity::<Length>("roller_diameter")?.si() / 2.0)?,
        "slider_crank" => {
            let (crank, rod): (Length, Length) = (section.quantity("crank")?, section.quantity("rod")?);
            if rod.si() <= crank.si() {
                reader.fault(section.span_of("rod"), Fault::RodTooShort, None);
                return None;
            }
            Kind::SliderCrank(SliderCrank {
                crank,
                rod,
                inertia: turning,
                mass: section.quantity("mass")?,
                inclination,
                angle: zero(),
            })
        }
        _ => {
            let points = section.rows("points").iter().filter_map(|row| match row.as_slice() {
                [position, inertia, torque] => Some(TablePoint {
                    position: Angle::from_si(*position),
                    inertia: MomentOfInertia::from_si(*inertia),
                    torque: Torque::from_si(*torque),
                }),
                _ => None,
            });
            section.get("points")?;
            match Table::new(points.collect()) {
                Ok(table) => Kind::Table(table),
                Err(fault) => {
                    reader.fault(section.span_of("points"), Fault::Table(fault), None);
                    return None;
                }
            }
        }
    };
    let mechanism = Mechanism {
        kind,
        friction: Friction {
            coulomb: section.quantity("friction_torque").unwrap_or_else(zero),
            viscous: section.quantity::<ViscousFriction>("viscous_friction").unwrap_or_else(zero),
            external: section.quantity("external_torque").unwrap_or_else(zero),
        },
        efficiency_driving: section.number("efficiency").unwrap_or(1.0),
        efficiency_driven: section.number("efficiency_back").unwrap_or(1.0),
        stage: None,
    };
    Some(Load { mechanism, start, force: section.quantity("process_force").unwrap_or_else(zero) })
}

/// The bodies of a turntable, and their tables where they are written so.
fn bodies<'s>(section: &'s Section, reader: &mut Reader<'_>) -> Option<(Vec<Body>, &'s [Section])> {
    if section.has("bodies") && section.has("body") {
        reader.fault(section.span_of("bodies"), Fault::BodiesTwice, None);
        return None;
    }
    if let Some(bodies) = section.bodies("bodies") {
        return Some((bodies.to_vec(), &[]));
    }
    let tables = section.tables("body");
    if tables.is_empty() {
        // What was refused has been told already.
        if section.is_whole() && !reader.is_damaged() {
            let fault = Fault::MissingKey { path: joined(&section.path, "body"), list: true };
            let hint = Hint::Example(format!("[[{}]] shape = \"disc\"", joined(&section.path, "body")));
            let start = section.span.start;
            reader.fault(start..start + usize::from(!section.span.is_empty()), fault, Some(hint));
        }
        return None;
    }
    let bodies: Option<Vec<Body>> = tables.iter().map(crate::bodies::of_table).collect();
    Some((bodies?, tables))
}

/// The place of what is wrong with a body; where nothing is written of it, the beginning of its table.
fn place_in(table: &Section, error: &BodyError) -> std::ops::Range<usize> {
    let named = crate::bodies::fields(error).iter().find(|name| table.get(name).is_some());
    named.map_or_else(|| table.span_of("shape"), |name| table.span_of(name))
}

/// Motion and what each segment adds to the load.
pub(crate) fn motion(root: &Section, load: &Load, reader: &mut Reader<'_>) -> Option<(Motion, Vec<Extra>)> {
    let sections = root.tables("motion");
    root.get("motion")?;
    let travel = load.mechanism.travel_m_per_rad();
    let specs: Vec<Option<SegmentSpec>> =
        sections.iter().map(|section| Turning { section, travel }.segment(reader)).collect();
    for section in sections {
        without_effect(section, load, reader);
        if matches!(load.mechanism.kind, Kind::Joint(_)) && !has_torque(section) && section.is_whole() {
            reader.fault(section.span_of("law"), Fault::JointWithoutTorque, None);
        }
    }
    let specs: Vec<SegmentSpec> = specs.into_iter().collect::<Option<_>>()?;
    let single = root.table("axis").and_then(|axis| axis.bool("single_move")).unwrap_or(false);
    let closing = if single { Closing::SingleMove } else { Axis::closing(&load.mechanism) };
    match Motion::new(&specs, load.start, closing) {
        Ok(motion) => {
            if let Some(found) = Axis::too_many_instants(&load.mechanism, &motion) {
                let section = sections.get(found.segment);
                let span = section.map_or_else(|| root.span_of("motion"), |section| section.span_of("law"));
                reader.fault(span, Fault::Instants(found), None);
                return None;
            }
            Some((motion, sections.iter().map(|section| extra(section, load)).collect()))
        }
        Err(faults) => {
            for MotionFault { segment, fault } in faults {
                let recorded = sections.iter().any(|section| section.text("law") == Some("recorded"));
                let unclosed = recorded && matches!(fault, MoveFault::SpeedNotClosed { .. });
                let hint = unclosed.then_some(Hint::CloseTheRecording);
                let section = segment.and_then(|index| sections.get(index));
                let span = section.map_or_else(|| root.span_of("motion"), |section| place(section, &fault));
                let travel_m_per_rad = travel.filter(|_| along_a_line(section, sections));
                reader.fault(span, Fault::Move { fault, travel_m_per_rad }, hint);
            }
            None
        }
    }
}

/// Whether the torque of a segment is recorded.
fn has_torque(section: &Section) -> bool {
    matches!(section.get("file"), Some(Entry::Recording(read)) if read.recording.torque.is_some())
}

/// A payload that nothing carries and a force along no line would be left out in silence: they are refused.
fn without_effect(section: &Section, load: &Load, reader: &mut Reader<'_>) {
    let (carries, has_line) = match &load.mechanism.kind {
        Kind::Rotor(rotor) => (rotor.payload_radius.si() > 0.0, false),
        Kind::Linear(_) | Kind::SliderCrank(_) => (true, true),
        _ => (false, false),
    };
    // The recorded torque of a joint has the inertia of everything in it.
    let turns = !matches!(load.mechanism.kind, Kind::Joint(_));
    for (key, effect) in [("payload", carries), ("payload_inertia", turns), ("process_force", has_line)] {
        if section.get(key).is_some() && !effect {
            let hint = match key {
                "payload" | "payload_inertia" if !turns => "process_torque",
                "payload" => "payload_inertia, or payload_distance",
                _ => "process_torque",
            };
            let hint = Hint::DidYouMean(hint.to_owned());
            reader.fault(section.span_of(key), Fault::WithoutEffect { key }, Some(hint));
        }
    }
}

/// Whether a segment states its motion along the line; for a fault of the whole cycle, whether any does.
fn along_a_line(section: Option<&Section>, all: &[Section]) -> bool {
    let line = |section: &Section| {
        ["distance", "speed", "acceleration", "jerk", "end_speed"]
            .iter()
            .any(|key| section.along(key).is_some_and(|(dimension, _)| is_of_a_line(dimension)))
    };
    section.map_or_else(|| all.iter().any(line), line)
}

/// Whether a quantity is one of the line, not of the rotation.
pub(crate) const fn is_of_a_line(dimension: Dimension) -> bool {
    matches!(dimension, Dimension::Length | Dimension::Velocity | Dimension::Acceleration | Dimension::Jerk)
}

/// The place of the value that a fault speaks of.
fn place(section: &Section, fault: &MoveFault) -> std::ops::Range<usize> {
    let keys: &[&str] = match fault {
        MoveFault::NoTimeToChangeSpeed { braking: true } => &["brake"],
        MoveFault::NoTimeToChangeSpeed { braking: false } => &["accelerate"],
        MoveFault::SpeedTooLow { .. } | MoveFault::SpeedTooHigh { .. } | MoveFault::EndSpeedAboveLimit => &["speed"],
        MoveFault::AccelerationTooLow { .. } => &["acceleration"],
        _ => &["law"],
    };
    keys.first().map_or_else(|| section.span.clone(), |key| section.span_of(key))
}

fn extra(section: &Section, load: &Load) -> Extra {
    Extra {
        mass: section.quantity("payload").unwrap_or_else(zero::<Mass>),
        inertia: section.quantity("payload_inertia").unwrap_or_else(zero),
        force: load.force + section.quantity("process_force").unwrap_or_else(zero::<Force>),
        torque: section.quantity("process_torque").unwrap_or_else(zero),
    }
}

/// A segment's quantities at the output.
struct Turning<'s> {
    section: &'s Section,
    travel: Option<f64>,
}

impl Turning<'_> {
    fn along<Q: Measure>(&self, name: &str, reader: &mut Reader<'_>) -> Option<Q> {
        let (dimension, si) = self.section.along(name)?;
        match (is_of_a_line(dimension), self.travel) {
            (false, _) => Some(Q::from_si(si)),
            (true, Some(travel)) => Some(Q::from_si(si / travel)),
            (true, None) => {
                reader.fault(self.section.span_of(name), Fault::NoLine { path: name.to_owned() }, None);
                None
            }
        }
    }

    fn segment(&self, reader: &mut Reader<'_>) -> Option<SegmentSpec> {
        let section = self.section;
        let before = reader.fault_count();
        let given = Given {
            distance: self.along("distance", reader),
            time: section.quantity("time"),
            speed: self.along("speed", reader),
            acceleration: self.along("acceleration", reader),
            jerk: self.along("jerk", reader),
            end_speed: self.along("end_speed", reader),
        };
        if reader.fault_count() > before {
            return None;
        }
        let law = match section.text("law")? {
            "manual" => {
                return Some(SegmentSpec::Manual(ManualMove {
                    speed: given.speed?,
                    accelerate: section.quantity("accelerate")?,
                    run: section.quantity("run")?,
                    brake: section.quantity("brake")?,
                    pause: section.quantity("pause")?,
                }));
            }
            "recorded" => {
                return crate::recorded::motion(section, self.travel, reader).map(SegmentSpec::Recorded);
            }
            "dwell" => {
                let hold = match section.text("hold") {
                    Some("brake") => Hold::Brake,
                    Some("free") => Hold::Free,
                    _ => Hold::Motor,
                };
                return Some(SegmentSpec::Dwell(given.time?, hold));
            }
            // VDI 2143 calls it so.
            "parabola" => Law::Triangle,
            id => Law::ALL.into_iter().find(|law| law.id() == id)?,
        };
        // A value that was refused has been told; without it the move would only seem undetermined.
        section.is_whole().then_some(SegmentSpec::Move(law, given))
    }
}

/// Defaults about load and motion that the file leaves open.
pub(crate) fn assumptions(root: &Section, found: &mut Vec<Assumption>) {
    let load = root.table("load").or_else(|| root.table("mechanism")?.subtables().next().map(|(_, section)| section));
    let frictions = ["friction_torque", "viscous_friction", "friction_force", "friction_coefficient"];
    let joint = root.table("mechanism").is_some_and(|mechanism| mechanism.get("joint").is_some());
    if !joint && load.is_none_or(|load| frictions.iter().all(|key| load.get(key).is_none())) {
        found.push(Assumption::NoFriction);
    }
    if root.table("load").is_none() && !joint {
        if load.is_none_or(|load| load.get("efficiency").is_none()) {
            found.push(Assumption::NoLosses);
        } else if load.is_none_or(|load| load.get("efficiency_back").is_none()) {
            found.push(Assumption::LossesDoNotHelp);
        }
    }
    let segments = root.tables("motion");
    let count = |section: &Section| {
        ["distance", "time", "speed", "acceleration"].iter().filter(|key| section.get(key).is_some()).count()
    };
    if segments.iter().any(|section| section.text("law") == Some("trapezoid") && count(section) == 2) {
        found.push(Assumption::TrapezoidThirds);
    }
    if root.table("axis").and_then(|axis| axis.bool("single_move")) == Some(true) {
        found.push(Assumption::SingleMoveRepeats);
    }
    let recorded = |section: &Section| match section.get("file") {
        Some(Entry::Recording(read)) => Some(read.clone()),
        _ => None,
    };
    if !joint && segments.iter().any(has_torque) {
        found.push(Assumption::RecordedTorqueAdds);
    }
    let differences = |section: &Section| {
        recorded(section).is_some_and(|read| read.recording.course.speed.is_none())
            && section.get("smoothing").is_none()
    };
    if segments.iter().any(differences) {
        found.push(Assumption::RecordedPositionDifferentiated);
    }
    let standing = |section: &&Section| section.text("law") == Some("dwell");
    if segments.iter().filter(standing).any(|section| !matches!(section.get("hold"), Some(Entry::Text(_)))) {
        found.push(Assumption::MotorHolds);
    }
}
