//! Storage, maintenance, shutdown and disposal of an actuator: a plan with dates, and the facts of the manual on each
//! phase.

use crate::calendar::Interval;
use crate::facts::{Order, facts_about};
use actuator::{BatteryFault, BatteryLife};
use catalogue::{Fact, LifeStep, Topic};
use chrono::{Days, NaiveDate};
use order_code::OrderCode;
use provenance::{Datum, Grade, Source};
use quantities::unit::{DAY, YEAR};
use quantities::{Measure, Time, identified};

/// Storage of an actuator before its commissioning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// Duration after delivery.
    For(Interval),
    /// End date of the storage.
    Until(NaiveDate),
}

/// Options of a maintenance request in addition to the ordering code.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UpkeepInputs {
    /// Date of delivery.
    pub delivered: NaiveDate,
    /// Storage before commissioning, if any.
    pub storage: Option<Storage>,
    /// Operation per day, for the life of a battery.
    pub hours_per_day: Option<Time>,
    /// Interval of regular work for which the manual states none.
    pub inspect: Option<Interval>,
    /// Reference date of the plan.
    pub today: Option<NaiveDate>,
}

identified! {
    /// A task or an event of the plan.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Task {
        /// End of the permitted storage.
        StorageEnd = "storage_end",
        /// Cleaning of the surfaces that dissipate heat.
        Cleaning = "cleaning",
        /// Inspection of cables and cable carrier.
        Cables = "cables",
        /// Inspection of the protective earth.
        ProtectiveEarth = "protective_earth",
        /// Inspection of the screws of housing and load.
        Screws = "screws",
        /// Inspection of the radial shaft seals for liquid and dirt.
        Seals = "seals",
        /// Recommended replacement of the encoder.
        EncoderRecommended = "encoder_recommended",
        /// End of the life of the encoder battery, from the model.
        BatteryEmpty = "battery_empty",
        /// Latest replacement of the encoder.
        EncoderLatest = "encoder_latest",
    }
}

impl Task {
    /// Returns the fact that requires the task.
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
    /// Obligation of a date.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum DateRule {
        /// Latest date.
        AtTheLatest = "at_the_latest",
        /// Recommended date.
        Recommended = "recommended",
        /// Estimated date.
        Estimated = "estimated",
        /// Regular interval.
        Every = "every",
        /// Longest permitted interval.
        EveryAtMost = "every_at_most",
    }
}

/// A line of the plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Planned {
    /// Task of the line.
    pub task: Task,
    /// Obligation of the date.
    pub rule: DateRule,
    /// Interval of a series.
    pub interval: Option<Interval>,
    /// Start of a series.
    pub counted_from: NaiveDate,
    /// Date, or first date of a series.
    pub first: NaiveDate,
    /// Next date of a series, not before today if today is stated.
    pub next: NaiveDate,
    /// The date is before today, if today is stated.
    pub passed: bool,
    /// Fact that requires the task.
    pub fact: &'static Fact,
    /// Grade of trust in the date; `None` if it follows from an interval stated by the user.
    pub grade: Option<Grade>,
    /// Model that yields the date, if there is one.
    pub model: Option<Source>,
}

/// An assumption of the plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlanNote {
    /// No storage was stated: commissioning on the day of delivery.
    NoStorageStated,
    /// The storage is longer than permitted.
    StorageTooLong,
    /// No interval of regular work was stated: a year is assumed.
    IntervalAssumed,
    /// Cleaning keeps the interval of the manual, which is shorter than the stated one.
    CleaningStaysShorter,
    /// No operation per day was stated: the life of the battery is not computed.
    HoursNotStated,
    /// Operation per day was stated for a feedback without a battery.
    NoBattery,
    /// The ten years end before the life of the battery.
    BatteryOutlivesEncoder,
    /// The manual states no interval for the seals.
    SealIntervalNotStated,
    /// The manual states no interval for renewing the grease.
    GreaseIntervalNotStated,
}

