//! Words for storage, maintenance, shutting down and disposal.

use super::battery_fault;
use crate::pick;
use crate::texts::{said, texts};
use chrono::NaiveDate;
use installation::calendar::{DateFault, INTERVAL_MOST_YEARS, Interval, IntervalFault, YEARS};
use installation::upkeep::{DateRule, PlanNote, Task, UpkeepFault};
use quantities::Language;

/// A day of a record as the language writes it: `2026-03-01` is 01.03.2026 in German.
#[must_use]
pub fn date_shown(day: &str, language: Language) -> String {
    let mut parts = day.splitn(3, '-');
    match (language, parts.next(), parts.next(), parts.next()) {
        (Language::De, Some(year), Some(month), Some(day)) => format!("{day}.{month}.{year}"),
        _ => day.to_owned(),
    }
}

/// A day as records and files have it: `2026-03-01`.
#[must_use]
pub fn date_text(date: NaiveDate) -> String {
    date.format("%Y-%m-%d").to_string()
}

/// Returns the title of a task.
#[must_use]
pub fn task_title(task: Task, language: Language) -> String {
    let (en, de) = match task {
        Task::StorageEnd => ("permissible storage ends", "zulässige Lagerung endet"),
        Task::Cleaning => ("clean housing and mounting plate", "Gehäuse und Montageplatte reinigen"),
        Task::Cables => ("inspect cables and cable carrier", "Leitungen und Energiekette kontrollieren"),
        Task::ProtectiveEarth => ("inspect the protective earth", "Schutzleiter kontrollieren"),
        Task::Screws => ("check the screws of housing and load", "Schrauben von Gehäuse und Last kontrollieren"),
        Task::Seals => ("visually inspect the shaft seals", "Wellendichtungen sichtprüfen"),
        Task::EncoderRecommended => ("recommended replacement of the encoder", "empfohlener Austausch des Gebers"),
        Task::BatteryEmpty => ("encoder battery discharged", "Geberbatterie entladen"),
        Task::EncoderLatest => ("replacement of the encoder, at the latest", "Austausch des Gebers, spätestens"),
    };
    pick(language, en, de).to_owned()
}

