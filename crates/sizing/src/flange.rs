//! The loads on the flange over the cycle: those that the user states for a segment, and those that follow from the
//! mechanism at every instant.

use crate::axis::{Axis, BearingDuty};
use mechanism::{Extra, FlangeForces, Mounting, Output};
use motion::Piece;
use numeric::{highest, lobatto, roots};
use provenance::Missing;
use quantities::{Force, Length, Measure, Time, Torque};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// Loads that follow from the mechanism.
#[derive(Clone, Debug, PartialEq)]
pub struct DerivedLoads {
    /// How the load sits on the flange.
    pub mounting: Mounting,
    /// The segments of the motion in which they act.
    pub acts: Vec<bool>,
}

/// A largest value and the instant at which it is reached; loads that do not change within a segment have the instant at
/// which the segment begins.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Peak {
    pub(crate) value: f64,
    pub(crate) at: f64,
}

impl Peak {
    fn see(&mut self, value: f64, at: f64) {
        if value > self.value {
            *self = Self { value, at };
        }
    }
}

/// The loads over the cycle for one place of the bearing and one exponent of its life.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct CycleLoads {
    /// F_r, F_a and M about the bearing's centre: the largest of any instant.
    pub(crate) radial: Peak,
    pub(crate) axial: Peak,
    pub(crate) moment: Peak,
    /// Averages of eq. 75.2 and 75.3: F_rav, F_aav \[N\].
    pub(crate) means: [f64; 2],
    /// The same averages of the moment of the mechanism, and of F_r (L_r + R) and F_a L_a of what the user states \[Nm\].
    pub(crate) mean_moments: [f64; 3],
}

/// What was worked out already.
#[derive(Clone, Debug, Default)]
pub(crate) struct Known(Arc<Found>);

#[derive(Debug, Default)]
struct Found {
    /// By R and B.
    loads: Mutex<Vec<KnownLoads>>,
    /// The instants within each piece of the motion at which a force along a line changes its sign: for every R and B the same.
    switches: OnceLock<Vec<Vec<f64>>>,
}

/// R and B bit by bit, and the loads for them.
type KnownLoads = ([u64; 2], CycleLoads);

impl Known {
    fn get(&self, key: [u64; 2], make: impl FnOnce() -> CycleLoads) -> CycleLoads {
        // One thread works a pair out, the others wait for it rather than do the same.
        let mut known = self.0.loads.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, loads)) = known.iter().find(|(of, _)| *of == key) {
            return *loads;
        }
        let loads = make();
        known.push((key, loads));
        loads
    }
}

impl BearingDuty {
    /// What is missing before the forces on the flange are known.
    pub(crate) fn forces_known(&self, axis: &Axis) -> Result<(), Missing> {
        if !self.has_loads {
            return Err(Missing { symbol: "bearing.radial_force" });
        }
        let missing = self.derived.as_ref().and_then(|derived| axis.mechanism.missing_for_forces(&derived.mounting));
        missing.map_or(Ok(()), |symbol| Err(Missing { symbol }))
    }

    /// What is missing before the tilting moment is known too.
    pub(crate) fn moment_known(&self, axis: &Axis) -> Result<(), Missing> {
        self.forces_known(axis)?;
        let Some(derived) = &self.derived else { return Ok(()) };
        let payload = axis.extras.iter().any(|extra| extra.mass.si() > 0.0);
        let missing = axis.mechanism.missing_for_moment(&derived.mounting, payload);
        missing.map_or(Ok(()), |symbol| Err(Missing { symbol }))
    }
}

impl Axis {
    /// The loads on the flange over the cycle with those of the mechanism; `None` where none follow from it.
    pub(crate) fn derived_loads(&self, offset: Length, exponent: f64) -> Option<CycleLoads> {
        let duty = self.bearing.as_ref()?;
        let derived = duty.derived.as_ref()?;
        if duty.forces_known(self).is_ok() && duty.moment_known(self).is_err() {
            // Without the moment there is no life: the peaks of the forces are all, for every bearing alike.
            let find =
                || Walk { only_forces: true, ..Walk::of(self, duty, derived, Length::from_si(0.0), 3.0) }.loads();
            return Some(self.flange_known.get([u64::MAX; 2], find));
        }
        let key = [offset.si().to_bits(), exponent.to_bits()];
        Some(self.flange_known.get(key, || Walk::of(self, duty, derived, offset, exponent).loads()))
    }

