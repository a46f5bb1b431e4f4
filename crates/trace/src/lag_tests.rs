//! Tests of lags of forms against independent sums, and of their invariances.

use super::tests::{arm, direct, jerk, law, manual, motion, swing};
use super::*;
use mechanism::{Friction, Output};
use motion::{Hold, Law, SegmentSpec};
use quantities::{Angle, Measure, Time, Torque, ViscousFriction};

/// Returns the loss of a motor with friction, and a second form.
fn losses() -> [Form; 2] {
    let copper = Form::square([0.3, 0.9, 1.1, 0.4]);
    let friction = Form::product([0.0, 0.0, 2.0, 0.7], [0.0, 0.0, 0.0, 1.0]);
    [copper.plus(&friction.scale(0.4)), copper.scale(0.2).plus(&friction)]
}

/// Returns x at an instant of a piece, directly from motion and mechanism.
fn signals(
    mechanism: &Mechanism,
    motion: &Motion,
    piece: &motion::Piece,
    t: f64,
    (direction, middle): (f64, f64),
) -> [f64; 4] {
    let state = piece.at(t);
    let output = Output {
        position_rad: state.position_rad,
        speed_rad_s: state.speed_rad_s,
        acceleration_rad_s2: state.acceleration_rad_s2,
        direction,
    };
    // The motor holds until the brake has closed, 70 ms, and while it opens, 110 ms.
    let closed = middle > 0.07 && middle < piece.duration_s - 0.11;
    let held = piece.is_rest()
        && match motion.stretches()[piece.segment].hold {
            Hold::Motor => false,
            Hold::Brake => closed,
            Hold::Free => true,
        };
    let load = if held { 0.0 } else { mechanism.torque(&output, &Extra::none()) };
    [state.acceleration_rad_s2, load, direction, state.speed_rad_s]
}

/// Integrates the lags by Simpson's rule for u e^(t/τ) in steps of equal length between the cuts at which a signal
/// jumps, each with u at its ends and its middle, over so many cycles that the initial state has decayed.
fn brute(mechanism: &Mechanism, motion: &Motion, lags: &[Lag], steps: u32) -> f64 {
    let mut course: Vec<(f64, [Vec<f64>; 3])> = Vec::new();
    for piece in motion.pieces() {
        let rest = piece.is_rest();
        let sign = |t: f64| if rest { 0.0 } else { piece.at(t).speed_rad_s.signum() };
        let mut cuts = vec![0.0, piece.duration_s];
        cuts.extend(piece.reversals());
        if rest {
            cuts.extend([0.07, piece.duration_s - 0.11].iter().filter(|t| (0.0..piece.duration_s).contains(*t)));
        } else {
            for useful in [false, true] {
                let torque = |t: f64| {
                    let state = piece.at(t);
                    let output = Output {
                        position_rad: state.position_rad,
                        speed_rad_s: state.speed_rad_s,
                        acceleration_rad_s2: state.acceleration_rad_s2,
                        direction: sign(t),
                    };
                    let none = Extra::none();
                    if useful { mechanism.useful_torque(&output, &none) } else { mechanism.torque(&output, &none) }
                };
                cuts.extend(numeric::roots(torque, piece.duration_s));
            }
        }
        cuts.sort_by(f64::total_cmp);
        for pair in cuts.windows(2).filter(|pair| pair[1] > pair[0]) {
            let middle = 0.5 * (pair[0] + pair[1]);
            let direction = sign(middle);
            // A step is short against every time constant too.
            let steps = lags.iter().map(|lag| (20.0 * (pair[1] - pair[0]) / lag.tau_s) as u32).fold(steps, u32::max);
            let h = (pair[1] - pair[0]) / f64::from(steps);
            let at = |t: f64| {
                let x = signals(mechanism, motion, piece, t, (direction, middle));
                let form = |lag: &Lag| -> f64 {
                    (0..4).map(|i| (0..4).map(|j| lag.form.0[i][j] * x[i] * x[j]).sum::<f64>()).sum()
                };
                lags.iter().map(form).collect::<Vec<f64>>()
            };
            for k in 0..steps {
                let t = pair[0] + f64::from(k) * h;
                course.push((h, [at(t), at(t + 0.5 * h), at(t + h)]));
            }
        }
    }
    let period: f64 = course.iter().map(|(h, _)| h).sum();
    let mut states = vec![0.0; lags.len()];
    let step = |states: &mut Vec<f64>, (h, u): &(f64, [Vec<f64>; 3])| {
        for (index, (state, lag)) in states.iter_mut().zip(lags).enumerate() {
            let lambda = h / lag.tau_s;
            let (e, half) = ((-lambda).exp(), (-0.5 * lambda).exp());
            *state = *state * e + lambda / 6.0 * (u[0][index] * e + 4.0 * u[1][index] * half + u[2][index]);
        }
        states.iter().sum::<f64>()
    };
    course.iter().for_each(|each| _ = step(&mut states, each));
    for (state, lag) in states.iter_mut().zip(lags) {
        *state /= 1.0 - (-period / lag.tau_s).exp();
    }
    course.iter().map(|each| step(&mut states, each)).fold(f64::NEG_INFINITY, f64::max)
}

