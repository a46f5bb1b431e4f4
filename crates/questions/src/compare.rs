//! Several actuators on one axis, and one actuator on two revisions of it.

use crate::list::size::sized;
use crate::progress::Progress;
use crate::sizing_use::{Candidate, Refusal, Rejected, Sizing, check, check_own, not_offered};
use crate::texts::margin_share;
use actuator::Parameters;
use axis::{AxisProject, Catalogue};
use configurator::ProductId;
use provenance::Datum;
use quantities::unit::{
    AMPERE, KILOGRAM, KILOGRAM_SQUARE_METRE, MILLIMETRE, NEWTON_METRE, NEWTON_METRE_PER_AMPERE, ONE, PERCENT,
    REVOLUTION_PER_MINUTE,
};
use quantities::{Measure, Unit};
use sizing::{Check, CheckId, StepObserver as _, Verdict};

/// Relative difference below which two figures are equal: above the rounding of a double, below the digits shown.
const SAME: f64 = 1e-9;

/// Returns `true` if two figures are equal, or neither is known.
fn same(a: Option<f64>, b: Option<f64>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() <= SAME * a.abs().max(b.abs()),
        (a, b) => a.is_none() && b.is_none(),
    }
}

/// A figure of several actuators.
#[derive(Clone, Debug, PartialEq)]
pub struct DatumRow {
    /// Symbol of the figure.
    pub symbol: &'static str,
    /// Unit of the values.
    pub unit: &'static Unit,
    /// Values in this unit, one for each actuator; `None` if not known.
    pub values: Vec<Option<f64>>,
    /// Errata of the source cells, in the same order: a value with an erratum may differ from the manual.
    pub errata: Vec<&'static [&'static str]>,
}

impl DatumRow {
    /// Returns `true` if all values are equal.
    #[must_use]
    pub fn is_same(&self) -> bool {
        self.values.iter().zip(self.values.iter().skip(1)).all(|(a, b)| same(*a, *b))
    }

    /// Returns the errata of an actuator's value.
    #[must_use]
    pub fn errata_of(&self, place: usize) -> &'static [&'static str] {
        self.errata.get(place).copied().unwrap_or_default()
    }
}

/// Returns the errata of some rows, without repetitions.
#[must_use]
pub fn errata_of(rows: &[DatumRow]) -> Vec<&'static str> {
    let mut found: Vec<&'static str> = Vec::new();
    for id in rows.iter().flat_map(|row| &row.errata).copied().flatten() {
        if !found.contains(id) {
            found.push(id);
        }
    }
    found
}

/// One check of several actuators.
#[derive(Clone, Debug)]
pub struct CheckRow {
    /// Identifier of the check.
    pub id: CheckId,
    /// Results of the check, one for each actuator; `None` if it is not part of the judgement.
    pub checks: Vec<Option<Check>>,
    /// The actuator with the lowest utilisation, if a single one has it.
    pub better: Option<usize>,
}

/// Comparison of several actuators on one axis.
#[derive(Clone, Debug)]
pub struct Comparison<'p> {
    /// The actuators in the requested order.
    pub candidates: Vec<Candidate<'p>>,
    /// The fitting actuator that is first in the ranking, if one fits.
    pub better: Option<usize>,
    /// Demand of the axis on each actuator, with its own inertia.
    pub demand: Vec<DatumRow>,
    /// Data of the actuators.
    pub data: Vec<DatumRow>,
    /// Every check that one of the actuators has, in the fixed order.
    pub checks: Vec<CheckRow>,
}

/// Compares the judgements of several actuators.
///
/// # Errors
/// [`Refusal`] of the first product that cannot be judged, with its place in the list, or [`Refusal::Stopped`] at its
/// place.
pub fn compare<'p>(
    project: &'p AxisProject,
    ids: &[ProductId],
    progress: &Progress,
) -> Result<Comparison<'p>, (usize, Refusal)> {
    let judged = |(index, id): (usize, &ProductId)| {
        let goes_on = progress.step().map_err(Refusal::from);
        goes_on.and_then(|()| check(project, id)).map_err(|refusal| (index, refusal))
    };
    let candidates: Vec<Candidate<'p>> = ids.iter().enumerate().map(judged).collect::<Result<_, _>>()?;
    let all: Vec<&Candidate<'p>> = candidates.iter().collect();
    let parameters: Vec<&Parameters> = all.iter().map(|candidate| candidate.parameters).collect();
    let (demand, data, checks) = (demand_rows(&all), data_rows(&parameters), check_rows(&all));
    let fitting = candidates.iter().enumerate().filter(|(_, candidate)| candidate.fits());
    let better = fitting.min_by(|(_, a), (_, b)| sizing::rank(&a.standing, &b.standing)).map(|(index, _)| index);
    Ok(Comparison { candidates, better, demand, data, checks })
}

