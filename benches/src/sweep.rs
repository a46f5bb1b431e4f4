//! Many axes.
#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a bench fails loudly and prints what it measured"
)]
use project::NoFiles;
use questions::Patience;
use questions::sweep::{Cells, Judged, Options, Sweep};
use std::time::Instant;

const MOVE: &str = "format = 1\n[load]\ninertia = \"1 kg m^2\"\nfriction_torque = \"5 N m\"\n[[motion]]\n\
    law = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"0.5 s\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n";

struct Seeded(u64);
impl Seeded {
    fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
    fn log(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.share())
    }
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }
}

fn main() {
    let rows: usize = std::env::var("ROWS").ok().and_then(|rows| rows.parse().ok()).unwrap_or(5_000);
    let heads =
        ["load.inertia [kg m^2]", "load.friction_torque [N m]", "motion[0].time [s]", "motion[0].distance [deg]"];
    let sweep = Sweep::new(("axis.toml", MOVE), Box::new(NoFiles), &heads, Options::default()).expect("a sweep");
    for (name, hard) in [("mixed", false), ("hard", true)] {
        let mut seeded = Seeded(7);
        let mut columns = vec![Vec::new(); 4];
        for _ in 0..rows {
            let values = if hard {
                [seeded.log(1e-3, 1e-2), seeded.between(0.0, 0.3), seeded.between(2.0, 5.0), seeded.between(10.0, 90.0)]
            } else {
                [
                    seeded.log(0.05, 5.0),
                    seeded.between(0.0, 20.0),
                    seeded.between(0.3, 2.0),
                    seeded.between(20.0, 180.0),
                ]
            };
            columns.iter_mut().zip(values).for_each(|(column, value)| column.push(Some(value)));
        }
        let cells: Vec<Cells<'_>> = columns.into_iter().map(Cells::Numbers).collect();
        let began = Instant::now();
        let found = sweep.judge(&cells, &Patience::endless()).expect("not cancelled");
        let seconds = began.elapsed().as_secs_f64();
        let fit: f64 = found
            .iter()
            .map(|answer| match answer {
                Ok(Judged::Best(best)) => f64::from(best.fit),
                other => panic!("{other:?}"),
            })
            .sum();
        println!("{name}: {:.1} us a row, {:.1} fit on average", seconds / rows as f64 * 1e6, fit / rows as f64);
    }
}
