//! Loads on the flange over a cycle against closed forms, and against sums over many small steps.

use super::*;
use actuator::FlangeLoad;
use mechanism::{Contact, Extra, Linear, LinearKind, Mechanism, MechanismKind, Rotor, RotorKind};
use motion::{Closing, Given, Law, Motion, Recorded, Samples, SegmentSpec, Treatment};
use quantities::unit::DEGREE;
use quantities::{Angle, AngularVelocity, Mass, MomentOfInertia};

const G: f64 = 9.806_65;
const B: f64 = 10.0 / 3.0;

fn length(metres: f64) -> Length {
    Length::from_si(metres)
}

fn bearing(offset: f64, exponent: f64) -> Geometry {
    Geometry { offset: length(offset), pitch: length(0.088), exponent }
}

fn arm(mass: f64, tilt_deg: f64) -> Mechanism {
    let rotor = Rotor {
        kind: RotorKind::Arm,
        inertia: MomentOfInertia::from_si(0.9),
        mass: Mass::from_si(mass),
        radius: length(0.35),
        payload_radius: length(0.6),
        angle: Angle::from_si(0.0),
        tilt: Angle::new_in(tilt_deg, &DEGREE),
    };
    Mechanism {
        kind: MechanismKind::Rotor(rotor),
        ..Mechanism::direct(MomentOfInertia::from_si(0.0), Torque::from_si(0.0))
    }
}

fn mounting() -> Mounting {
    Mounting { overhang: Some(length(0.05)), payload_overhang: Some(length(0.12)), ..Mounting::default() }
}

fn none() -> FlangeLoad {
    let none = length(0.0);
    FlangeLoad {
        radial_force: Force::from_si(0.0),
        radial_distance: none,
        axial_force: Force::from_si(0.0),
        axial_distance: none,
    }
}

fn axis(mechanism: Mechanism, specs: &[SegmentSpec], extras: Vec<Extra>, own: FlangeLoad) -> Axis {
    let motion = Motion::new(specs, Some(Angle::from_si(0.3)), Closing::SingleMove).unwrap();
    let mut axis = Axis::new(mechanism, motion, extras);
    axis.bearing = Some(BearingDuty {
        has_loads: true,
        loads: vec![own; specs.len()],
        derived: Some(DerivedLoads { mounting: mounting(), acts: vec![true; specs.len()] }),
        load_factor: Some(1.2),
        operating_condition: None,
        life_min: None,
        tilt_max: None,
    });
    axis
}

fn turning(turns: f64, seconds: f64) -> SegmentSpec {
    let given = Given {
        speed: Some(AngularVelocity::from_si(turns * std::f64::consts::TAU / seconds)),
        time: Some(Time::from_si(seconds)),
        ..Given::default()
    };
    SegmentSpec::Move(Law::Constant, given)
}

fn swing(angle_deg: f64, seconds: f64) -> SegmentSpec {
    let given = Given {
        distance: Some(Angle::new_in(angle_deg, &DEGREE)),
        time: Some(Time::from_si(seconds)),
        ..Given::default()
    };
    SegmentSpec::Move(Law::ModifiedSine, given)
}

/// A level arm over whole revolutions at constant speed: F_r² = m² (c² + g² − 2 c g sin θ), c = ω² r, from m |g − c| to
/// m (g + c); the mean of the square over a turn is m² (c² + g²), which B = 2 shows; M = F_r (L + R) throughout.
#[test]
fn whole_revolutions_by_hand() {
    for turns in [1.0, 3.0, 500.0] {
        let axis = axis(arm(6.0, 90.0), &[turning(turns, turns * 0.9)], Vec::new(), none());
        let c = (std::f64::consts::TAU / 0.9_f64).powi(2) * 0.35;
        let found = axis.derived_loads(&bearing(0.018, 2.0)).unwrap();
        assert!((found.turning.radial.value() / (6.0 * (c + G)) - 1.0).abs() < 1e-12, "{found:?}");
        assert!((found.means[0] / (6.0 * (c * c + G * G).sqrt()) - 1.0).abs() < 1e-12, "{turns}: {found:?}");
        assert!((found.mean_moment / (found.means[0] * 0.068) - 1.0).abs() < 1e-12);
        assert_eq!(found.turning.axial.value(), 0.0);
        // The largest force is at the lowest position of the mass: θ = 270°, from 0.3 rad on.
        let at = (1.5 * std::f64::consts::PI - 0.3) / (std::f64::consts::TAU / 0.9);
        assert!((found.turning.radial.at() - at).abs() < 1e-6, "{} {at}", found.turning.radial.at());
    }
}

