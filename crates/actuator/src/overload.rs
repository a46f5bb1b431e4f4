//! Overload of the winding as a first-order lag of (I/I_0)²: trip time, peak of a cycle, intermittent duty.

use quantities::{Measure, Ratio, Time};

/// Output of a first-order lag at the start of every piece of a periodic input, in steady periodic state.
///
/// y' = (u − y)/τ with u constant on each piece; y_0 = Σ u_j (1 − e^(−t_j/τ)) e^(−rest_j/τ) / (1 − e^(−T/τ)).
/// Pieces are (duration \[s\], input).
pub(crate) fn periodic_lag(pieces: &[(f64, f64)], tau_s: f64) -> Vec<f64> {
    let mut gathered = 0.0;
    let mut period_s = 0.0;
    let mut decays = Vec::with_capacity(pieces.len());
    for &(duration_s, input) in pieces {
        let decay = (-duration_s / tau_s).exp();
        decays.push(decay);
        gathered = gathered * decay - input * (-duration_s / tau_s).exp_m1();
        period_s += duration_s;
    }
    let loss = -(-period_s / tau_s).exp_m1();
    let mut value = if loss > 0.0 { gathered / loss } else { 0.0 };
    // What the first pass needed of a decay gives way to the state at its start.
    for (&(_, input), place) in pieces.iter().zip(&mut decays) {
        let decay = std::mem::replace(place, value);
        value = input + (value - input) * decay;
    }
    decays
}

/// Time until an overload trips.
///
/// t = τ ln((k² − k_0²) / (k² − 1)); `None` for k ≤ 1, which never trips; zero where the preload is at the limit already
///
/// # Symbols  k = I/I_0 overload factor, k_0 preload factor, τ time constant of the winding \[s\]
/// # Source   docs/theory/overload.md, first-order lag of the loss
/// # Valid    k, k_0 ≥ 0, τ > 0
#[must_use]
pub fn overload_trip_time(overload: Ratio, preload: Ratio, time_constant: Time) -> Option<Time> {
    let (square, before) = (overload.si().powi(2), preload.si().powi(2));
    (square > 1.0).then(|| {
        let seconds = time_constant.si() * ((square - before.min(1.0)) / (square - 1.0)).ln();
        Time::from_si(seconds.max(0.0))
    })
}

/// Largest value that the lag of (I/I_0)² reaches in a cycle repeated for ever, and when in the cycle.
///
/// y' = ((I/I_0)² − y)/τ; above one the overload protection trips
///
/// # Symbols  pieces: duration and (I/I_0)², constant on each piece; τ time constant of the winding \[s\]
/// # Source   docs/theory/overload.md; steady periodic state in closed form
/// # Valid    durations ≥ 0, τ > 0; zero for an empty cycle
#[must_use]
pub fn overload_peak(pieces: &[(Time, Ratio)], time_constant: Time) -> (Ratio, Time) {
    let plain: Vec<(f64, f64)> =
        pieces.iter().map(|(duration, square)| (duration.si(), square.si())).filter(|(s, _)| *s > 0.0).collect();
    let (mut peak, mut at_s, mut clock_s) = (0.0, 0.0, 0.0);
    for (value, (duration_s, _)) in periodic_lag(&plain, time_constant.si()).into_iter().zip(&plain) {
        // Every piece is monotonic, and the cycle closes: the starts hold every extreme.
        if value > peak {
            (peak, at_s) = (value, clock_s);
        }
        clock_s += duration_s;
    }
    // The start of the cycle is its end; the moment of a peak there is the end of the last piece.
    if at_s <= 0.0 && peak > 0.0 {
        at_s = clock_s;
    }
    (Ratio::from_si(peak), Time::from_si(at_s))
}

/// The lag of (I/I_0)² at the start of every piece of a cycle repeated for ever; as [`overload_peak`].
#[must_use]
pub fn overload_course(pieces: &[(Time, Ratio)], time_constant: Time) -> Vec<Ratio> {
    let plain: Vec<(f64, f64)> = pieces.iter().map(|(duration, square)| (duration.si(), square.si())).collect();
    periodic_lag(&plain, time_constant.si()).into_iter().map(Ratio::from_si).collect()
}

