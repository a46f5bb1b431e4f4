//! Values of the user with their sources.

use project::sections::StatedField;
use provenance::{Grade, Source, Sourced};

/// Returns a value of the user with its source: graded as published, since it is taken from a document of the user.
pub(crate) fn sourced<T>(field: &dyn StatedField, value: T) -> Sourced<T> {
    Sourced { value, source: Source::Project { key: field.path().into() }, grade: Grade::Published, errata: &[] }
}
