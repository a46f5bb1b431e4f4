//! The commands and their help, in English and German.

use crate::answer::Answer;
use crate::fault::simple;
use clap::builder::{PossibleValuesParser, Styles};
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use std::ffi::OsString;
use workbench::Language;
use workbench::text::help::values;
use workbench::text::{Usage, capitalised, help, terms, usage_text};

const NAME: &str = "antrieb";
const LANG_VARIABLE: &str = "ANTRIEB_LANG";

mod files;
mod installation;
pub(crate) mod library;
pub(crate) mod usage;

use files::{compare, curve, diff, export, plot, report, sheet, wiring};

/// A help text, with a remark where the program was built without the typesetting engine.
fn with_report(language: Language, help: &str) -> String {
    if cfg!(feature = "report") { help.to_owned() } else { format!("{help} ({})", help::not_in_this_build(language)) }
}

/// The language asked for: `--lang`, else the variable `ANTRIEB_LANG`, else English. The locale of the machine is
/// left out on purpose: the same call gives the same bytes everywhere.
pub(crate) fn language_of(arguments: impl Iterator<Item = OsString>) -> Language {
    let mut wanted = std::env::var(LANG_VARIABLE).ok();
    let mut arguments = arguments.map(|argument| argument.to_string_lossy().into_owned());
    while let Some(argument) = arguments.next() {
        if argument == "--" {
            break;
        } else if argument == "--lang" {
            wanted = arguments.next();
        } else if let Some(value) = argument.strip_prefix("--lang=") {
            wanted = Some(value.to_owned());
        }
    }
    wanted.and_then(|wanted| Language::of_id(&wanted)).unwrap_or_default()
}

/// Whether JSON is asked for, however faulty the rest of the call may be.
pub(crate) fn json_of(arguments: &[OsString]) -> bool {
    arguments.iter().skip(1).take_while(|argument| *argument != "--").any(|argument| argument == "--json")
}

fn project(language: Language) -> Arg {
    Arg::new("project")
        .value_name(values::project(language))
        .required(true)
        .value_parser(value_parser!(std::path::PathBuf))
        .help(help::project(language))
}

fn axis(language: Language) -> Arg {
    Arg::new("axis").long("axis").value_name(values::name(language)).help(help::axis(language))
}

fn sampling(command: Command, language: Language) -> Command {
    let most = i64::try_from(workbench::SAMPLES_MOST).unwrap_or(i64::MAX);
    command
        .arg(
            Arg::new("samples")
                .long("samples")
                .value_name(values::n(language))
                .value_parser(value_parser!(u32).range(1..=most))
                .help(help::samples(language)),
        )
        .arg(
            Arg::new("seed")
                .long("seed")
                .value_name(values::n(language))
                .value_parser(value_parser!(u64))
                .help(help::seed(language)),
        )
}

fn deadline(language: Language) -> Arg {
    Arg::new("deadline").long("deadline").value_name(values::time(language)).help(help::deadline(language))
}

/// The whole command line.
pub(crate) fn build(language: Language) -> Command {
    library::usage(headed(commands(language), language), language)
}

/// Gives a command and all its subcommands the headings of the language and a help flag in it.
fn headed(command: Command, language: Language) -> Command {
    let reads_a_project =
        command.get_arguments().any(|argument| ["project", "old"].contains(&argument.get_id().as_str()));
    let command = if reads_a_project { command.arg(deadline(language)).arg(files::memory(language)) } else { command };
    let mut command = command
        .disable_help_flag(true)
        .disable_help_subcommand(true)
        .help_template(format!("{{about}}\n\n{}: {{usage}}\n\n{{all-args}}{{after-help}}", help::usage(language)))
        .subcommand_help_heading(help::commands(language))
        .mut_args(|argument| {
            let heading = if argument.is_positional() { help::arguments(language) } else { help::options(language) };
            let takes_value = argument.get_action().takes_values();
            argument.help_heading(heading).hide_default_value(takes_value).hide_possible_values(takes_value)
        })
        .arg(
            Arg::new("help")
                .short('h')
                .long("help")
                .action(ArgAction::Help)
                .help_heading(help::options(language))
                .help(help::help_flag(language)),
        );
    if command.get_name() == NAME {
        command = command.disable_version_flag(true).arg(
            Arg::new("version")
                .short('V')
                .long("version")
                .action(ArgAction::Version)
                .help_heading(help::options(language))
                .help(help::version_flag(language)),
        );
    }
    let example = EXAMPLES.iter().find(|(name, _)| *name == command.get_name());
    if let Some((_, call)) = example {
        let told = command.get_after_help().map(|text| format!("{text}\n\n")).unwrap_or_default();
        command = command.after_help(format!("{told}{}:\n  {call}", help::example(language)));
    }
    command.mut_subcommands(|subcommand| headed(subcommand, language))
}

