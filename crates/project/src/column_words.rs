//! Headings of a table by the words that people have for keys, in a project that states these keys.

use crate::edit::{Written, key_at};
use crate::heading::{Counted, Heading, OF_MECHANISM, Objection, may_be_a_column, parts, underscored, with_brackets};
use crate::load::loads;
use crate::nearest::other_names;
use crate::{Fault, Hint, TabularFault};
use quantities::parse;
use std::borrow::Cow;

/// Keys of a move whose value may be the same in every move.
const OF_EVERY_MOVE: [&str; 7] =
    ["time", "acceleration", "jerk", "payload", "payload_inertia", "process_force", "process_torque"];

/// Words for the angle of a mechanism, which are words for the distance of a move too.
const ANGLES: [&str; 2] = ["angle", "winkel"];

/// Key of the angle of a mechanism.
const ANGLE_OF_MECHANISM: &str = "start_angle";

/// Heading of a key that a heading of a table stands for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HeadingMeant {
    /// Heading with the path of the key.
    pub heading: String,
    /// `true` if the key has the values with the opposite sign: the way back.
    pub is_opposite: bool,
}

/// Returns the headings that a heading of a table stands for in a project: the only stated key with this name or with one that
/// people have for it, or this key of every move. A heading that names a key, or none, is returned as it is. `prefix` stands
/// before the keys of the axis.
#[must_use]
pub fn headings_meant(all: &[Written], prefix: &str, heading: &str) -> Vec<HeadingMeant> {
    let marked = marked(heading);
    let (name, unit) = parts(&marked);
    let with_unit = |path: &str| unit.as_deref().map_or_else(|| path.to_owned(), |unit| format!("{path} [{unit}]"));
    let meant = |heading: String| HeadingMeant { heading, is_opposite: false };
    let as_it_is = || vec![meant(marked.clone().into_owned())];
    if Heading::is_one(&marked) || Counted::of([heading]) == Counted::FromZero {
        return as_it_is();
    }
    let bracketed = with_brackets(&name);
    if bracketed != name && Heading::is_one(&bracketed) {
        return vec![meant(with_unit(&bracketed))];
    }
    if let Some(path) = of_mechanism(all, prefix, &bracketed) {
        return vec![meant(with_unit(&path))];
    }
    if readings_of_angle(all, prefix, &marked).is_some() {
        return as_it_is();
    }
    let word = name.trim().to_lowercase();
    let names: Vec<&str> = std::iter::once(word.as_str()).chain(other_names(&word).iter().copied()).collect();
    let is_fitting = |path: &str| {
        let Some(key) = key_at(path).filter(|key| may_be_a_column(key)) else { return false };
        unit.as_deref().is_none_or(|unit| {
            let number = format!("1 {unit}");
            key.kind.dimensions().into_iter().any(|dimension| parse(dimension, &number).is_ok())
        })
    };
    let value = |path: &str| all.iter().find(|each| each.path == path).and_then(|each| each.value.as_deref());
    // The cycle is stated by a dwell, which is the rest of it.
    let is_of_dwell = |inside: &str| {
        let segment = inside.rsplit_once('.').map_or("", |(segment, _)| segment);
        value(&format!("{prefix}{segment}.law")) == Some("dwell") && !inside.ends_with(".cycle")
    };
    let of = |name: &&str| -> Vec<String> {
        let stated = all.iter().filter(|each| each.value.is_some()).filter_map(|each| each.path.strip_prefix(prefix));
        let named = stated.filter(|inside| inside.rsplit_once('.').is_some_and(|(_, last)| last == *name));
        named.filter(|inside| is_fitting(inside) && !is_of_dwell(inside)).map(str::to_owned).collect()
    };
    let found = names.iter().map(of).find(|found| !found.is_empty()).unwrap_or_default();
    let is_of_move = |path: &String| {
        path.strip_prefix("motion[")
            .and_then(|rest| rest.split_once("]."))
            .is_some_and(|(_, key)| OF_EVERY_MOVE.contains(&key))
    };
    // A mass may be that of the load or of what it carries at times.
    let is_mass = found.iter().any(|path| path.ends_with(".mass"));
    if is_mass && loads(all, prefix).iter().any(|load| load.is_payload) {
        return as_it_is();
    }
    match &found[..] {
        [path] => vec![meant(with_unit(path))],
        [_, _, ..] if found.iter().all(is_of_move) => found.iter().map(|path| meant(with_unit(path))).collect(),
        [first, _, ..] if found.iter().all(|path| path.starts_with("motion[") && path.ends_with("].distance")) => {
            // One value makes the distances equal, and some of them go back.
            let distance = |path: &String| value(&format!("{prefix}{path}")).unwrap_or_default();
            let amount = |path: &String| distance(path).trim_start_matches('-').to_owned();
            if found.iter().any(|path| amount(path) != amount(first)) {
                return as_it_is();
            }
            let is_back = |path: &String| distance(path).starts_with('-');
            let of =
                |path: &String| HeadingMeant { heading: with_unit(path), is_opposite: is_back(path) != is_back(first) };
            found.iter().map(of).collect()
        }
        _ => as_it_is(),
    }
}

