//! Time-optimal move with limited jerk: seven phases of constant jerk.

use crate::piece::Piece;

/// Limits of a move, all greater than zero; an infinite jerk yields the trapezoid.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    pub(crate) speed: f64,
    pub(crate) acceleration: f64,
    pub(crate) jerk: f64,
}

/// Returns the duration of a change of speed with zero acceleration at both ends \[s\].
///
/// t = Δω/a + a/j if the acceleration limit is reached (Δω ≥ a²/j), else 2√(Δω/j)
fn ramp_time(change: f64, limits: &Limits) -> f64 {
    let Limits { acceleration: a, jerk: j, .. } = *limits;
    if change * j >= a * a { change / a + a / j } else { 2.0 * (change / j).sqrt() }
}

/// Returns the distance of a move from `first` through `peak` to `last` without a constant phase. The acceleration of
/// each change is symmetric in time, so that its mean speed is the mean of its end speeds.
fn distance(first: f64, peak: f64, last: f64, limits: &Limits) -> f64 {
    0.5 * (first + peak) * ramp_time((peak - first).abs(), limits)
        + 0.5 * (peak + last) * ramp_time((last - peak).abs(), limits)
}

/// Relative tolerance for equal speeds and distances: a phase that makes up a smaller difference is rounding.
pub(crate) const SAME: f64 = 1e-9;

/// Returns the distance of a plain change of speed if a move in the direction of its end speeds is shorter, so that the
/// axis passes the end speed, or its end, and comes back.
pub(crate) fn overrun(length: f64, first: f64, last: f64, limits: &Limits) -> Option<f64> {
    let plain = distance(first, last, last, limits);
    let onwards = first * length >= 0.0 && last * length >= 0.0;
    (onwards && length.abs() < plain.abs() * (1.0 - SAME)).then_some(plain)
}

/// Returns the pieces of the shortest move over a distance between two speeds, with zero acceleration at both ends.
///
/// The peak speed is the limit if the distance permits a constant phase, else the root of the distance as a function of
/// a peak speed beyond the end speeds. A root exists: the distance is convex in the peak there and begins on the other
/// side. A distance that differs from that without a constant phase, or from that of the plain change of speed, by
/// rounding is that distance; the phases are stretched in time by the quotient of both.
///
/// # Source
/// own derivation, docs/theory/motion-laws.md; durations compared with an independent generator
pub(crate) fn pieces(length: f64, first: f64, last: f64, limits: &Limits) -> Vec<Piece> {
    // An end speed that differs from the limit by rounding is the limit.
    let at_limit = |speed: f64| (speed.abs() - limits.speed).abs() <= SAME * limits.speed;
    let ends = [first, last].into_iter().filter(|speed| at_limit(*speed));
    let top = ends.fold(0.0_f64, |most, speed| most.max(speed.abs()));
    let limits = &Limits { speed: if top > 0.0 { top } else { limits.speed }, ..*limits };
    let (low, high) = (first.min(last), first.max(last));
    // Distance of a plain change of speed; a longer one needs a higher peak, a shorter one a lower or reversed peak.
    let plain = distance(first, high, last, limits);
    let forward = length >= plain;
    let (near, far) = if forward { (high, limits.speed) } else { (low, -limits.speed) };
    for (peak, reached) in [(high, plain), (far, distance(first, far, last, limits))] {
        let way = 0.5 * (first.abs() + peak.abs()) * ramp_time((peak - first).abs(), limits)
            + 0.5 * (peak.abs() + last.abs()) * ramp_time((last - peak).abs(), limits);
        if (length - reached).abs() <= SAME * way {
            // Without a distance of its own, as between opposite speeds, a change cannot be stretched.
            let factor = Some(length / reached).filter(|factor| (factor - 1.0).abs() <= SAME).unwrap_or(1.0);
            let Limits { acceleration, jerk, .. } = *limits;
            let limits = Limits { acceleration: acceleration / factor, jerk: jerk / (factor * factor), ..*limits };
            let mut pieces = change(first, peak, &limits);
            pieces.extend(change(peak, last, &limits));
            return pieces;
        }
    }
    let reached = distance(first, far, last, limits);
    let (peak, run) = if (forward && reached <= length) || (!forward && reached >= length) {
        (far, (length - reached) / far)
    } else {
        let beyond = |peak: f64| distance(first, peak, last, limits) - length;
        let ends = [near.min(far), near.max(far)].map(|peak| (peak, beyond(peak)));
        (numeric::root(beyond, ends[0], ends[1], 0.0), 0.0)
    };
    let mut pieces = change(first, peak, limits);
    pieces.push(Piece::ramp(run, 0.0));
    pieces.extend(change(peak, last, limits));
    pieces.retain(|piece| piece.duration_s > 0.0);
    if pieces.is_empty() {
        // The speed changes by rounding only.
        pieces.push(Piece::ramp(length / peak, 0.0));
    }
    pieces
}

