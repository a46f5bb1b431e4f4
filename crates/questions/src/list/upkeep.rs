//! `upkeep CODE`: maintenance of an actuator, tasks and dates.

use super::given::{arguments, code_among, one, some};
use super::{Answer, Argument, ArgumentKind, CODE, Entry, Gives, Inquiry, Reads, Record, Unanswered};
use crate::answer;
use crate::chapters::read_hours;
use crate::sheet::sheet;
use crate::sizing_use::Refusal;
use crate::upkeep::read_storage;
pub use crate::upkeep::{day_of_clock, read_date, read_interval, upkeep};
use answers::Fit;
use axis::AxisProject;
pub use chrono::NaiveDate as Date;
pub use installation::calendar::Interval;
use installation::upkeep::Storage;
pub use installation::upkeep::{Planned, Upkeep, UpkeepInputs};
use order_code::OrderCode;
use quantities::unit::DAY;
use quantities::{Measure, Time};
use words::help;
use words::help::values;

pub(super) const DELIVERED: Argument =
    Argument::option("delivered", values::date, help::upkeep_delivered).of(ArgumentKind::Date).required();
pub(super) const STORAGE: Argument = Argument::option("storage", values::interval, help::upkeep_storage);
pub(super) const HOURS: Argument = Argument::option("hours-per-day", values::hours, help::upkeep_hours).signed();
pub(super) const INSPECT: Argument = Argument::option("inspect", values::interval, help::upkeep_inspect);
pub(super) const TODAY: Argument = Argument::option("today", values::date, help::upkeep_today).of(ArgumentKind::Date);

arguments! {
    /// Arguments of `upkeep`: actuator and dates of its life.
    pub struct Args {
        /// Ordering code of the actuator.
        code: OrderCode = CODE => code_among,
        /// Day of delivery.
        delivered: Date = DELIVERED => one(read_date),
        /// Storage before service.
        storage: Option<Storage> = STORAGE => some(read_storage),
        /// Hours of operation per day.
        hours_per_day: Option<Time> = HOURS => some(read_hours),
        /// Interval of the tasks that the manual requires regularly.
        inspect: Option<Interval> = INSPECT => some(read_interval),
        /// Reference day.
        today: Option<Date> = TODAY => some(read_date),
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "upkeep",
    path: "upkeep",
    about: help::upkeep,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Upkeep>("upkeep")),
    writes: &[],
    example: "CHA-14A-50-E-M128S --delivered 2026-03-01 --storage \"6 months\" --hours-per-day 10",
    answer: Some(|inquiry| {
        let (_, found) = found(inquiry)?;
        Ok(Answer::record(&found).fits(found.verdict == Fit::Fits))
    }),
};

/// Returns the plan, and its record.
///
/// # Errors
/// Every fault of the arguments; a delivery in the future.
pub fn found(inquiry: &Inquiry<'_>) -> Result<(Upkeep, answers::Upkeep), Unanswered> {
    let language = inquiry.language;
    let Args { code, delivered, storage, hours_per_day, inspect, today } = Args::read(&inquiry.given)?;
    let earlier = |day: Date| (delivered > day).then_some(day);
    if let Some(now) = today.map_or_else(|| before(delivered, inquiry), earlier) {
        let [day, now] = [delivered, now].map(words::upkeep::date_text);
        let hint = words::upkeep::give_today(language).to_owned();
        let fault = (words::upkeep::delivered_in_the_future(&day, &now, language), Some(hint));
        return Err(Unanswered::option("delivered", fault));
    }
    if sheet(&code).is_none() {
        return Err(Refusal::NoData.into());
    }
    let question = UpkeepInputs { delivered, storage, hours_per_day, inspect, today };
    let plan = upkeep(&code, &question, language)
        .map_err(|(name, message, hint)| Unanswered::option(name, (message, hint)))?;
    let record = answer::upkeep(&plan, language);
    Ok((plan, record))
}

/// Returns the question about the maintenance of the actuator of a project: storage as it states it, and operation per day where
/// the encoder has a battery. A storage of a part of a day counts as a whole one.
#[must_use]
pub fn of_the_project(project: &AxisProject, code: &OrderCode, delivered: Date) -> UpkeepInputs {
    let asked = &project.axis.asked;
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a positive time; one beyond the calendar is refused"
    )]
    let days = |time: Time| Interval::Days(DAY.from_si(time.si()).ceil() as u32);
    UpkeepInputs {
        delivered,
        storage: asked.storage.map(|time| Storage::For(days(time))),
        hours_per_day: asked.operation_per_day.filter(|_| installation::upkeep::has_battery(code)),
        inspect: None,
        today: None,
    }
}

/// Returns the day of the clock if another day is in the future everywhere on earth: in the far east it may already be
/// tomorrow.
fn before(day: Date, inquiry: &Inquiry<'_>) -> Option<Date> {
    let days = inquiry.days_since_1970?;
    let tomorrow = day_of_clock(days.checked_add(1)?)?;
    if day > tomorrow { day_of_clock(days) } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The project states storage and operation: parts of a day count as a day, the operation only for a battery.
    #[test]
    fn storage_and_operation_are_those_of_the_project() {
        let of = |requirements: &str, code: &OrderCode| {
            let text = format!(
                "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n\
                 [[motion]]\nlaw = \"triangle\"\ndistance = \"360 deg\"\ntime = \"1 s\"\n[requirements]\n{requirements}\n"
            );
            let project = crate::read(&text).unwrap_or_else(|faults| panic!("{faults:?}"));
            of_the_project(&project, code, Date::MIN)
        };
        let codes = configurator::all().iter().map(|(code, _)| code);
        let (with, without): (Vec<&OrderCode>, Vec<&OrderCode>) =
            codes.partition(|code| installation::upkeep::has_battery(code));
        let stated = "storage = \"36 h\"\noperation_per_day = \"8 h\"";
        for (code, has_battery) in [(with[0], true), (without[0], false)] {
            let found = of(stated, code);
            assert_eq!(found.storage, Some(Storage::For(Interval::Days(2))), "{code}");
            let hours = found.hours_per_day.map(|time| time.si() / 3600.0);
            assert_eq!(hours, has_battery.then_some(8.0), "{code}");
            let bare = of("brake = true", code);
            assert_eq!((bare.storage, bare.hours_per_day.is_some()), (None, false), "{code}");
        }
    }
}
