//! The judgement of a recorded motion does not depend on the noise in which the axis rests: neither on its size nor on
//! its kind, its interval or on the columns that are there.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use axis::Assumption;
use axis::{AxisProject, Files};
use quantities::{Measure, MomentOfInertia};
use std::fmt::Write as _;

struct Given(String);

impl Files for Given {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        Ok(Box::new(std::io::Cursor::new(self.0.clone())))
    }
}

/// Numbers that look random, normal with a standard deviation of 1.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        let mut uniform = || {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            (self.0 >> 11) as f64 / (1_u64 << 53) as f64
        };
        (0..12).map(|_| uniform()).sum::<f64>() - 6.0
    }
}

/// Half a second forth by 90°, 9 s rest, half a second back; speeds in degrees per second with noise.
fn recording(interval_ms: u32, noise_deg_s: f64, with_position: bool, noise: &mut Noise) -> Given {
    let mut text = String::from(if with_position { "t [s],q [deg],n [deg/s]\n" } else { "t [s],n [deg/s]\n" });
    let of = |t: f64| {
        let x = (t / 0.5).clamp(0.0, 1.0);
        (90.0 * x * x * x * (10.0 - 15.0 * x + 6.0 * x * x), 5400.0 * x * x * (1.0 - x) * (1.0 - x))
    };
    for k in 0..=10_000 / interval_ms {
        let t = f64::from(k * interval_ms) * 1e-3;
        let ((forth, fast), (back, slow)) = (of(t), of(t - 9.5));
        let is_end = k == 0 || k == 10_000 / interval_ms;
        let (position, speed) = (forth - back, fast - slow + if is_end { 0.0 } else { noise_deg_s * noise.next() });
        match with_position {
            true => writeln!(text, "{t:.3},{position:.9},{speed:e}").unwrap(),
            false => writeln!(text, "{t:.3},{speed:e}").unwrap(),
        }
    }
    Given(text)
}

fn judged(load: &str, files: &Given) -> (AxisProject, f64, f64) {
    let text =
        format!("format = 1\n[axis]\nname = \"rest\"\n{load}\n[[motion]]\nlaw = \"recorded\"\nfile = \"r.csv\"\n");
    let project = questions::read_all(&text, files).unwrap().remove(0);
    let demand = project.axis.demand(MomentOfInertia::from_si(0.1));
    (project, demand.torque_rms.si(), demand.duty_factor)
}

#[test]
fn noise_at_rest_changes_neither_torque_nor_duty() {
    let loads = [
        "[load]\ninertia = \"0.4 kg m^2\"\nfriction_torque = \"20 N m\"",
        "[mechanism.arm]\ninertia = \"1 kg m^2\"\nmass = \"5 kg\"\ncentre_distance = \"100 mm\"\naxis_tilt = \"90 deg\"\n\
         start_angle = \"20 deg\"\nefficiency = 0.8\nfriction_torque = \"8 N m\"",
    ];
    let mut noise = Noise(3);
    for load in loads {
        for interval in [5, 2] {
            for with_position in [true, false] {
                let (_, clean, duty) = judged(load, &recording(interval, 0.0, with_position, &mut noise));
                for size in [1e-13, 1e-9, 1e-6, 1e-4, 1e-3] {
                    let (project, torque, noisy_duty) =
                        judged(load, &recording(interval, size, with_position, &mut noise));
                    let place = format!("{size:e} °/s every {interval} ms, position {with_position}: {load}");
                    assert!((torque / clean - 1.0).abs() < 1e-3, "{torque} Nm for {clean}, {place}");
                    assert!((noisy_duty - duty).abs() < 1e-9, "{noisy_duty} for {duty}, {place}");
                    let is_told =
                        |each: &Assumption| matches!(each, Assumption::RecordedRest(noise) if noise.duration_s > 8.9);
                    assert!(project.assumptions.iter().any(is_told), "{place}: {:?}", project.assumptions);
                }
            }
        }
    }
}
