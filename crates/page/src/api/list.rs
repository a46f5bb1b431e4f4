//! What can be asked.

use super::Kind::{Date, Flag, Text, Whole, Word};
#[cfg(feature = "interface")]
use super::tables;
use super::{Body, Endpoint, Output, Parameter, axis, code, library};
use crate::Method::{Get, Post};
use figures::Figure;
use workbench::text::{help, requests};
use workbench::{CheckId, DriveForm, SAMPLES_MOST};

/// Media types beside JSON.
pub(super) const SVG: &str = "image/svg+xml";
pub(super) const PDF: &str = "application/pdf";
pub(super) const CSV: &str = "text/csv; charset=utf-8";
pub(super) const TOML: &str = "application/toml; charset=utf-8";
pub(super) const XLSX: &str = "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet";
pub(super) const PLAIN: &str = "text/plain; charset=utf-8";
pub(super) const CALENDAR: &str = "text/calendar; charset=utf-8";
pub(super) const PARQUET: &str = "application/vnd.apache.parquet";

const AXIS: Parameter = Parameter::of("axis", help::axis, Text);
const FILE: Parameter = Parameter::of("file", requests::file, Text);
#[allow(clippy::cast_possible_truncation, reason = "a million")]
const SAMPLES: Parameter = Parameter::of("samples", help::samples, Whole(1, SAMPLES_MOST as u64));
const SEED: Parameter = Parameter::of("seed", help::seed, Whole(0, u64::MAX));
const CODE: Parameter = Parameter::of("code", help::code_example, Text).required();
const OWN_OR_BEST: Parameter = Parameter::of("code", help::own_or_best_code, Text);
const WIDTH: Parameter = Parameter::of("width", help::width, Text);
const HEIGHT: Parameter = Parameter::of("height", help::height, Text);
const THEME: Parameter = Parameter::of("theme", help::theme, Word(|| vec!["light", "dark"]));

/// As many as the command line takes.
const fn top(about: workbench::text::Word) -> Parameter {
    Parameter::of("top", about, Whole(1, u16::MAX as u64))
}

fn checks() -> Vec<&'static str> {
    CheckId::ALL.iter().map(|check| check.id()).collect()
}

fn figures() -> Vec<&'static str> {
    Figure::ALL.map(Figure::id).to_vec()
}

fn forms() -> Vec<&'static str> {
    DriveForm::ALL.map(DriveForm::id).to_vec()
}

