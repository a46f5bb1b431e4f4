//! The keys of the file in the place of the engine's names for what it was given.

use project::{Project, Within};
use provenance::Source;
use sizing::{Check, CheckId, Judgement};

/// Lets every check of a judgement, and every step of its workings, cite the keys of the project as they are written.
pub(crate) fn cite(project: &Project, judgement: &mut Judgement) {
    let governing = judgement.manual.as_ref().map_or(0, |manual| manual.governing);
    for check in &mut judgement.checks {
        let within = within(check, governing);
        let (value, limit) = (check.value.map(|figure| figure.si), check.limit.map(|figure| figure.si));
        check.value_source.iter_mut().for_each(|source| rename(project, source, value, within));
        check.limit_source.iter_mut().for_each(|source| rename(project, source, limit, within));
        for step in &mut check.workings {
            rename(project, &mut step.source, Some(step.si), within);
        }
    }
}

/// The peak speed is that of an instant; what else belongs to one segment is of the move that governs by the manual.
fn within(check: &Check, governing: usize) -> Within {
    match check.at {
        Some(at) if check.id == CheckId::PeakSpeed => Within::At(at),
        _ => Within::Segment(governing),
    }
}

fn rename(project: &Project, source: &mut Source, si: Option<f64>, within: Within) {
    if let Source::Project { key } = source
        && !is_final(key)
        && let Some(stated) = project.stated_at(key, si, within)
    {
        *key = stated.into();
    }
}

/// What the reader itself wrote there: the data of an own actuator and of curves have their keys already.
fn is_final(key: &str) -> bool {
    ["actuator.", "curve[", "axis["].iter().any(|own| key.starts_with(own))
}
