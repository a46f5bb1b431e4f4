//! Values for the drawing of a mechanism, as far as they can be read from a project file.

use mechanism::ArmShape;
use mechanism::drawing::MechanismValues;
use quantities::{Unit, without_tolerance};

/// Returns the values of a mechanism among those of a file, by path and text: those of the mechanism's own table, and
/// the overhang of `[bearing]` in the same axis.
///
/// A value that cannot be read, e.g. while it is being typed, is unknown.
#[must_use]
pub fn drawn_figures<'t>(values: impl IntoIterator<Item = (&'t str, &'t str)>, table: &str) -> MechanismValues {
    let axis = table.find("].").map_or("", |end| table.get(..end + 2).unwrap_or_default());
    values.into_iter().fold(MechanismValues::none(), |known, (path, text)| {
        let own = path.strip_prefix(table).and_then(|rest| rest.strip_prefix('.'));
        let key = own.filter(|key| !key.contains(['.', '['])).or_else(|| {
            let outside = path.strip_prefix(axis)?.strip_prefix("bearing.")?;
            Some(outside).filter(|key| *key == "overhang")
        });
        match key.zip(amount(text)) {
            Some((key, si)) => known.with(key, si),
            None => known,
        }
    })
}

/// Returns a number with its unit in SI; for the words of a drawing, their numeric values.
fn amount(text: &str) -> Option<f64> {
    match text.trim() {
        "true" | "up" => return Some(1.0),
        // The share of an arm's length at which its centre of mass is.
        "rod" | "bar" => return Some(ArmShape::Rod.centre()),
        "taper" => return Some(ArmShape::Taper.centre()),
        "point" => return Some(ArmShape::Point.centre()),
        "off" => return Some(-1.0),
        _ => {}
    }
    let text = without_tolerance(text).trim();
    let end = text.find(|sign: char| !matches!(sign, '0'..='9' | '.' | '-' | '+' | 'e' | 'E')).unwrap_or(text.len());
    // The `e` of a unit does not belong to the number.
    let number = text.get(..end)?.trim_end_matches(['e', 'E']);
    let unit = text.get(number.len()..)?.trim();
    let value: f64 = number.parse().ok()?;
    if unit.is_empty() { Some(value) } else { Some(Unit::of(unit)?.to_si(value)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_figures_are_those_of_the_mechanism_and_its_axis() {
        let values = [
            ("axis[1].mechanism.arm.centre_distance", "9 m"),
            ("axis[2].mechanism.arm.centre_distance", "400 mm ± 5 mm"),
            ("axis[2].mechanism.arm.axis_tilt", "90 deg"),
            ("axis[2].mechanism.arm.payload_distance", "0.8"),
            ("axis[2].mechanism.arm.start_angle", "-"),
            ("axis[2].bearing.overhang", "60 mm"),
            ("axis[1].bearing.overhang", "70 mm"),
            ("axis[2].bearing.radial_distance", "80 mm"),
        ];
        let found = drawn_figures(values, "axis[2].mechanism.arm");
        assert_eq!(found.of("centre_distance"), Some(0.4));
        assert!((found.of("axis_tilt").unwrap_or_default() - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
        assert_eq!([found.of("payload_distance"), found.of("overhang")], [Some(0.8), Some(0.06)]);
        assert_eq!([found.of("start_angle"), found.of("radial_distance")], [None, None]);
    }

    #[test]
    fn words_stand_for_numbers() {
        let found = drawn_figures(
            [("mechanism.winder.winding", "off"), ("mechanism.winder.width", "600 mm"), ("bearing.overhang", "1e2 mm")],
            "mechanism.winder",
        );
        assert_eq!(found.of("winding"), Some(-1.0));
        assert!((found.of("overhang").unwrap_or_default() - 0.1).abs() < 1e-12);
    }
}
