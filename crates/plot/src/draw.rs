//! Drawing of the items of a plane.

use crate::canvas::{Anchor, Canvas, Fill, HAIR, Setting, Stroke, TEXT};
use crate::font::{ASCENT, DESCENT};
use crate::geometry::{Point, Rect};
use crate::item::{Area, At, Item, Line, Markers, Note, Reference, Tags, is_data, lines_of, pieces};
use crate::label::Label;
use crate::legend::{MARKER, draw_marker, fill, rule, stroke};
use crate::place::{Near, OccupiedPlane};
use crate::plane::Plane;
use crate::reduce::{line_path, outline_path, reduced, without_repeats};
use crate::style::Colour;

/// Number of points above which markers are thinned to one per half pixel and have no data attributes.
const MARKERS_MAX: usize = 2000;
/// Placement of a name, which is left to the tooltip if it would overlap something; a note is always drawn.
const NAME: Near = Near { gap: MARKER + 1.5, reach: 60.0, worst: 60.0 };
const NOTE: Near = Near { gap: 6.5, reach: 110.0, worst: f64::INFINITY };
/// Distance between a reference line and its label: more than a cell of the field, or the line would block its own
/// label.
const CLEAR: f64 = 4.6;

/// Draws the areas, which lie below the axes.
pub(crate) fn areas(canvas: &mut Canvas<'_>, plane: &Plane, items: &[Item]) {
    for item in items {
        if let Item::Area(area) = item {
            draw_area(canvas, plane, area);
        }
    }
}

/// Draws references and lines, which lie above the axes, and markers on top.
pub(crate) fn lines(canvas: &mut Canvas<'_>, plane: &Plane, items: &[Item]) {
    for reference in references(items) {
        draw_reference(canvas, plane, reference);
    }
    for line in lines_of(items) {
        draw_line(canvas, plane, line);
    }
    for item in items {
        if let Item::Markers(markers) = item {
            draw_markers(canvas, plane, markers);
        }
    }
}

/// Writes notes and names of points where there is room.
pub(crate) fn texts(canvas: &mut Canvas<'_>, plane: &Plane, items: &[Item], field: &mut OccupiedPlane) {
    for item in items {
        if let Item::Note(note) = item {
            draw_note(canvas, plane, note, field);
        }
    }
    for item in items {
        if let Item::Markers(markers) = item {
            for (point, name) in markers.points.iter().zip(&markers.names) {
                if is_data(*point) {
                    write_near(canvas, plane, *point, name, field, NAME, Colour::Ink);
                }
            }
        }
    }
}

/// Marks the drawn items in the field.
pub(crate) fn stamp(field: &mut OccupiedPlane, plane: &Plane, items: &[Item]) {
    for item in items {
        match item {
            Item::Line(line) => {
                for piece in line_pieces(plane, line).0 {
                    field.line(&piece);
                }
            }
            Item::Area(area) => {
                let (pieces, _) = pieces(&area.outline);
                let mut outline: Vec<Point> = pieces.concat().iter().map(|point| plane.at(*point)).collect();
                outline.extend(outline.first().copied());
                field.line(&reduced(&outline));
            }
            Item::Markers(markers) => {
                for point in markers.points.iter().filter(|point| is_data(**point)) {
                    let at = plane.at(*point);
                    if plane.area.grown(MARKER).cut(at, at).is_some() {
                        field.marker(at, MARKER);
                    }
                }
            }
            Item::Reference(reference) => field.line(&ends(plane, reference)),
            Item::Note(_) => {}
        }
    }
}

fn line_pieces(plane: &Plane, line: &Line) -> (Vec<Vec<Point>>, usize) {
    let (mut parts, dropped) = pieces(&line.points);
    // A closed line with a gap is drawn open.
    if line.closed
        && let [only] = parts.as_mut_slice()
    {
        only.extend(only.first().copied());
    }
    let drawn = parts.into_iter().flat_map(|piece| {
        without_repeats(reduced(&piece.into_iter().map(|point| plane.at(point)).collect::<Vec<_>>()))
    });
    (drawn.collect(), dropped)
}

