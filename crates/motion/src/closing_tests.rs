use super::*;
use crate::{Recorded, Samples, Treatment};

/// Reproducible uniform random numbers.
struct Random(u64);

impl Random {
    fn within(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }
}

const LAWS: [Law; 7] = [
    Law::Trapezoid,
    Law::Triangle,
    Law::Polynomial5,
    Law::ModifiedSine,
    Law::ModifiedTrapezoid,
    Law::SimpleSine,
    Law::InclinedSine,
];

/// Returns some moves and one back to their start, with dwells between some of them and none at either end.
fn there_and_back(random: &mut Random, case: usize) -> Motion {
    let moves = 1 + case % 3;
    let mut segments = Vec::new();
    let mut away = 0.0;
    for index in 0..=moves {
        let distance = if index == moves { -away } else { random.within(0.1, 2.0) };
        away += distance;
        let given = Given {
            distance: Some(Angle::from_si(distance)),
            time: Some(Time::from_si(distance.abs() * random.within(0.8, 1.2))),
            ..Given::default()
        };
        segments.push(SegmentSpec::Move(LAWS[(random.within(0.0, 7.0)) as usize], given));
        if index < moves && random.within(0.0, 1.0) < 0.5 {
            segments.push(SegmentSpec::Dwell(Time::from_si(random.within(0.1, 1.0)), Hold::Motor));
        }
    }
    Motion::new(&segments, Some(Angle::from_si(0.4)), Closing::Position).unwrap()
}

fn state(motion: &Motion, t: f64) -> crate::State {
    let piece = motion.pieces().iter().rfind(|piece| piece.start_s <= t).unwrap();
    piece.at((t - piece.start_s).min(piece.duration_s))
}

/// Samples the exact positions between two instants in equal steps.
fn sample(motion: &Motion, (from, to): (f64, f64), steps: u32, smoothing: Option<f64>) -> SegmentSpec {
    let time_s: Vec<f64> = (0..=steps).map(|k| (to - from) * f64::from(k) / f64::from(steps)).collect();
    let position_rad = Some(Arc::new(time_s.iter().map(|t| state(motion, from + t).position_rad).collect()));
    let samples = Samples { time_s: time_s.into(), position_rad, ..Samples::default() };
    let treatment = Treatment { smoothing: smoothing.map(Time::from_si), ..Treatment::default() };
    SegmentSpec::Recorded(Arc::new(Recorded::new(samples, treatment).unwrap()))
}

#[test]
fn exact_recordings_from_rest_to_rest_close() {
    let mut random = Random(3);
    for case in 0..1_500 {
        let motion = there_and_back(&mut random, case);
        let whole = (0.0, motion.duration().si());
        // Fifty to five thousand samples per cycle, at least twenty per move.
        let shortest = motion.stretches().iter().filter(|each| each.solved.is_some());
        let shortest = shortest.map(|each| each.duration.si()).fold(f64::INFINITY, f64::min);
        // Smoothing over seven samples would distort a move of twenty so that it no longer begins at rest.
        let smooth = case % 5 == 0;
        let least = (if smooth { 80.0 } else { 20.0 } * whole.1 / shortest).max(50.0);
        let steps = least * (5000.0_f64.max(least) / least).powf(random.within(0.0, 1.0));
        let steps = steps.round() as u32;
        let smoothing = smooth.then(|| 6.5 * whole.1 / f64::from(steps));
        let recorded = sample(&motion, whole, steps, smoothing);
        let closed = Motion::new(std::slice::from_ref(&recorded), None, Closing::Position);
        assert!(closed.is_ok(), "{case}: {steps} samples: {:?} {:?}", closed.unwrap_err(), motion.stretches());
        let dwell = SegmentSpec::Dwell(Time::from_si(0.5), Hold::Motor);
        let between = Motion::new(&[dwell.clone(), recorded, dwell], Some(Angle::from_si(0.4)), Closing::Position);
        assert!(between.is_ok(), "{case}: {steps} samples between rests: {:?}", between.unwrap_err());
    }
}

