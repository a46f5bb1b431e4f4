//! Places in the file at which the values of an axis are stated.
//!
//! The engine does not use keys of a file: it names its inputs by roles, such as `load.inertia` or `motion.speed`. This
//! module maps a role to the keys as written: `axis[2].mechanism.turntable.body`, `motion[1].distance, motion[1].time`.

use crate::axis_project::AxisProject;
use crate::driven::Driven;
use crate::mechanism::driven;
use motion::Solved;
use project::SegmentLaw;
use project::choices::Hold;
use project::sections::{Fields, Segment, StatedField};
use quantities::{Measure, Time};

/// Segment of a value, for roles that several segments have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Within {
    /// Segment at an instant of the cycle.
    At(Time),
    /// A segment, counted from zero.
    Segment(usize),
}

impl AxisProject {
    /// Returns the keys of the file that state a value, separated by commas; a value that is not stated has the key of
    /// its place. `None` if the role is the key itself.
    ///
    /// `role`: name in the engine. `si`: the value, which distinguishes the loads of several segments.
    #[must_use]
    pub fn stated_at(&self, role: &str, si: Option<f64>, within: Within) -> Option<String> {
        let root = &self.root;
        let of_segment = |field: fn(&Segment) -> &dyn StatedField| {
            self.segment(within).map_or_else(|| root.path(role), |segment| field(segment).path())
        };
        Some(match role {
            "motion.speed" | "motion.file" => self.speed_keys(within),
            "motion.accelerate" => of_segment(|segment| &segment.accelerate),
            "motion.run" => of_segment(|segment| &segment.run),
            "motion.brake" => of_segment(|segment| &segment.brake),
            "motion.pause" => of_segment(|segment| &segment.pause),
            "motion.hold" => {
                let held = root.segments().iter().filter(|segment| segment.hold.value() == Some(Hold::Brake));
                listed(held.map(|segment| segment.hold.path()))
            }
            "load.inertia" => self.inertia_keys(),
            "load.friction_torque" | "friction_torque" => {
                let friction = driven(&root.parts).and_then(Driven::friction);
                friction.map_or_else(|| root.path(role), |friction| friction.friction_torque.path())
            }
            "stage.ratio" if !self.ratios.is_empty() => root.path("stage.ratios"),
            _ => match role.strip_prefix("bearing.").filter(|_| root.has_loads_of_segments()) {
                Some(name) => self.bearing_keys(name, si),
                None if root.head().path.is_empty() => return None,
                None => root.path(role),
            },
        })
    }

    /// Returns `true` if one of several keys of the file, separated by commas, is stated.
    #[must_use]
    pub fn states(&self, keys: &str) -> bool {
        self.root.states(keys)
    }

    fn segment(&self, within: Within) -> Option<&Segment> {
        self.root.segments().get(self.index(within)?)
    }

    fn index(&self, within: Within) -> Option<usize> {
        match within {
            Within::Segment(index) => Some(index),
            Within::At(at) => {
                let near = 1e-9 * self.axis.motion.duration().si();
                let stretches = self.axis.motion.stretches().iter().enumerate();
                let under_way = stretches.filter(|(_, stretch)| {
                    let start = stretch.start.si();
                    (start - near..=start + stretch.duration.si() + near).contains(&at.si())
                });
                // At the border of two segments the faster one applies; a recording has its speed there itself.
                let speed = |index: usize| self.solved(index).map_or(0.0, |solved| solved.speed.si());
                under_way.map(|(index, _)| index).max_by(|a, b| speed(*a).total_cmp(&speed(*b)).then(b.cmp(a)))
            }
        }
    }

    fn solved(&self, index: usize) -> Option<Solved> {
        self.axis.motion.stretches().get(index)?.solved
    }

    /// Returns the keys that decide the largest speed of a segment.
    fn speed_keys(&self, within: Within) -> String {
        let found = self.index(within).and_then(|index| Some((index, *self.root.sources().get(index)?)));
        let Some((index, segment)) = found else { return self.root.parts.motion.path() };
        if segment.recording.is_some() {
            return segment.file.path();
        }
        let given = speed_follows_from(segment.stated, self.reaches_its_speed(index, segment.stated));
        listed(given.iter().map(|field| field.path()).chain(self.gearing(&given)))
    }

