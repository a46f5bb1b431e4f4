//! Items of a plane.

use crate::label::Label;
use crate::style::{Hatch, Tone};

/// Class, data and tooltip of an item, for scripts and style sheets of a page.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Tags {
    pub(crate) class: String,
    pub(crate) data: Vec<(String, String)>,
    pub(crate) tooltip: Option<String>,
}

impl Tags {
    pub(crate) fn set(&mut self, key: &str, value: &str) {
        let key: String = key
            .chars()
            .filter_map(|c| match c {
                'a'..='z' | '0'..='9' | '-' => Some(c),
                'A'..='Z' => Some(c.to_ascii_lowercase()),
                '_' | ' ' => Some('-'),
                _ => None,
            })
            .collect();
        // XML allows an attribute once per element: a repeated key replaces its value.
        self.data.retain(|(known, _)| *known != key);
        if !key.is_empty() && key != "label" && key != "dropped" {
            self.data.push((key, value.to_owned()));
        }
    }
}

/// Builder methods for the tags of an item.
macro_rules! tagged {
    ($item:ident) => {
        impl $item {
            /// Adds a CSS class.
            #[must_use]
            pub fn class(mut self, class: &str) -> Self {
                self.tags.class = class.to_owned();
                self
            }

            /// Adds an attribute `data-KEY`; the keys `label` and `dropped` belong to the chart.
            #[must_use]
            pub fn data(mut self, key: &str, value: &str) -> Self {
                self.tags.set(key, value);
                self
            }

            /// Sets the tooltip, which is the label unless set.
            #[must_use]
            pub fn tooltip(mut self, text: &str) -> Self {
                self.tags.tooltip = Some(text.to_owned());
                self
            }
        }
    };
}
pub(crate) use tagged;

/// Builder methods for items in a plane: the tags, label and tone.
macro_rules! labelled {
    ($item:ident) => {
        tagged!($item);

        impl $item {
            /// Sets the label.
            #[must_use]
            pub fn label(mut self, label: impl Into<Label>) -> Self {
                self.label = label.into();
                self
            }

            /// Sets the meaning of the item, which decides its colour.
            #[must_use]
            pub const fn tone(mut self, tone: Tone) -> Self {
                self.tone = tone;
                self
            }
        }
    };
}

/// An item in a plane, created from each of the types below.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// A line.
    Line(Line),
    /// An area.
    Area(Area),
    /// Single points.
    Markers(Markers),
    /// A line across the plane.
    Reference(Reference),
    /// A text at a point.
    Note(Note),
}

macro_rules! item {
    ($($kind:ident),*) => { $(
        impl From<$kind> for Item {
            fn from(item: $kind) -> Self {
                Self::$kind(item)
            }
        }
    )* };
}
item!(Line, Area, Markers, Reference, Note);

/// Line pattern.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dash {
    /// Solid line.
    Solid,
    /// Dashes.
    Dashed,
    /// Dots.
    Dotted,
    /// Dashes and dots.
    DashDotted,
}

impl Dash {
    pub(crate) const fn pattern(self) -> &'static str {
        match self {
            Self::Solid => "",
            Self::Dashed => "7 3",
            Self::Dotted => "1.5 2.5",
            Self::DashDotted => "9 3 2 3",
        }
    }
}

/// Line width.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Width {
    /// Secondary lines.
    Thin,
    /// Default.
    Normal,
    /// Most important lines.
    Strong,
}

impl Width {
    pub(crate) const fn pixels(self) -> f64 {
        match self {
            Self::Thin => 0.9,
            Self::Normal => 1.5,
            Self::Strong => 2.2,
        }
    }
}

/// A line through points. A point with a non-finite coordinate leaves a gap.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    pub(crate) points: Vec<(f64, f64)>,
    pub(crate) label: Label,
    pub(crate) tone: Tone,
    pub(crate) dash: Option<Dash>,
    pub(crate) width: Width,
    pub(crate) closed: bool,
    pub(crate) tags: Tags,
}
labelled!(Line);

