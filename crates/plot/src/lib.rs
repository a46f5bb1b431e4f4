//! Charts as SVG in one house style, for paper, web page and screen, independent of their subject.

mod bars;
mod canvas;
mod chart_title;
mod draw;
mod face;
mod font;
mod geometry;
mod item;
mod label;
mod legend;
mod number;
mod picture;
mod place;
mod plane;
#[cfg(feature = "png")]
mod png;
mod reduce;
mod stacked;
mod style;
mod ticks;
mod titled;
mod xy;

pub use bars::{Bar, BarChart, Verdict};
pub use face::{FaceChart, FacePin};
pub use font::{FONT_FAMILY, font_files};
pub use geometry::Rect;
pub use item::{Area, Dash, Item, Line, Markers, Note, Reference, Shape, Width};
pub use label::Label;
pub use picture::{Picture, TextBox};
pub use plane::PlaneAxis;
pub use stacked::{Panel, StackedChart};
pub use style::{Hatch, LOGO, Size, Style, Theme, Tone};
pub use xy::XyChart;
