//! Remarks on the result of a check.

use crate::check::Amount;
use actuator::{ErrorBudget, Protection};
use mechanism::Rope;
use quantities::{
    Angle, AngularVelocity, ElectricCurrent, ElectricPotential, Energy, Frequency, Length, Power,
    ThermodynamicTemperature, Time, Torque,
};
use std::fmt;
use std::ops::Deref;
use std::sync::Arc;

/// A remark on a check beyond its numbers.
///
/// Some are stored for every candidate: variants larger than three numbers are boxed.
#[derive(Clone, Debug, PartialEq)]
pub enum Note {
    /// Friction is evaluated with the gear at the ambient temperature and, if known, at the temperature of the settled
    /// cycle; the larger current decides.
    FrictionTemperatures {
        /// Ambient temperature.
        cold: ThermodynamicTemperature,
        /// Housing temperature in the settled cycle.
        settled: Option<ThermodynamicTemperature>,
    },
    /// Friction is extrapolated below 20 °C; it may be smaller or larger by these factors.
    FrictionExtrapolated {
        /// Smallest factor.
        low: f64,
        /// Largest factor.
        high: f64,
    },
    /// The limit is exceeded with a cold gear only.
    UntilWarm,
    /// The value is that of the instant with the highest utilisation; the largest current occurs elsewhere.
    LargestCurrentElsewhere {
        /// Largest current of the cycle.
        current: ElectricCurrent,
        /// Instant of the largest current.
        time: Time,
    },
    /// The short-time curve of the project permits a torque whose current exceeds I_max; the lower limit governs.
    CurveAboveLargestCurrent {
        /// Largest current of the curve, of T_max at most.
        current: ElectricCurrent,
    },
    /// The current exceeds I_max of the table, but nowhere that of the manufacturer's short-time curve, which permits up to
    /// this current.
    PermittedByCurve(Amount),
    /// The limit is the lower edge of an estimate; this is the upper edge.
    EstimatedUpTo(Amount),
    /// The value lies between the edges of an estimate.
    InsideBand,
    /// The utilisation is that of the rise above this temperature.
    RiseAbove(ThermodynamicTemperature),
    /// The cycle is not short compared with the winding's time constant; the effective value alone is not safe.
    CycleNotShort {
        /// Duration of the cycle.
        cycle: Time,
        /// Time constant of the winding.
        time_constant: Time,
    },
    /// Eq. 69.2 uses the accelerating time for the braking torque; the exact integral decides.
    BrakingTorqueAssumed,
    /// The recommendation holds for highly dynamic duty.
    RecommendationForHighDynamics {
        /// Largest recommended J_L/J_out.
        factor: f64,
    },
    /// The axis swings by less than the bearing bears without fretting for lack of lubrication.
    SwingTooSmall {
        /// Swing of the axis.
        swing: Angle,
        /// Least swing without fretting.
        least: Angle,
    },
    /// Small swings among larger ones.
    SmallSwings {
        /// Number in one cycle.
        count: usize,
        /// Largest of them.
        largest: Angle,
        /// Their share of the angle travelled.
        share: f64,
        /// Least swing without fretting.
        least: Angle,
    },
    /// The output bearing carries no load: any limit is met.
    NoBearingLoad,
    /// The gear's rating is that of an interchangeable gear of another manufacturer with the same T_R: as a limit it
    /// rejects no actuator.
    RatingOfInterchangeableGear,
    /// The gear's rating is estimated from the stronger series of the same manufacturer.
    RatingByStrongerGear,
    /// The limit is not derated for the stated altitude, for which the manual states no data.
    NotDeratedForAltitude,
    /// The stated derating reduces the continuous torque of this check, and no other limit.
    DeratesThisCheckOnly,
    /// The permissible loads hold one at a time; for their combination the life and the static safety decide.
    LoadsOneAtATime,
    /// The largest loads act at different instants and are combined; the worst single instant gives this value.
    AtOneInstant(Amount),
    /// The winding's temperature is an estimate; from cold it reaches its warning threshold after this time.
    WarmUp(Time),
    /// Largest temperature of the housing in the steady cycle.
    Housing(ThermodynamicTemperature),
    /// The load is under gravity or tension: a built-in holding brake is no safety brake.
    HangingLoad,
    /// Angle by which the load sags while the brake closes.
    Sag(Angle),
    /// A stop by the brake alone from the peak speed.
    BrakeStop(Box<BrakeStop>),
    /// The torque of the load exceeds that of the brake.
    BrakeDoesNotStop,
    /// Only friction holds the load in a dwell.
    NothingHolds,
    /// The load is under gravity or tension and the actuator has no brake: without power nothing holds it.
    NothingHoldsWithoutPower,
    /// Some dwells held by the brake are shorter than its closing and opening times: the motor holds these dwells
    /// entirely.
    DwellTooShortForBrake {
        /// Shortest of them.
        shortest: Time,
        /// t_c + t_o
        needed: Time,
    },
    /// t_c and t_o of this brake are not stated: those stated for the larger sizes are used.
    BrakeTimesAssumed,
    /// Time until the permissible number of applications of the brake at standstill is reached.
    BrakingsLast {
        /// Applications in one cycle.
        each_cycle: f64,
        /// Operation until the permissible number is reached, if that is stated.
        lasts: Option<Time>,
    },
    /// The duty does not fail, but a drive whose I²t supervision is set to I_0 trips.
    TripsAtStallCurrent(ElectricCurrent),
    /// The largest speed is above the end of the short-time curve, where no torque is permitted.
    AboveEndOfCurve {
        /// Largest speed at the output.
        speed: AngularVelocity,
        /// Speed at the end of the curve.
        end: AngularVelocity,
    },
    /// No threshold of a braking resistor lies between the largest voltage of the supply and U_DCmax.
    NoChopperThreshold {
        /// Largest voltage of the supply.
        supply: ElectricPotential,
        /// U_DCmax.
        limit: ElectricPotential,
    },
    /// Regenerated energy may raise the DC link above U_DCmax, for a short time only.
    DcLinkRises {
        /// Supply voltage plus rise.
        to: ElectricPotential,
        /// Rise that stays below U_DCmax.
        free: ElectricPotential,
    },
    /// Torques at which a cup-type gear of the same size ratchets and buckles, for orientation.
    Ratcheting {
        /// Torque at which the teeth jump.
        ratcheting: Torque,
        /// Torque at which the flexspline buckles, if published.
        buckling: Option<Torque>,
    },
    /// The motion requires a brake that the actuator does not have.
    NoBrake,
    /// Electrical energy of one cycle at the motor terminals.
    EnergyPerCycle {
        /// Energy taken.
        motoring: Energy,
        /// Energy regenerated.
        regenerated: Energy,
        /// Largest regenerated power.
        peak: Power,
    },
    /// Number of collisions of the stated duration that the gear bears at the peak speed.
    CollisionsPermitted(f64),
    /// Degrees of protection, compared numeral by numeral.
    Protection {
        /// Degree that the project requires.
        required: Protection,
        /// Degree of the actuator.
        printed: Protection,
    },
    /// Capacitor bank required to store the largest continuous amount of regenerated energy in one cycle.
    Capacitor {
        /// Largest continuous amount of energy.
        energy: Energy,
        /// Capacitance for the rise of the DC link voltage.
        capacitance_f: f64,
    },
    /// An axis that rotates endlessly loses its absolute reference when the count overflows.
    ReferenceLost {
        /// Turns of the motor that the encoder distinguishes.
        turns: f64,
    },
    /// The position is not absolute: the axis must be referenced after each power-on.
    NeedsReferencing,
    /// Replacement of the encoder with its battery: recommended after the first time, required after the second.
    BatteryExchange {
        /// Recommended time.
        recommended: Time,
        /// Latest time.
        latest: Time,
    },
    /// The field of application needs a risk assessment and the manufacturer's approval (section 2.4).
    ApprovalNeeded,
    /// The value is reached with every J_out, which is not known: the true one is at least as large.
    WithAnyInertia,
    /// No speed of the cycle is held constant.
    NoSpeedHeld,
    /// Output speeds at which the wave generator excites the load.
    ResonanceSpeeds(Box<ResonanceSpeeds>),
    /// First natural frequency of load and free rotor against each other.
    FreeRotor(Frequency),
    /// Budget by root of squares, and at the lever arm if there is one.
    Budget(Box<Budget>),
    /// Times with a slack rope: the results of these instants do not hold.
    RopeSlack(Box<RopeSlack>),
    /// The limit is the safe side of an open contradiction in the manual: the erratum.
    Erratum(&'static str),
}

/// Times with a slack rope, from and to, rope by rope.
#[derive(Clone, Debug, PartialEq)]
pub struct RopeSlack {
    /// Rope with beginning and end of each time.
    pub times: Vec<(Rope, Time, Time)>,
}

/// A stop by the brake alone from the peak speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BrakeStop {
    /// Angle until standstill.
    pub angle: Angle,
    /// Time until standstill.
    pub time: Time,
    /// Heat in the brake.
    pub energy: Energy,
    /// Permissible number of such stops, if stated.
    pub permitted: Option<f64>,
}

