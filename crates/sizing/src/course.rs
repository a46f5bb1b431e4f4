//! The cycle as time series for pictures and tables; the checks use the trace instead.

use crate::axis::Axis;
use crate::brake_times::carried;
use crate::currents::{Currents, coil_loss};
use crate::electrics::Electrics;
use crate::energy::CyclePower;
use crate::flange::output;
use crate::heat_checks::rise_scale;
use actuator::{Losses, Parameters};
use mechanism::{Extra, Output};
use quantities::{Measure, Ratio, Time, Torque};
use trace::Node;

/// Number of samples in one piece of a law.
const PER_PIECE: u32 = 32;

/// Number of samples within a window: more than a picture has columns.
const PER_WINDOW: f64 = 1000.0;

/// Largest number of samples in one piece, for any window.
const PER_PIECE_MOST: f64 = 16_384.0;

/// Largest number of recorded intervals that are evaluated one by one.
const SEEN_MOST: usize = 1 << 17;

/// Number of groups of adjacent intervals above that: more than a picture has columns.
const GROUPS: usize = 1 << 14;

/// One instant of the cycle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// Instant \[s\].
    pub time_s: f64,
    /// Position of the output \[rad\].
    pub position_rad: f64,
    /// Speed [rad/s].
    pub speed_rad_s: f64,
    /// Acceleration [rad/s²].
    pub acceleration_rad_s2: f64,
    /// Torque of the actuator, its own inertia included \[Nm\].
    pub torque_nm: f64,
    /// Motor current, signed like the torque, rms \[A\].
    pub current_a: Option<f64>,
    /// Electrical power at the motor terminals \[W\].
    pub power_w: Option<f64>,
    /// Winding temperature in the steady cycle \[K\].
    pub winding_k: Option<f64>,
    /// Housing temperature in the steady cycle \[K\].
    pub housing_k: Option<f64>,
    /// Overload integral in the steady cycle.
    pub overload: Option<f64>,
}

/// The cycle of an axis on one actuator.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Course {
    /// Instants in their order; two of equal time at a jump.
    pub samples: Vec<Sample>,
    /// Duration \[s\].
    pub duration_s: f64,
}

impl Course {
    /// Computes the cycle of an axis on an actuator, with every sample of its recordings; quantities with unknown data
    /// are left out.
    #[must_use]
    pub fn of(axis: &Axis, actuator: &Parameters) -> Self {
        Self::sampled(axis, actuator, (&|_, _| PER_PIECE, &|_| 1))
    }

    /// Computes the cycle for a picture, or for a picture of a time window \[s\]: with so many samples there that the
    /// picture shows no corners of its own. Adjacent intervals of long recordings form groups with their first and last
    /// instant and those with the smallest and the largest values; temperatures and overload are computed from all
    /// intervals.
    #[must_use]
    pub fn seen(axis: &Axis, actuator: &Parameters, window: Option<(f64, f64)>) -> Self {
        let is_outside = |start: f64, end: f64| window.is_some_and(|(from, until)| start > until || end < from);
        let parts = |start: f64, duration: f64| {
            let Some((from, until)) = window.filter(|_| !is_outside(start, start + duration)) else { return PER_PIECE };
            let parts = PER_WINDOW * duration / (until - from);
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to thousands")]
            let parts = parts.clamp(f64::from(PER_PIECE), PER_PIECE_MOST) as u32;
            parts
        };
        let [mut all, mut inside] = [0, 0];
        for placed in axis.motion.recordings() {
            all += placed.intervals();
            inside += (0..placed.intervals())
                .filter_map(|index| placed.interval(index))
                .filter(|interval| !is_outside(interval.start_s, interval.start_s + interval.duration_s))
                .count();
        }
        let group = |count: usize| if count > SEEN_MOST { count.div_ceil(GROUPS) } else { 1 };
        let [all, inside] = [all, inside].map(group);
        Self::sampled(axis, actuator, (&parts, &|start| if is_outside(start, start) { all } else { inside }))
    }

    /// Returns an upper bound of the number of instants of [`Course::of`], without evaluating them.
    #[must_use]
    pub fn instants_most(axis: &Axis) -> usize {
        instants_of_laws(axis, PER_PIECE)
            + axis.motion.recordings().iter().map(|placed| 2 * placed.intervals()).sum::<usize>()
    }

