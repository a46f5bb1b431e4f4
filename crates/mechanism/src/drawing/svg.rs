//! Drawings as SVG: each part has the class of its style, so that a page can colour it; a stand-alone picture includes
//! a style sheet.

use super::{CallOut, Drawing, DrawingPart, Look, Moving, SheetPoint, Step};
use std::fmt::Write;

/// Style sheet of a stand-alone picture; its text uses the font family Inter.
const STYLE: &str = "<style>.l-line,.l-thin,.l-hidden,.l-axis,.l-arrow,.l-dimension,.l-leader{fill:none}\
    .l-housing,.l-body,.l-line,.l-hole,.l-centre{stroke:#18222c;stroke-width:1.5;stroke-linejoin:round;stroke-linecap:round}\
    .l-housing{fill:#e9eef1}.l-body{fill:#cfe0e3;stroke:#0c5160;stroke-width:1.7}.l-hole,.l-centre{fill:#fff}\
    .l-thin,.l-hidden,.l-axis,.l-dimension,.l-leader{stroke:#56636f;stroke-width:.9}.l-hidden{stroke-dasharray:3 2.4}\
    .l-axis{stroke-dasharray:9 3 2 3}.l-leader{stroke-width:.6}.l-arrow{stroke:#0c5160;stroke-width:1.8}\
    .l-tip{fill:#0c5160;stroke:none}.l-end{fill:#56636f;stroke:none}.l-mark{fill:#18222c;stroke:none}\
    text{fill:#0c5160;font-family:Inter;font-weight:600;font-size:14px;text-anchor:middle}</style>";

impl Look {
    /// Returns the class of the elements.
    #[must_use]
    pub const fn class(self) -> &'static str {
        match self {
            Self::Housing => "l-housing",
            Self::Body => "l-body",
            Self::Line => "l-line",
            Self::Thin => "l-thin",
            Self::Hidden => "l-hidden",
            Self::Axis => "l-axis",
            Self::Arrow => "l-arrow",
            Self::Dimension => "l-dimension",
            Self::Hole => "l-hole",
        }
    }
}

/// Returns a coordinate rounded to hundredths.
fn shown(value: f64) -> f64 {
    (value * 100.0).round() / 100.0 + 0.0
}

fn pair([x, y]: SheetPoint) -> String {
    format!("{} {}", shown(x), shown(y))
}

/// Returns a point relative to another one, from distances along and across a direction.
fn offset([x, y]: SheetPoint, [dx, dy]: SheetPoint, along: f64, across: f64) -> SheetPoint {
    [x + along * dx - across * dy, y + along * dy + across * dx]
}

fn direction([ax, ay]: SheetPoint, [bx, by]: SheetPoint) -> SheetPoint {
    let length = (bx - ax).hypot(by - ay).max(f64::MIN_POSITIVE);
    [(bx - ax) / length, (by - ay) / length]
}

/// Returns the end of a step and the direction in which it arrives.
fn arrival(from: SheetPoint, step: &Step) -> Option<(SheetPoint, SheetPoint)> {
    match step {
        Step::Line(to) => Some((*to, direction(from, *to))),
        Step::Curve(_, before, to) => Some((*to, direction(*before, *to))),
        Step::Arc(radius, right, to) => {
            // The tangent differs from the chord by half of the angle of the arc.
            let half = (0.5 * (to[0] - from[0]).hypot(to[1] - from[1]) / radius).min(1.0).asin();
            let (sin, cos) = if *right { half } else { -half }.sin_cos();
            let chord = direction(from, *to);
            Some((*to, [cos * chord[0] - sin * chord[1], sin * chord[0] + cos * chord[1]]))
        }
        Step::Move(_) | Step::Close => None,
    }
}

fn path(class: &str, steps: &[Step]) -> String {
    let mut data = String::new();
    for step in steps {
        // Writing to a string cannot fail.
        let _ = match step {
            Step::Move(to) => write!(data, "M{}", pair(*to)),
            Step::Line(to) => write!(data, "L{}", pair(*to)),
            Step::Arc(radius, right, to) => {
                let r = shown(*radius);
                write!(data, "A{r} {r} 0 0 {} {}", u8::from(*right), pair(*to))
            }
            Step::Curve(a, b, to) => write!(data, "C{} {} {}", pair(*a), pair(*b), pair(*to)),
            Step::Close => write!(data, "Z"),
        };
    }
    format!("<path class='{class}' d='{data}'/>")
}

/// Returns an arrow head whose tip is at a point.
fn head(class: &str, at: SheetPoint, to: SheetPoint, [length, half]: [f64; 2]) -> String {
    let (left, right) = (offset(at, to, -length, half), offset(at, to, -length, -half));
    path(class, &[Step::Move(at), Step::Line(left), Step::Line(right), Step::Close])
}