impl Line {
    /// Returns its points (x, y).
    #[must_use]
    pub fn points(&self) -> &[(f64, f64)] {
        &self.points
    }

    /// Returns the label at the line as plain text.
    #[must_use]
    pub fn label_text(&self) -> String {
        self.label.plain()
    }

    /// Creates a line through points (x, y).
    #[must_use]
    pub fn new(points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self {
            points: points.into_iter().collect(),
            label: Label::default(),
            tone: Tone::Trace,
            dash: None,
            width: Width::Normal,
            closed: false,
            tags: Tags::default(),
        }
    }

    /// Sets the dashes, which follow the tone unless set.
    #[must_use]
    pub const fn dash(mut self, dash: Dash) -> Self {
        self.dash = Some(dash);
        self
    }

    /// Sets the line width.
    #[must_use]
    pub const fn width(mut self, width: Width) -> Self {
        self.width = width;
        self
    }

    /// Joins the last point to the first.
    #[must_use]
    pub const fn closed(mut self) -> Self {
        self.closed = true;
        self
    }

    pub(crate) const fn pattern(&self) -> &'static str {
        match (self.dash, self.tone) {
            (Some(dash), _) => dash.pattern(),
            (None, Tone::ShortTime) => "7 3",
            (None, Tone::Muted) => "1.5 2.5",
            (None, Tone::Series(number)) => match number % crate::style::SERIES {
                1 => "7 3",
                2 => "2 2.5",
                3 => "9 3 2 3",
                4 => "12 3",
                5 => "9 3 2 3 2 3",
                _ => "",
            },
            (None, Tone::Continuous | Tone::Trace) => "",
        }
    }
}

/// A filled area.
#[derive(Clone, Debug, PartialEq)]
pub struct Area {
    pub(crate) outline: Vec<(f64, f64)>,
    pub(crate) label: Label,
    pub(crate) tone: Tone,
    pub(crate) hatch: Option<Hatch>,
    pub(crate) tags: Tags,
}
labelled!(Area);

impl Area {
    /// Creates the area within a closed outline.
    #[must_use]
    pub fn new(outline: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self {
            outline: outline.into_iter().collect(),
            label: Label::default(),
            tone: Tone::Muted,
            hatch: None,
            tags: Tags::default(),
        }
    }

    /// Creates the band between two curves that run in the same direction.
    #[must_use]
    pub fn between(one: impl IntoIterator<Item = (f64, f64)>, other: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let back: Vec<(f64, f64)> = other.into_iter().collect();
        Self::new(one.into_iter().chain(back.into_iter().rev()))
    }

    /// Fills with a pattern, distinct without colour.
    #[must_use]
    pub const fn hatch(mut self, hatch: Hatch) -> Self {
        self.hatch = Some(hatch);
        self
    }
}

/// The form of a marker.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// ○
    Circle,
    /// ◇
    Diamond,
    /// ×
    Cross,
    /// □
    Square,
    /// △
    Triangle,
    /// A wide ring, never filled, that marks another marker without covering it.
    Ring,
}

/// Single points.
#[derive(Clone, Debug, PartialEq)]
pub struct Markers {
    pub(crate) points: Vec<(f64, f64)>,
    pub(crate) names: Vec<Label>,
    pub(crate) subjects: Vec<String>,
    pub(crate) label: Label,
    pub(crate) tone: Tone,
    pub(crate) shape: Shape,
    pub(crate) hollow: bool,
    pub(crate) tags: Tags,
}
labelled!(Markers);

impl Markers {
    /// Creates filled circles at points (x, y).
    #[must_use]
    pub fn new(points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self {
            points: points.into_iter().collect(),
            names: Vec::new(),
            subjects: Vec::new(),
            label: Label::default(),
            tone: Tone::Trace,
            shape: Shape::Circle,
            hollow: false,
            tags: Tags::default(),
        }
    }

