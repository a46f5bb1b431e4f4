//! Tests of the thermal network.

use super::*;

fn network() -> Network {
    Network::new([0.45, 0.37], [Time::from_si(60.0), Time::from_si(2400.0)])
}

fn celsius(value: f64) -> ThermodynamicTemperature {
    ThermodynamicTemperature::from_si(value + 273.15)
}

fn losses(copper_w: f64, friction_w: f64) -> Losses {
    Losses { copper_w, friction_w }
}

#[test]
fn copper_passes_both_resistances_and_friction_one() {
    let steady = network().steady(losses(20.0, 30.0), celsius(25.0));
    assert!((steady.housing.si() - celsius(25.0 + 50.0 * 0.37).si()).abs() < 1e-12);
    assert!((steady.winding.si() - celsius(25.0 + 50.0 * 0.37 + 20.0 * 0.45).si()).abs() < 1e-12);
}

#[test]
fn the_modes_together_are_the_resistances() {
    let network = network();
    let sum = |gains: [f64; 2]| gains.iter().sum::<f64>();
    assert!((sum(network.winding().copper) - 0.82).abs() < 1e-12);
    for across in [network.winding().friction, network.housing().copper, network.housing().friction] {
        assert!((sum(across) - 0.37).abs() < 1e-12);
    }
    let [quick, slow] = network.time_constants().map(Time::si);
    assert!((quick * slow - 60.0 * 2400.0).abs() < 1e-6, "det = a d");
    // Winding and housing as one node of the slow mode: τ_w (1 + R_ha/R_wh ...) is in between.
    assert!(quick < 60.0 && slow > 2400.0);
}

/// Integrates the two equations by the Runge-Kutta method over many periods; returns the states at the starts of the
/// pieces.
fn integrate(pieces: &[(f64, Losses)], periods: usize) -> Vec<(f64, f64)> {
    let (r_wh, r_ha) = (0.45, 0.37);
    let (c_w, c_h) = (60.0 / r_wh, 2400.0 / r_ha);
    let slope = |w: f64, h: f64, l: &Losses| {
        ((l.copper_w - (w - h) / r_wh) / c_w, (l.friction_w + (w - h) / r_wh - h / r_ha) / c_h)
    };
    let (mut w, mut h) = (0.0, 0.0);
    let mut starts = Vec::new();
    for _ in 0..periods {
        starts.clear();
        for (duration, l) in pieces {
            starts.push((w, h));
            let steps = 2000;
            let dt = duration / f64::from(steps);
            for _ in 0..steps {
                let (w1, h1) = slope(w, h, l);
                let (w2, h2) = slope(w + dt / 2.0 * w1, h + dt / 2.0 * h1, l);
                let (w3, h3) = slope(w + dt / 2.0 * w2, h + dt / 2.0 * h2, l);
                let (w4, h4) = slope(w + dt * w3, h + dt * h3, l);
                w += dt / 6.0 * (w1 + 2.0 * w2 + 2.0 * w3 + w4);
                h += dt / 6.0 * (h1 + 2.0 * h2 + 2.0 * h3 + h4);
            }
        }
    }
    starts
}

#[test]
fn the_course_agrees_with_a_long_integration() {
    for (pieces, periods) in [
        (vec![(20.0, losses(200.0, 40.0)), (40.0, losses(0.0, 0.0))], 600),
        (vec![(300.0, losses(90.0, 0.0)), (10.0, losses(300.0, 90.0)), (600.0, losses(5.0, 20.0))], 50),
    ] {
        let typed: Vec<_> = pieces.iter().map(|(t, l)| (Time::from_si(*t), *l)).collect();
        let found = network().course(&typed, celsius(0.0));
        for (found, (w, h)) in found.iter().zip(integrate(&pieces, periods)) {
            assert!((found.winding.si() - 273.15 - w).abs() < 1e-4, "{} {w}", found.winding.si() - 273.15);
            assert!((found.housing.si() - 273.15 - h).abs() < 1e-4, "{} {h}", found.housing.si() - 273.15);
        }
    }
}

