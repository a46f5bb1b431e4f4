//! `simulate PROJECT`: the digital twin of an axis with an actuator.

use super::given::{arguments, by_id, count, flag, number, some, some_product_among, text, word};
use super::plot::{HEIGHT, THEME, WIDTH};
use super::{
    AXIS, Answer, Argument, ArgumentKind, Cost, Entry, Given, Gives, Inquiry, OutputFile, PlacedAxis, Reads, Record,
    Unanswered, argument, media,
};
use crate::answer;
use crate::chapters::{read_hours, read_quantity};
use crate::progress::Progress;
use crate::signal::Signal;
pub use crate::simulate::RunChange;
use crate::simulate::{NotRun, ROWS_MOST, Simulated, StepLimit, Wanted, Work, simulate};
use axis::AxisProject;
use configurator::ProductId;
use feedback::Failure;
use quantities::unit::HOUR;
use quantities::{Language, Length, Measure, Time, format_significant};
use twin::{CURRENT_RATE_HZ, Fault, Operation, PeriodCourse, Reaction, Scenario};
pub use twin::{Part, ScenarioId};
use words::{Worded, help, help::values, simulation};

arguments! {
    /// Arguments of `simulate`: axis, actuator, scenario.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
        /// The actuator; without it the project's own.
        code: Option<ProductId> = argument::code(help::check_code) => some_product_among,
        /// Scenario; by default that of the project, else the cycle.
        scenario: Option<ScenarioId> = Argument::option("scenario", values::name, help::simulate_scenario)
            .of(ArgumentKind::Word(|| ScenarioId::ALL.iter().map(|each| each.id()).collect())) => word(ScenarioId::of),
        /// Instant of the scenario.
        at: Option<Time> = Argument::option("at", values::time, help::simulate_at).signed() => some(read_quantity),
        /// Stop reaction of the drive.
        reaction: Option<Reaction> = Argument::option("reaction", values::name, help::simulate_reaction)
            .of(ArgumentKind::Word(|| Reaction::ALL.map(Reaction::id).to_vec())) => word(by_id(&Reaction::ALL, Reaction::id)),
        /// Encoder failure.
        failure: Option<Failure> = Argument::option("failure", values::name, help::simulate_failure)
            .of(ArgumentKind::Word(|| Failure::ALL.iter().map(|each| each.id()).collect())) => word(by_id(&Failure::ALL, Failure::id)),
        /// Number of cycles.
        cycles: Option<u32> = Argument::option("cycles", values::n, help::simulate_cycles)
            .of(ArgumentKind::Whole(1, 100_000)) => number,
        /// Start of all parts at ambient temperature.
        cold: bool = Argument::flag("cold", help::simulate_cold) => flag,
        /// Days of operation with the mean losses of the cycle.
        days: Option<u32> = Argument::option("days", values::n, help::simulate_days)
            .of(ArgumentKind::Whole(1, DAYS_MOST as u64)) => number,
        /// Operation per day.
        hours_per_day: Option<Time> = Argument::option("hours-per-day", values::hours, help::simulate_hours) => some(read_hours),
        /// Time between two rows of the course.
        every: Option<Time> = Argument::option("every", values::time, help::simulate_every).signed() => some(read_quantity),
        /// Signals of the course; empty for all.
        signals: Vec<&'static Signal> = Argument::option("signals", values::names, help::simulate_signals)
            .of(ArgumentKind::Word(Signal::ids)).repeated() => signals,
        /// Format of the answer; on the command line the extension of the file.
        format: Option<String> = Argument::option("format", values::format, help::simulate_format)
            .of(ArgumentKind::Word(|| FORMATS.to_vec())) => text,
        /// Picture to draw.
        figure: Option<String> = Argument::option("figure", values::figure, help::simulate_figure)
            .of(ArgumentKind::Word(|| FIGURES.to_vec())) => text,
        /// Dark colours.
        theme: Option<bool> = THEME => word(|theme| Some(theme == "dark")),
        /// Width of the picture.
        width: Option<Length> = WIDTH => some(read_quantity),
        /// Height of the picture.
        height: Option<Length> = HEIGHT => some(read_quantity),
        /// Seed of phases and noise.
        seed: usize = Argument::option("seed", values::n, help::simulate_seed)
            .of(ArgumentKind::Whole(0, u32::MAX as u64)).usually("0") => count,
    }
}

