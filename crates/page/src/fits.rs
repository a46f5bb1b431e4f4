//! The right pane: the ranking with all checks of the selected actuator, the rejected actuators with their reasons, and
//! the map of candidates.

use crate::call::Shell;
use crate::checks;
use crate::markup::{id_of_product, vals};
use crate::parts::part;
use crate::shown::Outcome;
use crate::state::{Filter, List, MARKED_MOST, PageState, ReadProject, Sort};
use crate::{rejected, remedies};
use figures::{By, Size, Style, candidate_map};
use maud::{Markup, PreEscaped, html};
use order_code::{Brake, Feedback};
use quantities::unit::{KILOGRAM, MILLIMETRE};
use quantities::{Language, Measure, format_number};
use questions::texts::{fitting_text, percent, standing_text};
use questions::{Candidate, Fit, ProductId, Sizing};
use std::collections::BTreeSet;
use words::{capitalised, marked, page, ranking_rule, terminal, terms, title_of_check};

/// Number of fitting actuators above the fold.
const BEST_SHOWN: usize = 12;

/// Identifier of the fold with the other fitting actuators; its content is sent when it is opened.
const REST: &str = "ranking-rest";

/// Returns the pane.
pub(crate) fn column(
    state: &PageState,
    held: &ReadProject,
    found: &Outcome<'_, '_>,
    fields: &str,
    shell: &dyn Shell,
) -> Markup {
    let (l, is_old) = (state.language, held.is_old);
    html! {
        section id="fits" class=(if is_old { "pane old" } else { "pane" }) aria-labelledby="fits-title" {
            h2.unseen id="fits-title" { (page::what_fits(l)) }
            @if let Some(sizing) = found.sizing {
                (lists(state, sizing))
                // The other lists have no boxes to mark actuators: the marks stay.
                @if state.list != List::Ranking { (part(html! { @for id in &state.marked { input type="hidden" name="mark" form="state" value=(id); } })) }
                div id="list" role="tabpanel" aria-labelledby={ "list-" (state.list.id()) } { @match state.list {
                    List::Ranking => { @if sizing.answer().is_none() { (remedies::place(&shell.version(format!("{}\n{}", state.good, state.axis).as_bytes()), l)) } (ranking(state, sizing, found.candidate)) },
                    List::Rejected => (rejected::list(state, sizing, found, &shell.version(format!("{}\n{}", state.good, state.axis).as_bytes()))),
                    List::Map => (map(state, sizing, found.candidate.map(|candidate| &candidate.id))),
                } }
            } @else { (crate::next::steps(state, held, fields)) }
        }
    }
}

/// Returns the tabs of the pane.
fn lists(state: &PageState, sizing: &Sizing<'_>) -> Markup {
    let l = state.language;
    let fitting = sizing.fitting().len();
    let title = |list: List| match list {
        List::Ranking => format!("{} ({})", page::what_fits(l), sizing.ranked().count()),
        List::Rejected => format!("{} ({})", page::why_not(l), sizing.candidates.len() - fitting),
        List::Map => page::map(l).to_owned(),
    };
    html! {
        div.views role="tablist" aria-label=(page::what_fits(l)) {
            @for list in List::ALL {
                button type="button" role="tab" id={ "list-" (list.id()) } aria-selected=(list == state.list)
                    aria-controls="list" tabindex=(if list == state.list { "0" } else { "-1" }) hx-post="/work" hx-vals=(vals(&[("list", list.id())])) { (title(list)) }
            }
        }
    }
}

pub(crate) fn filters(state: &PageState, sizing: &Sizing<'_>) -> Markup {
    let l = state.language;
    let (mut sizes, mut feedbacks) = (BTreeSet::new(), BTreeSet::new());
    for each in &sizing.candidates {
        sizes.extend(each.product.frame_size.as_ref().map(|size| size.name.to_string()));
        feedbacks.extend(each.product.feedback.map(|feedback| feedback.to_string()));
    }
    let choice = |name: &str, label: &str, chosen: &str, all: &[(&str, &str)]| {
        html! {
            label { (label) " "
                select id=(name) name=(name) form="state" data-chosen=(chosen) hx-post="/work" hx-trigger="change" {
                    option value="" selected[chosen.is_empty()] { (page::any(l)) }
                    @for (value, text) in all { option value=(value) selected[chosen == *value] { (text) } }
                }
            }
        }
    };
    let number = |name: &str, label: &str, typed: &str| {
        html! {
            label { (label) " " input id=(name) name=(name) form="state" inputmode="decimal" size="5" value=(typed)
                hx-post="/work" hx-trigger="input changed delay:120ms, change"; }
        }
    };
    let brakes = [("with", page::with_brake(l)), ("without", page::without_brake(l))];
    html! {
        details id="filters" open[state.filter.is_set()] {
            summary { (page::filter(l)) }
            div.filters {
                (choice("f_size", page::size(l), &state.filter.size, &by_name(&sizes)))
                (choice("f_feedback", page::feedback(l), &state.filter.feedback, &by_name(&feedbacks)))
                (choice("f_brake", page::brake(l), &state.filter.brake, &brakes))
                (number("f_bore", page::least_bore(l), &state.filter.bore_mm))
                (number("f_length", page::greatest_length(l), &state.filter.length_mm))
                (number("f_mass", page::greatest_mass(l), &state.filter.mass_kg))
                (number("f_voltage", page::least_dc_link(l), &state.filter.voltage_v))
            }
        }
    }
}

