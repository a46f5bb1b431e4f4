//! Whole use cases on a generated project: verdicts that follow from the checks, answers that agree with each other and
//! with their schema, complete tables and pictures.

mod forms;
pub(crate) mod verdict;

use crate::text::{any_edits, mutate, tells};
use crate::{draft, project};
use ::axis::AxisProject;
use arbitrary::{Result, Unstructured};
use quantities::{Language, Measure};
use questions::list::diff::difference;
use questions::{Candidate, CheckId, Draw, ProductId, Progress, Sizing, Verdict, answer, check, list, size};
use serde::Serialize;
use serde_json::Value;
use std::sync::LazyLock;

/// Few samples, enough to execute every step.
const FEW: Draw = Draw { samples: Some(5), seed: 1 };

/// Input of a use case.
struct Case<'c> {
    text: &'c str,
    /// Place of the axis in the file.
    place: usize,
    project: &'c AxisProject,
    language: Language,
}

/// Sizes a generated project, in some cases with edits, and tests one further use case.
pub fn run(data: &[u8]) {
    let mut u = Unstructured::new(data);
    let Ok((question, language, text)) = chosen(&mut u) else { return };
    let Some(projects) = project::hold(&text) else { return };
    for (place, project) in projects.iter().enumerate() {
        let case = Case { text: &text, place, project, language };
        hold(&case, question);
    }
}

/// Returns the text of a case.
pub fn shown(data: &[u8]) -> String {
    chosen(&mut Unstructured::new(data))
        .map(|(question, language, text)| format!("# question {question}, {language:?}\n{text}"))
        .unwrap_or_default()
}

fn chosen(u: &mut Unstructured<'_>) -> Result<(u8, Language, String)> {
    let question = u.int_in_range(0..=9)?;
    let language = if u.ratio(1, 2)? { Language::De } else { Language::En };
    let edits = if u.ratio(1, 6)? { any_edits(u, 3)? } else { Vec::new() };
    let text = draft::project(u, true)?;
    Ok((question, language, mutate(&text, &edits)))
}

fn hold(case: &Case<'_>, question: u8) {
    let sizing = size(case.project);
    sizing.candidates.iter().chain(&sizing.own).for_each(verdict::candidate);
    assert!(sizing.candidates.is_sorted_by_key(|each| !each.fits()), "what fits stands first");
    let Some(best) = sizing.candidates.first() else { return };
    let code = best.id.clone();
    match question {
        0 => ranking(case),
        1 => agree(case, &sizing),
        2 => one(case, &code),
        3 => workings(case, &code),
        4 => compare_first_two(case, &sizing),
        5 => revisions(case, &code),
        6 => forms::tables(case, &sizing, best),
        7 => forms::figures(case, best),
        8 => twin(case, &code),
        _ => forms::dossier(case, &sizing, best),
    }
}

fn ranking(case: &Case<'_>) {
    let progress = Progress::endless();
    let Ok(found) = questions::list::size::ranking(case.project, 2, FEW, &progress) else { return };
    let found = found.record(case.language);
    assert_eq!(found.answer.is_some(), found.fitting > 0);
    keeps_to_schema("size", &found);
    if let Ok(found) = list::bearing::sizes(case.project, &progress, case.language) {
        keeps_to_schema("bearing", &answer::bearings(&found, case.project, case.language));
    }
}

/// Runs the twin if the run fits into the time of a case.
fn twin(case: &Case<'_>, code: &ProductId) {
    if let Some(Ok(run)) = twin_of(case.project, code, case.language) {
        keeps_to_schema("simulate", &answer::simulation(&run, case.language));
    }
}

/// Runs the twin: the run is refused with a reason, or every figure is a number, or the run is marked as having left
/// every bound. Returns `None` if it takes too long: ten cycles at a tenth of the speed that the fuzzing engine leaves.
///
/// # Panics
/// The run is none of these.
pub fn twin_of<'p>(
    project: &'p AxisProject,
    code: &ProductId,
    language: Language,
) -> Option<std::result::Result<questions::Simulated<'p>, list::simulate::NotSimulated>> {
    if project.axis.motion.duration().si() > 1.0 || project.twin.scenario.cycles > 1 {
        return None;
    }
    let scenario = project.twin.scenario.id;
    let found = list::simulate::of_scenario(project, Some(code), (scenario, None), &Progress::endless(), language);
    match &found {
        Ok(run) => {
            let ends = run.events.iter().any(|event| event.kind.id() == "diverged");
            let s = &run.summary;
            let figures = [s.following_rms_rad, s.current_rms_a, s.torque_peak_nm, s.link_v[1], s.unaccounted_j];
            assert!(ends || figures.iter().all(|figure| figure.is_finite()), "{s:?}");
            assert!(ends || run.course.iter().all(|row| row.position_rad.is_finite() && row.current_q_a.is_finite()));
        }
        Err(why) => assert!(!why.sentence.is_empty()),
    }
    Some(found)
}

