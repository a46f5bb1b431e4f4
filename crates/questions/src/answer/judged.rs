//! Judged actuators as records.

use super::check::{assumptions, assumptions_about, check, demand};
use super::code::names;
use super::motion;
use crate::catalogue_reserve::CatalogueReach;
use crate::gearing_proposals::GearingProposal;
use crate::limits::{NeededLimit, limits_needed};
use crate::proposals::{LawProposal, Proposals};
use crate::sizing_use::{Candidate, Sizing};
use crate::texts::{conditional_text, objection_text, reserve_condition, unsought_text};
use crate::tolerance::{Assessment, PointKind};
use answers::{
    Assessed, Fit, Id, Influence, Judgement, Make, NotSought, Number, Quantiles, Ranked, Rejection, Stage, StageRatio,
    Tolerance, ToleratedValue, Units, WorstCorner, WouldFit, WouldFitAfter, WouldFitWithLaw,
};
use axis::{ALL_CORNERS_MOST, AxisProject};
use configurator::ProductId;
use project::SegmentLaw;
use quantities::unit::{DAY, DEGREE_CELSIUS, KILOGRAM, MILLIMETRE, ONE, SECOND};
use quantities::{Language, Measure};
use sizing::{AxisChange, Proviso, Reserve, SAMPLES_ANEW, Verdict};
use words::{law_text, ranking_rule, unmet_text};

/// Returns the objections to a candidate besides failing checks, as text.
#[must_use]
pub fn objections(candidate: &Candidate<'_>, language: Language) -> Vec<String> {
    candidate.objections.iter().map(|each| objection_text(candidate, each, language)).collect()
}

/// Returns the requirements that stay open because a datum is missing, as text; `None` if there are none.
fn open_requirements(candidate: &Candidate<'_>, language: Language) -> Option<Vec<String>> {
    let open = candidate.open_requirements.iter().map(|unmet| unmet_text(unmet, language));
    Some(open.collect()).filter(|open: &Vec<String>| !open.is_empty())
}

/// Returns the verdict on a candidate.
#[must_use]
pub fn fit(candidate: &Candidate<'_>) -> Fit {
    candidate.fit().into()
}

/// Returns one judged actuator.
#[must_use]
pub fn candidate(candidate: &Candidate<'_>, language: Language) -> answers::Candidate {
    let id = Some(candidate.id.to_string());
    let (code, name) = if candidate.product.is_of_project() { (None, id) } else { (id, None) };
    let judgement = &candidate.judgement;
    answers::Candidate {
        code,
        name,
        make: candidate.is_among_makers.then(|| make(candidate)),
        verdict: fit(candidate),
        utilisation: Number(candidate.utilisation().unwrap_or(f64::NAN)),
        tightest: candidate.governing().map(|check| Id(check.id)),
        mass_kg: candidate.parameters.mass.known().map(|mass| Number::in_unit(mass.value.si(), &KILOGRAM)),
        mass_errata: candidate.parameters.mass.known().map_or_else(Vec::new, |mass| mass.errata.to_vec()),
        on_request: names(&candidate.on_request, language),
        demand: demand(judgement.by_the_manual(), judgement.demand.as_ref()),
        checks: judgement.checks.iter().map(|each| check(each, language)).collect(),
        objections: objections(candidate, language),
        open_requirements: open_requirements(candidate, language),
        open_questions: candidate.open_questions(),
    }
}

/// Returns maker, series and kind of an actuator, with length, price and time of delivery.
fn make(candidate: &Candidate<'_>) -> Make {
    let product = candidate.product;
    Make {
        maker: product.manufacturer.as_deref().map(str::to_owned),
        series: product.series.as_deref().map(str::to_owned),
        kind: "actuator",
        length_mm: product.parameters.length.known().map(|length| Number::in_unit(length.value.si(), &MILLIMETRE)),
        price: product.offer.price.as_deref().map(str::to_owned),
        lead_time_d: product.offer.lead_time.map(|time| Number::in_unit(time.si(), &DAY)),
    }
}

/// Returns one actuator with the motion, the reserve and the tolerances of the project.
#[must_use]
pub fn judgement(
    project: &AxisProject,
    judged: &Candidate<'_>,
    found: &Reserve,
    assessment: Option<&Assessment>,
    language: Language,
) -> Judgement {
    Judgement {
        candidate: candidate(judged, language),
        axis: project.name.clone(),
        motion: motion(&crate::moves(project), None, language),
        reserve: reserve(found, judged, language),
        tolerance: assessment.map(|found| tolerance(project, found, language)),
        assumptions: assumptions_about(project, judged, language),
    }
}