/// One call of each command; every one of them runs.
pub(crate) const EXAMPLES: &[(&str, &str)] = &[
    ("antrieb", "antrieb new screw --out axis.toml && antrieb size axis.toml"),
    ("size", "antrieb size axis.toml --top 5"),
    ("check", "antrieb check axis.toml --code CHA-25A-50-H-C1024"),
    ("explain", "antrieb explain axis.toml --code CHA-25A-50-H-C1024 --check continuous_torque"),
    ("report", "antrieb report axis.toml --out axis.pdf"),
    ("compare", "antrieb compare axis.toml --code CHA-25A-50-H-C1024 --code CHA-32A-50-H-C1024"),
    ("diff", "antrieb diff before.toml after.toml"),
    ("export", "antrieb export axis.toml --out axis.xlsx"),
    ("code", "antrieb code parse CHA-20A-100-H-C1024-B"),
    ("parse", "antrieb code parse CHA-20A-100-H-C1024-B"),
    ("list", "antrieb code list CHA-20A-*-H --available"),
    ("complete", "antrieb code complete CHA-14A-100-N"),
    ("data", "antrieb data CHA-20A-100-H-C1024"),
    ("wiring", "antrieb wiring CHA-25A-100-H-M512P-B --check pins.csv"),
    ("catalogue", "antrieb catalogue export --format csv"),
    ("errata", "antrieb errata CHA-25A-50-H-M512P"),
    ("commission", "antrieb commission CHA-25A-100-H-M512P-B --for sinamics"),
    ("torsion", "antrieb torsion CHA-20A-100-H-C1024 --torque \"60 N m\""),
    ("inertia", "antrieb inertia \"disc diameter=200mm length=20mm density=7850kg/m^3\""),
    ("curve", "antrieb curve CHA-20A-100-H-C1024 --voltage \"220 V\""),
    ("plot", "antrieb plot axis.toml --figure torque_speed --svg plane.svg"),
    ("bearing", "antrieb bearing axis.toml"),
    ("battery", "antrieb battery --hours-per-day 10"),
    ("mount", "antrieb mount CHA-25A-100-H-M512P-B --bore K7"),
    ("upkeep", "antrieb upkeep CHA-14A-50-E-M128S --delivered 2026-03-01 --storage \"6 months\" --hours-per-day 10"),
    ("new", "antrieb new arm --out axis.toml"),
    ("serve", "antrieb serve --open"),
    ("glossary", "antrieb glossary T_rms"),
    ("licences", "antrieb licences"),
    ("schema", "antrieb schema"),
    ("completions", "antrieb completions bash"),
    ("man", "antrieb man size"),
    ("help", "antrieb help size"),
];

/// The arguments with `help COMMAND` as `COMMAND --help`, wherever options for all commands stand.
pub(crate) fn with_help_asked(arguments: impl Iterator<Item = OsString>) -> Vec<OsString> {
    let mut arguments: Vec<OsString> = arguments.collect();
    let mut index = 1;
    while let Some(argument) = arguments.get(index).and_then(|argument| argument.to_str()) {
        match argument {
            "--lang" => index += 2,
            "--json" => index += 1,
            "help" => {
                let _ = arguments.remove(index);
                // The flag before what follows: what is asked about need not be whole.
                let words = arguments.iter().skip(index).take_while(|word| !word.to_string_lossy().starts_with('-'));
                let end = index + words.count();
                arguments.insert(end, "--help".into());
                return arguments;
            }
            other if other.starts_with("--lang=") => index += 1,
            _ => return arguments,
        }
    }
    arguments
}

