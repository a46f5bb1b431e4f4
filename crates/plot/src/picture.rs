//! The result of drawing a chart.

use crate::geometry::Rect;

/// A drawn chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    pub(crate) svg: String,
    pub(crate) width: f64,
    pub(crate) height: f64,
    pub(crate) dropped: usize,
    pub(crate) hidden: Vec<String>,
    pub(crate) texts: Vec<TextBox>,
}

/// A text of a picture with its box \[px\].
#[derive(Clone, Debug, PartialEq)]
pub struct TextBox {
    /// Box.
    pub area: Rect,
    /// Text without formatting.
    pub text: String,
}

impl Picture {
    /// Returns the picture as an SVG document, which can be embedded in a page as an element.
    #[must_use]
    pub fn svg(&self) -> &str {
        &self.svg
    }

    /// Converts the picture to an SVG document.
    #[must_use]
    pub fn into_svg(self) -> String {
        self.svg
    }

    /// Returns width and height in CSS pixels.
    #[must_use]
    pub const fn pixels(&self) -> (f64, f64) {
        (self.width, self.height)
    }

    /// Returns the number of non-finite points, which are not in the picture. Lines have a gap there.
    #[must_use]
    pub const fn dropped(&self) -> usize {
        self.dropped
    }

    /// Returns the labels that found no free place and are not in the picture, in their order.
    #[must_use]
    pub fn hidden_labels(&self) -> &[String] {
        &self.hidden
    }

    /// Returns every text with its box, in the order drawn.
    #[must_use]
    pub fn texts(&self) -> &[TextBox] {
        &self.texts
    }
}
