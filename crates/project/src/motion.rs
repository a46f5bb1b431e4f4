//! Segments of the motion: their keys, and the laws with their keys.

use crate::KeyDefault;
use crate::about::About;
use crate::cam::{CamEnds, CamPoint};
use crate::choices::{Hold, Law, Spline};
use crate::flange::FlangeLoads;
use crate::key::Variants;
use crate::recorded::{Columns, Gaps, HeldValues, Ratios, TimeStamps, Units};
use crate::section::{OfKinds, Section, names, section};
use crate::value::{Along, Rows, WordChoice, choice};
use quantities::{
    Angle, AngularAcceleration, AngularJerk, AngularVelocity, Force, Mass, MomentOfInertia, Time, Torque,
};

section! {
    /// A segment of the motion.
    Segment, SegmentName of About::Segment {
        law: SegmentLaw => needed;
        speed: Along<AngularVelocity> => stretches(-1, 1);
        accelerate: Time => not_negative, stretches(1, 0);
        run: Time => not_negative, stretches(1, 0);
        brake: Time => not_negative, stretches(1, 0);
        pause: Time => not_negative, stretches(1, 0);
        distance: Along<Angle> => stretches(0, 1);
        time: Time => not_negative, stretches(1, 0);
        cycle: Time => positive, example("2 s");
        acceleration: Along<AngularAcceleration> => positive, stretches(-2, 1);
        jerk: Along<AngularJerk> => positive, stretches(-3, 1);
        end_speed: Along<AngularVelocity> => stretches(-1, 1);
        hold: Hold = Hold::Motor => noted(KeyDefault::MotorHolds);
        file: String => example("lift.csv");
        columns: Columns;
        units: Units;
        recorded_ratio: Ratios;
        from: Time;
        to: Time;
        smoothing: Time => positive, example("20 ms");
        standstill: Along<AngularVelocity> => positive, example("0.1 1/min");
        gaps: Gaps;
        held_values: HeldValues;
        time_stamps: TimeStamps;
        payload: Mass => not_negative;
        payload_inertia: MomentOfInertia => not_negative;
        process_force: Force;
        process_torque: Torque;
        bearing: FlangeLoads;
        points: Rows<CamPoint> => example("[[\"0 s\", \"0 deg\"], [\"0.2 s\", \"30 deg\"], [\"0.5 s\", \"90 deg\"]]");
        master_speed: AngularVelocity => positive;
        spline: Spline;
        ends: CamEnds;
        start_speed: Along<AngularVelocity>;
        start_acceleration: Along<AngularAcceleration>;
        end_acceleration: Along<AngularAcceleration>;
    }
}