/// Returns words with themselves as labels.
fn by_name(words: &BTreeSet<String>) -> Vec<(&str, &str)> {
    words.iter().map(|word| (word.as_str(), word.as_str())).collect()
}

impl Filter {
    fn is_set(&self) -> bool {
        let Self { size, feedback, brake, bore_mm, length_mm, mass_kg, voltage_v } = self;
        [size, feedback, brake, bore_mm, length_mm, mass_kg, voltage_v].iter().any(|typed| !typed.is_empty())
    }

    /// Returns `true` if a candidate passes the filters; an unknown value passes.
    pub(crate) fn holds(&self, candidate: &Candidate<'_>) -> bool {
        let product = candidate.product;
        let named = |typed: &str, of: Option<&str>| typed.is_empty() || of.is_none_or(|of| typed == of);
        let with_brake = product.brake.map(|brake| if brake == Brake::With { "with" } else { "without" });
        let bound = |typed: &str| typed.trim().replace(',', ".").parse::<f64>().ok();
        let of = |value: Option<f64>, typed: &str, holds: fn(f64, f64) -> bool| match (value, bound(typed)) {
            (Some(value), Some(bound)) => holds(value, bound),
            _ => true,
        };
        let [mass, length, bore] = sizes_of(candidate);
        let voltage = candidate.parameters.dc_link_max.known().map(|found| found.value.si());
        named(&self.size, product.frame_size.as_ref().map(|size| &*size.name))
            && named(&self.feedback, product.feedback.map(Feedback::as_str))
            && named(&self.brake, with_brake)
            && of(bore, &self.bore_mm, |value, least| value >= least)
            && of(length, &self.length_mm, |value, most| value <= most)
            && of(mass, &self.mass_kg, |value, most| value <= most)
            && of(voltage, &self.voltage_v, |value, least| value >= least)
    }
}

/// Returns mass \[kg\], length \[mm\] and bore \[mm\].
fn sizes_of(candidate: &Candidate<'_>) -> [Option<f64>; 3] {
    let known = &candidate.parameters;
    [
        known.mass.known().map(|found| found.value.in_unit(&KILOGRAM)),
        known.length.known().map(|found| found.value.in_unit(&MILLIMETRE)),
        known.hollow_shaft.known().map(|found| found.value.in_unit(&MILLIMETRE)),
    ]
}

/// Sorts the ranking by the selected column.
fn sorted<'s, 'p>(state: &PageState, mut found: Vec<(usize, &'s Candidate<'p>)>) -> Vec<(usize, &'s Candidate<'p>)> {
    let by: fn(&Candidate<'_>) -> Option<f64> = match state.sort {
        Sort::Rank => return found,
        Sort::Utilisation => |each| each.utilisation(),
        Sort::Mass => |each| each.parameters.mass.known().map(|mass| mass.value.si()),
        Sort::Length => |each| each.parameters.length.known().map(|length| length.value.si()),
        // The largest bore comes first.
        Sort::Bore => |each| each.parameters.hollow_shaft.known().map(|bore| -bore.value.si()),
    };
    // Unknown values come last.
    found.sort_by(|(_, a), (_, b)| by(a).unwrap_or(f64::INFINITY).total_cmp(&by(b).unwrap_or(f64::INFINITY)));
    found
}

