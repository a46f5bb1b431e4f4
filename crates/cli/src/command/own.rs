//! Options and help that only the command line has, in addition to the arguments and output files of a question.

use super::argument::{self, flag, text};
use crate::changed::{LOAD_FACTORS, factor};
use clap::builder::{PossibleValuesParser, ValueParser};
use clap::{Arg, ArgAction, ArgGroup, Command, value_parser};
use quantities::{Language, MomentOfInertia};
use questions::SIGNALS;
use questions::list::{plot, report, wiring};
use std::net::{IpAddr, SocketAddr};
use words::help;
use words::help::{library, values};

/// Adds no options.
pub(crate) fn nothing(command: Command, _: Language) -> Command {
    command
}

/// Adds the fields of the title page of the report of the best actuator, which nothing else contains.
pub(crate) fn size(command: Command, language: Language) -> Command {
    command.args(report::TITLE_PAGE.map(|field| argument::of(&field, language).requires("report")))
}

/// Adds the date of delivery from which the maintenance follows.
pub(crate) fn report(command: Command, language: Language) -> Command {
    let delivered = text("delivered", values::date(language), help::report_delivered(language));
    command.arg(delivered.requires("installation"))
}

/// Call that writes the setpoints of a motion.
const SETPOINTS: &str = "antrieb moves axis.toml --every 2ms --out setpoints.csv";

/// Accepts any name of a table: the list itself reports the valid ones.
pub(crate) fn export(command: Command, language: Language) -> Command {
    let command = command.mut_arg("table", |table| table.value_parser(ValueParser::string()));
    command.after_help(help::setpoints_by_moves(&SETPOINTS, language))
}

/// Sets CSV as the default format.
pub(crate) fn catalogue(command: Command, _: Language) -> Command {
    command.mut_arg("format", |format| format.default_value("csv"))
}

/// Adds the recording from which a project begins.
pub(crate) fn new(command: Command, language: Language) -> Command {
    let from = text("from", values::file(language), help::new_from(language));
    let set = text("set", values::key_value(language), help::new_set(language)).action(ArgAction::Append);
    command.arg(from.value_parser(value_parser!(std::path::PathBuf))).arg(set)
}

/// Option that states further actuators beside the one of a data sheet.
pub(crate) const BESIDE: &str = "beside";

/// Adds further actuators beside the one of a data sheet.
pub(crate) fn data(command: Command, language: Language) -> Command {
    command.arg(text(BESIDE, values::code(language), help::data_beside(language)).action(ArgAction::Append))
}

/// Adds help on a picture without a file.
pub(crate) fn plot(command: Command, language: Language) -> Command {
    command.after_help(help::plot_without_files(language))
}

/// Adds a list of the signals of the output file below the options.
pub(crate) fn simulate(command: Command, language: Language) -> Command {
    let mut listed = format!("{}:", help::signals(language));
    for names in SIGNALS.chunks(5) {
        let names: Vec<&str> = names.iter().map(|signal| signal.id).collect();
        listed.push_str("\n  ");
        listed.push_str(&names.join(" "));
    }
    // The question has the options of its picture.
    listed.push_str(&format!("\n\n{}", help::setpoints_by_moves(&SETPOINTS, language)));
    command.mut_arg("signals", |signals| signals.requires("out")).after_help(listed)
}

/// Option that states values in place of a table.
pub(crate) const VARY: &str = "vary";

/// Option that states the step of a range.
pub(crate) const STEP: &str = "step";

/// Returns `true` if a change states a range of a key, which steps divide: `mass=30..60kg`, and no step of its own.
pub(super) fn is_plain_range(change: &str) -> bool {
    let (_, values) = change.split_once('=').unwrap_or_default();
    let colons = values.matches(':').count();
    let is_closed = values.contains("..") || is_dashed(values);
    is_of_several(values) && if is_closed { colons == 0 } else { colons < 2 && !values.contains([',', ';']) }
}

/// Columns that `--inputs` adds: those of the table, those of the project too.
const INPUTS: [&str; 2] = ["table", "all"];

