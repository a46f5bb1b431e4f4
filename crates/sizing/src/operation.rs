//! The cycle of an axis on one actuator, segment by segment: torque, speed, current, power and energy; the shaft of the motor; the
//! duty type. Nothing here is judged.

use crate::axis::Axis;
use crate::course::{instants, instants_of_laws};
use crate::currents::Currents;
use crate::electrics::Electrics;
use crate::energy::CyclePower;
use actuator::Parameters;
use quantities::Measure;
use trace::{Node, TorqueWith};

/// Parts in which a piece of a law is looked at, at most.
const PARTS_MOST: usize = 256;

/// Parts in which a piece of a law is looked at, at least.
const PARTS_LEAST: usize = 32;

/// Instants of all laws together beyond which a piece is looked at in fewer parts.
const INSTANTS: usize = 1 << 17;

/// Share of the largest value below which a torque, a speed or a power counts as none.
const NONE: f64 = 1e-9;

/// Share of the squared torque in acceleration and braking below which starting counts as insignificant for the heat.
const STARTING: f64 = 0.1;

/// The cycle on one actuator.
#[derive(Clone, Debug, PartialEq)]
pub struct Operation {
    /// The segments of the motion in their order.
    pub segments: Vec<SegmentLoad>,
    /// The whole cycle: maxima and effective values are those of the checks.
    pub cycle: SegmentLoad,
    /// Shaft of the motor; `None` without a ratio.
    pub motor: Option<MotorSide>,
    /// J_L: largest inertia of the load at the output \[kg m²\].
    pub inertia_load: f64,
    /// J_out: inertia of the actuator at the output \[kg m²\].
    pub inertia_own: f64,
    /// Duty type that the cycle corresponds to.
    pub duty: DutyType,
}

/// Load of the actuator within one segment.
///
/// # Symbols
/// T torque at the output with that of J_out, n output speed, I motor current (rms of a phase), P power at the motor terminals
/// # Source
/// docs/theory/moments.md, docs/theory/current.md, docs/theory/energy.md
/// # Valid
/// A current, power or energy belongs to one state of the gear: cold where the name says so, else that of the settled
/// cycle, with the winding at 20 °C as in the check of the regenerated power. The check of the peak current takes the larger
/// of both peaks. Between two of the 32 to 256 instants of a piece of a law, or of the samples of
/// a recording, torque, speed and current are taken as straight: the deviation is below 0.1 % of the largest value. The maxima of
/// the cycle are exact in the segment in which they occur.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SegmentLoad {
    /// Duration \[s\].
    pub duration_s: f64,
    /// max |T| \[Nm\]
    pub torque_peak_nm: f64,
    /// √(1/t ∫ T² dt) \[Nm\]
    pub torque_rms_nm: f64,
    /// max |ω| [rad/s]
    pub speed_peak_rad_s: f64,
    /// max |I| with the gear at the ambient temperature \[A\]; `None` where a datum of the current is not known.
    pub current_peak_cold_a: Option<f64>,
    /// max |I| in the settled cycle \[A\]
    pub current_peak_a: Option<f64>,
    /// √(1/t ∫ I² dt) \[A\]
    pub current_rms_a: Option<f64>,
    /// max P \[W\]; `None` where a datum of the power is not known.
    pub power_peak_w: Option<f64>,
    /// ∫ P dt where P > 0 \[J\]
    pub energy_taken_j: Option<f64>,
    /// −∫ P dt where P < 0 \[J\]
    pub energy_returned_j: Option<f64>,
}

/// Speed and torque at the shaft of the motor.
///
/// n_mot = i n, T_mot = k_TM I
///
/// # Source
/// cha-manual tables of technical data: i, k_TM
/// # Valid
/// T_mot is the torque in the air gap, friction of motor and gear included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorSide {
    /// i: reduction ratio.
    pub ratio: f64,
    /// Largest speed [rad/s].
    pub speed_peak_rad_s: f64,
    /// Mean of the magnitude of the speed [rad/s].
    pub speed_mean_rad_s: f64,
    /// Largest torque with the gear at the ambient temperature \[Nm\]; `None` where k_TM or the current is not known.
    pub torque_peak_cold_nm: Option<f64>,
    /// Largest torque in the settled cycle \[Nm\].
    pub torque_peak_nm: Option<f64>,
    /// Effective torque in the settled cycle \[Nm\].
    pub torque_rms_nm: Option<f64>,
}

