//! Words about storage, upkeep, shutting down and disposal.

use super::battery_fault;
use crate::pick;
use crate::texts::{said, texts};
use chrono::NaiveDate;
use installation::calendar::{DateFault, INTERVAL_MOST_YEARS, Interval, IntervalFault, YEARS};
use installation::upkeep::{PlanNote, Rule, Task, UpkeepFault};
use quantities::Language;

/// A day, as every language reads it without doubt: `2026-03-01`.
#[must_use]
pub fn date_text(date: NaiveDate) -> String {
    date.format("%Y-%m-%d").to_string()
}

/// What is to be done.
#[must_use]
pub fn task_title(task: Task, language: Language) -> String {
    let (en, de) = match task {
        Task::StorageEnd => ("permitted storage ends", "zulässige Lagerung endet"),
        Task::Cleaning => ("clean housing and mounting plate", "Gehäuse und Montageplatte reinigen"),
        Task::Cables => ("inspect cables and drag chain", "Kabel und Energiekette kontrollieren"),
        Task::ProtectiveEarth => ("inspect the protective earth", "Schutzleiter kontrollieren"),
        Task::Screws => ("check the screws of housing and load", "Schrauben von Gehäuse und Last kontrollieren"),
        Task::Seals => ("look at the shaft seals", "Wellendichtungen ansehen"),
        Task::EncoderRecommended => ("exchange of the encoder, recommended", "Tausch des Gebers, empfohlen"),
        Task::BatteryEmpty => ("battery of the encoder used up", "Batterie des Gebers verbraucht"),
        Task::EncoderLatest => ("exchange of the encoder, at the latest", "Tausch des Gebers, spätestens"),
    };
    pick(language, en, de).to_owned()
}

/// How binding a date is, with the interval of a series.
#[must_use]
pub fn rule_text(rule: Rule, interval: Option<Interval>, language: Language) -> String {
    let every = interval.map(|interval| every(interval, language)).unwrap_or_default();
    match rule {
        Rule::AtTheLatest => said!(language => "at the latest" | "spätestens"),
        Rule::Recommended => said!(language => "recommended" | "empfohlen"),
        Rule::Estimated => said!(language => "estimated" | "geschätzt"),
        Rule::Every => every,
        Rule::EveryAtMost => said!(language => "at least {every}" | "mindestens {every}"),
    }
}

fn every(interval: Interval, language: Language) -> String {
    let (count, [one_en, one_de, many_en, many_de]) = match interval {
        Interval::Months(months) if months % 12 == 0 => (months / 12, ["every year", "jedes Jahr", "years", "Jahre"]),
        Interval::Months(months) => (months, ["every month", "jeden Monat", "months", "Monate"]),
        Interval::Days(days) if days % 7 == 0 => (days / 7, ["every week", "jede Woche", "weeks", "Wochen"]),
        Interval::Days(days) => (days, ["every day", "jeden Tag", "days", "Tage"]),
    };
    match count {
        1 => pick(language, one_en, one_de).to_owned(),
        count => said!(language => "every {count} {many_en}" | "alle {count} {many_de}"),
    }
}

/// The assumptions, with their consequences.
#[must_use]
pub const fn plan_note(note: PlanNote, language: Language) -> &'static str {
    match note {
        PlanNote::NoStorageStated => crate::upkeep::no_storage_stated(language),
        PlanNote::StorageTooLong => crate::upkeep::storage_too_long(language),
        PlanNote::IntervalAssumed => crate::upkeep::interval_assumed(language),
        PlanNote::CleaningStaysShorter => crate::upkeep::cleaning_stays_shorter(language),
        PlanNote::HoursNotStated => crate::upkeep::hours_not_stated(language),
        PlanNote::NoBattery => crate::upkeep::no_battery(language),
        PlanNote::BatteryOutlivesEncoder => crate::upkeep::battery_outlives_encoder(language),
        PlanNote::SealIntervalNotStated => crate::upkeep::seal_interval_not_stated(language),
        PlanNote::GreaseIntervalNotStated => crate::upkeep::grease_interval_not_stated(language),
    }
}

/// What is wrong with a date, and what would be right.
#[must_use]
pub fn date_fault(fault: &DateFault, language: Language) -> (String, Option<String>) {
    match fault {
        DateFault::NoDate { written } => {
            (crate::terminal::not_a_date(written, language), Some(crate::upkeep::date_form(language).to_owned()))
        }
        DateFault::OutOfRange { date } => {
            (crate::upkeep::date_out_of_range(&date_text(*date), &YEARS.0, &YEARS.1, language), None)
        }
    }
}

/// What is wrong with an interval, and what would be right.
#[must_use]
pub fn interval_fault(fault: &IntervalFault, language: Language) -> (String, Option<String>) {
    let message = match fault {
        IntervalFault::NoWholeNumber { written } => crate::upkeep::interval_without_number(written, language),
        IntervalFault::UnitMissing { written } => crate::upkeep::interval_without_unit(written, language),
        IntervalFault::UnitUnknown { unit } => crate::upkeep::interval_of_unknown_unit(unit, language),
        IntervalFault::TooLong { written } => crate::upkeep::interval_too_long(written, &INTERVAL_MOST_YEARS, language),
    };
    (message, Some(crate::upkeep::interval_form(language).to_owned()))
}