fn draw_line(canvas: &mut Canvas<'_>, plane: &Plane, line: &Line) {
    let (pieces, dropped) = line_pieces(plane, line);
    canvas.open_item("line", &line.tags, &line.label, dropped);
    let stroke = stroke(line);
    let mut d = String::new();
    for piece in &pieces {
        match piece.as_slice() {
            // A single point has no length and would be invisible as a line.
            [only] if plane.area.cut(*only, *only).is_some() => {
                draw_marker(canvas, crate::item::Shape::Circle, *only, stroke.colour, false);
            }
            more => d.push_str(&line_path(more, &plane.area)),
        }
    }
    canvas.path(&d, &Fill::None, Some(&stroke));
    canvas.close();
}

fn draw_area(canvas: &mut Canvas<'_>, plane: &Plane, area: &Area) {
    let (pieces, dropped) = pieces(&area.outline);
    canvas.open_item("area", &area.tags, &area.label, dropped);
    let outline: Vec<Point> = pieces.concat().iter().map(|point| plane.at(*point)).collect();
    let d = outline_path(&reduced(&outline), &plane.area);
    let fill = fill(canvas, area);
    if area.hatch.is_some() {
        canvas.path(&d, &Fill::Flat(Colour::Tone(area.tone), 0.06), None);
    }
    canvas.path(&d, &fill, None);
    canvas.close();
}

fn draw_markers(canvas: &mut Canvas<'_>, plane: &Plane, markers: &Markers) {
    let dropped = markers.points.iter().filter(|point| !is_data(**point)).count();
    canvas.open_item("markers", &markers.tags, &markers.label, dropped);
    let many = markers.points.len() > MARKERS_MAX;
    let mut seen = std::collections::BTreeSet::new();
    for (index, point) in markers.points.iter().enumerate().filter(|(_, point)| is_data(**point)) {
        let at = plane.at(*point);
        if plane.area.grown(0.01).cut(at, at).is_none() {
            continue;
        }
        if many {
            #[expect(clippy::cast_possible_truncation, reason = "a place within the picture")]
            let place = ((at.0 * 2.0) as i32, (at.1 * 2.0) as i32);
            if seen.insert(place) {
                draw_marker(canvas, markers.shape, at, Colour::Tone(markers.tone), markers.hollow);
            }
            continue;
        }
        let mut tags = Tags::default();
        tags.set("x", &format!("{}", point.0));
        tags.set("y", &format!("{}", point.1));
        if let Some(subject) = markers.subjects.get(index) {
            tags.set("of", subject);
        }
        let name = markers.names.get(index).cloned().unwrap_or_default();
        canvas.open_item("marker", &tags, &name, 0);
        draw_marker(canvas, markers.shape, at, Colour::Tone(markers.tone), markers.hollow);
        canvas.close();
    }
    canvas.close();
}

fn ends(plane: &Plane, reference: &Reference) -> [Point; 2] {
    let area = &plane.area;
    match reference.at {
        At::X(x) => [(plane.x_at(x), area.top), (plane.x_at(x), area.bottom)],
        At::Y(y) => [(area.left, plane.y_at(y)), (area.right, plane.y_at(y))],
    }
}

fn draw_reference(canvas: &mut Canvas<'_>, plane: &Plane, reference: &Reference) {
    let value = match reference.at {
        At::X(value) | At::Y(value) => value,
    };
    let data = is_data((value, 0.0));
    canvas.open_item("reference", &reference.tags, &reference.label, usize::from(!data));
    let [from, to] = ends(plane, reference);
    if data && let Some((from, to)) = plane.area.cut(from, to) {
        canvas.line(from, to, &rule(reference));
    }
    canvas.close();
}

/// References whose labels are drawn at them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Labelled {
    /// Every one.
    All,
    /// Vertical ones only; the legend explains the others.
    Vertical,
}

impl Labelled {
    fn of(self, items: &[Item]) -> impl Iterator<Item = &Reference> {
        references(items).filter(move |reference| self == Self::All || matches!(reference.at, At::X(_)))
    }
}

/// Returns the place of the label of each reference, taken from the field; `None` without a label or without room.
pub(crate) fn reference_places(
    plane: &Plane,
    items: &[Item],
    labelled: Labelled,
    field: &mut OccupiedPlane,
) -> Vec<Option<(Rect, Label)>> {
    labelled.of(items).map(|reference| reference_place(plane, reference, field)).collect()
}

