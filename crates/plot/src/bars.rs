//! Utilisation of limits as horizontal bars.

use crate::canvas::{Anchor, Canvas, Fill, HAIR, RULE, Setting, Stroke, TEXT};
use crate::chart_title::{title, title_height};
use crate::font::CAP_HEIGHT;
use crate::geometry::{Point, Rect};
use crate::item::{Tags, tagged};
use crate::label::Label;
use crate::number::number;
use crate::picture::Picture;
use crate::plane::{EDGE, PlaneAxis, TICK, X_BELOW, X_LABELS, X_TITLE};
use crate::style::{Colour, Hatch, Style};
use crate::ticks::Ticks;
use crate::titled::titled;

/// Bars against a limit of 100 %, one row for each check.
#[derive(Clone, Debug, PartialEq)]
pub struct BarChart {
    axis: PlaneAxis,
    title: Label,
    description: String,
    rows: Vec<Bar>,
    legend: Vec<(Verdict, Label)>,
}

/// Result of a check, which decides colour, pattern and sign of a bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// Within the limit: filled, a tick.
    Pass,
    /// Within the limit with advice: rising lines, a triangle.
    Advice,
    /// Beyond the limit: crossed lines, a cross.
    Fail,
    /// Unknown: no bar, an empty circle.
    NotChecked,
    /// Known and not judged, since there is no limit: no bar, a dash.
    NoLimit,
}

/// One row: a label, a bar, a text.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    label: Label,
    verdict: Verdict,
    percent: Option<f64>,
    /// Percentage by the other edge of an estimated limit, at most that of the bar.
    from: Option<f64>,
    text: Label,
    tags: Tags,
}
tagged!(Bar);

impl Bar {
    /// Creates a row without a bar.
    #[must_use]
    pub fn new(label: impl Into<Label>, verdict: Verdict) -> Self {
        Self { label: label.into(), verdict, percent: None, from: None, text: Label::default(), tags: Tags::default() }
    }

    /// Sets the length of the bar in percent of the limit.
    #[must_use]
    pub const fn percent(mut self, percent: f64) -> Self {
        self.percent = Some(percent);
        self
    }

    /// Draws the part of the bar from this percentage on as uncertain: the limit is an estimate, and this is the
    /// percentage by its upper edge.
    #[must_use]
    pub const fn uncertain_from(mut self, percent: f64) -> Self {
        self.from = Some(percent);
        self
    }

    /// Sets the text at the right.
    #[must_use]
    pub fn text(mut self, text: impl Into<Label>) -> Self {
        self.text = text.into();
        self
    }
}

impl BarChart {
    /// Creates a chart without rows; the axis is that of the utilisation in percent.
    #[must_use]
    pub fn new(axis: PlaneAxis) -> Self {
        Self { axis, title: Label::default(), description: String::new(), rows: Vec::new(), legend: Vec::new() }
    }

    titled!();

    /// Adds a row.
    #[must_use]
    pub fn bar(mut self, bar: Bar) -> Self {
        self.rows.push(bar);
        self
    }

    /// Explains the sign of a verdict below the chart.
    #[must_use]
    pub fn explain(mut self, verdict: Verdict, text: impl Into<Label>) -> Self {
        self.legend.push((verdict, text.into()));
        self
    }

