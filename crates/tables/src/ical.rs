//! Maintenance plan as an iCalendar file (RFC 5545).

use answers::Id;
use chrono::{Datelike, NaiveTime};
use icalendar::{Calendar, Component, Event, EventLike, Property};
use quantities::Language;
use questions::list::upkeep::{Interval, Planned, Upkeep};
use words::upkeep;

/// Writes the plan as the text of an iCalendar file: an all-day event for each line, a series for a task at intervals.
///
/// Equal plans give equal bytes: the stamp of an event is the reference date of the plan, else the date of delivery,
/// and its identifier follows from code, delivery, name and task, so that a calendar which has read an earlier plan
/// replaces it with the new one.
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

/// Returns the permanent identifier of an event.
fn identifier(identity: &str, task: Id<impl answers::Identified>) -> String {
    let hash = blake3::hash(identity.as_bytes()).to_hex();
    let hash: String = hash.chars().take(32).collect();
    format!("{hash}-{}@antrieb", task.0.id())
}

/// Returns the recurrence rule of a series. A day that a month lacks becomes its last one, as in the plan; by default a
/// calendar would skip such a month.
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
