//! The commands of what follows from an ordering code: mounting, commissioning and upkeep.

use super::{axis, files::force, with_report};
use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgAction, ArgGroup, Command, value_parser};
use workbench::text::help::values;
use workbench::text::{capitalised, help, terms};
use workbench::{DriveForm, Language};

fn code(language: Language) -> Arg {
    Arg::new("code")
        .value_name(values::code(language))
        .required(true)
        .num_args(1..)
        .help(capitalised(terms::ordering_code(language)))
}

fn text(name: &'static str, value: &'static str, help: &'static str) -> Arg {
    Arg::new(name).long(name).value_name(value).help(help)
}

pub(super) fn mount(language: Language) -> Command {
    let bore = |name, help| text(name, values::bore(language), help).allow_hyphen_values(true);
    Command::new("mount")
        .about(help::mount(language))
        .arg(code(language))
        .arg(bore("bore", help::mount_bore(language)))
        .arg(bore("bore-load", help::mount_bore_load(language)))
        .arg(bore("bore-housing", help::mount_bore_housing(language)))
        .arg(
            text("project", values::file(language), help::mount_project(language))
                .value_parser(value_parser!(std::path::PathBuf)),
        )
        .arg(axis(language).requires("project"))
}

pub(super) fn upkeep(language: Language) -> Command {
    let date = |name, help| text(name, values::date(language), help);
    Command::new("upkeep")
        .about(help::upkeep(language))
        .arg(code(language))
        .arg(date("delivered", help::upkeep_delivered(language)).required(true))
        .arg(text("storage", values::interval(language), help::upkeep_storage(language)))
        .arg(text("hours-per-day", values::hours(language), help::upkeep_hours(language)).allow_hyphen_values(true))
        .arg(text("inspect", values::interval(language), help::upkeep_inspect(language)))
        .arg(date("today", help::upkeep_today(language)))
        .arg(
            text("ical", values::file(language), help::upkeep_ical(language))
                .value_parser(value_parser!(std::path::PathBuf)),
        )
        .arg(text("name", values::text(language), help::upkeep_name(language)).action(ArgAction::Set))
        .arg(force(language))
}

pub(super) fn commission(language: Language) -> Command {
    let file = |name: &'static str, help: String| {
        Arg::new(name)
            .long(name)
            .value_name(values::file(language))
            .value_parser(value_parser!(std::path::PathBuf))
            .help(help)
    };
    Command::new("commission")
        .about(help::commission(language))
        .arg(code(language))
        .arg(
            Arg::new("for")
                .long("for")
                .value_name(values::drive(language))
                .value_parser(PossibleValuesParser::new(DriveForm::ALL.map(DriveForm::id)))
                .help(help::commission_for(language)),
        )
        .arg(
            Arg::new("ambient")
                .long("ambient")
                .value_name(values::temperature(language))
                .allow_hyphen_values(true)
                .help(help::commission_ambient(language)),
        )
        .arg(file("out", help::commission_out(language).to_owned()).short('o').requires("for"))
        .arg(file("checklist", with_report(language, help::commission_checklist(language))))
        .arg(file("record", help::commission_record(language).to_owned()))
        .arg(file("blank", help::commission_blank(language).to_owned()))
        .arg(force(language))
        .group(ArgGroup::new("wanted").args(["for", "checklist", "record", "blank"]).multiple(true).required(true))
        .after_help(help::commission_exit(language))
}
