//! The middle pane: the demand of the axis on the selected actuator, one view at a time.

use crate::call::Shell;
use crate::chapters::with_symbols;
use crate::markup::vals;
use crate::parts::part;
use crate::state::{PageState, ReadProject, View};
use crate::{overlay, tolerances};
use axis::AxisProject;
use figures::{CyclePanels, Drawing, NoFigure, Size, Style};
use maud::{Markup, PreEscaped, html};
use quantities::unit::WATT;
use quantities::{Language, Measure, format_number};
use questions::list::check::reserve_unasked;
use questions::texts::{change_lines, demand_figures, reserve_condition};
use questions::{Candidate, Progress, power_over_cycle};
use words::{capitalised, page};

/// Returns the pane of a candidate judged with every check.
pub(crate) fn column(
    state: &PageState,
    project: &AxisProject,
    candidate: Option<&Candidate<'_>>,
    is_old: bool,
    shell: &dyn Shell,
    progress: &Progress,
) -> Markup {
    let l = state.language;
    html! {
        section id="demands" class=(if is_old { "pane old" } else { "pane" }) aria-labelledby="demands-title" {
            h2.unseen id="demands-title" { (page::what_it_demands(l)) }
            (views(state, project, candidate))
            @if let Some(candidate) = candidate {
                (sums(candidate, l))
                @if state.is_brief && is_long(project) { div id="reserve" data-same="" {} (later(state, candidate, shell)) }
                @else { (reserve(project, candidate, progress, l)) (view(state, project, candidate, is_old, shell, progress)) }
            } @else { p { (page::no_result_yet(l)) } }
        }
    }
}

/// Returns the pane without a result; of an axis without a load, with the mechanisms to choose from.
pub(crate) fn nothing(state: &PageState, held: &ReadProject) -> Markup {
    let l = state.language;
    let of_axis = [format!("{}mechanism", state.prefix), "mechanism".to_owned()];
    let missing = of_axis
        .iter()
        .find_map(|path| held.faults.at(path).map(|(_, fault)| fault).find(|fault| fault.id == "no_mechanism"));
    html! {
        section.pane id="demands" aria-labelledby="demands-title" {
            h2 id="demands-title" { (page::what_it_demands(l)) }
            p { (page::no_result_yet(l)) }
            @if let Some(fault) = missing {
                p { (fault.message) }
                (crate::start::choices(&state.prefix, fault.hint.is_some(), l))
            }
        }
    }
}

/// Returns the tabs of the pane.
fn views(state: &PageState, project: &AxisProject, candidate: Option<&Candidate<'_>>) -> Markup {
    let l = state.language;
    let title = |view: View| match view {
        View::Cycle => page::view_cycle(l),
        View::TorqueSpeed => page::view_torque_speed(l),
        View::Heat => page::view_heat(l),
        View::Energy => page::view_energy(l),
        View::Bearing => page::view_bearing(l),
        View::ErrorBudget => page::view_error_budget(l),
        View::Simulation => page::view_simulation(l),
        View::DataSheet => page::tool_data(l),
        View::Wiring => page::tool_wiring(l),
        View::Mounting => page::tool_mount(l),
        View::Commissioning => page::tool_commission(l),
        View::Encoder => page::tool_encoder(l),
        View::Maintenance => page::tool_upkeep(l),
    };
    let has = |view: View| match view {
        View::Bearing => candidate.is_none_or(|candidate| questions::flange_course(project, candidate).is_some()),
        View::Encoder | View::Wiring | View::DataSheet | View::Mounting | View::Commissioning | View::Maintenance => {
            candidate.is_none_or(|candidate| !candidate.product.is_of_project())
        }
        View::Cycle | View::TorqueSpeed | View::Heat | View::Energy | View::ErrorBudget | View::Simulation => true,
    };
    part(html! {
        div.views id="views" role="tablist" aria-label=(page::what_it_demands(l)) {
            @for view in View::ALL {
                button type="button" role="tab" id={ "view-" (view.id()) } aria-selected=(view == state.view) aria-controls="view"
                    tabindex=(if view == state.view { "0" } else { "-1" }) class=[if !has(view) { Some("empty") } else { view.tool().map(|_| "of-code") }]
                    hx-post="/work" hx-vals=(vals(&[("view", view.id())])) { (title(view)) }
            }
        }
    })
}

fn sums(candidate: &Candidate<'_>, language: Language) -> Markup {
    html! {
        section.demand aria-label=(page::sums(language)) {
            @if let Some(demand) = &candidate.judgement.demand {
                dl.sums {
                    @let exact = [demand.torque_rms.si(), demand.torque_peak.si(), demand.speed_mean.si(), demand.speed_peak.si(), demand.duty_factor];
                    @for ((symbol, value, unit), si) in demand_figures(demand, language).into_iter().zip(exact) {
                        div { dt { (crate::tip::of_symbol(symbol, language)) } dd { (explained(candidate, si, &format!("{value} {unit}"), language)) } }
                    }
                }
            }
        }
    }
}

