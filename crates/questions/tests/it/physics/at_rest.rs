//! Loads of the turning and of the resting gear: footnotes 2 to 4 of table 55.1.

use crate::physics::{of, read};
use questions::{CheckId, Verdict};

const CODE: &str = "CHA-14A-100-H-RES";

/// A press that is loaded while it waits: a swing, a dwell with its loads, a swing back.
fn press(dwell: &str, swing: &str) -> String {
    format!(
        "format = 1\n[load]\ninertia = \"0.2 kg m^2\"\nfriction_torque = \"1 N m\"\n\
         [[motion]]\nlaw = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n{swing}\
         [[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n[motion.bearing]\n{dwell}\n\
         [[motion]]\nlaw = \"trapezoid\"\ndistance = \"-90 deg\"\ntime = \"1 s\"\n\
         [bearing]\nradial_force = \"50 N\"\nradial_distance = \"50 mm\"\naxial_force = \"10 N\"\naxial_distance = \"0 mm\"\n\
         load_factor = 1.2\noperating_condition = \"normal\"\n"
    )
}

fn radial(force: f64, distance_mm: f64) -> String {
    format!("radial_force = \"{force} N\"\nradial_distance = \"{distance_mm} mm\"")
}

/// 1200 N at 80 mm in the dwell only, by hand for 14A (R 14 mm, d_p 46.5 mm, C_0 11400 N): M = 112.8 Nm is above M_dyn(max) 73 Nm,
/// which holds for the turning gear; M_eq = 112.8 + 23.25 mm · 1200 N = 140.7 Nm, M_0(max) 147 Nm; f_s = 11400/6051.6 = 1.884.
#[test]
fn a_moment_in_a_dwell_is_judged_by_the_static_limit() {
    let project = read(&press(&radial(1200.0, 80.0), ""));
    let value = |id| of(&project, CODE, id).value.unwrap().si;
    let moving = 50.0 * (0.05 + 0.014);
    assert!((value(CheckId::BearingTiltingMoment) - moving).abs() < 1e-9);
    assert!((value(CheckId::BearingRadial) - 50.0).abs() < 1e-9);
    let resting = of(&project, CODE, CheckId::BearingStaticMoment);
    assert!((resting.value.unwrap().si - (112.8 + 0.02325 * 1200.0)).abs() < 1e-9, "{resting:?}");
    assert!((resting.limit.unwrap().si - 147.0).abs() < 1e-9 && resting.verdict == Verdict::Pass);
    let safety = of(&project, CODE, CheckId::BearingStatic);
    let equivalent = 1200.0 + 2.0 * 112.8 / 0.0465 + 0.44 * 10.0;
    assert!((safety.value.unwrap().si - 11_400.0 / equivalent).abs() < 1e-9, "{safety:?}");
    assert!((safety.limit.unwrap().si - 1.8).abs() < 1e-12 && safety.verdict == Verdict::Pass);
    // The tilt under load is that of the largest moment, at rest too.
    let tilt = of(&project, CODE, CheckId::TiltAngle).value.unwrap().si;
    assert!((tilt - (112.8 / 23.0 / 60.0_f64).to_radians()).abs() < 1e-9, "{tilt}");
    let heavy = of(&read(&press(&radial(1300.0, 80.0), "")), CODE, CheckId::BearingStaticMoment);
    assert!(heavy.verdict == Verdict::Fail, "{heavy:?}");
}

/// The load is the same, but while the gear turns it is judged by M_dyn(max).
#[test]
fn a_moment_in_motion_is_judged_by_the_dynamic_limit() {
    let swing = format!("[motion.bearing]\n{}\n", radial(1200.0, 80.0));
    let project = read(&press(&radial(1200.0, 80.0), &swing));
    let tilting = of(&project, CODE, CheckId::BearingTiltingMoment);
    assert!((tilting.value.unwrap().si - 112.8).abs() < 1e-9 && tilting.verdict == Verdict::Fail, "{tilting:?}");
}

/// f_s of footnote 3: 1.8 for sizes 14 to 20, 1.5 for 25 to 58; a stricter operating condition stands.
#[test]
fn the_least_static_safety_is_that_of_the_size_or_of_the_condition() {
    let least = |code: &str, condition: &str| {
        let text = press(&radial(10.0, 10.0), "").replace("\"normal\"", &format!("\"{condition}\""));
        of(&read(&text), code, CheckId::BearingStatic).limit.unwrap().si
    };
    for (code, of_size) in [
        ("CHA-14A-100-H-RES", 1.8),
        ("CHA-17A-100-H-RES", 1.8),
        ("CHA-20A-100-H-C1024", 1.8),
        ("CHA-25A-100-H-C1024", 1.5),
        ("CHA-32A-100-H-C1024", 1.5),
        ("CHA-58A-100-H-C1024", 1.5),
    ] {
        for (condition, by_condition) in [("normal", 1.5_f64), ("shock", 2.0), ("high_accuracy", 3.0)] {
            assert!((least(code, condition) - by_condition.max(of_size)).abs() < 1e-12, "{code} {condition}");
        }
    }
}

/// The check is made of a cycle that rests, and of no other.
#[test]
fn a_cycle_without_rest_has_no_static_moment() {
    let text = "format = 1\n[load]\ninertia = \"0.2 kg m^2\"\n[[motion]]\nlaw = \"triangle\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n\
                [[motion]]\nlaw = \"triangle\"\ndistance = \"-90 deg\"\ntime = \"1 s\"\n[bearing]\nradial_force = \"50 N\"\nradial_distance = \"50 mm\"\n";
    let found = crate::physics::checks(&read(text), CODE);
    assert!(found.iter().all(|check| check.id != CheckId::BearingStaticMoment));
}

