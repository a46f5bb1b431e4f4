//! Inertia, speed and brake torque at the output, and what must grow or fall (tables 14.1 to 53.6).

use super::motor::each_ratio;
use super::tally::Tally;
use super::view::{AuditedCell, CellView, DriveView, Span, brief};
use std::collections::BTreeMap;

/// J_out = J i², and J_out_brake = J_brake i²
///
/// Source: chapter 6.1 of the manual; J in 10⁻⁴ kgm² at the motor, J_out in kgm² at the output.
/// Tolerance: the rounding of both values. Blamed: J_out.
pub(super) fn inertia(view: &CellView, tally: &mut Tally) {
    for drive in view.drives() {
        for (out, motor) in [("J_out", "J"), ("J_out_brake", "J_brake")] {
            let mut seen = 0;
            for cell in drive.entries.iter().filter(|entry| entry.cell.place.symbol == out) {
                let at_motor = drive.beside(motor, cell).and_then(AuditedCell::span);
                let square = cell.cell.place.ratio.parse::<f64>().ok().map(|i| i * i * 1e-4);
                let (Some(printed), Some(at_motor), Some(square)) = (cell.span(), at_motor, square) else {
                    tally.absent(cell.place());
                    continue;
                };
                seen += 1;
                let expected = at_motor * square;
                tally.compare(printed.meets(expected), &[cell], || {
                    format!("{} is {}, {motor} i² gives {expected}", cell.place(), cell.text)
                });
            }
            if seen < drive.ratios().len() {
                tally.absent(format_args!("{out} of {}", drive.name));
            }
        }
    }
}

/// n_max ≤ n_mot_max / i, and n_max = n_mot_max / i within its rounding
///
/// A speed limit that is rounded up lets the motor exceed its own limit.
///
/// Source: chapter 6.1 of the manual.
/// Tolerance: none above the quotient; half of the last printed digit of n_max below it. n_mot_max is exact (a setting,
/// not a measurement).
pub(super) fn speed(view: &CellView, tally: &mut Tally) {
    each_ratio(view, tally, "n_max", |drive, ratio, cell, tally| {
        let quotient = drive.once("n_mot_max")?.number()? / ratio.parse::<f64>().ok()?;
        let printed = cell.span()?;
        let fits = printed.mid <= quotient * (1.0 + 1e-9) && printed.high >= quotient;
        tally.compare(fits || rounded_down(printed, quotient), &[cell], || {
            format!("{} is {}, n_mot_max/i gives {}", cell.place(), cell.text, brief(quotient))
        });
        Some(())
    });
}

/// Returns `true` if a value is the next lower number with as many digits: 29 for 29.17, and 43 for 43.75 too.
fn rounded_down(printed: Span, exact: f64) -> bool {
    let digit = printed.high - printed.low;
    printed.mid <= exact && exact < printed.mid + digit
}

