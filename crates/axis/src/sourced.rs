//! Values of the user with their sources.

use project::sections::{KeyValue, Stated, StatedField};
use provenance::{Datum, Grade, Source, Sourced};

/// Returns a value of the user with its source: graded as published, since it is taken from a document of the user.
pub(crate) fn sourced<T>(field: &dyn StatedField, value: T) -> Sourced<T> {
    published(value, Source::Project { key: field.path().into() })
}

const fn published<T>(value: T, source: Source) -> Sourced<T> {
    Sourced { value, source, grade: Grade::Published, errata: &[] }
}

/// File that states the values of an actuator.
pub(crate) enum Origin<'a> {
    /// The project.
    Project,
    /// A catalogue file.
    File {
        /// Name of the file.
        name: &'a str,
        /// Line of the product, from one.
        line: usize,
        /// Document from which the values are taken; empty if the file names none.
        document: &'a str,
    },
}

impl Origin<'_> {
    /// Returns a value with its source.
    pub(crate) fn known<T>(&self, field: &dyn StatedField, value: T) -> Datum<T> {
        Datum::Known(match self {
            Self::Project => sourced(field, value),
            Self::File { name, line, document } => {
                let key = field.name();
                let of = if document.is_empty() { String::new() } else { format!(" ({document})") };
                published(value, Source::CatalogueFile { place: format!("{name}:{line}: {key}{of}").into() })
            }
        })
    }

    /// Returns the value of a field with its source, if it is stated.
    pub(crate) fn datum<T: KeyValue + Copy>(&self, field: &Stated<T>) -> Datum<T> {
        field.value().map_or(Datum::NotPrinted, |value| self.known(field, value))
    }
}
