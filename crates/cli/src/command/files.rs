//! The commands that compare, and those that write files.

use super::{axis, either, project, with_report};
use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgAction, Command, value_parser};
use workbench::Language;

pub(super) fn curve(language: Language) -> Command {
    let t = |en, de| either(language, en, de);
    let command = Command::new("curve")
        .about(t("Curves of the torque-speed plane", "Kennlinien in der Drehmoment-Drehzahl-Ebene"))
        .arg(Arg::new("code").value_name("CODE").required(true).help(t("Ordering code", "Bestellbezeichnung")))
        .arg(Arg::new("voltage").long("voltage").value_name("VOLTAGE").help(t(
            "Terminal voltage of the motor, rms, for example \"220 V\"; without it the maker's range holds",
            "Klemmenspannung des Motors, effektiv, zum Beispiel \"220 V\"; ohne sie gilt der Bereich der Herstellerangaben",
        )));
    picture(command, language)
}

pub(super) fn plot(language: Language) -> Command {
    let t = |en, de| either(language, en, de);
    let command = Command::new("plot")
        .about(t(
            "A picture of an axis on an actuator, as SVG or PNG",
            "Ein Bild einer Achse mit einem Antrieb, als SVG oder PNG",
        ))
        .arg(project(language))
        .arg(axis(language))
        .arg(Arg::new("code").long("code").value_name("CODE").help(t(
            "Ordering code; without it the project's own [actuator], else the best of the catalogue",
            "Bestellbezeichnung; ohne sie der eigene [actuator] des Projekts, sonst der beste des Katalogs",
        )))
        .arg(
            Arg::new("figure")
                .long("figure")
                .value_name("FIGURE")
                .required(true)
                .value_parser(PossibleValuesParser::new(figures::Figure::ALL.map(figures::Figure::id)))
                .help("torque_speed, cycle, utilisation, torsion, bearing_load, candidate_map"),
        )
        .arg(
            Arg::new("by")
                .long("by")
                .value_name("WHAT")
                .default_value("mass")
                .value_parser(PossibleValuesParser::new(["mass", "length"]))
                .help(t(
                    "candidate_map over mass (default) or length",
                    "candidate_map über mass (Masse, Vorgabe) oder length (Länge)",
                )),
        );
    picture(command, language).after_help(t(
        "Without --svg and --png the SVG goes to standard output.",
        "Ohne --svg und --png geht das SVG auf die Standardausgabe.",
    ))
}

/// The options of a command that draws.
fn picture(command: Command, language: Language) -> Command {
    let t = |en, de| either(language, en, de);
    let file = |name, help| {
        Arg::new(name).long(name).value_name("FILE").value_parser(value_parser!(std::path::PathBuf)).help(help)
    };
    let length = |name, help| Arg::new(name).long(name).value_name("LENGTH").help(help);
    command
        .arg(file(
            "svg",
            t(
                "Draw into this SVG file; - is standard output",
                "In diese SVG-Datei zeichnen; - ist die Standardausgabe",
            ),
        ))
        .arg(file("png", t("Draw into this PNG file", "In diese PNG-Datei zeichnen")))
        .arg(
            Arg::new("theme")
                .long("theme")
                .value_name("THEME")
                .default_value("light")
                .value_parser(PossibleValuesParser::new(["light", "dark"]))
                .help(t("light (default) or dark", "light (hell, Vorgabe) oder dark (dunkel)")),
        )
        .arg(length(
            "width",
            t("Width of the picture, for example \"160 mm\"", "Breite des Bildes, zum Beispiel \"160 mm\""),
        ))
        .arg(length(
            "height",
            t(
                "Height of the picture; it grows if its content needs it",
                "Höhe des Bildes; es wächst, wenn sein Inhalt es braucht",
            ),
        ))
        .arg(force(language))
}

pub(super) fn compare(language: Language) -> Command {
    let t = |en, de| either(language, en, de);
    Command::new("compare")
        .about(t(
            "Two to five actuators side by side, check by check",
            "Zwei bis fünf Antriebe nebeneinander, Nachweis für Nachweis",
        ))
        .arg(project(language))
        .arg(axis(language))
        .arg(Arg::new("code").long("code").value_name("CODE").required(true).action(ArgAction::Append).help(t(
            "Ordering code; given once for each actuator",
            "Bestellbezeichnung; für jeden Antrieb einmal anzugeben",
        )))
}

pub(super) fn diff(language: Language) -> Command {
    let t = |en, de| either(language, en, de);
    let file = |name: &'static str, value: &'static str, help| {
        Arg::new(name).value_name(value).required(true).value_parser(value_parser!(std::path::PathBuf)).help(help)
    };
    Command::new("diff")
        .about(t(
            "What another revision of a project changes in each check",
            "Was ein anderer Stand eines Projekts an jedem Nachweis ändert",
        ))
        .arg(file("old", "OLD", t("Project file before", "Projektdatei vorher")))
        .arg(
            file(
                "new",
                "NEW",
                t(
                    "Project file after; its verdict is the exit code",
                    "Projektdatei nachher; ihr Urteil ist der Rückgabewert",
                ),
            )
            .display_order(2),
        )
        .arg(axis(language))
        .arg(Arg::new("code").long("code").value_name("CODE").help(t(
            "Ordering code; without it the project's own [actuator], else the best before",
            "Bestellbezeichnung; ohne sie der eigene [actuator] des Projekts, sonst der beste vorher",
        )))
}

