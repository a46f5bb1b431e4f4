//! The whole page: head, bars, columns, text, and where one begins.

use crate::call::{Call, Reply, Shell};
use crate::state::{ALL_AXES, Held, State};
use crate::{axes, demand, detail, fits, form, laws, tools, waiting};
use figures::Theme;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use project::Project;
use quantities::Language;
use questions::list::compare::compare;
use questions::list::new::{Template, template, template_kinds};
use questions::list::size::sized;
use questions::list::{export, report, size};
use questions::{Candidate, CandidateId, CheckId, Patience, Refusal, check, check_own, explain, explain_own};
use words::{capitalised, check_title, page, terms};

/// The sign of the page in a browser.
pub const ICON: &str = "data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 16 16'%3E%3Ccircle cx='8' cy='8' r='6' fill='none' stroke='%231d5fa8' stroke-width='3'/%3E%3C/svg%3E";

/// The page with a project, or where one begins.
pub(crate) fn whole(call: &Call<'_>, shell: &dyn Shell, patience: &Patience) -> Markup {
    let mut state = State::of(call);
    if let Some(kind) = call.field("new").filter(|_| state.text.is_empty())
        && let Some(found) = template(&kind, "axis.toml", state.language)
    {
        state.text = found.text;
    }
    let l = state.language;
    let dark = state.theme == Theme::Dark;
    html! {
        (DOCTYPE)
        html lang=(l.id()) data-theme=[dark.then_some("dark")] {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="htmx-config" content=r#"{"includeIndicatorCSS":false,"history":false,"noSwap":[204,304,"4xx","5xx"]}"#;
                title { (page::title(l)) }
                link rel="icon" href=(ICON);
                link rel="stylesheet" href="/assets/page.css";
                script src="/assets/htmx.min.js" defer {}
                script type="module" src="/assets/page.js" {}
                script type="module" src="/assets/folder.js" {}
                script type="module" src="/assets/tools.js" {}
                script type="module" src="/assets/sketch.js" {}
            }
            body hx-target:inherited="#work" hx-swap:inherited="outerMorph" hx-include:inherited="#state, [form=state]" hx-sync:inherited="#work:queue all" {
                (laws::symbols(laws::words()))
                a.skip href="#standing" { (page::skip_to_result(l)) }
                @match work(&mut state, shell, patience) {
                    Ok(page) => { (page) }
                    Err((held, why)) => { (unfinished(&state, &held, shell, &waiting::stopped(&why, false, Some("/work"), shell, patience, l))) }
                }
                (waiting::place(l))
                aside id="detail" aria-live="polite" { @if call.field("tool").is_some() { (tools::pane(call, shell, patience)) } }
                footer { p.small { (page::computed_here(l)) } }
            }
        }
    }
}

/// The answer to a change: all of the page that it may touch. Where the work ended before it was done, the result that is
/// there stays in its place, and it is said beside it.
pub(crate) fn worked(call: &Call<'_>, shell: &dyn Shell, patience: &Patience) -> Reply {
    let mut state = State::of(call);
    let l = state.language;
    let (held, why) = match work(&mut state, shell, patience) {
        Ok(page) => return Reply::of(200, crate::HTML, page.into_string()),
        Err(unfinished) => unfinished,
    };
    let part = |target: &str, inside: Markup| html! { template hx type="partial" hx-target=(target) hx-swap="outerMorph" { (inside) } };
    let parts = html! {
        (part("#state", state_of(&state)))
        (part("#moves", form::column(&state, &held, shell)))
        (part("#text-pane", text(&state)))
        (part("#stopped", demand::stopped(&waiting::stopped(&why, true, Some("/work"), shell, patience, l))))
    };
    let mut reply = Reply::of(200, crate::HTML, parts.into_string());
    reply.headers.push(("hx-reswap", String::from("none")));
    reply
}

