//! Maps of candidates: named points in classes.

use crate::item::{Item, Markers, Shape};
use crate::label::Label;
use crate::picture::Picture;
use crate::plane::Axis;
use crate::style::{Style, Tone};
use crate::xy::XyChart;

/// Named points over two axes, in classes that differ by marker and colour.
///
/// A name is drawn where it finds room, classes and points that come first before those that follow; all names are
/// tooltips, and [`Picture::hidden_labels`] has those that were not drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct MapChart {
    chart: XyChart,
    classes: usize,
}

impl MapChart {
    /// An empty map.
    #[must_use]
    pub fn new(x: Axis, y: Axis) -> Self {
        Self { chart: XyChart::new(x, y), classes: 0 }
    }

    /// Sets the title above the chart, which also names it to a screen reader.
    #[must_use]
    pub fn title(self, title: impl Into<Label>) -> Self {
        Self { chart: self.chart.title(title), ..self }
    }

    /// Sets the description for screen readers.
    #[must_use]
    pub fn description(self, text: &str) -> Self {
        Self { chart: self.chart.description(text), ..self }
    }

    /// Adds a class of points (x, y, name).
    #[must_use]
    pub fn class<L: Into<Label>>(
        mut self,
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
        let (shape, hollow) = SHAPES.get(self.classes % SHAPES.len()).copied().unwrap_or((Shape::Circle, false));
        let mut markers = Markers::new(places).names(names).label(name).tone(tone).shape(shape);
        if hollow {
            markers = markers.hollow();
        }
        self.classes += 1;
        Self { chart: self.chart.with(markers), ..self }
    }

    /// Adds an item beside the points, such as a reference line.
    #[must_use]
    pub fn with(self, item: impl Into<Item>) -> Self {
        Self { chart: self.chart.with(item), ..self }
    }

    /// Sets what stands in place of the plane if there is no point to be shown in it.
    #[must_use]
    pub fn nothing(self, text: impl Into<Label>) -> Self {
        Self { chart: self.chart.nothing(text), ..self }
    }

    /// Draws the map.
    #[must_use]
    pub fn render(&self, style: &Style) -> Picture {
        self.chart.render_as("map", style)
    }
}
