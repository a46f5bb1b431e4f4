//! One row judged.

use super::Wanted;
use crate::answer::refusal_text;
use crate::sizing_use::{Refusal, actuators_of, with_options};
use actuator::Parameters;
use configurator::{Requirements, availability};
use order_code::OrderCode;
use project::Project;
use quantities::{Language, Measure};
use sizing::{Axis, Check, CheckId, Depth, Judgement, RankKey, Standing, Verdict};

/// The answer of a row.
#[derive(Clone, Debug, PartialEq)]
pub enum Judged {
    /// The best code.
    Best(Best),
    /// Every code.
    Every(Vec<Every>),
    /// The codes that no other beats.
    Front(Vec<OnFront>),
}

/// The best of the codes of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Best {
    /// How many codes fit.
    pub fit: u32,
    /// The best of them; `None` where none fits.
    pub code: Option<OrderCode>,
    /// Its largest utilisation; where none fits that of the nearest miss.
    pub utilisation: Option<f64>,
    /// The check with it; where none fits the one by which the nearest misses most.
    pub tightest: Option<CheckId>,
}

/// A code of a row with its checks.
#[derive(Clone, Debug, PartialEq)]
pub struct Every {
    /// The code.
    pub code: OrderCode,
    /// Whether nothing speaks against it.
    pub fits: bool,
    /// Its largest utilisation.
    pub utilisation: Option<f64>,
    /// The check that is exceeded most, else the tightest.
    pub tightest: Option<CheckId>,
    /// Verdict and utilisation of each requested check; `None` where the axis or the actuator does not have it.
    pub checks: Vec<Option<(Verdict, Option<f64>)>>,
}

/// A code that fits and that no other beats in mass, length and margin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnFront {
    /// The code.
    pub code: OrderCode,
    /// Mass \[kg\].
    pub mass_kg: Option<f64>,
    /// Length \[m\].
    pub length_m: Option<f64>,
    /// Its largest utilisation.
    pub utilisation: f64,
    /// The check with it.
    pub tightest: Option<CheckId>,
}

/// An actuator that is judged, with what holds of it for every row of a template.
pub(super) struct Entrant<'p> {
    code: OrderCode,
    parameters: &'p Parameters,
    /// Whether its code breaks a rule with the required options.
    is_barred: bool,
}

impl<'p> Entrant<'p> {
    pub(super) fn all(project: &'p Project) -> Vec<Self> {
        let known = actuators_of(project, project.option_1.is_some()).iter();
        let of = |(code, parameters): &'p (OrderCode, Parameters)| {
            let code = with_options(project, code)?;
            let optional = code.option_1.is_some() || code.option_2.is_some();
            Some(Self { code, parameters, is_barred: optional && availability(&code).is_err() })
        };
        known.filter_map(of).collect()
    }

    fn meets(&self, requirements: &Requirements) -> bool {
        !self.is_barred && requirements.unmet(&self.code, self.parameters).next().is_none()
    }

    fn standing(&self, judgement: &Judgement, meets: bool) -> Standing {
        let mass = self.parameters.mass.known().map(|mass| mass.value.si());
        Standing::of(judgement, meets, self.code.size.number(), mass)
    }
}

/// The axis of a row.
pub(super) struct Row<'r> {
    pub(super) project: &'r Project,
    pub(super) axis: &'r Axis,
    pub(super) requirements: &'r Requirements,
}

impl<'r> Row<'r> {
    pub(super) const fn of(project: &'r Project) -> Self {
        Self { project, axis: &project.axis, requirements: &project.requirements }
    }

