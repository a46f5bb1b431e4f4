//! Panels one above the other with a shared axis, usually of time.

use crate::canvas::{AXIS, Anchor, Canvas, HAIR, RULE, Setting, Stroke, TEXT};
use crate::chart_title::{title, title_height};
use crate::draw::{self, Labelled};
use crate::geometry::Rect;
use crate::item::{Item, Tags, lines_of};
use crate::label::Label;
use crate::legend::{self, LegendEntry, LegendRow};
use crate::picture::Picture;
use crate::place::OccupiedPlane;
use crate::plane::{EDGE, Plane, PlaneAxis, X_BELOW, x_ticks, y_margin, y_ticks};
use crate::style::{Colour, Style};
use crate::ticks::Ticks;
use crate::titled::titled;

/// Panels with one shared axis, and the borders of segments drawn through all of them.
#[derive(Clone, Debug, PartialEq)]
pub struct StackedChart {
    x: PlaneAxis,
    title: Label,
    description: String,
    segments: Vec<(f64, f64, Label)>,
    panels: Vec<Panel>,
}

impl StackedChart {
    /// Returns the shared axis of all panels, and every line with the axis of its panel, from top to bottom.
    #[must_use]
    pub fn lines(&self) -> (&PlaneAxis, Vec<(&PlaneAxis, &crate::Line)>) {
        let lines = self.panels.iter().flat_map(|panel| lines_of(&panel.items).map(|line| (&panel.y, line)));
        (&self.x, lines.collect())
    }
}

/// One panel: a y axis and its items. A limit is a [`Reference`](crate::Reference).
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    y: PlaneAxis,
    items: Vec<Item>,
    weight: f64,
}

impl Panel {
    /// Creates an empty panel.
    #[must_use]
    pub const fn new(y: PlaneAxis) -> Self {
        Self { y, items: Vec::new(), weight: 1.0 }
    }

    /// Sets the height of the plane of the panel as a multiple of the default.
    #[must_use]
    pub const fn weight(mut self, weight: f64) -> Self {
        self.weight = weight.max(1.0);
        self
    }

    /// Extends the range of the y axis by these values.
    #[must_use]
    pub fn including(mut self, (from, to): (f64, f64)) -> Self {
        self.y = self.y.including(from, to);
        self
    }

    /// Adds an item. Items with a label are explained next to the title of the panel; a vertical reference has its
    /// label at the line.
    #[must_use]
    pub fn with(mut self, item: impl Into<Item>) -> Self {
        self.items.push(item.into());
        self
    }
}

/// Least mean width of segments whose borders are drawn \[px\]: below, the lines would cover the curves.
const SEGMENT_LEAST: f64 = 3.0;

/// Height of the names of segments.
const SEGMENTS: f64 = 18.0;
/// Height of a line of title and legend above a panel.
const HEADER: f64 = 26.0;
/// Least height of a plane in which a course can be read.
const PANEL_MIN: f64 = 26.0;

struct Laid<'a> {
    plane: Plane,
    panel: &'a Panel,
    head: Head,
}

/// Title and legend of a panel: in one row, or one below the other in a narrow picture.
struct Head {
    entries: Vec<LegendEntry>,
    beside: bool,
}

impl Head {
    fn of(canvas: &mut Canvas<'_>, panel: &Panel) -> Self {
        let mut entries = legend::entries(canvas, &panel.items);
        entries.extend(legend::limits(&panel.items));
        // Ticks may take a power of ten out of the numbers, which is known only later: room for one.
        let title = panel.y.title(-3).width(AXIS, false);
        let room = canvas.style.size.width - 2.0 * EDGE - title - legend::COLUMN_GAP;
        let whole = legend::rows(&entries, f64::MAX);
        let beside = entries.is_empty() || whole.iter().all(|row| row.width() <= room);
        Self { entries, beside }
    }

    fn rows(&self, style: &Style) -> Vec<LegendRow<'_>> {
        let room = if self.beside { f64::MAX } else { style.size.width - 2.0 * EDGE };
        legend::rows(&self.entries, room)
    }

    fn title_room(&self, style: &Style) -> f64 {
        let legend: f64 =
            if self.beside { self.rows(style).iter().map(|row| row.width() + legend::COLUMN_GAP).sum() } else { 0.0 };
        style.size.width - 2.0 * EDGE - legend
    }

    fn height(&self, style: &Style) -> f64 {
        HEADER + if self.beside { 0.0 } else { legend::rows_height(&self.rows(style)) }
    }
}

impl StackedChart {
    /// Creates a chart without panels. The shared axis ends with data and segments.
    #[must_use]
    pub fn new(x: PlaneAxis) -> Self {
        Self {
            x: x.tight(),
            title: Label::default(),
            description: String::new(),
            segments: Vec::new(),
            panels: Vec::new(),
        }
    }

