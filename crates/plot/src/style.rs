//! The house style: sizes, colours, theme.

use crate::number::number;
use quantities::Language;

/// Sign of the program as SVG, in the colours of light paper: the section of a hollow shaft with the ellipse that turns in it.
pub const LOGO: &str = include_str!("../logo.svg");

/// Style of a chart: size, theme and language.
#[derive(Clone, Debug, PartialEq)]
pub struct Style {
    pub(crate) size: Size,
    pub(crate) theme: Theme,
    pub(crate) language: Language,
    pub(crate) id: String,
}

impl Style {
    /// Creates the style of a light chart in English.
    #[must_use]
    pub fn new(size: Size) -> Self {
        Self { size, theme: Theme::Light, language: Language::default(), id: String::from("plot") }
    }

    /// Sets the theme.
    #[must_use]
    pub const fn theme(mut self, theme: Theme) -> Self {
        self.theme = theme;
        self
    }

    /// Sets the language, which decides between decimal point and comma.
    #[must_use]
    pub const fn language(mut self, language: Language) -> Self {
        self.language = language;
        self
    }

    /// Sets the prefix of every identifier in the SVG; two charts on one page need different ones.
    #[must_use]
    pub fn id(mut self, id: &str) -> Self {
        self.id = id.chars().filter(|c| c.is_ascii_alphanumeric() || *c == '-').collect();
        if !self.id.starts_with(|c: char| c.is_ascii_alphabetic()) {
            self.id.insert_str(0, "plot");
        }
        self
    }
}

/// Nominal size of a chart. Text has a fixed size, so a larger chart shows more, not larger.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    pub(crate) width: f64,
    pub(crate) height: f64,
    pub(crate) millimetres: bool,
}

/// CSS pixels per millimetre, 96 to the inch.
const PX_PER_MM: f64 = 96.0 / 25.4;
const WIDTH_MIN: f64 = 160.0;
const HEIGHT_MIN: f64 = 120.0;
const SIDE_MAX: f64 = 20_000.0;

impl Size {
    /// Creates a size on paper. A size too small for axes and text is increased.
    #[must_use]
    pub fn millimetres(width: f64, height: f64) -> Self {
        Self::of(width * PX_PER_MM, height * PX_PER_MM, true)
    }

    /// Creates a size on a screen, in CSS pixels. A size too small for axes and text is increased.
    #[must_use]
    pub fn pixels(width: f64, height: f64) -> Self {
        Self::of(width, height, false)
    }

    fn of(width: f64, height: f64, millimetres: bool) -> Self {
        let side = |value: f64, least: f64| if value.is_finite() { value.clamp(least, SIDE_MAX) } else { least };
        Self { width: side(width, WIDTH_MIN), height: side(height, HEIGHT_MIN), millimetres }
    }

    /// Returns the attributes `width` and `height` of the picture.
    pub(crate) fn written(self) -> (String, String) {
        let write = |px: f64| {
            if self.millimetres { format!("{}mm", number(px / PX_PER_MM)) } else { number(px) }
        };
        (write(self.width), write(self.height))
    }
}

/// Colours for paper, for a dark screen, or left to the style sheet of a page.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// Dark on white.
    #[default]
    Light,
    /// Light on dark.
    Dark,
    /// Every colour is a CSS variable with the light colour as fallback; see [`Theme::variables`].
    Css,
}

impl Theme {
    /// Returns the CSS declarations that give a page the colours of this theme, for charts drawn with [`Theme::Css`].
    #[must_use]
    pub fn variables(self) -> String {
        COLOURS
            .iter()
            .map(|(name, light, dark)| {
                let colour = if self == Self::Dark { dark } else { light };
                format!("--plot-{name}:{colour};")
            })
            .collect()
    }

    pub(crate) fn colour(self, name: Colour) -> String {
        let Some((name, light, dark)) = COLOURS.get(name.index()) else { return String::from("#888888") };
        match self {
            Self::Light => (*light).to_owned(),
            Self::Dark => (*dark).to_owned(),
            Self::Css => format!("var(--plot-{name},{light})"),
        }
    }
}

/// Meaning of an item, which decides its colour and, by default, its dashes and markers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// Limit of continuous duty: red, solid.
    Continuous,
    /// Limit of short-time duty: blue, long dashes.
    ShortTime,
    /// Course of a quantity, such as a cycle: black, solid.
    Trace,
    /// Secondary information: grey, dotted.
    Muted,
    /// One of several series of equal rank, from 0; repeats after six.
    Series(u8),
}

/// A colour of the house style by its index in [`COLOURS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Colour {
    Paper,
    Ink,
    Soft,
    Grid,
    Pass,
    Advice,
    Fail,
    Unchecked,
    Tone(Tone),
}

