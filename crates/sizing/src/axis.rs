//! The axis: load and motion, prepared once for all candidates.

use crate::brake_times::{BrakeTimes, OtherBrakes, carried};
use crate::flange::{DerivedLoads, Known};
use crate::requirements::AxisRequirements;
use crate::resonance::{self, Held};
use crate::rope_checks::RopeCourse;
use crate::supply::Supply;
use actuator::FlangeLoad;
use mechanism::{Endless, Extra, Mechanism};
use motion::{Closing, ManualMove, Motion};
use quantities::{
    Angle, AngularVelocity, ElectricPotential, Measure, MomentOfInertia, ThermodynamicTemperature, Time, Torque,
};
use std::sync::OnceLock;
use trace::{Convex, Extent, Node, Surveys, TorqueWith, Trace};

/// Operating condition of the output bearing (table 76.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OperatingCondition {
    /// Normal operation: f_s ≥ 1.5.
    Normal,
    /// Vibration or shock: f_s ≥ 2.
    Shock,
    /// High transmission accuracy: f_s ≥ 3.
    HighAccuracy,
}

impl OperatingCondition {
    /// Returns the lower limit of the static safety.
    ///
    /// # Source
    /// cha-manual table 76.3
    #[must_use]
    pub const fn static_safety_min(self) -> f64 {
        match self {
            Self::Normal => 1.5,
            Self::Shock => 2.0,
            Self::HighAccuracy => 3.0,
        }
    }
}

/// Loads on the output bearing, and the requirements on it.
#[derive(Clone, Debug, PartialEq)]
pub struct BearingDuty {
    /// Loads are known. If neither the user states any nor the mechanism describes them, no check is made.
    pub has_loads: bool,
    /// Forces on the flange in each segment of the motion, as the user states them.
    pub loads: Vec<FlangeLoad>,
    /// Additional loads that follow from the mechanism.
    pub derived: Option<DerivedLoads>,
    /// f_w: load factor of table 74.2.
    pub load_factor: Option<f64>,
    /// Operating condition, for the static safety.
    pub operating_condition: Option<OperatingCondition>,
    /// Required life.
    pub life_min: Option<Time>,
    /// Permissible tilt.
    pub tilt_max: Option<Angle>,
}

/// Characteristic values of the motion, independent of the actuator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments {
    /// t_0: duration of the cycle.
    pub duration: Time,
    /// Time in motion.
    pub moving: Time,
    /// ∫|ω| dt: angle travelled, counted positive in both directions.
    pub angle_travelled: Angle,
    /// Angle between the end and the start of the cycle.
    pub angle_net: Angle,
    /// The cycle ends at its start position: [`Motion::ends_where_it_starts`].
    closes: bool,
    /// Largest minus smallest position within one cycle.
    pub angle_swing: Angle,
    /// max |ω|
    pub speed_peak: AngularVelocity,
    /// Instant at which the peak speed is first reached.
    pub speed_peak_at: Time,
    /// Largest J_L on the way.
    pub inertia_max: MomentOfInertia,
    /// Largest magnitude of the torque of the load, without the actuator's own inertia.
    pub load_peak: Torque,
    /// Instant at which the peak is first reached.
    pub load_peak_at: Time,
    /// Largest magnitude of the torque that holds the load without friction at any instant of the cycle.
    pub holding_torque: Torque,
}

impl Moments {
    fn of(trace: &Trace, motion: &Motion) -> Self {
        let (speed, speed_at) =
            trace.largest_once(&Convex(|extent: &Extent| extent.speed_rad_s, |node: &Node| node.speed_rad_s.abs()));
        let (load, load_at) = trace.largest_once(&TorqueWith { inertia_kgm2: 0.0 });
        let travelled = Angle::from_si(trace.gram().travelled());
        let (lowest, highest) = trace.span();
        Self {
            duration: motion.duration(),
            moving: Time::from_si(trace.gram().moving()),
            angle_travelled: travelled,
            angle_net: motion.net(),
            closes: motion.ends_where_it_starts(travelled, highest - lowest),
            angle_swing: highest - lowest,
            speed_peak: AngularVelocity::from_si(speed),
            speed_peak_at: Time::from_si(speed_at.time_s),
            inertia_max: trace.inertia().0,
            load_peak: Torque::from_si(load),
            load_peak_at: Time::from_si(load_at.time_s),
            holding_torque: trace.holding(),
        }
    }

    /// Returns `true` if the cycle ends at its start position, up to the error of its data: a swing, not a rotation.
    #[must_use]
    pub const fn is_swing(&self) -> bool {
        self.closes
    }

