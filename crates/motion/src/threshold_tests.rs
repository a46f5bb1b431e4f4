use crate::generated::{Cycle, Law, Noise, accelerations, samples};
use crate::{Recorded, Remark, Treatment};
use quantities::{AngularVelocity, Measure, Time};

/// A stated threshold of 0.1 to 5 % of the largest speed adds no acceleration to the motion: without noise within a few
/// per cent of the law, with noise no more than the recording itself. The axis is at rest in the rests.
#[test]
fn a_stated_standstill_leaves_the_ends_of_the_moves() {
    let mut noise = Noise(17);
    let mut wrong = Vec::new();
    for law in Law::ALL {
        for (h, rest) in [(0.0004, 0.3), (0.001, 0.5), (0.002, 0.3), (0.005, 2.0)] {
            let cycle = Cycle { law, way: 1.5, rest };
            let time = cycle.rows(h);
            for size in [0.0, 1e-4, 1e-3] {
                let speed: Vec<f64> =
                    time.iter().map(|t| cycle.at(*t)[1] + size * cycle.fastest() * noise.normal()).collect();
                let position: Vec<f64> =
                    time.iter().map(|t| cycle.at(*t)[0] + size * 0.1 * h * noise.normal()).collect();
                for (with_speed, window) in [(true, 0.0), (true, 0.04), (true, 0.08), (false, 0.0), (false, 0.04)] {
                    let columns = if with_speed { (None, Some(&speed[..])) } else { (Some(&position[..]), None) };
                    let smoothing = Some(Time::from_si(window)).filter(|_| window > 0.0);
                    let new = |standstill: Option<AngularVelocity>| {
                        let treatment = Treatment { smoothing, standstill, ..Treatment::default() };
                        Recorded::new(samples(&time, columns.0, columns.1), treatment).unwrap()
                    };
                    // A threshold of zero keeps everything.
                    let (own, _) = accelerations(&new(Some(AngularVelocity::from_si(0.0))));
                    for share in [0.001, 0.005, 0.01, 0.02, 0.05] {
                        if share < 6.0 * size {
                            continue;
                        }
                        let found = new(Some(AngularVelocity::from_si(share * cycle.fastest())));
                        let (peak, _) = accelerations(&found);
                        let most = (1.03 * cycle.peak()).max(if size > 0.0 { 1.1 * own } else { own });
                        let what = format!("{law:?} {h} noise {size:e} speed {with_speed} {window} share {share}");
                        if peak > most {
                            wrong.push(format!("{what}: {peak} of {} own {own}", cycle.peak()));
                        }
                        let still = found.speed_rad_s().iter().filter(|w| **w == 0.0).count() as f64 * h;
                        // A window spreads the moves into the rests.
                        let least = 3.0 * rest - 4.0 * (window + 8.0 * h);
                        if still < least {
                            wrong.push(format!("{what}: {still} s at rest, {least} expected"));
                        }
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} {wrong:#?}", wrong.len());
}

/// An offset at rest below the threshold is rest, and the ends of the moves lead down to zero.
#[test]
fn an_offset_at_rest_is_no_step() {
    let mut noise = Noise(23);
    for law in Law::ALL {
        for (offset, size) in [(0.002, 0.0), (0.002, 1e-4), (0.005, 1e-3), (-0.004, 5e-4)] {
            let cycle = Cycle { law, way: 1.5, rest: 0.5 };
            let time = cycle.rows(0.001);
            let speed: Vec<f64> =
                time.iter().map(|t| cycle.at(*t)[1] + cycle.fastest() * (offset + size * noise.normal())).collect();
            let new = |share: f64| {
                let standstill = Some(AngularVelocity::from_si(share * cycle.fastest()));
                let treatment = Treatment { standstill, ..Treatment::default() };
                Recorded::new(samples(&time, None, Some(&speed)), treatment).unwrap()
            };
            let ((own, _), found) = (accelerations(&new(0.0)), new(0.02));
            let (peak, _) = accelerations(&found);
            let still = found.speed_rad_s().iter().filter(|w| **w == 0.0).count();
            assert!(peak <= 1.4 * own, "{law:?} {offset} {size}: {peak} of {own}");
            assert!(still > 1400, "{law:?} {offset} {size}: {still}");
            assert_eq!(found.end_speeds_rad_s(), (0.0, 0.0));
        }
    }
}

/// A reversal without rest stays as it is; a dip below the threshold adds little acceleration.
#[test]
fn a_reversal_without_rest_is_kept() {
    let time: Vec<f64> = (0..4000_u32).map(|k| f64::from(k) * 1e-3).collect();
    for offset in [0.0, 0.5, 1.02, 1.05] {
        let speed: Vec<f64> = time.iter().map(|t| offset + (3.0 * t + 0.4).sin()).collect();
        let treatment = Treatment { standstill: Some(AngularVelocity::from_si(0.1)), ..Treatment::default() };
        let found = Recorded::new(samples(&time, None, Some(&speed)), treatment).unwrap();
        if offset < 1.0 {
            assert_eq!(found.speed_rad_s(), speed, "{offset}");
        }
        let (peak, _) = accelerations(&found);
        assert!(peak <= 4.0, "{offset}: {peak}");
    }
}

/// A threshold above the speed of a slow motion stops it in a step, which is named; one below it is not.
#[test]
fn a_standstill_within_the_motion_is_named() {
    let time: Vec<f64> = (0..4000_u32).map(|k| f64::from(k) * 1e-3).collect();
    let speed: Vec<f64> = time.iter().map(|t| if (1.0..2.0).contains(t) { 0.095 } else { 0.105 }).collect();
    let remarks = |standstill: f64| {
        let treatment = Treatment { standstill: Some(AngularVelocity::from_si(standstill)), ..Treatment::default() };
        Recorded::new(samples(&time, None, Some(&speed)), treatment).unwrap().remarks().to_vec()
    };
    assert_eq!(remarks(0.09), []);
    assert!(matches!(remarks(0.1).as_slice(), [Remark::StandstillSteps { .. }]));
}
