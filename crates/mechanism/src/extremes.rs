//! Extremes of inertia and holding torque over a range of positions.

use crate::equations::Equations;
use crate::{Endless, Extra, Mechanism, MechanismKind};
use numeric::highest;
use quantities::{Measure, MomentOfInertia, Torque};
use std::f64::consts::{PI, TAU};

/// Extremes of a load between two positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// Smallest J_L.
    pub inertia_least: MomentOfInertia,
    /// Largest J_L.
    pub inertia_largest: MomentOfInertia,
    /// Largest magnitude of the torque that holds the load at rest without the help of friction.
    pub holding: Torque,
    /// Positions of the actuator's output with the smallest and with the largest J_L \[rad\].
    pub inertia_at_rad: [f64; 2],
    /// Position of the actuator's output with the largest holding torque \[rad\].
    pub holding_at_rad: f64,
}

/// Number of steps over the angle that sixteen nodes resolve, see [`Mechanism::smooth_over`].
const STEPS: f64 = 16.0;

/// Smallest number of steps: three places determine a parabola.
const STEPS_LEAST: f64 = 2.0;

/// Relative excess that rounding causes.
const ROUNDING: f64 = 1e-13;

/// Relative difference between a parabola and the value at its vertex at which the search ends.
const CLOSE: f64 = 1e-12;

/// J_L, −J_L, T_h and −T_h at a position.
type Values = [f64; 4];

/// The largest of each of the values so far, with their positions.
type Largest = [(f64, f64); 4];

impl Mechanism {
    /// Returns the extremes of inertia and holding torque between two positions of the actuator's output.
    ///
    /// # Source
    /// docs/theory/mechanisms.md
    /// # Valid
    /// For slider cranks, four-bar linkages and scissor lifts by values at sixteenths of [`Mechanism::smooth_over`], then
    /// parabolas: relative error below 10⁻⁹. Exact for the others, whose extremes lie at an end of the range, at a point
    /// of a table or where the centre of mass is level with the axis.
    #[must_use]
    pub fn extremes(&self, from_rad: f64, to_rad: f64, extra: &Extra) -> Extremes {
        let ratio = self.stage_ratio();
        let (low, high) = (from_rad / ratio, to_rad / ratio);
        let (low, high) = (low.min(high), low.max(high));
        let equations = self.kind.equations();
        let is_periodic = equations.endless() == Endless::EachRevolution;
        // Everything recurs with the next revolution.
        let high = if is_periodic { high.min(low + TAU) } else { high };
        let at = |q: f64| -> Values {
            let reduced = self.kind.reduced(q, extra);
            let (inertia, holding) = (self.inertia_of(&reduced), self.holding_of(&reduced));
            [inertia, -inertia, holding, -holding]
        };
        let mut most = at(low).map(|value| (value, low));
        if high > low {
            see(&mut most, high, at(high));
            let turning = match &self.kind {
                // The lever of the weight is largest where the centre of mass is level with the axis.
                MechanismKind::Rotor(rotor) => vec![-rotor.angle.si(), PI - rotor.angle.si()],
                MechanismKind::Table(table) => table.kinks(),
                // Constant, or monotone over the position.
                MechanismKind::Linear(_)
                | MechanismKind::Joint(_)
                | MechanismKind::Hoist(_)
                | MechanismKind::Winder(_) => Vec::new(),
                MechanismKind::SliderCrank(_) | MechanismKind::FourBar(_) | MechanismKind::ScissorLift(_) => {
                    let smooth = equations.smooth_over(low, high).unwrap_or(high - low);
                    search(&mut most, (low, high), smooth, &at);
                    Vec::new()
                }
            };
            let first = |q: f64| if is_periodic { low + (q - low).rem_euclid(TAU) } else { q };
            let within = turning.into_iter().map(first).filter(|q| *q > low && *q < high);
            within.for_each(|q| see(&mut most, q, at(q)));
        }
        let [(inertia, inertia_at), (least, least_at), (holding, holding_at), (against, against_at)] = most;
        let holding_at = if against > holding { against_at } else { holding_at };
        Extremes {
            inertia_least: MomentOfInertia::from_si(-least),
            inertia_largest: MomentOfInertia::from_si(inertia),
            holding: Torque::from_si(holding.max(against).max(0.0)),
            inertia_at_rad: [least_at, inertia_at].map(|q| q * ratio),
            holding_at_rad: holding_at * ratio,
        }
    }
}

fn see(most: &mut Largest, position_rad: f64, values: Values) {
    for (most, value) in most.iter_mut().zip(values) {
        if value > most.0 {
            *most = (value, position_rad);
        }
    }
}

/// Searches a range in which the load is smooth: values at equal steps, then parabolas.
fn search(most: &mut Largest, (from, to): (f64, f64), smooth: f64, at: &impl Fn(f64) -> Values) {
    let steps = (STEPS * (to - from) / smooth).ceil().max(STEPS_LEAST);
    let mut seen = Vec::new();
    let mut k = 0.0;
    while k <= steps {
        let q = from + (to - from) * k / steps;
        let values = at(q);
        see(most, q, values);
        seen.push((q, values));
        k += 1.0;
    }
    for (which, most) in most.iter_mut().enumerate() {
        let value = |values: &Values| values.get(which).copied().unwrap_or(f64::NEG_INFINITY);
        for trio in seen.windows(3) {
            let [a, b, c] = trio else { continue };
            let three = [a, b, c].map(|(q, values)| (*q, value(values)));
            let (q, found) = highest(|q| value(&at(q)), three, most.0 + ROUNDING * most.0.abs(), CLOSE);
            if found > most.0 {
                *most = (found, q);
            }
        }
    }
}

#[cfg(test)]
#[path = "extremes_tests.rs"]
mod tests;
