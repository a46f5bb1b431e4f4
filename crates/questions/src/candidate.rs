//! A judged actuator: its verdict, its governing check, the order and the counts of its checks.

use actuator::Parameters;
use axis::Assumption;
use configurator::{BrokenRule, Product, ProductId, ProductSource, Unmet};
use order_code::Field;
use quantities::Language;
use sizing::{Check, Checks, Fit, Judgement, Standing, Verdict};
use words::{Counts, terminal};

/// Reason against a candidate other than a failing check.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Objection {
    /// A requirement of the project is not met.
    Unmet(Unmet),
    /// With the requested options, the code breaks a rule of the ordering tables.
    Rule(BrokenRule),
}

/// One judged actuator.
#[derive(Clone, Debug)]
pub struct Candidate<'p> {
    /// Identity of the candidate as it is ordered; a code is complete.
    pub id: ProductId,
    /// Product of the catalogue or of the project.
    pub product: &'p Product,
    /// Data of the product.
    pub parameters: &'p Parameters,
    /// Fields of the code that are on request only.
    pub on_request: Vec<Field>,
    /// Every check.
    pub judgement: Judgement,
    /// Reasons against the candidate besides failing checks; each rejects it.
    pub objections: Vec<Objection>,
    /// Requirements that stay open because a datum is missing, and that do not reject the candidate.
    pub open_requirements: Vec<Unmet>,
    /// Criteria of the ranking.
    pub standing: Standing,
    /// `true` if neither the call nor the project names an actuator and the answer is about the best of the ranking.
    pub is_best_of_ranking: bool,
    /// `true` if products of catalogue files compete, so that each is named with its maker.
    pub is_among_makers: bool,
}

