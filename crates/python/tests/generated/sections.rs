//! The sections of a project file as classes.

use super::names::{class, doc, literal, name, quoted, sentence};
use project::{Key, Kind, Range};
use quantities::{Dimension, Language};
use std::fmt::Write as _;

const HEAD: &str = r#""""A project as typed objects: every key of the project file is a keyword of a class.

This file is written from the description of the keys by `cargo xtask snapshots`; do not edit it. A quantity is a text with its
unit, `"30 kg"`, `antrieb.q(30, "kg")` or a quantity of pint; a bare number is refused. What is not given is not in the file.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from antrieb._axis import BaseAxis, BaseProject
from antrieb._quantity import Quantity
from antrieb._section import Kind, Load as LoadOrMechanism, Mechanism, ReturnMove, Section, Segment

"#;

/// Class of the table `[catalogue]`; `catalogue` is a function of the package.
const FILES: &str = "CatalogueFiles";

/// A class: its name, the class below it, its table, and its keys in the order of their places.
struct Class {
    name: String,
    base: &'static str,
    about: String,
    /// Path of its table in the file.
    table: String,
    keys: Vec<Member>,
}

/// A keyword of a class.
#[derive(Clone)]
struct Member {
    key: Key,
    /// Key of which it is another name.
    other_name_of: Option<&'static str>,
    is_required: bool,
    /// May be given without its name.
    has_place: bool,
    /// Words that this class permits, of those of the key.
    words: Option<Vec<&'static str>>,
    /// Class of its table.
    table: Option<String>,
    is_in_requirements: bool,
}

impl Member {
    fn of(key: &Key) -> Self {
        Self {
            key: *key,
            other_name_of: None,
            is_required: key.required,
            has_place: false,
            words: None,
            table: None,
            is_in_requirements: false,
        }
    }

    fn at_its_place(self) -> Self {
        Self { has_place: true, ..self }
    }

    fn open(self) -> Self {
        Self { is_required: false, ..self }
    }
}

/// Returns the module.
pub(super) fn module() -> String {
    let mut classes = Vec::new();
    let root = |name: &str| find(project::KEYS, name);
    let load = root("load");
    classes.push(plain("Load", "LoadOrMechanism", &load, "load"));
    for each in root("mechanism").kind.keys(false) {
        let body = each.kind.keys(false).iter().find(|key| matches!(key.kind, Kind::Variants(_)));
        if let Some(Kind::Variants(variants)) = body.map(|key| key.kind) {
            let members = variants.keys.iter().map(|key| by_place(key, variants.by)).collect();
            let table = format!("mechanism.{}.body", each.name);
            classes.push(Class {
                name: "Body".to_owned(),
                base: "Section",
                about: about(body.unwrap_or(each)),
                table,
                keys: members,
            });
        }
        let mut found = plain(&mechanism(each.name), "Mechanism", each, &format!("mechanism.{}", each.name));
        if let Some(at) = found.keys.iter().position(|member| member.key.name == "start_angle")
            && let Some(start) = found.keys.get(at).cloned()
        {
            let mut angle = Member { other_name_of: Some("start_angle"), ..start };
            angle.key.name = "angle";
            found.keys.insert(at + 1, angle);
        }
        classes.push(found);
    }
    segments(&root("motion"), &mut classes);
    for name in ["stage", "bearing", "drive", "actuator"] {
        classes.push(plain(&class(name), "Section", &root(name), name));
    }
    classes.push(plain(FILES, "Section", &root("catalogue"), "catalogue"));
    let twin = root("twin");
    classes.push(plain("Measured", "Section", &find(twin.kind.keys(false), "measured"), "twin.measured"));
    classes.push(plain("Twin", "Section", &twin, "twin"));
    let curve = root("curve");
    if let Kind::Variants(variants) = curve.kind {
        let members = variants.keys.iter().map(|key| by_place(key, variants.by)).collect();
        classes.push(Class {
            name: "Curve".to_owned(),
            base: "Section",
            about: about(&curve),
            table: "curve".to_owned(),
            keys: members,
        });
    }
    let mut out = HEAD.to_owned();
    classes.iter().for_each(|each| out.push_str(&written(each)));
    out.push_str(&axis(&root("requirements")));
    let mut all: Vec<&str> = classes.iter().map(|each| each.name.as_str()).collect();
    all.extend(["Axis", "Project"]);
    all.sort_unstable();
    out.push_str("\n\n__all__ = [\n");
    for each in all {
        let _ = writeln!(out, "    \"{each}\",");
    }
    out.push_str("]\n");
    out
}

