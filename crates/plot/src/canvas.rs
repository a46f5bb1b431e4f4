//! The SVG text: elements, paint, patterns, escaping. No other module writes SVG.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use crate::font::{ASCENT, DESCENT, FONT_FAMILY};
use crate::geometry::Rect;
use crate::item::Tags;
use crate::label::{Label, RunKind, TextRun, is_drawable};
use crate::number::number;
use crate::picture::{Picture, TextBox};
use crate::style::{Colour, Hatch, Style, Theme};

/// Font sizes in px at 96 px to the inch; the smallest is 7 pt.
pub(crate) const TITLE: f64 = 15.0;
pub(crate) const AXIS: f64 = 12.0;
pub(crate) const TEXT: f64 = 10.8;

pub(crate) const HAIR: f64 = 0.6;
pub(crate) const RULE: f64 = 1.0;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// Layout of a text.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Setting {
    pub(crate) size: f64,
    pub(crate) bold: bool,
    pub(crate) colour: Colour,
    pub(crate) anchor: Anchor,
    /// Outline in the colour of the paper around the letters, for text on top of lines.
    pub(crate) halo: bool,
}

impl Setting {
    pub(crate) const fn new(size: f64, colour: Colour, anchor: Anchor) -> Self {
        Self { size, bold: false, colour, anchor, halo: false }
    }

    pub(crate) const fn bold(self) -> Self {
        Self { bold: true, ..self }
    }

    pub(crate) const fn halo(self) -> Self {
        Self { halo: true, ..self }
    }
}

/// Style of a line.
#[derive(Clone, Debug)]
pub(crate) struct Stroke {
    pub(crate) colour: Colour,
    pub(crate) width: f64,
    pub(crate) dash: &'static str,
}

impl Stroke {
    pub(crate) const fn solid(colour: Colour, width: f64) -> Self {
        Self { colour, width, dash: "" }
    }
}

/// Filling of an area.
#[derive(Clone, Debug)]
pub(crate) enum Fill {
    None,
    Flat(Colour, f64),
    Pattern(String),
}

pub(crate) struct Canvas<'a> {
    pub(crate) style: &'a Style,
    out: String,
    patterns: BTreeMap<String, String>,
    texts: Vec<TextBox>,
    hidden: Vec<String>,
    dropped: usize,
}

impl<'a> Canvas<'a> {
    pub(crate) const fn new(style: &'a Style) -> Self {
        Self { style, out: String::new(), patterns: BTreeMap::new(), texts: Vec::new(), hidden: Vec::new(), dropped: 0 }
    }

    /// Records a label that found no free place.
    pub(crate) fn hide(&mut self, label: &Label) {
        self.hidden.push(label.plain());
    }

    pub(crate) fn open(&mut self, class: &str) {
        let _ = writeln!(self.out, "<g class=\"{}\">", escaped(class));
    }

    /// Opens the group of an item of the caller, with its class, data and tooltip.
    pub(crate) fn open_item(&mut self, kind: &str, tags: &Tags, label: &Label, dropped: usize) {
        let class = if tags.class.is_empty() { kind.to_owned() } else { format!("{kind} {}", tags.class) };
        let _ = write!(self.out, "<g class=\"{}\"", escaped(&class));
        if !label.is_empty() {
            let _ = write!(self.out, " data-label=\"{}\"", escaped(&label.plain()));
        }
        for (key, value) in &tags.data {
            let _ = write!(self.out, " data-{key}=\"{}\"", escaped(value));
        }
        if dropped > 0 {
            let _ = write!(self.out, " data-dropped=\"{dropped}\"");
            self.dropped += dropped;
        }
        self.out.push('>');
        let tooltip = tags.tooltip.clone().unwrap_or_else(|| label.plain());
        if !tooltip.is_empty() {
            let _ = write!(self.out, "<title>{}</title>", escaped(&tooltip));
        }
        self.out.push('\n');
    }

    /// Opens a group with the scale from pixels to values, for scripts.
    pub(crate) fn open_plane(
        &mut self,
        class: &str,
        area: &Rect,
        (x, y): ((f64, f64), (f64, f64)),
        (symbol, unit): (&str, &str),
    ) {
        // Adding zero removes the sign of a negative zero, on which machines differ.
        let [x_min, x_max, y_min, y_max] = [x.0, x.1, y.0, y.1].map(|bound| bound + 0.0);
        let _ = writeln!(
            self.out,
            "<g class=\"{class}\" data-left=\"{}\" data-right=\"{}\" data-top=\"{}\" data-bottom=\"{}\" \
             data-x-min=\"{x_min:e}\" data-x-max=\"{x_max:e}\" data-y-min=\"{y_min:e}\" data-y-max=\"{y_max:e}\" data-symbol=\"{}\" data-unit=\"{}\">",
            number(area.left),
            number(area.right),
            number(area.top),
            number(area.bottom),
            escaped(symbol),
            escaped(unit)
        );
    }

    pub(crate) fn close(&mut self) {
        self.out.push_str("</g>\n");
    }

