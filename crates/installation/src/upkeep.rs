//! Storage, upkeep, shutting down and disposal of an actuator: a plan with dates, and what the manual says about each.

use crate::calendar::Interval;
use crate::facts::{Order, facts_about};
use actuator::{BatteryFault, BatteryLife};
use catalogue::{Fact, Step, Topic};
use chrono::{Days, NaiveDate};
use order_code::OrderCode;
use provenance::{Datum, Grade, Source};
use quantities::unit::{DAY, YEAR};
use quantities::{Measure, Time, identified};

/// How long an actuator is stored before it goes into service.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// For a time after its delivery.
    For(Interval),
    /// Until a day.
    Until(NaiveDate),
}

/// What is asked beside the ordering code.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UpkeepAsked {
    /// Day of delivery.
    pub delivered: NaiveDate,
    /// Storage before service; none without.
    pub storage: Option<Storage>,
    /// Operation on a day, for the life of a battery.
    pub hours_per_day: Option<Time>,
    /// Interval of what the manual wants to be done regularly.
    pub inspect: Option<Interval>,
    /// Day that the plan is looked at from.
    pub today: Option<NaiveDate>,
}

identified! {
    /// Something that is to be done or ends.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Task {
        /// The permitted storage ends.
        StorageEnd = "storage_end",
        /// The surfaces that give off the heat are cleaned.
        Cleaning = "cleaning",
        /// Cables and drag chain are inspected.
        Cables = "cables",
        /// The protective earth is inspected.
        ProtectiveEarth = "protective_earth",
        /// The screws of housing and load are checked.
        Screws = "screws",
        /// The radial shaft seals and what stands or lies on them.
        Seals = "seals",
        /// The exchange of the encoder that is recommended.
        EncoderRecommended = "encoder_recommended",
        /// The battery of the encoder is used up, by the model.
        BatteryEmpty = "battery_empty",
        /// The encoder must be exchanged at the latest.
        EncoderLatest = "encoder_latest",
    }
}

impl Task {
    /// The fact that it rests on.
    const fn fact(self) -> &'static str {
        match self {
            Self::StorageEnd => "storage",
            Self::Cleaning => "clean_the_heat_path",
            Self::Cables => "inspect_cables",
            Self::ProtectiveEarth => "inspect_protective_earth",
            Self::Screws => "inspect_screws",
            Self::Seals => "no_standing_film",
            Self::EncoderRecommended => "encoder_exchange_recommended",
            Self::BatteryEmpty => "battery_not_exchangeable",
            Self::EncoderLatest => "encoder_exchange_latest",
        }
    }
}

identified! {
    /// How binding a date is.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Rule {
        /// Not after this date.
        AtTheLatest = "at_the_latest",
        /// On this date, by recommendation.
        Recommended = "recommended",
        /// Estimated to happen on this date.
        Estimated = "estimated",
        /// At intervals.
        Every = "every",
        /// At intervals, which must not be longer.
        EveryAtMost = "every_at_most",
    }
}

/// A line of the plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Planned {
    /// What.
    pub task: Task,
    /// How binding.
    pub rule: Rule,
    /// Interval of a series.
    pub interval: Option<Interval>,
    /// The day that a series is counted from.
    pub counted_from: NaiveDate,
    /// The date; of a series the first.
    pub first: NaiveDate,
    /// Of a series the first date that is not before today, if today is stated.
    pub next: NaiveDate,
    /// Whether it lies before today, if today is stated.
    pub passed: bool,
    /// The fact that it rests on.
    pub fact: &'static Fact,
    /// How far the date can be trusted; `None` where it follows from an interval that the user states.
    pub grade: Option<Grade>,
    /// Model that the date is from, where it is one.
    pub model: Option<Source>,
}

/// An assumption.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlanNote {
    /// No storage was stated: service begins on the day of delivery.
    NoStorageStated,
    /// The storage is longer than permitted.
    StorageTooLong,
    /// The interval of what is done regularly was not stated: a year is assumed.
    IntervalAssumed,
    /// The cleaning stays at its printed interval, which is shorter than the one stated.
    CleaningStaysShorter,
    /// The hours of operation on a day were not stated: the life of the battery is not computed.
    HoursNotStated,
    /// Hours of operation were stated for a feedback that has no battery.
    NoBattery,
    /// The ten years end before the battery does.
    BatteryOutlivesEncoder,
    /// The manual has no interval for the seals.
    SealIntervalNotStated,
    /// The manual has no interval for renewing the grease in service.
    GreaseIntervalNotStated,
}