/// Duty type to which the cycle corresponds.
///
/// # Source
/// IEC 60034-1, 4.2
/// # Valid
/// The cycle repeats without end. Types S2, S9 and S10 describe no repeated cycle and are not assigned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DutyType {
    /// S1: constant speed and torque without a rest.
    Continuous,
    /// S3: rests without current; acceleration and braking contribute less than a tenth of ∫ T² dt.
    Intermittent,
    /// S4: rests without current; acceleration contributes to the heat; no electric braking.
    WithStarting,
    /// S5: as S4, with electric braking.
    WithBraking,
    /// S6: no rest, constant speed, the torque changes.
    ContinuousLoadChanges,
    /// S7: no rest, starts and electric braking.
    ContinuousWithBraking,
    /// S8: no rest, the speed changes.
    SpeedChanges,
    /// S8: standstill in which the motor holds a torque, so that it is never without current.
    HeldAtStandstill,
}

/// Sums over one segment.
#[derive(Clone, Copy, Default)]
struct Sums {
    load: SegmentLoad,
    torque_square: f64,
    current_square: f64,
    taken: f64,
    returned: f64,
    /// ∫ T² dt while the speed changes.
    changing_square: f64,
    /// ∫ |T ω| dt while the actuator is driven \[J\].
    braked: f64,
    /// ∫ |T ω| dt \[J\].
    moved: f64,
    /// Time at rest without a torque \[s\].
    free_s: f64,
    slowest: Option<f64>,
    torque_range: Option<[f64; 2]>,
}

/// ∫ x² dt over a straight line from `a` to `b`.
fn square(a: f64, b: f64, duration: f64) -> f64 {
    duration * (a * a + a * b + b * b) / 3.0
}

/// Returns the number of parts in which each piece of a law is looked at.
fn parts(axis: &Axis) -> u32 {
    let parts = (INSTANTS / axis.motion.pieces().len().max(1)).clamp(PARTS_LEAST, PARTS_MOST);
    u32::try_from(parts).unwrap_or(1)
}

impl Operation {
    /// Returns an upper bound of the number of instants of the laws at which [`Operation::of`] looks, beside two of each interval of
    /// the recordings.
    #[must_use]
    pub fn instants_of_laws(axis: &Axis) -> usize {
        instants_of_laws(axis, parts(axis))
    }

    /// The cycle of an axis on an actuator; `None` if J_out is not known.
    #[must_use]
    pub fn of(axis: &Axis, actuator: &Parameters) -> Option<Self> {
        let braked = axis.braked_by(&actuator.brake);
        let axis = braked.as_deref().unwrap_or(axis);
        let inertia = actuator.inertia_out.known()?.value;
        let demand = axis.demand(inertia);
        let inertia = inertia.si();
        let electrics = Electrics::of(axis, actuator);
        let currents = Currents::of(axis, actuator, &electrics).ok();
        let power = currents.as_ref().and_then(|currents| CyclePower::of(actuator, Ok(currents)).ok());
        let peak_nm = demand.torque_peak.si();
        let walk = Walk { inertia, peak_nm, currents: currents.as_ref(), power: power.as_ref() };
        let mut sums = walk.sums(axis);
        let peaks = currents.as_ref().map(|currents| currents.peaks(axis));
        let cycle = walk.cycle(axis, &sums, peaks);
        // A maximum of the cycle is exact in its segment too.
        let torque = axis.trace.largest(&TorqueWith { inertia_kgm2: inertia }).1;
        walk.see(axis, &mut sums, torque, |load, value| load.torque_peak_nm = load.torque_peak_nm.max(value));
        if let Some([(cold, cold_at), (settled, settled_at)]) = peaks {
            walk.see(axis, &mut sums, cold_at, |load, _| {
                load.current_peak_cold_a = load.current_peak_cold_a.map(|known| known.max(cold));
            });
            walk.see(axis, &mut sums, settled_at, |load, _| {
                load.current_peak_a = load.current_peak_a.map(|known| known.max(settled));
            });
        }
        let (torque_peak_nm, torque_rms_nm) = (demand.torque_peak.si(), demand.torque_rms.si());
        let mut cycle = SegmentLoad { torque_peak_nm, torque_rms_nm, ..cycle };
        let duty = duty(axis, &sums);
        let mut segments: Vec<SegmentLoad> = sums.into_iter().map(|sums| sums.load).collect();
        to_the_cycle(&mut segments, &cycle, RMS);
        without_rounding(&mut segments, &mut cycle);
        let of_motor = |current: Option<f64>| {
            actuator.torque_constant_motor.known().zip(current).map(|(k, current)| k.value.si() * current)
        };
        let motor = actuator.ratio.known().map(|ratio| MotorSide {
            ratio: ratio.value,
            speed_peak_rad_s: ratio.value * demand.speed_peak.si(),
            speed_mean_rad_s: ratio.value * demand.speed_mean.si(),
            torque_peak_cold_nm: of_motor(cycle.current_peak_cold_a),
            torque_peak_nm: of_motor(cycle.current_peak_a),
            torque_rms_nm: of_motor(cycle.current_rms_a),
        });
        Some(Self { segments, cycle, motor, inertia_load: axis.moments.inertia_max.si(), inertia_own: inertia, duty })
    }