    /// Draws the chart, higher than its style says if the rows need it.
    #[must_use]
    pub fn render(&self, style: &Style) -> Picture {
        let mut style = style.clone();
        let head = EDGE + title_height(&Canvas::new(&style), &self.title) + 2.0;
        let legend = self.legend_rows(style.size.width);
        let foot = X_BELOW + EDGE + rows_height(&legend);
        let columns = self.columns(&style);
        let laid: Vec<Laid> = self.rows.iter().map(|bar| Laid::of(bar, &columns)).collect();
        let extra: f64 = laid.iter().map(|row| row.extra).sum();
        let units: f64 = self.rows.iter().map(|_| 1.0).sum::<f64>().max(1.0);
        let row = ((style.size.height - head - foot - extra) / units).clamp(ROW_MIN, ROW_MAX);
        style.size.height = row.mul_add(units, extra + head + foot);
        let style = &style;
        let mut canvas = Canvas::new(style);
        let (left, right) = (columns.left, columns.right);
        let area = Rect { left, right, top: head, bottom: row.mul_add(units, extra + head) };
        let ticks = Ticks::new(0.0, self.end(), 6, false);
        title(&mut canvas, &self.title);
        // Grid lines must not run through texts that stand above their bars.
        let lined = Rect { top: if columns.beside { area.top } else { area.bottom - 3.0 }, ..area };
        self.grid(&mut canvas, &lined, &ticks);
        let limit = x_at(&area, 100.0, ticks.hi);
        let mut top = head;
        for (bar, laid) in self.rows.iter().zip(&laid) {
            let height = row + laid.extra;
            draw_bar(&mut canvas, bar, laid, &columns, (top, height), ticks.hi);
            top += height;
        }
        canvas.line((limit, lined.top), (limit, area.bottom + TICK), &Stroke::solid(Colour::Ink, 1.6));
        let (title, size) = self.axis.title_within(0, area.right - EDGE);
        canvas.text((area.right, area.bottom + X_TITLE), &title, Setting::new(size, Colour::Ink, Anchor::End));
        draw_legend(&mut canvas, &legend, area.bottom + X_BELOW + 4.0);
        canvas.finish("bars", &self.title.plain(), &self.description)
    }

    /// Returns the end of the axis: a little beyond the longest bar, within limits.
    fn end(&self) -> f64 {
        let longest = self.rows.iter().filter_map(Bar::length).fold(0.0, f64::max);
        (longest * 1.05).clamp(110.0, LONGEST)
    }

    /// Returns the places of labels, bars and texts: in columns, or one above the other in a narrow picture.
    fn columns(&self, style: &Style) -> Columns {
        let width = style.size.width;
        if width < BESIDE_MIN {
            let (left, right) = (EDGE + SIGN, width - EDGE);
            return Columns { beside: false, left, right, labels: right - left, texts: right - left, width };
        }
        let widest = |of: fn(&Bar) -> f64| self.rows.iter().map(of).fold(0.0, f64::max);
        let labels = widest(|bar| bar.label.width(TEXT, false)).min(width * 0.42);
        let texts = widest(|bar| bar.text.width(TEXT, bar.verdict == Verdict::Fail)).min(width * 0.32);
        let left = EDGE + SIGN + labels + GAP;
        let right = (width - EDGE - texts - GAP).max(left + 30.0);
        Columns { beside: true, left, right, labels, texts, width }
    }

    fn grid(&self, canvas: &mut Canvas<'_>, area: &Rect, ticks: &Ticks) {
        canvas.open("axis x");
        let mut until = f64::NEG_INFINITY;
        for value in &ticks.values {
            let x = x_at(area, *value, ticks.hi);
            canvas.line((x, area.top), (x, area.bottom), &Stroke::solid(Colour::Grid, HAIR));
            canvas.line((x, area.bottom), (x, area.bottom + TICK), &Stroke::solid(Colour::Ink, RULE));
            let label = Label::from(ticks.label(*value, canvas.style.language));
            let half = label.width(TEXT, false) / 2.0;
            // On a narrow chart the number of the limit is kept and others are left out.
            let kept = ticks.values.len() < 3 || x - half > until + GAP / 2.0;
            if kept {
                until = x + half;
                canvas.text((x, area.bottom + X_LABELS), &label, Setting::new(TEXT, Colour::Ink, Anchor::Middle));
            }
        }
        canvas.line((area.left, area.bottom), (area.right, area.bottom), &Stroke::solid(Colour::Ink, RULE));
        canvas.line((area.left, area.top), (area.left, area.bottom), &Stroke::solid(Colour::Ink, RULE));
        canvas.close();
    }

    /// Returns the explained verdicts in rows, each with its place from the left and its text in lines.
    fn legend_rows(&self, width: f64) -> Vec<Vec<(f64, Verdict, Vec<Label>)>> {
        let mut rows: Vec<Vec<(f64, Verdict, Vec<Label>)>> = Vec::new();
        let mut x = f64::INFINITY;
        for (verdict, label) in &self.legend {
            let lines = label.wrapped(width - 2.0 * EDGE - SIGN, TEXT, false);
            let wide = SIGN + lines.iter().map(|line| line.width(TEXT, false)).fold(0.0, f64::max);
            if x + wide > width - EDGE {
                rows.push(Vec::new());
                x = EDGE;
            }
            if let Some(row) = rows.last_mut() {
                row.push((x, *verdict, lines));
            }
            x += wide + 18.0;
        }
        rows
    }
}