    pub(crate) fn path(&mut self, d: &str, fill: &Fill, stroke: Option<&Stroke>) {
        if d.is_empty() {
            return;
        }
        let _ = write!(self.out, "<path d=\"{d}\"");
        self.paint(fill, stroke);
        self.out.push_str("/>\n");
    }

    pub(crate) fn line(&mut self, from: (f64, f64), to: (f64, f64), stroke: &Stroke) {
        let d = format!("M{} {}L{} {}", number(from.0), number(from.1), number(to.0), number(to.1));
        self.path(&d, &Fill::None, Some(stroke));
    }

    pub(crate) fn rect(&mut self, area: &Rect, radius: f64, fill: &Fill, stroke: Option<&Stroke>) {
        let _ = write!(
            self.out,
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"",
            number(area.left),
            number(area.top),
            number(area.width().max(0.0)),
            number(area.height().max(0.0))
        );
        if radius > 0.0 {
            let _ = write!(self.out, " rx=\"{}\"", number(radius));
        }
        self.paint(fill, stroke);
        self.out.push_str("/>\n");
    }

    fn paint(&mut self, fill: &Fill, stroke: Option<&Stroke>) {
        match fill {
            Fill::None => self.out.push_str(" fill=\"none\""),
            Fill::Flat(colour, opacity) => {
                let _ = write!(self.out, " fill=\"{}\"", self.style.theme.colour(*colour));
                if *opacity < 1.0 {
                    let _ = write!(self.out, " fill-opacity=\"{}\"", number(*opacity));
                }
            }
            Fill::Pattern(id) => {
                let _ = write!(self.out, " fill=\"url(#{id})\"");
            }
        }
        if let Some(stroke) = stroke {
            let colour = self.style.theme.colour(stroke.colour);
            let _ = write!(self.out, " stroke=\"{colour}\" stroke-width=\"{}\"", number(stroke.width));
            if !stroke.dash.is_empty() {
                let _ = write!(self.out, " stroke-dasharray=\"{}\"", stroke.dash);
            }
        }
    }

    /// Returns a fill of lines, defined once for all of its uses.
    pub(crate) fn hatch(&mut self, colour: Colour, hatch: Hatch) -> Fill {
        let paint = self.style.theme.colour(colour);
        let name = match hatch {
            Hatch::Rising => "rising",
            Hatch::Falling => "falling",
            Hatch::Crossed => "crossed",
            Hatch::Dots => "dots",
        };
        let tint: String = Theme::Light.colour(colour).trim_start_matches('#').to_owned();
        let id = format!("{}-{name}-{tint}", self.style.id);
        let lines = |d: &str| format!("<path d=\"{d}\" fill=\"none\" stroke=\"{paint}\" stroke-width=\"0.8\"/>");
        // Steeper than 45°, a common slope of limits: a pattern parallel to them would be hard to see.
        let (shape, turn) = match hatch {
            Hatch::Rising => (lines("M2.5 0V5"), 28),
            Hatch::Falling => (lines("M2.5 0V5"), -28),
            Hatch::Crossed => (lines("M2.5 0V5M0 2.5H5"), 28),
            Hatch::Dots => (format!("<circle cx=\"2.5\" cy=\"2.5\" r=\"0.75\" fill=\"{paint}\"/>"), 28),
        };
        let pattern = format!(
            "<pattern id=\"{id}\" width=\"5\" height=\"5\" patternUnits=\"userSpaceOnUse\" \
             patternTransform=\"rotate({turn})\">{shape}</pattern>\n"
        );
        self.patterns.insert(id.clone(), pattern);
        Fill::Pattern(id)
    }

    /// Writes a text with its anchor on the base line and records its box.
    ///
    /// Layout provides the room. If the picture is too small for that, the first text stays and the other is hidden:
    /// half a number is worse than none.
    pub(crate) fn text(&mut self, at: (f64, f64), label: &Label, setting: Setting) {
        if label.is_empty() {
            return;
        }
        let area = text_area(at, label, setting);
        let size = self.style.size;
        let sheet = Rect { left: 0.0, right: size.width, top: 0.0, bottom: size.height };
        if !sheet.holds(&area) || self.texts.iter().any(|text| text.area.overlaps(&area)) {
            self.hide(label);
            return;
        }
        self.texts.push(TextBox { area, text: label.plain() });
        let label = &label.clone().merged();
        // Each of several runs has its own position, so that a font of other widths moves none of them into the next.
        let whole = match label.runs.as_slice() {
            [only] if only.kind == RunKind::Plain => Some(only),
            _ => None,
        };
        let (x, anchor) = if whole.is_some() { (at.0, setting.anchor) } else { (area.left, Anchor::Start) };
        let _ = write!(self.out, "<text x=\"{}\" y=\"{}\"", number(x), number(at.1));
        match anchor {
            Anchor::Start => {}
            Anchor::Middle => self.out.push_str(" text-anchor=\"middle\""),
            Anchor::End => self.out.push_str(" text-anchor=\"end\""),
        }
        if let Some(run) = whole {
            self.out.push_str(&length(run, setting));
        }
        let theme = self.style.theme;
        let _ = write!(self.out, " font-size=\"{}\" fill=\"{}\"", number(setting.size), theme.colour(setting.colour));
        if setting.bold {
            self.out.push_str(" font-weight=\"600\"");
        }
        if setting.halo {
            let paper = theme.colour(Colour::Paper);
            let _ = write!(
                self.out,
                " stroke=\"{paper}\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\""
            );
        }
        self.out.push('>');
        match whole {
            Some(run) => self.out.push_str(&escaped(&run.text)),
            None => self.runs(label, (area.left, at.1), setting),
        }
        self.out.push_str("</text>\n");
    }