    /// Sets the energies of the cycle to those of the check of the regenerated power, whose integrals are exact \[J\].
    #[must_use]
    pub fn with_energies(mut self, [taken, returned]: [f64; 2]) -> Self {
        (self.cycle.energy_taken_j, self.cycle.energy_returned_j) = (Some(taken), Some(returned));
        to_the_cycle(&mut self.segments, &self.cycle, ENERGIES);
        without_rounding(&mut self.segments, &mut self.cycle);
        self
    }
}

/// Least magnitude of a value that is not zero, in SI.
const LEAST: f64 = 1e-12;

/// A value of a row; `None` if it is not known.
type Field = fn(&mut SegmentLoad) -> Option<&mut f64>;

/// A value of a row with its share in the cycle, which adds up over the segments, and the exponent of the value in it.
type Part = (Field, fn(&SegmentLoad, f64) -> f64, i32);

/// Effective values: the integrals of their squares add up.
const RMS: &[Part] = &[
    (|load| Some(&mut load.torque_rms_nm), |load, value| value * value * load.duration_s, 2),
    (|load| load.current_rms_a.as_mut(), |load, value| value * value * load.duration_s, 2),
];

/// Energies: they add up.
const ENERGIES: &[Part] = &[
    (|load| load.energy_taken_j.as_mut(), |_, value| value, 1),
    (|load| load.energy_returned_j.as_mut(), |_, value| value, 1),
];

/// Largest deviation of a sum over the instants from the exact integral that is attributed to the instants.
const OF_THE_INSTANTS: f64 = 0.01;

/// Sets the sum over the instants of the only segment that has a share to the exact integral of the cycle. Of several segments
/// it is not known in which the sum deviates.
fn to_the_cycle(segments: &mut [SegmentLoad], cycle: &SegmentLoad, parts: &[Part]) {
    for (field, share, exponent) in parts {
        let part = |load: &SegmentLoad| {
            let mut load = *load;
            field(&mut load).copied().map_or(0.0, |value| share(&load, value))
        };
        if segments.iter().filter(|load| part(load) > 0.0).count() != 1 {
            continue;
        }
        let factor = part(cycle) / segments.iter().map(part).sum::<f64>();
        if (factor - 1.0).abs() < OF_THE_INSTANTS {
            for value in segments.iter_mut().filter_map(field) {
                *value *= if *exponent == 2 { factor.sqrt() } else { factor };
            }
        }
    }
}

/// Sets values that only rounding distinguishes from zero to zero, in the segments and in the cycle alike, as the torque of an arm
/// that stands upright: below a share of the largest value of the same kind.
fn without_rounding(segments: &mut [SegmentLoad], cycle: &mut SegmentLoad) {
    let torques: [Field; 2] = [|load| Some(&mut load.torque_peak_nm), |load| Some(&mut load.torque_rms_nm)];
    let speeds: [Field; 1] = [|load| Some(&mut load.speed_peak_rad_s)];
    let currents: [Field; 3] = [
        |load| load.current_peak_cold_a.as_mut(),
        |load| load.current_peak_a.as_mut(),
        |load| load.current_rms_a.as_mut(),
    ];
    let powers: [Field; 1] = [|load| load.power_peak_w.as_mut()];
    let energies: [Field; 2] = [|load| load.energy_taken_j.as_mut(), |load| load.energy_returned_j.as_mut()];
    let kinds: [&[Field]; 5] = [&torques, &speeds, &currents, &powers, &energies];
    for kind in kinds {
        let mut largest = 0.0_f64;
        for row in segments.iter_mut().chain([&mut *cycle]) {
            for field in kind {
                largest = field(row).map_or(largest, |value| largest.max(value.abs()));
            }
        }
        let least = (NONE * largest).max(LEAST);
        for row in segments.iter_mut().chain([&mut *cycle]) {
            for field in kind {
                if let Some(value) = field(row).filter(|value| value.abs() <= least) {
                    *value = 0.0;
                }
            }
        }
    }
}

