//! The inertia of solid bodies: tables of a project file, or text, one body a line: `cylinder diameter=200mm length=20mm
//! mass=5kg`. The keys of both are described once.

mod faults;
mod line;

pub(crate) use faults::fields;

use crate::Diagnostic;
use crate::section::{Entry, Section};
use crate::spec::{BODY, Kind};
use faults::Faults;
use line::{Keyed, Line};
use mechanism::{Body, BodyInertia, Inertia, Orientation, Shape};
use quantities::{Angle, HalfWidth, Length, Mass, MassDensity, Measure, Reading};

/// What a body looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyKind {
    /// A solid cylinder.
    Cylinder,
    /// A solid cylinder that is rather flat.
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

/// A shape as it is written: its name and the keys that it must have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BodyShape {
    /// What it is.
    pub kind: BodyKind,
    /// Name in the text: `cylinder`.
    pub name: &'static str,
    /// The dimensions that it must have.
    pub dimensions: &'static [&'static str],
    /// Whether `axis` may say how it lies.
    pub may_lie: bool,
}

/// Every shape.
pub static BODY_SHAPES: [BodyShape; 8] = [CYLINDER, DISC, TUBE, BOX, CONE, SPHERE, POINT, ROD];

pub(crate) const CYLINDER: BodyShape = shape(BodyKind::Cylinder, "cylinder", &["diameter", "length"], true);
pub(crate) const DISC: BodyShape = shape(BodyKind::Disc, "disc", &["diameter", "length"], true);
pub(crate) const TUBE: BodyShape = shape(BodyKind::Tube, "tube", &["outer", "inner", "length"], true);
pub(crate) const BOX: BodyShape = shape(BodyKind::Box, "box", &["a", "b", "height"], false);
pub(crate) const CONE: BodyShape = shape(BodyKind::Cone, "cone", &["diameter", "height"], false);
pub(crate) const SPHERE: BodyShape = shape(BodyKind::Sphere, "sphere", &["diameter"], false);
pub(crate) const POINT: BodyShape = shape(BodyKind::Point, "point", &[], false);
pub(crate) const ROD: BodyShape = shape(BodyKind::Rod, "rod", &["length"], false);

/// Keys that every shape may have.
pub(crate) const BODY_SHARED: &[&str] = &["mass", "density", "distance", "angle", "count"];

const fn shape(kind: BodyKind, name: &'static str, dimensions: &'static [&'static str], may_lie: bool) -> BodyShape {
    BodyShape { kind, name, dimensions, may_lie }
}

impl BodyShape {
    /// Every key that it may have.
    fn keys(&self) -> Vec<&'static str> {
        let mut keys = self.dimensions.to_vec();
        keys.extend(self.may_lie.then_some("axis"));
        keys.extend(BODY_SHARED);
        keys
    }
}

/// How `axis` may be written.
const AXES: [&str; 2] = ["parallel", "perpendicular"];

/// One body as it was read, and its inertia.
#[derive(Clone, Copy, Debug)]
pub struct BodyAnswer {
    /// Its shape.
    pub shape: &'static BodyShape,
    /// The body.
    pub body: Body,
    /// Its inertia in parts.
    pub parts: BodyInertia,
}

/// The inertia of several bodies.
#[derive(Clone, Debug)]
pub struct InertiaAnswer {
    /// Each body.
    pub bodies: Vec<BodyAnswer>,
    /// All together.
    pub total: Inertia,
}

/// Reads solid bodies, one a line, and adds up their inertia.
///
/// A body is its shape and then `key=value`, with the unit in the value: `tube outer=80mm inner=60mm length=50mm
/// density=2.7g/cm^3 distance=120mm count=3`. What is left out: `distance` 0, `angle` 0, `count` 1, `axis` parallel.
///
/// # Source   docs/guide/inertia.md; [`mechanism::inertia()`]
/// # Errors
/// Every fault with its place; the line of a place is the number of the body.
pub fn inertia(text: &str) -> Result<InertiaAnswer, Vec<Diagnostic>> {
    answer(text, &mut Faults::new(text))
}

