//! The questions about an axis, each with everything that belongs to its answer. A face words what was found, or asks for
//! the record.

use crate::answer;
use crate::chapters::bearing_of_each_size;
use crate::compare::compare;
use crate::patience::{Patience, Stopped};
use crate::sizing_use::{
    Candidate, CandidateId, Refusal, Sizing, check, check_own, explain, explain_own, reserve_of_watched, size_watched,
};
use crate::tolerance::{Assessment, Draw, assess_watched};
use order_code::OrderCode;
use project::Project;
use quantities::Language;
use serde::Serialize;
use sizing::{Check, CheckId, Reserve, SAMPLES_ANEW, Watch as _};

/// Of so many candidates of a ranking at most the tolerances are judged.
pub(crate) const ASSESSED_MOST: usize = 10;

/// A question about an axis.
#[derive(Clone, Debug)]
pub enum Request {
    /// Which actuators of the catalogue fit: the best `top` in full, the others in short.
    Size {
        /// How many are told in full.
        top: usize,
        /// How tolerances are sampled.
        draw: Draw,
    },
    /// Whether one actuator fits; without a code the project's own.
    Check {
        /// Which.
        code: Option<OrderCode>,
        /// How tolerances are sampled.
        draw: Draw,
    },
    /// How value and limit of its checks came about, or of one of them.
    Explain {
        /// Which actuator; without a code the project's own.
        code: Option<OrderCode>,
        /// Which check; without it all.
        check: Option<CheckId>,
    },
    /// What several actuators have and need, side by side.
    Compare {
        /// Which.
        codes: Vec<OrderCode>,
    },
    /// What the loads on the flange mean for the output bearing of each size.
    Bearing,
}

/// The record that answers a question.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
#[allow(missing_docs, reason = "each is what its record is")]
pub enum Response {
    Sizing(answers::Sizing),
    Judgement(answers::Judgement),
    Explanations(answers::Explanations),
    Comparison(answers::Comparison),
    Bearings(answers::Bearings),
}

/// Answers a question about an axis, with its texts in a language.
///
/// # Errors
/// Why an actuator cannot be judged.
pub fn ask(project: &Project, request: &Request, language: Language, patience: &Patience) -> Result<Response, Refusal> {
    Ok(match request {
        Request::Size { top, draw } => Response::Sizing(ranking(project, *top, *draw, patience)?.record(language)),
        Request::Check { code, draw } => {
            Response::Judgement(verification(project, code.as_ref(), *draw, patience)?.record(language))
        }
        Request::Explain { code, check } => {
            Response::Explanations(explanation(project, code.as_ref(), *check, patience)?.record(language))
        }
        Request::Compare { codes } => {
            let found = compare(project, codes, patience).map_err(|(_, refusal)| refusal)?;
            Response::Comparison(answer::comparison(&found, &project.name, language))
        }
        Request::Bearing => Response::Bearings(answer::bearings(&bearing_of_each_size(project), language)),
    })
}

/// The catalogue ranked for an axis, with what the tolerances mean for the best.
#[derive(Clone, Debug)]
pub struct Ranking<'p> {
    /// The axis.
    pub project: &'p Project,
    /// Every candidate, best first, and the project's own actuator.
    pub sizing: Sizing<'p>,
    /// How many are told in full.
    pub top: usize,
    /// The tolerances judged for the first of those and for the project's own actuator; empty without tolerances.
    pub assessed: Vec<(CandidateId, Assessment)>,
}

/// Ranks the catalogue for an axis.
///
/// # Errors
/// [`Refusal::TooManySamples`], [`Refusal::Stopped`].
pub fn ranking<'p>(project: &'p Project, top: usize, draw: Draw, patience: &Patience) -> Result<Ranking<'p>, Refusal> {
    let told = top.min(ASSESSED_MOST) + usize::from(project.actuator.is_some());
    let sampling = draw.sampling(project, told, patience.is_limited())?;
    let sizing = sized(project, top, patience)?;
    let fitting = sizing.candidates.iter().filter(|candidate| candidate.fits());
    let chosen: Vec<&Candidate<'_>> = fitting.take(top.min(ASSESSED_MOST)).chain(&sizing.own).collect();
    // Without tolerances there is no assessment, and so no pair.
    let found = assess_watched(project, &chosen, sampling, patience).map_err(|Stopped| Refusal::Stopped)?;
    let assessed = chosen.iter().map(|candidate| candidate.id.clone()).zip(found).collect();
    Ok(Ranking { project, sizing, top, assessed })
}

