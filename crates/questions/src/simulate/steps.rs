//! Solver steps of a run, counted before it begins, and the changes of a call by which it stays within the limit.

use axis::AxisProject;
use quantities::{Language, Measure};
use twin::Scenario;
use words::simulation;

/// Largest number of steps if the call states no time limit: about ten seconds on one core.
pub(crate) const STEPS_MOST: u64 = 50_000_000;

/// Additional cycles for the settled state, at most, and for days of operation: two at each of three temperatures, and
/// the settled state.
const WARM_CYCLES: u64 = 8;
const DAYS_CYCLES: u64 = 14;

/// Returns `true` if the instant of the event is chosen.
const fn is_chosen(scenario: &Scenario) -> bool {
    scenario.id.has_instant() && scenario.at_s.is_none()
}

const CYCLES: &str = "twin.cycles";
const COLD: &str = "twin.cold";

/// Limit of the steps of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StepLimit {
    /// No limit: the call states a time limit.
    None,
    /// [`STEPS_MOST`], unless the call states a time limit.
    WithoutTimeLimit,
    /// [`STEPS_MOST`]: a time limit cannot be stated.
    Fixed,
}

impl StepLimit {
    /// Returns the limit of a call.
    pub(crate) const fn of(refuses_long: bool) -> Self {
        if refuses_long { Self::WithoutTimeLimit } else { Self::None }
    }
}

/// Solver steps of a run and of the cycles besides it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Work {
    /// Steps of one cycle.
    pub(crate) cycle: u64,
    /// Steps of the run behind its cycles.
    pub(crate) after: u64,
    /// Number of cycles.
    pub(crate) cycles: u32,
    /// The run begins in the settled state.
    pub(crate) warm: bool,
    /// Operation over days is computed too.
    pub(crate) days: bool,
    /// The instant of the event is chosen.
    pub(crate) chosen: bool,
}

