//! Operation over days by mean losses, against the stepped model.

use super::{NOTHING, load, one_move, parameters, replaced};
use actuator::{Losses, Temperatures};
use quantities::{Measure, ThermodynamicTemperature};
use twin::{Averaged, Operation, Parameters, Scenario, Setup, Twin, averaged};

const DAY_S: f64 = 86_400.0;

/// Returns an actuator whose housing and winding are warm within minutes, so that the stepped model comes to an end.
fn quick() -> Parameters {
    let mut parameters = parameters("CHA-20A-100-H-C1024");
    let heat = &mut parameters.actuator.heat;
    replaced(&mut heat.winding_time_constant, 8.0);
    replaced(&mut heat.housing_time_constant, 80.0);
    parameters
}

/// Over two time constants of the housing from cold, the averaged housing is within 0.03 K of the stepped one at every
/// minute, the winding within its range in a cycle, compared with a rise of 20 K; the losses agree within a thousandth,
/// the supply within a hundredth.
#[test]
fn the_averaged_model_follows_the_stepped_one() {
    let parameters = quick();
    let (mechanism, motion, extras) = (load(1.3, 12.0), one_move(30.0, 0.1, 0.3, 0.1), NOTHING());
    let setup = Setup { ambient_k: 303.15, ..Setup::of(&parameters, &mechanism, &motion, &extras) };
    let mut stepped = Twin::new(&Setup { scenario: Scenario { cycles: 300, ..Scenario::default() }, ..setup }).unwrap();
    for minute in 1..=3 {
        let until = 60.0 * f64::from(minute);
        while stepped.time_s() < until - 1e-9 && !stepped.is_over() {
            stepped.advance(16);
        }
        let time = stepped.time_s();
        let operation = Operation { periods: 1, period_s: time, running_s: time };
        let Averaged { end_k, lost_j, supplied_j, cycles, .. } = averaged(&setup, operation, || true).unwrap().unwrap();
        let (now, summary) = (stepped.sample(), stepped.summary());
        let errors = [end_k[0] - now.winding_k, end_k[1] - now.housing_k];
        assert!(errors[0].abs() < 0.3 && errors[1].abs() < 0.03, "{minute}: {errors:?}, {now:?}");
        assert!(now.housing_k > 303.15 + 8.0, "{now:?}");
        let copper = lost_j[0] / summary.energies.copper_j - 1.0;
        let supply = supplied_j / summary.supplied_j - 1.0;
        assert!(copper.abs() < 1e-3 && supply.abs() < 1e-2, "{minute}: {copper} {supply}");
        assert!((cycles - time / 0.6).abs() < 1e-3, "{cycles}");
    }
}