/// Checks that the ranking, which judges in stages, agrees with the full judgement of a single candidate.
fn agree(case: &Case<'_>, sizing: &Sizing<'_>) {
    let fitting = sizing.candidates.iter().filter(|each| each.fits()).take(4);
    let rejected = sizing.candidates.iter().filter(|each| !each.fits()).step_by(40);
    for each in fitting.chain(rejected) {
        let code = &each.id;
        // Options required by the project may violate a rule; then only the ranking judges the candidate.
        let Ok(alone) = check(case.project, code) else { continue };
        verdict::candidate(&alone);
        let said = |candidate: &Candidate<'_>| {
            let checks = candidate.judgement.checks.iter().filter(|check| check.verdict == Verdict::Fail);
            let failing: Vec<CheckId> = checks.map(|check| check.id).collect();
            (candidate.fit(), failing, candidate.governing().map(|check| check.id), candidate.standing.utilisation)
        };
        assert_eq!(said(&alone), said(each), "{code}");
        for check in &each.judgement.checks {
            let same = alone.judgement.checks.iter().find(|other| other.id == check.id);
            let Some(same) = same else { continue };
            assert_eq!((same.verdict, same.value, same.limit), (check.verdict, check.value, check.limit), "{code}");
        }
    }
}

fn one(case: &Case<'_>, code: &ProductId) {
    for code in [Some(code), None] {
        if let Ok(found) = questions::list::check::verification(case.project, code, FEW, &Progress::endless()) {
            keeps_to_schema("check", &found.record(case.language));
        }
    }
    if let Ok(judged) = check(case.project, code) {
        verdict::reserve(case, code, &judged);
    }
}

fn workings(case: &Case<'_>, code: &ProductId) {
    let explained =
        |check| questions::list::explain::explanation(case.project, Some(code), check, &Progress::endless());
    let Ok(found) = explained(None) else { return };
    let found = found.record(case.language);
    assert!(!found.checks.is_empty());
    keeps_to_schema("explain", &found);
    if let Ok(found) = explained(Some(CheckId::PeakTorque)) {
        assert_eq!(found.checks().len(), 1);
    }
}

/// Compares the first two of the ranking, and the first with itself.
fn compare_first_two(case: &Case<'_>, sizing: &Sizing<'_>) {
    let codes: Vec<ProductId> = sizing.candidates.iter().take(2).map(|each| each.id.clone()).collect();
    let Ok(found) = questions::list::compare::compare(case.project, &codes, &Progress::endless()) else { return };
    keeps_to_schema("compare", &answer::comparison(&found, case.project, case.language));
    assert!(found.checks.iter().all(|row| row.checks.len() == codes.len()));
    let twice: Vec<ProductId> = codes.iter().take(1).chain(codes.iter().take(1)).cloned().collect();
    let Ok(found) = questions::list::compare::compare(case.project, &twice, &Progress::endless()) else { return };
    assert!(
        found.demand.iter().chain(&found.data).all(questions::list::compare::DatumRow::is_same),
        "{:?}",
        found.demand
    );
    assert!(found.checks.iter().all(|row| row.better.is_none()), "nothing is better than itself");
}

/// Checks that a revision without changes shows no difference.
fn revisions(case: &Case<'_>, code: &ProductId) {
    let Ok(found) = difference(case.project, case.project, Some(code), &Progress::endless()) else { return };
    assert!(found.demand.iter().all(questions::list::compare::DatumRow::is_same), "{:?}", found.demand);
    assert!(found.checks.iter().all(questions::list::diff::CheckChange::is_same), "{code}");
    assert_eq!(found.best_before, found.best_after);
    let inputs = ::project::input_changes((case.text, case.place), (case.text, case.place));
    assert!(inputs.is_empty(), "{inputs:?}");
    keeps_to_schema("diff", &answer::difference(&found, &inputs, &case.project.name, case.language));
}

/// Schema of each answer, compiled once.
struct Compiled {
    schemas: boon::Schemas,
    of: Vec<(&'static str, boon::SchemaIndex)>,
}

static COMPILED: LazyLock<Option<Compiled>> = LazyLock::new(|| compiled(&answers::schema(&questions::list::records())));

fn compiled(schema: &Value) -> Option<Compiled> {
    let mut found = Compiled { schemas: boon::Schemas::new(), of: Vec::new() };
    for command in ["size", "check", "explain", "compare", "diff", "bearing", "simulate", "export --table"] {
        let mut one = schema.get("properties")?.get(command)?.as_object()?.clone();
        one.insert("$schema".into(), schema.get("$schema")?.clone());
        one.insert("$defs".into(), schema.get("$defs")?.clone());
        let mut compiler = boon::Compiler::new();
        let name = format!("{}.json", command.replace(' ', ""));
        compiler.add_resource(&name, Value::Object(one)).ok()?;
        let index = compiler.compile(&name, &mut found.schemas).ok()?;
        found.of.push((command, index));
    }
    Some(found)
}

/// Checks that an answer as JSON satisfies its schema, and that no text in it would control a terminal.
fn keeps_to_schema(command: &str, record: &impl Serialize) {
    let value = serde_json::to_value(record).unwrap_or_default();
    let found = COMPILED.as_ref().and_then(|found| Some((found, found.of.iter().find(|(of, _)| *of == command)?.1)));
    assert!(found.is_some(), "no schema of {command}");
    if let Some((found, index)) = found
        && let Err(fault) = found.schemas.validate(&value, index)
    {
        assert!(value.is_null(), "{command}: {fault:#}");
        assert!(!value.is_null(), "{command}: no JSON");
    }
    texts(&value);
}

fn texts(value: &Value) {
    match value {
        Value::String(text) if !text.is_empty() => tells(text),
        Value::Array(all) => all.iter().for_each(texts),
        Value::Object(all) => all.values().for_each(texts),
        _ => {}
    }
}
