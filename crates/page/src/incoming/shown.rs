//! Layout of the preview of a recording.

use super::choices::{Choices, NO_ROLE, OTHER_WINDOW, TorqueUse, role_id};
use super::examination::{Examination, Request, SegmentPlace};
use crate::markup::{drawer, label_of};
use crate::recorded::rows;
use crate::sentences::{states_a_table, worded};
use figures::{Size, Style};
use maud::{Markup, PreEscaped, html};
use motion_words::{acceleration, alone, quality_rows};
use project::written;
use quantities::unit::NEWTON_METRE;
use quantities::{Language, Measure, Unit, format_significant};
use questions::{ColumnRole, Preview, recording_roles, window_text};
use words::{capitalised, incoming, page, role_text, terms};

mod motion_words;

/// Size of the curve \[px\].
const WIDTH: f64 = 660.0;

/// Largest number of values of the load that are listed.
const LISTED_MOST: usize = 12;

/// Returns the whole preview.
pub(super) fn preview(request: &Request, found: &Examination) -> Markup {
    let Request { state, choices, file } = request;
    let l = state.language;
    let is_whole = choices.torque == Some(TorqueUse::Whole);
    let waits = !choices.is_answered();
    let is_usable = found.examined.is_some() && !found.has_faulty_text && !waits;
    let inside = html! {
        form id="incoming" class="rows" method="post" action="/recording" autocomplete="off" {
            @if found.has_faulty_text { p.fault role="alert" { (incoming::text_is_faulty(l)) } }
            @if !found.unreadable.is_empty() || choices.preview.is_none() && found.examined.is_none() {
                div.fault role="alert" id="incoming-faults" {
                    p { strong { (incoming::unusable(l)) } }
                    @if found.unreadable.is_empty() { p { (incoming::no_table(&file.name(), l)) } }
                    ul { @for (message, hint) in &found.unreadable {
                        @let hint = hint.as_deref().map(|hint| if states_a_table(hint) { incoming::choose_below(l) } else { hint });
                        li { (worded(message, hint, l)) }
                    } }
                }
            }
            @if let Some(examined) = &found.examined {
                @let drawing = figures::recording(file.name(), examined, l);
                @let height = WIDTH * drawing.size_mm.1 / drawing.size_mm.0;
                @let style = Style::new(Size::pixels(WIDTH, height)).theme(state.theme).language(l).id("incoming-curve");
                figure.plot id="incoming-figure" tabindex="0" role="region" aria-label=(incoming::title(&file.name(), l)) { (PreEscaped(drawing.render(&style).into_svg())) }
            }
            @if let Some(preview) = &choices.preview { (columns(preview, choices, found, l)) }
            @if choices.has_torque() { (torque(request, l)) }
            @if let Some(line) = &choices.line { (line.fields(is_whole, l)) }
            @if let Some(examined) = &found.examined {
                h3 { (incoming::found(l)) }
                dl.facts id="incoming-found" { @for (name, value) in quality_rows(examined, l) { dt { (name) } dd { (value) } } }
                @for outliers in &examined.outliers { p.advice { (motion_words::outliers(outliers, l)) } }
                @if let Some((along, time_s, change)) = examined.jump { p.advice { (motion_words::jump(along, time_s, change, l)) } }
                (treatment(choices, found, l))
            }
            @if SegmentPlace::of(state).segments > 0 { (place(choices, l)) }
            @if found.examined.is_some() && !is_whole && !has_load(request) && !found.is_along_a_line() {
                div.row {
                    label for="incoming-inertia" { (label_of("load.inertia", l).unwrap_or_default()) }
                    span.quantity { input id="incoming-inertia" name="inertia" type="text" value=(crate::value::with_mark(&choices.inertia, l)) placeholder=(page::for_example(&crate::value::said("1.3 kg m^2", l), l)) aria-describedby="incoming-inertia-a"; }
                    p.small id="incoming-inertia-a" { (incoming::load_later(l)) }
                }
            }
            label.check { input type="checkbox" name="once" value="true" checked[choices.runs_once]; " " (incoming::runs_once(l)) }
            @if !found.open.is_empty() {
                div.advice id="incoming-open" {
                    p { strong { (incoming::still_open(l)) } }
                    ul { @for (fault, text) in found.open.iter().zip(words::worded(&found.open, l)) {
                        @let text = crate::markup::in_words(text, fault, l);
                        li { (worded(&text.message, text.hint.as_deref(), l)) }
                    } }
                }
            }
            div.downloads {
                button.primary type="submit" id="incoming-use" disabled[!is_usable] aria-describedby="incoming-why" { (incoming::use_it(l)) }
                button type="button" data-close="detail" { (page::close(l)) }
                span.small id="incoming-why" { @if waits { (choices.waits_for(l)) } @else { (incoming::not_written_yet(l)) } }
            }
        }
    };
    drawer(&incoming::title(&file.name(), l), &inside, l)
}

/// Returns `true` if the axis has a load.
fn has_load(request: &Request) -> bool {
    !load_of(request).is_empty()
}

