//! The loads on the flange over the cycle: those that the user states for a segment, and those that follow from the
//! mechanism at every instant.

mod walk;

use crate::axis::{Axis, BearingDuty};
use mechanism::{Mounting, Output};
use motion::Piece;
use provenance::Missing;
use quantities::{Force, Length, Measure, Time, Torque};
use std::cmp::Ordering;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use walk::Walk;

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
    pub(crate) fn see(&mut self, value: f64, at: f64) {
        if value > self.value {
            *self = Self { value, at };
        }
    }

    /// The larger of two; of equal ones the earlier.
    fn or(self, other: Self) -> Self {
        match self.value.total_cmp(&other.value) {
            Ordering::Greater => self,
            Ordering::Equal if self.at <= other.at => self,
            Ordering::Equal | Ordering::Less => other,
        }
    }
}

/// The largest F_r, F_a and M about the bearing's centre, each of any instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Peaks {
    pub(crate) radial: Peak,
    pub(crate) axial: Peak,
    pub(crate) moment: Peak,
}

impl Peaks {
    pub(crate) fn see(&mut self, [radial, axial, moment]: [f64; 3], at: f64) {
        self.radial.see(radial, at);
        self.axial.see(axial, at);
        self.moment.see(moment, at);
    }
}

/// The loads over the cycle for one place of the bearing and one exponent of its life.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct CycleLoads {
    /// While the gear turns.
    pub(crate) turning: Peaks,
    /// While it rests.
    pub(crate) resting: Peaks,
    /// Averages of eq. 75.2 and 75.3: F_rav, F_aav \[N\].
    pub(crate) means: [f64; 2],
    /// The same averages of the moment of the mechanism, and of F_r (L_r + R) and F_a L_a of what the user states \[Nm\].
    pub(crate) mean_moments: [f64; 3],
}

impl CycleLoads {
    /// The largest loads of the whole cycle, at rest too.
    pub(crate) fn whole(&self) -> Peaks {
        let (turning, resting) = (self.turning, self.resting);
        Peaks {
            radial: turning.radial.or(resting.radial),
            axial: turning.axial.or(resting.axial),
            moment: turning.moment.or(resting.moment),
        }
    }
}

/// What was worked out already.
#[derive(Clone, Debug, Default)]
pub(crate) struct Known(Arc<Found>);

#[derive(Debug, Default)]
struct Found {
    /// By R and B.
    loads: Mutex<Vec<KnownLoads>>,
    /// The instants within each piece of the motion at which the loads may have a corner or a step: for every R and B the same.
    corners: OnceLock<Vec<Vec<f64>>>,
    states: OnceLock<Vec<States>>,
}

/// States of the gear within a segment of the motion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct States {
    pub(crate) turns: bool,
    pub(crate) rests: bool,
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
            let find = || Walk::of(self, duty, derived, Length::from_si(0.0), 3.0).only_forces().loads();
            return Some(self.flange_known.get([u64::MAX; 2], find));
        }
        let key = [offset.si().to_bits(), exponent.to_bits()];
        Some(self.flange_known.get(key, || Walk::of(self, duty, derived, offset, exponent).loads()))
    }

    /// Returns the states of the gear in each segment of the motion.
    pub(crate) fn gear_states(&self) -> &[States] {
        self.flange_known.0.states.get_or_init(|| {
            let mut states = vec![States::default(); self.motion.stretches().len()];
            let mut see = |segment: usize, is_rest: bool| {
                if let Some(state) = states.get_mut(segment) {
                    state.rests |= is_rest;
                    state.turns |= !is_rest;
                }
            };
            self.motion.pieces().iter().for_each(|piece| see(piece.segment, piece.is_rest()));
            for placed in self.motion.recordings() {
                let intervals = (0..placed.intervals()).filter_map(|index| placed.interval(index));
                intervals.for_each(|interval| see(placed.segment, is_rest(&interval)));
            }
            states
        })
    }

    /// Returns `true` if the gear rests at some time of the cycle.
    pub(crate) fn gear_rests(&self) -> bool {
        self.gear_states().iter().any(|state| state.rests)
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
    /// Number of instants at which the loads on the flange are found in one walk over the cycle, for one bearing: those of motion laws and
    /// those of recordings, times [`mechanism::Mechanism::evaluation_cost`]; zero where none follow from the mechanism. Cuts at reversals
    /// and changes of sign are not counted.
    #[must_use]
    pub fn flange_instants(&self) -> [f64; 2] {
        let Some(duty) = self.bearing.as_ref().filter(|duty| duty.forces_known(self).is_ok()) else { return [0.0; 2] };
        let Some(derived) = &duty.derived else { return [0.0; 2] };
        let walk = Walk::of(self, duty, derived, Length::from_si(0.0), 3.0);
        let of_piece = |piece: &Piece| {
            let parts = if piece.is_rest() { 0.0 } else { walk.parts(piece, piece.duration_s) };
            let whole = if walk.repeats(piece) { (piece.duration_s / walk.turn_s(piece)).floor() / 2.0 } else { 1.0 };
            1.0 + walk::NODES as f64 * (parts / whole).ceil()
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
        [pieces, recordings].map(|instants| instants * self.mechanism.evaluation_cost())
    }
}

/// Returns `true` if nothing moves over an interval of a recording.
fn is_rest(interval: &motion::Interval) -> bool {
    interval.speed_rad_s == [0.0; 2]
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