/// Returns means and peaks of a cycle by a plain sum over many steps, written independently of the walk.
fn brute(axis: &Axis, offset: f64, exponent: f64, steps: u32) -> [f64; 7] {
    let mut equivalent = 0.0_f64;
    let (mut peaks, mut sums, mut travelled) = ([0.0_f64; 3], [0.0; 3], 0.0);
    let duty = axis.bearing.as_ref().unwrap();
    for piece in axis.motion.pieces() {
        for step in 0..steps {
            let dt = piece.duration_s / f64::from(steps);
            let state = piece.at((f64::from(step) + 0.5) * dt);
            let (w, a) = (state.speed_rad_s, state.acceleration_rad_s2);
            let output = Output {
                position_rad: state.position_rad,
                speed_rad_s: w,
                acceleration_rad_s2: a,
                direction: if w == 0.0 { 0.0 } else { w.signum() },
            };
            let extra = axis.extras.get(piece.segment).copied().unwrap_or_else(Extra::none);
            let forces = axis.mechanism.flange_forces(&output, &extra, 0.0, &duty.derived.as_ref().unwrap().mounting);
            let own = &duty.loads[piece.segment];
            let values = [
                forces.radial() + own.radial_force.si(),
                forces.axial() + own.axial_force.si(),
                forces.moment(length(offset)) + actuator::tilting_moment(own, length(offset)).si(),
            ];
            equivalent = equivalent.max(values[2] + 0.044 * (values[0] + 0.44 * values[1]));
            for k in 0..3 {
                peaks[k] = peaks[k].max(values[k]);
                sums[k] += values[k].powf(exponent) * w.abs() * dt;
            }
            travelled += w.abs() * dt;
        }
    }
    let means = sums.map(|sum| (sum / travelled).powf(1.0 / exponent));
    [peaks[0], peaks[1], peaks[2], means[0], means[1], means[2], equivalent]
}

#[test]
fn laws_agree_with_many_small_steps() {
    let own = FlangeLoad { radial_force: Force::from_si(40.0), axial_force: Force::from_si(15.0), ..none() };
    let payload = Extra { mass: Mass::from_si(2.5), ..Extra::none() };
    let slide = Linear {
        kind: LinearKind::Screw,
        travel_m_per_rad: 0.02,
        inertia: MomentOfInertia::from_si(0.001),
        mass: Mass::from_si(30.0),
        counterweight: Mass::from_si(0.0),
        inclination: Angle::from_si(0.0),
        friction_force: Force::from_si(20.0),
        friction_coefficient: 0.0,
    };
    let screw = Mechanism {
        kind: MechanismKind::Linear(slide),
        ..Mechanism::direct(MomentOfInertia::from_si(0.0), Torque::from_si(0.0))
    };
    for (mechanism, specs) in [
        (arm(6.0, 90.0), vec![swing(150.0, 0.7), swing(-150.0, 0.5)]),
        (arm(6.0, 35.0), vec![swing(400.0, 1.1)]),
        (arm(6.0, 65.0), vec![turning(2.7, 2.0)]),
        (screw, vec![swing(900.0, 0.9), swing(-900.0, 0.4)]),
    ] {
        let axis = axis(mechanism, &specs, vec![payload, Extra::none()], own);
        for exponent in [3.0, B] {
            let found = axis.derived_loads(&bearing(0.018, exponent)).unwrap();
            let expected = brute(&axis, 0.018, exponent, 20_000);
            let peaks = [found.turning.radial.value(), found.turning.axial.value()];
            for (found, expected) in
                peaks.iter().chain(&found.means).zip([expected[0], expected[1], expected[3], expected[4]])
            {
                assert!((found - expected).abs() <= 1e-6 * (1.0 + expected), "{found} {expected}");
            }
            assert!((found.mean_moment - expected[5]).abs() <= 1e-6 * (1.0 + expected[5]));
            assert!((found.turning.moment.value() - expected[2]).abs() <= 1e-6 * (1.0 + expected[2]));
            assert!((found.turning.equivalent.value() - expected[6]).abs() <= 1e-6 * (1.0 + expected[6]));
        }
    }
}