/// Returns the reserve of the actuator if it is found quickly, so that the page responds while the user types.
pub(crate) fn reserve(
    project: &AxisProject,
    candidate: &Candidate<'_>,
    progress: &Progress,
    language: Language,
) -> Markup {
    let reserve = if candidate.fits() {
        reserve_unasked(project, candidate, progress).unwrap_or_default()
    } else {
        Default::default()
    };
    html! {
        div id="reserve" {
            @for (line, (head, parts)) in change_lines(&reserve, candidate, language).into_iter().enumerate() {
                p.reserve {
                    (capitalised(head)) ": " @for (place, part) in parts.iter().enumerate() { @if place > 0 { "; " } (part) }
                    // The condition of the values in few words: the picture below stays in sight.
                    @if let Some(condition) = reserve_condition(&reserve, candidate, language).filter(|_| line == 0) {
                        " (" span title=(condition) { (words::report::reserve_partial(language)) } ")"
                    }
                }
            }
        }
    }
}

/// Returns a value; if a check has it, with a link to its derivation.
fn explained(candidate: &Candidate<'_>, si: f64, figure: &str, language: Language) -> Markup {
    let of = candidate.judgement.checks.iter().find(|check| check.value.is_some_and(|value| value.si == si));
    html! { @match of {
        Some(check) => button.figure type="button" title=(page::how_it_came_about(language)) hx-post="/explain" hx-target="#detail" hx-swap="innerHTML"
            hx-vals=(vals(&[("check", check.id.id())])) { (figure) },
        None => (figure),
    } }
}

/// Number of samples above which the picture of a recording is drawn after the numbers.
const LONG_SAMPLES: usize = 20_000;

fn is_long(project: &AxisProject) -> bool {
    project.axis.samples()[0] > LONG_SAMPLES
}

/// Returns the placeholder of a picture: the old picture stays until the new one, requested at once, has arrived.
fn later(state: &PageState, candidate: &Candidate<'_>, shell: &dyn Shell) -> Markup {
    let about = format!(
        "{}\n{}\n{}\n{}\n{:?}\n{:?}",
        state.good,
        state.axis,
        candidate.id,
        state.view.id(),
        state.window,
        state.room
    );
    let code = code_of(candidate);
    html! {
        div id="view" data-same="" {}
        span hidden id={ "later-" (shell.version(about.as_bytes())) } hx-post="/picture" hx-trigger="load, antrieb:again"
            hx-vals=(vals(&[("code", &code)])) hx-sync="#demands:replace" hx-target="#view" hx-swap="outerMorph" {}
    }
}

/// Returns the code by which a request names the actuator, so that it is not searched again; empty for that of the
/// project.
fn code_of(candidate: &Candidate<'_>) -> String {
    if candidate.product.is_of_project() { String::new() } else { candidate.id.to_string() }
}

/// Returns the content below the tabs.
pub(crate) fn view(
    state: &PageState,
    project: &AxisProject,
    candidate: &Candidate<'_>,
    is_old: bool,
    shell: &dyn Shell,
    progress: &Progress,
) -> Markup {
    let l = state.language;
    let none = html! {};
    let worst = overlay::worst(candidate);
    let marks = overlay::marks(&worst, l);
    let drawn = |name, above: &Markup, over: &Markup| {
        picture(state, name, drawing(state, project, candidate, progress), above, over)
    };
    let is_over_time = matches!(state.view, View::Cycle | View::Heat | View::Energy | View::Bearing);
    html! {
        div id="view" role="tabpanel" aria-labelledby={ "view-" (state.view.id()) } data-code=(code_of(candidate)) {
            @if is_over_time { (overlay::controls(project.axis.motion.duration().si(), overlay::ShownTime::of(state.window), l)) }
            @match state.view {
                View::Cycle => (drawn("cycle", &marks, &if is_old { html! {} } else { overlay::segment_handles(state, project) })),
                View::TorqueSpeed => {
                    div.plane-cursors {
                        (overlay::controls(project.axis.motion.duration().si(), overlay::ShownTime::None, l))
                        (overlay::across("torque-speed", state.view.id(), l))
                    }
                    (drawn("torque-speed", &none, &none))
                }
                View::Heat => (drawn("heat", &marks, &none)),
                View::Energy => { (power(project, candidate, l)) (drawn("energy", &marks, &none)) }
                View::Bearing => (drawn("bearing-load", &marks, &none)),
                View::Simulation if !crate::IS_WHOLE => {}
                View::Simulation => (crate::simulated::view(state, project, candidate, progress)),
                View::ErrorBudget => {
                    (crate::budget::table(candidate, l))
                    (tolerances::place(state, project, candidate, shell))
                    (overlay::across("torsion", state.view.id(), l))
                    (drawn("torsion", &none, &none))
                }
                View::DataSheet | View::Wiring | View::Mounting | View::Commissioning | View::Encoder | View::Maintenance => {
                    @if let Some(tool) = state.view.tool() { (of_actuator(tool, candidate)) }
                }
            }
        }
    }
}