/// All of the page that a change of the project may touch.
///
/// # Errors
/// What could be read of the project, where the work ended before it was done or was not begun, and why.
fn work(state: &mut State, shell: &dyn Shell, patience: &Patience) -> Result<Markup, (Box<Held>, Refusal)> {
    if state.text.is_empty() && state.good.is_empty() {
        return Ok(start(state, shell));
    }
    let held = state.hold(shell.files(), patience);
    if let Some(refusal) = held.refused.clone() {
        return Err((Box::new(held), refusal));
    }
    if state.all_axes && held.projects.len() > 1 {
        return match axes::together(state, &held, patience) {
            Ok(summary) => Ok(page_of(state, &held, shell, &html! { main.together { (summary) } })),
            Err(refusal) => Err((Box::new(held), refusal)),
        };
    }
    let project = held.projects.get(state.axis);
    let sizing = match project.map(|project| sized(project, 0, patience)).transpose() {
        Ok(sizing) => sizing,
        Err(refusal) => return Err((Box::new(held), refusal)),
    };
    if let Some(sizing) = &sizing {
        state.choose_nearest(sizing);
    }
    let looked_at = project.and_then(|project| looked_at(state, project, sizing.as_ref()?.candidates.first()));
    let id = looked_at.as_ref().map(|candidate| candidate.id.clone());
    let columns = html! {
        main {
            (form::column(state, &held, shell))
            @match project {
                Some(project) => (demand::column(state, project, looked_at.as_ref(), held.is_old, shell, patience)),
                None => (demand::nothing(state.language, &html! {})),
            }
            (fits::column(state, sizing.as_ref(), id.as_ref(), held.is_old))
        }
    };
    Ok(page_of(state, &held, shell, &columns))
}

fn page_of(state: &State, held: &Held, shell: &dyn Shell, main: &Markup) -> Markup {
    html! {
        div id="work" {
            (bar(state, shell))
            (state_of(state))
            (tabs(state, held))
            (main)
            (text(state))
        }
    }
}

/// The page about a project whose first result could not be waited for.
fn unfinished(state: &State, held: &Held, shell: &dyn Shell, why: &Markup) -> Markup {
    let columns = html! {
        main { (form::column(state, held, shell)) (demand::nothing(state.language, why)) (fits::column(state, None, None, true)) }
    };
    page_of(state, held, shell, &columns)
}

/// The selected actuator: the requested one, else the project's own, else the best, with every check.
pub(crate) fn looked_at<'p>(
    state: &State,
    project: &'p Project,
    best: Option<&Candidate<'_>>,
) -> Option<Candidate<'p>> {
    if let Some(found) = state.code.as_ref().and_then(|code| check(project, code).ok()) {
        return Some(found);
    }
    chosen(project, best)
}

/// The default actuator of a project: its own, else the best.
pub(crate) fn chosen<'p>(project: &'p Project, best: Option<&Candidate<'_>>) -> Option<Candidate<'p>> {
    if let Ok(own) = check_own(project) {
        return Some(own);
    }
    match best.map(|best| &best.id) {
        Some(CandidateId::Code(code)) => check(project, code).ok(),
        _ => None,
    }
}

