//! One row judged.

use super::Wanted;
use crate::answer::refusal_text;
use crate::sizing_use::{known_si, not_offered, products_of};
use axis::AxisProject;
use configurator::{Product, ProductId, Requirements};
use provenance::Datum;
use quantities::Language;
use sizing::{Axis, CheckId, Depth, Fit, Judgement, Ranked, Scope, Screen, Screening, Standing, Verdict};

/// The answer of a row.
#[derive(Clone, Debug, PartialEq)]
pub enum Judged {
    /// The best code.
    Best(Best),
    /// Every code.
    Every(Vec<Every>),
    /// The codes that no other dominates.
    Front(Vec<OnFront>),
}

/// The best of the codes of a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Best {
    /// Number of codes that fit within every limit.
    pub fit: u32,
    /// Number of further codes that fit if an estimate holds.
    pub fit_if_estimate: u32,
    /// Best of these codes; `None` if none fits. In a row with a code that code, fitting or not.
    pub code: Option<ProductId>,
    /// Utilisation of the governing check; if none fits, that of the actuator with the smallest excess.
    pub utilisation: Option<f64>,
    /// Governing check; if none fits, that of the actuator with the smallest excess, or the check that excludes it if the
    /// place of installation excludes every code.
    pub tightest: Option<CheckId>,
    /// Ratio of the stage chosen among several; `None` if the project does not state several.
    pub stage_ratio: Option<f64>,
}

impl Best {
    /// Returns `true` if a code fits, possibly if an estimate holds.
    #[must_use]
    pub const fn fits(&self) -> bool {
        self.fit > 0 || self.fit_if_estimate > 0
    }
}

/// A code of a row with its checks.
#[derive(Clone, Debug, PartialEq)]
pub struct Every {
    /// The code.
    pub code: ProductId,
    /// Verdict on the code.
    pub fit: Fit,
    /// Utilisation of the governing check.
    pub utilisation: Option<f64>,
    /// Governing check.
    pub tightest: Option<CheckId>,
    /// Ratio of the stage chosen among several; `None` if the project does not state several.
    pub stage_ratio: Option<f64>,
    /// Verdict and utilisation of each requested check; `None` if the axis or the actuator does not have it.
    pub checks: Vec<Option<(Verdict, Option<f64>)>>,
}

/// A fitting code that no other dominates in mass, length and margin.
#[derive(Clone, Debug, PartialEq)]
pub struct OnFront {
    /// The code.
    pub code: ProductId,
    /// Verdict on the code.
    pub fit: Fit,
    /// Mass \[kg\].
    pub mass_kg: Option<f64>,
    /// Length \[m\].
    pub length_m: Option<f64>,
    /// Utilisation of the governing check.
    pub utilisation: f64,
    /// Governing check.
    pub tightest: Option<CheckId>,
    /// Ratio of the stage chosen among several; `None` if the project does not state several.
    pub stage_ratio: Option<f64>,
    /// Ids of the errata of its mass and its length: the figures may not be those of the manual.
    pub errata: [&'static [&'static str]; 2],
}

/// A product to judge, with its properties that are constant for every row of a template.
pub(super) struct Entrant<'p> {
    id: ProductId,
    product: &'p Product,
    /// Size by which it is ranked.
    size: u32,
    /// `true` if it is offered with the required options.
    has_options: bool,
    /// `true` if it breaks a rule with these options.
    is_barred: bool,
}

impl<'p> Entrant<'p> {
    /// Returns every product of the catalogue.
    pub(super) fn all(project: &'p AxisProject) -> Vec<Self> {
        let by_mass = project.catalogue().has_files();
        let of = |product: &'p Product| {
            let ordered = product.with_options(project.option_1, project.option_2);
            Self {
                product,
                size: product.rank_size(by_mass),
                has_options: ordered.is_some(),
                is_barred: ordered.as_ref().is_some_and(|id| id.has_options() && id.availability().is_err()),
                id: ordered.unwrap_or_else(|| product.id.clone()),
            }
        };
        products_of(project).iter().map(of).collect()
    }

    /// Returns the products ranked for many axes.
    pub(super) fn screen(entrants: &[Self]) -> Screen {
        let of = |entrant: &Self| sizing::Entrant {
            parameters: &entrant.product.parameters,
            size: entrant.size,
            mass_kg: entrant.mass_kg().unwrap_or(f64::INFINITY),
        };
        Screen::of(&entrants.iter().map(of).collect::<Vec<_>>())
    }

    fn mass_kg(&self) -> Option<f64> {
        known_si(&self.product.parameters.mass)
    }

    pub(super) fn meets(&self, requirements: &Requirements) -> bool {
        self.has_options && !self.is_barred && requirements.are_met(&self.id, self.product)
    }

    fn standing(&self, judgement: &Judgement, meets: bool) -> Standing {
        Standing::of(judgement, meets, self.size, self.mass_kg())
    }
}

/// The axis of a row.
pub(super) struct RowAxis<'r> {
    pub(super) project: &'r AxisProject,
    pub(super) axis: &'r Axis,
    pub(super) requirements: &'r Requirements,
}

impl<'r> RowAxis<'r> {
    pub(super) const fn of(project: &'r AxisProject) -> Self {
        Self { project, axis: &project.axis, requirements: &project.requirements }
    }

    /// Returns the ratio chosen among several.
    fn stage_ratio(&self) -> Option<f64> {
        (!self.project.ratios.is_empty()).then(|| self.axis.mechanism.stage_ratio())
    }

