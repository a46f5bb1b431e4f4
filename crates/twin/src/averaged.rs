//! Operation over days and years, computed from the mean losses of a cycle.

use crate::machine::Machine;
use crate::setup::{Fault, Setup};
use crate::twin::Twin;
use crate::warm::settled;
use crate::{Scenario, ScenarioId};
use actuator::{HeatModel, Losses, Network, Temperatures};
use quantities::{Measure, ThermodynamicTemperature};

/// Schedule of operation: in each day or other period, cycles for a part of it, then a rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Operation {
    /// Number of periods.
    pub periods: u32,
    /// Duration of a period \[s\].
    pub period_s: f64,
    /// Time in operation per period \[s\], from zero to the whole period.
    pub running_s: f64,
}

/// Number of intervals between the points of a period: minutes of a day.
pub const POINTS_OF_A_PERIOD: u32 = 1440;

/// Temperatures at an instant of a period \[K\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PeriodPoint {
    /// Time since the beginning of the period \[s\].
    pub time_s: f64,
    /// Mean temperature of the winding over a cycle.
    pub winding_k: f64,
    /// Highest temperature of the winding within a cycle; the mean at rest.
    pub winding_peak_k: f64,
    /// Temperature of the housing.
    pub housing_k: f64,
}

/// Course of the temperatures over one period.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodCourse {
    /// Number of the period, from one.
    pub number: u32,
    /// Temperatures at equal intervals from beginning to end, [`POINTS_OF_A_PERIOD`] and one.
    pub points: Vec<PeriodPoint>,
}

/// Results of operation over days.
#[derive(Clone, Debug, PartialEq)]
pub struct Averaged {
    /// Courses of the first and the last period; one course if they are the same.
    pub courses: Vec<PeriodCourse>,
    /// Largest temperatures of winding and housing \[K\].
    pub peak_k: [f64; 2],
    /// Final temperatures of winding and housing \[K\].
    pub end_k: [f64; 2],
    /// Ranges of both temperatures over the last period \[K\].
    pub swing_k: [f64; 2],
    /// Mean temperature of the housing in operation \[K\].
    pub running_housing_k: f64,
    /// Total time in operation \[s\].
    pub running_s: f64,
    /// Number of cycles of the motion.
    pub cycles: f64,
    /// Number of starts from rest, which are cycles of the temperature.
    pub starts: u32,
    /// Heat generated in winding and housing \[J\].
    pub lost_j: [f64; 2],
    /// Energy from the supply \[J\].
    pub supplied_j: f64,
}

/// Periods of the current loop between two evaluations of the winding in a cycle: 10 ms.
const LOOKED_AT: u64 = 160;

/// Upper limit of a step \[s\], and as a share of the fast time constant.
const STEP_S: f64 = 60.0;
const STEP_SHARE: f64 = 0.25;

/// Mean powers of a cycle at one temperature of the housing.
#[derive(Clone, Copy, Debug)]
struct Node {
    housing_k: f64,
    /// Copper loss over the resistance \[A²\], heat in the housing \[W\], power of the supply \[W\].
    powers: [f64; 3],
    /// Highest temperature of the winding within the cycle above its mean \[K\].
    ripple_k: f64,
}

/// Mean powers as polynomials of the temperature of the housing.
#[derive(Clone, Debug)]
struct Means {
    nodes: [Node; 3],
    period_s: f64,
}

