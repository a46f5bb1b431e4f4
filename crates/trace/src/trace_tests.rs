use super::*;
use mechanism::{
    FourBar, Friction, Hoist, MechanismKind, Output, Rotor, RotorKind, ScissorLift, SliderCrank, Winder, Winding,
};
use motion::{Closing, Given, Hold, Law, ManualMove, Placed, Recorded, Samples, SegmentSpec, Treatment};
use quantities::{
    Angle, AngularAcceleration, AngularJerk, AngularVelocity, Force, Length, Mass, MassDensity, Measure,
    MomentOfInertia, Time, Torque, ViscousFriction,
};

pub(super) fn manual(speed: f64, [t1, t2, t3, tp]: [f64; 4]) -> SegmentSpec {
    let s = Time::from_si;
    SegmentSpec::Manual(ManualMove {
        speed: AngularVelocity::from_si(speed),
        accelerate: s(t1),
        run: s(t2),
        brake: s(t3),
        pause: s(tp),
    })
}

pub(super) fn law(law: Law, distance: f64, time: f64) -> SegmentSpec {
    let given = Given { distance: Some(Angle::from_si(distance)), time: Some(Time::from_si(time)), ..Given::default() };
    SegmentSpec::Move(law, given)
}

pub(super) fn jerk(distance: f64) -> SegmentSpec {
    SegmentSpec::Move(
        Law::Jerk,
        Given {
            distance: Some(Angle::from_si(distance)),
            speed: Some(AngularVelocity::from_si(3.0)),
            acceleration: Some(AngularAcceleration::from_si(20.0)),
            jerk: Some(AngularJerk::from_si(400.0)),
            ..Given::default()
        },
    )
}

pub(super) fn motion(segments: &[SegmentSpec]) -> Motion {
    Motion::new(segments, Some(Angle::from_si(0.0)), Closing::Speed).unwrap()
}

pub(super) fn direct() -> Mechanism {
    Mechanism::direct(MomentOfInertia::from_si(1.3), Torque::from_si(5.0))
}

pub(super) fn arm() -> Mechanism {
    let rotor = Rotor {
        kind: RotorKind::Arm,
        mass: Mass::from_si(6.0),
        radius: Length::from_si(0.35),
        tilt: Angle::from_si(std::f64::consts::FRAC_PI_2),
        ..Rotor::balanced(MomentOfInertia::from_si(0.8))
    };
    Mechanism { kind: MechanismKind::Rotor(rotor), efficiency_driving: 0.9, efficiency_driven: 0.8, ..direct() }
}

/// Returns the mechanism without losses: a sum of five parts.
pub(super) fn lossless() -> Mechanism {
    Mechanism { efficiency_driving: 1.0, efficiency_driven: 1.0, ..arm() }
}

/// Computes the integrals by composite Simpson sums, 4000 steps over each span between reversals and sign changes of
/// the torque; the fourth-order error is far below the tolerance.
fn brute(mechanism: &Mechanism, motion: &Motion, own: f64) -> [f64; 5] {
    let mut sums = [0.0; 5];
    let none = Extra::none();
    for piece in motion.pieces() {
        let torque = |t: f64, direction: f64| {
            let state = piece.at(t);
            let output = Output {
                position_rad: state.position_rad,
                speed_rad_s: state.speed_rad_s,
                acceleration_rad_s2: state.acceleration_rad_s2,
                direction,
            };
            (mechanism.torque(&output, &none), mechanism.useful_torque(&output, &none), state)
        };
        let mut cuts = vec![0.0, piece.duration_s];
        cuts.extend(piece.reversals());
        let runs = piece.runs();
        let sign = |t: f64| runs.direction(t);
        cuts.extend(numeric::roots(|t| torque(t, sign(t)).0, piece.duration_s));
        cuts.extend(numeric::roots(|t| torque(t, sign(t)).1, piece.duration_s));
        cuts.sort_by(f64::total_cmp);
        for pair in cuts.windows(2) {
            let n = 4000;
            let h = (pair[1] - pair[0]) / f64::from(n);
            let direction = sign(0.5 * (pair[0] + pair[1]));
            let values = |t: f64| {
                let (load, _, state) = torque(t, direction);
                let whole = own * state.acceleration_rad_s2 + load;
                [
                    whole * whole,
                    state.speed_rad_s.abs(),
                    direction * direction,
                    load.abs().powi(3) * state.speed_rad_s.abs(),
                    whole * state.speed_rad_s,
                ]
            };
            for k in 0..n {
                let t = pair[0] + f64::from(k) * h;
                let [a, m, b] = [values(t), values(t + 0.5 * h), values(t + h)];
                for (sum, ((a, m), b)) in sums.iter_mut().zip(a.iter().zip(m).zip(b)) {
                    *sum += (a + 4.0 * m + b) * h / 6.0;
                }
            }
        }
    }
    sums
}

