//! Comparison of a value with a limit, and the derivation of both.

use crate::check::{Amount, Check, CheckId, Direction, Verdict};
use crate::notes::{Note, Notes};
use derivation::Workings;
use numeric::at_most;
use provenance::{Grade, Missing, Source, Sourced};
use quantities::{Measure, Time, Unit};

/// Statements of the project in a derivation.
pub(crate) trait Asking {
    /// Records the limit of a check, if the project states one.
    fn asked(&mut self, symbol: &'static str, unit: &'static Unit, limit: Option<f64>, id: CheckId);

    /// Records a value that the project states by a key.
    fn stated(&mut self, symbol: &'static str, unit: &'static Unit, value: f64, key: &'static str);

    /// Records a limit of a key other than that of the check.
    fn asked_by(&mut self, symbol: &'static str, unit: &'static Unit, limit: f64, key: &'static str);
}

impl Asking for Workings {
    fn asked(&mut self, symbol: &'static str, unit: &'static Unit, limit: Option<f64>, id: CheckId) {
        if let (Some(limit), Some(key)) = (limit, id.key()) {
            self.asked_by(symbol, unit, limit, key);
        }
    }

    fn stated(&mut self, symbol: &'static str, unit: &'static Unit, value: f64, key: &'static str) {
        self.figure(symbol, unit, value, &project(key), Grade::Printed);
    }

    fn asked_by(&mut self, symbol: &'static str, unit: &'static Unit, limit: f64, key: &'static str) {
        self.stated(symbol, unit, limit, key);
        self.limit(symbol);
    }
}

/// Data of a check before it is a [`Check`].
pub(crate) struct Comparison<'a> {
    pub(crate) id: CheckId,
    pub(crate) unit: &'static Unit,
    pub(crate) value: f64,
    pub(crate) value_source: Source,
    pub(crate) at: Option<Time>,
    pub(crate) limit: f64,
    pub(crate) limit_source: &'a Source,
    pub(crate) grade: Grade,
    pub(crate) errata: &'static [&'static str],
    pub(crate) notes: Notes,
}

/// Edges of an estimate's band: up to the limit a value passes, above the upper edge it fails, between them it is
/// advice.
pub(crate) struct Edges {
    pub(crate) limit: f64,
    pub(crate) upper: f64,
    pub(crate) unit: &'static Unit,
}

impl Edges {
    /// Both edges times a factor.
    pub(crate) const fn scaled(self, factor: f64) -> Self {
        Self { limit: factor * self.limit, upper: factor * self.upper, unit: self.unit }
    }

    /// Returns the remark on the upper edge, if there is a band.
    pub(crate) fn remark(&self) -> Option<Note> {
        let is_band = !at_most(self.upper, self.limit);
        is_band.then_some(Note::EstimatedUpTo(Amount { si: self.upper, unit: self.unit }))
    }
}

impl<'a> Comparison<'a> {
    /// Compares a value with a known limit and its source.
    pub(crate) fn with<Q: Measure>(
        id: CheckId,
        unit: &'static Unit,
        value: f64,
        value_source: Source,
        limit: &'a Sourced<Q>,
    ) -> Self {
        Self {
            id,
            unit,
            value,
            value_source,
            at: None,
            limit: limit.value.si(),
            limit_source: &limit.source,
            grade: limit.grade,
            errata: limit.errata,
            notes: Notes::NONE,
        }
    }

    /// Returns the check: pass up to and including the lower edge of a band, fail above its upper edge, advice between
    /// them.
    pub(crate) fn between(mut self, edges: Edges) -> Check {
        let at_most = |edge: f64| Direction::AtMost.keeps(self.value.abs(), edge.abs());
        let (within, beyond) = (at_most(edges.limit), !at_most(edges.upper));
        self.limit = edges.limit;
        if let Some(remark) = edges.remark() {
            // The remark may have been added for several actuators.
            if !self.notes.contains(&remark) {
                self.notes.push(remark);
            }
            if !within && !beyond {
                self.notes.push(Note::InsideBand);
            }
        }
        let mut check = self.answer(if beyond { Verdict::Fail } else { Verdict::Advice });
        if within {
            check.verdict = Verdict::Pass;
        }
        check
    }

    /// Returns the check: pass up to and including the limit; `otherwise` beyond.
    #[inline]
    pub(crate) fn answer(self, otherwise: Verdict) -> Check {
        let (value, limit) = (self.value.abs(), self.limit.abs());
        let verdict = if Direction::AtMost.keeps(value, limit) { Verdict::Pass } else { otherwise };
        let mut notes = self.notes;
        cite(&mut notes, self.errata);
        Check {
            id: self.id,
            verdict,
            value: Some(Amount { si: self.value, unit: self.unit }),
            limit: Some(Amount { si: self.limit, unit: self.unit }),
            utilisation: (limit != 0.0).then(|| Direction::AtMost.share(value, limit)),
            at: self.at,
            grade: Some(self.grade),
            value_source: Some(self.value_source),
            limit_source: Some(self.limit_source.clone()),
            missing: None,
            notes,
            workings: Box::default(),
        }
    }
}

pub(crate) fn not_checked(id: CheckId, missing: Missing) -> Check {
    Check { missing: Some(missing.symbol), ..unjudged(id) }
}

/// Creates a check without values.
pub(crate) fn unjudged(id: CheckId) -> Check {
    Check {
        id,
        verdict: Verdict::NotChecked,
        value: None,
        limit: None,
        utilisation: None,
        at: None,
        grade: None,
        value_source: None,
        limit_source: None,
        missing: None,
        notes: Notes::NONE,
        workings: Box::default(),
    }
}

/// Compares a value with the limit that the project states by the key of the check, in the direction of the check;
/// without a limit the value is shown and not judged.
pub(crate) fn against_asked(id: CheckId, unit: &'static Unit, value: f64, asked: Option<f64>, source: Source) -> Check {
    let direction = id.direction();
    let verdict = match asked {
        None => Verdict::NotChecked,
        Some(limit) if direction.keeps(value, limit) => Verdict::Pass,
        Some(_) => Verdict::Fail,
    };
    Check {
        id,
        verdict,
        value: Some(Amount { si: value, unit }),
        limit: asked.map(|limit| Amount { si: limit, unit }),
        utilisation: asked.map(|limit| direction.share(value, limit)),
        at: None,
        grade: Some(Grade::Computed),
        value_source: Some(source),
        limit_source: asked.and(id.key()).map(project),
        missing: id.key().filter(|_| asked.is_none()),
        notes: Notes::NONE,
        workings: Box::default(),
    }
}

/// Cites errata without repetition.
pub(crate) fn cite(notes: &mut Notes, errata: &'static [&'static str]) {
    for id in errata {
        let note = Note::Erratum(id);
        if !notes.contains(&note) {
            notes.push(note);
        }
    }
}

/// Returns the source of a statement of the project by its key.
pub(crate) fn project(key: &'static str) -> Source {
    Source::Project { key: key.into() }
}

pub(crate) const fn equation(number: &'static str) -> Source {
    Source::Equation { number }
}