/// Returns the reason for the rejection of a candidate, in short form.
fn rejection(candidate: &Candidate<'_>, language: Language) -> Rejection {
    let worst = candidate.judgement.worst_failure();
    let failing = candidate.judgement.checks.iter().filter(|check| check.verdict == Verdict::Fail);
    Rejection {
        code: candidate.id.to_string(),
        make: candidate.is_among_makers.then(|| make(candidate)),
        check: worst.map(|check| Id(check.id)),
        value: worst.and_then(|check| check.value).map(|figure| Number(figure.value())),
        limit: worst.and_then(|check| check.limit).map(|figure| Number(figure.value())),
        unit: worst.and_then(|check| check.value).map(|figure| figure.unit.json),
        utilisation: worst.and_then(|check| check.utilisation).map(Number),
        failing: failing.map(|check| Id(check.id)).collect(),
        objections: objections(candidate, language),
    }
}

/// Returns the catalogue judged for an axis: the best `top` in full, the rejected ones with their reason.
#[must_use]
pub fn sizing(
    sizing: &Sizing<'_>,
    project: &AxisProject,
    assessed: &[(ProductId, Assessment)],
    proposals: &Proposals,
    top: usize,
    language: Language,
) -> answers::Sizing {
    let judged = |each: &Candidate<'_>| Assessed {
        candidate: candidate(each, language),
        tolerance: assessed.iter().find(|(of, _)| *of == each.id).map(|(_, found)| tolerance(project, found, language)),
    };
    let [certain, if_estimate] = sizing.counts();
    let ranking = sizing.fitting().iter().take(top).enumerate();
    answers::Sizing {
        axis: sizing.name.to_owned(),
        verdict: sizing.fit().into(),
        answer: sizing.answer().map(|answer| answer.id.to_string()),
        judged: sizing.candidates.len(),
        fit: certain,
        not_evaluated: sizing.not_evaluated(),
        fit_if_estimate: if_estimate,
        fitting: certain + if_estimate,
        rule: ranking_rule(sizing.by_mass, language),
        ranking: ranking.map(|(index, each)| Ranked { of: judged(each), rank: index + 1 }).collect(),
        rejected: sizing.rejected().iter().map(|each| rejection(each, language)).collect(),
        nearest_miss: sizing.nearest_miss().map(|miss| miss.id.to_string()),
        own: sizing.own.as_ref().map(judged),
        would_fit_after: Vec::new(),
        would_fit_with: proposals.gearings.iter().map(would_fit).collect(),
        would_fit_with_law: proposals.law.as_ref().map(|law| would_fit_with_law(law, language)),
        assumptions: assumptions(project, language),
        stage: stage(project),
        motion: motion(&crate::moves(project), None, language),
    }
}

fn would_fit(mend: &GearingProposal) -> WouldFit {
    WouldFit {
        key: mend.path.clone(),
        stated: mend.is_stated,
        value: Number::in_unit(mend.si, mend.unit),
        unit: mend.unit.json,
        code: mend.code.clone(),
        verdict: mend.fit.into(),
        if_estimate: mend.proviso.estimate,
        unless_rating: mend.proviso.rating,
    }
}

/// Returns a change of load or cycle time with which an actuator of the catalogue fits.
pub(crate) fn would_fit_after(reach: &CatalogueReach) -> WouldFitAfter {
    let (change, unit) = match reach.change {
        AxisChange::CycleTime => ("cycle_time", SECOND.json),
        AxisChange::Payload => ("payload_factor", ONE.json),
        AxisChange::Load => ("load_factor", ONE.json),
    };
    WouldFitAfter {
        change,
        value: Number(reach.value),
        unit,
        code: reach.code.clone(),
        verdict: reach.fit.into(),
        if_estimate: reach.proviso.estimate,
        unless_rating: reach.proviso.rating,
    }
}

fn would_fit_with_law(proposal: &LawProposal, language: Language) -> WouldFitWithLaw {
    let law = SegmentLaw::Law(proposal.law);
    WouldFitWithLaw {
        law: law.id(),
        title: law_text(law, language),
        keys: proposal.paths.clone(),
        code: proposal.code.clone(),
        verdict: proposal.fit.into(),
        if_estimate: proposal.proviso.estimate,
        unless_rating: proposal.proviso.rating,
    }
}