impl Work {
    /// Returns the work of an axis, known before the actuator is.
    pub(crate) fn of_axis(project: &AxisProject, scenario: &Scenario, days: bool) -> Self {
        let duration_s = project.axis.motion.duration().si();
        let steps = duration_s * twin::CURRENT_RATE_HZ * f64::from(twin::SUBSTEPS_USUAL);
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a count; beyond its range there are too many"
        )]
        let cycle = steps as u64;
        let (cycles, warm) = (scenario.cycles.max(1), scenario.starts_warm());
        Self { cycle, after: 0, cycles, warm, days, chosen: is_chosen(scenario) }
    }

    /// Returns the work of a part of the motion, whose steps are known with the actuator.
    pub(crate) const fn of_part(scenario: &Scenario) -> Self {
        Self { cycle: 0, after: 0, cycles: 1, warm: false, days: false, chosen: is_chosen(scenario) }
    }

    /// Returns the work with the steps of its run as they are known with the actuator.
    pub(crate) fn with_run(self, run: u64) -> Self {
        let cycles = u64::from(self.cycles.max(1));
        if self.cycle == 0 {
            return Self { cycle: run / cycles, ..self };
        }
        let after = run.saturating_sub(self.cycle.saturating_mul(cycles));
        Self { cycle: (run - after) / cycles, after, ..self }
    }

    /// Returns the steps of the run itself.
    fn run(&self) -> u64 {
        self.cycle.saturating_mul(u64::from(self.cycles)).saturating_add(self.after)
    }

    /// Returns the largest number of steps besides the run; the choice of an instant counts with the fewest that it needs.
    fn besides(&self) -> u64 {
        let warm = if self.warm { WARM_CYCLES } else { 0 };
        let days = if self.days { DAYS_CYCLES } else { 0 };
        self.cycle.saturating_mul(warm + days).saturating_add(self.search()[0])
    }

    /// Returns the smallest and the largest number of steps by which the instant of the event is chosen.
    fn search(&self) -> [u64; 2] {
        let substeps = u64::from(twin::SUBSTEPS_USUAL);
        if !self.chosen {
            return [0; 2];
        }
        twin::search_periods(self.cycle / substeps).map(|periods| periods.saturating_mul(substeps))
    }

    /// Returns the number of periods of the current loop for the choice of the instant: what the limit leaves, `None` for
    /// as many as the choice needs.
    pub(crate) fn search_periods(&self, limit: StepLimit) -> Option<u64> {
        let [least, most] = self.search();
        let left = STEPS_MOST.saturating_sub(self.most()).saturating_add(least);
        (limit != StepLimit::None && left < most).then_some(left / u64::from(twin::SUBSTEPS_USUAL))
    }

    /// Returns the largest number of steps, with the fewest for the choice of an instant.
    pub(crate) fn most(&self) -> u64 {
        self.run().saturating_add(self.besides())
    }

    /// Returns the fault of runs that exceed a limit together, with the changes that keep within it.
    ///
    /// # Errors
    /// [`TooManySteps`].
    pub(crate) fn within(works: &[Self], limit: StepLimit) -> Result<(), TooManySteps> {
        let sum = |of: &dyn Fn(&Self) -> u64| works.iter().map(of).fold(0, u64::saturating_add);
        if limit == StepLimit::None || sum(&Self::most) <= STEPS_MOST {
            return Ok(());
        }
        let within = |change: &dyn Fn(Self) -> Self| sum(&|work| change(*work).most()) <= STEPS_MOST;
        let cycles_most = works.iter().map(|work| work.cycles).max().unwrap_or(1);
        // The largest number of cycles, by bisection: the sum grows with it.
        let cycles = |change: &dyn Fn(Self) -> Self| {
            let fits = |most: u32| within(&|work| change(Self { cycles: work.cycles.min(most), ..work }));
            let (mut low, mut high) = (0, cycles_most);
            while high - low > 1 {
                let middle = low + (high - low) / 2;
                if fits(middle) { low = middle } else { high = middle }
            }
            (low > 0).then_some(low)
        };
        let cold = |work: Self| Self { warm: false, ..work };
        let has_warm = works.iter().any(|work| work.warm);
        let alone = [
            cycles(&|work| work).map(|most| Change { cycles: Some(most), ..Change::NONE }),
            (has_warm && within(&cold)).then_some(Change { cold: true, ..Change::NONE }),
            (works.iter().any(|work| work.chosen) && within(&|work| Self { chosen: false, ..work }))
                .then_some(Change { stated: true, ..Change::NONE }),
            (works.iter().any(|work| work.days) && within(&|work| Self { days: false, ..work }))
                .then_some(Change { without_days: true, ..Change::NONE }),
            (works.len() > 1 && works.iter().all(|work| work.most() <= STEPS_MOST))
                .then_some(Change { one_axis: true, ..Change::NONE }),
        ];
        let mut changes: Vec<Change> = alone.into_iter().flatten().collect();
        if changes.is_empty() && has_warm {
            let together = cycles(&cold).map(|most| Change { cold: true, cycles: Some(most), ..Change::NONE });
            changes.extend(together);
        }
        // Where no time limit can be stated, the command line is the way for a run that nothing shortens.
        let has_way = limit == StepLimit::WithoutTimeLimit || changes.is_empty();
        changes.extend(has_way.then_some(Change { time_limit: true, ..Change::NONE }));
        let chosen = works.iter().any(|work| work.chosen);
        Err(TooManySteps { run: sum(&Self::run), besides: sum(&Self::besides), chosen, limit, changes })
    }
}

/// More steps than the limit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct TooManySteps {
    /// Steps of the run.
    run: u64,
    /// Largest number of steps of the cycles besides it.
    besides: u64,
    /// `true` if steps for the choice of an instant are among them.
    chosen: bool,
    limit: StepLimit,
    /// Changes, of which each suffices.
    changes: Vec<Change>,
}

/// Change of a call that keeps its steps within the limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Change {
    /// Largest number of cycles.
    cycles: Option<u32>,
    cold: bool,
    /// The instant of the event is stated.
    stated: bool,
    without_days: bool,
    one_axis: bool,
    time_limit: bool,
}

