//! The linear drive against another integrator, and the order of the step.

use super::{NOTHING, load, one_move, parameters, replaced};
use twin::{Parameters, Setup, Switches, Twin};

/// Parameters whose winding does not warm up.
fn of_constant_resistance() -> Parameters {
    let mut parameters = parameters("CHA-20A-100-H-C1024");
    let heat = &mut parameters.actuator.heat;
    replaced(&mut heat.winding_time_constant, 1e15);
    replaced(&mut heat.housing_time_constant, 1e15);
    parameters
}

/// i_q, i_d, Ω, ω every eighth period after a step of the speed.
fn run(substeps: u32, step: f64, periods: u64) -> Vec<[f64; 4]> {
    let (parameters, mechanism, motion, extras) =
        (of_constant_resistance(), load(1.3, 0.0), one_move(1.0, 0.1, 1.0, 0.1), NOTHING());
    let setup = Setup {
        switches: Switches::none(),
        speed_step: Some(step),
        substeps,
        ..Setup::of(&parameters, &mechanism, &motion, &extras)
    };
    let mut twin = Twin::new(&setup).unwrap();
    let mut rows = Vec::new();
    for _ in 0..periods / 8 {
        let now = twin.sample();
        rows.push([now.current_q_a, now.current_d_a, now.motor_rad_s, now.speed_rad_s]);
        twin.advance(8);
    }
    rows
}

fn largest(rows: &[[f64; 4]], column: usize) -> f64 {
    rows.iter().fold(0.0, |most: f64, row| most.max(row[column].abs()))
}

fn farthest(a: &[[f64; 4]], b: &[[f64; 4]], column: usize) -> f64 {
    a.iter().zip(b).fold(0.0, |most: f64, (a, b)| most.max((a[column] - b[column]).abs()))
}

/// LSODA of SciPy with rtol 1e-10, see validation/twin: its own constants from the tables, its own controller.
#[test]
fn a_step_of_the_speed_is_that_of_lsoda() {
    let text = include_str!("../../../../validation/twin/speed_step.csv");
    let other: Vec<[f64; 4]> = text
        .lines()
        .skip(2)
        .map(|line| {
            let values: Vec<f64> = line.split(',').map(|value| value.parse().unwrap()).collect();
            [values[1], values[2], values[3], values[4]]
        })
        .collect();
    let own = run(6, 0.05, 800);
    assert_eq!(own.len(), other.len());
    for column in [0, 1, 2, 3] {
        let (difference, size) = (farthest(&own, &other, column), largest(&other, column));
        assert!(difference < 1e-6 * size, "column {column}: {difference:e} of {size}");
    }
}

/// Half the step, a sixteenth of the error: fourth order. The step stays within the first region of the torsion, where the
/// equations are smooth.
#[test]
fn the_method_is_of_fourth_order() {
    let reference = run(96, 0.002, 400);
    let errors: Vec<f64> = [1, 2, 4, 8].map(|substeps| farthest(&run(substeps, 0.002, 400), &reference, 0)).into();
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((3.7..4.5).contains(&order), "{order} {errors:?}");
    }
}
