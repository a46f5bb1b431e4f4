//! The commands and their help, in English and German.

use crate::answer::Answer;
use crate::fault::simple;
use clap::builder::{PossibleValuesParser, Styles};
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use std::ffi::OsString;
use workbench::Language;
use workbench::text::{Usage, usage_text};

const NAME: &str = "antrieb";
const LANG_VARIABLE: &str = "ANTRIEB_LANG";

mod files;
pub(crate) mod german;
pub(crate) mod usage;

use files::{compare, curve, diff, export, plot, report, sheet};

fn either(language: Language, en: &'static str, de: &'static str) -> &'static str {
    match language {
        Language::En => en,
        Language::De => de,
    }
}

/// A help text, with a remark where the program was built without the typesetting engine.
fn with_report(language: Language, help: &str) -> String {
    let remark = either(language, " (not in this build)", " (in dieser Ausführung nicht enthalten)");
    format!("{help}{}", if cfg!(feature = "report") { "" } else { remark })
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
    if wanted.is_some_and(|wanted| wanted.eq_ignore_ascii_case("de")) { Language::De } else { Language::En }
}

/// Whether JSON is asked for, however faulty the rest of the call may be.
pub(crate) fn json_of(arguments: &[OsString]) -> bool {
    arguments.iter().skip(1).take_while(|argument| *argument != "--").any(|argument| argument == "--json")
}

fn project(language: Language) -> Arg {
    Arg::new("project").value_name("PROJECT").required(true).value_parser(value_parser!(std::path::PathBuf)).help(
        either(
            language,
            "Project file (TOML); - reads standard input",
            "Projektdatei (TOML); - liest die Standardeingabe",
        ),
    )
}

fn axis(language: Language) -> Arg {
    Arg::new("axis").long("axis").value_name("NAME").help(either(
        language,
        "Only this axis of a project with several",
        "Nur diese Achse eines Projekts mit mehreren",
    ))
}

fn sampling(command: Command, language: Language) -> Command {
    let most = i64::try_from(workbench::SAMPLES_MOST).unwrap_or(i64::MAX);
    command
        .arg(Arg::new("samples").long("samples").value_name("N").value_parser(value_parser!(u32).range(1..=most)).help(
            either(
                language,
                "Samples within the tolerances of the project (10000)",
                "Stichproben in den Toleranzen des Projekts (10000)",
            ),
        ))
        .arg(Arg::new("seed").long("seed").value_name("N").value_parser(value_parser!(u64)).help(either(
            language,
            "Seed of the samples; the same seed draws the same (1)",
            "Startwert der Stichproben; derselbe Startwert zieht dasselbe (1)",
        )))
}

/// The whole command line.
pub(crate) fn build(language: Language) -> Command {
    let mut whole = headed(commands(language), language);
    if language == Language::De {
        whole.build();
        whole = german::usage(whole);
    }
    whole
}

/// Gives a command and all its subcommands the headings of the language and a help flag in it.
fn headed(command: Command, language: Language) -> Command {
    let t = |en, de| either(language, en, de);
    let reads_a_project =
        command.get_arguments().any(|argument| ["project", "old"].contains(&argument.get_id().as_str()));
    let command = if reads_a_project { command.arg(files::memory(language)) } else { command };
    let mut command = command
        .disable_help_flag(true)
        .disable_help_subcommand(true)
        .help_template(match language {
            Language::En => "{about}\n\nUsage: {usage}\n\n{all-args}{after-help}",
            Language::De => "{about}\n\nAufruf: {usage}\n\n{all-args}{after-help}",
        })
        .subcommand_help_heading(t("Commands", "Befehle"))
        .mut_args(|argument| {
            let argument = if language == Language::De { german::value(argument) } else { argument };
            let heading = if argument.is_positional() { t("Arguments", "Argumente") } else { t("Options", "Optionen") };
            let takes_value = argument.get_action().takes_values();
            argument.help_heading(heading).hide_default_value(takes_value).hide_possible_values(takes_value)
        })
        .arg(
            Arg::new("help")
                .short('h')
                .long("help")
                .action(ArgAction::Help)
                .help_heading(t("Options", "Optionen"))
                .help(t("Print this help", "Diese Hilfe zeigen")),
        );
    if command.get_name() == NAME {
        command = command.disable_version_flag(true).arg(
            Arg::new("version")
                .short('V')
                .long("version")
                .action(ArgAction::Version)
                .help_heading(t("Options", "Optionen"))
                .help(t("Print the version", "Die Version zeigen")),
        );
    }
    let example = EXAMPLES.iter().find(|(name, _)| *name == command.get_name());
    if let Some((_, call)) = example {
        let told = command.get_after_help().map(|text| format!("{text}\n\n")).unwrap_or_default();
        command = command.after_help(format!("{told}{}\n  {call}", t("Example:", "Beispiel:")));
    }
    command.mut_subcommands(|subcommand| headed(subcommand, language))
}

