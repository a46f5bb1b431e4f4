//! Samples of the laws of motion, for their pictures.

use crate::choices;
use motion::{Ends, Given, Hold, Law, ManualMove, Points, SegmentSpec, Spline, Web};
use project::{SegmentLaw, choices as stated};
use quantities::AngularJerk;
use quantities::{Angle, AngularAcceleration, AngularVelocity, Length, Measure, Time, Velocity};

/// Returns a move of one radian in one second, from rest to rest if the law allows it, for its picture; `None` for
/// a recording. Limited jerk is shown in thirds, the manual's move with a pause of the length of its run and ramps.
#[must_use]
pub fn law_sample(law: SegmentLaw) -> Option<SegmentSpec> {
    let second = Time::from_si;
    let far = Given { distance: Some(Angle::from_si(1.0)), ..Given::default() };
    let long = Given { time: Some(second(1.0)), ..Given::default() };
    match law {
        SegmentLaw::Law(stated::Law::Jerk) => Some(SegmentSpec::Move(
            Law::Jerk,
            Given {
                speed: Some(AngularVelocity::from_si(1.5)),
                acceleration: Some(AngularAcceleration::from_si(6.0)),
                jerk: Some(AngularJerk::from_si(54.0)),
                ..far
            },
        )),
        SegmentLaw::Law(stated::Law::Constant) => {
            Some(SegmentSpec::Move(Law::Constant, Given { speed: Some(AngularVelocity::from_si(1.0)), ..long }))
        }
        SegmentLaw::Law(law) => Some(SegmentSpec::Move(choices::law(law), Given { distance: far.distance, ..long })),
        SegmentLaw::Open => {
            Some(SegmentSpec::Move(choices::law(SegmentLaw::ASSUMED), Given { distance: far.distance, ..long }))
        }
        SegmentLaw::Web => {
            let web = Web {
                from: Length::from_si(0.4),
                to: Length::from_si(1.0),
                thickness: Length::from_si(0.3 * std::f64::consts::TAU),
                speed: Velocity::from_si(0.175),
                accelerate: second(0.2),
                brake: second(0.2),
            };
            Some(SegmentSpec::Points(web.points().ok()?.into()))
        }
        SegmentLaw::Manual => Some(SegmentSpec::Manual(ManualMove {
            speed: AngularVelocity::from_si(1.0),
            accelerate: second(0.2),
            run: second(0.2),
            brake: second(0.2),
            pause: second(0.4),
        })),
        SegmentLaw::Dwell => Some(SegmentSpec::Dwell(second(1.0), Hold::Motor)),
        SegmentLaw::Recorded => None,
        SegmentLaw::Points => {
            let points = [(0.0, 0.0), (1.0 / 3.0, 0.4), (2.0 / 3.0, 0.6), (1.0, 1.0)];
            let points = points.map(|(time, position)| (second(time), Angle::from_si(position)));
            Some(SegmentSpec::Points(Points::new(&points, Spline::Cubic, Ends::Rest).ok()?.into()))
        }
    }
}
