//! Legends: a sample of each item with its label.

use crate::canvas::{Anchor, Canvas, Fill, HAIR, Setting, Stroke, TEXT};
use crate::font::CAP_HEIGHT;
use crate::geometry::{Point, Rect};
use crate::item::{Area, At, Item, Line, Reference, Shape};
use crate::label::Label;
use crate::style::Colour;

pub(crate) struct LegendEntry {
    pub(crate) label: Label,
    pub(crate) sample: LegendSample,
}

#[derive(Clone, Debug)]
pub(crate) enum LegendSample {
    Line(Stroke),
    Patch(Fill, Stroke),
    Marker(Shape, Colour, bool),
}

const SAMPLE: f64 = 24.0;
const SAMPLE_GAP: f64 = 6.0;
pub(crate) const COLUMN_GAP: f64 = 18.0;
/// Line spacing of a legend.
pub(crate) const ROW: f64 = 16.0;
const PAD: f64 = 6.0;
/// Tolerance for widths added in another order, which differ in the last digit.
const ROUNDING: f64 = 1e-6;

/// Returns the entries of items whose label is not drawn at the item.
pub(crate) fn entries(canvas: &mut Canvas<'_>, items: &[Item]) -> Vec<LegendEntry> {
    let mut entries: Vec<LegendEntry> = Vec::new();
    for item in items {
        let (label, sample) = match item {
            Item::Line(line) => (&line.label, LegendSample::Line(stroke(line))),
            Item::Area(area) => {
                (&area.label, LegendSample::Patch(fill(canvas, area), Stroke::solid(Colour::Tone(area.tone), HAIR)))
            }
            Item::Markers(markers) => {
                let sample = LegendSample::Marker(markers.shape, Colour::Tone(markers.tone), markers.hollow);
                (&markers.label, sample)
            }
            Item::Reference(_) | Item::Note(_) => continue,
        };
        // Pieces of one curve have the same label, which is explained once.
        if !label.is_empty() && !entries.iter().any(|entry| entry.label == *label) {
            entries.push(LegendEntry { label: label.clone(), sample });
        }
    }
    entries
}

/// Returns the entries of the horizontal references, for planes too low for a label between their curves.
pub(crate) fn limits(items: &[Item]) -> impl Iterator<Item = LegendEntry> {
    let references = items.iter().filter_map(|item| match item {
        Item::Reference(reference) => Some(reference),
        Item::Line(_) | Item::Area(_) | Item::Markers(_) | Item::Note(_) => None,
    });
    let named = references.filter(|reference| matches!(reference.at, At::Y(_)) && !reference.label.is_empty());
    named.map(|reference| LegendEntry { label: reference.label.clone(), sample: LegendSample::Line(rule(reference)) })
}

/// Returns the stroke of a reference.
pub(crate) const fn rule(reference: &Reference) -> Stroke {
    Stroke { colour: Colour::Tone(reference.tone), width: 1.1, dash: reference.dash.pattern() }
}

pub(crate) const fn stroke(line: &Line) -> Stroke {
    Stroke { colour: Colour::Tone(line.tone), width: line.width.pixels(), dash: line.pattern() }
}

pub(crate) fn fill(canvas: &mut Canvas<'_>, area: &Area) -> Fill {
    match area.hatch {
        Some(hatch) => canvas.hatch(Colour::Tone(area.tone), hatch),
        None => Fill::Flat(Colour::Tone(area.tone), 0.16),
    }
}

/// Returns the size of the entries one below the other.
pub(crate) fn column_size(entries: &[LegendEntry]) -> (f64, f64) {
    let widest = entries.iter().map(|entry| entry.label.width(TEXT, false)).fold(0.0, f64::max);
    (2.0_f64.mul_add(PAD, SAMPLE + SAMPLE_GAP + widest), entries.iter().map(|_| ROW).sum::<f64>() + 2.0 * PAD - 3.0)
}

/// Draws the entries one below the other into a box of [`column_size`].
pub(crate) fn column(canvas: &mut Canvas<'_>, entries: &[LegendEntry], area: &Rect) {
    canvas.open("legend");
    canvas.rect(area, 2.0, &Fill::Flat(Colour::Paper, 0.9), Some(&Stroke::solid(Colour::Grid, HAIR)));
    let mut y = area.top + PAD + ROW / 2.0 - 1.5;
    for entry in entries {
        draw(canvas, entry, (area.left + PAD, y), std::slice::from_ref(&entry.label));
        y += ROW;
    }
    canvas.close();
}

/// A row of a legend: several entries, or one whose label takes several lines.
pub(crate) struct LegendRow<'a> {
    entries: Vec<(&'a LegendEntry, f64, Vec<Label>)>,
}

impl LegendRow<'_> {
    pub(crate) fn height(&self) -> f64 {
        self.entries.iter().map(|(.., lines)| lines.iter().map(|_| ROW).sum::<f64>()).fold(ROW, f64::max)
    }

    pub(crate) fn width(&self) -> f64 {
        self.entries.iter().map(|(_, width, _)| width + COLUMN_GAP).sum::<f64>() - COLUMN_GAP
    }
}