fn part(part: &DrawingPart) -> String {
    match part {
        DrawingPart::Circle(look, [x, y], radius) => {
            format!("<circle class='{}' cx='{}' cy='{}' r='{}'/>", look.class(), shown(*x), shown(*y), shown(*radius))
        }
        DrawingPart::Path(look, steps) => {
            let mut text = path(look.class(), steps);
            let ends = match steps.as_slice() {
                [Step::Move(from), .., before, last] => {
                    before.end().map(|before| (*from, before, *last, steps.get(1).copied()))
                }
                [Step::Move(from), last] => Some((*from, *from, *last, Some(*last))),
                _ => None,
            };
            let Some((from, before, last, first)) = ends else { return text };
            let Some((at, to)) = arrival(before, &last) else { return text };
            match look {
                Look::Arrow => text.push_str(&head("l-tip", at, to, [9.0, 4.0])),
                Look::Dimension => {
                    text.push_str(&head("l-end", at, to, [7.0, 2.2]));
                    if let Some(Step::Line(next)) = first {
                        text.push_str(&head("l-end", from, direction(next, from), [7.0, 2.2]));
                    }
                }
                Look::Housing | Look::Body | Look::Line | Look::Thin | Look::Hidden | Look::Axis | Look::Hole => {}
            }
            text
        }
        DrawingPart::Centre([x, y]) => {
            let (x, y) = (shown(*x), shown(*y));
            format!(
                "<circle class='l-centre' cx='{x}' cy='{y}' r='6'/>\
                <path class='l-mark' d='M{x} {y}v-6a6 6 0 0 1 6 6zM{x} {y}v6a6 6 0 0 1 -6 -6z'/>"
            )
        }
        DrawingPart::Symbol(text, [x, y]) => format!("<text x='{}' y='{}'>{text}</text>", shown(*x), shown(y + 4.5)),
        DrawingPart::Group(_, parts) => parts.iter().map(self::part).collect(),
    }
}

/// Returns a part whose groups a script can find.
fn movable(it: &DrawingPart) -> String {
    match it {
        DrawingPart::Group(group, _) => format!("<g data-group='{group}'>{}</g>", part(it)),
        DrawingPart::Circle(..) | DrawingPart::Path(..) | DrawingPart::Centre(_) | DrawingPart::Symbol(..) => part(it),
    }
}

impl Moving {
    /// Returns the table for a script: the centre of rotation, the continuation, then for each row the angle of the
    /// output \[°\], the clockwise rotation \[°\], shift x, shift y and, if the group is stretched, stretch x and y.
    ///
    /// # Symbols
    /// `ratio` angle of the output per angle of the mechanism
    #[must_use]
    pub fn table(&self, ratio: f64) -> String {
        let is_stretched = self.rows.iter().any(|(_, placement)| placement.stretch != [1.0, 1.0]);
        let mut text = format!("{} {}", pair(self.about), self.beyond.id());
        for (angle, placement) in &self.rows {
            let turn = shown(-placement.turn_rad.to_degrees());
            // Writing to a string cannot fail.
            let _ = write!(text, ";{} {turn} {}", shown((angle * ratio).to_degrees()), pair(placement.shift));
            if is_stretched {
                let [x, y] = placement.stretch.map(|value| (value * 1e4).round() / 1e4);
                let _ = write!(text, " {x} {y}");
            }
        }
        text
    }
}

impl CallOut {
    /// Returns the leader from the symbol to its end as SVG; it starts at some distance from the symbol.
    #[must_use]
    pub fn leader(&self) -> String {
        let from = offset(self.label, direction(self.label, self.at), 9.0, 0.0);
        let line = path("l-leader", &[Step::Move(from), Step::Line(self.at)]);
        format!("{line}<circle class='l-mark' cx='{}' cy='{}' r='1.5'/>", shown(self.at[0]), shown(self.at[1]))
    }

    /// Returns the position of the symbol's baseline.
    #[must_use]
    pub fn foot(&self) -> SheetPoint {
        [shown(self.label[0]), shown(self.label[1] + 4.5)]
    }
}

impl Drawing {
    /// Returns the box of the sheet for the attribute `viewBox`.
    #[must_use]
    pub fn view_box(&self) -> String {
        format!("0 0 {}", pair(self.size))
    }

    /// Returns the parts as SVG, without the call-outs.
    #[must_use]
    pub fn svg(&self) -> String {
        self.parts.iter().map(part).collect()
    }

    /// Returns the parts as SVG, each moving group in an element of its own with its index in `data-group`.
    #[must_use]
    pub fn movable_svg(&self) -> String {
        self.parts.iter().map(movable).collect()
    }

    /// Returns a stand-alone picture with the selected call-outs.
    #[must_use]
    pub fn picture(&self, shows: impl Fn(&CallOut) -> bool) -> String {
        let [width, height] = self.size;
        let mut text = format!(
            "<svg xmlns='http://www.w3.org/2000/svg' width='{width}' height='{height}' viewBox='{}'>{STYLE}{}",
            self.view_box(),
            self.svg()
        );
        for call_out in self.call_outs.iter().filter(|it| shows(it)) {
            let [x, y] = call_out.foot();
            let (symbol, index) = call_out.symbol.split_once('_').unwrap_or((call_out.symbol, ""));
            let _ = write!(text, "{}<text x='{x}' y='{y}'>{symbol}", call_out.leader());
            if !index.is_empty() {
                let _ = write!(text, "<tspan dy='3' font-size='13.7'>{index}</tspan>");
            }
            text.push_str("</text>");
        }
        text.push_str("</svg>");
        text
    }
}