/// Adds values in place of a table, and the form of the written answers.
pub(crate) fn sweep(command: Command, language: Language) -> Command {
    let values = text(VARY, values::key_values(language), help::sweep_vary(language)).action(ArgAction::Append);
    let steps = text("steps", values::n(language), help::sweep_steps(language))
        .value_parser(value_parser!(u64).range(1..=questions::list::new::SAMPLES_MOST));
    let inputs = text("inputs", values::name(language), help::sweep_inputs(language))
        .value_parser(PossibleValuesParser::new(INPUTS))
        .requires("out");
    command
        .mut_arg("table", |table| table.required(false).required_unless_present(VARY).conflicts_with(VARY))
        .mut_arg("out", |out| out.required(false).required_unless_present(VARY))
        .arg(values)
        .arg(steps.requires(VARY))
        .arg(text(STEP, values::quantity(language), help::sweep_step(language)).requires(VARY))
        .arg(inputs)
        .arg(flag("decimal-comma", help::sweep_decimal_comma(language)).requires("out"))
}

/// Adds the options of a picture.
pub(crate) fn picture(command: Command, language: Language) -> Command {
    command.args([plot::THEME, plot::WIDTH, plot::HEIGHT].map(|argument| argument::of(&argument, language)))
}

/// Adds the choice of the drawn connector, and the options of a picture.
pub(crate) fn wiring(command: Command, language: Language) -> Command {
    let roles = PossibleValuesParser::new(wiring::Role::ALL.iter().map(|role| role.id()));
    let connector = text("connector", values::connector(language), help::wiring_connector(language));
    picture(command.arg(connector.value_parser(roles)), language)
}

/// Requires one of the four options that a call is about.
pub(crate) fn commission(command: Command, language: Language) -> Command {
    let wanted = ArgGroup::new("wanted").args(["for", "checklist", "record", "blank"]);
    let code = values::code(language);
    let line = |(option, value): (&str, &str)| {
        let options = library::options_in_usage(library::LANGUAGE);
        format!("antrieb commission {options} --{option} <{value}> <{code}>...")
    };
    let file = values::file(language);
    let options = [("for", values::drive(language)), ("checklist", file), ("record", file), ("blank", file)];
    let indent = " ".repeat(help::usage(language).chars().count() + 2);
    let command = command.override_usage(options.map(line).join(&format!("\n{indent}")));
    command.group(wanted.multiple(true).required(true)).after_help(help::commission_exit(language))
}

/// Adds the shapes that a body may have, below the options.
pub(crate) fn shapes(command: Command, language: Language) -> Command {
    let mut shapes = String::new();
    for shape in &project::BODY_SHAPES {
        let axis = if shape.may_lie { " axis" } else { "" };
        let extent = shape.extent.map(|extent| format!(" ({extent})")).unwrap_or_default();
        let line = format!("  {:<9} {}{extent}{axis}", shape.name, shape.dimensions.join(" "));
        shapes.push_str(line.trim_end());
        shapes.push('\n');
    }
    command.after_help(format!("{}\n{shapes}{}", help::shapes(language), help::shapes_all(language)))
}

/// Returns `true` if a word is recognisably the value of an option that only the command line has.
pub(super) fn recognises(option: &str, word: &str, language: Language) -> bool {
    let changed = || word.split_once('=').map(|(key, value)| (key.trim(), value.trim()));
    // A bare number is a factor of the whole load only; the change refuses others with both forms.
    let is_factor = |key: &str, value: &str| {
        let number = || value.replace(',', ".").parse::<f64>().ok().filter(|number| LOAD_FACTORS.contains(number));
        let what = words::spoken::scaled(key);
        let is_percentage = value.ends_with('%') || value.starts_with('+');
        what.is_some() && (factor(value).is_some() || is_percentage || what == Some("load") && number().is_some())
    };
    let is_key = |key: &str| {
        key.starts_with(char::is_alphabetic) && key.chars().all(|sign| sign.is_alphanumeric() || "_.[]".contains(sign))
    };
    match option {
        "lang" => words::spoken::language_of(word).is_some(),
        // A time without its option is one of the motion.
        "deadline" => false,
        "memory" => crate::memory_allowed(Some(word.to_owned()), language).is_ok(),
        "scale" => changed().is_some_and(|(key, value)| is_factor(key, value)),
        "set" => changed().is_some_and(|(key, value)| is_key(key) && !value.contains("..") && !is_factor(key, value)),
        VARY => changed().is_some_and(|(key, value)| is_key(key) && is_of_several(value)),
        "inertia" => questions::read_quantity::<MomentOfInertia>(word, language).is_ok(),
        "listen" => word.parse::<SocketAddr>().is_ok() || word.parse::<IpAddr>().is_ok(),
        "port" => word.parse::<u16>().is_ok_and(|port| port >= PORT_LEAST),
        _ => false,
    }
}

