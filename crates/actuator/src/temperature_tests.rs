//! Tests of the thermal model.

use super::*;
use provenance::{CellRef, Datum, Sourced};

fn known<T>(value: T) -> Datum<T> {
    const CELL: CellRef = CellRef::of_the_manual("26.1", "x", "");
    Datum::Known(Sourced { value, source: Source::Cell(&CELL), grade: Grade::Printed, errata: &[] })
}

/// CHA-20A: R_LL = 5.9 Ω, I_0 = 2.1 A, hence 48.23 W at 80 °C.
fn motor() -> Thermal {
    Thermal::of(&Parameters {
        stall_current: known(ElectricCurrent::from_si(2.1)),
        resistance_ll: known(ElectricalResistance::from_si(5.9)),
        ..Parameters::unknown()
    })
    .unwrap()
}

fn celsius(value: f64) -> ThermodynamicTemperature {
    ThermodynamicTemperature::from_si(value + 273.15)
}

fn watt(value: f64) -> Power {
    Power::from_si(value)
}

#[test]
fn at_the_stall_loss_the_winding_warms_by_forty_kelvin() {
    let loss = copper_loss(ElectricalResistance::from_si(5.9), ElectricCurrent::from_si(2.1));
    assert!((loss.si() - 1.5 * 5.9 * 1.2358 * 4.41).abs() < 1e-9);
    let steady = motor().steady(loss, celsius(40.0));
    assert!((steady.winding.si() - celsius(80.0).si()).abs() < 1e-9);
    assert!((steady.housing.si() - celsius(76.0).si()).abs() < 1e-9);
}

#[test]
fn the_modes_together_are_the_resistances() {
    let thermal = motor();
    let [r_wh, r_ha] = thermal.resistance_k_per_w;
    assert!((thermal.gain_winding.iter().sum::<f64>() - r_wh - r_ha).abs() < 1e-12);
    assert!((thermal.gain_housing.iter().sum::<f64>() - r_ha).abs() < 1e-12);
    // a = 1/60, c = 9/2400, d = 1/2400 per second: s² + s/48 + 1/144000 = 0.
    let [quick, slow] = thermal.tau_s;
    assert!((quick - 48.793).abs() < 0.001 && (slow - 2951.2).abs() < 0.1, "{quick} {slow}");
    assert!((quick * slow - 60.0 * 2400.0).abs() < 1e-6);
}

/// Brute force: the two equations by Runge and Kutta, many periods.
fn integrate(thermal: &Thermal, pieces: &[(f64, f64)], periods: usize) -> (f64, f64) {
    let [r_wh, r_ha] = thermal.resistance_k_per_w;
    let (c_w, c_h) = (60.0 / r_wh, 2400.0 / r_ha);
    let slope = |w: f64, h: f64, p: f64| ((p - (w - h) / r_wh) / c_w, ((w - h) / r_wh - h / r_ha) / c_h);
    let (mut w, mut h) = (0.0, 0.0);
    let mut largest = (0.0_f64, 0.0_f64);
    for _ in 0..periods {
        largest = (0.0, 0.0);
        for &(duration, p) in pieces {
            let steps = 4000;
            let dt = duration / f64::from(steps);
            for _ in 0..steps {
                let (w1, h1) = slope(w, h, p);
                let (w2, h2) = slope(w + dt / 2.0 * w1, h + dt / 2.0 * h1, p);
                let (w3, h3) = slope(w + dt / 2.0 * w2, h + dt / 2.0 * h2, p);
                let (w4, h4) = slope(w + dt * w3, h + dt * h3, p);
                w += dt / 6.0 * (w1 + 2.0 * w2 + 2.0 * w3 + w4);
                h += dt / 6.0 * (h1 + 2.0 * h2 + 2.0 * h3 + h4);
                largest = (largest.0.max(w), largest.1.max(h));
            }
        }
    }
    largest
}

fn cycle(thermal: &Thermal, pieces: &[(f64, f64)]) -> CycleTemperatures {
    let typed: Vec<_> = pieces.iter().map(|&(t, p)| (Time::from_si(t), watt(p))).collect();
    thermal.cycle(&typed, celsius(0.0))
}