fn ranking(state: &PageState, sizing: &Sizing<'_>, looked_at: Option<&Candidate<'_>>) -> Markup {
    let l = state.language;
    let fitting = sizing.fitting();
    let evaluated = sizing.ranked().count();
    let all = sorted(state, sizing.ranked().filter(|(_, each)| state.filter.holds(each)).collect());
    let open: Vec<&Candidate<'_>> =
        fitting.iter().filter(|each| each.is_not_evaluated() && state.filter.holds(each)).collect();
    let is_in_the_table = |candidate: &Candidate<'_>| candidate.fits() && !candidate.is_not_evaluated();
    // The selected actuator is always above the fold.
    let is_it = |each: &Candidate<'_>| looked_at.is_some_and(|candidate| candidate.id == each.id);
    let (first, rest) = all.split_at(all.len().min(BEST_SHOWN));
    let below: Vec<_> = rest.iter().filter(|(_, each)| is_it(each)).copied().collect();
    let own = sizing.own.as_ref();
    html! {
        @if own.is_some() || !fitting.is_empty() { (part(filters(state, sizing))) }
        @if own.is_some() || !first.is_empty() {
            table.ranking {
                (heads(state))
                @if let Some(own) = own { (part(row(state, None, own, looked_at))) }
                @for (place, candidate) in first.iter().chain(&below) { (part(row(state, Some(*place), candidate, looked_at))) }
            }
        }
        @if looked_at.is_some_and(|candidate| !is_in_the_table(candidate) && own.is_none_or(|own| own.id != candidate.id)) && state.unfolded {
            @if let Some(candidate) = looked_at { h3 { (candidate.id) } (checks::of(candidate, &state.prefix, l)) }
        }
        @if rest.len() > below.len() {
            @let is_open = state.folds.iter().any(|open| open == REST);
            @let title = page::more_fitting(rest.len() - below.len(), l);
            (part(html! { details id=(REST) {
                @if is_open {
                    summary { (title) }
                    p.codes { @for (_, candidate) in rest.iter().filter(|(_, each)| !is_it(each)) { (look_at(&candidate.id.to_string(), l)) " " } }
                } @else { summary hx-post="/work" hx-vals=(vals(&[("fold", REST)])) { (title) } }
            } }))
        }
        @if !open.is_empty() {
            p.small id="not-evaluated" {
                (capitalised(terminal::not_evaluated_listed(l))) ": "
                @for candidate in open.iter().take(BEST_SHOWN) { (look_at(&candidate.id.to_string(), l)) " " }
                @if open.len() > BEST_SHOWN { (terminal::and_more(&(open.len() - BEST_SHOWN), l)) }
            }
        }
        p.small {
            span id="answer" { @if fitting.is_empty() { strong.fail { (capitalised(terminal::no_actuator_fits(l))) } ". " } (capitalised(&fitting_text(sizing, l))) } ". "
            @if !fitting.is_empty() { (page::shown_of(&all.len(), &evaluated, l)) ". " (capitalised(&ranking_rule(sizing.by_mass, l))) "." }
        }
        // Of the rejected ones, only the actuator with the smallest excess says what would let it fit.
        @if fitting.is_empty() && own.is_none() { button type="button" id="go-rejected" hx-post="/work" hx-vals=(vals(&[("list", List::Rejected.id())])) { (page::why_not(l)) } }
        @if state.marked.len() >= 2 {
            button type="button" id="compare" hx-post="/compare" hx-target="#detail" hx-swap="innerHTML" { (page::side_by_side(l)) }
        } @else if own.is_some() || fitting.len() > 1 { p.small { (page::compare_about(l)) } }
    }
}

fn look_at(name: &str, language: Language) -> Markup {
    html! { button.plain type="button" title=(page::look_at(&name, language)) hx-post="/work" hx-vals=(vals(&[("code", name)])) { (name) } }
}

/// Returns the button that shows and hides the checks of an actuator.
pub(crate) fn fold(name: &str, unfolded: bool, language: Language) -> Markup {
    html! {
        button.fold type="button" aria-expanded=(unfolded) aria-label=(page::checks_of(&name, language)) hx-post="/work"
            hx-vals=(vals(&[("code", name), ("unfolded", if unfolded { "false" } else { "true" })])) { @if unfolded { "▾" } @else { "▸" } }
    }
}

