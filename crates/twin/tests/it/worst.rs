//! Ways beyond the ends of a motion, long cycles and the limit of the search for the worst instant.

use super::{NOTHING, load, parameters};
use mechanism::{Extra, Mechanism};
use motion::{Closing, Given, Hold, Law, Motion, SegmentSpec};
use quantities::{Angle, Measure, Time};
use twin::{
    MotionDirection, Parameters, Reaction, Scenario, ScenarioId, Setup, Twin, WorstInstant, search_periods,
    worst_instant,
};

const CODE: &str = "CHA-25A-50-H-C1024-B";

/// Returns moves and rests of distances \[rad\] and times \[s\].
fn moves(all: &[(f64, f64)]) -> Motion {
    let of = |&(distance, time): &(f64, f64)| {
        let (distance, time) = (Angle::from_si(distance), Time::from_si(time));
        if distance.si() == 0.0 {
            SegmentSpec::Dwell(time, Hold::Motor)
        } else {
            let given = Given { distance: Some(distance), time: Some(time), ..Given::default() };
            SegmentSpec::Move(Law::ModifiedSine, given)
        }
    };
    let closing = if all.iter().map(|(distance, _)| distance).sum::<f64>().abs() < 1e-9 {
        Closing::Position
    } else {
        Closing::SingleMove
    };
    Motion::new(&all.iter().map(of).collect::<Vec<_>>(), None, closing).unwrap()
}

struct Axis {
    parameters: Parameters,
    mechanism: Mechanism,
    motion: Motion,
    extras: Vec<Extra>,
}

impl Axis {
    fn of(motion: Motion) -> Self {
        Self { parameters: parameters(CODE), mechanism: load(1.2, 2.0), motion, extras: NOTHING() }
    }

    fn setup(&self, scenario: Scenario) -> Setup<'_> {
        Setup { scenario, ..Setup::of(&self.parameters, &self.mechanism, &self.motion, &self.extras) }
    }

    fn searched(&self, scenario: Scenario, periods_most: Option<u64>) -> WorstInstant {
        worst_instant(&self.setup(scenario), periods_most, || true).unwrap().unwrap()
    }

    /// Returns the lowest and the highest position from an event until the end of the run \[rad\].
    fn reached(&self, scenario: Scenario, at_s: f64) -> [f64; 2] {
        let mut twin = Twin::new(&self.setup(Scenario { at_s: Some(at_s), ..scenario })).unwrap();
        let mut reached = [f64::INFINITY, f64::NEG_INFINITY];
        while !twin.is_over() {
            twin.advance(8);
            let sample = twin.sample();
            if sample.time_s >= at_s {
                reached = [reached[0].min(sample.position_rad), reached[1].max(sample.position_rad)];
            }
        }
        reached
    }
}

/// Compares the stated ways beyond the ends, zero and `upper`, with runs from a grid over the cycle.
fn compared(axis: &Axis, long_s: f64, upper: f64) {
    let count = 60;
    for scenario in failures() {
        let found = axis.searched(scenario, None);
        assert!(!found.is_cut && found.examined <= twin::INSTANTS_MOST);
        let stated = |end: MotionDirection| found.overruns.iter().find(|each| each.end == end);
        for place in 0..count {
            let [lowest, highest] = axis.reached(scenario, long_s * (f64::from(place) + 0.5) / f64::from(count));
            for (end, beyond) in [(MotionDirection::Positive, highest - upper), (MotionDirection::Negative, -lowest)] {
                // A way below a thousandth of the range is not stated.
                let most = stated(end).map_or(0.001 * upper, |each| each.beyond_rad);
                assert!(beyond <= 1.01 * most + 3e-4, "{scenario:?} {end:?} {beyond} {found:?}");
            }
        }
        for each in &found.overruns {
            let [lowest, highest] = axis.reached(scenario, each.at_s);
            let beyond = if each.end == MotionDirection::Positive { highest - upper } else { -lowest };
            assert!((beyond - each.beyond_rad).abs() < 1e-6, "{beyond} {each:?}");
        }
    }
}

