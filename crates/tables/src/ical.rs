//! A plan of upkeep as an iCalendar file (RFC 5545).

use answers::Id;
use chrono::{Datelike, NaiveTime};
use icalendar::{Calendar, Component, Event, EventLike, Property};
use quantities::Language;
use questions::list::upkeep::{Interval, Planned, Upkeep};
use words::upkeep;

/// The plan as the text of an iCalendar file: an event of a whole day for each line, a series for what is done at intervals.
///
/// The same plan gives the same bytes: the stamp of an event is the day that the plan is looked at from, else the day of
/// delivery, and its identifier follows from code, delivery, name and task, so that a calendar which has read an earlier plan
/// takes the new one in its place.
#[must_use]
pub fn calendar(plan: &Upkeep, record: &answers::Upkeep, name: Option<&str>, language: Language) -> String {
    let subject = name.map_or_else(|| record.code.clone(), |name| format!("{name} ({})", record.code));
    let mut calendar = Calendar::empty();
    calendar.append_property(Property::new("VERSION", "2.0"));
    calendar.append_property(Property::new("PRODID", "-//antrieb//upkeep//EN"));
    calendar.append_property(Property::new("CALSCALE", "GREGORIAN"));
    calendar.name(&upkeep::calendar_of(&subject, language));
    let stamp = plan.today.unwrap_or(plan.delivered).and_time(NaiveTime::MIN).and_utc();
    let identity = format!("{}\n{}\n{}", record.code, record.delivered, name.unwrap_or_default());
    for (line, texts) in plan.plan.iter().zip(&record.plan) {
        let mut event = Event::new();
        event
            .uid(&identifier(&identity, texts.task))
            .timestamp(stamp)
            .starts(line.first)
            .summary(&format!("{subject}: {}", texts.title))
            .description(&format!("{}\n{}\n{}", texts.rule_text, texts.text, texts.source))
            .add_property("TRANSP", "TRANSPARENT");
        if let Some(rule) = series(line) {
            event.add_property("RRULE", rule);
        }
        calendar.push(event.done());
    }
    calendar.to_string()
}

/// The permanent identifier of an event.
fn identifier(identity: &str, task: Id<impl answers::Identified>) -> String {
    let hash = blake3::hash(identity.as_bytes()).to_hex();
    let hash: String = hash.chars().take(32).collect();
    format!("{hash}-{}@antrieb", task.0.id())
}

/// The rule of a series. A day that a month lacks is its last one, as in the plan; without a word a calendar would leave
/// such a month out.
fn series(line: &Planned) -> Option<String> {
    Some(match line.interval? {
        Interval::Days(days) => format!("FREQ=DAILY;INTERVAL={days}"),
        Interval::Months(months) => {
            let day = line.counted_from.day();
            let clamped = if day > 28 {
                let days: Vec<String> = (28..=day).map(|day| day.to_string()).collect();
                format!(";BYMONTHDAY={};BYSETPOS=-1", days.join(","))
            } else {
                String::new()
            };
            format!("FREQ=MONTHLY;INTERVAL={months}{clamped}")
        }
    })
}