/// Largest number of days: ten years.
const DAYS_MOST: u32 = 3660;

/// Pictures of a run, by their identifiers.
pub const FIGURES: [&str; 2] = ["simulation", "control_loops"];

/// Formats of the answer: the record, the course as a table, or a picture.
const FORMATS: [&str; 4] = ["json", "csv", "parquet", PICTURE_FORMAT];

/// The format of a picture.
pub const PICTURE_FORMAT: &str = "svg";

/// Returns the signals in the order of the call, without repetitions.
fn signals(given: &Given, argument: &Argument) -> Result<Vec<&'static Signal>, Unanswered> {
    let mut named: Vec<&'static Signal> = Vec::new();
    for signal in given.all(argument.name).filter_map(Signal::of_id) {
        if named.iter().all(|known| known.id != signal.id) {
            named.push(signal);
        }
    }
    Ok(named)
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "simulate",
    path: "simulate",
    about: help::simulate,
    reads: Reads::Project,
    arguments: Args::ARGUMENTS,
    gives: Gives::RecordOr(
        Record::of::<answers::Answered<answers::Simulation>>("simulate"),
        &[media::CSV, media::PARQUET, media::SVG],
    ),
    writes: &[
        OutputFile::of("out", &[media::CSV, media::PARQUET], help::simulate_trace),
        OutputFile::of("svg", &[media::SVG], help::svg),
        OutputFile::of("png", &[media::PNG], help::png),
    ],
    example: "axis.toml --code CHA-25A-50-H-C1024 --scenario emergency_stop",
    answer: None,
};

/// Returns the record about each axis.
///
/// # Errors
/// Faults of project and arguments; reasons why nothing is simulated.
pub fn record(args: &Args, inquiry: &Inquiry<'_>) -> Result<Answer, Unanswered> {
    let axes = args.axes(inquiry)?;
    inquiry.record_of_each(&axes, |project| {
        let found = args.simulated(project, inquiry, false)?;
        Ok((answer::simulation(&found, inquiry.language), answers::Fit::of(found.fits())))
    })
}

/// Default time between two rows of a course \[s\].
const ROWS_USUAL_S: f64 = 1e-3;

impl Args {
    /// Returns the axes to simulate. The steps of all axes are counted before the first is judged.
    ///
    /// # Errors
    /// Faults of the project; more steps than permitted without a time limit.
    pub fn axes(&self, inquiry: &Inquiry<'_>) -> Result<Vec<PlacedAxis>, Unanswered> {
        let axes = inquiry.axes(self.axis.as_deref(), Cost::Other)?;
        let of = |(_, project): &PlacedAxis| Work::of_axis(project, &self.scenario(project), self.days.is_some());
        let works: Vec<Work> = axes.iter().map(of).collect();
        Work::within(&works, StepLimit::of(inquiry.refuses_long))
            .map_err(|fault| Unanswered::message(fault.said(inquiry.language)))?;
        Ok(axes)
    }

    fn cycles(&self, project: &AxisProject) -> u32 {
        self.cycles.unwrap_or_else(|| project.twin.scenario.cycles.max(1))
    }

    /// Returns `true` if the table of the call is that of the days, not the trace of the cycle.
    const fn tabulates_days(&self) -> bool {
        self.days.is_some() && self.signals.is_empty() && self.every.is_none()
    }