/// A part cut out of a cycle ends at another speed or position than it began with.
#[test]
fn recordings_that_do_not_close_are_refused() {
    let mut random = Random(5);
    let mut refused = 0;
    for case in 0..3_000 {
        let motion = there_and_back(&mut random, case);
        let duration = motion.duration().si();
        let (from, to) = (random.within(0.0, 0.4) * duration, random.within(0.6, 1.0) * duration);
        let steps = random.within(50.0, 2000.0) as u32;
        let recorded = sample(&motion, (from, to), steps, None);
        let SegmentSpec::Recorded(samples) = &recorded else { return };
        let fastest = samples.speed_rad_s().iter().fold(0.0_f64, |most, w| most.max(w.abs()));
        let apart = (state(&motion, from).speed_rad_s - state(&motion, to).speed_rad_s).abs();
        // With few samples the slope of the recording differs from that of the motion at the start of a move.
        if fastest == 0.0 || apart < 0.2 * fastest {
            continue;
        }
        refused += 1;
        let fault = Motion::new(&[recorded], None, Closing::Speed).err().map(|faults| faults[0].fault);
        assert!(
            matches!(fault, Some(MoveFault::SpeedNotClosed { .. })),
            "{case}: {apart} of {fastest}, {steps} samples"
        );
    }
    assert!(refused > 1_000, "{refused}");
}

/// Equal samples at an end mean that the motion is at rest there, not reversing.
#[test]
fn equal_samples_at_an_end_are_rest() {
    let time_s: Vec<f64> = (0..8).map(f64::from).collect();
    let position_rad = Some(vec![0.0, 0.0, 1.0, 3.0, 5.0, 6.0, 7.0, 7.0].into());
    let samples = Samples { time_s: time_s.into(), position_rad, ..Samples::default() };
    let recorded = Recorded::new(samples, Treatment::default()).unwrap();
    assert_eq!(recorded.end_speeds_rad_s(), (0.0, 0.0));
    assert_eq!(recorded.speed_rad_s()[1], 0.5);
}

/// The ends of a recorded swing differ by the noise of its samples, by what smoothing does to them, or by a small drift.
#[test]
fn a_recorded_swing_ends_where_it_starts() {
    let mut random = Random(7);
    for case in 0..300 {
        let motion = there_and_back(&mut random, case);
        let whole = (0.0, motion.duration().si());
        let states = motion.pieces().iter().map(|piece| piece.position_rad);
        let (low, high) = states.fold((f64::MAX, f64::MIN), |(low, high), q| (low.min(q), high.max(q)));
        let range = Angle::from_si(high - low);
        let smoothing = (case % 2 == 0).then(|| 20.0 * whole.1 / 2000.0);
        let SegmentSpec::Recorded(exact) = sample(&motion, whole, 2000, smoothing) else { return };
        let moved = |drift: f64, noise: f64, random: &mut Random| {
            let last = exact.position_rad().len() as f64 - 1.0;
            let along = exact.position_rad().iter().enumerate().map(|(k, q)| q + drift * k as f64 / last);
            let position: Vec<f64> = along.map(|q| q + random.within(-noise, noise)).collect();
            let samples = Samples {
                time_s: Arc::new(exact.time_s().to_vec()),
                position_rad: Some(Arc::new(position)),
                ..Samples::default()
            };
            let recorded = Recorded::new(samples, Treatment::default()).unwrap();
            Motion::new(&[SegmentSpec::Recorded(Arc::new(recorded))], None, Closing::SingleMove).unwrap()
        };
        let travelled = Angle::from_si(motion.pieces().len() as f64 * range.si());
        let noise = 4e-4 * range.si();
        assert!(moved(0.0, noise, &mut random).ends_where_it_starts(travelled, range), "{case}: noise");
        assert!(
            moved(2e-4 * range.si(), noise / 2.0, &mut random).ends_where_it_starts(travelled, range),
            "{case}: drift"
        );
        for share in [0.01, -0.05, 1.0] {
            let away = moved(share * range.si(), noise, &mut random);
            assert!(!away.ends_where_it_starts(travelled, range), "{case}: {share} of the range");
        }
        // Laws have no noise: what they do not return is a rotation.
        assert!(motion.ends_where_it_starts(travelled, range), "{case}");
    }
}