    /// Returns `true` if a segment reaches its stated `speed`: a limit that is not reached has no effect.
    fn reaches_its_speed(&self, index: usize, segment: &Segment) -> bool {
        let travel = self.axis.mechanism.travel_m_per_rad();
        let stated = segment.speed.value().map(|speed| match travel.filter(|_| speed.is_of_a_line) {
            Some(travel) => speed.si / travel,
            None => speed.si,
        });
        self.solved(index).zip(stated).is_some_and(|(solved, stated)| {
            let stated = stated.abs() * self.axis.mechanism.stage_ratio();
            (solved.speed.si() - stated).abs() <= 1e-9 * stated
        })
    }

    /// Returns the keys that convert a motion stated at the load to the output: travel per turn, and the ratio of a
    /// stage.
    fn gearing(&self, stated: &[&dyn StatedField]) -> Vec<String> {
        let along = stated.iter().any(|field| field.is_of_a_line());
        let driven = driven(&self.root.parts).filter(|_| along);
        // A web turns its roll the fastest where the roll is smallest.
        let core = driven.and_then(|driven| driven.field("core_diameter")).map(|field| field.path());
        let travel = driven.and_then(Driven::travel).map(|field| field.path()).or(core);
        #[allow(clippy::float_cmp, reason = "a ratio that is written as one, or none")]
        let geared = self.axis.mechanism.stage_ratio() != 1.0;
        let ratio = geared.then(|| self.root.path(if self.ratios.is_empty() { "stage.ratio" } else { "stage.ratios" }));
        travel.into_iter().chain(ratio).collect()
    }

    /// Returns the keys that decide the moment of inertia of the load; with a payload the engine cites its model of
    /// mechanisms.
    fn inertia_keys(&self) -> String {
        let Some(driven) = driven(&self.root.parts) else { return self.root.path("load.inertia") };
        listed(driven.inertia().into_iter().filter(|field| field.is_given()).map(|field| field.path()))
    }

    /// Returns the keys of a load on the flange: under `[bearing]`, or in the segments with this load.
    fn bearing_keys(&self, name: &str, si: Option<f64>) -> String {
        let segments = self.root.segments();
        let common = self.root.parts.bearing.get();
        let common = common.filter(|_| segments.iter().any(|segment| !segment.bearing.is_given()));
        let own = segments.iter().filter_map(|segment| segment.bearing.get()).filter_map(|loads| loads.field(name));
        let stating: Vec<&dyn StatedField> = common
            .and_then(|bearing| bearing.field(name))
            .into_iter()
            .chain(own)
            .filter(|each| each.is_given())
            .collect();
        let has = |field: &&&dyn StatedField| si.is_some_and(|si| field.si() == Some(si));
        let mut equal = stating.iter().filter(has).peekable();
        if equal.peek().is_some() {
            return listed(equal.map(|field| field.path()));
        }
        match stating.as_slice() {
            [] => self.root.path(&format!("bearing.{name}")),
            several => listed(several.iter().map(|field| field.path())),
        }
    }
}

/// Returns the fields that decide the largest speed of a move by a law, depending on whether it reaches its stated
/// speed.
fn speed_follows_from(segment: &Segment, reaches_its_speed: bool) -> Vec<&dyn StatedField> {
    let all: Vec<&dyn StatedField> = match segment.law.value() {
        Some(SegmentLaw::Recorded) => vec![&segment.file],
        Some(SegmentLaw::Points) => vec![&segment.points, &segment.master_speed],
        Some(SegmentLaw::Manual | SegmentLaw::Web) => vec![&segment.speed],
        Some(SegmentLaw::Law(_) | SegmentLaw::Open | SegmentLaw::Dwell) | None if reaches_its_speed => {
            vec![&segment.speed]
        }
        Some(SegmentLaw::Law(_) | SegmentLaw::Open | SegmentLaw::Dwell) | None => {
            vec![
                &segment.distance,
                &segment.time,
                &segment.speed,
                &segment.acceleration,
                &segment.jerk,
                &segment.end_speed,
            ]
        }
    };
    all.into_iter().filter(|field| field.is_given()).collect()
}

/// Largest number of listed keys.
const LISTED_MOST: usize = 8;

fn listed(keys: impl Iterator<Item = String>) -> String {
    let mut keys: Vec<String> = keys.take(LISTED_MOST + 1).collect();
    if let Some(last) = keys.get_mut(LISTED_MOST) {
        "…".clone_into(last);
    }
    keys.join(", ")
}
