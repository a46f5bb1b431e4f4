//! One pass over the motion: the loads on the flange at every instant, their largest values and their averages.

use super::{CycleLoads, DerivedLoads, FlangeSample, Geometry, InstantLoads, is_rest, output, with_equivalent};
use crate::axis::{Axis, BearingDuty};
use mechanism::{Extra, FlangeForces, Output, Recurrence};
use motion::Piece;
use numeric::{highest, lobatto, roots};
use quantities::{Force, Measure, Time, Torque};
use trace::kink_passes;

/// Largest angle of the load in a panel, less if the mechanism is not smooth over it: sixteen nodes integrate powers of
/// a quantity with the period of a revolution to almost the last bit.
const PANEL_ANGLE: f64 = std::f64::consts::FRAC_PI_6;

/// Largest phase of the harmonic of its law in a panel.
const PANEL_PHASE: f64 = std::f64::consts::FRAC_PI_4;

/// Largest number of fine panels of one piece, two thousand revolutions at changing speed. Beyond, panels grow: up to a
/// whole revolution sixteen nodes still integrate to 10⁻⁶, over several they are samples of a periodic quantity, whose
/// mean has an error of some 10⁻³.
const PANELS_FINE: f64 = 24_000.0;

/// Largest number of panels of one piece if the loads do not depend on the position or are a polynomial of it.
const PANELS_OF_A_LAW: f64 = 64.0;

/// Largest number of panels of the intervals of a recording, in addition to one for each interval; beyond, they grow
/// likewise.
const PANELS_RECORDED: f64 = 200_000.0;

/// Number of nodes of a panel.
pub(super) const NODES: usize = 16;

/// Angle of an interval of a recording below which three nodes suffice: the error of Simpson's rule is less than 10⁻⁷.
const INTERVAL_ANGLE: f64 = 0.05;

/// Largest number of displayed intervals of a recording.
const SAMPLES_SHOWN: usize = 20_000;

/// Relative tolerance of the search for a maximum between two nodes.
const CLOSE: f64 = 1e-12;

/// Sums of the averages: ∫|ω| x^B dt.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    travelled: f64,
    forces: [f64; 2],
    moment: f64,
}

/// One pass over the motion.
pub(super) struct Walk<'a> {
    axis: &'a Axis,
    duty: &'a BearingDuty,
    derived: &'a DerivedLoads,
    bearing: Geometry,
    loads: CycleLoads,
    sums: Sums,
    pub(super) samples: Option<Vec<FlangeSample>>,
    /// Moment and averages are not computed.
    only_forces: bool,
}

impl<'a> Walk<'a> {
    pub(super) fn of(axis: &'a Axis, duty: &'a BearingDuty, derived: &'a DerivedLoads, bearing: Geometry) -> Self {
        Self {
            axis,
            duty,
            derived,
            bearing,
            loads: CycleLoads::default(),
            sums: Sums::default(),
            samples: None,
            only_forces: false,
        }
    }

    /// Disables moments and averages.
    pub(super) fn only_forces(self) -> Self {
        Self { only_forces: true, ..self }
    }

    pub(super) fn loads(mut self) -> CycleLoads {
        self.walk();
        let Sums { travelled, forces, moment } = self.sums;
        let mean = |sum: f64| if travelled > 0.0 { (sum / travelled).powf(1.0 / self.bearing.exponent) } else { 0.0 };
        CycleLoads { means: forces.map(mean), mean_moment: mean(moment), ..self.loads }
    }

    pub(super) fn sampled(mut self) -> Vec<FlangeSample> {
        self.walk();
        self.samples.unwrap_or_default()
    }

    fn walk(&mut self) {
        let axis = self.axis;
        let pieces = axis.motion.pieces();
        let kept;
        let corners = if self.samples.is_none() {
            axis.flange_known.0.corners.get_or_init(|| pieces.iter().map(|piece| self.corners(piece)).collect())
        } else {
            kept = pieces.iter().map(|piece| self.corners(piece)).collect();
            &kept
        };
        let mut recordings = axis.motion.recordings().iter().peekable();
        for (piece, corners) in pieces.iter().zip(corners) {
            while let Some(placed) = recordings.next_if(|placed| placed.start_s < piece.start_s) {
                self.recording(placed);
            }
            if piece.is_rest() { self.rest(piece) } else { self.piece(piece, corners) }
        }
        for placed in recordings {
            self.recording(placed);
        }
    }

