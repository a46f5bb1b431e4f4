//! Where in the file a value of an axis is stated.
//!
//! The engine knows no key of a file: it names what it was given by a role, such as `load.inertia` or `motion.speed`. Here a
//! role becomes the keys as they are written: `axis[2].mechanism.turntable.body`, `motion[1].distance, motion[1].time`.

use crate::Project;
use crate::load::is_of_a_line;
use crate::read::joined;
use crate::section::Section;
use quantities::{Measure, Time};

/// What a value belongs to, where several segments have the like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Within {
    /// The segment that is under way at an instant of the cycle.
    At(Time),
    /// A segment, counted from zero.
    Segment(usize),
}

/// The quantities of a segment from which its motion follows.
const OF_A_MOVE: [&str; 6] = ["distance", "time", "speed", "acceleration", "jerk", "end_speed"];

impl Project {
    /// The keys of the file that state a value, separated by commas; what is not written there has the key where it would be.
    /// `None` where the role is the key itself.
    ///
    /// `role`: the engine's name for it. `si`: the value, by which loads of several segments are told apart.
    #[must_use]
    pub fn stated_at(&self, role: &str, si: Option<f64>, within: Within) -> Option<String> {
        let root = &self.root;
        Some(match role {
            "motion.speed" | "motion.file" => self.speed_keys(within),
            "motion.accelerate" | "motion.run" | "motion.brake" | "motion.pause" => {
                let name = role.strip_prefix("motion.").unwrap_or(role);
                self.segment(within).map_or_else(|| joined(&root.path, role), |section| joined(&section.path, name))
            }
            "motion.hold" => {
                let held = root.tables("motion").iter().filter(|section| section.text("hold") == Some("brake"));
                listed(held.map(|section| joined(&section.path, "hold")))
            }
            "load.inertia" => self.inertia_keys(),
            "load.friction_torque" | "friction_torque" => {
                self.load().map_or_else(|| joined(&root.path, role), |(_, load)| joined(&load.path, "friction_torque"))
            }
            "stage.ratio" if !self.ratios.is_empty() => joined(&root.path, "stage.ratios"),
            _ => match role.strip_prefix("bearing.").filter(|_| self.segment_bearings) {
                Some(name) => self.bearing_keys(name, si),
                None if root.path.is_empty() => return None,
                None => joined(&root.path, role),
            },
        })
    }

    /// The table of the load: `[load]`, or that of the mechanism.
    fn load(&self) -> Option<(&'static str, &Section)> {
        let given = self.root.table("load").map(|section| ("load", section));
        given.or_else(|| self.root.table("mechanism")?.subtables().next())
    }

    fn segment(&self, within: Within) -> Option<&Section> {
        let sections = self.root.tables("motion");
        let index = match within {
            Within::Segment(index) => index,
            Within::At(at) => {
                let near = 1e-9 * self.axis.motion.duration().si();
                let stretches = self.axis.motion.stretches().iter().enumerate();
                let under_way = stretches.filter(|(_, stretch)| {
                    let start = stretch.start.si();
                    (start - near..=start + stretch.duration.si() + near).contains(&at.si())
                });
                // Where one ends and the next begins, the faster one counts; a recording has its speed there itself.
                let speed = |index: usize| match self.axis.motion.stretches().get(index).and_then(|each| each.solved) {
                    Some(solved) => solved.speed.si(),
                    None => 0.0,
                };
                under_way.map(|(index, _)| index).max_by(|a, b| speed(*a).total_cmp(&speed(*b)).then(b.cmp(a)))?
            }
        };
        sections.get(index)
    }

