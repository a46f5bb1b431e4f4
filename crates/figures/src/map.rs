//! Map of all candidates: margin over mass or length.

use crate::drawing::{Chart, Drawing, Figure};
use crate::labels::{amount, percent};
use plot::{Dash, Markers, Note, PlaneAxis, Reference, Shape, Tone, XyChart};
use quantities::unit::{KILOGRAM, MILLIMETRE};
use quantities::{Language, Measure, Unit};
use questions::{Candidate, Fit, ProductId, Sizing};
use words::{capitalised, pictures, terms};

/// Quantity on the horizontal axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// Mass.
    Mass,
    /// Length.
    Length,
}

/// Candidates with less margin than this are omitted, since they would compress the scale for the others.
const MARGIN_MIN: f64 = -0.5;

/// Number of named best candidates in addition to the marked one.
const NAMED: usize = 4;

impl By {
    const fn unit(self) -> &'static Unit {
        match self {
            Self::Mass => &KILOGRAM,
            Self::Length => &MILLIMETRE,
        }
    }

    fn of(self, candidate: &Candidate<'_>) -> Option<f64> {
        match self {
            Self::Mass => Some(candidate.parameters.mass.known()?.value.si()),
            Self::Length => Some(candidate.parameters.length.known()?.value.si()),
        }
    }
}

/// A point in the map in the units of its axes, and the extent of the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapPoint {
    at: (f64, f64),
    reach: (f64, f64),
}

impl MapPoint {
    /// Parses four numbers: both coordinates, then the extent of both axes.
    #[must_use]
    pub fn read(text: &str) -> Option<Self> {
        let mut numbers = text.split(' ').map(|part| part.parse::<f64>().ok().filter(|number| number.is_finite()));
        let mut next = || numbers.next().flatten();
        let place = Self { at: (next()?, next()?), reach: (next()?, next()?) };
        (place.reach.0 > 0.0 && place.reach.1 > 0.0).then_some(place)
    }
}

/// Largest distance at which a point is selected, as a share of the map.
const MEANT: f64 = 0.04;

/// Returns the candidate whose point in the map is nearest to a point, if one is near.
#[must_use]
pub fn nearest<'s>(sizing: &'s Sizing<'_>, by: By, place: MapPoint) -> Option<&'s ProductId> {
    let distance = |candidate: &Candidate<'_>| {
        let (x, y) = point(by, candidate)?;
        let (dx, dy) = ((x - place.at.0) / place.reach.0, (y - place.at.1) / place.reach.1);
        Some(dx.hypot(dy)).filter(|distance| *distance <= MEANT)
    };
    let all = sizing.candidates.iter().filter_map(|candidate| Some((&candidate.id, distance(candidate)?)));
    all.min_by(|(_, a), (_, b)| a.total_cmp(b)).map(|(id, _)| id)
}

/// Returns the point of a candidate in the map; `None` if no check has a margin, or if its excess is so large that it is left
/// out.
fn point(by: By, candidate: &Candidate<'_>) -> Option<(f64, f64)> {
    let margin = 1.0 - candidate.utilisation()?;
    (margin >= MARGIN_MIN).then_some((by.unit().from_si(by.of(candidate)?), margin * 100.0))
}

/// Returns `true` if the map of these candidates shows any of them.
#[must_use]
pub fn has_points(sizing: &Sizing<'_>, by: By) -> bool {
    sizing.candidates.iter().chain(sizing.own.as_ref()).any(|candidate| point(by, candidate).is_some())
}

