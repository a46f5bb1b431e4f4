//! Tables of other sources against each other and against the manual.

use super::output::step;
use super::tally::Tally;
use super::view::{AuditedCell, CellView, brief};

/// KTY 84-130: rising, typical values within 1.1 ohm of the data sheet's closed form, the bounds on both sides of them
///
/// R = 1000 (1 + 6.12·10⁻³ (T − 100) + 1.1·10⁻⁵ (T − 100)² − 3.14·10⁻⁸ max(T − 250, 0)^3.6)
///
/// Source: NXP data sheet KTY84 series rev. 06 (nxp-kty84).
/// Tolerance: 1.1 ohm; the worst of the 36 points is 1.04 ohm off, at 300 °C.
pub(super) fn temperature_sensor(view: &CellView, tally: &mut Tally) {
    let of = |which: &str| -> Vec<&AuditedCell> {
        let cells = view.row("kty84-130", "R_KTY");
        cells.filter(|cell| cell.cell.place.condition.starts_with(which)).collect()
    };
    let [least, row, largest] = ["least", "typical", "largest"].map(of);
    for row in [&least, &row, &largest] {
        rising(tally, row);
    }
    for ((low, middle), high) in least.iter().zip(&row).zip(&largest) {
        let (Some(from), Some(typical), Some(to)) = (low.number(), middle.number(), high.number()) else { continue };
        // Printed to whole ohms on both sides of the typical value, 3 % of it at least.
        let is_right = (typical - from - (to - typical)).abs() <= 4.0 && from <= 0.97 * typical + 0.5;
        tally.compare(is_right, &[low, middle, high], || {
            format!("{} lies between {} and {}", middle.place(), brief(from), brief(to))
        });
    }
    for cell in row {
        let head =
            cell.cell.place.condition.split(", ").find_map(|part| part.strip_suffix(" degC")?.parse::<f64>().ok());
        let Some((printed, temperature)) = cell.number().zip(head) else {
            tally.absent(cell.place());
            continue;
        };
        let from_hundred = temperature - 100.0;
        let above = (temperature - 250.0).max(0.0);
        let expected =
            1000.0 * (1.0 + 6.12e-3 * from_hundred + 1.1e-5 * from_hundred.powi(2) - 3.14e-8 * above.powf(3.6));
        tally.compare((printed - expected).abs() <= 1.1, &[cell], || {
            format!("{} is {}, the closed form gives {}", cell.place(), cell.text, brief(expected))
        });
    }
}

/// PTC thermistors: the limits rise with temperature, and three sensors have three times the limit of one
///
/// Source: DIN 44081 and DIN 44082 as siemens-1fw6 quotes them; three and one in series have four times the single limit.
/// Tolerance: none.
pub(super) fn thermistor(view: &CellView, tally: &mut Tally) {
    let every: Vec<&AuditedCell> = view.row("ptc-din44081", "R_PTC").collect();
    let of = |kind: &str| -> Vec<&AuditedCell> {
        every.iter().copied().filter(|entry| entry.cell.place.condition.split(", ").any(|part| part == kind)).collect()
    };
    let single = of("single");
    for (kind, times) in [("single", 1.0), ("triple", 3.0), ("triple and single in series", 4.0)] {
        let row: Vec<&AuditedCell> = of(kind).into_iter().filter(|entry| !entry.text.is_empty()).collect();
        rising(tally, &row);
        for cell in row {
            let one = single.iter().find(|entry| entry.cell.column == cell.cell.column);
            step(
                tally,
                one.copied(),
                Some(cell),
                |a, b| (a * times - b).abs() < 1e-9,
                "not in the ratio of the sensors",
            );
        }
    }
}

