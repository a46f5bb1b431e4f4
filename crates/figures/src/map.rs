//! All candidates in one picture: margin over mass or length.

use crate::drawing::{Drawing, Figure};
use crate::words::{amount, percent, say};
use plot::{Axis, Dash, MapChart, Markers, Note, Reference, Shape, Tone};
use workbench::quantities::unit::{KILOGRAM, MILLIMETRE};
use workbench::quantities::{Language, Measure, Unit};
use workbench::{Candidate, CandidateId, Sizing, Verdict};

/// What the candidates are laid out by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// Mass.
    Mass,
    /// Length.
    Length,
}

/// Candidates with less margin than this are left out: they miss by so much that the others could not be told apart.
const MARGIN_MIN: f64 = -0.5;

/// How many of the best are named besides the one marked.
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

/// Every candidate by mass or length and by the margin to its tightest limit; one of them may be marked.
#[must_use]
pub fn candidate_map(sizing: &Sizing<'_>, by: By, marked: Option<&CandidateId>, language: Language) -> Drawing {
    let t = |en, de| say(language, en, de);
    let all: Vec<&Candidate<'_>> = sizing.candidates.iter().chain(sizing.own.as_ref()).collect();
    let margin = |candidate: &Candidate<'_>| 1.0 - candidate.standing.utilisation;
    let place = |candidate: &Candidate<'_>| {
        let x = by.of(candidate)?;
        (margin(candidate) >= MARGIN_MIN).then(|| (by.unit().from_si(x), margin(candidate) * 100.0))
    };
    let named: Vec<&CandidateId> = all
        .iter()
        .map(|candidate| (&candidate.id, candidate.fits()))
        .filter(|(id, fits)| *fits && Some(*id) != marked)
        .map(|(id, _)| id)
        .take(NAMED)
        .collect();
    let points = |of: &dyn Fn(&Candidate<'_>) -> bool| {
        let found = all.iter().filter(|candidate| of(candidate)).filter_map(|candidate| {
            let (x, y) = place(candidate)?;
            let name = if named.contains(&&candidate.id) { short(&candidate.id) } else { String::new() };
            Some((x, y, name))
        });
        found.collect::<Vec<_>>()
    };
    let axis = match by {
        By::Mass => Axis::new("m", "kg").name(t("Mass", "Masse")),
        By::Length => Axis::new("L", "mm").name(t("Length", "Länge")),
    };
    let mut chart =
        MapChart::new(axis, Axis::new("", "%").name(t("Margin to the tightest limit", "Reserve zur engsten Grenze")))
            .with(Reference::horizontal(0.0).tone(Tone::Continuous).dash(Dash::Solid))
            .nothing(nothing(&all, language));
    let advised = |candidate: &Candidate<'_>| {
        candidate.fits() && candidate.judgement.checks.iter().any(|check| check.verdict == Verdict::Advice)
    };
    // What fits is drawn last, upon the others.
    for (name, tone, points) in [
        (
            t("limit exceeded", "Grenze überschritten"),
            Tone::Series(1),
            points(&|candidate| !candidate.judgement_fits()),
        ),
        (
            t("requirement not met", "Anforderung nicht erfüllt"),
            Tone::Muted,
            points(&|candidate| !candidate.fits() && candidate.judgement_fits()),
        ),
        (t("fits", "geeignet"), Tone::Series(2), points(&|candidate| candidate.fits() && !advised(candidate))),
        (t("fits, with advice", "geeignet, mit Hinweis"), Tone::Series(4), points(&advised)),
    ] {
        // A class without a point keeps its marker and has no place in the legend.
        chart = chart.class(if points.is_empty() { "" } else { name }, tone, points);
    }
    let marked = marked.and_then(|id| all.iter().find(|candidate| candidate.id == *id));
    if let Some(candidate) = marked
        && let Some((x, y)) = place(candidate)
    {
        // Around the marker of its class, which stays to be seen.
        let markers = Markers::new([(x, y)]).shape(Shape::Ring).label(candidate.id.to_string());
        chart = chart.with(markers.class("marked")).with(Note::new(x, y, candidate.id.to_string()));
    }
    let left_out = all.iter().filter(|candidate| place(candidate).is_none()).count();
    let floor = percent(MARGIN_MIN, language);
    let caption = match language {
        Language::En => format!(
            "Each point is an actuator of the catalogue; below the red line a limit or a recommendation is exceeded. {left_out} are left out: margin below {floor}, or no figure known."
        ),
        Language::De => format!(
            "Jeder Punkt ist ein Antrieb des Katalogs; unter der roten Linie ist eine Grenze oder eine Empfehlung überschritten. {left_out} fehlen: Reserve unter {floor}, oder Angabe nicht bekannt."
        ),
    };
    let description = description(sizing, &all, by, marked.copied(), language);
    let of = if sizing.name.is_empty() { t("axis", "Achse") } else { sizing.name };
    Drawing::new(Figure::CandidateMap, of, (165.0, 115.0), language).map(caption, description, chart)
}

/// What stands in place of a map on which no candidate finds a place.
fn nothing(all: &[&Candidate<'_>], language: Language) -> String {
    let (count, floor) = (all.len(), percent(MARGIN_MIN, language));
    match language {
        Language::En => format!(
            "No candidate can be shown: each of the {count} misses its tightest limit by so much that its margin is below {floor}, or a figure of it is not known."
        ),
        Language::De => format!(
            "Kein Kandidat lässt sich zeigen: Jeder der {count} überschreitet seine engste Grenze so weit, dass seine Reserve unter {floor} liegt, oder eine Angabe zu ihm ist nicht bekannt."
        ),
    }
}

/// A code without the name of the series, which all share.
fn short(id: &CandidateId) -> String {
    let text = id.to_string();
    text.strip_prefix("CHA-").unwrap_or(&text).to_owned()
}

fn description(
    sizing: &Sizing<'_>,
    all: &[&Candidate<'_>],
    by: By,
    marked: Option<&Candidate<'_>>,
    language: Language,
) -> String {
    let fitting = all.iter().filter(|candidate| candidate.fits()).count();
    let mut text = match language {
        Language::En => format!("{} actuators, {fitting} fit.", all.len()),
        Language::De => format!("{} Antriebe, {fitting} davon geeignet.", all.len()),
    };
    let told = |candidate: &Candidate<'_>| {
        let figure = by.of(candidate).map_or_else(|| "–".to_owned(), |si| amount(si, by.unit(), language));
        let margin = 1.0 - candidate.standing.utilisation;
        if !margin.is_finite() {
            return match language {
                Language::En => format!("{}, {figure}, without margin: a limit is zero", candidate.id),
                Language::De => format!("{}, {figure}, ohne Reserve: eine Grenze ist null", candidate.id),
            };
        }
        let margin = percent(margin, language);
        match language {
            Language::En => format!("{}, {figure}, margin {margin}", candidate.id),
            Language::De => format!("{}, {figure}, Reserve {margin}", candidate.id),
        }
    };
    if let Some(best) = sizing.answer() {
        text.push_str(&format!(" {}: {}.", say(language, "The best", "Der beste"), told(best)));
    }
    if let Some(marked) = marked
        && sizing.answer().is_none_or(|best| best.id != marked.id)
    {
        text.push_str(&format!(" {}: {}.", say(language, "Marked", "Markiert"), told(marked)));
    }
    text
}
