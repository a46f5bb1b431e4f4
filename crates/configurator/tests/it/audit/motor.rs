//! Currents, torque constants and time constants of the motors (tables 14.1 to 48.1).

use super::tally::{Excuse, Tally};
use super::view::{AuditedCell, CellView, DriveView, Span, brief, median};
use std::f64::consts::PI;

/// tau_e = L_LL / R_LL
///
/// Source: definition of the electrical time constant, glossary of the manual; both values line to line.
/// Tolerance: the rounding of all three values.
pub(super) fn electrical_time_constant(view: &CellView, tally: &mut Tally) {
    for drive in view.drives() {
        let cells = [drive.once("tau_e"), drive.once("L_LL"), drive.once("R_LL")];
        let [Some(tau), Some(l), Some(r)] = cells else {
            tally.absent(format_args!("tau_e, L_LL or R_LL of {}", drive.name));
            continue;
        };
        let (Some(printed), Some(l), Some(r)) = (tau.span(), l.span(), r.span()) else {
            tally.absent(tau.place());
            continue;
        };
        expect(tally, tau, printed, l / r, Excuse::default(), "L_LL/R_LL");
    }
}

/// tau_m = 1.5 R_LL J / k²
///
/// k is the torque per ampere of rms current. Sizes 20A to 58A: k = √3 k_EM / (1000 · 2π/60) with k_EM in V rms line to
/// line per 1000 1/min; sizes 14A and 17A: k = k_TM. The manual does not say which; each group fits its own and misses
/// the other by 7 to 35 %.
///
/// Source: definition of the mechanical time constant, glossary of the manual.
/// Tolerance: the rounding of all values; a zero behind the comma of tau_m may be padding (14,0 9,0 23,0 of table 14.1).
pub(super) fn mechanical_time_constant(view: &CellView, tally: &mut Tally) {
    for drive in view.drives() {
        let taus: Vec<&AuditedCell> = drive.every("tau_m", "").collect();
        if taus.is_empty() {
            tally.absent(format_args!("tau_m of {}", drive.name));
        }
        for tau in taus {
            match expected_tau_m(&drive, tau) {
                Some(expected) => {
                    let Some(printed) = tau.span() else {
                        tally.absent(tau.place());
                        continue;
                    };
                    let basis = if drive.is_small() { "1,5 R_LL J/k_TM²" } else { "1,5 R_LL J/k² with k from k_EM" };
                    expect(tally, tau, printed, expected, padding(tau, expected), basis);
                }
                None => tally.absent(tau.place()),
            }
        }
    }
}

fn expected_tau_m(drive: &DriveView<'_>, tau: &AuditedCell) -> Option<Span> {
    let resistance = drive.once("R_LL")?.span()?;
    let inertia = inertia_beside(drive, tau)?.span()? * 1e-4;
    let k = if drive.is_small() {
        drive.once("k_TM")?.span()?
    } else {
        drive.once("k_EM")?.span()? * (3_f64.sqrt() / (1000.0 * 2.0 * PI / 60.0))
    };
    Some(resistance * inertia / (k * k) * 1.5 * 1e3)
}

/// tau_m / J is one number for all feedback systems on the same motor
///
/// Follows from tau_m = 1.5 R_LL J / k²: R_LL and k belong to the motor, J includes the rotor of the encoder.
/// The reference is the variant with the smallest inertia (C1024, D2048).
///
/// Source: as [`mechanical_time_constant`].
/// Tolerance: the rounding of all four values; a zero behind the comma of tau_m may be padding.
pub(super) fn time_constant_and_inertia(view: &CellView, tally: &mut Tally) {
    for (base, other) in variants(view) {
        let pairs = [inertia_beside(&base.0, base.1), inertia_beside(&other.0, other.1)];
        let [Some(j_base), Some(j_other)] = pairs.map(|cell| cell.and_then(AuditedCell::span)) else {
            tally.absent(format_args!("J beside {}", other.1.place()));
            continue;
        };
        let (Some(tau), Some(printed)) = (base.1.span(), other.1.span()) else {
            tally.absent(other.1.place());
            continue;
        };
        let expected = tau * j_other / j_base;
        let padded = Span::padded(&base.1.text).unwrap_or(tau) * j_other / j_base;
        let excuse = padding(other.1, padded);
        expect(tally, other.1, printed, expected, excuse, "tau_m in the ratio of the inertias");
    }
}