/// Gear ratings: T_N < T_A < T_R < T_M, and T_R = T_max of the CHA
///
/// Source: zd-shf-2uh, an interchangeable gear; that its T_R is the T_max of the CHA is the reason to use it.
/// Tolerance: none.
pub(super) fn gear_ratings(view: &CellView, tally: &mut Tally) {
    let get = |symbol: &str, like: &AuditedCell| {
        view.row("gear-ratings", symbol)
            .find(|entry| {
                (entry.cell.place.drive, entry.cell.place.ratio) == (like.cell.place.drive, like.cell.place.ratio)
            })
            .cloned()
    };
    let mut seen = 0;
    for repeated in view.row("gear-ratings", "T_R").filter(|entry| !entry.text.is_empty()) {
        seen += 1;
        let chain = [get("T_N", repeated), get("T_A", repeated), Some(repeated.clone()), get("T_M", repeated)];
        for pair in chain.windows(2) {
            if let [first, second] = pair {
                step(tally, first.as_ref(), second.as_ref(), |a, b| a < b, "not below the next limit");
            }
        }
        for drive in catalogue::drives().iter().filter(|drive| drive.name.starts_with(repeated.cell.place.drive)) {
            let maximum = view.drive(drive.name).at("T_max", repeated.cell.place.ratio);
            step(tally, Some(repeated), maximum, |a, b| (a - b).abs() < 1e-9, "T_R is not T_max of the CHA");
        }
    }
    if seen == 0 {
        tally.absent("T_R of gear-ratings");
    }
}

/// T_N of an interchangeable gear and T_max of the CHA are T_N and T_R of the stronger series over 1.3, the calibration
/// `stronger_gear_factor`
///
/// Source: shg-shf-2uh-lw-catalogue, zd-shf-2uh and the manual.
/// Tolerance: the rounding of both values. Blamed: both.
pub(super) fn stronger_gear(view: &CellView, tally: &mut Tally) {
    let factor = view.row("family", "stronger_gear_factor").find_map(AuditedCell::number);
    let mut seen = 0;
    for cell in view.row("gear-ratings", "T_N").filter(|entry| !entry.text.is_empty()) {
        let place = |entry: &AuditedCell| (entry.cell.place.drive, entry.cell.place.ratio);
        let stronger = view.row("gear-ratings-stronger", "T_N").find(|entry| place(entry) == place(cell));
        let (Some(printed), Some(stronger), Some(factor)) = (cell.span(), stronger.and_then(AuditedCell::span), factor)
        else {
            tally.absent(cell.place());
            continue;
        };
        seen += 1;
        let expected = stronger * factor.recip();
        tally.compare(printed.meets(expected), &[cell], || {
            format!("{} is {}, the stronger series gives {expected}", cell.place(), cell.text)
        });
    }
    if seen == 0 {
        tally.absent("T_N of gear-ratings");
    }
    let mut maxima = 0;
    for stronger in view.row("gear-ratings-stronger", "T_R").filter(|entry| !entry.text.is_empty()) {
        for drive in catalogue::drives().iter().filter(|drive| drive.name.starts_with(stronger.cell.place.drive)) {
            let maximum = view.drive(drive.name).at("T_max", stronger.cell.place.ratio);
            let (Some(cell), Some(over), Some(factor)) = (maximum, stronger.span(), factor) else {
                tally.absent(stronger.place());
                continue;
            };
            maxima += 1;
            let expected = over * factor.recip();
            tally.compare(cell.span().is_some_and(|printed| printed.meets(expected)), &[cell, stronger], || {
                format!("{} is {}, the stronger series gives {expected}", cell.place(), cell.text)
            });
        }
    }
    if maxima == 0 {
        tally.absent("T_R of gear-ratings-stronger");
    }
}

