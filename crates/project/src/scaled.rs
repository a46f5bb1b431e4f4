//! Stated values that are scaled: a segment of the motion in time and distance, the load, its payloads.

use crate::Range;
use crate::choices::Law;
use crate::edit::{EditFault, edit_values, key_at, written};
use crate::key::{Key, Kind};
use crate::motion::{Segment, SegmentLaw};
use crate::section::{OfKinds, Section};
use quantities::{Dimension, parse};
use std::collections::BTreeMap;

/// Digits of a stretched segment; more than a pointer in a picture resolves.
const DIGITS: i32 = 6;

/// Digits of a value scaled by a computed factor, and of one that decides the distance: a limit that the factor just keeps
/// is kept, and a cycle stays closed.
pub(crate) const EXACT_DIGITS: i32 = 12;

/// Returns the text with a segment scaled by `time` in its duration and by `way` in its distance.
///
/// `path`: of the segment. Only stated values are changed; units, tolerances and comments are kept.
///
/// # Errors
/// [`EditFault`].
pub fn stretch(text: &str, path: &str, time: f64, way: f64) -> Result<String, EditFault> {
    if !(time.is_finite() && way.is_finite() && time > 0.0 && way != 0.0) {
        return Err(EditFault::Path);
    }
    let all = StatedValues::of(text).ok_or(EditFault::Syntax)?;
    edit_values(text, &all.stretched(path, (time, way), DIGITS)?)
}

/// Values of a text by their paths.
struct StatedValues(BTreeMap<String, String>);

impl StatedValues {
    fn of(text: &str) -> Option<Self> {
        Some(Self(written(text)?.into_iter().filter_map(|key| Some((key.path, key.value?))).collect()))
    }

    fn get(&self, path: &str) -> Option<&str> {
        self.0.get(path).map(String::as_str)
    }

    /// Returns the changed values of a segment scaled by `time` in its duration and by `way` in its distance, with so many
    /// digits where they do not decide the distance.
    fn stretched(&self, path: &str, (time, way): (f64, f64), digits: i32) -> Result<Vec<(String, String)>, EditFault> {
        let value = |name: &str| self.get(&format!("{path}.{name}"));
        let law = value(Segment::VARIANTS.by).ok_or(EditFault::Path)?;
        // At constant speed the distance follows from the time.
        let constant = SegmentLaw::of_id(law) == Some(SegmentLaw::Law(Law::Constant));
        let powers = |key: &Key| match key.stretches? {
            powers if !constant => Some(powers),
            (-1, _) => None,
            _ => Some((1, 0)),
        };
        // With a distance, its sign is the direction, and the magnitudes of the other values apply.
        let is_way = |key: &Key| key.stretches == Some((0, 1));
        let directed = Segment::KEYS.iter().any(|key| is_way(key) && value(key.name).is_some());
        let mut changed = Vec::new();
        for key in Segment::KEYS {
            let (Some(stated), Some((of_time, of_way))) = (value(key.name), powers(key)) else { continue };
            let magnitude = directed && !is_way(key) || matches!(key.kind, Kind::Along(_, _, Range::Positive));
            let way = if magnitude { way.abs() } else { way };
            let factor = time.powi(of_time) * way.powi(of_way);
            if factor == 1.0 {
                continue;
            }
            let digits = if is_way(key) || !directed { EXACT_DIGITS } else { digits };
            let Some(scaled) = scaled(stated, factor, digits) else { continue };
            changed.push((format!("{path}.{}", key.name), scaled));
        }
        Ok(changed)
    }
}

