//! Tests of a long recording that recurs in the cycle: it is searched once, and the results are those of a search of
//! every recurrence.

use super::tests::{arm, direct};
use super::*;
use motion::{Closing, Law, Recorded, Samples, SegmentSpec, Treatment};
use std::cell::Cell as Counter;
use std::f64::consts::PI;

/// Returns a swing of 1.4 rad that returns to its start: 3000 intervals of 2 ms, with a rough torque.
fn swing() -> Arc<Recorded> {
    let count = 3001_u32;
    let phase = |k: u32| 2.0 * PI * f64::from(k) / f64::from(count - 1);
    let samples = Samples {
        time_s: (0..count).map(|k| 2e-3 * f64::from(k)).collect::<Vec<_>>().into(),
        position_rad: Some((0..count).map(|k| 0.7 * (1.0 - phase(k).cos())).collect::<Vec<_>>().into()),
        torque_nm: Some(
            (0..count)
                .map(|k| 3.0 * (7.0 * phase(k)).sin() + f64::from(k * 7919 % 101) / 101.0)
                .collect::<Vec<_>>()
                .into(),
        ),
        speed_rad_s: None,
    };
    Arc::new(Recorded::new(samples, Treatment::default()).unwrap())
}

/// Returns the swing so many times, with a pause after the second.
fn recurring(times: usize) -> Motion {
    let swing = swing();
    let mut segments: Vec<SegmentSpec> = (0..times).map(|_| SegmentSpec::Recorded(Arc::clone(&swing))).collect();
    segments.insert(2, SegmentSpec::Dwell(quantities::Measure::from_si(1.5), motion::Hold::default()));
    Motion::new(&segments, None, Closing::Position).unwrap()
}

/// Returns a copy of the trace in which every recurrence counts as another recording.
fn unmarked(trace: &Trace) -> Trace {
    let mut plain = trace.clone();
    plain.strips.iter_mut().enumerate().for_each(|(index, strip)| strip.first = index);
    plain
}

#[test]
fn a_recurrence_is_known_and_changes_no_result() {
    for (what, mechanism) in [("plain", direct()), ("arm", arm())] {
        let trace = Trace::of(&mechanism, &recurring(5), &[], &[]);
        let firsts: Vec<usize> = trace.strips().iter().map(|strip| strip.first).collect();
        assert_eq!(firsts, [0; 5], "{what}");
        let plain = unmarked(&trace);
        for inertia_kgm2 in [0.0, 0.6, 4.0] {
            let ((a, at), (b, of)) =
                (trace.largest(&TorqueWith { inertia_kgm2 }), plain.largest(&TorqueWith { inertia_kgm2 }));
            assert_eq!((a, at.time_s), (b, of.time_s), "{what}, torque with {inertia_kgm2} kgm²");
        }
        let form = Form::square([0.3, 0.9, 1.1, 0.4]);
        for taus in [[8.0, 0.6], [60.0, 2400.0], [0.05, 3.0]] {
            let lags = taus.map(|tau_s| Lag { tau_s, form });
            let (a, b) = (trace.peak_of_lags(&lags), plain.peak_of_lags(&lags));
            assert!((a.value - b.value).abs() <= 2e-10 * b.value, "{what}, lags of {taus:?} s: {a:?} {b:?}");
        }
    }
}

/// The swing behind a move of its own lies elsewhere: an arm has another torque there, a load without a weight has not.
#[test]
fn at_another_position_it_recurs_only_for_a_load_that_does_not_depend_on_it() {
    let swing = swing();
    let aside = super::tests::law(Law::ModifiedSine, 0.4, 0.6);
    let of = |recorded: &Arc<Recorded>| SegmentSpec::Recorded(Arc::clone(recorded));
    let speeds = Samples {
        time_s: swing.time_s().to_vec().into(),
        speed_rad_s: Some(swing.speed_rad_s().to_vec().into()),
        position_rad: None,
        torque_nm: None,
    };
    let recorded = Arc::new(Recorded::new(speeds, Treatment::default()).unwrap());
    let segments: Vec<SegmentSpec> = (0..4).flat_map(|_| [of(&recorded), aside.clone()]).collect();
    let motion = Motion::new(&segments, None, Closing::SingleMove).unwrap();
    for (what, mechanism, is_like) in [("plain", direct(), true), ("arm", arm(), false)] {
        let trace = Trace::of(&mechanism, &motion, &[], &[]);
        let firsts: Vec<usize> = trace.strips().iter().map(|strip| strip.first).collect();
        assert_eq!(firsts, if is_like { [0; 4] } else { [0, 1, 2, 3] }, "{what}");
        for inertia_kgm2 in [0.0, 2.0] {
            let sought = TorqueWith { inertia_kgm2 };
            let (found, all) = (trace.largest(&sought).0, unmarked(&trace).largest(&sought).0);
            assert!((found - all).abs() <= 1e-12 * all, "{what}: {found} {all}");
        }
    }
}

#[test]
fn five_recurrences_cost_no_more_than_one_search() {
    let evaluations = |trace: &Trace| {
        let count = Counter::new(0_usize);
        let value = |node: &Node| {
            count.set(count.get() + 1);
            (node.acceleration_rad_s2 + node.load_nm).abs()
        };
        // A bound that excludes nothing: every interval that is not known already is evaluated.
        let _ = trace.largest(&Any(|_: &Extent| f64::INFINITY, value));
        count.get()
    };
    let trace = Trace::of(&arm(), &recurring(5), &[], &[]);
    let (once, all) = (evaluations(&trace), evaluations(&unmarked(&trace)));
    assert!(once * 4 < all, "{once} evaluations, {all} for every recurrence");
}
