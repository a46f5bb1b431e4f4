//! Title above a chart.

use crate::canvas::{Anchor, Canvas, Setting, TITLE};
use crate::label::Label;
use crate::plane::EDGE;
use crate::style::Colour;

/// Height of a line of a title.
pub(crate) const TITLE_ROW: f64 = 19.0;

fn title_lines(canvas: &Canvas<'_>, title: &Label) -> Vec<Label> {
    title.wrapped(canvas.style.size.width - 2.0 * EDGE, TITLE, true)
}

/// Returns the height of a title above the chart.
pub(crate) fn title_height(canvas: &Canvas<'_>, title: &Label) -> f64 {
    let lines: f64 = title_lines(canvas, title).iter().map(|_| TITLE_ROW).sum();
    if lines > 0.0 { lines + 6.0 } else { 0.0 }
}

/// Draws the title; returns its lower end.
pub(crate) fn title(canvas: &mut Canvas<'_>, title: &Label) -> f64 {
    let mut y = EDGE;
    for line in title_lines(canvas, title) {
        canvas.text((EDGE, y + TITLE * 0.85), &line, Setting::new(TITLE, Colour::Ink, Anchor::Start).bold());
        y += TITLE_ROW;
    }
    y
}
