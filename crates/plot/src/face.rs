//! Mating face of a connector: pins with their numbers in a round insert, and a list of their signals.

use crate::canvas::{Anchor, Canvas, Fill, RULE, Setting, Stroke, TEXT};
use crate::chart_title::{title, title_height};
use crate::font::CAP_HEIGHT;
use crate::geometry::Point;
use crate::item::{Tags, tagged};
use crate::label::Label;
use crate::number::number;
use crate::picture::Picture;
use crate::plane::EDGE;
use crate::style::{Colour, Style, Tone};
use crate::titled::titled;

/// A round face with pins, and a list of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FaceChart {
    title: Label,
    description: String,
    note: Label,
    pins: Vec<FacePin>,
}

/// A pin of the face.
#[derive(Clone, Debug, PartialEq)]
pub struct FacePin {
    number: Label,
    text: Label,
    at: (f64, f64),
    tone: Option<Tone>,
    tags: Tags,
}
tagged!(FacePin);

impl FacePin {
    /// Creates a pin at a point of the unit circle, x to the right and y downwards, with no connection.
    #[must_use]
    pub fn new(number: impl Into<Label>, at: (f64, f64)) -> Self {
        Self { number: number.into(), text: Label::default(), at, tone: None, tags: Tags::default() }
    }

    /// Sets the signal of the pin in the list.
    #[must_use]
    pub fn text(mut self, text: impl Into<Label>) -> Self {
        self.text = text.into();
        self
    }

    /// Fills the pin as connected.
    #[must_use]
    pub const fn tone(mut self, tone: Tone) -> Self {
        self.tone = Some(tone);
        self
    }
}

/// Height of a row of the list.
const ROW: f64 = 15.0;
/// Height of a line of the note.
const NOTE_ROW: f64 = 14.0;
/// Radius of the insert as a share of that of the shell.
const INSERT: f64 = 0.9;
/// Radius of a pin as a share of that of the face, for seventeen pins.
const PIN: f64 = 0.125;
/// Largest share of the width for the face.
const FACE_SHARE: f64 = 0.5;

impl FaceChart {
    titled!();

    /// Sets the text below the face.
    #[must_use]
    pub fn note(mut self, text: impl Into<Label>) -> Self {
        self.note = text.into();
        self
    }

    /// Adds a pin.
    #[must_use]
    pub fn pin(mut self, pin: FacePin) -> Self {
        self.pins.push(pin);
        self
    }

    /// Draws the face, higher than its style says if the list needs it.
    #[must_use]
    pub fn render(&self, style: &Style) -> Picture {
        let mut style = style.clone();
        let head = EDGE + title_height(&Canvas::new(&style), &self.title) + 4.0;
        let note = self.note.wrapped(style.size.width - 2.0 * EDGE, TEXT, false);
        let foot = EDGE + note.iter().map(|_| NOTE_ROW).sum::<f64>();
        let rows: f64 = self.pins.iter().map(|_| ROW).sum();
        style.size.height = style.size.height.max(head + rows + foot + EDGE);
        let style = &style;
        let mut canvas = Canvas::new(style);
        title(&mut canvas, &self.title);
        let room = style.size.height - head - foot;
        let radius = (room / 2.0).min(style.size.width * FACE_SHARE / 2.0 - EDGE).max(20.0);
        let centre = (EDGE + radius, head + room / 2.0);
        canvas.open("face");
        canvas.path(&circle(centre, radius), &Fill::None, Some(&Stroke::solid(Colour::Ink, 2.0 * RULE)));
        canvas.path(&circle(centre, radius * INSERT), &Fill::None, Some(&Stroke::solid(Colour::Soft, RULE)));
        for pin in &self.pins {
            pin.draw(&mut canvas, centre, radius);
        }
        canvas.close();
        let left = centre.0 + radius + 2.0 * EDGE;
        let widest = self.pins.iter().map(|pin| pin.number.width(TEXT, true)).fold(0.0, f64::max);
        let mut base = head + (room - rows) / 2.0 + ROW * 0.75;
        canvas.open("pins");
        for pin in &self.pins {
            canvas.text((left + widest, base), &pin.number, Setting::new(TEXT, Colour::Ink, Anchor::End).bold());
            let text = left + widest + EDGE;
            let label = pin.text.elided(style.size.width - EDGE - text, TEXT, false);
            let colour = if pin.tone.is_some() { Colour::Ink } else { Colour::Soft };
            canvas.text((text, base), &label, Setting::new(TEXT, colour, Anchor::Start));
            base += ROW;
        }
        canvas.close();
        let mut base = style.size.height - foot + NOTE_ROW;
        for line in &note {
            canvas.text((EDGE, base), line, Setting::new(TEXT, Colour::Soft, Anchor::Start));
            base += NOTE_ROW;
        }
        canvas.finish("face", &self.title.plain(), &self.description)
    }
}

impl FacePin {
    fn draw(&self, canvas: &mut Canvas<'_>, centre: Point, radius: f64) {
        let scale = radius * (INSERT - PIN - 0.05);
        let at = (self.at.0.mul_add(scale, centre.0), self.at.1.mul_add(scale, centre.1));
        canvas.open_item("pin", &self.tags, &self.text, 0);
        let (fill, stroke) = match self.tone {
            Some(tone) => (Fill::Flat(Colour::Tone(tone), 0.18), Stroke::solid(Colour::Tone(tone), 1.6 * RULE)),
            None => (Fill::None, Stroke { colour: Colour::Soft, width: RULE, dash: "3 2" }),
        };
        canvas.path(&circle(at, radius * PIN), &fill, Some(&stroke));
        let base = TEXT.mul_add(CAP_HEIGHT / 2.0, at.1);
        canvas.text((at.0, base), &self.number, Setting::new(TEXT, Colour::Ink, Anchor::Middle));
        canvas.close();
    }
}

/// Returns a circle as a path.
fn circle(centre: Point, radius: f64) -> String {
    let (left, right) = (number(centre.0 - radius), number(centre.0 + radius));
    let (y, r) = (number(centre.1), number(radius));
    format!("M{left} {y}A{r} {r} 0 1 1 {right} {y}A{r} {r} 0 1 1 {left} {y}Z")
}