/// Word, law, required keys, optional keys in addition to those of every segment.
type LawLine = (&'static str, SegmentLaw, &'static [&'static str], &'static [&'static str]);

/// Keys of which any two determine a move from rest to rest.
const MOVE: &[&str] = names!(Segment: distance time speed acceleration);
const MOVE_ON: &[&str] = names!(Segment: distance time speed acceleration end_speed);

/// The laws of motion.
#[rustfmt::skip] // one line per law
const LAWS: [LawLine; 16] = [
    ("manual", SegmentLaw::Manual, names!(Segment: speed accelerate run brake pause), &[]),
    ("trapezoid", SegmentLaw::Law(Law::Trapezoid), &[], MOVE_ON),
    ("triangle", SegmentLaw::Law(Law::Triangle), &[], MOVE),
    ("jerk", SegmentLaw::Law(Law::Jerk), names!(Segment: distance speed acceleration jerk), names!(Segment: end_speed)),
    ("polynomial_5", SegmentLaw::Law(Law::Polynomial5), &[], MOVE_ON),
    ("modified_sine", SegmentLaw::Law(Law::ModifiedSine), &[], MOVE),
    ("modified_trapezoid", SegmentLaw::Law(Law::ModifiedTrapezoid), &[], MOVE),
    ("simple_sine", SegmentLaw::Law(Law::SimpleSine), &[], MOVE),
    ("inclined_sine", SegmentLaw::Law(Law::InclinedSine), &[], MOVE),
    // VDI 2143 uses this name for the triangle.
    ("parabola", SegmentLaw::Law(Law::Triangle), &[], MOVE),
    ("constant", SegmentLaw::Law(Law::Constant), names!(Segment: speed), names!(Segment: time distance)),
    ("dwell", SegmentLaw::Dwell, &[], names!(Segment: time cycle hold)),
    ("recorded", SegmentLaw::Recorded, names!(Segment: file), names!(Segment: columns units recorded_ratio from to smoothing standstill gaps held_values time_stamps)),
    ("points", SegmentLaw::Points, names!(Segment: points spline ends), names!(Segment: master_speed start_speed end_speed start_acceleration end_acceleration)),
    ("open", SegmentLaw::Open, &[], MOVE_ON),
    ("web", SegmentLaw::Web, names!(Segment: speed), names!(Segment: accelerate brake)),
];

impl OfKinds for Segment {
    #[allow(clippy::indexing_slicing, reason = "read while compiling: an index out of bounds does not compile")]
    const VARIANTS: &'static Variants = &Variants {
        keys: Self::KEYS,
        by: "law",
        kinds: &{
            let mut kinds: [(&str, &[&str], &[&str]); LAWS.len()] = [("", &[], &[]); LAWS.len()];
            let mut index = 0;
            while index < LAWS.len() {
                kinds[index] = (LAWS[index].0, LAWS[index].2, LAWS[index].3);
                index += 1;
            }
            kinds
        },
        shared: names!(Segment: payload payload_inertia process_force process_torque bearing),
    };
}

/// Law of a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SegmentLaw {
    /// A law of motion.
    Law(Law),
    /// The manual's move: a trapezoid with a pause.
    Manual,
    /// Rest.
    Dwell,
    /// A recording.
    Recorded,
    /// A spline through the points of a cam table.
    Points,
    /// A move whose law is not decided: that of [`SegmentLaw::ASSUMED`] is assumed.
    Open,
    /// The web of a winder at a constant line speed, from the initial roll to the full one or to the core.
    Web,
}

impl SegmentLaw {
    /// Law that is assumed for a move whose law is not decided.
    pub const ASSUMED: Law = Law::Polynomial5;

    /// Returns the law of a move; the assumed one if it is not decided.
    #[must_use]
    pub const fn of_a_move(self) -> Option<Law> {
        match self {
            Self::Law(law) => Some(law),
            Self::Open => Some(Self::ASSUMED),
            Self::Manual | Self::Dwell | Self::Recorded | Self::Points | Self::Web => None,
        }
    }

    /// Returns the identifier used in project files and data exchange.
    #[must_use]
    pub fn id(self) -> &'static str {
        LAWS.iter().find(|(_, law, ..)| *law == self).map_or("", |(word, ..)| word)
    }

    /// Iterates over every law, in the order of the project file.
    pub fn all() -> impl Iterator<Item = Self> {
        LAWS.iter().filter(|(word, law, ..)| law.id() == *word).map(|(_, law, ..)| *law)
    }

    /// Returns `true` if a move by this law can be stretched in time and distance by its keys.
    #[must_use]
    pub fn stretches(self) -> bool {
        let needed = LAWS.iter().find(|(_, law, ..)| *law == self).map_or(&[][..], |(_, _, needed, _)| needed);
        let grows = |name: &&str| Segment::KEYS.iter().any(|key| key.name == *name && key.stretches.is_some());
        // The distance of a web is that of its roll.
        self != Self::Web && needed.iter().all(grows)
    }

    /// Returns the law of a word of the project file; the quadratic parabola of VDI 2143 is the triangle.
    #[must_use]
    pub fn of_id(id: &str) -> Option<Self> {
        LAWS.iter().find(|(word, ..)| *word == id).map(|(_, law, ..)| *law)
    }
}

impl WordChoice for SegmentLaw {
    #[allow(clippy::indexing_slicing, reason = "read while compiling: an index out of bounds does not compile")]
    const WORDS: &'static [&'static str] = &{
        let mut words = [""; LAWS.len()];
        let mut index = 0;
        while index < LAWS.len() {
            words[index] = LAWS[index].0;
            index += 1;
        }
        words
    };

    fn of_word(word: &str) -> Option<Self> {
        Self::of_id(word)
    }
}

choice! { SegmentLaw }