    /// The loads on the flange over the cycle where only stated ones count, found once for each place of the bearing.
    pub(crate) fn stated_loads(&self, offset: Length, exponent: f64, find: impl FnOnce() -> CycleLoads) -> CycleLoads {
        // A few loads are compared sooner than found again.
        if self.bearing.as_ref().is_none_or(|duty| duty.loads.len() <= FEW) {
            return find();
        }
        self.flange_known.get([offset.si().to_bits(), exponent.to_bits()], find)
    }

    /// The loads on the flange at instants over the cycle, for pictures: instant, F_r, F_a, and M for a place of the
    /// bearing. Within a segment of constant loads only its ends are returned.
    #[must_use]
    pub fn flange_course(&self, offset: Option<Length>) -> Vec<FlangeSample> {
        let Some(duty) = self.bearing.as_ref().filter(|duty| duty.forces_known(self).is_ok()) else {
            return Vec::new();
        };
        match &duty.derived {
            Some(derived) => {
                let mut walk = Walk::of(self, duty, derived, offset.unwrap_or_else(|| Length::from_si(0.0)), 3.0);
                walk.samples = Some(Vec::new());
                let known = duty.moment_known(self).is_ok() && offset.is_some();
                let samples = walk.sampled().into_iter();
                samples.map(|sample| FlangeSample { moment: sample.moment.filter(|_| known), ..sample }).collect()
            }
            None => {
                let stretches = self.motion.stretches().iter().zip(&duty.loads);
                let ends = stretches.flat_map(|(stretch, load)| {
                    let moment = offset.map(|offset| actuator::tilting_moment(load, offset));
                    [stretch.start, stretch.start + stretch.duration].map(|time| FlangeSample {
                        time,
                        radial: load.radial_force,
                        axial: load.axial_force,
                        moment,
                    })
                });
                ends.collect()
            }
        }
    }
}

impl Axis {
    /// Number of instants at which the loads on the flange are found in one walk over the cycle, for one bearing; zero where none follow
    /// from the mechanism. Cuts at reversals and changes of sign are not counted.
    #[must_use]
    pub fn flange_instants(&self) -> f64 {
        let Some(duty) = self.bearing.as_ref().filter(|duty| duty.forces_known(self).is_ok()) else { return 0.0 };
        let Some(derived) = &duty.derived else { return 0.0 };
        let walk = Walk::of(self, duty, derived, Length::from_si(0.0), 3.0);
        let of_piece = |piece: &Piece| {
            let parts = if piece.is_rest() { 0.0 } else { walk.parts(piece, piece.duration_s) };
            let whole = if walk.repeats(piece) { (piece.duration_s / walk.turn_s(piece)).floor() / 2.0 } else { 1.0 };
            1.0 + NODES as f64 * (parts / whole).ceil()
        };
        let of_recording = |placed: &motion::Placed| {
            let panel = walk.recorded_panel(placed, 1);
            let intervals = (0..placed.intervals()).filter_map(|index| placed.interval(index));
            intervals
                .map(|interval| walk.recorded_nodes(&interval, panel))
                .map(|(nodes, count)| nodes as f64 * count)
                .sum::<f64>()
        };
        let pieces: f64 = self.motion.pieces().iter().map(of_piece).sum();
        let recordings: f64 = self.motion.recordings().iter().map(of_recording).sum();
        pieces + recordings
    }
}

/// So many stated loads are few.
const FEW: usize = 8;

/// The loads on the flange at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlangeSample {
    /// Instant.
    pub time: Time,
    /// F_r
    pub radial: Force,
    /// F_a
    pub axial: Force,
    /// M about the bearing's centre; `None` where it is not known.
    pub moment: Option<Torque>,
}

