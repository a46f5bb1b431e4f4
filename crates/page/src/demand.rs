//! The middle column: what the axis demands of the actuator that is looked at, over time and in the plane.

use crate::call::Shell;
use crate::form::vals;
use crate::state::State;
use crate::{overlay, tolerances};
use figures::{Figure, Size, Style, draw_within};
use maud::{Markup, PreEscaped, html};
use project::Project;
use quantities::{Language, Measure, format_significant};
use questions::list::check::reserve_unasked;
use questions::texts::{
    by_importance, counts_text, demand_figures, figure_text, margin_share, margin_text, objection_text, reserve_lines,
    standing_text, unit_text, verdict_text,
};
use questions::{Candidate, Check, Patience, Verdict};
use words::{
    assumption_text, capitalised, check_missing, check_title, grade_word, note_text, page, source_text, terminal, terms,
};

/// Width of the pictures in the page, in pixels.
const WIDTH: f64 = 640.0;

/// The column, of a candidate judged with every check.
pub(crate) fn column(
    state: &State,
    project: &Project,
    candidate: Option<&Candidate<'_>>,
    is_old: bool,
    shell: &dyn Shell,
    patience: &Patience,
) -> Markup {
    let l = state.language;
    html! {
        section id="demands" class=[is_old.then_some("old")] aria-labelledby="demands-title" {
            h2 id="demands-title" { (page::what_it_demands(l)) }
            (stopped(&html! {}))
            @if is_old { p.advice role="status" { (page::result_is_old(l)) } }
            @if let Some(candidate) = candidate {
                (head(candidate, l))
                @let none = html! {};
                @let worst = overlay::worst(candidate);
                @let held = if is_old { html! {} } else { overlay::grips(state, project) };
                (sums(project, candidate, patience, l))
                (tolerances::place(state, project, candidate, shell))
                (overlay::controls(project, state.window.is_some(), l))
                (picture((state, patience), project, candidate, Figure::Cycle, &overlay::marks(&worst, "", l), &held))
                (picture((state, patience), project, candidate, Figure::TorqueSpeed, &none, &none))
                (checks(candidate, &worst, l))
                (picture((state, patience), project, candidate, Figure::BearingLoad, &overlay::marks(&worst, "b", l), &none))
                (picture((state, patience), project, candidate, Figure::Torsion, &none, &none))
                (assumptions(project, l))
            }
        }
    }
}

pub(crate) fn verdict_class(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Pass => "pass",
        Verdict::Fail => "fail",
        Verdict::Advice => "advice",
        Verdict::NotChecked => "unchecked",
    }
}

fn head(candidate: &Candidate<'_>, language: Language) -> Markup {
    let class = match (candidate.fits(), candidate.open_questions()) {
        (false, _) => "fail",
        (true, _) if candidate.leaves_load_unheld() => "fail",
        (true, 0) => "pass",
        (true, _) => "unchecked",
    };
    html! {
        p id="standing" role="status" aria-live="polite" class={ "standing " (class) } {
            strong { (candidate.id) } ": " (standing_text(candidate, language))
        }
        p.counts { (counts_text(candidate, language)) }
        @let keys = candidate.keys_to_state();
        @if !keys.is_empty() {
            p.counts { (capitalised(terminal::to_state(language))) ": " @for (place, (key, _)) in keys.iter().enumerate() { @if place > 0 { ", " } code { (key) } } }
        }
        @for objection in &candidate.objections { p.fail { (objection_text(candidate, objection, language)) } }
    }
}

fn sums(project: &Project, candidate: &Candidate<'_>, patience: &Patience, language: Language) -> Markup {
    // Only if that is quick: the page answers while the user types.
    let reserve = reserve_unasked(project, candidate, patience).unwrap_or_default();
    html! {
        section aria-label=(page::sums(language)) {
            @if let Some(demand) = &candidate.judgement.demand {
                dl.sums {
                    @for (symbol, value, unit) in demand_figures(demand, language) {
                        div { dt { (crate::tip::of_symbol(symbol, language)) } dd { (value) " " (unit) } }
                    }
                }
            }
            @for (head, parts) in reserve_lines(&reserve, candidate, language) {
                p { (capitalised(head)) ": " @for (place, part) in parts.iter().enumerate() { @if place > 0 { "; " } (part) } }
            }
        }
    }
}

/// What is said where the last work ended before it was done; nothing else stands there.
pub(crate) fn stopped(what: &Markup) -> Markup {
    html! { p.advice id="stopped" role="status" { (what) } }
}