/// The catalogue judged and ranked for an axis, without its tolerances, for somebody who may stop it. The first `told` are
/// judged by every check where they fit; of the others is left out how much energy comes back, unless a limit is asked for.
///
/// # Errors
/// [`Refusal::Stopped`].
pub fn sized<'p>(project: &'p Project, told: usize, patience: &Patience) -> Result<Sizing<'p>, Refusal> {
    size_watched(project, told, patience).map_err(|Stopped| Refusal::Stopped)
}

impl Ranking<'_> {
    /// The candidates whose tolerances are judged.
    pub fn assessed(&self) -> impl Iterator<Item = (&Candidate<'_>, &Assessment)> {
        let candidates = || self.sizing.candidates.iter().chain(&self.sizing.own);
        self.assessed.iter().filter_map(move |(id, found)| Some((candidates().find(|each| each.id == *id)?, found)))
    }

    /// The record of it.
    #[must_use]
    pub fn record(&self, language: Language) -> answers::Sizing {
        answer::sizing(&self.sizing, self.project, &self.assessed, self.top, language)
    }
}

/// One actuator judged for an axis, with its reserve and what the tolerances mean.
#[derive(Clone, Debug)]
pub struct Verification<'p> {
    /// The axis.
    pub project: &'p Project,
    /// The actuator with every check.
    pub candidate: Candidate<'p>,
    /// How far one thing may be changed.
    pub reserve: Reserve,
    /// What the tolerances mean; `None` without tolerances.
    pub assessment: Option<Assessment>,
}

/// Judges one actuator for an axis; without a code the project's own.
///
/// # Errors
/// Why it cannot be judged.
pub fn verification<'p>(
    project: &'p Project,
    code: Option<&OrderCode>,
    draw: Draw,
    patience: &Patience,
) -> Result<Verification<'p>, Refusal> {
    let candidate = match code {
        Some(code) => check(project, code)?,
        None => check_own(project)?,
    };
    let (reserve, assessment) = margins(project, &candidate, draw, patience)?;
    Ok(Verification { project, candidate, reserve, assessment })
}

/// How far one thing may be changed until a candidate just fits, and what the tolerances mean for it.
///
/// # Errors
/// [`Refusal::TooManySamples`], [`Refusal::Stopped`].
pub fn margins(
    project: &Project,
    candidate: &Candidate<'_>,
    draw: Draw,
    patience: &Patience,
) -> Result<(Reserve, Option<Assessment>), Refusal> {
    // First what may be refused.
    draw.sampling(project, 1, patience.is_limited())?;
    let reserve = reserve_within(project, candidate, patience)?;
    Ok((reserve, scatter(project, candidate, draw, patience)?))
}

/// What the tolerances of a project mean for a candidate; `None` without tolerances.
///
/// # Errors
/// [`Refusal::TooManySamples`], [`Refusal::Stopped`].
pub fn scatter(
    project: &Project,
    candidate: &Candidate<'_>,
    draw: Draw,
    patience: &Patience,
) -> Result<Option<Assessment>, Refusal> {
    let sampling = draw.sampling(project, 1, patience.is_limited())?;
    let assessed = assess_watched(project, &[candidate], sampling, patience).map_err(|Stopped| Refusal::Stopped)?;
    Ok(assessed.into_iter().next())
}

/// How far one thing may be changed until a candidate just fits: whatever it costs for somebody who has said how long it may
/// take, else as far as that is sought unasked.
///
/// # Errors
/// [`Refusal::Stopped`].
pub fn reserve_within(project: &Project, candidate: &Candidate<'_>, patience: &Patience) -> Result<Reserve, Refusal> {
    if !patience.is_limited() {
        return reserve_unasked(project, candidate, patience);
    }
    reserve_of_watched(project, candidate, usize::MAX, patience).map_err(|Stopped| Refusal::Stopped)
}

