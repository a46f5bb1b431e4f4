//! Axes: range, ticks and labels.

use crate::canvas::{AXIS, Anchor, Canvas, Fill, HAIR, RULE, Setting, Stroke, TEXT};
use crate::font::CAP_HEIGHT;
use crate::geometry::{Point, Rect};
use crate::label::{Label, RunKind, SIZE_MIN, TextRun};
use crate::number::number;
use crate::style::Colour;
use crate::ticks::{LARGEST, Ticks};

/// One axis of a chart: name, symbol and unit of its quantity, and the range to show.
///
/// Written according to DIN 461: name, symbol in italics, a slash, the unit: "torque *T* / Nm".
#[derive(Clone, Debug, PartialEq)]
pub struct PlaneAxis {
    name: Label,
    symbol: String,
    unit: String,
    fixed: Option<(f64, f64)>,
    /// Values that the range contains besides the data.
    also: Option<(f64, f64)>,
    zero: bool,
    tight: bool,
    minor: bool,
}

impl PlaneAxis {
    /// Creates an axis of a quantity by its symbol (index after an underscore) and unit, either of which may be empty.
    #[must_use]
    pub fn new(symbol: &str, unit: &str) -> Self {
        Self {
            name: Label::symbol(symbol),
            symbol: symbol.to_owned(),
            unit: unit.to_owned(),
            fixed: None,
            also: None,
            zero: true,
            tight: false,
            minor: false,
        }
    }

    /// Returns symbol and unit.
    #[must_use]
    pub fn sign(&self) -> (&str, &str) {
        (&self.symbol, &self.unit)
    }

    /// Writes the name of the quantity before its symbol.
    #[must_use]
    pub fn name(mut self, name: &str) -> Self {
        let mut runs = Label::from(name).text(if self.name.is_empty() { "" } else { " " });
        runs.runs.append(&mut self.name.runs);
        self.name = runs;
        self
    }

    /// Allows a range without zero. Lengths can then no longer be compared by eye.
    #[must_use]
    pub const fn without_zero(mut self) -> Self {
        self.zero = false;
        self
    }

    /// Ends the axis at the data instead of at the next tick.
    #[must_use]
    pub const fn tight(mut self) -> Self {
        self.tight = true;
        self
    }

    /// Shows exactly this range and clips the rest. An empty range is ignored.
    #[must_use]
    pub fn range(mut self, from: f64, to: f64) -> Self {
        if from.is_finite() && to.is_finite() && from != to {
            self.fixed = Some((from.min(to), from.max(to)));
        }
        self
    }

    /// Extends the range of the data by these values, so that another chart can have the same range.
    #[must_use]
    pub fn including(mut self, from: f64, to: f64) -> Self {
        if from.is_finite() && to.is_finite() {
            self.also = Some((from, to));
        }
        self
    }

    /// Draws short ticks between the labelled ones.
    #[must_use]
    pub const fn minor_ticks(mut self) -> Self {
        self.minor = true;
        self
    }

    /// Returns name and symbol of the quantity, without its unit.
    #[must_use]
    pub fn quantity(&self) -> Label {
        self.name.clone()
    }

    /// Returns the title of the axis, with the power of ten that is taken out of its numbers.
    pub(crate) fn title(&self, exponent: i32) -> Label {
        let power = match exponent {
            0 => String::new(),
            _ => format!("10{}", raised(exponent)),
        };
        let unit = match (self.unit.as_str(), power.as_str()) {
            ("", power) => power.to_owned(),
            (unit, "") if unit.contains('/') && !self.name.is_empty() => format!("({unit})"),
            (unit, "") => unit.to_owned(),
            (unit, power) if unit.contains('/') => format!("({power} {unit})"),
            (unit, power) => format!("{power} {unit}"),
        };
        match (self.name.is_empty(), unit.is_empty()) {
            (_, true) => self.name.clone(),
            (true, false) => Label::from(unit),
            (false, false) => self.name.clone().text(&format!(" / {unit}")),
        }
    }

    /// Returns the title within a width, with its font size: whole, smaller, or without the name of the quantity.
    /// Symbol and unit stay.
    pub(crate) fn title_within(&self, exponent: i32, room: f64) -> (Label, f64) {
        let whole = self.title(exponent);
        let least = SIZE_MIN;
        if whole.width(AXIS, false) <= room {
            return (whole, AXIS);
        }
        if whole.width(least, false) <= room {
            return (whole, least);
        }
        let symbol: Vec<TextRun> = self.name.runs.iter().filter(|run| run.kind != RunKind::Plain).cloned().collect();
        if symbol.is_empty() {
            return (whole, least);
        }
        let short = Self { name: Label { runs: symbol }, ..self.clone() }.title(exponent);
        let size = if short.width(AXIS, false) <= room { AXIS } else { least };
        (short, size)
    }