    /// Samples the cycle; `parts`: number of parts of a piece by its beginning and its duration \[s\]; `group`: number
    /// of recorded intervals from an instant on that form a group.
    fn sampled(axis: &Axis, actuator: &Parameters, fine: Fineness<'_>) -> Self {
        let braked = axis.braked_by(&actuator.brake);
        let axis = braked.as_deref().unwrap_or(axis);
        let inertia = actuator.inertia_out.known().map_or(0.0, |own| own.value.si());
        let stall = actuator.stall_current.known().map(|stall| stall.value.si());
        let electrics = Electrics::of(axis, actuator);
        let currents = Currents::of(axis, actuator, &electrics);
        let power = CyclePower::of(actuator, currents.as_ref());
        let mut gathered = Gathered::default();
        instants(axis, fine, &mut |_, position_rad, node, waits| {
            let current = currents.as_ref().ok().map(|currents| currents.at(node));
            let losses = currents.as_ref().ok().and_then(|currents| currents.losses(node)).unwrap_or_default();
            let square = current.zip(stall).map_or(0.0, |(current, stall)| (current / stall).powi(2));
            let sample = Sample {
                time_s: node.time_s,
                position_rad,
                speed_rad_s: node.speed_rad_s,
                acceleration_rad_s2: node.acceleration_rad_s2,
                torque_nm: inertia * node.acceleration_rad_s2 + node.load_nm,
                current_a: current,
                power_w: power.as_ref().ok().map(|power| power.at(node)),
                ..Sample::default()
            };
            gathered.take(sample, [losses.copper_w, losses.friction_w, square], waits);
        });
        let Gathered { mut samples, means, .. } = gathered;
        if let Ok(currents) = &currents {
            heat(&mut samples, &means, axis, actuator, currents);
            overload(&mut samples, &means, actuator);
        }
        Self { samples, duration_s: axis.motion.duration().si() }
    }
}

/// Number of parts of a piece by its beginning and its duration \[s\], and number of recorded intervals from an instant
/// on that form a group.
pub(crate) type Fineness<'f> = (&'f dyn Fn(f64, f64) -> u32, &'f dyn Fn(f64) -> usize);

/// Copper loss and friction \[W\] and the square of the current as a share of I_0.
type Rates = [f64; 3];

/// Buffer of the instants of a course.
#[derive(Default)]
struct Gathered {
    samples: Vec<Sample>,
    /// Means from each sample to the next.
    means: Vec<Rates>,
    /// Incomplete group.
    waiting: Vec<(Sample, Rates)>,
    /// Last instant, kept or not \[s\].
    before: Option<(f64, Rates)>,
    /// ∫ dt since the last kept sample, and the number of gaps.
    since: (Rates, usize),
}

impl Gathered {
    /// Adds the next instant, which waits for the rest of its group or completes it.
    fn take(&mut self, sample: Sample, rates: Rates, waits: bool) {
        if !waits && self.waiting.is_empty() {
            return self.pass(&sample, &rates, true);
        }
        self.waiting.push((sample, rates));
        if waits {
            return;
        }
        let group = std::mem::take(&mut self.waiting);
        let kept = kept(&group);
        let mut kept = kept.iter().copied().peekable();
        for (place, (sample, rates)) in group.iter().enumerate() {
            let is_kept = kept.next_if_eq(&place).is_some();
            self.pass(sample, rates, is_kept);
        }
        // The memory is reused for the next group.
        self.waiting = group;
        self.waiting.clear();
    }

    fn pass(&mut self, sample: &Sample, rates: &Rates, is_kept: bool) {
        let mut mean = *rates;
        if let Some((time, before)) = self.before {
            let duration = (sample.time_s - time).max(0.0);
            mean = std::array::from_fn(|k| 0.5 * (before.get(k).unwrap_or(&0.0) + rates.get(k).unwrap_or(&0.0)));
            self.since.0.iter_mut().zip(mean).for_each(|(sum, mean)| *sum += mean * duration);
            self.since.1 += 1;
        }
        self.before = Some((sample.time_s, *rates));
        if is_kept {
            if let Some(last) = self.samples.last() {
                let duration = sample.time_s - last.time_s;
                let several = self.since.1 > 1 && duration > 0.0;
                self.means.push(if several { self.since.0.map(|sum| sum / duration) } else { mean });
            }
            self.since = Default::default();
            self.samples.push(*sample);
        }
    }
}