    /// Returns n_av: mean of |n| over the cycle, pause included.
    #[must_use]
    pub fn speed_mean(&self) -> AngularVelocity {
        AngularVelocity::from_si(self.angle_travelled.si() / self.duration.si())
    }

    /// Returns ED: share of the cycle in motion.
    #[must_use]
    pub fn duty_factor(&self) -> f64 {
        self.moving.si() / self.duration.si()
    }
}

/// A motion that needs more evaluation points than the cost limit allows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TooManyInstants {
    /// Index of the segment with most of them.
    pub segment: usize,
    /// Instants of the whole cycle.
    pub instants: f64,
    /// Largest permissible number.
    pub most: f64,
}

/// Load and motion of one axis, with the moments of its cycle.
#[derive(Clone, Debug)]
pub struct Axis {
    /// Mechanism with the load.
    pub mechanism: Mechanism,
    /// Motion.
    pub motion: Motion,
    /// Additional load in each segment.
    pub extras: Vec<Extra>,
    /// Ambient temperature, if the user stated one.
    pub ambient: Option<ThermodynamicTemperature>,
    /// Loads on the output bearing, if the user gave any.
    pub bearing: Option<BearingDuty>,
    /// DC link.
    pub supply: Option<Supply>,
    /// Further requirements.
    pub asked: AxisRequirements,
    pub(crate) brake_times: Option<BrakeTimes>,
    pub(crate) other_brakes: OtherBrakes,
    pub(crate) moments: Moments,
    pub(crate) trace: Trace,
    pub(crate) held: OnceLock<Vec<Held>>,
    pub(crate) least_peak: OnceLock<(Torque, Time)>,
    /// J_L and T_L if the manual's equations describe the load.
    pub(crate) plain: Option<(MomentOfInertia, Torque)>,
    /// Loads on the flange that were computed for earlier bearings.
    pub(crate) flange_known: Known,
    pub(crate) swing_ranges: OnceLock<Vec<f64>>,
    pub(crate) rope_course: OnceLock<Option<RopeCourse>>,
}

impl Axis {
    /// Returns the lowest and the highest position of the output over the cycle.
    #[must_use]
    pub fn span(&self) -> (Angle, Angle) {
        self.trace.span()
    }

    /// Prepares an axis without a brake, whose motor holds through every dwell: one pass over the motion.
    #[must_use]
    pub fn new(mechanism: Mechanism, motion: Motion, extras: Vec<Extra>) -> Self {
        Self::surveyed(mechanism, motion, extras, None, &Surveys::default())
    }

    /// Prepares an axis whose dwells may be held by a brake: one pass over the motion.
    #[must_use]
    pub fn braked(mechanism: Mechanism, motion: Motion, extras: Vec<Extra>, times: BrakeTimes) -> Self {
        Self::surveyed(mechanism, motion, extras, Some(times), &Surveys::default())
    }

    /// Prepares an axis with or without a brake; a recording whose survey is among the given ones is not evaluated again.
    /// The axis is the same to the last bit.
    #[must_use]
    pub fn surveyed(
        mechanism: Mechanism,
        motion: Motion,
        extras: Vec<Extra>,
        times: Option<BrakeTimes>,
        surveys: &Surveys,
    ) -> Self {
        let trace = Trace::surveyed(&mechanism, &motion, &extras, &carried(&motion, times.as_ref()), surveys);
        Self { brake_times: times, ..Self::with_trace(mechanism, motion, extras, trace) }
    }

    /// Returns the surveys of its recordings, for another axis with the same ones.
    #[must_use]
    pub fn surveys(&self) -> Surveys {
        self.trace.surveys()
    }

    pub(crate) fn with_trace(mechanism: Mechanism, motion: Motion, extras: Vec<Extra>, trace: Trace) -> Self {
        let moments = Moments::of(&trace, &motion);
        let plain = plain_load(&mechanism, &extras);
        Self {
            plain,
            mechanism,
            motion,
            extras,
            ambient: None,
            bearing: None,
            supply: None,
            asked: AxisRequirements::default(),
            brake_times: None,
            other_brakes: OtherBrakes::default(),
            moments,
            trace,
            flange_known: Known::default(),
            swing_ranges: OnceLock::new(),
            rope_course: OnceLock::new(),
            held: OnceLock::new(),
            least_peak: OnceLock::new(),
        }
    }