    /// Returns the range for data, and `true` if it may be extended to the next tick.
    pub(crate) fn span(&self, data: &[f64], both_signs: bool) -> (f64, f64, bool) {
        if let Some((lo, hi)) = self.fixed {
            return (lo, hi, false);
        }
        let mut range: Option<(f64, f64)> = None;
        let zero = if self.zero || both_signs { Some(0.0) } else { None };
        let also = self.also.into_iter().flat_map(|(from, to)| [from, to]);
        for value in data.iter().copied().chain(also).chain(zero).filter(|value| value.abs() <= LARGEST) {
            range = Some(range.map_or((value, value), |(lo, hi)| (lo.min(value), hi.max(value))));
        }
        let (mut lo, mut hi) = range.unwrap_or((0.0, 1.0));
        if self.tight && !both_signs {
            return (lo, hi, lo >= hi);
        }
        // Margin beyond the last point, so that it is not drawn on the frame; none for a rounding error next to zero.
        let room = (hi - lo) * 0.03;
        let noise = (hi - lo) * 1e-9;
        if hi > noise || !self.zero {
            hi += room;
        }
        if lo < -noise || !self.zero {
            lo -= room;
        }
        if both_signs {
            let least = 0.2 * hi.max(-lo);
            (lo, hi) = (lo.min(-least), hi.max(least));
        }
        (lo, hi, true)
    }
}

fn raised(exponent: i32) -> String {
    exponent
        .to_string()
        .chars()
        .map(|c| match c {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            digit => digit.to_digit(10).and_then(|d| char::from_u32(0x2070 + d)).unwrap_or(digit),
        })
        .collect()
}

/// A plane of two axes on the canvas.
#[derive(Clone, Debug)]
pub(crate) struct Plane {
    pub(crate) area: Rect,
    pub(crate) x: Ticks,
    pub(crate) y: Ticks,
}

/// Length of a tick.
pub(crate) const TICK: f64 = 4.0;
/// Free margin of the picture.
pub(crate) const EDGE: f64 = 8.0;
/// Distance between ticks and their labels.
const GAP: f64 = 4.0;
/// Distance from the lower end of a plane to the base line of its x labels.
pub(crate) const X_LABELS: f64 = TICK + GAP + TEXT * CAP_HEIGHT;
pub(crate) const X_TITLE: f64 = X_LABELS + 7.0 + AXIS * 0.8;
/// Height of an x axis with title below the plane.
pub(crate) const X_BELOW: f64 = X_TITLE + 4.0;
/// Height of the title of a y axis above the plane.
pub(crate) const Y_ABOVE: f64 = AXIS + 8.0;

impl Plane {
    /// Returns the ranges of both axes.
    pub(crate) fn range(&self) -> ((f64, f64), (f64, f64)) {
        ((self.x.lo, self.x.hi), (self.y.lo, self.y.hi))
    }

    pub(crate) fn at(&self, (x, y): Point) -> Point {
        (self.x_at(x), self.y_at(y))
    }

    pub(crate) fn x_at(&self, x: f64) -> f64 {
        let share = (x - self.x.lo) / (self.x.hi - self.x.lo);
        share.clamp(-1e6, 1e6).mul_add(self.area.width(), self.area.left)
    }

    pub(crate) fn y_at(&self, y: f64) -> f64 {
        let share = (y - self.y.lo) / (self.y.hi - self.y.lo);
        share.clamp(-1e6, 1e6).mul_add(-self.area.height(), self.area.bottom)
    }

    /// Draws the grid and, behind all else, the zero lines.
    pub(crate) fn grid(&self, canvas: &mut Canvas<'_>) {
        canvas.open("grid");
        let mut d = String::new();
        let inside = |value: f64, lo: f64, hi: f64| value > lo && value < hi;
        for x in self.x.values.iter().filter(|x| inside(**x, self.x.lo, self.x.hi)) {
            let x = number(self.x_at(*x));
            d.push_str(&format!("M{x} {}V{}", number(self.area.top), number(self.area.bottom)));
        }
        for y in self.y.values.iter().filter(|y| **y != self.y.lo) {
            let y = number(self.y_at(*y));
            d.push_str(&format!("M{} {y}H{}", number(self.area.left), number(self.area.right)));
        }
        canvas.path(&d, &Fill::None, Some(&Stroke::solid(Colour::Grid, HAIR)));
        canvas.close();
    }

