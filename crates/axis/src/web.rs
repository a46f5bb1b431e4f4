//! Lengths and speeds of the web of a winder, whose diameter changes with every turn.

use crate::fault::{AxisFault, AxisReport};
use crate::source::SegmentSource;
use mechanism::{MechanismKind, Winding};
use motion::{MoveFault, Points, Web, WebFault};
use project::sections::{Fields, Segment, StatedField};
use project::{Fault, Hint, SegmentLaw};
use quantities::{Measure, Time, Velocity};
use std::sync::Arc;

/// Duration of a ramp of the web that is not stated \[s\]; a guess for a machine with a dancer or a load cell.
pub(crate) const RAMP_S: f64 = 10.0;

/// Reports values along the web, with the turns of the roll that they are; returns `true` if there are some. The line
/// speed of a run of the web is none of them.
pub(crate) fn is_along_a_web(segments: &[Segment], kind: &MechanismKind, report: &mut AxisReport<'_>) -> bool {
    let MechanismKind::Winder(winder) = kind else { return false };
    let mut found = false;
    for segment in segments.iter().filter(|segment| segment.law.value() != Some(SegmentLaw::Web)) {
        for field in segment.fields().into_iter().filter(|field| field.is_of_a_line()) {
            let speed = segment.speed.value().filter(|_| field.name() == segment.speed.name());
            let hint = Hint::WebOfWinder {
                web_m_s: speed.map(|speed| speed.si),
                start_m: winder.start_diameter.si(),
                core_m: winder.core_diameter.si(),
            };
            report.fault(field.span(), Fault::NoLine { path: field.name().to_owned() }, Some(hint));
            found = true;
        }
    }
    found
}

/// Returns `true` if a ramp of a run of the web is not stated.
pub(crate) fn has_assumed_ramps(segment: &Segment) -> bool {
    segment.law.value() == Some(SegmentLaw::Web) && !(segment.accelerate.is_given() && segment.brake.is_given())
}

/// Builds the run of the web of a winder from the initial roll to the full one, or to the core; `kind` is `None` if the
/// load is faulty, `is_winder` if it is one, or none is stated.
pub(crate) fn run(
    segment: &SegmentSource<'_>,
    (kind, is_winder): (Option<&MechanismKind>, bool),
    report: &mut AxisReport<'_>,
) -> Option<Arc<Points>> {
    if !is_winder {
        report.fault(segment.law.span(), Fault::NoWeb, None);
    }
    let speed = segment.speed.value();
    if speed.is_some_and(|speed| !speed.is_of_a_line || speed.si <= 0.0) {
        report.fault(segment.speed.span(), Fault::WebSpeed, None);
        return None;
    }
    let Some(MechanismKind::Winder(winder)) = kind else { return None };
    let ramp = |field: &project::sections::Stated<Time>| match (field.value(), field.is_written()) {
        (Some(time), _) => Some(time),
        (None, false) => Some(Time::from_si(RAMP_S)),
        (None, true) => None,
    };
    let web = Web {
        from: winder.start_diameter,
        to: if winder.winding == Winding::Up { winder.full_diameter } else { winder.core_diameter },
        thickness: winder.thickness,
        speed: Velocity::from_si(speed?.si),
        accelerate: ramp(&segment.accelerate)?,
        brake: ramp(&segment.brake)?,
    };
    let fault = match web.points() {
        Ok(points) => return Some(points.into()),
        Err(fault) => fault,
    };
    match fault {
        WebFault::NoSpeed => report.fault(segment.speed.span(), Fault::WebSpeed, None),
        WebFault::TooShort { length_m, ramps_m } => {
            report.fault(segment.speed.span(), Fault::WebTooShort { length_m, ramps_m }, None);
        }
        WebFault::NoTimeToChangeSpeed { braking } => {
            let fault = AxisFault::Move { fault: MoveFault::NoTimeToChangeSpeed { braking }, travel_m_per_rad: None };
            let field = if braking { &segment.brake } else { &segment.accelerate };
            report.fault(field.span(), fault, None);
        }
        WebFault::OutOfRange => {
            let fault = AxisFault::Move { fault: MoveFault::OutOfRange, travel_m_per_rad: None };
            report.fault(segment.law.span(), fault, None);
        }
    }
    None
}

/// Reports moves beside a run of the web, since the roll at its start would not be the initial one.
pub(crate) fn alone(segments: &[Segment], report: &mut AxisReport<'_>) {
    if !segments.iter().any(|segment| segment.law.value() == Some(SegmentLaw::Web)) {
        return;
    }
    let mut runs = 0;
    for segment in segments {
        let law = segment.law.value();
        runs += usize::from(law == Some(SegmentLaw::Web));
        let is_beside = law.is_some_and(|law| !matches!(law, SegmentLaw::Dwell | SegmentLaw::Web));
        if is_beside || law == Some(SegmentLaw::Web) && runs > 1 {
            report.fault(segment.law.span(), Fault::WebNotAlone, None);
        }
    }
}
