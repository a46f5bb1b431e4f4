//! `explain`: how value and limit of a check came about.

use crate::answer::Answer;
use crate::code::parse_for_use;
use crate::subject::{Part, axes_of, refuse, together};
use crate::table::{hanging, labelled, paragraph};
use crate::waiting::patience;
use clap::ArgMatches;
use std::fmt::Write as _;
use workbench::answers::Explanations;
use workbench::text::{
    assumption_text, check_missing, check_title, note_text, symbol_shown, terminal, terms, verdict_word,
};
use workbench::{Candidate, Check, CheckId, Language, Node, Project, Question, derivation, node_amount, trust};

/// `antrieb explain PROJECT --code CODE [--check ID]`
pub(crate) fn explain(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let projects = match axes_of(Question::Other, matches, as_json, language) {
        Ok(projects) => projects,
        Err(answer) => return answer,
    };
    let answers = projects.iter().map(|project| axis(project, matches, as_json, language));
    together(answers.collect(), as_json)
}

fn axis(
    project: &Project,
    matches: &ArgMatches,
    as_json: bool,
    language: Language,
) -> Result<Part<Explanations>, Answer> {
    let (code, talk) = match matches.get_one::<String>("code") {
        None => (None, String::new()),
        Some(text) => {
            let (reading, note) = parse_for_use(text, as_json, language)?;
            (Some(reading.parsed.code), note)
        }
    };
    let wanted = matches.get_one::<String>("check").and_then(|id| CheckId::ALL.iter().find(|each| each.id() == id));
    let found = workbench::explanation(project, code.as_ref(), wanted.copied(), patience())
        .map_err(|refusal| refuse(&refusal, as_json, language))?;
    let text = || derivations(project, &found.candidate, &found.checks(), language);
    Ok(Part::of(as_json, found.candidate.fits(), || found.record(language), text).with_talk(talk))
}

fn derivations(project: &Project, candidate: &Candidate<'_>, checks: &[&Check], language: Language) -> String {
    let mut out = String::new();
    for check in checks {
        let _ = writeln!(out, "{}: {}", candidate.id, heading(check, language));
        out.push_str(&text(check, language));
        out.push('\n');
    }
    let head = terms::assumed(language);
    for assumption in &project.assumptions {
        out.push_str(&labelled(head, &assumption_text(*assumption, language)));
    }
    out
}

fn heading(check: &Check, language: Language) -> String {
    let mut line = format!("{}, {}", check_title(check.id, language), verdict_word(check.verdict, language));
    if let Some(share) = check.utilisation {
        let share = workbench::quantities::format_number(share * 100.0, 1, language);
        let _ = write!(line, ", {share} %");
    }
    line
}

fn text(check: &Check, language: Language) -> String {
    let found = derivation(check, language);
    let mut out = String::new();
    let (asked, given) = (terminal::asked(language), terminal::permitted(language));
    for (word, root) in [(asked, &found.value), (given, &found.limit)] {
        if let Some(root) = root {
            let _ = writeln!(out, "  {word}");
            tree(root, "    ", &mut out, language);
        }
    }
    if let Some(missing) = check.missing {
        out.push_str(&paragraph("  ", &check_missing(missing, language)));
    }
    for note in check.notes.iter() {
        let note = note_text(note, language);
        if !note.is_empty() {
            out.push_str(&paragraph("  ", &note));
        }
    }
    out
}

fn tree(node: &Node, indent: &str, out: &mut String, language: Language) {
    let term = if node.term.is_empty() { String::new() } else { format!("  {}", node.term) };
    let trust = if node.repeated { terminal::see_above(language).to_owned() } else { trust(node, language) };
    let line = format!("{} = {}{term}  [{trust}]", symbol_shown(&node.symbol), node_amount(node, language));
    out.push_str(&hanging(indent, &line));
    if !node.repeated {
        for text in [&node.formula, &node.figures].into_iter().flatten() {
            out.push_str(&paragraph(&format!("{indent}  = "), text));
        }
        for erratum in &node.errata {
            out.push_str(&paragraph(&format!("{indent}  ! {}: ", erratum.id), &erratum.evidence));
        }
    }
    for operand in &node.operands {
        tree(operand, &format!("{indent}    "), out, language);
    }
}