    /// Returns the days of a run whose table is that of the days; `Ok(None)` if it is the trace of the cycle.
    ///
    /// # Errors
    /// The actuator has no thermal model.
    pub fn days_of<'r>(
        &self,
        run: &'r Simulated<'_>,
        language: Language,
    ) -> Result<Option<&'r [PeriodCourse]>, Unanswered> {
        if !self.tabulates_days() {
            return Ok(None);
        }
        match run.days() {
            Some(days) => Ok(Some(days)),
            None => Err(Unanswered::option("days", (simulation::no_days(language).to_owned(), None))),
        }
    }

    /// Returns the scenario of the call, else that of the project.
    fn scenario(&self, project: &AxisProject) -> Scenario {
        let stated = &project.twin.scenario;
        Scenario {
            id: self.scenario.unwrap_or(stated.id),
            at_s: self.at.map(Time::si).or(stated.at_s),
            reaction: self.reaction.unwrap_or(stated.reaction),
            failure: self.failure.or(stated.failure),
            cycles: self.cycles(project),
            cold: self.cold || stated.cold,
        }
    }

    /// Returns the run, with its course if that is written.
    ///
    /// # Errors
    /// The reason why nothing is simulated.
    pub fn simulated<'p>(
        &self,
        project: &'p AxisProject,
        inquiry: &Inquiry<'_>,
        with_course: bool,
    ) -> Result<Simulated<'p>, Unanswered> {
        let every = self.every.map_or(ROWS_USUAL_S, Time::si);
        let scenario = self.scenario(project).id;
        let hours = self.hours_per_day.map_or(24.0, |time| time.in_unit(&HOUR));
        let language = inquiry.language;
        let period_us = format_significant(1e6 / CURRENT_RATE_HZ, 4, language);
        Unanswered::unless_right([
            (
                "every",
                every.is_nan() || every * CURRENT_RATE_HZ < 1.0 - 1e-9,
                simulation::refused_every(&period_us, language),
            ),
            ("at", self.at.is_some_and(|at| at.si() < 0.0), simulation::refused_range(&"at", language)),
            ("at", self.at.is_some() && !scenario.has_instant(), simulation::refused_at(language).to_owned()),
            (
                "reaction",
                self.reaction.is_some() && scenario == ScenarioId::Cycle,
                simulation::refused_reaction(language).to_owned(),
            ),
            (
                "hours-per-day",
                !(0.0..=24.0).contains(&hours) || (self.hours_per_day.is_some() && self.days.is_none()),
                simulation::refused_hours(language).to_owned(),
            ),
            (
                "days",
                self.days.is_some() && scenario != ScenarioId::Cycle,
                simulation::refused_days(language).to_owned(),
            ),
            (
                "failure",
                self.failure.is_some() && scenario != ScenarioId::EncoderFailure,
                simulation::refused_failure(&ScenarioId::EncoderFailure.id(), language),
            ),
        ])?;
        let day = Time::new_in(24.0, &HOUR).si();
        let wanted = Wanted {
            operation: self.days.map(|periods| Operation { periods, period_s: day, running_s: hours / 24.0 * day }),
            scenario: self.scenario(project),
            seed: self.seed as u64,
            every_s: with_course.then_some(every),
            part: None,
        };
        simulate(project, self.code.as_ref(), wanted, StepLimit::of(inquiry.refuses_long), inquiry.progress).map_err(
            |why| match why {
                NotRun::Refused(refusal) => refusal.into(),
                NotRun::Fault(fault) => self.unanswered(&fault, project, inquiry),
                other => Unanswered::message(said(&other, inquiry.language)),
            },
        )
    }

    /// Returns the refusal of the twin, at the value of the file that causes it.
    fn unanswered(&self, fault: &Fault, project: &AxisProject, inquiry: &Inquiry<'_>) -> Unanswered {
        let message = simulation::simulation_fault(fault, inquiry.language);
        // Among several files it is not known which one contains the axis.
        let [source] = inquiry.sources.as_slice() else { return Unanswered::message(message) };
        let (id, keys) = self.cause(fault);
        let place = keys.iter().find_map(|key| project.place_in_twin(key));
        let Some(span) = place else { return Unanswered::message(message) };
        let text = project::with_newlines(&project::decoded(&source.bytes).0).into_owned();
        let faults = vec![Worded::at(&text, span, id, message, None)];
        Unanswered::Text { name: source.name.clone(), text, faults }
    }

    /// Returns the identifier of a refusal, and the keys of `[twin]` whose values may cause it: those that the call does not
    /// state.
    fn cause(&self, fault: &Fault) -> (&'static str, Vec<String>) {
        let scenario = self.scenario.is_none().then(|| "scenario".to_owned());
        let at = self.at.is_none().then(|| "at".to_owned());
        match fault {
            Fault::AfterTheEnd { .. } => ("scenario_after_the_end", Vec::from_iter(at)),
            Fault::NotAtRest => ("scenario_in_motion", at.into_iter().chain(scenario).collect()),
            Fault::AtRest => ("scenario_at_rest", at.into_iter().chain(scenario).collect()),
            Fault::NoBrake => ("scenario_without_brake", Vec::from_iter(scenario)),
            Fault::NoBattery => ("scenario_without_battery", Vec::from_iter(scenario)),
            Fault::NoEncoder => ("scenario_without_encoder", Vec::from_iter(scenario)),
            Fault::NotOfThisEncoder { .. } => {
                let failure = self.failure.is_none().then(|| "failure".to_owned());
                ("failure_of_another_encoder", failure.into_iter().chain(scenario).collect())
            }
            Fault::Unstable { of, .. } => ("gain_unstable", vec![format!("{}_gain", of.id())]),
            Fault::OutOfRange(key) => ("out_of_range", vec![(*key).to_owned()]),
            Fault::NotOfThisLoad(key) => ("without_effect", vec![(*key).to_owned()]),
            Fault::Above { lower, upper } => ("wrong_order", vec![(*lower).to_owned(), (*upper).to_owned()]),
            Fault::Missing(_)
            | Fault::RecordedTorque
            | Fault::NoInertia
            | Fault::NoOutputEncoder
            | Fault::StepTooLong { .. } => ("not_simulated", Vec::new()),
        }
    }
}

