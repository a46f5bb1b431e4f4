//! Loads on the flange over the cycle: those that the user states for a segment, and those that follow from the
//! mechanism at every instant.

mod walk;

use crate::axis::{Axis, BearingDuty};
use mechanism::{Mounting, Output};
use motion::Piece;
use numeric::First;
use provenance::Missing;
use quantities::{Force, Length, Measure, Time, Torque};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use walk::Walk;

/// Loads that follow from the mechanism.
#[derive(Clone, Debug, PartialEq)]
pub struct DerivedLoads {
    /// Position of the load on the flange.
    pub mounting: Mounting,
    /// Segments of the motion in which they act.
    pub acts: Vec<bool>,
}

/// A largest value and its instant; for loads that are constant within a segment, the start of the segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Peak(First<()>);

impl Default for Peak {
    fn default() -> Self {
        Self(First::above(0.0, ()))
    }
}

impl Peak {
    pub(crate) fn see(&mut self, value: f64, at: f64) {
        self.0.see(value, at, ());
    }

    pub(crate) const fn value(self) -> f64 {
        self.0.value()
    }

    /// Returns the instant; the start of the cycle if there is no load.
    pub(crate) const fn at(self) -> f64 {
        self.0.at().max(0.0)
    }

    /// Returns the larger of two; of equal ones the earlier.
    fn or(mut self, other: Self) -> Self {
        self.see(other.value(), other.0.at());
        self
    }
}

/// Position, size and life exponent of an output bearing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Geometry {
    /// R: offset of the bearing's centre behind the flange face.
    pub(crate) offset: Length,
    /// d_p: pitch circle diameter.
    pub(crate) pitch: Length,
    /// B: exponent of the bearing's life.
    pub(crate) exponent: f64,
}

impl Geometry {
    /// Returns the geometry for which no moment is computed.
    fn none() -> Self {
        Self { offset: Length::from_si(0.0), pitch: Length::from_si(0.0), exponent: 3.0 }
    }

    fn key(&self) -> Key {
        [self.offset.si(), self.pitch.si(), self.exponent].map(f64::to_bits)
    }
}

/// Largest F_r, F_a and M about the bearing's centre, each at its own instant, and the largest combination of the three at
/// one instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Peaks {
    pub(crate) radial: Peak,
    pub(crate) axial: Peak,
    pub(crate) moment: Peak,
    /// M_eq of one instant: [`actuator::static_equivalent_moment`].
    pub(crate) equivalent: Peak,
}

impl Peaks {
    /// Returns `true` if the largest loads act at one instant; a load that never acts has none.
    pub(crate) fn is_of_one_instant(&self) -> bool {
        let mut acting = [self.radial, self.axial, self.moment].into_iter().filter(|peak| peak.value() > 0.0);
        let first = acting.next().map(Peak::at);
        acting.all(|peak| Some(peak.at()) == first)
    }

    pub(crate) fn see(&mut self, [radial, axial, moment, equivalent]: InstantLoads, at: f64) {
        self.radial.see(radial, at);
        self.axial.see(axial, at);
        self.moment.see(moment, at);
        self.equivalent.see(equivalent, at);
    }

    /// Returns the largest values in the order of [`InstantLoads`].
    fn each(&mut self) -> [&mut Peak; 4] {
        [&mut self.radial, &mut self.axial, &mut self.moment, &mut self.equivalent]
    }
}

/// F_r, F_a, M and M_eq at one instant.
pub(crate) type InstantLoads = [f64; 4];

/// Returns F_r, F_a and M at one instant with the M_eq that they make.
pub(crate) fn with_equivalent([radial, axial, moment]: [f64; 3], pitch: Length) -> InstantLoads {
    let none = Length::from_si(0.0);
    let load = actuator::FlangeLoad {
        radial_force: Force::from_si(radial),
        radial_distance: none,
        axial_force: Force::from_si(axial),
        axial_distance: none,
    };
    let equivalent = actuator::static_equivalent_moment(&load, Torque::from_si(moment), pitch);
    [radial, axial, moment, equivalent.si()]
}

/// Loads over the cycle for one geometry of the bearing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct CycleLoads {
    /// Loads while the gear turns.
    pub(crate) turning: Peaks,
    /// Loads while the gear rests.
    pub(crate) resting: Peaks,
    /// Averages of eq. 75.2 and 75.3: F_rav, F_aav \[N\].
    pub(crate) means: [f64; 2],
    /// Average of M by eq. 75.2, of the mechanism and as stated, \[Nm\].
    pub(crate) mean_moment: f64,
}

impl CycleLoads {
    /// Returns the largest loads of the whole cycle, including rest.
    pub(crate) fn whole(&self) -> Peaks {
        let (turning, resting) = (self.turning, self.resting);
        Peaks {
            radial: turning.radial.or(resting.radial),
            axial: turning.axial.or(resting.axial),
            moment: turning.moment.or(resting.moment),
            equivalent: turning.equivalent.or(resting.equivalent),
        }
    }
}

/// Results of earlier computations.
#[derive(Clone, Debug, Default)]
pub(crate) struct Known(Arc<Found>);

#[derive(Debug, Default)]
struct Found {
    /// Loads by the bearing's geometry.
    loads: Mutex<Vec<KnownLoads>>,
    /// Instants within each piece of the motion at which the loads may have a corner or a step, independent of the bearing.
    corners: OnceLock<Vec<Vec<f64>>>,
    states: OnceLock<Vec<States>>,
}