    titled!();

    /// Adds a segment of the shared axis.
    #[must_use]
    pub fn segment(mut self, from: f64, to: f64, name: impl Into<Label>) -> Self {
        if from.is_finite() && to.is_finite() {
            self.segments.push((from.min(to), from.max(to), name.into()));
        }
        self
    }

    /// Adds a panel below the others.
    #[must_use]
    pub fn panel(mut self, panel: Panel) -> Self {
        self.panels.push(panel);
        self
    }

    /// Draws the chart, higher than its style says if the panels need it.
    #[must_use]
    pub fn render(&self, style: &Style) -> Picture {
        let style = &self.grown(style);
        let mut canvas = Canvas::new(style);
        let laid = self.layout(&mut canvas);
        title(&mut canvas, &self.title);
        self.draw_segments(&mut canvas, &laid);
        for (index, part) in laid.iter().enumerate() {
            let Laid { plane, panel, head } = part;
            let mut field = OccupiedPlane::new(plane.area);
            draw::stamp(&mut field, plane, &panel.items);
            for x in self.borders_in(plane) {
                field.line(&[(x, plane.area.top), (x, plane.area.bottom)]);
            }
            let places = draw::reference_places(plane, &panel.items, Labelled::Vertical, &mut field);
            canvas.open_plane("plane panel", &plane.area, plane.range(), panel.y.sign());
            plane.grid(&mut canvas);
            let labels: Vec<Rect> = places.iter().flatten().map(|(area, _)| area.grown(1.0)).collect();
            self.draw_borders(&mut canvas, plane, &labels);
            draw::areas(&mut canvas, plane, &panel.items);
            plane.y_axis(&mut canvas, &panel.y);
            if index + 1 == laid.len() {
                plane.x_axis(&mut canvas, &self.x);
            } else {
                let (left, right, bottom) = (plane.area.left, plane.area.right, plane.area.bottom);
                canvas.line((left, bottom), (right, bottom), &Stroke::solid(Colour::Soft, HAIR));
            }
            draw::lines(&mut canvas, plane, &panel.items);
            draw::reference_labels(&mut canvas, &panel.items, Labelled::Vertical, &places);
            draw::texts(&mut canvas, plane, &panel.items, &mut field);
            canvas.close();
            let below = if head.beside { 0.0 } else { legend::rows_height(&head.rows(style)) };
            plane.y_title(&mut canvas, &panel.y, head.title_room(style), plane.area.top - 8.0 - below);
            let rows = head.rows(style);
            if head.beside {
                let left = plane.area.right - rows.iter().map(LegendRow::width).fold(0.0, f64::max);
                legend::draw_rows(&mut canvas, &rows, (left, plane.area.top - legend::ROW - 4.0));
            } else if !rows.is_empty() {
                legend::draw_rows(&mut canvas, &rows, (EDGE, plane.area.top - below - 4.0));
            }
        }
        if let Some(last) = laid.last() {
            last.plane.x_title(&mut canvas, &self.x);
        }
        canvas.finish("stacked", &self.title.plain(), &self.description)
    }

    /// Returns the style with the height that the panels need.
    fn grown(&self, style: &Style) -> Style {
        let mut style = style.clone();
        let scratch = style.clone();
        let mut canvas = Canvas::new(&scratch);
        let heads: f64 = self.panels.iter().map(|panel| Head::of(&mut canvas, panel).height(&scratch)).sum();
        let panels = heads + PANEL_MIN * self.weight();
        let least = 2.0 * EDGE + title_height(&canvas, &self.title) + self.segment_row() + panels + X_BELOW;
        style.size.height = style.size.height.max(least);
        style
    }

    /// Returns the height of all planes as a multiple of the default.
    fn weight(&self) -> f64 {
        self.panels.iter().map(|panel| panel.weight).sum()
    }

    const fn segment_row(&self) -> f64 {
        if self.segments.is_empty() { 0.0 } else { SEGMENTS }
    }

