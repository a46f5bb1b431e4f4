//! Principle drawings as plain data, used by page, pictures and report.
//!
//! Lengths are in units of the sheet, 380 wide and 190 high, x to the right and y downwards.

mod figures;
mod moving;
mod svg;
#[cfg(test)]
mod tests;

pub use figures::MechanismValues;
pub(crate) use moving::GroupAngles;
pub use moving::{Beyond, Moving, Placement};

use std::f64::consts::FRAC_PI_2;

/// A point of the sheet.
pub type SheetPoint = [f64; 2];

/// Line style and fill of a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// The actuator and other parts at rest.
    Housing,
    /// Moving parts.
    Body,
    /// A visible edge.
    Line,
    /// A thin edge, a dimension line.
    Thin,
    /// Hidden edges, or a second curve.
    Hidden,
    /// An axis of rotation or symmetry.
    Axis,
    /// Motions, forces and torques, with an arrow head at the end.
    Arrow,
    /// A dimension with an arrow head at each end.
    Dimension,
    /// A hole or a pin.
    Hole,
}

/// A segment of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// Beginning of a new subpath.
    Move(SheetPoint),
    /// Straight line to a point.
    Line(SheetPoint),
    /// Arc of a radius to a point, turning right if `true`, the shorter way.
    Arc(f64, bool, SheetPoint),
    /// Cubic curve with two control points to a point.
    Curve(SheetPoint, SheetPoint, SheetPoint),
    /// Line back to the beginning of the subpath.
    Close,
}

/// A part of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub enum DrawingPart {
    /// Circle with centre and radius.
    Circle(Look, SheetPoint, f64),
    /// Path of lines and arcs.
    Path(Look, Vec<Step>),
    /// Symbol for a centre of mass.
    Centre(SheetPoint),
    /// Symbol without a key, at its centre.
    Symbol(&'static str, SheetPoint),
    /// Parts that move together, with the index of their group in [`Drawing::moving`].
    Group(usize, Vec<DrawingPart>),
}

impl Step {
    /// Returns the end of the step.
    const fn end(self) -> Option<SheetPoint> {
        match self {
            Self::Move(to) | Self::Line(to) | Self::Arc(_, _, to) | Self::Curve(_, _, to) => Some(to),
            Self::Close => None,
        }
    }

    fn map(&mut self, change: impl Fn(SheetPoint) -> SheetPoint) {
        match self {
            Self::Move(to) | Self::Line(to) | Self::Arc(_, _, to) => *to = change(*to),
            Self::Curve(a, b, to) => (*a, *b, *to) = (change(*a), change(*b), change(*to)),
            Self::Close => {}
        }
    }
}

impl DrawingPart {
    fn map(&mut self, change: impl Fn(SheetPoint) -> SheetPoint + Copy) {
        match self {
            Self::Circle(_, at, _) | Self::Centre(at) | Self::Symbol(_, at) => *at = change(*at),
            Self::Path(_, steps) => steps.iter_mut().for_each(|step| step.map(change)),
            Self::Group(_, parts) => parts.iter_mut().for_each(|part| part.map(change)),
        }
    }

    /// Passes the extreme points of the part to `take`.
    fn corners(&self, take: &mut impl FnMut(SheetPoint)) {
        match self {
            Self::Circle(_, [x, y], radius) => {
                for (dx, dy) in [(-1.0, 0.0), (1.0, 0.0), (0.0, -1.0), (0.0, 1.0)] {
                    take([x + dx * radius, y + dy * radius]);
                }
            }
            Self::Path(_, steps) => steps.iter().filter_map(|step| step.end()).for_each(take),
            Self::Centre(at) | Self::Symbol(_, at) => take(*at),
            Self::Group(_, parts) => {
                for part in parts {
                    part.corners(take);
                }
            }
        }
    }
}

/// Returns the point at a distance and an angle from another one, counter-clockwise from the right.
pub(crate) fn polar([x, y]: SheetPoint, radius: f64, angle_rad: f64) -> SheetPoint {
    [x + radius * angle_rad.cos(), y - radius * angle_rad.sin()]
}

