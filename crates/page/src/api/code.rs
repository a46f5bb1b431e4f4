//! Questions about an ordering code.

use super::asked::Asked;
use super::{Unanswered, record};
use crate::Reply;
use workbench::answer;
use workbench::answers::{self, CommissionAnswer, Faults};
use workbench::quantities::{ElectricPotential, ThermodynamicTemperature};
use workbench::text::{file_trouble, terminal, upkeep, wiring};
use workbench::{
    Commissioning, Date, DriveForm, LISTED_BYTES_MAX, MountAsked, OrderCode, PerformanceCurve, Plane, Refusal,
    TorsionAnswer, Upkeep, UpkeepAsked, Wiring, usual_ambient,
};

pub(super) fn parse(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let text = asked.text("code").unwrap_or_default();
    let reading = workbench::read_code(text, asked.language)
        .map_err(|refusal| Unanswered::Code(answer::code_faults(text, &refusal, asked.language)))?;
    Ok(record(200, &answer::code_reading(&reading, asked.language)))
}

pub(super) fn list(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let pattern = asked.text("pattern");
    let read = |text| {
        workbench::read_pattern(text, asked.language)
            .map_err(|refusal| Unanswered::Code(answer::code_faults(text, &refusal, asked.language)))
    };
    let pattern = pattern.map(read).transpose()?;
    let only_available = asked.flag("available");
    let mut codes = workbench::list_codes(pattern.as_ref());
    codes.retain(|(_, found)| !only_available || found.is_available());
    Ok(record(200, &answer::listed(&codes, asked.language)))
}

pub(super) fn complete(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let text = asked.text("code").unwrap_or_default();
    let pattern = workbench::read_pattern(text, asked.language)
        .map_err(|refusal| Unanswered::Code(answer::code_faults(text, &refusal, asked.language)))?;
    let codes = workbench::list_codes(Some(&pattern));
    Ok(record(200, &answer::completion(&pattern, &codes, asked.language)))
}

pub(super) fn data(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let sheet = workbench::sheet(&asked.code()?).ok_or_else(|| asked.refused(&Refusal::NoData))?;
    Ok(record(200, &answer::sheet(&sheet, asked.language)))
}

pub(super) fn torsion(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let (code, found) = torsion_of(asked)?;
    Ok(record(200, &answer::torsion(&code, &found)))
}

/// A gear under a torque, or twisted by an angle.
pub(crate) fn torsion_of(asked: &Asked<'_>) -> Result<(OrderCode, TorsionAnswer), Unanswered> {
    let code = asked.code()?;
    let twist = workbench::read_twist(asked.text("torque"), asked.text("angle"), asked.language)
        .map_err(|(option, fault)| answer::option_fault(option, fault))?;
    let found = workbench::torsion(&code, twist).ok_or_else(|| asked.refused(&Refusal::NoData))?;
    Ok((code, found))
}

pub(super) fn curve(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let (code, curves, _) = curves_of(asked)?;
    Ok(record(200, &answer::curves(&code, &curves, asked.language)))
}

/// The curves of a code, and the plane that they bound.
pub(crate) fn curves_of(asked: &Asked<'_>) -> Result<(OrderCode, Vec<PerformanceCurve>, Plane), Unanswered> {
    let code = asked.code()?;
    let voltage: Option<ElectricPotential> = asked.quantity("voltage")?;
    match (workbench::curves(&code, voltage), workbench::plane_of(&code, voltage)) {
        (Some(Ok(curves)), Some(Ok(plane))) => Ok((code, curves, plane)),
        _ => Err(asked.refused(&Refusal::NoData)),
    }
}

pub(super) fn wiring(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    wiring_of(asked).map(|(_, found)| record(200, &found))
}

/// Connectors, pins and cables.
pub(crate) fn wiring_of(asked: &Asked<'_>) -> Result<(Wiring, answers::Wiring), Unanswered> {
    let code = asked.code()?;
    let found = workbench::wiring(&code).ok_or_else(|| asked.refused(&Refusal::NoData))?;
    let language = asked.language;
    let length = asked.text("length").map(|text| workbench::cable_length(text, language)).transpose();
    let length = length.map_err(|fault| answer::option_fault("length", fault))?;
    let section = asked.text("cross-section").map(|text| workbench::cross_section(text, language)).transpose();
    let section = section.map_err(|fault| answer::option_fault("cross-section", fault))?;
    if section.is_some() && length.is_none() {
        return Err(asked.missing("length"));
    }
    let told = answer::wiring(&found, length.map(|length| (length, section)), language);
    Ok((found, told))
}