/// Returns the stated values of the load of the axis: label and value.
fn load_of(request: &Request) -> Vec<String> {
    let l = request.state.language;
    let SegmentPlace { prefix, .. } = SegmentPlace::of(&request.state);
    let is_of_load = |path: &str| {
        path.strip_prefix(&prefix).is_some_and(|inside| inside.starts_with("load.") || inside.starts_with("mechanism."))
    };
    let keys = written(&request.state.text).unwrap_or_default();
    let stated = keys.iter().filter(|key| is_of_load(&key.path));
    let said = stated.filter_map(|key| {
        let value = crate::value::said(key.value.as_deref()?, l);
        Some(format!("{} {value}", label_of(&key.path, l)?))
    });
    said.collect()
}

fn listed(mut all: Vec<String>) -> String {
    let more = all.len().saturating_sub(LISTED_MOST);
    all.truncate(LISTED_MOST);
    if more > 0 {
        all.push("…".to_owned());
    }
    all.join("; ")
}

/// Returns the columns of the file, each with its use.
fn columns(preview: &Preview, choices: &Choices, found: &Examination, language: Language) -> Markup {
    let l = language;
    let more = preview.count.saturating_sub(preview.columns.len());
    html! {
        h3 id="incoming-columns-title" { (incoming::columns(l)) }
        div.wide tabindex="0" role="region" aria-labelledby="incoming-columns-title" { table id="incoming-columns" {
            thead { tr { @for head in [incoming::heading(l), incoming::used_as(l), &capitalised(terms::unit(l)), incoming::ratio(l)] { th scope="col" { (head) } } } }
            tbody { @for (index, (column, choice)) in preview.columns.iter().zip(&choices.columns).enumerate() {
                @let heading = if column.heading.is_empty() { &column.name } else { &column.heading };
                tr {
                    th scope="row" { (heading) }
                    td { select id={ "incoming-role-" (index) } name={ "role_" (index) } aria-label=(incoming::used_as_of(heading, l)) data-chosen=(choice.role.map_or(NO_ROLE, role_id)) {
                        option value=(NO_ROLE) selected[choice.role.is_none()] { (incoming::not_used(l)) }
                        @for role in ColumnRole::ALL { option value=(role_id(role)) selected[choice.role == Some(role)] { (capitalised(&role_text(role, l))) } }
                    } }
                    td { @if let Some(role) = choice.role { (unit(index, role, (column.unit.as_deref(), &choice.unit), heading, found, l)) } }
                    td { @if matches!(choice.role, Some(ColumnRole::Position | ColumnRole::Speed | ColumnRole::Torque)) {
                        input.short id={ "incoming-ratio-" (index) } name={ "ratio_" (index) } type="text" inputmode="decimal" size="5" value=(crate::value::with_mark(&choice.ratio, l)) aria-label=(incoming::ratio_of(heading, l));
                    } }
                }
            } }
        } }
        @if more > 0 { p.small { (incoming::more_columns(more, l)) } }
        p.small { (incoming::ratio_about(l)) }
        @if !preview.rows.is_empty() { details id="incoming-rows" { summary { (incoming::beginning(l)) } (rows(preview, l)) } }
    }
}

/// Returns the choice of the unit of a column.
fn unit(
    index: usize,
    role: ColumnRole,
    (in_file, chosen): (Option<&str>, &str),
    heading: &str,
    found: &Examination,
    language: Language,
) -> Markup {
    let l = language;
    let units =
        recording_roles().into_iter().find(|(_, of, _)| *of == role).map(|(.., units)| units).unwrap_or_default();
    let read = found.examined.as_ref().and_then(|examined| {
        let column = examined.recording.columns.iter().find(|column| column.role == role)?;
        chosen.is_empty().then_some(column.unit.symbol)
    });
    let stated = read.or(in_file);
    let name = stated.map_or_else(|| page::not_stated(l).to_owned(), |unit| incoming::unit_stated(&unit, l));
    let missing = stated.is_none() && chosen.is_empty();
    html! {
        select id={ "incoming-unit-" (index) } name={ "unit_" (index) } aria-label=(incoming::unit_of_column(&heading, l)) data-chosen=(chosen) aria-invalid=[missing.then_some("true")] {
            option value="" selected[chosen.is_empty()] { (name) }
            @for unit in units { option value=(unit) selected[unit == chosen] { (Unit::of(unit).map_or(unit, |unit| unit.symbol)) } }
        }
    }
}

