//! The chapters of one axis.

use super::alternatives::Alternatives;
use super::checks::{Checks, Titles};
use super::demand::{DemandTable, MotionTable};
use super::inputs::{Inputs, MechanismData, groups};
use super::laid_out::{LaidOut, laid_out};
use super::operation::{CycleData, DataSheet, data_sheet, operation};
use super::origins::{DerivationLines, UsedSource, derived, sources};
use super::shown::{Formatter, tied};
use crate::{AxisContent, Diagram, DiagramPlace};
use answers::{Check, Dossier, Fit, Item, Number, ScrewJoint, Tolerance, Verdict};
use quantities::Language;
use serde::Serialize;
use words::{capitalised, erratum_place_of, marked, proviso_text, purpose_of};

/// Data of the chapters of one axis, for the template.
#[derive(Serialize)]
pub(super) struct AxisData {
    /// Number of the axis, from 1.
    number: usize,
    name: String,
    cover: Cover,
    inputs: Inputs,
    assumptions: Vec<String>,
    mechanism: MechanismData,
    motion: MotionTable,
    single_move: bool,
    demand: DemandTable,
    operation: Option<CycleData>,
    data_sheet: DataSheet,
    checks: Checks,
    tolerance: Option<Scatter>,
    alternatives: Alternatives,
    bill_of_material: Vec<Item>,
    screws: Vec<ScrewJoint>,
    errata: Vec<Erratum>,
    figures: Vec<Placed>,
    /// Chapters for building and running the machine, if requested.
    chapters: Vec<LaidOut>,
    /// Derivations; empty in the short form.
    derivations: Vec<DerivationLines>,
    /// Sources; empty in the short form.
    sources: Vec<UsedSource>,
}

#[derive(Serialize)]
struct Cover {
    code: String,
    own: bool,
    /// `fits`, `open` (fits, but questions are open), `if_estimate`, `does_not_fit`.
    verdict: &'static str,
    /// The checks that lie within the band of an estimate, each with its utilisation.
    inside: String,
    /// The checks beyond a rating of another manufacturer's gear, each with its utilisation.
    above_ratings: String,
    /// `true` if the limit of the governing check is a rating of another manufacturer's gear.
    is_of_another_gear: bool,
    fails: usize,
    advised: usize,
    /// Number of checks for which a datum is missing.
    open: usize,
    /// Requirements for which a datum is missing, as text.
    open_requirements: Vec<String>,
    /// Number of open checks that may reject the actuator.
    rejecting: usize,
    shown: usize,
    passed: usize,
    /// Utilisation of the governing check.
    utilisation: String,
    tightest: String,
    mass: String,
    cycle: String,
    on_request: Vec<String>,
    objections: Vec<String>,
    reserve: Vec<Reserved>,
    /// The reserves hold by the checks that could be made only.
    reserve_is_partial: bool,
    /// Reserves that were not searched, as text; empty if all were.
    not_sought: String,
}

/// Reserve of one quantity: the value up to which the actuator fits.
#[derive(Serialize)]
struct Reserved {
    what: Reserve,
    /// The key of a limit of the project; empty elsewhere.
    key: String,
    value: String,
    /// Conditions under which the actuator fits at this value; empty without any.
    proviso: &'static str,
}

/// Quantity to which a reserve refers.
#[derive(Clone, Copy, Serialize)]
#[serde(rename_all = "snake_case")]
enum Reserve {
    LoadFactor,
    PayloadFactor,
    CycleTime,
    Ambient,
    Limits,
    Gearing,
    Law,
}

/// Effect of the tolerances of the project.
#[derive(Serialize)]
struct Scatter {
    share: String,
    interval: [String; 2],
    samples: usize,
    seed: String,
    passes: usize,
    /// Number of samples that fit on a condition only, as text; empty for none.
    condition: String,
    impossible: usize,
    quantiles: [String; 4],
    corner: Corner,
    influence: Vec<Influence>,
}

#[derive(Serialize)]
struct Corner {
    /// `fits`, `if_estimate` or `does_not_fit`.
    verdict: &'static str,
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
    place: String,
    text: String,
    check: String,
}

#[derive(Serialize)]
struct Placed {
    place: DiagramPlace,
    /// Files of the diagram, the highest first.
    files: Vec<String>,
    caption: String,
    alternative: String,
}

