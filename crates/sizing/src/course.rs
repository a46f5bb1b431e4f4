//! The cycle as time series, for pictures and tables: what is judged is the trace, this is how it looks.

use crate::axis::Axis;
use crate::brake_times::carried_in;
use crate::currents::Currents;
use crate::electrics::Electrics;
use crate::energy::CyclePower;
use actuator::{Losses, Parameters};
use mechanism::{Extra, Output};
use quantities::{Measure, Ratio, Time, Torque};
use trace::Node;

/// Samples in one piece of a law.
const PER_PIECE: u32 = 32;

/// Samples within a window that is looked at by itself: more than a picture has columns.
const PER_WINDOW: f64 = 1000.0;

/// Samples in one piece, however small a part of it is looked at.
const PER_PIECE_MOST: f64 = 16_384.0;

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
    /// Winding in the steady cycle \[K\].
    pub winding_k: Option<f64>,
    /// Housing in the steady cycle \[K\].
    pub housing_k: Option<f64>,
    /// Overload integral in the steady cycle.
    pub overload: Option<f64>,
}

/// The cycle of an axis on one actuator.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Course {
    /// The instants in their order; two of the same time where something jumps.
    pub samples: Vec<Sample>,
    /// Instants at which the segments begin \[s\].
    pub borders_s: Vec<f64>,
    /// Duration \[s\].
    pub duration_s: f64,
}

impl Course {
    /// The cycle of an axis on an actuator; quantities whose data are not known are left out.
    #[must_use]
    pub fn of(axis: &Axis, actuator: &Parameters) -> Self {
        Self::sampled(axis, actuator, &|_, _| PER_PIECE)
    }

    /// The same with so many samples between two instants \[s\] that a picture of that time alone shows no corner which the law
    /// has not.
    #[must_use]
    pub fn within(axis: &Axis, actuator: &Parameters, (from, until): (f64, f64)) -> Self {
        Self::sampled(axis, actuator, &|start, duration| {
            if start > until || start + duration < from {
                return PER_PIECE;
            }
            let parts = PER_WINDOW * duration / (until - from);
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to thousands")]
            let parts = parts.clamp(f64::from(PER_PIECE), PER_PIECE_MOST) as u32;
            parts
        })
    }

    /// `parts`: of a piece with its beginning and its duration \[s\].
    fn sampled(axis: &Axis, actuator: &Parameters, parts: &dyn Fn(f64, f64) -> u32) -> Self {
        let inertia = actuator.inertia_out.known().map_or(0.0, |own| own.value.si());
        let electrics = Electrics::of(axis, actuator);
        let currents = Currents::of(axis, actuator, &electrics);
        let power = CyclePower::of(actuator, currents.as_ref());
        let mut samples = Vec::new();
        let mut losses = Vec::new();
        instants(axis, parts, &mut |position_rad, node| {
            samples.push(Sample {
                time_s: node.time_s,
                position_rad,
                speed_rad_s: node.speed_rad_s,
                acceleration_rad_s2: node.acceleration_rad_s2,
                torque_nm: inertia * node.acceleration_rad_s2 + node.load_nm,
                current_a: currents.as_ref().ok().map(|currents| currents.at(node)),
                power_w: power.as_ref().ok().map(|power| power.at(node)),
                ..Sample::default()
            });
            losses.extend(currents.as_ref().ok().and_then(|currents| currents.losses(node)));
        });
        if let Ok(currents) = &currents {
            heat(&mut samples, &losses, axis, currents);
            overload(&mut samples, actuator);
        }
        Self {
            samples,
            borders_s: axis.motion.stretches().iter().map(|stretch| stretch.start.si()).collect(),
            duration_s: axis.motion.duration().si(),
        }
    }
}