fn compare(name: &str, mechanism: &Mechanism, motion: &Motion) {
    let trace = Trace::of(mechanism, motion, &[], &[]);
    let own = 0.7;
    let expected = brute(mechanism, motion, own);
    let work: f64 = trace
        .nodes()
        .iter()
        .map(|node| node.weight_s * (own * node.acceleration_rad_s2 + node.load_nm) * node.speed_rad_s)
        .sum();
    let found =
        [trace.gram.square([own, 1.0, 0.0, 0.0]), trace.gram.travelled(), trace.gram.moving(), trace.cubes(), work];
    for (index, (a, b)) in found.iter().zip(expected).enumerate() {
        assert!((a - b).abs() <= 1e-12 * (1.0 + b.abs()), "{name}, integral {index}: {a} against {b}");
    }
    let duration: f64 = trace.nodes().iter().map(|node| node.weight_s).sum();
    assert!((duration - motion.duration().si()).abs() < 1e-12, "{name}: the weights sum to {duration}");
    assert!(trace.nodes().windows(2).all(|pair| pair[1].time_s >= pair[0].time_s), "{name}: time runs forward");
}

#[test]
fn the_moments_agree_with_brute_force_for_every_law_and_load() {
    let mut viscous = direct();
    viscous.friction = Friction {
        viscous: ViscousFriction::from_si(2.0),
        external: Torque::from_si(3.0),
        coulomb: Torque::from_si(1.0),
    };
    let motions = [
        ("manual", motion(&[manual(4.0, [0.1, 0.3, 0.25, 0.5]), manual(-2.5, [0.4, 0.0, 0.2, 0.05])])),
        ("jerk", motion(&[jerk(2.0), SegmentSpec::Dwell(Time::from_si(0.3), Hold::Motor), jerk(-2.0)])),
        ("trapezoid", motion(&[law(Law::Trapezoid, 1.0, 0.4), law(Law::Triangle, -1.0, 0.5)])),
        ("polynomial", motion(&[law(Law::Polynomial5, 1.4, 0.6), law(Law::Polynomial5, -1.4, 0.9)])),
        ("modified sine", motion(&[law(Law::ModifiedSine, 1.4, 0.6), law(Law::ModifiedTrapezoid, -1.4, 0.9)])),
        ("sines", motion(&[law(Law::InclinedSine, 1.4, 0.6), law(Law::SimpleSine, -1.4, 0.9)])),
    ];
    for (name, motion) in &motions {
        compare(&format!("direct, {name}"), &direct(), motion);
        compare(&format!("viscous, {name}"), &viscous, motion);
        compare(&format!("arm, {name}"), &arm(), motion);
    }
}