/// Data of the actuator for the walk over the cycle.
struct Walk<'w> {
    inertia: f64,
    /// Largest |T| of the cycle \[Nm\].
    peak_nm: f64,
    currents: Option<&'w Currents<'w>>,
    power: Option<&'w CyclePower<'w>>,
}

impl Walk<'_> {
    fn torque(&self, node: &Node) -> f64 {
        self.inertia * node.acceleration_rad_s2 + node.load_nm
    }

    /// The sums of every segment, its effective values among them.
    fn sums(&self, axis: &Axis) -> Vec<Sums> {
        let stretches = axis.motion.stretches();
        let mut sums = vec![Sums::default(); stretches.len()];
        let parts = parts(axis);
        let mut before: Option<(usize, Node)> = None;
        instants(axis, (&|_, _| parts, &|_| 1), &mut |segment, _, node, _| {
            if let Some(sums) = sums.get_mut(segment) {
                self.instant(sums, node);
                if let Some((_, last)) = before.filter(|(of, last)| *of == segment && node.time_s > last.time_s) {
                    self.gap(sums, &last, node);
                }
            }
            before = Some((segment, *node));
        });
        for (sums, stretch) in sums.iter_mut().zip(stretches) {
            let duration = stretch.duration.si();
            let root = |square: f64| (square / duration).max(0.0).sqrt();
            let load = &mut sums.load;
            load.duration_s = duration;
            load.torque_rms_nm = root(sums.torque_square);
            load.current_rms_a = self.currents.map(|_| root(sums.current_square));
            load.energy_taken_j = self.power.map(|_| sums.taken);
            load.energy_returned_j = self.power.map(|_| sums.returned);
        }
        sums
    }

    fn instant(&self, sums: &mut Sums, node: &Node) {
        let (torque, speed) = (self.torque(node), node.speed_rad_s.abs());
        let load = &mut sums.load;
        load.torque_peak_nm = load.torque_peak_nm.max(torque.abs());
        load.speed_peak_rad_s = load.speed_peak_rad_s.max(speed);
        let most = |known: Option<f64>, value: f64| Some(known.map_or(value, |known| known.max(value)));
        if let Some(currents) = self.currents {
            let [cold, settled] = currents.in_both_states(node).map(f64::abs);
            load.current_peak_cold_a = most(load.current_peak_cold_a, cold);
            load.current_peak_a = most(load.current_peak_a, settled);
        }
        if let Some(power) = self.power {
            load.power_peak_w = most(load.power_peak_w, power.at(node).max(0.0));
        }
        sums.slowest = Some(sums.slowest.map_or(speed, |known| known.min(speed)));
        let [low, high] = sums.torque_range.unwrap_or([torque; 2]);
        sums.torque_range = Some([low.min(torque), high.max(torque)]);
    }

    fn gap(&self, sums: &mut Sums, a: &Node, b: &Node) {
        let duration = b.time_s - a.time_s;
        let [from, to] = [a, b].map(|node| self.torque(node));
        let of_torque = square(from, to, duration);
        sums.torque_square += of_torque;
        if (b.speed_rad_s - a.speed_rad_s).abs() > 0.0 {
            sums.changing_square += of_torque;
        }
        let rests = |node: &Node| node.direction == 0.0 && node.speed_rad_s == 0.0 && node.acceleration_rad_s2 == 0.0;
        if rests(a) && rests(b) {
            let is_free = from.abs().max(to.abs()) <= NONE * self.peak_nm;
            sums.free_s += if is_free { duration } else { 0.0 };
        }
        let power = 0.5 * (from * a.speed_rad_s + to * b.speed_rad_s) * duration;
        sums.moved += power.abs();
        sums.braked -= power.min(0.0);
        if let Some(currents) = self.currents {
            sums.current_square += square(currents.at(a), currents.at(b), duration);
        }
        if let Some(power) = self.power {
            power.energies(a, b, |energy| {
                sums.taken += energy.max(0.0);
                sums.returned -= energy.min(0.0);
            });
        }
    }

    /// Maxima and sums of the whole cycle; the effective current by the integral of the whole cycle.
    fn cycle(&self, axis: &Axis, sums: &[Sums], peaks: Option<[(f64, Node); 2]>) -> SegmentLoad {
        let duration = axis.moments.duration.si();
        let most = |of: fn(&SegmentLoad) -> Option<f64>| sums.iter().filter_map(|sums| of(&sums.load)).reduce(f64::max);
        let sum = |of: fn(&SegmentLoad) -> Option<f64>| {
            self.power.map(|_| sums.iter().filter_map(|sums| of(&sums.load)).sum())
        };
        SegmentLoad {
            duration_s: duration,
            torque_peak_nm: 0.0,
            torque_rms_nm: 0.0,
            speed_peak_rad_s: axis.moments.speed_peak.si(),
            current_peak_cold_a: peaks.map(|[(cold, _), _]| cold),
            current_peak_a: peaks.map(|[_, (settled, _)]| settled),
            current_rms_a: self
                .currents
                .map(|currents| (axis.trace.gram().square(currents.settled_weights()) / duration).max(0.0).sqrt()),
            power_peak_w: most(|load| load.power_peak_w),
            energy_taken_j: sum(|load| load.energy_taken_j),
            energy_returned_j: sum(|load| load.energy_returned_j),
        }
    }

    /// Enters the value of an instant into the segment in which it lies.
    fn see(&self, axis: &Axis, sums: &mut [Sums], node: Node, mut enter: impl FnMut(&mut SegmentLoad, f64)) {
        // An instant between two segments belongs to the one that comes nearer to the value.
        let torque = self.torque(&node).abs();
        let slack = 1e-9 * axis.moments.duration.si();
        let touching = axis.motion.stretches().iter().zip(sums).filter(|(stretch, _)| {
            let (start, end) = (stretch.start.si(), stretch.start.si() + stretch.duration.si());
            node.time_s >= start - slack && node.time_s <= end + slack
        });
        if let Some((_, sums)) =
            touching.max_by(|(_, a), (_, b)| a.load.torque_peak_nm.total_cmp(&b.load.torque_peak_nm))
        {
            enter(&mut sums.load, torque);
        }
    }
}