impl Candidate<'_> {
    /// Returns `true` if the candidate fits, possibly within the band of an estimate.
    #[must_use]
    pub const fn fits(&self) -> bool {
        self.standing.fit.fits()
    }

    /// Returns the verdict on the candidate.
    #[must_use]
    pub const fn fit(&self) -> Fit {
        self.standing.fit
    }

    /// Returns the text that states how an answer came to this actuator; `None` if one is stated.
    #[must_use]
    pub fn how_named(&self, language: Language) -> Option<String> {
        let text = if self.fits() { terminal::best_of_the_ranking } else { terminal::smallest_excess_of_the_ranking };
        self.is_best_of_ranking.then(|| text(&self.id, language))
    }

    /// Returns `true` if an assumption concerns the candidate: the plate of the manual is that of the series in the program.
    #[must_use]
    pub fn is_concerned_by(&self, assumption: Assumption) -> bool {
        assumption != Assumption::CoolingPlate || self.product.source == ProductSource::Manual
    }

    /// Returns `true` if no check fails, regardless of objections.
    #[must_use]
    pub fn judgement_fits(&self) -> bool {
        self.judgement.fits()
    }

    /// Returns the governing check, see [`Judgement::governing_in`].
    #[must_use]
    pub fn governing(&self) -> Option<&Check> {
        self.judgement.governing_in(self.fit())
    }

    /// Returns the utilisation of the governing check, infinite if its limit is zero or a range; `None` if no check has a
    /// margin, so that there is no utilisation to state.
    #[must_use]
    pub fn utilisation(&self) -> Option<f64> {
        self.judgement.governing().map(|_| self.standing.utilisation)
    }

    /// Returns the checks that could not be made and could reject the actuator: a reserve holds for the others only.
    #[must_use]
    pub fn unmade(&self) -> Vec<&Check> {
        self.not_checked().filter(|check| !check.id.is_recommendation()).collect()
    }

    /// Returns the reason for the rejection: the governing check, else the first objection; `None` if the candidate
    /// fits.
    #[must_use]
    pub fn reason(&self) -> Option<Reason<'_>> {
        if self.fits() {
            return None;
        }
        let by_check = self.judgement.worst_failure().map(Reason::Check);
        by_check.or_else(|| self.objections.first().map(Reason::Objection))
    }

    /// Returns the checks that exceed their limits without failing, within the band of an estimate or beyond a rating of another gear, the
    /// governing one first.
    #[must_use]
    pub fn inside_bands(&self) -> Vec<&Check> {
        by_importance(&self.judgement.checks).into_iter().filter(|check| check.is_inside_band()).collect()
    }

    /// Returns `true` if a check exceeds a rating of another manufacturer's gear, and none the lower edge of an estimate.
    #[must_use]
    pub fn depends_on_ratings_alone(&self) -> bool {
        let inside = self.inside_bands();
        !inside.is_empty() && inside.iter().all(|check| check.is_of_another_gear())
    }

    /// Returns the number of checks by verdict.
    #[must_use]
    pub fn counts(&self) -> Counts {
        let mut counts = Counts::default();
        for check in &self.judgement.checks {
            let of = match check.verdict {
                Verdict::Pass => &mut counts.passed,
                Verdict::Advice => &mut counts.advised,
                Verdict::Fail => &mut counts.failed,
                Verdict::NotChecked if check.is_open() => &mut counts.not_checked,
                Verdict::NotChecked => &mut counts.without_limit,
            };
            *of += 1;
            counts.deciding += usize::from(check.id.can_reject(check.verdict));
        }
        let open = |objection: &&Objection| matches!(objection, Objection::Unmet(unmet) if unmet.is_open());
        let objections_open = self.objections.iter().filter(open).count();
        counts.requirements_open = self.open_requirements.len() + objections_open;
        counts.requirements_not_met = self.objections.len() - objections_open;
        counts
    }

    /// Returns `true` if the candidate counts as fitting though no check that can reject it could be made.
    #[must_use]
    pub fn is_not_evaluated(&self) -> bool {
        self.fits() && self.counts().are_all_open()
    }

    /// Returns the number of open questions: checks without a value, and requirements for which a datum is missing.
    #[must_use]
    pub fn open_questions(&self) -> usize {
        let counts = self.counts();
        counts.not_checked + counts.requirements_open
    }

    /// Returns the verdict of a check with whose colour and sign an answer marks the candidate: a failure also for a load that
    /// nothing holds without power, and a missing datum for a candidate that fits as far as it could be judged.
    #[must_use]
    pub fn marked_as(&self) -> Verdict {
        match self.fit() {
            Fit::DoesNotFit => Verdict::Fail,
            _ if self.leaves_load_unheld() => Verdict::Fail,
            Fit::FitsIfEstimate => Verdict::Advice,
            Fit::Fits if self.open_questions() == 0 => Verdict::Pass,
            Fit::Fits => Verdict::NotChecked,
        }
    }

    /// Returns the missing keys of the project, each with the number of checks that require it; in the order of the
    /// checks.
    #[must_use]
    pub fn keys_to_state(&self) -> Vec<(&'static str, usize)> {
        let mut keys: Vec<(&'static str, usize)> = Vec::new();
        for key in self.not_checked().filter_map(|check| check.missing).filter(|missing| missing.contains('.')) {
            match keys.iter_mut().find(|(known, _)| *known == key) {
                Some((_, count)) => *count += 1,
                None => keys.push((key, 1)),
            }
        }
        keys
    }

    /// Returns `true` if gravity or a tension loads the axis and nothing holds it without power.
    #[must_use]
    pub const fn leaves_load_unheld(&self) -> bool {
        !self.standing.holds
    }

    /// Returns the checks for which a datum is missing.
    pub fn not_checked(&self) -> impl Iterator<Item = &Check> {
        self.judgement.checks.iter().filter(|check| check.is_open())
    }
}

/// Sorts checks into the order of every answer, the governing one before the others of its verdict; see
/// [`Check::importance`].
#[must_use]
pub fn by_importance(checks: &Checks) -> Vec<&Check> {
    let mut sorted: Vec<&Check> = checks.iter().collect();
    sorted.sort_by_cached_key(|check| check.importance());
    let governing = sizing::governing(checks);
    if let Some(place) = governing.and_then(|governing| sorted.iter().position(|check| check.id == governing.id)) {
        let first = sorted.iter().position(|check| governing.is_some_and(|other| other.verdict == check.verdict));
        if let Some(part) = first.and_then(|first| sorted.get_mut(first..=place)) {
            part.rotate_right(1);
        }
    }
    sorted
}

/// Reason for which an actuator is rejected.
#[derive(Clone, Copy, Debug)]
pub enum Reason<'c> {
    /// The governing check.
    Check(&'c Check),
    /// The first objection, if no check fails.
    Objection(&'c Objection),
}

impl Candidate<'_> {
    /// Updates the criteria of the ranking from the judgement.
    pub(crate) fn stand(&mut self) {
        let Standing { size, mass_kg, .. } = self.standing;
        let mass = Some(mass_kg).filter(|mass| mass.is_finite());
        self.standing = Standing::of(&self.judgement, self.objections.is_empty(), size, mass);
    }
}