/// Returns the run that a project states in `[twin]`, with its course, for a report; `None` if it states none.
///
/// # Errors
/// The reason why it is not run, in a sentence.
pub fn of_the_project<'p>(
    project: &'p AxisProject,
    product: Option<&ProductId>,
    progress: &Progress,
    language: Language,
) -> Option<Result<Simulated<'p>, String>> {
    if !project.twin.stated {
        return None;
    }
    let wanted = Wanted { scenario: project.twin.scenario, every_s: Some(ROWS_USUAL_S), ..Wanted::default() };
    Some(simulate(project, product, wanted, StepLimit::Fixed, progress).map_err(|why| said(&why, language)))
}

/// Returns the run of a scenario with its course, of a part of the motion if one is stated; all other data as stated by the
/// project.
///
/// # Errors
/// [`NotSimulated`].
pub fn of_scenario<'p>(
    project: &'p AxisProject,
    product: Option<&ProductId>,
    (id, part): (ScenarioId, Option<Part>),
    progress: &Progress,
    language: Language,
) -> Result<Simulated<'p>, NotSimulated> {
    // The instant of an event is one of the whole motion.
    let at_s = project.twin.scenario.at_s.filter(|_| part.is_none());
    let scenario = Scenario { id, at_s, ..project.twin.scenario };
    let wanted = Wanted { scenario, part, every_s: Some(ROWS_USUAL_S), ..Wanted::default() };
    simulate(project, product, wanted, StepLimit::Fixed, progress).map_err(|why| NotSimulated {
        changes: if let NotRun::Steps(fault) = &why { fault.of_the_project(language) } else { Vec::new() },
        is_too_long: matches!(why, NotRun::Steps(_) | NotRun::Rows(_)),
        sentence: said(&why, language),
    })
}

/// A run that is not computed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotSimulated {
    /// The reason in a sentence.
    pub sentence: String,
    /// Changes of the project with which it is computed.
    pub changes: Vec<RunChange>,
    /// The run exceeds a limit of its length; a part of the motion has a run.
    pub is_too_long: bool,
}

fn said(why: &NotRun, language: Language) -> String {
    match why {
        NotRun::Refused(refusal) => answer::refusal_text(refusal, None, language),
        NotRun::Fault(fault) => simulation::simulation_fault(fault, language),
        NotRun::Steps(fault) => fault.said(language),
        NotRun::Rows(rows) => simulation::too_many_rows(rows, &ROWS_MOST, language),
    }
}
