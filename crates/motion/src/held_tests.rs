use crate::generated::{Cycle, Law, Noise, accelerations, samples};
use crate::{HeldValues, MadeUp, Recorded, Samples, Spurious, TimeStamps, Treatment};
use quantities::{Measure, Time};

/// Irregularity of the updates of a held signal.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Source {
    /// Values of an even grid that arrive up to a row early or late.
    LateArrival,
    /// Values of the instants at which they arrive, up to a row beside an even grid.
    LateSample,
    /// Every so many updates are lost.
    Losing(usize),
    /// Updates are lost at random.
    LosingAtRandom,
    /// Values of instants between the rows, up to a row beside an even grid.
    Between,
    /// Every update arrives in time.
    Even,
}

impl Source {
    fn is_jittering(self) -> bool {
        matches!(self, Self::LateArrival | Self::LateSample)
    }
}

/// Returns values held over about `rows` rows at the instants `time`.
fn held_by(source: Source, rows: f64, h: f64, time: &[f64], value: impl Fn(f64) -> f64, noise: &mut Noise) -> Vec<f64> {
    let mut values = vec![f64::NAN; time.len()];
    let mut last = 0;
    let mut current = value(0.0);
    for update in 1_usize.. {
        let nominal = update as f64 * rows;
        let jitter = if source.is_jittering() { (1.5 * noise.next()).round() } else { 0.0 };
        let jitter = if source == Source::Between { noise.next() } else { jitter };
        let row = ((nominal + jitter).ceil() as usize).max(last + 1);
        if row >= time.len() {
            break;
        }
        if matches!(source, Source::Losing(every) if update % every == 0)
            || source == Source::LosingAtRandom && noise.next() > 0.8
        {
            continue;
        }
        values[last..row].fill(current);
        current = value(
            h * match source {
                Source::LateSample => row as f64,
                Source::Between => nominal + jitter,
                _ => nominal,
            },
        );
        last = row;
    }
    values[last..].fill(current);
    values
}

/// Returns the samples of a column.
fn column(time: &[f64], values: &[f64], is_speed: bool) -> Samples {
    if is_speed { samples(time, None, Some(values)) } else { samples(time, Some(values), None) }
}

fn treated(samples: Samples, held_values: HeldValues, smoothing: Option<Time>) -> Recorded {
    Recorded::new(samples, Treatment { held_values, smoothing, ..Treatment::default() }).unwrap()
}