/// T_Br = min(T_b i, T_max) with one motor brake torque T_b per size, and T_Br ≤ T_max
///
/// T_b is read from the ratios where T_Br stays below T_max: the quotient T_Br / i that most of them agree in. Where no
/// ratio is unlimited (14A), T_b is at least the largest T_max / i.
///
/// Source: found in the tables; the manual states no formula.
/// Tolerance: the rounding of T_Br. Blamed: T_Br.
pub(super) fn brake(view: &CellView, tally: &mut Tally) {
    let mut by_size: BTreeMap<&str, Vec<(&AuditedCell, f64, f64)>> = BTreeMap::new();
    for drive in view.drives() {
        for ratio in drive.ratios() {
            let cells = drive.at("T_Br", ratio).zip(drive.at("T_max", ratio).and_then(AuditedCell::number));
            match cells.zip(ratio.parse().ok()) {
                Some(((cell, limit), i)) => by_size.entry(drive.size()).or_default().push((cell, limit, i)),
                None => tally.absent(format_args!("T_Br of {}, i = {ratio}", drive.name)),
            }
        }
    }
    for (size, cells) in by_size {
        let Some(spans) = cells.iter().map(|(cell, ..)| cell.span()).collect::<Option<Vec<Span>>>() else {
            tally.absent(format_args!("T_Br of {size}"));
            continue;
        };
        let unlimited: Vec<Span> = cells
            .iter()
            .zip(&spans)
            .filter(|((_, limit, _), span)| span.high < *limit)
            .map(|((_, _, i), span)| *span * (1.0 / i))
            .collect();
        let votes = |value: f64| unlimited.iter().filter(|span| span.meets(Span::exact(value))).count();
        let chosen = unlimited.iter().map(|span| span.mid).max_by_key(|value| votes(*value));
        let motor = chosen.unwrap_or_else(|| cells.iter().map(|(_, limit, i)| limit / i).fold(0.0, f64::max));
        for ((cell, limit, i), span) in cells.iter().zip(spans) {
            let expected = (motor * i).min(*limit);
            tally.compare(span.meets(Span::exact(expected)), &[cell], || {
                let (expected, motor) = (brief(expected), brief(motor));
                format!("{} is {}, min(T_b i, T_max) gives {expected} with T_b = {motor}", cell.place(), cell.text)
            });
            tally.compare(span.mid <= *limit, &[cell], || {
                format!("{} is {}, above T_max = {limit}", cell.place(), cell.text)
            });
        }
    }
}

/// A brake of twice the torque has no less of a rotor
///
/// T_b is the largest T_Br/i of the drive, the rotor J_brake − J.
///
/// Source: found in the tables: T_b and rotor grow together from 14A to 50A; the manual states no rule.
/// Tolerance: the rounding of both inertias. Blamed: J_brake of the stronger brake.
pub(super) fn brake_rotor(view: &CellView, tally: &mut Tally) {
    let mut brakes: Vec<(&AuditedCell, f64, Span)> = Vec::new();
    for drive in view.drives() {
        let torque = drive
            .ratios()
            .into_iter()
            .filter_map(|ratio| Some(drive.at("T_Br", ratio)?.number()? / ratio.parse::<f64>().ok()?))
            .fold(0.0, f64::max);
        for bare in drive.every("J", "") {
            let braked = drive.beside("J_brake", bare);
            match braked.zip(braked.and_then(AuditedCell::span).zip(bare.span())) {
                Some((cell, (with, without))) => brakes.push((cell, torque, with - without)),
                None => tally.absent(format_args!("J or J_brake of {}", drive.name)),
            }
        }
    }
    for (cell, torque, rotor) in &brakes {
        for (other, weaker, less) in brakes.iter().filter(|(_, weaker, _)| *torque >= 2.0 * weaker) {
            tally.compare(rotor.high >= less.low, &[cell], || {
                format!(
                    "{} is {}, its brake of {} Nm adds {}, that of {} ({} Nm) adds {}",
                    cell.place(),
                    cell.text,
                    brief(*torque),
                    brief(rotor.mid),
                    other.place(),
                    brief(*weaker),
                    brief(less.mid)
                )
            });
        }
    }
}

