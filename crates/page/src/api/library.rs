//! Questions that need neither project nor code: the words, the data, the forms.

use super::asked::Asked;
use super::{JSON, Unanswered, record};
use crate::Reply;
use workbench::quantities::{Measure, Time};
use workbench::text::told;
use workbench::{BatteryLife, ErrataRefusal, InertiaAnswer, Refusal, answer};

pub(super) fn battery(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    battery_of(asked).map(|found| record(200, &answer::battery(&found)))
}

/// Life of the encoder's battery.
pub(crate) fn battery_of(asked: &Asked<'_>) -> Result<BatteryLife, Unanswered> {
    let hours = "hours-per-day";
    let operation = workbench::read_hours(asked.text(hours).unwrap_or_default(), asked.language)
        .map_err(|fault| answer::option_fault(hours, fault))?;
    let storage = asked.quantity::<Time>("storage")?.unwrap_or_else(|| Time::from_si(0.0));
    workbench::battery(operation, storage, asked.language)
        .map_err(|message| answer::option_fault(hours, (message, None)).into())
}

pub(super) fn inertia(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    inertia_of(asked).map(|found| record(200, &answer::inertia(&found)))
}

/// Bodies about an axis.
pub(crate) fn inertia_of(asked: &Asked<'_>) -> Result<InertiaAnswer, Unanswered> {
    // One body a line: the line of a fault is the number of the body.
    let text = asked.all("body").collect::<Vec<_>>().join("\n");
    workbench::inertia(&text).map_err(|faults| answer::faults("body", &told(&faults, asked.language)).into())
}

pub(super) fn errata(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let text = asked.text("about").unwrap_or_default();
    let found = workbench::errata_about(Some(text), asked.language).map_err(|refusal| match refusal {
        ErrataRefusal::Code(refusal) => Unanswered::Code(answer::code_faults(text, &refusal, asked.language)),
        ErrataRefusal::NoData => asked.refused(&Refusal::NoData),
        ErrataRefusal::Unknown { message, hint } => {
            let message = hint.map_or(message.clone(), |hint| format!("{message}; {hint}"));
            answer::fault(&message).into()
        }
    })?;
    Ok(record(200, &answer::errata(&found, asked.language)))
}

pub(super) fn glossary(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let wanted = asked.text("term");
    let found = workbench::glossary(wanted, asked.language)
        .map_err(|nearest| answer::not_in_glossary(wanted.unwrap_or_default(), &nearest, asked.language))?;
    Ok(record(200, &found))
}

pub(super) fn catalogue(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    if asked.text("format") == Some("csv") {
        return Ok(Reply::of(200, super::list::CSV, workbench::export_csv()));
    }
    Ok(record(200, &answer::catalogue_cells()))
}

pub(super) fn schema(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    if asked.flag("answers") {
        return Ok(record(200, &workbench::answers::schema()));
    }
    Ok(record(200, &workbench::schema(asked.language)))
}

pub(super) fn licences(_: &Asked<'_>) -> Result<Reply, Unanswered> {
    Ok(record(200, &workbench::licences()))
}

pub(super) fn template(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let kind = asked.text("kind").unwrap_or_default();
    let found = workbench::template(kind, TEMPLATE_NAME, asked.language);
    let found = found.ok_or_else(|| asked.refused(&Refusal::NoData))?;
    Ok(Reply::of(200, super::list::TOML, found.text))
}

/// What the header of a new project calls its file.
const TEMPLATE_NAME: &str = "axis.toml";

#[cfg(feature = "interface")]
pub(super) fn openapi(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let mut text = serde_json::to_string_pretty(&super::openapi::document(asked.language)).unwrap_or_default();
    text.push('\n');
    Ok(Reply::of(200, JSON, text))
}
