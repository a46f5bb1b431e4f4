//! What a chart becomes.

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

/// A text of a picture and the box that it takes, in px.
#[derive(Clone, Debug, PartialEq)]
pub struct TextBox {
    /// The box.
    pub area: Rect,
    /// The text without setting.
    pub text: String,
}

impl Picture {
    /// The picture as an SVG document, which is also an element to put into a page.
    #[must_use]
    pub fn svg(&self) -> &str {
        &self.svg
    }

    /// The picture as an SVG document.
    #[must_use]
    pub fn into_svg(self) -> String {
        self.svg
    }

    /// Width and height in CSS pixels.
    #[must_use]
    pub const fn pixels(&self) -> (f64, f64) {
        (self.width, self.height)
    }

    /// Points that were no finite numbers and are not in the picture. Lines have a gap there.
    #[must_use]
    pub const fn dropped(&self) -> usize {
        self.dropped
    }

    /// Labels that found no place free of other text and are not in the picture, in their order.
    #[must_use]
    pub fn hidden_labels(&self) -> &[String] {
        &self.hidden
    }

    /// Every text with its box, in the order drawn.
    #[must_use]
    pub fn texts(&self) -> &[TextBox] {
        &self.texts
    }
}