fn bar(state: &State, shell: &dyn Shell) -> Markup {
    let (has_folder, writes_report) = (shell.folder().is_some(), shell.report().is_some());
    let l = state.language;
    let other = Language::ALL.into_iter().find(|other| *other != l).unwrap_or(l);
    let dark = state.theme == Theme::Dark;
    html! {
        header {
            h1 { "antrieb" }
            nav.bar aria-label=(page::title(l)) {
                a.button href={ "/?lang=" (l.id()) } data-leaves="" { (page::new_project(l)) }
                @if has_folder {
                    button type="button" id="open" hx-get="/files" hx-target="#detail" hx-swap="innerHTML" hx-include="#state [name=lang]" { (page::open(l)) }
                } @else { button type="button" id="open" data-open="" { (page::open(l)) } }
                label.inline { span { (page::save_as(l)) } input id="file" name="file" form="state" type="text" size="18" value=(if state.file.is_empty() { "axis.toml" } else { &state.file }); }
                button type="button" id="save" data-save="" { (page::save(l)) }
                button type="button" id="undo" data-undo="" disabled { (page::undo(l)) }
                button type="button" id="redo" data-redo="" disabled { (page::redo(l)) }
                @if writes_report { button type="button" id="report" data-api=(report::ENTRY.path) data-name="antrieb.pdf" { (page::report_pdf(l)) } }
                button type="button" id="workbook" data-api=(export::ENTRY.path) data-name="antrieb.xlsx" { (page::workbook(l)) }
                button type="button" id="data" data-api=(size::ENTRY.path) data-name="antrieb.json" { (page::data_json(l)) }
                button type="button" id="project" data-project="" { (page::project_file(l)) }
                button type="button" id="link" data-link="" { (page::link_to_this(l)) }
                button type="button" id="tools" hx-post="/tools" hx-target="#detail" hx-swap="innerHTML" { (page::tools(l)) }
                button type="button" id="language" hx-post="/" hx-target="body" hx-swap="outerMorph" hx-vals=(form::vals(&[("lang", other.id())])) lang=(other.id()) { (page::other_language(l)) }
                button type="button" id="theme" aria-pressed=(dark) hx-post="/" hx-target="body" hx-swap="outerMorph"
                    hx-vals=(form::vals(&[("theme", if dark { "light" } else { "dark" })])) { (page::dark(l)) }
            }
            @if !writes_report { p.small { (page::report_elsewhere(l)) } }
            p id="told" role="status" hx-morph-skip="" data-no-answer=(page::no_answer(l)) {}
            div id="disk" role="alert" hx-morph-skip="" {}
        }
    }
}

/// What every request carries.
fn state_of(state: &State) -> Markup {
    let code = state.code.map(|code| code.to_string()).unwrap_or_default();
    html! {
        form id="state" hidden {
            textarea name="good" { (PreEscaped(escaped(&state.good))) }
            input type="hidden" name="axis" value=(if state.all_axes { String::from(ALL_AXES) } else { state.axis.to_string() });
            input type="hidden" name="from" value=[state.window.map(|window| window.0)];
            input type="hidden" name="until" value=[state.window.map(|window| window.1)];
            input type="hidden" name="code" value=(code);
            input type="hidden" name="lang" value=(state.language.id());
            input type="hidden" name="theme" value=(if state.theme == Theme::Dark { "dark" } else { "light" });
            input type="hidden" name="known" value=(state.known);
        }
    }
}

/// A text as the content of a field: its first end of line is one that HTML does not leave out.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 1);
    if text.starts_with('\n') {
        out.push('\n');
    }
    for sign in text.chars() {
        match sign {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            _ => out.push(sign),
        }
    }
    out
}

fn tabs(state: &State, held: &Held) -> Markup {
    let l = state.language;
    html! {
        @if held.projects.len() > 1 {
            nav.tabs aria-label=(capitalised(terms::axis(l))) {
                @for (place, project) in held.projects.iter().enumerate() {
                    button type="button" id={ "axis-" (place) } data-axis=(project.name)
                        aria-current=[(place == state.axis && !state.all_axes).then_some("page")]
                        hx-post="/work" hx-vals=(form::vals(&[("axis", &place.to_string()), ("code", ""), ("from", ""), ("until", "")])) { (project.name) }
                }
                button type="button" id="axis-all" aria-current=[state.all_axes.then_some("page")]
                    hx-post="/work" hx-vals=(form::vals(&[("axis", ALL_AXES), ("code", "")])) { (page::all_axes(l)) }
            }
        }
    }
}