/// Returns a heading with its unit in brackets, also if it is written behind an underscore: `time_s` is `time [s]`.
fn marked(heading: &str) -> Cow<'_, str> {
    underscored(heading).map_or(Cow::Borrowed(heading), |(name, unit)| format!("{name} [{}]", unit.ascii).into())
}

/// Returns the path of a key of the only mechanism or load that an axis states, from a path without its name:
/// `mechanism.arm.mass` for `mechanism.mass`.
fn of_mechanism(all: &[Written], prefix: &str, path: &str) -> Option<String> {
    let key = path.strip_prefix(OF_MECHANISM)?;
    let inside = all.iter().filter_map(|each| each.path.strip_prefix(prefix));
    let mut tables = inside
        .filter(|path| path.strip_prefix(OF_MECHANISM).map_or(*path == "load", |name| !name.contains(['.', '['])));
    let table = tables.next().filter(|_| tables.next().is_none())?;
    let is_angle = ANGLES.contains(&key.to_lowercase().as_str());
    [key, ANGLE_OF_MECHANISM]
        .into_iter()
        .take(if is_angle { 2 } else { 1 })
        .map(|key| format!("{table}.{key}"))
        .find(|path| Heading::is_one(path))
}

/// Returns the fault of a heading that names an angle in an axis whose mechanism has one beside the moves, and the headings that it
/// may stand for; `None` for another heading.
#[must_use]
pub fn readings_of_angle(all: &[Written], prefix: &str, heading: &str) -> Option<Objection> {
    let marked = marked(heading);
    let (name, unit) = parts(&marked);
    if !ANGLES.contains(&name.trim().to_lowercase().as_str()) {
        return None;
    }
    let angle = of_mechanism(all, prefix, &format!("{OF_MECHANISM}{ANGLE_OF_MECHANISM}"))?;
    let distances = all.iter().filter_map(|each| each.path.strip_prefix(prefix));
    let distance = distances.into_iter().find(|path| path.starts_with("motion[") && path.ends_with("].distance"))?;
    let with_unit = |path: &str| unit.as_deref().map_or_else(|| path.to_owned(), |unit| format!("{path} [{unit}]"));
    let readings = [angle.as_str(), distance].map(with_unit).to_vec();
    Some((Fault::UnknownKey { path: name.trim().to_owned() }, Some(Hint::ValidAre(readings))))
}