/// Output speeds at which the wave generator excites the load in the three regions of stiffness: each from that of the
/// largest to that of the least inertia of the cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResonanceSpeeds {
    /// Speeds for the load alone, with a blocked rotor.
    pub blocked: [(AngularVelocity, AngularVelocity); 3],
    /// Speeds for rotor and load against each other, if the inertia of the rotor is known.
    pub free: Option<[(AngularVelocity, AngularVelocity); 3]>,
}

/// Angular errors behind the sum of their check.
#[derive(Clone, Debug, PartialEq)]
pub struct Budget {
    /// The deviation is that along the line of the mechanism, not at a lever arm.
    pub is_along_the_line: bool,
    /// Contributions, known and unknown.
    pub errors: ErrorBudget,
    /// Worst case at the lever arm.
    pub deviation: Option<Length>,
}

impl Note {
    /// Returns `true` if the remark cites an erratum.
    #[must_use]
    pub const fn is_erratum(&self) -> bool {
        matches!(self, Self::Erratum(_))
    }
}

/// Remarks of a check. Most are equal for every candidate, and remarks of several checks are shared.
#[derive(Clone)]
pub struct Notes(Held);

#[derive(Clone)]
enum Held {
    /// Remarks that are equal for every candidate.
    Fixed(&'static [Note]),
    /// One remark with values of a candidate, the most common case.
    One(Note),
    /// Several remarks with values of a candidate.
    Found(Arc<[Note]>),
}

impl Notes {
    /// No remarks.
    pub(crate) const NONE: Self = Self::fixed(&[]);

    /// Creates remarks that are equal for every candidate.
    pub(crate) const fn fixed(notes: &'static [Note]) -> Self {
        Self(Held::Fixed(notes))
    }

    /// Adds a remark.
    pub(crate) fn push(&mut self, note: Note) {
        self.0 = match &self[..] {
            [] => Held::One(note),
            reported => Held::Found(reported.iter().cloned().chain(std::iter::once(note)).collect()),
        };
    }

    /// Adds remarks.
    pub(crate) fn extend(&mut self, notes: impl IntoIterator<Item = Note>) {
        notes.into_iter().for_each(|note| self.push(note));
    }
}

impl Deref for Notes {
    type Target = [Note];

    fn deref(&self) -> &[Note] {
        match &self.0 {
            Held::Fixed(notes) => notes,
            Held::One(note) => std::slice::from_ref(note),
            Held::Found(notes) => notes,
        }
    }
}

impl From<Note> for Notes {
    fn from(note: Note) -> Self {
        Self(Held::One(note))
    }
}

impl<const N: usize> From<[Note; N]> for Notes {
    fn from(notes: [Note; N]) -> Self {
        Self(Held::Found(Arc::new(notes)))
    }
}

impl fmt::Debug for Notes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self[..].fmt(f)
    }
}