impl AxisData {
    pub(super) fn build(index: usize, content: &AxisContent, full: bool, shown: &Formatter) -> Self {
        let dossier = &content.dossier;
        let judgement = &dossier.judgement;
        let titles = Titles::collect(dossier);
        let checks = Checks::build(dossier, shown);
        let erratum = |each: &answers::ErratumUsed| Erratum {
            place: tied(&capitalised(&erratum_place_of(&each.erratum.id, shown.0))),
            text: tied(&each.erratum.evidence),
            check: capitalised(&each.check),
        };
        Self {
            number: index + 1,
            name: judgement.axis.clone(),
            cover: cover(content, &checks, &titles, shown),
            inputs: groups(&dossier.inputs),
            assumptions: judgement.assumptions.iter().map(|each| tied(&each.why)).collect(),
            mechanism: MechanismData::build(dossier, shown),
            motion: MotionTable::build(&judgement.motion, shown),
            single_move: dossier.single_move,
            demand: DemandTable::build(dossier, shown),
            operation: operation(dossier, shown),
            data_sheet: data_sheet(dossier),
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
        files: (0..figure.svgs.len()).map(|size| figure_file(axis, index, size)).collect(),
        caption: tied(&figure.caption),
        // PDF/A requires an alternative text.
        alternative: [&figure.alternative_text, &figure.caption]
            .into_iter()
            .find(|text| !text.trim().is_empty())
            .map_or_else(|| "–".to_owned(), Clone::clone),
    }
}

fn cover(content: &AxisContent, checks: &Checks, titles: &Titles, shown: &Formatter) -> Cover {
    let judgement = &content.dossier.judgement;
    let candidate = &judgement.candidate;
    let counts = content.dossier.counts;
    let governing = candidate.checks.iter().find(|check| candidate.tightest == Some(check.id));
    let is_inside = |check: &&Check| {
        let beyond = check.utilisation.is_some_and(|share| share.0 > 1.0);
        *check.verdict == Verdict::Advice && check.margin && beyond
    };
    // A rating of another manufacturer's gear is no estimate and has no band.
    let beyond = |is_rating: bool| {
        let of = |check: &&Check| check.is_of_another_gear == is_rating;
        let named = candidate.checks.iter().filter(is_inside).filter(of).map(|check| {
            format!(
                "{} {}",
                capitalised(&check.title),
                check.utilisation.map(|share| shown.share(share)).unwrap_or_default()
            )
        });
        named.collect::<Vec<_>>().join("; ")
    };
    let proviso = |estimate, rating| proviso_text(estimate, rating, shown.0).unwrap_or_default();
    let reserve = &judgement.reserve;
    let reserve = [
        (Reserve::LoadFactor, "load_factor", reserve.load_factor, "1"),
        (Reserve::PayloadFactor, "payload_factor", reserve.payload_factor, "1"),
        (Reserve::CycleTime, "cycle_time", reserve.cycle_time, "s"),
        (Reserve::Ambient, "ambient", reserve.ambient.or(reserve.ambient_least), "degC"),
    ]
    .into_iter()
    .filter_map(|(what, name, value, unit)| {
        let most = shown.figure(value?, unit);
        let value = match (what, reserve.ambient_least, reserve.ambient) {
            (Reserve::Ambient, Some(least), Some(_)) => format!("{} … {most}", shown.number(least)),
            (Reserve::Ambient, Some(_), None) => format!("≥ {most}"),
            (Reserve::Ambient, None, _) => format!("≤ {most}"),
            _ => most,
        };
        let holds = |names: &[&str]| {
            names.contains(&name) || matches!(what, Reserve::Ambient) && names.contains(&"ambient_least")
        };
        let proviso = proviso(holds(&reserve.if_estimate), holds(&reserve.unless_rating));
        Some(Reserved { what, key: String::new(), value, proviso })
    });
    let limits = judgement.reserve.limits.iter().flatten().map(|limit| Reserved {
        what: Reserve::Limits,
        key: words_of(&limit.key, &content.dossier, shown.0),
        value: shown.figure(limit.value, limit.unit),
        proviso: "",
    });
    let gearing = content.dossier.sizing.would_fit_with.iter().map(|found| Reserved {
        what: Reserve::Gearing,
        key: words_of(&found.key, &content.dossier, shown.0),
        value: format!("{} ({})", shown.figure(found.value, found.unit), found.code),
        proviso: proviso(found.if_estimate, found.unless_rating),
    });
    let law = content.dossier.sizing.would_fit_with_law.iter().map(|found| Reserved {
        what: Reserve::Law,
        key: String::new(),
        value: format!("{} ({})", found.title, found.code),
        proviso: proviso(found.if_estimate, found.unless_rating),
    });
    let cycle: f64 = judgement.motion.segments.iter().map(|segment| segment.duration.0).sum();
    Cover {
        code: candidate.called().to_owned(),
        own: candidate.code.is_none(),
        verdict: match (candidate.verdict, candidate.open_questions) {
            (Fit::Fits, 0) => "fits",
            (Fit::Fits, _) if counts.deciding == 0 => "not_evaluated",
            (Fit::Fits, _) => "open",
            (Fit::FitsIfEstimate, _) => "if_estimate",
            (Fit::DoesNotFit, _) => "does_not_fit",
        },
        is_of_another_gear: governing.is_some_and(|check| check.is_of_another_gear),
        inside: beyond(false),
        above_ratings: beyond(true),
        fails: counts.failed,
        advised: counts.advised,
        open: candidate.open_questions.saturating_sub(counts.requirements_open),
        open_requirements: candidate.open_requirements.iter().flatten().map(|text| tied(text)).collect(),
        rejecting: checks.rejecting(),
        shown: counts.without_limit,
        passed: counts.passed,
        utilisation: governing.map_or_else(String::new, |check| {
            // A limit without a ratio, such as a degree of protection, is shown itself.
            check
                .utilisation
                .map_or_else(|| checks.compared(check).unwrap_or_else(|| "–".to_owned()), |share| shown.share(share))
        }),
        tightest: candidate.tightest.map(|id| capitalised(&titles.of(*id))).unwrap_or_default(),
        mass: candidate
            .mass_kg
            .map(|mass| marked(format!("{}\u{202f}kg", shown.mass(mass)), &candidate.mass_errata))
            .unwrap_or_default(),
        cycle: shown.figure(Number(cycle), "s"),
        on_request: candidate.on_request.clone(),
        objections: candidate.objections.iter().map(|text| tied(text)).collect(),
        reserve: reserve.chain(limits).chain(gearing).chain(law).collect(),
        reserve_is_partial: judgement.reserve.not_checked.is_some(),
        not_sought: judgement.reserve.not_sought.as_ref().map(|found| tied(&found.text)).unwrap_or_default(),
    }
}

/// Returns the label of a key of the project with the title of its table; its purpose if the inputs have none.
fn words_of(key: &str, dossier: &Dossier, language: Language) -> String {
    let inside = key.split_once("].").filter(|(axis, _)| axis.starts_with("axis[")).map_or(key, |(_, inside)| inside);
    let found = dossier.inputs.iter().find_map(|table| {
        let name = inside.strip_prefix(table.key.as_str())?.strip_prefix('.')?;
        let value = table.values.iter().find(|value| value.name == name)?;
        (!value.label.is_empty()).then(|| format!("{} ({})", capitalised(&value.label), table.title))
    });
    found.unwrap_or_else(|| capitalised(&purpose_of(inside, language)))
}

fn scatter(found: &Tolerance, dossier: &Dossier, titles: &Titles, shown: &Formatter) -> Scatter {
    let worst = &found.worst_corner;
    let quantiles = found.utilisation;
    Scatter {
        share: shown.share(found.share),
        interval: found.interval.map(|share| shown.share(share)),
        samples: found.samples,
        seed: found.seed.to_string(),
        passes: found.passes,
        condition: found.condition.clone(),
        impossible: found.impossible,
        quantiles: [quantiles.p05, quantiles.p50, quantiles.p95, quantiles.max].map(|share| shown.share(share)),
        corner: Corner {
            verdict: match worst.verdict {
                Fit::Fits => "fits",
                Fit::FitsIfEstimate => "if_estimate",
                Fit::DoesNotFit => "does_not_fit",
            },
            utilisation: shown.share(worst.utilisation),
            check: worst.check.map(|id| capitalised(&titles.of(*id))).unwrap_or_default(),
            is_corner: worst.is_corner,
            exhaustive: worst.exhaustive,
            values: worst
                .values
                .iter()
                .map(|each| [words_of(&each.quantity, dossier, shown.0), shown.figure(each.value, each.unit)])
                .collect(),
        },
        influence: found
            .influence
            .iter()
            .map(|each| Influence {
                quantity: words_of(&each.quantity, dossier, shown.0),
                share: each.share.written().unwrap_or_default(),
                percent: shown.share(each.share),
            })
            .collect(),
    }
}

/// Returns the name by which the template finds a figure of an axis, drawn in one of its sizes.
pub(crate) fn figure_file(axis: usize, index: usize, size: usize) -> String {
    format!("figure-{axis}-{index}-{size}.svg")
}