fn commands(language: Language) -> Command {
    let size = Command::new("size")
        .about(help::size(language))
        .arg(project(language))
        .arg(axis(language))
        .arg(
            Arg::new("top")
                .long("top")
                .value_name(values::n(language))
                .default_value("10")
                .value_parser(value_parser!(u16).range(1..))
                .help(help::size_top(language)),
        )
        .arg(Arg::new("all").long("all").action(ArgAction::SetTrue).help(help::size_all(language)));
    let size = size.arg(
        Arg::new("report")
            .long("report")
            .value_name(values::file(language))
            .value_parser(value_parser!(std::path::PathBuf))
            .help(with_report(language, help::size_report(language))),
    );
    let size = sheet(sampling(size, language), language);
    let check = Command::new("check")
        .about(help::check(language))
        .arg(project(language))
        .arg(axis(language))
        .arg(Arg::new("code").long("code").value_name(values::code(language)).help(help::check_code(language)));
    let check = sampling(check, language);
    let explain = Command::new("explain")
        .about(help::explain(language))
        .arg(project(language))
        .arg(axis(language))
        .arg(Arg::new("code").long("code").value_name(values::code(language)).help(help::explain_code(language)))
        .arg(
            Arg::new("check")
                .long("check")
                .value_name(values::check(language))
                .value_parser(PossibleValuesParser::new(workbench::CheckId::ALL.iter().map(|check| check.id())))
                .hide_possible_values(true)
                .help(help::explain_check(language)),
        );
    let code_arg =
        |help: String| Arg::new("code").value_name(values::code(language)).required(true).num_args(1..).help(help);
    let code = Command::new("code")
        .about(help::code(language))
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommand(
            Command::new("parse")
                .about(help::code_parse(language))
                .arg(code_arg(help::code_example(language).to_owned())),
        )
        .subcommand(
            Command::new("list")
                .about(help::code_list(language))
                .arg(Arg::new("pattern").value_name(values::pattern(language)).help(help::code_list_pattern(language)))
                .arg(
                    Arg::new("available")
                        .long("available")
                        .action(ArgAction::SetTrue)
                        .help(help::code_list_available(language)),
                ),
        )
        .subcommand(
            Command::new("complete")
                .about(help::code_complete(language))
                .arg(code_arg(help::code_complete_pattern(language).to_owned())),
        );
    let data =
        Command::new("data").about(help::data(language)).arg(code_arg(capitalised(terms::ordering_code(language))));
    let errata = Command::new("errata").about(help::errata(language)).arg(
        Arg::new("about")
            .value_name(values::code_table_or_id(language))
            .num_args(0..)
            .help(help::errata_about(language)),
    );
    let catalogue = Command::new("catalogue")
        .about(help::catalogue(language))
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommand(
            Command::new("export").about(help::catalogue_export(language)).arg(
                Arg::new("format")
                    .long("format")
                    .value_name(values::format(language))
                    .default_value("csv")
                    .value_parser(PossibleValuesParser::new(["csv", "json"]))
                    .help(help::catalogue_format(language)),
            ),
        );
    let mut languages = Language::ALL.map(Language::id);
    languages.sort_unstable();
    let shells = PossibleValuesParser::new(["bash", "elvish", "fish", "powershell", "zsh"]);
    Command::new(NAME)
        .version(env!("CARGO_PKG_VERSION"))
        .about(help::antrieb(language))
        .after_help(help::exit_codes(language))
        .styles(Styles::styled())
        .subcommand_required(true)
        .arg_required_else_help(true)
        .arg(Arg::new("json").long("json").global(true).action(ArgAction::SetTrue).help(help::json(language)))
        .arg(
            Arg::new("lang")
                .long("lang")
                .global(true)
                .value_name(values::lang(language))
                .value_parser(PossibleValuesParser::new(languages))
                .help(help::lang(language)),
        )
        .subcommand(size)
        .subcommand(check)
        .subcommand(explain)
        .subcommand(report(language))
        .subcommand(compare(language))
        .subcommand(diff(language))
        .subcommand(export(language))
        .subcommand(code)
        .subcommand(data)
        .subcommand(wiring(language))
        .subcommand(errata)
        .subcommand(catalogue)
        .subcommand(
            Command::new("torsion")
                .about(help::torsion(language))
                .arg(
                    Arg::new("code")
                        .value_name(values::code(language))
                        .required(true)
                        .help(capitalised(terms::ordering_code(language))),
                )
                .arg(
                    Arg::new("torque")
                        .long("torque")
                        .value_name(values::torque(language))
                        .required_unless_present("angle")
                        .allow_hyphen_values(true)
                        .help(help::torsion_torque(language)),
                )
                .arg(
                    Arg::new("angle")
                        .long("angle")
                        .value_name(values::angle(language))
                        .conflicts_with("torque")
                        .allow_hyphen_values(true)
                        .help(help::torsion_angle(language)),
                ),
        )
        .subcommand(installation::commission(language))
        .subcommand(inertia(language))
        .subcommand(curve(language))
        .subcommand(plot(language))
        .subcommand(Command::new("bearing").about(help::bearing(language)).arg(project(language)).arg(axis(language)))
        .subcommand(
            Command::new("battery")
                .about(help::battery(language))
                .arg(
                    Arg::new("hours-per-day")
                        .long("hours-per-day")
                        .value_name(values::hours(language))
                        .required(true)
                        .help(help::battery_hours(language)),
                )
                .arg(
                    Arg::new("storage")
                        .long("storage")
                        .value_name(values::time(language))
                        .help(help::battery_storage(language)),
                ),
        )
        .subcommand(files::serve(language))
        .subcommand(installation::mount(language))
        .subcommand(installation::upkeep(language))
        .subcommand(
            Command::new("new")
                .about(help::new(language))
                .arg(
                    Arg::new("kind")
                        .value_name(values::kind(language))
                        .required(true)
                        .value_parser(PossibleValuesParser::new(workbench::template_kinds()))
                        .help("manual, table, arm, screw, belt, recording"),
                )
                .arg(
                    Arg::new("out")
                        .long("out")
                        .short('o')
                        .value_name(values::file(language))
                        .value_parser(value_parser!(std::path::PathBuf))
                        .help(help::new_out(language)),
                )
                .arg(files::force(language)),
        )
        .subcommand(
            Command::new("glossary")
                .about(help::glossary(language))
                .arg(Arg::new("term").value_name(values::term(language)).help(help::glossary_term(language))),
        )
        .subcommand(Command::new("licences").about(help::licences(language)))
        .subcommand(schema(language))
        .subcommand(
            Command::new("completions").about(help::completions(language)).arg(
                Arg::new("shell")
                    .value_name(values::shell(language))
                    .required(true)
                    .value_parser(shells)
                    .help("bash, elvish, fish, powershell, zsh"),
            ),
        )
        .subcommand(Command::new("help").about(help::help(language)).arg(
            Arg::new("command").value_name(values::command(language)).num_args(0..).help(help::help_command(language)),
        ))
        .subcommand(
            Command::new("man")
                .about(help::man(language))
                .arg(Arg::new("command").value_name(values::command(language)).help(help::man_command(language))),
        )
}