/// Returns mechanisms whose inertia depends on the position, also near their singular positions: a lift at 11°, a
/// linkage whose coupler and rocker are nearly in line, a slider-crank with l/r = 1.05.
#[test]
fn the_moments_agree_with_brute_force_where_the_inertia_depends_on_the_position() {
    let (m, kg, kgm2) = (Length::from_si, Mass::from_si, MomentOfInertia::from_si);
    let none = Angle::from_si(0.0);
    let tilt = Angle::from_si(std::f64::consts::FRAC_PI_2);
    let four_bar = |coupler| FourBar {
        ground: m(0.4),
        crank: m(0.1),
        coupler: m(coupler),
        rocker: m(0.25),
        is_crossed: false,
        inertia: kgm2(0.02),
        coupler_mass: kg(2.5),
        coupler_centre: m(0.15),
        coupler_inertia: kgm2(0.03),
        rocker_mass: kg(3.0),
        rocker_centre: m(0.12),
        rocker_inertia: kgm2(0.08),
        rocker_torque: Torque::from_si(6.0),
        inclination: none,
        tilt,
    };
    let (inertia, mass) = (kgm2(0.01), kg(4.0));
    let kinds = [
        MechanismKind::FourBar(four_bar(0.35)),
        MechanismKind::FourBar(four_bar(0.256)),
        MechanismKind::SliderCrank(SliderCrank {
            crank: m(0.2),
            rod: m(0.21),
            inertia,
            mass,
            inclination: tilt,
            angle: none,
        }),
        MechanismKind::ScissorLift(ScissorLift {
            stages: 2,
            arm_length: m(1.2),
            lead: m(0.9),
            angle: Angle::from_si(0.2),
            mass: kg(20.0),
            arm_mass: kg(9.0),
            inertia,
        }),
        MechanismKind::Winder(Winder {
            winding: Winding::Up,
            core_diameter: m(0.1),
            full_diameter: m(0.6),
            start_diameter: m(0.3),
            thickness: m(0.02),
            width: m(0.3),
            density: MassDensity::from_si(900.0),
            tension: Force::from_si(30.0),
            inertia,
        }),
        MechanismKind::Hoist(Hoist {
            drum_diameter: m(0.3),
            falls: 2,
            inertia,
            mass,
            counterweight: kg(1.0),
            rope_mass: kg(2.0),
            hanging: m(3.0),
            reeving: 1.0,
        }),
    ];
    let motions = [
        motion(&[law(Law::Polynomial5, 6.0, 1.6), law(Law::ModifiedSine, -6.0, 1.9)]),
        motion(&[law(Law::Trapezoid, 3.0, 0.8), law(Law::SimpleSine, -3.0, 0.9)]),
    ];
    for kind in kinds {
        let mechanism = Mechanism { kind, efficiency_driving: 0.9, ..direct() };
        for motion in &motions {
            let what = mechanism.id().key();
            let trace = Trace::of(&mechanism, motion, &[], &[]);
            let span = mechanism.range_rad().unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
            assert!(trace.span.0 >= span.0 && trace.span.1 <= span.1, "{what}: {:?} {span:?}", trace.span);
            compare(what, &mechanism, motion);
        }
    }
}