impl Means {
    /// Runs two cycles at each of three temperatures of the housing; `None` if cancelled by the caller.
    fn of(setup: &Setup<'_>, settled_k: [f64; 2], goes_on: &mut dyn FnMut() -> bool) -> Result<Option<Self>, Fault> {
        let machine = Machine::of(setup.parameters, setup.switches, setup.seed)?;
        let cold = setup.ambient_k;
        let [hot, housing] = settled_k;
        // A minimum rise separates the three nodes.
        let rise = (housing - cold).max(3.0);
        // The second cycle is evaluated: the first begins with the DC link at the voltage of the supply.
        let scenario = Scenario { id: ScenarioId::Cycle, cycles: 2, ..setup.scenario };
        let mut nodes = [Node { housing_k: cold, powers: [0.0; 3], ripple_k: 0.0 }; 3];
        let mut period_s = 0.0;
        for (node, share) in nodes.iter_mut().zip([0.0, 0.5, 1.0]) {
            let start_k = [cold + share * (hot - cold), cold + share * rise];
            let mut twin = Twin::untripped(&Setup { start_k: Some(start_k), scenario, ..*setup })?;
            let first = twin.periods() / 2;
            // Sum, number and highest of the temperatures of the winding in the evaluated cycle.
            let mut winding = [0.0, 0.0, f64::NEG_INFINITY];
            let mut run = |until: u64, twin: &mut Twin<'_>| {
                winding = [0.0, 0.0, f64::NEG_INFINITY];
                let mut left = until;
                while left > 0 && !twin.is_over() {
                    if !goes_on() {
                        return None;
                    }
                    twin.advance(left.min(LOOKED_AT));
                    left = left.saturating_sub(LOOKED_AT);
                    let now = twin.sample().winding_k;
                    winding = [winding[0] + now, winding[1] + 1.0, winding[2].max(now)];
                }
                let (losses, time) = (twin.losses(), twin.time_s());
                let worked = [losses.copper_w * time, losses.friction_w * time, twin.summary().supplied_j];
                Some((worked, time, twin.sample()))
            };
            let Some((before, begin_s, begin)) = run(first, &mut twin) else { return Ok(None) };
            let Some((after, end_s, end)) = run(u64::MAX, &mut twin) else { return Ok(None) };
            period_s = end_s - begin_s;
            let [sum, count, highest] = winding;
            let ripple_k = (highest - sum / count.max(1.0)).max(0.0);
            let winding = f64::midpoint(begin.winding_k, end.winding_k);
            let mut powers = [0.0; 3];
            for (power, (after, before)) in powers.iter_mut().zip(after.iter().zip(before)) {
                *power = (after - before) / period_s;
            }
            powers[0] /= machine.resistance_ohm(winding);
            *node = Node { housing_k: f64::midpoint(begin.housing_k, end.housing_k), powers, ripple_k };
        }
        Ok(Some(Self { nodes, period_s }))
    }

    /// Returns mean losses and power of the supply \[W\] at temperatures, by Lagrange's polynomial through the three
    /// nodes.
    fn at(&self, machine: &Machine, winding_k: f64, housing_k: f64) -> (Losses, f64) {
        let mut powers = [0.0; 3];
        for (node, weight) in self.nodes.iter().zip(self.weights(housing_k)) {
            for (power, own) in powers.iter_mut().zip(node.powers) {
                *power += weight * own;
            }
        }
        let [square, friction_w, supplied] = powers;
        let copper_w = square * machine.resistance_ohm(winding_k);
        (Losses { copper_w: copper_w.max(0.0), friction_w: friction_w.max(0.0) }, supplied)
    }

    /// Returns Lagrange's weights of the three nodes.
    fn weights(&self, housing_k: f64) -> [f64; 3] {
        let [a, b, c] = &self.nodes;
        let weight = |own: &Node, one: &Node, two: &Node| {
            (housing_k - one.housing_k) * (housing_k - two.housing_k)
                / ((own.housing_k - one.housing_k) * (own.housing_k - two.housing_k))
        };
        [weight(a, b, c), weight(b, a, c), weight(c, a, b)]
    }

    /// Returns the highest temperature of the winding within a cycle above its mean \[K\].
    fn ripple_k(&self, housing_k: f64) -> f64 {
        let weighted = self.nodes.iter().zip(self.weights(housing_k)).map(|(node, weight)| weight * node.ripple_k);
        weighted.sum::<f64>().max(0.0)
    }
}

/// Transition of a network over one step under constant losses: x(t + Δt) = x_s + e^(A Δt) (x − x_s).
struct Stride<'a> {
    network: &'a Network,
    ambient: ThermodynamicTemperature,
    exponential: [[f64; 2]; 2],
}