/// The pieces of the laws, sampled, and the samples of the recordings, in the order of time.
fn instants(axis: &Axis, parts: &dyn Fn(f64, f64) -> u32, look: &mut impl FnMut(f64, &Node)) {
    let none = Extra::none();
    let extra = |segment: usize| axis.extras.get(segment).unwrap_or(&none);
    let mut recordings = axis.motion.recordings().iter().peekable();
    let recorded = |placed: &motion::Placed, look: &mut dyn FnMut(f64, &Node)| {
        for interval in (0..placed.intervals()).filter_map(|index| placed.interval(index)) {
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
                    position,
                    &Node {
                        time_s: time,
                        weight_s: 0.0,
                        acceleration_rad_s2: acceleration,
                        speed_rad_s: speed,
                        direction,
                        load_nm: load,
                    },
                );
            }
        }
    };
    for piece in axis.motion.pieces() {
        while let Some(placed) = recordings.next_if(|placed| placed.start_s < piece.start_s) {
            recorded(placed, look);
        }
        let (rests, runs) = (piece.is_rest(), piece.runs());
        let parts = if rests { 1 } else { parts(piece.start_s, piece.duration_s) };
        let mut instants: Vec<f64> =
            (0..=parts).map(|part| piece.duration_s * f64::from(part) / f64::from(parts)).collect();
        instants.extend(piece.reversals().into_iter().flat_map(|t| [t, t]));
        let (closing, opens) =
            carried_in(&axis.motion, piece.segment, axis.brake_times.as_ref()).ends(piece.duration_s);
        if rests {
            let inside = |t: &f64| *t > 0.0 && *t < piece.duration_s;
            instants.extend([closing, opens].into_iter().filter(inside).flat_map(|t| [t, t]));
        }
        instants.sort_by(f64::total_cmp);
        for (index, t) in instants.iter().enumerate() {
            let state = piece.at(*t);
            // On both sides of a reversal the direction is that of the neighbour away from it.
            let neighbour = |at: Option<usize>| at.and_then(|at| instants.get(at)).filter(|other| *other != t);
            let other = neighbour(index.checked_sub(1)).or_else(|| neighbour(Some(index + 1))).unwrap_or(t);
            let direction = runs.direction(0.5 * (t + other));
            let output = Output {
                position_rad: state.position_rad,
                speed_rad_s: state.speed_rad_s,
                acceleration_rad_s2: state.acceleration_rad_s2,
                direction,
            };
            let middle = 0.5 * (t + other);
            let held = rests && middle >= closing && middle <= opens && closing < opens;
            let load = if held { 0.0 } else { axis.mechanism.torque(&output, extra(piece.segment)) };
            look(
                state.position_rad,
                &Node {
                    time_s: piece.start_s + t,
                    weight_s: 0.0,
                    acceleration_rad_s2: state.acceleration_rad_s2,
                    speed_rad_s: state.speed_rad_s,
                    direction,
                    load_nm: load,
                },
            );
        }
    }
    for placed in recordings {
        recorded(placed, look);
    }
}

/// Durations from one sample to the next, the last to the end with none.
fn gaps(samples: &[Sample]) -> Vec<f64> {
    let next = samples.iter().skip(1).map(|sample| sample.time_s);
    let last = samples.last().map(|sample| sample.time_s);
    samples.iter().zip(next.chain(last)).map(|(sample, next)| (next - sample.time_s).max(0.0)).collect()
}

/// Means of a signal over the gaps.
fn means(values: &[f64]) -> impl Iterator<Item = f64> {
    values.iter().zip(values.iter().skip(1).chain(values.last())).map(|(a, b)| 0.5 * (a + b))
}

fn heat(samples: &mut [Sample], losses: &[Losses], axis: &Axis, currents: &Currents) {
    let Ok((model, _)) = currents.heat() else { return };
    if losses.len() != samples.len() {
        return;
    }
    let ambient = axis.ambient.unwrap_or_else(|| model.ambient_reference());
    let copper: Vec<f64> = losses.iter().map(|losses| losses.copper_w).collect();
    let friction: Vec<f64> = losses.iter().map(|losses| losses.friction_w).collect();
    let pieces: Vec<(Time, Losses)> = gaps(samples)
        .into_iter()
        .zip(means(&copper).zip(means(&friction)))
        .map(|(duration, (copper_w, friction_w))| (Time::from_si(duration), Losses { copper_w, friction_w }))
        .collect();
    for (sample, found) in samples.iter_mut().zip(model.network().course(&pieces, ambient)) {
        sample.winding_k = Some(found.winding.si());
        sample.housing_k = Some(found.housing.si());
    }
}

fn overload(samples: &mut [Sample], actuator: &Parameters) {
    let known = actuator.stall_current.known().zip(actuator.heat.winding_time_constant.known());
    let Some((stall, tau)) = known.map(|(stall, tau)| (stall.value.si(), tau.value)) else { return };
    let squares: Vec<f64> = samples.iter().filter_map(|sample| Some((sample.current_a? / stall).powi(2))).collect();
    if squares.len() != samples.len() {
        return;
    }
    let pieces: Vec<(Time, Ratio)> = gaps(samples)
        .into_iter()
        .zip(means(&squares))
        .map(|(duration, square)| (Time::from_si(duration), Ratio::from_si(square)))
        .collect();
    let course = actuator::overload_course(&pieces, tau);
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
        assert_eq!(course.borders_s, [0.0]);
        let travelled = course.samples.last().unwrap().position_rad;
        assert!((travelled - axis.moments().angle_travelled.si()).abs() < 1e-12);
        assert!(course.samples.windows(2).all(|pair| pair[1].time_s >= pair[0].time_s));
    }
}
