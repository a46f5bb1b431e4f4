//! The loads on the output bearing over the cycle.

use crate::cycle::{LIMIT_NEAR, segments};
use crate::drawing::{Drawing, Figure};
use crate::fault::NoFigure;
use crate::words::{amount, listed, say, subject};
use plot::{Axis, Dash, Label, Line, Panel, Reference, StackedChart, Tone};
use workbench::quantities::unit::{NEWTON, NEWTON_METRE, SECOND};
use workbench::quantities::{Language, Measure, Unit};
use workbench::{Candidate, CheckId, FlangeSample, Project};

type Load = fn(&FlangeSample) -> Option<f64>;

/// Radial force, axial force and tilting moment on the output bearing over the cycle.
///
/// # Errors
/// [`NoFigure::NoFlangeLoads`]
pub fn bearing_load(project: &Project, candidate: &Candidate<'_>, language: Language) -> Result<Drawing, NoFigure> {
    let course = workbench::flange_course(project, candidate).ok_or(NoFigure::NoFlangeLoads)?;
    let t = |en, de| say(language, en, de);
    let kinds: [(Axis, &Unit, CheckId, &str, Load, &str); 3] = [
        (
            Axis::new("F_r", NEWTON.symbol).name(t("Radial force", "Radialkraft")),
            &NEWTON,
            CheckId::BearingRadial,
            "F_R,dyn(max)",
            |load| Some(load.radial.si()),
            t("the radial force", "die Radialkraft"),
        ),
        (
            Axis::new("F_a", NEWTON.symbol).name(t("Axial force", "Axialkraft")),
            &NEWTON,
            CheckId::BearingAxial,
            "F_A,dyn(max)",
            |load| Some(load.axial.si()),
            t("the axial force", "die Axialkraft"),
        ),
        (
            Axis::new("M", NEWTON_METRE.symbol).name(t("Tilting moment", "Kippmoment")),
            &NEWTON_METRE,
            CheckId::BearingTiltingMoment,
            "M_dyn(max)",
            |load| Some(load.moment?.si()),
            t("the tilting moment", "das Kippmoment"),
        ),
    ];
    let mut chart = StackedChart::new(Axis::new("t", SECOND.symbol).name(t("Time", "Zeit")).minor_ticks());
    for (from, to, name) in segments(project, language) {
        chart = chart.segment(from, to, name);
    }
    let mut told = Vec::new();
    for (axis, unit, id, symbol, of, name) in kinds {
        let steps = course.iter().filter_map(|load| Some((load.time.si(), unit.from_si(of(load)?))));
        let steps: Vec<(f64, f64)> = steps.collect();
        if steps.is_empty() {
            continue;
        }
        let largest = course.iter().filter_map(of).fold(0.0, f64::max);
        let check = candidate.judgement.checks.iter().find(|check| check.id == id);
        let limit = check.and_then(|check| check.limit);
        let mut line = Line::new(steps).tone(Tone::Trace);
        let mut panel = Panel::new(axis);
        let shown = amount(largest, unit, language);
        if let Some(limit) = limit {
            let text = amount(limit.si, limit.unit, language);
            // A limit far above would press the load onto the axis.
            if largest >= LIMIT_NEAR * limit.si {
                panel = panel.with(
                    Reference::horizontal(limit.value())
                        .tone(Tone::Continuous)
                        .dash(Dash::Dashed)
                        .label(Label::symbol(symbol).text(&format!(" = {text}"))),
                );
            }
            line = line.label(match language {
                Language::En => format!("at most {shown} of {text}"),
                Language::De => format!("höchstens {shown} von {text}"),
            });
            told.push(match language {
                Language::En => format!("{name} reaches {shown} of {text}"),
                Language::De => format!("{name} erreicht {shown} von {text}"),
            });
        } else {
            told.push(match language {
                Language::En => format!("{name} reaches {shown}"),
                Language::De => format!("{name} erreicht {shown}"),
            });
        }
        panel = panel.with(line);
        chart = chart.panel(panel);
    }
    let description = format!("{}.", crate::words::sentence(&listed(&told, language)));
    let caption = t(
        "Loads as the project states them, or as they follow from the mechanism; the tilting moment is about the middle of the bearing. The limits hold one at a time; one far above the load is named and not drawn.",
        "Lasten, wie das Projekt sie angibt oder wie sie aus dem Mechanismus folgen; das Kippmoment gilt für die Mitte des Lagers. Die Grenzen gelten je für sich; eine weit über der Last ist genannt und nicht gezeichnet.",
    );
    Ok(Drawing::new(Figure::BearingLoad, &subject(candidate, &project.name), (165.0, 115.0), language).stacked(
        caption.to_owned(),
        description,
        chart,
    ))
}