/// The plan of one actuator, and what the manual says about each phase of its life.
#[derive(Clone, Debug, PartialEq)]
pub struct Upkeep {
    /// The ordering code.
    pub code: OrderCode,
    /// Day of delivery.
    pub delivered: NaiveDate,
    /// Day on which service begins.
    pub in_service: NaiveDate,
    /// Day that the plan is looked at from.
    pub today: Option<NaiveDate>,
    /// Whether the storage is within what is permitted.
    pub storage_permitted: bool,
    /// The plan, by date.
    pub plan: Vec<Planned>,
    /// Life of the battery of the encoder; not applicable without one, not printed where the hours are not stated.
    pub battery: Datum<BatteryLife>,
    /// The assumptions, with their consequences.
    pub notes: Vec<PlanNote>,
    /// Transport and storage.
    pub storage: Vec<&'static Fact>,
    /// In service.
    pub service: Vec<&'static Fact>,
    /// Shutting down, in the order of the steps.
    pub shutdown: Vec<&'static Fact>,
    /// Disposal.
    pub disposal: Vec<&'static Fact>,
}

/// Why there is no plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum UpkeepFault {
    /// The storage ends before the delivery.
    StorageBeforeDelivery {
        /// End of the storage.
        until: NaiveDate,
        /// Day of delivery.
        delivered: NaiveDate,
    },
    /// Outside the model of the battery.
    Battery(BatteryFault),
    /// A date of the plan lies beyond the calendar.
    BeyondTheCalendar,
}

/// Before the step that parts the connections come the five safety rules.
const ISOLATE: (&str, &str) = ("isolate_before_work", "shutdown_discharge");

/// Default interval of regular work: that of the cleaning.
const INSPECT_ASSUMED: Interval = Interval::Months(12);

/// The plan of an actuator.
///
/// # Source
/// cha-manual sections 6.22.4, 9.1, 9.8 and chapter 10; docs/theory/battery.md
/// # Errors
/// [`UpkeepFault`] where there is none.
pub fn upkeep(code: &OrderCode, asked: &UpkeepAsked) -> Result<Upkeep, UpkeepFault> {
    let delivered = asked.delivered;
    let beyond = UpkeepFault::BeyondTheCalendar;
    let in_service = match asked.storage {
        None => delivered,
        Some(Storage::For(interval)) => interval.after(delivered, 1).ok_or(beyond)?,
        Some(Storage::Until(until)) if until >= delivered => until,
        Some(Storage::Until(until)) => return Err(UpkeepFault::StorageBeforeDelivery { until, delivered }),
    };
    let mut plan = Plan { today: asked.today, in_service, lines: Vec::new(), notes: Vec::new() };
    if asked.storage.is_none() {
        plan.notes.push(PlanNote::NoStorageStated);
    }
    let mut storage_permitted = true;
    if let Some(end) = years_of("storage", "duration").and_then(|years| years.after(delivered, 1)) {
        storage_permitted = in_service <= end;
        // It concerns an actuator that is stored, and no longer one in service.
        if asked.storage.is_some() && asked.today.is_none_or(|today| today < in_service) {
            plan.once(Task::StorageEnd, Rule::AtTheLatest, end);
        }
    }
    if !storage_permitted {
        plan.notes.push(PlanNote::StorageTooLong);
    }
    plan.regularly(asked.inspect)?;
    let battery = plan.battery(code, asked)?;
    plan.notes.push(PlanNote::GreaseIntervalNotStated);
    // What is on the same day keeps the order of the tasks.
    plan.lines.sort_by_key(|line| line.next);
    let facts = facts_about(Topic::Upkeep, code, Order::Life);
    let of = |steps: &[Step]| -> Vec<&'static Fact> {
        let wanted = |fact: &&&Fact| fact.step.is_some_and(|step| steps.contains(&step)) && fact.id != ISOLATE.0;
        facts.iter().filter(wanted).copied().collect()
    };
    let mut shutdown = of(&[Step::Shutdown]);
    let place = shutdown.iter().position(|fact| fact.id == ISOLATE.1).unwrap_or(shutdown.len());
    shutdown.splice(place..place, facts.iter().find(|fact| fact.id == ISOLATE.0).copied());
    let [storage, disposal] = [Step::Transport, Step::Disposal].map(|step| of(&[step]));
    let elsewhere = [&storage, &shutdown, &disposal];
    let mut service: Vec<&'static Fact> = facts
        .iter()
        .filter(|fact| !elsewhere.iter().any(|facts| facts.iter().any(|other| other.id == fact.id)))
        .copied()
        .collect();
    service.sort_by_key(|fact| (fact.signal.is_none(), fact.signal));
    let Plan { lines, notes, .. } = plan;
    Ok(Upkeep {
        code: *code,
        delivered,
        in_service,
        today: asked.today,
        storage_permitted,
        plan: lines,
        battery,
        notes,
        storage,
        service,
        shutdown,
        disposal,
    })
}

/// A time that a fact states in years, as one of the calendar.
fn years_of(fact: &str, value: &str) -> Option<Interval> {
    let fact = catalogue::fact(fact)?;
    let value = fact.values.iter().find(|known| known.id == value)?;
    let years = (1..=100_u32).find(|years| (f64::from(*years) - value.number).abs() < 1e-9)?;
    (value.unit == YEAR.ascii).then_some(Interval::Months(12 * years))
}

/// A plan in the making.
struct Plan {
    today: Option<NaiveDate>,
    in_service: NaiveDate,
    lines: Vec<Planned>,
    notes: Vec<PlanNote>,
}

