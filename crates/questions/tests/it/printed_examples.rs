//! Worked examples that makers print, each with its inputs and its result typed from the document; half the last printed digit is
//! the tolerance.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use quantities::Measure;
use questions::{check_own, read};

/// T_1, T_3, T_rms \[Nm\] and n_av [1/min] by the manual's equations, and T_rms by the exact integral, of an actuator with an inertia.
fn demand(inertia_out: f64, text: &str) -> [f64; 5] {
    let project = read(&format!(
        "format = 1\n{text}[actuator]\nname = \"own\"\nratio = 50\ninertia_out = \"{inertia_out} kg m^2\"\n"
    ));
    let project = project.unwrap();
    let judgement = check_own(&project).unwrap().judgement;
    let (manual, exact) = (judgement.manual.unwrap(), judgement.demand.unwrap());
    let torques = manual.moves.first().unwrap();
    let per_minute = exact.speed_mean.in_unit(&quantities::unit::REVOLUTION_PER_MINUTE);
    let of = |torque: quantities::Torque| torque.si();
    [of(torques.accelerate), of(torques.brake), of(manual.demand.torque_rms), per_minute, of(exact.torque_rms)]
}

fn near(found: f64, printed: f64, half_digit: f64) {
    assert!((found - printed).abs() <= half_digit, "{found} for {printed}");
}

/// FHA-C manual, selection examples 1 and 3, pp. 24 to 32: FHA-25C-50, J 0.81 and 1.5 kgm², 120° at 60 1/min with 0.097 s up and
/// 0.085 s down in 2 s. Printed 150 Nm and 45 Nm. The print takes the braking torque from the acceleration, so the integral is larger:
/// √((149.6² · 0.097 + 170.8² · 0.085)/2 s) = 48.2 Nm.
#[test]
fn the_selection_example_of_the_fha_c() {
    // 120° less both ramps: 2.0944/6.2832 − 0.091 s.
    let [accelerate, _, rms, _, exact] = demand(
        0.81,
        "[load]\ninertia = \"1.5 kg m^2\"\n[[motion]]\nlaw = \"manual\"\nspeed = \"60 1/min\"\naccelerate = \"0.097 s\"\n\
         run = \"0.2423333 s\"\nbrake = \"0.085 s\"\npause = \"1.5756667 s\"\n",
    );
    near(accelerate, 150.0, 0.5);
    near(rms, 45.0, 0.5);
    near(exact, 48.2, 0.05);
}

/// CHA manual of 12/2015, p. 67, with the FHA-25C-50L, J_out 0.86 kgm²: printed 95, −85 and 35 Nm, 6 1/min; exactly 95.48, −85.48,
/// 35.57 and 6.154, which the print cuts.
#[test]
fn the_example_of_an_older_edition() {
    let [accelerate, brake, rms, mean, _] = demand(
        0.86,
        "[load]\ninertia = \"1.3 kg m^2\"\nfriction_torque = \"5 N m\"\n[[motion]]\nlaw = \"manual\"\nspeed = \"40 1/min\"\n\
         accelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\npause = \"1 s\"\n",
    );
    for (found, printed, exact) in
        [(accelerate, 95.0, 95.48), (-brake, 85.0, 85.48), (rms, 35.0, 35.57), (mean, 6.0, 6.154)]
    {
        near(found.trunc(), printed, 0.0);
        near(found, exact, 0.005);
    }
}

/// The largest torque of the load at the output of the actuator \[Nm\].
fn load_peak(text: &str) -> f64 {
    read(&format!("format = 1\n{text}")).unwrap().axis.moments().load_peak.si()
}

/// Honpine, "How to select a harmonic reduction gear": 0.88 kgm² to 3000/101 1/min in 0.12 s, printed 22.8 Nm.
#[test]
fn the_swing_of_honpine() {
    let speed = 3000.0 / 101.0;
    let found = load_peak(&format!(
        "[load]\ninertia = \"0.88 kg m^2\"\n[[motion]]\nlaw = \"manual\"\nspeed = \"{speed} 1/min\"\naccelerate = \"0.12 s\"\n\
         run = \"0.1 s\"\nbrake = \"0.12 s\"\npause = \"1 s\"\n"
    ));
    near(found, 22.8, 0.05);
}