/// J_L and T_h of linkages, cranks and arms at their true extremes along laws, dwells and a recording of coarse samples, not
/// at the nearest node: a dense walk over the positions, which the trace does not see.
#[test]
fn inertia_and_holding_torque_are_those_at_the_true_extremes() {
    let m = Length::from_si;
    let four_bar = |rocker: f64| FourBar {
        ground: m(0.4),
        crank: m(0.1),
        coupler: m(0.35),
        rocker: m(rocker),
        inertia: MomentOfInertia::from_si(0.02),
        coupler_mass: Mass::from_si(2.5),
        coupler_centre: m(0.15),
        rocker_mass: Mass::from_si(3.0),
        rocker_centre: m(0.12),
        rocker_inertia: MomentOfInertia::from_si(0.08),
        tilt: Angle::from_si(1.3),
        ..FourBar::default()
    };
    let crank = SliderCrank {
        crank: m(0.2),
        rod: m(0.5),
        inertia: MomentOfInertia::from_si(0.01),
        mass: Mass::from_si(4.0),
        inclination: Angle::from_si(1.0),
        angle: Angle::from_si(0.4),
    };
    let none = Torque::from_si(0.0);
    let of = |kind| Mechanism { kind, ..Mechanism::direct(MomentOfInertia::from_si(0.0), none) };
    let loads = [
        of(MechanismKind::FourBar(four_bar(0.25))),
        of(MechanismKind::FourBar(four_bar(0.2))),
        of(MechanismKind::SliderCrank(crank)),
        lossless(),
    ];
    let motions = [
        motion(&[law(Law::Polynomial5, 2.3, 0.7), SegmentSpec::Dwell(Time::from_si(0.2), Hold::Motor)]),
        motion(&[law(Law::ModifiedSine, 5.1, 1.1), law(Law::Trapezoid, -4.0, 0.9)]),
        motion(&[jerk(7.7)]),
        swing(9),
    ];
    for (place, mechanism) in loads.iter().enumerate() {
        for (number, motion) in motions.iter().enumerate() {
            let extra = Extra { inertia: MomentOfInertia::from_si(0.05), ..Extra::none() };
            let trace = Trace::of(mechanism, motion, &[extra; 2], &[]);
            let (low, high) = trace.span();
            let (mut inertia, mut holding) = ((f64::INFINITY, 0.0_f64), 0.0_f64);
            for k in 0..=20_000 {
                let q = low.si() + (high.si() - low.si()) * f64::from(k) / 20_000.0;
                let here = mechanism.inertia(q, &extra).si();
                inertia = (inertia.0.min(here), inertia.1.max(here));
                holding = holding.max(mechanism.holding_torque(q, &extra).si().abs());
            }
            let (largest, least) = trace.inertia();
            let found = [largest.si(), least.si(), trace.holding().si()];
            for (found, walked) in found.into_iter().zip([inertia.1, inertia.0, holding]) {
                let off = (found - walked).abs() / walked;
                assert!(off < 2e-7, "load {place}, motion {number}: {found} beside {walked}, {off:e}");
            }
        }
    }
}

#[test]
fn the_brake_carries_what_the_motor_does_not() {
    let cycle = motion(&[jerk(0.5), SegmentSpec::Dwell(Time::from_si(1.0), Hold::Brake), jerk(-0.5)]);
    let hold = |dwell| Trace::of(&arm(), &cycle, &[], &[Carried::Throughout, dwell]);
    let ends = Carried::AtItsEnds { first: Time::from_si(0.07), last: Time::from_si(0.11) };
    let (motor, brake, never) = (hold(Carried::Throughout), hold(ends), hold(Carried::Never));
    let square = |trace: &Trace| trace.gram.square([0.0, 1.0, 0.0, 0.0]);
    // Half a radian from the horizontal the arm needs its cosine, 0.82 of the second held by the brake.
    let held = (6.0 * mechanism::gravity_m_s2() * 0.35 * 0.5_f64.cos()).powi(2);
    assert!((square(&motor) - square(&brake) - 0.82 * held).abs() < 1e-9, "{}", square(&motor) - square(&brake));
    assert!((square(&motor) - square(&never) - held).abs() < 1e-9);
    // Independent of motor or brake: no position needs more than the horizontal one, from which the arm starts.
    let expected = 6.0 * mechanism::gravity_m_s2() * 0.35;
    assert!((brake.holding - expected).abs() < 1e-9, "{}", brake.holding);
    assert_eq!(motor.holding, brake.holding);
}

/// Skipping blocks does not change the result: the largest value over thousands of instants agrees with a plain loop.
#[test]
fn the_envelope_finds_what_a_plain_loop_finds() {
    let mut segments = Vec::new();
    for k in 0..120 {
        let speed = 1.0 + 0.37 * f64::from((k * 7) % 11);
        segments
            .push(manual(if k % 3 == 0 { -speed } else { speed }, [0.05 + 0.001 * f64::from(k % 17), 0.1, 0.06, 0.0]));
    }
    let trace = Trace::of(&direct(), &motion(&segments), &[], &[]);
    assert!(trace.nodes().len() > 4 * BLOCK);
    for own in [0.0, 0.01, 0.5, 8.0] {
        let value = |node: &Node| (own * node.acceleration_rad_s2 + node.load_nm).abs();
        let (largest, node) = trace.largest(&TorqueWith { inertia_kgm2: own });
        let at = node.time_s;
        let mut plain = (f64::NEG_INFINITY, 0.0);
        for node in &trace.nodes() {
            if value(node) > plain.0 {
                plain = (value(node), node.time_s);
            }
        }
        assert_eq!((largest, at), plain, "own inertia {own}");
    }
}