impl Change {
    const NONE: Self =
        Self { cycles: None, cold: false, stated: false, without_days: false, one_axis: false, time_limit: false };

    fn said(self, limit: StepLimit, language: Language) -> String {
        // Without a call the project states them.
        let [cycles, cold, at] = if limit == StepLimit::Fixed {
            [CYCLES, "twin.cold = true", "twin.at"]
        } else {
            ["--cycles", "--cold", "--at"]
        };
        let of_cycles = self.cycles.map(|most| simulation::steps_cycles(&most, &cycles, language));
        let flags = [
            (self.cold, simulation::steps_cold(&cold, language)),
            (self.stated, simulation::steps_at(&at, language)),
            (self.without_days, simulation::steps_without_days(language).to_owned()),
            (self.one_axis, simulation::steps_one_axis(language).to_owned()),
            (self.time_limit && limit == StepLimit::Fixed, simulation::steps_in_the_terminal(language).to_owned()),
            (self.time_limit && limit != StepLimit::Fixed, simulation::steps_time_limit(language).to_owned()),
        ];
        let words = flags.into_iter().filter(|(is_made, _)| *is_made).map(|(_, words)| words);
        let together =
            of_cycles.into_iter().chain(words).reduce(|one, other| simulation::steps_and(&one, &other, language));
        together.unwrap_or_default()
    }
}

/// Change of a project that keeps its run within the limit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RunChange {
    /// The change in words.
    pub title: String,
    /// Keys of the axis with their new values.
    pub edits: Vec<(&'static str, String)>,
}

impl TooManySteps {
    /// Returns the changes of the project of which each suffices.
    pub(crate) fn of_the_project(&self, language: Language) -> Vec<RunChange> {
        let changes = self.changes.iter().filter(|change| change.cycles.is_some() || change.cold);
        let change = |change: &Change| {
            let cycles =
                change.cycles.map(|most| (simulation::fewer_cycles(&most, language), (CYCLES, most.to_string())));
            let cold = change.cold.then(|| (simulation::cold_start(language).to_owned(), (COLD, "true".to_owned())));
            let (titles, edits): (Vec<String>, Vec<_>) = cycles.into_iter().chain(cold).unzip();
            let title = titles.into_iter().reduce(|one, other| simulation::steps_and(&one, &other, language));
            RunChange { title: title.unwrap_or_default(), edits }
        };
        changes.map(change).collect()
    }

    /// Returns the fault in words, with the changes of the call or, without one, of the project.
    pub(crate) fn said(&self, language: Language) -> String {
        let [run, besides, most] = [self.run, self.besides, STEPS_MOST].map(grouped);
        let fault = if self.besides == 0 {
            simulation::too_many_steps(&run, &most, language)
        } else if self.chosen {
            simulation::too_many_steps_chosen(&run, &besides, &most, language)
        } else {
            simulation::too_many_steps_besides(&run, &besides, &most, language)
        };
        let changes = self.changes.iter().map(|change| change.said(self.limit, language));
        match changes.reduce(|one, other| simulation::steps_or(&one, &other, language)) {
            Some(changes) => format!("{fault}: {changes}"),
            None => fault,
        }
    }
}