/// A panel covers at most this angle of the load: sixteen nodes integrate powers of what turns once a revolution to near
/// the last bit.
const PANEL_ANGLE: f64 = std::f64::consts::FRAC_PI_6;

/// A panel covers at most this phase of the harmonic of its law.
const PANEL_PHASE: f64 = std::f64::consts::FRAC_PI_4;

/// So many panels of one piece at most, two thousand revolutions at changing speed. Beyond, a panel grows: up to a whole revolution
/// sixteen nodes still integrate to 10⁻⁶, over several they are samples of what repeats, whose mean errs by some 10⁻³.
const PANELS_FINE: f64 = 24_000.0;

/// So many panels of one piece at most where the loads do not depend on the position.
const PANELS_OF_A_LAW: f64 = 64.0;

/// So many panels of the intervals of a recording at most, beside one for each interval; beyond, they grow likewise.
const PANELS_RECORDED: f64 = 200_000.0;

/// Nodes of a panel.
const NODES: usize = 16;

/// An interval of a recording over which the load turns by less takes three nodes: Simpson's rule errs by less than 10⁻⁷.
const INTERVAL_ANGLE: f64 = 0.05;

/// So many intervals of a recording are shown at most.
const SAMPLES_SHOWN: usize = 20_000;

/// To so much of it a largest value between two nodes is found.
const CLOSE: f64 = 1e-12;

/// Averages under way: ∫|ω| x^B dt.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    travelled: f64,
    forces: [f64; 2],
    moments: [f64; 3],
}

/// One pass over the motion.
struct Walk<'a> {
    axis: &'a Axis,
    duty: &'a BearingDuty,
    derived: &'a DerivedLoads,
    offset: Length,
    exponent: f64,
    loads: CycleLoads,
    sums: Sums,
    samples: Option<Vec<FlangeSample>>,
    /// Whether neither moment nor averages are found.
    only_forces: bool,
}

/// F_r, F_a and M at one instant, and M of the mechanism alone.
type Values = ([f64; 3], f64);

impl<'a> Walk<'a> {
    fn of(axis: &'a Axis, duty: &'a BearingDuty, derived: &'a DerivedLoads, offset: Length, exponent: f64) -> Self {
        Self {
            axis,
            duty,
            derived,
            offset,
            exponent,
            loads: CycleLoads::default(),
            sums: Sums::default(),
            samples: None,
            only_forces: false,
        }
    }

    fn loads(mut self) -> CycleLoads {
        self.walk();
        let Sums { travelled, forces, moments } = self.sums;
        let mean = |sum: f64| if travelled > 0.0 { (sum / travelled).powf(1.0 / self.exponent) } else { 0.0 };
        CycleLoads { means: forces.map(mean), mean_moments: moments.map(mean), ..self.loads }
    }

    fn sampled(mut self) -> Vec<FlangeSample> {
        self.walk();
        self.samples.unwrap_or_default()
    }

    fn walk(&mut self) {
        let axis = self.axis;
        let pieces = axis.motion.pieces();
        let switches = axis.flange_known.0.switches.get_or_init(|| {
            let of = |piece| if self.repeats(piece) { Vec::new() } else { self.switches(piece) };
            pieces.iter().map(of).collect()
        });
        let mut recordings = axis.motion.recordings().iter().peekable();
        for (piece, switches) in pieces.iter().zip(switches) {
            while let Some(placed) = recordings.next_if(|placed| placed.start_s < piece.start_s) {
                self.recording(placed);
            }
            if piece.is_rest() { self.rest(piece) } else { self.piece(piece, switches) }
        }
        for placed in recordings {
            self.recording(placed);
        }
    }

    /// x^B; for the exponents of both types of bearing without logarithms.
    fn power(&self, x: f64) -> f64 {
        if self.exponent == 3.0 {
            x * x * x
        } else if self.exponent == 10.0 / 3.0 {
            x * x * x * x.cbrt()
        } else {
            x.powf(self.exponent)
        }
    }