/// Returns the offers against artefacts of the file, with their effect.
fn treatment(choices: &Choices, found: &Examination, language: Language) -> Markup {
    let l = language;
    let Some(examined) = &found.examined else { return html! {} };
    let stated = choices.smoothing.clone().unwrap_or_default();
    let torque = |si: f64| format!("{} {}", format_significant(NEWTON_METRE.from_si(si), 4, l), NEWTON_METRE.symbol);
    let is_listed =
        |window: &str| found.effects.iter().any(|effect| effect.window.is_some_and(|of| window_text(of) == window));
    let is_other = choices.is_other_window || !stated.is_empty() && !is_listed(&stated);
    html! {
        @if let Some(sentence) = alone(examined, choices.torque == Some(TorqueUse::Whole), l) { p.advice id="incoming-artefact" { (sentence) } }
        @match examined.made_up().map(|made_up| made_up.cause) {
            Some(questions::Spurious::Held { .. }) => label.check { input type="checkbox" name="held" value="true" checked[choices.interpolates]; " " (incoming::interpolate(l)) },
            Some(questions::Spurious::Stamps { .. }) => label.check { input type="checkbox" name="even" value="true" checked[choices.is_evenly_spaced]; " " (incoming::even_rows(l)) },
            _ => {},
        }
        fieldset id="incoming-smoothing" {
            legend { (incoming::smoothing(l)) }
            @let has_torque = found.effects.iter().any(|effect| effect.torque_peak.is_some());
            @if has_torque { p.small { (incoming::smoothing_about(l)) } } @else { p.small { (incoming::acceleration_about(l)) " " (incoming::peak_later(l)) } }
            ul.plain {
                @if found.effects.is_empty() { li { (window(("", !is_other && stated.is_empty()), incoming::no_smoothing(l))) } }
                @for effect in &found.effects {
                    @let text = effect.window.map(window_text).unwrap_or_default();
                    @let name = if text.is_empty() { incoming::no_smoothing(l).to_owned() } else { crate::value::with_mark(&text, l) };
                    li {
                        (window((&text, !is_other && text == stated), &name)) ": "
                        @match (effect.torque_peak, effect.acceleration_peak) {
                            (Some(peak), _) => strong { "T" sub { "peak" } " = " (torque(peak.si())) },
                            (None, Some(peak)) => strong { (if examined.is_along_a_line() { "a" } else { "α" }) sub { "peak" } " = " (acceleration(examined, peak, l)) },
                            (None, None) => span.small { (incoming::not_with_this(l)) },
                        }
                        @if effect.is_proposed { " " span.small { "– " (incoming::removes_steps(l)) } }
                    }
                }
                li {
                    (window((OTHER_WINDOW, is_other), incoming::other_window(l))) " "
                    input.short id="incoming-window" name="window" type="text" size="8" value=(if is_other && !choices.is_other_window { crate::value::with_mark(&stated, l) } else { choices.other_window.clone() }) aria-label=(incoming::other_window(l)) placeholder="10 ms";
                }
            }
        }
    }
}

fn window((value, is_chosen): (&str, bool), name: &str) -> Markup {
    let id = format!("incoming-window-{}", value.replace([' ', '.'], "-"));
    html! { label for=(id) { input type="radio" name="smoothing" id=(id) value=(value) checked[is_chosen]; " " (name) } }
}

/// Returns the question about the torque, and the consequence of its answer.
fn torque(request: &Request, language: Language) -> Markup {
    let l = language;
    let chosen = request.choices.torque;
    let all = [
        (TorqueUse::Whole, incoming::torque_whole(l), incoming::torque_whole_about(l)),
        (TorqueUse::Process, incoming::torque_process(l), incoming::torque_process_about(l)),
        (TorqueUse::Unused, incoming::torque_unused(l), incoming::torque_unused_about(l)),
    ];
    let load = load_of(request);
    html! {
        fieldset id="incoming-torque" {
            legend { (incoming::torque_question(l)) }
            ul.plain { @for (each, title, about) in all { li {
                @let id = format!("incoming-torque-{}", each.id());
                label for=(id) { input type="radio" name="torque" id=(id) value=(each.id()) checked[chosen == Some(each)] required; " " strong { (title) } ": " (about) }
            } } }
            p.advice id="incoming-consequence" aria-live="polite" { @match chosen {
                Some(TorqueUse::Process) if load.is_empty() => (incoming::is_added_to_nothing(l)),
                Some(TorqueUse::Process) => (incoming::is_added(&listed(load), l)),
                Some(TorqueUse::Whole) if !load.is_empty() => (incoming::is_removed(&listed(load), l)),
                Some(TorqueUse::Whole | TorqueUse::Unused) | None => {},
            } }
        }
    }
}

/// Returns the choice between a new motion and a further segment.
fn place(choices: &Choices, language: Language) -> Markup {
    let l = language;
    html! {
        fieldset id="incoming-place" {
            legend { (incoming::place(l)) }
            @for (value, title, is_chosen) in [("replaced", incoming::replaces(l), !choices.is_added), ("added", incoming::is_added_behind(l), choices.is_added)] {
                label.check for={ "incoming-" (value) } { input type="radio" name="place" id={ "incoming-" (value) } value=(value) checked[is_chosen]; " " (title) }
            }
        }
    }
}

impl Examination {
    fn is_along_a_line(&self) -> bool {
        self.examined.as_ref().is_some_and(questions::ExaminedRecording::is_along_a_line)
    }
}