    /// Draws the y axis: line, ticks, numbers.
    pub(crate) fn y_axis(&self, canvas: &mut Canvas<'_>, axis: &PlaneAxis) {
        canvas.open("axis y");
        let left = self.area.left;
        let rule = Stroke::solid(Colour::Ink, RULE);
        canvas.line((left, self.area.top), (left, self.area.bottom), &rule);
        let language = canvas.style.language;
        if axis.minor {
            for value in &self.y.minor {
                let y = self.y_at(*value);
                canvas.line((left - TICK / 2.0, y), (left, y), &Stroke::solid(Colour::Ink, HAIR));
            }
        }
        let mut numbered = numbered(&self.y, self.area.height()).peekable();
        for value in &self.y.values {
            let y = self.y_at(*value);
            canvas.line((left - TICK, y), (left, y), &rule);
            if numbered.next_if_eq(value).is_some() {
                let label = Label::from(self.y.label(*value, language));
                let setting = Setting::new(TEXT, Colour::Ink, Anchor::End);
                canvas.text((left - TICK - GAP, TEXT.mul_add(CAP_HEIGHT / 2.0, y)), &label, setting);
            }
        }
        if self.y.lo < 0.0 && self.y.hi > 0.0 {
            let zero = self.y_at(0.0);
            canvas.line((left, zero), (self.area.right, zero), &Stroke::solid(Colour::Ink, RULE));
        }
        canvas.close();
    }

    /// Draws the x axis: line, ticks, numbers.
    pub(crate) fn x_axis(&self, canvas: &mut Canvas<'_>, axis: &PlaneAxis) {
        canvas.open("axis x");
        let bottom = self.area.bottom;
        let rule = Stroke::solid(Colour::Ink, RULE);
        canvas.line((self.area.left, bottom), (self.area.right, bottom), &rule);
        let language = canvas.style.language;
        if axis.minor {
            for value in &self.x.minor {
                let x = self.x_at(*value);
                canvas.line((x, bottom), (x, bottom + TICK / 2.0), &Stroke::solid(Colour::Ink, HAIR));
            }
        }
        let mut until = 0.0;
        for value in &self.x.values {
            let x = self.x_at(*value);
            canvas.line((x, bottom), (x, bottom + TICK), &rule);
            let label = Label::from(self.x.label(*value, language));
            let half = label.width(TEXT, false) / 2.0;
            // A number is left out only if the plane is too narrow for two of them.
            if x - half >= until && x + half <= canvas.style.size.width {
                until = x + half + GAP;
                canvas.text((x, bottom + X_LABELS), &label, Setting::new(TEXT, Colour::Ink, Anchor::Middle));
            }
        }
        canvas.close();
    }

    /// Writes the title of the y axis, horizontal above its numbers, on a base line.
    pub(crate) fn y_title(&self, canvas: &mut Canvas<'_>, axis: &PlaneAxis, room: f64, at: f64) {
        let (title, size) = axis.title_within(self.y.exponent, room);
        canvas.text((EDGE, at), &title, Setting::new(size, Colour::Ink, Anchor::Start));
    }

    /// Writes the title of the x axis below its end.
    pub(crate) fn x_title(&self, canvas: &mut Canvas<'_>, axis: &PlaneAxis) {
        let (title, size) = axis.title_within(self.x.exponent, self.area.right - EDGE);
        canvas.text(
            (self.area.right, self.area.bottom + X_TITLE),
            &title,
            Setting::new(size, Colour::Ink, Anchor::End),
        );
    }
}

/// Share of a widened axis that the data take at least; a low plane would waste its height otherwise.
const FILLED: f64 = 0.6;

/// Returns the ticks that fit into a height: at least two of them with a number.
pub(crate) fn y_ticks((lo, hi, widen): (f64, f64, bool), height: f64) -> Ticks {
    // Extending the range adds up to two steps, so that their number is known only afterwards.
    let distance = (height / 9.0).clamp(20.0, 38.0);
    let room = whole((height / distance).clamp(1.0, 12.0));
    // A fixed range has no ticks beyond its last ones: finer steps leave more than a single number.
    let most = if widen { room } else { room + 2 };
    let coarse = (1..=most)
        .rev()
        .map(|most| Ticks::new(lo, hi, most, widen))
        .find(|ticks| ticks.values.len() <= room + 1)
        .unwrap_or_else(|| Ticks::new(lo, hi, 1, widen));
    let has_scale = |ticks: &Ticks| numbered(ticks, height).nth(1).is_some();
    if has_scale(&coarse) && hi - lo >= FILLED * (coarse.hi - coarse.lo) || hi <= lo {
        return coarse;
    }
    // A low plane ends at its data, and its steps are closer than the numbers of a higher one.
    (1..=FINEST).map(|most| Ticks::new(lo, hi, most, false)).find(has_scale).unwrap_or(coarse)
}

/// Largest number of steps tried for two numbers on a low plane.
const FINEST: usize = 12;

