//! Names of the axes of a file: each is one of its own.

use crate::read::{WORD_SHOWN, shortened};
use crate::report::FaultReport;
use crate::stated::{Stated, StatedField};
use crate::{Fault, Hint};
use std::collections::{BTreeMap, BTreeSet};

/// Returns the part of a name that distinguishes it: neither case nor spaces do, so that a name that is selected, spoken or
/// written as a file leads to one axis.
fn distinguishing(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase()
}

/// Reports axes with the name of an earlier one, each with the nearest free name.
pub(crate) fn named_apart<'n>(axes: impl Iterator<Item = &'n Stated<String>> + Clone, report: &mut FaultReport<'_>) {
    // By name: the first field, its line, and the number of the next proposal.
    let mut known: BTreeMap<String, (&Stated<String>, usize, usize)> = BTreeMap::new();
    let names: BTreeSet<String> = axes.clone().filter_map(|name| Some(distinguishing(name.get()?))).collect();
    let (mut line, mut counted) = (1, 0);
    for field in axes {
        let Some(name) = field.get().map(|name| name.trim()) else { continue };
        let span = field.span();
        line += report.text().get(counted..span.start).unwrap_or_default().matches('\n').count();
        counted = counted.max(span.start);
        let Some((first, at, next)) = known.get_mut(&distinguishing(name)) else {
            let _ = known.insert(distinguishing(name), (field, line, 2));
            continue;
        };
        let is_alike = first.get().is_none_or(|first| first.trim() == name);
        let name_shown = shortened(name, WORD_SHOWN);
        let fault = Fault::AxisNamedTwice { name: name_shown, first: first.path(), line: *at, is_alike };
        let free = (*next..).map(|number| (number, format!("{name} {number}")));
        let free = free.into_iter().find(|(_, free)| !names.contains(&distinguishing(free)));
        let hint = free.map(|(number, free)| {
            *next = number + 1;
            Hint::DidYouMean(free)
        });
        report.fault(span, fault, hint);
    }
}

#[cfg(test)]
mod tests {
    use super::distinguishing;
    use crate::{Fault, read};

    /// Two names that differ in case or spaces alone are refused, those that differ in anything else are not.
    #[test]
    fn names_differ_by_more_than_case_and_spaces() {
        let names =
            ["swivel", "Swivel ", "SWIVEL", " swivel", "swivel 2", "Swivel  2", "swivel2", "Größe", "GRÖSSE", "größe"];
        for one in names {
            for other in names {
                let axis = |name: &str| {
                    format!(
                        "[[axis]]\nname = \"{name}\"\n[axis.load]\ninertia = \"1 kg m^2\"\n[[axis.motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n"
                    )
                };
                let text = format!("format = 1\n{}{}", axis(one), axis(other));
                let is_one = distinguishing(one) == distinguishing(other);
                let faults = read(&text).unwrap().report.into_faults();
                let alike = faults.iter().find_map(|each| match each.fault {
                    Fault::AxisNamedTwice { is_alike, .. } => Some(is_alike),
                    _ => None,
                });
                assert_eq!(alike, is_one.then_some(one.trim() == other.trim()), "{one:?} {other:?}: {faults:?}");
            }
        }
        assert_eq!(distinguishing("Swivel \t axis"), "swivel axis");
    }
}