/// Places of labels, bars and texts.
struct Columns {
    /// Columns for labels, bars and texts; otherwise the bar is below its texts.
    beside: bool,
    /// Left and right end of the bars.
    left: f64,
    right: f64,
    /// Widths of labels and of texts.
    labels: f64,
    texts: f64,
    /// Width of the picture.
    width: f64,
}

/// Label and text of a row in lines, and their height beyond one line.
struct Laid {
    label: Vec<Label>,
    text: Vec<Label>,
    extra: f64,
}

impl Laid {
    fn of(bar: &Bar, columns: &Columns) -> Self {
        let count = |lines: &[Label]| lines.iter().map(|_| 1.0).sum::<f64>();
        let bold = bar.verdict == Verdict::Fail;
        let label = bar.label.wrapped(columns.labels + ROUNDING, TEXT, false);
        let text = bar.text.wrapped(columns.texts + ROUNDING, TEXT, bold);
        let extra = if columns.beside {
            LINE * (count(&label).max(count(&text)) - 1.0).max(0.0)
        } else if one_line(&label, &text, columns, bold) {
            LINE
        } else {
            LINE * (count(&label) + count(&text))
        };
        Self { label, text, extra }
    }
}

/// Returns `true` if label and text fit into one line above their bar.
fn one_line(label: &[Label], text: &[Label], columns: &Columns, bold: bool) -> bool {
    match (label, text) {
        ([_], []) => true,
        ([label], [text]) => label.width(TEXT, false) + text.width(TEXT, bold) + GAP <= columns.labels,
        _ => false,
    }
}

/// Utilisation in percent at which bars are broken.
const LONGEST: f64 = 150.0;
/// Width of the sign before a label.
const SIGN: f64 = 17.0;
const GAP: f64 = 10.0;
const ROW_MIN: f64 = 16.0;
const ROW_MAX: f64 = 23.0;
const LEGEND_ROW: f64 = 16.0;
/// Line spacing of a text.
const LINE: f64 = 13.5;
/// Width below which a picture has its labels above the bars.
const BESIDE_MIN: f64 = 400.0;
/// Tolerance for widths added in another order, which differ in the last digit.
const ROUNDING: f64 = 1e-6;

impl Bar {
    fn length(&self) -> Option<f64> {
        self.percent.filter(|percent| percent.is_finite()).map(|percent| percent.max(0.0))
    }
}

impl Verdict {
    const fn class(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::Advice => "advice",
            Self::Fail => "fail",
            Self::NotChecked => "not-checked",
            Self::NoLimit => "no-limit",
        }
    }

    const fn colour(self) -> Colour {
        match self {
            Self::Pass => Colour::Pass,
            Self::Advice => Colour::Advice,
            Self::Fail => Colour::Fail,
            Self::NotChecked | Self::NoLimit => Colour::Unchecked,
        }
    }
}

fn x_at(area: &Rect, percent: f64, hi: f64) -> f64 {
    (percent / hi).mul_add(area.width(), area.left)
}

