use super::*;
use crate::{check_own, size};

/// Only T_max limits: (J_L + J_out) n_2/t_1 + T_L = (1.3 + 1) · 10/0.1 + 5 = 235 Nm of 240 Nm.
fn own(inertia: &str, friction: &str, rest: &str) -> AxisProject {
    let text = format!(
        "format = 1\n[load]\ninertia = \"{inertia}\"\nfriction_torque = \"{friction}\"\n[[motion]]\nlaw = \"manual\"\n\
         speed = \"10 rad/s\"\naccelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\npause = \"1 s\"\n\
         [actuator]\nname = \"own\"\ninertia_out = \"1 kg m^2\"\ntorque_max = \"240 N m\"\n{rest}"
    );
    crate::read(&text).unwrap_or_else(|faults| panic!("{faults:#?}"))
}

fn assess_own(project: &AxisProject, sampling: Sampling, parts: usize) -> Assessment {
    let candidate = check_own(project).unwrap();
    let mut found = finished(assess_with(project, &[&candidate], sampling, (parts, &Unobserved)));
    assert_eq!(found.len(), 1);
    found.remove(0)
}

#[test]
fn a_single_inertia_passes_with_its_analytic_share() {
    // 240 Nm is reached at J_L = 1.35 kgm²; of 1.3 ± 0.1 that leaves 0.15/0.2 = 75 %.
    let project = own("1.3 kg m^2 ± 0.1 kg m^2", "5 N m", "");
    for seed in 1..=3 {
        let found = assess_own(&project, Sampling { samples: 10_000, seed }, 2);
        // The interval misses the truth once in twenty times; twice its width does not.
        let (low, high) = found.interval;
        let half = high - low;
        assert!((found.share() - 0.75).abs() < half, "seed {seed}: {found:?}");
        assert_eq!(found.passes as f64 / 10_000.0, found.share());
        assert!((found.worst.utilisation - 245.0 / 240.0).abs() < 1e-12, "{:?}", found.worst);
        assert_eq!(
            (found.worst.fit.fits(), found.worst.check, found.worst.place),
            (false, Some(CheckId::PeakTorque), PointKind::Corner)
        );
        assert!((found.worst.values[0] - 1.4).abs() < 1e-12);
        // T/T_max is uniform from 225/240 to 245/240.
        for (quantile, share) in
            [(found.utilisation.p05, 0.05), (found.utilisation.p50, 0.5), (found.utilisation.p95, 0.95)]
        {
            assert!((quantile - (225.0 + 20.0 * share) / 240.0).abs() < 0.002, "{found:?}");
        }
        assert!(found.utilisation.max < 245.0 / 240.0);
        assert_eq!(found.influence, [Influence { quantity: 0, share: 1.0 }]);
    }
    let covered = (1..=100).filter(|seed| {
        let (low, high) = assess_own(&project, Sampling { samples: 200, seed: *seed }, 1).interval;
        low <= 0.75 && 0.75 <= high
    });
    let covered = covered.count();
    assert!((88..=100).contains(&covered), "a 95 % interval that holds the truth {covered} times of 100");
}

/// T = (J_L + 1) · 100 + T_L: a half-width of 0.04 kgm² moves it by 4 Nm, one of 2 Nm by 2 Nm; the shares are as 4² to 2².
#[test]
fn influences_are_as_the_squares_of_the_weights() {
    let found = assess_own(&own("1.3 kg m^2 ± 0.04 kg m^2", "5 N m ± 2 N m", ""), Sampling::default(), 2);
    // By the order of the file's reader: friction_torque before inertia.
    let shares: Vec<(usize, f64)> = found.influence.iter().map(|each| (each.quantity, each.share)).collect();
    let [(1, inertia), (0, friction)] = shares[..] else { panic!("{shares:?}") };
    assert!((inertia / friction / 4.0 - 1.0).abs() < 0.12, "{shares:?}");
    assert!((inertia + friction - 1.0).abs() < 1e-12);
}