/// Returns the fault of a heading that names the cycle of an axis of which no dwell states it, and the headings of the stated
/// times of dwells and pauses, which fill a cycle; `None` for another heading.
#[must_use]
pub fn without_cycle(all: &[Written], prefix: &str, heading: &str) -> Option<Objection> {
    const CYCLE: &str = "cycle";
    let marked = marked(heading);
    let (name, unit) = parts(&marked);
    let word = name.trim().to_lowercase();
    if word != CYCLE && !other_names(&word).contains(&CYCLE) {
        return None;
    }
    let value = |path: &str| all.iter().find(|each| each.path == path).and_then(|each| each.value.as_deref());
    let key = |place: usize, key: &str| format!("motion[{place}].{key}");
    let is_there = |place: &usize| all.iter().any(|each| each.path == format!("{prefix}motion[{place}]"));
    let unit = unit.as_deref().unwrap_or("s");
    let time = |place: usize| {
        let is_dwell = value(&format!("{prefix}{}", key(place, "law"))) == Some("dwell");
        let time = key(place, if is_dwell { "time" } else { "pause" });
        value(&format!("{prefix}{time}")).is_some().then(|| format!("{time} [{unit}]"))
    };
    let times: Vec<String> = (1..).take_while(is_there).filter_map(time).collect();
    let fault = Fault::Tabular(TabularFault::NoCycle { path: name.trim().to_owned() });
    Some((fault, (!times.is_empty()).then_some(Hint::ValidAre(times))))
}

