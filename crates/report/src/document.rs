//! The document as the template reads it: every number already in the words of its language, every list in its order.

mod alternatives;
pub(crate) mod axis;
#[cfg(feature = "pdf")]
pub(crate) mod checklist;
mod checks;
mod demand;
mod ends;
mod inputs;
pub(crate) mod laid_out;
mod operation;
mod origins;
mod shown;

use crate::{Change, Content, Fault, Settings};
use axis::AxisData;
use chrono::{Datelike, NaiveDate};
use serde::Serialize;
use shown::Formatter;
use std::collections::BTreeMap;

/// Data of the report template.
#[derive(Serialize)]
pub(crate) struct ReportDocument {
    lang: &'static str,
    full: bool,
    head: Head,
    axes: Vec<AxisData>,
    documents: Vec<answers::Document>,
    /// Grades that occur among the checks, the best first.
    grades: Vec<checks::GradeTold>,
    /// Texts of the template, by key.
    words: BTreeMap<&'static str, String>,
}

/// Data of the document itself.
#[derive(Serialize)]
struct Head {
    /// Kind of the actuators that are judged.
    subject: String,
    /// Name of the only axis; empty with several.
    axis: String,
    /// `true` if the actuator of every axis fits.
    fits: bool,
    date: Option<Date>,
    date_text: String,
    revision: String,
    project: String,
    number: String,
    author: String,
    company: String,
    customer: String,
    order: String,
    changes: Vec<Change>,
    /// Values in place of those of the project file.
    altered: Vec<String>,
    program: String,
    hash_project: String,
    hash_catalogue: String,
}

/// A date as the template sets it in the properties of the document.
#[derive(Serialize)]
struct Date {
    year: i32,
    month: u32,
    day: u32,
}

impl From<NaiveDate> for Date {
    fn from(date: NaiveDate) -> Self {
        Self { year: date.year(), month: date.month(), day: date.day() }
    }
}

impl ReportDocument {
    pub(crate) fn build(content: &Content, settings: &Settings) -> Result<Self, Fault> {
        let shown = Formatter(content.language);
        let first = content.axes.first().ok_or(Fault::NoAxis)?;
        let dossiers = || content.axes.iter().map(|axis| &axis.dossier);
        let mut documents: Vec<answers::Document> = Vec::new();
        for each in dossiers().flat_map(|dossier| &dossier.documents) {
            if documents.iter().all(|known| known.id != each.id) {
                documents.push(each.clone());
            }
        }
        let head = Head {
            subject: checks::once(content.axes.iter().map(|axis| &axis.actuator_kind)).join("; "),
            axis: if content.axes.len() == 1 { first.dossier.judgement.axis.clone() } else { String::new() },
            fits: dossiers().all(|dossier| dossier.judgement.candidate.verdict.fits()),
            date_text: settings.date.map(|date| shown.date(date)).unwrap_or_default(),
            date: settings.date.map(Date::from),
            revision: settings.revision.clone(),
            project: settings.project.clone(),
            number: settings.number.clone(),
            author: settings.author.clone(),
            company: settings.company.clone(),
            customer: settings.customer.clone(),
            order: settings.order.clone(),
            changes: settings.changes.iter().map(|change| shown_change(change, &shown)).collect(),
            altered: settings.altered.iter().map(|line| shown::tied(line)).collect(),
            program: first.dossier.fingerprints.program.clone(),
            hash_project: checks::once(dossiers().map(|dossier| &dossier.fingerprints.project)).join(", "),
            hash_catalogue: checks::once(dossiers().map(|dossier| &dossier.fingerprints.catalogue)).join(", "),
        };
        Ok(Self {
            lang: content.language.id(),
            full: settings.full,
            head,
            grades: checks::grades(dossiers(), content.language),
            words: words::report::words(content.language),
            axes: content
                .axes
                .iter()
                .enumerate()
                .map(|(index, axis)| AxisData::build(index, axis, settings.full, &shown))
                .collect(),
            documents,
        })
    }
}

/// Returns a change with its day in the format of the language; a day that is no calendar date stays unchanged.
fn shown_change(change: &Change, shown: &Formatter) -> Change {
    let date = change.date.parse().map_or_else(|_| change.date.clone(), |date| shown.date(date));
    Change { date, ..change.clone() }
}
