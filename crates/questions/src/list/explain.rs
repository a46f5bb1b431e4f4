//! `explain PROJECT`: computation of value and limit of the checks of an actuator.

use super::given::{arguments, by_id, some_product_among, text, word};
use super::{AXIS, Argument, ArgumentKind, Cost, Entry, Gives, Reads, Record, argument};
use crate::answer;
pub use crate::explain::derivation;
use crate::progress::Progress;
use crate::sizing_use::{Candidate, Refusal, explained};
use crate::subject::stated_or_best;
use axis::AxisProject;
use configurator::ProductId;
use quantities::Language;
use sizing::{Check, CheckId, StepObserver as _};
use words::check_title;
use words::help;
use words::help::values;

arguments! {
    /// Arguments of `explain`: axis, actuator, check.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
        /// The actuator; without it the project's own.
        code: Option<ProductId> = argument::code(help::explain_code) => some_product_among,
        /// One check; without it all.
        check: Option<CheckId> = Argument::option("check", values::check, help::explain_check)
            .of(ArgumentKind::Word(|| CheckId::ALL.iter().map(|check| check.id()).collect())).titled(check_titles) => word(by_id(CheckId::ALL, CheckId::id)),
    }
}

/// Returns the titles of the checks in every language, as an answer shows them, each with its identifier.
pub(super) fn check_titles() -> Vec<(String, &'static str)> {
    let titles = |language: Language| CheckId::ALL.iter().map(move |check| (check_title(*check, language), check.id()));
    Language::ALL.into_iter().flat_map(titles).collect()
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
    pub fn explanation<'p>(&self, project: &'p AxisProject, progress: &Progress) -> Result<Explanation<'p>, Refusal> {
        explanation(project, self.code.as_ref(), self.check, progress)
    }
}

/// One actuator judged with the workings of its checks.
#[derive(Clone, Debug)]
pub struct Explanation<'p> {
    /// The axis.
    pub project: &'p AxisProject,
    /// The actuator.
    pub candidate: Candidate<'p>,
    /// The requested check; `None` for all.
    wanted: Option<CheckId>,
}

/// Judges one actuator with its workings; without an identity the project's own.
///
/// # Errors
/// The reason why it cannot be judged, [`Refusal::NotAsked`] if the check is not part of the judgement,
/// [`Refusal::Stopped`].
pub fn explanation<'p>(
    project: &'p AxisProject,
    id: Option<&ProductId>,
    wanted: Option<CheckId>,
    progress: &Progress,
) -> Result<Explanation<'p>, Refusal> {
    progress.step()?;
    let candidate = explained(project, stated_or_best(project, id, progress)?);
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
        self.candidate.judgement.checks.iter().filter(asked).collect()
    }

    /// Returns the record of the explanation.
    #[must_use]
    pub fn record(&self, language: Language) -> answers::Explanations {
        answer::explanations(self.project, &self.candidate, &self.checks(), language)
    }
}

#[cfg(test)]
mod tests {
    use super::super::Given;
    use super::*;
    use quantities::Language;

    fn asked(check: &str) -> Result<Option<CheckId>, String> {
        let pairs = [("check".into(), check.to_owned().into())];
        let found = Given::of(Args::ARGUMENTS, pairs, Language::En).and_then(|given| Args::read(&given));
        found.map(|args| args.check).map_err(|why| format!("{:?}", why.faults(None, Language::En).errors))
    }

    /// A check is named by its identifier or by its title in either language, in any case and spacing; another word leads to
    /// the nearest one.
    #[test]
    fn a_check_is_named_by_its_title_too() {
        for id in CheckId::ALL {
            let titles = Language::ALL.map(|language| check_title(*id, language));
            for name in titles.into_iter().chain([id.id().to_owned(), id.id().replace('_', " ")]) {
                for written in [name.clone(), name.to_uppercase(), format!(" {} ", name.replace(' ', "  "))] {
                    assert_eq!(asked(&written), Ok(Some(*id)), "{written:?}");
                }
            }
        }
        for (written, meant) in [("peak_torqe", "peak_torque"), ("Spitzendrehmomet", "peak_torque")] {
            assert!(asked(written).is_err_and(|why| why.contains(meant)), "{written}: {:?}", asked(written));
        }
        assert!(asked("xyz").is_err());
    }
}
