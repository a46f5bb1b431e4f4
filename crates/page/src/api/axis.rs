//! Questions about the axes of a project.

use super::asked::Asked;
use super::{Unanswered, record};
use crate::{Reply, ReportAsked};
use figures::{By, Figure, NoFigure, Size, Theme};
use serde::Serialize;
use workbench::answers::{self, Answered, Faults};
use workbench::quantities::Length;
use workbench::text::{terminal, terms};
use workbench::{CheckId, MountAsked, OrderCode, Project, Refusal, Verdict, answer};

/// How many axes are compared.
const COMPARED: std::ops::RangeInclusive<usize> = 2..=5;

/// How many are told in full where nobody says.
const TOP_USUAL: usize = 10;

/// The answers of all axes as one record; where a question about one cannot be answered, only the faults of all.
fn together<T: Serialize>(parts: Vec<Result<(T, bool), Unanswered>>) -> Result<Reply, Unanswered> {
    let (mut records, mut refused, mut fits) = (Vec::new(), Vec::new(), true);
    let mut status = 422;
    for part in parts {
        match part {
            Ok((found, fitting)) => {
                fits &= fitting;
                records.push(found);
            }
            Err(Unanswered::Faults(own, faults)) => {
                status = status.max(own);
                refused.push(faults);
            }
            Err(code) => return Err(code),
        }
    }
    if refused.is_empty() {
        return Ok(record(200, &Answered::of(records, fits)));
    }
    Err(Unanswered::Faults(status, Faults::together(refused)))
}

pub(super) fn size(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let top = if asked.flag("all") { usize::MAX } else { asked.whole("top").unwrap_or(TOP_USUAL) };
    let one = |(_, project): &(usize, Project)| {
        let found = workbench::ranking(project, top, asked.draw(), asked.patience)
            .map_err(|refusal| asked.refused(&refusal))?;
        Ok((found.record(asked.language), found.sizing.fits()))
    };
    together(asked.axes()?.iter().map(one).collect())
}

pub(super) fn check(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let axes = asked.axes()?;
    let code = wanted(asked)?;
    let one = |(_, project): &(usize, Project)| {
        let found = workbench::verification(project, code.as_ref(), asked.draw(), asked.patience)
            .map_err(|refusal| asked.refused(&refusal))?;
        Ok((found.record(asked.language), found.candidate.fits()))
    };
    together(axes.iter().map(one).collect())
}

pub(super) fn explain(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let axes = asked.axes()?;
    let code = wanted(asked)?;
    let check = asked.text("check").and_then(|id| CheckId::ALL.iter().find(|each| each.id() == id)).copied();
    let one = |(_, project): &(usize, Project)| {
        let found = workbench::explanation(project, code.as_ref(), check, asked.patience)
            .map_err(|refusal| asked.refused(&refusal))?;
        Ok((found.record(asked.language), found.candidate.fits()))
    };
    together(axes.iter().map(one).collect())
}

/// The code asked for; its faults stand among those of the axes.
fn wanted(asked: &Asked<'_>) -> Result<Option<OrderCode>, Unanswered> {
    Ok(asked.text("code").map(|text| asked.code_among_others(text)).transpose()?)
}

pub(super) fn compare(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let written: Vec<&str> = asked.all("code").collect();
    if !COMPARED.contains(&written.len()) {
        return Err(answer::fault(&terminal::two_to_five_codes(&written.len(), asked.language)).into());
    }
    let codes = written.iter().map(|text| asked.code_of(text)).collect::<Result<Vec<OrderCode>, _>>()?;
    let one = |(_, project): &(usize, Project)| {
        let found =
            workbench::compare(project, &codes, asked.patience).map_err(|(_, refusal)| asked.refused(&refusal))?;
        let fits = found.candidates.iter().any(workbench::Candidate::fits);
        Ok((answer::comparison(&found, &project.name, asked.language), fits))
    };
    together(asked.axes()?.iter().map(one).collect())
}

pub(super) fn bearing(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let one = |(_, project): &(usize, Project)| {
        let sizes = workbench::bearing_of_each_size(project);
        if sizes.iter().all(|(_, candidate)| workbench::bearing_checks(candidate).next().is_none()) {
            return Err(answer::fault(terms::no_flange_loads(asked.language)).into());
        }
        let fails = |candidate| workbench::bearing_checks(candidate).any(|check| check.verdict == Verdict::Fail);
        let fits = sizes.iter().any(|(_, candidate)| !fails(candidate));
        Ok((answer::bearings(&sizes, asked.language), fits))
    };
    together(asked.axes()?.iter().map(one).collect())
}

