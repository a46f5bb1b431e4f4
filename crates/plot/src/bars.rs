//! Utilisation of limits as horizontal bars.

use crate::canvas::{Anchor, Canvas, Fill, HAIR, Hatch, RULE, Setting, Stroke, TEXT, number};
use crate::font::CAP_HEIGHT;
use crate::geometry::{Point, Rect};
use crate::item::{Tags, tagged};
use crate::label::Label;
use crate::picture::Picture;
use crate::plane::{Axis, EDGE, TICK, X_BELOW, X_LABELS, X_TITLE};
use crate::style::{Colour, Style};
use crate::ticks::Ticks;
use crate::xy::{title, title_height};

/// Bars against a limit of 100 %, one row for each check.
#[derive(Clone, Debug, PartialEq)]
pub struct BarChart {
    axis: Axis,
    title: Label,
    description: String,
    rows: Vec<Row>,
    legend: Vec<(Verdict, Label)>,
    longest: f64,
}

#[derive(Clone, Debug, PartialEq)]
enum Row {
    Heading(Label),
    Bar(Bar),
}

/// What was found, which decides colour, pattern and sign of a bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// Within the limit: filled, a tick.
    Pass,
    /// Within the limit but worth a thought: rising lines, a triangle.
    Advice,
    /// Beyond the limit: crossed lines, a cross.
    Fail,
    /// Not known: no bar, an empty circle.
    NotChecked,
}

/// One row: a label, a bar, a text.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    label: Label,
    verdict: Verdict,
    percent: Option<f64>,
    text: Label,
    tags: Tags,
}
tagged!(Bar);

impl Bar {
    /// A row without a bar yet.
    #[must_use]
    pub fn new(label: impl Into<Label>, verdict: Verdict) -> Self {
        Self { label: label.into(), verdict, percent: None, text: Label::default(), tags: Tags::default() }
    }

