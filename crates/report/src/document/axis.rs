//! The chapters of one axis.

use super::alternatives::Alternatives;
use super::checks::{Checks, Titles};
use super::demand::{DemandTable, MotionTable};
use super::figure_file;
use super::inputs::{Inputs, Mechanism, groups};
use super::laid_out::{LaidOut, laid_out};
use super::origins::{Derived, Source, derived, sources};
use super::shown::{Shown, tied};
use crate::{AxisContent, Diagram, DiagramPlace};
use answers::{Candidate, Check, CheckId, Dossier, Fit, Item, Number, ScrewJoint, Tolerance};
use serde::Serialize;
use words::capitalised;

/// Everything about one axis that the template places.
#[derive(Serialize)]
pub(super) struct Axis {
    /// From 1.
    number: usize,
    name: String,
    cover: Cover,
    inputs: Inputs,
    assumptions: Vec<String>,
    mechanism: Mechanism,
    motion: MotionTable,
    demand: DemandTable,
    checks: Checks,
    tolerance: Option<Scatter>,
    alternatives: Alternatives,
    bill_of_material: Vec<Item>,
    screws: Vec<ScrewJoint>,
    errata: Vec<Erratum>,
    figures: Vec<Placed>,
    /// Chapters for building and running the machine, if requested.
    chapters: Vec<LaidOut>,
    /// Only of the full form.
    derivations: Vec<Derived>,
    /// Only of the full form.
    sources: Vec<Source>,
}

#[derive(Serialize)]
struct Cover {
    code: String,
    own: bool,
    /// `fits`, `open` (fits, but questions are open), `does_not_fit`.
    verdict: &'static str,
    fails: usize,
    advised: usize,
    /// How many questions could not be answered.
    open: usize,
    /// How many of them may keep the actuator out.
    rejecting: usize,
    shown: usize,
    passed: usize,
    utilisation: String,
    share: f64,
    tightest: String,
    mass: String,
    cycle: String,
    on_request: Vec<String>,
    objections: Vec<String>,
    reserve: Vec<Reserved>,
    /// What was not sought of it, in words; empty where everything was.
    not_sought: String,
}

/// How far one thing may be changed.
#[derive(Serialize)]
struct Reserved {
    what: Reserve,
    /// The key of a limit of the project; empty elsewhere.
    key: String,
    value: String,
}

/// What may be changed.
#[derive(Clone, Copy, Serialize)]
#[serde(rename_all = "snake_case")]
enum Reserve {
    LoadFactor,
    PayloadFactor,
    CycleTime,
    Ambient,
    Limits,
    Gearing,
}

/// What the tolerances of the project mean.
#[derive(Serialize)]
struct Scatter {
    share: String,
    interval: [String; 2],
    samples: usize,
    seed: String,
    passes: usize,
    impossible: usize,
    quantiles: [String; 4],
    corner: Corner,
    influence: Vec<Influence>,
}

#[derive(Serialize)]
struct Corner {
    fits: bool,
    utilisation: String,
    check: String,
    is_corner: bool,
    exhaustive: bool,
    values: Vec<[String; 2]>,
}

#[derive(Serialize)]
struct Influence {
    quantity: String,
    share: f64,
    percent: String,
}

#[derive(Serialize)]
struct Erratum {
    id: String,
    text: String,
    check: String,
}

#[derive(Serialize)]
struct Placed {
    place: DiagramPlace,
    file: String,
    caption: String,
    alternative: String,
}

impl Axis {
    pub(super) fn build(index: usize, content: &AxisContent, full: bool, shown: &Shown) -> Self {
        let dossier = &content.dossier;
        let judgement = &dossier.judgement;
        let titles = Titles::collect(dossier);
        let checks = Checks::build(dossier, shown);
        let erratum = |each: &answers::ErratumUsed| Erratum {
            id: each.erratum.id.clone(),
            text: tied(&each.erratum.evidence),
            check: capitalised(&each.check),
        };
        Self {
            number: index + 1,
            name: judgement.axis.clone(),
            cover: cover(content, &checks, &titles, shown),
            inputs: groups(&dossier.inputs),
            assumptions: judgement.assumptions.iter().map(|text| tied(text)).collect(),
            mechanism: Mechanism::build(dossier, shown),
            motion: MotionTable::build(&judgement.motion, shown),
            demand: DemandTable::build(dossier, shown),
            tolerance: judgement.tolerance.as_ref().map(|found| scatter(found, dossier, &titles, shown)),
            alternatives: Alternatives::build(dossier, &titles, full, shown),
            bill_of_material: dossier.bill_of_material.clone(),
            screws: dossier.screws.iter().map(tied_joint).collect(),
            errata: dossier.errata.iter().map(erratum).collect(),
            figures: content.figures.iter().enumerate().map(|(place, figure)| placed(index, place, figure)).collect(),
            chapters: laid_out(index, &content.chapters),
            derivations: if full { derived(&dossier.explained, shown) } else { Vec::new() },
            sources: if full { sources(&dossier.explained) } else { Vec::new() },
            checks,
        }
    }
}

fn tied_joint(joint: &ScrewJoint) -> ScrewJoint {
    ScrewJoint { circle: tied(&joint.circle), torque: tied(&joint.torque), text: tied(&joint.text), ..joint.clone() }
}

