//! Facts that the manual, or another source, states in prose and not in a table.

use order_code::{Brake, Feedback, OrderCode, Series, Size, Winding};
use provenance::Grade;
use quantities::identified;

/// One statement of a source in our own words, with the figures in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fact {
    /// Identifier.
    pub id: &'static str,
    /// Section of the document: `9.4`.
    pub section: &'static str,
    /// Identifier of the document in `data/sources.toml`.
    pub document: &'static str,
    /// How far it can be trusted.
    pub grade: Grade,
    /// The answers that show it.
    pub topics: &'static [Topic],
    /// Signal word; `None` for a plain statement.
    pub signal: Option<Signal>,
    /// Its place in a check-list.
    pub step: Option<Step>,
    /// The codes that it holds for.
    pub holds_for: HoldsFor,
    /// The figures in it, in machine form.
    pub values: &'static [FactValue],
    /// English text.
    pub en: &'static str,
    /// German text.
    pub de: &'static str,
}

impl Fact {
    /// Whether an answer on this topic shows it for this code; safety is shown by every answer.
    #[must_use]
    pub fn is_shown(&self, topic: Topic, code: &OrderCode) -> bool {
        (self.topics.contains(&topic) || self.topics.contains(&Topic::Safety)) && self.holds_for.covers(code)
    }
}

/// The codes that a fact holds for. An empty list and `None` leave the field open.
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
    /// Only with a brake, or only without.
    pub brake: Option<bool>,
    /// Only with the encoder at the output (option EC), or only without.
    pub output_encoder: Option<bool>,
    /// Only where the KTY of the winding is led out, or only where it is not.
    pub kty: Option<bool>,
}

impl HoldsFor {
    /// Whether a code is among them.
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
    /// The figure, in its unit.
    pub number: f64,
    /// Unit in ASCII; empty for pure numbers.
    pub unit: &'static str,
    /// What the figure bounds.
    pub bound: Bound,
}

identified! {
    /// The answer that shows a fact.
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
        /// Every one of them.
        Safety = "safety",
    }
}

identified! {
    /// Signal words of ISO 3864-2 and ANSI Z535.6, gravest first.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Signal {
        /// Death or grave injury follows.
        Danger = "danger",
        /// Death or grave injury may follow.
        Warning = "warning",
        /// Light injury may follow.
        Caution = "caution",
        /// Damage to things may follow.
        Notice = "notice",
        /// Worth knowing.
        Info = "info",
    }
}

identified! {
    /// When a fact matters, in the order of a machine's life.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Step {
        /// Transport and storage.
        Transport = "transport",
        /// Mounting in the machine.
        Mounting = "mounting",
        /// Electrical installation.
        Wiring = "wiring",
        /// Before the power is switched on.
        BeforePower = "before_power",
        /// The first motion.
        FirstMotion = "first_motion",
        /// After the first day of operation.
        AfterADay = "after_a_day",
        /// In service.
        InService = "in_service",
        /// Shutting down and work on a machine that stands.
        Shutdown = "shutdown",
        /// Taking out of service.
        Disposal = "disposal",
    }
}

identified! {
    /// What a figure says about the thing it is the figure of.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Bound {
        /// More than the figure.
        Above = "above",
        /// Less than the figure.
        Below = "below",
        /// The figure or more.
        AtLeast = "at_least",
        /// The figure or less.
        AtMost = "at_most",
        /// Around the figure.
        About = "about",
        /// The figure.
        Exactly = "exactly",
    }
}