/// A load on a mechanism's own side: a level arm holds its weight in the dwell, F_r = m g and M = m g (L + R).
#[test]
fn a_resting_mechanism_bears_its_weight() {
    let text = "format = 1\n[mechanism.arm]\ninertia = \"0.4 kg m^2\"\nmass = \"5 kg\"\ncentre_distance = \"180 mm\"\naxis_tilt = \"90 deg\"\n\
                start_angle = \"0 deg\"\n[[motion]]\nlaw = \"modified_sine\"\ndistance = \"90 deg\"\ntime = \"2 s\"\n\
                [[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n[[motion]]\nlaw = \"modified_sine\"\ndistance = \"-90 deg\"\ntime = \"2 s\"\n\
                [bearing]\noverhang = \"45 mm\"\n";
    let weight = 5.0 * 9.806_65;
    let found = of(&read(text), CODE, CheckId::BearingStaticMoment).value.unwrap().si;
    assert!((found - (weight * (0.045 + 0.014) + 0.02325 * weight)).abs() < 1e-9, "{found}");
}

/// A press with two dwells, each with its own radial force F_r at 80 mm and axial force F_a at 30 mm.
fn two_dwells([first, second]: [[f64; 2]; 2]) -> String {
    let dwell = |[radial, axial]: [f64; 2]| {
        format!(
            "[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n[motion.bearing]\nradial_force = \"{radial} N\"\nradial_distance = \"80 mm\"\n\
             axial_force = \"{axial} N\"\naxial_distance = \"30 mm\"\n"
        )
    };
    format!(
        "format = 1\n[load]\ninertia = \"0.2 kg m^2\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n{}\
         [[motion]]\nlaw = \"trapezoid\"\ndistance = \"-90 deg\"\ntime = \"1 s\"\n{}\
         [bearing]\nradial_force = \"5 N\"\nradial_distance = \"5 mm\"\nload_factor = 1.2\noperating_condition = \"normal\"\n",
        dwell(first),
        dwell(second)
    )
}

/// Largest loads of different rests are combined, and the worst single rest is stated: both by eq. 76.1, written apart, over a
/// grid of loads. Only what a single rest violates is rejected; what the combination alone violates is advice whose band
/// runs from one to the other. The order of the rests changes nothing.
#[test]
fn loads_of_different_rests_are_combined_and_each_is_judged_alone() {
    // 14A: R 14 mm, d_p 46.5 mm, C_0 11400 N, M_0(max) 147 Nm, f_s 1.8.
    let moment = |[radial, axial]: [f64; 2]| radial * (0.08 + 0.014) + axial * 0.03;
    let equivalent = |radial: f64, axial: f64, moment: f64| moment + 0.02325 * (radial + 0.44 * axial);
    let mut seen = [0; 3];
    for step in 0..144_u32 {
        let [a, b, c, d] = [step % 4, step / 4 % 3, step / 12 % 4, step / 48].map(f64::from);
        let loads = [[820.0 + 130.0 * a, 90.0 * b], [190.0 * c, 60.0 + 1100.0 * d]];
        let project = read(&two_dwells(loads));
        let largest = |of: fn(&[f64; 2]) -> f64| loads.iter().map(of).fold(0.0, f64::max);
        let (radial, axial) = (largest(|load| load[0]), largest(|load| load[1]));
        let moments = loads.map(moment);
        let combined = equivalent(radial, axial, moments[0].max(moments[1]));
        let alone = loads.map(|load| equivalent(load[0], load[1], moment(load)));
        let alone = alone[0].max(alone[1]);
        for (id, value, by_one, limit, keeps) in [
            (CheckId::BearingStaticMoment, combined, alone, 147.0, alone <= 147.0),
            (CheckId::BearingStatic, 11_400.0 * 0.02325 / combined, 11_400.0 * 0.02325 / alone, 1.8, {
                11_400.0 * 0.02325 / alone >= 1.8
            }),
        ] {
            let found = of(&project, CODE, id);
            assert!((found.value.unwrap().si / value - 1.0).abs() < 1e-9, "{loads:?} {found:?}");
            let share = if id == CheckId::BearingStatic { limit / value } else { value / limit };
            let expected = match (share <= 1.0, keeps) {
                (true, _) => Verdict::Pass,
                (false, true) => Verdict::Advice,
                (false, false) => Verdict::Fail,
            };
            assert_eq!(found.verdict, expected, "{loads:?} {found:?}");
            seen[[Verdict::Pass, Verdict::Advice, Verdict::Fail].iter().position(|of| *of == expected).unwrap()] += 1;
            assert_eq!(found.is_inside_band(), expected == Verdict::Advice);
            match found.utilisation_band() {
                Some([low, high]) => {
                    let by_one = if id == CheckId::BearingStatic { limit / by_one } else { by_one / limit };
                    assert!(
                        (low / by_one - 1.0).abs() < 1e-9 && (high / share - 1.0).abs() < 1e-9,
                        "{loads:?} {found:?}"
                    );
                }
                None => assert!((combined / alone - 1.0).abs() < 1e-8, "{loads:?} {found:?}"),
            }
            if step % 6 > 0 {
                continue;
            }
            let swapped = of(&read(&two_dwells([loads[1], loads[0]])), CODE, id);
            assert_eq!((swapped.verdict, swapped.value.map(|of| of.si)), (found.verdict, found.value.map(|of| of.si)));
        }
    }
    assert!(seen.iter().all(|count| *count >= 10), "{seen:?}");
}
