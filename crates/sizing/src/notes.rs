//! What there is to remark about the answer of a check.

use crate::check::Amount;
use actuator::Protection;
use mechanism::Rope;
use quantities::{
    Angle, AngularVelocity, ElectricCurrent, ElectricPotential, Energy, Frequency, Length, Power,
    ThermodynamicTemperature, Time, Torque,
};
use std::fmt;
use std::ops::Deref;
use std::sync::Arc;

/// What a reader must know about a check beyond its numbers.
///
/// Of every candidate some are kept: what is longer than three numbers stands in a box.
#[derive(Clone, Debug, PartialEq)]
pub enum Note {
    /// Friction counts with the gear as cold as the air and with the gear as warm as the cycle makes it, if that is known;
    /// the larger current decides.
    FrictionTemperatures {
        /// Of the air.
        cold: ThermodynamicTemperature,
        /// Of the housing in the settled cycle.
        settled: Option<ThermodynamicTemperature>,
    },
    /// Below 20 °C friction is extrapolated; it may be so many times smaller or larger.
    FrictionExtrapolated {
        /// Smallest factor.
        low: f64,
        /// Largest factor.
        high: f64,
    },
    /// The limit is exceeded with a cold gear only.
    UntilWarm,
    /// The limit is the lower edge of an estimate; the upper edge is this figure.
    EstimatedUpTo(Amount),
    /// The value lies between the edges of an estimate.
    InsideBand,
    /// The utilisation is that of the rise above this temperature.
    RiseAbove(ThermodynamicTemperature),
    /// The cycle is not short against the winding's time constant; the effective value alone is not safe.
    CycleNotShort {
        /// Duration of the cycle.
        cycle: Time,
        /// Time constant of the winding.
        time_constant: Time,
    },
    /// Eq. 69.2 takes the braking torque from the accelerating time; the exact integral decides.
    BrakingTorqueAssumed,
    /// The recommendation holds for highly dynamic duty.
    RecommendationForHighDynamics {
        /// Largest J_L/J_out recommended.
        factor: f64,
    },
    /// The axis swings by less than the bearing bears without fretting for want of lubrication.
    SwingTooSmall {
        /// Swing of the axis.
        swing: Angle,
        /// Least swing without fretting.
        least: Angle,
    },
    /// Such swings among larger ones.
    SmallSwings {
        /// How many happen in one cycle.
        count: usize,
        /// The largest of them.
        largest: Angle,
        /// Their share of the angle travelled.
        share: f64,
        /// Least swing without fretting.
        least: Angle,
    },
    /// The gear's rating is that of an interchangeable gear of another maker with the same T_R: as a limit it rejects nothing.
    RatingOfInterchangeableGear,
    /// The gear's rating is estimated from the stronger series of the same maker.
    RatingByStrongerGear,
    /// The permissible loads hold one at a time; together the life and the static safety decide.
    LoadsOneAtATime,
    /// The winding's temperature is an estimate; from cold it reaches its warning threshold after this time.
    WarmUp(Time),
    /// The largest temperature of the housing in the steady cycle.
    Housing(ThermodynamicTemperature),
    /// The load hangs: a built-in holding brake is no safety brake.
    HangingLoad,
    /// While the brake closes the load sags by this angle.
    Sag(Angle),
    /// A stop by the brake alone from the peak speed.
    BrakeStop(Box<BrakeStop>),
    /// The load drives harder than the brake holds.
    BrakeDoesNotStop,
    /// In a dwell nothing holds the load but its friction.
    NothingHolds,
    /// The load hangs and the actuator has no brake: without power nothing holds it.
    NothingHoldsWithoutPower,
    /// Some dwells held by the brake are shorter than it takes to close and to open: the motor holds all of them.
    DwellTooShortForBrake {
        /// The shortest of them.
        shortest: Time,
        /// t_c + t_o
        needed: Time,
    },
    /// t_c and t_o of this brake are not printed: those printed for the larger sizes were taken.
    BrakeTimesAssumed,
    /// How long the permitted applications of the brake at standstill last.
    BrakingsLast {
        /// Applications in one cycle.
        each_cycle: f64,
        /// Operation until the permitted number is reached, if that is printed.
        lasts: Option<Time>,
    },
    /// The duty does not fail, and a drive whose I²t supervision is set to I_0 trips all the same.
    TripsAtStallCurrent(ElectricCurrent),
    /// No threshold of a brake resistor lies between the largest voltage of the supply and U_DCmax.
    NoChopperThreshold {
        /// The largest voltage of the supply.
        supply: ElectricPotential,
        /// U_DCmax.
        limit: ElectricPotential,
    },
    /// While energy comes back the DC link may rise above U_DCmax, for a short time only.
    DcLinkRises {
        /// Supply and rise together.
        to: ElectricPotential,
        /// The rise that stays below U_DCmax.
        free: ElectricPotential,
    },
    /// Torques at which a cup-type gear of the same size ratchets and buckles, for orientation.
    Ratcheting {
        /// At this torque the teeth jump.
        ratcheting: Torque,
        /// At this torque the flexspline buckles, if published.
        buckling: Option<Torque>,
    },
    /// The motion requires a brake that the actuator does not have.
    NoBrake,
    /// Electrical energy of one cycle at the motor terminals.
    EnergyPerCycle {
        /// Taken in.
        motoring: Energy,
        /// Given back.
        regenerated: Energy,
        /// Largest power given back.
        peak: Power,
    },
    /// How many collisions of the stated duration the gear bears at the peak speed.
    CollisionsPermitted(f64),
    /// The degrees of protection that are compared numeral by numeral.
    Protection {
        /// Stated by the project.
        required: Protection,
        /// That of the actuator.
        printed: Protection,
    },
    /// What a capacitor bank must have to take back what one cycle returns at a stretch.
    Capacitor {
        /// Energy at a stretch.
        energy: Energy,
        /// Capacitance for the rise of the DC link voltage.
        capacitance_f: f64,
    },
    /// An axis that turns on and on loses its absolute reference where the count overflows.
    ReferenceLost {
        /// Turns of the motor that the encoder distinguishes.
        turns: f64,
    },
    /// The position is not absolute: it must be searched after each switching on.
    NeedsReferencing,
    /// The encoder with its battery should be exchanged after the first, must be after the second time.
    BatteryExchange {
        /// Recommended.
        recommended: Time,
        /// At the latest.
        latest: Time,
    },
    /// The field of application needs a risk assessment and the maker's approval (section 2.4).
    ApprovalNeeded,
    /// Output speeds at which the wave generator excites the load.
    ResonanceSpeeds(Box<ResonanceSpeeds>),
    /// First natural frequency of load and free rotor against each other.
    FreeRotor(Frequency),
    /// The budget by root of squares, and at the lever arm if there is one.
    Budget(Box<Budget>),
    /// Times for which a rope would be slack: the results of these instants do not hold.
    RopeSlack(Box<RopeSlack>),
    /// The limit is the safe side of an open contradiction in the print: the erratum.
    Erratum(&'static str),
}

/// Times for which a rope would be slack, from and to, rope by rope.
#[derive(Clone, Debug, PartialEq)]
pub struct RopeSlack {
    /// The rope with beginning and end of each.
    pub times: Vec<(Rope, Time, Time)>,
}

/// A stop by the brake alone from the peak speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BrakeStop {
    /// Angle until rest.
    pub angle: Angle,
    /// Time until rest.
    pub time: Time,
    /// Heat in the brake.
    pub energy: Energy,
    /// How many such stops are permitted, if printed.
    pub permitted: Option<f64>,
}

