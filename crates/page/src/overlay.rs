//! Overlays of the pictures: the instant, marks of the governing instants, ends of segments to drag. A script places
//! each by the numbers that it gets from here.

use crate::checks::verdict_class;
use crate::state::PageState;
use axis::AxisProject;
use maud::{Markup, html};
use quantities::unit::SECOND;
use quantities::{Language, Measure, format_significant};
use questions::texts::by_importance;
use questions::{Candidate, Check, moves};
use words::{capitalised, law_text, page, title_of_check, views};

/// Controls of a window of time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ShownTime {
    /// Shows the whole time.
    Whole,
    /// Shows a part of it.
    Narrowed,
    /// The picture is not over time.
    None,
}

impl ShownTime {
    pub(crate) const fn of(window: Option<(f64, f64)>) -> Self {
        if window.is_some() { Self::Narrowed } else { Self::Whole }
    }
}

/// Returns the slider of the instant of all pictures, and the controls of their time window.
pub(crate) fn controls(until_s: f64, window: ShownTime, language: Language) -> Markup {
    let l = language;
    let whole = (window == ShownTime::Whole).then_some("true");
    html! {
        div.cursor {
            div.cursor-line-of {
                button.small type="button" id="play" data-play="" aria-label=(page::play(l)) title=(page::play(l)) data-other=(page::pause(l)) hx-morph-skip="" { "▶" }
                button.small type="button" id="slower" data-slower="" aria-label=(page::slower(l)) title=(page::slower(l)) { "½×" }
                span.small data-speed="" hx-morph-skip="" {}
                label.unseen for="instant" { (page::instant_on_the_axis(l)) }
                input id="instant" type="range" min="0" max="1000" value="0" step="1" title=(page::instant_on_the_axis(l)) data-until=(until_s) aria-describedby="instant-about" aria-keyshortcuts=[(window != ShownTime::None).then_some("+ - 0")];
                @if window != ShownTime::None {
                    span.zoom role="group" aria-label=(page::time_shown(l)) title=(views::zoom_about(l)) {
                        button type="button" id="zoom-in" data-zoom="in" aria-label=(page::zoom_in(l)) { "+" }
                        button type="button" id="zoom-out" data-zoom="out" aria-label=(page::zoom_out(l)) aria-disabled=[whole] { "−" }
                        button type="button" id="zoom-back" data-zoom="back" aria-label=(page::window_back(l)) title=(page::window_back(l)) aria-disabled=[whole] { "◂" }
                        button type="button" id="zoom-on" data-zoom="on" aria-label=(page::window_on(l)) title=(page::window_on(l)) aria-disabled=[whole] { "▸" }
                        button type="button" id="zoom-whole" data-zoom="whole" aria-disabled=[whole] { (page::whole_cycle(l)) }
                    }
                }
            }
            output.values id="instant-values" for="instant" hx-morph-skip="" {}
            span.unseen id="instant-about" { (page::cursor_about(l)) }
        }
    }
}

/// Returns the slider of the place in a plane that is not over time, and the row of its values; `figure` is the
/// identifier of the picture, `view` that of the view whose curves it has.
pub(crate) fn across(figure: &str, view: &str, language: Language) -> Markup {
    let l = language;
    html! {
        div.cursor {
            label.unseen for={ "across-" (figure) } { (views::place_on_the_axis(l)) }
            div.cursor-line-of { input.across id={ "across-" (figure) } type="range" min="0" max="1000" value="500" step="1" data-across={ "plot-" (figure) } data-view=(view) title=(views::across_about(l)); }
            output.values id={ "across-" (figure) "-values" } for={ "across-" (figure) } hx-morph-skip="" {}
        }
    }
}

/// Returns the slider through the points of the map of candidates, and the row of their values.
pub(crate) fn through_candidates(language: Language) -> Markup {
    let l = language;
    html! {
        div.cursor {
            label.unseen for="across-map" { (views::candidate_by_mass(l)) }
            div.cursor-line-of { input.across id="across-map" type="range" min="0" max="1000" value="0" step="1" data-across="plot-map" data-place="m kg" data-other=(views::margin(l)) title=(views::candidate_by_mass(l)); }
            output.values id="across-map-values" for="across-map" hx-morph-skip="" {}
        }
    }
}

/// An instant at which checks have their highest utilisation.
pub(crate) struct Worst<'c> {
    at_s: f64,
    checks: Vec<&'c Check>,
}

impl<'c> Worst<'c> {
    /// Returns the instant \[s\].
    pub(crate) const fn at_s(&self) -> f64 {
        self.at_s
    }

    /// Returns the checks with their highest utilisation at the instant.
    pub(crate) fn checks(&self) -> &[&'c Check] {
        &self.checks
    }
}