/// Returns the text with the whole motion of an axis slower by a factor, dwells and a stated cycle included; `prefix` stands
/// before the keys of the axis. `None` if a segment has no values that a factor could change: a recording, points over the
/// time, a web whose ramps are assumed.
#[must_use]
pub fn paced(text: &str, prefix: &str, factor: f64) -> Option<String> {
    let written = written(text)?;
    let is_segment = |path: &str| {
        let place = path.strip_prefix(prefix)?.strip_prefix("motion[")?.strip_suffix(']')?;
        place.parse::<usize>().ok()
    };
    let segments: Vec<String> =
        written.iter().filter(|key| is_segment(&key.path).is_some()).map(|key| key.path.clone()).collect();
    let all = StatedValues(written.into_iter().filter_map(|key| Some((key.path, key.value?))).collect());
    let mut changed = Vec::new();
    for segment in &segments {
        let mut times = |name: &str, factor: f64| {
            let path = format!("{segment}.{name}");
            let Some(stated) = all.get(&path) else { return Some(false) };
            let value = scaled(stated, factor, EXACT_DIGITS)?;
            changed.push((path, value));
            Some(true)
        };
        match all.get(&format!("{segment}.law"))? {
            "recorded" => return None,
            "points" => times("master_speed", 1.0 / factor)?.then_some(())?,
            "web" => {
                let all = [times("speed", 1.0 / factor)?, times("accelerate", factor)?, times("brake", factor)?];
                all.iter().all(|is_stated| *is_stated).then_some(())?;
            }
            // The way is kept: without its speed it would follow from the time.
            "constant" => {
                times("speed", 1.0 / factor)?;
                times("time", factor)?;
            }
            _ => {
                times("cycle", factor)?;
                changed.extend(all.stretched(segment, (factor, 1.0), EXACT_DIGITS).ok()?);
            }
        }
    }
    let changed = edit_values(text, &changed).ok()?;
    (changed != text || factor == 1.0).then_some(changed)
}

/// Returns the text with the stated masses and moments of inertia of load and mechanism scaled by `load`, and those of the
/// payloads by `payload`; `prefix` stands before the keys of the axis. Solid bodies keep their dimensions: their masses or
/// densities are scaled. `None` if the load has none, or recorded torques that a factor does not reach.
#[must_use]
pub fn load_scaled(text: &str, prefix: &str, load: f64, payload: f64) -> Option<String> {
    let all = written(text)?;
    let mut changed = Vec::new();
    for key in &all {
        let Some(inside) = key.path.strip_prefix(prefix) else { continue };
        let is_of_load = inside.starts_with("load.") || inside.starts_with("mechanism.");
        if inside.starts_with("mechanism.joint") && load != 1.0 {
            return None;
        }
        let is_payload = inside.starts_with("motion[") && inside.contains("].payload");
        let factor = if is_of_load { load } else { payload };
        let Some(stated) = key.value.as_deref().filter(|_| (is_of_load || is_payload) && factor != 1.0) else {
            continue;
        };
        let kind = key_at(inside).map(|key| key.kind);
        if let Some(Kind::Bodies) = kind {
            changed.push((key.path.clone(), bodies_scaled(stated, factor)?));
        }
        let is_density = matches!(kind, Some(Kind::Quantity(Dimension::MassDensity, _))) && inside.contains(".body[");
        if is_density || matches!(kind, Some(Kind::Quantity(Dimension::Mass | Dimension::MomentOfInertia, _))) {
            changed.push((key.path.clone(), scaled(stated, factor, EXACT_DIGITS)?));
        }
    }
    let changed = edit_values(text, &changed).ok()?;
    (changed != text || load == 1.0 && payload == 1.0).then_some(changed)
}

/// Scales the masses and densities of bodies that are written as texts, one a line.
pub(crate) fn bodies_scaled(lines: &str, factor: f64) -> Option<String> {
    let word = |word: &str| match word.split_once('=') {
        Some((key @ ("mass" | "density"), value)) => Some(format!("{key}={}", scaled(value, factor, EXACT_DIGITS)?)),
        _ => Some(word.to_owned()),
    };
    let line = |line: &str| Some(line.split(' ').map(word).collect::<Option<Vec<String>>>()?.join(" "));
    Some(lines.lines().map(line).collect::<Option<Vec<String>>>()?.join("\n"))
}

