//! Cross-checks of the data: every value against its neighbours, every deviation against the errata.
//!
//! A check recomputes a stated value from others, with a tolerance of half a printed digit for each. A deviation must
//! be explained by an erratum at the cell, or by a rule in code with its reason. Each check runs three times: on the
//! manual's values, on the values after errata, and on the values used by the checks of an actuator. Conversely, an
//! erratum that corrects a cell covered by a check must show up as a deviation there; otherwise it is an orphan.

mod bearing;
mod feedback;
mod motor;
mod ordering;
mod output;
mod published;
mod records;
mod sisters;
mod tally;
mod view;

use view::TextVersion;

use catalogue::Erratum;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use tally::{Tally, place};
use view::CellView;

type Check = fn(&CellView, &mut Tally);

/// The checks by name, in the order of the manual.
const CHECKS: [(&str, Check); 31] = [
    ("tables exist", ordering::tables),
    ("ratios of the key", ordering::ratios),
    ("combinations", ordering::combinations),
    ("codes have parameters", ordering::codes),
    ("J_out = J i²", output::inertia),
    ("n_max = n_mot_max/i", output::speed),
    ("tau_e = L_LL/R_LL", motor::electrical_time_constant),
    ("tau_m = 1.5 R_LL J/k²", motor::mechanical_time_constant),
    ("tau_m ~ J", motor::time_constant_and_inertia),
    ("I_0 = T_0/k_Tout + I_NLS", motor::stall_current),
    ("k_Tout = i k_TM η", motor::torque_constant),
    ("T_max/k_Tout <= I_max", motor::maximum_current),
    ("T_Br = min(T_b i, T_max)", output::brake),
    ("a stronger brake is no lighter", output::brake_rotor),
    ("order of the values", output::order),
    ("order of the sizes", output::sizes),
    ("C1024 = M512P", sisters::same_motor),
    ("M512P adds 1,0 kg", sisters::encoder_share),
    ("E = H/N", sisters::same_gear),
    ("stiffness and accuracy", bearing::growth),
    ("M_0 = d_p C_0/(2 f_s)", bearing::static_moment),
    ("F_R, F_A and life", bearing::life),
    ("resolution", feedback::resolution),
    ("turns and words", feedback::turns),
    ("screws", bearing::screws),
    ("KTY 84-130", published::temperature_sensor),
    ("PTC", published::thermistor),
    ("gear ratings", published::gear_ratings),
    ("T_N = T_N,stronger/1.3", published::stronger_gear),
    ("curves of CHA-20A", published::curves),
    ("records", records),
];

fn records(view: &CellView, tally: &mut Tally) {
    records::sources(view, tally);
    records::terms(view, tally);
    records::errata(view, tally);
}

/// Result of the checks.
pub(crate) struct Report {
    tallies: Vec<Tally>,
    orphans: Vec<&'static str>,
    covered: usize,
}

/// Runs every check in every reading.
#[must_use]
pub(crate) fn run() -> Report {
    let tallies: Vec<Tally> = TextVersion::ALL
        .into_iter()
        .flat_map(|reading| {
            let view = CellView::of(reading);
            CHECKS.map(|(name, check)| tally(name, check, &view))
        })
        .collect();
    let (covered, orphans) = orphans(catalogue::errata(), &tallies);
    Report { tallies, orphans, covered }
}

fn tally(name: &'static str, check: Check, view: &CellView) -> Tally {
    let mut tally = Tally::new(name, view.reading);
    check(view, &mut tally);
    if tally.comparisons == 0 {
        tally.absent("the check found nothing to compare");
    }
    tally
}

/// Returns the number of errata at cells covered by a check, and the identifiers of those that explain no deviation.
fn orphans(errata: &[Erratum], tallies: &[Tally]) -> (usize, Vec<&'static str>) {
    let printed = || tallies.iter().filter(|tally| tally.reading == TextVersion::Printed);
    let covered: BTreeSet<_> = printed().flat_map(|tally| &tally.covered).collect();
    let at_work: BTreeSet<&str> =
        printed().flat_map(|tally| &tally.deviations).flat_map(|deviation| &deviation.errata).copied().collect();
    let under_test: Vec<&'static str> = errata
        .iter()
        .filter(|erratum| TextVersion::Printed.explains(erratum))
        .filter(|erratum| {
            let mut cells = catalogue::cells().filter(|cell| cell.errata.contains(&erratum.id));
            cells.any(|cell| covered.contains(&place(cell)))
        })
        .map(|erratum| erratum.id)
        .collect();
    let orphans = under_test.iter().copied().filter(|id| !at_work.contains(id)).collect();
    (under_test.len(), orphans)
}

