//! Torsion curve of the gear with its working point.

use crate::drawing::{Chart, Drawing, Figure};
use crate::fault::NoFigure;
use crate::labels::{amount, subject};
use axis::AxisProject;
use plot::{Dash, Label, Line, Markers, PlaneAxis, Reference, Tone, Width, XyChart};
use quantities::unit::{ARCMINUTE, NEWTON_METRE};
use quantities::{Language, Measure, Torque};
use questions::{Candidate, TorsionCurve};
use words::pictures;

/// Extent of the curve relative to its outermost point.
const ROOM: f64 = 1.15;

/// Draws the torsion curve of a candidate's gear, both directions, with the largest torque of the project.
///
/// # Errors
/// [`NoFigure::NoStiffness`]
pub fn torsion(project: &AxisProject, candidate: &Candidate<'_>, language: Language) -> Result<Drawing, NoFigure> {
    let found = questions::torsion_of(project, candidate).ok_or(NoFigure::NoStiffness)?;
    Ok(drawn(&subject(candidate, &project.name), &found, Point::OfTheLoad, language))
}

/// Draws the torsion curve of a gear, both directions, with a point on it; `name` is its subject.
#[must_use]
pub fn torsion_curve(name: &str, found: &TorsionCurve, language: Language) -> Drawing {
    drawn(name, found, Point::Inquiry, language)
}

/// Kind of the point on the curve.
#[derive(Clone, Copy)]
enum Point {
    /// Largest torque of a load.
    OfTheLoad,
    /// Requested torque.
    Inquiry,
}

fn drawn(about: &str, found: &TorsionCurve, point: Point, language: Language) -> Drawing {
    let end = found.torque.si().abs().max(found.curve.torque_2.si()) * ROOM;
    let points = found.points(Torque::from_si(end));
    let nm = |torque: Torque| NEWTON_METRE.from_si(torque.si());
    let curve = points.iter().map(|(torque, angle)| (nm(*torque), ARCMINUTE.from_si(angle.si())));
    let work = (nm(found.torque), ARCMINUTE.from_si(found.angle.si()));
    let (torque, angle) =
        (amount(found.torque.si(), &NEWTON_METRE, language), amount(found.angle.si(), &ARCMINUTE, language));
    let border =
        |torque: Torque, symbol: &str| Reference::vertical(nm(torque)).dash(Dash::Dotted).label(Label::symbol(symbol));
    let name = pictures::working_point(language);
    let chart = XyChart::new(
        PlaneAxis::new("T", NEWTON_METRE.symbol).name(pictures::torque_on_the_gear(language)),
        PlaneAxis::new("φ", "arcmin").name(pictures::torsion(language)),
    )
    .four_quadrant()
    .with(border(found.curve.torque_1, "T_1"))
    .with(border(found.curve.torque_2, "T_2"))
    .with(Line::new(curve).tone(Tone::Series(0)).width(Width::Strong).class("torsion"))
    .with(Markers::new([work]).label(format!("{name}: {torque}, {angle}")).class("working-point"));
    let (one, two) = (
        amount(found.curve.torque_1.si(), &NEWTON_METRE, language),
        amount(found.curve.torque_2.si(), &NEWTON_METRE, language),
    );
    let caption = pictures::torsion_caption(&one, &two, language);
    let (description, caption) = match point {
        Point::OfTheLoad => (
            pictures::torsion_described(&torque, &angle, &one, &two, language),
            format!("{caption} {}", pictures::torque_of_the_load(language)),
        ),
        Point::Inquiry => (pictures::torsion_of_a_code_described(&torque, &angle, &one, &two, language), caption),
    };
    Drawing::new(Figure::Torsion, about, (135.0, 95.0), (caption, description), Chart::Xy(chart), language)
}
