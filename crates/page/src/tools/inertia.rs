//! Moment of inertia of bodies that are entered row by row and drawn to scale; the result fills the field that the tool
//! was opened from.

use super::calculators::inertia_table;
use super::field::{MARK, Trouble};
use super::scene::Scene;
use crate::markup::{label_of, vals};
use crate::value::{said, stated, with_mark};
use axis::{BodyAnswer, InertiaAnswer, inertia};
use maud::{Markup, html};
use project::{BODY_SHAPES, BodyShape};
use quantities::{Language, Measure, parse_as};
use questions::{BodyOrientation, SolidShape};
use words::{body_key, capitalised, page, shape_title, worded};

/// Largest number of rows.
const ROWS_MOST: usize = 40;

/// Density of a material, as in a project file, with its source.
const MATERIALS: [(&str, &str); 2] = [
    // EN 1993-1-2, 3.2.2
    ("steel", "7850 kg/m^3"),
    // EN 1999-1-1, 3.2.5
    ("aluminium", "2700 kg/m^3"),
];

/// Path of the field that takes the result, in requests.
const INTO: &str = "into";

/// A row: a shape and the values of its keys as typed.
struct BodyRow {
    shape: &'static BodyShape,
    values: Vec<(&'static str, String)>,
}

/// Returns the unit that a bare number of a key has.
fn unit(key: &str) -> &'static str {
    match key {
        "mass" => "kg",
        "density" => "kg/m^3",
        "angle" => "deg",
        "count" => "",
        _ => "mm",
    }
}

/// Returns the keys of a shape that a row shows, in their order.
fn keys(shape: &BodyShape) -> impl Iterator<Item = &'static str> + use<> {
    shape.dimensions.iter().copied().chain(shape.extent).chain(["mass", "density", "distance", "angle", "count"])
}

impl BodyRow {
    /// Returns the line of the body.
    fn line(&self, language: Language) -> String {
        let pair = |(key, typed): &(&str, String)| {
            let value: String = stated(typed, unit(key), language).split_whitespace().collect();
            (!value.is_empty()).then(|| format!(" {key}={value}"))
        };
        format!("{}{}", self.shape.name, self.values.iter().filter_map(pair).collect::<String>())
    }

    /// Reads a line of a link.
    fn of_line(line: &str, language: Language) -> Option<Self> {
        let mut words = line.split_whitespace();
        let name = words.next()?;
        let shape = BODY_SHAPES.iter().find(|shape| shape.name == name)?;
        let pairs: Vec<(&str, &str)> = words.filter_map(|word| word.split_once('=')).collect();
        let all = ["axis"].into_iter().filter(|_| shape.may_lie).chain(keys(shape));
        let value = |key: &'static str| {
            let stated = pairs.iter().find(|(of, _)| *of == key).map_or("", |(_, value)| value);
            (key, spaced(stated, language))
        };
        Some(Self { shape, values: all.map(value).collect() })
    }
}

/// Returns the bodies of the turntable of the shown axis, as lines.
fn bodies_of_axis(scene: &Scene<'_>) -> String {
    let lines = scene.of_axis("mechanism.turntable.bodies").unwrap_or_default();
    let mut tables: Vec<(String, String)> = Vec::new();
    for (rest, value) in scene.below_axis("mechanism.turntable.body[") {
        let Some((place, key)) = rest.split_once("].") else { continue };
        if tables.last().is_none_or(|(of, _)| of != place) {
            tables.push((place.to_owned(), String::new()));
        }
        let Some((_, line)) = tables.last_mut() else { continue };
        let value: String = value.split_whitespace().collect();
        *line = if key == "shape" { format!("{value}{line}") } else { format!("{line} {key}={value}") };
    }
    let lines = lines.lines().map(str::to_owned).chain(tables.into_iter().map(|(_, line)| line));
    lines.collect::<Vec<_>>().join("\n")
}

/// Returns the rows of a request: those typed, those of a link, or those of the axis in work.
fn rows(scene: &Scene<'_>) -> Vec<BodyRow> {
    let l = scene.language;
    let of_text = |text: &str| text.lines().filter_map(|line| BodyRow::of_line(line, l)).take(ROWS_MOST).collect();
    if scene.typed("rows").is_none_or(|rows| rows.is_empty()) {
        return match scene.typed("body").filter(|text| !text.is_empty()) {
            Some(text) => of_text(&text),
            None if scene.call.field(INTO).is_some() => Vec::new(),
            None => of_text(&bodies_of_axis(scene)),
        };
    }
    let row = |index: usize| {
        let field = |key: &str| scene.typed(&format!("{key}-{index}")).unwrap_or_default();
        let name = field("shape");
        let shape = BODY_SHAPES.iter().find(|shape| shape.name == name)?;
        let material = field("material");
        let density = MATERIALS.iter().find(|(name, _)| *name == material).map(|(_, density)| with_mark(density, l));
        let value = |key: &'static str| {
            let typed = field(key);
            (
                key,
                match (key, &density) {
                    ("density", Some(density)) => density.clone(),
                    ("mass", Some(_)) => String::new(),
                    _ => typed,
                },
            )
        };
        let all = ["axis"].into_iter().filter(|_| shape.may_lie).chain(keys(shape));
        Some(BodyRow { shape, values: all.map(value).collect() })
    };
    (0..ROWS_MOST).filter_map(row).collect()
}

