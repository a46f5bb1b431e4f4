//! A principle drawing as plain data, for page, pictures and report alike.
//!
//! Lengths are those of the sheet, 380 wide and 190 high, x to the right and y down.

mod svg;

use std::f64::consts::FRAC_PI_2;

/// A point of the sheet.
pub type Point = [f64; 2];

/// How a part is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// The actuator and what does not move with the load.
    Housing,
    /// What moves.
    Body,
    /// A visible edge.
    Line,
    /// A thin edge, a dimension line.
    Thin,
    /// What is hidden, or a second course.
    Hidden,
    /// An axis of rotation or symmetry.
    Axis,
    /// What moves along or acts, with a head at its end.
    Arrow,
    /// A dimension, with a head at either end.
    Dimension,
    /// A hole or a pin.
    Hole,
}

/// A piece of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// A new piece begins here.
    Move(Point),
    /// Straight to here.
    Line(Point),
    /// Along a circle of a radius to here, turning right if `true`, the short way round.
    Arc(f64, bool, Point),
    /// A cubic curve by two points beside it to here.
    Curve(Point, Point, Point),
    /// Back to the beginning of the piece.
    Close,
}

/// A part of the drawing.
#[derive(Clone, Debug, PartialEq)]
pub enum Part {
    /// A circle: centre and radius.
    Circle(Look, Point, f64),
    /// Lines and arcs.
    Path(Look, Vec<Step>),
    /// The sign for a centre of mass.
    Centre(Point),
    /// A symbol that stands for no key: its middle.
    Symbol(&'static str, Point),
}

/// A key of the project where it can be seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CallOut {
    /// The key, in the table of the mechanism.
    pub key: &'static str,
    /// Its symbol; what follows `_` is its index.
    pub symbol: &'static str,
    /// What it points at.
    pub at: Point,
    /// The middle of the symbol.
    pub label: Point,
}

/// A drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Width and height of the sheet.
    pub size: Point,
    /// From back to front.
    pub parts: Vec<Part>,
    /// The keys it shows.
    pub call_outs: Vec<CallOut>,
    /// Whether the mechanism has a line that can be inclined.
    has_line: bool,
}

/// Beyond so steep a line the drawing stands upright.
const UPRIGHT_FROM_RAD: f64 = 0.5 * FRAC_PI_2;

impl Drawing {
    /// An empty sheet.
    pub(crate) const fn new() -> Self {
        Self { size: [380.0, 190.0], parts: Vec::new(), call_outs: Vec::new(), has_line: false }
    }

    /// With a line along which something moves to the right: an inclination turns it.
    pub(crate) const fn along_a_line(mut self) -> Self {
        self.has_line = true;
        self
    }

    /// As it stands under an inclination of its line \[rad\]: one nearer to the vertical than to the level is drawn
    /// upright, with the positive direction upwards or downwards, and gravity beside it.
    #[must_use]
    pub fn inclined(self, inclination_rad: f64) -> Self {
        let sine = inclination_rad.sin();
        if !self.has_line || sine.abs() <= UPRIGHT_FROM_RAD.sin() {
            return self;
        }
        let [width, height] = self.size;
        let up = sine > 0.0;
        let turn = |[x, y]: Point| if up { [y, width - x] } else { [height - y, x] };
        let step = |step: Step| match step {
            Step::Move(to) => Step::Move(turn(to)),
            Step::Line(to) => Step::Line(turn(to)),
            Step::Arc(radius, right, to) => Step::Arc(radius, right, turn(to)),
            Step::Curve(a, b, to) => Step::Curve(turn(a), turn(b), turn(to)),
            Step::Close => Step::Close,
        };
        let part = |part: Part| match part {
            Part::Circle(look, at, radius) => Part::Circle(look, turn(at), radius),
            Part::Path(look, steps) => Part::Path(look, steps.into_iter().map(step).collect()),
            Part::Centre(at) => Part::Centre(turn(at)),
            Part::Symbol(text, at) => Part::Symbol(text, turn(at)),
        };
        let call_outs = self.call_outs.into_iter();
        let turned = Self {
            size: [height, width],
            parts: self.parts.into_iter().map(part).collect(),
            call_outs: call_outs.map(|it| CallOut { at: turn(it.at), label: turn(it.label), ..it }).collect(),
            has_line: false,
        };
        turned.arrow([14.0, 16.0], [14.0, 50.0]).symbol("g", [26.0, 38.0])
    }

    fn with(mut self, part: Part) -> Self {
        self.parts.push(part);
        self
    }

    pub(crate) fn path(self, look: Look, steps: impl IntoIterator<Item = Step>) -> Self {
        self.with(Part::Path(look, steps.into_iter().collect()))
    }

    pub(crate) fn line(self, look: Look, from: Point, to: Point) -> Self {
        self.path(look, [Step::Move(from), Step::Line(to)])
    }

    /// A closed outline.
    pub(crate) fn outline(self, look: Look, points: &[Point]) -> Self {
        let steps = points.iter().enumerate().map(|(k, at)| if k == 0 { Step::Move(*at) } else { Step::Line(*at) });
        self.path(look, steps.chain([Step::Close]))
    }