    fn values(&self, segment: usize, output: &Output, recorded_nm: f64) -> Values {
        let none = Extra::none();
        let extra = self.axis.extras.get(segment).unwrap_or(&none);
        let forces = if self.derived.acts.get(segment).copied().unwrap_or(false) {
            self.axis.mechanism.flange_forces(output, extra, recorded_nm, &self.derived.mounting)
        } else {
            FlangeForces::default()
        };
        let [radial, axial, by_radial, by_axial] = self.stated(segment);
        let moment = if self.only_forces { 0.0 } else { forces.moment(self.offset) };
        ([forces.radial() + radial, forces.axial() + axial, moment + by_radial + by_axial], moment)
    }

    /// What the user states for a segment: F_r, F_a, F_r (L_r + R), F_a L_a.
    fn stated(&self, segment: usize) -> [f64; 4] {
        self.duty.loads.get(segment).map_or([0.0; 4], |load| {
            let (radial, axial) = (load.radial_force.si(), load.axial_force.si());
            let by_radial = radial * (load.radial_distance.si() + self.offset.si());
            [radial, axial, by_radial, axial * load.axial_distance.si()]
        })
    }

    /// Sees an instant; `weight`: |ω| dt under it.
    fn see(&mut self, segment: usize, time: f64, values: &Values, weight: f64) {
        let ([radial, axial, moment], of_mechanism) = *values;
        self.loads.radial.see(radial, time);
        self.loads.axial.see(axial, time);
        self.loads.moment.see(moment, time);
        if weight > 0.0 && !self.only_forces {
            let [_, _, by_radial, by_axial] = self.stated(segment);
            let add = |value: f64| if value == 0.0 { 0.0 } else { weight * self.power(value) };
            let (forces, moments) = ([radial, axial].map(add), [of_mechanism, by_radial, by_axial].map(add));
            self.sums.travelled += weight;
            self.sums.forces.iter_mut().zip(forces).for_each(|(sum, part)| *sum += part);
            self.sums.moments.iter_mut().zip(moments).for_each(|(sum, part)| *sum += part);
        }
        if let Some(samples) = &mut self.samples {
            samples.push(FlangeSample {
                time: Time::from_si(time),
                radial: Force::from_si(radial),
                axial: Force::from_si(axial),
                moment: Some(Torque::from_si(moment)),
            });
        }
    }

    fn rest(&mut self, piece: &Piece) {
        let values = self.values(piece.segment, &output(piece, 0.0, 0.0), 0.0);
        self.see(piece.segment, piece.start_s, &values, 0.0);
        if self.samples.is_some() {
            self.see(piece.segment, piece.start_s + piece.duration_s, &values, 0.0);
        }
    }

    /// Duration of one revolution of the load at the speed of the piece \[s\].
    fn turn_s(&self, piece: &Piece) -> f64 {
        std::f64::consts::TAU * self.axis.mechanism.stage_ratio() / piece.speed_rad_s.abs()
    }

    /// Whether the piece turns more than twice at constant speed under a load that turns with it: every revolution is the first
    /// one.
    fn repeats(&self, piece: &Piece) -> bool {
        let is_steady = piece.speed_degree() == Some(0) && self.turns_with_the_load(piece.segment);
        is_steady && piece.duration_s > 2.0 * self.turn_s(piece)
    }

    fn piece(&mut self, piece: &Piece, switches: &[f64]) {
        let parts = self.parts(piece, piece.duration_s);
        let mut cuts = piece.reversals();
        if !self.repeats(piece) {
            cuts.extend(switches);
        } else if self.samples.is_none() {
            let turn = self.turn_s(piece);
            let whole = (piece.duration_s / turn).floor();
            self.panels(piece, (0.0, turn), whole, (parts / whole).ceil());
            self.panels(piece, (whole * turn, piece.duration_s), 1.0, (parts / whole).ceil());
            return;
        } else {
            cuts.extend(self.switches(piece));
        }
        cuts.push(piece.duration_s);
        cuts.sort_by(f64::total_cmp);
        let mut from = 0.0;
        for to in cuts {
            if to - from > 1e-12 * piece.duration_s {
                self.panels(piece, (from, to), 1.0, (parts * (to - from) / piece.duration_s).ceil());
                from = to;
            }
        }
    }