/// A tolerance of a body: its line from zero, its key, the value, the half-width with its place in the line.
pub(crate) type BodyTolerance = (usize, &'static str, Reading, HalfWidth);

/// The same of bodies whose quantities may carry tolerances.
pub(crate) fn toleranced(text: &str) -> Result<(InertiaAnswer, Vec<BodyTolerance>), Vec<Diagnostic>> {
    let mut faults = Faults::with_tolerances(text);
    let answer = answer(text, &mut faults)?;
    Ok((answer, faults.tolerances.unwrap_or_default()))
}

fn answer(text: &str, faults: &mut Faults<'_>) -> Result<InertiaAnswer, Vec<Diagnostic>> {
    let mut found = Vec::new();
    let mut spans = Vec::new();
    for (index, (start, line)) in lines(text).enumerate() {
        let line = Line::split(start, line);
        faults.begin(index, start);
        found.extend(read(&line, faults));
        spans.push(line.span.clone());
    }
    let bodies: Vec<Body> = found.iter().map(|(_, body)| *body).collect();
    if !faults.is_empty() {
        return Err(faults.take());
    }
    let total = match mechanism::inertia(&bodies) {
        Ok(total) => total,
        Err(errors) => {
            for fault in errors {
                faults.body(&fault.error, spans.get(fault.body).cloned().unwrap_or_default());
            }
            return Err(faults.take());
        }
    };
    Ok(InertiaAnswer { bodies: found.into_iter().filter_map(parts).collect(), total })
}

/// The lines of a text with their offsets; an empty text has one line.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut start = 0;
    text.split('\n').map(move |line| {
        let at = start;
        start += line.len() + 1;
        (at, line)
    })
}

/// The values of one line as far as they are good.
#[derive(Default)]
struct Values {
    quantities: Vec<(&'static str, f64)>,
    count: Option<u32>,
    orientation: Orientation,
}

impl Values {
    fn get(&self, key: &str) -> Option<f64> {
        self.quantities.iter().find(|(name, _)| *name == key).map(|(_, si)| *si)
    }

    fn length(&self, key: &str) -> Length {
        Length::from_si(self.get(key).unwrap_or(0.0))
    }

    fn body(&self, shape: &BodyShape) -> Body {
        Body {
            shape: self.shape(shape),
            mass: self.get("mass").map(Mass::from_si),
            density: self.get("density").map(MassDensity::from_si),
            distance: self.length("distance"),
            angle: Angle::from_si(self.get("angle").unwrap_or(0.0)),
            count: self.count.unwrap_or(1),
        }
    }