    /// Sets the length of the bar in percent of the limit.
    #[must_use]
    pub const fn percent(mut self, percent: f64) -> Self {
        self.percent = Some(percent);
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
    /// A chart without rows; the axis is that of the utilisation in percent.
    #[must_use]
    pub fn new(axis: Axis) -> Self {
        Self {
            axis,
            title: Label::default(),
            description: String::new(),
            rows: Vec::new(),
            legend: Vec::new(),
            longest: 150.0,
        }
    }

    /// Sets the title above the chart, which also names it to a screen reader.
    #[must_use]
    pub fn title(mut self, title: impl Into<Label>) -> Self {
        self.title = title.into();
        self
    }

    /// Sets what a screen reader tells of the chart.
    #[must_use]
    pub fn description(mut self, text: &str) -> Self {
        text.clone_into(&mut self.description);
        self
    }

    /// Sets where bars are broken, 150 % unless set; at least 110 %.
    #[must_use]
    pub const fn longest(mut self, percent: f64) -> Self {
        // A comparison that NaN fails too.
        self.longest = if percent >= 110.0 && percent <= 1e6 { percent } else { 110.0 };
        self
    }

    /// Starts a group of rows.
    #[must_use]
    pub fn heading(mut self, label: impl Into<Label>) -> Self {
        self.rows.push(Row::Heading(label.into()));
        self
    }

    /// Adds a row.
    #[must_use]
    pub fn bar(mut self, bar: Bar) -> Self {
        self.rows.push(Row::Bar(bar));
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
        let foot = X_BELOW + EDGE + legend.iter().map(|_| LEGEND_ROW).sum::<f64>();
        let units: f64 = self.rows.iter().map(Row::height).sum::<f64>().max(1.0);
        let row = ((style.size.height - head - foot) / units).clamp(ROW_MIN, ROW_MAX);
        style.size.height = row.mul_add(units, head + foot);
        let style = &style;
        let mut canvas = Canvas::new(style);
        let area = self.area(style, head, row.mul_add(units, head));
        let ticks = Ticks::new(0.0, self.end(), 6, false);
        title(&mut canvas, &self.title);
        self.grid(&mut canvas, &area, &ticks);
        let mut top = head;
        for entry in &self.rows {
            let height = row * entry.height();
            match entry {
                Row::Heading(label) => {
                    let label = label.elided(style.size.width - 2.0 * EDGE, TEXT, true);
                    let at = (EDGE, TEXT.mul_add(-0.3, top + height));
                    canvas.text(at, &label, Setting::new(TEXT, Colour::Ink, Anchor::Start).bold());
                }
                Row::Bar(bar) => self.draw_bar(&mut canvas, bar, &area, (top, height), ticks.hi),
            }
            top += height;
        }
        let limit = x_at(&area, 100.0, ticks.hi);
        canvas.line((limit, area.top), (limit, area.bottom + TICK), &Stroke::solid(Colour::Ink, 1.6));
        let title = self.axis.title(0).elided(area.right - EDGE, crate::canvas::AXIS, false);
        let setting = Setting::new(crate::canvas::AXIS, Colour::Ink, Anchor::End);
        canvas.text((area.right, area.bottom + X_TITLE), &title, setting);
        draw_legend(&mut canvas, &legend, area.bottom + X_BELOW + 4.0);
        canvas.finish("bars", &self.title.plain(), &self.description)
    }

    fn bars(&self) -> impl Iterator<Item = &Bar> {
        self.rows.iter().filter_map(|row| match row {
            Row::Bar(bar) => Some(bar),
            Row::Heading(_) => None,
        })
    }

    /// The end of the axis: a little beyond the longest bar, within bounds.
    fn end(&self) -> f64 {
        let longest = self.bars().filter_map(Bar::length).fold(0.0, f64::max);
        (longest * 1.05).clamp(110.0, self.longest)
    }

    /// The area of the bars between the labels and the texts.
    fn area(&self, style: &Style, top: f64, bottom: f64) -> Rect {
        let width = style.size.width;
        let widest = |of: fn(&Bar) -> f64| self.bars().map(of).fold(0.0, f64::max);
        let labels = widest(|bar| bar.label.width(TEXT, false)).min(width * 0.42);
        let texts = widest(|bar| bar.text.width(TEXT, bar.verdict == Verdict::Fail)).min(width * 0.32);
        let left = EDGE + SIGN + labels + GAP;
        let right = (width - EDGE - texts - GAP).max(left + 30.0);
        Rect { left, right, top, bottom }
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
            // On a narrow chart the limit keeps its number, others give way.
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

    fn draw_bar(&self, canvas: &mut Canvas<'_>, bar: &Bar, area: &Rect, (top, height): (f64, f64), hi: f64) {
        let dropped = usize::from(bar.percent.is_some_and(|percent| !percent.is_finite()));
        canvas.open_item(&format!("bar {}", bar.verdict.class()), &bar.tags, &bar.label, dropped);
        let middle = top + height / 2.0;
        let base = TEXT.mul_add(CAP_HEIGHT / 2.0, middle);
        draw_sign(canvas, bar.verdict, (EDGE + 5.0, middle));
        let label = bar.label.elided(area.left - GAP - EDGE - SIGN + ROUNDING, TEXT, false);
        canvas.text((EDGE + SIGN, base), &label, Setting::new(TEXT, Colour::Ink, Anchor::Start));
        let thick = (height * 0.58).min(13.0);
        let lane = Rect { left: area.left, right: area.right, top: middle - thick / 2.0, bottom: middle + thick / 2.0 };
        match (bar.verdict, bar.length()) {
            (Verdict::NotChecked, _) => {
                let fill = canvas.hatch(Colour::Unchecked, Hatch::Dots);
                canvas.rect(&lane, 0.0, &fill, None);
            }
            // Decided, but by no ratio: sign and text tell it.
            (_, None) => {}
            (verdict, Some(percent)) => {
                // A pixel at least: a bar of nothing is still a bar.
                let end = x_at(area, percent.min(hi), hi).max(area.left + 1.0);
                let drawn = Rect { right: end, ..lane };
                let colour = verdict.colour();
                match verdict {
                    Verdict::Advice | Verdict::Fail => {
                        let hatch = if verdict == Verdict::Fail { Hatch::Crossed } else { Hatch::Rising };
                        let lines = canvas.hatch(colour, hatch);
                        canvas.rect(&drawn, 0.0, &Fill::Flat(colour, 0.3), None);
                        canvas.rect(&drawn, 0.0, &lines, Some(&Stroke::solid(colour, RULE)));
                    }
                    Verdict::Pass | Verdict::NotChecked => {
                        canvas.rect(&drawn, 0.0, &Fill::Flat(colour, 0.85), Some(&Stroke::solid(colour, RULE)));
                    }
                }
                if percent > hi {
                    draw_break(canvas, &drawn);
                }
            }
        }
        let room = canvas.style.size.width - EDGE - area.right - GAP + ROUNDING;
        let fail = bar.verdict == Verdict::Fail;
        let colour = if bar.verdict == Verdict::NotChecked { Colour::Soft } else { Colour::Ink };
        let setting = Setting::new(TEXT, colour, Anchor::End);
        let text = bar.text.elided(room, TEXT, fail);
        canvas.text((canvas.style.size.width - EDGE, base), &text, if fail { setting.bold() } else { setting });
        canvas.close();
    }

    /// The explained verdicts in rows, each with its place from the left.
    fn legend_rows(&self, width: f64) -> Vec<Vec<(f64, Verdict, Label)>> {
        let mut rows: Vec<Vec<(f64, Verdict, Label)>> = Vec::new();
        let mut x = f64::INFINITY;
        for (verdict, label) in &self.legend {
            let label = label.elided(width - 2.0 * EDGE - SIGN, TEXT, false);
            let wide = SIGN + label.width(TEXT, false);
            if x + wide > width - EDGE {
                rows.push(Vec::new());
                x = EDGE;
            }
            if let Some(row) = rows.last_mut() {
                row.push((x, *verdict, label));
            }
            x += wide + 18.0;
        }
        rows
    }
}

/// Room of a sign before a label.
const SIGN: f64 = 17.0;
const GAP: f64 = 10.0;
const ROW_MIN: f64 = 16.0;
const ROW_MAX: f64 = 23.0;
const LEGEND_ROW: f64 = 16.0;
/// A width added up in another order differs in the last digit.
const ROUNDING: f64 = 1e-6;

impl Row {
    /// Height in rows: a heading has some room above.
    const fn height(&self) -> f64 {
        match self {
            Self::Heading(_) => 1.35,
            Self::Bar(_) => 1.0,
        }
    }
}

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
        }
    }

    const fn colour(self) -> Colour {
        match self {
            Self::Pass => Colour::Pass,
            Self::Advice => Colour::Advice,
            Self::Fail => Colour::Fail,
            Self::NotChecked => Colour::Unchecked,
        }
    }
}