pub(super) fn moves(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let (_, project) = asked.axis()?;
    Ok(record(200, &answer::motion(&workbench::moves(&project), asked.language)))
}

pub(super) fn diff(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let code = asked.code_if_any()?;
    let (old_text, new_text) = asked.two_texts()?;
    let (old, new) = (asked.axes_of(&old_text, "old")?, asked.axes_of(&new_text, "new")?);
    let pairs = workbench::paired(&old, &new);
    if pairs.is_empty() {
        return Err(answer::fault(terminal::no_common_axis(asked.language)).into());
    }
    let one = |(before, after): (usize, usize)| {
        let (before, after) = (old.get(before)?, new.get(after)?);
        let inputs = workbench::input_changes((&old_text, before.0), (&new_text, after.0));
        let found = workbench::difference(&before.1, &after.1, code.as_ref(), asked.patience);
        Some(
            found
                .map_err(|refusal| asked.refused(&refusal))
                .map(|found| (answer::difference(&found, &inputs, &after.1.name, asked.language), found.after.fits())),
        )
    };
    together(pairs.into_iter().filter_map(one).collect())
}

pub(super) fn mount(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    mount_of(asked).map(|found| record(200, &found))
}

/// How an actuator is mounted under the loads of a project.
pub(crate) fn mount_of(asked: &Asked<'_>) -> Result<answers::Mount, Unanswered> {
    super::code::mount_under(asked, |code| {
        let (_, project) = asked.axis()?;
        let loads = workbench::joint_loads(&project, code).map_err(|refusal| asked.refused(&refusal))?;
        Ok((MountAsked { axis: loads, ..MountAsked::default() }, Some(project.name)))
    })
}

pub(super) fn plot(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let (_, project) = asked.axis()?;
    let code = asked.code_if_any()?;
    // Sought only where neither a code nor an actuator of the project's own is drawn.
    let best = if code.is_none() && project.actuator.is_none() {
        let found = workbench::sized(&project, 0, asked.patience).map_err(|refusal| asked.refused(&refusal))?;
        found.candidates.first().map(|best| best.id.clone())
    } else {
        None
    };
    let candidate =
        workbench::candidate_for(&project, code.as_ref(), || best).map_err(|refusal| asked.refused(&refusal))?;
    let figure = asked.text("figure").and_then(Figure::of_id).ok_or_else(|| asked.refused(&Refusal::NoData))?;
    let by = if asked.text("by") == Some("length") { By::Length } else { By::Mass };
    let drawing =
        figures::draw(figure, &project, &candidate, by, asked.patience, asked.language).map_err(
            |fault| match fault {
                NoFigure::Refused(refusal) => asked.refused(&refusal),
                other => answer::fault(&other.message(None, asked.language)).into(),
            },
        )?;
    picture(asked, &drawing)
}

pub(super) fn report(asked: &Asked<'_>) -> Result<Reply, Unanswered> {
    let l = asked.language;
    let Some(write) = asked.shell.report() else { return Err(answer::fault(terminal::built_without_report(l)).into()) };
    let axes = asked.axes()?;
    let code = asked.code_if_any()?;
    if axes.len() > 1 && code.is_some() {
        let names: Vec<&str> = axes.iter().map(|(_, project)| project.name.as_str()).collect();
        return Err(answer::fault(&terminal::code_is_for_one_axis(&names.join(", "), l)).into());
    }
    let date = asked.label("date")?;
    let found = write(&ReportAsked {
        text: asked.body()?,
        axes: &axes,
        code,
        full: asked.flag("full"),
        installation: asked.flag("installation"),
        date: date.as_deref(),
        language: l,
        patience: asked.patience,
    });
    let bytes = found.map_err(|what| Unanswered::from(answer::fault(&what)))?;
    Ok(Reply::of(200, super::list::PDF, bytes).saved_as("antrieb.pdf"))
}

/// A drawing in the size and colours asked for.
pub(super) fn picture(asked: &Asked<'_>, drawing: &figures::Drawing) -> Result<Reply, Unanswered> {
    let side = |name: &str, usual: f64| match asked.quantity::<Length>(name)? {
        Some(length) => figures::side_mm(length, asked.language)
            .map_err(|what| Unanswered::from(answer::option_fault(name, (what, None)))),
        None => Ok(usual),
    };
    let (width, height) = drawing.size_mm;
    let size = Size::millimetres(side("width", width)?, side("height", height)?);
    let theme = if asked.text("theme") == Some("dark") { Theme::Dark } else { Theme::Light };
    let svg = drawing.render(&drawing.style(size, theme, asked.language)).into_svg();
    Ok(Reply::of(200, super::list::SVG, svg))
}
