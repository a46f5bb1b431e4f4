//! The twin as a whole.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic, reason = "a test may fail")]

mod averaged;
mod bench;
mod course;
mod coverage;
mod filter;
mod foreign;
mod identify;
mod instrument;
mod linear;
mod link;
mod logger;
mod moving;
mod runs;
mod steady;
mod worst;
mod wrong_columns;
mod wrong_projects;

use mechanism::{Extra, Mechanism};
use motion::{Closing, ManualMove, Motion, SegmentSpec};
use provenance::{Datum, Grade, Source, Sourced};
use quantities::unit::REVOLUTION_PER_MINUTE;
use quantities::{AngularVelocity, Measure, MomentOfInertia, Time, Torque};
use twin::Parameters;

/// Returns the parameters of a code.
fn parameters(code: &str) -> Parameters {
    Parameters::of(&configurator::parameters(&order_code::parse(code).unwrap().code).unwrap())
}

/// Replaces a datum by a value in SI.
fn replaced<Q: Measure>(datum: &mut Datum<Q>, si: f64) {
    let source = Source::Model { name: "twin" };
    *datum = Datum::Known(Sourced { value: Q::from_si(si), source, grade: Grade::Assumed, errata: &[] });
}

/// Returns the signals of its feedback.
fn encoder(code: &str) -> feedback::Encoder {
    installation::encoder::encoders(&order_code::parse(code).unwrap().code).unwrap().remove(0).encoder
}

/// Returns a load at the output.
fn load(inertia: f64, friction: f64) -> Mechanism {
    Mechanism::direct(MomentOfInertia::from_si(inertia), Torque::from_si(friction))
}

/// Returns one move of the manual.
fn one_move(rpm: f64, ramp: f64, run: f64, pause: f64) -> Motion {
    let time = Time::from_si;
    let each = ManualMove {
        speed: AngularVelocity::new_in(rpm, &REVOLUTION_PER_MINUTE),
        accelerate: time(ramp),
        run: time(run),
        brake: time(ramp),
        pause: time(pause),
    };
    Motion::new(&[SegmentSpec::Manual(each)], None, Closing::SingleMove).unwrap()
}

const NOTHING: fn() -> Vec<Extra> = || vec![Extra::none()];
