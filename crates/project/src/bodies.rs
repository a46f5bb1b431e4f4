//! Inertia of solid bodies: tables of a project file, or text, one body a line: `cylinder diameter=200mm length=20mm
//! mass=5kg`. Both share one description of the keys.

mod faults;
mod line;

pub use faults::body_fields;

use crate::Diagnostic;
use crate::about::About;
use crate::key::{Kind, Variants};
use crate::section::{Fields, OfKinds, Section, names, section};
use crate::stated::{SectionHead, StatedField};
use crate::value::choices;
use faults::Faults;
use line::{Keyed, Line};
use mechanism::{Body, BodyInertia, Inertia, Orientation, SolidShape};
use quantities::{Angle, HalfWidth, Length, Mass, MassDensity, Reading};

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
    Orientation { Parallel = "parallel", Perpendicular = "perpendicular" }
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
    (shape.name, shape.dimensions, if shape.may_lie { names!(BodySection: axis) } else { &[] })
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
    /// Allows the key `axis` for the orientation.
    pub may_lie: bool,
}

/// Shapes.
pub static BODY_SHAPES: [BodyShape; 8] = [CYLINDER, DISC, TUBE, BOX, CONE, SPHERE, POINT, ROD];

const CYLINDER: BodyShape = shape(BodyKind::Cylinder, "cylinder", names!(BodySection: diameter length), true);
const DISC: BodyShape = shape(BodyKind::Disc, "disc", names!(BodySection: diameter length), true);
const TUBE: BodyShape = shape(BodyKind::Tube, "tube", names!(BodySection: outer inner length), true);
const BOX: BodyShape = shape(BodyKind::Box, "box", names!(BodySection: a b height), false);
const CONE: BodyShape = shape(BodyKind::Cone, "cone", names!(BodySection: diameter height), false);
const SPHERE: BodyShape = shape(BodyKind::Sphere, "sphere", names!(BodySection: diameter), false);
const POINT: BodyShape = shape(BodyKind::Point, "point", &[], false);
const ROD: BodyShape = shape(BodyKind::Rod, "rod", names!(BodySection: length), false);

/// Keys that every shape may have.
const BODY_SHARED: &[&str] = names!(BodySection: mass density distance angle count);

const fn shape(kind: BodyKind, name: &'static str, dimensions: &'static [&'static str], may_lie: bool) -> BodyShape {
    BodyShape { kind, name, dimensions, may_lie }
}

impl BodyShape {
    /// Returns every key that the shape may have.
    fn keys(&self) -> Vec<&'static str> {
        let mut keys = self.dimensions.to_vec();
        keys.extend(self.may_lie.then_some("axis"));
        keys.extend(BODY_SHARED);
        keys
    }
}

/// One body as read, and its inertia.
#[derive(Clone, Copy, Debug)]
pub struct BodyAnswer {
    /// Shape.
    pub shape: &'static BodyShape,
    /// The body.
    pub body: Body,
    /// Parts of its inertia.
    pub parts: BodyInertia,
}

/// The inertia of several bodies.
#[derive(Clone, Debug)]
pub struct InertiaAnswer {
    /// Bodies in the order of the text.
    pub bodies: Vec<BodyAnswer>,
    /// Sum of the inertias.
    pub total: Inertia,
}

/// Reads solid bodies, one a line, and adds their inertias.
///
/// A body is its shape, then `key=value`, with the unit in the value: `tube outer=80mm inner=60mm length=50mm
/// density=2.7g/cm^3 distance=120mm count=3`. Defaults: `distance` 0, `angle` 0, `count` 1, `axis` parallel.
///
/// # Source
/// docs/guide/inertia.md; [`mechanism::inertia()`]
/// # Errors
/// Every fault with its place; the line of a place is the number of the body.
pub fn inertia(text: &str) -> Result<InertiaAnswer, Vec<Diagnostic>> {
    let (sections, total) = sections(text, &mut Faults::new(text))?;
    Ok(InertiaAnswer { bodies: sections.iter().filter_map(parts).collect(), total })
}

