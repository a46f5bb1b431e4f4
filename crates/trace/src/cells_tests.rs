//! Tests of cells on a recording too long for its nodes to be stored, with so much noise that bounds over time are
//! useless: results of the cells against a plain loop over every interval.

use super::cubes::cubes_of_panel;
use super::tests::{arm, direct, lossless};
use super::*;
use mechanism::Plain;
use motion::{Closing, Recorded, Samples, SegmentSpec, Treatment};
use quantities::{Measure, ViscousFriction};
use std::f64::consts::PI;

/// Returns swings with a pause between them: 20 000 intervals, noise in speed and torque.
pub(crate) fn noisy(with_torque: bool) -> Motion {
    let count = 20_001_u32;
    let mut state = 7_u64;
    let mut noise = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    let time_s: Vec<f64> = (0..count).map(|k| 1e-3 * f64::from(k)).collect();
    let speed = |t: f64, noise: f64| {
        if (7.0..9.0).contains(&t) { 0.0 } else { 1.3 * (0.9 * t).sin() + 0.4 * (5.1 * t).sin() + 0.02 * noise }
    };
    let mut speeds: Vec<f64> = time_s.iter().map(|t| speed(*t, noise())).collect();
    (speeds[0], speeds[count as usize - 1]) = (0.0, 0.0);
    let torque: Vec<f64> = time_s.iter().map(|t| 6.0 * (1.7 * t).cos() + 2.0 * noise()).collect();
    let samples = Samples {
        time_s: time_s.into(),
        speed_rad_s: Some(speeds.into()),
        torque_nm: with_torque.then(|| torque.into()),
        position_rad: None,
    };
    let recorded = Recorded::new(samples, Treatment::default()).unwrap();
    Motion::new(&[SegmentSpec::Recorded(Arc::new(recorded))], None, Closing::SingleMove).unwrap()
}

fn cases() -> Vec<(&'static str, Mechanism, Motion)> {
    let mut viscous = direct();
    viscous.friction.viscous = ViscousFriction::from_si(3.0);
    vec![
        ("inertia and friction", direct(), noisy(false)),
        ("viscous", viscous.clone(), noisy(false)),
        ("torque besides", viscous, noisy(true)),
        ("arm", arm(), noisy(false)),
        ("lossless arm", lossless(), noisy(false)),
        ("lossless arm with torque", lossless(), noisy(true)),
    ]
}

fn close(found: f64, expected: f64, what: &str) {
    assert!((found - expected).abs() <= 1e-11 * expected.abs(), "{what}: {found} against {expected}");
}