/// Yaskawa E-V-MD, p. 30: a ball screw of 10 mm behind a gear 1/2, 250 kg at 15 m/min, µ 0.2, η 0.9 of the whole; printed 0.43 Nm at
/// the motor at constant speed; here it is so slow that the inertia adds 0.25 N to 490 N.
#[test]
fn the_ball_screw_of_yaskawa() {
    let found = load_peak(
        "[mechanism.screw]\nlead = \"10 mm\"\nmass = \"250 kg\"\nfriction_coefficient = 0.2\nefficiency = 0.9\n\
         [stage]\nkind = \"gear\"\nratio = 2\nefficiency = 1\n\
         [[motion]]\nlaw = \"trapezoid\"\ndistance = \"20 mm\"\nspeed = \"1 mm/s\"\nacceleration = \"1 mm/s^2\"\n\
         [[motion]]\nlaw = \"trapezoid\"\ndistance = \"-20 mm\"\nspeed = \"1 mm/s\"\nacceleration = \"1 mm/s^2\"\n",
    );
    near(found, 0.43, 0.005);
}

/// Copley Xenus XTL, A.1, and Kollmorgen SERVOSTAR, app. D: E = ½ J ω² − 3/2 R_LL I² t_d − ½ T_F ω t_d with I = (J ω/t_d − T_F)/k_T, for
/// 0.1 kgm² from 100 rad/s to rest in 0.5 s, k_T 1 Nm/A, R_LL 0.2 Ω: 440 J without friction and 401.4 J with 2 Nm. The formula deducts what
/// the winding takes from the supply close to standstill, which is not regenerated: (3/2 R_LL I²)²/(2 k_T I ω) t_d more, 1.8 J and 1.312 J.
/// Yaskawa Sigma-7, 12.8.6, has the same with E_S = J n²/182 and E_L = π/60 n T_L t_D, and the resistor's mean power E_K/T.
#[test]
fn the_energy_of_a_stop_of_copley_kollmorgen_and_yaskawa() {
    for (friction, printed, more) in [(0.0, 440.0, 1.8), (2.0, 401.4, 1.312)] {
        // k_EM of k_TM = k_T/i: √3 k_EM = k_TM · 2π · 1000/60.
        let constant = 1.0 / 50.0 * 2.0 * std::f64::consts::PI * 1000.0 / 60.0 / 3.0_f64.sqrt();
        let text = format!(
            "format = 1\n[load]\ninertia = \"0.06 kg m^2\"\nfriction_torque = \"{friction} N m\"\n\
             [[motion]]\nlaw = \"manual\"\nspeed = \"100 rad/s\"\naccelerate = \"0.5 s\"\nrun = \"0.5 s\"\nbrake = \"0.5 s\"\n\
             pause = \"2.5 s\"\n[requirements]\nsupply = \"560 V\"\ndc_link_rise = \"60 V\"\n[actuator]\nname = \"own\"\nratio = 50\n\
             inertia_out = \"0.04 kg m^2\"\ncurrent_max = \"90 A\"\ntorque_constant_out = \"1 N m/A\"\n\
             voltage_constant_motor = \"{constant} V/1000 1/min\"\nresistance_ll = \"0.2 ohm\"\ninductance_ll = \"1 mH\"\n\
             torque_constant_motor = \"0.02 N m/A\"\npole_pairs = 5\nno_load_starting_current = \"0 A\"\nno_load_current_constant_30 = \"0 A/min^-1\"\n\
             no_load_current_constant_80 = \"0 A/min^-1\"\n"
        );
        let judgement = check_own(&read(&text).unwrap()).unwrap().judgement;
        let found = judgement.checks.iter().find(|check| check.id == sizing::CheckId::Regeneration).unwrap();
        let energy = found.notes.iter().find_map(|note| match note {
            sizing::Note::EnergyPerCycle { regenerated, .. } => Some(regenerated.si()),
            _ => None,
        });
        near(energy.unwrap(), printed + more, 0.001);
        // The mean over the cycle of 4 s, for which a braking resistor is chosen.
        near(found.value.unwrap().si, (printed + more) / 4.0, 0.001);
        // A bank of capacitors takes it with E = ½ C (U_M² − U²).
        let bank = found.notes.iter().find_map(|note| match note {
            sizing::Note::Capacitor { capacitance_f, .. } => Some(*capacitance_f),
            _ => None,
        });
        near(bank.unwrap(), 2.0 * (printed + more) / (620.0_f64.powi(2) - 560.0_f64.powi(2)), 1e-7);
        // By the rounded constants of Yaskawa, 182 for 2 · 60² /(4π²) = 182.4.
        let (speed, current) = (100.0 * 60.0 / std::f64::consts::TAU, 20.0 - friction);
        let stored = 0.1 * speed * speed / 182.0;
        let (lost, heat) = (std::f64::consts::PI / 60.0 * speed * friction * 0.5, 1.5 * 0.2 * current * current * 0.5);
        near(energy.unwrap() / (stored - lost - heat + more), 1.0, 0.003);
    }
}