/// Returns a count with a space between groups of three digits.
fn grouped(count: u64) -> String {
    let digits = count.to_string();
    let mut found = String::with_capacity(digits.len() + digits.len() / 3);
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            found.push('\u{a0}');
        }
        found.push(digit);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A run is refused beyond the limit alone, and every change that is proposed keeps it within; fewer cycles are not
    /// proposed for one.
    #[test]
    fn the_advice_about_too_many_steps_can_be_followed() {
        let (mut refused, mut alone) = (0, 0);
        for cycle in [1_000, 60_000, 2_000_000, 10_761_060, 40_000_000, 90_000_000] {
            for cycles in [1, 2, 7, 100_000] {
                for (warm, days) in [(false, false), (true, false), (false, true), (true, true)] {
                    for axes in [1, 3] {
                        let work = Work { cycle, after: 0, cycles, warm, days, chosen: !days };
                        let works = vec![work; axes];
                        let sum = |works: &[Work]| works.iter().map(Work::most).sum::<u64>();
                        for limit in [StepLimit::None, StepLimit::WithoutTimeLimit, StepLimit::Fixed] {
                            let found = Work::within(&works, limit);
                            let is_over = sum(&works) > STEPS_MOST && limit != StepLimit::None;
                            assert_eq!(found.is_err(), is_over, "{works:?}");
                            let Err(fault) = found else { continue };
                            refused += 1;
                            assert!(!fault.changes.is_empty(), "a way out for {work:?}");
                            for change in fault.of_the_project(Language::En) {
                                assert!(!change.title.is_empty() && !change.edits.is_empty(), "{change:?}");
                            }
                            let is_terminal =
                                limit == StepLimit::Fixed && fault.changes.iter().all(|change| change.time_limit);
                            alone += usize::from(is_terminal);
                            assert_eq!(fault.run + fault.besides, sum(&works));
                            assert_eq!(fault.run, axes as u64 * cycle * u64::from(cycles));
                            for change in fault.changes {
                                if change.time_limit {
                                    assert!(limit != StepLimit::None);
                                    continue;
                                }
                                assert!(change.cycles.is_none_or(|most| most < cycles), "{work:?} {change:?}");
                                let changed = Work {
                                    cycles: change.cycles.unwrap_or(cycles),
                                    warm: warm && !change.cold,
                                    days: days && !change.without_days,
                                    chosen: !days && !change.stated,
                                    ..work
                                };
                                let left = if change.one_axis { 1 } else { axes };
                                assert!(sum(&vec![changed; left]) <= STEPS_MOST, "{work:?} {change:?}");
                                // One cycle more would be too many.
                                if change.cycles.is_some() {
                                    let more = Work { cycles: changed.cycles + 1, ..changed };
                                    assert!(sum(&vec![more; left]) > STEPS_MOST, "{work:?} {change:?}");
                                }
                            }
                        }
                    }
                }
            }
        }
        assert!(refused > 50 && alone > 0 && alone < refused / 2, "{refused} {alone}");
    }

    /// A roll of half an hour is too long for the page however it starts; the command line computes it.
    #[test]
    fn a_long_roll_has_a_way_out_on_the_page() {
        let roll = Work { cycle: 160_200_000, after: 0, cycles: 1, warm: true, days: false, chosen: false };
        let fault = Work::within(&[roll], StepLimit::Fixed).unwrap_err();
        assert!(fault.of_the_project(Language::De).is_empty());
        assert!(fault.said(Language::En).contains("antrieb simulate"), "{}", fault.said(Language::En));
        let short = Work { cycle: 10_761_060, ..roll };
        let fault = Work::within(&[short], StepLimit::Fixed).unwrap_err();
        let cold = RunChange { title: "kalt beginnen".to_owned(), edits: vec![(COLD, "true".to_owned())] };
        assert_eq!(fault.of_the_project(Language::De), [cold]);
    }

    #[test]
    fn a_winder_may_start_cold_instead() {
        let winder = Work { cycle: 10_761_060, after: 0, cycles: 1, warm: true, days: false, chosen: false };
        let fault = Work::within(&[winder], StepLimit::WithoutTimeLimit).unwrap_err();
        for (language, words) in [
            (
                Language::En,
                "10\u{a0}761\u{a0}060 steps and up to 86\u{a0}088\u{a0}480 for the temperatures at its start exceed the limit of 50\u{a0}000\u{a0}000: \
                 start cold (--cold), or state a time limit (--deadline)",
            ),
            (
                Language::De,
                "10\u{a0}761\u{a0}060 Schritte und bis zu 86\u{a0}088\u{a0}480 für die Temperaturen am Beginn überschreiten die Grenze von \
                 50\u{a0}000\u{a0}000: kalt beginnen (--cold) oder eine Zeitgrenze angeben (--deadline)",
            ),
        ] {
            assert_eq!(fault.said(language), words);
        }
    }
}