/// The course of a period is that of the stepped model in operation and of the network alone at rest; the highest winding
/// temperature within a cycle is that of the stepped model.
#[test]
fn the_course_of_a_period_follows_the_stepped_model() {
    let parameters = quick();
    let (mechanism, motion, extras) = (load(1.3, 12.0), one_move(30.0, 0.1, 0.3, 0.1), NOTHING());
    let setup = Setup { ambient_k: 303.15, ..Setup::of(&parameters, &mechanism, &motion, &extras) };
    let operation = Operation { periods: 2, period_s: 288.0, running_s: 144.0 };
    let found = averaged(&setup, operation, || true).unwrap().unwrap();
    assert_eq!(found.courses.iter().map(|course| course.number).collect::<Vec<_>>(), [1, 2]);
    let first = &found.courses[0].points;
    assert_eq!(first.len(), twin::POINTS_OF_A_PERIOD as usize + 1);
    assert!((first[first.len() - 1].time_s - 288.0).abs() < 1e-9);
    // The second period begins as the first ends.
    assert_eq!(first[first.len() - 1].winding_k, found.courses[1].points[0].winding_k);
    let mut stepped = Twin::new(&Setup { scenario: Scenario { cycles: 240, ..Scenario::default() }, ..setup }).unwrap();
    let mut compared = 0;
    for block in 1..=12 {
        // Twelve seconds are twenty cycles, and sixty points.
        let (mut sum, mut count, mut highest) = (0.0, 0.0, 0.0_f64);
        let until = 12.0 * f64::from(block);
        while stepped.time_s() < until - 1e-9 {
            stepped.advance(160);
            let now = stepped.sample().winding_k;
            // The last cycle of the block.
            if stepped.time_s() > until - 0.6 {
                (sum, count, highest) = (sum + now, count + 1.0, highest.max(now));
            }
        }
        let point = first[block as usize * 60];
        let now = stepped.sample();
        assert!((point.housing_k - now.housing_k).abs() < 0.03, "{block}: {point:?} {now:?}");
        assert!((point.winding_k - sum / count).abs() < 0.15, "{block}: {point:?} {}", sum / count);
        assert!((point.winding_peak_k - highest).abs() < 0.15, "{block}: {point:?} {highest}");
        compared += usize::from(point.winding_peak_k > point.winding_k + 0.1);
    }
    assert!(compared > 6, "{compared}");
    // At rest: the network without losses, by Heun's method with a hundredth of a second.
    let heat = actuator::HeatModel::of(&parameters.actuator).unwrap();
    let ambient = ThermodynamicTemperature::from_si(303.15);
    let of = |[winding, housing]: [f64; 2]| {
        let [winding, housing] = [winding, housing].map(ThermodynamicTemperature::from_si);
        let flows = heat.network().flows(&Temperatures { winding, housing }, Losses::default(), ambient);
        [flows.winding_k_per_s, flows.housing_k_per_s]
    };
    let mut state = [first[720].winding_k, first[720].housing_k];
    for point in &first[721..] {
        for _ in 0..20 {
            let one = of(state);
            let two = of([state[0] + 0.01 * one[0], state[1] + 0.01 * one[1]]);
            state = [0, 1].map(|k: usize| state[k] + 0.005 * (one[k] + two[k]));
        }
        let error = (point.winding_k - state[0]).abs().max((point.housing_k - state[1]).abs());
        assert!(error < 1e-3 && point.winding_peak_k == point.winding_k, "{point:?} {state:?}");
    }
}

/// A year of days with sixteen hours of operation: each day from the warmth of the rest to the settled state and back.
#[test]
fn a_year_settles_into_equal_days() {
    let parameters = parameters("CHA-20A-100-H-C1024");
    let (mechanism, motion, extras) = (load(1.3, 12.0), one_move(30.0, 0.1, 0.3, 0.1), NOTHING());
    let setup = Setup { ambient_k: 303.15, ..Setup::of(&parameters, &mechanism, &motion, &extras) };
    let run = |days, hours| {
        let operation = Operation { periods: days, period_s: DAY_S, running_s: hours * 3600.0 };
        averaged(&setup, operation, || true).unwrap().unwrap()
    };
    let year = run(365, 16.0);
    let settled = twin::settled(&setup, || true).unwrap().unwrap();
    for (peak, settled) in year.peak_k.iter().zip(settled) {
        assert!((peak - settled).abs() < 0.3, "{year:?} {settled:?}");
    }
    // The rest of eight hours is long against the housing.
    assert!(year.swing_k[0] > 0.9 * (settled[0] - 303.15), "{year:?}");
    assert_eq!(year.starts, 365);
    assert!((year.running_s - 365.0 * 16.0 * 3600.0).abs() < 1e-3);
    // A day is a day, but for the first, which begins cold.
    let (two, three) = (run(2, 16.0), run(3, 16.0));
    let day = three.supplied_j - two.supplied_j;
    assert!((year.supplied_j / (365.0 * day) - 1.0).abs() < 1e-3, "{year:?} {day}");
    // All day long, and not at all.
    let (always, never) = (run(3, 24.0), run(3, 0.0));
    assert_eq!((always.starts, never.cycles), (1, 0.0));
    assert!(never.peak_k == [303.15; 2] && never.supplied_j == 0.0);
    assert_eq!(averaged(&setup, Operation { periods: 1, period_s: DAY_S, running_s: DAY_S }, || false), Ok(None));
}