impl Colour {
    const fn index(self) -> usize {
        match self {
            Self::Paper => 0,
            Self::Ink => 1,
            Self::Soft | Self::Tone(Tone::Muted) => 2,
            Self::Grid => 3,
            Self::Tone(Tone::Continuous) => 4,
            Self::Tone(Tone::ShortTime) => 5,
            Self::Tone(Tone::Trace) => 6,
            Self::Pass => 7,
            Self::Advice => 8,
            Self::Fail => 9,
            Self::Unchecked => 10,
            Self::Tone(Tone::Series(number)) => 11 + (number % SERIES) as usize,
        }
    }
}

pub(crate) const SERIES: u8 = 6;

/// Name, colour on light, colour on dark. The series follow Okabe and Ito, whose colours differ for every kind of
/// colour vision; without their yellow, which is too faint for a line on white.
const COLOURS: [(&str, &str, &str); 17] = [
    ("paper", "#ffffff", "#15181d"),
    ("ink", "#1d2127", "#e6e8eb"),
    ("soft", "#626a75", "#9aa3ae"),
    ("grid", "#e2e5e9", "#2c323a"),
    ("continuous", "#c2182b", "#ff6f70"),
    ("short-time", "#0b57a4", "#6db3f8"),
    ("trace", "#14171b", "#f4f5f6"),
    ("pass", "#1f8a70", "#35b895"),
    ("advice", "#c07f00", "#f0b83a"),
    ("fail", "#c2182b", "#ff6f70"),
    ("unchecked", "#8a929d", "#7d8692"),
    ("series-0", "#0072b2", "#56b4e9"),
    ("series-1", "#d55e00", "#ff8f4a"),
    ("series-2", "#009e73", "#2fc79b"),
    ("series-3", "#b8629a", "#e39cc8"),
    ("series-4", "#b87b00", "#f2bd4b"),
    ("series-5", "#3b3f8f", "#a5a9f5"),
];

/// Lines of a pattern, distinct without colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Hatch {
    /// Rising lines.
    Rising,
    /// Falling lines.
    Falling,
    /// Rising and falling lines.
    Crossed,
    /// Dots.
    Dots,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_css_colour_falls_back_to_the_light_one() {
        assert_eq!(Theme::Css.colour(Colour::Ink), "var(--plot-ink,#1d2127)");
        assert_eq!(Theme::Dark.colour(Colour::Ink), "#e6e8eb");
        assert!(Theme::Dark.variables().starts_with("--plot-paper:#15181d;--plot-ink:#e6e8eb;"));
    }

    #[test]
    fn every_colour_has_its_own_name() {
        assert_eq!(Theme::Css.colour(Colour::Tone(Tone::Series(0))), "var(--plot-series-0,#0072b2)");
        assert_eq!(Theme::Css.colour(Colour::Tone(Tone::Series(11))), "var(--plot-series-5,#3b3f8f)");
        assert_eq!(Theme::Css.colour(Colour::Unchecked), "var(--plot-unchecked,#8a929d)");
    }

    /// Returns the contrast of two colours, 1 to 21, as WCAG 2 defines it.
    fn contrast(a: &str, b: &str) -> f64 {
        let luminance = |colour: &str| {
            let channel = |at: usize| {
                let value = f64::from(u8::from_str_radix(&colour[at..at + 2], 16).unwrap()) / 255.0;
                if value <= 0.03928 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
            };
            0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5)
        };
        let (a, b) = (luminance(a), luminance(b));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    /// Requires a contrast with the paper of 4.5 to 1 for text, and of 3 to 1 for lines and marks; the grid may be
    /// fainter.
    #[test]
    fn every_colour_stands_out_from_its_paper() {
        let (_, light_paper, dark_paper) = COLOURS[0];
        for (name, light, dark) in COLOURS.iter().skip(1).filter(|(name, ..)| *name != "grid") {
            let least = if matches!(*name, "ink" | "soft") { 4.5 } else { 3.0 };
            for (colour, paper) in [(light, light_paper), (dark, dark_paper)] {
                let found = contrast(colour, paper);
                assert!(found >= least, "{name} {colour} on {paper}: {found:.2}");
            }
        }
    }

    #[test]
    fn a_size_is_one_that_can_be_drawn() {
        assert_eq!(Size::pixels(f64::NAN, -3.0), Size::pixels(160.0, 120.0));
        assert_eq!(Size::millimetres(160.0, 100.0).written(), ("160mm".to_owned(), "100mm".to_owned()));
    }

    #[test]
    fn an_identifier_is_one() {
        assert_eq!(Style::new(Size::pixels(1.0, 1.0)).id("7\"<a").id, "plot7a");
    }
}