/// Monotonic order over the ratio, and the effect of a brake
///
/// T_max, T_0, k_Tout and K_INL do not fall with i, n_max falls, I_NLS (20 °C) does not rise; J, J_out, mass and length
/// grow with the brake.
///
/// Source: the manual's own order; a misplaced column or digit breaks it.
/// Tolerance: none, the printed numbers are compared. Blamed: both values.
pub(super) fn order(view: &CellView, tally: &mut Tally) {
    for drive in view.drives() {
        let ratios = drive.ratios();
        for ratio in ratios.windows(2) {
            let [before, after] = ratio else { continue };
            for symbol in ["T_max", "T_0", "k_Tout", "K_INL", "J_out", "J_out_brake", "n_max", "I_NLS"] {
                for first in drive.every(symbol, before).filter(|entry| !cold(entry)) {
                    let second = drive.every(symbol, after).find(|entry| {
                        (entry.cell.place.condition, entry.cell.feedback)
                            == (first.cell.place.condition, first.cell.feedback)
                    });
                    let fits: fn(f64, f64) -> bool = match symbol {
                        "n_max" => |a, b| a > b,
                        "I_NLS" => |a, b| a >= b,
                        "J_out" | "J_out_brake" => |a, b| a < b,
                        _ => |a, b| a <= b,
                    };
                    step(tally, Some(first), second, fits, "out of order with its neighbour");
                }
            }
        }
        for (without, with) in
            [("J", "J_brake"), ("J_out", "J_out_brake"), ("m", "m_brake"), ("L", "L_brake"), ("I_HBr", "I_OBr")]
        {
            for bare in drive.entries.iter().copied().filter(|entry| entry.cell.place.symbol == without) {
                let braked = drive.beside(with, bare);
                if braked.is_some_and(|entry| entry.text == "-") {
                    continue;
                }
                step(tally, Some(bare), braked, |a, b| a < b, "not below the value with which it is paired");
            }
        }
    }
}

/// Families whose sizes are compared: the 680 V windings with the lightest and with the absolute encoder.
const FAMILIES: [&[&str]; 2] = [
    &[
        "CHA-14A-H/N",
        "CHA-17A-H/N",
        "CHA-20A-C1024",
        "CHA-25A-C1024",
        "CHA-32A-C1024",
        "CHA-40A-C1024",
        "CHA-50A-C1024",
        "CHA-58A-C1024",
    ],
    &["CHA-20A-M512P", "CHA-25A-M512P", "CHA-32A-M512P", "CHA-40A-M512P", "CHA-50A-M512P", "CHA-58A-M512P"],
];

/// T_max, T_0, T_Br, mass, rotor inertia and bore do not fall from one size to the next; n_mot_max and n_N do not rise
///
/// Source: the order of the sizes; a misplaced column or digit breaks it.
/// Tolerance: none, the printed numbers are compared. Blamed: both values.
pub(super) fn sizes(view: &CellView, tally: &mut Tally) {
    for family in FAMILIES {
        for pair in family.windows(2) {
            let [smaller, larger] = pair else { continue };
            let [smaller, larger] = [smaller, larger].map(|name| view.drive(name));
            for symbol in ["T_max", "T_0", "T_Br"] {
                // Neighbouring sizes may share a brake.
                let grows: fn(f64, f64) -> bool = if symbol == "T_Br" { |a, b| a <= b } else { |a, b| a < b };
                for ratio in smaller.ratios().into_iter().filter(|ratio| larger.ratios().contains(ratio)) {
                    step(tally, smaller.at(symbol, ratio), larger.at(symbol, ratio), grows, "not below the next size");
                }
            }
            let once = |symbol: &str| (lightest(&smaller, symbol), lightest(&larger, symbol));
            for symbol in ["m", "m_brake", "J", "J_brake", "d_H"] {
                let (first, second) = once(symbol);
                step(tally, first, second, |a, b| a <= b, "above the next size");
            }
            for symbol in ["n_mot_max", "n_N"] {
                let (first, second) = once(symbol);
                step(tally, first, second, |a, b| a >= b, "below the next size");
            }
        }
    }
}

/// Returns the smallest of the values that a drive states for its encoders.
fn lightest<'a>(drive: &DriveView<'a>, symbol: &str) -> Option<&'a AuditedCell> {
    let value = |entry: &&AuditedCell| entry.number().unwrap_or(f64::INFINITY);
    drive.every(symbol, "").min_by(|a, b| value(a).total_cmp(&value(b)))
}

/// Returns `true` for I_NLS at the cold limit, which rises with i; only the value at 20 °C falls.
fn cold(entry: &AuditedCell) -> bool {
    entry.cell.place.symbol == "I_NLS" && entry.cell.place.condition.starts_with('-')
}