/// The closed form for one operation per cycle equals the course of two pieces at the start of the rest.
#[test]
fn intermittent_duty_is_the_course_of_operation_and_rest() {
    let network = network();
    for (duty, cycle) in [(0.5, 60.0), (0.25, 60.0), (0.9, 3000.0)] {
        let pieces = [
            (Time::from_si(duty * cycle), losses(50.0, 20.0)),
            (Time::from_si((1.0 - duty) * cycle), losses(0.0, 0.0)),
        ];
        let end = network.course(&pieces, celsius(0.0)).get(1).unwrap().winding.si() - 273.15;
        let (a, b) = network.intermittent(duty, Time::from_si(cycle));
        assert!((50.0 * a + 20.0 * b - end).abs() < 1e-9);
    }
    let (a, b) = network.intermittent(1.0, Time::from_si(60.0));
    assert!((a - 0.82).abs() < 1e-12 && (b - 0.37).abs() < 1e-12);
}

#[test]
fn warming_up_takes_longer_the_nearer_the_threshold_is_to_the_end() {
    let network = network();
    // 20·0.82 + 64·0.37 = 40.08 K in steady state.
    let time = |threshold| network.warm_up_time(losses(20.0, 64.0), celsius(40.0), celsius(threshold)).map(Time::si);
    assert_eq!(time(80.1), None);
    assert_eq!(time(40.0), Some(0.0));
    let mut last = 0.0;
    for threshold in [45.0, 50.0, 60.0, 70.0, 79.0, 80.07] {
        let now = time(threshold).unwrap();
        assert!(now > last);
        last = now;
    }
    // A long cycle cut at this time reaches the threshold.
    let now = time(60.0).unwrap();
    let pieces = [(Time::from_si(now), losses(20.0, 64.0)), (Time::from_si(1e6), losses(0.0, 0.0))];
    let there = network.course(&pieces, celsius(40.0)).get(1).unwrap().winding.si();
    assert!((there - celsius(60.0).si()).abs() < 1e-6);
}

/// Losses are either stored or transferred to the air; in the steady state nothing is stored.
#[test]
fn flows_keep_the_energy_and_vanish_in_the_steady_state() {
    let (network, ambient, load) = (network(), celsius(25.0), losses(20.0, 30.0));
    let [c_w, c_h] = network.capacity_j_per_k;
    let state = Temperatures { winding: celsius(70.0), housing: celsius(40.0) };
    let flows = network.flows(&state, load, ambient);
    let stored = c_w * flows.winding_k_per_s + c_h * flows.housing_k_per_s;
    assert!((stored + flows.housing_to_ambient_w - 50.0).abs() < 1e-9);
    assert!((flows.winding_to_housing_w - 30.0 / 0.45).abs() < 1e-9);
    let steady = network.flows(&network.steady(load, ambient), load, ambient);
    assert!(steady.winding_k_per_s.abs() < 1e-12 && steady.housing_k_per_s.abs() < 1e-12);
}

/// Stepped with its own slopes, the network follows the closed form: half a minute of loss, half a minute of rest.
#[test]
fn the_flows_make_the_course() {
    let (network, ambient) = (network(), celsius(25.0));
    let pieces = [(Time::from_si(30.0), losses(80.0, 10.0)), (Time::from_si(30.0), losses(0.0, 0.0))];
    let course = network.course(&pieces, ambient);
    let (mut state, step) = (course[0], 1e-3);
    for _ in 0..30_000 {
        let moved = |state: &Temperatures, slope: &HeatFlows, time: f64| Temperatures {
            winding: ThermodynamicTemperature::from_si(state.winding.si() + time * slope.winding_k_per_s),
            housing: ThermodynamicTemperature::from_si(state.housing.si() + time * slope.housing_k_per_s),
        };
        let first = network.flows(&state, losses(80.0, 10.0), ambient);
        let middle = network.flows(&moved(&state, &first, 0.5 * step), losses(80.0, 10.0), ambient);
        state = moved(&state, &middle, step);
    }
    assert!((state.winding.si() - course[1].winding.si()).abs() < 1e-6);
    assert!((state.housing.si() - course[1].housing.si()).abs() < 1e-6);
}