impl<'a> Stride<'a> {
    fn of(network: &'a Network, ambient_k: f64, step_s: f64) -> Self {
        let ambient = ThermodynamicTemperature::from_si(ambient_k);
        let [quick, slow] = network.time_constants().map(|tau| -1.0 / tau.si());
        let at = |winding: f64, housing: f64| {
            let [winding, housing] = [winding, housing].map(|rise| ThermodynamicTemperature::from_si(ambient_k + rise));
            let flows = network.flows(&Temperatures { winding, housing }, Losses::default(), ambient);
            [flows.winding_k_per_s, flows.housing_k_per_s]
        };
        let columns = [at(1.0, 0.0), at(0.0, 1.0)];
        let [one, two] = [(quick * step_s).exp(), (slow * step_s).exp()];
        // Sylvester's formula for two eigenvalues.
        let cell = |row: usize, column: usize| {
            let a = columns.get(column).and_then(|each| each.get(row)).copied().unwrap_or(0.0);
            let unit = f64::from(u8::from(row == column));
            (one * (a - slow * unit) - two * (a - quick * unit)) / (quick - slow)
        };
        Self { network, ambient, exponential: [[cell(0, 0), cell(0, 1)], [cell(1, 0), cell(1, 1)]] }
    }

    fn step(&self, [winding, housing]: [f64; 2], losses: Losses) -> [f64; 2] {
        let steady = self.network.steady(losses, self.ambient);
        let [w, h] = [winding - steady.winding.si(), housing - steady.housing.si()];
        let [[a, b], [c, d]] = self.exponential;
        [steady.winding.si() + a * w + b * h, steady.housing.si() + c * w + d * h]
    }
}

/// Points of a period that a calculation by steps passes.
struct Marked {
    course: PeriodCourse,
    period_s: f64,
}

impl Marked {
    fn of(number: u32, period_s: f64, [winding_k, housing_k]: [f64; 2]) -> Self {
        let first = PeriodPoint { time_s: 0.0, winding_k, winding_peak_k: winding_k, housing_k };
        Self { course: PeriodCourse { number, points: vec![first] }, period_s }
    }

    /// Returns the time of the next point \[s\].
    #[allow(clippy::cast_precision_loss, reason = "a thousand")]
    fn next_s(&self) -> f64 {
        self.period_s * self.course.points.len() as f64 / f64::from(POINTS_OF_A_PERIOD)
    }

    fn push(&mut self, time_s: f64, [winding_k, housing_k]: [f64; 2], ripple_k: f64) {
        self.course.points.push(PeriodPoint { time_s, winding_k, winding_peak_k: winding_k + ripple_k, housing_k });
    }

    /// Adds the points within a step, whose state is that of constant losses since its beginning.
    fn pass(&mut self, [from_s, until_s]: [f64; 2], ripple_k: impl Fn(f64) -> f64, state: impl Fn(f64) -> [f64; 2]) {
        // The sum of the steps may miss the end of a part by rounding.
        let until_s = until_s + 1e-6 * (until_s - from_s);
        while self.next_s() <= until_s && !self.is_complete() {
            let time_s = self.next_s();
            let now = state((time_s - from_s).max(0.0));
            self.push(time_s, now, ripple_k(now[1]));
        }
    }

    const fn is_complete(&self) -> bool {
        self.course.points.len() > POINTS_OF_A_PERIOD as usize
    }

    /// Returns the course with its last point, which the sum of the steps may miss by rounding.
    fn finished(mut self, state: [f64; 2]) -> PeriodCourse {
        if !self.is_complete() {
            let ripple_k = self.course.points.last().map_or(0.0, |last| last.winding_peak_k - last.winding_k);
            self.push(self.next_s(), state, ripple_k);
        }
        self.course
    }
}