/// Scales a quantity as written; a tolerance in percent is kept, one in a unit is scaled too.
pub(crate) fn scaled(stated: &str, factor: f64, digits: i32) -> Option<String> {
    let is_number = |sign: char| sign.is_ascii_digit() || matches!(sign, '.' | '+' | '-');
    let stated = stated.trim();
    let end = stated.char_indices().find(|(place, sign)| {
        let exponent = matches!(sign, 'e' | 'E')
            && stated.get(place + 1..).is_some_and(|rest| rest.starts_with(|next: char| is_number(next)));
        !is_number(*sign) && !exponent
    });
    let (number, rest) = stated.split_at_checked(end.map_or(stated.len(), |(place, _)| place))?;
    let number: f64 = number.parse().ok()?;
    let new = shown(number * factor, digits)?;
    match ["±", "+-", "+/-"].iter().find_map(|sign| rest.split_once(sign).map(|parts| (sign, parts))) {
        Some((sign, (unit, band))) if !band.trim_end().ends_with('%') => {
            Some(format!("{new}{unit}{sign} {}", self::scaled(band, factor.abs(), digits)?))
        }
        _ => Some(format!("{new}{rest}")),
    }
}

/// Returns a quantity as stated, multiplied by a factor; `None` for a text that begins with no number.
#[must_use]
pub fn multiplied(stated: &str, factor: f64) -> Option<String> {
    scaled(stated, factor, EXACT_DIGITS)
}

/// Returns the sum of a stated quantity and another one, in the stated unit and with the stated tolerance: `80 kg` and `+5kg` are
/// `85 kg`. `None` if one of them is no quantity of the dimension.
#[must_use]
pub fn increased(stated: &str, by: &str, dimension: Dimension) -> Option<String> {
    let end = ["±", "+-", "+/-"].iter().filter_map(|sign| stated.find(sign)).min().unwrap_or(stated.len());
    let end = stated.get(..end)?.trim_end().len();
    let (value, tolerance) = stated.split_at_checked(end)?;
    let (old, more) = (parse(dimension, value).ok()?.si, parse(dimension, by).ok()?.si);
    if old == 0.0 {
        return Some(by.trim().trim_start_matches('+').to_owned());
    }
    Some(format!("{}{tolerance}", scaled(value, (old + more) / old, EXACT_DIGITS)?))
}