    /// Returns the number of evaluation points of a motion under its load, and the segment with most of them, if the
    /// number exceeds the limit; an axis is not built from such a motion.
    #[must_use]
    pub fn too_many_instants(mechanism: &Mechanism, motion: &Motion) -> Option<TooManyInstants> {
        let found = trace::instants(mechanism, motion);
        let instants = found.iter().map(|(_, count)| count).sum::<f64>();
        let (segment, _) = found.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
        let most = trace::INSTANTS_MOST;
        (instants > most).then_some(TooManyInstants { segment: *segment, instants, most })
    }

    /// Returns the number of evaluation points of its cycle: the cost of one pass over it.
    #[must_use]
    pub fn instants(&self) -> usize {
        self.trace.instants()
    }

    /// Returns the number of samples of its long recordings, and their work: samples under a load that depends on the
    /// position or has losses count twice, more if the equations of the load take longer, and a little more if the
    /// loads on the flange follow from the mechanism.
    #[must_use]
    pub fn samples(&self) -> [usize; 2] {
        /// Number of evaluations of the flange that take as long as a sample, for all bearings of the catalogue.
        const A_SAMPLE: f64 = 32.0;
        let [samples, work] = self.trace.samples();
        let [_, on_flange] = self.flange_instants();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count far below 2^52")]
        let on_flange = (on_flange / A_SAMPLE) as usize;
        [samples, if samples == 0 { 0 } else { work + on_flange }]
    }

    /// Returns the ranges of the closed swings of a cycle \[rad\]; only the output bearing needs them.
    pub(crate) fn swing_ranges(&self) -> &[f64] {
        self.swing_ranges.get_or_init(|| crate::swings::swing_ranges(&self.motion))
    }

    /// Returns the tension of the ropes over the cycle; `None` if no rope holds a load.
    pub(crate) fn rope_course(&self) -> Option<&RopeCourse> {
        self.rope_course.get_or_init(|| RopeCourse::of(self)).as_ref()
    }

    /// Returns `true` if the cycle has so few instants that judging an actuator takes microseconds.
    #[must_use]
    pub fn is_short(&self) -> bool {
        self.trace.is_short()
    }

    /// Returns the integrals of the cycle.
    #[must_use]
    pub const fn moments(&self) -> &Moments {
        &self.moments
    }

    /// Returns the voltage of the supply at the motor terminals, rms; `None` if the project states no supply.
    #[must_use]
    pub fn terminal_voltage(&self) -> Option<ElectricPotential> {
        self.supply.as_ref().map(Supply::terminal_voltage)
    }

    /// Returns the speeds held in the cycle; only gears of known stiffness need them.
    pub(crate) fn held_speeds(&self) -> &[Held] {
        self.held.get_or_init(|| resonance::held_speeds(self))
    }

    /// Returns the cubic mean of the torque of the load over the angle travelled: (∫|T|³|ω| dt / ∫|ω| dt)^(1/3).
    pub(crate) fn load_cubic_mean(&self) -> Torque {
        let travelled = self.trace.gram().travelled();
        Torque::from_si(if travelled > 0.0 { (self.trace.cubes() / travelled).cbrt() } else { 0.0 })
    }

    /// Returns the condition under which a cycle of a mechanism is closed.
    #[must_use]
    pub fn closing(mechanism: &Mechanism) -> Closing {
        match mechanism.endless() {
            Endless::Everywhere => Closing::Speed,
            Endless::EachRevolution => Closing::Revolutions,
            Endless::Never => Closing::Position,
        }
    }

    /// Returns J_L, T_L and the moves if the manual's equations describe the axis: a constant inertia, a friction
    /// independent of the speed, no other loads, and a cycle of the manual's moves only.
    pub(crate) fn by_the_manual(&self) -> Option<(MomentOfInertia, Torque, &[ManualMove])> {
        let (inertia, friction) = self.plain?;
        Some((inertia, friction, self.motion.manual()?))
    }
}

/// Returns J_L and T_L of a load with a constant inertia, a friction independent of the speed, and no other torques.
fn plain_load(mechanism: &Mechanism, extras: &[Extra]) -> Option<(MomentOfInertia, Torque)> {
    let plain = mechanism.is_constant_over_ramps()
        && mechanism.stage.is_none_or(|stage| stage.changes_nothing())
        && mechanism.efficiency_driving == 1.0
        && mechanism.efficiency_driven == 1.0
        && extras.iter().all(|extra| *extra == Extra::none())
        && mechanism.holding_torque(0.0, &Extra::none()).si() == 0.0
        && matches!(mechanism.kind, mechanism::MechanismKind::Rotor(_));
    plain.then(|| (mechanism.inertia(0.0, &Extra::none()), mechanism.friction.coulomb))
}