/// Returns the trace of a motion with a brake in the segments that state one: it closes in 70 ms and opens in 110 ms.
pub(super) fn under(mechanism: &Mechanism, motion: &Motion) -> Trace {
    let carried = |hold: Hold| match hold {
        Hold::Motor => Carried::Throughout,
        Hold::Brake => Carried::AtItsEnds { first: Time::from_si(0.07), last: Time::from_si(0.11) },
        Hold::Free => Carried::Never,
    };
    let carried: Vec<Carried> = motion.stretches().iter().map(|stretch| carried(stretch.hold)).collect();
    Trace::of(mechanism, motion, &[], &carried)
}

fn two(taus: [f64; 2]) -> [Lag; 2] {
    let [a, b] = losses();
    [Lag { tau_s: taus[0], form: a }, Lag { tau_s: taus[1], form: b }]
}

fn dwell(seconds: f64, hold: Hold) -> SegmentSpec {
    SegmentSpec::Dwell(Time::from_si(seconds), hold)
}

fn cycles() -> Vec<(&'static str, Vec<SegmentSpec>)> {
    vec![
        ("manual", vec![manual(4.0, [0.1, 0.3, 0.25, 0.5]), manual(-2.5, [0.4, 0.0, 0.2, 0.05])]),
        ("jerk", vec![jerk(2.0), dwell(0.3, Hold::Motor), jerk(-2.0), dwell(30.0, Hold::Free)]),
        ("long", vec![jerk(0.7), dwell(40.0, Hold::Motor), jerk(-0.7), dwell(200.0, Hold::Brake)]),
        ("quintic", vec![law(Law::Polynomial5, 1.4, 0.6), law(Law::Polynomial5, -1.4, 0.9)]),
        ("sine", vec![law(Law::ModifiedSine, 1.4, 0.6), law(Law::ModifiedTrapezoid, -1.4, 0.9)]),
        ("slow ramps", vec![manual(0.4, [20.0, 0.0, 30.0, 5.0]), manual(-0.4, [10.0, 0.0, 40.0, 0.0])]),
    ]
}

fn loads() -> Vec<(&'static str, Mechanism)> {
    let mut viscous = direct();
    viscous.friction = Friction {
        viscous: ViscousFriction::from_si(2.0),
        external: Torque::from_si(3.0),
        coulomb: Torque::from_si(1.0),
    };
    vec![("direct", direct()), ("viscous", viscous), ("arm", arm())]
}

