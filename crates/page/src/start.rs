//! The start page: a mechanism, at most six values, a first answer.

use crate::call::{Call, Shell};
use crate::sketch;
use maud::{Markup, html};
use project::{Edit, EditFault, Key, Kind, SegmentLaw, edit, key_at, stretch, written};
use quantities::{Angle, Language, Length, Measure, format_significant, parse_as};
use questions::list::new::template;
use questions::list::size::sized;
use questions::{MechanismId, Progress, Rejected, read_all_watched};
use std::sync::LazyLock;
use words::{about_text, capitalised, hyphenated, incoming, page, short_label, terminal};

/// A way to begin: the values of the example of a mechanism, and the keys to fill in.
pub(crate) struct Begin {
    pub(crate) mechanism: Option<&'static str>,
    /// The example without the requirements of its own machine.
    text: String,
    /// Path and value of each key to fill in.
    pub(crate) asked: Vec<(String, String)>,
}

/// Largest number of values to fill in.
const ASKED_MOST: usize = 6;

/// The ways to begin: each mechanism that needs neither a recording nor rows of points.
pub(crate) static BEGINS: LazyLock<Vec<Begin>> = LazyLock::new(|| {
    let few = |id: &&MechanismId| !matches!(id, MechanismId::Joint | MechanismId::Table);
    MechanismId::ALL.iter().filter(few).filter_map(|id| Begin::of(*id).ok()).collect()
});

impl Begin {
    fn of(id: MechanismId) -> Result<Self, EditFault> {
        let mut text: String =
            id.example().lines().filter(|line| !line.starts_with("# ")).fold(String::new(), |mut text, line| {
                text.push_str(line.split_once(" #").map_or(line, |(stated, _)| stated.trim_end()));
                text.push('\n');
                text
            });
        // Loads on the flange, drive and the other requirements belong to another machine.
        let own = |path: &str| {
            path.starts_with("bearing")
                || path.starts_with("drive")
                || path.ends_with("].bearing")
                || path == "axis.name"
                || path.starts_with("requirements.") && path != "requirements.supply"
        };
        while let Some(gone) = written(&text).ok_or(EditFault::Syntax)?.into_iter().find(|key| own(&key.path)) {
            text = edit(&text, &gone.path, Edit::Gone)?;
        }
        let stated = written(&text).ok_or(EditFault::Syntax)?;
        // A cycle that does not return to its start runs once.
        if !stated.iter().any(|key| key.value.as_ref().is_some_and(|value| value.starts_with('-'))) {
            text = edit(&text, "axis.single_move", Edit::Value("true"))?;
        }
        let figures = |table: &'static str, most: usize| {
            let quantity = |key: &Key| matches!(key.kind, Kind::Quantity(..) | Kind::Along(..));
            let of_table = stated.iter().filter(move |each| each.path.starts_with(table));
            let mut found: Vec<(bool, String, String)> = of_table
                .filter_map(|each| {
                    let key = key_at(&each.path).filter(|key| quantity(key))?;
                    let first = key.required || each.path.contains("[1]");
                    Some((!first, each.path.clone(), each.value.clone()?))
                })
                .collect();
            found.sort_by_key(|(later, ..)| *later);
            found.into_iter().take(most).map(|(_, path, value)| (path, value)).collect::<Vec<_>>()
        };
        let motion = [figures("motion[1].", 2), figures("motion[2].time", 1)].concat();
        let load = if id == MechanismId::Load { "load." } else { "mechanism." };
        let asked = [figures(load, ASKED_MOST - motion.len()), motion].concat();
        let mechanism = (id != MechanismId::Load).then(|| id.key());
        Ok(Self { mechanism, text, asked })
    }

    /// Returns the project file with the typed values. Another distance or time of the first segment scales all
    /// segments, so that the cycle still returns to its start.
    pub(crate) fn text(&self, typed: impl Fn(&str) -> Option<String>) -> String {
        let mut text = self.text.clone();
        for (path, usual) in &self.asked {
            let Some(value) = typed(path).filter(|value| value != usual) else { continue };
            let factor = share(&value, usual);
            let stretched = match (path.as_str(), factor) {
                ("motion[1].distance", Some(way)) => stretched(&text, 1.0, way),
                ("motion[1].time", Some(time)) => stretched(&text, time, 1.0),
                _ => None,
            };
            let base = stretched.unwrap_or_else(|| text.clone());
            text = edit(&base, path, Edit::Value(&value)).unwrap_or(base);
        }
        text
    }
}