pub(super) fn export(language: Language) -> Command {
    let t = |en, de| either(language, en, de);
    let text = |name: &'static str, value: &'static str, help| Arg::new(name).long(name).value_name(value).help(help);
    Command::new("export")
        .about(t(
            "The results as a workbook, or one table as CSV, JSON or Parquet",
            "Die Ergebnisse als Arbeitsmappe, oder eine Tabelle als CSV, JSON oder Parquet",
        ))
        .arg(project(language))
        .arg(axis(language))
        .arg(text("code", "CODE", t(
            "Ordering code; without it the project's own [actuator], else the best",
            "Bestellbezeichnung; ohne sie der eigene [actuator] des Projekts, sonst der beste",
        )))
        .arg(
            text("out", "FILE", t(
                "File to write, by its ending: .xlsx, .csv, .json, .parquet; - or none: CSV to standard output",
                "Zieldatei, nach ihrer Endung: .xlsx, .csv, .json, .parquet; - oder keine: CSV auf die Standardausgabe",
            ))
            .short('o')
            .value_parser(value_parser!(std::path::PathBuf)),
        )
        .arg(text("table", "NAME", t(
            "One table: inputs, assumptions, demand, motion, candidates, checks, course",
            "Eine Tabelle: inputs, assumptions, demand, motion, candidates, checks, course",
        )))
        .arg(
            text("top", "N", t(
                "How many of the ranking the tables hold (20)",
                "Wie viele der Reihenfolge die Tabellen enthalten (20)",
            ))
            .default_value("20")
            .value_parser(value_parser!(u16).range(1..)),
        )
        .arg(text("revision", "TEXT", t("Revision for the first sheet", "Revision für das erste Blatt")))
        .arg(text("date", "DATE", t(
            "Date for the first sheet; none without it, so that the same call gives the same bytes",
            "Datum für das erste Blatt; ohne Angabe keines, damit derselbe Aufruf dieselben Bytes gibt",
        )))
        .arg(force(language))
}

pub(super) fn report(language: Language) -> Command {
    let t = |en, de| either(language, en, de);
    let text = |name: &'static str, value: &'static str, help| Arg::new(name).long(name).value_name(value).help(help);
    let command = Command::new("report")
        .about(with_report(language, t("The results as a PDF to sign", "Die Ergebnisse als PDF zum Unterschreiben")))
        .arg(project(language))
        .arg(axis(language))
        .arg(text(
            "code",
            "CODE",
            t(
                "Ordering code; without it the project's own [actuator], else the best of the catalogue",
                "Bestellbezeichnung; ohne sie der eigene [actuator] des Projekts, sonst der beste des Katalogs",
            ),
        ))
        .arg(
            text("out", "FILE", t("PDF file to write", "Zu schreibende PDF-Datei"))
                .short('o')
                .required(true)
                .value_parser(value_parser!(std::path::PathBuf)),
        )
        .arg(Arg::new("full").long("full").action(ArgAction::SetTrue).help(t(
            "With the derivation of every check, all sources and all codes as appendices",
            "Mit Herleitung jedes Nachweises, allen Quellen und allen Bestellbezeichnungen im Anhang",
        )));
    sheet(command, language)
}

/// What stands on the title page.
pub(super) fn sheet(command: Command, language: Language) -> Command {
    let t = |en, de| either(language, en, de);
    let text = |name: &'static str, value: &'static str, help| Arg::new(name).long(name).value_name(value).help(help);
    command
        .arg(text(
            "date",
            "DATE",
            t(
                "Date of the document, 2026-11-21; none without it, so that the same call gives the same bytes",
                "Datum des Dokuments, 2026-11-21; ohne Angabe keines, damit derselbe Aufruf dieselben Bytes gibt",
            ),
        ))
        .arg(text("revision", "TEXT", t("Revision of the document", "Revision des Dokuments")))
        .arg(text("title", "TEXT", t("Project, plant or order", "Projekt, Anlage oder Auftrag")))
        .arg(text("number", "TEXT", t("Number of the document", "Nummer des Dokuments")))
        .arg(text("author", "TEXT", t("Who made it", "Bearbeitet von")))
        .arg(text("company", "TEXT", t("Company or office", "Firma oder Büro")))
        .arg(
            Arg::new("archive")
                .long("archive")
                .action(ArgAction::SetTrue)
                .help(t("As PDF/A for archiving; needs --date", "Als PDF/A zum Archivieren; braucht --date")),
        )
        .arg(force(language))
}

pub(super) fn force(language: Language) -> Arg {
    let help = either(language, "Replace a file that exists", "Eine vorhandene Datei ersetzen");
    Arg::new("force").long("force").action(ArgAction::SetTrue).help(help)
}

/// How much memory the recordings of a project may take.
pub(super) fn memory(language: Language) -> Arg {
    Arg::new("memory").long("memory").value_name("SIZE").help(either(
        language,
        "Memory for the recordings of the project (512 MiB, or variable ANTRIEB_MEMORY)",
        "Speicher für die Aufzeichnungen des Projekts (512 MiB, oder Variable ANTRIEB_MEMORY)",
    ))
}
