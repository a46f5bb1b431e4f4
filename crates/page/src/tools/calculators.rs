//! Layouts of the answers of the tools: lines, tables and pictures.

use super::scene::Scene;
use crate::call::query;
use crate::chapters::laid_out;
use axis::InertiaAnswer;
use figures::{Drawing, Size, Style, Theme};
use maud::{Markup, PreEscaped, html};
use quantities::unit::{DEGREE, MILLIMETRE, NEWTON_METRE, REVOLUTION_PER_MINUTE, VOLT};
use quantities::{Language, Measure, Torque, format_significant};
use questions::list::{Inquiry, Unanswered};
use questions::texts::{battery_lines, torsion_lines};
use questions::{PerformanceCurve, answer, chapter, curve_rows, list};
use words::{
    capitalised, commission as commissioning, curve_title, grade_word, page, shape_title, source_text, terminal, terms,
};

/// Width of a picture \[px\].
const WIDTH: f64 = 640.0;

pub(super) fn picture(drawing: &Drawing, name: &str, theme: Theme, language: Language) -> Markup {
    let (width, height) = drawing.size_mm;
    let style = Style::new(Size::pixels(WIDTH, WIDTH * height / width)).theme(theme).language(language).id(name);
    html! { figure.plot { (PreEscaped(drawing.render(&style).into_svg())) figcaption { (drawing.caption) } } }
}

pub(super) fn curve(inquiry: &Inquiry<'_>, scene: &Scene<'_>) -> Result<Markup, Unanswered> {
    let l = inquiry.language;
    let (code, plane) = list::curve::found(inquiry)?;
    Ok(html! {
        (picture(&figures::curves(&code, &plane, l), "tool-curve", scene.theme, l))
        @for curve in &plane.curves { (curve_table(curve, l)) }
    })
}

pub(super) fn encoder(inquiry: &Inquiry<'_>, scene: &Scene<'_>) -> Result<Markup, Unanswered> {
    let l = inquiry.language;
    let found = list::encoder::found(inquiry)?;
    let title = capitalised(words::encoder::turn_the_shaft(l));
    let angle = found.motor.shaft.angle_deg.0;
    Ok(html! {
        // The script writes the angle into its field, which sends the request again.
        label.turn { (title) " " input type="range" id="turn" min="0" max="359.9" step="0.1" value=(angle) data-turns="t-angle" hx-morph-skip=""; }
        @for (place, state) in [Some(&found.motor), found.output_encoder.as_ref()].into_iter().flatten().enumerate() {
            @for (part, drawing) in figures::encoder_tracks(&found.code, state, l).iter().enumerate() {
                (picture(drawing, &format!("tool-tracks-{place}-{part}"), scene.theme, l))
            }
        }
        (laid_out(&chapter::encoder(&found, l)))
    })
}

fn curve_table(curve: &PerformanceCurve, language: Language) -> Markup {
    let l = language;
    let shown = |value: f64| format_significant(value, 4, l);
    let volts =
        curve.voltage.map(|voltage| format!("{} {}", format_significant(voltage.in_unit(&VOLT), 3, l), VOLT.symbol));
    let torque =
        |torque: Option<Torque>| torque.map_or_else(|| "–".to_owned(), |torque| shown(torque.in_unit(&NEWTON_METRE)));
    html! {
        h4 { (capitalised(&curve_title(&curve.kind, l))) @if let Some(volts) = volts { ", " (volts) } }
        p.small { (grade_word(curve.grade, l)) ", " (source_text(&curve.source, l)) }
        div.wide tabindex="0" { table {
            thead { tr { th.number scope="col" { "n min⁻¹" } th.number scope="col" { "T Nm" } th.number scope="col" { (terminal::up_to_nm(l)) } } }
            tbody { @for (speed, lower, upper) in curve_rows(curve) { tr {
                td.number { (shown(speed.in_unit(&REVOLUTION_PER_MINUTE))) } td.number { (torque(lower)) } td.number { (torque(upper)) }
            } } }
        } }
    }
}

pub(super) fn torsion(inquiry: &Inquiry<'_>, scene: &Scene<'_>) -> Result<Markup, Unanswered> {
    let l = inquiry.language;
    let (code, found) = list::torsion::found(inquiry)?;
    let drawing = figures::torsion_curve(&code.to_string(), &found.at(), l);
    Ok(html! {
        @for (place, line) in torsion_lines(&code, &found, l).iter().enumerate() {
            p { @if place == 0 { strong { (line) } } @else { (capitalised(line)) } }
        }
        p.small { (answer::torsion(&code, &found, inquiry.language).source) }
        (picture(&drawing, "tool-torsion", scene.theme, l))
    })
}

pub(super) fn battery(inquiry: &Inquiry<'_>, _: &Scene<'_>) -> Result<Markup, Unanswered> {
    let found = list::battery::found(inquiry)?;
    let source = source_text(&found.life.source, inquiry.language);
    Ok(
        html! { @for line in battery_lines(&found, inquiry.language) { p { (capitalised(&line)) } } p.small { (source) } },
    )
}

