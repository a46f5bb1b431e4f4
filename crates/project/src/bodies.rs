//! Inertia of solid bodies: tables of a project file, or text, one body a line: `cylinder diameter=200mm length=20mm
//! mass=5kg`. Both share one description of the keys.

mod faults;
mod line;

use crate::Diagnostic;
use crate::about::About;
use crate::choices::Orientation;
use crate::key::{Kind, Variants};
use crate::section::{Fields, OfKinds, Section, names, section};
use crate::stated::SectionHead;
use crate::value::choices;
use faults::Faults;
use line::{Keyed, Line};
use quantities::{Angle, HalfWidth, Length, Mass, MassDensity, Reading};
use std::ops::Range;

section! {
    /// A solid body, in a table of the project file and in one line of text alike.
    BodySection, BodyName of About::Body {
        shape: BodyKind => needed;
        diameter: Length => positive;
        length: Length => positive;
        outer: Length => positive, example("80 mm");
        inner: Length => not_negative, example("60 mm");
        a: Length => positive;
        b: Length => positive;
        height: Length => positive;
        axis: Orientation;
        mass: Mass => positive;
        density: MassDensity => positive;
        distance: Length => not_negative;
        angle: Angle;
        count: u32 = 1 => whole(1, u32::MAX as i64), example("3");
    }
}

choices! {
    BodyKind {
        Cylinder = "cylinder",
        Disc = "disc",
        Tube = "tube",
        Box = "box",
        Cone = "cone",
        Sphere = "sphere",
        Point = "point",
        Rod = "rod",
    }
}

impl OfKinds for BodySection {
    const VARIANTS: &'static Variants = &Variants {
        keys: Self::KEYS,
        by: "shape",
        kinds: &[
            of_shape(CYLINDER),
            of_shape(DISC),
            of_shape(TUBE),
            of_shape(BOX),
            of_shape(CONE),
            of_shape(SPHERE),
            of_shape(POINT),
            of_shape(ROD),
        ],
        shared: BODY_SHARED,
    };
}

/// Returns the required and the optional keys of a shape.
const fn of_shape(shape: BodyShape) -> (&'static str, &'static [&'static str], &'static [&'static str]) {
    let optional: &[&str] = match (shape.extent, shape.may_lie) {
        (Some(_), true) => names!(BodySection: length axis),
        (Some(_), false) => names!(BodySection: height),
        (None, _) => &[],
    };
    (shape.name, shape.dimensions, optional)
}

/// Kind of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyKind {
    /// A solid cylinder.
    Cylinder,
    /// A flat solid cylinder.
    Disc,
    /// A hollow cylinder.
    Tube,
    /// A cuboid.
    Box,
    /// A cone.
    Cone,
    /// A sphere.
    Sphere,
    /// A mass without extent.
    Point,
    /// A slender rod.
    Rod,
}

/// A shape of the text: its name and its required keys.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BodyShape {
    /// Kind.
    pub kind: BodyKind,
    /// Name in the text: `cylinder`.
    pub name: &'static str,
    /// Required dimensions.
    pub dimensions: &'static [&'static str],
    /// Dimension that only a mass from the density, or a lying body, needs.
    pub extent: Option<&'static str>,
    /// Allows the key `axis` for the orientation.
    pub may_lie: bool,
}

/// Shapes.
pub static BODY_SHAPES: [BodyShape; 8] = [CYLINDER, DISC, TUBE, BOX, CONE, SPHERE, POINT, ROD];

const CYLINDER: BodyShape = shape(BodyKind::Cylinder, "cylinder", names!(BodySection: diameter), true);
const DISC: BodyShape = shape(BodyKind::Disc, "disc", names!(BodySection: diameter), true);
const TUBE: BodyShape = shape(BodyKind::Tube, "tube", names!(BodySection: outer inner), true);
const BOX: BodyShape = shape(BodyKind::Box, "box", names!(BodySection: a b), false);
const CONE: BodyShape = shape(BodyKind::Cone, "cone", names!(BodySection: diameter), false);
const SPHERE: BodyShape = shape(BodyKind::Sphere, "sphere", names!(BodySection: diameter), false);
const POINT: BodyShape = shape(BodyKind::Point, "point", &[], false);
const ROD: BodyShape = shape(BodyKind::Rod, "rod", names!(BodySection: length), false);

/// Keys that every shape may have.
const BODY_SHARED: &[&str] = names!(BodySection: mass density distance angle count);

const fn shape(kind: BodyKind, name: &'static str, dimensions: &'static [&'static str], may_lie: bool) -> BodyShape {
    let extent = match kind {
        BodyKind::Cylinder | BodyKind::Disc | BodyKind::Tube => Some("length"),
        BodyKind::Box | BodyKind::Cone => Some("height"),
        BodyKind::Sphere | BodyKind::Point | BodyKind::Rod => None,
    };
    BodyShape { kind, name, dimensions, extent, may_lie }
}

impl BodyShape {
    /// Returns every key that the shape may have.
    fn keys(&self) -> Vec<&'static str> {
        let mut keys = self.dimensions.to_vec();
        keys.extend(self.extent);
        keys.extend(self.may_lie.then_some("axis"));
        keys.extend(BODY_SHARED);
        keys
    }
}