/// Returns the ratio of two quantities.
fn share(value: &str, of: &str) -> Option<f64> {
    fn both<Q: Measure>(value: &str, of: &str) -> Option<f64> {
        Some(parse_as::<Q>(value).ok()?.si() / parse_as::<Q>(of).ok()?.si())
    }
    both::<Length>(value, of).or_else(|| both::<Angle>(value, of)).or_else(|| both::<quantities::Time>(value, of))
}

/// Scales time and distance of every segment but the dwells.
fn stretched(text: &str, time: f64, way: f64) -> Option<String> {
    let laws =
        written(text)?.into_iter().filter_map(|key| Some((key.path.strip_suffix(".law")?.to_owned(), key.value?)));
    let mut moves = laws.filter(|(_, law)| SegmentLaw::of_id(law) != Some(SegmentLaw::Dwell));
    moves.try_fold(text.to_owned(), |text, (segment, _)| stretch(&text, &segment, time, way)).ok()
}

/// Returns the title of a mechanism.
fn title(mechanism: Option<&str>, language: Language) -> String {
    let Some(name) = mechanism else { return page::load_at_the_output(language).to_owned() };
    key_at(&format!("mechanism.{name}")).map(|key| capitalised(about_text(key.about, language))).unwrap_or_default()
}

/// Returns the ways to begin, as drawings.
pub(crate) fn tiles(language: Language) -> Markup {
    html! {
        ul.tiles { @for (place, begin) in BEGINS.iter().enumerate() {
            @let title = title(begin.mechanism, language);
            li { button.tile type="button" hx-get={ "/begin?kind=" (place) "&lang=" (language.id()) } hx-target="#begin" hx-swap="innerHTML" hx-include="unset" {
                span.sketch aria-hidden="true" { (sketch::still(begin.mechanism)) }
                span { (hyphenated(&title)) }
            } }
        }
            li { button.tile type="button" id="tile-recording" data-recording="" title=(incoming::tile_about(language)) {
                span.sketch aria-hidden="true" { (sketch::recording()) }
                span { (hyphenated(incoming::tile(language))) }
            } }
        }
    }
}

/// Returns the few values of a way to begin, next to a drawing that follows them.
pub(crate) fn asked(place: usize, language: Language) -> Markup {
    let Some(begin) = BEGINS.get(place) else { return html! {} };
    html! {
        form.begin-form.rows method="get" action="/" aria-labelledby="begin-title" {
            h3 id="begin-title" tabindex="-1" { (title(begin.mechanism, language)) }
            span.sketch id="begin-sketch" { (drawing(begin, &begin.text(|_| None), language)) }
            p.small { (page::usual_values(language)) }
            @for (path, value) in &begin.asked {
                @let id = crate::markup::id(path);
                div.row {
                    label for=(id) { (key_at(path).map(|key| capitalised(&short_label(about_text(key.about, language)))).unwrap_or_default()) @if path.starts_with("motion[2]") { " (" (words::law_text(SegmentLaw::Dwell, language)) ")" } }
                    input id=(id) name=(path) type="text" value=(crate::value::with_mark(value, language)) autocomplete="off" spellcheck="false"
                        hx-get="/begin/drawing" hx-trigger="input changed delay:100ms" hx-target="#begin-sketch" hx-swap="innerHTML" hx-include="closest form";
                }
            }
            input type="hidden" name="begin" value=(place);
            input type="hidden" name="lang" value=(language.id());
            button.primary type="submit" { (page::first_answer(language)) }
        }
    }
}

/// Returns the text of a way to begin with the typed values.
pub(crate) fn typed(begin: &Begin, call: &Call<'_>) -> String {
    begin.text(|path| call.field(path).map(|typed| crate::value::with_point(&typed, call.language())))
}