/// Returns the tool.
pub(super) fn shown(scene: &Scene<'_>) -> Markup {
    let l = scene.language;
    let rows = rows(scene);
    let text = rows.iter().map(|row| row.line(l)).collect::<Vec<_>>().join("\n");
    let into = scene.call.field(INTO).filter(|path| label_of(path, l).is_some());
    let answer = if rows.is_empty() { None } else { Some(inertia(&text)) };
    let faults = match &answer {
        Some(Err(faults)) => worded(faults, l),
        _ => Vec::new(),
    };
    let of_row = |index: usize| -> Vec<Trouble> {
        faults
            .iter()
            .filter(|fault| fault.line == index + 1)
            .map(|fault| Trouble { field: None, message: fault.message.clone(), hint: fault.hint.clone() })
            .collect()
    };
    // A line of a link that names no shape has no row.
    let lost: Vec<String> = match scene.typed("body") {
        Some(text) if scene.typed("rows").is_none_or(|rows| rows.is_empty()) => text
            .lines()
            .filter(|line| !line.trim().is_empty() && BodyRow::of_line(line, l).is_none())
            .map(str::to_owned)
            .collect(),
        _ => Vec::new(),
    };
    html! {
        input type="hidden" name={ (MARK) "rows" } value="true";
        @if let Some(into) = &into { input type="hidden" name=(INTO) value=(into); }
        @for line in &lost { p.fault { (page::no_body(line, l)) } }
        div.bodies {
            @for (index, row) in rows.iter().enumerate() { (body(index, Some(row), &of_row(index), l)) }
            @if rows.len() < ROWS_MOST { (body(rows.len(), None, &[], l)) }
        }
        div id="tool-answer" aria-live="polite" {
            @if let Some(Ok(found)) = &answer {
                (drawing(found, l))
                @if let Some(into) = &into { (fills(into, found, l)) }
                (inertia_table(found, l))
            }
        }
        (scene.link(&[("body", &text)]))
    }
}

/// Returns the row of a body; without one, the choice of a further shape.
fn body(index: usize, row: Option<&BodyRow>, troubles: &[Trouble], language: Language) -> Markup {
    let l = language;
    let chosen = row.map_or("", |row| row.shape.name);
    let name = |key: &str| format!("{MARK}{key}-{index}");
    let id = |key: &str| format!("t-{key}-{index}");
    let title = page::body_number(&(index + 1), l);
    let material = row.and_then(|row| {
        let (_, density) = row.values.iter().find(|(key, _)| *key == "density")?;
        let of = |text: &str| parse_as::<quantities::MassDensity>(&crate::value::taken(text, l)).ok().map(Measure::si);
        MATERIALS.iter().find(|(_, known)| of(density).is_some() && of(known) == of(density))
    });
    html! {
        fieldset.body id={ "body-" (index) } {
            legend { (title) }
            select id=(id("shape")) name=(name("shape")) aria-label=(page::shape_of(&title, l)) data-chosen=(chosen) {
                option value="" selected[chosen.is_empty()] { @if row.is_some() { (page::without_body(l)) } @else { (page::further_body(l)) } }
                @for shape in &BODY_SHAPES { option value=(shape.name) selected[shape.name == chosen] { (capitalised(shape_title(shape, l))) } }
            }
            @if let Some(row) = row {
                @for (key, value) in row.values.iter().filter(|(key, _)| *key != "density" || material.is_none()) {
                    @if *key == "axis" {
                        label { span { (page::orientation(l)) } select id=(id(key)) name=(name(key)) data-chosen=(value) {
                            option value="" selected[value.is_empty()] { (page::lies_parallel(l)) }
                            option value="perpendicular" selected[value == "perpendicular"] { (page::lies_across(l)) }
                        } }
                    } @else {
                        @if *key == "mass" {
                            label { span { (page::material(l)) } select id=(id("material")) name=(name("material")) data-chosen=(material.map_or("", |(name, _)| name)) {
                                option value="" selected[material.is_none()] { (page::by_mass_or_density(l)) }
                                @for (place, (name, density)) in MATERIALS.iter().enumerate() {
                                    option value=(name) selected[material.is_some_and(|(of, _)| of == name)] { (if place == 0 { page::steel(l) } else { page::aluminium(l) }) ", " (density.replace("m^3", "m³")) }
                                }
                            } }
                        }
                        @if *key != "mass" || material.is_none() { label { span { (label(key, l)) } input id=(id(key)) name=(name(key)) type="text" value=(value) placeholder=(unit(key).replace("m^3", "m³").replace("deg", "°")) autocomplete="off" spellcheck="false"; } }
                    }
                }
            }
            @for trouble in troubles { (trouble.shown(l)) }
        }
    }
}

