//! Splines through the points of a cam table.

use crate::along::turned;
use crate::choices;
use crate::fault::{AxisFault, AxisReport};
use crate::needs::needs;
use crate::recorded::states_its_motion;
use motion::{EndState, Ends, Points, PointsFault};
use project::Fault;
use project::choices::Spline;
use project::sections::{CamEnds, Segment, StatedField, Written};
use quantities::{Angle, AngularVelocity, Dimension, Measure, Time};
use std::sync::Arc;

/// Builds the spline through its points; reports all of their faults, with the end conditions that the spline
/// needs.
pub(crate) fn through_points(
    segment: &Segment,
    end_speed: Option<AngularVelocity>,
    travel: Option<f64>,
    report: &mut AxisReport<'_>,
) -> Option<Arc<Points>> {
    let before = report.fault_count();
    let (spline, ends) = (segment.spline.value(), segment.ends.value());
    end_keys(segment, spline, ends, report);
    let mut acceleration = |stated| turned(stated, travel, report).unwrap_or_else(|| Measure::from_si(0.0));
    let [first, last] = [&segment.start_acceleration, &segment.end_acceleration].map(&mut acceleration);
    let first_speed = turned(&segment.start_speed, travel, report);
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
    let rows = segment.points.get()?;
    let (rows, is_whole) = (rows.rows.as_slice(), rows.is_whole);
    let measures = rows.first().map(|(point, _)| point.measures());
    for (_, span) in rows.iter().filter(|(point, _)| Some(point.measures()) != measures) {
        report.fault(span.clone(), Fault::UnlikeFirstPoint, None);
    }
    let over_master = measures.is_some_and(|[over, _]| over == Dimension::Angle);
    if over_master {
        needs(&segment.points, &segment.master_speed, report);
    } else if segment.master_speed.is_given() {
        report.fault(segment.master_speed.span(), Fault::MasterOfTimes, None);
    }
    let along_a_line = measures.is_some_and(|[_, position]| position == Dimension::Length);
    if along_a_line && travel.is_none() {
        report.fault(segment.points.span(), Fault::NoLine { path: segment.points.path() }, None);
    }
    if rows.iter().any(|(point, _)| Some(point.measures()) != measures) {
        return None;
    }
    // Without them the points are checked in their own units.
    let per_second = segment.master_speed.value().filter(|_| over_master).map_or(1.0, Measure::si);
    let per_turn = travel.filter(|_| along_a_line).unwrap_or(1.0);
    let points: Vec<(Time, Angle)> = rows
        .iter()
        .map(|(point, _)| {
            let [over, position] = point.values();
            (Time::from_si(over / per_second), Angle::from_si(position / per_turn))
        })
        .collect();
    // Requirements of the spline on the points are reported without its keys too.
    match Points::new(&points, choices::spline(spline.unwrap_or(Spline::Cubic)), ends.unwrap_or(Ends::Rest)) {
        // A refused value has been reported; without it the motion would be another one.
        Ok(found) if is_whole && states_its_motion(segment) && report.fault_count() == before => Some(found.into()),
        Ok(_) => None,
        Err(faults) => {
            for fault in faults {
                let row = match fault {
                    PointsFault::NotFinite { index } | PointsFault::NotIncreasing { index } => rows.get(index),
                    PointsFault::TooFew { .. } | PointsFault::Uneven if !is_whole => continue,
                    PointsFault::TooFew { .. } | PointsFault::Uneven => None,
                };
                let span = row.map_or_else(|| segment.points.span(), |(_, span)| span.clone());
                report.fault(span, AxisFault::Points(fault), None);
            }
            None
        }
    }
}

/// Reports speeds and accelerations at the ends that are missing or that spline and ends do not use.
fn end_keys(segment: &Segment, spline: Option<Spline>, ends: Option<CamEnds>, report: &mut AxisReport<'_>) {
    let Some(ends) = ends else { return };
    let fields: [(&dyn StatedField, bool); 4] = [
        (&segment.start_speed, true),
        (&segment.end_speed, true),
        (&segment.start_acceleration, spline != Some(Spline::Cubic)),
        (&segment.end_acceleration, spline != Some(Spline::Cubic)),
    ];
    for (field, of_spline) in fields {
        let other = if ends != CamEnds::Stated {
            Some((segment.ends.name(), ends.written()))
        } else {
            (!of_spline).then(|| (segment.spline.name(), Spline::Cubic.written()))
        };
        match other {
            Some((by, kind)) if field.is_given() => {
                let fault = Fault::KeyOfAnotherKind { path: field.path(), by, kind };
                report.fault(field.span(), fault, None);
            }
            None if spline.is_some() => needs(&segment.ends, field, report),
            Some(_) | None => {}
        }
    }
}
