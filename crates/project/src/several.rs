//! A further axis in a file: the axis at its root becomes one of several.

use crate::edit::{EditFault, Written, written};
use std::ops::Range as Span;
use toml_edit::Value;

/// Table of an axis in a file with several.
const AXIS: &str = "axis";

/// Root keys that all axes share.
const SHARED: [&str; 3] = ["format", "curve", "catalogue"];

/// Returns the text of a project with a further axis behind those that it has.
///
/// `further` is the text of a project with one axis at its root, of which the shared keys are left out. A file with one
/// axis becomes one with several; its axis takes the name `first` unless it has one. Comments and order are kept.
///
/// # Errors
/// [`EditFault`]; the path of a text that states tables of the axis without headings.
pub fn with_axis(text: &str, first: &str, further: &str, name: &str) -> Result<String, EditFault> {
    let mut joined = if axes(text)? > 0 { text.to_owned() } else { separated(text, first)? };
    let further = separated(further, name)?;
    let keys = written(&further).ok_or(EditFault::Syntax)?;
    let begin = keys.iter().find(|key| key.path == "axis[1]").map(|key| key.span.start).ok_or(EditFault::Path)?;
    if !joined.ends_with('\n') {
        joined.push('\n');
    }
    joined.push('\n');
    joined.push_str(further.get(begin..).ok_or(EditFault::Path)?);
    if axes(&joined)? < 2 { Err(EditFault::Path) } else { Ok(joined) }
}

/// Returns the number of `[[axis]]` tables.
fn axes(text: &str) -> Result<usize, EditFault> {
    let keys = written(text).ok_or(EditFault::Syntax)?;
    let is_axis =
        |key: &&Written| key.path.strip_prefix("axis[").is_some_and(|rest| rest.ends_with(']') && !rest.contains('.'));
    Ok(keys.iter().filter(is_axis).count())
}

fn is_shared(path: &str) -> bool {
    SHARED
        .iter()
        .any(|shared| path.strip_prefix(shared).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '['])))
}

/// Returns a text with one axis at its root as one with `[[axis]]`.
fn separated(text: &str, name: &str) -> Result<String, EditFault> {
    let keys = written(text).ok_or(EditFault::Syntax)?;
    let is_heading =
        |key: &&Written| key.value.is_none() && text.get(key.span.clone()).is_some_and(|head| head.starts_with('['));
    let mut headings: Vec<(&str, Span<usize>)> =
        keys.iter().filter(is_heading).map(|key| (key.path.as_str(), key.span.clone())).collect();
    headings.sort_by_key(|(_, span)| span.start);
    let named = keys.iter().any(|key| key.path == "axis.name");
    let name_line = if named { String::new() } else { format!("name = {}\n", Value::from(name)) };
    let behind =
        |place: usize| headings.iter().map(|(_, span)| span.start).find(|start| *start > place).unwrap_or(text.len());
    // The block of the axis stands before its other tables.
    let own = headings.iter().find(|(path, _)| *path == AXIS).map(|(_, span)| span.start..behind(span.start));
    let first = headings.iter().find(|(path, _)| !is_shared(path)).map_or(text.len(), |(_, span)| span.start);
    let own_head = headings.iter().find(|(path, _)| *path == AXIS).map(|(_, span)| span.clone());
    let own_rest = match (&own, own_head) {
        (Some(block), Some(head)) => text.get(head.end..block.end).ok_or(EditFault::Path)?,
        _ => "",
    };
    let (remark, keys_of_axis) = own_rest.split_once('\n').unwrap_or((own_rest, ""));
    let mut out = text.get(..first).ok_or(EditFault::Path)?.to_owned();
    if !out.is_empty() && !out.ends_with('\n') {
        out.push('\n');
    }
    out.push_str(&format!("[[axis]]{remark}\n{name_line}{keys_of_axis}"));
    if own.is_none() {
        out.push('\n');
    }
    let mut at = first;
    for (path, span) in headings.iter().filter(|(_, span)| span.start >= first) {
        out.push_str(text.get(at..span.start).ok_or(EditFault::Path)?);
        at = span.start;
        if *path == AXIS {
            at = behind(span.start);
        } else if !is_shared(path) {
            let head = text.get(span.clone()).ok_or(EditFault::Path)?;
            let brackets = head.len() - head.trim_start_matches('[').len();
            out.push_str(&format!("{}axis.{}", &"[["[..brackets.min(2)], head.trim_start_matches('[')));
            at = span.end;
        }
    }
    out.push_str(text.get(at..).ok_or(EditFault::Path)?);
    if values(&out, "axis[1].")? == expected(&keys, named, name) { Ok(out) } else { Err(EditFault::Path) }
}