type Variant<'a> = (DriveView<'a>, &'a AuditedCell);

/// Returns pairs of tau_m on the same motor: the one of the encoder with the smallest inertia, and each other one.
fn variants(view: &CellView) -> Vec<(Variant<'_>, Variant<'_>)> {
    let mut pairs = Vec::new();
    for drive in view.drives() {
        if let Some(name) = drive.name.strip_suffix("-M512P") {
            let sister = view.drives().into_iter().find(|d| d.name.strip_suffix("-C1024") == Some(name));
            if let Some(sister) = sister
                && let (Some(base), Some(other)) = (sister.once("tau_m"), drive.once("tau_m"))
            {
                pairs.push(((sister, base), (drive, other)));
            }
            continue;
        }
        let Some(base) = drive.every("tau_m", "").find(|entry| entry.cell.feedback == "D2048") else { continue };
        for other in drive.every("tau_m", "").filter(|entry| entry.cell.feedback != "D2048") {
            let name = drive.name;
            pairs.push(((view.drive(name), base), (view.drive(name), other)));
        }
    }
    pairs
}

fn inertia_beside<'a>(drive: &DriveView<'a>, tau: &AuditedCell) -> Option<&'a AuditedCell> {
    drive.every("J", "").find(|entry| entry.cell.feedback == tau.cell.feedback)
}

fn padding(cell: &AuditedCell, expected: Span) -> Excuse {
    let fits = Span::padded(&cell.text).is_some_and(|span| span.meets(expected));
    let rule = fits.then_some("the last zero of tau_m is padding: the value is known to full milliseconds");
    Excuse { rule, ..Excuse::default() }
}

/// I_0 = T_0 / k_Tout + I_NLS (680 V), I_0 = T_0 / k_Tout (48 V)
///
/// Source: chapter 6.1 of the manual (stall torque and no-load current); that the 48 V windings leave I_NLS out is read
/// from all nine of their values.
/// Tolerance: the rounding of all values. Blamed: I_0 and k_Tout.
pub(super) fn stall_current(view: &CellView, tally: &mut Tally) {
    each_ratio(view, tally, "I_0", |drive, ratio, current, tally| {
        let torque = drive.at("T_0", ratio)?.span()?;
        let constant = drive.at("k_Tout", ratio)?;
        let mut expected = torque / constant.span()?;
        if !drive.is_48_v() {
            expected = expected + drive.at("I_NLS", ratio)?.span()?;
        }
        let printed = current.span()?;
        tally.compare(printed.meets(expected), &[current, constant], || {
            format!("{} is {}, T_0/k_Tout (+ I_NLS) gives {expected}", current.place(), current.text)
        });
        Some(())
    });
}

/// T_max / k_Tout ≤ I_max: the drive has the current for its maximum torque
///
/// Source: definition of k_Tout, glossary of the manual.
/// Tolerance: lower end of T_max / k_Tout against the upper end of I_max. Blamed: I_max.
pub(super) fn maximum_current(view: &CellView, tally: &mut Tally) {
    each_ratio(view, tally, "I_max", |drive, ratio, current, tally| {
        let needed = drive.at("T_max", ratio)?.span()? / drive.at("k_Tout", ratio)?.span()?;
        let printed = current.span()?;
        tally.compare(needed.low <= printed.high, &[current], || {
            format!("{} is {}, T_max/k_Tout needs {needed}", current.place(), current.text)
        });
        Some(())
    });
}