/// Iterates over straight lines from point to point.
pub(crate) fn polyline(points: &[SheetPoint]) -> impl Iterator<Item = Step> {
    points.iter().enumerate().map(|(k, at)| if k == 0 { Step::Move(*at) } else { Step::Line(*at) })
}

/// Marking of a key of the project in the drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CallOut {
    /// Key within its table.
    pub key: &'static str,
    /// The key belongs to the table `[bearing]`; otherwise to that of the mechanism.
    pub is_of_bearing: bool,
    /// Symbol of the key; the part after `_` is a subscript.
    pub symbol: &'static str,
    /// End of the leader.
    pub at: SheetPoint,
    /// Centre of the symbol.
    pub label: SheetPoint,
    /// Moving group to which the leader points, if any.
    pub group: Option<usize>,
}

/// A principle drawing with its call-outs and moving groups.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Width and height of the sheet.
    pub size: SheetPoint,
    /// Parts from back to front.
    pub parts: Vec<DrawingPart>,
    /// Call-outs of the keys.
    pub call_outs: Vec<CallOut>,
    /// Moving groups.
    pub moving: Vec<Moving>,
    /// Counter-clockwise rotation of the finished drawing \[rad\].
    lean_rad: f64,
}

/// Space required by a symbol on either side of its centre.
const LABEL: SheetPoint = [11.0, 8.0];

/// Margin of a sheet adapted to its content.
const EDGE: f64 = 6.0;

impl Drawing {
    /// Creates an empty sheet.
    pub(crate) const fn new() -> Self {
        Self { size: [380.0, 190.0], parts: Vec::new(), call_outs: Vec::new(), moving: Vec::new(), lean_rad: 0.0 }
    }

    /// Sets the rotation of the whole drawing, counter-clockwise: the inclination of a line, or the negative tilt of an
    /// axis \[rad\].
    pub(crate) const fn leaning(mut self, lean_rad: f64) -> Self {
        self.lean_rad = lean_rad;
        self
    }

    /// Sets the rotation of the whole drawing to the inclination of a line along which something moves to the right.
    pub(crate) fn along_a_line(self, figures: &MechanismValues) -> Self {
        self.leaning(figures.of("inclination").unwrap_or(0.0))
    }

    /// Adds a moving group, with the call-outs that point to it.
    pub(crate) fn moves(
        mut self,
        course: &GroupAngles,
        about: SheetPoint,
        place: impl Fn(f64) -> Placement,
        draw: impl FnOnce(Self) -> Self,
    ) -> Self {
        let (group, calls) = (self.moving.len(), self.call_outs.len());
        let around = std::mem::take(&mut self.parts);
        self.moving.push(Moving::of(course, about, place));
        self = draw(self);
        let own = std::mem::replace(&mut self.parts, around);
        self.parts.push(DrawingPart::Group(group, own));
        for call_out in self.call_outs.iter_mut().skip(calls) {
            call_out.group = Some(group);
        }
        self
    }

    /// Adds a group that turns with the output, counter-clockwise for a positive rate.
    pub(crate) fn turns(self, start_rad: f64, about: SheetPoint, rate: f64, draw: impl FnOnce(Self) -> Self) -> Self {
        self.moves(&GroupAngles::even(start_rad), about, |angle| Placement::turned(rate * (angle - start_rad)), draw)
    }

    /// Returns the drawing as shown: rotated, with the overhang if stated, on a sheet that includes the motion.
    pub(crate) fn finished(mut self, figures: &MechanismValues) -> Self {
        let lean = self.lean_rad;
        if lean != 0.0 {
            let (sine, cosine) = lean.sin_cos();
            let vector = |[x, y]: SheetPoint| [cosine * x + sine * y, cosine * y - sine * x];
            self.map(vector);
            for moving in &mut self.moving {
                for (_, placement) in &mut moving.rows {
                    placement.shift = vector(placement.shift);
                }
            }
        }
        self.cut(figures, lean != 0.0);
        if let Some(overhang) = figures.of("overhang") {
            self = self.overhang(overhang);
        }
        if lean != 0.0 {
            self = self.gravity();
        }
        self.keep_apart();
        self
    }