/// Returns the obligation of a date, with the interval of a series.
#[must_use]
pub fn rule_text(rule: DateRule, interval: Option<Interval>, language: Language) -> String {
    let every = interval.map(|interval| every(interval, language)).unwrap_or_default();
    match rule {
        DateRule::AtTheLatest => said!(language => "at the latest" | "spätestens"),
        DateRule::Recommended => said!(language => "recommended" | "empfohlen"),
        DateRule::Estimated => said!(language => "estimated" | "geschätzt"),
        DateRule::Every => every,
        DateRule::EveryAtMost => said!(language => "at least {every}" | "mindestens {every}"),
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

/// Returns an assumption of the plan, with its consequences.
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

/// Returns the fault of a date and the remedy.
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

/// Returns the fault of an interval and the remedy.
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

/// Returns the reason why there is no plan: the option concerned, the fault and the remedy.
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
    title(code) = "Maintenance of {code}" | "Wartung von {code}";
    date_form = "format of a date: 2026-03-01" | "Format eines Datums: 2026-03-01";
    date_out_of_range(date, from, to) =
        "{date} is outside the years {from} to {to}"
        | "{date} liegt außerhalb der Jahre {from} bis {to}";
    delivered_in_the_future(date, today) =
        "{date} is in the future, today is {today}"
        | "{date} liegt in der Zukunft, heute ist {today}";
    give_today =
        "a plan begins with the delivery; use --today DATE for a later reference date"
        | "ein Plan beginnt mit der Lieferung; mit --today DATUM ein späteres Bezugsdatum angeben";
    interval_without_number(written) =
        "`{written}` does not begin with a whole number above zero"
        | "„{written}“ beginnt nicht mit einer ganzen Zahl über null";
    interval_without_unit(written) = "the unit is missing after `{written}`" | "nach „{written}“ fehlt die Einheit";
    interval_of_unknown_unit(unit) = "`{unit}` is not a unit of an interval" | "„{unit}“ ist keine Einheit eines Intervalls";
    interval_too_long(written, most) =
        "`{written}` is longer than {most} years"
        | "„{written}“ ist länger als {most} Jahre";
    interval_form =
        "write years (a), months, weeks or days (d): `6 months`, `1 a`"
        | "Jahre (a), Monate, Wochen oder Tage (d) schreiben: „6 Monate“, „1 a“";
    storage_before_delivery(until, delivered) =
        "the storage ends on {until}, before the delivery on {delivered}"
        | "die Lagerung endet am {until}, vor der Lieferung am {delivered}";
    beyond_the_calendar = "the plan extends beyond the calendar" | "der Plan reicht über den Kalender hinaus";
    no_storage_stated =
        "no storage stated: operation assumed to begin on the date of delivery (--storage)"
        | "keine Lagerung angegeben: Betriebsbeginn am Tag der Lieferung angenommen (--storage)";
    storage_too_long =
        "the storage period exceeds the limit of the manual: the service life of the grease may be reduced; ask the manufacturer before commissioning"
        | "die Lagerdauer überschreitet die Grenze der Anleitung: die Gebrauchsdauer des Fetts kann verkürzt sein; vor der Inbetriebnahme beim Hersteller erfragen";
    interval_assumed =
        "the manual requires regular inspections without stating an interval: one year assumed, as stated for cleaning (--inspect)"
        | "für Kontrollen nennt die Anleitung nur „regelmäßig“: angenommen ist ein Jahr wie für die Reinigung (--inspect)";
    cleaning_stays_shorter =
        "cleaning remains at the interval of one year stated in the manual; the given interval is longer"
        | "für die Reinigung gilt weiterhin ein Jahr laut Anleitung; das angegebene Intervall ist länger";
    hours_not_stated =
        "life of the encoder battery not checked: the hours of operation per day are missing (--hours-per-day)"
        | "Lebensdauer der Geberbatterie nicht geprüft: die Betriebsstunden je Tag fehlen (--hours-per-day)";
    no_battery =
        "--hours-per-day has no effect: this encoder has no battery"
        | "--hours-per-day bleibt ohne Wirkung: dieser Geber hat keine Batterie";
    battery_outlives_encoder =
        "according to the model, the battery life exceeds the ten years after which the encoder must be replaced"
        | "nach dem Modell ist die Lebensdauer der Batterie länger als die zehn Jahre, nach denen der Geber spätestens zu ersetzen ist";
    seal_interval_not_stated =
        "the manual states no inspection interval for the seals; they must be kept free of standing liquid and abrasive particles; the dates are those of the other inspections"
        | "die Anleitung nennt kein Kontrollintervall für die Dichtungen; sie sind frei von stehender Flüssigkeit und abrasiven Partikeln zu halten; die Termine sind die der übrigen Kontrollen";
    grease_interval_not_stated =
        "grease replacement during operation: not stated in the manual"
        | "Fettwechsel im Betrieb: in der Anleitung nicht angegeben";
    delivered_and_service(delivered, service) =
        "delivered {delivered}, in operation from {service}"
        | "geliefert {delivered}, in Betrieb ab {service}";
    seen_from(today) = "as of {today}" | "Stand {today}";
    plan_head = "plan" | "Plan";
    date_head = "date" | "Datum";
    task_head = "task" | "Tätigkeit";
    rule_head = "interval" | "Frist";
    rests_on = "based on" | "Grundlage";
    as_stated = "as stated (--inspect)" | "wie angegeben (--inspect)";
    passed = "overdue" | "überschritten";
    storage_head = "transport and storage" | "Transport und Lagerung";
    service_head = "in operation" | "im Betrieb";
    shutdown_head = "shutdown, in this order" | "Stillsetzen, in dieser Reihenfolge";
    disposal_head = "disposal" | "Entsorgung";
    calendar_of(code) = "maintenance of {code}" | "Wartung von {code}";
    calendar_is_an_ics(display) =
        "a calendar is an iCalendar file: specify a file name ending in .ics, not {display}"
        | "ein Kalender ist eine iCalendar-Datei: einen Dateinamen mit der Endung .ics angeben, nicht {display}";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_day_is_written_as_the_language_has_it() {
        assert_eq!(date_shown("2026-03-01", Language::De), "01.03.2026");
        assert_eq!(date_shown("2026-03-01", Language::En), "2026-03-01");
        assert_eq!(date_shown("2026", Language::De), "2026");
    }
}