/// Solid bodies as read from text, with the faults of their keys and values.
#[derive(Debug)]
pub struct BodyText {
    /// One section for each line that states a shape; refused values are marked.
    pub bodies: Vec<BodySection>,
    /// Faults in the order of the text.
    pub faults: Vec<Diagnostic>,
    /// Number of faults beyond those that are kept.
    pub more: usize,
}

/// Reads solid bodies, one a line.
///
/// A body is its shape, then `key=value`, with the unit in the value: `tube outer=80mm inner=60mm length=50mm
/// density=2.7g/cm^3 distance=120mm count=3`. Defaults: `distance` 0, `angle` 0, `count` 1, `axis` parallel.
#[must_use]
pub fn read_bodies(text: &str) -> BodyText {
    let mut faults = Faults::new(text);
    let bodies = sections(text, &mut faults, &|_, span| span);
    let (faults, more) = faults.take();
    BodyText { bodies, faults, more }
}

/// A tolerance of a body: its line from zero, its key, the value, the half-width with its place in the line.
pub(crate) type BodyTolerance = (usize, &'static str, Reading, HalfWidth);

/// Place in the file of a place in a line, counted from zero.
type PlaceOf<'p> = &'p dyn Fn(usize, Range<usize>) -> Range<usize>;

/// Reads bodies whose quantities may have tolerances; `place` gives the places of their values.
pub(crate) fn toleranced(text: &str, place: PlaceOf<'_>) -> (BodyText, Vec<BodyTolerance>) {
    let mut faults = Faults::with_tolerances(text);
    let bodies = sections(text, &mut faults, place);
    let tolerances = faults.tolerances.take().unwrap_or_default();
    let (faults, more) = faults.take();
    (BodyText { bodies, faults, more }, tolerances)
}

fn sections(text: &str, faults: &mut Faults<'_>, place: PlaceOf<'_>) -> Vec<BodySection> {
    let read = |(index, (start, line)): (usize, (usize, &str))| {
        faults.begin(index, start);
        let place = |span: Range<usize>| place(index, span);
        read(&Line::split(start, line), faults, &place)
    };
    lines(text).enumerate().filter_map(read).collect()
}

/// Iterates over the lines of a text with their offsets; an empty text has one line.
pub(crate) fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut start = 0;
    text.split('\n').map(move |line| {
        let at = start;
        start += line.len() + 1;
        (at, line)
    })
}

impl BodySection {
    /// Returns its shape.
    #[must_use]
    pub fn shape(&self) -> Option<&'static BodyShape> {
        BODY_SHAPES.iter().find(|shape| Some(shape.kind) == self.shape.value())
    }
}

/// Reads one body and reports its faults.
fn read(line: &Line<'_>, faults: &mut Faults<'_>, place: &dyn Fn(Range<usize>) -> Range<usize>) -> Option<BodySection> {
    let known = faults.shape(line);
    if let Some(stray) = &line.stray {
        faults.stray(stray);
    }
    let mut section = BodySection::absent(&SectionHead::new("", place(line.span.clone())));
    let by = BodySection::VARIANTS.by;
    let all: Vec<&str> = BodySection::KEYS.iter().map(|key| key.name).filter(|name| *name != by).collect();
    let valid = known.map_or(all, BodyShape::keys);
    let mut meant: Vec<&str> = Vec::new();
    for (index, pair) in line.pairs.iter().enumerate() {
        let Some(key) = BodySection::KEYS.iter().find(|key| key.name == pair.key && valid.contains(&key.name)) else {
            meant.extend(faults.unknown_key(pair, known, &valid));
            continue;
        };
        if line.pairs.iter().take(index).any(|earlier| earlier.key == pair.key) {
            faults.twice(pair);
            continue;
        }
        let span = place(pair.value_span.clone());
        if let Kind::Quantity(dimension, _) = key.kind {
            let si = faults.quantity(pair, key.name, dimension);
            match (section.field_mut(key.name), si) {
                (Some(field), Some(si)) => field.state(si, span),
                (Some(field), None) => field.refuse_value(),
                (None, _) => {}
            }
        } else if let Kind::Integer(..) = key.kind {
            match faults.count(pair) {
                Some(count) => section.count.give(count, span),
                None => section.count.refuse(),
            }
        } else {
            match faults.axis(pair) {
                Some(axis) => section.axis.give(axis, span),
                None => section.axis.refuse(),
            }
        }
    }
    let shape = known?;
    section.shape.give(shape.kind, place(line.shape_span.clone()));
    // The key that a misspelt one stands for is not reported as missing.
    let written = |name: &str| line.has(name) || meant.contains(&name);
    for dimension in shape.dimensions.iter().filter(|name| !written(name)) {
        faults.missing(line, dimension);
    }
    // A misspelt key has a value that is not known.
    for name in meant {
        if let Some(field) = section.field_mut(name).filter(|field| !field.is_written()) {
            field.refuse_value();
        }
    }
    Some(section)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::value::WordChoice;

    #[test]
    fn every_word_of_a_shape_has_its_entry() {
        let names: Vec<&str> = BODY_SHAPES.iter().map(|shape| shape.name).collect();
        assert_eq!(names, BodyKind::WORDS);
    }
}
