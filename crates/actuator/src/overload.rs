//! Overload of the winding as a first-order lag of (I/I_0)² in a periodic cycle.

use quantities::{ElectricCurrent, Measure, Ratio, Time};

/// Returns the output of a first-order lag at the start of each piece of a periodic input, in steady periodic state.
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
    // Each decay is overwritten with the state at the start of its piece after its last use.
    for (&(_, input), place) in pieces.iter().zip(&mut decays) {
        let decay = std::mem::replace(place, value);
        value = input + (value - input) * decay;
    }
    decays
}

/// Returns the rate of change of the state of the overload supervision at an instant [1/s].
///
/// y' = ((I/I_0)² − y)/τ
///
/// # Symbols
/// y state, I motor current, I_0 stall current, τ time constant of the winding \[s\]
/// # Source
/// docs/theory/overload.md
/// # Valid
/// I_0 > 0, τ > 0
#[must_use]
pub fn overload_slope(state: Ratio, current: ElectricCurrent, stall: ElectricCurrent, time_constant: Time) -> f64 {
    let share = current.si() / stall.si();
    (share * share - state.si()) / time_constant.si()
}

/// Returns the lag of (I/I_0)² at the start of each piece of a periodic cycle.
///
/// y' = ((I/I_0)² − y)/τ; above one the overload protection trips. The lag is monotonic on each piece and the cycle is
/// closed, so that the starts include all extremes.
///
/// # Symbols
/// pieces: duration and (I/I_0)², constant on each piece; τ time constant of the winding \[s\]
/// # Source
/// docs/theory/overload.md; steady periodic state in closed form
/// # Valid
/// durations ≥ 0, τ > 0
#[must_use]
pub fn overload_course(pieces: &[(Time, Ratio)], time_constant: Time) -> Vec<Ratio> {
    let plain: Vec<(f64, f64)> = pieces.iter().map(|(duration, square)| (duration.si(), square.si())).collect();
    periodic_lag(&plain, time_constant.si()).into_iter().map(Ratio::from_si).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the largest value of the lag and its time in the cycle; a peak at the start is reported at the end of
    /// the last piece.
    fn peak(pieces: &[(f64, f64)]) -> (f64, f64) {
        let typed: Vec<_> = pieces.iter().map(|&(t, u)| (Time::from_si(t), Ratio::from_si(u))).collect();
        let (mut largest, mut at, mut clock) = (0.0, 0.0, 0.0);
        for (value, (duration, _)) in overload_course(&typed, Time::from_si(60.0)).into_iter().zip(pieces) {
            if value.si() > largest {
                (largest, at) = (value.si(), clock);
            }
            clock += duration;
        }
        (largest, if at > 0.0 || largest <= 0.0 { at } else { clock })
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

    /// 60 s at twice the stall current in small steps: the lag of a constant, 4 (1 − 1/e).
    #[test]
    fn the_slope_leads_to_the_lag() {
        let (current, stall, tau) = (ElectricCurrent::from_si(3.0), ElectricCurrent::from_si(1.5), Time::from_si(60.0));
        let (mut state, step) = (0.0, 1e-3);
        for _ in 0..60_000 {
            // Heun's method: mean of the slopes at both ends of the step.
            let slope = |state: f64| overload_slope(Ratio::from_si(state), current, stall, tau);
            let first = slope(state);
            state += 0.5 * step * (first + slope(state + step * first));
        }
        assert!((state - 4.0 * (1.0 - (-1.0_f64).exp())).abs() < 1e-8, "{state}");
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
}