/// Returns the place of a tool about the actuator, which is requested with it and stays while the project changes.
fn of_actuator(tool: &str, candidate: &Candidate<'_>) -> Markup {
    let code = code_of(candidate);
    part(html! {
        div id={ "view-tool-" (tool) } hx-post="/tools" hx-trigger="load" hx-target="this" hx-swap="innerHTML" hx-sync="this"
            hx-vals=(vals(&[("tool", tool), ("about", &code), ("within", "view")])) {}
    })
}

/// Draws the figure of the view.
///
/// # Errors
/// [`NoFigure`] if there is nothing to draw.
pub(crate) fn drawing(
    state: &PageState,
    project: &AxisProject,
    candidate: &Candidate<'_>,
    progress: &Progress,
) -> Result<Drawing, NoFigure> {
    let l = state.language;
    let over_time = |panels| Ok(figures::cycle(project, candidate, panels, state.window, l));
    match state.view {
        View::Cycle => over_time(CyclePanels::Motion),
        View::Heat => over_time(CyclePanels::Heat),
        View::Energy => over_time(CyclePanels::Energy),
        View::TorqueSpeed => Ok(figures::torque_speed(project, candidate, l)),
        View::Bearing => figures::bearing_load(project, candidate, state.window, l),
        View::ErrorBudget => figures::torsion(project, candidate, l),
        View::Simulation if !crate::IS_WHOLE => Err(NoFigure::OfARun),
        View::Simulation => crate::simulated::run(state, project, candidate, progress)
            .map(|run| figures::simulation(&run, state.window, &state.kept_ranges, l))
            .map_err(|_| NoFigure::OfARun),
        View::DataSheet | View::Wiring | View::Mounting | View::Commissioning | View::Encoder | View::Maintenance => {
            Err(NoFigure::OfARun)
        }
    }
}

/// Returns the largest powers of the cycle.
fn power(project: &AxisProject, candidate: &Candidate<'_>, language: Language) -> Markup {
    let number = |watts: f64| format!("{} {}", format_number(watts, 0, language), WATT.symbol);
    html! { @if let Some(power) = power_over_cycle(project, candidate) {
        dl.sums {
            div { dt { (capitalised(page::power_taken(language))) } dd { (number(power.taken_w)) } }
            div { dt { (capitalised(page::power_returned(language))) } dd { (number(power.returned_w)) } }
        }
    } }
}

/// Height of the picture of a run in which each of its courses can be read \[px\].
const RUN_HIGH: f64 = 860.0;

/// Returns a picture that fills the pane, with the content above and over it; or the reason why there is no picture.
pub(crate) fn picture(
    state: &PageState,
    name: &str,
    drawing: Result<Drawing, NoFigure>,
    above: &Markup,
    over: &Markup,
) -> Markup {
    let l = state.language;
    let drawing = match drawing {
        Ok(drawing) => drawing,
        Err(why) => return html! { p.empty { (capitalised(&why.message(None, l))) } },
    };
    let (width, height) = state.room;
    // Seven courses need more than the pane shows at once.
    let high = if name == "simulation" { height.max(RUN_HIGH) } else { height };
    let style = Style::new(Size::pixels(width, high)).theme(state.theme).language(l).id(name);
    part(html! {
        figure.plot id={ "plot-" (name) } data-figure=(drawing.figure.id()) data-width=(width) data-height=(height) {
            (above)
            div.frame { (PreEscaped(drawing.render(&style).into_svg())) (over) }
            figcaption {
                span.caption { (with_symbols(&drawing.caption)) }
                span.plot-tools {
                    button.small type="button" data-full="" aria-pressed="false" title=(page::full_window(l)) aria-label=(page::full_window(l)) { svg.icon viewBox="0 0 14 14" width="14" height="14" aria-hidden="true" { path d="M1 5V1H5M9 1H13V5M13 9V13H9M5 13H1V9" {} } }
                    button.small type="button" data-copy="svg" { (page::copy_svg(l)) }
                    button.small type="button" data-copy="data" { (page::copy_data(l)) }
                }
            }
        }
    })
}