/// Updates that come early or late by a row, updates that are lost, and periods that are no multiple of the rows are
/// found, and with one value for each update the acceleration is that of the motion.
#[test]
fn irregular_updates_are_found_and_interpolated() {
    let mut noise = Noise(41);
    let sources = [
        Source::LateArrival,
        Source::LateSample,
        Source::Losing(5),
        Source::Losing(7),
        Source::Losing(20),
        Source::LosingAtRandom,
        Source::Even,
    ];
    let mut wrong = Vec::new();
    for (source, law) in sources.into_iter().flat_map(|source| Law::ALL.map(|law| (source, law))) {
        let cycle = Cycle { law, way: 1.5, rest: 0.3 };
        for (h, rows) in [
            (0.001, 4.0),
            (0.001, 7.0),
            (0.002, 10.0),
            (0.0005, 5.0),
            (0.002, 3.5),
            (0.001, 2.5),
            (0.001, 6.4),
            (0.002, 2.0),
            (0.001, 3.0),
        ] {
            if source.is_jittering() && rows < 4.0 {
                continue;
            }
            let time = cycle.rows(h);
            for is_speed in [true, false] {
                let values = held_by(source, rows, h, &time, |t| cycle.at(t)[usize::from(is_speed)], &mut noise);
                let plain = treated(column(&time, &values, is_speed), HeldValues::Kept, None);
                let found = treated(column(&time, &values, is_speed), HeldValues::Interpolated, None);
                let (peak, rms) = accelerations(&found);
                let (peak, rms) = (peak / cycle.peak(), rms / cycle.rms());
                // Where the acceleration jumps, the instant of the jump is known within a period.
                let loses = matches!(source, Source::Losing(_) | Source::LosingAtRandom);
                let most = match law {
                    Law::Trapezoid if loses => 2.0,
                    Law::Trapezoid => 1.25,
                    _ => 1.05,
                };
                let is_named = matches!(
                    plain.made_up(),
                    Some(MadeUp { cause: Spurious::Held { period_s }, .. }) if (period_s / (rows * h) - 1.0).abs() < 0.03
                );
                if !is_named
                    || !(0.95..most).contains(&peak)
                    || !(0.96..1.02).contains(&rms)
                    || found.made_up().is_some()
                {
                    wrong.push(format!(
                        "{source:?} {law:?} h {h} rows {rows} speed {is_speed}: {:?} peak {peak:.3} rms {rms:.3} {:?}",
                        plain.made_up(),
                        found.made_up()
                    ));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// A value that is written when it has changed by a certain amount is held for irregular times: it is found, and
/// straight lines between the changes leave the acceleration of the motion.
#[test]
fn a_value_written_on_change_is_found() {
    for law in Law::ALL {
        let cycle = Cycle { law, way: 1.5, rest: 0.5 };
        let time = cycle.rows(0.0005);
        let mut current = 0.0;
        let values: Vec<f64> = time
            .iter()
            .map(|t| {
                let speed = cycle.at(*t)[1];
                if (speed - current).abs() > 0.003 * cycle.fastest() || speed == 0.0 {
                    current = speed;
                }
                current
            })
            .collect();
        let plain = treated(column(&time, &values, true), HeldValues::Kept, None);
        let found = treated(column(&time, &values, true), HeldValues::Interpolated, None);
        let (before, rms) = (accelerations(&plain).1 / cycle.rms(), accelerations(&found).1 / cycle.rms());
        let named = matches!(plain.made_up(), Some(MadeUp { cause: Spurious::Held { .. }, .. }));
        assert!(named && (0.97..1.03).contains(&rms), "{law:?}: {before} {rms} {:?}", plain.made_up());
    }
}

/// Steps of held values are still there after their interpolation: they are found with the acceleration that they make
/// up, and the window stated leaves the acceleration of the motion.
#[test]
fn steps_of_interpolated_values_are_found() {
    let mut seen = 0;
    for (law, step) in [1e-6, 2e-5, 1e-4].into_iter().flat_map(|step| Law::ALL.map(|law| (law, step))) {
        let cycle = Cycle { law, way: 1.5, rest: 0.3 };
        for (h, rows, is_speed) in [(0.001, 4.0, false), (0.001, 10.0, false), (0.0005, 5.0, true), (0.001, 8.0, true)]
        {
            let time = cycle.rows(h);
            let step = if is_speed { 50.0 * step } else { step };
            let exact = |t: f64| cycle.at(t)[usize::from(is_speed)];
            let value = |t: f64| (exact(t) / step).round() * step;
            let values = held_by(Source::Even, rows, h, &time, value, &mut Noise(1));
            let found = treated(column(&time, &values, is_speed), HeldValues::Interpolated, None);
            let what = format!("{law:?} step {step} h {h} rows {rows} speed {is_speed}");
            let (peak, _) = accelerations(&found);
            let Some(MadeUp { cause: Spurious::Steps { step: stated, smoothing_s }, acceleration_rad_s2, .. }) =
                found.made_up()
            else {
                assert!(peak < 1.12 * cycle.peak(), "{what}: {peak} of {} {:?}", cycle.peak(), found.made_up());
                continue;
            };
            seen += 1;
            assert!((stated / step - 1.0).abs() < 1e-6, "{what}: {stated}");
            let error = peak - cycle.peak();
            assert!(acceleration_rad_s2 > 0.8 * error, "{what}: {acceleration_rad_s2} for {error}");
            let Some(smoothing) = smoothing_s.map(Time::from_si) else { continue };
            let smooth = treated(column(&time, &values, is_speed), HeldValues::Interpolated, Some(smoothing));
            let (peak, _) = accelerations(&smooth);
            assert!(peak < 1.1 * cycle.peak(), "{what}: {peak} of {} with {smoothing:?}", cycle.peak());
            assert_eq!(smooth.made_up(), None, "{what}");
        }
    }
    assert!(seen > 8, "{seen}");
}

/// Held values whose stamps scatter too are named one after the other, and with both keys the motion is left.
#[test]
fn held_values_with_scattered_stamps_are_both_named() {
    let mut noise = Noise(3);
    for law in Law::ALL {
        let cycle = Cycle { law, way: 1.5, rest: 0.3 };
        for (h, rows) in [(0.002, 4.0), (0.001, 5.0), (0.0015, 3.0)] {
            let time = cycle.rows(h);
            for kind in 0..2 {
                // Uniform scatter, and a scheduler that wakes in time or most of an interval late.
                let late = |u: f64| if kind == 0 { 0.4 * u } else { f64::from(u8::from(u > 0.4)) * 0.7 };
                let stamps: Vec<f64> = time.iter().map(|t| t + h * late(noise.next())).collect();
                for is_speed in [true, false] {
                    let values =
                        held_by(Source::Even, rows, h, &time, |t| cycle.at(t)[usize::from(is_speed)], &mut noise);
                    let new = |held_values, time_stamps| {
                        let treatment = Treatment { held_values, time_stamps, ..Treatment::default() };
                        Recorded::new(column(&stamps, &values, is_speed), treatment).unwrap()
                    };
                    let what = format!("{law:?} h {h} rows {rows} kind {kind} speed {is_speed}");
                    let plain = new(HeldValues::Kept, TimeStamps::Kept);
                    let is_held = matches!(plain.made_up(), Some(MadeUp { cause: Spurious::Held { .. }, .. }));
                    assert!(is_held, "{what}: {:?}", plain.made_up());
                    let between = new(HeldValues::Interpolated, TimeStamps::Kept);
                    let (_, rms) = accelerations(&between);
                    let is_named = matches!(between.made_up(), Some(MadeUp { cause: Spurious::Stamps { .. }, .. }));
                    assert!(is_named || (rms / cycle.rms() - 1.0).abs() < 0.05, "{what}: {rms}");
                    let both = new(HeldValues::Interpolated, TimeStamps::Even);
                    let (peak, rms) = accelerations(&both);
                    assert!((rms / cycle.rms() - 1.0).abs() < 0.03, "{what}: {rms} of {}", cycle.rms());
                    assert!(peak < 1.26 * cycle.peak(), "{what}: {peak} of {}", cycle.peak());
                    assert_eq!((both.made_up(), both.remarks()), (None, &[][..]), "{what}");
                }
            }
        }
    }
}

/// Recordings at rest, constant columns and equal maxima have neither a fault nor a remark.
#[test]
fn constant_columns_are_no_fault() {
    let time: Vec<f64> = (0..500_u32).map(|k| f64::from(k) * 0.002).collect();
    let saw: Vec<f64> = (0..500_u32).map(|k| f64::from((k % 40).min(40 - k % 40))).collect();
    for (position, speed) in [
        (Some(vec![0.0; 500]), None),
        (Some(vec![2.5; 500]), Some(vec![0.0; 500])),
        (None, Some(vec![0.0; 500])),
        (None, Some(vec![3.0; 500])),
        (None, Some(saw)),
        (Some(time.iter().map(|t| 3.0 * t).collect()), Some(vec![3.0; 500])),
    ] {
        for smoothing in [None, Some(Time::from_si(0.04))] {
            let samples = samples(&time, position.as_deref(), speed.as_deref());
            let found = treated(samples, HeldValues::Kept, smoothing);
            assert_eq!(found.made_up(), None);
            assert_eq!((found.rest_noise(), found.alternating(), found.remarks()), (None, None, &[][..]));
        }
    }
}

/// Values of instants between the rows, early or late, keep an error of up to half a row in time: it is named, with the
/// window that takes it out.
#[test]
fn updates_at_instants_between_the_rows_are_named() {
    let mut noise = Noise(3);
    for law in Law::ALL {
        let cycle = Cycle { law, way: 1.5, rest: 0.3 };
        for (h, rows) in [(0.002, 4.0), (0.001, 5.0), (0.001, 10.0), (0.0005, 8.0)] {
            let time = cycle.rows(h);
            for is_speed in [true, false] {
                let exact = |t: f64| cycle.at(t)[usize::from(is_speed)];
                let values = held_by(Source::Between, rows, h, &time, exact, &mut noise);
                let found = treated(column(&time, &values, is_speed), HeldValues::Interpolated, None);
                let excess = accelerations(&found).0 / cycle.peak() - 1.0;
                let what = format!("{law:?} h {h} rows {rows} speed {is_speed}: {excess} {:?}", found.made_up());
                let Some(MadeUp { cause: Spurious::Updates { smoothing_s }, acceleration_rad_s2, .. }) =
                    found.made_up()
                else {
                    assert!(excess < 0.25, "{what}");
                    continue;
                };
                assert!(acceleration_rad_s2 > 0.6 * excess * cycle.peak(), "{what}");
                let Some(smoothing) = smoothing_s.map(Time::from_si) else { continue };
                let smooth = treated(column(&time, &values, is_speed), HeldValues::Interpolated, Some(smoothing));
                let (peak, rms) = accelerations(&smooth);
                let (peak, rms) = (peak / cycle.peak(), rms / cycle.rms());
                assert!(peak < 1.1 && (0.85..1.02).contains(&rms), "{what}: {peak} {rms} with {smoothing:?}");
            }
        }
    }
}