fn heads(state: &PageState) -> Markup {
    let l = state.language;
    let head = |sort: Sort, title: &str, unit: &str| {
        let is_it = state.sort == sort;
        html! {
            th class={ "number " (sort.id()) } scope="col" aria-sort=[is_it.then_some(if sort == Sort::Bore { "descending" } else { "ascending" })] {
                button.sort type="button" hx-post="/work" hx-vals=(vals(&[("sort", sort.id())])) title=(page::sort_by(&title, l)) {
                    (title) @if !unit.is_empty() { " " span.unit { (unit) } }
                }
            }
        }
    };
    html! {
        thead { tr {
            (head(Sort::Rank, "#", ""))
            th scope="col" { (capitalised(terms::ordering_code(l))) }
            (head(Sort::Utilisation, capitalised(terms::utilisation_short(l)).trim_end_matches(" %"), "%"))
            (head(Sort::Mass, "m", KILOGRAM.symbol))
            (head(Sort::Length, "L", MILLIMETRE.symbol))
            (head(Sort::Bore, "d", MILLIMETRE.symbol))
            th.number scope="col" title=(capitalised(terms::advice(l))) { "!" }
            th.number scope="col" title=(capitalised(terms::not_checked(l))) { "?" }
        } }
    }
}

fn row(state: &PageState, rank: Option<usize>, candidate: &Candidate<'_>, looked_at: Option<&Candidate<'_>>) -> Markup {
    let l = state.language;
    let name = candidate.id.to_string();
    let share = candidate.utilisation();
    let number = |value: Option<f64>, digits: usize| {
        value.map_or_else(|| "–".to_owned(), |value| format_number(value, digits, l))
    };
    let [mass, length, bore] = sizes_of(candidate);
    let errata = candidate.parameters.mass.known().map_or(&[][..], |mass| mass.errata);
    // The ids alone: the text of an erratum in each row weighs more than the row.
    let doubted = errata.join(", ");
    let tightest = candidate.governing().map(|check| capitalised(&title_of_check(check, l))).unwrap_or_default();
    let advice = candidate.counts().advised;
    let open = candidate.open_questions();
    let is_marked = |id: &ProductId| state.marked.contains(id);
    let it = looked_at.filter(|it| it.id == candidate.id);
    let unfolded = it.is_some() && state.unfolded;
    html! {
        tbody id={ "r-" (id_of_product(&name)) } aria-current=[it.map(|_| "true")] {
            tr {
                td.number.rank { @match rank { Some(rank) => (rank), None => "–" } }
                td.code {
                    (fold(&name, unfolded, l))
                    @if !candidate.product.is_of_project() {
                        input type="checkbox" name="mark" form="state" value=(name) id={ "m-" (id_of_product(&name)) } aria-label=(page::mark(&name, l))
                            checked[is_marked(&candidate.id)] data-checked=(is_marked(&candidate.id)) disabled[!is_marked(&candidate.id) && state.marked.len() >= MARKED_MOST]
                            hx-post="/work" hx-trigger="change";
                    }
                    (look_at(&name, l))
                    @if !candidate.on_request.is_empty() { " " span.small { (terms::on_request(l)) } }
                    @if candidate.fit() == Fit::FitsIfEstimate { " " span.advice.small title=(standing_text(candidate, l)) { (if candidate.depends_on_ratings_alone() { terminal::unless_the_rating_applies(l) } else { terminal::if_the_estimate_holds(l) }) } }
                    @if candidate.leaves_load_unheld() { " " span.fail.small { (page::load_hangs(l)) } }
                }
                td.number title=(tightest) {
                    (percent(share, l))
                    @if let Some(share) = share { (checks::bar(share, candidate.governing().and_then(questions::Check::utilisation_band))) }
                }
                td.number title=[(!doubted.is_empty()).then_some(&doubted)] { (marked(number(mass, 1), errata)) } td.number.length { (number(length, 0)) } td.number.bore { (number(bore, 0)) }
                td.number.advice { @if advice > 0 { (advice) } }
                td.number.unchecked { @if open > 0 { (open) } }
            }
            @if let Some(it) = it.filter(|_| unfolded) { tr.unfolded { td colspan="8" { (checks::of(it, &state.prefix, l)) } } }
        }
    }
}

fn map(state: &PageState, sizing: &Sizing<'_>, looked_at: Option<&ProductId>) -> Markup {
    let drawing = candidate_map(sizing, By::Mass, looked_at, state.language);
    let (width, height) = drawing.size_mm;
    let size = Size::pixels(460.0, 460.0 * height / width);
    let style = Style::new(size).theme(state.theme).language(state.language).id("map");
    html! {
        (crate::overlay::through_candidates(state.language))
        figure.plot id="plot-map" { div.frame { (PreEscaped(drawing.render(&style).into_svg())) } figcaption { (drawing.caption) " " (page::map_about(state.language)) } }
    }
}