fn failures() -> [Scenario; 3] {
    let stop = |reaction| Scenario { id: ScenarioId::EmergencyStop, reaction, ..Scenario::default() };
    let failure = Scenario { id: ScenarioId::PowerFailure, ..Scenario::default() };
    [failure, stop(Reaction::Ramp), stop(Reaction::Brake)]
}

/// No instant of a grid leads farther beyond an end than the stated one, which a run from it reaches; a motion that does
/// not return has no ends.
#[test]
fn no_event_leads_farther_beyond_an_end_than_the_stated_one() {
    let stroke = [(1.5, 0.6), (0.0, 0.3), (-0.4, 0.4), (-1.1, 0.5), (0.0, 0.3)];
    // Slow: at the end of the travel the way beyond it depends on the last tenths.
    let slow = [(2.5, 2.8), (0.0, 0.5), (-2.5, 2.8), (0.0, 0.5)];
    for (there, long_s, upper) in [(&stroke[..], 2.1, 1.5), (&slow[..], 6.6, 2.5)] {
        compared(&Axis::of(moves(there)), long_s, upper);
    }
    let axis = Axis::of(moves(&stroke));
    // The brake closes after the end of the way that is left.
    let failure = axis.searched(failures()[0], None);
    assert_eq!(failure.overruns.len(), 2, "{failure:?}");
    assert!(failure.overruns.iter().all(|each| each.beyond_rad > 0.01 && each.rests), "{failure:?}");
    let onwards = Axis::of(moves(&[(1.5, 0.6), (0.0, 0.3)]));
    assert_eq!(onwards.searched(failures()[0], None).overruns, []);
}

/// A long rest changes neither the ways after an event nor their instants, though each instant has its own run-up then.
#[test]
fn a_long_cycle_has_the_ways_of_a_short_one() {
    let moving = [(1.5, 0.6), (0.0, 0.3), (-1.5, 0.7)];
    let of = |rest_s: f64| Axis::of(moves(&[&moving[..], &[(0.0, rest_s)]].concat()));
    let (short, long) = (of(0.5), of(400.0));
    for scenario in failures() {
        let [one, other] = [&short, &long].map(|axis| axis.searched(scenario, None));
        for (a, b) in one.directions.iter().zip(&other.directions) {
            assert_eq!(a.direction, b.direction, "{scenario:?}");
            assert!((a.value - b.value).abs() < 0.005 * a.value + 1e-4, "{scenario:?} {a:?} {b:?}");
        }
        for (a, b) in one.overruns.iter().zip(&other.overruns) {
            assert!(a.end == b.end && (a.beyond_rad - b.beyond_rad).abs() < 0.01 * a.beyond_rad + 3e-4, "{a:?} {b:?}");
        }
        assert_eq!(one.overruns.len(), other.overruns.len());
    }
}

/// A search with few periods examines few instants and says so, and begins with the largest properties: what it finds is
/// near the worst.
#[test]
fn a_search_ends_before_its_largest_number_of_periods() {
    for rest_s in [0.5, 400.0] {
        let axis = Axis::of(moves(&[(1.5, 0.6), (0.0, 0.3), (-0.7, 0.4), (-0.8, 0.5), (0.0, rest_s)]));
        let cycle = ((1.8 + rest_s) * twin::CURRENT_RATE_HZ) as u64;
        let [least, most] = search_periods(cycle);
        let scenario = failures()[0];
        let whole = axis.searched(scenario, Some(most));
        assert!(!whole.is_cut && whole == axis.searched(scenario, None));
        // The periods of a quarter of the fewest instants.
        let reached = if rest_s < 100.0 { cycle } else { 0 };
        let cut = axis.searched(scenario, Some(reached + (least - reached) / 4));
        assert!(cut.is_cut && (4..whole.examined).contains(&cut.examined), "{rest_s} {cut:?} {whole:?}");
        assert!(cut.directions[0].value > 0.95 * whole.directions[0].value, "{cut:?} {whole:?}");
    }
}
