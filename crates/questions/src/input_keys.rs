//! Replacement of the engine's names for inputs by the keys of the project file.

use axis::{AxisProject, Within};
use provenance::{Grade, Key, Source};
use sizing::{Check, CheckId};
use std::sync::Arc;

/// Cached keys of a project: every candidate requires the same few.
#[derive(Debug)]
pub(crate) struct InputKeys<'p> {
    project: &'p AxisProject,
    known: Vec<Known>,
}

/// Key of a role of the engine at a value and a place of the motion.
#[derive(Debug)]
struct Known {
    role: Key,
    /// The value that distinguishes the role from others of the same name; `None` if the value is irrelevant.
    si: Option<Option<f64>>,
    within: Within,
    /// `None` if the role is already the key.
    key: Option<Key>,
}

impl<'p> InputKeys<'p> {
    pub(crate) const fn of(project: &'p AxisProject) -> Self {
        Self { project, known: Vec::new() }
    }

    /// Replaces the sources of a check and of its workings by the keys of the project; `governing` is the segment whose
    /// move governs by the manual.
    pub(crate) fn cite(&mut self, check: &mut Check, governing: usize) {
        let is_key = |source: &Option<Source>| matches!(source, Some(Source::Project { .. }));
        if check.workings.is_empty() && !is_key(&check.value_source) && !is_key(&check.limit_source) {
            return;
        }
        let within = within(check, governing);
        let (value, limit) = (check.value.map(|figure| figure.si), check.limit.map(|figure| figure.si));
        check.value_source.iter_mut().for_each(|source| {
            self.rename(source, value, within);
        });
        check.limit_source.iter_mut().for_each(|source| {
            self.rename(source, limit, within);
        });
        for step in &mut check.workings {
            if self.rename(&mut step.source, Some(step.si), within)
                && let Source::Project { key } = &step.source
                && !self.project.states(key)
            {
                step.source = Source::NotStated { key: Arc::from(&**key) };
                step.grade = Grade::Assumed;
            }
        }
    }

    /// Replaces a name of the engine by the keys of the file; returns `true` if it was one.
    fn rename(&mut self, source: &mut Source, si: Option<f64>, within: Within) -> bool {
        let Source::Project { key } = source else { return false };
        let fits = |known: &&Known| known.within == within && known.si.is_none_or(|known| known == si);
        // Most names of the engine are the same few texts at the same address.
        let is_same = |known: &&Known| std::ptr::eq(&*known.role, &**key) && fits(known);
        let is_equal = |known: &&Known| known.role == *key && fits(known);
        let known = self.known.iter();
        let stated = match known.clone().find(is_same).or_else(|| known.clone().find(is_equal)) {
            Some(known) => known.key.clone(),
            None if is_final(key) => return false,
            None => {
                // Only loads on the flange are distinguished by their value.
                let by_value = key.starts_with("bearing.");
                let stated = self.project.stated_at(key, si.filter(|_| by_value), within).map(Key::from);
                if self.known.len() < KNOWN_MOST {
                    let si = by_value.then_some(si);
                    self.known.push(Known { role: key.clone(), si, within, key: stated.clone() });
                }
                stated
            }
        };
        if let Some(stated) = stated {
            *key = stated;
        }
        true
    }
}

/// Largest number of cached keys. If every candidate has its own instant, a search in a longer list costs more than a
/// new request.
const KNOWN_MOST: usize = 64;

/// Returns the place of a check in the motion: the instant of the peak speed, else the segment whose move governs by
/// the manual.
fn within(check: &Check, governing: usize) -> Within {
    match check.at {
        Some(at) if check.id == CheckId::PeakSpeed => Within::At(at),
        _ => Within::Segment(governing),
    }
}

/// Returns `true` if the reader already cites the key: data of an own actuator and of curves.
fn is_final(key: &str) -> bool {
    ["actuator.", "curve[", "axis["].iter().any(|own| key.starts_with(own))
}
