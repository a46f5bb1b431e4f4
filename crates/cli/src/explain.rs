//! `explain`: derivation of value and limit of a check.

use crate::answer::CommandAnswer;
use crate::call::Call;
use crate::reserve::assumptions_about;
use crate::table::{hanging, paragraph};
use crate::waiting::progress;
use answers::Node;
use axis::AxisProject;
use quantities::Language;
use questions::list::explain::derivation;
use questions::list::{Cost, Inquiry, Unanswered, explain};
use questions::texts::{margin_share, node_amount, trust, verdict_text};
use questions::{Candidate, Check, Verdict};
use std::fmt::Write as _;
use words::{
    check_meaning, check_missing, erratum_line, note_text, percent_text, symbol_shown, terminal, title_of_check,
};

/// `antrieb explain PROJECT --code CODE [--check ID]`
pub(crate) fn explain(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let args = explain::Args::read(&inquiry.given)?;
    let axes = inquiry.axes(args.axis.as_deref(), Cost::Other)?;
    let found = inquiry.each(&axes, |project| {
        let found = args.explanation(project, progress())?;
        Ok((derivations(project, &found.candidate, &found.checks(), language), found.candidate.fits()))
    })?;
    Ok(CommandAnswer::of_axes(found))
}

fn derivations(project: &AxisProject, candidate: &Candidate<'_>, checks: &[&Check], language: Language) -> String {
    // The reason why an actuator does not fit stands first.
    let (failed, others): (Vec<&Check>, Vec<&Check>) = checks.iter().partition(|check| check.verdict == Verdict::Fail);
    let mut out = String::new();
    for check in failed.into_iter().chain(others) {
        out.push_str(&paragraph("", &format!("{}: {}", candidate.id, heading(check, language))));
        out.push_str(&paragraph("  ", check_meaning(check.id, language)));
        out.push_str(&text(check, language));
        out.push('\n');
    }
    out + &assumptions_about(project, candidate, language)
}

fn heading(check: &Check, language: Language) -> String {
    let mut line = format!("{}, {}", title_of_check(check, language), verdict_text(check, language));
    if let Some(share) = margin_share(check) {
        let share = percent_text(share, language);
        let _ = write!(line, ", {share} %");
    }
    line
}

fn text(check: &Check, language: Language) -> String {
    let found = derivation(check, language);
    let mut out = String::new();
    let (inquiry, given) = (terminal::asked(language), terminal::permitted(language));
    for (word, root) in [(inquiry, &found.value), (given, &found.limit)] {
        if let Some(root) = root {
            let _ = writeln!(out, "  {word}");
            tree(root, "    ", &mut out, language);
        }
    }
    if let Some(missing) = check.missing {
        out.push_str(&paragraph("  ", &check_missing(missing, language)));
    }
    for note in check.notes.iter() {
        out.push_str(&paragraph("  ", &note_text(note, language)));
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
            out.push_str(&paragraph(&format!("{indent}  ! "), &erratum_line(&erratum.id, language)));
        }
    }
    for operand in &node.operands {
        tree(operand, &format!("{indent}    "), out, language);
    }
}