    fn runs(&mut self, label: &Label, (left, base): (f64, f64), setting: Setting) {
        let mut x = left;
        for run in &label.runs {
            let lowered = if run.kind == RunKind::Index { setting.size * 0.24 } else { 0.0 };
            let _ = write!(self.out, "<tspan x=\"{}\" y=\"{}\"", number(x), number(base + lowered));
            match run.kind {
                RunKind::Plain => {}
                RunKind::Symbol => self.out.push_str(" font-style=\"italic\" font-weight=\"400\""),
                RunKind::Index => {
                    let _ = write!(self.out, " font-size=\"{}\"", number(run.size(setting.size)));
                }
            }
            self.out.push_str(&length(run, setting));
            let _ = write!(self.out, ">{}</tspan>", escaped(&run.text));
            x += run.width(setting.size, setting.bold);
        }
    }

    /// Returns the whole picture, with the description for screen readers.
    pub(crate) fn finish(self, kind: &str, title: &str, description: &str) -> Picture {
        let size = self.style.size;
        let (written_width, written_height) = size.written();
        let (width, height) = (number(size.width), number(size.height));
        let id = &self.style.id;
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot {kind}\" width=\"{written_width}\" \
             height=\"{written_height}\" viewBox=\"0 0 {width} {height}\" \
             font-family=\"{FONT_FAMILY}, 'Helvetica Neue', Arial, sans-serif\" stroke-linejoin=\"round\" role=\"img\""
        );
        let mut named = Vec::new();
        if !title.is_empty() {
            named.push(format!("{id}-title"));
        }
        if !description.is_empty() {
            named.push(format!("{id}-desc"));
        }
        if !named.is_empty() {
            let _ = write!(svg, " aria-labelledby=\"{}\"", named.join(" "));
        }
        if self.dropped > 0 {
            let _ = write!(svg, " data-dropped=\"{}\"", self.dropped);
        }
        if !self.hidden.is_empty() {
            let _ = write!(svg, " data-hidden-labels=\"{}\"", self.hidden.len());
        }
        svg.push_str(">\n");
        if !title.is_empty() {
            let _ = writeln!(svg, "<title id=\"{id}-title\">{}</title>", escaped(title));
        }
        if !description.is_empty() {
            let _ = writeln!(svg, "<desc id=\"{id}-desc\">{}</desc>", escaped(description));
        }
        if !self.patterns.is_empty() {
            let patterns: String = self.patterns.values().map(String::as_str).collect();
            let _ = writeln!(svg, "<defs>\n{patterns}</defs>");
        }
        let paper = self.style.theme.colour(Colour::Paper);
        let _ = writeln!(svg, "<rect class=\"paper\" width=\"{width}\" height=\"{height}\" fill=\"{paper}\"/>");
        svg.push_str(&self.out);
        svg.push_str("</svg>\n");
        Picture {
            svg,
            width: size.width,
            height: size.height,
            dropped: self.dropped,
            hidden: self.hidden,
            texts: self.texts,
        }
    }
}

/// Number of characters up to which the width of a text is left to the font: another one differs by a pixel or two.
const SHORT: usize = 3;

/// Returns the attribute that fixes the width of a run at that of the layout for any font: the picture does not contain
/// the font.
fn length(run: &TextRun, setting: Setting) -> String {
    if run.text.chars().count() <= SHORT {
        return String::new();
    }
    let width = number(run.width(setting.size, setting.bold));
    format!(" textLength=\"{width}\" lengthAdjust=\"spacingAndGlyphs\"")
}

/// Returns the box of a text with its anchor on the base line.
pub(crate) fn text_area(at: (f64, f64), label: &Label, setting: Setting) -> Rect {
    let width = label.width(setting.size, setting.bold);
    let left = match setting.anchor {
        Anchor::Start => at.0,
        Anchor::Middle => at.0 - width / 2.0,
        Anchor::End => at.0 - width,
    };
    Rect { left, right: left + width, top: at.1 - setting.size * ASCENT, bottom: at.1 + setting.size * DESCENT }
}

/// Escapes a text for XML, in an element or an attribute.
pub(crate) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c if is_drawable(c) => out.push(c),
            _ => out.push(' '),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_of_xml_gets_through() {
        assert_eq!(escaped("a<b>&\"c'\u{7}\u{ffff}"), "a&lt;b&gt;&amp;&quot;c&#39;  ");
    }
}