/// Returns the ticks that have room for a number in a height, from the lowest on: those of a very low plane are closer
/// than their numbers are high.
fn numbered(ticks: &Ticks, height: f64) -> impl Iterator<Item = f64> {
    let pixels = height / (ticks.hi - ticks.lo);
    let mut last = f64::NEG_INFINITY;
    ticks.values.iter().copied().filter(move |value| {
        let has_room = (value - last) * pixels >= TEXT;
        if has_room {
            last = *value;
        }
        has_room
    })
}

/// Returns the width of the y labels to the left of the plane.
pub(crate) fn y_margin(canvas: &Canvas<'_>, ticks: &Ticks) -> f64 {
    let widest = ticks.values.iter().map(|value| width_of(canvas, ticks, *value)).fold(0.0, f64::max);
    EDGE + widest + TICK + GAP
}

/// Returns ticks whose labels do not touch, and the right end of the plane at which the last label is not cut off.
pub(crate) fn x_ticks(canvas: &Canvas<'_>, (lo, hi, widen): (f64, f64, bool), left: f64, right: f64) -> (Ticks, f64) {
    let edge = canvas.style.size.width - 2.0;
    let mut end = right;
    for most in (1..=whole(((right - left) / 42.0).clamp(1.0, 16.0))).rev() {
        let ticks = Ticks::new(lo, hi, most, widen);
        let x_at = |x: f64, end: f64| ((x - ticks.lo) / (ticks.hi - ticks.lo)).mul_add(end - left, left);
        end = right;
        if let Some(last) = ticks.values.last() {
            let beyond = width_of(canvas, &ticks, *last).mul_add(0.5, x_at(*last, right)) - edge;
            end = (right - beyond.max(0.0)).max(left + 20.0);
        }
        let boxes: Vec<(f64, f64)> =
            ticks.values.iter().map(|value| (x_at(*value, end), width_of(canvas, &ticks, *value) / 2.0)).collect();
        if boxes.iter().zip(boxes.iter().skip(1)).all(|(a, b)| a.0 + a.1 + 12.0 <= b.0 - b.1) {
            return (ticks, end);
        }
    }
    (Ticks::new(lo, hi, 1, widen), end)
}

fn width_of(canvas: &Canvas<'_>, ticks: &Ticks, value: f64) -> f64 {
    Label::from(ticks.label(value, canvas.style.language)).width(TEXT, false)
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to a small count by the callers")]
const fn whole(value: f64) -> usize {
    value as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn titles_follow_the_standard() {
        assert_eq!(PlaneAxis::new("T", "Nm").title(0).plain(), "T / Nm");
        assert_eq!(PlaneAxis::new("n", "min⁻¹").name("Speed").title(3).plain(), "Speed n / 10³ min⁻¹");
        assert_eq!(PlaneAxis::new("K", "Nm/rad").title(0).plain(), "K / (Nm/rad)");
        assert_eq!(PlaneAxis::new("K", "Nm/rad").title(-6).plain(), "K / (10⁻⁶ Nm/rad)");
        assert_eq!(PlaneAxis::new("", "%").title(0).plain(), "%");
        assert_eq!(PlaneAxis::new("", "").name("Rank").title(0).plain(), "Rank");
        assert_eq!(PlaneAxis::new("i", "").title(6).plain(), "i / 10⁶");
    }

    #[test]
    fn a_title_without_room_keeps_symbol_and_unit() {
        let axis = PlaneAxis::new("T_rms", "Nm").name("Torque at the output");
        let whole = axis.title(0).width(AXIS, false);
        assert_eq!(axis.title_within(0, whole + 1.0), (axis.title(0), AXIS));
        assert_eq!(axis.title_within(0, whole * 0.8), (axis.title(0), SIZE_MIN));
        assert_eq!(axis.title_within(3, whole * 0.5).0.plain(), "T_rms / 10³ Nm");
        assert_eq!(axis.title_within(0, 1.0).0.plain(), "T_rms / Nm");
    }

    #[test]
    fn zero_is_shown_unless_it_is_waived() {
        assert_eq!(PlaneAxis::new("T", "Nm").span(&[5.0, 10.0], false).0, 0.0);
        // A return move that ends a rounding error below its start needs no negative half.
        assert!(PlaneAxis::new("φ", "°").span(&[-3e-13, 763.9], false).0 > -1e-6);
        assert!(PlaneAxis::new("φ", "°").span(&[-763.9, 3e-13], false).1 < 1e-6);
        assert!(PlaneAxis::new("T", "Nm").without_zero().span(&[5.0, 10.0], false).0 > 4.0);
        let (lo, hi, _) = PlaneAxis::new("T", "Nm").span(&[5.0, 10.0], true);
        assert!(lo < 0.0 && hi > 10.0);
        assert_eq!(PlaneAxis::new("T", "Nm").range(8.0, 2.0).span(&[5.0], false), (2.0, 8.0, false));
    }
}