fn x_at(area: &Rect, percent: f64, hi: f64) -> f64 {
    (percent / hi).mul_add(area.width(), area.left)
}

/// The sign of a verdict around a point.
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
        Verdict::NotChecked => {
            let d = format!("M{} {}a3.6 3.6 0 1 0 7.2 0a3.6 3.6 0 1 0 -7.2 0Z", number(x - 3.6), number(y));
            let pen = Stroke { colour, width: 1.3, dash: "2 1.4" };
            canvas.path(&d, &Fill::None, Some(&pen));
        }
    }
}

/// Two slanted strokes through a bar that goes on beyond its drawn end.
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

fn draw_legend(canvas: &mut Canvas<'_>, rows: &[Vec<(f64, Verdict, Label)>], top: f64) {
    if rows.is_empty() {
        return;
    }
    canvas.open("legend");
    let mut y = top + LEGEND_ROW / 2.0;
    for row in rows {
        for (x, verdict, label) in row {
            draw_sign(canvas, *verdict, (x + 5.0, y));
            let at = (x + SIGN, TEXT.mul_add(CAP_HEIGHT / 2.0, y));
            canvas.text(at, label, Setting::new(TEXT, Colour::Ink, Anchor::Start));
        }
        y += LEGEND_ROW;
    }
    canvas.close();
}