/// One call of each command; every one of them runs.
pub(crate) const EXAMPLES: [(&str, &str); 27] = [
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
    ("catalogue", "antrieb catalogue export --format csv"),
    ("errata", "antrieb errata CHA-25A-50-H-M512P"),
    ("torsion", "antrieb torsion CHA-20A-100-H-C1024 --torque \"60 N m\""),
    ("inertia", "antrieb inertia \"disc diameter=200mm length=20mm density=7850kg/m^3\""),
    ("curve", "antrieb curve CHA-20A-100-H-C1024 --voltage \"220 V\""),
    ("plot", "antrieb plot axis.toml --figure torque_speed --svg plane.svg"),
    ("bearing", "antrieb bearing axis.toml"),
    ("battery", "antrieb battery --hours-per-day 10"),
    ("new", "antrieb new arm --out axis.toml"),
    ("glossary", "antrieb glossary T_rms"),
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
    let t = |en, de| either(language, en, de);
    let size = Command::new("size")
        .about(t("Rank the whole catalogue for an axis", "Den ganzen Katalog für eine Achse ordnen"))
        .arg(project(language))
        .arg(axis(language))
        .arg(
            Arg::new("top")
                .long("top")
                .value_name("N")
                .default_value("10")
                .value_parser(value_parser!(u16).range(1..))
                .help(t("How many fitting actuators to show (10)", "Wie viele geeignete Antriebe gezeigt werden (10)")),
        )
        .arg(Arg::new("all").long("all").action(ArgAction::SetTrue).help(t(
            "Show every actuator, the rejected ones with their reason",
            "Alle Antriebe zeigen, die verworfenen mit Grund",
        )));
    let size = size.arg(
        Arg::new("report").long("report").value_name("FILE").value_parser(value_parser!(std::path::PathBuf)).help(
            with_report(language, t("Write the report of the best as PDF", "Den Bericht des besten als PDF schreiben")),
        ),
    );
    let size = sheet(sampling(size, language), language);
    let check = Command::new("check")
        .about(t(
            "Judge one actuator, every check with its margin",
            "Einen Antrieb beurteilen, jeden Nachweis mit seiner Reserve",
        ))
        .arg(project(language))
        .arg(axis(language))
        .arg(Arg::new("code").long("code").value_name("CODE").help(t(
            "Ordering code; without it the project's own [actuator] is judged",
            "Bestellbezeichnung; ohne sie wird der eigene [actuator] des Projekts beurteilt",
        )));
    let check = sampling(check, language);
    let explain = Command::new("explain")
        .about(t(
            "Derive the checks of one actuator, figures put in",
            "Die Nachweise eines Antriebs herleiten, mit eingesetzten Zahlen",
        ))
        .arg(project(language))
        .arg(axis(language))
        .arg(Arg::new("code").long("code").value_name("CODE").help(t(
            "Ordering code; without it the project's own [actuator] is explained",
            "Bestellbezeichnung; ohne sie wird der eigene [actuator] des Projekts hergeleitet",
        )))
        .arg(
            Arg::new("check")
                .long("check")
                .value_name("CHECK")
                .value_parser(PossibleValuesParser::new(workbench::CheckId::ALL.iter().map(|check| check.id())))
                .hide_possible_values(true)
                .help(t(
                    "One check, for example continuous_torque; all without it",
                    "Einen Nachweis, zum Beispiel continuous_torque; ohne Angabe alle",
                )),
        );
    let code_arg = |help| Arg::new("code").value_name("CODE").required(true).num_args(1..).help(help);
    let code = Command::new("code")
        .about(t("Read, list and complete ordering codes", "Bestellbezeichnungen lesen, auflisten und ergänzen"))
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommand(
            Command::new("parse")
                .about(t("Read a code and explain each field", "Einen Code lesen und jedes Feld erklären"))
                .arg(code_arg(t(
                    "Ordering code, for example CHA-20A-100-H-C1024-B",
                    "Bestellbezeichnung, zum Beispiel CHA-20A-100-H-C1024-B",
                ))),
        )
        .subcommand(
            Command::new("list")
                .about(t("List the valid codes", "Die gültigen Codes auflisten"))
                .arg(Arg::new("pattern").value_name("PATTERN").help(t(
                    "Partial code, for example CHA-20A-*-H; all without it",
                    "Teilcode, zum Beispiel CHA-20A-*-H; ohne ihn alle",
                )))
                .arg(Arg::new("available").long("available").action(ArgAction::SetTrue).help(t(
                    "Only codes that are available without asking",
                    "Nur Codes, die ohne Anfrage verfügbar sind",
                ))),
        )
        .subcommand(
            Command::new("complete")
                .about(t(
                    "Complete a partial code and say what may follow",
                    "Einen Teilcode ergänzen und zeigen, was folgen kann",
                ))
                .arg(code_arg(t(
                    "Partial code; * stands for any value of a field",
                    "Teilcode; * steht für jeden Wert eines Feldes",
                ))),
        );
    let data = Command::new("data")
        .about(t(
            "Data sheet of one actuator, each value with its table",
            "Datenblatt eines Antriebs, jeder Wert mit seiner Tabelle",
        ))
        .arg(code_arg(t("Ordering code", "Bestellbezeichnung")));
    let errata = Command::new("errata")
        .about(t(
            "What is wrong or in doubt in the print, and what is used",
            "Was im Druck falsch oder zweifelhaft ist, und was verwendet wird",
        ))
        .arg(Arg::new("about").value_name("CODE | TABLE | ID").num_args(0..).help(t(
            "Ordering code, number of a table, or id of an erratum; all without it",
            "Bestellbezeichnung, Nummer einer Tabelle oder Name eines Druckfehlers; ohne Angabe alle",
        )));
    let catalogue = Command::new("catalogue")
        .about(t("The whole catalogue", "Der ganze Katalog"))
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommand(
            Command::new("export")
                .about(t(
                    "Every cell of the maker's tables in long form",
                    "Jede Zelle der Herstellertabellen in langer Form",
                ))
                .arg(
                    Arg::new("format")
                        .long("format")
                        .value_name("FORMAT")
                        .default_value("csv")
                        .value_parser(PossibleValuesParser::new(["csv", "json"]))
                        .help(t("csv (default) or json", "csv (Vorgabe) oder json")),
                ),
        );
    let shells = PossibleValuesParser::new(["bash", "elvish", "fish", "powershell", "zsh"]);
    Command::new(NAME)
        .version(env!("CARGO_PKG_VERSION"))
        .about(t(
            "Engineering workbench for hollow-shaft servo actuators of the CHA series",
            "Auslegungswerkzeug für Hohlwellen-Servoantriebe der Baureihe CHA",
        ))
        .after_help(t(
            "Exit code: 0 fits or answered, 1 does not fit, 2 the question could not be answered.",
            "Rückgabewert: 0 geeignet oder beantwortet, 1 nicht geeignet, 2 die Frage ließ sich nicht beantworten.",
        ))
        .styles(Styles::styled())
        .subcommand_required(true)
        .arg_required_else_help(true)
        .arg(
            Arg::new("json")
                .long("json")
                .global(true)
                .action(ArgAction::SetTrue)
                .help(t("Answer as JSON", "Antwort als JSON")),
        )
        .arg(
            Arg::new("lang")
                .long("lang")
                .global(true)
                .value_name("LANG")
                .value_parser(PossibleValuesParser::new(["de", "en"]))
                .help(t(
                    "Language of the answer, en or de (or variable ANTRIEB_LANG)",
                    "Sprache der Antwort, en oder de (oder Variable ANTRIEB_LANG)",
                )),
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
        .subcommand(errata)
        .subcommand(catalogue)
        .subcommand(
            Command::new("torsion")
                .about(t("Torsion of the gear under a torque", "Torsion des Getriebes unter einem Drehmoment"))
                .arg(Arg::new("code").value_name("CODE").required(true).help(t("Ordering code", "Bestellbezeichnung")))
                .arg(
                    Arg::new("torque")
                        .long("torque")
                        .value_name("TORQUE")
                        .required(true)
                        .allow_hyphen_values(true)
                        .help(t(
                            "Torque at the output, for example \"60 N m\"",
                            "Drehmoment am Abtrieb, zum Beispiel \"60 N m\"",
                        )),
                ),
        )
        .subcommand(inertia(language))
        .subcommand(curve(language))
        .subcommand(plot(language))
        .subcommand(
            Command::new("bearing")
                .about(t(
                    "The output bearing of every size under a project's loads",
                    "Das Abtriebslager jeder Baugröße unter den Lasten eines Projekts",
                ))
                .arg(project(language))
                .arg(axis(language)),
        )
        .subcommand(
            Command::new("battery")
                .about(t("Life of the battery of the M128S encoder", "Lebensdauer der Batterie des Gebers M128S"))
                .arg(
                    Arg::new("hours-per-day")
                        .long("hours-per-day")
                        .value_name("HOURS")
                        .required(true)
                        .help(t("Hours of operation a day, 0 to 24", "Betriebsstunden je Tag, 0 bis 24")),
                )
                .arg(Arg::new("storage").long("storage").value_name("TIME").help(t(
                    "Storage before operation, for example \"1 a\"; none without it",
                    "Lagerung vor dem Betrieb, zum Beispiel \"1 a\"; ohne Angabe keine",
                ))),
        )
        .subcommand(
            Command::new("new")
                .about(t("A commented project file to fill in", "Eine kommentierte Projektdatei zum Ausfüllen"))
                .arg(
                    Arg::new("kind")
                        .value_name("KIND")
                        .required(true)
                        .value_parser(PossibleValuesParser::new(workbench::template_kinds()))
                        .help("manual, table, arm, screw, belt, recording"),
                )
                .arg(
                    Arg::new("out")
                        .long("out")
                        .short('o')
                        .value_name("FILE")
                        .value_parser(value_parser!(std::path::PathBuf))
                        .help(t(
                            "Project file to write, with an example recording beside it for kind recording",
                            "Zu schreibende Projektdatei; bei der Art recording mit einer Beispielaufzeichnung daneben",
                        )),
                )
                .arg(files::force(language)),
        )
        .subcommand(
            Command::new("glossary")
                .about(t(
                    "Words and symbols with their meaning, in both languages",
                    "Wörter und Zeichen mit ihrer Bedeutung, in beiden Sprachen",
                ))
                .arg(Arg::new("term").value_name("TERM").help(t(
                    "Symbol, name or word, for example T_rms; all without it",
                    "Zeichen, Name oder Wort, zum Beispiel T_rms; ohne Angabe alle",
                ))),
        )
        .subcommand(schema(language))
        .subcommand(
            Command::new("completions")
                .about(t("Completion script for a shell", "Vervollständigung für eine Shell"))
                .arg(Arg::new("shell").required(true).value_parser(shells).help("bash, elvish, fish, powershell, zsh")),
        )
        .subcommand(
            Command::new("help").about(t("Help on a command", "Hilfe zu einem Befehl")).arg(
                Arg::new("command")
                    .value_name("COMMAND")
                    .num_args(0..)
                    .help(t("Command; all of them without it", "Befehl; ohne ihn alle")),
            ),
        )
        .subcommand(
            Command::new("man").about(t("Manual page (roff)", "Handbuchseite (roff)")).arg(
                Arg::new("command")
                    .value_name("COMMAND")
                    .help(t("Command; antrieb itself without it", "Befehl; ohne ihn antrieb selbst")),
            ),
        )
}

fn schema(language: Language) -> Command {
    Command::new("schema")
        .about(either(
            language,
            "JSON Schema of the project file, or of the answers",
            "JSON-Schema der Projektdatei oder der Antworten",
        ))
        .arg(Arg::new("answers").long("answers").action(ArgAction::SetTrue).help(either(
            language,
            "What --json writes for each command",
            "Was --json bei jedem Befehl schreibt",
        )))
}

fn inertia(language: Language) -> Command {
    let t = |en, de| either(language, en, de);
    let head = t(
        "Shapes and their keys (axis: parallel or perpendicular to the axis of rotation):",
        "Formen und ihre Schlüssel (axis: parallel oder perpendicular, senkrecht zur Drehachse):",
    );
    let tail = t(
        "All: mass or density; distance from the axis of rotation (0), angle (0), count evenly spaced (1).",
        "Alle: mass oder density; distance von der Drehachse (0), angle (0), count gleichmäßig verteilt (1).",
    );
    let mut shapes = String::new();
    for shape in &workbench::BODY_SHAPES {
        let axis = if shape.may_lie { " axis" } else { "" };
        let line = format!("  {:<9} {}{axis}", shape.name, shape.dimensions.join(" "));
        shapes.push_str(line.trim_end());
        shapes.push('\n');
    }
    Command::new("inertia")
        .about(t("Moment of inertia of solid bodies", "Massenträgheitsmoment fester Körper"))
        .arg(Arg::new("body").value_name("BODY").required(true).num_args(1..).help(t(
            "Each body in quotes, for example \"disc diameter=200mm length=20mm density=7850kg/m^3\"",
            "Jeder Körper in Anführungszeichen, etwa \"disc diameter=200mm length=20mm density=7850kg/m^3\"",
        )))
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
        Ok(()) => Answer::data(german::headings(&String::from_utf8_lossy(&out), language)),
        Err(error) => simple(&error.to_string(), as_json, language),
    }
}