#[allow(clippy::expect_used, reason = "without the key the module must not be written")]
fn find(keys: &'static [Key], name: &str) -> Key {
    *keys.iter().find(|key| key.name == name).expect("the description has the key")
}

fn about(key: &Key) -> String {
    sentence(&words::key_text(key, Language::En))
}

/// Returns the class of a mechanism; a `Table` is one of Arrow already.
fn mechanism(name: &str) -> String {
    if name == "table" { "TableMechanism".to_owned() } else { class(name) }
}

fn by_place(key: &Key, by: &str) -> Member {
    let member = Member::of(key);
    if key.name == by { member.at_its_place() } else { member.open() }
}

fn plain(name: &str, base: &'static str, key: &Key, table: &str) -> Class {
    let mut keys: Vec<Member> = key.kind.keys(false).iter().map(Member::of).collect();
    for member in &mut keys {
        match member.key.kind {
            Kind::Variants(_) => member.table = Some("Body".to_owned()),
            Kind::Table(_) => member.table = Some(class(member.key.name)),
            _ => {}
        }
    }
    Class { name: name.to_owned(), base, about: about(key), table: table.to_owned(), keys }
}

/// Adds the classes of the segments: one for every law that moves a distance, one for the way back, one for each other law.
fn segments(motion: &Key, classes: &mut Vec<Class>) {
    let Kind::Variants(variants) = motion.kind else { return };
    for (key, name) in
        [("columns", "Columns"), ("units", "Units"), ("recorded_ratio", "RecordedRatio"), ("bearing", "FlangeLoads")]
    {
        classes.push(plain(name, "Section", &find(variants.keys, key), &format!("motion.{key}")));
    }
    let is_move =
        |(_, needed, allowed): &(&str, &[&str], &[&str])| needed.contains(&"distance") || allowed.contains(&"distance");
    let moves: Vec<_> = variants.kinds.iter().copied().filter(is_move).collect();
    let laws: Vec<&str> = moves.iter().map(|(law, ..)| *law).collect();
    let of_moves =
        |name: &str| moves.iter().any(|(_, needed, allowed)| needed.contains(&name) || allowed.contains(&name));
    let of = |class: &str,
              about: &str,
              laws: Vec<&'static str>,
              has: &dyn Fn(&str) -> bool,
              needed: &[&str],
              place: &[&str]| {
        let has = |key: &&Key| key.name == variants.by || has(key.name) || variants.shared.contains(&key.name);
        let keys = variants.keys.iter().filter(has).map(|key| {
            let mut member = Member::of(key).open();
            if key.name == variants.by {
                member.words = Some(laws.clone());
            }
            member.is_required = needed.contains(&key.name);
            member.has_place = place.contains(&key.name);
            member.table = match key.name {
                "columns" => Some("Columns".to_owned()),
                "units" => Some("Units".to_owned()),
                "recorded_ratio" => Some("RecordedRatio".to_owned()),
                "bearing" => Some("FlangeLoads".to_owned()),
                _ => None,
            };
            member
        });
        let keys = keys.collect();
        Class { name: class.to_owned(), base: "Segment", about: about.to_owned(), table: "motion".to_owned(), keys }
    };
    classes.push(of("Move", "A move by a law of motion.", laws.clone(), &of_moves, &["law"], &["law"]));
    let back =
        "A move back to where the motion began: its distance is that of all moves before it, its law that of the last.";
    let mut way_back = of("Return", back, laws, &|name| name != "distance" && of_moves(name), &[], &[]);
    way_back.base = "ReturnMove";
    classes.push(way_back);
    for (law, needed, allowed) in variants.kinds.iter().filter(|kind| !is_move(kind)) {
        let has = |name: &str| needed.contains(&name) || allowed.contains(&name);
        let place: Vec<&str> = match *law {
            "dwell" => vec!["time"],
            _ => needed.iter().copied().take(1).collect(),
        };
        let about = format!("A segment by the law `{law}`: {}.", words::law_text(law_of(law), Language::En));
        classes.push(of(&class(law), &about, vec![law], &has, needed, &place));
    }
}