#[test]
fn the_cycle_agrees_with_a_long_integration() {
    let thermal = motor();
    for (pieces, periods) in [
        (vec![(20.0, 200.0), (40.0, 0.0)], 700),
        (vec![(300.0, 90.0), (10.0, 300.0), (600.0, 5.0)], 60),
        (vec![(3600.0, 60.0), (3600.0, 10.0)], 20),
    ] {
        let (w, h) = integrate(&thermal, &pieces, periods);
        let found = cycle(&thermal, &pieces);
        assert!((found.winding_max.si() - 273.15 - w).abs() < 1e-4, "{} {w}", found.winding_max.si() - 273.15);
        assert!((found.housing.si() - 273.15 - h).abs() < 1e-4, "{} {h}", found.housing.si() - 273.15);
    }
}

#[test]
fn short_cycles_warm_like_the_mean_loss_and_constant_loss_like_the_steady_state() {
    let thermal = motor();
    let steady = thermal.steady(watt(30.0), celsius(0.0));
    for pieces in [vec![(1e-3, 90.0), (2e-3, 0.0)], vec![(7.0, 30.0), (11.0, 30.0)]] {
        let found = cycle(&thermal, &pieces);
        assert!((found.winding_max.si() - steady.winding.si()).abs() < 1e-3);
        assert!((found.housing.si() - steady.housing.si()).abs() < 1e-3);
    }
    assert_eq!(cycle(&thermal, &[]).winding_max, celsius(0.0));
}

/// In the steady periodic state the mean of each lag is the mean of its input: the heat let in is let out.
#[test]
fn the_energy_balance_of_a_period_closes() {
    let thermal = motor();
    let pieces = [(20.0, 200.0), (40.0, 0.0), (5.0, 400.0), (100.0, 10.0)];
    let (period, heat) = pieces.iter().fold((0.0, 0.0), |(t, w), (dt, p)| (t + dt, w + dt * p));
    for tau in thermal.tau_s {
        let starts = periodic_lag(&pieces, tau);
        let area: f64 =
            starts.iter().zip(pieces).map(|(start, (dt, p))| p * dt - (start - p) * tau * (-dt / tau).exp_m1()).sum();
        assert!((area / period - heat / period).abs() < 1e-9);
    }
}

#[test]
fn the_hottest_moment_is_the_end_of_the_largest_loss() {
    let found = cycle(&motor(), &[(40.0, 0.0), (20.0, 200.0), (40.0, 0.0)]);
    assert!((found.at.si() - 60.0).abs() < 1e-12);
}

#[test]
fn warming_up_takes_longer_the_nearer_the_threshold_is_to_the_end() {
    let thermal = motor();
    let time = |loss, threshold| thermal.warm_up_time(watt(loss), celsius(40.0), celsius(threshold)).map(Time::si);
    let stall = copper_loss(ElectricalResistance::from_si(5.9), ElectricCurrent::from_si(2.1)).si();
    assert_eq!(time(stall, 81.0), None);
    assert_eq!(time(0.0, 80.0), None);
    assert_eq!(time(stall, 40.0), Some(0.0));
    let mut last = 0.0;
    for threshold in [45.0, 50.0, 60.0, 70.0, 79.0, 79.999] {
        let now = time(stall, threshold).unwrap();
        assert!(now > last);
        // The time found gives the threshold back.
        let [g1, g2] = thermal.gain_winding;
        let [t1, t2] = thermal.tau_s;
        let rise = stall * (g1 * (1.0 - (-now / t1).exp()) + g2 * (1.0 - (-now / t2).exp()));
        assert!((rise + 40.0 - threshold).abs() < 1e-9);
        last = now;
    }
    // Twice the loss: the threshold lies at half of the rise, a little before τ_slow ln 2 = 2046 s.
    let twice = time(2.0 * stall, 80.0).unwrap();
    assert!(twice > 1700.0 && twice < 2046.0, "{twice}");
}
