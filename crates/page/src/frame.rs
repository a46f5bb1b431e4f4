//! The whole page: head, verdict, three panes, and the start page.

use crate::call::{Call, Reply, Shell};
use crate::head::{self, USUAL_NAME};
use crate::parts::ShownParts;
use crate::shown::{Outcome, looked_at, looked_at_alone};
use crate::state::{ALL_AXES, List, PageState, ReadProject};
use crate::verdict;
use crate::{axes, demand, detail, fits, form, laws, tools, waiting};
use figures::{CurveName, CurveValues, Drawing, Theme};
use maud::{DOCTYPE, Markup, html};
use quantities::Language;
use questions::list::compare::compare;
use questions::list::new::{self, Template, template_kinds};
use questions::list::size::sized;
use questions::{Candidate, CheckId, ProductId, Progress, Refusal, Rejected, Sizing, explain, explain_own};
use std::sync::LazyLock;
use words::{check_title, page};

/// Icon of the page: the sign as an address.
static ICON: LazyLock<String> = LazyLock::new(|| {
    let kept =
        crate::markup::LOGO.trim_end().replace('#', "%23").replace('<', "%3C").replace('>', "%3E").replace('"', "'");
    format!("data:image/svg+xml,{kept}")
});

/// Returns the head of a page: settings that apply to all following elements, title, icon, style sheet and scripts.
#[must_use]
pub fn head(first: &Markup, title: &str, style: &str, scripts: &Markup) -> Markup {
    html! {
        head {
            meta charset="utf-8";
            meta name="viewport" content="width=device-width, initial-scale=1";
            (first)
            title { (title) }
            link rel="icon" href=(*ICON);
            link rel="stylesheet" href=(style);
            (scripts)
        }
    }
}

/// Returns the scripts of the workbench with their settings.
fn scripts() -> Markup {
    html! {
        meta name="htmx-config" content=r#"{"includeIndicatorCSS":false,"history":false,"noSwap":[204,304,"4xx","5xx"]}"#;
        // First: it adds the token to the requests of the others.
        script src="/assets/enter.js" {}
        script src="/assets/htmx.min.js" defer {}
        @for name in ["page.js", "panes.js", "folder.js", "tools.js", "door.js", "begin.js", "sketch.js", "theory.js", "print.js", "across.js", "table.js", "runs.js"] { script type="module" src={ "/assets/" (name) } {} }
    }
}

