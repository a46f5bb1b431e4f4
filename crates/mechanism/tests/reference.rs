//! Hoist, winder, scissor lift and four-bar against `validation/mechanisms/mechanisms.py` (mpmath 1.3.0, 50 digits), which
//! differentiates energies and momenta of the moving parts numerically; balances of power; faults.

use mechanism::{
    Extra, FourBar, Geometry, Hoist, LinearKind, Mechanism, MechanismKind, Mounting, Output, ScissorLift, Winder,
    Winding, reeving_efficiency,
};
use quantities::unit::DEGREE;
use quantities::{Angle, Force, Length, Mass, MassDensity, Measure, MomentOfInertia, Torque};
use std::f64::consts::TAU;

fn m(metres: f64) -> Length {
    Length::from_si(metres)
}

fn kg(mass: f64) -> Mass {
    Mass::from_si(mass)
}

fn kgm2(inertia: f64) -> MomentOfInertia {
    MomentOfInertia::from_si(inertia)
}

fn deg(angle: f64) -> Angle {
    Angle::new_in(angle, &DEGREE)
}

fn out(q: f64, w: f64, a: f64) -> Output {
    let direction = if w == 0.0 { 0.0 } else { w.signum() };
    Output { position_rad: q, speed_rad_s: w, acceleration_rad_s2: a, direction }
}

const STATES: [[f64; 3]; 3] = [[0.4, 3.0, -7.0], [2.1, -5.0, 11.0], [4.9, 2.5, 4.0]];

fn mechanism(kind: MechanismKind) -> Mechanism {
    Mechanism { kind, ..Mechanism::direct(kgm2(0.0), Torque::from_si(0.0)) }
}

fn torques(kind: MechanismKind) -> [f64; 3] {
    let mechanism = mechanism(kind);
    STATES.map(|[q, w, a]| mechanism.torque(&out(q, w, a), &Extra::none()))
}

fn agree(found: [f64; 3], reference: [f64; 3], relative: f64) {
    for (found, reference) in found.into_iter().zip(reference) {
        assert!((found - reference).abs() <= relative * reference.abs(), "{found} {reference}");
    }
}

fn hoist(falls: u32) -> Hoist {
    Hoist {
        drum_diameter: m(0.3),
        falls,
        inertia: kgm2(0.8),
        mass: kg(400.0),
        counterweight: kg(150.0),
        rope_mass: kg(5.4),
        hanging: m(6.0),
        reeving: 1.0,
    }
}

#[test]
fn a_hoist_with_a_heavy_rope() {
    let references = [
        [282.537827635, 521.53723370875, 427.90569665375],
        [160.14631322125, 231.268657552187, 203.438371335312],
        [109.651614515, 149.67544407875, 134.03443718375],
        [82.586032594375, 111.723022231797, 100.349159320156],
    ];
    for (falls, reference) in (1..).zip(references) {
        agree(torques(MechanismKind::Hoist(hoist(falls))), reference, 1e-13);
    }
}

/// 400 kg on 4 falls of a drum of 300 mm: 400·9.80665·0.15/4 = 147.1 Nm; η = (1 + 0.98 + 0.98² + 0.98³)/4 = 0.97039.
#[test]
fn a_hoist_by_hand() {
    let plain = Hoist { counterweight: kg(0.0), rope_mass: kg(0.0), ..hoist(4) };
    let hoist = mechanism(MechanismKind::Hoist(plain));
    assert!((hoist.holding_torque(0.0, &Extra::none()).si() - 147.099_75).abs() < 1e-9);
    assert!((hoist.travel_m_per_rad().unwrap() - 0.0375).abs() < 1e-15);
    assert!(!hoist.depends_on_position() && hoist.range_rad().is_none());
    assert!((reeving_efficiency(4, 0.98) - 0.970_398).abs() < 1e-6);
    assert_eq!(reeving_efficiency(3, 1.0), 1.0);
    // Each rope pulls the drum with a fourth of the weight, the load's and the counterweight's, at 50 mm.
    let mounting = Mounting { overhang: Some(m(0.05)), ..Mounting::default() };
    let balanced = mechanism(MechanismKind::Hoist(Hoist { counterweight: kg(400.0), ..plain }));
    let forces = balanced.flange_forces(&out(0.0, 0.0, 0.0), &Extra::none(), 0.0, &mounting);
    assert!((forces.radial() - 200.0 * 9.806_65).abs() < 1e-9 && forces.axial() == 0.0);
    assert!((forces.moment(m(0.0)) - 10.0 * 9.806_65).abs() < 1e-9);
}