/// Returns `true` if a text states several values: `0,10,20kg`, `0..10 kg`.
pub(super) fn is_of_several(text: &str) -> bool {
    text.contains("..") || is_dashed(text) || text.contains([',', ';', ':']) && !text.starts_with(['[', '{', '"'])
}

/// Returns `true` if a text is a range with a dash: `0-10 kg`.
fn is_dashed(text: &str) -> bool {
    text.split_once(['-', '–']).is_some_and(|(low, high)| {
        let is_number = |text: &str| text.starts_with(|sign: char| sign.is_ascii_digit());
        is_number(low) && is_number(high) && low.parse::<f64>().is_ok()
    })
}

/// Smallest number that is plainly a port: smaller ones belong to services of the system.
const PORT_LEAST: u16 = 1024;

pub(super) fn serve(language: Language) -> Command {
    let [one, all] = crate::serve::EXAMPLES;
    Command::new("serve")
        .about(help::serve(language))
        .arg(
            Arg::new("folder")
                .value_name(values::folder(language))
                .value_parser(value_parser!(std::path::PathBuf))
                .help(help::serve_folder(language)),
        )
        .arg(text("port", values::n(language), help::serve_port(language)).value_parser(value_parser!(u16)))
        .arg(flag("open", help::serve_open(language)))
        .arg(text("listen", values::address(language), help::serve_listen(&one, &all, language)))
        .arg(flag("no-token", help::serve_no_token(language)))
        .arg(memory(language))
}

pub(super) fn drive(language: Language) -> Command {
    let l = language;
    Command::new("drive")
        .about(help::drive(l))
        .arg(Arg::new("code").value_name(values::code(l)).required(true).num_args(1..).help(help::ordering_code(l)))
        .arg(
            // Its own identifier: a server has no deadline, which every command with a project accepts.
            text("project-file", values::file(l), help::drive_project(l))
                .long("project")
                .value_parser(value_parser!(std::path::PathBuf))
                .conflicts_with("inertia"),
        )
        .arg(text("axis", values::name(l), help::axis(l)).requires("project-file"))
        .arg(text("inertia", values::quantity(l), help::drive_inertia(l)))
        .arg(
            text("protocol", values::name(l), help::drive_protocol(l))
                .value_parser(PossibleValuesParser::new(server::DriveProtocol::ALL.map(server::DriveProtocol::id)))
                .default_value(server::DriveProtocol::default().id()),
        )
        .arg(
            text("time", values::name(l), help::drive_time(l))
                .value_parser(PossibleValuesParser::new(questions::drive::Time::ALL.map(questions::drive::Time::id)))
                .default_value(questions::drive::Time::default().id()),
        )
        .arg(text("port", values::n(l), help::drive_port(l)).value_parser(value_parser!(u16)))
        .arg(
            text("node", values::n(l), help::drive_node(l))
                .value_parser(value_parser!(u8).range(1..=i64::from(questions::drive::NODE_MOST)))
                .default_value("1"),
        )
        .arg(text("seed", values::n(l), help::simulate_seed(l)).value_parser(value_parser!(u32)).default_value("0"))
        .arg(flag("eds", help::drive_eds(l)))
        .arg(memory(l))
}

/// Creates the options that state other values of a project for one call.
pub(super) fn changes(language: Language) -> [Arg; 2] {
    [
        ("set", values::key_value(language), help::set(language)),
        ("scale", values::what_factor(language), help::scale(language)),
    ]
    .map(|(name, value, help)| text(name, value, help).action(ArgAction::Append))
}

/// Creates the option that names catalogue files.
pub(super) fn catalogue_files(language: Language) -> Arg {
    text("catalogue", values::file(language), help::catalogue_file(language))
        .value_parser(value_parser!(std::path::PathBuf))
        .action(ArgAction::Append)
}

/// Creates the option that limits the memory of the recordings of a project.
pub(super) fn memory(language: Language) -> Arg {
    text("memory", values::size(language), help::memory(language))
}
