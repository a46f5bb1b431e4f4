//! The row at the top: the axes, the file, and the menus.

use crate::call::Shell;
use crate::markup::vals;
use crate::state::{ALL_AXES, PageState, ReadProject};
use figures::Theme;
use maud::{Markup, html};
use quantities::Language;
use questions::list::{Argument, ArgumentKind, export, report, size};
use words::{capitalised, incoming, page, terms};

/// Default name of a project file.
pub(crate) const USUAL_NAME: &str = "axis.toml";

/// Returns the row of a project. With a result that fits (`is_done`) the export is the main action.
pub(crate) fn of_project(state: &PageState, held: &ReadProject, is_done: bool, shell: &dyn Shell) -> Markup {
    let l = state.language;
    let file = if state.file.is_empty() { USUAL_NAME } else { &state.file };
    html! {
        header id="head" {
            (brand(l))
            (axes(state, held))
            span.file {
                span id="file-name" title=(page::save_as(l)) { (file) }
                " " span id="file-state" data-changed=(page::changed(l)) data-saved=(page::saved_state(l)) {}
            }
            nav.bar aria-label=(page::title(l)) {
                button.icon type="button" id="undo" data-undo="" aria-disabled="true" aria-label=(page::undo(l)) title={ (page::undo(l)) " (Ctrl+Z)" } { "↶" }
                button.icon type="button" id="redo" data-redo="" aria-disabled="true" aria-label=(page::redo(l)) title={ (page::redo(l)) " (Ctrl+Y)" } { "↷" }
                (menu("menu-file", (page::file(l), "M3 1.5h6.5l3.5 3.5v9.5h-10zM9.5 1.5v3.5h3.5"), false, &file_items(file, shell, l)))
                (menu("menu-export", (page::export(l), "M8 1.5v8.5M4.7 6.7 8 10l3.3-3.3M2 11.5v3h12v-3"), is_done, &export_items(shell, l)))
                (tools(l))
                button.icon type="button" id="find" data-find="" aria-label=(page::find(l)) title={ (page::find(l)) " (/)" } { "⌕" }
                (language(state))
                (theme(state))
                button.icon type="button" id="keys" data-keys="" aria-label=(page::keyboard(l)) title={ (page::keyboard(l)) " (?)" } { "?" }
            }
        }
    }
}

/// Returns the row of the start page.
pub(crate) fn of_start(state: &PageState) -> Markup {
    html! {
        header id="head" {
            (brand(state.language))
            span.file {}
            nav.bar aria-label=(page::title(state.language)) {
                (tools(state.language))
                @for other in Language::ALL { @if other != state.language {
                    a.button href={ "/?lang=" (other.id()) } lang=(other.id()) { (named(page::other_language(state.language), &html! { (other.id().to_uppercase()) })) }
                } }
                (theme(state))
            }
        }
    }
}

/// Returns the places of messages: about the last action, and about the file in the folder.
pub(crate) fn messages(language: Language) -> Markup {
    html! {
        p id="status" role="status" hx-morph-skip="" {}
        div id="disk" role="alert" hx-morph-skip="" {}
        div id="draft" role="alert" hx-morph-skip="" {}
        // Apart from the places that keep their content, so that another language reaches them.
        span id="messages" hidden data-no-answer=(page::no_answer(language)) data-answers=(page::answers_again(language))
            data-draft=(page::draft_found(language)) data-restore=(page::restore_draft(language)) data-discard=(page::discard_draft(language))
            data-restored=(page::draft_restored(language)) data-full=(page::draft_too_large(language))
            data-most=(crate::RECORDING_BYTES_MAX) data-too-large=(incoming::too_large(&(crate::RECORDING_BYTES_MAX >> 20), language))
            data-one-file=(incoming::one_file(language)) {}
        div id="drop" aria-hidden="true" { (incoming::drop_here(language)) }
    }
}

fn brand(language: Language) -> Markup {
    html! { h1 { a.brand href={ "/?lang=" (language.id()) } data-leaves="" title=(page::new_project(language)) { (crate::markup::logo()) span.name { "antrieb" } } } }
}

fn tools(language: Language) -> Markup {
    html! { button type="button" id="tools" hx-post="/tools" hx-target="#detail" hx-swap="innerHTML" { (named(page::tools(language), &icon("M10.5 1.6a4 4 0 0 0-4.6 5.3L1.6 11.2a1.6 1.6 0 0 0 0 2.2l1 1a1.6 1.6 0 0 0 2.2 0l4.3-4.3a4 4 0 0 0 5.3-4.6L12 7.9 9.6 7.6 8.1 6.4 8.1 4z"))) } }
}

fn language(state: &PageState) -> Markup {
    let other = Language::ALL.into_iter().find(|other| *other != state.language).unwrap_or(state.language);
    html! {
        button type="button" id="language" hx-post="/" hx-target="body" hx-swap="outerMorph" hx-vals=(vals(&[("lang", other.id())]))
            lang=(other.id()) { (named(page::other_language(state.language), &html! { (other.id().to_uppercase()) })) }
    }
}

fn theme(state: &PageState) -> Markup {
    let dark = state.theme == Theme::Dark;
    html! {
        button.icon type="button" id="theme" aria-pressed=(dark) aria-label=(page::dark(state.language)) title=(page::dark(state.language))
            hx-post="/" hx-target="body" hx-swap="outerMorph" hx-vals=(vals(&[("theme", if dark { "light" } else { "dark" })])) { "◐" }
    }
}