/// States of the gear within a segment of the motion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct States {
    pub(crate) turns: bool,
    pub(crate) rests: bool,
}

/// Bit patterns of R, d_p and B.
type Key = [u64; 3];

/// Geometry of a bearing and the loads for it.
type KnownLoads = (Key, CycleLoads);

impl Known {
    fn get(&self, key: Key, make: impl FnOnce() -> CycleLoads) -> CycleLoads {
        // One thread computes the loads of a pair; the others wait for it rather than repeat the work.
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
    /// Checks that the forces on the flange are known; otherwise returns the missing datum.
    pub(crate) fn forces_known(&self, axis: &Axis) -> Result<(), Missing> {
        if !self.has_loads {
            return Err(Missing { symbol: "bearing.radial_force" });
        }
        let missing = self.derived.as_ref().and_then(|derived| axis.mechanism.missing_for_forces(&derived.mounting));
        missing.map_or(Ok(()), |symbol| Err(Missing { symbol }))
    }

    /// Checks that the tilting moment is known too; otherwise returns the missing datum.
    pub(crate) fn moment_known(&self, axis: &Axis) -> Result<(), Missing> {
        self.forces_known(axis)?;
        let Some(derived) = &self.derived else { return Ok(()) };
        let payload = axis.extras.iter().any(|extra| extra.mass.si() > 0.0);
        let missing = axis.mechanism.missing_for_moment(&derived.mounting, payload);
        missing.map_or(Ok(()), |symbol| Err(Missing { symbol }))
    }
}

impl Axis {
    /// Returns the loads on the flange over the cycle including those of the mechanism; `None` if none follow from it.
    pub(crate) fn derived_loads(&self, bearing: &Geometry) -> Option<CycleLoads> {
        let duty = self.bearing.as_ref()?;
        let derived = duty.derived.as_ref()?;
        if duty.forces_known(self).is_ok() && duty.moment_known(self).is_err() {
            // Without the moment there is no life: only the peaks of the forces are needed, equal for every bearing.
            let find = || Walk::of(self, duty, derived, Geometry::none()).only_forces().loads();
            return Some(self.flange_known.get([u64::MAX; 3], find));
        }
        Some(self.flange_known.get(bearing.key(), || Walk::of(self, duty, derived, *bearing).loads()))
    }

    /// Returns the states of the gear in each segment of the motion.
    pub(crate) fn gear_states(&self) -> &[States] {
        self.flange_known.0.states.get_or_init(|| {
            let mut states = vec![States::default(); self.motion.stretches().len()];
            let mut see = |segment: usize, rests: bool, turns: bool| {
                if let Some(state) = states.get_mut(segment) {
                    state.rests |= rests;
                    state.turns |= turns;
                }
            };
            self.motion.pieces().iter().for_each(|piece| see(piece.segment, piece.is_rest(), !piece.is_rest()));
            // Each step of a search judges another axis: the samples are not passed again.
            for placed in self.motion.recordings() {
                see(placed.segment, placed.recorded.rests(), placed.recorded.turns());
            }
            states
        })
    }

    /// Returns `true` if the gear rests at some time of the cycle.
    pub(crate) fn gear_rests(&self) -> bool {
        self.gear_states().iter().any(|state| state.rests)
    }

    /// Returns the loads on the flange over the cycle if only stated ones apply, computed once for each geometry of the
    /// bearing.
    pub(crate) fn stated_loads(&self, bearing: &Geometry, find: impl FnOnce() -> CycleLoads) -> CycleLoads {
        // Comparing a few loads is faster than a look-up.
        if self.bearing.as_ref().is_none_or(|duty| duty.loads.len() <= FEW) {
            return find();
        }
        self.flange_known.get(bearing.key(), find)
    }

    /// Returns the loads on the flange at instants over the cycle, for pictures: instant, F_r, F_a, and M for a
    /// position of the bearing. Within a segment of constant loads only its ends are returned.
    #[must_use]
    pub fn flange_course(&self, offset: Option<Length>) -> Vec<FlangeSample> {
        let Some(duty) = self.bearing.as_ref().filter(|duty| duty.forces_known(self).is_ok()) else {
            return Vec::new();
        };
        match &duty.derived {
            Some(derived) => {
                let none = Geometry::none();
                let mut walk =
                    Walk::of(self, duty, derived, Geometry { offset: offset.unwrap_or(none.offset), ..none });
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
    /// Returns the number of instants at which the loads on the flange are computed in one walk over the cycle, for one
    /// bearing: those of motion laws and those of recordings, times [`mechanism::Mechanism::evaluation_cost`]; zero if
    /// none follow from the mechanism. Cuts at reversals and changes of sign are not counted.
    #[must_use]
    pub fn flange_instants(&self) -> [f64; 2] {
        let Some(duty) = self.bearing.as_ref().filter(|duty| duty.forces_known(self).is_ok()) else { return [0.0; 2] };
        let Some(derived) = &duty.derived else { return [0.0; 2] };
        let walk = Walk::of(self, duty, derived, Geometry::none());
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

/// Largest number of stated loads that are compared directly.
const FEW: usize = 8;

/// Loads on the flange at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlangeSample {
    /// Instant.
    pub time: Time,
    /// F_r
    pub radial: Force,
    /// F_a
    pub axial: Force,
    /// M about the bearing's centre; `None` if unknown.
    pub moment: Option<Torque>,
}

/// Returns the state of a piece.
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