fn law_of(word: &str) -> project::SegmentLaw {
    project::SegmentLaw::of_id(word).unwrap_or(project::SegmentLaw::Dwell)
}

/// Returns the type of a keyword.
fn type_of(member: &Member) -> String {
    let key = &member.key;
    match key.kind {
        Kind::Quantity(..) | Kind::Along(..) => "Quantity".to_owned(),
        Kind::Number(..) => "float".to_owned(),
        Kind::Numbers(..) => "Sequence[float]".to_owned(),
        Kind::Integer(..) => "int".to_owned(),
        Kind::Bool => "bool".to_owned(),
        Kind::Text => "str".to_owned(),
        Kind::OneOf(words) => literal(member.words.clone().unwrap_or_else(|| words.to_vec())),
        Kind::ListOf(words) => {
            let one = literal(words.iter().copied());
            format!("{one} | Sequence[{one}]")
        }
        Kind::Rows(columns) => format!("Sequence[tuple[{}]]", vec!["Quantity"; columns.len()].join(", ")),
        Kind::Texts | Kind::Bodies => "Sequence[str]".to_owned(),
        Kind::Table(_) => table_class(member),
        Kind::Variants(_) | Kind::OneOrMany(..) => format!("Sequence[{}]", table_class(member)),
    }
}

/// Returns the type of an attribute: the value as it is written.
fn stored_type(member: &Member) -> String {
    match member.key.kind {
        Kind::Quantity(..) | Kind::Along(..) => "str".to_owned(),
        Kind::Numbers(..) => "tuple[float, ...]".to_owned(),
        Kind::ListOf(_) | Kind::Texts | Kind::Bodies => "tuple[str, ...]".to_owned(),
        Kind::Rows(_) => "tuple[tuple[str, ...], ...]".to_owned(),
        Kind::Variants(_) | Kind::OneOrMany(..) => format!("tuple[{}, ...]", table_class(member)),
        _ => type_of(member),
    }
}

fn table_class(member: &Member) -> String {
    member.table.clone().unwrap_or_else(|| class(member.key.name))
}

/// Returns the description of a key for the reader and writer of the package.
fn kind_of(member: &Member) -> String {
    let key = &member.key;
    if let Some(other) = member.other_name_of {
        return format!("Kind(\"alias\", of_key={})", quoted(other));
    }
    let example = project::example(key).and_then(|line| line.split_once("= ").map(|(_, value)| value.to_owned()));
    let example = example.unwrap_or_default();
    let words = |words: &[&str]| {
        let each: Vec<String> = words.iter().map(|word| quoted(word)).collect();
        format!(", words=({},)", each.join(", "))
    };
    let shown = |example: &str| format!(", example={}", quoted(example));
    let (of, more) = match key.kind {
        Kind::Along(_, along, _) => {
            let other = format!(", other={}", quoted(along.example()));
            ("quantity", shown(example.trim_matches('"')) + &other)
        }
        Kind::Quantity(..) => ("quantity", shown(example.trim_matches('"'))),
        Kind::Number(..) => ("number", shown(&example)),
        Kind::Numbers(..) => ("numbers", shown(&example)),
        Kind::Integer(..) => ("integer", shown(&example)),
        Kind::Bool => ("bool", String::new()),
        Kind::Text => ("text", String::new()),
        Kind::OneOf(all) => ("word", words(&member.words.clone().unwrap_or_else(|| all.to_vec()))),
        Kind::ListOf(all) => ("words", words(all)),
        Kind::Rows(columns) => ("rows", format!("{}, columns={}", shown(&example), columns.len())),
        Kind::Texts | Kind::Bodies => ("texts", String::new()),
        Kind::Table(_) => ("table", format!(", table={}", quoted(&table_class(member)))),
        Kind::Variants(_) | Kind::OneOrMany(..) => ("tables", format!(", table={}", quoted(&table_class(member)))),
    };
    format!("Kind(\"{of}\"{more})")
}