/// Arranges the entries in rows of a width; a label too long for one line is broken, never shortened.
pub(crate) fn rows(entries: &[LegendEntry], width: f64) -> Vec<LegendRow<'_>> {
    let mut rows: Vec<LegendRow<'_>> = Vec::new();
    let mut taken = f64::INFINITY;
    for entry in entries {
        let room = width - SAMPLE - SAMPLE_GAP + ROUNDING;
        let lines = entry.label.wrapped(room, TEXT, false);
        let widest = lines.iter().map(|line| line.width(TEXT, false)).fold(0.0, f64::max);
        let wide = SAMPLE + SAMPLE_GAP + widest;
        if taken + COLUMN_GAP + wide > width {
            rows.push(LegendRow { entries: Vec::new() });
            taken = wide;
        } else {
            taken += COLUMN_GAP + wide;
        }
        if let Some(row) = rows.last_mut() {
            row.entries.push((entry, wide, lines));
        }
    }
    rows
}

/// Returns the height of the rows.
pub(crate) fn rows_height(rows: &[LegendRow<'_>]) -> f64 {
    rows.iter().map(LegendRow::height).sum()
}

/// Draws rows from a left end and an upper end downwards.
pub(crate) fn draw_rows(canvas: &mut Canvas<'_>, rows: &[LegendRow<'_>], (left, top): Point) {
    canvas.open("legend");
    let mut y = top + ROW / 2.0;
    for row in rows {
        let mut x = left;
        for (entry, width, lines) in &row.entries {
            draw(canvas, entry, (x, y), lines);
            x += width + COLUMN_GAP;
        }
        y += row.height();
    }
    canvas.close();
}

/// Draws one entry with the middle of its first line at a height.
fn draw(canvas: &mut Canvas<'_>, entry: &LegendEntry, (x, y): Point, lines: &[Label]) {
    match &entry.sample {
        LegendSample::Line(stroke) => canvas.line((x, y), (x + SAMPLE, y), stroke),
        LegendSample::Patch(fill, stroke) => {
            let area = Rect { left: x, right: x + SAMPLE, top: y - 5.0, bottom: y + 5.0 };
            canvas.rect(&area, 0.0, fill, Some(stroke));
        }
        LegendSample::Marker(shape, colour, hollow) => {
            draw_marker(canvas, *shape, (x + SAMPLE / 2.0, y), *colour, *hollow)
        }
    }
    let mut base = TEXT.mul_add(CAP_HEIGHT / 2.0, y);
    for line in lines {
        canvas.text((x + SAMPLE + SAMPLE_GAP, base), line, Setting::new(TEXT, Colour::Ink, Anchor::Start));
        base += ROW;
    }
}

/// Radius of a marker.
pub(crate) const MARKER: f64 = 3.4;
/// Radius of a ring around another marker.
const RING: f64 = 6.8;

/// Draws a marker.
pub(crate) fn draw_marker(canvas: &mut Canvas<'_>, shape: Shape, (x, y): Point, colour: Colour, hollow: bool) {
    use crate::number::number;
    let polygon = |corners: &[(f64, f64)]| {
        let mut d = String::new();
        for (index, (dx, dy)) in corners.iter().enumerate() {
            let command = if index == 0 { 'M' } else { 'L' };
            d.push_str(&format!("{command}{} {}", number(dx.mul_add(MARKER, x)), number(dy.mul_add(MARKER, y))));
        }
        d + "Z"
    };
    let d = match shape {
        Shape::Circle => {
            let r = number(MARKER);
            let across = number(2.0 * MARKER);
            format!("M{} {}a{r} {r} 0 1 0 {across} 0a{r} {r} 0 1 0 -{across} 0Z", number(x - MARKER), number(y))
        }
        Shape::Ring => {
            let r = number(RING);
            let across = number(2.0 * RING);
            format!("M{} {}a{r} {r} 0 1 0 {across} 0a{r} {r} 0 1 0 -{across} 0Z", number(x - RING), number(y))
        }
        Shape::Diamond => polygon(&[(0.0, -1.3), (1.3, 0.0), (0.0, 1.3), (-1.3, 0.0)]),
        Shape::Square => polygon(&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)]),
        Shape::Triangle => polygon(&[(0.0, -1.25), (1.15, 0.8), (-1.15, 0.8)]),
        Shape::Cross => {
            let (l, r, t, b) = (number(x - MARKER), number(x + MARKER), number(y - MARKER), number(y + MARKER));
            format!("M{l} {t}L{r} {b}M{l} {b}L{r} {t}")
        }
    };
    if matches!(shape, Shape::Ring | Shape::Cross) {
        canvas.path(&d, &Fill::None, Some(&Stroke::solid(colour, 1.6)));
    } else if hollow {
        canvas.path(&d, &Fill::Flat(Colour::Paper, 1.0), Some(&Stroke::solid(colour, 1.3)));
    } else {
        canvas.path(&d, &Fill::Flat(colour, 1.0), Some(&Stroke::solid(Colour::Paper, HAIR)));
    }
}