impl Report {
    /// Returns the unexplained deviations and the errata without a deviation as text.
    #[must_use]
    pub(crate) fn findings(&self) -> Vec<String> {
        let deviations = self.tallies.iter().flat_map(Tally::unexplained).map(ToString::to_string);
        let orphans = self.orphans.iter().map(|id| {
            format!("orphan: erratum {id} calls a value wrong that fits its neighbours in every check that covers it")
        });
        deviations.chain(orphans).collect()
    }

    /// Returns the total number of comparisons.
    #[must_use]
    pub(crate) fn comparisons(&self) -> usize {
        self.tallies.iter().map(|tally| tally.comparisons).sum()
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let of_the_manual = catalogue::tables().iter().filter(|table| table.is_of_the_manual()).count();
        let (tables, cells) = (catalogue::tables().len(), catalogue::cells().count());
        writeln!(f, "{tables} tables ({of_the_manual} of the manual), {cells} printed cells")?;
        let mut kinds: BTreeMap<_, [usize; 2]> = BTreeMap::new();
        for erratum in catalogue::errata() {
            let [corrected, flagged] = kinds.entry(erratum.kind).or_default();
            *(if erratum.corrected_here { corrected } else { flagged }) += 1;
        }
        writeln!(f, "{} errata, {} of them at cells that a check covers", catalogue::errata().len(), self.covered)?;
        for (kind, [corrected, flagged]) in kinds {
            writeln!(f, "  {:<14}{corrected:>4} corrected {flagged:>4} flagged", kind.id())?;
        }
        writeln!(f, "{} comparisons in three readings; per check in the print:", self.comparisons())?;
        for tally in self.tallies.iter().filter(|tally| tally.reading == TextVersion::Printed) {
            let errata: BTreeSet<&str> = tally.deviations.iter().flat_map(|d| &d.errata).copied().collect();
            let by_erratum = tally.deviations.iter().filter(|deviation| !deviation.errata.is_empty()).count();
            let by_rule = tally.deviations.iter().filter(|deviation| deviation.rule.is_some()).count();
            write!(f, "  {:<26}{:>5}", tally.check, tally.comparisons)?;
            match (by_erratum, by_rule) {
                (0, 0) => {}
                (_, 0) => write!(f, ", {by_erratum} explained by errata")?,
                (0, _) => write!(f, ", {by_rule} explained by rule")?,
                _ => write!(f, ", {by_erratum} explained by errata, {by_rule} by rule")?,
            }
            writeln!(f)?;
            for id in errata {
                writeln!(f, "      {id}")?;
            }
            for rule in tally.deviations.iter().filter_map(|deviation| deviation.rule).collect::<BTreeSet<_>>() {
                writeln!(f, "      rule: {rule}")?;
            }
        }
        Ok(())
    }
}

/// Returns the unexplained deviations that a check finds in a view.
fn findings_of(check: Check, view: &CellView) -> Vec<String> {
    tally("under test", check, view).findings()
}

#[test]
fn the_data_are_consistent() {
    let report = run();
    print!("{report}");
    let findings = report.findings();
    assert!(findings.is_empty(), "{} findings:\n{}", findings.len(), findings.join("\n"));
}

mod tests {
    use super::*;

    #[test]
    fn an_erratum_without_a_deviation_is_an_orphan() {
        let mut quiet = Tally::new("quiet", TextVersion::Printed);
        let view = CellView::of(TextVersion::Printed);
        let cell = view.find(|cell| cell.errata.contains(&"25A-M512P-J_out-50")).unwrap();
        quiet.compare(true, &[cell], String::new);
        assert_eq!(orphans(catalogue::errata(), &[quiet]).1, ["25A-M512P-J_out-50"]);
        let mut loud = Tally::new("loud", TextVersion::Printed);
        loud.compare(false, &[cell], String::new);
        assert!(orphans(catalogue::errata(), &[loud]).1.is_empty());
    }

    #[test]
    fn a_check_that_compares_nothing_does_not_pass() {
        let idle = tally("idle", |_, _| {}, &CellView::of(TextVersion::Printed));
        assert_eq!(idle.findings(), ["idle (printed): cannot be checked: the check found nothing to compare"]);
    }
}