/// Returns the pulls on the drum of a load on `falls`, lifted and lowered: from fall to fall the pull is that of the one
/// before times the efficiency of the sheave between them, and all together bear the load.
fn pulls(load: f64, falls: u32, sheave: f64) -> [f64; 2] {
    [sheave, 1.0 / sheave].map(|step| load / (0..falls).map(|fall| step.powf(f64::from(fall))).sum::<f64>())
}

/// Lifted, the rope of the load pulls more and that of the counterweight less, lowered the other way round: 1000 kg
/// against 950 kg on four falls of a drum of 200 mm, sheaves of 0.95.
///
/// η_F = (1 + 0.95 + 0.9025 + 0.857375)/4 = 0.92746875; F_1 = 2451.66 N, F_2 = 2329.08 N;
/// up 0.1 (2643.39 − 2160.15) = 48.32 Nm, down 0.1 (2273.84 − 2511.22) = −23.74 Nm: both have to be driven
#[test]
fn a_counterweight_has_its_own_direction_of_losses() {
    let with = |falls: u32, sheave: f64, mass: f64, counterweight: f64, drum: f64| {
        mechanism(MechanismKind::Hoist(Hoist {
            drum_diameter: m(0.2),
            inertia: kgm2(drum),
            mass: kg(mass),
            counterweight: kg(counterweight),
            rope_mass: kg(0.0),
            reeving: reeving_efficiency(falls, sheave),
            ..hoist(falls)
        }))
    };
    let torque = |hoist: &Mechanism, direction: f64, a: f64| {
        let state = Output { position_rad: 0.0, speed_rad_s: direction, acceleration_rad_s2: a, direction };
        hoist.torque(&state, &Extra::none())
    };
    let balanced = with(4, 0.95, 1000.0, 950.0, 0.0);
    assert!((torque(&balanced, 1.0, 0.0) - 48.32).abs() < 0.005, "{}", torque(&balanced, 1.0, 0.0));
    assert!((torque(&balanced, -1.0, 0.0) + 23.74).abs() < 0.005, "{}", torque(&balanced, -1.0, 0.0));
    assert!((torque(&balanced, 0.0, 0.0) - 0.1 * 50.0 / 4.0 * 9.806_65).abs() < 1e-9);
    let mounting = Mounting { overhang: Some(m(0.05)), ..Mounting::default() };
    let mut driven = 0;
    for falls in [1, 2, 3, 4, 6, 8] {
        for sheave in [1.0, 0.98, 0.95, 0.9] {
            for counterweight in [0.0, 10.0, 300.0, 600.0, 950.0, 1000.0, 1020.0, 1600.0] {
                for a in [-20.0, -3.0, 0.0, 3.0, 20.0] {
                    let (drum, radius, n) = (0.8, 0.1, f64::from(falls));
                    let hoist = with(falls, sheave, 1000.0, counterweight, drum);
                    let along = radius / n * a;
                    let (load, balance) = (1000.0 * (9.806_65 + along), counterweight * (9.806_65 - along));
                    let eta = reeving_efficiency(falls, sheave);
                    for direction in [1.0, -1.0] {
                        let found = torque(&hoist, direction, a);
                        let sides = if direction > 0.0 { [1.0 / eta, eta] } else { [eta, 1.0 / eta] };
                        let ropes = radius / n * (load * sides[0] - balance * sides[1]);
                        // While the ropes drive, the loss of the lowered one is no help.
                        let ropes = if ropes * direction < 0.0 { ropes / eta } else { ropes };
                        assert!((found - drum * a - ropes).abs() < 1e-9 * load, "{falls} {sheave} {counterweight} {a}");
                        let ideal = radius / n * (load - balance);
                        // Losses never relieve the motor beyond the ropes without them, and never drive.
                        assert!((ropes - ideal) * direction > -1e-9 * load);
                        driven += u32::from(ropes * direction < 0.0);
                        // Fall by fall; lowered, η_F is a little more than the exact quotient.
                        let [[up, down], [up_c, down_c]] = [load, balance].map(|of| pulls(of, falls, sheave));
                        let exact = radius * if direction > 0.0 { up - down_c } else { down - up_c };
                        let near = 0.1 * (1.0 - eta) * radius / n * (load + balance) + 1e-9 * load;
                        if exact * direction > 0.0 && ropes * direction > 0.0 {
                            assert!(
                                (ropes - exact).abs() < near,
                                "{falls} {sheave} {counterweight} {a}: {ropes} {exact}"
                            );
                        }
                        // The ropes that turn the drum load the flange.
                        let state =
                            Output { position_rad: 0.0, speed_rad_s: direction, acceleration_rad_s2: a, direction };
                        let radial = hoist.flange_forces(&state, &Extra::none(), 0.0, &mounting).radial();
                        let help = if (load * sides[0] - balance * sides[1]) * direction < 0.0 { eta } else { 1.0 };
                        let sum = (load * sides[0] + balance * sides[1]) / n / help;
                        assert!(
                            (radial - sum).abs() < 1e-9 * load,
                            "{falls} {sheave} {counterweight} {a}: {radial} {sum}"
                        );
                    }
                }
            }
        }
    }
    assert!(driven > 200, "{driven}");
    // Equal masses: the same torque up and down, all of it losses.
    let equal = with(4, 0.95, 1000.0, 1000.0, 0.0);
    let expected = 0.1 * 2_451.662_5 * (1.0 / 0.927_468_75 - 0.927_468_75);
    assert!((torque(&equal, 1.0, 0.0) - expected).abs() < 1e-9);
    assert!((torque(&equal, -1.0, 0.0) + expected).abs() < 1e-9);
}