    fn shape(&self, shape: &BodyShape) -> Shape {
        let length = |key| self.length(key);
        let orientation = self.orientation;
        match shape.kind {
            BodyKind::Tube => {
                let (outer, inner) = (length("outer"), length("inner"));
                Shape::Tube { outer, inner, length: length("length"), orientation }
            }
            BodyKind::Box => Shape::Box { a: length("a"), b: length("b"), height: length("height") },
            BodyKind::Cone => Shape::Cone { diameter: length("diameter"), height: length("height") },
            BodyKind::Sphere => Shape::Sphere { diameter: length("diameter") },
            BodyKind::Point => Shape::PointMass,
            BodyKind::Rod => Shape::Rod { length: length("length") },
            BodyKind::Cylinder | BodyKind::Disc => {
                Shape::Cylinder { diameter: length("diameter"), length: length("length"), orientation }
            }
        }
    }
}

/// The body that a table of a project file describes; `None` where a key that it needs was refused or is missing.
pub(crate) fn of_table(section: &Section) -> Option<Body> {
    let shape = BODY_SHAPES.iter().find(|shape| Some(shape.name) == section.text("shape"))?;
    let whole = section.is_whole() && shape.dimensions.iter().all(|name| section.get(name).is_some());
    let quantities = BODY.iter().filter_map(|key| Some((key.name, section.si(key.name)?)));
    let orientation = match section.text("axis") {
        Some("perpendicular") => Orientation::Perpendicular,
        _ => Orientation::Parallel,
    };
    let count = match section.get("count") {
        Some(Entry::Integer(count)) => u32::try_from(*count).ok(),
        _ => None,
    };
    whole.then(|| Values { quantities: quantities.collect(), count, orientation }.body(shape))
}

/// The solid bodies that an axis turns, however they are written; `None` where it turns something else.
pub(crate) fn of_axis(root: &Section) -> Option<InertiaAnswer> {
    let turntable = root.table("mechanism")?.table("turntable")?;
    let found: Vec<(&'static BodyShape, Body)> = match turntable.bodies("bodies") {
        Some(bodies) => bodies.iter().map(|body| (shape_of(&body.shape), *body)).collect(),
        None => turntable
            .tables("body")
            .iter()
            .filter_map(|table| {
                let shape = BODY_SHAPES.iter().find(|shape| Some(shape.name) == table.text("shape"))?;
                Some((shape, of_table(table)?))
            })
            .collect(),
    };
    let bodies: Vec<Body> = found.iter().map(|(_, body)| *body).collect();
    let total = mechanism::inertia(&bodies).ok()?;
    Some(InertiaAnswer { bodies: found.into_iter().filter_map(parts).collect(), total })
}

fn parts((shape, body): (&'static BodyShape, Body)) -> Option<BodyAnswer> {
    body.inertia().ok().map(|parts| BodyAnswer { shape, body, parts })
}

/// The shape of a body as it is written; a disc is a cylinder.
const fn shape_of(shape: &Shape) -> &'static BodyShape {
    match shape {
        Shape::Cylinder { .. } => &CYLINDER,
        Shape::Tube { .. } => &TUBE,
        Shape::Box { .. } => &BOX,
        Shape::Cone { .. } => &CONE,
        Shape::Sphere { .. } => &SPHERE,
        Shape::PointMass => &POINT,
        Shape::Rod { .. } => &ROD,
    }
}

/// Gives a body another value, in SI, in the place of one that it has; `None` for a key that it does not have.
pub(crate) fn set(body: &mut Body, key: &str, si: f64) -> Option<()> {
    let length = Length::from_si(si);
    match key {
        "mass" => body.mass = Some(Mass::from_si(si)),
        "density" => body.density = Some(MassDensity::from_si(si)),
        "distance" => body.distance = length,
        "angle" => body.angle = Angle::from_si(si),
        _ => match (&mut body.shape, key) {
            (
                Shape::Cylinder { diameter: part, .. }
                | Shape::Cone { diameter: part, .. }
                | Shape::Sphere { diameter: part },
                "diameter",
            )
            | (
                Shape::Cylinder { length: part, .. } | Shape::Tube { length: part, .. } | Shape::Rod { length: part },
                "length",
            )
            | (Shape::Tube { outer: part, .. }, "outer")
            | (Shape::Tube { inner: part, .. }, "inner")
            | (Shape::Box { a: part, .. }, "a")
            | (Shape::Box { b: part, .. }, "b")
            | (Shape::Box { height: part, .. } | Shape::Cone { height: part, .. }, "height") => *part = length,
            _ => return None,
        },
    }
    Some(())
}

/// Reads one body; what is wrong with it goes to the faults.
fn read(line: &Line<'_>, faults: &mut Faults<'_>) -> Option<(&'static BodyShape, Body)> {
    let known = faults.shape(line);
    for stray in &line.strays {
        faults.stray(stray);
    }
    let all: Vec<&str> = BODY.iter().map(|key| key.name).filter(|name| *name != "shape").collect();
    let valid = known.map_or(all, BodyShape::keys);
    let mut values = Values::default();
    let mut meant: Vec<&str> = Vec::new();
    for (index, pair) in line.pairs.iter().enumerate() {
        let Some(key) = BODY.iter().find(|key| key.name == pair.key && valid.contains(&key.name)) else {
            meant.extend(faults.unknown_key(pair, known, &valid));
            continue;
        };
        if line.pairs.iter().take(index).any(|earlier| earlier.key == pair.key) {
            faults.twice(pair);
            continue;
        }
        match key.kind {
            Kind::Quantity(dimension, _) => {
                values.quantities.extend(faults.quantity(pair, key.name, dimension).map(|si| (key.name, si)));
            }
            Kind::Integer(..) => values.count = faults.count(pair),
            _ => values.orientation = faults.axis(pair).unwrap_or_default(),
        }
    }
    let shape = known?;
    // What a misspelt key was meant to be is not missing too.
    let written = |name: &&str| line.has(name) || meant.contains(name);
    for dimension in shape.dimensions.iter().filter(|name| !written(name)) {
        faults.missing(line, dimension);
    }
    let body = values.body(shape);
    for error in body.faults() {
        // What could not be read has been told already.
        let fields = faults::fields(&error);
        let unread = |field: &&str| shape.dimensions.contains(field) && values.get(field).is_none();
        let damaged = |field: &&str| written(field) && values.get(field).is_none();
        let lost_mass = fields.is_empty() && ["mass", "density"].iter().any(damaged);
        if !fields.iter().any(unread) && !lost_mass {
            let place = fields.first().and_then(|field| line.value_of(field));
            faults.body(&error, place.unwrap_or_else(|| line.shape_span.clone()));
        }
    }
    Some((shape, body))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_of_a_shape_is_described() {
        for shape in &BODY_SHAPES {
            for name in shape.keys() {
                assert!(BODY.iter().any(|key| key.name == name), "{name}");
            }
            assert!(
                matches!(BODY.first().map(|key| key.kind), Some(Kind::OneOf(names)) if names.contains(&shape.name))
            );
        }
    }
}
