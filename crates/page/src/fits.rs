//! The right column: what fits, best first, and what keeps the others out.

use crate::form::vals;
use crate::state::{Filter, MARKED_MOST, State};
use figures::{By, Size, Style, candidate_map};
use maud::{Markup, PreEscaped, html};
use quantities::unit::{KILOGRAM, MILLIMETRE, NEWTON_METRE};
use quantities::{Language, Measure, format_number};
use questions::texts::{percent, reason, shown};
use questions::{Candidate, CandidateId, Sizing};
use words::{capitalised, check_title, page, ranking_rule, terminal, terms};

/// So many of what fits stand before a fold.
const BEST_SHOWN: usize = 12;

/// Number of rejected actuators listed by name; the others are counted.
const REJECTED_SHOWN: usize = 40;

/// The column.
pub(crate) fn column(
    state: &State,
    sizing: Option<&Sizing<'_>>,
    looked_at: Option<&CandidateId>,
    is_old: bool,
) -> Markup {
    let l = state.language;
    html! {
        section id="fits" class=[is_old.then_some("old")] aria-labelledby="fits-title" {
            h2 id="fits-title" { (page::what_fits(l)) }
            @if let Some(sizing) = sizing {
                (answer(sizing, l))
                (filters(state, sizing))
                (ranking(state, sizing, looked_at))
                (rejected(state, sizing, looked_at))
                (map(state, sizing, looked_at))
            } @else {
                p { (page::no_result_yet(l)) }
            }
        }
    }
}

fn answer(sizing: &Sizing<'_>, language: Language) -> Markup {
    let fitting = sizing.candidates.iter().filter(|each| each.fits()).count();
    let judged = terminal::judged(fitting, &sizing.candidates.len(), language);
    html! {
        p id="answer" role="status" aria-live="polite" {
            @match sizing.answer() {
                Some(best) => { strong.pass { (best.id) } }
                None => { strong.fail { (capitalised(terminal::no_actuator_fits(language))) } }
            }
            br; (judged)
        }
    }
}

