//! Drawing of a mechanism: its symbols lead to the rows of the form and the rows to them; its moving parts follow the
//! instant of the pictures over time.

use crate::markup::id;
use axis::AxisProject;
use maud::{Markup, PreEscaped, html};
use quantities::{Language, Measure};
use questions::{Drawing, MechanismId, MechanismValues, moves};
use words::page;

/// Content of a drawing.
pub(crate) struct SketchContent<'s> {
    /// Key of the mechanism; `None` for a load at the output.
    pub(crate) mechanism: Option<&'s str>,
    /// Stated values of the mechanism.
    pub(crate) figures: MechanismValues,
    /// Path of its table.
    pub(crate) of: &'s str,
    /// Title.
    pub(crate) title: &'s str,
    /// The project as it was last read; source of the distance of its motion.
    pub(crate) project: Option<&'s AxisProject>,
}

fn id_of(mechanism: Option<&str>) -> MechanismId {
    mechanism.and_then(MechanismId::of).unwrap_or(MechanismId::Load)
}

/// Returns the symbol of a key in the drawing of its mechanism, by its path within an axis: `mechanism.screw.lead`.
pub(crate) fn symbol_of(path: &str) -> Option<&'static str> {
    let (mechanism, key) = match path.strip_prefix("mechanism.") {
        Some(inside) => inside.split_once('.').map(|(kind, key)| (Some(kind), key))?,
        None => (None, path.strip_prefix("load.")?),
    };
    let drawing = id_of(mechanism).drawing(&MechanismValues::none());
    drawing.call_outs.iter().find(|call_out| call_out.key == key && !call_out.is_of_bearing).map(|found| found.symbol)
}

/// Returns the drawing alone, as the picture of an option.
pub(crate) fn still(mechanism: Option<&str>) -> Markup {
    let drawing = id_of(mechanism).drawing(&MechanismValues::none());
    html! { svg viewBox=(drawing.view_box()) { (PreEscaped(drawing.svg())) } }
}

/// Returns the drawing of a mechanism to the scale of the stated values, with its symbols.
pub(crate) fn shown(it: &SketchContent<'_>, language: Language) -> Markup {
    let l = language;
    let mechanism = id_of(it.mechanism);
    // The motion of an older text may belong to another mechanism.
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
    // Position along the line per angle of the output, if the pictures show a linear position.
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
                            Some((head, tail)) => { (head) tspan dy=".3em" font-size="80%" { (tail) } }
                            None => { (call_out.symbol) }
                        }
                    }
                }
            }
        }
    }
}

/// Returns the parts; each moving group has the table of its motion.
fn movable(drawing: &Drawing, ratio: f64) -> String {
    let mut drawn = drawing.movable_svg();
    for (group, moving) in drawing.moving.iter().enumerate() {
        let plain = format!("<g data-group='{group}'>");
        drawn = drawn.replace(&plain, &format!("<g data-group='{group}' data-rows='{}'>", moving.table(ratio)));
    }
    drawn
}
/// Returns the drawing of a recording on its tile: samples over time.
pub(crate) fn recording() -> Markup {
    let samples = [
        (14, 78),
        (26, 77),
        (38, 68),
        (50, 47),
        (62, 26),
        (74, 17),
        (86, 18),
        (98, 27),
        (110, 49),
        (122, 66),
        (134, 77),
        (146, 78),
    ];
    let path = samples.iter().map(|(x, y)| format!("{x} {y}")).collect::<Vec<_>>().join("L");
    html! {
        svg viewBox="0 0 160 100" {
            path.l-thin d="M10 8V90H154" {}
            path.l-line d={ "M" (path) } {}
            @for (x, y) in samples { circle.l-mark cx=(x) cy=(y) r="2.4" {} }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use project::{KEYS, Key, Kind};

    /// Returns the drawing with an inclination, as text.
    fn drawn_of(mechanism: Option<&str>, inclination: Option<f64>, of: &str, language: Language) -> String {
        let figures =
            inclination.map_or_else(MechanismValues::none, |angle| MechanismValues::none().with("inclination", angle));
        shown(&SketchContent { mechanism, figures, of, title: "t", project: None }, language).into_string()
    }

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
            let drawn = drawn_of(Some(kind.name), None, "m", Language::En);
            assert!(!seen.contains(&drawn), "{}", kind.name);
            for part in drawn.split("href=\"#f-m-").skip(1) {
                let key = part.split('"').next().unwrap_or_default();
                assert!(rows.iter().any(|row| row.name == key), "{}: {key}", kind.name);
            }
            seen.push(drawn);
        }
        let load = drawn_of(None, None, "load", Language::De);
        for part in load.split("href=\"#f-load-").skip(1) {
            let key = part.split('"').next().unwrap_or_default();
            assert!(keys_of("load").iter().any(|row| row.name == key), "{key}");
        }
    }

    /// Requires that a moving group has its table, and that the anchors of its symbols are stated for the script.
    #[test]
    fn what_moves_has_its_table() {
        let texts = KEYS.iter().find(|key| key.name == "mechanism").map(|key| key.kind);
        let Some(Kind::Table(kinds)) = texts else { panic!("no mechanisms") };
        for kind in kinds {
            let drawn = drawn_of(Some(kind.name), Some(1.57), "m", Language::En);
            assert!(drawn.contains("data-rows='"), "{}", kind.name);
            assert_eq!(drawn.matches("data-with=").count(), drawn.matches("data-at=").count(), "{}", kind.name);
            assert!(!drawn.contains("style="), "{}", kind.name);
        }
    }

    /// Requires that a stated overhang is shown and leads to its row in the table of the bearing of its axis.
    #[test]
    fn an_overhang_is_shown_where_it_is_stated() {
        for (table, row) in
            [("mechanism.hoist", "#f-bearing-overhang"), ("axis[2].mechanism.hoist", "#f-axis-2--bearing-overhang")]
        {
            let with = |figures: MechanismValues| {
                let it = SketchContent { mechanism: Some("hoist"), figures, of: table, title: "t", project: None };
                shown(&it, Language::De).into_string()
            };
            assert!(with(MechanismValues::none().with("overhang", 0.1)).contains(&format!("href=\"{row}\"")));
            assert!(!with(MechanismValues::none()).contains("overhang"));
        }
    }

    /// Requires that the motion of a project gives the stroke: the drawing contains the travel of its slide and its
    /// scale in millimetres.
    #[test]
    fn a_project_gives_the_way_of_its_motion() {
        let id = MechanismId::Screw;
        let projects = questions::read_all(id.example(), &axis::NoFiles).unwrap_or_default();
        let project = projects.first();
        let it = |mechanism| SketchContent {
            mechanism: Some(mechanism),
            figures: MechanismValues::none().with("lead", 0.01),
            of: "mechanism.screw",
            title: "t",
            project,
        };
        let drawn = shown(&it("screw"), Language::En).into_string();
        assert!(project.is_some() && drawn.contains("data-per-output=\"0.00"), "{drawn}");
        // The motion does not apply to another mechanism.
        assert!(!shown(&it("belt"), Language::En).into_string().contains("data-per-output"));
    }
}