/// Returns the governing instants of a candidate in order of time; checks at the same instant are grouped.
pub(crate) fn worst<'c>(candidate: &'c Candidate<'_>) -> Vec<Worst<'c>> {
    let mut found: Vec<Worst<'c>> = Vec::new();
    for check in by_importance(&candidate.judgement.checks) {
        let Some(at_s) = check.at.map(Measure::si) else { continue };
        match found.iter_mut().find(|known| (known.at_s - at_s).abs() <= 1e-6 * at_s.abs()) {
            Some(known) => known.checks.push(check),
            None => found.push(Worst { at_s, checks: vec![check] }),
        }
    }
    found.sort_by(|a, b| a.at_s.total_cmp(&b.at_s));
    found
}

/// Returns the number of the mark of a check.
pub(crate) fn number(worst: &[Worst<'_>], check: &Check) -> Option<usize> {
    let place = worst.iter().position(|each| each.checks.iter().any(|other| other.id == check.id))?;
    Some(place + 1)
}

/// Returns the marks over a picture.
pub(crate) fn marks(worst: &[Worst<'_>], language: Language) -> Markup {
    let l = language;
    html! {
        @if !worst.is_empty() {
            div.marks-row role="group" aria-label=(page::worst_instants(l)) {
                @for (place, each) in worst.iter().enumerate() {
                    @let names = each.checks.iter().map(|check| title_of_check(check, l)).collect::<Vec<_>>().join(", ");
                    @let first = each.checks.first().map(|check| check.id.id()).unwrap_or_default();
                    @let title = format!("{}: {}", page::worst_instant(&SECOND.figure(each.at_s, 3, l), l), names);
                    @let class = each.checks.first().map(|check| verdict_class(check.verdict)).unwrap_or_default();
                    button type="button" class={ "mark-number " (class) } id={ "mark-" (place) } data-instant=(each.at_s) data-row={ "check-" (first) }
                        title=(title) aria-label={ (place + 1) ": " (title) } { (place + 1) }
                }
            }
        }
    }
}

/// Largest number of handles in a picture.
const HANDLES_MOST: usize = 100;

/// Returns the ends of the segments in the picture of the position, moved by pointer or arrow keys.
pub(crate) fn segment_handles(state: &PageState, project: &AxisProject) -> Markup {
    let l = state.language;
    let mut found = questions::segment_handles(project);
    let is_shown = |at: f64| state.window.is_none_or(|(from, until)| (from..=until).contains(&at));
    found.segment_handles.retain(|grip| is_shown(grip.to.0) || grip.peak.is_some_and(|(at, _)| is_shown(at)));
    // Where handles would cover each other, a part of the time is to be selected first.
    if found.segment_handles.len() > HANDLES_MOST {
        return html! {};
    }
    let prefix = &state.prefix;
    let moves = moves(project);
    let shown = |value: f64| format_significant(value, 4, l);
    html! {
        @for grip in &found.segment_handles {
            @let law = moves.moves.get(grip.segment).map(|each| law_text(each.law, l)).unwrap_or_default();
            @let number = grip.segment + 1;
            @let title = page::ends_at(&shown(grip.to.0), &shown(grip.to.1), &found.unit.symbol_in(l), l);
            button.grip type="button" role="slider" id={ "grip-" (grip.segment) } data-path={ (prefix) "motion[" (number) "]" }
                data-from-time=(grip.from.0) data-from-way=(grip.from.1) data-time=(grip.to.0) data-way=(grip.to.1) data-goes=(grip.goes)
                aria-label=(capitalised(&page::end_of_segment(&number, &law, l)))
                aria-valuenow=(if grip.goes { grip.to.1 } else { grip.to.0 }) aria-valuetext=(title) aria-describedby="grips-about" title=(title) {}
        }
        @for grip in &found.segment_handles {
            @if let Some((at, speed)) = grip.peak {
                @let law = moves.moves.get(grip.segment).map(|each| law_text(each.law, l)).unwrap_or_default();
                @let number = grip.segment + 1;
                @let title = page::ends_at(&shown(at), &shown(speed), &found.speed_unit.symbol_in(l), l);
                button.grip.peak type="button" role="slider" id={ "peak-" (grip.segment) } data-path={ (prefix) "motion[" (number) "]" }
                    data-panel=(if moves.turns { "n" } else { "v" }) data-from-time=(grip.from.0) data-until=(grip.to.0) data-time=(at) data-way=(speed)
                    aria-label=(capitalised(&views::peak_of_segment(&number, &law, l)))
                    aria-valuenow=(speed) aria-valuetext=(title) aria-describedby="grips-about" title={ (title) ". " (views::peak_about(l)) } {}
            }
        }
        @if !found.segment_handles.is_empty() { span.unseen id="grips-about" { (page::grips_about(l)) } }
    }
}