    /// Returns x^B; for the exponents of both types of bearing without logarithms.
    fn power(&self, x: f64) -> f64 {
        if self.bearing.exponent == 3.0 {
            x * x * x
        } else if self.bearing.exponent == 10.0 / 3.0 {
            x * x * x * x.cbrt()
        } else {
            x.powf(self.bearing.exponent)
        }
    }

    fn values(&self, segment: usize, output: &Output, recorded_nm: f64) -> InstantLoads {
        let none = Extra::none();
        let extra = self.axis.extras.get(segment).unwrap_or(&none);
        let forces = if self.derived.acts.get(segment).copied().unwrap_or(false) {
            self.axis.mechanism.flange_forces(output, extra, recorded_nm, &self.derived.mounting)
        } else {
            FlangeForces::default()
        };
        let [radial, axial, by_radial, by_axial] = self.stated(segment);
        let moment = if self.only_forces { 0.0 } else { forces.moment(self.bearing.offset) };
        let values = [forces.radial() + radial, forces.axial() + axial, moment + by_radial + by_axial];
        with_equivalent(values, self.bearing.pitch)
    }

    /// Returns the stated loads of a segment: F_r, F_a, F_r (L_r + R), F_a L_a.
    fn stated(&self, segment: usize) -> [f64; 4] {
        self.duty.loads.get(segment).map_or([0.0; 4], |load| {
            let (radial, axial) = (load.radial_force.si(), load.axial_force.si());
            let by_radial = radial * (load.radial_distance.si() + self.bearing.offset.si());
            [radial, axial, by_radial, axial * load.axial_distance.si()]
        })
    }

    /// Evaluates an instant of the turning gear; `weight`: |ω| dt under it.
    fn see(&mut self, time: f64, values: &InstantLoads, weight: f64) {
        self.loads.turning.see(*values, time);
        if weight > 0.0 && !self.only_forces {
            let add = |value: f64| if value == 0.0 { 0.0 } else { weight * self.power(value) };
            let [radial, axial, moment, _] = values.map(add);
            self.sums.travelled += weight;
            self.sums.forces.iter_mut().zip([radial, axial]).for_each(|(sum, part)| *sum += part);
            self.sums.moment += moment;
        }
        self.show(time, values);
    }

    /// Evaluates an instant of the gear at rest.
    fn see_rest(&mut self, time: f64, values: &InstantLoads) {
        self.loads.resting.see(*values, time);
        self.show(time, values);
    }

    fn show(&mut self, time: f64, [radial, axial, moment, _]: &InstantLoads) {
        if let Some(samples) = &mut self.samples {
            samples.push(FlangeSample {
                time: Time::from_si(time),
                radial: Force::from_si(*radial),
                axial: Force::from_si(*axial),
                moment: Some(Torque::from_si(*moment)),
            });
        }
    }

    fn rest(&mut self, piece: &Piece) {
        let values = self.values(piece.segment, &output(piece, 0.0, 0.0), 0.0);
        self.see_rest(piece.start_s, &values);
        if self.samples.is_some() {
            self.see_rest(piece.start_s + piece.duration_s, &values);
        }
    }

    /// Returns the duration of one revolution of the load at the speed of the piece \[s\].
    pub(super) fn turn_s(&self, piece: &Piece) -> f64 {
        std::f64::consts::TAU * self.axis.mechanism.stage_ratio() / piece.speed_rad_s.abs()
    }

    /// Returns `true` if the piece turns more than twice at constant speed under loads that repeat with each revolution.
    pub(super) fn repeats(&self, piece: &Piece) -> bool {
        let is_steady = piece.speed_degree() == Some(0) && piece.speed_rad_s != 0.0;
        let is_periodic = self.axis.mechanism.flange_recurrence() == Recurrence::EachRevolution;
        is_steady && is_periodic && piece.duration_s > 2.0 * self.turn_s(piece)
    }

    fn piece(&mut self, piece: &Piece, cuts: &[f64]) {
        let parts_per_s = self.parts(piece, piece.duration_s) / piece.duration_s;
        if !self.repeats(piece) || self.samples.is_some() {
            self.stretch(piece, (0.0, piece.duration_s), (1.0, parts_per_s), cuts.iter().copied());
            return;
        }
        let turn = self.turn_s(piece);
        let whole = (piece.duration_s / turn).floor();
        self.stretch(piece, (0.0, turn), (whole, parts_per_s), cuts.iter().copied());
        let rest = (whole * turn, piece.duration_s);
        self.stretch(piece, rest, (1.0, parts_per_s), cuts.iter().map(|cut| cut + whole * turn));
    }