fn placed(axis: usize, index: usize, figure: &Diagram) -> Placed {
    Placed {
        place: figure.place,
        file: figure_file(axis, index),
        caption: tied(&figure.caption),
        // An archive file must have one.
        alternative: [&figure.alternative_text, &figure.caption]
            .into_iter()
            .find(|text| !text.trim().is_empty())
            .map_or_else(|| "–".to_owned(), Clone::clone),
    }
}

fn cover(content: &AxisContent, checks: &Checks, titles: &Titles, shown: &Shown) -> Cover {
    let judgement = &content.dossier.judgement;
    let candidate = &judgement.candidate;
    let counts = checks.counts();
    let reserve = &judgement.reserve;
    let reserve = [
        (Reserve::LoadFactor, reserve.load_factor, "1"),
        (Reserve::PayloadFactor, reserve.payload_factor, "1"),
        (Reserve::CycleTime, reserve.cycle_time, "s"),
        (Reserve::Ambient, reserve.ambient, "degC"),
    ]
    .into_iter()
    .filter_map(|(what, value, unit)| Some(Reserved { what, key: String::new(), value: shown.figure(value?, unit) }));
    let limits = judgement.reserve.limits.iter().flatten().map(|limit| Reserved {
        what: Reserve::Limits,
        key: words_of(&limit.key, &content.dossier),
        value: shown.figure(limit.value, limit.unit),
    });
    let gearing = content.dossier.sizing.would_fit_with.iter().map(|found| Reserved {
        what: Reserve::Gearing,
        key: words_of(&found.key, &content.dossier),
        value: format!("{} ({})", shown.figure(found.value, found.unit), found.code),
    });
    let cycle: f64 = judgement.motion.segments.iter().map(|segment| segment.duration.0).sum();
    Cover {
        code: candidate.called().to_owned(),
        own: candidate.code.is_none(),
        verdict: match (candidate.verdict, candidate.open_questions) {
            (Fit::Fits, 0) => "fits",
            (Fit::Fits, _) => "open",
            (Fit::DoesNotFit, _) => "does_not_fit",
        },
        fails: counts.failed,
        advised: counts.advised,
        open: candidate.open_questions,
        // Beside the checks these are requirements for which a datum is missing, and every requirement may reject.
        rejecting: counts.rejecting + candidate.open_questions.saturating_sub(counts.open),
        shown: counts.shown,
        passed: counts.passed,
        utilisation: shown.share(candidate.utilisation),
        share: candidate.utilisation.written().unwrap_or_default(),
        tightest: highest(candidate).map(|id| capitalised(&titles.of(id))).unwrap_or_default(),
        mass: candidate.mass_kg.map(|mass| shown.figure(mass, "kg")).unwrap_or_default(),
        cycle: shown.figure(Number(cycle), "s"),
        on_request: candidate.on_request.clone(),
        objections: candidate.objections.iter().map(|text| tied(text)).collect(),
        reserve: reserve.chain(limits).chain(gearing).collect(),
        not_sought: judgement.reserve.not_sought.as_ref().map(|found| tied(&found.text)).unwrap_or_default(),
    }
}

/// The check to which the highest utilisation belongs: where a class such as the voltage is exceeded, that is not the
/// tightest margin.
fn highest(candidate: &Candidate) -> Option<CheckId> {
    let of = |check: &&Check| check.utilisation == Some(candidate.utilisation);
    let listed = candidate.checks.iter().filter(of).map(|check| *check.id);
    let tightest = candidate.tightest.map(|id| *id);
    listed.clone().find(|id| Some(*id) == tightest).or_else(|| listed.clone().next()).or(tightest)
}

/// A key of the project in the words of its inputs, with its table; the key itself where the inputs have none.
fn words_of(key: &str, dossier: &Dossier) -> String {
    let inside = key.split_once("].").filter(|(axis, _)| axis.starts_with("axis[")).map_or(key, |(_, inside)| inside);
    let found = dossier.inputs.iter().find_map(|table| {
        let name = inside.strip_prefix(table.key.as_str())?.strip_prefix('.')?;
        let value = table.values.iter().find(|value| value.name == name)?;
        (!value.label.is_empty()).then(|| format!("{} ({})", capitalised(&value.label), table.title))
    });
    found.unwrap_or_else(|| key.to_owned())
}

fn scatter(found: &Tolerance, dossier: &Dossier, titles: &Titles, shown: &Shown) -> Scatter {
    let worst = &found.worst_corner;
    let quantiles = found.utilisation;
    Scatter {
        share: shown.share(found.share),
        interval: found.interval.map(|share| shown.share(share)),
        samples: found.samples,
        seed: found.seed.to_string(),
        passes: found.passes,
        impossible: found.impossible,
        quantiles: [quantiles.p05, quantiles.p50, quantiles.p95, quantiles.max].map(|share| shown.share(share)),
        corner: Corner {
            fits: worst.verdict == Fit::Fits,
            utilisation: shown.share(worst.utilisation),
            check: worst.check.map(|id| capitalised(&titles.of(*id))).unwrap_or_default(),
            is_corner: worst.is_corner,
            exhaustive: worst.exhaustive,
            values: worst
                .values
                .iter()
                .map(|each| [words_of(&each.quantity, dossier), shown.figure(each.value, each.unit)])
                .collect(),
        },
        influence: found
            .influence
            .iter()
            .map(|each| Influence {
                quantity: words_of(&each.quantity, dossier),
                share: each.share.written().unwrap_or_default(),
                percent: shown.share(each.share),
            })
            .collect(),
    }
}
