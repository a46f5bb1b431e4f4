//! Runs whose position counts from another zero than the mechanism, or which do not follow the cycle.

use super::*;

/// A run at another pace than the cycle is no doubt, but named: a scale of the time shows nowhere else.
#[test]
fn a_run_at_another_pace_is_named() {
    let [wheel, ..] = loads();
    let motion = moves(&EXCITING);
    let run = measured(&recorded(&wheel, &motion, &none(), 1), 1);
    assert_eq!(said(&run, &wheel, &motion, &none()).other_motion, None);
    let mut slow = run;
    slow.speed_rad_s = None;
    slow.time_s.iter_mut().for_each(|time| *time *= 1.1);
    slow.motor_rad_s.iter_mut().for_each(|speed| *speed /= 1.1);
    let found = said(&slow, &wheel, &motion, &none());
    assert!(found.other_motion.is_some_and(|correlation| correlation < 0.99), "{:?}", found.other_motion);
}

/// A position that counts from another zero than the mechanism leaves the loads as they are planted: own weight and payloads
/// act at one offset, which is named. Without an offset none counts.
#[test]
fn payloads_act_at_the_offset_of_the_position() {
    let [_, arm, _] = loads();
    let MechanismKind::Rotor(rotor) = arm.kind else { panic!("an arm") };
    let kind = MechanismKind::Rotor(Rotor { payload_radius: Length::from_si(0.5), ..rotor });
    let arm = Mechanism { kind, ..arm };
    let motion = moves(&EXCITING);
    let laden = |kg: f64| Extra { mass: Mass::from_si(kg), ..Extra::none() };
    let extras = [laden(2.0), laden(2.0), laden(0.0), laden(0.0), laden(1.0)].repeat(2);
    let plain = arm.plain(&extras[0]).unwrap();
    let flange = 0.02 * parameters(CODE).actuator.inertia_out.known().unwrap().value.si();
    let planted = [
        (Identified::LoadInertia, plain.inertia_kgm2 + flange),
        (Identified::Coulomb, plain.coulomb_nm),
        (Identified::Viscous, plain.viscous_nms),
        (Identified::Gravity, plain.weight_nm),
    ];
    let (mut inside, mut all) = ([0; 5], 0);
    for (seed, degrees) in (0..).zip([0.0, 34.0, -18.6, -40.0, -69.0, 90.0, 120.0, -120.0, 3.0, -8.0]) {
        let zero = f64::to_radians(degrees);
        let mut run = measured(&recorded(&arm, &motion, &extras, seed), seed);
        run.position_rad.iter_mut().for_each(|position| *position -= zero);
        let found_run = said(&run, &arm, &motion, &extras);
        assert_eq!(found_run.doubts.iter().map(|doubt| doubt.misread).collect::<Vec<_>>(), [], "{degrees}°");
        let [offset, half] = found_run.offset_rad.unwrap();
        let angle = found(&found_run.estimates, Identified::GravityAngle).unwrap();
        let turn = std::f64::consts::TAU;
        let off = angle.value - plain.angle_rad - zero;
        assert!((angle.value - plain.angle_rad - offset).abs() < 1e-9, "{degrees}°: {angle:?} {offset}");
        inside[4] += usize::from((off - turn * (off / turn).round()).abs() <= half);
        for ((of, value), inside) in planted.iter().zip(&mut inside) {
            let estimate = found(&found_run.estimates, *of).unwrap();
            assert!((estimate.value - value).abs() < 1.6 * estimate.half_width, "{degrees}°: {estimate:?} of {value}");
            *inside += usize::from((estimate.value - value).abs() <= estimate.half_width);
        }
        all += 1;
    }
    assert!(inside.iter().all(|inside| inside + 2 >= all), "{inside:?} of {all}");
}
