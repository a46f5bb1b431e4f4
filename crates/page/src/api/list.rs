//! What can be asked.

use super::Kind::{Flag, Text, Whole, Word};
use super::{Body, Endpoint, Output, Parameter, axis, code, library, tables};
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
        answer: axis::size,
    },
    Endpoint {
        method: Post,
        path: "check",
        about: help::check,
        body: Body::Project,
        parameters: &[AXIS, FILE, Parameter::of("code", help::check_code, Text), SAMPLES, SEED],
        output: Output::Record("check"),
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
        answer: axis::explain,
    },
    Endpoint {
        method: Post,
        path: "compare",
        about: help::compare,
        body: Body::Project,
        parameters: &[AXIS, FILE, Parameter::of("code", help::compare_code, Text).required().repeated()],
        output: Output::Record("compare"),
        answer: axis::compare,
    },
    Endpoint {
        method: Post,
        path: "diff",
        about: help::diff,
        body: Body::TwoProjects,
        parameters: &[AXIS, Parameter::of("code", help::diff_code, Text)],
        output: Output::Record("diff"),
        answer: axis::diff,
    },
    Endpoint {
        method: Post,
        path: "bearing",
        about: help::bearing,
        body: Body::Project,
        parameters: &[AXIS, FILE],
        output: Output::Record("bearing"),
        answer: axis::bearing,
    },
    Endpoint {
        method: Post,
        path: "moves",
        about: requests::moves,
        body: Body::Project,
        parameters: &[AXIS, FILE],
        output: Output::Shared("Motion"),
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
            Parameter::of("table", help::export_table, Word(|| ::tables::NAMES.to_vec())),
            Parameter::of("format", requests::format, Word(|| vec!["json", "csv", "parquet", "xlsx"])),
            top(help::export_top),
            Parameter::of("revision", help::export_revision, Text),
            Parameter::of("date", help::export_date, Text),
        ],
        output: Output::RecordOr("export --table", &[XLSX, CSV, PARQUET]),
        answer: tables::export,
    },
    Endpoint {
        method: Get,
        path: "code/parse",
        about: help::code_parse,
        body: Body::None,
        parameters: &[CODE],
        output: Output::Record("code parse"),
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
        answer: code::list,
    },
    Endpoint {
        method: Get,
        path: "code/complete",
        about: help::code_complete,
        body: Body::None,
        parameters: &[Parameter::of("code", help::code_complete_pattern, Text).required()],
        output: Output::Record("code complete"),
        answer: code::complete,
    },
    Endpoint {
        method: Get,
        path: "data",
        about: help::data,
        body: Body::None,
        parameters: &[CODE],
        output: Output::Record("data"),
        answer: code::data,
    },
    Endpoint {
        method: Get,
        path: "torsion",
        about: help::torsion,
        body: Body::None,
        parameters: &[CODE, Parameter::of("torque", help::torsion_torque, Text).required()],
        output: Output::Record("torsion"),
        answer: code::torsion,
    },
    Endpoint {
        method: Get,
        path: "curve",
        about: help::curve,
        body: Body::None,
        parameters: &[CODE, Parameter::of("voltage", help::curve_voltage, Text)],
        output: Output::Record("curve"),
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
        answer: code::wiring,
    },
    Endpoint {
        method: Post,
        path: "wiring",
        about: requests::pins_compared,
        body: Body::Pins,
        parameters: &[CODE, FILE],
        output: Output::Record("wiring --check"),
        answer: code::pins,
    },
    Endpoint {
        method: Get,
        path: "mount",
        about: help::mount,
        body: Body::None,
        parameters: &[CODE, BORE, BORE_LOAD, BORE_HOUSING],
        output: Output::Record("mount"),
        answer: code::mount,
    },
    Endpoint {
        method: Post,
        path: "mount",
        about: requests::mounted_in_project,
        body: Body::Project,
        parameters: &[CODE, BORE, BORE_LOAD, BORE_HOUSING, AXIS, FILE],
        output: Output::Record("mount"),
        answer: axis::mount,
    },
    Endpoint {
        method: Get,
        path: "upkeep",
        about: help::upkeep,
        body: Body::None,
        parameters: &[
            CODE,
            Parameter::of("delivered", help::upkeep_delivered, Text).required(),
            Parameter::of("storage", help::upkeep_storage, Text),
            Parameter::of("hours-per-day", help::upkeep_hours, Text),
            Parameter::of("inspect", help::upkeep_inspect, Text),
            Parameter::of("today", help::upkeep_today, Text),
        ],
        output: Output::Record("upkeep"),
        answer: code::upkeep,
    },
    Endpoint {
        method: Get,
        path: "commission",
        about: help::commission,
        body: Body::None,
        parameters: &[
            CODE,
            Parameter::of("for", help::commission_for, Word(forms)),
            Parameter::of("ambient", help::commission_ambient, Text),
        ],
        output: Output::Record("commission"),
        answer: code::commission,
    },
    Endpoint {
        method: Post,
        path: "commission",
        about: requests::measured_judged,
        body: Body::Measured,
        parameters: &[CODE, FILE],
        output: Output::Record("commission --record"),
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
        answer: library::battery,
    },
    Endpoint {
        method: Get,
        path: "inertia",
        about: help::inertia,
        body: Body::None,
        parameters: &[Parameter::of("body", help::inertia_body, Text).required().repeated()],
        output: Output::Record("inertia"),
        answer: library::inertia,
    },
    Endpoint {
        method: Get,
        path: "errata",
        about: help::errata,
        body: Body::None,
        parameters: &[Parameter::of("about", help::errata_about, Text)],
        output: Output::Record("errata"),
        answer: library::errata,
    },
    Endpoint {
        method: Get,
        path: "glossary",
        about: help::glossary,
        body: Body::None,
        parameters: &[Parameter::of("term", help::glossary_term, Text)],
        output: Output::Record("glossary"),
        answer: library::glossary,
    },
    Endpoint {
        method: Get,
        path: "catalogue",
        about: help::catalogue_export,
        body: Body::None,
        parameters: &[Parameter::of("format", help::catalogue_format, Word(|| vec!["json", "csv"]))],
        output: Output::RecordOr("catalogue export", &[CSV]),
        answer: library::catalogue,
    },
    Endpoint {
        method: Get,
        path: "new",
        about: help::new,
        body: Body::None,
        parameters: &[Parameter::of("kind", requests::kind, Word(|| workbench::template_kinds().collect())).required()],
        output: Output::Media(&[TOML]),
        answer: library::template,
    },
    Endpoint {
        method: Get,
        path: "schema",
        about: help::schema,
        body: Body::None,
        parameters: &[Parameter::of("answers", help::schema_answers, Flag)],
        output: Output::Json,
        answer: library::schema,
    },
    Endpoint {
        method: Get,
        path: "licences",
        about: help::licences,
        body: Body::None,
        parameters: &[],
        output: Output::Record("licences"),
        answer: library::licences,
    },
    Endpoint {
        method: Get,
        path: "openapi.json",
        about: requests::endpoints,
        body: Body::None,
        parameters: &[],
        output: Output::Json,
        answer: library::openapi,
    },
];

const BORE: Parameter = Parameter::of("bore", help::mount_bore, Text);
const BORE_LOAD: Parameter = Parameter::of("bore-load", help::mount_bore_load, Text);
const BORE_HOUSING: Parameter = Parameter::of("bore-housing", help::mount_bore_housing, Text);
