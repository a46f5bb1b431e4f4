//! Judgement of an actuator, and ranking of the catalogue.

use crate::{AssumptionEntry, Check, Demand, Fit, Id, Motion, Number, Units};
use schemars::JsonSchema;
use serde::Serialize;
use sizing::CheckId;

/// Maker, series and kind of a product, stated where products of catalogue files compete.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Make {
    /// Maker; `null` if no file states it.
    pub maker: Option<String>,
    /// Series of the maker; `null` if no file states it.
    pub series: Option<String>,
    /// Kind of the product: `actuator`.
    pub kind: &'static str,
    /// Length in mm; `null` if it is not stated.
    pub length_mm: Option<Number>,
    /// Price as written; `null` if it is not stated.
    pub price: Option<String>,
    /// Time of delivery in days; `null` if it is not stated.
    pub lead_time_d: Option<Number>,
}

/// One judged actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Candidate {
    /// Ordering code of an actuator of the catalogue.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub code: Option<String>,
    /// Name of the project's own actuator.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Maker, series and kind, if products of catalogue files compete.
    #[serde(flatten)]
    pub make: Option<Make>,
    /// Verdict on the actuator.
    pub verdict: Fit,
    /// Utilisation of the governing check; 1 is the limit. `null` if it fails at a limit of zero or outside a range.
    pub utilisation: Number,
    /// Id of the governing check: the failing one with the largest excess, else the one with the highest utilisation.
    /// `null` if no check has a limit.
    pub tightest: Option<Id<CheckId>>,
    /// Mass in kg, the larger one if the manual is in doubt.
    pub mass_kg: Option<Number>,
    /// Ids of the errata that touch the mass.
    pub mass_errata: Vec<&'static str>,
    /// Names of the fields of the code that are on request only.
    pub on_request: Vec<String>,
    /// Demand on the actuator; `null` without J_out.
    pub demand: Option<Demand>,
    /// The checks, in a fixed order.
    pub checks: Vec<Check>,
    /// Requirements not met and rules violated, as text.
    pub objections: Vec<String>,
    /// Requirements that stay open because a datum is missing, as text; only where there are some.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub open_requirements: Option<Vec<String>>,
    /// Number of questions that could not be answered because a datum is missing: checks without a value, and open
    /// requirements.
    pub open_questions: usize,
}

impl Candidate {
    /// Returns the ordering code or the name.
    #[must_use]
    pub fn called(&self) -> &str {
        self.code.as_deref().or(self.name.as_deref()).unwrap_or_default()
    }

    /// Returns `true` if it counts as fitting though no check that can reject it could be made.
    #[must_use]
    pub fn is_not_evaluated(&self) -> bool {
        self.verdict != Fit::DoesNotFit && !self.checks.iter().any(|check| check.id.can_reject(*check.verdict))
    }
}

/// `check`: one actuator, every check with its margin.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Judgement {
    /// The actuator.
    #[serde(flatten)]
    pub candidate: Candidate,
    /// Name of the axis.
    pub axis: String,
    /// Motion resulting from the project.
    pub motion: Motion,
    /// Reserves of the actuator.
    pub reserve: Reserve,
    /// Effect of the tolerances of the project; only if it has some.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<Tolerance>,
    /// Assumptions.
    pub assumptions: Vec<AssumptionEntry>,
}

/// Largest change of one quantity, all others unchanged, at which the actuator still fits (or would fit); `null` if
/// nothing within reach fits or everything does. Each value has four digits and is judged as stated: with it no check
/// fails, one step of the last digit further one does. The search proceeds in steps of 10 %, temperatures in steps of 5
/// K; a narrower gap between two regions that fit is not detected.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Reserve {
    /// Values of limits of the project, rounded to four digits on the sufficient side, with which the actuator would
    /// fit, all together; only if nothing but these limits rejects it.
    pub limits: Option<Vec<NeededLimit>>,
    /// Factor on all masses and moments of inertia.
    pub load_factor: Option<Number>,
    /// Factor on the payloads of the segments.
    pub payload_factor: Option<Number>,
    /// Duration of the whole motion, run faster or slower.
    pub cycle_time: Option<Number>,
    /// Highest ambient temperature of those about the present one, or of the nearest ones at which the actuator fits.
    pub ambient: Option<Number>,
    /// Lowest ambient temperature of the same: below it a check fails, or the data of the actuator do not hold.
    pub ambient_least: Option<Number>,
    /// Units of cycle time and ambient temperature.
    pub units: Units,
    /// Names of the fields above whose value fits only if an estimate holds, `fits_if_estimate`.
    pub if_estimate: Vec<&'static str>,
    /// Names of the fields above whose value fits unless a gear rating of another manufacturer applies, `fits_if_estimate`.
    pub unless_rating: Vec<&'static str>,
    /// Checks that could not be made, for which the values do not hold; `null` if all were made that could reject the actuator, or
    /// without a value.
    pub not_checked: Option<ReserveNotChecked>,
    /// Quantities not searched because of the cost; `null` if all were.
    pub not_sought: Option<NotSought>,
}