/// Returns the text about a keyword: purpose, example with its unit, range.
fn explained(member: &Member) -> String {
    let key = &member.key;
    if let Some(other) = member.other_name_of {
        return format!("Another name of `{other}`.");
    }
    let mut out = about(key);
    let range = |range: Range| match range {
        Range::Positive => ", above zero",
        Range::NotNegative => ", zero or more",
        _ => "",
    };
    match key.kind {
        Kind::Quantity(dimension, of) | Kind::Along(dimension, _, of) => {
            let example = project::example(key).unwrap_or_default();
            let example = example.split_once("= ").map_or("", |(_, value)| value).trim_matches('"').to_owned();
            let kind = named(dimension);
            let line =
                if let Kind::Along(_, along, _) = key.kind { format!(" or {}", named(along)) } else { String::new() };
            let _ = write!(out, " {kind}{line} such as `\"{example}\"`{}.", range(of));
        }
        Kind::Number(low, high) => {
            let _ = write!(out, " {low} to {high}.");
        }
        Kind::Integer(low, high) => {
            let _ = write!(out, " {low} to {high}.");
        }
        _ => {}
    }
    out
}

fn named(dimension: Dimension) -> String {
    let text = dimension.name(Language::En).to_string();
    let mut signs = text.chars();
    signs.next().map_or_else(String::new, |first| first.to_uppercase().chain(signs).collect())
}

fn written(each: &Class) -> String {
    let mut out = format!("\n\nclass {}({}):\n", each.name, each.base);
    let _ = writeln!(out, "    \"\"\"{}\"\"\"\n", doc(&each.about));
    out.push_str("    __slots__ = ()\n");
    let _ = writeln!(out, "    _TABLE = {}", quoted(&each.table));
    let law = each.keys.iter().find(|member| member.key.name == "law");
    let only = law.and_then(|member| member.words.clone()).filter(|words| words.len() == 1);
    if let Some([law]) = only.as_deref() {
        let _ = writeln!(out, "    _LAW = {}", quoted(law));
    }
    let members: Vec<&Member> = each.keys.iter().filter(|member| only.is_none() || member.key.name != "law").collect();
    out.push_str(&body(&members));
    out
}

/// Returns keys, fields and constructor of a class.
fn body(members: &[&Member]) -> String {
    let mut out = String::new();
    let places: Vec<String> =
        members.iter().filter(|member| member.has_place).map(|member| quoted(&name(member.key.name))).collect();
    if !places.is_empty() {
        let _ = writeln!(out, "    _PLACES = ({},)", places.join(", "));
    }
    let needed: Vec<String> =
        members.iter().filter(|member| member.is_required).map(|member| quoted(&name(member.key.name))).collect();
    if !needed.is_empty() {
        let _ = writeln!(out, "    _NEEDED = ({},)", needed.join(", "));
    }
    out.push_str("    _KEYS = {\n");
    for member in members {
        let _ = writeln!(out, "        {}: {},", quoted(&name(member.key.name)), kind_of(member));
    }
    out.push_str("    }\n\n");
    for member in members.iter().filter(|member| member.other_name_of.is_none()) {
        let open = if member.is_required { "" } else { " | None" };
        let _ = writeln!(out, "    {}: {}{open}", name(member.key.name), stored_type(member));
    }
    out.push_str("\n    def __init__(\n        self,\n");
    out.push_str(&signature(members));
    out.push_str("    ) -> None:\n");
    out.push_str("        \"\"\"Args:\n");
    for member in members {
        let _ = writeln!(out, "            {}: {}", name(member.key.name), doc(&explained(member)));
    }
    out.push_str("        \"\"\"\n        self._begin(\n");
    for member in members {
        let own = name(member.key.name);
        let _ = writeln!(out, "            {own}={own},");
    }
    out.push_str("        )\n");
    out
}

/// Returns the parameters of a constructor: those with a place, the required ones, the others.
fn signature(members: &[&Member]) -> String {
    let line = |member: &&Member| {
        let usual = if member.is_required { "" } else { " | None = None" };
        format!("        {}: {}{usual},\n", name(member.key.name), type_of(member))
    };
    let mut out: String = members.iter().filter(|member| member.has_place).map(&line).collect();
    let mut named = members.iter().filter(|member| !member.has_place).peekable();
    if named.peek().is_some() {
        out.push_str("        *,\n");
    }
    out.extend(named.map(line));
    out
}