/// Returns path and value of each value of the axis, and of the shared keys.
fn values(text: &str, prefix: &str) -> Result<Vec<(String, String)>, EditFault> {
    let keys = written(text).ok_or(EditFault::Syntax)?;
    let own = |key: Written| {
        let is_of_axis = key.path.starts_with(prefix);
        (is_of_axis || is_shared(&key.path)).then_some((key.path, key.value?))
    };
    let mut found: Vec<_> = keys.into_iter().filter_map(own).collect();
    found.sort();
    Ok(found)
}

/// Returns the values of a text with one axis under the paths of one of several.
fn expected(keys: &[Written], named: bool, name: &str) -> Vec<(String, String)> {
    let moved = |key: &Written| {
        let path = match key.path.strip_prefix("axis.") {
            _ if is_shared(&key.path) => key.path.clone(),
            Some(inside) => format!("axis[1].{inside}"),
            None => format!("axis[1].{}", key.path),
        };
        Some((path, key.value.clone()?))
    };
    let own = (!named).then(|| ("axis[1].name".to_owned(), name.to_owned()));
    let mut found: Vec<_> = keys.iter().filter_map(moved).chain(own).collect();
    found.sort();
    found
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

    use super::*;

    fn examples() -> Vec<String> {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
        let files = std::fs::read_dir(folder).unwrap().flatten().map(|entry| entry.path());
        let texts = files.filter(|path| path.extension().is_some_and(|ending| ending == "toml"));
        texts.map(|path| std::fs::read_to_string(path).unwrap()).filter(|text| text.contains("[[motion]]")).collect()
    }

    /// Every value of both files is a value of the joined one, under the path of its axis; comments stay.
    #[test]
    fn two_files_become_two_axes_with_all_their_values() {
        let all = examples();
        assert!(all.len() > 5);
        for one in &all {
            for other in &all {
                let joined = with_axis(one, "first", other, "second");
                let Ok(joined) = joined else { panic!("{one}\n{other}") };
                assert_eq!(axes(&joined), Ok(2));
                for (text, index, name) in [(one, 1, "first"), (other, 2, "second")] {
                    let keys = written(text).unwrap();
                    let named = keys.iter().any(|key| key.path == "axis.name");
                    let wanted = expected(&keys, named, name).into_iter().filter(|(path, _)| !is_shared(path));
                    let found = written(&joined).unwrap();
                    for (path, value) in wanted {
                        let path = path.replacen("axis[1]", &format!("axis[{index}]"), 1);
                        assert!(
                            found.iter().any(|key| key.path == path && key.value.as_ref() == Some(&value)),
                            "{path}\n{joined}"
                        );
                    }
                }
                let remarks = |text: &str| text.lines().filter(|line| line.trim_start().starts_with('#')).count();
                assert!(remarks(&joined) >= remarks(one));
            }
        }
    }

    #[test]
    fn a_third_axis_is_added_and_a_file_without_headings_is_refused() {
        let one = "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[axis]\nsingle_move = true\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n";
        let two = with_axis(one, "a", one, "b").unwrap();
        let three = with_axis(&two, "x", one, "c \"d\"").unwrap();
        let names: Vec<String> = written(&three)
            .unwrap()
            .into_iter()
            .filter(|key| key.path.ends_with(".name"))
            .filter_map(|key| key.value)
            .collect();
        assert_eq!(names, ["a", "b", "c \"d\""]);
        assert!(with_axis("format = 1\nload.inertia = \"1 kg m^2\"\n", "a", one, "b").is_err());
        assert_eq!(with_axis("= =", "a", one, "b"), Err(EditFault::Syntax));
    }
}
