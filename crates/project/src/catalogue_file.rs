//! Catalogue files: products of any manufacturer as data.

use crate::own::{ActuatorEntry, CatalogueFile, CatalogueHead};
use crate::read::Reader;
use crate::report::FaultReport;
use crate::section::Section;
use crate::value::OneOrMany;
use crate::{Diagnostic, Key};

/// Largest catalogue file that is read, in bytes.
pub const CATALOGUE_MAX_BYTES: usize = 32 << 20;

/// The keys of a catalogue file.
pub const CATALOGUE_KEYS: &[Key] = CatalogueFile::KEYS;

/// A catalogue file as read, with its faults so far; the products that are built from it add theirs.
#[derive(Debug)]
pub struct ReadCatalogue<'t> {
    /// Statements for all products.
    pub head: Option<CatalogueHead>,
    /// Actuators in the order of the file; refused values are marked.
    pub actuators: Vec<ActuatorEntry>,
    /// Faults of keys, units and values.
    pub report: FaultReport<'t>,
}

/// Reads a catalogue file in TOML.
///
/// # Errors
/// If the file is too large. Faults of its text are in the report.
pub fn read_catalogue(text: &str) -> Result<ReadCatalogue<'_>, Vec<Diagnostic>> {
    let mut reader = Reader::within(text, CATALOGUE_MAX_BYTES)?;
    let mut file: CatalogueFile = reader.read();
    let head = file.catalogue.get().cloned();
    let actuators = match file.actuator.get_mut() {
        Some(OneOrMany::Many(several)) => std::mem::take(several),
        Some(OneOrMany::One(one)) => vec![one.clone()],
        None => Vec::new(),
    };
    Ok(ReadCatalogue { head, actuators, report: reader.report })
}