/// Returns the three phases of a change of speed: jerk, constant acceleration, opposite jerk; none if the change is
/// rounding.
fn change(from: f64, to: f64, limits: &Limits) -> Vec<Piece> {
    let (step, sign) = ((to - from).abs(), (to - from).signum());
    if step <= SAME * from.abs().max(to.abs()) {
        return Vec::new();
    }
    let whole = ramp_time(step, limits);
    let half = 0.5 * whole;
    let edge = limits.acceleration / limits.jerk;
    let edge = if edge >= half * (1.0 - SAME) { half } else { edge };
    if edge == 0.0 {
        return vec![Piece::ramp(whole, step / whole * sign).ending_with(to)];
    }
    // The jerk follows from the times, so that the change of speed is exact to the last bit.
    let jerk = step / (edge * (whole - edge)) * sign;
    let top = jerk * edge;
    // The speeds between the phases lie between `from` and `to` despite rounding of the integral.
    let gained = (0.5 * top * edge).abs().min(0.5 * step) * sign;
    let mut phases = vec![
        Piece::polynomial(edge, [0.0, jerk, 0.0, 0.0]).ending_with(from + gained),
        Piece::polynomial(whole - 2.0 * edge, [top, 0.0, 0.0, 0.0]).ending_with(to - gained),
        Piece::polynomial(edge, [top, -jerk, 0.0, 0.0]).ending_with(to),
    ];
    phases.retain(|phase| phase.duration_s > 0.0);
    phases
}

#[cfg(test)]
#[path = "ramp_tests.rs"]
mod ramp_tests;

#[cfg(test)]
mod tests {
    use super::*;

    fn duration(length: f64, first: f64, last: f64, limits: &Limits) -> f64 {
        pieces(length, first, last, limits).iter().map(|piece| piece.duration_s).sum()
    }

    /// T = d/v + v/a + a/j where all three limits are reached; the value of the reference list.
    #[test]
    fn a_full_move_takes_the_sum_of_the_three_quotients() {
        let limits = Limits { speed: 4.0, acceleration: 30.0, jerk: 900.0 };
        let expected = 1.7 / 4.0 + 4.0 / 30.0 + 30.0 / 900.0;
        assert!((duration(1.7, 0.0, 0.0, &limits) - expected).abs() < 1e-12);
    }

    /// Random moves compared with the Rust port of the ruckig generator: equal durations within 1e-9, never longer.
    #[test]
    fn durations_agree_with_an_independent_generator() {
        use rsruckig::prelude::*;
        let mut seed = 0x9e37_79b9_7f4a_7c15_u64;
        let mut random = |low: f64, high: f64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            low + (high - low) * ((seed >> 11) as f64 / (1_u64 << 53) as f64)
        };
        let (mut compared, mut worst) = (0, 0.0_f64);
        for case in 0..20_000 {
            let limits = Limits { speed: random(0.5, 10.0), acceleration: random(1.0, 100.0), jerk: random(10.0, 5e3) };
            let length = random(-6.0, 6.0);
            let (first, last) = if case % 2 == 0 {
                (0.0, 0.0)
            } else {
                (random(-1.0, 1.0) * limits.speed, random(-1.0, 1.0) * limits.speed)
            };
            let mut input: InputParameter<1> = InputParameter::new(None);
            input.current_position[0] = 0.0;
            input.current_velocity[0] = first;
            input.target_position[0] = length;
            input.target_velocity[0] = last;
            input.max_velocity[0] = limits.speed;
            input.max_acceleration[0] = limits.acceleration;
            input.max_jerk[0] = limits.jerk;
            let mut other: Trajectory<1> = Trajectory::new(None);
            let mut generator: Ruckig<1, IgnoreErrorHandler> = Ruckig::new(None, 0.001);
            if generator.calculate(&input, &mut other).is_err() {
                continue;
            }
            let ours = duration(length, first, last, &limits);
            let difference = ours - other.get_duration();
            worst = worst.max(difference.abs());
            assert!(difference.abs() <= 1e-9, "{length} {first} {last} {limits:?}: {ours} {}", other.get_duration());
            compared += 1;
        }
        assert!(compared > 19_000, "only {compared} of 20000 compared; worst {worst:e}");
    }
}
