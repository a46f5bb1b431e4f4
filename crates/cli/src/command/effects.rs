//! Options that have no effect without another one: the dependences, and the refusal of a call that lacks the other.

use clap::ArgMatches;
use clap::parser::ValueSource;
use quantities::Language;
use questions::list::plot::MAP;
use questions::list::{LIST, Unanswered};
use words::terminal;

/// Dependence of an option on others.
pub(crate) struct Dependence {
    /// Commands with the option.
    commands: &'static [&'static str],
    /// Name of the option.
    pub(crate) option: &'static str,
    /// Options of which it needs one.
    pub(crate) needs: &'static [&'static str],
}

const fn dependence(
    commands: &'static [&'static str],
    option: &'static str,
    needs: &'static [&'static str],
) -> Dependence {
    Dependence { commands, option, needs }
}

/// Commands that draw a picture into a file and answer with a text otherwise.
const DRAWN: &[&str] = &["simulate", "wiring", "curve"];

/// Dependences that neither the declaration of an argument nor the question itself has.
pub(crate) const DEPENDENCES: [Dependence; 7] = [
    dependence(&["simulate"], "every", &["out"]),
    dependence(&["simulate"], "figure", &["svg", "png"]),
    dependence(DRAWN, "theme", &["svg", "png"]),
    dependence(DRAWN, "width", &["svg", "png"]),
    dependence(DRAWN, "height", &["svg", "png"]),
    dependence(&["wiring"], "connector", &["svg", "png"]),
    dependence(&["upkeep"], "name", &["ical"]),
];

/// Commands whose file has a name without an option too.
const NAMED_BY_THEMSELVES: [&str; 1] = ["report"];

/// Options of a scenario, which the project may state as well: the question refuses them.
const OF_A_SCENARIO: [&str; 2] = ["at", "reaction"];

/// Returns the options of which an option of a command needs one; empty if it needs none.
pub(crate) fn needs(command: &str, option: &str) -> Vec<&'static str> {
    if option == "force" && !NAMED_BY_THEMSELVES.contains(&command) {
        let entry = LIST.iter().copied().find(|entry| entry.command() == command);
        return entry.into_iter().flat_map(|entry| entry.files().map(|file| file.option)).collect();
    }
    if command == "simulate" && OF_A_SCENARIO.contains(&option) {
        return vec!["scenario"];
    }
    let own = DEPENDENCES.iter().find(|each| each.option == option && each.commands.contains(&command));
    own.map(|own| own.needs.to_vec()).unwrap_or_default()
}

/// Returns `true` if an option of a command has no effect beside those that are given.
pub(super) fn is_idle(command: &str, option: &str, given: &[&str]) -> bool {
    let needs = needs(command, option);
    !needs.is_empty() && !needs.iter().any(|other| given.contains(other))
}

/// Returns the refusal of every option of a call that has no effect in it; `matches` are those of the command.
pub(crate) fn refusal(command: &str, matches: &ArgMatches, language: Language) -> Option<Unanswered> {
    let is_given = |name: &str| {
        matches.try_contains_id(name).unwrap_or(false) && matches.value_source(name) == Some(ValueSource::CommandLine)
    };
    let ids = matches.ids().map(|id| id.as_str().to_owned());
    let lacking = ids.filter(|option| is_given(option)).filter_map(|option| {
        let needs = needs(command, &option);
        let is_of_the_question = command == "simulate" && OF_A_SCENARIO.contains(&option.as_str());
        let is_met = needs.iter().any(|other| is_given(other));
        let is_lacking = !(needs.is_empty() || is_of_the_question || is_met);
        let name = DEPENDENCES.iter().map(|each| each.option).chain(["force"]).find(|name| *name == option)?;
        let others = needs.iter().map(|other| format!("--{other}")).collect::<Vec<_>>().join(", ");
        is_lacking.then(|| Unanswered::option(name, (terminal::no_effect_without(&others, language), None)))
    });
    let mut all: Vec<Unanswered> = lacking.collect();
    if command == "sweep" {
        all.extend(of_a_sweep(matches, &is_given, language));
    }
    let figure = || matches.try_get_one::<String>("figure").ok().flatten();
    if command == "plot" && is_given("by") && figure().is_some_and(|figure| figure != MAP) {
        let needed = format!("--figure {MAP}");
        all.push(Unanswered::option("by", (terminal::no_effect_without(&needed, language), None)));
    }
    (!all.is_empty()).then(|| Unanswered::combined(all))
}

/// Returns the refusals of the options of a sweep that depend on the values of others.
fn of_a_sweep(matches: &ArgMatches, is_given: &dyn Fn(&str) -> bool, language: Language) -> Vec<Unanswered> {
    let mut all = Vec::new();
    let varied = matches.try_get_many::<String>(super::own::VARY).ok().flatten().into_iter().flatten();
    let ranges = varied.into_iter().filter(|change| super::own::is_plain_range(change)).count();
    if is_given("steps") && is_given(super::own::VARY) && ranges == 0 {
        all.push(Unanswered::option("steps", (terminal::no_steps_without_a_range(language).to_owned(), None)));
    }
    // The step of one range stands in its values.
    if is_given(super::own::STEP) && is_given(super::own::VARY) {
        let why = if is_given("steps") { terminal::step_beside_steps } else { terminal::no_step_of_one_range };
        all.push(Unanswered::option("step", (why(language).to_owned(), None)));
    }
    all
}