    pub(crate) fn rect(self, look: Look, [x, y]: Point, [w, h]: Point) -> Self {
        self.outline(look, &[[x, y], [x + w, y], [x + w, y + h], [x, y + h]])
    }

    pub(crate) fn circle(self, look: Look, at: Point, radius: f64) -> Self {
        self.with(Part::Circle(look, at, radius))
    }

    pub(crate) fn arrow(self, from: Point, to: Point) -> Self {
        self.line(Look::Arrow, from, to)
    }

    /// An arrow along a circle, turning right if `right`.
    pub(crate) fn turning(self, from: Point, radius: f64, right: bool, to: Point) -> Self {
        self.path(Look::Arrow, [Step::Move(from), Step::Arc(radius, right, to)])
    }

    pub(crate) fn dimension(self, from: Point, to: Point) -> Self {
        self.line(Look::Dimension, from, to)
    }

    pub(crate) fn centre(self, at: Point) -> Self {
        self.with(Part::Centre(at))
    }

    pub(crate) fn symbol(self, text: &'static str, at: Point) -> Self {
        self.with(Part::Symbol(text, at))
    }

    /// A bar with round ends between two pins.
    pub(crate) fn bar(self, [ax, ay]: Point, [bx, by]: Point, half: f64) -> Self {
        let (dx, dy) = (bx - ax, by - ay);
        let length = dx.hypot(dy).max(f64::MIN_POSITIVE);
        let (nx, ny) = (-dy / length * half, dx / length * half);
        let steps = [
            Step::Move([ax + nx, ay + ny]),
            Step::Arc(half, true, [ax - nx, ay - ny]),
            Step::Line([bx - nx, by - ny]),
            Step::Arc(half, true, [bx + nx, by + ny]),
            Step::Close,
        ];
        self.path(Look::Body, steps).circle(Look::Hole, [ax, ay], 0.55 * half).circle(Look::Hole, [bx, by], 0.55 * half)
    }

    /// A support: a line to the right with its hatching below.
    pub(crate) fn ground(mut self, [x, y]: Point, width: f64) -> Self {
        self = self.line(Look::Line, [x, y], [x + width, y]);
        let mut hatching = Vec::new();
        let mut at = x + 6.0;
        while at <= x + width {
            hatching.extend([Step::Move([at, y]), Step::Line([at - 6.0, y + 6.0])]);
            at += 8.0;
        }
        self.path(Look::Thin, hatching)
    }

    /// A support seen from below: a line to the right with its hatching above.
    pub(crate) fn ground_above(mut self, [x, y]: Point, width: f64) -> Self {
        self = self.line(Look::Line, [x, y], [x + width, y]);
        let mut hatching = Vec::new();
        let mut at = x;
        while at + 6.0 <= x + width {
            hatching.extend([Step::Move([at, y]), Step::Line([at + 6.0, y - 6.0])]);
            at += 8.0;
        }
        self.path(Look::Thin, hatching)
    }

    /// Turns of a rope on a drum, from the upper left, with width and inclination of the strokes.
    pub(crate) fn rope(mut self, [x, y]: Point, [height, lean]: Point) -> Self {
        for turn in 0..6 {
            let at = x + 5.0 * f64::from(turn);
            self = self.line(Look::Thin, [at, y], [at + lean, y + height]);
        }
        self
    }

    /// A fixed pivot: a triangle on a support.
    pub(crate) fn pivot(self, [x, y]: Point) -> Self {
        self.outline(Look::Housing, &[[x, y], [x + 12.0, y + 20.0], [x - 12.0, y + 20.0]])
            .ground([x - 18.0, y + 20.0], 36.0)
    }

    /// The actuator from the side, its flange 78 to the right of `x`, its axis at `y`.
    pub(crate) fn actuator(mut self, [x, y]: Point) -> Self {
        self = self
            .rect(Look::Housing, [x, y - 36.0], [58.0, 72.0])
            .rect(Look::Housing, [x + 58.0, y - 44.0], [10.0, 88.0])
            .rect(Look::Housing, [x + 68.0, y - 27.0], [10.0, 54.0]);
        for offset in [-9.0, 9.0] {
            self = self.line(Look::Hidden, [x, y + offset], [x + 78.0, y + offset]);
        }
        self
    }

    /// The actuator along its axis.
    pub(crate) fn face(self, at: Point, radius: f64) -> Self {
        self.circle(Look::Housing, at, radius).circle(Look::Hidden, at, radius * 0.72).circle(
            Look::Hole,
            at,
            radius * 0.3,
        )
    }

    /// A slide on a line, with its nut or clamp below.
    pub(crate) fn slide(self, [x, y]: Point) -> Self {
        self.rect(Look::Body, [x, y], [84.0, 36.0]).centre([x + 42.0, y + 18.0])
    }

    pub(crate) fn calls(mut self, key: &'static str, symbol: &'static str, at: Point, label: Point) -> Self {
        self.call_outs.push(CallOut { key, symbol, at, label });
        self
    }
}