    /// Evaluates the panels between two instants of a piece, cut at those between them; each counts `times` over.
    fn stretch(
        &mut self,
        piece: &Piece,
        (start, end): (f64, f64),
        (times, parts_per_s): (f64, f64),
        cuts: impl Iterator<Item = f64>,
    ) {
        let mut cuts: Vec<f64> = cuts.filter(|cut| *cut > start && *cut < end).collect();
        cuts.push(end);
        cuts.sort_by(f64::total_cmp);
        let runs = piece.runs();
        let mut from = start;
        for to in cuts {
            if to - from > 1e-12 * piece.duration_s {
                let sense = runs.direction(0.5 * (from + to));
                self.panels((piece, sense), (from, to), times, (parts_per_s * (to - from)).ceil());
                from = to;
            }
        }
    }

    /// Returns the number of panels of a piece or a part of it by its duration.
    pub(super) fn parts(&self, piece: &Piece, duration: f64) -> f64 {
        let [amplitude, frequency, _] = piece.harmonic;
        let phase = if amplitude == 0.0 { 0.0 } else { frequency * duration / PANEL_PHASE };
        let states = [0.0, 0.25, 0.5, 0.75, 1.0].map(|u| piece.at(u * piece.duration_s));
        let fastest = states.iter().map(|state| state.speed_rad_s.abs()).fold(0.0, f64::max);
        let angle = fastest * duration / self.axis.mechanism.stage_ratio();
        // Loads that do not depend on the position, or are a polynomial of it, are as smooth as the law, except for the
        // corner where the larger of two bounds changes.
        let of_law = (angle / PANEL_ANGLE).min(PANELS_OF_A_LAW);
        let of_position = self.panel_angle(piece).map_or(0.0, |panel| (angle / panel).min(PANELS_FINE));
        phase.max(of_law).max(of_position).max(1.0).ceil()
    }

