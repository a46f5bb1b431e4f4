//! `upkeep`: what is to be done with an actuator, and by when.

use crate::answer::{Answer, written};
use crate::code::{parse_for_use, read_argument};
use crate::fault::{option_fault, path_text, text_option};
use crate::laid_out::shown;
use crate::save::save;
use crate::subject::{refuse, refused_together};
use clap::ArgMatches;
use std::path::PathBuf;
use std::time::{SystemTime, UNIX_EPOCH};
use workbench::answers::Fit;
use workbench::text::upkeep;
use workbench::{Language, OrderCode, UpkeepAsked, chapter};

/// Seconds of a day.
const DAY_S: u64 = 86_400;

/// `antrieb upkeep CODE --delivered DATE`
pub(crate) fn upkeep(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    answer(matches, as_json, language).unwrap_or_else(|faults| refused_together(faults, as_json))
}

fn answer(matches: &ArgMatches, as_json: bool, language: Language) -> Result<Answer, Vec<Answer>> {
    let (code, asked, talk) = question(matches, as_json, language)?;
    let one = |fault: Answer| vec![fault];
    let name = text_option(matches, "name", as_json, language).map_err(one)?;
    let plan = workbench::upkeep(&code, &asked, language)
        .map_err(|(option, message, hint)| one(option_fault(option, (message, hint), as_json, language)))?;
    let mut record = workbench::answer::upkeep(&plan, language);
    if let Some(file) = matches.get_one::<PathBuf>("ical") {
        let bytes = tables::calendar(&plan, &record, name.as_deref(), language);
        save(&[(file, bytes.as_bytes())], &[], matches.get_flag("force"))
            .map_err(|fault| one(fault.answer(as_json, language)))?;
        record.calendar = Some(path_text(file));
    }
    let data = if as_json { written(&record) } else { text(&record, language) };
    Ok(Answer { talk, ..Answer::data(data) }.fits(record.verdict == Fit::Fits))
}

/// What is asked, or every fault of it.
fn question(
    matches: &ArgMatches,
    as_json: bool,
    language: Language,
) -> Result<(OrderCode, UpkeepAsked, String), Vec<Answer>> {
    let mut faults: Vec<Answer> = Vec::new();
    let code = match parse_for_use(&read_argument(matches), as_json, language) {
        Ok((reading, talk)) => Some((reading.parsed.code, talk)),
        Err(fault) => {
            faults.push(fault);
            None
        }
    };
    let read = |option: &'static str| matches.get_one::<String>(option).map(String::as_str);
    macro_rules! option {
        ($name:literal, $reader:expr) => {
            read($name).and_then(|text| {
                $reader(text, language).map_err(|fault| faults.push(option_fault($name, fault, as_json, language))).ok()
            })
        };
    }
    let delivered = option!("delivered", workbench::read_date);
    let today = option!("today", workbench::read_date);
    let storage = option!("storage", workbench::read_storage);
    let inspect = option!("inspect", workbench::read_interval);
    let hours_per_day = option!("hours-per-day", workbench::read_hours);
    if let Some(file) = matches.get_one::<PathBuf>("ical")
        && file.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("ics"))
    {
        let message = upkeep::calendar_is_an_ics(&path_text(file), language);
        faults.push(option_fault("ical", (message, None), as_json, language));
    }
    // The clock says nothing else than that a delivery has not been yet.
    if let Some(delivered) = delivered
        && let Some(today) = today.map_or_else(|| before(delivered), |today| (delivered > today).then_some(today))
    {
        let message =
            upkeep::delivered_in_the_future(&upkeep::date_text(delivered), &upkeep::date_text(today), language);
        let hint = upkeep::give_today(language).to_owned();
        faults.push(option_fault("delivered", (message, Some(hint)), as_json, language));
    }
    match (code, delivered) {
        (Some((code, _)), _) if workbench::sheet(&code).is_none() => {
            faults.push(refuse(&workbench::Refusal::NoData, as_json, language));
            Err(faults)
        }
        (Some((code, talk)), Some(delivered)) if faults.is_empty() => {
            Ok((code, UpkeepAsked { delivered, storage, hours_per_day, inspect, today }, talk))
        }
        _ => Err(faults),
    }
}

/// The day of the clock where another has not come yet anywhere on earth: far east of here it may be tomorrow.
fn before(day: workbench::Date) -> Option<workbench::Date> {
    let days = SystemTime::now().duration_since(UNIX_EPOCH).ok()?.as_secs() / DAY_S;
    let tomorrow = workbench::day_of_clock(days + 1)?;
    if day > tomorrow { workbench::day_of_clock(days) } else { None }
}

fn text(record: &workbench::answers::Upkeep, language: Language) -> String {
    let text = shown(&chapter::upkeep(record, language), language);
    record.calendar.as_ref().map_or_else(|| text.clone(), |file| format!("{text}\n{file}\n"))
}