/// Returns the classes of an axis and of a project with several.
fn axis(requirements: &Key) -> String {
    let mut members: Vec<Member> = Vec::new();
    let root = |name: &str| Member { is_required: false, ..Member::of(&find(project::KEYS, name)) };
    let own = find(project::KEYS, "axis");
    for key in own.kind.keys(false).iter().filter(|key| key.name != "name") {
        members.push(Member::of(key).open());
    }
    for name in ["stage", "bearing", "drive", "actuator", "twin"] {
        members.push(root(name));
    }
    members.push(Member { table: Some("Curve".to_owned()), ..root("curve") });
    members.push(Member { table: Some(FILES.to_owned()), ..root("catalogue") });
    let required = requirements.kind.keys(false).iter();
    members.extend(required.map(|key| Member { is_in_requirements: true, ..Member::of(key).open() }));
    let members: Vec<&Member> = members.iter().collect();
    let mut out = "\n\nclass Axis(BaseAxis):\n    \"\"\"An axis: a load or a mechanism, its motion, and what is required of the \
                   actuator.\n\n    Every function that takes a project takes an axis, a list of axes, or a `Project`.\n    \"\"\"\n\n"
        .to_owned();
    out.push_str("    __slots__ = ()\n");
    let names: Vec<String> = members
        .iter()
        .filter(|member| member.is_in_requirements)
        .map(|member| quoted(&name(member.key.name)))
        .collect();
    let _ = writeln!(out, "    _REQUIREMENTS = (\n        {},\n    )", names.join(",\n        "));
    out.push_str(
        &body(&members)
            .replacen("        *,\n", "        name: str | None,\n        mechanism: LoadOrMechanism,\n        motion: Sequence[Segment] | Segment,\n        *,\n", 1)
            .replacen(
                "        \"\"\"Args:\n",
                "        \"\"\"Args:\n            name: Name of the axis; `None` leaves a single axis without one.\n            mechanism: The load at the \
                 output, or the mechanism between output and load.\n            motion: The segments of the motion in their order.\n",
                1,
            )
            .replacen("        self._begin(\n", "        self._begin(\n            name=name,\n            mechanism=mechanism,\n            motion=motion,\n", 1)
            .replacen("    _KEYS = {\n", "    _PLACES = (\"name\", \"mechanism\", \"motion\")\n    _NEEDED = (\"mechanism\", \"motion\")\n    _KEYS = {\n        \"name\": Kind(\"text\"),\n        \"mechanism\": Kind(\"mechanism\"),\n        \"motion\": Kind(\"tables\", table=\"Segment\"),\n", 1)
            .replacen("    }\n\n", "    }\n\n    name: str | None\n    mechanism: LoadOrMechanism\n    motion: tuple[Segment, ...]\n", 1),
    );
    out.push_str(
        "\n\nclass Project(BaseProject):\n    \"\"\"Several axes in one project, and the curves of actuators that they share.\"\"\"\n\n    \
         __slots__ = ()\n    _KEYS = {\n        \"axis\": Kind(\"tables\", table=\"Axis\"),\n        \"curve\": Kind(\"tables\", table=\"Curve\"),\n        \"catalogue\": Kind(\"table\", table=\"CatalogueFiles\"),\n    }\n    \
         _PLACES = (\"axis\",)\n\n    axis: tuple[Axis, ...]\n    curve: tuple[Curve, ...] | None\n    catalogue: CatalogueFiles | None\n\n    def __init__(self, axis: Sequence[Axis], *, curve: Sequence[Curve] | None = None, catalogue: CatalogueFiles | None = None) -> None:\n        \
         \"\"\"Args:\n            axis: The axes, each with a name of its own.\n            curve: Curves of the user for actuators of the catalogue.\n            catalogue: Catalogue files, whose products are judged beside the built-in series.\n        \
         \"\"\"\n        self._begin(axis=axis, curve=curve, catalogue=catalogue)\n",
    );
    out
}

#[test]
fn every_key_of_the_project_file_is_a_keyword_of_a_class() {
    let text = module();
    fn walk(keys: &'static [Key], found: &mut Vec<&'static str>) {
        for key in keys {
            let inner = [key.kind.keys(false), key.kind.keys(true)];
            if inner.iter().all(|keys| keys.is_empty()) {
                found.push(key.name);
            }
            inner.into_iter().for_each(|keys| walk(keys, found));
        }
    }
    let mut all = Vec::new();
    walk(project::KEYS, &mut all);
    assert!(all.len() > 300, "{}", all.len());
    for key in all.into_iter().filter(|key| *key != "format") {
        assert!(text.contains(&format!("        {}: ", name(key))), "{key}");
    }
}