/// Curves of CHA-20A: continuous torque at standstill = T_0, maximum torque = T_max, speed up to n_max
///
/// Source: cha-page-39, read from a chart's data.
/// Tolerance: half a digit of 1 Nm for the torques at standstill; a curve must not pass n_max. Blamed: the curve.
pub(super) fn curves(view: &CellView, tally: &mut Tally) {
    let drive = view.drive("CHA-20A-M512P");
    for cell in view.row("curves-20A", "curve_T_n").filter(|entry| !entry.text.is_empty()) {
        let Some(points) = configurator::published_curve_points(&cell.text) else {
            tally.absent(cell.place());
            continue;
        };
        let (Some((_, start)), Some((end, _))) = (points.first().copied(), points.last().copied()) else {
            tally.absent(cell.place());
            continue;
        };
        let number = |symbol| drive.at(symbol, cell.cell.place.ratio).and_then(AuditedCell::number);
        let (Some(stall), Some(peak), Some(speed)) = (number("T_0"), number("T_max"), number("n_max")) else {
            tally.absent(cell.place());
            continue;
        };
        let (limit, exact) = match cell.cell.place.condition {
            "continuous" => (stall, true),
            "maximum" => (peak, true),
            _ => (peak, false),
        };
        let fits = if exact { (start - limit).abs() < 0.5 } else { (stall..=limit).contains(&start) };
        tally.compare(fits, &[cell], || format!("{} starts at {start} Nm, the table has {limit}", cell.place()));
        tally.compare((start - limit).abs() <= 1.0 + 1e-9 || !exact, &[], || {
            format!("{} starts at {start} Nm, more than 1 Nm from {limit}", cell.place())
        });
        tally.compare(end <= speed, &[], || format!("{} ends at {end} 1/min, beyond n_max = {speed}", cell.place()));
    }
    if view.row("curves-20A", "curve_T_n").next().is_none() {
        tally.absent("curve_T_n of curves-20A");
    }
}

fn rising(tally: &mut Tally, row: &[&AuditedCell]) {
    if row.len() < 2 {
        tally.absent("a row that should rise has fewer than two values");
    }
    for pair in row.windows(2) {
        if let [first, second] = pair {
            step(tally, Some(first), Some(second), |a, b| a < b, "not below its neighbour");
        }
    }
}

mod tests {
    use super::super::findings_of;
    use super::*;

    #[test]
    fn a_changed_sensor_resistance_is_found() {
        let view = CellView::with("kty84-130", "606", |cell| cell.place.condition == "typical, 25 degC");
        // By the closed form, and by the bounds on both sides of it.
        assert_eq!(findings_of(temperature_sensor, &view).len(), 2);
    }

    #[test]
    fn a_changed_thermistor_limit_is_found() {
        let view = CellView::with("ptc-din44081", "≤ 1560", |cell| cell.printed == "≤ 1650");
        assert_eq!(findings_of(thermistor, &view).len(), 1);
    }

    #[test]
    fn a_changed_gear_rating_is_found() {
        let altered = |symbol: &'static str, text| {
            CellView::with("gear-ratings", text, move |c| {
                c.place.symbol == symbol && c.place.drive == "CHA-14A" && c.place.ratio == "50"
            })
        };
        assert_eq!(findings_of(gear_ratings, &altered("T_N", "7,4")).len(), 1);
        assert_eq!(findings_of(gear_ratings, &altered("T_R", "19")).len(), 2);
    }

    #[test]
    fn a_changed_rating_of_the_stronger_gear_is_found() {
        let altered = CellView::with("gear-ratings-stronger", "90", |c| {
            c.place.symbol == "T_N" && c.place.drive == "CHA-25A" && c.place.ratio == "100"
        });
        assert_eq!(findings_of(stronger_gear, &altered).len(), 1);
        let altered = CellView::with("gear-ratings-stronger", "90", |c| {
            c.place.symbol == "T_R" && c.place.drive == "CHA-20A" && c.place.ratio == "80"
        });
        assert!(!findings_of(stronger_gear, &altered).is_empty());
        let altered = CellView::with("family", "1,2", |c| c.place.symbol == "stronger_gear_factor");
        assert!(findings_of(stronger_gear, &altered).len() > 25);
    }

    #[test]
    fn a_curve_off_the_table_is_found() {
        let altered = |text| {
            CellView::with("curves-20A", text, |c| c.place.condition.contains("continuous") && c.place.ratio == "50")
        };
        assert_eq!(findings_of(curves, &altered("(0;34)(25;31)(70;20)")).len(), 2);
        assert_eq!(findings_of(curves, &altered("(0;32)(25;31)(130;20)")).len(), 1);
    }
}