/// Returns the ratio of the stage between actuator and mechanism, and the results for the other ratios of the project.
fn stage(project: &AxisProject) -> Option<Stage> {
    let stage = project.axis.mechanism.stage.as_ref()?;
    let ratios = project.ratios.iter().map(|each| StageRatio {
        ratio: Number(each.ratio),
        answer: each.answer.as_ref().map(ToString::to_string),
        utilisation: Number(each.utilisation),
        fitting: each.fitting,
    });
    Some(Stage { ratio: Number(stage.ratio), ratios: ratios.collect() })
}

/// Returns the permissible changes of the axis, or of the limits of its project.
#[must_use]
pub fn reserve(reserve: &Reserve, candidate: &Candidate<'_>, language: Language) -> answers::Reserve {
    let limit = |needed: NeededLimit| {
        let unit = needed.enough.unit;
        answers::NeededLimit { key: needed.key, value: Number::in_unit(needed.enough.si, unit), unit: unit.json }
    };
    let reaches = [
        ("load_factor", reserve.load_factor.map(|reach| reach.proviso)),
        ("payload_factor", reserve.payload_factor.map(|reach| reach.proviso)),
        ("cycle_time", reserve.cycle_time.map(|reach| reach.proviso)),
        ("ambient_least", reserve.ambient_least.map(|reach| reach.proviso)),
        ("ambient", reserve.ambient.map(|reach| reach.proviso)),
    ];
    let names = |of: fn(Proviso) -> bool| {
        reaches.iter().filter(|(_, proviso)| proviso.is_some_and(of)).map(|(name, _)| *name).collect()
    };
    answers::Reserve {
        limits: limits_needed(candidate).map(|limits| limits.into_iter().map(limit).collect()),
        load_factor: reserve.load_factor.map(|reach| Number(reach.value)),
        payload_factor: reserve.payload_factor.map(|reach| Number(reach.value)),
        cycle_time: reserve.cycle_time.map(|reach| Number::in_unit(reach.value.si(), &SECOND)),
        ambient: reserve.ambient.map(|reach| Number::in_unit(reach.value.si(), &DEGREE_CELSIUS)),
        ambient_least: reserve.ambient_least.map(|reach| Number::in_unit(reach.value.si(), &DEGREE_CELSIUS)),
        units: Units::of(&[("cycle_time", &SECOND), ("ambient", &DEGREE_CELSIUS), ("ambient_least", &DEGREE_CELSIUS)]),
        if_estimate: names(|proviso| proviso.estimate),
        unless_rating: names(|proviso| proviso.rating),
        not_checked: reserve_condition(reserve, candidate, language).map(|text| answers::ReserveNotChecked {
            checks: candidate.unmade().into_iter().map(|check| Id(check.id)).collect(),
            text,
        }),
        not_sought: reserve.unsought.map(|unsought| NotSought {
            quantities: ["load_factor", "payload_factor"]
                .into_iter()
                .chain(unsought.pace.then_some("cycle_time"))
                .collect(),
            samples: unsought.samples,
            most: SAMPLES_ANEW,
            text: unsought_text(&unsought, language),
        }),
    }
}

/// Returns samples, worst point and influences of the tolerances.
#[must_use]
pub fn tolerance(project: &AxisProject, assessment: &Assessment, language: Language) -> Tolerance {
    let found = &assessment.utilisation;
    let worst = &assessment.worst;
    let values = project.tolerances.iter().zip(&worst.values).map(|(each, si)| ToleratedValue {
        quantity: each.path.clone(),
        value: Number::in_unit(*si, each.unit),
        unit: each.unit.json,
    });
    let influence = assessment.influence.iter().filter_map(|each| {
        let quantity = project.tolerances.get(each.quantity)?.path.clone();
        Some(Influence { quantity, share: Number(each.share) })
    });
    Tolerance {
        samples: assessment.sampling.samples,
        seed: assessment.sampling.seed,
        distribution: "uniform",
        passes: assessment.passes,
        passes_if_estimate: assessment.conditional.samples,
        condition: conditional_text(assessment, language).unwrap_or_default(),
        impossible: assessment.impossible,
        share: Number(assessment.share()),
        interval: [Number(assessment.interval.0), Number(assessment.interval.1)],
        utilisation: Quantiles {
            p05: Number(found.p05),
            p50: Number(found.p50),
            p95: Number(found.p95),
            max: Number(found.max),
        },
        worst_corner: WorstCorner {
            verdict: worst.fit.into(),
            utilisation: Number(worst.utilisation),
            check: worst.check.map(Id),
            values: values.collect(),
            is_corner: worst.place != PointKind::Sample,
            exhaustive: project.tolerances.len() <= ALL_CORNERS_MOST,
        },
        influence: influence.collect(),
    }
}
