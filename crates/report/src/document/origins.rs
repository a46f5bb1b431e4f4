//! Origin of every number, for the full form: derivations and sources.

use super::checks::once;
use super::shown::{Formatter, tied};
use answers::{Explained, Node};
use serde::Serialize;
use words::{capitalised, symbol_shown};

/// A derivation as lines, nested by depth.
#[derive(Serialize)]
pub(super) struct DerivationLines {
    title: String,
    verdict: &'static str,
    sources: Vec<String>,
    grade: &'static str,
    lines: Vec<Line>,
}

/// One formula: in symbols, with figures, its result, and the figures that went in.
#[derive(Serialize)]
struct Line {
    depth: usize,
    label: String,
    term: String,
    formula: String,
    substituted: String,
    result: String,
    source: String,
    grade: &'static str,
    figures: Vec<SourcedNumber>,
}

#[derive(Serialize)]
struct SourcedNumber {
    label: String,
    result: String,
    source: String,
}

/// Depth to which a derivation is printed; a figure below it is printed with its value and source only.
const DEPTH: usize = 2;

pub(super) fn derived(explained: &[Explained], shown: &Formatter) -> Vec<DerivationLines> {
    let derived = explained.iter().map(|each| {
        let mut lines = Vec::new();
        let sides = [&each.derivation.limit, &each.derivation.value].into_iter().flatten();
        let mut open: Vec<(usize, &Node)> = sides.map(|node| (0, node)).collect();
        while let Some((depth, node)) = open.pop() {
            let own_line = |child: &&Node| depth < DEPTH && child.formula.is_some() && !child.repeated;
            let (steps, figures): (Vec<&Node>, Vec<&Node>) = node.operands.iter().partition(own_line);
            let result = shown.figure(node.value, node.unit);
            let substituted = node.figures.as_deref().map(tied).unwrap_or_default();
            lines.push(Line {
                depth,
                label: symbol_shown(&node.symbol),
                term: node.term.clone(),
                formula: node.formula.clone().unwrap_or_default(),
                // A formula that is one figure says with figures what its result says.
                substituted: if equal_but_for_spaces(&substituted, &result) { String::new() } else { substituted },
                result,
                source: node.source.clone(),
                grade: node.grade.map_or("", |grade| shown.grade(*grade)),
                figures: figures
                    .into_iter()
                    .map(|each| SourcedNumber {
                        label: symbol_shown(&each.symbol),
                        result: shown.figure(each.value, each.unit),
                        source: if each.repeated { String::new() } else { each.source.clone() },
                    })
                    .collect(),
            });
            open.extend(steps.into_iter().rev().map(|child| (depth + 1, child)));
        }
        DerivationLines {
            title: capitalised(&each.check.title),
            verdict: each.check.verdict.id(),
            sources: once(&each.check.sources),
            grade: each.check.grade.map_or("", |grade| shown.grade(*grade)),
            lines,
        }
    });
    derived.filter(|each| !each.lines.is_empty()).collect()
}

/// Returns `true` if two texts are equal apart from white space.
fn equal_but_for_spaces(a: &str, b: &str) -> bool {
    a.split_whitespace().flat_map(str::chars).eq(b.split_whitespace().flat_map(str::chars))
}

/// A source and what it served.
#[derive(Serialize)]
pub(super) struct UsedSource {
    text: String,
    used_for: Vec<String>,
}

/// Returns the sources in the order of their first use.
pub(super) fn sources(explained: &[Explained]) -> Vec<UsedSource> {
    let mut found: Vec<UsedSource> = Vec::new();
    let mut enter = |text: &str, title: &str| {
        if text.is_empty() {
            return;
        }
        let place = found.iter().position(|source| source.text == text).unwrap_or_else(|| {
            found.push(UsedSource { text: text.to_owned(), used_for: Vec::new() });
            found.len() - 1
        });
        if let Some(source) = found.get_mut(place).filter(|source| source.used_for.iter().all(|known| known != title)) {
            source.used_for.push(title.to_owned());
        }
    };
    for each in explained {
        let title = capitalised(&each.check.title);
        for text in &each.check.sources {
            enter(text, &title);
        }
        let mut open: Vec<&Node> = [&each.derivation.limit, &each.derivation.value].into_iter().flatten().collect();
        while let Some(node) = open.pop() {
            enter(&node.source, &title);
            open.extend(node.operands.iter().rev());
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spaces_of_any_width_are_alike() {
        assert!(equal_but_for_spaces("5 Nm", "5\u{202f}Nm") && !equal_but_for_spaces("5 Nm", "50 Nm"));
    }
}