/// Maintenance plan of one actuator, and the facts of the manual on each phase of its life.
#[derive(Clone, Debug, PartialEq)]
pub struct Upkeep {
    /// Ordering code of the actuator.
    pub code: OrderCode,
    /// Date of delivery.
    pub delivered: NaiveDate,
    /// Date of commissioning.
    pub in_service: NaiveDate,
    /// Reference date of the plan.
    pub today: Option<NaiveDate>,
    /// The storage is within the permitted limit.
    pub storage_permitted: bool,
    /// Lines of the plan in order of date.
    pub plan: Vec<Planned>,
    /// Life of the encoder battery; not applicable without one, not stated if the operation per day is not.
    pub battery: Datum<BatteryLife>,
    /// Assumptions with their consequences.
    pub notes: Vec<PlanNote>,
    /// Facts on transport and storage.
    pub storage: Vec<&'static Fact>,
    /// Facts on operation.
    pub service: Vec<&'static Fact>,
    /// Facts on shutdown, in the order of the steps.
    pub shutdown: Vec<&'static Fact>,
    /// Facts on disposal.
    pub disposal: Vec<&'static Fact>,
}

/// Reason for which a plan is impossible.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum UpkeepFault {
    /// The storage ends before the delivery.
    StorageBeforeDelivery {
        /// End of the storage.
        until: NaiveDate,
        /// Date of delivery.
        delivered: NaiveDate,
    },
    /// The input is outside the model of the battery.
    Battery(BatteryFault),
    /// A date of the plan is beyond the calendar.
    BeyondTheCalendar,
}

/// The five safety rules, and the shutdown step that they precede, in which connections are separated.
const ISOLATE: (&str, &str) = ("isolate_before_work", "shutdown_discharge");

/// Default interval of regular work: that of the cleaning.
const INSPECT_ASSUMED: Interval = Interval::Months(12);

/// Returns the maintenance plan of an actuator.
///
/// # Source
/// cha-manual sections 6.22.4, 9.1, 9.8 and chapter 10; docs/theory/battery.md
/// # Errors
/// [`UpkeepFault`] if a plan is impossible.
pub fn upkeep(code: &OrderCode, asked: &UpkeepInputs) -> Result<Upkeep, UpkeepFault> {
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
        // Concerns an actuator in store, or a planned storage that is too long; in service it is no date.
        let concerns = asked.today.map_or(!storage_permitted, |today| today < in_service);
        if asked.storage.is_some() && concerns {
            plan.once(Task::StorageEnd, DateRule::AtTheLatest, end);
        }
    }
    if !storage_permitted {
        plan.notes.push(PlanNote::StorageTooLong);
    }
    plan.regularly(asked.inspect)?;
    let battery = plan.battery(code, asked)?;
    plan.notes.push(PlanNote::GreaseIntervalNotStated);
    // Lines with the same date keep the order of the tasks.
    plan.lines.sort_by_key(|line| line.next);
    let facts = facts_about(Topic::Upkeep, code, Order::Life);
    let of = |steps: &[LifeStep]| -> Vec<&'static Fact> {
        let wanted = |fact: &&&Fact| fact.step.is_some_and(|step| steps.contains(&step)) && fact.id != ISOLATE.0;
        facts.iter().filter(wanted).copied().collect()
    };
    let mut shutdown = of(&[LifeStep::Shutdown]);
    let place = shutdown.iter().position(|fact| fact.id == ISOLATE.1).unwrap_or(shutdown.len());
    shutdown.splice(place..place, facts.iter().find(|fact| fact.id == ISOLATE.0).copied());
    let [storage, disposal] = [LifeStep::Transport, LifeStep::Disposal].map(|step| of(&[step]));
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

/// Returns a time that a fact states in years, as calendar months.
fn years_of(fact: &str, value: &str) -> Option<Interval> {
    let fact = catalogue::fact(fact)?;
    let value = fact.values.iter().find(|known| known.id == value)?;
    let years = (1..=100_u32).find(|years| (f64::from(*years) - value.number).abs() < 1e-9)?;
    (value.unit == YEAR.ascii).then_some(Interval::Months(12 * years))
}