/// Computes temperatures and energies of operation over days from cold, from the mean losses of a cycle at the
/// temperatures of each minute.
///
/// x' = A x + B P(ϑ_w, ϑ_h), P the means of a cycle at three temperatures; steps of at most a minute, exact for
/// constant P, P at the middle of the step
///
/// # Source
/// docs/theory/twin.md; the network of docs/theory/thermal.md
/// # Valid
/// cycles short compared with τ_w; within a longer one the winding temperature varies as in the simulation of one cycle
/// # Errors
/// [`Fault`] of [`Twin::new`]; `Ok(None)` if cancelled by the caller or if the actuator has no heat model
pub fn averaged(
    setup: &Setup<'_>,
    operation: Operation,
    mut goes_on: impl FnMut() -> bool,
) -> Result<Option<Averaged>, Fault> {
    let Ok(heat) = HeatModel::of(&setup.parameters.actuator) else { return Ok(None) };
    let Some(settled_k) = settled(setup, &mut goes_on)? else { return Ok(None) };
    let Some(means) = Means::of(setup, settled_k, &mut goes_on)? else { return Ok(None) };
    let machine = Machine::of(setup.parameters, setup.switches, setup.seed)?;
    let network = heat.network();
    let [quick, _] = network.time_constants().map(|tau| tau.si());
    let most = STEP_S.min(STEP_SHARE * quick);
    let Operation { periods, period_s, .. } = operation;
    let running_s = operation.running_s.min(period_s).max(0.0);
    let mut state = setup.start_k.unwrap_or([setup.ambient_k; 2]);
    let mut found = Averaged {
        courses: Vec::new(),
        peak_k: state,
        end_k: state,
        swing_k: [0.0; 2],
        running_housing_k: 0.0,
        running_s: f64::from(periods) * running_s,
        cycles: f64::from(periods) * running_s / means.period_s,
        starts: if running_s < period_s { periods } else { u32::from(periods > 0) },
        lost_j: [0.0; 2],
        supplied_j: 0.0,
    };
    // Both parts of a period are divided into whole steps.
    let parts = [(running_s, true), (period_s - running_s, false)].map(|(time, runs)| {
        let count = (time / most).ceil();
        let step = if count > 0.0 { time / count } else { 0.0 };
        (count, step, runs, Stride::of(network, setup.ambient_k, step))
    });
    for number in 1..=periods {
        if !goes_on() {
            return Ok(None);
        }
        let mut course = (number == 1 || number == periods).then(|| Marked::of(number, period_s, state));
        let mut time_s = 0.0;
        let mut span = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for (count, step, runs, stride) in &parts {
            let mut left = *count;
            while left > 0.0 {
                left -= 1.0;
                let of = |[winding, housing]: [f64; 2]| {
                    if *runs { means.at(&machine, winding, housing) } else { (Losses::default(), 0.0) }
                };
                // Losses at the middle of the step, from a trial step with those at its start.
                let first = stride.step(state, of(state).0);
                let middle = [0, 1].map(|k| {
                    let at = |of: &[f64; 2]| of.get(k).copied().unwrap_or_default();
                    f64::midpoint(at(&state), at(&first))
                });
                let (losses, supplied) = of(middle);
                if let Some(course) = &mut course {
                    let ripple_k = |housing_k: f64| if *runs { means.ripple_k(housing_k) } else { 0.0 };
                    course.pass([time_s, time_s + step], ripple_k, |since_s| {
                        Stride::of(network, setup.ambient_k, since_s).step(state, losses)
                    });
                    time_s += step;
                }
                state = stride.step(state, losses);
                found.lost_j[0] += losses.copper_w * step;
                found.lost_j[1] += losses.friction_w * step;
                found.supplied_j += supplied * step;
                if *runs {
                    found.running_housing_k += middle[1] * step / found.running_s;
                }
                for ((span, peak), now) in span.iter_mut().zip(&mut found.peak_k).zip(state) {
                    *span = [span[0].min(now), span[1].max(now)];
                    *peak = peak.max(now);
                }
            }
        }
        found.courses.extend(course.map(|course| course.finished(state)));
        found.end_k = state;
        found.swing_k = span.map(|[low, high]| high - low);
    }
    Ok(Some(found))
}