pub(super) fn pins(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let code = asked.code()?;
    let found = workbench::wiring(&code).ok_or_else(|| asked.refused(&Refusal::NoData))?;
    let (name, bytes) = (asked.name()?, asked.bytes());
    if bytes.len() > LISTED_BYTES_MAX {
        let what = wiring::pin_list_too_large(&LISTED_BYTES_MAX, asked.language);
        return Err(Unanswered::Faults(413, answer::file_fault(&name, &what)));
    }
    let read = workbench::read_list(&found, bytes)
        .map_err(|error| answer::file_fault(&name, &file_trouble(&error, asked.language)))?;
    match &read.outcome {
        Ok(comparison) => Ok(record(200, &answer::wiring_check(&found, comparison, asked.language))),
        Err(_) => Err(answer::faults(&name, &read.told(asked.language)).into()),
    }
}

/// How an actuator is mounted.
pub(super) fn mount(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    mount_alone(asked).map(|found| record(200, &found))
}

/// The same under the limits of the manual.
pub(crate) fn mount_alone(asked: &Asked<'_>) -> Result<answers::Mount, Unanswered> {
    mount_under(asked, |_| Ok((MountAsked::default(), None)))
}

/// The same under loads that are asked for once code and bores are right, with the name of their axis.
pub(super) fn mount_under(
    asked: &Asked<'_>,
    loads: impl FnOnce(&OrderCode) -> Result<(MountAsked, Option<String>), Unanswered>,
) -> Result<answers::Mount, Unanswered> {
    let mut faults: Vec<Faults> = Vec::new();
    let code = asked.code_among_others(asked.text("code").unwrap_or_default()).map_err(|fault| faults.push(fault));
    let mut bore = |name: &str| {
        let read = workbench::read_bore(asked.text(name)?, asked.language);
        read.map_err(|fault| faults.push(answer::option_fault(name, fault))).ok()
    };
    let (both, load, housing) = (bore("bore"), bore("bore-load"), bore("bore-housing"));
    let (Ok(code), true) = (code, faults.is_empty()) else { return Err(Faults::together(faults).into()) };
    let (under, name) = loads(&code)?;
    let question = MountAsked { bore_load: load.or(both), bore_housing: housing.or(both), ..under };
    let found = workbench::mount(&code, &question).ok_or_else(|| asked.refused(&Refusal::NoData))?;
    Ok(answer::mount(&found, &question, name.as_deref(), asked.language))
}

pub(super) fn upkeep(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    upkeep_of(asked).map(|(_, found)| record(200, &found))
}

/// The plan as a calendar.
#[cfg(feature = "interface")]
pub(super) fn calendar(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let name = asked.label("name")?;
    let (plan, found) = upkeep_of(asked)?;
    let text = tables::calendar(&plan, &found, name.as_deref(), asked.language);
    Ok(Reply::of(200, super::list::CALENDAR, text).saved_as(&format!("{}.ics", found.code)))
}