fn draw_bar(canvas: &mut Canvas<'_>, bar: &Bar, laid: &Laid, columns: &Columns, (top, height): (f64, f64), hi: f64) {
    let dropped = usize::from(bar.percent.is_some_and(|percent| !percent.is_finite()));
    canvas.open_item(&format!("bar {}", bar.verdict.class()), &bar.tags, &bar.label, dropped);
    let fail = bar.verdict == Verdict::Fail;
    let (ink, soft) = (Colour::Ink, if bar.verdict == Verdict::NotChecked { Colour::Soft } else { Colour::Ink });
    let text = |anchor: Anchor| {
        let setting = Setting::new(TEXT, soft, anchor);
        if fail { setting.bold() } else { setting }
    };
    let row = height - laid.extra;
    let base_of = |middle: f64| TEXT.mul_add(CAP_HEIGHT / 2.0, middle);
    let middle = if columns.beside {
        let middle = top + height / 2.0;
        draw_sign(canvas, bar.verdict, (EDGE + 5.0, middle));
        let first = |lines: &[Label]| base_of(middle) - (lines.iter().map(|_| LINE).sum::<f64>() - LINE).max(0.0) / 2.0;
        let start = Setting::new(TEXT, ink, Anchor::Start);
        write_lines(canvas, &laid.label, (EDGE + SIGN, first(&laid.label)), start);
        write_lines(canvas, &laid.text, (columns.width - EDGE, first(&laid.text)), text(Anchor::End));
        middle
    } else {
        let first = top + LINE / 2.0 + 3.0;
        draw_sign(canvas, bar.verdict, (EDGE + 5.0, first));
        let start = Setting::new(TEXT, ink, Anchor::Start);
        let below = write_lines(canvas, &laid.label, (EDGE + SIGN, base_of(first)), start);
        if one_line(&laid.label, &laid.text, columns, fail) {
            write_lines(canvas, &laid.text, (columns.right, base_of(first)), text(Anchor::End));
        } else {
            write_lines(canvas, &laid.text, (EDGE + SIGN, below), text(Anchor::Start));
        }
        top + laid.extra + row / 2.0 + 1.0
    };
    let thick = (row * 0.58).min(13.0);
    let lane =
        Rect { left: columns.left, right: columns.right, top: middle - thick / 2.0, bottom: middle + thick / 2.0 };
    match (bar.verdict, bar.length()) {
        (Verdict::NotChecked, _) => {
            let fill = canvas.hatch(Colour::Unchecked, Hatch::Dots);
            canvas.rect(&lane, 0.0, &fill, None);
        }
        // Judged without a ratio: sign and text show the verdict.
        (_, None) => {}
        (verdict, Some(percent)) => {
            // At least a pixel, so that a bar of zero is visible.
            let end = x_at(&lane, percent.min(hi), hi).max(lane.left + 1.0);
            let drawn = Rect { right: end, ..lane };
            let colour = verdict.colour();
            match verdict {
                Verdict::Advice | Verdict::Fail => {
                    let hatch = if verdict == Verdict::Fail { Hatch::Crossed } else { Hatch::Rising };
                    let lines = canvas.hatch(colour, hatch);
                    canvas.rect(&drawn, 0.0, &Fill::Flat(colour, 0.3), None);
                    canvas.rect(&drawn, 0.0, &lines, Some(&Stroke::solid(colour, RULE)));
                }
                Verdict::Pass | Verdict::NotChecked | Verdict::NoLimit => {
                    canvas.rect(&drawn, 0.0, &Fill::Flat(colour, 0.85), Some(&Stroke::solid(colour, RULE)));
                }
            }
            if let Some(from) = bar.from {
                draw_band(canvas, (x_at(&lane, from.clamp(0.0, hi), hi), drawn.right), middle);
            }
            if percent > hi {
                draw_break(canvas, &drawn);
            }
        }
    }
    if !columns.beside {
        canvas.line((lane.left, lane.top), (lane.left, lane.bottom), &Stroke::solid(Colour::Ink, RULE));
        let limit = x_at(&lane, 100.0, hi);
        canvas.line((limit, lane.top), (limit, lane.bottom + 2.0), &Stroke::solid(Colour::Ink, 1.6));
    }
    canvas.close();
}

/// Writes lines one below the other; returns the base line of the next.
fn write_lines(canvas: &mut Canvas<'_>, lines: &[Label], (x, mut base): Point, setting: Setting) -> f64 {
    for line in lines {
        canvas.text((x, base), line, setting);
        base += LINE;
    }
    base
}