/// The duty type of a cycle with these sums.
fn duty(axis: &Axis, sums: &[Sums]) -> DutyType {
    let sum = |of: fn(&Sums) -> f64| sums.iter().map(of).sum::<f64>();
    let peak = sums.iter().map(|sums| sums.load.torque_peak_nm).fold(0.0, f64::max);
    let fastest = axis.moments.speed_peak.si();
    let slowest = sums.iter().filter_map(|sums| sums.slowest).fold(f64::INFINITY, f64::min);
    let has_rest = axis.moments.moving.si() < axis.moments.duration.si() * (1.0 - NONE);
    // Until the brake has closed and while it opens the motor holds too: only without any rest free of torque it is never
    // without current.
    let holds = sum(|sums| sums.free_s) <= NONE * axis.moments.duration.si();
    let brakes = sum(|sums| sums.braked) > NONE * sum(|sums| sums.moved);
    // A load that is held all the time is a continuous one, at the speed zero.
    let only_holds = holds && fastest <= 0.0;
    if has_rest && !only_holds {
        let starting = sum(|sums| sums.changing_square) / sum(|sums| sums.torque_square);
        return match (holds, brakes) {
            (true, _) => DutyType::HeldAtStandstill,
            _ if starting < STARTING => DutyType::Intermittent,
            (_, true) => DutyType::WithBraking,
            (_, false) => DutyType::WithStarting,
        };
    }
    if fastest - slowest > NONE * fastest {
        let stops = slowest <= NONE * fastest;
        return if stops && brakes { DutyType::ContinuousWithBraking } else { DutyType::SpeedChanges };
    }
    let ranges = || sums.iter().filter_map(|sums| sums.torque_range);
    let low = ranges().map(|[low, _]| low).fold(f64::INFINITY, f64::min);
    let high = ranges().map(|[_, high]| high).fold(f64::NEG_INFINITY, f64::max);
    if high - low > NONE * peak { DutyType::ContinuousLoadChanges } else { DutyType::Continuous }
}

#[cfg(test)]
#[path = "operation_tests.rs"]
mod tests;
