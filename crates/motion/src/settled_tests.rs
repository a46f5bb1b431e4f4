use crate::generated::{Noise, poly, samples};
use crate::{Recorded, Treatment};

/// 90° in 0.8 s, rest 2 s, back, rest; positions in degrees.
struct Cycle {
    time: Vec<f64>,
    position: Vec<f64>,
    speed: Vec<f64>,
    /// Time since the beginning of the rest; `None` in a move.
    rest: Vec<Option<f64>>,
}

const WAY: f64 = 90.0;
const MOVE: f64 = 0.8;
const REST: f64 = 2.0;

fn cycle(h: f64) -> Cycle {
    let count = (2.0 * (MOVE + REST) / h).round() as usize;
    let mut found = Cycle { time: vec![], position: vec![], speed: vec![], rest: vec![] };
    for k in 0..=count {
        let t = k as f64 * h;
        let (forth, back) = (poly(WAY, MOVE, t), poly(WAY, MOVE, t - MOVE - REST));
        let within = if t < MOVE + REST { t } else { t - MOVE - REST };
        let speed = forth.1 - back.1;
        let speed = if speed.abs() < 1e-9 { 0.0 } else { speed };
        found.time.push(t);
        found.position.push(forth.0 - back.0);
        found.speed.push(speed);
        found.rest.push((speed == 0.0).then_some((within - MOVE).max(0.0)));
    }
    found
}

/// T_rms of 0.4 kgm² and 20 Nm of friction.
fn rms(recorded: &Recorded) -> f64 {
    let mut sum = 0.0;
    for (t, w) in recorded.time_s().windows(2).zip(recorded.speed_rad_s().windows(2)) {
        let (h, alpha) = (t[1] - t[0], (w[1] - w[0]) / (t[1] - t[0]));
        let mut add = |share: f64, direction: f64| sum += share * h * (0.4 * alpha + 20.0 * direction).powi(2);
        if w[0] * w[1] < 0.0 {
            let share = w[0] / (w[0] - w[1]);
            add(share, w[0].signum());
            add(1.0 - share, w[1].signum());
        } else {
            add(1.0, if w[0] + w[1] == 0.0 { 0.0 } else { (w[0] + w[1]).signum() });
        }
    }
    (sum / recorded.duration_s()).sqrt()
}

fn of(time: &[f64], position: &[f64], speed: Option<&[f64]>) -> Recorded {
    // Nine decimals of a degree.
    let written: Vec<f64> = position.iter().map(|q| ((q * 1e9).round() * 1e-9).to_radians()).collect();
    let speed: Option<Vec<f64>> = speed.map(|speed| speed.iter().map(|w| w.to_radians()).collect());
    Recorded::new(samples(time, Some(&written), speed.as_deref()), Treatment::default()).unwrap()
}

/// Noise filtered by a Gaussian window.
fn lowpass(noise: &mut Noise, count: usize, sigma: f64) -> Vec<f64> {
    let white: Vec<f64> = (0..count + 200).map(|_| noise.normal()).collect();
    let weight = |k: f64| (-0.5 * (k / sigma).powi(2)).exp();
    let mut found: Vec<f64> =
        (0..count).map(|k| (0..200).map(|j| weight(j as f64 - 100.0) * white[k + j]).sum::<f64>()).collect();
    let size = (found.iter().map(|x| x * x).sum::<f64>() / count as f64).sqrt();
    found.iter_mut().for_each(|x| *x /= size);
    found
}

/// T_rms of the law, ∫ (J α ± T)² dt = J² ∫ α² dt + T² t over a move, since ∫ α dt = 0.
fn rms_of_the_law() -> f64 {
    let squares = 120.0 / 7.0 * (WAY.to_radians() / MOVE.powi(2)).powi(2) * MOVE;
    ((0.16 * squares + 400.0 * MOVE) / (MOVE + REST)).sqrt()
}

/// A disturbance of the position at rest: sample and time since the beginning of the rest.
type Disturbance<'d> = &'d dyn Fn(usize, f64) -> f64;