/// Returns the sum of the bodies, their common centre of mass, and the part of each.
pub(super) fn inertia_table(found: &InertiaAnswer, language: Language) -> Markup {
    let l = language;
    let number = |value: f64| format_significant(value, 4, l);
    let total = &found.total;
    let heads = ["z", "m [kg]", "r [mm]", "φ [°]", "J_own [kgm²]", "m r² [kgm²]", "J [kgm²]"];
    let balanced = total.centre_radius.si() <= 0.0;
    let centre = if balanced {
        terminal::centre_on_the_axis(l).to_owned()
    } else {
        let (radius, angle) = (total.centre_radius.in_unit(&MILLIMETRE), total.centre_angle.in_unit(&DEGREE));
        let gravity = total.gravity_torque_max().in_unit(&NEWTON_METRE);
        terminal::centre_of_mass(&number(radius), &number(angle), &number(gravity), l)
    };
    html! {
        p { strong { "J = " (number(total.inertia.si())) " kgm², m = " (number(total.mass.si())) " kg" } }
        @for line in centre.lines() { p { (capitalised(line)) } }
        div.wide tabindex="0" { table {
            thead { tr { th scope="col" { "#" } th scope="col" { (capitalised(terms::body(l))) } @for head in heads { th.number scope="col" { (head) } } } }
            tbody { @for (place, each) in found.bodies.iter().enumerate() { tr {
                td { (place + 1) } th scope="row" { (shape_title(each.shape, l)) } td.number { (each.body.count) }
                @for value in [
                    each.parts.mass.si(), each.body.distance.in_unit(&MILLIMETRE), each.body.angle.in_unit(&DEGREE),
                    each.parts.own.si(), each.parts.steiner.si(), each.parts.total.si(),
                ] { td.number { (number(value)) } }
            } } }
        } }
        p.small { (terminal::inertia_explained(l)) }
    }
}

pub(super) fn wiring(inquiry: &Inquiry<'_>, scene: &Scene<'_>) -> Result<Markup, Unanswered> {
    let l = inquiry.language;
    let (found, record) = list::wiring::found(inquiry)?;
    let drawn = found.connectors.iter().filter(|connector| !connector.pins.is_empty());
    let drawings: Vec<Markup> = drawn
        .map(|connector| {
            let drawing = figures::mating_face(&found.code, connector, figures::PinTexts::Full, l);
            let style = Style::new(drawing.size()).theme(scene.theme).language(l).id(connector.role.id());
            html! { figure.plot.small { (PreEscaped(drawing.render(&style).into_svg())) } }
        })
        .collect();
    Ok(html! { div.faces { @for each in &drawings { (each) } } (laid_out(&chapter::wiring(&record, Vec::new(), l))) })
}

pub(super) fn mount(inquiry: &Inquiry<'_>, _: &Scene<'_>) -> Result<Markup, Unanswered> {
    Ok(laid_out(&chapter::mount(&list::mount::found(inquiry)?, inquiry.language)))
}

/// Returns the mounting under the loads of the project.
pub(super) fn mount_in_project(inquiry: &Inquiry<'_>, _: &Scene<'_>) -> Result<Markup, Unanswered> {
    Ok(laid_out(&chapter::mount(&list::mount_project::found(inquiry)?, inquiry.language)))
}

pub(super) fn commission(inquiry: &Inquiry<'_>, scene: &Scene<'_>) -> Result<Markup, Unanswered> {
    let l = inquiry.language;
    let (sheet, objects) = list::commission::found(inquiry)?;
    let ambient = inquiry.given.all("ambient").next().map(|text| ("ambient", text));
    let file = |what: &str, more: &[(&str, &str)]| {
        let own = [("code", sheet.code.as_str()), ("lang", l.id())];
        format!("/api/v1/{what}?{}", query(own.iter().chain(more).copied()))
    };
    let lists: Vec<(&str, &str)> = ambient.into_iter().collect();
    Ok(html! {
        p.downloads {
            a.button href=(file("commission/drive", &[("for", "sinamics")])) download { (page::drive_sinamics(l)) } " "
            a.button href=(file("commission/drive", &[("for", "cia402")])) download { (page::drive_eds(l)) } " "
            @if scene.shell.checklist().is_some() {
                a.button href=(file("commission/checklist", &lists)) download { (page::checklist_pdf(l)) }
            }
        }
        p.small { (page::measured_elsewhere(&commissioning::measured(l), l)) }
        (laid_out(&chapter::commission(&sheet, &objects, l)))
    })
}

pub(super) fn upkeep(inquiry: &Inquiry<'_>, _: &Scene<'_>) -> Result<Markup, Unanswered> {
    let l = inquiry.language;
    let (_, found) = list::upkeep::found(inquiry)?;
    let said = ["code", "delivered", "storage", "hours-per-day", "inspect", "today"];
    let said = said.into_iter().filter_map(|name| Some((name, inquiry.given.all(name).next()?)));
    Ok(html! {
        p.downloads { a.button href={ "/api/v1/upkeep/calendar?" (query(said.chain([("lang", l.id())]))) } download { (page::calendar_file(l)) } }
        (laid_out(&chapter::upkeep(&found, l)))
    })
}