#[test]
fn the_bits_do_not_depend_on_the_parts_and_threads() {
    let project = own("1.3 kg m^2 ± 10 %", "5 N m ± 20 %", "");
    let candidate = check_own(&project).unwrap();
    let sizing = size(&project);
    let mut all: Vec<&Candidate<'_>> = sizing.candidates.iter().take(4).collect();
    all.push(&candidate);
    let sampling = Sampling { samples: 333, seed: 7 };
    let one = finished(assess_with(&project, &all, sampling, (1, &Unobserved)));
    for threads in [1, 2, 8] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        for parts in [2, 3, 500] {
            let found = pool.install(|| finished(assess_with(&project, &all, sampling, (parts, &Unobserved))));
            assert_eq!(found, one, "{threads} threads, {parts} parts");
        }
        let ranked =
            pool.install(|| size(&project).candidates.iter().map(|each| format!("{each:?}")).collect::<Vec<_>>());
        let here: Vec<String> = sizing.candidates.iter().map(|each| format!("{each:?}")).collect();
        assert_eq!(ranked, here, "{threads} threads");
    }
    let alone: Vec<Assessment> = all.iter().flat_map(|each| assess(&project, &[each], sampling)).collect();
    assert_eq!(alone, one, "an actuator's answer does not depend on the others");
    assert_ne!(finished(assess_with(&project, &all, Sampling { seed: 8, ..sampling }, (1, &Unobserved))), one);
}

/// The numbers of one seed, so that no platform and no other version of the generator draws others unnoticed.
#[test]
fn a_seed_draws_these_numbers() {
    let draws = Draws { seed: 1, quantities: 3 };
    let tolerances = own("1.3 kg m^2 ± 1 kg m^2", "5 N m ± 1 N m", "mass = \"5 kg ± 1 kg\"\n").tolerances;
    let values = draws.sample(0, &tolerances);
    let later = draws.sample(9_999, &tolerances);
    let column: Vec<u64> = draws.column(1, 10_000).collect();
    assert_eq!(column.len(), 10_000);
    let share = |drawn: u64| drawn as f64 / (1_u64 << 53) as f64;
    assert_eq!(tolerances[1].at(2.0 * share(column[0]) - 1.0), values[1]);
    assert_eq!(tolerances[1].at(2.0 * share(column[9_999]) - 1.0), later[1]);
    assert_eq!(column[..3], SEED_1);
}

/// Draws 1, 4 and 7 of PCG XSL RR 128/64 (O'Neill 2014) from this state and stream, by a program of its own in Python.
const SEED_1: [u64; 3] = [4869767755786490, 7309827273422702, 8431559210512940];

#[test]
fn no_width_is_no_tolerance() {
    let project = own("1.3 kg m^2 ± 0 %", "5 N m +- 0 N m", "");
    assert!(project.tolerances.is_empty());
    let candidate = check_own(&project).unwrap();
    assert!(assess(&project, &[&candidate], Sampling::default()).is_empty());
    let plain = check_own(&project).unwrap().standing;
    let exact = own("1.3 kg m^2", "5 N m", "");
    assert_eq!(check_own(&exact).unwrap().standing, plain);
}

#[test]
fn the_nominal_answer_does_not_see_the_tolerance() {
    let (with, without) = (own("1.3 kg m^2 ± 50 %", "5 N m ± 100 %", ""), own("1.3 kg m^2", "5 N m", ""));
    assert_eq!(check_own(&with).unwrap().standing, check_own(&without).unwrap().standing);
}

#[test]
fn data_of_the_own_actuator_and_requirements_vary_too() {
    let text = "mass = \"5 kg ± 1 kg\"\n[requirements]\nmass_max = \"5.5 kg\"\n";
    let project = own("1.3 kg m^2", "5 N m", text);
    let found = assess_own(&project, Sampling::default(), 2);
    assert!((found.share() - 0.75).abs() < 0.02, "{found:?}");
    assert!(!found.worst.fit.fits() && (found.worst.values[0] - 6.0).abs() < 1e-12, "{:?}", found.worst);
    assert!(found.influence.is_empty(), "no check depends on the mass");

    let project = own("1.3 kg m^2", "5 N m", "mass = \"5 kg\"\n[requirements]\nmass_max = \"5.5 kg ± 1 kg\"\n");
    let found = assess_own(&project, Sampling::default(), 2);
    assert!((found.share() - 0.75).abs() < 0.02, "{found:?}");

    let text = "[requirements]\nambient = \"40 degC ± 10 K\"\n";
    let project = own("0.05 kg m^2 ± 1 %", "1 N m", text);
    let sizing = size(&project);
    let best: Vec<&Candidate<'_>> = sizing.candidates.iter().take(1).collect();
    let found = assess(&project, &best, Sampling::default());
    assert!((found[0].share() - 0.5).abs() < 0.02, "the data hold up to 40 °C: {:?}", found[0]);
    assert_eq!(found[0].worst.check, Some(CheckId::Ambient));
}

