//! `upkeep`: what is to be done with an actuator, and by when.

use crate::answer::{Answer, written};
use crate::code::{parse_for_use, read_argument};
use crate::facts::facts_text;
use crate::fault::{option_fault, path_text, text_option};
use crate::save::save;
use crate::subject::{refuse, refused_together};
use crate::table::{Align, Table, labelled, paragraph};
use clap::ArgMatches;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::{SystemTime, UNIX_EPOCH};
use workbench::answers::{Fact, Fit};
use workbench::quantities::unit::{HOUR, YEAR};
use workbench::quantities::{Measure, Time, format_significant};
use workbench::text::{grade_word, mounting, terminal, upkeep};
use workbench::{Language, OrderCode, UpkeepAsked};

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
    let data = if as_json { written(&record) } else { text(&plan, &record, language) };
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
    let hours_per_day = option!("hours-per-day", hours);
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

/// Hours a day; they may go without a unit: the option names it.
fn hours(text: &str, language: Language) -> Result<Time, (String, Option<String>)> {
    match text.trim().parse::<f64>() {
        Ok(hours) => Ok(Time::new_in(hours, &HOUR)),
        Err(_) => workbench::read_quantity(text, language),
    }
}

fn text(plan: &workbench::Upkeep, record: &workbench::answers::Upkeep, language: Language) -> String {
    let mut out = format!("{}\n", record.code);
    let mut head = upkeep::delivered_and_service(&record.delivered, &record.in_service, language);
    if let Some(today) = &record.today {
        let _ = write!(head, "; {}", upkeep::seen_from(today, language));
    }
    out.push_str(&paragraph("", &head));
    let _ = writeln!(out, "\n{}", upkeep::plan_head(language));
    let heads = [upkeep::date_head, upkeep::task_head, upkeep::rule_head, upkeep::rests_on];
    let mut table = Table::new(heads.map(|head| (head(language), Align::Left)));
    for line in &record.plan {
        let rule = if line.passed {
            format!("{}, {}", line.rule_text, upkeep::passed(language))
        } else {
            line.rule_text.clone()
        };
        let grade = line.grade.map_or_else(|| upkeep::as_stated(language), |grade| grade_word(*grade, language));
        let rests = format!("{grade}, {}", line.source);
        table.row([line.next.clone(), line.title.clone(), rule, rests]);
    }
    out.push_str(&table.render());
    if let Some(battery) = plan.battery.known() {
        let years = |time: Time| format_significant(time.in_unit(&YEAR), 3, language);
        let life = &battery.value;
        let grade = grade_word(life.life.grade, language);
        let told = terminal::battery(
            &years(life.life.value),
            &grade,
            &years(life.exchange_recommended),
            &years(life.exchange_latest),
            language,
        );
        out.push('\n');
        for line in told.lines() {
            out.push_str(&paragraph("", line));
        }
    }
    out.push('\n');
    for note in &record.notes {
        out.push_str(&labelled(terminal::note(language), note));
    }
    facts(&mut out, upkeep::storage_head(language), &record.storage, language);
    facts(&mut out, upkeep::service_head(language), &record.service, language);
    let _ = writeln!(out, "\n{}", upkeep::shutdown_head(language));
    for (number, fact) in record.shutdown.iter().enumerate() {
        let word = fact.signal.map(|signal| workbench::text::signal_word(*signal, language));
        let text = word.map_or_else(|| fact.text.to_owned(), |word| format!("{word}: {}", fact.text));
        out.push_str(&paragraph(&format!("{:>2}. ", number + 1), &format!("{text} ({})", fact.source)));
    }
    facts(&mut out, upkeep::disposal_head(language), &record.disposal, language);
    let _ = writeln!(out, "\n{}", mounting::errata_head(language));
    for erratum in &record.errata {
        out.push_str(&paragraph(&format!("* {}: ", erratum.id), &erratum.evidence));
    }
    if let Some(file) = &record.calendar {
        let _ = writeln!(out, "\n{file}");
    }
    out
}

fn facts(out: &mut String, head: &str, facts: &[Fact], language: Language) {
    let _ = writeln!(out, "\n{head}");
    out.push_str(&facts_text(facts, language));
}
