//! Catalogue files: products of any maker as data, and their use in a project.

use crate::about::About;
use crate::own::ActuatorValues;
use crate::read::Reader;
use crate::report::FaultReport;
use crate::section::{Section, section};
use crate::value::{OneOrMany, Texts};
use crate::{Diagnostic, Key};
use quantities::Time;

/// Largest catalogue file that is read, in bytes.
pub const CATALOGUE_MAX_BYTES: usize = 32 << 20;

section! {
    /// Catalogue files of a project.
    CatalogueSection, CatalogueName of About::Catalogue {
        files: Texts => example("stock.toml");
        cha: bool = true;
    }
}

section! {
    /// A whole catalogue file.
    CatalogueFile, CatalogueFileName of About::CatalogueFile {
        catalogue: CatalogueHead;
        actuator: OneOrMany<ActuatorEntry, ActuatorEntry>;
    }
}

section! {
    /// Statements of a catalogue file that hold for all its products.
    CatalogueHead, CatalogueHeadName of About::CatalogueHead {
        maker: String => example("Example Drives");
        series: String => example("XD");
        source: String => example("catalogue 2026, pages 12 to 15");
        date: String => example("2026-05-01");
    }
}

section! {
    /// An actuator of a catalogue file.
    ActuatorEntry, ActuatorEntryName of About::ActuatorEntry {
        id: String => needed, example("XD-25-100");
        maker: String => example("Example Drives");
        series: String => example("XD");
        source: String => example("data sheet XD-25, revision C");
        price: String => example("1250 EUR");
        lead_time: Time => not_negative, example("56 d");
        ..values: ActuatorValues;
    }
}

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
