//! Inertia of solid bodies.

use crate::choices;
use crate::fault::{AxisDiagnostic, AxisFault, AxisReport};
use mechanism::{Body, BodyError, BodyInertia, Inertia, SolidShape};
use project::sections::{BodySection, Fields, Parts, Section, StatedField};
use project::{BodyKind, BodyShape, BodyText, Diagnostic, Fault, read_bodies};
use std::ops::Range;

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
/// # Source
/// docs/guide/inertia.md; [`mechanism::inertia()`]
/// # Errors
/// Every fault with its place; the line of a place is the number of the body.
pub fn inertia(text: &str) -> Result<InertiaAnswer, Vec<AxisDiagnostic>> {
    let BodyText { bodies, faults, mut more } = read_bodies(text);
    let mut found: Vec<AxisDiagnostic> = faults.into_iter().map(Diagnostic::into_other).collect();
    for (span, error) in faults_of(&bodies, found.is_empty()) {
        if found.len() < FAULTS_MOST {
            found.push(Diagnostic::at(text, span, AxisFault::Body(error), None));
        } else {
            more += 1;
        }
    }
    found.sort_by_key(|fault| (fault.span.start, fault.span.end));
    if more > 0 {
        let end = text.len();
        found.push(Diagnostic::at(text, end..end, Fault::More { count: more }.into(), None));
    }
    if found.is_empty() { summed(&bodies).ok_or(found) } else { Err(found) }
}

/// Faults beyond this number are counted, not listed.
const FAULTS_MOST: usize = 50;

/// Reports the faults of the bodies of a turntable that are written as texts, and refuses faulty ones.
pub(crate) fn check_texts(parts: &mut Parts, report: &mut AxisReport<'_>) {
    let Some(table) = parts.mechanism.get_mut().and_then(|all| all.turntable.get_mut()) else { return };
    let Some(lines) = table.bodies.get() else { return };
    let is_whole = lines.is_whole;
    let faults = faults_of(&lines.bodies, is_whole);
    if !is_whole || !faults.is_empty() {
        table.bodies.refuse();
    }
    for (span, error) in faults {
        report.fault(span, AxisFault::BodyOfText { path: table.bodies.path(), error }, None);
    }
}

/// Returns the faults of bodies written as texts, each with its place; `whole`: all of their values were read.
pub(crate) fn faults_of(bodies: &[BodySection], whole: bool) -> Vec<(Range<usize>, BodyError)> {
    let mut found: Vec<_> = bodies.iter().flat_map(faults_of_one).collect();
    if whole && found.is_empty() {
        // Those of the sum.
        let errors = mechanism::inertia(&bodies.iter().filter_map(body).collect::<Vec<_>>()).err().unwrap_or_default();
        let place = |index: usize| bodies.get(index).map_or(0..0, |section| section.head().span.clone());
        found.extend(errors.into_iter().map(|each| (place(each.body), each.error)));
    }
    found
}

fn faults_of_one(section: &BodySection) -> Vec<(Range<usize>, BodyError)> {
    let Some(shape) = section.shape() else { return Vec::new() };
    let is_new = |error: &BodyError| {
        // A value that could not be read has been reported already.
        let fields = body_fields(error, section);
        let unread = |field: &&dyn StatedField| match error {
            BodyError::DimensionMissing { .. } => field.is_written(),
            _ => shape.dimensions.contains(&field.name()) && !field.is_given(),
        };
        let damaged = |field: &dyn StatedField| field.is_written() && !field.is_given();
        let lost_mass = fields.is_empty() && (damaged(&section.mass) || damaged(&section.density));
        !fields.iter().any(unread) && !lost_mass
    };
    let place = |error: &BodyError| {
        let named = body_fields(error, section).into_iter().next().filter(|field| field.is_given());
        named.map_or_else(|| section.shape.span(), StatedField::span)
    };
    let faults = body_of(section, shape.kind).faults();
    faults.into_iter().filter(is_new).map(|error| (place(&error), error)).collect()
}

/// Returns the body that a table describes; `None` if a required key was refused or is missing.
pub(crate) fn body(section: &BodySection) -> Option<Body> {
    let shape = section.shape()?;
    let has = |name: &&str| section.field(name).is_some_and(StatedField::is_given);
    (section.is_whole() && shape.dimensions.iter().all(has)).then(|| body_of(section, shape.kind))
}

/// Returns the body, with defaults for keys that are not stated.
fn body_of(section: &BodySection, kind: BodyKind) -> Body {
    Body {
        shape: shape_of(section, kind),
        mass: section.mass.value(),
        density: section.density.value(),
        distance: section.distance.or_zero(),
        angle: section.angle.or_zero(),
        count: section.count(),
    }
}