/// Returns the indices of the first and the last instant of a group and of those with the smallest and the largest
/// values, in order.
fn kept(group: &[(Sample, Rates)]) -> Vec<usize> {
    let signals: [fn(&Sample) -> f64; 6] = [
        |sample| sample.position_rad,
        |sample| sample.speed_rad_s,
        |sample| sample.acceleration_rad_s2,
        |sample| sample.torque_nm,
        |sample| sample.current_a.unwrap_or(0.0),
        |sample| sample.power_w.unwrap_or(0.0),
    ];
    let mut places = vec![0, group.len().saturating_sub(1)];
    for signal in signals.iter().filter(|_| group.len() > 2) {
        let values = || group.iter().map(|(sample, _)| signal(sample)).enumerate();
        places.extend(values().min_by(|(_, a), (_, b)| a.total_cmp(b)).map(|(place, _)| place));
        places.extend(values().max_by(|(_, a), (_, b)| a.total_cmp(b)).map(|(place, _)| place));
    }
    places.sort_unstable();
    places.dedup();
    places
}

/// Returns an upper bound of the number of instants of the pieces of the laws, each in so many parts.
pub(crate) fn instants_of_laws(axis: &Axis, parts: u32) -> usize {
    let of_piece = |piece: &motion::Piece| {
        // A rest has two ends, and the brake closes and opens in it; elsewhere a reversal has two instants.
        if piece.is_rest() { 6 } else { parts as usize + 1 + 2 * piece.reversals().len() }
    };
    axis.motion.pieces().iter().map(of_piece).sum()
}

/// Visits the samples of the pieces of the laws and of the recordings, in order of time: index of the segment, position
/// \[rad\], the instant, and whether it waits for the rest of its group.
pub(crate) fn instants(axis: &Axis, (parts, group): Fineness<'_>, look: &mut impl FnMut(usize, f64, &Node, bool)) {
    let none = Extra::none();
    let extra = |segment: usize| axis.extras.get(segment).unwrap_or(&none);
    let mut recordings = axis.motion.recordings().iter().peekable();
    let recorded = |placed: &motion::Placed, look: &mut dyn FnMut(usize, f64, &Node, bool)| {
        let count = placed.intervals();
        let (mut left, mut is_group) = (0, false);
        for (index, interval) in (0..count).filter_map(|index| Some((index, placed.interval(index)?))) {
            if left == 0 {
                left = group(interval.start_s).clamp(1, count - index);
                is_group = left > 1;
            }
            left -= 1;
            let acceleration = interval.acceleration_rad_s2();
            let [first, last] = interval.speed_rad_s;
            let direction = if first + last == 0.0 { 0.0 } else { (first + last).signum() };
            for u in [0.0, 1.0] {
                let (position, speed, torque) = interval.at(u);
                let output =
                    Output { position_rad: position, speed_rad_s: speed, acceleration_rad_s2: acceleration, direction };
                let extra = extra(placed.segment);
                let extra = Extra { torque: extra.torque + Torque::from_si(torque), ..*extra };
                let time = interval.start_s + u * interval.duration_s;
                let load = axis.mechanism.torque(&output, &extra);
                look(
                    placed.segment,
                    position,
                    &Node {
                        time_s: time,
                        weight_s: 0.0,
                        acceleration_rad_s2: acceleration,
                        speed_rad_s: speed,
                        direction,
                        load_nm: load,
                    },
                    if u == 0.0 { is_group } else { left > 0 },
                );
            }
        }
    };
    let carried = carried(&axis.motion, axis.brake_times.as_ref());
    for piece in axis.motion.pieces() {
        while let Some(placed) = recordings.next_if(|placed| placed.start_s < piece.start_s) {
            recorded(placed, look);
        }
        let (rests, runs) = (piece.is_rest(), piece.runs());
        let parts = if rests { 1 } else { parts(piece.start_s, piece.duration_s) };
        let mut instants: Vec<f64> =
            (0..=parts).map(|part| piece.duration_s * f64::from(part) / f64::from(parts)).collect();
        instants.extend(piece.reversals().into_iter().flat_map(|t| [t, t]));
        let (closing, opens) = carried.get(piece.segment).map_or((0.0, 0.0), |own| own.ends(piece.duration_s));
        if rests {
            let inside = |t: &f64| *t > 0.0 && *t < piece.duration_s;
            instants.extend([closing, opens].into_iter().filter(inside).flat_map(|t| [t, t]));
        }
        instants.sort_by(f64::total_cmp);
        for (index, t) in instants.iter().enumerate() {
            // On both sides of a reversal the direction is that of the adjacent instant away from it.
            let neighbour = |at: Option<usize>| at.and_then(|at| instants.get(at)).filter(|other| *other != t);
            let other = neighbour(index.checked_sub(1)).or_else(|| neighbour(Some(index + 1))).unwrap_or(t);
            let middle = 0.5 * (t + other);
            let output = output(piece, *t, runs.direction(middle));
            let held = rests && middle >= closing && middle <= opens && closing < opens;
            let load = if held { 0.0 } else { axis.mechanism.torque(&output, extra(piece.segment)) };
            look(
                piece.segment,
                output.position_rad,
                &Node {
                    time_s: piece.start_s + t,
                    weight_s: 0.0,
                    acceleration_rad_s2: output.acceleration_rad_s2,
                    speed_rad_s: output.speed_rad_s,
                    direction: output.direction,
                    load_nm: load,
                },
                false,
            );
        }
    }
    for placed in recordings {
        recorded(placed, look);
    }
}

