//! A project file that begins with a recording of the user.

use crate::templates::{Template, template, template_kinds};
use quantities::{Dimension, Language, Unit};
use recording::{Preview, PreviewColumn, Role};
use words::recorded_template;

/// Kind of a project whose mechanism the recording decides.
const RECORDING: &str = "recording";

/// Kind whose motion is stated by speed and times, not by segments.
const MANUAL: &str = "manual";

/// Returns the project of a kind whose motion is a recording; `named` is the recording as the project names it, `file`
/// the name of the project. The kind `recording` begins with a joint if the recording has a torque, with a belt if it
/// is along a line, else with a load. `None` if the kind has no such motion.
#[must_use]
pub fn recorded(kind: &str, preview: &Preview, (named, file): (&str, &str), language: Language) -> Option<Template> {
    if !begins_with_motion(kind) {
        return None;
    }
    let kind = match kind {
        RECORDING => base(preview),
        kind => kind,
    };
    let plain = template(kind, file, language)?.text;
    let (head, motion) = plain.split_once("[[motion]]")?;
    let (_, tail) = motion.split_once("\n[requirements]")?;
    let head = without_figures(head);
    let text = format!("{head}{}\n[requirements]{tail}", segment(preview, named, language));
    Some(Template { text, recording: None })
}

/// Returns the part of a template above its motion with the figures of the machine as comments: those of an example are
/// none of the recorded machine.
fn without_figures(head: &str) -> String {
    let mut is_of_machine = false;
    let line = |line: &str| {
        if let Some(table) = line.strip_prefix('[') {
            is_of_machine = table.starts_with("load") || table.starts_with("mechanism");
        }
        let states = line.starts_with(|sign: char| sign.is_ascii_lowercase()) && line.contains(" = ");
        if is_of_machine && states { format!("# {line}\n") } else { format!("{line}\n") }
    };
    head.lines().map(line).collect()
}

/// Returns `true` if the motion of a kind of project may be a recording.
#[must_use]
pub fn begins_with_motion(kind: &str) -> bool {
    kind != MANUAL && template_kinds().any(|known| known == kind)
}

/// Returns `true` if a column has a unit of a dimension.
fn is_of(column: &PreviewColumn, dimension: Dimension) -> bool {
    column.unit.as_ref().is_some_and(|unit| {
        let unit = unit.trim_matches(['[', ']', '(', ')']);
        Unit::of_dimension(dimension, unit).is_some()
    })
}

/// Returns the column that is recognised for a role. A name that is not recognised may denote another quantity in the same
/// unit, a limit or a deviation: such a column is stated by the user.
fn column_of(preview: &Preview, role: Role) -> Option<&PreviewColumn> {
    preview.columns.iter().find(|column| column.role == Some(role))
}

/// Returns `true` if a column may be the torque of the load, recognised or not: by its unit or by its name.
fn may_be_torque(column: &PreviewColumn) -> bool {
    let name = column.heading.to_lowercase();
    let is_named = || Role::Torque.names().iter().any(|known| known.len() > SYMBOL_MOST && name.contains(known));
    column.role == Some(Role::Torque) || is_of(column, Dimension::Torque) || is_named()
}

/// Length of the longest symbol in letters; longer names of a quantity are words.
const SYMBOL_MOST: usize = 3;

/// Returns the kind that fits the columns of a recording: with a torque, even if it is not recognised, a joint, so that none
/// is left out of the load unseen.
fn base(preview: &Preview) -> &'static str {
    let is_along = |role: Role, dimension| column_of(preview, role).is_some_and(|column| is_of(column, dimension));
    if is_along(Role::Position, Dimension::Length) || is_along(Role::Speed, Dimension::Velocity) {
        "belt"
    } else if preview.columns.iter().any(may_be_torque) {
        "joint"
    } else {
        "load"
    }
}

/// Returns the segment with the recording: its columns as recognised, and a comment for each that is not.
fn segment(preview: &Preview, named: &str, language: Language) -> String {
    let quoted = |text: &str| format!("{text:?}");
    let mut lines = vec!["[[motion]]".to_owned(), "law = \"recorded\"".to_owned(), format!("file = {}", quoted(named))];
    let unused = preview.columns.iter().filter(|column| column.role.is_none());
    let unused: Vec<&str> = unused.map(|column| column.heading.as_str()).collect();
    for role in Role::ALL {
        let key = match role {
            Role::Time => "time",
            Role::Position => "position",
            Role::Speed => "speed",
            Role::Torque => "torque",
        };
        let column = column_of(preview, role);
        lines.push(match column {
            Some(column) => format!("columns.{key} = {}", quoted(&column.name)),
            None => {
                let remark = match unused.as_slice() {
                    [] => recorded_template::none_left(language).to_owned(),
                    _ => recorded_template::not_recognised(&unused.join(", "), language),
                };
                format!("# columns.{key} = \"…\"  # {remark}")
            }
        });
        if let Some(column) = column.filter(|column| column.unit.is_none() && !column.is_clock) {
            lines.push(format!("# units.{key} = \"…\"  # {}", recorded_template::no_unit(&column.heading, language)));
        }
    }
    lines.push(String::new());
    lines.join("\n")
}