/// The column without a result.
pub(crate) fn nothing(language: Language, why: &Markup) -> Markup {
    html! {
        section id="demands" aria-labelledby="demands-title" {
            h2 id="demands-title" { (page::what_it_demands(language)) }
            (stopped(why))
            p { (page::no_result_yet(language)) }
        }
    }
}

/// A picture, drawn for the page, with what stands above it and what lies over it; nothing where there is nothing to draw.
fn picture(
    (state, patience): (&State, &Patience),
    project: &Project,
    candidate: &Candidate<'_>,
    figure: Figure,
    above: &Markup,
    over: &Markup,
) -> Markup {
    let Ok(drawing) = draw_within(figure, project, candidate, state.window, patience, state.language) else {
        return html! {};
    };
    let (width, height) = drawing.size_mm;
    let size = Size::pixels(WIDTH, WIDTH * height / width);
    let name = figure.id().replace('_', "-");
    let style = Style::new(size).theme(state.theme).language(state.language).id(&name);
    html! {
        figure.plot id={ "plot-" (name) } data-figure=(figure.id()) {
            (above)
            div.frame { (PreEscaped(drawing.render(&style).into_svg())) (over) }
            figcaption { (drawing.caption) }
        }
    }
}

/// The heads of a table of checks.
pub(crate) fn check_heads(language: Language) -> [&'static str; 6] {
    let l = language;
    [terms::check(l), terms::verdict(l), terms::value(l), terms::limit(l), terms::unit(l), terms::utilisation_short(l)]
}

fn checks(candidate: &Candidate<'_>, worst: &[overlay::Worst<'_>], language: Language) -> Markup {
    let l = language;
    html! {
        section aria-labelledby="checks-title" {
            h3 id="checks-title" { (page::checks_of(&candidate.id, l)) }
            div.wide tabindex="0" role="region" aria-labelledby="checks-title" {
                table.checks {
                    thead { tr { @for head in check_heads(l) { th scope="col" { (crate::tip::of_word(head, l)) } } } }
                    tbody { @for check in by_importance(&candidate.judgement.checks) { (row(check, worst, l)) } }
                }
            }
        }
    }
}

fn row(check: &Check, worst: &[overlay::Worst<'_>], language: Language) -> Markup {
    let l = language;
    let missing = check.missing.map(|symbol| check_missing(symbol, l));
    let share = margin_share(check).map(|share| (share * 100.0).clamp(0.0, 150.0));
    html! {
        tr id={ "check-" (check.id.id()) } class=(verdict_class(check.verdict)) {
            th scope="row" {
                button.plain type="button" title=(page::how_it_came_about(l)) hx-post="/explain" hx-target="#detail" hx-swap="innerHTML"
                    hx-vals=(vals(&[("check", check.id.id())])) { (capitalised(&check_title(check.id, l))) }
            }
            td { span.verdict { (verdict_text(check, l)) } }
            td.number { (figure_text(check.value, l)) }
            td.number { (figure_text(check.limit, l)) }
            td { (unit_text(check.value)) }
            td.number {
                (margin_text(check, l))
                @if let Some(share) = share { svg.bar viewBox="0 0 150 8" aria-hidden="true" { rect x="0" y="0" width=(share) height="8" {} path d="M100 0V8" {} } }
                @if let Some(at) = check.at {
                    " " button.small type="button" data-instant=(at.si()) title=(page::jump_to_worst(l)) {
                        @if let Some(number) = overlay::number(worst, check) { span.mark-number { (number) } " " }
                        (page::worst_instant(&format_significant(at.si(), 3, l), l))
                    }
                }
            }
        }
        @if check.verdict == Verdict::NotChecked || check.verdict == Verdict::Advice {
            tr.told class=(verdict_class(check.verdict)) { td colspan="6" {
                @if let Some(missing) = missing { (page::to_be_checked_state(l)) " " (missing) " " }
                @for note in check.notes.iter() { (note_text(note, l)) " " }
                @if let (Some(source), Some(grade)) = (&check.limit_source, check.grade) { (grade_word(grade, l)) ", " (source_text(source, l)) }
            } }
        }
    }
}

fn assumptions(project: &Project, language: Language) -> Markup {
    html! {
        @if !project.assumptions.is_empty() {
            details id="assumptions" open {
                summary { (capitalised(terms::assumptions(language))) }
                ul { @for assumption in &project.assumptions { li { (assumption_text(*assumption, language)) } } }
            }
        }
    }
}

/// What the terminal calls the two sides of a check.
pub(crate) fn sides(language: Language) -> [&'static str; 2] {
    [terminal::asked(language), terminal::permitted(language)]
}