/// Draws every candidate by mass or length and by the margin of its governing check; one of them may be marked.
#[must_use]
pub fn candidate_map(sizing: &Sizing<'_>, by: By, marked: Option<&ProductId>, language: Language) -> Drawing {
    let all: Vec<&Candidate<'_>> = sizing.candidates.iter().chain(sizing.own.as_ref()).collect();
    let place = |candidate: &Candidate<'_>| point(by, candidate);
    let shared = shared_series(sizing);
    let named: Vec<&ProductId> = all
        .iter()
        .filter(|candidate| candidate.fits() && Some(&candidate.id) != marked)
        .map(|candidate| &candidate.id)
        .take(NAMED)
        .collect();
    let points = |of: &dyn Fn(&Candidate<'_>) -> bool| {
        let found = all.iter().filter(|candidate| of(candidate)).filter_map(|candidate| {
            let (x, y) = place(candidate)?;
            let name = if named.contains(&&candidate.id) { short(candidate, shared) } else { String::new() };
            Some(((x, y, name), candidate.id.to_string()))
        });
        found.collect::<Vec<_>>()
    };
    let axis = match by {
        By::Mass => PlaneAxis::new("m", "kg").name(&capitalised(terms::mass(language))),
        By::Length => PlaneAxis::new("L", "mm").name(pictures::length(language)),
    };
    let mut chart = XyChart::map(axis, PlaneAxis::new("", "%").name(pictures::margin_to_the_tightest_limit(language)))
        .with(Reference::horizontal(0.0).tone(Tone::Continuous).dash(Dash::Solid))
        .nothing(pictures::no_candidate_can_be_shown(&all.len(), &percent(MARGIN_MIN, language), language));
    // Fitting candidates are drawn last, on top of the others.
    for (name, tone, points) in [
        (pictures::limit_exceeded(language), Tone::Series(1), points(&|candidate| !candidate.judgement_fits())),
        (
            terms::requirement_not_met(language),
            Tone::Muted,
            points(&|candidate| !candidate.fits() && candidate.judgement_fits()),
        ),
        (terms::fits(language), Tone::Series(2), points(&|candidate| candidate.fit() == Fit::Fits)),
        (
            terms::fits_if_estimate(language),
            Tone::Series(4),
            points(&|candidate| candidate.fit() == Fit::FitsIfEstimate),
        ),
    ] {
        // A class without a point keeps its marker and is not in the legend.
        let (points, subjects): (Vec<_>, Vec<String>) = points.into_iter().unzip();
        chart = chart.class(if points.is_empty() { "" } else { name }, tone, points).subjects(subjects);
    }
    let marked = marked.and_then(|id| all.iter().find(|candidate| candidate.id == *id));
    if let Some(candidate) = marked
        && let Some((x, y)) = place(candidate)
    {
        // Around the marker of its class, which stays visible.
        let markers = Markers::new([(x, y)]).shape(Shape::Ring).label(candidate.id.to_string());
        chart = chart.with(markers.class("marked")).with(Note::new(x, y, candidate.id.to_string()));
    }
    let left_out = all.iter().filter(|candidate| place(candidate).is_none()).count();
    let floor = percent(MARGIN_MIN, language);
    let caption = pictures::candidate_map_caption(&left_out, &floor, language);
    let description = description(sizing, &all, by, marked.copied(), language);
    let of = if sizing.name.is_empty() { terms::axis(language) } else { sizing.name };
    Drawing::new(Figure::CandidateMap, of, (165.0, 115.0), (caption, description), Chart::Xy(chart), language)
}

/// Returns the series of the products, if all share one.
fn shared_series<'s>(sizing: &'s Sizing<'_>) -> Option<&'s str> {
    let first = sizing.candidates.first()?.product.series.as_deref()?;
    let shares = |candidate: &Candidate<'_>| candidate.product.series.as_deref() == Some(first);
    sizing.candidates.iter().all(shares).then_some(first)
}

/// Returns the identity of a candidate without the name of the series that all share.
fn short(candidate: &Candidate<'_>, shared: Option<&str>) -> String {
    let text = candidate.id.to_string();
    let rest = shared.and_then(|series| text.strip_prefix(series)?.strip_prefix('-'));
    rest.unwrap_or(&text).to_owned()
}

fn description(
    sizing: &Sizing<'_>,
    all: &[&Candidate<'_>],
    by: By,
    marked: Option<&Candidate<'_>>,
    language: Language,
) -> String {
    let is_fitting = |candidate: &&&Candidate<'_>| candidate.fits() && !candidate.counts().are_all_open();
    let fitting = all.iter().filter(is_fitting).count();
    let mut text = pictures::how_many_fit(&all.len(), &fitting, language);
    let sentence = |candidate: &Candidate<'_>| {
        let figure = by.of(candidate).map_or_else(|| "–".to_owned(), |si| amount(si, by.unit(), language));
        let Some(margin) = candidate.utilisation().map(|share| 1.0 - share) else {
            return pictures::candidate_not_checked(&candidate.id, &figure, language);
        };
        if !margin.is_finite() {
            return pictures::candidate_without_margin(&candidate.id, &figure, language);
        }
        let margin = percent(margin, language);
        pictures::candidate_with_margin(&candidate.id, &figure, &margin, language)
    };
    if let Some(best) = sizing.answer() {
        text.push_str(&format!(" {}: {}.", pictures::the_best(language), sentence(best)));
    }
    if let Some(marked) = marked
        && sizing.answer().is_none_or(|best| best.id != marked.id)
    {
        text.push_str(&format!(" {}: {}.", pictures::marked(language), sentence(marked)));
    }
    text
}