/// Returns the motion with a disturbance at rest, from positions alone or with speeds.
fn disturbed(cycle: &Cycle, add: Disturbance<'_>, with_speed: bool) -> Recorded {
    let error: Vec<f64> =
        cycle.rest.iter().enumerate().map(|(k, rest)| rest.map_or(0.0, |rest| add(k, rest))).collect();
    let position: Vec<f64> = cycle.position.iter().zip(&error).map(|(q, e)| q + e).collect();
    let slopes = crate::recorded::slopes(&cycle.time, &error);
    let speed: Vec<f64> = cycle.speed.iter().zip(slopes).map(|(w, e)| w + e).collect();
    of(&cycle.time, &position, with_speed.then_some(&speed))
}

/// A rest is one by its size: hum, settling, drift and filtered noise far below the motion change T_rms by less than 10⁻³
/// against the closed form, from positions alone and with speeds. Their size is stated.
#[test]
fn small_disturbances_at_rest_are_rest() {
    let (exact, cycle, turn) = (rms_of_the_law(), cycle(0.002), std::f64::consts::TAU);
    let mut noise = Noise(7);
    let mut wrong = Vec::new();
    let mut judge = |name: String, add: Disturbance<'_>, range: f64, both: bool| {
        for with_speed in [false, true].into_iter().filter(|with| !with || both) {
            let found = disturbed(&cycle, add, with_speed);
            let off = rms(&found) / exact - 1.0;
            let place = found.rest_noise().map_or(0.0, |noise| noise.place_rad.to_degrees());
            if off.abs() > 1.2e-3 || !(0.3 * range..=1.2 * range + 2e-5).contains(&place) {
                wrong.push(format!("{name}, speed {with_speed}: {off:e}, {place}° of {range}°"));
            }
        }
    };
    for size in [1e-6, 1e-5, 1e-4, 1e-3] {
        judge(format!("5 Hz {size}"), &|_, t| size * (turn * 5.0 * t).sin(), 2.0 * size, true);
        judge(format!("50 Hz {size}"), &|_, t| size * (turn * 50.0 * t).sin(), 2.0 * size, true);
    }
    for size in [1e-5, 1e-4] {
        judge(format!("drift {size}"), &|_, t| size * t / REST, size, true);
    }
    for size in [1e-4, 1e-3, 1e-2] {
        for sign in [1.0, -1.0] {
            let settling = |_: usize, t: f64| sign * size * (-t / 0.1).exp() * (turn * 15.0 * t).sin();
            judge(format!("settling {size}"), &settling, 1.6 * size, true);
        }
    }
    for size in [1e-5, 1e-4, 1e-3] {
        let filtered = lowpass(&mut noise, cycle.time.len(), 10.0);
        let add = |k: usize, t: f64| size * filtered[k] * (t / 0.05).min(1.0) * ((REST - t) / 0.05).clamp(0.0, 1.0);
        judge(format!("filtered {size}"), &add, 6.0 * size, true);
    }
    // White noise leaves the ends of a rest open by a sample, 6·10⁻⁴ of T_rms each.
    for size in [1e-7, 1e-5, 1e-4, 1e-3, 5e-3] {
        let mut sum = 0.0;
        for _ in 0..6 {
            let white: Vec<f64> = cycle.time.iter().map(|_| noise.normal()).collect();
            let off = rms(&disturbed(&cycle, &|k, _| size * white[k], false)) / exact - 1.0;
            sum += off / 6.0;
            assert!(off.abs() < 2.5e-3, "white {size}: {off:e}");
        }
        assert!(sum.abs() < 2e-3, "white {size}: {sum:e} on average");
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// The sampling interval does not lengthen the motion from positions alone: the first and the last sample of a rest are at
/// rest.
#[test]
fn a_rest_loses_no_sample() {
    let exact = rms_of_the_law();
    for (h, most) in [(0.0002, 1e-5), (0.001, 1e-5), (0.002, 2e-5), (0.005, 1e-4), (0.01, 3e-4), (0.02, 1e-3)] {
        let found = disturbed(&cycle(h), &|_, _| 0.0, false);
        let off = rms(&found) / exact - 1.0;
        assert!(off.abs() < most, "{h} s: {off:e}");
        assert_eq!((found.rest_noise(), found.slow_motion()), (None, None), "{h} s");
    }
    // Counts of a slow motion leave their place by one step: it goes on.
    let time: Vec<f64> = (0..4000).map(|k| f64::from(k) * 1e-3).collect();
    let counts: Vec<f64> = time.iter().map(|t| 0.01 * (20.0 * (t + 0.2 * (3.0 * t).sin())).round()).collect();
    let found = of(&time, &counts, None);
    assert_eq!(
        found.speed_rad_s()[1..3999],
        crate::recorded::slopes(
            &time,
            &counts.iter().map(|q| ((q * 1e9).round() * 1e-9).to_radians()).collect::<Vec<_>>()
        )[1..3999]
    );
}

/// A slow motion that leaves its place stays motion, and is named with its size: a creep, a swing, and the tracking after a
/// move.
#[test]
fn a_slow_motion_is_named() {
    let (cycle, turn) = (cycle(0.002), std::f64::consts::TAU);
    let cases: [(&str, Disturbance<'_>); 3] = [
        ("creep", &|_, t| 0.05 * t / REST),
        ("swing", &|_, t| 0.1 * (turn * 2.0 * t).sin()),
        ("tracking", &|_, t| 15.0 / 3600.0 * t),
    ];
    for (name, add) in cases {
        let found = disturbed(&cycle, add, false);
        let moving =
            cycle.rest.iter().zip(found.speed_rad_s()).filter(|(rest, w)| rest.is_some() && **w != 0.0).count();
        assert!(moving > 1900, "{name}: {moving}");
        let slow = found.slow_motion().unwrap_or_else(|| panic!("{name} is not named"));
        assert!(slow.duration_s > 3.9 && slow.place_rad > 1e-4, "{name}: {slow:?}");
    }
}

/// White noise at rest of up to a thousandth of the largest speed changes T_rms by less than a thousandth where speeds are recorded;
/// from positions alone by no more than an interval of friction at each of the four ends, and by less than 10⁻⁴ where the first increment
/// of a move is seen.
#[test]
fn white_noise_at_rest_changes_the_effective_torque_within_its_bound() {
    let mut wrong = Vec::new();
    for h in [0.001, 0.002, 0.005] {
        let cycle = cycle(h);
        let exact = [false, true].map(|with_speed| rms(&disturbed(&cycle, &|_, _| 0.0, with_speed)));
        let most = cycle.speed.iter().fold(0.0_f64, |most, w| most.max(w.abs()));
        // ½ n h M²/∫M² dt with four ends, the friction of 20 Nm and twice the mean square of a move and a rest.
        let bound = 0.5 * 4.0 * h * 400.0 / (2.0 * (MOVE + REST) * rms_of_the_law().powi(2));
        // Increment of the first interval of a move, q ≈ 10 (t/T)³ of the way.
        let first = 10.0 * WAY * (h / MOVE).powi(3);
        for share in [1e-6, 1e-5, 1e-4, 3e-4, 1e-3] {
            let mut noise = Noise(11);
            for _ in 0..10 {
                let white: Vec<f64> = cycle.time.iter().map(|_| noise.normal()).collect();
                // The difference over two intervals has the share of the largest speed.
                let size = share * most * 2.0 * h / std::f64::consts::SQRT_2;
                let of_position = rms(&disturbed(&cycle, &|k, _| size * white[k], false)) / exact[0] - 1.0;
                let is_seen = first > 8.0 * size;
                let speed: Vec<f64> = (0..cycle.time.len())
                    .map(|k| cycle.speed[k] + if cycle.rest[k].is_some() { share * most * white[k] } else { 0.0 })
                    .collect();
                let of_speed = rms(&of(&cycle.time, &cycle.position, Some(&speed))) / exact[1] - 1.0;
                if of_speed.abs() > 1e-3 || of_position.abs() > if is_seen { 1e-4 } else { 1.1 * bound } {
                    wrong.push(format!("{h} s, {share:e}: {of_speed:e}, {of_position:e} of {bound:e}, seen {is_seen}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}: {wrong:#?}", wrong.len());
}
