//! Charts of one plane: curves, areas and points over two axes, and maps of candidates.

use crate::canvas::{AXIS, Anchor, Canvas, Fill, RULE, Setting, Stroke};
use crate::chart_title::{TITLE_ROW, title, title_height};
use crate::draw::{self, Labelled};
use crate::geometry::Rect;
use crate::item::{Item, Markers, Shape, lines_of};
use crate::label::Label;
use crate::legend::{self, LegendEntry};
use crate::picture::Picture;
use crate::place::OccupiedPlane;
use crate::plane::{EDGE, Plane, PlaneAxis, X_BELOW, Y_ABOVE, x_ticks, y_margin, y_ticks};
use crate::style::{Colour, Style, Tone};
use crate::titled::titled;

/// A chart of curves, areas and points over two axes.
///
/// ```
/// use plot::{Line, PlaneAxis, Size, Style, Tone, XyChart};
/// let picture = XyChart::new(PlaneAxis::new("n", "min⁻¹"), PlaneAxis::new("T", "Nm"))
///     .title("Limits")
///     .with(Line::new([(0.0, 9.0), (3000.0, 9.0), (4500.0, 0.0)]).tone(Tone::Continuous).label("continuous"))
///     .render(&Style::new(Size::millimetres(120.0, 80.0)));
/// assert!(picture.svg().starts_with("<svg"));
/// assert_eq!(picture.dropped(), 0);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct XyChart {
    pub(crate) x: PlaneAxis,
    pub(crate) y: PlaneAxis,
    pub(crate) title: Label,
    pub(crate) description: String,
    pub(crate) four_quadrant: bool,
    pub(crate) items: Vec<Item>,
    pub(crate) nothing: Label,
    /// Class of the picture.
    kind: &'static str,
}

impl XyChart {
    /// Returns both axes, and every line with the axis of its values.
    #[must_use]
    pub fn lines(&self) -> (&PlaneAxis, Vec<(&PlaneAxis, &crate::Line)>) {
        (&self.x, lines_of(&self.items).map(|line| (&self.y, line)).collect())
    }

    /// Creates an empty chart.
    #[must_use]
    pub fn new(x: PlaneAxis, y: PlaneAxis) -> Self {
        Self {
            x,
            y,
            title: Label::default(),
            description: String::new(),
            four_quadrant: false,
            items: Vec::new(),
            nothing: Label::default(),
            kind: "xy",
        }
    }

    /// Creates an empty map of candidates: named points in classes that differ by marker and colour.
    ///
    /// A name is drawn if there is room, earlier classes and points first; all names are tooltips, and
    /// [`Picture::hidden_labels`] has those that are not drawn.
    #[must_use]
    pub fn map(x: PlaneAxis, y: PlaneAxis) -> Self {
        Self { kind: "map", ..Self::new(x, y) }
    }

    titled!();

    /// Shows both signs of both quantities, with axes through zero.
    #[must_use]
    pub const fn four_quadrant(mut self) -> Self {
        self.four_quadrant = true;
        self
    }

    /// Sets the text in place of the plane if there is no point to show in it.
    #[must_use]
    pub fn nothing(mut self, text: impl Into<Label>) -> Self {
        self.nothing = text.into();
        self
    }

    /// Adds an item. Areas are drawn first, then references, lines, markers and notes, each kind in its order.
    #[must_use]
    pub fn with(mut self, item: impl Into<Item>) -> Self {
        self.items.push(item.into());
        self
    }

    /// Adds items.
    #[must_use]
    pub fn with_all<I: Into<Item>>(mut self, items: impl IntoIterator<Item = I>) -> Self {
        self.items.extend(items.into_iter().map(Into::into));
        self
    }