/// Returns the page with a project, or the start page.
pub(crate) fn whole(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Markup {
    let mut state = PageState::of(call);
    if let Some(kind) = call.field("new").filter(|_| state.text.is_empty())
        && let Some(found) = new::example(&kind, USUAL_NAME, state.language)
    {
        state.take(found.text, call);
    }
    let l = state.language;
    let dark = state.theme == Theme::Dark;
    html! {
        (DOCTYPE)
        html lang=(l.id()) data-theme=[dark.then_some("dark")] {
            (head(&html! {}, page::title(l), "/assets/page.css", &scripts()))
            body hx-target:inherited="#work" hx-swap:inherited="outerMorph" hx-include:inherited="#state, [form=state]" hx-sync:inherited="#work:queue all" {
                (laws::symbols(laws::words()))
                template id="units" { (crate::value::lists()) }
                a.skip href="#standing" { (page::skip_to_result(l)) }
                @match work(&mut state, shell, progress) {
                    Ok(page) => { (page) }
                    Err((held, why)) => { (unfinished(&state, &held, shell, &waiting::stopped(&why, false, Some("/work"), shell, progress, l), progress)) }
                }
                (waiting::place(l))
                aside id="detail" aria-live="polite" { (drawer_of(call, &mut state, shell, progress)) }
                dialog id="palette" aria-label=(page::find(l)) {}
            }
        }
    }
}

/// Returns what a link opens in the drawer: a tool, the derivation of a check, the comparison of the marked actuators.
fn drawer_of(call: &Call<'_>, state: &mut PageState, shell: &dyn Shell, progress: &Progress) -> Markup {
    html! {
        @if crate::IS_WHOLE && call.field("tool").is_some() { (tools::pane(call, shell, progress)) }
        @else if let Some(check) = call.field("check").filter(|_| crate::IS_WHOLE) { (derivation_of(&check, state, shell, progress)) }
        @else if crate::IS_WHOLE && state.marked.len() > 1 { (comparison(state, shell, progress)) }
    }
}

/// Answers a change with all parts of the page that it may affect. If the work was stopped, the last result stays on
/// the page with a message.
pub(crate) fn worked(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Reply {
    let mut state = PageState::of(call);
    if let Some(further) = crate::start::further_text(call) {
        state.add_axis(&further);
    }
    let l = state.language;
    let (held, why) = match work(&mut state, shell, progress) {
        Ok(page) => return Reply::of(200, crate::HTML, ShownParts::of(call).left_out(&page.into_string())),
        Err(unfinished) => unfinished,
    };
    let parts = html! {
        (partial("#state", state_of(&state)))
        (partial("#moves", form::column(&state, &held, None, shell)))
        (partial("#stopped", crate::markup::stopped(&waiting::stopped(&why, true, Some("/work"), shell, progress, l))))
    };
    Reply::of(200, crate::HTML, parts.into_string()).with("hx-reswap", "none")
}

/// Returns all parts of the page that a change of the project may affect.
///
/// # Errors
/// The part of the project that could be read, and the reason, if the work was stopped or not begun.
fn work(state: &mut PageState, shell: &dyn Shell, progress: &Progress) -> Result<Markup, (Box<ReadProject>, Refusal)> {
    if state.text.is_empty() && state.good.is_empty() {
        return Ok(start(state, shell));
    }
    let held = state.hold(shell, progress);
    if let Some(refusal) = held.refused.clone() {
        return Err((Box::new(held), refusal));
    }
    if state.all_axes && held.projects.len() > 1 {
        return match axes::summary(state, &held, progress) {
            Ok(summary) => Ok(page_of(state, &held, shell, (&html! {}, false), &html! { main.together { (summary) } })),
            Err(refusal) => Err((Box::new(held), refusal)),
        };
    }
    let project = held.projects.get(state.axis);
    // The best actuator is judged with every check together with the catalogue, because it is viewed most often. The
    // reasons of the others are computed when they are shown.
    let rejected = if state.list == List::Ranking { Rejected::Nearest } else { Rejected::All };
    let sizing = match project.map(|project| sized(project, 1, rejected, progress)).transpose() {
        Ok(sizing) => sizing,
        Err(refusal) => return Err((Box::new(held), refusal)),
    };
    if let Some(sizing) = &sizing {
        state.choose_nearest(sizing);
    }
    let goes_on = || if progress.is_over() { Err(Refusal::Stopped) } else { Ok(()) };
    if let Err(refusal) = goes_on() {
        return Err((Box::new(held), refusal));
    }
    let looked_at = project.and_then(|project| looked_at(state, project, sizing.as_ref()?.named()));
    let found = Outcome { project, sizing: sizing.as_ref(), candidate: looked_at.as_ref() };
    let moves = form::column(state, &held, looked_at.as_ref(), shell);
    let bar = verdict::bar(state, &held, &found, &moves.0, progress);
    if let Err(refusal) = goes_on() {
        return Err((Box::new(held), refusal));
    }
    let demands = match project {
        Some(project) => demand::column(state, project, looked_at.as_ref(), held.is_old, shell, progress),
        None => demand::nothing(state, &held),
    };
    if let Err(refusal) = goes_on() {
        return Err((Box::new(held), refusal));
    }
    let panes = panes(&moves, &demands, &fits::column(state, &held, &found, &moves.0, shell), state.language);
    let is_done = !held.is_old && looked_at.as_ref().is_some_and(Candidate::fits);
    Ok(page_of(state, &held, shell, (&bar, is_done), &panes))
}

/// Returns the three panes with the dividers between them.
fn panes(moves: &Markup, demands: &Markup, fits: &Markup, language: Language) -> Markup {
    let l = language;
    let border = |id: &str, of: &str, label: &str| {
        html! { div.border id=(id) role="separator" tabindex="0" aria-orientation="vertical" aria-label=(label) aria-controls=(of) aria-valuemin="0" aria-valuemax="100" aria-valuenow="25" hx-morph-skip="" {} }
    };
    html! {
        nav.pane-tabs aria-label=(page::panes(l)) {
            @for (place, title) in [page::what_moves(l), page::what_it_demands(l), page::what_fits(l)].into_iter().enumerate() {
                button type="button" data-pane=(place + 1) { (title) }
            }
        }
        main id="panes" {
            (moves)
            (border("border-1", "moves", page::border_left(l)))
            (demands)
            (border("border-2", "fits", page::border_right(l)))
            (fits)
        }
    }
}

/// Returns the page of a project. With a result that fits (`is_done`) its main action is the export.
fn page_of(
    state: &PageState,
    held: &ReadProject,
    shell: &dyn Shell,
    (bar, is_done): (&Markup, bool),
    main: &Markup,
) -> Markup {
    html! {
        div id="work" {
            (head::of_project(state, held, is_done, shell))
            (head::messages(state.language))
            (state_of(state))
            (bar)
            (main)
        }
    }
}

/// Returns the page about a project whose first result took too long.
fn unfinished(state: &PageState, held: &ReadProject, shell: &dyn Shell, why: &Markup, progress: &Progress) -> Markup {
    let none = Outcome { project: None, sizing: None, candidate: None };
    let moves = form::column(state, held, None, shell);
    let bar = verdict::bar(state, held, &none, &moves.0, progress);
    let panes = panes(
        &moves,
        &demand::nothing(state, held),
        &fits::column(state, held, &none, &moves.0, shell),
        state.language,
    );
    page_of(state, held, shell, (&html! { (bar) (crate::markup::stopped(why)) }, false), &panes)
}

/// Returns the form with the state that every request carries.
fn state_of(state: &PageState) -> Markup {
    let code = state.code.as_ref().map(ToString::to_string).unwrap_or_default();
    html! {
        form id="state" hidden {
            textarea name="good" { (crate::markup::kept(&state.good)) }
            input type="hidden" name="axis" value=(if state.all_axes { String::from(ALL_AXES) } else { state.axis.to_string() });
            input type="hidden" name="from" value=[state.window.map(|window| window.0)];
            input type="hidden" name="until" value=[state.window.map(|window| window.1)];
            input type="hidden" name="code" value=(code);
            input type="hidden" name="lang" value=(state.language.id());
            input type="hidden" name="theme" value=(if state.theme == Theme::Dark { "dark" } else { "light" });
            input type="hidden" name="known" value=(state.known);
            input type="hidden" name="view" value=(state.view.id());
            input type="hidden" name="list" value=(state.list.id());
            input type="hidden" name="sort" value=(state.sort.id());
            input type="hidden" name="unfolded" value=(state.unfolded);
            input type="hidden" name="width" value=(state.room.0);
            input type="hidden" name="height" value=(state.room.1);
        }
    }
}

/// Returns the start page: what is to be moved, an example, a file.
fn start(state: &PageState, shell: &dyn Shell) -> Markup {
    let l = state.language;
    html! {
        div id="work" {
            (head::of_start(state))
            (head::messages(l))
            (state_of(state))
            main.start {
                p.what-this-is { (page::what_this_is(l)) }
                section id="unsaved" aria-labelledby="unsaved-title" hidden {
                    h2 id="unsaved-title" { (page::continue_unsaved(l)) }
                    ul.plain {}
                    details hidden { summary {} ul.plain {} }
                }
                section aria-labelledby="start-title" {
                    h2 id="start-title" { (page::what_do_you_move(l)) }
                    p { (page::start_about(l)) }
                    div.begin {
                        (crate::start::tiles(l))
                        div id="begin" aria-live="polite" { (crate::start::asked(state.begin, false, l)) }
                    }
                }
                section aria-labelledby="example-title" {
                    h2 id="example-title" { (page::or_an_example(l)) }
                    ul.cards { @for (kind, found) in examples(l) { li { (example(kind, &found, l)) } } }
                }
                section aria-labelledby="file-title" {
                    h2 id="file-title" { (page::or_a_file(l)) }
                    button type="button" data-open="" { (page::open(l)) }
                    (crate::files::in_folder(shell, l))
                }
                p.small { (page::computed_here(l)) }
            }
        }
    }
}

/// Returns the examples without repetition: several names may lead to one example.
fn examples(language: Language) -> Vec<(&'static str, Template)> {
    let mut found: Vec<(&'static str, Template)> = Vec::new();
    for kind in template_kinds() {
        let Some(one) = new::example(kind, USUAL_NAME, language) else { continue };
        if found.iter().all(|(_, known)| known.text != one.text) {
            found.push((kind, one));
        }
    }
    found
}

/// Returns the card of an example; an example with a recording writes it into the folder, for which a link is not
/// allowed.
fn example(kind: &str, found: &Template, language: Language) -> Markup {
    let about = crate::start::about(&found.text, kind);
    let l = language.id();
    let drawing = crate::sketch::still(crate::start::mechanism_of(&found.text).as_deref());
    let inside = html! { span.sketch aria-hidden="true" { (drawing) } span { (about) @if found.recording.is_none() { span.small.two-lines hx-get={ "/example?kind=" (kind) "&lang=" (l) } hx-trigger="load" hx-target="this" hx-swap="innerHTML" hx-include="unset" hx-sync="this" hx-morph-skip-children="" {} } } };
    html! {
        @if found.recording.is_none() { a.card href={ "/?new=" (kind) "&lang=" (l) } { (inside) } }
        @else { form method="post" action={ "/example?kind=" (kind) "&lang=" (l) } { button.card type="submit" { (inside) } } }
    }
}

/// Returns the picture of a long recording, requested after its numbers, and the reserve of the actuator.
pub(crate) fn picture(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Reply {
    let mut state = PageState::of(call);
    let held = state.hold(shell, progress);
    let Some(project) = held.projects.get(state.axis) else { return Reply::text(204, "") };
    let Some(candidate) = looked_at_alone(&state, project, progress) else { return Reply::text(204, "") };
    let parts = html! {
        (demand::view(&state, project, &candidate, held.is_old, shell, progress))
        (partial("#reserve", demand::reserve(project, &candidate, progress, state.language)))
    };
    Reply::of(200, crate::HTML, parts.into_string())
}

/// Returns a part of an answer with its target in the page.
fn partial(target: &str, inside: Markup) -> Markup {
    html! { template hx type="partial" hx-target=(target) hx-swap="outerMorph" { (inside) } }
}

/// Returns the curves of the picture as a table.
pub(crate) fn curves(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Reply {
    match shown_drawing(call, shell, progress) {
        Ok(drawing) => Reply::text(200, &drawing.curves(call.language())),
        Err(why) => Reply::text(404, &why),
    }
}

/// Returns the values of the curves of the picture for its cursor: groups of curves with the same places.
pub(crate) fn values(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Reply {
    let drawing = match shown_drawing(call, shell, progress) {
        Ok(drawing) => drawing,
        Err(why) => return Reply::text(404, &why),
    };
    let name = |name: &CurveName| serde_json::json!([name.symbol, name.unit, name.label]);
    let group = |group: &CurveValues| {
        let names: Vec<_> = group.names.iter().map(name).collect();
        serde_json::json!({ "names": names, "x": group.places, "y": group.values, "reduced": group.is_reduced })
    };
    let groups: Vec<_> = drawing.values().iter().map(group).collect();
    let found = serde_json::json!({ "place": drawing.place_name().as_ref().map(name), "groups": groups });
    Reply::of(200, "application/json", found.to_string())
}

/// Draws the picture in the middle pane.
///
/// # Errors
/// The reason in one sentence, if there is none.
fn shown_drawing(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Result<Drawing, String> {
    let mut state = PageState::of(call);
    let held = state.hold(shell, progress);
    let none = || page::no_result_yet(state.language).to_owned();
    let project = held.projects.get(state.axis).ok_or_else(none)?;
    let candidate = looked_at_alone(&state, project, progress).ok_or_else(none)?;
    demand::drawing(&state, project, &candidate, progress).map_err(|why| why.message(None, state.language))
}

/// Returns the derivation of a check for the selected actuator.
pub(crate) fn explained(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Markup {
    derivation_of(&call.field("check").unwrap_or_default(), &mut PageState::of(call), shell, progress)
}

fn derivation_of(wanted: &str, state: &mut PageState, shell: &dyn Shell, progress: &Progress) -> Markup {
    let held = state.hold(shell, progress);
    if let Some(refusal) = &held.refused {
        let why = waiting::stopped(refusal, false, None, shell, progress, state.language);
        return html! { p.advice role="status" { (why) } };
    }
    let Some(project) = held.projects.get(state.axis) else { return html! {} };
    let is_sought = state.code.is_none() && project.actuator.is_none();
    let sizing = if is_sought { sized(project, 0, Rejected::Nearest, progress).ok() } else { None };
    let best = sizing.as_ref().and_then(Sizing::named).map(|best| best.id.clone());
    let found = match state.code.as_ref().or(best.as_ref()) {
        Some(id) => explain(project, id),
        None => explain_own(project),
    };
    let Ok(candidate) = found else { return html! {} };
    let Some(one) = candidate.judgement.checks.iter().find(|each| each.id.id() == wanted) else {
        let known = CheckId::ALL.iter().find(|id| id.id() == wanted);
        return html! { @if let Some(id) = known { p { (check_title(*id, state.language)) } } };
    };
    detail::explained(&candidate, one, state.language)
}

/// Returns the comparison of the marked actuators.
pub(crate) fn compared(call: &Call<'_>, shell: &dyn Shell, progress: &Progress) -> Markup {
    comparison(&mut PageState::of(call), shell, progress)
}

fn comparison(state: &mut PageState, shell: &dyn Shell, progress: &Progress) -> Markup {
    let held = state.hold(shell, progress);
    // A mark may be left of a catalogue file that the project does not name any more.
    let found = held.projects.get(state.axis).and_then(|project| {
        let is_known = |id: &&ProductId| {
            project.catalogue().product(id).is_some() || project.actuator.as_ref().is_some_and(|own| own.id == **id)
        };
        let marked: Vec<ProductId> = state.marked.iter().filter(is_known).cloned().collect();
        compare(project, &marked, progress).ok()
    });
    html! { @if let Some(found) = found { (detail::compared(&found, state.language)) } }
}
