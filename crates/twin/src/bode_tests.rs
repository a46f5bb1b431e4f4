use super::*;
use crate::{Parameters, Switches};
use mechanism::{Extra, Mechanism};
use motion::{Closing, Hold, Motion, SegmentSpec};
use provenance::{Datum, Grade, Source, Sourced};
use quantities::{Measure, MomentOfInertia, Time, Torque};

/// Returns the motor speed in response to a sinusoidal speed setpoint, as a complex amplitude over the last periods.
fn swung(setup: &Setup<'_>, frequency: f64) -> Complex {
    let mut twin = Twin::new(setup).unwrap();
    let amplitude = 1e-4;
    let omega = TAU * frequency;
    let (start, end) = (1.5, 1.5 + 10.0 / frequency);
    let mut sum = Complex::new(0.0, 0.0);
    let mut count = 0.0;
    while twin.time_s() < end {
        let time = twin.time_s();
        twin.want_speed(amplitude * (omega * time).sin());
        // The speed at the middle of eight periods represents them.
        for _ in 0..8 {
            if twin.time_s() >= start {
                let now = twin.sample();
                let unit = Complex::unit(-omega * now.time_s);
                sum = sum + unit * now.motor_rad_s;
                count += 1.0;
            }
            twin.advance(1);
        }
    }
    // A sine is the imaginary part: its amplitude is 2j/N Σ.
    sum * Complex::new(0.0, 2.0 / (count * amplitude))
}

/// The response of the simulated drive to a sinusoidal speed setpoint, sampled at the rate of the position loop, agrees
/// with the transfer function below, near and above the resonance.
#[test]
fn the_simulated_drive_answers_as_the_transfer_function_says() {
    let code = order_code::parse("CHA-20A-100-H-C1024").unwrap().code;
    let mut parameters = Parameters::of(&configurator::parameters(&code).unwrap());
    parameters.model.gear_damping_ratio.value = 0.3;
    let heat = &mut parameters.actuator.heat;
    for time_constant in [&mut heat.winding_time_constant, &mut heat.housing_time_constant] {
        let (value, source) = (Time::from_si(1e15), Source::Model { name: "twin" });
        *time_constant = Datum::Known(Sourced { value, source, grade: Grade::Assumed, errata: &[] });
    }
    let mechanism = Mechanism::direct(MomentOfInertia::from_si(1.3), Torque::from_si(0.0));
    let rest = SegmentSpec::Dwell(Time::from_si(4.0), Hold::Motor);
    let motion = Motion::new(&[rest], None, Closing::SingleMove).unwrap();
    let extras = [Extra::none()];
    for delay in [false, true] {
        let switches = Switches { delay, ..Switches::none() };
        let setup = Setup {
            switches,
            speed_step: Some(0.0),
            substeps: 2,
            ..Setup::of(&parameters, &mechanism, &motion, &extras)
        };
        let twin = Twin::new(&setup).unwrap();
        let linear = linear(&twin, &setup);
        for frequency in [8.0, 20.0, 50.0, 125.0, 250.0] {
            let s = Complex::new(0.0, TAU * frequency);
            let [_, closed] = linear.both(Loop::Speed, s);
            let wanted = closed * Linear::repeated(s, Loop::Position, Loop::Speed);
            let found = swung(&setup, frequency);
            let error = (found - wanted).size() / wanted.size();
            assert!(error < 0.02, "{frequency} Hz, {delay}: {found:?} {wanted:?}, {error}");
        }
    }
}

/// A loop K/s has its crossover at K/2π, a phase margin of 90°, and no gain margin.
#[test]
fn margins_of_an_integrator_by_hand() {
    let points: Vec<Response> = (0..=400)
        .map(|k| {
            let frequency_hz = 0.1 * 10_f64.powf(f64::from(k) / 100.0);
            let open = 10.0 / frequency_hz;
            let closed = open / open.hypot(1.0);
            Response { frequency_hz, open, open_phase_rad: -0.5 * PI, closed, closed_phase_rad: -open.recip().atan() }
        })
        .collect();
    let found = margins(&points);
    assert!((found.crossover_hz.unwrap() - 10.0).abs() < 1e-9 && found.gain.is_none() && found.stable);
    assert!((found.phase_rad.unwrap() - 0.5 * PI).abs() < 1e-12);
    assert!((found.bandwidth_hz.unwrap() - 10.0).abs() < 0.01, "{found:?}");
}