    /// Adds a class of points (x, y, name), with the next marker after those of the earlier classes.
    #[must_use]
    pub fn class<L: Into<Label>>(
        self,
        name: impl Into<Label>,
        tone: Tone,
        points: impl IntoIterator<Item = (f64, f64, L)>,
    ) -> Self {
        const SHAPES: [(Shape, bool); 8] = [
            (Shape::Circle, false),
            (Shape::Diamond, true),
            (Shape::Square, false),
            (Shape::Triangle, true),
            (Shape::Cross, false),
            (Shape::Circle, true),
            (Shape::Diamond, false),
            (Shape::Square, true),
        ];
        let (places, names): (Vec<(f64, f64)>, Vec<Label>) =
            points.into_iter().map(|(x, y, name)| ((x, y), name.into())).unzip();
        let before = self.items.iter().filter(|item| matches!(item, Item::Markers(_))).count();
        let (shape, hollow) = SHAPES.get(before % SHAPES.len()).copied().unwrap_or((Shape::Circle, false));
        let markers = Markers::new(places).names(names).label(name).tone(tone).shape(shape);
        self.with(if hollow { markers.hollow() } else { markers })
    }

    /// Sets the subjects of the points of the class added last.
    #[must_use]
    pub fn subjects(mut self, subjects: impl IntoIterator<Item = String>) -> Self {
        if let Some(Item::Markers(markers)) = self.items.last_mut() {
            markers.subjects = subjects.into_iter().collect();
        }
        self
    }

    /// Draws the chart, higher than its style states if title and legend leave no room for the plane.
    #[must_use]
    pub fn render(&self, style: &Style) -> Picture {
        if !self.nothing.is_empty() && !self.items.iter().any(has_points) {
            return self.say_nothing(style);
        }
        let style = &self.grown(style);
        let mut canvas = Canvas::new(style);
        let entries = legend::entries(&mut canvas, &self.items);
        let mut plane = self.layout(&canvas, &[]);
        let mut field = self.field(&plane);
        let corner = if entries.is_empty() { None } else { legend_corner(&field, &plane.area, &entries) };
        if let Some(area) = &corner {
            field.text(area.grown(2.0));
        } else if !entries.is_empty() {
            plane = self.layout(&canvas, &entries);
            field = self.field(&plane);
        }
        let top = title(&mut canvas, &self.title);
        debug_assert!(top <= plane.area.top, "the title is above the plane");
        canvas.open_plane("plane", &plane.area, plane.range(), self.y.sign());
        plane.grid(&mut canvas);
        if self.four_quadrant {
            canvas.rect(&plane.area, 0.0, &Fill::None, Some(&Stroke::solid(Colour::Grid, RULE)));
        }
        draw::areas(&mut canvas, &plane, &self.items);
        plane.y_axis(&mut canvas, &self.y);
        plane.x_axis(&mut canvas, &self.x);
        if plane.x.lo < 0.0 && plane.x.hi > 0.0 {
            let zero = plane.x_at(0.0);
            canvas.line((zero, plane.area.top), (zero, plane.area.bottom), &Stroke::solid(Colour::Ink, RULE));
        }
        draw::lines(&mut canvas, &plane, &self.items);
        if let Some(area) = &corner {
            legend::column(&mut canvas, &entries, area);
        }
        let places = draw::reference_places(&plane, &self.items, Labelled::All, &mut field);
        draw::reference_labels(&mut canvas, &self.items, Labelled::All, &places);
        draw::texts(&mut canvas, &plane, &self.items, &mut field);
        canvas.close();
        plane.y_title(&mut canvas, &self.y, style.size.width - 2.0 * EDGE, plane.area.top - 8.0);
        plane.x_title(&mut canvas, &self.x);
        if corner.is_none() && !entries.is_empty() {
            let rows = legend::rows(&entries, style.size.width - 2.0 * EDGE);
            legend::draw_rows(&mut canvas, &rows, (EDGE, plane.area.bottom + X_BELOW + 4.0));
        }
        canvas.finish(self.kind, &self.title.plain(), &self.description)
    }

    /// Draws the sentence in place of a plane without a point.
    fn say_nothing(&self, style: &Style) -> Picture {
        let mut style = style.clone();
        let lines = self.nothing.wrapped(style.size.width - 2.0 * EDGE, AXIS, false);
        let text: f64 = lines.iter().map(|_| TITLE_ROW).sum();
        let above = EDGE + title_height(&Canvas::new(&style), &self.title);
        style.size.height = above + text + 2.0 * EDGE;
        let mut canvas = Canvas::new(&style);
        title(&mut canvas, &self.title);
        let mut base = above + TITLE_ROW * 0.7;
        for line in &lines {
            canvas.text((EDGE, base), line, Setting::new(AXIS, Colour::Ink, Anchor::Start));
            base += TITLE_ROW;
        }
        canvas.finish(self.kind, &self.title.plain(), &self.description)
    }

