//! `explain`: how value and limit of a check came about.

use crate::answer::Answer;
use crate::code::parse_for_use;
use crate::fault::error_word;
use crate::subject::{axes_of, refuse, together};
use crate::table::{hanging, paragraph};
use clap::ArgMatches;
use std::fmt::Write as _;
use workbench::text::{assumption_text, check_missing, check_title, note_text, verdict_word};
use workbench::{Check, CheckId, Language, Node, Project, explanation, json, trust};

/// `antrieb explain PROJECT --code CODE [--check ID]`
pub(crate) fn explain(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let projects = match axes_of(matches, as_json, language) {
        Ok(projects) => projects,
        Err(answer) => return answer,
    };
    let answers = projects.iter().map(|project| axis(project, matches, as_json, language));
    together(answers.collect(), as_json)
}

fn axis(project: &Project, matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let mut talk = String::new();
    let judged = match matches.get_one::<String>("code") {
        None => workbench::explain_own(project),
        Some(text) => match parse_for_use(text, as_json, language) {
            Ok((reading, note)) => {
                talk = note;
                workbench::explain(project, &reading.parsed.code)
            }
            Err(answer) => return answer,
        },
    };
    let candidate = match judged {
        Ok(candidate) => candidate,
        Err(refusal) => return refuse(&refusal, as_json, language),
    };
    let wanted = matches.get_one::<String>("check").and_then(|id| CheckId::ALL.iter().find(|each| each.id() == id));
    let checks: Vec<&Check> =
        candidate.judgement.checks.iter().filter(|check| wanted.is_none_or(|id| check.id == *id)).collect();
    if let (Some(id), true) = (wanted, checks.is_empty()) {
        return not_asked(*id, as_json, language);
    }
    let code = u8::from(!candidate.fits());
    if as_json {
        let value = serde_json::json!({
            "axis": project.name,
            "code": candidate.id.to_string(),
            "checks": checks.iter().map(|check| json::explain(check, language)).collect::<Vec<_>>(),
            "assumptions": json::assumptions(&project.assumptions, language),
        });
        return Answer { data: format!("{value:#}\n"), talk, code };
    }
    let mut out = String::new();
    for check in checks {
        let _ = writeln!(out, "{}: {}", candidate.id, heading(check, language));
        out.push_str(&text(check, language));
        out.push('\n');
    }
    let head = if language == Language::De { "angenommen: " } else { "assumed: " };
    for assumption in &project.assumptions {
        out.push_str(&paragraph(head, &assumption_text(*assumption, language)));
    }
    Answer { data: out, talk, code }
}

fn not_asked(id: CheckId, as_json: bool, language: Language) -> Answer {
    let title = check_title(id, language);
    let what = match language {
        Language::En => format!("{title}: this check is not part of this axis and actuator"),
        Language::De => format!("{title}: dieser Nachweis gehört nicht zu dieser Achse und diesem Antrieb"),
    };
    let mut answer = Answer::fault(format!("{}: {what}\n", error_word(language)));
    if as_json {
        answer.data = format!("{:#}\n", serde_json::json!({ "errors": [{ "message": what }] }));
    }
    answer
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
    let found = explanation(check, language);
    let mut out = String::new();
    let (asked, given) = match language {
        Language::En => ("asked", "permitted"),
        Language::De => ("verlangt", "zulässig"),
    };
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
    let trust = if node.is_repeated {
        if language == Language::De { "siehe oben".to_owned() } else { "see above".to_owned() }
    } else {
        trust(node, language)
    };
    out.push_str(&hanging(indent, &format!("{} = {}{term}  [{trust}]", node.shown(), node.amount(language))));
    if !node.is_repeated {
        for text in [&node.formula, &node.figures].into_iter().flatten() {
            out.push_str(&paragraph(&format!("{indent}  = "), text));
        }
        for (id, evidence) in &node.errata {
            out.push_str(&paragraph(&format!("{indent}  ! {id}: "), evidence));
        }
    }
    for operand in &node.operands {
        tree(operand, &format!("{indent}    "), out, language);
    }
}
