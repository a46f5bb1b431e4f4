//! Life of the output bearing against a direct integral over the angle: every mechanism, alone and behind a stage, under several
//! laws, at constant speed too.

use crate::physics::read;
use axis::AxisProject;
use mechanism::{Extra, Output};
use quantities::unit::HOUR;
use quantities::{Length, Measure};
use questions::{CheckId, check};
use std::f64::consts::TAU;
use testkit::projects::{Drawn, Draws, mechanisms, moved};

/// R, d_p \[m\], C \[N\] and B of table 55.1, 74.5.
const SIZES: [(&str, f64, f64, f64, f64); 2] =
    [("CHA-25A-100-H-C1024", 0.018, 0.088, 30_000.0, 10.0 / 3.0), ("CHA-17A-100-H-RES", 0.014, 0.058, 11_500.0, 3.0)];

/// Without any load the life is without end.
fn life_h(project: &AxisProject, code: &str) -> f64 {
    let code = order_code::parse(code).unwrap().code;
    let found = check(project, &code).unwrap();
    let life = found.judgement.checks.iter().find(|check| check.id == CheckId::BearingLife).unwrap();
    assert!(life.value.is_some() || life.notes.contains(&sizing::Note::NoBearingLoad), "{life:?}");
    life.value.map_or(f64::INFINITY, |life| life.si / HOUR.to_si(1.0))
}

/// Eq. 74.1 to 75.4 with averages by a sum over many short steps of every piece.
fn direct_life_h(project: &AxisProject, (_, r, d_p, c, b): (&str, f64, f64, f64, f64), steps: u32) -> f64 {
    let axis = &project.axis;
    let mounting = axis.bearing.as_ref().unwrap().derived.as_ref().unwrap().mounting;
    let (mut sums, mut travelled, mut time) = ([0.0; 3], 0.0, 0.0);
    for piece in axis.motion.pieces() {
        time += piece.duration_s;
        if piece.is_rest() {
            continue;
        }
        let dt = piece.duration_s / f64::from(steps);
        for step in 0..steps {
            let state = piece.at((f64::from(step) + 0.5) * dt);
            let output = Output {
                position_rad: state.position_rad,
                speed_rad_s: state.speed_rad_s,
                acceleration_rad_s2: state.acceleration_rad_s2,
                direction: state.speed_rad_s.signum(),
            };
            let extra = axis.extras.get(piece.segment).copied().unwrap_or_else(Extra::none);
            let forces = axis.mechanism.flange_forces(&output, &extra, 0.0, &mounting);
            let weight = state.speed_rad_s.abs() * dt;
            let values = [forces.radial(), forces.axial(), forces.moment(Length::from_si(r))];
            sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value.powf(b));
            travelled += weight;
        }
    }
    let [radial, axial, moment] = sums.map(|sum: f64| (sum / travelled).powf(1.0 / b));
    let across = radial + 2.0 * moment / d_p;
    let (x, y) = if axial <= 1.5 * across { (1.0, 0.45) } else { (0.67, 0.67) };
    let speed = travelled / TAU / time * 60.0;
    1e6 / (60.0 * speed) * (c / (1.2 * (x * across + y * axial))).powf(b)
}

const BEARING: &str = "load_factor = 1.2\noperating_condition = \"normal\"\n";

/// The laws under which a mechanism goes through its stroke, at constant speed too.
fn motions(drawn: &Drawn, time_s: f64) -> Vec<(&'static str, String)> {
    let stroke = drawn.stroke_deg;
    let steady =
        format!("[[motion]]\nlaw = \"constant\"\nspeed = \"{} deg/s\"\ntime = \"{time_s} s\"\n", stroke / time_s);
    vec![
        ("constant", steady),
        ("trapezoid", moved("trapezoid", stroke, time_s)),
        ("polynomial_5", moved("polynomial_5", stroke, time_s)),
        ("modified_sine", moved("modified_sine", stroke, time_s)),
    ]
}