fn winder(winding: Winding) -> Winder {
    Winder {
        winding,
        core_diameter: m(0.1),
        full_diameter: m(0.6),
        start_diameter: m(0.32),
        thickness: m(0.004),
        width: m(0.6),
        density: MassDensity::from_si(900.0),
        tension: Force::from_si(120.0),
        inertia: kgm2(0.02),
    }
}

#[test]
fn a_winder_up_and_off() {
    agree(
        torques(MechanismKind::Winder(winder(Winding::Up))),
        [15.2115638361212, 25.8439184549134, 22.0352565381092],
        1e-13,
    );
    agree(
        torques(MechanismKind::Winder(winder(Winding::Off))),
        [-23.1388908223793, -12.9648581144959, -16.71169180327],
        1e-13,
    );
}

/// (600 − 320)/(2·4) = 35 turns to the full roll, (320 − 100)/8 = 27.5 back to the core.
#[test]
fn a_winder_ends_at_its_core_and_at_the_full_roll() {
    let range = |winding| mechanism(MechanismKind::Winder(winder(winding))).range_rad().unwrap();
    let near = |(a, b): (f64, f64), (c, d): (f64, f64)| (a - c * TAU).abs() < 1e-9 && (b - d * TAU).abs() < 1e-9;
    assert!(near(range(Winding::Up), (-27.5, 35.0)), "{:?}", range(Winding::Up));
    assert!(near(range(Winding::Off), (-35.0, 27.5)), "{:?}", range(Winding::Off));
    let wrong = Winder { full_diameter: m(0.09), start_diameter: m(0.05), ..winder(Winding::Up) };
    assert_eq!(wrong.faults(), [Geometry::FullBelowCore, Geometry::StartBelowCore]);
    let wrong = Winder { start_diameter: m(0.7), ..winder(Winding::Up) };
    assert_eq!(wrong.faults(), [Geometry::StartAboveFull]);
    assert!(winder(Winding::Up).faults().is_empty());
}

