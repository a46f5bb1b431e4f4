//! The drawing of a mechanism: its symbols lead to the rows of the form, and the rows to them; what moves in it follows the
//! instant of the pictures over time.

use crate::form::id;
use maud::{Markup, PreEscaped, html};
use project::Project;
use quantities::{Language, Measure};
use questions::{Drawing, Figures, MechanismId, moves};
use words::page;

/// What is drawn.
pub(crate) struct Shown<'s> {
    /// The key of the mechanism; without one a load at the output.
    pub(crate) mechanism: Option<&'s str>,
    /// What is stated of it.
    pub(crate) figures: Figures,
    /// The path of its table.
    pub(crate) of: &'s str,
    /// What it is called.
    pub(crate) title: &'s str,
    /// The project as it was read last, for the way of its motion.
    pub(crate) project: Option<&'s Project>,
}

fn id_of(mechanism: Option<&str>) -> MechanismId {
    mechanism.and_then(MechanismId::of).unwrap_or(MechanismId::Load)
}

/// The drawing alone, for a picture of a choice.
pub(crate) fn still(mechanism: Option<&str>) -> Markup {
    let drawing = id_of(mechanism).drawing(&Figures::none());
    html! { svg viewBox=(drawing.view_box()) { (PreEscaped(drawing.svg())) } }
}

/// The drawing of a mechanism of which the inclination is known; `of` is the path of its table.
pub(crate) fn of(
    mechanism: Option<&str>,
    inclination: Option<&str>,
    of: &str,
    title: &str,
    language: Language,
) -> Markup {
    let path = format!("{of}.inclination");
    let figures = project::drawn_figures(inclination.map(|text| (path.as_str(), text)), of);
    shown(&Shown { mechanism, figures, of, title, project: None }, language)
}

/// The drawing of a mechanism to the scale of what is stated, with its symbols.
pub(crate) fn shown(it: &Shown<'_>, language: Language) -> Markup {
    let l = language;
    let mechanism = id_of(it.mechanism);
    // The motion of an older text may be that of another mechanism.
    let project = it.project.filter(|project| project.axis.mechanism.id() == mechanism);
    let ratio = project.map_or(1.0, |project| project.axis.mechanism.stage_ratio());
    let figures = project.map_or_else(
        || it.figures.clone(),
        |project| {
            let (from, to) = project.axis.span();
            it.figures.clone().over(from.si() / ratio, to.si() / ratio)
        },
    );
    let drawing = mechanism.drawing(&figures);
    let bearing = it.of.find("].").and_then(|end| it.of.get(..end + 2)).unwrap_or_default();
    // Position along the line, where the pictures show that, per angle of the output.
    let per_output = project.map(moves).filter(|moves| !moves.turns).map(|moves| moves.per_output);
    html! {
        svg.drawn viewBox=(drawing.view_box()) role="group" aria-label=(page::drawing_of(&it.title, l)) data-per-output=[per_output] {
            (PreEscaped(movable(&drawing, ratio)))
            @for call_out in &drawing.call_outs {
                @let path = if call_out.is_of_bearing { format!("{bearing}bearing.{}", call_out.key) } else { format!("{}.{}", it.of, call_out.key) };
                @let [x, y] = call_out.foot();
                a href={ "#" (id(&path)) } data-for=(id(&path)) data-with=[call_out.group] data-at=[call_out.group.map(|_| format!("{:.2} {:.2}", call_out.at[0], call_out.at[1]))] {
                    (PreEscaped(call_out.leader()))
                    text x=(x) y=(y) text-anchor="middle" {
                        @match call_out.symbol.split_once('_') {
                            Some((head, tail)) => { (head) tspan dy="4" font-size="70%" { (tail) } }
                            None => { (call_out.symbol) }
                        }
                    }
                }
            }
        }
    }
}

/// The parts, each group that moves with its table.
fn movable(drawing: &Drawing, ratio: f64) -> String {
    let mut drawn = drawing.movable_svg();
    for (group, moving) in drawing.moving.iter().enumerate() {
        let plain = format!("<g data-group='{group}'>");
        drawn = drawn.replace(&plain, &format!("<g data-group='{group}' data-rows='{}'>", moving.table(ratio)));
    }
    drawn
}
#[cfg(test)]
mod tests {
    use super::*;
    use project::{KEYS, Key, Kind};

    fn keys_of(name: &str) -> &'static [Key] {
        match KEYS.iter().find(|key| key.name == name).map(|key| key.kind) {
            Some(Kind::Table(keys)) => keys,
            _ => &[],
        }
    }

    #[test]
    fn every_mechanism_has_a_drawing_and_every_sign_a_key() {
        let mut seen = Vec::new();
        for kind in keys_of("mechanism") {
            let Kind::Table(rows) = kind.kind else { panic!("{}", kind.name) };
            let drawn = of(Some(kind.name), None, "m", "t", Language::En).into_string();
            assert!(!seen.contains(&drawn), "{}", kind.name);
            for part in drawn.split("href=\"#f-m-").skip(1) {
                let key = part.split('"').next().unwrap_or_default();
                assert!(rows.iter().any(|row| row.name == key), "{}: {key}", kind.name);
            }
            seen.push(drawn);
        }
        let load = of(None, None, "load", "t", Language::De).into_string();
        for part in load.split("href=\"#f-load-").skip(1) {
            let key = part.split('"').next().unwrap_or_default();
            assert!(keys_of("load").iter().any(|row| row.name == key), "{key}");
        }
    }
}
