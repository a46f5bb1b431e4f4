//! What a command is about: which axes of the project, which actuator.

use crate::answer::Answer;
use crate::code::parse_for_use;
use crate::fault::{read_projects, simple};
use crate::say::t;
use clap::ArgMatches;
use std::path::PathBuf;
use workbench::{Candidate, CandidateId, Language, Project, Refusal};

/// The axes of the project, or the one that is asked for.
pub(crate) fn axes_of(matches: &ArgMatches, as_json: bool, language: Language) -> Result<Vec<Project>, Answer> {
    let path = matches.get_one::<PathBuf>("project").cloned().unwrap_or_default();
    let projects = read_projects(&path, as_json, language)?;
    let found = picked(projects, matches, as_json, language)?;
    Ok(found.into_iter().map(|(_, project)| project).collect())
}

/// The axes, or the one that is asked for, each with its place in the file.
pub(crate) fn picked(
    projects: Vec<Project>,
    matches: &ArgMatches,
    as_json: bool,
    language: Language,
) -> Result<Vec<(usize, Project)>, Answer> {
    let wanted = matches.get_one::<String>("axis");
    let names: Vec<String> = projects.iter().map(|project| project.name.clone()).collect();
    let mut found: Vec<(usize, Project)> = projects.into_iter().enumerate().collect();
    if let Some(wanted) = wanted {
        found.retain(|(_, project)| project.name == *wanted);
        if found.is_empty() {
            let what = t(
                language,
                &format!("the project has no axis \"{wanted}\"; it has: {}", names.join(", ")),
                &format!("das Projekt hat keine Achse „{wanted}“; es hat: {}", names.join(", ")),
            );
            return Err(simple(&what, as_json, language));
        }
    }
    Ok(found)
}

/// The answers of several axes as one: texts under each other, JSON values in `axes`; one that does not fit decides.
pub(crate) fn together(answers: Vec<Answer>, as_json: bool) -> Answer {
    let mut answers = answers;
    if answers.len() == 1 {
        return answers.remove(0);
    }
    let code = answers.iter().map(|answer| answer.code).max().unwrap_or(0);
    let mut talk: Vec<&str> =
        answers.iter().map(|answer| answer.talk.as_str()).filter(|talk| !talk.is_empty()).collect();
    talk.dedup();
    let talk = talk.concat();
    if as_json {
        let axes: Vec<serde_json::Value> =
            answers.iter().filter_map(|answer| serde_json::from_str(&answer.data).ok()).collect();
        let verdict = if code == 0 { "fits" } else { "does_not_fit" };
        let value = serde_json::json!({ "verdict": verdict, "axes": axes });
        return Answer { data: format!("{value:#}\n"), talk, code };
    }
    let texts: Vec<&str> = answers.iter().map(|answer| answer.data.as_str()).collect();
    Answer { data: texts.join("\n"), talk, code }
}

/// The actuator asked for, else the project's own, else the best of the catalogue, which `best` names.
pub(crate) fn candidate<'p>(
    project: &'p Project,
    best: impl FnOnce() -> Option<CandidateId>,
    matches: &ArgMatches,
    as_json: bool,
    language: Language,
) -> Result<(Candidate<'p>, String), Answer> {
    let refuse = |refusal| refuse(&refusal, as_json, language);
    if let Ok(Some(text)) = matches.try_get_one::<String>("code") {
        let (reading, note) = parse_for_use(text, as_json, language)?;
        return Ok((workbench::check(project, &reading.parsed.code).map_err(refuse)?, note));
    }
    if let Ok(own) = workbench::check_own(project) {
        return Ok((own, String::new()));
    }
    match best() {
        // Ranked by the checks that decide; drawn with all of them.
        Some(CandidateId::Code(code)) => Ok((workbench::check(project, &code).map_err(refuse)?, String::new())),
        _ => Err(refuse(workbench::Refusal::NoData)),
    }
}

/// Why an actuator cannot be judged.
pub(crate) fn refuse(refusal: &Refusal, as_json: bool, language: Language) -> Answer {
    let what = match refusal {
        Refusal::NoActuator => t(
            language,
            "the project has no [actuator]; name one of the catalogue with --code",
            "das Projekt hat keinen [actuator]; einen aus dem Katalog mit --code nennen",
        ),
        _ => t(
            language,
            "the manual prints no data for this code: it is on request only",
            "für diesen Code druckt die Anleitung keine Daten: er ist nur auf Anfrage lieferbar",
        ),
    };
    simple(&what, as_json, language)
}