    fn layout(&self, canvas: &mut Canvas<'_>) -> Vec<Laid<'_>> {
        let size = canvas.style.size;
        let top = EDGE + title_height(canvas, &self.title) + self.segment_row();
        let bottom = size.height - EDGE / 2.0 - X_BELOW;
        let mut xs: Vec<f64> = self.segments.iter().flat_map(|(from, to, _)| [*from, *to]).collect();
        let style = canvas.style;
        let heads: Vec<Head> = self.panels.iter().map(|panel| Head::of(canvas, panel)).collect();
        // Titles and legends take what they need; the planes share the rest.
        let rest = bottom - top - heads.iter().map(|head| head.height(style)).sum::<f64>();
        let one = rest / self.weight().max(1.0);
        let mut parts: Vec<(&Panel, Ticks, Head)> = Vec::new();
        for (panel, head) in self.panels.iter().zip(heads) {
            let (x, y): (Vec<Vec<f64>>, Vec<Vec<f64>>) = panel.items.iter().map(Item::reach).unzip();
            xs.extend(x.concat());
            let ticks = y_ticks(panel.y.span(&y.concat(), false), one * panel.weight);
            parts.push((panel, ticks, head));
        }
        let left = parts.iter().map(|(_, ticks, _)| y_margin(canvas, ticks)).fold(0.0, f64::max).min(size.width / 2.0);
        let (x, right) = x_ticks(canvas, self.x.span(&xs, false), left, size.width - EDGE - 4.0);
        let mut y = top;
        let mut laid = Vec::new();
        for (panel, ticks, head) in parts {
            let area =
                Rect { left, right, top: y + head.height(style), bottom: y + head.height(style) + one * panel.weight };
            y = area.bottom;
            laid.push(Laid { plane: Plane { area, x: x.clone(), y: ticks }, panel, head });
        }
        laid
    }

    /// Returns the borders of the segments, without repetition.
    fn borders(&self) -> Vec<f64> {
        let mut borders: Vec<f64> = self.segments.iter().flat_map(|(from, to, _)| [*from, *to]).collect();
        borders.sort_by(f64::total_cmp);
        borders.dedup();
        borders
    }

    /// Returns true if the segments within a plane are wide enough, on average, to be seen one by one.
    fn are_segments_seen(&self, plane: &Plane) -> bool {
        let inside = self.segments.iter().filter(|(from, to, _)| *to > plane.x.lo && *from < plane.x.hi).count();
        inside as f64 * SEGMENT_LEAST <= plane.area.right - plane.area.left
    }

    /// Returns the borders within a plane \[px\]; none if they would stand too close to each other.
    fn borders_in(&self, plane: &Plane) -> Vec<f64> {
        if !self.are_segments_seen(plane) {
            return Vec::new();
        }
        let inside = self.borders().into_iter().filter(|x| *x > plane.x.lo && *x < plane.x.hi);
        inside.map(|x| plane.x_at(x)).collect()
    }

    /// Draws the borders of segments, interrupted at labels.
    fn draw_borders(&self, canvas: &mut Canvas<'_>, plane: &Plane, labels: &[Rect]) {
        let pen = Stroke { colour: Colour::Soft, width: HAIR, dash: "3 2" };
        for x in self.borders_in(plane) {
            let mut crossed: Vec<&Rect> = labels.iter().filter(|label| label.left < x && x < label.right).collect();
            crossed.sort_by(|a, b| a.top.total_cmp(&b.top));
            let mut top = plane.area.top - 2.0;
            for label in crossed {
                if label.top > top {
                    canvas.line((x, top), (x, label.top), &pen);
                }
                top = top.max(label.bottom);
            }
            if plane.area.bottom > top {
                canvas.line((x, top), (x, plane.area.bottom), &pen);
            }
        }
    }

    /// Writes the names of the segments above the first panel, with brackets over their extent.
    fn draw_segments(&self, canvas: &mut Canvas<'_>, laid: &[Laid<'_>]) {
        let Some(first) = laid.first().filter(|first| self.are_segments_seen(&first.plane)) else { return };
        let plane = &first.plane;
        let base = plane.area.top - first.head.height(canvas.style);
        let mut until = f64::NEG_INFINITY;
        for (from, to, name) in &self.segments {
            let (from, to) = (plane.x_at(*from), plane.x_at(*to));
            let (from, to) = (from.max(plane.area.left), to.min(plane.area.right));
            if to <= from {
                continue;
            }
            canvas.open_item("segment", &Tags::default(), name, 0);
            let rule = Stroke::solid(Colour::Soft, RULE);
            canvas.line((from + 1.0, base), (to - 1.0, base), &rule);
            let room = to - from.max(until) - 4.0;
            // A name without room is shortened to its first word, which still distinguishes segments.
            let fits = name.width(TEXT, false) <= room;
            let short = if fits { name.clone() } else { name.first_word().elided(room, TEXT, false) };
            // Of overlapping segments, only the free part is named.
            if short.is_empty() || from < until {
                canvas.hide(name);
            } else {
                let middle = f64::midpoint(from, to);
                canvas.text((middle, base - 5.0), &short, Setting::new(TEXT, Colour::Soft, Anchor::Middle));
                until = to;
            }
            canvas.close();
        }
    }
}