/// Every endpoint, in the order in which they are told.
pub(super) const ENDPOINTS: &[Endpoint] = &[
    Endpoint {
        method: Post,
        path: "size",
        about: help::size,
        body: Body::Project,
        parameters: &[AXIS, FILE, top(help::size_top), Parameter::of("all", help::size_all, Flag), SAMPLES, SEED],
        output: Output::Record("size"),
        #[cfg(feature = "interface")]
        answer: axis::size,
    },
    Endpoint {
        method: Post,
        path: "check",
        about: help::check,
        body: Body::Project,
        parameters: &[AXIS, FILE, Parameter::of("code", help::check_code, Text), SAMPLES, SEED],
        output: Output::Record("check"),
        #[cfg(feature = "interface")]
        answer: axis::check,
    },
    Endpoint {
        method: Post,
        path: "explain",
        about: help::explain,
        body: Body::Project,
        parameters: &[
            AXIS,
            FILE,
            Parameter::of("code", help::explain_code, Text),
            Parameter::of("check", help::explain_check, Word(checks)),
        ],
        output: Output::Record("explain"),
        #[cfg(feature = "interface")]
        answer: axis::explain,
    },
    Endpoint {
        method: Post,
        path: "compare",
        about: help::compare,
        body: Body::Project,
        parameters: &[AXIS, FILE, Parameter::of("code", help::compare_code, Text).required().repeated()],
        output: Output::Record("compare"),
        #[cfg(feature = "interface")]
        answer: axis::compare,
    },
    Endpoint {
        method: Post,
        path: "diff",
        about: help::diff,
        body: Body::TwoProjects,
        parameters: &[AXIS, Parameter::of("code", help::diff_code, Text)],
        output: Output::Record("diff"),
        #[cfg(feature = "interface")]
        answer: axis::diff,
    },
    Endpoint {
        method: Post,
        path: "bearing",
        about: help::bearing,
        body: Body::Project,
        parameters: &[AXIS, FILE],
        output: Output::Record("bearing"),
        #[cfg(feature = "interface")]
        answer: axis::bearing,
    },
    Endpoint {
        method: Post,
        path: "moves",
        about: requests::moves,
        body: Body::Project,
        parameters: &[AXIS, FILE],
        output: Output::Shared("Motion"),
        #[cfg(feature = "interface")]
        answer: axis::moves,
    },
    Endpoint {
        method: Post,
        path: "plot",
        about: help::plot,
        body: Body::Project,
        parameters: &[
            AXIS,
            FILE,
            OWN_OR_BEST,
            Parameter::of("figure", requests::figure, Word(figures)).required(),
            Parameter::of("by", help::plot_by, Word(|| vec!["mass", "length"])),
            THEME,
            WIDTH,
            HEIGHT,
        ],
        output: Output::Media(&[SVG]),
        #[cfg(feature = "interface")]
        answer: axis::plot,
    },
    Endpoint {
        method: Post,
        path: "report",
        about: help::report,
        body: Body::Project,
        parameters: &[
            AXIS,
            FILE,
            OWN_OR_BEST,
            Parameter::of("full", help::report_full, Flag),
            Parameter::of("installation", help::report_installation, Flag),
            Parameter::of("date", help::date, Text),
        ],
        output: Output::Media(&[PDF]),
        #[cfg(feature = "interface")]
        answer: axis::report,
    },
    Endpoint {
        method: Post,
        path: "export",
        about: help::export,
        body: Body::Project,
        parameters: &[
            AXIS,
            FILE,
            Parameter::of("code", help::export_code, Text),
            #[cfg(feature = "interface")]
            Parameter::of("table", help::export_table, Word(|| ::tables::NAMES.to_vec())),
            #[cfg(feature = "interface")]
            Parameter::of(
                "format",
                requests::format,
                Word(|| ::tables::Format::ALL.map(::tables::Format::ending).to_vec()),
            ),
            top(help::export_top),
            Parameter::of("revision", help::export_revision, Text),
            Parameter::of("date", help::export_date, Text),
        ],
        output: Output::RecordOr("export --table", &[XLSX, CSV, PARQUET]),
        #[cfg(feature = "interface")]
        answer: tables::export,
    },
    Endpoint {
        method: Get,
        path: "code/parse",
        about: help::code_parse,
        body: Body::None,
        parameters: &[CODE],
        output: Output::Record("code parse"),
        #[cfg(feature = "interface")]
        answer: code::parse,
    },
    Endpoint {
        method: Get,
        path: "code/list",
        about: help::code_list,
        body: Body::None,
        parameters: &[
            Parameter::of("pattern", help::code_list_pattern, Text),
            Parameter::of("available", help::code_list_available, Flag),
        ],
        output: Output::Record("code list"),
        #[cfg(feature = "interface")]
        answer: code::list,
    },
    Endpoint {
        method: Get,
        path: "code/complete",
        about: help::code_complete,
        body: Body::None,
        parameters: &[Parameter::of("code", help::code_complete_pattern, Text).required()],
        output: Output::Record("code complete"),
        #[cfg(feature = "interface")]
        answer: code::complete,
    },
    Endpoint {
        method: Get,
        path: "data",
        about: help::data,
        body: Body::None,
        parameters: &[CODE],
        output: Output::Record("data"),
        #[cfg(feature = "interface")]
        answer: code::data,
    },
    Endpoint {
        method: Get,
        path: "torsion",
        about: help::torsion,
        body: Body::None,
        parameters: &[
            CODE,
            Parameter::of("torque", help::torsion_torque, Text),
            Parameter::of("angle", help::torsion_angle, Text),
        ],
        output: Output::Record("torsion"),
        #[cfg(feature = "interface")]
        answer: code::torsion,
    },
    Endpoint {
        method: Get,
        path: "curve",
        about: help::curve,
        body: Body::None,
        parameters: &[CODE, Parameter::of("voltage", help::curve_voltage, Text)],
        output: Output::Record("curve"),
        #[cfg(feature = "interface")]
        answer: code::curve,
    },
    Endpoint {
        method: Get,
        path: "wiring",
        about: help::wiring,
        body: Body::None,
        parameters: &[
            CODE,
            Parameter::of("length", help::wiring_length, Text),
            Parameter::of("cross-section", help::wiring_section, Text),
        ],
        output: Output::Record("wiring"),
        #[cfg(feature = "interface")]
        answer: code::wiring,
    },
    Endpoint {
        method: Post,
        path: "wiring",
        about: requests::pins_compared,
        body: Body::Pins,
        parameters: &[CODE, FILE],
        output: Output::Record("wiring --check"),
        #[cfg(feature = "interface")]
        answer: code::pins,
    },
    Endpoint {
        method: Get,
        path: "mount",
        about: help::mount,
        body: Body::None,
        parameters: &[CODE, BORE, BORE_LOAD, BORE_HOUSING],
        output: Output::Record("mount"),
        #[cfg(feature = "interface")]
        answer: code::mount,
    },
    Endpoint {
        method: Post,
        path: "mount",
        about: requests::mounted_in_project,
        body: Body::Project,
        parameters: &[CODE, BORE, BORE_LOAD, BORE_HOUSING, AXIS, FILE],
        output: Output::Record("mount"),
        #[cfg(feature = "interface")]
        answer: axis::mount,
    },
    Endpoint {
        method: Get,
        path: "upkeep",
        about: help::upkeep,
        body: Body::None,
        parameters: &[CODE, DELIVERED, STORAGE, HOURS, INSPECT, TODAY],
        output: Output::Record("upkeep"),
        #[cfg(feature = "interface")]
        answer: code::upkeep,
    },
    Endpoint {
        method: Get,
        path: "upkeep/calendar",
        about: requests::upkeep_calendar,
        body: Body::None,
        parameters: &[CODE, DELIVERED, STORAGE, HOURS, INSPECT, TODAY, Parameter::of("name", help::upkeep_name, Text)],
        output: Output::Media(&[CALENDAR]),
        #[cfg(feature = "interface")]
        answer: code::calendar,
    },
    Endpoint {
        method: Get,
        path: "commission",
        about: help::commission,
        body: Body::None,
        parameters: &[CODE, Parameter::of("for", help::commission_for, Word(forms)), AMBIENT],
        output: Output::Record("commission"),
        #[cfg(feature = "interface")]
        answer: code::commission,
    },
    Endpoint {
        method: Get,
        path: "commission/drive",
        about: requests::commission_drive,
        body: Body::None,
        parameters: &[
            CODE,
            Parameter::of(
                "for",
                help::commission_for,
                Word(|| [DriveForm::Sinamics, DriveForm::Cia402].map(DriveForm::id).to_vec()),
            )
            .required(),
        ],
        output: Output::Media(&[PLAIN]),
        #[cfg(feature = "interface")]
        answer: code::commission_file,
    },
    Endpoint {
        method: Get,
        path: "commission/checklist",
        about: requests::commission_checklist,
        body: Body::None,
        parameters: &[CODE, AMBIENT],
        output: Output::Media(&[PDF]),
        #[cfg(feature = "interface")]
        answer: code::checklist,
    },
    Endpoint {
        method: Get,
        path: "commission/blank",
        about: help::commission_blank,
        body: Body::None,
        parameters: &[CODE],
        output: Output::Media(&[TOML]),
        #[cfg(feature = "interface")]
        answer: code::blank,
    },
    Endpoint {
        method: Post,
        path: "commission",
        about: requests::measured_judged,
        body: Body::Measured,
        parameters: &[CODE, FILE],
        output: Output::Record("commission --record"),
        #[cfg(feature = "interface")]
        answer: code::judged,
    },
    Endpoint {
        method: Get,
        path: "battery",
        about: help::battery,
        body: Body::None,
        parameters: &[
            Parameter::of("hours-per-day", help::battery_hours, Text).required(),
            Parameter::of("storage", help::battery_storage, Text),
        ],
        output: Output::Record("battery"),
        #[cfg(feature = "interface")]
        answer: library::battery,
    },
    Endpoint {
        method: Get,
        path: "inertia",
        about: help::inertia,
        body: Body::None,
        parameters: &[Parameter::of("body", requests::body, Text).required().repeated()],
        output: Output::Record("inertia"),
        #[cfg(feature = "interface")]
        answer: library::inertia,
    },
    Endpoint {
        method: Get,
        path: "errata",
        about: help::errata,
        body: Body::None,
        parameters: &[Parameter::of("about", help::errata_about, Text)],
        output: Output::Record("errata"),
        #[cfg(feature = "interface")]
        answer: library::errata,
    },
    Endpoint {
        method: Get,
        path: "glossary",
        about: help::glossary,
        body: Body::None,
        parameters: &[Parameter::of("term", help::glossary_term, Text)],
        output: Output::Record("glossary"),
        #[cfg(feature = "interface")]
        answer: library::glossary,
    },
    Endpoint {
        method: Get,
        path: "catalogue",
        about: help::catalogue_export,
        body: Body::None,
        parameters: &[Parameter::of("format", help::catalogue_format, Word(|| vec!["json", "csv"]))],
        output: Output::RecordOr("catalogue export", &[CSV]),
        #[cfg(feature = "interface")]
        answer: library::catalogue,
    },
    Endpoint {
        method: Get,
        path: "new",
        about: help::new,
        body: Body::None,
        parameters: &[Parameter::of("kind", requests::kind, Word(|| workbench::template_kinds().collect())).required()],
        output: Output::Media(&[TOML]),
        #[cfg(feature = "interface")]
        answer: library::template,
    },
    Endpoint {
        method: Get,
        path: "schema",
        about: help::schema,
        body: Body::None,
        parameters: &[Parameter::of("answers", help::schema_answers, Flag)],
        output: Output::Json,
        #[cfg(feature = "interface")]
        answer: library::schema,
    },
    Endpoint {
        method: Get,
        path: "licences",
        about: help::licences,
        body: Body::None,
        parameters: &[],
        output: Output::Record("licences"),
        #[cfg(feature = "interface")]
        answer: library::licences,
    },
    Endpoint {
        method: Get,
        path: "openapi.json",
        about: requests::endpoints,
        body: Body::None,
        parameters: &[],
        output: Output::Json,
        #[cfg(feature = "interface")]
        answer: library::openapi,
    },
];

const BORE: Parameter = Parameter::of("bore", help::mount_bore, Text);
const BORE_LOAD: Parameter = Parameter::of("bore-load", help::mount_bore_load, Text);
const BORE_HOUSING: Parameter = Parameter::of("bore-housing", help::mount_bore_housing, Text);
const AMBIENT: Parameter = Parameter::of("ambient", help::commission_ambient, Text);
const DELIVERED: Parameter = Parameter::of("delivered", help::upkeep_delivered, Date).required();
const STORAGE: Parameter = Parameter::of("storage", help::upkeep_storage, Text);
const HOURS: Parameter = Parameter::of("hours-per-day", help::upkeep_hours, Text);
const INSPECT: Parameter = Parameter::of("inspect", help::upkeep_inspect, Text);
const TODAY: Parameter = Parameter::of("today", help::upkeep_today, Date);