    /// Moves all points.
    fn map(&mut self, change: impl Fn(SheetPoint) -> SheetPoint + Copy) {
        for part in &mut self.parts {
            part.map(change);
        }
        for call_out in &mut self.call_outs {
            (call_out.at, call_out.label) = (change(call_out.at), change(call_out.label));
        }
        for moving in &mut self.moving {
            moving.about = change(moving.about);
        }
    }

    /// Adapts the sheet to its content over the whole motion; unless `to_size`, it is only enlarged.
    fn cut(&mut self, figures: &MechanismValues, to_size: bool) {
        let [width, height] = self.size;
        let start = if to_size { [[f64::MAX; 2], [f64::MIN; 2]] } else { [[EDGE; 2], [width - EDGE, height - EDGE]] };
        let mut bounds = start;
        let mut take = |[x, y]: SheetPoint| {
            let [[left, top], [right, bottom]] = bounds;
            bounds = [[left.min(x), top.min(y)], [right.max(x), bottom.max(y)]];
        };
        for part in &self.parts {
            part.corners(&mut take);
            let DrawingPart::Group(group, _) = part else { continue };
            let (Some(moving), Some([from, to])) = (self.moving.get(*group), figures.motion_rad()) else { continue };
            for step in 0..=60 {
                let placement = moving.at(from + f64::from(step) / 60.0 * (to - from));
                part.corners(&mut |at| take(moving.point(placement, at)));
            }
        }
        for call_out in &self.call_outs {
            let [x, y] = call_out.label;
            take([x - LABEL[0], y - LABEL[1]]);
            take([x + LABEL[0], y + LABEL[1]]);
        }
        if bounds == start {
            return;
        }
        let [[left, top], [right, bottom]] = bounds;
        self.map(|[x, y]| [x - left + EDGE, y - top + EDGE]);
        self.size = [(right - left + 2.0 * EDGE).ceil(), (bottom - top + 2.0 * EDGE).ceil()];
    }

    /// Adds the direction of gravity beside a rotated drawing.
    fn gravity(mut self) -> Self {
        let [width, _] = self.size;
        self.size[0] += 24.0;
        self.arrow([width + 4.0, 12.0], [width + 4.0, 46.0]).symbol("g", [width + 15.0, 30.0])
    }

    /// Adds a side view of the actuator with its load in the corner, for drawings along the axis.
    fn overhang(mut self, overhang_m: f64) -> Self {
        let [width, height] = self.size;
        self.size = [width + 112.0, height.max(120.0)];
        let (x, y) = (width + 4.0, self.size[1] - 46.0);
        // Limited so that it fits above a quarter of a metre and is readable below 40 mm.
        let away = (overhang_m * 160.0).clamp(-24.0, 44.0);
        let away = if away.abs() < 8.0 { 8.0_f64.copysign(away) } else { away };
        let (flange, load) = (x + 44.0, x + 44.0 + away);
        self = self
            .rect(Look::Housing, [x, y - 20.0], [34.0, 40.0])
            .rect(Look::Housing, [x + 34.0, y - 24.0], [10.0, 48.0])
            .line(Look::Axis, [x - 2.0, y], [x + 106.0, y])
            .rect(Look::Body, [load - 7.0, y - 15.0], [14.0, 30.0])
            .line(Look::Thin, [flange, y - 24.0], [flange, y - 40.0])
            .line(Look::Thin, [load, y - 15.0], [load, y - 40.0])
            .line(Look::Thin, [flange.min(load) - 10.0, y - 36.0], [flange.max(load) + 10.0, y - 36.0])
            .calls("overhang", "a", [0.5 * (flange + load), y - 36.0], [0.5 * (flange + load), y - 54.0]);
        if let Some(call_out) = self.call_outs.last_mut() {
            call_out.is_of_bearing = true;
        }
        self
    }