fn scissor(stages: u32) -> ScissorLift {
    ScissorLift {
        stages,
        arm_length: m(1.2),
        lead: m(0.9),
        angle: deg(25.0),
        mass: kg(180.0),
        arm_mass: kg(90.0),
        inertia: kgm2(0.003),
    }
}

#[test]
fn a_scissor_lift_of_one_and_of_three_stages() {
    agree(
        torques(MechanismKind::ScissorLift(scissor(1))),
        [382.839395146795, 291.039764004396, 110.452038186868],
        1e-12,
    );
    agree(
        torques(MechanismKind::ScissorLift(scissor(3))),
        [304.664883528718, 918.313692234796, 330.611790355102],
        1e-12,
    );
}

/// The thrust of the screw is n (m + m_a/2) g cot θ at rest; the range ends upright and at 1°.
#[test]
fn a_scissor_lift_by_hand() {
    let lift = mechanism(MechanismKind::ScissorLift(scissor(2)));
    let mounting = Mounting { share: Some(1.0), ..Mounting::default() };
    let forces = lift.flange_forces(&out(0.0, 0.0, 0.0), &Extra::none(), 0.0, &mounting);
    let thrust = 2.0 * 225.0 * 9.806_65 / deg(25.0).si().tan();
    assert!((forces.axial() - thrust).abs() < 1e-9 * thrust && forces.radial() == 0.0);
    assert_eq!(lift.missing_for_forces(&Mounting::default()), Some("bearing.flange_share"));
    let (low, high) = lift.range_rad().unwrap();
    let base = 1.2 * deg(25.0).si().cos();
    assert!((high - base / (0.9 / TAU)).abs() < 1e-9, "{high}");
    assert!((low - (base - 1.2 * deg(1.0).si().cos()) / (0.9 / TAU)).abs() < 1e-9, "{low}");
    assert_eq!(ScissorLift { angle: deg(0.5), ..scissor(1) }.faults(), [Geometry::Flat]);
    assert_eq!(ScissorLift { angle: deg(90.0), ..scissor(1) }.faults(), [Geometry::Upright]);
    assert!(lift.torque(&out(-1e6, 1.0, 1.0), &Extra::none()).is_finite());
}

fn four_bar(is_crossed: bool) -> FourBar {
    FourBar {
        ground: m(0.4),
        crank: m(0.1),
        coupler: m(0.35),
        rocker: m(0.25),
        is_crossed,
        inertia: kgm2(0.02),
        coupler_mass: kg(2.5),
        coupler_centre: m(0.15),
        coupler_inertia: kgm2(0.03),
        rocker_mass: kg(3.0),
        rocker_centre: m(0.12),
        rocker_inertia: kgm2(0.08),
        rocker_torque: Torque::from_si(6.0),
        inclination: deg(20.0),
        tilt: deg(70.0),
    }
}

#[test]
fn a_four_bar_open_and_crossed() {
    let open = [0.290803983552358, 0.191928712305127, 0.69338037315837];
    agree(torques(MechanismKind::FourBar(four_bar(false))), open, 1e-12);
    let crossed = [-2.01085369194332, -1.12019777611513, 2.97581330851796];
    agree(torques(MechanismKind::FourBar(four_bar(true))), crossed, 1e-12);
}

/// The force at the crank pin, from the equations of coupler and rocker, makes the torque of Lagrange's equation.
#[test]
fn the_force_at_the_crank_pin_makes_the_torque() {
    for is_crossed in [false, true] {
        let linkage = FourBar { inertia: kgm2(0.0), ..four_bar(is_crossed) };
        let mechanism = mechanism(MechanismKind::FourBar(linkage));
        for step in 0..48 {
            let q = f64::from(step) * TAU / 48.0;
            let output = out(q, 4.0, -9.0);
            let forces = mechanism.flange_forces(&output, &Extra::none(), 0.0, &Mounting::default());
            let [x, y] = forces.radial_n;
            // The flange bears the force; the torque is that of its reaction.
            let torque = -0.1 * (q.cos() * y - q.sin() * x);
            let asked = mechanism.torque(&output, &Extra::none());
            assert!((torque - asked).abs() < 1e-11 * (1.0 + asked.abs()), "{q}: {torque} {asked}");
        }
    }
}