    /// Sets the form.
    #[must_use]
    pub const fn shape(mut self, shape: Shape) -> Self {
        self.shape = shape;
        self
    }

    /// Draws the outline only.
    #[must_use]
    pub const fn hollow(mut self) -> Self {
        self.hollow = true;
        self
    }

    /// Names the points in their order. A name is drawn if there is room, and is the tooltip of its point in any case;
    /// earlier names are placed first.
    #[must_use]
    pub fn names<L: Into<Label>>(mut self, names: impl IntoIterator<Item = L>) -> Self {
        self.names = names.into_iter().map(Into::into).collect();
        self
    }
}

/// A line across the plane at one value.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    pub(crate) at: At,
    pub(crate) label: Label,
    pub(crate) tone: Tone,
    pub(crate) dash: Dash,
    pub(crate) tags: Tags,
}
labelled!(Reference);

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum At {
    X(f64),
    Y(f64),
}

impl Reference {
    /// Creates a horizontal line at a value of y.
    #[must_use]
    pub fn horizontal(y: f64) -> Self {
        Self::new(At::Y(y))
    }

    /// Creates a vertical line at a value of x.
    #[must_use]
    pub fn vertical(x: f64) -> Self {
        Self::new(At::X(x))
    }

    /// Sets the dashes.
    #[must_use]
    pub const fn dash(mut self, dash: Dash) -> Self {
        self.dash = dash;
        self
    }

    fn new(at: At) -> Self {
        Self { at, label: Label::default(), tone: Tone::Muted, dash: Dash::DashDotted, tags: Tags::default() }
    }
}

/// A text at a point, placed in a free area and joined to its point by a leader.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    pub(crate) at: (f64, f64),
    pub(crate) label: Label,
    pub(crate) tone: Tone,
    pub(crate) tags: Tags,
}
labelled!(Note);

impl Note {
    /// Creates a text for the point (x, y).
    #[must_use]
    pub fn new(x: f64, y: f64, label: impl Into<Label>) -> Self {
        Self { at: (x, y), label: label.into(), tone: Tone::Trace, tags: Tags::default() }
    }
}

impl Item {
    /// Returns the coordinates x and y that the axes have to include, unchecked.
    pub(crate) fn reach(&self) -> (Vec<f64>, Vec<f64>) {
        let split = |points: &[(f64, f64)]| points.iter().filter(|p| is_data(**p)).copied().unzip();
        match self {
            Self::Line(line) => split(&line.points),
            Self::Area(area) => split(&area.outline),
            Self::Markers(markers) => split(&markers.points),
            Self::Reference(reference) => match reference.at {
                At::X(x) => (vec![x], Vec::new()),
                At::Y(y) => (Vec::new(), vec![y]),
            },
            Self::Note(note) => split(&[note.at]),
        }
    }
}

/// Returns `true` if a point can be drawn.
pub(crate) fn is_data((x, y): (f64, f64)) -> bool {
    x.abs() <= crate::ticks::LARGEST && y.abs() <= crate::ticks::LARGEST
}

/// Splits a series at its non-finite points; returns the pieces and the number of these points.
pub(crate) fn pieces(points: &[(f64, f64)]) -> (Vec<Vec<(f64, f64)>>, usize) {
    let dropped = points.iter().filter(|point| !is_data(**point)).count();
    let pieces = points.split(|point| !is_data(*point)).filter(|piece| !piece.is_empty());
    (pieces.map(<[_]>::to_vec).collect(), dropped)
}

/// Returns the lines among the items.
pub(crate) fn lines_of(items: &[Item]) -> impl Iterator<Item = &Line> {
    items.iter().filter_map(|item| match item {
        Item::Line(line) => Some(line),
        Item::Area(_) | Item::Markers(_) | Item::Reference(_) | Item::Note(_) => None,
    })
}