    /// What the largest speed of a segment follows from.
    fn speed_keys(&self, within: Within) -> String {
        let Some(section) = self.segment(within) else { return joined(&self.root.path, "motion") };
        let named = |name: &str| joined(&section.path, name);
        match section.text("law") {
            Some("recorded") => return named("file"),
            Some("manual") => return listed([named("speed")].into_iter().chain(self.gearing(section, &["speed"]))),
            _ => {}
        }
        let given: Vec<&str> = OF_A_MOVE.into_iter().filter(|name| section.get(name).is_some()).collect();
        let reached = given.contains(&"speed") && self.reaches_its_speed(section);
        let given: &[&str] = if reached { &["speed"] } else { &given };
        listed(given.iter().map(|name| named(name)).chain(self.gearing(section, given)))
    }

    /// Whether a segment gets as fast as its `speed` says: a limit that is not reached decides nothing.
    fn reaches_its_speed(&self, section: &Section) -> bool {
        let index = self.root.tables("motion").iter().position(|each| std::ptr::eq(each, section));
        let solved = index.and_then(|index| self.axis.motion.stretches().get(index)?.solved);
        let travel = self.axis.mechanism.travel_m_per_rad();
        let stated = section.along("speed").map(|(dimension, si)| match travel.filter(|_| is_of_a_line(dimension)) {
            Some(travel) => si / travel,
            None => si,
        });
        solved.zip(stated).is_some_and(|(solved, stated)| {
            let stated = stated.abs() * self.axis.mechanism.stage_ratio();
            (solved.speed.si() - stated).abs() <= 1e-9 * stated
        })
    }

    /// What makes a motion that is stated at the load one at the output: travel per turn, and the ratio of a stage.
    fn gearing(&self, section: &Section, names: &[&str]) -> Vec<String> {
        let along = names.iter().any(|name| section.along(name).is_some_and(|(dimension, _)| is_of_a_line(dimension)));
        let travel = self.load().filter(|_| along).and_then(|(name, load)| {
            let key = match name {
                "screw" => "lead",
                "belt" => "pulley_diameter",
                "conveyor" => "roller_diameter",
                _ => return None,
            };
            Some(joined(&load.path, key))
        });
        #[allow(clippy::float_cmp, reason = "a ratio that is written as one, or none")]
        let geared = self.axis.mechanism.stage_ratio() != 1.0;
        let ratio = geared
            .then(|| joined(&self.root.path, if self.ratios.is_empty() { "stage.ratio" } else { "stage.ratios" }));
        travel.into_iter().chain(ratio).collect()
    }

    /// What the moment of inertia of the load follows from; with a payload the engine cites its model of mechanisms.
    fn inertia_keys(&self) -> String {
        let Some((_, load)) = self.load() else { return joined(&self.root.path, "load.inertia") };
        let names = ["inertia", "bodies", "body"].into_iter().filter(|name| load.get(name).is_some());
        listed(names.map(|name| joined(&load.path, name)))
    }

    /// Where a load on the flange is stated: under `[bearing]`, or by the segments that have it so.
    fn bearing_keys(&self, name: &str, si: Option<f64>) -> String {
        let segments = self.root.tables("motion");
        let common = self.root.table("bearing").filter(|_| segments.iter().any(|each| each.table("bearing").is_none()));
        let own = segments.iter().filter_map(|section| section.table("bearing"));
        let stating: Vec<&Section> = common.into_iter().chain(own).filter(|each| each.get(name).is_some()).collect();
        let has = |section: &&&Section| si.is_some_and(|si| section.si(name) == Some(si));
        let mut equal = stating.iter().filter(has).peekable();
        if equal.peek().is_some() {
            return listed(equal.map(|section| joined(&section.path, name)));
        }
        match stating.as_slice() {
            [] => joined(&self.root.path, &format!("bearing.{name}")),
            several => listed(several.iter().map(|section| joined(&section.path, name))),
        }
    }
}

/// More keys than these are not named.
const LISTED_MOST: usize = 8;

fn listed(keys: impl Iterator<Item = String>) -> String {
    let mut keys: Vec<String> = keys.take(LISTED_MOST + 1).collect();
    if let Some(last) = keys.get_mut(LISTED_MOST) {
        "…".clone_into(last);
    }
    keys.join(", ")
}