    /// Number of panels of a piece or a part of it that lasts so long.
    fn parts(&self, piece: &Piece, duration: f64) -> f64 {
        let [amplitude, frequency, _] = piece.harmonic;
        let phase = if amplitude == 0.0 { 0.0 } else { frequency * duration / PANEL_PHASE };
        let speed = [0.0, 0.25, 0.5, 0.75, 1.0].map(|u| piece.at(u * piece.duration_s).speed_rad_s.abs());
        let angle = speed.into_iter().fold(0.0, f64::max) * duration / self.axis.mechanism.stage_ratio();
        // What does not depend on the position is as smooth as the law, but for the corner where one of two bounds becomes the larger.
        let most = if self.turns_with_the_load(piece.segment) { PANELS_FINE } else { PANELS_OF_A_LAW };
        let turning = (angle / PANEL_ANGLE).min(most);
        phase.max(turning).max(1.0).ceil()
    }

    /// Whether the loads change with the angle of the load at the same speed and acceleration: under an unbalanced load, a crank, a
    /// table, and where a payload hangs beside the axis.
    fn turns_with_the_load(&self, segment: usize) -> bool {
        let payload = self.axis.extras.get(segment).is_some_and(|extra| extra.mass.si() != 0.0);
        self.axis.mechanism.depends_on_position() || payload && self.axis.mechanism.stage.is_none()
    }

    /// Instants inside the piece at which a force along a line changes its sign.
    fn switches(&self, piece: &Piece) -> Vec<f64> {
        let none = Extra::none();
        let extra = self.axis.extras.get(piece.segment).unwrap_or(&none);
        let forces = |t: f64| {
            let sense = piece.at(t).speed_rad_s.signum();
            self.axis.mechanism.flange_switches(&output(piece, t, sense), extra, 0.0)
        };
        let mut found = Vec::new();
        if piece.is_rest() || forces(0.0).is_none() {
            return found;
        }
        let spans = (self.parts(piece, piece.duration_s) / 12.0).ceil().max(1.0);
        let span = piece.duration_s / spans;
        for which in 0..2 {
            let mut k = 0.0;
            while k < spans {
                let force = |t: f64| forces(k * span + t).and_then(|of| of.get(which).copied()).unwrap_or(0.0);
                found.extend(roots(force, span).into_iter().map(|t| k * span + t));
                k += 1.0;
            }
        }
        found
    }

    /// Panels between two instants of a piece that turns one way there; each counts `times` over.
    fn panels(&mut self, piece: &Piece, (from, to): (f64, f64), times: f64, count: f64) {
        let sense = piece.at(0.5 * (from + to)).speed_rad_s.signum();
        let length = (to - from) / count.max(1.0);
        let mut k = 0.0;
        while k < count.max(1.0) {
            let (start, end) = (from + k * length, from + (k + 1.0) * length);
            let mut nodes = [(0.0, [0.0; 3]); NODES];
            for ((u, weight), node) in lobatto(NODES).iter().zip(&mut nodes) {
                let t = start + u * (end - start);
                let output = output(piece, t, sense);
                let values = self.values(piece.segment, &output, 0.0);
                let travelled = times * weight * (end - start) * output.speed_rad_s.abs();
                self.see(piece.segment, piece.start_s + t, &values, travelled);
                *node = (t, values.0);
            }
            self.peaks_between(piece, sense, &nodes);
            k += 1.0;
        }
    }