fn references(items: &[Item]) -> impl Iterator<Item = &Reference> {
    items.iter().filter_map(|item| match item {
        Item::Reference(reference) => Some(reference),
        Item::Line(_) | Item::Area(_) | Item::Markers(_) | Item::Note(_) => None,
    })
}

fn reference_place(plane: &Plane, reference: &Reference, field: &mut OccupiedPlane) -> Option<(Rect, Label)> {
    let [from, to] = ends(plane, reference);
    if reference.label.is_empty() || plane.area.cut(from, to).is_none() || !from.0.is_finite() || !from.1.is_finite() {
        return None;
    }
    let label = reference.label.elided(plane.area.width() - 8.0, TEXT, false);
    let (width, height) = (label.width(TEXT, false), TEXT * (ASCENT + DESCENT));
    let box_at = |left: f64, top: f64| Rect { left, right: left + width, top, bottom: top + height };
    let area = plane.area;
    let shares = (0..=24_u8).map(|step| f64::from(step) / 24.0);
    let boxes: Vec<Rect> = match reference.at {
        At::Y(_) => shares
            .flat_map(|share| {
                let left = (area.right - 4.0 - width) - share * (area.width() - width - 8.0);
                [box_at(left, from.1 - CLEAR - height), box_at(left, from.1 + CLEAR)]
            })
            .collect(),
        At::X(_) => shares
            .flat_map(|share| {
                let top = area.top + 4.0 + share * (area.height() - height - 8.0);
                [box_at(from.0 + CLEAR, top), box_at(from.0 - CLEAR - width, top)]
            })
            .collect(),
    };
    let (area, _) = field.best(boxes)?;
    field.text(area);
    Some((area, label))
}

/// Writes the labels of references at the places of [`reference_places`].
pub(crate) fn reference_labels(
    canvas: &mut Canvas<'_>,
    items: &[Item],
    labelled: Labelled,
    places: &[Option<(Rect, Label)>],
) {
    for (reference, place) in labelled.of(items).zip(places) {
        match place {
            Some((area, label)) => write_in(canvas, area, label, Colour::Tone(reference.tone)),
            None if reference.label.is_empty() => {}
            None => canvas.hide(&reference.label),
        }
    }
}

fn draw_note(canvas: &mut Canvas<'_>, plane: &Plane, note: &Note, field: &mut OccupiedPlane) {
    canvas.open_item("note", &note.tags, &note.label, usize::from(!is_data(note.at)));
    if is_data(note.at) {
        write_near(canvas, plane, note.at, &note.label, field, NOTE, Colour::Tone(note.tone));
    }
    canvas.close();
}

/// Writes a text near a point, with a leader if it is at a distance.
fn write_near(
    canvas: &mut Canvas<'_>,
    plane: &Plane,
    point: Point,
    label: &Label,
    field: &mut OccupiedPlane,
    near: Near,
    colour: Colour,
) {
    let at = plane.at(point);
    if label.is_empty() || plane.area.grown(0.01).cut(at, at).is_none() {
        return;
    }
    let full = label;
    let label = full.elided(plane.area.width() * 0.7, TEXT, false);
    let (width, height) = (label.width(TEXT, false), TEXT * (ASCENT + DESCENT));
    let Some(place) = field.place_near(at, (width, height), near) else {
        canvas.hide(full);
        return;
    };
    if let Some(end) = place.leader {
        let length = (end.0 - at.0).hypot(end.1 - at.1).max(1e-9);
        // The leader starts outside its marker and ends before the text.
        let along = |px: f64| ((end.0 - at.0).mul_add(px / length, at.0), (end.1 - at.1).mul_add(px / length, at.1));
        canvas.line(along(near.gap - 1.0), along((length - 1.0).max(near.gap)), &Stroke::solid(Colour::Soft, HAIR));
    }
    write_in(canvas, &place.area, &label, colour);
}

fn write_in(canvas: &mut Canvas<'_>, area: &Rect, label: &Label, colour: Colour) {
    let setting = Setting::new(TEXT, colour, Anchor::Start).halo();
    canvas.text((area.left, TEXT.mul_add(ASCENT, area.top)), label, setting);
}