/// Output speeds at which the wave generator excites the load in the three regions of stiffness: each from that of the
/// largest to that of the least inertia of the cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResonanceSpeeds {
    /// The load swings alone.
    pub blocked: [(AngularVelocity, AngularVelocity); 3],
    /// The rotor swings against it, if its inertia is known.
    pub free: Option<[(AngularVelocity, AngularVelocity); 3]>,
}

/// The sum of the angular errors, in other forms than in its check.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Budget {
    /// Root of the sum of squares.
    pub root_sum_square: Angle,
    /// Worst case at the lever arm.
    pub deviation: Option<Length>,
    /// How many contributions are not known.
    pub missing: usize,
}

impl Note {
    /// Whether the remark cites an erratum.
    #[must_use]
    pub const fn is_erratum(&self) -> bool {
        matches!(self, Self::Erratum(_))
    }
}

/// Remarks of a check. Most are the same for every candidate, and what several checks remark is shared.
#[derive(Clone)]
pub struct Notes(Held);

#[derive(Clone)]
enum Held {
    /// The same for every candidate.
    Fixed(&'static [Note]),
    /// One with figures of a candidate, as most have.
    One(Note),
    /// Several with such figures.
    Found(Arc<[Note]>),
}

impl Notes {
    /// None.
    pub(crate) const NONE: Self = Self::fixed(&[]);

    /// Those that are the same for every candidate.
    pub(crate) const fn fixed(notes: &'static [Note]) -> Self {
        Self(Held::Fixed(notes))
    }

    /// Adds one.
    pub(crate) fn push(&mut self, note: Note) {
        self.0 = match &self[..] {
            [] => Held::One(note),
            [one] => Held::Found(Arc::new([one.clone(), note])),
            reported => Held::Found(reported.iter().cloned().chain(std::iter::once(note)).collect()),
        };
    }

    /// Adds some.
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
