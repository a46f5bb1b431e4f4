//! Signals and words of encoders, compared with their minimum work: a sine and a cosine each.
//!
//! The promise is ten million per second; the ratio is judged.
#![allow(clippy::print_stdout, reason = "a bench prints what it measured")]

use benches::{Gates, least_processor_s};
use feedback::endat::{ErrorBits, Frame};
use feedback::ssi::SsiFormat;
use feedback::{
    Absolute, CommutationPhases, Encoder, Interface, Protocol, Shaft, Signal, SinePair, SquareTracks, TrackingLoop,
};
use quantities::{Angle, AngularVelocity, Measure};
use std::hint::black_box;
use std::process::ExitCode;

const COUNT: u32 = 100_000;

fn angles() -> impl Iterator<Item = Angle> {
    (0..COUNT).map(|at| Angle::from_si(f64::from(at) * 6e-5))
}

fn main() -> ExitCode {
    let mut gates = Gates::default();
    let baseline = || {
        angles().for_each(|angle| {
            black_box((512.0 * angle.si()).sin_cos());
        });
    };
    let pair = SinePair { periods: 512, level: None };
    let format = SsiFormat { turns: 12, steps: 13 };
    let absolute = Some(Absolute { protocol: Protocol::EnDat, format });
    let interface = Interface::Sine { pair, commutation: None, has_reference: false, absolute };
    let sine = Encoder { interface, deviation: None };
    let tracks = SquareTracks { periods: 2048 };
    let commutation = CommutationPhases { periods: 5 };
    let square = Encoder { interface: Interface::Square { tracks, commutation }, deviation: None };
    let ssi = SsiFormat { turns: 12, steps: 17 };
    let still = AngularVelocity::from_si(0.0);
    let mut gate = |what: &str, most: f64, measured: &mut dyn FnMut()| {
        let [own, other] = [least_processor_s(9, 40, &mut *measured), least_processor_s(9, 40, baseline)];
        gates.share_at_most(what, own / other, ("a sine and cosine each", most));
        println!("  millions a second, by processor time: {:.0}; ten are promised", f64::from(COUNT) / own / 1e6);
    };
    gate("a sine track", 3.0, &mut || {
        angles().for_each(|angle| {
            black_box(sine.at(Signal::A, angle));
        });
    });
    gate("a square track", 4.0, &mut || {
        angles().for_each(|angle| {
            black_box(square.at(Signal::A, angle));
        });
    });
    gate("an EnDat word", 4.0, &mut || {
        angles().for_each(|angle| {
            let position = format.position(Shaft::new(3, angle, still));
            let frame = Frame { position: position.turns << 13 | position.step, is_error: false };
            black_box(frame.word(25, ErrorBits::Both));
        });
    });
    gate("an SSI word", 3.0, &mut || {
        angles().for_each(|angle| {
            black_box(ssi.word(ssi.position(Shaft::new(3, angle, still))));
        });
    });
    let mut tracking = TrackingLoop::at_rest(Angle::from_si(0.0));
    gate("a step of the tracking loop", 6.0, &mut || {
        angles().for_each(|angle| {
            let (sine, cosine) = angle.si().sin_cos();
            black_box(tracking.step([sine, cosine]));
        });
    });
    gates.close()
}
