//! Judgement of an actuator, and ranking of the catalogue.

use crate::{Check, Demand, Fit, Id, Motion, Number, Units};
use schemars::JsonSchema;
use serde::Serialize;
use sizing::CheckId;

/// One judged actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Candidate {
    /// Ordering code, of an actuator of the catalogue.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub code: Option<String>,
    /// Name, of the project's own actuator.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The verdict on it.
    pub verdict: Fit,
    /// Utilisation of the governing check; 1 is the limit. `null` where it fails at a limit of zero or outside a range.
    pub utilisation: Number,
    /// Id of the governing check: the failing one that is exceeded most; where none fails, the one with the highest utilisation.
    /// `null` if no check has a limit.
    pub tightest: Option<Id<CheckId>>,
    /// Mass in kg, the larger one where the print is in doubt.
    pub mass_kg: Option<Number>,
    /// Names of the fields of the code that are on request only.
    pub on_request: Vec<String>,
    /// Demand on the actuator; `null` without J_out.
    pub demand: Option<Demand>,
    /// Every check, in a fixed order.
    pub checks: Vec<Check>,
    /// Requirements not met and rules broken, in words.
    pub objections: Vec<String>,
    /// How many questions could not be answered for want of a datum: checks without a value, and requirements left open.
    pub open_questions: usize,
}

impl Candidate {
    /// Returns the ordering code or the name.
    #[must_use]
    pub fn called(&self) -> &str {
        self.code.as_deref().or(self.name.as_deref()).unwrap_or_default()
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
    /// The motion as it came out.
    pub motion: Motion,
    /// How far one thing may be changed.
    pub reserve: Reserve,
    /// What the tolerances of the project mean; only where it has some.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<Tolerance>,
    /// What was assumed, in words.
    pub assumptions: Vec<String>,
}

/// How far one thing may be changed, all others as they are, with the actuator still fitting (or with which it would fit);
/// `null` where nothing within reach fits or everything does. Each value has four digits and is judged as it stands: with it no
/// check fails, one step of the last digit further one does. The search walks in steps of 10 %, temperatures in steps of 5 K; a
/// gap between two regions that fit is passed over where it is narrower.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Reserve {
    /// Only limits of the project keep the actuator out, and these values of their keys, rounded to four digits on the side
    /// that suffices, all together would let it in.
    pub limits: Option<Vec<NeededLimit>>,
    /// On all masses and inertias.
    pub load_factor: Option<Number>,
    /// On the payloads of the segments.
    pub payload_factor: Option<Number>,
    /// The whole motion run through faster or slower.
    pub cycle_time: Option<Number>,
    /// The ambient temperature.
    pub ambient: Option<Number>,
    /// Units of the latter two.
    pub units: Units,
    /// The fields above with whose value it fits only if an estimate holds, `fits_if_estimate`.
    pub if_estimate: Vec<&'static str>,
    /// What was not sought because of what it costs; `null` where everything was.
    pub not_sought: Option<NotSought>,
}

/// Changes that were not sought: each step of the search would find the load of a long recording anew.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct NotSought {
    /// The fields beside this one that are `null` for it.
    pub quantities: Vec<&'static str>,
    /// Work of each search step: recorded samples whose load is found anew, with a quarter of the instants of motion laws and of the
    /// loads on the flange.
    pub samples: usize,
    /// Largest such work without `--deadline`.
    pub most: usize,
    /// The same in words.
    pub text: String,
}

/// A limit of the project that would have to be another.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct NeededLimit {
    /// Its key.
    pub key: String,
    /// The value that suffices.
    pub value: Number,
    /// Its unit.
    pub unit: &'static str,
}

/// `size`: the catalogue judged for an axis.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Sizing {
    /// Name of the axis.
    pub axis: String,
    /// The verdict on the best, the project's own included.
    pub verdict: Fit,
    /// The best ordering code; `null` if none fits.
    pub answer: Option<String>,
    /// How many actuators of the catalogue were judged.
    pub judged: usize,
    /// How many of them fit within every limit, verdict `fits`.
    pub fit: usize,
    /// How many others fit if an estimate holds, verdict `fits_if_estimate`.
    pub fit_if_estimate: usize,
    /// The sum of both.
    pub fitting: usize,
    /// What the ranking goes by, in words.
    pub rule: String,
    /// The best that fit, in the requested number.
    pub ranking: Vec<Ranked>,
    /// Those that do not fit, by what they miss by.
    pub rejected: Vec<Rejection>,
    /// Of those that do not fit the one that misses by least, among those that meet every requirement and are of the right class of
    /// voltage and place; `null` where there is none.
    pub nearest_miss: Option<String>,
    /// The project's own actuator.
    pub own: Option<Assessed>,
    /// Where nothing fits: values of the gearing with which an actuator would, one change at a time.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub would_fit_with: Vec<WouldFit>,
    /// What was assumed, in words.
    pub assumptions: Vec<String>,
    /// The stage between actuator and mechanism; only where the project has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stage: Option<Stage>,
    /// The motion as it came out.
    pub motion: Motion,
}

