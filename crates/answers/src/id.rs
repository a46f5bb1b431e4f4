//! Words of a fixed set in the form of data exchange.

use catalogue::{Bound, LifeStep, SignalWord};
use installation::wiring::{CableFor, CableRole, Circuit, Role, Severity, SignalGroup};
use order_code::Field;
use provenance::Grade;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};
use sizing::{CheckId, Direction, Part, RunCheckId, Verdict};
use std::borrow::Cow;
use std::ops::Deref;
use twin::{EventEffect, EventKind, Loop, MotionDirection, Reaction, ScenarioId};

/// A type of the engine whose values have an identifier in data exchange.
pub trait Identified: Copy + 'static {
    /// Name of the set in the schema.
    const NAME: &'static str;

    /// The values, in their order.
    const ALL: &'static [Self];

    /// Returns the identifier of a value.
    fn id(self) -> &'static str;
}

/// A value serialised as its identifier; the schema lists the identifiers of its set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Id<T>(pub T);

impl<T> Deref for Id<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.0
    }
}

impl<T: Identified> Serialize for Id<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.0.id())
    }
}

impl<T: Identified> JsonSchema for Id<T> {
    fn schema_name() -> Cow<'static, str> {
        T::NAME.into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let ids: Vec<&str> = T::ALL.iter().map(|each| each.id()).collect();
        json_schema!({ "type": "string", "enum": ids })
    }
}

macro_rules! identified {
    ($($type:ty as $name:literal: $all:expr;)*) => {
        $(impl Identified for $type {
            const NAME: &'static str = $name;
            const ALL: &'static [Self] = $all;

            fn id(self) -> &'static str {
                <$type>::id(self)
            }
        })*
    };
}

identified! {
    CableFor as "CableFor": &CableFor::ALL;
    CableRole as "CableRole": &CableRole::ALL;
    Circuit as "Circuit": &Circuit::ALL;
    SignalGroup as "SignalGroup": &SignalGroup::ALL;
    Role as "ConnectorRole": &Role::ALL;
    Severity as "Severity": &Severity::ALL;
    Bound as "Bound": &Bound::ALL;
    SignalWord as "Signal": &SignalWord::ALL;
    LifeStep as "Step": &LifeStep::ALL;
    CheckId as "CheckId": CheckId::ALL;
    RunCheckId as "RunCheckId": &RunCheckId::ALL;
    EventEffect as "EventEffect": &EventEffect::ALL;
    EventKind as "EventKind": &EventKind::ALL;
    MotionDirection as "MotionDirection": &MotionDirection::ALL;
    Loop as "Loop": &Loop::ALL;
    Reaction as "Reaction": &Reaction::ALL;
    ScenarioId as "ScenarioId": &ScenarioId::ALL;
    Verdict as "Verdict": &Verdict::ALL;
    Direction as "Direction": &Direction::ALL;
    Part as "Part": &Part::ALL;
    Field as "Field": Field::ALL;
    Grade as "Grade": &[Grade::Printed, Grade::Computed, Grade::Published, Grade::Estimated, Grade::Assumed];
}

identified! {
    feedback::Protocol as "EncoderProtocol": &feedback::Protocol::ALL;
    installation::encoder::Assumed as "EncoderAssumed": &installation::encoder::Assumed::ALL;
    installation::fit::Side as "Side": &installation::fit::Side::ALL;
    installation::fit::FitKind as "FitKind": &installation::fit::FitKind::ALL;
    installation::joint::LoadCase as "LoadCase": &installation::joint::LoadCase::ALL;
    installation::upkeep::Task as "Task": &installation::upkeep::Task::ALL;
    installation::upkeep::DateRule as "Rule": &installation::upkeep::DateRule::ALL;
}

/// Verdict on an actuator, or on the best of several; best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Fit {
    /// No check fails, and no requirement or rule is violated.
    Fits,
    /// No check fails, but one exceeds its limit within the band of an estimate, with the verdict `advice`.
    FitsIfEstimate,
    /// A check fails, or a requirement is not met.
    DoesNotFit,
}

impl Fit {
    /// Returns the verdict of a comparison without an estimate.
    #[must_use]
    pub const fn of(fits: bool) -> Self {
        if fits { Self::Fits } else { Self::DoesNotFit }
    }

    /// Returns `true` unless a check fails or a requirement is not met.
    #[must_use]
    pub const fn fits(self) -> bool {
        !matches!(self, Self::DoesNotFit)
    }

    /// Returns the worst of several verdicts.
    #[must_use]
    pub fn of_all(all: impl IntoIterator<Item = Self>) -> Self {
        all.into_iter().max().unwrap_or(Self::Fits)
    }
}

impl From<sizing::Fit> for Fit {
    fn from(fit: sizing::Fit) -> Self {
        match fit {
            sizing::Fit::Fits => Self::Fits,
            sizing::Fit::FitsIfEstimate => Self::FitsIfEstimate,
            sizing::Fit::DoesNotFit => Self::DoesNotFit,
        }
    }
}

/// Availability of an ordering code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Availability {
    /// Available without a request.
    Available,
    /// Available on request only.
    OnRequest,
}

impl Availability {
    /// Returns the availability for an answer.
    #[must_use]
    pub const fn of(available: bool) -> Self {
        if available { Self::Available } else { Self::OnRequest }
    }
}