/// k_Tout / (i k_TM) is plausible, and alike at all ratios of a drive
///
/// The quotient is the torque share of the gear, its efficiency: it cannot exceed 1.
///
/// Source: k_Tout = i k_TM η.
/// Tolerance: 0.85 for the quotient of the printed values, 1 for the lower end of k_Tout against the upper end of i k_TM;
/// the interval of k_Tout / i within 3.2 % of the medians of the family's lower and upper ends. The widest honest spread is
/// 3.0 % (17A-H/N, i = 80). Blamed: k_Tout; for a quotient above 1 k_TM too.
pub(super) fn torque_constant(view: &CellView, tally: &mut Tally) {
    for drive in view.drives() {
        let motor_cell = drive.once("k_TM");
        let Some((motor_cell, motor)) = motor_cell.and_then(|cell| Some((cell, cell.span()?))) else {
            tally.absent(format_args!("k_TM of {}", drive.name));
            continue;
        };
        let mut family = Vec::new();
        for ratio in drive.ratios() {
            let cell = drive.at("k_Tout", ratio);
            let span = cell.and_then(AuditedCell::span).zip(ratio.parse().ok()).map(|(k, i): (_, f64)| k * (1.0 / i));
            match cell.zip(span) {
                Some(pair) => family.push(pair),
                None => tally.absent(format_args!("k_Tout of {}, i = {ratio}", drive.name)),
            }
        }
        let low = 0.968 * median(family.iter().map(|(_, span)| span.low).collect());
        let high = 1.032 * median(family.iter().map(|(_, span)| span.high).collect());
        for (cell, span) in family {
            let share = span.mid / motor.mid;
            let times = || format!("{} is {}, {} times i k_TM", cell.place(), cell.text, brief(share));
            tally.compare(share >= 0.85, &[cell], times);
            tally.compare(span.low <= motor.high, &[motor_cell, cell], times);
            tally.compare(span.high >= low && span.low <= high, &[cell], || {
                let per_ratio = Span { low, mid: span.mid, high };
                format!("{}/i is {}, the other ratios ask for {per_ratio}", cell.place(), brief(span.mid))
            });
        }
    }
}

fn expect(tally: &mut Tally, cell: &AuditedCell, printed: Span, expected: Span, excuse: Excuse, how: &str) {
    tally.compare_or(printed.meets(expected), &[cell], excuse, || {
        format!("{} is {}, {how} gives {expected}", cell.place(), cell.text)
    });
}

/// Runs a check on the cell of a symbol at every ratio of every drive; `None` is reported as an impossible comparison.
pub(super) fn each_ratio(
    view: &CellView,
    tally: &mut Tally,
    symbol: &str,
    check: impl Fn(&DriveView<'_>, &'static str, &AuditedCell, &mut Tally) -> Option<()>,
) {
    for drive in view.drives() {
        for ratio in drive.ratios() {
            let done = drive.at(symbol, ratio).and_then(|cell| check(&drive, ratio, cell, tally));
            if done.is_none() {
                tally.absent(format_args!("{symbol} of {}, i = {ratio}", drive.name));
            }
        }
    }
}

mod tests {
    use super::super::findings_of;
    use super::*;

    fn altered(table: &str, symbol: &'static str, ratio: &'static str, text: &str) -> CellView {
        CellView::with(table, text, |cell| cell.place.symbol == symbol && cell.place.ratio == ratio)
    }

    #[test]
    fn a_changed_inductance_is_found() {
        assert_eq!(findings_of(electrical_time_constant, &altered("26.1", "L_LL", "", "9,0")).len(), 1);
    }

    #[test]
    fn a_changed_mechanical_time_constant_is_found() {
        assert_eq!(findings_of(mechanical_time_constant, &altered("26.1", "tau_m", "", "7,6")).len(), 1);
        let small = CellView::with("17.1", "4,9", |cell| cell.place.symbol == "tau_m" && cell.feedback == "RES");
        assert_eq!(findings_of(mechanical_time_constant, &small).len(), 1);
    }

    #[test]
    fn time_constants_out_of_the_ratio_of_the_inertias_are_found() {
        let view = CellView::with("17.1", "4,9", |cell| cell.place.symbol == "tau_m" && cell.feedback == "M128S");
        assert_eq!(findings_of(time_constant_and_inertia, &view).len(), 1);
    }

    #[test]
    fn a_changed_stall_current_is_found() {
        assert_eq!(findings_of(stall_current, &altered("36.1", "I_0", "100", "4,8")).len(), 1);
        assert_eq!(findings_of(stall_current, &altered("14.1", "I_0", "30", "6,8")).len(), 1);
    }

    #[test]
    fn too_small_a_maximum_current_is_found() {
        assert_eq!(findings_of(maximum_current, &altered("36.1", "I_max", "100", "10,1")).len(), 1);
    }

    #[test]
    fn a_torque_constant_off_its_family_is_found() {
        assert_eq!(findings_of(torque_constant, &altered("36.1", "k_Tout", "100", "161")).len(), 1);
    }

    #[test]
    fn an_efficiency_above_one_is_found() {
        // 0.45 instead of 0.55: all six ratios exceed the torque of the motor.
        assert_eq!(findings_of(torque_constant, &altered("28.1", "k_TM", "", "0,45")).len(), 6);
    }
}