#[test]
fn lags_agree_with_brute_force_for_laws_loads_and_time_constants() {
    for (name, segments) in &cycles() {
        for (load, mechanism) in &loads() {
            let motion = motion(segments);
            let trace = under(mechanism, &motion);
            for taus in [[60.0, 2400.0], [0.05, 3.0], [8.0, 0.6]] {
                let lags = two(taus);
                let (found, expected) = (trace.peak_of_lags(&lags), brute(mechanism, &motion, &lags, 1500));
                let error = found.value / expected - 1.0;
                assert!(error.abs() < 1e-6 && error > -1e-8, "{name}, {load}, {taus:?}: {} {expected}", found.value);
                assert!((0.0..=motion.duration().si()).contains(&found.at_s));
            }
        }
    }
}

/// The mean is that of the lag with an endless time constant.
#[test]
fn a_very_long_lag_holds_the_mean() {
    let trace = under(&arm(), &motion(&cycles()[1].1));
    let [form, _] = losses();
    let found = trace.peak_of_lags(&[Lag { tau_s: 1e9, form }]).value;
    assert!((found / trace.mean(&form) - 1.0).abs() < 1e-7, "{found} {}", trace.mean(&form));
}

fn same(a: f64, b: f64, what: &str) {
    assert!((a / b - 1.0).abs() < 1e-9, "{what}: {a} {b}");
}

#[test]
fn neither_rotation_nor_repetition_nor_mirror_nor_units_change_a_lag() {
    for (name, segments) in &cycles() {
        for (load, mechanism) in loads().iter().filter(|(load, _)| *load != "arm") {
            let peak = |segments: &[SegmentSpec], taus: [f64; 2]| {
                under(mechanism, &motion(segments)).peak_of_lags(&two(taus)).value
            };
            for taus in [[60.0, 2400.0], [0.05, 3.0]] {
                let what = format!("{name}, {load}, {taus:?}");
                let base = peak(segments, taus);
                let mut rotated = segments.clone();
                rotated.rotate_left(1);
                // The position of the axis has no effect here.
                same(peak(&rotated, taus), base, &format!("{what}, rotated"));
                same(peak(&[segments.clone(), segments.clone(), segments.clone()].concat(), taus), base, &what);
                let trace = under(mechanism, &motion(segments));
                let thousand = two(taus).map(|lag| Lag { form: lag.form.scale(1e3), ..lag });
                same(1e-3 * trace.peak_of_lags(&thousand).value, base, &format!("{what}, units"));
            }
        }
    }
    // A mirrored arm: every angle and torque counted the other way.
    let mirrored = |segments: &[SegmentSpec]| -> Vec<SegmentSpec> {
        let turned = |segment: &SegmentSpec| match segment {
            SegmentSpec::Move(law, given) => {
                let back = |angle: Angle| Angle::from_si(-angle.si());
                SegmentSpec::Move(*law, motion::Given { distance: given.distance.map(back), ..*given })
            }
            other => other.clone(),
        };
        segments.iter().map(turned).collect()
    };
    let mut other = arm();
    if let mechanism::MechanismKind::Rotor(rotor) = &mut other.kind {
        rotor.tilt = Angle::from_si(-rotor.tilt.si());
    }
    let segments = &cycles()[1].1;
    let lags = two([8.0, 0.6]);
    let base = under(&arm(), &motion(segments)).peak_of_lags(&lags).value;
    same(under(&other, &motion(&mirrored(segments))).peak_of_lags(&lags).value, base, "mirror");
}

