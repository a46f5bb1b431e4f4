//! The calendar file of a maintenance plan.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use quantities::Language;
use questions::list::upkeep::{UpkeepInputs, read_date, read_interval, upkeep};
use questions::{answer, read_code};

fn calendar(delivered: &str, inspect: &str, name: Option<&str>) -> String {
    let language = Language::En;
    let code = read_code("CHA-14A-50-E-M128S", language).unwrap().parsed.code;
    let asked = UpkeepInputs {
        delivered: read_date(delivered, language).unwrap(),
        storage: None,
        hours_per_day: None,
        inspect: Some(read_interval(inspect, language).unwrap()),
        today: None,
    };
    let plan = upkeep(&code, &asked, language).unwrap();
    tables::calendar(&plan, &answer::upkeep(&plan, language), name, language)
}

/// Joins continued lines: RFC 5545, 3.1.
fn unfolded(text: &str) -> Vec<String> {
    text.replace("\r\n ", "").lines().map(str::to_owned).collect()
}

/// Returns the values of a property in the order of the events.
fn values(text: &str, property: &str) -> Vec<String> {
    let value = |line: String| line.strip_prefix(property).map(|rest| rest.trim_start_matches(':').to_owned());
    unfolded(text).into_iter().filter_map(value).collect()
}

#[test]
fn the_same_plan_gives_the_same_bytes_and_nothing_of_the_clock() {
    let text = calendar("2026-03-01", "6 months", None);
    assert_eq!(text, calendar("2026-03-01", "6 months", None));
    let stamps = values(&text, "DTSTAMP");
    assert!(stamps.len() == 7 && stamps.iter().all(|stamp| stamp == "20260301T000000Z"), "{stamps:?}");
    let begin = text.lines().next();
    assert_eq!(begin, Some("BEGIN:VCALENDAR"));
    assert!(text.lines().all(|line| line.len() <= 75), "a line longer than 75 bytes");
    assert!(text.split("\r\n").all(|line| !line.contains('\n')), "an end of line without carriage return");
}

#[test]
fn each_event_has_an_identifier_of_its_own_that_stays() {
    let first = values(&calendar("2026-03-01", "6 months", None), "UID");
    let mut distinct = first.clone();
    distinct.sort();
    distinct.dedup();
    assert_eq!(distinct.len(), first.len());
    // Another interval is the same plan changed; another name or delivery is another plan.
    let sorted = |text: &str| {
        let mut found = values(text, "UID");
        found.sort();
        found
    };
    assert_eq!(sorted(&calendar("2026-03-01", "1 a", None)), distinct);
    for other in [calendar("2026-03-01", "6 months", Some("axis 3")), calendar("2026-03-02", "6 months", None)] {
        assert!(values(&other, "UID").iter().all(|uid| !first.contains(uid)));
    }
}

#[test]
fn a_series_repeats_and_a_date_does_not() {
    let text = calendar("2026-03-01", "6 months", None);
    // Cleaning, cables, protective earth, screws, seals; two replacements happen once. The storage has ended when the
    // actuator is in service.
    assert_eq!(values(&text, "RRULE"), vec!["FREQ=MONTHLY;INTERVAL=6"; 5]);
    assert_eq!(values(&text, "DTSTART;VALUE=DATE").len(), 7);
    assert_eq!(values(&calendar("2026-03-01", "90 d", None), "RRULE"), vec!["FREQ=DAILY;INTERVAL=90"; 5]);
}

/// A calendar omits a month that lacks the day, unless the rule selects the last one (RFC 5545, 3.3.10).
#[test]
fn the_end_of_a_month_stays_the_end_of_a_month() {
    let text = calendar("2026-08-31", "6 months", None);
    let rule = "FREQ=MONTHLY;INTERVAL=6;BYMONTHDAY=28,29,30,31;BYSETPOS=-1";
    assert!(values(&text, "RRULE").iter().all(|found| found == rule), "{text}");
    assert!(values(&text, "DTSTART;VALUE=DATE").iter().filter(|date| *date == "20270228").count() == 5, "{text}");
}

#[test]
fn a_name_with_signs_of_the_format_is_escaped() {
    let text = calendar("2026-03-01", "1 a", Some("axis 3; left, upper\\lower"));
    let summaries = values(&text, "SUMMARY");
    assert!(summaries.iter().all(|line| line.starts_with("axis 3\\; left\\, upper\\\\lower (CHA-")), "{summaries:?}");
}