/// Returns the stated key that is nearest to one in an entry which its list does not have: the same key of another entry.
#[must_use]
pub fn nearest_entry(all: &[Written], path: &str) -> Option<String> {
    let (list, rest) = path.rsplit_once('[')?;
    let (number, key) = rest.split_once(']')?;
    let number: i64 = number.parse().ok()?;
    let place = |each: &Written| -> Option<i64> {
        let inside = each.path.strip_prefix(list)?.strip_prefix('[')?;
        let (other, own) = inside.split_once(']')?;
        (own == key && each.value.is_some()).then(|| other.parse().ok())?
    };
    let nearest = all.iter().filter_map(place).min_by_key(|other| (number - other).abs())?;
    Some(format!("{list}[{nearest}]{key}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edit::written;

    const TEXT: &str = "[mechanism.screw]\nmass = \"20 kg\"\nlead = \"10 mm\"\n\
        [[motion]]\nlaw = \"open\"\ndistance = \"100 mm\"\ntime = \"1 s\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"2 s\"\n\
        [[motion]]\nlaw = \"open\"\ndistance = \"-100 mm\"\ntime = \"1 s\"\n";

    fn of(all: &[Written], heading: &str) -> Vec<String> {
        let shown = |meant: HeadingMeant| format!("{}{}", if meant.is_opposite { "-" } else { "" }, meant.heading);
        headings_meant(all, "", heading).into_iter().map(shown).collect()
    }

    #[test]
    fn a_word_is_the_only_key_or_the_key_of_every_move() {
        let all = written(TEXT).unwrap();
        for (heading, meant) in [
            ("mass [kg]", &["mechanism.screw.mass [kg]"][..]),
            ("Masse [g]", &["mechanism.screw.mass [g]"]),
            ("Masse (kg)", &["mechanism.screw.mass [kg]"]),
            ("mass", &["mechanism.screw.mass"]),
            ("lead [mm]", &["mechanism.screw.lead [mm]"]),
            ("Zeit [s]", &["motion[1].time [s]", "motion[3].time [s]"]),
            ("time [ms]", &["motion[1].time [ms]", "motion[3].time [ms]"]),
            ("motion.2.time [s]", &["motion[2].time [s]"]),
            ("motion[1].time [s]", &["motion[1].time [s]"]),
            // The way back has the opposite sign.
            ("distance [mm]", &["motion[1].distance [mm]", "-motion[3].distance [mm]"]),
            ("Weg [mm]", &["motion[1].distance [mm]", "-motion[3].distance [mm]"]),
            ("mass [mm]", &["mass [mm]"]),
            ("id", &["id"]),
            // Behind an underscore, as in recordings.
            ("mass_kg", &["mechanism.screw.mass [kg]"]),
            ("time_ms", &["motion[1].time [ms]", "motion[3].time [ms]"]),
            ("motion[1].time_s", &["motion[1].time [s]"]),
            ("motion.1.time_s", &["motion[1].time [s]"]),
            ("mechanism.mass_g", &["mechanism.screw.mass [g]"]),
            ("payload_inertia", &["payload_inertia"]),
            // Without the name of the mechanism.
            ("mechanism.mass [kg]", &["mechanism.screw.mass [kg]"]),
            ("mechanism.lead [mm]", &["mechanism.screw.lead [mm]"]),
            ("mechanism.length [mm]", &["mechanism.length [mm]"]),
            ("load.mass [kg]", &["load.mass [kg]"]),
            ("angle [mm]", &["motion[1].distance [mm]", "-motion[3].distance [mm]"]),
        ] {
            assert_eq!(of(&all, heading), meant, "{heading}");
        }
        let carried = format!("{TEXT}payload = \"2 kg\"\n");
        assert_eq!(of(&written(&carried).unwrap(), "mass [kg]"), ["mass [kg]"]);
        // Of different distances one value would make equal ones.
        let other = written(&TEXT.replace("-100 mm", "-50 mm")).unwrap();
        assert_eq!(of(&other, "distance [mm]"), ["distance [mm]"]);
        let times = |all: &[Written], heading: &str| without_cycle(all, "", heading).map(|(_, hint)| hint);
        let valid = |heading: &str| Some(Some(Hint::ValidAre(vec![heading.to_owned()])));
        assert_eq!(times(&all, "Zyklus [ms]"), valid("motion[2].time [ms]"));
        assert_eq!(times(&all, "time [ms]"), None);
        let paused = "[[motion]]\nlaw = \"manual\"\nspeed = \"40 1/min\"\n";
        assert_eq!(times(&written(paused).unwrap(), "cycle"), Some(None));
        let paused = written(&format!("{paused}pause = \"1 s\"\n")).unwrap();
        assert_eq!(times(&paused, "cycle [s]"), valid("motion[1].pause [s]"));
        let cycle = written(&TEXT.replace("time = \"2 s\"", "cycle = \"5 s\"")).unwrap();
        for heading in ["cycle [s]", "Zyklus [s]", "Taktzeit [s]"] {
            assert_eq!(of(&cycle, heading), ["motion[2].cycle [s]"], "{heading}");
        }
    }

    #[test]
    fn an_angle_of_mechanism_and_moves_has_two_readings() {
        let arm = TEXT.replace("screw", "arm").replace("lead = \"10 mm\"", "length = \"1 m\"").replace("mm\"", "deg\"");
        let all = written(&arm).unwrap();
        for heading in ["angle [deg]", "Winkel [deg]", "angle_deg", "angle"] {
            let unit = if heading.contains("deg") { " [deg]" } else { "" };
            let readings = readings_of_angle(&all, "", heading).map(|(_, hint)| hint);
            let valid =
                ["mechanism.arm.start_angle", "motion[1].distance"].map(|path| format!("{path}{unit}")).to_vec();
            assert_eq!(readings, Some(Some(Hint::ValidAre(valid))), "{heading}");
            assert!(of(&all, heading).iter().all(|meant| !meant.contains("motion")), "{heading}");
        }
        assert_eq!(of(&all, "mechanism.angle [deg]"), ["mechanism.arm.start_angle [deg]"]);
        assert_eq!(of(&all, "distance [deg]").len(), 2);
        assert_eq!(readings_of_angle(&written(TEXT).unwrap(), "", "angle [deg]"), None);
    }

    #[test]
    fn the_nearest_entry_has_the_key() {
        let all = written(TEXT).unwrap();
        for (path, nearest) in [
            ("motion[7].time", Some("motion[3].time")),
            ("motion[4].distance", Some("motion[3].distance")),
            ("motion[0].time", Some("motion[1].time")),
            ("motion[4].payload", None),
            ("mechanism.screw.mass", None),
        ] {
            assert_eq!(nearest_entry(&all, path).as_deref(), nearest, "{path}");
        }
    }
}