    /// The answer: of one code, or of the catalogue.
    pub(super) fn judged(
        &self,
        entrants: &[Entrant<'_>],
        code: Option<&OrderCode>,
        wanted: &Wanted,
        language: Language,
    ) -> Result<Judged, String> {
        let single;
        let (entrants, depth) = match code {
            None => (entrants, Depth::Rank),
            Some(code) => {
                let no_data = || refusal_text(&Refusal::NoData, None, language);
                let bare = OrderCode { option_1: None, option_2: None, special: false, ..*code };
                let mut known = actuators_of(self.project, code.has_output_encoder()).iter();
                let (_, parameters) = known.find(|(known, _)| *known == bare).ok_or_else(no_data)?;
                single = [Entrant { code: *code, parameters, is_barred: availability(code).is_err() }];
                (&single[..], Depth::Margins)
            }
        };
        Ok(match wanted {
            Wanted::Best => Judged::Best(self.best(entrants, depth)),
            Wanted::Every(checks) => Judged::Every(self.every(entrants, checks)),
            Wanted::Front => Judged::Front(self.front(entrants, depth)),
        })
    }

    fn best(&self, entrants: &[Entrant<'_>], depth: Depth) -> Best {
        let mut judge = sizing::Judge::of(self.axis, depth);
        let mut fit = 0;
        let mut best: Option<(RankKey, OrderCode, Judgement)> = None;
        let mut miss: Option<(RankKey, Judgement)> = None;
        for entrant in entrants {
            let judgement = judge.next(entrant.parameters, &mut |_, _| {});
            let meets = entrant.meets(self.requirements);
            let standing = entrant.standing(&judgement, meets);
            let key = RankKey::of(&standing);
            if standing.fits {
                fit += 1;
                if best.as_ref().is_none_or(|(other, ..)| key < *other) {
                    best = Some((key, entrant.code, judgement));
                }
            } else if meets && !is_of_another_place(&judgement) && miss.as_ref().is_none_or(|(other, _)| key < *other) {
                miss = Some((key, judgement));
            }
        }
        match (best, miss) {
            (Some((_, code, judgement)), _) => Best {
                fit,
                code: Some(code),
                utilisation: finite(judgement.utilisation()),
                tightest: judgement.tightest().map(|check| check.id),
            },
            (None, Some((_, judgement))) => Best {
                fit,
                code: None,
                utilisation: finite(judgement.utilisation()),
                tightest: judgement.worst_failure().map(|check| check.id),
            },
            (None, None) => Best { fit, code: None, utilisation: None, tightest: None },
        }
    }

    fn every(&self, entrants: &[Entrant<'_>], wanted: &[CheckId]) -> Vec<Every> {
        let mut judge = sizing::Judge::of(self.axis, Depth::Full);
        let of = |entrant: &Entrant<'_>| {
            let judgement = judge.next(entrant.parameters, &mut |_, _| {});
            let standing = entrant.standing(&judgement, entrant.meets(self.requirements));
            let check = |id: &CheckId| {
                let found = judgement.checks.iter().find(|check| check.id == *id)?;
                Some((found.verdict, found.utilisation.and_then(finite)))
            };
            Every {
                code: entrant.code,
                fits: standing.fits,
                utilisation: finite(standing.utilisation),
                tightest: judgement.worst_failure().or_else(|| judgement.tightest()).map(|check| check.id),
                checks: wanted.iter().map(check).collect(),
            }
        };
        entrants.iter().map(of).collect()
    }

    fn front(&self, entrants: &[Entrant<'_>], depth: Depth) -> Vec<OnFront> {
        let mut judge = sizing::Judge::of(self.axis, depth);
        let of = |entrant: &Entrant<'_>| {
            let judgement = judge.next(entrant.parameters, &mut |_, _| {});
            let standing = entrant.standing(&judgement, entrant.meets(self.requirements));
            standing.fits.then(|| OnFront {
                code: entrant.code,
                mass_kg: entrant.parameters.mass.known().map(|mass| mass.value.si()),
                length_m: entrant.parameters.length.known().map(|length| length.value.si()),
                utilisation: standing.utilisation,
                tightest: judgement.tightest().map(|check| check.id),
            })
        };
        let fitting: Vec<OnFront> = entrants.iter().filter_map(of).collect();
        let beaten = |one: &OnFront| fitting.iter().any(|other| other.beats(one));
        fitting.iter().filter(|one| !beaten(one)).copied().collect()
    }
}

impl OnFront {
    /// What is not known counts as infinite.
    fn figures(&self) -> [f64; 3] {
        let or_infinite = |figure: Option<f64>| figure.unwrap_or(f64::INFINITY);
        [or_infinite(self.mass_kg), or_infinite(self.length_m), self.utilisation]
    }

    /// Whether it is nowhere worse than another and somewhere better.
    fn beats(&self, other: &Self) -> bool {
        let pairs = || self.figures().into_iter().zip(other.figures());
        pairs().all(|(own, other)| own <= other) && pairs().any(|(own, other)| own < other)
    }
}

/// Whether it fails where neither load nor pace matter, such as a voltage: then it is no near miss.
fn is_of_another_place(judgement: &Judgement) -> bool {
    let fails = |check: &Check| check.verdict == Verdict::Fail && check.id.is_of_the_place();
    judgement.checks.iter().any(fails)
}

/// A utilisation; `None` where a limit of zero is exceeded.
fn finite(utilisation: f64) -> Option<f64> {
    utilisation.is_finite().then_some(utilisation)
}