/// Checks for which the values of a reserve do not hold: they could reject the actuator and could not be made.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ReserveNotChecked {
    /// Checks.
    pub checks: Vec<Id<CheckId>>,
    /// Condition in words.
    pub text: String,
}

/// Quantities not searched: each step of the search would compute the load of a long recording again.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct NotSought {
    /// Names of the neighbouring fields that are `null` for this reason.
    pub quantities: Vec<&'static str>,
    /// Work of each search step: recorded samples whose load is computed again, plus a quarter of the instants of
    /// motion laws and of the loads on the flange.
    pub samples: usize,
    /// Largest work permitted without `--deadline`.
    pub most: usize,
    /// Reason as text.
    pub text: String,
}

/// A limit of the project that would have to be changed.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct NeededLimit {
    /// Key of the limit.
    pub key: String,
    /// Sufficient value.
    pub value: Number,
    /// Unit of the value.
    pub unit: &'static str,
}

/// `size`: judgement of the catalogue for an axis.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Sizing {
    /// Name of the axis.
    pub axis: String,
    /// Verdict on the best actuator, the project's own included.
    pub verdict: Fit,
    /// Best ordering code; `null` if none fits.
    pub answer: Option<String>,
    /// Number of actuators of the catalogue judged.
    pub judged: usize,
    /// Number of actuators that fit within every limit, verdict `fits`.
    pub fit: usize,
    /// Number of actuators among `fit` for which data are missing for every check that can reject them.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub not_evaluated: usize,
    /// Number of further actuators that fit if an estimate holds, verdict `fits_if_estimate`.
    pub fit_if_estimate: usize,
    /// Sum of `fit` and `fit_if_estimate`.
    pub fitting: usize,
    /// Criterion of the ranking, as text.
    pub rule: String,
    /// Best fitting actuators, in the requested number.
    pub ranking: Vec<Ranked>,
    /// Actuators that do not fit, by smallest excess.
    pub rejected: Vec<Rejection>,
    /// Ordering code with the smallest excess among those that do not fit but meet every requirement and are of the
    /// right class of voltage and place; where none fits, the one with the smallest excess that meets every requirement;
    /// where none does, the one that misses the fewest requirements and limits. `null` if there is none.
    pub nearest_miss: Option<String>,
    /// Project's own actuator.
    pub own: Option<Assessed>,
    /// Smallest changes of load and cycle time with which an actuator would fit, one change at a time; only if nothing
    /// fits and the cycle is not too long for the search.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub would_fit_after: Vec<WouldFitAfter>,
    /// Values of the gearing with which an actuator would fit, one change at a time; only if nothing fits.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub would_fit_with: Vec<WouldFit>,
    /// Law of motion in place of the assumed one with which an actuator would fit; only if nothing fits and a law is open.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub would_fit_with_law: Option<WouldFitWithLaw>,
    /// Assumptions.
    pub assumptions: Vec<AssumptionEntry>,
    /// Stage between actuator and mechanism; only if the project has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stage: Option<Stage>,
    /// Motion resulting from the project.
    pub motion: Motion,
}

/// A value with which an actuator would fit.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WouldFit {
    /// Key of the project.
    pub key: String,
    /// `true` if the project states the key; `false` if it would be added.
    pub stated: bool,
    /// Value of three digits nearest to the stated one with which an actuator fits.
    pub value: Number,
    /// Unit of the value; `1` for a ratio.
    pub unit: &'static str,
    /// Best ordering code with this value.
    pub code: String,
    /// Verdict on this code.
    pub verdict: Fit,
    /// `true` if the code fits only if an estimate holds.
    pub if_estimate: bool,
    /// `true` if the code fits unless a gear rating of another manufacturer applies.
    pub unless_rating: bool,
}

/// A change of load or cycle time after which an actuator would fit.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WouldFitAfter {
    /// Changed quantity: `cycle_time`, `payload_factor` or `load_factor`, as in `reserve`.
    pub change: &'static str,
    /// Duration of the cycle, or factor.
    pub value: Number,
    /// Unit of the value; `1` for a factor.
    pub unit: &'static str,
    /// Best ordering code with this value.
    pub code: String,
    /// Verdict on this code.
    pub verdict: Fit,
    /// `true` if the code fits only if an estimate holds.
    pub if_estimate: bool,
    /// `true` if the code fits unless a gear rating of another manufacturer applies.
    pub unless_rating: bool,
}