/// A value with which an actuator would fit.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WouldFit {
    /// The key of the project.
    pub key: String,
    /// Whether the project states it; else it would be added.
    pub stated: bool,
    /// The value of three digits nearest to the stated one with which an actuator fits.
    pub value: Number,
    /// Its unit; `1` for a ratio.
    pub unit: &'static str,
    /// The best ordering code with it.
    pub code: String,
    /// The verdict on it.
    pub verdict: Fit,
}

/// An actuator that fits, with its place.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Ranked {
    /// The actuator.
    #[serde(flatten)]
    pub of: Assessed,
    /// Its place, from 1.
    pub rank: usize,
}

/// An actuator with what the tolerances of the project mean for it.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Assessed {
    /// The actuator.
    #[serde(flatten)]
    pub candidate: Candidate,
    /// What the tolerances mean; only where the project has some.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<Tolerance>,
}

/// Why a candidate is rejected, in short.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Rejection {
    /// Its ordering code.
    pub code: String,
    /// Id of the governing check: the failing one that is exceeded most; `null` where only objections speak against it.
    pub check: Option<Id<CheckId>>,
    /// Value of that check.
    pub value: Option<Number>,
    /// Its limit.
    pub limit: Option<Number>,
    /// Unit of both.
    pub unit: Option<&'static str>,
    /// Its utilisation; `null` where the limit is zero or a range.
    pub utilisation: Option<Number>,
    /// Ids of all failing checks, in the order of the checks.
    pub failing: Vec<Id<CheckId>>,
    /// Requirements not met and rules broken, in words.
    pub objections: Vec<String>,
}

/// The stage between actuator and mechanism.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Stage {
    /// Its ratio.
    pub ratio: Number,
    /// What each ratio of the project would give.
    pub ratios: Vec<StageRatio>,
}

/// What a ratio of the stage would give.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StageRatio {
    /// The ratio.
    pub ratio: Number,
    /// The best ordering code with it; `null` if none fits.
    pub answer: Option<String>,
    /// Utilisation of the governing check of the best, or of the nearest miss.
    pub utilisation: Number,
    /// How many fit, if only by an estimate.
    pub fitting: usize,
}

/// What the tolerances of the project mean for an actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Tolerance {
    /// How many samples were drawn.
    pub samples: usize,
    /// With which seed.
    pub seed: u64,
    /// Always `uniform`.
    pub distribution: &'static str,
    /// Samples with which nothing speaks against the actuator.
    pub passes: usize,
    /// Samples with which there is no axis; none of them passes.
    pub impossible: usize,
    /// Share of the samples that pass.
    pub share: Number,
    /// Its 95 % interval, low and high.
    pub interval: [Number; 2],
    /// The highest utilisation over the samples.
    pub utilisation: Quantiles,
    /// The worst that was found.
    pub worst_corner: WorstCorner,
    /// What the utilisation hangs on, the largest share first; empty where it does not vary.
    pub influence: Vec<Influence>,
}

/// Quantiles of the highest utilisation; `null` where it is infinite.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Quantiles {
    /// 5 %.
    pub p05: Number,
    /// 50 %.
    pub p50: Number,
    /// 95 %.
    pub p95: Number,
    /// The largest.
    pub max: Number,
}

/// The worst point within the tolerances.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WorstCorner {
    /// Whether the actuator fits there.
    pub verdict: Fit,
    /// Its highest utilisation there.
    pub utilisation: Number,
    /// The failing check that is exceeded most, else the tightest.
    pub check: Option<Id<CheckId>>,
    /// The value of each quantity there.
    pub values: Vec<ToleratedValue>,
    /// `false`: a sample inside the bands is worse than every corner, and this is the sample.
    pub is_corner: bool,
    /// `true`: every corner was looked at; `false`: more than ten quantities, the corner was searched.
    pub exhaustive: bool,
}

/// A quantity with a tolerance at some point.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ToleratedValue {
    /// Its key.
    pub quantity: String,
    /// Its value.
    pub value: Number,
    /// The unit, as written.
    pub unit: &'static str,
}

/// How much a quantity moves the utilisation.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Influence {
    /// Its key.
    pub quantity: String,
    /// Share of the explained variance.
    pub share: Number,
}