/// A cycle that repeats, recorded with noise: over its seam the smoothed speed errs as little as inside, and is the same
/// at both ends.
#[test]
fn a_cycle_is_smoothed_over_its_seam() {
    let (mut random, mut sums) = (Random(11), [0.0; 2]);
    for case in 0..60 {
        let (period, count) = (random.within(0.5, 4.0), 2000_u32);
        // With one turn it would be at rest for an instant.
        let (shift, turns) = (random.within(0.0, 6.0), [0.0, 2.0, 3.0][case % 3]);
        // Also a motion that turns further with each cycle.
        let course = |t: f64| {
            let x = std::f64::consts::TAU * t / period;
            let rate = std::f64::consts::TAU / period;
            [(x + shift).sin() + turns * x, rate * ((x + shift).cos() + turns)]
        };
        let time_s: Vec<f64> = (0..=count).map(|k| period * f64::from(k) / f64::from(count)).collect();
        let noise: Vec<f64> = time_s.iter().map(|_| random.within(-1e-3, 1e-3)).collect();
        let position: Vec<f64> = time_s.iter().zip(&noise).map(|(t, e)| course(*t)[0] + e).collect();
        let speed: Vec<f64> = time_s.iter().zip(&noise).map(|(t, e)| course(*t)[1] + e * 20.0).collect();
        for (position_rad, speed_rad_s) in [(Some(position), None), (None, Some(speed))] {
            let samples = Samples {
                time_s: time_s.clone().into(),
                position_rad: position_rad.map(Arc::new),
                speed_rad_s: speed_rad_s.map(Arc::new),
                torque_nm: None,
            };
            let smoothing = Some(Time::from_si(period * 40.5 / f64::from(count)));
            let errors = |repeats: bool| {
                let treatment = Treatment { smoothing, repeats, ..Treatment::default() };
                let found = Recorded::new(samples.clone(), treatment).unwrap();
                let of = |place: usize| (found.speed_rad_s()[place] - course(time_s[place])[1]).abs();
                let last = count as usize;
                let ends = (0..20).chain(last - 20..=last).map(of).fold(0.0, f64::max);
                let inside = (40..last - 40).map(of).fold(0.0, f64::max);
                let (first, end) = found.end_speeds_rad_s();
                (ends, inside, (first - end).abs())
            };
            let (closed, inside, apart) = errors(true);
            assert!(closed < 2.0 * inside && apart < 1e-6 * inside, "{case}: {closed} {inside} {apart}");
            sums = [sums[0] + closed, sums[1] + errors(false).0];
        }
    }
    assert!(sums[1] > 2.0 * sums[0], "{sums:?}");
}

/// Ends that move differently are no cycle: the window ends there, as without a repetition.
#[test]
fn a_motion_that_does_not_close_is_not_smoothed_over_its_ends() {
    let time_s: Vec<f64> = (0..=500).map(|k| 2e-3 * f64::from(k)).collect();
    let position: Vec<f64> = time_s.iter().map(|t| 3.0 * t * t).collect();
    let of = |repeats: bool| {
        let samples = Samples {
            time_s: time_s.clone().into(),
            position_rad: Some(Arc::new(position.clone())),
            ..Samples::default()
        };
        let treatment = Treatment { smoothing: Some(Time::from_si(0.05)), repeats, ..Treatment::default() };
        Recorded::new(samples, treatment).unwrap()
    };
    assert_eq!(of(true).speed_rad_s(), of(false).speed_rad_s());
}