fn check_rows(candidates: &[&Candidate<'_>]) -> Vec<CheckRow> {
    let of = |candidate: &Candidate<'_>, id: CheckId| {
        candidate.judgement.checks.iter().find(|check| check.id == id).cloned()
    };
    CheckId::ALL
        .iter()
        .map(|id| (*id, candidates.iter().map(|candidate| of(candidate, *id)).collect::<Vec<_>>()))
        .filter(|(_, checks)| checks.iter().any(Option::is_some))
        .map(|(id, checks)| CheckRow { id, better: better(&checks), checks })
        .collect()
}

/// Returns the actuator with the lowest utilisation, if all have one.
fn better(checks: &[Option<Check>]) -> Option<usize> {
    let shares: Vec<f64> = checks.iter().map(|check| check.as_ref()?.utilisation).collect::<Option<_>>()?;
    let (index, least) = shares.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1))?;
    let alone = shares.iter().enumerate().all(|(other, share)| other == index || share - least > SAME);
    (alone && shares.len() > 1).then_some(index)
}

fn demand_rows(candidates: &[&Candidate<'_>]) -> Vec<DatumRow> {
    let row = |symbol, unit: &'static Unit, of: fn(&sizing::Demand) -> f64| DatumRow {
        symbol,
        unit,
        values: candidates
            .iter()
            .map(|each| each.judgement.demand.as_ref().map(|demand| unit.from_si(of(demand))))
            .collect(),
        errata: vec![&[]; candidates.len()],
    };
    vec![
        row("T_rms", &NEWTON_METRE, |demand| demand.torque_rms.si()),
        row("T_peak", &NEWTON_METRE, |demand| demand.torque_peak.si()),
        row("n_av", &REVOLUTION_PER_MINUTE, |demand| demand.speed_mean.si()),
        row("n_peak", &REVOLUTION_PER_MINUTE, |demand| demand.speed_peak.si()),
        row("ED", &PERCENT, |demand| demand.duty_factor),
    ]
}

/// Returns the data of several actuators of a catalogue, as a comparison has them.
///
/// # Errors
/// [`Refusal`] of the first one that has no data, with its place in the list.
pub fn data_of(catalogue: &dyn Catalogue, ids: &[ProductId]) -> Result<Vec<DatumRow>, (usize, Refusal)> {
    let of = |(index, id): (usize, &ProductId)| {
        id.availability().map_err(|broken| (index, Refusal::Broken(broken)))?;
        let product = catalogue.product(id).ok_or_else(|| (index, not_offered(catalogue, id)))?;
        Ok(&product.parameters)
    };
    let all: Vec<&Parameters> = ids.iter().enumerate().map(of).collect::<Result<_, _>>()?;
    Ok(data_rows(&all))
}

fn data_rows(all: &[&Parameters]) -> Vec<DatumRow> {
    fn found<Q: Measure>(datum: &Datum<Q>) -> Found {
        datum.known().map(|known| (known.value.si(), known.errata))
    }
    let row = |symbol, unit: &'static Unit, of: fn(&Parameters) -> Found| {
        let found: Vec<Found> = all.iter().map(|parameters| of(parameters)).collect();
        DatumRow {
            symbol,
            unit,
            values: found.iter().map(|found| found.map(|(si, _)| unit.from_si(si))).collect(),
            errata: found.iter().map(|found| found.map_or(&[][..], |(_, errata)| errata)).collect(),
        }
    };
    vec![
        row("i", &ONE, |data| data.ratio.known().map(|ratio| (ratio.value, ratio.errata))),
        row("T_max", &NEWTON_METRE, |data| found(&data.torque_max)),
        row("T_0", &NEWTON_METRE, |data| found(&data.stall_torque)),
        row("I_max", &AMPERE, |data| found(&data.current_max)),
        row("I_0", &AMPERE, |data| found(&data.stall_current)),
        row("k_Tout", &NEWTON_METRE_PER_AMPERE, |data| found(&data.torque_constant_out)),
        row("J_out", &KILOGRAM_SQUARE_METRE, |data| found(&data.inertia_out)),
        row("d_H", &MILLIMETRE, |data| found(&data.hollow_shaft)),
        row("L", &MILLIMETRE, |data| found(&data.length)),
        row("m", &KILOGRAM, |data| found(&data.mass)),
    ]
}

