//! The questions as functions.

use super::Schema;
use super::names::{doc, function, literal, name, quoted, sentence};
use super::types::of_shape;
use quantities::Language;
use questions::list::{Argument, ArgumentKind, Entry, Gives, LIST, Reads, media};
use serde_json::Value;
use std::fmt::Write as _;

const HEAD: &str = r#""""The questions of antrieb as functions: each answers as the command of its name does.

This file is written from the list of questions by `cargo xtask snapshots`; do not edit it. A quantity is a text with its unit,
`"40 1/min"`. A question about a project takes its text, or the path of its file; a text of one line is a path. Recordings that
it names are opened beside the file, those of a text in `folder`. `file` names a text in faults. A call that would take long is
refused at once unless `deadline` states how long it may take (`"60 s"`); recordings take `memory` at most (`"1 GiB"`). Every
fault of a call is in one `AntriebError`.
"""

from __future__ import annotations

from collections.abc import Sequence
from datetime import date as Day
from typing import TYPE_CHECKING, Literal, overload

from antrieb._axis import BaseAxis, BaseProject
from antrieb._call import Lang, Path, Picture, Text, TimeLimit, ask, flag
from antrieb._called import called
from antrieb._lazy import lazy
from antrieb._trace import Trace, held

if TYPE_CHECKING:
    from antrieb import answers
else:
    answers = lazy("antrieb.answers")

"#;

/// Questions that the package has in another form under the same name: its sweep takes tables, not files.
const REPLACED: [&str; 1] = ["sweep"];

/// A parameter of a function.
#[derive(Clone)]
struct Parameter {
    name: String,
    of: String,
    usual: Option<String>,
    about: String,
}

/// Parameters of a function.
#[derive(Clone)]
struct Takes {
    /// Parameters by position or by name.
    first: Vec<Parameter>,
    /// Parameters by name only.
    named: Vec<Parameter>,
}

/// A form of a function: its differing parameters, and its return type.
struct Form {
    /// Parameters with their type; `true` if required.
    by: Vec<(&'static str, String, bool)>,
    returns: String,
}

/// Returns the module.
pub(super) fn module(schema: &Schema) -> String {
    let mut out = HEAD.to_owned();
    let mut all: Vec<String> = Vec::new();
    for entry in LIST {
        out.push_str(&whole(entry, schema));
        all.push(function(entry.command));
    }
    out.push_str("\n\n");
    // A word that only stands before others is its first question.
    for entry in LIST {
        let group = entry.command.split(' ').next().unwrap_or_default();
        if !all.contains(&function(group)) {
            let _ = writeln!(out, "{} = {}", function(group), function(entry.command));
            all.push(function(group));
        }
    }
    out.push_str("\n# A call of each command that runs; the tests put it to the function too.\n_EXAMPLES = {\n");
    for entry in LIST.iter().filter(|entry| entry.option().is_none()) {
        let call = format!("{} {}", entry.command, entry.example);
        let _ = writeln!(out, "    {}: {},", quoted(&function(entry.command)), quoted(call.trim()));
    }
    out.push_str("}\n\n__all__ = [\n");
    all.retain(|known| !REPLACED.contains(&known.as_str()));
    all.sort();
    for known in &all {
        let _ = writeln!(out, "    \"{known}\",");
    }
    out.push_str("]\n");
    out
}

fn whole(entry: &Entry, schema: &Schema) -> String {
    let takes = takes(entry);
    let forms = forms(entry, schema);
    let mut out = String::new();
    if forms.len() > 1 {
        for form in &forms {
            let _ = write!(out, "\n\n@overload\n{} ...\n", head(entry, &takes, form).trim_end());
        }
    }
    let every = Form { by: Vec::new(), returns: union(forms.iter().map(|form| form.returns.as_str())) };
    out.push_str("\n\n@called\n");
    out.push_str(&head(entry, &takes, &every));
    let _ = writeln!(out, "    \"\"\"{}\"\"\"", about(entry, &takes));
    let sources: Vec<String> = sources(entry).iter().map(|each| each.name.clone()).collect();
    let texts = if sources.is_empty() { "()".to_owned() } else { format!("({},)", sources.join(", ")) };
    let pair = |each: &Argument| {
        let (option, name) = (quoted(each.name), name(each.name));
        if matches!(each.kind, ArgumentKind::Flag) {
            format!("({option}, flag({}, {name}))", quoted(&name))
        } else if is_recorded(each) {
            format!("({option}, held({}, {name}))", quoted(&name))
        } else {
            format!("({option}, {name})")
        }
    };
    let pairs: Vec<String> = entry.arguments.iter().map(pair).collect();
    let of = record_type(entry, schema).unwrap_or_else(|| "object".to_owned());
    let mut given = vec![
        format!("lambda: {of}"),
        quoted(entry.command),
        texts,
        format!("[{}]", pairs.join(", ")),
        "lang".to_owned(),
    ];
    let own: &[&str] = match sources.len() {
        0 => &[],
        1 => &["file", "folder", "deadline", "memory"],
        _ => &["folder", "deadline", "memory"],
    };
    given.extend(own.iter().map(|name| format!("{name}={name}")));
    let _ = writeln!(out, "    answer: {} = ask(", every.returns);
    out.extend(given.iter().map(|each| format!("        {each},\n")));
    out.push_str("    )\n    return answer\n");
    out
}

/// Returns the first line of a form.
fn head(entry: &Entry, takes: &Takes, form: &Form) -> String {
    let mut takes = takes.clone();
    for (by, of, is_required) in &form.by {
        for parameter in takes.first.iter_mut().chain(&mut takes.named).filter(|each| each.name == *by) {
            parameter.of.clone_from(of);
            parameter.usual = parameter.usual.take().filter(|_| !is_required);
        }
    }
    let written = |each: &Parameter| match &each.usual {
        Some(usual) => format!("    {}: {} = {usual},\n", each.name, each.of),
        None => format!("    {}: {},\n", each.name, each.of),
    };
    let mut out = format!("def {}(\n", function(entry.command));
    out.extend(takes.first.iter().map(written));
    if !takes.named.is_empty() {
        out.push_str("    *,\n");
        out.extend(takes.named.iter().map(written));
    }
    let _ = writeln!(out, ") -> {}:", form.returns);
    out
}

fn about(entry: &Entry, takes: &Takes) -> String {
    let mut out = doc(&sentence((entry.about)(Language::En)));
    out.push_str("\n\n    Args:\n");
    for each in takes.first.iter().chain(&takes.named) {
        let _ = writeln!(out, "        {}: {}", each.name, doc(&each.about));
    }
    let _ = write!(
        out,
        "\n    Returns:\n        {}\n\n    Raises:\n        AntriebError: Every fault of the call.\n    ",
        returned(entry)
    );
    out
}

fn returned(entry: &Entry) -> &'static str {
    match entry.gives {
        Gives::Record(_) => "The record, as `--json` has it, as typed objects; units as `antrieb.answers` states.",
        Gives::RecordOr(..) => "The record as typed objects with `format=\"json\"`, else the file.",
        Gives::Json => "JSON as Python has it.",
        Gives::Media([media::SVG]) => "The picture.",
        Gives::Media(types) if types.iter().all(|media| is_text(media)) => "The text of the file.",
        Gives::Media(_) => "The bytes of the file.",
    }
}

/// Returns the type of the record.
fn record_type(entry: &Entry, schema: &Schema) -> Option<String> {
    match entry.gives {
        Gives::Record(record) | Gives::RecordOr(record, _) => Some(
            schema
                .properties
                .get(record.command)
                .map_or_else(|| "object".to_owned(), |shape| of_shape(shape, schema, true)),
        ),
        Gives::Json => Some("dict[str, object]".to_owned()),
        Gives::Media(_) => None,
    }
}

/// Returns the forms of a function: for a named axis there is one answer, and the format decides the return type.
fn forms(entry: &Entry, schema: &Schema) -> Vec<Form> {
    let record = record_type(entry, schema).unwrap_or_default();
    match entry.gives {
        Gives::Media(types) => vec![Form { by: Vec::new(), returns: of_media(types) }],
        Gives::Json => vec![Form { by: Vec::new(), returns: record }],
        Gives::Record(_) => forms_of_axes(entry, record),
        Gives::RecordOr(_, types) => {
            let formats =
                entry.arguments.iter().find(|each| each.name == "format").map(Argument::words).unwrap_or_default();
            let files = formats.into_iter().filter(|word| *word != "json");
            let (texts, others): (Vec<&str>, Vec<&str>) = files.partition(|word| is_text(of_ending(word, types)));
            let (pictures, others): (Vec<&str>, Vec<&str>) =
                others.into_iter().partition(|word| of_ending(word, types) == media::SVG);
            let mut forms = forms_of_axes(entry, record);
            for form in &mut forms {
                form.by.push(("format", literal(["json"]), false));
            }
            for (words, returns) in [(texts, "str"), (pictures, "Picture"), (others, "bytes")] {
                if !words.is_empty() {
                    forms.push(Form { by: vec![("format", literal(words), true)], returns: returns.to_owned() });
                }
            }
            forms
        }
    }
}

/// Returns the forms of a record: of an axis as an object, and for a named axis, there is one; of a project of objects there
/// is one for each axis.
fn forms_of_axes(entry: &Entry, record: String) -> Vec<Form> {
    match (one_of_several(&record), entry.arguments.iter().any(|each| each.name == "axis")) {
        (Some(one), true) => {
            let mut forms = vec![
                Form { by: vec![("axis", "str".to_owned(), true)], returns: one.clone() },
                Form { by: vec![("axis", "None".to_owned(), false)], returns: record.clone() },
            ];
            if entry.reads == Reads::Project {
                let of_projects = ("text", "BaseProject | Sequence[BaseAxis]".to_owned(), true);
                let several = record.trim_start_matches(&format!("{one} | ")).to_owned();
                forms.insert(0, Form { by: vec![("text", "BaseAxis".to_owned(), true)], returns: one });
                forms.insert(1, Form { by: vec![of_projects, ("axis", "None".to_owned(), false)], returns: several });
            }
            forms
        }
        _ => vec![Form { by: Vec::new(), returns: record }],
    }
}

/// Returns the media type of a format by its extension.
fn of_ending(ending: &str, types: &[&'static str]) -> &'static str {
    let wanted = match ending {
        "csv" => media::CSV,
        "xlsx" => media::XLSX,
        "parquet" => media::PARQUET,
        "svg" => media::SVG,
        _ => media::JSON,
    };
    types.iter().copied().find(|media| *media == wanted).unwrap_or(media::PDF)
}

fn is_text(media: &str) -> bool {
    [media::CSV, media::TOML, media::PLAIN, media::CALENDAR, media::JSON].contains(&media)
}

fn of_media(types: &[&str]) -> String {
    let of = if types == [media::SVG] {
        "Picture"
    } else if types.iter().all(|media| is_text(media)) {
        "str"
    } else {
        "bytes"
    };
    of.to_owned()
}

/// Returns the answer of one axis, of one or several.
fn one_of_several(record: &str) -> Option<String> {
    let (one, several) = record.split_once(" | ")?;
    let own = one.strip_prefix("answers.")?;
    (several == format!("answers.AxesOf{own}")).then(|| one.to_owned())
}

fn union<'t>(types: impl Iterator<Item = &'t str>) -> String {
    let mut all: Vec<&str> = Vec::new();
    for part in types.flat_map(|each| each.split(" | ")) {
        if !all.contains(&part) {
            all.push(part);
        }
    }
    all.join(" | ")
}

/// Returns the parameters for the subject of a function.
fn sources(entry: &Entry) -> Vec<Parameter> {
    let text = |name: &str, about: &str| Parameter {
        name: name.to_owned(),
        of: "Text".to_owned(),
        usual: None,
        about: about.to_owned(),
    };
    match entry.reads {
        Reads::Nothing => Vec::new(),
        Reads::Measured if entry.command == "catalogue check" => {
            vec![text("text", "The catalogue file as text, or the path of its file.")]
        }
        Reads::Project => vec![text("text", "The project as text, or the path of its file.")],
        Reads::Pins => vec![text("text", "The list of pins in CSV as text, or the path of its file.")],
        Reads::Measured => vec![text("text", "The measured values as text, or the path of their file.")],
        Reads::TwoProjects => vec![
            text("old", "The project before as text, or the path of its file."),
            text("new", "The project after as text, or the path of its file."),
        ],
    }
}

/// Returns the parameters in the order of the command line: by position a file without a name, the texts, required
/// arguments and the code; the others by name, so that no value is taken for another argument.
fn takes(entry: &Entry) -> Takes {
    let mut named = Vec::new();
    let is_first =
        |each: &&Argument| each.required || each.name == "code" || each.form != questions::list::ArgumentForm::Option;
    let (at_place, by_name): (Vec<&Argument>, Vec<&Argument>) = entry.arguments.iter().partition(is_first);
    let (must, may): (Vec<&Argument>, Vec<&Argument>) = at_place.into_iter().partition(|each| each.required);
    let (before, must): (Vec<&Argument>, Vec<&Argument>) = must.into_iter().partition(|each| is_recorded(each));
    let mut first: Vec<Parameter> = before.into_iter().map(|each| of_argument(each, entry.gives)).collect();
    first.extend(sources(entry));
    first.extend(must.into_iter().chain(may).map(|each| of_argument(each, entry.gives)));
    named.push(Parameter {
        name: "lang".to_owned(),
        of: "Lang".to_owned(),
        usual: Some(quoted("en")),
        about: "Language of the texts: `en` or `de`.".to_owned(),
    });
    named.extend(by_name.into_iter().map(|each| of_argument(each, entry.gives)));
    let own = |name: &str, of: &str, about: &str| Parameter {
        name: name.to_owned(),
        of: format!("{of} | None"),
        usual: Some("None".to_owned()),
        about: about.to_owned(),
    };
    match entry.reads {
        Reads::Nothing => {}
        Reads::Project | Reads::Pins | Reads::Measured | Reads::TwoProjects => {
            if entry.reads != Reads::TwoProjects {
                named.push(own("file", "str", "What a text is called in faults."));
            }
            named.push(own(
                "folder",
                "Path",
                "Where the recordings that a text names lie; without it the current folder.",
            ));
            named.push(own(
                "deadline",
                "TimeLimit",
                "How long the answer may take, such as `60 s`; without it what would take long is refused.",
            ));
            named.push(own("memory", "str", "How much memory the recordings may take, such as `1 GiB`."));
        }
    }
    Takes { first, named }
}

/// Returns `true` for a recorded run: a file by position, for which Python takes its content too.
fn is_recorded(argument: &Argument) -> bool {
    let is_bare = argument.form == questions::list::ArgumentForm::Bare;
    is_bare && argument.required && matches!(argument.kind, ArgumentKind::File)
}

fn of_argument(argument: &Argument, gives: Gives) -> Parameter {
    let words = argument.words();
    let of = match argument.kind {
        ArgumentKind::Text if argument.name == "hours-per-day" => "str | float".to_owned(),
        ArgumentKind::Text | ArgumentKind::Code => "str".to_owned(),
        ArgumentKind::Date => "str | Day".to_owned(),
        ArgumentKind::File if is_recorded(argument) => "Trace".to_owned(),
        ArgumentKind::File => "Path".to_owned(),
        ArgumentKind::Flag => "bool".to_owned(),
        ArgumentKind::Whole(..) => "int".to_owned(),
        ArgumentKind::Word(_) => literal(words),
    };
    let of = if argument.repeated { format!("{of} | Sequence[{of}]") } else { of };
    let is_json = matches!(gives, Gives::RecordOr(..)) && argument.name == "format";
    let usual = match (argument.required, argument.kind, argument.usual) {
        _ if is_json => Some(quoted("json")),
        (true, ..) => None,
        (false, ArgumentKind::Flag, _) => Some("False".to_owned()),
        (false, ArgumentKind::Whole(..), Some(usual)) => Some(usual.to_owned()),
        (false, ArgumentKind::Word(_), Some(usual)) => Some(quoted(usual)),
        (false, ..) => Some("None".to_owned()),
    };
    let of = if usual.as_deref() == Some("None") { format!("{of} | None") } else { of };
    let mut about = sentence((argument.about)(Language::En));
    if let (ArgumentKind::Whole(least, most), true) = (argument.kind, argument.name != "seed") {
        let _ = write!(about, " {least} to {most}.");
    }
    if let (ArgumentKind::Text, Some(usual)) = (argument.kind, argument.usual) {
        let _ = write!(about, " Without it `{usual}`.");
    }
    Parameter { name: name(argument.name), of, usual, about }
}

#[test]
fn every_question_has_a_function_of_its_own() {
    let names: Vec<String> = LIST.iter().map(|entry| function(entry.command)).collect();
    for (index, each) in names.iter().enumerate() {
        assert!(!names.iter().take(index).any(|other| other == each), "{each}");
    }
    let text = module(&Schema::of_the_answers());
    for each in names {
        assert!(text.contains(&format!("\ndef {each}(")), "{each}");
    }
}

#[test]
fn a_form_returns_what_the_format_says() {
    let schema = Schema { properties: serde_json::Map::new(), definitions: serde_json::Map::new() };
    let export =
        LIST.iter().find(|entry| entry.command == "export").map(|entry| forms(entry, &schema)).unwrap_or_default();
    let found: Vec<&str> = export.iter().map(|form| form.returns.as_str()).collect();
    assert_eq!(found, ["object", "str", "bytes"]);
    assert_eq!(of_shape(&Value::Null, &schema, true), "object");
}