/// Loss of intermittent duty S3 relative to the loss of continuous duty, during operation.
///
/// (I_S3/I_S1)² = (1 − e^(−T_c/τ)) / (1 − e^(−ED T_c/τ))
///
/// # Symbols  ED duty factor, T_c cycle \[s\], τ time constant of the winding \[s\]
/// # Source   docs/theory/overload.md; a first-order lag that reaches its continuous value at the end of each operation
/// # Valid    0 < ED ≤ 1, T_c > 0, τ > 0; 1/ED for short cycles, 1 for long ones
#[must_use]
pub fn intermittent_loss_factor(duty: Ratio, cycle: Time, time_constant: Time) -> Ratio {
    let share = cycle.si() / time_constant.si();
    Ratio::from_si((-share).exp_m1() / (-duty.si() * share).exp_m1())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn trip(k: f64, k0: f64) -> Option<f64> {
        overload_trip_time(Ratio::from_si(k), Ratio::from_si(k0), Time::from_si(60.0)).map(Time::si)
    }

    /// 60 ln(2.25/1.25) = 35.3 s, 60 ln(4/3) = 17.3 s, 60 ln(9/8) = 7.1 s from cold.
    #[test]
    fn trip_times_by_hand() {
        for (k, seconds) in [(1.5, 35.27), (2.0, 17.26), (3.0, 7.07)] {
            assert!((trip(k, 0.0).unwrap() - seconds).abs() < 0.005, "{k}");
        }
        assert!((trip(2.0, 0.5).unwrap() - 60.0 * (3.75_f64 / 3.0).ln()).abs() < 1e-12);
        assert_eq!(trip(1.0, 0.0), None);
        assert_eq!(trip(0.5, 0.0), None);
        assert_eq!(trip(2.0, 1.0), Some(0.0));
        assert_eq!(trip(2.0, 3.0), Some(0.0));
    }

    fn peak(pieces: &[(f64, f64)]) -> (f64, f64) {
        let typed: Vec<_> = pieces.iter().map(|&(t, u)| (Time::from_si(t), Ratio::from_si(u))).collect();
        let (value, at) = overload_peak(&typed, Time::from_si(60.0));
        (value.si(), at.si())
    }

    /// Half a minute at twice the loss, half a minute of rest: 2 (1 − e^(−1/2)) / (1 − e^(−1)) = 1.2449, at 30 s.
    #[test]
    fn the_peak_of_two_pieces_by_hand() {
        let (value, at) = peak(&[(30.0, 2.0), (30.0, 0.0)]);
        assert!((value - 1.244_918_662).abs() < 1e-8, "{value}");
        assert!((at - 30.0).abs() < 1e-12);
        let (same, at) = peak(&[(30.0, 0.0), (30.0, 2.0)]);
        assert!((same - value).abs() < 1e-12);
        assert!((at - 60.0).abs() < 1e-12);
    }

    #[test]
    fn short_cycles_see_the_mean_and_long_ones_the_largest() {
        assert!((peak(&[(1e-6, 4.0), (3e-6, 0.0)]).0 - 1.0).abs() < 1e-6);
        assert!((peak(&[(6e4, 4.0), (6e4, 0.0)]).0 - 4.0).abs() < 1e-12);
        assert!((peak(&[(5.0, 0.7), (9.0, 0.7)]).0 - 0.7).abs() < 1e-12);
        assert_eq!(peak(&[]), (0.0, 0.0));
        assert_eq!(peak(&[(0.0, 5.0)]), (0.0, 0.0));
    }

    #[test]
    fn the_closed_form_agrees_with_many_repetitions() {
        let pieces = [(3.0, 4.0), (20.0, 0.2), (11.0, 1.7), (40.0, 0.0)];
        let mut value: f64 = 0.0;
        let mut largest: f64 = 0.0;
        for _ in 0..50 {
            largest = 0.0;
            for (duration, input) in pieces {
                let steps = 1000;
                for _ in 0..steps {
                    value = input + (value - input) * (-duration / f64::from(steps) / 60.0_f64).exp();
                    largest = largest.max(value);
                }
            }
        }
        assert!((peak(&pieces).0 - largest).abs() < 1e-10);
    }

    /// The peak of a cycle at the intermittent loss is exactly the limit.
    #[test]
    fn intermittent_duty_reaches_the_limit_and_not_more() {
        for duty in [0.1, 0.25, 0.5, 0.9] {
            let factor = intermittent_loss_factor(Ratio::from_si(duty), Time::from_si(60.0), Time::from_si(60.0)).si();
            assert!((peak(&[(60.0 * duty, factor), (60.0 * (1.0 - duty), 0.0)]).0 - 1.0).abs() < 1e-12);
        }
        let factor = |duty, cycle| {
            intermittent_loss_factor(Ratio::from_si(duty), Time::from_si(cycle), Time::from_si(60.0)).si()
        };
        assert!((factor(0.5, 60.0) - 1.606_530_66).abs() < 1e-8);
        assert!((factor(0.25, 1e-3) - 4.0).abs() < 1e-4);
        assert!((factor(0.25, 1e5) - 1.0).abs() < 1e-12);
        assert!((factor(1.0, 60.0) - 1.0).abs() < 1e-15);
    }
}