#[test]
fn lengths_that_make_no_linkage() {
    let of = |[ground, crank, coupler, rocker]: [f64; 4]| {
        let [ground, crank, coupler, rocker] = [ground, crank, coupler, rocker].map(m);
        FourBar { ground, crank, coupler, rocker, ..four_bar(false) }.faults()
    };
    assert!(of([0.4, 0.1, 0.35, 0.25]).is_empty());
    assert_eq!(of([0.9, 0.1, 0.35, 0.25]), [Geometry::NotAssembled]);
    assert_eq!(of([0.4, 0.25, 0.35, 0.25]), [Geometry::TooShort]);
    assert_eq!(of([0.4, 0.3, 0.5, 0.25]), [Geometry::TooUnequal]);
    assert_eq!(of([0.4, 0.3, 0.5, 0.19]), [Geometry::TooShort, Geometry::TooUnequal]);
    // A parallelogram passes through a straight line, where its branches meet.
    assert_eq!(of([0.4, 0.1, 0.4, 0.1]), [Geometry::TooShort, Geometry::TooUnequal]);
    // A drag link: the fixed link is the shortest, all others go round.
    assert!(of([0.1, 0.3, 0.35, 0.4]).is_empty());
}

/// The power at the output is d/dt (½ J ω² + V): the torque along a path against differences of the energy, in which the
/// weight enters as the integral of the holding torque. A roll takes its web in with its energy, so it is left out.
#[test]
fn the_power_is_the_change_of_the_energy() {
    let kinds = [
        MechanismKind::Hoist(hoist(3)),
        MechanismKind::ScissorLift(scissor(2)),
        MechanismKind::FourBar(four_bar(false)),
        MechanismKind::FourBar(four_bar(true)),
    ];
    for kind in kinds {
        let mechanism = mechanism(kind);
        let none = Extra::none();
        let path = |t: f64| out(1.0 + 0.8 * t.sin(), 0.8 * t.cos(), -0.8 * t.sin());
        let mut t = 0.05;
        while t < TAU {
            let kinetic = |t: f64| {
                let at = path(t);
                0.5 * mechanism.inertia(at.position_rad, &none).si() * at.speed_rad_s * at.speed_rad_s
            };
            let h = 1e-4;
            let change = (kinetic(t - 2.0 * h) - 8.0 * kinetic(t - h) + 8.0 * kinetic(t + h) - kinetic(t + 2.0 * h))
                / (12.0 * h);
            let at = path(t);
            let weight = mechanism.holding_torque(at.position_rad, &none).si() * at.speed_rad_s;
            let power = mechanism.torque(&at, &none) * at.speed_rad_s;
            assert!((power - change - weight).abs() < 1e-8 * (1.0 + power.abs()), "{t}: {power} {}", change + weight);
            t += 0.1;
        }
    }
}

/// Over a closed path the weight does no work: the holding torque is the slope of a height.
#[test]
fn the_weight_does_no_work_over_a_revolution() {
    let mechanism =
        mechanism(MechanismKind::FourBar(FourBar { rocker_torque: Torque::from_si(0.0), ..four_bar(false) }));
    let steps = 720;
    let work: f64 =
        (0..steps).map(|k| mechanism.holding_torque(f64::from(k) * TAU / f64::from(steps), &Extra::none()).si()).sum();
    assert!(work.abs() < 1e-10, "{work}");
}

/// A hoist with one fall and a weightless rope is an upright belt.
#[test]
fn the_limits_are_those_of_simpler_mechanisms() {
    let plain = Hoist { counterweight: kg(0.0), rope_mass: kg(0.0), falls: 1, ..hoist(1) };
    let belt = mechanism::Linear {
        kind: LinearKind::Belt,
        travel_m_per_rad: 0.15,
        inertia: kgm2(0.8),
        mass: kg(400.0),
        counterweight: kg(0.0),
        inclination: deg(90.0),
        friction_force: Force::from_si(0.0),
        friction_coefficient: 0.0,
    };
    agree(torques(MechanismKind::Hoist(plain)), torques(MechanismKind::Linear(belt)), 1e-14);
}