/// A value in SI with the errata of its cell.
type Found = Option<(f64, &'static [&'static str])>;

/// Change of one check between two revisions.
#[derive(Clone, Debug)]
pub struct CheckChange {
    /// Identifier of the check.
    pub id: CheckId,
    /// Result before; `None` if the check was not part of the judgement.
    pub before: Option<Check>,
    /// Result after.
    pub after: Option<Check>,
}

impl CheckChange {
    /// Returns the shown utilisation after minus that before.
    #[must_use]
    pub fn change(&self) -> Option<f64> {
        Some(margin_share(self.after.as_ref()?)? - margin_share(self.before.as_ref()?)?)
    }

    /// Returns `true` if the verdict differs.
    #[must_use]
    pub fn is_other_verdict(&self) -> bool {
        self.before.as_ref().map(|check| check.verdict) != self.after.as_ref().map(|check| check.verdict)
    }

    /// Returns `true` if verdict, value and limit are equal.
    #[must_use]
    pub fn is_same(&self) -> bool {
        let figure = |check: &Option<Check>, of: fn(&Check) -> Option<sizing::Amount>| {
            check.as_ref().and_then(of).map(|figure| figure.si)
        };
        let near = |of| same(figure(&self.before, of), figure(&self.after, of));
        !self.is_other_verdict() && near(|check| check.value) && near(|check| check.limit)
    }

    /// Returns the rank in the list: new failures, then other verdicts, then the larger change of utilisation.
    fn order(&self) -> (bool, bool, f64) {
        let fails = self.after.as_ref().is_some_and(|check| check.verdict == Verdict::Fail);
        let other = self.is_other_verdict();
        // Checks that differ by rounding only keep their order.
        let change = self.change().filter(|_| !self.is_same());
        (!(fails && other), !other, -change.map_or(0.0, f64::abs))
    }
}

/// One actuator on two revisions of an axis.
#[derive(Clone, Debug)]
pub struct Difference<'p> {
    /// The actuator on the first revision.
    pub before: Candidate<'p>,
    /// The actuator on the second revision.
    pub after: Candidate<'p>,
    /// Demand of the axis on the actuator, before and after.
    pub demand: Vec<DatumRow>,
    /// Every check, other verdicts first, then by the change of utilisation.
    pub checks: Vec<CheckChange>,
    /// The best of the catalogue before, if one fits.
    pub best_before: Option<ProductId>,
    /// The best of the catalogue after, if one fits.
    pub best_after: Option<ProductId>,
}

/// Compares an actuator on two revisions of an axis: the given one, else the project's own actuator if both have one,
/// else the first of the ranking for the first revision, which need not fit.
///
/// # Errors
/// [`Refusal`] if the product cannot be judged, [`Refusal::Stopped`].
pub fn difference<'p>(
    old: &'p AxisProject,
    new: &'p AxisProject,
    id: Option<&ProductId>,
    progress: &Progress,
) -> Result<Difference<'p>, Refusal> {
    let ranked = |project| sized(project, 0, Rejected::Nearest, progress);
    let (sized_before, sized_after) = (ranked(old)?, ranked(new)?);
    let best = |sizing: &Sizing<'_>| sizing.answer().map(|answer| answer.id.clone());
    let own = id.is_none() && old.actuator.is_some() && new.actuator.is_some();
    let (before, after) = if own {
        (check_own(old)?, check_own(new)?)
    } else {
        let first = sized_before.named().map(|candidate| &candidate.id);
        let id = id.or(first).ok_or(Refusal::NoActuator)?;
        (check(old, id)?, check(new, id)?)
    };
    let pair = [&before, &after];
    let mut checks: Vec<CheckChange> = check_rows(&pair)
        .into_iter()
        .map(|row| {
            let mut found = row.checks.into_iter();
            CheckChange { id: row.id, before: found.next().flatten(), after: found.next().flatten() }
        })
        .collect();
    checks.sort_by(|a, b| {
        let ((fails_a, other_a, change_a), (fails_b, other_b, change_b)) = (a.order(), b.order());
        fails_a.cmp(&fails_b).then(other_a.cmp(&other_b)).then(change_a.total_cmp(&change_b))
    });
    let demand = demand_rows(&pair);
    Ok(Difference { before, after, demand, checks, best_before: best(&sized_before), best_after: best(&sized_after) })
}
