//! `explain PROJECT`: computation of value and limit of the checks of an actuator.

use super::given::{arguments, by_id, some_code_among, text, word};
use super::{AXIS, Argument, ArgumentKind, Cost, Entry, Gives, Reads, Record, argument};
use crate::answer;
pub use crate::explain::derivation;
use crate::progress::Progress;
use crate::sizing_use::{Candidate, Refusal, explain, explain_own};
use order_code::OrderCode;
use project::Project;
use quantities::Language;
use sizing::{Check, CheckId, StepObserver as _};
use std::sync::Arc;
use words::help;
use words::help::values;

arguments! {
    /// Arguments of `explain`: axis, actuator, check.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
        /// The actuator; without it the project's own.
        code: Option<OrderCode> = argument::code(help::explain_code) => some_code_among,
        /// One check; without it all.
        check: Option<CheckId> = Argument::option("check", values::check, help::explain_check)
            .of(ArgumentKind::Word(|| CheckId::ALL.iter().map(|check| check.id()).collect())) => word(by_id(CheckId::ALL, CheckId::id)),
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "explain",
    path: "explain",
    about: help::explain,
    reads: Reads::Project,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Answered<answers::Explanations>>("explain")),
    writes: &[],
    example: "axis.toml --code CHA-25A-50-H-C1024 --check continuous_torque",
    answer: Some(|asked| {
        let args = Args::read(&asked.given)?;
        let axes = asked.axes(args.axis.as_deref(), Cost::Other)?;
        asked.record_of_each(&axes, |project| {
            let found = args.explanation(project, asked.progress)?;
            Ok((found.record(asked.language), answer::fit(&found.candidate)))
        })
    }),
};

impl Args {
    /// Judges the actuator with its workings.
    ///
    /// # Errors
    /// As [`explanation`].
    pub fn explanation<'p>(&self, project: &'p Project, progress: &Progress) -> Result<Explanation<'p>, Refusal> {
        explanation(project, self.code.as_ref(), self.check, progress)
    }
}

/// One actuator judged with the workings of its checks.
#[derive(Clone, Debug)]
pub struct Explanation<'p> {
    /// The axis.
    pub project: &'p Project,
    /// The actuator.
    pub candidate: Candidate<'p>,
    /// The requested check; `None` for all.
    wanted: Option<CheckId>,
}

/// Judges one actuator with its workings; without a code the project's own.
///
/// # Errors
/// The reason why it cannot be judged, [`Refusal::NotAsked`] if the check is not part of the judgement,
/// [`Refusal::Stopped`].
pub fn explanation<'p>(
    project: &'p Project,
    code: Option<&OrderCode>,
    wanted: Option<CheckId>,
    progress: &Progress,
) -> Result<Explanation<'p>, Refusal> {
    progress.step()?;
    let candidate = match code {
        Some(code) => explain(project, code)?,
        None => explain_own(project)?,
    };
    let found = Explanation { project, candidate, wanted };
    match wanted {
        Some(id) if found.checks().is_empty() => Err(Refusal::NotAsked(id)),
        _ => Ok(found),
    }
}

impl Explanation<'_> {
    /// Returns the requested checks.
    #[must_use]
    pub fn checks(&self) -> Vec<&Check> {
        let asked = |check: &&Check| self.wanted.is_none_or(|id| check.id == id);
        self.candidate.judgement.checks.iter().map(Arc::as_ref).filter(asked).collect()
    }

    /// Returns the record of the explanation.
    #[must_use]
    pub fn record(&self, language: Language) -> answers::Explanations {
        answer::explanations(self.project, &self.candidate, &self.checks(), language)
    }
}