/// Every mechanism, under every law, within 10⁻⁴ of the direct integral.
#[test]
fn the_life_of_every_mechanism_is_the_integral_over_the_angle() {
    let mut seen = Vec::new();
    for seed in 0..2 {
        for drawn in mechanisms(&mut Draws::new(seed)) {
            if drawn.bearing.is_none() {
                continue;
            }
            seen.push(drawn.key);
            let time = drawn.stroke_deg / 360.0;
            for ((law, motion), size) in motions(&drawn, time).into_iter().zip(SIZES.into_iter().cycle()) {
                let text = drawn.project(&motion, BEARING, "");
                let project = read(&text);
                let (found, direct) = (life_h(&project, size.0), direct_life_h(&project, size, 40_000));
                assert!(found == direct || (found / direct - 1.0).abs() < 1e-4, "{law}: {found} for {direct}\n{text}");
            }
        }
    }
    for id in mechanism::MechanismId::ALL {
        // A recorded joint describes no motion of its own.
        assert!(seen.contains(&id.key()) || id.key() == "joint", "{}", id.key());
    }
}

/// So slow that inertia has no part in it, a stroke wears the bearing as much under any law: the averages are those over the angle.
#[test]
fn the_life_of_a_slow_stroke_does_not_depend_on_the_law() {
    for drawn in mechanisms(&mut Draws::new(11)) {
        if drawn.bearing.is_none() {
            continue;
        }
        let time = 40.0 * drawn.stroke_deg;
        let lives: Vec<(&str, f64)> = motions(&drawn, time)
            .into_iter()
            .map(|(law, motion)| (law, life_h(&read(&drawn.project(&motion, BEARING, "")), SIZES[0].0)))
            .collect();
        let first = lives[0].1;
        assert!(
            lives.iter().all(|(_, life)| *life == first || (life / first - 1.0).abs() < 1e-4),
            "{lives:?}\n{}",
            drawn.sections
        );
    }
}

/// The winder of the examples from core to full roll: F_r = F + π ρ b (r² − r_k²) g over the angle, M = F_r (L + R), by hand.
#[test]
fn the_winder_of_the_examples_by_hand() {
    let example = include_str!("../../../../../examples/winder.toml");
    let (core, full, thickness) = (0.045, 0.165, 0.002);
    let steps = 200_000;
    let power = (0..steps).map(|step| {
        let r = core + (full - core) * (f64::from(step) + 0.5) / f64::from(steps);
        let web = std::f64::consts::PI * 900.0 * 0.4 * (r * r - core * core);
        (80.0 + web * 9.806_65).powf(10.0 / 3.0)
    });
    let radial = (power.sum::<f64>() / f64::from(steps)).powf(0.3);
    let equivalent = radial + 2.0 * radial * (0.06 + 0.018) / 0.088;
    let turns = (full - core) / thickness;
    for law in ["trapezoid", "polynomial_5", "constant"] {
        let text = match law {
            "constant" => example
                .replace("law = \"trapezoid\"\ndistance = \"21600 deg\"\n", "law = \"constant\"\ntime = \"90 s\"\n")
                .replace("[[motion]]\nlaw = \"dwell\"\ntime = \"20 s\"\n", ""),
            _ => example.to_owned(),
        };
        let text = text.replace("acceleration = \"2 rad/s^2\"\n", "");
        let text = match law {
            "polynomial_5" => {
                text.replace("speed = \"40 1/min\"", "time = \"100 s\"").replace("\"trapezoid\"", "\"polynomial_5\"")
            }
            _ => text,
        };
        let project = read(&text);
        let minutes = project.axis.motion.duration().si() / 60.0;
        let expected = 1e6 / (60.0 * turns / minutes) * (30_000.0 / (1.2 * equivalent)).powf(10.0 / 3.0);
        let found = life_h(&project, SIZES[0].0);
        assert!((found / expected - 1.0).abs() < 1e-4, "{law}: {found} for {expected}");
    }
}
