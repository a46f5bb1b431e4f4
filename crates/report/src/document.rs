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
    program: String,
    hash_project: String,
    hash_catalogue: String,
}

#[derive(Serialize)]
struct Date {
    year: u16,
    month: u8,
    day: u8,
}

impl ReportDocument {
    pub(crate) fn build(content: &Content, settings: &Settings) -> Result<Self, Fault> {
        let shown = Formatter(content.language);
        let first = content.axes.first().ok_or(Fault::NoAxis)?;
        let date = settings.date.as_deref().map(read_date).transpose()?;
        let dossiers = || content.axes.iter().map(|axis| &axis.dossier);
        let mut documents: Vec<answers::Document> = Vec::new();
        for each in dossiers().flat_map(|dossier| &dossier.documents) {
            if documents.iter().all(|known| known.id != each.id) {
                documents.push(each.clone());
            }
        }
        let head = Head {
            axis: if content.axes.len() == 1 { first.dossier.judgement.axis.clone() } else { String::new() },
            fits: dossiers().all(|dossier| dossier.judgement.candidate.verdict.fits()),
            date_text: date.as_ref().map(|date| shown.date(date.year, date.month, date.day)).unwrap_or_default(),
            date,
            revision: settings.revision.clone(),
            project: settings.project.clone(),
            number: settings.number.clone(),
            author: settings.author.clone(),
            company: settings.company.clone(),
            customer: settings.customer.clone(),
            order: settings.order.clone(),
            changes: settings.changes.iter().map(|change| shown_change(change, &shown)).collect(),
            program: first.dossier.fingerprints.program.clone(),
            hash_project: checks::once(dossiers().map(|dossier| &dossier.fingerprints.project)).join(", "),
            hash_catalogue: first.dossier.fingerprints.catalogue.clone(),
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
    let date = read_date(&change.date)
        .map_or_else(|_| change.date.clone(), |date| shown.date(date.year, date.month, date.day));
    Change { date, ..change.clone() }
}

/// Parses a calendar date as year, month, day.
fn read_date(text: &str) -> Result<Date, Fault> {
    let fault = || Fault::Date { text: text.to_owned() };
    let mut parts = text.trim().splitn(3, '-');
    let mut next = |digits: usize| {
        parts.next().filter(|part| part.len() == digits && part.bytes().all(|byte| byte.is_ascii_digit()))
    };
    let (Some(year), Some(month), Some(day)) = (next(4), next(2), next(2)) else { return Err(fault()) };
    let year: u16 = year.parse().map_err(|_| fault())?;
    let month: u8 = month.parse().map_err(|_| fault())?;
    let day: u8 = day.parse().map_err(|_| fault())?;
    let leap = year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
    let last = match month {
        2 => 28 + u8::from(leap),
        4 | 6 | 9 | 11 => 30,
        1..=12 => 31,
        _ => return Err(fault()),
    };
    if day == 0 || day > last {
        return Err(fault());
    }
    Ok(Date { year, month, day })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_date_is_one_of_the_calendar() {
        for text in ["2026-11-21", "2024-02-29", "2000-02-29"] {
            assert!(read_date(text).is_ok(), "{text}");
        }
        for text in ["", "21.11.2026", "2026-13-01", "2026-02-29", "1900-02-29", "2026-04-31", "2026-1-1", "2026-11-+1"]
        {
            assert!(read_date(text).is_err(), "{text}");
        }
    }
}