/// An arm about a horizontal axis: level it needs most, and the band of its position holds the level inside.
#[test]
fn a_sample_that_is_worse_than_every_corner_is_reported() {
    let text = "format = 1\n[axis]\nsingle_move = true\n[mechanism.arm]\ninertia = \"0.1 kg m^2\"\nmass = \"10 kg\"\n\
                centre_distance = \"200 mm\"\naxis_tilt = \"90 deg\"\nstart_angle = \"0 deg ± 60 deg\"\n[[motion]]\n\
                law = \"dwell\"\ntime = \"1 s\"\n[actuator]\nname = \"own\"\ninertia_out = \"1 kg m^2\"\n\
                torque_max = \"15 N m\"\n";
    let project = crate::read(text).unwrap_or_else(|faults| panic!("{faults:#?}"));
    let found = assess_own(&project, Sampling { samples: 1000, seed: 1 }, 2);
    assert_eq!((found.worst.place, found.worst.fit.fits()), (PointKind::Sample, false), "{found:?}");
    assert!(found.worst.values[0].abs() < 0.02, "{:?}", found.worst);
    assert_eq!(found.worst.check, Some(CheckId::PeakTorque));
    assert!((found.worst.utilisation - found.utilisation.max).abs() < 1e-15);
}

#[test]
fn more_quantities_than_corners_can_be_counted_are_searched() {
    let moves = "[[motion]]\nlaw = \"manual\"\nspeed = \"10 rad/s ± 1 %\"\naccelerate = \"0.1 s ± 1 %\"\n\
                 run = \"0.1 s\"\nbrake = \"0.1 s ± 1 %\"\npause = \"1 s\"\n";
    let project =
        own("1.3 kg m^2 ± 1 %", "5 N m ± 10 %", &format!("{}[bearing]\n", moves.repeat(4)).replace("[bearing]\n", ""));
    assert_eq!(project.tolerances.len(), 14);
    let found = assess_own(&project, Sampling { samples: 200, seed: 1 }, 2);
    // (1.313 + 1) · 10.1/0.099 + 5.5
    assert_eq!(found.worst.place, PointKind::SearchedCorner);
    assert!((found.worst.utilisation * 240.0 - (2.313 * 10.1 / 0.099 + 5.5)).abs() < 1e-9, "{:?}", found.worst);
}

/// The samples examine the same checks as a full judgement.
#[test]
fn the_margins_alone_give_the_verdict_and_the_utilisation_of_every_check() {
    let asked = "[requirements]\nsupply = \"560 V\"\nambient = \"35 degC\"\nabsolute = true\nresolution_max = \"5 arcsec\"\n\
                 operation_per_day = \"8 h\"\nbattery_life_min = \"5 a\"\ntorsion_max = \"4 arcmin\"\n\
                 natural_frequency_min = \"20 Hz\"\ngear_life_min = \"20000 h\"\nangle_error_max = \"9 arcmin\"\n\
                 regeneration_power_max = \"50 W\"\nstop_angle_max = \"90 deg\"\ncollision_torque = \"80 N m\"\n";
    let bare = include_str!("../../../examples/manual-example.toml").to_owned();
    for text in [
        format!("{bare}{asked}"),
        format!("{bare}[requirements]\nregeneration_power_max = \"2 W\"\n"),
        bare,
        include_str!("../../../examples/tilting-arm.toml").to_owned(),
        include_str!("../../../examples/two-way-shuttle.toml").to_owned(),
    ] {
        let project = crate::read(&text).unwrap();
        for Product { id: code, parameters, .. } in crate::embedded_catalogue().products(false) {
            let [full, margins] =
                [Scope::All, Scope::Deciding].map(|depth| sizing::judge(&project.axis, parameters, depth));
            let said = |judgement: &Judgement| {
                let id = |check: Option<&sizing::Check>| check.map(|check| check.id);
                (judgement.fit(), judgement.utilisation(), id(judgement.governing()))
            };
            assert_eq!(said(&full), said(&margins), "{code}");
        }
    }
}