    /// Returns the angle of the mechanism in one panel, if the loads depend on the position and are no polynomial of
    /// it.
    fn panel_angle(&self, piece: &Piece) -> Option<f64> {
        let reversals = piece.reversals();
        let turns = [0.0, piece.duration_s].into_iter().chain(reversals).map(|t| piece.at(t).position_rad);
        let (low, high) = turns.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), q| (low.min(q), high.max(q)));
        self.axis.mechanism.smooth_over(low, high).filter(|panel| panel.is_finite())
    }

    /// Returns the instants inside the piece at which the loads on the flange may have a corner or a step: where the axis
    /// reverses, where the position passes a kink of the load, and where a force along a line changes its sign. Of a piece that
    /// [repeats](Self::repeats) those of the first revolution.
    fn corners(&self, piece: &Piece) -> Vec<f64> {
        if piece.is_rest() {
            return Vec::new();
        }
        let piece = if self.repeats(piece) && self.samples.is_none() {
            &Piece { duration_s: self.turn_s(piece), ..*piece }
        } else {
            piece
        };
        let mut found = piece.reversals();
        found.extend(kink_passes(&self.axis.mechanism, piece));
        found.extend(self.switches(piece));
        found
    }

    /// Returns the instants inside the piece at which a force along a line changes its sign.
    fn switches(&self, piece: &Piece) -> Vec<f64> {
        let none = Extra::none();
        let extra = self.axis.extras.get(piece.segment).unwrap_or(&none);
        let runs = piece.runs();
        let forces = |t: f64| self.axis.mechanism.flange_switches(&output(piece, t, runs.direction(t)), extra, 0.0);
        let mut found = Vec::new();
        if forces(0.0).is_none() {
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

    /// Returns `true` if the loads may step within a piece: at a kink of the load, or where losses change sides.
    fn has_steps(&self) -> bool {
        let mechanism = &self.axis.mechanism;
        mechanism.has_losses() || mechanism.stage.is_some() || !mechanism.kinks().is_empty()
    }

    /// Evaluates the panels between two instants of a piece with one direction of rotation, `sense`; each counts `times` over.
    fn panels(&mut self, (piece, sense): (&Piece, f64), (from, to): (f64, f64), times: f64, count: f64) {
        let length = (to - from) / count.max(1.0);
        // At a kink or a step of the load each panel uses its own side.
        let beside = if self.has_steps() { 1e-9 * (to - from) } else { 0.0 };
        let mut k = 0.0;
        while k < count.max(1.0) {
            let (start, end) = (from + k * length, from + (k + 1.0) * length);
            let mut nodes = [(0.0, [0.0; 4]); NODES];
            for ((u, weight), node) in lobatto(NODES).iter().zip(&mut nodes) {
                let t = (start + u * (end - start)).max(from + beside).min(to - beside);
                let output = output(piece, t, sense);
                let values = self.values(piece.segment, &output, 0.0);
                let travelled = times * weight * (end - start) * output.speed_rad_s.abs();
                self.see(piece.start_s + t, &values, travelled);
                *node = (t, values);
            }
            self.peaks_between(piece, sense, &nodes);
            k += 1.0;
        }
    }

    /// Searches between the nodes around an inner maximum if the parabola through three nodes indicates a larger value.
    fn peaks_between(&mut self, piece: &Piece, sense: f64, nodes: &[(f64, InstantLoads); NODES]) {
        for which in 0..4 {
            for (place, trio) in nodes.windows(3).enumerate() {
                let [a, b, c] = trio else { continue };
                let [a, b, c] = [a, b, c].map(|(t, values)| (*t, values.get(which).copied().unwrap_or(0.0)));
                // Between the first two nodes, and the last two, the larger one may be the end.
                let is_at_an_end = place == 0 || place + 3 == NODES;
                if !is_at_an_end && (b.1 < a.1 || b.1 < c.1) {
                    continue;
                }
                let best = self.loads.turning.each().get(which).map_or(0.0, |peak| peak.value());
                let value = |t: f64| {
                    let values = self.values(piece.segment, &output(piece, t, sense), 0.0);
                    values.get(which).copied().unwrap_or(0.0)
                };
                let (t, found) = highest(value, [a, b, c], best, CLOSE);
                if let Some(peak) = self.loads.turning.each().get_mut(which) {
                    peak.see(found, piece.start_s + t);
                }
            }
        }
    }

    /// Returns the angle by which the mechanism turns in an interval \[rad\].
    fn turned(&self, interval: &motion::Interval) -> f64 {
        let [first, last] = interval.speed_rad_s;
        first.abs().max(last.abs()) * interval.duration_s / self.axis.mechanism.stage_ratio()
    }

    /// Returns the angle of a panel of a recording, of which one interval in `stride` is evaluated \[rad\].
    pub(super) fn recorded_panel(&self, placed: &motion::Placed, stride: usize) -> f64 {
        let intervals = (0..placed.intervals()).step_by(stride).filter_map(|index| placed.interval(index));
        let all: f64 = intervals.map(|interval| self.turned(&interval) / PANEL_ANGLE).sum();
        PANEL_ANGLE * (all / PANELS_RECORDED).max(1.0)
    }

    /// Returns the nodes of each panel of an interval, and their number.
    pub(super) fn recorded_nodes(&self, interval: &motion::Interval, panel: f64) -> (usize, f64) {
        let angle = self.turned(interval);
        (if angle < INTERVAL_ANGLE { 3 } else { NODES }, (angle / panel).ceil().max(1.0))
    }

    fn recording(&mut self, placed: &motion::Placed) {
        // A picture of a long recording needs no more instants.
        let stride = if self.samples.is_some() { placed.intervals().div_ceil(SAMPLES_SHOWN).max(1) } else { 1 };
        let panel = self.recorded_panel(placed, stride);
        for interval in (0..placed.intervals()).step_by(stride).filter_map(|index| placed.interval(index)) {
            if is_rest(&interval) {
                for share in [0.0, 1.0] {
                    let (position_rad, _, recorded) = interval.at(share);
                    let output = Output { position_rad, speed_rad_s: 0.0, acceleration_rad_s2: 0.0, direction: 0.0 };
                    let values = self.values(placed.segment, &output, recorded);
                    self.see_rest(interval.start_s + share * interval.duration_s, &values);
                }
                continue;
            }
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
                        self.see(interval.start_s + u * interval.duration_s, &values, travelled);
                    }
                    k += 1.0;
                }
            }
        }
    }
}
