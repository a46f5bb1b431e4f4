//! What a command is about: which axes of the project, which actuator.

use crate::answer::{Answer, written};
use crate::code::parse_for_use;
use crate::fault::{Source, simple};
use crate::waiting::{time_limit, waited_s};
use clap::ArgMatches;
use serde::Serialize;
use std::path::PathBuf;
use workbench::answers::{Answered, Faults};
use workbench::{Candidate, CandidateId, Language, Project, Question, Refusal};

/// The axes of the project, or the one that is asked for, where the answer to a question about them does not take long or
/// somebody has said how long it may take.
pub(crate) fn axes_of(
    question: Question,
    matches: &ArgMatches,
    as_json: bool,
    language: Language,
) -> Result<Vec<Project>, Answer> {
    axes_with_inputs(question, matches, as_json, language).map(|(projects, _)| projects)
}

/// The same with the files that were read for them.
pub(crate) fn axes_with_inputs(
    question: Question,
    matches: &ArgMatches,
    as_json: bool,
    language: Language,
) -> Result<(Vec<Project>, Vec<PathBuf>), Answer> {
    let path = matches.get_one::<PathBuf>("project").cloned().unwrap_or_default();
    let source = Source::read(&path, matches, as_json, language)?;
    let projects = source.projects(as_json, language)?;
    let inputs = source.inputs(&projects);
    let found = picked(projects, matches, as_json, language)?;
    in_reach(question, found.iter().map(|(_, project)| project), as_json, language)?;
    Ok((found.into_iter().map(|(_, project)| project).collect(), inputs))
}

/// The axes, or the one that is asked for, each with its place in the file.
pub(crate) fn picked(
    projects: Vec<Project>,
    matches: &ArgMatches,
    as_json: bool,
    language: Language,
) -> Result<Vec<(usize, Project)>, Answer> {
    let wanted = matches.get_one::<String>("axis").map(String::as_str);
    workbench::picked(projects, wanted, language).map_err(|what| simple(&what, as_json, language))
}

/// The answer about one axis: a record where JSON is asked for, else a text.
pub(crate) struct Part<T> {
    pub(crate) said: Said<T>,
    /// For stderr.
    pub(crate) talk: String,
    pub(crate) fits: bool,
}

/// What is said of an axis.
pub(crate) enum Said<T> {
    Record(T),
    Text(String),
}

impl<T> Part<T> {
    /// The record or the text, whichever is asked for.
    pub(crate) fn of(as_json: bool, fits: bool, record: impl FnOnce() -> T, text: impl FnOnce() -> String) -> Self {
        let said = if as_json { Said::Record(record()) } else { Said::Text(text()) };
        Self { said, talk: String::new(), fits }
    }

    /// With something to tell besides.
    pub(crate) fn with_talk(self, talk: String) -> Self {
        Self { talk, ..self }
    }
}

/// The answers of all axes as one: texts under each other, records in `axes`; one that does not fit decides. Where a
/// question about an axis cannot be answered there is no answer, only the faults of all.
pub(crate) fn together<T: Serialize>(parts: Vec<Result<Part<T>, Answer>>, as_json: bool) -> Answer {
    let (mut records, mut texts, mut refused) = (Vec::new(), Vec::new(), Vec::new());
    let (mut talk, mut fits): (Vec<String>, bool) = (Vec::new(), true);
    for part in parts {
        match part {
            Ok(part) => {
                fits &= part.fits;
                if !part.talk.is_empty() && talk.last() != Some(&part.talk) {
                    talk.push(part.talk);
                }
                match part.said {
                    Said::Record(record) => records.push(record),
                    Said::Text(text) => texts.push(text),
                }
            }
            Err(fault) => refused.push(fault),
        }
    }
    if !refused.is_empty() {
        return refused_together(refused, as_json);
    }
    let data = if as_json { written(&Answered::of(records, fits)) } else { texts.join("\n") };
    Answer { data, talk: talk.concat(), ..Answer::none() }.fits(fits)
}

/// Several faults as one answer, each once.
pub(crate) fn refused_together(refused: Vec<Answer>, as_json: bool) -> Answer {
    let (mut talk, mut faults): (Vec<String>, Vec<Faults>) = (Vec::new(), Vec::new());
    for fault in refused {
        if !talk.contains(&fault.talk) {
            talk.push(fault.talk);
        }
        faults.push(Faults { errors: fault.faults });
    }
    Answer::refused(talk.concat(), Faults::together(faults), as_json)
}

/// The actuator asked for, else the project's own, else the best of the catalogue, which `best` names.
pub(crate) fn candidate<'p>(
    project: &'p Project,
    best: impl FnOnce() -> Option<CandidateId>,
    matches: &ArgMatches,
    as_json: bool,
    language: Language,
) -> Result<(Candidate<'p>, String), Answer> {
    let asked = match matches.try_get_one::<String>("code") {
        Ok(Some(text)) => Some(parse_for_use(text, as_json, language)?),
        _ => None,
    };
    let (code, talk) = asked.map(|(reading, note)| (reading.parsed.code, note)).unzip();
    workbench::candidate_for(project, code.as_ref(), best)
        .map(|candidate| (candidate, talk.unwrap_or_default()))
        .map_err(|refusal| refuse(&refusal, as_json, language))
}

/// Refuses what takes long where nobody has said how long it may take.
pub(crate) fn in_reach<'p>(
    question: Question,
    projects: impl IntoIterator<Item = &'p Project> + Clone,
    as_json: bool,
    language: Language,
) -> Result<(), Answer> {
    if time_limit().is_some() {
        return Ok(());
    }
    question.is_quick(projects).map_err(|refusal| refuse(&refusal, as_json, language))
}

/// Why an actuator cannot be judged.
pub(crate) fn refuse(refusal: &Refusal, as_json: bool, language: Language) -> Answer {
    let what = workbench::answer::refusal_text(refusal, waited_s(), language);
    simple(&what, as_json, language)
}