#[test]
fn cells_hold_every_interval_once_and_add_up_to_the_whole() {
    for (what, mechanism, motion) in cases() {
        let trace = Trace::of(&mechanism, &motion, &[], &[]);
        let [strip] = trace.strips() else { panic!("{what}: not kept") };
        let root = strip.root().unwrap();
        fn leaves(strip: &Strip, cell: &Cell, seen: &mut Vec<f64>) {
            match cell.inside {
                Inside::Intervals(from, to) => {
                    let (extent, _) = strip.seen(cell);
                    strip.panels_within((from, to), &mut |panel| {
                        seen.push(panel.nodes[0].time_s);
                        for node in panel.nodes {
                            for weights in
                                [[1.0, 0.0, 0.0, 0.0], [0.4, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]
                            {
                                let (low, high) = extent.range(weights);
                                let value: f64 = weights.iter().zip(node.signals()).map(|(c, x)| c * x).sum();
                                let room = 1e-12 * (low.abs() + high.abs());
                                assert!(value >= low - room && value <= high + room, "{value} outside {low} to {high}");
                            }
                        }
                    });
                }
                Inside::Halves(halves) => {
                    strip.children(halves).into_iter().flatten().for_each(|half| leaves(strip, half, seen));
                }
            }
        }
        let mut seen = Vec::new();
        leaves(strip, root, &mut seen);
        seen.sort_by(f64::total_cmp);
        let mut expected = Vec::new();
        trace.blocks().iter().for_each(|block| trace.panels(block, &mut |panel| expected.push(panel.nodes[0].time_s)));
        assert_eq!(seen, expected, "{what}");
        for i in 0..4 {
            let mut weights = [0.0; 4];
            weights[i] = 1.0;
            let raw = strip.weights(weights);
            close(root.gram.square(raw) * strip.stretch(), trace.gram.square(weights), what);
        }
    }
}

#[test]
fn the_largest_values_are_those_of_a_plain_loop() {
    for (what, mechanism, motion) in cases() {
        let trace = Trace::of(&mechanism, &motion, &[], &[]);
        for own in [0.0, 0.5, 8.0] {
            let sought = TorqueWith { inertia_kgm2: own };
            let (largest, node) = trace.largest(&sought);
            let plain = trace.nodes().iter().map(|node| sought.value(node)).fold(0.0, f64::max);
            assert!(largest >= plain * (1.0 - 1e-12), "{what} {own}: {largest} below {plain}");
            assert!(largest <= plain * (1.0 + 1e-6), "{what} {own}: {largest} far above {plain}");
            close(sought.value(&node), largest, what);
            close(trace.largest_once(&sought).0, largest, what);
        }
        // Neither convex nor of one sign: the product of torque and speed.
        let power = Any(
            |extent: &Extent| {
                let (low, high) = extent.range([0.5, 1.0, 0.0, 0.0]);
                let (back, forth) = extent.speeds_rad_s;
                [low * back, low * forth, high * back, high * forth].into_iter().fold(f64::NEG_INFINITY, f64::max)
            },
            |node: &Node| (0.5 * node.acceleration_rad_s2 + node.load_nm) * node.speed_rad_s,
        );
        let (largest, _) = trace.largest(&power);
        let plain = trace.nodes().iter().map(|node| power.value(node)).fold(f64::NEG_INFINITY, f64::max);
        assert!(largest >= plain * (1.0 - 1e-12) && largest <= plain * 1.01, "{what}: {largest} against {plain}");
    }
}

/// Several straight intervals at a time against finely cut sums: torque with and without a zero, speed from rest and to
/// rest.
#[test]
fn cubes_of_ramps_by_brute_force() {
    let ramps = Ramps {
        duration_s: [0.5, 2.0, 1e-3, 0.7],
        acceleration_rad_s2: [0.0; 4],
        speed_rad_s: [[0.0, -3.0, 2.0, -1.0], [4.0, -1.0, 2.0, 0.0]],
        load_nm: [[5.0, -7.0, -1.0, 3.0], [9.0, 2.0, -1.0, -30.0]],
        direction: 1.0,
    };
    let mut expected = 0.0;
    for lane in 0..4 {
        let steps = 100_000;
        for k in 0..steps {
            let u = (f64::from(k) + 0.5) / f64::from(steps);
            let at = |ends: [[f64; 4]; 2]| ends[0][lane] + u * (ends[1][lane] - ends[0][lane]);
            let torque = at(ramps.load_nm);
            expected += (torque.powi(3) * at(ramps.speed_rad_s)).abs() * ramps.duration_s[lane] / f64::from(steps);
        }
    }
    let found = crate::cubes::cubes_of_ramps(&ramps);
    assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
    let empty = Ramps { duration_s: [0.0; 4], ..Ramps::default() };
    assert_eq!(crate::cubes::cubes_of_ramps(&empty), 0.0);
}

#[test]
fn the_cubes_are_those_of_a_plain_loop() {
    for (what, mechanism, motion) in cases() {
        let trace = Trace::of(&mechanism, &motion, &[], &[]);
        let mut plain = 0.0;
        trace.blocks().iter().for_each(|block| trace.panels(block, &mut |panel| plain += cubes_of_panel(&panel)));
        assert!((trace.cubes() / plain - 1.0).abs() < 1e-9, "{what}: {} against {plain}", trace.cubes());
    }
}

/// The views of one survey, as created by the search for reserves, agree with surveys of their own.
#[test]
fn another_load_and_another_pace_are_seen_as_if_surveyed_anew() {
    let (positions, torques) = (noisy(false), noisy(true));
    for (load, motion, is_factor) in [
        (direct(), &torques, true),
        (lossless(), &positions, true),
        // The recorded torque stays when the load is another one.
        (lossless(), &torques, false),
    ] {
        let base = Trace::of(&load, motion, &[], &[]);
        let _ = base.largest(&TorqueWith { inertia_kgm2: 0.5 });
        let heavier = base.changed(&load.with_masses(3.0), motion, &[], &[]);
        seen_as_anew(&heavier, &Trace::of(&load.with_masses(3.0), motion, &[], &[]));
        let faster = base.changed(&load, &motion.stretched(0.7), &[], &[]);
        seen_as_anew(&faster, &Trace::of(&load, &motion.stretched(0.7), &[], &[]));
        let survey = |trace: &Trace| trace.strips().first().map(Strip::survey_address);
        assert_eq!([survey(&heavier) == survey(&base), survey(&faster) == survey(&base)], [is_factor, true]);
    }
}

/// The survey of a balanced rotor does not serve an unbalanced one, nor the reverse.
#[test]
fn a_weight_that_was_not_there_is_surveyed() {
    let motion = noisy(true);
    let base = Trace::of(&lossless(), &motion, &[], &[]);
    for other in [direct(), lossless().with_masses(0.0)] {
        seen_as_anew(&base.changed(&other, &motion, &[], &[]), &Trace::of(&other, &motion, &[], &[]));
    }
    let base = Trace::of(&direct(), &motion, &[], &[]);
    seen_as_anew(&base.changed(&lossless(), &motion, &[], &[]), &Trace::of(&lossless(), &motion, &[], &[]));
}

/// The view of an arm shows the torque of the arm at every instant.
#[test]
fn the_view_of_an_arm_is_what_it_asks_for() {
    let mut load = lossless();
    load.friction.viscous = ViscousFriction::from_si(3.0);
    for (motion, stretch) in [(noisy(true), 1.0), (noisy(false), 0.7), (noisy(true), 1.9)] {
        let motion = motion.stretched(stretch);
        let trace = Trace::of(&load, &motion, &[], &[]);
        let [strip] = trace.strips() else { panic!("not kept") };
        let placed = &motion.recordings()[0];
        let mut seen = 0;
        for index in 0..strip.intervals() {
            let interval = placed.interval(index).unwrap();
            strip.interval(index, &mut |panel| {
                for node in panel.nodes {
                    let share = (node.time_s - interval.start_s) / interval.duration_s;
                    let (position_rad, speed_rad_s, torque) = interval.at(share);
                    let output = mechanism::Output {
                        position_rad,
                        speed_rad_s,
                        acceleration_rad_s2: interval.acceleration_rad_s2(),
                        direction: node.direction,
                    };
                    let extra = Extra { torque: Torque::from_si(torque), ..Extra::none() };
                    let asked = load.torque(&output, &extra);
                    assert!((node.load_nm - asked).abs() < 1e-9 * (1.0 + asked.abs()), "{} {asked}", node.load_nm);
                    seen += 1;
                }
            });
        }
        assert!(seen > 60_000, "{seen}");
        let holding =
            placed.recorded.position_rad().iter().map(|q| load.holding_torque(q + placed.offset_rad, &Extra::none()));
        let holding = holding.map(|torque| torque.si().abs()).fold(0.0, f64::max);
        close(trace.holding().si(), holding, "holding");
    }
}

fn seen_as_anew(changed: &Trace, anew: &Trace) {
    for own in [0.0, 0.5] {
        let sought = TorqueWith { inertia_kgm2: own };
        close(changed.largest(&sought).0, anew.largest(&sought).0, "peak");
    }
    close(changed.holding().si(), anew.holding().si(), "holding");
    close(changed.cubes(), anew.cubes(), "cubes");
    for weights in [[0.3, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.2]] {
        close(changed.gram.square(weights), anew.gram.square(weights), "sums");
    }
    let lag = |tau_s: f64| Lag { tau_s, form: Form::square([0.2, 0.5, 0.1, 0.3]) };
    let (a, b) = (changed.peak_of_lags(&[lag(3.0), lag(900.0)]), anew.peak_of_lags(&[lag(3.0), lag(900.0)]));
    assert!((a.value / b.value - 1.0).abs() < 1e-9, "{} {}", a.value, b.value);
}

/// Two lags, one short and one long against the blocks, agree with the exact step of a parabola over every interval.
#[test]
fn lags_are_those_of_a_plain_loop() {
    for (what, mechanism, motion) in cases() {
        let trace = Trace::of(&mechanism, &motion, &[], &[]);
        for taus in [[2.0, 60.0], [40.0, 3_000.0], [0.3, 5.0]] {
            let forms = [Form::square([0.2, 0.5, 0.1, 0.3]), Form::product([0.0, 0.0, 0.5, 0.4], [0.0, 0.0, 0.0, 1.0])];
            let lags = [0, 1].map(|k| Lag { tau_s: taus[k], form: forms[k] });
            let found = trace.peak_of_lags(&lags).value;
            let mut largest = 0.0_f64;
            // The first pass finds the initial state of the cycle, the second the largest value.
            let mut starts = [0.0; 2];
            for pass in 0..2 {
                let mut states = starts;
                trace.blocks().iter().for_each(|block| {
                    trace.panels(block, &mut |panel| {
                        for (state, lag) in states.iter_mut().zip(&lags) {
                            let (lambda, n) = (panel.duration_s / lag.tau_s, panel.nodes.len());
                            let weights = rule::rule(n).weights(lambda);
                            let gain: f64 =
                                panel.nodes.iter().zip(weights).map(|(node, w)| w * lag.form.at(node)).sum();
                            *state = *state * (-lambda).exp() + gain;
                        }
                        if pass == 1 {
                            largest = largest.max(states.iter().sum());
                        }
                    });
                });
                if pass == 0 {
                    for ((start, state), lag) in starts.iter_mut().zip(states).zip(&lags) {
                        *start = state / -(-trace.duration / lag.tau_s).exp_m1();
                    }
                    largest = starts.iter().sum();
                }
            }
            assert!(found >= largest * (1.0 - 1e-9), "{what} {taus:?}: {found} below {largest}");
            assert!(found <= largest * (1.0 + 1e-6), "{what} {taus:?}: {found} above {largest}");
        }
    }
}

/// The moments for the cube agree with the rule with five nodes, for both forms of the intervals.
#[test]
fn moments_of_straight_intervals_by_two_ways() {
    let motion = noisy(false);
    let mechanism = direct();
    let plain: Plain = mechanism.plain(&Extra::none()).unwrap();
    let placed = &motion.recordings()[0];
    for index in [10, 5_000, 12_345] {
        let interval = placed.interval(index).unwrap();
        let [w0, w1] = interval.speed_rad_s;
        if w0 * w1 <= 0.0 {
            continue;
        }
        let node = |speed: f64| Node {
            acceleration_rad_s2: interval.acceleration_rad_s2(),
            load_nm: plain.constant_nm + 2.5,
            speed_rad_s: speed,
            ..Node::default()
        };
        let nodes = [node(w0), node(0.5 * (w0 + w1)), node(w1)];
        let panel = Panel::passing(&nodes, interval.duration_s, [0.0; 4]);
        let (mut by_nodes, mut closed) = ([0.0; 20], [0.0; 20]);
        cubes::add(&mut by_nodes, &panel);
        cubes::add_interval(&mut closed, plain.constant_nm + 2.5, &interval);
        for (a, b) in by_nodes.iter().zip(closed) {
            assert!((a - b).abs() <= 1e-12 * a.abs(), "{index}: {a} {b}");
        }
    }
}

/// Returns ten slow swings, each from rest to rest at a sample: 16 000 intervals.
fn from_rest() -> Motion {
    let time_s: Vec<f64> = (0..16_001).map(|k| 1e-3 * f64::from(k)).collect();
    let speeds: Vec<f64> =
        (0..16_001_u32).map(|k| if k % 800 == 0 { 0.0 } else { (PI * f64::from(k) / 800.0).sin() }).collect();
    let torque: Vec<f64> = (0..16_001_u32).map(|k| f64::from(k * 7919 % 1009) / 500.0 - 1.0).collect();
    let samples = Samples {
        time_s: time_s.into(),
        speed_rad_s: Some(speeds.into()),
        torque_nm: Some(torque.into()),
        position_rad: None,
    };
    let recorded = Recorded::new(samples, Treatment::default()).unwrap();
    Motion::new(&[SegmentSpec::Recorded(Arc::new(recorded))], None, Closing::SingleMove).unwrap()
}

/// Several intervals at a time have the integrals of their panels, block by block, and most intervals are processed so.
#[test]
fn a_sweep_has_the_integrals_of_the_panels() {
    let rest = [("from rest", direct()), ("arm from rest", lossless()), ("arm with losses", arm())]
        .map(|(what, load)| (what, load, from_rest()));
    let mut viscous = lossless();
    viscous.friction.viscous = ViscousFriction::from_si(3.0);
    let slower = ("lossless arm, slower", viscous, noisy(true).stretched(1.3));
    let noise = cases().into_iter().chain([("arm with torque", arm(), noisy(true)), slower]);
    for (what, mechanism, motion) in noise.chain(rest) {
        let trace = Trace::of(&mechanism, &motion, &[], &[]);
        let [strip] = trace.strips() else { panic!("{what}: not kept") };
        let mut ramps = 0;
        for block in trace.blocks() {
            let (mut swept, mut expected) = ([0.0; 5], [0.0; 5]);
            let add = |sums: &mut [f64; 5], panel: &Panel<'_>| {
                for node in panel.nodes {
                    let [_, load, direction, speed] = node.signals();
                    let values = [1.0, load, speed * load, direction * load, load * load];
                    sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += node.weight_s * value);
                }
            };
            strip.panels(block, &mut |panel| add(&mut expected, &panel));
            strip.sweep(block, &mut |passed| match passed {
                Swept::Panel(panel) => add(&mut swept, &panel),
                Swept::Ramps(many) => many.iter().for_each(|four| {
                    ramps += four.duration_s.iter().filter(|duration| **duration > 0.0).count();
                    for lane in 0..4 {
                        for (share, weight) in [(0.0, 1.0 / 6.0), (0.5, 4.0 / 6.0), (1.0, 1.0 / 6.0)] {
                            let at = |ends: [[f64; 4]; 2]| ends[0][lane] + share * (ends[1][lane] - ends[0][lane]);
                            let (load, speed) = (at(four.load_nm), at(four.speed_rad_s));
                            let values = [1.0, load, speed * load, four.direction * load, load * load];
                            let weight = weight * four.duration_s[lane];
                            swept.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value);
                        }
                    }
                }),
            });
            let most = f64::max(block.extent.load_nm.1, -block.extent.load_nm.0);
            let scale = block.duration_s * (1.0 + most) * (1.0 + most);
            for (swept, expected) in swept.iter().zip(expected) {
                assert!(
                    (swept - expected).abs() <= 1e-12 * scale,
                    "{what}: {swept} against {expected} at {}",
                    block.from_s
                );
            }
        }
        assert!(ramps * 10 > strip.intervals() * 8, "{what}: {ramps}");
    }
}