    /// Moves overlapping symbols apart, within the sheet.
    fn keep_apart(&mut self) {
        let [width, height] = self.size;
        let [wide, high] = [17.0, 15.0];
        for _ in 0..80 {
            let mut is_apart = true;
            for one in 0..self.call_outs.len() {
                for other in 0..one {
                    let (Some(a), Some(b)) = (self.call_outs.get(one), self.call_outs.get(other)) else { continue };
                    let [dx, dy] = [a.label[0] - b.label[0], a.label[1] - b.label[1]];
                    let (lack_x, lack_y) = (wide - dx.abs(), high - dy.abs());
                    if lack_x <= 0.0 || lack_y <= 0.0 {
                        continue;
                    }
                    is_apart = false;
                    let [x, y] = if lack_x < lack_y {
                        [0.55 * lack_x.copysign(dx), 0.0]
                    } else {
                        [0.0, 0.55 * lack_y.copysign(dy)]
                    };
                    for (index, sign) in [(one, 1.0), (other, -1.0)] {
                        let Some(call_out) = self.call_outs.get_mut(index) else { continue };
                        let [at_x, at_y] = call_out.label;
                        call_out.label = [
                            (at_x + sign * x).clamp(LABEL[0], width - LABEL[0]),
                            (at_y + sign * y).clamp(LABEL[1], height - LABEL[1]),
                        ];
                    }
                }
            }
            if is_apart {
                break;
            }
        }
    }

    fn with(mut self, part: DrawingPart) -> Self {
        self.parts.push(part);
        self
    }

    pub(crate) fn path(self, look: Look, steps: impl IntoIterator<Item = Step>) -> Self {
        self.with(DrawingPart::Path(look, steps.into_iter().collect()))
    }

    pub(crate) fn line(self, look: Look, from: SheetPoint, to: SheetPoint) -> Self {
        self.path(look, [Step::Move(from), Step::Line(to)])
    }

    /// Adds a closed outline.
    pub(crate) fn outline(self, look: Look, points: &[SheetPoint]) -> Self {
        self.path(look, polyline(points).chain([Step::Close]))
    }

    pub(crate) fn rect(self, look: Look, [x, y]: SheetPoint, [w, h]: SheetPoint) -> Self {
        self.outline(look, &[[x, y], [x + w, y], [x + w, y + h], [x, y + h]])
    }

    pub(crate) fn circle(self, look: Look, at: SheetPoint, radius: f64) -> Self {
        self.with(DrawingPart::Circle(look, at, radius))
    }

    pub(crate) fn arrow(self, from: SheetPoint, to: SheetPoint) -> Self {
        self.line(Look::Arrow, from, to)
    }

    /// Adds an arrow along a circle, turning right if `right`.
    pub(crate) fn turning(self, from: SheetPoint, radius: f64, right: bool, to: SheetPoint) -> Self {
        self.path(Look::Arrow, [Step::Move(from), Step::Arc(radius, right, to)])
    }

    /// Adds an arrow along a circle from one angle to another \[rad\], in the direction of the difference.
    pub(crate) fn sweep(self, look: Look, at: SheetPoint, radius: f64, [from, to]: [f64; 2]) -> Self {
        let pieces = [1.0, 2.0, 3.0, 4.0].into_iter().find(|pieces| (to - from).abs() <= FRAC_PI_2 * pieces);
        let pieces = pieces.unwrap_or(4.0);
        let ends = [1.0, 2.0, 3.0, 4.0].into_iter().take_while(|piece| *piece <= pieces);
        let arc = |piece| Step::Arc(radius, to < from, polar(at, radius, from + (to - from) * piece / pieces));
        self.path(look, [Step::Move(polar(at, radius, from))].into_iter().chain(ends.map(arc)))
    }

    pub(crate) fn dimension(self, from: SheetPoint, to: SheetPoint) -> Self {
        self.line(Look::Dimension, from, to)
    }

    pub(crate) fn centre(self, at: SheetPoint) -> Self {
        self.with(DrawingPart::Centre(at))
    }

    pub(crate) fn symbol(self, text: &'static str, at: SheetPoint) -> Self {
        self.with(DrawingPart::Symbol(text, at))
    }