/// Draws the sign of a verdict around a point.
fn draw_sign(canvas: &mut Canvas<'_>, verdict: Verdict, (x, y): Point) {
    let line = |corners: &[(f64, f64)]| {
        let mut d = String::new();
        for (index, (dx, dy)) in corners.iter().enumerate() {
            d.push_str(&format!("{}{} {}", if index == 0 { 'M' } else { 'L' }, number(x + dx), number(y + dy)));
        }
        d
    };
    let colour = verdict.colour();
    let pen = Stroke::solid(colour, 1.8);
    match verdict {
        Verdict::Pass => canvas.path(&line(&[(-4.2, 0.2), (-1.2, 3.4), (4.4, -3.6)]), &Fill::None, Some(&pen)),
        Verdict::Fail => {
            let d = line(&[(-3.6, -3.6), (3.6, 3.6)]) + &line(&[(-3.6, 3.6), (3.6, -3.6)]);
            canvas.path(&d, &Fill::None, Some(&pen));
        }
        Verdict::Advice => {
            let d = line(&[(0.0, -4.6), (5.0, 4.0), (-5.0, 4.0)]) + "Z";
            canvas.path(&d, &Fill::Flat(colour, 1.0), Some(&Stroke::solid(colour, RULE)));
            let mark = line(&[(0.0, -1.8), (0.0, 1.2)]) + &line(&[(0.0, 2.2), (0.0, 3.2)]);
            canvas.path(&mark, &Fill::None, Some(&Stroke::solid(Colour::Paper, 1.2)));
        }
        Verdict::NoLimit => canvas.path(&line(&[(-3.6, 0.0), (3.6, 0.0)]), &Fill::None, Some(&pen)),
        Verdict::NotChecked => {
            let d = format!("M{} {}a3.6 3.6 0 1 0 7.2 0a3.6 3.6 0 1 0 -7.2 0Z", number(x - 3.6), number(y));
            let pen = Stroke { colour, width: 1.3, dash: "2 1.4" };
            canvas.path(&d, &Fill::None, Some(&pen));
        }
    }
}

/// Draws the band of an estimate along the middle of a bar: a line with a stop at either end, on a lighter ground.
fn draw_band(canvas: &mut Canvas<'_>, (left, right): (f64, f64), middle: f64) {
    for (colour, width) in [(Colour::Paper, 3.2), (Colour::Ink, 1.2)] {
        let pen = Stroke::solid(colour, width);
        canvas.line((left, middle), (right, middle), &pen);
        for x in [left, right] {
            canvas.line((x, middle - 3.0), (x, middle + 3.0), &pen);
        }
    }
}

/// Draws two slanted strokes through a bar that continues beyond its drawn end.
fn draw_break(canvas: &mut Canvas<'_>, bar: &Rect) {
    let (top, bottom) = (bar.top - 2.0, bar.bottom + 2.0);
    let x = bar.right - 16.0;
    let slant = 5.0;
    let gap = format!(
        "M{} {}L{} {}H{}L{} {}Z",
        number(x),
        number(bottom),
        number(x + slant),
        number(top),
        number(x + slant + 4.5),
        number(x + 4.5),
        number(bottom)
    );
    canvas.path(&gap, &Fill::Flat(Colour::Paper, 1.0), None);
    for x in [x, x + 4.5] {
        canvas.line((x, bottom), (x + slant, top), &Stroke::solid(Colour::Ink, RULE));
    }
}

/// Returns the height of the rows of the legend.
fn rows_height(rows: &[Vec<(f64, Verdict, Vec<Label>)>]) -> f64 {
    rows.iter().map(|row| row_height(row)).sum()
}

fn row_height(row: &[(f64, Verdict, Vec<Label>)]) -> f64 {
    row.iter().map(|(.., lines)| lines.iter().map(|_| LEGEND_ROW).sum::<f64>()).fold(LEGEND_ROW, f64::max)
}

fn draw_legend(canvas: &mut Canvas<'_>, rows: &[Vec<(f64, Verdict, Vec<Label>)>], top: f64) {
    if rows.is_empty() {
        return;
    }
    canvas.open("legend");
    let mut y = top + LEGEND_ROW / 2.0;
    for row in rows {
        for (x, verdict, lines) in row {
            draw_sign(canvas, *verdict, (x + 5.0, y));
            let at = (x + SIGN, TEXT.mul_add(CAP_HEIGHT / 2.0, y));
            write_lines(canvas, lines, at, Setting::new(TEXT, Colour::Ink, Anchor::Start));
        }
        y += row_height(row);
    }
    canvas.close();
}