/// A plan under construction.
struct Plan {
    today: Option<NaiveDate>,
    in_service: NaiveDate,
    lines: Vec<Planned>,
    notes: Vec<PlanNote>,
}

impl Plan {
    /// Adds a single task or event.
    fn once(&mut self, task: Task, rule: DateRule, date: NaiveDate) {
        self.line(task, rule, None, (date, date), (Some(Grade::Printed), None));
    }

    fn line(
        &mut self,
        task: Task,
        rule: DateRule,
        interval: Option<Interval>,
        (first, next): (NaiveDate, NaiveDate),
        (grade, model): (Option<Grade>, Option<Source>),
    ) {
        let Some(fact) = catalogue::fact(task.fact()) else { return };
        let passed = self.today.is_some_and(|today| next < today);
        let (grade, counted_from) = (grade.map(|grade| fact.grade.worst(grade)), self.in_service);
        self.lines.push(Planned { task, rule, interval, counted_from, first, next, passed, fact, grade, model });
    }

    /// Adds the tasks at regular intervals, counted from commissioning.
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
        // The interval is stated by the user or assumed; the manual states that of the cleaning only.
        let grade = stated.map_or(Some(Grade::Assumed), |_| None);
        let clean =
            if cleaning == yearly { (DateRule::EveryAtMost, Some(Grade::Printed)) } else { (DateRule::Every, grade) };
        let series = [
            (Task::Cleaning, clean.0, cleaning, clean.1),
            (Task::Cables, DateRule::Every, interval, grade),
            (Task::ProtectiveEarth, DateRule::Every, interval, grade),
            (Task::Screws, DateRule::Every, interval, grade),
            (Task::Seals, DateRule::Every, interval, grade),
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

    /// Adds the events of an encoder whose turns are buffered by a battery.
    fn battery(&mut self, code: &OrderCode, asked: &UpkeepInputs) -> Result<Datum<BatteryLife>, UpkeepFault> {
        if !has_battery(code) {
            if asked.hours_per_day.is_some() {
                self.notes.push(PlanNote::NoBattery);
            }
            return Ok(Datum::NotApplicable);
        }
        let from_delivery = |fact: &str| years_of(fact, "").and_then(|years| years.after(asked.delivered, 1));
        if let Some(date) = from_delivery(Task::EncoderRecommended.fact()) {
            self.once(Task::EncoderRecommended, DateRule::Recommended, date);
        }
        if let Some(date) = from_delivery(Task::EncoderLatest.fact()) {
            self.once(Task::EncoderLatest, DateRule::AtTheLatest, date);
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
            self.line(Task::BatteryEmpty, DateRule::Estimated, None, (end, end), (Some(life.life.grade), source));
        }
        let (source, grade, errata) = (life.life.source.clone(), life.life.grade, life.life.errata);
        Ok(Datum::Known(provenance::Sourced { value: life, source, grade, errata }))
    }
}

/// Returns the time from one day to a later one.
fn days_between(from: NaiveDate, to: NaiveDate) -> Time {
    let days = u32::try_from((to - from).num_days()).unwrap_or(0);
    Time::new_in(f64::from(days), &DAY)
}

/// Returns the day a time after another, in whole days.
fn later(from: NaiveDate, time: Time) -> Option<NaiveDate> {
    // Limited because the calendar itself ends far beyond any plan.
    let days = time.in_unit(&DAY).floor().clamp(0.0, 1e6) as u64;
    from.checked_add_days(Days::new(days))
}

/// Returns `true` if a battery buffers the turns of the encoder of a code.
#[must_use]
pub fn has_battery(code: &OrderCode) -> bool {
    catalogue::fact(Task::EncoderLatest.fact()).is_some_and(|fact| fact.holds_for.feedbacks == [code.feedback])
}