    /// Adds a bar with round ends between two pins.
    pub(crate) fn bar(self, [ax, ay]: SheetPoint, [bx, by]: SheetPoint, half: f64) -> Self {
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

    /// Adds a rectangle about its centre, rotated counter-clockwise.
    pub(crate) fn leaning_rect(self, look: Look, middle: SheetPoint, [w, h]: SheetPoint, lean_rad: f64) -> Self {
        let corner = |x: f64, y: f64| polar(polar(middle, 0.5 * x * w, lean_rad), 0.5 * y * h, lean_rad + FRAC_PI_2);
        self.outline(look, &[corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)])
    }

    /// Adds holes around an axis, which make a rotation visible.
    pub(crate) fn holes(mut self, at: SheetPoint, around: f64, radius: f64) -> Self {
        for hole in 0..3 {
            self = self.circle(Look::Hole, polar(at, around, f64::from(hole) * FRAC_PI_2 * 4.0 / 3.0 + 0.4), radius);
        }
        self
    }

    /// Adds a support: a line to the right with hatching below.
    pub(crate) fn ground(mut self, [x, y]: SheetPoint, width: f64) -> Self {
        self = self.line(Look::Line, [x, y], [x + width, y]);
        let mut hatching = Vec::new();
        let mut at = x + 6.0;
        while at <= x + width {
            hatching.extend([Step::Move([at, y]), Step::Line([at - 6.0, y + 6.0])]);
            at += 8.0;
        }
        self.path(Look::Thin, hatching)
    }

    /// Adds an overhead support: a line to the right with hatching above.
    pub(crate) fn ground_above(mut self, [x, y]: SheetPoint, width: f64) -> Self {
        self = self.line(Look::Line, [x, y], [x + width, y]);
        let mut hatching = Vec::new();
        let mut at = x;
        while at + 6.0 <= x + width {
            hatching.extend([Step::Move([at, y]), Step::Line([at + 6.0, y - 6.0])]);
            at += 8.0;
        }
        self.path(Look::Thin, hatching)
    }

    /// Adds turns of a rope on a drum, from the upper left, with height and inclination of the strokes.
    pub(crate) fn rope(mut self, [x, y]: SheetPoint, [height, lean]: SheetPoint) -> Self {
        for turn in 0..6 {
            let at = x + 5.0 * f64::from(turn);
            self = self.line(Look::Thin, [at, y], [at + lean, y + height]);
        }
        self
    }

    /// Adds a fixed pivot: a triangle on a support.
    pub(crate) fn pivot(self, [x, y]: SheetPoint) -> Self {
        self.outline(Look::Housing, &[[x, y], [x + 12.0, y + 20.0], [x - 12.0, y + 20.0]])
            .ground([x - 18.0, y + 20.0], 36.0)
    }

    /// Adds the actuator from the side, its flange 78 to the right of `x` and its axis at `y`.
    pub(crate) fn actuator(mut self, [x, y]: SheetPoint) -> Self {
        self = self
            .rect(Look::Housing, [x, y - 36.0], [58.0, 72.0])
            .rect(Look::Housing, [x + 58.0, y - 44.0], [10.0, 88.0])
            .rect(Look::Housing, [x + 68.0, y - 27.0], [10.0, 54.0]);
        for offset in [-9.0, 9.0] {
            self = self.line(Look::Hidden, [x, y + offset], [x + 78.0, y + offset]);
        }
        self
    }

    /// Adds the actuator seen along its axis.
    pub(crate) fn face(self, at: SheetPoint, radius: f64) -> Self {
        self.circle(Look::Housing, at, radius).circle(Look::Hidden, at, radius * 0.72).circle(
            Look::Hole,
            at,
            radius * 0.3,
        )
    }

    /// Adds a slide with its centre of mass.
    pub(crate) fn slide(self, [x, y]: SheetPoint) -> Self {
        self.rect(Look::Body, [x, y], [84.0, 36.0]).centre([x + 42.0, y + 18.0])
    }

    pub(crate) fn calls(mut self, key: &'static str, symbol: &'static str, at: SheetPoint, label: SheetPoint) -> Self {
        self.call_outs.push(CallOut { key, is_of_bearing: false, symbol, at, label, group: None });
        self
    }
}
