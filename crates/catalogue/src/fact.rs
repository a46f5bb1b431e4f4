//! Facts that the manual, or another source, states in prose and not in a table.

use order_code::{Brake, Feedback, OrderCode, Series, Size, Winding};
use provenance::Grade;
use quantities::identified;

/// One statement of a source in our own words, with its figures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fact {
    /// Identifier.
    pub id: &'static str,
    /// Section of the document: `9.4`.
    pub section: &'static str,
    /// Identifier of the document in `data/sources.toml`.
    pub document: &'static str,
    /// Grade of trust.
    pub grade: Grade,
    /// Answers that show it.
    pub topics: &'static [Topic],
    /// Signal word; `None` for a plain statement.
    pub signal: Option<SignalWord>,
    /// Step of the checklist that contains it.
    pub step: Option<LifeStep>,
    /// Codes for which it holds.
    pub holds_for: HoldsFor,
    /// Figures of the statement, in machine form.
    pub values: &'static [FactValue],
    /// English text.
    pub en: &'static str,
    /// German text.
    pub de: &'static str,
}

impl Fact {
    /// Returns `true` if an answer on this topic shows it for this code; safety facts are in every answer.
    #[must_use]
    pub fn is_shown(&self, topic: Topic, code: &OrderCode) -> bool {
        (self.topics.contains(&topic) || self.topics.contains(&Topic::Safety)) && self.holds_for.covers(code)
    }
}

/// Codes for which a fact holds. An empty list and `None` leave the field open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HoldsFor {
    /// Series.
    pub series: Series,
    /// Sizes.
    pub sizes: &'static [Size],
    /// Windings.
    pub windings: &'static [Winding],
    /// Feedback systems.
    pub feedbacks: &'static [Feedback],
    /// `true`: only with a brake; `false`: only without.
    pub brake: Option<bool>,
    /// `true`: only with the encoder at the output (option EC); `false`: only without.
    pub output_encoder: Option<bool>,
    /// `true`: only if the KTY of the winding is led out; `false`: only if it is not.
    pub kty: Option<bool>,
}

impl HoldsFor {
    /// Returns `true` if a code is among them.
    #[must_use]
    pub fn covers(&self, code: &OrderCode) -> bool {
        self.series == code.series()
            && (self.sizes.is_empty() || self.sizes.contains(&code.size))
            && (self.windings.is_empty() || self.windings.contains(&code.winding))
            && (self.feedbacks.is_empty() || self.feedbacks.contains(&code.feedback))
            && self.brake.is_none_or(|brake| brake == (code.brake == Brake::With))
            && self.output_encoder.is_none_or(|encoder| encoder == code.has_output_encoder())
            && self.kty.is_none_or(|kty| kty == crate::series::leads_out_kty(code))
    }
}

/// A figure of a fact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FactValue {
    /// Identifier among the figures of the fact; empty if it is the only one.
    pub id: &'static str,
    /// Value in its unit.
    pub number: f64,
    /// Unit in ASCII; empty for pure numbers.
    pub unit: &'static str,
    /// Kind of bound that the figure states.
    pub bound: Bound,
}

identified! {
    /// Answer that shows a fact.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Topic {
        /// Connectors, pins and cables.
        Wiring = "wiring",
        /// Joints, fits, heat into the machine.
        Mount = "mount",
        /// Parameters of the drive and the first motion.
        Commission = "commission",
        /// Service, storage, disposal.
        Upkeep = "upkeep",
        /// Every answer.
        Safety = "safety",
    }
}

identified! {
    /// Signal words of ISO 3864-2 and ANSI Z535.6, most severe first.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum SignalWord {
        /// Death or serious injury will occur.
        Danger = "danger",
        /// Death or serious injury may occur.
        Warning = "warning",
        /// Minor or moderate injury may occur.
        Caution = "caution",
        /// Damage to property may occur.
        Notice = "notice",
        /// Useful information.
        Info = "info",
    }
}

identified! {
    /// Step in the life of a machine at which a fact matters, in order.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum LifeStep {
        /// Transport and storage.
        Transport = "transport",
        /// Mounting in the machine.
        Mounting = "mounting",
        /// Electrical installation.
        Wiring = "wiring",
        /// Before the power is switched on.
        BeforePower = "before_power",
        /// First motion.
        FirstMotion = "first_motion",
        /// After the first day of operation.
        AfterADay = "after_a_day",
        /// During service.
        InService = "in_service",
        /// Shutdown, and work on a stationary machine.
        Shutdown = "shutdown",
        /// Taking out of service.
        Disposal = "disposal",
    }
}

identified! {
    /// Relation of a value to the figure.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Bound {
        /// Greater than the figure.
        Above = "above",
        /// Less than the figure.
        Below = "below",
        /// The figure or greater.
        AtLeast = "at_least",
        /// The figure or less.
        AtMost = "at_most",
        /// Approximately the figure.
        About = "about",
        /// Equal to the figure.
        Exactly = "exactly",
    }
}