/// What is to be done, and when.
pub(crate) fn upkeep_of(asked: &Asked<'_>) -> Result<(Upkeep, answers::Upkeep), Unanswered> {
    let language = asked.language;
    let mut faults: Vec<Faults> = Vec::new();
    let code = asked.code_among_others(asked.text("code").unwrap_or_default()).map_err(|fault| faults.push(fault)).ok();
    macro_rules! option {
        ($name:literal, $reader:expr) => {
            asked.text($name).and_then(|text| {
                $reader(text, language).map_err(|fault| faults.push(answer::option_fault($name, fault))).ok()
            })
        };
    }
    let delivered: Option<Date> = option!("delivered", workbench::read_date);
    let today: Option<Date> = option!("today", workbench::read_date);
    let storage = option!("storage", workbench::read_storage);
    let inspect = option!("inspect", workbench::read_interval);
    let hours_per_day = option!("hours-per-day", workbench::read_hours);
    if let Some(delivered) = delivered
        && let Some(today) =
            today.map_or_else(|| before(delivered, asked), |today| (delivered > today).then_some(today))
    {
        let [day, now] = [delivered, today].map(upkeep::date_text);
        let hint = upkeep::give_today(language).to_owned();
        let told = (upkeep::delivered_in_the_future(&day, &now, language), Some(hint));
        faults.push(answer::option_fault("delivered", told));
    }
    if code.is_some_and(|code| workbench::sheet(&code).is_none())
        && let Unanswered::Faults(_, none) = asked.refused(&Refusal::NoData)
    {
        faults.push(none);
    }
    match (code, delivered) {
        (Some(code), Some(delivered)) if faults.is_empty() => {
            let question = UpkeepAsked { delivered, storage, hours_per_day, inspect, today };
            let plan = workbench::upkeep(&code, &question, language)
                .map_err(|(name, message, hint)| answer::option_fault(name, (message, hint)))?;
            let found = answer::upkeep(&plan, language);
            Ok((plan, found))
        }
        _ => Err(Faults::together(faults).into()),
    }
}

/// The day of the shell's clock where another has not come yet anywhere on earth: far east of it it may be tomorrow.
fn before(day: Date, asked: &Asked<'_>) -> Option<Date> {
    let days = asked.shell.days_since_1970()?;
    let tomorrow = workbench::day_of_clock(days.checked_add(1)?)?;
    if day > tomorrow { workbench::day_of_clock(days) } else { None }
}

pub(super) fn commission(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let (sheet, objects) = commission_of(asked)?;
    if asked.text("for").and_then(DriveForm::of_id) == Some(DriveForm::Cia402) {
        return Ok(record(200, &CommissionAnswer::Objects(objects)));
    }
    Ok(record(200, &CommissionAnswer::Sheet(Box::new(sheet))))
}

/// What a drive is told, with the objects of CiA 402 where they are asked for.
pub(crate) fn commission_of(
    asked: &Asked<'_>,
) -> Result<(answers::Commissioning, Vec<answers::DriveObject>), Unanswered> {
    let about = commissioning(asked)?;
    let ambient: Option<ThermodynamicTemperature> = asked.quantity("ambient")?;
    let form = asked.text("for").and_then(DriveForm::of_id).unwrap_or(DriveForm::Plain);
    let objects = if form == DriveForm::Cia402 { answer::drive_objects(&about, asked.language) } else { Vec::new() };
    Ok((answer::commissioning(&about, form, ambient.unwrap_or_else(usual_ambient), asked.language), objects))
}

/// What is known for the commissioning of a code.
pub(crate) fn commissioning(asked: &Asked<'_>) -> Result<Commissioning, Unanswered> {
    workbench::commission(&asked.code()?).ok_or_else(|| asked.refused(&Refusal::NoData))
}

/// The values as a drive reads them.
pub(super) fn commission_file(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let about = commissioning(asked)?;
    let (text, ending) = match asked.text("for").and_then(DriveForm::of_id) {
        Some(DriveForm::Cia402) => (workbench::eds(&about, asked.language), "eds"),
        _ => (workbench::sinamics_script(&about, asked.language), "txt"),
    };
    Ok(Reply::of(200, super::list::PLAIN, text).saved_as(&format!("{}.{ending}", about.code)))
}

/// An empty record to fill in.
pub(super) fn blank(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let about = commissioning(asked)?;
    let name = format!("{}-measured.toml", about.code);
    let text = workbench::blank_record(&about, &name, asked.language);
    Ok(Reply::of(200, super::list::TOML, text).saved_as(&name))
}

/// The check-lists as a form to fill in.
pub(super) fn checklist(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let l = asked.language;
    let Some(write) = asked.shell.checklist() else {
        return Err(answer::fault(terminal::built_without_report(l)).into());
    };
    let (sheet, _) = commission_of(asked)?;
    let bytes = write(&sheet, l).map_err(|what| Unanswered::from(answer::fault(&what)))?;
    Ok(Reply::of(200, super::list::PDF, bytes).saved_as(&format!("{}.pdf", sheet.code)))
}

pub(super) fn judged(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let about = commissioning(asked)?;
    let judged = workbench::judge(&about, &asked.measured()?);
    Ok(record(200, &answer::recorded(&about, &judged, asked.language)))
}