/// A tolerance of a body: its line from zero, its key, the value, the half-width with its place in the line.
pub(crate) type BodyTolerance = (usize, &'static str, Reading, HalfWidth);

/// Reads bodies whose quantities may have tolerances; returns their sections and tolerances.
pub(crate) fn toleranced(text: &str) -> Result<(Vec<BodySection>, Vec<BodyTolerance>), Vec<Diagnostic>> {
    let mut faults = Faults::with_tolerances(text);
    let (sections, _) = sections(text, &mut faults)?;
    Ok((sections, faults.tolerances.unwrap_or_default()))
}

fn sections(text: &str, faults: &mut Faults<'_>) -> Result<(Vec<BodySection>, Inertia), Vec<Diagnostic>> {
    let mut found = Vec::new();
    let mut spans = Vec::new();
    for (index, (start, line)) in lines(text).enumerate() {
        let line = Line::split(start, line);
        faults.begin(index, start);
        found.extend(read(&line, faults));
        spans.push(line.span.clone());
    }
    if !faults.is_empty() {
        return Err(faults.take());
    }
    let bodies: Vec<Body> = found.iter().filter_map(BodySection::body).collect();
    match mechanism::inertia(&bodies) {
        Ok(total) => Ok((found, total)),
        Err(errors) => {
            for fault in errors {
                faults.body(&fault.error, spans.get(fault.body).cloned().unwrap_or_default());
            }
            Err(faults.take())
        }
    }
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
    /// Returns the shape of the text.
    fn shape(&self) -> Option<&'static BodyShape> {
        BODY_SHAPES.iter().find(|shape| Some(shape.kind) == self.shape.value())
    }

    /// Returns the body that a table describes; `None` if a required key was refused or is missing.
    #[must_use]
    pub fn body(&self) -> Option<Body> {
        let shape = self.shape()?;
        let has = |name: &&str| self.field(name).is_some_and(StatedField::is_given);
        (self.is_whole() && shape.dimensions.iter().all(has)).then(|| self.body_of(shape.kind))
    }

    /// Returns the body, with defaults for keys that are not stated.
    fn body_of(&self, kind: BodyKind) -> Body {
        Body {
            shape: self.shape_of(kind),
            mass: self.mass.value(),
            density: self.density.value(),
            distance: self.distance.or_zero(),
            angle: self.angle.or_zero(),
            count: self.count(),
        }
    }

    fn shape_of(&self, kind: BodyKind) -> SolidShape {
        let orientation = self.axis.value().unwrap_or_default();
        let (diameter, length, height) = (self.diameter.or_zero(), self.length.or_zero(), self.height.or_zero());
        match kind {
            BodyKind::Tube => {
                SolidShape::Tube { outer: self.outer.or_zero(), inner: self.inner.or_zero(), length, orientation }
            }
            BodyKind::Box => SolidShape::Box { a: self.a.or_zero(), b: self.b.or_zero(), height },
            BodyKind::Cone => SolidShape::Cone { diameter, height },
            BodyKind::Sphere => SolidShape::Sphere { diameter },
            BodyKind::Point => SolidShape::PointMass,
            BodyKind::Rod => SolidShape::Rod { length },
            BodyKind::Cylinder | BodyKind::Disc => SolidShape::Cylinder { diameter, length, orientation },
        }
    }
}

/// Returns solid bodies with their inertia.
#[must_use]
pub fn summed(sections: &[BodySection]) -> Option<InertiaAnswer> {
    let bodies: Vec<Body> = sections.iter().filter_map(BodySection::body).collect();
    let total = mechanism::inertia(&bodies).ok()?;
    Some(InertiaAnswer { bodies: sections.iter().filter_map(parts).collect(), total })
}

fn parts(section: &BodySection) -> Option<BodyAnswer> {
    let (shape, body) = (section.shape()?, section.body()?);
    body.inertia().ok().map(|parts| BodyAnswer { shape, body, parts })
}

/// Reads one body and reports its faults.
fn read(line: &Line<'_>, faults: &mut Faults<'_>) -> Option<BodySection> {
    let known = faults.shape(line);
    if let Some(stray) = &line.stray {
        faults.stray(stray);
    }
    let mut section = BodySection::absent(&SectionHead::new("", line.span.clone()));
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
        let span = pair.value_span.clone();
        if let Kind::Quantity(dimension, _) = key.kind {
            let si = faults.quantity(pair, key.name, dimension);
            if let Some((field, si)) = section.field_mut(key.name).zip(si) {
                field.state(si, span);
            }
        } else if let Kind::Integer(..) = key.kind {
            if let Some(count) = faults.count(pair) {
                section.count.give(count, span);
            }
        } else if let Some(axis) = faults.axis(pair) {
            section.axis.give(axis, span);
        }
    }
    let shape = known?;
    section.shape.give(shape.kind, line.shape_span.clone());
    // The key that a misspelt one stands for is not reported as missing.
    let written = |name: &str| line.has(name) || meant.contains(&name);
    for dimension in shape.dimensions.iter().filter(|name| !written(name)) {
        faults.missing(line, dimension);
    }
    let body = section.body_of(shape.kind);
    for error in body.faults() {
        // A value that could not be read has been reported already.
        let fields = faults::body_fields(&error, &section);
        let unread = |field: &&dyn StatedField| shape.dimensions.contains(&field.name()) && !field.is_given();
        let damaged = |field: &dyn StatedField| written(field.name()) && !field.is_given();
        let lost_mass = fields.is_empty() && (damaged(&section.mass) || damaged(&section.density));
        if !fields.iter().any(unread) && !lost_mass {
            let place = fields.first().and_then(|field| line.value_of(field.name()));
            faults.body(&error, place.unwrap_or_else(|| line.shape_span.clone()));
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