/// Compares two numbers of neighbouring columns.
pub(super) fn step(
    tally: &mut Tally,
    first: Option<&AuditedCell>,
    second: Option<&AuditedCell>,
    fits: impl Fn(f64, f64) -> bool,
    words: &str,
) {
    let (Some(first), Some(second)) = (first, second) else {
        let known = first.or(second).map_or_else(String::new, AuditedCell::place);
        tally.absent(format_args!("no partner of {known}"));
        return;
    };
    let (Some(a), Some(b)) = (first.number(), second.number()) else {
        tally.absent(format_args!("{} or {}", first.place(), second.place()));
        return;
    };
    tally.compare(fits(a, b), &[first, second], || {
        format!("{} is {}, {words}: {} is {}", first.place(), first.text, second.place(), second.text)
    });
}

mod tests {
    use super::super::findings_of;
    use super::*;

    fn altered(table: &str, symbol: &'static str, ratio: &'static str, text: &str) -> CellView {
        CellView::with(table, text, |cell| cell.place.symbol == symbol && cell.place.ratio == ratio)
    }

    #[test]
    fn a_changed_inertia_is_found() {
        assert_eq!(findings_of(inertia, &altered("26.2", "J_out", "100", "1,21")).len(), 1);
        // 0,13 at i = 30 has too few digits to tell, and i = 160 has an erratum.
        assert_eq!(findings_of(inertia, &altered("26.2", "J_brake", "", "1,44")).len(), 4);
    }

    #[test]
    fn an_inertia_rounded_to_one_digit_less_is_found() {
        assert_eq!(findings_of(inertia, &altered("26.2", "J_out", "160", "2,90")).len(), 1);
    }

    #[test]
    fn a_changed_speed_is_found() {
        assert_eq!(findings_of(speed, &altered("26.1", "n_max", "80", "76")).len(), 1);
        assert_eq!(findings_of(speed, &altered("26.1", "n_max", "80", "73")).len(), 1);
    }

    #[test]
    fn a_speed_rounded_up_is_found_and_one_rounded_down_is_not() {
        assert_eq!(findings_of(speed, &altered("32.1", "n_max", "120", "34")).len(), 1);
        assert!(findings_of(speed, &altered("32.1", "n_max", "120", "33")).is_empty());
    }

    #[test]
    fn a_changed_brake_torque_is_found() {
        assert_eq!(findings_of(brake, &altered("26.3", "T_Br", "50", "54")).len(), 1);
        assert_eq!(findings_of(brake, &altered("26.3", "T_Br", "100", "90")).len(), 2);
    }

    #[test]
    fn a_brake_too_light_for_its_torque_is_found() {
        let untouched = findings_of(brake_rotor, &CellView::of(super::super::TextVersion::Printed));
        let lighter = findings_of(brake_rotor, &altered("30.2", "J_brake", "", "5,0"));
        assert!(lighter.len() > untouched.len(), "{lighter:?}");
    }

    #[test]
    fn a_value_out_of_the_order_of_the_sizes_is_found() {
        assert_eq!(findings_of(sizes, &altered("30.1", "T_max", "100", "133")).len(), 1);
        assert_eq!(findings_of(sizes, &altered("30.1", "m", "", "16,6")).len(), 1);
        assert_eq!(findings_of(sizes, &altered("30.1", "n_mot_max", "", "8400")).len(), 1);
    }

    #[test]
    fn a_value_out_of_order_is_found() {
        assert_eq!(findings_of(order, &altered("26.1", "T_max", "80", "47")).len(), 1);
        assert_eq!(findings_of(order, &altered("26.1", "m_brake", "", "2,9")).len(), 1);
        let view =
            CellView::with("51.3", "117", |cell| cell.place.symbol == "L_brake" && cell.place.drive == "CHA-20A-C1024");
        assert_eq!(findings_of(order, &view).len(), 1);
    }
}