    /// Looks between the nodes around an inner largest one, where the parabola through three says that it may pay.
    fn peaks_between(&mut self, piece: &Piece, sense: f64, nodes: &[(f64, [f64; 3]); NODES]) {
        for which in 0..3 {
            for trio in nodes.windows(3) {
                let [a, b, c] = trio else { continue };
                let [a, b, c] = [a, b, c].map(|(t, values)| (*t, values.get(which).copied().unwrap_or(0.0)));
                if b.1 < a.1 || b.1 < c.1 {
                    continue;
                }
                let best = [self.loads.radial, self.loads.axial, self.loads.moment].get(which).map_or(0.0, |p| p.value);
                let value = |t: f64| {
                    let (values, _) = self.values(piece.segment, &output(piece, t, sense), 0.0);
                    values.get(which).copied().unwrap_or(0.0)
                };
                let (t, found) = highest(value, [a, b, c], best, CLOSE);
                let peak = match which {
                    0 => &mut self.loads.radial,
                    1 => &mut self.loads.axial,
                    _ => &mut self.loads.moment,
                };
                peak.see(found, piece.start_s + t);
            }
        }
    }

    /// The angle by which the mechanism turns in an interval \[rad\].
    fn turned(&self, interval: &motion::Interval) -> f64 {
        let [first, last] = interval.speed_rad_s;
        first.abs().max(last.abs()) * interval.duration_s / self.axis.mechanism.stage_ratio()
    }

    /// The angle that a panel of a recording covers, of which every interval in so many is looked at \[rad\].
    fn recorded_panel(&self, placed: &motion::Placed, stride: usize) -> f64 {
        let intervals = (0..placed.intervals()).step_by(stride).filter_map(|index| placed.interval(index));
        let all: f64 = intervals.map(|interval| self.turned(&interval) / PANEL_ANGLE).sum();
        PANEL_ANGLE * (all / PANELS_RECORDED).max(1.0)
    }

    /// Nodes of each panel of an interval, and their number.
    fn recorded_nodes(&self, interval: &motion::Interval, panel: f64) -> (usize, f64) {
        let angle = self.turned(interval);
        (if angle < INTERVAL_ANGLE { 3 } else { NODES }, (angle / panel).ceil().max(1.0))
    }

    fn recording(&mut self, placed: &motion::Placed) {
        // A picture of a long recording needs no more instants than that.
        let stride = if self.samples.is_some() { placed.intervals().div_ceil(SAMPLES_SHOWN).max(1) } else { 1 };
        let panel = self.recorded_panel(placed, stride);
        for interval in (0..placed.intervals()).step_by(stride).filter_map(|index| placed.interval(index)) {
            let acceleration = interval.acceleration_rad_s2();
            let [first, last] = interval.speed_rad_s;
            let zero = if first * last < 0.0 { first / (first - last) } else { 1.0 };
            let (nodes, count) = self.recorded_nodes(&interval, panel);
            let ends = [(0.0, zero, if first == 0.0 { last } else { first }), (zero, 1.0, last)];
            for (from, to, speed) in ends.into_iter().filter(|(from, to, _)| to > from) {
                let sense = if speed == 0.0 { 0.0 } else { speed.signum() };
                let mut k = 0.0;
                while k < count {
                    let (start, length) = (from + k * (to - from) / count, (to - from) / count);
                    for (u, weight) in lobatto(nodes) {
                        let u = start + u * length;
                        let (position_rad, speed_rad_s, recorded) = interval.at(u);
                        let output =
                            Output { position_rad, speed_rad_s, acceleration_rad_s2: acceleration, direction: sense };
                        let values = self.values(placed.segment, &output, recorded);
                        let travelled = weight * length * interval.duration_s * speed_rad_s.abs();
                        self.see(placed.segment, interval.start_s + u * interval.duration_s, &values, travelled);
                    }
                    k += 1.0;
                }
            }
        }
    }
}

/// The state of a piece.
pub(crate) fn output(piece: &Piece, t: f64, direction: f64) -> Output {
    let state = piece.at(t);
    Output {
        position_rad: state.position_rad,
        speed_rad_s: state.speed_rad_s,
        acceleration_rad_s2: state.acceleration_rad_s2,
        direction,
    }
}

#[cfg(test)]
#[path = "flange_tests.rs"]
mod tests;