#[test]
fn from_rest_to_rest_the_acceleration_along_the_motion_cancels() {
    let trace = Trace::of(&direct(), &motion(&[manual(4.0, [0.1, 0.3, 0.25, 0.5])]), &[], &[]);
    let along: f64 = trace.nodes().iter().map(|node| node.weight_s * node.acceleration_rad_s2 * node.direction).sum();
    assert!(along.abs() < 1e-12);
}

/// 1.8 kgm² turned by 90° in 0.5 s: α_max = C_a s/T² with the published C_a of each law, found to the last digits
/// although it lies inside the motion.
#[test]
fn the_peak_of_every_law_is_a_node() {
    let (s, t) = (std::f64::consts::FRAC_PI_2, 0.5);
    let load = Mechanism::direct(MomentOfInertia::from_si(1.0), Torque::from_si(0.0));
    for (law_name, c_a) in [
        (Law::Triangle, 4.0),
        (Law::Polynomial5, 10.0 / 3.0_f64.sqrt()),
        (Law::ModifiedSine, law_constant(Law::ModifiedSine)),
        (Law::ModifiedTrapezoid, law_constant(Law::ModifiedTrapezoid)),
        (Law::SimpleSine, std::f64::consts::PI.powi(2) / 2.0),
        (Law::InclinedSine, std::f64::consts::TAU),
    ] {
        let trace = Trace::of(&load, &motion(&[law(law_name, s, t)]), &[], &[]);
        let (peak, _) = trace.largest(&TorqueWith { inertia_kgm2: 0.8 });
        let expected = 1.8 * c_a * s / (t * t);
        assert!((peak / expected - 1.0).abs() < 1e-12, "{law_name:?}: {peak} against {expected}");
    }
}

fn law_constant(law: Law) -> f64 {
    law.characteristics().1
}

/// Returns a swing of three harmonics with a recorded torque, sampled irregularly.
pub(super) fn swing(samples: u32) -> Motion {
    let step = |k: u32| f64::from(k) + 0.15 * f64::from(k % 5) - 0.3;
    let end = step(samples - 1) - step(0);
    let time_s: Vec<f64> = (0..samples).map(|k| 6.0 * (step(k) - step(0)) / end).collect();
    let phase = |t: f64, k: f64| std::f64::consts::TAU * t * k / 6.0;
    let speed = time_s.iter().map(|t| phase(*t, 1.0).sin() + 0.4 * phase(*t, 3.0).sin() - 0.7 * phase(*t, 7.0).sin());
    let torque = time_s.iter().map(|t| 12.0 * phase(*t, 2.0).cos() + 3.0 * phase(*t, 11.0).sin());
    let mut speed: Vec<f64> = speed.collect();
    let torque: Vec<f64> = torque.collect();
    // A pause.
    speed.iter_mut().skip(samples as usize / 3).take(samples as usize / 10).for_each(|speed| *speed = 0.0);
    (speed[0], speed[samples as usize - 1]) = (0.0, 0.0);
    let samples = Samples {
        time_s: time_s.into(),
        speed_rad_s: Some(speed.into()),
        torque_nm: Some(torque.into()),
        position_rad: None,
    };
    let recorded = Recorded::new(samples, Treatment::default()).unwrap();
    Motion::new(&[SegmentSpec::Recorded(std::sync::Arc::new(recorded))], None, Closing::SingleMove).unwrap()
}

