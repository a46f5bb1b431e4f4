//! The keys of the file in the place of the engine's names for what it was given.

use project::{Project, Within};
use provenance::{Key, Source};
use sizing::{Check, CheckId, Judgement};

/// The keys of a project that were asked for: the same few for every candidate.
#[derive(Debug)]
pub(crate) struct Cited<'p> {
    project: &'p Project,
    known: Vec<Known>,
}

/// Where a role is stated that has a value and belongs to a place of the motion.
#[derive(Debug)]
struct Known {
    role: Key,
    /// Only loads on the flange are told apart by it.
    si: Option<f64>,
    within: Within,
    /// `None` where the role is the key itself.
    key: Option<Key>,
}

impl<'p> Cited<'p> {
    pub(crate) const fn of(project: &'p Project) -> Self {
        Self { project, known: Vec::new() }
    }

    pub(crate) const fn project(&self) -> &'p Project {
        self.project
    }

    /// Lets every check of a judgement, and every step of its workings, cite the keys of the project as they are written.
    pub(crate) fn cite(&mut self, judgement: &mut Judgement) {
        let governing = judgement.manual.as_ref().map_or(0, |manual| manual.governing);
        for check in &mut judgement.checks {
            let within = within(check, governing);
            let (value, limit) = (check.value.map(|figure| figure.si), check.limit.map(|figure| figure.si));
            check.value_source.iter_mut().for_each(|source| self.rename(source, value, within));
            check.limit_source.iter_mut().for_each(|source| self.rename(source, limit, within));
            for step in &mut check.workings {
                self.rename(&mut step.source, Some(step.si), within);
            }
        }
    }

    fn rename(&mut self, source: &mut Source, si: Option<f64>, within: Within) {
        let Source::Project { key } = source else { return };
        if is_final(key) {
            return;
        }
        let si = si.filter(|_| key.starts_with("bearing."));
        let same = |known: &&Known| known.role == *key && known.si == si && known.within == within;
        let found = self.known.iter().find(same).map(|known| known.key.clone());
        let stated = found.unwrap_or_else(|| {
            let stated = self.project.stated_at(key, si, within).map(Key::from);
            if self.known.len() < KNOWN_MOST {
                self.known.push(Known { role: key.clone(), si, within, key: stated.clone() });
            }
            stated
        });
        if let Some(stated) = stated {
            *key = stated;
        }
    }
}

/// More are not kept: where every candidate has its own instant, looking for it costs more than asking anew.
const KNOWN_MOST: usize = 64;

/// The peak speed is that of an instant; what else belongs to one segment is of the move that governs by the manual.
fn within(check: &Check, governing: usize) -> Within {
    match check.at {
        Some(at) if check.id == CheckId::PeakSpeed => Within::At(at),
        _ => Within::Segment(governing),
    }
}

/// What the reader itself wrote there: the data of an own actuator and of curves have their keys already.
fn is_final(key: &str) -> bool {
    ["actuator.", "curve[", "axis["].iter().any(|own| key.starts_with(own))
}
