//! Factors in the name of a column, by which its values differ from those in the stated unit.

use crate::names::{NAME_BYTES, words};

/// Words of a factor by which the values of a column are multiplied.
const FACTOR: [&str; 8] = ["scaled", "scale", "scaling", "factor", "skaliert", "skalierung", "faktor", "mult"];

/// Returns the factor in a name without its unit, by which the values differ from those in the stated unit: `torque x10`,
/// `position*100`, `speed/1000`, `speed (1:100)`, `torque (scaled 0.1)`.
///
/// An index (`q*`, `/joint/2/effort`), a label (`X2`), and an object of a drive (`6064:00`) are none.
pub(crate) fn factor_in(bare: &str) -> Option<&str> {
    if bare.len() > NAME_BYTES {
        return None;
    }
    if words(bare).iter().any(|word| FACTOR.contains(&word.as_str())) {
        return Some(bare);
    }
    let is_number_sign = |sign: char| sign.is_ascii_digit() || matches!(sign, '.' | ',');
    let starts = bare.char_indices().filter(|(place, sign)| {
        let before = bare.get(..*place).and_then(|text| text.chars().next_back());
        sign.is_ascii_digit() && !before.is_some_and(is_number_sign)
    });
    starts.map(|(place, _)| place).find_map(|place| {
        let (before, rest) = bare.split_at_checked(place)?;
        let length = rest.find(|sign| !is_number_sign(sign)).unwrap_or(rest.len());
        let (number, behind) = rest.split_at_checked(length)?;
        let value: f64 = number.replace(',', ".").parse().ok()?;
        let is_alone = !before.ends_with(char::is_alphanumeric);
        let (before, behind) = (before.trim_end(), behind.trim_start());
        let is_power = value > 0.0 && value != 1.0 && value.log10().fract().abs() < 1e-9;
        let sign = before.chars().next_back();
        let is_times = |sign: char| matches!(sign, '*' | '·' | '×');
        // `x` is a sign of multiplication behind another word only; an axis is `X10`.
        let is_x = matches!(sign, Some('x' | 'X')) && before.len() > 1 && is_power;
        let is_over = sign == Some('/') && is_power && !behind.starts_with('/');
        let is_first = behind.starts_with(is_times) || (behind.starts_with(['x', 'X']) && is_power);
        let ratio =
            behind.strip_prefix(':').map(|rest| rest.trim_start().starts_with(|sign: char| sign.is_ascii_digit()));
        let is_ratio = value == 1.0 && ratio == Some(true)
            || is_power && behind.trim_start_matches(':').trim() == "1" && ratio == Some(true);
        let is_decimal = number.starts_with(['0']) && number.contains(['.', ',']) && value > 0.0;
        let is_exponent = behind
            .strip_prefix(['e', 'E'])
            .is_some_and(|rest| rest.trim_start_matches(['+', '-']).starts_with(|sign: char| sign.is_ascii_digit()));
        let is_factor = sign.is_some_and(is_times)
            || is_x
            || is_over
            || is_first
            || is_ratio
            || is_alone && (is_decimal || is_exponent);
        is_factor.then_some(bare)
    })
}

#[cfg(test)]
mod tests {
    use super::factor_in;

    #[test]
    fn a_factor_in_a_name_is_found_and_nothing_else() {
        for bare in [
            "torque x10",
            "torque*10",
            "torque (x100)",
            "torque *1000",
            "torque (scaled 0.1)",
            "position*100",
            "speed/1000",
            "speed (1:100)",
            "time x10",
            "10x torque",
            "10*torque",
            "Moment ×10",
            "torque 1e-3",
            "M 0,1",
            "torque scale",
            "Drehmoment (Faktor 10)",
            "speed 100:1",
            "pos / 1000",
        ] {
            assert!(factor_in(bare).is_some(), "{bare}");
        }
        for bare in [
            "torque",
            "q1",
            "X2 pos",
            "X10",
            "x10_pos",
            "/joint/10/effort",
            "/joint_2/effort",
            "6064:00",
            "0x6064 Position",
            "r0061[0]: Speed",
            "S-0-0051 Lageistwert",
            "Axis[1].ActPos",
            "Achse 10 Moment",
            "J3 torque",
            "606C:00",
            "n_1",
            "torque 2",
            "Ch1.2 pos",
            "pos_1_1",
            "v 100",
            "maximum",
            "DB1.DBD10",
            "torque 1",
            "n 1.0",
        ] {
            assert_eq!(factor_in(bare), None, "{bare}");
        }
    }
}
