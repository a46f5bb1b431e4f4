//! The derivation of a check as a tree: formula, figures put in, value, source and grade of everything.

use crate::answer::cited_erratum;
use answers::{Derivation, Id, Node, Number};
use provenance::{Grade, Source};
use quantities::{Language, Unit, with_symbol};
use sizing::Check;
use sizing::derivation::{Formula, How, Part, Step};
use words::{found_condition, found_text, grade_word, source_text, step_term, symbol_shown, symbol_term, unpadded};

/// Digits of the figures in a derivation: as many as a pocket calculator needs to come to the same answer.
const DIGITS: usize = 6;

/// Returns the value of a figure with its unit as text.
#[must_use]
pub fn node_amount(node: &Node, language: Language) -> String {
    let (number, unit) = number_and_unit(node, language);
    with_symbol(&number, unit)
}

/// Returns the number of a figure as text, and the symbol of its unit; `1` for a ratio.
#[must_use]
pub fn number_and_unit(node: &Node, language: Language) -> (String, &'static str) {
    let value = node.value.0;
    match Unit::of(node.unit) {
        Some(unit) if unit.is_below_resolution(value) => ("0".to_owned(), unit.symbol_in(language)),
        Some(unit) => (number_text(value, language), unit.symbol_in(language)),
        None => (number_text(value, language), node.unit),
    }
}

/// Returns a number of a derivation as text.
#[must_use]
pub fn number_text(value: f64, language: Language) -> String {
    unpadded(value, DIGITS, language)
}

/// Returns the derivation of value and limit of a check that was judged with its workings.
#[must_use]
pub fn derivation(check: &Check, language: Language) -> Derivation {
    let steps = &check.workings;
    let mut seen = vec![false; steps.len()];
    let mut of = |part: Part| {
        let root = steps.iter().rposition(|step| step.part == part)?;
        node(steps, root, &mut seen, language)
    };
    Derivation { value: of(Part::Value), limit: of(Part::Limit) }
}

fn amount(value: f64, unit: &Unit, language: Language) -> String {
    let number = if unit.is_below_resolution(value) { "0".to_owned() } else { number_text(value, language) };
    with_symbol(&number, unit.symbol_in(language))
}

fn node(steps: &[Step], index: usize, seen: &mut [bool], language: Language) -> Option<Node> {
    let step = steps.get(index)?;
    let flag = seen.get_mut(index)?;
    let repeated = *flag && !step.operands().is_empty();
    *flag = true;
    let (tree, formula, figures, condition) = match &step.how {
        How::Formula { text, operands } => match Formula::parse(text) {
            Ok(tree) => {
                let (symbols, figures) = written(&tree, operands, steps, language);
                (Some(tree), Some(symbols), Some(figures), None)
            }
            Err(_) => (None, Some(text.clone().into_owned()), None, None),
        },
        How::Found { what, .. } => {
            let tree = what.formula().and_then(|text| Formula::parse(text).ok());
            let condition = tree.is_some().then(|| found_condition(*what, language));
            (tree, Some(found_text(*what, language)), None, condition)
        }
        How::Given => (None, None, None, None),
    };
    let operands = if repeated { &[][..] } else { step.operands() };
    Some(Node {
        symbol: step.symbol.to_owned(),
        term: term(step, language),
        formula,
        figures,
        tree,
        condition,
        value: Number(step.value()),
        unit: step.unit.json,
        source: source_text(&step.source, language),
        page: step.source.page(),
        model: step.source.model(),
        grade: (!is_stated(step)).then_some(Id(step.grade)),
        errata: step.errata.iter().map(|id| cited_erratum(id, language)).collect(),
        operands: operands.iter().filter_map(|index| node(steps, *index, seen, language)).collect(),
        repeated,
    })
}

/// Returns a formula as text in symbols, and with the values inserted.
fn written(formula: &Formula, operands: &[usize], steps: &[Step], language: Language) -> (String, String) {
    let number = |value: f64| number_text(value, language);
    let figure = |name: &str| {
        let step = operands.iter().filter_map(|index| steps.get(*index)).find(|step| step.symbol == name);
        step.map_or_else(
            || symbol_shown(name),
            |step| {
                let text = amount(step.value(), step.unit, language);
                if step.value() < 0.0 && !step.unit.is_below_resolution(step.value()) {
                    format!("({text})")
                } else {
                    text
                }
            },
        )
    };
    (formula.shown(&symbol_shown, &number), formula.shown(&figure, &number))
}

/// Grade in words, for people.
#[must_use]
pub fn trust(node: &Node, language: Language) -> String {
    match node.grade {
        Some(grade) => format!("{}, {}", grade_word(*grade, language), node.source),
        None => node.source.clone(),
    }
}

/// Returns `true` if the user stated the figure.
fn is_stated(step: &Step) -> bool {
    step.how == How::Given && matches!(step.source, Source::Project { .. }) && step.grade == Grade::Printed
}

/// The field's word for a symbol: of a printed cell that of the glossary, which another figure of the same name in a
/// derivation must not take over.
fn term(step: &Step, language: Language) -> String {
    if let Source::Cell(cell) | Source::Published(cell) = &step.source
        && step.how == How::Given
        && cell.symbol.strip_prefix(step.symbol).is_some_and(|rest| matches!(rest, "" | "_brake"))
    {
        return symbol_term(cell.symbol, language);
    }
    match step_term(step.symbol, step.unit.json, language) {
        // What the user gave of an own actuator has the word of the glossary.
        "" => Some(symbol_term(step.symbol, language)).filter(|term| term != step.symbol).unwrap_or_default(),
        term => term.to_owned(),
    }
}