/// At the ends of a move the computed speed is rounding, of either sign; friction keeps the direction of the move there, under
/// every law and duration. Downhill with more friction than weight the way back would pull with their sum.
#[test]
fn rounding_at_the_end_of_a_move_turns_no_friction() {
    let laws = Law::ALL.into_iter().filter(|law| !matches!(law, Law::Constant | Law::Jerk));
    for (law, kind) in
        laws.flat_map(|law| [(law, LinearKind::Belt), (law, LinearKind::Conveyor), (law, LinearKind::Screw)])
    {
        for seconds in [1.0, 3.3, 4.0, 7.1, 12.7, 20.0, 40.2, 60.3, 100.7, 300.1, 1000.0] {
            let slide = Linear {
                kind,
                travel_m_per_rad: 0.05,
                inertia: MomentOfInertia::from_si(0.001),
                mass: Mass::from_si(30.0),
                counterweight: Mass::from_si(0.0),
                inclination: Angle::new_in(-20.0, &DEGREE),
                friction_force: Force::from_si(40.0),
                friction_coefficient: 0.6,
            };
            let mechanism = Mechanism {
                kind: MechanismKind::Linear(slide),
                efficiency_driving: 0.9,
                efficiency_driven: 0.8,
                ..Mechanism::direct(MomentOfInertia::from_si(0.0), Torque::from_si(0.0))
            };
            let given = Given {
                distance: Some(Angle::new_in(900.0, &DEGREE)),
                time: Some(Time::from_si(seconds)),
                ..Given::default()
            };
            let mut axis = axis(mechanism, &[SegmentSpec::Move(law, given)], Vec::new(), none());
            let derived = axis.bearing.as_mut().and_then(|duty| duty.derived.as_mut()).unwrap();
            derived.mounting.contact = Some(Contact::Belt { tension: Force::from_si(100.0) });
            let found = axis.derived_loads(&bearing(0.018, B)).unwrap();
            let expected = brute(&axis, 0.018, B, 2_000);
            let peaks = [found.turning.radial, found.turning.axial, found.turning.moment].map(|peak| peak.value());
            for (found, expected) in peaks.into_iter().zip(expected) {
                assert!(found <= 1e-9 + 1.002 * expected, "{law:?} {kind:?} {seconds} s: {found} {expected}");
            }
        }
    }
}

/// A finely recorded motion gives the loads of the law that it was recorded from, up to its steps of the acceleration.
#[test]
fn a_recording_agrees_with_its_law() {
    let law = axis(arm(6.0, 90.0), &[swing(150.0, 0.7), swing(-150.0, 0.5)], Vec::new(), none());
    let piece_at = |t: f64| {
        let pieces = law.motion.pieces();
        let piece = pieces.iter().rfind(|piece| piece.start_s <= t).unwrap();
        piece.at((t - piece.start_s).min(piece.duration_s))
    };
    let n = 6000;
    let time: Vec<f64> = (0..=n).map(|k| 1.2 * f64::from(k) / f64::from(n)).collect();
    let samples = Samples {
        position_rad: Some(std::sync::Arc::new(time.iter().map(|t| piece_at(*t).position_rad).collect())),
        speed_rad_s: Some(std::sync::Arc::new(time.iter().map(|t| piece_at(*t).speed_rad_s).collect())),
        time_s: time.into(),
        torque_nm: None,
    };
    let recorded = Recorded::new(samples, Treatment::default()).unwrap();
    let recorded = axis(arm(6.0, 90.0), &[SegmentSpec::Recorded(Arc::new(recorded))], Vec::new(), none());
    let (law, recorded) =
        (law.derived_loads(&bearing(0.02, B)).unwrap(), recorded.derived_loads(&bearing(0.02, B)).unwrap());
    for (a, b) in [
        (law.means[0], recorded.means[0]),
        (law.mean_moment, recorded.mean_moment),
        (law.turning.radial.value(), recorded.turning.radial.value()),
    ] {
        assert!((a / b - 1.0).abs() < 5e-5, "{a} {b}");
    }
}

#[test]
fn without_mass_only_what_is_stated_remains() {
    let own = FlangeLoad {
        radial_force: Force::from_si(100.0),
        radial_distance: length(0.06),
        axial_force: Force::from_si(250.0),
        axial_distance: length(0.04),
    };
    let axis = axis(arm(0.0, 90.0), &[swing(150.0, 0.7), swing(-150.0, 0.5)], Vec::new(), own);
    let found = axis.derived_loads(&bearing(0.02, B)).unwrap();
    let close = |a: f64, b: f64| (a - b).abs() < 1e-12 * b;
    assert!(close(found.means[0], 100.0) && close(found.means[1], 250.0));
    assert!(close(found.turning.moment.value(), 18.0) && close(found.mean_moment, 18.0));
}

/// Requires that each pair of bearing position and exponent is computed once; a copy of the axis shares the result.
#[test]
fn what_is_known_is_not_worked_out_again() {
    let axis = axis(arm(6.0, 90.0), &[swing(150.0, 0.7)], Vec::new(), none());
    let first = axis.derived_loads(&bearing(0.02, B)).unwrap();
    assert_eq!(axis.clone().derived_loads(&bearing(0.02, B)), Some(first));
    assert_eq!(axis.flange_known.0.loads.lock().unwrap().len(), 1);
}
