//! A check, and the demand of an axis, as records.

use crate::explain::derivation;
use crate::sizing_use::Candidate;
use answers::{AssumptionEntry, DemandFigures, DemandMode, Id, IntegralDemand, MoveTorques, Number, Units};
use axis::{AssumedKeys, AxisProject};
use quantities::unit::{NEWTON_METRE, PERCENT, REVOLUTION_PER_MINUTE, SECOND};
use quantities::{Language, Measure};
use sizing::{Amount, Check, Demand, ManualDemand, Note};
use words::{assumption_text, check_meaning, note_text, source_text, title_of_check};

/// Returns one check.
#[must_use]
pub fn check(check: &Check, language: Language) -> answers::Check {
    let number = |figure: Option<Amount>| figure.map(|figure| Number(figure.value()));
    let sources: Vec<String> = [&check.limit_source, &check.value_source]
        .into_iter()
        .flatten()
        .map(|source| source_text(source, language))
        .collect();
    answers::Check {
        id: Id(check.id),
        title: title_of_check(check, language),
        verdict: Id(check.verdict),
        value: number(check.value),
        limit: number(check.limit),
        unit: check.value.or(check.limit).map(|figure| figure.unit.json),
        direction: Id(check.direction()),
        part: Id(check.id.part()),
        utilisation: check.utilisation.map(Number),
        margin: check.id.has_margin(),
        at: check.at.map(|at| Number::in_unit(at.si(), &SECOND)),
        grade: check.grade.map(Id),
        source: (!sources.is_empty()).then(|| sources.join("; ")),
        sources,
        missing: check.missing.map(str::to_owned),
        notes: check.notes.iter().map(|note| note_text(note, language)).collect(),
        errata: check
            .notes
            .iter()
            .filter_map(|note| if let Note::Erratum(id) = note { Some(*id) } else { None })
            .collect(),
        is_of_another_gear: check.is_of_another_gear(),
        is_open: check.is_open(),
    }
}

/// Returns a check with the derivation of its value and its limit.
#[must_use]
pub fn explained(found: &Check, language: Language) -> answers::Explained {
    answers::Explained {
        check: check(found, language),
        meaning: check_meaning(found.id, language),
        derivation: derivation(found, language),
    }
}

/// Returns checks of an actuator with their derivations.
#[must_use]
pub fn explanations(
    project: &AxisProject,
    candidate: &Candidate<'_>,
    checks: &[&Check],
    language: Language,
) -> answers::Explanations {
    answers::Explanations {
        axis: project.name.clone(),
        code: candidate.id.to_string(),
        checks: checks.iter().map(|check| explained(check, language)).collect(),
        assumptions: assumptions_about(project, candidate, language),
    }
}

/// Returns the assumptions of an answer about one actuator: also how it was chosen, where none is stated.
pub(super) fn assumptions_about(
    project: &AxisProject,
    candidate: &Candidate<'_>,
    language: Language,
) -> Vec<AssumptionEntry> {
    let best = candidate.how_named(language).map(|why| AssumptionEntry {
        key: None,
        value: Some(candidate.id.to_string()),
        why,
    });
    let concerning = project.assumed().into_iter().filter(|each| candidate.is_concerned_by(each.assumption));
    best.into_iter().chain(concerning.map(|each| assumption(each, language))).collect()
}

/// Returns the assumptions, with the keys that take their place and the values in effect.
pub(crate) fn assumptions(project: &AxisProject, language: Language) -> Vec<AssumptionEntry> {
    project.assumed().into_iter().map(|each| assumption(each, language)).collect()
}

/// Returns an assumption with its keys and the value in effect.
pub(crate) fn assumption(assumed: AssumedKeys, language: Language) -> AssumptionEntry {
    AssumptionEntry {
        key: (!assumed.keys.is_empty()).then(|| assumed.keys.join(", ")),
        value: assumed.value,
        why: assumption_text(assumed.assumption, language),
    }
}

fn figures(demand: &Demand) -> DemandFigures {
    DemandFigures {
        torque_rms: Number::in_unit(demand.torque_rms.si(), &NEWTON_METRE),
        torque_peak: Number::in_unit(demand.torque_peak.si(), &NEWTON_METRE),
        speed_mean: Number::in_unit(demand.speed_mean.si(), &REVOLUTION_PER_MINUTE),
        speed_peak: Number::in_unit(demand.speed_peak.si(), &REVOLUTION_PER_MINUTE),
        duty_factor: Number(demand.duty_factor * 100.0),
    }
}

fn torques(torques: &sizing::MoveTorques) -> MoveTorques {
    let [accelerate, run, brake] =
        [torques.accelerate, torques.run, torques.brake].map(|torque| Number::in_unit(torque.si(), &NEWTON_METRE));
    MoveTorques { accelerate, run, brake }
}

/// Returns the demand: the figures of the manual with T_1, T_2, T_3 of the governing move, beside the exact integrals.
pub(super) fn demand(manual: Option<&ManualDemand>, integral: Option<&Demand>) -> Option<answers::Demand> {
    let units = Units::of(&[("T", &NEWTON_METRE), ("n", &REVOLUTION_PER_MINUTE), ("ED", &PERCENT)]);
    let exact = integral.map(figures);
    let Some(manual) = manual else {
        return exact.map(|figures| answers::Demand {
            mode: DemandMode::Integral,
            figures,
            torques: None,
            units,
            moves: Vec::new(),
            governing_move: None,
            integral: None,
        });
    };
    let several = manual.moves.len() > 1;
    Some(answers::Demand {
        mode: DemandMode::Manual,
        figures: figures(&manual.demand),
        torques: manual.moves.get(manual.governing).map(torques),
        units,
        moves: if several { manual.moves.iter().map(torques).collect() } else { Vec::new() },
        governing_move: several.then_some(manual.governing + 1),
        integral: exact.map(|figures| IntegralDemand { figures, mode: DemandMode::Integral }),
    })
}