    /// Returns the style with the height that a plane with title and legend needs.
    fn grown(&self, style: &Style) -> Style {
        let mut grown = style.clone();
        let mut canvas = Canvas::new(style);
        let entries = legend::entries(&mut canvas, &self.items);
        let (above, below) = (self.above(&canvas), below(&canvas, &entries));
        let [one, both] = PLANE_MIN;
        let least = if self.four_quadrant { both } else { one };
        grown.size.height = grown.size.height.max(above + least + below);
        grown
    }

    fn above(&self, canvas: &Canvas<'_>) -> f64 {
        EDGE + title_height(canvas, &self.title) + Y_ABOVE
    }

    /// Returns the plane above the legend of these entries.
    fn layout(&self, canvas: &Canvas<'_>, entries: &[LegendEntry]) -> Plane {
        let size = canvas.style.size;
        let top = self.above(canvas);
        let bottom = size.height - below(canvas, entries);
        let (xs, ys): (Vec<Vec<f64>>, Vec<Vec<f64>>) = self.items.iter().map(Item::reach).unzip();
        let y = y_ticks(self.y.span(&ys.concat(), self.four_quadrant), bottom - top);
        let left = y_margin(canvas, &y).min(size.width / 2.0);
        let right = size.width - EDGE - 4.0;
        let (x, right) = x_ticks(canvas, self.x.span(&xs.concat(), self.four_quadrant), left, right);
        Plane { area: Rect { left, right, top, bottom }, x, y }
    }

    /// Returns the field with the drawn items, so that text can avoid them.
    fn field(&self, plane: &Plane) -> OccupiedPlane {
        let mut field = OccupiedPlane::new(plane.area);
        draw::stamp(&mut field, plane, &self.items);
        if self.four_quadrant {
            let (x, y) = (plane.x_at(0.0), plane.y_at(0.0));
            field.line(&[(x, plane.area.top), (x, plane.area.bottom)]);
            field.line(&[(plane.area.left, y), (plane.area.right, y)]);
        }
        field
    }
}

/// Returns `true` if an item has a point of its own; a line across the plane and a note have none.
fn has_points(item: &Item) -> bool {
    !matches!(item, Item::Reference(_) | Item::Note(_)) && !item.reach().0.is_empty()
}

/// Returns the height of axis and legend below a plane.
fn below(canvas: &Canvas<'_>, entries: &[LegendEntry]) -> f64 {
    let rows = legend::rows(entries, canvas.style.size.width - 2.0 * EDGE);
    let legend = legend::rows_height(&rows);
    X_BELOW + EDGE / 2.0 + if legend > 0.0 { legend + 4.0 } else { 0.0 }
}

/// Smallest height of a plane, and of one with both signs of both quantities.
const PLANE_MIN: [f64; 2] = [60.0, 180.0];

/// Returns a corner, or else the middle of the upper or lower edge, into which a legend fits without covering anything.
fn legend_corner(field: &OccupiedPlane, area: &Rect, entries: &[LegendEntry]) -> Option<Rect> {
    let (width, height) = legend::column_size(entries);
    if width > area.width() * 0.6 || height > area.height() * 0.6 {
        return None;
    }
    let gap = 8.0;
    let (left, right) = (area.left + gap, area.right - gap - width);
    let (top, bottom) = (area.top + gap, area.bottom - gap - height);
    let middle = area.middle().0 - width / 2.0;
    let corners = [(right, top), (left, top), (right, bottom), (left, bottom), (middle, top), (middle, bottom)];
    let boxes = corners.map(|(left, top)| Rect { left, right: left + width, top, bottom: top + height });
    field.best(boxes).filter(|(_, cost)| *cost == 0.0).map(|(area, _)| area)
}
