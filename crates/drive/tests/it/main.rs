//! The virtual drive as a controller sees it.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic, reason = "a test may fail")]

mod can;
mod faults;
mod hostile;
mod line;
mod modes;
mod objects;
mod states;

use drive::{Address, Drive, Given, State, Value};
use feedback::{Encoder, Failure};
use installation::commission::{cia402, commission};
use mechanism::{Extra, Friction, Mechanism};
use motion::{Closing, ManualMove, Motion, SegmentSpec};
use quantities::unit::REVOLUTION_PER_MINUTE;
use quantities::{AngularVelocity, Measure, MomentOfInertia, Time, Torque};
use twin::{Parameters, Scenario, Setup};

/// With a brake, M512P: its position rises with the motor clockwise.
const CODE: &str = "CHA-25A-100-H-M512P-B";

/// Data borrowed by a setup.
struct Axis {
    parameters: Parameters,
    mechanism: Mechanism,
    motion: Motion,
    extras: Vec<Extra>,
    given: Given,
    encoder: Encoder,
    failure: Option<Failure>,
}

impl Axis {
    fn of(code: &str, inertia: f64, torque: f64) -> Self {
        let code = order_code::parse(code).unwrap().code;
        let about = commission(&code).unwrap();
        let friction = Friction { external: Torque::from_si(torque), ..Friction::none() };
        let mechanism = Mechanism::direct(MomentOfInertia::from_si(inertia), Torque::from_si(0.0));
        let time = Time::from_si;
        let each = ManualMove {
            speed: AngularVelocity::new_in(10.0, &REVOLUTION_PER_MINUTE),
            accelerate: time(0.1),
            run: time(0.1),
            brake: time(0.1),
            pause: time(0.1),
        };
        Self {
            parameters: Parameters::of(&about.actuator),
            mechanism: Mechanism { friction, ..mechanism },
            motion: Motion::new(&[SegmentSpec::Manual(each)], None, Closing::SingleMove).unwrap(),
            extras: vec![Extra::none()],
            encoder: installation::encoder::encoders(&code).unwrap().remove(0).encoder,
            failure: None,
            given: Given {
                node: 1,
                name: format!("antrieb {code}"),
                seed: 0,
                objects: cia402::objects(&about),
                has_battery: about.actuator.feedback.buffered_by_battery,
                has_kty: about.has_kty(),
            },
        }
    }

    fn drive(&self) -> Drive<'_> {
        let scenario = Scenario { failure: self.failure, ..Scenario::default() };
        let setup = Setup {
            scenario,
            encoder: Some(&self.encoder),
            ..Setup::of(&self.parameters, &self.mechanism, &self.motion, &self.extras)
        };
        let mut drive = Drive::new(&setup, &self.given).unwrap();
        drive.advance(2);
        drive
    }
}

fn usual() -> Axis {
    Axis::of(CODE, 1.0, 0.0)
}

fn at(index: u16) -> Address {
    Address::new(index, 0)
}

fn read(drive: &Drive<'_>, index: u16) -> i64 {
    match drive.read(at(index)).unwrap() {
        Value::Number(number) => number,
        Value::Text(text) => panic!("{text}"),
    }
}

fn write(drive: &mut Drive<'_>, index: u16, value: i64) {
    drive.write(at(index), value).unwrap_or_else(|abort| panic!("{index:04X} = {value}: {abort:?}"));
}

/// Brings the drive to operation enabled, with the brake open.
fn enabled(drive: &mut Drive<'_>, mode: i64) {
    write(drive, 0x6060, mode);
    for control in [0x06, 0x07, 0x0F] {
        write(drive, 0x6040, control);
    }
    assert_eq!(drive.state(), State::OperationEnabled);
    drive.advance(400);
    assert_eq!(read(drive, 0x2003), 0, "the brake is open");
}

/// Half milliseconds until something holds, at most so many.
fn until(drive: &mut Drive<'_>, most: u64, holds: impl Fn(&Drive<'_>) -> bool) -> u64 {
    for step in 0..most {
        if holds(drive) {
            return step;
        }
        drive.advance(1);
    }
    panic!("after {most} steps: {:?}, statusword {:04X}", drive.state(), read(drive, 0x6041));
}