    /// Returns the best of the catalogue.
    pub(super) fn best(&self, entrants: &[Entrant<'_>], screening: &mut Screening<'_>, meets: &[bool]) -> Best {
        let found = screening.found(self.axis, meets);
        let ranked = found.best.or(found.miss);
        let code = |ranked: Ranked| entrants.get(ranked.entrant).map(|entrant| entrant.id.clone());
        Best {
            fit: u32::try_from(found.fit).unwrap_or(u32::MAX),
            fit_if_estimate: u32::try_from(found.fit_if_estimate).unwrap_or(u32::MAX),
            code: found.best.and_then(code),
            utilisation: ranked.and_then(|ranked| finite(ranked.utilisation)),
            tightest: ranked.and_then(|ranked| ranked.tightest),
            stage_ratio: self.stage_ratio(),
        }
    }

    /// Returns the answer for one product.
    ///
    /// # Errors
    /// If there are no data for it.
    pub(super) fn of_product(&self, id: &ProductId, wanted: &Wanted, language: Language) -> Result<Judged, String> {
        let own = self.project.actuator.as_ref().filter(|own| own.id == *id);
        let found = own.or_else(|| self.project.catalogue().product(id));
        let product =
            found.ok_or_else(|| refusal_text(&not_offered(&**self.project.catalogue(), id), None, language))?;
        let is_barred = id.availability().is_err();
        let size = product.rank_size(self.project.catalogue().has_files());
        let entrant = Entrant { id: id.clone(), product, size, has_options: true, is_barred };
        let alone = std::slice::from_ref(&entrant);
        Ok(match wanted {
            Wanted::Best => Judged::Best(self.single(&entrant)),
            Wanted::Every(checks) => Judged::Every(self.every(alone, checks)),
            Wanted::Front => Judged::Front(self.front(alone)),
        })
    }

    fn single(&self, entrant: &Entrant<'_>) -> Best {
        let judgement = sizing::judge(self.axis, &entrant.product.parameters, Scope::Deciding);
        let fit = entrant.standing(&judgement, entrant.meets(self.requirements)).fit;
        let governing = judgement.governing_in(fit);
        Best {
            fit: u32::from(fit == Fit::Fits),
            fit_if_estimate: u32::from(fit == Fit::FitsIfEstimate),
            code: Some(entrant.id.clone()),
            utilisation: finite(judgement.utilisation()),
            tightest: governing.map(|check| check.id),
            stage_ratio: self.stage_ratio(),
        }
    }

    pub(super) fn every(&self, entrants: &[Entrant<'_>], wanted: &[CheckId]) -> Vec<Every> {
        let mut judge = sizing::Judge::new(self.axis, Scope::All, Depth::Complete);
        let of = |entrant: &Entrant<'_>| {
            let judgement = judge.next(&entrant.product.parameters, &mut |_, _| {});
            let standing = entrant.standing(&judgement, entrant.meets(self.requirements));
            let check = |id: &CheckId| {
                let found = judgement.checks.iter().find(|check| check.id == *id)?;
                Some((found.verdict, found.utilisation.and_then(finite)))
            };
            Every {
                code: entrant.id.clone(),
                fit: standing.fit,
                utilisation: finite(standing.utilisation),
                tightest: judgement.governing_in(standing.fit).map(|check| check.id),
                stage_ratio: self.stage_ratio(),
                checks: wanted.iter().map(check).collect(),
            }
        };
        entrants.iter().filter(|entrant| entrant.has_options).map(of).collect()
    }

    pub(super) fn front(&self, entrants: &[Entrant<'_>]) -> Vec<OnFront> {
        let mut judge = sizing::Judge::new(self.axis, Scope::Deciding, Depth::UntilRejected);
        let of = |entrant: &Entrant<'_>| {
            let judgement = judge.next(&entrant.product.parameters, &mut |_, _| {});
            let standing = entrant.standing(&judgement, entrant.meets(self.requirements));
            standing.fit.fits().then(|| OnFront {
                code: entrant.id.clone(),
                fit: standing.fit,
                mass_kg: entrant.mass_kg(),
                length_m: known_si(&entrant.product.parameters.length),
                utilisation: standing.utilisation,
                tightest: judgement.governing().map(|check| check.id),
                stage_ratio: self.stage_ratio(),
                errata: [errata_of(&entrant.product.parameters.mass), errata_of(&entrant.product.parameters.length)],
            })
        };
        let fitting: Vec<OnFront> = entrants.iter().filter_map(of).collect();
        let beaten = |one: &OnFront| fitting.iter().any(|other| other.beats(one));
        fitting.iter().filter(|one| !beaten(one)).cloned().collect()
    }
}

/// The errata of a datum.
fn errata_of<T>(datum: &Datum<T>) -> &'static [&'static str] {
    datum.known().map_or(&[], |known| known.errata)
}

impl OnFront {
    /// Returns mass, length and utilisation; an unknown value is infinite.
    fn figures(&self) -> [f64; 3] {
        let or_infinite = |figure: Option<f64>| figure.unwrap_or(f64::INFINITY);
        [or_infinite(self.mass_kg), or_infinite(self.length_m), self.utilisation]
    }

    /// Returns `true` if the code dominates another: nowhere worse, and better in at least one figure.
    fn beats(&self, other: &Self) -> bool {
        let pairs = || self.figures().into_iter().zip(other.figures());
        pairs().all(|(own, other)| own <= other) && pairs().any(|(own, other)| own < other)
    }
}

/// Returns a utilisation; `None` if a limit of zero or a range is exceeded.
fn finite(utilisation: f64) -> Option<f64> {
    utilisation.is_finite().then_some(utilisation)
}
