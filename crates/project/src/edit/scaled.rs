//! A segment of the motion stretched in time and way: what is given of it is changed in proportion.

use crate::edit::{Edit, EditFault, edit, written};

/// How the quantities of a segment grow with its time and its way: power of the time, power of the way.
///
/// A law from rest to rest keeps its shape when time is stretched by k and way by m: s m, T k, v m/k, a m/k², j m/k³.
const OF_A_LAW: [(&str, i32, i32); 6] = [
    ("distance", 0, 1),
    ("time", 1, 0),
    ("speed", -1, 1),
    ("acceleration", -2, 1),
    ("jerk", -3, 1),
    ("end_speed", -1, 1),
];

/// Those of the manual's move.
const OF_THE_MANUAL: [(&str, i32, i32); 5] =
    [("speed", -1, 1), ("accelerate", 1, 0), ("run", 1, 0), ("brake", 1, 0), ("pause", 1, 0)];

/// At constant speed the way follows from the time.
const OF_CONSTANT_SPEED: [(&str, i32, i32); 2] = [("time", 1, 0), ("distance", 1, 0)];

/// Digits of what is written; more than a hand at a picture tells.
const DIGITS: i32 = 6;

/// The text with a segment that takes `time` times as long and goes `way` times as far.
///
/// `path`: of the segment. Only what is stated is changed, and its unit, tolerance and remark stay.
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
    let law = value("law").ok_or(EditFault::Path)?;
    let of: &[(&str, i32, i32)] = match law {
        "manual" => &OF_THE_MANUAL,
        "constant" => &OF_CONSTANT_SPEED,
        _ => &OF_A_LAW,
    };
    // With a distance its sign is the direction, and of all else the magnitude counts.
    let directed = value("distance").is_some();
    let mut changed = text.to_owned();
    for (name, of_time, of_way) in of {
        let Some(stated) = value(name) else { continue };
        let magnitude = directed && *name != "distance" || matches!(*name, "acceleration" | "jerk");
        let way = if magnitude { way.abs() } else { way };
        let factor = time.powi(*of_time) * way.powi(*of_way);
        if factor == 1.0 {
            continue;
        }
        let Some(scaled) = scaled(stated, factor) else { continue };
        changed = edit(&changed, &format!("{path}.{name}"), Edit::Value(&scaled))?;
    }
    Ok(changed)
}

/// A quantity as it is written, its number times a factor; a tolerance in percent stays, one in a unit grows with it.
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

/// A number with [`DIGITS`] digits, without zeros behind the last one that tells something.
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
