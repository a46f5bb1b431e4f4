//! Where every number is from: derivations in short, sources, errata.

use super::checks::{Titles, capital, parts_of_source};
use super::shown::Shown;
use crate::data::{Derivation, Erratum, Judged, Node, Titled};
use serde::Serialize;

/// A derivation as lines; depth tells what belongs to what.
#[derive(Serialize)]
pub(super) struct Derived {
    check: String,
    title: String,
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
    grade: String,
    figures: Vec<Figure>,
}

#[derive(Serialize)]
struct Figure {
    label: String,
    result: String,
    source: String,
}

/// How deep a derivation goes in print; below it a figure stands with its value and source.
const DEPTH: usize = 2;

pub(super) fn derived(derivations: &[Derivation], shown: &Shown) -> Vec<Derived> {
    derivations
        .iter()
        .map(|derivation| {
            let mut lines = Vec::new();
            let mut open: Vec<(usize, &Node)> = derivation.nodes.iter().rev().map(|node| (0, node)).collect();
            while let Some((depth, node)) = open.pop() {
                let own_line = |child: &&Node| depth < DEPTH && !child.formula.is_empty() && !child.repeated;
                let (steps, figures): (Vec<&Node>, Vec<&Node>) = node.children.iter().partition(own_line);
                let result = result_of(node, shown);
                lines.push(Line {
                    depth,
                    label: greek(&node.label),
                    term: node.term.clone(),
                    formula: greek(&node.formula),
                    // A formula that is one figure says with figures what its result says.
                    substituted: if alike(&node.substituted, &result) {
                        String::new()
                    } else {
                        node.substituted.clone()
                    },
                    result,
                    source: node.source.clone(),
                    grade: node.grade.clone(),
                    figures: figures
                        .into_iter()
                        .map(|each| Figure {
                            label: greek(&each.label),
                            result: result_of(each, shown),
                            source: if each.repeated { String::new() } else { each.source.clone() },
                        })
                        .collect(),
                });
                open.extend(steps.into_iter().rev().map(|child| (depth + 1, child)));
            }
            Derived { check: derivation.check.clone(), title: derivation.title.clone(), lines }
        })
        .collect()
}

fn result_of(node: &Node, shown: &Shown) -> String {
    node.value.map(|value| shown.figure(value, &node.unit)).unwrap_or_default()
}

/// Whether two texts differ in their spaces at most.
fn alike(a: &str, b: &str) -> bool {
    a.split_whitespace().flat_map(str::chars).eq(b.split_whitespace().flat_map(str::chars))
}

/// Greek letters written out, as in files, become letters.
fn greek(text: &str) -> String {
    const LETTERS: [(&str, &str); 14] = [
        ("alpha", "α"),
        ("beta", "β"),
        ("gamma", "γ"),
        ("delta", "δ"),
        ("epsilon", "ε"),
        ("eta", "η"),
        ("theta", "θ"),
        ("mu", "μ"),
        ("rho", "ρ"),
        ("sigma", "σ"),
        ("tau", "τ"),
        ("phi", "φ"),
        ("psi", "ψ"),
        ("omega", "ω"),
    ];
    let mut shown = String::with_capacity(text.len());
    for piece in text.split_inclusive(|sign: char| !sign.is_alphabetic()) {
        let word = piece.trim_end_matches(|sign: char| !sign.is_alphabetic());
        let rest = piece.strip_prefix(word).unwrap_or_default();
        // An index keeps its letters: only what stands at the head of a symbol is one.
        let head = !shown.ends_with('_');
        let letter = LETTERS.iter().find(|(name, _)| head && *name == word).map_or(word, |(_, letter)| letter);
        shown.push_str(letter);
        shown.push_str(rest);
    }
    shown
}

fn title_of(derivation: &Derivation, titles: &Titles) -> String {
    if derivation.title.is_empty() { titles.of(&derivation.check) } else { derivation.title.clone() }
}

/// A source and what it served.
#[derive(Serialize)]
pub(super) struct Source {
    text: String,
    used_for: Vec<String>,
}

/// Every source in the order of its first use, those listed without use at the end.
pub(super) fn sources(judged: &Judged, derivations: &[Derivation], listed: &[Titled], titles: &Titles) -> Vec<Source> {
    let mut found: Vec<Source> = Vec::new();
    let mut enter = |text: String, use_for: Option<String>| {
        let place = found.iter().position(|source| source.text == text).unwrap_or_else(|| {
            found.push(Source { text, used_for: Vec::new() });
            found.len() - 1
        });
        if let (Some(source), Some(title)) = (found.get_mut(place), use_for)
            && !source.used_for.contains(&title)
        {
            source.used_for.push(title);
        }
    };
    for check in &judged.checks {
        for text in parts_of_source(&check.source) {
            enter(text, Some(capital(&check.title)));
        }
    }
    for derivation in derivations {
        let mut open: Vec<&Node> = derivation.nodes.iter().rev().collect();
        let title = capital(&title_of(derivation, titles));
        while let Some(node) = open.pop() {
            for text in parts_of_source(&node.source) {
                enter(text, Some(title.clone()));
            }
            open.extend(node.children.iter().rev());
        }
    }
    for source in listed {
        let text = if source.title.is_empty() { source.id.clone() } else { format!("{}: {}", source.id, source.title) };
        enter(text, None);
    }
    found
}

/// Every erratum that a remark or a derivation cites, beside those given.
pub(super) fn errata(
    judged: &Judged,
    derivations: &[Derivation],
    given: Vec<Erratum>,
    titles: &Titles,
) -> Vec<Erratum> {
    let mut errata = given;
    for derivation in derivations {
        let mut open: Vec<&Node> = derivation.nodes.iter().rev().collect();
        while let Some(node) = open.pop() {
            for each in &node.errata {
                if !errata.iter().any(|known| known.id == each.id) {
                    let source = capital(&title_of(derivation, titles));
                    errata.push(Erratum { id: each.id.clone(), text: each.evidence.clone(), source });
                }
            }
            open.extend(node.children.iter().rev());
        }
    }
    for check in &judged.checks {
        for note in &check.notes {
            let Some((head, text)) = note.split_once(": ") else { continue };
            let Some((word, id)) = head.split_once(' ') else { continue };
            if !word.eq_ignore_ascii_case("erratum") || errata.iter().any(|known| known.id == id) {
                continue;
            }
            errata.push(Erratum { id: id.to_owned(), text: text.to_owned(), source: capital(&check.title) });
        }
    }
    errata
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_letter_written_out_is_shown_as_letter_but_not_within_a_word_or_an_index() {
        assert_eq!(greek("alpha_rms"), "α_rms");
        assert_eq!(greek("2 · rho · alpha_rms"), "2 · ρ · α_rms");
        assert_eq!(greek("metal tau_e k_tau"), "metal τ_e k_tau");
        assert_eq!(greek(""), "");
    }

    #[test]
    fn spaces_of_any_width_are_alike() {
        assert!(alike("5 Nm", "5\u{202f}Nm") && !alike("5 Nm", "50 Nm"));
    }
}