fn schema(language: Language) -> Command {
    Command::new("schema")
        .about(help::schema(language))
        .arg(Arg::new("answers").long("answers").action(ArgAction::SetTrue).help(help::schema_answers(language)))
}

fn inertia(language: Language) -> Command {
    let head = help::shapes(language);
    let tail = help::shapes_all(language);
    let mut shapes = String::new();
    for shape in &workbench::BODY_SHAPES {
        let axis = if shape.may_lie { " axis" } else { "" };
        let line = format!("  {:<9} {}{axis}", shape.name, shape.dimensions.join(" "));
        shapes.push_str(line.trim_end());
        shapes.push('\n');
    }
    Command::new("inertia")
        .about(help::inertia(language))
        .arg(
            Arg::new("body")
                .value_name(values::body(language))
                .required(true)
                .num_args(1..)
                .help(help::inertia_body(language)),
        )
        .after_help(format!("{head}\n{shapes}{tail}"))
}

/// The completion script of a shell.
pub(crate) fn completions(matches: &ArgMatches, language: Language) -> Answer {
    let mut out = Vec::new();
    let mut command = build(language);
    let shell = matches.get_one::<String>("shell").and_then(|name| name.parse::<clap_complete::Shell>().ok());
    if let Some(shell) = shell {
        clap_complete::generate(shell, &mut command, NAME, &mut out);
    }
    Answer::data(String::from_utf8_lossy(&out).into_owned())
}

/// A manual page.
pub(crate) fn man(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let mut whole = build(language);
    whole.build();
    let wanted = matches.get_one::<String>("command");
    let page = match wanted {
        None => Some(whole),
        Some(name) => whole.find_subcommand(name).map(|found| found.clone().display_name(format!("{NAME}-{name}"))),
    };
    let Some(page) = page else {
        let written = wanted.cloned().unwrap_or_default();
        return simple(&usage_text(&Usage::UnknownCommand { written }, language), as_json, language);
    };
    let mut out = Vec::new();
    match clap_mangen::Man::new(page).render(&mut out) {
        Ok(()) => Answer::data(library::headings(&String::from_utf8_lossy(&out), language)),
        Err(error) => simple(&error.to_string(), as_json, language),
    }
}
