//! Angular errors at the output, one by one.

use crate::candidate::Candidate;
use quantities::{Angle, Language, Measure};
use sizing::{CheckId, Note};
use words::{error_kind_text, grade_word, source_text};

/// Angular error at the output, or an unknown one.
#[derive(Clone, Debug)]
pub struct AngularError {
    /// Name.
    pub name: String,
    /// Magnitude with grade and source as text; `None` if it is not known.
    pub known: Option<(Angle, String)>,
    /// Share of the sum \[1\].
    pub share: f64,
}

/// Angular errors at the output, the largest first, the unknown ones last.
#[derive(Clone, Debug)]
pub struct AngularErrors {
    /// Errors.
    pub errors: Vec<AngularError>,
    /// Sum of all, as if each had its limit in the same direction.
    pub sum: Angle,
    /// Root of the sum of squares, as if they were independent.
    pub root_sum_square: Angle,
}

/// Returns the angular errors behind the check of the error budget; `None` if it could not be made.
#[must_use]
pub fn angular_errors(candidate: &Candidate<'_>, language: Language) -> Option<AngularErrors> {
    let check = candidate.judgement.checks.iter().find(|check| check.id == CheckId::ErrorBudget)?;
    let budget = check.notes.iter().find_map(|note| match note {
        Note::Budget(budget) => Some(&budget.errors),
        _ => None,
    })?;
    let sum = budget.worst_case();
    let known = budget.contributions.iter().map(|each| {
        let source =
            format!("{}, {}", grade_word(each.angle.grade, language), source_text(&each.angle.source, language));
        let share = if sum.si() > 0.0 { each.angle.value.si() / sum.si() } else { 0.0 };
        AngularError { name: error_kind_text(each.kind, language), known: Some((each.angle.value, source)), share }
    });
    let mut errors: Vec<AngularError> = known.collect();
    errors.sort_by(|a, b| b.share.total_cmp(&a.share));
    errors.extend(budget.missing.iter().map(|kind| AngularError {
        name: error_kind_text(*kind, language),
        known: None,
        share: 0.0,
    }));
    Some(AngularErrors { errors, sum, root_sum_square: budget.root_sum_square() })
}
