//! `catalogue check FILE…`: faults and implausible values of catalogue files.

use super::given::{arguments, flag};
use super::{Answer, Argument, Entry, Gives, Inquiry, Reads, Record, Unanswered};
use crate::answer::checked_catalogue;
use crate::reading::Unread;
use answers::CatalogueCheck;
use axis::{AxisDiagnostic, AxisFault};
use std::collections::BTreeSet;
use words::help;

arguments! {
    /// Arguments of `catalogue check`: proposals.
    pub struct Args {
        /// Proposes units that resolve findings.
        fix_units: bool = Argument::flag("fix-units", help::catalogue_check_fix_units) => flag,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "catalogue check",
    path: "catalogue/check",
    about: help::catalogue_check,
    reads: Reads::Measured,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<CatalogueCheck>("catalogue check")),
    writes: &[],
    example: "examples/catalogue/stock.csv",
    answer: Some(|inquiry| {
        let found = found(inquiry)?;
        Ok(Answer::record(&found).fits(found.plausible))
    }),
};

/// Checks the catalogue files of a call.
///
/// # Errors
/// Every fault of the files, each with its place; a product of two files.
pub fn found(inquiry: &Inquiry<'_>) -> Result<CatalogueCheck, Unanswered> {
    let Args { fix_units } = Args::read(&inquiry.given)?;
    let language = inquiry.language;
    inquiry.source()?;
    let parameters = inquiry.catalogue.own_actuator();
    let (mut files, mut refused) = (Vec::new(), Vec::new());
    let mut names: BTreeSet<String> = BTreeSet::new();
    for source in &inquiry.sources {
        let faults = match axis::check_catalogue(&source.name, &source.bytes, &parameters, fix_units) {
            Ok(check) => {
                let twice = check.names.iter().filter(|id| names.contains(*id));
                let twice: Vec<AxisFault> = twice.map(|id| AxisFault::ProductOfTwoFiles { id: id.clone() }).collect();
                files.push(checked_catalogue(&source.name, &check, language));
                names.extend(check.names);
                twice.into_iter().map(|fault| AxisDiagnostic::at("", 0..0, fault, None)).collect()
            }
            Err(faults) => faults,
        };
        if !faults.is_empty() {
            let (text, _) = project::decoded(&source.bytes);
            refused.push(Unanswered::unread(Unread::Faults(faults), &source.name, &text, language));
        }
    }
    if !refused.is_empty() {
        return Err(Unanswered::combined(refused));
    }
    Ok(CatalogueCheck { plausible: files.iter().all(|file| file.findings.is_empty()), files })
}