/// The same as far as it is sought unasked.
///
/// # Errors
/// [`Refusal::Stopped`].
pub fn reserve_unasked(project: &Project, candidate: &Candidate<'_>, patience: &Patience) -> Result<Reserve, Refusal> {
    reserve_of_watched(project, candidate, SAMPLES_ANEW, patience).map_err(|Stopped| Refusal::Stopped)
}

impl Verification<'_> {
    /// The record of it.
    #[must_use]
    pub fn record(&self, language: Language) -> answers::Judgement {
        answer::judgement(self.project, &self.candidate, &self.reserve, self.assessment.as_ref(), language)
    }
}

/// One actuator judged with the workings of its checks.
#[derive(Clone, Debug)]
pub struct Explanation<'p> {
    /// The axis.
    pub project: &'p Project,
    /// The actuator.
    pub candidate: Candidate<'p>,
    /// The check asked for; `None` for all.
    wanted: Option<CheckId>,
}

/// Judges one actuator with its workings; without a code the project's own.
///
/// # Errors
/// Why it cannot be judged, [`Refusal::NotAsked`] where the check is not part of the judgement, [`Refusal::Stopped`].
pub fn explanation<'p>(
    project: &'p Project,
    code: Option<&OrderCode>,
    wanted: Option<CheckId>,
    patience: &Patience,
) -> Result<Explanation<'p>, Refusal> {
    patience.step().map_err(|Stopped| Refusal::Stopped)?;
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
    /// The checks asked for.
    #[must_use]
    pub fn checks(&self) -> Vec<&Check> {
        let asked = |check: &&Check| self.wanted.is_none_or(|id| check.id == id);
        self.candidate.judgement.checks.iter().filter(asked).collect()
    }

    /// The record of it.
    #[must_use]
    pub fn record(&self, language: Language) -> answers::Explanations {
        answer::explanations(self.project, &self.candidate, &self.checks(), language)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::Language;

    const PROJECT: &str = "format = 1\n[load]\ninertia = \"1.3 kg m^2 ± 5 %\"\n[[motion]]\nlaw = \"manual\"\n\
        speed = \"40 1/min\"\naccelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\npause = \"1 s\"\n";

    #[test]
    fn every_question_has_its_record() {
        let project = crate::read(PROJECT).unwrap();
        let draw = Draw { samples: Some(50), seed: 1 };
        let code = order_code::parse("CHA-32A-50-H-C1024").unwrap().code;
        let asked = |request: &Request| ask(&project, request, Language::En, &Patience::endless());
        let Ok(Response::Sizing(sizing)) = asked(&Request::Size { top: 3, draw }) else { panic!() };
        assert_eq!((sizing.judged, sizing.ranking.len()), (276, 3));
        assert!(sizing.ranking.iter().all(|ranked| ranked.of.tolerance.is_some()));
        let Ok(Response::Judgement(judgement)) = asked(&Request::Check { code: Some(code), draw }) else { panic!() };
        assert!(judgement.tolerance.is_some() && judgement.candidate.called() == "CHA-32A-50-H-C1024");
        let one = Request::Explain { code: Some(code), check: Some(CheckId::Thermal) };
        let Ok(Response::Explanations(explained)) = asked(&one) else { panic!() };
        assert_eq!(explained.checks.len(), 1);
        let codes = vec![code, order_code::parse("CHA-40A-50-H-C1024").unwrap().code];
        let Ok(Response::Comparison(found)) = asked(&Request::Compare { codes }) else { panic!() };
        assert_eq!(found.candidates.len(), 2);
        let Ok(Response::Bearings(found)) = asked(&Request::Bearing) else { panic!() };
        assert!(found.sizes.len() > 5);
    }

    #[test]
    fn what_cannot_be_answered_is_refused() {
        let project = crate::read(PROJECT).unwrap();
        let own = Request::Check { code: None, draw: Draw::default() };
        let ask = |project, request: &Request, language| ask(project, request, language, &Patience::endless());
        assert_eq!(ask(&project, &own, Language::De), Err(Refusal::NoActuator));
        let code = order_code::parse("CHA-32A-50-H-C1024").ok().map(|parsed| parsed.code);
        let brake = Request::Explain { code, check: Some(CheckId::BrakeHolding) };
        assert_eq!(ask(&project, &brake, Language::De), Err(Refusal::NotAsked(CheckId::BrakeHolding)));
    }
}
