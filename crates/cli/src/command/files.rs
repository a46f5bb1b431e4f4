//! The commands that compare, and those that write files.

use super::{axis, project, with_report};
use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgAction, Command, value_parser};
use workbench::Language;
use workbench::text::help::values;
use workbench::text::{capitalised, help, terms};

pub(super) fn curve(language: Language) -> Command {
    let command = Command::new("curve")
        .about(help::curve(language))
        .arg(
            Arg::new("code")
                .value_name(values::code(language))
                .required(true)
                .help(capitalised(terms::ordering_code(language))),
        )
        .arg(
            Arg::new("voltage")
                .long("voltage")
                .value_name(values::voltage(language))
                .help(help::curve_voltage(language)),
        );
    picture(command, language)
}

pub(super) fn plot(language: Language) -> Command {
    let command = Command::new("plot")
        .about(help::plot(language))
        .arg(project(language))
        .arg(axis(language))
        .arg(Arg::new("code").long("code").value_name(values::code(language)).help(help::own_or_best_code(language)))
        .arg(
            Arg::new("figure")
                .long("figure")
                .value_name(values::figure(language))
                .required(true)
                .value_parser(PossibleValuesParser::new(figures::Figure::ALL.map(figures::Figure::id)))
                .help("torque_speed, cycle, utilisation, torsion, bearing_load, candidate_map"),
        )
        .arg(
            Arg::new("by")
                .long("by")
                .value_name(values::what(language))
                .default_value("mass")
                .value_parser(PossibleValuesParser::new(["mass", "length"]))
                .help(help::plot_by(language)),
        );
    picture(command, language).after_help(help::plot_without_files(language))
}

pub(super) fn wiring(language: Language) -> Command {
    let command = Command::new("wiring")
        .about(help::wiring(language))
        .arg(
            Arg::new("code")
                .value_name(values::code(language))
                .required(true)
                .num_args(1..)
                .help(capitalised(terms::ordering_code(language))),
        )
        .arg(
            Arg::new("check")
                .long("check")
                .value_name(values::file(language))
                .value_parser(value_parser!(std::path::PathBuf))
                .help(help::wiring_check(language)),
        )
        .arg(Arg::new("length").long("length").value_name(values::length(language)).help(help::wiring_length(language)))
        .arg(
            Arg::new("cross-section")
                .long("cross-section")
                .value_name(values::area(language))
                .requires("length")
                .help(help::wiring_section(language)),
        )
        .arg(
            Arg::new("connector")
                .long("connector")
                .value_name(values::connector(language))
                .value_parser(PossibleValuesParser::new(workbench::Role::ALL.iter().map(|role| role.id())))
                .help(help::wiring_connector(language)),
        );
    picture(command, language)
}

/// The options of a command that draws.
fn picture(command: Command, language: Language) -> Command {
    let file = |name, help| {
        Arg::new(name)
            .long(name)
            .value_name(values::file(language))
            .value_parser(value_parser!(std::path::PathBuf))
            .help(help)
    };
    let length = |name, help| Arg::new(name).long(name).value_name(values::length(language)).help(help);
    command
        .arg(file("svg", help::svg(language)))
        .arg(file("png", help::png(language)))
        .arg(
            Arg::new("theme")
                .long("theme")
                .value_name(values::theme(language))
                .default_value("light")
                .value_parser(PossibleValuesParser::new(["light", "dark"]))
                .help(help::theme(language)),
        )
        .arg(length("width", help::width(language)))
        .arg(length("height", help::height(language)))
        .arg(force(language))
}

pub(super) fn compare(language: Language) -> Command {
    Command::new("compare").about(help::compare(language)).arg(project(language)).arg(axis(language)).arg(
        Arg::new("code")
            .long("code")
            .value_name(values::code(language))
            .required(true)
            .action(ArgAction::Append)
            .help(help::compare_code(language)),
    )
}