/// Writes a number with some digits, without trailing zeros.
pub(crate) fn shown(number: f64, digits: i32) -> Option<String> {
    if !number.is_finite() {
        return None;
    }
    if number == 0.0 {
        return Some(String::from("0"));
    }
    #[allow(clippy::cast_possible_truncation, reason = "the exponent of a number")]
    let exponent = number.abs().log10().floor() as i32;
    if !(-6..=9).contains(&exponent) {
        return Some(format!("{number:.*e}", usize::try_from(digits - 1).unwrap_or(0)));
    }
    let places = usize::try_from(digits - 1 - exponent).unwrap_or(0);
    let text = format!("{number:.places$}");
    Some(if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A factor that just reaches a limit is kept up to the rounding of twelve digits.
    #[test]
    fn a_pace_is_kept_to_twelve_digits() {
        let text = "[[motion]]\nlaw = \"trapezoid\"\ndistance = \"1 rad\"\ntime = \"0.8 s\"\n\
            [[motion]]\nlaw = \"dwell\"\ntime = \"0.3 s\"\n";
        for factor in [1.0 / 3.0, 1.338_461_538_461, 7.0 / 6.0, 1.000_001] {
            let paced = paced(text, "", factor).unwrap();
            let times = written(&paced).unwrap().into_iter().filter(|key| key.path.ends_with(".time"));
            let seconds = times.map(|key| key.value.unwrap().trim_end_matches(" s").parse::<f64>().unwrap());
            let sum: f64 = seconds.sum();
            assert!((sum / (1.1 * factor) - 1.0).abs() < 1e-11, "{factor}: {paced}");
        }
    }

    #[test]
    fn what_is_given_grows_in_proportion_and_the_rest_stays() {
        let text = "[[motion]]\nlaw = \"jerk\" # fast\ndistance = \"-800 mm\"\nspeed = \"0.5 m/s\"\n\
            acceleration = \"2.5 m/s^2 ± 4 %\"\njerk = \"40 m/s^3 +- 2 m/s^3\"\n";
        let doubled = stretch(text, "motion[1]", 2.0, 0.5).unwrap();
        let expected = "[[motion]]\nlaw = \"jerk\" # fast\ndistance = \"-400 mm\"\nspeed = \"0.125 m/s\"\n\
            acceleration = \"0.3125 m/s^2 ± 4 %\"\njerk = \"2.5 m/s^3 +- 0.125 m/s^3\"\n";
        assert_eq!(doubled, expected);
        let turned = stretch(text, "motion[1]", 1.0, -1.0).unwrap();
        assert!(turned.contains("\"800 mm\"") && turned.contains("\"0.5 m/s\""), "{turned}");
    }

    #[test]
    fn masses_and_inertias_of_the_load_are_scaled_and_those_of_its_payloads_apart() {
        let text = "[mechanism.belt]\nmass = \"18 kg ± 1 kg\" # slide\npulley_diameter = \"120 mm\"\ninertia = \"0.004 kg m^2\"\n\
            [[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\npayload = \"3 kg\"\n";
        let heavier = load_scaled(text, "", 1.15, 1.15).unwrap();
        for part in ["\"20.7 kg ± 1.15 kg\" # slide", "\"120 mm\"", "\"0.0046 kg m^2\"", "\"3.45 kg\""] {
            assert!(heavier.contains(part), "{part}\n{heavier}");
        }
        assert_eq!(load_scaled(text, "", 1.0, 2.0).unwrap(), text.replace("3 kg", "6 kg"));
        for (body, heavier) in [
            (
                "bodies = [\"disc diameter=1m mass=2kg\", \"point mass=1.5kg distance=1m\"]",
                "bodies = [\n  \"disc diameter=1m mass=4kg\",\n  \"point mass=3kg distance=1m\",\n]",
            ),
            (
                "bodies = [\"sphere diameter=1m density=2g/cm^3\"]",
                "bodies = [\n  \"sphere diameter=1m density=4g/cm^3\",\n]",
            ),
            (
                "[[mechanism.turntable.body]]\nshape = \"disc\"\ndiameter = \"1 m\"\nmass = \"8 kg ± 5 %\"",
                "[[mechanism.turntable.body]]\nshape = \"disc\"\ndiameter = \"1 m\"\nmass = \"16 kg ± 5 %\"",
            ),
            (
                "[[mechanism.turntable.body]]\nshape = \"sphere\"\ndiameter = \"1 m\"\ndensity = \"2 kg/m^3\"",
                "[[mechanism.turntable.body]]\nshape = \"sphere\"\ndiameter = \"1 m\"\ndensity = \"4 kg/m^3\"",
            ),
        ] {
            let table = |body: &str| format!("[mechanism.turntable]\n{body}\n");
            assert_eq!(load_scaled(&table(body), "", 2.0, 1.0), Some(table(heavier)), "{body}");
        }
        let joint = "[mechanism.joint]\ninertia = \"1 kg m^2\"\n";
        assert_eq!(load_scaled(joint, "", 2.0, 2.0), None);
        assert_eq!(load_scaled("[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n", "", 2.0, 2.0), None);
    }

    #[test]
    fn a_sum_has_the_unit_and_the_tolerance_of_the_stated_value() {
        for (stated, by, sum) in [
            ("80 kg", "+5kg", "85 kg"),
            ("80 kg", "-5000 g", "75 kg"),
            ("0.8 s", "+200 ms", "1 s"),
            ("8 kg ± 1 kg", "+2 kg", "10 kg ± 1 kg"),
            ("0 kg", "+2 kg", "2 kg"),
            ("3kg", "-4kg", "-1kg"),
        ] {
            let dimension = if stated.contains('s') { Dimension::Time } else { Dimension::Mass };
            assert_eq!(increased(stated, by, dimension).as_deref(), Some(sum), "{stated} {by}");
        }
        assert_eq!(increased("80 kg", "+5 s", Dimension::Mass), None);
    }

    #[test]
    fn a_slower_motion_keeps_its_way_and_its_cycle_grows_with_it() {
        let motion = |segments: &str| format!("[[motion]]\n{}\n", segments.replace("; ", "\n"));
        for (stated, slower) in [
            ("law = \"dwell\"; cycle = \"4 s\"", Some("law = \"dwell\"; cycle = \"8 s\"")),
            ("law = \"constant\"; speed = \"30 1/min\"", Some("law = \"constant\"; speed = \"15 1/min\"")),
            (
                "law = \"constant\"; speed = \"30 1/min\"; distance = \"360 deg\"",
                Some("law = \"constant\"; speed = \"15 1/min\"; distance = \"360 deg\""),
            ),
            (
                "law = \"constant\"; speed = \"30 1/min\"; time = \"2 s\"",
                Some("law = \"constant\"; speed = \"15 1/min\"; time = \"4 s\""),
            ),
            (
                "law = \"polynomial_5\"; distance = \"90 deg\"; time = \"1 s\"",
                Some("law = \"polynomial_5\"; distance = \"90 deg\"; time = \"2 s\""),
            ),
            ("law = \"recorded\"; file = \"run.csv\"", None),
            ("law = \"web\"; speed = \"60 m/min\"", None),
        ] {
            assert_eq!(paced(&motion(stated), "", 2.0), slower.map(motion), "{stated}");
        }
    }

    /// The time of a change grows with the number of segments: of ten times as many, at most some thirty times as long.
    #[test]
    fn a_long_cycle_is_slowed_in_proportion_to_its_length() {
        let cycle = |segments: usize| {
            "[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n".repeat(segments)
        };
        let seconds = |segments: usize| {
            let text = cycle(segments);
            let begin = std::time::Instant::now();
            let slower = paced(&text, "", 2.0).unwrap();
            assert_eq!(slower, text.replace("1 s", "2 s"));
            begin.elapsed().as_secs_f64()
        };
        // Other programs of the machine disturb some of the tries.
        let mut tries = Vec::new();
        let is_in_proportion = (0..5).any(|_| {
            let few = (0..3).map(|_| seconds(400)).fold(f64::INFINITY, f64::min);
            let many = seconds(4_000);
            tries.push([few, many]);
            many < 30.0 * few
        });
        assert!(is_in_proportion, "{tries:?} s");
    }

    #[test]
    fn where_no_distance_tells_the_direction_the_speed_turns() {
        let text = "[[motion]]\nlaw = \"manual\"\nspeed = \"4e1 1/min\"\naccelerate = \"100 ms\"\nrun = \"0 s\"\n\
            brake = \"0.1 s\"\npause = \"1 s\"\n";
        let found = stretch(text, "motion[1]", 2.0, -1.0).unwrap();
        assert!(
            found.contains("\"-20 1/min\"") && found.contains("\"200 ms\"") && found.contains("\"2 s\""),
            "{found}"
        );
        assert!(found.contains("run = \"0 s\"") && found.contains("brake = \"0.2 s\""), "{found}");
    }

    #[test]
    fn what_is_no_stretch_changes_nothing() {
        let text = "[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n";
        for (time, way) in [(0.0, 1.0), (-1.0, 1.0), (f64::NAN, 1.0), (1.0, 0.0), (1.0, f64::INFINITY)] {
            assert_eq!(stretch(text, "motion[1]", time, way), Err(EditFault::Path));
        }
        assert_eq!(stretch(text, "motion[2]", 2.0, 1.0), Err(EditFault::Path));
        assert_eq!(stretch("a = = b", "motion[1]", 2.0, 1.0), Err(EditFault::Syntax));
    }
}