impl Plan {
    /// Something that happens once.
    fn once(&mut self, task: Task, rule: Rule, date: NaiveDate) {
        self.line(task, rule, None, (date, date), (Some(Grade::Printed), None));
    }

    fn line(
        &mut self,
        task: Task,
        rule: Rule,
        interval: Option<Interval>,
        (first, next): (NaiveDate, NaiveDate),
        (grade, model): (Option<Grade>, Option<Source>),
    ) {
        let Some(fact) = catalogue::fact(task.fact()) else { return };
        let passed = self.today.is_some_and(|today| next < today);
        let (grade, counted_from) = (grade.map(|grade| fact.grade.worst(grade)), self.in_service);
        self.lines.push(Planned { task, rule, interval, counted_from, first, next, passed, fact, grade, model });
    }

    /// What is done at intervals from the beginning of service on.
    fn regularly(&mut self, stated: Option<Interval>) -> Result<(), UpkeepFault> {
        let interval = stated.unwrap_or(INSPECT_ASSUMED);
        if stated.is_none() {
            self.notes.push(PlanNote::IntervalAssumed);
        }
        let yearly = years_of("clean_the_heat_path", "").unwrap_or(INSPECT_ASSUMED);
        let cleaning = yearly.shorter(interval, self.in_service);
        if interval.shorter(yearly, self.in_service) != interval {
            self.notes.push(PlanNote::CleaningStaysShorter);
        }
        // The interval comes from the user or is assumed; the manual states only that of the cleaning.
        let grade = stated.map_or(Some(Grade::Assumed), |_| None);
        let clean = if cleaning == yearly { (Rule::EveryAtMost, Some(Grade::Printed)) } else { (Rule::Every, grade) };
        let series = [
            (Task::Cleaning, clean.0, cleaning, clean.1),
            (Task::Cables, Rule::Every, interval, grade),
            (Task::ProtectiveEarth, Rule::Every, interval, grade),
            (Task::Screws, Rule::Every, interval, grade),
            (Task::Seals, Rule::Every, interval, grade),
        ];
        for (task, rule, interval, grade) in series {
            let beyond = UpkeepFault::BeyondTheCalendar;
            let first = interval.after(self.in_service, 1).ok_or(beyond)?;
            let from = self.today.unwrap_or(first);
            let next = interval.next(self.in_service, from).ok_or(beyond)?;
            self.line(task, rule, Some(interval), (first, next), (grade, None));
        }
        self.notes.push(PlanNote::SealIntervalNotStated);
        Ok(())
    }

    /// The encoder whose battery buffers its turns.
    fn battery(&mut self, code: &OrderCode, asked: &UpkeepAsked) -> Result<Datum<BatteryLife>, UpkeepFault> {
        let has_battery =
            catalogue::fact(Task::EncoderLatest.fact()).is_some_and(|fact| fact.holds_for.feedbacks == [code.feedback]);
        if !has_battery {
            if asked.hours_per_day.is_some() {
                self.notes.push(PlanNote::NoBattery);
            }
            return Ok(Datum::NotApplicable);
        }
        let from_delivery = |fact: &str| years_of(fact, "").and_then(|years| years.after(asked.delivered, 1));
        if let Some(date) = from_delivery(Task::EncoderRecommended.fact()) {
            self.once(Task::EncoderRecommended, Rule::Recommended, date);
        }
        if let Some(date) = from_delivery(Task::EncoderLatest.fact()) {
            self.once(Task::EncoderLatest, Rule::AtTheLatest, date);
        }
        let (Some(hours), Datum::Known(battery)) = (asked.hours_per_day, configurator::battery()) else {
            self.notes.push(PlanNote::HoursNotStated);
            return Ok(Datum::NotPrinted);
        };
        let stored = days_between(asked.delivered, self.in_service);
        let life = battery.value.life(hours, stored).map_err(UpkeepFault::Battery)?;
        if life.capped {
            self.notes.push(PlanNote::BatteryOutlivesEncoder);
        } else if let Some(end) = later(self.in_service, life.life.value) {
            let source = Some(life.life.source.clone());
            self.line(Task::BatteryEmpty, Rule::Estimated, None, (end, end), (Some(life.life.grade), source));
        }
        let (source, grade, errata) = (life.life.source.clone(), life.life.grade, life.life.errata);
        Ok(Datum::Known(provenance::Sourced { value: life, source, grade, errata }))
    }
}

/// The time from one day to a later one.
fn days_between(from: NaiveDate, to: NaiveDate) -> Time {
    let days = u32::try_from((to - from).num_days()).unwrap_or(0);
    Time::new_in(f64::from(days), &DAY)
}

/// The day that lies a time after another, whole days counted.
fn later(from: NaiveDate, time: Time) -> Option<NaiveDate> {
    // Far beyond any plan the calendar itself ends.
    let days = time.in_unit(&DAY).floor().clamp(0.0, 1e6) as u64;
    from.checked_add_days(Days::new(days))
}