pub(super) fn diff(language: Language) -> Command {
    let file = |name: &'static str, value: &'static str, help| {
        Arg::new(name).value_name(value).required(true).value_parser(value_parser!(std::path::PathBuf)).help(help)
    };
    Command::new("diff")
        .about(help::diff(language))
        .arg(file("old", values::old(language), help::diff_old(language)))
        .arg(file("new", values::new(language), help::diff_new(language)).display_order(2))
        .arg(axis(language))
        .arg(Arg::new("code").long("code").value_name(values::code(language)).help(help::diff_code(language)))
}

pub(super) fn export(language: Language) -> Command {
    let text = |name: &'static str, value: &'static str, help| Arg::new(name).long(name).value_name(value).help(help);
    Command::new("export")
        .about(help::export(language))
        .arg(project(language))
        .arg(axis(language))
        .arg(text("code", values::code(language), help::export_code(language)))
        .arg(
            text("out", values::file(language), help::export_out(language))
                .short('o')
                .value_parser(value_parser!(std::path::PathBuf)),
        )
        .arg(text("table", values::name(language), help::export_table(language)))
        .arg(
            text("top", values::n(language), help::export_top(language))
                .default_value("20")
                .value_parser(value_parser!(u16).range(1..)),
        )
        .arg(text("revision", values::text(language), help::export_revision(language)))
        .arg(text("date", values::date(language), help::export_date(language)))
        .arg(force(language))
}

pub(super) fn report(language: Language) -> Command {
    let text = |name: &'static str, value: &'static str, help| Arg::new(name).long(name).value_name(value).help(help);
    let command = Command::new("report")
        .about(with_report(language, help::report(language)))
        .arg(project(language))
        .arg(axis(language))
        .arg(text("code", values::code(language), help::own_or_best_code(language)))
        .arg(
            text("out", values::file(language), help::report_out(language))
                .short('o')
                .required(true)
                .value_parser(value_parser!(std::path::PathBuf)),
        )
        .arg(Arg::new("full").long("full").action(ArgAction::SetTrue).help(help::report_full(language)))
        .arg(
            Arg::new("installation")
                .long("installation")
                .action(ArgAction::SetTrue)
                .help(help::report_installation(language)),
        )
        .arg(text("delivered", values::date(language), help::report_delivered(language)).requires("installation"));
    sheet(command, language)
}

/// What stands on the title page.
pub(super) fn sheet(command: Command, language: Language) -> Command {
    let text = |name: &'static str, value: &'static str, help| Arg::new(name).long(name).value_name(value).help(help);
    command
        .arg(text("date", values::date(language), help::date(language)))
        .arg(text("revision", values::text(language), help::revision(language)))
        .arg(text("title", values::text(language), help::title(language)))
        .arg(text("number", values::text(language), help::number(language)))
        .arg(text("author", values::text(language), help::author(language)))
        .arg(text("company", values::text(language), help::company(language)))
        .arg(Arg::new("archive").long("archive").action(ArgAction::SetTrue).help(help::archive(language)))
        .arg(force(language))
}

pub(super) fn force(language: Language) -> Arg {
    let help = help::force(language);
    Arg::new("force").long("force").action(ArgAction::SetTrue).help(help)
}

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
        .arg(
            Arg::new("port")
                .long("port")
                .value_name(values::n(language))
                .value_parser(value_parser!(u16))
                .help(help::serve_port(language)),
        )
        .arg(Arg::new("open").long("open").action(ArgAction::SetTrue).help(help::serve_open(language)))
        .arg(
            Arg::new("listen")
                .long("listen")
                .value_name(values::address(language))
                .help(help::serve_listen(&one, &all, language)),
        )
        .arg(memory(language))
}

/// How much memory the recordings of a project may take.
pub(super) fn memory(language: Language) -> Arg {
    Arg::new("memory").long("memory").value_name(values::size(language)).help(help::memory(language))
}
