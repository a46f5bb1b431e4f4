//! Two ways to the energy of a long recording agree: in the order of time, as required for the bank of a DC link, and by cells of
//! alike intervals. Noise turns the sign of torque and power thousands of times.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may fail")]

use axis::Files;
use questions::{CheckId, check};
use sizing::Check;
use std::fmt::Write as _;

struct Given(String);

impl Files for Given {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        Ok(Box::new(std::io::Cursor::new(self.0.clone())))
    }
}

/// 20 000 intervals with swings, a rest and positions rounded so coarsely that the acceleration is mostly noise.
fn recording(digits: usize) -> Given {
    let mut text = String::from("time,position\n");
    for k in 0..=20_000 {
        let t = f64::from(k) * 1e-3;
        let position =
            if (0.4..0.5).contains(&(t / 20.0)) { 1.0 } else { 1.0 - (0.3 * std::f64::consts::PI * t).cos() };
        let eased = position * (1.0 - (-(t * t)).exp()) * (1.0 - (-((20.0 - t).powi(2))).exp());
        writeln!(text, "{t:.3},{eased:.digits$}").unwrap();
    }
    Given(text)
}

fn regeneration(mechanism: &str, files: &Given, requirements: &str) -> Check {
    let text = format!(
        "format = 1\n[axis]\nname = \"noise\"\n{mechanism}\n[[motion]]\nlaw = \"recorded\"\nfile = \"r.csv\"\n\
         units = {{ time = \"s\", position = \"rad\" }}\n[requirements]\nsupply = \"560 V\"\n{requirements}\n"
    );
    let projects = questions::read_all(&text, files).unwrap();
    let code = order_code::parse("CHA-32A-100-H-C1024").unwrap().code;
    let checked = check(&projects[0], &code).unwrap();
    checked.judgement.checks.iter().find(|check| check.id == CheckId::Regeneration).unwrap().clone()
}

#[test]
fn energy_by_cells_is_energy_in_the_order_of_time() {
    let loads = [
        "[load]\ninertia = \"2 kg m^2\"\nfriction_torque = \"1 N m\"",
        "[load]\ninertia = \"0.4 kg m^2\"\nfriction_torque = \"0 N m\"\nviscous_friction = \"2 N m s/rad\"",
        "[mechanism.arm]\ninertia = \"1 kg m^2\"\nmass = \"5 kg\"\ncentre_distance = \"100 mm\"\naxis_tilt = \"90 deg\"\n\
         start_angle = \"20 deg\"",
    ];
    for (load, digits) in loads.into_iter().flat_map(|load| [(load, 5), (load, 9)]) {
        let files = recording(digits);
        let by_cells = regeneration(load, &files, "");
        let in_time = regeneration(load, &files, "dc_link_rise = \"40 V\"");
        let (a, b) = (by_cells.value.unwrap().si, in_time.value.unwrap().si);
        assert!(b > 0.0, "something comes back: {load}");
        assert!((a / b - 1.0).abs() < 1e-10, "{load}, {digits} digits: {a} W by cells, {b} W in time");
        let energies = |check: &Check| {
            let found = check.notes.iter().find_map(|note| match note {
                sizing::Note::EnergyPerCycle { motoring, regenerated, peak } => Some(
                    [motoring, regenerated]
                        .map(|energy| quantities::Measure::si(*energy))
                        .into_iter()
                        .chain([quantities::Measure::si(*peak)]),
                ),
                _ => None,
            });
            found.unwrap().collect::<Vec<f64>>()
        };
        for (a, b) in energies(&by_cells).into_iter().zip(energies(&in_time)) {
            assert!((a / b - 1.0).abs() < 1e-9, "{load}, {digits} digits: {a} by cells, {b} in time");
        }
    }
}