/// Straight speed and torque between the samples: u is a parabola in each part with one direction.
#[test]
fn lags_of_a_recording_agree_with_sums_over_its_intervals() {
    for (samples, steps) in [(50, 1_000), (3_000, 40), (12_000, 10)] {
        let fine = f64::from(steps);
        let motion = swing(samples);
        let trace = under(&direct(), &motion);
        for taus in [[60.0, 2400.0], [0.05, 3.0]] {
            let lags = two(taus);
            let nodes = trace.nodes();
            // Three nodes per part.
            let mut states = [0.0; 2];
            let round = |states: &mut [f64; 2]| {
                let mut best = f64::NEG_INFINITY;
                for part in nodes.chunks(3) {
                    let h = part.iter().map(|node| node.weight_s).sum::<f64>() / fine;
                    for k in 0..steps {
                        for (state, lag) in states.iter_mut().zip(&lags) {
                            let u = |s: f64| lag.form.at(&part[0].towards(&part[2], s));
                            let s = f64::from(k) / fine;
                            let (e, half) = ((-h / lag.tau_s).exp(), (-0.5 * h / lag.tau_s).exp());
                            *state = *state * e
                                + h / lag.tau_s / 6.0 * (u(s) * e + 4.0 * u(s + 0.5 / fine) * half + u(s + 1.0 / fine));
                        }
                        best = f64::max(best, states.iter().sum());
                    }
                }
                best
            };
            round(&mut states);
            for (state, lag) in states.iter_mut().zip(&lags) {
                *state /= 1.0 - (-motion.duration().si() / lag.tau_s).exp();
            }
            let expected = round(&mut states);
            let found = trace.peak_of_lags(&lags).value;
            let error = found / expected - 1.0;
            assert!(error.abs() < 1e-6 && error > -1e-9, "{samples}, {taus:?}: {found} {expected}");
        }
    }
}

/// One revolution represents a long rotation of an arm: sixty revolutions sampled one by one, and a chain of shorter
/// runs, give the same result.
#[test]
fn revolutions_at_constant_speed_stand_for_each_other() {
    let run = |revolutions: f64, speed: f64| {
        let given = motion::Given {
            distance: Some(Angle::from_si(revolutions * std::f64::consts::TAU)),
            speed: Some(quantities::AngularVelocity::from_si(speed)),
            ..motion::Given::default()
        };
        SegmentSpec::Move(Law::Constant, given)
    };
    // Runs of one and a half revolutions are not merged.
    let apart: Vec<SegmentSpec> = (0..40).map(|_| run(1.5, 9.0)).collect();
    let of = |segments: &[SegmentSpec]| under(&arm(), &motion(segments));
    let (once, each) = (of(&[run(60.0, 9.0)]), of(&apart));
    assert!(each.nodes().len() > 30 * once.nodes().len());
    for c in [[0.0, 1.0, 0.0, 0.0], [0.3, 0.9, 1.1, 0.4]] {
        same(once.gram.square(c), each.gram.square(c), "sum");
    }
    same(once.cubes(), each.cubes(), "cubes");
    for taus in [[8.0, 0.6], [60.0, 2400.0], [0.05, 3.0]] {
        let (a, b) = (once.peak_of_lags(&two(taus)), each.peak_of_lags(&two(taus)));
        same(a.value, b.value, &format!("lags {taus:?}"));
    }
    // Within a cycle that also rests: the lags rise from one revolution to the next.
    for taus in [[8.0, 0.6], [60.0, 2400.0], [0.05, 3.0]] {
        let ramp = |distance: f64, end: f64| {
            let given = motion::Given {
                distance: Some(Angle::from_si(distance)),
                speed: Some(quantities::AngularVelocity::from_si(9.0)),
                acceleration: Some(quantities::AngularAcceleration::from_si(40.0)),
                end_speed: Some(quantities::AngularVelocity::from_si(end)),
                ..motion::Given::default()
            };
            SegmentSpec::Move(Law::Trapezoid, given)
        };
        let turn = std::f64::consts::TAU;
        let cycle = |middle: Vec<SegmentSpec>| {
            let mut all = vec![ramp(turn, 9.0)];
            all.extend(middle);
            all.extend([ramp(turn, 0.0), dwell(30.0, Hold::Brake)]);
            of(&all).peak_of_lags(&two(taus)).value
        };
        same(cycle(vec![run(60.0, 9.0)]), cycle(apart.clone()), &format!("with rest, {taus:?}"));
    }
    // A million revolutions cost no more.
    assert!(of(&[run(1e6, 9.0)]).nodes().len() <= once.nodes().len() + 300);
}