fn filters(state: &State, sizing: &Sizing<'_>) -> Markup {
    let l = state.language;
    let mut sizes: Vec<String> = Vec::new();
    let mut feedbacks: Vec<String> = Vec::new();
    for each in &sizing.candidates {
        let CandidateId::Code(code) = &each.id else { continue };
        let (size, feedback) = (code.size.to_string(), code.feedback.to_string());
        if !sizes.contains(&size) {
            sizes.push(size);
        }
        if !feedbacks.contains(&feedback) {
            feedbacks.push(feedback);
        }
    }
    sizes.sort();
    feedbacks.sort();
    let choice = |name: &str, label: &str, chosen: &str, all: &[(String, String)]| {
        html! {
            label { (label) " "
                select id=(name) name=(name) form="state" data-chosen=(chosen) hx-post="/work" hx-trigger="change" {
                    option value="" selected[chosen.is_empty()] { (page::any(l)) }
                    @for (value, text) in all { option value=(value) selected[chosen == value] { (text) } }
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
    let same =
        |all: &[String]| -> Vec<(String, String)> { all.iter().map(|each| (each.clone(), each.clone())).collect() };
    let brakes = [
        ("with".to_owned(), page::with_brake(l).to_owned()),
        ("without".to_owned(), page::without_brake(l).to_owned()),
    ];
    html! {
        details id="filters" open[state.filter.is_set()] {
            summary { (page::filter(l)) }
            div.filters {
                (choice("f_size", page::size(l), &state.filter.size, &same(&sizes)))
                (choice("f_feedback", page::feedback(l), &state.filter.feedback, &same(&feedbacks)))
                (choice("f_brake", page::brake(l), &state.filter.brake, &brakes))
                (number("f_bore", page::least_bore(l), &state.filter.bore_mm))
                (number("f_length", page::greatest_length(l), &state.filter.length_mm))
                (number("f_mass", page::greatest_mass(l), &state.filter.mass_kg))
                (number("f_voltage", page::least_dc_link(l), &state.filter.voltage_v))
            }
        }
    }
}

impl Filter {
    fn is_set(&self) -> bool {
        let Self { size, feedback, brake, bore_mm, length_mm, mass_kg, voltage_v } = self;
        [size, feedback, brake, bore_mm, length_mm, mass_kg, voltage_v].iter().any(|typed| !typed.is_empty())
    }

    /// Whether a candidate passes the filters; an unknown datum passes.
    fn holds(&self, candidate: &Candidate<'_>) -> bool {
        let CandidateId::Code(code) = &candidate.id else { return true };
        let named = |typed: &str, of: String| typed.is_empty() || typed == of;
        let bound = |typed: &str| typed.trim().replace(',', ".").parse::<f64>().ok();
        let of = |value: Option<f64>, typed: &str, holds: fn(f64, f64) -> bool| match (value, bound(typed)) {
            (Some(value), Some(bound)) => holds(value, bound),
            _ => true,
        };
        let known = &candidate.parameters;
        let bore = known.hollow_shaft.known().map(|found| MILLIMETRE.from_si(found.value.si()));
        let length = known.length.known().map(|found| MILLIMETRE.from_si(found.value.si()));
        let mass = known.mass.known().map(|found| KILOGRAM.from_si(found.value.si()));
        let voltage = known.dc_link_max.known().map(|found| found.value.si());
        named(&self.size, code.size.to_string())
            && named(&self.feedback, code.feedback.to_string())
            && (self.brake.is_empty() || (self.brake == "with") == (code.brake == order_code::Brake::With))
            && of(bore, &self.bore_mm, |value, least| value >= least)
            && of(length, &self.length_mm, |value, most| value <= most)
            && of(mass, &self.mass_kg, |value, most| value <= most)
            && of(voltage, &self.voltage_v, |value, least| value >= least)
    }
}

fn ranking(state: &State, sizing: &Sizing<'_>, looked_at: Option<&CandidateId>) -> Markup {
    let l = state.language;
    let fitting: Vec<&Candidate<'_>> = sizing.candidates.iter().filter(|each| each.fits()).collect();
    let shown_ones: Vec<(usize, &&Candidate<'_>)> =
        fitting.iter().enumerate().filter(|(_, each)| state.filter.holds(each)).collect();
    let (first, rest) = shown_ones.split_at(shown_ones.len().min(BEST_SHOWN));
    html! {
        @if let Some(own) = &sizing.own {
            h3 { (capitalised(terms::own_actuator(l))) }
            p class=(if own.fits() { "pass" } else { "fail" }) { (own.id) ": " @if own.fits() { (terms::fits(l)) } @else { (terms::does_not_fit(l)) ", " (reason(own, l)) } }
        }
        h3 id="ranking-title" { (page::ranking(l)) }
        p.small { (ranking_rule(l)) " " (page::shown_of(&shown_ones.len(), &fitting.len(), l)) }
        @if state.marked.len() >= 2 {
            button type="button" hx-post="/compare" hx-target="#detail" hx-swap="innerHTML" { (page::side_by_side(l)) }
        } @else { p.small { (page::compare_told(l)) } }
        ol.ranking aria-labelledby="ranking-title" {
            @for (place, candidate) in first { (ranked(state, place + 1, candidate, looked_at)) }
        }
        @if !rest.is_empty() {
            details id="ranking-rest" {
                summary { (page::more_fitting(rest.len(), l)) }
                ol.ranking aria-labelledby="ranking-title" {
                    @for (place, candidate) in rest { (ranked(state, place + 1, candidate, looked_at)) }
                }
            }
        }
    }
}

fn ranked(state: &State, rank: usize, candidate: &Candidate<'_>, looked_at: Option<&CandidateId>) -> Markup {
    let l = state.language;
    let name = candidate.id.to_string();
    let share = candidate.standing.utilisation;
    let mass = candidate.parameters.mass.known().map(|mass| format_number(KILOGRAM.from_si(mass.value.si()), 1, l));
    let torque = candidate.judgement.demand.map(|demand| shown(demand.torque_rms.si(), &NEWTON_METRE, l));
    let tightest = candidate.judgement.tightest().map(|check| check_title(check.id, l)).unwrap_or_default();
    let advice = candidate.judgement.checks.iter().filter(|check| check.verdict == questions::Verdict::Advice).count();
    let open = candidate.open_questions();
    let is_marked = |code: &order_code::OrderCode| state.marked.contains(code);
    html! {
        li id={ "r-" (name) } aria-current=[(looked_at == Some(&candidate.id)).then_some("true")] {
            span.rank { (rank) "." }
            @if let CandidateId::Code(code) = &candidate.id {
                input type="checkbox" name="mark" form="state" value=(name) id={ "m-" (name) } aria-label=(page::mark(&name, l))
                    checked[is_marked(code)] data-checked=(is_marked(code)) disabled[!is_marked(code) && state.marked.len() >= MARKED_MOST]
                    hx-post="/work" hx-trigger="change";
            }
            button.plain type="button" title=(page::look_at(&name, l)) hx-post="/work" hx-vals=(vals(&[("code", &name)])) { (name) }
            span.with-bar {
                svg.bar viewBox="0 0 150 8" preserveAspectRatio="none" aria-hidden="true" { rect x="0" y="0" width=((share * 100.0).clamp(0.0, 150.0)) height="8" {} path d="M100 0V8" {} }
                (percent(Some(share), l)) " %"
            }
            span.more-of {
                span { (tightest) }
                @if let Some(torque) = torque { span { "T" sub { "rms" } " " (torque) " Nm" } }
                @if let Some(mass) = mass { span { (mass) " kg" } }
                @if !candidate.on_request.is_empty() { span { (terms::on_request(l)) } }
                @if advice > 0 { span.advice { (terms::advice(l)) ": " (advice) } }
                @if open > 0 { span.unchecked { (terms::not_checked(l)) ": " (open) } }
            }
        }
    }
}

/// The rejected actuators by rising excess, each with the failed check; their details list changes that would admit them.
fn rejected(state: &State, sizing: &Sizing<'_>, looked_at: Option<&CandidateId>) -> Markup {
    let l = state.language;
    let all: Vec<&Candidate<'_>> = sizing.candidates.iter().filter(|each| !each.fits()).collect();
    if all.is_empty() {
        return html! {};
    }
    let found: Vec<&&Candidate<'_>> = all.iter().filter(|each| state.filter.holds(each)).collect();
    html! {
        details id="rejected" open[all.len() == sizing.candidates.len()] {
            summary { (terminal::rejected_count(&all.len(), l)) }
            p.small { (page::shown_of(&found.len().min(REJECTED_SHOWN), &all.len(), l)) }
            ul.rejected {
                @for candidate in found.iter().take(REJECTED_SHOWN) {
                    @let name = candidate.id.to_string();
                    li id={ "r-" (name) } aria-current=[(looked_at == Some(&candidate.id)).then_some("true")] {
                        button.plain type="button" title=(page::what_would_let_it_in(l)) hx-post="/work" hx-vals=(vals(&[("code", &name)])) { (name) }
                        span.fail { (reason(candidate, l)) }
                    }
                }
            }
        }
    }
}

fn map(state: &State, sizing: &Sizing<'_>, looked_at: Option<&CandidateId>) -> Markup {
    let drawing = candidate_map(sizing, By::Mass, looked_at, state.language);
    let (width, height) = drawing.size_mm;
    let size = Size::pixels(460.0, 460.0 * height / width);
    let style = Style::new(size).theme(state.theme).language(state.language).id("map");
    html! {
        figure.plot id="plot-map" { div.frame { (PreEscaped(drawing.render(&style).into_svg())) } figcaption { (drawing.caption) " " (page::map_told(state.language)) } }
    }
}