/// Straight speed and torque between samples, each interval separately: the squares of straight lines and their
/// products have closed integrals.
fn by_intervals(placed: &Placed, plain: &Mechanism, own: f64) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for interval in (0..placed.intervals()).map(|k| placed.interval(k).unwrap()) {
        let [w0, w1] = interval.speed_rad_s;
        let mut cuts = vec![0.0];
        if w0 * w1 < 0.0 {
            cuts.push(w0 / (w0 - w1));
        }
        cuts.push(1.0);
        for cut in cuts.windows(2) {
            let h = (cut[1] - cut[0]) * interval.duration_s;
            let direction = if w0 == 0.0 && w1 == 0.0 { 0.0 } else { interval.at(0.5 * (cut[0] + cut[1])).1.signum() };
            let at = |u: f64| {
                let (position, speed, torque) = interval.at(u);
                let output = Output {
                    position_rad: position,
                    speed_rad_s: speed,
                    acceleration_rad_s2: interval.acceleration_rad_s2(),
                    direction,
                };
                let extra = Extra { torque: Torque::from_si(torque), ..Extra::none() };
                (own * output.acceleration_rad_s2 + plain.torque(&output, &extra), speed)
            };
            let ((a, v), (b, w)) = (at(cut[0]), at(cut[1]));
            sums[0] += h * (a * a + a * b + b * b) / 3.0;
            sums[1] += h * (v + w).abs() / 2.0;
            sums[2] += h * direction * direction;
        }
    }
    sums
}

#[test]
fn the_moments_of_a_recording_are_exact_for_straight_lines_between_samples() {
    let mut load = direct();
    load.friction.viscous = ViscousFriction::from_si(2.0);
    for samples in [50, 1_000, 20_000] {
        let motion = swing(samples);
        let trace = Trace::of(&load, &motion, &[], &[]);
        let expected = by_intervals(&motion.recordings()[0], &load, 0.7);
        let found = [trace.gram.square([0.7, 1.0, 0.0, 0.0]), trace.gram.travelled(), trace.gram.moving()];
        for (index, (a, b)) in found.iter().zip(expected).enumerate() {
            assert!((a - b).abs() <= 1e-12 * (1.0 + b.abs()), "{samples}, integral {index}: {a} against {b}");
        }
        let work: f64 = trace.nodes().iter().map(|n| n.weight_s * n.acceleration_rad_s2 * n.load_nm).sum();
        let blocks: f64 =
            trace.blocks().iter().map(|block| block.gram.product([1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0])).sum();
        assert!((work - blocks).abs() <= 1e-11 * (1.0 + work.abs()), "{work} {blocks}");
    }
}

/// A finely sampled law: the error of the samples decreases with the square of the step.
#[test]
fn a_sampled_law_comes_near_the_law() {
    let segments = [law(Law::Polynomial5, 1.4, 0.6), law(Law::Polynomial5, -1.4, 0.9)];
    let exact = motion(&segments);
    let sampled = |n: u32| {
        let time_s: Vec<f64> = (0..=n).map(|k| 1.5 * f64::from(k) / f64::from(n)).collect();
        let at = |t: f64| {
            let piece = exact.pieces().iter().rfind(|piece| piece.start_s <= t).unwrap();
            piece.at(t - piece.start_s)
        };
        let samples = Samples {
            position_rad: Some(std::sync::Arc::new(time_s.iter().map(|t| at(*t).position_rad).collect())),
            speed_rad_s: Some(std::sync::Arc::new(time_s.iter().map(|t| at(*t).speed_rad_s).collect())),
            time_s: time_s.into(),
            torque_nm: None,
        };
        let recorded = Recorded::new(samples, Treatment::default()).unwrap();
        let segment = SegmentSpec::Recorded(std::sync::Arc::new(recorded));
        Motion::new(&[segment], None, Closing::Position).unwrap()
    };
    for load in [direct(), arm()] {
        let own = [0.7, 1.0, 0.0, 0.0];
        let whole = Trace::of(&load, &exact, &[], &[]).gram.square(own);
        let miss = |n| (Trace::of(&load, &sampled(n), &[], &[]).gram.square(own) / whole - 1.0).abs();
        let (coarse, fine) = (miss(300), miss(600));
        assert!(coarse < 2e-3 && fine < 5e-4, "{coarse} {fine}");
        assert!(coarse / fine > 3.0 || coarse < 1e-6, "{coarse} {fine}");
    }
}