fn shape_of(section: &BodySection, kind: BodyKind) -> SolidShape {
    let orientation = section.axis.value().map(choices::orientation).unwrap_or_default();
    let (diameter, length, height) = (section.diameter.or_zero(), section.length.value(), section.height.value());
    match kind {
        BodyKind::Tube => {
            SolidShape::Tube { outer: section.outer.or_zero(), inner: section.inner.or_zero(), length, orientation }
        }
        BodyKind::Box => SolidShape::Box { a: section.a.or_zero(), b: section.b.or_zero(), height },
        BodyKind::Cone => SolidShape::Cone { diameter, height },
        BodyKind::Sphere => SolidShape::Sphere { diameter },
        BodyKind::Point => SolidShape::PointMass,
        BodyKind::Rod => SolidShape::Rod { length: section.length.or_zero() },
        BodyKind::Cylinder | BodyKind::Disc => SolidShape::Cylinder { diameter, length, orientation },
    }
}

/// Returns solid bodies with their inertia.
pub(crate) fn summed(sections: &[BodySection]) -> Option<InertiaAnswer> {
    let bodies: Vec<Body> = sections.iter().filter_map(body).collect();
    let total = mechanism::inertia(&bodies).ok()?;
    Some(InertiaAnswer { bodies: sections.iter().filter_map(parts).collect(), total })
}

fn parts(section: &BodySection) -> Option<BodyAnswer> {
    let (shape, body) = (section.shape()?, body(section)?);
    body.inertia().ok().map(|parts| BodyAnswer { shape, body, parts })
}

/// Returns the fields that an error is about; empty for a missing mass, or the whole body.
pub(crate) fn body_fields<'s>(error: &BodyError, body: &'s BodySection) -> Vec<&'s dyn StatedField> {
    match error {
        BodyError::DimensionOutOfRange { field, .. } | BodyError::DimensionMissing { field } => {
            body.field(field).into_iter().collect()
        }
        BodyError::InnerNotBelowOuter { .. } => vec![&body.inner, &body.outer],
        BodyError::MassAndDensity { .. } | BodyError::NoVolume | BodyError::DensityOutOfRange { .. } => {
            vec![&body.density]
        }
        BodyError::MassOutOfRange { .. } => vec![&body.mass],
        BodyError::DistanceOutOfRange { .. } => vec![&body.distance],
        BodyError::AngleNotFinite => vec![&body.angle],
        BodyError::NoPiece => vec![&body.count],
        BodyError::NoMass | BodyError::BeyondNumbers => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{AxisProject, NoCatalogue};

    /// Lines with the identifier of their fault and the faulty part; sound ones without.
    const LINES: [(&str, Option<(&str, &str)>); 9] = [
        ("disc diameter=1m length=1mm mass=1kg", None),
        ("point mass=0.6 kg distance=80 mm", None),
        ("disc diameter=1m length=1mm mass=1", Some(("unit_missing", "1"))),
        ("blob mass=1kg", Some(("no_shape", "blob"))),
        ("disc diameter=1m length=1mm mas=1kg", Some(("key_of_another_shape", "mas"))),
        ("disc diameter=1m length=1mm", Some(("body_without_mass", "disc"))),
        ("point mass=1kg distance=-1m", Some(("body_distance_out_of_range", "-1m"))),
        ("tube outer=10mm inner=20mm length=1mm mass=1kg", Some(("body_inner_not_below_outer", "20mm"))),
        ("point mass=1kg count=0", Some(("body_no_piece", "0"))),
    ];

    fn listed(text: &str, faults: Vec<AxisDiagnostic>) -> Vec<(&'static str, String)> {
        let of = |fault: AxisDiagnostic| (fault.fault.id(), text.get(fault.span).unwrap_or_default().to_owned());
        faults.into_iter().map(of).collect()
    }

    /// Faults of the values and faults of the bodies that they describe appear at once, each at its value, for bodies alone
    /// and for those of a project.
    #[test]
    fn faults_of_values_and_of_bodies_appear_at_once() {
        let all = LINES.iter().flat_map(|one| LINES.iter().flat_map(move |two| LINES.map(|three| [*one, *two, three])));
        for lines in all {
            let expected: Vec<(&str, String)> =
                lines.iter().filter_map(|(_, fault)| fault.map(|(id, part)| (id, part.to_owned()))).collect();
            let text = lines.map(|(line, _)| line).join("\n");
            assert_eq!(listed(&text, inertia(&text).err().unwrap_or_default()), expected, "{text}");
            let bodies = lines.map(|(line, _)| format!("  \"{line}\",\n")).concat();
            let text = format!(
                "format = 1\n[mechanism.turntable]\naxis_tilt = \"0 deg\"\nbodies = [\n{bodies}]\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n"
            );
            let found = AxisProject::read(&text, &NoCatalogue::shared(), &|_, _| None).err().unwrap_or_default();
            assert_eq!(listed(&text, found), expected, "{text}");
        }
    }
}
