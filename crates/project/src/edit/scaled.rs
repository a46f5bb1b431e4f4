//! A segment of the motion stretched in time and distance: its stated values are scaled.

use crate::Range;
use crate::choices::Law;
use crate::edit::{Edit, EditFault, edit, written};
use crate::key::{Key, Kind};
use crate::motion::{Segment, SegmentLaw};
use crate::section::{OfKinds, Section};

/// Digits of a scaled value; more than a pointer in a picture resolves.
const DIGITS: i32 = 6;

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
    let all = written(text).ok_or(EditFault::Syntax)?;
    let value = |name: &str| {
        let path = format!("{path}.{name}");
        all.iter().find(|key| key.path == path).and_then(|key| key.value.as_deref())
    };
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
    let mut changed = text.to_owned();
    for key in Segment::KEYS {
        let (Some(stated), Some((of_time, of_way))) = (value(key.name), powers(key)) else { continue };
        let magnitude = directed && !is_way(key) || matches!(key.kind, Kind::Along(_, _, Range::Positive));
        let way = if magnitude { way.abs() } else { way };
        let factor = time.powi(of_time) * way.powi(of_way);
        if factor == 1.0 {
            continue;
        }
        let Some(scaled) = scaled(stated, factor) else { continue };
        changed = edit(&changed, &format!("{path}.{}", key.name), Edit::Value(&scaled))?;
    }
    Ok(changed)
}

/// Scales a quantity as written; a tolerance in percent is kept, one in a unit is scaled too.
fn scaled(stated: &str, factor: f64) -> Option<String> {
    let is_number = |sign: char| sign.is_ascii_digit() || matches!(sign, '.' | '+' | '-');
    let stated = stated.trim();
    let end = stated.char_indices().find(|(place, sign)| {
        let exponent = matches!(sign, 'e' | 'E')
            && stated.get(place + 1..).is_some_and(|rest| rest.starts_with(|next: char| is_number(next)));
        !is_number(*sign) && !exponent
    });
    let (number, rest) = stated.split_at_checked(end.map_or(stated.len(), |(place, _)| place))?;
    let number: f64 = number.parse().ok()?;
    let new = shown(number * factor)?;
    match ["±", "+-", "+/-"].iter().find_map(|sign| rest.split_once(sign).map(|parts| (sign, parts))) {
        Some((sign, (unit, band))) if !band.trim_end().ends_with('%') => {
            Some(format!("{new}{unit}{sign} {}", self::scaled(band, factor.abs())?))
        }
        _ => Some(format!("{new}{rest}")),
    }
}

/// Writes a number with [`DIGITS`] digits, without trailing zeros.
fn shown(number: f64) -> Option<String> {
    if !number.is_finite() {
        return None;
    }
    if number == 0.0 {
        return Some(String::from("0"));
    }
    #[allow(clippy::cast_possible_truncation, reason = "the exponent of a number")]
    let exponent = number.abs().log10().floor() as i32;
    if !(-6..=9).contains(&exponent) {
        return Some(format!("{number:.5e}"));
    }
    let places = usize::try_from(DIGITS - 1 - exponent).unwrap_or(0);
    let text = format!("{number:.places$}");
    Some(if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text })
}

#[cfg(test)]
mod tests {
    use super::*;

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