/// Returns the label of a key of a body; a sign stays small.
fn label(key: &str, language: Language) -> String {
    let label = body_key(key, language).unwrap_or(key);
    if label.chars().count() == 1 { label.to_owned() } else { capitalised(label) }
}

/// Returns a value of a line with a space before its unit, and with the decimal mark of the language.
fn spaced(value: &str, language: Language) -> String {
    let digits = value.chars().take_while(|sign| sign.is_ascii_digit() || matches!(sign, '.' | '-' | '+')).count();
    let (number, unit) = value.split_at_checked(digits).unwrap_or((value, ""));
    with_mark(if unit.is_empty() { number.to_owned() } else { format!("{number} {unit}") }.as_str(), language)
}

/// Returns the button that writes the result into the field.
fn fills(into: &str, found: &InertiaAnswer, language: Language) -> Markup {
    let l = language;
    let value = format!("{:.5e}", found.total.inertia.si()).parse::<f64>().unwrap_or_default();
    let value = format!("{value} kg m^2");
    html! {
        p.downloads { button.primary type="button" id="fill-inertia" data-shuts="" hx-post="/work" hx-target="#work" hx-swap="outerMorph"
            hx-include="#state, [form=state]" hx-vals=(vals(&[("do", &format!("value {into}={value}"))])) {
            (page::fill_field(&label_of(into, l).unwrap_or_default(), &said(&value, l), l))
        } }
    }
}

/// Returns the bodies to scale, seen along the axis of rotation.
fn drawing(found: &InertiaAnswer, language: Language) -> Markup {
    let reach = found.bodies.iter().map(|body| {
        let (wide, high, _) = outline(body);
        body.body.distance.si() + 0.5 * wide.hypot(high)
    });
    let reach = reach.fold(1e-3_f64, f64::max) * 1.08;
    let scale = 150.0 / reach;
    let pieces = |body: &BodyAnswer| {
        let step = 360.0 / f64::from(body.body.count.max(1));
        let first = body.body.angle.si().to_degrees();
        (0..body.body.count.min(60)).map(|piece| -(first + step * f64::from(piece))).collect::<Vec<f64>>()
    };
    html! {
        figure.sketch id="bodies-drawing" {
            svg viewBox="-156 -156 312 312" role="img" aria-label=(page::bodies_drawn(language)) {
                path.l-axis d="M-154 0H154M0 -154V154" {}
                @for body in &found.bodies {
                    @let (wide, high, round) = outline(body);
                    @let (w, h, r) = (wide * scale, high * scale, body.body.distance.si() * scale);
                    @for angle in pieces(body) {
                        g transform={ "rotate(" (round_to(angle)) ") translate(" (round_to(r)) " 0)" } {
                            @if round { circle.l-body cx="0" cy="0" r=(round_to(f64::max(0.5 * w, 1.5))) {} @if let Some(inner) = inner(body) { circle.l-hole cx="0" cy="0" r=(round_to(0.5 * inner * scale)) {} } }
                            @else { rect.l-body x=(round_to(-0.5 * w)) y=(round_to(-0.5 * h)) width=(round_to(f64::max(w, 1.0))) height=(round_to(f64::max(h, 1.0))) {} }
                        }
                    }
                }
                circle.l-mark cx="0" cy="0" r="2" {}
            }
        }
    }
}

fn round_to(value: f64) -> f64 {
    (100.0 * value).round() / 100.0
}

/// Returns width and height of the outline of a body \[m\], and `true` if it is round.
fn outline(body: &BodyAnswer) -> (f64, f64, bool) {
    use SolidShape::{Box, Cone, Cylinder, PointMass, Rod, Sphere, Tube};
    match body.body.shape {
        Cylinder { diameter, length, orientation } => {
            lying(diameter.si(), length.map_or(0.0, Measure::si), orientation)
        }
        Tube { outer, length, orientation, .. } => lying(outer.si(), length.map_or(0.0, Measure::si), orientation),
        Box { a, b, .. } => (a.si(), b.si(), false),
        Cone { diameter, .. } | Sphere { diameter } => (diameter.si(), diameter.si(), true),
        PointMass => (0.0, 0.0, true),
        Rod { length } => (length.si(), 0.0, false),
    }
}

const fn lying(diameter: f64, length: f64, orientation: BodyOrientation) -> (f64, f64, bool) {
    match orientation {
        BodyOrientation::Parallel => (diameter, diameter, true),
        BodyOrientation::Perpendicular => (length, diameter, false),
    }
}

/// Returns the inner diameter of a tube that stands parallel to the axis \[m\].
fn inner(body: &BodyAnswer) -> Option<f64> {
    match body.body.shape {
        SolidShape::Tube { inner, orientation: BodyOrientation::Parallel, .. } => Some(inner.si()),
        _ => None,
    }
}