/// A law of motion with which an actuator would fit.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WouldFitWithLaw {
    /// Law of every move whose law is open, as in project files.
    pub law: &'static str,
    /// Law as text.
    pub title: &'static str,
    /// Keys of these laws.
    pub keys: Vec<String>,
    /// Best ordering code with this law.
    pub code: String,
    /// Verdict on this code.
    pub verdict: Fit,
    /// `true` if the code fits only if an estimate holds.
    pub if_estimate: bool,
    /// `true` if the code fits unless a gear rating of another manufacturer applies.
    pub unless_rating: bool,
}

/// An actuator that fits, with its rank.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Ranked {
    /// Result for the actuator.
    #[serde(flatten)]
    pub of: Assessed,
    /// Rank, from 1.
    pub rank: usize,
}

/// An actuator with the effect of the project's tolerances.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Assessed {
    /// Result for the actuator.
    #[serde(flatten)]
    pub candidate: Candidate,
    /// Effect of the tolerances; only if the project has some.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<Tolerance>,
}

/// Summary of the reasons for a rejection.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Rejection {
    /// Ordering code of the rejected actuator.
    pub code: String,
    /// Maker, series and kind, if products of catalogue files compete.
    #[serde(flatten)]
    pub make: Option<Make>,
    /// Id of the governing check: the failing one with the largest excess; `null` if only objections reject the
    /// actuator.
    pub check: Option<Id<CheckId>>,
    /// Value of that check.
    pub value: Option<Number>,
    /// Limit of that check.
    pub limit: Option<Number>,
    /// Unit of value and limit.
    pub unit: Option<&'static str>,
    /// Utilisation of that check; `null` if the limit is zero or a range.
    pub utilisation: Option<Number>,
    /// Ids of the failing checks, in the order of the checks.
    pub failing: Vec<Id<CheckId>>,
    /// Requirements not met and rules violated, as text.
    pub objections: Vec<String>,
}

/// The stage between actuator and mechanism.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Stage {
    /// Ratio in use.
    pub ratio: Number,
    /// Results for each ratio of the project.
    pub ratios: Vec<StageRatio>,
}

/// Result for a ratio of the stage.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StageRatio {
    /// Ratio of the stage.
    pub ratio: Number,
    /// Best ordering code with this ratio; `null` if none fits.
    pub answer: Option<String>,
    /// Utilisation of the governing check of the best actuator, or of the one with the smallest excess.
    pub utilisation: Number,
    /// Number of actuators that fit, including those that depend on an estimate.
    pub fitting: usize,
}

/// Effect of the project's tolerances on an actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Tolerance {
    /// Number of samples drawn.
    pub samples: usize,
    /// Seed of the random numbers.
    pub seed: u64,
    /// `uniform` in every case.
    pub distribution: &'static str,
    /// Number of samples with which the actuator fits.
    pub passes: usize,
    /// Number of samples among `passes` with which it fits if an estimate holds, `fits_if_estimate`.
    pub passes_if_estimate: usize,
    /// This number as text with the condition; empty for none.
    #[serde(skip)]
    pub condition: String,
    /// Number of samples without a valid axis; none of them passes.
    pub impossible: usize,
    /// Share of the samples that pass.
    pub share: Number,
    /// 95 % interval of the share, lower and upper end.
    pub interval: [Number; 2],
    /// Distribution of the highest utilisation over the samples.
    pub utilisation: Quantiles,
    /// Worst point found.
    pub worst_corner: WorstCorner,
    /// Influence of each quantity on the utilisation, the largest share first; empty if it does not vary.
    pub influence: Vec<Influence>,
}

/// Quantiles of the highest utilisation; `null` for an infinite one.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Quantiles {
    /// 5 % quantile.
    pub p05: Number,
    /// 50 % quantile.
    pub p50: Number,
    /// 95 % quantile.
    pub p95: Number,
    /// Largest value.
    pub max: Number,
}

/// The worst point within the tolerances.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WorstCorner {
    /// Verdict at this point.
    pub verdict: Fit,
    /// Highest utilisation at this point.
    pub utilisation: Number,
    /// Id of the governing check: the failing one with the largest excess, else the one with the highest utilisation.
    pub check: Option<Id<CheckId>>,
    /// Value of each quantity at this point.
    pub values: Vec<ToleratedValue>,
    /// `false`: a sample inside the bands is worse than every corner, and this is the sample.
    pub is_corner: bool,
    /// `true`: every corner was evaluated; `false`: more than ten quantities, the corner was searched.
    pub exhaustive: bool,
}

/// A quantity with a tolerance at some point.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ToleratedValue {
    /// Key of the quantity.
    pub quantity: String,
    /// Value of the quantity.
    pub value: Number,
    /// Unit as written.
    pub unit: &'static str,
}

/// Influence of a quantity on the utilisation.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Influence {
    /// Key of the quantity.
    pub quantity: String,
    /// Share of the explained variance.
    pub share: Number,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "Serde passes a reference")]
const fn is_zero(count: &usize) -> bool {
    *count == 0
}