/// Why there is no plan: the option concerned, what is wrong, and what would be right.
#[must_use]
pub fn upkeep_fault(fault: &UpkeepFault, language: Language) -> (&'static str, String, Option<String>) {
    match fault {
        UpkeepFault::StorageBeforeDelivery { until, delivered } => (
            "storage",
            crate::upkeep::storage_before_delivery(&date_text(*until), &date_text(*delivered), language),
            None,
        ),
        UpkeepFault::Battery(fault) => {
            let option = match fault {
                actuator::BatteryFault::OperationOutOfRange { .. } => "hours-per-day",
                actuator::BatteryFault::StorageOutOfRange { .. } => "storage",
            };
            (option, battery_fault(fault, language), None)
        }
        UpkeepFault::BeyondTheCalendar => ("delivered", crate::upkeep::beyond_the_calendar(language).to_owned(), None),
    }
}

texts! {
    title(code) = "Upkeep of {code}" | "Wartung von {code}";
    date_form = "a date is written 2026-03-01" | "ein Datum wird 2026-03-01 geschrieben";
    date_out_of_range(date, from, to) =
        "{date} is outside the years {from} to {to}"
        | "{date} liegt außerhalb der Jahre {from} bis {to}";
    delivered_in_the_future(date, today) =
        "{date} is in the future, today is {today}"
        | "{date} liegt in der Zukunft, heute ist {today}";
    give_today =
        "a plan begins with the delivery; --today DATE looks ahead"
        | "ein Plan beginnt mit der Lieferung; --today DATUM blickt voraus";
    interval_without_number(written) =
        "`{written}` does not begin with a whole number above zero"
        | "„{written}“ beginnt nicht mit einer ganzen Zahl über null";
    interval_without_unit(written) = "the unit is missing after `{written}`" | "nach „{written}“ fehlt die Einheit";
    interval_of_unknown_unit(unit) = "`{unit}` is no unit of an interval" | "„{unit}“ ist keine Einheit eines Intervalls";
    interval_too_long(written, most) =
        "`{written}` is longer than {most} years"
        | "„{written}“ ist länger als {most} Jahre";
    interval_form =
        "write years (a), months, weeks or days (d): `6 months`, `1 a`"
        | "Jahre (a), Monate, Wochen oder Tage (d) schreiben: „6 Monate“, „1 a“";
    storage_before_delivery(until, delivered) =
        "the storage ends on {until}, before the delivery on {delivered}"
        | "die Lagerung endet am {until}, vor der Lieferung am {delivered}";
    beyond_the_calendar = "the plan leaves the calendar" | "der Plan reicht über den Kalender hinaus";
    no_storage_stated =
        "no storage stated: service is taken to begin on the day of delivery (--storage)"
        | "keine Lagerung angegeben: der Betrieb beginnt angenommen am Tag der Lieferung (--storage)";
    storage_too_long =
        "the storage is longer than the manual permits: the grease may have lost life; ask the maker before the actuator goes into service"
        | "die Lagerung ist länger als die Anleitung zulässt: das Fett kann an Gebrauchsdauer verloren haben; vor der Inbetriebnahme beim Hersteller nachfragen";
    interval_assumed =
        "for inspections the manual says regularly only: a year is assumed, its latest for cleaning (--inspect)"
        | "für Kontrollen sagt die Anleitung nur „regelmäßig“: angenommen ist ein Jahr, ihre Frist für das Reinigen (--inspect)";
    cleaning_stays_shorter =
        "the cleaning stays at the year that the manual states; the interval given is longer"
        | "das Reinigen bleibt bei dem Jahr, das die Anleitung nennt; das angegebene Intervall ist länger";
    hours_not_stated =
        "life of the encoder's battery not checked: the hours of operation a day are missing (--hours-per-day)"
        | "Lebensdauer der Geberbatterie nicht geprüft: die Betriebsstunden je Tag fehlen (--hours-per-day)";
    no_battery =
        "--hours-per-day has no effect: this feedback has no battery"
        | "--hours-per-day bleibt ohne Wirkung: dieses Feedback hat keine Batterie";
    battery_outlives_encoder =
        "by the model the battery outlives the ten years after which the encoder must be exchanged"
        | "nach dem Modell hält die Batterie länger als die zehn Jahre, nach denen der Geber spätestens zu tauschen ist";
    seal_interval_not_stated =
        "the manual does not ask to look at the seals at intervals, only to keep them free of standing liquid and abrasive particles; the dates are those of the inspections"
        | "die Anleitung verlangt keine Kontrolle der Dichtungen in Intervallen, nur dass weder Flüssigkeit auf ihnen steht noch abrasive Teilchen sie erreichen; die Termine sind die der Kontrollen";
    grease_interval_not_stated =
        "renewing the grease in service: not stated in the manual"
        | "Erneuern des Fetts im Betrieb: in der Anleitung nicht angegeben";
    delivered_and_service(delivered, service) =
        "delivered {delivered}, in service from {service}"
        | "geliefert {delivered}, in Betrieb ab {service}";
    seen_from(today) = "seen from {today}" | "Stand {today}";
    plan_head = "plan" | "Plan";
    date_head = "date" | "Datum";
    task_head = "what" | "was";
    rule_head = "rule" | "Regel";
    rests_on = "rests on" | "beruht auf";
    as_stated = "as stated (--inspect)" | "wie angegeben (--inspect)";
    passed = "passed" | "überschritten";
    storage_head = "transport and storage" | "Transport und Lagerung";
    service_head = "in service" | "im Betrieb";
    shutdown_head = "shutting down, in this order" | "Stillsetzen, in dieser Reihenfolge";
    disposal_head = "disposal" | "Entsorgung";
    calendar_of(code) = "upkeep of {code}" | "Wartung von {code}";
    calendar_is_an_ics(display) =
        "a calendar is an iCalendar file: name one that ends in .ics, not {display}"
        | "ein Kalender ist eine iCalendar-Datei: eine mit der Endung .ics nennen, nicht {display}";
}