/// Returns the drawing of a way to begin with the typed values.
pub(crate) fn drawing_of(call: &Call<'_>) -> Markup {
    let begin = BEGINS.get(crate::files::place(call));
    html! { @if let Some(begin) = begin { (drawing(begin, &typed(begin, call), call.language())) } }
}

/// Returns the drawing to the scale of a text; invalid values are left out.
fn drawing(begin: &Begin, text: &str, language: Language) -> Markup {
    let of = begin.mechanism.map_or_else(|| "load".to_owned(), |name| format!("mechanism.{name}"));
    let stated = written(text).unwrap_or_default();
    let figures = stated.iter().filter_map(|key| Some((key.path.as_str(), key.value.as_deref()?)));
    let project = questions::read(text).ok();
    let it = sketch::SketchContent {
        mechanism: begin.mechanism,
        figures: axis::drawn_figures(figures, &of),
        of: &of,
        title: &title(begin.mechanism, language),
        project: project.as_ref(),
    };
    sketch::shown(&it, language)
}

/// Returns the result of an example, for its card.
pub(crate) fn example_verdict(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Markup {
    let l = call.language();
    let kind = call.field("kind").unwrap_or_default();
    let Some(found) = template(&kind, crate::head::USUAL_NAME, l).filter(|found| found.recording.is_none()) else {
        return html! {};
    };
    let Ok(projects) = read_all_watched(&found.text, shell.files(), shell.catalogue(), progress) else {
        return html! {};
    };
    let Some((project, sizing)) =
        projects.first().and_then(|project| Some((project, sized(project, 0, Rejected::None, progress).ok()?)))
    else {
        return html! {};
    };
    let cycle = format_significant(project.axis.motion.duration().si(), 3, l);
    html! {
        @match sizing.answer() {
            Some(best) => span class=(crate::shown::class(best)) { (best.id) },
            None => span.fail { (capitalised(terminal::no_actuator_fits(l))) },
        }
        " " span.small { (page::cycle_of(&cycle, l)) }
    }
}

/// Returns the mechanism of a project's text.
pub(crate) fn mechanism_of(text: &str) -> Option<String> {
    project::written(text)?
        .iter()
        .find_map(|key| key.path.strip_prefix("mechanism.")?.split('.').next().map(str::to_owned))
}

/// Returns the first line of an example: its description.
pub(crate) fn about<'t>(text: &'t str, kind: &'t str) -> &'t str {
    text.lines().find_map(|line| line.strip_prefix("# ")).unwrap_or(kind)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails loudly")]

    use super::*;

    #[test]
    fn every_way_to_begin_asks_for_at_most_six_figures_and_has_an_answer() {
        for begin in BEGINS.iter() {
            assert!(begin.asked.len() <= ASKED_MOST, "{:?}", begin.mechanism);
            let text = begin.text(|_| None);
            let project = questions::read(&text);
            assert!(project.is_ok(), "{text}\n{project:?}");
            let fits = project.is_ok_and(|project| questions::size(&project).fits());
            assert!(fits, "{text}");
        }
    }

    #[test]
    fn what_is_typed_takes_the_place_of_what_is_proposed() {
        let belt = BEGINS.iter().find(|begin| begin.mechanism == Some("belt")).unwrap();
        let text = belt.text(|path| (path == "motion[1].distance").then(|| "-0.25 m".to_owned()));
        assert!(text.contains("distance = \"-0.25 m\"") && text.contains("distance = \"250 mm\""), "{text}");
        let text = belt.text(|path| (path == "mechanism.belt.mass").then(|| "heavy".to_owned()));
        assert!(text.contains("mass = \"heavy\""), "{text}");
    }

    #[test]
    fn every_mechanism_that_is_stated_by_figures_begins_with_those_of_its_example() {
        assert_eq!(BEGINS.len(), MechanismId::ALL.len() - 2);
        for begin in BEGINS.iter() {
            let asked: Vec<&str> = begin.asked.iter().map(|(path, _)| path.as_str()).collect();
            assert!(asked.len() >= 4 && asked.iter().all(|path| key_at(path).is_some()), "{asked:?}");
            assert!(!begin.text.contains("[bearing]") && begin.text.contains("supply"), "{}", begin.text);
        }
    }
}