/// Enough samples for two threads, and the envelope against a plain loop.
#[test]
fn the_envelope_of_a_recording_finds_what_a_plain_loop_finds_and_threads_change_no_bit() {
    let motion = swing(70_000);
    let trace = Trace::of(&direct(), &motion, &[], &[]);
    let again = Trace::of(&direct(), &motion, &[], &[]);
    assert_eq!(trace.gram, again.gram);
    let single: Vec<Gram> = swing_blocks(&motion);
    assert_eq!(trace.blocks().iter().map(|block| block.gram).collect::<Vec<_>>(), single);
    for own in [0.0, 0.5, 8.0] {
        let value = |node: &Node| (own * node.acceleration_rad_s2 + node.load_nm).abs();
        let (largest, node) = trace.largest(&TorqueWith { inertia_kgm2: own });
        let plain = trace.nodes().iter().fold((f64::NEG_INFINITY, 0.0), |best, node| {
            if value(node) > best.0 { (value(node), node.time_s) } else { best }
        });
        assert_eq!((largest, node.time_s), plain, "own inertia {own}");
    }
}

/// Returns the sums of the blocks of a recording, after checking that a sequential pass gives the same.
fn swing_blocks(motion: &Motion) -> Vec<Gram> {
    let strip = Strip::new(motion.recordings()[0].clone(), direct(), Extra::none(), &[], &[]);
    let count = motion.recordings()[0].intervals();
    let most = strip.block_intervals();
    let raw: Vec<Gram> =
        (0..count).step_by(most).map(|from| strip.block(from..(from + most).min(count)).gram).collect();
    assert_eq!(raw, strip.raw_blocks().iter().map(|block| block.gram).collect::<Vec<_>>());
    strip.found(0).blocks.iter().map(|block| block.gram).collect()
}
/// J = 1.28 kgm², b = 16.127 Nms/rad, 1 rad by limited jerk, 10 rad/s, 10 rad/s², 60 rad/s³: the largest torque lies within a
/// phase of constant jerk, where J α falls and b ω rises. Dense sampling of the motion finds 42.35 Nm, its phases' ends 42.16.
#[test]
fn the_peak_between_nodes_is_found() {
    let mut load = Mechanism::direct(MomentOfInertia::from_si(1.0), Torque::from_si(0.0));
    load.friction.viscous = ViscousFriction::from_si(16.127);
    let given = Given {
        distance: Some(Angle::from_si(1.0)),
        speed: Some(AngularVelocity::from_si(10.0)),
        acceleration: Some(AngularAcceleration::from_si(10.0)),
        jerk: Some(AngularJerk::from_si(60.0)),
        ..Given::default()
    };
    let motion = motion(&[SegmentSpec::Move(Law::Jerk, given)]);
    let dense = |own: f64| {
        let pieces = motion.pieces().iter();
        let at = |piece: &motion::Piece, k: u32| {
            let state = piece.at(piece.duration_s * f64::from(k) / 20_000.0);
            ((1.0 + own) * state.acceleration_rad_s2 + 16.127 * state.speed_rad_s).abs()
        };
        pieces.flat_map(|piece| (0..=20_000).map(move |k| at(piece, k))).fold(0.0, f64::max)
    };
    let trace = Trace::of(&load, &motion, &[], &[]);
    for own in [0.0, 0.28, 0.6, 3.0] {
        let (peak, node) = trace.largest(&TorqueWith { inertia_kgm2: own });
        let expected = dense(own);
        assert!((peak / expected - 1.0).abs() < 1e-8, "{own}: {peak} against {expected}");
        assert!(((own * node.acceleration_rad_s2 + node.load_nm).abs() - peak).abs() < 1e-12);
    }
    assert!((dense(0.28) - 42.35).abs() < 0.005, "{}", dense(0.28));
}