fn text(state: &State) -> Markup {
    let l = state.language;
    html! {
        details id="text-pane" {
            summary { (page::text_of_the_file(l)) }
            label.small for="text" { (page::text_told(l)) }
            textarea id="text" name="text" form="state" rows="24" spellcheck="false" hx-post="/work" hx-trigger="input changed delay:200ms, change" { (PreEscaped(escaped(&state.text))) }
        }
    }
}

/// Where one begins: what is to be moved, an example, a file.
fn start(state: &State, shell: &dyn Shell) -> Markup {
    let l = state.language;
    html! {
        div id="work" {
            (state_of(state))
            header { h1 { "antrieb" } nav.bar aria-label=(page::title(l)) {
                button type="button" id="tools" hx-post="/tools" hx-target="#detail" hx-swap="innerHTML" { (page::tools(l)) }
                @for other in Language::ALL { @if other != l { a.button href={ "/?lang=" (other.id()) } lang=(other.id()) { (page::other_language(l)) } } }
            } p id="told" role="status" hx-morph-skip="" data-no-answer=(page::no_answer(l)) {} }
            main.start {
                section aria-labelledby="start-title" {
                    h2 id="start-title" { (page::what_do_you_move(l)) }
                    p { (page::start_told(l)) }
                    (crate::start::tiles(l))
                }
                section aria-labelledby="example-title" {
                    h2 id="example-title" { (page::or_an_example(l)) }
                    ul.plain { @for kind in template_kinds() {
                        @if let Some(found) = template(kind, "axis.toml", l) { li { (example(kind, &found, l)) } }
                    } }
                }
                section aria-labelledby="file-title" {
                    h2 id="file-title" { (page::or_a_file(l)) }
                    button type="button" data-open="" { (page::open(l)) }
                    (crate::files::in_folder(shell, l))
                }
            }
        }
    }
}

/// An example; one with a recording puts it into the folder, which a link may not.
fn example(kind: &str, found: &Template, language: Language) -> Markup {
    let about = crate::start::about(&found.text, kind);
    let l = language.id();
    html! {
        @if found.recording.is_none() { a href={ "/?new=" (kind) "&lang=" (l) } { (about) } }
        @else { form method="post" action={ "/example?kind=" (kind) "&lang=" (l) } { button.plain type="submit" { (about) } } }
    }
}

/// How a check came about, for the actuator that is looked at.
pub(crate) fn explained(call: &Call<'_>, shell: &dyn Shell, patience: &Patience) -> Markup {
    let mut state = State::of(call);
    let wanted = call.field("check").unwrap_or_default();
    let held = state.hold(shell.files(), patience);
    if let Some(refusal) = &held.refused {
        let why = waiting::stopped(refusal, false, None, shell, patience, state.language);
        return html! { p.advice role="status" { (why) } };
    }
    let Some(project) = held.projects.get(state.axis) else { return html! {} };
    let is_sought = state.code.is_none() && project.actuator.is_none();
    let sizing = if is_sought { sized(project, 0, patience).ok() } else { None };
    let best = sizing.as_ref().and_then(|sizing| sizing.candidates.first()).map(|best| best.id.clone());
    let found = match (state.code, best) {
        (Some(code), _) | (None, Some(CandidateId::Code(code))) => explain(project, &code),
        _ => explain_own(project),
    };
    let Ok(candidate) = found else { return html! {} };
    let Some(one) = candidate.judgement.checks.iter().find(|each| each.id.id() == wanted) else {
        let known = CheckId::ALL.iter().find(|id| id.id() == wanted);
        return html! { @if let Some(id) = known { p { (check_title(*id, state.language)) } } };
    };
    detail::explained(&candidate, one, state.language)
}

/// The marked actuators side by side.
pub(crate) fn compared(call: &Call<'_>, shell: &dyn Shell, patience: &Patience) -> Markup {
    let mut state = State::of(call);
    let held = state.hold(shell.files(), patience);
    let found = held.projects.get(state.axis).and_then(|project| compare(project, &state.marked, patience).ok());
    html! { @if let Some(found) = found { (detail::compared(&found, state.language)) } }
}