/// Returns the durations from one sample to the next; that of the last is zero.
fn gaps(samples: &[Sample]) -> Vec<f64> {
    let next = samples.iter().skip(1).map(|sample| sample.time_s);
    let last = samples.last().map(|sample| sample.time_s);
    samples.iter().zip(next.chain(last)).map(|(sample, next)| (next - sample.time_s).max(0.0)).collect()
}

/// Sets the temperatures of winding and housing, by the network, losses and scale of the check on the winding; the coil
/// of an open brake heats the housing by its mean loss.
fn heat(samples: &mut [Sample], means: &[Rates], axis: &Axis, actuator: &Parameters, currents: &Currents) {
    let Ok((model, _)) = currents.heat() else { return };
    let ambient = axis.ambient.unwrap_or_else(|| model.ambient_reference());
    let coil_w = coil_loss(axis, actuator).si();
    let scale = rise_scale(axis, actuator, currents);
    let pieces: Vec<(Time, Losses)> = gaps(samples)
        .into_iter()
        .zip(means.iter().chain(std::iter::once(&[0.0; 3])))
        .map(|(duration, [copper_w, friction_w, _])| {
            (Time::from_si(duration), Losses { copper_w: *copper_w, friction_w: *friction_w + coil_w })
        })
        .collect();
    for (sample, found) in samples.iter_mut().zip(model.network().course(&pieces, ambient)) {
        sample.winding_k = Some(ambient.si() + scale * (found.winding.si() - ambient.si()));
        sample.housing_k = Some(found.housing.si());
    }
}

fn overload(samples: &mut [Sample], means: &[Rates], actuator: &Parameters) {
    let known = actuator.stall_current.known().zip(actuator.heat.winding_time_constant.known());
    let Some((_, tau)) = known else { return };
    let pieces: Vec<(Time, Ratio)> = gaps(samples)
        .into_iter()
        .zip(means.iter().chain(std::iter::once(&[0.0; 3])))
        .map(|(duration, [.., square])| (Time::from_si(duration), Ratio::from_si(*square)))
        .collect();
    let course = actuator::overload_course(&pieces, tau.value);
    for (sample, found) in samples.iter_mut().zip(course) {
        sample.overload = Some(found.si());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mechanism::Mechanism;
    use motion::{Closing, ManualMove, Motion, SegmentSpec};
    use quantities::{AngularVelocity, MomentOfInertia};

    #[test]
    fn the_course_is_that_of_the_trace() {
        let s = Time::from_si;
        let only = SegmentSpec::Manual(ManualMove {
            speed: AngularVelocity::from_si(4.0),
            accelerate: s(0.1),
            run: s(0.3),
            brake: s(0.2),
            pause: s(1.0),
        });
        let motion = Motion::new(&[only], None, Closing::Speed).unwrap();
        let load = Mechanism::direct(MomentOfInertia::from_si(1.0), Torque::from_si(5.0));
        let axis = Axis::new(load, motion, Vec::new());
        let course = Course::of(&axis, &Parameters::unknown());
        let peak = course.samples.iter().map(|sample| sample.torque_nm).fold(0.0, f64::max);
        assert!((peak - 45.0).abs() < 1e-12, "{peak}");
        let square: f64 = course
            .samples
            .windows(2)
            .map(|pair| {
                let (a, b) = (pair[0].torque_nm, pair[1].torque_nm);
                (pair[1].time_s - pair[0].time_s) * (a * a + a * b + b * b) / 3.0
            })
            .sum();
        assert!((square - axis.trace.gram().square([0.0, 1.0, 0.0, 0.0])).abs() < 1e-9);
        assert!((course.duration_s - 1.6).abs() < 1e-12);
        let travelled = course.samples.last().unwrap().position_rad;
        assert!((travelled - axis.moments().angle_travelled.si()).abs() < 1e-12);
        assert!(course.samples.windows(2).all(|pair| pair[1].time_s >= pair[0].time_s));
    }
}