/// Returns a title that a narrow window shows as a sign; readers of screens have the title in both.
fn named(title: &str, sign: &Markup) -> Markup {
    html! { span.title { (title) } span.sign aria-hidden="true" { (sign) } }
}

fn icon(path: &str) -> Markup {
    html! { svg.icon viewBox="0 0 16 16" width="16" height="16" { path d=(path) {} } }
}

fn menu(id: &str, (title, sign): (&str, &str), is_main: bool, items: &Markup) -> Markup {
    html! { details.menu id=(id) { summary class=[is_main.then_some("primary")] { (named(title, &icon(sign))) } div.items { (items) } } }
}

fn file_items(file: &str, shell: &dyn Shell, language: Language) -> Markup {
    let l = language;
    html! {
        a.button href={ "/?lang=" (l.id()) } data-leaves="" { (page::new_project(l)) }
        @if shell.folder().is_some() {
            button type="button" id="open" hx-get="/files" hx-target="#detail" hx-swap="innerHTML" hx-include="#state [name=lang]" { (page::open(l)) }
        } @else { button type="button" id="open" data-open="" { (page::open(l)) } }
        label.field for="file" { span { (page::save_as(l)) } input id="file" name="file" form="state" type="text" size="18" value=(file) autocomplete="off" spellcheck="false" hx-morph-skip=""; }
        button type="button" id="save" data-save="" { (page::save(l)) span.key { "Ctrl+S" } }
        button type="button" id="print" data-print="" { (page::print(l)) span.key { "Ctrl+P" } }
        button type="button" id="project" data-project="" { (page::project_file(l)) }
        button type="button" id="link" data-link="" { (page::link_to_this(l)) }
        button type="button" id="versions" data-versions="" { (page::versions(l)) }
    }
}

fn export_items(shell: &dyn Shell, language: Language) -> Markup {
    let l = language;
    html! {
        @if shell.report().is_some() {
            button type="button" id="report" data-api=(report::ENTRY.path) data-ending="pdf" { (page::report_pdf(l)) }
            (title_page(l))
        } @else { p.small { (crate::sentences::quoted(page::report_elsewhere(l), l)) } }
        button type="button" id="workbook" data-api=(export::ENTRY.path) data-ending="xlsx" { (page::workbook(l)) }
        button type="button" id="data" data-api=(size::ENTRY.path) data-ending="json" { (page::data_json(l)) }
        button type="button" id="picture" data-picture="" { (page::picture_shown(l)) }
    }
}

/// Returns the fields of the title page of the report and its extent: the arguments of the report that the page does not give itself.
fn title_page(language: Language) -> Markup {
    let l = language;
    // The page knows axis and actuator, and sends the day.
    let fields = report::Args::ARGUMENTS.iter().filter(|field| !["axis", "code", "date"].contains(&field.name));
    html! {
        details id="report-fields" hx-morph-skip="" {
            summary { (page::title_page(l)) }
            @for field in fields {
                @let id = format!("report-{}", field.name);
                @if matches!(field.kind, ArgumentKind::Flag) {
                    label.check for=(id) { input id=(id) type="checkbox" data-report=(field.name); " " (label(field, l)) }
                } @else if field.repeated {
                    label.field for=(id) { span { (label(field, l)) } textarea id=(id) data-report=(field.name) rows="2" spellcheck="false" {} }
                } @else {
                    label.field for=(id) { span { (label(field, l)) } input id=(id) data-report=(field.name) type="text" autocomplete="off" spellcheck="false"; }
                }
            }
        }
    }
}

/// Returns the label of an argument of the report; without the options that its help on the command line names.
fn label(field: &Argument, language: Language) -> &'static str {
    match field.name {
        "change" => page::change_lines(language),
        "full" => page::with_derivations(language),
        "installation" => page::with_installation(language),
        "archive" => page::as_archive(language),
        _ => (field.about)(language),
    }
}

/// Returns the tabs of the axes of a project with several.
fn axes(state: &PageState, held: &ReadProject) -> Markup {
    let l = state.language;
    html! {
        @if held.projects.len() > 1 {
            nav.tabs aria-label=(capitalised(terms::axis(l))) {
                @for (place, project) in held.projects.iter().enumerate() {
                    button type="button" id={ "axis-" (place) } data-axis=(project.name)
                        aria-current=[(place == state.axis && !state.all_axes).then_some("page")]
                        hx-post="/work" hx-vals=(vals(&[("axis", &place.to_string()), ("code", ""), ("from", ""), ("until", "")])) { (project.name) }
                }
                button type="button" id="axis-all" aria-current=[state.all_axes.then_some("page")]
                    hx-post="/work" hx-vals=(vals(&[("axis", ALL_AXES), ("code", "")])) { (page::all_axes(l)) }
                (new_axis(held, l))
            }
        } @else { (new_axis(held, l)) }
    }
}

/// Returns the button that adds an axis to the file.
fn new_axis(held: &ReadProject, language: Language) -> Markup {
    let l = language;
    html! {
        button.small type="button" id="new-axis" disabled[!held.has_places] title=(page::new_axis_about(l))
            hx-get={ "/axis?lang=" (l.id()) } hx-target="#detail" hx-swap="innerHTML" hx-include="unset" { "+ " (page::new_axis(l)) }
    }
}
